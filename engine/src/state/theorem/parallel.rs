//! Directions: of two vectors one is a positive multiple of the other, or both are zero.
//!
//! With a = n·h and b = d·h, n and d without a common factor, that is so exactly if n·d > 0 wherever h is not zero. A
//! factor of n·d that divides all coordinates of h, or the sum of their squares, can only be zero where h is: so it is
//! enough that n·d ≥ 0, and that the other factors have no zeros.

use basis_prover::collections::list::Listed;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::{Coordinate, Failure, Symmetries, candidates, decide as decide_statement, refute, simple};

use super::net::{Net, nets, parts_of_both};
use super::products;
use super::witness::{explained, witness, witness_nets};
use crate::algebra::divisors::factor::factor;
use crate::algebra::divisors::gcd::checked_gcd;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{Claim, Comparison, Side};
use crate::state::family::premises;
use crate::state::inequality::compared;
use crate::state::proofs::steps;
use crate::state::verdict::{Evidence, Stated, Verdict, Witness};
use crate::theorem::{Form, Theorem, Unit};

/// The work for common factors, and for values at algebraic points.
const WORK: u64 = 1_000_000;

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
        let common: Vec<Poly> = common.terms.values().map(|h| h.numer().clone()).listed();
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
        // The common factor need not be believed.
        if common.iter().any(|p| p.div_exact(&shared).is_none()) {
            shared = Poly::one();
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

    /// What has to be shown: n·d > 0; if factors of it matter only where both sides are zero, n·d ≥ 0, and that the
    /// other factors have no zeros.
    fn signs(&self, theorem: &Theorem) -> Vec<(String, Poly, Relation)> {
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

/// dot(h, h) up to a denominator, for a combination h of points without coordinates, if all dot products in it occur in
/// the theorem.
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

/// A polynomial without factors that divide another one as well.
fn without(mut poly: Poly, other: &Poly, work: &mut Work) -> Poly {
    while !poly.is_zero() {
        let shared = checked_gcd(&poly, other, work).unwrap_or_else(Poly::one);
        if shared.as_constant().is_some() || other.div_exact(&shared).is_none() {
            break;
        }
        let Some(quotient) = poly.div_exact(&shared) else { break };
        poly = quotient;
    }
    poly
}

/// p or −p, whichever is positive at the simplest values of the ranges; a polynomial that is zero there has no sign.
fn with_positive_value(theorem: &Theorem, p: &Poly) -> Poly {
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    for (var, range) in &theorem.region().ranges {
        if let Some(slot) = at.get_mut(var.0) {
            *slot = simple(range);
        }
    }
    if p.eval(&at).is_negative() { -p } else { p.clone() }
}

/// Values of the scalars at which a polynomial in them is not zero.
fn nonzero(theorem: &Theorem, p: &Poly) -> Option<Vec<Rational>> {
    let domain = theorem.scalar_domain();
    let zero = compared(&Fraction::from(p.clone()), Comparison::Equal, &domain);
    let Err(Failure::Refuted(found)) = decide_statement(zero, &Symmetries::new(), 1) else { return None };
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    for (var, c) in &found.point {
        if let (Some(slot), Coordinate::Rational(x)) = (at.get_mut(var.0), c) {
            *slot = x.clone();
        }
    }
    Some(at)
}

/// The factor f with a = f·b as text, if there is one.
pub(super) fn factor_text(theorem: &Theorem, left: &Side, right: &Side) -> Option<String> {
    if left.value.is_zero() && right.value.is_zero() {
        return None;
    }
    Some(Proportion::new(theorem, &left.value, &right.value)?.shown(theorem))
}

/// The statement that a polynomial is ≥ 0 (> 0).
pub(super) fn sign(p: &Poly, relation: Relation, domain: &Rc<Domain>) -> Statement {
    Statement::Sign { value: Fraction::from(p.clone()).quotient(), relation, domain: Rc::clone(domain) }
}

/// What has to be shown for two vectors to have the same direction: that they are proportional, and the signs of the
/// factors.
pub(super) fn statements(theorem: &Theorem, left: &Side, right: &Side) -> Vec<Stated> {
    let (a, b) = (&left.value, &right.value);
    let domain = theorem.scalar_domain();
    let zero = |of: String, f: &Fraction| Stated::new(of, compared(f, Comparison::Equal, &domain));
    let of = format!("{} - {}", left.text, right.text);
    if a.is_zero() && b.is_zero() {
        return vec![zero(of, &Fraction::zero())];
    }
    let Some(found) = Proportion::new(theorem, a, b) else {
        // No factor at all: nothing can be proved.
        return vec![zero(of, &Fraction::constant(Rational::ONE))];
    };
    let [n, d] = found.factors.clone().map(Fraction::from);
    let mut all = Vec::new();
    let mut units: Vec<Unit> = a.terms.keys().copied().listed();
    units.extend(b.terms.keys().filter(|unit| !a.terms.contains_key(unit)));
    for unit in units {
        let difference = &(&d * &a.coefficient(unit)) - &(&n * &b.coefficient(unit));
        all.push(zero(format!("{} - ({})*({})", left.text, found.shown(theorem), right.text), &difference));
    }
    let domain = theorem.domain();
    for (of, polynomial, relation) in found.signs(theorem) {
        let as_products = products::statement(theorem, &polynomial, relation);
        all.push(Stated::new(of, as_products.unwrap_or_else(|| sign(&polynomial, relation, &domain))));
    }
    super::parts::enough(all, &mut premises::without)
}

/// What is said of the points of a net: all minors of the two vectors are zero, and wherever one of them is not zero,
/// their dot product is positive.
pub(super) fn on_points(
    theorem: &Theorem,
    [left, right]: [&Side; 2],
    net: &Net,
    domain: &Rc<Domain>,
) -> Vec<Stated> {
    let parts = parts_of_both(theorem, [&left.value, &right.value], net);
    let [x, y] = &parts;
    let mut dot = Fraction::zero();
    let mut squares = Poly::zero();
    for ((_, p), (_, q)) in x.iter().zip(y) {
        dot = &dot + &(p * q);
        squares = &(&squares + &p.numer().pow(2)) + &q.numer().pow(2);
    }
    let mut where_not_zero = (**domain).clone();
    where_not_zero.premises.push((squares, Relation::Positive));
    let positive = compared(&dot, Comparison::Greater, &Rc::new(where_not_zero));
    let mut all = vec![Stated::new(format!("dot({}, {})", left.text, right.text), positive)];
    all.extend(minors(&parts, [left, right], domain));
    all
}

/// All 2×2 minors of two vectors, given by their parts: these are zero exactly where the vectors are dependent.
fn minors(
    [x, y]: &[Vec<(String, Fraction)>; 2],
    [left, right]: [&Side; 2],
    domain: &Rc<Domain>,
) -> impl Iterator<Item = Stated> {
    let (left, right) = (&left.text, &right.text);
    let count = x.len().min(y.len());
    let pairs = (0..count).flat_map(move |i| (i + 1..count).map(move |j| (i, j)));
    pairs.map(move |(i, j)| {
        let minor = &(&x[i].1 * &y[j].1) - &(&x[j].1 * &y[i].1);
        let (p, q) = (&x[i].0, &x[j].0);
        let of = if x.len() == 2 {
            format!("cross({left}, {right})")
        } else {
            format!("({left}){p}*({right}){q} - ({left}){q}*({right}){p}")
        };
        Stated::new(of, compared(&minor, Comparison::Equal, domain))
    })
}

/// Decides whether two vectors have the same direction; messages have the factor as given, if it is.
pub(super) fn decide(
    theorem: &Theorem,
    claim: &Claim,
    [left, right]: [&Side; 2],
    factor: Option<&str>,
) -> Verdict {
    let (a, b) = (&left.value, &right.value);
    let both_zero = a.is_zero() && b.is_zero();
    let found = if both_zero { None } else { Proportion::new(theorem, a, b) };
    if !both_zero && found.is_none() {
        return not_proportional(theorem, claim, [left, right]);
    }
    let mut shown = Vec::new();
    let mut open = None;
    for Stated { of, statement, .. } in statements(theorem, left, right) {
        match decide_statement(statement, &Symmetries::new(), theorem.budget) {
            Ok(proved) => shown.push((of, proved)),
            Err(Failure::Refuted(_)) => {
                open.get_or_insert_with(|| String::from(BOTH_ZERO));
            }
            Err(Failure::Undecided(left)) => open = Some(left),
        }
    }
    let Some(found) = found else {
        return match open {
            None => Verdict::Proved(Evidence::new(String::from("expansion of both sides"), steps(shown))),
            Some(left) => Verdict::Undecided(left),
        };
    };
    let factor_shown = factor.map_or_else(|| found.shown(theorem), String::from);
    let Some(open) = open else {
        let sign = if found.rest == found.product { "> 0" } else { "> 0 where the sides are not zero" };
        let count = found.signs(theorem).len();
        let methods: Vec<String> =
            shown[shown.len() - count..].iter().map(|(_, shown)| shown.method.to_string()).listed();
        let method = format!("expansion with the factor {factor_shown} {sign} ({})", methods.join(", "));
        return Verdict::Proved(Evidence::new(method, steps(shown)));
    };
    for point in points(theorem, &found) {
        if let Some(mut result) = failing(theorem, [left, right], &point) {
            let note = if result.value.is_zero() {
                "one side is zero and the other is not:"
            } else {
                "the two sides have opposite directions:"
            };
            if !found.factors[1].is_zero() && factor_shown.len() <= MAX_SHOWN {
                result.notes.push(format!("the left side is ({factor_shown}) times the right side"));
            }
            return explained(theorem, claim, result, note);
        }
    }
    let shown = if factor_shown.len() <= MAX_SHOWN {
        format!("({factor_shown})")
    } else {
        String::from("a long factor")
    };
    Verdict::Undecided(format!("the left side is {shown} times the right side; {open}"))
}

/// Points at which the factor may not be positive: where it is negative, and a coordinate is not zero; then, where it
/// is zero.
fn points<'a>(
    theorem: &'a Theorem,
    found: &Proportion,
) -> impl Iterator<Item = Vec<(Var, Coordinate)>> + use<'a> {
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
    let mut first: Vec<Vec<(Var, Coordinate)>> = Vec::new();
    if found.product.is_zero() {
        // One side is zero everywhere.
        let at = found.common.iter().find_map(|p| nonzero(theorem, p));
        first.extend(at.map(|at| {
            theorem.scalars.iter().map(|p| (p.var, Coordinate::Rational(at[p.var.0].clone()))).listed()
        }));
        attempts.clear();
    }
    let domain = theorem.domain();
    let decided = attempts.into_iter().filter_map(move |(polynomial, relation)| {
        match decide_statement(sign(&polynomial, relation, &domain), &Symmetries::new(), theorem.budget) {
            Err(Failure::Refuted(found)) => Some(found.point),
            Ok(_) | Err(Failure::Undecided(_)) => None,
        }
    });
    let common = found.common.clone();
    let elsewhere = factors.into_iter().flat_map(move |(factor, _)| zeros(theorem, &factor, &common));
    first.into_iter().chain(decided).chain(elsewhere)
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
        let mut values = candidates(&scalar.range, VALUES as u32);
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
        let domain = theorem.domain();
        match decide_statement(sign(&rest, Relation::Positive, &domain), &Symmetries::new(), 1) {
            Err(Failure::Refuted(found)) => {
                point.extend(found.point.into_iter().filter(|(var, _)| *var == unknown));
                Some(point)
            }
            Ok(_) | Err(Failure::Undecided(_)) => None,
        }
    })
}

