//! What a mesh asks of a surface, whatever its type.

use crate::{BoundedSurface, Point, Point3, Scalar, Surface};

/// A surface without its types, on the unit square.
pub(super) trait Patch<S> {
    /// The point.
    fn point(&self, x: [S; 2]) -> [S; 3];
    /// The unit normal, if there is one.
    fn normal(&self, x: [S; 2]) -> Option<[S; 3]>;
    /// An upper bound of the distance between the surface and a triangle over the rectangle.
    fn flatness(&self, from: [S; 2], to: [S; 2]) -> Flatness<S>;
}

/// How far a flat piece may be from the surface, by the part that each parameter and both together have in it.
pub(super) struct Flatness<S> {
    pub(super) u: S,
    pub(super) both: S,
    pub(super) v: S,
}

impl<S: Scalar> Flatness<S> {
    pub(super) fn distance(&self) -> S {
        self.u + self.both + self.v
    }
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

    fn flatness(&self, from: [P::Scalar; 2], to: [P::Scalar; 2]) -> Flatness<P::Scalar> {
        let ([u0, v0], [u1, v1]) = (parameters(self, from), parameters(self, to));
        let [uu, uv, vv] = self.second_derivative_bounds([u0, u1], [v0, v1]);
        let (h, k) = (u1 - u0, v1 - v0);
        let eighth = P::Scalar::of(0.125);
        Flatness { u: uu * h * h * eighth, both: (uv + uv) * h * k * eighth, v: vv * k * k * eighth }
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

fn components<P: Point3>(point: P) -> [P::Scalar; 3] {
    [0, 1, 2].map(|c| point.component(c))
}
