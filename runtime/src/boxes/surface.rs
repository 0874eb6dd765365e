//! Patches on boxes of two variables as surfaces over their rectangle.

use super::{BoxBasis, BoxPatch};
#[cfg(feature = "geometry")]
use crate::surface::forward_boxes;
#[cfg(feature = "geometry")]
use crate::{BoundedSurface, SurfacePiece};
use crate::{Point, Scalar, Surface, SurfaceDomain};

/// Over the rectangle of the family, if it has two variables.
///
/// ```
/// use basis_runtime::{BoxPatch, Surface, SurfaceDomain, basis};
///
/// basis! {
///     family Quadrilateral {
///         domain -1 <= u <= 1, -1 <= v <= 1;
///         b[i, j] = (1 + (2*i - 1)*u)/2 * (1 + (2*j - 1)*v)/2 for i in 0..=1, j in 0..=1;
///     }
/// }
/// # fn main() {
/// let points = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0]];
/// let patch = BoxPatch::new(Quadrilateral::new(), points);
/// assert_eq!(patch.domain(), SurfaceDomain::Rectangle([[-1.0, 1.0]; 2]));
/// assert_eq!(patch.eval(0.0, 0.5), [1.5, 1.5, 0.0]);
/// assert_eq!(patch.normal(0.0, 0.5), Some([0.0, 0.0, 1.0]));
/// # }
/// ```
impl<S, B, P> Surface for BoxPatch<B, P>
where
    S: Scalar,
    B: BoxBasis<Scalar = S, Coordinates = [S; 2], Orders = [usize; 2]>,
    P: Point<Scalar = S>,
{
    type Point = P;

    #[inline]
    fn domain(&self) -> SurfaceDomain<S> {
        let [[u_lo, v_lo], [u_hi, v_hi]] = B::domain();
        SurfaceDomain::Rectangle([[u_lo, u_hi], [v_lo, v_hi]])
    }

    #[inline]
    fn eval(&self, u: S, v: S) -> P {
        self.eval_at([u, v])
    }

    #[inline]
    fn partial(&self, u: S, v: S, orders: [usize; 2]) -> P::Vector {
        self.partial_at([u, v], orders)
    }
}

#[cfg(feature = "geometry")]
impl<S, B, P> BoundedSurface for BoxPatch<B, P>
where
    S: Scalar,
    B: BoxBasis<Scalar = S, Coordinates = [S; 2], Orders = [usize; 2]>,
    P: Point<Scalar = S>,
{
    fn pieces(&self) -> alloc::vec::Vec<SurfacePiece> {
        let net = self.to_bernstein();
        let of = |n: usize, c: usize| net.as_ref()[n].component(c).to_f64();
        let size = [B::DEGREES[0] + 1, B::DEGREES[1] + 1];
        alloc::vec![SurfacePiece::from_fn(self.domain().ranges(), size, P::DIM, P::DIM, of)]
    }

    forward_boxes!();
}
