//! How wide the rectangles of a surface may be in each direction, from samples of how much it bends there.
//!
//! Over a rectangle of the widths `h` and `k`, a smooth surface `S` with the unit normal `n` is about that far from its
//! triangles:
//!
//! ```text
//! (|S_uu n| h² + |S_vv n| k²) / 8 + ¾ |S_uv n| h k,
//! ```
//!
//! the last term of which is what the bound of a skew quadrilateral takes. One direction is cut first and gets a share of
//! the tolerance, everywhere along it as much as where it bends most across it. The other one has the rest: where the first
//! direction bends less, its lines are farther apart, or rectangles take two, four, … parts of the first direction at
//! once. Of several shares the one counts that leaves the fewest rectangles.

use alloc::vec::Vec;

use super::flat::{P3, distance_to_segment};
use super::lines::{Lines, WIDTH};
use crate::vector::{cross, dot, length};

/// The number of samples in each direction of a surface with few spans.
const SAMPLES: usize = 12;

/// The fewest and the most samples of a span.
const OF_SPAN: [usize; 2] = [1, 4];

/// The most lines between two knots; halves follow.
const MOST: f64 = 1024.0;

/// What is left of the tolerance for what samples miss.
const MARGIN: f64 = 0.95;

/// The shares of the tolerance that are tried for the first direction.
const SHARES: [f64; 5] = [0.35, 0.45, 0.55, 0.7, 1.0];

/// The shares of the tolerance that are tried for the second direction.
const RESTS: [f64; 5] = [0.3, 0.45, 0.6, 0.75, 0.9];

/// How much the surface bends over one sample.
#[derive(Clone, Copy, Debug, Default)]
struct Bend {
    /// The distances across the surface from the chords along both parameters.
    away: [f64; 2],
    /// The distances in any direction, which count on the sides of rectangles.
    side: [f64; 2],
    /// What the bound of a skew quadrilateral takes.
    twist: f64,
}

/// The samples of one parameter: each lies between two places, with a third one in its middle.
struct Samples {
    places: Vec<u32>,
    of_span: usize,
}

impl Samples {
    fn new(knots: &[u32]) -> Self {
        let of_span = (SAMPLES / (knots.len() + 1)).clamp(OF_SPAN[0], OF_SPAN[1]);
        let ends: Vec<u32> = [0].into_iter().chain(knots.iter().copied()).chain([WIDTH]).collect();
        let steps = 2 * of_span as u64;
        let mut places = alloc::vec![0];
        for ends in ends.windows(2) {
            let width = u64::from(ends[1] - ends[0]);
            places.extend((1..=steps).map(|k| ends[0] + (width * k / steps) as u32));
        }
        Self { places, of_span }
    }

    fn count(&self) -> usize {
        self.places.len() / 2
    }

    /// The lines for a density at each sample, of which those at both ends of the parameter are `narrow` times as far
    /// from these; and how much denser they are for their number to be whole.
    fn lines(&self, density: &[f64], narrow: f64) -> (Vec<u32>, Vec<f64>) {
        let spans = density.len() / self.of_span;
        let (mut lines, mut factors) = (Vec::new(), Vec::new());
        for (index, span) in density.chunks(self.of_span).enumerate() {
            let lost = [index == 0, index + 1 == spans].map(|is_end| if is_end { 1.0 - narrow } else { 0.0 });
            let wanted: f64 = halves(span).sum();
            let parts = parts(wanted, narrow, lost);
            let unit = wanted / (parts - lost[0] - lost[1]);
            factors.push(if parts > 1.0 { 1.0 / unit } else { 1.0 / wanted.max(f64::MIN_POSITIVE) });
            let (mut next, mut sum) = (unit * (1.0 - lost[0]), 0.0);
            let mut left = parts - 1.0;
            for (k, density) in halves(span).enumerate() {
                let half = 2 * index * self.of_span + k;
                let [from, to] = [half, half + 1].map(|at| self.places[at]);
                while left > 0.5 && next <= sum + density {
                    let place = from + (f64::from(to - from) * ((next - sum) / density)) as u32;
                    if place > lines.last().copied().unwrap_or(0) && place < WIDTH {
                        lines.push(place);
                    }
                    next += unit;
                    left -= 1.0;
                }
                sum += density;
            }
        }
        (lines, factors)
    }
}

/// What both halves of all samples of a span have of a density that changes evenly from sample to sample.
fn halves(span: &[f64]) -> impl Iterator<Item = f64> {
    let half = |k: usize, is_upper: bool| {
        let change = match (is_upper, k + 1 < span.len(), k > 0) {
            (true, true, _) => span[k + 1] - span[k],
            (true, false, true) => span[k] - span[k - 1],
            (false, _, true) => span[k - 1] - span[k],
            (false, true, false) => span[k] - span[k + 1],
            _ => 0.0,
        };
        0.5 * (span[k] + 0.25 * change).max(0.5 * span[k])
    };
    (0..span.len()).flat_map(move |k| [half(k, false), half(k, true)])
}

