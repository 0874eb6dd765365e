//! Every question has the answer of brute force, whichever type of curve is asked.

use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::Range;

use basis_runtime::bspline::{BSplineCurve, KnotVector, NurbsCurve};
use basis_runtime::{Bezier, CurveError, CurvePiece, ParametricCurve, Path, PiecewiseCurve, Point};

use crate::random::Random;

type P2 = [f64; 2];
type P3 = [f64; 3];

/// A curve of which nothing is known but what the trait asks for, so that every answer is the trait's own.
#[derive(Clone)]
pub struct Plain<C>(pub C);

impl<C: ParametricCurve> ParametricCurve for Plain<C> {
    type Point = C::Point;
    type Part = C::Part;

    fn domain(&self) -> [<C::Point as Point>::Scalar; 2] {
        self.0.domain()
    }

    fn eval(&self, t: <C::Point as Point>::Scalar) -> C::Point {
        self.0.eval(t)
    }

    fn derivatives_into(
        &self,
        t: <C::Point as Point>::Scalar,
        derivatives: &mut [<C::Point as Point>::Vector],
    ) {
        self.0.derivatives_into(t, derivatives);
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.0.pieces()
    }

    fn split(&self, t: <C::Point as Point>::Scalar) -> Result<[C::Part; 2], CurveError> {
        self.0.split(t)
    }

    fn subsegment(&self, range: Range<<C::Point as Point>::Scalar>) -> Result<C::Part, CurveError> {
        self.0.subsegment(range)
    }

    fn reversed(&self) -> C::Part {
        self.0.reversed()
    }
}

pub fn distance<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|d| (a[d] - b[d]).powi(2)).sum::<f64>().sqrt()
}

fn random_points<const D: usize>(random: &mut Random, count: usize) -> Vec<[f64; D]> {
    (0..count).map(|_| [(); D].map(|()| random.between(-1.0, 1.0))).collect()
}

/// A cubic spline with a double knot, uneven spans and a domain that does not begin at 0.
pub fn spline<const D: usize>(random: &mut Random) -> BSplineCurve<[f64; D]> {
    let knots = KnotVector::clamped(3, &[-1.0, 0.5, 1.0, 1.0, 3.0, 3.25]).unwrap();
    BSplineCurve::new(knots.clone(), random_points(random, knots.functions())).unwrap()
}

pub fn nurbs<const D: usize>(random: &mut Random) -> NurbsCurve<[f64; D]> {
    let knots = KnotVector::clamped(3, &[0.0, 0.5, 2.0, 3.0]).unwrap();
    let weights: Vec<f64> = (0..knots.functions()).map(|_| random.between(0.3, 3.0)).collect();
    NurbsCurve::new(knots.clone(), random_points(random, knots.functions()), weights).unwrap()
}

/// The unit circle over `0 <= t <= 4`, a quarter for each unit.
pub fn circle() -> NurbsCurve<P2> {
    let half = 0.5_f64.sqrt();
    let points = [
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [-1.0, 1.0],
        [-1.0, 0.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
        [1.0, 0.0],
    ];
    let weights = [1.0, half, 1.0, half, 1.0, half, 1.0, half, 1.0];
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]).unwrap();
    NurbsCurve::new(knots, points, weights).unwrap()
}

