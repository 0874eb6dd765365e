//! Families on triangles and tetrahedra: what they provide, and the patches over them.

mod bernstein;
mod edge;
pub(crate) mod index;
#[cfg(feature = "alloc")]
mod join;
mod net;
mod normal;
mod parts;
mod patch;
pub(crate) mod raise;
mod shape;

use core::fmt::Debug;

pub use bernstein::{TriangularBernsteinBasis, TriangularBernsteinOf, TriangularBezier, TriangularBezierOf};
pub use edge::{EdgeBasis, TriangleEdge};
pub use index::{SimplexIndex, TetrahedronIndex, TriangleIndex};
#[cfg(feature = "alloc")]
pub use join::TriangleContact;
#[cfg(feature = "elements")]
pub(crate) use net::raised;
#[cfg(feature = "geometry")]
pub(crate) use net::triangle_line;
pub(crate) use net::{simplex_sum, square_row};
pub use patch::{SimplexPatch, TriangularPatch};

use crate::basis::combination;
use crate::matrices::{self, Kind};
use crate::{Array, Form, Point, Scalar};
use net::contract;

/// A family of polynomial basis functions on a triangle or a tetrahedron, with its shape parameters set to values.
///
/// [`basis!`](crate::basis!) implements it for the types that it generates. A point of the domain is given by its
/// barycentric coordinates `[u, v, w]` (on a tetrahedron `[u, v, w, x]`), all ≥ 0 with the sum 1; functions and control
/// points stand in the lexicographic order of their indices, see [`SimplexIndex`]. Coordinates with another sum are not
/// normalised: the formulas are evaluated as they are homogeneous.
///
/// ```
/// use basis_runtime::{SimplexBasis, basis};
///
/// basis! {
///     family Quadratic {
///         domain triangle (u, v, w);
///         permute b[2, 0, 0] = u^2;
///         permute b[1, 1, 0] = 2*u*v;
///     }
/// }
///
/// fn sum<B: SimplexBasis<Scalar = f64>>(basis: B, at: B::Coordinates) -> f64 {
///     basis.values(at).as_ref().iter().sum()
/// }
/// # fn main() {
/// assert_eq!(sum(Quadratic::new(), [0.5, 0.25, 0.25]), 1.0);
/// // b[0,0,2], b[0,1,1], …, b[2,0,0] along the edge from v = 1 to u = 1.
/// let derivatives = Quadratic::new().derivatives([0.5, 0.25, 0.25], [1.0, -1.0, 0.0], 1);
/// assert_eq!(derivatives, [0.0, -0.5, -0.5, 0.5, -0.5, 1.0]);
/// # }
/// ```
pub trait SimplexBasis: Copy + PartialEq + Debug {
    /// The type of coordinates, values and shape parameters.
    type Scalar: Scalar;

    /// Barycentric coordinates: `[S; 3]` or `[S; 4]`.
    type Coordinates: Array<Self::Scalar> + PartialEq + Debug;

    /// One order of differentiation for each independent coordinate, all but the last: `[usize; 2]` or `[usize; 3]`.
    type Orders: Array<usize>;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each function of the Bernstein basis of the same degree.
    type Bernstein<T: Copy>: Array<T>;

    /// The name of the family in its spec, with its order.
    const NAME: &'static str;

    /// The proved bounds of the rounding errors of [`values`](Self::values), one for each function, where the
    /// barycentric coordinates add up to 1; of families that were written by hand, and without the feature `rounding`,
    /// there are none.
    const ROUNDING: &'static [crate::Rounding] = &[];

    /// A proved bound of the rounding error of each component of a point of a patch, binding included, in ε times the
    /// largest absolute value of that component of a control point, where the barycentric coordinates
    /// add up to 1; `None` where none is known.
    const ROUNDING_POINT: Option<f64> = None;

    /// The degree of the functions.
    const DEGREE: usize;

