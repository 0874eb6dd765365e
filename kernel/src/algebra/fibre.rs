//! Polynomials in one variable in scaled Bernstein form: Σ βₖ sᵏ rⁿ⁻ᵏ with r + s = 1, s running from 0 to 1.
//!
//! βₖ is the Bernstein coefficient times the binomial coefficient n over k: the same signs, but whole numbers stay
//! whole, and a factor s or r shows as a zero at an end. Forms are determined up to a positive factor.

use num_bigint::{BigInt, Sign};
use num_integer::Integer as _;
use num_traits::One as _;

use super::done::did;
use super::rational::{Rational, Words};
use crate::collections::list::Mapped;

/// A step from one basis to another; changes of basis are short lists of them.
#[derive(Clone, Debug)]
pub enum Step {
    /// Replaces x by x + h in a sum of powers of x.
    Shift(Rational),
    /// Multiplies cₖ by the k-th power of a number.
    Powers(Rational),
    /// Puts cₖ and cₙ₋ₖ in each other's place.
    Reverse,
}
use Step::{Powers, Reverse, Shift};

/// From powers of x to the form on low ≤ x ≤ high, with x = low·r + high·s.
///
/// The factor is dⁿ for the product d of the denominators of the ends.
pub fn on_interval(low: &Rational, high: &Rational) -> Vec<Step> {
    let d = &low.denom() * &high.denom();
    let (a, b) = (low * &d, high * &d);
    let width = &b - &a;
    // Last eₖ sᵏ (r + s)ⁿ⁻ᵏ.
    vec![Reverse, Powers(d), Reverse, Shift(a), Powers(width), Reverse, Shift(Rational::ONE), Reverse]
}

/// From powers of x to the form on x ≥ low, with x = low + s/r, of p(x)·rⁿ.
pub fn upwards(low: &Rational) -> Vec<Step> {
    let d = low.denom();
    vec![Reverse, Powers(d.clone()), Reverse, Shift(low.numer()), Powers(d)]
}

/// From powers of x to the form on x ≤ high, with x = high − r/s, of p(x)·sⁿ.
pub fn downwards(high: &Rational) -> Vec<Step> {
    let d = high.denom();
    vec![Reverse, Powers(d.clone()), Reverse, Shift(high.numer()), Powers(-d), Reverse]
}

/// The form on the half 0 ≤ s ≤ 1/2, times 2ⁿ: s becomes s and r becomes 2r + s.
pub fn lower_half() -> Vec<Step> {
    vec![Reverse, Shift(Rational::ONE), Powers(Rational::from(2)), Reverse]
}

/// The form on the half 1/2 ≤ s ≤ 1, times 2ⁿ: s becomes 2s + r and r stays.
pub fn upper_half() -> Vec<Step> {
    vec![Shift(Rational::ONE), Powers(Rational::from(2))]
}

/// The form on x ≤ m of the form on an infinite side that is cut at the m of s = 1/2: s stays and r becomes r + s.
pub fn lower_part() -> Vec<Step> {
    vec![Reverse, Shift(Rational::ONE), Reverse]
}

/// The form on x ≥ m of the form on an infinite side that is cut at the m of s = 1/2: s becomes s + r and r stays.
pub fn upper_part() -> Vec<Step> {
    vec![Shift(Rational::ONE)]
}

/// Takes the steps.
pub fn apply(steps: &[Step], c: &mut [Rational]) {
    Change::new(steps, c.iter(), c.len()).apply(c);
}

/// Steps that are taken for many lists of numbers.
#[derive(Debug)]
pub(super) struct Change<'a> {
    steps: &'a [Step],
    words: Option<(Words, Vec<WordStep>)>,
    buffer: Vec<i64>,
}

impl<'a> Change<'a> {
    /// For these numbers, in lists of at most this length.
    pub(super) fn new<'n>(
        steps: &'a [Step],
        numbers: impl Iterator<Item = &'n Rational>,
        len: usize,
    ) -> Self {
        let words =
            Words::of(numbers).and_then(|words| Some((words, word_steps(steps, len, words.largest)?)));
        Self { steps, words, buffer: Vec::with_capacity(len) }
    }

    /// Takes the steps for one list.
    pub(super) fn apply(&mut self, c: &mut [Rational]) {
        if let Some((words, steps)) = &self.words {
            self.buffer.clear();
            for c in &*c {
                self.buffer.push(words.word(c));
            }
            apply_words(steps, &mut self.buffer);
            for (k, c) in c.iter_mut().enumerate() {
                *c = words.number(self.buffer[k]);
            }
            return;
        }
        apply_whole(self.steps, c);
    }
}

