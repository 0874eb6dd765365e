//! The two values that mean something: a [`Proof`] is a statement that has been checked to be true, a [`Refutation`]
//! one that has been checked to be false.
//!
//! Their fields are private and this file makes them nowhere but behind a check, so that to hold one is to know that
//! its statement is true, or false, as far as this crate is right.

use std::rc::Rc;

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::certificate::Certificate;
use crate::check::{are_independent, check};
use crate::point::Point;
use crate::refusal::{Refusal, fits, shown};
use crate::statement::{Domain, Quotient, Statement};

/// A statement that is true, with the certificate by which it was checked.
///
/// ```
/// # use std::rc::Rc;
/// use basis_kernel::algebra::{poly::Poly, work::Work};
/// use basis_kernel::{Certificate, Proof, Quotient, Statement};
///
/// let statement = Statement::Zero { value: Quotient::from(Poly::zero()), domain: Rc::default() };
/// let proof = Proof::new(Rc::new(statement), Certificate::Direct, &mut Work::usual(1)).unwrap();
/// assert!(matches!(proof.statement(), Statement::Zero { .. }));
/// ```
///
/// There is no other way to make one:
///
/// ```compile_fail,E0451
/// # use std::rc::Rc;
/// use basis_kernel::{Certificate, Proof, Statement};
///
/// fn proved(statement: Rc<Statement>) -> Proof {
///     Proof { statement, certificate: Certificate::Direct } // error: these fields are private
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Proof {
    statement: Rc<Statement>,
    certificate: Certificate,
}

impl Proof {
    /// The proof of a statement, if the certificate is one.
    ///
    /// # Errors
    /// What is wrong with the certificate, or that the work is spent.
    pub fn new(statement: Rc<Statement>, certificate: Certificate, work: &mut Work) -> Result<Self, Refusal> {
        check(&statement, &certificate, work)?;
        Ok(Self { statement, certificate })
    }

    /// What is true.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Why it is true.
    pub const fn certificate(&self) -> &Certificate {
        &self.certificate
    }
}

/// Where a statement fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Witness {
    /// At this point the value is not as claimed.
    At(Point),
    /// At this point, which has the values of no exception, a combination of the rows is zero: its factors are
    /// polynomials in the root of the point, and one of them is a number different from 0.
    Dependent(Point, Vec<Univariate>),
    /// At this point, which has rational coordinates and the values of the exception with this number, the rows are
    /// independent.
    Independent(Point, usize),
    /// At this point, with these numbers for the points of the dot products, which lie on a line; those without a
    /// number are at its origin.
    OnLine(Point, Vec<(usize, Rational)>),
}

/// A statement that is false, with the witness by which it was checked.
///
/// ```compile_fail,E0451
/// # use std::rc::Rc;
/// use basis_kernel::{Refutation, Statement, Witness};
///
/// fn refuted(statement: Rc<Statement>, witness: Witness) -> Refutation {
///     Refutation { statement, witness, value: None } // error: these fields are private
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Refutation {
    statement: Rc<Statement>,
    witness: Witness,
    value: Option<Rational>,
}

impl Refutation {
    /// The refutation of a statement, if it fails as the witness says.
    ///
    /// # Errors
    /// What is wrong with the witness, or that the work is spent.
    pub fn new(statement: Rc<Statement>, witness: Witness, work: &mut Work) -> Result<Self, Refusal> {
        let value = fails(&statement, &witness, work)?;
        Ok(Self { statement, witness, value })
    }

    /// What is false.
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// Where it fails.
    pub const fn witness(&self) -> &Witness {
        &self.witness
    }

    /// The value that is not as claimed, if it is a rational number; `None` for independence.
    pub const fn value(&self) -> Option<&Rational> {
        self.value.as_ref()
    }
}

