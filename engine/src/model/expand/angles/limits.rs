//! The ends of ranges, which may contain π and shape parameters.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::model::Parameter;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::angle::{Angle, Kind, multiple_of_pi};
use crate::model::formula::phase::Linear;
use crate::model::formula::print::Printer;
use crate::model::scope::Scope;
use crate::syntax::{self, RangeDecl};
/// Where a variable stands.
pub(super) struct Place {
    pub(super) slot: Var,
    pub(super) itself: Var,
    pub(super) is_domain: bool,
}

/// An end of a range of an angle.
pub(super) struct Bound {
    pub(super) value: Linear,
    pub(super) included: bool,
    pub(super) text: String,
}

impl Bound {
    /// Whether it contains π or shape parameters.
    pub(super) fn is_no_number(&self) -> bool {
        !self.value.pi.is_zero() || !self.value.parts.is_empty()
    }

    /// The end of another range at a number, which belongs to that range if this one belongs to its own.
    pub(super) fn of(&self, x: Rational) -> End {
        if self.included { End::Included(x) } else { End::Excluded(x) }
    }
}

/// x at a number, by ψ/π or by the number.
pub(super) enum Tangent {
    Exact(Rational),
    Infinite,
    Irrational,
}

impl Tangent {
    pub(super) fn of(kind: Kind, rate: &Rational, turns: bool, shift: &Rational, at: &Linear) -> Self {
        if kind == Kind::Hyperbolic {
            return if at.number.is_zero() { Self::Exact(Rational::ZERO) } else { Self::Irrational };
        }
        let (own, other) = if turns { (&at.number, &at.pi) } else { (&at.pi, &at.number) };
        if !other.is_zero() {
            return Self::Irrational;
        }
        let psi = &(own - shift) * rate; // in multiples of π
        match (&psi * &Rational::from(4)).to_i64() {
            Some(k @ (-1..=1)) => Self::Exact(Rational::from(k)),
            Some(2 | -2) => Self::Infinite,
            _ => Self::Irrational,
        }
    }
}

/// The ends of a range as they are written, where it has ends; `None` when one is no sum of multiples.
pub(super) fn limits(scope: &mut Scope<'_>, decl: &RangeDecl) -> Option<Limits> {
    let mut ends = [None, None];
    for (end, limit) in ends.iter_mut().zip([&decl.low, &decl.high]) {
        let Some(syntax::Limit { value: expr, included }) = limit else { continue };
        let value = scope.scalar(expr).and_then(|f| Linear::of(&f, scope.analytic.pi));
        let Some(value) = value else {
            if scope.diagnostics.borrow().is_empty() {
                let message = "the end of a range is a number, a multiple of `pi`, or a shape parameter";
                scope.report(scope.error(expr.span, message));
            }
            return None;
        };
        let text = Printer { constants: &scope.constants, component: None }.print(expr);
        *end = Some(Bound { value, included: *included, text });
    }
    Some(ends)
}

/// The ends of a range, the lower one first.
pub(super) type Limits = [Option<Bound>; 2];

/// The range as it is written.
pub(super) fn declared(name: &str, limits: &Limits) -> String {
    let sign = |limit: &Bound| if limit.included { "<=" } else { "<" };
    let mut text = String::from(name);
    if let [Some(low), _] = limits {
        text = format!("{} {} {text}", low.text, sign(low));
    }
    if let [_, Some(high)] = limits {
        text = format!("{text} {} {}", sign(high), high.text);
    }
    text
}

/// The sum at an end of a range.
pub(super) fn sum_of(scope: &Scope<'_>, value: &Linear, count: usize) -> Option<Fraction> {
    let mut sum = Fraction::constant(value.number.clone());
    for (var, factor, turns) in &value.parts {
        // A parameter that is no angle stands where it is declared.
        let angle = scope.analytic.angles.iter().any(|a| a.itself == *var);
        let var = if angle { *var } else { Var(var.0.checked_sub(count)?) };
        let mut part = &Fraction::constant(factor.clone()) * &Fraction::var(var);
        if *turns {
            part = &part * &Fraction::var(scope.analytic.pi?);
        }
        sum = &sum + &part;
    }
    if !value.pi.is_zero() {
        sum = &sum + &(&Fraction::constant(value.pi.clone()) * &Fraction::var(scope.analytic.pi?));
    }
    Some(sum)
}

/// ψ/π at an end of a range that is a multiple of π, or of 1 where the rate is one of π.
pub(super) fn psi(rate: &Rational, turns: bool, shift: &Rational, end: &Bound) -> Rational {
    &(if turns { &end.value.number } else { &end.value.pi } - shift) * rate
}

