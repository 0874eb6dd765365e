//! Dense polynomials in one variable over the rationals.

use super::poly::{Poly, Var};
use super::rational::Rational;
use super::work::Work;
use crate::collections::list::Mapped;

/// c₀ + c₁ x + … + cₙ xⁿ with cₙ ≠ 0; no coefficient at all for 0.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Univariate {
    coefficients: Vec<Rational>,
}

impl Univariate {
    /// The polynomial with these coefficients, constant first.
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The polynomial with these whole coefficients, constant first.
    pub fn integers(coefficients: &[i64]) -> Self {
        Self::new(coefficients.mapped(|c| Rational::from(*c)))
    }

    /// The polynomial in one variable that `poly` is; `None` if another variable occurs.
    pub fn from_poly(poly: &Poly, var: Var) -> Option<Self> {
        let mut coefficients = vec![Rational::ZERO; poly.degree(var) as usize + 1];
        for (m, c) in poly.terms() {
            let e = m.exponent(var);
            if m.total_degree() != u32::from(e) {
                return None;
            }
            coefficients[usize::from(e)] = c.clone();
        }
        Some(Self::new(coefficients))
    }

    /// The coefficients, constant first.
    pub fn coefficients(&self) -> &[Rational] {
        &self.coefficients
    }

    /// The degree; 0 also for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Whether the polynomial is 0.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// Whether no variable occurs.
    pub fn is_constant(&self) -> bool {
        self.coefficients.len() <= 1
    }

    /// The coefficient of the highest power; 0 for the zero polynomial.
    pub fn leading(&self) -> Rational {
        self.coefficients.last().cloned().unwrap_or(Rational::ZERO)
    }

    /// The size of the largest coefficient in bits.
    pub fn max_bits(&self) -> u64 {
        self.coefficients.iter().map(Rational::bits).max().unwrap_or(0)
    }

    /// The sign of the value at a number: −1, 0 or 1.
    pub fn sign_at(&self, x: &Rational) -> i32 {
        // Whole numbers only: dⁿ·p(n/d) = Σ cₖ nᵏ dⁿ⁻ᵏ has the same sign.
        let (n, d) = (x.numer(), x.denom());
        let mut value = Rational::ZERO;
        let mut power = Rational::ONE;
        for c in self.coefficients.iter().rev() {
            value = &(&value * &n) + &(c * &power);
            power *= &d;
        }
        value.signum()
    }

    /// Counts the work of the sign of the value at a number.
    pub fn spend_sign(&self, x: &Rational, work: &mut Work) -> Option<()> {
        let n = self.degree() as u64 + 1;
        let words = 1 + (self.max_bits() + n * x.bits()) / 64;
        work.spend((2 * n * words).saturating_mul(1 + x.bits() / 64))
    }

    /// The sign as x goes to +∞ (`up`) or −∞.
    pub fn sign_at_infinity(&self, up: bool) -> i32 {
        let sign = self.leading().signum();
        if up || self.degree().is_multiple_of(2) { sign } else { -sign }
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let scaled = |(k, c): (usize, &Rational)| c * &Rational::from(k as i64);
        Self::new(self.coefficients.iter().enumerate().skip(1).map(scaled).collect())
    }

    /// The polynomial divided by a positive number, so that the coefficients are whole without common factor.
    pub fn primitive(&self) -> Self {
        let mut content = Rational::ZERO;
        for c in &self.coefficients {
            content = content.gcd(c);
            if content.is_one() && self.coefficients.iter().all(Rational::is_integer) {
                return self.clone();
            }
        }
        match content.recip() {
            Some(factor) => self.scale(&factor),
            None => self.clone(),
        }
    }

    /// The polynomial with whole coefficients without common factor, the leading one positive.
    pub fn normalized(&self) -> Self {
        let p = self.primitive();
        if p.leading().is_negative() { p.scale(&Rational::from(-1)) } else { p }
    }

    /// The polynomial times a number.
    pub fn scale(&self, factor: &Rational) -> Self {
        Self::new(self.coefficients.mapped(|c| c * factor))
    }

    /// The sum.
    pub fn add(&self, other: &Self) -> Self {
        let mut sum = self.coefficients.clone();
        sum.resize(sum.len().max(other.coefficients.len()), Rational::ZERO);
        for (x, c) in sum.iter_mut().zip(&other.coefficients) {
            *x += c;
        }
        Self::new(sum)
    }

    /// The remainder on division by `divisor`; `None` when the divisor is 0 or the work is spent.
    pub fn modulo(&self, divisor: &Self, work: &mut Work) -> Option<Self> {
        let (n, lead) = (divisor.degree(), divisor.leading());
        let inverse = lead.recip()?;
        let mut rest = self.coefficients.clone();
        while rest.len() > n {
            let top = rest.pop()?;
            let factor = &top * &inverse;
            let shift = rest.len() - n;
            work.spend_fractions(factor.bits() + divisor.max_bits())?;
            for (k, c) in divisor.coefficients.iter().take(n).enumerate() {
                work.spend_fractions(factor.bits() + c.bits())?;
                rest[k + shift] -= &(c * &factor);
            }
        }
        Some(Self::new(rest))
    }

