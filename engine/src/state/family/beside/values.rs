//! Numbers between which functions lie at a point of a domain with an angle.
//!
//! At a point the tangents and all other variables are rational; the angles themselves, π and exp(r) are not, unless the
//! point is an end.

use basis_kernel::Statement;
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, candidates, refute};
use std::rc::Rc;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::enclosure::inverse;
use crate::model::angle::{Angle, Kind};

/// The level of the continued fractions from which the values of angles come.
const LEVEL: u32 = 12;

/// Units of work for the numbers between which an angle lies, and for a product of two pairs of such numbers.
pub(super) const ENCLOSURE: u64 = 1000;
pub(super) const PRODUCT: u64 = 20;

/// Units of work for a factor of a term that is a rational coordinate.
const PLACED: u64 = 3;

/// Variables with their values.
pub(in crate::state) type Values = Vec<(Var, Rational)>;

/// Two numbers, the first one not larger.
type Interval = (Rational, Rational);

/// Variables that have no rational value at a point.
#[derive(Clone, Debug, Default)]
pub(super) struct Enclosures {
    /// Angles that have an end of their range as value.
    pub(super) exact: Vec<(Var, Fraction)>,
    /// Numbers between which the others lie.
    pub(super) between: Vec<(Var, Interval)>,
}

/// The numbers between which the others lie at a point; `None` beyond the reach of a tangent.
pub(super) fn enclosures(family: &Family, point: &Values) -> Option<Enclosures> {
    let mut found = Enclosures::default();
    let numbers = family.analytic.numbers();
    for (var, range) in &family.analytic.ranges {
        if let Some((low, high)) = range.finite().filter(|_| numbers.contains(var)) {
            found.between.push((*var, (rounded(low, false), rounded(high, true))));
        }
    }
    for angle in family.analytic.angles.iter().filter(|a| a.kind != Kind::Linear) {
        let Some((_, y)) = point.iter().find(|(var, _)| *var == angle.var) else { continue };
        let range = family.region().range(angle.var);
        let side = [&range.low, &range.high].into_iter().position(|end| end.value() == Some(y));
        if let Some(side) = side.filter(|side| !angle.ends[*side].is_empty()) {
            let limit = angle.limits[side].clone();
            found.between.push((angle.itself, between(&limit, point, &found.between)?));
            found.exact.push((angle.itself, limit));
            continue;
        }
        let (mut low, mut high) = between(&angle.tangent(), point, &found.between)?;
        if low != high {
            (low, high) = (rounded(&low, false), rounded(&high, true));
        }
        let (low, high) = (inverse(angle.kind, &low, LEVEL)?.0, inverse(angle.kind, &high, LEVEL)?.1);
        let unit = &(Rational::ONE, Rational::ONE);
        let pi = found.between.iter().find(|(v, _)| Some(*v) == family.analytic.pi).map(|(_, i)| i.clone());
        let scale = if angle.turns { pi.as_ref()? } else { unit };
        // Divided by the rate, and by π; where the range of the tangent reaches 1 and more, see `inverse`.
        let per = |x: &Rational, by: &Rational| x.checked_div(&(by * &angle.rate));
        let ends = [per(&low, &scale.0)?, per(&low, &scale.1)?, per(&high, &scale.0)?, per(&high, &scale.1)?];
        let shift = if angle.turns || angle.shift.is_zero() { unit.clone() } else { pi? };
        let low = &(&shift.0 * &angle.shift).min(&shift.1 * &angle.shift) + ends.iter().min()?;
        let high = &(&shift.0 * &angle.shift).max(&shift.1 * &angle.shift) + ends.iter().max()?;
        found.between.push((angle.itself, (rounded(&low, false), rounded(&high, true))));
    }
    Some(found)
}

/// What variables beside their sines are where that is known exactly: at ends of their ranges, and where a tangent is 0.
pub(in crate::state::family) fn exact(family: &Family, point: &Values) -> Vec<(Var, Fraction)> {
    let Some(found) = enclosures(family, point) else { return Vec::new() };
    let mut all = found.exact;
    for angle in family.analytic.angles.iter().filter(|a| a.kind != Kind::Linear) {
        if all.iter().any(|(var, _)| *var == angle.itself) {
            continue;
        }
        let tangent = between(&angle.tangent(), point, &found.between);
        if tangent.is_none_or(|(low, high)| !low.is_zero() || !high.is_zero()) {
            continue;
        }
        let shift = Fraction::constant(angle.shift.clone());
        let pi = family.analytic.pi.filter(|_| !angle.turns).map(Fraction::var);
        all.push((angle.itself, pi.map_or_else(|| shift.clone(), |pi| &shift * &pi)));
    }
    all
}

