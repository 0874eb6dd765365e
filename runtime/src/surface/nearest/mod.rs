//! The point of a surface that is nearest to a given one, with a proof that none is nearer.

// All functions of these two are marked `#[inline]`, long as they are: not generic, they would else be compiled with
// this crate for everybody, and are now where a nearest point is asked for.
mod piece;
mod search;

pub(crate) use piece::Piece;
pub(crate) use search::{length_unit, search};

use alloc::vec::Vec;

use super::TensorSurface;
use crate::domain::from_unit;
use crate::vector::{distance, length};
use crate::{Basis, Nearest, Point, Scalar, Surface};

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The point of the surface that is nearest to `point`, among those with parameters in the domain.
    ///
    /// It is a global minimum: its distance exceeds [`at_least`](Nearest::at_least), which no point of the surface
    /// is nearer than, by no more than `accuracy`. An `accuracy` below some 64 `ε` times the greatest distance of a
    /// Bézier control point, also zero or NaN, asks for what the scalar type can give. Where very many points are
    /// almost equally near, such as around the centre of a sphere, the work ends earlier: the point is still a minimum,
    /// and `at_least` says how much is proved.
    ///
    /// Found by branch and bound on the Bézier form, from the box of a part and the Bernstein coefficients of its
    /// squared distance, with Newton's method for the point. `None` if the point, the surface or the distance is not
    /// finite.
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
    pub fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Nearest<P, [P::Scalar; 2]>> {
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
        Some(Nearest { at: [u, v], point: found, distance, at_least })
    }
}

/// The patch and the parameters in it, from 0 to 1, at which rational Bézier patches are nearest to `point`, up to that
/// accuracy, and a lower bound of their distance; `None` if anything is not finite or a weight not positive.
#[inline]
pub(crate) fn nearest_of_pieces(
    pieces: &[&Piece],
    point: &[f64],
    accuracy: f64,
    epsilon: f64,
) -> Option<(usize, [f64; 2], f64)> {
    let mut farthest = 0.0_f64;
    for piece in pieces {
        let here = piece.farthest(point);
        if !here.is_finite() {
            return None;
        }
        farthest = farthest.max(here);
    }
    if !point.iter().all(|c| c.is_finite()) {
        return None;
    }
    let unit = if farthest > 0.0 { farthest } else { 1.0 };
    let seen: Vec<Piece> = pieces.iter().map(|piece| piece.seen_from(point, unit)).collect();
    let (place, bound) = search(&seen, (0.5 * accuracy / unit).max(64.0 * epsilon))?;
    Some((place.piece, place.at, (bound * unit * (1.0 - epsilon)).max(0.0)))
}

/// The parameters, from 0 to 1, at which a Bézier patch of those degrees is nearest to `point`, up to that accuracy,
/// and a lower bound of its distance; a row of control points for each function of `v`.
fn nearest_of_patch<P: Point>(
    degrees: [usize; 2],
    net: impl Iterator<Item = P> + Clone,
    point: P,
    accuracy: P::Scalar,
) -> Option<([P::Scalar; 2], P::Scalar)> {
    let unit = length_unit(net.clone().map(|p| length(p.minus(point))));
    let difference = |p: P, c: usize| (p.component(c).to_f64() - point.component(c).to_f64()) / unit;
    let net = net.flat_map(|p| (0..P::DIM).map(move |c| difference(p, c))).collect();
    let epsilon = P::Scalar::EPSILON.to_f64();
    // The point that is returned is rounded, too.
    let tolerance = (0.5 * accuracy.to_f64() / unit).max(64.0 * epsilon);
    let (nearest, bound) = search(&[Piece::new(degrees, P::DIM, net)], tolerance)?;
    let at_least = P::Scalar::of((bound * unit * (1.0 - epsilon)).max(0.0));
    Some((nearest.at.map(P::Scalar::of), at_least))
}
