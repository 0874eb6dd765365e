//! Functions for reading: with the variable itself where the family calculates with a part of its range, in sin and cos
//! of angles, in exp or in sinh and cosh; as a product and expanded.
//!
//! With x = tan ψ, S = sin 2ψ and C = cos 2ψ: x = (1 + x²)·S/2, (1 − x)² = (1 + x²)(1 − S), (1 + x)² = (1 + x²)(1 + S),
//! (1 − x)(1 + x) = (1 + x²)·C, 2x² = (1 + x²)(1 − C), 2 = (1 + x²)(1 + C), and any other polynomial of degree ≤ 2k over
//! (1 + x²)^k is one in S and C, of degree 1 in S. With x = tanh ψ the same holds for 1 − x² and sinh and cosh, as far as
//! the signs allow, and with E = exp 2ψ also x = (E − 1)/(E + 1).

use crate::algebra::divisors::gcd::{gcd_all, split_monomial};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::{Angle, Kind};

/// The work for a common factor of the coefficients of a sum.
const CONTENT: u64 = 100_000;

/// A function as a product for reading.
pub(super) fn factored(family: &Family, f: &Fraction) -> String {
    shortest(&products(family, f).into_iter().map(|product| product.text(true)).collect::<Vec<_>>())
}

/// A function as a factor of a product: a sum stands in brackets.
pub(super) fn as_factor(family: &Family, f: &Fraction) -> String {
    shortest(&products(family, f).into_iter().map(|product| product.text(false)).collect::<Vec<_>>())
}

/// A function expanded into a sum, over a sum where it is a quotient.
pub(super) fn expanded(family: &Family, f: &Fraction) -> String {
    let mut texts = Vec::new();
    for product in products(family, f) {
        texts.push(product.expanded());
        texts.push(product.reduced().expanded());
    }
    let sums: Vec<String> = texts.iter().filter(|text| !text.contains("/(")).cloned().collect();
    shortest(if sums.is_empty() { &texts } else { &sums })
}

/// The first of the shortest texts.
fn shortest(texts: &[String]) -> String {
    texts.iter().min_by_key(|text| text.chars().count()).cloned().unwrap_or_default()
}

/// The ways to write a function.
fn products<'f>(family: &'f Family, f: &Fraction) -> Vec<Product<'f>> {
    let ways: &[Way] = if family.analytic.is_transcendental() {
        &[Way::Exponentials, Way::Sines, Way::Sums, Way::Tangents]
    } else {
        &[Way::Sines]
    };
    let all = ways.iter().map(|way| (way, Product::new(family, f, *way)));
    // Of tangents only polynomials.
    all.filter(|(way, p)| **way != Way::Tangents || p.factors.iter().all(|(_, e)| *e > 0))
        .map(|(_, p)| p)
        .collect()
}

/// A way to write a function of an angle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    /// Exponentials as `exp(-2*t)`, angles in sin and cos, both as products.
    Exponentials,
    /// In sin and cos, sinh and cosh, as products.
    Sines,
    /// The same without products.
    Sums,
    /// In tan and tanh of the half.
    Tangents,
}

/// A number times powers of polynomials.
struct Product<'f> {
    family: &'f Family,
    names: Vec<String>,
    number: Rational,
    factors: Vec<(Poly, i32)>,
    /// Variables that stand for an exponential, whose power is that of a multiple: `exp(2*t)` for the square of `exp(t)`.
    exponentials: Vec<(Var, Exponential)>,
    /// sin and cos, or sinh and cosh, of one angle.
    pairs: Vec<(Var, Var, Kind)>,
}

/// What stands in an exponential.
enum Exponential {
    /// A rational number.
    Number(Rational),
    /// A multiple of a variable.
    Of(Box<Angle>),
}

impl Exponential {
    /// The power with this exponent.
    fn power(&self, exponent: i32) -> String {
        let exponent = Rational::from(i64::from(exponent));
        match self {
            Self::Number(r) => format!("exp({})", &exponent * r),
            Self::Of(angle) => format!("exp({})", argument(angle, &(&exponent + &exponent))),
        }
    }
}

