//! Angles and exponentials. A variable s that stands in `sin(s)` or `cos(s)` is replaced by x = tan(v·s), one in `sinh(s)`
//! or `exp(s)` by x = tanh(v·s), in which all of these are quotients of polynomials:
//!
//! sin 2ψ = 2x/(1 + x²), cos 2ψ = (1 − x²)/(1 + x²); sinh 2ψ = 2x/(1 − x²), exp 2ψ = (1 + x)/(1 − x), where ψ = v·s.
//!
//! A domain variable whose ends contain shape parameters or π, and which stands in none of these, is x itself. Where the ends of
//! its range are no rational numbers in x, a variable y from 0 to 1 takes the place of x,
//! x = low + width·y. The numbers π, exp(r) and tan(r) are variables as well: they are transcendental, so that an equation
//! holds if and only if it holds for all values of these variables, as is so for s itself beside x. The number tan(π/n) is
//! algebraic: an equation that contains it is divided by its minimal polynomial before it is looked at.

#[cfg(feature = "angles")]
pub(crate) mod enclosure;
#[cfg(feature = "angles")]
pub(super) mod ends;
#[cfg(not(feature = "angles"))]
#[path = "no_ends.rs"]
pub(super) mod ends;
#[cfg(feature = "angles")]
pub(crate) mod tangents;
#[cfg(not(feature = "angles"))]
#[path = "no_tangents.rs"]
pub(crate) mod tangents;

use basis_prover::collections::list::Listed;

use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::divisors::gcd::content;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::algebra::work::Work;
use crate::model::roots::{self, Root};

/// The work for a common factor of the coefficients of a small polynomial.
const CONTENT: u64 = 100_000;

/// Shape parameters that have a value, as multiples of π.
pub(crate) type Given = Vec<(String, Rational)>;

/// With what a family is expanded anew for some of its claims.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Anew {
    /// Shape parameters that have a value.
    pub(crate) given: Given,
    /// The numbers of the statements whose claims ask for smaller parts of the angles than the functions; those of the family
    /// as it is, if there are none; ascending.
    pub(crate) statements: Vec<usize>,
}

/// Which functions a variable stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// sin, cos, tan.
    Circular,
    /// sinh, cosh, tanh, exp.
    Hyperbolic,
    /// None: a domain variable whose ends contain shape parameters or π, x = s.
    Linear,
}

/// A domain variable or shape parameter s that stands in sin, cos, exp and the like.
#[derive(Clone, Debug)]
pub struct Angle {
    /// The name of s.
    pub name: String,
    /// Which functions it stands in.
    pub kind: Kind,
    /// The variable y, or x if `low` is 0 and `width` is 1.
    pub var: Var,
    /// The variable s itself, where it stands outside of these functions.
    pub itself: Var,
    /// v, the factor of s in ψ.
    pub rate: Rational,
    /// Whether v is `rate` times π.
    pub turns: bool,
    /// ψ = v·(s − shift), with a shift in multiples of π unless the rate is one.
    pub shift: Rational,
    /// x where y is 0.
    pub low: Fraction,
    /// dx/dy.
    pub width: Fraction,
    /// The ends of the range in s; 0 where there is none.
    pub limits: [Fraction; 2],
    /// The ends of the range as they are written; empty where there is none.
    pub ends: [String; 2],
    /// The range of s as it is written, such as `0 <= θ <= pi/2`.
    pub declared: String,
    /// y and s after the domain is reversed; nothing for shape parameters.
    pub mirror: Vec<(Var, Fraction)>,
}

impl Angle {
    /// v as a number.
    pub fn speed(&self) -> Rational {
        if self.turns { &self.rate * &Analytic::pi() } else { self.rate.clone() }
    }

    /// x in terms of the variables.
    pub fn tangent(&self) -> Fraction {
        &self.low + &(&self.width * &Fraction::var(self.var))
    }

