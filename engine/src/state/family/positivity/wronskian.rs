//! Functions that are totally positive, and functions that are not, by their Wronskians.
//!
//! **Theorem.** Let all minors of (b[j](t_i)) at points t_0 < t_1 < … of an interval be ≥ 0. Then on the interval all Wronskians
//! det(D(b[j], i)), i = 0, …, k, of functions j_0 < … < j_k are ≥ 0.
//!
//! *Proof.* Where all points go to t, the minor over ∏ (t_j − t_i), i < j, goes to the Wronskian at t over ∏ i!: by subtracting rows
//! it is the determinant of the divided differences, and these go to the derivatives over i! (S. Karlin, "Total Positivity", 1968,
//! chapter 2). The products are > 0.
//!
//! **Theorem.** Let the Wronskians of all neighbouring functions j, j + 1, …, j + k be > 0 inside of the interval, that of all
//! functions only ≥ 0. Then all minors of the functions are ≥ 0.
//!
//! *Proof.* At a point inside the numbers D(b[j], i) are a matrix, of which the minors of the rows 0, …, k and of neighbouring
//! columns are > 0. So are those of any columns in ascending order (M. Fekete, by the identities between minors that differ in one
//! column). A function c₀b[j₀] + … + cₖb[jₖ] whose Wronskians W(j₀), W(j₀, j₁), … are > 0 has at most k zeros inside (G. Pólya, by
//! dividing by the first function and differentiating), and the minor at ascending points, which is an integral of such minors of
//! the derivatives of the quotients b[jᵢ]/b[j₀], is > 0, and ≥ 0 where the last Wronskian is. At the ends it follows by continuity.
//!
//! Points at which a Wronskian is negative are found as of every expression, also where numbers like exp(1), or a variable beside its
//! sine, occur in it; the minors themselves have values at many points in them, between which nothing relates.

use basis_prover::collections::list::{Listed, Mapped};

use super::minors::determinant;
use crate::algebra::fraction::Fraction;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::{Family, Function};

/// The work for a first look for a point at which one is negative, before a proof is searched.
pub(in crate::state::family) const FIRST_LOOK: u64 = 2_000_000;

/// The work for finding such a point where there is no proof.
pub(in crate::state::family) const WORK: u64 = 20_000_000;

/// The work for a first proof, before another kind of proof gets all that there is.
pub(in crate::state::family) const FIRST_PROOF: u64 = 2_000_000;

/// The number that stands in certificates for a proof by Wronskians, other than those of ways from assumptions.
pub(in crate::state::family) const BY_WRONSKIANS: usize = 99;

/// A method in words.
pub(in crate::state::family) const METHOD: &str = "positive Wronskians of neighbouring functions";

/// The family on its domain without ends.
pub(in crate::state::family) fn inside(family: &Family) -> Family {
    let mut inside = family.clone();
    for parameter in &mut inside.domain {
        parameter.range = basis_prover::sign::open(&parameter.range);
    }
    inside
}

/// What is enough for all minors to be ≥ 0; `None` when the work is spent.
pub(in crate::state::family) fn sufficient(
    family: &Family,
    work: &mut Work,
) -> Option<Vec<(String, Fraction, Comparison)>> {
    let count = family.functions.len();
    let mut jets = family.functions.mapped(|f| vec![f.value.clone()]);
    let mut all = Vec::new();
    for size in 1..=count {
        if size > 1 {
            differentiate(family, &mut jets, work)?;
        }
        for first in 0..=count - size {
            let (of, value) = wronskian(family, &jets, &(first..first + size).listed(), work)?;
            let comparison = if size == count { Comparison::GreaterEqual } else { Comparison::Greater };
            all.push((of, value, comparison));
        }
    }
    Some(all)
}

/// The Wronskians that are looked at: of one function each, of all pairs, and of neighbouring functions; those for which the work
/// suffices.
pub(in crate::state::family) fn conditions(
    family: &Family,
    work: &mut Work,
) -> Vec<(String, Fraction, Comparison)> {
    let functions = family.functions.iter().enumerate();
    let single =
        |(k, f): (usize, &Function)| (family.function_label(k), f.value.clone(), Comparison::GreaterEqual);
    let mut all = functions.map(single).listed();
    let mut jets = family.functions.mapped(|f| vec![f.value.clone()]);
    for size in 2..=jets.len() {
        let done = differentiate(family, &mut jets, work).and_then(|()| of_size(family, &jets, size, work));
        let Some(wronskians) = done else { break };
        all.extend(wronskians);
    }
    all
}

/// The Wronskian of some functions, of which all derivatives are given that it contains, and its name.
fn wronskian(
    family: &Family,
    jets: &[Vec<Fraction>],
    functions: &[usize],
    work: &mut Work,
) -> Option<(String, Fraction)> {
    let labels = functions.mapped(|k| family.function_label(*k));
    let of =
        if let [alone] = &labels[..] { alone.clone() } else { format!("Wronskian of {}", labels.join(", ")) };
    let value = determinant(functions.mapped(|k| jets[*k].clone()), work)?;
    Some((of, family.analytic.reduced(value)))
}

/// Adds the next derivative to those of each function.
fn differentiate(family: &Family, jets: &mut [Vec<Fraction>], work: &mut Work) -> Option<()> {
    let (var, ..) = family.interval()?;
    for jet in jets {
        let next = family.derivative_within(jet.last()?, var, work)?;
        jet.push(family.analytic.reduced(next));
    }
    Some(())
}

/// The Wronskians of two functions each, of all pairs; of more, those of neighbouring functions.
fn of_size(
    family: &Family,
    jets: &[Vec<Fraction>],
    size: usize,
    work: &mut Work,
) -> Option<Vec<(String, Fraction, Comparison)>> {
    let mut all = Vec::new();
    for first in 0..=jets.len() - size {
        let last = if size == 2 { jets.len() } else { first + 2 };
        for second in first + 1..last {
            let functions = core::iter::once(first).chain(second..second + size - 1);
            let (of, value) = wronskian(family, jets, &functions.listed(), work)?;
            all.push((of, value, Comparison::GreaterEqual));
        }
    }
    Some(all)
}
