//! Ranges that premises make narrower, and their ends apart from what lies beyond.
//!
//! Where g < 0 beyond a number, nothing is claimed there: what holds for the rest of the box is enough.

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::of_negative;
use std::rc::Rc;

use super::{Accept, Seen, Sign};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;

/// How often what lies between an irrational end and a rational one beyond it is halved.
const NARROWED: usize = 40;

/// How often a step outwards is doubled.
const DOUBLED: usize = 20;

fn half(a: &Rational, b: &Rational) -> Rational {
    &(a + b) * &Rational::new(1, 2)
}

impl Sign<'_> {
    /// The same on narrower ranges: premises in one variable with an irrational zero leave out what lies beyond it.
    pub(super) fn narrowed(&self) -> Option<Vec<Statement>> {
        let mut region = self.domain.region.clone();
        let mut all = Vec::new();
        for (g, _) in &self.domain.premises {
            let [x] = g.variables()[..] else { continue };
            let Some((_, range)) = region.ranges.iter_mut().find(|(v, _)| *v == x) else { continue };
            let Some((low, high)) = range.finite().map(|(a, b)| (a.clone(), b.clone())) else { continue };
            let value = |at: &Rational| g.at(x, at).as_constant().map_or(0, |c| c.signum());
            // From an end at which the premise fails towards the middle of what it leaves.
            for (end, upper) in [(&low, false), (&high, true)] {
                let other = if upper { &low } else { &high };
                if value(end) >= 0 {
                    continue;
                }
                let inner = (1..=8).map(|k| end + &(&(other - end) * &Rational::new(k, 8)));
                let Some(mut inner) = inner.into_iter().find(|at| value(at) > 0) else { continue };
                let mut outer = end.clone();
                for _ in 0..NARROWED {
                    let middle = half(&outer, &inner);
                    if value(&middle) < 0 { outer = middle } else { inner = middle }
                }
                let cut = if upper {
                    Range::closed(outer.clone(), high.clone())
                } else {
                    Range::closed(low.clone(), outer.clone())
                };
                let beyond = Domain::of(Region { ranges: vec![(x, cut)] });
                let value = Quotient::from(-g);
                all.push(Statement::Sign { value, relation: Relation::Positive, domain: Rc::new(beyond) });
                let end = End::Excluded(outer);
                if upper { range.high = end } else { range.low = end }
            }
        }
        if all.is_empty() {
            return None;
        }
        let domain = Rc::new(Domain { premises: Vec::new(), region, ..self.domain.clone() });
        all.push(Statement::Sign { value: self.value.clone(), relation: self.relation, domain });
        Some(all)
    }

    /// The same without ends of ranges at which a premise fails, as 0 ≤ p has where p·q ≥ 1; what is assumed stays.
    pub(super) fn opened(&self, depth: usize, accept: &mut Accept<'_>) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        if self.relation == Relation::NonNegative && self.value.denominator.as_constant().is_some() {
            return false;
        }
        let mut region = self.domain.region.clone();
        let mut all = Vec::new();
        for (x, range) in &mut region.ranges {
            for end in [&mut range.low, &mut range.high] {
                let End::Included(at) = end.clone() else { continue };
                let fails = |(g, premise): &(Poly, Relation)| {
                    let g = Some(g).filter(|g| g.depends_on(*x))?;
                    let (value, relation) = (Quotient::from(-&g.at(*x, &at)), of_negative(*premise));
                    Sign { value, relation, domain: self.domain }.if_seen()
                };
                if let Some(fails) = self.domain.premises.iter().find_map(fails) {
                    all.push(fails);
                    *end = End::Excluded(at);
                }
            }
        }
        self.on_narrower(region, &all, depth, accept)
    }

    /// A strict inequality at an end of the range of a variable that no premise has, and beyond it: a multiple of a premise which
    /// is 0 at that end is positive beyond.
    pub(super) fn end_apart(&self, depth: usize, accept: &mut Accept<'_>) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        if self.relation != Relation::Positive || self.value.denominator.as_constant().is_none() {
            return false;
        }
        let is_free = |x: Var| self.domain.premises.iter().all(|(g, _)| !g.depends_on(x));
        (0..self.domain.region.ranges.len()).any(|k| {
            let (x, range) = &self.domain.region.ranges[k];
            [(&range.low, false), (&range.high, true)].into_iter().any(|(end, upper)| {
                let (true, true, End::Included(at)) =
                    (is_free(*x), self.value.numerator.depends_on(*x), end.clone())
                else {
                    return false;
                };
                let mut beyond = self.domain.clone();
                let own = &mut beyond.region.ranges[k].1;
                if upper {
                    own.high = End::Excluded(at.clone());
                } else {
                    own.low = End::Excluded(at.clone());
                }
                let numerator = self.value.numerator.at(*x, &at);
                let here = Sign { value: Quotient { numerator, ..self.value.clone() }, ..*self };
                let there = Sign { value: self.value.clone(), domain: &beyond, ..*self };
                let seen = [&here, &there].map(|sign| Seen::new(&sign.value, sign.domain));
                let [Some(seen), Some(seen_beyond)] = seen else { return false };
                here.enough(&seen, depth, &mut |here| {
                    let mut both = |there: Vec<Statement>| accept([&here[..], &there].concat());
                    there.by_number(&seen_beyond, None, &mut both) || there.multiplied(depth, &mut both)
                })
            })
        })
    }

    /// The same with an end for a range that has none, as 0 ≤ x has where x² + y² ≤ 9; what is assumed stays.
    pub(super) fn bounded(&self, depth: usize, accept: &mut Accept<'_>) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        let mut region = self.domain.region.clone();
        let mut all = Vec::new();
        for k in 0..region.ranges.len() {
            let (x, range) = region.ranges[k].clone();
            for (end, upper) in [(&range.low, false), (&range.high, true)] {
                if end.value().is_some() {
                    continue;
                }
                let mut premises = self.domain.premises.iter();
                let found = premises.find_map(|(g, _)| Some((g, beyond(g, x, upper, &region)?)));
                let Some((g, (number, is_attained))) = found else { continue };
                let mut outside = region.clone();
                // Where the premise is 0 at the number itself, that belongs to what is left.
                let outer =
                    if is_attained { End::Excluded(number.clone()) } else { End::Included(number.clone()) };
                outside.ranges[k].1 = if upper {
                    Range { low: outer, high: End::Infinite }
                } else {
                    Range { low: End::Infinite, high: outer }
                };
                let domain = Domain { premises: Vec::new(), region: outside, ..self.domain.clone() };
                let value = Quotient::from(-g);
                // Where other variables are not next to 0 there may be no such end.
                if Seen::new(&value, &domain).is_none_or(|seen| seen.fails(Relation::Positive)) {
                    continue;
                }
                all.push(Statement::Sign { value, relation: Relation::Positive, domain: Rc::new(domain) });
                let own = &mut region.ranges[k].1;
                if upper { own.high = End::Included(number) } else { own.low = End::Included(number) }
            }
        }
        self.on_narrower(region, &all, depth, accept)
    }
}

