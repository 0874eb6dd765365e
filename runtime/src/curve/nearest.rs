//! The point of a curve nearest to a given one: the global minimum, by branch and bound.
//!
//! On a piece of the curve `f(x) = |C(x) - p|²` is a polynomial, and its smallest Bernstein coefficient bounds it from
//! below. A piece is put aside when this bound shows that it cannot improve on the best point found by more than the
//! accuracy, and when the differences of the coefficients change their sign not more than once: `f` then has at most
//! one minimum inside (Descartes' rule of signs), which Newton's method finds. What is put aside is good enough also if
//! all coefficients are wrong by their rounding errors; otherwise the piece is halved, which makes it and its rounding
//! errors smaller.

use alloc::vec::Vec;

use crate::bernstein::{self, bracketed_root, changes_of_sign};
use crate::domain::from_unit;
use crate::numeric::binomial::row;
use crate::vector::{difference, distance, dot, is_finite, length};
use crate::{Array, Basis, Curve, Nearest, Point, Scalar};

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The point of the curve nearest to `point`, among those with a parameter in the domain.
    ///
    /// It is a global minimum: its distance exceeds [`at_least`](Nearest::at_least), which no point of the curve is
    /// nearer than, by no more than `accuracy`. This bound is proved up to rounding: an `accuracy` below some `ε` times
    /// the size of the curve as seen from the point, also zero or NaN, asks for what the scalar type can give. Of
    /// several nearest points one is returned. `None` if `point` or a control point is infinite or NaN, or so large
    /// that a point of the curve is.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// let nearest = parabola.nearest([0.0, -2.0], 1e-9).unwrap();
    /// assert_eq!((nearest.at, nearest.point, nearest.distance), (0.5, [0.0, 0.0], 2.0));
    /// assert!(nearest.at_least >= 2.0 - 1e-9);
    /// ```
    pub fn nearest(&self, point: P, accuracy: B::Scalar) -> Option<Nearest<P>> {
        let mut seen = self.to_bernstein();
        for p in seen.as_mut() {
            *p = difference(*p, point);
        }
        let size = seen.as_ref().iter().fold(B::Scalar::ZERO, |size, &p| size.max(length(p)));
        if !seen.as_ref().iter().all(|&p| is_finite(p)) || !size.is_finite() {
            return None;
        }
        let best = self.candidate(point, B::Scalar::ZERO);
        let mut search =
            Search { curve: self, point, size, accuracy: B::Scalar::ZERO, best, overflow: false };
        search.improve(B::Scalar::ONE);
        if size > B::Scalar::ZERO {
            // Scaled, so that no square overflows or vanishes.
            for p in seen.as_mut() {
                *p = P::from_components(|d| p.component(d) / size);
            }
            // Not less than twice the noise of a square: in a space of many dimensions less could never be settled.
            let units = (8 * (B::DEGREE + 1)).max(2 * noise_units::<B, P>());
            let rounding = B::Scalar::EPSILON * B::Scalar::from_usize(units);
            search.accuracy = (accuracy / size).max(rounding);
            search.run(seen);
        }
        if search.overflow {
            return None;
        }
        let proved = search.best.distance - search.accuracy * size;
        Some(Nearest { at_least: proved.max(B::Scalar::ZERO), ..search.best })
    }

    /// The point at `x` in the unit interval.
    fn candidate(&self, point: P, x: B::Scalar) -> Nearest<P> {
        let t = from_unit(B::domain(), x);
        let on_curve = self.eval(t);
        let distance = distance(on_curve, point);
        Nearest { at: t, point: on_curve, distance, at_least: B::Scalar::ZERO }
    }
}

struct Search<'a, B: Basis, P: Point<Scalar = B::Scalar>> {
    curve: &'a Curve<B, P>,
    point: P,
    /// The unit in which the pieces and the accuracy are measured.
    size: B::Scalar,
    accuracy: B::Scalar,
    best: Nearest<P>,
    /// Whether a distance was infinite or NaN, which nothing can be concluded from.
    overflow: bool,
}

/// A part of the curve as seen from the point, in the search's unit.
struct Piece<A, S> {
    points: A,
    from: S,
    to: S,
    depth: u32,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Search<'_, B, P> {
    /// Returns the square of the distance at `x`.
    fn improve(&mut self, x: B::Scalar) -> B::Scalar {
        let candidate = self.curve.candidate(self.point, x);
        self.overflow |= !candidate.distance.is_finite();
        if candidate.distance < self.best.distance {
            self.best = candidate;
        }
        let distance = candidate.distance / self.size;
        distance * distance
    }

