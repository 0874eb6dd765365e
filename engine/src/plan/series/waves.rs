//! What power series are made of and shortened by: those of products of sines and cosines, and Chebyshev polynomials.

use std::rc::Rc;

use basis_prover::collections::list::Listed;

use crate::algebra::rational::Rational;
use crate::model::angle::{Angle, Kind};

/// The bits that coefficients of floats have, and some more.
const BITS: u32 = 58;

/// What may be missing of a number in place of floats.
pub(super) fn negligible(x: &Rational) -> Rational {
    x * &Rational::from(2).pow(BITS).recip().unwrap_or(Rational::ONE)
}

pub(super) fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The polynomial of degree below n that is nearest to xⁿ for 0 ≤ x ≤ 1, and its error: xⁿ − T*(x)/2²ⁿ⁻¹, where T* is
/// the Chebyshev polynomial of degree n ≥ 1 of that interval.
pub(super) fn chebyshev(n: usize) -> (Vec<Rational>, Rational) {
    let mut last = vec![Rational::ONE];
    let mut this = vec![-Rational::ONE, Rational::from(2)];
    for _ in 1..n {
        // T*ₖ₊₁ = (4x − 2)·T*ₖ − T*ₖ₋₁
        let mut next = vec![Rational::ZERO; this.len() + 1];
        for (k, c) in this.iter().enumerate() {
            next[k + 1] += &(c * &Rational::from(4));
            next[k] -= &(c * &Rational::from(2));
        }
        for (next, c) in next.iter_mut().zip(&last) {
            *next -= c;
        }
        (last, this) = (this, next);
    }
    let error = this.pop().and_then(|leading| leading.recip()).unwrap_or(Rational::ONE);
    (this.iter().map(|c| -&(c * &error)).listed(), error)
}

/// The power series of sinⁱ(v·s)·cosⁿ⁻ⁱ(v·s) in s, or of sinh and cosh, for all i.
pub(super) struct Waves {
    of: (Kind, Rational, u32, usize),
    all: Vec<Vec<Rational>>,
}

impl Waves {
    /// Those of an angle, computed once.
    pub(super) fn known(angle: &Angle, n: u32, last: usize, known: &mut Vec<Rc<Self>>) -> Rc<Self> {
        let of = (angle.kind, angle.rate.clone(), n, last);
        if let Some(waves) = known.iter().find(|waves| waves.of == of) {
            return Rc::clone(waves);
        }
        let waves = Rc::new(Self::new(angle, n, last));
        known.push(Rc::clone(&waves));
        waves
    }

    fn new(angle: &Angle, n: u32, last: usize) -> Self {
        let sign = if angle.kind == Kind::Circular { -Rational::ONE } else { Rational::ONE };
        let mut term = Rational::ONE;
        let mut parts = [vec![Rational::ZERO; last + 1], vec![Rational::ZERO; last + 1]];
        for k in 0..=last {
            // sin and cos have signs +, +, −, −.
            let signed = if k / 2 % 2 == 1 { &term * &sign } else { term.clone() };
            parts[1 - k % 2][k] = signed;
            term = &term * &(&angle.rate * &Rational::new(1, k as i64 + 1));
        }
        let [sine, cosine] = &parts;
        let mut one = vec![Rational::ZERO; last + 1];
        one[0] = Rational::ONE;
        let powers = |base: &[Rational]| {
            let mut all = vec![one.clone()];
            for k in 0..n as usize {
                all.push(product(&all[k], base));
            }
            all
        };
        let (sines, cosines) = (powers(sine), powers(cosine));
        let all = sines.iter().zip(cosines.iter().rev()).map(|(a, b)| product(a, b)).listed();
        Self { of: (angle.kind, angle.rate.clone(), n, last), all }
    }

    pub(super) fn of(&self, i: u32) -> &[Rational] {
        &self.all[i as usize]
    }
}

fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let coefficient = |k: usize| {
        (0..=k).fold(Rational::ZERO, |sum, i| {
            if a[i].is_zero() || b[k - i].is_zero() { sum } else { &sum + &(&a[i] * &b[k - i]) }
        })
    };
    (0..a.len()).map(coefficient).listed()
}
