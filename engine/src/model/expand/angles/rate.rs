//! The rate of an angle: the number v of x = tan(v·s), chosen so that the tangent is finite on the range, and rational at
//! its ends.

use super::declared::Declared;
use super::edges::{Edge, edge};
use super::limits::{Bound, Tangent, psi, stays_finite};
use super::survey::Use;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::angle::{Kind, multiple_of_pi};
use crate::model::scope::Scope;
use basis_prover::collections::list::{Listed, Mapped};

/// x = tan(factor·(s − shift)), and what takes the place of ends whose tangents are irrational.
pub(super) struct Rate {
    pub(super) factor: Rational,
    pub(super) shift: Rational,
    pub(super) edges: [Option<Edge>; 2],
    /// Whether tangents at ends are made of tan(π/n).
    pub(super) by_root: bool,
}

impl Rate {
    /// Of an angle that is measured from 0.
    pub(super) fn of(rate: Rational) -> Self {
        Self::from(rate, Rational::ZERO)
    }

    fn from(rate: Rational, shift: Rational) -> Self {
        Self { factor: rate, shift, edges: [None, None], by_root: false }
    }
}

/// Half of the unit, and parts of that.
fn candidates(unit: &Rational) -> Vec<Rational> {
    (1..=8).map(|m| unit * &Rational::new(1, 2 * m)).listed()
}

