//! Exact rational numbers of unbounded size.
//!
//! Nearly all numbers of a spec fit in two machine words, and the engine runs unoptimised inside a
//! `cargo build`; so a number is kept as two `i64` while it fits and as two [`BigInt`] when it does not.
//! The representation is canonical: equal numbers are equal as data.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_bigint::{BigInt, Sign};
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, ToPrimitive as _};

use super::done::did;

/// An exact fraction in lowest terms with a positive denominator.
#[derive(PartialEq, Eq, Hash)]
pub struct Rational(Repr);

#[derive(PartialEq, Eq, Hash)]
enum Repr {
    /// Numerator and denominator, lowest terms, denominator positive, neither is `i64::MIN`.
    Small(i64, i64),
    /// The same for numbers that do not fit in `Small`.
    Big(Box<(BigInt, BigInt)>),
}
use Repr::{Big, Small};

impl Clone for Rational {
    // The derived one calls a function for every field, and nothing is called as often.
    fn clone(&self) -> Self {
        match &self.0 {
            Small(n, d) => Self(Small(*n, *d)),
            Big(b) => Self(Big(b.clone())),
        }
    }
}

impl Rational {
    /// 0.
    pub const ZERO: Self = Self(Small(0, 1));
    /// 1.
    pub const ONE: Self = Self(Small(1, 1));

    /// `numer / denom`.
    ///
    /// # Panics
    /// When `denom` is zero; for literals in the code, not for input.
    pub fn new(numer: i64, denom: i64) -> Self {
        assert!(denom != 0, "a literal denominator is not zero");
        Self::from_i128(i128::from(numer), i128::from(denom))
    }

    /// The fraction of two whole numbers.
    ///
    /// # Panics
    /// When `denom` is zero.
    pub fn ratio(numer: BigInt, denom: BigInt) -> Self {
        assert!(denom.sign() != Sign::NoSign, "division of {numer} by zero");
        let common = euclid(&numer, &denom) * if denom.is_negative() { -1 } else { 1 };
        Self::lowest(numer / &common, denom / common)
    }

    /// A fraction in lowest terms with a positive denominator.
    fn lowest(numer: BigInt, denom: BigInt) -> Self {
        match (small(&numer), small(&denom)) {
            (Some(n), Some(d)) => Self(Small(n, d)),
            _ => Self(Big(Box::new((numer, denom)))),
        }
    }

    /// The number that a text such as `12` or `-3/4` denotes.
    pub fn parse(text: &str) -> Option<Self> {
        let (numer, denom) = text.split_once('/').unwrap_or((text, "1"));
        let denom = denom.parse::<BigInt>().ok().filter(|denom| denom.sign() != Sign::NoSign)?;
        Some(Self::ratio(numer.parse().ok()?, denom))
    }

    /// Numerator and denominator.
    pub(super) fn parts(&self) -> (BigInt, BigInt) {
        match &self.0 {
            Small(n, d) => (BigInt::from(*n), BigInt::from(*d)),
            Big(b) => (**b).clone(),
        }
    }

    /// From 128-bit parts that cannot both be out of range after one operation on `Small` numbers.
    fn from_i128(mut numer: i128, mut denom: i128) -> Self {
        if denom < 0 {
            (numer, denom) = (-numer, -denom);
        }
        if denom != 1 {
            let g = gcd(numer.unsigned_abs(), denom.unsigned_abs()) as i128;
            if g > 1 {
                (numer, denom) = (numer / g, denom / g);
            }
        }
        match (i64::try_from(numer), i64::try_from(denom)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Self(Small(n, d)),
            _ => Self(Big(Box::new((BigInt::from(numer), BigInt::from(denom))))),
        }
    }

