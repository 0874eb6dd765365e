//! The checker: one file for each way to prove something, each with its theorem at the top.

mod bernstein;
mod chart;
mod claim;
mod elimination;
mod levels;
pub(crate) mod pieces;
pub(crate) mod products;
pub(crate) mod rank;
mod sign;
mod slices;
mod sturm;

use crate::algebra::poly::Poly;
use crate::algebra::work::Work;
use crate::certificate::{Certificate, SignProof, Signed};
use crate::refusal::{Refusal, fits, shown};
use crate::statement::{Domain, Products, Quotient, Relation, Statement};

pub use chart::Chart;
pub(crate) use rank::are_independent;

/// Checks that a certificate proves a statement.
pub(crate) fn check(
    statement: &Statement,
    certificate: &Certificate,
    work: &mut Work,
) -> Result<(), Refusal> {
    match (statement, certificate) {
        (Statement::Zero { value, .. }, Certificate::Direct) => {
            defined(value)?;
            shown(value.numerator.is_zero(), "the expanded difference is not zero")
        }
        (Statement::Sign { value, relation, domain }, certificate) => {
            sign(value, *relation, domain, certificate, work)
        }
        (Statement::Products { value, relation, products, domain }, certificate) => {
            dot_products(value, *relation, (products, domain), certificate, work)
        }
        (Statement::Independent { rows, except, region }, certificate) => {
            rank::independent(rows, except, region, certificate, work)
        }
        _ => Err(Refusal::Unfit("the certificate is one of another kind of statement")),
    }
}

/// Something is said only of what is defined somewhere.
pub(crate) fn defined(value: &Quotient) -> Result<(), Refusal> {
    fits(!value.denominator.is_zero(), "a denominator is zero everywhere")
}

/// n/d has the sign of n where d > 0, that of −n where d < 0. Where d is 0 there is no value, so that d ≥ 0 is enough.
fn sign(
    value: &Quotient,
    relation: Relation,
    domain: &Domain,
    certificate: &Certificate,
    work: &mut Work,
) -> Result<(), Refusal> {
    defined(value)?;
    let chart = Chart::new(domain, [&value.numerator, &value.denominator])?;
    let direct = SignProof::direct();
    let (denominator, numerator) = match certificate {
        Certificate::Direct => (None, &direct),
        Certificate::Sign { denominator, numerator } => (denominator.as_ref(), numerator),
        _ => return Err(Refusal::Unfit("the certificate is not one of a sign")),
    };
    let number = value.denominator.as_constant();
    let negative = match (number, denominator) {
        (Some(number), None) => number.is_negative(),
        (Some(_), Some(_)) => {
            return Err(Refusal::Unfit("the denominator is a number, its sign needs no proof"));
        }
        (None, Some(signed)) => sign::signed(
            &chart.counted(&value.denominator, work)?,
            Relation::NonNegative,
            chart.region(),
            signed,
            work,
        )?,
        (None, None) if *certificate == Certificate::Direct => {
            let below = chart.counted(&value.denominator, work)?;
            let positive = Signed::Positive(SignProof::direct());
            let negative = Signed::Negative(SignProof::direct());
            sign::signed(&below, Relation::NonNegative, chart.region(), &positive, work)
                .or_else(|_| sign::signed(&below, Relation::NonNegative, chart.region(), &negative, work))?
        }
        (None, None) => return Err(Refusal::Unfit("the sign of the denominator is not proved")),
    };
    let above = chart.counted(&value.numerator, work)?;
    let above = if negative { -&above } else { above };
    sign::check(&above, relation, chart.region(), numerator, work)
}

/// A sum of dot products: a matrix of numbers is looked at itself, one of polynomials by the sums of its minors.
fn dot_products(
    value: &Poly,
    relation: Relation,
    (products, domain): (&Products, &Domain),
    certificate: &Certificate,
    work: &mut Work,
) -> Result<(), Refusal> {
    let gram = products::Gram::of(value, products, work)?;
    if let (Certificate::Direct, Some((constant, matrix))) = (certificate, gram.numbers()) {
        shown(relation.holds(&constant), "with all points at the origin the value is not as claimed")?;
        let semidefinite = products::is_semidefinite(matrix, work).ok_or(Refusal::Spent)?;
        return shown(semidefinite, "the sum of dot products is negative somewhere");
    }
    let signs = gram.signs(relation, work)?;
    let direct = SignProof::direct();
    let proofs = match certificate {
        Certificate::Direct => None,
        Certificate::Minors(proofs) => Some(proofs),
        _ => return Err(Refusal::Unfit("the certificate is not one of a sum of dot products")),
    };
    fits(proofs.is_none_or(|p| p.len() == signs.len()), "there is not one proof for each sum of minors")?;
    for (k, (sum, relation)) in signs.iter().enumerate() {
        let proof = proofs.map_or(&direct, |p| &p[k]);
        let chart = Chart::new(domain, [sum, sum])?;
        sign::check(&chart.counted(sum, work)?, *relation, chart.region(), proof, work)?;
    }
    Ok(())
}
