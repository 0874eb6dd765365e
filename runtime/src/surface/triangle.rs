//! Triangular patches as tensor surfaces.

use crate::bernstein::elevate;
use crate::simplex::SimplexIndex;
use crate::{Array, Basis, Point, SimplexPatch, TensorSurface, TriangularBasis};

/// The Bernstein basis of the degree of a family on a triangle.
type Side<B> =
    <<B as TriangularBasis>::EdgeBernstein<()> as Array<()>>::Basis<<B as crate::SimplexBasis>::Scalar>;

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The same patch as a tensor surface over the unit square, whose edge `s = 0` is the corner `u = 1`:
    ///
    /// ```text
    /// u = 1 - s,   v = s (1 - r),   w = s r
    /// ```
    ///
    /// So everything for surfaces serves triangular patches too: boxes, meshes, continuity along an edge. The normal at
    /// the corner is a limit, and on the same side as that of the patch. With the Bernstein points `p`, row `m` is the
    /// curve over `p[n-m, m-k, k]`, `k = 0, …, m`, with its degree raised to `n`.
    ///
    /// The other three edges have the parameters of the boundary curves, so that neighbours share them.
    pub fn to_tensor_surface(&self) -> TensorSurface<Side<B>, Side<B>, P> {
        let net = self.to_bernstein();
        let net = net.as_ref();
        let degree = B::DEGREE;
        let rows = <Side<B> as Basis>::Points::<<Side<B> as Basis>::Points<P>>::from_fn(|m| {
            let mut short = <Side<B> as Basis>::Points::<P>::from_fn(|_| P::zero());
            let point = |k: usize| net[SimplexIndex::<3>::new([degree - m, m - k, k]).position()];
            for (k, slot) in short.as_mut().iter_mut().enumerate().take(m + 1) {
                *slot = point(k);
            }
            let mut row = short;
            elevate(&short.as_ref()[..=m], row.as_mut());
            row
        });
        TensorSurface::new(Side::<B>::default(), Side::<B>::default(), rows)
    }
}
