//! A number times a premise, taken away.
//!
//! The number c has to satisfy c·m·g ≤ f at all points; what some points say of it leaves an interval, from which it is
//! chosen. That it is right is for the kernel to see.

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::Listed;
use std::rc::Rc;

use super::points::{directions, fits, ranges, values};
use super::{Accept, Seen, Sign, first, is_nonnegative, signed, without_premises};
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;

/// How often the steps towards a narrower interval for a number are halved.
const NEARER: usize = 6;

/// From how many points with the same value steps are made.
const STARTS: usize = 6;

/// How often steps of one length are made.
const REPEATED: usize = 4;

impl Sign<'_> {
    /// The first statements of [`by_number`](Self::by_number).
    pub(super) fn by_first_number(&self, seen: &Seen) -> Option<Vec<Statement>> {
        first(&mut |accept| self.by_number(seen, None, accept))
    }

    /// With a number times a premise taken away, and times something that is ≥ 0, also this square.
    pub(super) fn by_number(&self, seen: &Seen, square: Option<&Poly>, accept: &mut Accept<'_>) -> bool {
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
                    let Some(times) = below.div_exact(&over) else { continue };
                    let domain = without_premises(domain);
                    let sign = |value: Quotient, relation| Statement::Sign {
                        value,
                        relation,
                        domain: Rc::clone(&domain),
                    };
                    // From a strict premise follows a strict inequality, where its factor is positive.
                    let strict = *relation == Relation::Positive && *premise == Relation::Positive;
                    let by_factor = strict && is_positive(&factor);
                    let plain = if strict && factor.is_one() { Relation::NonNegative } else { *relation };
                    let relations = [(plain, None), (Relation::NonNegative, Some(&factor))];
                    for (relation, positive) in relations.into_iter().take(1 + usize::from(by_factor)) {
                        let positive = positive.map(|p| sign(p.clone().into(), Relation::Positive));
                        for c in self.multiples(seen, &quotient, relation == Relation::Positive) {
                            let numerator = &value.numerator - &(&product.scale(&c) * &times);
                            let rest = sign(Quotient { numerator, denominator: below.clone() }, relation);
                            let denominator =
                                (!over.is_one()).then(|| sign(over.clone().into(), Relation::Positive));
                            let others = denominator.into_iter().chain(positive.clone());
                            if accept([rest].into_iter().chain(others).listed()) {
                                return true;
                            }
                        }
                    }
                }
            }
        }
        false
    }
}

impl Sign<'_> {
    /// Numbers c > 0 with c·g ≤ f at all points: one in the middle of all such numbers, and the shortest.
    /// `strictly` where the value has to be positive also where g is 0.
    fn multiples(&self, seen: &Seen, g: &Quotient, strictly: bool) -> Vec<Rational> {
        let Some((low, high)) = self.interval(seen, g, strictly) else { return Vec::new() };
        // Away from both ends, if there is room; where there is little it may be an end.
        let width = &high - &low;
        let little = width < &high * &Rational::new(1, 50);
        let aside = if little { Rational::ZERO } else { &width * &Rational::new(1, 4) };
        let middle = simplest_within(&(&low + &aside), &(&high - &aside));
        let shortest = Some(simplest_within(&low, &high)).filter(|c| *c != middle);
        [middle].into_iter().chain(shortest).filter(Rational::is_positive).listed()
    }

    /// The ends of the interval of these numbers.
    fn interval(&self, seen: &Seen, g: &Quotient, strictly: bool) -> Option<(Rational, Rational)> {
        let g_values = values(&g.numerator, &g.denominator, &seen.points)?;
        // The largest lower and the least upper bound, with the points that say so.
        let mut bounds: [Option<(Rational, Vec<usize>)>; 2] = [None, None];
        for (k, pair) in seen.values.iter().zip(&g_values).enumerate() {
            let (Some(f), Some(g)) = pair else { continue };
            let sign = g.signum();
            if sign == 0 {
                if f.is_negative() || strictly && f.is_zero() {
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
            let any = &low.map_or(Rational::ZERO, |(low, _)| low).max(Rational::ZERO) + &Rational::ONE;
            return Some((any.clone(), any));
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
        (low <= high).then_some((low, high))
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
/// the ends of the ranges of other variables, and times their squares, where there are no ends those of the variables; these
/// without the powers, too; where its degree is lower than that of the numerator also variables that are ≥ 0, their sum, and
/// squares.
fn factors(numerator: &Poly, premise: &Poly, domain: &Domain) -> Vec<Poly> {
    let own = common(numerator, domain);
    let (mut all, mut apart) = (vec![own.clone()], Vec::new());
    let others = ranges(domain);
    let others = others.iter().filter(|(v, _)| numerator.depends_on(*v) && !premise.depends_on(*v));
    for (var, range) in others {
        let x = Poly::var(*var);
        let low = range.low.value().map(|end| &x - &Poly::constant(end.clone()));
        let high = range.high.value().map(|end| &Poly::constant(end.clone()) - &x);
        if low.is_none() && high.is_none() {
            all.push(&own * &x.pow(2));
            if !own.is_one() {
                apart.push(x.pow(2));
            }
        }
        for distance in [low, high].into_iter().flatten() {
            all.push(&own * &distance);
            all.push(&own * &distance.pow(2));
            if !own.is_one() {
                apart.extend([distance.pow(2), distance]);
            }
        }
    }
    all.append(&mut apart);
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
