//! Values, derivatives and Bernstein coefficients of families on triangles, tetrahedra and boxes against the exact
//! fractions of their specs.

use std::collections::BTreeSet;

use basis_engine::Verdict;
use basis_engine::algebra::poly::{Poly, PolyExt};
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::plan::patch::form::PatchForm;
use basis_engine::{Disk, Subject, source};
use basis_runtime::Scalar;
use basis_tests::each_patch;
use basis_tests::exact::{Reference, epsilon, fraction};
use basis_tests::patches::{
    Bilinear, ShippedPatch, TriangularBernstein, TriangularI, TriangularI3, TriangularI8, TriangularII,
    TriangularII5, TriangularII8, exact,
};
use basis_tests::random::Random;

/// The sum of the absolute values of the terms in Bernstein form: what rounding errors are proportional to.
fn sizes<S: Scalar>(reference: &Reference, shape: &[S]) -> Vec<f64> {
    let family = &reference.family;
    let form = PatchForm::new(family).expect("a patch");
    let mut point: Vec<Rational> = shape.iter().map(|x| fraction(*x)).collect();
    point.resize(family.names.len(), Rational::ZERO);
    let absolute: Vec<Rational> = point.iter().map(Rational::abs).collect();
    let size = |p: &Poly| Poly::from_terms(p.terms().map(|(m, c)| (m.clone(), c.abs()))).eval(&absolute);
    form.functions
        .iter()
        .map(|f| {
            let denom = f.denom.eval(&point).recip().expect("no pole");
            f.bernstein.iter().map(|p| (&size(p) * &denom).to_f64().abs()).fold(0.0, f64::max)
        })
        .collect()
}

fn derivatives<B: ShippedPatch>() {
    let (reference, random, n) = (B::reference(), &mut Random::new(31), B::degree());
    let variables = reference.family.domain.len();
    let width = reference.family.domain.iter().filter_map(|p| p.range.finite());
    let width = width.map(|(a, b)| (b - a).to_f64()).fold(1.0, f64::min);
    // Exact values of the largest families take long.
    let (shapes, rounds) = if n < 8 { (3, 12) } else { (1, 4) };
    for shape in reference.shapes::<B::Scalar>(shapes, random) {
        let basis = B::with(&shape).expect("inside the range");
        let sizes = sizes(&reference, &shape);
        for round in 0..rounds {
            let at = B::point(&reference, random);
            let mut orders = vec![0; variables];
            for _ in 0..round % 4 {
                orders[random.below(variables)] += 1;
            }
            let order: usize = orders.iter().sum();
            let actual = basis.partials(&at, &orders);
            let expected = exact(&reference, &shape, &at, &orders);
            assert_eq!(actual.len(), expected.len());
            // Each derivative makes differences of Bernstein coefficients, times the degree.
            let growth = (0..order).map(|k| 2.0 * n.saturating_sub(k) as f64 / width).product::<f64>();
            let power = ((2 * variables * (n + 4)) as f64) * epsilon::<B::Scalar>();
            for ((a, e), size) in actual.iter().zip(&expected).zip(&sizes) {
                let error = (&fraction(*a) - e).to_f64().abs();
                let tolerance = power * growth.max(1.0) * size;
                let title = reference.family.title();
                assert!(
                    error <= tolerance,
                    "{title} {shape:?} {orders:?} at {at:?}: {a} for {e}, off by {error}"
                );
            }
        }
        let at = B::point(&reference, random);
        assert_eq!(basis.partials(&at, &vec![0; variables]), basis.values(&at));
        let zero = basis.partials(&at, &vec![n + 1; variables]);
        assert!(zero.iter().all(|d| *d == B::Scalar::ZERO));
    }
}

#[test]
fn have_exact_derivatives_up_to_rounding() {
    each_patch!(f64, derivatives);
    each_patch!(f32, derivatives);
}

/// Bernstein coefficients against those of the engine, which knows nothing of the recursion; with their exact sign, so
/// that what is proved holds for the floats.
fn coefficients<B: ShippedPatch>() {
    let reference = B::reference();
    let family = &reference.family;
    let form = PatchForm::new(family).expect("a patch");
    for shape in reference.shapes::<B::Scalar>(3, &mut Random::new(32)) {
        let mut point: Vec<Rational> = shape.iter().map(|x| fraction(*x)).collect();
        point.resize(family.names.len(), Rational::ZERO);
        let actual = B::with(&shape).expect("inside the range").bernstein_coefficients();
        assert_eq!(actual.len(), form.functions.len());
        for ((row, f), size) in actual.iter().zip(&form.functions).zip(sizes(&reference, &shape)) {
            assert_eq!(row.len(), f.bernstein.len());
            let denom = f.denom.eval(&point).recip().expect("no pole");
            for (a, p) in row.iter().zip(&f.bernstein) {
                let e = &p.eval(&point) * &denom;
                let error = (&fraction(*a) - &e).to_f64().abs();
                let title = family.title();
                assert!(error <= 12.0 * epsilon::<B::Scalar>() * size, "{title} {shape:?}: {a} for {e}");
            }
        }
    }
}

