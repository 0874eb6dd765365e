//! All ranges of one variable on which polynomials are nonnegative.

use crate::collections::list::Listed;
use core::cmp::Ordering;

use crate::algebra::divisors::gcd::square_free;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, between_roots};
use crate::budget::Budget;
use crate::coordinate::Coordinate;
use crate::sign::decomposition::projection::{all_roots, basis, levels, univariates};
use crate::sign::problem::Problem;
use crate::sign::univariate;
use crate::sign::{Outcome, prove};
use basis_kernel::{Relation, with};

/// A closed interval; `None` where it has no end.
pub type Part = (Option<Coordinate>, Option<Coordinate>);

/// The largest intervals of `var` that meet its range in the region and on which all polynomials are nonnegative, the
/// other variables on their ranges, in increasing order; single irrational numbers are left out.
///
/// # Errors
/// What is left to decide when the budget is spent.
pub fn nonnegative_parts(
    polys: &[Poly],
    var: Var,
    region: &Region,
    budget: &mut Budget,
) -> Result<Vec<Part>, String> {
    let spent = || String::from("the budget is spent on the projection to one parameter");
    let mut problems = Vec::new();
    for p in polys {
        corners(p, var, region, &mut problems);
    }
    let mut critical = Vec::new();
    for problem in problems.iter().filter(|problem| problem.poly.depends_on(var)) {
        critical.extend(projection(problem, var, budget).ok_or_else(spent)?);
    }
    let found = (|| {
        let polys = univariates(&basis(&critical, &mut budget.work)?, var)?;
        let mut roots = all_roots(&polys, &Range::all(), &mut budget.work)?;
        for (k, root) in &mut roots {
            root.detect_rational(&polys[*k], &mut budget.work)?;
        }
        Some((polys, roots))
    })();
    let (polys, roots) = found.ok_or_else(spent)?;
    let plain: Vec<Root> = roots.iter().map(|(_, root)| root.clone()).listed();
    let mut holds = |x: &Rational| -> Result<bool, String> {
        for problem in &problems {
            match prove(&problem.fix(var, x), Relation::NonNegative, budget) {
                Outcome::Proved(..) => {}
                Outcome::Refuted(_) => return Ok(false),
                Outcome::Unknown(left) => return Err(left),
            }
        }
        Ok(true)
    };
    // Between neighbouring roots one value decides for all, and what holds there holds at the ends.
    let cells = between_roots(&plain, None, None).iter().map(&mut holds).collect::<Result<Vec<_>, _>>()?;
    let mut parts: Vec<(Option<usize>, Option<usize>)> = Vec::new();
    let mut open = None;
    for (k, good) in cells.iter().enumerate() {
        let before = k.checked_sub(1);
        match (open, good) {
            (None, true) => open = Some(before),
            (None, false) => {
                if let (Some(r), Some(Root::Exact(x))) = (before, before.and_then(|r| plain.get(r)))
                    && !cells[r]
                    && holds(x)?
                {
                    parts.push((before, before));
                }
            }
            (Some(_), true) => {}
            (Some(start), false) => {
                parts.push((start, before));
                open = None;
            }
        }
    }
    parts.extend(open.map(|start| (start, None)));
    let mut end = |k: Option<usize>| match k {
        None => Ok(None),
        Some(k) => {
            let (of, root) = &roots[k];
            univariate::coordinate(&polys[*of], root, &mut budget.work).map(Some).ok_or_else(spent)
        }
    };
    let mut result = Vec::new();
    for (low, high) in parts {
        let part = (end(low)?, end(high)?);
        if meets(&part, &region.range(var)) {
            result.push(part);
        }
    }
    Ok(result)
}

/// A problem for each choice of ends of the ranges of those variables in which a polynomial has degree 1: with fewer
/// variables to project.
fn corners(p: &Poly, var: Var, region: &Region, problems: &mut Vec<Problem>) {
    let problem = Problem::new(p, &with(region, var, Range::all()));
    let affine = |(v, r): &&(Var, Range)| *v != var && problem.poly.degree(*v) == 1 && *r != Range::all();
    let Some((other, range)) = problem.ranges.iter().find(affine) else { return problems.push(problem) };
    let slope = problem.poly.derivative(*other);
    let low = range.low.value().map_or_else(|| -&slope, |x| problem.poly.at(*other, x));
    let high = range.high.value().map_or_else(|| slope.clone(), |x| problem.poly.at(*other, x));
    let rest = Region { ranges: region.ranges.iter().filter(|(v, _)| v != other).cloned().listed() };
    for end in [low, high] {
        corners(&end, var, &rest, problems);
    }
}

/// Polynomials in `var` at whose roots the claim of a problem can change; `None` when the work is spent.
fn projection(problem: &Problem, var: Var, budget: &mut Budget) -> Option<Vec<Poly>> {
    let factors = square_free(&problem.poly, &mut budget.work)?;
    // An even power changes no sign; but where one in `var` alone vanishes, the others do not matter.
    let counts = |(f, e): &(Poly, u32)| e % 2 == 1 || f.variables() == [var];
    let factors: Vec<Poly> = factors.into_iter().filter(counts).map(|(f, _)| f).listed();
    let levels = levels(&factors, &problem.ranges, Some(var), false, &mut budget.work)?;
    levels.sets.into_iter().next()
}

/// Whether an interval and a range have a number in common, ends of the range included.
fn meets((low, high): &Part, range: &Range) -> bool {
    let order = |c: &Coordinate, x: &Rational| match c {
        Coordinate::Rational(r) => r.cmp(x),
        Coordinate::Algebraic(r) => r.compare(x),
    };
    let below = |c: &Coordinate| range.high.value().is_none_or(|x| order(c, x) != Ordering::Greater);
    let above = |c: &Coordinate| range.low.value().is_none_or(|x| order(c, x) != Ordering::Less);
    low.as_ref().is_none_or(below) && high.as_ref().is_none_or(above)
}
