//! Which variables stand in sin, cos, exp and the like in a family, with which factors: the family is evaluated once with
//! names in place of sines, and their arguments are looked at.

use proc_macro2::Span;

use super::super::occurs::sides;
use super::super::{functions, names};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::angle::{Anew, Kind};
use crate::model::budget::SPLIT;
use crate::model::formula::phase::{Linear, frequency, special};
use crate::model::scope::{Argument, Recorded, Scope, Stage};
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
    /// Shape parameters as frequencies of domain variables, with the function, where, and whether π is a factor.
    pub(super) frequencies: Vec<(Var, Var, String, Span, bool)>,
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
///
/// Where a claim needs smaller parts of an angle than the functions, or numbers that they do not contain, the family is expanded
/// anew for it: the statements that stand apart come second.
pub(super) fn survey<'a>(
    scope: &Scope<'a>,
    written: &'a syntax::Family,
    names: &[String],
    shapes: usize,
) -> (Uses, Vec<Vec<usize>>) {
    let mut probe = Scope::new(scope.library, scope.unit, scope.source);
    probe.constants.clone_from(&scope.constants);
    probe.order = scope.order;
    probe.names = names.to_vec();
    probe.domain = (shapes..names.len()).map(Var).listed();
    probe.analytic.pi = Some(Var(names.len()));
    probe.names.push(String::from(PI[0]));
    probe.anew.clone_from(&scope.anew);
    super::given(&mut probe);
    probe.recorded = Some(Recorded::default());
    let mut seen = Seen::default();
    // The angles are the same on all spans, so that their tangents can be compared.
    for k in 0..scope.span.map_or(1, |(_, count)| count) {
        probe.span = scope.span.map(|(_, count)| (k, count));
        probe.functions = SortedMap::new();
        probe.planned_functions = SortedMap::new();
        probe.defined = SortedMap::new();
        probe.lets = SortedMap::new();
        probe_claims(&mut probe, written, &mut seen);
        for var in (0..shapes).map(Var) {
            if probe.functions.values().flatten().any(|f| f.depends_on(var)) {
                seen.beside.push(var);
            }
        }
    }
    let variables = Variables { names, shapes, pi: probe.analytic.pi };
    let all = (0..seen.claims.len()).listed();
    if scope.anew != Anew::default() {
        return (seen.uses(&all, &variables), Vec::new());
    }
    // The uses in several claims, which are counted: there may be any number of claims.
    let count = |parts: usize| scope.within(scope.budget.step(parts as u64), written.name.span, SPLIT);
    let uses = |claims: &[usize]| {
        let uses = seen.uses(claims, &variables);
        count(1 + claims.iter().map(|k| seen.claims[*k].1.len()).sum::<usize>()).map(|()| uses)
    };
    // Of a variable that is an angle in claims alone those are together that come first. A claim with the same arguments as
    // another one needs nothing more.
    let (mut together, mut apart): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut known = uses(&together).unwrap_or_default();
    for k in all {
        let content = &seen.claims[k].1;
        if together.iter().any(|known| seen.claims[*known].1 == *content) {
            continue;
        }
        if count(together.len() / 4).is_none() {
            break;
        }
        together.push(k);
        let Some(with) = uses(&together) else { break };
        if with.are_finer(&known) {
            together.pop();
            apart.push(k);
        } else {
            known = with;
        }
    }
    let mut groups: Vec<(Uses, Vec<usize>)> = Vec::new();
    // Claims stand in the order of their numbers.
    for k in apart {
        let number = seen.claims[k].0;
        let with = together.iter().copied().chain([k]).listed();
        let Some(own) = uses(&with).filter(|_| count(4 * groups.len()).is_some()) else { break };
        // A mistaken claim has a message of its own.
        let alike = |known: &Uses| !own.are_mistaken() && !own.are_finer(known) && !known.are_finer(&own);
        match groups.iter_mut().find(|(known, _)| alike(known)) {
            Some((_, group)) => group.push(number),
            None => groups.push((own, vec![number])),
        }
    }
    (known, groups.into_iter().map(|(_, group)| group).listed())
}

/// What the functions and the claims of a family contain, these with the number of their statement.
#[derive(Default)]
struct Seen {
    functions: Content,
    claims: Vec<(usize, Content)>,
    beside: Vec<Var>,
}

/// Arguments of sines and exponentials, and values that angles are given.
#[derive(Default)]
struct Content {
    arguments: Vec<Argument>,
    places: Vec<(Var, Fraction)>,
}

impl Content {
    const fn len(&self) -> usize {
        self.arguments.len() + self.places.len()
    }

    fn extend(&mut self, more: Self) {
        self.arguments.extend(more.arguments);
        self.places.extend(more.places);
    }
}

impl PartialEq for Content {
    fn eq(&self, other: &Self) -> bool {
        let alike = |(a, b): (&Argument, &Argument)| a.name == b.name && a.value == b.value;
        self.arguments.len() == other.arguments.len()
            && self.arguments.iter().zip(&other.arguments).all(alike)
            && self.places == other.places
    }
}

/// The variables of a family: its shape parameters, those of its domain, and π.
struct Variables<'n> {
    names: &'n [String],
    shapes: usize,
    pi: Option<Var>,
}

impl Seen {
    /// Notes what a claim contains, further spans included.
    fn add(&mut self, number: usize, content: Content) {
        match self.claims.binary_search_by(|(known, _)| known.cmp(&number)) {
            Ok(place) => self.claims[place].1.extend(content),
            Err(place) => self.claims.insert(place, (number, content)),
        }
    }

