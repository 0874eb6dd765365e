//! A curve of any type behind one type.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::any::Any;
use core::fmt::{self, Debug, Formatter};
use core::ops::Range;

use super::image::{Affine, Image};
use crate::geometry::forward;
use crate::{CurveError, CurvePiece, Frame, Nearest, ParametricCurve, Point, Point3};

/// A curve of any type, so that curves of different families and degrees have one type: the segments of a
/// [`PiecewiseCurve`](crate::PiecewiseCurve), or a list of curves that can be cut.
///
/// It answers everything by the methods of the curve inside, so that points and derivatives are those of its family, bit
/// for bit; each question costs one indirect call more. It is cheap to clone: clones share the curve, which never
/// changes.
///
/// ```
/// use basis_runtime::{AnyCurve, Bezier, ParametricCurve, RationalBezier};
///
/// let line = Bezier::from_points([[2.0, 0.0], [1.0, 0.0]]);
/// let half = 0.5_f64.sqrt();
/// let arc = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, half, 1.0])?;
/// let curves = [AnyCurve::new(line), AnyCurve::new(arc)];
/// let length: f64 = curves.iter().map(|curve| curve.arclen(1e-9)).sum();
/// assert!((length - 1.0 - std::f64::consts::FRAC_PI_2).abs() < 1e-8);
/// assert_eq!(curves[0].downcast_ref(), Some(&line));
/// # Ok::<(), basis_runtime::CurveError>(())
/// ```
pub struct AnyCurve<P: Point>(Arc<dyn Shared<P>>);

/// A curve that can be shared and cut without its type.
trait Shared<P: Point>: ParametricCurve<Point = P> + Debug + Send + Sync {
    fn any(&self) -> &dyn Any;
    fn split_any(&self, t: P::Scalar) -> Result<[AnyCurve<P>; 2], CurveError>;
    fn subsegment_any(&self, range: Range<P::Scalar>) -> Result<AnyCurve<P>, CurveError>;
    fn reversed_any(&self) -> AnyCurve<P>;
}

impl<P: Point, C> Shared<P> for C
where
    C: ParametricCurve<Point = P> + Debug + Send + Sync + 'static,
    C::Part: ParametricCurve<Part = C::Part> + Debug + Send + Sync + 'static,
{
    fn any(&self) -> &dyn Any {
        self
    }

    fn split_any(&self, t: P::Scalar) -> Result<[AnyCurve<P>; 2], CurveError> {
        Ok(self.split(t)?.map(AnyCurve::new))
    }

    fn subsegment_any(&self, range: Range<P::Scalar>) -> Result<AnyCurve<P>, CurveError> {
        Ok(AnyCurve::new(self.subsegment(range)?))
    }

    fn reversed_any(&self) -> AnyCurve<P> {
        AnyCurve::new(self.reversed())
    }
}

impl<P: Point> AnyCurve<P> {
    /// Any curve, which keeps its domain. That parts of its parts are of one type is so of all types of this crate.
    pub fn new<C>(curve: C) -> Self
    where
        C: ParametricCurve<Point = P> + Debug + Send + Sync + 'static,
        C::Part: ParametricCurve<Part = C::Part> + Debug + Send + Sync + 'static,
    {
        Self(Arc::new(curve))
    }

    /// The curve inside, if it is of that type: with its control points, and of a family with its shape values.
    pub fn downcast_ref<C: 'static>(&self) -> Option<&C> {
        self.0.any().downcast_ref()
    }
}

impl<P: Point + Send + Sync + 'static> AnyCurve<P> {
    /// The image under an affine map, over the same domain. It is evaluated as the image of points of this curve; the
    /// closure is not kept, but `n + 1` of its values, in a space of `n` dimensions, from which all others follow.
    #[must_use]
    pub fn map<Q>(&self, image: impl FnMut(P) -> Q) -> AnyCurve<Q>
    where
        Q: Point<Scalar = P::Scalar> + Send + Sync + 'static,
    {
        self.image(Affine::of(self.control_box(), image))
    }

    pub(super) fn image<Q>(&self, by: Affine<P, Q>) -> AnyCurve<Q>
    where
        Q: Point<Scalar = P::Scalar> + Send + Sync + 'static,
    {
        AnyCurve::new(Image { curve: self.clone(), by })
    }

    crate::affine::transform!();
}

impl<P: Point> Clone for AnyCurve<P> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<P: Point> Debug for AnyCurve<P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<P: Point> ParametricCurve for AnyCurve<P> {
    type Point = P;
    type Part = Self;

    forward! { [0]
        domain() -> [P::Scalar; 2];
        eval(t: P::Scalar) -> P;
        derivatives_into(t: P::Scalar, derivatives: &mut [P::Vector]) -> ();
        pieces() -> Vec<CurvePiece>;
        parameter_of(place: f64) -> P::Scalar;
        place_of(t: P::Scalar) -> f64;
        start() -> P;
        end() -> P;
        eval_checked(t: P::Scalar) -> Result<P, CurveError>;
        eval_clamped(t: P::Scalar) -> P;
        eval_into(ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError>;
        derivative(t: P::Scalar, order: usize) -> P::Vector;
        samples_into(out: &mut [P]) -> ();
        tangent(t: P::Scalar) -> Option<P::Vector>;
        extent() -> P::Scalar;
        curvature(t: P::Scalar) -> P::Scalar;
        arclen(accuracy: P::Scalar) -> P::Scalar;
        inv_arclen(length: P::Scalar, accuracy: P::Scalar) -> P::Scalar;
        arclen_parameters(count: usize, accuracy: P::Scalar) -> Vec<P::Scalar>;
        samples_by_arclen(count: usize, accuracy: P::Scalar) -> Vec<P>;
        flatten(tolerance: P::Scalar) -> Result<Vec<P>, CurveError>;
        control_box() -> [P; 2];
        bounding_box() -> [P; 2];
        extrema() -> Vec<P::Scalar>;
        inflections() -> Result<Vec<P::Scalar>, CurveError>;
        nearest(point: P, accuracy: P::Scalar) -> Option<Nearest<P>>;
    }

    fn frenet_frame(&self, t: P::Scalar) -> Result<Frame<P>, CurveError>
    where
        P: Point3,
    {
        self.0.frenet_frame(t)
    }

    fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        self.0.split_any(t)
    }

    /// The whole of the curve is the curve itself.
    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        let [lo, hi] = self.domain();
        if range == (lo..hi) { Ok(self.clone()) } else { self.0.subsegment_any(range) }
    }

    fn reversed(&self) -> Self {
        self.0.reversed_any()
    }
}
