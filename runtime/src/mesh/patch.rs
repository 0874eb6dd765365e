//! What a mesh asks of a surface, whatever its type.

use alloc::vec::Vec;

use crate::domain::from_unit;
use crate::{BoundedSurface, Point, Point3, Scalar, Surface, SurfaceDomain, SurfacePiece};

/// A surface without its types, on the unit square.
pub(super) trait Patch<S> {
    /// The point.
    fn point(&self, x: [S; 2]) -> [S; 3];
    /// The unit normal, if there is one.
    fn normal(&self, x: [S; 2]) -> Option<[S; 3]>;
    /// The rational Bézier patches of the surface, those of a triangle over the unit square.
    fn bezier(&self) -> Vec<SurfacePiece>;
    /// The parameter in one direction of a number between 0 and 1, over the unit square that of a triangle itself.
    fn parameter(&self, axis: usize, x: S) -> f64;
    /// The parameters, scaled to the unit square or the triangle, at a place of the unit square.
    fn uv(&self, x: [S; 2]) -> [S; 2];
}

impl<T, P> Patch<P::Scalar> for T
where
    T: BoundedSurface + Surface<Point = P>,
    P: Point3,
{
    fn point(&self, x: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let (u, v) = self.domain().at(x[0], x[1]);
        components(self.eval(u, v))
    }

    fn normal(&self, x: [P::Scalar; 2]) -> Option<[P::Scalar; 3]> {
        let (u, v) = self.domain().at(x[0], x[1]);
        Surface::normal(self, u, v).map(components)
    }

    fn bezier(&self) -> Vec<SurfacePiece> {
        self.pieces().into_iter().map(SurfacePiece::on_square).collect()
    }

    fn parameter(&self, axis: usize, x: P::Scalar) -> f64 {
        from_unit(self.domain().ranges()[axis], x).to_f64()
    }

    fn uv(&self, x: [P::Scalar; 2]) -> [P::Scalar; 2] {
        match self.domain() {
            SurfaceDomain::Rectangle(_) => x,
            SurfaceDomain::Triangle => SurfaceDomain::Triangle.at(x[0], x[1]).into(),
        }
    }
}

fn components<P: Point>(point: P) -> [P::Scalar; 3] {
    [0, 1, 2].map(|c| point.component(c))
}