/// The number of parts of a span for a number that need not be whole, of which the parts at ends lose something.
fn parts(wanted: f64, narrow: f64, lost: [f64; 2]) -> f64 {
    let is_end = lost[0] + lost[1] > 0.0;
    // What is not finite is found out later.
    if !wanted.is_finite() || wanted <= if is_end { narrow } else { 1.0 } {
        return 1.0;
    }
    let mut all = wanted + lost[0] + lost[1];
    while all > MOST {
        all *= 0.5;
    }
    let whole = f64::from(all as u32);
    (whole + if all > whole { 1.0 } else { 0.0 }).max(2.0)
}

/// The places of both parameters for a surface with these knots and a tolerance, of which rectangles at edges have less
/// by `reach`; `at` is the surface on the unit square.
pub(in crate::mesh) fn lines(
    knots: [Vec<u32>; 2],
    tolerance: f64,
    reach: f64,
    at: impl Fn([f64; 2]) -> P3,
) -> [Lines; 2] {
    let knots = knots.map(|mut knots| {
        knots.retain(|&knot| knot > 0 && knot < WIDTH);
        knots.sort_unstable();
        knots.dedup();
        knots
    });
    let samples = knots.each_ref().map(|knots| Samples::new(knots));
    let bends = bends(&samples, at);
    let mut best: Option<(f64, [Vec<u32>; 2])> = None;
    for first in [0, 1] {
        let grid = |tolerance: f64, reach: f64| Grid {
            first: &samples[first],
            second: &samples[1 - first],
            bends: &bends,
            axis: first,
            tolerance: MARGIN * tolerance,
            reach,
        };
        let (wide, careful) = (grid(tolerance, reach), grid(tolerance - reach, 0.0));
        for share in SHARES {
            let mut found = wide.lines(share);
            // All rectangles are at edges.
            if found.1.len().min(found.2.len()) < 2 {
                found = careful.lines(share);
            }
            let (needed, lines, others) = found;
            if best.as_ref().is_none_or(|(least, _)| needed < *least) {
                best = Some((needed, if first == 0 { [lines, others] } else { [others, lines] }));
            }
        }
    }
    let [us, vs] = best.map(|(_, lines)| lines).unwrap_or_default();
    let [of_u, of_v] = knots;
    [Lines { knots: of_u, parts: us }, Lines { knots: of_v, parts: vs }]
}

/// The samples with the direction that is cut first.
struct Grid<'a> {
    first: &'a Samples,
    second: &'a Samples,
    /// Those of `u` next to each other.
    bends: &'a [Bend],
    axis: usize,
    tolerance: f64,
    reach: f64,
}

impl Grid<'_> {
    /// The bend at a sample of the first direction and one of the second.
    fn bend(&self, i: usize, j: usize) -> &Bend {
        &self.bends[if self.axis == 0 { j * self.first.count() + i } else { i * self.second.count() + j }]
    }

    /// The number of rectangles, about, and the lines of both directions, if the first one has this share of the
    /// tolerance.
    fn lines(&self, share: f64) -> (f64, Vec<u32>, Vec<u32>) {
        let root = crate::Scalar::sqrt;
        let [first, second] = [self.first.count(), self.second.count()];
        let narrow = |share: f64| root((1.0 - self.reach / (self.tolerance * share)).max(0.25));
        let mut density: Vec<f64> = (0..first)
            .map(|i| {
                let all = (0..second).map(|j| self.bend(i, j));
                let most = all.map(|bend| (bend.away[self.axis] / share).max(bend.side[self.axis]));
                root(most.fold(0.0, f64::max) / self.tolerance)
            })
            .collect();
        let (lines, factors) = self.first.lines(&density, narrow(share));
        for (i, density) in density.iter_mut().enumerate() {
            *density = (*density * factors[i / self.first.of_span]).max(1.0 / self.first.of_span as f64);
        }
        let widths: Vec<f64> = density.iter().map(|density| 1.0 / density).collect();
        let across: Vec<f64> = (0..second).map(|j| self.density(j, &widths)).collect();
        let (others, factors) = self.second.lines(&across, narrow(1.0 - share));
        let needed = across.iter().enumerate().map(|(j, density)| {
            let scaled = (density * factors[j / self.second.of_span]).max(1.0 / self.second.of_span as f64);
            scaled * self.row(j, 1.0 / scaled, &widths)
        });
        (needed.sum(), lines, others)
    }

    /// The number of lines of the second direction over a sample of it that leaves the fewest rectangles.
    fn density(&self, j: usize, widths: &[f64]) -> f64 {
        let other = 1 - self.axis;
        let all = (0..widths.len()).map(|i| self.bend(i, j));
        let most =
            all.map(|bend| bend.side[other].max(bend.away[other])).fold(0.0, f64::max) / self.tolerance;
        let mut best = (f64::INFINITY, 0.0);
        for rest in RESTS {
            let density = crate::Scalar::sqrt(most / rest);
            let capped = density.max(1.0 / self.second.of_span as f64);
            let needed = capped * self.row(j, 1.0 / capped, widths);
            if needed < best.0 {
                best = (needed, density);
            }
        }
        if best.0.is_finite() { best.1 } else { crate::Scalar::sqrt(most / RESTS[0]) }
    }

    /// The number of rectangles in a row as wide as `width` at a sample of the second direction, each of which takes as
    /// many parts of the first direction as the tolerance allows.
    fn row(&self, j: usize, width: f64, widths: &[f64]) -> f64 {
        let other = 1 - self.axis;
        let mut sum = 0.0;
        for (i, &along) in widths.iter().enumerate() {
            let bend = self.bend(i, j);
            let left = self.tolerance - bend.away[other] * width * width;
            let fits = |along: f64| {
                bend.away[self.axis] * along * along + bend.twist * along * width <= left
                    && bend.side[self.axis] * along * along <= self.tolerance
            };
            let (mut along, mut more) = (along, 1.0);
            if fits(along) {
                while along < widths.len() as f64 && fits(2.0 * along) {
                    along *= 2.0;
                }
            } else {
                while !fits(along) {
                    if more > 2.0 {
                        return f64::INFINITY;
                    }
                    // Halves that are not in all rows give corners to neighbours.
                    more *= 1.3;
                    along *= 0.5;
                }
            }
            sum += more / along;
        }
        sum
    }
}

