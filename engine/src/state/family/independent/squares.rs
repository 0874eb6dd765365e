//! Independence as an inequality, for the sum of the squares of the maximal minors.

use basis_kernel::{Domain, Relation, Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use std::rc::Rc;

use super::super::positivity::minors::determinant;
use super::super::premises::{self, Positive};
use super::super::{Said, on_part};
use super::{SQUARES, Table, pulled_back, table};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::Kind;
use crate::state::verdict::Stated;

/// What is said of the sum of the squares of the maximal minors.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::state::family) enum Squares {
    /// That it is positive.
    Plain,
    /// What is enough for that under what is assumed.
    Whole,
    /// What is enough, as it is nowhere below 0: each of its factors is positive, up to its sign.
    Factors,
    /// The same of the product of its factors, each once.
    Product,
}

/// The ways by which independence is one of these, by their numbers from 1.
pub(in crate::state::family) const BY_SQUARES: [Squares; 3] =
    [Squares::Factors, Squares::Product, Squares::Whole];

/// More functions than this have too large a determinant.
const MAX_SQUARES: usize = 6;

/// Independence as an inequality: det(A·Aᵀ), the sum of the squares of the maximal minors of the table A, is > 0 where
/// what is assumed holds and no exception is, and 0 at the exceptions. Where what is assumed is no part of a box it may decide what
/// the table on the whole box does not; then the way away from what is assumed is given. `None` for many functions, and for variables beside their sines.
pub(in crate::state::family) fn by_squares(
    family: &Family,
    except: &[Values],
    of: Squares,
    away: &mut dyn FnMut(&Statement) -> Option<Vec<Statement>>,
) -> Option<Vec<Said>> {
    let Table { rows, .. } = table(family);
    let wide = |v: Var| {
        family.analytic.numbers().contains(&v)
            || family.analytic.angles.iter().any(|a| a.itself == v && a.var != v && a.kind != Kind::Linear)
    };
    if rows.len() > MAX_SQUARES || rows.iter().flatten().flat_map(Poly::variables).any(wide) {
        return None;
    }
    let first = except.iter().flatten().map(|(var, _)| *var).listed();
    let pieces = family.pieces(&[], &first, true);
    let mut all = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let row = |row: &Vec<Poly>| row.iter().map(|p| piece.pull_back(p)).collect::<Option<Vec<Poly>>>();
        let domain = piece.domain();
        let rows = Positive::of(&domain).of_rows(rows.iter().map(row).collect::<Option<Vec<_>>>()?);
        let value = basis_prover::working(family.budget, &mut |work| {
            let mut gram = vec![Vec::new(); rows.len()];
            for (a, line) in rows.iter().zip(&mut gram) {
                for b in &rows {
                    let mut sum = Poly::zero();
                    for (x, y) in a.iter().zip(b) {
                        work.spend_product(x, y)?;
                        sum = &sum + &(x * y);
                    }
                    line.push(Fraction::from(sum));
                }
            }
            determinant(gram, work)
        })?;
        let value = value.as_poly()?.clone();
        let mut apart = domain.clone();
        for values in except {
            let own = match &pulled_back(values, piece)?[..] {
                [] => continue,
                [own] => own.clone(),
                _ => return None,
            };
            apart.premises.push((squared_distance(&own), Relation::Positive));
            let (of, statement) = (at_exception(family, values), dependent_at(&value, &domain, &own));
            let stated = Stated::new(on_part(&of, number, pieces.len()), statement);
            all.push(Said { stated, of, piece: piece.clone() });
        }
        let domain = Rc::new(apart);
        let sign = |value: Poly| Statement::Sign {
            value: value.into(),
            relation: Relation::Positive,
            domain: Rc::clone(&domain),
        };
        let factors = if of == Squares::Plain { None } else { nonzero_factors(&value, &domain) };
        let parts = match (of, factors) {
            (Squares::Factors, Some(factors)) => factors,
            (Squares::Product, Some(factors)) => {
                vec![factors.iter().fold(Poly::one(), |product, p| &product * p)]
            }
            _ => vec![value],
        };
        for part in parts.into_iter().map(sign) {
            let enough = if of == Squares::Plain { None } else { away(&part) };
            for statement in enough.unwrap_or_else(|| vec![part]) {
                let stated = Stated::new(on_part(SQUARES, number, pieces.len()), statement);
                all.push(Said { stated, of: String::from(SQUARES), piece: piece.clone() });
            }
        }
    }
    Some(all)
}

/// What is evaluated at an exception, where it has to be 0.
pub(super) fn at_exception(family: &Family, values: &Values) -> String {
    format!("{SQUARES} at {}", exception_text(family, values))
}

/// An exception as it is written, `p = 1`, of several values with brackets.
pub(super) fn exception_text(family: &Family, values: &[(Var, Rational)]) -> String {
    let parts: Vec<String> = values.mapped(|(v, x)| family.shape_value(*v, x));
    match &parts[..] {
        [only] => only.clone(),
        several => format!("({})", several.join(", ")),
    }
}

/// The square of the distance from values of some variables, which is positive at all other points.
fn squared_distance(values: &Values) -> Poly {
    let square = |(v, x): &(Var, Rational)| (&Poly::var(*v) - &Poly::constant(x.clone())).pow(2);
    values.iter().map(square).fold(Poly::zero(), |sum, square| &sum + &square)
}

/// That a polynomial is 0 at all points of a domain that have some values.
fn dependent_at(p: &Poly, domain: &Domain, values: &Values) -> Statement {
    let at = |p: &Poly| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
    let mut domain = domain.clone();
    domain.region.ranges.retain(|(var, _)| values.iter().all(|(v, _)| v != var));
    for (premise, _) in &mut domain.premises {
        *premise = at(premise);
    }
    Statement::Zero { value: at(p).into(), domain: Rc::new(domain) }
}

/// The factors of a polynomial, each with the sign that makes it positive at some point that counts; `None` of a number, 0
/// for instance.
fn nonzero_factors(p: &Poly, domain: &Domain) -> Option<Vec<Poly>> {
    if p.as_constant().is_some() {
        return None;
    }
    let (_, factors) = basis_prover::working(1, &mut |work| checked_factor(p, work))?;
    let point = premises::inside(p, domain)?;
    let turned = |factor: Poly| if factor.eval(&point).is_negative() { -&factor } else { factor };
    Some(factors.into_iter().map(|(factor, _)| turned(factor)).listed())
}
