//! The Bernstein basis on a triangle, of any degree, as a family of basis functions.

use core::marker::PhantomData;

use super::index::TriangleIndex;
use super::{SimplexBasis, TriangularBasis, TriangularPatch};
use crate::__private::multinomials;
use crate::{Array, BernsteinForm, Point, Scalar};

/// The Bernstein basis on a triangle, of degree `n = N - 1`, with `T = (n+1)(n+2)/2` functions, `N` of them on each
/// edge: `b[i,j,k](u, v, w) = n!/(i! j! k!) u^i v^j w^k`.
///
/// Patches over it are [`TriangularBezier`] patches. Every triangular patch has this form:
/// [`TriangularPatch::to_bezier`](crate::SimplexPatch::to_bezier), and the parts that `split_edge` and `part` return.
///
/// ```
/// use basis_runtime::{SimplexBasis, TriangularBernsteinBasis};
///
/// let quadratic = TriangularBernsteinBasis::<f64, 3, 6>::new();
/// assert_eq!(quadratic.values([0.5, 0.25, 0.25]), [0.0625, 0.125, 0.0625, 0.25, 0.25, 0.25]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TriangularBernsteinBasis<S, const N: usize, const T: usize> {
    scalar: PhantomData<S>,
}

impl<S: Scalar, const N: usize, const T: usize> TriangularBernsteinBasis<S, N, T> {
    /// The basis; that `T` belongs to `N` is checked when the call is compiled.
    #[inline]
    pub const fn new() -> Self {
        const {
            assert!(N > 0, "a Bernstein basis has at least one function");
            assert!(
                T == TriangleIndex::count(N - 1),
                "a triangle with N functions on each edge has N (N + 1) / 2"
            );
        };
        Self { scalar: PhantomData }
    }
}

impl<S: Scalar, const N: usize, const T: usize> Default for TriangularBernsteinBasis<S, N, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const N: usize, const T: usize> SimplexBasis for TriangularBernsteinBasis<S, N, T> {
    type Scalar = S;
    type Coordinates = [S; 3];
    type Orders = [usize; 2];
    type Values = [S; T];
    type Points<X: Copy> = [X; T];
    type Bernstein<X: Copy> = [X; T];

    const NAME: &'static str = "TriangularBernstein";
    const DEGREE: usize = N - 1;
    const ORDER: Option<usize> = Some(N - 1);
    const MULTINOMIALS: &'static [f64] = &const { multinomials::<T>(3, N - 1) };

    fn values(&self, at: [S; 3]) -> [S; T] {
        let powers = at.map(|x| {
            let mut power = S::ONE;
            core::array::from_fn::<S, N, _>(|k| {
                if k > 0 {
                    power = power * x;
                }
                power
            })
        });
        let mut indices = TriangleIndex::all(N - 1);
        core::array::from_fn(|position| {
            let [i, j, k] = indices.next().map_or([0; 3], TriangleIndex::components);
            S::of(Self::MULTINOMIALS[position]) * powers[0][i] * powers[1][j] * powers[2][k]
        })
    }

    fn bernstein_weights(&self) -> [[S; T]; T] {
        core::array::from_fn(|i| core::array::from_fn(|j| if i == j { S::ONE } else { S::ZERO }))
    }

    #[inline]
    fn to_bernstein<P: Point<Scalar = S>>(&self, points: &[P; T]) -> [P; T] {
        *points
    }
}

impl<S: Scalar, const N: usize, const T: usize> TriangularBasis for TriangularBernsteinBasis<S, N, T> {
    type EdgeValues = [S; N];
    type EdgePoints<X: Copy> = [X; N];
    type EdgeBernstein<X: Copy> = [X; N];
    type EdgeForm<P: Point<Scalar = S>> = BernsteinForm<P, N>;

    const OWN_EDGES: bool = true;

    #[inline]
    fn edge_form<P: Point<Scalar = S>>(points: &[P; N]) -> BernsteinForm<P, N> {
        BernsteinForm::new(*points)
    }
}

/// Raises the degree of a net whose first elements are those of the lower degree, in place:
/// `(n + 1) Q[i,j,k] = i P[i-1,j,k] + j P[i,j-1,k] + k P[i,j,k-1]` for each step from `n` to `n + 1`.
pub(super) fn elevate<P: Point>(net: &mut [P], from: usize, to: usize) {
    for degree in from..to {
        let share = P::Scalar::ONE / P::Scalar::from_usize(degree + 1);
        // From the last element down: those below stand at lower positions, and each step moves them up.
        let count = TriangleIndex::count(degree + 1);
        for position in (0..count).rev() {
            let components =
                TriangleIndex::at(degree + 1, position).map_or([0; 3], TriangleIndex::components);
            let below = |place: usize| {
                let mut below = components;
                below[place] -= 1;
                net[TriangleIndex::new(below).position()]
            };
            // A corner stays what it is.
            net[position] = match components.iter().position(|&count| count == degree + 1) {
                Some(corner) => below(corner),
                None => (0..3).filter(|&place| components[place] > 0).fold(P::zero(), |sum, place| {
                    sum.add_weighted(below(place), P::Scalar::from_usize(components[place]) * share)
                }),
            };
        }
    }
}

/// The Bernstein basis on a triangle of the same degree as the family `B`.
pub type TriangularBernsteinOf<B> = <<B as TriangularBasis>::EdgeBernstein<()> as Array<()>>::OnTriangle<
    <B as SimplexBasis>::Scalar,
    <B as SimplexBasis>::Bernstein<()>,
>;

/// A triangular Bézier patch of degree `N - 1` with `T` control points, `N` of them on each edge.
///
/// ```
/// use basis_runtime::TriangularBezier;
///
/// let patch = TriangularBezier::<f64, 3, 6>::from_points([0.0, 0.0, 4.0, 2.0, 1.0, 8.0]);
/// assert_eq!(patch.eval_at([0.5, 0.5, 0.0]), 3.5);
/// ```
pub type TriangularBezier<P, const N: usize, const T: usize> =
    TriangularPatch<TriangularBernsteinBasis<<P as Point>::Scalar, N, T>, P>;

/// A part of a triangular patch over the family `B`, or all of it, as a Bézier patch of the same degree.
pub type TriangularBezierOf<B, P> = TriangularPatch<TriangularBernsteinOf<B>, P>;

impl<P: Point, const N: usize, const T: usize> TriangularBezier<P, N, T> {
    /// The Bézier patch over these control points, in lexicographic order of their indices.
    pub fn from_points(points: [P; T]) -> Self {
        Self::new(TriangularBernsteinBasis::new(), points)
    }
}
