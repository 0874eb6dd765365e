//! Zeros, least and greatest values of functions of one variable that are negative somewhere.

mod parametric;

use core::cmp::Ordering;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::algebra::real::algebraic::{Algebraic, number};
use crate::algebra::real::field::Field;
use crate::algebra::real::reading::{in_square_roots, of_least_degree};
use crate::algebra::real::roots::isolate;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::{Kind, multiple_of_pi};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, candidates, typical};

/// The work for the extrema of a family.
const WORK: u64 = 20_000_000;

/// Where a function is zero and where it is least and greatest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extrema {
    /// The name of the function, such as `b[1]`.
    pub label: String,
    /// Its zeros on the domain, such as `t = 1/2`.
    pub zeros: Vec<String>,
    /// Its least value.
    pub minimum: Extremum,
    /// Its greatest value.
    pub maximum: Extremum,
}

/// A least or greatest value and where it is taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extremum {
    /// The value.
    pub value: String,
    /// The points, such as `t = 1/3`.
    pub at: Vec<String>,
}

/// The functions of one variable that are negative somewhere on the domain; an end that the domain leaves out counts, as a
/// limit. With shape parameters for all of their values, where zeros and extrema are quotients of polynomials in them,
/// or at values that are named. Of functions that contain π or exp(r) what is no value at an end of the domain is a
/// decimal. Nothing is said of functions that contain a variable beside its sine.
pub fn extrema(family: &Family) -> Vec<Extrema> {
    if family.interval().is_none() {
        return Vec::new();
    }
    let mut all = Vec::new();
    basis_prover::within(WORK, &mut || {
        let work = &mut Work::new(WORK);
        let (sample, numbers) = (sample(family), family.analytic.numbers());
        for (k, f) in family.functions.iter().enumerate() {
            let label = family.function_label(k);
            let found = match parametric::of_function(family, &f.value, work) {
                Some(found) => found.map(|found| Extrema { label, ..found }),
                // Without work for one function there is none for the others.
                None => match at_sample(family, (&label, &f.value), &sample, &numbers, work) {
                    Some(found) => found,
                    None => return,
                },
            };
            all.extend(found);
        }
    });
    all
}

/// Shape values that satisfy what is assumed, away from the ends of their ranges where that is possible.
fn sample(family: &Family) -> Vec<(Var, Rational)> {
    let pieces = family.pieces(&[], &[], true);
    let Some(piece) = pieces.first() else { return Vec::new() };
    let inside = |range: &Range| {
        let is_end = |x: &Rational| [&range.low, &range.high].iter().any(|end| end.value() == Some(x));
        candidates(range, 3).into_iter().find(|x| !is_end(x)).unwrap_or_else(|| typical(range))
    };
    let point = piece.ranges.mapped(|(var, range)| (*var, Coordinate::Rational(inside(range))));
    let rational = |(var, c): (Var, Coordinate)| match c {
        Coordinate::Rational(x) => Some((var, x)),
        Coordinate::Algebraic(_) => None,
    };
    piece.image(&point).into_iter().filter_map(rational).listed()
}