    /// The uses in the functions, and in some of the claims.
    fn uses(&self, claims: &[usize], Variables { names, shapes, pi }: &Variables<'_>) -> Uses {
        let mut uses = Uses { beside: self.beside.clone(), ..Uses::default() };
        let contents = || core::iter::once(&self.functions).chain(claims.iter().map(|k| &self.claims[*k].1));
        for Argument { name, value, span } in contents().flat_map(|content| &content.arguments) {
            let span = *span;
            let Some(linear) = Linear::of(value, *pi) else {
                let pair = frequency(value, |v| v.0 < *shapes, |v| (*shapes..names.len()).contains(&v.0));
                if let Some((parameter, t)) = pair {
                    let turns = pi.is_some_and(|pi| value.depends_on(pi));
                    uses.frequencies.push((parameter, t, name.clone(), span, turns));
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
                let of = Use { kind, turns: *turns, unit: factor.abs(), torn: None, beside: false, span };
                uses.add(*var, of);
            }
            if !circular && !linear.number.is_zero() {
                uses.numbers.push(linear.number.abs());
            }
            if circular && !linear.pi.is_zero() && special(name, &linear).is_none() {
                uses.turns.push(&linear.pi * &Rational::new(1, 2));
            }
        }
        for (var, value) in contents().flat_map(|content| &content.places) {
            let Some(of) = uses.of(*var).cloned() else { continue };
            let Some(linear) = Linear::of(value, *pi) else { continue };
            // In the middle of the domain, at t = α/2, the angle of α is half of that of t.
            for (shape, factor, _) in linear.parts.iter().filter(|(shape, ..)| shape.0 < *shapes) {
                uses.add(*shape, Use { unit: &of.unit * &factor.abs(), ..of.clone() });
            }
            if of.kind == Kind::Hyperbolic && !linear.number.is_zero() {
                uses.numbers.push(&linear.number.abs() * &of.unit);
            }
            uses.places.push((*var, Linear { parts: Vec::new(), ..linear }));
        }
        uses
    }
}

impl Uses {
    /// Whether no family can have all of them.
    fn are_mistaken(&self) -> bool {
        !self.frequencies.is_empty() || self.by_var.iter().any(|(_, of)| of.torn.is_some())
    }

    /// Whether an angle or a number that others have, too, is needed in smaller parts than there, or a tangent that is
    /// irrational and that they do not need.
    fn are_finer(&self, others: &Self) -> bool {
        let is_finer = |(var, of): &(Var, Use)| others.of(*var).is_some_and(|known| of.unit != known.unit);
        let unit = |uses: &Self| uses.numbers.iter().fold(Rational::ZERO, |unit, number| unit.gcd(number));
        let parts = |uses: &Self| {
            let half = Rational::new(1, 2);
            let at = |(var, value): &(Var, Linear)| {
                let of = uses.of(*var).filter(|of| of.kind == Kind::Circular)?;
                Some(&(if of.turns { &value.number } else { &value.pi } * &of.unit) * &half)
            };
            let turns = uses.turns.iter().cloned().chain(uses.places.iter().filter_map(at));
            turns.fold(Rational::new(1, 4), |unit, psi| unit.gcd(&psi))
        };
        self.are_mistaken() && !others.are_mistaken()
            || self.by_var.iter().any(is_finer)
            || !others.numbers.is_empty() && unit(self) != unit(others)
            || parts(self) != parts(others)
    }
}

/// Evaluates the functions and the claims of a family.
fn probe_claims<'a>(probe: &mut Scope<'a>, written: &'a syntax::Family, seen: &mut Seen) {
    probe.stage = Stage::Defining;
    names::plan(probe, written);
    functions::define(probe, written);
    probe.stage = Stage::Complete;
    let take = |probe: &mut Scope<'a>| {
        let recorded = probe.recorded.replace(Recorded::default()).unwrap_or_default();
        Content { arguments: recorded.arguments, places: recorded.places }
    };
    seen.functions.extend(take(probe));
    for (number, statement) in written.statements.iter().enumerate() {
        let StatementKind::Claim(claim) = &statement.kind else { continue };
        let Anew { given, statements } = &probe.anew;
        let is_about = |number| statements.is_empty() || statements.contains(&number);
        let mut content = Content::default();
        match &claim.kind {
            ClaimKind::Relation(relation) if given.is_empty() && is_about(number) => {
                probe_relation(probe, relation);
            }
            ClaimKind::At(bindings, relations) if is_about(number) && is_about_given(probe, bindings) => {
                for binding in bindings {
                    let name = names::attempt(probe, &mut |probe| names::bound_name(probe, binding));
                    let place = name.and_then(|name| probe.variable(&name)).zip(probe.scalar(&binding.value));
                    content.places.extend(place);
                }
                for relation in relations {
                    probe_relation(probe, relation);
                }
            }
            _ => {}
        }
        content.extend(take(probe));
        if content.len() > 0 {
            seen.add(number, content);
        }
    }
}

/// Whether a block gives all shape parameters their values that have one.
fn is_about_given(probe: &mut Scope<'_>, bindings: &[Binding]) -> bool {
    let given = probe.anew.given.clone();
    given.iter().all(|(name, turns)| {
        // A name without an index stands for all of its parameters.
        let base = name.split('[').next();
        let own = bindings.iter().find(|b| {
            let bound = names::attempt(probe, &mut |probe| names::bound_name(probe, b));
            bound.is_some_and(|bound| bound == *name || Some(bound.as_str()) == base)
        });
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
