//! Bounds for an angle or an exponent that stands beside its own sine or exponential: by quotients of polynomials in its
//! tangent.
//!
//! **Theorems** (continued fractions of C. F. Gauss 1813, and J. H. Lambert). For z > 0
//!
//! arctan z = z/(1 + T₁) with Tₖ = k²z²/(2k + 1 + Tₖ₊₁) > 0:
//!
//! put 0 in place of Tₙ and the quotient is too large for odd n, too small for even n. For 0 < z < 1
//!
//! artanh z = z/(1 − T₁) with Tₖ = k²z²/(2k + 1 − Tₖ₊₁), 0 < Tₖ < k·z²:
//!
//! put 0 in place of Tₙ and the quotient is too small, put n·z² and it is too large. (Tₖ/z² is a power series in z² with
//! coefficients ≥ 0, and its limit at z = 1 is k.) No denominator vanishes there, and both sides are odd in z.
//!
//! An angle s with x = tan(v·(s − shift)) is therefore between two quotients in x. Measured from an end e of its range it is
//! e + arctan(z)/v with z = (x − xₑ)/(1 + x·xₑ), and the bounds are exact at that end; for tanh it is 1 − x·xₑ. Measured from a
//! point whose tangent is rational, and which is itself only known between bounds, they hold where z ≥ 0.
//! What holds for all numbers between the bounds in place of s holds for s.

use std::sync::LazyLock;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::{Analytic, Angle, Kind};
use crate::model::bernstein::to_bernstein;

/// More terms than this are not expanded.
const MAX_TERMS: usize = 6000;

/// The number from which an angle is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    /// Where the tangent is 0.
    Zero,
    /// The lower end of its range.
    Low,
    /// The upper end.
    High,
    /// Where the tangent is this many parts of [`UNIT`]: the bounds hold where it is not smaller.
    At(i64),
}

/// The denominator of tangents from which angles are measured.
pub(crate) const UNIT: i64 = 1 << 12;

/// The level of bounds for the angles that have these tangents, and their bits after the point.
const SHARP: u32 = 30;
const SHORT: u32 = 30;

/// How an angle is bounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct From<'a> {
    /// From where it is measured.
    pub(crate) anchor: Anchor,
    /// The range of its variable.
    pub(crate) range: &'a Range,
    /// The level at which the continued fraction is cut off.
    pub(crate) n: u32,
    /// A point of the domain.
    pub(crate) typical: &'a [(Var, Rational)],
}

/// A quotient of polynomials, with a positive denominator, that bounds an angle.
struct Bound {
    above: Poly,
    below: Poly,
}

/// The two bounds of z⁻¹·arctan z or z⁻¹·artanh z as coefficients in z², above and below the fraction line.
fn quotients(kind: Kind, n: u32) -> [[Vec<Rational>; 2]; 2] {
    let number = |k: u32| Rational::from(i64::from(k));
    let step = |(a, b): (Vec<Rational>, Vec<Rational>), k: u32| {
        // (2k − 1) ± k²z²/(a/b)
        let factor = if kind == Kind::Circular { number(k * k) } else { -number(k * k) };
        let mut sum: Vec<Rational> = a.iter().map(|c| c * &number(2 * k - 1)).collect();
        sum.resize(sum.len().max(b.len() + 1), Rational::ZERO);
        for (i, c) in b.iter().enumerate() {
            sum[i + 1] += &(c * &factor);
        }
        (sum, a)
    };
    let whole = |n: u32, tail: Option<Rational>| {
        let first: Vec<Rational> = core::iter::once(number(2 * n - 1)).chain(tail).collect();
        let (below, above) = (1..n).rev().fold((first, vec![Rational::ONE]), step);
        [above, below]
    };
    match kind {
        Kind::Hyperbolic => [whole(n, None), whole(n, Some(-number(n)))],
        Kind::Circular | Kind::Linear => [whole(n, None), whole(n + 1, None)],
    }
}

/// Numbers below and above π, from π = 16 arctan(1/5) − 4 arctan(1/239).
pub(crate) fn pi_bounds() -> &'static (Rational, Rational) {
    static BOUNDS: LazyLock<(Rational, Rational)> = LazyLock::new(pi_from_arctangents);
    &BOUNDS
}

fn pi_from_arctangents() -> (Rational, Rational) {
    // The partial sums of an alternating series lie on both sides of its value.
    let arctan = |n: i64, terms: u32| {
        let x = Rational::new(1, n);
        (0..terms).fold(Rational::ZERO, |sum, k| {
            let term = &x.pow(2 * k + 1) * &Rational::new(1, i64::from(2 * k + 1));
            if k % 2 == 0 { &sum + &term } else { &sum - &term }
        })
    };
    let bound = |terms: u32| {
        let (a, b) = (arctan(5, terms), arctan(239, terms + 1));
        &(&Rational::from(16) * &a) - &(&Rational::from(4) * &b)
    };
    (bound(16), bound(15))
}

