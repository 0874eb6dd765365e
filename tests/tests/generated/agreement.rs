//! The crate and the engine agree: every shipped family is generated, and its curves are those of the exact formulas.

use basis_engine::algebra::range::DisplayRange as _;
use std::collections::BTreeSet;

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_runtime::{Array, Curve, Scalar};
use basis_tests::each_family;
use basis_tests::exact::{epsilon, fraction};
use basis_tests::families::Shipped;
use basis_tests::random::Random;

fn family<B: Shipped>(seen: &mut BTreeSet<String>) {
    seen.insert(B::reference().family.name.clone());
}

/// A new family in the library needs a line in `families.rs`.
#[test]
fn every_shipped_family_is_tested() {
    let mut tested = BTreeSet::new();
    each_family!(f64, family, &mut tested);
    // Families on triangles and in several variables are tested in `patches.rs`.
    basis_tests::all_are_tested(&tested, |family| family.interval().is_some());
}

fn constants<B: Shipped>() {
    let reference = B::reference();
    assert_eq!(B::NAME, reference.family.title());
    assert_eq!(B::LEN, reference.family.functions.len());
    let (var, low, high) = reference.family.interval().expect("one domain variable");
    assert_eq!(B::DEGREE, reference.family.degree(var) as usize);
    assert_eq!(B::domain().map(fraction), [low.clone(), high.clone()]);
}

#[test]
fn in_name_length_degree_and_domain() {
    each_family!(f64, constants);
    each_family!(f32, constants);
}

/// Σ bᵢ(t) Pᵢ and its first two derivatives, against Σ |bᵢ| |Pᵢ| and the like for rounding.
fn curves<B: Shipped>() {
    let (reference, random) = (B::reference(), &mut Random::new(21));
    let [lo, hi] = B::domain().map(Scalar::to_f64);
    for shape in reference.shapes::<B::Scalar>(6, random) {
        let (basis, exact) = (B::with(&shape).expect("inside the range"), reference.at(&shape));
        let bezier = exact.bernstein_coefficients();
        for _ in 0..6 {
            let t = B::Scalar::of(lo + (hi - lo) * random.unit::<f64>());
            let points = B::Points::from_fn(|_| random.between::<B::Scalar>(-1.0, 1.0));
            let curve = Curve::new(basis, points);
            let sizes = bezier.iter().map(|c| c.iter().map(|c| c.to_f64().abs()).fold(0.0, f64::max));
            let mut bound: f64 = sizes.zip(points.as_ref()).map(|(c, p)| c * p.to_f64().abs()).sum();
            for (order, actual) in curve.eval_with_derivs::<4>(t).into_iter().enumerate() {
                let functions = exact.derivatives(&fraction(t), order);
                let terms = functions.iter().zip(points.as_ref()).map(|(b, p)| b * &fraction(*p));
                let expected = terms.fold(Rational::ZERO, |sum, term| sum + term);
                let error = (&fraction(actual) - &expected).to_f64().abs();
                let tolerance = 12.0 * epsilon::<B::Scalar>() * bound;
                assert!(
                    error <= tolerance,
                    "{} {shape:?}, order {order} at {t}: {actual} for {expected}",
                    B::NAME
                );
                bound *= 2.0 * B::DEGREE.saturating_sub(order).max(1) as f64 / (hi - lo);
            }
            assert_eq!(curve.eval(t), curve.eval_with_derivs::<1>(t)[0]);
        }
    }
}

#[test]
fn on_curves() {
    each_family!(f64, curves);
    each_family!(f32, curves);
}

fn refuses<B: Shipped>() {
    let reference = B::reference();
    for (k, parameter) in reference.family.shapes.iter().enumerate() {
        let mut shape: Vec<B::Scalar> = reference.shape(&mut Random::new(1));
        let outside = |v: Option<&Rational>, by: f64| v.map(|v| B::Scalar::of(v.to_f64() + by));
        let wrong = [
            outside(parameter.range.low.value(), -1e-3),
            outside(parameter.range.high.value(), 1e-3),
            Some(B::Scalar::of(f64::NAN)),
            Some(B::Scalar::of(f64::INFINITY)),
            Some(B::Scalar::of(f64::NEG_INFINITY)),
        ];
        for value in wrong.into_iter().flatten() {
            shape[k] = value;
            let error = B::with(&shape).expect_err("outside of the range");
            assert_eq!(error.parameter(), parameter.name);
            assert_eq!(error.range(), parameter.range.display(&parameter.name).to_string());
        }
        for (end, included) in [&parameter.range.low, &parameter.range.high]
            .into_iter()
            .filter_map(|end| Some((end.value()?, end.is_included())))
        {
            shape[k] = B::Scalar::of(end.to_f64());
            assert_eq!(B::with(&shape).is_ok(), included, "{} at {}", B::NAME, shape[k]);
        }
    }
}

#[test]
fn on_the_declared_ranges() {
    each_family!(f64, refuses);
    each_family!(f32, refuses);
}
