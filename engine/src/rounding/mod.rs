//! Proved bounds of rounding errors.
//!
//! The value that floats give for a function is that of its [`Steps`] in which step k is multiplied by 1 + δₖ, |δₖ| ≤ u,
//! where u = ε/2 is half the distance from 1 to the next float. To first order the error is Σ δₖ·wₖvₖ, with vₖ the exact
//! value of the step and wₖ the derivative of the result with respect to it. Both are rational functions of the inputs,
//! so that a bound is a statement like any other one about signs, which the kernel decides:
//!
//! - *relative*, κ·u times the value: κ·|v| − Σ|wₖvₖ| ≥ 0; file `relative`;
//! - *absolute*, c·u, for functions that change their sign: c − Σ|wₖvₖ| ≥ 0; file `absolute`.
//!
//! What is of higher order in u is bounded by a number that counts roundings, with u = 2⁻²⁴, that of `f32`; file `rest`.
//! Steps that do not round are left out: inputs, numbers that are floats, negation, products with powers of two, and
//! differences a − b with b/2 ≤ a ≤ 2b (Sterbenz), for which the domain is cut into cells.
//!
//! A fused multiplication and addition rounds less, so that the bounds hold for fused code, too. They hold as long as
//! nothing overflows; each product that underflows adds half the smallest float.
//!
//! Shape values and the coordinates of a point are exact as they are given. All three or four barycentric coordinates
//! are inputs: the exact value is that of the formula for these floats, also if they do not quite sum to 1.

mod absolute;
mod cell;
mod conditions;
mod exact;
mod relative;
mod rest;

use std::rc::Rc;

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::plan::Input;
use crate::steps::Steps;
use cell::Cell;
use exact::Exact;

/// How far a computed value may be from the exact one, in units of ε, the distance from 1 to the next float: 2⁻²³ for
/// `f32`, 2⁻⁵² for `f64`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// This many ε times the value.
    Relative(Rational),
    /// This many ε.
    Absolute(Rational),
}

impl Error {
    /// The number of ε.
    pub const fn epsilons(&self) -> &Rational {
        match self {
            Self::Relative(bound) | Self::Absolute(bound) => bound,
        }
    }
}

/// A bound with what it follows from.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The bound, rounded up to hundredths.
    pub error: Error,
    cells: Vec<Part>,
}

/// What a bound takes on one cell of the domain.
#[derive(Clone, Debug)]
struct Part {
    domain: Rc<Domain>,
    /// Polynomials that are not negative: conditions under which the others say something about the error.
    conditions: Vec<Poly>,
    /// With a bound of κ u: (κ − `rest`)·`value` − `sum` is not negative.
    value: Poly,
    sum: Poly,
    rest: Rational,
}

impl Part {
    /// What is not negative if the error is at most this many u.
    fn last(&self, bound: &Rational) -> Poly {
        &self.value.scale(&(bound - &self.rest)) - &self.sum
    }
}

impl Bound {
    /// The statements from which it follows that the error is at most `epsilons` times ε, relative or absolute as the
    /// bound is.
    pub fn statements(&self, epsilons: &Rational) -> Vec<Statement> {
        let mut all = Vec::new();
        for part in &self.cells {
            let last = part.last(&(epsilons * &Rational::from(2)));
            for poly in part.conditions.iter().chain([&last]) {
                let (value, domain) = (Quotient::from(poly.clone()), Rc::clone(&part.domain));
                all.push(Statement::Sign { value, relation: Relation::NonNegative, domain });
            }
        }
        all
    }
}

/// Bounds of the errors of the values of all functions; an error with no bound is `None`.
///
/// `None` in place of a list when the work is spent.
pub fn values(family: &Family) -> Option<Vec<Option<Bound>>> {
    let steps: Steps = todo!();
    basis_prover::working(family.budget, &mut |work| bounds(family, &steps, work))
}

fn bounds(family: &Family, steps: &Steps, work: &mut Work) -> Option<Vec<Option<Bound>>> {
    let (region, variables) = inputs(family);
    let variable = |input: Input| match input {
        Input::Shape(k) => family.shapes.get(k).map(|p| p.var),
        Input::Coordinate(k) => variables.get(k).copied(),
        Input::Point(_) | Input::Derivative(_) => None,
    };
    let mut exact = Exact::new(steps, &variable)?;
    let mut all = Vec::new();
    for output in &steps.outputs {
        all.push(bound(&mut exact, *output, &region, &variables, work)?);
    }
    Some(all)
}

/// The bound of one result, relative if there is one.
fn bound(
    exact: &mut Exact<'_>,
    output: usize,
    region: &Region,
    cut: &[Var],
    work: &mut Work,
) -> Option<Option<Bound>> {
    for count in [2, 8] {
        let cells = Cell::grid(region, cut, count);
        if let Some(parts) = on_each(&cells, &mut |cell| relative::part(exact, output, cell, work)) {
            return Some(Some(rounded_up(parts, Error::Relative)));
        }
    }
    let cells = Cell::grid(region, cut, 16);
    let parts = on_each(&cells, &mut |cell| absolute::part(exact, output, cell, work));
    Some(parts.map(|parts| rounded_up(parts, Error::Absolute)))
}

/// A part for each cell, or `None` if one has none.
fn on_each(
    cells: &[Cell],
    part: &mut dyn FnMut(&Cell) -> Option<(Rational, Part)>,
) -> Option<Vec<(Rational, Part)>> {
    let mut parts = Vec::new();
    for cell in cells {
        parts.push(part(cell)?);
    }
    Some(parts)
}

/// The largest bound, which is in u, in hundredths of ε.
fn rounded_up(parts: Vec<(Rational, Part)>, error: fn(Rational) -> Error) -> Bound {
    let mut largest = Rational::ZERO;
    for (bound, _) in &parts {
        if *bound > largest {
            largest = bound.clone();
        }
    }
    let hundredths = -&(-&(&largest * &Rational::from(50))).floor();
    let error = error(&hundredths * &Rational::new(1, 100));
    Bound { error, cells: parts.into_iter().map(|(_, part)| part).listed() }
}

/// The ranges of all inputs, and the variables of the coordinates in order: on a simplex one more than are independent.
fn inputs(family: &Family) -> (Region, Vec<Var>) {
    let coordinates = family.domain.iter().chain(&family.dependent);
    let mut ranges: Vec<(Var, Range)> = family.shapes.mapped(|p| (p.var, p.range.clone()));
    let mut variables = Vec::new();
    for p in coordinates {
        ranges.push((p.var, if family.is_simplex() { Range::unit() } else { p.range.clone() }));
        variables.push(p.var);
    }
    (Region { ranges }, variables)
}

#[cfg(test)]
mod tests;
