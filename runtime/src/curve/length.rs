//! Arc length, with an error bound that is proved rather than estimated.
//!
//! On a piece of the curve let `D(z)`, `-1 <= z <= 1`, be its derivative in powers of `z`: `D = d0 + d1 z + …`. If
//! `Σ_{j≥1} (2 |d0·dj| rʲ) + (Σ_{j≥1} |dj| rʲ)² < |d0|²`, the speed `|D|` continues to an analytic function of modulus at most
//! `M` on the disc `|z| <= r`, hence on the Bernstein ellipse with `r = (ρ + 1/ρ)/2`, and the Gauss–Legendre rule with `n` nodes
//! has an error of at most `8 M ρ / (ρ - 1) ρ^(-2n)` (from the best approximation of degree `2n - 1`; Trefethen,
//! *Approximation Theory and Approximation Practice*, theorems 8.2 and 19.3). Pieces for which no rule is good enough are
//! halved; next to a cusp, where the condition fails, pieces end when chord and control polygon agree to within the accuracy.

use super::quadrature::{RULES, Rule};
use crate::domain::from_unit;
use crate::vector::{distance, dot, is_finite};
use crate::{Array, Basis, Curve, Point, Scalar, bernstein};

/// The `ρ` of the ellipses that are tried.
const ELLIPSES: [f64; 6] = [64.0, 16.0, 8.0, 4.0, 2.5, 1.8];

/// The error bound is computed for derivatives with up to so many coefficients after the first.
const MOST: usize = 100; // the highest degree of a spec

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The arc length `∫ |C'(t)| dt` over the domain; the error is at most `accuracy`.
    ///
    /// The bound of the error is proved, up to rounding: an `accuracy` below about `ε` times the length, also zero or NaN,
    /// asks for what the scalar type can give. Infinite or NaN control points have the length NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// // y = x², 0 <= x <= 1: √5/2 + asinh(2)/4.
    /// let parabola = Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    /// assert!((parabola.arclen(1e-12) - 1.478942857544597_f64).abs() < 1e-12);
    /// ```
    pub fn arclen(&self, accuracy: B::Scalar) -> B::Scalar {
        let Some(whole) = self.prepare(accuracy) else { return B::Scalar::NAN };
        let unit = whole.unit;
        let mut sum = B::Scalar::ZERO;
        whole.piece.walk(&mut |leaf: &Leaf<'_, B::Bernstein<P>, P>| {
            sum = sum + leaf.length();
            true
        });
        sum * unit
    }

    /// The parameter `t` for which the curve from its start to `C(t)` has that length; the length up to there differs from
    /// `length` by at most `accuracy`, as in [`arclen`](Self::arclen).
    ///
    /// A `length` below zero gives the start of the domain, one above the length of the curve its end, and NaN gives NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    /// let half = parabola.inv_arclen(0.5 * parabola.arclen(1e-12), 1e-12);
    /// let [left, right] = parabola.split(half);
    /// let difference: f64 = left.arclen(1e-12) - right.arclen(1e-12);
    /// assert!(difference.abs() < 4e-12);
    /// ```
    pub fn inv_arclen(&self, length: B::Scalar, accuracy: B::Scalar) -> B::Scalar {
        if length.is_nan() {
            return length;
        }
        let Some(whole) = self.prepare(accuracy) else { return B::Scalar::NAN };
        let mut found = B::Scalar::ONE;
        let mut rest = length / whole.unit;
        whole.piece.walk(&mut |leaf: &Leaf<'_, B::Bernstein<P>, P>| {
            let piece = leaf.length();
            if rest < piece {
                found = leaf.invert(rest.max(B::Scalar::ZERO));
                return false;
            }
            rest = rest - piece;
            true
        });
        from_unit(B::domain(), found)
    }

    /// The parameters of `count` points at equal distances along the curve, both ends included; each as in
    /// [`inv_arclen`](Self::inv_arclen), but found in one pass.
    ///
    /// All NaN if a control point is infinite or NaN.
    #[cfg(feature = "alloc")]
    pub fn arclen_parameters(&self, count: usize, accuracy: B::Scalar) -> alloc::vec::Vec<B::Scalar> {
        let Some(whole) = self.prepare(accuracy) else { return alloc::vec![B::Scalar::NAN; count] };
        let total = self.arclen(accuracy) / whole.unit;
        let step = total / B::Scalar::from_usize(count.saturating_sub(1).max(1));
        let mut parameters = alloc::vec::Vec::with_capacity(count);
        let mut before = B::Scalar::ZERO;
        whole.piece.walk(&mut |leaf: &Leaf<'_, B::Bernstein<P>, P>| {
            let after = before + leaf.length();
            while parameters.len() < count {
                let target = step * B::Scalar::from_usize(parameters.len());
                if target >= after {
                    break;
                }
                parameters.push(from_unit(B::domain(), leaf.invert(target - before)));
            }
            before = after;
            true
        });
        // The last one, and on a curve of length zero all of them.
        let end = if total > B::Scalar::ZERO { B::domain()[1] } else { B::domain()[0] };
        parameters.resize(count, end);
        if count > 1 {
            parameters[count - 1] = B::domain()[1];
        }
        parameters
    }

    /// `count` points at equal distances along the curve, both ends included, exactly: the points at the
    /// [`arclen_parameters`](Self::arclen_parameters).
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// // A straight line with a parameter that is not proportional to its length.
    /// let line = Bezier::from_points([0.0_f64, 0.0, 1.0]);
    /// for (point, expected) in line.samples_by_arclen(5, 1e-12).iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
    ///     assert!((point - expected).abs() < 1e-11);
    /// }
    /// ```
    #[cfg(feature = "alloc")]
    pub fn samples_by_arclen(&self, count: usize, accuracy: B::Scalar) -> alloc::vec::Vec<P> {
        self.arclen_parameters(count, accuracy).into_iter().map(|t| self.eval(t)).collect()
    }

    /// The whole curve, ready to be walked along; `None` if it is not finite.
    fn prepare(&self, accuracy: B::Scalar) -> Option<Whole<B::Bernstein<P>, B::Scalar>> {
        let mut points = self.to_bernstein();
        let polygon = polygon(points.as_ref());
        if !points.as_ref().iter().all(|&p| is_finite(p)) || !polygon.is_finite() {
            return None;
        }
        let square = polygon * polygon;
        let margin = B::Scalar::EPSILON * B::Scalar::EPSILON;
        let in_range = square * margin > B::Scalar::MIN_POSITIVE && (square / margin).is_finite();
        let unit = if in_range || polygon == B::Scalar::ZERO { B::Scalar::ONE } else { polygon };
        if unit != B::Scalar::ONE {
            // The start becomes the origin, so that nothing overflows.
            let start = points.as_ref()[0];
            for p in points.as_mut() {
                let q = p.minus(start);
                *p = P::from_components(|d| q.component(d) / unit);
            }
        }
        let accuracy = (accuracy / unit).max(B::Scalar::EPSILON * (polygon / unit));
        let (from, to) = (B::Scalar::ZERO, B::Scalar::ONE);
        Some(Whole { piece: Piece { points, from, to, accuracy, depth: 0 }, unit })
    }
}

