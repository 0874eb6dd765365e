//! Parallel curves without what is nearer to the curve than the distance.
//!
//! All parts between places at which the parallel curve meets itself, or turns round at a cusp or an inner corner, or
//! begins or ends a long arc around a corner, or is as far from an end of the curve as it should be, are as a whole far
//! enough from the curve, or not. Those that are, are put together again. A loop between the sides of an inner corner or
//! a cusp, which runs in the other direction, is left out by its direction: it may be nearer by less than the tolerance.

use alloc::vec::Vec;

use super::super::{Path, PathSegment};
use super::outline::circle;
use super::parallel::{Part, V, length, plus, wedge};
use crate::geometry::{meetings, nearest_place, self_meetings};
use crate::{CurvePiece, ParametricCurve};

/// A parallel curve, or the outline of a contour.
pub(super) struct Raw {
    pub(super) parts: Vec<Part>,
    pub(super) closed: bool,
}

/// What is trimmed, and against what.
pub(super) struct Trim<'a> {
    /// The curve.
    pub(super) base: &'a [CurvePiece],
    /// The ends of its open contours.
    pub(super) ends: &'a [V],
    /// Other curves at the distance from the curve.
    pub(super) barriers: &'a [Vec<Part>],
    pub(super) distance: f64,
    pub(super) tolerance: f64,
}

/// The parameters at which a raw curve is cut, and intervals of loops that do not stay.
type Cuts = (Vec<f64>, Vec<[f64; 2]>);

/// Loops that are longer, in the unit of the distance, are judged by their distance from the curve alone.
const SHORT: f64 = 8.0;

/// A part of a raw curve that stays.
struct Kept {
    path: Path<V>,
    /// Whether the next one of those that stay follows it on its curve.
    goes_on: bool,
}

