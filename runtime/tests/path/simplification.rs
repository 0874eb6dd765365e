//! Paths of fewer segments, and paths along points.

use basis_runtime::bspline::FitError;
use basis_runtime::{Bezier, CurveError, Fit, ParametricCurve, Path, PathSegment, to_svg};

use crate::closed;
use crate::random::Random;

type P = [f64; 2];

/// The largest distance of points of the one from the other, both ways.
fn apart(a: &Path<P>, b: &Path<P>) -> f64 {
    let one = |a: &Path<P>, b: &Path<P>| {
        let near = |p: P| b.nearest(p, 1e-9).unwrap().distance;
        a.samples(6 * a.segments().len() + 1).map(near).fold(0.0, f64::max)
    };
    one(a, b).max(one(b, a))
}

#[test]
fn within_the_tolerance_with_fewer_segments() {
    let mut random = Random::new(61);
    for round in 0..6 {
        // A random path, cut into many pieces.
        let path = closed(&mut random, 2 + round % 3);
        let count = 8 * path.segments().len();
        let end = path.domain()[1];
        let mut cut = path.subsegment(0.0..end / count as f64).unwrap();
        for k in 1..count {
            let [a, b] = [k, k + 1].map(|k| end * k as f64 / count as f64);
            cut.append(&path.subsegment(a..b).unwrap());
        }
        for tolerance in [1e-1, 1e-3] {
            let simple = cut.simplified(tolerance).unwrap();
            let cubics = cut.to_cubics(tolerance).unwrap().segments().len();
            assert!(simple.segments().len() < cubics, "{} {cubics}", simple.segments().len());
            assert!(simple.segments().iter().all(|s| s.degree() <= 3 && s.weights().is_none()));
            assert!(apart(&simple, &cut) <= tolerance * (1.0 + 1e-9));
            assert!(simple.start() == cut.start() && simple.end() == cut.end());
        }
    }
}

/// Corners that the tolerance does not hide stay corners, and so do jumps.
#[test]
fn corners_and_jumps_stay() {
    let mut path =
        Path::<P>::polyline(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]]).unwrap();
    path.append(&Path::polyline(&[[5.0, 0.0], [6.0, 0.0], [7.0, 0.0]]).unwrap());
    let simple = path.simplified(1e-3).unwrap();
    let ends: Vec<[P; 2]> = simple.segments().iter().map(|s| [s.start(), s.end()]).collect();
    assert_eq!(ends, [[[0.0, 0.0], [2.0, 0.0]], [[2.0, 0.0], [2.0, 2.0]], [[5.0, 0.0], [7.0, 0.0]]]);
    // A circle in 64 arcs, as a few cubics.
    let circle = Path::circle([0.0, 0.0], 1.0);
    let mut arcs = circle.subsegment(0.0..0.0625).unwrap();
    for k in 1..64 {
        arcs.append(&circle.subsegment(f64::from(k) / 16.0..f64::from(k + 1) / 16.0).unwrap());
    }
    let simple = arcs.simplified(1e-3).unwrap();
    assert!(simple.segments().len() <= 5, "{}", simple.segments().len());
    assert!(simple.samples(500).all(|p| (p[0].hypot(p[1]) - 1.0).abs() <= 1e-3));
}

#[test]
fn hostile_paths() {
    let line = Path::<P>::polyline(&[[0.0, 0.0], [1.0, 1.0]]).unwrap();
    assert!(matches!(line.simplified(0.0), Err(CurveError::Tolerance { .. })));
    let broken = Path::<P>::polyline(&[[0.0, 0.0], [f64::NAN, 1.0]]).unwrap();
    assert_eq!(broken.simplified(0.1).unwrap_err(), CurveError::NotFinite);
    let mut random = Random::new(62);
    let number = |random: &mut Random| match random.below(8) {
        0 => 1e300,
        1 => 5e-324,
        2 => -1e-300,
        3..6 => 0.0,
        _ => random.between::<f64>(-2.0, 2.0),
    };
    for _ in 0..200 {
        let mut point = || [number(&mut random), number(&mut random)];
        let segments =
            (0..4).map(|k| PathSegment::polynomial((0..=k).map(|_| point()).collect::<Vec<P>>()).unwrap());
        let path = Path::new(segments.collect()).unwrap();
        if let Ok(simple) = path.simplified(1e-2) {
            assert!(simple.start() == path.start() && simple.end() == path.end());
        }
    }
}

