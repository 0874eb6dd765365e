//! Integrals in an angle or exponent s.
//!
//! With x = tan ψ (tanh ψ), ψ = v·(s − shift), dx/ds = v·(1 ± x²). A polynomial in sin 2ψ and cos 2ψ (sinh, cosh) is P(x)/qᴺ with
//! q = 1 ± x² and deg P ≤ 2N, and the other way round.
//!
//! **Theorem.** P/qᴺ = c + dH/ds for exactly one number c and some H = Q/qᴺ, deg Q ≤ 2N.
//!
//! *Proof.* dH/ds = v·(Q′·q ∓ 2N·x·Q)/qᴺ. Compared by powers of x, P = c·qᴺ + v·(Q′·q ∓ 2N·x·Q) determines the coefficient
//! of x^(k+1) in Q from that of x^(k−1), and the last equation c: its factor is the mean of a positive function, times a number.
//!
//! So ∫ sᵐ·P/qᴺ ds = c·sᵐ⁺¹/(m + 1) + sᵐ·H − m·∫ sᵐ⁻¹·H ds. Of quotients by other polynomials some have an antiderivative
//! among the functions of a spec, and some do not: ∫ cos/(1 + sin)² = −1/(1 + sin), ∫ tan = −ln cos. They are errors.

use proc_macro2::Span;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::angle::{Angle, Kind};
use crate::model::formula::AngleValue;
use crate::model::scope::Scope;
use basis_prover::collections::list::Mapped;

/// P/qᴺ by the powers of x in P, or Q/qᴺ likewise.
type Powers = Vec<Fraction>;

