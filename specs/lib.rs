//! The library of basis families: the texts of the spec files in this package, by name.
//!
//! A name is the path of the file without its ending: `quartic` is `quartic.basis`, `papers/quartic` is the file
//! `papers/quartic.basis` with every claim of a paper. What each family is, where it comes from and what is proved of
//! it stands in the files. They are used as
//!
//! - `basis!(library "quartic")` in Rust, with basis-runtime,
//! - `use library "quartic";` in other specs,
//! - `basis check library:quartic` at a terminal.
//!
//! ```
//! assert!(basis_specs::text("quartic").is_some_and(|text| text.contains("family QuarticBernstein")));
//! ```
#![no_std]

macro_rules! specs {
    ($($name:literal)*) => { &[$(($name, include_str!(concat!($name, ".basis")))),*] };
}

/// All specs, as names with their texts, sorted by name.
pub static SPECS: &[(&str, &str)] = specs![
    "ball"
    "bernstein"
    "beta_spline"
    "bspline"
    "cardinal"
    "curves/ball"
    "curves/exponents"
    "curves/lambda"
    "curves/q_analogues"
    "delgado_pena"
    "elements"
    "elements/beams"
    "elements/boxes"
    "hermite"
    "joins/blends"
    "joins/easing"
    "kernels/soft"
    "kernels/statistics"
    "kernels/wavelets"
    "kochanek_bartels"
    "lagrange"
    "papers/bspline"
    "papers/quadratic"
    "papers/quartic"
    "papers/revolution"
    "papers/triangular"
    "polynomials/chebyshev"
    "polynomials/discrete"
    "polynomials/orthogonal"
    "polynomials/sequences"
    "quadratic"
    "quartic"
    "quartic_surface"
    "rational/barycentric"
    "rational/bezier"
    "rational/circles"
    "rational/interpolation"
    "rational/lupas"
    "rational/tension"
    "smoothstep"
    "splines/bspline"
    "splines/kernels"
    "splines/segments"
    "splines/tension"
    "splines/uniform"
    "triangles/elements"
    "triangles/patches"
    "triangles/prisms"
    "triangles/shape"
    "triangular"
    "trigonometric/end_angle"
    "trigonometric/han"
    "trigonometric/kernels"
    "trigonometric/mixed"
    "trigonometric/shape"
];

/// The text of the spec with this name; `None` where the library has no such spec.
#[must_use]
pub fn text(name: &str) -> Option<&'static str> {
    SPECS.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

#[cfg(doctest)]
#[doc = include_str!("README.md")]
struct Readme;
