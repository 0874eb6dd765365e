//! Exact rational numbers of unbounded size.
//!
//! Nearly all numbers of a spec fit in two machine words, and the engine runs unoptimised inside a
//! `cargo build`; so a number is kept as two `i64` while it fits and as two whole numbers of any size when it does not.
//! The representation is canonical: equal numbers are equal as data.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use super::integer::{Integer, gcd_of_words};

/// An exact fraction in lowest terms with a positive denominator.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Repr);

#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    /// Numerator and denominator, lowest terms, denominator positive, neither is `i64::MIN`.
    Small(i64, i64),
    /// Only for numbers that do not fit in `Small`.
    Big(Box<Ratio>),
}
use Repr::{Big, Small};

/// Lowest terms, denominator positive.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Ratio {
    numer: Integer,
    denom: Integer,
}

impl Rational {
    /// 0.
    pub const ZERO: Self = Self(Small(0, 1));
    /// 1.
    pub const ONE: Self = Self(Small(1, 1));

    /// `numer / denom`; `None` when `denom` is zero.
    pub fn checked_new(numer: i64, denom: i64) -> Option<Self> {
        (denom != 0).then(|| Self::from_i128(i128::from(numer), i128::from(denom)))
    }

    /// `numer / denom`.
    ///
    /// # Panics
    /// When `denom` is zero; for literals in the code, not for input.
    pub fn new(numer: i64, denom: i64) -> Self {
        Self::checked_new(numer, denom).expect("a literal denominator is not zero")
    }

    /// The number that a decimal literal such as `12`, `0.62` or `1_000` denotes, exactly; `None` if it is
    /// not one.
    pub fn from_decimal(text: &str) -> Option<Self> {
        let digits: String = text.chars().filter(|c| *c != '_').collect();
        let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
        let all = format!("{whole}{fraction}");
        if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let numer = Self::from_ratio(Integer::from_digits(&all)?, Integer::from(1));
        numer.checked_div(&Self::from(10).pow(fraction.len() as u32))
    }