/// Whether `rate` times an end that holds shape parameters is less than a quarter turn at all their values.
pub(super) fn stays_finite(scope: &Scope<'_>, rate: &Rational, end: &Bound, known: &[Parameter]) -> bool {
    let value = &end.value;
    let mut reached = true;
    if let ([(var, factor, _)], true) = (&value.parts[..], value.pi.is_zero() && value.number.is_zero()) {
        // Of one parameter alone it is known from its own range.
        let Some(angle) = scope.analytic.angles.iter().find(|a| a.itself == *var) else { return false };
        if angle.rate == rate * &factor.abs() {
            return true;
        }
        let own = known.iter().find(|parameter| parameter.var == angle.var);
        reached = own.is_none_or(|own| {
            [&own.range.low, &own.range.high]
                .iter()
                .any(|end| matches!(end, End::Included(x) if !x.is_zero()))
        });
    }
    // In units of π.
    let Some(pi) = scope.analytic.pi else { return false };
    let mut sum = value.pi.abs();
    for (var, factor, _) in &value.parts {
        let Some(angle) = scope.analytic.angles.iter().find(|a| a.itself == *var) else { return false };
        let mut largest = Rational::ZERO;
        for limit in &angle.limits {
            let Some(limit) = Linear::of(limit, Some(pi)).filter(|limit| limit.parts.is_empty()) else {
                return false;
            };
            let number = limit.number.abs().checked_div(&pi_bounds().0).unwrap_or(Rational::ZERO);
            largest = largest.max(&limit.pi.abs() + &number);
        }
        sum += &(&largest * &factor.abs());
    }
    let (turned, quarter) = (rate * &sum, Rational::new(1, 2));
    value.number.is_zero() && (turned < quarter || turned == quarter && !reached)
}

/// x at an end of the range, for reading, such as `tan(α/2)`, `tanh(1)` or `(a + h)`.
pub(super) fn of_end(angle: &Angle, end: &Bound) -> String {
    let Linear { number, pi, parts } = &end.value;
    let alone = parts.is_empty() && angle.shift.is_zero() && !angle.turns;
    match angle.kind {
        Kind::Hyperbolic if alone && pi.is_zero() => format!("tanh({})", number * &angle.rate),
        Kind::Circular if alone && number.is_zero() => {
            match Tangent::of(angle.kind, &angle.rate, false, &Rational::ZERO, &end.value) {
                Tangent::Exact(x) => x.to_string(),
                _ => format!("tan({})", multiple_of_pi(&(pi * &angle.rate))),
            }
        }
        Kind::Circular if alone && pi.is_zero() => format!("tan({})", number * &angle.rate),
        _ => {
            let sum = end.text.contains(' ');
            let name = if sum { format!("({})", end.text) } else { end.text.clone() };
            Angle { name, ..angle.clone() }.tangent_name()
        }
    }
}

/// Whether the upper of two ends is above the lower one for all values of the parameters.
pub(super) fn ordered(scope: &Scope<'_>, ends: &[&Bound], known: &[Parameter]) -> bool {
    let [low, high] = ends else { return false };
    are_ordered(scope, &low.value, &high.value, known)
}

/// Whether one sum is seen to be less than another for all values of the parameters.
pub(in crate::model::expand) fn are_ordered(
    scope: &Scope<'_>,
    low: &Linear,
    high: &Linear,
    known: &[Parameter],
) -> bool {
    let mut width = high.clone();
    let turned = low.scaled(&Rational::from(-1));
    width.pi += &turned.pi;
    width.number += &turned.number;
    for (var, factor, _) in &turned.parts {
        match width.parts.iter_mut().find(|(v, ..)| v == var) {
            Some((_, known, _)) => *known += factor,
            None => width.parts.push((*var, factor.clone(), false)),
        }
    }
    // The least value between the ends of the parameters, and whether it is taken.
    let (mut number, mut pi, mut taken) = (width.number, width.pi, true);
    for (var, factor, _) in width.parts.iter().filter(|(_, factor, _)| !factor.is_zero()) {
        let Some(angle) = scope.analytic.angles.iter().find(|a| a.itself == *var) else { return false };
        let Some(own) = known.iter().find(|p| p.var == angle.var) else { return false };
        let side = usize::from(factor.is_negative());
        let limit = Linear::of(&angle.limits[side], scope.analytic.pi);
        let Some(limit) = limit.filter(|l| l.parts.is_empty() && !angle.ends[side].is_empty()) else {
            return false;
        };
        number += &(factor * &limit.number);
        pi += &(factor * &limit.pi);
        taken &= [&own.range.low, &own.range.high][side].is_included();
    }
    let (below, above) = pi_bounds();
    let least = &number + &(&pi * if pi.is_negative() { above } else { below });
    least.is_positive() || number.is_zero() && pi.is_zero() && !taken
}
