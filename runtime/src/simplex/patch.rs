//! Control points bound to a family on a simplex.

use core::fmt::{self, Debug, Formatter};

use super::edge::{EdgeBasis, TriangleEdge};
use super::index::SimplexIndex;
use super::net::triangle_point;
use super::normal;
use super::{SimplexBasis, TriangularBasis, finish, partial};
use crate::vector::vectors;
use crate::{Array, CountError, Curve, Point, Point3, Scalar};

/// A triangular patch `S(u, v, w) = Σ b[i,j,k](u, v, w) P[i,j,k]`, `u + v + w = 1`, over control points `P[i,j,k]` in
/// lexicographic order, see [`SimplexIndex`](crate::SimplexIndex).
///
/// ```
/// use basis_runtime::{TriangleIndex, TriangularPatch, basis};
///
/// basis! {
///     family Quadratic {
///         domain triangle (u, v, w);
///         b[i, j, k] = 2/(factorial(i)*factorial(j)*factorial(k)) * u^i * v^j * w^k for i, j, k in simplex(2);
///     }
/// }
/// # fn main() {
/// // The points (0,0,2) (0,1,1) (0,2,0) (1,0,1) (1,1,0) (2,0,0) of a bulging triangle.
/// let points = [[0.0, 0.0, 0.0], [0.0, 1.0, 1.0], [0.0, 2.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [2.0, 0.0, 0.0]];
/// let patch = TriangularPatch::new(Quadratic::new(), points);
///
/// assert_eq!(patch.eval(1.0, 0.0), [2.0, 0.0, 0.0]); // the corner u = 1
/// assert_eq!(patch.eval(0.25, 0.25), patch.eval_at([0.25, 0.25, 0.5]));
/// let [[point, along_v], [along_u, _]] = patch.eval_with_partials::<2>(0.25, 0.25);
/// assert_eq!((along_u, along_v), ([2.0, 0.0, 0.5], [0.0, 2.0, 0.5]));
/// assert_eq!(point, [0.5, 0.5, 0.625]);
/// assert!(patch.normal(0.25, 0.25).is_some_and(|normal| normal[2] > 0.9));
///
/// let index = TriangleIndex::new([1, 0, 1]);
/// assert_eq!(patch.control_point(index), Some([1.0, 0.0, 1.0]));
/// # }
/// ```
pub type TriangularPatch<B, P> = SimplexPatch<B, P>;

/// Control points bound to a family on a triangle ([`TriangularPatch`]) or a tetrahedron.
///
/// They are converted to the Bernstein form once; a point then costs one nested sum.
///
/// ```
/// use basis_runtime::{SimplexPatch, TetrahedronIndex, basis};
///
/// basis! {
///     family Solid {
///         domain tetrahedron (u, v, w, x);
///         permute b[1, 0, 0, 0] = u;
///     }
/// }
/// # fn main() {
/// // A temperature at the corners x = 1, w = 1, v = 1, u = 1, and its rates of change.
/// let temperature = SimplexPatch::new(Solid::new(), [10.0, 20.0, 30.0, 50.0]);
/// assert_eq!(temperature.control_point(TetrahedronIndex::new([1, 0, 0, 0])), Some(50.0));
/// assert_eq!(temperature.eval_at([0.25, 0.25, 0.25, 0.25]), 27.5);
/// assert_eq!(temperature.partial_at([0.25, 0.25, 0.25, 0.25], [1, 0, 0]), 40.0);
/// assert_eq!(temperature.derivative([0.25, 0.25, 0.25, 0.25], [1.0, -1.0, 0.0, 0.0], 1), 20.0);
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct SimplexPatch<B: SimplexBasis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    net: B::Bernstein<P>,
}