    /// Whether the number is 0.
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Small(0, _))
    }

    /// Whether the number is 1.
    pub fn is_one(&self) -> bool {
        matches!(self.0, Small(1, 1))
    }

    /// −1, 0 or 1.
    pub fn signum(&self) -> i32 {
        match &self.0 {
            Small(n, _) => n.signum() as i32,
            Big(b) => match b.0.sign() {
                Sign::Minus => -1,
                Sign::NoSign => 0,
                Sign::Plus => 1,
            },
        }
    }

    /// Whether the number is below 0.
    pub fn is_negative(&self) -> bool {
        self.signum() < 0
    }

    /// Whether the number is above 0.
    pub fn is_positive(&self) -> bool {
        self.signum() > 0
    }

    /// Whether the number is whole.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Small(_, d) => *d == 1,
            Big(b) => b.1.is_one(),
        }
    }

    /// The value as a machine integer, if it is whole and fits.
    pub fn to_i64(&self) -> Option<i64> {
        match self.0 {
            Small(n, 1) => Some(n),
            _ => None,
        }
    }

    /// The absolute value.
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// 1 divided by the number; `None` for 0.
    pub fn recip(&self) -> Option<Self> {
        Self::ONE.checked_div(self)
    }

    /// The quotient; `None` when `other` is 0.
    pub fn checked_div(&self, other: &Self) -> Option<Self> {
        (!other.is_zero()).then(|| self / other)
    }

    /// The power with a whole exponent.
    pub fn pow(&self, exponent: u32) -> Self {
        let (mut result, mut base, mut e) = (Self::ONE, self.clone(), exponent);
        while e > 0 {
            if e & 1 == 1 {
                result *= &base;
            }
            e >>= 1;
            if e > 0 {
                base = &base * &base;
            }
        }
        result
    }

    /// The largest whole number not above this one.
    pub fn floor(&self) -> Self {
        let (n, d) = self.parts();
        Self::from(n.div_floor(&d))
    }

    /// The size of numerator and denominator together, in bits: the work that arithmetic on the number costs.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(n, d) => u64::from(128 - n.unsigned_abs().leading_zeros() - d.leading_zeros()),
            Big(b) => b.0.bits() + b.1.bits(),
        }
    }

    /// The numerator, with the sign of the number.
    pub fn numer(&self) -> Self {
        match &self.0 {
            Small(n, _) => Self(Small(*n, 1)),
            Big(b) => Self::from(b.0.clone()),
        }
    }

    /// The denominator, positive.
    pub fn denom(&self) -> Self {
        match &self.0 {
            Small(_, d) => Self(Small(*d, 1)),
            Big(b) => Self::from(b.1.clone()),
        }
    }

    /// The big integer that the number is, if it is whole.
    pub fn to_whole(&self) -> Option<BigInt> {
        match &self.0 {
            Small(n, 1) => Some(BigInt::from(*n)),
            Small(..) => None,
            Big(b) => b.1.is_one().then(|| b.0.clone()),
        }
    }

    /// The greatest common divisor of two fractions: the largest positive g such that both are whole
    /// multiples of it, gcd(a/b, c/d) = gcd(a·d, c·b)/(b·d).
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Small(a, b), Small(c, d)) = (&self.0, &other.0) {
            // gcd(a/b, c/d) = gcd(a, c) / lcm(b, d) for fractions in lowest terms
            let n = gcd(u128::from(a.unsigned_abs()), u128::from(c.unsigned_abs()));
            let (b, d) = (b.unsigned_abs(), d.unsigned_abs());
            let l = u128::from(b) / gcd(u128::from(b), u128::from(d)) * u128::from(d);
            if l <= i128::MAX as u128 {
                return Self::from_i128(n as i128, l as i128);
            }
        }
        let ((a, b), (c, d)) = (self.parts(), other.parts());
        Self::lowest(euclid(&a, &c), b.lcm(&d)) // no prime divides both, because none divides a and b, or c and d
    }
}

/// The integer as a machine word, if it fits and is not `i64::MIN`.
fn small(value: &BigInt) -> Option<i64> {
    value.to_i64().filter(|n| *n != i64::MIN)
}

/// The greatest common divisor. One division first, because mostly one of the two is small; and nothing is searched for beside
/// a power of two, which is the denominator of a number that was rounded.
fn euclid(a: &BigInt, b: &BigInt) -> BigInt {
    let (a, b) = if a.bits() < b.bits() { (b, a) } else { (a, b) };
    let Some(twos) = b.trailing_zeros() else { return a.abs() };
    if twos + 1 == b.bits() {
        return BigInt::from(1) << twos.min(a.trailing_zeros().unwrap_or(twos));
    }
    did(12 + a.bits() / 64 + (b.bits() / 32).pow(2));
    let rest = a % b;
    match (rest.magnitude().to_u128(), b.magnitude().to_u128()) {
        (Some(a), Some(b)) => BigInt::from(gcd(a, b)),
        _ => rest.gcd(b),
    }
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        // Machine-word division is many times faster than 128-bit division.
        if let (Ok(x), Ok(y)) = (u64::try_from(a), u64::try_from(b)) {
            let (mut x, mut y) = (x, y);
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return u128::from(x);
        }
        (a, b) = (b, a % b);
    }
    a
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        if value == i64::MIN { Self::from_i128(i128::from(value), 1) } else { Self(Small(value, 1)) }
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        match small(&value) {
            Some(n) => Self(Small(n, 1)),
            None => Self(Big(Box::new((value, BigInt::from(1))))),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Small(a, b), Small(c, d)) => {
                (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)))
            }
            _ => {
                let ((a, b), (c, d)) = (self.parts(), other.parts());
                (a * d).cmp(&(c * b))
            }
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Small(n, 1) => write!(f, "{n}"),
            Small(n, d) => write!(f, "{n}/{d}"),
            Big(b) if b.1.is_one() => write!(f, "{}", b.0),
            Big(b) => write!(f, "{}/{}", b.0, b.1),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Small(n, d) => Rational(Small(-n, *d)),
            Big(b) => Rational(Big(Box::new((-&b.0, b.1.clone())))),
        }
    }
}

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        -&self
    }
}

