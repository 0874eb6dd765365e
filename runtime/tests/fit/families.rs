//! Curves over families: given parameters, ends, shape values, smoothing.

use basis_runtime::bspline::{FitError, Spacing};
use basis_runtime::{
    BernsteinBasis, Bezier, Curve, Fit, FitEnd, ParametricCurve, RationalCurve, SpannedBasis, SpannedCurve,
};

use crate::random::Random;
use crate::{QuarticBernstein, Spans, Turning, Weighted, distance};

fn points<const D: usize>(random: &mut Random, count: usize) -> Vec<[f64; D]> {
    (0..count).map(|_| core::array::from_fn(|_| random.between::<f64>(-3.0, 5.0))).collect()
}

fn parameters(random: &mut Random, count: usize, [lo, hi]: [f64; 2]) -> Vec<f64> {
    (0..count).map(|_| random.between::<f64>(lo, hi)).collect()
}

/// The sum that is to be minimised.
fn sum<const D: usize>(
    curve: &impl ParametricCurve<Point = [f64; D]>,
    points: &[[f64; D]],
    t: &[f64],
    weights: &[f64],
) -> f64 {
    (0..points.len()).map(|i| (weights[i] * distance(curve.eval(t[i]), points[i])).powi(2)).sum()
}

/// The least squares are least: the sum is stationary in every component of every control point, and the residuals are those that
/// the answer says.
#[test]
fn the_sum_is_stationary() {
    let mut random = Random::new(1);
    for round in 0..30 {
        let count = 5 + round;
        let (t, points) = (parameters(&mut random, count, [0.0, 1.0]), points::<3>(&mut random, count));
        let weights: Vec<f64> = (0..count).map(|_| random.between::<f64>(0.1, 2.0)).collect();
        let basis = QuarticBernstein::new(random.between::<f64>(-2.5, 1.0)).unwrap();
        let fit = Fit::new(&points).parameters(&t).weights(&weights).curve(basis).unwrap();
        let best = sum(&fit.curve, &points, &t, &weights);
        for i in 0..4 {
            for d in 0..3 {
                let mut changed = <[_; 4]>::try_from(fit.curve.control_points()).unwrap();
                let value = |change: f64, changed: &mut [[f64; 3]; 4]| {
                    changed[i][d] += change;
                    let value = sum(&Curve::new(basis, *changed), &points, &t, &weights);
                    changed[i][d] -= change;
                    value
                };
                let [up, down] = [1e-3, -1e-3].map(|change| value(change, &mut changed));
                assert!(up >= best && down >= best && (up - down).abs() <= 1e-9 * best, "{up} {best} {down}");
            }
        }
        let distances: Vec<f64> = (0..count).map(|i| distance(fit.curve.eval(t[i]), points[i])).collect();
        let largest = distances.iter().copied().fold(0.0, f64::max);
        let mean = (distances.iter().map(|d| d * d).sum::<f64>() / count as f64).sqrt();
        assert!((fit.largest - largest).abs() < 1e-13 && (fit.root_mean_square - mean).abs() < 1e-13);
        assert_eq!((fit.parameters, fit.rounds), (t, 0));
    }
}

/// Points of a curve give the curve back, over families of all kinds and with shape values.
#[test]
fn curves_come_back() {
    let mut random = Random::new(2);
    for _ in 0..20 {
        let t = parameters(&mut random, 40, [0.0, 1.0]);
        let λ = random.between::<f64>(-2.9, 1.0);
        let given = points::<2>(&mut random, 4).try_into().unwrap();
        let curve = Curve::new(QuarticBernstein::new(λ).unwrap(), given);
        let data: Vec<[f64; 2]> = t.iter().map(|&t| curve.eval(t)).collect();
        let fit = Fit::new(&data).parameters(&t).curve_over([[-3.0, 1.0]], |[λ]| QuarticBernstein::new(λ));
        let fit = fit.unwrap();
        assert!((fit.curve.basis().lambda() - λ).abs() < 1e-7, "{λ}: {:?}", fit.curve);
        assert!(fit.largest < 1e-10, "{λ}: {}", fit.largest);

        let t = parameters(&mut random, 40, [0.0, 2.0]);
        let family =
            Weighted::new(random.between::<f64>(0.2, 4.0), random.between::<f64>(-0.9, 0.9)).unwrap();
        let curve = family.curve(points::<2>(&mut random, 3).try_into().unwrap());
        let data: Vec<[f64; 2]> = t.iter().map(|&t| curve.eval(t)).collect();
        let fit = Fit::new(&data).parameters(&t).rational(family).unwrap();
        assert!(fit.largest < 1e-12);
        let ranges = [[0.1, 5.0], [-1.0, 1.0]];
        let fit = Fit::new(&data).parameters(&t).rational_over(ranges, |[ω, κ]| Weighted::new(ω, κ)).unwrap();
        assert!(fit.largest < 1e-8, "{} {:?} {family:?}", fit.largest, fit.curve.basis());

        let family = Turning::new(2.0).unwrap();
        let curve = family.curve(points::<2>(&mut random, 3).try_into().unwrap());
        let data: Vec<[f64; 2]> = t.iter().map(|&t| curve.eval(t)).collect();
        let fit = Fit::new(&data).parameters(&t).rational(family).unwrap();
        assert!(fit.largest < 1e-12);
        // With the angle as an unknown the parameters go with the domain.
        let data: Vec<[f64; 2]> = (0..30).map(|i| curve.eval(2.0 * f64::from(i) / 29.0)).collect();
        let fit =
            Fit::new(&data).spacing(Spacing::Uniform).rational_over([[0.1, 3.0]], |[φ]| Turning::new(φ));
        assert!(fit.unwrap().largest < 1e-8);

        let family = Spans::new(random.between::<f64>(0.3, 3.0)).unwrap();
        let t = parameters(&mut random, 40, family.domain());
        let curve = family.curve(points::<2>(&mut random, 4).try_into().unwrap());
        let data: Vec<[f64; 2]> = t.iter().map(|&t| curve.eval(t)).collect();
        let fit = Fit::new(&data).parameters(&t).spanned(family).unwrap();
        assert!(fit.largest < 1e-12);
        let fit = Fit::new(&data).parameters(&t).spanned_over([[0.25, 4.0]], |[d]| Spans::new(d)).unwrap();
        assert!(fit.largest < 1e-8, "{}", fit.largest);
    }
}

