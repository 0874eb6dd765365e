//! Signs under assumptions that are no part of a box, such as α² + β² ≤ 1.
//!
//! **Theorem.** Where g ≥ 0, a function f with f − c·m·g ≥ 0 is ≥ 0, for a number c ≥ 0 and a product m of powers that are ≥ 0
//! (the S-procedure of V. A. Yakubovich 1971). It is > 0 if f − c·m·g is, or if g, c and m are.
//!
//! Where g is a polynomial in one variable, f = q·g + r by division, and q ≥ 0 and r ≥ 0 are enough.
//!
//! Where x > 0, f has the sign of x·f. Where x ≥ 0, f ≥ 0 if x·f ≥ 0, and f ≥ 0 for x = 0.
//!
//! Where f has at most one degree more than g: f = P + N with P ≥ 0 is ≥ 0 if P² − N² is, as |N| ≤ P then. The product m may
//! be P² there.
//!
//! On an ellipsoid g ≥ 0, a function that is linear in its variables is ≥ 0 if it is at the middle, by enough.
//!
//! Where d ≥ 0 follows from the premises, n/d has the sign of n. Where n is a positive number plus f ≥ 0, it is positive. A range has no end
//! at which a premise fails; and f > 0 may be shown at an end of a range and beyond it apart, where m > 0 and g > 0 are enough.
//!
//! f = 0 if −f² ≥ 0.
//!
//! The premise is then no longer needed: f − c·m·g ≥ 0 is said of the whole box.
//!
//! There are many such ways, each of which leads to statements that are enough. The first one is the one that proves most
//! claims; where it does not, [`tried`] finds another one, of which the number is part of the evidence.

mod counterexample;
mod ellipsoid;
mod ends;
mod equalities;
mod faces;
mod multiple;
mod narrower;
mod numbered;
mod points;
mod positive;
mod quotients;
mod search;
mod touching;

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort;
use std::rc::Rc;

