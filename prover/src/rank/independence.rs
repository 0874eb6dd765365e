//! Linear independence of functions whose coefficients depend on parameters.
//!
//! The functions are the rows of a matrix of polynomials in the parameters. They are independent at a point exactly when
//! one of the maximal minors is not zero there. The matrix is cut into blocks first, by its symmetries and by the places of
//! its zeros. Of a block a few minors are enough: as long as those that are known vanish together at some point of the
//! region, either the rank drops at that point, or a minor that does not vanish there joins them.

use super::blocks::{Block, triangular};
use super::budget::Budget;
use super::certificate::Certificate;
use super::pieces::pieces;
use super::problem::{Problem, as_rational, inner, rational, simple, value};
use super::symmetry::{ChangeOfBasis, Symmetries};
use super::zeros::is_zero;
use super::{Coordinate, Decision, Relation, decide};
use crate::algebra::algebraic::Algebraic;
use crate::algebra::matrix::{
    minor, nonzero_minors, pivot_columns, polynomial_combination, vanishing_combination,
};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::{Spent, Work};
use crate::collections::list::Mapped;
use crate::collections::sort::{sort_by, sort_unique};

/// Values of some parameters, the others free.
pub type Values = Vec<(Var, Rational)>;

/// Functions as the rows of a matrix of their coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// One row for each function, all of one length.
    pub rows: Vec<Vec<Poly>>,
    /// What is known to leave the matrix unchanged: a help, no more.
    pub symmetries: Symmetries,
}

impl Table {
    /// A table without known symmetries.
    pub const fn new(rows: Vec<Vec<Poly>>) -> Self {
        Self { rows, symmetries: Vec::new() }
    }

    /// With numbers in place of some parameters.
    fn fix(&self, values: &[(Var, Rational)]) -> Vec<Vec<Poly>> {
        let at = |p: &Poly| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
        self.rows.mapped(|row| row.mapped(at))
    }
}

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

/// A part of the region on which functions are independent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The part; together with the exceptions the parts cover the region.
    pub region: Region,
    /// The bases in which the matrix is cut into blocks, if they are not the given ones.
    pub change: Option<ChangeOfBasis>,
    /// The blocks, with all rows, each of them in one block: the rows of a block are zero in the columns of the minors of all
    /// later blocks.
    pub blocks: Vec<Minors>,
}

/// Rows of a matrix with minors that do not vanish together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Minors {
    /// The rows.
    pub rows: Vec<usize>,
    /// For each minor its columns, as many as there are rows.
    pub columns: Vec<Vec<usize>>,
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

/// The most minors of a block that are taken into account.
const MAX_MINORS: usize = 12;
/// The work for the sign of a single minor that may be dispensable.
const SINGLE_MINOR: u64 = 50_000;
/// Blocks of so many rows are cut further with the help of symmetries.
const LARGE: usize = 4;

