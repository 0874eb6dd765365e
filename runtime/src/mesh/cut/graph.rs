//! How far triangles over a rectangle of parameters are from the surface over it, both ways, also where they bend.
//!
//! In the direction `n`, across all triangles, these are the graph of a function `g` over a polygon `Q` of a plane, which
//! is `gₖ` on the triangle `k`, and nowhere steeper than `L`. A point of the surface is at a height `z` over a point `x`.
//!
//! - From the surface to the triangles: with the distance `h` of `x` from a convex `Q`, a point is no farther away than
//!   `√(h² + (z - g)²) + L h`. As `g` is one of the `gₖ` everywhere, `z - g ≤ max (z - gₖ)`, which makes this a convex
//!   function: the largest value at a control point is a bound. If no corner is higher than `w` above the plane of any
//!   triangle, `g ≤ gₖ + w`, so that `g - z ≤ (gₖ - z) + w` for each `k`; and the other way round.
//! - From the triangles to the surface: a point of `Q` with one of the surface above or below it is done with. All others
//!   lie between a side of `Q` and the curve along it, on a line from a point of the curve to the nearest one of the
//!   side, since the surface covers what its boundary goes around. With the distance `d` of these two, which is a convex
//!   function too, the triangles there are no farther from the curve than `(1 + L) d`.

use alloc::vec::Vec;

use super::flat::{P3, Part, distance, distance_to_segment, dot, larger, minus, quarters};
use crate::vector::cross;

/// The steepest triangles for which the bound is of use.
const STEEPEST: f64 = 0.5;

/// What is no area, beside the largest one, and no length, beside the largest one.
const TINY: f64 = 1e-12;

/// A corner of the polygon over a rectangle, with its parameters.
pub(in crate::mesh) struct Corner {
    pub(in crate::mesh) point: P3,
    pub(in crate::mesh) at: [f64; 2],
    /// Whether it is a corner of a neighbour, within a side, and not one of the rectangle.
    pub(in crate::mesh) is_on_side: bool,
}

/// The plane of a triangle as heights above it.
struct Plane {
    from: P3,
    /// Across the triangle, as long as the heights ask for.
    across: P3,
}

impl Plane {
    fn height(&self, p: P3) -> f64 {
        dot(minus(p, self.from), self.across)
    }
}

/// The triangles as a graph over a plane.
struct Graph {
    axes: [P3; 2],
    planes: Vec<Plane>,
    steepest: f64,
    /// How high corners are above and below the planes of other triangles.
    apart: [f64; 2],
    /// A convex polygon with that of the triangles in it, and how far it is from that one.
    hull: Vec<[f64; 2]>,
    inwards: f64,
}

/// A bound of the distance, both ways, for the parts of the surface, cut at all corners, and the corners in
/// counter-clockwise order, which lie on the surface; `None` if the triangles are no
/// graph, or too steep for a bound.
pub(in crate::mesh) fn bound(
    parts: &[Part],
    corners: &[Corner],
    triangles: &[[P3; 3]],
    weld: f64,
) -> Option<f64> {
    let graph = Graph::new(corners, triangles)?;
    let (mut farthest, mut outside, mut aside) = (0.0_f64, 0.0_f64, 0.0_f64);
    let parts: Vec<Part> = parts.iter().flat_map(quarters).collect();
    for part in &parts {
        let (away, out) = graph.farthest(part);
        farthest = larger(farthest, away);
        outside = larger(outside, out);
    }
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for part in &parts {
        for (axis, range) in ranges.iter_mut().enumerate() {
            let [lo, hi] = part.span(axis);
            *range = [range[0].min(lo), range[1].max(hi)];
        }
    }
    for (k, from) in corners.iter().enumerate() {
        let to = &corners[(k + 1) % corners.len()];
        aside = larger(aside, beside(&parts, ranges, [from, to], weld));
    }
    let lean = graph.steepest;
    Some(larger(farthest + lean * outside, (1.0 + lean) * aside))
}

