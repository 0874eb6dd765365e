//! Variables and products of their powers.

use core::cmp::Ordering;
use core::fmt;

use Repr::{Packed, Wide};

/// A variable, by its place in the table of names of the item it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Var(pub usize);

/// A product of powers of variables.
///
/// The order is lexicographic, variable 0 counting most.
#[derive(PartialEq, Eq, Hash)]
pub struct Monomial(Repr);

/// The exponents; the representation is canonical, so that equal monomials are equal as data.
#[derive(PartialEq, Eq, Hash)]
enum Repr {
    /// One byte for each of the first 16 variables, variable 0 in the highest: a product is one addition, and
    /// numbers compare as monomials do.
    Packed(u128),
    /// For more variables or higher exponents; no trailing zeros.
    Wide(Vec<u16>),
}

/// The number of variables that fit in a packed monomial.
const PACKED: usize = 16;

/// The highest bit of every byte: without it two exponents add up without a carry.
const HIGH_BITS: u128 = 0x8080_8080_8080_8080_8080_8080_8080_8080;

const fn shift(var: usize) -> u32 {
    8 * (PACKED - 1 - var) as u32
}

impl Monomial {
    /// The monomial 1.
    pub const fn one() -> Self {
        Self(Packed(0))
    }

    /// The monomial with the given exponents, by variable.
    pub fn new(mut exponents: Vec<u16>) -> Self {
        while exponents.last() == Some(&0) {
            exponents.pop();
        }
        if exponents.len() > PACKED || exponents.iter().any(|e| *e > 255) {
            return Self(Wide(exponents));
        }
        Self(Packed(exponents.iter().enumerate().fold(0, |all, (i, e)| all + (u128::from(*e) << shift(i)))))
    }

    /// The exponent of a variable.
    pub fn exponent(&self, var: Var) -> u16 {
        match &self.0 {
            Packed(all) if var.0 < PACKED => (all >> shift(var.0)) as u16 & 0xff,
            Packed(_) => 0,
            Wide(e) => e.get(var.0).copied().unwrap_or(0),
        }
    }

    /// The same monomial with another exponent of one variable.
    pub fn with_exponent(&self, var: Var, exponent: u16) -> Self {
        if let Packed(all) = &self.0
            && var.0 < PACKED
            && exponent <= 255
        {
            return Self(Packed((all & !(0xff << shift(var.0))) + (u128::from(exponent) << shift(var.0))));
        }
        let mut e = self.exponents();
        if e.len() <= var.0 {
            e.resize(var.0 + 1, 0);
        }
        e[var.0] = exponent;
        Self::new(e)
    }

    /// The exponents by variable, trailing zeros left out.
    pub fn exponents(&self) -> Vec<u16> {
        match &self.0 {
            Packed(all) => {
                let len = PACKED - all.trailing_zeros() as usize / 8;
                (0..len).map(|i| (all >> shift(i)) as u16 & 0xff).collect()
            }
            Wide(e) => e.clone(),
        }
    }

    /// Whether this is the monomial 1.
    pub const fn is_one(&self) -> bool {
        matches!(self.0, Packed(0))
    }

    /// One more than the last variable that occurs; 0 for the monomial 1.
    pub fn width(&self) -> usize {
        match &self.0 {
            Packed(all) => PACKED - all.trailing_zeros() as usize / 8,
            Wide(e) => e.len(),
        }
    }

    /// The sum of all exponents.
    pub fn total_degree(&self) -> u32 {
        match &self.0 {
            // Sums of neighbouring bytes, then of those, side by side in one number.
            Packed(all) => {
                let low = 0x00ff_00ff_00ff_00ff_00ff_00ff_00ff_00ff;
                let pairs = (all & low) + (all >> 8 & low);
                let halves = (pairs as u64) + (pairs >> 64) as u64;
                (halves.wrapping_mul(0x0001_0001_0001_0001) >> 48) as u32
            }
            Wide(e) => e.iter().map(|e| u32::from(*e)).sum(),
        }
    }

    /// The product; panics when an exponent exceeds 65535, as a wrapped one would make false identities true. The
    /// checker refuses polynomials that come near to it, see [`Work::spend_product`](super::work::Work::spend_product).
    pub(super) fn mul(&self, other: &Self) -> Self {
        if let (Packed(a), Packed(b)) = (&self.0, &other.0)
            && (a | b) & HIGH_BITS == 0
        {
            return Self(Packed(a + b));
        }
        let (mut long, mut short) = (self.exponents(), other.exponents());
        if long.len() < short.len() {
            core::mem::swap(&mut long, &mut short);
        }
        for (x, y) in long.iter_mut().zip(&short) {
            *x = x.checked_add(*y).expect("an exponent is below 65536");
        }
        Self::new(long)
    }

    /// The quotient, if `other` divides.
    pub fn checked_div(&self, other: &Self) -> Option<Self> {
        if let (Packed(a), Packed(b)) = (&self.0, &other.0)
            && (a | b) & HIGH_BITS == 0
        {
            // A byte that borrows loses the high bit that was lent to it.
            let difference = (a | HIGH_BITS) - b;
            return (difference & HIGH_BITS == HIGH_BITS).then_some(Self(Packed(difference & !HIGH_BITS)));
        }
        let (mut e, divisor) = (self.exponents(), other.exponents());
        if divisor.len() > e.len() {
            return None;
        }
        for (x, y) in e.iter_mut().zip(&divisor) {
            *x = x.checked_sub(*y)?;
        }
        Some(Self::new(e))
    }
}

impl Clone for Monomial {
    // The derived one calls a function for every field.
    fn clone(&self) -> Self {
        match &self.0 {
            Packed(all) => Self(Packed(*all)),
            Wide(e) => Self(Wide(e.clone())),
        }
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Packed(a), Packed(b)) => a.cmp(b),
            // Without trailing zeros, vectors compare as monomials do.
            _ => self.exponents().cmp(&other.exponents()),
        }
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl fmt::Debug for Monomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}", self.exponents())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_and_wide_monomials_are_one_representation() {
        let m = Monomial::new(vec![1, 0, 200]);
        let n = Monomial::new(vec![0, 3, 100]);
        let product = m.mul(&n);
        assert_eq!(product.exponents(), [1, 3, 300]);
        assert_eq!(product.checked_div(&n), Some(m.clone()));
        assert!(matches!(product.checked_div(&n).map(|m| m.0), Some(Packed(_))));
        assert_eq!(m.checked_div(&n), None);
        let far = Monomial::one().with_exponent(Var(20), 2);
        assert_eq!((far.width(), far.exponent(Var(20)), far.total_degree()), (21, 2, 2));
        assert!(far < m && Monomial::one() < far);
        assert_eq!(far.with_exponent(Var(20), 0), Monomial::one());
        assert_eq!(Monomial::new(vec![2, 1]).checked_div(&Monomial::new(vec![1, 2])), None);
        assert_eq!(
            Monomial::new(vec![2, 2]).checked_div(&Monomial::new(vec![1, 2])),
            Some(Monomial::new(vec![1]))
        );
    }
}
