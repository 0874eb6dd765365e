//! Claims of theorems: identities between linear forms, signs of scalars, directions of vectors.

use core::convert::Infallible;

use super::gram::{self, Gram};
use super::net::{Net, evaluated, nets, on_net, parts, sparse};
use super::quadratic::Quadratic;
#[cfg(any(test, feature = "tools"))]
use super::{Assertion, Statement, quadratic};
use super::{Evidence, Step, StepProof, Verdict, Witness, parallel, point};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::decide::{self, Budget, Coordinate, Decision, Relation};
use crate::model::theorem::{Form, Theorem, TheoremClaim, TheoremClaimKind, Unit};
use crate::model::{Comparison, Parameter};

/// Regular nets have at most so many points that matter.
const MAX_REGULAR: usize = 8;

/// So many nets are tried where an inequality between coordinates stays undecided.
const ATTEMPTS: usize = 16;

/// Decides a claim of a theorem.
pub fn theorem_claim(theorem: &Theorem, claim: &TheoremClaim) -> Verdict {
    let of = &claim.difference;
    match &settled(theorem, &claim.kind) {
        TheoremClaimKind::Scalar(Comparison::Equal, f) if f.is_zero() => identity(of),
        TheoremClaimKind::Zero(form) if form.is_zero() => identity(of),
        TheoremClaimKind::Scalar(Comparison::Equal, f) => {
            let found = witness_nets(theorem, claim).find_map(|net| {
                let value = on_net(theorem, f, &net);
                let at = nonzero(theorem, &value)?;
                Some(refutation(theorem, &net, of.clone(), &value, &at))
            });
            found.map_or_else(no_witness, |w| explained(theorem, claim, w, "the two sides differ by"))
        }
        TheoremClaimKind::Zero(form) => {
            let found = witness_nets(theorem, claim).find_map(|net| {
                parts(theorem, form, &net).into_iter().find_map(|(label, value)| {
                    let at = nonzero(theorem, &value)?;
                    let of = if label.is_empty() { of.clone() } else { format!("({of}){label}") };
                    Some(refutation(theorem, &net, of, &value, &at))
                })
            });
            found.map_or_else(no_witness, |w| explained(theorem, claim, w, "the two sides differ by"))
        }
        TheoremClaimKind::Scalar(comparison, f) => sign(theorem, claim, *comparison, f),
        TheoremClaimKind::Parallel(a, b) => parallel::parallel(theorem, claim, a, b),
    }
}

/// What has to be shown for a claim of a theorem to be true; one statement for each step of a proof.
#[cfg(any(test, feature = "tools"))]
pub fn theorem_statements(theorem: &Theorem, claim: &TheoremClaim) -> Vec<Statement> {
    let first = |form: &Form| form.terms.values().next().cloned().unwrap_or_else(Fraction::zero);
    let (of, assertion) = match &settled(theorem, &claim.kind) {
        TheoremClaimKind::Parallel(a, b) => return parallel::statements(theorem, claim, a, b),
        TheoremClaimKind::Scalar(Comparison::Equal, f) => {
            (claim.difference.clone(), Assertion::Zero(f.clone()))
        }
        // A form is zero if it has no terms.
        TheoremClaimKind::Zero(form) => (claim.difference.clone(), Assertion::Zero(first(form))),
        TheoremClaimKind::Scalar(comparison, f) => {
            let (relation, negate) = relation(*comparison);
            let polynomial = with_sign(theorem, f, negate);
            let numbers = Gram::of(&polynomial, &theorem.products).is_some();
            let form = if numbers { None } else { Quadratic::new(theorem, &polynomial) };
            if let Some(form) = form {
                let statement = |(of, polynomial, relation)| {
                    let region = quadratic::scalars(theorem);
                    Statement {
                        of,
                        assertion: Assertion::Sign { polynomial, relation, region },
                        budget: theorem.budget,
                    }
                };
                return form.statements(&claim.difference, relation).into_iter().map(statement).collect();
            }
            (claim.difference.clone(), sign_assertion(theorem, polynomial, relation))
        }
    };
    vec![Statement { of, assertion, budget: theorem.budget }]
}

/// The sign of a polynomial, of dot products or in the ranges of the scalars.
#[cfg(any(test, feature = "tools"))]
pub(super) fn sign_assertion(theorem: &Theorem, polynomial: Poly, relation: Relation) -> Assertion {
    if Gram::of(&polynomial, &theorem.products).is_none() {
        return Assertion::Sign { polynomial, relation, region: theorem.region() };
    }
    let own = theorem.products.iter().filter(|(var, _)| polynomial.depends_on(*var));
    let products = own.copied().collect();
    Assertion::Squares { polynomial, relation, products }
}

