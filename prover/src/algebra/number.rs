//! Functions of numbers that no check needs.

use basis_kernel::algebra::rational::Rational;

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

/// The number that is not negative and whose square this is; `None` where there is no rational one.
pub fn square_root(x: &Rational) -> Option<Rational> {
    if x.is_negative() {
        return None;
    }
    let root = |x: Rational| x.to_whole().map(|x| Rational::from(x.sqrt()));
    let root = root(x.numer())?.checked_div(&root(x.denom())?)?;
    (&(&root * &root) == x).then_some(root)
}

/// The number modulo a prime below 2³²; `None` when the prime divides the denominator.
pub fn modulo(x: &Rational, prime: u32) -> Option<u32> {
    let rest = |x: Rational| match x.to_i64() {
        Some(x) => Some(x.rem_euclid(i64::from(prime)) as u64),
        None => {
            let p = Rational::from(i64::from(prime));
            (&x - &(&(&x / &p).floor() * &p)).to_i64().map(|r| r as u64)
        }
    };
    let (n, d) = (rest(x.numer())?, rest(x.denom())?);
    if d == 1 {
        return Some(n as u32);
    }
    if d == 0 {
        return None;
    }
    // d^(p−2) is the inverse of d.
    let p = u64::from(prime);
    let (mut result, mut base, mut e) = (n, d, p - 2);
    while e > 0 {
        if e & 1 == 1 {
            result = result * base % p;
        }
        base = base * base % p;
        e >>= 1;
    }
    Some(result as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_size() {
        assert_eq!(binomial(30, 15), Rational::from(155_117_520));
        assert_eq!(binomial(3, 4), Rational::ZERO);
        let big = Rational::from(3).pow(100);
        assert_eq!(modulo(&Rational::new(1, 3), 7), Some(5));
        assert_eq!(modulo(&big, 101), Some(1));
        assert_eq!(modulo(&-&big, 101), Some(100));
        assert_eq!(modulo(&Rational::new(1, 7), 7), None);
        assert_eq!(
            square_root(&(&big / &Rational::from(4))),
            Some(&Rational::from(3).pow(50) / &Rational::from(2))
        );
        assert_eq!(square_root(&Rational::from(2)), None);
        assert_eq!(square_root(&Rational::from(-1)), None);
        assert_eq!(square_root(&Rational::ZERO), Some(Rational::ZERO));
    }
}