/// Every point is within the tolerance of the path, the corners are points, and the text is read back.
#[test]
fn paths_along_points() {
    let mut random = Random::new(63);
    let arch = Bezier::from_points([[0.0, 0.0], [1.0, 3.0], [4.0, 3.0], [5.0_f64, 0.0]]);
    let mut points: Vec<P> = arch.samples(60).collect();
    points.extend((1..30).map(|i| [5.0 - f64::from(i) / 6.0, 0.0]));
    for p in &mut points {
        *p = p.map(|c| c + random.between::<f64>(-1e-4, 1e-4));
    }
    for tolerance in [1e-1, 1e-2, 1e-3] {
        let fit = Fit::new(&points).path_within(tolerance, 1.0).unwrap();
        assert!(fit.largest <= tolerance && fit.parameters.len() == points.len());
        for (&t, &p) in fit.parameters.iter().zip(&points) {
            let q = fit.curve.eval(t);
            assert!((p[0] - q[0]).hypot(p[1] - q[1]) <= tolerance * (1.0 + 1e-9), "{t} {p:?} {q:?}");
        }
        assert!(fit.curve.segments().iter().any(|s| s.end() == points[59]), "the corner");
        assert!(fit.curve.segments().len() < 12, "{}", fit.curve.segments().len());
        let text = to_svg(&fit.curve, 1e-9).unwrap();
        let [read] = Path::<P>::from_svg(&text).unwrap().try_into().unwrap();
        assert_eq!(read.segments().len(), fit.curve.segments().len());
    }
    let two = Fit::new(&points[..2]).path_within(0.1, 1.0).unwrap();
    assert_eq!((two.curve.start(), two.curve.end()), (points[0], points[1]));
    let zigzag = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 0.0], [3.0, 1.0]];
    let fit = Fit::new(&zigzag).path_within(0.01, 0.5).unwrap();
    assert_eq!(fit.curve.segments().len(), 3);
    assert!(Fit::new(&zigzag[..1]).path_within(0.01, 0.5).is_err());
    for corner in [-0.5, f64::NAN, f64::NEG_INFINITY] {
        let error = Fit::new(&zigzag).path_within(0.01, corner).unwrap_err();
        assert!(matches!(error, FitError::Corner { .. }), "{error}");
    }
    assert!(Fit::new(&zigzag).path_within(0.01, f64::INFINITY).is_ok());
    let error = Fit::new(&[[1.0, 1.0]; 5]).path_within(0.01, 0.5).unwrap_err();
    assert_eq!(error, FitError::Coincide { index: 1 });
    assert!(error.to_string().starts_with("point 1 coincides with the one before it"), "{error}");
}

/// The pieces of one cubic become that cubic.
#[test]
fn a_cubic_comes_back() {
    let mut random = Random::new(64);
    let mut alone = 0;
    for _ in 0..20 {
        let x = |k: usize, random: &mut Random| k as f64 + random.between::<f64>(-0.3, 0.3);
        let points = core::array::from_fn(|k| [x(k, &mut random), random.between::<f64>(-1.0, 1.0)]);
        let cubic: Bezier<P, 4> = Bezier::from_points(points);
        let mut pieces = Path::from_curve(&cubic.subsegment(0.0..0.1).unwrap());
        for k in 1..10 {
            pieces.append(&cubic.subsegment(f64::from(k) / 10.0..f64::from(k + 1) / 10.0).unwrap());
        }
        let count = pieces.simplified(1e-4).unwrap().segments().len();
        alone += usize::from(count == 1);
        assert!(count <= 2, "{points:?}");
    }
    assert!(alone >= 18, "{alone} of 20");
}

/// In single precision as in double precision.
#[test]
fn single_precision() {
    let line: Vec<[f32; 2]> = (0..=100).map(|i| i as f32).map(|x| [x, 2.0 * x]).collect();
    assert_eq!(Path::polyline(&line).unwrap().simplified(1e-3).unwrap().segments().len(), 1);
    for scale in [1.0_f32, 10.0] {
        let angle = |i: usize| i as f32 / 1000.0 * std::f32::consts::TAU;
        let corners: Vec<[f32; 2]> =
            (0..1000).map(angle).map(|a| [scale * a.cos(), scale * a.sin()]).collect();
        let simple = Path::polygon(&corners).unwrap().simplified(1e-3 * scale).unwrap();
        assert_eq!(simple.segments().len(), 4, "{scale}");
    }
}
