//! Exact numbers of extrema: roots, values, comparisons, and how they are written.

use core::cmp::Ordering;

use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::{Algebraic, number};
use crate::algebra::real::field::{Element, Field};
use crate::algebra::real::reading::{in_square_roots, of_least_degree};
use crate::algebra::real::roots::isolate;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::decimals;
use basis_prover::Coordinate;

/// The zeros of a polynomial strictly between two numbers; none of the polynomial 0.
pub(super) fn roots(
    p: &Univariate,
    low: &Rational,
    high: &Rational,
    work: &mut Work,
) -> Option<Vec<Coordinate>> {
    if p.is_constant() {
        return Some(Vec::new());
    }
    let p = p.square_free_part(work)?;
    let mut all = Vec::new();
    for mut root in isolate(&p, Some(low), Some(high), work)? {
        root.detect_rational(&p, work)?;
        all.push(match number(&p, &root)? {
            Ok(x) => Coordinate::Rational(x),
            Err(x) => Coordinate::Algebraic(of_least_degree(&x.tidy(work)?, work)?),
        });
    }
    Some(all)
}

/// The value of numer/denom at a number.
pub(super) fn value(
    numer: &Univariate,
    denom: &Univariate,
    x: &Coordinate,
    work: &mut Work,
) -> Option<Coordinate> {
    match x {
        Coordinate::Rational(x) => {
            let at =
                |p: &Univariate| p.coefficients().iter().rev().fold(Rational::ZERO, |sum, c| &(&sum * x) + c);
            Some(Coordinate::Rational(at(numer).checked_div(&at(denom))?))
        }
        Coordinate::Algebraic(x) => {
            let mut field = Field::new(x.clone());
            let below = field.reduce(denom, work)?;
            let inverse = field.inverse(&below, work)?;
            let above = field.reduce(numer, work)?;
            let value = field.mul(&above, &inverse, work)?;
            let value = field.reduce(&value, work)?;
            in_field(&field, &value, work)
        }
    }
}

/// An element of a field as a number of its own.
pub(super) fn in_field(field: &Field, element: &Element, work: &mut Work) -> Option<Coordinate> {
    Some(match field.number(element, work)? {
        Ok(x) => Coordinate::Rational(x),
        Err(x) => match rational(&x, work)? {
            Some(x) => Coordinate::Rational(x),
            None => Coordinate::Algebraic(of_least_degree(&x, work)?),
        },
    })
}

/// The number, if it is rational after all.
#[expect(clippy::option_option, reason = "the work may be spent")]
fn rational(x: &Algebraic, work: &mut Work) -> Option<Option<Rational>> {
    let mut all = isolate(x.polynomial(), Some(x.low()), Some(x.high()), work)?;
    let Some(root) = all.first_mut() else { return Some(None) };
    root.detect_rational(x.polynomial(), work)?;
    Some(number(x.polynomial(), root)?.ok())
}

pub(super) fn compare(a: &Coordinate, b: &Coordinate, work: &mut Work) -> Option<Ordering> {
    Some(match (a, b) {
        (Coordinate::Rational(a), Coordinate::Rational(b)) => a.cmp(b),
        (Coordinate::Algebraic(a), Coordinate::Rational(b)) => a.compare(b),
        (Coordinate::Rational(a), Coordinate::Algebraic(b)) => b.compare(a).reverse(),
        (Coordinate::Algebraic(a), Coordinate::Algebraic(b)) => a.compare_with(b, work)?,
    })
}

/// In increasing order, each number once.
pub(super) fn sort(all: &mut Vec<Coordinate>, work: &mut Work) -> Option<()> {
    let mut sorted: Vec<Coordinate> = Vec::new();
    for x in all.drain(..) {
        let mut place = sorted.len();
        while place > 0 && compare(&x, &sorted[place - 1], work)? == Ordering::Less {
            place -= 1;
        }
        if place == 0 || compare(&x, &sorted[place - 1], work)? != Ordering::Equal {
            sorted.insert(place, x);
        }
    }
    *all = sorted;
    Some(())
}

/// A number for reading: a fraction, `1/2 - 1/6*sqrt(3)`, or a decimal with the polynomial of which it is a root.
pub(super) fn text(x: &Coordinate) -> String {
    match x {
        Coordinate::Rational(x) => x.to_string(),
        Coordinate::Algebraic(x) => {
            in_square_roots(x).unwrap_or_else(|| format!("{} ({})", decimal(x), x.describe("x")))
        }
    }
}

/// A rational number next to another one.
pub(super) fn approximation(x: &Coordinate) -> Rational {
    match x {
        Coordinate::Rational(x) => x.clone(),
        Coordinate::Algebraic(x) => {
            let mut x = x.clone();
            for _ in 0..60 {
                x.refine();
            }
            x.low().clone()
        }
    }
}

/// The decimal of a number that is computed with approximations.
pub(super) fn about(x: &Rational) -> String {
    format!("about {}", decimals::readable(x, 9, 8))
}

/// Nine digits of a number.
fn decimal(x: &Algebraic) -> String {
    decimals::readable(&approximation(&Coordinate::Algebraic(x.clone())), 9, 8)
}

/// A fraction with a power of ten below the line as a decimal.
pub(super) fn short(x: &Rational) -> String {
    let million = Rational::from(1_000_000);
    let scaled = x * &million;
    if x.is_integer() || !scaled.is_integer() {
        return x.to_string();
    }
    let digits = format!("{:0>7}", scaled.abs().to_string());
    let (whole, part) = digits.split_at(digits.len() - 6);
    format!("{}{whole}.{}", if x.is_negative() { "-" } else { "" }, part.trim_end_matches('0'))
}
