//! Real roots of polynomials in one variable: isolation by Descartes' rule of signs in Bernstein form.

use super::simplest::{simplest_between, simplest_within, spend_simplest};
use crate::algebra::fibre;
use crate::algebra::number::modulo;
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;

/// Where one root is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Root {
    /// Exactly here.
    Exact(Rational),
    /// The only root strictly between two numbers that are no roots.
    Between(Rational, Rational),
}

impl Root {
    /// The greatest known number that is not above the root.
    pub fn low(&self) -> &Rational {
        match self {
            Self::Exact(x) | Self::Between(x, _) => x,
        }
    }

    /// The least known number that is not below the root.
    pub fn high(&self) -> &Rational {
        match self {
            Self::Exact(x) | Self::Between(_, x) => x,
        }
    }

    /// Halves the interval.
    pub fn refine(&mut self, p: &Univariate, work: &mut Work) -> Option<()> {
        let Self::Between(low, high) = self else { return Some(()) };
        let middle = half(&(&*low + &*high));
        spend_value(p, &middle, work)?;
        spend_value(p, low, work)?;
        let sign = p.sign_at(&middle);
        if sign == 0 {
            *self = Self::Exact(middle);
        } else if sign == p.sign_at(low) {
            *low = middle;
        } else {
            *high = middle;
        }
        Some(())
    }

    /// Finds out whether the root is rational; if it is, it is exact from then on.
    ///
    /// With L the leading coefficient of p without common factor, L·x is a whole number for a rational root x.
    pub fn detect_rational(&mut self, p: &Univariate, work: &mut Work) -> Option<()> {
        if matches!(self, Self::Exact(_)) {
            return Some(());
        }
        let p = primitive(p, work)?;
        let lead = p.leading().abs();
        if let ([constant, _], false) = (p.coefficients(), lead.is_zero()) {
            *self = Self::Exact(-&(constant / &p.leading()));
            return Some(());
        }
        if has_no_rational_root(&p, work)? {
            return Some(());
        }
        let mut round = 0_u32;
        while let Self::Between(low, high) = self {
            work.spend_fractions(lead.bits() + low.bits() + high.bits())?;
            let next = &(&*low * &lead).floor() + &Rational::ONE;
            let end = &*high * &lead;
            if next >= end {
                return Some(());
            }
            let single = &next + &Rational::ONE >= end;
            // A simple root is found long before the interval is short.
            let candidate = if single {
                &next / &lead
            } else if round.is_power_of_two() || round == 0 {
                spend_simplest(low, high, work)?;
                simplest_between(Some(low), Some(high))
            } else {
                self.refine(&p, work)?;
                round += 1;
                continue;
            };
            spend_value(&p, &candidate, work)?;
            if p.sign_at(&candidate) == 0 {
                *self = Self::Exact(candidate);
                return Some(());
            }
            if single {
                return Some(());
            }
            self.refine(&p, work)?;
            round += 1;
        }
        Some(())
    }
}

fn half(x: &Rational) -> Rational {
    x * &Rational::new(1, 2)
}

/// Counts the work of one value, of fractions in lowest terms.
fn spend_value(p: &Univariate, x: &Rational, work: &mut Work) -> Option<()> {
    let n = p.degree() as u64;
    work.spend_fractions(x.bits())?;
    work.spend(30 + 6 * n * weight(p.max_bits() + n * x.bits()))?;
    p.spend_sign(x, work)
}

/// Whether the polynomial has no root modulo one of a few primes, and so no rational root.
fn has_no_rational_root(p: &Univariate, work: &mut Work) -> Option<bool> {
    for prime in [5_u32, 7, 11, 13, 17, 19, 23, 29, 31, 37] {
        work.spend(u64::from(prime) * p.coefficients().len() as u64 / 2)?;
        let residues: Option<Vec<u32>> = p.coefficients().iter().map(|c| modulo(c, prime)).collect();
        let Some(residues) = residues else { continue };
        if residues.last() == Some(&0) {
            continue; // the prime may divide the denominator of the root
        }
        let value = |x: u32| residues.iter().rev().fold(0, |v, c| (v * x + c) % prime);
        if (0..prime).all(|x| value(x) != 0) {
            return Some(true);
        }
    }
    Some(false)
}

