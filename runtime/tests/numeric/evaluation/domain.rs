//! Domains other than the unit interval.

use basis_runtime::{Basis, Curve};

use crate::families::{Linear, QuadraticLagrange};
use crate::random::Random;

#[test]
fn lagrange_interpolates_at_its_nodes() {
    let curve = Curve::new(QuadraticLagrange::new(), [3.0, 7.0, -1.0]);
    assert_eq!([-1.0, 0.0, 1.0].map(|t| curve.eval(t)), [3.0, 7.0, -1.0]);
    assert_eq!(curve.domain(), [-1.0, 1.0]);
    assert_eq!(curve.to_bernstein(), [3.0, 13.0, -1.0]);
}

/// 3 t (t-1)/2 + 7 (1 - t²) - t (t+1)/2 = 7 - 2 t - 6 t², differentiated with respect to t.
#[test]
fn derivatives_are_with_respect_to_the_parameter() {
    let curve = Curve::new(QuadraticLagrange::new(), [3.0_f32, 7.0, -1.0]);
    assert_eq!(curve.eval_with_derivs(0.5), [4.5, -8.0, -12.0, 0.0]);
    assert_eq!(curve.eval_with_derivs(-1.0), [3.0, 10.0, -12.0, 0.0]);
    assert_eq!(curve.basis().derivatives(0.5, 1), [0.0, -1.0, 1.0]);
    assert_eq!(curve.basis().derivatives(0.5, 2), [1.0, -2.0, 1.0]);
}

/// The width 7/10 - 1/10 is no float, and the ends are exact nevertheless.
#[test]
fn a_width_that_is_no_float() {
    let curve = Curve::new(Linear::<f64>::default(), [0.3_f64, 0.9]);
    assert_eq!([curve.eval(0.1), curve.eval(0.7)], [0.3_f64, 0.9]);
    assert!((curve.eval_with_derivs::<2>(0.4)[1] - 1.0).abs() < 1e-15);

    let mut random = Random::new(31);
    for _ in 0..1000 {
        let [s, x] = Linear::<f64>::default().values(random.between(0.1, 0.7));
        assert!(s >= 0.0 && x >= 0.0 && (s + x - 1.0).abs() <= f64::EPSILON);
    }
}
