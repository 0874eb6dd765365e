//! What is assumed of shape values and scalars, enforced by constructors and by the functions of joins.

use basis_runtime::{CurveError, basis};

basis!("../../specs/good/related_scalars.basis", Related, Scaled);

basis! {
    family Knots {
        shape 0 < h[i] for i in 0..=2;
        domain 0 <= x <= h[1];
        b[0] = (h[1] - x)^2/(h[1]*(h[0] + h[1]));
        b[1] = 1 - b[0] - b[2];
        b[2] = x^2/(h[1]*(h[1] + h[2]));
        prove partition_of_unity;
        prove nonnegative;
    }
}

#[test]
fn constructors_refuse_shape_values_that_are_not_assumed() {
    assert!(Related::new(1.0, 1.0).is_ok());
    assert!(Related::new(0.5, 0.75).is_err()); // q <= p
    assert!(Related::new(1.5, 0.75).is_err()); // p + q <= 2
}

#[test]
fn joins_refuse_scalars_that_are_not_related_as_assumed() {
    let p = [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0], [3.0, 3.0]];
    let scaled =
        |delta: f64, e: f64| related_scalars::scaled(&p, related_scalars::ScaledScalars { delta, e });
    let points = scaled(2.0, 1.0).expect("1 <= 2");
    assert_eq!(points, [[3.0, 3.0], [3.5, 4.0]]);
    assert!(matches!(scaled(1.0, 2.0), Err(CurveError::Shape(_))));
}

#[test]
fn lists_of_shape_parameters_at_ends_of_the_domain() {
    let knots = Knots::new([1.0, 2.0, 3.0]).expect("positive lengths");
    let at = |x: f64| [(2.0 - x).powi(2) / 6.0, 1.0 - (2.0 - x).powi(2) / 6.0 - x * x / 10.0, x * x / 10.0];
    for x in [0.0, 0.5, 1.25, 2.0] {
        for (own, expected) in knots.values(x).into_iter().zip(at(x)) {
            assert!((own - expected).abs() < 1e-15, "{x}: {own} {expected}");
        }
    }
    assert!(Knots::new([1.0, 0.0, 3.0]).is_err());
}
