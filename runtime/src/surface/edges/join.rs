//! Joins: a second surface moved so that it continues a first one across an edge.
//!
//! The derivatives of a surface across an edge are curves over its family along the edge. Where the second surface has the
//! same family and shape values there, the conditions of contact hold on the whole edge if they hold for the control points
//! of these curves; otherwise the curves are first written over its family, if they can be.

use alloc::vec::Vec;

use super::{Direction, Edge, EdgePair, JoinError, Orientation};
use crate::bernstein::elevate;
use crate::curve::backwards;
use crate::numeric::{leibniz, linear::solve};
use crate::vector::{is_finite, largest_component};
use crate::{Array, Basis, Contact, Curve, CurveError, Point, RationalSurface, Scalar, TensorSurface};

/// The derivatives of a surface across an edge, as curves over its family along the edge.
struct Across<P: Point> {
    /// The control points: `[k][i]` of the derivative of order `k`.
    points: Vec<Vec<P>>,
    /// The Bernstein weights of the family, row by row.
    weights: Vec<Vec<P::Scalar>>,
}

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The surface `next`, moved so that it continues this one across an edge of each, with that contact.
    ///
    /// Edges and their directions may be any. With P and Q the functions from the edge into this and into the other surface,
    /// each with the parameter of its surface across the edge, the derivatives agree as [`Contact`] says, on the whole edge:
    /// order 0 is a common edge, [`Contact::Tangent`] is G1, [`Contact::Curvature`] G2. Of `next` one row or column more
    /// than that order is replaced, the others stay. Along the edge it can have any family that holds the derivatives of
    /// this surface: with the same family and shape values its control points are found one by one.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// use basis_runtime::{BernsteinBasis, Contact, Edge, EdgePair, Surface, TensorSurface};
    ///
    /// fn net<const N: usize>(y: f64) -> [[[f64; 3]; N]; N] {
    ///     core::array::from_fn(|i| core::array::from_fn(|j| {
    ///         let (x, y) = (i as f64, y + j as f64);
    ///         [x, y, (x - 1.5) * (y - 4.0)]
    ///     }))
    /// }
    /// let lambda = QuarticBernstein::new(0.5)?;
    /// let [a, b] = [-1.0, 0.8].map(QuarticBernstein::new);
    /// let first = TensorSurface::new(lambda, a?, net(0.0));
    /// let edges = EdgePair::along(Edge::VEnd, Edge::VStart);
    /// let contact = Contact::Curvature { f: 0.7, c: 0.0 };
    /// let next = first.continued(edges, contact, &TensorSurface::new(lambda, b?, net(3.5)))?;
    /// let joint = first.joint(edges, &next, 65);
    /// assert_eq!(joint.geometric_order(1e-12, 1e-12, 1e-12), Some(2));
    ///
    /// // A Bézier surface of the same degree, across another edge, which runs the other way.
    /// let quartic = BernsteinBasis::<f64, 5>::new();
    /// let edges = EdgePair::against(Edge::VEnd, Edge::UStart);
    /// let next = first.continued(edges, contact, &TensorSurface::new(quartic, quartic, net(3.5)))?;
    /// assert_eq!(first.joint(edges, &next, 65).geometric_order(1e-12, 1e-12, 1e-12), Some(2));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinError::Factor`] as for curves; [`JoinError::Contact`] if the order is not below the number of control points of
    /// `next` across the edge; [`JoinError::FirstShape`] and [`JoinError::SecondShape`] if the rows that count at an edge along
    /// `v` have different shape values; [`JoinError::Unreachable`] if the family of `next` along the edge does not hold the
    /// derivatives; [`JoinError::Undetermined`] if its control points across the edge do not determine them;
    /// [`JoinError::NotFinite`] if a computed control point is not finite.
    pub fn continued<W, X>(
        &self,
        edges: EdgePair,
        contact: Contact<P::Scalar>,
        next: &TensorSurface<W, X, P>,
    ) -> Result<TensorSurface<W, X, P>, JoinError>
    where
        W: Basis<Scalar = U::Scalar>,
        X: Basis<Scalar = U::Scalar>,
    {
        possible(contact, TensorSurface::<W, X, P>::most(edges.second))?;
        next.touching(edges.second, &self.beyond(edges, contact)?, edges.orientation)
    }

    /// The derivatives across the edge of a surface that continues this one.
    fn beyond(&self, edges: EdgePair, contact: Contact<P::Scalar>) -> Result<Across<P>, JoinError> {
        let across = self.across(edges.first, contact.order());
        let mut across = across.map_err(|row| JoinError::FirstShape { row })?;
        across.replace(|derivatives| beyond(edges, contact, derivatives))?;
        Ok(across)
    }

    /// The highest order of contact across an edge.
    fn most(edge: Edge) -> usize {
        if edge.across() == Direction::U { U::LEN - 1 } else { V::LEN - 1 }
    }

    /// The derivatives up to that order across an edge; the row that has another family than the others that count.
    fn across(&self, edge: Edge, order: usize) -> Result<Across<P>, usize> {
        let rows = self.rows();
        let points = |of: &dyn Fn(usize, usize) -> P, len: usize| -> Vec<Vec<P>> {
            (0..=order).map(|k| (0..len).map(|i| of(k, i)).collect()).collect()
        };
        if edge.across() == Direction::V {
            let at = V::domain()[usize::from(edge.is_end())];
            let derivatives = |row: &Curve<V, P>| {
                let mut derivatives = alloc::vec![P::Vector::zero(); order + 1];
                row.derivatives_into(at, &mut derivatives);
                derivatives
            };
            let derivatives: Vec<Vec<P::Vector>> = rows.iter().map(derivatives).collect();
            let points = points(&|k, i| P::from_vector(derivatives[i][k]), U::LEN);
            return Ok(Across { points, weights: weights(self.u_basis()) });
        }
        let (factors, basis) = self.counting(edge, order)?;
        let point = |k: usize, j: usize| {
            let column = rows.iter().map(|row| row.control_points()[j]);
            crate::basis::combination(column.zip(factors[k].as_ref().iter().copied()))
        };
        Ok(Across { points: points(&point, V::LEN), weights: weights(basis) })
    }

    /// The factors `[k][i]` of the rows in the derivatives across an edge along `v`, and the family of all rows that count;
    /// the row that has another one.
    fn counting(&self, edge: Edge, order: usize) -> Result<(Vec<U::Values>, V), usize> {
        let at = U::domain()[usize::from(edge.is_end())];
        let factors: Vec<U::Values> = (0..=order).map(|k| self.u_basis().derivatives(at, k)).collect();
        let counts = |i: &usize| factors.iter().any(|w| w.as_ref()[*i] != P::Scalar::ZERO);
        let rows = self.rows();
        // Some row counts, unless all functions vanish there to that order; the nearest to the edge says what is right.
        let mut counting = (0..U::LEN).filter(counts);
        let nearest = if edge.is_end() { counting.next_back() } else { counting.next() }.unwrap_or_default();
        let basis = rows[nearest].basis();
        match (0..U::LEN).filter(counts).find(|&i| rows[i].basis() != basis) {
            Some(row) => Err(row),
            None => Ok((factors, basis)),
        }
    }

    /// This surface with these derivatives across an edge.
    fn touching(&self, edge: Edge, across: &Across<P>, orientation: Orientation) -> Result<Self, JoinError> {
        let order = across.points.len() - 1;
        let net = |i: usize, j: usize| self.rows()[i].control_points()[j];
        if edge.across() == Direction::V {
            let points = across.over(self.u_basis(), orientation)?;
            let mut rows = U::Points::<Curve<V, P>>::from_fn(|i| self.rows()[i]);
            for (i, row) in rows.as_mut().iter_mut().enumerate() {
                let derivatives: Vec<P> = points.iter().map(|points| points[i]).collect();
                *row = Curve::new(
                    row.basis(),
                    solved(row.basis(), edge, &derivatives, V::Points::from_fn(|j| net(i, j)))?,
                );
            }
            return Ok(Self::from_rows(self.u_basis(), rows));
        }
        let (_, basis) = self.counting(edge, order).map_err(|row| JoinError::SecondShape { row })?;
        let points = across.over(basis, orientation)?;
        let mut moved = U::Points::<V::Points<P>>::from_fn(|i| V::Points::from_fn(|j| net(i, j)));
        for j in 0..V::LEN {
            let derivatives: Vec<P> = points.iter().map(|points| points[j]).collect();
            let column = solved(self.u_basis(), edge, &derivatives, U::Points::from_fn(|i| net(i, j)))?;
            for (row, &point) in moved.as_mut().iter_mut().zip(column.as_ref()) {
                row.as_mut()[j] = point;
            }
        }
        Ok(Self::with_rows(self.u_basis(), U::Points::from_fn(|i| self.rows()[i].basis()), moved))
    }
}

