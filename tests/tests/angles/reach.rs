//! How far floats reach in shape values with exponentials: up to there nothing overflows, beyond there is an error.

use basis_runtime::{RationalBasis, Scalar, ShapeError, basis};

use crate::{ExponentialBernstein as Cubic, HBezierQuadratic};

basis! {
    /// A coefficient is made of 1 − tanh(α)·tanh(β/2), which is no product.
    family Pair {
        shape 0 < α, 0 < β;
        domain 0 <= t <= 1;
        b[0] = (1 - t)*exp(-β)/(t + exp(-2*α) + exp(-β));
    }
    /// Another shape parameter in place of the second exponential.
    family Lifted {
        shape 0 < α, 0 <= λ <= 1;
        domain 0 <= t <= 1;
        b[0] = exp(-α)/(λ*(1 - t) + t + exp(-α));
    }
    /// Values that grow like the exponential, whose derivatives grow faster.
    family Steep {
        shape 0 < α;
        domain 0 <= t <= 1;
        b[0] = 1/(t + exp(-α));
    }
    /// A range without ends.
    family Logistic {
        shape k;
        domain 0 <= t <= 1;
        b[0] = (1 - t)/(exp(k)*t + 1 - t);
        b[1] = exp(k)*t/(exp(k)*t + 1 - t);
    }
    /// A fast rate on a short range.
    family Quick {
        shape 0 < α <= 1/1000;
        domain 0 <= t <= α;
        b[0] = sinh(50000*t)/sinh(50000*α);
    }
}

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

/// Values and two derivatives at places of the unit interval, each within some ε of what is expected, or of the largest
/// derivative of its order.
fn compare<B: RationalBasis<Scalar = f64>>(basis: &B, expected: &dyn Fn(f64) -> [Vec<f64>; 3]) {
    let near = (1..600).step_by(7).map(|k| 0.5_f64.powi(k));
    let places: Vec<f64> = near.chain([0.0, 1.0, 0.3, 0.75]).collect();
    let mut largest = [0.0_f64; 3];
    for t in &places {
        for (largest, all) in largest.iter_mut().zip(expected(*t)) {
            *largest = all.iter().fold(*largest, |largest, x| largest.max(x.abs()));
        }
    }
    let values = largest[0];
    for t in &places {
        for (order, (expected, largest)) in expected(*t).iter().zip(largest).enumerate() {
            let all = basis.derivatives(*t, order);
            for (value, expected) in all.as_ref().iter().zip(expected) {
                // Derivatives are differences of what may be as large as values.
                let size = if order == 0 { expected.abs() } else { largest.max(values) };
                assert!(
                    (value - expected).abs() <= 1e-12 * size + 1e-300,
                    "{} at {t}, order {order}: {value} for {expected}, of {largest}",
                    B::NAME
                );
            }
        }
    }
}

/// c, c′ and c″ of (p + q·t)/(r + s·t).
fn quotient([p, q, r, s]: [f64; 4], t: f64) -> [f64; 3] {
    let w = r + s * t;
    let first = (q - s * ((p + q * t) / w)) / w;
    [(p + q * t) / w, first, -2.0 * first * (s / w)]
}

#[test]
fn two_exponentials_have_no_difference_of_large_ones() {
    // As far as both are accepted.
    let mut count = 0;
    for alpha in [1e-3_f64, 1.0, 20.0, 40.0, 150.0, 300.0] {
        for beta in [1e-3_f64, 1.0, 20.0, 40.0, 150.0, 300.0] {
            let Ok(basis) = Pair::new(alpha, beta) else { continue };
            count += 1;
            let (first, second) = ((-2.0 * alpha).exp(), (-beta).exp());
            let expected = |t| quotient([second, -second, first + second, 1.0], t).map(|x| vec![x]);
            compare(&basis, &expected);
        }
    }
    assert_eq!(count, 36);
    let mut count = 0;
    for alpha in [1e-3_f64, 1.0, 20.0, 40.0, 150.0, 300.0] {
        for lambda in [0.0, 1e-200, 1e-20, 0.5, 1.0] {
            let Ok(basis) = Lifted::new(alpha, lambda) else { continue };
            count += 1;
            let falls = (-alpha).exp();
            let expected = |t| quotient([falls, 0.0, lambda + falls, 1.0 - lambda], t).map(|x| vec![x]);
            compare(&basis, &expected);
        }
    }
    assert_eq!(count, 30);
}

#[test]
fn derivatives_of_unbounded_values_do_not_overflow() {
    let (alpha, _) = end::<Steep<f64>>(Steep::new, f64::next_up);
    assert!(alpha > 200.0 && alpha < 236.6, "{alpha}");
    let expected = |t| quotient([1.0, 0.0, (-alpha).exp(), 1.0], t).map(|x| vec![x]);
    compare(&Steep::new(alpha).expect("inside"), &expected);
    let (alpha, _) = end::<Steep<f32>>(Steep::new, f32::next_up);
    assert!(alpha > 15.0 && alpha < 29.6, "{alpha}");
    let basis = Steep::new(alpha).expect("inside");
    for k in 0..40 {
        for order in 0..=2 {
            let [value] = basis.derivatives(0.5_f32.powi(k), order);
            assert!(value.is_finite(), "{k} {order}");
        }
    }
}

#[test]
fn a_range_without_a_low_end_is_limited_there_as_well() {
    let (k, error) = end::<Logistic<f64>>(Logistic::new, f64::next_up);
    assert!(error.to_string().ends_with(&format!("range k <= {k}, as far as f64 reaches")), "{error}");
    let (low, error) = end::<Logistic<f64>>(|k| Logistic::new(-k), f64::next_up);
    assert!(error.to_string().ends_with(&format!("range k >= -{low}, as far as f64 reaches")), "{error}");
    assert!(k > 300.0 && k < 355.0 && low > 300.0 && low < 355.0, "{low} {k}");
    for k in [-low, -100.0, -20.0, -1.0, 0.0, 1.0, 20.0, 100.0, k] {
        let basis = Logistic::new(k).expect("inside");
        let e = k.exp();
        compare(&basis, &|t| {
            let w = e * t + (1.0 - t);
            let first = e / w / w;
            let second = -2.0 * first * ((e - 1.0) / w);
            [vec![(1.0 - t) / w, e * t / w], vec![-first, first], vec![-second, second]]
        });
    }
    let (k, _) = end::<Logistic<f32>>(Logistic::new, f32::next_up);
    let (low, _) = end::<Logistic<f32>>(|k| Logistic::new(-k), f32::next_up);
    assert!(k > 30.0 && k < 44.0 && low > 30.0 && low < 44.0, "{low} {k}");
}

#[test]
fn small_shape_values_are_accepted_at_fast_rates() {
    for alpha in [1e-3_f64, 5e-4, 1e-6] {
        let basis = Quick::new(alpha).expect("inside");
        for place in [0.0, 0.001, 0.25, 0.5, 0.999, 1.0] {
            let t = alpha * place;
            let (value, expected) = (basis.values(t)[0], (5e4 * t).sinh() / (5e4 * alpha).sinh());
            assert!((value - expected).abs() <= 1e-12 * expected, "{alpha} {t}: {value} for {expected}");
            assert!((0..=2).all(|order| basis.derivatives(t, order)[0].is_finite()));
        }
    }
    // Between 0 and the end.
    assert!(Quick::new(4e-4_f32).is_ok());
    let error = Quick::new(1e-3_f32).expect_err("exp(100) is no f32");
    assert!(error.to_string().contains("α <= 1/1000, of which f32 reaches α <= 0.000"), "{error}");
}
