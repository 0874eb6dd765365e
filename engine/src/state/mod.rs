//! From claims to statements, and from the kernel's answers to verdicts: every kind of claim has a file, among those
//! about a family or those about a theorem.
//!
//! A claim is true if all of its [`statements`] are. It is false if one of them is; a claim of a theorem about points
//! also if one of its [`instances`] is, which say the same of definite points.

mod family;
mod inequality;
mod judge;
mod parts;
mod proofs;
mod report;
mod run;
#[cfg(feature = "joins")]
mod theorem;
#[cfg(not(feature = "joins"))]
#[path = "no_theorem.rs"]
mod theorem;
mod verdict;

#[cfg(any(test, feature = "tools"))]
pub(crate) use family::premises::{inside, proved as proved_from_premises};
pub use family::{Table, statements as family_statements, table};
#[cfg(any(test, feature = "tools"))]
pub(crate) use family::{combination_text, moves};
#[cfg(any(test, feature = "rounding"))]
pub use family::{point_error, point_name, value_errors};
pub use judge::{Prover, ground_statements};
pub use parts::{FEW, Part, Standing, parts};
pub use report::diagnose;
pub use run::Run;
pub use verdict::{Evidence, Stated, Verdict, Witness, WitnessPoints, as_declared, point_text};

use basis_kernel::Statement;

use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::model::Family;
use crate::subject::Subject;

/// The family that a claim is about: its own, or that with the values which an `at` block gives to angles.
fn about<'a>(family: &'a Family, claim: &'a Claim) -> &'a Family {
    claim.about.as_deref().unwrap_or(family)
}

/// What a claim says, as statements of which all have to be true; `None` when the budget does not suffice to expand them.
///
/// Of a comparison in which an angle or exponent stands beside its sine or exponential, and of one under assumptions, there are
/// several ways to statements that are enough for it. Their numbers are those of [`Evidence::ways`]; each of them will do, and 0 stands for what is not
/// given.
pub fn statements(subject: &Subject, claim: &Claim, ways: &[usize]) -> Option<Vec<Stated>> {
    match subject {
        Subject::Family(family) => family::statements(about(family, claim), claim, ways),
        Subject::Theorem(theorem) => theorem::statements(theorem, claim, ways),
    }
}

/// What a claim says of definite points in place of the given ones of a theorem; of a family, what it says. It is false
/// if one of these statements is.
///
/// # Errors
/// When there is not one place for each given point, they have different dimensions, or the budget does not suffice.
pub fn instances(
    subject: &Subject,
    claim: &Claim,
    given: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    match subject {
        Subject::Family(family) if given.is_empty() => {
            let stated = family::refutable(about(family, claim), claim);
            stated.ok_or("the budget is spent on a common denominator")
        }
        Subject::Family(family) if matches!(claim.kind, crate::claim::ClaimKind::TotallyPositive) => {
            family::minors(about(family, claim), given)
        }
        Subject::Family(_) => Err("a family has no control points"),
        Subject::Theorem(theorem) => theorem::instances(theorem, claim, given),
    }
}

/// What a claim of a family says of `of` at a point, with bounds for π, exp(r) and angles beside their sines; and that
/// it fails whatever these are between the bounds. It is false if both are seen: that the first one fails at the point,
/// and the second one.
pub fn at_point(
    subject: &Subject,
    claim: &Claim,
    of: &str,
    point: &[(Var, Rational)],
) -> Option<[Statement; 2]> {
    match subject {
        Subject::Family(family) => family::at_point(about(family, claim), claim, of, point),
        Subject::Theorem(_) => None,
    }
}

/// Decides a claim about a family.
pub(crate) fn of_family(family: &Family, claim: &Claim) -> Verdict {
    family::decide(about(family, claim), claim)
}

/// Decides a claim.
pub fn decide(subject: &Subject, claim: &Claim) -> Verdict {
    let verdict = match subject {
        Subject::Family(family) => of_family(family, claim),
        Subject::Theorem(theorem) => theorem::decide(theorem, claim),
    };
    match verdict {
        // These go without saying.
        Verdict::Proved(evidence) if family::premises::are_first(evidence.ways()) => {
            Verdict::Proved(evidence.by(Vec::new()))
        }
        other => other,
    }
}
