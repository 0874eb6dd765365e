//! The point of a tensor surface that is nearest to a given one.

use super::TensorSurface;
use crate::bspline::{Projection, nearest_of_patch};
use crate::domain::from_unit;
use crate::vector::distance;
use crate::{Basis, Point, Scalar, Surface};

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The point of the surface that is nearest to `point`, among those with parameters in the domain.
    ///
    /// It is a global minimum: its distance exceeds [`at_least`](Projection::at_least), which no point of the surface is nearer
    /// than, by no more than `accuracy`. An `accuracy` below some 64 `ε` times the greatest distance of a Bézier control point,
    /// also zero or NaN, asks for what the scalar type can give. Where very many points are almost equally near, such as
    /// around the centre of a sphere, the work ends earlier: the point is still a minimum, and `at_least` says how much is proved.
    ///
    /// Found by branch and bound on the Bézier form, from the box of a part and the Bernstein coefficients of its squared
    /// distance, with Newton's method for the point. `None` if the point, the surface or the distance is not finite.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, TensorSurface};
    ///
    /// // The saddle z = x y over the square from -1 to 1.
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let net = [[[-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0]], [[1.0, -1.0, -1.0], [1.0, 1.0, 1.0]]];
    /// let saddle = TensorSurface::new(linear, linear, net);
    /// let found = saddle.nearest([0.0, 0.0, 1.0], 1e-9).unwrap();
    /// assert!((found.distance - 1.0).abs() < 1e-9 && found.at_least > 1.0 - 1e-9);
    /// ```
    pub fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Projection<P>> {
        let net = self.bezier_net();
        let turned = (0..=V::DEGREE).flat_map(|j| net.as_ref().iter().map(move |row| row.as_ref()[j]));
        let (at, at_least) = nearest_of_patch([U::DEGREE, V::DEGREE], turned, point, accuracy)?;
        let [u, v] = [(U::domain(), at[0]), (V::domain(), at[1])].map(|(domain, x)| from_unit(domain, x));
        let found = self.eval(u, v);
        let distance = distance(found, point);
        if !distance.is_finite() {
            return None;
        }
        let at_least = if at_least < distance { at_least } else { distance };
        Some(Projection { parameters: [u, v], point: found, distance, at_least })
    }
}
