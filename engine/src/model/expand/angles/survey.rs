//! Which variables stand in sin, cos, exp and the like in a family, with which factors: the family is evaluated once with
//! names in place of sines, and their arguments are looked at.

use proc_macro2::Span;

use super::super::occurs::sides;
use super::super::{functions, names};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::formula::phase::{Linear, frequency, special};
use crate::model::scope::{Argument, Scope, Stage};
use crate::model::words::{CIRCULAR, PI};
use crate::syntax::{self, Binding, ClaimKind, StatementKind};
use basis_prover::collections::list::Listed;
use basis_prover::collections::map::SortedMap;

/// The arguments of one variable, or of one number.
#[derive(Default)]
pub(super) struct Uses {
    /// By variable: its factors, those in sin and cos first, then those in exp; whether they are multiples of π.
    pub(super) by_var: Vec<(Var, Use)>,
    /// Numbers in arguments of exp.
    pub(super) numbers: Vec<Rational>,
    /// Halves of numbers in arguments of sin and cos, as multiples of π.
    pub(super) turns: Vec<Rational>,
    /// The values that `at` gives to angles.
    pub(super) places: Vec<(Var, Linear)>,
    /// Shape parameters that stand in functions themselves.
    pub(super) beside: Vec<Var>,
    /// Shape parameters as frequencies of domain variables, with the function, and where.
    pub(super) frequencies: Vec<(Var, Var, String, Span)>,
}

#[derive(Clone, Debug)]
pub(super) struct Use {
    pub(super) kind: Kind,
    pub(super) turns: bool,
    /// The greatest common divisor of the factors.
    pub(super) unit: Rational,
    /// Whether the factors do not go together.
    pub(super) torn: Option<&'static str>,
    /// Whether the variable stands in functions itself, too: its tangent is to be bounded then, as bounds for it need.
    pub(super) beside: bool,
    pub(super) span: Span,
}

impl Uses {
    pub(super) fn add(&mut self, var: Var, new: Use) {
        if let Some((_, known)) = self.by_var.iter_mut().find(|(v, _)| *v == var) {
            if known.kind != new.kind {
                known.torn = Some("sin or cos, and exp, sinh or cosh");
                known.span = new.span;
            } else if known.turns != new.turns {
                known.torn = Some("sin and cos of different angles, with and without `pi`");
                known.span = new.span;
            }
            known.unit = known.unit.gcd(&new.unit);
        } else {
            self.by_var.push((var, new));
        }
    }

    pub(super) fn of(&self, var: Var) -> Option<&Use> {
        self.by_var.iter().find(|(v, _)| *v == var).map(|(_, u)| u)
    }
}

