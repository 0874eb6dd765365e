//! Whole numbers of unbounded size.
//!
//! What a rational number needs when its parts do not fit in a machine word, and no more. Every user of the macro compiles
//! this file and runs it unoptimised; so it is a few plain loops over words, without generic code.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Mul, Neg, Sub};

/// A whole number, ± Σ wᵢ·2^(64·i).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Integer {
    /// Never for 0.
    negative: bool,
    /// The words wᵢ, the lowest first, the last is not 0.
    words: Vec<u64>,
}

impl Integer {
    /// The power of two with this exponent.
    pub(super) fn power_of_two(exponent: u64) -> Self {
        let mut words = vec![0; (exponent / 64) as usize];
        words.push(1 << (exponent % 64));
        Self { negative: false, words }
    }

    /// The number that a text of decimal digits denotes; `None` for any other text.
    pub(super) fn from_digits(text: &str) -> Option<Self> {
        if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let mut words = Vec::new();
        for digits in text.as_bytes().chunks(DIGITS) {
            let (mut factor, mut value) = (1, 0);
            for digit in digits {
                factor *= 10;
                value = 10 * value + u64::from(digit - b'0');
            }
            multiply_add(&mut words, factor, value);
        }
        Some(Self { negative: false, words })
    }

    /// The number as a machine word, if it fits.
    pub(super) fn to_i64(&self) -> Option<i64> {
        match self.words[..] {
            [] => Some(0),
            [word] if self.negative => 0_i64.checked_sub_unsigned(word),
            [word] => i64::try_from(word).ok(),
            _ => None,
        }
    }

    /// The lowest 128 bits of the absolute value.
    pub(super) fn low(&self) -> u128 {
        low(&self.words)
    }

    /// −1, 0 or 1.
    pub(super) fn signum(&self) -> i32 {
        if self.words.is_empty() { 0 } else { 1 - 2 * i32::from(self.negative) }
    }

    /// Whether the number is 1.
    pub(super) fn is_one(&self) -> bool {
        !self.negative && self.words == [1]
    }

    /// How many bits the absolute value takes, 0 for 0.
    pub(super) fn bits(&self) -> u64 {
        bits(&self.words)
    }

    /// The absolute value.
    pub(super) fn abs(mut self) -> Self {
        self.negative = false;
        self
    }

    /// The quotient, rounded towards 0, and the remainder, which has the sign of the number; `None` when `divisor` is 0.
    pub(super) fn div_rem(&self, divisor: &Self) -> Option<(Self, Self)> {
        let (quotient, remainder) = div_rem(&self.words, &divisor.words)?;
        Some((signed(self.negative != divisor.negative, quotient), signed(self.negative, remainder)))
    }

    /// The remainder in `0..modulus`; `None` when `modulus` is 0.
    pub(super) fn modulo(&self, modulus: u32) -> Option<u32> {
        let mut words = self.words.clone();
        let remainder = divide_by_word(&mut words, u64::from(modulus))? as u32;
        Some(if self.negative && remainder > 0 { modulus - remainder } else { remainder })
    }

    /// The greatest common divisor, not negative.
    pub(super) fn gcd(&self, other: &Self) -> Self {
        signed(false, gcd(self.words.clone(), other.words.clone()))
    }
}

impl From<i128> for Integer {
    fn from(value: i128) -> Self {
        signed(value < 0, halves(value.unsigned_abs()))
    }
}

impl Neg for Integer {
    type Output = Self;
    fn neg(self) -> Self {
        signed(!self.negative, self.words)
    }
}

impl Add for &Integer {
    type Output = Integer;
    fn add(self, other: Self) -> Integer {
        if self.negative == other.negative {
            return signed(self.negative, sum(&self.words, &other.words));
        }
        match compare(&self.words, &other.words) {
            Ordering::Less => signed(other.negative, combination(1, &other.words, 1, &self.words)),
            _ => signed(self.negative, combination(1, &self.words, 1, &other.words)),
        }
    }
}

impl Sub for &Integer {
    type Output = Integer;
    fn sub(self, other: Self) -> Integer {
        self + &-other.clone()
    }
}

impl Mul for &Integer {
    type Output = Integer;
    fn mul(self, other: Self) -> Integer {
        signed(self.negative != other.negative, product(&self.words, &other.words))
    }
}

