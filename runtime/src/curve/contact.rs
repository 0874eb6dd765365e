//! Curves that continue a curve, at either end, with a given order of contact.

use crate::vector::{is_finite, largest_component, vectors};
use crate::{Array, Basis, Curve, CurveError, Point, Scalar};

/// How the derivatives of two curves P and Q, each in its own parameter, agree at a common point.
///
/// The equations are met as they stand. Geometric continuity follows from them where `P'` does not vanish; where it does,
/// as at the end of a curve that is a point or at a pole of a surface, so does `Q'`, and there is no common tangent: the
/// direction in which Q leaves is that of its first derivative that does not vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Contact<S> {
    /// Parametric continuity Cⁿ: `Q⁽ᵏ⁾ = P⁽ᵏ⁾` for all `k` up to this order.
    Parametric {
        /// The order; 0 for a common point.
        order: usize,
    },
    /// Geometric continuity G1, a common tangent: `f Q' = P'`.
    Tangent {
        /// How many times as long the velocity of P is, positive.
        f: S,
    },
    /// Geometric continuity G2, a common tangent and a common curvature: `f Q' = P'`, `f² Q'' + c Q' = P''`.
    Curvature {
        /// How many times as long the velocity of P is, positive.
        f: S,
        /// Any number; it moves the second derivative along the tangent.
        c: S,
    },
    /// Parametric continuity after a change of the speed: `fᵏ Q⁽ᵏ⁾ = P⁽ᵏ⁾` for all `k` up to this order, and so geometric
    /// continuity of that order.
    Scaled {
        /// The order.
        order: usize,
        /// How many times as long the velocity of P is, positive.
        f: S,
    },
}

impl<S: Scalar> Contact<S> {
    /// The highest derivative that is prescribed.
    pub fn order(&self) -> usize {
        match *self {
            Self::Parametric { order } | Self::Scaled { order, .. } => order,
            Self::Tangent { .. } => 1,
            Self::Curvature { .. } => 2,
        }
    }

    /// The two factors; `None` for those of parametric continuity, 1 and 0.
    fn factors(&self) -> Result<Option<(S, S)>, CurveError> {
        let (f, c) = match *self {
            Self::Parametric { .. } => return Ok(None),
            Self::Tangent { f } | Self::Scaled { f, .. } => (f, S::ZERO),
            Self::Curvature { f, c } => (f, c),
        };
        if !(f > S::ZERO && f.is_finite()) {
            return Err(CurveError::Factor { name: "f", value: f.to_f64() });
        }
        if !c.is_finite() {
            return Err(CurveError::Factor { name: "c", value: c.to_f64() });
        }
        Ok(Some((f, c)))
    }

    /// Replaces the derivatives of P by those of Q.
    pub(crate) fn transform<P: Point<Scalar = S>>(&self, derivatives: &mut [P]) -> Result<(), CurveError> {
        if let (Some((f, c)), [_, first, rest @ ..]) = (self.factors()?, derivatives) {
            let inverse = S::ONE / f;
            let mut power = inverse * inverse;
            for higher in rest.iter_mut().skip(1) {
                power = power * inverse;
                *higher = higher.scale(power);
            }
            *first = first.scale(inverse);
            if let Some(second) = rest.first_mut() {
                *second = second.add_weighted(*first, -c).scale(inverse * inverse);
            }
        }
        Ok(())
    }
}

/// The derivatives at the end of the same curve in the other direction.
#[cfg(feature = "alloc")]
pub(crate) fn backwards<P: Point>(derivatives: &[P]) -> alloc::vec::Vec<P> {
    let sign = |k: usize| if k.is_multiple_of(2) { P::Scalar::ONE } else { -P::Scalar::ONE };
    derivatives.iter().enumerate().map(|(k, p)| p.scale(sign(k))).collect()
}

/// An end of a curve.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Start,
    Last,
}

