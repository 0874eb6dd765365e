//! Points to curves of all kinds, and grids of points to surfaces: one builder for each.

mod fitted;
mod functions;
mod grid;
mod knots;
mod linear;
mod lines;
mod orthogonal;
mod polygon;
mod shapes;

use alloc::boxed::Box;
use alloc::vec::Vec;

pub use fitted::{FitEnd, Fitted, GridEnd};
use functions::{Functions, Polynomial, Rational, Spanned, ends_of_domain};
pub use grid::{FittedSurface, GridFit};
use knots::Over;
use linear::{Data, End, Problem, Space, dot};
use orthogonal::{Search, State};
use polygon::{corners, spaced};

use crate::bspline::{BSplineCurve, FitError, KnotVector, Spacing};
use crate::vector::direction;
use crate::{
    Array, Basis, Curve, ParametricCurve, Path, PathSegment, Point, RationalBasis, RationalCurve, Scalar,
    ShapeError, SpannedBasis, SpannedCurve,
};

/// Points to which a curve is fitted, and how.
///
/// For given parameters `t[i]` and weights `w[i]` the control points minimise
///
/// ```text
/// Σ_i (w[i] |C(t[i]) - p[i]|)² + λ ∫ |C''(t)|² dt,
/// ```
///
/// among the curves with the ends that are asked for. The system is solved by rotations in `f64`, banded for B-splines,
/// without normal equations; λ is 0 unless [`smoothing`](Self::smoothing) says otherwise. With
/// [`orthogonal`](Self::orthogonal) the parameters are unknowns too, so that the distances from the curve are minimised, and
/// shape values where a family has them: see [`curve_over`](Self::curve_over).
///
/// Without [`parameters`](Self::parameters) they follow from the distances of the points.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), Box<dyn core::error::Error>> {
/// use basis_runtime::bspline::KnotVector;
/// use basis_runtime::{Basis, BernsteinBasis, Fit, FitEnd, ParametricCurve};
///
/// let points: Vec<[f64; 2]> = (0..=20).map(|i| f64::from(i) / 20.0 * 1.5).map(|a| [a.cos(), a.sin()]).collect();
///
/// // A cubic Bézier curve for an arc, with the ends and the directions that it should have.
/// let ends = [FitEnd::Tangent([0.0, 1.0]), FitEnd::Tangent([-1.5_f64.sin(), 1.5_f64.cos()])];
/// let arc = Fit::new(&points).ends(ends).orthogonal(20).curve(BernsteinBasis::<f64, 4>::default())?;
/// assert!(arc.largest < 3e-4 && arc.curve.start() == points[0]);
///
/// // A family with a shape parameter, which is found: -3 <= λ <= 1.
/// let given = basis_runtime::Curve::new(QuarticBernstein::new(-0.75)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
/// let points: Vec<[f64; 2]> = given.samples(30).collect();
/// let t: Vec<f64> = (0..30).map(|i| f64::from(i) / 29.0).collect();
/// let found = Fit::new(&points).parameters(&t).curve_over([[-3.0, 1.0]], |[λ]| QuarticBernstein::new(λ))?;
/// assert!((found.curve.basis().lambda() + 0.75).abs() < 1e-9);
///
/// // As few knots as a tolerance needs.
/// let wave: Vec<[f64; 2]> = (0..200).map(|i| f64::from(i) / 20.0).map(|x| [x, x.sin()]).collect();
/// let spline = Fit::new(&wave).spline_within(3, 1e-3)?;
/// assert!(spline.largest <= 1e-3 && spline.curve.control_points().len() < 25);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Fit<'a, P: Point> {
    points: &'a [P],
    parameters: Option<&'a [P::Scalar]>,
    weights: Option<&'a [P::Scalar]>,
    spacing: Spacing,
    ends: [FitEnd<P>; 2],
    smoothing: P::Scalar,
    rounds: usize,
    moving: bool,
}

