//! How far polynomials on a domain between numbers are from their functions.
//!
//! A function is a quotient A/B of polynomials in t and a tangent. Both times cosᵏ are sums of products of sin ψ, cos ψ
//! and t, which have power series in the place p, 0 ≤ p ≤ 1, on a span. With a polynomial P in place of the function,
//!
//! A/B − P = (A − B·P)/B,
//!
//! and A − B·P is a power series in p again. Its first coefficients are 0 where function and polynomial vanish, which
//! is decided exactly, so that it is at most p to that power times the sum of the absolute values of all others. All
//! numbers are enclosed: a middle with digits that are cut off, and a radius that grows with what was.

use basis_prover::collections::list::{Listed, Mapped};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Analytic, Angle, Kind};

/// Bits after the point.
const BITS: u32 = 192;

/// The highest power of a series.
const LAST: usize = 44;

/// Terms of the series of numbers, and the largest arguments for which those that are missing are below the last bit.
const TERMS: i64 = 140;
const LARGEST: i64 = 12;

/// A number that is within a distance of another one.
#[derive(Clone)]
struct Near {
    middle: Rational,
    radius: Rational,
}

impl Near {
    fn new(middle: &Rational, radius: &Rational) -> Self {
        let unit = Rational::from(2).pow(BITS);
        let tiny = unit.recip().unwrap_or(Rational::ONE);
        let floor = |x: &Rational| &(x * &unit).floor() * &tiny;
        let rounded = floor(middle);
        let radius = &(&(middle - &rounded) + radius) + &tiny;
        Self { middle: rounded, radius: floor(&radius) }
    }

    fn exact(x: &Rational) -> Self {
        Self { middle: x.clone(), radius: Rational::ZERO }
    }

    fn zero() -> Self {
        Self::exact(&Rational::ZERO)
    }

    /// What its absolute value is at most.
    fn size(&self) -> Rational {
        &self.middle.abs() + &self.radius
    }

    fn is_zero(&self) -> bool {
        self.middle.is_zero() && self.radius.is_zero()
    }

    fn add(&self, other: &Self) -> Self {
        Self { middle: &self.middle + &other.middle, radius: &self.radius + &other.radius }
    }

    fn neg(&self) -> Self {
        Self { middle: -&self.middle, radius: self.radius.clone() }
    }

    fn mul(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::zero();
        }
        let radius = &(&self.size() * &other.radius) + &(&self.radius * &other.middle.abs());
        Self::new(&(&self.middle * &other.middle), &radius)
    }

    fn recip(&self) -> Option<Self> {
        let least = &self.middle.abs() - &self.radius;
        let inverse = self.middle.recip().filter(|_| least.is_positive())?;
        let radius = self.radius.checked_div(&(&least * &self.middle.abs()))?;
        Some(Self::new(&inverse, &radius))
    }
}

/// exp x, from that of its sixteenth part.
fn exponential(x: &Near) -> Option<Near> {
    let part = x.mul(&Near::exact(&Rational::new(1, 16)));
    let [odd, even] = waves(&part, false)?;
    let mut power = odd.add(&even);
    for _ in 0..4 {
        power = power.mul(&power);
    }
    Some(power)
}

/// sin x and cos x, or sinh x and cosh x.
fn waves(x: &Near, is_circular: bool) -> Option<[Near; 2]> {
    if x.size() > Rational::from(LARGEST) {
        return None;
    }
    let square = x.mul(x);
    let square = if is_circular { square.neg() } else { square };
    let sum = |first: Near, from: i64| {
        let (mut term, mut sum) = (first.clone(), first);
        for k in 0..TERMS / 2 {
            let n = from + 2 * k;
            term = term.mul(&square).mul(&Near::new(&Rational::new(1, (n + 1) * (n + 2)), &Rational::ZERO));
            sum = sum.add(&term);
        }
        // With all terms that are missing.
        Near::new(&sum.middle, &sum.radius)
    };
    Some([sum(x.clone(), 1), sum(Near::exact(&Rational::ONE), 0)])
}

/// A power series in p: the sum of its first terms, and a number that pᴸ⁺¹ times is at least the absolute value of all
/// others.
#[derive(Clone)]
struct Series {
    terms: Vec<Near>,
    rest: Rational,
}

impl Series {
    fn constant(x: Near) -> Self {
        let mut terms = vec![Near::zero(); LAST + 1];
        terms[0] = x;
        Self { terms, rest: Rational::ZERO }
    }

    fn add(&self, other: &Self) -> Self {
        let terms = self.terms.iter().zip(&other.terms).map(|(a, b)| a.add(b)).listed();
        Self { terms, rest: &self.rest + &other.rest }
    }

