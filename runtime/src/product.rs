//! Families on products of simplices and intervals, such as prisms: what they provide, and the patches over them.

use core::fmt::{self, Debug, Formatter};

use crate::basis::combination;
use crate::boxes::net;
use crate::domain::{inverse_width, unit};
use crate::matrices::{self, Kind};
use crate::simplex::{derivative_of_net, index::lattice_size};
use crate::{Array, CountError, Point, Scalar};

/// A factor of a domain, with the degree of the functions in its coordinates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DomainFactor {
    /// An interval with one coordinate.
    Interval {
        /// The degree in the coordinate.
        degree: usize,
    },
    /// A triangle with three barycentric coordinates.
    Triangle {
        /// The degree in all of them together.
        degree: usize,
    },
    /// A tetrahedron with four barycentric coordinates.
    Tetrahedron {
        /// The degree in all of them together.
        degree: usize,
    },
}

impl DomainFactor {
    /// The number of coordinates, and how many of them are independent.
    pub(crate) const fn coordinates(self) -> (usize, usize) {
        match self {
            Self::Interval { .. } => (1, 1),
            Self::Triangle { .. } => (3, 2),
            Self::Tetrahedron { .. } => (4, 3),
        }
    }

    /// The degree.
    #[cfg(any(feature = "laws", feature = "elements"))]
    pub(crate) const fn degree(self) -> usize {
        match self {
            Self::Interval { degree } | Self::Triangle { degree } | Self::Tetrahedron { degree } => degree,
        }
    }

    /// The number of Bernstein polynomials of the degree.
    pub(crate) const fn size(self) -> usize {
        match self {
            Self::Interval { degree } => degree + 1,
            Self::Triangle { degree } => lattice_size(3, degree),
            Self::Tetrahedron { degree } => lattice_size(4, degree),
        }
    }
}

/// A family of polynomial basis functions on a product of simplices and intervals, with its shape parameters set to values.
///
/// [`basis!`](crate::basis!) implements it for the types that it generates. A point of the domain has all coordinates
/// of all factors in the order of the spec, on a prism `[u, v, w, z]`; barycentric ones are ≥ 0 with the sum 1.
/// Functions and control points stand in the lexicographic order of their indices, the last index fastest. Barycentric
/// coordinates with another sum are not normalised.
///
/// ```
/// use basis_runtime::{ProductBasis, basis};
///
/// basis! {
///     family Wedge {
///         domain triangle (u, v, w), -1 <= z <= 1;
///         b[i,j,k,l] = u^i * v^j * w^k * (1 + (2*l - 1)*z)/2 for i, j, k in simplex(1), l in 0..=1;
///     }
/// }
/// # fn main() {
/// // b[0,0,1,0], b[0,0,1,1], b[0,1,0,0], …
/// let wedge = Wedge::new();
/// assert_eq!(wedge.values([0.5, 0.25, 0.25, 1.0]), [0.0, 0.25, 0.0, 0.25, 0.0, 0.5]);
/// // In u, with w = 1 - u - v, and z.
/// assert_eq!(wedge.partials([0.5, 0.25, 0.25, 1.0], [1, 0, 1]), [0.5, -0.5, 0.0, 0.0, -0.5, 0.5]);
/// let mass: f64 = wedge.mass_matrix().iter().flatten().sum();
/// assert!((mass - 1.0).abs() < 1e-15); // the volume 1/2 · 2
/// # }
/// ```
pub trait ProductBasis: Copy + PartialEq + Debug {
    /// The type of coordinates, values and shape parameters.
    type Scalar: Scalar;

    /// All coordinates: `[S; 4]` on a prism.
    type Coordinates: Array<Self::Scalar> + PartialEq + Debug;

    /// One order of differentiation for each independent coordinate, of a simplex all but the last: `[usize; 3]` on a prism.
    type Orders: Array<usize>;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each product of Bernstein polynomials of the same degrees, the last factor fastest.
    type Bernstein<T: Copy>: Array<T>;

    /// The name of the family in its spec, with its order.
    const NAME: &'static str;

