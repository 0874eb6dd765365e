//! Independence on a box but for exceptions, part by part.

use basis_kernel::{Piece, Rank, Values, pieces};

use super::cut::{Cut, Failed, whole};
use super::exception::{Exception, dependent};
use super::irrational::{Irrational, irrational};
use super::table::{Table, at, complete};
use crate::algebra::matrix::vanishing_combination;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::work::{Spent, Work};
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::coordinate::Coordinate;
use crate::sign::problem::{as_rational, rational, simple};

/// The most parts into which exceptions cut a region.
const MAX_PIECES: usize = 1000;

/// How the search for the independence of functions ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Independence {
    /// They are independent at all points of the region but the exceptions, and dependent at these.
    Proved(Rank),
    /// They are dependent at this point, which is no exception.
    Dependent(Vec<(Var, Coordinate)>),
    /// The exception with this number is not one: they are independent at this point, which has its values.
    NoException(usize, Values),
    /// The budget is spent; what is left to decide, in words.
    Undecided(String),
}

/// Decides whether the rows of a matrix are linearly independent at every point of a region that does not have the
/// values of one of the exceptions, and dependent at all others. Exceptions outside of the region play no part.
pub fn independent(table: Table<'_>, except: &[Values], region: &Region, budget: u32) -> Independence {
    let mut exceptions = Vec::new();
    for (number, values) in except.iter().enumerate() {
        match dependent(table, values, region, &mut Budget::scaled(budget)) {
            Exception::Dependent(combination) => exceptions.push(combination),
            Exception::Independent(point) => return Independence::NoException(number, point),
            Exception::Outside => exceptions.push(Vec::new()),
            Exception::Undecided(left) => return Independence::Undecided(left),
        }
    }
    let Some(parts) = pieces(&complete(table.rows, region), except, MAX_PIECES) else {
        return Independence::Undecided(String::from("the exceptions cut the ranges into too many parts"));
    };
    let budget = &mut Budget::scaled(budget);
    let mut proved = Vec::new();
    for region in parts {
        match on_piece(table, &region, budget) {
            Ok(piece) => proved.push(piece),
            Err(Failure::Dependent(point)) => return Independence::Dependent(point),
            Err(Failure::Undecided(left)) => return Independence::Undecided(left),
        }
    }
    Independence::Proved(Rank { pieces: proved, exceptions })
}

enum Failure {
    Dependent(Vec<(Var, Coordinate)>),
    Undecided(String),
}

fn spent(rows: &[Vec<Poly>]) -> Failure {
    Failure::Undecided(format!("the budget is spent on the minors of a table of {} functions", rows.len()))
}

/// Proves independence on a region that is not empty.
fn on_piece(table: Table<'_>, region: &Region, budget: &mut Budget) -> Result<Piece, Failure> {
    // Numbers in place of parameters with a single value.
    let single = |r: &Range| r.finite().filter(|(a, b)| a == b).map(|(a, _)| a.clone());
    let single: Values = region.ranges.iter().filter_map(|(v, r)| Some((*v, single(r)?))).listed();
    let rows = table.fix(&single);
    let Some(cut) = Cut::new(&rows, table.symmetries) else {
        let start: Values = region.ranges.mapped(|(v, r)| (*v, simple(r)));
        return Err(Failure::Dependent(rational(start)));
    };
    match cut.minors(region, budget) {
        Ok(blocks) => return Ok(Piece { change: cut.change, blocks }),
        Err(Failed::Undecided(left)) => return Err(Failure::Undecided(left)),
        Err(Failed::Everywhere(point)) if as_rational(&point).is_none() => {
            return Err(Failure::Dependent(point));
        }
        Err(Failed::Everywhere(point) | Failed::Point(point)) => {
            match is_dependent(&rows, &point, &mut budget.work) {
                Err(Spent) => return Err(spent(&rows)),
                Ok(true) => return Err(Failure::Dependent(point)),
                Ok(false) => {}
            }
        }
    }
    // Dependent in its own columns, a block of few rows may still be independent in all of them.
    match whole(&rows).minors(region, budget) {
        Ok(blocks) => Ok(Piece { change: None, blocks }),
        Err(Failed::Undecided(left)) => Err(Failure::Undecided(left)),
        Err(Failed::Everywhere(point) | Failed::Point(point)) => {
            match is_dependent(&rows, &point, &mut budget.work) {
                Ok(true) => Err(Failure::Dependent(point)),
                Ok(false) | Err(Spent) => Err(spent(&rows)),
            }
        }
    }
}

/// Whether the rows are dependent at a point.
///
/// # Errors
/// When the work is spent.
fn is_dependent(rows: &[Vec<Poly>], point: &Vec<(Var, Coordinate)>, work: &mut Work) -> Result<bool, Spent> {
    if let Some(exact) = as_rational(point) {
        return Ok(vanishing_combination(&at(rows, &exact), work)?.is_some());
    }
    match irrational(rows, point, work).ok_or(Spent)? {
        Irrational::Independent(_) => Ok(false),
        Irrational::Dependent => Ok(true),
    }
}
