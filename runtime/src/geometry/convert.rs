//! Between the numbers of a curve and those of the search, which is in double precision.

use alloc::vec::Vec;

use super::CurvePiece;
use crate::{CurveError, Point, Scalar};

/// The parameter of a sample: exact at both ends.
pub(super) fn sample<S: Scalar>(domain: [S; 2], index: usize, count: usize) -> S {
    let steps = S::from_usize(count.saturating_sub(1).max(1));
    crate::domain::from_unit(domain, S::from_usize(index) / steps)
}

/// The pieces of a curve in the plane.
pub(super) fn in_the_plane<P: Point>(pieces: Vec<CurvePiece>) -> Result<Vec<CurvePiece>, CurveError> {
    if P::DIM == 2 { Ok(pieces) } else { Err(CurveError::Dimension { expected: 2, found: P::DIM }) }
}

/// An accuracy for the search in double precision: what is not positive asks for the best.
pub(super) fn floor<S: Scalar>(accuracy: S) -> f64 {
    accuracy.to_f64().max(0.0)
}

/// A parameter that was found in double precision.
pub(super) fn back<S: Scalar>(domain: [S; 2], t: f64) -> S {
    clamped(domain, S::of(t))
}

/// The parameter of the domain nearest to `t`; NaN stays.
pub(crate) fn clamped<S: Scalar>([lo, hi]: [S; 2], t: S) -> S {
    if t < lo {
        lo
    } else if t > hi {
        hi
    } else {
        t
    }
}

pub(super) fn corners_of<P: Point>(sides: &[[f64; 2]]) -> [P; 2] {
    let corner =
        |k: usize| P::from_components(|d| P::Scalar::of(sides.get(d).map_or(f64::NAN, |side| side[k])));
    [corner(0), corner(1)]
}
