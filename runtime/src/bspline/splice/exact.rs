//! Method (c): over the same knots, copy the edge row and set the second row.

use super::strip::Strip;
use crate::Point;
use crate::vector::{dot, length};

/// `inner = edge - a (inner' - edge')` with the target's rows `'` and one factor `a > 0`, so that the derivatives
/// across the edge differ by a constant factor: gap and angle are rounding errors.
///
/// The factor is the one with the smallest change of the difference `edge - inner`, but never less than a small
/// positive one: `a = Σ e·w / Σ w·w` over the control points, `e = edge - inner`, `w = inner' - edge'`. It is returned.
pub(super) fn rows(strip: &mut Strip, target: &Strip) -> f64 {
    let pairs = || {
        let e = strip.edge.iter().zip(&strip.inner).map(|(edge, inner)| edge.minus(*inner));
        let w = target.edge.iter().zip(&target.inner).map(|(edge, inner)| inner.minus(*edge));
        e.zip(w)
    };
    let product: f64 = pairs().map(|(e, w)| dot(e, w)).sum();
    let square: f64 = pairs().map(|(_, w)| dot(w, w)).sum();
    let lengths: [f64; 2] = pairs().fold([0.0; 2], |[a, b], (e, w)| [a + length(e), b + length(w)]);
    let least = 0.1 * lengths[0] / lengths[1];
    let mut factor = product / square;
    if !(factor > least && factor.is_finite()) {
        // The strip turns back, or has no width: keep a part of its width, or take the target's.
        factor = if least > 0.0 && least.is_finite() { least } else { 1.0 };
    }
    strip.edge.clone_from(&target.edge);
    let rows = target.edge.iter().zip(&target.inner);
    strip.inner = rows.map(|(edge, inner)| edge.add_scaled(inner.minus(*edge), -factor)).collect();
    factor
}
