//! Joins: a second surface moved so that it continues a first one across an edge.
//!
//! Along the common edge both surfaces are curves over one family with the same shape values; so are their derivatives
//! across the edge, and the conditions of contact hold on the whole edge if they hold for the control points of these
//! curves.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::TensorSurface;
use crate::{Array, Basis, Curve, Point, Scalar};

/// The highest order of contact.
const MOST: usize = 3;

/// Why a surface cannot continue another one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum JoinError {
    /// A row of the first surface that counts at the edge has other shape values than the others, so that its
    /// derivatives across the edge are no curves of one family.
    FirstShape {
        /// The row.
        row: usize,
    },
    /// The second surface has other shape values along the edge than the first one.
    SecondShape {
        /// The row, if the edge belongs to rows; `None` for the shape values in `u`.
        row: Option<usize>,
    },
    /// The factor is not a positive, finite number.
    Factor {
        /// The factor.
        value: f64,
    },
    /// The order of contact is too high: for the number of control points across the edge, or at all.
    Contact {
        /// The highest order that is possible.
        most: usize,
        /// The order asked for.
        found: usize,
    },
    /// The apex of a triangle that continues another one across an edge is not beyond the edge.
    Apex {
        /// Its barycentric coordinate that must be negative.
        value: f64,
    },
    /// No control points of the family with these shape values give the second patch the derivatives of the first one.
    Unreachable,
    /// With these shape values the control points next to the edge do not determine the derivatives across it; in the
    /// quartic family at γ = -3.
    Undetermined,
}

impl Display for JoinError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::FirstShape { row } => write!(
                f,
                "row {row} of the first surface counts at the edge, but has other shape values than the \
                 rows beside it: give all of them the same"
            ),
            Self::SecondShape { row: Some(row) } => write!(
                f,
                "row {row} of the second surface counts at the edge: give it the shape values that the \
                 first surface has along the edge"
            ),
            Self::SecondShape { row: None } => write!(
                f,
                "the second surface has other shape values along the edge: give it those of the first surface in u"
            ),
            Self::Factor { value } => write!(f, "the factor {value} is not a positive, finite number"),
            Self::Contact { most, found } => {
                write!(f, "contact of order {found} is not possible, at most of order {most}")
            }
            Self::Apex { value } => write!(
                f,
                "the apex is not beyond the edge: its barycentric coordinate that belongs to the \
                 opposite corner is {value}, and must be negative"
            ),
            Self::Unreachable => write!(
                f,
                "no control points of the second patch continue the first one with these shape values: \
                 choose others, or a family with more functions of its degree, such as that of Bernstein"
            ),
            Self::Undetermined => write!(
                f,
                "with these shape values of the second surface its control points do not determine the \
                 derivatives across the edge: choose others"
            ),
        }
    }
}

impl Error for JoinError {}

