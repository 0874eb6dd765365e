//! Homogeneous points, over which a rational curve is a polynomial one.

use crate::bspline::SplineError;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{Point, Scalar};

/// The homogeneous point `(w P, w)` of a control point `P` with the weight `w`.
///
/// It is a [`Point`] with one component more, so everything that works on control points works on weighted ones too.
///
/// ```
/// use basis_runtime::bspline::Homogeneous;
///
/// let point = Homogeneous::new([1.0, 2.0], 0.5);
/// assert_eq!(point.scaled, [0.5, 1.0]);
/// assert_eq!(point.project(), [1.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct Homogeneous<P: Point> {
    /// The point times the weight.
    pub scaled: P,
    /// The weight.
    pub weight: P::Scalar,
}

impl<P: Point> Homogeneous<P> {
    /// The point `P` with the weight `w`.
    #[inline]
    pub fn new(point: P, weight: P::Scalar) -> Self {
        Self { scaled: point.scale(weight), weight }
    }

    /// The point itself: `scaled / weight`.
    #[inline]
    pub fn project(&self) -> P {
        P::from_components(|i| self.scaled.component(i) / self.weight)
    }
}

impl<P: Point> Point for Homogeneous<P> {
    type Scalar = P::Scalar;
    type Vector = Homogeneous<P::Vector>;
    const DIM: usize = P::DIM + 1;

    #[inline]
    fn from_components(mut component: impl FnMut(usize) -> P::Scalar) -> Self {
        let scaled = P::from_components(&mut component);
        Self { scaled, weight: component(P::DIM) }
    }

    #[inline]
    fn component(&self, index: usize) -> P::Scalar {
        if index == P::DIM { self.weight } else { self.scaled.component(index) }
    }

    #[inline]
    fn scale(self, factor: P::Scalar) -> Self {
        Self { scaled: self.scaled.scale(factor), weight: self.weight * factor }
    }

    #[inline]
    fn to_vector(self) -> Self::Vector {
        Homogeneous { scaled: self.scaled.to_vector(), weight: self.weight }
    }

    #[inline]
    fn from_vector(vector: Self::Vector) -> Self {
        Self { scaled: P::from_vector(vector.scaled), weight: vector.weight }
    }

    #[inline]
    fn minus(self, point: Self) -> Self::Vector {
        Homogeneous { scaled: self.scaled.minus(point.scaled), weight: self.weight - point.weight }
    }

    #[inline]
    fn add_weighted(self, point: Self, factor: P::Scalar) -> Self {
        Self {
            scaled: self.scaled.add_weighted(point.scaled, factor),
            weight: self.weight.add_weighted(point.weight, factor),
        }
    }
}

/// All weights if each is a positive finite number and there are `expected` of them.
pub(super) fn check_weights<S: Scalar>(weights: &[S], expected: usize) -> Result<(), SplineError> {
    if weights.len() != expected {
        return Err(SplineError::Weights { expected, found: weights.len() });
    }
    match weights.iter().position(|&weight| weight <= S::ZERO || !weight.is_finite()) {
        Some(index) => Err(SplineError::Weight { index, weight: weights[index].to_f64() }),
        None => Ok(()),
    }
}
