//! Curves that continue a curve, at either end, with a given order of contact.

use crate::vector::{is_finite, largest_component};
use crate::{Array, Basis, Curve, CurveError, Point, Scalar};

/// How the derivatives `Q', Q'', …` at the start of a curve follow from those at the end of another, `P', P'', …`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Contact<S> {
    /// Parametric continuity Cⁿ: the derivatives up to this order are the same.
    Parametric {
        /// The order; 0 for a common point.
        order: usize,
    },
    /// Geometric continuity G1: `Q' = β1 P'`, a common tangent.
    Tangent {
        /// The ratio of the velocities, positive.
        beta1: S,
    },
    /// Geometric continuity G2: `Q' = β1 P'`, `Q'' = β1² P'' + β2 P'`, a common tangent and curvature (Barsky's β-constraints).
    Curvature {
        /// The ratio of the velocities, positive.
        beta1: S,
        /// Any number; it moves the second derivative along the tangent.
        beta2: S,
    },
}

impl<S: Scalar> Contact<S> {
    /// The highest derivative that is prescribed.
    pub fn order(&self) -> usize {
        match *self {
            Self::Parametric { order } => order,
            Self::Tangent { .. } => 1,
            Self::Curvature { .. } => 2,
        }
    }

    fn check(&self) -> Result<(), CurveError> {
        let (beta1, beta2) = match *self {
            Self::Parametric { .. } => return Ok(()),
            Self::Tangent { beta1 } => (beta1, S::ZERO),
            Self::Curvature { beta1, beta2 } => (beta1, beta2),
        };
        if !(beta1 > S::ZERO && beta1.is_finite()) {
            return Err(CurveError::Factor { value: beta1.to_f64() });
        }
        if !beta2.is_finite() {
            return Err(CurveError::Factor { value: beta2.to_f64() });
        }
        Ok(())
    }

    /// Replaces the derivatives at the end of the first curve by those at the start of the next one.
    fn transform<P: Point<Scalar = S>>(&self, derivatives: &mut [P]) {
        let (beta1, beta2) = match *self {
            Self::Parametric { .. } => return,
            Self::Tangent { beta1 } => (beta1, S::ZERO),
            Self::Curvature { beta1, beta2 } => (beta1, beta2),
        };
        if let [_, first, rest @ ..] = derivatives {
            if let Some(second) = rest.first_mut() {
                *second = second.scale(beta1 * beta1).add_scaled(*first, beta2);
            }
            *first = first.scale(beta1);
        }
    }
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// A curve of any family that continues this one: its first control points, one more than the order of contact, are
    /// computed; the others are taken from `points`.
    ///
    /// The computed points solve `Σ_i b[i]⁽ᵏ⁾(lo) Q[i] = Q⁽ᵏ⁾` for `k` from 0 to the order, with the derivatives `Q⁽ᵏ⁾` of
    /// [`Contact`].
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// use basis_runtime::{Contact, Curve};
    ///
    /// let first = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let free = [[0.0, 0.0], [0.0, 0.0], [7.0, 0.0], [8.0, 1.0]]; // the first two will be replaced
    /// let next = first.continuation(QuarticBernstein::new(-1.0)?, Contact::Tangent { beta1: 1.0 }, free)?;
    /// assert_eq!(next.control_points(), [[4.0, 0.0], [5.75, -3.5], [7.0, 0.0], [8.0, 1.0]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Factor`] if `β1` is not positive or a factor not finite, [`CurveError::NotFinite`] if this curve is not,
    /// [`CurveError::Join`] if the first control points of the family do not determine these derivatives: some families have
    /// shape values at which their derivative at the start is zero.
    pub fn continuation<C: Basis<Scalar = B::Scalar>>(
        &self,
        basis: C,
        contact: Contact<B::Scalar>,
        points: C::Points<P>,
    ) -> Result<Curve<C, P>, CurveError> {
        self.touching(basis, contact, points, false)
    }

