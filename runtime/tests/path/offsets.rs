//! Curves beside curves, and outlines of strokes, against distances that are found by brute force.

use std::f64::consts::PI;

use basis_runtime::bspline::{BSplineCurve, KnotVector, NurbsCurve};
use basis_runtime::{
    Bezier, Curve, CurveError, LineCap, LineJoin, Offset, ParametricCurve, Path, PathSegment, Stroke,
};

use crate::closed;
use crate::random::Random;

type P = [f64; 2];

fn away(p: P, q: P) -> f64 {
    (p[0] - q[0]).hypot(p[1] - q[1])
}

/// Points of the exact parallel curve.
fn exact(curve: &impl ParametricCurve<Point = P>, distance: f64, count: usize) -> Vec<P> {
    let [lo, hi] = curve.domain();
    let point = |i: usize| {
        let t = lo + (hi - lo) * i as f64 / count as f64;
        let ([x, y], [u, v]) = (curve.eval(t), curve.tangent(t).unwrap());
        [x - distance * v, y + distance * u]
    };
    (0..=count).map(point).collect()
}

/// The distance of the answer from the parallel curve, both ways, is at most the tolerance.
fn check(curve: &impl ParametricCurve<Point = P>, distance: f64, tolerance: f64) {
    let [path] = curve.offset(distance, tolerance).unwrap().try_into().unwrap();
    let [lo, hi] = curve.domain();
    let count = 800;
    let expected = exact(curve, distance, count);
    let at = |t: f64| {
        let ([x, y], [u, v]) = (curve.eval(t), curve.tangent(t).unwrap());
        [x - distance * v, y + distance * u]
    };
    for p in path.segments().iter().flat_map(|s| (0..=8).map(|i| s.eval(f64::from(i) / 8.0))) {
        // The nearest of many points of the exact curve, and the nearest one next to each that is nearer than its neighbours.
        let far: Vec<f64> = expected.iter().map(|&q| away(p, q)).collect();
        let lowest = |&i: &usize| (i == 0 || far[i] <= far[i - 1]) && (i == count || far[i] <= far[i + 1]);
        let refined = |i: usize| {
            let (mut best, mut t) = (far[i], lo + (hi - lo) * i as f64 / count as f64);
            let mut step = (hi - lo) / count as f64;
            while best > tolerance && step > 1e-12 {
                let sides = [(t - step).max(lo), (t + step).min(hi)].map(|t| (away(p, at(t)), t));
                let side = if sides[0].0 < sides[1].0 { sides[0] } else { sides[1] };
                if side.0 < best {
                    (best, t) = side;
                } else {
                    step *= 0.5;
                }
            }
            best
        };
        let best = (0..=count).filter(lowest).map(refined).fold(f64::INFINITY, f64::min);
        assert!(best <= tolerance * (1.0 + 1e-9), "{best} {tolerance} {}", path.segments().len());
    }
    for &q in expected.iter().step_by(16) {
        let found = path.nearest(q, 1e-3 * tolerance).unwrap().distance;
        assert!(found <= 1.001 * tolerance, "{found} {tolerance}");
    }
    assert!(away(path.start(), expected[0]) < 1e-9 && away(path.end(), expected[count]) < 1e-9);
}

#[test]
fn curves_of_all_types() {
    let mut random = Random::new(51);
    for round in 0..6 {
        let mut point = || [random.between::<f64>(-2.0, 2.0), random.between(-2.0, 2.0)];
        let points: [P; 6] = core::array::from_fn(|_| point());
        let distance = [0.3, -0.3, 1.1, -0.02][round % 4];
        let tolerance = [1e-1, 1e-2, 1e-3, 1e-4][round % 4];
        check(&Bezier::from_points([points[0], points[1], points[2], points[3]]), distance, tolerance);
        check(&Bezier::from_points(points), distance, tolerance);
        let knots = || KnotVector::clamped(3, &[0.0, 0.4, 0.7, 1.0]).unwrap();
        let spline = BSplineCurve::new(knots(), points).unwrap();
        check(&spline, distance, tolerance);
        let weights: Vec<f64> = (0..6).map(|_| random.between::<f64>(0.3, 3.0)).collect();
        check(&NurbsCurve::new(knots(), points, weights).unwrap(), distance, tolerance);
    }
}