/// A multiple of ψ, such as `2*t - pi`.
fn argument(angle: &Angle, factor: &Rational) -> String {
    let tangent = Angle { rate: &angle.rate * factor, kind: Kind::Circular, ..angle.clone() }.tangent_name();
    let inner = tangent.strip_prefix("tan(").and_then(|rest| rest.strip_suffix(')')).unwrap_or(&tangent);
    // Brackets around all of it.
    let bare = inner.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
    bare.filter(|bare| !bare.contains(['(', ')'])).unwrap_or(inner).to_string()
}

/// The powers of x, 1 − x, 1 + x and 1 + x² or 1 − x² in a product.
#[derive(Default)]
struct Powers {
    x: i32,
    minus: i32,
    plus: i32,
    square: i32,
}

impl<'f> Product<'f> {
    fn new(family: &'f Family, f: &Fraction, way: Way) -> Self {
        let mut product = Self {
            family,
            names: family.names.clone(),
            number: Rational::ONE,
            factors: Vec::new(),
            exponentials: Vec::new(),
            pairs: Vec::new(),
        };
        if let Some((var, r)) = &family.analytic.exponential {
            product.exponentials.push((*var, Exponential::Number(r.clone())));
        }
        product.put_back(f, way);
        product
    }

    /// Writes a function in the variables themselves.
    fn put_back(&mut self, f: &Fraction, way: Way) {
        self.push(f.numer(), 1);
        self.push(f.denom(), -1);
        // The variables of the domain first: their tangents may be multiples of those of the shape parameters.
        for angle in self.family.analytic.angles.iter().rev() {
            let mut own = Vec::new();
            for (p, e) in core::mem::take(&mut self.factors) {
                if p.depends_on(angle.var) { own.push((p, e)) } else { self.factors.push((p, e)) }
            }
            if !angle.low.is_zero() || angle.width.as_constant().is_none_or(|w| !w.is_one()) {
                own = unscaled(&own, angle);
            }
            match (angle.kind, way) {
                (Kind::Linear, _) => self.linear(own, angle),
                (_, Way::Tangents) => {
                    self.names[angle.var.0] = angle.tangent_name();
                    for (p, e) in own {
                        self.push(&p, e);
                    }
                }
                (Kind::Hyperbolic, Way::Exponentials) => self.exponential(own, angle),
                _ => self.sines(own, angle, way),
            }
        }
    }

    /// Multiplies by a power of a polynomial.
    fn push(&mut self, p: &Poly, exponent: i32) {
        if exponent == 0 {
            return;
        }
        let mut content = p.numeric_content();
        if content.is_zero() {
            self.number = Rational::ZERO;
            return;
        }
        if self.is_negative(p) {
            content = -content;
        }
        self.scale(&content, exponent);
        let (monomial, mut p) = split_monomial(&p.scale(&content.recip().unwrap_or(Rational::ONE)));
        for (k, e) in monomial.exponents().iter().enumerate().filter(|(_, e)| **e > 0) {
            self.multiply(Poly::var(Var(k)), exponent * i32::from(*e));
        }
        if let Some((e, _)) = &self.family.analytic.exponential
            && p.depends_on(*e)
        {
            for factor in [&Poly::var(*e) + &Poly::one(), &Poly::var(*e) - &Poly::one()] {
                let (power, rest) = divided(p, &factor);
                self.multiply(factor, power * exponent);
                p = rest;
            }
        }
        match p.as_constant() {
            Some(number) => self.scale(&number, exponent),
            None => self.multiply(p, exponent),
        }
    }

    fn multiply(&mut self, p: Poly, exponent: i32) {
        if exponent == 0 {
            return;
        }
        let negative = -&p;
        match self.factors.iter_mut().find(|(q, _)| *q == p || *q == negative) {
            Some((q, e)) => {
                if *q == negative && exponent % 2 != 0 {
                    self.number = -self.number.clone();
                }
                *e += exponent;
            }
            None => self.factors.push((p, exponent)),
        }
        self.factors.retain(|(_, e)| *e != 0);
    }

