//! No number makes a question about a spline panic or run without end.

use basis_runtime::bspline::{BSplineCurve, KnotVector, NurbsCurve};
use basis_runtime::{CurveError, ParametricCurve};

const NUMBERS: [f64; 12] =
    [0.0, 1.0, -1.0, 0.375, 1e-9, 1e-300, 1e300, f64::MAX, 1e9, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

fn ask(curve: &dyn ParametricCurve<Point = [f64; 2]>, a: f64, b: f64) {
    let [lo, hi] = curve.domain();
    let inside = |t: f64| (lo..=hi).contains(&t) || t.is_nan();
    assert!(inside(curve.inv_arclen(a, b)));
    assert!(curve.arclen_parameters(3, a).into_iter().all(inside));
    let length = curve.arclen(a);
    assert!(length >= 0.0 || length.is_nan(), "{length}");
    assert!(curve.extrema().into_iter().all(inside) && curve.inflections().unwrap().into_iter().all(inside));
    if let Some(found) = curve.nearest([a, b], b) {
        assert!(inside(found.at) && found.distance >= found.at_least && found.at_least >= 0.0, "{found:?}");
    }
    if a > 1e-3 || a <= 0.0 || a.is_nan() {
        match curve.flatten(a) {
            Ok(corners) => assert!(corners.len() >= 2),
            Err(error) => assert!(matches!(
                error,
                CurveError::Tolerance { .. } | CurveError::NotFinite | CurveError::TooManyPoints { .. }
            )),
        }
    }
    let tangent = curve.tangent(a);
    assert!(tangent.is_none_or(|[x, y]| (x.hypot(y) - 1.0).abs() < 1e-9), "{tangent:?}");
    let [low, high] = curve.bounding_box();
    assert!((0..2).all(|d| low[d] <= high[d] || low[d].is_nan()), "{low:?} {high:?}");
    let _ = (curve.curvature(a), curve.control_box(), curve.eval_clamped(a), curve.derivative(a, 9));
    assert_eq!(curve.eval_checked(a).is_ok(), (lo..=hi).contains(&a));
    assert_eq!(curve.samples_by_arclen(4, a).len(), 4);
    let mut points = [[0.0; 2]; 2];
    assert!(curve.eval_into(&[lo, a], &mut points).is_ok() && curve.eval_into(&[a], &mut points).is_err());
}

#[test]
fn numbers() {
    let nets: [fn(usize) -> [f64; 2]; 9] = [
        |i| [i as f64, (i * i) as f64 * 0.25],
        |_| [0.5, -2.0],
        |_| [f64::NAN; 2],
        |_| [f64::INFINITY, 0.0],
        |i| [(i % 2) as f64, 0.0],
        |i| [[0.0, 1.0, 0.0, 1.0][i % 4], [0.0, 1.0, 1.0, 0.0][i % 4]],
        |i| [f64::MAX * [1.0, -1.0][i % 2], f64::MAX * [1.0, -1.0][i / 2 % 2]],
        |i| [5e-324 * i as f64, 1e-308 * (i * i) as f64],
        |i| [1e160 * i as f64, 1e-160 * (i * i) as f64],
    ];
    for net in nets {
        let knots = KnotVector::clamped(3, &[0.0, 0.25, 0.25, 1.0]).unwrap();
        let points: Vec<[f64; 2]> = (0..knots.functions()).map(net).collect();
        let weights: Vec<f64> = (0..points.len()).map(|i| [1.0, 1e-3, 1e3][i % 3]).collect();
        let rational = NurbsCurve::new(knots.clone(), &points, &weights).unwrap();
        let plain = BSplineCurve::new(knots, points).unwrap();
        for (k, a) in NUMBERS.into_iter().enumerate() {
            for step in [0, 5] {
                let b = NUMBERS[(k + step) % NUMBERS.len()];
                ask(&plain, a, b);
                ask(&rational, a, b);
            }
        }
    }
}
