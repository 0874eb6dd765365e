//! Checks the search for zeros in slices.

use super::bernstein::{coefficients, cost};
use super::levels::projections;
use super::sturm::Sturm;
use super::{Claim, check, inside};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::decide::Relation;
use crate::decide::certificate::{Base, Section, Slices};

/// Checks that p is positive on an open box.
pub(super) fn slices(claim: &Claim<'_>, slices: &Slices, depth: usize) -> Result<(), String> {
    let open = claim.ranges.iter().all(|(_, r)| !r.low.is_included() && !r.high.is_included());
    check(claim.relation == Relation::Positive && open, || "slices are for p > 0 on open boxes only".into())?;
    check(claim.ranges.len() > 1, || "slices are for two variables or more".into())?;
    let mut irrational = Vec::new();
    let mut variables = Vec::new();
    for base in &slices.bases {
        let (var, sections) = self::base(claim, base, depth)?;
        variables.push(var);
        irrational.push(sections);
    }
    let covered = match &irrational[..] {
        [only] => only.is_empty(),
        _ => variables.iter().eq(claim.ranges.iter().map(|(v, _)| v)),
    };
    check(covered, || "a variable is not cut into slices".into())?;
    let count = irrational.iter().try_fold(1_usize, |n, s| n.checked_mul(s.len()));
    check(count == Some(slices.boxes.len()), || "the number of boxes is another one".into())?;
    for (number, ends) in slices.boxes.iter().enumerate() {
        check(ends.len() == irrational.len(), || "a box has another dimension".into())?;
        let mut rest = number;
        let mut sides = Vec::new();
        for (k, sections) in irrational.iter().enumerate().rev() {
            let (low, high, sturm) = &sections[rest % sections.len()];
            rest /= sections.len();
            let (a, b) = &ends[k];
            claim.spend(sturm.cost(&[a, b]))?;
            let around = *low <= a && a < b && b <= *high && !sturm.is_root(a) && !sturm.is_root(b);
            check(around && sturm.count(Some(a), Some(b)) == 1, || "a box misses its point".into())?;
            sides.push((variables[k], Range::closed(a.clone(), b.clone())));
        }
        claim.spend(cost(&claim.poly, &sides))?;
        let form = coefficients(&claim.poly, &sides)?;
        let size: u64 = claim.ranges.iter().map(|(v, _)| u64::from(claim.poly.degree(*v)) + 1).product();
        let positive = form.terms().all(|(_, c)| c.is_positive()) && form.len() as u64 == size;
        check(positive, || "a Bernstein coefficient on a box is not positive".into())?;
    }
    // The box is connected and p has no zero: one positive value is enough, and one of the slices has it.
    Ok(())
}

/// An irrational section: its interval, and the roots of its level.
type Irrational<'a> = (&'a Rational, &'a Rational, std::rc::Rc<Sturm>);

/// Checks the slices along one variable; the variable and the sections that are left.
fn base<'a>(
    claim: &Claim<'_>,
    base: &'a Base,
    depth: usize,
) -> Result<(crate::algebra::poly::Var, Vec<Irrational<'a>>), String> {
    projections(claim, &base.order, &base.levels, claim.ranges.len() > 2)?;
    let (Some(var), Some(level)) = (base.order.first(), base.levels.first()) else {
        return Err("there is no level".into());
    };
    let range = claim.range(*var)?;
    let sturm = std::rc::Rc::new(Sturm::new(level.iter(), *var, &mut claim.work.borrow_mut())?);
    let values: Vec<&Rational> = base.sectors.iter().map(|(x, _)| x).collect();
    claim.spend(sturm.cost(&values))?;
    sturm.separated(&values, range)?;
    check(base.sections.len() + 1 == values.len(), || {
        "there is not one section between neighbouring slices".into()
    })?;
    let slice = |x: &Rational, certificate| {
        claim.part(claim.poly.at(*var, x), claim.relation)?.verify(certificate, depth + 1)
    };
    for (x, certificate) in &base.sectors {
        slice(x, certificate)?;
    }
    let mut irrational = Vec::new();
    for (section, between) in base.sections.iter().zip(values.windows(2)) {
        match section {
            Section::Exact(x, certificate) => {
                let here = between[0] < x && x < between[1] && inside(range, x) && sturm.is_root(x);
                check(here, || format!("the section {x} is not a root"))?;
                slice(x, certificate)?;
            }
            Section::Between(a, b) => {
                claim.spend(sturm.cost(&[a, b]))?;
                let here =
                    between[0] <= a && a < b && b <= between[1] && !sturm.is_root(a) && !sturm.is_root(b);
                check(here && sturm.count(Some(a), Some(b)) == 1, || {
                    "an interval does not isolate a root".into()
                })?;
                irrational.push((a, b, std::rc::Rc::clone(&sturm)));
            }
        }
    }
    Ok((*var, irrational))
}
