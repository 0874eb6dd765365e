//! B-splines: given knots, numbers of control points, tolerances, smoothing.

use basis_runtime::bspline::{BSplineCurve, FitError, KnotVector, Spacing, parameters};
use basis_runtime::{Fit, FitEnd};
use serde_json::Value;

use crate::distance;
use crate::random::Random;

/// scipy's smoothing splines, whose weights are the squares.
#[test]
fn the_smoothing_splines_of_scipy() {
    let text = include_str!("../golden/bspline.json");
    let golden: Value = serde_json::from_str(text).unwrap();
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let cases = golden["smoothings"].as_array().unwrap();
    assert!(!cases.is_empty());
    for case in cases {
        let (x, y, weights) =
            (numbers(&case["parameters"]), numbers(&case["data"]), numbers(&case["weights"]));
        let largest = weights.iter().copied().fold(0.0, f64::max);
        let factor = case["factor"].as_f64().unwrap();
        let knots = KnotVector::clamped(3, &x).unwrap();
        let fit = Fit::new(&y).parameters(&x).weights(&weights).smoothing(factor).spline(knots).unwrap();
        for (&at, &expected) in numbers(&case["at"]).iter().zip(&numbers(&case["values"])) {
            let found = fit.curve.eval(at);
            assert!((found - expected).abs() < 1e-8, "{factor} {largest}: {found} is not {expected} at {at}");
        }
    }
}

/// The same as the least squares with all three numbers given.
#[test]
fn over_given_knots() {
    let mut random = Random::new(21);
    let data: Vec<[f64; 2]> =
        (0..30).map(|_| [random.between::<f64>(0.0, 9.0), random.between::<f64>(-2.0, 2.0)]).collect();
    let t = parameters(&data, Spacing::Chord).unwrap();
    let knots = KnotVector::clamped(3, &[0.0, 0.3, 0.5, 1.0]).unwrap();
    let expected = BSplineCurve::fit(knots.clone(), &t, &data, None).unwrap();
    let fit = Fit::new(&data).spline(knots).unwrap();
    for (a, b) in fit.curve.control_points().iter().zip(expected.control_points()) {
        assert!(distance(*a, *b) < 1e-10);
    }
}

#[test]
fn as_many_control_points_as_asked_for() {
    let data: Vec<[f64; 2]> = (0..50).map(|i| f64::from(i) * 0.13).map(|x| [x, x.sin()]).collect();
    let mut last = f64::INFINITY;
    for count in [4, 6, 10, 20, 35, 50] {
        let fit = Fit::new(&data).ends([FitEnd::Interpolated; 2]).spline_with(3, count).unwrap();
        assert_eq!(fit.curve.control_points().len(), count);
        assert!(fit.root_mean_square < last);
        last = fit.root_mean_square;
    }
    assert!(last < 1e-13);
    let few = Fit::new(&data).spline_with(3, 3).unwrap_err();
    assert_eq!(few, FitError::TooFewFunctions { needed: 4, found: 3 });
    let many = Fit::new(&data).spline_with(3, 51).unwrap_err();
    assert_eq!(many, FitError::TooFew { needed: 51, found: 50 });
}

/// Every point is within the tolerance, and the knots stand where the curve is not smooth.
#[test]
fn within_a_tolerance() {
    let mut random = Random::new(22);
    for round in 0..12 {
        let degree = 1 + round % 5;
        let corner: f64 = random.between::<f64>(2.0, 8.0);
        let noise = [0.0, 1e-3, 0.1][round % 3];
        let data: Vec<[f64; 2]> = (0..150)
            .map(|i| f64::from(i) / 15.0)
            .map(|x| [x, (x - corner).abs() + 0.2 * x.sin() + random.between::<f64>(-noise, noise)])
            .collect();
        let tolerance = [1e-1, 1e-2, 1e-3][(round / 3) % 3];
        let fit = Fit::new(&data).spline_within(degree, tolerance).unwrap();
        assert!(fit.largest <= tolerance);
        for (&t, &p) in fit.parameters.iter().zip(&data) {
            assert!(distance(fit.curve.eval(t), p) <= tolerance * (1.0 + 1e-9));
        }
        let spans = fit.curve.knots().spans().count();
        if noise == 0.0 && degree > 1 {
            assert!(spans < 60, "{degree} {tolerance}: {spans}");
        }
        let ends =
            Fit::new(&data).ends([FitEnd::Interpolated; 2]).orthogonal(1).spline_within(degree, tolerance);
        let ends = ends.unwrap();
        assert!(ends.largest <= tolerance && ends.curve.start() == data[0] && ends.curve.end() == data[149]);
    }
}

/// A polynomial needs no knots, and what jumps cannot be reached.
#[test]
fn the_fewest_and_the_impossible() {
    let cubic: Vec<[f64; 1]> = (0..40).map(|i| f64::from(i) / 39.0).map(|x| [x * x * (x - 0.7)]).collect();
    let t: Vec<f64> = (0..40).map(|i| f64::from(i) / 39.0).collect();
    let fit = Fit::new(&cubic).parameters(&t).spline_within(3, 1e-12).unwrap();
    assert_eq!(fit.curve.control_points().len(), 4);
    let twice = [[0.0], [1.0], [2.0], [1.0], [0.0]];
    let error = Fit::new(&twice).parameters(&[0.0, 0.5, 0.5, 0.7, 1.0]).spline_within(1, 0.1).unwrap_err();
    assert!(matches!(error, FitError::NotReached { reached, .. } if reached >= 0.4), "{error}");
    let fit = Fit::new(&twice).parameters(&[0.0, 0.5, 0.5, 0.7, 1.0]).spline_within(1, 0.51).unwrap();
    assert!(fit.largest <= 0.51);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Fit::new(&twice).spline_within(1, tolerance).unwrap_err();
        assert!(matches!(error, FitError::Tolerance { .. }));
    }
    // Every tolerance can be reached with different parameters: the curve through the points.
    let data: Vec<[f64; 2]> = (0..30).map(|i| [f64::from(i), f64::from(i * i % 7)]).collect();
    for degree in 1..6 {
        let fit = Fit::new(&data).spline_within(degree, 1e-9).unwrap();
        assert!(fit.largest <= 1e-9);
    }
}
