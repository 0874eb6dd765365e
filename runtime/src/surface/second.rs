//! Bounds of second derivatives, from which a flat piece knows how far it is from its surface.

use super::net::Net;
use super::{RationalSurface, ScalarOf, Surface, TensorSurface};
use crate::bernstein::{differentiate, restrict};
use crate::domain::unit;
use crate::vector::length;
use crate::{Basis, Point, Point3, Scalar, SurfaceOfRevolution};

/// A surface whose second derivatives have known bounds on every part.
///
/// A triangle with its corners on the surface, whose parameters lie in a rectangle of the widths `h` and `k`, is
/// nowhere farther from the surface than `(h² |S_uu| + 2 h k |S_uv| + k² |S_vv|) / 8` with these bounds; a mesh rests
/// on it.
pub trait BoundedSurface: Surface {
    /// Upper bounds of `|S_uu|`, `|S_uv|` and `|S_vv|` for `u[0] <= u <= u[1]` and `v[0] <= v <= v[1]`, inside of the
    /// domain.
    ///
    /// Infinite where no bound is known, NaN where the surface is infinite or NaN.
    fn second_derivative_bounds(&self, u: [ScalarOf<Self>; 2], v: [ScalarOf<Self>; 2])
    -> [ScalarOf<Self>; 3];
}

/// From the Bézier control points of the part: second derivatives are convex combinations of second differences.
impl<U, V, P> BoundedSurface for TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    fn second_derivative_bounds(&self, u: [P::Scalar; 2], v: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let net = Net::of_part(self, u, v);
        let bounds = [[2, 0], [1, 1], [0, 2]].map(|orders| largest_length(&net.differentiated(orders)));
        on_part(bounds, [u[1] - u[0], v[1] - v[0]])
    }
}

/// By the rule for quotients, about the point in the middle of the part.
impl<U, V, P> BoundedSurface for RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    fn second_derivative_bounds(&self, u: [P::Scalar; 2], v: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let half = P::Scalar::of(0.5);
        let weight = Net::of_part(self.weight(), u, v);
        let least = weight.points().iter().fold(P::Scalar::INFINITY, |a, &b| if b >= a { a } else { b });
        if least <= P::Scalar::ZERO {
            // A pole may lie in the part, or a weight is zero at its border.
            return [P::Scalar::INFINITY; 3];
        }
        let middle = self.eval(u[0] + (u[1] - u[0]) * half, v[0] + (v[1] - v[0]) * half);
        let numerator = Net::of_part(self.numerator(), u, v).zip(&weight, |p, w| p.add_scaled(middle, -w));
        let of = |orders| {
            let net = numerator.differentiated(orders);
            let weights = weight.differentiated(orders);
            [largest_length(&net), largest_length(&weights)]
        };
        // N' = N - c w and S' = S - c: N' = w S'.
        let [n, _] = of([0, 0]);
        let s = n / least;
        let [[n_u, w_u], [n_v, w_v]] = [[1, 0], [0, 1]].map(of);
        let [s_u, s_v] = [(n_u + w_u * s) / least, (n_v + w_v * s) / least];
        let [[n_uu, w_uu], [n_uv, w_uv], [n_vv, w_vv]] = [[2, 0], [1, 1], [0, 2]].map(of);
        let two = P::Scalar::of(2.0);
        let bounds = [
            (n_uu + two * w_u * s_u + w_uu * s) / least,
            (n_uv + w_u * s_v + w_v * s_u + w_uv * s) / least,
            (n_vv + two * w_v * s_v + w_vv * s) / least,
        ];
        on_part(bounds, [u[1] - u[0], v[1] - v[0]])
    }
}

/// `|S_uu| = |C''|`, `|S_uv| = |r'|` and `|S_vv| = |r|` at every angle.
impl<B: Basis, P: Point3<Scalar = B::Scalar>> BoundedSurface for SurfaceOfRevolution<B, P> {
    fn second_derivative_bounds(&self, u: [P::Scalar; 2], _: [P::Scalar; 2]) -> [P::Scalar; 3] {
        let [from, to] = u.map(|u| unit(B::domain(), u)[1]);
        let part = |mut points: B::Bernstein<P>, order: usize| {
            restrict(points.as_mut(), from, to);
            let mut rest = points.as_mut();
            for _ in 0..order {
                rest = differentiate(rest);
            }
            rest.iter().fold(P::Scalar::ZERO, |a, &p| larger(a, length(p)))
        };
        let width = u[1] - u[0];
        let generatrix = part(self.meridian(P::Scalar::ZERO).to_bernstein(), 2);
        let [slope, radius] = [1, 0].map(|order| part(self.radii().to_bernstein(), order));
        [generatrix / (width * width), slope / width, radius]
    }
}

/// From the unit square to a part of those widths.
fn on_part<S: Scalar>([uu, uv, vv]: [S; 3], [h, k]: [S; 2]) -> [S; 3] {
    [uu / (h * h), uv / (h * k), vv / (k * k)]
}

fn largest_length<P: Point>(net: &Net<P>) -> P::Scalar {
    net.points().iter().fold(P::Scalar::ZERO, |a, &p| larger(a, length(p)))
}

/// The larger one; NaN stays.
fn larger<S: Scalar>(a: S, b: S) -> S {
    if b <= a || a.is_nan() { a } else { b }
}
