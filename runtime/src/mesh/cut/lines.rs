//! Where a parameter is cut: at knots first, then at lines, then into halves.
//!
//! At a knot the curvature of a surface may jump, or there may be a crease. Between knots the tolerance asks for some
//! number of parts; halves alone would round that number up to a power of two, in both directions, and make up to four
//! times too many rectangles. All rectangles are cut at the same places, so that neighbours meet.

use alloc::vec::Vec;

/// The width of the parameter square: parameters are whole numbers, so that equal ones are recognised. Single precision
/// holds it, and 3, 5, 7 and 9 equal spans begin at whole numbers.
pub(in crate::mesh) const WIDTH: u32 = (1 << 14) * 9 * 5 * 7;

/// The places of one parameter, in increasing order.
#[derive(Debug, Default)]
pub(in crate::mesh) struct Lines {
    pub(in crate::mesh) knots: Vec<u32>,
    pub(in crate::mesh) parts: Vec<u32>,
}

impl Lines {
    /// The place at which a range is cut: of the knots within the one nearest to its middle, or else of the lines the
    /// one with as many before as after it, or else the middle.
    pub(in crate::mesh) fn between(&self, from: u32, to: u32) -> u32 {
        let middle = from + (to - from) / 2;
        let inside = |places: &[u32]| {
            let start = places.partition_point(|&place| place <= from);
            let end = places.partition_point(|&place| place < to);
            start..end.max(start)
        };
        let knots = &self.knots[inside(&self.knots)];
        let after = knots.partition_point(|&knot| knot <= middle);
        let near = &knots[after.saturating_sub(1)..(after + 1).min(knots.len())];
        let parts = &self.parts[inside(&self.parts)];
        let knot = near.iter().copied().min_by_key(|knot| knot.abs_diff(middle));
        knot.or_else(|| parts.get(parts.len() / 2).copied()).unwrap_or(middle)
    }

    /// Whether a range has a place of its own at which it is cut.
    pub(in crate::mesh) fn cross(&self, from: u32, to: u32) -> bool {
        [&self.knots, &self.parts].into_iter().any(|places| {
            let next = places.partition_point(|&place| place <= from);
            places.get(next).is_some_and(|&place| place < to)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cut_at_knots_then_in_parts_then_in_halves() {
        let lines = Lines { knots: alloc::vec![300, 600], parts: alloc::vec![100, 200, 400, 500] };
        assert_eq!(lines.between(0, WIDTH), 600);
        assert_eq!(lines.between(0, 600), 300);
        assert_eq!(lines.between(0, 300), 200);
        assert_eq!(lines.between(0, 200), 100);
        assert_eq!(lines.between(200, 300), 250);
        assert_eq!(lines.between(600, 601), 600);
        assert!(lines.cross(50, 101) && lines.cross(250, 301));
        assert!(!lines.cross(100, 200) && !lines.cross(600, WIDTH));
    }
}
