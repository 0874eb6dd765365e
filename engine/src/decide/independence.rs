//! Linear independence of functions whose coefficients depend on parameters.
//!
//! The functions are the rows of a matrix of polynomials in the parameters. They are independent at a point exactly when
//! one of the maximal minors is not zero there. A few minors are enough: as long as those that are known vanish together
//! at some point of the region, either the rank drops at that point, or a minor that does not vanish there joins them.

use super::budget::Budget;
use super::certificate::Certificate;
use super::pieces::pieces;
use super::problem::{Problem, as_rational, rational, simple, value};
use super::zeros::is_zero;
use super::{Coordinate, Decision, Relation, decide};
use crate::algebra::algebraic::Algebraic;
use crate::algebra::matrix::{
    minor, nonzero_minors, pivot_columns, polynomial_combination, vanishing_combination,
};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::sorting::sort_by;

/// Values of some parameters, the others free.
pub type Values = Vec<(Var, Rational)>;

/// What is known about the independence of functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Independence {
    /// They are independent at all points of the region but the exceptions.
    Proved(Vec<Piece>),
    /// They are dependent at a point that is no exception.
    Refuted(Dependence),
    /// The budget is spent; what is left to decide, for people.
    Undecided(String),
}

/// A part of the region with minors that do not vanish together on it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The part; together with the exceptions the parts cover the region.
    pub region: Region,
    /// The columns of the minors.
    pub minors: Vec<Vec<usize>>,
    /// For a single minor: that it or its negative is positive on the part; for several: that the sum of their squares is.
    pub certificate: Certificate,
}

/// A point at which functions are dependent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dependence {
    /// A coordinate for each parameter, in increasing order.
    pub point: Vec<(Var, Coordinate)>,
    /// Whole numbers cᵢ without common factor with Σ cᵢ fᵢ = 0 there; `None` at an irrational point.
    pub combination: Option<Vec<Rational>>,
}

/// The most minors that are taken into account.
const MAX_MINORS: usize = 12;
/// The work for the sign of a single minor that may be dispensable.
const SINGLE_MINOR: u64 = 50_000;

/// Decides whether the rows of a matrix are linearly independent at every point of a region that does not have the values
/// of one of the exceptions.
///
/// That the rows are dependent at the exceptions is another claim: see [`dependent`].
pub fn independent(
    rows: &[Vec<Poly>],
    except: &[Values],
    region: &Region,
    budget: &mut Budget,
) -> Independence {
    let mut proved = Vec::new();
    for region in pieces(&complete(rows, region), except) {
        match on_piece(rows, &region, budget) {
            Ok((minors, certificate)) => proved.push(Piece { region, minors, certificate }),
            Err(Failure::Dependent(dependence)) => return Independence::Refuted(dependence),
            Err(Failure::Undecided(left)) => return Independence::Undecided(left),
        }
    }
    Independence::Proved(proved)
}

/// The region with all real numbers for the parameters that it says nothing of.
pub(super) fn complete(rows: &[Vec<Poly>], region: &Region) -> Region {
    let mut region = region.clone();
    for var in rows.iter().flatten().flat_map(Poly::variables) {
        if !region.ranges.iter().any(|(v, _)| *v == var) {
            region.ranges.push((var, Range::all()));
        }
    }
    sort_by(&mut region.ranges, |a, b| a.0.cmp(&b.0));
    region
}

enum Failure {
    Dependent(Dependence),
    Undecided(String),
}

fn spent(rows: &[Vec<Poly>]) -> Failure {
    Failure::Undecided(format!("the budget is spent on the minors of a table of {} functions", rows.len()))
}

