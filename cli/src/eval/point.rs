//! The point at which a family is evaluated.

use basis_engine::algebra::poly::{Poly, PolyExt, Var};
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};

use super::assign;
use crate::args::Assignment;
use crate::output::error;

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

    /// The functions with the shape values put in: polynomials in the domain variables.
    ///
    /// # Errors
    /// A denominator is zero at the shape values.
    pub(super) fn bind(&self, family: &Family) -> Result<Vec<Poly>, Diagnostic> {
        let bound = |p: &Poly| family.shapes.iter().fold(p.clone(), |p, s| p.at(s.var, self.value(s.var)));
        let functions = family.functions.iter().enumerate().map(|(k, function)| {
            // The model keeps domain variables out of denominators.
            let denom = function.value.denom().eval(&self.values);
            let factor = denom.recip().ok_or_else(|| {
                let shown = function.value.denom().display(&family.names);
                error(format!(
                    "the denominator of `{}` is zero at {}",
                    family.function_label(k),
                    self.describe(family.shapes.iter())
                ))
                .note(format!("the denominator is `{shown}`"))
                .help("choose other shape values")
            })?;
            Ok(bound(function.value.numer()).scale(&factor))
        });
        functions.collect()
    }

    /// The values of some parameters, such as `λ = 1/2, t = 1/3`.
    pub(super) fn describe<'p>(&self, parameters: impl Iterator<Item = &'p Parameter>) -> String {
        let parts: Vec<String> = parameters.map(|p| format!("{} = {}", p.name, self.value(p.var))).collect();
        parts.join(", ")
    }
}
