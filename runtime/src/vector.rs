//! Lengths, products and directions of vectors, given as points.

use crate::{Array, Point, Scalar};

/// A point of three-dimensional space, where surfaces have normals.
///
/// Implemented for `[S; 3]`, with the features of glam for `Vec3`, `Vec3A` and `DVec3`, and with the features `nalgebra` and
/// `mint` for `Vector3` and `Point3`. A type of your own needs one line, and `DIM = 3`:
///
/// ```
/// use basis_runtime::{Point, Point3};
///
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Position([f32; 3]);
///
/// impl Point for Position {
///     type Scalar = f32;
///     type Vector = Self;
///     const DIM: usize = 3;
///     fn from_components(component: impl FnMut(usize) -> f32) -> Self {
///         Position(<[f32; 3]>::from_components(component))
///     }
///     fn component(&self, index: usize) -> f32 {
///         self.0[index]
///     }
/// }
/// impl Point3 for Position {}
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a point of three-dimensional space",
    note = "normals exist for points with three components, such as `[f64; 3]` or `glam::Vec3`"
)]
pub trait Point3: Point {}

impl<S: Scalar> Point3 for [S; 3] {}

#[cfg(feature = "nalgebra")]
mod nalgebra {
    use super::Scalar;

    impl<S: Scalar> super::Point3 for nalgebra::SVector<S, 3> {}
    impl<S: Scalar> super::Point3 for nalgebra::Point<S, 3> {}
}

/// The same components in another type: a point as the vector from the origin, or back.
#[inline]
pub(crate) fn recast<P: Point, Q: Point<Scalar = P::Scalar>>(point: P) -> Q {
    Q::from_components(|i| point.component(i))
}

/// `a - b` of coefficients, which are points in the beginning and vectors after that.
#[inline]
pub(crate) fn difference<P: Point>(a: P, b: P) -> P {
    P::from_vector(a.minus(b))
}

/// An array of points as one of vectors.
#[inline]
pub(crate) fn vectors<P: Point, A: Array<P::Vector>>(points: &[P]) -> A {
    A::from_fn(|i| points[i].to_vector())
}

/// The scalar product `Σ a_i b_i`.
#[inline]
pub(crate) fn dot<P: Point>(a: P, b: P) -> P::Scalar {
    (0..P::DIM).fold(P::Scalar::ZERO, |sum, i| sum + a.component(i) * b.component(i))
}

/// The vector product `a × b`.
#[inline]
pub(crate) fn cross<P: Point>(a: P, b: P) -> P {
    const { assert!(P::DIM == 3, "a type that implements Point3 has three components, and its vectors too") };
    P::from_components(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a.component(j) * b.component(k) - a.component(k) * b.component(j)
    })
}

/// The Euclidean length; infinite or NaN if a component is. Neither the square of a large component overflows nor that
/// of a small one vanishes.
#[inline]
pub(crate) fn length<P: Point>(vector: P) -> P::Scalar {
    let square = dot(vector, vector);
    if square > P::Scalar::MIN_POSITIVE / P::Scalar::EPSILON && square.is_finite() {
        return square.sqrt();
    }
    scaled_length(vector)
}

#[cold]
fn scaled_length<P: Point>(vector: P) -> P::Scalar {
    let largest = largest_component(vector);
    if largest == P::Scalar::ZERO || !largest.is_finite() {
        return largest;
    }
    let scaled = P::from_components(|i| vector.component(i) / largest);
    dot(scaled, scaled).sqrt() * largest
}

/// The vector of length one in that direction; `None` if the vector is zero, infinite or NaN.
#[inline]
pub(crate) fn direction<P: Point>(vector: P) -> Option<P> {
    let largest = largest_component(vector);
    if largest == P::Scalar::ZERO || !largest.is_finite() {
        return None;
    }
    // Divided, not multiplied by the inverse, which is infinite for a subnormal component.
    let scaled = P::from_components(|i| vector.component(i) / largest);
    let length = dot(scaled, scaled).sqrt();
    Some(P::from_components(|i| scaled.component(i) / length))
}

/// The unit vector of the part of `vector` that is perpendicular to a unit vector.
pub(crate) fn perpendicular<P: Point>(unit: P, vector: P) -> Option<P> {
    let vector = direction(vector)?;
    let part = direction(vector.add_weighted(unit, -dot(vector, unit)))?;
    // Once more: what rounding has left along the unit vector is large if the part was small.
    direction(part.add_weighted(unit, -dot(part, unit)))
}

/// A unit vector perpendicular to this one, from the axis that is farthest from it.
pub(crate) fn any_perpendicular<P: Point>(unit: P) -> P {
    let axis =
        (0..3).fold(0, |axis, d| if unit.component(d).abs() < unit.component(axis).abs() { d } else { axis });
    let axis = P::from_components(|d| if d == axis { P::Scalar::ONE } else { P::Scalar::ZERO });
    perpendicular(unit, axis).unwrap_or(axis)
}

