//! Counterexamples to what is said under premises: among points, on the faces of the box, and on the border of a
//! premise or where it is an equation.

use basis_kernel::Statement;
use basis_prover::Counterexample;
use std::rc::Rc;

use super::search::{Search, among_points};
use super::{equalities, faces, touching};
use crate::algebra::work::Work;

/// A counterexample to an equation, or to a statement about a sign, under premises.
pub(in crate::state) fn counterexample(statement: &Statement, work: &mut Work) -> Option<Counterexample> {
    let found = among_points(statement, work);
    let statement = Rc::new(statement.clone());
    let near = match found {
        Some(Search::Found(found)) => return Some(*found),
        Some(Search::Lowest(near)) => near,
        None => return equalities::counterexample(&statement, work),
    };
    if let Some(found) = equalities::counterexample(&statement, work) {
        return Some(found);
    }
    faces::counterexample(&statement, work).or_else(|| touching::counterexample(&statement, &near, work))
}
