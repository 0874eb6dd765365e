//! Antiderivatives of quotients (M. Ostrogradsky, 1845; E. Horowitz, "Algorithms for partial fraction decomposition and
//! rational function integration", SYMSAM 1971). With D₁ = gcd(D, D′), D₂ = D/D₁ and E = D₁′·D₂/D₁, a polynomial, N/D =
//! (Q/D₁)′ if and only if N = Q′·D₂ − Q·E, and if N/D has any rational antiderivative it has one of this form. Compared
//! by powers of t from the highest one, the factor of the coefficient qₖ of Q is (k − deg D₁)·lc(D₂): all of them are
//! determined but that of the constant of integration.

use crate::algebra::divisors::gcd::checked_gcd;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::budget::{Budget, TooLarge};
use crate::model::scope::Scope;

/// The work for a common divisor.
const GCD: u64 = 5_000_000;

/// Adds a term to the coefficient of a power.
fn add_to(all: &mut Powers, power: usize, term: &Fraction, budget: &Budget) -> Result<(), TooLarge> {
    if all.len() <= power {
        all.resize(power + 1, Fraction::zero());
    }
    all[power] = budget.add(&all[power], term)?;
    Ok(())
}

/// Polynomials by their powers.
type Powers = Vec<Fraction>;

impl Scope<'_> {
    /// A rational function whose derivative in a variable a quotient is; nothing if there is none.
    pub(super) fn rational_antiderivative(
        &self,
        f: &Fraction,
        var: Var,
    ) -> Result<Option<Fraction>, TooLarge> {
        let budget = &self.budget;
        let below = f.denom();
        budget.spend((below.len() * below.len()) as u64)?;
        let Some(first) = checked_gcd(below, &below.derivative(var), &mut Work::new(GCD)) else {
            return Err(TooLarge::Formula(String::from("has too large a denominator for an integral")));
        };
        let exact = |p: &Poly| p.div_exact(&first);
        let Some(second) = exact(below) else { return Ok(None) };
        let Some(slope) = exact(&(&first.derivative(var) * &second)) else { return Ok(None) };
        let powers =
            |p: &Poly| -> Powers { p.coefficients_in(var).into_iter().map(Fraction::from).collect() };
        let (mut left, second, slope) = (powers(f.numer()), powers(&second), powers(&slope));
        let degree = first.degree(var) as usize;
        let Some(leading) = second.last() else { return Ok(None) };
        let top = (left.len() + 1).saturating_sub(second.len());
        let mut found: Powers = vec![Fraction::zero(); top + 1];
        for k in (0..=top).rev() {
            let Some(power) = (k + second.len()).checked_sub(2) else { break };
            let Some(rest) = left.get(power).filter(|c| !c.is_zero()).cloned() else { continue };
            if k == degree {
                return Ok(None);
            }
            let factor = Fraction::constant(Rational::from(k as i64 - degree as i64));
            let q = budget.div(&rest, &budget.mul(leading, &factor)?)?;
            let minus = -&q;
            for (i, c) in second.iter().enumerate() {
                let Some(place) = (k + i).checked_sub(1) else { continue };
                let term =
                    budget.mul(&budget.mul(&minus, c)?, &Fraction::constant(Rational::from(k as i64)))?;
                add_to(&mut left, place, &term, budget)?;
            }
            for (i, c) in slope.iter().enumerate() {
                add_to(&mut left, k + i, &budget.mul(&q, c)?, budget)?;
            }
            found[k] = q;
        }
        if left.iter().any(|c| !c.is_zero()) {
            return Ok(None);
        }
        let mut sum = Fraction::zero();
        for (k, q) in found.iter().enumerate() {
            let power = Fraction::from(Poly::var(var).pow(k as u32));
            sum = budget.add(&sum, &budget.mul(q, &power)?)?;
        }
        budget.div(&sum, &Fraction::from(first)).map(Some)
    }
}
