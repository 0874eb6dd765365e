//! Claims about theorems: identities between linear forms, signs of scalars, directions of vectors.

mod axes;
mod net;
mod parallel;
mod parts;
mod products;
mod witness;

use basis_prover::collections::list::Listed;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::{
    Coordinate, Counterexample, Failure, Shown, Symmetries, decide as decide_statement, typical, within_half,
};

use super::family::on_part;
use super::family::premises::{self, NOT_DERIVED};
use super::inequality::{self, Said, compared};
use super::proofs::{all, steps};
use super::verdict::{Evidence, Stated, Verdict};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{PolyExt, Var};
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind, Comparison, Difference};
use crate::theorem::{Theorem, Unit};
use axes::Axes;
use net::{Net, nets, on_net, parts as parts_of};
use parts::{Part, settled};
use witness::{explained, witness, witness_nets};

/// Nets that are tried where an inequality between coordinates stays undecided.
const ATTEMPTS: usize = 16;

/// Why an equation stays undecided: no point was found.
const NO_WITNESS: &str =
    "the two sides are different expressions, but no point was found at which they differ";

/// What a claim says; `None` where the relations of the scalars make it too long.
pub(super) fn statements(theorem: &Theorem, claim: &Claim, ways: &[usize]) -> Option<Vec<Stated>> {
    if theorem.parts.is_empty() {
        return Some(own_statements(theorem, claim));
    }
    let parts = parts::parts(theorem, claim)?;
    let count = parts.len();
    let mut ways = ways.iter();
    let mut away = |statement: &Statement| premises::by_next(statement, &mut ways);
    let of_part = |(k, part): (usize, Part)| {
        let stated = parts::enough(own_statements(&part.theorem, &part.claim), &mut away);
        stated.into_iter().map(move |s| Stated { of: on_part(&s.of, k, count), ..s }).listed()
    };
    Some(parts.into_iter().enumerate().flat_map(of_part).listed())
}

/// What a claim says of scalars that are not related.
fn own_statements(theorem: &Theorem, claim: &Claim) -> Vec<Stated> {
    match &settled(theorem, &claim.kind) {
        ClaimKind::Scalar { comparison, difference } => scalar(theorem, *comparison, difference),
        ClaimKind::Vector { text, value } => {
            let domain = theorem.scalar_domain();
            let zero = |f: &Fraction| compared(f, Comparison::Equal, &domain);
            let mut all = Vec::new();
            for (unit, coefficient) in &value.terms {
                all.push(Stated::new(coefficient_of(theorem, text, *unit), zero(coefficient)));
            }
            if all.is_empty() {
                // Without terms it is zero.
                all.push(Stated::new(text.clone(), zero(&Fraction::zero())));
            }
            all
        }
        ClaimKind::Parallel { left, right } => parallel::statements(theorem, left, right),
        _ => Vec::new(),
    }
}

/// What a coefficient of a vector is the coefficient of, as text.
fn coefficient_of(theorem: &Theorem, text: &str, unit: Unit) -> String {
    let name = |p: usize| theorem.points.get(p).map_or_else(|| p.to_string(), |point| point.name.clone());
    match unit {
        _ if theorem.dimension.is_some() => format!("coordinates of {text}"),
        Unit::Point(p) => format!("coefficient of {} in {text}", name(p)),
        Unit::Pair(p, q) => format!("coefficient of cross({}, {}) in {text}", name(p), name(q)),
    }
}

/// What a comparison of a scalar says: as a sum of dot products if it is one, and of its denominator then.
fn scalar(theorem: &Theorem, comparison: Comparison, difference: &Difference) -> Vec<Stated> {
    let Difference { text, value, .. } = difference;
    if let Some(Said { relation, negated }) = inequality::said(comparison) {
        let mut at = vec![Rational::ONE; theorem.names.len()];
        for scalar in &theorem.scalars {
            at[scalar.var.0] = typical(&scalar.range);
        }
        let below = value.denom().eval(&at).is_negative();
        let above = if below == negated { value.numer().clone() } else { -value.numer() };
        let plain = value.denom().variables().iter().all(|v| theorem.scalars.iter().any(|p| p.var == *v));
        if let (true, Some(statement)) = (plain, products::statement(theorem, &above, relation)) {
            let mut all = vec![Stated::new(text.clone(), statement)];
            if value.denom().as_constant().is_none() {
                let denominator = if below { -value.denom() } else { value.denom().clone() };
                let domain = theorem.scalar_domain();
                let of = denominator.display(&theorem.names).to_string();
                all.push(Stated::new(of, parallel::sign(&denominator, Relation::NonNegative, &domain)));
            }
            return all;
        }
    }
    if comparison != Comparison::Equal
        && let Some(axes) = Axes::of(theorem, value)
        && let Some(value) = axes.put(theorem, value)
    {
        return vec![Stated::new(text.clone(), compared(&value, comparison, &axes.domain(theorem)))];
    }
    let domain = theorem.domain();
    vec![Stated::new(text.clone(), compared(value, comparison, &domain))]
}

