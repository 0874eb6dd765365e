//! The tangent in which an angle is expanded, and the range of that.

use super::declared::Declared;
use super::edges::Edge;
use super::limits::{Bound, Limits, Place, Tangent, declared, of_end, ordered, sum_of};
use super::numbers::ranges;
use super::rate::Rate;
use super::survey::Use;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::model::Parameter;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::angle::{Angle, Kind};
use crate::model::chart::Constraint;
use crate::model::scope::Scope;
use crate::syntax::RangeDecl;
use basis_kernel::Relation;
use basis_prover::collections::list::Listed;

/// A domain variable whose ends contain shape parameters or π: y runs from 0 to 1.
pub(super) fn linear(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    limits: &Limits,
    count: usize,
    (known, constraints): (&[Parameter], &[Constraint]),
) -> Option<Range> {
    let name = &decl.name.text;
    let [Some(low), Some(high)] = limits else {
        let error = scope.error(decl.name.span, format!("the domain of `{name}` has no end on one side"));
        scope.report(error.help("write both ends, such as `domain 0 <= t <= α;`"));
        return None;
    };
    let (first, last) = (sum_of(scope, &low.value, count)?, sum_of(scope, &high.value, count)?);
    let width = &last - &first;
    let of_angles = scope.analytic.angles.iter().filter_map(|angle| {
        let range = &known.iter().find(|p| p.var == angle.var)?.range;
        Some((angle.itself, range_itself(angle, range, scope.analytic.pi)))
    });
    let ranges = known.iter().map(|p| (p.var, p.range.clone())).chain(of_angles).chain(ranges(scope));
    let region = Region { ranges: ranges.listed() };
    if let Err(text) = scope.is_positive(&width, &region, constraints) {
        let mut at_ends = low.value.parts.iter().chain(&high.value.parts);
        if at_ends.any(|(var, ..)| scope.is_mistaken(scope.names[var.0].trim_end())) {
            return None; // its range is not known
        }
        let message = format!("the ends of the domain of `{name}` are not in order");
        let error = scope.error(decl.name.span, message).label(text);
        scope.report(
            error.help("narrow the ranges of the parameters so that the lower end is below the upper one"),
        );
        return None;
    }
    let new = Angle {
        name: name.clone(),
        kind: Kind::Linear,
        var: at.slot,
        itself: at.itself,
        rate: Rational::ONE,
        turns: false,
        shift: Rational::ZERO,
        low: first.clone(),
        width,
        limits: [first.clone(), last.clone()],
        ends: [low.text.clone(), high.text.clone()],
        declared: declared(name, limits),
        mirror: Vec::new(),
    };
    let own = |f: &Fraction| {
        let text = f.display(&scope.names);
        if text.contains([' ', '*', '/']) { format!("({text})") } else { text }
    };
    let (from, width) = (first.display(&scope.names), own(&new.width));
    scope.names[at.slot.0] = match (new.low.is_zero(), from.strip_prefix('-')) {
        (true, _) => format!("{name}/{width}"),
        (false, Some(below)) if !below.contains(' ') => format!("({name} + {below})/{width}"),
        _ => format!("({name} - {})/{width}", own(&first)),
    };
    scope.analytic.angles.push(new);
    scope.ends.push((Fraction::zero(), Fraction::constant(Rational::ONE)));
    Some(unit([low, high]))
}

/// The range of a parameter that stands in sin, cos or exp as well, from that of its tangent; where it ends at multiples of π a
/// wider one.
fn range_itself(angle: &Angle, of_tangent: &Range, pi: Option<Var>) -> Range {
    let end = |side: usize| {
        let known = [&of_tangent.low, &of_tangent.high][side];
        let limit = &angle.limits[side];
        if angle.ends[side].is_empty() || known.value().is_none() {
            return End::Infinite;
        }
        if let Some(x) = limit.as_constant() {
            return if known.is_included() { End::Included(x) } else { End::Excluded(x) };
        }
        let (low, high) = pi_bounds();
        let at = |x: &Rational| limit.substitute(pi?, &Fraction::constant(x.clone()))?.as_constant();
        match (at(low), at(high)) {
            (Some(a), Some(b)) => End::Excluded(if side == 0 { a.min(b) } else { a.max(b) }),
            _ => End::Infinite,
        }
    };
    Range { low: end(0), high: end(1) }
}

