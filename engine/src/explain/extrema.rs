//! Zeros, least and greatest values of functions that are negative somewhere.

mod beside;
mod bounds;
mod domain;
mod interval;
mod level;
mod multiples;
mod numbers;
mod parametric;
mod point;
mod several;
mod stationary;
mod system;

use core::cmp::Ordering;

use self::numbers::{about, approximation, compare, roots, sort, text, value};
use super::shape_values;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::{Kind, multiple_of_pi};
use basis_prover::Coordinate;
use basis_prover::collections::list::{Listed, Mapped};

/// The work for the extrema of a family, and of one function of several variables.
const WORK: u64 = 20_000_000;
const OF_SEVERAL: u64 = 1_000_000;
/// What looking at the points of a lattice takes.
const SEARCH: u64 = 20_000;

/// Where a function is zero and where it is least and greatest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extrema {
    /// The name of the function, such as `b[1]`.
    pub label: String,
    /// Its zeros on the domain, such as `t = 1/2` or `(u, v, w) = (0, 0, 1)`; those that are on no line or curve of
    /// zeros.
    pub zeros: Vec<String>,
    /// Lines, curves and so on at whose points it is zero.
    pub zeros_on: Vec<Locus>,
    /// Whether it may have other zeros.
    pub zeros_are_open: bool,
    /// Its least value.
    pub minimum: Extremum,
    /// Its greatest value.
    pub maximum: Extremum,
    /// Whether the extreme values may be taken at other points, too.
    pub is_open: bool,
    /// Whether the values are proved bounds: the exact ones are out of reach.
    pub are_bounds: bool,
}

impl Extrema {
    /// Of a function without zeros.
    fn new(label: &str, minimum: Extremum, maximum: Extremum) -> Self {
        Self {
            label: label.to_owned(),
            zeros: Vec::new(),
            zeros_on: Vec::new(),
            zeros_are_open: false,
            minimum,
            maximum,
            is_open: false,
            are_bounds: false,
        }
    }
}

/// A least or greatest value and where it is taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extremum {
    /// The value, or `between -1/8 and -0.12`.
    pub value: String,
    /// The points, such as `t = 1/3`.
    pub at: Vec<String>,
    /// Lines, curves and so on at all of whose points it is taken.
    pub on: Vec<Locus>,
}

/// The points of a domain of several dimensions that satisfy an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Locus {
    /// What they are.
    pub kind: LocusKind,
    /// The equation, such as `2*u + v = 1`; nothing for the whole domain.
    pub equation: String,
}

/// What the points are that satisfy an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LocusKind {
    /// A part of a line.
    Line,
    /// A curve.
    Curve,
    /// A part of a plane.
    Plane,
    /// A surface.
    Surface,
    /// All points.
    Domain,
}

impl LocusKind {
    /// What has this dimension.
    const fn new(dimension: usize, is_flat: bool) -> Self {
        match (dimension, is_flat) {
            (0 | 1, true) => Self::Line,
            (0 | 1, false) => Self::Curve,
            (_, true) => Self::Plane,
            (_, false) => Self::Surface,
        }
    }

    /// The word for it, such as `line`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Curve => "curve",
            Self::Plane => "plane",
            Self::Surface => "surface",
            Self::Domain => "domain",
        }
    }
}

/// What is known of the functions of a family that are negative somewhere.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AllExtrema {
    /// Their zeros and extrema.
    pub known: Vec<Extrema>,
    /// Of which functions nothing is said, each with why, such as `it contains a number that is not rational`.
    pub open: Vec<(String, String)>,
}

/// What is known of a function.
enum Found {
    /// It is negative nowhere.
    Nonnegative,
    Known(Box<Extrema>),
    /// Nothing, and why.
    Open(String),
}

/// What is said where the work is spent.
const SPENT: &str = "too much work";

/// The functions that are negative somewhere on the domain; an end that the domain leaves out counts, as a limit.
/// With shape parameters for all of their values, where zeros and extrema are quotients of polynomials in them, or at
/// values that are named. Of functions of one variable that contain π or exp(r) what is no value at an end of the
/// domain is a decimal. Of functions of several variables exact values if they are within reach, else proved bounds.
pub fn extrema(family: &Family) -> AllExtrema {
    let mut all = AllExtrema::default();
    basis_prover::within(WORK, &mut || {
        let work = &mut Work::new(WORK);
        let (sample, numbers) = (shape_values::simple(family), family.analytic.numbers());
        for (k, f) in family.functions.iter().enumerate() {
            let label = family.function_label(k);
            let found = match parametric::of_function(family, &f.value, work) {
                Some(Some(found)) => Some(Found::Known(Box::new(Extrema { label: label.clone(), ..found }))),
                Some(None) => Some(Found::Nonnegative),
                None => {
                    let mut at = |sample: &[(Var, Rational)]| {
                        at_values(family, (&label, &f.value), sample, &numbers, work)
                    };
                    let found = at(&sample);
                    // Perhaps it is negative at other values.
                    let elsewhere = match &found {
                        Some(Found::Nonnegative) if !own_shapes(&f.value, &sample, &numbers).is_empty() => {
                            shape_values::where_negative(family, k)
                        }
                        _ => None,
                    };
                    elsewhere.map_or(found, |values| at(&values))
                }
            };
            match found.unwrap_or_else(|| Found::Open(String::from(SPENT))) {
                Found::Nonnegative => {}
                Found::Known(found) => all.known.push(*found),
                Found::Open(why) => all.open.push((label, why)),
            }
        }
    });
    all
}