/// All questions of length, extent and distance, against many samples.
pub fn against_samples<const D: usize>(curve: &impl ParametricCurve<Point = [f64; D]>, random: &mut Random) {
    const COUNT: usize = 20_001;
    let [lo, hi] = curve.domain();
    let at = |i: usize| lo + (hi - lo) * i as f64 / (COUNT - 1) as f64;
    let samples: Vec<[f64; D]> = curve.samples(COUNT).collect();
    assert_eq!([samples[0], samples[COUNT - 1]], [curve.start(), curve.end()]);

    let chords: f64 = samples.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
    let length = curve.arclen(1e-10);
    assert!((length - chords).abs() < 1e-5 * length, "{length} {chords}");
    assert!((curve.arclen(1e-4) - length).abs() <= 1.1e-4);
    let lengths: f64 = [0.2, 0.55].iter().fold(0.0, |sum, x| sum + x * length);
    let middle = curve.inv_arclen(lengths - 0.2 * length, 1e-10);
    let [before, after] = curve.split(middle).unwrap();
    assert!((before.arclen(1e-10) - 0.55 * length).abs() < 1e-8);
    assert!((before.arclen(1e-10) + after.arclen(1e-10) - length).abs() < 1e-9);
    let parameters = curve.arclen_parameters(6, 1e-10);
    for pair in parameters.windows(2) {
        assert!((curve.subsegment(pair[0]..pair[1]).unwrap().arclen(1e-11) - 0.2 * length).abs() < 1e-8);
    }
    assert_eq!(curve.samples_by_arclen(6, 1e-10)[5], curve.end());
    assert_eq!((curve.inv_arclen(-1.0, 1e-9), curve.inv_arclen(1e9, 1e-9)), (lo, hi));
    assert!(curve.inv_arclen(f64::NAN, 1e-9).is_nan());

    let [low, high] = curve.bounding_box();
    let [far_low, far_high] = curve.control_box();
    for d in 0..D {
        let values = || samples.iter().map(|p| p[d]);
        let (least, largest) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
        assert!(low[d] <= least + 1e-13 && low[d] > least - 1e-5, "{d}: {low:?} {least}");
        assert!(high[d] >= largest - 1e-13 && high[d] < largest + 1e-5, "{d}: {high:?} {largest}");
        assert!(far_low[d] <= low[d] && far_high[d] >= high[d]);
    }
    // Between extrema every component is monotone, and at each some component turns.
    let mut ends = vec![lo];
    ends.extend(curve.extrema());
    ends.push(hi);
    assert!(ends.is_sorted());
    for pair in ends.windows(2) {
        let inside: Vec<_> =
            (0..=40).map(|i| curve.eval(pair[0] + (pair[1] - pair[0]) * f64::from(i) / 40.0)).collect();
        for d in 0..D {
            let steps = || inside.windows(2).map(|p| p[1][d] - p[0][d]);
            assert!(steps().all(|s| s > -1e-12) || steps().all(|s| s < 1e-12), "{pair:?} {d}");
        }
    }

    for _ in 0..5 {
        let target = [(); D].map(|()| random.between(-1.5, 1.5));
        let found = curve.nearest(target, 1e-9).unwrap();
        let sampled = samples.iter().map(|&p| distance(p, target)).fold(f64::MAX, f64::min);
        assert!(distance(found.point, curve.eval(found.at)) < 1e-14);
        assert!((distance(found.point, target) - found.distance).abs() < 1e-14);
        assert!(found.distance <= sampled + 1e-9 && found.at_least <= sampled, "{found:?} {sampled}");
        assert!(found.distance - found.at_least <= 1.01e-9, "{found:?}");
    }

    for tolerance in [0.1, 1e-3] {
        let corners = curve.flatten(tolerance).unwrap();
        assert_eq!([corners[0], corners[corners.len() - 1]], [curve.start(), curve.end()]);
        assert!(corners.len() < 200);
        for &p in samples.iter().step_by(50) {
            let off = corners.windows(2).map(|c| to_segment(p, c[0], c[1])).fold(f64::MAX, f64::min);
            assert!(off <= tolerance, "{off} > {tolerance}");
        }
        for c in corners.windows(2) {
            let between = core::array::from_fn(|d| 0.6 * c[0][d] + 0.4 * c[1][d]);
            assert!(curve.nearest(between, 1e-9).unwrap().distance <= tolerance + 1e-9);
        }
    }
    assert!(matches!(curve.flatten(0.0), Err(CurveError::Tolerance { .. })));

    // Derivatives and what is made of them.
    for i in [137, 4_321, 11_111, 19_000] {
        let (t, h) = (at(i), 1e-5 * (hi - lo));
        let difference: [f64; D] =
            core::array::from_fn(|d| (curve.eval(t + h)[d] - curve.eval(t - h)[d]) / (2.0 * h));
        let velocity = curve.derivative(t, 1);
        let speed = distance(velocity, [0.0; D]);
        assert!(distance(difference, velocity) < 1e-5 * (1.0 + speed));
        let tangent = curve.tangent(t).unwrap();
        assert!(distance(tangent, velocity.map(|v| v / speed)) < 1e-12);
        let [_, first, second] = curve.eval_with_derivs(t);
        assert!(distance(first, velocity) < 1e-12 && distance(second, curve.derivative(t, 2)) < 1e-11);
        let (dot, square) = (inner(first, second), inner(second, second));
        let bend = (speed * speed * square - dot * dot).max(0.0).sqrt() / speed.powi(3);
        assert!((curve.curvature(t).abs() - bend).abs() < 1e-8 * (1.0 + bend));
    }
    let back = curve.reversed();
    let [from, to] = back.domain();
    assert!(distance(back.eval(from + 0.3 * (to - from)), curve.eval(hi - 0.3 * (hi - lo))) < 1e-13);
    assert!(matches!(curve.split(lo), Err(CurveError::AtEnd { .. })));
    assert!(matches!(curve.split(hi + 1.0), Err(CurveError::Parameter { .. })));
    assert!(matches!(curve.split(f64::NAN), Err(CurveError::Parameter { .. })));
    assert!(matches!(curve.subsegment(lo..hi + 1.0), Err(CurveError::Parameter { .. })));
    assert!(matches!(curve.subsegment(lo..lo), Err(CurveError::EmptyRange { .. })));
    let part = curve.subsegment(at(9_000)..at(3_000)).unwrap();
    let ends = [part.start(), part.end()];
    assert!(distance(ends[0], samples[9_000]) < 1e-12 && distance(ends[1], samples[3_000]) < 1e-12);
    assert!(matches!(curve.eval_checked(hi + 1.0), Err(CurveError::Parameter { .. })));
    assert_eq!(curve.eval_clamped(hi + 1.0), curve.end());
}