/// The witness at a point where the factor is not positive; `None` if both sides are zero there.
fn failing(theorem: &Theorem, sides: [&Side; 2], point: &[(Var, Coordinate)]) -> Option<Witness> {
    let domain = theorem.scalar_domain();
    let scalars: Vec<(Var, Coordinate)> = theorem
        .scalars
        .iter()
        .map(|p| {
            let given = point.iter().find(|(v, _)| *v == p.var).map(|(_, c)| c.clone());
            (p.var, given.unwrap_or_else(|| Coordinate::Rational(basis_prover::typical(&p.range))))
        })
        .listed();
    let mut at = vec![Rational::ZERO; theorem.names.len()];
    for (var, c) in point {
        match c {
            Coordinate::Rational(x) => at[var.0] = x.clone(),
            // Control points can be chosen, irrational coordinates of theirs are not looked for.
            Coordinate::Algebraic(_) if theorem.scalars.iter().any(|p| p.var == *var) => {}
            Coordinate::Algebraic(_) => return None,
        }
    }
    let given = theorem.dimension.map(|_| Net::from_coordinates(theorem, &at));
    for net in given.into_iter().chain(nets(theorem)) {
        let Some(Stated { of, statement, .. }) = on_points(theorem, sides, &net, &domain).into_iter().next()
        else {
            continue;
        };
        if let Some(found) = refute(&Rc::new(statement), &scalars, &mut Work::new(EXPLICIT)) {
            return Some(witness(theorem, of, Some(&net), &found, false));
        }
    }
    None
}

