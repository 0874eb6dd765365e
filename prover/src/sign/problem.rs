//! A polynomial with the ranges of its variables: what the methods of the cascade work on.

use crate::algebra::bernstein::Side;
use crate::algebra::poly::{Poly, PolyExt, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_between;
use crate::algebra::work::Work;
use crate::collections::list::Listed;
use crate::coordinate::Coordinate;

/// A point by coordinates.
pub(crate) type Point = Vec<(Var, Coordinate)>;

/// A polynomial and the ranges of exactly the variables that occur, none of them empty or a single number.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    pub(crate) poly: Poly,
    pub(crate) ranges: Vec<(Var, Range)>,
}

impl Problem {
    /// The polynomial on a box without empty ranges; single numbers are put in place of their variables.
    pub(crate) fn new(poly: &Poly, region: &Region) -> Self {
        let mut poly = poly.clone();
        for (var, range) in &region.ranges {
            if let Some((a, b)) = range.finite()
                && a == b
            {
                poly = poly.at(*var, a);
            }
        }
        let ranges = poly.variables().into_iter().map(|v| (v, region.range(v))).listed();
        Self { poly, ranges }
    }

    /// Another polynomial on the same ranges.
    pub(crate) fn with(&self, poly: Poly) -> Self {
        let ranges = self.ranges.iter().filter(|(v, _)| poly.depends_on(*v)).cloned().listed();
        Self { poly, ranges }
    }

    /// With a number in place of a variable.
    pub(crate) fn fix(&self, var: Var, value: &Rational) -> Self {
        self.with(self.poly.at(var, value))
    }

    /// The range of a variable that occurs.
    pub(crate) fn range(&self, var: Var) -> Range {
        self.ranges.iter().find(|(v, _)| *v == var).map_or(Range::all(), |(_, r)| r.clone())
    }

    /// Whether a rational point lies in the ranges; missing coordinates do.
    pub(crate) fn contains(&self, point: &[(Var, Rational)]) -> bool {
        point.iter().all(|(v, x)| self.range(*v).contains(x))
    }

    /// The value at a rational point.
    pub(crate) fn value(&self, point: &[(Var, Rational)]) -> Rational {
        value(&self.poly, point)
    }

    /// Counts the work of the value at a point whose coordinates have `bits` bits each.
    pub(crate) fn spend_value(&self, bits: u64, work: &mut Work) -> Option<()> {
        let words = 1 + (self.poly.max_bits() + u64::from(self.poly.total_degree()) * bits) / 64;
        work.spend(20 + self.poly.len() as u64 * (1 + self.ranges.len() as u64) * 5 * words)
    }

    /// Adds simple coordinates for the variables that a point lacks.
    pub(crate) fn complete(&self, mut point: Point) -> Point {
        for (v, r) in &self.ranges {
            if !point.iter().any(|(w, _)| w == v) {
                point.push((*v, Coordinate::Rational(simple(r))));
            }
        }
        point
    }

    /// A point of the interior of the ranges at which a polynomial in the same variables is not zero; `None` for the
    /// zero polynomial.
    pub(crate) fn nonzero_point(&self, poly: &Poly) -> Option<Vec<(Var, Rational)>> {
        let mut rest = poly.clone();
        let mut point = Vec::new();
        for (var, range) in &self.ranges {
            let count = rest.degree(*var) as usize + 1;
            let value = inner(range, count).into_iter().find(|x| !rest.at(*var, x).is_zero())?;
            rest = rest.at(*var, &value);
            point.push((*var, value));
        }
        Some(point)
    }
}

/// The value of a polynomial at a rational point; missing coordinates must not occur.
pub(crate) fn value(poly: &Poly, point: &[(Var, Rational)]) -> Rational {
    let len = point.iter().map(|(v, _)| v.0 + 1).max().unwrap_or(0);
    let mut all = vec![Rational::ZERO; len];
    for (v, x) in point {
        all[v.0] = x.clone();
    }
    poly.eval(&all)
}

/// A rational point as a point.
pub(crate) fn rational(point: Vec<(Var, Rational)>) -> Point {
    point.into_iter().map(|(v, x)| (v, Coordinate::Rational(x))).listed()
}

/// The coordinates of a point, if all are rational.
pub(crate) fn as_rational(point: &Point) -> Option<Vec<(Var, Rational)>> {
    point
        .iter()
        .map(|(v, c)| match c {
            Coordinate::Rational(x) => Some((*v, x.clone())),
            Coordinate::Algebraic(_) => None,
        })
        .collect()
}

/// A simple number of a range that is not empty, an inner one if there is any.
pub(crate) fn simple(range: &Range) -> Rational {
    simplest_between(range.low.value(), range.high.value())
}

/// Different simple numbers strictly inside a range that is not a single number.
pub(crate) fn inner(range: &Range, count: usize) -> Vec<Rational> {
    let mut list = vec![simple(range)];
    let parts = count as i64 + 1;
    for k in 1..=parts {
        let x = match (range.low.value(), range.high.value()) {
            (Some(a), Some(b)) => a + &(&(b - a) * &Rational::new(k, parts + 1)),
            (Some(a), None) => a + &Rational::from(k),
            (None, Some(b)) => b - &Rational::from(k),
            (None, None) => Rational::from(k),
        };
        if !list.contains(&x) {
            list.push(x);
        }
    }
    list
}

/// The range without its ends.
pub fn open(range: &Range) -> Range {
    let open = |end: &End| end.value().map_or(End::Infinite, |v| End::Excluded(v.clone()));
    Range { low: open(&range.low), high: open(&range.high) }
}

/// The end s = 0 or s = 1 of a side, if it is finite.
pub(crate) const fn end(side: &Side, high: bool) -> Option<&Rational> {
    match (side, high) {
        (Side::Finite(a, _) | Side::Upwards(a), false) => Some(a),
        (Side::Finite(_, b) | Side::Downwards(b), true) => Some(b),
        _ => None,
    }
}

/// A range with at least one end as a side of a box.
pub(crate) fn side(range: &Range) -> Option<Side> {
    match (range.low.value(), range.high.value()) {
        (Some(a), Some(b)) => Some(Side::Finite(a.clone(), b.clone())),
        (Some(a), None) => Some(Side::Upwards(a.clone())),
        (None, Some(b)) => Some(Side::Downwards(b.clone())),
        (None, None) => None,
    }
}