    fn times(&self, factor: &Near) -> Self {
        Self { terms: self.terms.mapped(|c| c.mul(factor)), rest: short(&(&self.rest * &factor.size())) }
    }

    /// The sum of the absolute values of the terms from one on, with the rest.
    fn size_from(&self, k: usize) -> Rational {
        self.terms[k..].iter().fold(self.rest.clone(), |sum, c| &sum + &c.size())
    }

    fn mul(&self, other: &Self) -> Self {
        let mut terms = vec![Near::zero(); LAST + 1];
        let mut beyond = Rational::ZERO;
        for (i, a) in self.terms.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (j, b) in other.terms.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
                match terms.get_mut(i + j) {
                    Some(sum) => *sum = sum.add(&a.mul(b)),
                    None => beyond += &(&short(&a.size()) * &short(&b.size())),
                }
            }
        }
        let rest = &(&self.rest * &other.size_from(0)) + &(&self.size_from(0) * &other.rest);
        Self { terms, rest: short(&(&beyond + &rest)) }
    }

    fn powers(&self, degree: u32) -> Vec<Self> {
        let mut all = vec![Self::constant(Near::exact(&Rational::ONE))];
        for k in 0..degree as usize {
            all.push(all[k].mul(self));
        }
        all
    }
}

/// A number with few digits that is not less.
fn short(x: &Rational) -> Rational {
    let unit = Rational::from(2).pow(BITS);
    unit.recip().map_or_else(|| x.clone(), |tiny| &(&(x * &unit).floor() + &Rational::ONE) * &tiny)
}

/// The numbers π, exp(r), tan(r) and tan(π/n).
fn numbers(analytic: &Analytic) -> Option<Vec<(Var, Near)>> {
    let mut all = analytic.pi.map(|var| (var, pi())).into_iter().listed();
    let tangent = |x: &Near| {
        let [sin, cos] = waves(x, true)?;
        Some(sin.mul(&cos.recip()?))
    };
    if let Some((var, r)) = &analytic.exponential {
        all.push((*var, exponential(&Near::exact(r))?));
    }
    if let Some((var, r)) = &analytic.tangent {
        all.push((*var, tangent(&Near::exact(r))?));
    }
    for root in &analytic.roots {
        all.push((root.var, tangent(&pi().mul(&Near::exact(&Rational::new(1, root.parts))))?));
    }
    Some(all)
}

fn pi() -> Near {
    let radius = Rational::from(10).pow(44).recip().unwrap_or(Rational::ONE);
    Near::new(&Analytic::pi(), &radius)
}

/// What A, B and P are made of on a span.
pub(super) struct Residual<'f> {
    angle: &'f Angle,
    numbers: Vec<(Var, Near)>,
    /// Powers of y·cos ψ, of cos ψ, and of t, as many as the functions have.
    places: Vec<Series>,
    cosines: Vec<Series>,
    times: Vec<Series>,
    /// The largest absolute values of shape parameters; `None` for one without.
    shapes: Vec<(Var, Option<Rational>)>,
}

impl<'f> Residual<'f> {
    /// On a span that begins or ends at `ends[0]`, p being 0 there and 1 at `ends[1]`.
    pub(super) fn new(family: &Family, angle: &'f Angle, ends: [&Fraction; 2]) -> Option<Self> {
        let numbers = numbers(&family.analytic)?;
        let value = |f: &Fraction| {
            let own = |p: &Poly| of_numbers(p, &numbers);
            Some(own(f.numer())?.mul(&own(f.denom())?.recip()?))
        };
        let [from, to] = [value(ends[0])?, value(ends[1])?];
        let step = to.add(&from.neg());
        let by = if angle.turns { pi() } else { Near::exact(&Rational::ONE) };
        let rate = by.mul(&Near::exact(&angle.rate));
        let shift =
            if angle.turns { Near::exact(&angle.shift) } else { pi().mul(&Near::exact(&angle.shift)) };
        let is_circular = angle.kind == Kind::Circular;
        let [sin, cos] = waves(&rate.mul(&from.add(&shift.neg())), is_circular)?;
        // Derivatives of sin are cos, −sin, …; none is larger in absolute value than these.
        let reach = rate.mul(&step);
        let largest = if is_circular {
            Rational::ONE
        } else {
            let most = &rate.mul(&from.add(&shift.neg())).size() + &reach.size();
            exponential(&Near::exact(&most)).filter(|_| most <= Rational::from(LARGEST))?.size()
        };
        let mut factors = vec![Near::exact(&Rational::ONE)];
        for k in 1..=LAST + 1 {
            let inverse = Near::new(&Rational::new(1, k as i64), &Rational::ZERO);
            factors.push(factors[k - 1].mul(&reach).mul(&inverse));
        }
        let rest = short(&(&factors[LAST + 1].size() * &largest));
        let of = |own: [&Near; 2], signs: [bool; 4]| {
            let terms = (0..=LAST).map(|k| {
                let term = own[k % 2].mul(&factors[k]);
                if is_circular && signs[k % 4] { term.neg() } else { term }
            });
            Series { terms: terms.listed(), rest: rest.clone() }
        };
        let sine = of([&sin, &cos], [false, false, true, true]);
        let cosine = of([&cos, &sin], [false, true, true, false]);
        let mut t = Series::constant(from);
        t.terms[1] = step;
        let own = [angle.var, angle.itself];
        let mut shapes = Vec::new();
        for (var, range) in &family.region().ranges {
            if !own.contains(var) {
                shapes.push((*var, range.finite().map(|(low, high)| low.abs().max(high.abs()))));
            }
        }
        let (low, width) = (value(&angle.low)?, value(&angle.width)?);
        let place = sine.add(&cosine.times(&low.neg())).times(&width.recip()?);
        let polys = || family.functions.iter().flat_map(|f| [f.value.numer(), f.value.denom()]);
        let most = |var: Var| polys().map(|p| p.degree(var)).max().unwrap_or(0);
        let power = most(angle.var);
        let (places, cosines) = (place.powers(power), cosine.powers(power));
        let times = t.powers(most(angle.itself));
        Some(Self { angle, numbers, places, cosines, times, shapes })
    }

