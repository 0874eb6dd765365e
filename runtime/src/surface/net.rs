//! The net of a Bézier patch of any degrees, for algorithms that subdivide.

use alloc::vec::Vec;

use super::TensorSurface;
use crate::bernstein::split;
use crate::{Basis, Point, Scalar};

/// The control points of a Bézier patch on the unit square, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Net<P> {
    points: Vec<P>,
    /// The number of points in a row, one more than the degree in `v`.
    columns: usize,
}

impl<P: Point> Net<P> {
    /// The patch with these control points, row by row.
    pub(crate) fn new(points: Vec<P>, columns: usize) -> Self {
        Self { points, columns }
    }

    /// The surface as a Bézier patch.
    pub(crate) fn of<U, V>(surface: &TensorSurface<U, V, P>) -> Self
    where
        U: Basis<Scalar = P::Scalar>,
        V: Basis<Scalar = P::Scalar>,
    {
        let mut points = Vec::with_capacity((U::DEGREE + 1) * (V::DEGREE + 1));
        for row in surface.bezier_net().as_ref() {
            points.extend_from_slice(row.as_ref());
        }
        Self { points, columns: V::DEGREE + 1 }
    }

    /// The net of the same shape over `of` of each pair of points.
    pub(crate) fn zip<Q: Copy, R>(&self, other: &Net<Q>, of: impl Fn(P, Q) -> R) -> Net<R> {
        let points = self.points.iter().zip(&other.points).map(|(&p, &q)| of(p, q)).collect();
        Net { points, columns: self.columns }
    }

    /// The net of the same shape over `of` of each point.
    pub(crate) fn map<Q>(&self, of: impl Fn(P) -> Q) -> Net<Q> {
        Net { points: self.points.iter().map(|&p| of(p)).collect(), columns: self.columns }
    }

    pub(crate) fn points(&self) -> &[P] {
        &self.points
    }

    fn rows(&self) -> usize {
        self.points.len() / self.columns
    }

    /// The four control points that are points of the patch.
    pub(crate) fn corners(&self) -> [P; 4] {
        let (columns, last) = (self.columns, self.points.len() - 1);
        [self.points[0], self.points[columns - 1], self.points[last + 1 - columns], self.points[last]]
    }

    /// Both halves in the direction in which neighbouring control points differ more.
    pub(crate) fn halves(&self) -> [Self; 2] {
        let size = |a: P, b: P| crate::vector::largest_component(a.minus(b));
        let mut steps = [P::Scalar::ZERO; 2];
        for (k, &point) in self.points.iter().enumerate() {
            if k >= self.columns {
                steps[0] = steps[0].max(size(point, self.points[k - self.columns]));
            }
            if k % self.columns > 0 {
                steps[1] = steps[1].max(size(point, self.points[k - 1]));
            }
        }
        if steps[0] >= steps[1] { self.halves_u() } else { self.halves_v() }
    }

    /// The halves `u <= 1/2` and `u >= 1/2`.
    pub(crate) fn halves_u(&self) -> [Self; 2] {
        let (mut left, mut right) = (self.clone(), self.clone());
        let mut before: Vec<P> = Vec::with_capacity(self.rows());
        let mut after = alloc::vec![P::zero(); self.rows()];
        for j in 0..self.columns {
            before.clear();
            before.extend(self.points.iter().skip(j).step_by(self.columns));
            split(&mut before, P::Scalar::of(0.5), &mut after);
            for (i, (&a, &b)) in before.iter().zip(&after).enumerate() {
                left.points[i * self.columns + j] = a;
                right.points[i * self.columns + j] = b;
            }
        }
        [left, right]
    }

    /// The halves `v <= 1/2` and `v >= 1/2`.
    pub(crate) fn halves_v(&self) -> [Self; 2] {
        let (mut left, mut right) = (self.clone(), self.clone());
        let rows = left.points.chunks_mut(self.columns).zip(right.points.chunks_mut(self.columns));
        for (before, after) in rows {
            split(before, P::Scalar::of(0.5), after);
        }
        [left, right]
    }
}