/// The claim with a number in place of every scalar whose range is a single number.
fn settled(theorem: &Theorem, kind: &TheoremClaimKind) -> TheoremClaimKind {
    let put = |f: &Fraction| {
        theorem.scalars.iter().fold(f.clone(), |f, scalar| match scalar.range.finite() {
            // No denominator vanishes on the ranges.
            Some((low, high)) if low == high => {
                f.substitute(scalar.var, &Fraction::constant(low.clone())).unwrap_or(f)
            }
            _ => f,
        })
    };
    let form = |form: &Form| {
        let Ok(form) = form.map::<Infallible>(&mut |f| Ok(put(f)));
        form
    };
    match kind {
        TheoremClaimKind::Scalar(comparison, f) => TheoremClaimKind::Scalar(*comparison, put(f)),
        TheoremClaimKind::Zero(a) => TheoremClaimKind::Zero(form(a)),
        TheoremClaimKind::Parallel(a, b) => TheoremClaimKind::Parallel(form(a), form(b)),
    }
}

pub(super) fn identity(of: &str) -> Verdict {
    let steps = vec![Step { of: of.to_string(), proof: StepProof::Identity }];
    Verdict::Proved(Evidence { method: String::from("expansion of both sides"), steps })
}

pub(super) fn no_witness() -> Verdict {
    Verdict::Undecided(String::from(
        "the two sides are different expressions, but no point was found at which they differ",
    ))
}

/// The verdict with a witness; texts leave out the scalars and points that do not matter to the claim.
pub(super) fn explained(
    theorem: &Theorem,
    claim: &TheoremClaim,
    mut witness: Witness,
    what: &str,
) -> Verdict {
    witness.idle = idle(theorem, &claim.kind);
    let at = witness.point();
    let place = if at.is_empty() { String::new() } else { format!(" at {at}") };
    witness.notes.push(format!("{what} `{}` = {}{place}", witness.of, witness.value));
    if !matches!(claim.kind, TheoremClaimKind::Zero(_) | TheoremClaimKind::Scalar(Comparison::Equal, _)) {
        // The sign of a scalar without a range is easily forgotten.
        let any = theorem.scalars.iter().zip(&witness.at).filter(|(scalar, (_, value))| {
            scalar.range == Range::all()
                && claim.kind.depends_on(scalar.var)
                && matches!(value, Coordinate::Rational(x) if !x.is_positive())
        });
        witness.notes.extend(any.map(|(scalar, _)| {
            let name = &scalar.name;
            format!("`{name}` can be any number; `scalar 0 < {name};` declares it positive")
        }));
    }
    Verdict::Refuted(witness)
}

/// Nets that show two things to be different, such as a person can read: with most points in one place if there are many.
pub(super) fn witness_nets(theorem: &Theorem, claim: &TheoremClaim) -> impl Iterator<Item = Net> {
    let idle = idle(theorem, &claim.kind);
    let used = theorem.points.iter().filter(|point| !idle.contains(&point.name)).count();
    let first = if used > MAX_REGULAR { Some(sparse(theorem)) } else { None };
    first.into_iter().flatten().chain(nets(theorem))
}

/// The scalars on which a claim does not depend, and the points: those that it does not contain once determined points are
/// expressed by given ones.
fn idle(theorem: &Theorem, kind: &TheoremClaimKind) -> Vec<String> {
    let forms: &[&Form] = match kind {
        TheoremClaimKind::Scalar(..) => &[],
        TheoremClaimKind::Zero(form) => &[form],
        TheoremClaimKind::Parallel(a, b) => &[a, b],
    };
    let mut used = Vec::new();
    if theorem.dimension.is_none() {
        for unit in forms.iter().flat_map(|form| form.terms.keys()) {
            match unit {
                Unit::Point(p) => used.push(*p),
                Unit::Pair(p, q) => used.extend([*p, *q]),
            }
        }
    }
    let products = theorem.products.iter().filter(|(var, _)| kind.depends_on(*var));
    used.extend(products.flat_map(|(_, (p, q))| [*p, *q]));
    let matters = |label: &String| {
        let mut given = theorem.points.iter().enumerate().filter(|(_, point)| point.name == *label);
        given.any(|(k, point)| used.contains(&k) || point.coordinates.iter().any(|var| kind.depends_on(*var)))
    };
    let scalars = theorem.scalars.iter().filter(|p| !kind.depends_on(p.var)).map(|p| p.name.clone());
    let labels = theorem
        .patches
        .iter()
        .flat_map(|patch| patch.points.iter().map(|point| crate::model::label(&patch.name, &point.index)));
    scalars.chain(labels.filter(|label| !matters(label))).collect()
}

