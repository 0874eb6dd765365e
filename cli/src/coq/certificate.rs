//! Certificates of the kernel as those of `Basis.v`.

use std::rc::Rc;

use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_kernel::algebra::poly::Var;
use basis_kernel::algebra::work::Work;
use basis_kernel::{Certificate, Cuts, Proof, SignProof, Signed};

use super::formula::rational;

/// The proof of a sign with that of the denominator, for the independent variables in their order; what there is no
/// counterpart for.
pub(super) fn of(
    certificate: &Certificate,
    variables: &[(Var, Range)],
) -> Result<(String, String), &'static str> {
    match certificate {
        Certificate::Direct => Ok((String::from("Direct"), String::from("Direct"))),
        Certificate::Sign { denominator, numerator } => {
            let below = match denominator {
                None => String::from("Direct"),
                Some(Signed::Positive(proof) | Signed::Negative(proof)) => sign(proof, variables)?,
            };
            Ok((sign(numerator, variables)?, below))
        }
        _ => Err("another kind of certificate"),
    }
}

/// The certificate of a proof of a sign, or else one by cuts alone that the kernel accepts for the same statement.
pub(super) fn by_cuts(proof: &Proof, variables: &[(Var, Range)]) -> Result<(String, String), &'static str> {
    let found = of(proof.certificate(), variables);
    let (Err(_), Certificate::Sign { denominator, .. }) = (&found, proof.certificate()) else { return found };
    let statement = Rc::new(proof.statement().clone());
    for depth in 1..=MAX_CUTS {
        for (var, _) in variables {
            let numerator = SignProof::Cuts(halved(*var, depth));
            let certificate = Certificate::Sign { denominator: denominator.clone(), numerator };
            if let Ok(proof) = Proof::new(Rc::clone(&statement), certificate, &mut Work::usual(1)) {
                return of(proof.certificate(), variables);
            }
        }
    }
    found
}

/// How often a side is halved where the proof has no counterpart.
const MAX_CUTS: u32 = 3;

/// A side that is halved, and its halves in turn, `depth` times.
fn halved(var: Var, depth: u32) -> Cuts {
    match depth {
        0 => Cuts::None,
        _ => Cuts::At { var, low: Box::new(halved(var, depth - 1)), high: Box::new(halved(var, depth - 1)) },
    }
}

/// The proof of a sign.
pub(super) fn sign(proof: &SignProof, variables: &[(Var, Range)]) -> Result<String, &'static str> {
    match proof {
        SignProof::Cuts(tree) => cuts(tree, &mut variables.to_vec()),
        SignProof::Corners { .. } => Err("a proof by the corners of a range"),
        SignProof::Factors { .. } => Err("a proof by factors"),
        SignProof::Faces(_) => Err("a proof by faces"),
        SignProof::Cells(_) => Err("a proof by cells"),
        SignProof::Slices(_) => Err("a proof by slices"),
    }
}

fn cuts(tree: &Cuts, variables: &mut [(Var, Range)]) -> Result<String, &'static str> {
    let Cuts::At { var, low, high } = tree else { return Ok(String::from("Direct")) };
    let place = variables.iter().position(|(v, _)| v == var).ok_or("a cut along another variable")?;
    let range = variables[place].1.clone();
    let at = middle(&range);
    let mut part = |range: Range, tree: &Cuts| {
        variables[place].1 = range;
        cuts(tree, variables)
    };
    let below = part(Range { low: range.low.clone(), high: End::Included(at.clone()) }, low)?;
    let above = part(Range { low: End::Included(at.clone()), high: range.high.clone() }, high)?;
    variables[place].1 = range;
    Ok(format!("(Cut {place} {} {below} {above})", rational(&at)))
}

/// Where a side is cut: in the middle, 1 beyond the end of an infinite side, and at 0 on a side without ends.
fn middle(range: &Range) -> Rational {
    match (range.low.value(), range.high.value()) {
        (Some(a), Some(b)) => &(a + b) * &Rational::new(1, 2),
        (Some(a), None) => a + &Rational::ONE,
        (None, Some(b)) => b - &Rational::ONE,
        (None, None) => Rational::ZERO,
    }
}
