//! The edges of triangular patches: the restriction of a basis to an edge is a family on an interval.

use super::TriangularBasis;
use super::index::TriangleIndex;
use crate::{Array, Basis, Edge, Point, Scalar};

/// An edge of a triangle that has a curve; the corners are where u = 1, v = 1 and w = 1.
///
/// An [`Edge`] is a side of the parameters of any surface, of a triangle three of them and the corner `u = 1`, on which
/// there is no family and nothing to divide: hence this type for the three. Each is the [`Edge`] that it is converted
/// to, in the same direction.
///
/// ```
/// use basis_runtime::{Edge, SurfaceDomain, TriangleEdge, TriangleIndex, TriangularPatch, basis};
///
/// basis! {
///     family Linear {
///         domain triangle (u, v, w);
///         permute b[1, 0, 0] = u;
///     }
/// }
/// # fn main() {
/// // The points of w = 1, v = 1, u = 1.
/// let patch = TriangularPatch::new(Linear::new(), [[0.0, 0.0], [0.0, 1.0], [4.0, 0.0]]);
/// let edge = patch.edge_curve(TriangleEdge::W);
/// assert_eq!((edge.start(), edge.end()), ([0.0, 1.0], [4.0, 0.0]));
/// assert_eq!(edge.eval(0.25), patch.eval_at(TriangleEdge::W.point(0.25)));
/// assert_eq!(TriangleEdge::W.index(1, 0), TriangleIndex::new([0, 1, 0]));
/// assert_eq!(Edge::from(TriangleEdge::W), Edge::VEnd);
/// assert_eq!(SurfaceDomain::Triangle.on_edge(Edge::VEnd, 0.25), (0.25, 0.75)); // as TriangleEdge::W.point(0.25)
/// assert_eq!(TriangleEdge::of(Edge::UEnd), None); // the corner u = 1
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum TriangleEdge {
    /// The edge u = 0, from the corner w = 1 to the corner v = 1: [`Edge::UStart`].
    U,
    /// The edge v = 0, from the corner w = 1 to the corner u = 1: [`Edge::VStart`].
    V,
    /// The edge w = 0, from the corner v = 1 to the corner u = 1: [`Edge::VEnd`].
    W,
}

impl TriangleEdge {
    /// All three.
    pub const ALL: [Self; 3] = [Self::U, Self::V, Self::W];

    /// The edge of a triangle that is this side of the parameters; `None` for [`Edge::UEnd`], which is a corner.
    pub const fn of(edge: Edge) -> Option<Self> {
        match edge {
            Edge::UStart => Some(Self::U),
            Edge::UEnd => None,
            Edge::VStart => Some(Self::V),
            Edge::VEnd => Some(Self::W),
        }
    }

    /// Which coordinate is 1 at the start, and which at the end.
    pub(super) const fn corners(self) -> [usize; 2] {
        match self {
            Self::U => [2, 1],
            Self::V => [2, 0],
            Self::W => [1, 0],
        }
    }

    /// Which coordinate is zero on the edge, and 1 at the opposite corner.
    #[cfg(feature = "alloc")]
    pub(super) const fn opposite(self) -> usize {
        match self {
            Self::U => 0,
            Self::V => 1,
            Self::W => 2,
        }
    }

    /// The barycentric coordinates of the point at the parameter `t`, `0 <= t <= 1`.
    pub fn point<S: Scalar>(self, t: S) -> [S; 3] {
        let [start, end] = self.corners();
        let mut point = [S::ZERO; 3];
        point[start] = S::ONE - t;
        point[end] = t;
        point
    }

    /// The index of the control point at that place on the edge, for a patch of that order; from 0 at the start to
    /// `order` at the end, where all further ones are.
    pub const fn index(self, order: usize, place: usize) -> TriangleIndex {
        let [start, end] = self.corners();
        let place = if place < order { place } else { order };
        let mut components = [0; 3];
        components[start] = order - place;
        components[end] = place;
        TriangleIndex::new(components)
    }
}

impl From<TriangleEdge> for Edge {
    fn from(edge: TriangleEdge) -> Self {
        match edge {
            TriangleEdge::U => Self::UStart,
            TriangleEdge::V => Self::VStart,
            TriangleEdge::W => Self::VEnd,
        }
    }
}

/// The restriction of a family on a triangle to an edge, as a family on the interval from 0 to 1.
///
/// Its functions belong to the control points of the edge, in the direction of the edge. Where other control points
/// have an influence on the edge, see [`TriangularBasis::OWN_EDGES`], it is the Bernstein basis of the degree of the
/// family instead.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EdgeBasis<B> {
    basis: B,
    edge: TriangleEdge,
}

impl<B: TriangularBasis> EdgeBasis<B> {
    /// The restriction of a basis to an edge.
    pub const fn new(basis: B, edge: TriangleEdge) -> Self {
        Self { basis, edge }
    }

    /// The basis on the triangle.
    pub fn basis(&self) -> B {
        self.basis
    }

    /// The edge.
    pub fn edge(&self) -> TriangleEdge {
        self.edge
    }

    /// Where the function of that place on the edge stands among the functions of the triangle.
    fn position(&self, place: usize) -> usize {
        self.edge.index(<B::EdgePoints<()> as Array<()>>::LEN - 1, place).position()
    }
}

impl<B: TriangularBasis> Basis for EdgeBasis<B> {
    type Scalar = B::Scalar;
    type Values = B::EdgeValues;
    type Points<T: Copy> = B::EdgePoints<T>;
    type Bernstein<T: Copy> = B::EdgeBernstein<T>;
    type Form<P: Point<Scalar = B::Scalar>> = B::EdgeForm<P>;

    /// The name of the family on the triangle.
    const NAME: &'static str = B::NAME;

    fn domain() -> [B::Scalar; 2] {
        [B::Scalar::ZERO, B::Scalar::ONE]
    }

    fn values(&self, t: B::Scalar) -> B::EdgeValues {
        if B::OWN_EDGES {
            let values = self.basis.values(self.edge.point(t));
            return B::EdgeValues::from_fn(|place| values.as_ref()[self.position(place)]);
        }
        // The Bernstein functions: binomial(n, k) s^(n-k) t^k, the multinomial factors of the edge.
        let [s, t] = [B::Scalar::ONE - t, t];
        let power = |x: B::Scalar, k: usize| (0..k).fold(B::Scalar::ONE, |power, _| power * x);
        B::EdgeValues::from_fn(|place| {
            let factor = B::Scalar::of(B::MULTINOMIALS[self.position(place)]);
            factor * power(s, B::DEGREE - place) * power(t, place)
        })
    }

    fn bernstein_weights(&self) -> B::EdgeBernstein<B::EdgeValues> {
        let weights = B::OWN_EDGES.then(|| self.basis.bernstein_weights());
        B::EdgeBernstein::from_fn(|row| match &weights {
            Some(weights) => {
                let row = weights.as_ref()[self.edge.index(B::DEGREE, row).position()];
                B::EdgeValues::from_fn(|place| row.as_ref()[self.position(place)])
            }
            None => B::EdgeValues::from_fn(|k| if k == row { B::Scalar::ONE } else { B::Scalar::ZERO }),
        })
    }

    fn bind<P: Point<Scalar = B::Scalar>>(&self, points: &B::EdgePoints<P>) -> B::EdgeForm<P> {
        B::edge_form(&self.to_bernstein(points))
    }
}