/// What is known of a function at some shape values; nothing inside if it is negative nowhere or contains other variables,
/// `None` when the work is spent.
#[expect(clippy::option_option, reason = "the work may be spent")]
fn at_sample(
    family: &Family,
    (label, f): (&str, &Fraction),
    sample: &[(Var, Rational)],
    numbers: &[Var],
    work: &mut Work,
) -> Option<Option<Extrema>> {
    let Some((var, low, high)) = family.interval() else { return Some(None) };
    // What the function does not contain may be anything.
    let shapes = sample.iter().filter(|(v, _)| !numbers.contains(v) && f.depends_on(*v)).listed();
    let known = sample.iter().filter(|(v, _)| numbers.contains(v)).listed();
    let put = |f: &Fraction, values: &[&(Var, Rational)]| {
        let put = |f: Fraction, (v, x): &&(Var, Rational)| f.substitute(*v, &Fraction::constant(x.clone()));
        values.iter().try_fold(f.clone(), put)
    };
    let part = |p: &Poly| Univariate::from_poly(p, var);
    let Some(exact) = put(f, &shapes) else { return Some(None) };
    let is_exact = !numbers.iter().any(|v| exact.depends_on(*v));
    let parts = put(&exact, &known).and_then(|f| Some((part(f.numer())?, part(f.denom())?)));
    let Some((numer, denom)) = parts else { return Some(None) };
    if [low, high].iter().any(|end| denom.sign_at(end) == 0) {
        return Some(None); // without a bound next to an end that the domain leaves out
    }
    let Some((zeros, least, greatest)) = of_function(&numer, &denom, low, high, work)? else {
        return Some(None);
    };
    let slope = exact.derivative_within(var, work)?;
    let angle = family.analytic.angle(var);
    let at_place = |f: &Fraction, x: &Rational| f.substitute(var, &Fraction::constant(x.clone()));
    // A place is exact where that is seen of it: the function or its derivative is 0 there, whatever the numbers are.
    let is_known = |x: &Coordinate| match x {
        Coordinate::Algebraic(_) => is_exact,
        Coordinate::Rational(x) => {
            let vanishes = |f: &Fraction| at_place(f, x).is_some_and(|value| value.is_zero());
            is_exact || x == low || x == high || vanishes(&exact) || vanishes(&slope)
        }
    };
    let place = |x: &Coordinate| {
        let name = &family.names[var.0];
        let itself = |x: &Rational| angle.and_then(|angle| at_place(&put(&angle.tangent(), &shapes)?, x));
        let own = if is_known(x) { text(x) } else { about(&approximation(x)) };
        let own = format!("{name} = {own}");
        let Some(angle) = angle else { return own };
        if angle.kind == Kind::Linear {
            return match x {
                Coordinate::Rational(rational) if is_known(x) => {
                    itself(rational).map(|f| super::written(family, &f))
                }
                _ if is_exact => None,
                _ => itself(&approximation(x)).and_then(|f| Some(about(&put(&f, &known)?.as_constant()?))),
            }
            .map_or(own, |value| format!("{} = {value}", angle.name));
        }
        let Coordinate::Rational(x) = x else { return own };
        let end = [low, high].into_iter().position(|end| end == x).map(|k| &angle.ends[k]);
        if let Some(end) = end.filter(|end| !end.is_empty()) {
            return format!("{} = {end}", angle.name);
        }
        // Where the tangent vanishes, its argument does.
        if at_place(&angle.tangent(), x).is_some_and(|x| x.is_zero()) {
            let shift = &angle.shift;
            let shown = if angle.turns { shift.to_string() } else { multiple_of_pi(shift) };
            return format!("{} = {shown}", angle.name);
        }
        own
    };
    let at = |points: &[Coordinate]| points.mapped(place);
    let extremum = |(value, points): (Coordinate, Vec<Coordinate>)| {
        let there = points.iter().filter(|x| is_known(x)).find_map(|x| match x {
            Coordinate::Rational(x) => at_place(&exact, x),
            Coordinate::Algebraic(_) => None,
        });
        let value = match there {
            _ if is_exact => text(&value),
            Some(value) => super::written(family, &value),
            None => about(&approximation(&value)),
        };
        Extremum { value, at: at(&points) }
    };
    let shown: Vec<String> = shapes.iter().map(|(v, x)| format!("{} = {x}", family.names[v.0])).listed();
    let label = if shown.is_empty() { label.to_owned() } else { format!("{label} at {}", shown.join(", ")) };
    Some(Some(Extrema { label, zeros: at(&zeros), minimum: extremum(least), maximum: extremum(greatest) }))
}

/// A value and the points at which it is taken.
type Taken = (Coordinate, Vec<Coordinate>);

/// Zeros, least and greatest value of numer/denom between two numbers; nothing inside if the function is negative nowhere,
/// `None` when the work is spent.
#[expect(clippy::option_option, reason = "the work may be spent")]
fn of_function(
    numer: &Univariate,
    denom: &Univariate,
    low: &Rational,
    high: &Rational,
    work: &mut Work,
) -> Option<Option<(Vec<Coordinate>, Taken, Taken)>> {
    let minus = Rational::from(-1);
    let slope = numer.derivative().mul(denom).add(&numer.mul(&denom.derivative()).scale(&minus));
    let mut points = vec![Coordinate::Rational(low.clone()), Coordinate::Rational(high.clone())];
    points.extend(roots(&slope, low, high, work)?);
    let mut values = Vec::new();
    for x in points {
        values.push((value(numer, denom, &x, work)?, x));
    }
    let extreme = |wanted: Ordering, work: &mut Work| -> Option<Taken> {
        let mut best: Option<Taken> = None;
        for (value, x) in &values {
            match &mut best {
                None => best = Some((value.clone(), vec![x.clone()])),
                Some((known, at)) => match compare(value, known, work)? {
                    Ordering::Equal => at.push(x.clone()),
                    order if order == wanted => best = Some((value.clone(), vec![x.clone()])),
                    _ => {}
                },
            }
        }
        let (value, mut at) = best?;
        sort(&mut at, work)?;
        Some((value, at))
    };
    let (least, greatest) = (extreme(Ordering::Less, work)?, extreme(Ordering::Greater, work)?);
    let zero = Coordinate::Rational(Rational::ZERO);
    if compare(&least.0, &zero, work)? != Ordering::Less {
        return Some(None);
    }
    let mut zeros = roots(numer, low, high, work)?;
    for end in [low, high] {
        if numer.sign_at(end) == 0 {
            zeros.push(Coordinate::Rational(end.clone()));
        }
    }
    sort(&mut zeros, work)?;
    Some(Some((zeros, least, greatest)))
}

/// The zeros of a polynomial strictly between two numbers; none of the polynomial 0.
fn roots(p: &Univariate, low: &Rational, high: &Rational, work: &mut Work) -> Option<Vec<Coordinate>> {
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
fn value(numer: &Univariate, denom: &Univariate, x: &Coordinate, work: &mut Work) -> Option<Coordinate> {
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
            Some(match field.number(&value, work)? {
                Ok(x) => Coordinate::Rational(x),
                Err(x) => match rational(&x, work)? {
                    Some(x) => Coordinate::Rational(x),
                    None => Coordinate::Algebraic(of_least_degree(&x, work)?),
                },
            })
        }
    }
}

