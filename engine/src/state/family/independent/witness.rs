//! Witnesses of dependence, and of exceptions at which functions are independent.

use basis_kernel::{Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Counterexample};

use super::super::beside;
use super::super::point::{domain_names, named_point};
use super::apart::{APART, with_multiples};
use super::squares::{at_exception, exception_text};
use super::{COEFFICIENTS, SQUARES, pulled_back};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};
use crate::state::verdict::Witness;

/// The combination of the functions that vanishes at a point, or the exception at which they are independent.
pub(in crate::state::family) fn witness(
    family: &Family,
    except: &[Values],
    label: &str,
    found: &Counterexample,
    piece: &Piece,
) -> Witness {
    let own = except.iter().find(|values| label == at_exception(family, values));
    let own_values = own.into_iter().flatten().map(|(v, x)| (*v, Fraction::constant(x.clone()))).listed();
    let at = named_point(family, found, &own_values, piece);
    let refutation = found.refutation.clone();
    let point: Vec<(Var, Coordinate)> = if piece.steps.is_empty() && own.is_none() {
        found.point.clone()
    } else {
        let own =
            |p: &Parameter| at.iter().find(|(name, _)| *name == p.name).map(|(_, c)| (p.var, c.clone()));
        family.shapes.iter().filter_map(own).listed()
    };
    let described: Vec<String> = point
        .iter()
        .filter(|(v, _)| family.shapes.iter().any(|s| s.var == *v))
        .map(|(v, c)| match c {
            Coordinate::Rational(x) => family.shape_value(*v, x),
            Coordinate::Algebraic(_) => c.describe(&family.names[v.0]),
        })
        .listed();
    let rational: Option<Vec<Rational>> = point
        .iter()
        .map(|(_, c)| match c {
            Coordinate::Rational(x) => Some(x.clone()),
            Coordinate::Algebraic(_) => None,
        })
        .collect();
    let here = if described.is_empty() { String::new() } else { format!(" at {}", described.join(", ")) };
    let (of, value, note) = match (found.refutation.witness(), rational) {
        (basis_kernel::Witness::Independent(_, number), _) => {
            // Of an exception there may be several in the box.
            let mut left = *number;
            let own = except.iter().find(|values| {
                let count = pulled_back(values, piece).map_or(0, |all| all.len());
                let found = left < count;
                left = left.saturating_sub(count);
                found
            });
            let values = own.map(Vec::as_slice).unwrap_or_default();
            let note = no_exception(family, except, values, &here);
            (String::from(SQUARES), squares(found), note)
        }
        (basis_kernel::Witness::Dependent(_, factors), Some(rational)) => {
            // The rows are multiples of the functions.
            let mut coordinates = vec![Rational::ZERO; family.names.len()];
            for ((var, _), x) in point.iter().zip(rational) {
                if let Some(slot) = coordinates.get_mut(var.0) {
                    *slot = x;
                }
            }
            let own = |k: usize, c: &Univariate| {
                Poly::constant(&c.leading() * &family.numerator_factor(k).eval(&coordinates))
            };
            let scaled = match APART.iter().position(|own| *own == label) {
                Some(raised) => with_multiples(family, factors, raised),
                None => factors.iter().enumerate().map(|(k, c)| own(k, c)).listed(),
            };
            let of = combination_text(family, &scaled);
            let note = format!("`{of}` vanishes identically{here}");
            (of, Rational::ZERO, note)
        }
        _ => match own {
            Some(values) => {
                let note = no_exception(family, except, values, &here);
                let value = found.value().map_or(Rational::ZERO, |(value, _)| value);
                (String::from(SQUARES), value, note)
            }
            None => {
                let note = format!("the functions are linearly dependent{here}");
                (String::from(SQUARES), Rational::ZERO, note)
            }
        },
    };
    let stated = match found.refutation.statement() {
        Statement::Sign { .. } | Statement::Zero { .. } => label,
        _ => APART.into_iter().find(|own| *own == label).unwrap_or(COEFFICIENTS),
    };
    let mut witness = Witness::new(of, at, value, refutation).about(stated);
    witness.places = beside::places(family, &[], &witness.at, &point);
    witness.idle = domain_names(family);
    witness.notes = vec![note];
    witness
}

/// Why an exception is none.
fn no_exception(family: &Family, except: &[Values], values: &[(Var, Rational)], here: &str) -> String {
    let exception = exception_text(family, values);
    let note = format!("the functions are independent{here}, so {exception} is no exception");
    // `except α = -3, β = 0` is two exceptions.
    let single = |values: &Values| if let [(var, _)] = values[..] { Some(var) } else { None };
    if let [first, others @ ..] = except
        && others.iter().any(|other| single(other) != single(first))
        && except.iter().all(|values| single(values).is_some())
    {
        let all = except.iter().flatten().map(|(v, x)| family.shape_value(*v, x)).listed();
        return format!("{note}; one that needs all of these values is `except ({})`", all.join(", "));
    }
    note
}

/// The determinant of the matrix of the rows at a rational point times its transpose, by elimination.
fn squares(found: &Counterexample) -> Rational {
    let Statement::Independent { rows, .. } = found.refutation.statement() else { return Rational::ZERO };
    let at = |p: &Poly| {
        found.point.iter().fold(p.clone(), |p, (v, c)| match c {
            Coordinate::Rational(x) => p.at(*v, x),
            Coordinate::Algebraic(_) => p,
        })
    };
    let numbers: Vec<Vec<Rational>> =
        rows.mapped(|row| row.mapped(|p| at(p).as_constant().unwrap_or(Rational::ZERO)));
    let product =
        |a: &[Rational], b: &[Rational]| a.iter().zip(b).fold(Rational::ZERO, |s, (x, y)| &s + &(x * y));
    let mut rows: Vec<Vec<Rational>> = numbers.mapped(|a| numbers.mapped(|b| product(a, b)));
    // A matrix of this kind is positive definite: its pivots stand on the diagonal.
    let mut determinant = Rational::ONE;
    for k in 0..rows.len() {
        let pivot = rows[k].clone();
        determinant *= &pivot[k];
        for row in &mut rows[k + 1..] {
            let Some(factor) = row[k].checked_div(&pivot[k]) else { return Rational::ZERO };
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x -= &(p * &factor);
            }
        }
    }
    determinant
}

/// `b[1] - 2*b[2]`, numbers made whole; factors of several terms in brackets.
pub(crate) fn combination_text(family: &Family, factors: &[Poly]) -> String {
    let content = factors.iter().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
    let whole = content.recip().unwrap_or(Rational::ONE);
    let mut text = String::new();
    for (k, factor) in factors.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
        let factor = factor.scale(&whole);
        let shown = factor.display(&family.names).to_string();
        let negative = factor.len() == 1 && shown.starts_with('-');
        let magnitude = if negative { -&factor } else { factor };
        text += match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        if magnitude.len() > 1 {
            text += &format!("({})*", magnitude.display(&family.names));
        } else if !magnitude.is_one() {
            text += &format!("{}*", magnitude.display(&family.names));
        }
        text += &family.function_label(k);
    }
    text
}