impl<B: SimplexBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The patch over these control points, one for each function.
    pub fn new(basis: B, points: B::Points<P>) -> Self {
        Self { basis, points, net: basis.to_bernstein(&points) }
    }

    /// The patch over the same control points with other shape values.
    #[must_use]
    pub fn with_basis(&self, basis: B) -> Self {
        Self::new(basis, self.points)
    }

    /// The patch over the images of all control points: the image under an affine map if the functions sum to 1, and always
    /// under a linear one.
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> SimplexPatch<B, Q> {
        SimplexPatch::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The same from a slice.
    ///
    /// # Errors
    /// When the number of points is not the number of functions.
    pub fn from_slice(basis: B, points: &[P]) -> Result<Self, CountError> {
        Ok(Self::new(basis, CountError::one_each(B::NAME, points)?))
    }

    /// The derivative of the given order along a direction, a difference of two points in barycentric coordinates; zero
    /// above the degree.
    pub fn derivative(&self, at: B::Coordinates, along: B::Coordinates, order: usize) -> P::Vector {
        let mut net = self.net;
        let degree = super::differentiate(net.as_mut(), B::DEGREE, along.as_ref(), order);
        finish(net.as_mut(), degree, at.as_ref()).to_vector()
    }

    /// The partial derivative of these orders in the coordinates but the last, which is 1 minus their sum; zero above the
    /// degree.
    pub fn partial_at(&self, at: B::Coordinates, orders: B::Orders) -> P::Vector {
        let mut net = self.net;
        let degree = partial::<P, B::Coordinates>(net.as_mut(), B::DEGREE, orders.as_ref());
        finish(net.as_mut(), degree, at.as_ref()).to_vector()
    }

    /// The point with these barycentric coordinates; at the corners of the domain the Bernstein point there, exactly.
    #[inline]
    pub fn eval_at(&self, at: B::Coordinates) -> P {
        if let [u, v, w] = *at.as_ref() {
            return triangle_point(self.net.as_ref(), B::MULTINOMIALS, [u, v, w], B::DEGREE);
        }
        let mut net = self.net;
        finish(net.as_mut(), B::DEGREE, at.as_ref())
    }

    /// The basis, with its shape parameters.
    #[inline]
    pub fn basis(&self) -> B {
        self.basis
    }

    /// The control points, one for each function, in the lexicographic order of their indices.
    #[inline]
    pub fn control_points(&self) -> &[P] {
        self.points.as_ref()
    }

    /// The control point with an index; `None` when there is none, or when the functions of the family have other
    /// indices than those of one order.
    pub fn control_point<const K: usize>(&self, index: SimplexIndex<K>) -> Option<P> {
        let fits = B::ORDER == Some(index.order()) && <B::Coordinates as Array<B::Scalar>>::LEN == K;
        if fits { self.control_points().get(index.position()).copied() } else { None }
    }

    /// The control points of the same patch in the Bernstein basis of the same degree, in lexicographic order.
    #[inline]
    pub fn to_bernstein(&self) -> B::Bernstein<P> {
        self.net
    }
}

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The point `S(u, v, 1 - u - v)`.
    ///
    /// Coordinates are not clamped: outside of the triangle the polynomial is continued.
    #[inline]
    pub fn eval(&self, u: B::Scalar, v: B::Scalar) -> P {
        self.eval_at([u, v, B::Scalar::ONE - u - v])
    }

    /// The partial derivative `∂ⁱ⁺ʲ S / ∂uⁱ ∂vʲ` of `S(u, v, 1 - u - v)` of the orders `[i, j]`.
    pub fn partial(&self, u: B::Scalar, v: B::Scalar, orders: [usize; 2]) -> P::Vector {
        self.partial_at([u, v, B::Scalar::ONE - u - v], B::Orders::from_fn(|k| orders[k]))
    }

    /// The partial derivatives `[i][j]` = `∂ⁱ⁺ʲ S / ∂uⁱ ∂vʲ` of `S(u, v, 1 - u - v)` for all `i, j < K`; `[0][0]` is
    /// the vector from the origin to the point.
    pub fn eval_with_partials<const K: usize>(&self, u: B::Scalar, v: B::Scalar) -> [[P::Vector; K]; K] {
        let at = [u, v, B::Scalar::ONE - u - v];
        let mut partials = [[P::Vector::zero(); K]; K];
        let (mut along_u, mut u_degree) = (self.net, B::DEGREE);
        for (i, row) in partials.iter_mut().enumerate() {
            let (mut along_v, mut degree) = (along_u, u_degree);
            for (j, derivative) in row.iter_mut().enumerate().take((B::DEGREE + 1).saturating_sub(i)) {
                let mut net = along_v;
                let value = if i + j == 0 { self.eval(u, v) } else { finish(net.as_mut(), degree, &at) };
                *derivative = value.to_vector();
                if degree > 0 {
                    degree = partial::<P, B::Coordinates>(along_v.as_mut(), degree, &[0, 1]);
                }
            }
            if u_degree > 0 {
                u_degree = partial::<P, B::Coordinates>(along_u.as_mut(), u_degree, &[1, 0]);
            }
        }
        partials
    }

    /// The unit normal at `(u, v)`, the direction of `S_u × S_v`, or where that vanishes its limit from inside of the
    /// triangle.
    ///
    /// `None` where there is no limit, as at the apex of a cone; on a patch that has shrunk to a curve or a point; on a
    /// fold, across which the normal flips; and where the patch is infinite or NaN. That the product vanishes is
    /// recognised up to the rounding errors of the control points. The limit is found from the Newton polygon of
    /// `S_u × S_v` at the point, after common powers of the coordinates are taken out, so that it also exists along an
    /// edge that has shrunk to a point.
    ///
    /// At a zero inside of the triangle the limits of the three triangles that meet there must agree, as they do for
    /// `(x² - y², 2xy, 0)`. Where a curve of zeros passes through the inside, as `x = 0` for `(x³, y, 0)`, the answer
    /// is `None`, even if the normals on both sides are the same.
    pub fn normal(&self, u: B::Scalar, v: B::Scalar) -> Option<P::Vector>
    where
        P: Point3,
    {
        let at = [u, v, B::Scalar::ONE - u - v];
        normal::normal::<B, P::Vector>(vectors(self.net.as_ref()), B::DEGREE, at)
    }

    /// The boundary curve along an edge, from its start to its end, over the interval from 0 to 1.
    ///
    /// When the family allows it, its control points are those of the edge, and its family the restriction of the basis
    /// to the edge; otherwise it is a Bézier curve. Either way it is the edge of the patch as a polynomial; what
    /// [`BoundedSurface::boundary`](crate::BoundedSurface::boundary) gives of surfaces of any type is the same curve
    /// with the same parameter.
    pub fn edge_curve(&self, edge: TriangleEdge) -> Curve<EdgeBasis<B>, P> {
        let points = if B::OWN_EDGES { self.points.as_ref() } else { self.net.as_ref() };
        let last = <B::EdgePoints<P> as Array<P>>::LEN - 1;
        let basis = EdgeBasis::new(self.basis, edge);
        Curve::new(basis, B::EdgePoints::from_fn(|k| points[edge.index(last, k).position()]))
    }
}

// The net follows from the basis and the control points, so neither of these looks at it.

impl<B: SimplexBasis, P: Point<Scalar = B::Scalar>> PartialEq for SimplexPatch<B, P> {
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: SimplexBasis, P: Point<Scalar = B::Scalar>> Debug for SimplexPatch<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("SimplexPatch")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
