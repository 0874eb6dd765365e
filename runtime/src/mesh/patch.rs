//! What a mesh asks of a surface, whatever its type.

use alloc::vec::Vec;

use crate::{BoundedSurface, Point, Point3, Scalar, Surface, SurfacePiece};

/// A surface without its types, on the unit square.
pub(super) trait Patch<S> {
    /// The point.
    fn point(&self, x: [S; 2]) -> [S; 3];
    /// The unit normal, if there is one.
    fn normal(&self, x: [S; 2]) -> Option<[S; 3]>;
    /// The rational Bézier patches of the surface.
    fn bezier(&self) -> Vec<SurfacePiece>;
    /// The parameter in one direction of a number between 0 and 1.
    fn parameter(&self, axis: usize, x: S) -> f64;
}

impl<T, P> Patch<P::Scalar> for T
where
    T: BoundedSurface + Surface<Point = P>,
    P: Point3,
{
    fn point(&self, x: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let [u, v] = parameters(self, x);
        components(self.eval(u, v))
    }

    fn normal(&self, x: [P::Scalar; 2]) -> Option<[P::Scalar; 3]> {
        let [u, v] = parameters(self, x);
        Surface::normal(self, u, v).map(components)
    }

    fn bezier(&self) -> Vec<SurfacePiece> {
        self.pieces()
    }

    fn parameter(&self, axis: usize, x: P::Scalar) -> f64 {
        parameters(self, [x; 2])[axis].to_f64()
    }
}

/// Exact at both ends of the domain.
fn parameters<T: Surface>(
    surface: &T,
    x: [<T::Point as Point>::Scalar; 2],
) -> [<T::Point as Point>::Scalar; 2] {
    let ranges = surface.domain();
    [0, 1].map(|k| {
        let [lo, hi] = ranges[k];
        lo * (<T::Point as Point>::Scalar::ONE - x[k]) + hi * x[k]
    })
}

fn components<P: Point>(point: P) -> [P::Scalar; 3] {
    [0, 1, 2].map(|c| point.component(c))
}