    fn scale(&mut self, number: &Rational, exponent: i32) {
        let base = if exponent < 0 { number.recip().unwrap_or(Rational::ONE) } else { number.clone() };
        self.number = &self.number * &base.pow(exponent.unsigned_abs());
    }

    /// Whether a polynomial in π and exp(r) alone is negative; of others, whether all coefficients are.
    fn is_negative(&self, p: &Poly) -> bool {
        let number =
            (p.as_constant().is_none()).then(|| self.family.analytic.number(&Fraction::from(p.clone())));
        match number.flatten() {
            Some(value) => value.is_negative(),
            None => p.terms().all(|(_, c)| c.is_negative()),
        }
    }

    /// A new variable.
    fn name(&mut self, name: String) -> Var {
        self.names.push(name);
        Var(self.names.len() - 1)
    }

    /// A variable whose range ends in shape parameters: the distances to the ends are factors.
    fn linear(&mut self, own: Vec<(Poly, i32)>, angle: &Angle) {
        self.names[angle.var.0].clone_from(&angle.name);
        let x = Fraction::var(angle.var);
        let distances = [&x - &angle.limits[0], &angle.limits[1] - &x];
        for (p, e) in own {
            let mut rest = p;
            for distance in &distances {
                let Some(distance) = distance.as_poly().filter(|d| d.depends_on(angle.var)) else { continue };
                let (power, left) = divided(rest, distance);
                self.push(distance, e * power);
                rest = left;
            }
            self.push(&rest, e);
        }
    }

    /// Takes the powers of x, 1 − x and 1 + x out of a product.
    fn powers(own: Vec<(Poly, i32)>, angle: &Angle) -> (Powers, Vec<(Poly, i32)>) {
        let (one, x) = (Poly::one(), Poly::var(angle.var));
        let mut powers = Powers::default();
        let mut rests = Vec::new();
        for (p, e) in own {
            let (a, p) = divided(p, &x);
            let (b, p) = divided(p, &(&one - &x));
            let (c, p) = divided(p, &(&one + &x));
            powers.x += a * e;
            powers.minus += b * e;
            powers.plus += c * e;
            let p = if angle.kind == Kind::Circular {
                let (d, p) = divided(p, &(&one + &(&x * &x)));
                powers.square += d * e;
                p
            } else {
                p
            };
            rests.push((p, e));
        }
        (powers, rests)
    }

    /// A product in x as one in exp 2ψ.
    fn exponential(&mut self, own: Vec<(Poly, i32)>, angle: &Angle) {
        if own.is_empty() {
            return;
        }
        let var = self.name(String::new());
        self.exponentials.push((var, Exponential::Of(Box::new(angle.clone()))));
        let (one, two, e) = (Poly::one(), Rational::from(2), Poly::var(var));
        let (above, below) = (&e - &one, &e + &one);
        let (powers, rests) = Self::powers(own, angle);
        self.push(&above, powers.x);
        self.push(&e, powers.plus);
        self.scale(&two, powers.minus + powers.plus);
        let mut sums = -powers.x - powers.minus - powers.plus;
        for (p, exponent) in rests {
            let degree = p.degree(angle.var);
            let mut sum = Poly::zero();
            for (j, coefficient) in p.coefficients_in(angle.var).iter().enumerate() {
                let j = j as u32;
                sum = &sum + &(coefficient * &(&above.pow(j) * &below.pow(degree - j)));
            }
            let (power, sum) = divided(sum, &e);
            self.push(&e, power * exponent);
            self.push(&sum, exponent);
            sums -= exponent * degree as i32;
        }
        self.push(&below, sums);
    }

