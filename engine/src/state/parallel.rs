//! Directions of vectors: `a parallel b` is true at a point if a = f·b there for some f > 0, or both are zero.

use super::gram::{self, Gram};
use super::net::{Net, evaluated, nets, parts, parts_of_both};
#[cfg(any(test, feature = "tools"))]
use super::theorem::sign_assertion;
use super::theorem::{coordinates, explained, identity, no_witness, nonzero, refutation, witness_nets};
#[cfg(any(test, feature = "tools"))]
use super::{Assertion, Statement};
use super::{Evidence, Step, StepProof, Verdict, Witness, point};
use crate::algebra::algebraic::Algebraic;
use crate::algebra::factor::factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::gcd::checked_gcd;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::Mapped;
use crate::decide::{self, Budget, Coordinate, Decision, Relation, is_zero};
use crate::model::theorem::{Form, Theorem, TheoremClaim, Unit};

/// The work for common factors, and for values at algebraic points.
pub(super) const WORK: u64 = 1_000_000;

/// What is left of a claim if the factor is not positive everywhere.
const BOTH_ZERO: &str = "where it is not positive, both may be zero";

/// Factors with more bytes are not written in messages.
const MAX_SHOWN: usize = 160;
/// The most terms of which squares are summed up.
const MAX_TERMS: usize = 64;
/// Values of each scalar, and combinations of them, with which zeros of a factor are looked for.
const VALUES: usize = 3;
const ATTEMPTS: usize = 60;

/// Two vectors that are multiples of a third one: a = n·h and b = d·h.
struct Proportion {
    /// n and d, without a common factor.
    factors: [Poly; 2],
    /// The coordinates of h that are different from 0, up to denominators, which vanish nowhere.
    common: Vec<Poly>,
    /// n·d
    product: Poly,
    /// n·d without the factors that can only be zero where h, and with it a and b, is zero.
    rest: Poly,
}

impl Proportion {
    /// `None` when a and b are not multiples of one another.
    fn new(theorem: &Theorem, a: &Form, b: &Form) -> Option<Self> {
        let (factors, common) = if b.is_zero() {
            ([Poly::one(), Poly::zero()], a.clone())
        } else {
            let factor = proportion(a, b)?;
            let below = Fraction::from(factor.denom().clone());
            let whole = factor.denom().as_constant().is_some();
            let common = b.map(&mut |y| if whole { Ok(y.clone()) } else { y.checked_div(&below).ok_or(()) });
            ([factor.numer().clone(), factor.denom().clone()], common.ok()?)
        };
        let squared = square(theorem, &common);
        let common: Vec<Poly> = common.terms.values().map(|h| h.numer().clone()).collect();
        let product = &factors[0] * &factors[1];
        let work = &mut Work::new(WORK);
        // Where a factor of one of these is zero, h is: all its coordinates, or the sum of their squares.
        let mut shared = product.clone();
        for p in &common {
            if shared.as_constant().is_some() {
                break;
            }
            shared = checked_gcd(&shared, p, work).unwrap_or_else(Poly::one);
        }
        let mut rest = without(product.clone(), &shared, work);
        if rest.as_constant().is_none() && common.iter().map(Poly::len).sum::<usize>() <= MAX_TERMS {
            let squares = common.iter().fold(Poly::zero(), |sum, p| &sum + &p.pow(2));
            rest = without(rest, &squares, work);
        }
        if let (None, Some(squared)) = (rest.as_constant(), squared) {
            rest = without(rest, &squared, work);
        }
        Some(Self { factors, common, product, rest })
    }

    /// f with a = f·b as text.
    fn shown(&self, theorem: &Theorem) -> String {
        let [n, d] = &self.factors;
        let quotient = Fraction::new(n.clone(), d.clone());
        quotient.map_or_else(|| String::from("1/0"), |f| f.display(&theorem.names))
    }

    /// What has to be shown: n·d > 0; if factors of it matter only where both sides are zero, n·d ≥ 0, and that the other factors
    /// have no zeros.
    fn statements(&self, theorem: &Theorem) -> Vec<(String, Poly, Relation)> {
        if self.rest == self.product {
            return vec![(self.shown(theorem), self.product.clone(), Relation::Positive)];
        }
        let text = |p: &Poly| p.display(&theorem.names).to_string();
        let mut all = vec![(text(&self.product), self.product.clone(), Relation::NonNegative)];
        if self.rest.as_constant().is_none() {
            let rest = with_positive_value(theorem, &self.rest);
            all.push((text(&rest), rest, Relation::Positive));
        }
        all
    }
}

