//! Arc length of rational pieces, with an error bound that is proved, and its inverse.
//!
//! On a piece `-1 <= z <= 1` the speed is `√q / w²`, with a polynomial `q = c0 + c1 T1(z) + …` and the weight function
//! `w = d0 + d1 T1(z) + …`, which is 1 for a polynomial piece. On the Bernstein ellipse of the parameter `ρ` no `|Tj|`
//! is larger than `(ρʲ + ρ⁻ʲ)/2`; with `κ` the sum of `|cj|` times that, over `c0`, neither is `|q|` larger than
//! `c0 (1 + κ)`, and if `κ < 1` it has no zero there; likewise `|w|` is at least `d0 (1 - κ')`. So the speed is analytic
//! inside of the ellipse and has a known bound, and with it the error of the Gauss–Legendre rule with `n` nodes is at
//! most `64/15 max|speed| ρ^(-2n) / (1 - ρ⁻²)`; see `curve/length` for the source. Pieces for which no rule is good enough
//! are halved; those next to a cusp end when chord and control polygon agree. Where the degree is high, rounding errors of the
//! Chebyshev coefficients times `ρʲ` would hide what is known; there Bernstein coefficients bound the ones of high order, and
//! `q` and `w` themselves on short pieces.

use alloc::vec::Vec;

use crate::CurvePiece;
use crate::Scalar;
use crate::bernstein;
use crate::curve::{ELLIPSES, RULES, Rule};
use crate::geometry::derivative;

/// Below this depth a part is narrower than the distance of two floats.
const DEPTH: u32 = 56;

/// The arc length of all pieces; its error is at most `accuracy`. NaN if a control point is not finite, infinite if
/// it is too large for a number.
#[inline]
pub(crate) fn length(pieces: &[CurvePiece], accuracy: f64) -> f64 {
    let mut sum = 0.0;
    let finite = walk(pieces, accuracy, &mut |leaf| {
        sum += leaf.length;
        true
    });
    if finite {
        return sum;
    }
    // The differences of finite points may be too large.
    let largest = pieces.iter().map(CurvePiece::largest).fold(0.0, f64::max);
    if largest <= 1.0 || !pieces.iter().all(CurvePiece::is_finite) {
        return f64::NAN;
    }
    let scaled: Vec<CurvePiece> =
        pieces.iter().map(|piece| piece.seen_from(&alloc::vec![0.0; piece.dimension()], largest)).collect();
    length(&scaled, accuracy / largest) * largest
}

/// The parameters up to which the curve has each of these lengths, which do not decrease; NaN if a control point is not
/// finite.
#[inline]
pub(crate) fn parameters(pieces: &[CurvePiece], lengths: &[f64], accuracy: f64) -> Vec<f64> {
    let mut found = Vec::with_capacity(lengths.len());
    let mut before = 0.0;
    let finite = walk(pieces, accuracy, &mut |leaf| {
        while let Some(&length) = lengths.get(found.len()) {
            if length.is_nan() {
                found.push(f64::NAN);
            } else if length - before < leaf.length {
                found.push(leaf.part.parameter(leaf.invert((length - before).max(0.0))));
            } else {
                break;
            }
        }
        before += leaf.length;
        found.len() < lengths.len()
    });
    let end = pieces.last().map_or(f64::NAN, |piece| piece.domain()[1]);
    found.resize(lengths.len(), end);
    if !finite {
        found.fill(f64::NAN);
    }
    for (found, length) in found.iter_mut().zip(lengths) {
        if length.is_nan() {
            *found = f64::NAN;
        }
    }
    found
}