/// The bits after the point of bounds of angles.
const BITS: u32 = 100;

/// Numbers between which arctan 1/2 lies, and artanh 1/3.
fn step_bounds(kind: Kind) -> Option<&'static (Rational, Rational)> {
    const LEVEL: u32 = 40;
    static BOUNDS: LazyLock<[Option<(Rational, Rational)>; 2]> = LazyLock::new(|| {
        [(Kind::Circular, 2), (Kind::Hyperbolic, 3)]
            .map(|(kind, n)| quotient_bounds(kind, &Rational::new(1, n), LEVEL))
    });
    BOUNDS[usize::from(kind == Kind::Hyperbolic)].as_ref()
}

/// Longer numbers are left to the quotients, as far from 0 as they are.
const LONG: u64 = 400;

/// Numbers between which arctan z or artanh z lies; `None` where there is no artanh z. Far from 0 by the differences from
/// arctan 1/2, and from artanh 1/3 as often as needed: the quotients are good for small numbers.
pub(crate) fn inverse(kind: Kind, z: &Rational, n: u32) -> Option<(Rational, Rational)> {
    let square = z * z;
    if kind == Kind::Hyperbolic && square >= Rational::ONE {
        return None;
    }
    if kind == Kind::Circular && square > Rational::ONE {
        // arctan z = ±π/2 − arctan 1/z.
        let ((a, b), (low, high)) = (inverse(kind, &z.recip()?, n)?, pi_bounds());
        let quarter = |pi: &Rational| pi * &Rational::new(1, 2);
        let (low, high) = (quarter(low), quarter(high));
        return Some(if z.is_negative() { (&-&high - &b, &-&low - &a) } else { (&low - &b, &high - &a) });
    }
    let third = Rational::new(1, 3);
    if z.abs() > third && kind != Kind::Linear && z.bits() < LONG {
        let step = if kind == Kind::Circular { Rational::new(1, 2) } else { third };
        let step = if z.is_negative() { -step } else { step };
        let product = z * &step;
        let below = if kind == Kind::Circular { Rational::ONE + product } else { Rational::ONE - product };
        let (low, high) = inverse(kind, &(z - &step).checked_div(&below)?, n)?;
        let (a, b) = step_bounds(kind)?;
        return Some(if z.is_negative() { (&low - b, &high - a) } else { (&low + a, &high + b) });
    }
    quotient_bounds(kind, z, n)
}

/// The same by the quotients themselves.
fn quotient_bounds(kind: Kind, z: &Rational, n: u32) -> Option<(Rational, Rational)> {
    let (p, q) = (z.numer(), z.denom());
    let (p_square, q_square) = (&p * &p, &q * &q);
    // Σ cᵢ·p²ⁱ·q²⁽ᵐ⁻ⁱ⁾: whole numbers, as common factors of long fractions are not looked for in little time.
    let value = |c: &[Rational]| {
        let (mut sum, mut power) = (Rational::ZERO, Rational::ONE);
        for c in c.iter().rev() {
            sum = &(&sum * &p_square) + &(c * &power);
            power = &power * &q_square;
        }
        sum
    };
    let [a, b] = quotients(kind, n).map(|[above, below]| {
        let rest =
            |from: &[Rational], to: &[Rational]| q_square.pow(to.len().saturating_sub(from.len()) as u32);
        let numerator = &(&p * &value(&above)) * &rest(&above, &below);
        let denominator = &(&q * &value(&below)) * &rest(&below, &above);
        around(&numerator, &denominator)
    });
    let ((a, above_a), (b, above_b)) = (a?, b?);
    Some(if a < b { (a, above_b) } else { (b, above_a) })
}

/// Numbers with [`BITS`] bits after the point below and above the quotient of a whole number and a positive one.
fn around(numerator: &Rational, denominator: &Rational) -> Option<(Rational, Rational)> {
    let unit = Rational::from(2).pow(BITS);
    let (above, below) = ((numerator * &unit).to_whole()?, denominator.to_whole()?);
    // Cut off towards 0.
    let part = Rational::ratio(above / below, 1.into());
    let (low, high) = if numerator.is_negative() { (-1, 0) } else { (0, 1) };
    let at = |n: i64| (&part + &Rational::from(n)).checked_div(&unit);
    Some((at(low)?, at(high)?))
}

