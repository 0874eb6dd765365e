//! Families on boxes, products of intervals: what they provide, and the patches over them.

mod bounds;
pub(crate) mod net;
mod surface;

use core::fmt::{self, Debug, Formatter};

pub use net::box_sum;

use crate::basis::combination;
use crate::domain::{inverse_width, unit};
use crate::matrices::{self, Kind};
use crate::{Array, CountError, Point, Scalar};
use net::{differentiate, finish};

/// A family of polynomial basis functions on a box, with its shape parameters set to values.
///
/// [`basis!`](crate::basis!) implements it for the types that it generates. Functions and control points stand in the
/// lexicographic order of their indices, the last index fastest.
///
/// ```
/// use basis_runtime::{BoxBasis, basis};
///
/// basis! {
///     family Sheet {
///         domain 0 <= u <= 2, 0 <= v <= 1;
///         b[0] = u*v;
///         b[1] = 1 - u*v;
///     }
/// }
/// # fn main() {
/// assert_eq!(Sheet::<f64>::domain(), [[0.0, 0.0], [2.0, 1.0]]);
/// assert_eq!(Sheet::new().values([1.0, 0.5]), [0.5, 0.5]);
/// assert_eq!(Sheet::new().partials([1.0, 0.5], [1, 1]), [1.0, -1.0]);
/// # }
/// ```
pub trait BoxBasis: Copy + PartialEq + Debug {
    /// The type of coordinates, values and shape parameters.
    type Scalar: Scalar;

    /// A point of the box: `[S; 2]`, `[S; 3]`, …
    type Coordinates: Array<Self::Scalar> + PartialEq + Debug;

    /// One order of differentiation for each coordinate.
    type Orders: Array<usize>;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each function of the tensor product Bernstein basis of the same degrees, the last index fastest.
    type Bernstein<T: Copy>: Array<T>;

    /// The name of the family in its spec, with its order.
    const NAME: &'static str;

    /// The proved bounds of the rounding errors of [`values`](Self::values), one for each function; of families that
    /// were written by hand, and without the feature `rounding`, there are none.
    const ROUNDING: &'static [crate::Rounding] = &[];

    /// A proved bound of the rounding error of each component of a point of a patch, binding included, in ε times the
    /// largest absolute value of that component of a control point; `None` where none is known.
    const ROUNDING_POINT: Option<f64> = None;

    /// The degree of the functions in each coordinate.
    const DEGREES: &'static [usize];

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The lowest and the highest corner of the box.
    fn domain() -> [Self::Coordinates; 2];

    /// The values of all functions.
    fn values(&self, at: Self::Coordinates) -> Self::Values;

    /// The weights `c[α][i]` of the control points in the Bernstein net; by columns the Bernstein coefficients of the
    /// functions.
    fn bernstein_weights(&self) -> Self::Bernstein<Self::Values>;

    /// The partial derivatives of these orders in the coordinates; zero above the degrees.
    fn partials(&self, at: Self::Coordinates, orders: Self::Orders) -> Self::Values {
        if orders.as_ref().iter().all(|&order| order == 0) {
            return self.values(at);
        }
        let mut weights = self.bernstein_weights();
        partial::<Self, _>(weights.as_mut(), at, orders)
    }

    /// The values of all functions at many points, and their derivatives up to that order in the coordinates: what
    /// [`values`](Self::values) and [`partials`](Self::partials) give, with everything that does not depend on the
    /// points computed once.
    #[cfg(feature = "elements")]
    fn tabulate(
        &self,
        at: &[Self::Coordinates],
        order: usize,
    ) -> crate::Tabulation<Self::Scalar, Self::Orders> {
        crate::elements::tabulate_box(self, at, order)
    }

    /// Which functions belong to which corner, edge or face, or to the inside.
    #[cfg(feature = "elements")]
    fn entities(&self) -> crate::Entities {
        let factors: alloc::vec::Vec<_> =
            Self::DEGREES.iter().map(|&degree| crate::elements::Factor::interval(degree)).collect();
        crate::elements::in_cell(self.bernstein_weights().as_ref(), &factors)
    }

    /// The nodes of the family, one point for each function, at which it has the value 1 and all others are 0, up to
    /// rounding errors: nodes on the boundary lie on it exactly. `None` if there are none, or if the functions do not span
    /// the coordinates.
    #[cfg(feature = "elements")]
    fn nodes(&self) -> Option<Self::Points<Self::Coordinates>> {
        crate::elements::box_nodes(self)
    }

    /// The control points of the same patch in the tensor product Bernstein basis of the same degrees:
    /// `Σ_i c[α][i] points[i]` with the [`bernstein_weights`](Self::bernstein_weights) `c`.
    fn to_bernstein<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Bernstein<P> {
        let weights = self.bernstein_weights();
        Self::Bernstein::from_fn(|j| {
            let row = weights.as_ref()[j];
            let used = points.as_ref().iter().copied().zip(row.as_ref().iter().copied());
            combination(used.filter(|(_, weight)| *weight != Self::Scalar::ZERO))
        })
    }

