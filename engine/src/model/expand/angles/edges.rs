//! Ends of ranges of angles whose tangents are irrational.
//!
//! Of ψ = kπ/(4n) the multiple nψ is one of eighth turns, so that x = tan ψ is a zero of Im (1 + ix)ⁿ, of Re (1 + ix)ⁿ,
//! or of their sum or difference. All its zeros are the tangents of ψ + jπ/n; those that are zeros for a part of n are
//! taken out. Where no other one lies in the range, the sign of that polynomial says on which side of tan ψ a number
//! is; the range itself ends at a rational number beyond tan ψ.

use crate::algebra::divisors::gcd::checked_gcd;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;
use crate::algebra::work::Work;

/// An end of a range.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    /// A number beyond the end.
    pub(super) beyond: Rational,
    /// In the range, a polynomial that is positive inside of the end and zero there.
    pub(super) inside: Poly,
}

/// Larger n are not tried.
const MAX_MULTIPLE: i64 = 24;

/// The end at tan(πψ) of a range of `var` whose other end is tan(πother), both less than a quarter turn; `None` where more
/// than one zero lies in the range.
pub(super) fn edge(var: Var, psi: &Rational, other: &Rational) -> Option<Edge> {
    if psi.is_negative() {
        let Edge { beyond, inside } = edge(var, &-psi, &-other)?;
        return Some(Edge { beyond: -beyond, inside: inside.substitute(var, &-&Poly::var(var)) });
    }
    let eighths = psi * &Rational::from(4);
    let n = eighths.denom().to_i64().filter(|n| *n <= MAX_MULTIPLE)?;
    let k = (&eighths * &Rational::from(n)).to_i64()?;
    // Also where both ends are n-th parts of a turn from one another, if the other one is at 0: that zero is taken out.
    let gap = &(psi - other).abs() * &Rational::from(n);
    let is_zero_apart = other.is_zero() && k % 4 == 0;
    if gap > Rational::ONE || gap.is_one() && !is_zero_apart {
        return None;
    }
    let all = vanishing(var, n, k)?;
    let zero = primitive(var, psi)?;
    let sign_of = |p: &Poly, at: &Rational| p.at(var, at).as_constant().map_or(0, |c| c.signum());
    let sign = |at: &Rational| sign_of(&all, at);
    // The zeros below tan ψ are passed by steps that are shorter than their distances.
    let mut below = Rational::new(1, 2 * n);
    let mut above = below.clone();
    for _ in 0..(k + 3) / 4 {
        below = above.clone();
        while sign(&above) == sign(&below) {
            below = above;
            above = simplest_within(&(&below * &Rational::new(33, 32)), &(&below * &Rational::new(17, 16)));
        }
    }
    for _ in 0..12 {
        let middle = &(&below + &above) * &Rational::new(1, 2);
        if sign(&middle) == sign(&below) { below = middle } else { above = middle }
    }
    let is_upper = psi > other;
    let beyond = if is_upper {
        simplest_within(&above, &(&above * &Rational::new(65, 64)))
    } else {
        simplest_within(&(&below * &Rational::new(63, 64)), &below)
    };
    let outside = sign_of(&zero, &beyond);
    let turned = sign_of(&zero, if is_upper { &below } else { &above });
    (outside * turned < 0).then(|| Edge { beyond, inside: if turned < 0 { -&zero } else { zero } })
}

/// A polynomial that vanishes at tan ψ, and at the tangents of all angles whose n-th multiples differ from nψ by halves of a
/// turn, where nψ is k eighth turns; without the zero at 0.
fn vanishing(var: Var, n: i64, k: i64) -> Option<Poly> {
    let [quarter, half, three, whole] = multiples(var, n);
    match k.rem_euclid(4) {
        0 => whole.div_exact(&Poly::var(var)),
        1 => Some(quarter),
        2 => Some(half),
        _ => Some(three),
    }
}

/// A polynomial that vanishes at tan(πψ) and not where a smaller multiple of the angle is one of eighth turns.
pub(super) fn primitive(var: Var, psi: &Rational) -> Option<Poly> {
    let eighths = psi * &Rational::from(4);
    let n = eighths.denom().to_i64().filter(|n| *n <= MAX_MULTIPLE)?;
    let k = (&eighths * &Rational::from(n)).to_i64()?;
    let (mut zero, work) = (vanishing(var, n, k)?, &mut Work::usual(1));
    // Zeros whose smaller multiples are whole eighth turns are others.
    for d in (1..n).filter(|d| n % d == 0) {
        for other in multiples(var, d) {
            let common = checked_gcd(&zero, &other, work)?;
            zero = zero.div_exact(&common)?;
        }
    }
    Some(zero)
}

/// Polynomials whose zeros are the tangents of the angles of which the n-th multiples are one, two, three, and four eighth
/// turns, each up to whole halves of a turn.
fn multiples(var: Var, n: i64) -> [Poly; 4] {
    let x = Poly::var(var);
    let (mut re, mut im) = (Poly::one(), Poly::zero());
    for _ in 0..n {
        (re, im) = (&re - &(&im * &x), &im + &(&re * &x));
    }
    [&im - &re, re.clone(), &im + &re, im]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::rational::ToFloat as _;

    /// Of an end the condition holds for the tangents inside, and fails for those outside up to the widened range.
    #[test]
    fn edges_separate_tangents() {
        let x = Var(0);
        let mut found = 0;
        for n in 1..=12_i64 {
            for p in 1..=n {
                // ψ = pπ/(2n), less than a quarter turn; the other end at 0, or as far on the other side.
                let psi = Rational::new(p, 2 * n);
                if (&psi * &Rational::from(4)).is_integer() || psi >= Rational::new(1, 2) {
                    continue;
                }
                let tangent = (core::f64::consts::PI * psi.to_f64()).tan();
                for other in [Rational::ZERO, -&psi, &psi * &Rational::new(1, 2)] {
                    let Some(Edge { beyond, inside }) = edge(x, &psi, &other) else { continue };
                    found += 1;
                    assert!(beyond.to_f64() > tangent && beyond.to_f64() < 1.02 * tangent, "{psi} {other}");
                    let low = (core::f64::consts::PI * other.to_f64()).tan();
                    let low = Rational::new((low * 1e6).ceil() as i64, 1_000_000);
                    for j in 1..1000 {
                        let at = &low + &(&Rational::new(j, 1000) * &(&beyond - &low));
                        let value = inside.at(x, &at).as_constant().unwrap();
                        assert_eq!(value.is_positive(), at.to_f64() < tangent, "{psi} {other} {at}");
                    }
                    // The mirrored end, which is a lower one.
                    let mirrored = edge(x, &-&psi, &-&other).unwrap();
                    assert_eq!(mirrored.beyond, -beyond);
                }
            }
        }
        assert!(found > 40, "{found}");
        let lower = edge(x, &Rational::new(1, 6), &Rational::new(1, 3)).unwrap();
        assert!(
            lower.beyond.to_f64() < 0.578
                && lower.inside.at(x, &Rational::ONE).as_constant().unwrap().is_positive()
        );
    }
}
