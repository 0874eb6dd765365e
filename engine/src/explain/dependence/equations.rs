//! Dependence along lines and curves of shape values: where a common factor of all maximal minors of the coefficients
//! vanishes, functions are dependent.

use basis_prover::algebra::matrix::minor;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::rank::{Exceptional, ExceptionalSet};

use super::super::shape_values;
use super::{describe_exception, relation};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::divisors::gcd::gcd;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::state;
use crate::weights::{zero, zeros};

/// The work for minors and their factors.
const WORK: u64 = 2_000_000;

/// More minors are not looked at.
const MAX_MINORS: usize = 80;

/// Points that are stated of infinitely many.
const MAX_POINTS: usize = 4;

/// Where functions are dependent, in words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dependence {
    /// Values or equations, perhaps with the combination that vanishes, such as `λ = -3: b[1] - b[2] = 0` or `a + b = 1`.
    pub at: Vec<String>,
    /// What is left open; `None` when these are all.
    pub open: Option<String>,
}

/// The shape values at which the functions of a family are linearly dependent, those on lines and curves by equations.
pub fn dependence(family: &Family) -> Dependence {
    let set = super::exceptional_set(family);
    if set.open.is_some() && !set.exceptions.is_empty() {
        if let Some(found) = along(family, &set) {
            return found;
        }
        // Of many points some with short numbers.
        let mut texts = set.exceptions.mapped(|e| describe_exception(family, e));
        basis_prover::collections::sort::sort_by_key(&mut texts, |text| text.chars().count());
        texts.truncate(MAX_POINTS);
        return Dependence { at: texts, open: set.open };
    }
    Dependence { at: set.exceptions.mapped(|e| describe_exception(family, e)), open: set.open }
}

/// The same with equations; `None` where there are none.
fn along(family: &Family, set: &ExceptionalSet) -> Option<Dependence> {
    let rows = state::table(family).rows;
    let is_shape = |v: &Var| v.0 < family.shapes.len();
    if !family.analytic.is_empty() || !rows.iter().flatten().all(|p| p.variables().iter().all(is_shape)) {
        return None;
    }
    let work = &mut Work::new(WORK);
    let minors = minors(&rows, work)?;
    let common = minors.iter().fold(Poly::zero(), |common, p| gcd(&common, p));
    if common.is_zero() || common.as_constant().is_some() {
        return None;
    }
    let points: Vec<(&Exceptional, Vec<(Var, _)>)> =
        set.exceptions.iter().filter_map(|e| Some((e, shape_values::as_rational(&e.values)?))).listed();
    let lies_on = |factor: &Poly, e: &Exceptional| {
        let values = points.iter().find(|(known, _)| *known == e).map(|(_, values)| values);
        let at = |values: &Vec<(Var, _)>| values.iter().fold(factor.clone(), |p, (var, x)| p.at(*var, x));
        values.is_some_and(|values| at(values).is_zero())
    };
    let mut found = Dependence::default();
    let mut factors = Vec::new();
    // Beside the factors there are no others where a minor is a multiple of them by a number.
    let mut is_open = !minors.iter().any(|p| p.div_exact(&common).is_some_and(|q| q.as_constant().is_some()));
    for (factor, _) in checked_factor(&common, work)?.1 {
        let mut own = set.exceptions.iter().filter(|e| lies_on(&factor, e));
        let Some(first) = own.next() else {
            is_open |= !vanishes_nowhere(family, &factor);
            continue;
        };
        let vanishing = first.combination.as_ref().filter(|c| vanishes(&rows, c, &factor));
        let combination = vanishing.map(|c| format!(": {} = 0", relation(family, c, &[])));
        found.at.push(format!("{}{}", equation(family, &factor), combination.unwrap_or_default()));
        factors.push(factor);
    }
    if factors.is_empty() {
        return None;
    }
    if is_open {
        let others = set.exceptions.iter().filter(|e| !factors.iter().any(|factor| lies_on(factor, e)));
        found.at.extend(others.map(|e| describe_exception(family, e)).take(MAX_POINTS));
        found.open = Some(String::from(super::OTHERS));
    }
    Some(found)
}

/// All maximal minors that are not the zero polynomial.
fn minors(rows: &[Vec<Poly>], work: &mut Work) -> Option<Vec<Poly>> {
    let width = rows.first()?.len();
    let columns = (0..width).filter(|k| rows.iter().any(|row| !row[*k].is_zero())).listed();
    let mut choices: Vec<Vec<usize>> = vec![Vec::new()];
    for (place, column) in columns.iter().enumerate() {
        let mut more = Vec::new();
        for choice in &choices {
            let missing = rows.len() - choice.len();
            if missing > 0 {
                more.push([&choice[..], &[*column]].concat());
            }
            if missing < columns.len() - place {
                more.push(choice.clone());
            }
        }
        choices = more;
        if choices.len() > MAX_MINORS {
            return None;
        }
    }
    choices.retain(|choice| choice.len() == rows.len());
    let mut all = Vec::new();
    for choice in choices {
        let value = minor(rows, &choice, work)?;
        if !value.is_zero() {
            all.push(value);
        }
    }
    Some(all)
}

/// Whether a combination of the rows vanishes wherever a polynomial does.
fn vanishes(rows: &[Vec<Poly>], combination: &[Poly], factor: &Poly) -> bool {
    let width = rows.first().map_or(0, Vec::len);
    (0..width).all(|k| {
        let terms = rows.iter().zip(combination);
        let sum = terms.fold(Poly::zero(), |sum, (row, c)| &sum + &(c * &row[k]));
        sum.is_zero() || sum.div_exact(factor).is_some()
    })
}

fn vanishes_nowhere(family: &Family, factor: &Poly) -> bool {
    zeros(factor, &family.shape_region(), family.budget).is_empty()
        || shape_values::vanishes_nowhere(family, factor)
}

/// `a + b = 1`, `x = y`
fn equation(family: &Family, factor: &Poly) -> String {
    if factor.variables().len() < 2 {
        return zero(factor, &family.names);
    }
    let constant = factor.variables().iter().fold(factor.clone(), |p, v| p.at(*v, &Rational::ZERO));
    let constant = constant.as_constant().unwrap_or(Rational::ZERO);
    let sides = |p: &Poly, c: &Rational| {
        let positive = |wanted: bool| {
            let own = p.terms().filter(|(_, c)| c.is_positive() == wanted);
            Poly::from_terms(own.map(|(m, c)| (m.clone(), c.abs())))
        };
        let (above, below) = (positive(true), positive(false));
        let show = |p: &Poly| p.display(&family.names).to_string();
        if c.is_zero() && !above.is_zero() && !below.is_zero() {
            return format!("{} = {}", show(&above), show(&below));
        }
        format!("{} = {c}", show(p))
    };
    let rest = factor - &Poly::constant(constant.clone());
    if rest.display(&family.names).to_string().starts_with('-') {
        sides(&-&rest, &constant)
    } else {
        sides(&rest, &-constant)
    }
}
