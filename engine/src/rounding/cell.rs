//! Cells of the domain, and what Bernstein coefficients on them tell.

use std::rc::Rc;

use basis_kernel::Domain;

use crate::algebra::bernstein::{Form, Side};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use basis_prover::collections::list::Listed;

/// A cell.
pub(super) struct Cell {
    pub(super) domain: Rc<Domain>,
}

/// More cells than this are not made.
const MOST: u64 = 64;

impl Cell {
    /// The cells of a grid that cuts the range of each of some variables into a number of equal parts, or fewer when
    /// these would be too many cells. A range without end is cut at 0, if that is inside, and nowhere else.
    pub(super) fn grid(region: &Region, cuts: &[(Var, u32)]) -> Vec<Self> {
        let mut most = cuts.iter().map(|(_, count)| *count).max().unwrap_or(1);
        let size = |most: u32| {
            cuts.iter().fold(1_u64, |size, (_, count)| size.saturating_mul(u64::from(*count.min(&most))))
        };
        while most > 1 && size(most) > MOST {
            most -= 1;
        }
        let mut cells = vec![region.clone()];
        for (var, count) in cuts {
            let mut finer = Vec::new();
            for cell in cells {
                finer.extend(parts(&cell, *var, i64::from(*count.min(&most))));
            }
            cells = finer;
        }
        let cells = cells.into_iter();
        cells.map(|region| Self { domain: Rc::new(Domain::of(region)) }).listed()
    }

    /// Whether p ≥ 0 (`Some(true)`) or p ≤ 0 (`Some(false)`) by the signs of its Bernstein coefficients.
    pub(super) fn sign(&self, p: &Poly, work: &mut Work) -> Option<bool> {
        if let Some(c) = p.as_constant() {
            return Some(!c.is_negative());
        }
        let form = Form::new(p, &self.sides(&[p])?, work)?;
        let negative = form.coefficients().iter().any(Rational::is_negative);
        let positive = form.coefficients().iter().any(Rational::is_positive);
        (!(negative && positive)).then_some(!negative)
    }

    /// The least κ ≥ 0 for which no Bernstein coefficient of κ·q − p is negative; `None` if there is none.
    pub(super) fn ratio(&self, p: &Poly, q: &Poly, work: &mut Work) -> Option<Rational> {
        // q + z·p in one form, so that the degrees are the same: z = 0 gives q, z = 1 gives q + p.
        let z = self.unused(&[p, q]);
        let both = q + &(&Poly::var(z) * p);
        let mut sides = self.sides(&[p, q])?;
        sides.push((z, Side::Finite(Rational::ZERO, Rational::ONE)));
        let form = Form::new(&both, &sides, work)?;
        let mut least = Rational::ZERO;
        for pair in form.coefficients().chunks(form.degrees().last()? + 1) {
            let [below, above] = pair else { continue };
            let above = above - below;
            if below.is_positive() {
                let ratio = above.checked_div(below)?;
                if ratio > least {
                    least = ratio;
                }
            } else if below.is_negative() || above.is_positive() {
                return None;
            }
        }
        Some(least)
    }

    /// The sides of the cell along the variables that occur; `None` if one has no ends.
    fn sides(&self, polys: &[&Poly]) -> Option<Vec<(Var, Side)>> {
        let mut sides = Vec::new();
        for (var, range) in &self.domain.region.ranges {
            if polys.iter().any(|p| p.depends_on(*var)) {
                sides.push((*var, Side::of(range)?));
            }
        }
        Some(sides)
    }

    /// A variable that does not occur.
    fn unused(&self, polys: &[&Poly]) -> Var {
        let ranges = self.domain.region.ranges.iter().map(|(v, _)| v.0 + 1);
        let others = polys.iter().flat_map(|p| p.variables()).map(|v| v.0 + 1);
        Var(ranges.chain(others).max().unwrap_or(0))
    }
}

/// A region in equal parts along a variable.
fn parts(region: &Region, var: Var, count: i64) -> Vec<Region> {
    let range = region.range(var);
    let with = |own: Range| {
        let mut part = region.clone();
        for (v, range) in &mut part.ranges {
            if *v == var {
                *range = own.clone();
            }
        }
        part
    };
    let Some((low, high)) = range.finite() else {
        let zero = Rational::ZERO;
        let is_inside = range.low.value().is_none_or(Rational::is_negative)
            && range.high.value().is_none_or(Rational::is_positive);
        if !is_inside || count < 2 {
            return vec![region.clone()];
        }
        let below = Range { low: range.low.clone(), high: End::Included(zero.clone()) };
        return vec![with(below), with(Range { low: End::Included(zero), high: range.high.clone() })];
    };
    let at = |k: i64| low + &(&(high - low) * &Rational::new(k, count));
    (0..count).map(|k| with(Range::closed(at(k), at(k + 1)))).listed()
}
