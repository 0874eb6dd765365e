//! Exact values of the functions of a family, from its formulas and not from the steps of its evaluators; of those with
//! angles and exponentials to sixty digits.

use basis_engine::Family;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::rational::Rational;
use basis_engine::algebra::work::Work;
use basis_engine::model::angle::{Analytic, Kind};

/// Where in the domain a value is meant.
#[derive(Clone, Debug)]
pub enum At {
    /// At this parameter.
    Inside(Rational),
    /// At the lower or the upper end of the span, which no float need be.
    End(usize),
}

/// The functions of a family on one span with their first and second derivatives, as formulas.
#[derive(Clone, Debug)]
pub struct Formulas<'a> {
    family: &'a Family,
    orders: [Vec<Fraction>; 3],
}

impl<'a> Formulas<'a> {
    /// Those of a family.
    ///
    /// # Panics
    /// When a derivative is not known.
    pub fn new(family: &'a Family) -> Self {
        let var = family.domain[0].var;
        let next = |f: &Fraction| family.derivative_within(f, var, &mut Work::unlimited()).expect("no limit");
        let values: Vec<Fraction> = family.functions.iter().map(|f| f.value.clone()).collect();
        let first: Vec<Fraction> = values.iter().map(next).collect();
        let second = first.iter().map(next).collect();
        Self { family, orders: [values, first, second] }
    }

    /// By how much a derivative may be larger than the function: by the degree of polynomials, divided by the length of
    /// the span; 1 at least.
    ///
    /// # Panics
    /// When the ends of the span have no value.
    pub fn growth(&self, shapes: &[Rational]) -> Rational {
        let domain = &self.family.domain[0];
        let known = variables(self.family, shapes, &At::End(0));
        let length = match self.family.analytic.angle(domain.var) {
            Some(angle) => {
                let [low, high] = angle.limits.each_ref().map(|limit| put(limit, &known));
                &high - &low
            }
            None => domain.range.finite().map(|(low, high)| high - low).expect("an interval"),
        };
        let degree = Rational::from(i64::from(self.family.degree(domain.var)));
        degree.checked_div(&length).expect("not empty").max(Rational::ONE)
    }

    /// The values, first and second derivatives of all functions.
    ///
    /// # Panics
    /// Where a function has no value.
    pub fn at(&self, shapes: &[Rational], at: &At) -> [Vec<Rational>; 3] {
        let known = variables(self.family, shapes, at);
        self.orders.each_ref().map(|all| all.iter().map(|f| put(f, &known)).collect())
    }
}

/// The values of all variables, tangents among them.
fn variables(family: &Family, shapes: &[Rational], at: &At) -> Vec<(Var, Rational)> {
    let analytic = &family.analytic;
    let mut known: Vec<(Var, Rational)> = analytic.pi.into_iter().map(|var| (var, Analytic::pi())).collect();
    known.extend(analytic.exponential.as_ref().map(|(var, exponent)| (*var, exp(exponent))));
    known.extend(analytic.tangent.as_ref().map(|(var, angle)| {
        let (sin, cos) = sin_cos(angle);
        (*var, rounded(&(&sin / &cos)))
    }));
    known.extend(analytic.roots.iter().map(|root| {
        let (sin, cos) = sin_cos(&(&Analytic::pi() * &Rational::new(1, root.parts)));
        (root.var, rounded(&(&sin / &cos)))
    }));
    let all = family.shapes.iter().zip(shapes).map(|(p, value)| (p.var, value.clone()));
    for (var, value) in all {
        add(analytic, var, &value, &mut known);
    }
    let domain = &family.domain[0];
    match at {
        At::Inside(t) => add(analytic, domain.var, t, &mut known),
        At::End(k) => {
            let (low, high) = domain.range.finite().expect("an interval");
            let end = [low, high][*k].clone();
            known.push((domain.var, end));
        }
    }
    known
}

fn add(analytic: &Analytic, var: Var, value: &Rational, known: &mut Vec<(Var, Rational)>) {
    let Some(angle) = analytic.angle(var) else {
        known.push((var, value.clone()));
        return;
    };
    let pi = Analytic::pi();
    let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &pi };
    let rate = if angle.turns { &angle.rate * &pi } else { angle.rate.clone() };
    let argument = &rate * &(value - &shift);
    let x = match angle.kind {
        Kind::Circular => {
            let (sin, cos) = sin_cos(&argument);
            &sin / &cos
        }
        Kind::Hyperbolic => {
            let e = exp(&(&argument * &Rational::from(2)));
            &(&e - &Rational::ONE) / &(&e + &Rational::ONE)
        }
        Kind::Linear => value.clone(),
    };
    let [low, width] = [&angle.low, &angle.width].map(|f| put(f, known));
    known.push((angle.var, rounded(&(&(&x - &low) / &width))));
    if angle.itself != angle.var {
        known.push((angle.itself, value.clone()));
    }
}

/// The value of a quotient.
fn put(f: &Fraction, known: &[(Var, Rational)]) -> Rational {
    let of = |poly: &Poly| {
        let mut sum = Rational::ZERO;
        for (monomial, coefficient) in poly.terms() {
            let factors = known.iter().map(|(var, value)| value.pow(monomial.exponent(*var).into()));
            sum = &sum + &factors.fold(coefficient.clone(), |product, factor| &product * &factor);
        }
        sum
    };
    of(f.numer()).checked_div(&of(f.denom())).expect("a function has a value on its domain")
}

/// To seventy digits after the point.
fn rounded(x: &Rational) -> Rational {
    let unit = Rational::from(10).pow(70);
    &(x * &unit).floor() / &unit
}

fn sin_cos(x: &Rational) -> (Rational, Rational) {
    let mut sums = [Rational::ZERO, Rational::ZERO];
    let (mut term, mut k) = (Rational::ONE, 0_i64);
    while k < 60 || !term.is_zero() {
        let signed = if k & 2 == 0 { term.clone() } else { -&term };
        let sum = &mut sums[(k & 1) as usize];
        *sum = &*sum + &signed;
        k += 1;
        term = rounded(&(&(&term * x) / &Rational::from(k)));
    }
    let [cos, sin] = sums;
    (sin, cos)
}

fn exp(x: &Rational) -> Rational {
    if *x < Rational::ZERO {
        return &Rational::ONE / &exp(&-x);
    }
    let (mut sum, mut term, mut k) = (Rational::ZERO, Rational::ONE, 0_i64);
    while !term.is_zero() {
        sum = &sum + &term;
        k += 1;
        term = rounded(&(&(&term * x) / &Rational::from(k)));
    }
    sum
}