fn inner<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|d| a[d] * b[d]).sum()
}

fn to_segment<const D: usize>(p: [f64; D], a: [f64; D], b: [f64; D]) -> f64 {
    let chord: [f64; D] = core::array::from_fn(|d| b[d] - a[d]);
    let arm: [f64; D] = core::array::from_fn(|d| p[d] - a[d]);
    let x = (inner(arm, chord) / inner(chord, chord).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    distance(p, core::array::from_fn(|d| a[d] + x * chord[d]))
}

#[test]
fn of_splines() {
    let random = &mut Random::new(1701);
    for _ in 0..3 {
        against_samples(&spline::<2>(random), random);
        against_samples(&spline::<3>(random), random);
        against_samples(&nurbs::<2>(random), random);
        against_samples(&nurbs::<3>(random), random);
    }
}

#[test]
fn of_curves_over_families() {
    let random = &mut Random::new(1702);
    for _ in 0..3 {
        let segment =
            |random: &mut Random| Bezier::<P2, 4>::from_points(random_points(random, 4).try_into().unwrap());
        let first = segment(random);
        let mut points = segment(random).control_points().to_vec();
        points[0] = first.end();
        let second = Bezier::from_points(points.try_into().unwrap());
        let piecewise = PiecewiseCurve::new(vec![first, second]).unwrap();
        against_samples(&first, random);
        against_samples(&Plain(first), random);
        against_samples(&piecewise, random);
        against_samples(&Plain(piecewise), random);
        let in_space = Bezier::<P3, 6>::from_points(random_points(random, 6).try_into().unwrap());
        against_samples(&in_space, random);
        against_samples(&Plain(in_space), random);
    }
}

#[test]
fn of_a_circle() {
    let circle = circle();
    against_samples(&circle.split(3.999).unwrap()[0], &mut Random::new(1703));
    assert!((circle.arclen(1e-13) - 2.0 * PI).abs() < 1e-13);
    assert!((circle.inv_arclen(FRAC_PI_2, 1e-13) - 1.0).abs() < 1e-12);
    let [low, high] = circle.bounding_box();
    assert!(distance(low, [-1.0; 2]) < 1e-15 && distance(high, [1.0; 2]) < 1e-15);
    assert_eq!(circle.extrema().len(), 3); // not the start and the end
    assert_eq!(circle.inflections().unwrap(), [0.0; 0]);
    for t in [0.0, 0.3, 1.0, 2.6, 4.0] {
        assert!((circle.curvature(t) - 1.0).abs() < 1e-12);
        let ([x, y], tangent) = (circle.eval(t), circle.tangent(t).unwrap());
        assert!(distance(tangent, [-y, x]) < 1e-12);
    }
    let found = circle.nearest([0.3, 0.4], 1e-12).unwrap();
    assert!((found.distance - 0.5).abs() < 1e-12 && distance(found.point, [0.6, 0.8]) < 1e-6);
    // From the centre all points are equally near.
    let found = circle.nearest([0.0; 2], 1e-9).unwrap();
    assert!((found.distance - 1.0).abs() < 1e-14 && found.at_least > 1.0 - 1e-9, "{found:?}");
    // The largest distance of an arc from its chord is 1 - cos(π/n).
    let corners = circle.flatten(1e-3).unwrap().len() - 1;
    assert!((71..150).contains(&corners), "{corners}");
}

#[test]
fn inflections_of_splines() {
    let random = &mut Random::new(1704);
    let mut total = 0;
    for round in 0..30 {
        let (spline, nurbs) = (spline::<2>(random), nurbs::<2>(random));
        let curve: &dyn ParametricCurve<Point = P2> = if round % 2 == 0 { &spline } else { &nurbs };
        let [lo, hi] = curve.domain();
        let found = curve.inflections().unwrap();
        total += found.len();
        let turn = |t: f64| {
            let mut d = [[0.0; 2]; 3];
            curve.derivatives_into(t, &mut d);
            d[1][0] * d[2][1] - d[1][1] * d[2][0]
        };
        let mut sampled = 0;
        let mut last = turn(lo);
        for i in 1..=5_000 {
            let next = turn(lo + (hi - lo) * (f64::from(i) - 0.37) / 5_000.0);
            sampled += usize::from((next > 0.0) != (last > 0.0));
            last = next;
        }
        assert_eq!(found.len(), sampled, "{found:?}");
    }
    assert!(total > 30);
    assert!(matches!(spline::<3>(random).inflections(), Err(CurveError::Dimension { .. })));
}

/// Where the velocity vanishes the tangent is a limit, and at the end of the curve that of arriving.
#[test]
fn tangents_at_halts() {
    let points = [[0.0, 0.0], [0.0, 0.0], [3.0, 4.0], [5.0, 4.0], [5.0, 4.0], [5.0, 4.0]];
    let halting = BSplineCurve::new(KnotVector::uniform(3, 3).unwrap(), points).unwrap();
    assert_eq!(halting.tangent(0.0), Some([0.6, 0.8]));
    let tangent = halting.tangent(1.0).unwrap();
    assert!(distance(tangent, [1.0, 0.0]) < 1e-15, "{tangent:?}");
    let point = BSplineCurve::from_bezier([[1.0, 2.0]; 4]).unwrap();
    assert_eq!(point.tangent(0.5), None);
    assert_eq!((point.arclen(0.0), point.inv_arclen(1.0, 0.0)), (0.0, 1.0));
    assert_eq!(point.flatten(0.1).unwrap().len(), 2);
    // A cusp, from where the curve leaves downwards.
    let cusp = NurbsCurve::from(
        BSplineCurve::from_bezier([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]]).unwrap(),
    );
    let t = cusp.tangent(0.5).unwrap();
    assert!(distance(t, [0.0, -1.0]) < 1e-12, "{t:?}");
}

