//! Triangular patches as surfaces: over the triangle, and as tensor surfaces over the unit square.

#[cfg(feature = "geometry")]
use super::forward_boxes;
use super::partials_by_number;
use crate::simplex::square_row;
use crate::{
    Array, Basis, Point, Point3, SimplexPatch, Surface, SurfaceDomain, TensorSurface, TriangularBasis,
};
#[cfg(feature = "geometry")]
use crate::{BoundedSurface, Nearest, SurfacePiece};

/// The Bernstein basis of the degree of a family on a triangle.
type Side<B> =
    <<B as TriangularBasis>::EdgeBernstein<()> as Array<()>>::Basis<<B as crate::SimplexBasis>::Scalar>;

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The same patch as a tensor surface over the unit square, whose edge `x = 1` is the corner `u = 1`:
    ///
    /// ```text
    /// u = x,   v = (1 - x) y,   w = (1 - x) (1 - y)
    /// ```
    ///
    /// as by [`SurfaceDomain::at`]. With the Bernstein points `p`, row `i` is the curve over `p[i, k, n-i-k]`,
    /// `k = 0, …, n-i`, with its degree raised to `n`. The patch is a [`Surface`] itself; this one is made of
    /// control points of the usual kind, and has parts over rectangles.
    pub fn to_tensor_surface(&self) -> TensorSurface<Side<B>, Side<B>, P> {
        let net = self.to_bernstein();
        let rows = <Side<B> as Basis>::Points::<<Side<B> as Basis>::Points<P>>::from_fn(|i| {
            let mut row = <Side<B> as Basis>::Points::<P>::from_fn(|_| P::zero());
            square_row(net.as_ref(), B::DEGREE, i, row.as_mut());
            row
        });
        TensorSurface::new(Side::<B>::default(), Side::<B>::default(), rows)
    }
}

/// Over the triangle: `S(u, v, 1 - u - v)`.
impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> Surface for SimplexPatch<B, P> {
    type Point = P;

    #[inline]
    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        SurfaceDomain::Triangle
    }

    #[inline]
    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        self.eval(u, v)
    }

    #[inline]
    fn partial(&self, u: P::Scalar, v: P::Scalar, orders: [usize; 2]) -> P::Vector {
        self.partial(u, v, orders)
    }

    partials_by_number!();

    #[inline]
    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        self.eval_with_partials(u, v)
    }

    #[inline]
    fn normal(&self, u: P::Scalar, v: P::Scalar) -> Option<P::Vector>
    where
        P: Point3,
    {
        self.normal(u, v)
    }
}

#[cfg(feature = "geometry")]
impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> BoundedSurface for SimplexPatch<B, P> {
    fn pieces(&self) -> alloc::vec::Vec<SurfacePiece> {
        SurfacePiece::triangular(self.to_bernstein().as_ref()).into_iter().collect()
    }

    forward_boxes!();

    #[inline]
    fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Nearest<P, [P::Scalar; 2]>> {
        self.nearest(point, accuracy)
    }
}
