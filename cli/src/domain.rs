//! Domains as the spec writes them, and degrees on them.

use basis_engine::Family;

/// The domain, such as `0 <= t <= 1` or `triangle (u, v, w)`.
pub(crate) fn describe(family: &Family) -> String {
    if family.is_simplex() {
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
        let shape = if names.len() == 3 { "triangle" } else { "tetrahedron" };
        return format!("{shape} ({})", names.join(", "));
    }
    let ranges: Vec<String> = family.domain.iter().map(|p| p.range.display(&p.name).to_string()).collect();
    ranges.join(", ")
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
