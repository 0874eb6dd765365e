//! Answers that are one place because a curve ends where it begins.

use alloc::vec::Vec;

use super::beside::{dot, point};
use super::clipping::View;
use super::{Found, MeetingKind};
use crate::CurvePiece;

/// What two curves have in common, as seen from one point.
struct Seams<'a> {
    curves: [&'a [CurvePiece]; 2],
    view: View<'a>,
    domains: [[f64; 2]; 2],
    /// Whether each curve ends where it begins.
    closed: [bool; 2],
    gaps: [f64; 2],
}

/// Answers at both sides of the end of a closed curve as one; two crossings at different places stay two.
#[inline]
pub(super) fn joined(
    mut found: Vec<Found>,
    curves: [&[CurvePiece]; 2],
    view: View<'_>,
    accuracy: f64,
) -> Vec<Found> {
    let [Some(first), Some(second)] = curves.map(domain) else { return found };
    let domains = [first, second];
    let closed = curves.map(|pieces| is_closed(pieces, accuracy * view.unit));
    if found.len() < 2 || closed == [false; 2] {
        return found;
    }
    let gaps = domains.map(|[lo, hi]| 1e-9 * (hi - lo));
    let seams = Seams { curves, view, domains, closed, gaps };
    let mut k = 0;
    while k < found.len() {
        let other = (0..found.len()).filter(|&n| n != k).find_map(|n| {
            let joined = seams.one(&found[k], &found[n])?;
            Some((n, joined))
        });
        if let Some((n, one)) = other {
            found[k] = one;
            found.remove(n);
            // It may have become the neighbour of one before it.
            k = 0;
        } else {
            k += 1;
        }
    }
    found.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
    found
}

impl Seams<'_> {
    /// The place of two answers that are one: they touch, or follow each other through an end, in both parameters.
    #[inline]
    fn one(&self, f: &Found, g: &Found) -> Option<Found> {
        let (first, through) = self.union(0, f.first, g.first)?;
        let (second, other) = self.union(1, f.second, g.second)?;
        if !through && !other {
            return None;
        }
        let crossings = [f, g].map(|found| found.kind == MeetingKind::Crossing);
        if crossings == [true; 2] && !self.are_one_point(f, g) {
            return None;
        }
        let overlap = [f, g].iter().any(|found| found.kind == MeetingKind::Overlap);
        let kind = match (overlap, crossings.contains(&true)) {
            (true, _) => MeetingKind::Overlap,
            (false, true) => MeetingKind::Crossing,
            (false, false) => MeetingKind::Contact,
        };
        let first_is_better = match crossings {
            [true, false] => true,
            [false, true] => false,
            _ => self.square(f) <= self.square(g),
        };
        let at = if first_is_better { f.at } else { g.at };
        let [mut first, mut second] = [first, second];
        for (side, at) in [&mut first, &mut second].into_iter().zip(at) {
            // Rounding errors of the period.
            if side[0] > side[1] && at < side[0] && at > side[1] {
                if at - side[1] < side[0] - at {
                    side[1] = at;
                } else {
                    side[0] = at;
                }
            }
        }
        Some(Found { kind, first, second, at })
    }

    /// The interval of both if they touch, and whether it goes through the end of a closed curve: then it begins at a
    /// larger parameter than it ends.
    #[inline]
    fn union(&self, k: usize, a: [f64; 2], b: [f64; 2]) -> Option<([f64; 2], bool)> {
        let ([lo, hi], gap) = (self.domains[k], self.gaps[k]);
        let period = hi - lo;
        let unrolled = |[from, to]: [f64; 2]| [from, if from > to { to + period } else { to }];
        let ([a, b], wraps) = ([a, b].map(unrolled), a[0] > a[1] || b[0] > b[1]);
        let shifts: &[f64] = if self.closed[k] { &[0.0, period, -period] } else { &[0.0] };
        let touch = |&shift: &f64| a[0] <= b[1] + shift + gap && b[0] + shift <= a[1] + gap;
        let shift = shifts.iter().copied().find(touch)?;
        let (mut from, to) = (a[0].min(b[0] + shift), a[1].max(b[1] + shift));
        let through = wraps || shifts.iter().any(|shift| *shift != 0.0 && touch(shift));
        if to - from >= period - gap {
            return Some(([lo, hi], through));
        }
        let length = to - from;
        if from < lo || through && from <= lo + gap {
            from += period;
        }
        let end = from + length;
        let ends_at_start = through && end >= hi - gap || end > hi + gap;
        Some(([from.min(hi), if ends_at_start { (end - period).max(lo) } else { end.min(hi) }], through))
    }

    /// Whether two crossings are one, but for the ends of closed curves.
    #[inline]
    fn are_one_point(&self, f: &Found, g: &Found) -> bool {
        (0..2).all(|k| {
            let [lo, hi] = self.domains[k];
            let away = (f.at[k] - g.at[k]).abs();
            away <= self.gaps[k] || self.closed[k] && away >= hi - lo - self.gaps[k]
        })
    }

    /// The square of the distance of both points of an answer.
    #[inline]
    fn square(&self, found: &Found) -> f64 {
        let [a, b] = [0, 1].map(|k| point(self.curves[k], found.at[k]));
        let away: Vec<f64> = a.iter().zip(&b).map(|(a, b)| (a - b) / self.view.unit).collect();
        dot(&away, &away)
    }
}

#[inline]
fn domain(pieces: &[CurvePiece]) -> Option<[f64; 2]> {
    Some([pieces.first()?.domain()[0], pieces.last()?.domain()[1]])
}

/// Whether a curve ends no farther than a distance from its start.
#[inline]
fn is_closed(pieces: &[CurvePiece], distance: f64) -> bool {
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return false };
    (0..first.dimension()).all(|d| (first.control(0, d) - last.control(last.degree(), d)).abs() <= distance)
}