impl Scope<'_> {
    /// The integral in an angle between two values of it.
    pub(in crate::model::formula) fn over_angle(
        &self,
        f: &Fraction,
        angle: &Angle,
        [low, high]: [&AngleValue; 2],
        span: Span,
    ) -> Option<Fraction> {
        let x = angle.var;
        let own = self.fits(self.budget.sub(&Fraction::var(x), &angle.low), span)?;
        // Numbers tan(π/n) are above the fraction line only, so that their powers can be lowered below it.
        let per = self.fits(self.budget.div(&Fraction::constant(Rational::ONE), &angle.width), span)?;
        let own = self.fits(self.budget.mul(&own, &self.analytic.reduced(per)), span)?;
        let f = self.put_one(f, x, &own, span)?;
        let Some((mut left, n)) = self.in_powers(&f, angle) else {
            let name = &angle.name;
            let functions = if angle.kind == Kind::Circular { "sin, cos" } else { "sinh, cosh, exp" };
            let error = self.error(span, format!("integrals of quotients in {functions} are not supported"));
            let label = format!("sums of products of {functions} and powers of `{name}` are integrated");
            let help = "claim the derivative of the antiderivative, `D(1/(1 + sin(t)), t) = …`, and its values at the ends; or that the integrand lies between functions that are integrated, `x <= y <= z`: their integrals bound this one";
            self.report(error.label(label).help(help));
            return None;
        };
        let rate = Fraction::constant(angle.rate.clone());
        let rate = match self.analytic.pi.filter(|_| angle.turns) {
            Some(pi) => self.fits(self.budget.mul(&rate, &Fraction::var(pi)), span)?,
            None => rate,
        };
        let mut sum = Fraction::zero();
        while let Some(p) = left.pop() {
            let m = left.len();
            let (c, h) = self.primitive(&p, n, angle.kind, &rate, span)?;
            let up = self.at_place(&c, &h, (m, n), angle, high, span)?;
            let down = self.at_place(&c, &h, (m, n), angle, low, span)?;
            sum = self.fits(self.budget.add(&sum, &self.fits(self.budget.sub(&up, &down), span)?), span)?;
            if let Some(next) = left.last_mut() {
                let factor = Fraction::constant(Rational::from(m as i64));
                for (p, h) in next.iter_mut().zip(&h) {
                    let part = self.fits(self.budget.mul(&factor, h), span)?;
                    *p = self.fits(self.budget.sub(p, &part), span)?;
                }
            }
        }
        Some(sum)
    }

    /// By powers of the angle itself P/qᴺ, and N; `None` where the function is no such sum.
    fn in_powers(&self, f: &Fraction, angle: &Angle) -> Option<(Vec<Powers>, usize)> {
        let x = Poly::var(angle.var);
        let square = x.pow(2);
        let lowered = |p: &Poly| {
            let f = self.analytic.reduced(Fraction::from(p.clone()));
            f.as_poly().cloned().unwrap_or_else(|| p.clone())
        };
        let (mut above, mut below) = (lowered(f.numer()), lowered(f.denom()));
        let mut divide = |by: &Poly| {
            let mut count = 0;
            while let Some(rest) = below.div_exact(by).filter(|_| below.depends_on(angle.var)) {
                (below, count) = (rest, count + 1);
            }
            count
        };
        let n = match angle.kind {
            Kind::Circular => divide(&(&square + &Poly::one())),
            _ => {
                let (plus, minus) = (&Poly::one() + &x, &Poly::one() - &x);
                let (i, j) = (divide(&plus), divide(&minus));
                let n: u32 = i.max(j);
                self.budget.spend(u64::from(n) * above.len() as u64).ok()?;
                above = &(&above * &plus.pow(n - i)) * &minus.pow(n - j);
                n
            }
        };
        if below.depends_on(angle.var) || below.depends_on(angle.itself) {
            return None;
        }
        let below = Fraction::from(below);
        let size = 2 * n as usize + 1;
        let mut all = Vec::new();
        for of_power in above.coefficients_in(angle.itself) {
            let mut powers = of_power.coefficients_in(angle.var).mapped(|p| Fraction::from(p.clone()));
            if powers.len() > size {
                return None;
            }
            powers.resize(size, Fraction::zero());
            for p in &mut powers {
                *p = self.budget.div(p, &below).ok()?;
            }
            all.push(powers);
        }
        Some((all, n as usize))
    }

    /// c and H with P/qᴺ = c + dH/ds.
    fn primitive(
        &self,
        p: &Powers,
        n: usize,
        kind: Kind,
        rate: &Fraction,
        span: Span,
    ) -> Option<(Fraction, Powers)> {
        let number = |x: Rational| Fraction::constant(x);
        // q^(k−1) stands in the equation of x^k with this factor.
        let factor = |k: usize| match kind {
            Kind::Circular => Rational::from(k as i64 - 1 - 2 * n as i64),
            _ => Rational::from(2 * n as i64 - k as i64 + 1),
        };
        let power = power_of_q(n, kind);
        // v·Q = α − c·β
        let (mut alpha, mut beta) = (vec![Fraction::zero(); 2 * n + 2], vec![Rational::ZERO; 2 * n + 2]);
        let rest = |k: usize, alpha: &[Fraction], beta: &[Rational]| {
            let Some(before) = k.checked_sub(1) else { return Some((p[k].clone(), power[k].clone())) };
            let taken = self.fits(self.budget.mul(&number(factor(k)), &alpha[before]), span)?;
            let of_p = self.fits(self.budget.sub(&p[k], &taken), span)?;
            Some((of_p, &power[k] - &(&factor(k) * &beta[before])))
        };
        for k in 0..2 * n {
            let (a, b) = rest(k, &alpha, &beta)?;
            let part = Rational::new(1, k as i64 + 1);
            alpha[k + 1] = self.fits(self.budget.mul(&a, &number(part.clone())), span)?;
            beta[k + 1] = &b * &part;
        }
        let (a, b) = rest(2 * n, &alpha, &beta)?;
        let c = self.fits(self.budget.div(&a, &number(b)), span)?;
        let mut h = Vec::new();
        for (a, b) in alpha.iter().zip(&beta).take(2 * n + 1) {
            let with_c = self.fits(self.budget.mul(&c, &number(b.clone())), span)?;
            let sum = self.fits(self.budget.sub(a, &with_c), span)?;
            h.push(self.fits(self.budget.div(&sum, rate), span)?);
        }
        Some((c, h))
    }

    /// c·sᵐ⁺¹/(m + 1) + sᵐ·H where the angle has a value.
    fn at_place(
        &self,
        c: &Fraction,
        h: &Powers,
        (m, n): (usize, usize),
        angle: &Angle,
        (y, s): &AngleValue,
        span: Span,
    ) -> Option<Fraction> {
        let times = |a: &Fraction, b: &Fraction| self.fits(self.budget.mul(a, b), span);
        let plus = |a: &Fraction, b: &Fraction| self.fits(self.budget.add(a, b), span);
        let x = plus(&angle.low, &times(&angle.width, y)?)?;
        let mut above = Fraction::zero();
        for p in h.iter().rev() {
            above = plus(&times(&above, &x)?, p)?;
        }
        let mut below = Fraction::zero();
        for p in power_of_q(n, angle.kind).into_iter().rev() {
            below = plus(&times(&below, &x)?, &Fraction::constant(p))?;
        }
        let h = self.fits(self.budget.div(&above, &below), span)?;
        let power = self.fits(self.budget.pow(s, m as u32), span)?;
        let linear = times(&times(c, s)?, &Fraction::constant(Rational::new(1, m as i64 + 1)))?;
        times(&power, &plus(&linear, &h)?)
    }
}

/// The coefficients of (1 ± x²)ᴺ.
fn power_of_q(n: usize, kind: Kind) -> Vec<Rational> {
    let sign = Rational::from(if kind == Kind::Circular { 1 } else { -1 });
    let mut all = vec![Rational::ZERO; 2 * n + 1];
    all[0] = Rational::ONE;
    for k in 1..=n {
        let factor = &Rational::new((n + 1 - k) as i64, k as i64) * &sign;
        all[2 * k] = &all[2 * k - 2] * &factor;
    }
    all
}
