//! Numbers between bounds.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use basis_prover::collections::list::Listed;

/// The bits behind the point to which bounds are rounded away from each other.
const BITS: u32 = 80;

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
    let mut powers: Vec<(usize, Vec<Interval>)> = Vec::new();
    for (var, x) in at {
        let mut own = vec![Interval::point(&Rational::ONE)];
        for k in 0..p.degree(*var) as usize {
            own.push(own[k].mul(x));
        }
        powers.push((var.0, own));
    }
    for (m, c) in p.terms() {
        let mut product = Interval::point(c);
        for (k, e) in m.exponents().into_iter().enumerate().filter(|(_, e)| *e > 0) {
            let (_, own) = powers.iter().find(|(var, _)| *var == k)?;
            product = product.mul(own.get(usize::from(e))?);
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

/// A polynomial in two variables whose coefficients are known between bounds.
struct InTwo(Vec<(usize, usize, Interval)>);

impl InTwo {
    fn new(p: &Poly, [x, y]: [Var; 2], others: &[(Var, Interval)]) -> Option<Self> {
        let mut all = Vec::new();
        for (i, part) in p.coefficients_in(x).iter().enumerate() {
            for (j, c) in part.coefficients_in(y).iter().enumerate().filter(|(_, c)| !c.is_zero()) {
                all.push((i, j, of_poly(c, others)?));
            }
        }
        Some(Self(all))
    }

    fn values(&self, [x, y]: [&Interval; 2]) -> Interval {
        let powers = |x: &Interval, most: usize| {
            let mut all = vec![Interval::point(&Rational::ONE)];
            for k in 0..most {
                all.push(all[k].mul(x));
            }
            all
        };
        let most = |of: &dyn Fn(&(usize, usize, Interval)) -> usize| self.0.iter().map(of).max().unwrap_or(0);
        let (of_x, of_y) = (powers(x, most(&|t| t.0)), powers(y, most(&|t| t.1)));
        let zero = Interval::point(&Rational::ZERO);
        self.0.iter().fold(zero, |sum, (i, j, c)| sum.add(&of_x[*i].mul(&of_y[*j]).mul(c)))
    }
}

/// A quotient of two of them.
pub(super) struct QuotientInTwo {
    above: InTwo,
    below: InTwo,
}

impl QuotientInTwo {
    /// `None` where another variable has no bounds.
    pub(super) fn new(f: &Fraction, vars: [Var; 2], others: &[(Var, Interval)]) -> Option<Self> {
        let of = |p: &Poly| InTwo::new(p, vars, others);
        Some(Self { above: of(f.numer())?, below: of(f.denom())? })
    }

    /// The values; `None` where the denominator may be 0.
    pub(super) fn values(&self, at: [&Interval; 2]) -> Option<Interval> {
        self.above.values(at).div(&self.below.values(at))
    }
}