/// Multiplies cₖ by the k-th power of a number.
fn powers_of(c: &mut [BigInt], factor: &BigInt) {
    if factor.is_one() {
        return;
    }
    let mut power = BigInt::from(1);
    for c in c {
        *c *= &power;
        power *= factor;
    }
}

/// Replaces x by x + h in a sum of powers of x.
fn shift(c: &mut [BigInt], h: &BigInt) {
    for i in 0..c.len().saturating_sub(1) {
        for j in (i..c.len() - 1).rev() {
            let (low, high) = c.split_at_mut(j + 1);
            if h.is_one() {
                low[j] += &high[0];
            } else if high[0].sign() != Sign::NoSign {
                low[j] += &high[0] * h;
            }
        }
    }
    did((c.len() * c.len()) as u64 / 4 * (1 + c.first().map_or(0, |c| c.bits() / 64)));
}

/// Takes the steps by way of whole numbers over a common denominator: without common divisors after every sum.
///
/// With x = y/q the sum Σ cₖ xᵏ is q⁻ⁿ Σ cₖ qⁿ⁻ᵏ yᵏ, and x + p/q is (y + p)/q.
fn apply_whole(steps: &[Step], c: &mut [Rational]) {
    let mut denom = BigInt::from(1);
    for c in &*c {
        if !c.is_integer() {
            denom = denom.lcm(&c.parts().1);
        }
    }
    let mut whole = c.mapped(|c| {
        let (n, d) = c.parts();
        &denom / d * n
    });
    for step in steps {
        let (Shift(by) | Powers(by)) = step else {
            whole.reverse();
            continue;
        };
        let (p, q) = by.parts();
        if !q.is_one() {
            whole.reverse();
            powers_of(&mut whole, &q);
            whole.reverse();
            denom *= q.pow(c.len().saturating_sub(1) as u32);
        }
        if let Powers(_) = step {
            powers_of(&mut whole, &p);
        } else if p.sign() != Sign::NoSign {
            shift(&mut whole, &p);
            powers_of(&mut whole, &q);
        }
    }
    for (c, whole) in c.iter_mut().zip(whole) {
        *c = if denom.is_one() { Rational::from(whole) } else { Rational::ratio(whole, denom.clone()) };
    }
}

/// A [`Step`] in machine words.
#[derive(Clone, Copy, Debug)]
pub(super) enum WordStep {
    Shift(i64),
    Powers(i64),
    Reverse,
}

/// The steps in machine words for `len` coefficients up to `largest`, those that do nothing left out; `None` where
/// something could overflow.
pub(super) fn word_steps(steps: &[Step], len: usize, largest: u64) -> Option<Vec<WordStep>> {
    let mut result: Vec<WordStep> = Vec::with_capacity(steps.len());
    let mut bound = largest.max(1);
    for step in steps {
        // How much larger a coefficient can become for each degree.
        let growth = match step {
            Shift(h) if h.is_zero() => continue,
            Powers(factor) if factor.is_one() => continue,
            Shift(h) => {
                result.push(WordStep::Shift(h.to_i64()?));
                h.to_i64()?.unsigned_abs().checked_add(1)?
            }
            Powers(factor) => {
                result.push(WordStep::Powers(factor.to_i64()?));
                factor.to_i64()?.unsigned_abs().max(1)
            }
            Reverse => {
                if let Some(WordStep::Reverse) = result.last() {
                    result.pop();
                } else {
                    result.push(WordStep::Reverse);
                }
                1
            }
        };
        for _ in 1..len {
            if growth > 1 {
                bound = bound.checked_mul(growth)?;
            }
        }
    }
    i64::try_from(bound).is_ok().then_some(result)
}