/// The rounds in which shape values are improved where the parameters stay.
const SHAPE_ROUNDS: usize = 50;

/// What was found, in the scalar type of the points.
struct Found<P: Point> {
    control: Vec<P>,
    parameters: Vec<P::Scalar>,
    largest: P::Scalar,
    root_mean_square: P::Scalar,
    rounds: usize,
}

impl<'a, P: Point> Fit<'a, P> {
    /// Points in the order of the curve, with parameters from the lengths of the chords between them, free ends and nothing
    /// else.
    pub fn new(points: &'a [P]) -> Self {
        Self {
            points,
            parameters: None,
            weights: None,
            spacing: Spacing::Chord,
            ends: [FitEnd::Free; 2],
            smoothing: P::Scalar::ZERO,
            rounds: 0,
            moving: false,
        }
    }

    /// With these parameters, one for each point, in the domain of the curve. They may have any order, and repeat.
    #[must_use]
    pub fn parameters(mut self, parameters: &'a [P::Scalar]) -> Self {
        self.parameters = Some(parameters);
        self
    }

    /// With parameters from the distances of the points by another rule than [`Spacing::Chord`]. Neighbours that coincide
    /// have one parameter.
    #[must_use]
    pub fn spacing(mut self, spacing: Spacing) -> Self {
        self.spacing = spacing;
        self
    }

    /// With a weight for each distance; 0 leaves a point out.
    #[must_use]
    pub fn weights(mut self, weights: &'a [P::Scalar]) -> Self {
        self.weights = Some(weights);
        self
    }

    /// With these demands on the start and the end of the curve.
    #[must_use]
    pub fn ends(mut self, ends: [FitEnd<P>; 2]) -> Self {
        self.ends = ends;
        self
    }

    /// With λ > 0 times the integral of the squared second derivative: the larger, the straighter the curve.
    ///
    /// The integral is exact for B-splines and polynomial families, and that of a Gauss rule on each span for others. For
    /// numbers `y[i]` at parameters `x[i]`, over the knots `x[i]` and with degree 3, the result is the smoothing spline of
    /// scipy's `make_smoothing_spline(x, y, w, lam=λ)`, whose weights are the squares of these.
    #[must_use]
    pub fn smoothing(mut self, factor: P::Scalar) -> Self {
        self.smoothing = factor;
        self
    }

    /// With parameters that move to the nearest points of the curve, in up to that many rounds: it minimises the distances
    /// from the curve, by Gauss and Newton's method, and ends earlier when nothing changes. No round makes the sum larger.
    /// Points at the ends of the domain keep their parameters. A local minimum next to the fit for the first parameters is
    /// found.
    #[must_use]
    pub fn orthogonal(mut self, rounds: usize) -> Self {
        self.rounds = rounds;
        self.moving = rounds > 0;
        self
    }

    /// The curve over a family, also a Bézier curve: over [`BernsteinBasis`](crate::BernsteinBasis).
    ///
    /// # Errors
    /// [`FitError`]: numbers that are not finite, parameters outside of the domain, too few points, ends that the family
    /// cannot have.
    pub fn curve<B: Basis<Scalar = P::Scalar>>(&self, basis: B) -> Result<Fitted<Curve<B, P>>, FitError> {
        self.curve_over([], |[]| Ok(basis))
    }

    /// The curve over a family with shape values that are unknowns too, each in the range with that index: the family that
    /// fits best, looked for from many places of the ranges. Where `family` gives an error, which may be in a part of the
    /// ranges, there is none.
    ///
    /// # Errors
    /// As [`curve`](Self::curve); [`FitError::Range`] and [`FitError::Shapes`].
    pub fn curve_over<B: Basis<Scalar = P::Scalar>, const N: usize>(
        &self,
        ranges: [[P::Scalar; 2]; N],
        family: impl FnMut([P::Scalar; N]) -> Result<B, ShapeError>,
    ) -> Result<Fitted<Curve<B, P>>, FitError> {
        let (basis, found) = self.over(ranges, family, |basis| Box::new(Polynomial(basis)))?;
        let points = B::Points::from_fn(|i| found.control[i]);
        Ok(found.with(Curve::new(basis, points)))
    }