#[test]
fn have_exact_bernstein_coefficients_up_to_rounding() {
    each_patch!(f64, coefficients);
    each_patch!(f32, coefficients);
}

/// The largest relative error of a value, in ε; all functions are nonnegative.
fn worst<B: ShippedPatch>(seed: u64, points: usize) -> f64 {
    let (reference, random) = (B::reference(), &mut Random::new(seed));
    let smallest = if size_of::<B::Scalar>() == 4 { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
    let mut worst = 0.0_f64;
    for _ in 0..points {
        let shape: Vec<B::Scalar> = reference.shape(random);
        let at = B::point(&reference, random);
        let values = B::with(&shape).expect("inside the range").values(&at);
        for (value, exact) in values.iter().zip(exact(&reference, &shape, &at, &[])) {
            assert!(value.to_f64() >= 0.0, "{} {shape:?} at {at:?}: {value}", reference.family.title());
            if exact.is_zero() {
                assert_eq!(value.to_f64(), 0.0, "{} {shape:?} at {at:?}", reference.family.title());
            } else if exact.to_f64() > 64.0 * smallest {
                let error = (&fraction(*value) - &exact).to_f64().abs() / exact.to_f64();
                worst = worst.max(error / epsilon::<B::Scalar>());
            }
        }
    }
    println!("{} in {}: {worst:.2} ε", reference.family.title(), core::any::type_name::<B::Scalar>());
    worst
}

/// Over the whole ranges of the shape parameters, on and next to edges and corners.
#[test]
fn have_a_small_relative_error_and_are_never_negative() {
    assert!(worst::<Bilinear<f32>>(41, 1000) <= 3.0);
    assert!(worst::<Bilinear<f64>>(42, 500) <= 3.0);
    assert!(worst::<TriangularBernstein<f32>>(43, 1000) <= 3.0);
    assert!(worst::<TriangularI<f32>>(44, 400) <= 4.0);
    assert!(worst::<TriangularI<f64>>(45, 150) <= 4.0);
    assert!(worst::<TriangularII<f32>>(46, 400) <= 4.0);
    assert!(worst::<TriangularII<f64>>(47, 150) <= 4.0);
    assert!(worst::<TriangularI3<f32>>(48, 100) <= 4.0);
    assert!(worst::<TriangularII5<f32>>(49, 60) <= 4.0);
    assert!(worst::<TriangularII5<f64>>(50, 30) <= 4.0);
    assert!(worst::<TriangularII8<f32>>(51, 8) <= 4.0);
    assert!(worst::<TriangularI8<f32>>(52, 4) <= 4.0);
}

fn family<B: ShippedPatch>(seen: &mut BTreeSet<String>) {
    seen.insert(B::reference().family.name.clone());
}

/// A new family in the library needs a line in `patches.rs`.
#[test]
fn every_shipped_family_is_tested() {
    let mut tested = BTreeSet::new();
    each_patch!(f64, family, &mut tested);
    basis_tests::all_are_tested(&tested, |family| family.interval().is_none());
}

/// What is proved nonnegative has no negative coefficient in the code.
#[test]
fn proved_families_have_nonnegative_factors() {
    for name in ["triangular.basis", "lagrange.basis"] {
        let path = basis_tests::spec(name).to_string_lossy().into_owned();
        let report = basis_engine::check(source::read(&Disk, &path, &[]).expect("readable"));
        for item in &report.items {
            let Subject::Family(family) = &item.subject else { continue };
            let proved = item
                .claims
                .iter()
                .any(|(claim, verdict)| claim.text == "nonnegative" && matches!(verdict, Verdict::Proved(_)));
            if proved && family.interval().is_none() && family.functions.len() <= 21 {
                let form = PatchForm::new(family).expect("a patch");
                let corner: Vec<Rational> = family.names.iter().map(|_| Rational::ONE).collect();
                for p in form.functions.iter().flat_map(|f| &f.inner) {
                    assert!(!p.eval(&corner).is_negative(), "{}", family.title());
                }
            }
        }
    }
}