/// A part of a piece whose length is known.
struct Leaf {
    /// Measured in `unit`.
    part: CurvePiece,
    unit: f64,
    length: f64,
    /// `None` of a part that counts as straight.
    speed: Option<(Speed, &'static Rule)>,
}

impl Leaf {
    /// The place up to which the part has that length.
    #[inline]
    fn invert(&self, length: f64) -> f64 {
        let Some((speed, rule)) = &self.speed else { return halve(self.part.clone(), length / self.unit) };
        let (mut low, mut high) = (0.0, 1.0);
        let mut x = length / self.length;
        // Newton's method, kept between places on both sides. Over a part the rule is no worse: the ellipse of the part
        // lies inside of that of the whole.
        for _ in 0..DEPTH {
            let here = 0.5 * x * rule.integrate(|z: f64| speed.at(0.5 * x * (z + 1.0)));
            if here < length {
                low = x;
            } else {
                high = x;
            }
            let step = (length - here) / speed.at(x);
            let next = x + step;
            let inside = next > low && next < high;
            let next = if inside { next } else { 0.5 * (low + high) };
            if (next - x).abs() <= 4.0 * f64::EPSILON * x.abs() || high - low <= f64::EPSILON {
                return next;
            }
            x = next;
        }
        x
    }
}

/// The place up to which a straight part has that length. The speed need not be constant, and may vanish; but where chord
/// and control polygon agree, they do so on every half, because halving shortens the polygons and lengthens the chords.
#[inline]
fn halve(mut part: CurvePiece, mut length: f64) -> f64 {
    let (mut place, mut width) = (0.0, 1.0);
    for _ in 0..DEPTH {
        if length <= 0.0 {
            break;
        }
        width *= 0.5;
        let [before, after] = part.split(0.5);
        let [shortest, longest] = before.length_bounds();
        let here = 0.5 * (shortest + longest);
        part = if length >= here {
            length -= here;
            place += width;
            after
        } else {
            before
        };
    }
    place
}

/// The derivatives and what they divide by.
struct Speed {
    /// Velocities of a polynomial piece; of a rational one numerators and their derivatives, pair by pair.
    lists: Vec<Vec<f64>>,
    /// The weights and their derivative.
    weights: Option<[Vec<f64>; 2]>,
}

impl Speed {
    #[inline]
    fn of(piece: &CurvePiece) -> Self {
        let components = (0..piece.dimension()).map(|d| piece.component(d));
        match piece.weights() {
            None => Self { lists: components.map(derivative).collect(), weights: None },
            Some(weights) => {
                let lists = components.flat_map(|c| [c.to_vec(), derivative(c)]).collect();
                Self { lists, weights: Some([weights.to_vec(), derivative(weights)]) }
            }
        }
    }

    /// `q` and `w` at `0 <= x <= 1`.
    #[inline]
    fn parts(&self, x: f64) -> [f64; 2] {
        match &self.weights {
            None => {
                let velocity = self.lists.iter().map(|list| bernstein::eval(list, x));
                [velocity.fold(0.0, |sum, v| sum + v * v), 1.0]
            }
            Some(weights) => {
                let [w, slope] = [0, 1].map(|k| bernstein::eval(&weights[k], x));
                let square = self.lists.chunks_exact(2).fold(0.0, |sum, pair| {
                    let v = bernstein::eval(&pair[1], x) * w - bernstein::eval(&pair[0], x) * slope;
                    sum + v * v
                });
                [square, w]
            }
        }
    }

    /// The speed with respect to `x`.
    #[inline]
    fn at(&self, x: f64) -> f64 {
        let [q, w] = self.parts(x);
        Scalar::sqrt(q) / (w * w)
    }
}

/// The arc length, and the parameters of that many points at equal distances along the curve, both ends included.
#[inline]
pub(crate) fn equal_distances(pieces: &[CurvePiece], count: usize, accuracy: f64) -> (f64, Vec<f64>) {
    let total = length(pieces, accuracy);
    let steps = count.saturating_sub(1).max(1) as f64;
    let lengths: Vec<f64> = (0..count).map(|i| total * (i as f64 / steps)).collect();
    (total, parameters(pieces, &lengths, accuracy))
}

/// Walks along all pieces, part by part, until `visit` says to stop; `false` if a control point is not finite.
#[inline]
fn walk(pieces: &[CurvePiece], accuracy: f64, visit: &mut dyn FnMut(&Leaf) -> bool) -> bool {
    let polygon: f64 = pieces.iter().map(|piece| piece.length_bounds()[1]).sum();
    if !pieces.iter().all(CurvePiece::is_finite) || !polygon.is_finite() {
        return false;
    }
    if polygon == 0.0 {
        return true;
    }
    // Seen from the start and measured in the length of the polygon, so that nothing overflows or cancels.
    let Some(first) = pieces.first() else { return true };
    let origin: Vec<f64> = (0..first.dimension()).map(|d| first.control(0, d)).collect();
    let degree = pieces.iter().map(CurvePiece::degree).max().unwrap_or(0);
    let noise = f64::EPSILON * (4 * degree) as f64;
    let accuracy = (accuracy / polygon).max(f64::EPSILON) / pieces.len() as f64;
    let table = Cosines::new(pieces);
    for piece in pieces {
        let mut open = alloc::vec![(piece.seen_from(&origin, polygon), accuracy, 0_u32)];
        while let Some((part, accuracy, depth)) = open.pop() {
            let speed = Speed::of(&part);
            let mut leaf = match table.rule(&part, &speed, accuracy) {
                Some(rule) => {
                    let length = 0.5 * rule.integrate(|z: f64| speed.at(0.5 * (z + 1.0)));
                    Leaf { part, unit: polygon, length, speed: Some((speed, rule)) }
                }
                None => {
                    let [shortest, longest] = part.length_bounds();
                    if longest - shortest > accuracy + accuracy && longest > noise && depth < DEPTH {
                        let [before, after] = part.split(0.5);
                        open.push((after, 0.5 * accuracy, depth + 1));
                        open.push((before, 0.5 * accuracy, depth + 1));
                        continue;
                    }
                    Leaf { part, unit: polygon, length: 0.5 * (shortest + longest), speed: None }
                }
            };
            leaf.length *= polygon;
            if let Some((speed, _)) = &mut leaf.speed {
                for list in &mut speed.lists {
                    for c in list {
                        *c *= polygon;
                    }
                }
            }
            if !visit(&leaf) {
                return true;
            }
        }
    }
    true
}

/// The cosines from which Chebyshev coefficients are computed: `cos(π i / (2 m))` with `m` nodes.
struct Cosines {
    /// For `q` and for `w`.
    tables: [Vec<f64>; 2],
}

impl Cosines {
    #[inline]
    fn new(pieces: &[CurvePiece]) -> Self {
        let degree = pieces.iter().map(CurvePiece::degree).max().unwrap_or(0);
        let rational = pieces.iter().any(|piece| piece.weights().is_some());
        let nodes = if rational {
            [(4 * degree).saturating_sub(3).max(1), degree + 1]
        } else {
            [(2 * degree).max(2) - 1, 1]
        };
        let table =
            |m: usize| (0..4 * m).map(|i| Scalar::sin_cos(f64::PI * i as f64 / (2 * m) as f64).1).collect();
        Self { tables: nodes.map(table) }
    }