/// What is known of a function at some shape values; `None` when the work is spent.
fn at_values(
    family: &Family,
    (label, f): (&str, &Fraction),
    values: &[(Var, Rational)],
    numbers: &[Var],
    work: &mut Work,
) -> Option<Found> {
    if family.interval().is_some() {
        return at_sample(family, (label, f), values, numbers, work);
    }
    let (exact, label) = with_values(family, (label, f), values, numbers);
    of_several(family, &label, &exact?, work)
}

/// What is known of a function of several variables; `None` when the work for all of them is spent.
fn of_several(family: &Family, label: &str, f: &Fraction, work: &mut Work) -> Option<Found> {
    work.spend(SEARCH)?;
    let units = OF_SEVERAL.min(work.left());
    let mut own = Work::new(units);
    let found = several::of_function(family, label, f, &mut own);
    work.spend(units - own.left())?;
    Some(found)
}

/// A function at the values of the shape parameters that it contains, and its name with these.
fn with_values(
    family: &Family,
    (label, f): (&str, &Fraction),
    sample: &[(Var, Rational)],
    numbers: &[Var],
) -> (Option<Fraction>, String) {
    let shapes = own_shapes(f, sample, numbers);
    let shown = shapes.iter().map(|(v, x)| format!("{} = {x}", family.names[v.0])).listed();
    let label = if shown.is_empty() { label.to_owned() } else { format!("{label} at {}", shown.join(", ")) };
    (put(f, &shapes), label)
}

/// The values of the shape parameters that a function contains; what it does not contain may be anything.
fn own_shapes(f: &Fraction, sample: &[(Var, Rational)], numbers: &[Var]) -> Vec<(Var, Rational)> {
    sample.iter().filter(|(v, _)| !numbers.contains(v) && f.depends_on(*v)).cloned().listed()
}

/// A function with numbers in place of variables; `None` where it has no value there.
fn put(f: &Fraction, values: &[(Var, Rational)]) -> Option<Fraction> {
    let put = |f: Fraction, (v, x): &(Var, Rational)| f.substitute(*v, &Fraction::constant(x.clone()));
    values.iter().try_fold(f.clone(), put)
}

/// What is known of a function of one variable at some shape values; `None` when the work is spent.
fn at_sample(
    family: &Family,
    (label, f): (&str, &Fraction),
    sample: &[(Var, Rational)],
    numbers: &[Var],
    work: &mut Work,
) -> Option<Found> {
    let (var, low, high) = family.interval()?;
    let open = |why: &str| Some(Found::Open(String::from(why)));
    let shapes = own_shapes(f, sample, numbers);
    let known = sample.iter().filter(|(v, _)| numbers.contains(v)).cloned().listed();
    let part = |p: &Poly| Univariate::from_poly(p, var);
    if family.analytic.beside(f).next().is_some() {
        let dependent = family.analytic.dependent();
        let sample = sample.iter().filter(|(v, _)| !dependent.contains(v)).cloned().listed();
        let (_, label) = with_values(family, (label, f), &sample, numbers);
        return beside::of_function(family, (&label, f), &sample, work);
    }
    let (Some(exact), label) = with_values(family, (label, f), sample, numbers) else {
        return open("it has no value at simple shape values");
    };
    let is_exact = !numbers.iter().any(|v| exact.depends_on(*v));
    let parts = put(&exact, &known).and_then(|f| Some((part(f.numer())?, part(f.denom())?)));
    let Some((numer, denom)) = parts else {
        return open("it contains further numbers");
    };
    if [low, high].iter().any(|end| denom.sign_at(end) == 0) {
        return open("it has no bound next to an end that the domain leaves out");
    }
    let Some((zeros, least, greatest)) = of_function(&numer, &denom, low, high, work)? else {
        return Some(Found::Nonnegative);
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
        Extremum { value, at: at(&points), on: Vec::new() }
    };
    let found = Extrema { zeros: at(&zeros), ..Extrema::new(&label, extremum(least), extremum(greatest)) };
    Some(Found::Known(Box::new(found)))
}

/// A value and the points at which it is taken.
type Taken = (Coordinate, Vec<Coordinate>);

/// Zeros, least and greatest value of numer/denom between two numbers; nothing inside if the function is negative
/// nowhere, `None` when the work is spent.
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
