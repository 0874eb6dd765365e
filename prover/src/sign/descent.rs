//! Counterexamples near a minimum: Newton's method in exact numbers, rounded after each step.

use basis_kernel::Relation;

use super::problem::{Problem, simple};
use super::witness::violates;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_by;

/// The number of points from which the method starts.
const STARTS: usize = 3;
/// The most steps from each: towards a zero of order 4 the value falls by a factor of 5 with each step.
const STEPS: u32 = 90;
/// How often a step is halved until the value falls.
const HALVINGS: u32 = 6;

/// A rational point at which the claim fails, found by walking downhill; `None` when none is found, and that says
/// nothing.
pub(super) fn downhill(
    problem: &Problem,
    relation: Relation,
    budget: &mut Budget,
) -> Option<Vec<(Var, Rational)>> {
    let work = &mut budget.work;
    let walk = Walk::new(problem, work)?;
    for mut point in walk.starts(work)? {
        let mut value = walk.value(&problem.poly, &point, work)?;
        for step in 0..STEPS {
            let at: Vec<(Var, Rational)> =
                problem.ranges.iter().zip(&point).map(|((v, _), x)| (*v, x.clone())).listed();
            if violates(problem, relation, &at) {
                return Some(at);
            }
            // The distance from a zero of order 4 falls by a third.
            let Some((next, lower)) = walk.step(&point, &value, 16 + 3 * step / 4, work) else { break };
            // Near a positive minimum nothing is to be found.
            let slow = &lower * &Rational::from(20) > &value * &Rational::from(19);
            (point, value) = (next, lower);
            if slow && step > 8 {
                break;
            }
        }
    }
    None
}

/// A polynomial with its first and second derivatives.
struct Walk<'p> {
    problem: &'p Problem,
    slopes: Vec<Poly>,
    curvatures: Vec<Vec<Poly>>,
}

impl<'p> Walk<'p> {
    fn new(problem: &'p Problem, work: &mut Work) -> Option<Self> {
        let n = problem.ranges.len() as u64;
        work.spend(n * n * problem.poly.len() as u64)?;
        let derivatives = |p: &Poly| problem.ranges.mapped(|(v, _)| p.derivative(*v));
        let slopes = derivatives(&problem.poly);
        let curvatures = slopes.mapped(derivatives);
        Some(Self { problem, slopes, curvatures })
    }

    /// The value of a polynomial in the same variables.
    fn value(&self, p: &Poly, point: &[Rational], work: &mut Work) -> Option<Rational> {
        let mut rest = p.clone();
        for ((var, _), x) in self.problem.ranges.iter().zip(point) {
            work.spend_at(&rest, *var, x)?;
            rest = rest.at(*var, x);
        }
        rest.as_constant()
    }

    /// The lowest of some points that are spread over the box.
    fn starts(&self, work: &mut Work) -> Option<Vec<Vec<Rational>>> {
        let lists = self.problem.ranges.mapped(|(_, range)| spread(range));
        let mut points: Vec<Vec<Rational>> = vec![Vec::new()];
        for list in &lists {
            let mut longer = Vec::new();
            for point in &points {
                longer.extend(list.iter().map(|x| [&point[..], core::slice::from_ref(x)].concat()));
            }
            points = longer;
            points.truncate(243);
        }
        let mut valued = Vec::new();
        for point in points {
            valued.push((self.value(&self.problem.poly, &point, work)?, point));
        }
        sort_by(&mut valued, |a, b| a.0.cmp(&b.0));
        valued.truncate(STARTS);
        Some(valued.into_iter().map(|(_, point)| point).listed())
    }

