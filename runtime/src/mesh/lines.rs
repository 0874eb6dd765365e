//! Where a parameter is cut: at knots first, then into equal parts, then into halves.
//!
//! At a knot the curvature of a surface may jump, or there may be a crease. Between knots the tolerance asks for some
//! number of equal parts; halves alone would round that number up to a power of two, in both directions, and make up to
//! four times too many rectangles. All rectangles are cut at the same places, so that neighbours meet.

use alloc::vec::Vec;

use super::flat::{P3, distance_to_segment};

/// The width of the parameter square: parameters are whole numbers, so that equal ones are recognised. Single precision
/// holds it, and 3, 5, 7 and 9 equal spans begin at whole numbers.
pub(super) const WIDTH: u32 = (1 << 14) * 9 * 5 * 7;

/// The number of equal parts of a span over which the bend is sampled.
const PARTS: usize = 8;

/// The number of lines across which a bend is sampled.
const ACROSS: usize = 9;

/// The number of equal parts from which on halves follow: the number of parts is then too high by a ninth at most.
const FEW: f64 = 8.0;

/// The places of one parameter, in increasing order.
#[derive(Debug, Default)]
pub(super) struct Lines {
    knots: Vec<u32>,
    parts: Vec<u32>,
}

impl Lines {
    fn new(knots: Vec<u32>, counts: Vec<[u32; 2]>) -> Self {
        let parts = spans(&knots).zip(counts).flat_map(|([from, to], [parts, _])| {
            let place = move |k: u32| u64::from(to - from) * u64::from(k) / u64::from(parts);
            (1..parts).map(move |k| from + place(k) as u32)
        });
        let parts = parts.collect();
        Self { knots, parts }
    }

    /// The place at which a range is cut: the one nearest to its middle of the knots within, or else of the parts, or
    /// else the middle.
    pub(super) fn between(&self, from: u32, to: u32) -> u32 {
        let middle = from + (to - from) / 2;
        let nearest = |places: &[u32]| {
            let after = places.partition_point(|&place| place <= middle);
            let near = after.saturating_sub(1)..(after + 1).min(places.len());
            let inside = places[near].iter().copied().filter(|&place| place > from && place < to);
            inside.min_by_key(|place| place.abs_diff(middle))
        };
        nearest(&self.knots).or_else(|| nearest(&self.parts)).unwrap_or(middle)
    }
}

/// The places of both parameters for a surface with these knots and a tolerance, of which rectangles at edges have less
/// by `reach`; `at` is the surface on the unit square.
pub(super) fn lines(
    knots: [Vec<u32>; 2],
    tolerance: f64,
    reach: f64,
    at: impl Fn([f64; 2]) -> P3,
) -> [Lines; 2] {
    let [us, vs] = knots.map(|mut knots| {
        knots.retain(|&knot| knot > 0 && knot < WIDTH);
        knots.sort_unstable();
        knots.dedup();
        knots
    });
    let bends = [bends(&us, 0, &at), bends(&vs, 1, &at)];
    let careful = counts(&bends, tolerance - reach);
    let [m, n] = careful.each_ref().map(|counts| counts.iter().map(|&count| all(count)).sum::<f64>());
    // Either all rectangles are a little smaller than they need be, or those at edges are cut once more.
    let more_inside = m * n * reach / tolerance;
    let [of_u, of_v] = if more_inside > 2.0 * (m + n) { counts(&bends, tolerance) } else { careful };
    [Lines::new(us, of_u), Lines::new(vs, of_v)]
}

/// The numbers of parts, and of halves of them, of all spans in both directions.
///
/// Both directions share the tolerance. Least rectangles are left if they share it equally; but where the flatter
/// direction needs less, as its number of parts is whole, the other one may have the rest.
fn counts(bends: &[Vec<f64>; 2], tolerance: f64) -> [Vec<[u32; 2]>; 2] {
    let [u, v] = bends.each_ref().map(|bends| bends.iter().copied().fold(0.0, f64::max));
    let is_v_flatter = v < u;
    let [flatter, other] = if is_v_flatter { [&bends[1], &bends[0]] } else { [&bends[0], &bends[1]] };
    let first: Vec<[u32; 2]> = flatter.iter().map(|&bend| count(bend, 0.5 * tolerance)).collect();
    let left = flatter.iter().zip(&first).map(|(bend, &count)| tolerance - bend / (all(count) * all(count)));
    let left = left.fold(tolerance, f64::min);
    let second = other.iter().map(|&bend| count(bend, left)).collect();
    if is_v_flatter { [second, first] } else { [first, second] }
}

/// The number of halves of all parts.
fn all([parts, halves]: [u32; 2]) -> f64 {
    f64::from(parts) * f64::from(halves)
}

/// Parts and halves of them for a span that is as far from its chord as `bend`, if no part may be farther from its own
/// than `share`. The distance falls with the square of the number of parts.
fn count(bend: f64, share: f64) -> [u32; 2] {
    let mut parts = crate::Scalar::sqrt(bend / share);
    let mut halves = 1;
    while parts > 2.0 * FEW && halves < WIDTH {
        parts *= 0.5;
        halves *= 2;
    }
    // What is not finite is found out later.
    if !(parts > 1.0 && parts <= 2.0 * FEW) {
        return [1, halves];
    }
    // A number that is not whole is rounded up.
    let whole = parts as u32;
    [whole + u32::from(parts > f64::from(whole)), halves]
}

fn spans(knots: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    let starts = core::iter::once(0).chain(knots.iter().copied());
    starts.zip(knots.iter().copied().chain(core::iter::once(WIDTH))).map(|(from, to)| [from, to])
}

/// The distance of each span from its chord, if it bent everywhere as much as where it bends most.
fn bends(knots: &[u32], axis: usize, at: &impl Fn([f64; 2]) -> P3) -> Vec<f64> {
    let unit = |place: u32| f64::from(place) / f64::from(WIDTH);
    let span = |[from, to]: [u32; 2]| {
        let (from, to) = (unit(from), unit(to));
        let line = |across: f64| {
            let point = |k: usize| {
                let mut x = [across; 2];
                x[axis] = from + (to - from) * (k as f64 / (2 * PARTS) as f64);
                at(x)
            };
            let points: Vec<P3> = (0..=2 * PARTS).map(point).collect();
            let away =
                (0..PARTS).map(|k| distance_to_segment(points[2 * k + 1], points[2 * k], points[2 * k + 2]));
            away.fold(0.0, f64::max)
        };
        let across = (0..ACROSS).map(|k| line(k as f64 / (ACROSS - 1) as f64));
        // A little more, as the samples may miss the place where it bends most.
        1.03 * across.fold(0.0, f64::max) * (PARTS * PARTS) as f64
    };
    spans(knots).map(span).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cut_at_knots_then_in_parts_then_in_halves() {
        let lines = Lines { knots: alloc::vec![300, 600], parts: alloc::vec![100, 200, 400, 500] };
        assert_eq!(lines.between(0, WIDTH), 600);
        assert_eq!(lines.between(0, 600), 300);
        assert_eq!(lines.between(0, 300), 100);
        assert_eq!(lines.between(100, 300), 200);
        assert_eq!(lines.between(200, 300), 250);
        assert_eq!(lines.between(600, 601), 600);
    }

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