/// The multiples Σ cᵢ·p²ⁱ·q²⁽ᵐ⁻ⁱ⁾.
fn homogeneous(coefficients: &[Rational], p: &Poly, q: &Poly, m: usize) -> Poly {
    let (p, q) = (p * p, q * q);
    let mut sum = Poly::zero();
    for (i, c) in coefficients.iter().enumerate() {
        sum = &sum + &(&p.pow(i as u32) * &q.pow((m - i) as u32)).scale(c);
    }
    sum
}

impl Angle {
    /// The two bounds of the angle; `None` for one that is no angle, or where it has no such end.
    fn bounds(&self, analytic: &Analytic, from: &From<'_>) -> Option<[Bound; 2]> {
        let From { anchor, range, n, typical } = *from;
        if self.kind == Kind::Linear {
            return None;
        }
        let x = self.tangent();
        let pi = || analytic.pi.map(Fraction::var);
        let (at, start) = match anchor {
            Anchor::Zero | Anchor::At(_) => {
                let at =
                    if let Anchor::At(parts) = anchor { Rational::new(parts, UNIT) } else { Rational::ZERO };
                let shift = Fraction::constant(self.shift.clone());
                let start = if self.turns || self.shift.is_zero() { shift } else { &shift * &pi()? };
                (Fraction::constant(at), start)
            }
            Anchor::Low | Anchor::High => {
                let side = usize::from(anchor == Anchor::High);
                let end = [&range.low, &range.high][side].value()?;
                let at = x.substitute(self.var, &Fraction::constant(end.clone()))?;
                (at, self.limits[side].clone())
            }
        };
        // z = p/q, the difference of the angles as a tangent.
        let across = &(x.denom() * at.denom());
        let product = x.numer() * at.numer();
        let q = if self.kind == Kind::Circular { across + &product } else { across - &product };
        let p = &(x.numer() * at.denom()) - &(at.numer() * x.denom());
        // The denominators of a tangent vanish nowhere, nor does 1 ± x·xₑ; so q has the sign of one of its values.
        let value = typical.iter().fold(q.clone(), |q, (var, x)| q.at(*var, x)).as_constant()?;
        let (p, q) = match value.signum() {
            1 => (p, q),
            -1 => (-&p, -&q),
            _ => return None,
        };
        let start = start.as_poly()?.clone();
        let mut rate = Poly::constant(self.rate.clone());
        if self.turns {
            rate = &rate * pi()?.numer();
        }
        // The angle that has a tangent in the middle, times the rate, is only known between bounds.
        let middle = match anchor {
            Anchor::At(parts) => {
                let (low, high) = inverse(self.kind, &Rational::new(parts, UNIT), SHARP)?;
                // Short numbers: what is expanded with them is shorter.
                let unit = Rational::from(1 << SHORT);
                let above = -(-(&high * &unit)).floor();
                [(&low * &unit).floor().checked_div(&unit)?, above.checked_div(&unit)?]
            }
            _ => [Rational::ZERO, Rational::ZERO],
        };
        // Of numbers z > 0 the lower one comes first.
        let [mut first, mut second] = quotients(self.kind, n);
        if self.kind == Kind::Circular && n % 2 == 1 {
            (first, second) = (second, first);
        }
        let bound = |[above, below]: [Vec<Rational>; 2], middle: &Rational| {
            let m = above.len().max(below.len()) - 1;
            let above = &p * &homogeneous(&above, &p, &q, m);
            let own = &q * &homogeneous(&below, &p, &q, m);
            let below = &own * &rate;
            Bound { above: &(&(&start * &below) + &above) + &own.scale(middle), below }
        };
        Some([bound(first, &middle[0]), bound(second, &middle[1])])
    }
}

/// A polynomial f that contains an angle itself, as polynomials without it: f ≥ 0 (> 0) if all of them are, and f ≤ 0 (< 0)
/// if all of them are.
///
/// Of degree 1 in the angle there are two, one for each bound, unless it shall be a single one. In a single one the variable
/// of the angle runs from 0 to 1 between the bounds. In short cells there is one for each Bernstein polynomial between the bounds.
pub(crate) fn without(
    f: &Poly,
    analytic: &Analytic,
    angle: &Angle,
    from: &From<'_>,
    single: bool,
    work: &mut Work,
) -> Option<Vec<Poly>> {
    let degree = f.degree(angle.itself);
    let bounds = angle.bounds(analytic, from)?;
    if degree == 1 && !single {
        let [low, high] = &bounds;
        return Some(vec![
            put(f, angle.itself, degree, low, work)?,
            put(f, angle.itself, degree, high, work)?,
        ]);
    }
    let between = between(angle, bounds, work)?;
    let whole = put(f, angle.itself, degree, &between, work)?;
    if single || !matches!(from.anchor, Anchor::At(_)) {
        return Some(vec![whole]);
    }
    // Between narrow bounds nothing is lost by the coefficients of Bernstein's polynomials, and they have a variable less.
    let powers = whole.coefficients_in(angle.itself);
    Some(to_bernstein(&powers, powers.len().saturating_sub(1) as u32))
}

