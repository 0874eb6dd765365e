//! Functions as text, in the factored form in which they are evaluated.

use super::form::{FunctionForm, IntervalForm};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::Family;

/// A function as the product that is evaluated; expanded where the domain is not the unit interval.
pub(crate) fn factored(family: &Family, form: &IntervalForm, function: &FunctionForm) -> String {
    let names = &family.names;
    let t = &names[form.var.0];
    let over = |text: String, product: bool| {
        if function.denom.is_one() {
            return text;
        }
        let text = if product { text } else { format!("({text})") };
        format!("{text}/({})", function.denom.display(names))
    };
    let f = &function.factored;
    if f.inner.is_empty() {
        return String::from("0");
    }
    let inner = f.inner_monomial(form);
    // A number belongs to the polynomial factor unless it would make fractions of it.
    let whole = inner.scale(&f.content);
    let alone = f.x_power == 0 && f.s_power == 0 && function.denom.is_one();
    let (number, inner) = if whole.numeric_content().is_integer() || alone {
        (Rational::ONE, whole)
    } else {
        (f.content.clone(), inner)
    };
    let mut factors = Vec::new();
    if !number.is_one() {
        factors.push(number.to_string());
    }
    let powers = f.x_power + f.s_power;
    if !inner.is_one() || (factors.is_empty() && powers == 0) {
        let text = inner.display(names).to_string();
        factors.push(if inner.len() > 1 && !alone { format!("({text})") } else { text });
    }
    let unit = form.low.is_zero() && form.high.is_one();
    let at = |end: &Rational| Poly::constant(end.clone());
    let (from_low, to_high) = if unit {
        (Poly::var(form.var), &Poly::one() - &Poly::var(form.var))
    } else {
        (&Poly::var(form.var) - &at(&form.low), &at(&form.high) - &Poly::var(form.var))
    };
    for (base, power) in [(from_low, f.x_power), (to_high, f.s_power)] {
        let base = if base.len() > 1 { format!("({})", base.display(names)) } else { t.clone() };
        match power {
            0 => {}
            1 => factors.push(base),
            _ => factors.push(format!("{base}^{power}")),
        }
    }
    over(factors.join("*"), true)
}
