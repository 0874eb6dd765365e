//! Numbers as they are typed, r or r·π, and their tangents to fifty digits.
//!
//! What is not rational is taken for a rational number that differs from it by less than 10⁻⁵⁰, so that the arithmetic stays
//! exact and one rounding is left, that to a decimal.

use std::fmt;

use basis_engine::algebra::rational::{self, Rational, ToFloat as _};
use basis_engine::model::angle::{Analytic, Angle, Kind};

/// a + b·π.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Number {
    rational: Rational,
    turns: Rational,
}

/// π to 62 digits.
const PI: &str = "3.14159265358979323846264338327950288419716939937510582097494459";

/// π, rounded.
pub(super) fn pi() -> Rational {
    // The text above is a number.
    rational::parse(PI).unwrap_or(Rational::ZERO)
}

/// A rounded number differs from the one that is meant by less than this times itself, a tangent t by less than this times
/// 1 + t², a hyperbolic one by less than this times 1 − |t|.
pub(super) fn precision() -> Rational {
    Rational::from(10).pow(50).recip().unwrap_or(Rational::ZERO)
}

impl Number {
    /// The number that a text such as `-1/3`, `0.62`, `pi/2` or `2*pi/3` stands for.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        if let Some(rational) = rational::parse(text) {
            return Some(Self { rational, turns: Rational::ZERO });
        }
        let (before, after) = text.split_once("pi").or_else(|| text.split_once('π'))?;
        let before = before.trim();
        let factor = match before.strip_suffix('*').unwrap_or(before).trim() {
            "" if !before.ends_with('*') => Rational::ONE,
            "-" | "−" if !before.ends_with('*') => Rational::from(-1),
            factor => rational::parse(factor)?,
        };
        let after = after.trim();
        let turns = match (after.strip_prefix('/'), after.strip_prefix('*')) {
            _ if after.is_empty() => factor,
            (Some(below), _) => factor.checked_div(&rational::parse(below.trim())?)?,
            (_, Some(times)) => &factor * &rational::parse(times.trim())?,
            (None, None) => return None,
        };
        Some(Self { rational: Rational::ZERO, turns })
    }

    /// A rational number.
    pub(super) const fn rational(rational: Rational) -> Self {
        Self { rational, turns: Rational::ZERO }
    }

    /// The number, if it is rational.
    pub(super) fn exact(&self) -> Option<&Rational> {
        self.turns.is_zero().then_some(&self.rational)
    }

    /// The number, rounded if it is not rational.
    pub(crate) fn value(&self) -> Rational {
        if self.turns.is_zero() { self.rational.clone() } else { &self.rational + &(&self.turns * &pi()) }
    }

    /// How far the value is at most from the number.
    pub(super) fn error(&self) -> Rational {
        // π is written with 62 digits.
        &self.turns.abs() * &precision()
    }

    /// How many of these steps there are from one number to another, fewer than 0 from a greater one to a smaller one.
    pub(crate) fn steps(&self, low: &Self, high: &Self) -> Option<i64> {
        // A last step that ends at `high` may be rounded up.
        let slack = Rational::new(1, 1_000_000_000_000_000_000);
        let steps = (&high.value() - &low.value()).checked_div(&self.value())?;
        (&steps + &slack).floor().to_i64()
    }

    /// The number at k of n equal steps from one to another.
    pub(crate) fn between(low: &Self, high: &Self, k: i64, n: i64) -> Self {
        let part = Rational::new(k, n);
        let at = |a: &Rational, b: &Rational| a + &(&(b - a) * &part);
        Self { rational: at(&low.rational, &high.rational), turns: at(&low.turns, &high.turns) }
    }

    /// The value of the variable that stands for a shape parameter: of an angle its tangent, or the part of the way between the
    /// tangents at the ends; `None` where it has none.
    pub(crate) fn of_parameter(&self, angle: Option<&Angle>, analytic: &Analytic) -> Option<Rational> {
        let Some(angle) = angle else { return Some(self.value()) };
        let phase = self.phase(&angle.rate, angle.turns, &angle.shift);
        let (x, _) = match angle.kind {
            Kind::Circular if !phase.is_within_a_quarter_turn() => return None,
            Kind::Circular => phase.tan()?,
            Kind::Hyperbolic => phase.tanh()?,
            Kind::Linear => return Some(self.value()),
        };
        let [low, width] = [analytic.number(&angle.low)?, analytic.number(&angle.width)?];
        if low.is_zero() && width.is_one() {
            return Some(x);
        }
        // At the ends all of these are rounded.
        let near = Rational::from(10).pow(18).recip()?;
        let part = (&x - &low).checked_div(&width)?;
        let end = [Rational::ZERO, Rational::ONE].into_iter().find(|end| (&part - end).abs() < near);
        Some(end.unwrap_or(part))
    }

    /// This number and k steps.
    pub(crate) fn plus(&self, step: &Self, k: i64) -> Self {
        let k = Rational::from(k);
        let add = |a: &Rational, b: &Rational| a + &(b * &k);
        Self { rational: add(&self.rational, &step.rational), turns: add(&self.turns, &step.turns) }
    }

    /// v·(s − shift) of an angle s, with shift and perhaps v in multiples of π.
    pub(super) fn phase(&self, rate: &Rational, turns: bool, shift: &Rational) -> Self {
        if turns {
            // v is a multiple of π, and so is the product where s is rational.
            let known = &self.value() - shift;
            return match self.exact() {
                Some(_) => Self { rational: Rational::ZERO, turns: rate * &known },
                None => Self::rational(&(rate * &known) * &pi()),
            };
        }
        Self { rational: rate * &self.rational, turns: rate * &(&self.turns - shift) }
    }

    /// Whether an angle lies between −π/2 and π/2, these included.
    pub(super) fn is_within_a_quarter_turn(&self) -> bool {
        let size = if self.rational.is_zero() {
            self.turns.abs()
        } else {
            &self.value().abs() * &pi().recip().unwrap_or(Rational::ZERO)
        };
        size <= Rational::new(1, 2)
    }

    /// The tangent, and how far it is at most from the true one, 0 at multiples of π/4; `None` where there is none.
    pub(super) fn tan(&self) -> Option<(Rational, Rational)> {
        if self.rational.is_zero() {
            let quarters = &self.turns * &Rational::from(4);
            match quarters.to_i64().map(|q| q.rem_euclid(4)) {
                Some(0) => return Some((Rational::ZERO, Rational::ZERO)),
                Some(1) => return Some((Rational::ONE, Rational::ZERO)),
                Some(2) => return None,
                Some(_) => return Some((Rational::from(-1), Rational::ZERO)),
                None => {}
            }
        }
        // tan(x + kπ) = tan(x).
        let turns = (&self.value() * &pi().recip()?).floor();
        let x = &self.value() - &(&turns * &pi());
        let (sin, cos) = series(&x, -1);
        let tangent = rounded(&sin.checked_div(&cos)?);
        // The terms of sin x have their digits for small x too, if nothing was taken from x.
        let scale =
            if self.turns.is_zero() && turns.is_zero() { x.abs().min(Rational::ONE) } else { Rational::ONE };
        let error = &(&Rational::ONE + &(&tangent * &tangent)) * &(&scale * &precision());
        Some((tangent, error))
    }

    /// The hyperbolic tangent, and how far it is at most from the true one.
    pub(super) fn tanh(&self) -> Option<(Rational, Rational)> {
        let x = self.value();
        if x.is_zero() {
            return Some((Rational::ZERO, Rational::ZERO));
        }
        // tanh |x| = (e^2|x| − 1)/(e^2|x| + 1) = 1 − 2/(e^2|x| + 1); next to 1 it is the distance that has to have its digits.
        let square = exp(&(&x + &x).abs())?;
        let sum = &square + &Rational::ONE;
        let size = if square > Rational::from(3) {
            &Rational::ONE - &rounded(&Rational::from(2).checked_div(&sum)?)
        } else {
            rounded(&(&square - &Rational::ONE).checked_div(&sum)?)
        };
        let error = &(&Rational::ONE - &size) * &precision();
        Some((if x.is_negative() { -&size } else { size }, error))
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.turns.is_zero() {
            return write!(f, "{}", self.rational);
        }
        if !self.rational.is_zero() {
            write!(f, "{} + ", self.rational)?;
        }
        let (above, below) = (self.turns.numer(), self.turns.denom());
        match above.to_i64() {
            Some(1) => f.write_str("pi")?,
            Some(-1) => f.write_str("-pi")?,
            _ => write!(f, "{above}*pi")?,
        }
        if below.is_one() { Ok(()) } else { write!(f, "/{below}") }
    }
}

