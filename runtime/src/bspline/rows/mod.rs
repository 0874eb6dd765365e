//! The algorithms on knots and control points, once for curves and for both directions of surfaces.
//!
//! What belongs to one basis function is a *row* of `lanes` points: one point of a curve, a row of the net of a
//! surface. Surfaces turn their net for the other direction.

mod bezier;
mod elevate;
mod insert;
mod merge;
mod remove;
mod split;

use alloc::vec::Vec;

pub(super) use bezier::bezier;
pub(super) use elevate::elevate;
pub(super) use insert::{clamp, insert, insert_into};
pub(super) use merge::missing;
pub(super) use remove::{remove, within};
pub(super) use split::split;

use super::KnotVector;
use crate::Scalar;

/// A knot vector with the rows over it, one after the other.
#[derive(Clone, Debug)]
pub(super) struct Rows<S, P> {
    pub(super) knots: KnotVector<S>,
    pub(super) points: Vec<P>,
    pub(super) lanes: usize,
}

impl<S: Scalar, P> Rows<S, P> {
    pub(super) fn row(&self, index: usize) -> &[P] {
        &self.points[index * self.lanes..][..self.lanes]
    }
}

/// `from + (to - from) factor`; equal points give that point exactly, whatever the factor.
#[inline]
fn between<P: crate::Point>(from: P, to: P, factor: P::Scalar) -> P {
    from.add_scaled(to.minus(from), factor)
}