/// Curves that begin or end with control points that coincide have directions there all the same.
#[test]
fn vanishing_velocities() {
    for (a, b) in [(0, 1), (2, 3), (0, 2)] {
        let mut points = [[0.0, 0.0], [1.0, 1.5], [2.0, -1.0], [3.0, 0.5]];
        points[b] = points[a];
        if (a, b) == (0, 2) {
            points[1] = points[0];
        }
        for distance in [0.2, -0.4] {
            check(&Bezier::from_points(points), distance, 1e-4);
        }
    }
    // A cusp: the direction turns by a half turn within the curve, which is an outer corner.
    let cusp = Bezier::from_points([[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0_f64, 0.0]]);
    let [path] = cusp.offset(0.1, 1e-6).unwrap().try_into().unwrap();
    for p in path.samples(400) {
        let near = cusp.nearest(p, 1e-12).unwrap();
        assert!(near.distance < 0.1 + 1e-6);
    }
}

/// Lines and circles have exact answers, and the cusps of a parabola stand where the radius of curvature is the distance.
#[test]
fn known_answers() {
    let line = Path::polyline(&[[1.0, 1.0], [4.0, 5.0]]).unwrap();
    let [beside] = line.offset(5.0, 1e-9).unwrap().try_into().unwrap();
    assert!(away(beside.start(), [-3.0, 4.0]) < 1e-14 && away(beside.end(), [0.0, 8.0]) < 1e-14);
    let circle = Path::circle([3.0, -1.0], 2.0);
    for (distance, tolerance) in [(0.5, 1e-3), (-1.0, 1e-6), (3.5, 1e-9)] {
        let [beside] = circle.offset(distance, tolerance).unwrap().try_into().unwrap();
        assert!(beside.is_closed());
        let radius = (2.0_f64 - distance).abs();
        assert!(beside.samples(999).all(|p| (away(p, [3.0, -1.0]) - radius).abs() <= tolerance));
    }
    // Of y = x²: κ = 2 / (1 + 4 x²)^(3/2).
    let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]);
    let [beside] = parabola.offset(1.0, 1e-4).unwrap().try_into().unwrap();
    let x = ((2.0_f64.powf(2.0 / 3.0) - 1.0) / 4.0).sqrt();
    let speed = (1.0 + 4.0 * x * x).sqrt();
    for sign in [-1.0, 1.0] {
        let cusp = [sign * (x - 2.0 * x / speed), x * x + 1.0 / speed];
        assert!(beside.segments().iter().any(|s| away(s.end(), cusp) < 1e-9), "{cusp:?}");
    }
    assert_eq!(
        parabola.offset(0.0, 1e-4).unwrap()[0].segments()[0].control_points(),
        parabola.control_points()
    );
}

#[test]
fn joins_and_contours() {
    let square = Path::rectangle([[0.0, 0.0], [2.0, 2.0]]);
    let area = |join: LineJoin<f64>| {
        let [path] = Offset::new(-1.0, 1e-6).unwrap().join(join).of(&square).unwrap().try_into().unwrap();
        assert!(path.is_closed());
        path.enclosed().unwrap().area
    };
    assert!((area(LineJoin::Round) - (12.0 + PI)).abs() < 1e-12);
    assert!((area(LineJoin::Bevel) - 14.0).abs() < 1e-12);
    assert!((area(LineJoin::Miter { limit: 1.5 }) - 16.0).abs() < 1e-12);
    assert!((area(LineJoin::Miter { limit: 1.4 }) - 14.0).abs() < 1e-12);
    assert!((area(LineJoin::Miter { limit: f64::NAN }) - 14.0).abs() < 1e-12);
    let mut two = square;
    two.append(&Path::circle([9.0, 0.0], 1.0));
    two.append(&Path::polyline(&[[0.0, 5.0], [1.0, 5.0]]).unwrap());
    let paths = two.offset(-0.5, 1e-6).unwrap();
    assert_eq!(paths.iter().map(Path::is_closed).collect::<Vec<_>>(), [true, true, false]);
}