impl<U, V, P> RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The surface `next`, moved so that it continues this one across an edge of each, with that contact: as
    /// [`TensorSurface::continued`], for numerator and denominator.
    ///
    /// Weights along an edge belong to the points of the edge, so those of the rows that are replaced are replaced,
    /// too. Numerator and denominator can be multiplied by any function of the parameter across the edge; the one is
    /// taken with which the weights of `next` keep their means along the edge. So none of them changes where those of
    /// neither surface change along the edge, as those of polynomial surfaces.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, Contact, Edge, EdgePair, RationalSurface, Surface};
    ///
    /// // A quarter of a cylinder, and a sheet beyond it.
    /// let half = 0.5_f64.sqrt();
    /// let arc = |x: f64| [[x, 1.0, 0.0], [x, 1.0, 1.0], [x, 0.0, 1.0]];
    /// let (linear, quadratic) = (BernsteinBasis::<_, 2>::new(), BernsteinBasis::<_, 3>::new());
    /// let cylinder = RationalSurface::new(linear, quadratic, [arc(0.0), arc(2.0)], [[1.0, half, 1.0]; 2]);
    /// let sheet = [[[0.0; 3]; 3], [[0.0; 3]; 3], [[5.0, 1.0, 0.0], [5.0, 2.0, 2.0], [5.0, 0.0, 1.0]]];
    /// let draft = RationalSurface::new(quadratic, quadratic, sheet, [[1.0; 3]; 3]);
    /// let edges = EdgePair::along(Edge::UEnd, Edge::UStart);
    /// let next = cylinder.continued(edges, Contact::Tangent { f: 1.0 }, &draft)?;
    /// assert_eq!(cylinder.joint(edges, &next, 65).geometric_order(1e-14, 1e-14, 1e-9), Some(1));
    /// assert_eq!(next.control_point(2, 1), Some(([5.0, 2.0, 2.0], 1.0)));
    /// # Ok::<(), basis_runtime::JoinError>(())
    /// ```
    ///
    /// # Errors
    /// As [`TensorSurface::continued`], and [`JoinError::Weights`] if the mean of the weights along the edge vanishes.
    pub fn continued<W, X>(
        &self,
        edges: EdgePair,
        contact: Contact<P::Scalar>,
        next: &RationalSurface<W, X, P>,
    ) -> Result<RationalSurface<W, X, P>, JoinError>
    where
        W: Basis<Scalar = U::Scalar>,
        X: Basis<Scalar = U::Scalar>,
    {
        possible(contact, TensorSurface::<W, X, P>::most(edges.second))?;
        let mut numerator = self.numerator().beyond(edges, contact)?;
        let mut weight = self.weight().beyond(edges, contact)?;
        let own = next.weight().across(edges.second, contact.order());
        let own = own.map_err(|row| JoinError::SecondShape { row })?;
        let factor = factor_of_weights(&own.means(), &weight.means())?;
        numerator.replace(|derivatives| Ok(leibniz::product(&derivatives, &factor)))?;
        weight.replace(|derivatives| Ok(leibniz::product(&derivatives, &factor)))?;
        Ok(RationalSurface::from_homogeneous(
            next.numerator().touching(edges.second, &numerator, edges.orientation)?,
            next.weight().touching(edges.second, &weight, edges.orientation)?,
        ))
    }
}

