//! The point of a B-spline surface that is nearest to a given one.

use alloc::vec::Vec;

use super::rows::{self, Rows};
use super::{BSplineSurface, Direction, KnotVector};
use crate::surface::nearest::{Piece, length_unit, search};
use crate::vector::length;
use crate::{Nearest, Point, Scalar};

impl<P: Point> BSplineSurface<P> {
    /// The point of the surface that is nearest to `point`.
    ///
    /// The surface is divided into Bézier patches, and these into halves. The control points of a part give a lower
    /// bound of its distance (their bounding box, and the Bernstein coefficients of the squared distance), and parts
    /// that cannot be nearer than the best point found so far are left out; that point is improved by Newton's method.
    /// So the distance is the smallest one of the whole surface, not of a neighbourhood: it exceeds
    /// [`at_least`](Nearest::at_least), which is proved, by no more than `accuracy`. An `accuracy` below some 64 `ε`
    /// times the greatest distance of a control point, also zero or NaN, asks for what the scalar type can give.
    ///
    /// Where very many points are almost equally near, such as around the centre of a sphere, the work ends earlier:
    /// the point is still a minimum, and `at_least` says how much is proved. At a knot where the surface jumps the
    /// point may be the limit from one side.
    ///
    /// `None` if the point, a control point of the surface or the distance is not finite.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, Net};
    ///
    /// // The saddle z = x y.
    /// let saddle = BSplineSurface::from_bezier(Net::from_rows([
    ///     [[-1.0_f64, -1.0, 1.0], [-1.0, 1.0, -1.0]],
    ///     [[1.0, -1.0, -1.0], [1.0, 1.0, 1.0]],
    /// ])?)?;
    /// let found = saddle.nearest([0.0, 0.0, 1.0], 1e-9).unwrap();
    /// assert!((found.distance - 1.0).abs() < 1e-15);
    /// assert!(found.at_least > 1.0 - 1e-9);
    /// # Ok::<(), basis_runtime::bspline::SplineError>(())
    /// ```
    pub fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Nearest<P, [P::Scalar; 2]>> {
        let spans = [Direction::U, Direction::V].map(|d| self.knots(d).spans().collect::<Vec<_>>());
        let distances = self.net().map(|p| length(p.minus(point)));
        if !distances.as_slice().iter().all(|distance| distance.is_finite()) {
            return None;
        }
        let unit = length_unit(distances.as_slice().iter().copied());
        let pieces = self.pieces(point, unit);
        let epsilon = P::Scalar::EPSILON.to_f64();
        let tolerance = (0.5 * accuracy.to_f64() / unit).max(64.0 * epsilon);
        let (nearest, bound) = search(&pieces, tolerance)?;

        let place = [nearest.piece / spans[1].len(), nearest.piece % spans[1].len()];
        let place = [spans[0][place[0]], spans[1][place[1]]];
        let parameter = |i: usize, knots: &[P::Scalar]| {
            let (lo, hi, at) = (knots[place[i]], knots[place[i] + 1], nearest.at[i]);
            if at >= 1.0 {
                return hi;
            }
            let t = P::Scalar::of(lo.to_f64() + (hi.to_f64() - lo.to_f64()) * at);
            if t < lo {
                lo
            } else if t > hi {
                hi
            } else {
                t
            }
        };
        let [u, v] = [self.knots(Direction::U), self.knots(Direction::V)].map(KnotVector::as_slice);
        let at = [parameter(0, u), parameter(1, v)];
        // On one side of a knot or the other the point is the same, unless the surface jumps.
        let away = |p: P| length(p.minus(point));
        let (mut found, limit) = (self.eval(at[0], at[1]), self.partial_on(place, at, [0, 0]));
        let same = away(found).to_f64() <= away(limit).to_f64() + tolerance * unit;
        if !same {
            found = limit;
        }
        let distance = away(found);
        let at_least = P::Scalar::of((bound * unit * (1.0 - epsilon)).max(0.0)).min(distance);
        Some(Nearest { at, point: found, distance, at_least })
    }

    /// The polynomial pieces as Bézier patches, those with the lowest `u` first; differences from `point` in that unit.
    fn pieces(&self, point: P, unit: f64) -> Vec<Piece> {
        let difference = |p: P, c: usize| (p.component(c).to_f64() - point.component(c).to_f64()) / unit;
        let net = self.net();
        let points =
            net.as_slice().iter().flat_map(|&p| (0..P::DIM).map(move |c| difference(p, c))).collect();
        let [ku, kv] = self.degrees();
        let columns = net.columns();
        let rows = Rows { knots: self.knots(Direction::U).to_f64(), points, lanes: columns * P::DIM };
        let knots = self.knots(Direction::V).to_f64();
        let bands = rows::bezier(&rows).into_iter();
        bands
            .flat_map(|(_, band)| {
                // Turned: a row for each function of v, with `ku + 1` points in it.
                let entry = |j: usize, i: usize| &band[(i * columns + j) * P::DIM..][..P::DIM];
                let turned =
                    (0..columns).flat_map(|j| (0..=ku).flat_map(move |i| entry(j, i).iter().copied()));
                let lanes = (ku + 1) * P::DIM;
                let rows = Rows { knots: knots.clone(), points: turned.collect::<Vec<f64>>(), lanes };
                let patches = rows::bezier(&rows).into_iter();
                patches.map(|(_, net)| Piece::new([ku, kv], P::DIM, net)).collect::<Vec<_>>()
            })
            .collect()
    }
}
