//! The simplest rational number in an interval: the one with the smallest denominator, and among those the one
//! nearest to zero.

use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// The simplest number strictly between two numbers, `None` standing for −∞ and +∞; if nothing is between them,
/// the first end that there is.
pub fn simplest_between(low: Option<&Rational>, high: Option<&Rational>) -> Rational {
    let (negative_low, positive_high) =
        (low.is_none_or(Rational::is_negative), high.is_none_or(Rational::is_positive));
    match (low, high) {
        (Some(a), Some(b)) if a >= b => a.clone(),
        _ if negative_low && positive_high => Rational::ZERO,
        // 0 is not inside: both ends are on one side of it.
        _ if positive_high => above_zero(low.unwrap_or(&Rational::ZERO), high),
        _ => -above_zero(&-high.unwrap_or(&Rational::ZERO), low.map(|a| -a).as_ref()),
    }
}

/// Counts the work of finding the simplest number between two: about one step of the continued fraction for each bit.
pub fn spend_simplest(low: &Rational, high: &Rational, work: &mut Work) -> Option<()> {
    let bits = low.bits() + high.bits();
    work.spend(bits * (1 + bits / 64) / 2)
}

/// The simplest number in the open interval (low, high) for 0 ≤ low < high.
///
/// Walks down the continued fraction that the two ends share, x = n + 1/y, in whole numbers: the ends are a/b and c/d,
/// with d = 0 for +∞, and (p, q; r, s) is the product of the matrices (n, 1; 1, 0), so that x = (p·y + q)/(r·y + s).
fn above_zero(low: &Rational, high: Option<&Rational>) -> Rational {
    let (mut a, mut b) = (low.numer(), low.denom());
    let (mut c, mut d) = high.map_or((Rational::ONE, Rational::ZERO), |x| (x.numer(), x.denom()));
    let (mut p, mut q) = (Rational::ONE, Rational::ZERO);
    let (mut r, mut s) = (Rational::ZERO, Rational::ONE);
    loop {
        let whole = whole_part(&a, &b);
        let next = &whole + &Rational::ONE;
        let (top, bottom) = (&(&p * &whole) + &q, &(&r * &whole) + &s);
        if d.is_zero() || c > &next * &d {
            // The whole number is the simplest one.
            return &(&top + &p) / &(&bottom + &r);
        }
        // whole ≤ low < high ≤ whole + 1; the reciprocals of the rests are in the other order.
        (a, b, c, d) = (d.clone(), &c - &(&whole * &d), b.clone(), &a - &(&whole * &b));
        (p, q, r, s) = (top, p, bottom, r);
    }
}

/// The largest whole number not above a/b, for whole a ≥ 0 and b > 0.
fn whole_part(a: &Rational, b: &Rational) -> Rational {
    if let (Some(a), Some(b)) = (a.to_i64(), b.to_i64()) {
        return Rational::from(a / b);
    }
    match (a.to_whole(), b.to_whole()) {
        (Some(a), Some(b)) => Rational::from(a / b), // without a search for common factors
        _ => (a / b).floor(),
    }
}

/// The simplest number with low ≤ x ≤ high, for low ≤ high.
pub fn simplest_within(low: &Rational, high: &Rational) -> Rational {
    let inner = simplest_between(Some(low), Some(high));
    let size = |x: &Rational| (x.denom(), x.abs());
    [low, high].into_iter().cloned().fold(inner, |best, x| if size(&x) < size(&best) { x } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn r(n: i64, d: i64) -> Rational {
        Rational::new(n, d)
    }

    #[test]
    fn smallest_denominator_wins() {
        let between = |a: Rational, b: Rational| simplest_between(Some(&a), Some(&b));
        assert_eq!(between(r(3, 10), r(4, 10)), r(1, 3));
        assert_eq!(between(r(333, 1000), r(334, 1000)), r(1, 3));
        assert_eq!(between(r(1, 3), r(1, 2)), r(2, 5));
        assert_eq!(between(r(-1, 3), r(5, 2)), r(0, 1));
        assert_eq!(between(r(0, 1), r(1, 1)), r(1, 2));
        assert_eq!(between(r(0, 1), r(1, 7)), r(1, 8));
        assert_eq!(between(r(-7, 2), r(-3, 2)), r(-2, 1));
        assert_eq!(between(r(-1, 2), r(-1, 3)), r(-2, 5));
        assert_eq!(between(r(2, 1), r(2, 1)), r(2, 1));
        assert_eq!(simplest_between(Some(&r(7, 2)), None), r(4, 1));
        assert_eq!(simplest_between(Some(&r(4, 1)), None), r(5, 1));
        assert_eq!(simplest_between(None, Some(&r(-7, 2))), r(-4, 1));
        assert_eq!(simplest_between(None, Some(&r(0, 1))), r(-1, 1));
        assert_eq!(simplest_between(None, None), r(0, 1));
        assert_eq!(simplest_within(&r(1, 3), &r(1, 2)), r(1, 2));
        assert_eq!(simplest_within(&r(5, 7), &r(5, 7)), r(5, 7));
    }

    #[test]
    fn agrees_with_a_search_by_denominator() {
        for (a, b, c, d) in [(1, 7, 2, 9), (5, 11, 6, 13), (22, 7, 355, 113), (1, 100, 1, 99), (8, 5, 13, 8)]
        {
            let (mut low, mut high) = (r(a, b), r(c, d));
            if low > high {
                core::mem::swap(&mut low, &mut high);
            }
            let found = (1..1000)
                .flat_map(|den| (0..40 * den).map(move |num| r(num, den)))
                .find(|x| *x > low && *x < high)
                .expect("an interval contains fractions");
            assert_eq!(simplest_between(Some(&low), Some(&high)), found);
        }
    }
}