/// The values of the scalars at which a function has a value, and one that is not zero.
pub(super) fn nonzero(theorem: &Theorem, value: &Fraction) -> Option<Vec<Rational>> {
    if value.is_zero() {
        return None;
    }
    // Where the denominator were zero, there would be no value.
    let mut rest = [value.numer().clone(), value.denom().clone()];
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    let settled = |scalar: &Parameter| scalar.range.finite().is_some_and(|(low, high)| low == high);
    // A scalar with a single value leaves no choice, so that its value is put in before others are chosen.
    let (single, others): (Vec<_>, Vec<_>) = theorem.scalars.iter().partition(|scalar| settled(scalar));
    for scalar in single.into_iter().chain(others) {
        // Of more numbers than the two have zeros in this variable together, one is none of them.
        let count = rest.iter().map(|p| p.degree(scalar.var)).sum::<u32>() + 1;
        let found = point::candidates(&scalar.range, count)
            .into_iter()
            .find(|x| rest.iter().all(|p| !p.at(scalar.var, x).is_zero()))?;
        rest = rest.map(|p| p.at(scalar.var, &found));
        at[scalar.var.0] = found;
    }
    Some(at)
}

/// A witness from values of the scalars and a net.
pub(super) fn refutation(
    theorem: &Theorem,
    net: &Net,
    of: String,
    value: &Fraction,
    at: &[Rational],
) -> Witness {
    let value = value.eval(at).unwrap_or(Rational::ZERO);
    let net = evaluated(theorem, net, at, &[]);
    let named = theorem.scalars.iter().map(|p| (p.name.clone(), Coordinate::Rational(at[p.var.0].clone())));
    Witness { of, at: named.collect(), idle: Vec::new(), net, value, notes: Vec::new() }
}

/// A polynomial with the sign of a quotient, or of its opposite: the denominator vanishes nowhere on the ranges, so that its
/// sign at one point is its sign everywhere.
fn with_sign(theorem: &Theorem, value: &Fraction, negate: bool) -> Poly {
    let mut at = vec![Rational::ONE; theorem.names.len()];
    for scalar in &theorem.scalars {
        at[scalar.var.0] = point::simple(&scalar.range);
    }
    if value.denom().eval(&at).is_negative() == negate { value.numer().clone() } else { -value.numer() }
}

/// What a comparison of x with zero says of x, or if the second is true of −x.
const fn relation(comparison: Comparison) -> (Relation, bool) {
    match comparison {
        Comparison::Greater => (Relation::Positive, false),
        Comparison::Less => (Relation::Positive, true),
        Comparison::LessEqual => (Relation::NonNegative, true),
        _ => (Relation::NonNegative, false),
    }
}

/// An inequality between a scalar and zero.
fn sign(theorem: &Theorem, claim: &TheoremClaim, comparison: Comparison, value: &Fraction) -> Verdict {
    let of = claim.difference.as_str();
    let (relation, negate) = relation(comparison);
    let polynomial = |value: &Fraction| with_sign(theorem, value, negate);
    let whole = polynomial(value);
    if let Some(gram) = Gram::of(&whole, &theorem.products) {
        return match gram.decide(relation) {
            Ok(squares) => {
                let method = gram::method(&squares);
                let proof = StepProof::Squares(squares);
                Verdict::Proved(Evidence { method, steps: vec![Step { of: of.to_string(), proof }] })
            }
            Err(line) => {
                let net = Net::on_a_line(theorem, &line);
                let value = on_net(theorem, value, &net);
                let at = coordinates(theorem, &[]);
                let witness = refutation(theorem, &net, of.to_string(), &value, &at);
                explained(theorem, claim, witness, "the value is")
            }
        };
    }
    if let Some(form) = Quadratic::new(theorem, &whole) {
        return form.decide(theorem, claim, relation, value);
    }
    let decide = |value: &Fraction, budget: &mut Budget| {
        decide::decide(&polynomial(value), relation, &theorem.region(), budget)
    };
    let fresh = || Budget::scaled(theorem.budget);
    let witness = match decide(value, &mut fresh()) {
        Decision::Proved(proof) => {
            let method = proof.method.to_string();
            let proof = StepProof::Sign(proof);
            return Verdict::Proved(Evidence { method, steps: vec![Step { of: of.to_string(), proof }] });
        }
        Decision::Undecided(left) => {
            // With definite points in place of coordinates the question is a smaller one.
            let budget = &mut fresh();
            for net in nets(theorem).take(if theorem.dimension.is_some() { ATTEMPTS } else { 0 }) {
                let value = on_net(theorem, value, &net);
                if let Decision::Refuted(witness) = decide(&value, budget) {
                    return counterexample(theorem, claim, &net, &value, &witness);
                }
            }
            return Verdict::Undecided(format!("`{of}`: {left}"));
        }
        Decision::Refuted(witness) => witness,
    };
    if theorem.products.iter().any(|(var, _)| value.depends_on(*var)) {
        // Dot products are not any numbers: the claim must fail for a net.
        for net in nets(theorem) {
            let value = on_net(theorem, value, &net);
            if let Decision::Refuted(witness) = decide(&value, &mut fresh()) {
                return counterexample(theorem, claim, &net, &value, &witness);
            }
        }
        return Verdict::Undecided(format!(
            "`{of}`: it fails for some numbers in place of the dot products, but for no points that were tried"
        ));
    }
    let at = coordinates(theorem, &witness.point);
    let net = Net::from_coordinates(theorem, &at);
    counterexample(theorem, claim, &net, value, &witness)
}

