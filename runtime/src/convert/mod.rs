//! Curves of other crates: their points as control points, and their curves where the degree allows.

#[cfg(feature = "kurbo")]
mod kurbo;
#[cfg(feature = "lyon_geom")]
mod lyon_geom;

use crate::{Basis, Curve, CurveError, Point, bernstein};

/// A point of the plane, as other crates take it.
type Pair<S> = (S, S);

/// The `N` Bézier control points in the plane of a curve of a degree below `N`, elevated if need be.
fn planar<B, P, const N: usize>(curve: &Curve<B, P>) -> Result<[Pair<B::Scalar>; N], CurveError>
where
    B: Basis,
    P: Point<Scalar = B::Scalar>,
{
    if P::DIM != 2 {
        return Err(CurveError::Dimension { expected: 2, found: P::DIM });
    }
    if B::DEGREE >= N {
        return Err(CurveError::Degree { most: N - 1, found: B::DEGREE });
    }
    let mut points = [P::zero(); N];
    bernstein::elevate(curve.to_bernstein().as_ref(), &mut points);
    Ok(points.map(|p| (p.component(0), p.component(1))))
}