/// A surface over its net, with the derivatives `[k][i]` across an edge of the control point `i` of the edge.
type Across<B, P> = [<B as Basis>::Points<P>; MOST + 1];

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The surface `next`, moved so that its edge `v = lo` continues the edge `v = hi` of this one (a u–u join).
    ///
    /// The derivatives `∂ᵏ/∂vᵏ` of the one, at its end, are `factorᵏ` times those of the other at its start, for
    /// `k <= contact`: contact 0 is a common edge, 1 a G1 and 2 a G2 join; with the factor 1 it is C1 and C2. The first
    /// `contact + 1` columns of the net of `next` are replaced, the others stay. Both normals are on the same side.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// use basis_runtime::{Edge, EdgePair, TensorSurface, edge_continuity};
    ///
    /// let net = |y: f64| core::array::from_fn(|i| core::array::from_fn(|j| {
    ///     let (x, y) = (i as f64, y + j as f64);
    ///     [x, y, (x - 1.5) * (y - 4.0)]
    /// }));
    /// let lambda = QuarticBernstein::new(0.5)?;
    /// let [a, b] = [-1.0, 0.8].map(QuarticBernstein::new);
    /// let first = TensorSurface::new(lambda, a?, net(0.0));
    /// let next = first.join_uu(&TensorSurface::new(lambda, b?, net(3.5)), 2, 0.7)?;
    /// let measured = edge_continuity(&first, &next, EdgePair::along(Edge::VEnd, Edge::VStart), 65);
    /// assert_eq!(measured.order(1e-12, 1e-12, 1e-12), Some(2));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// When the shape values in `u` differ, the control points of `next` cannot meet the conditions, or the contact or
    /// the factor is out of range.
    pub fn join_uu<W: Basis<Scalar = U::Scalar>>(
        &self,
        next: &TensorSurface<U, W, P>,
        contact: usize,
        factor: P::Scalar,
    ) -> Result<TensorSurface<U, W, P>, JoinError> {
        if next.u_basis() != self.u_basis() {
            return Err(JoinError::SecondShape { row: None });
        }
        let across = self.across_v(check::<W>(contact, factor)?);
        let mut moved: U::Points<Curve<W, P>> = U::Points::from_fn(|i| next.rows()[i]);
        for (i, row) in moved.as_mut().iter_mut().enumerate() {
            let targets: [P; MOST + 1] = core::array::from_fn(|k| across[k].as_ref()[i]);
            let mut points = W::Points::from_fn(|j| row.control_points()[j]);
            solve(row.basis(), &targets[..=contact], factor, points.as_mut())?;
            *row = Curve::new(row.basis(), points);
        }
        Ok(TensorSurface::from_rows(next.u_basis(), moved))
    }

    /// The surface `next`, moved so that its edge `u = lo` continues the edge `v = hi` of this one (a u–v join): the
    /// parameter `v` of the one runs along the edge as `u` of the other.
    ///
    /// As [`join_uu`](Self::join_uu), but the first `contact + 1` rows of `next` are replaced, which must have the
    /// shape values of this surface in `u`. The normals are on different sides, since `(u, v)` turns the other way in
    /// `next`: [`edge_continuity`] says so, and a mesh of both turns one of them.
    ///
    /// [`edge_continuity`]: crate::edge_continuity
    ///
    /// # Errors
    /// As [`join_uu`](Self::join_uu), and when a row of `next` has the wrong shape values.
    pub fn join_uv<W: Basis<Scalar = U::Scalar>>(
        &self,
        next: &TensorSurface<W, U, P>,
        contact: usize,
        factor: P::Scalar,
    ) -> Result<TensorSurface<W, U, P>, JoinError> {
        let across = self.across_v(check::<W>(contact, factor)?);
        next.with_start_u(self.u_basis(), &across, contact, factor)
    }

    /// The surface `next`, moved so that its edge `u = lo` continues the edge `u = hi` of this one (a v–v join).
    ///
    /// As [`join_uu`](Self::join_uu), but the first `contact + 1` rows of `next` are replaced. They, and the last
    /// `contact + 1` rows of this surface, must all have the same shape values. Both normals are on the same side.
    ///
    /// # Errors
    /// As [`join_uu`](Self::join_uu), and when a row of either surface has the wrong shape values.
    pub fn join_vv<W: Basis<Scalar = U::Scalar>>(
        &self,
        next: &TensorSurface<W, V, P>,
        contact: usize,
        factor: P::Scalar,
    ) -> Result<TensorSurface<W, V, P>, JoinError> {
        check::<W>(contact, factor)?;
        let [_, hi] = U::domain();
        let weights: [U::Values; MOST + 1] = core::array::from_fn(|k| self.u_basis().derivatives(hi, k));
        let counts = |i: usize| weights[..=contact].iter().any(|w| w.as_ref()[i] != P::Scalar::ZERO);
        let rows = self.rows();
        // Some row counts, unless all functions vanish there to that order.
        let last = (0..U::LEN).rev().find(|&i| counts(i)).unwrap_or(U::LEN - 1);
        let basis = rows[last].basis();
        if let Some(row) = (0..U::LEN).find(|&i| counts(i) && rows[i].basis() != basis) {
            return Err(JoinError::FirstShape { row });
        }
        let across: Across<V, P> = core::array::from_fn(|k| {
            V::Points::from_fn(|j| {
                let column = rows.iter().map(|row| row.control_points()[j]);
                crate::basis::combination(column.zip(weights[k].as_ref().iter().copied()))
            })
        });
        next.with_start_u(basis, &across, contact, factor)
    }

    /// The derivatives across the edge `v = hi` of each row, which are the control points of the derivatives of the
    /// surface.
    fn across_v(&self, _: Checked) -> Across<U, P> {
        let [_, hi] = V::domain();
        let rows = U::Points::<[P; MOST + 1]>::from_fn(|i| self.rows()[i].eval_with_derivs(hi));
        core::array::from_fn(|k| U::Points::from_fn(|i| rows.as_ref()[i][k]))
    }

    /// This surface with its first rows such that the derivatives across `u = lo` are curves over these control points.
    fn with_start_u(
        &self,
        edge: V,
        across: &Across<V, P>,
        contact: usize,
        factor: P::Scalar,
    ) -> Result<Self, JoinError> {
        let [lo, _] = U::domain();
        for k in 0..=contact {
            let weights = self.u_basis().derivatives(lo, k);
            let wrong =
                |i: &usize| weights.as_ref()[*i] != P::Scalar::ZERO && self.rows()[*i].basis() != edge;
            if let Some(row) = (0..U::LEN).find(wrong) {
                return Err(JoinError::SecondShape { row: Some(row) });
            }
        }
        let mut net: U::Points<V::Points<P>> =
            U::Points::from_fn(|i| V::Points::from_fn(|j| self.rows()[i].control_points()[j]));
        for j in 0..V::LEN {
            let targets: [P; MOST + 1] = core::array::from_fn(|k| across[k].as_ref()[j]);
            let mut column = U::Points::<P>::from_fn(|i| net.as_ref()[i].as_ref()[j]);
            solve(self.u_basis(), &targets[..=contact], factor, column.as_mut())?;
            for (row, &point) in net.as_mut().iter_mut().zip(column.as_ref()) {
                row.as_mut()[j] = point;
            }
        }
        Ok(Self::with_rows(self.u_basis(), U::Points::from_fn(|i| self.rows()[i].basis()), net))
    }
}