impl PartialOrd for Integer {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Integer {
    fn cmp(&self, other: &Self) -> Ordering {
        match (self.negative, other.negative) {
            (false, false) => compare(&self.words, &other.words),
            (true, true) => compare(&other.words, &self.words),
            (false, true) => Ordering::Greater,
            (true, false) => Ordering::Less,
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut groups = Vec::new();
        let mut rest = self.words.clone();
        while let (false, Some(group)) =
            (rest.is_empty(), divide_by_word(&mut rest, 10_u64.pow(DIGITS as u32)))
        {
            groups.push(group);
        }
        if self.negative {
            f.write_str("-")?;
        }
        write!(f, "{}", groups.pop().unwrap_or(0))?;
        for group in groups.iter().rev() {
            write!(f, "{group:0DIGITS$}")?;
        }
        Ok(())
    }
}

/// So many decimal digits fit in every word.
const DIGITS: usize = 19;

/// The number with these words, of which the last may be 0.
fn signed(negative: bool, words: Vec<u64>) -> Integer {
    let words = trimmed(words);
    Integer { negative: negative && !words.is_empty(), words }
}

// What follows is about numbers that are not negative, as their words.

fn trimmed(mut words: Vec<u64>) -> Vec<u64> {
    while words.last() == Some(&0) {
        words.pop();
    }
    words
}

fn halves(value: u128) -> Vec<u64> {
    trimmed(vec![value as u64, (value >> 64) as u64])
}

/// The word at an index, 0 where there is none.
fn word(words: &[u64], index: usize) -> u64 {
    if index < words.len() { words[index] } else { 0 }
}

fn low(words: &[u64]) -> u128 {
    u128::from(word(words, 0)) | u128::from(word(words, 1)) << 64
}

fn bits(words: &[u64]) -> u64 {
    match words.last() {
        Some(last) => 64 * words.len() as u64 - u64::from(last.leading_zeros()),
        None => 0,
    }
}

fn compare(a: &[u64], b: &[u64]) -> Ordering {
    let mut i = a.len();
    if i != b.len() {
        return i.cmp(&b.len());
    }
    while i > 0 {
        i -= 1;
        if a[i] != b[i] {
            return a[i].cmp(&b[i]);
        }
    }
    Ordering::Equal
}

/// a + b
fn sum(a: &[u64], b: &[u64]) -> Vec<u64> {
    let len = a.len().max(b.len());
    let mut words = Vec::with_capacity(len + 1);
    let (mut i, mut carry) = (0, 0);
    while i < len {
        carry += u128::from(word(a, i)) + u128::from(word(b, i));
        words.push(carry as u64);
        carry >>= 64;
        i += 1;
    }
    words.push(carry as u64);
    words
}

/// x·a − y·b for x, y ≤ 2⁶², where that is not negative and takes no more words than a or b.
fn combination(x: u64, a: &[u64], y: u64, b: &[u64]) -> Vec<u64> {
    let (x, y) = (i128::from(x), i128::from(y));
    let len = a.len().max(b.len());
    let mut words = Vec::with_capacity(len);
    let (mut i, mut carry) = (0, 0);
    while i < len {
        carry += x * i128::from(word(a, i)) - y * i128::from(word(b, i));
        words.push(carry as u64);
        carry >>= 64;
        i += 1;
    }
    trimmed(words)
}

/// a·b
fn product(a: &[u64], b: &[u64]) -> Vec<u64> {
    let mut words = vec![0; a.len() + b.len()];
    let mut i = 0;
    while i < a.len() {
        let factor = u128::from(a[i]);
        let (mut j, mut carry) = (0, 0);
        while j < b.len() {
            carry += factor * u128::from(b[j]) + u128::from(words[i + j]);
            words[i + j] = carry as u64;
            carry >>= 64;
            j += 1;
        }
        words[i + j] = carry as u64;
        i += 1;
    }
    words
}

/// Replaces a by factor·a + addend.
fn multiply_add(a: &mut Vec<u64>, factor: u64, addend: u64) {
    let mut carry = u128::from(addend);
    for word in a.iter_mut() {
        carry += u128::from(factor) * u128::from(*word);
        *word = carry as u64;
        carry >>= 64;
    }
    if carry > 0 {
        a.push(carry as u64);
    }
}

/// Replaces a by its quotient and gives the remainder; `None` when the divisor is 0.
fn divide_by_word(a: &mut Vec<u64>, divisor: u64) -> Option<u64> {
    if divisor == 0 {
        return None;
    }
    let mut remainder = 0;
    let mut i = a.len();
    while i > 0 {
        i -= 1;
        let part = u128::from(remainder) << 64 | u128::from(a[i]);
        a[i] = (part / u128::from(divisor)) as u64;
        remainder = (part % u128::from(divisor)) as u64;
    }
    if a.last() == Some(&0) {
        a.pop();
    }
    Some(remainder)
}

/// a·2^count for count < 64, with one word more.
fn shifted(a: &[u64], count: u32) -> Vec<u64> {
    let mut words = Vec::with_capacity(a.len() + 1);
    let mut carry = 0;
    for word in a {
        carry |= u128::from(*word) << count;
        words.push(carry as u64);
        carry >>= 64;
    }
    words.push(carry as u64);
    words
}

/// 64 bits of a, from the bit with this index on.
fn window(a: &[u64], start: u64) -> u64 {
    let first = (start / 64) as usize;
    (low(&a[first.min(a.len())..]) >> (start % 64)) as u64
}

/// Quotient and remainder; `None` when b is 0. The division of the schools, one word after the other (Knuth, The Art of
/// Computer Programming 2, 4.3.1, algorithm D).
fn div_rem(a: &[u64], b: &[u64]) -> Option<(Vec<u64>, Vec<u64>)> {
    let top = b.last()?;
    if compare(a, b) == Ordering::Less {
        return Some((Vec::new(), a.to_vec()));
    }
    if let [divisor] = b {
        let mut quotient = a.to_vec();
        let remainder = divide_by_word(&mut quotient, *divisor)?;
        return Some((quotient, trimmed(vec![remainder])));
    }
    // With the highest bit of the divisor set, a digit that is guessed from two words is at most two too high.
    let shift = top.leading_zeros();
    let (mut rest, mut divisor) = (shifted(a, shift), shifted(b, shift));
    divisor.pop();
    let n = divisor.len();
    let (first, second) = (u128::from(divisor[n - 1]), u128::from(divisor[n - 2]));
    let mut quotient = vec![0; a.len() - n + 1];
    let mut j = quotient.len();
    while j > 0 {
        j -= 1;
        let high = u128::from(rest[j + n]) << 64 | u128::from(rest[j + n - 1]);
        let (mut digit, mut left) = (high / first, high % first);
        while digit >> 64 != 0 || digit * second > (left << 64 | u128::from(rest[j + n - 2])) {
            digit -= 1;
            left += first;
            if left >> 64 != 0 {
                break;
            }
        }
        if subtract_multiple(&mut rest[j..=j + n], digit as u64, &divisor) {
            digit -= 1;
            add_back(&mut rest[j..=j + n], &divisor);
        }
        quotient[j] = digit as u64;
    }
    // The remainder is below the divisor: its words above are 0.
    let mut remainder = rest;
    remainder.truncate(n);
    let mut carry = 0;
    for word in remainder.iter_mut().rev() {
        let both = u128::from(carry) << 64 | u128::from(*word);
        carry = *word;
        *word = (both >> shift) as u64;
    }
    Some((trimmed(quotient), trimmed(remainder)))
}

/// Replaces a by a − digit·b modulo 2^(64·a.len()); whether that was negative.
fn subtract_multiple(a: &mut [u64], digit: u64, b: &[u64]) -> bool {
    let (mut i, mut borrow) = (0, 0_u128);
    while i < a.len() {
        borrow += u128::from(digit) * u128::from(word(b, i));
        let (difference, below) = a[i].overflowing_sub(borrow as u64);
        a[i] = difference;
        borrow = (borrow >> 64) + u128::from(below);
        i += 1;
    }
    borrow != 0
}

/// Replaces a by a + b modulo 2^(64·a.len()).
fn add_back(a: &mut [u64], b: &[u64]) {
    let (mut i, mut carry) = (0, 0_u128);
    while i < a.len() {
        carry += u128::from(a[i]) + u128::from(word(b, i));
        a[i] = carry as u64;
        carry >>= 64;
        i += 1;
    }
}

/// The greatest common divisor: Euclid's algorithm, many steps at once (Lehmer) until two words are left.
fn gcd(mut a: Vec<u64>, mut b: Vec<u64>) -> Vec<u64> {
    if compare(&a, &b) == Ordering::Less {
        (a, b) = (b, a);
    }
    while b.len() > 2 {
        (a, b) = match euclidean_steps(&a, &b) {
            Some(next) => next,
            None => remainder(a, b),
        };
    }
    if b.is_empty() {
        return a;
    }
    if a.len() > 2 {
        (a, b) = remainder(a, b);
    }
    halves(gcd_of_words(low(&a), low(&b)))
}

/// One step of Euclid's algorithm: (b, a mod b), or a when b is 0.
fn remainder(a: Vec<u64>, b: Vec<u64>) -> (Vec<u64>, Vec<u64>) {
    match div_rem(&a, &b) {
        Some((_, remainder)) => (b, remainder),
        None => (a, b),
    }
}

/// As many steps of Euclid's algorithm as the highest bits of a ≥ b determine; `None` when that is none.
///
/// The k-th remainder is r = ±(x·a − y·b) with cofactors x ≤ y that grow with each step. Divided by a power of two and
/// rounded, remainders r ≥ s with cofactors y ≤ z have the true quotient as long as s ≥ z and r − s ≥ y + z
/// (Collins' condition; Knuth, 4.5.2, algorithm L).
fn euclidean_steps(a: &[u64], b: &[u64]) -> Option<(Vec<u64>, Vec<u64>)> {
    let start = bits(a).saturating_sub(62);
    let (mut r, mut s) = (window(a, start), window(b, start));
    let (mut x, mut next_x) = (1, 0);
    let (mut y, mut next_y) = (0, 1);
    let mut even = true;
    let mut known = None;
    while s >= next_y && r - s >= y + next_y {
        known = (y > 0).then_some((x, y, next_x, next_y, even));
        let quotient = r / s;
        (r, s) = (s, r % s);
        (x, next_x) = (next_x, x + quotient * next_x);
        (y, next_y) = (next_y, y + quotient * next_y);
        even = !even;
    }
    let (x, y, next_x, next_y, even) = known?;
    Some(if even {
        (combination(x, a, y, b), combination(next_y, b, next_x, a))
    } else {
        (combination(y, b, x, a), combination(next_x, a, next_y, b))
    })
}

/// The greatest common divisor of two machine integers.
pub(super) fn gcd_of_words(mut a: u128, mut b: u128) -> u128 {
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

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_integer::Integer as _;

    use super::Integer;

    /// Whole numbers of up to `words` words; long runs of equal bits find the rare branches of the division.
    struct Numbers(u64);

    impl Numbers {
        fn word(&mut self) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let bits = self.0 >> 33 ^ self.0;
            match self.0 >> 60 {
                0..3 => 0,
                3..6 => u64::MAX,
                6..8 => 1 << 63,
                8 => 1,
                _ => bits,
            }
        }

        fn next(&mut self, words: u64) -> (Integer, BigInt) {
            let count = self.word() % (words + 1);
            let mut number = (Integer::from(0), BigInt::from(0));
            for _ in 0..count {
                let word = self.word();
                number.0 = &(&number.0 * &Integer::power_of_two(64)) + &Integer::from(i128::from(word));
                number.1 = (number.1 << 64) + word;
            }
            if self.0 >> 40 & 1 == 1 { (-number.0, -number.1) } else { number }
        }
    }