impl<P: Point> Across<P> {
    /// Puts others in place of the derivatives that belong to one function along the edge.
    fn replace(&mut self, by: impl Fn(Vec<P>) -> Result<Vec<P>, JoinError>) -> Result<(), JoinError> {
        for i in 0..self.points[0].len() {
            let derivatives = by(self.points.iter().map(|points| points[i]).collect())?;
            for (points, derivative) in self.points.iter_mut().zip(derivatives) {
                points[i] = derivative;
            }
        }
        Ok(())
    }

    /// The means of the derivatives along the edge: those of their Bernstein coefficients.
    fn means(&self) -> Vec<P> {
        let part = P::Scalar::ONE / P::Scalar::from_usize(self.weights.len());
        let of = |points: &Vec<P>| {
            let coefficients = self.coefficients(points);
            coefficients.into_iter().fold(P::zero(), |sum, p| sum.add_weighted(p, part))
        };
        self.points.iter().map(of).collect()
    }

    /// The Bernstein coefficients of the curve over these control points.
    fn coefficients(&self, points: &[P]) -> Vec<P> {
        let of_row = |row: &Vec<P::Scalar>| {
            points.iter().zip(row).fold(P::zero(), |sum, (&p, &weight)| sum.add_weighted(p, weight))
        };
        self.weights.iter().map(of_row).collect()
    }