/// Trimmed answers: everything is at the distance from the curve, all of the parallel curve that is, is there, and
/// nothing meets itself.
fn check_trimmed(curve: &Path<P>, distance: f64, tolerance: f64) {
    let paths = Offset::new(distance, tolerance).unwrap().trimmed().of(curve).unwrap();
    for path in &paths {
        for p in path.samples(100) {
            let near = curve.nearest(p, 1e-3 * tolerance).unwrap().distance;
            assert!((near - distance.abs()).abs() <= 2.6 * tolerance, "{near} {distance} {tolerance}");
        }
    }
    let mut missing = 0;
    let count = 150;
    for p in exact(curve, distance, count) {
        let near = curve.nearest(p, 1e-9).unwrap().distance;
        if near >= distance.abs() - 1e-8 {
            let to = paths.iter().filter_map(|path| path.nearest(p, 0.1 * tolerance)).map(|n| n.distance);
            missing += usize::from(to.fold(f64::INFINITY, f64::min) > 3.0 * tolerance);
        }
    }
    assert_eq!(missing, 0, "{distance} {tolerance}");
}

#[test]
fn trimmed_answers() {
    let mut random = Random::new(52);
    for round in 0..12 {
        let curve = closed(&mut random, 2 + round % 4);
        let distance = [0.2, -0.5, 1.0][round % 3];
        check_trimmed(&curve, distance, 1e-3);
        let mut point = || [random.between::<f64>(-2.0, 2.0), random.between(-2.0, 2.0)];
        let open = Path::from_curve(&Bezier::from_points([point(), point(), point(), point()]));
        check_trimmed(&open, distance, 1e-3);
    }
}

/// An inner corner, a slot, and what vanishes.
#[test]
fn trimmed_shapes() {
    let trimmed =
        |path: &Path<P>, distance: f64| Offset::new(distance, 1e-6).unwrap().trimmed().of(path).unwrap();
    let square = Path::rectangle([[0.0, 0.0], [2.0, 2.0]]);
    let [inside] = trimmed(&square, 0.5).try_into().unwrap();
    assert!(inside.is_closed() && (inside.enclosed().unwrap().area - 1.0).abs() < 1e-9);
    assert!(trimmed(&square, 1.25).is_empty());
    // Two rooms with a narrow passage become two squares.
    let rooms = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 1.8],
        [6.0, 1.8],
        [6.0, 0.0],
        [10.0, 0.0],
        [10.0, 4.0],
        [6.0, 4.0],
        [6.0, 2.2],
        [4.0, 2.2],
        [4.0, 4.0],
        [0.0, 4.0],
    ];
    let rooms = trimmed(&Path::polygon(&rooms).unwrap(), 0.5);
    assert_eq!(rooms.len(), 2);
    for room in rooms {
        // Nine of the square, and the corners of the passage reach 0.5 into the room by arcs.
        let area = room.enclosed().unwrap().area;
        assert!(room.is_closed() && (area - 9.0).abs() < 0.2, "{area}");
    }
    // Both sides of an ellipse beyond its smallest radius of curvature.
    let ellipse = Path::ellipse([0.0, 0.0], [3.0, 1.0], 0.0);
    let [inside] = trimmed(&ellipse, 0.6).try_into().unwrap();
    assert!(inside.is_closed());
    assert!(inside.self_intersections(1e-9).unwrap().is_empty());
    assert!(inside.enclosed().unwrap().area > 0.0 && inside.winding([0.0, 0.0]).unwrap() == Some(1));
    // A hole and a wall that meet: one contour on each side.
    let mut ring = Path::circle([0.0, 0.0], 3.0);
    ring.append(&Path::circle([0.0, 0.0], 1.0).reversed());
    assert_eq!(trimmed(&ring, 0.5).len(), 2);
    assert!(trimmed(&ring, 1.1).is_empty());
}