impl Declared<'_> {
    /// The rate of an angle; `None`, with an error, if there is none.
    pub(super) fn rate(&self, scope: &Scope<'_>) -> Option<Rate> {
        if self.is_parametric() {
            return Some(Rate::of(self.rate_of_parameters(scope)?));
        }
        self.has_proper_ends(scope)?;
        let (is_domain, has_roots) = (self.at.is_domain, !scope.analytic.roots.is_empty());
        let found = without_parameters(self.of, &self.ends, is_domain)
            .filter(|rate| !rate.by_root || has_roots)
            .or_else(|| self.rate_with_edges());
        if found.is_some() {
            return found;
        }
        let texts: Vec<&str> = self.ends.mapped(|l| l.text.as_str());
        let (name, ends) = (self.name(), texts.join(" and "));
        let message =
            format!("the functions of `{name}` have irrational values at the ends {ends} of its range");
        let help = if self.at.is_domain {
            "choose ends at which the smallest angle is a multiple of pi/3, pi/4, pi/5 or another small part of `pi`; a shape parameter may also be the end of the domain, `shape 0 < α <= pi/2; domain 0 <= t <= α;`"
        } else {
            "let the range begin at 0, or make it smaller: between its ends there may be no other zero of the polynomial that vanishes at an end, and ends such as pi/6, pi/4 or pi/3 leave more room than pi/8"
        };
        self.wrong(scope, message, help)
    }

    /// `None`, with an error, where an end of an angle is no multiple of π that it can have.
    fn has_proper_ends(&self, scope: &Scope<'_>) -> Option<()> {
        if !self.is_circular() || self.of.turns {
            return Some(());
        }
        let is_domain = self.at.is_domain;
        let is_proper = |l: &&Bound| match (l.value.number.is_zero(), l.value.pi.is_zero()) {
            (true, _) => {
                // With a value of a shape parameter it may be any multiple.
                let any = !is_domain || !scope.anew.given.is_empty();
                l.value.pi.abs() <= Rational::ONE && (any || (&l.value.pi + &l.value.pi).is_integer())
            }
            (false, true) => !is_domain && l.value.number.abs() < pi_bounds().0,
            (false, false) => false,
        };
        let Some(end) = self.ends.iter().find(|l| !is_proper(l)) else { return Some(()) };
        let (what, help) = if is_domain {
            (
                "pi/2 between -pi and pi",
                if end.value.number.is_zero() && end.value.pi.abs() > Rational::ONE {
                    "ends of an angle are multiples of `pi/2` from `-pi` to `pi`; let a part of it be the variable, `sin(2*s)` with `0 <= s <= pi`"
                } else if end.value.number.is_zero() {
                    "ends of an angle are multiples of `pi/2` from `-pi` to `pi`, or a shape parameter, `shape 0 < α < pi; domain 0 <= θ <= α;`; a part of the angle can be the variable, `tan(pi*s/4)` with `0 <= s <= 1`"
                } else {
                    "ends of an angle are multiples of `pi/2` from `-pi` to `pi`, or a shape parameter: `shape 0 < α < pi; domain 0 <= θ <= α;`"
                },
            )
        } else {
            (
                "pi up to pi, nor a number below it",
                "ends of an angle are numbers from -3.14 to 3.14, and rational multiples of `pi` up to `pi`: `shape 0 < α < pi;`",
            )
        };
        let message =
            format!("the end {} of the angle `{}` is not a multiple of {what}", end.text, self.name());
        self.wrong(scope, message, help)
    }

    /// The largest rate of a shape parameter with which the tangent is finite, with edges at irrational ends.
    fn rate_with_edges(&self) -> Option<Rate> {
        if !self.is_circular() || self.at.is_domain || self.of.turns {
            return None;
        }
        candidates(&self.of.unit).into_iter().find_map(|rate| {
            let edges = irrational_ends(self.at.slot, &rate, &self.ends)?;
            Some(Rate { edges, ..Rate::of(rate) })
        })
    }

    /// The rate of a domain variable between shape parameters, whose rates have been found: a multiple of theirs.
    fn rate_of_parameters(&self, scope: &Scope<'_>) -> Option<Rational> {
        let (of, name) = (self.of, self.name());
        let mut rates: Vec<(Rational, Rational)> = Vec::new();
        for (var, factor, _) in self.ends.iter().flat_map(|l| &l.value.parts) {
            let shape = self.all.get(var.0.checked_sub(self.count)?)?;
            shape.as_ref()?;
            let angle = scope.analytic.angles.iter().find(|a| a.itself == *var)?;
            rates.push((angle.rate.clone(), factor.abs()));
        }
        // The least common multiple of those that the ends ask for.
        let mut least: Option<Rational> = None;
        for (rate, factor) in &rates {
            let wanted = rate.checked_div(factor)?;
            least = Some(match &least {
                Some(known) => (known * &wanted).checked_div(&known.gcd(&wanted))?,
                None => wanted,
            });
        }
        let least = least?;
        let is_multiple = |rate: &Rational| {
            let multiple = |(own, factor): &(Rational, Rational)| (rate * factor).checked_div(own);
            !of.turns && rates.iter().all(|known| multiple(known).is_some_and(|n| n.is_integer()))
        };
        let is_finite =
            |rate: &Rational, l: &Bound| !self.is_circular() || stays_finite(scope, rate, l, self.known);
        // Where the variable is used with larger factors than the parameter, its rate is larger, too, if its tangent is
        // finite then.
        let half = Rational::new(1, 2);
        let own = (&of.unit * &half).checked_div(&least)?;
        let rate = match own.to_i64() {
            Some(n) if n > 1 && !of.beside => {
                let rate = &least * &own;
                let finite = self.ends.iter().all(|l| is_finite(&rate, l));
                if is_multiple(&rate) && finite { rate } else { least }
            }
            _ => least,
        };
        if !is_multiple(&rate) {
            let message = format!("the ends of the domain of `{name}` are not multiples of one angle");
            let help = "write `domain 0 <= t <= α;` or `domain -α <= t <= α;`";
            return self.wrong(scope, message, help);
        }
        // Beyond a quarter turn the tangent is another one.
        if let Some(end) = self.ends.iter().find(|l| !is_finite(&rate, l)) {
            let reach = multiple_of_pi(&half.checked_div(&rate)?);
            let message = format!("the end {} of the angle `{name}` can be {reach} or more", end.text);
            let help =
                "make one shape parameter the whole angle, `domain 0 <= t <= α;`, or narrow the ranges";
            return self.wrong(scope, message, help);
        }
        Some(rate)
    }
}

/// The rate of an angle whose range ends in numbers or multiples of π.
pub(super) fn without_parameters(of: &Use, ends: &[&Bound], is_domain: bool) -> Option<Rate> {
    if ends.iter().any(|end| !end.value.parts.is_empty()) {
        return None;
    }
    with_rational_ends(of, ends, is_domain).or_else(|| match (of.kind, of.turns, is_domain) {
        (Kind::Circular, false, false) => Some(Rate::of(between_numbers(&of.unit, ends)?)),
        (Kind::Circular, _, true) => with_a_root(of, ends),
        _ => None,
    })
}