/// Both ends are the first and the last point to the last bit, and the directions are those that were given.
#[test]
fn ends_are_as_asked_for() {
    let mut random = Random::new(3);
    for _ in 0..50 {
        let data = points::<3>(&mut random, 12);
        let [first, last] = [data[0], data[11]];
        let free = Fit::new(&data).curve(BernsteinBasis::<f64, 6>::default()).unwrap();
        let through = Fit::new(&data).ends([FitEnd::Interpolated; 2]);
        let through = through.curve(BernsteinBasis::<f64, 6>::default()).unwrap();
        assert_eq!([through.curve.start(), through.curve.end()], [first, last]);
        assert!(through.root_mean_square >= free.root_mean_square * (1.0 - 1e-12));

        let directions: [[f64; 3]; 2] = points(&mut random, 2).try_into().unwrap();
        let ends = directions.map(FitEnd::Tangent);
        let along = Fit::new(&data).ends(ends).curve(BernsteinBasis::<f64, 6>::default()).unwrap();
        assert_eq!([along.curve.start(), along.curve.end()], [first, last]);
        for (t, direction) in [0.0, 1.0].into_iter().zip(directions) {
            let tangent = along.curve.tangent(t).unwrap();
            let size = distance(direction, [0.0; 3]);
            assert!(distance(tangent, direction.map(|x| x / size)) < 1e-9, "{tangent:?} {direction:?}");
        }
        assert!(along.root_mean_square >= through.root_mean_square * (1.0 - 1e-12));
        // One end only.
        let one = Fit::new(&data).ends([FitEnd::Free, FitEnd::Tangent(directions[1])]);
        let one = one.curve(BernsteinBasis::<f64, 6>::default()).unwrap();
        assert!(one.curve.end() == last && one.root_mean_square <= along.root_mean_square * (1.0 + 1e-12));
    }
}

/// With smoothing the least change of any control point makes the sum and the integral together larger; with very much of it
/// the curve is a straight line.
#[test]
fn smoothing_is_exact() {
    let mut random = Random::new(4);
    let (data, t) = (points::<2>(&mut random, 9), parameters(&mut random, 9, [0.0, 1.0]));
    let energy = |curve: &Bezier<[f64; 2], 5>| {
        // |C''|² has the degree 4: Boole's rule is exact up to 5.
        let square = |t: f64| distance(curve.derivative(t, 2), [0.0; 2]).powi(2);
        let rule = [(0.0, 7.0), (0.25, 32.0), (0.5, 12.0), (0.75, 32.0), (1.0, 7.0)];
        rule.into_iter().map(|(t, weight)| weight * square(t)).sum::<f64>() / 90.0
    };
    for λ in [1e-4, 1e-2, 1.0] {
        let fit =
            Fit::new(&data).parameters(&t).smoothing(λ).curve(BernsteinBasis::<f64, 5>::default()).unwrap();
        let value = |curve: &Bezier<[f64; 2], 5>| sum(curve, &data, &t, &[1.0; 9]) + λ * energy(curve);
        let best = value(&fit.curve);
        for i in 0..5 {
            let change = |by: f64| {
                let mut points = <[_; 5]>::try_from(fit.curve.control_points()).unwrap();
                points[i][0] += by;
                value(&Curve::new(BernsteinBasis::default(), points))
            };
            let [up, down] = [change(1e-3), change(-1e-3)];
            assert!(up >= best && down >= best && (up - down).abs() <= 1e-9 * best, "{up} {best} {down}");
        }
    }
    let fit =
        Fit::new(&data).parameters(&t).smoothing(1e12).curve(BernsteinBasis::<f64, 5>::default()).unwrap();
    assert!(energy(&fit.curve) < 1e-12);
}

