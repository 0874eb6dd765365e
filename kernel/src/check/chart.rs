//! Simplices as images of boxes.
//!
//! **Theorem.** The simplex xᵢ ≥ 0, x₁ + … + xₖ ≤ c is the image of the unit box under x₁ = c(1 − s₁), x₂ = c·s₁(1 −
//! s₂), x₃ = c·s₁s₂(1 − s₃), …; so p ≥ 0 (> 0) holds on the simplex if and only if it does on the box, with these
//! polynomials in place of the xᵢ.
//!
//! *Proof.* c·s₁⋯sᵢ is what x₁, …, xᵢ leave of c. It determines sᵢ unless nothing was left before, and then any number
//! will do for sᵢ.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::work::Work;
use crate::refusal::{Refusal, fits};
use crate::statement::Domain;

/// The largest number of a variable.
const MAX_VARIABLE: usize = 1 << 20;

/// The way from a box to a domain with simplices.
#[derive(Clone, Debug)]
pub struct Chart {
    region: Region,
    /// The variables of the simplices as polynomials in variables of the box.
    by: Vec<(Var, Poly)>,
}

impl Chart {
    /// The chart of a domain on which polynomials are looked at. The variables sᵢ of the box follow those that occur in
    /// the domain or in the polynomials, simplex by simplex. Premises play no part: what holds without them holds with
    /// them.
    ///
    /// # Errors
    /// When a variable belongs to two simplices or has a range beside, or a simplex has no variable.
    pub fn new(domain: &Domain, values: [&Poly; 2]) -> Result<Self, Refusal> {
        let mut region = domain.region.clone();
        let mut by: Vec<(Var, Poly)> = Vec::new();
        if domain.simplices.is_empty() {
            return Ok(Self { region, by });
        }
        let simplices = domain.simplices.iter().flat_map(|s| s.variables.iter().copied());
        let occurring = values.into_iter().flat_map(Poly::variables);
        let ranges = domain.region.ranges.iter().map(|(v, _)| *v);
        let mut next =
            occurring.chain(ranges).chain(simplices).map(|v| v.0.saturating_add(1)).max().unwrap_or(0);
        let count: usize = domain.simplices.iter().map(|s| s.variables.len()).sum();
        fits(next <= MAX_VARIABLE && count <= MAX_VARIABLE, "there are too many variables")?;
        for simplex in &domain.simplices {
            fits(!simplex.variables.is_empty() && !simplex.sum.is_negative(), "a simplex has no points")?;
            let mut rest = Poly::constant(simplex.sum.clone());
            for var in &simplex.variables {
                let free =
                    domain.region.ranges.iter().all(|(v, _)| v != var) && by.iter().all(|(v, _)| v != var);
                fits(free, "a variable of a simplex has a range beside")?;
                let s = Var(next);
                next += 1;
                region.ranges.push((s, Range::unit()));
                by.push((*var, &rest * &(&Poly::one() - &Poly::var(s))));
                rest = &rest * &Poly::var(s);
            }
        }
        Ok(Self { region, by })
    }

    /// The box.
    pub const fn region(&self) -> &Region {
        &self.region
    }

    /// The polynomial in the variables of the box; the work is counted.
    pub(super) fn counted(&self, polynomial: &Poly, work: &mut Work) -> Result<Poly, Refusal> {
        let mut p = polynomial.clone();
        for (var, by) in &self.by {
            let too_high = if p.total_degree() < 1 << 14 { 0 } else { u64::MAX };
            work.spend(cost(&p, *var, by).max(too_high)).ok_or(Refusal::Spent)?;
            p = p.substitute(*var, by);
        }
        Ok(p)
    }

    /// The variables of the simplices as polynomials in variables of the box.
    pub fn variables(&self) -> &[(Var, Poly)] {
        &self.by
    }
}

/// Of putting a polynomial in place of a variable: of xᵉ become e + 1 terms.
fn cost(p: &Poly, var: Var, by: &Poly) -> u64 {
    let (degree, growth) = (u64::from(p.degree(var)), 2 + by.max_bits());
    let words = 1 + (p.max_bits() + degree * growth) / 64;
    (6 * p.len() as u64 * (degree + 1)).saturating_mul(words)
}
