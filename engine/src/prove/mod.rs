//! Decides claims: every kind of claim has a file, and every verdict its certificate or its witness.

mod identity;
mod independent;
mod inequality;
mod point;
mod report;

pub use report::diagnose;

use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::decide::{Coordinate, Proof};
use crate::model::{Claim, ClaimKind, Comparison, Expected, Family};

/// What is known about a claim.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The claim is true.
    Proved(Evidence),
    /// The claim is false.
    Refuted(Witness),
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// Why a claim is true.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// The method in a few words; where several steps were needed, the most elaborate one.
    pub method: String,
    /// One proof for each polynomial that the claim is about.
    pub steps: Vec<Step>,
}

/// A polynomial and the proof of what is claimed of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// The expression as text, such as `b[1]`.
    pub of: String,
    /// The proof.
    pub proof: StepProof,
}

/// The kinds of proofs.
#[derive(Clone, Debug)]
pub enum StepProof {
    /// After expansion nothing is left.
    Identity,
    /// The sign of a polynomial on the declared ranges.
    Sign {
        /// The polynomial.
        polynomial: crate::algebra::poly::Poly,
        /// What is proved of it.
        relation: crate::decide::Relation,
        /// Where.
        region: crate::algebra::range::Region,
        /// The proof.
        proof: Proof,
    },
    /// The rank of the coefficient table.
    Independence(independent::RankProof),
}

#[cfg(feature = "tools")]
pub(crate) use independent::combination_text;
pub use independent::{RankProof, coefficient_table};

/// A point at which a claim fails.
#[derive(Clone, Debug)]
pub struct Witness {
    /// The expression whose value contradicts the claim; for an equation left side minus right side.
    pub of: String,
    /// The point: every shape parameter and domain variable.
    pub at: Vec<(String, Coordinate)>,
    /// The exact value of the expression there.
    pub value: Rational,
    /// What it means, in one line each.
    pub notes: Vec<String>,
}

impl Witness {
    /// The point as text, such as `λ = 1, t = 1/2`.
    pub fn point(&self) -> String {
        let parts: Vec<String> = self.at.iter().map(|(name, c)| c.describe(name)).collect();
        parts.join(", ")
    }
}

/// Decides a claim about a family.
pub fn claim(family: &Family, claim: &Claim) -> Verdict {
    match &claim.kind {
        ClaimKind::PartitionOfUnity => identity::partition_of_unity(family),
        ClaimKind::Symmetric => identity::symmetric(family),
        ClaimKind::Continuity(order) => identity::continuity(family, *order),
        ClaimKind::Nonnegative => inequality::nonnegative(family),
        ClaimKind::Independent(except) => independent::independent(family, except),
        ClaimKind::Relation { comparison: Comparison::Equal, differences, fixed } => {
            identity::equations(family, differences, fixed)
        }
        ClaimKind::Relation { comparison, differences, fixed } => {
            inequality::relation(family, *comparison, differences, fixed)
        }
    }
}

/// Whether a verdict is the one that the author of the claim declared.
pub const fn as_declared(expected: Expected, verdict: &Verdict) -> bool {
    matches!(
        (expected, verdict),
        (Expected::True, Verdict::Proved(_)) | (Expected::False, Verdict::Refuted(_))
    )
}

/// A point of the variables as a point of the names, complete with what `at` fixes.
fn named_point(
    family: &Family,
    point: &[(Var, Coordinate)],
    fixed: &[(Var, crate::algebra::fraction::Fraction)],
) -> Vec<(String, Coordinate)> {
    let mut rational = vec![Rational::ZERO; family.names.len()];
    for (var, c) in point {
        if let (Some(slot), Coordinate::Rational(value)) = (rational.get_mut(var.0), c) {
            *slot = value.clone();
        }
    }
    let mut all: Vec<(String, Coordinate)> = family
        .shapes
        .iter()
        .chain(&family.domain)
        .map(|p| {
            let fixed_value = fixed.iter().find(|(v, _)| *v == p.var).and_then(|(_, f)| f.eval(&rational));
            let given = point.iter().find(|(v, _)| *v == p.var).map(|(_, c)| c.clone());
            let value = fixed_value
                .map(Coordinate::Rational)
                .or(given)
                .unwrap_or_else(|| Coordinate::Rational(point::simple(&p.range)));
            (p.name.clone(), value)
        })
        .collect();
    if let Some(last) = &family.dependent {
        let mut rest = Some(Rational::ONE);
        for (_, c) in &all[family.shapes.len()..] {
            rest = match (rest, c) {
                (Some(rest), Coordinate::Rational(x)) => Some(&rest - x),
                _ => None,
            };
        }
        all.extend(rest.map(|rest| (last.name.clone(), Coordinate::Rational(rest))));
    }
    all
}
