//! Claims about families.

mod identity;
mod independent;
mod ladder;
mod point;
#[cfg(any(test, feature = "rounding"))]
mod rounding;
mod spans;

use std::rc::Rc;

use basis_prover::{Coordinate, Counterexample, Failure, Method, Shown};

use super::inequality::{self, compared};
use super::proofs::{all, steps};
use super::verdict::{Evidence, Stated, Verdict, Witness};
use basis_kernel::Statement;

use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{Claim, ClaimKind, Comparison, Difference};
use crate::model::Family;
use basis_prover::collections::list::{Listed, Mapped};
use point::{domain_names, named_point};

#[cfg(any(test, feature = "tools"))]
pub(crate) use identity::moves;
#[cfg(any(test, feature = "tools"))]
pub(crate) use independent::combination_text;
pub use independent::{Table, coefficient_table};
#[cfg(any(test, feature = "tools"))]
pub use rounding::point_error;
#[cfg(any(test, feature = "rounding"))]
pub use rounding::value_errors;

/// The expressions that a claim compares with zero, as text and as quotients of polynomials; `None` when the work is spent.
fn expressions(family: &Family, kind: &ClaimKind, work: &mut Work) -> Option<Vec<(String, Fraction)>> {
    Some(match kind {
        ClaimKind::PartitionOfUnity => identity::partition_of_unity(family, work)?,
        ClaimKind::Symmetric if !family.pieces.is_empty() => spans::symmetric(family, work)?,
        ClaimKind::Symmetric => identity::symmetric(family, work)?,
        ClaimKind::Smooth(order) => spans::smooth(family, *order, work)?,
        ClaimKind::Continuity(order) => identity::continuity(family, *order),
        ClaimKind::Nonnegative => {
            let functions = family.functions.iter().enumerate();
            functions.map(|(k, f)| (family.function_label(k), f.value.clone())).listed()
        }
        ClaimKind::Relation { differences, .. } => {
            differences.mapped(|(_, d)| (d.text.clone(), d.value.clone()))
        }
        _ => Vec::new(),
    })
}

/// What a claim says; `None` when the budget of the family does not suffice to expand it.
pub fn statements(family: &Family, claim: &Claim) -> Option<Vec<Stated>> {
    let kind = &claim.kind;
    if let ClaimKind::Spans(parts) = kind {
        return spans::statements(family, claim, parts);
    }
    set_known_factors(family.analytic.denominators());
    if let ClaimKind::Independent(except) = kind {
        return Some(vec![independent::stated(family, except)]);
    }
    #[cfg(any(test, feature = "rounding"))]
    if let ClaimKind::Rounding(epsilons) = kind {
        return rounding::statements(family, epsilons);
    }
    let domain = Rc::new(inequality::domain(family, kind.fixed()));
    let comparison = |k: usize| match kind {
        ClaimKind::Nonnegative => Comparison::GreaterEqual,
        ClaimKind::Relation { differences, .. } => differences[k].0,
        _ => Comparison::Equal,
    };
    let expressions =
        basis_prover::working(family.budget, &mut |work| expressions(family, kind, work))?.into_iter();
    let mut all = Vec::new();
    for (k, (of, value)) in expressions.enumerate() {
        let comparison = comparison(k);
        let beside = basis_prover::working(family.budget, &mut |work| {
            Some(ladder::steps(family, &of, &value, comparison, work))
        });
        if let Some(steps) = beside.flatten() {
            for ladder::Step { of, value, comparison } in steps {
                let (of, value) = without_numbers(family, of, value);
                let stated = Stated::new(of, compared(&value, comparison, &domain));
                all.push(Stated { is_stronger: true, ..stated });
            }
            continue;
        }
        let (of, value) = match comparison {
            Comparison::Equal => (of, value),
            _ => without_numbers(family, of, value),
        };
        all.push(Stated::new(of, compared(&value, comparison, &domain)));
    }
    Some(all)
}

/// A value without the powers of π and exp(r) that are its factors: they are positive and play no part in its sign.
fn without_numbers(family: &Family, mut of: String, value: Fraction) -> (String, Fraction) {
    let mut result = value;
    for var in family.analytic.numbers() {
        let least = |p: &Poly| p.terms().map(|(m, _)| m.exponent(var)).min().unwrap_or(0);
        let (above, below) = (least(result.numer()), least(result.denom()));
        if result.is_zero() || above == below {
            continue;
        }
        let power = |n: u16| Fraction::from(Poly::var(var).pow(u32::from(n)));
        let factor = power(above).checked_div(&power(below)).unwrap_or_else(Fraction::zero);
        let Some(rest) = result.checked_div(&factor) else { continue };
        of = format!("({of})/({})", factor.display(&family.names));
        result = rest;
    }
    (of, result)
}