/// dot(h, h) up to a denominator, for a combination h of points without coordinates, if all dot products in it occur in the theorem.
fn square(theorem: &Theorem, h: &Form) -> Option<Poly> {
    let terms = h.terms.values().map(|f| f.numer().len() + f.denom().len()).sum::<usize>();
    if theorem.products.is_empty() || terms > MAX_TERMS {
        return None;
    }
    let mut sum = Fraction::zero();
    for (p, x) in &h.terms {
        for (q, y) in &h.terms {
            let (Unit::Point(p), Unit::Point(q)) = (*p, *q) else { return None };
            let pair = (p.min(q), p.max(q));
            let (var, _) = theorem.products.iter().find(|(_, other)| *other == pair)?;
            sum = &sum + &(&(x * y) * &Fraction::var(*var));
        }
    }
    Some(sum.numer().clone())
}

/// A polynomial without the factors that it shares with another one.
fn without(mut poly: Poly, other: &Poly, work: &mut Work) -> Poly {
    while !poly.is_zero() {
        let shared = checked_gcd(&poly, other, work).unwrap_or_else(Poly::one);
        match poly.div_exact(&shared) {
            Some(quotient) if shared.as_constant().is_none() => poly = quotient,
            _ => break,
        }
    }
    poly
}

/// ± p, positive at some point of the ranges.
fn with_positive_value(theorem: &Theorem, p: &Poly) -> Poly {
    let at = nonzero(theorem, &Fraction::from(p.clone()));
    if at.is_some_and(|at| p.eval(&at).is_negative()) { -p } else { p.clone() }
}

/// What has to be shown for two vectors to have the same direction.
#[cfg(any(test, feature = "tools"))]
pub(super) fn statements(theorem: &Theorem, claim: &TheoremClaim, a: &Form, b: &Form) -> Vec<Statement> {
    let budget = theorem.budget;
    let zero = |value: Fraction| Statement {
        of: claim.difference.clone(),
        assertion: Assertion::Zero(value),
        budget,
    };
    if a.is_zero() && b.is_zero() {
        return vec![zero(Fraction::zero())];
    }
    let Some(found) = Proportion::new(theorem, a, b) else {
        // No factor at all: nothing can be proved.
        return vec![zero(Fraction::constant(Rational::ONE))];
    };
    let statement = |(of, polynomial, relation): (String, Poly, Relation)| Statement {
        of,
        assertion: sign_assertion(theorem, polynomial, relation),
        budget,
    };
    found.statements(theorem).into_iter().map(statement).collect()
}

