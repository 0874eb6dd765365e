//! Signs under assumptions that are no part of a box, such as α² + β² ≤ 1.
//!
//! **Theorem.** Where g ≥ 0, a function f with f − c·m·g ≥ 0 is ≥ 0, for a number c ≥ 0 and a product m of powers that are ≥ 0
//! (the S-procedure of V. A. Yakubovich 1971). It is > 0 if f − c·m·g is, or if g, c and m are.
//!
//! Where g is a polynomial in one variable, f = q·g + r by division, and q ≥ 0 and r ≥ 0 are enough.
//!
//! Where x > 0, f has the sign of x·f.
//!
//! Where f has at most one degree more than g: f = P + N with P ≥ 0 is ≥ 0 if P² − N² is, as |N| ≤ P then. The product m may
//! be P² there.
//!
//! The premise is then no longer needed: f − c·m·g ≥ 0 is said of the whole box. The number c has to satisfy
//! c·m·g ≤ f at all points; what some points say of it leaves an interval, from which it is chosen. That it is right is for
//! the kernel to see.

mod ends;
mod narrower;
mod points;
mod positive;
mod search;
mod touching;

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort;
use std::rc::Rc;

use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::poly::{Monomial, Poly, PolyExt as _, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;
pub(super) use points::inside;
use points::{directions, fits, ranges, sample, values};
pub(super) use positive::Positive;
pub(in crate::state) use search::counterexample;

/// How often the steps towards a narrower interval for a number are halved.
const NEARER: usize = 6;

/// From how many points with the same value steps are made.
const STARTS: usize = 6;

/// How often steps of one length are made.
const REPEATED: usize = 4;

/// Sums of more terms are not squared.
const MAX_SQUARED: usize = 12;

/// What is enough for a statement about a sign to hold where its premises do; `None` if it does not need them, or seems to be
/// false, or no multiple of a premise is found to help.
pub(in crate::state) fn without(statement: &Statement) -> Option<Vec<Statement>> {
    let Statement::Sign { value, relation, domain } = statement else { return None };
    if domain.premises.is_empty() {
        return None;
    }
    let sign = Sign { value: Positive::of(domain).reduced(value), relation: *relation, domain };
    let seen = Seen::new(&sign.value, domain)?;
    // Without a value of the wrong sign the box alone may be enough.
    if !seen.fails(sign.relation) && sign.value == *value {
        return None;
    }
    sign.enough(&seen, domain.premises.len() + 1)
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
}

impl Sign<'_> {
    /// The statement about the whole box.
    fn plain(&self) -> Statement {
        let (value, relation) = (self.value.clone(), self.relation);
        Statement::Sign { value, relation, domain: without_premises(self.domain) }
    }

    /// Statements about the whole box from which it follows.
    fn enough(&self, seen: &Seen, depth: usize) -> Option<Vec<Statement>> {
        if !seen.fails(self.relation) {
            return Some(vec![self.plain()]);
        }
        let divided = |exactly| self.divided(depth, exactly);
        divided(true)
            .or_else(|| self.at_irrational_ends())
            .or_else(|| divided(false))
            // A factor alone, of which from a few points little can be seen where a range has no end.
            .or_else(|| {
                let alone = self.value.numerator.len() == 1 && self.is_unbounded();
                alone.then(|| self.multiplied())?
            })
            .or_else(|| self.by_factors())
            .or_else(|| self.by_number(seen))
            .or_else(|| self.squared())
            .or_else(|| self.multiplied())
            .or_else(|| self.narrowed())
            .or_else(|| self.bounded(depth))
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
            sign *= if even { own * own } else { own };
            if even && self.relation == Relation::NonNegative {
                continue;
            }
            let value = Quotient::from(if own < 0 { -&factor } else { factor });
            let part = Sign { value, relation: self.relation, domain: self.domain };
            let seen = Seen::new(&part.value, self.domain)?;
            all.extend(if seen.fails(part.relation) { part.by_number(&seen)? } else { vec![part.plain()] });
        }
        (sign > 0).then_some(all)
    }

    /// For P + N, where P ≥ 0: that P² − N² has the sign.
    fn squared(&self) -> Option<Vec<Statement>> {
        let Quotient { numerator, denominator } = &self.value;
        let degree = self.domain.premises.iter().map(|(g, _)| g.total_degree()).max()?;
        if !denominator.is_one() || numerator.total_degree() > degree + 1 || numerator.len() > MAX_SQUARED {
            return None;
        }
        // Terms that are ≥ 0, or those with positive coefficients.
        let positive = |_: &Monomial, c: &Rational| c.is_positive();
        let [_, others] = signed(numerator.variables(), self.domain);
        let nonnegative = |m: &Monomial, c: &Rational| {
            c.is_positive() && others.iter().all(|v| m.exponent(*v).is_multiple_of(2))
        };
        self.squared_from(&nonnegative).or_else(|| self.squared_from(&positive))
    }

    /// Whether a variable of the premises has a range without an end.
    fn is_unbounded(&self) -> bool {
        let ranges = self.domain.region.ranges.iter();
        let mut open = ranges.filter(|(_, range)| range.finite().is_none());
        open.any(|(v, _)| self.domain.premises.iter().any(|(g, _)| g.depends_on(*v)))
    }

    /// That a variable is positive where the premises hold, and its product with the quotient has the sign.
    fn multiplied(&self) -> Option<Vec<Statement>> {
        let premises = self.domain.premises.iter();
        let mut variables = premises.flat_map(|(g, _)| g.variables()).listed();
        sort(&mut variables);
        variables.dedup();
        let [nonnegative, _] = signed(variables, self.domain);
        nonnegative.into_iter().find_map(|v| {
            let x = Poly::var(v);
            let positive = self.positive(v)?;
            if self.relation == Relation::Positive && self.value == Quotient::from(x.clone()) {
                return Some(positive);
            }
            let numerator = &self.value.numerator * &x;
            let value = Quotient { numerator, ..self.value.clone() };
            Some([positive, Sign { value, ..*self }.by_any_number()?].concat())
        })
    }

    /// That a variable which is ≥ 0 is positive: a premise fails where it is 0, or a multiple of one shows it.
    fn positive(&self, v: Var) -> Option<Vec<Statement>> {
        let sign =
            |value: Poly| Sign { value: value.into(), relation: Relation::Positive, domain: self.domain };
        let negative_at_zero = self.domain.premises.iter().find_map(|(g, _)| {
            let sign = sign(-&g.at(v, &Rational::ZERO));
            let is_negative = match sign.value.numerator.as_constant() {
                Some(c) => c.is_positive(),
                None => !Seen::new(&sign.value, self.domain)?.fails(sign.relation),
            };
            is_negative.then(|| vec![sign.plain()])
        });
        negative_at_zero.or_else(|| sign(Poly::var(v)).by_any_number())
    }

    /// By the box alone, or with a number times a premise taken away.
    fn by_any_number(&self) -> Option<Vec<Statement>> {
        let seen = Seen::new(&self.value, self.domain)?;
        if seen.fails(self.relation) {
            self.by_number_times(&seen, Some(&Poly::one()))
        } else {
            Some(vec![self.plain()])
        }
    }

    /// The same where P consists of some terms.
    fn squared_from(&self, is_above: &dyn Fn(&Monomial, &Rational) -> bool) -> Option<Vec<Statement>> {
        let part = |wanted: bool| {
            let own = self.value.numerator.terms().filter(|(m, c)| is_above(m, c) == wanted);
            Poly::from_terms(own.map(|(m, c)| (m.clone(), c.clone())))
        };
        let (above, below) = (part(true), part(false));
        if above.is_zero() || below.is_zero() {
            return None;
        }
        let square = above.pow(2);
        let value = Quotient::from(&square - &below.pow(2));
        let sign = Sign { value, relation: self.relation, domain: self.domain };
        let seen = Seen::new(&sign.value, self.domain)?;
        let domain = without_premises(self.domain);
        let first = Statement::Sign { value: above.into(), relation: Relation::NonNegative, domain };
        let rest = if seen.fails(sign.relation) {
            sign.by_number_times(&seen, Some(&square))?
        } else {
            vec![sign.plain()]
        };
        Some([vec![first], rest].concat())
    }

    /// For a quotient of q·g + r, where g is a premise: that q and r have the sign. `exactly` where r is 0.
    fn divided(&self, depth: usize, exactly: bool) -> Option<Vec<Statement>> {
        let depth = depth.checked_sub(1)?;
        let part = |numerator: Poly, relation: Relation| {
            let value = Quotient { numerator, denominator: self.value.denominator.clone() };
            let sign = Sign { value, relation, domain: self.domain };
            let seen = Seen::new(&sign.value, self.domain)?;
            let mut fails = seen
                .points
                .iter()
                .zip(&seen.values)
                .filter(|(_, value)| value.as_ref().is_some_and(Rational::is_negative));
            if fails.any(|(point, _)| self.domain.premises.iter().all(|(g, sign)| sign.holds(&g.eval(point))))
            {
                return None;
            }
            sign.enough(&seen, depth)
        };
        self.domain.premises.iter().find_map(|(g, premise)| {
            let (q, r) = divided(&self.value.numerator, g)?;
            if r.is_zero() != exactly || q.is_zero() {
                return None;
            }
            // Strict is what has one strict summand.
            if r.is_zero() {
                let strict = self.relation == Relation::Positive;
                if strict && *premise != Relation::Positive {
                    return None;
                }
                return part(q, self.relation);
            }
            Some([part(q, Relation::NonNegative)?, part(r, self.relation)?].concat())
        })
    }

    /// With a number times a premise taken away, and times something that is ≥ 0.
    fn by_number(&self, seen: &Seen) -> Option<Vec<Statement>> {
        self.by_number_times(seen, None)
    }

    /// The same, also times a square.
    fn by_number_times(&self, seen: &Seen, square: Option<&Poly>) -> Option<Vec<Statement>> {
        let Self { value, relation, domain } = self;
        let Seen { points, .. } = seen;
        let one = Poly::one();
        let below = &value.denominator;
        let is_positive = |p: &Poly| {
            let values = values(p, &one, points);
            !p.is_one() && values.is_some_and(|all| all.iter().flatten().all(Rational::is_positive))
        };
        for (g, premise) in domain.premises.iter().filter(|(g, _)| !g.is_zero()) {
            // What vanishes with a power that all terms share is positive only by the premise itself.
            let alone = (*relation == Relation::Positive).then(Poly::one);
            let all = factors(&value.numerator, g, domain);
            let alone = alone.filter(|one| !all.contains(one));
            for factor in alone.into_iter().chain(all).chain(square.cloned()) {
                let product = &factor * g;
                // Over the denominator of the value, too, or over the part of it in the variables of the premise.
                let part = of_variables(below, g).filter(|part| part != below);
                let over = [Some(below.clone()), part].into_iter().flatten().filter(|p| is_positive(p));
                for over in [one.clone()].into_iter().chain(over) {
                    let quotient = Quotient { numerator: product.clone(), denominator: over.clone() };
                    let Some(c) = self.multiple(seen, &quotient) else { continue };
                    let numerator = &value.numerator - &(&product.scale(&c) * &below.div_exact(&over)?);
                    // From a strict premise follows a strict inequality.
                    let strict =
                        *relation == Relation::Positive && *premise == Relation::Positive && factor.is_one();
                    let relation = if strict { Relation::NonNegative } else { *relation };
                    let domain = without_premises(domain);
                    let sign = |value: Quotient, relation| Statement::Sign {
                        value,
                        relation,
                        domain: Rc::clone(&domain),
                    };
                    let rest = sign(Quotient { numerator, denominator: below.clone() }, relation);
                    let denominator = (!over.is_one()).then(|| sign(over.into(), Relation::Positive));
                    return Some([rest].into_iter().chain(denominator).listed());
                }
            }
        }
        None
    }
}

