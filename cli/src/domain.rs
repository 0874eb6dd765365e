//! Domains as the spec writes them, degrees on them, and what theorems are about.

use basis_engine::Family;
use basis_engine::Theorem;
use basis_engine::model::Factor;
use basis_engine::model::angle::Kind;

/// The domain, such as `0 <= t <= 1` or `triangle (u, v, w)`.
pub(crate) fn describe(family: &Family) -> String {
    family.domain_text()
}

/// What is assumed of the shape parameters beside their ranges, such as `α^2 + β^2 <= 1`, and what follows for those that
/// an equation determines.
pub(crate) fn assumptions(family: &Family) -> Vec<String> {
    let conditions = family.assumed().map(|c| c.text.clone());
    let values = family.determined.iter().map(|(name, f)| format!("{name} = {}", f.display(&family.names)));
    conditions.chain(values).collect()
}

/// A title with the curves, surfaces and scalars of a theorem, such as `join G1: P = Quadratic(λ); -2 <= λ <= 1`.
pub(crate) fn theorem_heading(theorem: &Theorem, title: &str) -> String {
    let patches: Vec<String> =
        theorem.patches.iter().map(|p| format!("{} = {}", p.name, p.written)).collect();
    let mut facts = vec![patches.join(", "), theorem.conditions().join(", ")];
    facts.retain(|fact| !fact.is_empty());
    format!("{title}: {}\n", facts.join("; "))
}

/// The functions that stand in a family beside polynomials: it has no degree in its domain variable.
pub(crate) fn transcendental(family: &Family) -> Option<&'static str> {
    let kind = |family: &Family| family.domain.iter().find_map(|p| Some(family.analytic.angle(p.var)?.kind));
    let kinds =
        || core::iter::once(kind(family)).chain(family.pieces.iter().map(|piece| kind(piece))).flatten();
    if kinds().any(|kind| kind == Kind::Circular) {
        Some("with sine and cosine")
    } else {
        kinds().any(|kind| kind == Kind::Hyperbolic).then_some("with exponentials")
    }
}

/// The degree for each factor of the domain: in its variable, or in all coordinates of a simplex together.
pub(crate) fn degrees(family: &Family) -> Vec<u32> {
    let degree = |factor: Factor<'_>| match factor {
        Factor::Interval(p) => family.degree(p.var),
        Factor::Simplex(independent, _) => {
            let terms = family.functions.iter().flat_map(|f| f.value.numer().terms());
            let degrees = terms
                .map(|(monomial, _)| independent.iter().map(|p| u32::from(monomial.exponent(p.var))).sum());
            degrees.max().unwrap_or(0)
        }
    };
    let own: Vec<u32> = family.factors().into_iter().map(degree).collect();
    // Of several spans the one of the highest degree counts.
    let others = family.pieces.iter().flat_map(|piece| degrees(piece));
    if let [only] = own[..] { vec![others.fold(only, u32::max)] } else { own }
}