    /// The product.
    pub fn mul(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::default();
        }
        let mut product = vec![Rational::ZERO; self.coefficients.len() + other.coefficients.len() - 1];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j] += &(a * b);
            }
        }
        Self::new(product)
    }

    /// The remainder of a positive multiple of the polynomial on division by `divisor`, primitive; `None` when
    /// the divisor is 0 or the work is spent.
    ///
    /// The sign is that of the remainder of the polynomial itself.
    pub fn remainder(&self, divisor: &Self, work: &mut Work) -> Option<Self> {
        let (n, lead) = (divisor.degree(), divisor.leading());
        if lead.is_zero() {
            return None;
        }
        let mut rest = self.coefficients.clone();
        // A product of long numbers takes as many operations as the product of their lengths.
        let words = |bits: u64| 1 + bits / 64;
        let (own, other) = (words(self.max_bits()), words(divisor.max_bits()));
        let product = own + other + own * other / 4;
        let scale = lead.abs();
        while rest.len() > n {
            work.spend(2 * rest.len() as u64 * product)?;
            // rest := |lead|·rest − sign(lead)·top·xᵏ·divisor
            let Some(top) = rest.pop() else { break };
            let shift = rest.len() - n;
            if top.is_zero() {
                continue;
            }
            work.spend_fractions(top.bits() + scale.bits())?;
            let common = top.gcd(&scale);
            let (times, minus) = (&scale / &common, &top / &common);
            let minus = if lead.is_negative() { -minus } else { minus };
            if !times.is_one() {
                for c in &mut rest {
                    *c *= &times;
                }
            }
            for (k, c) in divisor.coefficients.iter().take(n).enumerate() {
                rest[k + shift] -= &(c * &minus);
            }
        }
        let rest = Self::new(rest);
        let size = words(rest.max_bits());
        work.spend(rest.coefficients.len() as u64 * size * size / 4)?;
        Some(rest.primitive())
    }

    /// The quotient, if `divisor` divides without remainder.
    pub fn div_exact(&self, divisor: &Self) -> Option<Self> {
        let (n, lead) = (divisor.degree(), divisor.leading());
        if lead.is_zero() {
            return None;
        }
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![Rational::ZERO; (rest.len() + 1).saturating_sub(divisor.coefficients.len())];
        while rest.len() > n {
            let Some(top) = rest.pop() else { break };
            let shift = rest.len() - n;
            if top.is_zero() {
                continue;
            }
            let factor = &top / &lead;
            for (k, c) in divisor.coefficients.iter().take(n).enumerate() {
                rest[k + shift] -= &(c * &factor);
            }
            quotient[shift] = factor;
        }
        rest.iter().all(Rational::is_zero).then(|| Self::new(quotient))
    }

    /// The greatest common divisor, normalised; `None` when the work is spent.
    pub fn gcd(&self, other: &Self, work: &mut Work) -> Option<Self> {
        let (mut a, mut b) = (self.normalized(), other.normalized());
        if a.degree() < b.degree() {
            core::mem::swap(&mut a, &mut b);
        }
        while !b.is_zero() {
            if b.is_constant() {
                return Some(Self::integers(&[1]));
            }
            let rest = a.remainder(&b, work)?;
            (a, b) = (b, rest);
        }
        Some(a.normalized())
    }

    /// The product of the different factors, p/gcd(p, p′), normalised; `None` when the work is spent.
    pub fn square_free_part(&self, work: &mut Work) -> Option<Self> {
        let p = self.normalized();
        let common = p.gcd(&p.derivative(), work)?;
        if common.is_constant() {
            return Some(p);
        }
        let words = 1 + (p.max_bits() + common.max_bits()) / 64;
        work.spend((p.degree() * common.degree()) as u64 * words * words)?;
        Some(p.div_exact(&common)?.normalized())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(c: &[i64]) -> Univariate {
        Univariate::integers(c)
    }

    #[test]
    fn evaluates_signs_without_fractions() {
        let q = p(&[-2, 0, 1]);
        assert_eq!(q.sign_at(&Rational::new(7, 5)), -1);
        assert_eq!(q.sign_at(&Rational::new(3, 2)), 1);
        assert_eq!(p(&[0, -1]).sign_at_infinity(false), 1);
    }

    #[test]
    fn divides_and_finds_common_factors() {
        let work = &mut Work::unlimited();
        let a = p(&[1, 1]).mul(&p(&[1, 1])).mul(&p(&[-3, 2]));
        let b = p(&[1, 1]).mul(&p(&[5, 7]));
        assert_eq!(a.gcd(&b, work), Some(p(&[1, 1])));
        assert_eq!(a.square_free_part(work), Some(p(&[1, 1]).mul(&p(&[-3, 2]))));
        assert_eq!(a.div_exact(&p(&[-3, 2])), Some(p(&[1, 2, 1])));
        assert_eq!(a.div_exact(&p(&[1, 3])), None);
        // The remainder of x² − 2 by −2x + 1 is −7/4, up to a positive factor.
        assert_eq!(p(&[-2, 0, 1]).remainder(&p(&[1, -2]), work), Some(p(&[-1])));
        assert_eq!(p(&[1]).remainder(&Univariate::default(), work), None);
    }

    #[test]
    fn ends_when_the_work_is_spent() {
        assert_eq!(p(&[1, 2, 3, 4, 5]).gcd(&p(&[2, 3, 4, 9]), &mut Work::new(3)), None);
    }
}