    /// s where it does not stand beside its sine, from the lower to the upper end as y, which does not occur, runs through its
    /// range.
    #[cfg(feature = "angles")]
    pub(crate) fn along(&self, range: &Range) -> Option<Fraction> {
        let [first, last] = &self.limits;
        let low = range.low.value()?;
        let rise = &Fraction::var(self.var) - &Fraction::constant(low.clone());
        let part = match range.high.value() {
            Some(high) => &rise * &Fraction::constant((high - low).recip()?),
            None => rise.checked_div(&(&rise + &Fraction::constant(Rational::ONE)))?,
        };
        Some(first + &(&(last - first) * &part))
    }

    /// The name of x, such as `tan(θ/2)`.
    pub fn tangent_name(&self) -> String {
        let function = match self.kind {
            Kind::Circular => "tan",
            Kind::Hyperbolic => "tanh",
            Kind::Linear => return self.name.clone(),
        };
        let s = if self.shift.is_zero() {
            self.name.clone()
        } else {
            let shift = if self.turns { self.shift.to_string() } else { multiple_of_pi(&self.shift) };
            match shift.strip_prefix('-') {
                Some(shift) => format!("({} + {shift})", self.name),
                None => format!("({} - {shift})", self.name),
            }
        };
        match s.strip_prefix('(').and_then(|s| s.strip_suffix(')')) {
            Some(s) if self.rate.is_one() && !self.turns => format!("{function}({s})"),
            _ => format!("{function}({})", times(&self.rate, self.turns, &s)),
        }
    }

    /// The factor of y′ = factor·(1 ± x²), the derivative in s.
    pub(super) fn slope(&self, pi: Option<Var>) -> Fraction {
        let rate = Fraction::constant(self.rate.clone());
        let rate = match pi.filter(|_| self.turns) {
            Some(pi) => &rate * &Fraction::var(pi),
            None => rate,
        };
        rate.checked_div(&self.width).unwrap_or_else(Fraction::zero)
    }

    /// dy/ds.
    fn rate_of_change(&self, pi: Option<Var>, work: &mut Work) -> Option<Fraction> {
        let x = self.tangent();
        let one = Fraction::constant(Rational::ONE);
        let sum = match self.kind {
            Kind::Circular => one.add_within(&x.mul_within(&x, work)?, work)?,
            Kind::Hyperbolic => one.sub_within(&x.mul_within(&x, work)?, work)?,
            Kind::Linear => one,
        };
        self.slope(pi).mul_within(&sum, work)
    }
}

/// A name that stands alone: the tangent between two ends is written in brackets, for its powers.
pub(crate) fn without_brackets(name: &str) -> &str {
    let Some(inner) = name.strip_prefix('(').and_then(|name| name.strip_suffix(')')) else { return name };
    let mut depth = 0_i32;
    let closes = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth < 0
    };
    // The first bracket belongs to the last one.
    if inner.chars().any(closes) { name } else { inner }
}

/// `pi/2`, `-2*pi` and so on.
pub(crate) fn multiple_of_pi(factor: &Rational) -> String {
    if factor.is_zero() { String::from("0") } else { times(factor, false, "pi") }
}

/// A factor, perhaps times π, and a name: `pi*t/2`.
pub(crate) fn times(factor: &Rational, turns: bool, name: &str) -> String {
    let (above, below) = (factor.numer(), factor.denom());
    let mut text = String::new();
    if above == Rational::from(-1) {
        text.push('-');
    } else if !above.is_one() {
        text += &format!("{above}*");
    }
    if turns {
        text += "pi*";
    }
    text += name;
    if below.is_one() { text } else { format!("{text}/{below}") }
}

/// What of a family goes beyond quotients of polynomials.
#[derive(Clone, Debug, Default)]
pub struct Analytic {
    /// The variables that stand in sin, cos, exp and the like.
    pub angles: Vec<Angle>,
    /// The variable that stands for π.
    pub pi: Option<Var>,
    /// The variable that stands for exp(r), and r > 0.
    pub exponential: Option<(Var, Rational)>,
    /// The variable that stands for tan(r), and 0 < r < π/2.
    pub tangent: Option<(Var, Rational)>,
    /// The variables that stand for tan(π/n); all are polynomials in the last one.
    pub roots: Vec<Root>,
    /// Ranges in which the numbers lie, and the variables of the angles themselves.
    pub ranges: Vec<(Var, Range)>,
    /// The numbers of the statements for which the family is expanded anew, together where they need the same; each list
    /// is ascending.
    pub(crate) finer: Vec<Vec<usize>>,
}

