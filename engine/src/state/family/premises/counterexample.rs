//! Counterexamples to what is said under premises: among points, on the faces of the box, and on the border of a premise.

use basis_kernel::Statement;
use basis_prover::Counterexample;
use std::rc::Rc;

use super::search::{Search, among_points};
use super::{faces, touching};
use crate::algebra::work::Work;

/// A counterexample to an equation, or to a statement about a sign, under premises.
pub(in crate::state) fn counterexample(statement: &Statement, work: &mut Work) -> Option<Counterexample> {
    let near = match among_points(statement, work)? {
        Search::Found(found) => return Some(*found),
        Search::Lowest(near) => near,
    };
    let statement = Rc::new(statement.clone());
    faces::counterexample(&statement, work).or_else(|| touching::counterexample(&statement, &near, work))
}
