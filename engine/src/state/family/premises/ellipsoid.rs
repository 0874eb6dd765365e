//! Functions that are linear in the variables of an ellipsoid, as slopes are in the derivatives at the ends of a cubic.
//!
//! **Theorem.** Let g = ρ − Σ wᵢ·yᵢ² with wᵢ > 0 and f = a + Σ bᵢ·yᵢ. Where g ≥ 0, f ≥ 0 if a ≥ 0 and a² ≥ ρ·Σ bᵢ²/wᵢ, because
//! (Σ bᵢ·yᵢ)² ≤ Σ bᵢ²/wᵢ · Σ wᵢ·yᵢ² (Cauchy and Schwarz). On the whole ellipsoid nothing less is enough.
//!
//! Squares are completed variable by variable, so that a, ρ and bᵢ are free of them.

use basis_kernel::{Quotient, Statement};

use super::Sign;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;

impl Sign<'_> {
    /// That the value of a linear function at the middle of an ellipsoid is large enough.
    pub(super) fn on_ellipsoid(&self) -> Option<Vec<Statement>> {
        if !self.value.denominator.is_one() {
            return None;
        }
        self.domain.premises.iter().find_map(|(g, _)| {
            let (a, square) = parts(&self.value.numerator, g)?;
            let sign = |value: Poly| Sign { value: Quotient::from(value), ..*self }.if_seen();
            Some(vec![sign(a.clone())?, sign(&a.pow(2) - &square)?])
        })
    }
}

/// a and ρ·Σ bᵢ²/wᵢ; `None` where a polynomial is not linear in the variables of the other one, or that one is no ellipsoid.
fn parts(f: &Poly, g: &Poly) -> Option<(Poly, Poly)> {
    let variables = g.variables();
    let (mut value, mut rest, mut sum) = (f.clone(), g.clone(), Poly::zero());
    for (k, x) in variables.iter().enumerate() {
        // −w·x² + l·x + r = −w·(x − l/2w)² + l²/4w + r
        let [r, l, square] = &rest.coefficients_in(*x)[..] else { return None };
        let weight = (-square).as_constant().filter(Rational::is_positive)?;
        let half = (&Rational::from(2) * &weight).recip()?;
        let middle = l.scale(&half);
        rest = r + &(l * &middle).scale(&Rational::new(1, 2));
        let (at_zero, slope) = match &value.coefficients_in(*x)[..] {
            [at_zero] => (at_zero.clone(), Poly::zero()),
            [at_zero, slope] => (at_zero.clone(), slope.clone()),
            _ => return None,
        };
        // The slope is one number for all values of the variables.
        if variables.iter().any(|v| slope.depends_on(*v))
            || variables[..k].iter().any(|v| middle.depends_on(*v))
        {
            return None;
        }
        value = &at_zero + &(&slope * &middle);
        sum = &sum + &slope.pow(2).scale(&weight.recip()?);
    }
    Some((value, &rest * &sum))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::poly::Var;

    /// f = 3 + x + 2·y on 5 − (x − 1)² − 4·y² ≥ 0, whose middle is (1, 0): a = 4, and 5·(1 + 4/4) = 10.
    #[test]
    fn squares_are_completed() {
        let [x, y] = [0, 1].map(|k| Poly::var(Var(k)));
        let number = |n: i64| Poly::constant(Rational::from(n));
        let f = &(&number(3) + &x) + &y.scale(&Rational::from(2));
        let g = &(&number(5) - &(&x - &number(1)).pow(2)) - &y.pow(2).scale(&Rational::from(4));
        assert_eq!(parts(&f, &g), Some((number(4), number(10))));
        assert_eq!(parts(&(&x * &y), &g), None);
        assert_eq!(parts(&f, &-&g), None);
    }

    /// x² + x·y + y² ≤ 1 and f = x + y, which is 2/√3 at most.
    #[test]
    fn squares_with_mixed_terms_are_completed() {
        let [x, y] = [0, 1].map(|k| Poly::var(Var(k)));
        let g = &(&(&Poly::one() - &x.pow(2)) - &(&x * &y)) - &y.pow(2);
        assert_eq!(parts(&(&x + &y), &g), Some((Poly::zero(), Poly::constant(Rational::new(4, 3)))));
    }
}