/// A counterexample to an equation at a point where the two sides differ with the value that a variable beside its sine has
/// there, t = 0 where tan(t/2) = 0; in the statement both are free.
pub(in crate::state::family) fn genuine(family: &Family, found: Counterexample) -> Counterexample {
    let statement = Rc::new(found.refutation.statement().clone());
    let Statement::Zero { value, domain } = &*statement else { return found };
    let depends = |v: Var| value.numerator.depends_on(v) || value.denominator.depends_on(v);
    let angles = family.analytic.angles.iter();
    let angles: Vec<&Angle> =
        angles.filter(|a| a.kind != Kind::Linear && a.itself != a.var && depends(a.itself)).listed();
    let mut point: Values = Vec::new();
    for (var, coordinate) in &found.point {
        let Coordinate::Rational(x) = coordinate else { return found };
        point.push((*var, x.clone()));
    }
    let differs = |point: &Values| {
        let exact = exact(family, &super::rational_part(family, point));
        let value = Fraction::new(value.numerator.clone(), value.denominator.clone())?;
        let value = exact.iter().rev().try_fold(value, |value, (var, x)| put(&value, *var, x))?;
        (!value.is_zero()).then_some(exact)
    };
    let elsewhere = angles.iter().flat_map(|angle| {
        let point = &point;
        let near = candidates(&domain.region.range(angle.var), OTHERS).into_iter();
        near.map(|x| {
            point.iter().map(|(v, y)| (*v, if *v == angle.var { x.clone() } else { y.clone() })).listed()
        })
    });
    for mut point in core::iter::once(point.clone()).chain(elsewhere) {
        let Some(exact) = differs(&point) else { continue };
        for (var, x) in exact {
            let own = point.iter_mut().find(|(v, _)| *v == var);
            if let (Some((_, value)), Some(x)) = (own, x.as_constant()) {
                *value = x;
            }
        }
        let coordinates = point.into_iter().map(|(v, x)| (v, Coordinate::Rational(x))).listed();
        if let Some(found) = refute(&statement, &coordinates, &mut Work::new(GENUINE)) {
            return found;
        }
    }
    found
}

/// How many values of an angle are tried where both sides of an equation agree at the first one.
const OTHERS: u32 = 8;

/// The work for one of them.
const GENUINE: u64 = 1_000_000;

/// A number with a short denominator that is not above, or not below, another one.
fn rounded(x: &Rational, up: bool) -> Rational {
    let unit = Rational::from(2).pow(90);
    let scaled = x * &unit;
    let whole = if up { -(-scaled).floor() } else { scaled.floor() };
    whole.checked_div(&unit).unwrap_or(Rational::ZERO)
}

fn product(a: &Interval, b: &Interval) -> Interval {
    // The ends of the product where one factor has one sign are known from the signs of the ends of the other.
    let (of, with) = if b.0.is_negative() { (b, a) } else { (a, b) };
    if !with.0.is_negative() {
        let low = if of.0.is_negative() { &with.1 } else { &with.0 };
        let high = if of.1.is_negative() { &with.0 } else { &with.1 };
        return (&of.0 * low, &of.1 * high);
    }
    let all = [&a.0 * &b.0, &a.0 * &b.1, &a.1 * &b.0, &a.1 * &b.1];
    let least = all.iter().min().cloned().unwrap_or(Rational::ZERO);
    let most = all.into_iter().max().unwrap_or(Rational::ZERO);
    (least, most)
}

/// Numbers between which a polynomial lies at a point.
pub(super) fn of_poly(p: &Poly, point: &Values, wide: &[(Var, Interval)]) -> Option<Interval> {
    let p = point.iter().fold(p.clone(), |p, (var, x)| p.at(*var, x));
    // The powers of each variable, from the first on.
    let mut powers: Vec<(Var, Vec<Interval>)> = Vec::new();
    for var in p.variables() {
        let interval = &wide.iter().find(|(v, _)| *v == var)?.1;
        let mut all = vec![interval.clone()];
        for k in 1..p.degree(var) as usize {
            all.push(product(&all[k - 1], interval));
        }
        powers.push((var, all));
    }
    let mut sum = (Rational::ZERO, Rational::ZERO);
    for (m, c) in p.terms() {
        let factors = powers
            .iter()
            .filter_map(|(var, all)| usize::from(m.exponent(*var)).checked_sub(1).and_then(|k| all.get(k)));
        let one = (Rational::ONE, Rational::ONE);
        let term = product(&(c.clone(), c.clone()), &factors.fold(one, |term, power| product(&term, power)));
        sum = (&sum.0 + &term.0, &sum.1 + &term.1);
    }
    Some(sum)
}