    /// The coefficients `c0, c1, …` of a polynomial that is known at the nodes.
    #[inline]
    fn coefficients(table: &[f64], values: &[f64]) -> Vec<f64> {
        let m = values.len();
        let coefficient = |j: usize| {
            let sum: f64 =
                values.iter().enumerate().map(|(k, v)| v * table[j * (2 * k + 1) % table.len()]).sum();
            sum * if j == 0 { 1.0 } else { 2.0 } / m as f64
        };
        (0..m).map(coefficient).collect()
    }

    /// The first rule whose error is proved to be at most `accuracy`.
    #[inline]
    fn rule(&self, part: &CurvePiece, speed: &Speed, accuracy: f64) -> Option<&'static Rule> {
        let at = |table: &[f64], index: usize| -> Vec<f64> {
            let m = table.len() / 4;
            (0..m).map(|k| speed.parts(0.5 * (table[2 * k + 1] + 1.0))[index]).collect()
        };
        let q = Self::coefficients(&self.tables[0], &at(&self.tables[0], 0));
        let w = match part.weights() {
            None => alloc::vec![1.0],
            Some(_) => Self::coefficients(&self.tables[1], &at(&self.tables[1], 1)),
        };
        if !(q[0] > 0.0 && w[0] > 0.0) {
            return None;
        }
        let [mut q, mut w] = [q, w].map(|c| Series::of(&c));
        let hull = (q.bounds.len() > NOISY).then(|| Hull::of(part));
        if let Some(hull) = &hull {
            q.lower(hull.largest(), 2 * hull.degree());
            w.lower(hull.largest_weight(), hull.weights.len() - 1);
        }
        ELLIPSES.iter().rev().find_map(|&rho| {
            let series = rule_on_ellipse(rho, q.on_ellipse(rho), w.on_ellipse(rho), accuracy);
            series.or_else(|| {
                let [q, w] = hull.as_ref()?.on_ellipse(rho);
                rule_on_ellipse(rho, q, w, accuracy)
            })
        })
    }
}

/// The first rule whose error is proved to be at most `accuracy` by the ellipse of the parameter `ρ`, on which `q` and `w`
/// are known as a value `c` and a bound `κ` of `|q/c - 1|`.
#[inline]
fn rule_on_ellipse(rho: f64, q: [f64; 2], w: [f64; 2], accuracy: f64) -> Option<&'static Rule> {
    let ([q, kq], [w, kw]) = (q, w);
    if !(kq < 1.0 && kw < 1.0) {
        return None;
    }
    let least = w * (1.0 - kw);
    let largest = 0.5 * Scalar::sqrt(q * (1.0 + kq)) / (least * least);
    let mut error = 64.0 / 15.0 * largest / (1.0 - 1.0 / (rho * rho));
    let mut nodes = 0;
    RULES.iter().find(|rule| {
        while nodes < rule.len() {
            error /= rho * rho;
            nodes += 1;
        }
        error <= accuracy
    })
}

/// With more coefficients than these the powers of `ρ` make their rounding errors matter.
const NOISY: usize = 64;

/// A polynomial `c0 + c1 T1(z) + …` with `c0 > 0`.
struct Series {
    mean: f64,
    /// Bounds of `|c1|, |c2|, …`.
    bounds: Vec<f64>,
}

