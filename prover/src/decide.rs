//! Decides statements: the empty certificate first, then what the search finds.

use std::rc::Rc;

use basis_kernel::{
    Certificate, Chart, Proof, Quotient, Refusal, Relation, SignProof, Signed, Statement, Witness,
};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::budget::{Budget, charge};
use crate::coordinate::Coordinate;
use crate::counterexample::{Counterexample, Exact, at};
use crate::method::Method;
use crate::nonzero::nonzero;
use crate::rank::symmetry::Symmetries;
use crate::rank::{self, Independence, Table};
use crate::sign::{Found, problem, search};

/// A statement that is proved.
#[derive(Clone, Debug)]
pub struct Shown {
    /// The proof.
    pub proof: Proof,
    /// The most elaborate method that it needed.
    pub method: Method,
}

/// Why there is no proof of a statement.
#[derive(Clone, Debug)]
pub enum Failure {
    /// It is false.
    Refuted(Box<Counterexample>),
    /// The budget is spent; what is left to decide, in words.
    Undecided(String),
}

/// The work for making an irrational counterexample explicit.
const EXPLICIT: u64 = 20_000_000;

/// Decides a statement, with `budget` times the usual work. For a matrix, permutations may be known that leave it unchanged.
///
/// # Errors
/// The statement is false, or the budget is spent.
pub fn decide(statement: Statement, symmetries: &Symmetries, budget: u32) -> Result<Shown, Failure> {
    let statement = Rc::new(statement);
    if let Ok(proof) = checked(&statement, Certificate::Direct, first(budget)) {
        let method = direct(&statement);
        return Ok(Shown { proof, method });
    }
    match &*statement {
        Statement::Zero { value, domain } => {
            let found = nonzero(value, domain);
            let found = found.and_then(|point| crate::refute(&statement, &point, &mut Work::new(EXPLICIT)));
            found.map_or_else(
                || Err(Failure::Undecided(String::from("no point was found at which the two sides differ"))),
                |c| Err(Failure::Refuted(Box::new(c))),
            )
        }
        Statement::Sign { value, relation, .. } => sign(&statement, value, *relation, budget),
        Statement::Products { .. } => products(&statement, budget),
        Statement::Independent { .. } => rank(&statement, symmetries, budget),
    }
}

/// The work for the empty certificate: a few times that of a search.
fn first(budget: u32) -> Work {
    Work::new(4 * Budget::scaled(budget).left())
}

/// The method by which the empty certificate proves a statement.
fn direct(statement: &Statement) -> Method {
    match statement {
        Statement::Zero { .. } => Method::Constant,
        Statement::Sign { value, domain, .. } => {
            let single = |v: &Var| domain.region.range(*v).finite().is_some_and(|(a, b)| a == b);
            let empty = domain.region.ranges.iter().any(|(_, r)| r.is_empty());
            if empty || value.numerator.variables().iter().all(single) {
                Method::Constant
            } else {
                Method::Coefficients
            }
        }
        Statement::Products { .. } => Method::Squares,
        Statement::Independent { .. } => Method::Minors,
    }
}

/// Has the kernel check a certificate, and counts its work.
fn checked(statement: &Rc<Statement>, certificate: Certificate, mut work: Work) -> Result<Proof, Refusal> {
    let before = work.left();
    let proof = Proof::new(Rc::clone(statement), certificate, &mut work);
    charge(before - work.left());
    proof
}

/// Proposes a certificate to the kernel.
fn propose(
    statement: &Rc<Statement>,
    certificate: Certificate,
    method: Method,
    budget: u32,
) -> Result<Shown, Failure> {
    match checked(statement, certificate, Work::usual(budget)) {
        Ok(proof) => Ok(Shown { proof, method }),
        Err(refusal) => Err(Failure::Undecided(format!("a proof was found, but not accepted: {refusal}"))),
    }
}