impl Trim<'_> {
    pub(super) fn run(&self, mut raws: Vec<Raw>) -> Vec<Path<V>> {
        let size = self.base.iter().map(CurvePiece::largest).fold(self.distance.abs(), f64::max);
        let noise = 64.0 * f64::EPSILON * size;
        for raw in &mut raws {
            raw.parts.retain(|part| {
                let points = part.segment.control_points();
                points.iter().any(|&p| length(plus(p, points[0], -1.0)) > noise)
            });
        }
        raws.retain(|raw| !raw.parts.is_empty());
        let pieces: Vec<Vec<CurvePiece>> = raws
            .iter()
            .map(|raw| {
                let numbered = raw.parts.iter().enumerate();
                numbered.map(|(k, part)| part.segment.to_piece([k as f64, (k + 1) as f64])).collect()
            })
            .collect();
        let cuts = self.cuts(&raws, &pieces);
        let mut kept: Vec<Kept> = Vec::new();
        for (raw, (cuts, loops)) in raws.iter().zip(cuts) {
            self.keep(raw, cuts, &loops, noise, &mut kept);
        }
        chains(&kept, 4.0 * self.tolerance + noise)
    }

    /// The parameters at which each raw curve is cut, in increasing order, and its loops at corners.
    fn cuts(&self, raws: &[Raw], pieces: &[Vec<CurvePiece>]) -> Vec<Cuts> {
        let accuracy = 0.01 * self.tolerance;
        let mut barriers: Vec<CurvePiece> = Vec::new();
        for part in self.barriers.iter().flatten().filter(|part| !part.reversed) {
            barriers.push(part.segment.to_piece([0.0, 1.0]));
        }
        barriers.extend(self.ends.iter().flat_map(|&end| circle(end, self.distance.abs())));
        let mut cuts: Vec<Cuts> = Vec::new();
        for (i, (raw, own)) in raws.iter().zip(pieces).enumerate() {
            let (mut list, mut loops) = (Vec::new(), Vec::new());
            for (k, pair) in raw.parts.windows(2).enumerate() {
                if pair[0].reversed != pair[1].reversed
                    || self.is_long_arc(&pair[0]) != self.is_long_arc(&pair[1])
                {
                    list.push((k + 1) as f64);
                }
            }
            for found in self_meetings(own, accuracy, f64::EPSILON).unwrap_or_default() {
                list.extend(found.at);
                list.extend(found.first);
                list.extend(found.second);
                loops.extend(self.loop_of(raw, found.at));
            }
            // All others at once: the work of a search is bounded.
            let mut others = barriers.clone();
            others
                .extend(pieces.iter().enumerate().filter(|(j, _)| *j != i).flat_map(|(_, all)| all.clone()));
            for found in meetings(own, &others, accuracy, f64::EPSILON).unwrap_or_default() {
                list.push(found.at[0]);
                list.extend(found.first);
            }
            list.sort_by(f64::total_cmp);
            list.dedup_by(|b, a| *b - *a <= 1e-9);
            cuts.push((list, loops));
        }
        cuts
    }

    /// The short loop of a raw curve between two parameters of a place at which it meets itself, if it is one that the
    /// sides of an inner corner or of a cusp make: it runs backwards somewhere, and around what is inside in the other
    /// direction than the curve. Such a loop is nearer to the curve than the distance, perhaps by less than the tolerance.
    fn loop_of(&self, raw: &Raw, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
        let count = raw.parts.len() as f64;
        let around = raw.closed.then_some([to, from + count]);
        core::iter::once([from, to]).chain(around).find(|&ends| self.is_backwards(raw, ends))
    }

    fn is_backwards(&self, raw: &Raw, [from, to]: [f64; 2]) -> bool {
        let part = |k: usize| &raw.parts[k % raw.parts.len()];
        let (start, end) = (from as usize, to as usize);
        let at = |k: usize, x: f64| part(k).segment.eval(x);
        let first = at(start, from - start as f64);
        let (mut last, mut area, mut size, mut reversed) = (first, 0.0, 0.0, false);
        for k in start..=end {
            let (lo, hi) = (if k == start { from - k as f64 } else { 0.0 }, (to - k as f64).min(1.0));
            reversed |= part(k).reversed && lo < hi;
            for i in 1..=4 {
                let next = at(k, lo + (hi - lo) * f64::from(i) / 4.0);
                area += wedge(plus(last, first, -1.0), plus(next, first, -1.0));
                size += length(plus(next, last, -1.0));
                last = next;
            }
            if size > SHORT * self.distance.abs() {
                return false;
            }
        }
        reversed && area * self.distance < 0.0
    }

    /// Adds the parts of a raw curve that stay, in its order.
    fn keep(&self, raw: &Raw, mut cuts: Vec<f64>, loops: &[[f64; 2]], noise: f64, kept: &mut Vec<Kept>) {
        let count = raw.parts.len() as f64;
        let segments: Vec<PathSegment<V>> = raw.parts.iter().map(|part| part.segment.clone()).collect();
        let Ok(path) = Path::new(segments) else { return };
        if !raw.closed || cuts.is_empty() {
            cuts.insert(0, 0.0);
            cuts.push(count);
            cuts.dedup_by(|b, a| *b - *a <= 1e-9);
        } else {
            // Around the end: the last part reaches into the next turn.
            cuts.retain(|&cut| cut < count - 1e-9);
            if cuts.is_empty() {
                cuts.push(0.0);
            }
            cuts.push(cuts[0] + count);
        }
        let mut last_stays = false;
        for ends in cuts.windows(2) {
            let at = |x: f64| {
                let t = ends[0] + (ends[1] - ends[0]) * x;
                if t > count { t - count } else { t }
            };
            let middle = 0.5 * (ends[0] + ends[1]);
            let within = |&[from, to]: &[f64; 2]| {
                [middle, middle - count, middle + count].iter().any(|&t| from < t && t < to)
            };
            let (k, _) = path.locate(at(0.5));
            // No place of an arc at a cusp is known at which it comes too near to the sides.
            let samples: &[f64] = if self.is_long_arc(&raw.parts[k]) {
                &[0.02, 0.25, 0.5, 0.75, 0.98]
            } else {
                &[0.25, 0.5, 0.75]
            };
            let stays = !loops.iter().any(within)
                && samples.iter().all(|&x| self.is_far_enough(raw, &path, at(x), noise));
            if !stays {
                last_stays = false;
            } else if let Some(part) = part_of(&path, ends[0], ends[1], count, noise) {
                if last_stays && let Some(before) = kept.last_mut() {
                    before.goes_on = true;
                }
                kept.push(Kept { path: part, goes_on: false });
                last_stays = true;
            }
        }
    }

    /// Whether a part is an arc of more than a sixth of a circle, as it stands where the curve turns back.
    fn is_long_arc(&self, part: &Part) -> bool {
        let chord = plus(part.segment.end(), part.segment.start(), -1.0);
        part.segment.weights().is_some() && length(chord) > self.distance.abs()
    }

    /// Whether a point of a raw curve is as far from the curve as it should be.
    fn is_far_enough(&self, raw: &Raw, path: &Path<V>, t: f64, noise: f64) -> bool {
        let (k, _) = path.locate(t);
        let part = &raw.parts[k];
        if part.reversed {
            return false;
        }
        let point = path.eval(t);
        let Some((place, _)) = nearest_place(self.base, &point, 0.01 * self.tolerance, f64::EPSILON) else {
            return false;
        };
        let Some(piece) = self.base.iter().rfind(|p| p.domain()[0] <= place).or(self.base.first()) else {
            return false;
        };
        let x = piece.place(place);
        let near = [piece.value(0, x), piece.value(1, x)];
        length(plus(point, near, -1.0)) >= part.least - 1.5 * self.tolerance - noise
    }
}