/// To 55 digits after the point; of small numbers to as many.
fn rounded(x: &Rational) -> Rational {
    let mut scale = Rational::from(10).pow(55);
    // A binary digit is a third of a decimal one, so that small numbers keep their digits.
    let small = x.denom().bits().saturating_sub(x.numer().bits());
    scale = &scale * &Rational::from(2).pow(u32::try_from(small).unwrap_or(0).min(4000));
    (&(x * &scale) + &Rational::new(1, 2)).floor().checked_div(&scale).unwrap_or(Rational::ZERO)
}

/// The sums of the odd and of the even terms of Σ s^⌊k/2⌋ x^k/k!: sin and cos for s = −1, sinh and cosh for s = 1.
fn series(x: &Rational, sign: i64) -> (Rational, Rational) {
    let mut sums = [Rational::ZERO, Rational::ZERO];
    let mut term = Rational::ONE;
    let tiny = Rational::from(10).pow(60).recip().unwrap_or(Rational::ZERO);
    let mut k = 0_i64;
    while k < 8 || term.abs() > tiny {
        let signed = if k % 4 >= 2 { &term * &Rational::from(sign) } else { term.clone() };
        let slot = usize::from(k % 2 == 0);
        sums[slot] = &sums[slot] + &signed;
        k += 1;
        term = rounded(&(&(&term * x) * &Rational::new(1, k)));
    }
    let [odd, even] = sums;
    (odd, even)
}

