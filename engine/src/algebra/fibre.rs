//! Polynomials in one variable in scaled Bernstein form: Σ βₖ sᵏ rⁿ⁻ᵏ with r + s = 1, s running from 0 to 1.
//!
//! βₖ is the Bernstein coefficient times the binomial coefficient n over k: the same signs, but whole numbers stay
//! whole, and a factor s or r shows as a zero at an end. Forms are determined up to a positive factor.

use super::rational::Rational;

/// From powers of x to the form on low ≤ x ≤ high, with x = low·r + high·s.
///
/// The factor is dⁿ for the product d of the denominators of the ends.
pub fn on_interval(c: &mut [Rational], low: &Rational, high: &Rational) {
    let d = &low.denom() * &high.denom();
    let (a, b) = (low * &d, high * &d);
    denominator(c, &d);
    shift(c, &a);
    powers(c, &(&b - &a));
    // eₖ sᵏ (r + s)ⁿ⁻ᵏ
    c.reverse();
    shift(c, &Rational::ONE);
    c.reverse();
}

/// From powers of x to the form on x ≥ low, with x = low + s/r, of p(x)·rⁿ.
pub fn upwards(c: &mut [Rational], low: &Rational) {
    let d = low.denom();
    denominator(c, &d);
    shift(c, &low.numer());
    powers(c, &d);
}

/// From powers of x to the form on x ≤ high, with x = high − r/s, of p(x)·sⁿ.
pub fn downwards(c: &mut [Rational], high: &Rational) {
    let d = high.denom();
    denominator(c, &d);
    shift(c, &high.numer());
    powers(c, &-d);
    c.reverse();
}

/// The form on the half 0 ≤ s ≤ 1/2, times 2ⁿ: s becomes s and r becomes 2r + s.
pub fn lower_half(c: &mut [Rational]) {
    c.reverse();
    upper_half(c);
    c.reverse();
}

/// The form on the half 1/2 ≤ s ≤ 1, times 2ⁿ: s becomes 2s + r and r stays.
pub fn upper_half(c: &mut [Rational]) {
    shift(c, &Rational::ONE);
    powers(c, &Rational::from(2));
}

/// dⁿ p(x) = Σ cₖ dⁿ⁻ᵏ (d x)ᵏ: from powers of x to powers of d·x.
fn denominator(c: &mut [Rational], d: &Rational) {
    c.reverse();
    powers(c, d);
    c.reverse();
}

/// The form on x ≤ m of the form on an infinite side that is cut at the m of s = 1/2: s stays and r becomes r + s.
pub fn lower_part(c: &mut [Rational]) {
    c.reverse();
    upper_part(c);
    c.reverse();
}

/// The form on x ≥ m of the form on an infinite side that is cut at the m of s = 1/2: s becomes s + r and r stays.
pub fn upper_part(c: &mut [Rational]) {
    shift(c, &Rational::ONE);
}

/// Multiplies cₖ by the k-th power of a number.
pub(super) fn powers(c: &mut [Rational], factor: &Rational) {
    if factor.is_one() {
        return;
    }
    let mut power = Rational::ONE;
    for c in c {
        if !c.is_zero() {
            *c *= &power;
        }
        power *= factor;
    }
}

/// Replaces x by x + h in a sum of powers of x.
pub(super) fn shift(c: &mut [Rational], h: &Rational) {
    let n = c.len();
    if h.is_zero() || n == 0 {
        return;
    }
    let unit = h.is_one();
    for i in 0..n - 1 {
        for j in (i..n - 1).rev() {
            let (low, high) = c.split_at_mut(j + 1);
            if high[0].is_zero() {
                continue;
            }
            if unit {
                low[j] += &high[0];
            } else {
                low[j] += &(&high[0] * h);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn list(c: &[i64]) -> Vec<Rational> {
        c.iter().map(|c| Rational::from(*c)).collect()
    }
    fn r(n: i64, d: i64) -> Rational {
        Rational::new(n, d)
    }
    fn value(form: &[Rational], s: &Rational) -> Rational {
        let n = form.len() - 1;
        let r = &Rational::ONE - s;
        form.iter()
            .enumerate()
            .map(|(k, c)| &(c * &s.pow(k as u32)) * &r.pow((n - k) as u32))
            .fold(Rational::ZERO, |a, b| a + b)
    }
    fn power_sum(c: &[Rational], x: &Rational) -> Rational {
        c.iter().rev().fold(Rational::ZERO, |v, c| &(&v * x) + c)
    }

    #[test]
    fn forms_have_the_values_of_the_polynomial() {
        let p = list(&[3, -1, 4, 0, -5]);
        let s = r(2, 7);
        let opposite = &Rational::ONE - &s;
        let (low, high) = (r(-1, 2), r(5, 3));
        let mut form = p.clone();
        on_interval(&mut form, &low, &high);
        let x = &(&low * &opposite) + &(&high * &s);
        assert_eq!(value(&form, &s), &power_sum(&p, &x) * &r(6, 1).pow(4));
        let mut form = p.clone();
        upwards(&mut form, &low);
        let x = &low + &(&s / &opposite);
        assert_eq!(value(&form, &s), &(&power_sum(&p, &x) * &opposite.pow(4)) * &r(2, 1).pow(4));
        let mut form = p.clone();
        downwards(&mut form, &high);
        let x = &high - &(&opposite / &s);
        assert_eq!(value(&form, &s), &(&power_sum(&p, &x) * &s.pow(4)) * &r(3, 1).pow(4));
    }

    #[test]
    fn halves_have_the_values_of_the_whole() {
        let form = list(&[3, -1, 4, 0, -5]);
        let s = r(2, 7);
        let (mut low, mut high) = (form.clone(), form.clone());
        lower_half(&mut low);
        upper_half(&mut high);
        assert_eq!(value(&low, &s), &value(&form, &r(1, 7)) * &r(16, 1));
        assert_eq!(value(&high, &s), &value(&form, &r(9, 14)) * &r(16, 1));
    }
}
