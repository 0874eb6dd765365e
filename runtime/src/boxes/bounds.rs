//! Boxes around patches on boxes.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

use super::{BoxBasis, BoxPatch};
use crate::Point;
#[cfg(feature = "alloc")]
use crate::Scalar;

impl<B: BoxBasis, P: Point<Scalar = B::Scalar>> BoxPatch<B, P> {
    /// The smallest axis-parallel box around the Bernstein points, as its two extreme corners: cheap, and never too
    /// small up to rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        crate::vector::box_of(self.to_bernstein().as_ref())
    }

    /// The smallest axis-parallel box around the patch, as its two extreme corners, up to rounding errors.
    ///
    /// Found by subdivision, as [`TensorSurface::bounding_box`](crate::TensorSurface::bounding_box), with the same
    /// promises.
    ///
    /// ```
    /// use basis_runtime::{BoxPatch, basis};
    ///
    /// basis! {
    ///     family Sheet {
    ///         domain 0 <= u <= 2, 0 <= v <= 1;
    ///         b[0] = u*(2 - u)*(1 - v);
    ///         b[1] = 1 - b[0];
    ///     }
    /// }
    /// # fn main() {
    /// let heights = BoxPatch::new(Sheet::new(), [3.0, 1.0]);
    /// assert_eq!(heights.control_box(), [1.0, 5.0]);
    /// assert_eq!(heights.bounding_box(), [1.0, 3.0]); // at u = 1, v = 0
    /// # }
    /// ```
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        let net = self.to_bernstein();
        let side = |sign: B::Scalar, c: usize| {
            sign * largest(B::DEGREES, net.as_ref().iter().map(|p| sign * p.component(c)).collect())
        };
        [P::from_components(|c| side(-B::Scalar::ONE, c)), P::from_components(|c| side(B::Scalar::ONE, c))]
    }
}

/// The number of parts that are looked at together.
#[cfg(feature = "alloc")]
const PARTS: usize = 1000;

/// The number of halvings after which a part is a point; the smallest numbers stay apart for ever.
#[cfg(feature = "alloc")]
const ROUNDS: usize = 256;

/// The largest value of a function on the unit cube, from its Bernstein coefficients, the last index fastest.
#[cfg(feature = "alloc")]
fn largest<S: Scalar>(degrees: &[usize], coefficients: Vec<S>) -> S {
    if !coefficients.iter().all(|c| c.is_finite()) {
        return S::NAN;
    }
    let size = coefficients.iter().fold(S::ZERO, |size, c| size.max(c.abs()));
    let noise = S::of(4.0) * S::EPSILON * size;
    let above = |part: &Vec<S>| part.iter().fold(-S::INFINITY, |a, &b| a.max(b));
    let mut best = -S::INFINITY;
    let mut parts = alloc::vec![coefficients];
    // Every round halves what may hold a larger value; a part of the size of the noise holds none.
    for round in 0.. {
        best = parts.iter().map(|part| largest_corner(degrees, part)).fold(best, S::max);
        parts.retain(|part| above(part) > best + noise);
        if parts.is_empty() || parts.len() > PARTS || round > ROUNDS {
            return parts.iter().map(above).fold(best, S::max);
        }
        parts = parts.iter().flat_map(|part| halves(degrees, part)).collect();
    }
    best
}

/// How far apart the neighbours along an axis are among the coefficients.
#[cfg(feature = "alloc")]
fn stride(degrees: &[usize], axis: usize) -> usize {
    degrees[axis + 1..].iter().map(|degree| degree + 1).product()
}

/// The largest coefficient that is a value at a corner.
#[cfg(feature = "alloc")]
fn largest_corner<S: Scalar>(degrees: &[usize], part: &[S]) -> S {
    let is_corner = |place: usize| {
        (0..degrees.len()).all(|axis| {
            let index = place / stride(degrees, axis) % (degrees[axis] + 1);
            index == 0 || index == degrees[axis]
        })
    };
    let corners = part.iter().enumerate().filter(|&(place, _)| is_corner(place));
    corners.fold(-S::INFINITY, |largest, (_, &c)| largest.max(c))
}

/// Both halves along the axis in which neighbouring coefficients differ most, by de Casteljau's algorithm.
#[cfg(feature = "alloc")]
fn halves<S: Scalar>(degrees: &[usize], part: &[S]) -> [Vec<S>; 2] {
    let step = |axis: usize| {
        let stride = stride(degrees, axis);
        let has_next = |place: &usize| place / stride % (degrees[axis] + 1) < degrees[axis];
        (0..part.len()).filter(has_next).fold(S::ZERO, |a, k| a.max((part[k + stride] - part[k]).abs()))
    };
    let steeper = |a: usize, b: usize| if step(b) > step(a) { b } else { a };
    let axis = (0..degrees.len()).reduce(steeper).unwrap_or(0);
    let (stride, degree) = (stride(degrees, axis), degrees[axis]);
    let (mut lower, mut upper) = (part.to_vec(), part.to_vec());
    for first in (0..part.len()).filter(|place| place / stride % (degree + 1) == 0) {
        for m in 1..=degree {
            for i in 0..=degree - m {
                let (here, next) = (first + i * stride, first + (i + 1) * stride);
                upper[here] = (upper[here] + upper[next]) * S::of(0.5);
            }
            lower[first + m * stride] = upper[first];
        }
    }
    [lower, upper]
}