/// How much the surface bends at all samples, those of `u` next to each other.
fn bends([us, vs]: &[Samples; 2], at: impl Fn([f64; 2]) -> P3) -> Vec<Bend> {
    let unit = |place: u32| f64::from(place) / f64::from(WIDTH);
    let row = |v: u32| us.places.iter().map(|&u| at([unit(u), unit(v)])).collect::<Vec<P3>>();
    let mut low = row(0);
    let mut all = Vec::with_capacity(us.count() * vs.count());
    for places in vs.places[1..].chunks_exact(2) {
        let [middle, high] = [0, 1].map(|k| row(places[k]));
        for k in (1..us.places.len()).step_by(2) {
            all.push(bend([&low, &middle, &high].map(|row| [row[k - 1], row[k], row[k + 1]])));
        }
        low = high;
    }
    all
}

/// From nine points, those of a row along `u` next to each other.
fn bend(p: [[P3; 3]; 3]) -> Bend {
    let minus = |a: P3, b: P3| [0, 1, 2].map(|c| a[c] - b[c]);
    let normal = cross(minus(p[1][2], p[1][0]), minus(p[2][1], p[0][1]));
    let size = length(normal);
    let away = |x: P3| if size > 0.0 { (dot(x, normal) / size).abs() } else { length(x) };
    let sag = |a: P3, b: P3, c: P3| [0, 1, 2].map(|k| b[k] - 0.5 * (a[k] + c[k]));
    let twist = minus(minus(p[2][2], p[2][0]), minus(p[0][2], p[0][0]));
    let [u, v] = [[p[1][0], p[1][1], p[1][2]], [p[0][1], p[1][1], p[2][1]]];
    let found = Bend {
        away: [u, v].map(|[a, b, c]| away(sag(a, b, c))),
        side: [u, v].map(|[a, b, c]| distance_to_segment(b, a, c)),
        twist: 0.75 * away(twist),
    };
    // What is not finite is found out later.
    let is_finite = [found.away, found.side].iter().flatten().chain([&found.twist]).all(|x| x.is_finite());
    if is_finite { found } else { Bend::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A trough needs parts in one direction only, `sqrt(bend / tolerance)` of them.
    #[test]
    fn as_many_parts_as_are_needed() {
        let trough = |[u, _]: [f64; 2]| [u, 0.0, 4.0 * u * u];
        for (tolerance, least) in [(0.1, 3), (0.02, 7), (0.01, 10)] {
            let [along, across] = lines([Vec::new(), Vec::new()], tolerance, 0.0, trough);
            let found = along.parts.len() + 1;
            assert!(found >= least && found <= least + least / 2 + 1, "{found} for {tolerance}");
            assert!(across.parts.is_empty());
        }
        let endless = lines([Vec::new(), Vec::new()], 0.1, 0.0, |_| [f64::NAN; 3]);
        assert!(endless.iter().all(|lines| lines.parts.is_empty()));
    }
}