    /// A product in x as one in sin and cos of 2ψ, or sinh and cosh.
    fn sines(&mut self, own: Vec<(Poly, i32)>, angle: &Angle, way: Way) {
        if own.is_empty() {
            return;
        }
        let circular = angle.kind == Kind::Circular;
        let of = argument(angle, &Rational::from(2));
        let functions = if circular { ["sin", "cos"] } else { ["sinh", "cosh"] };
        let [sin, cos] = functions.map(|f| self.name(format!("{f}({of})")));
        self.pairs.push((sin, cos, angle.kind));
        if way == Way::Sums {
            let (above, below) = multiplied(&own);
            let degree = |p: &Poly| p.degree(angle.var).div_ceil(2);
            let k = degree(&above).max(degree(&below));
            for (p, e) in [(above, 1), (below, -1)] {
                let p = in_sines(&p, angle, k, (sin, cos));
                let coefficients =
                    p.coefficients_in(sin).iter().flat_map(|c| c.coefficients_in(cos)).collect::<Vec<_>>();
                let common = gcd_all(&coefficients, &mut Work::new(CONTENT)).filter(|g| !g.is_zero());
                let common = common.unwrap_or_else(Poly::one);
                let rest = p.div_exact(&common);
                self.push(rest.as_ref().unwrap_or(&p), e);
                if rest.is_some() {
                    self.push(&common, e);
                }
            }
            return;
        }
        let (mut powers, mut rests) = Self::powers(own, angle);
        // A single 1 − x is nothing in sines: it goes with another polynomial, best with one of odd degree.
        if (powers.minus + powers.plus) % 2 != 0 {
            let x = Poly::var(angle.var);
            let (odd, single) = if powers.minus % 2 == 0 {
                (&mut powers.plus, &Poly::one() + &x)
            } else {
                (&mut powers.minus, &Poly::one() - &x)
            };
            let sign = odd.signum();
            *odd -= sign;
            let degree = |p: &Poly| p.degree(angle.var);
            let odd = rests.iter().position(|(p, e)| *e == sign && degree(p) % 2 == 1);
            match odd.or_else(|| rests.iter().position(|(_, e)| *e == sign)) {
                Some(k) => rests[k].0 = &rests[k].0 * &single,
                None => rests.push((single, sign)),
            }
        }
        if circular {
            if powers.minus % 2 != 0 {
                self.push(&Poly::var(cos), 1);
                (powers.minus, powers.plus, powers.square) =
                    (powers.minus - 1, powers.plus - 1, powers.square + 1);
            }
        } else {
            // ((1 + x)/(1 − x))^m is exp 2mψ.
            let m = (powers.plus - powers.minus) / 2;
            if m != 0 {
                let e = self.name(String::new());
                self.exponentials.push((e, Exponential::Of(Box::new(angle.clone()))));
                self.push(&Poly::var(e), m);
            }
            powers.square = i32::midpoint(powers.plus, powers.minus);
            (powers.minus, powers.plus) = (0, 0);
        }
        if powers.x % 2 != 0 {
            self.push(&Poly::var(sin), 1);
            self.scale(&Rational::new(1, 2), 1);
            (powers.x, powers.square) = (powers.x - 1, powers.square + 1);
        }
        for (p, e) in rests {
            let k = p.degree(angle.var).div_ceil(2);
            powers.square += e * k as i32;
            self.push(&in_sines(&p, angle, k, (sin, cos)), e);
        }
        let (one, c, s) = (Poly::one(), Poly::var(cos), Poly::var(sin));
        let versine = if circular { &one - &c } else { &c - &one };
        let (i, p, q) = (powers.x / 2, powers.minus / 2, powers.plus / 2);
        let j = -(powers.square + i + p + q);
        self.scale(&Rational::new(1, 2), i + j);
        self.conjugates([(versine, i), (&one + &c, j)], &s);
        self.conjugates([(&one - &s, p), (&one + &s, q)], &c);
    }

    /// Multiplies by powers of two polynomials whose product is the square of a variable.
    fn conjugates(&mut self, [(a, i), (b, j)]: [(Poly, i32); 2], root: &Poly) {
        let common = if i > 0 && j > 0 {
            i.min(j)
        } else if i < 0 && j < 0 {
            i.max(j)
        } else {
            0
        };
        self.push(root, 2 * common);
        self.push(&a, i - common);
        self.push(&b, j - common);
    }

