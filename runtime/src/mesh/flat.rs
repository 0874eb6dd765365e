//! How far two triangles over a rectangle of parameters are from the surface over it, both ways, from control points.
//!
//! With the corners `a = S(u0, v0)`, `b = S(u1, v0)`, `c = S(u1, v1)`, `d = S(u0, v1)`, the diagonals `ac` and `bd` and
//! a bound `t` of how far the four are from a flat, convex quadrilateral `K`:
//!
//! - The distance from `K` is a convex function, so that the surface is nowhere farther from `K` than a control point.
//! - The nearest point of `K` is a continuous function of the point of the surface. Every point of `K` is its value
//!   somewhere, but for those between a side and the curve along it; these are no farther from the curve than its
//!   control points are from the side.
//!
//! So with the largest distance of the control points from the triangles, or from the side to which they belong, plus
//! `t`, every point of the surface is that near to the triangles, and every point of these to the surface. Nothing is
//! said about parameters: a surface whose points move in its own plane needs no more triangles for that.

use alloc::vec::Vec;

use crate::SurfacePiece;
use crate::surface::nearest::Piece;

/// A point in double precision.
pub(super) type P3 = [f64; 3];

/// A part of a piece over a rectangle.
#[derive(Clone)]
pub(super) struct Part {
    /// The index of its piece.
    piece: usize,
    /// The rectangle in the parameters of the surface.
    span: [[f64; 2]; 2],
    /// The rectangle in the unit square of the piece.
    place: [[f64; 2]; 2],
    net: Piece,
}

impl Part {
    /// A control point; NaN if its weight is not positive.
    fn point(&self, i: usize, j: usize) -> P3 {
        let weight = self.net.weight(j * (self.net.degrees()[0] + 1) + i);
        let p = self.net.point(i, j);
        if weight > 0.0 { [0, 1, 2].map(|k| p[k] / weight) } else { [f64::NAN; 3] }
    }
}

/// The pieces of a surface that overlap ranges of both parameters, not cut yet.
pub(super) fn whole(pieces: &[SurfacePiece], ranges: [[f64; 2]; 2]) -> Vec<Part> {
    let is_outside = |piece: &SurfacePiece| {
        [0, 1].into_iter().any(|axis| {
            let ([lo, hi], [from, to]) = (piece.domain[axis], ranges[axis]);
            lo >= to || hi <= from
        })
    };
    let part = |(index, piece): (usize, &SurfacePiece)| Part {
        piece: index,
        span: piece.domain,
        place: [[0.0, 1.0]; 2],
        net: piece.net.clone(),
    };
    pieces.iter().enumerate().filter(|(_, piece)| !is_outside(piece)).map(part).collect()
}

/// The parts below and above a parameter.
pub(super) fn cut(pieces: &[SurfacePiece], parts: Vec<Part>, axis: usize, t: f64) -> [Vec<Part>; 2] {
    let (mut before, mut after) = (Vec::new(), Vec::new());
    for part in parts {
        let [lo, hi] = part.span[axis];
        let [from, to] = part.place[axis];
        let at = (pieces[part.piece].place(axis, t) - from) / (to - from);
        if t >= hi || at >= 1.0 {
            before.push(part);
        } else if t <= lo || at <= 0.0 {
            after.push(part);
        } else {
            let middle = from + (to - from) * at;
            let halves = [(0.0, at, [lo, t], [from, middle]), (at, 1.0, [t, hi], [middle, to])];
            let [low, high] = halves.map(|(from, to, span, place)| {
                let mut half = Part { net: part.net.restricted(axis, from, to), ..part };
                half.span[axis] = span;
                half.place[axis] = place;
                half
            });
            before.push(low);
            after.push(high);
        }
    }
    [before, after]
}

/// How far a flat piece may be from the surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flatness {
    /// How much the curves along each parameter bend, which says where to cut.
    pub(super) bends: [f64; 2],
    /// A bound of the distance of the two triangles from the surface, both ways.
    pub(super) distance: f64,
}

/// What nine points say, those in the middle of the sides and of the rectangle among them: how much the surface bends,
/// and how far it is at least from the triangles. `at` takes halves of the rectangle, from 0 to 2.
pub(super) fn sampled(corners: [P3; 4], at: impl Fn([u32; 2]) -> P3) -> Flatness {
    let [a, b, c, d] = corners;
    let [low, high, left, right] = [[1, 0], [1, 2], [0, 1], [2, 1]].map(&at);
    let middle = at([1, 1]);
    let along_u = larger(distance_to_segment(low, a, b), distance_to_segment(high, d, c));
    let along_v = larger(distance_to_segment(left, a, d), distance_to_segment(right, b, c));
    let away = distance_to_triangles(middle, corners);
    Flatness {
        bends: [
            larger(along_u, distance_to_segment(middle, left, right)),
            larger(along_v, distance_to_segment(middle, low, high)),
        ],
        distance: larger(larger(along_u, along_v), away),
    }
}

