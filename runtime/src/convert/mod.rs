//! Curves of other crates: their points as control points, and their curves where the degree allows.

#[cfg(feature = "kurbo")]
mod kurbo;
#[cfg(feature = "lyon_geom")]
mod lyon_geom;

use crate::numeric::binomial::row;
use crate::{Basis, Curve, CurveError, Point, Scalar, bernstein};

/// A point of the plane, as other crates take it.
type Pair<S> = (S, S);

/// The `N` Bézier control points in the plane of a curve of a degree below `N`, elevated if need be. The degree is that
/// of the curve, which can be lower than that of its family: the quartic family has the cubic curves at λ = 0.
fn planar<B, P, const N: usize>(curve: &Curve<B, P>) -> Result<[Pair<B::Scalar>; N], CurveError>
where
    B: Basis,
    P: Point<Scalar = B::Scalar>,
{
    if P::DIM != 2 {
        return Err(CurveError::Dimension { expected: 2, found: P::DIM });
    }
    let mut bernstein = curve.to_bernstein();
    let mut rest = bernstein.as_mut();
    while rest.len() > N {
        let degree = rest.len() - 1;
        rest = reduce(rest).ok_or(CurveError::Degree { most: N - 1, found: degree })?;
    }
    let mut points = [P::zero(); N];
    bernstein::elevate(rest, &mut points);
    Ok(points.map(|p| (p.component(0), p.component(1))))
}

/// Replaces the control points by those of the same polynomial with one less, and returns them, if its degree is that
/// low up to rounding errors: if the highest difference vanishes. The first and the last one stay.
fn reduce<P: Point>(points: &mut [P]) -> Option<&mut [P]> {
    let degree = points.len().checked_sub(1).filter(|&degree| degree > 0)?;
    let (mut difference, mut largest) = (P::zero(), P::Scalar::ZERO);
    for ((k, &point), binomial) in points.iter().enumerate().zip(row(degree)) {
        let sign = if (degree - k) % 2 == 0 { 1.0 } else { -1.0 };
        difference = difference.add_weighted(point, P::Scalar::of(sign * binomial));
        largest = (0..P::DIM).fold(largest, |largest, d| largest.max(point.component(d).abs()));
    }
    // Each product has a binomial coefficient as a factor; their sum is 2ⁿ, of n + 1 products.
    let sum = (0..degree).fold((degree + 1) as f64, |sum, _| 2.0 * sum);
    let noise = largest * P::Scalar::EPSILON * P::Scalar::of(sum);
    if !noise.is_finite() || !(0..P::DIM).all(|d| difference.component(d).abs() <= noise) {
        return None;
    }
    // n p[i] = i q[i-1] + (n - i) q[i], from both ends to the middle.
    let n = P::Scalar::from_usize(degree);
    let (last, middle) = (points[degree], degree.div_ceil(2));
    for i in 1..middle {
        let [before, rest] = [i, degree - i].map(P::Scalar::from_usize);
        points[i] = points[i].scale(n / rest).add_weighted(points[i - 1], P::Scalar::ZERO - before / rest);
    }
    let mut after = last;
    for i in (middle..degree).rev() {
        let [before, rest] = [i, degree - i].map(P::Scalar::from_usize);
        let point = points[i].scale(n / before).add_weighted(after, P::Scalar::ZERO - rest / before);
        (points[i], after) = (after, point);
    }
    Some(&mut points[..degree])
}