impl Analytic {
    /// Irreducible polynomials of which the denominators of sin, cos and the like are made, 1 + x², or 1 + x and 1 − x, and
    /// those of quotients by sines and cosines of twice the angle, 1 ± x, or 1 + x².
    pub(crate) fn denominators(&self) -> Vec<Poly> {
        let one = Fraction::constant(Rational::ONE);
        let mut all = Vec::new();
        for angle in self.angles.iter().filter(|a| a.kind != Kind::Linear) {
            let x = angle.tangent();
            let own = [&one + &(&x * &x), &one + &x, &one - &x];
            all.extend(own.iter().map(|f| (f.numer().normalized(), angle)));
        }
        // Of degree 1, or 2 without real zeros, in y: irreducible but for what its coefficients share.
        let primitive = |(p, angle): (Poly, &Angle)| {
            let content = content(&p, angle.var, &mut Work::new(CONTENT))?;
            p.div_exact(&content)
        };
        let mut factors = all.into_iter().filter_map(primitive).listed();
        // Those of the ends of ranges, such as tanh(2) = (exp(1)⁴ − 1)/(exp(1)⁴ + 1).
        let numbers = self.numbers();
        let ends = self.angles.iter().filter(|a| a.kind != Kind::Linear).flat_map(|a| [&a.low, &a.width]);
        for end in ends.flat_map(|f| [f.numer(), f.denom()]) {
            if end.as_constant().is_some() || end.variables().iter().any(|v| !numbers.contains(v)) {
                continue;
            }
            for (factor, _) in checked_factor(end, &mut Work::new(CONTENT)).map_or(Vec::new(), |all| all.1) {
                if factor.len() > 1 && !factors.contains(&factor) {
                    factors.push(factor);
                }
            }
        }
        factors
    }

    /// Whether a variable stands in sin, exp or the like.
    pub fn is_transcendental(&self) -> bool {
        self.angles.iter().any(|a| a.kind != Kind::Linear)
    }

    /// Whether nothing does.
    pub fn is_empty(&self) -> bool {
        self.angles.is_empty() && self.numbers().is_empty()
    }

    /// Where the variable of an angle has a value: at an end of its range as that is written, `t = pi/2`, inside as a
    /// multiple of π, if it is one of which the tangent is 0 or ±1.
    pub(crate) fn value_named(&self, var: Var, value: &Rational, range: &Range) -> Option<String> {
        let angle = self.angle(var)?;
        let is_here = |end: &End| end.value() == Some(value);
        let side = [&range.low, &range.high].into_iter().position(is_here);
        if let Some(end) = side.map(|side| &angle.ends[side]).filter(|end| !end.is_empty()) {
            return Some(format!("{} = {end}", angle.name));
        }
        let is_tangent = angle.low.is_zero() && angle.width == Fraction::constant(Rational::ONE);
        if angle.kind != Kind::Circular || angle.turns || !is_tangent {
            return None;
        }
        let quarters = value.to_i64().filter(|x| (-1..=1).contains(x))?;
        let turns = Rational::new(quarters, 4).checked_div(&angle.rate)?;
        Some(format!("{} = {}", angle.name, multiple_of_pi(&(&turns + &angle.shift))))
    }

    /// The angle of a variable: y, x or s itself.
    pub fn angle(&self, var: Var) -> Option<&Angle> {
        self.angles.iter().find(|a| a.var == var || a.itself == var)
    }

