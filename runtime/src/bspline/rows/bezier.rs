//! Bézier extraction: the control points of each polynomial piece.

use alloc::vec::Vec;

use super::{Rows, clamp, insert};
use crate::Point;

/// For each span that has a length its ends and the `(k + 1) lanes` control points of the piece over it in Bézier form.
pub(in crate::bspline) fn bezier<P: Point>(rows: &Rows<P::Scalar, P>) -> Vec<([P::Scalar; 2], Vec<P>)> {
    let rows = clamp(rows);
    let k = rows.knots.degree();
    // Inner knots of multiplicity k + 1 stay: the spline may jump there.
    let breakpoints = rows.knots.breakpoints();
    let inner = &breakpoints[1..breakpoints.len() - 1];
    let inserted: Vec<_> = inner
        .iter()
        .flat_map(|&t| core::iter::repeat_n(t, k.saturating_sub(rows.knots.multiplicity(t))))
        .collect();
    let Ok(pieces) = insert(&rows, &inserted) else {
        return Vec::new(); // not reached: inner knots, up to multiplicity k
    };
    let knots = pieces.knots.as_slice();
    let spans = pieces.knots.spans();
    spans
        .map(|span| {
            let points = &pieces.points[(span - k) * rows.lanes..(span + 1) * rows.lanes];
            ([knots[span], knots[span + 1]], points.to_vec())
        })
        .collect()
}
