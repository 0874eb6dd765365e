//! Derivatives at an end of a domain in an angle.
//!
//! In y, the tangent between the ends of the domain, a function is N(y, s)/W(y, s), where s is the variable itself. At an end
//! y and s are power series in the distance τ from it: s = s₀ + τ, and y from y′ = v(1 ± x²)/width with x = low + width·y.
//! The quotient of the series of N and W has the derivatives as coefficients, k! times each. Only functions of shape
//! parameters are multiplied and divided, where derivatives of the whole function would be of a higher degree in y with
//! each order.

use basis_prover::collections::list::Listed;

use super::{Angle, Kind};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;

/// The value of a function and its derivatives up to an order at an end.
pub(in crate::model) fn derivatives(
    family: &Family,
    angle: &Angle,
    f: &Fraction,
    (end, upper): (&Rational, bool),
    order: u32,
    work: &mut Work,
) -> Option<Vec<Fraction>> {
    let place = Place {
        vars: [angle.var, angle.itself],
        y: tangents(angle, family.analytic.pi, end, order, work)?,
        s: distance(&angle.limits[usize::from(upper)], order),
    };
    let (above, below) = (place.series(f.numer(), work)?, place.series(f.denom(), work)?);
    let mut all = quotient(&above, &below, work)?;
    let mut factorial = Rational::ONE;
    for (k, coefficient) in (0_i64..).zip(&mut all) {
        factorial = &factorial * &Rational::from(k.max(1));
        let derivative = coefficient.mul_within(&Fraction::constant(factorial.clone()), work)?;
        *coefficient = family.analytic.reduced(derivative);
    }
    Some(all)
}

/// What takes the place of the angle itself and of y on a span when the domain is reversed; u goes from 0 to 1 on the span.
///
/// With u from 0 to 1 on both spans, tan of the difference from the sum of the ends is a quotient of linear functions of
/// u with the values 1 and 0 at the ends, (1 - u)/(1 + c·u), and 1 + c is what the slopes say at the end u = 0.
pub(in crate::model) fn reversed(
    (own, angle): (&Angle, &Angle),
    [low, high]: [&Rational; 2],
    [other_low, other_high]: [&Rational; 2],
    u: &Fraction,
    work: &mut Work,
) -> Option<Vec<(Var, Fraction)>> {
    let one = Fraction::constant(Rational::ONE);
    let (start, span) = (Fraction::constant(other_low.clone()), Fraction::constant(other_high - other_low));
    // (1 ± x²)/W at an end, where x = L + W·u.
    let mut slope = |angle: &Angle, width: &Rational, end: &Rational| {
        let x =
            angle.low.add_within(&angle.width.mul_within(&Fraction::constant(end.clone()), work)?, work)?;
        let square = x.mul_within(&x, work)?;
        let above = match angle.kind {
            Kind::Circular => one.add_within(&square, work)?,
            Kind::Hyperbolic => one.sub_within(&square, work)?,
            Kind::Linear => one.clone(),
        };
        let width = angle.width.mul_within(&Fraction::constant(width.clone()), work)?;
        above.div_within(&width, work).ok().flatten()
    };
    let there = slope(angle, &(other_high - other_low), other_high)?;
    let here = slope(own, &(high - low), low)?;
    let c = there.div_within(&here, work).ok().flatten()?.sub_within(&one, work)?;
    let below = one.add_within(&c.mul_within(u, work)?, work)?;
    let u = (&one - u).div_within(&below, work).ok().flatten()?;
    let y = start.add_within(&span.mul_within(&u, work)?, work)?;
    let [first, last] = &angle.limits;
    let [own_first, own_last] = &own.limits;
    // The sum of the ends of both spans together is twice that of the domain.
    let sum = &(&(first + last) + &(own_first + own_last)) * &Fraction::constant(Rational::new(1, 2));
    Some(vec![(angle.itself, &sum - &Fraction::var(own.itself)), (angle.var, y)])
}

/// An end, as series of y and of s.
struct Place {
    vars: [Var; 2],
    y: Vec<Fraction>,
    s: Vec<Fraction>,
}

impl Place {
    /// A polynomial in y, s and shape parameters, by Horner's scheme in both.
    fn series(&self, p: &Poly, work: &mut Work) -> Option<Vec<Fraction>> {
        let [y, s] = self.vars;
        let zero = vec![Fraction::zero(); self.y.len()];
        let mut outer = zero.clone();
        for coefficient in p.coefficients_in(y).into_iter().rev() {
            let mut inner = zero.clone();
            for number in coefficient.coefficients_in(s).into_iter().rev() {
                if inner.iter().any(|c| !c.is_zero()) {
                    inner = product(&inner, &self.s, work)?;
                }
                inner[0] = inner[0].add_within(&Fraction::from(number), work)?;
            }
            if outer.iter().any(|c| !c.is_zero()) {
                outer = product(&outer, &self.y, work)?;
            }
            for (sum, term) in outer.iter_mut().zip(&inner) {
                *sum = sum.add_within(term, work)?;
            }
        }
        Some(outer)
    }
}

/// s₀ + τ.
fn distance(end: &Fraction, order: u32) -> Vec<Fraction> {
    let coefficient = |k: u32| match k {
        0 => end.clone(),
        1 => Fraction::constant(Rational::ONE),
        _ => Fraction::zero(),
    };
    (0..=order).map(coefficient).listed()
}

/// The series of y.
fn tangents(
    angle: &Angle,
    pi: Option<Var>,
    end: &Rational,
    order: u32,
    work: &mut Work,
) -> Option<Vec<Fraction>> {
    let slope = angle.slope(pi);
    let mut y = vec![Fraction::constant(end.clone())];
    for k in 0..order as usize {
        // The coefficient of τᵏ in 1 ± x²; that of x is width·y, and low more for k = 0.
        let mut x = Vec::new();
        for coefficient in &y {
            x.push(angle.width.mul_within(coefficient, work)?);
        }
        x[0] = x[0].add_within(&angle.low, work)?;
        let mut sum = Fraction::constant(if k == 0 { Rational::ONE } else { Rational::ZERO });
        for i in 0..=k {
            let term = x[i].mul_within(&x[k - i], work)?;
            sum = match angle.kind {
                Kind::Circular => sum.add_within(&term, work)?,
                Kind::Hyperbolic => sum.sub_within(&term, work)?,
                Kind::Linear => sum,
            };
        }
        let share = Fraction::constant(Rational::new(1, k as i64 + 1));
        y.push(slope.mul_within(&sum, work)?.mul_within(&share, work)?);
    }
    Some(y)
}

fn product(a: &[Fraction], b: &[Fraction], work: &mut Work) -> Option<Vec<Fraction>> {
    let mut all = Vec::new();
    for k in 0..a.len() {
        let mut sum = Fraction::zero();
        for i in (0..=k).filter(|i| !a[*i].is_zero() && !b[k - i].is_zero()) {
            sum = sum.add_within(&a[i].mul_within(&b[k - i], work)?, work)?;
        }
        all.push(sum);
    }
    Some(all)
}

/// `None` too where the denominator vanishes at the end.
fn quotient(above: &[Fraction], below: &[Fraction], work: &mut Work) -> Option<Vec<Fraction>> {
    let mut all: Vec<Fraction> = Vec::new();
    for k in 0..above.len() {
        let mut rest = above[k].clone();
        for i in (0..k).filter(|i| !below[k - i].is_zero()) {
            rest = rest.sub_within(&all[i].mul_within(&below[k - i], work)?, work)?;
        }
        all.push(rest.div_within(&below[0], work).ok().flatten()?);
    }
    Some(all)
}
