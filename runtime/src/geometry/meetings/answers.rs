//! The answers: crossings, and intervals that touch each other as one.

use alloc::vec::Vec;

use super::beside::{Near, approach, dot, point, pseudo_inverse, state};
use super::clipping;
use super::{Found, MeetingKind};
use crate::geometry::local::piece_at;
use crate::{CurvePiece, Scalar};

/// How far rounding errors take points that are one from each other, in the unit in which the curves have the size 1.
const NOISE: f64 = 1e-12;

/// From how many places the one at which curves are nearest to each other is searched.
const STARTS: usize = 24;

/// What makes answers of groups.
pub(super) struct Answers {
    pub(super) curves: [Vec<CurvePiece>; 2],
    pub(super) accuracy: f64,
    /// Whether both curves are one.
    pub(super) itself: bool,
}

impl Answers {
    /// The answers to intervals that are connected to each other, and crossings among them.
    #[inline]
    pub(super) fn add(&self, near: &[Near], mut crossings: Vec<Found>, found: &mut Vec<Found>) {
        let Some(best) = near.iter().min_by(|a, b| a.distance.total_cmp(&b.distance)) else {
            found.append(&mut crossings);
            return;
        };
        let mut around = best.intervals;
        for part in near {
            for (side, part) in around.iter_mut().zip(part.intervals) {
                *side = [side[0].min(part[0]), side[1].max(part[1])];
            }
        }
        let extent = self.extent(around[0]);
        let long = extent > 20.0 * Scalar::sqrt(self.accuracy);
        let [first, second] = around;
        if !long && !crossings.is_empty() {
            // The rest of the neighbourhood of a crossing belongs to it.
            for part in near {
                let middle = part.intervals.map(|[lo, hi]| 0.5 * (lo + hi));
                let away = |f: &Found| (0..2).map(|k| (f.at[k] - middle[k]).abs()).fold(0.0, f64::max);
                let nearest = crossings.iter_mut().min_by(|a, b| away(a).total_cmp(&away(b)));
                let Some(crossing) = nearest else { continue };
                for (interval, [lo, hi]) in
                    [&mut crossing.first, &mut crossing.second].into_iter().zip(part.intervals)
                {
                    *interval = [interval[0].min(lo), interval[1].max(hi)];
                }
            }
            for crossing in crossings.iter_mut().filter(|crossing| self.is_tangent(crossing.at)) {
                crossing.kind = MeetingKind::Contact;
            }
            found.extend(told_apart(crossings));
            return;
        }
        let Some(at) = self.place(near, best, around, extent) else { return };
        let kind = if long { MeetingKind::Overlap } else { MeetingKind::Contact };
        found.push(Found { kind, first, second, at });
    }

    /// The parameters of an answer; `None` if the curves are not near each other, or parts of one curve are so only
    /// because it turns between them.
    #[inline]
    fn place(&self, near: &[Near], best: &Near, around: [[f64; 2]; 2], extent: f64) -> Option<[f64; 2]> {
        let [a, b] = &self.curves;
        if !self.itself || !self.is_turn(around) {
            return self.nearest(near, best, around);
        }
        // If it comes back the way that it went, then from as far as it does.
        let is_place = |at: [f64; 2], distance: f64, enough: f64| {
            at[0] < at[1] && distance <= enough && self.extent(at) > 2.0 * self.accuracy
        };
        let mut starts: Vec<&Near> = near.iter().collect();
        starts.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let starts = starts.iter().take(STARTS).map(|near| near.at);
        for start in core::iter::once([around[0][0], around[1][1]]).chain(starts) {
            let (at, distance) = approach(a, b, start, around);
            if is_place(at, distance, NOISE) {
                return Some(at);
            }
        }
        if extent <= 4.0 * Scalar::sqrt(self.accuracy) {
            return None;
        }
        let apart = |near: &&Near| near.at[1] - near.at[0];
        let farthest = near
            .iter()
            .filter(|near| is_place(near.at, near.distance, self.accuracy))
            .max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        Some(farthest.at)
    }

    /// The parameters at which the curves are nearest to each other, from some places; `None` if they are farther than the
    /// accuracy, and that is certain.
    #[inline]
    fn nearest(&self, near: &[Near], best: &Near, around: [[f64; 2]; 2]) -> Option<[f64; 2]> {
        let [a, b] = &self.curves;
        let (mut at, mut least) = approach(a, b, best.at, around);
        if least <= self.accuracy {
            return Some(at);
        }
        let mut starts: Vec<&Near> = near.iter().collect();
        starts.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        for start in starts.into_iter().take(STARTS) {
            let (next, distance) = approach(a, b, start.at, around);
            if distance < least {
                (at, least) = (next, distance);
            }
        }
        let undecided = near.iter().any(|near| !near.decided);
        (least <= self.accuracy || undecided).then_some(at)
    }

