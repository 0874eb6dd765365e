//! Linear independence: the rank of the coefficient table and the shape values at which it drops.

mod apart;
mod squares;
mod witness;

use basis_kernel::{Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_unique;
use basis_prover::{Symmetries, Symmetry};

pub(super) use self::apart::apart;
pub(super) use self::squares::{BY_SQUARES, Squares, by_squares};
#[cfg(any(test, feature = "tools"))]
pub(crate) use self::witness::combination_text;
pub(super) use self::witness::witness;
use super::premises::Positive;
use super::{Said, beside, on_part};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::Angle;
use crate::model::bernstein::{bernstein_table, graded_table};
use crate::model::chart::Piece;
use crate::state::verdict::Stated;

/// Why nothing is said of exceptions that are no values of the variables of a box.
pub(super) const NOT_IN_PARTS: &str =
    "an exception cannot be separated from the other values that satisfy what is assumed";

/// What the claim is about, in place of an expression.
const COEFFICIENTS: &str = "table of coefficients";

/// What is evaluated where there is no combination to show.
const SQUARES: &str = "sum of the squares of the maximal minors";

/// Units of work for an entry of a table.
const ENTRY: u64 = 20;

/// Functions as the rows of a matrix of their coefficients.
#[derive(Clone, Debug)]
pub struct Table {
    /// One row for each function, all of one length.
    pub rows: Vec<Vec<Poly>>,
    /// Permutations that leave the matrix unchanged, as far as they are known.
    pub symmetries: Symmetries,
}

/// Independence on the declared ranges except for the listed shape values; at each of these the functions must be
/// dependent.
///
/// Of shape values in several parts, or in the image of a box, the same is said of the boxes; `None` where an exception
/// cannot be said with values of their variables.
pub(super) fn said(family: &Family, except: &[Values]) -> Option<Vec<Said>> {
    let Table { rows, symmetries } = table(family);
    let first = except.iter().flatten().map(|(var, _)| *var).listed();
    let pieces = family.pieces(&[], &first, true);
    let mut all = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let mut own = Vec::new();
        for values in except {
            own.extend(pulled_back(values, piece)?);
        }
        let row = |row: &Vec<Poly>| row.iter().map(|p| piece.pull_back(p)).collect::<Option<Vec<Poly>>>();
        let domain = piece.domain();
        let rows = Positive::of(&domain).of_rows(rows.iter().map(row).collect::<Option<Vec<_>>>()?);
        let (rows, region, is_stronger) = match beside::rows_between_bounds(family, &rows, &domain.region) {
            Some((rows, region)) => (rows, region, true),
            None => (rows, domain.region, false),
        };
        let statement = Statement::Independent { rows, except: own, region };
        let of = on_part(COEFFICIENTS, number, pieces.len());
        let stated = Stated { of, statement, symmetries: symmetries.clone(), is_stronger };
        all.push(Said { stated, of: String::from(COEFFICIENTS), piece: piece.clone() });
    }
    Some(all)
}

/// Values of parameters as values of the variables of a box, in as many ways as there are; `None` where they are not of
/// this kind.
fn pulled_back(values: &Values, piece: &Piece) -> Option<Vec<Values>> {
    let mut known: Vec<Values> = vec![Vec::new()];
    // Each parameter after those on which it depends.
    let order = piece.ranges.iter().filter_map(|(var, _)| values.iter().find(|(v, _)| v == var));
    for (var, x) in order {
        let difference = &piece.pull_back(&Poly::var(*var))? - &Poly::constant(x.clone());
        let mut longer = Vec::new();
        for values in &known {
            let rest = values.iter().fold(difference.clone(), |p, (v, x)| p.at(*v, x));
            if let Some(c) = rest.as_constant() {
                longer.extend(c.is_zero().then(|| values.clone()));
                continue;
            }
            let (_, factors) = basis_prover::working(1, &mut |work| checked_factor(&rest, work))?;
            for (factor, _) in factors {
                let [only] = factor.variables()[..] else { return None };
                let slope = factor.derivative(only).as_constant()?;
                let root = -&(&factor.at(only, &Rational::ZERO).as_constant()? * &slope.recip()?);
                let range = piece.ranges.iter().find(|(v, _)| *v == only).map(|(_, range)| range);
                if range.is_none_or(|range| range.contains(&root)) {
                    let mut values = values.clone();
                    values.push((only, root));
                    longer.push(values);
                }
            }
        }
        known = longer;
    }
    Some(known)
}

/// The coefficients of all functions on the whole domain, one row for each function.
pub fn table(family: &Family) -> Table {
    if family.pieces.is_empty() { coefficient_table(family) } else { table_of_spans(family) }
}

/// The tables of all spans beside one another.
fn table_of_spans(family: &Family) -> Table {
    let mut rows: Vec<Vec<Poly>> = vec![Vec::new(); family.functions.len()];
    for piece in &family.pieces {
        for (row, more) in rows.iter_mut().zip(coefficient_table(piece).rows) {
            row.extend(more);
        }
    }
    Table { rows, symmetries: Symmetries::new() }
}