    /// The parts above and below the fraction line, multiplied out.
    fn parts(&self) -> (Poly, Poly) {
        let (mut above, mut below) =
            (Poly::constant(self.number.numer()), Poly::constant(self.number.denom()));
        for (p, e) in &self.factors {
            let part = if *e > 0 { &mut above } else { &mut below };
            *part = &*part * &p.pow(e.unsigned_abs());
        }
        (above, below)
    }

    /// With no higher power of sin or sinh than the first, and nothing in factors.
    fn reduced(mut self) -> Self {
        let (mut above, mut below) = self.parts();
        for (sin, cos, kind) in &self.pairs {
            let (one, c) = (Poly::one(), Poly::var(*cos));
            let square = &one - &(&c * &c);
            let square = if *kind == Kind::Circular { square } else { -&square };
            let reduce = |p: &Poly| {
                let mut sum = Poly::zero();
                for (k, coefficient) in p.coefficients_in(*sin).iter().enumerate() {
                    let k = k as u32;
                    sum = &sum + &(&(coefficient * &square.pow(k / 2)) * &Poly::var(*sin).pow(k % 2));
                }
                sum
            };
            (above, below) = (reduce(&above), reduce(&below));
        }
        (self.number, self.factors) = (Rational::ONE, Vec::new());
        self.push(&above, 1);
        self.push(&below, -1);
        self
    }

    /// As a sum, or a quotient of two.
    fn expanded(&self) -> String {
        let (mut above, mut below) = self.parts();
        if above.is_zero() {
            return String::from("0");
        }
        if self.is_negative(&below) {
            (above, below) = (-&above, -&below);
        }
        // A power of an exponential below the line goes above it.
        let mut shifts = Vec::new();
        for (var, _) in &self.exponentials {
            let (power, rest) = divided(below, &Poly::var(*var));
            below = rest;
            shifts.push(power);
        }
        if let Some(unit) = below.as_constant().and_then(|c| c.recip()) {
            return self.sum(&above.scale(&unit), &shifts);
        }
        let bracket = |text: String| if text.contains(' ') { format!("({text})") } else { text };
        let (above, below) = (bracket(self.sum(&above, &shifts)), self.sum(&below, &[]));
        if below.contains([' ', '*']) { format!("{above}/({below})") } else { format!("{above}/{below}") }
    }

    /// A sum, the exponents of exponentials less by some numbers.
    fn sum(&self, p: &Poly, shifts: &[i32]) -> String {
        let (mut p, mut names) = (p.clone(), self.names.clone());
        for (k, (var, of)) in self.exponentials.iter().enumerate() {
            let shift = shifts.get(k).copied().unwrap_or(0);
            let mut sum = Poly::zero();
            for (j, coefficient) in p.coefficients_in(*var).iter().enumerate() {
                let power = j as i32 - shift;
                if power == 0 {
                    sum = &sum + coefficient;
                } else if !coefficient.is_zero() {
                    names.push(of.power(power));
                    sum = &sum + &(coefficient * &Poly::var(Var(names.len() - 1)));
                }
            }
            p = sum;
        }
        positive_first(&p.display(&names).to_string())
    }

    /// As a product; as a factor of a longer one a sum has brackets.
    fn text(mut self, alone: bool) -> String {
        if self.number.is_zero() {
            return String::from("0");
        }
        // A sign goes into a difference.
        if self.number.is_negative() {
            let constant = |p: &Poly| self.family.analytic.number(&Fraction::from(p.clone())).is_some();
            let mixed = |p: &Poly| p.terms().any(|(_, c)| c.is_negative());
            if let Some((p, _)) = self.factors.iter_mut().find(|(p, e)| *e == 1 && mixed(p) && !constant(p)) {
                *p = -&*p;
                self.number = -self.number;
            }
        }
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for (p, e) in &self.factors {
            let of = self.exponentials.iter().find(|(var, _)| *p == Poly::var(*var));
            if let Some((_, of)) = of {
                above.push(of.power(*e));
                continue;
            }
            let text = self.sum(p, &[]);
            let base = if text.contains(' ') { format!("({text})") } else { text };
            let part = if *e > 0 { &mut above } else { &mut below };
            part.push(if e.abs() == 1 { base } else { format!("{base}^{}", e.abs()) });
        }
        let sign = if self.number.is_negative() { "-" } else { "" };
        let number = self.number.abs();
        let (mut first, mut last) = (number.clone(), Rational::ONE);
        if !below.is_empty() {
            (first, last) = (number.numer(), number.denom());
        }
        if !first.is_one() || above.is_empty() {
            above.insert(0, first.to_string());
        }
        if !last.is_one() {
            below.insert(0, last.to_string());
        }
        let numerator = above.join("*");
        match below.as_slice() {
            [] if alone && above.len() == 1 && sign.is_empty() => {
                let bare = numerator.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
                bare.unwrap_or(&numerator).to_string()
            }
            [] => format!("{sign}{numerator}"),
            [one] => format!("{sign}{numerator}/{one}"),
            several => format!("{sign}{numerator}/({})", several.join("*")),
        }
    }
}