/// All uses in a family. It is expanded with all variables themselves and one more for every sine; errors are those of
/// the expansion proper.
pub(super) fn survey<'a>(
    scope: &Scope<'a>,
    written: &'a syntax::Family,
    names: &[String],
    shapes: usize,
) -> Uses {
    let mut probe = Scope::new(scope.library, scope.unit, scope.source);
    probe.constants.clone_from(&scope.constants);
    probe.order = scope.order;
    probe.names = names.to_vec();
    probe.domain = (shapes..names.len()).map(Var).listed();
    probe.analytic.pi = Some(Var(names.len()));
    probe.names.push(String::from(PI[0]));
    probe.given.clone_from(&scope.given);
    super::given(&mut probe);
    probe.recorded = Some(Vec::new());
    let (mut places, mut beside) = (Vec::new(), Vec::new());
    // The angles are the same on all spans, so that their tangents can be compared.
    for k in 0..scope.span.map_or(1, |(_, count)| count) {
        probe.span = scope.span.map(|(_, count)| (k, count));
        probe.functions = SortedMap::new();
        probe.planned_functions = SortedMap::new();
        probe.defined = SortedMap::new();
        probe.lets = SortedMap::new();
        probe_claims(&mut probe, written, &mut places);
        for var in (0..shapes).map(Var) {
            if probe.functions.values().flatten().any(|f| f.depends_on(var)) {
                beside.push(var);
            }
        }
    }
    let mut uses = Uses { beside, ..Uses::default() };
    for Argument { name, value, span } in probe.recorded.unwrap_or_default() {
        let Some(linear) = Linear::of(&value, probe.analytic.pi) else {
            let pair = frequency(&value, |v| v.0 < shapes, |v| (shapes..names.len()).contains(&v.0));
            if let Some((parameter, t)) = pair {
                uses.frequencies.push((parameter, t, name, span));
            }
            continue;
        };
        // Not of a sine of a sine.
        if linear.parts.iter().any(|(var, ..)| var.0 >= names.len()) {
            continue;
        }
        let circular = CIRCULAR.contains(&name.as_str());
        let kind = if circular { Kind::Circular } else { Kind::Hyperbolic };
        for (var, factor, turns) in &linear.parts {
            uses.add(*var, Use { kind, turns: *turns, unit: factor.abs(), torn: None, beside: false, span });
        }
        if !circular && !linear.number.is_zero() {
            uses.numbers.push(linear.number.abs());
        }
        if circular && !linear.pi.is_zero() && special(&name, &linear).is_none() {
            uses.turns.push(&linear.pi * &Rational::new(1, 2));
        }
    }
    for (var, value) in places {
        let Some(of) = uses.of(var).cloned() else { continue };
        if let Some(linear) = Linear::of(&value, probe.analytic.pi).filter(|value| value.parts.is_empty()) {
            uses.places.push((var, linear));
        }
        if let Some(number) = value.as_constant() {
            if of.kind == Kind::Hyperbolic && !number.is_zero() {
                uses.numbers.push(&number.abs() * &of.unit);
            }
        } else if let Some(linear) = Linear::of(&value, probe.analytic.pi) {
            // In the middle of the domain, at t = α/2, the angle of α is half of that of t.
            for (shape, factor, _) in linear.parts.iter().filter(|(shape, ..)| shape.0 < shapes) {
                uses.add(*shape, Use { unit: &of.unit * &factor.abs(), ..of.clone() });
            }
        }
    }
    uses
}

/// Evaluates the functions and the claims of a family; the values that `at` gives to variables.
pub(super) fn probe_claims<'a>(
    probe: &mut Scope<'a>,
    written: &'a syntax::Family,
    places: &mut Vec<(Var, Fraction)>,
) {
    probe.stage = Stage::Defining;
    names::plan(probe, written);
    functions::define(probe, written);
    probe.stage = Stage::Complete;
    for statement in &written.statements {
        let StatementKind::Claim(claim) = &statement.kind else { continue };
        match &claim.kind {
            ClaimKind::Relation(relation) if probe.given.is_empty() => probe_relation(probe, relation),
            ClaimKind::At(bindings, relations) if is_about_given(probe, bindings) => {
                for Binding { name, value, .. } in bindings {
                    let var = probe.variable(&name.text);
                    places.extend(var.zip(probe.scalar(value)));
                }
                for relation in relations {
                    probe_relation(probe, relation);
                }
            }
            _ => {}
        }
    }
}

/// Whether a block gives all shape parameters their values that have one.
fn is_about_given(probe: &mut Scope<'_>, bindings: &[Binding]) -> bool {
    let given = probe.given.clone();
    given.iter().all(|(name, turns)| {
        let own = bindings.iter().find(|b| b.name.text == *name && b.indices.is_empty());
        let value = own.and_then(|b| names::attempt(probe, &mut |probe| probe.scalar(&b.value)));
        value.and_then(|value| Linear::of(&value, probe.analytic.pi)).is_some_and(|value| value.pi == *turns)
    })
}

/// Evaluates the sides of a claim for all values of its index variables.
pub(super) fn probe_relation(probe: &mut Scope<'_>, relation: &syntax::Relation) {
    probe.each(&relation.loops, &mut |probe| {
        sides(relation, &mut |side| {
            probe.value(side);
        });
        probe.waits_for = None;
        true
    });
}
