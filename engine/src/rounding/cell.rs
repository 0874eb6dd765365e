//! Cells of the domain, and what Bernstein coefficients on them tell.

use std::rc::Rc;

use basis_kernel::Domain;

use crate::algebra::bernstein::{Form, Side};
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use basis_prover::collections::list::Listed;

/// A cell.
pub(super) struct Cell {
    pub(super) domain: Rc<Domain>,
    /// The coordinates on each simplex, whose sum is 1.
    simplices: Vec<Vec<Var>>,
    /// With which power of their sums polynomials are multiplied that are compared.
    power: u32,
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
        cells.map(|region| Self::whole(&region, &[])).listed()
    }

    /// The cell that is all of a region, with the coordinates on each simplex.
    pub(super) fn whole(region: &Region, simplices: &[Vec<Var>]) -> Self {
        Self { domain: Rc::new(Domain::of(region.clone())), simplices: simplices.to_vec(), power: 0 }
    }

    /// The same cell, with comparisons of polynomials of a higher degree; `None` where there are no simplices.
    ///
    /// On a simplex the coefficients of homogeneous polynomials approach their values when these are multiplied with
    /// powers of the sum of the coordinates.
    pub(super) fn raised(&self) -> Option<Self> {
        let Self { domain, simplices, power } = self;
        (!simplices.is_empty()).then(|| Self {
            domain: Rc::clone(domain),
            simplices: simplices.clone(),
            power: power + 2,
        })
    }

    /// A polynomial times the power of the sums of coordinates.
    pub(super) fn times_power(&self, p: Poly, work: &mut Work) -> Option<Poly> {
        if self.power == 0 {
            return Some(p);
        }
        let factor = self.simplices.iter().fold(Poly::one(), |all, own| &all * &sum(own).pow(self.power));
        work.spend_product(&p, &factor)?;
        Some(&p * &factor)
    }

    /// A polynomial times powers of the sums of coordinates, so that it has the degree of some others in those of each
    /// simplex, if these are homogeneous of one degree.
    pub(super) fn of_degree(&self, p: &Poly, others: &mut dyn Iterator<Item = &Poly>) -> Poly {
        let mut all = others.filter(|other| !other.is_zero()).collect::<Vec<_>>();
        all.push(p);
        self.simplices.iter().fold(p.clone(), |p, own| {
            let degrees = all.iter().map(|other| degree(other, own)).collect::<Option<Vec<_>>>();
            match degrees.as_deref() {
                Some([degree, rest @ .., of_p]) if rest.iter().all(|other| other == degree) => {
                    degree.checked_sub(*of_p).map_or_else(|| p.clone(), |missing| &p * &sum(own).pow(missing))
                }
                _ => p,
            }
        })
    }

    /// Both halves along a variable: a range without ends is cut at 0, one with one end as far from it as that is from
    /// 0, but by 1 at least.
    pub(super) fn halves(&self, var: Var) -> Option<[Self; 2]> {
        let region = &self.domain.region;
        let range = region.range(var);
        let step = |x: &Rational| x.abs().max(Rational::ONE);
        let middle = match (range.low.value(), range.high.value()) {
            (Some(low), Some(high)) if low == high => return None,
            (Some(low), Some(high)) => &(low + high) * &Rational::new(1, 2),
            (Some(low), None) => low + &step(low),
            (None, Some(high)) => high - &step(high),
            (None, None) => Rational::ZERO,
        };
        let halves = [
            Range { low: range.low, high: End::Included(middle.clone()) },
            Range { low: End::Included(middle), high: range.high },
        ];
        let of = |half: Range| Self {
            power: self.power,
            ..Self::whole(&with(region, var, &half), &self.simplices)
        };
        Some(halves.map(of))
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

    /// Whether p has both signs at corners of the cell, or towards its infinite ends.
    pub(super) fn has_both_signs(&self, p: &Poly, work: &mut Work) -> Option<bool> {
        let form = Form::new(p, &self.sides(&[p])?, work)?;
        let degrees = form.degrees();
        let is_corner = |place: usize| {
            (0..degrees.len()).all(|axis| {
                let own = place / form.stride(axis) % (degrees[axis] + 1);
                own == 0 || own == degrees[axis]
            })
        };
        let corners = form.coefficients().iter().enumerate().filter(|(place, _)| is_corner(*place));
        let corners = corners.map(|(_, c)| c).listed();
        Some(corners.iter().any(|c| c.is_negative()) && corners.iter().any(|c| c.is_positive()))
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

fn sum(variables: &[Var]) -> Poly {
    variables.iter().fold(Poly::zero(), |sum, v| &sum + &Poly::var(*v))
}

/// The degree of a polynomial in some variables, if it is homogeneous in these.
fn degree(p: &Poly, variables: &[Var]) -> Option<u32> {
    let of = |m: &Monomial| variables.iter().map(|v| u32::from(m.exponent(*v))).sum::<u32>();
    let mut degrees = p.terms().map(|(m, _)| of(m));
    let first = degrees.next()?;
    degrees.all(|other| other == first).then_some(first)
}

/// A region with another range of a variable.
fn with(region: &Region, var: Var, own: &Range) -> Region {
    let mut part = region.clone();
    for (v, range) in &mut part.ranges {
        if *v == var {
            *range = own.clone();
        }
    }
    part
}

/// A region in equal parts along a variable.
fn parts(region: &Region, var: Var, count: i64) -> Vec<Region> {
    let range = region.range(var);
    let with = |own: Range| with(region, var, &own);
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