/// A curve whose lengths are measured in `unit`: so that the squares of velocities neither overflow nor vanish.
struct Whole<A, S> {
    piece: Piece<A, S>,
    unit: S,
}

/// The length of the control polygon.
fn polygon<P: Point>(points: &[P]) -> P::Scalar {
    points.windows(2).fold(P::Scalar::ZERO, |sum, pair| sum + distance(pair[0], pair[1]))
}

struct Piece<A, S> {
    points: A,
    from: S,
    to: S,
    accuracy: S,
    depth: u32,
}

impl<A, S: Scalar> Piece<A, S> {
    /// Returns whether to go on after this piece.
    fn walk<P: Point<Scalar = S>>(self, visit: &mut impl FnMut(&Leaf<'_, A, P>) -> bool) -> bool
    where
        A: Array<P>,
    {
        let Self { points, from, to, accuracy, depth } = self;
        // The derivative in z = 2x - 1 over the piece, x from 0 to 1.
        let mut derivative = points;
        let derivative = bernstein::differentiate(derivative.as_mut());
        bernstein::centred_powers(derivative);
        for d in derivative.iter_mut() {
            *d = d.scale(S::of(0.5));
        }
        if let Some(rule) = rule(derivative, accuracy) {
            return visit(&Leaf { from, to, speed: Speed::Smooth { derivative, rule } });
        }
        let [shortest, longest] = length_bounds(points.as_ref());
        if longest - shortest <= accuracy + accuracy || depth == DEPTH {
            return visit(&Leaf { from, to, speed: Speed::Straight { points } });
        }
        let middle = from + (to - from) * S::of(0.5);
        let (mut left, mut right) = (points, points);
        bernstein::split(left.as_mut(), S::of(0.5), right.as_mut());
        let (accuracy, depth) = (accuracy * S::of(0.5), depth + 1);
        Piece { points: left, from, to: middle, accuracy, depth }.walk(visit)
            && Piece { points: right, from: middle, to, accuracy, depth }.walk(visit)
    }
}

/// The smallest rule whose error for `∫ |D(z)| dz` is proved to be at most `accuracy`.
fn rule<P: Point>(derivative: &[P], accuracy: P::Scalar) -> Option<&'static Rule> {
    let (&first, rest) = derivative.split_first()?;
    let square = dot(first, first);
    if rest.len() > MOST {
        return None;
    }
    let [mut sizes, mut along] = [[P::Scalar::ZERO; MOST]; 2];
    for (j, &d) in rest.iter().enumerate() {
        sizes[j] = dot(d, d).sqrt();
        along[j] = dot(first, d).abs();
    }
    let (sizes, along) = (&sizes[..rest.len()], &along[..rest.len()]);
    let speed = square.sqrt();
    let mut best: Option<&'static Rule> = None;
    for rho in ELLIPSES {
        let radius = P::Scalar::of(0.5 * (rho + 1.0 / rho));
        let (mut change, mut cross) = (P::Scalar::ZERO, P::Scalar::ZERO);
        for (&size, &along) in sizes.iter().zip(along).rev() {
            change = (change + size) * radius;
            cross = (cross + along) * radius;
        }
        // Neither if anything overflows.
        if cross + cross + change * change < square {
            let bound = P::Scalar::of(8.0 * rho / (rho - 1.0)) * (speed + change);
            let smaller = RULES.iter().take_while(|rule| best.is_none_or(|best| rule.len() < best.len()));
            let shrink = P::Scalar::of(1.0 / (rho * rho));
            best = smaller
                .into_iter()
                .find(|rule| (0..rule.len()).fold(bound, |error, _| error * shrink) <= accuracy)
                .or(best);
        }
    }
    best
}

/// The lengths of the chord and of the control polygon, between which the length of the curve lies.
fn length_bounds<P: Point>(points: &[P]) -> [P::Scalar; 2] {
    match points {
        [start, .., end] => [distance(*start, *end), polygon(points)],
        _ => [P::Scalar::ZERO; 2],
    }
}

/// A piece whose length is known.
struct Leaf<'a, A, P: Point> {
    from: P::Scalar,
    to: P::Scalar,
    speed: Speed<'a, A, P>,
}

