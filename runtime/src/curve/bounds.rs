//! Extrema, inflections and the bounding box: zeros of polynomials that a curve defines.

use alloc::vec;
use alloc::vec::Vec;

use crate::bernstein::{self, Root, RootKind, roots};
use crate::domain::from_unit;
use crate::vector::{largest_component, length, safe_unit, wedge};
use crate::{Basis, Curve, CurveError, Point, Scalar};

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The parameters inside of the domain at which a component has a maximum or minimum, in increasing order.
    ///
    /// For the extrema of one component ask [`component`](Self::component). A component that is constant up to rounding
    /// errors has none. None if a control point is infinite or NaN.
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
            .filter(|&d| !is_constant(points.as_ref(), d))
            .flat_map(|d| stationary(points.as_ref(), d))
            .filter(|root| root.kind == RootKind::Crossing)
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

    /// The parameters inside of the domain at which a curve in the plane changes from turning left to turning right or
    /// the other way round, in increasing order: where `x' y'' - y' x''` changes its sign.
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
        let mut points = self.to_bernstein();
        let mut largest = points.as_ref().iter().fold(B::Scalar::ZERO, |a, &p| a.max(largest_component(p)));
        // The scale does not matter; products of differences are formed.
        let unit = safe_unit(largest, 2);
        if unit != B::Scalar::ONE {
            for p in points.as_mut() {
                *p = P::from_components(|d| p.component(d) / unit);
            }
            largest = B::Scalar::ONE;
        }
        let (mut first, mut second) = (points, points);
        let first = &*bernstein::differentiate(first.as_mut());
        let velocity = bernstein::differentiate(second.as_mut());
        let second = &*bernstein::differentiate(velocity);
        let mut turn = vec![B::Scalar::ZERO; (first.len() + second.len()).saturating_sub(1)];
        bernstein::bilinear(first, second, &mut turn, |a, b| wedge(a, b, 0, 1));
        // On a straight line only the rounding errors of the points are left, in both factors.
        let noise = |order: usize| difference_noise::<B::Scalar>(B::DEGREE, order) * largest;
        let size = |points: &[P]| points.iter().fold(B::Scalar::ZERO, |a, &p| a.max(length(p)));
        let noise = size(first) * noise(2) + size(second) * noise(1);
        if turn.iter().all(|c| c.abs() <= noise) {
            return Ok(Vec::new());
        }
        let changes = roots(&turn).into_iter().filter(|root| root.kind == RootKind::Crossing);
        Ok(changes.map(|root| from_unit(B::domain(), root.x)).collect())
    }
}

/// Where the derivative of a component vanishes.
fn stationary<P: Point>(points: &[P], d: usize) -> Vec<Root<P::Scalar>> {
    let component = points.iter().map(|p| p.component(d));
    // So that differences do not overflow.
    let unit = safe_unit(component.clone().fold(P::Scalar::ZERO, |a, c| a.max(c.abs())), 0);
    let mut component: Vec<P::Scalar> = component.map(|c| c / unit).collect();
    roots(bernstein::differentiate(&mut component))
}

/// Whether the control points differ in a component by rounding errors only.
fn is_constant<P: Point>(points: &[P], d: usize) -> bool {
    let components = points.iter().map(|p| p.component(d));
    let largest = components.clone().fold(P::Scalar::ZERO, |a, c| a.max(c.abs()));
    let noise = difference_noise::<P::Scalar>(1, 1) * largest;
    points.windows(2).all(|pair| (pair[1].component(d) - pair[0].component(d)).abs() <= noise)
}

/// What rounding errors of the control points of a curve of that degree leave of the control points of a derivative of
/// that order, in units of the largest control point.
fn difference_noise<S: Scalar>(degree: usize, order: usize) -> S {
    let rounding = S::of(4.0) * S::EPSILON;
    (0..order.min(degree)).fold(rounding, |noise, k| noise * S::from_usize(2 * (degree - k)))
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