/// a/b + c/d: numerator and denominator b·d / gcd(b, d) have no other common factors than those of gcd(b, d).
fn sum((a, b): (BigInt, BigInt), (c, d): (BigInt, BigInt)) -> Rational {
    let common = euclid(&b, &d);
    let b = b / &common;
    let numer = a * (&d / &common) + c * &b;
    let rest = euclid(&numer, &common);
    Rational::lowest(numer / &rest, b * (d / rest))
}

/// a/b · c/d: common are only factors of a and d, and of b and c.
fn product((a, b): (BigInt, BigInt), (c, d): (BigInt, BigInt)) -> Rational {
    let (first, second) = (euclid(&a, &d), euclid(&b, &c));
    Rational::lowest((a / &first) * (c / &second), (b / second) * (d / first))
}

/// Implements one operator for references and values: in 128 bits on small numbers, in big integers otherwise.
macro_rules! operator {
    ($trait:ident $method:ident $assign_trait:ident $assign:ident $checked:ident $big:expr, |$a:ident, $b:ident, $c:ident, $d:ident| $small:expr) => {
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                if let (Small(a, 1), Small(c, 1)) = (&self.0, &other.0)
                    && let Some(n) = a.$checked(*c)
                    && n != i64::MIN
                {
                    return Rational(Small(n, 1));
                }
                if let (Small($a, $b), Small($c, $d)) = (&self.0, &other.0) {
                    let ($a, $b, $c, $d) =
                        (i128::from(*$a), i128::from(*$b), i128::from(*$c), i128::from(*$d));
                    let (n, d) = $small;
                    return Rational::from_i128(n, d);
                }
                if let (Some(a), Some(b)) = (self.to_whole(), other.to_whole()) {
                    return Rational::from($trait::$method(a, b)); // no common factors to look for
                }
                $big(self.parts(), other.parts())
            }
        }
        impl $trait for Rational {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $trait::$method(&self, &other)
            }
        }
        impl $assign_trait<&Rational> for Rational {
            fn $assign(&mut self, other: &Rational) {
                *self = $trait::$method(&*self, other);
            }
        }
    };
}
operator!(Add add AddAssign add_assign checked_add sum, |a, b, c, d| if b == d { (a + c, b) } else { (a * d + c * b, b * d) });
operator!(Sub sub SubAssign sub_assign checked_sub (|x, (c, d): (BigInt, _)| sum(x, (-c, d))), |a, b, c, d| if b == d { (a - c, b) } else { (a * d - c * b, b * d) });
operator!(Mul mul MulAssign mul_assign checked_mul product, |a, b, c, d| (a * c, b * d));

impl Div<&Rational> for &Rational {
    type Output = Rational;
    /// # Panics
    /// When `other` is zero; see [`Rational::checked_div`].
    fn div(self, other: &Rational) -> Rational {
        assert!(!other.is_zero(), "division of {self} by zero");
        if let (Small(a, b), Small(c, d)) = (&self.0, &other.0) {
            let (a, b, c, d) = (i128::from(*a), i128::from(*b), i128::from(*c), i128::from(*d));
            return Rational::from_i128(a * d, b * c);
        }
        if let (Some(a), Some(b)) = (self.to_whole(), other.to_whole()) {
            // Mostly a division without remainder, which needs no search for common factors.
            let (quotient, rest) = a.div_rem(&b);
            if rest.sign() == Sign::NoSign {
                return Rational::from(quotient);
            }
        }
        let (c, d) = other.parts();
        product(self.parts(), if c.is_negative() { (-d, -c) } else { (d, c) })
    }
}

