//! The parameters of a surface: those of a rectangle or of a triangle.

use super::{Direction, Edge};
use crate::curve::inside;
use crate::domain::from_unit;
use crate::{CurveError, Scalar};

/// The parameters `(u, v)` of a surface: all of a rectangle, or all of a triangle.
///
/// Both are ranges of `v` above the range of `u`, and so have the same four [edges](Edge). A triangle is a rectangle whose
/// upper side slopes down to the corner `u = 1`: its edge [`VEnd`](Edge::VEnd) is where `w = 1 - u - v` is zero, and
/// [`UEnd`](Edge::UEnd) is that corner.
///
/// ```text
/// v = 1  |\                v = hi  +------+
///        | \  VEnd                 | VEnd |
///        |  \                      |      |
/// v = 0  +---+ u = 1       v = lo  +------+ u = hi
/// ```
///
/// ```
/// use basis_runtime::{Direction, SurfaceDomain};
///
/// let triangle = SurfaceDomain::<f64>::Triangle;
/// assert!(triangle.contains(0.25, 0.75) && !triangle.contains(0.5, 0.75));
/// assert_eq!(triangle.range(Direction::U, 0.25), [0.0, 0.75]); // of v, where u = 1/4
/// assert_eq!(triangle.at(0.5, 0.5), (0.5, 0.25)); // halfway up above u = 1/2
/// let rectangle = SurfaceDomain::Rectangle([[0.0, 2.0], [1.0, 3.0]]);
/// assert_eq!(rectangle.at(0.5, 0.5), (1.0, 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum SurfaceDomain<S> {
    /// `lo_u <= u <= hi_u`, `lo_v <= v <= hi_v`, as `[[lo_u, hi_u], [lo_v, hi_v]]`.
    Rectangle([[S; 2]; 2]),
    /// `u >= 0`, `v >= 0`, `u + v <= 1`: two barycentric coordinates, of which the third is `w = 1 - u - v`.
    Triangle,
}

impl<S: Scalar> SurfaceDomain<S> {
    /// The smallest and the largest value of each parameter, `[[lo_u, hi_u], [lo_v, hi_v]]`.
    #[inline]
    pub fn ranges(self) -> [[S; 2]; 2] {
        match self {
            Self::Rectangle(ranges) => ranges,
            Self::Triangle => [[S::ZERO, S::ONE]; 2],
        }
    }

    /// The width of both ranges.
    #[inline]
    pub(crate) fn widths(self) -> [S; 2] {
        self.ranges().map(|[lo, hi]| hi - lo)
    }

    /// The smallest and the largest value that one parameter has where the other one is constant: that of direction
    /// `constant`, with the value `at`.
    ///
    /// Outside of a triangle it lies between the two lines on which its edges lie.
    #[inline]
    pub fn range(self, constant: Direction, at: S) -> [S; 2] {
        match (self, constant) {
            (Self::Rectangle([_, v]), Direction::U) => v,
            (Self::Rectangle([u, _]), Direction::V) => u,
            (Self::Triangle, _) => {
                let end = S::ONE - at;
                if end < S::ZERO { [end, S::ZERO] } else { [S::ZERO, end] }
            }
        }
    }

    /// Whether these are parameters of the surface; not of NaN.
    #[inline]
    pub fn contains(self, u: S, v: S) -> bool {
        self.check(u, v).is_ok()
    }

    /// Whether these are parameters of the surface.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] with the one that is not, and the range that it has where the other one is what it is.
    #[inline]
    pub fn check(self, u: S, v: S) -> Result<(), CurveError> {
        inside(self.ranges()[0], u)?;
        inside(self.range(Direction::U, u), v)
    }

    /// The parameters of the surface that are nearest to these; NaN stays.
    #[inline]
    pub fn clamped(self, u: S, v: S) -> (S, S) {
        let [u_range, v_range] = self.ranges();
        let clamp = |[lo, hi]: [S; 2], t: S| {
            if t < lo {
                lo
            } else if t > hi {
                hi
            } else {
                t
            }
        };
        if self == Self::Triangle && u + v > S::ONE {
            // On the line u + v = 1; both may be infinite.
            let beside = if u == v { S::ZERO } else { u - v };
            let u = clamp(u_range, (S::ONE + beside) * S::of(0.5));
            return (u, S::ONE - u);
        }
        let u = clamp(u_range, u);
        let [_, top] = self.range(Direction::U, u);
        let v = clamp(v_range, v);
        (u, if v > top { top } else { v })
    }

    /// The parameters at the place `(x, y)` of the unit square: `u` is linear in `x`, and `v` above it in `y`. The edges
    /// go to the edges of the same names, exactly at both ends.
    ///
    /// ```text
    /// u = lo_u (1 - x) + hi_u x,   v = lo_v (1 - y) + hi_v y        of a rectangle
    /// u = x,                       v = (1 - x) y                    of a triangle
    /// ```
    #[inline]
    pub fn at(self, x: S, y: S) -> (S, S) {
        match self {
            Self::Rectangle([u, v]) => (from_unit(u, x), from_unit(v, y)),
            Self::Triangle => (x, (S::ONE - x) * y),
        }
    }

    /// The parameters at `x` along an edge, `0 <= x <= 1`. Exact at both ends.
    #[inline]
    pub fn on_edge(self, edge: Edge, x: S) -> (S, S) {
        match edge {
            Edge::UStart => self.at(S::ZERO, x),
            Edge::UEnd => self.at(S::ONE, x),
            Edge::VStart => self.at(x, S::ZERO),
            Edge::VEnd => self.at(x, S::ONE),
        }
    }
}