impl Sign<'_> {
    /// A number c > 0 with c·g ≤ f at all points, in the middle of those that do.
    fn multiple(&self, seen: &Seen, g: &Quotient) -> Option<Rational> {
        let g_values = values(&g.numerator, &g.denominator, &seen.points)?;
        // The largest lower and the least upper bound, with the points that say so.
        let mut bounds: [Option<(Rational, Vec<usize>)>; 2] = [None, None];
        for (k, pair) in seen.values.iter().zip(&g_values).enumerate() {
            let (Some(f), Some(g)) = pair else { continue };
            let sign = g.signum();
            if sign == 0 {
                if f.is_negative() {
                    return None;
                }
                continue;
            }
            let own = f.checked_div(g)?;
            let bound = &mut bounds[usize::from(sign > 0)];
            match bound {
                Some((known, points)) if *known == own => points.push(k),
                Some((known, _)) if (own > *known) == (sign > 0) => {}
                _ => *bound = Some((own, vec![k])),
            }
        }
        let [low, high] = bounds;
        let Some((high, highest)) = high else {
            return Some(&low.map_or(Rational::ZERO, |(low, _)| low).max(Rational::ZERO) + &Rational::ONE);
        };
        let (low, lowest) = low.unwrap_or((Rational::ZERO, Vec::new()));
        if low > high {
            return None;
        }
        // Where f and g vanish together there is a single such number, and nearby points leave little room around it.
        let nearer = |all: &[usize], bound: Rational, sign: i32| {
            // Of many points with one value some in all parts of the domain, first and last one included.
            let last = all.len().saturating_sub(1);
            let starts = (0..STARTS.min(all.len())).map(|k| all[k * last / (STARTS - 1).min(last).max(1)]);
            let found = starts.map(|k| self.nearer(g, &seen.points[k], bound.clone(), sign));
            if sign > 0 { found.min() } else { found.max() }.unwrap_or(bound)
        };
        let high = nearer(&highest, high, 1);
        let low = nearer(&lowest, low, -1).max(Rational::ZERO);
        if low > high {
            return None;
        }
        // Away from both ends, if there is room; where there is little it may be an end.
        let width = &high - &low;
        let little = width < &high * &Rational::new(1, 50);
        let aside = if little { Rational::ZERO } else { &width * &Rational::new(1, 4) };
        let c = simplest_within(&(&low + &aside), &(&high - &aside));
        c.is_positive().then_some(c)
    }

    /// The quotient f/g where g has a sign, made smaller where it is positive and larger where it is negative, step by step
    /// from a point.
    fn nearer(&self, g: &Quotient, from: &[Rational], value: Rational, sign: i32) -> Rational {
        let ranges = ranges(self.domain);
        let depends = |q: &Quotient, v: Var| q.numerator.depends_on(v) || q.denominator.depends_on(v);
        let moving: Vec<&(Var, Range)> =
            ranges.iter().filter(|(v, _)| depends(&self.value, *v) || depends(g, *v)).collect();
        let at = |point: &[Rational]| {
            let value = |q: &Quotient| q.numerator.eval(point).checked_div(&q.denominator.eval(point));
            basis_prover::charged(&mut || {
                let below = value(g).filter(|g| g.signum() == sign)?;
                value(&self.value)?.checked_div(&below)
            })?
        };
        let short =
            |d: &Vec<i64>| d.iter().all(|k| k.abs() <= 1) && d.iter().filter(|k| **k != 0).count() <= 2;
        let directions: Vec<Vec<i64>> = directions(moving.len()).into_iter().filter(short).collect();
        let (mut point, mut best) = (from.to_vec(), value);
        let mut step = Rational::new(1, 16);
        for _ in 0..NEARER {
            for _ in 0..REPEATED {
                let mut moved = false;
                for direction in &directions {
                    let mut next = point.clone();
                    for ((var, range), steps) in moving.iter().zip(direction) {
                        let width = range.finite().map_or(Rational::ONE, |(low, high)| high - low);
                        next[var.0] += &(&(&step * &width) * &Rational::from(*steps));
                    }
                    let inside = ranges.iter().all(|(var, range)| range.contains(&next[var.0]));
                    if !inside || !fits(self.domain, &next) {
                        continue;
                    }
                    if let Some(own) = at(&next)
                        && (if sign > 0 { own < best } else { own > best })
                    {
                        (point, best, moved) = (next, own, true);
                    }
                }
                if !moved {
                    break;
                }
            }
            step = &step * &Rational::new(1, 2);
        }
        best
    }
}