/// How numbers become machine words: as numerators over a common denominator.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words {
    pub(super) denom: i64, // 1 when all numbers are whole
    /// No numerator has a larger absolute value.
    pub(super) largest: u64,
}

impl Words {
    /// For some numbers; `None` when one of them does not fit.
    pub(super) fn of<'a>(numbers: impl Iterator<Item = &'a Rational>) -> Option<Self> {
        let (mut denom, mut largest) = (1_i64, 0);
        for number in numbers {
            let Small(n, d) = number.0 else { return None };
            largest = n.unsigned_abs().max(largest);
            if d != 1 && d != denom {
                let common = gcd(u128::from(denom.unsigned_abs()), u128::from(d.unsigned_abs()));
                denom = denom.checked_mul(d / i64::try_from(common).ok()?)?;
            }
        }
        Some(Self { denom, largest: largest.checked_mul(denom.unsigned_abs())? })
    }

    /// The numerator of one of the numbers.
    pub(super) fn word(self, number: &Rational) -> i64 {
        match number.0 {
            Small(n, d) if d == self.denom => n,
            Small(n, d) => n * (self.denom / d),
            Big(_) => 0, // not one of them
        }
    }

    /// The number with this numerator.
    pub(super) fn number(self, word: i64) -> Rational {
        Rational::from_i128(i128::from(word), i128::from(self.denom))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_and_big_numbers_are_one_representation() {
        let huge = Rational::from(i64::MAX) + Rational::ONE;
        assert!(matches!(huge.0, Big(_)));
        assert_eq!(huge.clone() - Rational::ONE, Rational::from(i64::MAX));
        assert!(matches!((huge.clone() - Rational::ONE).0, Small(..)));
        assert_eq!(&huge / &huge, Rational::ONE);
        assert_eq!(Rational::from(i64::MIN).to_string(), "-9223372036854775808");
        assert_eq!(-Rational::from(i64::MIN), huge);
    }

    #[test]
    fn order_and_powers() {
        assert!(Rational::new(1, 3) < Rational::new(34, 100));
        assert_eq!(Rational::new(-2, 3).pow(3), Rational::new(-8, 27));
        assert_eq!(Rational::from(2).pow(200).bits(), 202);
        assert_eq!(Rational::new(-7, 2).floor(), Rational::from(-4));
        assert_eq!(Rational::new(3, 4).gcd(&Rational::new(5, 6)), Rational::new(1, 12));
        let big = Rational::from(3).pow(100);
        assert_eq!((&big * &Rational::from(10)).gcd(&Rational::from(-25)), Rational::from(5));
    }

    #[test]
    fn common_divisors_of_every_size() {
        let powers =
            |prime: i64| [0_u32, 1, 2, 31, 32, 63, 64, 65, 130].map(|k| Rational::from(prime).pow(k));
        let whole: Vec<BigInt> = powers(2)
            .iter()
            .flat_map(|a| powers(3).map(|b| a * &b))
            .flat_map(|x| [1, -7].map(|factor| &x * &Rational::from(factor)))
            .filter_map(|x| x.to_whole())
            .collect();
        for a in &whole {
            assert_eq!(euclid(a, &BigInt::ZERO), a.abs());
            for b in &whole {
                assert_eq!(euclid(a, b), a.gcd(b), "{a} {b}");
            }
        }
    }

    #[test]
    fn big_fractions_are_in_lowest_terms() {
        let big = Rational::from(10).pow(30);
        let x = |n: i64, d: i64| &Rational::new(n, d) / &big;
        assert_eq!(&x(1, 6) + &x(1, 10), x(4, 15));
        assert_eq!(&x(1, 6) - &x(1, 6), Rational::ZERO);
        assert_eq!(&x(-5, 6) * &(&x(3, 10) * &(&big * &big)), Rational::new(-1, 4));
        assert_eq!(&x(-5, 6) / &x(-5, 9), Rational::new(3, 2));
        assert!((&x(-5, 6) / &Rational::from(-7)).is_positive() && x(1, 3) < x(1, 2) && x(-1, 2) < x(-1, 3));
        assert_eq!((&big + &Rational::new(-1, 3)).floor(), &big - &Rational::ONE);
        assert_eq!(Rational::parse("-6/-4"), Some(Rational::new(3, 2)));
        assert_eq!(Rational::parse("1/0"), None);
        assert_eq!(Rational::parse(&x(-7, 3).to_string()), Some(x(-7, 3)));
        assert_eq!(x(4, 3).gcd(&x(2, 9)), x(2, 9));
    }
}