    /// A lower point whose coordinates are multiples of 2^−bits, and its value; `None` when Newton's
    /// direction has none, or the work is spent.
    fn step(
        &self,
        point: &[Rational],
        value: &Rational,
        bits: u32,
        work: &mut Work,
    ) -> Option<(Vec<Rational>, Rational)> {
        let mut system: Vec<Vec<Rational>> = Vec::new();
        for (slope, row) in self.slopes.iter().zip(&self.curvatures) {
            // The matrix is symmetric.
            let mut numbers: Vec<Rational> = system.iter().map(|r| r[system.len()].clone()).listed();
            for p in &row[system.len()..] {
                numbers.push(shortened(&self.value(p, point, work)?));
            }
            numbers.push(-shortened(&self.value(slope, point, work)?));
            system.push(numbers);
        }
        let gradient: Vec<Rational> = system.iter().filter_map(|row| row.last()).map(|x| -x).listed();
        let mut direction = solved(system, work)?;
        let rise = gradient.iter().zip(&direction).fold(Rational::ZERO, |sum, (g, d)| &sum + &(g * d));
        if !rise.is_negative() {
            direction = direction.mapped(|x| -x);
        }
        let unit = Rational::from(2).pow(bits);
        for _ in 0..HALVINGS {
            let next: Vec<Rational> = (self.problem.ranges.iter().zip(point).zip(&direction))
                .map(|(((_, range), x), d)| clamped(range, &rounded(&(x + d), &unit), x))
                .listed();
            let lower = self.value(&self.problem.poly, &next, work)?;
            if lower < *value {
                return Some((next, lower));
            }
            direction = direction.mapped(|x| x * &Rational::new(1, 2));
        }
        None
    }
}

/// Three numbers of a range.
fn spread(range: &Range) -> Vec<Rational> {
    match range.finite() {
        Some((a, b)) => {
            [(1, 6), (1, 2), (5, 6)].map(|(n, d)| a + &(&(b - a) * &Rational::new(n, d))).to_vec()
        }
        None => {
            let middle = simple(range);
            [-1, 0, 1].map(|k| clamped(range, &(&middle + &Rational::from(k)), &middle)).to_vec()
        }
    }
}

/// The multiple of 1/unit below a number.
fn rounded(x: &Rational, unit: &Rational) -> Rational {
    &(x * unit).floor() / unit
}

/// The number with its first 64 bits: a direction need not be exact.
fn shortened(x: &Rational) -> Rational {
    let size = x.numer().bits() as i32 - x.denom().bits() as i32;
    let power = Rational::from(2).pow((64 - size).unsigned_abs());
    if size > 64 { &rounded(&(x / &power), &Rational::ONE) * &power } else { rounded(x, &power) }
}

/// The number, or if it lies outside of the range one between an inner number and the end.
fn clamped(range: &Range, x: &Rational, inner: &Rational) -> Rational {
    let ends = [&range.low, &range.high];
    let beyond = [range.low.value().is_some_and(|a| x <= a), range.high.value().is_some_and(|b| x >= b)];
    for (end, beyond) in ends.into_iter().zip(beyond) {
        if let (true, Some(limit)) = (beyond, end.value()) {
            let middle = &(limit + inner) * &Rational::new(1, 2);
            return if end.is_included() { limit.clone() } else { middle };
        }
    }
    x.clone()
}

/// The solution of linear equations, each with its right side last; `None` when it is not unique, or the work is spent.
fn solved(mut rows: Vec<Vec<Rational>>, work: &mut Work) -> Option<Vec<Rational>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).find(|i| !rows[*i][k].is_zero())?;
        rows.swap(k, pivot);
        let top = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i == k || row[k].is_zero() {
                continue;
            }
            let factor = &row[k] / &top[k];
            for (x, p) in row.iter_mut().zip(&top).skip(k) {
                work.spend_fractions(x.bits() + p.bits() + factor.bits())?;
                *x -= &(&factor * p);
            }
        }
    }
    Some((0..n).map(|k| &rows[k][n] / &rows[k][k]).listed())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shortened() {
        for x in
            [Rational::new(1, 3).pow(90), Rational::new(-7, 3), Rational::from(7).pow(90), Rational::ZERO]
        {
            let error = &shortened(&x) - &x;
            assert!(error.abs() <= &x.abs() * &Rational::new(1, 1 << 62), "{x}");
            assert!(shortened(&x).numer().bits() < 400, "{x}");
        }
    }

    #[test]
    fn equations_are_solved() {
        let n = |x: i64| Rational::from(x);
        let work = &mut Work::unlimited();
        let rows = vec![vec![n(0), n(2), n(4)], vec![n(3), n(1), n(5)]];
        assert_eq!(solved(rows, work), Some(vec![n(1), n(2)]));
        assert_eq!(solved(vec![vec![n(1), n(2), n(0)], vec![n(2), n(4), n(1)]], work), None);
    }
}
