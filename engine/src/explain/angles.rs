//! Functions of angles in sin and cos, or sinh and cosh.
//!
//! x^j/(1 + x²)^k with x = tan ψ is sin^j ψ·cos^(2k−j) ψ, which is a polynomial in S = sin 2ψ and C = cos 2ψ, of degree 1
//! in S: sin²ψ = (1 − C)/2, cos²ψ = (1 + C)/2, sin ψ cos ψ = S/2; for tanh the same with 1 − x², −sinh²ψ = (1 − C)/2.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Angle, Kind};

/// A function in sin and cos of the angles that occur.
pub(super) fn text(family: &Family, f: &Fraction) -> String {
    let mut names = family.names.clone();
    let mut f = f.clone();
    // The variables of the domain first: their tangents may be multiples of those of the shape parameters.
    for angle in family.analytic.angles.iter().rev() {
        let Some(plain) = unscaled(&f, angle) else { return f.display(&names) };
        if angle.kind == Kind::Linear {
            names[angle.var.0].clone_from(&angle.name);
            f = plain;
            continue;
        }
        let (numer, denom) = (plain.numer(), plain.denom());
        let powers = numer.degree(angle.var).max(denom.degree(angle.var)).div_ceil(2);
        if powers == 0 {
            f = plain;
            continue;
        }
        let [sin, cos] = [0, 1].map(|k| Var(names.len() + k));
        let (s, c) = if angle.kind == Kind::Circular { ("sin", "cos") } else { ("sinh", "cosh") };
        let twice = Angle { rate: &angle.rate + &angle.rate, ..angle.clone() };
        let argument = twice.tangent_name();
        let argument = argument.split_once('(').map_or("", |(_, rest)| rest);
        names.extend([format!("{s}({argument}"), format!("{c}({argument}")]);
        let put = |p: &Poly| in_sines(p, angle, powers, (sin, cos));
        let Some(quotient) = Fraction::new(put(numer), put(denom)) else { return plain.display(&names) };
        f = quotient;
    }
    f.display(&names)
}

/// The function with x in place of y; `None` where that has no value.
fn unscaled(f: &Fraction, angle: &Angle) -> Option<Fraction> {
    let x = Fraction::var(angle.var);
    let y = (&x - &angle.low).checked_div(&angle.width)?;
    f.substitute(angle.var, &y)
}

/// p(x)/(1 ± x²)^k, k at least half of the degree, as a polynomial in S and C.
fn in_sines(p: &Poly, angle: &Angle, k: u32, (sin, cos): (Var, Var)) -> Poly {
    let half = Rational::new(1, 2);
    let (one, c) = (Poly::one(), Poly::var(cos));
    // The squares of cos ψ and of sin ψ.
    let square_of_cos = (&one + &c).scale(&half);
    let square_of_sin = if angle.kind == Kind::Circular { &one - &c } else { &c - &one }.scale(&half);
    let both = Poly::var(sin).scale(&half);
    let mut sum = Poly::zero();
    for (j, coefficient) in p.coefficients_in(angle.var).iter().enumerate() {
        let j = j as u32;
        let even = &square_of_sin.pow(j / 2) * &square_of_cos.pow(k - j.div_ceil(2));
        let power = if j % 2 == 1 { &even * &both } else { even };
        sum = &sum + &(coefficient * &power);
    }
    sum
}