    /// The fraction or decimal that a text such as `-3/4`, `2` or `0.5` denotes; `None` if it is not one.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let (negative, text) = match text.strip_prefix(['-', '−']) {
            Some(rest) => (true, rest.trim_start()),
            None => (false, text),
        };
        let magnitude = match text.split_once('/') {
            Some((n, d)) => {
                let (n, d) = (Self::from_decimal(n.trim())?, Self::from_decimal(d.trim())?);
                n.checked_div(&d)?
            }
            None => Self::from_decimal(text)?,
        };
        Some(if negative { -magnitude } else { magnitude })
    }

    /// The fraction that a finite float is; `None` for NaN and infinities.
    pub fn from_f64(value: f64) -> Option<Self> {
        let bits = value.to_bits();
        let exponent = (bits >> 52 & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        // ± fraction·2^-1074 below the normal numbers, else ± (2^52 + fraction)·2^(exponent − 1075)
        let (digits, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | 1 << 52, exponent) };
        let digits = Self::from(if value.is_sign_negative() { -digits } else { digits });
        let scale = Self::from(2).pow((exponent - 1075).unsigned_abs());
        value.is_finite().then(|| if exponent < 1075 { &digits / &scale } else { &digits * &scale })
    }

    /// The nearest float.
    pub fn to_f64(&self) -> f64 {
        let Ratio { numer, denom } = self.to_ratio();
        // |self| = (quotient + less than 1)·2^-scale; the quotient has 64 or 65 bits, fewer below the normal numbers
        let scale = (64 + denom.bits() as i64 - numer.bits() as i64).min(1075);
        let power = Integer::power_of_two(scale.unsigned_abs());
        let (numer, denom) = if scale < 0 { (numer, &denom * &power) } else { (&numer * &power, denom) };
        let Some((quotient, rest)) = numer.abs().div_rem(&denom) else { return f64::NAN };
        // A last bit that says whether anything is left makes the rounding exact.
        let digits = quotient.low() << 1 | u128::from(rest.signum() != 0);
        let dropped = (128 - digits.leading_zeros()).saturating_sub(53).max((scale - 1073).max(0) as u32);
        let (kept, half) = (digits >> dropped, (1_u128 << dropped) >> 1);
        let above = digits & ((1_u128 << dropped) - 1);
        let rounded = kept + u128::from(above > half || above == half && kept & 1 == 1);
        let mut magnitude = rounded as f64;
        let mut exponent = i64::from(dropped) - scale - 1;
        while exponent != 0 {
            let step = exponent.clamp(-1000, 1000);
            magnitude *= 2_f64.powi(step as i32);
            exponent -= step;
        }
        if self.is_negative() { -magnitude } else { magnitude }
    }

    /// Numerator and denominator.
    fn to_ratio(&self) -> Ratio {
        match &self.0 {
            Small(n, d) => {
                Ratio { numer: Integer::from(i128::from(*n)), denom: Integer::from(i128::from(*d)) }
            }
            Big(b) => (**b).clone(),
        }
    }

    /// From parts in lowest terms, the denominator positive.
    fn from_ratio(numer: Integer, denom: Integer) -> Self {
        match (small(&numer), small(&denom)) {
            (Some(n), Some(d)) => Self(Small(n, d)),
            _ => Self(Big(Box::new(Ratio { numer, denom }))),
        }
    }

    /// From 128-bit parts that cannot both be out of range after one operation on `Small` numbers.
    fn from_i128(mut numer: i128, mut denom: i128) -> Self {
        if denom < 0 {
            (numer, denom) = (-numer, -denom);
        }
        if denom != 1 {
            let g = gcd_of_words(numer.unsigned_abs(), denom.unsigned_abs()) as i128;
            if g > 1 {
                (numer, denom) = (numer / g, denom / g);
            }
        }
        match (i64::try_from(numer), i64::try_from(denom)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Self(Small(n, d)),
            _ => Self(Big(Box::new(Ratio { numer: Integer::from(numer), denom: Integer::from(denom) }))),
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
            Big(b) => b.numer.signum(),
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
            Big(b) => b.denom.is_one(),
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
        let Ratio { numer, denom } = self.to_ratio();
        match numer.div_rem(&denom) {
            Some((quotient, rest)) if rest.signum() < 0 => Self::whole(&quotient - &Integer::from(1)),
            Some((quotient, _)) => Self::whole(quotient),
            None => self.clone(), // no denominator is 0
        }
    }

    /// The smallest whole number not below this one.
    pub fn ceil(&self) -> Self {
        -(-self).floor()
    }

    /// How many bits numerator and denominator take together: the work that arithmetic on the number costs.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(n, d) => u64::from(128 - n.unsigned_abs().leading_zeros() - d.leading_zeros()),
            Big(b) => b.numer.bits() + b.denom.bits(),
        }
    }

    /// The numerator, with the sign of the number.
    pub fn numer(&self) -> Self {
        match &self.0 {
            Small(n, _) => Self(Small(*n, 1)),
            Big(b) => Self::whole(b.numer.clone()),
        }
    }

    /// The denominator, positive.
    pub fn denom(&self) -> Self {
        match &self.0 {
            Small(_, d) => Self(Small(*d, 1)),
            Big(b) => Self::whole(b.denom.clone()),
        }
    }

    /// The big integer that the number is, if it is whole.
    fn to_whole(&self) -> Option<Integer> {
        match &self.0 {
            Small(n, 1) => Some(Integer::from(i128::from(*n))),
            Small(..) => None,
            Big(b) => b.denom.is_one().then(|| b.numer.clone()),
        }
    }

    /// The number that a whole number is.
    fn whole(value: Integer) -> Self {
        Self::from_ratio(value, Integer::from(1))
    }

    /// The number modulo a prime below 2³²; `None` when the prime divides the denominator.
    pub fn modulo(&self, prime: u32) -> Option<u32> {
        let p = i64::from(prime);
        let (n, d) = match &self.0 {
            Small(n, d) => (n.rem_euclid(p), d.rem_euclid(p)),
            Big(b) => (i64::from(b.numer.modulo(prime)?), i64::from(b.denom.modulo(prime)?)),
        };
        if d == 1 {
            return Some(n as u32);
        }
        if d == 0 {
            return None;
        }
        // d^(p−2) is the inverse of d.
        let p = u64::from(prime);
        let (mut result, mut base, mut e) = (n as u64, d as u64, p - 2);
        while e > 0 {
            if e & 1 == 1 {
                result = result * base % p;
            }
            base = base * base % p;
            e >>= 1;
        }
        Some(result as u32)
    }

    /// The greatest common divisor of two fractions: the largest positive g such that both are whole
    /// multiples of it, gcd(a/b, c/d) = gcd(a·d, c·b)/(b·d).
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Small(a, b), Small(c, d)) = (&self.0, &other.0) {
            // gcd(a/b, c/d) = gcd(a, c) / lcm(b, d) for fractions in lowest terms
            let n = gcd_of_words(u128::from(a.unsigned_abs()), u128::from(c.unsigned_abs()));
            let (b, d) = (b.unsigned_abs(), d.unsigned_abs());
            let l = u128::from(b) / gcd_of_words(u128::from(b), u128::from(d)) * u128::from(d);
            if l <= i128::MAX as u128 {
                return Self::from_i128(n as i128, l as i128);
            }
        }
        let (x, y) = (self.to_ratio(), other.to_ratio());
        let common = x.denom.gcd(&y.denom);
        Self::from_ratio(x.numer.gcd(&y.numer), &x.denom * &quotient(&y.denom, &common))
    }
}

