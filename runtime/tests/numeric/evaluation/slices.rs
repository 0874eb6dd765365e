//! Many parameters at once give what one at a time gives, up to a fused rounding, and the ends exactly.

use basis_runtime::{Array, Basis, Bezier, Curve, CurveError, Point, Scalar};

use crate::families::{
    Bernstein7, Bernstein30, Constant, Linear, QuadraticLagrange, QuarticBernstein, UniformCubic,
};
use crate::random::Random;

/// More than one tile, and a rest that is no multiple of a vector.
const COUNT: usize = 1037;

fn slices_agree<B: Basis>(basis: B, count: usize, random: &mut Random) {
    let points = B::Points::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
    let curve: Curve<B, [B::Scalar; 3]> = Curve::new(basis, points);
    let [lo, hi] = curve.domain();
    let mut ts: Vec<B::Scalar> = (0..count).map(|_| random.between(lo.to_f64(), hi.to_f64())).collect();
    (ts[0], ts[count - 1]) = (lo, hi);
    let [zero, nothing] = [B::Scalar::ZERO, B::Scalar::NAN];

    let mut out = vec![[nothing; 3]; count];
    curve.eval_into(&ts, &mut out).unwrap();
    assert_eq!([out[0], out[count - 1]], [curve.start(), curve.end()], "{}", B::NAME);
    let epsilon = B::Scalar::EPSILON.to_f64();
    for (&t, point) in ts.iter().zip(&out) {
        let gap = curve.eval(t).minus(*point);
        assert!(gap.iter().all(|c| c.to_f64().abs() < 8.0 * epsilon), "{} at {t}: {gap:?}", B::NAME);
    }

    let [mut values, mut first, mut second, mut third] = core::array::from_fn(|_| vec![[nothing; 3]; count]);
    curve.eval_with_derivs_into(&ts, [&mut values, &mut first, &mut second, &mut third]).unwrap();
    assert_eq!(values, out);
    for (i, &t) in ts.iter().enumerate() {
        let expected: [[B::Scalar; 3]; 4] = curve.eval_with_derivs(t);
        let found = [values[i], first[i], second[i], third[i]];
        for order in 0..4 {
            let scale = (3.0 * B::DEGREE as f64 + 1.0).powi(order);
            let gap = expected[order as usize].minus(found[order as usize]);
            let tolerance = 8.0 * epsilon * scale;
            assert!(
                gap.iter().all(|c| c.to_f64().abs() <= tolerance),
                "{} order {order} at {t}: {gap:?} {tolerance:e}",
                B::NAME
            );
        }
    }

    let [mut x, mut y, mut z] = core::array::from_fn(|_| vec![nothing; count]);
    curve.eval_components_into(&ts, &mut [&mut x, &mut y, &mut z]).unwrap();
    for (i, point) in out.iter().enumerate() {
        let gap = point.minus([x[i], y[i], z[i]]);
        assert!(gap.iter().all(|c| c.to_f64().abs() < 8.0 * epsilon));
    }

    let mut samples = vec![[zero; 3]; count];
    curve.samples_into(&mut samples);
    assert_eq!([samples[0], samples[count - 1]], [curve.start(), curve.end()], "{}", B::NAME);
    for (point, sample) in curve.samples(count).zip(&samples) {
        assert!(point.minus(*sample).iter().all(|c| c.to_f64().abs() < 8.0 * epsilon));
    }
}

fn all_families<S: Scalar>() {
    let random = &mut Random::new(61);
    for count in [2, 15, 16, 17, COUNT] {
        slices_agree(QuarticBernstein::<S>::new(random.between(-3.0, 1.0)).unwrap(), count, random);
        slices_agree(QuadraticLagrange::<S>::new(), count, random);
        slices_agree(UniformCubic::<S>::new(), count, random);
        slices_agree(Bernstein7::<S>::new(), count, random);
        slices_agree(Bernstein30::<S>::new(), count, random);
        slices_agree(Linear::<S>::default(), count, random);
        slices_agree(Constant::<S>::default(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 1>::new(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 2>::new(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 3>::new(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 6>::new(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 8>::new(), count, random);
        slices_agree(basis_runtime::BernsteinBasis::<S, 13>::new(), count, random);
    }
}

#[test]
fn in_f32() {
    all_families::<f32>();
}

#[test]
fn in_f64() {
    all_families::<f64>();
}

#[test]
fn slices_of_different_lengths() {
    let curve = Bezier::from_points([0.0_f64, 1.0]);
    let error = CurveError::Length { expected: 2, found: 1 };
    assert_eq!(curve.eval_into(&[0.0, 1.0], &mut [0.0]), Err(error));
    assert_eq!(curve.eval_with_derivs_into(&[0.0, 1.0], [&mut [0.0]]), Err(error));
    assert_eq!(
        curve.eval_components_into(&[0.0], &mut []),
        Err(CurveError::Dimension { expected: 0, found: 1 })
    );
    assert_eq!(curve.eval_into(&[], &mut []), Ok(()));
}

#[test]
fn few_samples() {
    let curve = Bezier::from_points([3.0_f64, 1.0, 5.0]);
    assert!(curve.samples(0).next().is_none());
    assert!(curve.samples(1).eq([3.0]));
    assert!(curve.samples(2).rev().eq([5.0, 3.0]));
    assert_eq!(curve.samples(7).nth(3), Some(2.5));
    assert_eq!(curve.samples(7).len(), 7);
    curve.samples_into(&mut []);
    let mut one = [0.0];
    curve.samples_into(&mut one);
    assert_eq!(one, [3.0]);
}

/// A step of 1/(n-1), added up, would miss the end.
#[test]
fn the_last_sample_is_the_end() {
    let curve = Bezier::from_points([0.1_f32, 0.7, -0.3]);
    for count in 2..3000 {
        assert_eq!(curve.samples(count).next_back(), Some(-0.3));
    }
}
