//! Families in floating point: everything that a page needs to evaluate them.
//!
//! A function of one variable is a quotient of sums in Bernstein form, whose coefficients are sums of terms in the other
//! variables: near the ends of the domain, and at high degrees, the powers of the variable would cancel. One of several
//! variables is a quotient of sums of terms.

use basis_engine::Family;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::number::binomial;
use basis_engine::algebra::poly::{Monomial, Poly, Var};
use basis_engine::algebra::range::Range;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::Parameter;
use basis_engine::model::angle::{Angle, Kind};
use serde_json::{Value, json};

/// The middle of two numbers.
pub(crate) fn middle(low: &Rational, high: &Rational) -> f64 {
    f64::midpoint(low.to_f64(), high.to_f64())
}

/// A family with its shape parameters and spans.
pub(crate) fn family(family: &Family) -> Value {
    let kind = if family.domain.len() == 1 { "interval" } else { "product" };
    // Those that are independent come first, at the places of their ranges.
    let last = family.simplices.iter().map(|simplex| &simplex.last);
    let variables: Vec<&str> = family.domain.iter().chain(last).map(|p| p.name.as_str()).collect();
    let simplices: Vec<[usize; 2]> =
        family.simplices.iter().map(|simplex| [simplex.places.start, simplex.places.end]).collect();
    let spans: Option<Vec<Value>> = if family.pieces.is_empty() {
        span(family).map(|span| vec![span])
    } else {
        family.pieces.iter().map(|piece| span(piece)).collect()
    };
    let Some(spans) = spans else { return json!({ "error": "the domain has no ends" }) };
    let conditions: Vec<Value> = family
        .constraints
        .iter()
        .map(|c| json!({ "value": terms(family, &c.value), "text": c.text }))
        .collect();
    json!({
        "title": family.title(),
        "doc": family.doc,
        "kind": kind,
        "variables": variables,
        "simplices": simplices,
        "shapes": family.shapes.iter().map(|p| shape(family, p)).collect::<Vec<_>>(),
        "conditions": conditions,
        "labels": (0..family.functions.len()).map(|k| family.function_label(k)).collect::<Vec<_>>(),
        "indices": family.functions.iter().map(|f| f.index.clone()).collect::<Vec<_>>(),
        "spans": spans
    })
}

fn shape(family: &Family, p: &Parameter) -> Value {
    let value = simple(p);
    let [low, high] = slider(&p.range, value);
    json!({
        "name": p.name,
        "declared": family.declared(p),
        "doc": p.doc,
        "var": p.var.0,
        "low": low,
        "high": high,
        "value": value,
        "excluded": [!p.range.low.is_included(), !p.range.high.is_included()],
        "open": [p.range.low.value().is_none(), p.range.high.value().is_none()]
    })
}

/// A simple number inside of a range.
fn simple(p: &Parameter) -> f64 {
    let range = &p.range;
    let half = Rational::new(1, 2);
    let middle = range.finite().map(|(low, high)| &(low + high) * &half);
    let above = range.low.value().map(|low| low + &Rational::ONE);
    let below = range.high.value().map(|high| high - &Rational::ONE);
    let candidates = [Some(half), Some(Rational::ONE), Some(Rational::ZERO), middle, above, below];
    candidates.into_iter().flatten().find(|x| range.contains(x)).map_or(0.0, |x| x.to_f64())
}

/// The ends of a slider: those of the range, and ten units further where it has none.
fn slider(range: &Range, value: f64) -> [f64; 2] {
    match (range.low.value().map(Rational::to_f64), range.high.value().map(Rational::to_f64)) {
        (Some(low), Some(high)) => [low, high],
        (Some(low), None) => [low, low.max(value) + 10.0],
        (None, Some(high)) => [high.min(value) - 10.0, high],
        (None, None) => [value - 5.0, value + 5.0],
    }
}

