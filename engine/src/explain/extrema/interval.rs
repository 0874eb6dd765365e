//! Numbers between bounds.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use basis_prover::collections::list::Listed;

/// The bits behind the point to which bounds are rounded away from each other.
const BITS: u32 = 90;

/// All numbers from one to another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Interval {
    pub(super) low: Rational,
    pub(super) high: Rational,
}

impl Interval {
    pub(super) fn new(low: Rational, high: Rational) -> Self {
        let unit = Rational::from(2).pow(BITS);
        let down = |x: &Rational| (x * &unit).floor().checked_div(&unit);
        let low = if low.bits() > 2 * u64::from(BITS) { down(&low).unwrap_or(low) } else { low };
        let is_long = high.bits() > 2 * u64::from(BITS);
        let high = if is_long { down(&-&high).map_or(high, |x| -x) } else { high };
        Self { low, high }
    }

    pub(super) fn point(x: &Rational) -> Self {
        Self { low: x.clone(), high: x.clone() }
    }

    /// −1, 0 or 1 where all numbers have this sign.
    pub(super) fn sign(&self) -> Option<i32> {
        (self.low.signum() == self.high.signum()).then(|| self.low.signum())
    }

    pub(super) fn middle(&self) -> Rational {
        &(&self.low + &self.high) * &Rational::new(1, 2)
    }

    pub(super) fn add(&self, other: &Self) -> Self {
        Self::new(&self.low + &other.low, &self.high + &other.high)
    }

    pub(super) fn mul(&self, other: &Self) -> Self {
        let products = [&self.low, &self.high].map(|x| [x * &other.low, x * &other.high]).concat();
        let (low, high) = (products.iter().min(), products.iter().max());
        Self::new(low.cloned().unwrap_or(Rational::ZERO), high.cloned().unwrap_or(Rational::ZERO))
    }

    /// `None` where a number of the other one is 0.
    pub(super) fn div(&self, other: &Self) -> Option<Self> {
        if other.sign()? == 0 {
            return None;
        }
        Some(self.mul(&Self::new(other.high.recip()?, other.low.recip()?)))
    }
}

/// The values of a polynomial; `None` where a variable has no bounds.
fn of_poly(p: &Poly, at: &[(Var, Interval)]) -> Option<Interval> {
    let mut sum = Interval::point(&Rational::ZERO);
    for (m, c) in p.terms() {
        let mut product = Interval::point(c);
        for (k, e) in m.exponents().into_iter().enumerate().filter(|(_, e)| *e > 0) {
            let x = &at.iter().find(|(var, _)| var.0 == k)?.1;
            product = (0..e).fold(product, |product, _| product.mul(x));
        }
        sum = sum.add(&product);
    }
    Some(sum)
}

/// The values of a quotient; `None` where its denominator may be 0, or a variable has no bounds.
pub(super) fn values(f: &Fraction, at: &[(Var, Interval)]) -> Option<Interval> {
    let known = at.iter().filter(|(var, _)| f.depends_on(*var)).cloned().listed();
    of_poly(f.numer(), &known)?.div(&of_poly(f.denom(), &known)?)
}
