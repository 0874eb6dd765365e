//! Signs under assumptions that are no part of a box, such as α² + β² ≤ 1.
//!
//! **Theorem.** Where g ≥ 0, a function f with f − c·m·g ≥ 0 is ≥ 0, for a number c ≥ 0 and a product m of powers that are ≥ 0
//! (the S-procedure of V. A. Yakubovich 1971). It is > 0 if f − c·m·g is, or if g, c and m are.
//!
//! The premise is then no longer needed: f − c·m·g ≥ 0 is said of the whole box. The number c has to satisfy
//! c·m·g ≤ f at all points; what some points say of it leaves an interval, from which it is chosen. That it is right is for
//! the kernel to see.

use basis_kernel::{Domain, Relation};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Counterexample, refute, typical};
use core::cmp::Ordering;
use std::rc::Rc;

use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;
use crate::algebra::work::Work;
use basis_kernel::{Quotient, Statement};

/// Points at which functions are looked at, at most.
const MAX_POINTS: usize = 800;

/// Steps that are tried on the way down.
const MAX_TRIES: usize = 3000;

/// More terms than this are not evaluated at that many points.
const MAX_TERMS: usize = 400;

/// What is enough for a statement about a sign to hold where its premises do; `None` if it does not need them, or seems to be
/// false, or no multiple of a premise is found to help.
pub(super) fn without(statement: &Statement) -> Option<Statement> {
    let Statement::Sign { value, relation, domain } = statement else { return None };
    if domain.premises.is_empty() {
        return None;
    }
    let points = sample(value, domain)?;
    let f = values(&value.numerator, &value.denominator, &points)?;
    // Without a negative value the box alone may be enough.
    f.iter().flatten().find(|x| x.is_negative())?;
    let one = Poly::one();
    let factor = common(&value.numerator, domain);
    let m = values(&factor, &one, &points)?;
    for (g, premise) in &domain.premises {
        if g.is_zero() {
            continue;
        }
        let own = values(g, &one, &points)?;
        let (mut low, mut high) = (Rational::ZERO, None::<Rational>);
        let mut fits = true;
        for ((f, g), m) in f.iter().zip(&own).zip(&m) {
            let (Some(f), Some(g), Some(m)) = (f, g, m) else { continue };
            let bound = &(g * m);
            match bound.signum() {
                0 => fits &= !f.is_negative(),
                1 => {
                    let most = f.checked_div(bound)?;
                    high = Some(high.map_or(most.clone(), |known| known.min(most)));
                }
                _ => low = low.max(f.checked_div(bound)?),
            }
        }
        let c = match high {
            Some(high) if fits && low <= high => {
                // Away from both ends, if there is room.
                let quarter = &(&high - &low) * &Rational::new(1, 4);
                simplest_within(&(&low + &quarter), &(&high - &quarter))
            }
            None if fits => &low + &Rational::ONE,
            _ => continue,
        };
        if !c.is_positive() {
            continue;
        }
        let term = &(g * &factor).scale(&c) * &value.denominator;
        let numerator = &value.numerator - &term;
        let value = Quotient { numerator, denominator: value.denominator.clone() };
        // From a strict premise follows a strict inequality.
        let strict = *relation == Relation::Positive && *premise == Relation::Positive && factor.is_one();
        let relation = if strict { Relation::NonNegative } else { *relation };
        let domain = Rc::new(Domain { premises: Vec::new(), ..(**domain).clone() });
        return Some(Statement::Sign { value, relation, domain });
    }
    None
}