/// Decides whether two vectors have the same direction.
pub(super) fn parallel(theorem: &Theorem, claim: &TheoremClaim, a: &Form, b: &Form) -> Verdict {
    if a.is_zero() && b.is_zero() {
        return identity(&claim.difference);
    }
    let (left, right) = claim.text.split_once(" parallel ").unwrap_or((&claim.text, ""));
    let Some(found) = Proportion::new(theorem, a, b) else {
        return not_proportional(theorem, claim, [a, b], [left, right]);
    };
    let decide = |p: &Poly, relation: Relation| {
        decide::decide(p, relation, &theorem.region(), &mut Budget::scaled(theorem.budget))
    };
    let shown = found.shown(theorem);
    let mut steps = Vec::new();
    let mut methods = Vec::new();
    let mut open = None;
    for (of, polynomial, relation) in found.statements(theorem) {
        if let Some(gram) = Gram::of(&polynomial, &theorem.products) {
            match gram.decide(relation) {
                Ok(squares) => {
                    methods.push(gram::method(&squares));
                    steps.push(Step { of, proof: StepProof::Squares(squares) });
                }
                Err(_) => {
                    open.get_or_insert_with(|| String::from(BOTH_ZERO));
                }
            }
            continue;
        }
        match decide(&polynomial, relation) {
            Decision::Proved(proof) => {
                methods.push(proof.method.to_string());
                steps.push(Step { of, proof: StepProof::Sign(proof) });
            }
            Decision::Refuted(_) => {
                open.get_or_insert_with(|| String::from(BOTH_ZERO));
            }
            Decision::Undecided(left) => open = Some(left),
        }
    }
    let Some(open) = open else {
        let sign = if found.rest == found.product { "> 0" } else { "> 0 where the sides are not zero" };
        let method = format!("expansion with the factor {shown} {sign} ({})", methods.join(", "));
        return Verdict::Proved(Evidence { method, steps });
    };
    // Where the factor is negative, and a coordinate is not zero; then, where it is zero.
    let square = found.common.first().map_or_else(Poly::one, |p| p.pow(2));
    let mut attempts = vec![
        (found.product.clone(), Relation::NonNegative),
        (&found.product * &square, Relation::NonNegative),
        (with_positive_value(theorem, &found.rest), Relation::Positive),
    ];
    let factors = factor(&found.rest).1;
    for (factor, _) in &factors {
        attempts.push((with_positive_value(theorem, factor), Relation::Positive));
    }
    let mut points: Vec<Vec<(Var, Coordinate)>> = Vec::new();
    if found.product.is_zero() {
        // One side is zero everywhere.
        let at = found.common.iter().find_map(|p| nonzero(theorem, &Fraction::from(p.clone())));
        points.extend(at.map(|at| {
            theorem.scalars.iter().map(|p| (p.var, Coordinate::Rational(at[p.var.0].clone()))).collect()
        }));
        attempts.clear();
    }
    let found_points =
        attempts.into_iter().filter_map(|(polynomial, relation)| match decide(&polynomial, relation) {
            Decision::Refuted(witness) => Some(witness.point),
            Decision::Proved(_) | Decision::Undecided(_) => None,
        });
    let elsewhere = factors.into_iter().flat_map(|(factor, _)| zeros(theorem, &factor, &found.common));
    for point in points.into_iter().chain(found_points).chain(elsewhere) {
        if let Some(mut result) = failing(theorem, [a, b], &point, [left, right]) {
            let note = if result.value.is_zero() {
                "one side is zero and the other is not:"
            } else {
                "the two sides have opposite directions:"
            };
            if !found.factors[1].is_zero() && shown.len() <= MAX_SHOWN {
                result.notes.push(format!("the left side is ({shown}) times the right side"));
            }
            return explained(theorem, claim, result, note);
        }
    }
    let shown = if shown.len() <= MAX_SHOWN { format!("({shown})") } else { String::from("a long factor") };
    Verdict::Undecided(format!("the left side is {shown} times the right side; {open}"))
}

/// Zeros of a factor where all scalars but one have simple values, of those on which it or a coordinate depends.
fn zeros<'a>(
    theorem: &'a Theorem,
    factor: &Poly,
    common: &[Poly],
) -> impl Iterator<Item = Vec<(Var, Coordinate)>> + use<'a> {
    let mut scalars = Vec::new();
    let mut unknowns = Vec::new();
    for scalar in &theorem.scalars {
        if factor.depends_on(scalar.var) {
            unknowns.push(scalar.var);
        } else if !common.iter().any(|p| p.depends_on(scalar.var)) {
            continue;
        }
        let mut values = point::candidates(&scalar.range, VALUES as u32);
        values.truncate(VALUES);
        scalars.push((scalar.var, values));
    }
    // The square is not positive at zeros of the factor only.
    let square = factor.pow(2);
    let attempts = if unknowns.is_empty() { 0 } else { ATTEMPTS };
    (0..attempts).filter_map(move |attempt| {
        let unknown = unknowns[attempt % unknowns.len()];
        let mut choice = attempt / unknowns.len();
        let mut rest = square.clone();
        let mut point = Vec::new();
        for (var, values) in scalars.iter().filter(|(var, _)| *var != unknown) {
            let x = &values[choice % values.len()];
            choice /= values.len();
            rest = rest.at(*var, x);
            point.push((*var, Coordinate::Rational(x.clone())));
        }
        match decide::decide(&rest, Relation::Positive, &theorem.region(), &mut Budget::default()) {
            Decision::Refuted(witness) => {
                point.extend(witness.point.into_iter().filter(|(var, _)| *var == unknown));
                Some(point)
            }
            Decision::Proved(_) | Decision::Undecided(_) => None,
        }
    })
}