use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::poly::{Monomial, Poly, PolyExt as _, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
pub(in crate::state) use counterexample::counterexample;
pub(crate) use numbered::proved;
pub(in crate::state) use numbered::{are_first, by, by_first, by_next, is_assumed, tried, without};
pub(crate) use points::inside;
use points::{counts, ranges, sample, values};
pub(super) use positive::Positive;

/// Sums of more terms are not squared.
const MAX_SQUARED: usize = 12;

/// What is left where nothing is found, although a claim is false of more points than are assumed.
pub(in crate::state) const NOT_DERIVED: &str = "it could not be derived from what is assumed";

/// Takes statements that are enough, and says whether they will do.
type Accept<'a> = dyn FnMut(Vec<Statement>) -> bool + 'a;

/// Statements that are enough, by one way after the other, each with its number, until one will do. They are numbered from 1 on
/// where the statement itself, without its premises, seems to be true.
fn ways(statement: &Statement, accept: &mut dyn FnMut(usize, Vec<Statement>) -> bool) -> Option<()> {
    let Statement::Sign { value, relation, domain } = statement else { return None };
    if !is_assumed(statement) {
        return None;
    }
    let sign = Sign { value: Positive::of(domain).reduced(value), relation: *relation, domain };
    let seen = Seen::new(&sign.value, domain)?;
    if seen.refutes(sign.relation, domain) {
        return None;
    }
    // Without a value of the wrong sign the box alone may be enough.
    let mut next = usize::from(!seen.fails(sign.relation) && sign.value == *value);
    sign.enough(&seen, domain.premises.len() + 1, &mut |enough| {
        next += 1;
        accept(next - 1, enough)
    });
    Some(())
}

/// The first statements of some.
fn first(all: &mut dyn FnMut(&mut Accept<'_>) -> bool) -> Option<Vec<Statement>> {
    let mut found = None;
    all(&mut |enough| {
        found = Some(enough);
        true
    });
    found
}

/// That a quotient has a sign where premises hold.
struct Sign<'s> {
    value: Quotient,
    relation: Relation,
    domain: &'s Domain,
}

/// Points of a box, and the values of a quotient there.
struct Seen {
    points: Vec<Vec<Rational>>,
    values: Vec<Option<Rational>>,
}

impl Seen {
    fn new(value: &Quotient, domain: &Domain) -> Option<Self> {
        let points = sample(value, domain)?;
        let values = values(&value.numerator, &value.denominator, &points)?;
        Some(Self { points, values })
    }

    /// Whether one of the values does not have a sign.
    fn fails(&self, relation: Relation) -> bool {
        self.values.iter().flatten().any(|value| !relation.holds(value))
    }

    /// Whether a value does not have a sign where the premises of a domain hold: then no way leads to a proof.
    fn refutes(&self, relation: Relation, domain: &Domain) -> bool {
        let mut all = self.points.iter().zip(&self.values);
        all.any(|(point, value)| value.as_ref().is_some_and(|x| !relation.holds(x)) && counts(domain, point))
    }
}

impl Sign<'_> {
    /// The statement about the whole box.
    fn plain(&self) -> Statement {
        let (value, relation) = (self.value.clone(), self.relation);
        Statement::Sign { value, relation, domain: without_premises(self.domain) }
    }

    /// The same, if a number or the values at some points do not contradict it.
    fn if_seen(&self) -> Option<Statement> {
        let is_seen = match self.value.numerator.as_constant() {
            Some(c) if self.value.denominator.is_one() => self.relation.holds(&c),
            _ => !Seen::new(&self.value, self.domain)?.fails(self.relation),
        };
        is_seen.then(|| self.plain())
    }

    /// The rest on a narrower box, where these statements say that the premises fail elsewhere.
    fn on_narrower(
        &self,
        region: Region,
        elsewhere: &[Statement],
        depth: usize,
        accept: &mut Accept<'_>,
    ) -> bool {
        if elsewhere.is_empty() {
            return false;
        }
        let domain = Domain { region, ..self.domain.clone() };
        let rest = Sign { value: self.value.clone(), relation: self.relation, domain: &domain };
        let Some(seen) = Seen::new(&rest.value, &domain) else { return false };
        rest.enough(&seen, depth, &mut |rest| accept([elsewhere, &rest].concat()))
    }

    /// Statements about the whole box from which it follows, by one way after the other, until one will do.
    fn enough(&self, seen: &Seen, depth: usize, accept: &mut Accept<'_>) -> bool {
        if !seen.fails(self.relation) && accept(vec![self.plain()]) {
            return true;
        }
        let mut found = |way: Option<Vec<Statement>>| way.is_some_and(&mut *accept);
        // A factor alone, of which from a few points little can be seen where a range has no end.
        let alone = self.value.numerator.len() == 1 && self.is_unbounded();
        self.above_and_below(depth, true, &mut |all| found(Some(all)))
            || self.divided(depth, true, &mut |all| found(Some(all)))
            || self.opened(depth, &mut |all| found(Some(all)))
            || found(self.by_zeros())
            || found(self.at_irrational_ends())
            || self.divided(depth, false, &mut |all| found(Some(all)))
            || alone && self.multiplied(depth, &mut |all| found(Some(all)))
            || found(self.by_factors())
            || self.by_number(seen, None, &mut |all| found(Some(all)))
            || self.above_and_below(depth, false, &mut |all| found(Some(all)))
            || self.end_apart(depth, &mut |all| found(Some(all)))
            || self.without_number(depth, &mut |all| found(Some(all)))
            || found(self.on_ellipsoid())
            || self.squared(&mut |all| found(Some(all)))
            || found(self.narrowed())
            || self.bounded(depth, &mut |all| found(Some(all)))
            || self.multiplied(depth, &mut |all| found(Some(all)))
    }

    /// The factors g(x·v) of a polynomial and the rest, g(x) a premise and v a variable, as of cos(t) = g(tan(t/4))·h
    /// on 0 ≤ t ≤ α ≤ π/2, where tan(t/4) is a part of tan(α/4).
    fn premises_of_parts(&self, p: &Poly) -> (Poly, Vec<(Poly, u32)>) {
        let (mut rest, mut found) = (p.clone(), Vec::new());
        for (g, _) in &self.domain.premises {
            let [x] = g.variables()[..] else { continue };
            for v in p.variables().into_iter().filter(|v| *v != x) {
                let (one, v) = (Poly::one(), Poly::var(v));
                let turned = &v + &(&v - &one);
                for part in [v, turned.clone(), -&turned] {
                    let factor = g.substitute(x, &(&Poly::var(x) * &part));
                    let mut exponent = 0;
                    while let Some(quotient) = rest.div_exact(&factor) {
                        (rest, exponent) = (quotient, exponent + 1);
                    }
                    if exponent > 0 {
                        found.push((factor, exponent));
                    }
                }
            }
        }
        (rest, found)
    }

    /// That each factor has the sign that it has at a point inside, if their product has the right one there.
    fn by_factors(&self) -> Option<Vec<Statement>> {
        let Quotient { numerator, denominator } = &self.value;
        let (rest, mut factors) = self.premises_of_parts(numerator);
        let (number, others) = basis_prover::working(1, &mut |work| checked_factor(&rest, work))?;
        factors.extend(others);
        if factors.len() < 2 && factors.iter().all(|(_, exponent)| *exponent == 1) {
            return None;
        }
        let point = inside(numerator, self.domain)?;
        let (mut all, mut sign) = (Vec::new(), number.signum());
        if !denominator.is_one() {
            let below = denominator.eval(&point).signum();
            sign *= below;
            let value = Quotient::from(if below < 0 { -denominator } else { denominator.clone() });
            all.push(Sign { value, relation: Relation::Positive, domain: self.domain }.plain());
        }
        for (factor, exponent) in factors {
            let even = exponent % 2 == 0;
            let own = factor.eval(&point).signum();
            sign *= if even { 1 } else { own };
            if even && self.relation == Relation::NonNegative {
                continue;
            }
            let value = Quotient::from(if own < 0 { -&factor } else { factor });
            let part = Sign { value, relation: self.relation, domain: self.domain };
            let seen = Seen::new(&part.value, self.domain)?;
            all.extend(if seen.fails(part.relation) {
                part.by_first_number(&seen)?
            } else {
                vec![part.plain()]
            });
        }
        (sign > 0).then_some(all)
    }

    /// For a polynomial with a constant term that is positive: that the rest is ≥ 0.
    fn without_number(&self, depth: usize, accept: &mut Accept<'_>) -> bool {
        let Quotient { numerator, denominator } = &self.value;
        let number = self.value.numerator.terms().find(|(m, _)| m.is_one()).map(|(_, c)| c.clone());
        let (Some(number), Some(depth)) = (number.filter(Rational::is_positive), depth.checked_sub(1)) else {
            return false;
        };
        if !denominator.is_one() {
            return false;
        }
        let value = Quotient::from(numerator - &Poly::constant(number));
        let rest = Sign { value, relation: Relation::NonNegative, domain: self.domain };
        let seen = Seen::new(&rest.value, self.domain);
        let Some(seen) = seen.filter(|seen| !seen.refutes(rest.relation, self.domain)) else { return false };
        rest.enough(&seen, depth, accept)
    }

    /// For P + N, where P ≥ 0: that P² − N² has the sign.
    fn squared(&self, accept: &mut Accept<'_>) -> bool {
        let Quotient { numerator, denominator } = &self.value;
        let degree = self.domain.premises.iter().map(|(g, _)| g.total_degree()).max().unwrap_or(0);
        if !denominator.is_one() || numerator.total_degree() > degree + 1 || numerator.len() > MAX_SQUARED {
            return false;
        }
        // Terms that are ≥ 0, or those with positive coefficients.
        let positive = |_: &Monomial, c: &Rational| c.is_positive();
        let [_, others] = signed(numerator.variables(), self.domain);
        let nonnegative = |m: &Monomial, c: &Rational| {
            c.is_positive() && others.iter().all(|v| m.exponent(*v).is_multiple_of(2))
        };
        self.squared_from(&nonnegative, accept) || self.squared_from(&positive, accept)
    }

    /// Whether a variable of the premises has a range without an end.
    fn is_unbounded(&self) -> bool {
        let ranges = self.domain.region.ranges.iter();
        let mut open = ranges.filter(|(_, range)| range.finite().is_none());
        open.any(|(v, _)| self.domain.premises.iter().any(|(g, _)| g.depends_on(*v)))
    }

    /// That a variable is positive where the premises hold, or the sign for the value 0 of it; and its product with the
    /// quotient has the sign.
    fn multiplied(&self, depth: usize, accept: &mut Accept<'_>) -> bool {
        let premises = self.domain.premises.iter();
        let mut variables = premises.flat_map(|(g, _)| g.variables()).listed();
        sort(&mut variables);
        variables.dedup();
        let [nonnegative, _] = signed(variables, self.domain);
        nonnegative.into_iter().any(|v| {
            let x = Poly::var(v);
            let numerator = &self.value.numerator * &x;
            let product = Sign { value: Quotient { numerator, ..self.value.clone() }, ..*self };
            if let Some(positive) = self.positive(v) {
                if self.relation == Relation::Positive && self.value == Quotient::from(x) {
                    return accept(positive);
                }
                return product.by_any_number(&mut |rest| accept([&positive[..], &rest].concat()));
            }
            self.relation == Relation::NonNegative
                && self.at_zero(v, depth, &mut |at_zero| {
                    product.by_any_number(&mut |rest| accept([&at_zero[..], &rest].concat()))
                })
        })
    }

    /// The sign where a variable is 0.
    fn at_zero(&self, v: Var, depth: usize, accept: &mut Accept<'_>) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        let zero = Rational::ZERO;
        let mut domain = self.domain.clone();
        let ranges = domain.region.ranges.iter_mut();
        let Some((_, range)) = ranges.into_iter().find(|(own, _)| *own == v) else { return false };
        *range = Range::closed(zero.clone(), zero.clone());
        let mut zeros = vec![v];
        for (g, _) in &mut domain.premises {
            *g = g.at(v, &zero);
        }
        // Where −x² ≥ 0, x is 0, too.
        while let Some(x) = domain.premises.iter().find_map(|(g, _)| vanishing(g)) {
            for (g, _) in &mut domain.premises {
                *g = g.at(x, &zero);
            }
            for (_, range) in domain.region.ranges.iter_mut().filter(|(own, _)| *own == x) {
                *range = Range::closed(zero.clone(), zero.clone());
            }
            zeros.push(x);
        }
        let at_zeros = |p: &Poly| zeros.iter().fold(p.clone(), |p, x| p.at(*x, &zero));
        let [numerator, denominator] = [&self.value.numerator, &self.value.denominator].map(at_zeros);
        if denominator.is_zero() {
            return false;
        }
        let sign = Sign { value: Quotient { numerator, denominator }, domain: &domain, ..*self };
        Seen::new(&sign.value, &domain).is_some_and(|seen| sign.enough(&seen, depth, accept))
    }

    /// That a variable which is ≥ 0 is positive: a premise fails where it is 0, or a multiple of one shows it.
    fn positive(&self, v: Var) -> Option<Vec<Statement>> {
        let sign =
            |value: Poly| Sign { value: value.into(), relation: Relation::Positive, domain: self.domain };
        let premises = self.domain.premises.iter();
        let negative_at_zero =
            premises.into_iter().find_map(|(g, _)| sign(-&g.at(v, &Rational::ZERO)).if_seen());
        let negative_at_zero = negative_at_zero.map(|negative| vec![negative]);
        negative_at_zero.or_else(|| first(&mut |accept| sign(Poly::var(v)).by_any_number(accept)))
    }

    /// By the box alone, or with a number times a premise taken away.
    fn by_any_number(&self, accept: &mut Accept<'_>) -> bool {
        let Some(seen) = Seen::new(&self.value, self.domain) else { return false };
        if seen.fails(self.relation) {
            self.by_number(&seen, Some(&Poly::one()), accept)
        } else {
            accept(vec![self.plain()])
        }
    }

    /// The same where P consists of some terms.
    fn squared_from(&self, is_above: &dyn Fn(&Monomial, &Rational) -> bool, accept: &mut Accept<'_>) -> bool {
        let part = |wanted: bool| {
            let own = self.value.numerator.terms().filter(|(m, c)| is_above(m, c) == wanted);
            Poly::from_terms(own.map(|(m, c)| (m.clone(), c.clone())))
        };
        let (above, below) = (part(true), part(false));
        if above.is_zero() || below.is_zero() {
            return false;
        }
        let square = above.pow(2);
        let value = Quotient::from(&square - &below.pow(2));
        let sign = Sign { value, relation: self.relation, domain: self.domain };
        let Some(seen) = Seen::new(&sign.value, self.domain) else { return false };
        let domain = without_premises(self.domain);
        let at_least = Statement::Sign { value: above.into(), relation: Relation::NonNegative, domain };
        let mut with_it = |rest: Vec<Statement>| accept([vec![at_least.clone()], rest].concat());
        if seen.fails(sign.relation) {
            sign.by_number(&seen, Some(&square), &mut with_it)
        } else {
            with_it(vec![sign.plain()])
        }
    }

    /// For a quotient of q·g + r, where g is a premise: that q and r have the sign. `exactly` where r is 0.
    fn divided(&self, depth: usize, exactly: bool, accept: &mut Accept<'_>) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        let part = |numerator: &Poly, relation: Relation, accept: &mut Accept<'_>| {
            let value =
                Quotient { numerator: numerator.clone(), denominator: self.value.denominator.clone() };
            let sign = Sign { value, relation, domain: self.domain };
            let Some(seen) = Seen::new(&sign.value, self.domain) else { return false };
            !seen.refutes(Relation::NonNegative, self.domain) && sign.enough(&seen, depth, accept)
        };
        self.domain.premises.iter().any(|(g, premise)| {
            let Some((q, r)) = divided(&self.value.numerator, g) else { return false };
            if r.is_zero() != exactly || q.is_zero() {
                return false;
            }
            // Strict is what has one strict summand.
            if r.is_zero() {
                let strict = self.relation == Relation::Positive;
                return !(strict && *premise != Relation::Positive) && part(&q, self.relation, accept);
            }
            part(&q, Relation::NonNegative, &mut |of_q| {
                part(&r, self.relation, &mut |of_r| accept([&of_q[..], &of_r].concat()))
            })
        })
    }
}