#[test]
fn frames_of_a_helix_like_spline() {
    let points: Vec<P3> = (0..40).map(|i| f64::from(i) * 0.3).map(|a| [a.cos(), a.sin(), 0.5 * a]).collect();
    let curve = BSplineCurve::interpolate(5, &points, basis_runtime::bspline::Spacing::Chord).unwrap();
    let [lo, hi] = curve.domain();
    let middle = 0.5 * (lo + hi);
    // r = 1, h = 1/2: κ = r / (r² + h²), τ = h / (r² + h²).
    assert!((curve.curvature(middle) - 0.8).abs() < 1e-4 && (curve.torsion(middle) - 0.4).abs() < 1e-3);
    let frame = curve.frenet_frame(middle).unwrap();
    let [x, y, _] = frame.point;
    assert!(distance(frame.normal, [-x, -y, 0.0]) < 1e-3);
    assert!((inner(frame.binormal, frame.tangent)).abs() < 1e-15);
    let frames = curve.rotation_minimizing_frames(400, None).unwrap();
    for pair in frames.windows(2) {
        // The normal turns towards the tangent only.
        let turn: P3 = core::array::from_fn(|d| pair[1].normal[d] - pair[0].normal[d]);
        assert!(inner(turn, pair[0].binormal).abs() < 1e-3); // that of Frenet's frames turns by 1e-2
    }
    assert!(matches!(
        BSplineCurve::from_bezier([[0.0, 1.0, 2.0]; 3]).unwrap().rotation_minimizing_frames(3, None),
        Err(CurveError::NoTangent)
    ));
}