/// The control points of a curve over `basis` that touches `curve` with this end of its own: after the end of `curve`
/// with its start, before the start of `curve` with its last point.
pub(crate) fn touching<B: Basis, C: Basis<Scalar = B::Scalar>, P: Point<Scalar = B::Scalar>>(
    basis: &C,
    curve: &Curve<B, P>,
    contact: Contact<B::Scalar>,
    points: C::Points<P>,
    end: End,
) -> Result<C::Points<P>, CurveError> {
    let conditions = contact.order().saturating_add(1);
    if conditions > C::LEN {
        let (most, found) = (C::LEN.saturating_sub(1), contact.order());
        return Err(CurveError::Contact { family: C::NAME, most, found });
    }
    let mut derivatives: C::Points<P::Vector> = vectors(points.as_ref());
    let first = &mut derivatives.as_mut()[..conditions];
    curve.derivatives_into(B::domain()[usize::from(end == End::Start)], first);
    contact.transform(first)?;
    let derivatives = C::Points::<P>::from_fn(|i| P::from_vector(derivatives.as_ref()[i]));
    let derivatives = &derivatives.as_ref()[..conditions];
    let points = match end {
        End::Start => basis.start_points(derivatives, points)?,
        End::Last => basis.end_points(derivatives, points)?,
    };
    if !points.as_ref().iter().all(|&p| is_finite(p)) {
        return Err(CurveError::NotFinite);
    }
    Ok(points)
}

/// [`Basis::start_points`] or [`Basis::end_points`] for any order, by elimination.
pub(crate) fn eliminate<B: Basis, P: Point<Scalar = B::Scalar>>(
    basis: &B,
    derivatives: &[P],
    points: B::Points<P>,
    end: End,
) -> Result<B::Points<P>, CurveError> {
    let at = B::domain()[usize::from(end == End::Last)];
    let matrix = B::Points::<B::Values>::from_fn(|k| basis.derivatives(at, k));
    eliminate_in(B::NAME, matrix, derivatives, points, end)
}

/// [`eliminate`] with the derivatives of the functions at that end, one row for each order.
pub(crate) fn eliminate_in<V, M, A, P>(
    family: &'static str,
    mut matrix: M,
    derivatives: &[P],
    points: A,
    end: End,
) -> Result<A, CurveError>
where
    P: Point,
    V: Array<P::Scalar> + Point<Scalar = P::Scalar>,
    M: Array<V>,
    A: Array<P>,
{
    let conditions = derivatives.len();
    let undetermined = CurveError::Join { family, conditions, at: "" };
    if conditions > A::LEN {
        return Err(undetermined);
    }
    // Points and functions are counted from the end.
    let place = |i: usize| if end == End::Last { A::LEN - 1 - i } else { i };
    let matrix = &mut matrix.as_mut()[..conditions];
    for row in matrix.iter_mut() {
        let own = *row;
        *row = V::from_components(|i| own.component(place(i)));
    }
    let mut solved = points;
    let targets = &mut solved.as_mut()[..conditions];
    targets.copy_from_slice(derivatives);
    for (target, row) in targets.iter_mut().zip(matrix.iter()) {
        for (i, &weight) in row.as_ref().iter().enumerate().skip(conditions) {
            *target = target.add_weighted(points.as_ref()[place(i)], -weight);
        }
    }
    solve(matrix, targets).ok_or(undetermined)?;
    let mut points = points;
    for (i, &value) in targets.iter().enumerate() {
        points.as_mut()[place(i)] = value;
    }
    Ok(points)
}

/// Solves `matrix · x = right` by elimination with the largest pivot; `x` replaces `right`. `None` if the matrix is
/// singular up to rounding.
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
                matrix[row] = matrix[row].add_weighted(matrix[column], -factor);
                right[row] = right[row].add_weighted(right[column], -factor);
            }
        }
    }
    for row in (0..len).rev() {
        let known = right.iter().enumerate().skip(row + 1);
        let value = known
            .fold(right[row], |value, (column, &x)| value.add_weighted(x, -matrix[row].component(column)));
        let pivot = matrix[row].component(row);
        right[row] = P::from_components(|d| value.component(d) / pivot);
    }
    Some(())
}