/// A number beyond which a polynomial seems to be negative, and whether it is 0 there; all other variables are where they are
/// nearest to 0.
fn beyond(g: &Poly, x: Var, upper: bool, region: &Region) -> Option<(Rational, bool)> {
    if !g.depends_on(x) {
        return None;
    }
    let mut alone = g.clone();
    for (other, range) in region.ranges.iter().filter(|(other, _)| *other != x) {
        let value = if range.contains(&Rational::ZERO) {
            Rational::ZERO
        } else {
            let ends = [&range.low, &range.high].into_iter().filter_map(End::value);
            ends.min_by(|a, b| a.abs().cmp(&b.abs()))?.clone()
        };
        alone = alone.at(*other, &value);
    }
    let sign = |at: &Rational| alone.at(x, at).as_constant().map_or(0, |c| c.signum());
    let (_, range) = region.ranges.iter().find(|(own, _)| *own == x)?;
    let start =
        [&range.low, &range.high].into_iter().find_map(|end| end.value().cloned()).unwrap_or(Rational::ZERO);
    let step = |k: usize| {
        let length = Rational::from(1 << k);
        if upper { &start + &length } else { &start - &length }
    };
    // The last point at which it is not negative, and the first one of those beyond.
    let last = (0..DOUBLED).rev().find(|k| sign(&step(*k)) >= 0);
    let mut inner = last.map_or(start.clone(), step);
    let mut outer = step(last.map_or(0, |k| k + 1));
    if last == Some(DOUBLED - 1) || sign(&outer) >= 0 || sign(&inner) < 0 {
        return None;
    }
    for _ in 0..NARROWED {
        let middle = half(&inner, &outer);
        if sign(&middle) < 0 { outer = middle } else { inner = middle }
    }
    let (low, high) = if upper { (&inner, &outer) } else { (&outer, &inner) };
    let root = simplest_within(low, high);
    if sign(&root) == 0 {
        return Some((root, true));
    }
    // A short number somewhat farther out.
    let width = &(&outer - &start).abs() * &Rational::new(1, 64);
    let far = if upper { &outer + &width } else { &outer - &width };
    let (low, high) = if upper { (outer, far) } else { (far, outer) };
    Some((simplest_within(&low, &high), false))
}