/// Corners that turn by so little that the loop between their sides is hidden in the tolerance.
#[test]
fn trimmed_small_corners() {
    let trimmed =
        |path: &Path<P>, distance: f64| Offset::new(distance, 1e-3).unwrap().trimmed().of(path).unwrap();
    for turn in [0.5_f64, 0.2, 0.1, 0.05, 0.02, 0.01, 0.001] {
        for side in [1.0, -1.0] {
            let end = [1.0 + turn.cos(), side * turn.sin()];
            let [path] = trimmed(&Path::polyline(&[[0.0, 0.0], [1.0, 0.0], end]).unwrap(), 0.1 * side)
                .try_into()
                .unwrap();
            assert!(path.self_intersections(1e-9).unwrap().is_empty(), "{turn} {path:?}");
        }
    }
    for count in [12_u32, 60, 200] {
        let corner = |i: u32| {
            let angle = 2.0 * PI * f64::from(i) / f64::from(count);
            [angle.cos(), angle.sin()]
        };
        let polygon = Path::polygon(&(0..count).map(corner).collect::<Vec<_>>()).unwrap();
        let [inside] = trimmed(&polygon, 0.1).try_into().unwrap();
        let half = PI / f64::from(count);
        let height = half.cos() - 0.1;
        let expected = f64::from(count) * height * height * half.tan();
        let area = inside.enclosed().unwrap().area;
        assert!(inside.is_closed() && (area - expected).abs() < 5e-3, "{count} {area} {expected}");
    }
    // Many chords of a curve, in a time that does not grow with the cube of their number.
    for count in [250, 1000] {
        let x = |i: u32| 20.0 * f64::from(i) / f64::from(count);
        let wave: Vec<P> = (0..=count).map(|i| [x(i), x(i).sin()]).collect();
        assert_eq!(trimmed(&Path::polyline(&wave).unwrap(), 0.1).len(), 1);
    }
}

/// A segment that turns back has an arc there, as two segments have.
#[test]
fn curves_that_turn_back() {
    let out_and_back = PathSegment::polynomial(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]).unwrap();
    let curve = Path::new(vec![out_and_back]).unwrap();
    for distance in [0.3, -0.3] {
        for offset in [Offset::new(distance, 1e-4).unwrap(), Offset::new(distance, 1e-4).unwrap().trimmed()] {
            let [path] = offset.of(&curve).unwrap().try_into().unwrap();
            for p in path.samples(200) {
                let near: f64 = curve.nearest(p, 1e-9).unwrap().distance;
                assert!((near - 0.3).abs() < 1e-4, "{p:?} {near}");
            }
            assert!(path.nearest([0.8, 0.0], 1e-9).unwrap().distance < 1e-9);
        }
    }
}

/// A point is painted if it is nearer to the curve than half of the width.
#[test]
fn strokes_cover_what_is_near() {
    let mut random = Random::new(53);
    for round in 0..40 {
        let curve = if round % 2 == 0 {
            closed(&mut random, 2 + round % 3)
        } else {
            let mut point = || [random.between::<f64>(-2.0, 2.0), random.between(-2.0, 2.0)];
            let mut path = Path::from_curve(&Bezier::from_points([point(), point(), point(), point()]));
            path.line_to(point());
            path
        };
        let width = [0.2, 1.0, 3.0][round % 3];
        let stroke = Stroke::new(width, 1e-4).unwrap().join(LineJoin::Round).cap(LineCap::Round);
        let outlines = stroke.of(&curve).unwrap();
        assert_eq!(outlines.len(), if curve.is_closed() { 2 } else { 1 });
        assert!(outlines.iter().all(Path::is_closed));
        for _ in 0..100 {
            let p = [random.between::<f64>(-5.0, 6.0), random.between(-5.0, 4.0)];
            let near = curve.nearest(p, 1e-9).unwrap().distance;
            if (near - 0.5 * width).abs() > 2e-4 {
                let winding: i32 = outlines.iter().map(|path| path.winding(p).unwrap().unwrap_or(1)).sum();
                assert_eq!(winding != 0, near < 0.5 * width, "{p:?} {near} {width} {winding} {round}");
            }
        }
    }
}

