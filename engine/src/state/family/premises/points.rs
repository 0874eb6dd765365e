//! Points of a box at which functions are looked at, and what they are there.

use basis_kernel::{Domain, Quotient};
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_by_key;
use basis_prover::typical;

use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;

/// Points at which functions are looked at, at most.
const MAX_POINTS: usize = 800;

/// More terms than this are not evaluated at that many points.
const MAX_TERMS: usize = 400;

/// A point, by variable, far inside of what premises leave of a box, among those at which a polynomial is looked at and is not 0 if
/// there are any.
pub(crate) fn inside(p: &Poly, domain: &Domain) -> Option<Vec<Rational>> {
    let room = |point: &Vec<Rational>| domain.premises.iter().map(|(g, _)| g.eval(point)).min();
    let points = sample(&p.clone().into(), domain)?.into_iter().filter(|point| counts(domain, point));
    points.max_by_key(|point| (!p.eval(point).is_zero(), room(point)))
}

/// Whether the premises hold at a point.
pub(super) fn counts(domain: &Domain, point: &[Rational]) -> bool {
    domain.premises.iter().all(|(g, relation)| relation.holds(&g.eval(point)))
}

/// The ranges of the variables that have one; of those of a simplex what surrounds it.
pub(super) fn ranges(domain: &Domain) -> Vec<(Var, Range)> {
    let mut all = domain.region.ranges.clone();
    for simplex in &domain.simplices {
        let range = Range::closed(Rational::ZERO, simplex.sum.clone());
        all.extend(simplex.variables.iter().map(|var| (*var, range.clone())));
    }
    all
}

/// The ranges of all variables: of those that may have any value, as coordinates of points may, the whole line.
pub(super) fn all_ranges(value: &Quotient, domain: &Domain) -> Vec<(Var, Range)> {
    let mut all = ranges(domain);
    let premises = domain.premises.iter().map(|(g, _)| g);
    for p in [&value.numerator, &value.denominator].into_iter().chain(premises) {
        for var in p.variables() {
            if all.iter().all(|(known, _)| *known != var) {
                all.push((var, Range { low: End::Infinite, high: End::Infinite }));
            }
        }
    }
    all
}

/// Whether the coordinates of a point on each simplex sum to no more than they may.
pub(super) fn fits(domain: &Domain, point: &[Rational]) -> bool {
    domain.simplices.iter().all(|simplex| {
        let sum = simplex.variables.iter().fold(Rational::ZERO, |sum, var| &sum + &point[var.0]);
        sum <= simplex.sum
    })
}

/// Directions in which each variable changes by two steps at most; of many variables only two of them change.
pub(super) fn directions(variables: usize) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for _ in 0..variables {
        let few = |direction: &Vec<i64>| variables <= 3 || direction.iter().filter(|k| **k != 0).count() <= 2;
        let longer = |rest: &Vec<i64>| (-2..=2).map(|k| [&[k], &rest[..]].concat()).filter(few).listed();
        all = all.iter().flat_map(longer).listed();
    }
    all
}

/// The values of a quotient at points; nothing where it has none. `None` for a quotient that is too long, and where no work is
/// left.
pub(super) fn values(numer: &Poly, denom: &Poly, points: &[Vec<Rational>]) -> Option<Vec<Option<Rational>>> {
    if numer.len() + denom.len() > MAX_TERMS {
        return None;
    }
    basis_prover::charge(8 * points.len() as u64);
    let (above, below) = basis_prover::charged(&mut || (on_grid(numer, points), on_grid(denom, points)))?;
    Some(above.into_iter().zip(&below).map(|(above, below)| above.checked_div(below)).listed())
}

/// The values of a polynomial at points of which neighbours share most coordinates: those are put in once.
fn on_grid(p: &Poly, points: &[Vec<Rational>]) -> Vec<Rational> {
    let mut variables = p.variables();
    // Those that change least often first.
    sort_by_key(&mut variables, |v| points.windows(2).filter(|pair| pair[0][v.0] != pair[1][v.0]).count());
    let mut all = Vec::new();
    put_in_order(p, &variables, points, &mut all);
    all
}

/// The values, with the variables put in one after the other.
fn put_in_order(p: &Poly, variables: &[Var], points: &[Vec<Rational>], all: &mut Vec<Rational>) {
    let Some((first, rest)) = variables.split_first() else {
        let value = p.as_constant().unwrap_or(Rational::ZERO);
        return all.extend(core::iter::repeat_n(value, points.len()));
    };
    for chunk in points.chunk_by(|a, b| a[first.0] == b[first.0]) {
        put_in_order(&p.at(*first, &chunk[0][first.0]), rest, chunk, all);
    }
}

/// Points of a domain, by variable, its corners and many inside; a variable on which nothing depends has one value.
pub(super) fn sample(value: &Quotient, domain: &Domain) -> Option<Vec<Vec<Rational>>> {
    let ranges = all_ranges(value, domain);
    let occurs = |var: &Var| {
        let premises = domain.premises.iter().map(|(g, _)| g);
        [&value.numerator, &value.denominator].into_iter().chain(premises).any(|p| p.depends_on(*var))
    };
    let count = ranges.iter().filter(|(var, _)| occurs(var)).count();
    let parts = [64_i64, 24, 8, 4, 2, 2, 1, 1, 1].get(count.checked_sub(1)?)?;
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
        basis_prover::charge((points.len() * (8 + width)) as u64);
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
            let at = |share: Rational| low + &(&(high - low) * &share);
            // Next to an end that is left out, too.
            let beside = [Rational::new(1, 1024), Rational::new(1023, 1024)];
            let all = (0..=parts).map(|k| Rational::new(k, parts));
            let left_out = [&range.low, &range.high].map(|end| !end.is_included());
            let extra = beside.into_iter().zip(left_out).filter_map(|(x, out)| out.then_some(x));
            all.chain(extra).map(at).listed()
        }
        (low, high) => {
            let (start, sign) = match (low, high) {
                (Some(low), _) => (low.clone(), 1),
                (_, Some(high)) => (high.clone(), -1),
                _ => (Rational::ZERO, 0),
            };
            let equal = |k: i64| Rational::new(k, if parts > 8 { 4 } else { 1 });
            // The first of many steps away from an end is a short one.
            let step = |k: i64| match k {
                1 if sign != 0 && parts >= 4 => Rational::new(1, 8),
                2.. if sign != 0 && parts >= 4 && k < parts => equal(k - 1),
                _ => equal(k),
            };
            let (from, to) = if sign == 0 { (-parts / 2, parts / 2) } else { (0, parts) };
            (from..=to).map(|k| if sign < 0 { &start - &step(k) } else { &start + &step(k) }).listed()
        }
    };
    all.into_iter().filter(|x| range.contains(x)).listed()
}
