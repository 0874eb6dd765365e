//! Real algebraic numbers for reading: with square roots where these are enough, else as roots of short polynomials.

use core::cmp::Ordering;
use core::fmt;

use super::algebraic::Algebraic;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::univariate::{ToPoly as _, Univariate};
use crate::algebra::work::Work;
use crate::collections::list::Listed;
use crate::collections::sort::sort_unique;

impl Algebraic {
    /// The number as `root of -2 + x^2 between 1.414 and 1.415`, the polynomial in the given name: for programs.
    pub fn describe(&self, name: &str) -> String {
        let (names, p) = ([name.to_string()], self.polynomial().to_poly(Var(0)));
        format!("root of {} between {} and {}", p.display(&names), decimal(self.low()), decimal(self.high()))
    }

    /// The number as `sqrt(2)` or `1/2 - 1/6*sqrt(3)`, or else as [`describe`](Self::describe) has it, with a
    /// polynomial of a smaller degree where one is known: for readers.
    pub fn reading(&self, name: &str) -> String {
        const WORK: u64 = 1_000_000;
        let least = of_least_degree(self, &mut Work::new(WORK));
        if let Some(text) = least.as_ref().and_then(in_square_roots) {
            return text;
        }
        least.as_ref().unwrap_or(self).describe(name)
    }
}

/// A number as a decimal if three, six or nine digits are enough and the fraction would be longer.
fn decimal(x: &Rational) -> String {
    for digits in [3_usize, 6, 9] {
        let scaled = x * &Rational::from(10_i64.pow(digits as u32));
        if x.denom() > Rational::from(9) && scaled.is_integer() {
            let text = format!("{:0>width$}", scaled.abs().to_string(), width = digits + 1);
            let (whole, fraction) = text.split_at(text.len() - digits);
            let sign = if x.is_negative() { "-" } else { "" };
            return format!("{sign}{whole}.{}", fraction.trim_end_matches('0'));
        }
    }
    x.to_string()
}

impl fmt::Display for Algebraic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.describe("x"))
    }
}

/// The number as a root of a quadratic factor of its polynomial, if it is one; else of what is left without these factors;
/// `None` when the work is spent.
///
/// Factors a·x² + b·x + c with whole numbers have values at 0, 1 and −1 that divide those of the polynomial.
pub fn of_least_degree(x: &Algebraic, work: &mut Work) -> Option<Algebraic> {
    const MOST: usize = 5_000;
    let mut p = x.polynomial().primitive();
    if p.degree() < 3 {
        return Some(x.clone());
    }
    let as_root = |of: &Univariate| Algebraic::new(of, x.low().clone(), x.high().clone());
    let at = |y: i64| {
        let y = Rational::from(y);
        p.coefficients().iter().rev().fold(Rational::ZERO, |sum, c| &(&sum * &y) + c).to_i64()
    };
    let [Some(c), Some(e), Some(f)] = [at(0), at(1), at(-1)].map(|value| value.and_then(divisors)) else {
        return Some(x.clone());
    };
    if c.len() * e.len() * f.len() > MOST {
        return Some(x.clone());
    }
    for c in &c {
        for e in &e {
            // a + b + c and a − b + c are ±e and ±f, up to the sign of all.
            for (e, f) in f.iter().flat_map(|f| [(*e, *f), (*e, -f), (-e, *f), (-e, -f)]) {
                // The sum is even, or there is no such factor.
                let a = i64::midpoint(e, f) - c;
                if (e + f) % 2 != 0 || a == 0 || p.degree() < 3 {
                    continue;
                }
                work.spend(10 * p.degree() as u64)?;
                let factor = Univariate::integers(&[*c, (e - f) / 2, a]);
                let Some(rest) = p.div_exact(&factor) else { continue };
                if factor.sign_at(x.low()) * factor.sign_at(x.high()) == -1 {
                    return Some(as_root(&factor.normalized()).unwrap_or_else(|| x.clone()));
                }
                p = rest;
            }
        }
    }
    Some(as_root(&p.normalized()).unwrap_or_else(|| x.clone()))
}

/// The positive divisors of a number that is not 0; `None` of large ones.
fn divisors(n: i64) -> Option<Vec<i64>> {
    const LARGEST: u64 = 100_000_000;
    let n = n.unsigned_abs();
    if n == 0 || n > LARGEST {
        return None;
    }
    let small = (1..).take_while(|k| k * k <= n).filter(|k| n.is_multiple_of(*k)).listed();
    let large = small.iter().map(|k| n / k).listed();
    let mut all = [small, large].concat();
    sort_unique(&mut all);
    Some(all.into_iter().map(|k| k as i64).listed())
}

/// A root of a quadratic polynomial a·x² + b·x + c as −b/(2a) ± q·√n with a whole number n without small square
/// factors; `None` of other numbers.
pub fn in_square_roots(x: &Algebraic) -> Option<String> {
    let [c, b, a] = x.polynomial().coefficients() else { return None };
    let middle = (-b).checked_div(&(a + a))?;
    let discriminant = &(b * b) - &(&(a * c) * &Rational::from(4));
    let mut n = discriminant.to_i64().filter(|n| (1..1_000_000_000_000).contains(n))?;
    let mut outside = 1_i64;
    let mut factor = 2_i64;
    while factor * factor <= n && factor < 100_000 {
        if n % (factor * factor) == 0 {
            n /= factor * factor;
            outside *= factor;
        } else {
            factor += 1;
        }
    }
    let mut q = Rational::from(outside).checked_div(&(a + a))?.abs();
    if x.compare(&middle) == Ordering::Less {
        q = -q;
    }
    // It may be rational after all.
    if (n as u64).isqrt().pow(2) == n as u64 {
        return Some((&middle + &(&q * &Rational::from((n as u64).isqrt() as i64))).to_string());
    }
    let root = |q: &Rational| if q.is_one() { format!("sqrt({n})") } else { format!("{q}*sqrt({n})") };
    Some(match (middle.is_zero(), q.is_negative()) {
        (true, true) => format!("-{}", root(&-&q)),
        (true, false) => root(&q),
        (false, true) => format!("{middle} - {}", root(&-&q)),
        (false, false) => format!("{middle} + {}", root(&q)),
    })
}
