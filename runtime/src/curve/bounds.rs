//! Extrema, inflections and the bounding box: zeros of polynomials that a curve defines.

use alloc::vec;
use alloc::vec::Vec;

use crate::bernstein::{self, Root, roots};
use crate::domain::from_unit;
use crate::vector::wedge;
use crate::{Basis, Curve, CurveError, Point, Scalar};

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The parameters inside of the domain at which a component has a maximum or minimum, in increasing order.
    ///
    /// For the extrema of one component ask [`component`](Self::component). None if a control point is infinite or NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let arch = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// assert_eq!(arch.extrema(), [0.5]);
    /// ```
    pub fn extrema(&self) -> Vec<B::Scalar> {
        let points = self.to_bernstein();
        let mut all: Vec<B::Scalar> = (0..P::DIM)
            .flat_map(|d| stationary(points.as_ref(), d))
            .filter(|root| root.crosses)
            .map(|root| from_unit(B::domain(), root.x))
            .collect();
        all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
        all.dedup();
        all
    }

    /// The smallest axis-parallel box around the curve, as its two extreme corners `[min, max]`, up to rounding errors.
    ///
    /// NaN in a component in which a control point is infinite or NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let arch = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// assert_eq!(arch.bounding_box(), [[0.0, 0.0], [4.0, 1.5]]);
    /// ```
    pub fn bounding_box(&self) -> [P; 2] {
        let points = self.to_bernstein();
        let sides = |d: usize| component_bounds(points.as_ref(), d);
        [P::from_components(|d| sides(d)[0]), P::from_components(|d| sides(d)[1])]
    }

    /// The parameters inside of the domain at which a curve in the plane changes from turning left to turning right or the
    /// other way round, in increasing order: where `x' y'' - y' x''` changes its sign.
    ///
    /// None on a straight line, and none if a control point is infinite or NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let wave = Bezier::from_points([[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]]);
    /// assert_eq!(wave.inflections()?, [0.5]);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if the points have not two components.
    pub fn inflections(&self) -> Result<Vec<B::Scalar>, CurveError> {
        if P::DIM != 2 {
            return Err(CurveError::Dimension { expected: 2, found: P::DIM });
        }
        let points = self.to_bernstein();
        let (mut first, mut second) = (points, points);
        let first = &*bernstein::differentiate(first.as_mut());
        let velocity = bernstein::differentiate(second.as_mut());
        let second = &*bernstein::differentiate(velocity);
        let mut turn = vec![B::Scalar::ZERO; (first.len() + second.len()).saturating_sub(1)];
        bernstein::bilinear(first, second, &mut turn, |a, b| wedge(a, b, 0, 1));
        // On a straight line only rounding errors are left, of the size of the products.
        let size =
            |points: &[P]| points.iter().fold(B::Scalar::ZERO, |a, &p| a.max(crate::vector::length(p)));
        let noise = B::Scalar::of(4.0) * B::Scalar::EPSILON * size(first) * size(second);
        if turn.iter().all(|c| c.abs() <= noise) {
            return Ok(Vec::new());
        }
        let changes = roots(&turn).into_iter().filter(|root| root.crosses);
        Ok(changes.map(|root| from_unit(B::domain(), root.x)).collect())
    }
}

/// Where the derivative of a component vanishes.
fn stationary<P: Point>(points: &[P], d: usize) -> Vec<Root<P::Scalar>> {
    let mut component: Vec<P::Scalar> = points.iter().map(|p| p.component(d)).collect();
    roots(bernstein::differentiate(&mut component))
}

/// The smallest and the largest value of a component.
fn component_bounds<P: Point>(points: &[P], d: usize) -> [P::Scalar; 2] {
    let component: Vec<P::Scalar> = points.iter().map(|p| p.component(d)).collect();
    if component.is_empty() || !component.iter().all(|c| c.is_finite()) {
        return [P::Scalar::NAN; 2];
    }
    let [first, last] = [component[0], component[component.len() - 1]];
    let ends = [first.min(last), first.max(last)];
    if bernstein::bounds(&component) == ends {
        return ends;
    }
    stationary(points, d).iter().fold(ends, |[min, max], root| {
        let value = bernstein::eval(&component, root.x);
        [min.min(value), max.max(value)]
    })
}