/// The bound for the triangles with these corners, `[a, b, c, d]` counter-clockwise from the lower ends of both
/// parameters. Sides whose ends are nearer than `weld` count as points, if the curves along them are.
pub(super) fn measure(parts: &[Part], corners: [P3; 4], tolerance: f64, weld: f64) -> Flatness {
    let skewness = skewness(corners);
    let mut found = estimate(parts, corners, weld);
    found.distance += skewness;
    // The hull of the control points of halves is much nearer to the surface.
    if found.distance > tolerance && skewness < tolerance && found.distance <= 4.0 * tolerance {
        let halves: Vec<Part> = parts.iter().flat_map(quarters).collect();
        found.distance = found.distance.min(estimate(&halves, corners, weld).distance + skewness);
    }
    if found.distance > tolerance {
        for part in parts {
            bend(part, &mut found.bends);
        }
    }
    found
}

/// How much the rows of control points of a part bend in each direction.
fn bend(part: &Part, bends: &mut [f64; 2]) {
    let [m, n] = part.net.degrees();
    for j in 0..=n {
        for i in 0..=m {
            let p = part.point(i, j);
            if i > 0 && i < m {
                bends[0] = larger(bends[0], distance_to_segment(p, part.point(0, j), part.point(m, j)));
            }
            if j > 0 && j < n {
                bends[1] = larger(bends[1], distance_to_segment(p, part.point(i, 0), part.point(i, n)));
            }
        }
    }
}

/// The halves in both directions of a part.
fn quarters(part: &Part) -> Vec<Part> {
    let mut all = alloc::vec![part.clone()];
    for axis in [0, 1] {
        if part.net.degrees()[axis] < 2 {
            continue;
        }
        all = all
            .into_iter()
            .flat_map(|part| {
                let [lo, hi] = part.span[axis];
                let middle = 0.5 * (lo + hi);
                let mut nets = part.net.halved(axis).into_iter();
                [[lo, middle], [middle, hi]].map(|span| {
                    let mut half =
                        Part { net: nets.next().unwrap_or_else(|| part.net.clone()), ..part.clone() };
                    half.span[axis] = span;
                    half
                })
            })
            .collect();
    }
    all
}

fn estimate(parts: &[Part], corners: [P3; 4], weld: f64) -> Flatness {
    let mut bends = [0.0_f64; 2];
    let mut farthest = 0.0_f64;
    let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for part in parts {
        for axis in [0, 1] {
            low[axis] = low[axis].min(part.span[axis][0]);
            high[axis] = high[axis].max(part.span[axis][1]);
        }
    }
    let [a, b, c, d] = corners;
    for part in parts {
        let [m, n] = part.net.degrees();
        // The sides of the rectangle on which the part lies: along u at both ends of v, along v at both ends of u.
        let on_side = [
            part.span[1][0] <= low[1],
            part.span[1][1] >= high[1],
            part.span[0][0] <= low[0],
            part.span[0][1] >= high[0],
        ];
        let sides = [[a, b], [d, c], [a, d], [b, c]];
        for j in 0..=n {
            for i in 0..=m {
                let p = part.point(i, j);
                let is_on = [j == 0, j == n, i == 0, i == m];
                let mut is_inside = true;
                for side in 0..4 {
                    if on_side[side] && is_on[side] {
                        // The side belongs to the triangles, so that these are no farther away.
                        is_inside = false;
                        let [from, to] = sides[side];
                        let away = distance_to_segment(p, from, to);
                        farthest = larger(farthest, away);
                        let axis = side / 2;
                        bends[axis] = larger(bends[axis], away);
                        // A curve that comes back to where it began is no point.
                        if distance(from, to) <= weld && away > weld {
                            bends[axis] = f64::INFINITY;
                            farthest = f64::INFINITY;
                        }
                    }
                }
                if is_inside {
                    farthest = larger(farthest, distance_to_triangles(p, corners));
                }
            }
        }
    }
    Flatness { bends, distance: farthest }
}

