//! Domains as the spec writes them, degrees on them, and what theorems are about.

use basis_engine::Family;
use basis_engine::Theorem;
use basis_engine::algebra::range::DisplayRange as _;

/// The domain, such as `0 <= t <= 1` or `triangle (u, v, w)`.
pub(crate) fn describe(family: &Family) -> String {
    if family.is_simplex() {
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
        let shape = if names.len() == 3 { "triangle" } else { "tetrahedron" };
        return format!("{shape} ({})", names.join(", "));
    }
    let ranges: Vec<String> = family.domain.iter().map(|p| family.declared(p)).collect();
    ranges.join(", ")
}

/// A title with the curves, surfaces and scalars of a theorem, such as `join G1: P = Quadratic(λ); -2 <= λ <= 1`.
pub(crate) fn theorem_heading(theorem: &Theorem, title: &str) -> String {
    let patches: Vec<String> =
        theorem.patches.iter().map(|p| format!("{} = {}", p.name, p.written)).collect();
    let scalars: Vec<String> = theorem.scalars.iter().map(|p| p.range.display(&p.name).to_string()).collect();
    let mut facts = vec![patches.join(", "), scalars.join(", ")];
    facts.retain(|fact| !fact.is_empty());
    format!("{title}: {}\n", facts.join("; "))
}

/// The degree in each variable of a box; the only one, in all variables together, on a simplex.
pub(crate) fn degrees(family: &Family) -> Vec<u32> {
    if !family.is_simplex() {
        return family.domain.iter().map(|p| family.degree(p.var)).collect();
    }
    let terms = family.functions.iter().flat_map(|f| f.value.numer().terms());
    let degrees =
        terms.map(|(monomial, _)| family.domain.iter().map(|p| u32::from(monomial.exponent(p.var))).sum());
    vec![degrees.max().unwrap_or(0)]
}