/// The coefficients of the numerators of all functions, one row for each; denominators vanish nowhere. On an
/// interval in the Bernstein basis, or in powers if that makes the table triangular; on a simplex in homogeneous
/// monomials, in which more of them are numbers.
fn coefficient_table(family: &Family) -> Table {
    // An angle beside its sine is one more variable of the domain.
    let numerators = family.numerators();
    // A table is made for every claim, and kept with its proof.
    basis_prover::charge(numerators.iter().map(|p| ENTRY * p.len() as u64).sum());
    let (over_domain, constant): (Vec<&Angle>, Vec<&Angle>) =
        family.analytic.angles.iter().partition(|a| family.domain.iter().any(|p| p.var == a.var));
    let mixed = over_domain.iter().any(|a| numerators.iter().any(|p| p.depends_on(a.itself)));
    if let Some(rows) = graded_table(family).filter(|_| !mixed) {
        return Table { rows, symmetries: Symmetries::new() };
    }
    if let Some(rows) = bernstein_table(family).filter(|_| !mixed) {
        let reversed = |len: usize| (0..len).rev().listed();
        let width = rows.first().map_or(0, Vec::len);
        let symmetries = vec![vec![Symmetry { rows: reversed(rows.len()), columns: reversed(width) }]];
        return Table { rows, symmetries };
    }
    let domain: Vec<Var> = family.domain.iter().map(|p| p.var).listed();
    // The shape parameters are the first variables.
    let mut constants: Vec<Var> = (0..family.shapes.len()).map(Var).listed();
    constants.extend(family.analytic.numbers());
    constants.extend(constant.iter().map(|a| a.itself));
    let parts_of = |m: &Monomial| {
        let others = constants.iter().fold(m.clone(), |others, v| others.with_exponent(*v, 0));
        (m.checked_div(&others).unwrap_or_else(Monomial::one), others)
    };
    let domain_degree = |m: &Monomial| parts_of(m).1.total_degree() as u16;
    let terms = numerators.iter().flat_map(Poly::terms);
    let degree = terms.map(|(m, _)| domain_degree(m)).max().unwrap_or(0);
    // On a simplex times powers of u + v + w = 1; w is not written, its exponent is what the others leave of the
    // degree.
    let mut powers = vec![Poly::one()];
    if family.is_simplex() {
        let sum = domain.iter().fold(Poly::one(), |sum, v| &sum + &Poly::var(*v));
        for k in 0..usize::from(degree) {
            powers.push(&powers[k] * &sum);
        }
    }
    let row = |p: &Poly| -> SortedMap<Monomial, Poly> {
        let mut parts = vec![Vec::new(); powers.len()];
        for (m, c) in p.terms() {
            let missing = if family.is_simplex() { usize::from(degree - domain_degree(m)) } else { 0 };
            parts[missing].push((m.clone(), c.clone()));
        }
        let raised = parts.into_iter().zip(&powers).map(|(part, power)| &Poly::from_terms(part) * power);
        let mut terms: SortedMap<Monomial, Vec<(Monomial, Rational)>> = SortedMap::new();
        for (m, c) in raised.fold(Poly::zero(), |sum, p| &sum + &p).terms() {
            let (shape, column) = parts_of(m);
            terms.get_or_insert_with(column, Vec::new).push((shape, c.clone()));
        }
        let mut row = SortedMap::new();
        for (column, terms) in terms {
            row.insert(column, Poly::from_terms(terms));
        }
        row
    };
    let rows: Vec<SortedMap<Monomial, Poly>> = numerators.mapped(row);
    let mut columns: Vec<&Monomial> = rows.iter().flat_map(SortedMap::keys).listed();
    sort_unique(&mut columns);
    let symmetries = if family.is_simplex() {
        let exponents = |m: &&Monomial| {
            let mut all: Vec<u16> = domain.iter().map(|v| m.exponent(*v)).listed();
            all.push(degree - domain_degree(m));
            all
        };
        exchanges(family, &columns.iter().map(exponents).listed())
    } else {
        Symmetries::new()
    };
    let filled =
        rows.iter().map(|row| columns.iter().map(|c| row.get(*c).cloned().unwrap_or_default()).listed());
    Table { rows: filled.listed(), symmetries }
}

/// For each corner of a simplex the exchanges with those before it, of indices and exponents alike.
fn exchanges(family: &Family, columns: &[Vec<u16>]) -> Symmetries {
    let corners = family.domain.len() + 1;
    let swapped = |index: &Vec<i64>, a: usize, b: usize| {
        let mut index = index.clone();
        index.swap(a, b);
        family.functions.iter().position(|f| f.index == index)
    };
    let exchange = |a: usize, b: usize| {
        let indices = family.functions.iter().map(|f| &f.index);
        let rows = indices
            .map(|i| if i.len() == corners { swapped(i, a, b) } else { None })
            .collect::<Option<_>>()?;
        let moved = columns.iter().map(|c| {
            let mut column = c.clone();
            column.swap(a, b);
            columns.binary_search(&column).ok()
        });
        Some(Symmetry { rows, columns: moved.collect::<Option<_>>()? })
    };
    let sums = (1..corners).map(|k| (0..k).map(|j| exchange(j, k)).collect::<Option<Vec<_>>>());
    sums.collect::<Option<Symmetries>>().unwrap_or_default()
}