/// Decides whether the rows of a matrix are linearly independent at every point of a region that does not have the values
/// of one of the exceptions.
///
/// That the rows are dependent at the exceptions is another claim: see [`dependent`].
pub fn independent(table: &Table, except: &[Values], region: &Region, budget: &mut Budget) -> Independence {
    let mut proved = Vec::new();
    for region in pieces(&complete(&table.rows, region), except) {
        match on_piece(table, region, budget) {
            Ok(piece) => proved.push(piece),
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
fn on_piece(table: &Table, region: Region, budget: &mut Budget) -> Result<Piece, Failure> {
    // Numbers in place of parameters with a single value.
    let single = |r: &Range| r.finite().filter(|(a, b)| a == b).map(|(a, _)| a.clone());
    let single: Values = region.ranges.iter().filter_map(|(v, r)| Some((*v, single(r)?))).collect();
    let rows = table.fix(&single);
    let Some(cut) = Cut::new(&rows, &table.symmetries) else {
        let start: Values = region.ranges.mapped(|(v, r)| (*v, simple(r)));
        let combination = vanishing_combination(&at(&rows, &start), &mut budget.work);
        return Err(match combination {
            Ok(combination) => Failure::Dependent(Dependence { point: rational(start), combination }),
            Err(Spent) => spent(&rows),
        });
    };
    match cut.minors(&region, budget) {
        Ok(blocks) => return Ok(Piece { region, change: cut.change, blocks }),
        Err(Failed::Undecided(left)) => return Err(Failure::Undecided(left)),
        Err(Failed::Everywhere(point)) if as_rational(&point).is_none() => {
            return Err(Failure::Dependent(Dependence { point, combination: None }));
        }
        Err(Failed::Everywhere(point) | Failed::Point(point)) => {
            match dependence_at(&rows, point, &mut budget.work) {
                Err(Spent) => return Err(spent(&rows)),
                Ok(Some(dependence)) => return Err(Failure::Dependent(dependence)),
                Ok(None) => {}
            }
        }
    }
    // Dependent in its own columns, a block of few rows may still be independent in all of them.
    match whole(&rows).minors(&region, budget) {
        Ok(blocks) => Ok(Piece { region, change: None, blocks }),
        Err(Failed::Undecided(left)) => Err(Failure::Undecided(left)),
        Err(Failed::Everywhere(point) | Failed::Point(point)) => {
            let found = dependence_at(&rows, point, &mut budget.work).ok().flatten();
            Err(found.map_or_else(|| spent(&rows), Failure::Dependent))
        }
    }
}

/// A matrix in blocks.
pub(super) struct Cut {
    change: Option<ChangeOfBasis>,
    rows: Vec<Vec<Poly>>,
    pub(super) blocks: Vec<Block>,
}

/// All rows and columns as one block.
fn whole(rows: &[Vec<Poly>]) -> Cut {
    let block =
        Block { rows: (0..rows.len()).collect(), columns: (0..rows.first().map_or(0, Vec::len)).collect() };
    Cut { change: None, rows: rows.to_vec(), blocks: vec![block] }
}

/// The columns of minors of a block, with the certificate that they do not vanish together.
type Known = (Vec<Vec<usize>>, Certificate);

/// Why there are no minors.
enum Failed {
    /// At this point the rows of a block are dependent in the columns of the block.
    Point(Vec<(Var, Coordinate)>),
    /// At this point the rows of the whole matrix are dependent.
    Everywhere(Vec<(Var, Coordinate)>),
    Undecided(String),
}

impl Cut {
    /// By the places of the zeros, and if that leaves large blocks by symmetries; `None` when the rows are dependent whatever
    /// the parameters are.
    pub(super) fn new(rows: &[Vec<Poly>], symmetries: &Symmetries) -> Option<Self> {
        let plain = Self { change: None, rows: rows.to_vec(), blocks: triangular(rows)? };
        let large = |b: &Block| b.rows.len() > LARGE && !plain.is_constant(b);
        if !plain.blocks.iter().any(large) {
            return Some(plain);
        }
        let Some(change) = ChangeOfBasis::adapted(rows, symmetries) else { return Some(plain) };
        let rows = change.apply(rows);
        let blocks = triangular(&rows)?;
        Some(Self { change: Some(change), rows, blocks })
    }

    pub(super) fn block(&self, block: &Block) -> Vec<Vec<Poly>> {
        let row = |r: &usize| block.columns.mapped(|c| self.rows[*r][*c].clone());
        block.rows.mapped(row)
    }

    fn is_constant(&self, block: &Block) -> bool {
        let mut entries = block.rows.iter().flat_map(|r| block.columns.iter().map(|c| &self.rows[*r][*c]));
        entries.all(|p| p.is_zero() || p.as_constant().is_some())
    }

    fn minors(&self, region: &Region, budget: &mut Budget) -> Result<Vec<Minors>, Failed> {
        let mut known: Vec<(Vec<Vec<Poly>>, Known)> = Vec::new();
        let mut all = Vec::new();
        let mut square = true;
        for block in &self.blocks {
            let rows = self.block(block);
            // The rows up to here have no other columns than those up to here: if these are as many, a determinant vanishes.
            square &= block.rows.len() == block.columns.len();
            // Equal blocks, which symmetries make, have equal proofs.
            let (columns, certificate) = match known.iter().find(|(r, _)| *r == rows) {
                Some((_, known)) => known.clone(),
                None => {
                    let found = block_minors(&rows, region, budget);
                    let (columns, certificate) = found.map_err(|failed| match failed {
                        Failed::Point(point) if square => Failed::Everywhere(point),
                        other => other,
                    })?;
                    known.push((rows, (columns.clone(), certificate.clone())));
                    (columns, certificate)
                }
            };
            let columns = columns.mapped(|m| m.mapped(|c| block.columns[*c]));
            all.push(Minors { rows: block.rows.clone(), columns, certificate });
        }
        Ok(all)
    }
}

/// The functions at a point at which they may be dependent; `None` when they are not.
fn dependence_at(
    rows: &[Vec<Poly>],
    point: Vec<(Var, Coordinate)>,
    work: &mut Work,
) -> Result<Option<Dependence>, Spent> {
    if let Some(exact) = as_rational(&point) {
        let combination = vanishing_combination(&at(rows, &exact), work)?;
        return Ok(combination.map(|c| Dependence { point, combination: Some(c) }));
    }
    Ok(match irrational(rows, &point, work).ok_or(Spent)? {
        Irrational::Independent(_) => None,
        Irrational::Dependent => Some(Dependence { point, combination: None }),
    })
}

/// Minors of a block that do not vanish together, and why.
fn block_minors(rows: &[Vec<Poly>], region: &Region, budget: &mut Budget) -> Result<Known, Failed> {
    let spent = || {
        Failed::Undecided(format!("the budget is spent on the minors of a table of {} functions", rows.len()))
    };
    let start: Values = region.ranges.mapped(|(v, r)| (*v, simple(r)));
    let numbers = at(rows, &start);
    let pivots = pivot_columns(&numbers, &mut budget.work).ok_or_else(spent)?;
    if pivots.len() < rows.len() {
        return Err(Failed::Point(rational(start)));
    }
    if rows.iter().flatten().all(|p| p.is_zero() || p.as_constant().is_some()) {
        return Ok((vec![pivots], Certificate::Constant));
    }
    let choices = nonzero_minors(rows, &mut budget.work).ok_or_else(spent)?;
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
    let first = choices.into_iter().next().ok_or_else(spent)?;
    let mut columns = vec![first.columns];
    let mut minors = vec![first.value];
    loop {
        let claim = positive_claim(&minors, &start);
        let point = match decide(&claim, Relation::Positive, region, budget) {
            Decision::Proved(proof) => return Ok((columns, proof.certificate)),
            Decision::Undecided(left) => {
                return Err(Failed::Undecided(format!("minors of the coefficients: {left}")));
            }
            Decision::Refuted(witness) if !witness.value.is_zero() => {
                // A minor that changes its sign: look at its zeros.
                let square = &claim * &claim;
                match decide(&square, Relation::Positive, region, budget) {
                    Decision::Refuted(witness) => witness.point,
                    _ => return Err(spent()),
                }
            }
            Decision::Refuted(witness) => witness.point,
        };
        let more = match as_rational(&point) {
            Some(exact) => pivot_columns(&at(rows, &exact), &mut budget.work).ok_or_else(spent)?,
            None => match irrational(rows, &point, &mut budget.work).ok_or_else(spent)? {
                Irrational::Independent(columns) => columns,
                Irrational::Dependent => Vec::new(),
            },
        };
        if more.len() < rows.len() {
            return Err(Failed::Point(point));
        }
        if columns.len() == MAX_MINORS || columns.contains(&more) {
            return Err(spent());
        }
        minors.push(minor(rows, &more, &mut budget.work).ok_or_else(spent)?);
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
    rows.mapped(|row| row.mapped(|p| value(p, point)))
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
    let columns = largest_pivots(at(rows, &near), work)?;
    let candidate = minor(&exact, &columns, work)?;
    if !is_zero(&candidate, &algebraic, work)? {
        return Some(Irrational::Independent(columns));
    }
    if rows.first().is_some_and(|r| r.len() == rows.len()) {
        // There is no other minor.
        return Some(Irrational::Dependent);
    }
    // The sum of the squares of all minors is the determinant of the matrix times its transpose (Cauchy–Binet).
    let product =
        |a: &Vec<Poly>, b: &Vec<Poly>| a.iter().zip(b).fold(Poly::zero(), |s, (x, y)| &s + &(x * y));
    let gram: Vec<Vec<Poly>> = exact.mapped(|a| exact.mapped(|b| product(a, b)));
    let all: Vec<usize> = (0..rows.len()).collect();
    let determinant = minor(&gram, &all, work)?;
    is_zero(&determinant, &algebraic, work)?.then_some(Irrational::Dependent)
}

/// The columns of the pivots when always the entry with the greatest absolute value is taken; `None` when the work is spent.
fn largest_pivots(mut rows: Vec<Vec<Rational>>, work: &mut Work) -> Option<Vec<usize>> {
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
                work.spend_fractions(p.bits().max(x.bits()) + factor.bits())?;
                *x -= &(p * &factor);
            }
        }
        columns.push(j);
    }
    sort_unique(&mut columns);
    Some(columns)
}

/// Whether the rows are dependent wherever some parameters have the given values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Exception {
    /// The rows are dependent: polynomials cᵢ in the other parameters, without common factor, with Σ cᵢ fᵢ = 0.
    Dependent(Vec<Poly>),
    /// They are independent at this point of the region, which has the values.
    Independent(Vec<(Var, Rational)>),
    /// The region contains no point with these values.
    Outside,
    /// The budget is spent.
    Undecided(String),
}