    /// The mass matrix: the integrals `∫ b[i] b[j]` over the box, row by row.
    ///
    /// Those of the Bernstein polynomials are fractions, and the matrix is `cᵀ G c` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    #[must_use]
    fn mass_matrix(&self) -> Self::Points<Self::Values> {
        let ([low, high], weights) = (Self::domain(), self.bernstein_weights());
        matrices::on_box(Kind::Mass, weights.as_ref(), Self::DEGREES, low.as_ref(), high.as_ref())
    }

    /// The stiffness matrix: the integrals `∫ ∇b[i] · ∇b[j]` over the box, row by row.
    #[must_use]
    fn stiffness_matrix(&self) -> Self::Points<Self::Values> {
        let ([low, high], weights) = (Self::domain(), self.bernstein_weights());
        matrices::on_box(Kind::Stiffness, weights.as_ref(), Self::DEGREES, low.as_ref(), high.as_ref())
    }
}

/// The partial derivative of these orders of a net, at a point of the box.
fn partial<B: BoxBasis, P: Point<Scalar = B::Scalar>>(
    net: &mut [P],
    at: B::Coordinates,
    orders: B::Orders,
) -> P {
    let [low, high] = B::domain();
    let mut scale = B::Scalar::ONE;
    let mut len = net.len();
    // One coordinate after the other, from the last, whose coefficients are neighbours.
    for (axis, &degree) in B::DEGREES.iter().enumerate().rev() {
        let range = [low.as_ref()[axis], high.as_ref()[axis]];
        let order = orders.as_ref()[axis];
        if order > degree {
            return P::zero();
        }
        let (width, inverse) = (degree + 1, inverse_width(range));
        for fibre in 0..len / width {
            let coefficients = &mut net[fibre * width..(fibre + 1) * width];
            differentiate(coefficients, order);
            net[fibre] =
                finish(&mut net[fibre * width..(fibre + 1) * width - order], unit(range, at.as_ref()[axis]));
        }
        for _ in 0..order {
            scale = scale * inverse;
        }
        len /= width;
    }
    net[0].scale(scale)
}

/// Control points bound to a family on a box: `S(ξ, η, …) = Σ b[i](ξ, η, …) P[i]`.
///
/// They are converted to the Bernstein form once. A patch of two variables is a [`Surface`](crate::Surface).
///
/// ```
/// use basis_runtime::{BoxPatch, basis};
///
/// basis! {
///     family Quadrilateral {
///         domain -1 <= ξ <= 1, -1 <= η <= 1;
///         b[i, j] = (1 + (2*i - 1)*ξ)/2 * (1 + (2*j - 1)*η)/2 for i in 0..=1, j in 0..=1;
///     }
/// }
/// # fn main() {
/// // The points of b[0,0], b[0,1], b[1,0], b[1,1].
/// let element = BoxPatch::new(Quadrilateral::new(), [[0.0, 0.0], [0.0, 2.0], [4.0, 0.0], [6.0, 3.0]]);
/// assert_eq!(element.eval_at([-1.0, 1.0]), [0.0, 2.0]);
/// assert_eq!(element.eval_at([0.0, 0.0]), [2.5, 1.25]);
/// assert_eq!(element.partial_at([0.0, 0.0], [1, 0]), [2.5, 0.25]); // a column of the Jacobian matrix
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct BoxPatch<B: BoxBasis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    net: B::Bernstein<P>,
}

impl<B: BoxBasis, P: Point<Scalar = B::Scalar>> BoxPatch<B, P> {
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
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> BoxPatch<B, Q> {
        BoxPatch::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The same from a slice.
    ///
    /// # Errors
    /// When the number of points is not the number of functions.
    pub fn from_slice(basis: B, points: &[P]) -> Result<Self, CountError> {
        Ok(Self::new(basis, CountError::one_each(B::NAME, points)?))
    }

    /// The point of the patch; at the corners of the box the Bernstein point there, exactly.
    ///
    /// Coordinates are not clamped: outside of the box the polynomial is continued.
    pub fn eval_at(&self, at: B::Coordinates) -> P {
        let mut net = self.net;
        partial::<B, P>(net.as_mut(), at, B::Orders::from_fn(|_| 0))
    }

    /// The partial derivative of these orders in the coordinates; zero above the degrees.
    pub fn partial_at(&self, at: B::Coordinates, orders: B::Orders) -> P::Vector {
        let mut net = self.net;
        partial::<B, P>(net.as_mut(), at, orders).to_vector()
    }

    /// The lowest and the highest corner of the box.
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

    /// The control points of the same patch in the tensor product Bernstein basis of the same degrees, the last index
    /// fastest.
    pub fn to_bernstein(&self) -> B::Bernstein<P> {
        self.net
    }
}

// The net follows from the basis and the control points, so neither of these looks at it.

impl<B: BoxBasis, P: Point<Scalar = B::Scalar>> PartialEq for BoxPatch<B, P> {
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: BoxBasis, P: Point<Scalar = B::Scalar>> Debug for BoxPatch<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("BoxPatch")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