#[test]
fn in_single_precision() {
    let knots = KnotVector::<f32>::clamped(2, &[0.0, 1.0, 3.0]).unwrap();
    let curve = BSplineCurve::new(knots, [[0.0_f32, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]).unwrap();
    let length = curve.arclen(1e-6);
    let points = curve.control_points().iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
    let exact = BSplineCurve::new(KnotVector::clamped(2, &[0.0, 1.0, 3.0]).unwrap(), points).unwrap();
    assert!((f64::from(length) - exact.arclen(1e-12)).abs() < 2e-6, "{length}");
    let found = curve.nearest([2.0, 9.0], 1e-4).unwrap();
    assert!(found.at_least <= found.distance && found.distance - found.at_least < 2e-4);
    assert_eq!(curve.inv_arclen(100.0, 1e-3), 3.0);
}

/// Pieces in a list of any types, and one question for all of them.
#[test]
fn of_curves_whose_type_is_not_known() {
    let random = &mut Random::new(1705);
    let curves: Vec<Box<dyn ParametricCurve<Point = P2>>> = vec![
        Box::new(circle()),
        Box::new(spline::<2>(random)),
        Box::new(Bezier::from_points([[0.0, 0.0], [1.0, 1.0]])),
    ];
    let nearest = curves.iter().filter_map(|c| c.nearest([0.5, 0.5], 1e-9)).map(|found| found.distance);
    assert!(nearest.fold(f64::MAX, f64::min) < 1e-9);
    let mut samples = [[0.0; 2]; 5];
    curves[0].samples_into(&mut samples);
    assert!(distance(samples[1], [0.0, 1.0]) < 1e-15);
}

#[test]
fn pieces_of_a_type_of_ones_own() {
    let points = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert!(CurvePiece::rational([0.0, 1.0], &points, &[1.0, 0.5_f64.sqrt(), 1.0]).is_ok());
    assert!(matches!(CurvePiece::rational([0.0, 1.0], &points, &[1.0, 1.0]), Err(CurveError::Length { .. })));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = CurvePiece::rational([0.0, 1.0], &points, &[1.0, bad, 1.0]).unwrap_err();
        assert!(matches!(refused, CurveError::Weight { index: 1, .. }));
        assert!(refused.to_string().starts_with("weight 1 is "), "{refused}");
    }
    let plain = CurvePiece::rational([0.0, 1.0], &points, &[2.0, 2.0, 2.0]).unwrap();
    assert_eq!(plain, CurvePiece::polynomial([0.0, 1.0], &points));
    assert_eq!((plain.degree(), plain.dimension(), plain.weights()), (2, 2, None));
}