    #[track_caller]
    fn same(ours: &Integer, theirs: &BigInt) {
        assert_eq!(ours.to_string(), theirs.to_string());
        assert_eq!(ours.bits(), theirs.bits());
    }

    #[test]
    fn agrees_with_num_bigint() {
        let mut numbers = Numbers(1);
        for round in 0..3000 {
            let (a, x) = numbers.next(1 + round % 7);
            let (b, y) = numbers.next(1 + round % 5);
            let (c, z) = numbers.next(1 + round % 3);
            same(&(&a + &b), &(&x + &y));
            same(&(&a - &b), &(&x - &y));
            same(&(&a * &b), &(&x * &y));
            assert_eq!(a.cmp(&b), x.cmp(&y));
            let (abc, xyz) = (&(&a * &b) + &c, &x * &y + &z);
            match abc.div_rem(&b) {
                Some((quotient, remainder)) => {
                    let (expected_quotient, expected_remainder) = xyz.div_rem(&y);
                    same(&quotient, &expected_quotient);
                    same(&remainder, &expected_remainder);
                }
                None => assert_eq!(b.signum(), 0),
            }
            same(&a.gcd(&b), &x.gcd(&y));
            same(&(&a * &c).gcd(&(&b * &c)), &(&x * &z).gcd(&(&y * &z)));
            assert_eq!(a.modulo(101).map(BigInt::from), Some(x.mod_floor(&BigInt::from(101))));
            assert_eq!(a.to_i64(), i64::try_from(&x).ok());
            let digits = x.magnitude().to_string();
            assert_eq!(Integer::from_digits(&digits), Some(a.abs()));
        }
    }

    /// The quotients of consecutive Fibonacci numbers are 1: no pair needs more steps.
    #[test]
    fn greatest_common_divisors_of_neighbours() {
        let (mut a, mut b) = (Integer::from(1), Integer::from(1));
        for _ in 0..1500 {
            (a, b) = (&a + &b, a);
            assert!(a.gcd(&b).is_one());
            assert!(b.gcd(&a).is_one());
        }
        let factor = Integer::power_of_two(200);
        assert_eq!((&a * &factor).gcd(&(&b * &factor)), factor);
        assert_eq!(Integer::from(0).gcd(&-a.clone()), a);
    }

    #[test]
    fn reads_digits_only() {
        for text in ["", "-1", "+1", "1 000", "1.5", "٣"] {
            assert_eq!(Integer::from_digits(text), None, "{text}");
        }
        assert_eq!(Integer::from_digits("000"), Some(Integer::from(0)));
    }
}