/// From 0 to 1, with the ends of a declared range that belong to it.
fn unit([low, high]: [&Bound; 2]) -> Range {
    Range { low: low.of(Rational::ZERO), high: high.of(Rational::ONE) }
}

/// Makes a variable an angle; the range of y.
pub(super) fn angle(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    of: &Use,
    limits: &Limits,
    (all, count, known): (&[Option<Use>], usize, &[Parameter]),
    conditions: &mut Vec<Constraint>,
) -> Option<Range> {
    let ends: Vec<&Bound> = limits.iter().flatten().listed();
    let declared = Declared { decl, at, of, limits, ends, all, count, known };
    declared.has_its_ends(scope)?;
    let Rate { factor: rate, shift, edges, by_root } = declared.rate(scope)?;
    let mut new = declared.angle(scope, rate, shift);
    scope.names[at.slot.0] = new.tangent_name();
    let exact = !declared.is_parametric()
        && !by_root
        && declared.ends.iter().all(|l| l.value.number.is_zero() || of.turns && declared.is_circular());
    let range = if exact {
        declared.between_numbers(&new, &edges)
    } else {
        declared.between_functions(scope, &mut new)?
    };
    if range.is_empty() || at.is_domain && range.finite().is_none_or(|(a, b)| a >= b) {
        let of_pi = declared.ends.iter().find(|l| !l.value.pi.is_zero() && !declared.is_circular());
        if let Some(end) = of_pi {
            let message =
                format!("the end {} of the range of `{}` is no rational number", end.text, declared.name());
            return declared.wrong(scope, message, RATIONAL_ENDS);
        }
        let message = format!("the range of `{}` is empty", declared.name());
        return declared.wrong(scope, message, "write the smaller end first");
    }
    scope.analytic.angles.push(new);
    conditions.extend(declared.conditions(edges));
    Some(range)
}

/// What to write where a range of a variable in exponentials ends at a multiple of π.
const RATIONAL_ENDS: &str = "in `exp`, `sinh` and `cosh` ranges end at rational numbers or at a shape parameter: `shape 0 < α; domain 0 <= t <= α;`";