    /// The curve over a family with denominators, angles or exponentials.
    ///
    /// # Errors
    /// As [`curve`](Self::curve).
    pub fn rational<B: RationalBasis<Scalar = P::Scalar>>(
        &self,
        basis: B,
    ) -> Result<Fitted<RationalCurve<B, P>>, FitError> {
        self.rational_over([], |[]| Ok(basis))
    }

    /// The curve over such a family with shape values that are unknowns, as in [`curve_over`](Self::curve_over); weights of
    /// rational Bézier curves are shape values.
    ///
    /// # Errors
    /// As [`curve_over`](Self::curve_over).
    pub fn rational_over<B: RationalBasis<Scalar = P::Scalar>, const N: usize>(
        &self,
        ranges: [[P::Scalar; 2]; N],
        family: impl FnMut([P::Scalar; N]) -> Result<B, ShapeError>,
    ) -> Result<Fitted<RationalCurve<B, P>>, FitError> {
        let (basis, found) = self.over(ranges, family, |basis| Box::new(Rational(basis)))?;
        let points = B::Points::from_fn(|i| found.control[i]);
        Ok(found.with(RationalCurve::new(basis, points)))
    }

    /// The curve over a family on several spans.
    ///
    /// # Errors
    /// As [`curve`](Self::curve).
    pub fn spanned<B: SpannedBasis<Scalar = P::Scalar>>(
        &self,
        basis: B,
    ) -> Result<Fitted<SpannedCurve<B, P>>, FitError> {
        self.spanned_over([], |[]| Ok(basis))
    }

    /// The curve over such a family with shape values that are unknowns, as in [`curve_over`](Self::curve_over); lengths of
    /// spans may be among them.
    ///
    /// # Errors
    /// As [`curve_over`](Self::curve_over).
    pub fn spanned_over<B: SpannedBasis<Scalar = P::Scalar>, const N: usize>(
        &self,
        ranges: [[P::Scalar; 2]; N],
        family: impl FnMut([P::Scalar; N]) -> Result<B, ShapeError>,
    ) -> Result<Fitted<SpannedCurve<B, P>>, FitError> {
        let (basis, found) = self.over(ranges, family, |basis| Box::new(Spanned(basis)))?;
        let points = B::Points::from_fn(|i| found.control[i]);
        Ok(found.with(SpannedCurve::new(basis, points)))
    }

    /// The B-spline curve over these knots.
    ///
    /// # Errors
    /// As [`curve`](Self::curve); [`FitError::Undetermined`] if too few parameters are in the support of a basis function.
    pub fn spline(&self, knots: KnotVector<P::Scalar>) -> Result<Fitted<BSplineCurve<P>>, FitError> {
        let data = Data::new(self.points, 1, self.weights)?;
        let ends = self.ends_of(&data)?;
        let exact = knots.to_f64();
        let t = self.parameters_in(&data, Some(exact.domain()))?;
        let over = self.over_knots(&data, &ends, exact, &t)?;
        self.spline_of(&data, &over, knots)
    }

    /// The clamped B-spline curve of that degree with that number of control points; the knots follow the parameters, so that
    /// each span holds some (L. Piegl, W. Tiller, *The NURBS Book*, 1997, section 9.4.1). Its domain is `0 <= t <= 1`, or
    /// reaches from the smallest to the largest of the given parameters.
    ///
    /// # Errors
    /// As [`spline`](Self::spline); [`FitError::TooFewFunctions`] for fewer control points than the degree and one,
    /// [`FitError::TooFew`] for fewer points than control points.
    pub fn spline_with(&self, degree: usize, count: usize) -> Result<Fitted<BSplineCurve<P>>, FitError> {
        let data = Data::new(self.points, 1, self.weights)?;
        let ends = self.ends_of(&data)?;
        let t = self.parameters_in(&data, None)?;
        let knots = KnotVector::clamped(degree, &knots::averaged(degree, count, &t)?)?;
        let over = self.over_knots(&data, &ends, knots, &t)?;
        let knots = scalar_knots(&over.knots)?;
        self.spline_of(&data, &over, knots)
    }

