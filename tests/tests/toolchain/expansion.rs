//! The generated code of a few families, to be read whenever it changes: `INSTA_UPDATE=always cargo test -p
//! basis-tests --test toolchain expansion` writes the code of today into `snapshots`.

use basis_engine::{Disk, Library, Prover, Request, Requested, expand, source};
use proc_macro2::Span;

/// The formatted code of one family of a file.
fn code(file: &str, family: &str, order: &[i64]) -> String {
    let path = basis_tests::spec(file).to_string_lossy().into_owned();
    let library = Library::from_source(&Disk, &Prover, source::read(&Disk, &path, &[]).unwrap());
    let family =
        Requested { name: family.to_string(), span: Span::call_site(), order: order.to_vec(), rename: None };
    let runtime = "::basis_runtime".parse().unwrap();
    let (tokens, diagnostics) = expand(&library, &Request { families: vec![family], runtime });
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    prettyplease::unparse(&syn::parse2(tokens).unwrap())
}

#[test]
fn of_a_shape_parameter() {
    insta::assert_snapshot!("quadratic", code("quadratic.basis", "QuadraticBezier", &[]));
    insta::assert_snapshot!("quartic", code("quartic.basis", "QuarticBernstein", &[]));
}

#[test]
fn of_rational_coefficients() {
    insta::assert_snapshot!("beta_spline", code("beta_spline.basis", "BetaSpline", &[]));
}

#[test]
fn of_an_index_parameter() {
    insta::assert_snapshot!("bernstein_3", code("bernstein.basis", "Bernstein", &[3]));
}

#[test]
fn of_another_domain() {
    insta::assert_snapshot!("quadric", code("../tests/specs/good/quadric.basis", "Quadric", &[]));
}

/// Above degree 4 curves are bound in Bernstein form.
#[test]
fn of_high_degree() {
    let form = |degree: i64| {
        let code = code("bernstein.basis", "Bernstein", &[degree]);
        let code: String = code.split_whitespace().collect();
        (code.contains("::EndpointForm<P,3"), code.contains("::BernsteinForm<P,6"))
    };
    assert_eq!(form(4), (true, false));
    assert_eq!(form(5), (false, true));
}

#[test]
fn of_a_triangle() {
    insta::assert_snapshot!("triangular_2", code("triangular.basis", "TriangularII", &[4]));
}

#[test]
fn of_a_join() {
    insta::assert_snapshot!("quadratic_g2", code("quadratic.basis", "G2", &[]));
    insta::assert_snapshot!("quartic_surface_g1_uu", code("quartic_surface.basis", "G1UU", &[]));
}

#[test]
fn of_a_box() {
    insta::assert_snapshot!("serendipity", code("lagrange.basis", "Serendipity", &[]));
}
