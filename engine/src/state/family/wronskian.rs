//! Functions that are not totally positive, by their Wronskians.
//!
//! **Theorem.** Let all minors of (b[j](t_i)) at points t_0 < t_1 < … of an interval be ≥ 0. Then on the interval all Wronskians
//! det(D(b[j], i)), i = 0, …, k, of functions j_0 < … < j_k are ≥ 0.
//!
//! *Proof.* Where all points go to t, the minor over ∏ (t_j − t_i), i < j, goes to the Wronskian at t over ∏ i!: by subtracting rows
//! it is the determinant of the divided differences, and these go to the derivatives over i! (S. Karlin, "Total Positivity", 1968,
//! chapter 2). The products are > 0.
//!
//! Points at which a Wronskian is negative are found as of every expression, also where numbers like exp(1), or a variable beside its
//! sine, occur in it; the minors themselves have values at many points in them, between which nothing relates.

use basis_prover::collections::list::{Listed, Mapped};

use super::total::determinant;
use crate::algebra::fraction::Fraction;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::{Family, Function};

/// The work for a first look for a point at which one is negative, before a proof is searched.
pub(super) const FIRST_LOOK: u64 = 2_000_000;

/// The work for finding such a point where there is no proof.
pub(super) const WORK: u64 = 20_000_000;

/// The Wronskians that are looked at: of one function each, of all pairs, and of neighbouring functions; those for which the work
/// suffices.
pub(super) fn conditions(family: &Family, work: &mut Work) -> Vec<(String, Fraction, Comparison)> {
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
            let functions = functions.listed();
            let rows = functions.mapped(|k| jets[*k].clone());
            let value = family.analytic.reduced(determinant(rows, work)?);
            let labels = functions.mapped(|k| family.function_label(*k));
            all.push((format!("Wronskian of {}", labels.join(", ")), value, Comparison::GreaterEqual));
        }
    }
    Some(all)
}