/// What a claim says of definite points.
///
/// # Errors
/// When there is not one place for each given point, or they have different dimensions.
pub(super) fn instances(
    theorem: &Theorem,
    claim: &Claim,
    given: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    if theorem.parts.is_empty() {
        return own_instances(theorem, claim, given);
    }
    let parts = parts::parts(theorem, claim).ok_or("the claim is too long")?;
    let count = parts.len();
    let mut all = Vec::new();
    for (k, part) in parts.iter().enumerate() {
        let own = own_instances(&part.theorem, &part.claim, given)?;
        all.extend(own.into_iter().map(|s| Stated { of: on_part(&s.of, k, count), ..s }));
    }
    Ok(all)
}

/// The same of scalars that are not related.
fn own_instances(
    theorem: &Theorem,
    claim: &Claim,
    given: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    let net = &Net::given(theorem, given)?;
    let kind = settled(theorem, &claim.kind);
    let domain = theorem.scalar_domain();
    let vague = theorem.products.iter().any(|(var, _)| kind.depends_on(*var));
    if net.places().is_empty() {
        // Without points, or with coordinates as variables; but dot products are not any numbers.
        return match &kind {
            ClaimKind::Scalar { .. } if vague => Err("the claim is about points, and none are given"),
            ClaimKind::Scalar { comparison, difference } => {
                let domain = theorem.domain();
                let statement = compared(&difference.value, *comparison, &domain);
                Ok(vec![Stated::new(difference.text.clone(), statement)])
            }
            _ if theorem.points.is_empty() => Ok(on_points(theorem, &kind, net, &domain)),
            _ => Err("the claim is about points, and none are given"),
        };
    }
    Ok(on_points(theorem, &kind, net, &domain))
}

/// What a claim says of the points of a net.
fn on_points(theorem: &Theorem, kind: &ClaimKind, net: &Net, domain: &Rc<Domain>) -> Vec<Stated> {
    match kind {
        ClaimKind::Scalar { comparison, difference } => {
            let value = on_net(theorem, &difference.value, net);
            vec![Stated::new(difference.text.clone(), compared(&value, *comparison, domain))]
        }
        ClaimKind::Vector { text, value } => {
            let zero = |(label, value): (String, Fraction)| {
                let of = if label.is_empty() { text.clone() } else { format!("({text}){label}") };
                Stated::new(of, compared(&value, Comparison::Equal, domain))
            };
            parts_of(theorem, value, net).into_iter().map(zero).listed()
        }
        ClaimKind::Parallel { left, right } => parallel::on_points(theorem, [left, right], net, domain),
        _ => Vec::new(),
    }
}

/// Decides a claim: on each part of the values of the scalars.
pub(super) fn decide(theorem: &Theorem, claim: &Claim) -> Verdict {
    if theorem.parts.is_empty() {
        return own_verdict(theorem, claim, None);
    }
    // In the scalars themselves, not in the variables of a box.
    let factor = match &claim.kind {
        ClaimKind::Parallel { left, right } => parallel::factor_text(theorem, left, right),
        _ => None,
    };
    let Some(parts) = parts::parts(theorem, claim) else {
        return Verdict::Undecided(String::from("the relations of the scalars make the claim too long"));
    };
    let count = parts.len();
    let (mut methods, mut all, mut ways, mut open) = (Vec::new(), Vec::new(), Vec::new(), None);
    for (k, part) in parts.iter().enumerate() {
        match own_verdict(&part.theorem, &part.claim, factor.as_deref()) {
            Verdict::Proved(evidence) => {
                ways.extend_from_slice(evidence.ways());
                let (method, steps) = evidence.into_parts();
                all.extend(steps.into_iter().map(|(of, proof)| (on_part(&of, k, count), proof)));
                methods.push(method);
            }
            Verdict::Refuted(witness) => {
                let of = on_part(witness.of_statement(), k, count);
                return Verdict::Refuted(Box::new(witness.about(&of)));
            }
            Verdict::Undecided(left) => open = open.or(Some(left)),
        }
    }
    match open {
        Some(left) => Verdict::Undecided(left),
        None => Verdict::Proved(Evidence::new(methods.pop().unwrap_or_default(), all).by(ways)),
    }
}

