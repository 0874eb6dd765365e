//! Parts of curves, other directions and other degrees are the same curve.

use basis_runtime::{Array, Basis, Bezier, Curve, Point};

use crate::families::{
    Bernstein7, Bernstein30, Constant, Linear, QuadraticLagrange, QuarticBernstein, UniformCubic,
};
use crate::random::Random;

type Planar<B> = Curve<B, [f64; 2]>;

fn assert_near(a: [f64; 2], b: [f64; 2]) {
    assert!(a.minus(b).iter().all(|c| c.abs() < 1e-13), "{a:?} {b:?}");
}

fn parts_agree<B: Basis<Scalar = f64>>(basis: B, random: &mut Random) {
    let points = B::Points::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
    let curve: Planar<B> = Curve::new(basis, points);
    let [lo, hi] = curve.domain();
    let at = |x: f64| lo + (hi - lo) * x;
    let whole = curve.to_bezier();
    let reversed = curve.reversed();
    let [x, y] = [random.between(0.0, 1.0), random.between(0.0, 1.0)];
    let [left, right] = curve.split(at(x)).unwrap();
    let part = curve.subsegment(at(x)..at(y)).unwrap();
    let velocity = curve.hodograph();
    assert_eq!(left.end(), right.start());
    assert_eq!([whole.start(), whole.end()], [left.start(), right.end()]);
    assert_eq!([whole.end(), whole.start()], [reversed.start(), reversed.end()]);
    for u in [0.0, 0.125, 0.5, 0.9, 1.0] {
        assert_near(whole.eval(u), curve.eval(at(u)));
        assert_near(reversed.eval(u), curve.eval(at(1.0 - u)));
        assert_near(left.eval(u), curve.eval(at(x * u)));
        assert_near(right.eval(u), curve.eval(at(x + (1.0 - x) * u)));
        assert_near(part.eval(u), curve.eval(at(x + (y - x) * u)));
        let [_, expected] = curve.eval_with_derivs(at(u));
        assert!(velocity.eval(u).minus(expected).iter().all(|c| c.abs() < 1e-11));
    }
    assert_eq!(curve.subsegment(lo..hi).unwrap(), whole);
    assert_eq!(curve.subsegment(hi..lo).unwrap(), reversed);
    let raised: Bezier<[f64; 2], 40> = curve.elevate();
    for u in [0.0, 0.3, 1.0] {
        assert_near(raised.eval(u), whole.eval(u));
    }
    assert_eq!([raised.start(), raised.end()], [whole.start(), whole.end()]);
}

#[test]
fn of_all_families() {
    let random = &mut Random::new(71);
    for _ in 0..50 {
        parts_agree(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), random);
        parts_agree(QuadraticLagrange::new(), random);
        parts_agree(UniformCubic::new(), random);
        parts_agree(Bernstein7::new(), random);
        parts_agree(Bernstein30::new(), random);
        parts_agree(Linear::default(), random);
        parts_agree(Constant::default(), random);
    }
}

/// The parameter is that of the piece, and velocities scale with its length.
#[test]
fn velocity_of_a_part() {
    let curve = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    let [_, whole] = curve.eval_with_derivs(0.25);
    let [_, part] = curve.subsegment(0.25..0.75).unwrap().eval_with_derivs(0.0);
    assert_near(part, whole.scale(0.5));
}

#[test]
fn derivatives_of_any_order() {
    let random = &mut Random::new(72);
    let points = core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
    let curve = Curve::new(QuarticBernstein::new(-2.5).unwrap(), points);
    let expected: [[f64; 2]; 7] = curve.eval_with_derivs(0.3);
    let mut derivatives = [[f64::NAN; 2]; 7];
    curve.derivatives_into(0.3, &mut derivatives);
    for (order, (&a, &b)) in derivatives.iter().zip(&expected).enumerate() {
        assert_near(a, b);
        assert_near(curve.derivative(0.3, order), b);
    }
    assert_eq!(derivatives[5..], [[0.0; 2]; 2]);
    curve.derivatives_into(0.3, &mut []);
}

#[test]
fn parameters_outside_of_the_domain() {
    use basis_runtime::CurveError;

    let curve = Curve::new(Linear::<f64>::default(), [1.0_f64, 7.0]);
    assert_eq!(curve.eval_checked(0.1), Ok(1.0));
    assert_eq!(curve.eval_checked(0.7), Ok(7.0));
    assert_eq!(curve.eval_checked(0.0), Err(CurveError::Parameter { value: 0.0, domain: [0.1, 0.7] }));
    assert!(
        matches!(curve.eval_checked(f64::NAN), Err(CurveError::Parameter { value, .. }) if value.is_nan())
    );
    let error = curve.eval_checked(f64::INFINITY).unwrap_err();
    assert_eq!(error.to_string(), "the parameter inf is outside of the domain 0.1 <= t <= 0.7");
    assert_eq!(curve.eval_clamped(-3.0), 1.0);
    assert_eq!(curve.eval_clamped(f64::INFINITY), 7.0);
    assert!(curve.eval_clamped(f64::NAN).is_nan());
}
