//! Merging: which knots one vector lacks of another.

use alloc::vec::Vec;

use crate::Scalar;
use crate::bspline::{KnotError, KnotVector};

/// The inner knots of `other`, as often as they occur there more than in `knots`.
///
/// Knots are compared exactly. Degrees may differ; at most `k + 1` copies, `k` the degree of `knots`, are asked for.
pub(in crate::bspline) fn missing<S: Scalar>(
    knots: &KnotVector<S>,
    other: &KnotVector<S>,
) -> Result<Vec<S>, KnotError> {
    if knots.domain() != other.domain() {
        let domains = [knots, other].map(|knots| knots.domain().map(Scalar::to_f64));
        return Err(KnotError::Domains { domains });
    }
    let breakpoints = other.breakpoints();
    let inner = &breakpoints[1..breakpoints.len() - 1];
    let missing = inner.iter().flat_map(|&t| {
        let wanted = other.multiplicity(t).min(knots.degree() + 1);
        core::iter::repeat_n(t, wanted.saturating_sub(knots.multiplicity(t)))
    });
    Ok(missing.collect())
}
