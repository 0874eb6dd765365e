//! Claims about families.

use std::rc::Rc;

use basis_kernel::{Domain, Statement};
use basis_prover::{Coordinate, Counterexample, Failure, Method, Shown, typical};

use super::verdict::{Evidence, Stated, Verdict, Witness};
use super::{all, identity, independent, inequality, steps};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind, Comparison};
use crate::model::Family;
use basis_kernel::collections::list::Mapped;

/// The expressions that a claim compares with zero, as text and as quotients of polynomials.
fn expressions(family: &Family, kind: &ClaimKind) -> Vec<(String, Fraction)> {
    match kind {
        ClaimKind::PartitionOfUnity => identity::partition_of_unity(family),
        ClaimKind::Symmetric => identity::symmetric(family),
        ClaimKind::Continuity(order) => identity::continuity(family, *order),
        ClaimKind::Nonnegative => {
            let functions = family.functions.iter().enumerate();
            functions.map(|(k, f)| (family.function_label(k), f.value.clone())).collect()
        }
        ClaimKind::Relation { differences, .. } => differences.mapped(|d| (d.text.clone(), d.value.clone())),
        _ => Vec::new(),
    }
}

/// What a claim says.
pub fn statements(family: &Family, claim: &Claim) -> Vec<Stated> {
    let kind = &claim.kind;
    if let ClaimKind::Independent(except) = kind {
        return vec![independent::stated(family, except)];
    }
    let domain = Rc::new(inequality::domain(family, kind.fixed()));
    let comparison = match kind {
        ClaimKind::Nonnegative => Comparison::GreaterEqual,
        ClaimKind::Relation { comparison, .. } => *comparison,
        _ => Comparison::Equal,
    };
    let expressions = expressions(family, kind).into_iter();
    expressions.map(|(of, value)| Stated::new(of, compared(&value, comparison, &domain))).collect()
}

/// The statement that a value compares with zero as stated, at all points of a domain.
pub(super) fn compared(value: &Fraction, comparison: Comparison, domain: &Rc<Domain>) -> Statement {
    let domain = Rc::clone(domain);
    match inequality::relation(comparison) {
        None => Statement::Zero { value: value.quotient(), domain },
        Some((relation, negate)) => {
            let value = if negate { (-value).quotient() } else { value.quotient() };
            Statement::Sign { value, relation, domain }
        }
    }
}

/// Decides a claim.
pub(super) fn decide(family: &Family, claim: &Claim) -> Verdict {
    match all(statements(family, claim), family.budget) {
        Ok(shown) => Verdict::Proved(Evidence::new(method(&claim.kind, &shown), steps(shown))),
        Err((of, Failure::Refuted(found))) => {
            Verdict::Refuted(Box::new(witness(family, &claim.kind, of, &found)))
        }
        Err((of, Failure::Undecided(left))) => Verdict::Undecided(match &claim.kind {
            ClaimKind::Independent(_) => left,
            _ => format!("`{of}`: {left}"),
        }),
    }
}

/// How a claim was proved, in a few words.
fn method(kind: &ClaimKind, shown: &[(String, Shown)]) -> String {
    let equation = matches!(kind, ClaimKind::Relation { comparison: Comparison::Equal, .. });
    String::from(match kind {
        ClaimKind::PartitionOfUnity => "expansion of the sum",
        ClaimKind::Symmetric => "expansion of the moved functions",
        ClaimKind::Continuity(_) => "expansion of the derivatives at the ends",
        ClaimKind::Independent(_) => "minors",
        _ if equation => "expansion of both sides",
        _ => {
            let hardest = shown.iter().map(|(_, shown)| shown.method).max();
            return hardest.unwrap_or(Method::Constant).to_string();
        }
    })
}

/// The witness that a counterexample is.
fn witness(family: &Family, kind: &ClaimKind, of: String, found: &Counterexample) -> Witness {
    if let ClaimKind::Independent(except) = kind {
        return independent::witness(family, except, found);
    }
    let at = named_point(family, found, kind.fixed());
    let negated = match kind {
        ClaimKind::Relation { comparison, .. } => {
            inequality::relation(*comparison).is_some_and(|(_, negate)| negate)
        }
        _ => false,
    };
    let value = found.refutation.value().cloned().unwrap_or(Rational::ZERO);
    let value = if negated { -value } else { value };
    let mut witness = Witness::new(of, at, value, found.refutation.clone());
    if matches!(kind, ClaimKind::Continuity(_)) {
        witness.idle = domain_names(family);
    }
    witness.notes = identity::notes(family, kind, &witness);
    witness
}

/// The names of the domain variables.
pub(super) fn domain_names(family: &Family) -> Vec<String> {
    family.domain_variables().map(|p| p.name.clone()).collect()
}

/// A counterexample as a point of the names, complete with what `at` fixes and with values for what plays no part.
pub(super) fn named_point(
    family: &Family,
    found: &Counterexample,
    fixed: &[(Var, Fraction)],
) -> Vec<(String, Coordinate)> {
    // On a simplex no more than what is left.
    let mut left = Rational::ONE;
    let mut all: Vec<(String, Coordinate)> = Vec::new();
    let mut last = Fraction::constant(Rational::ONE);
    for (k, parameter) in family.shapes.iter().chain(&family.domain).enumerate() {
        let var = parameter.var;
        let on_simplex = family.is_simplex() && k >= family.shapes.len();
        let given = found.point.iter().find(|(v, _)| *v == var).map(|(_, c)| c.clone());
        let fixed_value = fixed.iter().find(|(v, _)| *v == var).map(|(_, f)| f);
        if on_simplex {
            last = &last - &fixed_value.cloned().unwrap_or_else(|| Fraction::var(var));
        }
        let known = given.or_else(|| found.evaluate(&fixed_value?.quotient()));
        let value = known.unwrap_or_else(|| {
            let simple = typical(&parameter.range);
            let simple = if on_simplex { simple.min(left.clone()) } else { simple };
            if on_simplex {
                last =
                    last.substitute(var, &Fraction::constant(simple.clone())).unwrap_or_else(Fraction::zero);
            }
            Coordinate::Rational(simple)
        });
        if let (true, Coordinate::Rational(x)) = (on_simplex, &value) {
            left -= x;
        }
        all.push((parameter.name.clone(), value));
    }
    if let Some(dependent) = &family.dependent {
        all.extend(found.evaluate(&last.quotient()).map(|c| (dependent.name.clone(), c)));
    }
    all
}