    /// The order `n`, when there is one function for each index with the sum `n`.
    const ORDER: Option<usize>;

    /// The multinomial coefficients `n!/(α₁! α₂! …)` of the Bernstein basis of the degree `n`, in lexicographic order.
    const MULTINOMIALS: &'static [f64];

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The values of all functions.
    fn values(&self, at: Self::Coordinates) -> Self::Values;

    /// The weights `c[α][i]` of the control points in the Bernstein net; by columns the Bernstein coefficients of the
    /// functions: `b[i] = Σ_α c[α][i] · n!/(α₁! α₂! …) u^α₁ v^α₂ …` with `n = DEGREE`.
    fn bernstein_weights(&self) -> Self::Bernstein<Self::Values>;

    /// The derivatives of the given order along a direction, a difference of two points in barycentric coordinates;
    /// zero above the degree.
    ///
    /// On a triangle `[1, -1, 0]` is the edge from the corner `v = 1` to the corner `u = 1`.
    fn derivatives(&self, at: Self::Coordinates, along: Self::Coordinates, order: usize) -> Self::Values {
        if order == 0 {
            return self.values(at);
        }
        let mut weights = self.bernstein_weights();
        let degree = differentiate(weights.as_mut(), Self::DEGREE, along.as_ref(), order);
        finish(weights.as_mut(), degree, at.as_ref())
    }

    /// The partial derivatives of these orders in the coordinates but the last, which is 1 minus their sum; zero above
    /// the degree.
    fn partials(&self, at: Self::Coordinates, orders: Self::Orders) -> Self::Values {
        if orders.as_ref().iter().all(|&order| order == 0) {
            return self.values(at);
        }
        let mut weights = self.bernstein_weights();
        let degree =
            partial::<Self::Values, Self::Coordinates>(weights.as_mut(), Self::DEGREE, orders.as_ref());
        finish(weights.as_mut(), degree, at.as_ref())
    }

    /// The values of all functions at many points, and their derivatives up to that order in the coordinates but the last: what
    /// [`values`](Self::values) and [`partials`](Self::partials) give, with everything that does not depend on the
    /// points computed once.
    #[cfg(feature = "elements")]
    fn tabulate(
        &self,
        at: &[Self::Coordinates],
        order: usize,
    ) -> crate::Tabulation<Self::Scalar, Self::Orders> {
        crate::elements::tabulate_simplex(self, at, order)
    }

    /// Which functions belong to which corner, edge or face, or to the inside.
    #[cfg(feature = "elements")]
    fn entities(&self) -> crate::Entities {
        let corners = <Self::Coordinates as Array<Self::Scalar>>::LEN;
        let factor = crate::elements::Factor::simplex(corners, Self::DEGREE);
        crate::elements::in_cell(self.bernstein_weights().as_ref(), &[factor])
    }

    /// The nodes of the family, one point for each function, at which it has the value 1 and all others are 0, up to
    /// rounding errors: nodes on the boundary lie on it exactly. `None` if there are none, or if the functions do not span
    /// the coordinates.
    #[cfg(feature = "elements")]
    fn nodes(&self) -> Option<Self::Points<Self::Coordinates>> {
        crate::elements::simplex_nodes(self)
    }

    /// The control points of the same patch in the Bernstein basis of the same degree: `Σ_i c[α][i] points[i]` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    fn to_bernstein<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Bernstein<P> {
        let weights = self.bernstein_weights();
        Self::Bernstein::from_fn(|j| {
            let row = weights.as_ref()[j];
            let used = points.as_ref().iter().copied().zip(row.as_ref().iter().copied());
            combination(used.filter(|(_, weight)| *weight != Self::Scalar::ZERO))
        })
    }

    /// The mass matrix: the integrals `∫ b[i] b[j]` over the reference triangle `u, v, 1 - u - v >= 0` of the area 1/2, or
    /// the reference tetrahedron of the volume 1/6, row by row.
    ///
    /// Those of the Bernstein polynomials are fractions, and the matrix is `cᵀ G c` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    #[must_use]
    fn mass_matrix(&self) -> Self::Points<Self::Values> {
        matrix::<Self>(Kind::Mass, self)
    }

    /// The stiffness matrix: the integrals `∫ ∂b[i]/∂u ∂b[j]/∂u + ∂b[i]/∂v ∂b[j]/∂v` over the reference triangle, or those
    /// with the three derivatives over the reference tetrahedron, row by row.
    #[must_use]
    fn stiffness_matrix(&self) -> Self::Points<Self::Values> {
        matrix::<Self>(Kind::Stiffness, self)
    }
}

