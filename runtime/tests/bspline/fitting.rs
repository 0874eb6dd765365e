//! Interpolation and least squares: against scipy, through their points, and what is refused.

use basis_runtime::bspline::{
    BSplineCurve, BSplineSurface, FitError, KnotError, KnotVector, Net, Spacing, parameters,
};
use proptest::prelude::*;

use crate::golden::{assert_near, golden, knots, numbers, points};
use crate::support::{distance, point};

#[test]
fn the_same_curves_as_scipy() {
    for case in golden("fits") {
        let (t, data) = (numbers(&case["parameters"]), points::<2>(&case["data"]));
        let expected = &case["interpolating"];
        let over = knots(&case["degree"], &expected["knots"]);
        let curve = BSplineCurve::interpolate_at(over, &t, &data).unwrap();
        assert_near(curve.control_points(), &points::<2>(&expected["points"]), 1e-10);

        let expected = &case["least_squares"];
        let over = knots(&case["degree"], &expected["knots"]);
        let curve = BSplineCurve::fit(over, &t, &data, Some(&numbers(&case["weights"]))).unwrap();
        assert_near(curve.control_points(), &points::<2>(&expected["points"]), 1e-10);
    }
}

#[test]
fn each_mistake_has_its_error() {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0]];
    let through = |degree, spacing| BSplineCurve::interpolate(degree, &points, spacing);
    assert_eq!(through(3, Spacing::Chord), Err(FitError::Coincide { index: 2 }));
    assert!(through(3, Spacing::Uniform).is_ok());
    assert_eq!(through(4, Spacing::Uniform), Err(FitError::TooFew { needed: 5, found: 4 }));
    assert_eq!(through(usize::MAX, Spacing::Uniform), Err(FitError::TooFew { needed: usize::MAX, found: 4 }));
    assert_eq!(parameters(&[[1.0]], Spacing::Chord), Err(FitError::TooFew { needed: 2, found: 1 }));
    let broken = [[0.0], [f64::NAN], [1.0]];
    assert_eq!(parameters(&broken, Spacing::Centripetal), Err(FitError::NotFinite { index: 1 }));
    assert_eq!(parameters(&[[f64::NAN]; 3], Spacing::Chord), Err(FitError::NotFinite { index: 0 }));
    assert_eq!(parameters(&broken, Spacing::Uniform), Err(FitError::NotFinite { index: 1 }));
    let uniform = BSplineCurve::interpolate(1, &broken, Spacing::Uniform);
    assert_eq!(uniform, Err(FitError::NotFinite { index: 1 }));

    let over = KnotVector::clamped(1, &[0.0, 0.5, 1.0]).unwrap();
    let through = BSplineCurve::interpolate_at(over, &[0.0, 0.2, 0.5, 1.0], &points).unwrap_err();
    assert_eq!(through, FitError::Functions { functions: 3, points: 4 });
    assert!(through.to_string().starts_with("4 points; a curve over these knots passes through 3"));

    // All parameters are in the first span: the last function is nowhere.
    let over = KnotVector::clamped(1, &[0.0, 0.5, 1.0]).unwrap();
    let fit = BSplineCurve::fit(over.clone(), &[0.0, 0.1, 0.2, 0.3], &points, None);
    assert_eq!(fit, Err(FitError::Undetermined { function: 2 }));
    let fit = BSplineCurve::fit(over.clone(), &[0.0, 0.1, 0.2], &points, None);
    assert_eq!(fit, Err(FitError::Count { expected: 4, found: 3 }));
    let fit = BSplineCurve::fit(over.clone(), &[0.0, 0.1, 0.2, 1.5], &points, None);
    assert!(matches!(fit, Err(FitError::Knots(KnotError::Outside { .. }))));
    let fit = BSplineCurve::fit(over, &[0.0, 0.1, 0.2, f64::NAN], &points, None);
    assert_eq!(fit, Err(FitError::NotFinite { index: 3 }));
}

#[test]
fn the_point_of_a_grid_that_is_not_finite() {
    let mut grid = Net::from_fn(4, 5, |i, j| [i as f64, j as f64]).unwrap();
    grid[[2, 3]][1] = f64::NAN;
    for spacing in [Spacing::Uniform, Spacing::Chord] {
        let surface = BSplineSurface::interpolate([2, 2], &grid, spacing);
        assert_eq!(surface.unwrap_err(), FitError::NotFinite { index: 2 * 5 + 3 });
    }
    let knots = KnotVector::uniform(1, 1).unwrap();
    let near = [0.0, 0.2, 0.5, 0.8, 1.0];
    let surface = BSplineSurface::fit([knots.clone(), knots], [&near[1..], &near], &grid);
    assert_eq!(surface.unwrap_err(), FitError::NotFinite { index: 2 * 5 + 3 });
}