    /// The control points of the same curves over another family, in the same or the other direction.
    fn over<B: Basis<Scalar = P::Scalar>>(
        &self,
        basis: B,
        orientation: Orientation,
    ) -> Result<Vec<Vec<P>>, JoinError> {
        let own = weights(basis);
        if orientation == Orientation::Same && own == self.weights {
            return Ok(self.points.clone());
        }
        let size = own.len().max(self.weights.len());
        // The Bernstein coefficients of its functions, with the common degree.
        let columns: Vec<Vec<P::Scalar>> = (0..B::LEN)
            .map(|i| {
                let mut column = alloc::vec![P::Scalar::ZERO; size];
                elevate(&own.iter().map(|row| row[i]).collect::<Vec<_>>(), &mut column);
                column
            })
            .collect();
        let over = |points: &Vec<P>| {
            let mut coefficients = self.coefficients(points);
            if orientation == Orientation::Opposite {
                coefficients.reverse();
            }
            let mut target = alloc::vec![P::zero(); size];
            elevate(&coefficients, &mut target);
            let largest = target.iter().fold(P::Scalar::ZERO, |a, &p| a.max(largest_component(p)));
            let row = |(k, &p): (usize, &P)| (columns.iter().map(|column| column[k]).collect(), p);
            let mut system: Vec<(Vec<P::Scalar>, P)> = target.iter().enumerate().map(row).collect();
            solve(&mut system, B::LEN, largest).ok_or(JoinError::Unreachable)
        };
        self.points.iter().map(over).collect()
    }
}

fn weights<B: Basis>(basis: B) -> Vec<Vec<B::Scalar>> {
    basis.bernstein_weights().as_ref().iter().map(|row| row.as_ref().to_vec()).collect()
}

/// The control points of a line of the net with these derivatives at the edge.
pub(crate) fn solved<B: Basis, P: Point<Scalar = B::Scalar>>(
    basis: B,
    edge: Edge,
    derivatives: &[P],
    points: B::Points<P>,
) -> Result<B::Points<P>, JoinError> {
    let solved = if edge.is_end() {
        basis.end_points(derivatives, points)
    } else {
        basis.start_points(derivatives, points)
    };
    let solved = solved.map_err(|_| JoinError::Undetermined)?;
    if solved.as_ref().iter().all(|&p| is_finite(p)) { Ok(solved) } else { Err(JoinError::NotFinite) }
}

/// The order of a contact, if it is at most the highest that is possible.
pub(crate) fn possible<S: Scalar>(contact: Contact<S>, most: usize) -> Result<usize, JoinError> {
    let found = contact.order();
    if found > most { Err(JoinError::Contact { most, found }) } else { Ok(found) }
}

/// The derivatives across the second of two edges, from those across the first one and the contact.
pub(crate) fn beyond<P: Point>(
    edges: EdgePair,
    contact: Contact<P::Scalar>,
    mut derivatives: Vec<P>,
) -> Result<Vec<P>, JoinError> {
    if !edges.first.is_end() {
        derivatives = backwards(&derivatives);
    }
    contact.transform(&mut derivatives).map_err(|error| match error {
        CurveError::Factor { name, value } => JoinError::Factor { name, value },
        _ => JoinError::NotFinite, // not reached: a factor is all that can be wrong
    })?;
    Ok(if edges.second.is_end() { backwards(&derivatives) } else { derivatives })
}

/// The factor by which a rational surface in homogeneous points is multiplied before it is continued, as its
/// derivatives across the edge: the one with which the weights of the other surface keep their means along the edge. A
/// surface is the same whatever the factor is.
pub(crate) fn factor_of_weights<S: Scalar>(own: &[S], beyond: &[S]) -> Result<Vec<S>, JoinError> {
    let factor = leibniz::quotient(own, beyond);
    if factor.iter().all(|x| x.is_finite()) { Ok(factor) } else { Err(JoinError::Weights) }
}