/// The functions on one span; nothing where the domain has no ends.
fn span(family: &Family) -> Option<Value> {
    let ranges: Option<Vec<[f64; 2]>> =
        family.domain.iter().map(|p| p.range.finite().map(|(a, b)| [a.to_f64(), b.to_f64()])).collect();
    let interval = family.interval();
    let sum = |p: &Poly| match interval {
        Some((var, low, high)) => {
            let coefficients = bernstein(p, var, low, high);
            json!({ "bernstein": coefficients.iter().map(|c| terms(family, c)).collect::<Vec<_>>() })
        }
        None => json!({ "terms": terms(family, p) }),
    };
    let function = |f: &Fraction| {
        let below = if f.denom().is_one() { Value::Null } else { sum(f.denom()) };
        json!({ "above": sum(f.numer()), "below": below })
    };
    let analytic = &family.analytic;
    let numbers: Vec<(usize, f64)> = analytic.floats().iter().map(|(var, x)| (var.0, *x)).collect();
    Some(json!({
        "ranges": ranges?,
        "width": variables(family),
        "domain": family.domain.iter().map(|p| p.var.0).collect::<Vec<_>>(),
        "numbers": numbers,
        "angles": analytic.angles.iter().map(|a| angle(family, a)).collect::<Vec<_>>(),
        "functions": family.functions.iter().map(|f| function(&f.value)).collect::<Vec<_>>()
    }))
}

/// An angle s = shift + atan(x) / rate, or with atanh, where x = low + width·y; x itself without a kind.
fn angle(family: &Family, a: &Angle) -> Value {
    let pi = core::f64::consts::PI;
    let (rate, shift) = (a.rate.to_f64(), a.shift.to_f64());
    let (rate, shift) = if a.turns { (rate * pi, shift) } else { (rate, shift * pi) };
    let kind = match a.kind {
        Kind::Circular => "atan",
        Kind::Hyperbolic => "atanh",
        Kind::Linear => "",
    };
    let quotient =
        |f: &Fraction| json!({ "above": terms(family, f.numer()), "below": terms(family, f.denom()) });
    json!({
        "name": a.name,
        "kind": kind,
        "rate": rate,
        "shift": shift,
        "low": quotient(&a.low),
        "width": quotient(&a.width),
        "var": a.var.0,
        "itself": a.itself.0
    })
}

/// How many variables there are, numbers and angles included.
fn variables(family: &Family) -> usize {
    let angles = family.analytic.angles.iter().flat_map(|a| [a.var.0, a.itself.0]);
    let numbers = family.analytic.numbers().into_iter().map(|var| var.0);
    angles.chain(numbers).map(|k| k + 1).chain([family.names.len()]).max().unwrap_or(0)
}

/// The terms of a polynomial, each a coefficient followed by variables with their exponents.
fn terms(family: &Family, poly: &Poly) -> Value {
    let width = variables(family);
    let term = |(monomial, coefficient): (&Monomial, &Rational)| {
        let mut term = vec![json!(coefficient.to_f64())];
        for k in 0..width {
            let exponent = monomial.exponent(Var(k));
            if exponent > 0 {
                term.push(json!(k));
                term.push(json!(exponent));
            }
        }
        Value::from(term)
    };
    poly.terms().map(term).collect::<Vec<_>>().into()
}

/// The coefficients of a polynomial in Bernstein form on an interval: with p(low + width·x) = Σ aᵢ xⁱ of degree n they
/// are bⱼ = Σ C(j, i) / C(n, i) aᵢ, for i ≤ j.
fn bernstein(p: &Poly, var: Var, low: &Rational, high: &Rational) -> Vec<Poly> {
    let unit = &Poly::constant(low.clone()) + &Poly::var(var).scale(&(high - low));
    let degree = p.degree(var);
    let mut powers = p.substitute(var, &unit).coefficients_in(var);
    powers.resize(degree as usize + 1, Poly::zero());
    let coefficient = |j: u32| {
        (0..=j).fold(Poly::zero(), |sum, i| {
            let weight = &binomial(j, i) / &binomial(degree, i);
            &sum + &powers[i as usize].scale(&weight)
        })
    };
    (0..=degree).map(coefficient).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_on_any_interval() {
        // t² on [-1, 1] has the coefficients 1, -1, 1; t·λ on [0, 2] has 0 and 2λ.
        let (t, l) = (Var(1), Var(0));
        let number = |n: i64| Poly::integer(n);
        let square = Poly::var(t).pow(2);
        let found = bernstein(&square, t, &Rational::from(-1), &Rational::from(1));
        assert_eq!(found, [number(1), number(-1), number(1)]);
        let product = &Poly::var(t) * &Poly::var(l);
        let found = bernstein(&product, t, &Rational::ZERO, &Rational::from(2));
        assert_eq!(found, [Poly::zero(), Poly::var(l).scale(&Rational::from(2))]);
        assert_eq!(bernstein(&Poly::zero(), t, &Rational::ZERO, &Rational::ONE), [Poly::zero()]);
    }
}