/// The distance of two points, `|a - b|`.
#[inline]
pub(crate) fn distance<P: Point>(a: P, b: P) -> P::Scalar {
    length(a.minus(b))
}

/// The point `(1 - x) a + x b`.
#[inline]
pub(crate) fn lerp<P: Point>(a: P, b: P, x: P::Scalar) -> P {
    a.scale(P::Scalar::ONE - x).add_weighted(b, x)
}

/// The unit in which to measure things of that size: 1 if their power with the exponent `2^squarings` neither overflows
/// nor vanishes, with a margin of `ε²` on both sides, and otherwise their size. A scale of 1 leaves exact numbers
/// exact.
pub(crate) fn safe_unit<S: Scalar>(size: S, squarings: usize) -> S {
    let power = (0..squarings).fold(size, |power, _| power * power);
    let margin = S::EPSILON * S::EPSILON;
    let in_range = power * margin > S::MIN_POSITIVE && (power / margin).is_finite();
    if in_range || size == S::ZERO { S::ONE } else { size }
}

/// Whether all components are finite.
#[inline]
pub(crate) fn is_finite<P: Point>(point: P) -> bool {
    (0..P::DIM).all(|i| point.component(i).is_finite())
}

/// The smallest axis-parallel box around points, as its two extreme corners; NaN in a component in which a point is
/// NaN.
pub(crate) fn box_of<P: Point>(points: &[P]) -> [P; 2] {
    let extreme = |of: fn(P::Scalar, P::Scalar) -> P::Scalar| {
        P::from_components(|c| {
            let components = points.iter().map(|p| p.component(c));
            let extreme =
                components.reduce(|a, b| if a.is_nan() || b.is_nan() { P::Scalar::NAN } else { of(a, b) });
            extreme.unwrap_or(P::Scalar::NAN)
        })
    };
    [extreme(Scalar::min), extreme(Scalar::max)]
}

/// The component `a_i b_j - a_j b_i` of the exterior product.
#[inline]
pub(crate) fn wedge<P: Point>(a: P, b: P, i: usize, j: usize) -> P::Scalar {
    a.component(i) * b.component(j) - a.component(j) * b.component(i)
}

/// The largest absolute value of a component; NaN if one is NaN.
#[inline]
pub(crate) fn largest_component<P: Point>(vector: P) -> P::Scalar {
    (0..P::DIM).map(|i| vector.component(i).abs()).fold(P::Scalar::ZERO, |largest, component| {
        // Written so that NaN, once met, stays.
        if component <= largest || largest.is_nan() { largest } else { component }
    })
}

#[cfg(test)]
mod tests {
    use super::{cross, direction, dot, length, safe_unit};

    #[test]
    fn products() {
        assert_eq!(dot([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]), 12.0);
        assert_eq!(cross([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]), [27.0, 6.0, -13.0]);
    }

    #[test]
    fn lengths_of_any_size() {
        assert_eq!(length([3.0, -4.0]), 5.0);
        assert_eq!(length([3e300, -4e300]), 5e300);
        assert_eq!(length([3e-300, 4e-300]), 5e-300);
        assert_eq!(length([0.0_f32; 3]), 0.0);
        assert_eq!(length([f64::NEG_INFINITY, 1.0]), f64::INFINITY);
        assert!(length([1.0, f64::NAN, 2.0]).is_nan());
        assert!(length([f64::INFINITY, f64::NAN]).is_nan());
    }

    #[test]
    fn units_for_powers() {
        assert_eq!(safe_unit(1e30, 1), 1.0);
        assert_eq!(safe_unit(1e30, 3), 1.0);
        assert_eq!(safe_unit(1e40, 3), 1e40);
        assert_eq!(safe_unit(1e-40, 3), 1e-40);
        assert_eq!(safe_unit(1e300, 0), 1e300);
        assert_eq!(safe_unit(0.0_f32, 1), 1.0);
    }

    #[test]
    fn directions_of_any_size() {
        for size in [5e-324, 1e-300, 1.0, 1e300] {
            assert_eq!(direction([0.0, -size, 0.0]), Some([0.0, -1.0, 0.0]));
        }
        let smallest = f32::from_bits(1);
        assert_eq!(direction([3.0 * smallest, 4.0 * smallest]), direction([3.0_f32, 4.0]));
        assert_eq!(direction([0.0; 3]), None);
        assert_eq!(direction([f64::INFINITY, 0.0]), None);
        assert_eq!(direction([f64::NAN, 1.0]), None);
    }
}