/// Decides whether values of some parameters are an exception from independence on a region.
pub fn dependent(table: &Table, values: &Values, region: &Region, budget: &mut Budget) -> Exception {
    let mut region = complete(&table.rows, region);
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
    combination.iter().map(|p| p.scale(&factor)).collect()
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

/// Whether the rows are dependent at a point with a coordinate for each parameter; `None` when the work is spent.
#[cfg(any(test, feature = "tools"))]
pub fn dependent_at(table: &Table, point: &[(Var, Coordinate)], budget: &mut Budget) -> Option<bool> {
    let rows = &table.rows;
    if let Some(exact) = as_rational(&point.to_vec()) {
        return Some(vanishing_combination(&at(rows, &exact), &mut budget.work).ok()?.is_some());
    }
    let Some(cut) = Cut::new(rows, &table.symmetries) else { return Some(true) };
    let mut square = true;
    for block in &cut.blocks {
        square &= block.rows.len() == block.columns.len();
        match irrational(&cut.block(block), point, &mut budget.work)? {
            Irrational::Independent(_) => {}
            Irrational::Dependent if square => return Some(true),
            Irrational::Dependent => {
                let all = irrational(rows, point, &mut budget.work)?;
                return Some(matches!(all, Irrational::Dependent));
            }
        }
    }
    Some(false)
}
