//! The point at which a family is evaluated.

use std::rc::Rc;

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};

use super::assign;
use crate::args::Assignment;
use crate::output::error;

/// Of a family on several spans the first one that contains the value of the domain variable.
pub(super) fn on_span(family: &Rc<Family>, at: &[Assignment]) -> Rc<Family> {
    let holds = |piece: &&Rc<Family>| {
        let [variable] = piece.domain.as_slice() else { return false };
        let given = at.iter().find(|a| a.name == variable.name);
        given.is_some_and(|a| variable.range.contains(&a.value))
    };
    family.pieces.iter().find(holds).or(family.pieces.first()).unwrap_or(family).clone()
}

/// A value for each shape parameter and each domain variable.
#[derive(Debug)]
pub(super) struct Point {
    /// By variable.
    values: Vec<Rational>,
}

impl Point {
    /// The point that the options give.
    ///
    /// # Errors
    /// As for [`assign::values`].
    pub(super) fn new(
        family: &Family,
        shapes: &[Assignment],
        at: &[Assignment],
    ) -> Result<Self, Vec<Diagnostic>> {
        assign::values(family, shapes, at).map(|values| Self { values })
    }

    /// The value of a variable.
    pub(super) fn value(&self, var: Var) -> &Rational {
        &self.values[var.0]
    }

    /// All values, by variable.
    pub(super) fn values(&self) -> &[Rational] {
        &self.values
    }

    /// The functions with the shape values put in: quotients of polynomials in the domain variables.
    ///
    /// # Errors
    /// A denominator is zero at the point.
    pub(super) fn bind(&self, family: &Family) -> Result<Vec<Fraction>, Diagnostic> {
        let bound = |p: &Poly| family.shapes.iter().fold(p.clone(), |p, s| p.at(s.var, self.value(s.var)));
        let functions = family.functions.iter().enumerate().map(|(k, function)| {
            let zero = || {
                let shown = function.value.denom().display(&family.names);
                error(format!(
                    "the denominator of `{}` is zero at {}",
                    family.function_label(k),
                    self.describe(family.shapes.iter().chain(family.domain_variables()))
                ))
                .note(format!("the denominator is `{shown}`"))
                .help("choose other values")
            };
            let value = Fraction::new(bound(function.value.numer()), bound(function.value.denom()));
            value.filter(|value| value.eval(&self.values).is_some()).ok_or_else(zero)
        });
        functions.collect()
    }

    /// The values of some parameters, such as `λ = 1/2, t = 1/3`.
    pub(super) fn describe<'p>(&self, parameters: impl Iterator<Item = &'p Parameter>) -> String {
        let parts: Vec<String> = parameters.map(|p| format!("{} = {}", p.name, self.value(p.var))).collect();
        parts.join(", ")
    }
}