    /// The proved bounds of the rounding errors of [`values`](Self::values), one for each function, where the
    /// barycentric coordinates add up to 1; of families that were written by hand, and without the feature `rounding`,
    /// there are none.
    const ROUNDING: &'static [crate::Rounding] = &[];

    /// A proved bound of the rounding error of each component of a point of a patch, binding included, in ε times the
    /// largest absolute value of that component of a control point, where barycentric coordinates
    /// add up to 1; `None` where none is known.
    const ROUNDING_POINT: Option<f64> = None;

    /// The factors of the domain.
    const FACTORS: &'static [DomainFactor];

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The lowest and the highest value of each coordinate; of barycentric ones 0 and 1.
    fn domain() -> [Self::Coordinates; 2];

    /// The values of all functions.
    fn values(&self, at: Self::Coordinates) -> Self::Values;

    /// The weights `c[α][i]` of the control points in the Bernstein net; by columns the Bernstein coefficients of the
    /// functions.
    fn bernstein_weights(&self) -> Self::Bernstein<Self::Values>;

    /// The partial derivatives of these orders in the independent coordinates, the last one of each simplex being 1 minus the
    /// others; zero above the degrees.
    fn partials(&self, at: Self::Coordinates, orders: Self::Orders) -> Self::Values {
        if orders.as_ref().iter().all(|&order| order == 0) {
            return self.values(at);
        }
        let mut weights = self.bernstein_weights();
        partial::<Self, _>(weights.as_mut(), at, orders)
    }

    /// The values of all functions at many points, and their derivatives up to that order in the independent coordinates: what
    /// [`values`](Self::values) and [`partials`](Self::partials) give, with the Bernstein coefficients computed once.
    #[cfg(feature = "elements")]
    fn tabulate(
        &self,
        at: &[Self::Coordinates],
        order: usize,
    ) -> crate::Tabulation<Self::Scalar, Self::Orders> {
        crate::elements::tabulate_product(self, at, order)
    }

    /// Which functions belong to which corner, edge or face, or to the inside.
    #[cfg(feature = "elements")]
    fn entities(&self) -> crate::Entities {
        crate::elements::in_cell(self.bernstein_weights().as_ref(), &crate::elements::product(Self::FACTORS))
    }

    /// The nodes of the family, one point for each function, at which it has the value 1 and all others are 0, up to
    /// rounding errors: nodes on the boundary lie on it exactly. `None` if there are none, or if the functions do not span
    /// the coordinates.
    #[cfg(feature = "elements")]
    fn nodes(&self) -> Option<Self::Points<Self::Coordinates>> {
        crate::elements::product_nodes(self)
    }

    /// A rule of quadrature on the domain: the product of those on its factors, exact for polynomials of that degree in the
    /// coordinates of each, the points of the last factor fastest. The weights have the volume of the domain as their sum, as
    /// for [`mass_matrix`](Self::mass_matrix).
    ///
    /// ```
    /// use basis_runtime::{ProductBasis, basis};
    ///
    /// basis!(library "triangles/prisms", QuadraticWedge);
    /// # fn main() -> Result<(), basis_runtime::QuadratureError> {
    /// let wedge = QuadraticWedge::<f64>::new();
    /// let rule = QuadraticWedge::<f64>::quadrature(4)?; // 6 points of the triangle times 3 of the interval
    /// assert_eq!(rule.len(), 18);
    /// let entry = rule.integrate(|at: [f64; 4]| wedge.values(at)[0] * wedge.values(at)[1]);
    /// assert!((entry - wedge.mass_matrix()[0][1]).abs() < 1e-16);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`QuadratureError::Degree`](crate::QuadratureError::Degree) for a degree above 1023, or where a rule without symmetries
    /// would have more than 2²² points.
    #[cfg(feature = "elements")]
    fn quadrature<const K: usize>(
        degree: usize,
    ) -> Result<crate::Quadrature<Self::Coordinates>, crate::QuadratureError>
    where
        Self: ProductBasis<Coordinates = [<Self as ProductBasis>::Scalar; K]>,
    {
        let [low, high] = Self::domain();
        crate::Quadrature::on_product(Self::FACTORS, [low.as_ref(), high.as_ref()], degree)
    }