/// How far the control points along a side are from it.
fn beside(parts: &[Part], ranges: [[f64; 2]; 2], [from, to]: [&Corner; 2], weld: f64) -> f64 {
    // The side has the same value of one parameter at both ends.
    let axis = usize::from(from.at[0] == to.at[0]);
    let [lo, hi] = [from.at[axis].min(to.at[axis]), from.at[axis].max(to.at[axis])];
    let range = ranges[1 - axis];
    let is_end = from.at[1 - axis] > 0.5 * (range[0] + range[1]);
    let mut farthest = 0.0_f64;
    for part in parts {
        let ([start, end], across) = (part.span(axis), part.span(1 - axis));
        let middle = 0.5 * (start + end);
        let is_on_side = if is_end { across[1] >= range[1] } else { across[0] <= range[0] };
        if is_on_side && middle >= lo && middle <= hi {
            for p in part.side(axis, is_end) {
                farthest = larger(farthest, distance_to_segment(p, from.point, to.point));
            }
        }
    }
    // A curve that comes back to where it began is no point.
    if distance(from.point, to.point) <= weld && farthest > weld { f64::INFINITY } else { farthest }
}

impl Graph {
    fn new(corners: &[Corner], triangles: &[[P3; 3]]) -> Option<Self> {
        let areas: Vec<P3> = triangles.iter().map(|&[a, b, c]| cross(minus(b, a), minus(c, a))).collect();
        let sum = areas.iter().fold([0.0; 3], |sum, area| [0, 1, 2].map(|c| sum[c] + area[c]));
        let size = distance(sum, [0.0; 3]);
        if !(size > 0.0 && size.is_finite()) {
            return None;
        }
        let normal = sum.map(|c| c / size);
        let mut planes = Vec::with_capacity(triangles.len());
        let mut steepest = 0.0_f64;
        for (&area, triangle) in areas.iter().zip(triangles) {
            // A side of a triangle may be one point, where a surface has a pole.
            if distance(area, [0.0; 3]) <= TINY * size {
                continue;
            }
            let up = dot(area, normal);
            let slope = distance(cross(area, normal), [0.0; 3]) / up;
            if !(up > 0.0 && slope <= STEEPEST) {
                return None;
            }
            steepest = steepest.max(slope);
            planes.push(Plane { from: triangle[0], across: area.map(|c| c / up) });
        }
        let mut apart = [0.0_f64; 2];
        for plane in &planes {
            for p in triangles.iter().flatten() {
                let height = plane.height(*p);
                apart = [larger(apart[0], height), larger(apart[1], -height)];
            }
        }
        let long = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let least = (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))?;
        let first = cross(normal, long[least]);
        let unit = distance(first, [0.0; 3]);
        let first = first.map(|c| c / unit);
        let axes = [first, cross(normal, first)];
        let (hull, inwards) = hull(corners, &axes)?;
        Some(Self { axes, planes, steepest, apart, hull, inwards })
    }

    /// The largest distance of the control points of a part, but for what steep triangles add to it, and the largest one
    /// from the polygon.
    fn farthest(&self, part: &Part) -> (f64, f64) {
        let points: Vec<(P3, f64)> =
            part.points().map(|p| (p, self.inwards + self.outside(flat(p, &self.axes)))).collect();
        let outside = points.iter().fold(0.0, |outside, &(_, out)| larger(outside, out));
        let far = |sign: f64, of: &dyn Fn(P3) -> f64| {
            points.iter().fold(0.0, |farthest, &(p, out)| {
                let height = (sign * of(p)).max(0.0);
                larger(farthest, crate::Scalar::sqrt(out * out + height * height))
            })
        };
        let side = |sign: f64, apart: f64| {
            let highest = |p: P3| {
                self.planes.iter().map(|plane| sign * plane.height(p)).fold(f64::NEG_INFINITY, larger)
            };
            let of_all = far(1.0, &highest);
            let of_one = |plane: &Plane| far(sign, &|p| plane.height(p)) + apart;
            self.planes.iter().map(of_one).fold(of_all, f64::min)
        };
        (larger(side(1.0, self.apart[1]), side(-1.0, self.apart[0])), outside)
    }

    /// The distance from the polygon of a point of the plane.
    fn outside(&self, x: [f64; 2]) -> f64 {
        let sides = || self.hull.iter().zip(self.hull.iter().cycle().skip(1));
        if sides().all(|(&a, &b)| turn(a, b, x) >= 0.0) {
            return 0.0;
        }
        let lift = |[x, y]: [f64; 2]| [x, y, 0.0];
        sides().map(|(&a, &b)| distance_to_segment(lift(x), lift(a), lift(b))).fold(f64::INFINITY, f64::min)
    }
}

fn flat(p: P3, axes: &[P3; 2]) -> [f64; 2] {
    axes.map(|axis| dot(p, axis))
}