#[test]
fn caps() {
    let line = Path::<P>::polyline(&[[0.0, 0.0], [3.0, 4.0]]).unwrap();
    for (cap, expected) in [(LineCap::Butt, 10.0), (LineCap::Square, 14.0), (LineCap::Round, 10.0 + PI)] {
        let [outline] = Stroke::new(2.0, 1e-6).unwrap().cap(cap).of(&line).unwrap().try_into().unwrap();
        assert!((outline.enclosed().unwrap().area.abs() - expected).abs() < 1e-12, "{cap:?}");
    }
}

#[test]
fn hostile_numbers() {
    let number = |random: &mut Random| match random.below(12) {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => 1e300,
        3 => 5e-324,
        4 => 1e-300,
        5..8 => 0.0,
        8..10 => 1.0,
        _ => random.between::<f64>(-3.0, 3.0),
    };
    let mut random = Random::new(54);
    let mut answers = 0;
    for _ in 0..200 {
        let count = 1 + random.below(5);
        let points: Vec<P> = (0..count).map(|_| [number(&mut random), number(&mut random)]).collect();
        let mut path = Path::from(PathSegment::polynomial(points.clone()).unwrap());
        if random.below(2) == 0 {
            let weights: Vec<f64> = points.iter().map(|_| random.between::<f64>(0.01, 9.0)).collect();
            path.push(PathSegment::rational(points, weights).unwrap());
        }
        if random.below(2) == 0 {
            path.line_to([number(&mut random), number(&mut random)]);
        }
        let tolerance = [1e-3, 1e-2, number(&mut random).max(1e-6)][random.below(3)];
        let Ok(offset) = Offset::new(number(&mut random), tolerance) else { continue };
        answers += usize::from(offset.of(&path).is_ok());
        if random.below(4) == 0 {
            answers += usize::from(offset.trimmed().of(&path).is_ok());
        }
        if let Ok(stroke) = Stroke::new(number(&mut random), tolerance) {
            answers +=
                usize::from(stroke.join(LineJoin::Miter { limit: number(&mut random) }).of(&path).is_ok());
        }
    }
    assert!(answers > 40, "{answers}");
    let space = Curve::new(basis_runtime::BernsteinBasis::<f64, 2>::default(), [[0.0; 3], [1.0; 3]]);
    assert_eq!(space.offset(1.0, 0.1).unwrap_err(), CurveError::Dimension { expected: 2, found: 3 });
    let line = Path::polyline(&[[0.0, 0.0], [1.0, 0.0]]).unwrap();
    assert!(matches!(line.offset(f64::INFINITY, 0.1), Err(CurveError::Distance { .. })));
    assert!(matches!(line.offset(1.0, 0.0), Err(CurveError::Tolerance { .. })));
    assert!(matches!(Stroke::new(-1.0, 0.1), Err(CurveError::Distance { .. })));
    let point = Path::polyline(&[[1.0, 1.0], [1.0, 1.0]]).unwrap();
    assert!(point.offset(1.0, 0.1).unwrap().is_empty());
}

/// Other scalar types.
#[test]
fn single_precision() {
    let line = Path::<[f32; 2]>::polyline(&[[0.0, 0.0], [3.0, 4.0], [6.0, 0.0]]).unwrap();
    let [beside] = line.offset(1.0, 1e-3).unwrap().try_into().unwrap();
    assert_eq!(beside.segments().len(), 4); // two lines and an arc of more than a quarter
    assert!(away(beside.start().map(f64::from), [-0.8, 0.6]) < 1e-6);
}
