//! Decides statements: the empty certificate first, then what the search finds.

use std::rc::Rc;

use basis_kernel::{
    Certificate, Chart, Gram, Point, Products, Proof, Quotient, Refusal, Refutation, Relation, SignProof,
    Signed, Statement, Witness,
};

use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::{Work, done};
use crate::budget::{Budget, begin, charge, charge_refused, checking};
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_unique;
use crate::coordinate::Coordinate;
use crate::counterexample::{Counterexample, Exact, at};
use crate::method::Method;
use crate::nonzero::nonzero;
use crate::rank::symmetry::Symmetries;
use crate::rank::{self, Independence, Table};
use crate::semidefinite::semidefinite;
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

/// What −x is wherever x is not as claimed: > 0 where x ≥ 0 fails, and ≥ 0 where x > 0 does.
pub const fn of_negative(relation: Relation) -> Relation {
    match relation {
        Relation::NonNegative => Relation::Positive,
        Relation::Positive => Relation::NonNegative,
    }
}

/// The work for making an irrational counterexample explicit.
const EXPLICIT: u64 = 20_000_000;

/// Decides a statement, with `budget` times the usual work. For a matrix, permutations may be known that leave it
/// unchanged.
///
/// # Errors
/// The statement is false, or the budget is spent.
pub fn decide(statement: Statement, symmetries: &Symmetries, budget: u32) -> Result<Shown, Failure> {
    begin();
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
    let (before, operations) = (work.left(), done());
    let proof = Proof::new(Rc::clone(statement), certificate, &mut work);
    match &proof {
        Err(Refusal::Spent) => charge_refused(done() - operations),
        _ => charge(before - work.left()),
    }
    proof
}

