//! The two parameter directions and the four edges of a surface, and edges of two surfaces that belong together.

use crate::surface::ScalarOf;
use crate::vector::distance;
use crate::{Point, Scalar, Surface};

/// One of the two parameter directions of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// The first parameter, which numbers the rows of a net.
    U,
    /// The second parameter, which numbers the columns of a net.
    V,
}

/// How two directions along one line are related, or two normals of one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Orientation {
    /// They are the same.
    Same,
    /// One is the reverse of the other.
    Opposite,
}

/// An edge of the parameters of a surface, a rectangle or a triangle: see [`SurfaceDomain`](crate::SurfaceDomain).
/// Those of a triangle that are no corner have a type of their own, [`TriangleEdge`](crate::TriangleEdge), which is
/// converted to this one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Edge {
    /// `u = lo`; runs along `v`.
    UStart,
    /// `u = hi`; runs along `v`. Of a triangle the corner `u = 1`.
    UEnd,
    /// `v = lo`; runs along `u`.
    VStart,
    /// `v = hi`; runs along `u`. Of a triangle `v = 1 - u`.
    VEnd,
}

impl Edge {
    /// All four.
    pub const ALL: [Self; 4] = [Self::UStart, Self::UEnd, Self::VStart, Self::VEnd];

    /// Whether the edge runs along `u`.
    pub fn runs_along_u(self) -> bool {
        matches!(self, Self::VStart | Self::VEnd)
    }

    /// The parameter that is constant on the edge, of a triangle but for `VEnd`.
    pub fn across(self) -> Direction {
        if self.runs_along_u() { Direction::V } else { Direction::U }
    }

    /// Whether the constant parameter is at its upper end.
    pub fn is_end(self) -> bool {
        matches!(self, Self::UEnd | Self::VEnd)
    }

    /// The edge on the other side of the surface.
    pub fn opposite(self) -> Self {
        match self {
            Self::UStart => Self::UEnd,
            Self::UEnd => Self::UStart,
            Self::VStart => Self::VEnd,
            Self::VEnd => Self::VStart,
        }
    }

    /// Whether, seen from the side to which the normal points, the surface is to the right of the edge.
    pub(crate) fn surface_on_the_right(self) -> bool {
        matches!(self, Self::UStart | Self::VEnd)
    }

    /// The derivatives along the edge and across it, out of the surface.
    pub(super) fn derivatives<P: Point<Vector = P>>(
        self,
        is_triangle: bool,
        along_u: P,
        along_v: P,
    ) -> [P; 2] {
        let back = |p: P| p.scale(-P::Scalar::ONE);
        match self {
            Self::UEnd if is_triangle => [P::zero(), along_u],
            Self::VEnd if is_triangle => {
                [along_u.minus(along_v), along_u.add_scaled(along_v, P::Scalar::ONE)]
            }
            Self::UStart => [along_v, back(along_u)],
            Self::UEnd => [along_v, along_u],
            Self::VStart => [along_u, back(along_v)],
            Self::VEnd => [along_u, along_v],
        }
    }
}

/// An edge each of two surfaces that belong together: to measure how smoothly they meet there, or to join them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EdgePair {
    /// The edge of the first surface, the one that stays where another one is moved.
    pub first: Edge,
    /// The edge of the second surface, the one that is moved so that it continues the first.
    pub second: Edge,
    /// Whether the parameters along the two edges run in the same direction or in opposite ones.
    pub orientation: Orientation,
}

impl EdgePair {
    /// Edges along which the parameters run in the same direction.
    pub const fn along(first: Edge, second: Edge) -> Self {
        Self { first, second, orientation: Orientation::Same }
    }

    /// Edges along which the parameters run in opposite directions.
    pub const fn against(first: Edge, second: Edge) -> Self {
        Self { first, second, orientation: Orientation::Opposite }
    }

    /// Edges of two surfaces in the direction in which their ends are nearer to each other.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, Edge, EdgePair, TensorSurface};
    ///
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let square = |net: [[[f64; 3]; 2]; 2]| TensorSurface::new(linear, linear, net);
    /// let left = square([[[0.0; 3], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]]);
    /// let right = square([[[1.0, 1.0, 0.0], [1.0, 0.0, 0.0]], [[2.0, 1.0, 0.0], [2.0, 0.0, 0.0]]]);
    /// let pair = EdgePair::nearest(&left, Edge::UEnd, &right, Edge::UStart);
    /// assert_eq!(pair, EdgePair::against(Edge::UEnd, Edge::UStart));
    /// ```
    pub fn nearest<A, B>(first: &A, first_edge: Edge, second: &B, second_edge: Edge) -> Self
    where
        A: Surface + ?Sized,
        B: Surface<Point = A::Point> + ?Sized,
    {
        let ends = [ScalarOf::<A>::ZERO, ScalarOf::<A>::ONE];
        let [start, end] = ends.map(|x| {
            let (u, v) = first.domain().on_edge(first_edge, x);
            first.eval(u, v)
        });
        let [other_start, other_end] = ends.map(|x| {
            let (u, v) = second.domain().on_edge(second_edge, x);
            second.eval(u, v)
        });
        let same = distance(start, other_start) + distance(end, other_end);
        let opposite = distance(start, other_end) + distance(end, other_start);
        if opposite < same {
            Self::against(first_edge, second_edge)
        } else {
            Self::along(first_edge, second_edge)
        }
    }

    /// The edges in the other order.
    pub const fn swapped(self) -> Self {
        Self { first: self.second, second: self.first, orientation: self.orientation }
    }
}
