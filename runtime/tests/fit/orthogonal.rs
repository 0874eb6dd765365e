//! Parameters as unknowns: distances from the curve.

use basis_runtime::bspline::KnotVector;
use basis_runtime::{BernsteinBasis, Bezier, Fit, FitEnd, ParametricCurve};
use basis_test_support::cases;

use crate::random::Random;
use crate::{QuarticBernstein, Spans, Weighted, distance};

/// Points of a Bézier curve at parameters that nobody knows give the curve back.
#[test]
fn curves_come_back_without_their_parameters() {
    let mut random = Random::new(11);
    let mut found = 0;
    for _ in 0..40 {
        let x = |k: usize, random: &mut Random| k as f64 + random.between::<f64>(-0.3, 0.3);
        let control = core::array::from_fn(|k| [x(k, &mut random), random.between::<f64>(-1.0, 1.0)]);
        let curve: Bezier<[f64; 2], 4> = Bezier::from_points(control);
        let mut t: Vec<f64> = (0..28).map(|_| random.between::<f64>(0.0, 1.0)).chain([0.0, 1.0]).collect();
        t.sort_by(f64::total_cmp);
        let data: Vec<[f64; 2]> = t.iter().map(|&t| curve.eval(t)).collect();
        let before = Fit::new(&data).curve(BernsteinBasis::<f64, 4>::default()).unwrap();
        let fit = Fit::new(&data).orthogonal(50).curve(BernsteinBasis::<f64, 4>::default()).unwrap();
        assert!(fit.root_mean_square <= before.root_mean_square);
        found += usize::from(fit.largest < 1e-10);
    }
    assert!(found >= 38, "{found} of 40");
}

/// A circle's arc is found as a rational curve with its weight, and the points are on it.
#[test]
fn an_arc_with_its_weight() {
    for angle in [0.5_f64, 1.5, 2.2] {
        let data: Vec<[f64; 2]> =
            (0..=24).map(|i| angle * f64::from(i) / 24.0).map(|a| [a.cos(), a.sin()]).collect();
        let family = |[ω]: [f64; 1]| Weighted::new(ω, 0.0);
        let fit = Fit::new(&data).orthogonal(60).rational_over([[0.1, 5.0]], family).unwrap();
        let ω = fit.curve.basis().omega();
        assert!((ω - (angle / 2.0).cos()).abs() < 1e-6, "{angle}: {ω}");
        for p in fit.curve.samples(50) {
            assert!((p[0].hypot(p[1]) - 1.0).abs() < 1e-9);
        }
    }
}

/// Noisy points: the distances are those of the nearest points of the curve, no round makes the sum larger, and the ends stay.
#[test]
fn distances_are_orthogonal() {
    let mut random = Random::new(12);
    for _ in 0..cases(20) {
        let a = random.between::<f64>(0.5, 2.0);
        let data: Vec<[f64; 3]> = (0..60)
            .map(|i| f64::from(i) / 59.0 * 4.0)
            .map(|s| [s, (a * s).sin(), 0.3 * s * s].map(|c: f64| c + random.between::<f64>(-0.05, 0.05)))
            .collect();
        let ends = [FitEnd::Interpolated, FitEnd::Tangent([1.0, 0.0, 2.0])];
        let knots = || KnotVector::uniform(3, 4).unwrap();
        let mut last = f64::INFINITY;
        for rounds in [0, 1, 2, 5, 60] {
            let fit = Fit::new(&data).ends(ends).orthogonal(rounds).spline(knots()).unwrap();
            assert!(fit.root_mean_square <= last * (1.0 + 1e-12) && fit.rounds <= rounds);
            last = fit.root_mean_square;
            assert_eq!([fit.curve.eval(0.0), fit.curve.eval(1.0)], [data[0], data[59]]);
            if rounds == 60 {
                for (&t, &p) in fit.parameters.iter().zip(&data) {
                    let there = distance(fit.curve.eval(t), p);
                    let nearest = fit.curve.nearest(p, 1e-9).unwrap();
                    assert!(there - nearest.distance < 1e-6, "{t}: {there} {}", nearest.distance);
                }
            }
        }
    }
}

/// Shape values and parameters at once, also where the domain depends on the shape value.
#[test]
fn shape_values_and_parameters() {
    let basis = QuarticBernstein::new(-1.5).unwrap();
    let given = basis_runtime::Curve::new(basis, [[0.0_f64, 0.0], [1.0, 2.5], [3.0, 2.0], [4.0, 0.5]]);
    let data: Vec<[f64; 2]> = (0..=40).map(|i| given.eval((f64::from(i) / 40.0).powf(1.2))).collect();
    let fit =
        Fit::new(&data).orthogonal(200).curve_over([[-3.0, 1.0]], |[λ]| QuarticBernstein::new(λ)).unwrap();
    assert!(fit.largest < 1e-6, "{} {:?}", fit.largest, fit.curve);

    let given = Spans::new(2.5).unwrap().curve([[0.0_f64, 0.0], [1.0, 2.5], [3.0, 2.0], [4.0, -1.5]]);
    let data: Vec<[f64; 2]> = given.samples(41).collect();
    let family = |[d]: [f64; 1]| Spans::new(d);
    let free = Fit::new(&data).spanned_over([[0.25, 4.0]], family).unwrap();
    let fit = Fit::new(&data).orthogonal(200).spanned_over([[0.25, 4.0]], family).unwrap();
    assert!(fit.largest < 1e-6 && fit.largest < free.largest, "{} {:?}", fit.largest, fit.curve);
}
