//! Derivatives of every order, of functions and of curves.

use basis_runtime::{Array, Basis, Curve, Scalar};

use crate::families::{Bernstein7, Bernstein30, Constant, QuadraticLagrange, QuarticBernstein, UniformCubic};
use crate::random::Random;
use crate::reference::{derivative, evaluate, quadratic_lagrange, quartic, uniform_cubic};

/// Compares with the derivatives of the defining polynomials, for the basis and for a curve over random points.
fn follow_the_polynomials<B: Basis>(basis: B, functions: &[Vec<f64>], random: &mut Random, epsilon: f64) {
    let [lo, hi] = B::domain().map(Scalar::to_f64);
    let t: B::Scalar = random.between(lo, hi);
    let points = B::Points::from_fn(|_| random.between::<B::Scalar>(-1.0, 1.0));
    let along = Curve::new(basis, points).eval_with_derivs::<7>(t);
    for (order, along) in along.into_iter().enumerate() {
        let exact: Vec<f64> = functions.iter().map(|b| evaluate(&derivative(b, order), t.to_f64())).collect();
        let tolerance = 12.0 * epsilon * 5_f64.powi(order as i32);
        for (b, exact) in basis.derivatives(t, order).as_ref().iter().zip(&exact) {
            assert!(
                (b.to_f64() - exact).abs() <= tolerance,
                "{} order {order} at {t}: {b}, {exact}",
                B::NAME
            );
            assert!(order <= B::DEGREE || *b == B::Scalar::ZERO);
        }
        let exact: f64 = points.as_ref().iter().zip(&exact).map(|(p, b)| p.to_f64() * b).sum();
        assert!(
            (along.to_f64() - exact).abs() <= tolerance,
            "{} curve, order {order} at {t}: {along}, {exact}",
            B::NAME
        );
        assert!(order <= B::DEGREE || along == B::Scalar::ZERO);
    }
}

fn all_families<S: Scalar>(epsilon: f64) {
    let random = &mut Random::new(21);
    for _ in 0..1000 {
        let lambda: S = random.between(-3.0, 1.0);
        let basis = QuarticBernstein::new(lambda).unwrap();
        follow_the_polynomials(basis, &quartic(lambda.to_f64()), random, epsilon);
        follow_the_polynomials(UniformCubic::<S>::new(), &uniform_cubic(), random, epsilon);
        follow_the_polynomials(QuadraticLagrange::<S>::new(), &quadratic_lagrange(), random, epsilon);
        follow_the_polynomials(Constant::<S>::default(), &[vec![1.0]], random, epsilon);
    }
}

#[test]
fn follow_the_polynomials_in_f32() {
    all_families::<f32>(f32::EPSILON.into());
}

#[test]
fn follow_the_polynomials_in_f64() {
    all_families::<f64>(f64::EPSILON);
}

#[test]
fn at_the_start_as_claimed() {
    let lambda = 0.5;
    let basis = QuarticBernstein::new(lambda).unwrap();
    assert_eq!(basis.derivatives(0.0, 1), [-(3.0 + lambda), 3.0 + lambda, 0.0, 0.0]);
    assert_eq!(basis.derivatives(0.0, 2), [6.0 * (1.0 + lambda), -6.0 * (2.0 + lambda), 6.0, 0.0]);
    assert_eq!(basis.derivatives(0.3, 0).map(f32::of), basis.values(0.3).map(f32::of));
    assert_eq!(basis.derivatives(0.3, 5), [0.0; 4]);
    assert_eq!(basis.derivatives(0.3, usize::MAX), [0.0; 4]);
}

/// C'(0) = n (P1 - P0), C''(0) = n (n-1) (P2 - 2 P1 + P0), and the same at the other end.
#[test]
fn of_bezier_curves_at_the_ends() {
    let curve = Curve::new(Bernstein7::new(), [1.0, 2.0, 4.0, 8.0, 16.0, 8.0, 4.0, 2.0]);
    assert_eq!(curve.eval_with_derivs(0.0), [1.0, 7.0, 42.0]);
    assert_eq!(curve.eval_with_derivs(1.0), [2.0, -14.0, 84.0]);

    let points = core::array::from_fn(|k| [k as f32, if k == 30 { 1.0 } else { 0.0 }]);
    let curve = Curve::new(Bernstein30::new(), points);
    assert_eq!(curve.eval_with_derivs(1.0), [[30.0, 1.0], [30.0, 30.0], [0.0, 870.0]]);
}

/// Σ binomial(n, k) s^(n-k) x^k (k/n) = x, so the derivatives are 1, 0, 0, ….
#[test]
fn of_a_straight_line_of_degree_30() {
    let line = Curve::new(Bernstein30::new(), core::array::from_fn(|k| k as f64));
    for i in 0..=16 {
        let t = f64::from(i) / 16.0;
        let [point, velocity, rest @ ..] = line.eval_with_derivs::<40>(t);
        assert!((point - 30.0 * t).abs() < 1e-13 && (velocity - 30.0).abs() < 1e-12);
        assert_eq!(rest, [0.0; 38]);
    }
}

#[test]
fn none_one_or_more_than_there_are() {
    let curve = Curve::new(QuarticBernstein::new(-1.25).unwrap(), [1.0, -2.0, 0.5, 3.0]);
    assert_eq!(curve.eval_with_derivs::<0>(0.3), [0.0; 0]);
    assert_eq!(curve.eval_with_derivs::<1>(0.3), [curve.eval(0.3)]);
    let all = curve.eval_with_derivs::<200>(0.3);
    assert_eq!(all[..3], curve.eval_with_derivs::<3>(0.3));
    assert_eq!(all[5..], [0.0; 195]);

    let curve = Curve::new(Bernstein7::new(), [1.0_f32, -2.0, 0.5, 3.0, 1.0, 2.0, 9.0, 4.0]);
    assert_eq!(curve.eval_with_derivs::<0>(0.3), [0.0; 0]);
    assert_eq!(curve.eval_with_derivs::<1>(0.3), [curve.eval(0.3)]);
    assert_eq!(curve.eval_with_derivs::<200>(0.3)[8..], [0.0; 192]);

    let point = Curve::new(Constant::default(), [5.0]);
    assert_eq!(point.eval_with_derivs(0.5), [5.0, 0.0, 0.0]);
}
