//! Splitting: two splines over the two parts of the domain.

use alloc::vec::Vec;

use super::{Rows, insert};
use crate::bspline::{KnotError, KnotVector};
use crate::{Point, Scalar};

/// The rows over the domain up to `t`, and those from `t` on.
pub(in crate::bspline) fn split<P: Point>(
    rows: &Rows<P::Scalar, P>,
    t: P::Scalar,
) -> Result<[Rows<P::Scalar, P>; 2], KnotError> {
    let [lo, hi] = rows.knots.domain();
    if rows.knots.check(t)? == lo || t == hi {
        return Err(KnotError::AtEnd { parameter: t.to_f64() });
    }
    let (k, lanes) = (rows.knots.degree(), rows.lanes);
    let repeated: Vec<_> = core::iter::repeat_n(t, k + 1 - rows.knots.multiplicity(t)).collect();
    let whole = insert(rows, &repeated)?;
    let knots = whole.knots.as_slice();
    let below = knots.partition_point(|&knot| knot < t);
    Ok([
        Rows {
            knots: KnotVector::trusted(k, knots[..=below + k].to_vec()),
            points: whole.points[..below * lanes].to_vec(),
            lanes,
        },
        Rows {
            knots: KnotVector::trusted(k, knots[below..].to_vec()),
            points: whole.points[below * lanes..].to_vec(),
            lanes,
        },
    ])
}