/// A curve over a straight line, also within the accuracy, need not have a constant speed.
#[test]
fn lengths_along_straight_pieces() {
    // x = 4 t²
    let [path] = Path::<P2>::from_svg("M0 0Q0 0 4 0").unwrap().try_into().unwrap();
    for (point, x) in path.samples_by_arclen(5, 1e-9).iter().zip([0.0, 1.0, 2.0, 3.0, 4.0]) {
        assert!((point[0] - x).abs() <= 1e-9, "{point:?} {x}");
    }
    let single = Path::<[f32; 2]>::from_svg("M0 0Q0 0 4 0").unwrap();
    for (point, x) in single[0].samples_by_arclen(5, 1e-6).iter().zip([0.0, 1.0, 2.0, 3.0, 4.0]) {
        assert!((point[0] - x).abs() <= 4e-6, "{point:?} {x}");
    }
    let slow = BSplineCurve::from_bezier([[0.0, 0.0], [0.1, 0.0], [0.2, 0.0], [5.0, 0.0]]).unwrap();
    let rational = NurbsCurve::new(slow.knots().clone(), slow.control_points(), [1.0, 3.0, 0.5, 2.0]);
    let rational = rational.unwrap();
    for length in [0.0_f64, 1e-3, 0.3, 1.0, 4.9, 5.0] {
        assert!((slow.eval(slow.inv_arclen(length, 1e-9))[0] - length).abs() <= 1e-9);
        assert!((rational.eval(rational.inv_arclen(length, 1e-9))[0] - length).abs() <= 1e-9);
    }
    // There and back, x = 2 t (1 - t).
    let back = Path::from_curve(&Bezier::from_points([[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]));
    for (length, x) in [(0.25_f64, 0.25_f64), (0.5, 0.5), (0.75, 0.25)] {
        assert!((back.eval(back.inv_arclen(length, 1e-9))[0] - x).abs() <= 1e-9);
    }
    let flat = Path::from_curve(&Bezier::from_points([[0.0, 0.0], [0.0, 1e-3], [4.0, 0.0]]));
    for accuracy in [1e-1, 1e-3, 1e-9] {
        for length in [0.5_f64, 1.0, 3.0] {
            let before = flat.subsegment(0.0..flat.inv_arclen(length, accuracy)).unwrap();
            assert!((before.arclen(1e-12) - length).abs() <= accuracy * 1.001);
        }
    }
}

/// A Bézier curve whose control points lie on a helix.
fn helix(degree: usize) -> BSplineCurve<P3> {
    let angle = |i: usize| 6.0 * i as f64 / degree as f64;
    let point = |a: f64| [a.cos(), a.sin(), a / 10.0];
    BSplineCurve::from_bezier((0..=degree).map(angle).map(point).collect::<Vec<_>>()).unwrap()
}

/// The length of the polygon with n corners has an error that falls like `1/n²`; two of them tell the limit.
fn extrapolated(curve: &impl ParametricCurve<Point = P3>) -> f64 {
    let polygon = |n: usize| {
        let corners: Vec<P3> = curve.samples(n + 1).collect();
        corners.windows(2).map(|pair| distance(pair[0], pair[1])).sum::<f64>()
    };
    (4.0 * polygon(2000) - polygon(1000)) / 3.0
}

/// Rounding errors of Chebyshev coefficients of high order are no reason to halve again and again.
#[test]
fn lengths_of_high_degree() {
    for degree in [10, 24, 43, 44, 48, 60] {
        let curve = helix(degree);
        let start = std::time::Instant::now();
        let length = curve.arclen(1e-9);
        assert!(start.elapsed().as_secs_f64() < 4.0, "{degree}: {:?}", start.elapsed());
        assert!((length - extrapolated(&curve)).abs() <= 2e-9, "{degree}: {length}");
        if degree < 30 {
            let weights: Vec<f64> = (0..=degree).map(|i| 1.0 + (i as f64 / 3.0).sin() / 2.0).collect();
            let points = curve.control_points();
            let rational = NurbsCurve::new(curve.knots().clone(), points, weights).unwrap();
            assert!((rational.arclen(1e-9) - extrapolated(&rational)).abs() <= 2e-9, "{degree}");
        }
    }
}

/// Curves of high degree keep the accuracy, too.
#[test]
fn nearest_points_of_high_degree() {
    for degree in [10, 15, 16, 20, 25, 40, 60] {
        let curve = helix(degree);
        for point in [[3.0, 1.0, 0.0], [0.0, 0.0, 0.0], [0.1, 0.2, 0.3], [0.0, 0.0, 0.3]] {
            let found = curve.nearest(point, 1e-9).unwrap();
            assert!(found.distance - found.at_least <= 1e-9, "{degree} {point:?}: {found:?}");
            assert!(curve.samples(2001).all(|p| distance(p, point) >= found.at_least));
        }
    }
}

/// Curvatures and torsions of a curve of any size are those of the same curve of size 1, in the unit of its size.
#[test]
fn curvatures_of_curves_of_any_size() {
    let shape = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [2.0, 1.5, 0.0], [1.0, 3.0, 1.0]];
    let of = |size: f64| Bezier::from_points(shape.map(|p| p.map(|x| size * x)));
    let (unit, flat) = (of(1.0), of(1.0).map(|[x, y, _]| [x, y]));
    for size in [2.0_f64.powi(996), 2.0_f64.powi(-996)] {
        let curve = of(size);
        let in_plane = curve.map(|[x, y, _]| [x, y]);
        for t in [0.0, 0.3, 1.0] {
            let close = |a: f64, b: f64| (a * size / b - 1.0).abs() < 1e-13;
            assert!(close(curve.curvature(t), unit.curvature(t)), "{}", curve.curvature(t));
            assert!(close(ParametricCurve::curvature(&curve, t), unit.curvature(t)));
            assert!(close(in_plane.curvature(t), flat.curvature(t)));
            assert!(close(curve.torsion(t), unit.torsion(t)), "{}", curve.torsion(t));
        }
        let joint = curve.joint(&of(size));
        assert!((joint.curvature * size / unit.joint(&unit).curvature - 1.0).abs() < 1e-13, "{joint:?}");
    }
}