/// The witness of an inequality; at irrational values of scalars the function is exactly zero.
pub(super) fn counterexample(
    theorem: &Theorem,
    claim: &TheoremClaim,
    net: &Net,
    value: &Fraction,
    witness: &decide::Witness,
) -> Verdict {
    let at = coordinates(theorem, &witness.point);
    let mut result = refutation(theorem, net, claim.difference.clone(), value, &at);
    let irrational = witness.point.iter().filter(|(_, c)| matches!(c, Coordinate::Algebraic(_)));
    let vars: Vec<Var> = irrational.clone().map(|(var, _)| *var).collect();
    for (var, c) in irrational {
        let name = &theorem.names[var.0];
        match result.at.iter_mut().find(|(n, _)| n == name) {
            Some(slot) => slot.1 = c.clone(),
            // A coordinate of a control point.
            None => result.notes.push(c.describe(name)),
        }
        result.value = witness.value.clone();
        result.net = evaluated(theorem, net, &at, &vars);
    }
    explained(theorem, claim, result, "the value is")
}

/// The rational values by variable, simple ones for what is left open.
pub(super) fn coordinates(theorem: &Theorem, point: &[(Var, Coordinate)]) -> Vec<Rational> {
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    for scalar in &theorem.scalars {
        at[scalar.var.0] = point::simple(&scalar.range);
    }
    for (var, c) in point {
        if let (Coordinate::Rational(x), Some(slot)) = (c, at.get_mut(var.0)) {
            *slot = x.clone();
        }
    }
    at
}

/// The expressions whose values can contradict a claim on a net, with their values where they do.
#[cfg(any(test, feature = "tools"))]
pub(super) fn contradictions(
    theorem: &Theorem,
    claim: &TheoremClaim,
    net: &Net,
    at: &[Rational],
) -> Vec<(String, Option<Rational>)> {
    let of = &claim.difference;
    let value = |f: &Fraction| on_net(theorem, f, net).eval(at);
    let values = |parts: Vec<(String, Fraction)>| -> Vec<(String, Rational)> {
        parts.into_iter().map(|(label, f)| (label, f.eval(at).unwrap_or(Rational::ZERO))).collect()
    };
    match &claim.kind {
        TheoremClaimKind::Scalar(Comparison::Equal, f) => {
            vec![(of.clone(), value(f).filter(|x| !x.is_zero()))]
        }
        TheoremClaimKind::Scalar(comparison, f) => {
            let (relation, negate) = relation(*comparison);
            let fails = |x: &Rational| !relation.holds(&if negate { -x } else { x.clone() });
            vec![(of.clone(), value(f).filter(fails))]
        }
        TheoremClaimKind::Zero(form) => values(parts(theorem, form, net))
            .into_iter()
            .map(|(label, x)| {
                let of = if label.is_empty() { of.clone() } else { format!("({of}){label}") };
                (of, Some(x).filter(|x| !x.is_zero()))
            })
            .collect(),
        TheoremClaimKind::Parallel(a, b) => {
            let (left, right) = claim.text.split_once(" parallel ").unwrap_or((&claim.text, ""));
            let [x, y] = super::net::parts_of_both(theorem, [a, b], net).map(values);
            let zero = x.iter().chain(&y).all(|(_, v)| v.is_zero());
            let dot = x.iter().zip(&y).fold(Rational::ZERO, |sum, ((_, p), (_, q))| &sum + &(p * q));
            let mut all =
                vec![(format!("dot({left}, {right})"), Some(dot).filter(|d| !zero && !d.is_positive()))];
            for i in 0..x.len() {
                for j in i + 1..x.len().min(y.len()) {
                    let minor = &(&x[i].1 * &y[j].1) - &(&x[j].1 * &y[i].1);
                    let (p, q) = (&x[i].0, &x[j].0);
                    let of = if x.len() == 2 {
                        format!("cross({left}, {right})")
                    } else {
                        format!("({left}){p}*({right}){q} - ({left}){q}*({right}){p}")
                    };
                    all.push((of, Some(minor).filter(|m| !m.is_zero())));
                }
            }
            all
        }
    }
}
