//! Where curves meet: by exclusion of parts that are apart, and a test that two parts meet at most once.
//!
//! Two parts `A(x)` and `B(y)` are put aside when their boxes, or their control points along the direction from one to
//! the other, are farther apart than the accuracy. With a matrix `M` near the inverse of the derivative of `F = A - B`
//! in the middle and `q = max |M F' - 1| < 1` over both parts, from the control points of the derivatives, `F` has at
//! most one zero, and all places with `|F| <= d` lie within `q/2 + d |M|` of the place to which Newton's step leads from
//! the middle (the operator of Krawczyk): if that is outside of both parts there is none; otherwise Newton's method
//! finds the zero. All others are halved, until control points show that they are one curve, or that both go along
//! their chords: then the intervals in which the chords are beside each other are known. Parts that run along each other
//! for long are not halved but compared as functions of one parameter (`along`). So nothing is left out. A search that
//! becomes too long nevertheless goes on with twice the accuracy, and so on; what it finds then is an answer also where
//! the curves are not known to be as near as was asked for.
//!
//! Intervals that touch each other, also through the end of a closed curve, are one answer, and what is beside a crossing belongs to it. The parts between two
//! places of one curve say whether these are places at which it meets itself: not if it goes on in one direction between
//! them, or no farther than twice the accuracy.
mod along;
mod answers;
mod beside;
mod clipping;
mod line;
pub(super) mod meeting;
mod merged;
mod seam;
mod search;
mod single;
pub(super) mod surface_meeting;

use alloc::vec::Vec;

use crate::CurvePiece;
use beside::{difference, dot, point};
use clipping::View;
use search::Search;
use single::Pair;

pub use meeting::{Meeting, PlaneMeeting};
pub use surface_meeting::SurfaceMeeting;
pub(crate) use surface_meeting::of_line;

/// How two curves meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum MeetingKind {
    /// At one point, at an angle.
    Crossing,
    /// Nearer to each other than the accuracy, next to one point: they touch, meet at a cusp, or just do not meet.
    Contact,
    /// Nearer to each other than the accuracy along an interval that is longer than curves have in common which merely
    /// touch: twenty times the root of the accuracy, in the unit in which the curves have the size 1. Also a contact of
    /// high order.
    Overlap,
}

/// Parameters of both curves between which they meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) kind: MeetingKind,
    pub(crate) first: [f64; 2],
    pub(crate) second: [f64; 2],
    pub(crate) at: [f64; 2],
}

/// All places at which two curves meet, in the order of the first parameter; `None` if anything is not finite.
#[inline]
pub(crate) fn meetings(
    a: &[CurvePiece],
    b: &[CurvePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<Vec<Found>> {
    let (view, accuracy) = view(a, b, accuracy, epsilon)?;
    let mut search = Search::new(accuracy);
    if let ([first], [second]) = (a, b) {
        search.between(first, second, view);
        search.run();
        return Some(seam::joined(search.answers(a, b, accuracy, view), [a, b], view, accuracy));
    }
    let boxes: Vec<Vec<[f64; 2]>> = a.iter().chain(b).map(|piece| bounds(piece, view)).collect();
    for [k, n] in merged::beside(&boxes, accuracy, |k, n| k < a.len() && n >= a.len()) {
        search.between(&a[k], &b[n - a.len()], view);
    }
    search.run();
    Some(seam::joined(search.answers(a, b, accuracy, view), [a, b], view, accuracy))
}

/// All places at which a curve meets itself, the smaller parameter first, but for the one at which a closed curve ends
/// where it begins; `None` if anything is not finite.
#[inline]
pub(crate) fn self_meetings(a: &[CurvePiece], accuracy: f64, epsilon: f64) -> Option<Vec<Found>> {
    let (view, accuracy) = view(a, &[], accuracy, epsilon)?;
    let seen: Vec<CurvePiece> = a.iter().map(|piece| view.of(piece)).collect();
    let mut search = Search::new(accuracy);
    search.own = &seen;
    for (k, first) in seen.iter().enumerate() {
        search.against_itself(first);
        if let Some(second) = seen.get(k + 1) {
            search.open.push(Pair { first: first.clone(), second: second.clone() });
        }
    }
    let boxes: Vec<Vec<[f64; 2]>> = a.iter().map(|piece| bounds(piece, view)).collect();
    for [k, n] in merged::beside(&boxes, accuracy, |k, n| n >= k + 2) {
        search.between(&a[k], &a[n], view);
    }
    search.run();
    let mut found = search.answers(a, a, accuracy, view);
    let ends = [a.first()?.domain()[0], a.last()?.domain()[1]];
    let near = 1e-9 * (ends[1] - ends[0]);
    let away = difference(&point(&seen, ends[0]), &point(&seen, ends[1]));
    if dot(&away, &away) <= 4.0 * accuracy * accuracy {
        found.retain(|f| {
            let is_inside = f.first[0] > ends[0] + near || f.second[1] < ends[1] - near;
            let comes_back = f.kind == MeetingKind::Overlap || f.first[1] + near >= f.second[0];
            is_inside || comes_back
        });
    }
    Some(found)
}

/// A common origin and a common unit of both curves, and the accuracy in it.
#[inline]
fn view<'a>(
    a: &'a [CurvePiece],
    b: &'a [CurvePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<(View<'a>, f64)> {
    let first = a.first()?;
    if !a.iter().chain(b).all(CurvePiece::is_finite) {
        return None;
    }
    let mut size = 0.0_f64;
    for piece in a.iter().chain(b) {
        for d in 0..first.dimension() {
            let origin = first.control(0, d);
            size = (0..=piece.degree()).fold(size, |size, i| size.max((piece.control(i, d) - origin).abs()));
        }
    }
    if !size.is_finite() {
        return None;
    }
    let unit = if size > 0.0 { size } else { 1.0 };
    let accuracy = if accuracy > 0.0 { accuracy / unit } else { 0.0 };
    Some((View { first, unit }, accuracy.max(64.0 * epsilon)))
}

/// The box of a piece as it is seen.
#[inline]
fn bounds(piece: &CurvePiece, view: View<'_>) -> Vec<[f64; 2]> {
    let side = |d: usize| {
        let origin = view.origin(d);
        (0..=piece.degree()).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], i| {
            let c = (piece.control(i, d) - origin) / view.unit;
            [lo.min(c), hi.max(c)]
        })
    };
    (0..piece.dimension()).map(side).collect()
}