#[test]
fn what_cannot_be_is_an_error() {
    let data = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
    let basis = BernsteinBasis::<f64, 4>::default();
    let error = |fit: Fit<'_, [f64; 2]>| fit.curve(basis).unwrap_err();
    assert_eq!(error(Fit::new(&data)), FitError::TooFew { needed: 4, found: 3 });
    let basis = BernsteinBasis::<f64, 3>::default();
    let error = |fit: Fit<'_, [f64; 2]>| fit.curve(basis).unwrap_err();
    let line = [FitEnd::Tangent([1.0, 0.0]); 2];
    assert_eq!(error(Fit::new(&data).ends(line)), FitError::Ends);
    let zero = [FitEnd::Free, FitEnd::Tangent([0.0; 2])];
    assert_eq!(error(Fit::new(&data).ends(zero)), FitError::Tangent { end: 1 });
    assert_eq!(error(Fit::new(&data).smoothing(-1.0)), FitError::Smoothing { value: -1.0 });
    let outside = error(Fit::new(&data).parameters(&[0.0, 0.5, 2.5]));
    assert_eq!(outside, FitError::Outside { index: 2, parameter: 2.5, domain: [0.0, 1.0] });
    assert_eq!(outside.to_string(), "parameter 2, 2.5, is outside of the domain 0 <= t <= 1");
    assert_eq!(error(Fit::new(&data).parameters(&[0.0])), FitError::Count { expected: 3, found: 1 });
    assert_eq!(error(Fit::new(&data).weights(&[1.0])), FitError::Count { expected: 3, found: 1 });
    let family = |[λ]: [f64; 1]| QuarticBernstein::new(λ);
    let far = Fit::new(&data).smoothing(0.1).curve_over([[5.0, 9.0]], family);
    assert_eq!(far.unwrap_err(), FitError::Shapes);
    let empty = Fit::new(&data).smoothing(0.1).curve_over([[1.0, 1.0]], family);
    assert_eq!(empty.unwrap_err(), FitError::Range { index: 0, range: [1.0, 1.0] });
    // Where a part of the range has no family, the rest is searched.
    let wide = Fit::new(&data).smoothing(0.1).curve_over([[-20.0, 9.0]], family).unwrap();
    assert!(wide.curve.basis().lambda() >= -3.0);
}

/// A curve over each kind of family has the same type whether its shape values are given or found.
#[test]
fn types() {
    let data: Vec<[f32; 2]> = (0..20).map(|i| [i as f32, (i as f32 * 0.3).sin()]).collect();
    let fit = Fit::new(&data).ends([FitEnd::Interpolated; 2]).curve(BernsteinBasis::<f32, 6>::default());
    let fit: Bezier<[f32; 2], 6> = fit.unwrap().curve;
    assert!(fit.start() == data[0] && fit.end() == data[19]);
    let numbers: Vec<f64> = (0..9).map(|i| f64::from(i * i)).collect();
    let t: Vec<f64> = (0..9).map(|i| f64::from(i) / 8.0).collect();
    let parabola = Fit::new(&numbers).parameters(&t).curve(BernsteinBasis::<f64, 3>::default()).unwrap();
    assert!((parabola.curve.control_points()[2] - 64.0).abs() < 1e-12 && parabola.largest < 1e-12);
    let data: Vec<[f64; 2]> = data.iter().map(|p| p.map(f64::from)).collect();
    let rational: RationalCurve<Turning, [f64; 2]> =
        Fit::new(&data).rational(Turning::new(2.0).unwrap()).unwrap().curve;
    let spanned: SpannedCurve<Spans, [f64; 2]> =
        Fit::new(&data).spanned(Spans::new(1.0).unwrap()).unwrap().curve;
    assert!(rational.domain()[1] == 2.0 && spanned.domain()[1] == 2.0);
}

/// Directions in single precision have the length 1 up to its rounding errors only, which is no reason to refuse them.
#[test]
fn directions_at_the_ends_in_single_precision() {
    for k in 0..50 {
        let turn = k as f32 * 0.13;
        let along = [turn.cos(), turn.sin()];
        let points: Vec<[f32; 2]> = (0..=10).map(|i| along.map(|c| c * i as f32)).collect();
        let fit =
            Fit::new(&points).ends([FitEnd::Tangent(along); 2]).curve(BernsteinBasis::<f32, 4>::default());
        assert!(fit.unwrap().largest < 1e-5, "{turn}");
    }
}