/// The real roots of a polynomial without multiple roots strictly between two numbers (`None`: no limit), in
/// increasing order. The intervals are disjoint but may share ends; none reaches a limit.
///
/// `None` when the work is spent.
pub fn isolate(
    p: &Univariate,
    low: Option<&Rational>,
    high: Option<&Rational>,
    work: &mut Work,
) -> Option<Vec<Root>> {
    let mut roots = Vec::new();
    if p.is_constant() || matches!((low, high), (Some(a), Some(b)) if a >= b) {
        return Some(roots);
    }
    let p = primitive(p, work)?;
    // Outside of [−bound, bound] are no roots, and none at its ends.
    let bound = bound(&p);
    let start = low.cloned().unwrap_or(-&bound);
    let end = high.cloned().unwrap_or(bound);
    if start >= end {
        return Some(roots);
    }
    let mut stack = vec![(on_interval(&p, &start, &end, work)?, start, end)];
    while let Some((form, low, high)) = stack.pop() {
        if form.is_empty() {
            roots.push(Root::Exact(low));
            continue;
        }
        let variations = variations(&form);
        if variations == 0 {
            continue;
        }
        let at_end = |c: Option<&Rational>| c.is_none_or(Rational::is_zero);
        if variations == 1 && !at_end(form.first()) && !at_end(form.last()) {
            roots.push(Root::Between(low, high));
            continue;
        }
        let middle = half(&(&low + &high));
        let (left, right) = halves(&form, work)?;
        // From left to right: the left half, a root in the middle (marked by an empty form), the right half.
        let root = at_end(left.last());
        stack.push((right, middle.clone(), high));
        if root {
            stack.push((Vec::new(), middle.clone(), middle.clone()));
        }
        stack.push((left, low, middle));
    }
    for root in &mut roots {
        while matches!(root, Root::Between(a, b) if Some(&*a) == low || Some(&*b) == high) {
            root.refine(&p, work)?;
        }
    }
    Some(roots)
}

/// A power of two above the absolute value of every root, complex ones too: 2·max |aₙ₋ₖ/aₙ|^(1/k), rounded up; 2 for
/// a polynomial without roots.
pub fn bound(p: &Univariate) -> Rational {
    let n = p.degree();
    let size = |c: &Rational| c.numer().bits() as i64; // |c| < 2^(bits − 1), as the denominator takes one bit
    let lead = size(&p.leading());
    let exponent = p
        .coefficients()
        .iter()
        .enumerate()
        .take(n)
        .filter(|(_, c)| !c.is_zero())
        .map(|(i, c)| {
            let quotient = size(c) - lead + 1; // |aᵢ/aₙ| < 2^quotient
            let k = (n - i) as i64;
            if quotient > 0 { (quotient + k - 1) / k } else { quotient / k }
        })
        .max()
        .unwrap_or(0);
    let exponent = exponent + 1;
    let power = Rational::from(2).pow(exponent.unsigned_abs() as u32);
    if exponent < 0 { power.recip().unwrap_or(Rational::ONE) } else { power }
}

/// The work of a sum of numbers of this length in bits, compared with one of machine words: longer ones take memory, and common
/// divisors.
const fn weight(bits: u64) -> u64 {
    if bits < 64 { 1 } else { 6 + bits / 32 }
}

/// The polynomial with whole coefficients without common factor.
fn primitive(p: &Univariate, work: &mut Work) -> Option<Univariate> {
    for c in p.coefficients() {
        work.spend_fractions(c.bits())?;
    }
    Some(p.primitive())
}

/// The Bernstein form on an interval, without the binomial coefficients.
fn on_interval(p: &Univariate, low: &Rational, high: &Rational, work: &mut Work) -> Option<Vec<Rational>> {
    let n = p.degree() as u64;
    work.spend(2 * n * n * weight(p.max_bits() + n * (low.bits() + high.bits())) + 50)?;
    let mut form = p.coefficients().to_vec();
    fibre::apply(&fibre::on_interval(low, high), &mut form);
    Some(form)
}

/// The forms of the two halves of the interval.
fn halves(form: &[Rational], work: &mut Work) -> Option<(Vec<Rational>, Vec<Rational>)> {
    let n = form.len() as u64;
    let bits = form.iter().map(Rational::bits).max().unwrap_or(0);
    work.spend(n * n * weight(bits) + 50)?;
    let (mut left, mut right) = (form.to_vec(), form.to_vec());
    fibre::apply(&fibre::lower_half(), &mut left);
    fibre::apply(&fibre::upper_half(), &mut right);
    Some((left, right))
}

/// The number of changes of sign, zeros left out.
pub fn variations(coefficients: &[Rational]) -> usize {
    let mut last = 0;
    let mut count = 0;
    for c in coefficients {
        let sign = c.signum();
        if sign != 0 {
            count += usize::from(last == -sign);
            last = sign;
        }
    }
    count
}

/// Simple numbers, one in each of the open intervals into which the roots cut the open interval (low, high).
pub fn between_roots(roots: &[Root], low: Option<&Rational>, high: Option<&Rational>) -> Vec<Rational> {
    let mut samples = Vec::with_capacity(roots.len() + 1);
    for k in 0..=roots.len() {
        let before = k.checked_sub(1).and_then(|k| roots.get(k));
        let after = roots.get(k);
        // Ends of intervals are no roots and may be taken; exact roots and the limits may not.
        let sample = match (before, after) {
            (Some(Root::Between(_, a)), Some(Root::Between(b, _))) => simplest_within(a, b),
            _ => simplest_between(before.map(Root::high).or(low), after.map(Root::low).or(high)),
        };
        samples.push(sample);
    }
    samples
}