/// Checks that a statement fails; the value at the point.
fn fails(statement: &Statement, witness: &Witness, work: &mut Work) -> Result<Option<Rational>, Refusal> {
    match (statement, witness) {
        (Statement::Zero { value, domain }, Witness::At(point)) => {
            point.check(work)?;
            point.lies_in(domain, work)?;
            shown(point.sign_of_fraction(value, work)? != 0, "the value is zero at the point")?;
            point.rational_value(value, work)
        }
        (Statement::Sign { value, relation, domain }, Witness::At(point)) => {
            point.check(work)?;
            point.lies_in(domain, work)?;
            let sign = point.sign_of_fraction(value, work)?;
            shown(!relation.allows(sign), "the value is as claimed at the point")?;
            point.rational_value(value, work)
        }
        (Statement::Independent { rows, except, region }, Witness::Dependent(point, factors)) => {
            point.check(work)?;
            point.lies_in(&Domain::of(region.clone()), work)?;
            for values in except {
                let mut apart = false;
                for (var, x) in values {
                    let difference = &Poly::var(*var) - &Poly::constant(x.clone());
                    apart |= point.sign_of(&difference, work)? != 0;
                }
                shown(apart, "the point is an exception")?;
            }
            fits(factors.len() == rows.len(), "there is not one factor for each row")?;
            let some = factors.iter().any(|c| c.is_constant() && !c.is_zero());
            shown(some, "no factor is a number different from 0")?;
            for column in 0..rows.first().map_or(0, Vec::len) {
                let mut sum = Univariate::default();
                for (factor, row) in factors.iter().zip(rows) {
                    if !factor.is_zero() {
                        let entry = point.value(&row[column], work)?;
                        sum = sum.add(&point.product(factor, &entry, work)?);
                    }
                }
                shown(sum.is_zero(), "the combination does not vanish at the point")?;
            }
            Ok(None)
        }
        (Statement::Independent { rows, except, region }, Witness::Independent(point, number)) => {
            point.check(work)?;
            point.lies_in(&Domain::of(region.clone()), work)?;
            let values = except.get(*number).ok_or(Refusal::Unfit("there is no such exception"))?;
            for (var, x) in values {
                let own =
                    point.coordinates.iter().any(|(v, c)| v == var && c.is_constant() && c.leading() == *x);
                shown(own, "the point is not one of the exception")?;
            }
            let mut numbers = Vec::new();
            for row in rows {
                let mut all = Vec::new();
                for entry in row {
                    let value = point.value(entry, work)?;
                    fits(value.is_constant(), "the point is irrational")?;
                    all.push(value.leading());
                }
                numbers.push(all);
            }
            let full = are_independent(&numbers, work).ok_or(Refusal::Spent)?;
            shown(full, "the rows are dependent at the point")?;
            Ok(None)
        }
        (Statement::Products { value, relation, products, domain }, Witness::OnLine(point, numbers)) => {
            point.check(work)?;
            point.lies_in(domain, work)?;
            let twice = |k: usize| products[..k].iter().any(|(v, _)| *v == products[k].0);
            let ranges = &domain.region.ranges;
            let known = |(v, _): &(Var, _)| {
                point.coordinates.iter().any(|(w, _)| v == w)
                    || ranges.iter().any(|(w, _)| v == w)
                    || domain.simplices.iter().any(|s| s.variables.contains(v))
            };
            let proper = !(0..products.len()).any(twice) && !products.iter().any(known);
            fits(proper, "a dot product is given twice")?;
            let number = |p| numbers.iter().find(|(q, _)| *q == p).map_or(Rational::ZERO, |(_, x)| x.clone());
            let mut on_line = value.clone();
            for (var, (p, q)) in products {
                let product = &number(*p) * &number(*q);
                work.spend_at(&on_line, *var, &product).ok_or(Refusal::Spent)?;
                on_line = on_line.at(*var, &product);
            }
            let sign = point.sign_of(&on_line, work)?;
            shown(!relation.allows(sign), "the value is as claimed at the point")?;
            point.rational_value(&Quotient::from(on_line), work)
        }
        _ => Err(Refusal::Unfit("the witness is one against another kind of statement")),
    }
}
