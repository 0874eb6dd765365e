//! Parts of tensor surfaces: isocurves, boundary curves, Bézier patches, split.

use core::ops::Range;

use super::{Direction, TensorSurface};
use crate::basis::combination;
use crate::bernstein::restrict;
use crate::curve::{divisible, nonempty};
use crate::domain::unit;
use crate::{Array, Basis, BernsteinOf, BezierOf, Curve, CurveError, Point, Scalar};

/// A part of a tensor surface, as a Bézier patch of the same degrees on the unit square.
///
/// Families with shape parameters are not closed under subdivision; all of their surfaces are made of Bézier patches.
pub type BezierPatchOf<U, V, P> = TensorSurface<BernsteinOf<U>, BernsteinOf<V>, P>;

/// The net of a Bézier patch of the degrees of two families.
pub(crate) type BezierNet<U, V, P> = <BernsteinOf<U> as Basis>::Points<<BernsteinOf<V> as Basis>::Points<P>>;

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The curve `u ↦ S(u, v)`. It has the family of the surface in `u`.
    pub fn along_u(&self, v: P::Scalar) -> Curve<U, P> {
        Curve::new(self.u_basis(), U::Points::from_fn(|i| self.rows()[i].eval(v)))
    }

    /// The curve `v ↦ S(u, v)`, if it has the family of the surface in `v`: if all rows that count at `u` have the same
    /// shape values. [`along_v_bezier`](Self::along_v_bezier) gives it in any case.
    pub fn along_v(&self, u: P::Scalar) -> Option<Curve<V, P>> {
        let weights = self.u_basis().values(u);
        let rows = || {
            self.rows().iter().zip(weights.as_ref().iter().copied()).filter(|(_, w)| *w != P::Scalar::ZERO)
        };
        let basis = rows().next()?.0.basis();
        if rows().any(|(row, _)| row.basis() != basis) {
            return None;
        }
        let points = V::Points::from_fn(|j| combination(rows().map(|(row, w)| (row.control_points()[j], w))));
        Some(Curve::new(basis, points))
    }

    /// The curve `v ↦ S(u, v)` as a Bézier curve, on the unit interval.
    pub fn along_v_bezier(&self, u: P::Scalar) -> BezierOf<V, P> {
        let weights = self.u_basis().values(u);
        let rows = U::Points::<V::Bernstein<P>>::from_fn(|i| self.rows()[i].to_bernstein());
        let point = |j: usize| {
            combination(rows.as_ref().iter().map(|row| row.as_ref()[j]).zip(weights.as_ref().iter().copied()))
        };
        Curve::new(BernsteinOf::<V>::default(), <BernsteinOf<V> as Basis>::Points::from_fn(point))
    }

    /// The boundary curves at `v = lo` and `v = hi`, which run along `u`.
    ///
    /// For a family that interpolates its end points their control points are the first and the last column of the net.
    pub fn boundary_along_u(&self) -> [Curve<U, P>; 2] {
        V::domain().map(|v| self.along_u(v))
    }

    /// The boundary curves at `u = lo` and `u = hi`, which run along `v`; `None` as for
    /// [`along_v`](Self::along_v).
    ///
    /// For a family that interpolates its end points they are the first and the last row of the net, each with the
    /// shape values of that row.
    pub fn boundary_along_v(&self) -> [Option<Curve<V, P>>; 2] {
        U::domain().map(|u| self.along_v(u))
    }

    /// The same surface as a Bézier patch of the same degrees, on the unit square.
    #[must_use]
    pub fn to_bezier(&self) -> BezierPatchOf<U, V, P> {
        patch::<U, V, P>(self.bezier_net())
    }

    /// The parts below and above a parameter of one direction, each as a Bézier patch on the unit square. They share an
    /// edge exactly.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if the parameter is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of
    /// it, where one part would be a curve.
    pub fn split(
        &self,
        direction: Direction,
        at: P::Scalar,
    ) -> Result<[BezierPatchOf<U, V, P>; 2], CurveError> {
        let [mut before, mut after] = [self.bezier_net(); 2];
        match direction {
            Direction::U => {
                divisible(U::domain(), at)?;
                let [_, x] = unit(U::domain(), at);
                restrict_u::<U, V, P>(&mut before, P::Scalar::ZERO, x);
                restrict_u::<U, V, P>(&mut after, x, P::Scalar::ONE);
                after.as_mut()[0] = before.as_ref()[U::DEGREE];
            }
            Direction::V => {
                divisible(V::domain(), at)?;
                let [_, y] = unit(V::domain(), at);
                restrict_v::<U, V, P>(&mut before, P::Scalar::ZERO, y);
                restrict_v::<U, V, P>(&mut after, y, P::Scalar::ONE);
                for (before, after) in before.as_ref().iter().zip(after.as_mut()) {
                    after.as_mut()[0] = before.as_ref()[V::DEGREE];
                }
            }
        }
        Ok([patch::<U, V, P>(before), patch::<U, V, P>(after)])
    }

    /// The part over a rectangle of parameters, as a Bézier patch on the unit square; a range with `start > end` runs
    /// backwards.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of a range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends of one are equal.
    pub fn subpatch(
        &self,
        u: Range<P::Scalar>,
        v: Range<P::Scalar>,
    ) -> Result<BezierPatchOf<U, V, P>, CurveError> {
        nonempty(U::domain(), &u)?;
        nonempty(V::domain(), &v)?;
        let mut net = self.bezier_net();
        let [[_, u_from], [_, u_to]] = [u.start, u.end].map(|u| unit(U::domain(), u));
        let [[_, v_from], [_, v_to]] = [v.start, v.end].map(|v| unit(V::domain(), v));
        restrict_u::<U, V, P>(&mut net, u_from, u_to);
        restrict_v::<U, V, P>(&mut net, v_from, v_to);
        Ok(patch::<U, V, P>(net))
    }

    /// The same surface with one parameter running the other way, as a Bézier patch on the unit square; its normals
    /// turn to the other side.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> BezierPatchOf<U, V, P> {
        let mut net = self.bezier_net();
        match direction {
            Direction::U => net.as_mut().reverse(),
            Direction::V => net.as_mut().iter_mut().for_each(|row| row.as_mut().reverse()),
        }
        patch::<U, V, P>(net)
    }

    /// The control points of the surface as a Bézier patch.
    pub(crate) fn bezier_net(&self) -> BezierNet<U, V, P> {
        let rows = U::Points::<V::Bernstein<P>>::from_fn(|i| self.rows()[i].to_bernstein());
        let columns = V::Bernstein::<U::Bernstein<P>>::from_fn(|j| {
            self.u_basis().to_bernstein(&U::Points::from_fn(|i| rows.as_ref()[i].as_ref()[j]))
        });
        Array::from_fn(|i| Array::from_fn(|j| columns.as_ref()[j].as_ref()[i]))
    }
}

fn patch<U, V, P>(net: BezierNet<U, V, P>) -> BezierPatchOf<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    TensorSurface::new(BernsteinOf::<U>::default(), BernsteinOf::<V>::default(), net)
}

/// Replaces the patch by its part between two parameters in `u`.
pub(crate) fn restrict_u<U, V, P>(net: &mut BezierNet<U, V, P>, from: P::Scalar, to: P::Scalar)
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    for j in 0..=V::DEGREE {
        let mut column = U::Bernstein::<P>::from_fn(|i| net.as_ref()[i].as_ref()[j]);
        restrict(column.as_mut(), from, to);
        for (row, &point) in net.as_mut().iter_mut().zip(column.as_ref()) {
            row.as_mut()[j] = point;
        }
    }
}

/// Replaces the patch by its part between two parameters in `v`.
pub(crate) fn restrict_v<U, V, P>(net: &mut BezierNet<U, V, P>, from: P::Scalar, to: P::Scalar)
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    for row in net.as_mut() {
        restrict(row.as_mut(), from, to);
    }
}
