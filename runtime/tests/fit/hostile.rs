//! Numbers of any kind: an answer or an error, never a panic, and soon.

use basis_runtime::bspline::{KnotVector, Net};
use basis_runtime::{BernsteinBasis, Fit, FitEnd, GridEnd, GridFit};

use crate::random::Random;
use crate::{QuarticBernstein, Weighted};

fn number(random: &mut Random) -> f64 {
    match random.below(14) {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => 1e300,
        3 => -1e-300,
        4 => 5e-324,
        5 => f64::MAX,
        6..9 => 0.0,
        9..12 => 1.0,
        _ => random.wild::<f64>(),
    }
}

#[test]
fn any_numbers() {
    let mut random = Random::new(41);
    let mut answers = 0;
    for round in 0..3000 {
        let count = random.below(9);
        let rarely = |random: &mut Random| if round % 3 == 0 { number(random) } else { random.wild::<f64>() };
        let data: Vec<[f64; 2]> = (0..count).map(|_| [rarely(&mut random), rarely(&mut random)]).collect();
        let t: Vec<f64> = (0..count).map(|_| random.unit()).collect();
        let weights: Vec<f64> = (0..count).map(|_| number(&mut random)).collect();
        let mut end = || match random.below(3) {
            0 => FitEnd::Free,
            1 => FitEnd::Interpolated,
            _ => FitEnd::Tangent([number(&mut random), number(&mut random)]),
        };
        let ends = [end(), end()];
        let mut fit = Fit::new(&data).ends(ends).orthogonal(random.below(4));
        if random.below(2) == 0 {
            fit = fit.parameters(&t);
        }
        if random.below(3) == 0 {
            fit = fit.weights(&weights);
        }
        if random.below(3) == 0 {
            fit = fit.smoothing(number(&mut random));
        }
        answers += usize::from(fit.curve(BernsteinBasis::<f64, 3>::default()).is_ok());
        let tolerance = number(&mut random);
        answers += usize::from(fit.spline_within(random.below(4), tolerance).is_ok());
        answers += usize::from(fit.spline_with(random.below(4), random.below(9)).is_ok());
        if let Ok(knots) = KnotVector::clamped(2, &[number(&mut random), number(&mut random)]) {
            answers += usize::from(fit.spline(knots).is_ok());
        }
        if round % 20 == 0 {
            let ranges = [[number(&mut random), number(&mut random)], [-1.0, 1.0]];
            answers += usize::from(fit.rational_over(ranges, |[ω, κ]| Weighted::new(ω, κ)).is_ok());
            let range = [[number(&mut random), number(&mut random)]];
            answers += usize::from(fit.curve_over(range, |[λ]| QuarticBernstein::new(λ)).is_ok());
        }
        if let Ok(net) = Net::from_fn(random.below(5), random.below(5), |i, j| {
            data.get(i + j).copied().unwrap_or([1.0; 2])
        }) {
            answers += usize::from(GridFit::new(&net).spline_within([1, 2], tolerance).is_ok());
            let end = |k: usize| match k % 4 {
                0 => GridEnd::Free,
                1 => GridEnd::Interpolated,
                2 => GridEnd::Tangent(data.get(k).copied().unwrap_or([1.0, 0.0])),
                _ => GridEnd::Tangents(&data),
            };
            let ends = [(); 2].map(|()| [(); 2].map(|()| end(random.below(16))));
            let fit = GridFit::new(&net).ends(ends);
            let lambda = |[l]: [f64; 1]| QuarticBernstein::new(l);
            answers += usize::from(fit.spline_within([2, 3], tolerance).is_ok());
            answers +=
                usize::from(fit.surface_over(([[-3.0, 1.0]], [[-1.0, tolerance]]), (lambda, lambda)).is_ok());
        }
    }
    assert!(answers > 1000, "{answers}");
}

/// Points that coincide, or lie on a line, with all options.
#[test]
fn degenerate_points() {
    let same = [[2.0, 3.0]; 10];
    assert!(Fit::new(&same).curve(BernsteinBasis::<f64, 4>::default()).is_err());
    assert!(Fit::new(&same[..1]).curve(BernsteinBasis::<f64, 1>::default()).is_err());
    assert!(Fit::<[f64; 2]>::new(&[]).spline_within(3, 0.1).is_err());
    let t: Vec<f64> = (0..10).map(|i| f64::from(i) / 9.0).collect();
    let point =
        Fit::new(&same).parameters(&t).orthogonal(9).curve(BernsteinBasis::<f64, 4>::default()).unwrap();
    assert!(point.largest < 1e-14);
    let line: Vec<[f64; 3]> = (0..10).map(|i| [f64::from(i), 0.0, 1e9]).collect();
    let ends = [FitEnd::Tangent([1.0, 0.0, 0.0]); 2];
    let fit = Fit::new(&line).ends(ends).orthogonal(30).curve(BernsteinBasis::<f64, 6>::default()).unwrap();
    assert!(fit.largest < 1e-5);
    let pairs: Vec<[f64; 2]> = (0..40).map(|i| [f64::from(i / 2), f64::from(i / 2 % 3)]).collect();
    assert!(Fit::new(&pairs).spline_within(3, 1e-9).unwrap().largest <= 1e-9);
}