/// The witness at a point where the factor is not positive; `None` if both sides are zero there.
fn failing(
    theorem: &Theorem,
    [a, b]: [&Form; 2],
    point: &[(Var, Coordinate)],
    [left, right]: [&str; 2],
) -> Option<Witness> {
    let at = coordinates(theorem, point);
    let of = format!("dot({left}, {right})");
    let algebraic: Vec<_> = point
        .iter()
        .filter_map(|(var, c)| match c {
            Coordinate::Algebraic(x) => Some((*var, x.clone())),
            Coordinate::Rational(_) => None,
        })
        .collect();
    if algebraic.is_empty() {
        let given = theorem.dimension.map(|_| Net::from_coordinates(theorem, &at));
        for net in given.into_iter().chain(nets(theorem)) {
            let values = |parts: &[(String, Fraction)]| -> Option<Vec<Rational>> {
                parts.iter().map(|(_, f)| f.eval(&at)).collect()
            };
            let [x, y] = parts_of_both(theorem, [a, b], &net);
            let (Some(x), Some(y)) = (values(&x), values(&y)) else { continue };
            let dot = x.iter().zip(&y).fold(Rational::ZERO, |sum, (p, q)| &sum + &(p * q));
            if !dot.is_positive() && !x.iter().chain(&y).all(Rational::is_zero) {
                return Some(refutation(theorem, &net, of, &Fraction::constant(dot), &at));
            }
        }
        return None;
    }
    // Control points can be chosen, irrational coordinates of theirs are not looked for.
    let scalars = algebraic.iter().all(|(var, _)| theorem.scalars.iter().any(|p| p.var == *var));
    if !scalars {
        return None;
    }
    let work = &mut Work::new(WORK);
    let net = nets(theorem).find(|net| one_vanishes(theorem, net, [a, b], &at, &algebraic, work))?;
    let irrational: Vec<Var> = algebraic.mapped(|(var, _)| *var);
    let net = evaluated(theorem, &net, &at, &irrational);
    let named = theorem.scalars.iter().map(|p| {
        let value = algebraic.iter().find(|(var, _)| *var == p.var);
        let value = value.map_or_else(
            || Coordinate::Rational(at[p.var.0].clone()),
            |(_, x)| Coordinate::Algebraic(x.clone()),
        );
        (p.name.clone(), value)
    });
    let at = named.collect();
    Some(Witness { of, at, idle: Vec::new(), net, value: Rational::ZERO, notes: Vec::new() })
}

/// Whether on a net one of two vectors is zero and the other is not, where some scalars are irrational.
pub(super) fn one_vanishes(
    theorem: &Theorem,
    net: &Net,
    [a, b]: [&Form; 2],
    at: &[Rational],
    algebraic: &[(Var, Algebraic)],
    work: &mut Work,
) -> bool {
    let mut zeros = |form: &Form| -> Vec<Option<bool>> {
        let mut zero = |f: &Fraction| {
            let p = f.numer();
            let rational = p.variables().into_iter().filter(|v| !algebraic.iter().any(|(var, _)| var == v));
            is_zero(&rational.fold(p.clone(), |p, v| p.at(v, &at[v.0])), algebraic, work)
        };
        parts(theorem, form, net).iter().map(|(_, f)| zero(f)).collect()
    };
    let (a, b) = (zeros(a), zeros(b));
    let vanishes = |values: &[Option<bool>]| values.iter().all(|zero| *zero == Some(true));
    let differs = |values: &[Option<bool>]| values.contains(&Some(false));
    (vanishes(&a) && differs(&b)) || (vanishes(&b) && differs(&a))
}

/// The factor f with a = f·b as functions; `None` when there is none.
fn proportion(a: &Form, b: &Form) -> Option<Fraction> {
    let (unit, y) = b.terms.iter().next()?;
    let factor = a.coefficient(*unit).checked_div(y)?;
    let proportional = b.terms.iter().all(|(unit, y)| a.coefficient(*unit) == &factor * y);
    (proportional && a.terms.keys().all(|unit| b.terms.contains_key(unit))).then_some(factor)
}

/// A point at which the coordinates of two vectors are not proportional.
fn not_proportional(
    theorem: &Theorem,
    claim: &TheoremClaim,
    [a, b]: [&Form; 2],
    [left, right]: [&str; 2],
) -> Verdict {
    for net in witness_nets(theorem, claim) {
        let [x, y] = parts_of_both(theorem, [a, b], &net);
        for i in 0..x.len() {
            for j in i + 1..x.len().min(y.len()) {
                let minor = &(&x[i].1 * &y[j].1) - &(&x[j].1 * &y[i].1);
                let Some(at) = nonzero(theorem, &minor) else { continue };
                let (p, q) = (&x[i].0, &x[j].0);
                let of = if x.len() == 2 {
                    format!("cross({left}, {right})")
                } else {
                    format!("({left}){p}*({right}){q} - ({left}){q}*({right}){p}")
                };
                let witness = refutation(theorem, &net, of, &minor, &at);
                return explained(theorem, claim, witness, "the directions differ:");
            }
        }
    }
    no_witness()
}
