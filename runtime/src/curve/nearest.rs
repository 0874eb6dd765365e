//! The point of a curve nearest to a given one: the global minimum, by branch and bound.
//!
//! On a piece of the curve `f(x) = |C(x) - p|²` is a polynomial, and its smallest Bernstein coefficient bounds it from below.
//! A piece is put aside when this bound shows that it cannot improve on the best point found by more than the accuracy;
//! when `f` is monotone or concave on it, so that an end is nearest; and when `f` is convex on it, after Newton's method.

use alloc::vec;
use alloc::vec::Vec;

use crate::bernstein::{self, simple_root};
use crate::domain::from_unit;
use crate::vector::{distance, is_finite, largest_component};
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
        let seen = B::Bernstein::<P>::from_fn(|i| self.to_bernstein().as_ref()[i].minus(point));
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
        let mut square = vec![zero; 2 * B::DEGREE + 1];
        let (mut slope, mut bend) = (Vec::new(), Vec::new());
        let mut pieces = vec![(curve, zero, one, 0)];
        while let Some((mut piece, from, to, depth)) = pieces.pop() {
            bernstein::dot(piece.as_ref(), piece.as_ref(), &mut square);
            let [lowest, _] = bernstein::bounds(&square);
            if lowest.max(zero).sqrt() >= self.best.distance / size - accuracy {
                continue;
            }
            let middle = from + (to - from) * half;
            slope.clone_from(&square);
            let degree = bernstein::differentiate(&mut slope).len();
            slope.truncate(degree);
            if one_sign(&slope) {
                // The end at which f is smaller is an end of the curve, or of the neighbouring piece.
                self.improve(if slope.iter().any(|&c| c > zero) { from } else { to });
                continue;
            }
            bend.clone_from(&slope);
            let bend = bernstein::differentiate(&mut bend);
            if one_sign(bend) {
                if bend.iter().any(|&c| c < zero) || slope[0] >= zero || slope[slope.len() - 1] <= zero {
                    self.improve(from);
                    self.improve(to);
                } else {
                    self.improve(from + (to - from) * simple_root(&slope));
                }
                continue;
            }
            self.improve(middle);
            if depth == DEPTH {
                continue;
            }
            let mut right = piece;
            bernstein::split(piece.as_mut(), half, right.as_mut());
            let halves = [(piece, from, middle, depth + 1), (right, middle, to, depth + 1)];
            // The half that ends nearer to the point is looked at first: it is last on the stack.
            let [start, end] = [square[0], square[square.len() - 1]];
            pieces.extend(if start < end { [halves[1], halves[0]] } else { halves });
        }
    }
}

/// Whether no two coefficients have different signs.
fn one_sign<S: Scalar>(coefficients: &[S]) -> bool {
    let [lowest, highest] = bernstein::bounds(coefficients);
    lowest >= S::ZERO || highest <= S::ZERO
}