    /// The clamped B-spline curve of that degree from which no point is farther than the tolerance, with few knots: they are
    /// inserted where the error is, until it is small enough, and those that are not needed are removed.
    ///
    /// The domain is that of [`spline_with`](Self::spline_with).
    ///
    /// # Errors
    /// As [`spline_with`](Self::spline_with); [`FitError::Tolerance`] if the tolerance is not positive and finite,
    /// [`FitError::NotReached`] if no curve of that degree comes as near, which is so with different points at one parameter,
    /// with smoothing, or with directions at the ends.
    pub fn spline_within(
        &self,
        degree: usize,
        tolerance: P::Scalar,
    ) -> Result<Fitted<BSplineCurve<P>>, FitError> {
        check_tolerance(tolerance)?;
        let data = Data::new(self.points, 1, self.weights)?;
        let ends = self.ends_of(&data)?;
        let t = self.parameters_in(&data, None)?;
        let wanted = tolerance.to_f64() / data.unit;
        let mut fit = |knots: KnotVector<f64>, t: &[f64]| self.over_knots(&data, &ends, knots, t);
        let over = knots::within(degree, &t, wanted, self.rounds, &mut fit)
            .map_err(|error| in_unit(error, data.unit))?;
        let knots = scalar_knots(&over.knots)?;
        self.spline_of(&data, &over, knots)
    }