/// The largest exponent of which a power of e is computed.
const MAX_EXPONENT: i64 = 1000;

/// e^x, rounded; `None` for very large |x|.
pub(super) fn exp(x: &Rational) -> Option<Rational> {
    if x.abs() > Rational::from(MAX_EXPONENT) {
        return None;
    }
    if x.is_negative() {
        return exp(&-x)?.recip();
    }
    // e^x = (e^(x/2^k))^(2^k)
    let halvings = x.floor().to_i64().map_or(0, |n| i64::BITS - n.leading_zeros());
    let part = x.checked_div(&Rational::from(2).pow(halvings))?;
    let (odd, even) = series(&part, 1);
    let mut power = &odd + &even;
    for _ in 0..halvings {
        power = rounded(&(&power * &power));
    }
    Some(power)
}

/// The number with a tangent, or with a hyperbolic one, rounded.
pub(super) fn inverse(tangent: &Rational, hyperbolic: bool) -> Option<Rational> {
    let near = tangent.to_f64();
    let mut x = rational::parse(&format!("{:.25}", if hyperbolic { near.atanh() } else { near.atan() }))?;
    for _ in 0..3 {
        let at = Number::rational(x.clone());
        let (value, slope) = if hyperbolic {
            let (value, _) = at.tanh()?;
            let slope = &Rational::ONE - &(&value * &value);
            (value, slope)
        } else {
            let (value, _) = at.tan()?;
            let slope = &Rational::ONE + &(&value * &value);
            (value, slope)
        };
        x = rounded(&(&x + &(tangent - &value).checked_div(&slope)?));
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(x: &Rational, text: &str) {
        let tiny = Rational::from(10).pow(40).recip().expect("not zero");
        assert!((x - &rational::parse(text).expect("a number")).abs() < tiny, "{}", x.to_f64());
    }

    #[test]
    fn numbers_as_they_are_typed() {
        for (text, shown) in [
            ("pi", "pi"),
            ("-pi/2", "-pi/2"),
            ("2*pi/3", "2*pi/3"),
            ("2/3*π", "2*pi/3"),
            ("0.5", "1/2"),
            ("pi*3/4", "pi*3/4"),
        ] {
            let parsed = Number::parse(text).map(|n| n.to_string());
            if text == "pi*3/4" {
                assert_eq!(parsed.as_deref(), Some("3*pi/4"));
            } else {
                assert_eq!(parsed.as_deref(), Some(shown));
            }
        }
        for wrong in ["", "p", "*pi", "pi/0", "pi2", "pi+1", "pipi", "-", "e"] {
            assert_eq!(Number::parse(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn functions_to_many_digits() {
        let of = |text: &str| Number::parse(text).expect("a number");
        assert_eq!(of("pi/4").tan(), Some((Rational::ONE, Rational::ZERO)));
        assert_eq!(of("pi/2").tan(), None);
        near(&of("pi/3").tan().expect("there is one").0, "1.7320508075688772935274463415058723669428");
        near(&of("4*pi/3").tan().expect("there is one").0, "1.7320508075688772935274463415058723669428");
        near(&of("1/2").tan().expect("there is one").0, "0.5463024898437905132551794657802853832976");
        near(&of("-1/2").tanh().expect("there is one").0, "-0.4621171572600097585023184836436725487302");
        // Next to 1 it is the distance that has digits: 1 - tanh(150) is about 2/e^300.
        let apart = &Rational::ONE - &of("150").tanh().expect("there is one").0;
        let product = &apart * &exp(&Rational::from(300)).expect("there is one");
        near(&product, "2");
        near(&exp(&Rational::ONE).expect("small"), "2.7182818284590452353602874713526624977572");
        near(&exp(&Rational::from(-3)).expect("small"), "0.0497870683678639429793424156500617766317");
        near(
            &inverse(&Rational::new(1, 2), false).expect("finite"),
            "0.4636476090008061162142562314612144020285",
        );
        near(
            &inverse(&Rational::new(1, 2), true).expect("finite"),
            "0.5493061443340548456976226184612628523237",
        );
    }
}
