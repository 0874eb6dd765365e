//! How far floats reach in shape values with exponentials: up to there nothing overflows, beyond there is an error.

use basis_runtime::{RationalBasis, Scalar, ShapeError};

use crate::{ExponentialBernstein as Cubic, HBezierQuadratic};

/// The largest shape value with a family, and the error for the next float.
fn end<B: RationalBasis>(
    new: fn(B::Scalar) -> Result<B, ShapeError>,
    next: fn(B::Scalar) -> B::Scalar,
) -> (B::Scalar, ShapeError) {
    let (mut low, mut high) = (B::Scalar::ONE, B::Scalar::of(1e4));
    while next(low) < high {
        let middle = (low + high) * B::Scalar::of(0.5);
        if new(middle).is_ok() { low = middle } else { high = middle }
    }
    (low, new(high).expect_err("beyond"))
}

/// Values and two derivatives of the functions, all over the domain.
fn check<B: RationalBasis>(basis: &B, alpha: B::Scalar) {
    let near = (1..40).map(|k| 0.5_f64.powi(k));
    for place in near.clone().chain(near.map(|x| 1.0 - x)).chain([0.0, 1.0, 0.3, 0.7]) {
        let t = alpha * B::Scalar::of(place);
        let sum: f64 = basis.values(t).as_ref().iter().map(|x| x.to_f64()).sum();
        assert!((sum - 1.0).abs() < 1e-5, "{} at {t}: {sum}", B::NAME);
        for order in 0..=2 {
            let all = basis.derivatives(t, order);
            assert!(all.as_ref().iter().all(|x| x.is_finite()), "{} at {t}, order {order}", B::NAME);
        }
    }
}

#[test]
fn shape_values_that_overflow_are_refused() {
    let (alpha, error) = end::<HBezierQuadratic<f64>>(HBezierQuadratic::new, f64::next_up);
    assert!(alpha > 300.0 && alpha < 356.0, "{alpha}");
    assert_eq!(error.to_string().split(" = ").next(), Some("HBezierQuadratic: α"));
    let said = format!("is outside the declared range 0 < α, of which f64 reaches α <= {alpha}");
    assert!(error.to_string().ends_with(&said), "{error}");
    check(&HBezierQuadratic::new(alpha).expect("inside"), alpha);
    let (alpha, error) = end::<HBezierQuadratic<f32>>(HBezierQuadratic::new, f32::next_up);
    assert!(alpha > 30.0 && alpha < 44.5, "{alpha}");
    assert!(error.to_string().ends_with(&format!("of which f32 reaches α <= {alpha}")), "{error}");
    check(&HBezierQuadratic::new(alpha).expect("inside"), alpha);

    let (alpha, _) = end::<Cubic<f64>>(Cubic::new, f64::next_up);
    assert!(alpha > 200.0 && alpha < 248.0, "{alpha}");
    check(&Cubic::new(alpha).expect("inside"), alpha);
    let (alpha, _) = end::<Cubic<f32>>(Cubic::new, f32::next_up);
    assert!(alpha > 20.0 && alpha < 34.0, "{alpha}");
    check(&Cubic::new(alpha).expect("inside"), alpha);
}
