//! Closed curves: periodic knots, and interpolation.

use basis_runtime::ParametricCurve;
use basis_runtime::bspline::{
    BSplineCurve, FitError, KnotError, KnotVector, Spacing, SplineError, parameters,
};
use proptest::prelude::*;

use super::support::{P3, distance, point};

/// Both ends have the same point and derivatives below that order, up to rounding errors.
fn closes(curve: &BSplineCurve<P3>, order: usize) {
    let [lo, hi] = curve.domain();
    for k in 0..order {
        let [a, b] = [lo, hi].map(|t| curve.derivative(t, k));
        let size = distance(a, [0.0; 3]).max(1.0);
        assert!(distance(a, b) < 1e-9 * size, "{k}: {a:?} {b:?}");
    }
}

proptest! {
    #[test]
    fn periodic_curves_close_smoothly(
        degree in 1..6_usize,
        steps in prop::collection::vec(0.2..1.0, 1..9),
        points in prop::collection::vec(point(), 9),
    ) {
        let mut breakpoints = vec![-1.0];
        for step in &steps {
            breakpoints.push(breakpoints[breakpoints.len() - 1] + step);
        }
        let points = &points[..steps.len()];
        let curve = BSplineCurve::periodic(degree, &breakpoints, points).unwrap();
        prop_assert_eq!(curve.domain(), [-1.0, breakpoints[steps.len()]]);
        closes(&curve, degree);
        // Where the curve begins does not matter: turned by one span it has the same points.
        let period = breakpoints[steps.len()] - breakpoints[0];
        let mut turned = breakpoints[1..].to_vec();
        turned.push(breakpoints[1] + period);
        let rotated: Vec<P3> = (0..points.len()).map(|i| points[(i + 1) % points.len()]).collect();
        let other = BSplineCurve::periodic(degree, &turned, &rotated).unwrap();
        for i in 0..20 {
            let t = breakpoints[0] + period * f64::from(i) / 20.0;
            let s = if t < breakpoints[1] { t + period } else { t };
            prop_assert!(distance(curve.eval(t), other.eval(s)) < 1e-11);
        }
    }

    #[test]
    fn closed_interpolation_passes_through_all_points(
        degree in 1..7_usize,
        points in prop::collection::vec(point(), 3..30),
    ) {
        for spacing in [Spacing::Uniform, Spacing::Chord, Spacing::Centripetal] {
            let mut around = points.clone();
            around.push(points[0]);
            let Ok(at) = parameters(&around, spacing) else { continue };
            // Uneven distances make high degrees swing.
            if degree > 3 && spacing != Spacing::Uniform {
                continue;
            }
            match BSplineCurve::interpolate_closed(degree, &points, spacing) {
                Ok(curve) => {
                    let size = curve.control_points().iter().map(|&p| distance(p, [0.0; 3])).fold(1.0, f64::max);
                    for (&t, &point) in at.iter().zip(&points) {
                        prop_assert!(distance(curve.eval(t), point) < 1e-10 * size, "{t}");
                    }
                    let [lo, hi] = curve.domain();
                    for k in 0..degree {
                        let [a, b] = [lo, hi].map(|t| curve.derivative(t, k));
                        let scale = (points.len() as f64 * 30.0).powi(k as i32) * size;
                        prop_assert!(distance(a, b) < 1e-8 * scale, "{k} {a:?} {b:?}");
                    }
                }
                Err(error) => prop_assert!(matches!(error, FitError::Undetermined { .. }), "{error}"),
            }
        }
    }
}

#[test]
fn a_circle_from_its_points() {
    // The error falls with the fourth power of the number of points.
    let error = |count: usize| {
        let points: Vec<[f64; 2]> =
            (0..count).map(|i| (std::f64::consts::TAU * i as f64 / count as f64).sin_cos().into()).collect();
        let curve = BSplineCurve::interpolate_closed(3, &points, Spacing::Chord).unwrap();
        curve.samples(500).map(|[x, y]| (x.hypot(y) - 1.0).abs()).fold(0.0, f64::max)
    };
    let [few, many] = [error(12), error(24)];
    assert!(few < 1e-3 && (few / many).log2() > 3.8, "{few} {many}");
    // As quick as its length.
    let long: Vec<[f64; 2]> =
        (0..20_000).map(|i| (f64::from(i) * std::f64::consts::TAU / 2e4).sin_cos().into()).collect();
    let curve = BSplineCurve::interpolate_closed(4, &long, Spacing::Chord).unwrap();
    assert!(distance([curve.eval(0.25)[0], 0.0, 0.0], [1.0, 0.0, 0.0]) < 1e-12);
}

#[test]
fn what_does_not_close_is_an_error() {
    assert_eq!(
        BSplineCurve::periodic(2, &[0.0, 1.0, 2.0], &[[0.0; 2]; 3]),
        Err(SplineError::Count { expected: 2, found: 3 })
    );
    assert_eq!(KnotVector::<f64>::periodic(2, &[1.0]), Err(KnotError::TooFew { found: 1, degree: 2 }));
    assert!(matches!(KnotVector::periodic(2, &[1.0, 0.0]), Err(KnotError::Decreasing { .. })));
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]];
    assert!(matches!(
        BSplineCurve::interpolate_closed(3, &corners, Spacing::Chord),
        Err(FitError::Coincide { index: 3 }) // the last and the first point
    ));
    assert!(BSplineCurve::interpolate_closed(3, &corners[..2], Spacing::Uniform).is_err());
    // Of degree 0 it jumps from one point to the next.
    assert_eq!(
        BSplineCurve::interpolate_closed(0, &corners, Spacing::Uniform).unwrap().eval(0.3),
        corners[1]
    );
}
