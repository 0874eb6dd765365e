//! The shape values at which the functions of a family are linearly dependent.

mod equations;

pub use equations::{Dependence, dependence};

use basis_kernel::{Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::rank::{Exceptional, ExceptionalSet, Table};
use basis_prover::{Coordinate, decide};

use super::shape_values;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::claim::ClaimKind;
use crate::model::Family;
use crate::state::{self, Verdict};

/// The work for the shape values at which functions are dependent, of which each is looked for with a budget of its own.
const EXCEPTIONS: u64 = 20_000_000;

/// The shape values at which the functions of a family are dependent, and what is left open: nothing only if it is
/// proved that they are independent everywhere else.
pub fn exceptional_set(family: &Family) -> ExceptionalSet {
    let units = EXCEPTIONS.saturating_mul(u64::from(family.budget));
    basis_prover::within(units, &mut || exceptions(family))
}

fn exceptions(family: &Family) -> ExceptionalSet {
    let state::Table { rows, symmetries } = state::table(family);
    let table = Table { rows: &rows, symmetries: &symmetries };
    let mut set = basis_prover::rank::exceptional_set(table, &family.shape_region(), family.budget);
    set.exceptions.retain(|e| shape_values::exist(family, &e.values));
    let dependent = family.analytic.dependent();
    if rows.iter().flatten().any(|p| dependent.iter().any(|v| p.depends_on(*v))) {
        // Where an angle and its tangent have values that do not belong together nothing is said.
        set.exceptions.retain(|e| !e.values.iter().any(|(var, _)| dependent.contains(var)));
        set.open = rational_values(&set)
            .map_or_else(|| Some(String::from(OTHERS)), |except| open_besides(family, except));
        return set;
    }
    let everywhere = set.exceptions.iter().any(|e| e.values.is_empty());
    let Some(except) = rational_values(&set).filter(|_| !everywhere) else { return set };
    if !family.constraints.is_empty() {
        // On the whole box the functions may be dependent where what is assumed is false.
        decide_besides(family, &mut set, except);
    } else if set.open.is_none() {
        let statement = Statement::Independent { rows, except, region: family.shape_region() };
        if decide(statement, &symmetries, family.budget).is_err() {
            set.open = Some(String::from(OTHERS));
        }
    }
    set
}

/// The values of all exceptions, if they are rational.
fn rational_values(set: &ExceptionalSet) -> Option<Vec<Values>> {
    set.exceptions.iter().map(|e| shape_values::as_rational(&e.values)).collect()
}

/// What is left open of exceptions that may not be all.
const OTHERS: &str = "it is not proved that there are no others";

/// What is left open where functions are said to be independent but for these exceptions.
fn open_besides(family: &Family, except: Vec<Values>) -> Option<String> {
    match super::verdict(family, ClaimKind::Independent(except)) {
        Verdict::Proved(_) => None,
        _ => Some(String::from(OTHERS)),
    }
}

/// Counterexamples to independence that are looked for beside the exceptions of the whole box.
const MORE: usize = 4;

/// Whether the claim is proved that functions are independent but for these exceptions; counterexamples to it are further
/// ones.
fn decide_besides(family: &Family, set: &mut ExceptionalSet, mut except: Vec<Values>) {
    set.open = Some(String::from(OTHERS));
    for _ in 0..MORE {
        let witness = match super::verdict(family, ClaimKind::Independent(except.clone())) {
            Verdict::Proved(_) => {
                set.open = None;
                return;
            }
            Verdict::Refuted(witness) => witness,
            Verdict::Undecided(_) => return,
        };
        let point = shape_values::of_witness(family, &witness);
        let Some(exception) = point.and_then(|point| exception_at(family, &point)) else { return };
        let Some(values) = shape_values::as_rational(&exception.values) else { return };
        if except.contains(&values) {
            return;
        }
        set.exceptions.push(exception);
        except.push(values);
    }
}

/// As few of the coordinates of a point as make the functions dependent; `None` where they are independent.
fn exception_at(family: &Family, point: &Values) -> Option<Exceptional> {
    let rows = state::table(family).rows;
    let n = point.len().min(6);
    for size in 0..=n as u32 {
        for subset in (0_u32..1 << n).filter(|s| s.count_ones() == size) {
            let kept = |(k, value): (usize, &(Var, Rational))| (subset >> k & 1 == 1).then(|| value.clone());
            let values = point.iter().enumerate().filter_map(kept).listed();
            let put = |p: &Poly| values.iter().fold(p.clone(), |p, (var, x)| p.at(*var, x));
            let rows = rows.mapped(|row| row.mapped(put));
            let table = Table { rows: &rows, symmetries: &Vec::new() };
            let mut found =
                basis_prover::rank::exceptional_set(table, &family.shape_region(), family.budget).exceptions;
            // There is one without values where they are dependent for all values of the others.
            let Some(generic) = found.pop().filter(|e| e.values.is_empty()) else { continue };
            let values = values.mapped(|(var, x)| (*var, Coordinate::Rational(x.clone())));
            return Some(Exceptional { values, combination: generic.combination });
        }
    }
    None
}

/// What an element of the exceptional set says, such as `λ = -3: b[1] - b[2] = 0`.
pub fn describe_exception(family: &Family, exception: &Exceptional) -> String {
    let shown = |(v, c): &(Var, Coordinate)| match c {
        Coordinate::Rational(x) => family.shape_value(*v, x),
        Coordinate::Algebraic(_) => c.describe(&family.names[v.0]),
    };
    let values = exception.values.iter().map(shown).collect::<Vec<_>>();
    let at = if values.is_empty() { String::from("all shape values") } else { values.join(", ") };
    let Some(combination) = &exception.combination else { return at };
    format!("{at}: {} = 0", relation(family, combination, &exception.values))
}

/// The combination of the functions that vanishes at some shape values.
fn relation(family: &Family, combination: &[Poly], values: &[(Var, Coordinate)]) -> String {
    let fixed = |p: &Poly| {
        values.iter().fold(p.clone(), |p, (v, c)| match c {
            Coordinate::Rational(x) => p.at(*v, x),
            Coordinate::Algebraic(_) => p,
        })
    };
    let scaled: Vec<Poly> =
        combination.iter().enumerate().map(|(k, c)| c * &fixed(&family.numerator_factor(k))).collect();
    state::combination_text(family, &scaled)
}