/// Whether a statement says something of π, of exp(r), or of a variable beside its sine: these are variables in it, and
/// points at which it fails need not be points at which the claim does. An equation holds for all values of these
/// variables if it holds, because they are transcendental, and algebraically independent of one another as far as they
/// occur together.
pub(super) fn is_wider(family: &Family, statement: &Statement) -> bool {
    let variables = || {
        let angles = family.analytic.angles.iter().map(|a| a.itself);
        family.analytic.numbers().into_iter().chain(angles)
    };
    let of = |p: &Poly| variables().any(|v| p.depends_on(v));
    match statement {
        // Nobody knows whether π and exp(1) are independent of one another.
        Statement::Zero { value, .. } => {
            family
                .analytic
                .numbers()
                .iter()
                .all(|v| value.numerator.depends_on(*v) || value.denominator.depends_on(*v))
                && family.analytic.numbers().len() > 1
        }
        Statement::Sign { value, .. } => of(&value.numerator) || of(&value.denominator),
        Statement::Products { value, .. } => of(value),
        Statement::Independent { rows, .. } => rows.iter().flatten().any(of),
    }
}

const TOO_LONG: &str = "the budget is spent on a common denominator of the functions";

/// What is left where a proof for all values is not found.
const WIDER: &str =
    "it is not seen from bounds for pi, exp, or for a variable beside its sine or exponential";

/// Decides a claim.
pub(super) fn decide(family: &Family, claim: &Claim) -> Verdict {
    if let ClaimKind::Spans(parts) = &claim.kind {
        return spans::decide(family, claim, parts);
    }
    #[cfg(any(test, feature = "rounding"))]
    if let ClaimKind::Rounding(epsilons) = &claim.kind {
        return rounding::decide(family, epsilons);
    }
    let Some(statements) = statements(family, claim) else {
        return Verdict::Undecided(String::from(TOO_LONG));
    };
    let stronger: Vec<String> = statements.iter().filter(|s| s.is_stronger).map(|s| s.of.clone()).listed();
    match all(statements, family.budget) {
        Ok(shown) => Verdict::Proved(Evidence::new(method(&claim.kind, &shown), steps(shown))),
        Err((of, Failure::Refuted(found)))
            if stronger.contains(&of) || is_wider(family, found.refutation.statement()) =>
        {
            Verdict::Undecided(format!("`{of}`: {WIDER}"))
        }
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
    let equation = matches!(kind, ClaimKind::Relation { differences, .. }
        if differences.iter().all(|(comparison, _)| *comparison == Comparison::Equal));
    String::from(match kind {
        ClaimKind::PartitionOfUnity => "expansion of the sum",
        ClaimKind::Symmetric => "expansion of the moved functions",
        ClaimKind::Continuity(_) => "expansion of the derivatives at the ends",
        ClaimKind::Smooth(_) => "expansion of the derivatives at the knots",
        ClaimKind::Independent(_) => "minors",
        _ if equation => "expansion of both sides",
        _ => {
            let hardest = shown.iter().map(|(_, shown)| shown.method).max();
            return hardest.unwrap_or(Method::Constant).to_string();
        }
    })
}

/// How the expression of a statement compares with zero, as the claim has it.
fn stated_comparison(
    family: &Family,
    kind: &ClaimKind,
    of: &str,
    statement: &Statement,
) -> Option<Comparison> {
    let ClaimKind::Relation { differences, .. } = kind else { return Some(Comparison::Equal) };
    let (Statement::Zero { domain, .. } | Statement::Sign { domain, .. }) = statement else { return None };
    let own = |(comparison, d): &&(Comparison, Difference)| {
        let (text, value) = match comparison {
            Comparison::Equal => (d.text.clone(), d.value.clone()),
            _ => without_numbers(family, d.text.clone(), d.value.clone()),
        };
        text == of && compared(&value, *comparison, domain) == *statement
    };
    differences.iter().find(own).map(|(comparison, _)| *comparison)
}

/// The witness that a counterexample is.
fn witness(family: &Family, kind: &ClaimKind, of: String, found: &Counterexample) -> Witness {
    if let ClaimKind::Independent(except) = kind {
        return independent::witness(family, except, found);
    }
    let at = named_point(family, found, kind.fixed());
    // Of the statements of a chain several may be about one expression.
    let comparison =
        stated_comparison(family, kind, &of, found.refutation.statement()).unwrap_or(Comparison::Equal);
    let negated = inequality::is_negated(comparison);
    let value = found.refutation.value().cloned().unwrap_or(Rational::ZERO);
    let value = if negated { -value } else { value };
    let mut witness = Witness::new(of, at, value, found.refutation.clone());
    witness.shown = shown(family, found);
    if matches!(kind, ClaimKind::Continuity(_) | ClaimKind::Smooth(_)) {
        witness.idle = domain_names(family);
    }
    witness.notes = identity::notes(family, kind, &witness);
    witness
}

/// The value at a counterexample to an equation as text, if it contains π, exp(r), or a variable beside its sine.
fn shown(family: &Family, found: &Counterexample) -> Option<String> {
    let Statement::Zero { value, .. } = found.refutation.statement() else { return None };
    let wide = |v: Var| {
        family.analytic.numbers().contains(&v) || family.analytic.angles.iter().any(|a| a.itself == v)
    };
    let of = |p: &Poly| p.variables().into_iter().any(wide);
    if !of(&value.numerator) && !of(&value.denominator) {
        return None;
    }
    let put = |p: &Poly| {
        found.point.iter().filter(|(v, _)| !wide(*v)).fold(p.clone(), |p, (v, c)| match c {
            Coordinate::Rational(x) => p.at(*v, x),
            Coordinate::Algebraic(_) => p,
        })
    };
    let value = Fraction::new(put(&value.numerator), put(&value.denominator))?;
    Some(value.display(&family.names))
}