/// A counterexample to a statement about a sign under premises, among some points.
pub(super) fn counterexample(statement: &Statement, work: &mut Work) -> Option<Counterexample> {
    let Statement::Sign { value, relation, domain } = statement else { return None };
    if domain.premises.is_empty() {
        return None;
    }
    let points = sample(value, domain)?;
    let f = values(&value.numerator, &value.denominator, &points)?;
    let counts =
        |point: &Vec<Rational>| domain.premises.iter().all(|(g, relation)| relation.holds(&g.eval(point)));
    // Of points with the same value the one that is farthest inside has the most room around it.
    let room = |point: &Vec<Rational>| domain.premises.iter().map(|(g, _)| g.eval(point)).min();
    let mut best: Option<(Vec<Rational>, Rational)> = None;
    for (point, f) in points.iter().zip(f) {
        let Some(f) = f else { continue };
        let better = best.as_ref().is_none_or(|(known, least)| match f.cmp(least) {
            Ordering::Equal => room(point) > room(known),
            order => order == Ordering::Less,
        });
        if better && counts(point) {
            best = Some((point.clone(), f));
        }
    }
    let (mut point, mut least) = best?;
    // Downhill in smaller and smaller steps.
    let ranges = ranges(domain);
    let directions = directions(ranges.len());
    let mut step = Rational::new(1, 16);
    let mut tries = 0;
    while tries < MAX_TRIES && relation.holds(&least) {
        let mut lower = None;
        for direction in &directions {
            let mut next = point.clone();
            for ((var, range), steps) in ranges.iter().zip(direction) {
                let width = range.finite().map_or(Rational::ONE, |(low, high)| high - low);
                next[var.0] += &(&(&step * &width) * &Rational::from(*steps));
            }
            tries += 1;
            let inside = ranges.iter().all(|(var, range)| range.contains(&next[var.0]));
            if !inside || !fits(domain, &next) || !counts(&next) {
                continue;
            }
            if let Some(Some(f)) = values(&value.numerator, &value.denominator, &[next.clone()])?.pop()
                && f < least
            {
                lower = Some((next, f));
                break;
            }
        }
        match lower {
            Some(better) => (point, least) = better,
            None if step.denom().bits() > 14 => break,
            None => step = &step * &Rational::new(1, 2),
        }
    }
    if relation.holds(&least) {
        return None;
    }
    let coordinates = ranges.mapped(|(var, _)| (*var, Coordinate::Rational(point[var.0].clone())));
    refute(&Rc::new(statement.clone()), &coordinates, work)
}

/// The ranges of all variables; of those of a simplex what surrounds it.
fn ranges(domain: &Domain) -> Vec<(Var, Range)> {
    let mut all = domain.region.ranges.clone();
    for simplex in &domain.simplices {
        let range = Range::closed(Rational::ZERO, simplex.sum.clone());
        all.extend(simplex.variables.iter().map(|var| (*var, range.clone())));
    }
    all
}

/// Whether the coordinates of a point on each simplex sum to no more than they may.
fn fits(domain: &Domain, point: &[Rational]) -> bool {
    domain.simplices.iter().all(|simplex| {
        let sum = simplex.variables.iter().fold(Rational::ZERO, |sum, var| &sum + &point[var.0]);
        sum <= simplex.sum
    })
}

/// Directions in which each variable changes by two steps at most; of many variables only two of them change.
fn directions(variables: usize) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for _ in 0..variables {
        let few = |direction: &Vec<i64>| variables <= 4 || direction.iter().filter(|k| **k != 0).count() <= 2;
        let longer = |rest: &Vec<i64>| (-2..=2).map(|k| [&[k], &rest[..]].concat()).filter(few).listed();
        all = all.iter().flat_map(longer).listed();
    }
    all
}

/// The values of a quotient at points; nothing where it has none. `None` for a quotient that is too long.
fn values(numer: &Poly, denom: &Poly, points: &[Vec<Rational>]) -> Option<Vec<Option<Rational>>> {
    if numer.len() + denom.len() > MAX_TERMS {
        return None;
    }
    let at = |point: &Vec<Rational>| match denom.as_constant() {
        Some(c) => numer.eval(point).checked_div(&c),
        None => numer.eval(point).checked_div(&denom.eval(point)),
    };
    Some(points.mapped(at))
}

/// The powers that all terms of a polynomial share of variables that are ≥ 0, and the even ones of others.
fn common(p: &Poly, domain: &Domain) -> Poly {
    let mut factor = Poly::one();
    for (var, range) in &ranges(domain) {
        let power = p.terms().map(|(m, _)| m.exponent(*var)).min().unwrap_or(0);
        let nonnegative = range.low.value().is_some_and(|x| !x.is_negative());
        let power = if nonnegative { power } else { power - power % 2 };
        factor = &factor * &Poly::var(*var).pow(u32::from(power));
    }
    factor
}