/// Proves independence on a region that is not empty.
fn on_piece(
    rows: &[Vec<Poly>],
    region: &Region,
    budget: &mut Budget,
) -> Result<(Vec<Vec<usize>>, Certificate), Failure> {
    let start: Values = region.ranges.iter().map(|(v, r)| (*v, simple(r))).collect();
    if let Some(combination) = vanishing_combination(&at(rows, &start)) {
        return Err(Failure::Dependent(Dependence {
            point: rational(start),
            combination: Some(combination),
        }));
    }
    // Numbers in place of parameters with a single value; then the columns of the most convenient minor.
    let single: Values = region
        .ranges
        .iter()
        .filter_map(|(v, r)| r.finite().filter(|(a, b)| a == b).map(|(a, _)| (*v, a.clone())))
        .collect();
    let rows: Vec<Vec<Poly>> = rows
        .iter()
        .map(|row| row.iter().map(|p| single.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x))).collect())
        .collect();
    let choices = nonzero_minors(&rows, &mut budget.work).ok_or_else(|| spent(&rows))?;
    for choice in choices.iter().take(MAX_MINORS) {
        // Often one of them vanishes nowhere.
        let claim = positive_claim(core::slice::from_ref(&choice.value), &start);
        let mut part = budget.take(SINGLE_MINOR);
        let decision = decide(&claim, Relation::Positive, region, &mut part);
        budget.put_back(&part);
        if let Decision::Proved(proof) = decision {
            return Ok((vec![choice.columns.clone()], proof.certificate));
        }
    }
    let Some(first) = choices.into_iter().next() else { return Err(spent(&rows)) };
    let mut columns = vec![first.columns];
    let mut minors = vec![first.value];
    loop {
        let claim = positive_claim(&minors, &start);
        let point = match decide(&claim, Relation::Positive, region, budget) {
            Decision::Proved(proof) => return Ok((columns, proof.certificate)),
            Decision::Undecided(left) => {
                return Err(Failure::Undecided(format!("minors of the coefficients: {left}")));
            }
            Decision::Refuted(witness) if !witness.value.is_zero() => {
                // A minor that changes its sign: look at its zeros.
                let square = &claim * &claim;
                match decide(&square, Relation::Positive, region, budget) {
                    Decision::Refuted(witness) => witness.point,
                    _ => return Err(spent(&rows)),
                }
            }
            Decision::Refuted(witness) => witness.point,
        };
        let more = match as_rational(&point) {
            Some(exact) => match vanishing_combination(&at(&rows, &exact)) {
                Some(combination) => {
                    return Err(Failure::Dependent(Dependence { point, combination: Some(combination) }));
                }
                None => pivot_columns(&at(&rows, &exact)),
            },
            None => match irrational(&rows, &point, &mut budget.work).ok_or_else(|| spent(&rows))? {
                Irrational::Independent(columns) => columns,
                Irrational::Dependent => {
                    return Err(Failure::Dependent(Dependence { point, combination: None }));
                }
            },
        };
        if columns.len() == MAX_MINORS || columns.contains(&more) {
            return Err(spent(&rows));
        }
        minors.push(minor(&rows, &more, &mut budget.work).ok_or_else(|| spent(&rows))?);
        columns.push(more);
    }
}

/// The polynomial whose positivity shows that minors do not vanish together: a single one with the sign that it has at a
/// point, or the sum of the squares.
pub(super) fn positive_claim(minors: &[Poly], at: &[(Var, Rational)]) -> Poly {
    match minors {
        [only] if value(only, at).is_negative() => -only,
        [only] => only.clone(),
        _ => minors.iter().fold(Poly::zero(), |sum, m| &sum + &(m * m)),
    }
}

/// The matrix at a rational point.
pub(super) fn at(rows: &[Vec<Poly>], point: &[(Var, Rational)]) -> Vec<Vec<Rational>> {
    rows.iter().map(|row| row.iter().map(|p| value(p, point)).collect()).collect()
}

/// The rank at a point with irrational coordinates.
pub(super) enum Irrational {
    /// The minor of these columns is not zero.
    Independent(Vec<usize>),
    /// All minors are zero.
    Dependent,
}

