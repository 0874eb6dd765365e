//! Zeros and extrema as quotients of polynomials in the shape parameters, for all of their values at once.
//!
//! The numerator of a function and that of its slope are split into factors. Where all of them that contain the variable are
//! linear in it, zeros and stationary points are quotients of polynomials in the shape parameters. Which of them lie in the
//! domain, and at which of them the function is least or greatest, is proved for all shape values, or nothing is said.

use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::decide;

use super::{Extrema, Extremum};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::model::angle::Kind;

/// Zeros and extrema of a function of a family with shape parameters, without its name; nothing inside if it is negative
/// nowhere, `None` if they are not of this kind.
#[expect(clippy::option_option, reason = "they may be of another kind")]
pub(super) fn of_function(family: &Family, f: &Fraction, work: &mut Work) -> Option<Option<Extrema>> {
    let (var, low, high) = family.interval()?;
    let is_linear = family.analytic.angles.iter().all(|a| a.kind == Kind::Linear && a.var == var);
    if family.shapes.is_empty() || !family.constraints.is_empty() || !is_linear {
        return None;
    }
    let own = |v: Var| v == var || family.shapes.iter().any(|p| p.var == v);
    if !f.numer().variables().into_iter().chain(f.denom().variables()).all(own) {
        return None;
    }
    let all = Known { family, var, ends: [low, high], domain: Rc::new(family.points()) };
    let derivative = f.derivative_within(var, work)?;
    let ends = [low, high].map(|end| Fraction::constant(end.clone()));
    let mut points = ends.to_vec();
    for point in all.roots(derivative.numer(), work)? {
        if !points.contains(&point) {
            points.push(point);
        }
    }
    let mut values = Vec::new();
    for point in &points {
        values.push((f.substitute_within(var, point, work).ok()??, point));
    }
    let least = all.extreme(&values, false, work)?;
    if all.is_nonnegative(&least.0) {
        return Some(None);
    }
    let greatest = all.extreme(&values, true, work)?;
    let zeros = if f.is_zero() { Vec::new() } else { all.roots(f.numer(), work)? };
    let zeros = zeros.mapped(|point| all.place(point));
    Some(Some(Extrema { zeros, ..Extrema::new("", all.extremum(least), all.extremum(greatest)) }))
}

/// What is known of the domain and the shape values.
struct Known<'f> {
    family: &'f Family,
    var: Var,
    ends: [&'f Rational; 2],
    domain: Rc<Domain>,
}

impl Known<'_> {
    /// Whether a function of the shape parameters is proved to be ≥ 0 for all of their values.
    fn is_nonnegative(&self, f: &Fraction) -> bool {
        self.is_so(f, Relation::NonNegative)
    }

    fn is_so(&self, f: &Fraction, relation: Relation) -> bool {
        let value = f.quotient();
        let sign = Statement::Sign { value, relation, domain: Rc::clone(&self.domain) };
        decide(sign, &Vec::new(), self.family.budget).is_ok()
    }

    /// The zeros of a polynomial that lie in the domain, each once; `None` where they are no quotients, or where it is not known
    /// whether they lie in the domain.
    fn roots(&self, p: &Poly, work: &mut Work) -> Option<Vec<Fraction>> {
        if p.is_zero() {
            return Some(Vec::new());
        }
        let mut all = Vec::new();
        for (factor, _) in checked_factor(p, work)?.1 {
            let coefficients = factor.coefficients_in(self.var);
            let [rest, slope] = match &coefficients[..] {
                // Where it vanishes, the whole polynomial does.
                [_] => continue,
                [rest, slope] => [rest, slope].map(|p| Fraction::from(p.clone())),
                _ if self.keeps_its_sign(&factor) => continue,
                _ => return None,
            };
            // At a value at which the slope vanishes there is no zero, or no other point.
            if !self.is_so(&slope, Relation::Positive) && !self.is_so(&-&slope, Relation::Positive) {
                return None;
            }
            let root = (-&rest).checked_div(&slope)?;
            let [below, above] = self.ends.map(|end| &root - &Fraction::constant(end.clone()));
            if self.is_nonnegative(&below) && self.is_nonnegative(&-&above) {
                all.push(root);
            } else if !self.is_so(&-&below, Relation::Positive) && !self.is_so(&above, Relation::Positive) {
                return None;
            }
        }
        Some(all)
    }

    /// Whether a factor vanishes nowhere on the domain.
    fn keeps_its_sign(&self, factor: &Poly) -> bool {
        let factor = Fraction::from(factor.clone());
        self.is_so(&factor, Relation::Positive) || self.is_so(&-&factor, Relation::Positive)
    }

    /// The value that is proved to be the least, or the greatest, of some for all shape values, and all points at which it is
    /// taken.
    fn extreme(
        &self,
        values: &[(Fraction, &Fraction)],
        greatest: bool,
        work: &mut Work,
    ) -> Option<(Fraction, Vec<Fraction>)> {
        for (value, _) in values {
            let mut is_extreme = true;
            for (other, _) in values {
                let difference = other.sub_within(value, work)?;
                let difference = if greatest { -&difference } else { difference };
                is_extreme = is_extreme && self.is_nonnegative(&difference);
            }
            if is_extreme {
                let at = values.iter().filter(|(other, _)| other == value);
                return Some((value.clone(), at.map(|(_, point)| (*point).clone()).listed()));
            }
        }
        None
    }

    fn extremum(&self, (value, points): (Fraction, Vec<Fraction>)) -> Extremum {
        Extremum {
            value: super::super::written(self.family, &value),
            at: points.mapped(|point| self.place(point)),
            on: Vec::new(),
        }
    }

    /// A point in the variable itself.
    fn place(&self, point: &Fraction) -> String {
        let angle = self.family.analytic.angle(self.var);
        let itself = angle.and_then(|angle| angle.tangent().substitute(self.var, point));
        let name = angle.map_or(&self.family.names[self.var.0], |angle| &angle.name);
        format!("{name} = {}", super::super::written(self.family, itself.as_ref().unwrap_or(point)))
    }
}