enum Speed<'a, A, P: Point> {
    /// `|D(z)|`, for which the rule is good enough on every part of the piece that starts at its start.
    Smooth { derivative: &'a [P], rule: &'static Rule },
    /// Chord and control polygon agree; so they do on every part, because subdivision shortens the polygons and
    /// lengthens the chords.
    Straight { points: A },
}

impl<A: Array<P>, P: Point> Leaf<'_, A, P> {
    fn length(&self) -> P::Scalar {
        match &self.speed {
            Speed::Smooth { derivative, rule } => rule.integrate(|z| speed(derivative, z)),
            Speed::Straight { points } => mean(length_bounds(points.as_ref())),
        }
    }

    /// The parameter in the unit interval up to which the piece has that length.
    fn invert(&self, target: P::Scalar) -> P::Scalar {
        let part = match &self.speed {
            Speed::Smooth { derivative, rule } => invert(derivative, rule, target),
            Speed::Straight { points } => halve(*points, target),
        };
        self.from + (self.to - self.from) * part
    }
}

fn mean<S: Scalar>([a, b]: [S; 2]) -> S {
    (a + b) * S::of(0.5)
}

/// The part of a straight piece, from 0 to 1, that has that length. The speed need not be constant, and may vanish.
fn halve<A: Array<P>, P: Point>(mut points: A, mut target: P::Scalar) -> P::Scalar {
    let half = P::Scalar::of(0.5);
    let [mut part, mut width] = [P::Scalar::ZERO, P::Scalar::ONE];
    for _ in 0..DEPTH {
        width = width * half;
        let mut right = points;
        bernstein::split(points.as_mut(), half, right.as_mut());
        let left = mean(length_bounds(points.as_ref()));
        if target >= left {
            target = target - left;
            part = part + width;
            points = right;
        }
    }
    part
}

/// `|D(z)|`
#[inline]
fn speed<P: Point>(derivative: &[P], z: P::Scalar) -> P::Scalar {
    let Some((&last, rest)) = derivative.split_last() else { return P::Scalar::ZERO };
    let velocity = rest.iter().rev().fold(last, |sum, &d| d.add_scaled(sum, z));
    dot(velocity, velocity).sqrt()
}

/// The part of the piece, from 0 to 1, that has that length: Newton's method, and halving where it leaves the bracket.
fn invert<P: Point>(derivative: &[P], rule: &Rule, target: P::Scalar) -> P::Scalar {
    let [one, two, half] = [P::Scalar::ONE, P::Scalar::of(2.0), P::Scalar::of(0.5)];
    // The length over -1..z, and its derivative.
    let up_to = |part: P::Scalar| rule.integrate(|y| speed(derivative, (y + one) * part - one)) * part;
    let [mut lo, mut hi] = [P::Scalar::ZERO, one];
    let mut part = half;
    for _ in 0..80 {
        let gap = up_to(part) - target;
        if gap == P::Scalar::ZERO {
            break;
        }
        if gap < P::Scalar::ZERO {
            lo = part;
        } else {
            hi = part;
        }
        let slope = two * speed(derivative, two * part - one);
        let newton = part - gap / slope;
        let next = if newton > lo && newton < hi { newton } else { lo + (hi - lo) * half };
        let step = (next - part).abs();
        part = next;
        if step <= P::Scalar::EPSILON * part {
            break;
        }
    }
    part
}
