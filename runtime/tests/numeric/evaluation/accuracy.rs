//! Rounding errors of curves in `f32`, measured against `f64`, in units of ε times the largest control point.
//!
//! `cargo test -p basis-runtime --test numeric accuracy -- --nocapture` prints them.

use basis_runtime::{BernsteinForm, Curve, EndpointForm, Form};
use basis_test_support::cases;

use crate::families::{QuarticBernstein, UniformCubic};
use crate::random::Random;
use crate::reference::{de_casteljau, evaluate, quartic, uniform_cubic};

const ROUNDS: usize = 20_000;

/// Control points around zero, alternating ones, or a small curve far from the origin.
fn control_points<const N: usize>(round: usize, random: &mut Random) -> [f32; N] {
    core::array::from_fn(|k| match round % 3 {
        0 => random.between(-1.0, 1.0),
        1 => random.between::<f32>(0.8, 1.0) * if k % 2 == 0 { 1.0 } else { -1.0 },
        _ => random.between(9.0, 11.0),
    })
}

/// Uniform, or close to one end.
fn parameter(round: usize, random: &mut Random) -> f32 {
    let distance: f32 = random.between(0.0, if round % 4 < 2 { 1.0 } else { 0.1 });
    if round % 4 == 3 { 1.0 - distance } else { distance }
}

fn error(value: f32, exact: f64, points: &[f64]) -> f64 {
    let largest = points.iter().fold(0.0, |largest: f64, p| largest.max(p.abs()));
    (f64::from(value) - exact).abs() / largest / f64::from(f32::EPSILON)
}

#[test]
fn of_the_quartic_curve() {
    let random = &mut Random::new(41);
    let mut worst = 0.0_f64;
    for round in 0..cases(ROUNDS) {
        let lambda: f32 = random.between(-3.0, 1.0);
        let points: [f32; 4] = control_points(round, random);
        let t = parameter(round, random);
        let value = Curve::new(QuarticBernstein::new(lambda).unwrap(), points).eval(t);
        let points = points.map(f64::from);
        let functions = quartic(lambda.into());
        let exact = functions.iter().zip(points).map(|(b, p)| evaluate(b, t.into()) * p).sum();
        worst = worst.max(error(value, exact, &points));
    }
    println!("QuarticBernstein: {worst:.2} ε");
    assert!(worst < 2.0);
}

#[test]
fn of_the_cubic_spline_segment() {
    let random = &mut Random::new(42);
    let mut worst = 0.0_f64;
    for round in 0..cases(ROUNDS) {
        let points: [f32; 4] = control_points(round, random);
        let t = parameter(round, random);
        let value = Curve::new(UniformCubic::new(), points).eval(t);
        let points = points.map(f64::from);
        let exact = uniform_cubic().iter().zip(points).map(|(b, p)| evaluate(b, t.into()) * p).sum();
        worst = worst.max(error(value, exact, &points));
    }
    println!("UniformCubic: {worst:.2} ε");
    assert!(worst < 2.5); // its ends are rounded averages
}

/// The weights of the control points of a Bézier curve of degree `N - 1 = R + 1` in the inner coefficients of its
/// endpoint form: `C - chord = s x R`, divided in the Bernstein basis, then rewritten in powers of `y`.
fn inner_weights<const N: usize, const R: usize>() -> [[f32; N]; R] {
    let n = N - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
    let mut weights = [[0.0; N]; R];
    for j in 0..R {
        let quotient = binomial(n, j + 1) / binomial(n - 2, j);
        let chord = (j + 1) as f64 / n as f64;
        // binomial(n-2, j) s^(n-2-j) x^j in powers of y.
        let mut function = vec![binomial(n - 2, j)];
        for factor in 0..n - 2 {
            let slope = if factor < j { 0.5 } else { -0.5 };
            function = crate::reference::product(&function, &[0.5, slope]);
        }
        for (k, c) in function.into_iter().enumerate() {
            weights[k][j + 1] += c * quotient;
            weights[k][0] -= c * quotient * (1.0 - chord);
            weights[k][n] -= c * quotient * chord;
        }
    }
    weights.map(|row| row.map(|w| w as f32))
}

/// The largest errors of both forms at degree `N - 1`: of points, and of first derivatives in units of ε times twice
/// the degree times the largest control point, which bounds the derivative.
fn both_forms<const N: usize, const R: usize>() -> [[f64; 2]; 2] {
    let random = &mut Random::new(43);
    let weights = inner_weights::<N, R>();
    let mut worst = [[0.0_f64; 2]; 2];
    for round in 0..cases(ROUNDS) {
        let points: [f32; N] = control_points(round, random);
        let x = parameter(round, random);
        let inner = weights.map(|row| basis_runtime::__private::combine(&points, row));
        let endpoint = EndpointForm::new([points[0], points[N - 1]], inner).eval_with_derivs::<2>(x);
        let bernstein = BernsteinForm::new(points).eval_with_derivs::<2>(x);
        let points = points.map(f64::from);
        let slope = 2.0 * (N - 1) as f64;
        let differences: Vec<f64> = points.windows(2).map(|p| (N - 1) as f64 * (p[1] - p[0])).collect();
        let exact = [de_casteljau(&points, x.into()), de_casteljau(&differences, x.into())];
        for (worst, [point, velocity]) in worst.iter_mut().zip([endpoint, bernstein]) {
            worst[0] = worst[0].max(error(point, exact[0], &points));
            worst[1] = worst[1].max(error(velocity, exact[1], &points.map(|p| slope * p)));
        }
    }
    let [endpoint, bernstein] = worst;
    println!(
        "degree {:2}: points {:6.2} ε in endpoint form, {:5.2} ε in Bernstein form; derivatives {:6.2} ε, {:5.2} ε",
        N - 1,
        endpoint[0],
        bernstein[0],
        endpoint[1],
        bernstein[1]
    );
    worst
}

#[test]
fn of_both_forms_by_degree() {
    both_forms::<2, 0>();
    both_forms::<3, 1>();
    both_forms::<4, 2>();
    both_forms::<5, 3>();
    both_forms::<6, 4>();
    both_forms::<7, 5>();
    both_forms::<9, 7>();
    both_forms::<11, 9>();
    let [endpoint, bernstein] = both_forms::<13, 11>();
    assert!(endpoint[0] < 4.0 && bernstein[0] < 6.5);
    both_forms::<15, 13>();
    both_forms::<17, 15>();
    both_forms::<21, 19>();
    let [_, bernstein] = both_forms::<31, 29>();
    assert!(bernstein[0] < 12.0);
}