    /// A number a for which a polynomial is at most a·pᵏ from a quotient, where both vanish of the order k; the
    /// polynomial by its coefficients.
    pub(super) fn most(
        &self,
        above: &Poly,
        below: &Poly,
        polynomial: &[Poly],
        order: usize,
    ) -> Option<Rational> {
        let y = self.angle.var;
        let power = above.degree(y).max(below.degree(y));
        let [above, below] = [self.of(above, power), self.of(below, power)];
        let [(m, below)] = &below[..] else { return None };
        if m.total_degree() > 0 {
            return None;
        }
        // By the monomials in shape parameters.
        let mut parts: Vec<(Monomial, Series)> = above;
        for (k, c) in polynomial.iter().enumerate() {
            for (m, c) in c.terms() {
                let mut term = Series::constant(Near::zero());
                *term.terms.get_mut(k)? = Near::exact(&-c);
                add(&mut parts, m, term.mul(below));
            }
        }
        let mut sum = Rational::ZERO;
        for (m, series) in &parts {
            let mut factor = series.size_from(order);
            for (var, most) in &self.shapes {
                let power = u32::from(m.exponent(*var));
                if power > 0 {
                    factor = &factor * &most.as_ref()?.pow(power);
                }
            }
            sum += &factor;
        }
        let first = &below.terms[0];
        let least = &(&first.middle.abs() - &first.radius) - &below.size_from(1);
        let most = sum.checked_div(&least).filter(|_| least.is_positive())?;
        // With few digits.
        let unit = Rational::from(2).pow(BITS);
        Some(&(&(&most * &unit).floor() + &Rational::ONE) * &unit.recip()?)
    }

    /// A polynomial times a power of cos ψ, by its monomials in shape parameters.
    fn of(&self, p: &Poly, power: u32) -> Vec<(Monomial, Series)> {
        let mut parts = Vec::new();
        for (m, c) in p.terms() {
            let [i, j] = [self.angle.var, self.angle.itself].map(|var| usize::from(m.exponent(var)));
            let mut rest = m.with_exponent(self.angle.var, 0).with_exponent(self.angle.itself, 0);
            let mut factor = Near::exact(c);
            for (var, x) in &self.numbers {
                for _ in 0..m.exponent(*var) {
                    factor = factor.mul(x);
                }
                rest = rest.with_exponent(*var, 0);
            }
            let product = self.cosines[power as usize - i].mul(&self.places[i]).mul(&self.times[j]);
            add(&mut parts, &rest, product.times(&factor));
        }
        parts
    }
}

fn add(parts: &mut Vec<(Monomial, Series)>, m: &Monomial, series: Series) {
    match parts.iter_mut().find(|(own, _)| own == m) {
        Some((_, sum)) => *sum = sum.add(&series),
        None => parts.push((m.clone(), series)),
    }
}

/// A polynomial in numbers only.
fn of_numbers(p: &Poly, numbers: &[(Var, Near)]) -> Option<Near> {
    let mut sum = Near::zero();
    for (m, c) in p.terms() {
        let (mut term, mut left) = (Near::exact(c), m.total_degree());
        for (var, x) in numbers {
            let power = m.exponent(*var);
            left -= u32::from(power);
            for _ in 0..power {
                term = term.mul(x);
            }
        }
        if left > 0 {
            return None;
        }
        sum = sum.add(&term);
    }
    Some(sum)
}
