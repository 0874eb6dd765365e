//! Curves of several segments that are moved at an end: only the first or the last segment is changed.

use alloc::vec::Vec;

use super::PiecewiseCurve;
use crate::{CurveError, CurveScalar, CurveVector, JoinableCurve, Point, Scalar};

impl<C: JoinableCurve + Clone> JoinableCurve for PiecewiseCurve<C> {
    fn highest_contact(&self) -> usize {
        self.segments[0].highest_contact().min(self.last().highest_contact())
    }

    fn with_start(&self, derivatives: &[CurveVector<C>]) -> Result<Self, CurveError> {
        let mut moved = self.clone();
        moved.segments[0] = moved.segments[0].with_start(&in_segment(&moved.segments[0], derivatives))?;
        Ok(moved)
    }

    fn with_end(&self, derivatives: &[CurveVector<C>]) -> Result<Self, CurveError> {
        let (mut moved, last) = (self.clone(), self.segments.len() - 1);
        moved.segments[last] = moved.segments[last].with_end(&in_segment(self.last(), derivatives))?;
        Ok(moved)
    }
}

/// The derivatives in the parameter of a segment, of which the unit interval of the whole curve is one.
fn in_segment<C: JoinableCurve>(segment: &C, derivatives: &[CurveVector<C>]) -> Vec<CurveVector<C>> {
    let [lo, hi] = segment.domain();
    let mut scale = CurveScalar::<C>::ONE;
    let scaled = derivatives.iter().map(|derivative| {
        let scaled = derivative.scale(CurveScalar::<C>::ONE / scale);
        scale = scale * (hi - lo);
        scaled
    });
    scaled.collect()
}
