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
pub(in crate::mesh) type P3 = [f64; 3];

/// A part of a piece over a rectangle.
#[derive(Clone)]
pub(in crate::mesh) struct Part {
    /// The index of its piece.
    piece: usize,
    /// The rectangle in the parameters of the surface.
    span: [[f64; 2]; 2],
    /// The rectangle in the unit square of the piece.
    place: [[f64; 2]; 2],
    net: Piece,
}

impl Part {
    /// The range of a parameter of the surface.
    pub(in crate::mesh) fn span(&self, axis: usize) -> [f64; 2] {
        self.span[axis]
    }

    /// All control points.
    pub(in crate::mesh) fn points(&self) -> impl Iterator<Item = P3> {
        let [m, n] = self.net.degrees();
        (0..=n).flat_map(move |j| (0..=m).map(move |i| self.point(i, j)))
    }

    /// The control points along a parameter at the lower or upper end of the other one.
    pub(in crate::mesh) fn side(&self, axis: usize, is_end: bool) -> impl Iterator<Item = P3> {
        let degrees = self.net.degrees();
        let across = if is_end { degrees[1 - axis] } else { 0 };
        (0..=degrees[axis])
            .map(move |k| if axis == 0 { self.point(k, across) } else { self.point(across, k) })
    }

    /// Both halves in one direction.
    fn halves(&self, axis: usize) -> [Self; 2] {
        let [lo, hi] = self.span[axis];
        let middle = 0.5 * (lo + hi);
        let [low, high] = self.net.halved(axis);
        [(low, [lo, middle]), (high, [middle, hi])].map(|(net, range)| {
            let mut half = Self { net, ..*self };
            half.span[axis] = range;
            half
        })
    }

    /// Takes the control points of its halves in both directions into account, where it bends.
    fn see_quarters(&self, target: &Target, farthest: &mut Farthest) {
        let (net, degrees) = (self.net.numbers(), self.net.degrees());
        // Four nets of bicubic rational patches have room without memory of their own.
        let (mut few, mut many) = ([0.0; 256], Vec::new());
        let all = if 4 * net.len() <= few.len() {
            &mut few[..4 * net.len()]
        } else {
            many.resize(4 * net.len(), 0.0);
            &mut many[..]
        };
        all[..net.len()].copy_from_slice(net);
        let mut spans = [self.span; 4];
        let mut count = 1;
        for axis in [0, 1] {
            if degrees[axis] < 2 {
                continue;
            }
            let (upper, lower) = all.split_at_mut(count * net.len());
            let nets = upper.chunks_exact_mut(net.len()).zip(lower.chunks_exact_mut(net.len()));
            for (k, (upper, lower)) in nets.enumerate() {
                self.net.divide(upper, lower, axis, 0.5);
                let [lo, hi] = self.span[axis];
                let middle = 0.5 * (lo + hi);
                spans[count + k] = spans[k];
                (spans[k][axis], spans[count + k][axis]) = ([middle, hi], [lo, middle]);
            }
            count *= 2;
        }
        for (net, span) in all.chunks_exact(net.len()).zip(spans).take(count) {
            farthest.see(target, span, degrees, net);
        }
    }

    /// A control point; NaN if its weight is not positive.
    fn point(&self, i: usize, j: usize) -> P3 {
        let weight = self.net.weight(j * (self.net.degrees()[0] + 1) + i);
        let p = self.net.point(i, j);
        if weight > 0.0 { [0, 1, 2].map(|k| p[k] / weight) } else { [f64::NAN; 3] }
    }
}

/// The pieces of a surface that overlap ranges of both parameters, not cut yet.
pub(in crate::mesh) fn whole(pieces: &[SurfacePiece], ranges: [[f64; 2]; 2]) -> Vec<Part> {
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
pub(in crate::mesh) fn cut(pieces: &[SurfacePiece], parts: Vec<Part>, axis: usize, t: f64) -> [Vec<Part>; 2] {
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
            let [low, high] = part.net.split(axis, at);
            let half = |net: Piece, span: [f64; 2], place: [f64; 2]| {
                let mut half = Part { net, ..part };
                half.span[axis] = span;
                half.place[axis] = place;
                half
            };
            let (low, high) = (half(low, [lo, t], [from, middle]), half(high, [t, hi], [middle, to]));
            before.push(low);
            after.push(high);
        }
    }
    [before, after]
}