/// Points of a domain, by variable, its corners and many inside; a variable on which nothing depends has one value.
fn sample(value: &Quotient, domain: &Domain) -> Option<Vec<Vec<Rational>>> {
    let ranges = ranges(domain);
    let occurs = |var: &Var| {
        let premises = domain.premises.iter().map(|(g, _)| g);
        [&value.numerator, &value.denominator].into_iter().chain(premises).any(|p| p.depends_on(*var))
    };
    let count = ranges.iter().filter(|(var, _)| occurs(var)).count();
    let parts = [64_i64, 24, 8, 4, 2, 2].get(count.checked_sub(1)?)?;
    let width = ranges.iter().map(|(var, _)| var.0 + 1).max()?;
    let mut points = vec![vec![Rational::ZERO; width]];
    for (var, range) in &ranges {
        let on_simplex = domain.simplices.iter().any(|s| s.variables.contains(var));
        let idle = if on_simplex { Rational::ZERO } else { typical(range) };
        let own = if occurs(var) { coordinates(range, *parts) } else { vec![idle] };
        let mut next = Vec::new();
        for point in &points {
            for x in &own {
                let mut point = point.clone();
                point[var.0] = x.clone();
                // What is still to come is 0, or more.
                if fits(domain, &point) {
                    next.push(point);
                }
            }
        }
        points = next;
        if points.len() > MAX_POINTS {
            return None;
        }
    }
    Some(points)
}

/// Numbers of a range, in equal steps; of an infinite one small ones.
fn coordinates(range: &Range, parts: i64) -> Vec<Rational> {
    let all: Vec<Rational> = match (range.low.value(), range.high.value()) {
        (Some(low), Some(high)) => {
            (0..=parts).map(|k| low + &(&(high - low) * &Rational::new(k, parts))).listed()
        }
        (low, high) => {
            let (start, sign) = match (low, high) {
                (Some(low), _) => (low.clone(), 1),
                (_, Some(high)) => (high.clone(), -1),
                _ => (Rational::ZERO, 0),
            };
            let step = |k: i64| Rational::new(k, if parts > 8 { 4 } else { 1 });
            let (from, to) = if sign == 0 { (-parts / 2, parts / 2) } else { (0, parts) };
            (from..=to).map(|k| if sign < 0 { &start - &step(k) } else { &start + &step(k) }).listed()
        }
    };
    all.into_iter().filter(|x| range.contains(x)).listed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::range::Region;

    fn x() -> Poly {
        Poly::var(Var(0))
    }

    fn y() -> Poly {
        Poly::var(Var(1))
    }

    fn on_disk(f: &Poly, relation: Relation) -> Statement {
        let both = Range::closed(Rational::from(-1), Rational::ONE);
        let region = Region { ranges: vec![(Var(0), both.clone()), (Var(1), both)] };
        let disk = &(&Poly::one() - &x().pow(2)) - &y().pow(2);
        let domain = Domain { premises: vec![(disk, Relation::NonNegative)], ..Domain::of(region) };
        Statement::Sign { value: f.clone().into(), relation, domain: Rc::new(domain) }
    }

    fn proved(f: &Poly) -> bool {
        let statement = without(&on_disk(f, Relation::NonNegative)).expect("a multiple of the premise");
        basis_prover::decide(statement, &Vec::new(), 1).is_ok()
    }

    #[test]
    fn signs_on_a_disk() {
        let number = |n: i64, d: i64| Poly::constant(Rational::new(n, d));
        let sum = &x() + &y();
        assert!(proved(&(&number(2, 1) - &sum.pow(2))));
        assert!(proved(&(&number(3, 2) - &sum)));
        assert!(proved(&(&number(1, 1) - &(&x() * &y()).scale(&Rational::from(2)))));
        // √2 is a little less than 1.4143.
        assert!(proved(&(&number(1_415, 1_000) - &sum)));
    }

    #[test]
    fn what_is_false_is_refuted_inside() {
        let sum = &x() + &y();
        let f = &Poly::constant(Rational::new(13, 10)) - &sum;
        let statement = on_disk(&f, Relation::NonNegative);
        let found = counterexample(&statement, &mut Work::unlimited()).expect("a point");
        let at = |k: usize| match &found.point[k].1 {
            Coordinate::Rational(x) => x.clone(),
            Coordinate::Algebraic(_) => panic!("a rational point"),
        };
        assert!(&(&at(0) * &at(0)) + &(&at(1) * &at(1)) <= Rational::ONE);
        assert!(&at(0) + &at(1) > Rational::new(13, 10));
        // Outside of the disk only.
        let f = &Poly::constant(Rational::new(3, 2)) - &sum;
        assert!(counterexample(&on_disk(&f, Relation::NonNegative), &mut Work::unlimited()).is_none());
    }
}