/// A quotient: the sign of the denominator, which vanishes nowhere, and then that of the numerator.
fn sign(
    statement: &Rc<Statement>,
    value: &Quotient,
    relation: Relation,
    budget: u32,
) -> Result<Shown, Failure> {
    let Statement::Sign { domain, .. } = &**statement else { return unfit() };
    let Ok(chart) = Chart::new(domain, [&value.numerator, &value.denominator]) else { return unfit() };
    let region = chart.region();
    let search = |p: &Poly, relation: Relation| search(p, relation, region, &mut Budget::scaled(budget));
    let mut hardest = Method::Constant;
    let (denominator, negative) = match value.denominator.as_constant() {
        Some(number) => (None, number.is_negative()),
        None => {
            let below = chart.pull_back(&value.denominator);
            let start: Vec<(Var, Rational)> =
                below.variables().iter().map(|v| (*v, simple(&region.range(*v)))).collect();
            let negative = problem::value(&below, &start).is_negative();
            match search(&if negative { -&below } else { below }, Relation::NonNegative) {
                Found::Proof(method, proof) => {
                    hardest = method;
                    let signed = if negative { Signed::Negative(proof) } else { Signed::Positive(proof) };
                    (Some(signed), negative)
                }
                Found::Point(_) => {
                    return Err(Failure::Undecided(String::from("the denominator changes its sign")));
                }
                Found::Nothing(left) => return Err(Failure::Undecided(format!("the denominator: {left}"))),
            }
        }
    };
    let above = chart.pull_back(&value.numerator);
    match search(&if negative { -&above } else { above }, relation) {
        Found::Proof(method, numerator) => {
            let certificate = Certificate::Sign { denominator, numerator };
            propose(statement, certificate, method.max(hardest), budget)
        }
        Found::Point(mut point) => {
            for (var, range) in &region.ranges {
                if !point.iter().any(|(v, _)| v == var) {
                    point.push((*var, Coordinate::Rational(simple(range))));
                }
            }
            let work = &mut Work::new(EXPLICIT);
            let found = Exact::new(&point, work).and_then(|mut exact| {
                // Only what is no variable of the box alone.
                let inner = |var: Var| chart.variables().iter().all(|(_, by)| !by.depends_on(var));
                let simplices: Vec<Var> = region.ranges.iter().map(|(v, _)| *v).collect();
                let declared = |var: Var| domain.region.ranges.iter().any(|(v, _)| *v == var);
                exact.image(
                    chart.variables(),
                    &|v| inner(v) && (declared(v) || !simplices.contains(&v)),
                    work,
                )?;
                at(statement, &mut exact, work)
            });
            found.map_or_else(
                || {
                    Err(Failure::Undecided(String::from(
                        "it fails, but at a point that could not be made explicit",
                    )))
                },
                |c| Err(Failure::Refuted(Box::new(c))),
            )
        }
        Found::Nothing(left) => Err(Failure::Undecided(left)),
    }
}

fn unfit() -> Result<Shown, Failure> {
    Err(Failure::Undecided(String::from("the statement is not one that the search knows")))
}

/// Sums of dot products: the signs of sums of minors.
fn products(statement: &Rc<Statement>, budget: u32) -> Result<Shown, Failure> {
    let Statement::Products { value, relation, products, domain } = &**statement else { return unfit() };
    let signs = match basis_kernel::minor_signs(value, *relation, products, &mut Work::usual(budget)) {
        Ok(signs) => signs,
        Err(refusal) => return Err(Failure::Undecided(refusal.to_string())),
    };
    let mut hardest = Method::Constant;
    let mut proofs: Vec<SignProof> = Vec::new();
    for (sum, relation) in signs {
        match search(&sum, relation, &domain.region, &mut Budget::scaled(budget)) {
            Found::Proof(method, proof) => {
                hardest = hardest.max(method);
                proofs.push(proof);
            }
            Found::Point(_) => return Err(Failure::Undecided(String::from("it fails for some points"))),
            Found::Nothing(left) => return Err(Failure::Undecided(left)),
        }
    }
    propose(statement, Certificate::Minors(proofs), hardest, budget)
}

/// Independence: combinations at the exceptions, and minors elsewhere.
fn rank(statement: &Rc<Statement>, symmetries: &Symmetries, budget: u32) -> Result<Shown, Failure> {
    let Statement::Independent { rows, except, region } = &**statement else { return unfit() };
    match rank::independent(Table { rows, symmetries }, except, region, budget) {
        Independence::Proved(proof) => propose(statement, Certificate::Rank(proof), Method::Minors, budget),
        Independence::NoException(number, point) => {
            let coordinates: Vec<(Var, Coordinate)> =
                point.iter().map(|(v, x)| (*v, Coordinate::Rational(x.clone()))).collect();
            let work = &mut Work::new(EXPLICIT);
            let found = Exact::new(&coordinates, work).and_then(|mut exact| {
                let refutation = exact.refute(statement, &|p| Witness::Independent(p, number), work)?;
                Some(Counterexample { refutation, point: coordinates, exact })
            });
            found.map_or_else(
                || Err(Failure::Undecided(String::from("the budget is spent on the rank at an exception"))),
                |c| Err(Failure::Refuted(Box::new(c))),
            )
        }
        Independence::Dependent(point) => dependent(statement, Table { rows, symmetries }, &point),
        Independence::Undecided(left) => Err(Failure::Undecided(left)),
    }
}

/// The refutation by a combination of the rows that vanishes at a point.
fn dependent(
    statement: &Rc<Statement>,
    table: Table<'_>,
    point: &[(Var, Coordinate)],
) -> Result<Shown, Failure> {
    let work = &mut Work::new(EXPLICIT);
    let found = Exact::new(point, work).and_then(|mut exact| {
        let combination = rank::combination(&mut exact, table, work)?;
        let witness = |point| Witness::Dependent(point, combination.clone());
        let refutation = exact.refute(statement, &witness, work)?;
        Some(Counterexample { refutation, point: point.to_vec(), exact })
    });
    found.map_or_else(
        || Err(Failure::Undecided(String::from("the budget is spent on a combination that vanishes"))),
        |c| Err(Failure::Refuted(Box::new(c))),
    )
}

/// A simple number of a range that is not empty, an inner one if there is any.
pub fn simple(range: &Range) -> Rational {
    problem::simple(range)
}