/// How far a flat piece may be from the surface.
#[derive(Clone, Copy, Debug)]
pub(in crate::mesh) struct Flatness {
    /// How much the curves along each parameter bend, which says where to cut.
    pub(in crate::mesh) bends: [f64; 2],
    /// A bound of the distance of the two triangles from the surface, both ways.
    pub(in crate::mesh) distance: f64,
}

/// What nine points say, those in the middle of the sides and of the rectangle among them: how much the surface bends,
/// and how far it is at least from the triangles. `at` takes halves of the rectangle, from 0 to 2.
pub(in crate::mesh) fn sampled(corners: [P3; 4], at: impl Fn([u32; 2]) -> P3) -> Flatness {
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
pub(in crate::mesh) fn measure(parts: &[Part], corners: [P3; 4], tolerance: f64, weld: f64) -> Flatness {
    let skewness = skewness(corners);
    let target = Target::new(parts, corners, weld);
    let mut found = Farthest::default();
    for part in parts {
        found.see(&target, part.span, part.net.degrees(), part.net.numbers());
    }
    let mut found = found.flatness();
    found.distance += skewness;
    // The hull of the control points of halves is much nearer to the surface.
    if found.distance > tolerance && skewness < tolerance && found.distance <= 4.0 * tolerance {
        let mut halves = Farthest::default();
        for part in parts {
            part.see_quarters(&target, &mut halves);
        }
        found.distance = found.distance.min(halves.flatness().distance + skewness);
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

/// The halves of a part in both directions, where it bends.
pub(in crate::mesh) fn quarters(part: &Part) -> Vec<Part> {
    let [bends_along_u, bends_along_v] = part.net.degrees().map(|degree| degree > 1);
    let all = if bends_along_u { Vec::from(part.halves(0)) } else { alloc::vec![part.clone()] };
    if bends_along_v { all.iter().flat_map(|part| part.halves(1)).collect() } else { all }
}

/// Two triangles, with what their distances from control points ask for.
struct Target {
    triangles: Triangles,
    /// The sides of the rectangle: along `u` at both ends of `v`, along `v` at both ends of `u`.
    sides: [Segment; 4],
    /// The ranges of both parameters.
    ranges: [[f64; 2]; 2],
    /// The square of the length of what counts as a point.
    weld: f64,
}

impl Target {
    fn new(parts: &[Part], corners: [P3; 4], weld: f64) -> Self {
        let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for part in parts {
            for (range, [lo, hi]) in ranges.iter_mut().zip(part.span) {
                *range = [range[0].min(lo), range[1].max(hi)];
            }
        }
        let [a, b, c, d] = corners;
        let sides = [[a, b], [d, c], [a, d], [b, c]].map(|[from, to]| Segment::new(from, to));
        Self { triangles: Triangles::new(corners), sides, ranges, weld: weld * weld }
    }
}

/// The squares of the largest distances of control points.
#[derive(Default)]
struct Farthest {
    bends: [f64; 2],
    distance: f64,
}

impl Farthest {
    fn flatness(self) -> Flatness {
        let root = crate::Scalar::sqrt;
        Flatness { bends: self.bends.map(root), distance: root(self.distance) }
    }

    /// Takes the control points of a part over a rectangle into account.
    fn see(&mut self, target: &Target, span: [[f64; 2]; 2], [m, n]: [usize; 2], net: &[f64]) {
        // The sides of the rectangle on which the part lies.
        let [u, v] = [0, 1].map(|axis| {
            let ([lo, hi], [low, high]) = (span[axis], target.ranges[axis]);
            [lo <= low, hi >= high]
        });
        let stride = net.len() / ((m + 1) * (n + 1));
        for (k, numbers) in net.chunks_exact(stride).enumerate() {
            let (i, j) = (k % (m + 1), k / (m + 1));
            let p = control_point(numbers);
            let on_sides = [v[0] && j == 0, v[1] && j == n, u[0] && i == 0, u[1] && i == m];
            if on_sides == [false; 4] {
                self.distance = larger(self.distance, target.triangles.square(p));
                continue;
            }
            // The side belongs to the triangles, so that these are no farther away.
            for (index, side) in target.sides.iter().enumerate().filter(|&(index, _)| on_sides[index]) {
                let away = side.square(p);
                // A curve that comes back to where it began is no point.
                let is_loop = side.length <= target.weld && away > target.weld;
                let away = if is_loop { f64::INFINITY } else { away };
                self.distance = larger(self.distance, away);
                self.bends[index / 2] = larger(self.bends[index / 2], away);
            }
        }
    }
}

/// A control point from its numbers; NaN if its weight is not positive.
fn control_point(numbers: &[f64]) -> P3 {
    match *numbers {
        [x, y, z] => [x, y, z],
        [x, y, z, weight] if weight > 0.0 => [x / weight, y / weight, z / weight],
        _ => [f64::NAN; 3],
    }
}

/// A segment, and the squares of distances from it.
#[derive(Clone, Copy)]
struct Segment {
    from: P3,
    chord: P3,
    /// The square of its length.
    length: f64,
}

impl Segment {
    fn new(from: P3, to: P3) -> Self {
        let chord = minus(to, from);
        Self { from, chord, length: dot(chord, chord) }
    }

    fn square(&self, p: P3) -> f64 {
        let arm = minus(p, self.from);
        let x = dot(arm, self.chord) / self.length;
        // Also where the chord has no length.
        let x = if x <= 0.0 || x.is_nan() { 0.0 } else { x.min(1.0) };
        let away = [0, 1, 2].map(|k| arm[k] - x * self.chord[k]);
        dot(away, away)
    }
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
pub(in crate::mesh) fn displacement(side: &[P3]) -> f64 {
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
pub(in crate::mesh) fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || a.is_nan() { f64::INFINITY } else { a.max(b) }
}

pub(in crate::mesh) fn minus(a: P3, b: P3) -> P3 {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub(in crate::mesh) fn dot(a: P3, b: P3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(in crate::mesh) fn distance(a: P3, b: P3) -> f64 {
    crate::vector::distance(a, b)
}

pub(in crate::mesh) fn distance_to_segment(p: P3, from: P3, to: P3) -> f64 {
    distance(p, foot(p, from, to))
}

/// The point of a segment that is nearest to a point.
pub(in crate::mesh) fn foot(p: P3, from: P3, to: P3) -> P3 {
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
pub(in crate::mesh) fn distance_to_triangles(p: P3, corners: [P3; 4]) -> f64 {
    Triangles::new(corners).distance(p)
}

/// The triangles `abc` and `acd`.
struct Triangles {
    corners: [P3; 4],
    planes: [Option<Plane>; 2],
}

impl Triangles {
    fn new([a, b, c, d]: [P3; 4]) -> Self {
        Self { corners: [a, b, c, d], planes: [Plane::new([a, b, c]), Plane::new([a, c, d])] }
    }

    fn distance(&self, p: P3) -> f64 {
        crate::Scalar::sqrt(self.square(p))
    }

    /// The square of the distance.
    fn square(&self, p: P3) -> f64 {
        let [a, b, c, d] = self.corners;
        match self.planes.each_ref().map(|plane| plane.as_ref().and_then(|plane| plane.height(p))) {
            [Some(x), Some(y)] => x.min(y),
            // The other triangle may be a little nearer; a bound is all that is asked for.
            [Some(x), None] | [None, Some(x)] => x,
            [None, None] => {
                let sides = [[a, b], [b, c], [c, d], [d, a], [a, c]];
                sides
                    .map(|[from, to]| Segment::new(from, to).square(p))
                    .into_iter()
                    .fold(f64::INFINITY, f64::min)
            }
        }
    }
}

/// The plane of a triangle `abc`.
struct Plane {
    from: P3,
    sides: [P3; 2],
    /// The vectors whose products with a difference from `a` are the shares of `b` and `c`.
    shares: [P3; 2],
}

impl Plane {
    /// `None` if the triangle has no area.
    fn new([a, b, c]: [P3; 3]) -> Option<Self> {
        let (ab, ac) = (minus(b, a), minus(c, a));
        let (bb, bc, cc) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
        let determinant = bb * cc - bc * bc;
        if determinant <= 1e-24 * bb * cc {
            return None;
        }
        let shares = [
            [0, 1, 2].map(|k| (cc * ab[k] - bc * ac[k]) / determinant),
            [0, 1, 2].map(|k| (bb * ac[k] - bc * ab[k]) / determinant),
        ];
        Some(Self { from: a, sides: [ab, ac], shares })
    }

    /// The square of the distance of a point, if its foot is inside of the triangle.
    fn height(&self, p: P3) -> Option<f64> {
        let (ap, [ab, ac]) = (minus(p, self.from), self.sides);
        let [x, y] = self.shares.map(|share| dot(share, ap));
        let is_inside = x >= 0.0 && y >= 0.0 && x + y <= 1.0;
        is_inside.then(|| {
            let away = [0, 1, 2].map(|k| ap[k] - (x * ab[k] + y * ac[k]));
            dot(away, away)
        })
    }
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