/// A matrix on the reference triangle or tetrahedron.
fn matrix<B: SimplexBasis>(kind: Kind, basis: &B) -> B::Points<B::Values> {
    let weights = basis.bernstein_weights();
    if <B::Coordinates as Array<B::Scalar>>::LEN == 3 {
        matrices::simplex::<_, _, 3>(kind, weights.as_ref(), B::DEGREE)
    } else {
        matrices::simplex::<_, _, 4>(kind, weights.as_ref(), B::DEGREE)
    }
}

/// A family on a triangle, with its edges.
///
/// [`basis!`](crate::basis!) implements it for every family on a triangle.
pub trait TriangularBasis:
    SimplexBasis<Coordinates = [<Self as SimplexBasis>::Scalar; 3], Orders = [usize; 2]>
{
    /// One value for each control point of an edge.
    type EdgeValues: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element for each control point of an edge.
    type EdgePoints<T: Copy>: Array<T>;

    /// One element for each Bernstein point of an edge: `[T; DEGREE + 1]`.
    type EdgeBernstein<T: Copy>: Array<T>;

    /// A boundary curve, ready to be evaluated.
    type EdgeForm<P: Point<Scalar = Self::Scalar>>: Form<P>;

    /// Whether on every edge all functions vanish but those of its own control points, so that a boundary curve depends
    /// on these alone; otherwise it is a Bézier curve.
    const OWN_EDGES: bool;

    /// The curve with these Bernstein points.
    fn edge_form<P: Point<Scalar = Self::Scalar>>(points: &Self::EdgeBernstein<P>) -> Self::EdgeForm<P>;
}

/// Differentiates a net along a direction; the degree that is left.
fn differentiate<P: Point>(net: &mut [P], degree: usize, along: &[P::Scalar], order: usize) -> usize {
    if order > degree {
        net.fill(P::zero());
        return 0;
    }
    for m in (degree - order + 1..=degree).rev() {
        contract(net, m, along);
        for element in &mut net[..] {
            *element = element.scale(P::Scalar::from_usize(m));
        }
    }
    degree - order
}

/// Differentiates a net in all coordinates but the last; the degree that is left.
pub(crate) fn partial<P: Point, C: Array<P::Scalar>>(
    net: &mut [P],
    degree: usize,
    orders: &[usize],
) -> usize {
    let last = orders.len();
    orders.iter().enumerate().fold(degree, |degree, (place, &order)| {
        let along = C::from_fn(|j| match j {
            _ if j == place => P::Scalar::ONE,
            _ if j == last => -P::Scalar::ONE,
            _ => P::Scalar::ZERO,
        });
        differentiate(net, degree, along.as_ref(), order)
    })
}

/// The partial derivative of these orders of a net, at a point.
pub(crate) fn derivative_of_net<P: Point, C: Array<P::Scalar>>(
    net: &mut [P],
    degree: usize,
    at: &[P::Scalar],
    orders: &[usize],
) -> P {
    let degree = partial::<P, C>(net, degree, orders);
    finish(net, degree, at)
}

/// De Casteljau's algorithm to the end.
fn finish<P: Point>(net: &mut [P], degree: usize, at: &[P::Scalar]) -> P {
    for m in (1..=degree).rev() {
        contract(net, m, at);
    }
    net[0]
}