impl Declared<'_> {
    /// The angle, whose tangent runs from 0 with width 1 until its ends are known.
    fn angle(&self, scope: &Scope<'_>, rate: Rational, shift: Rational) -> Angle {
        let (name, limits) = (self.name(), self.limits);
        let sum = |l: &Bound| sum_of(scope, &l.value, self.count);
        Angle {
            name: name.to_owned(),
            kind: self.of.kind,
            var: self.at.slot,
            itself: self.at.itself,
            rate,
            turns: self.of.turns,
            shift,
            low: Fraction::zero(),
            width: Fraction::constant(Rational::ONE),
            limits: [0, 1].map(|k| limits[k].as_ref().and_then(sum).unwrap_or_else(Fraction::zero)),
            ends: [0, 1].map(|k| limits[k].as_ref().map_or_else(String::new, |l| l.text.clone())),
            declared: declared(name, limits),
            mirror: Vec::new(),
        }
    }

    /// The range of the tangent between ends at which it is rational or infinite, or that have an edge in their place.
    fn between_numbers(&self, new: &Angle, edges: &[Option<Edge>; 2]) -> Range {
        let end = |side: usize| match (&self.limits[side], &edges[side]) {
            (Some(l), Some(edge)) => l.of(edge.beyond.clone()),
            // Only of a hyperbolic parameter.
            (None, _) => End::Excluded(Rational::from(if side == 0 { -1 } else { 1 })),
            (Some(l), None) => match Tangent::of(new.kind, &new.rate, new.turns, &new.shift, &l.value) {
                Tangent::Exact(x) => l.of(x),
                Tangent::Infinite | Tangent::Irrational => End::Infinite,
            },
        };
        Range { low: end(0), high: end(1) }
    }

    /// The range of y, from 0 to 1, where x = low + width·y, with low and width as functions of shape parameters, π and
    /// exp(r).
    fn between_functions(&self, scope: &mut Scope<'_>, new: &mut Angle) -> Option<Range> {
        let mut tangents = Vec::new();
        for (limit, beyond) in self.limits.iter().zip([-1, 1]) {
            tangents.push(match limit {
                Some(end) => self.tangent_at(scope, new, end)?,
                // Only a hyperbolic parameter has no end: its tangent goes to ±1.
                None => Fraction::constant(Rational::from(beyond)),
            });
        }
        self.are_in_order(scope)?;
        let [first, last] = <[Fraction; 2]>::try_from(tangents).ok()?;
        new.width = &last - &first;
        new.low = first;
        // In brackets, as powers of it may be written.
        let text = |side: usize, beyond: &str| {
            self.limits[side].as_ref().map_or_else(|| String::from(beyond), |end| of_end(new, end))
        };
        let (x, from, to) = (new.tangent_name(), text(0, "(-1)"), text(1, "1"));
        scope.names[self.at.slot.0] = if new.low.is_zero() {
            format!("({x}/{to})")
        } else {
            format!("(({x} - {from})/({to} - {from}))")
        };
        let end = |side: usize, y: Rational| match &self.limits[side] {
            Some(end) => end.of(y),
            None => End::Excluded(y),
        };
        Some(Range { low: end(0, Rational::ZERO), high: end(1, Rational::ONE) })
    }

    /// Reports ends that are not in order, or are not known to be.
    fn are_in_order(&self, scope: &Scope<'_>) -> Option<()> {
        let name = self.name();
        if self.at.is_domain {
            if ordered(scope, &self.ends, self.known) {
                return Some(());
            }
            let message = format!("the ends of the domain of `{name}` could not be proved to be in order");
            let help = if self.is_circular() {
                "let the parameter at the end be positive: `shape 0 < α < pi; domain 0 <= t <= α;`"
            } else {
                "let the parameter at the end be positive: `shape 0 < α; domain 0 <= t <= α;`"
            };
            return self.wrong(scope, message, help);
        }
        match self.ends[..] {
            [low, high] if low.value.about() > high.value.about() => {
                self.wrong(scope, format!("the range of `{name}` is empty"), "write the smaller end first")
            }
            _ => Some(()),
        }
    }

    /// x at an end.
    fn tangent_at(&self, scope: &mut Scope<'_>, new: &Angle, end: &Bound) -> Option<Fraction> {
        let mut sum = Fraction::constant(end.value.number.clone());
        for (var, factor, _) in &end.value.parts {
            sum = &sum + &(&Fraction::constant(factor.clone()) * &Fraction::var(*var));
        }
        if let Some(pi) = scope.analytic.pi {
            sum = &sum + &(&Fraction::constant(end.value.pi.clone()) * &Fraction::var(pi));
        }
        match scope.angle_at(new, &sum, self.decl.name.span) {
            Ok(x) => x,
            Err((message, help)) => self.wrong(scope, message, &help),
        }
    }

    /// That an angle lies between its ends, where edges stand in their places.
    fn conditions(&self, edges: [Option<Edge>; 2]) -> Vec<Constraint> {
        let mut all = Vec::new();
        for (edge, limit) in edges.into_iter().zip(self.limits) {
            let (Some(edge), Some(limit)) = (edge, limit) else { continue };
            let relation = if limit.included { Relation::NonNegative } else { Relation::Positive };
            let text = declared(self.name(), self.limits);
            all.push(Constraint { value: edge.inside, relation, text, is_end: true });
        }
        all
    }
}