/// The number, if it is rational after all.
#[expect(clippy::option_option, reason = "the work may be spent")]
fn rational(x: &Algebraic, work: &mut Work) -> Option<Option<Rational>> {
    let mut all = isolate(x.polynomial(), Some(x.low()), Some(x.high()), work)?;
    let Some(root) = all.first_mut() else { return Some(None) };
    root.detect_rational(x.polynomial(), work)?;
    Some(number(x.polynomial(), root)?.ok())
}

fn compare(a: &Coordinate, b: &Coordinate, work: &mut Work) -> Option<Ordering> {
    Some(match (a, b) {
        (Coordinate::Rational(a), Coordinate::Rational(b)) => a.cmp(b),
        (Coordinate::Algebraic(a), Coordinate::Rational(b)) => a.compare(b),
        (Coordinate::Rational(a), Coordinate::Algebraic(b)) => b.compare(a).reverse(),
        (Coordinate::Algebraic(a), Coordinate::Algebraic(b)) => a.compare_with(b, work)?,
    })
}

/// In increasing order, each number once.
fn sort(all: &mut Vec<Coordinate>, work: &mut Work) -> Option<()> {
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
fn text(x: &Coordinate) -> String {
    match x {
        Coordinate::Rational(x) => x.to_string(),
        Coordinate::Algebraic(x) => {
            in_square_roots(x).unwrap_or_else(|| format!("{} ({})", decimal(x), x.describe("x")))
        }
    }
}

/// A rational number next to another one.
fn approximation(x: &Coordinate) -> Rational {
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
fn about(x: &Rational) -> String {
    format!("about {}", digits(x))
}

/// Nine digits of a number.
fn decimal(x: &Algebraic) -> String {
    digits(&approximation(&Coordinate::Algebraic(x.clone())))
}

/// Nine digits behind the point, or of a small number nine digits.
fn digits(x: &Rational) -> String {
    let x = x.to_f64();
    if x == 0.0 || x.abs() >= 1e-3 { format!("{x:.9}") } else { format!("{x:.8e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A value, and where it is taken.
    type Text = (String, Vec<String>);

    fn of(coefficients: &[i64]) -> Option<(Vec<String>, Text, Text)> {
        let p = Univariate::integers(coefficients);
        let one = Univariate::integers(&[1]);
        let found = of_function(&p, &one, &Rational::ZERO, &Rational::ONE, &mut Work::unlimited());
        let (zeros, least, greatest) = found.expect("unlimited")?;
        let all = |points: &[Coordinate]| points.iter().map(text).listed();
        let taken = |(value, at): &Taken| (text(value), all(at));
        Some((all(&zeros), taken(&least), taken(&greatest)))
    }

    #[test]
    fn least_and_greatest_values() {
        let texts = |all: &[&str]| all.iter().map(ToString::to_string).listed();
        // t(2t − 1), of the quadratic Lagrange basis.
        let (zeros, least, greatest) = of(&[0, -1, 2]).expect("negative");
        assert_eq!(zeros, texts(&["0", "1/2"]));
        assert_eq!(least, (String::from("-1/8"), texts(&["1/4"])));
        assert_eq!(greatest, (String::from("1"), texts(&["1"])));
        // 6t² − 6t + 1, the shifted Legendre polynomial, zeros 1/2 ∓ √3/6; greatest at both ends.
        let (zeros, least, greatest) = of(&[1, -6, 6]).expect("negative");
        assert_eq!(zeros, texts(&["1/2 - 1/6*sqrt(3)", "1/2 + 1/6*sqrt(3)"]));
        assert_eq!(least, (String::from("-1/2"), texts(&["1/2"])));
        assert_eq!(greatest, (String::from("1"), texts(&["0", "1"])));
        // 20t³ − 30t² + 12t − 1: extrema at 1/2 ∓ √5/10 with the values ±1/√5; least at t = 0.
        let (_, least, _) = of(&[-1, 12, -30, 20]).expect("negative");
        assert_eq!(least, (String::from("-1"), texts(&["0"])));
        // t³ − 2t: least at √(2/3), where it is −(4/3)√(2/3).
        let (_, least, _) = of(&[0, -2, 0, 1]).expect("negative");
        assert_eq!(least, (String::from("-4/9*sqrt(6)"), texts(&["1/3*sqrt(6)"])));
        // t⁵ + t − 1 has no zero with roots of squares.
        let (zeros, ..) = of(&[-1, 1, 0, 0, 0, 1]).expect("negative");
        assert!(zeros[0].starts_with("0.754877666 (root of "), "{}", zeros[0]);
        // Nonnegative functions have no entry, nor has 0.
        assert_eq!(of(&[0, 1]), None);
        assert_eq!(of(&[]), None);
    }
}
