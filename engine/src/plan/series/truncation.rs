//! How much is missing of power series in a shape value α that are cut off.
//!
//! A product of k sines and cosines of v·t has a power series in t with coefficients whose absolute values are at most
//! those of exp(k v t), sines and cosines of α likewise. So the terms of c·tʲαᵠ times such products whose powers in all
//! are above N are at most, with κ = k v|t/α| + m w,
//!
//! |c| |t/α|ʲ αʲ⁺ᵠ (κα)ⁿ/n! / (1 − κα/(n + 1)), n = N + 1 − j − q.

use std::rc::Rc;

use super::parameter::Source;
use super::waves::Waves;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// The work for the zeros of a function at the ends of the domain.
const WORK: u64 = 5_000_000;

/// What is missing is looked at more closely unless it is below 2 to the power of minus this.
const TINY: u32 = 64;

/// The terms that are looked at for it.
const FURTHER: usize = 24;

impl Source<'_> {
    /// Whether a function is 0 of these orders at the ends of the domain.
    pub(super) fn vanishes(&self, f: &Fraction, powers: [u32; 2]) -> Option<bool> {
        let work = &mut Work::new(WORK);
        for (is_upper, order) in [(false, powers[0]), (true, powers[1])] {
            let mut derivative = f.clone();
            for k in 0..order {
                if k > 0 {
                    derivative = self.family.derivative_within(&derivative, self.angle.var, work)?;
                }
                if !self.family.at_end(&derivative, is_upper, work)?.is_zero() {
                    return Some(false);
                }
            }
        }
        Some(true)
    }

    /// A number d for which dropped terms, from that power of α on, are at most d·yⁱ(1 − y)ʲ; `None` where they do not
    /// vanish so at the ends, or variables have no bounds.
    pub(super) fn dropped(&self, terms: &[Poly], powers: [u32; 2], from: usize) -> Option<Rational> {
        let ends = self.ends(powers);
        let mut power = self.largest.pow(from as u32);
        let mut sum = Rational::ZERO;
        for p in terms {
            if !self.is_bounded(p) {
                return None;
            }
            sum += &(&self.size(&p.div_exact(&ends)?) * &power);
            power = &power * &self.largest;
        }
        Some(sum)
    }

    /// A number d for which the terms above a total degree are at most d·yⁱ(1 − y)ʲ, if the whole vanishes so at the
    /// ends: by some more terms, and what is left.
    pub(super) fn beyond(
        &self,
        p: &Poly,
        powers: [u32; 2],
        last: usize,
        ends: [u32; 2],
        place: &Poly,
        known: &mut Vec<Rc<Waves>>,
    ) -> Option<Rational> {
        let rest = self.rest(p, powers, last, ends)?;
        if rest < Rational::from(2).pow(TINY).recip()? {
            return Some(rest);
        }
        let further = last + FURTHER;
        let more = &self.series(p, powers, further, known)[last + 1..];
        let dropped = self.dropped(&self.in_place(more, place), ends, last + 1)?;
        Some(&dropped + &self.rest(p, powers, further, ends)?)
    }

    /// A number d for which the terms above a total degree are at most d·yⁱ(1 − y)ʲ, if the whole vanishes so at the
    /// ends.
    ///
    /// A function that vanishes at y = 0 of the order i is at most yⁱ/i! times the largest value of its i-th
    /// derivative, which for αⁿ(t/α)ᵐ, m ≤ n, is at most nⁱ times as large, times a power of the slope of t/α.
    pub(super) fn rest(&self, p: &Poly, powers: [u32; 2], last: usize, [i, j]: [u32; 2]) -> Option<Rational> {
        if !self.is_bounded(p) {
            return None;
        }
        let reach = self.slopes[0].abs().max(self.slopes[1].abs());
        let slope = (&self.slopes[1] - &self.slopes[0]).abs().checked_div(&reach)?.max(Rational::ONE);
        let rates = [&self.angle.rate * &reach, self.end.rate.clone()];
        let kappa = rates.iter().zip(powers).fold(Rational::ZERO, |sum, (rate, power)| {
            &sum + &(&rate.abs() * &Rational::from(i64::from(power)))
        });
        let x = &kappa * &self.largest;
        let two = Rational::from(2);
        let mut most = Rational::ZERO;
        for (order, other) in [(i, j), (j, i)] {
            let mut sum = Rational::ZERO;
            for (m, c) in p.terms() {
                let [of_angle, of_end] =
                    [self.angle.itself, self.end.itself].map(|var| u32::from(m.exponent(var)));
                let n = (last + 1).checked_sub((of_angle + of_end) as usize).filter(|n| *n > 0)?;
                let power = |k: usize| Rational::from(k as i64);
                // Terms have at most this quotient.
                let grown = Rational::new(last as i64 + 2, last as i64 + 1).pow(order);
                let quotient = &x.checked_div(&power(n + 1))? * &grown;
                let factorial = (1..=n).fold(Rational::ONE, |product, k| &product * &power(k));
                let first = x.pow(n as u32).checked_div(&factorial)?;
                let all =
                    first.checked_div(&(&Rational::ONE - &quotient)).filter(|_| quotient < Rational::ONE)?;
                let size = &(&c.abs() * &self.of_others(m)) * &reach.pow(of_angle);
                sum += &(&(&size * &self.largest.pow(of_angle + of_end)) * &all);
            }
            let derivative = &slope.pow(order) * &Rational::from(last as i64 + 1).pow(order);
            // On the half next to the end the other factor is at least 2⁻ʲ.
            let here = &(&sum * &derivative) * &two.pow(other);
            most = most.max(here);
        }
        Some(most)
    }

    /// Whether all variables in a polynomial have bounds.
    fn is_bounded(&self, p: &Poly) -> bool {
        self.others.iter().all(|(var, most)| most.is_some() || !p.depends_on(*var))
    }
}
