//! The steps of the control points that a join determines.

use super::{Steps, lower};
use crate::model::Parameter;
use crate::plan::join::{self, Determined};
use crate::theorem::Theorem;

/// The control points that a join determines, as steps.
#[derive(Clone, Debug)]
pub struct JoinSteps<'a> {
    /// The determined points of each patch, in the order of the outputs.
    pub determined: Vec<Determined<'a>>,
    /// The given points that they depend on, by their positions in the theorem: [`Input::Point`](crate::plan::Input)
    /// is a position in this list.
    pub given: Vec<usize>,
    /// The scalars that they depend on: [`Input::Shape`](crate::plan::Input) is a position in this list.
    pub scalars: Vec<&'a Parameter>,
    /// From one component of the given points to the same component of the determined ones.
    pub steps: Steps,
}

impl<'a> JoinSteps<'a> {
    /// The steps of a join; `None` when its points depend on dot products, which a component does not know.
    pub fn new(theorem: &'a Theorem) -> Option<Self> {
        let determined = join::determined(theorem);
        let forms = || determined.iter().flat_map(|(_, points)| points).map(|(_, form)| *form);
        let depends = |var| forms().flat_map(|form| form.terms.values()).any(|weight| weight.depends_on(var));
        if theorem.products.iter().any(|(var, _)| depends(*var)) {
            return None;
        }
        let given = join::used(theorem, &determined);
        let scalars: Vec<&Parameter> = theorem.scalars.iter().filter(|scalar| depends(scalar.var)).collect();
        let steps = lower(&join::points(&scalars, &given, forms()));
        Some(Self { determined, given, scalars, steps })
    }
}