/// The integer as a machine word, if it fits and is not `i64::MIN`.
fn small(value: &Integer) -> Option<i64> {
    value.to_i64().filter(|n| *n != i64::MIN)
}

/// The quotient by a divisor that is not 0, rounded towards 0.
fn quotient(value: &Integer, divisor: &Integer) -> Integer {
    if divisor.is_one() {
        return value.clone();
    }
    value.div_rem(divisor).map_or_else(|| value.clone(), |(quotient, _)| quotient)
}

/// a/b + c/d. With g = gcd(b, d) the sum a·(d/g) + c·(b/g) has common factors with g only (Knuth, The Art of Computer
/// Programming 2, 4.5.1).
fn sum(x: &Ratio, y: &Ratio) -> Rational {
    let g = x.denom.gcd(&y.denom);
    let (b, d) = (quotient(&x.denom, &g), quotient(&y.denom, &g));
    let numer = &(&x.numer * &d) + &(&y.numer * &b);
    let left = numer.gcd(&g);
    Rational::from_ratio(quotient(&numer, &left), &b * &quotient(&y.denom, &left))
}

/// x − y
fn difference(x: &Ratio, y: &Ratio) -> Rational {
    sum(x, &Ratio { numer: -y.numer.clone(), denom: y.denom.clone() })
}

/// (a/b)·(c/d): common factors are those of a and d, and of c and b.
fn product(x: &Ratio, y: &Ratio) -> Rational {
    let (first, second) = (x.numer.gcd(&y.denom), y.numer.gcd(&x.denom));
    let numer = &quotient(&x.numer, &first) * &quotient(&y.numer, &second);
    Rational::from_ratio(numer, &quotient(&x.denom, &second) * &quotient(&y.denom, &first))
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self::from_i128(i128::from(value), 1)
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
                let (x, y) = (self.to_ratio(), other.to_ratio());
                (&x.numer * &y.denom).cmp(&(&y.numer * &x.denom))
            }
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Small(n, 1) => write!(f, "{n}"),
            Small(n, d) => write!(f, "{n}/{d}"),
            Big(b) if b.denom.is_one() => write!(f, "{}", b.numer),
            Big(b) => write!(f, "{}/{}", b.numer, b.denom),
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
            Big(b) => Rational(Big(Box::new(Ratio { numer: -b.numer.clone(), denom: b.denom.clone() }))),
        }
    }
}

impl Neg for Rational {
    type Output = Self;
    fn neg(self) -> Self {
        -&self
    }
}

/// Implements one operator for references and values: in 128 bits on small numbers, in big integers else.
macro_rules! operator {
    ($trait:ident $method:ident $assign_trait:ident $assign:ident $checked:ident, |$a:ident, $b:ident, $c:ident, $d:ident| $small:expr, $big:expr) => {
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                // Most numbers are whole.
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
                    return Rational::whole($trait::$method(&a, &b)); // no common factors to look for
                }
                $big(&self.to_ratio(), &other.to_ratio())
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
operator!(Add add AddAssign add_assign checked_add, |a, b, c, d| if b == d { (a + c, b) } else { (a * d + c * b, b * d) }, sum);
operator!(Sub sub SubAssign sub_assign checked_sub, |a, b, c, d| if b == d { (a - c, b) } else { (a * d - c * b, b * d) }, difference);
operator!(Mul mul MulAssign mul_assign checked_mul, |a, b, c, d| (a * c, b * d), product);

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
            if let Some((quotient, rest)) = a.div_rem(&b)
                && rest.signum() == 0
            {
                return Rational::whole(quotient);
            }
        }
        let Ratio { numer, denom } = other.to_ratio();
        let inverse = if numer.signum() < 0 {
            Ratio { numer: -denom, denom: -numer }
        } else {
            Ratio { numer: denom, denom: numer }
        };
        product(&self.to_ratio(), &inverse)
    }
}

