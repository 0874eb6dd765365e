//! Families as exact tables of functions over a domain and shape parameters.

use super::obligation::Obligation;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::diagnostic::Place;
use crate::source::SourceId;
use basis_prover::collections::list::{Listed, Mapped};

/// A family of basis functions of one order.
#[derive(Clone, Debug)]
pub struct Family {
    /// The name.
    pub name: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// The values of the index parameters, such as n = 3.
    pub order: Vec<(String, i64)>,
    /// The spec that defines it.
    pub source: SourceId,
    /// Where its name stands.
    pub place: Place,
    /// The names of all variables: the shape parameters, then the domain variables.
    pub names: Vec<String>,
    /// The shape parameters, variables 0, 1, …
    pub shapes: Vec<Parameter>,
    /// The independent domain variables, the variables after the shape parameters: all variables of a box, all
    /// but the last barycentric coordinate of a simplex.
    pub domain: Vec<Parameter>,
    /// The last barycentric coordinate of a simplex, 1 minus the others; it does not occur in the functions.
    pub dependent: Option<Parameter>,
    /// The name that the functions share.
    pub function_name: String,
    /// The functions in the order of their indices.
    pub functions: Vec<Function>,
    /// The functions of the lowest order, when these were raised from them.
    pub base: Vec<Function>,
    /// What holds on the declared ranges, so that the formulas mean something.
    pub obligations: Vec<Obligation>,
    /// How many times the usual work the provers may spend on a claim.
    pub budget: u32,
}

/// A shape parameter or a domain variable.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name as it is written.
    pub name: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// Where it is declared.
    pub place: Place,
    /// The variable.
    pub var: Var,
    /// The declared range; for a domain variable both ends are finite and included.
    pub range: Range,
}

/// A basis function.
#[derive(Clone, Debug)]
pub struct Function {
    /// The index, 2 for `b[2]`.
    pub index: Vec<i64>,
    /// The function: a polynomial in the domain variables, whose coefficients are rational functions of the
    /// shape parameters.
    pub value: Fraction,
}

impl Family {
    /// The name with the order, such as `Bernstein(3)`.
    pub fn title(&self) -> String {
        if self.order.is_empty() {
            return self.name.clone();
        }
        let values: Vec<String> = self.order.mapped(|(_, v)| v.to_string());
        format!("{}({})", self.name, values.join(", "))
    }

    /// The name of a function, such as `b[2]`.
    pub fn function_label(&self, position: usize) -> String {
        label(&self.function_name, &self.functions[position].index)
    }

    /// Whether the domain is a triangle or a tetrahedron.
    pub const fn is_simplex(&self) -> bool {
        self.dependent.is_some()
    }

    /// All domain variables; of a simplex all barycentric coordinates.
    pub fn domain_variables(&self) -> impl Iterator<Item = &Parameter> {
        self.domain.iter().chain(&self.dependent)
    }

    /// The declared ranges of all independent variables; of a simplex the surrounding box.
    pub fn region(&self) -> Region {
        Region { ranges: self.shapes.iter().chain(&self.domain).map(|p| (p.var, p.range.clone())).listed() }
    }

    /// The declared ranges of the shape parameters.
    pub fn shape_region(&self) -> Region {
        Region { ranges: self.shapes.mapped(|p| (p.var, p.range.clone())) }
    }

    /// The only domain variable and the two ends of its range; `None` when there are several.
    pub fn interval(&self) -> Option<(Var, &Rational, &Rational)> {
        let ([only], None) = (self.domain.as_slice(), &self.dependent) else { return None };
        let (low, high) = only.range.finite()?;
        Some((only.var, low, high))
    }

    /// The highest degree of the functions in a domain variable.
    pub fn degree(&self, var: Var) -> u32 {
        self.functions.iter().map(|f| f.value.numer().degree(var)).max().unwrap_or(0)
    }
}

/// `b[2,0,1]`.
pub(crate) fn label(name: &str, index: &[i64]) -> String {
    let index: Vec<String> = index.mapped(i64::to_string);
    format!("{name}[{}]", index.join(","))
}