/// The variable that vanishes where a polynomial −c·x², −c·x⁴, … is ≥ 0.
fn vanishing(g: &Poly) -> Option<Var> {
    let ([x], [coefficient]) = (&g.variables()[..], &g.terms().map(|(_, c)| c.clone()).listed()[..]) else {
        return None;
    };
    (coefficient.is_negative() && g.degree(*x).is_multiple_of(2)).then_some(*x)
}

/// Whether a range has no negative numbers.
fn is_nonnegative(range: &Range) -> bool {
    range.low.value().is_some_and(|low| !low.is_negative())
}

/// The variables that are ≥ 0, and the others.
fn signed(variables: Vec<Var>, domain: &Domain) -> [Vec<Var>; 2] {
    let ranges = ranges(domain);
    let fits = |v: &Var| ranges.iter().any(|(own, range)| own == v && is_nonnegative(range));
    let (nonnegative, others) = variables.into_iter().partition(fits);
    [nonnegative, others]
}

fn without_premises(domain: &Domain) -> Rc<Domain> {
    Rc::new(Domain { premises: Vec::new(), ..domain.clone() })
}

/// q and r with f = q·g + r, where g is a polynomial in one variable and r has a lower degree in it.
fn divided(f: &Poly, g: &Poly) -> Option<(Poly, Poly)> {
    let [x] = g.variables()[..] else { return None };
    let degree = g.degree(x);
    let lead = g.coefficients_in(x).pop()?.as_constant()?.recip()?;
    let (mut q, mut r) = (Poly::zero(), f.clone());
    while r.degree(x) >= degree && !r.is_zero() {
        let top = r.degree(x);
        let coefficient = r.coefficients_in(x).pop()?;
        let term = (&coefficient * &Poly::var(x).pow(top - degree)).scale(&lead);
        r = &r - &(&term * g);
        q = &q + &term;
    }
    Some((q, r))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::work::Work;
    use basis_prover::Coordinate;

    fn x() -> Poly {
        Poly::var(Var(0))
    }

    fn y() -> Poly {
        Poly::var(Var(1))
    }

    fn on_disk(f: &Poly, relation: Relation) -> Statement {
        let both = Range::closed(Rational::from(-1), Rational::ONE);
        let region = Region { ranges: vec![(Var(0), both.clone()), (Var(1), both)] };
        let disk = &(&Poly::one() - &x().pow(2)) - &y().pow(2);
        let domain = Domain { premises: vec![(disk, Relation::NonNegative)], ..Domain::of(region) };
        Statement::Sign { value: f.clone().into(), relation, domain: Rc::new(domain) }
    }

    fn proved(f: &Poly) -> bool {
        let statements = without(&on_disk(f, Relation::NonNegative)).expect("a multiple of the premise");
        statements.into_iter().all(|statement| basis_prover::decide(statement, &Vec::new(), 1).is_ok())
    }

    #[test]
    fn signs_on_a_disk() {
        let number = |n: i64, d: i64| Poly::constant(Rational::new(n, d));
        let sum = &x() + &y();
        assert!(proved(&(&number(2, 1) - &sum.pow(2))));
        assert!(proved(&(&number(3, 2) - &sum)));
        assert!(proved(&(&number(1, 1) - &(&x() * &y()).scale(&Rational::from(2)))));
        // √2 is a little less than 1.4143.
        assert!(proved(&(&number(1_415, 1_000) - &sum)));
    }

    #[test]
    fn what_is_false_is_refuted_inside() {
        let sum = &x() + &y();
        let f = &Poly::constant(Rational::new(13, 10)) - &sum;
        let statement = on_disk(&f, Relation::NonNegative);
        let found = counterexample(&statement, &mut Work::unlimited()).expect("a point");
        let at = |k: usize| match &found.point[k].1 {
            Coordinate::Rational(x) => x.clone(),
            Coordinate::Algebraic(_) => panic!("a rational point"),
        };
        assert!(&(&at(0) * &at(0)) + &(&at(1) * &at(1)) <= Rational::ONE);
        assert!(&at(0) + &at(1) > Rational::new(13, 10));
        // Outside of the disk only.
        let f = &Poly::constant(Rational::new(3, 2)) - &sum;
        assert!(counterexample(&on_disk(&f, Relation::NonNegative), &mut Work::unlimited()).is_none());
    }
}
