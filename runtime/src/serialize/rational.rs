//! Curves over rational families as they are written; what is read goes through the constructors.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Elements, ReadCurve, WrittenCurve};
use crate::{Point, RationalBasis, RationalCurve, SpannedBasis, SpannedCurve};

impl<B, P> Serialize for SpannedCurve<B, P>
where
    B: SpannedBasis + Serialize,
    P: Point<Scalar = B::Scalar> + Serialize,
{
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        WrittenCurve { basis: &self.basis(), points: self.control_points() }.serialize(serializer)
    }
}

impl<'de, B, P> Deserialize<'de> for SpannedCurve<B, P>
where
    B: SpannedBasis + Deserialize<'de>,
    P: Point<Scalar = B::Scalar> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ReadCurve { basis, points } =
            ReadCurve::<B, Elements<B::Points<P>, P>>::deserialize(deserializer)?;
        Ok(Self::new(basis, points.0))
    }
}

impl<B, P> Serialize for RationalCurve<B, P>
where
    B: RationalBasis + Serialize,
    P: Point<Scalar = B::Scalar> + Serialize,
{
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        WrittenCurve { basis: &self.basis(), points: self.control_points() }.serialize(serializer)
    }
}

impl<'de, B, P> Deserialize<'de> for RationalCurve<B, P>
where
    B: RationalBasis + Deserialize<'de>,
    P: Point<Scalar = B::Scalar> + Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let ReadCurve { basis, points } =
            ReadCurve::<B, Elements<B::Points<P>, P>>::deserialize(deserializer)?;
        Ok(Self::new(basis, points.0))
    }
}

#[cfg(feature = "geometry")]
pub(crate) mod bezier {
    //! The Bernstein coefficients of numerator and denominator.

    use alloc::vec::Vec;
    use core::cmp::Ordering;

    use serde::Deserialize;

    use crate::serialize::Read;
    use crate::{CurveError, Point, RationalBezier, RationalSpline, Scalar};

    #[derive(Deserialize)]
    #[serde(rename = "RationalSpline", expecting = "struct RationalSpline")]
    #[serde(bound(deserialize = "P: Read<'de>"))]
    pub(crate) struct Spline<P: Point> {
        curves: Vec<RationalBezier<P>>,
    }

    impl<P: Point> TryFrom<Spline<P>> for RationalSpline<P> {
        type Error = CurveError;

        fn try_from(read: Spline<P>) -> Result<Self, CurveError> {
            Self::new(read.curves)
        }
    }

    #[derive(Deserialize)]
    #[serde(rename = "RationalBezier", expecting = "struct RationalBezier")]
    #[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
    pub(crate) struct Bezier<P: Point> {
        domain: [P::Scalar; 2],
        numerator: Vec<P>,
        weights: Vec<P::Scalar>,
    }

    impl<P: Point> TryFrom<Bezier<P>> for RationalBezier<P> {
        type Error = CurveError;

        fn try_from(read: Bezier<P>) -> Result<Self, CurveError> {
            let Bezier { domain: [lo, hi], numerator, weights } = read;
            if numerator.len() != weights.len() || numerator.is_empty() {
                let expected = numerator.len().max(1);
                return Err(CurveError::Length { expected, found: weights.len() });
            }
            if lo.partial_cmp(&hi) != Some(Ordering::Less) {
                return Err(CurveError::EmptyRange { at: lo.to_f64() });
            }
            let wrong = |w: &P::Scalar| !w.is_finite();
            if let Some(index) = weights.iter().position(wrong) {
                return Err(CurveError::Weight { index, value: weights[index].to_f64() });
            }
            Ok(Self::of_numerator([lo, hi], &numerator, &weights))
        }
    }
}
