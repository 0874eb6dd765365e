//! Signs of products.
//!
//! A product is ≥ 0 where its factors are, up to the signs of an even number of them: (sinh(t) − t)·(α − λ·t) where each of them is. Each
//! factor goes a way of its own. Of a numerator in the tangent x of an angle each factor takes as many denominators, 1 + x² or 1 − x²,
//! as it needs to be a polynomial in sine and cosine again, whose derivatives are short.

use basis_prover::collections::sort::sort_by_key;

use super::sample::Sample;
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::work::Work;

/// The factors of a value, each with the sign that makes it ≥ 0 where it is looked at; `None` for a numerator with a single one,
/// where a factor has both signs, and where an odd number of them is negative. Those of which there is an even power are left out unless
/// the value is to be > 0.
pub(super) fn factors(
    value: &Fraction,
    strict: bool,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Fraction>> {
    let (above, numerators) = checked_factor(value.numer(), work)?;
    let (below, mut denominators) = checked_factor(value.denom(), work)?;
    // A tangent that is a part of another one stands beside that one in its denominator.
    sort_by_key(&mut denominators, |(denominator, _)| core::cmp::Reverse(denominator.variables().len()));
    let mut parts: Vec<(Fraction, u32)> = Vec::new();
    for (numerator, exponent) in numerators {
        let mut divisor = Poly::one();
        for (denominator, left) in &mut denominators {
            let Some(x) = denominator.variables().pop() else { continue };
            let own = numerator.degree(x).saturating_sub(divisor.degree(x));
            let needed = own.div_ceil(denominator.degree(x));
            if needed * exponent <= *left {
                *left -= needed * exponent;
                divisor = &divisor * &denominator.pow(needed);
            }
        }
        parts.push((Fraction::new(numerator, divisor)?, exponent));
    }
    if parts.len() < 2 && parts.iter().all(|(_, exponent)| *exponent == 1) {
        return None;
    }
    let left = denominators.into_iter().filter(|(_, exponent)| *exponent > 0);
    parts.extend(left.map(|(denominator, exponent)| (Fraction::from(denominator), exponent)));
    let (mut sign, mut all) = (above.signum() * below.signum(), Vec::new());
    for (part, exponent) in parts {
        let is_even = exponent.is_multiple_of(2);
        if is_even && !strict {
            continue;
        }
        let own = sign_of(&part, sample, work)?;
        sign *= if is_even { 1 } else { own };
        all.push(if own < 0 { -&part } else { part });
    }
    (sign > 0).then_some(all)
}

/// The sign that a value has wherever it is looked at and not 0.
fn sign_of(value: &Fraction, sample: &Sample<'_>, work: &mut Work) -> Option<i32> {
    let signs = sample.signs(value, work)?;
    let mut signs = signs.into_iter().flatten().filter(|sign| *sign != 0);
    let first = signs.next()?;
    signs.all(|sign| sign == first).then_some(first)
}
