//! Curves of every type that are moved at an end so that they continue another curve.

use alloc::vec::Vec;

use super::{CurveScalar, CurveVector, ParametricCurve};
use crate::curve::backwards;
use crate::numeric::binomial::binomial;
use crate::numeric::leibniz;
use crate::vector::is_finite;
use crate::{
    Array, Basis, Contact, Curve, CurveError, Point, RationalBasis, RationalBezier, RationalCurve,
    RationalSpline, Scalar, SpannedBasis, SpannedCurve,
};

/// A curve whose control points next to an end can be replaced so that it has given derivatives there: what
/// [`ParametricCurve::continued`] and [`ParametricCurve::preceded`] move. All types with control points of their own
/// are: [`Curve`], [`PiecewiseCurve`](crate::PiecewiseCurve) of these, [`RationalCurve`], [`SpannedCurve`],
/// [`RationalBezier`], [`RationalSpline`], [`Path`](crate::Path), and with the feature `bspline` `BSplineCurve` and `NurbsCurve`.
pub trait JoinableCurve: ParametricCurve + Sized {
    /// The highest order of contact at an end: one less than the number of control points that its derivatives can
    /// determine.
    fn highest_contact(&self) -> usize;

    /// The curve with this point and these derivatives `[C, C', …]` at its start, as
    /// [`derivatives_into`](ParametricCurve::derivatives_into) gives them: as many control points as there are of these are
    /// replaced, weights and knots stay.
    ///
    /// # Errors
    /// [`CurveError::Contact`] if there are more than the [`highest_contact`](Self::highest_contact) allows,
    /// [`CurveError::Join`] if the control points do not determine them, [`CurveError::NotFinite`] if a computed point is
    /// not finite.
    fn with_start(&self, derivatives: &[CurveVector<Self>]) -> Result<Self, CurveError>;

    /// As [`with_start`](Self::with_start), at the end of the curve.
    ///
    /// # Errors
    /// As [`with_start`](Self::with_start).
    fn with_end(&self, derivatives: &[CurveVector<Self>]) -> Result<Self, CurveError>;
}

/// What a curve that is joined to another one at its parameter `t` has there.
pub(super) fn touching<P: Point>(
    curve: &(impl ParametricCurve<Point = P> + ?Sized),
    t: P::Scalar,
    contact: Contact<P::Scalar>,
    most: usize,
) -> Result<Vec<P::Vector>, CurveError> {
    if contact.order() > most {
        return Err(CurveError::Contact { family: "the curve", most, found: contact.order() });
    }
    let mut derivatives = alloc::vec![P::Vector::zero(); contact.order() + 1];
    curve.derivatives_into(t, &mut derivatives);
    contact.transform(&mut derivatives)?;
    Ok(derivatives)
}

/// The point and the derivatives as control points take them.
pub(crate) fn as_points<P: Point>(derivatives: &[P::Vector]) -> Vec<P> {
    derivatives.iter().map(|&derivative| P::from_vector(derivative)).collect()
}

/// The error for more derivatives than a curve can have.
pub(crate) fn possible<C: JoinableCurve>(
    curve: &C,
    family: &'static str,
    derivatives: &[CurveVector<C>],
) -> Result<(), CurveError> {
    let (most, found) = (curve.highest_contact(), derivatives.len().saturating_sub(1));
    if found > most { Err(CurveError::Contact { family, most, found }) } else { Ok(()) }
}

/// Replaces the first points so that `Σ_i row(k)[i] points[i] = derivatives[k]`, where the entries of a row behind the
/// diagonal vanish: as at a clamped end.
pub(crate) fn replace_first<P: Point>(
    points: &mut [P],
    derivatives: &[P],
    row: impl Fn(usize) -> Vec<P::Scalar>,
) -> Result<(), CurveError> {
    for (k, &derivative) in derivatives.iter().enumerate() {
        let row = row(k);
        let known = row.iter().zip(&*points).take(k);
        let rest = known.fold(derivative, |rest, (&weight, &point)| rest.add_weighted(point, -weight));
        points[k] = P::from_components(|d| rest.component(d) / row[k]);
        if !is_finite(points[k]) {
            return Err(CurveError::NotFinite);
        }
    }
    Ok(())
}