/// The polynomials of a row of a matrix, in which the variable of the angle runs from 0 to 1 between the bounds: all times the
/// same positive denominator.
pub(crate) fn row_without(
    row: &[Poly],
    analytic: &Analytic,
    angle: &Angle,
    from: &From<'_>,
    work: &mut Work,
) -> Option<Vec<Poly>> {
    let between = between(angle, angle.bounds(analytic, from)?, work)?;
    let degree = row.iter().map(|p| p.degree(angle.itself)).max().unwrap_or(0);
    row.iter().map(|p| put(p, angle.itself, degree, &between, work)).collect()
}

/// All numbers between two bounds, as the variable of the angle runs from 0 to 1.
fn between(angle: &Angle, [low, high]: [Bound; 2], work: &mut Work) -> Option<Bound> {
    let s = Poly::var(angle.itself);
    let (first, last) =
        (multiplied(&low.above, &high.below, work)?, multiplied(&high.above, &low.below, work)?);
    let above = &first + &multiplied(&s, &(&last - &first), work)?;
    let below = multiplied(&low.below, &high.below, work)?;
    Some(Bound { above, below })
}

/// A polynomial with a quotient in place of a variable, times a power of its denominator, which is positive.
fn put(f: &Poly, var: Var, degree: u32, Bound { above, below }: &Bound, work: &mut Work) -> Option<Poly> {
    let parts = f.coefficients_in(var);
    let mut rest = vec![Poly::one()];
    for k in 0..degree as usize {
        rest.push(multiplied(&rest[k], below, work)?);
    }
    let (mut sum, mut power) = (Poly::zero(), Poly::one());
    for (part, rest) in parts.iter().zip(rest.iter().rev()) {
        sum = &sum + &multiplied(&multiplied(part, &power, work)?, rest, work)?;
        power = multiplied(&power, above, work)?;
    }
    Some(sum)
}

fn multiplied(a: &Poly, b: &Poly, work: &mut Work) -> Option<Poly> {
    work.spend_product(a, b)?;
    Some(a * b).filter(|p| p.len() <= MAX_TERMS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::rational::ToFloat as _;

    /// Bounds on both sides, and that they become narrower; the exact value by the float of the standard library.
    #[test]
    fn bounds_are_on_both_sides() {
        for kind in [Kind::Circular, Kind::Hyperbolic] {
            for (a, b) in [(1, 1000), (1, 3), (-2, 3), (9, 10), (99, 100), (14, 1), (-7, 2)] {
                let z = Rational::new(a, b);
                if kind == Kind::Hyperbolic && z.abs() > Rational::ONE {
                    assert!(inverse(kind, &z, 3).is_none());
                    continue;
                }
                let exact = if kind == Kind::Circular { z.to_f64().atan() } else { z.to_f64().atanh() };
                let mut before = f64::INFINITY;
                for n in 1..12 {
                    let (low, high) = inverse(kind, &z, n).expect("bounds");
                    assert!(low < high, "{kind:?} {z} {n}");
                    let tiny = 1e-15 * exact.abs();
                    assert!(
                        low.to_f64() <= exact + tiny && exact - tiny <= high.to_f64(),
                        "{kind:?} {z} {n}"
                    );
                    let width = (&high - &low).to_f64();
                    assert!(width < before || width < 1e-29, "{kind:?} {z} {n}");
                    before = width;
                }
            }
        }
    }

    #[test]
    fn pi_lies_between_its_bounds() {
        let (low, high) = pi_bounds();
        assert!(low.to_f64() <= core::f64::consts::PI && core::f64::consts::PI <= high.to_f64());
        assert!(low < high && high - low < Rational::from(10).pow(18).recip().unwrap());
    }

    #[test]
    fn the_first_bounds() {
        let third = Rational::new(1, 3);
        // x/(1 + x²/3) and x; x and x/(1 − x²).
        let unit = Rational::from(2).pow(BITS).recip().expect("not zero");
        for (kind, low, high) in [
            (Kind::Circular, Rational::new(9, 28), third.clone()),
            (Kind::Hyperbolic, third.clone(), Rational::new(3, 8)),
        ] {
            let (a, b) = inverse(kind, &third, 1).expect("bounds");
            assert!(a <= low && &low - &a <= unit && high <= b && &b - &high <= unit);
            let (c, d) = inverse(kind, &-&third, 1).expect("bounds");
            assert!(c <= -&high && -&low <= d && &d - &c <= &(&b - &a) + &unit);
        }
    }
}