/// x − root, times the denominator of the root.
pub fn linear(root: &Rational) -> Univariate {
    Univariate::new(vec![-root.numer(), root.denom()])
}

/// The rational roots of a polynomial without multiple roots, in increasing order; `None` when the work is spent.
pub fn rational_roots(p: &Univariate, work: &mut Work) -> Option<Vec<Rational>> {
    let mut exact = Vec::new();
    for mut root in isolate(p, None, None, work)? {
        root.detect_rational(p, work)?;
        if let Root::Exact(x) = root {
            exact.push(x);
        }
    }
    Some(exact)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn r(n: i64, d: i64) -> Rational {
        Rational::new(n, d)
    }
    fn p(c: &[i64]) -> Univariate {
        Univariate::integers(c)
    }
    fn roots(q: &Univariate, low: Option<i64>, high: Option<i64>) -> Vec<Root> {
        let (low, high) = (low.map(Rational::from), high.map(Rational::from));
        let work = &mut Work::unlimited();
        let mut found = isolate(q, low.as_ref(), high.as_ref(), work).expect("unlimited");
        for root in &mut found {
            root.detect_rational(q, work).expect("unlimited");
        }
        found
    }

    #[test]
    fn finds_rational_roots_exactly() {
        // (3x − 1)(2x − 1)(x + 5)(x − 7)
        let q = p(&[-1, 3]).mul(&p(&[-1, 2])).mul(&p(&[5, 1])).mul(&p(&[-7, 1]));
        let exact =
            |list: &[(i64, i64)]| list.iter().map(|(n, d)| Root::Exact(r(*n, *d))).collect::<Vec<_>>();
        assert_eq!(roots(&q, None, None), exact(&[(-5, 1), (1, 3), (1, 2), (7, 1)]));
        assert_eq!(roots(&q, Some(0), Some(1)), exact(&[(1, 3), (1, 2)]));
        assert_eq!(roots(&q, Some(-5), Some(7)), exact(&[(1, 3), (1, 2)]));
        assert_eq!(roots(&q, Some(1), None), exact(&[(7, 1)]));
        assert_eq!(roots(&q, Some(8), Some(9)), vec![]);
        let big = p(&[-123_457, 1_000_003]).mul(&p(&[-2, 0, 1]));
        assert_eq!(roots(&big, Some(0), Some(1)), exact(&[(123_457, 1_000_003)]));
        assert_eq!(roots(&p(&[0, 1]), None, None), exact(&[(0, 1)]));
    }

    #[test]
    fn isolates_irrational_roots() {
        // x(x² − 2)(100x² − 201): two pairs of close roots
        let q = p(&[0, 1]).mul(&p(&[-2, 0, 1])).mul(&p(&[-201, 0, 100]));
        let found = roots(&q, None, None);
        assert_eq!(found.len(), 5);
        assert_eq!(found[2], Root::Exact(Rational::ZERO));
        for (k, root) in found.iter().enumerate() {
            if let Root::Between(a, b) = root {
                assert_eq!(q.sign_at(a) * q.sign_at(b), -1, "{k}");
            }
        }
        assert!(found.windows(2).all(|w| w[0].high() <= w[1].low()));
        let samples = between_roots(&found, None, None);
        assert_eq!(samples.iter().map(|x| q.sign_at(x)).collect::<Vec<_>>(), vec![-1, 1, -1, 1, -1, 1]);
        assert_eq!(isolate(&q, None, None, &mut Work::new(100)), None);
    }

    #[test]
    fn samples_are_strictly_inside_the_limits() {
        // The root √2/2 in (0, 1), whose interval is the whole range at first.
        let q = p(&[-1, 0, 2]);
        let (low, high) = (Rational::ZERO, Rational::ONE);
        let found = isolate(&q, Some(&low), Some(&high), &mut Work::unlimited()).expect("unlimited");
        let samples = between_roots(&found, Some(&low), Some(&high));
        assert_eq!(samples.len(), 2);
        assert!(samples[0] > low && samples[1] < high);
        assert_eq!(samples.iter().map(|x| q.sign_at(x)).collect::<Vec<_>>(), vec![-1, 1]);
    }

    #[test]
    fn wilkinson_and_other_products() {
        let mut q = p(&[1]);
        for k in 1..=12 {
            q = q.mul(&p(&[-k, 1]));
        }
        let expected: Vec<Root> = (1..=12).map(|k| Root::Exact(Rational::from(k))).collect();
        assert_eq!(roots(&q, None, None), expected);
        // Mignotte: x⁷ − 2(50x − 1)² has two roots very near to 1/50
        let m = p(&[-2, 200, -5000, 0, 0, 0, 0, 1]);
        assert_eq!(roots(&m, Some(0), Some(1)).len(), 2);
    }
}
