//! The largest range of one variable on which polynomials stay nonnegative.

use crate::collections::sort::sort_by_key;
use core::cmp::Ordering;

use crate::algebra::divisors::gcd::square_free;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, between_roots};
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::coordinate::Coordinate;
use crate::sign::decomposition::projection::{all_roots, levels, univariates};
use crate::sign::problem::{Problem, inner};
use crate::sign::univariate;
use crate::sign::{Outcome, prove};
use basis_kernel::{Relation, with};

/// The largest interval around the declared range of a variable on which polynomials are nonnegative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LargestRange {
    /// From the first to the second end, both included; `None` where there is no end.
    Between(Option<Coordinate>, Option<Coordinate>),
    /// One of the polynomials is negative somewhere on the declared ranges.
    Negative,
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// Finds the largest interval of `var` around its range in the region on which all polynomials are nonnegative, the
/// other variables on their ranges.
///
/// A condition that holds for all values of the others in a range holds on a closed set of values of `var`, whose ends
/// are among the roots of the projection to `var`; so one value between neighbouring roots decides for all of them.
pub fn largest_range(polys: &[Poly], var: Var, region: &Region, budget: &mut Budget) -> LargestRange {
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return LargestRange::Between(None, None);
    }
    let (mut low, mut high) = (None, None);
    // The smallest first: most of the others narrow nothing then, and to see that is cheaper than to find how far they
    // would reach.
    let mut sorted: Vec<&Poly> = polys.iter().listed();
    sort_by_key(&mut sorted, |p| p.len());
    for (k, p) in sorted.into_iter().enumerate() {
        if k > 0 && nonnegative_between(p, var, (&low, &high), region, budget) {
            continue;
        }
        match of_one(p, var, region, budget) {
            LargestRange::Between(a, b) => {
                let narrowed = tighten(&mut low, a, Ordering::Greater, budget)
                    .and_then(|()| tighten(&mut high, b, Ordering::Less, budget));
                if narrowed.is_none() {
                    return LargestRange::Undecided(String::from(
                        "the budget is spent on comparing two ends",
                    ));
                }
            }
            other => return other,
        }
    }
    LargestRange::Between(low, high)
}

/// The work for the quick answer.
const QUICK: u64 = 100_000;

/// Whether a polynomial is seen with little work to be nonnegative for all values of `var` between two ends.
fn nonnegative_between(
    p: &Poly,
    var: Var,
    (low, high): (&Option<Coordinate>, &Option<Coordinate>),
    region: &Region,
    budget: &mut Budget,
) -> bool {
    let end = |end: &Option<Coordinate>| match end {
        None => Some(End::Infinite),
        Some(Coordinate::Rational(x)) => Some(End::Included(x.clone())),
        Some(Coordinate::Algebraic(_)) => None,
    };
    let (Some(low), Some(high)) = (end(low), end(high)) else { return false };
    let problem = Problem::new(p, &with(region, var, Range { low, high }));
    let mut part = budget.take(QUICK);
    let proved = matches!(prove(&problem, Relation::NonNegative, &mut part), Outcome::Proved(..));
    budget.put_back(&part);
    proved
}

/// Replaces an end by another one that compares with it as given, or that is the first at all; `None` when the work is
/// spent.
fn tighten(
    end: &mut Option<Coordinate>,
    other: Option<Coordinate>,
    replace: Ordering,
    budget: &mut Budget,
) -> Option<()> {
    let order = match (&other, &*end) {
        (None, _) => return Some(()),
        (Some(_), None) => replace,
        (Some(Coordinate::Rational(x)), Some(Coordinate::Rational(y))) => x.cmp(y),
        (Some(Coordinate::Algebraic(x)), Some(Coordinate::Rational(y))) => x.compare(y),
        (Some(Coordinate::Rational(x)), Some(Coordinate::Algebraic(y))) => y.compare(x).reverse(),
        (Some(Coordinate::Algebraic(x)), Some(Coordinate::Algebraic(y))) => {
            x.compare_with(y, &mut budget.work)?
        }
    };
    if order == replace {
        *end = other;
    }
    Some(())
}