    /// The path of cubic segments from which no point is farther than the tolerance, with the given points as corners: those at
    /// which the polygon of the points turns by more than `corner`, an angle in radians, also for drawing what was traced.
    ///
    /// Between corners it is a cubic B-spline as by [`spline_within`](Self::spline_within), so that its curvature is continuous
    /// there. The first and the last point are its ends. With two points between corners it is a straight line.
    ///
    /// Only the given points are near the path. Where what lies between them counts, as on a polygon or a path of many
    /// segments, there is [`Path::simplified`].
    ///
    /// ```
    /// use basis_runtime::{Fit, ParametricCurve, to_svg};
    ///
    /// // Up a straight line, and down a parabola.
    /// let up = (0..10).map(|i| [f64::from(i) / 10.0, f64::from(i) / 5.0]);
    /// let down = (0..=20).map(|i| f64::from(i) / 20.0).map(|x| [1.0 + x, 2.0 - 2.0 * x * x]);
    /// let points: Vec<[f64; 2]> = up.chain(down).collect();
    /// let path = Fit::new(&points).path_within(1e-3, 0.8)?.curve;
    /// assert!(path.start() == [0.0, 0.0] && path.end() == [2.0, 0.0] && path.segments().len() < 6);
    /// assert!(to_svg(&path, 1e-6)?.starts_with('M'));
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`spline_within`](Self::spline_within), and [`FitError::Corner`] if `corner` is negative or NaN; from π on there are
    /// no corners. Parameters that were given are not used.
    pub fn path_within(&self, tolerance: P::Scalar, corner: P::Scalar) -> Result<Fitted<Path<P>>, FitError> {
        check_tolerance(tolerance)?;
        if corner.is_nan() || corner < P::Scalar::ZERO {
            return Err(FitError::Corner { value: corner.to_f64() });
        }
        let data = Data::new(self.points, 1, self.weights)?;
        self.ends_of(&data)?;
        let mut segments: Vec<PathSegment<P>> = Vec::new();
        let mut parameters = Vec::new();
        let (mut largest, mut squares, mut rounds) = (P::Scalar::ZERO, P::Scalar::ZERO, 0);
        let corners = corners(&data, corner.to_f64());
        for (k, range) in corners.windows(2).enumerate() {
            let [from, to] = [range[0], range[1]];
            let points = &self.points[from..=to];
            let mut ends = self.ends;
            for (e, inner) in [k > 0, k + 2 < corners.len()].into_iter().enumerate() {
                if inner || ends[e] == FitEnd::Free {
                    ends[e] = FitEnd::Interpolated;
                }
            }
            let weights = self.weights.map(|weights| &weights[from..=to]);
            let fit = Self { points, parameters: None, weights, ends, ..self.clone() };
            let different = 1 + points.windows(2).filter(|pair| pair[0] != pair[1]).count();
            let found = fit.spline_within(different.saturating_sub(1).clamp(1, 3), tolerance)?;
            let before = P::Scalar::from_usize(segments.len());
            let breakpoints = found.curve.knots().breakpoints();
            for (i, &t) in found.parameters.iter().enumerate() {
                let span = breakpoints[1..breakpoints.len() - 1].partition_point(|&b| b <= t);
                let x = crate::domain::unit([breakpoints[span], breakpoints[span + 1]], t)[1];
                if i > 0 || k == 0 {
                    parameters.push(before + P::Scalar::from_usize(span) + x);
                }
            }
            segments.extend(Path::from_curve(&found.curve).segments().iter().cloned());
            largest = largest.max(found.largest);
            let mean = found.root_mean_square;
            squares = squares + mean * mean * P::Scalar::from_usize(points.len());
            rounds = rounds.max(found.rounds);
        }
        let curve = Path::new(segments).map_err(|_| FitError::TooFew { needed: 2, found: data.len() })?;
        let root_mean_square = (squares / P::Scalar::from_usize(data.len())).sqrt();
        Ok(Fitted { curve, parameters, largest, root_mean_square, rounds })
    }

    fn spline_of(
        &self,
        data: &Data,
        over: &Over,
        knots: KnotVector<P::Scalar>,
    ) -> Result<Fitted<BSplineCurve<P>>, FitError> {
        let space = Space::new(&over.knots, 0.0);
        let found = self.found(data, &space, &over.control, &over.t, over.rounds);
        let curve = BSplineCurve::new(knots, found.control.clone()).map_err(|_| FitError::Functions {
            functions: over.knots.functions(),
            points: found.control.len(),
        })?;
        Ok(found.with(curve))
    }

    /// The best control points over knots, in the unit of the data.
    fn over_knots(
        &self,
        data: &Data,
        ends: &[End; 2],
        knots: KnotVector<f64>,
        t: &[f64],
    ) -> Result<Over, FitError> {
        let smoothing = data.smoothing(self.smoothing.to_f64())?;
        self.enough(data, ends, knots.functions())?;
        let search = self.search(data, ends, smoothing, &[], knots.domain());
        let make = knots.clone();
        let (State { control, t, .. }, rounds) =
            search.run(&mut |_| Some(Box::new(make.clone()) as Box<dyn Functions>), t)?;
        let space = Space::new(&knots, 0.0);
        if !search.problem.ends_are_met(&space, &control) {
            return Err(FitError::Ends);
        }
        let squares = search.problem.squares(&space, &control, &t);
        let errors = squares.into_iter().map(Scalar::sqrt).collect();
        Ok(Over { knots, control, t, errors, rounds })
    }

    fn search<'s>(
        &self,
        data: &'s Data,
        ends: &'s [End; 2],
        smoothing: f64,
        ranges: &'s [[f64; 2]],
        domain: [f64; 2],
    ) -> Search<'s> {
        let rounds = if self.moving { self.rounds } else { SHAPE_ROUNDS };
        let given = self.parameters.is_some();
        let problem = Problem { data, ends };
        Search { problem, smoothing, ranges, rounds, moving: self.moving, domain, given }
    }

    /// The family that fits best, and the curve over it.
    fn over<'f, B: 'f + Copy, const N: usize>(
        &self,
        ranges: [[P::Scalar; 2]; N],
        mut family: impl FnMut([P::Scalar; N]) -> Result<B, ShapeError>,
        functions: fn(B) -> Box<dyn Functions + 'f>,
    ) -> Result<(B, Found<P>), FitError> {
        let data = Data::new(self.points, 1, self.weights)?;
        let smoothing = data.smoothing(self.smoothing.to_f64())?;
        let ends = self.ends_of(&data)?;
        let ranges = ranges.map(|range| range.map(Scalar::to_f64));
        check_ranges(&ranges)?;
        let mut of = |shapes: &[f64]| {
            let shapes = core::array::from_fn(|k| P::Scalar::of(shapes[k]));
            family(shapes).ok()
        };
        // Where the domain depends on the shape values, parameters keep their place in it.
        let first = orthogonal::grid(&ranges).iter().find_map(|shapes| of(shapes));
        let first = functions(first.ok_or(FitError::Shapes)?);
        let domain = ends_of_domain(&*first);
        if !domain.iter().all(|end| end.is_finite()) {
            return Err(FitError::Domain);
        }
        self.enough(&data, &ends, first.count())?;
        // Of a domain that depends on shape values, those are left out with which a parameter is outside.
        let t = self.parameters_in(&data, (N == 0 || self.parameters.is_none()).then_some(domain))?;
        let search = self.search(&data, &ends, smoothing, &ranges, domain);
        let (state, rounds) = search.run(&mut |shapes| of(shapes).map(functions), &t)?;
        let basis = of(&state.shapes).ok_or(FitError::Shapes)?;
        let best = functions(basis);
        let space = Space::new(&*best, 0.0);
        if !search.problem.ends_are_met(&space, &state.control) {
            return Err(FitError::Ends);
        }
        Ok((basis, self.found(&data, &space, &state.control, &state.t, rounds)))
    }

    /// The answer in the scalar type and the unit of the points.
    fn found(&self, data: &Data, space: &Space<'_>, control: &[f64], t: &[f64], rounds: usize) -> Found<P> {
        let point =
            |p: &[f64]| P::from_components(|d| P::Scalar::of(p.get(d).copied().unwrap_or(0.0) * data.unit));
        let mut points: Vec<P> = match P::DIM {
            0 => alloc::vec![P::zero(); space.functions.count()],
            dim => control.chunks_exact(dim).map(point).collect(),
        };
        let given = [self.points.first(), self.points.last()];
        for ((end, given), rows) in self.ends.iter().zip(given).zip(&space.ends) {
            // A control point that is an end is the point to the last bit.
            let (first, row) = &rows[0];
            let mut other = row.iter().enumerate().filter(|(_, b)| **b != 0.0);
            if *end != FitEnd::Free
                && let (Some((j, &1.0)), None, Some(&given)) = (other.next(), other.next(), given)
            {
                points[first + j] = given;
            }
        }
        let problem = Problem { data, ends: &[End::Free, End::Free] };
        let squares = problem.squares(space, control, t);
        let largest = squares.iter().fold(0.0_f64, |a, &b| a.max(b));
        let mean = squares.iter().sum::<f64>() / squares.len().max(1) as f64;
        let length = |square: f64| P::Scalar::of(Scalar::sqrt(square) * data.unit);
        Found {
            control: points,
            parameters: t.iter().map(|&t| P::Scalar::of(t)).collect(),
            largest: length(largest),
            root_mean_square: length(mean),
            rounds,
        }
    }

    /// Whether there are as many conditions as unknowns, and not more demands than unknowns.
    fn enough(&self, data: &Data, ends: &[End; 2], functions: usize) -> Result<(), FitError> {
        let demands = |end: &End| usize::from(end.point().is_some()) + usize::from(end.tangent().is_some());
        let demanded = demands(&ends[0]) + demands(&ends[1]);
        if demanded > functions {
            return Err(FitError::Ends);
        }
        let known = data.len() + ends.iter().filter(|end| end.tangent().is_some()).count();
        if known < functions && self.smoothing <= P::Scalar::ZERO {
            return Err(FitError::TooFew { needed: functions - (known - data.len()), found: data.len() });
        }
        Ok(())
    }

    /// The demands on the ends, in the unit of the data.
    fn ends_of(&self, data: &Data) -> Result<[End; 2], FitError> {
        if data.len() < 2 {
            return Err(FitError::TooFew { needed: 2, found: data.len() });
        }
        let mut ends = [End::Free, End::Free];
        for (e, i) in [0, data.len() - 1].into_iter().enumerate() {
            let point = data.point(i).to_vec();
            ends[e] = match self.ends[e] {
                FitEnd::Free => End::Free,
                FitEnd::Interpolated => End::Point(point),
                FitEnd::Tangent(tangent) => End::Tangent(point, unit_of::<P>(tangent, e)?),
            };
        }
        Ok(ends)
    }

    /// The parameters that were given, or those that follow from the points, in the domain.
    fn parameters_in(&self, data: &Data, domain: Option<[f64; 2]>) -> Result<Vec<f64>, FitError> {
        let Some(given) = self.parameters else {
            let [lo, hi] = domain.unwrap_or([0.0, 1.0]);
            let unit = spaced(data, self.spacing)?;
            return Ok(unit.into_iter().map(|x| crate::domain::from_unit([lo, hi], x)).collect());
        };
        if given.len() != data.len() {
            return Err(FitError::Count { expected: data.len(), found: given.len() });
        }
        let given: Vec<f64> = given.iter().map(|t| t.to_f64()).collect();
        if let Some(index) = given.iter().position(|t| !t.is_finite()) {
            return Err(FitError::NotFinite { index });
        }
        if let Some(domain @ [lo, hi]) = domain
            && let Some(index) = given.iter().position(|&t| t < lo || t > hi)
        {
            return Err(FitError::Outside { index, parameter: given[index], domain });
        }
        Ok(given)
    }
}