    /// The variables that stand for a definite number: π, exp(r), tan(r), tan(π/n).
    pub fn numbers(&self) -> Vec<Var> {
        self.transcendental().into_iter().chain(self.roots.iter().map(|root| root.var)).listed()
    }

    /// Those that stand for a transcendental number: π, exp(r), tan(r).
    pub fn transcendental(&self) -> Vec<Var> {
        let others = [&self.exponential, &self.tangent].into_iter().flatten().map(|(var, _)| *var);
        self.pi.into_iter().chain(others).listed()
    }

    /// A quotient with the same value whose numerator is 0 if that is, although tan(π/n) is a variable.
    pub fn reduced(&self, f: Fraction) -> Fraction {
        roots::reduced(&self.roots, f)
    }

    /// The same variables, with the values as floats.
    pub fn floats(&self) -> Vec<(Var, f64)> {
        let pi = self.pi.map(|var| (var, core::f64::consts::PI));
        let exponential = self.exponential.as_ref().map(|(var, r)| (*var, r.to_f64().exp()));
        let tangent = self.tangent.as_ref().map(|(var, r)| (*var, r.to_f64().tan()));
        let root = |root: &Root| (root.var, (core::f64::consts::PI / root.parts as f64).tan());
        pi.into_iter().chain(exponential).chain(tangent).chain(self.roots.iter().map(root)).listed()
    }

    /// The variables that have one value for those of the others: π, exp(r), tan(r), and angles beside their sines.
    pub fn dependent(&self) -> Vec<Var> {
        let angles = self.angles.iter().filter(|a| a.kind != Kind::Linear && a.itself != a.var);
        self.numbers().into_iter().chain(angles.map(|a| a.itself)).listed()
    }

    /// π with an error below 10⁻⁴⁴.
    pub fn pi() -> Rational {
        const DIGITS: [i64; 3] = [314_159_265_358_979, 323_846_264_338_327, 950_288_419_716_939];
        let thousand = Rational::from(1_000_000_000_000_000);
        let digits =
            DIGITS.iter().fold(Rational::ZERO, |sum, group| &(&sum * &thousand) + &Rational::from(*group));
        let unit = Rational::from(10).pow(44).recip().unwrap_or(Rational::ZERO);
        &digits * &unit
    }

    /// The values of the numbers, to more digits than a float has.
    pub fn values(&self) -> Vec<(Var, Rational)> {
        let middle = |var: Var| {
            let (_, range) = self.ranges.iter().find(|(v, _)| *v == var)?;
            let (low, high) = range.finite()?;
            Some(&(low + high) * &Rational::new(1, 2))
        };
        let value = |var: Var| if Some(var) == self.pi { Some(Self::pi()) } else { middle(var) };
        self.numbers().into_iter().filter_map(|var| Some((var, value(var)?))).listed()
    }

    /// The number that a quotient is once the numbers are replaced by their values; `None` where it is not only of these.
    pub fn number(&self, f: &Fraction) -> Option<Rational> {
        let put = |f: Fraction, (var, value): (Var, Rational)| f.substitute(var, &Fraction::constant(value));
        self.values().into_iter().try_fold(f.clone(), put)?.as_constant()
    }

    /// The angles that stand in a function beside their sines or exponentials.
    pub(crate) fn beside<'a>(&'a self, f: &'a Fraction) -> impl Iterator<Item = &'a Angle> {
        let is_beside = |a: &&Angle| a.kind != Kind::Linear && a.itself != a.var && f.depends_on(a.itself);
        self.angles.iter().filter(is_beside)
    }

    /// Whether a function contains the angle with that tangent itself, beside its sine or exponential.
    pub fn mixes(&self, f: &Fraction, tangent: Var) -> bool {
        self.angles.iter().any(|a| a.var == tangent && a.itself != a.var && f.depends_on(a.itself))
    }