    /// A curve of any family that this one continues: its last control points, one more than the order of contact, are computed;
    /// the others are taken from `points`.
    ///
    /// As [`continuation`](Self::continuation) at the other end: the derivatives `Q⁽ᵏ⁾` at the end of the new curve follow
    /// from those at the start of this one, `P', P'', …`, as [`Contact`] says.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// use basis_runtime::{Contact, Curve};
    ///
    /// let last = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let free = [[-4.0, 0.0], [-3.0, 1.0], [0.0, 0.0], [0.0, 0.0]]; // the last two will be replaced
    /// let first = last.preceding(QuarticBernstein::new(-1.0)?, Contact::Tangent { beta1: 1.0 }, free)?;
    /// assert_eq!(first.control_points(), [[-4.0, 0.0], [-3.0, 1.0], [-1.75, -3.5], [0.0, 0.0]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`continuation`](Self::continuation), for the last control points.
    pub fn preceding<C: Basis<Scalar = B::Scalar>>(
        &self,
        basis: C,
        contact: Contact<B::Scalar>,
        points: C::Points<P>,
    ) -> Result<Curve<C, P>, CurveError> {
        self.touching(basis, contact, points, true)
    }

    /// A curve that touches this one, `before` its start or else after its end. Its control points are counted from the
    /// common point.
    fn touching<C: Basis<Scalar = B::Scalar>>(
        &self,
        basis: C,
        contact: Contact<B::Scalar>,
        points: C::Points<P>,
        before: bool,
    ) -> Result<Curve<C, P>, CurveError> {
        contact.check()?;
        let conditions = contact.order().saturating_add(1);
        let undetermined = CurveError::Join { conditions, points: C::LEN };
        if conditions > C::LEN {
            return Err(undetermined);
        }
        let place = |i: usize| if before { C::LEN - 1 - i } else { i };
        let (here, there) = (B::domain()[usize::from(!before)], C::domain()[usize::from(before)]);
        let given = C::Points::<P>::from_fn(|i| points.as_ref()[place(i)]);
        let mut points = given;
        let targets = &mut points.as_mut()[..conditions];
        self.derivatives_into(here, targets);
        contact.transform(targets);
        if !targets.iter().all(|&p| is_finite(p)) {
            return Err(CurveError::NotFinite);
        }
        let mut matrix = C::Points::<C::Values>::from_fn(|k| {
            let row = basis.derivatives(there, k);
            C::Values::from_components(|i| row.component(place(i)))
        });
        let matrix = &mut matrix.as_mut()[..conditions];
        for (target, row) in targets.iter_mut().zip(matrix.iter()) {
            for (i, &weight) in row.as_ref().iter().enumerate().skip(conditions) {
                *target = target.add_scaled(given.as_ref()[i], -weight);
            }
        }
        solve(matrix, targets).ok_or(undetermined)?;
        Ok(Curve::new(basis, C::Points::from_fn(|i| points.as_ref()[place(i)])))
    }
}

/// Solves `matrix · x = right` by elimination with the largest pivot; `x` replaces `right`. `None` if the matrix is singular
/// up to rounding.
fn solve<V, P>(matrix: &mut [V], right: &mut [P]) -> Option<()>
where
    P: Point,
    V: Array<P::Scalar> + Point<Scalar = P::Scalar>,
{
    let len = right.len();
    // The derivatives grow with their order: rows are compared after division by their largest entry.
    for (row, value) in matrix.iter_mut().zip(right.iter_mut()) {
        let size = largest_component(*row);
        if !(size > P::Scalar::ZERO && size.is_finite()) {
            return None;
        }
        *row = row.scale(P::Scalar::ONE / size);
        *value = value.scale(P::Scalar::ONE / size);
    }
    let noise = P::Scalar::EPSILON * P::Scalar::from_usize(16 * len);
    for column in 0..len {
        let pivot = (column..len).reduce(|a, b| {
            if matrix[b].component(column).abs() > matrix[a].component(column).abs() { b } else { a }
        })?;
        if matrix[pivot].component(column).abs() <= noise {
            return None;
        }
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        for row in column + 1..len {
            let factor = matrix[row].component(column) / matrix[column].component(column);
            if factor != P::Scalar::ZERO {
                matrix[row] = matrix[row].add_scaled(matrix[column], -factor);
                right[row] = right[row].add_scaled(right[column], -factor);
            }
        }
    }
    for row in (0..len).rev() {
        let known = right.iter().enumerate().skip(row + 1);
        let value =
            known.fold(right[row], |value, (column, &x)| value.add_scaled(x, -matrix[row].component(column)));
        let pivot = matrix[row].component(row);
        right[row] = P::from_components(|d| value.component(d) / pivot);
    }
    Some(())
}