#[test]
fn heavy_weights_pin_points() {
    let t: Vec<f64> = (0..40).map(|i| f64::from(i) / 39.0).collect();
    let points: Vec<[f64; 1]> = t.iter().map(|x| [(5.0 * x).sin()]).collect();
    for weight in [1e6, 1e14, 1e20, 1e100] {
        let mut weights = vec![1.0; 40];
        for pinned in [0, 20, 39] {
            weights[pinned] = weight;
        }
        let knots = KnotVector::uniform(3, 6).unwrap();
        let curve = BSplineCurve::fit(knots, &t, &points, Some(&weights)).unwrap();
        for pinned in [0, 20, 39] {
            assert!((curve.eval(t[pinned])[0] - points[pinned][0]).abs() < 1e-11);
        }
        assert!(t.iter().zip(&points).all(|(&t, p)| (curve.eval(t)[0] - p[0]).abs() < 2e-3));
    }
}

#[test]
fn a_grid_with_a_pole() {
    // The first row is one point; its parameters come from the other rows.
    let grid = Net::from_fn(4, 5, |i, j| [i as f64 * (j as f64 - 2.0), i as f64, 0.0]).unwrap();
    let surface = BSplineSurface::interpolate([3, 2], &grid, Spacing::Chord).unwrap();
    assert!(distance(surface.eval(0.0, 0.3), [0.0; 3]) < 1e-14);
    assert!(distance(surface.eval(1.0, 0.5), [0.0, 3.0, 0.0]) < 1e-14);
}

proptest! {
    #[test]
    fn curves_pass_through_their_points(
        degree in 1..=5_usize,
        points in prop::collection::vec(point(), 6..30),
        spacing in prop_oneof![Just(Spacing::Uniform), Just(Spacing::Chord), Just(Spacing::Centripetal)],
    ) {
        let t = parameters(&points, spacing).unwrap();
        let curve = BSplineCurve::interpolate(degree, &points, spacing).unwrap();
        let size = curve.control_points().iter().flatten().fold(1.0, |a: f64, x| a.max(x.abs()));
        for (&t, &point) in t.iter().zip(&points) {
            prop_assert!(distance(curve.eval(t), point) < 1e-12 * size);
        }
    }

    #[test]
    fn surfaces_pass_through_their_points(
        degrees in [1..=4_usize, 1..=4_usize],
        raw in prop::collection::vec(point(), 7 * 6),
    ) {
        let grid = Net::from_fn(7, 6, |i, j| raw[i * 6 + j]).unwrap();
        let surface = BSplineSurface::interpolate(degrees, &grid, Spacing::Uniform).unwrap();
        let size = surface.net().as_slice().iter().flatten().fold(1.0, |a: f64, x| a.max(x.abs()));
        for i in 0..7 {
            for j in 0..6 {
                let found = surface.eval(i as f64 / 6.0, j as f64 / 5.0);
                prop_assert!(distance(found, grid[[i, j]]) < 1e-12 * size);
            }
        }
    }

    #[test]
    fn a_curve_of_the_space_is_found_again(curve in crate::support::curve_of(3)) {
        let t: Vec<f64> = (0..=200).map(|i| f64::from(i) / 200.0).collect();
        let points: Vec<_> = t.iter().map(|&t| curve.eval(t)).collect();
        if let Ok(found) = BSplineCurve::fit(curve.knots().clone(), &t, &points, None) {
            prop_assert!(crate::support::largest_distance(&found, &curve) < 1e-10);
        }
    }
}

/// The order of the points does not matter.
#[test]
fn parameters_of_any_order() {
    for case in golden("fits") {
        let (t, data) = (numbers(&case["parameters"]), points::<2>(&case["data"]));
        let over = knots(&case["degree"], &case["least_squares"]["knots"]);
        let expected = BSplineCurve::fit(over.clone(), &t, &data, None).unwrap();
        for (step, shift) in [(7, 0), (19, 5), (3, 1)] {
            let order: Vec<usize> = (0..t.len()).map(|i| (step * i + shift) % t.len()).collect();
            let mixed: Vec<f64> = order.iter().map(|&i| t[i]).collect();
            let points: Vec<[f64; 2]> = order.iter().map(|&i| data[i]).collect();
            let curve = BSplineCurve::fit(over.clone(), &mixed, &points, None).unwrap();
            assert_near(curve.control_points(), expected.control_points(), 1e-10);
        }
    }
}