/// The verdict on a claim about scalars that are not related.
fn own_verdict(theorem: &Theorem, claim: &Claim, factor: Option<&str>) -> Verdict {
    if let ClaimKind::Parallel { left, right } = &settled(theorem, &claim.kind) {
        return parallel::decide(theorem, claim, [left, right], factor);
    }
    let stated = own_statements(theorem, claim);
    let assumed = stated.iter().any(parts::has_premises);
    let proved = |shown: Vec<(String, Shown)>| Evidence::new(method(&claim.kind, &shown), steps(shown));
    let mut ways = Vec::new();
    let enough = parts::enough(stated.clone(), &mut |s| premises::by_first(s, &mut ways));
    let first = if assumed {
        within_half(&mut || all(enough.clone(), theorem.budget))
    } else {
        all(enough, theorem.budget)
    };
    match first {
        Ok(shown) => Verdict::Proved(proved(shown).by(ways)),
        Err((of, decision)) => match &claim.kind {
            ClaimKind::Scalar { comparison, .. } if assumed && *comparison != Comparison::Equal => {
                match under_premises(theorem, claim, &stated) {
                    Verdict::Undecided(left) => {
                        let mut ways = Vec::new();
                        let later = parts::enough(stated, &mut |s| premises::tried(s, &mut ways));
                        // By the first ways these are the same statements.
                        let shown =
                            if premises::are_first(&ways) { None } else { all(later, theorem.budget).ok() };
                        shown
                            .map_or(Verdict::Undecided(left), |shown| Verdict::Proved(proved(shown).by(ways)))
                    }
                    refuted => refuted,
                }
            }
            ClaimKind::Scalar { comparison, difference } if *comparison != Comparison::Equal => {
                inequality(theorem, claim, difference, of, decision)
            }
            _ => equation(theorem, claim),
        },
    }
}

/// How a claim was proved, in a few words.
fn method(kind: &ClaimKind, shown: &[(String, Shown)]) -> String {
    if matches!(kind, ClaimKind::Vector { .. } | ClaimKind::Scalar { comparison: Comparison::Equal, .. }) {
        return String::from("expansion of both sides");
    }
    let Some((_, hardest)) = shown.iter().max_by_key(|(_, shown)| shown.method) else { return String::new() };
    match hardest.proof.statement() {
        Statement::Products { .. } if hardest.method != basis_prover::Method::Squares => {
            format!("a positive semidefinite matrix ({})", hardest.method)
        }
        _ => hardest.method.to_string(),
    }
}

/// A counterexample to an equation, also among points at which premises hold.
fn refuted(statement: Statement, budget: u32) -> Option<Counterexample> {
    let found = basis_prover::working(budget, &mut |work| premises::counterexample(&statement, work));
    if found.is_some() {
        return found;
    }
    match decide_statement(statement, &Symmetries::new(), budget) {
        Err(Failure::Refuted(found)) => Some(*found),
        _ => None,
    }
}

/// An equation that does not hold: a net on which a part of it fails.
fn equation(theorem: &Theorem, claim: &Claim) -> Verdict {
    let domain = theorem.scalar_domain();
    let kind = settled(theorem, &claim.kind);
    for net in witness_nets(theorem, claim) {
        for Stated { of, statement, .. } in on_points(theorem, &kind, &net, &domain) {
            if let Some(found) = refuted(statement, theorem.budget) {
                let witness = witness(theorem, of, Some(&net), &found, false);
                return explained(theorem, claim, witness, "the two sides differ by");
            }
        }
    }
    Verdict::Undecided(String::from(NO_WITNESS))
}