/// The factor of a product that has the variables of a premise, if the others do not occur in it.
fn of_variables(product: &Poly, premise: &Poly) -> Option<Poly> {
    let others = product.variables().into_iter().filter(|v| !premise.depends_on(*v));
    let part = others.fold(product.clone(), |p, v| p.at(v, &Rational::ZERO));
    product.div_exact(&part).map(|_| part)
}

/// What a premise is multiplied by: the powers that a numerator has in all its terms, alone, and times the distances from
/// the ends of the ranges of other variables, and times their squares; where its degree is lower than that of the numerator
/// also variables that are ≥ 0, their sum, and squares.
fn factors(numerator: &Poly, premise: &Poly, domain: &Domain) -> Vec<Poly> {
    let own = common(numerator, domain);
    let mut all = vec![own.clone()];
    let others = ranges(domain);
    let others = others.iter().filter(|(v, _)| numerator.depends_on(*v) && !premise.depends_on(*v));
    for (var, range) in others {
        let x = Poly::var(*var);
        let low = range.low.value().map(|end| &x - &Poly::constant(end.clone()));
        let high = range.high.value().map(|end| &Poly::constant(end.clone()) - &x);
        for distance in [low, high].into_iter().flatten() {
            all.push(&own * &distance);
            all.push(&own * &distance.pow(2));
        }
    }
    if own.is_one() && numerator.total_degree() > premise.total_degree() {
        let [positive, others] = signed(premise.variables(), domain);
        all.extend(positive.iter().map(|v| Poly::var(*v)));
        if positive.len() > 1 {
            all.push(positive.iter().fold(Poly::zero(), |sum, v| &sum + &Poly::var(*v)));
        }
        all.extend(others.iter().map(|v| Poly::var(*v).pow(2)));
    }
    all
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

/// The powers that all terms of a polynomial share of variables that are ≥ 0, and the even ones of others.
fn common(p: &Poly, domain: &Domain) -> Poly {
    let mut factor = Poly::one();
    for (var, range) in &ranges(domain) {
        let power = p.terms().map(|(m, _)| m.exponent(*var)).min().unwrap_or(0);
        let power = if is_nonnegative(range) { power } else { power - power % 2 };
        factor = &factor * &Poly::var(*var).pow(u32::from(power));
    }
    factor
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::range::Region;
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
