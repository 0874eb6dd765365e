//! NaN in gives NaN out, and nothing panics.

use basis_runtime::Curve;

use crate::families::{Bernstein7, Constant, QuadraticLagrange, QuarticBernstein};

#[test]
fn a_parameter_that_is_nan() {
    assert!(Curve::new(QuarticBernstein::new(0.5).unwrap(), [1.0_f64; 4]).eval(f64::NAN).is_nan());
    assert!(Curve::new(QuadraticLagrange::new(), [1.0_f32; 3]).eval(f32::NAN).is_nan());
    assert!(Curve::new(Bernstein7::new(), [1.0_f64; 8]).eval(f64::NAN).is_nan());
    assert!(Curve::new(Constant::default(), [1.0_f64]).eval(f64::NAN).is_nan());
    assert!(QuarticBernstein::new(0.5).unwrap().values(f64::NAN).iter().all(|b| b.is_nan()));
    let [point, velocity, ..] = Curve::new(Bernstein7::new(), [1.0_f64; 8]).eval_with_derivs::<9>(f64::NAN);
    assert!(point.is_nan() && velocity.is_nan());
}

#[test]
fn a_point_that_is_nan() {
    let curve =
        Curve::new(QuarticBernstein::new(0.5).unwrap(), [[0.0, 1.0], [f64::NAN, 2.0], [0.0; 2], [1.0; 2]]);
    let [x, y] = curve.eval(0.5);
    assert!(x.is_nan() && !y.is_nan());
}

#[test]
fn an_infinite_parameter() {
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), [1.0_f64, 3.0, 2.0, 5.0]);
    assert!(!curve.eval(f64::INFINITY).is_finite());
}