/// The largest rate with which the tangent is finite, and rational at the ends.
fn with_rational_ends(of: &Use, ends: &[&Bound], is_domain: bool) -> Option<Rate> {
    let circular = of.kind == Kind::Circular;
    let half = Rational::new(1, 2);
    let shifts = if circular && is_domain { shifts(&of.unit, of.turns, ends) } else { vec![Rational::ZERO] };
    for rate in candidates(&of.unit) {
        for shift in &shifts {
            let is_finite = |l: &&Bound| {
                let psi = psi(&rate, of.turns, shift, l).abs();
                psi < half || psi == half && !l.included && !is_domain && !of.beside
            };
            let is_irrational = |l: &&Bound| {
                matches!(Tangent::of(of.kind, &rate, of.turns, shift, &l.value), Tangent::Irrational)
            };
            if !circular || ends.iter().all(is_finite) && !ends.iter().any(is_irrational) {
                return Some(Rate::from(rate, shift.clone()));
            }
        }
    }
    None
}

/// The largest rate of a domain variable with which the tangent is finite, where it is irrational at an end.
fn with_a_root(of: &Use, ends: &[&Bound]) -> Option<Rate> {
    let is_part = |l: &&Bound| (if of.turns { &l.value.pi } else { &l.value.number }).is_zero();
    let half = Rational::new(1, 2);
    let is_finite =
        |rate: &Rational| ends.iter().all(|l| psi(rate, of.turns, &Rational::ZERO, l).abs() < half);
    let rate = candidates(&of.unit).into_iter().find(is_finite).filter(|_| ends.iter().all(is_part))?;
    Some(Rate { by_root: true, ..Rate::of(rate) })
}

/// Of an angle whose range ends in numbers the largest rate with which the tangent is finite at the ends, and rational at
/// those that are multiples of π; `None` of any other angle.
pub(super) fn between_numbers(unit: &Rational, ends: &[&Bound]) -> Option<Rational> {
    if ends.iter().all(|l| l.value.number.is_zero()) {
        return None;
    }
    let (pi, _) = pi_bounds();
    let fits = |rate: &Rational, l: &Bound| match (l.value.number.is_zero(), l.value.pi.is_zero()) {
        (true, _) => {
            let tangent = Tangent::of(Kind::Circular, rate, false, &Rational::ZERO, &l.value);
            matches!(tangent, Tangent::Exact(_))
        }
        (false, pi_is_zero) => pi_is_zero && &(&l.value.number.abs() * rate) * &Rational::from(2) < *pi,
    };
    candidates(unit).into_iter().find(|rate| ends.iter().all(|l| fits(rate, l)))
}

/// Angles in the domain from which others can be measured: sin and cos of all multiples of them are 0, 1 or −1. First 0.
fn shifts(unit: &Rational, turns: bool, ends: &[&Bound]) -> Vec<Rational> {
    const MOST: i64 = 32;
    let mut all = vec![Rational::ZERO];
    let value = |l: &Bound| if turns { l.value.number.clone() } else { l.value.pi.clone() };
    let ([low, high], Some(step)) = (ends, (unit + unit).recip()) else { return all };
    let first = value(low).checked_div(&step).map_or(Rational::ZERO, |n| -(-n).floor());
    for k in 0..MOST {
        let shift = &(&first + &Rational::from(k)) * &step;
        if shift <= value(high) && !shift.is_zero() {
            all.push(shift);
        }
    }
    all
}

/// What takes the place of ends whose tangents are irrational; `None` where a tangent is infinite, or the conditions are
/// not.
fn irrational_ends(var: Var, rate: &Rational, ends: &[&Bound]) -> Option<[Option<Edge>; 2]> {
    let [low, high] = ends else { return None };
    let psi = [low, high].map(|l| psi(rate, false, &Rational::ZERO, l));
    let is_finite = |psi: &Rational| psi.abs() < Rational::new(1, 2);
    let mut edges = [None, None];
    for side in 0..2 {
        if !is_finite(&psi[side]) || !is_finite(&psi[1 - side]) {
            return None;
        }
        if !(&psi[side] * &Rational::from(4)).is_integer() {
            edges[side] = Some(edge(var, &psi[side], &psi[1 - side])?);
        }
    }
    Some(edges)
}