/// Proposes a certificate to the kernel.
fn propose(
    statement: &Rc<Statement>,
    certificate: Certificate,
    method: Method,
    budget: u32,
) -> Result<Shown, Failure> {
    match checked(statement, certificate, checking(budget)) {
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
            let below = pull_back(&chart, &value.denominator);
            let start: Vec<(Var, Rational)> =
                below.variables().iter().map(|v| (*v, simple(&region.range(*v)))).listed();
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
    let above = pull_back(&chart, &value.numerator);
    let above = if negative { -&above } else { above };
    let certificate = |numerator| Certificate::Sign { denominator: denominator.clone(), numerator };
    match accepted(statement, (&above, relation, region), &certificate, budget) {
        Ok(Shown { proof, method }) => Ok(Shown { proof, method: method.max(hardest) }),
        Err(Left::Refused(failure)) => Err(failure),
        Err(Left::Nothing(left)) => Err(Failure::Undecided(left)),
        Err(Left::Point(mut point)) => {
            for (var, range) in &region.ranges {
                if !point.iter().any(|(v, _)| v == var) {
                    point.push((*var, Coordinate::Rational(simple(range))));
                }
            }
            let work = &mut Work::new(EXPLICIT);
            let found = Exact::new(&point, work).and_then(|mut exact| {
                // Only what is no variable of the box alone.
                let inner = |var: Var| chart.variables().iter().all(|(_, by)| !by.depends_on(var));
                let simplices: Vec<Var> = region.ranges.iter().map(|(v, _)| *v).listed();
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
                    let left = if domain.premises.is_empty() {
                        "it fails, but at a point that could not be made explicit"
                    } else {
                        "it fails at points of the declared ranges that need not satisfy what is assumed"
                    };
                    Err(Failure::Undecided(String::from(left)))
                },
                |c| Err(Failure::Refuted(Box::new(c))),
            )
        }
    }
}

/// What there is instead of a proof of a sign.
enum Left {
    /// A point at which it fails.
    Point(Vec<(Var, Coordinate)>),
    /// Why nothing was found.
    Nothing(String),
    /// Proofs, all of which take too much work to check.
    Refused(Failure),
}

/// The first proof of the sign of a polynomial that the kernel accepts. Of one that takes too much work to check the method is
/// left out, and another one may be found.
fn accepted(
    statement: &Rc<Statement>,
    (p, relation, region): (&Poly, Relation, &Region),
    certificate: &dyn Fn(SignProof) -> Certificate,
    budget: u32,
) -> Result<Shown, Left> {
    let mut refused: Vec<(Method, Failure)> = Vec::new();
    loop {
        let all = Budget::scaled(budget);
        let mut own = refused.iter().fold(all, |budget, (method, _)| budget.without(*method));
        let found = search(p, relation, region, &mut own);
        drop(own); // what it took counts before the check does
        match found {
            Found::Proof(method, proof) if refused.iter().all(|(known, _)| *known != method) => {
                match propose(statement, certificate(proof), method, budget) {
                    Ok(shown) => return Ok(shown),
                    Err(failure) => refused.push((method, failure)),
                }
            }
            Found::Point(point) if refused.is_empty() => return Err(Left::Point(point)),
            Found::Nothing(left) if refused.is_empty() => return Err(Left::Nothing(left)),
            _ => return Err(Left::Refused(refused.swap_remove(0).1)),
        }
    }
}

fn unfit() -> Result<Shown, Failure> {
    Err(Failure::Undecided(String::from("the statement is not one that the search knows")))
}

/// What must be ≥ 0 (> 0) for a polynomial of degree 1 in dot products to be so for all points: its value with all
/// points at the origin, and the sums of the principal minors of its matrix, those of size 1 first.
///
/// # Errors
/// When it is not of degree 1, there are too many points, or the work is spent.
pub fn minor_signs(
    value: &Poly,
    relation: Relation,
    products: &Products,
    work: &mut Work,
) -> Result<Vec<(Poly, Relation)>, Refusal> {
    Gram::of(value, products, work)?.signs(relation, work)
}

/// The polynomial in the variables of the box of a chart.
pub fn pull_back(chart: &Chart, polynomial: &Poly) -> Poly {
    chart.variables().iter().fold(polynomial.clone(), |p, (var, by)| p.substitute(*var, by))
}

/// Sums of dot products: the signs of sums of minors. Where one of them is negative, so is the matrix for some vector.
fn products(statement: &Rc<Statement>, budget: u32) -> Result<Shown, Failure> {
    let Statement::Products { value, relation, products, domain } = &**statement else { return unfit() };
    let signs = match minor_signs(value, *relation, products, &mut Work::usual(budget)) {
        Ok(signs) => signs,
        Err(refusal) => return Err(Failure::Undecided(refusal.to_string())),
    };
    let mut hardest = Method::Constant;
    let mut proofs: Vec<SignProof> = Vec::new();
    for (sum, relation) in signs {
        let Ok(chart) = Chart::new(domain, [&sum, &sum]) else { return unfit() };
        let budget = &mut Budget::scaled(budget);
        match search(&pull_back(&chart, &sum), relation, chart.region(), budget) {
            Found::Proof(method, proof) => {
                hardest = hardest.max(method);
                proofs.push(proof);
            }
            Found::Point(point) => {
                let found = on_line(statement, &chart, &point, &mut budget.work);
                return Err(found.map_or_else(
                    || {
                        let left = "it fails, but at points that could not be made explicit";
                        Failure::Undecided(String::from(left))
                    },
                    |c| Failure::Refuted(Box::new(c)),
                ));
            }
            Found::Nothing(left) => return Err(Failure::Undecided(left)),
        }
    }
    propose(statement, Certificate::Minors(proofs), hardest, budget)
}

/// The refutation of a sum of dot products at a rational point of the box of a chart, by points on a line; `None` when
/// there are none, or the work is spent.
fn on_line(
    statement: &Rc<Statement>,
    chart: &Chart,
    point: &[(Var, Coordinate)],
    work: &mut Work,
) -> Option<Counterexample> {
    let Statement::Products { value, relation, products, domain } = &**statement else { return None };
    let mut inner = problem::as_rational(&point.to_vec())?;
    for (var, range) in &chart.region().ranges {
        if !inner.iter().any(|(v, _)| v == var) {
            inner.push((*var, simple(range)));
        }
    }
    let by = |var: Var| chart.variables().iter().find(|(v, _)| *v == var);
    let coordinate = |var: Var| match by(var) {
        Some((_, by)) => problem::value(by, &inner),
        None => inner.iter().find(|(v, _)| *v == var).map_or(Rational::ZERO, |(_, x)| x.clone()),
    };
    let mut vars: Vec<Var> = domain.region.ranges.iter().map(|(v, _)| *v).listed();
    vars.extend(domain.simplices.iter().flat_map(|s| s.variables.iter().copied()).chain(value.variables()));
    vars.retain(|v| products.iter().all(|(w, _)| v != w));
    sort_unique(&mut vars);
    let at: Vec<(Var, Rational)> = vars.mapped(|v| (*v, coordinate(*v)));
    let mut numbers = value.clone();
    for (var, x) in &at {
        work.spend_at(&numbers, *var, x)?;
        numbers = numbers.at(*var, x);
    }
    // c + xᵀA x at the point: far out in a direction in which A is negative it is as small as one likes.
    let mut points: Vec<usize> = products.iter().flat_map(|(_, (p, q))| [*p, *q]).listed();
    sort_unique(&mut points);
    let place = |p: usize| points.binary_search(&p).unwrap_or(0);
    let mut matrix = vec![vec![Rational::ZERO; points.len()]; points.len()];
    let coefficient = |monomial: &Monomial| {
        numbers.terms().find(|(m, _)| *m == monomial).map_or(Rational::ZERO, |(_, c)| c.clone())
    };
    let constant = coefficient(&Monomial::one());
    for (var, (p, q)) in products {
        let half = &coefficient(&Monomial::one().with_exponent(*var, 1)) * &Rational::new(1, 2);
        matrix[place(*p)][place(*q)] += &half;
        matrix[place(*q)][place(*p)] += &half;
    }
    let mut direction = vec![Rational::ZERO; points.len()];
    if relation.holds(&constant) {
        direction = semidefinite(&matrix, work)?.err()?;
    }
    let form = |x: &[Rational]| {
        let row = |r: &Vec<Rational>| r.iter().zip(x).fold(Rational::ZERO, |sum, (a, x)| &sum + &(a * x));
        matrix.iter().zip(x).fold(constant.clone(), |sum, (r, x)| &sum + &(&row(r) * x))
    };
    while relation.holds(&form(&direction)) {
        work.spend_fractions(constant.bits() + form(&direction).bits())?;
        direction = direction.mapped(|x| x + x);
    }
    let coordinates = at.mapped(|(v, x)| (*v, Univariate::new(vec![x.clone()])));
    let witness = Witness::OnLine(
        Point { root: None, coordinates },
        points.into_iter().zip(direction).filter(|(_, x)| !x.is_zero()).listed(),
    );
    let refutation = Refutation::new(Rc::clone(statement), witness, &mut Work::usual(1)).ok()?;
    let point = problem::rational(at);
    let exact = Exact::new(&point, work)?;
    Some(Counterexample { refutation, point, exact })
}

/// Independence: combinations at the exceptions, and minors elsewhere.
fn rank(statement: &Rc<Statement>, symmetries: &Symmetries, budget: u32) -> Result<Shown, Failure> {
    let Statement::Independent { rows, except, region } = &**statement else { return unfit() };
    match rank::independent(Table { rows, symmetries }, except, region, budget) {
        Independence::Proved(proof) => propose(statement, Certificate::Rank(proof), Method::Minors, budget),
        Independence::NoException(number, point) => {
            let coordinates: Vec<(Var, Coordinate)> =
                point.iter().map(|(v, x)| (*v, Coordinate::Rational(x.clone()))).listed();
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