/// How often a polynomial divides another one, and what is left.
fn divided(p: Poly, by: &Poly) -> (i32, Poly) {
    let (mut power, mut rest) = (0, p);
    while !rest.is_zero()
        && let Some(quotient) = rest.div_exact(by)
    {
        (power, rest) = (power + 1, quotient);
    }
    (power, rest)
}

/// The parts of a product above and below the fraction line.
fn multiplied(own: &[(Poly, i32)]) -> (Poly, Poly) {
    let part = |sign: i32| {
        let of = own.iter().filter(|(_, e)| e.signum() == sign);
        of.fold(Poly::one(), |product, (p, e)| &product * &p.pow(e.unsigned_abs()))
    };
    (part(1), part(-1))
}

/// A product with x in place of y.
fn unscaled(own: &[(Poly, i32)], angle: &Angle) -> Vec<(Poly, i32)> {
    let (above, below) = multiplied(own);
    let y = (&Fraction::var(angle.var) - &angle.low).checked_div(&angle.width);
    let f = y.and_then(|y| Fraction::new(above, below)?.substitute(angle.var, &y));
    f.map_or_else(Vec::new, |f| vec![(f.numer().clone(), 1), (f.denom().clone(), -1)])
}

/// A sum that begins with a term without a minus sign, where there is one.
fn positive_first(text: &str) -> String {
    let Some(rest) = text.strip_prefix('-') else { return text.to_string() };
    let mut depth = 0;
    let mut terms = vec![(0, '-')];
    for (at, c) in rest.char_indices() {
        depth += i32::from(c == '(') - i32::from(c == ')');
        if depth == 0 && rest[at..].starts_with([' ']) && rest[at + 1..].starts_with(['+', '-']) {
            terms.push((at, if rest[at + 1..].starts_with('+') { '+' } else { '-' }));
        }
    }
    let Some(first) = terms.iter().position(|(_, sign)| *sign == '+') else { return text.to_string() };
    let end = |k: usize| terms.get(k + 1).map_or(rest.len(), |(at, _)| *at);
    let moved = &rest[terms[first].0 + 3..end(first)];
    format!("{moved} - {}{}", &rest[..terms[first].0], &rest[end(first)..])
}

/// p(x)/(1 ± x²)^k, k at least half of the degree, as a polynomial in S and C.
fn in_sines(p: &Poly, angle: &Angle, k: u32, (sin, cos): (Var, Var)) -> Poly {
    let half = Rational::new(1, 2);
    let (one, c) = (Poly::one(), Poly::var(cos));
    // The squares of cos ψ and of sin ψ.
    let square_of_cos = (&one + &c).scale(&half);
    let square_of_sin = if angle.kind == Kind::Circular { &one - &c } else { &c - &one }.scale(&half);
    let both = Poly::var(sin).scale(&half);
    let mut sum = Poly::zero();
    for (j, coefficient) in p.coefficients_in(angle.var).iter().enumerate() {
        let j = j as u32;
        let even = &square_of_sin.pow(j / 2) * &square_of_cos.pow(k - j.div_ceil(2));
        let power = if j % 2 == 1 { &even * &both } else { even };
        sum = &sum + &(coefficient * &power);
    }
    sum
}