/// The work for making a counterexample explicit.
const EXPLICIT: u64 = 5_000_000;

/// The factor f with a = f·b as functions; `None` when there is none.
fn proportion(a: &Form, b: &Form) -> Option<Fraction> {
    let (unit, y) = b.terms.iter().next()?;
    let factor = a.coefficient(*unit).checked_div(y)?;
    let proportional = b.terms.iter().all(|(unit, y)| a.coefficient(*unit) == &factor * y);
    (proportional && a.terms.keys().all(|unit| b.terms.contains_key(unit))).then_some(factor)
}

/// A point at which the coordinates of two vectors are not proportional.
fn not_proportional(theorem: &Theorem, claim: &Claim, sides: [&Side; 2]) -> Verdict {
    let domain = theorem.scalar_domain();
    for net in witness_nets(theorem, claim) {
        let parts = parts_of_both(theorem, sides.map(|side| &side.value), &net);
        for Stated { of, statement, .. } in minors(&parts, sides, &domain) {
            if let Some(found) = super::refuted(statement, theorem.budget) {
                let witness = witness(theorem, of, Some(&net), &found, false);
                return explained(theorem, claim, witness, "the directions differ:");
            }
        }
    }
    Verdict::Undecided(String::from(
        "the two sides are different expressions, but no point was found at which they differ",
    ))
}