/// Takes the steps, which [`word_steps`] has found not to overflow. Plain loops: this runs unoptimised.
pub(super) fn apply_words(steps: &[WordStep], c: &mut [i64]) {
    let n = c.len();
    for step in steps {
        match *step {
            WordStep::Shift(h) => {
                let mut i = 0;
                while i + 1 < n {
                    let mut j = n - 1;
                    while j > i {
                        c[j - 1] += h * c[j];
                        j -= 1;
                    }
                    i += 1;
                }
            }
            WordStep::Powers(factor) => {
                let (mut k, mut power) = (1, 1);
                while k < n {
                    power *= factor;
                    c[k] *= power;
                    k += 1;
                }
            }
            WordStep::Reverse => {
                let mut k = 0;
                while k < n / 2 {
                    c.swap(k, n - 1 - k);
                    k += 1;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(c: &[i64]) -> Vec<Rational> {
        c.iter().map(|c| Rational::from(*c)).collect()
    }
    fn r(n: i64, d: i64) -> Rational {
        Rational::new(n, d)
    }
    fn value(form: &[Rational], s: &Rational) -> Rational {
        let n = form.len() - 1;
        let r = &Rational::ONE - s;
        form.iter()
            .enumerate()
            .map(|(k, c)| &(c * &s.pow(k as u32)) * &r.pow((n - k) as u32))
            .fold(Rational::ZERO, |a, b| a + b)
    }
    fn power_sum(c: &[Rational], x: &Rational) -> Rational {
        c.iter().rev().fold(Rational::ZERO, |v, c| &(&v * x) + c)
    }

    #[test]
    fn forms_have_the_values_of_the_polynomial() {
        let p = list(&[3, -1, 4, 0, -5]);
        let s = r(2, 7);
        let opposite = &Rational::ONE - &s;
        let (low, high) = (r(-1, 2), r(5, 3));
        let mut form = p.clone();
        apply(&on_interval(&low, &high), &mut form);
        let x = &(&low * &opposite) + &(&high * &s);
        assert_eq!(value(&form, &s), &power_sum(&p, &x) * &r(6, 1).pow(4));
        let mut form = p.clone();
        apply(&upwards(&low), &mut form);
        let x = &low + &(&s / &opposite);
        assert_eq!(value(&form, &s), &(&power_sum(&p, &x) * &opposite.pow(4)) * &r(2, 1).pow(4));
        let mut form = p.clone();
        apply(&downwards(&high), &mut form);
        let x = &high - &(&opposite / &s);
        assert_eq!(value(&form, &s), &(&power_sum(&p, &x) * &s.pow(4)) * &r(3, 1).pow(4));
    }

    #[test]
    fn halves_have_the_values_of_the_whole() {
        let form = list(&[3, -1, 4, 0, -5]);
        let s = r(2, 7);
        let (mut low, mut high) = (form.clone(), form.clone());
        apply(&lower_half(), &mut low);
        apply(&upper_half(), &mut high);
        assert_eq!(value(&low, &s), &value(&form, &r(1, 7)) * &r(16, 1));
        assert_eq!(value(&high, &s), &value(&form, &r(9, 14)) * &r(16, 1));
    }

    #[test]
    fn long_numbers_take_the_same_steps() {
        // A large factor makes the coefficients too long for machine words, and changes nothing else.
        let huge = Rational::from(i64::MAX).pow(2);
        let p = [r(3, 2), r(-1, 3), r(0, 1), r(5, 1), r(-7, 6), r(1, 1)];
        let (low, high) = (r(-2, 3), r(3, 1));
        let all = [on_interval(&low, &high), upwards(&low), downwards(&high), lower_half(), upper_part()];
        for steps in all.iter().chain([
            &vec![Shift(r(-1, 2)), Powers(r(2, 3)), Reverse, Shift(r(3, 4))],
            &vec![Shift(r(1 << 40, 1))],
        ]) {
            let (mut short, mut long) = (p.to_vec(), p.iter().map(|c| c * &huge).collect::<Vec<_>>());
            apply(steps, &mut short);
            apply(steps, &mut long);
            assert_eq!(short.iter().map(|c| c * &huge).collect::<Vec<_>>(), long, "{steps:?}");
        }
        let (mut form, x) = (p.to_vec(), r(5, 7));
        apply(&[Shift(r(-1, 2)), Powers(r(2, 3))], &mut form);
        assert_eq!(power_sum(&form, &x), power_sum(&p, &(&(&x * &r(2, 3)) - &r(1, 2))));
    }
}