/// The part of a path between two parameters, of a closed one perhaps around its end; `None` if it has no length.
fn part_of(path: &Path<V>, from: f64, to: f64, count: f64, noise: f64) -> Option<Path<V>> {
    let mut segments: Vec<PathSegment<V>> = Vec::new();
    for [a, b] in [[from, to.min(count)], [from.max(count) - count, to - count]] {
        if b > a
            && let Ok(part) = path.subsegment(a..b)
        {
            segments.extend_from_slice(part.segments());
        }
    }
    segments.retain(|segment| {
        let points = segment.control_points();
        points.iter().any(|&p| length(plus(p, points[0], -1.0)) > noise)
    });
    Path::new(segments).ok()
}

/// Parts put together: each is followed by the one behind it, or by the one that begins where it ends.
fn chains(kept: &[Kept], near: f64) -> Vec<Path<V>> {
    let count = kept.len();
    let starts: Vec<V> = kept.iter().map(|k| k.path.start()).collect();
    let ends: Vec<V> = kept.iter().map(|k| k.path.end()).collect();
    let mut next: Vec<Option<usize>> =
        (0..count).map(|k| (kept[k].goes_on && k + 1 < count).then_some(k + 1)).collect();
    let mut taken = alloc::vec![false; count];
    for follower in next.iter().flatten() {
        taken[*follower] = true;
    }
    // The nearest pairs first.
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (k, &end) in ends.iter().enumerate().filter(|(k, _)| next[*k].is_none()) {
        for (n, &start) in starts.iter().enumerate().filter(|(n, _)| !taken[*n]) {
            let distance = length(plus(start, end, -1.0));
            if distance <= near {
                pairs.push((distance, k, n));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, k, n) in pairs {
        if next[k].is_none() && !taken[n] {
            next[k] = Some(n);
            taken[n] = true;
        }
    }
    let mut used = alloc::vec![false; count];
    let mut paths = Vec::new();
    // Open chains begin with parts that follow none; what is left is closed.
    let order = (0..count).filter(|&k| !taken[k]).chain(0..count).collect::<Vec<_>>();
    for first in order {
        let mut segments: Vec<PathSegment<V>> = Vec::new();
        let mut at = Some(first);
        let mut closed = false;
        while let Some(k) = at {
            if used[k] {
                closed = k == first;
                break;
            }
            used[k] = true;
            for segment in kept[k].path.segments() {
                let joined = segments.last().map(PathSegment::end);
                segments.push(joined.map_or_else(|| segment.clone(), |end| segment.started(end)));
            }
            at = next[k];
        }
        if closed && let [first, .., last] = &mut segments[..] {
            *last = last.reversed().started(first.start()).reversed();
        }
        paths.extend(Path::new(segments).ok());
    }
    paths
}