    /// How far the first curve goes away from its point at one end of an interval.
    #[inline]
    fn extent(&self, [lo, hi]: [f64; 2]) -> f64 {
        let start = point(&self.curves[0], lo);
        let away = |k: u32| {
            let end = point(&self.curves[0], lo + 0.125 * f64::from(k) * (hi - lo));
            start.iter().zip(&end).map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
        };
        Scalar::sqrt((1..=8).map(away).fold(0.0, f64::max))
    }

    /// Whether a curve turns between parts of it, at a cusp or a corner, so that they are near each other there.
    #[inline]
    fn is_turn(&self, [first, second]: [[f64; 2]; 2]) -> bool {
        let [from, to] = [first[1], second[0]].map(|t| point(&self.curves[0], t));
        let square: f64 = from.iter().zip(&to).map(|(a, b)| (a - b) * (a - b)).sum();
        first[1] >= second[0] || square <= 64.0 * self.accuracy * self.accuracy
    }

    /// Whether the curves have one tangent at a place, up to what rounding errors make of a contact.
    #[inline]
    fn is_tangent(&self, at: [f64; 2]) -> bool {
        let pieces = [0, 1].map(|k| piece_at(&self.curves[k], at[k]));
        let [Some(a), Some(b)] = pieces else { return false };
        let (_, [p, q]) = state(a, b, [a.place(at[0]), b.place(at[1])]);
        let (pp, pq, qq) = (dot(&p, &p), dot(&p, &q), dot(&q, &q));
        pp * qq - pq * pq <= 1e-11 * pp * qq
    }

    /// Intervals around a crossing outside of which the curves are not near each other, as far as they are straight.
    #[inline]
    pub(super) fn around(&self, at: [f64; 2]) -> [[f64; 2]; 2] {
        let pieces = [0, 1].map(|k| piece_at(&self.curves[k], at[k]));
        let [Some(a), Some(b)] = pieces else { return at.map(|t| [t, t]) };
        let places = [a.place(at[0]), b.place(at[1])];
        let (_, columns) = state(a, b, places);
        let Some(rows) = pseudo_inverse(&columns) else { return at.map(|t| [t, t]) };
        let reach = rows.map(|row| 2.0 * self.accuracy * Scalar::sqrt(dot(&row, &row)));
        let sign = if dot(&columns[0], &columns[1]) > 0.0 { -1.0 } else { 1.0 };
        let mut around = places.map(|place| [place; 2]);
        for side in [1.0, -1.0] {
            // Almost parallel ones are not straight as far as that.
            let is_near = |at: [f64; 2]| {
                let (value, _) = state(a, b, at);
                dot(&value, &value) <= 6.25 * self.accuracy * self.accuracy
            };
            let mut steps = reach;
            let mut aside = clipping::both_inside(places, [side, side * sign], steps);
            while steps[0].max(steps[1]) > 1e-12 && !is_near(aside) {
                steps = steps.map(|step| 0.5 * step);
                aside = clipping::both_inside(places, [side, side * sign], steps);
            }
            clipping::extend(&mut around, aside);
        }
        // Where one ends, the other one goes on alone.
        let alone = [0, 1].map(|k| 2.0 * self.accuracy / Scalar::sqrt(dot(&columns[k], &columns[k])));
        clipping::extend_alone(&mut around, places, alone);
        let pieces = [a, b];
        [0, 1].map(|k| around[k].map(|place| pieces[k].parameter(place)))
    }
}

/// Crossings with their neighbourhoods; those in the neighbourhoods of each other are one place at which the curves touch.
#[inline]
fn told_apart(mut crossings: Vec<Found>) -> Vec<Found> {
    let within = |f: &Found, at: [f64; 2]| {
        [f.first, f.second].iter().zip(at).all(|(side, t)| (side[0]..=side[1]).contains(&t))
    };
    // They are near each other all the way between two neighbourhoods that touch.
    let touch = |f: &Found, g: &Found| {
        let sides = [[f.first, g.first], [f.second, g.second]];
        sides.iter().all(|[a, b]| a[0] < a[1] && b[0] < b[1] && a[0] <= b[1] && b[0] <= a[1])
    };
    let mut kept: Vec<Found> = Vec::with_capacity(crossings.len());
    while let Some(mut next) = crossings.pop() {
        // One that has grown may contain another one.
        while let Some(k) =
            kept.iter().position(|f| within(f, next.at) || within(&next, f.at) || touch(f, &next))
        {
            let other = kept.swap_remove(k);
            for (side, [lo, hi]) in [(&mut next.first, other.first), (&mut next.second, other.second)] {
                *side = [side[0].min(lo), side[1].max(hi)];
            }
            next.kind = MeetingKind::Contact;
        }
        kept.push(next);
    }
    kept
}