fn of_one(p: &Poly, var: Var, region: &Region, budget: &mut Budget) -> LargestRange {
    let declared = region.range(var);
    let problem = Problem::new(p, &with(region, var, Range::all()));
    // Corners first: fewer variables to project.
    let affine = |(v, r): &&(Var, Range)| *v != var && problem.poly.degree(*v) == 1 && *r != Range::all();
    if let Some((other, range)) = problem.ranges.iter().find(affine) {
        let slope = problem.poly.derivative(*other);
        let low = range.low.value().map_or_else(|| -&slope, |x| problem.poly.at(*other, x));
        let high = range.high.value().map_or_else(|| slope.clone(), |x| problem.poly.at(*other, x));
        let rest = Region { ranges: region.ranges.iter().filter(|(v, _)| v != other).cloned().listed() };
        return largest_range(&[low, high], var, &rest, budget);
    }
    let undecided =
        || LargestRange::Undecided(String::from("the budget is spent on the projection to one parameter"));
    if !problem.poly.depends_on(var) {
        return match prove(&problem, Relation::NonNegative, budget) {
            Outcome::Proved(..) => LargestRange::Between(None, None),
            Outcome::Refuted(_) => LargestRange::Negative,
            Outcome::Unknown(left) => LargestRange::Undecided(left),
        };
    }
    let Some(factors) = square_free(&problem.poly, &mut budget.work) else { return undecided() };
    let odd: Vec<Poly> = factors.into_iter().filter(|(_, e)| e % 2 == 1).map(|(f, _)| f).listed();
    let Some(levels) = levels(&odd, &problem.ranges, Some(var), false, &mut budget.work) else {
        return undecided();
    };
    let found = (|| {
        let polys = univariates(&levels.sets[0], var)?;
        let mut roots = all_roots(&polys, &Range::all(), &mut budget.work)?;
        for (k, root) in &mut roots {
            root.detect_rational(&polys[*k], &mut budget.work)?;
        }
        Some((polys, roots))
    })();
    let Some((polys, roots)) = found else { return undecided() };
    let plain: Vec<Root> = roots.mapped(|(_, root)| root.clone());
    let samples = between_roots(&plain, None, None);
    // The number of roots below a number that is not one of them.
    let below = |x: &Rational| {
        let before = |(k, root): &(usize, Root)| match root {
            Root::Exact(r) => r < x,
            Root::Between(a, b) => b <= x || a < x && polys[*k].sign_at(a) != polys[*k].sign_at(x),
        };
        roots.iter().filter(|r| before(r)).count()
    };
    let single = declared.finite().filter(|(a, b)| a == b).map(|(a, _)| vec![a.clone()]);
    let candidates = single.unwrap_or_else(|| inner(&declared, roots.len() + 1));
    let Some(start) = candidates.iter().find(|x| polys.iter().all(|p| p.sign_at(x) != 0)) else {
        return LargestRange::Undecided(String::from("the declared range is a single critical value"));
    };
    let start = below(start);
    let mut holds =
        |cell: usize| match prove(&problem.fix(var, &samples[cell]), Relation::NonNegative, budget) {
            Outcome::Proved(..) => Ok(true),
            Outcome::Refuted(_) => Ok(false),
            Outcome::Unknown(left) => Err(left),
        };
    let mut walk = || -> Result<Option<(usize, usize)>, String> {
        if !holds(start)? {
            return Ok(None);
        }
        let (mut first, mut last) = (start, start);
        while first > 0 && holds(first - 1)? {
            first -= 1;
        }
        while last + 1 < samples.len() && holds(last + 1)? {
            last += 1;
        }
        Ok(Some((first, last)))
    };
    let (first, last) = match walk() {
        Ok(Some(cells)) => cells,
        Ok(None) => return LargestRange::Negative,
        Err(left) => return LargestRange::Undecided(left),
    };
    let mut end = |k: Option<usize>| {
        let found = k.and_then(|k| roots.get(k));
        found.and_then(|(k, root)| univariate::coordinate(&polys[*k], root, &mut budget.work))
    };
    let (low, high) = (end(first.checked_sub(1)), end(Some(last)));
    if (first > 0) != low.is_some() || (last < roots.len()) != high.is_some() {
        return undecided();
    }
    // The declared range has to lie between the ends.
    let order = |c: &Coordinate, x: &Rational| match c {
        Coordinate::Rational(r) => r.cmp(x),
        Coordinate::Algebraic(r) => r.compare(x),
    };
    let inside_low =
        low.as_ref().is_none_or(|c| declared.low.value().is_some_and(|x| order(c, x) != Ordering::Greater));
    let inside_high =
        high.as_ref().is_none_or(|c| declared.high.value().is_some_and(|x| order(c, x) != Ordering::Less));
    if inside_low && inside_high { LargestRange::Between(low, high) } else { LargestRange::Negative }
}
