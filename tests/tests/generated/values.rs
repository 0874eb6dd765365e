//! Values, derivatives and coefficients of generated types against the exact fractions of their specs.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_runtime::Scalar;
use basis_tests::each_family;
use basis_tests::exact::{epsilon, fraction, fractions, largest};
use basis_tests::families::{
    Cardinal, CubicBSpline, CubicHermite, QuadraticBezier, QuarticBernstein, SaidBall, Shipped, Tenths,
};
use basis_tests::random::Random;

/// Where no step of a formula rounds, the floats are the fractions.
fn are_exact<B: Shipped<Scalar = f64>>(shapes: impl Iterator<Item = Vec<f64>>) {
    let reference = B::reference();
    for shape in shapes {
        let (basis, exact) = (B::with(&shape).expect("inside the range"), reference.at(&shape));
        for t in (0..=8).map(|k| f64::from(k) / 8.0) {
            let expected = exact.values(&fraction(t));
            assert_eq!(fractions(basis.values(t)), expected, "{} at {shape:?}, {t}", B::NAME);
        }
        let rows: Vec<Vec<Rational>> = basis.coefficients().iter().map(fractions).collect();
        assert_eq!(rows, exact.coefficients, "{} at {shape:?}", B::NAME);
    }
}

#[test]
fn are_exact_where_no_step_rounds() {
    let quarters = |low: i32, high: i32| (4 * low..=4 * high).map(|k| vec![f64::from(k) / 4.0]);
    are_exact::<QuadraticBezier>(quarters(-2, 1));
    are_exact::<QuarticBernstein>(quarters(-3, 1));
    are_exact::<CubicHermite>([vec![]].into_iter());
    are_exact::<SaidBall>([vec![]].into_iter());
}

fn near(actual: &[Rational], expected: &[Rational], tolerance: f64, what: impl Fn() -> String) {
    assert_eq!(actual.len(), expected.len(), "{}", what());
    for (i, (a, e)) in actual.iter().zip(expected).enumerate() {
        let error = (a - e).to_f64().abs();
        assert!(
            error <= tolerance,
            "{}, entry {i}: {} for {}, off by {error}",
            what(),
            a.to_f64(),
            e.to_f64()
        );
    }
}

/// k-th derivatives come from k-th differences of the Bernstein coefficients c: they are at most
/// 2ᵏ n!/(n − k)! max|c| / wᵏ on an interval of width w, and so is, times a few ε, what rounding adds. Where terms of
/// c cancel, as 1 − τ does, max|c| is that without cancellation.
fn derivatives<B: Shipped>() {
    let (reference, random, n) = (B::reference(), &mut Random::new(5), B::DEGREE);
    let [lo, hi] = B::domain().map(Scalar::to_f64);
    for shape in reference.shapes::<B::Scalar>(5, random) {
        let (basis, exact) = (B::with(&shape).expect("inside the range"), reference.at(&shape));
        let bernstein = exact.bernstein_coefficients();
        let size = bernstein.iter().flatten().map(|c| c.to_f64().abs()).fold(1.0, f64::max);
        for _ in 0..6 {
            let t = B::Scalar::of(lo + (hi - lo) * random.unit::<f64>());
            let mut bound = size;
            for order in 0..=n + 2 {
                if bound > largest::<B::Scalar>() {
                    break; // derivatives of high order leave the range of f32
                }
                let expected = exact.derivatives(&fraction(t), order);
                let actual = fractions(basis.derivatives(t, order));
                let tolerance = epsilon::<B::Scalar>() * (4 + 2 * n) as f64 * bound;
                near(&actual, &expected, tolerance, || {
                    format!("{} {shape:?}, order {order} at {t}", B::NAME)
                });
                bound *= 2.0 * n.saturating_sub(order) as f64 / (hi - lo);
            }
            assert_eq!(basis.derivatives(t, 0), basis.values(t));
        }
    }
}

#[test]
fn have_derivatives_of_every_order() {
    each_family!(f64, derivatives);
    each_family!(f32, derivatives);
}

fn coefficients<B: Shipped>() {
    let reference = B::reference();
    for shape in reference.shapes::<B::Scalar>(12, &mut Random::new(6)) {
        let (basis, exact) = (B::with(&shape).expect("inside the range"), reference.at(&shape));
        let [lo, hi] = B::domain().map(Scalar::to_f64);
        let reach = lo.abs().max(hi.abs()).max(1.0).powi(B::DEGREE as i32);
        let check = |actual: Vec<Vec<B::Scalar>>, expected: &[Vec<Rational>], reach: f64, what: &str| {
            assert_eq!(actual.len(), expected.len());
            for ((actual, expected), sizes) in actual.iter().zip(expected).zip(&exact.sizes) {
                let size = sizes.iter().map(Rational::to_f64).fold(0.0, f64::max);
                let tolerance = 8.0 * epsilon::<B::Scalar>() * size * reach;
                near(&fractions(actual), expected, tolerance, || format!("{} {shape:?}, {what}", B::NAME));
            }
        };
        check(basis.coefficients(), &exact.coefficients, 1.0, "coefficients");
        let bernstein = exact.bernstein_coefficients();
        check(basis.bernstein_coefficients(), &bernstein, reach, "Bernstein coefficients");
    }
}

#[test]
fn have_coefficients_in_both_bases() {
    each_family!(f64, coefficients);
    each_family!(f32, coefficients);
}

/// At the ends of the ranges some coefficients vanish, and next to the ends they have the right sign: what is proved of
/// the exact ones holds for the floats.
fn signs<B: Shipped>() {
    let sign = |c: &f64| if *c == 0.0 { 0.0 } else { c.signum() };
    let reference = B::reference();
    for shape in reference.shapes::<B::Scalar>(40, &mut Random::new(7)) {
        let (basis, exact) = (B::with(&shape).expect("inside the range"), reference.at(&shape));
        for (actual, expected) in basis.bernstein_coefficients().iter().zip(exact.bernstein_coefficients()) {
            let actual: Vec<f64> = actual.iter().map(|c| sign(&c.to_f64())).collect();
            let expected: Vec<f64> = expected.iter().map(|c| sign(&c.to_f64())).collect();
            assert_eq!(actual, expected, "{} {shape:?}", B::NAME);
        }
    }
}

#[test]
fn have_coefficients_of_the_exact_sign_at_the_ends_of_the_ranges() {
    signs::<QuadraticBezier>();
    signs::<QuarticBernstein>();
    signs::<Cardinal>();
    signs::<Tenths>();
}

/// A family without shape parameters has coefficients that are numbers: the nearest floats.
#[test]
fn have_constant_coefficients_that_are_rounded_once() {
    let (basis, exact) = (CubicBSpline::<f64>::new(), CubicBSpline::<f64>::reference().at::<f64>(&[]));
    let nearest = |rows: &[Vec<Rational>]| -> Vec<Vec<f64>> {
        rows.iter().map(|row| row.iter().map(Rational::to_f64).collect()).collect()
    };
    assert_eq!(Shipped::coefficients(&basis), nearest(&exact.coefficients));
    assert_eq!(Shipped::bernstein_coefficients(&basis), nearest(&exact.bernstein_coefficients()));
}
