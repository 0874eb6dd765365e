//! How far `values` are from the exact values, in units in the last place.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_runtime::Scalar;
use basis_tests::exact::fraction;
use basis_tests::families::{Bernstein30, Cubic, QuadraticBezier, QuarticBernstein, SaidBall, Shipped};
use basis_tests::random::Random;

/// The distance between neighbouring floats at the exact value.
fn ulp<S: Scalar>(exact: &Rational) -> f64 {
    let (digits, smallest) = if size_of::<S>() == 4 { (23, -149) } else { (52, -1074) };
    let exponent = exact.to_f64().abs().log2().floor() as i32;
    2_f64.powi((exponent - digits).max(smallest))
}

/// The largest error of a value at random points, where nothing is rounded to a subnormal number.
fn worst<B: Shipped>(seed: u64, points: usize) -> f64 {
    let (reference, random) = (B::reference(), &mut Random::new(seed));
    let smallest = if size_of::<B::Scalar>() == 4 { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let mut worst = 0.0_f64;
    for _ in 0..points {
        let shape: Vec<B::Scalar> = reference.shape(random);
        let t: B::Scalar = random.unit();
        let values = B::with(&shape).expect("inside the range").values(t);
        for (value, exact) in values.as_ref().iter().zip(reference.at(&shape).values(&fraction(t))) {
            assert!(value.to_f64() >= 0.0, "{} {shape:?} at {t}: {value}", B::NAME);
            if exact.is_zero() {
                assert_eq!(value.to_f64(), 0.0, "{} {shape:?} at {t}", B::NAME);
            } else if exact.to_f64() > 64.0 * smallest {
                let error = (&fraction(*value) - &exact).to_f64().abs() / ulp::<B::Scalar>(&exact);
                worst = worst.max(error);
            }
        }
    }
    println!("{} in {}: {worst:.2} ulp", B::NAME, core::any::type_name::<B::Scalar>());
    worst
}

/// Over the whole range of the shape parameter, both ends included, and next to both ends of the domain.
#[test]
fn of_the_quartic_family_is_six_ulp() {
    assert!(worst::<QuarticBernstein<f32>>(1, 10_000) <= 6.0);
    assert!(worst::<QuarticBernstein<f64>>(2, 5_000) <= 6.0);
}

#[test]
fn of_other_nonnegative_families() {
    assert!(worst::<QuadraticBezier<f32>>(3, 2_000) <= 6.0);
    assert!(worst::<QuadraticBezier<f64>>(4, 1_000) <= 6.0);
    assert!(worst::<SaidBall<f32>>(5, 1_000) <= 4.0);
    assert!(worst::<Cubic<f64>>(6, 1_000) <= 4.0);
    assert!(worst::<Bernstein30<f64>>(7, 200) <= 20.0);
}

/// A monomial form has negative values there.
#[test]
fn next_to_the_end_values_are_not_negative() {
    for lambda in [-3.0_f32, -2.999_999_8, -0.3, 0.0, 0.7, 0.999_999_94, 1.0] {
        let basis = QuarticBernstein::new(lambda).expect("inside the range");
        let mut t = 1.0_f32;
        for _ in 0..2000 {
            t = t.next_down();
            let [a, b, c, d] = basis.values(t);
            assert!(a >= 0.0 && b >= 0.0 && c >= 0.0 && d >= 0.0, "{lambda} at {t}: {:?}", [a, b, c, d]);
        }
    }
}
