//! Dot products that are multiplied by one another: in coordinates along axes that belong to the points.
//!
//! **Theorem.** Vectors p₁, …, pₖ of any space have orthonormal axes along which p₁ = (x₁₁, 0, …), p₂ = (x₂₁, x₂₂, 0, …), …,
//! and no xᵢᵢ is negative. So an inequality between dot products holds for all vectors if and only if it holds with
//! pᵢ·pⱼ = x_{i1}x_{j1} + … + x_{ii}x_{ji}, i ≤ j, for all numbers x.
//!
//! *Proof.* The axes are those of Gram and Schmidt, each in the sense in which xᵢᵢ ≥ 0; where a vector depends on those
//! before it, any further axis will do. Conversely the rows of numbers are vectors.
//!
//! A value that is the same for p₁ − o, p₂ − o, … in place of p₁, p₂, …, where o is one of the points, is looked at for
//! o = 0 only.

use std::rc::Rc;

use basis_kernel::Domain;
use basis_prover::Coordinate;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort_unique;

use super::net::Net;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::theorem::Theorem;

/// More points have too many coordinates.
const MAX_POINTS: usize = 4;

/// The work for putting coordinates in.
const WORK: u64 = 2_000_000;

/// The coordinates of the points whose dot products occur in a value.
pub(super) struct Axes {
    /// The points that are not at the origin, in the order of their rows.
    points: Vec<usize>,
    /// The variable that is the first coordinate of the first point.
    first: usize,
}

impl Axes {
    /// For a value in which points are multiplied by other ones; `None` where none are, or they are too many.
    pub(super) fn of(theorem: &Theorem, value: &Fraction) -> Option<Self> {
        let occurring = theorem.products.iter().filter(|(var, _)| value.depends_on(*var));
        let pairs = occurring.map(|(_, pair)| *pair).listed();
        let mut points = pairs.iter().flat_map(|(p, q)| [*p, *q]).listed();
        sort_unique(&mut points);
        // One of them may be the origin.
        if pairs.iter().all(|(p, q)| p == q) || points.len() > MAX_POINTS + 1 {
            return None;
        }
        if let Some(origin) = points.iter().rposition(|o| is_moved(theorem, value, *o) == Some(true)) {
            points.remove(origin);
        }
        (points.len() <= MAX_POINTS).then_some(Self { points, first: theorem.names.len() })
    }

    /// The coordinate of a point along an axis that it has.
    const fn coordinate(&self, point: usize, axis: usize) -> Var {
        Var(self.first + point * (point + 1) / 2 + axis)
    }

    /// The value in coordinates; `None` where it has too many terms.
    pub(super) fn put(&self, theorem: &Theorem, value: &Fraction) -> Option<Fraction> {
        let work = &mut Work::new(WORK);
        let place = |point: usize| self.points.iter().position(|p| *p == point);
        let mut value = value.clone();
        for (var, (p, q)) in &theorem.products {
            if !value.depends_on(*var) {
                continue;
            }
            let product = match (place(*p), place(*q)) {
                (Some(i), Some(j)) => (0..=i.min(j)).fold(Poly::zero(), |sum, axis| {
                    let [x, y] = [i, j].map(|point| Poly::var(self.coordinate(point, axis)));
                    &sum + &(&x * &y)
                }),
                _ => Poly::zero(),
            };
            value = value.substitute_within(*var, &Fraction::from(product), work).ok()??;
        }
        Some(value)
    }

    /// The values of the scalars, and of the coordinates.
    pub(super) fn domain(&self, theorem: &Theorem) -> Rc<Domain> {
        let mut domain = (*theorem.scalar_domain()).clone();
        for k in 0..self.points.len() {
            let range = Range { low: End::Included(Rational::ZERO), high: End::Infinite };
            domain.region.ranges.push((self.coordinate(k, k), range));
        }
        Rc::new(domain)
    }

    /// The points that have these coordinates, the others at the origin; `None` where a coordinate is irrational.
    pub(super) fn net(&self, theorem: &Theorem, at: &[(Var, Coordinate)]) -> Option<Net> {
        let dimension = self.points.len().max(2);
        let mut places = theorem.points.mapped(|_| vec![Rational::ZERO; dimension]);
        for (k, point) in self.points.iter().enumerate() {
            for (axis, place) in places[*point].iter_mut().enumerate().take(k + 1) {
                let var = self.coordinate(k, axis);
                match at.iter().find(|(v, _)| *v == var) {
                    Some((_, Coordinate::Rational(x))) => *place = x.clone(),
                    Some(_) => return None,
                    None => {}
                }
            }
        }
        Net::given(theorem, &places).ok()
    }
}

/// Whether a value is the same when all points are moved so that one of them comes to the origin; `None` where this is
/// too much work.
fn is_moved(theorem: &Theorem, value: &Fraction, origin: usize) -> Option<bool> {
    let work = &mut Work::new(WORK);
    let count = theorem.names.len();
    // Dot products of the moved points are expressed by other variables than those that they replace.
    let product = |p: usize, q: usize| {
        let pair = (p.min(q), p.max(q));
        let (var, _) = theorem.products.iter().find(|(_, other)| *other == pair)?;
        Some(Poly::var(Var(var.0 + count)))
    };
    let mut moved = value.clone();
    let mut renamed = (0..count).map(Var).listed();
    for (var, (p, q)) in &theorem.products {
        renamed[var.0] = Var(var.0 + count);
        if !value.depends_on(*var) {
            continue;
        }
        let pairs = [(*p, *q), (origin, origin), (*p, origin), (*q, origin)];
        let [Some(pq), Some(oo), Some(po), Some(qo)] = pairs.map(|(p, q)| product(p, q)) else {
            return Some(false);
        };
        let product = &(&pq + &oo) - &(&po + &qo);
        moved = moved.substitute_within(*var, &Fraction::from(product), work).ok()??;
    }
    Some(moved.sub_within(&value.rename(&renamed), work)?.is_zero())
}