    /// Whether no distance whose square is at least `square` improves on the best point by more than the accuracy.
    fn is_settled(&self, square: B::Scalar) -> bool {
        let gap = self.best.distance / self.size - self.accuracy;
        gap <= B::Scalar::ZERO || square >= gap * gap
    }

    fn run(&mut self, curve: B::Bernstein<P>) {
        let half = B::Scalar::of(0.5);
        let mut next = Some(Piece { points: curve, from: B::Scalar::ZERO, to: B::Scalar::ONE, depth: 0 });
        let mut pieces = Vec::new();
        while let Some(Piece { mut points, from, to, depth }) = next.take().or_else(|| pieces.pop())
            && !self.overflow
        {
            let square = Square::<B>::of(&points);
            let [lowest, _] = bernstein::bounds(square.coefficients());
            if self.is_settled(lowest - square.noise) {
                continue;
            }
            if let Some(reached) = self.minimum(&square, from, to)
                && self.is_settled(reached - (square.noise + square.noise))
            {
                continue;
            }
            let middle = from + (to - from) * half;
            self.improve(middle);
            if depth == DEPTH {
                continue;
            }
            let [start, .., end] = square.coefficients() else { continue };
            let mut right = points;
            bernstein::split(points.as_mut(), half, right.as_mut());
            let depth = depth + 1;
            let left = Piece { points, from, to: middle, depth };
            let right = Piece { points: right, from: middle, to, depth };
            // The half that ends nearer to the point is looked at first.
            let (first, second) = if start < end { (left, right) } else { (right, left) };
            pieces.push(second);
            next = Some(first);
        }
    }

    /// The smallest square of a distance on the piece; `None` if it may have more than one minimum.
    fn minimum(&mut self, square: &Square<B>, from: B::Scalar, to: B::Scalar) -> Option<B::Scalar> {
        let [start, .., end] = *square.coefficients() else { return None };
        // The derivative, but for a positive factor.
        let mut buffers = [(); 2].map(|()| B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]));
        let [slope, bend] = buffers.each_mut().map(|buffer| buffer.as_mut().as_flattened_mut());
        let slope = &mut slope[..2 * B::DEGREE];
        for (slope, pair) in slope.iter_mut().zip(square.coefficients().windows(2)) {
            *slope = pair[1] - pair[0];
        }
        match changes_of_sign(slope) {
            1 if slope.iter().find(|&&c| c != B::Scalar::ZERO).is_some_and(|&c| c < B::Scalar::ZERO) => {
                let root = bracketed_root(slope, bend);
                Some(self.improve(from + (to - from) * root))
            }
            // Monotone, or with a maximum: an end is nearest.
            0 | 1 if start < end => Some(self.improve(from)),
            0 | 1 => Some(self.improve(to)),
            _ => None,
        }
    }
}

/// A bound of the rounding errors of `|C|²`, in units of `ε` times its largest coefficient.
const fn noise_units<B: Basis, P: Point>() -> usize {
    2 * B::DEGREE + P::DIM + 6
}

/// The Bernstein coefficients of `|C|²`.
struct Square<B: Basis> {
    /// One more than there are.
    coefficients: B::Bernstein<[B::Scalar; 2]>,
    /// A bound of the rounding errors of the polynomial.
    noise: B::Scalar,
}

impl<B: Basis> Square<B> {
    /// `Σ_{i+j=k} binomial(n, i) binomial(n, j) / binomial(2n, k) P[i]·P[j]`
    #[inline]
    fn of<P: Point<Scalar = B::Scalar>>(points: &B::Bernstein<P>) -> Self {
        let (zero, two) = (B::Scalar::ZERO, B::Scalar::of(2.0));
        let mut coefficients = B::Bernstein::from_fn(|_| [zero; 2]);
        let c = coefficients.as_mut().as_flattened_mut();
        let mut largest = zero;
        for (i, (&p, weight)) in points.as_ref().iter().zip(row(B::DEGREE)).enumerate() {
            let square = dot(p, p);
            largest = largest.max(square);
            c[2 * i] = c[2 * i] + square * B::Scalar::of(weight * weight);
            for (j, (&q, other)) in points.as_ref().iter().zip(row(B::DEGREE)).enumerate().take(i) {
                let both = B::Scalar::of(weight * other);
                c[i + j] = c[i + j] + two * dot(p, q) * both;
            }
        }
        for (c, weight) in c.iter_mut().zip(row(2 * B::DEGREE)) {
            *c = *c * B::Scalar::of(1.0 / weight);
        }
        let noise = largest * B::Scalar::EPSILON * B::Scalar::from_usize(noise_units::<B, P>());
        Self { coefficients, noise }
    }

    fn coefficients(&self) -> &[B::Scalar] {
        &self.coefficients.as_ref().as_flattened()[..=2 * B::DEGREE]
    }
}
