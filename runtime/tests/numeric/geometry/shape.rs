//! Shape parameters: which values a family takes, and what it says of the others.

use core::ops::Bound;

use basis_runtime::__private::{check_reach, check_shape};
use basis_runtime::{Scalar, ShapeError};

use crate::families::QuarticBernstein;

#[test]
fn takes_the_declared_range_with_its_ends() {
    for lambda in [-3.0, -1.5, 0.0, 1.0] {
        assert_eq!(QuarticBernstein::new(lambda).unwrap().lambda(), lambda);
    }
    for lambda in [(-3.0_f64).next_up(), 1.0_f64.next_down()] {
        assert!(QuarticBernstein::new(lambda).is_ok());
    }
    for lambda in [(-3.0_f64).next_down(), 1.0_f64.next_up(), f64::INFINITY, f64::NAN] {
        assert!(QuarticBernstein::new(lambda).is_err());
    }
}

#[test]
fn names_the_parameter_and_its_range() {
    let error = QuarticBernstein::new(-3.5_f32).unwrap_err();
    assert_eq!((error.family(), error.parameter()), ("QuarticBernstein", "λ"));
    assert_eq!((error.value(), error.range()), (-3.5, "-3 <= λ <= 1"));
    assert_eq!(
        [2.0, f64::NAN, f64::INFINITY, 1e300].map(|l| QuarticBernstein::new(l).unwrap_err().to_string()),
        [
            "QuarticBernstein: λ = 2 is outside the declared range -3 <= λ <= 1",
            "QuarticBernstein: λ is not a number; the declared range is -3 <= λ <= 1",
            "QuarticBernstein: λ = inf is not finite; the declared range is -3 <= λ <= 1",
            "QuarticBernstein: λ = 1e300 is outside the declared range -3 <= λ <= 1",
        ]
    );
}

#[test]
fn open_and_missing_bounds() {
    let positive = |value| check_shape("Join", "δ", value, Bound::Excluded(0.0), Bound::Unbounded, "0 < δ");
    assert_eq!(positive(f32::MIN_POSITIVE), Ok(f32::MIN_POSITIVE));
    assert!(positive(0.0).is_err() && positive(-0.0).is_err() && positive(f32::INFINITY).is_err());
    // 2/3 is no float; the nearest one stands for it.
    let upto = |value| check_shape("F", "a", value, Bound::Unbounded, Bound::Included(2.0 / 3.0), "a <= 2/3");
    assert_eq!(upto(2.0_f32 / 3.0), Ok(2.0 / 3.0));
    assert!(upto((2.0_f32 / 3.0).next_up()).is_err());
}

/// Each kind of floats has an end of its own, and a text that says it.
#[test]
fn floats_reach_to_their_own_ends() {
    fn check<S: Scalar>(value: S) -> Result<S, ShapeError> {
        check_reach("F", "a", value, [(300.0, "a <= 300"), (30.0, "a <= 30")])
    }
    assert_eq!((check(300.0_f64), check(30.0_f32)), (Ok(300.0), Ok(30.0)));
    let error = check(300.5_f64).unwrap_err();
    assert_eq!(error.to_string(), "F: a = 300.5 is outside the declared range a <= 300");
    let error = check(30.5_f32).unwrap_err();
    assert_eq!(error.to_string(), "F: a = 30.5 is outside the declared range a <= 30");
    assert!(check(f64::NAN).is_err());
}

#[test]
fn is_an_error_value() {
    fn build(lambda: f64) -> Result<f64, Box<dyn core::error::Error + Send + Sync>> {
        Ok(QuarticBernstein::new(lambda)?.lambda())
    }
    assert!(build(0.5).is_ok());
    assert!(build(1.5).unwrap_err().downcast_ref::<ShapeError>().is_some());
    let error = QuarticBernstein::new(1.5).unwrap_err();
    assert_eq!(error.clone(), error);
}