    /// The derivative of a function in a variable: of one that stands in sin, cos and the like in the variable itself,
    /// all others fixed; `None` when the work is spent.
    pub fn derivative_within(&self, f: &Fraction, var: Var, work: &mut Work) -> Option<Fraction> {
        let (slot, itself, own) = match self.angle(var) {
            Some(angle) => (angle.var, angle.itself, angle.rate_of_change(self.pi, work)?),
            None => (var, var, Fraction::constant(Rational::ONE)),
        };
        let mut sum = Fraction::zero();
        if f.depends_on(itself) {
            sum = f.derivative_within(itself, work)?;
        }
        for other in self.angles.iter().filter(|a| f.depends_on(a.var)) {
            let change = if other.var == slot {
                own.clone()
            } else {
                // x = low + width·y stays what it is, so that y′ = −(low′ + width′·y)/width.
                let (low, width) = (&other.low, &other.width);
                if !low.depends_on(slot) && !width.depends_on(slot) {
                    continue;
                }
                let y = Fraction::var(other.var);
                let stretched = width.derivative_within(slot, work)?.mul_within(&y, work)?;
                let moved = low.derivative_within(slot, work)?.add_within(&stretched, work)?;
                let relative = moved.div_within(width, work).ok().flatten()?;
                -&relative.mul_within(&own, work)?
            };
            let slope = f.derivative_within(other.var, work)?;
            sum = sum.add_within(&slope.mul_within(&change, work)?, work)?;
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn angle(name: &str, rate: Rational, turns: bool, var: usize) -> Angle {
        Angle {
            name: String::from(name),
            kind: Kind::Circular,
            var: Var(var),
            itself: Var(var + 10),
            rate,
            turns,
            shift: Rational::ZERO,
            low: Fraction::zero(),
            width: Fraction::constant(Rational::ONE),
            limits: [Fraction::zero(), Fraction::zero()],
            ends: Default::default(),
            declared: String::new(),
            mirror: Vec::new(),
        }
    }

    #[test]
    fn names_of_tangents() {
        let name = |rate, turns| angle("t", rate, turns, 0).tangent_name();
        assert_eq!(name(Rational::new(1, 2), false), "tan(t/2)");
        assert_eq!(name(Rational::new(1, 4), true), "tan(pi*t/4)");
        assert_eq!(name(Rational::new(3, 2), false), "tan(3*t/2)");
        assert_eq!(without_brackets("(tanh(t/2)/tanh(1))"), "tanh(t/2)/tanh(1)");
        assert_eq!(without_brackets("(a + b)/(c)"), "(a + b)/(c)");
        assert_eq!(without_brackets("(a)*(b)"), "(a)*(b)");
        let shifted = Angle { shift: Rational::new(1, 2), ..angle("t", Rational::new(1, 2), false, 0) };
        assert_eq!(shifted.tangent_name(), "tan((t - pi/2)/2)");
    }

    /// Of sin t in the angle and, where the end of the domain is the parameter, of sin t in the end: 0.
    #[test]
    fn the_chain_rule() {
        let work = &mut Work::unlimited();
        let mut t = angle("t", Rational::new(1, 2), false, 0);
        let end = angle("α", Rational::new(1, 2), false, 1);
        t.width = Fraction::var(Var(1));
        let analytic = Analytic { angles: vec![t.clone(), end], ..Analytic::default() };
        let x = t.tangent();
        let one = Fraction::constant(Rational::ONE);
        let below = &one + &(&x * &x);
        let sin = (&x + &x).checked_div(&below).expect("not zero");
        let cos = (&one - &(&x * &x)).checked_div(&below).expect("not zero");
        assert_eq!(analytic.derivative_within(&sin, Var(0), work), Some(cos.clone()));
        assert_eq!(analytic.derivative_within(&sin, Var(10), work), Some(cos));
        assert_eq!(analytic.derivative_within(&sin, Var(11), work), Some(Fraction::zero()));
        let product = &Fraction::var(Var(10)) * &sin; // t sin t
        let slope = analytic.derivative_within(&product, Var(0), work).expect("enough work");
        assert_eq!(
            &slope - &sin,
            &Fraction::var(Var(10)) * &analytic.derivative_within(&sin, Var(0), work).unwrap()
        );
    }
}