impl Series {
    /// From coefficients that were computed.
    #[inline]
    fn of(c: &[f64]) -> Self {
        let noise = 8.0 * f64::EPSILON * c.len() as f64 * c[0];
        Self { mean: c[0], bounds: c[1..].iter().map(|c| c.abs() + noise).collect() }
    }

    /// Lowers the bounds to `2 M ρ⁻ʲ`, where `M = m aᵏ`, `a = (ρ + ρ⁻¹)/2`, bounds the polynomial on an ellipse if no Bernstein
    /// coefficient of degree `k` is larger than `m`: `Σ |Bi(x)| <= (|x| + |1 - x|)ᵏ`. So coefficients of high order are less
    /// than their rounding errors.
    #[inline]
    fn lower(&mut self, largest: f64, degree: usize) {
        for rho in ELLIPSES {
            let mut bound = (0..degree).fold(2.0 * largest, |bound, _| bound * half_axis(rho));
            for c in &mut self.bounds {
                bound /= rho;
                *c = c.min(bound);
            }
        }
    }

    /// The mean and `Σ_{j >= 1} |cj| (ρʲ + ρ⁻ʲ)/2 / c0`.
    #[inline]
    fn on_ellipse(&self, rho: f64) -> [f64; 2] {
        let (mut sum, mut power) = (0.0, 1.0);
        for c in &self.bounds {
            power *= rho;
            sum += c * 0.5 * (power + 1.0 / power);
        }
        [self.mean, sum / self.mean]
    }
}

/// `|x| + |1 - x|` on the ellipse.
#[inline]
fn half_axis(rho: f64) -> f64 {
    0.5 * (rho + 1.0 / rho)
}

/// What the Bernstein coefficients of `V`, `q = V · V`, and of `w` say.
struct Hull {
    /// One component of `V` after the other.
    velocity: Vec<Vec<f64>>,
    weights: Vec<f64>,
}

impl Hull {
    #[inline]
    fn of(part: &CurvePiece) -> Self {
        let velocity = (0..part.dimension()).map(|d| part.slope(d)).collect();
        Self { velocity, weights: part.weights().map_or(alloc::vec![1.0], <[f64]>::to_vec) }
    }

    /// The degree of `V`.
    #[inline]
    fn degree(&self) -> usize {
        self.velocity.first().map_or(0, |list| list.len().saturating_sub(1))
    }

    /// The largest square of a coefficient of `V`.
    #[inline]
    fn largest(&self) -> f64 {
        let square = |i: usize| self.velocity.iter().fold(0.0, |sum, list| sum + list[i] * list[i]);
        (0..=self.degree()).map(square).fold(0.0, f64::max)
    }

    #[inline]
    fn largest_weight(&self) -> f64 {
        self.weights.iter().fold(0.0, |largest, w| largest.max(w.abs()))
    }

    /// For `q` and `w` a value `c` and a bound of `|q/c - 1|`.
    #[inline]
    fn on_ellipse(&self, rho: f64) -> [[f64; 2]; 2] {
        let [speed, change] = around_middle(&self.velocity, rho);
        let [w, of_w] = around_middle(core::slice::from_ref(&self.weights), rho);
        // |(c + v)² - c²|
        [[speed * speed, (speed + speed + change) * change / (speed * speed)], [w, of_w / w]]
    }
}

/// The length of the mean `m` of the first and the last coefficient, and a bound of `|p - m|` on the ellipse of a polynomial
/// with these lists of Bernstein coefficients: half the difference of both times `a = (ρ + ρ⁻¹)/2`, for the line from one to the
/// other, and the largest distance of a coefficient from it times `aᵏ`, `k` the degree.
#[inline]
fn around_middle(lists: &[Vec<f64>], rho: f64) -> [f64; 2] {
    let (mut middle, mut slope, mut bend) = (0.0, 0.0, 0.0);
    let last = lists.first().map_or(0, |list| list.len().saturating_sub(1));
    for i in 0..=last {
        let part = if last > 0 { i as f64 / last as f64 } else { 0.0 };
        let mut square = 0.0;
        for list in lists {
            let away = list[i] - list[0] - part * (list[last] - list[0]);
            square += away * away;
        }
        bend = f64::max(bend, square);
    }
    for list in lists {
        let (sum, difference) = (list[0] + list[last], list[last] - list[0]);
        middle += 0.25 * sum * sum;
        slope += 0.25 * difference * difference;
    }
    let a = half_axis(rho);
    let [middle, slope, bend] = [middle, slope, bend].map(Scalar::sqrt);
    [middle, slope * a + (0..last).fold(bend, |bend, _| bend * a)]
}