/// The binomial coefficient n!/(k!·(n−k)!), 0 for k > n.
pub fn binomial(n: u32, k: u32) -> Rational {
    if k > n {
        return Rational::ZERO;
    }
    let mut result = Rational::ONE;
    for i in 0..k.min(n - k) {
        result = &result * &Rational::new(i64::from(n - i), i64::from(i + 1));
    }
    result
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
    fn decimals_are_exact() {
        assert_eq!(Rational::from_decimal("0.62"), Some(Rational::new(31, 50)));
        assert_eq!(Rational::from_decimal("1_000.5"), Some(Rational::new(2001, 2)));
        assert_eq!(Rational::from_decimal("1e3"), None);
        assert_eq!(Rational::parse(" -3/6 "), Some(Rational::new(-1, 2)));
        assert_eq!(Rational::parse("1/0"), None);
        assert_eq!(Rational::parse(""), None);
    }

    #[test]
    fn order_and_powers() {
        assert!(Rational::new(1, 3) < Rational::new(34, 100));
        assert_eq!(Rational::new(-2, 3).pow(3), Rational::new(-8, 27));
        assert_eq!(Rational::from(2).pow(200).bits(), 202);
        assert_eq!(binomial(30, 15), Rational::from(155_117_520));
        assert_eq!(Rational::new(-7, 2).floor(), Rational::from(-4));
        assert_eq!(Rational::new(3, 4).gcd(&Rational::new(5, 6)), Rational::new(1, 12));
        let big = Rational::from(3).pow(100);
        assert_eq!((&big * &Rational::from(10)).gcd(&Rational::from(-25)), Rational::from(5));
        assert_eq!(Rational::new(1, 3).modulo(7), Some(5));
        assert_eq!(big.modulo(101), Some(1));
        assert_eq!(Rational::new(1, 7).modulo(7), None);
    }

    #[test]
    fn laws_hold_for_numbers_of_any_size() {
        let values = |seed: i64| {
            let a = &Rational::from(3 * seed + 1).pow(17) / &Rational::from(6).pow(30 + seed as u32);
            let b = &Rational::from(-10).pow(21 + seed as u32) / &Rational::from(seed + 14).pow(11);
            [a, b, Rational::new(seed - 3, 6), Rational::from(7).pow(40)]
        };
        for (x, y, z) in
            (0..6).flat_map(values).zip((0..6).rev().flat_map(values)).map(|(x, y)| (x.clone(), y, x.pow(2)))
        {
            assert_eq!(&(&x + &y) - &y, x);
            assert_eq!(&(&x + &y) * &z, &x * &z + &y * &z);
            assert_eq!((&x - &y).signum(), x.cmp(&y) as i32);
            if let Some(quotient) = x.checked_div(&y) {
                assert_eq!(&quotient * &y, x);
                let common = x.gcd(&y);
                assert!((&x / &common).is_integer() && (&y / &common).is_integer());
                assert_eq!((&x / &common).gcd(&(&y / &common)), Rational::ONE);
            }
            assert!(x.floor() <= x && x < x.floor() + Rational::ONE && x.floor().is_integer());
            assert!(x.ceil() >= x && x > x.ceil() - Rational::ONE && x.ceil().is_integer());
            assert_eq!(Rational::parse(&x.to_string()), Some(x));
        }
    }

    #[test]
    fn floats_are_read_exactly_and_written_rounded() {
        let smallest = f64::from_bits(1);
        for x in [
            0.0,
            1.0,
            -0.1,
            1.0 / 3.0,
            1e300,
            -1e-300,
            f64::MIN_POSITIVE,
            3.0 * smallest,
            f64::MAX,
            2_f64.powi(64),
        ] {
            let exact = Rational::from_f64(x).expect("finite");
            assert_eq!(exact.to_f64(), x);
            let next = Rational::from_f64(x.next_up()).unwrap_or_else(|| Rational::from(2).pow(1024));
            let middle = &(&exact + &next) / &Rational::from(2);
            let little = &(&next - &exact) / &Rational::from(1_000_000);
            assert_eq!((&middle - &little).to_f64(), x);
            assert_eq!((&middle + &little).to_f64(), x.next_up());
            let even = if x.to_bits() & 1 == 0 { x } else { x.next_up() };
            assert_eq!(middle.to_f64(), even);
        }
        assert_eq!(Rational::from_f64(f64::NAN), None);
        assert_eq!(Rational::from_f64(f64::NEG_INFINITY), None);
        assert_eq!(Rational::from(2).pow(2000).to_f64(), f64::INFINITY);
        assert_eq!(Rational::from(2).pow(2000).recip().map(|x| x.to_f64()), Some(0.0));
    }
}