impl<P: Point> Found<P> {
    fn with<C: ParametricCurve<Point = P>>(self, curve: C) -> Fitted<C> {
        let Self { parameters, largest, root_mean_square, rounds, .. } = self;
        Fitted { curve, parameters, largest, root_mean_square, rounds }
    }
}

fn check_tolerance<S: Scalar>(tolerance: S) -> Result<(), FitError> {
    if tolerance > S::ZERO && tolerance.is_finite() {
        Ok(())
    } else {
        Err(FitError::Tolerance { value: tolerance.to_f64() })
    }
}

/// The direction at an end, of length 1 in double precision too, whatever the scalar type is.
fn unit_of<P: Point>(tangent: P::Vector, end: usize) -> Result<Vec<f64>, FitError> {
    let unit = direction(tangent).ok_or(FitError::Tangent { end })?;
    let unit: Vec<f64> = (0..P::DIM).map(|d| unit.component(d).to_f64()).collect();
    let length = Scalar::sqrt(dot(&unit, &unit));
    Ok(unit.into_iter().map(|x| x / length).collect())
}

fn check_ranges(ranges: &[[f64; 2]]) -> Result<(), FitError> {
    match ranges.iter().position(|[lo, hi]| !(lo < hi && (hi - lo).is_finite())) {
        Some(index) => Err(FitError::Range { index, range: ranges[index] }),
        None => Ok(()),
    }
}

/// An error about lengths that were measured in that unit.
fn in_unit(error: FitError, unit: f64) -> FitError {
    match error {
        FitError::NotReached { tolerance, reached } => {
            FitError::NotReached { tolerance: tolerance * unit, reached: reached * unit }
        }
        other => other,
    }
}

/// The knots in another scalar type.
fn scalar_knots<S: Scalar>(knots: &KnotVector<f64>) -> Result<KnotVector<S>, FitError> {
    let all: Vec<S> = knots.as_slice().iter().map(|&t| S::of(t)).collect();
    Ok(KnotVector::new(knots.degree(), all)?)
}
