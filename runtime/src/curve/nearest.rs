//! The point of a curve nearest to a given one: the global minimum, by branch and bound.
//!
//! On a piece of the curve `f(x) = |C(x) - p|²` is a polynomial, and its smallest Bernstein coefficient bounds it from below.
//! A piece is put aside when this bound shows that it cannot improve on the best point found by more than the accuracy;
//! when `f` is monotone or concave on it, so that an end is nearest; and when `f` is convex on it, after Newton's method.

use alloc::vec;
use alloc::vec::Vec;

use crate::bernstein::{self, multiply_binomials, simple_root};
use crate::domain::from_unit;
use crate::vector::{distance, dot, is_finite, largest_component};
use crate::{Array, Basis, Curve, Point, Scalar};

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

/// The point of a curve nearest to a given one; see [`Curve::nearest`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Nearest<P: Point> {
    /// The parameter.
    pub t: P::Scalar,
    /// The point `C(t)`.
    pub point: P,
    /// The distance of `C(t)` from the given point.
    pub distance: P::Scalar,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The point of the curve nearest to `point`, among those with a parameter in the domain.
    ///
    /// It is a global minimum: its distance is at most `accuracy` larger than that of any other point of the curve. This
    /// bound is proved up to rounding: an `accuracy` below some `ε` times the size of the curve as seen from the point, also
    /// zero or NaN, asks for what the scalar type can give. Of several nearest points one is returned. If `point` or a control
    /// point is infinite or NaN, everything in the result is NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// let nearest = parabola.nearest([0.0, -2.0], 1e-9);
    /// assert_eq!((nearest.t, nearest.point, nearest.distance), (0.5, [0.0, 0.0], 2.0));
    /// ```
    pub fn nearest(&self, point: P, accuracy: B::Scalar) -> Nearest<P> {
        let nan = B::Scalar::NAN;
        let mut seen = self.to_bernstein();
        for p in seen.as_mut() {
            *p = p.minus(point);
        }
        let size = seen.as_ref().iter().fold(B::Scalar::ZERO, |size, &p| {
            let component = largest_component(p);
            if component <= size { size } else { component }
        });
        if !seen.as_ref().iter().all(|&p| is_finite(p)) || !size.is_finite() {
            return Nearest { t: nan, point: P::from_components(|_| nan), distance: nan };
        }
        let mut search = Search { curve: self, point, best: self.candidate(point, B::Scalar::ZERO) };
        search.improve(B::Scalar::ONE);
        if size > B::Scalar::ZERO {
            // Scaled, so that no square overflows or vanishes.
            let unit =
                B::Bernstein::<P>::from_fn(|i| P::from_components(|d| seen.as_ref()[i].component(d) / size));
            let rounding = B::Scalar::EPSILON * B::Scalar::from_usize(8 * (B::DEGREE + 1));
            search.run(unit, size, (accuracy / size).max(rounding));
        }
        search.best
    }

    /// The point at `x` in the unit interval.
    fn candidate(&self, point: P, x: B::Scalar) -> Nearest<P> {
        let t = from_unit(B::domain(), x);
        let on_curve = self.eval(t);
        Nearest { t, point: on_curve, distance: distance(on_curve, point) }
    }
}

struct Search<'a, B: Basis, P: Point<Scalar = B::Scalar>> {
    curve: &'a Curve<B, P>,
    point: P,
    best: Nearest<P>,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Search<'_, B, P> {
    fn improve(&mut self, x: B::Scalar) {
        let candidate = self.curve.candidate(self.point, x);
        if candidate.distance < self.best.distance {
            self.best = candidate;
        }
    }

    /// `curve` is the whole curve as seen from the point, divided by `size`; so is `accuracy`.
    fn run(&mut self, curve: B::Bernstein<P>, size: B::Scalar, accuracy: B::Scalar) {
        let [zero, one, half] = [B::Scalar::ZERO, B::Scalar::ONE, B::Scalar::of(0.5)];
        let mut square = Square::new(B::DEGREE);
        let (mut slope, mut bend) = (Vec::new(), Vec::new());
        let mut pieces = vec![(curve, zero, one, 0)];
        while let Some((mut piece, from, to, depth)) = pieces.pop() {
            let square = square.of(piece.as_ref());
            let [lowest, _] = bernstein::bounds(square);
            let gap = self.best.distance / size - accuracy;
            if gap <= zero || lowest >= gap * gap {
                continue;
            }
            slope.clear();
            // The derivative, but for a positive factor.
            slope.extend(square.windows(2).map(|pair| pair[1] - pair[0]));
            if one_sign(&slope) {
                // The end at which f is smaller is an end of the curve, or of the neighbouring piece.
                self.improve(if slope.iter().any(|&c| c > zero) { from } else { to });
                continue;
            }
            bend.clear();
            bend.extend(slope.windows(2).map(|pair| pair[1] - pair[0]));
            if one_sign(&bend) {
                if bend.iter().any(|&c| c < zero) || slope[0] >= zero || slope[slope.len() - 1] <= zero {
                    self.improve(from);
                    self.improve(to);
                } else {
                    self.improve(from + (to - from) * simple_root(&slope));
                }
                continue;
            }
            let [start, end] = [square[0], square[square.len() - 1]];
            let middle = from + (to - from) * half;
            self.improve(middle);
            if depth == DEPTH {
                continue;
            }
            let mut right = piece;
            bernstein::split(piece.as_mut(), half, right.as_mut());
            let halves = [(piece, from, middle, depth + 1), (right, middle, to, depth + 1)];
            // The half that ends nearer to the point is looked at first: it is last on the stack.
            pieces.extend(if start < end { [halves[1], halves[0]] } else { halves });
        }
    }
}

/// The Bernstein coefficients of `|C|²`, with everything that does not depend on the curve computed once.
struct Square<S> {
    /// `binomial(n, i)`
    binomials: Vec<S>,
    /// `1 / binomial(2n, k)`
    inverse: Vec<S>,
    coefficients: Vec<S>,
}

impl<S: Scalar> Square<S> {
    fn new(degree: usize) -> Self {
        let row = |degree: usize| {
            let mut row = vec![S::ONE; degree + 1];
            multiply_binomials(&mut row);
            row
        };
        let inverse = row(2 * degree).into_iter().map(|binomial| S::ONE / binomial).collect();
        Self { binomials: row(degree), inverse, coefficients: vec![S::ZERO; 2 * degree + 1] }
    }

    /// `Σ_{i+j=k} binomial(n, i) binomial(n, j) / binomial(2n, k) P[i]·P[j]`
    fn of<P: Point<Scalar = S>>(&mut self, points: &[P]) -> &[S] {
        self.coefficients.fill(S::ZERO);
        for (i, (&p, &weight)) in points.iter().zip(&self.binomials).enumerate() {
            let p = p.scale(weight);
            self.coefficients[2 * i] = self.coefficients[2 * i] + dot(p, p);
            let p = p.scale(S::of(2.0));
            for (j, (&q, &weight)) in points.iter().zip(&self.binomials).enumerate().take(i) {
                self.coefficients[i + j] = self.coefficients[i + j] + dot(p, q) * weight;
            }
        }
        for (c, &inverse) in self.coefficients.iter_mut().zip(&self.inverse) {
            *c = *c * inverse;
        }
        &self.coefficients
    }
}

/// Whether no two coefficients have different signs.
fn one_sign<S: Scalar>(coefficients: &[S]) -> bool {
    let [lowest, highest] = bernstein::bounds(coefficients);
    lowest >= S::ZERO || highest <= S::ZERO
}