/// Lengths and areas of finite points are numbers, or infinite where they are too large for one.
#[test]
fn lengths_and_areas_at_the_end_of_the_range() {
    let line = |x: f32| Bezier::from_points([[-x, 0.0], [x, 0.0]]);
    assert_eq!(line(3e38).arclen(1e30), f32::INFINITY);
    assert_eq!(ParametricCurve::arclen(&line(3e38), 1e30), f32::INFINITY);
    assert_eq!(line(1.5e38).arclen(1e30), 3e38);
    let double = Bezier::from_points([[-1.5e308, 0.0], [1.5e308_f64, 0.0]]);
    assert_eq!([double.arclen(1e300), ParametricCurve::arclen(&double, 1e300)], [f64::INFINITY; 2]);
    assert_eq!(Plain(double).arclen(1e300), f64::INFINITY);
    // Differences that are too large, of a length that is not: the parameters at equal distances are those of any size.
    assert_eq!(line(3e38).arclen_parameters(3, 1e30), [0.0, 0.5, 1.0]);
    let zigzag = |x: f32| Bezier::from_points([[-x, -x], [x, -x], [-x, x], [x, x]]);
    let ratio = zigzag(3e38).inv_arclen(3e38, 1e30) / zigzag(1.0).inv_arclen(1.0, 1e-8);
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
    assert!(Bezier::from_points([[0.0, 0.0], [f32::NAN, 0.0]]).arclen(1.0).is_nan());
    let square = |x: f64| Path::rectangle([[-x, -x], [x, 0.5 * x]]);
    for x in [1e38, 1e60, 1e150, 1e-60, 1e-150] {
        let enclosed = square(x).enclosed().unwrap();
        let [cx, cy] = enclosed.centroid.unwrap();
        assert!(cx.abs() < 1e-15 * x && (cy / x + 0.25).abs() < 1e-15, "{cx} {cy}");
        assert!((enclosed.area / x / x - 3.0).abs() < 1e-14, "{enclosed:?}");
        assert!(enclosed.second_moments.iter().all(|m| !m.is_nan()), "{enclosed:?}");
    }
    let large = Path::<[f32; 2]>::rectangle([[-1e38, -1e38], [1e38, 1e38]]);
    assert_eq!(large.enclosed().unwrap().area, f32::INFINITY);
    assert_eq!(large.reversed().enclosed().unwrap().area, f32::NEG_INFINITY);
    assert_eq!(large.enclosed().unwrap().centroid, Some([0.0, 0.0]));
}
