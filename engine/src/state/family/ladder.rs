//! Signs of functions in which a variable stands beside its own sine or exponential.
//!
//! **Theorems.** On [a, b] a function g with g(a) ≥ 0 and g′ ≥ 0 is ≥ 0, as is one with g(b) ≥ 0 and g′ ≤ 0; and so is a concave
//! one, g″ ≤ 0, with g(a) ≥ 0 and g(b) ≥ 0. Where an end value is > 0, so is g by the first two.
//!
//! A derivative lowers the degree in the variable where its factors are constant, until only sines are left. What is
//! stated is enough for the claim, but need not be true if the claim is.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::Family;
use crate::model::angle::{Angle, Kind};
use basis_prover::typical;

/// Derivatives that are tried.
const MAX_DEPTH: usize = 6;

/// Something that has to be ≥ 0, or > 0.
pub(super) struct Step {
    pub(super) of: String,
    pub(super) value: Fraction,
    pub(super) comparison: Comparison,
}

/// What is enough for a value to be ≥ 0 (> 0) on the domain; `None` where the variable does not stand beside its sine.
pub(super) fn steps(
    family: &Family,
    of: &str,
    value: &Fraction,
    comparison: Comparison,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let (var, low, high) = family.interval()?;
    let angle = family.analytic.angle(var).filter(|a| a.kind != Kind::Linear)?;
    let (value, of) = match comparison {
        Comparison::GreaterEqual | Comparison::Greater => (value.clone(), of.to_string()),
        Comparison::LessEqual | Comparison::Less => (-value, format!("-({of})")),
        _ => return None,
    };
    let strict = matches!(comparison, Comparison::Greater | Comparison::Less);
    if !value.depends_on(angle.itself) {
        return None;
    }
    let ladder = Ladder { family, angle, ends: [low.clone(), high.clone()] };
    let mut found = Vec::new();
    ladder.add(&of, &value, strict, MAX_DEPTH, &mut found, work)?;
    Some(found)
}

struct Ladder<'f> {
    family: &'f Family,
    angle: &'f Angle,
    /// y at both ends.
    ends: [Rational; 2],
}

impl Ladder<'_> {
    fn add(
        &self,
        of: &str,
        value: &Fraction,
        strict: bool,
        depth: usize,
        found: &mut Vec<Step>,
        work: &mut Work,
    ) -> Option<()> {
        let comparison = if strict { Comparison::Greater } else { Comparison::GreaterEqual };
        let mut push = |of: String, value: Fraction, comparison| found.push(Step { of, value, comparison });
        if !value.depends_on(self.angle.itself) {
            push(String::from(of), value.clone(), comparison);
            return Some(());
        }
        let depth = depth.checked_sub(1)?;
        let slope = self.family.derivative_within(value, self.angle.var, work)?;
        let range = &self.family.domain.first()?.range;
        let (first, last) =
            (self.at(value, 0, work), self.at(value, 1, work).filter(|_| range.high.is_included()));
        let sign = |value: &Option<Fraction>| value.as_ref().and_then(|v| self.sign(v));
        let growing = match (sign(&first)?, sign(&last)) {
            (_, None) => true,
            (0, Some(0)) if !strict => {
                let curved = self.family.derivative_within(&slope, self.angle.var, work)?;
                push(format!("{of} at {}", self.angle.ends[0]), first?, comparison);
                push(format!("{of} at {}", self.angle.ends[1]), last?, comparison);
                return self.add(&format!("-D({of}, 2)"), &-&curved, false, depth, found, work);
            }
            (a, Some(b)) if a != b => a < b,
            _ => {
                let rise = last.as_ref()?.sub_within(first.as_ref()?, work)?;
                self.sign(&rise)? >= 0
            }
        };
        if growing {
            push(format!("{of} at {}", self.angle.ends[0]), first?, comparison);
            self.add(&format!("D({of})"), &slope, false, depth, found, work)
        } else {
            push(format!("{of} at {}", self.angle.ends[1]), last?, comparison);
            self.add(&format!("-D({of})"), &-&slope, false, depth, found, work)
        }
    }

    /// The value at an end of the domain.
    fn at(&self, value: &Fraction, side: usize, work: &mut Work) -> Option<Fraction> {
        let y = Fraction::constant(self.ends[side].clone());
        let put = value.substitute_within(self.angle.var, &y, work).ok()??;
        put.substitute_within(self.angle.itself, &self.angle.limits[side], work).ok()?
    }

    /// The sign at a typical point: a guess, from which the steps are chosen.
    fn sign(&self, value: &Fraction) -> Option<i32> {
        let point = |p: &Poly| {
            let region = self.family.region();
            let coordinate = |v: Var| {
                let range = region.ranges.iter().find(|(w, _)| *w == v).map(|(_, r)| r.clone());
                middle(&range.unwrap_or_else(Range::all))
            };
            let number = p.variables().into_iter().fold(p.clone(), |p, v| p.at(v, &coordinate(v)));
            number.as_constant().map_or(0, |c| c.signum())
        };
        if value.is_zero() {
            return Some(0);
        }
        Some(point(value.numer()) * point(value.denom()))
    }
}

/// The middle of a range, or another point of it.
fn middle(range: &Range) -> Rational {
    range.finite().map_or_else(|| typical(range), |(a, b)| &(a + b) * &Rational::new(1, 2))
}
