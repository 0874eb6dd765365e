//! The numbers tan(π/n) of which tangents of rational parts of a turn are made that are irrational: at ends of a
//! domain, at values that `at` gives to an angle, and of numbers such as sin(π/4).
//!
//! tan(kπ/n) is a quotient of polynomials in x = tan(π/n), from (1 + ix)ᵏ. The number itself is a zero of its minimal
//! polynomial, which is found as a divisor of Im (1 + ix)ⁿ.
//!
//! **Theorem** (I. Niven, "Irrational numbers", 1956, chapter 3). For even n > 4 the degree of tan(π/n) is φ(n), or φ(n)/2 if 4
//! divides n.
//!
//! A polynomial of this degree that vanishes there is therefore irreducible, and one of a smaller degree that vanishes there
//! is 0.

use std::cell::RefCell;

use super::edges::primitive;
use super::limits::{Bound, Limits};
use super::numbers::{rounded, tangent_bounds};
use super::rate::{self, Rate};
use super::survey::{Use, Uses};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::univariate::Univariate;
use crate::model::angle::Kind;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::formula::phase::Linear;
use crate::model::roots::{Root, reduced};
use crate::model::scope::Scope;
use basis_prover::collections::list::Listed;
use basis_prover::collections::map::SortedMap;

/// The largest n, and the highest degree of tan(π/n).
const MAX_PARTS: i64 = 60;
const MAX_DEGREE: i64 = 8;

/// The numbers tan(π/n) of which the tangents at the ends of a domain are made, and all others of a family.
pub(super) fn roots(
    scope: &mut Scope<'_>,
    uses: &Uses,
    all: &[Option<Use>],
    limits: &[Limits],
    shapes: usize,
) {
    // ψ/π wherever tan ψ is needed. With a value of a shape parameter the family is expanded anew.
    let (mut at_ends, mut turns) = (Vec::new(), uses.turns.clone());
    for (k, of) in all.iter().enumerate().skip(shapes) {
        let Some(of) = of.as_ref().filter(|of| of.kind == Kind::Circular) else { continue };
        let ends: Vec<&Bound> = limits[k].iter().flatten().listed();
        let Rate { factor, shift, .. } = match rate::without_parameters(of, &ends, true) {
            Some(rate) => rate,
            // Of a domain that ends at parameters: in most families half of the angle.
            None => Rate::of(&of.unit * &Rational::new(1, 2)),
        };
        let psi = |value: &Linear| {
            let (own, other) = if of.turns { (&value.number, &value.pi) } else { (&value.pi, &value.number) };
            other.is_zero().then(|| &(own - &shift) * &factor)
        };
        if ends.iter().all(|end| end.value.parts.is_empty()) {
            at_ends.extend(ends.iter().filter_map(|end| psi(&end.value)));
        }
        turns.extend(uses.places.iter().filter(|(var, _)| var.0 == k).filter_map(|(_, value)| psi(value)));
    }
    let of_ends = with_all(None, &at_ends);
    let of_all = with_all(of_ends, &turns);
    let (Some(finest), mut roots) = (of_all, Vec::new()) else { return };
    for parts in of_ends.into_iter().filter(|n| *n != finest).chain([finest]) {
        let var = Var(scope.names.len());
        let Some(number) = number(var, parts) else { return };
        scope.names.push(format!("tan(pi/{parts})"));
        roots.push(Root { var, parts, number, finer: None });
    }
    if let [of_ends, finest] = &mut roots[..] {
        let x = Poly::var(finest.var);
        // (1 + ix)ᵏ
        let (mut re, mut im) = (Poly::one(), Poly::zero());
        for _ in 0..finest.parts / of_ends.parts {
            (re, im) = (&re - &(&im * &x), &im + &(&re * &x));
        }
        let value = Fraction::new(im, re).map(|f| reduced(core::slice::from_ref(finest), f));
        of_ends.finer = value.and_then(|f| f.as_poly().cloned());
    }
    scope.budget.set_roots(&roots);
    scope.analytic.roots = roots;
}

/// The least n of which all of these are multiples of 1/n, after another one, as far as that is not too large; what
/// does not fit is refused where it is written.
fn with_all(before: Option<i64>, turns: &[Rational]) -> Option<i64> {
    turns.iter().filter(|psi| !(*psi * &Rational::from(4)).is_integer()).fold(before, |parts, psi| {
        let unit = parts.map_or_else(|| Rational::new(1, 2), |n| Rational::new(1, n)).gcd(psi);
        unit.denom().to_i64().filter(|n| *n <= MAX_PARTS && degree(*n) <= MAX_DEGREE).or(parts)
    })
}

/// tan(π/n), n > 4 even.
fn number(var: Var, parts: i64) -> Option<Algebraic> {
    let part = Rational::new(1, parts);
    let minimal = primitive(var, &part).filter(|p| i64::from(p.degree(var)) == degree(parts))?;
    // It is the least positive zero.
    let (low, high) = bounds(parts)?;
    Algebraic::new(&Univariate::from_poly(&minimal, var)?, low, high)
}

/// Numbers below and above tan(π/n), which are found once: a spec may have thousands of families with the same angle.
fn bounds(parts: i64) -> Option<(Rational, Rational)> {
    thread_local! {
        static KNOWN: RefCell<SortedMap<i64, (Rational, Rational)>> = const { RefCell::new(SortedMap::new()) };
    }
    if let Some(known) = KNOWN.with_borrow(|all| all.get(&parts).cloned()) {
        return Some(known);
    }
    let part = Rational::new(1, parts);
    let (low, high) = pi_bounds();
    let (low, _) = tangent_bounds(&rounded(&(low * &part), false))?;
    let (_, high) = tangent_bounds(&rounded(&(high * &part), true))?;
    KNOWN.with_borrow_mut(|all| all.insert(parts, (low.clone(), high.clone())));
    Some((low, high))
}

/// The degree of tan(π/n) for an even n > 4.
fn degree(parts: i64) -> i64 {
    let coprime =
        (1..parts).filter(|k| Rational::new(*k, parts).denom() == Rational::from(parts)).count() as i64;
    if parts % 4 == 0 { coprime / 2 } else { coprime }
}
