//! Families with angles and exponentials in single precision: at most 20 units in the last place from the values of double
//! precision, next to both ends too, and for lengths of the domain that are small and large.

use basis_runtime::{RationalBasis, ShapeError, SpannedBasis, basis};
use basis_tests::exact::epsilon;
use basis_tests::random::Random;

basis!(
    library "trigonometric/end_angle",
    CBezierQuadratic, TrigonometricBBasis(2), HBezierQuadratic, ExponentialBernstein(4)
);
basis!(library "trigonometric/shape", QuadraticTwoParameters, CubicOneParameter, RationalQuadraticTrigonometric);
mod beside_the_angle {
    use super::basis;
    basis!(library "trigonometric/mixed", CBezierCubic, HBezierCubic, CBSplineCubic);
    basis!(library "trigonometric/shape", CubicCBezier);
}
use beside_the_angle::{CBSplineCubic, CBezierCubic, CubicCBezier, HBezierCubic};

/// What is below this has fewer digits.
const LEAST: f64 = 1e-37;

fn is_near(single: &[f32], double: &[f64], what: &dyn Fn() -> String) {
    for (k, (found, exact)) in single.iter().zip(double).enumerate() {
        assert!(*found >= 0.0, "function {k} of {} is {found}", what());
        if *exact < LEAST {
            continue;
        }
        let error = ((f64::from(*found) - exact) / exact).abs() / epsilon::<f32>();
        // A unit is half of ε.
        assert!(error <= 10.0, "function {k} of {}: {found} in place of {exact}, {error} ε", what());
    }
}

/// Parameters from 0 to `end`, many of them next to these.
fn parameters(random: &mut Random, end: f32) -> Vec<f32> {
    let mut all = Vec::new();
    for _ in 0..12 {
        all.push(random.between(0.0, f64::from(end)));
        let near = 2_f32.powi(-1 - random.below(23) as i32);
        all.extend([end * near * random.between::<f32>(0.5, 1.0), end * (1.0 - near)]);
    }
    all
}

/// Shape values between these numbers, some of them next to one of the two.
fn shape<const N: usize>(random: &mut Random, ranges: &[[f64; 2]; N]) -> [f32; N] {
    ranges.map(|[low, high]| {
        let near = 2_f64.powi(-(random.below(20) as i32));
        match random.below(4) {
            0 => (low + (high - low) * near * 0.99) as f32,
            1 => (high - (high - low) * near * 0.99) as f32,
            _ => random.between(low, high),
        }
    })
}

fn agrees<const N: usize, A: RationalBasis<Scalar = f32>, B: RationalBasis<Scalar = f64>>(
    single: fn([f32; N]) -> Result<A, ShapeError>,
    double: fn([f64; N]) -> Result<B, ShapeError>,
    ranges: [[f64; 2]; N],
    seed: u64,
) {
    let mut random = Random::new(seed);
    for _ in 0..300 {
        let shape = shape(&mut random, &ranges);
        let (a, b) = (single(shape).unwrap(), double(shape.map(f64::from)).unwrap());
        for t in parameters(&mut random, a.domain()[1]) {
            let what = || format!("{} at {shape:?}, {t}", A::NAME);
            is_near(a.values(t).as_ref(), b.values(f64::from(t)).as_ref(), &what);
        }
    }
}

const PI: f64 = core::f64::consts::PI;

#[test]
fn domains_that_end_at_a_parameter() {
    agrees(|[a]| CBezierQuadratic::new(a), |[a]| CBezierQuadratic::new(a), [[0.0, PI]], 1);
    agrees(|[a]| TrigonometricBBasis::new(a), |[a]| TrigonometricBBasis::new(a), [[0.0, PI]], 2);
    agrees(|[a]| HBezierQuadratic::new(a), |[a]| HBezierQuadratic::new(a), [[0.0, 30.0]], 3);
    agrees(|[a]| ExponentialBernstein::new(a), |[a]| ExponentialBernstein::new(a), [[0.0, 16.0]], 4);
}

#[test]
fn domains_that_end_at_a_right_angle() {
    agrees(
        |[m, n]| QuadraticTwoParameters::new(m, n),
        |[m, n]| QuadraticTwoParameters::new(m, n),
        [[-1.0, 1.0]; 2],
        5,
    );
    agrees(|[l]| CubicOneParameter::new(l), |[l]| CubicOneParameter::new(l), [[-2.0, 1.0]], 6);
    agrees(
        |[w]| RationalQuadraticTrigonometric::new(w),
        |[w]| RationalQuadraticTrigonometric::new(w),
        [[0.0, 10.0]],
        7,
    );
}

#[test]
fn variables_beside_their_sines() {
    agrees(|[a]| CBezierCubic::new(a), |[a]| CBezierCubic::new(a), [[0.0, PI]], 8);
    agrees(|[a]| HBezierCubic::new(a), |[a]| HBezierCubic::new(a), [[0.0, 6.0]], 9);
    agrees(|[a]| CBSplineCubic::new(a), |[a]| CBSplineCubic::new(a), [[0.0, PI]], 10);
    let (single, double) = (CubicCBezier::<f32>::default(), CubicCBezier::<f64>::default());
    let mut random = Random::new(11);
    for _ in 0..300 {
        for t in parameters(&mut random, SpannedBasis::domain(&single)[1]) {
            let what = || format!("CubicCBezier at {t}");
            is_near(&single.values(t), &double.values(f64::from(t)), &what);
        }
    }
}
