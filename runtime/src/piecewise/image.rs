//! Images of curves of all types under affine maps.

use alloc::vec::Vec;
use core::ops::Range;

use super::{AnyCurve, PiecewiseCurve};
#[cfg(feature = "bspline")]
use crate::bspline::{BSplineCurve, NurbsCurve};
use crate::vector::{is_finite, largest_component};
use crate::{
    Basis, Curve, CurveError, CurvePiece, ParametricCurve, Path, Point, RationalBasis, RationalBezier,
    RationalCurve, RationalSpline, Scalar, SpannedBasis, SpannedCurve,
};

/// An affine map: `to + Σ_d columns[d] (p - from)[d]`.
#[derive(Clone, Debug)]
pub(super) struct Affine<P: Point, Q: Point> {
    from: P,
    to: Q,
    columns: Vec<Q>,
}

impl<P: Point, Q: Point<Scalar = P::Scalar>> Affine<P, Q> {
    /// From its values at the corners of a box, so that the errors of images of points in there are rounding errors of
    /// the size of the images.
    pub(super) fn of([low, high]: [P; 2], mut image: impl FnMut(P) -> Q) -> Self {
        let extent = largest_component(high.minus(low));
        let size = if extent > P::Scalar::ZERO && extent.is_finite() { extent } else { P::Scalar::ONE };
        let from = if is_finite(low) { low } else { P::zero() };
        let to = image(from);
        let corner = |d: usize| {
            P::from_components(|k| if k == d { from.component(k) + size } else { from.component(k) })
        };
        let column = |d: usize| Q::from_vector(image(corner(d)).minus(to).scale(P::Scalar::ONE / size));
        let columns = (0..P::DIM).map(column).collect();
        Self { from, to, columns }
    }

    fn vector(&self, vector: P::Vector) -> Q::Vector {
        let columns = self.columns.iter().enumerate();
        let sum = columns.fold(Q::zero(), |sum, (d, &c)| sum.add_weighted(c, vector.component(d)));
        sum.to_vector()
    }

    fn point(&self, point: P) -> Q {
        self.to.add_scaled(self.vector(point.minus(self.from)), P::Scalar::ONE)
    }

    fn piece(&self, piece: &CurvePiece) -> CurvePiece {
        let control = |i: usize| P::from_components(|d| P::Scalar::of(piece.control(i, d)));
        let points: Vec<Q> = (0..=piece.degree()).map(|i| self.point(control(i))).collect();
        let unit = [P::Scalar::ZERO, P::Scalar::ONE];
        let weights = piece.weights().unwrap_or_default().iter().map(|&w| P::Scalar::of(w));
        let image = match CurvePiece::rational(unit, &points, &weights.collect::<Vec<_>>()) {
            Ok(image) => image,
            Err(_) => CurvePiece::polynomial(unit, &points),
        };
        image.over(piece.domain())
    }
}

/// The image of a curve under an affine map.
#[derive(Clone, Debug)]
pub(super) struct Image<P: Point, Q: Point> {
    pub(super) curve: AnyCurve<P>,
    pub(super) by: Affine<P, Q>,
}

impl<P: Point, Q: Point<Scalar = P::Scalar>> Image<P, Q> {
    fn of(&self, curve: AnyCurve<P>) -> Self {
        Self { curve, by: self.by.clone() }
    }
}

impl<P: Point, Q: Point<Scalar = P::Scalar>> ParametricCurve for Image<P, Q> {
    type Point = Q;
    type Part = Self;

    fn domain(&self) -> [Q::Scalar; 2] {
        self.curve.domain()
    }

    fn eval(&self, t: Q::Scalar) -> Q {
        self.by.point(self.curve.eval(t))
    }

    fn start(&self) -> Q {
        self.by.point(self.curve.start())
    }

    fn end(&self) -> Q {
        self.by.point(self.curve.end())
    }

    fn derivatives_into(&self, t: Q::Scalar, derivatives: &mut [Q::Vector]) {
        let mut own = alloc::vec![P::Vector::zero(); derivatives.len()];
        self.curve.derivatives_into(t, &mut own);
        for (order, (derivative, &own)) in derivatives.iter_mut().zip(&own).enumerate() {
            *derivative = match order {
                0 => self.by.point(P::from_vector(own)).to_vector(),
                _ => self.by.vector(own),
            };
        }
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.curve.pieces().iter().map(|piece| self.by.piece(piece)).collect()
    }

    fn parameter_of(&self, place: f64) -> Q::Scalar {
        self.curve.parameter_of(place)
    }

    fn place_of(&self, t: Q::Scalar) -> f64 {
        self.curve.place_of(t)
    }

    fn split(&self, t: Q::Scalar) -> Result<[Self; 2], CurveError> {
        Ok(self.curve.split(t)?.map(|part| self.of(part)))
    }

    fn subsegment(&self, range: Range<Q::Scalar>) -> Result<Self, CurveError> {
        Ok(self.of(self.curve.subsegment(range)?))
    }

    fn reversed(&self) -> Self {
        self.of(self.curve.reversed())
    }
}

impl<P: Point + Send + Sync + 'static> PiecewiseCurve<AnyCurve<P>> {
    /// The image under an affine map; see [`AnyCurve::map`]. Segments that meet exactly do so afterwards.
    #[must_use]
    pub fn map<Q>(&self, image: impl FnMut(P) -> Q) -> PiecewiseCurve<AnyCurve<Q>>
    where
        Q: Point<Scalar = P::Scalar> + Send + Sync + 'static,
    {
        let by = Affine::of(self.control_box(), image);
        PiecewiseCurve { segments: self.segments.iter().map(|segment| segment.image(by.clone())).collect() }
    }

    crate::affine::transform!();
}

/// The images of curves of which all segments have one type: by the `map` of that type.
macro_rules! mapped {
    ($($(#[$feature:meta])* $(@$basis:ident)? $curve:ty => $image:ty;)+) => {$(
        $(#[$feature])*
        impl<$(B: $basis,)? P: Point> PiecewiseCurve<$curve>
        where
            $(B: $basis<Scalar = P::Scalar>,)?
        {
            /// The curve over the images of all control points, by the `map` of the segments.
            #[must_use]
            pub fn map<Q: Point<Scalar = P::Scalar>>(
                &self,
                mut image: impl FnMut(P) -> Q,
            ) -> PiecewiseCurve<$image> {
                PiecewiseCurve { segments: self.segments.iter().map(|segment| segment.map(&mut image)).collect() }
            }

            crate::affine::transform!();
        }
    )+};
}

mapped! {
    @Basis Curve<B, P> => Curve<B, Q>;
    @RationalBasis RationalCurve<B, P> => RationalCurve<B, Q>;
    @SpannedBasis SpannedCurve<B, P> => SpannedCurve<B, Q>;
    RationalBezier<P> => RationalBezier<Q>;
    RationalSpline<P> => RationalSpline<Q>;
    Path<P> => Path<Q>;
    #[cfg(feature = "bspline")]
    BSplineCurve<P> => BSplineCurve<Q>;
    #[cfg(feature = "bspline")]
    NurbsCurve<P> => NurbsCurve<Q>;
}