/// That contact and factor are in range.
struct Checked;

fn check<W: Basis>(contact: usize, factor: W::Scalar) -> Result<Checked, JoinError> {
    let most = MOST.min(W::LEN - 1);
    if contact > most {
        return Err(JoinError::Contact { most, found: contact });
    }
    if !(factor > W::Scalar::ZERO && factor.is_finite()) {
        return Err(JoinError::Factor { value: factor.to_f64() });
    }
    Ok(Checked)
}

/// Replaces the first `targets.len()` control points so that the k-th derivative at the start of the domain is
/// `targets[k] / factorᵏ`, by Gaussian elimination.
fn solve<B: Basis, P: Point<Scalar = B::Scalar>>(
    basis: B,
    targets: &[P],
    factor: P::Scalar,
    points: &mut [P],
) -> Result<(), JoinError> {
    let [lo, _] = B::domain();
    let count = targets.len();
    let mut matrix = [[P::Scalar::ZERO; MOST + 1]; MOST + 1];
    let mut right = [P::zero(); MOST + 1];
    let mut power = P::Scalar::ONE;
    for (k, &target) in targets.iter().enumerate() {
        let weights = basis.derivatives(lo, k);
        let weights = weights.as_ref();
        let given = P::from_components(|c| target.component(c) / power);
        right[k] = points.iter().zip(weights).skip(count).fold(given, |sum, (&p, &w)| sum.add_scaled(p, -w));
        matrix[k][..count].copy_from_slice(&weights[..count]);
        power = power * factor;
    }
    for column in 0..count {
        let size = |row: usize| matrix[row][..count].iter().fold(P::Scalar::ZERO, |a, b| a.max(b.abs()));
        let relative = |row: usize| matrix[row][column].abs() / size(row).max(P::Scalar::MIN_POSITIVE);
        let pivot = (column..count).fold(column, |a, b| if relative(b) > relative(a) { b } else { a });
        if relative(pivot) <= P::Scalar::of(16.0) * P::Scalar::EPSILON || relative(pivot).is_nan() {
            return Err(JoinError::Undetermined);
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..count {
            let ratio = matrix[row][column] / matrix[column][column];
            if ratio == P::Scalar::ZERO {
                continue;
            }
            let pivot_row = matrix[column];
            for (entry, pivot_entry) in matrix[row].iter_mut().zip(pivot_row).skip(column) {
                *entry = *entry - ratio * pivot_entry;
            }
            right[row] = right[row].add_scaled(right[column], -ratio);
        }
    }
    for row in (0..count).rev() {
        let sum = (row + 1..count).fold(right[row], |sum, k| sum.add_scaled(points[k], -matrix[row][k]));
        points[row] = P::from_components(|c| sum.component(c) / matrix[row][row]);
    }
    Ok(())
}