/// Whether the rows are independent at a point with irrational coordinates; `None` when the work is spent.
pub(super) fn irrational(
    rows: &[Vec<Poly>],
    point: &[(Var, Coordinate)],
    work: &mut Work,
) -> Option<Irrational> {
    let mut near = Vec::new();
    let mut exact = rows.to_vec();
    let mut algebraic: Vec<(Var, Algebraic)> = Vec::new();
    for (var, c) in point {
        match c {
            Coordinate::Rational(x) => {
                near.push((*var, x.clone()));
                for p in exact.iter_mut().flatten() {
                    *p = p.at(*var, x);
                }
            }
            Coordinate::Algebraic(x) => {
                let mut x = x.clone();
                x.refine_below(&Rational::new(1, 1 << 40), work)?;
                near.push((*var, x.low().clone()));
                algebraic.push((*var, x));
            }
        }
    }
    // Near to the point the largest pivots are those that do not vanish at the point itself.
    let columns = largest_pivots(at(rows, &near));
    let candidate = minor(&exact, &columns, work)?;
    if !is_zero(&candidate, &algebraic, work)? {
        return Some(Irrational::Independent(columns));
    }
    // The sum of the squares of all minors is the determinant of the matrix times its transpose (Cauchy–Binet).
    let product =
        |a: &Vec<Poly>, b: &Vec<Poly>| a.iter().zip(b).fold(Poly::zero(), |s, (x, y)| &s + &(x * y));
    let gram: Vec<Vec<Poly>> = exact.iter().map(|a| exact.iter().map(|b| product(a, b)).collect()).collect();
    let all: Vec<usize> = (0..rows.len()).collect();
    let determinant = minor(&gram, &all, work)?;
    is_zero(&determinant, &algebraic, work)?.then_some(Irrational::Dependent)
}

/// The columns of the pivots when always the entry with the greatest absolute value is taken.
fn largest_pivots(mut rows: Vec<Vec<Rational>>) -> Vec<usize> {
    let mut columns = Vec::new();
    while !rows.is_empty() {
        let entries =
            rows.iter().enumerate().flat_map(|(i, row)| row.iter().enumerate().map(move |(j, x)| (i, j, x)));
        let free = entries.filter(|(_, j, x)| !x.is_zero() && !columns.contains(j));
        let Some((i, j, _)) = free.max_by_key(|(_, _, x)| x.abs()) else { break };
        let pivot = rows.swap_remove(i);
        for row in &mut rows {
            let factor = &row[j] / &pivot[j];
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x -= &(p * &factor);
            }
        }
        columns.push(j);
    }
    columns.sort_unstable();
    columns
}

/// Whether the rows are dependent wherever some parameters have the given values; where not, a point of the region with
/// these values at which they are independent, or the region when it contains no such point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Exception {
    /// The rows are dependent: polynomials cᵢ in the other parameters, without common factor, with Σ cᵢ fᵢ = 0.
    Dependent(Vec<Poly>),
    /// They are independent at this point.
    Independent(Vec<(Var, Rational)>),
    /// The region contains no point with these values.
    Outside,
    /// The budget is spent.
    Undecided(String),
}

/// Decides whether values of some parameters are an exception from independence on a region.
pub fn dependent(rows: &[Vec<Poly>], values: &Values, region: &Region, budget: &mut Budget) -> Exception {
    let region = complete(rows, region);
    if values.iter().any(|(v, x)| !region.range(*v).contains(x)) {
        return Exception::Outside;
    }
    let fixed: Vec<Vec<Poly>> = rows
        .iter()
        .map(|row| row.iter().map(|p| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x))).collect())
        .collect();
    let spent =
        || Exception::Undecided(String::from("the budget is spent on a combination of the functions"));
    let Some(combination) = polynomial_combination(&fixed, &mut budget.work) else { return spent() };
    if !combination.is_empty() {
        return Exception::Dependent(combination);
    }
    // Independent in general, and so at most points: at one where a minor is not zero.
    let Some(minor) = nonzero_minors(&fixed, &mut budget.work).and_then(|m| m.into_iter().next()) else {
        return spent();
    };
    let mut free = region.clone();
    free.ranges.retain(|(v, _)| values.iter().all(|(w, _)| w != v));
    let problem = Problem::new(&minor.value, &free);
    let Some(mut point) = problem.nonzero_point(&problem.poly) else {
        return Exception::Undecided(String::from(
            "the functions are dependent on a part of the region only",
        ));
    };
    point.extend(values.iter().cloned());
    for (v, r) in &region.ranges {
        if !point.iter().any(|(w, _)| w == v) {
            point.push((*v, simple(r)));
        }
    }
    sort_by(&mut point, |a, b| a.0.cmp(&b.0));
    Exception::Independent(point)
}