    /// The control points of the same patch in the Bernstein basis of the same degrees: `Σ_i c[α][i] points[i]` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    fn to_bernstein<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Bernstein<P> {
        let weights = self.bernstein_weights();
        Self::Bernstein::from_fn(|j| {
            let row = weights.as_ref()[j];
            let used = points.as_ref().iter().copied().zip(row.as_ref().iter().copied());
            combination(used.filter(|(_, weight)| *weight != Self::Scalar::ZERO))
        })
    }

    /// The mass matrix: the integrals `∫ b[i] b[j]` over the domain, row by row; of a triangle the reference triangle of the
    /// area 1/2, of a tetrahedron the reference tetrahedron of the volume 1/6.
    #[must_use]
    fn mass_matrix(&self) -> Self::Points<Self::Values> {
        matrix::<Self>(Kind::Mass, self)
    }

    /// The stiffness matrix: the integrals over the domain of the products of the derivatives in each independent
    /// coordinate, summed, row by row.
    #[must_use]
    fn stiffness_matrix(&self) -> Self::Points<Self::Values> {
        matrix::<Self>(Kind::Stiffness, self)
    }
}

fn matrix<B: ProductBasis>(kind: Kind, basis: &B) -> B::Points<B::Values> {
    let ([low, high], weights) = (B::domain(), basis.bernstein_weights());
    matrices::on_product(kind, weights.as_ref(), B::FACTORS, low.as_ref(), high.as_ref())
}

/// The partial derivative of these orders of a net, at a point of the domain.
pub(crate) fn partial<B: ProductBasis, P: Point<Scalar = B::Scalar>>(
    net: &mut [P],
    at: B::Coordinates,
    orders: B::Orders,
) -> P {
    let [low, high] = B::domain();
    let (at, orders) = (at.as_ref(), orders.as_ref());
    let (mut coordinate, mut independent) = (at.len(), orders.len());
    let mut scale = B::Scalar::ONE;
    let mut len = net.len();
    // One factor after the other, from the last, whose coefficients are neighbours.
    for factor in B::FACTORS.iter().rev() {
        let (all, free) = factor.coordinates();
        coordinate -= all;
        independent -= free;
        let (at, orders) = (&at[coordinate..coordinate + all], &orders[independent..independent + free]);
        let size = factor.size();
        for block in 0..len / size {
            let own = &mut net[block * size..(block + 1) * size];
            net[block] = match *factor {
                DomainFactor::Interval { degree } if orders[0] > degree => P::zero(),
                DomainFactor::Interval { .. } => {
                    let range = [low.as_ref()[coordinate], high.as_ref()[coordinate]];
                    net::differentiate(own, orders[0]);
                    net::finish(&mut own[..size - orders[0]], unit(range, at[0]))
                }
                DomainFactor::Triangle { degree } => {
                    derivative_of_net::<P, [B::Scalar; 3]>(own, degree, at, orders)
                }
                DomainFactor::Tetrahedron { degree } => {
                    derivative_of_net::<P, [B::Scalar; 4]>(own, degree, at, orders)
                }
            };
        }
        if let DomainFactor::Interval { .. } = factor {
            for _ in 0..orders[0] {
                scale = scale * inverse_width([low.as_ref()[coordinate], high.as_ref()[coordinate]]);
            }
        }
        len /= size;
    }
    net[0].scale(scale)
}

