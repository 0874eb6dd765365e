//! Values of parameters at which rows are dependent.

use basis_kernel::Values;

use super::table::{Table, at, complete};
use crate::algebra::matrix::{nonzero_minors, pivot_columns, polynomial_combination};
use crate::algebra::poly::Poly;
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_by;
use crate::sign::problem::{Problem, inner, simple};

/// Whether the rows are dependent wherever some parameters have the given values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Exception {
    /// The rows are dependent: polynomials cᵢ in the other parameters, without common factor, with Σ cᵢ fᵢ = 0.
    Dependent(Vec<Poly>),
    /// They are independent at this point of the region, which has the values.
    Independent(Values),
    /// The region contains no point with these values.
    Outside,
    /// The budget is spent.
    Undecided(String),
}

/// Decides whether values of some parameters are an exception from independence on a region.
pub(super) fn dependent(
    table: Table<'_>,
    values: &Values,
    region: &Region,
    budget: &mut Budget,
) -> Exception {
    let mut region = complete(table.rows, region);
    for (v, x) in values {
        match region.ranges.iter_mut().find(|(w, _)| w == v) {
            Some((_, r)) if r.contains(x) => *r = Range::closed(x.clone(), x.clone()),
            Some(_) => return Exception::Outside,
            None => region.ranges.push((*v, Range::closed(x.clone(), x.clone()))),
        }
    }
    sort_by(&mut region.ranges, |a, b| a.0.cmp(&b.0));
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return Exception::Outside;
    }
    let fixed = table.fix(values);
    match generic(&fixed, &region, &mut budget.work) {
        Some(Generic::Independent(point)) => Exception::Independent(point),
        Some(Generic::Dependent(combination)) => Exception::Dependent(in_lowest_terms(&combination)),
        None => Exception::Undecided(String::from("the budget is spent on a combination of the functions")),
    }
}

/// The multiple of a combination that has whole coefficients without a common factor, the leading one of its first
/// polynomial positive.
fn in_lowest_terms(combination: &[Poly]) -> Vec<Poly> {
    let content = combination.iter().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
    let lead = combination.iter().find_map(|p| p.leading_term().map(|(_, c)| c.clone()));
    let factor = content.recip().unwrap_or(Rational::ONE);
    let factor = if lead.is_some_and(|c| c.is_negative()) { -factor } else { factor };
    combination.iter().map(|p| p.scale(&factor)).listed()
}

/// Whether rows are independent at some point of a region.
pub(super) enum Generic {
    /// At this one.
    Independent(Values),
    /// Nowhere, by this combination.
    Dependent(Vec<Poly>),
}

/// Whether the rows are independent at some point of a region that is not empty; `None` when the work is spent.
pub(super) fn generic(rows: &[Vec<Poly>], region: &Region, work: &mut Work) -> Option<Generic> {
    // If they are at all, nearly every point will do.
    for k in 0..3 {
        let number = |r: &Range| match r.finite() {
            Some((a, b)) if a == b => a.clone(),
            _ => inner(r, k + 1).pop().unwrap_or_else(|| simple(r)),
        };
        let point: Values = region.ranges.mapped(|(v, r)| (*v, number(r)));
        if pivot_columns(&at(rows, &point), work)?.len() == rows.len() {
            return Some(Generic::Independent(point));
        }
    }
    let combination = polynomial_combination(rows, work)?;
    if !combination.is_empty() {
        return Some(Generic::Dependent(combination));
    }
    let minor = nonzero_minors(rows, work)?.into_iter().next()?;
    let mut free = region.clone();
    free.ranges.retain(|(_, r)| r.finite().is_none_or(|(a, b)| a != b));
    let problem = Problem::new(&minor.value, &free);
    let mut point = problem.nonzero_point(&problem.poly)?;
    for (v, r) in &region.ranges {
        if !point.iter().any(|(w, _)| w == v) {
            point.push((*v, simple(r)));
        }
    }
    sort_by(&mut point, |a, b| a.0.cmp(&b.0));
    Some(Generic::Independent(point))
}