/// Twice the area of a triangle, positive counter-clockwise.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// The polygon without corners that lie inwards of their sides, and how far these do; `None` if it is not convex.
fn hull(corners: &[Corner], axes: &[P3; 2]) -> Option<(Vec<[f64; 2]>, f64)> {
    let points: Vec<[f64; 2]> = corners.iter().map(|corner| flat(corner.point, axes)).collect();
    let count = points.len();
    let ends = |k: usize| {
        let before = (1..=count).map(|n| (k + count - n) % count).find(|&n| !corners[n].is_on_side)?;
        let after = (1..=count).map(|n| (k + n) % count).find(|&n| !corners[n].is_on_side)?;
        Some([before, after])
    };
    let (mut hull, mut inwards) = (Vec::with_capacity(count), 0.0_f64);
    for k in 0..count {
        let [before, after] = ends(k)?;
        if corners[k].is_on_side && turn(points[before], points[after], points[k]) > 0.0 {
            let side = [corners[before].point, corners[after].point];
            inwards = larger(inwards, distance_to_segment(corners[k].point, side[0], side[1]));
        } else {
            hull.push(points[k]);
        }
    }
    let size = hull.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    hull.dedup_by(|a, b| (a[0] - b[0]).abs().max((a[1] - b[1]).abs()) <= TINY * size);
    let count = hull.len();
    let is_convex = (0..count)
        .all(|k| turn(hull[k], hull[(k + 1) % count], hull[(k + 2) % count]) >= -TINY * size * size);
    is_convex.then_some((hull, inwards))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SurfacePiece;
    use crate::mesh::cut::flat;

    /// A square of which one side is a parabola with its tip above and outside of the middle, and three triangles that
    /// meet at the tip: their bound, and the largest distance of samples of the surface.
    fn tent(height: f64, outwards: f64) -> (Option<f64>, f64) {
        let points: [P3; 6] = [
            [0.0; 3],
            [0.0, 1.0, 0.0],
            [0.5, -2.0 * outwards, 2.0 * height],
            [0.5, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
        ];
        let pieces = [SurfacePiece::polynomial([[0.0, 1.0]; 2], 3, &points).unwrap()];
        let [mut parts, after] = flat::cut(&pieces, flat::whole(&pieces, [[0.0, 1.0]; 2]), 0, 0.5);
        parts.extend(after);
        let corner = |x: f64, y: f64| Corner { point: [x, y, 0.0], at: [x, y], is_on_side: false };
        let [a, b, c, d] = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        let tip = Corner { point: [0.5, -outwards, height], at: [0.5, 0.0], is_on_side: true };
        let triangles = [[b.point, c.point], [c.point, d.point], [d.point, a.point]]
            .map(|[from, to]| [tip.point, from, to]);
        let mut farthest = 0.0_f64;
        for (k, l) in (0..=32).flat_map(|k| (0..=32).map(move |l| (k, l))) {
            let [u, v] = [k, l].map(|k| f64::from(k) / 32.0);
            let raised = 4.0 * u * (1.0 - u) * (1.0 - v);
            let p = [u, v - outwards * raised, height * raised];
            let away = triangles.map(|[a, b, c]| flat::distance_to_triangles(p, [a, b, c, c]));
            farthest = farthest.max(away.into_iter().fold(f64::INFINITY, f64::min));
        }
        (bound(&parts, &[a, tip, b, c, d], &triangles, 1e-9), farthest)
    }

    #[test]
    fn triangles_that_meet_at_a_corner_of_a_neighbour() {
        for (height, outwards) in
            [(0.1, 0.0), (-0.1, 0.0), (0.0, 0.1), (0.0, -0.1), (0.06, 0.08), (0.05, -0.1)]
        {
            let (found, farthest) = tent(height, outwards);
            let found = found.unwrap();
            let moved = crate::Scalar::sqrt(height * height + outwards * outwards);
            assert!(
                found >= farthest && found <= 1.2 * moved,
                "{found}, {farthest} for {height}, {outwards}"
            );
        }
        assert!(tent(0.0, 0.0).0.unwrap() < 1e-15);
    }

    #[test]
    fn no_bound_of_triangles_that_are_too_steep() {
        assert_eq!(tent(2.0, 0.0).0, None);
        assert_eq!(tent(f64::NAN, 0.0).0, None);
    }
}