/// Numbers between which a quotient lies at a point; `None` where its denominator is not seen to differ from 0.
pub(super) fn between(f: &Fraction, point: &Values, wide: &[(Var, Interval)]) -> Option<Interval> {
    let below = of_poly(f.denom(), point, wide)?;
    if below.0.signum() * below.1.signum() <= 0 {
        return None;
    }
    let above = of_poly(f.numer(), point, wide)?;
    Some(product(&above, &(below.1.recip()?, below.0.recip()?)))
}

/// The work of finding numbers between which a quotient lies at a point: rational coordinates are put in, pairs of numbers are
/// multiplied for the others.
pub(super) fn cost(family: &Family, f: &Fraction) -> u64 {
    let numbers = family.analytic.numbers();
    let angles = family.analytic.angles.iter().filter(|a| a.itself != a.var).map(|a| a.itself);
    let wide = angles.chain(numbers).listed();
    let of_term = |m: &Monomial| {
        let pairs = wide.iter().map(|v| u64::from(m.exponent(*v))).sum::<u64>();
        PLACED * u64::from(m.total_degree()) + PRODUCT * (1 + pairs)
    };
    let of = |p: &Poly| p.terms().map(|(m, _)| of_term(m)).sum::<u64>();
    of(f.numer()) + of(f.denom())
}

/// About which values the variables have at a point that is named by a tangent between those at the ends of a range: their
/// names and values.
pub(in crate::state) fn about(family: &Family, point: &Values) -> Vec<(String, Rational)> {
    let Some(found) = enclosures(family, point) else { return Vec::new() };
    let scaled = |angle: &&Angle| {
        let direct = angle.low.is_zero() && angle.width.as_constant().is_some_and(|w| w == Rational::ONE);
        angle.kind != Kind::Linear && !direct && point.iter().any(|(var, _)| *var == angle.var)
    };
    let of = |angle: &Angle| {
        if found.exact.iter().any(|(var, _)| *var == angle.itself) {
            return None; // an end, which is named
        }
        let (low, high) = &found.between.iter().find(|(var, _)| *var == angle.itself)?.1;
        Some((angle.name.clone(), &(low + high) * &Rational::new(1, 2)))
    };
    family.analytic.angles.iter().filter(scaled).filter_map(of).listed()
}

/// About which value a function has at a point, where its enclosure tells.
pub(super) fn about_value(family: &Family, point: &Values, f: &Fraction) -> Option<Rational> {
    let found = enclosures(family, point)?;
    let f = found.exact.iter().rev().try_fold(f.clone(), |f, (var, x)| put(&f, *var, x))?;
    let (low, high) = between(&f, point, &found.between)?;
    Some(&(&low + &high) * &Rational::new(1, 2))
}

/// Numbers between which a function lies at a point of the domain where the variable that stands for a tangent, and the angle
/// itself, are functions of π, exp(r) and tan(π/n); shape parameters have values.
pub(super) fn about_at(
    family: &Family,
    f: &Fraction,
    (angle, y, itself): (&Angle, &Fraction, &Fraction),
    typical: &Values,
    work: &mut Work,
) -> Option<Interval> {
    work.spend(ENCLOSURE + cost(family, f))?;
    let is_shape = |var: Var| family.shapes.iter().any(|p| p.var == var);
    let shapes = typical.iter().filter(|(var, _)| is_shape(*var)).cloned().listed();
    let mut found = enclosures(family, &shapes)?;
    for (var, place) in [(angle.var, y), (angle.itself, itself)] {
        let (low, high) = between(place, &shapes, &found.between)?;
        found.between.push((var, (rounded(&low, false), rounded(&high, true))));
    }
    between(f, &shapes, &found.between)
}

/// A number below or above a function of π and exp(r).
pub(super) fn bound(family: &Family, f: &Fraction, up: bool) -> Option<Rational> {
    let found = enclosures(family, &Vec::new())?;
    let (low, high) = between(f, &Vec::new(), &found.between)?;
    Some(rounded(if up { &high } else { &low }, up))
}

/// A quotient with a quotient in place of a variable.
pub(super) fn put(f: &Fraction, var: Var, x: &Fraction) -> Option<Fraction> {
    f.substitute(var, x)
}
