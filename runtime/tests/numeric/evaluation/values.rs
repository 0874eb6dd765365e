//! Values of the basis functions: exact where floats can be, nonnegative where proved, summing to one.

use basis_runtime::{Basis, Scalar};

use crate::families::{Bernstein30, Constant, QuadraticLagrange, QuarticBernstein, UniformCubic};
use crate::random::Random;
use crate::reference;

#[test]
fn exact_at_dyadic_parameters() {
    // t = 1/4, λ = 1/2: numerators over 1024.
    let values = QuarticBernstein::new(0.5).unwrap().values(0.25);
    assert_eq!(values.map(|b| b * 1024.0), [378.0, 486.0, 150.0, 10.0]);
    // t = 3/4, λ = -3: numerators over 256.
    let values = QuarticBernstein::new(-3.0_f32).unwrap().values(0.75);
    assert_eq!(values.map(|b| b * 256.0), [13.0, 27.0, 27.0, 189.0]);
    // λ = 0 is the cubic Bernstein basis.
    assert_eq!(QuarticBernstein::new(0.0).unwrap().values(0.5), [0.125, 0.375, 0.375, 0.125]);

    assert_eq!(QuadraticLagrange::new().values(0.5), [-0.125, 0.75, 0.375]);
    assert_eq!(QuadraticLagrange::<f32>::new().values(0.0), [0.0, 1.0, 0.0]);
    assert_eq!(Constant::<f64>::default().values(0.3), [1.0]);
    assert_eq!(Bernstein30::<f64>::new().values(0.5)[15], 155_117_520.0 / 2_f64.powi(30));
}

#[test]
fn exact_at_the_ends() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let basis = QuarticBernstein::<f64>::new(random.between(-3.0, 1.0)).unwrap();
        assert_eq!(basis.values(0.0), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(basis.values(1.0), [0.0, 0.0, 0.0, 1.0]);
    }
    assert_eq!(QuadraticLagrange::new().values(-1.0), [1.0, 0.0, 0.0]);
    assert_eq!(QuadraticLagrange::new().values(1.0), [0.0, 0.0, 1.0]);
    let cubic = UniformCubic::<f32>::new();
    assert_eq!(cubic.values(0.0), [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0, 0.0]);
    assert_eq!(cubic.values(1.0), [0.0, 1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0]);
}

/// Every value is close to the exact one relative to itself, so no value is negative.
#[test]
fn relative_error_in_f32_is_a_few_ulp() {
    let mut random = Random::new(2);
    let mut worst = 0.0_f64;
    for round in 0..20_000 {
        let lambda: f32 = match round % 10 {
            0 => -3.0,
            1 => 1.0,
            _ => random.between(-3.0, 1.0),
        };
        let distance = 2_f64.powf(random.between::<f64>(-40.0, -1.0));
        let t = f32::of(if round % 2 == 0 { distance } else { 1.0 - distance });
        let values = QuarticBernstein::new(lambda).unwrap().values(t);
        let (l, x, s) = (f64::from(lambda), f64::from(t), 1.0 - f64::from(t));
        let exact = [
            ((1.0 - l) * x + s) * s * s * s, // none of these factors cancels
            ((3.0 + l) * s + 3.0 * x) * x * s * s,
            ((3.0 + l) * x + 3.0 * s) * x * x * s,
            ((1.0 - l) * s + x) * x * x * x,
        ];
        for (value, exact) in values.into_iter().zip(exact) {
            assert!(value >= 0.0, "λ = {lambda}, t = {t}: {values:?}");
            // Below this the value is subnormal.
            if exact > 1e-36 {
                worst = worst.max((f64::from(value) - exact).abs() / exact / f64::from(f32::EPSILON));
            }
        }
    }
    println!("QuarticBernstein values, f32: relative error at most {worst:.2} ε");
    assert!(worst < 5.0);
}

fn sums_to_one<B: Basis>(basis: B, lo: f64, hi: f64, epsilon: f64) {
    let mut random = Random::new(3);
    for _ in 0..1000 {
        let values = basis.values(random.between(lo, hi));
        let sum: f64 = values.as_ref().iter().map(|b| b.to_f64()).sum();
        assert!((sum - 1.0).abs() <= 4.0 * epsilon, "{}: {sum}", B::NAME);
    }
}

#[test]
fn sum_to_one() {
    sums_to_one(QuarticBernstein::new(0.62).unwrap(), 0.0, 1.0, f64::EPSILON);
    sums_to_one(QuarticBernstein::new(-3.0_f32).unwrap(), 0.0, 1.0, f32::EPSILON.into());
    sums_to_one(UniformCubic::<f64>::new(), 0.0, 1.0, f64::EPSILON);
    sums_to_one(QuadraticLagrange::<f64>::new(), -1.0, 1.0, f64::EPSILON);
}

#[test]
fn follow_the_definition() {
    let mut random = Random::new(4);
    for _ in 0..1000 {
        let t: f64 = random.between(-1.0, 1.0);
        for (value, function) in
            QuadraticLagrange::new().values(t).iter().zip(reference::quadratic_lagrange())
        {
            assert!((value - reference::evaluate(&function, t)).abs() < 4.0 * f64::EPSILON);
        }
        let t = t.abs();
        for (value, function) in UniformCubic::new().values(t).iter().zip(reference::uniform_cubic()) {
            assert!((value - reference::evaluate(&function, t)).abs() < 4.0 * f64::EPSILON);
        }
    }
}

#[test]
fn lengths_are_counted_from_the_types() {
    assert_eq!((QuarticBernstein::<f64>::LEN, QuarticBernstein::<f64>::DEGREE), (4, 4));
    assert_eq!((UniformCubic::<f64>::LEN, UniformCubic::<f64>::DEGREE), (4, 3));
    assert_eq!((Constant::<f64>::LEN, Constant::<f64>::DEGREE), (1, 0));
}