/// An inequality that is not derived from premises that are no part of a box: a point at which they hold and it fails, of
/// the coordinates of points, too.
fn under_premises(theorem: &Theorem, claim: &Claim, stated: &[Stated]) -> Verdict {
    let ClaimKind::Scalar { comparison, .. } = &claim.kind else {
        return Verdict::Undecided(String::from(NOT_DERIVED));
    };
    let kind = settled(theorem, &claim.kind);
    let vague = theorem.products.iter().any(|(var, _)| kind.depends_on(*var));
    let refuted = |stated: &[Stated], net: Option<&Net>| {
        stated.iter().find_map(|s| {
            let found = basis_prover::working(theorem.budget, &mut |work| {
                premises::counterexample(&s.statement, work)
            })?;
            let witness = witness(theorem, s.of.clone(), net, &found, inequality::is_negated(*comparison));
            Some(explained(theorem, claim, witness, "the value is"))
        })
    };
    // Dot products are not any numbers: the claim must fail for a net.
    let found = if vague || stated.iter().any(|s| matches!(s.statement, Statement::Products { .. })) {
        nets(theorem)
            .take(ATTEMPTS)
            .find_map(|net| refuted(&on_points(theorem, &kind, &net, &theorem.scalar_domain()), Some(&net)))
    } else {
        refuted(stated, None)
    };
    found.unwrap_or_else(|| {
        let of = stated.first().map_or("", |s| s.of.as_str());
        Verdict::Undecided(format!("`{of}`: {NOT_DERIVED}"))
    })
}

/// An inequality that is not proved.
fn inequality(
    theorem: &Theorem,
    claim: &Claim,
    difference: &Difference,
    of: String,
    failure: Failure,
) -> Verdict {
    let ClaimKind::Scalar { comparison, .. } = &claim.kind else { return Verdict::Undecided(of) };
    let negate = inequality::is_negated(*comparison);
    let domain = theorem.scalar_domain();
    let kind = settled(theorem, &claim.kind);
    let on_net = |net: &Net, at: Option<&[(Var, Coordinate)]>| -> Option<Verdict> {
        for Stated { of, statement, .. } in on_points(theorem, &kind, net, &domain) {
            let found = match at {
                Some(at) => {
                    let scalars = theorem.scalars.iter().map(|p| {
                        let given = at.iter().find(|(v, _)| *v == p.var).map(|(_, c)| c.clone());
                        (p.var, given.unwrap_or_else(|| Coordinate::Rational(typical(&p.range))))
                    });
                    let scalars: Vec<(Var, Coordinate)> = scalars.listed();
                    let work = &mut crate::algebra::work::Work::new(EXPLICIT);
                    Box::new(basis_prover::refute(&Rc::new(statement), &scalars, work)?)
                }
                None => match decide_statement(statement, &Symmetries::new(), theorem.budget) {
                    Err(Failure::Refuted(found)) => found,
                    _ => continue,
                },
            };
            let witness = witness(theorem, of, Some(net), &found, negate);
            return Some(explained(theorem, claim, witness, "the value is"));
        }
        None
    };
    let stated = scalar(theorem, *comparison, difference);
    if let Some(Stated { statement: statement @ Statement::Products { .. }, .. }) = stated.first() {
        if let Some((at, net)) = products::counterexample(theorem, statement, theorem.budget)
            && let Some(verdict) = on_net(&net, Some(&at))
        {
            return verdict;
        }
        return Verdict::Undecided(match failure {
            Failure::Undecided(left) => format!("`{of}`: {left}"),
            Failure::Refuted(_) => format!("`{of}` fails for some points, but at irrational values only"),
        });
    }
    let vague = theorem.products.iter().any(|(var, _)| difference.value.depends_on(*var));
    match failure {
        Failure::Undecided(left) => {
            // With definite points in place of coordinates the question is a smaller one.
            let attempts = if theorem.dimension.is_some() || vague { ATTEMPTS } else { 0 };
            let found = nets(theorem).take(attempts).find_map(|net| on_net(&net, None));
            found.unwrap_or_else(|| Verdict::Undecided(format!("`{of}`: {left}")))
        }
        Failure::Refuted(found) if vague => {
            // Dot products are not any numbers: the claim must fail for a net.
            let axes = Axes::of(theorem, &difference.value);
            let own = axes.and_then(|axes| on_net(&axes.net(theorem, &found.point)?, Some(&found.point)));
            let found = own.or_else(|| nets(theorem).find_map(|net| on_net(&net, None)));
            found.unwrap_or_else(|| {
                Verdict::Undecided(format!(
                    "`{of}`: it fails for some numbers in place of the dot products, but for no points that were tried"
                ))
            })
        }
        Failure::Refuted(found) => {
            explained(theorem, claim, witness(theorem, of, None, &found, negate), "the value is")
        }
    }
}

/// The work for making a counterexample explicit.
const EXPLICIT: u64 = 20_000_000;