/// An array of the same points.
fn copied<P: Copy, A: Array<P>>(points: &[P]) -> A {
    A::from_fn(|i| points[i])
}

/// [`JoinableCurve`] of a curve over a family.
macro_rules! over_family {
    ($($basis:ident: $curve:ident;)+) => {$(
        impl<B: $basis, P: Point<Scalar = B::Scalar>> JoinableCurve for $curve<B, P> {
            fn highest_contact(&self) -> usize {
                self.control_points().len().saturating_sub(1)
            }

            fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
                possible(self, B::NAME, derivatives)?;
                let points = self.basis().start_points(&as_points(derivatives), copied(self.control_points()))?;
                finite(points.as_ref())?;
                Ok(Self::new(self.basis(), points))
            }

            fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
                possible(self, B::NAME, derivatives)?;
                let points = self.basis().end_points(&as_points(derivatives), copied(self.control_points()))?;
                finite(points.as_ref())?;
                Ok(Self::new(self.basis(), points))
            }
        }
    )+};
}

over_family! {
    Basis: Curve;
    RationalBasis: RationalCurve;
}

/// At an end, the curve is that of the first or the last span.
impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> JoinableCurve for SpannedCurve<B, P> {
    fn highest_contact(&self) -> usize {
        B::LEN.saturating_sub(1)
    }

    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        possible(self, B::NAME, derivatives)?;
        let points =
            self.basis().span(0).start_points(&as_points(derivatives), copied(self.control_points()))?;
        finite(points.as_ref())?;
        Ok(Self::new(self.basis(), points))
    }

    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        possible(self, B::NAME, derivatives)?;
        let last = self.basis().span(B::SPANS - 1);
        let points = last.end_points(&as_points(derivatives), copied(self.control_points()))?;
        finite(points.as_ref())?;
        Ok(Self::new(self.basis(), points))
    }
}

/// Only the first or the last curve is changed.
impl<P: Point> JoinableCurve for RationalSpline<P> {
    fn highest_contact(&self) -> usize {
        let curves = self.curves();
        curves[0].degree().min(curves[curves.len() - 1].degree())
    }

    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        let mut curves = self.curves().to_vec();
        curves[0] = curves[0].with_start(derivatives)?;
        Self::new(curves)
    }

    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        let mut curves = self.curves().to_vec();
        let last = curves.len() - 1;
        curves[last] = curves[last].with_end(derivatives)?;
        Self::new(curves)
    }
}

fn finite<P: Point>(points: &[P]) -> Result<(), CurveError> {
    if points.iter().all(|&p| is_finite(p)) { Ok(()) } else { Err(CurveError::NotFinite) }
}

impl<P: Point> JoinableCurve for RationalBezier<P> {
    fn highest_contact(&self) -> usize {
        self.degree()
    }

    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        possible(self, "the Bézier curve", derivatives)?;
        let [lo, hi] = self.domain();
        let degree = self.degree();
        // The derivative of order k of the Bernstein polynomial i at the start.
        let row = |k: usize| -> Vec<P::Scalar> {
            let factor = (0..k)
                .fold(P::Scalar::ONE, |f, i| f * CurveScalar::<Self>::from_usize(degree - i) / (hi - lo));
            let entry = |i: usize| {
                let sign = if (k - i).is_multiple_of(2) { factor } else { -factor };
                sign * binomial::<P::Scalar>(k, i)
            };
            (0..=k).map(entry).collect()
        };
        let weight =
            |k: usize| row(k).iter().zip(self.weights()).fold(P::Scalar::ZERO, |sum, (&a, &w)| sum + a * w);
        let weights: Vec<P::Scalar> = (0..derivatives.len()).map(weight).collect();
        let mut points = self.numerator().to_vec();
        replace_first(&mut points, &leibniz::product(&as_points(derivatives), &weights), row)?;
        let divided = points.iter().zip(self.weights());
        let divided: Vec<P> = divided.map(|(p, &w)| P::from_components(|d| p.component(d) / w)).collect();
        finite(&divided)?;
        Ok(Self::new(divided, self.weights().to_vec())?.with_domain([lo, hi]))
    }

    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        Ok(self.reversed().with_start(&backwards(derivatives))?.reversed())
    }
}
