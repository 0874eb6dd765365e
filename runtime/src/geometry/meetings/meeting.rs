//! Where curves meet each other, themselves and planes, with points.

use alloc::vec::Vec;

use super::{Found, MeetingKind};
use crate::bernstein::{RootKind, roots};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::{distance, recast};
use crate::{CurvePiece, CurveVector, ParametricCurve};
use crate::{Point, Scalar};

/// A place at which two curves meet, or a curve meets itself.
///
/// An interval of a closed curve that runs through its end begins at a larger parameter than it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct Meeting<P: Point> {
    /// How they meet.
    pub kind: MeetingKind,
    /// The parameters of the first curve between which they meet here.
    pub first: [P::Scalar; 2],
    /// The parameters of the second curve between which they meet here.
    pub second: [P::Scalar; 2],
    /// The parameters of both curves at which they meet, or are nearest to each other.
    pub at: [P::Scalar; 2],
    /// The point of the first curve there.
    pub point: P,
    /// Its distance from the point of the second one.
    pub distance: P::Scalar,
}

/// A place at which a curve meets a plane, or in the plane a line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct PlaneMeeting<P: Point> {
    /// [`Crossing`](MeetingKind::Crossing) if the curve goes on at the other side, [`Contact`](MeetingKind::Contact) if
    /// it touches the plane or ends there, [`Overlap`](MeetingKind::Overlap) if a piece of it lies in the plane.
    pub kind: MeetingKind,
    /// The parameters between which they meet here; equal but for an overlap.
    pub interval: [P::Scalar; 2],
    /// The point of the curve at the first of them.
    pub point: P,
}

/// The answers as points of the curves.
pub(crate) fn with_points<P: Point>(
    first: &(impl ParametricCurve<Point = P> + ?Sized),
    second: &(impl ParametricCurve<Point = P> + ?Sized),
    found: Vec<Found>,
) -> Vec<Meeting<P>> {
    let meeting = |f: Found| {
        let at = [first.parameter_of(f.at[0]), second.parameter_of(f.at[1])];
        let (point, other) = (first.eval(at[0]), second.eval(at[1]));
        Meeting {
            kind: f.kind,
            first: f.first.map(|t| first.parameter_of(t)),
            second: f.second.map(|t| second.parameter_of(t)),
            at,
            point,
            distance: distance(point, other),
        }
    };
    found.into_iter().map(meeting).collect()
}

/// The places of a curve at which it meets another one.
pub(crate) fn of_two<P: Point>(
    first: &(impl ParametricCurve<Point = P> + ?Sized),
    second: &dyn ParametricCurve<Point = P>,
    accuracy: P::Scalar,
) -> Option<Vec<Meeting<P>>> {
    let (a, b) = (first.pieces(), second.pieces());
    let found = super::meetings(&a, &b, accuracy.to_f64(), P::Scalar::EPSILON.to_f64())?;
    Some(with_points(first, second, found))
}

/// The places of a curve at which it meets itself.
pub(crate) fn of_one<P: Point>(
    curve: &(impl ParametricCurve<Point = P> + ?Sized),
    accuracy: P::Scalar,
) -> Option<Vec<Meeting<P>>> {
    let found = super::self_meetings(&curve.pieces(), accuracy.to_f64(), P::Scalar::EPSILON.to_f64())?;
    Some(with_points(curve, curve, found))
}

/// The places at which a curve meets the plane through `point` across `normal`: zeros of the height above it.
pub(crate) fn of_plane<C: ParametricCurve + ?Sized>(
    curve: &C,
    point: C::Point,
    normal: CurveVector<C>,
) -> Option<Vec<PlaneMeeting<C::Point>>> {
    let normal: C::Point = recast(normal);
    let components = |p: C::Point| (0..C::Point::DIM).map(|d| p.component(d).to_f64()).collect::<Vec<f64>>();
    let found = plane_places(&curve.pieces(), &components(point), &components(normal))?;
    let meeting = |(kind, interval): (MeetingKind, [f64; 2])| {
        let interval = interval.map(|t| curve.parameter_of(t));
        PlaneMeeting { kind, interval, point: curve.eval(interval[0]) }
    };
    Some(found.into_iter().map(meeting).collect())
}

/// The kinds and parameters at which the height of the pieces above a plane is zero.
#[inline]
fn plane_places(
    pieces: &[CurvePiece],
    point: &[f64],
    normal: &[f64],
) -> Option<Vec<(MeetingKind, [f64; 2])>> {
    let size = normal.iter().fold(0.0_f64, |size, n| size.max(n.abs()));
    let finite =
        normal.iter().chain(point).all(|x| x.is_finite()) && pieces.iter().all(CurvePiece::is_finite);
    if !finite || size == 0.0 {
        return None;
    }
    let mut found: Vec<(MeetingKind, [f64; 2])> = Vec::new();
    // The sign of the height at the end of the pieces before, where it is not zero.
    let mut before: Option<bool> = None;
    for piece in pieces {
        let seen = piece.seen_from(point, 1.0);
        let largest = piece.largest().max(point.iter().fold(0.0_f64, |a, c| a.max(c.abs())));
        let noise = 8.0 * f64::EPSILON * (normal.len() + piece.degree()) as f64 * largest;
        let mut height = alloc::vec![0.0; piece.degree() + 1];
        for (d, n) in normal.iter().enumerate() {
            for (height, c) in height.iter_mut().zip(seen.component(d)) {
                *height += n / size * c;
            }
        }
        for height in &mut height {
            if height.abs() <= noise {
                *height = 0.0;
            }
        }
        let [lo, hi] = piece.domain();
        let Some(&first) = height.iter().find(|h| **h != 0.0) else {
            match found.last_mut() {
                Some((MeetingKind::Overlap, interval)) if interval[1] >= lo => interval[1] = hi,
                Some(last) if last.1[1] >= lo => *last = (MeetingKind::Overlap, [lo, hi]),
                _ => found.push((MeetingKind::Overlap, [lo, hi])),
            }
            continue;
        };
        for root in roots(&height) {
            let t = piece.parameter(root.x);
            let at_start = root.x <= 0.0;
            let kind = if root.kind == RootKind::Crossing
                || at_start && before.is_some_and(|positive| positive != (first > 0.0))
            {
                MeetingKind::Crossing
            } else {
                MeetingKind::Contact
            };
            match found.last_mut() {
                // The end of the piece before.
                Some(last) if at_start && last.1[1] >= t => {
                    if last.0 == MeetingKind::Contact {
                        last.0 = kind;
                    }
                }
                _ => found.push((kind, [t, t])),
            }
        }
        before = height.iter().rev().find(|h| **h != 0.0).map(|&last| last > 0.0);
    }
    Some(found)
}
