//! Strict signs on open boxes, by slices.
//!
//! **Theorem** (Lazard 1994; proof by McCallum, Parusiński and Paunescu 2019). Let the polynomials of the levels be as
//! in `levels`, and for three variables or more contain the trailing coefficients too. Over an interval between
//! neighbouring roots of the lowest level all cells are alike, those that are not open as well: p has a zero in every
//! slice x = c of the open box or in none. So if p has no zero in one slice of each interval, nor in those at the
//! rational roots, then a zero of p has an irrational root of the lowest level as this coordinate. If that is so for
//! each variable, and p is not zero near the points with such coordinates, p has no zero at all; the box is connected,
//! and one positive value is enough.

use std::rc::Rc;

use super::bernstein::all_positive;
use super::claim::{Claim, inside};
use super::levels::projections;
use super::sturm::Sturm;
use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::certificate::{Base, Section, SignProof, Slices};
use crate::refusal::{Refusal, fits, shown};
use crate::statement::Relation;

/// How the claim in a slice is checked.
pub(super) type Check = fn(&Claim, &SignProof, &mut Work) -> Result<(), Refusal>;

/// Checks that p is positive on an open box.
pub(super) fn slices(claim: &Claim, slices: &Slices, check: Check, work: &mut Work) -> Result<(), Refusal> {
    let open = claim.ranges.iter().all(|(_, r)| !r.low.is_included() && !r.high.is_included());
    fits(claim.relation == Relation::Positive && open, "slices are for p > 0 on open boxes only")?;
    fits(claim.ranges.len() > 1, "slices are for two variables or more")?;
    let mut irrational = Vec::new();
    let mut variables = Vec::new();
    for base in &slices.bases {
        let (var, sections) = self::base(claim, base, check, work)?;
        variables.push(var);
        irrational.push(sections);
    }
    let covered = match &irrational[..] {
        [only] => only.is_empty(),
        _ => variables.iter().eq(claim.ranges.iter().map(|(v, _)| v)),
    };
    fits(covered, "a variable is not cut into slices")?;
    let count = irrational.iter().try_fold(1_usize, |n, s| n.checked_mul(s.len()));
    fits(count == Some(slices.boxes.len()), "the number of boxes is another one")?;
    for (number, ends) in slices.boxes.iter().enumerate() {
        fits(ends.len() == irrational.len(), "a box has another dimension")?;
        let mut rest = number;
        let mut sides = Vec::new();
        for (k, sections) in irrational.iter().enumerate().rev() {
            let (low, high, sturm) = &sections[rest % sections.len()];
            rest /= sections.len();
            let (a, b) = &ends[k];
            work.spend(sturm.cost(&[a, b])).ok_or(Refusal::Spent)?;
            let around = *low <= a && a < b && b <= *high && !sturm.is_root(a) && !sturm.is_root(b);
            shown(around && sturm.count(Some(a), Some(b)) == 1, "a box misses its point")?;
            sides.push((variables[k], Range::closed(a.clone(), b.clone())));
        }
        all_positive(&claim.poly, &sides, work)?;
    }
    // The box is connected and p has no zero: one positive value is enough, and one of the slices has it.
    Ok(())
}

/// An irrational section: its interval, and the roots of its level.
type Irrational<'a> = (&'a Rational, &'a Rational, Rc<Sturm>);

/// Checks the slices along one variable; the variable and the sections that are left.
fn base<'a>(
    claim: &Claim,
    base: &'a Base,
    check: Check,
    work: &mut Work,
) -> Result<(Var, Vec<Irrational<'a>>), Refusal> {
    projections(claim, &base.order, &base.levels, claim.ranges.len() > 2, work)?;
    let (Some(var), Some(level)) = (base.order.first(), base.levels.first()) else {
        return Err(Refusal::Unfit("there is no level"));
    };
    let range = claim.range(*var)?;
    let sturm = Rc::new(Sturm::new(level.iter(), *var, work)?);
    let values: Vec<&Rational> = base.sectors.iter().map(|(x, _)| x).collect();
    work.spend(sturm.cost(&values)).ok_or(Refusal::Spent)?;
    sturm.separated(&values, range)?;
    fits(base.sections.len() + 1 == values.len(), "there is not one section between neighbouring slices")?;
    for (x, proof) in &base.sectors {
        check(&claim.slice(*var, x, work)?, proof, work)?;
    }
    let mut irrational = Vec::new();
    for (section, between) in base.sections.iter().zip(values.windows(2)) {
        match section {
            Section::Exact(x, proof) => {
                let here = between[0] < x && x < between[1] && inside(range, x) && sturm.is_root(x);
                shown(here, "a section is not a root")?;
                check(&claim.slice(*var, x, work)?, proof, work)?;
            }
            Section::Between(a, b) => {
                work.spend(sturm.cost(&[a, b])).ok_or(Refusal::Spent)?;
                let here =
                    between[0] <= a && a < b && b <= between[1] && !sturm.is_root(a) && !sturm.is_root(b);
                let one = here && sturm.count(Some(a), Some(b)) == 1;
                shown(one, "an interval does not isolate a root")?;
                irrational.push((a, b, Rc::clone(&sturm)));
            }
        }
    }
    Ok((*var, irrational))
}
