//! Weights of points as text: as products, and where they have no value.

use crate::algebra::divisors::factor::factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use basis_prover::collections::list::Listed;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::{Symmetries, decide};

/// The factors of a polynomial in the shape values that are not known to be different from zero on a region.
pub(crate) fn zeros(p: &Poly, region: &Region, budget: u32) -> Vec<Poly> {
    let domain = Rc::new(Domain::of(region.clone()));
    let zero_free = |p: &Poly| {
        let (value, domain) = (Fraction::from(p.clone()).quotient(), Rc::clone(&domain));
        let positive = Statement::Sign { value, relation: Relation::Positive, domain };
        decide(positive, &Symmetries::new(), budget).is_ok()
    };
    let factors = factor(p).1.into_iter().map(|(factor, _)| factor);
    factors.filter(|f| f.as_constant().is_none() && !zero_free(f) && !zero_free(&-f)).listed()
}

/// Where a factor is zero, such as `λ = -2`.
pub(crate) fn zero(factor: &Poly, names: &[String]) -> String {
    if let [var] = factor.variables().as_slice()
        && let [a, b] = factor.coefficients_in(*var).as_slice()
        && let Some((a, b)) = a.as_constant().zip(b.as_constant())
        && let Some(root) = (-&a).checked_div(&b)
    {
        return format!("{} = {root}", names[var.0]);
    }
    format!("{} = 0", factor.display(names))
}

/// Σ weight·point, every weight as a product.
pub(crate) fn combination<'a>(
    terms: impl Iterator<Item = (&'a str, &'a Fraction)>,
    names: &[String],
) -> String {
    let mut text = String::new();
    for (point, weight) in terms {
        let (content, numer) = product(weight.numer(), names);
        let (below, denom) = product(weight.denom(), names);
        // The content of a denominator is not zero.
        let number = content.checked_div(&below).unwrap_or(Rational::ONE);
        text += match (text.is_empty(), number.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let mut number = number.abs();
        let (mut above, mut below) = (numer, denom);
        if !below.is_empty() && !number.is_integer() {
            below.insert(0, number.denom().to_string());
            number = number.numer();
        }
        if !number.is_one() {
            above.insert(0, number.to_string());
        }
        let mut factor = above.join("*");
        if !below.is_empty() {
            let above = if factor.is_empty() { "1" } else { &factor };
            let divisor = below.join("*");
            factor =
                if below.len() > 1 { format!("{above}/({divisor})") } else { format!("{above}/{divisor}") };
        }
        text += &if factor.is_empty() { point.to_string() } else { format!("{factor}*{point}") };
    }
    if text.is_empty() { String::from("0") } else { text }
}

/// A polynomial as a number and factors for reading.
fn product(poly: &Poly, names: &[String]) -> (Rational, Vec<String>) {
    let (mut content, factors) = factor(poly);
    let mut texts = Vec::new();
    for (factor, power) in factors {
        if let Some(c) = factor.as_constant() {
            content *= &c.pow(power);
            continue;
        }
        // The sign that begins with the simplest term.
        let negative = factor.display(names).to_string().starts_with('-');
        let factor = if negative { -&factor } else { factor };
        if negative && power % 2 == 1 {
            content = -&content;
        }
        let text = factor.display(names).to_string();
        let text = if factor.len() > 1 { format!("({text})") } else { text };
        texts.push(if power > 1 { format!("{text}^{power}") } else { text });
    }
    (content, texts)
}