/// How far four corners are from a flat, convex quadrilateral with them as corners: the distance of the diagonals where
/// they cross, and twice their distance where they do not.
fn skewness([a, b, c, d]: [P3; 4]) -> f64 {
    let (p, q, r) = (minus(c, a), minus(d, b), minus(a, b));
    let (pp, pq, qq, pr, qr) = (dot(p, p), dot(p, q), dot(q, q), dot(p, r), dot(q, r));
    let determinant = pp * qq - pq * pq;
    let clamp = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) };
    let margin = 1e-9;
    if determinant > 1e-20 * pp * qq {
        let (x, y) = ((pq * qr - qq * pr) / determinant, (pp * qr - pq * pr) / determinant);
        let inside = |x: f64| x >= -margin && x <= 1.0 + margin;
        if inside(x) && inside(y) {
            return gap(a, p, clamp(x), b, q, clamp(y));
        }
    }
    // The nearest points of two segments that do not cross: an end of one of them is among them.
    let ends = [
        (0.0, clamp(qr / qq)),
        (1.0, clamp((qr + pq) / qq)),
        (clamp(-pr / pp), 0.0),
        (clamp((pq - pr) / pp), 1.0),
    ];
    2.0 * ends.into_iter().map(|(x, y)| gap(a, p, x, b, q, y)).fold(f64::INFINITY, f64::min)
}

fn gap(a: P3, p: P3, x: f64, b: P3, q: P3, y: f64) -> f64 {
    distance([0, 1, 2].map(|k| a[k] + x * p[k]), [0, 1, 2].map(|k| b[k] + y * q[k]))
}

/// How far the corners of neighbours move the triangles: the largest distance of a corner on a side from its place
/// there, where corners keep their order; `[from, corners…, to]`.
pub(super) fn displacement(side: &[P3]) -> f64 {
    let [from, between @ .., to] = side else { return 0.0 };
    let chord = minus(*to, *from);
    let square = dot(chord, chord);
    let (mut last, mut largest) = (0.0_f64, 0.0_f64);
    for &corner in between {
        // Not a number where the coordinates are huge; then the distance is infinite.
        let share = dot(minus(corner, *from), chord) / square;
        let x = if square > 0.0 && !share.is_nan() { share.clamp(last, 1.0) } else { last };
        last = x;
        largest = larger(largest, distance(corner, [0, 1, 2].map(|k| from[k] + x * chord[k])));
    }
    largest
}

/// The larger one; NaN, once met, is infinite.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || a.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn minus(a: P3, b: P3) -> P3 {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: P3, b: P3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn distance(a: P3, b: P3) -> f64 {
    crate::vector::distance(a, b)
}

pub(super) fn distance_to_segment(p: P3, from: P3, to: P3) -> f64 {
    distance(p, foot(p, from, to))
}

/// The point of a segment that is nearest to a point.
pub(super) fn foot(p: P3, from: P3, to: P3) -> P3 {
    let chord = minus(to, from);
    let x = dot(minus(p, from), chord) / dot(chord, chord);
    // Also where the chord has no length.
    if x <= 0.0 || x.is_nan() {
        return from;
    }
    if x >= 1.0 {
        return to;
    }
    [0, 1, 2].map(|k| from[k] + x * chord[k])
}

/// The distance from the triangles `abc` and `acd`.
pub(super) fn distance_to_triangles(p: P3, [a, b, c, d]: [P3; 4]) -> f64 {
    match [[a, b, c], [a, c, d]].map(|triangle| height(p, triangle)) {
        [Some(x), Some(y)] => x.min(y),
        // The other triangle may be a little nearer; a bound is all that is asked for.
        [Some(x), None] | [None, Some(x)] => x,
        [None, None] => {
            let sides = [[a, b], [b, c], [c, d], [d, a], [a, c]];
            sides.map(|[from, to]| distance_to_segment(p, from, to)).into_iter().fold(f64::INFINITY, f64::min)
        }
    }
}

/// The distance from the plane of a triangle, if the foot is inside.
fn height(p: P3, [a, b, c]: [P3; 3]) -> Option<f64> {
    let (ab, ac, ap) = (minus(b, a), minus(c, a), minus(p, a));
    let (bb, bc, cc, bp, cp) = (dot(ab, ab), dot(ab, ac), dot(ac, ac), dot(ab, ap), dot(ac, ap));
    let determinant = bb * cc - bc * bc;
    if determinant <= 1e-24 * bb * cc {
        return None;
    }
    let (x, y) = ((cc * bp - bc * cp) / determinant, (bb * cp - bc * bp) / determinant);
    let is_inside = x >= 0.0 && y >= 0.0 && x + y <= 1.0;
    is_inside.then(|| distance(ap, [0, 1, 2].map(|k| x * ab[k] + y * ac[k])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_at_huge_coordinates_are_moved_far() {
        let side = [[0.0; 3], [1e300, -1e300, 0.0], [2e300, 0.0, 1.0], [4e300, 0.0, 0.0]];
        assert!(displacement(&side) >= 1e300);
        let side = [[0.0; 3], [1.0, 1.0, 0.0], [2.0, -3.0, 0.0], [4.0, 0.0, 0.0]];
        assert_eq!(displacement(&side), 3.0);
    }
}
