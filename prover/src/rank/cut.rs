//! A matrix in blocks, and minors of a block that do not vanish together.

use basis_kernel::{ChangeOfBasis, Minors, Relation, SignProof, Signed, Values};

use super::blocks::{Block, triangular};
use super::irrational::{Irrational, irrational};
use super::symmetry::{self, Symmetries};
use super::table::at;
use crate::algebra::matrix::{determinant, minor, nonzero_minors, pivot_columns};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::coordinate::Coordinate;
use crate::sign::problem::{as_rational, rational, simple, value};
use crate::sign::{Found, search};

/// The most minors of a block that are taken into account.
const MAX_MINORS: usize = 12;
/// The work for the sign of a single minor that may be dispensable.
const SINGLE_MINOR: u64 = 50_000;
/// Blocks of this number of rows are cut further with the help of symmetries.
const LARGE: usize = 4;

/// A matrix in blocks.
pub(super) struct Cut {
    pub(super) change: Option<ChangeOfBasis>,
    pub(super) rows: Vec<Vec<Poly>>,
    pub(super) blocks: Vec<Block>,
}

/// All rows and columns as one block.
pub(super) fn whole(rows: &[Vec<Poly>]) -> Cut {
    let block =
        Block { rows: (0..rows.len()).listed(), columns: (0..rows.first().map_or(0, Vec::len)).listed() };
    Cut { change: None, rows: rows.to_vec(), blocks: vec![block] }
}

/// The columns of minors of a block, with the proof that they do not vanish together.
type Known = (Vec<Vec<usize>>, Signed);

/// Why there are no minors.
pub(super) enum Failed {
    /// At this point the rows of a block are dependent in the columns of the block.
    Point(Vec<(Var, Coordinate)>),
    /// At this point the rows of the whole matrix are dependent.
    Everywhere(Vec<(Var, Coordinate)>),
    Undecided(String),
}

impl Cut {
    /// By the places of the zeros, and if that leaves large blocks by symmetries; `None` when the rows are dependent
    /// whatever the parameters are.
    pub(super) fn new(rows: &[Vec<Poly>], symmetries: &Symmetries) -> Option<Self> {
        let plain = Self { change: None, rows: rows.to_vec(), blocks: triangular(rows)? };
        let large = |b: &Block| b.rows.len() > LARGE && !plain.is_constant(b);
        if !plain.blocks.iter().any(large) {
            return Some(plain);
        }
        let Some(change) = symmetry::adapted(rows, symmetries) else { return Some(plain) };
        let rows = symmetry::apply(&change, rows);
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

    /// Minors of all blocks, and why they do not vanish together.
    pub(super) fn minors(&self, region: &Region, budget: &mut Budget) -> Result<Vec<Minors>, Failed> {
        let mut known: Vec<(Vec<Vec<Poly>>, Known)> = Vec::new();
        let mut all = Vec::new();
        let mut square = true;
        for block in &self.blocks {
            let rows = self.block(block);
            // The rows up to here have no other columns than those up to here: if these are as many, a determinant
            // vanishes.
            square &= block.rows.len() == block.columns.len();
            // Equal blocks, which symmetries make, have equal proofs.
            let (columns, sign) = match known.iter().find(|(r, _)| *r == rows) {
                Some((_, known)) => known.clone(),
                None => {
                    let found = block_minors(&rows, region, budget);
                    let (columns, sign) = found.map_err(|failed| match failed {
                        Failed::Point(point) if square => Failed::Everywhere(point),
                        other => other,
                    })?;
                    known.push((rows, (columns.clone(), sign.clone())));
                    (columns, sign)
                }
            };
            let columns = columns.mapped(|m| m.mapped(|c| block.columns[*c]));
            all.push(Minors { rows: block.rows.clone(), columns, sign });
        }
        Ok(all)
    }
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
        let sign = signed(&numbers, &pivots, SignProof::direct(), &mut budget.work).ok_or_else(spent)?;
        return Ok((vec![pivots], sign));
    }
    let choices = nonzero_minors(rows, &mut budget.work).ok_or_else(spent)?;
    for choice in choices.iter().take(MAX_MINORS) {
        // Often one of them vanishes nowhere.
        let claim = positive_claim(core::slice::from_ref(&choice.value), &start, &mut budget.work)
            .ok_or_else(spent)?;
        let mut part = budget.take(SINGLE_MINOR);
        let found = search(&claim, Relation::Positive, region, &mut part);
        budget.put_back(&part);
        if let Found::Proof(_, proof) = found {
            let sign = signed(&numbers, &choice.columns, proof, &mut budget.work).ok_or_else(spent)?;
            return Ok((vec![choice.columns.clone()], sign));
        }
    }
    let first = choices.into_iter().next().ok_or_else(spent)?;
    let mut columns = vec![first.columns];
    let mut minors = vec![first.value];
    loop {
        let claim = positive_claim(&minors, &start, &mut budget.work).ok_or_else(spent)?;
        let point = match search(&claim, Relation::Positive, region, budget) {
            Found::Proof(_, proof) => {
                let sign = match &columns[..] {
                    [only] => signed(&numbers, only, proof, &mut budget.work).ok_or_else(spent)?,
                    _ => Signed::Positive(proof),
                };
                return Ok((columns, sign));
            }
            Found::Nothing(left) => {
                return Err(Failed::Undecided(format!("minors of the coefficients: {left}")));
            }
            Found::Point(point) if is_negative(&claim, &point) => {
                // A minor that changes its sign: look at its zeros.
                budget.work.spend_product(&claim, &claim).ok_or_else(spent)?;
                let square = &claim * &claim;
                match search(&square, Relation::Positive, region, budget) {
                    Found::Point(point) => point,
                    _ => return Err(spent()),
                }
            }
            Found::Point(point) => point,
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

/// Whether a polynomial is negative at a point with rational coordinates.
fn is_negative(p: &Poly, point: &Vec<(Var, Coordinate)>) -> bool {
    as_rational(point).is_some_and(|exact| value(p, &exact).is_negative())
}

/// A proof that the minor of some columns, or its negative if it is negative at a point with this matrix, is positive;
/// `None` when the work is spent.
fn signed(numbers: &[Vec<Rational>], columns: &[usize], proof: SignProof, work: &mut Work) -> Option<Signed> {
    let square = numbers.mapped(|row| columns.mapped(|c| row[*c].clone()));
    let negative = determinant(square, work)?.is_negative();
    Some(if negative { Signed::Negative(proof) } else { Signed::Positive(proof) })
}

/// The polynomial whose positivity shows that minors do not vanish together: a single one with the sign that it has at
/// a point, or the sum of the squares; `None` when the work is spent.
pub(super) fn positive_claim(minors: &[Poly], at: &[(Var, Rational)], work: &mut Work) -> Option<Poly> {
    if let [only] = minors {
        return Some(if value(only, at).is_negative() { -only } else { only.clone() });
    }
    let mut sum = Poly::zero();
    for m in minors {
        work.spend_product(m, m)?;
        sum = &sum + &(m * m);
    }
    Some(sum)
}