/// Control points bound to a family on a product of simplices and intervals: `S(u, v, w, z) = Σ b[i](u, v, w, z) P[i]` on a
/// prism.
///
/// They are converted to the Bernstein form once.
///
/// ```
/// use basis_runtime::{ProductPatch, basis};
///
/// basis! {
///     family Wedge {
///         domain triangle (u, v, w), -1 <= z <= 1;
///         b[i,j,k,l] = u^i * v^j * w^k * (1 + (2*l - 1)*z)/2 for i, j, k in simplex(1), l in 0..=1;
///     }
/// }
/// # fn main() {
/// // The points of b[0,0,1,0], b[0,0,1,1], b[0,1,0,0], b[0,1,0,1], b[1,0,0,0], b[1,0,0,1].
/// let corners = [[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 3.0, 0.0], [0.0, 3.0, 2.0], [4.0, 0.0, 0.0], [4.0, 0.0, 3.0]];
/// let element = ProductPatch::new(Wedge::new(), corners);
/// assert_eq!(element.eval_at([1.0, 0.0, 0.0, 1.0]), [4.0, 0.0, 3.0]);
/// assert_eq!(element.eval_at([0.5, 0.5, 0.0, 0.0]), [2.0, 1.5, 1.25]);
/// // Columns of the Jacobian matrix in u, with w = 1 - u - v, and z.
/// assert_eq!(element.partial_at([0.5, 0.5, 0.0, 0.0], [1, 0, 0]), [4.0, 0.0, 0.5]);
/// assert_eq!(element.partial_at([0.5, 0.5, 0.0, 0.0], [0, 0, 1]), [0.0, 0.0, 1.25]);
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct ProductPatch<B: ProductBasis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    net: B::Bernstein<P>,
}

impl<B: ProductBasis, P: Point<Scalar = B::Scalar>> ProductPatch<B, P> {
    /// The patch over these control points, one for each function.
    pub fn new(basis: B, points: B::Points<P>) -> Self {
        Self { basis, points, net: basis.to_bernstein(&points) }
    }

    /// The same from a slice.
    ///
    /// # Errors
    /// When the number of points is not the number of functions.
    pub fn from_slice(basis: B, points: &[P]) -> Result<Self, CountError> {
        Ok(Self::new(basis, CountError::one_each(B::NAME, points)?))
    }

    /// The patch over the same control points with other shape values.
    #[must_use]
    pub fn with_basis(&self, basis: B) -> Self {
        Self::new(basis, self.points)
    }

    /// The patch over the images of all control points: the image under an affine map if the functions sum to 1, and always
    /// under a linear one.
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> ProductPatch<B, Q> {
        ProductPatch::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The point of the patch; at the corners of the domain the Bernstein point there, exactly.
    ///
    /// Coordinates are not clamped: outside of the domain the polynomial is continued.
    pub fn eval_at(&self, at: B::Coordinates) -> P {
        let mut net = self.net;
        partial::<B, P>(net.as_mut(), at, B::Orders::from_fn(|_| 0))
    }

    /// The partial derivative of these orders in the independent coordinates, the last one of each simplex being 1 minus the
    /// others; zero above the degrees.
    pub fn partial_at(&self, at: B::Coordinates, orders: B::Orders) -> P::Vector {
        let mut net = self.net;
        partial::<B, P>(net.as_mut(), at, orders).to_vector()
    }

    /// The smallest axis-parallel box around the Bernstein points, as its two extreme corners: cheap, and never too
    /// small up to rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        crate::vector::box_of(self.net.as_ref())
    }

    /// The lowest and the highest value of each coordinate; of barycentric ones 0 and 1.
    pub fn corners(&self) -> [B::Coordinates; 2] {
        B::domain()
    }

    /// The basis, with its shape parameters.
    pub fn basis(&self) -> B {
        self.basis
    }

    /// The control points, one for each function, in the lexicographic order of their indices.
    pub fn control_points(&self) -> &[P] {
        self.points.as_ref()
    }

    /// The control points of the same patch in the Bernstein basis of the same degrees, the last factor fastest.
    pub fn to_bernstein(&self) -> B::Bernstein<P> {
        self.net
    }
}

// The net follows from the basis and the control points, so neither of these looks at it.

impl<B: ProductBasis, P: Point<Scalar = B::Scalar>> PartialEq for ProductPatch<B, P> {
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: ProductBasis, P: Point<Scalar = B::Scalar>> Debug for ProductPatch<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("ProductPatch")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
