//! Linear independence: the rank of the coefficient table and the shape values at which it drops.

use basis_kernel::{Domain, Relation, Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_unique;
use basis_prover::{Coordinate, Counterexample, Symmetries, Symmetry};

use std::rc::Rc;

use super::point::{domain_names, named_point};
use super::positivity::minors::determinant;
use super::premises::{self, Positive};
use super::{Said, beside};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, PolyExt, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::model::angle::{Angle, Kind};
use crate::model::bernstein::{bernstein_table, graded_table};
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};
use crate::state::verdict::{Stated, Witness};

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
        let of = super::on_part(COEFFICIENTS, number, pieces.len());
        let stated = Stated { of, statement, symmetries: symmetries.clone(), is_stronger };
        all.push(Said { stated, of: String::from(COEFFICIENTS), piece: piece.clone() });
    }
    Some(all)
}

/// What a dependence is read from where π, exp(r) and the like occur, without and with the functions times powers of
/// one of them.
const APART: [&str; 3] = [
    "table of coefficients of all powers of its numbers",
    "table of coefficients of the functions and of their multiples by a number",
    "table of coefficients of the functions and of their multiples by the powers of a number",
];

/// More rows than this are not looked at for a combination with powers of a number.
const MAX_MULTIPLES: usize = 24;

/// Dependence where numbers such as π and exp(r), or variables beside their sines, stand in the table: they become
/// columns like the powers of the domain variables. A combination that vanishes column by column vanishes whatever they
/// are; independence does not follow. To the functions their multiples by the powers of one number are added, of the
/// first one only it alone: because this number is transcendental, a combination of all of them is one of the functions
/// whose coefficients are polynomials in it and not all 0. Nothing where no number occurs, or where what is assumed is
/// no part of a box.
pub(super) fn apart(family: &Family) -> Vec<Said> {
    (0..APART.len()).filter_map(|raised| multiples_apart(family, raised)).flatten().listed()
}

/// The number by whose powers functions are multiplied: the only one that is transcendental.
fn multiplier(family: &Family) -> Option<Var> {
    let occurs = |v: &Var| {
        let of = |family: &Family| {
            family.functions.iter().any(|f| f.value.depends_on(*v))
                || family.analytic.angles.iter().any(|a| a.low.depends_on(*v) || a.width.depends_on(*v))
        };
        of(family) || family.pieces.iter().any(|piece| of(piece))
    };
    let mut all = family.analytic.transcendental().into_iter().filter(occurs);
    let only = all.next()?;
    all.next().is_none().then_some(only)
}

/// The statements with the functions times the powers of a number up to one of them.
fn multiples_apart(family: &Family, raised: usize) -> Option<Vec<Said>> {
    let factors = match raised {
        0 => vec![Poly::one()],
        _ if family.functions.len() * (raised + 1) > MAX_MULTIPLES => return None,
        _ => {
            let number = Poly::var(multiplier(family)?);
            (0..=raised).map(|k| number.pow(k as u32)).listed()
        }
    };
    let spans =
        if family.pieces.is_empty() { vec![family] } else { family.pieces.iter().map(|p| &**p).listed() };
    let mut rows: Vec<Vec<Poly>> = vec![Vec::new(); family.functions.len() * factors.len()];
    let mut has_numbers = false;
    for span in spans {
        let mut numbers = span.analytic.numbers();
        numbers.extend(span.analytic.angles.iter().filter(|a| a.itself != a.var).map(|a| a.itself));
        // The functions times one factor, the same for all.
        let mut over = Poly::one();
        for f in &span.functions {
            if over.div_exact(f.value.denom()).is_none() {
                over = &over * f.value.denom();
            }
        }
        let times = |f: &Fraction| Some(&over.div_exact(f.denom())? * f.numer());
        let all: Vec<Poly> = span.functions.iter().map(|f| times(&f.value)).collect::<Option<_>>()?;
        let all = all.iter().flat_map(|p| factors.iter().map(move |factor| p * factor)).listed();
        has_numbers |= all.iter().any(|p| numbers.iter().any(|v| p.depends_on(*v)));
        let shapes = span.shapes.iter().map(|p| p.var).filter(|v| !numbers.contains(v)).listed();
        let mut columns: Vec<Monomial> = Vec::new();
        let parts = |m: &Monomial| {
            let column = shapes.iter().fold(m.clone(), |column, v| column.with_exponent(*v, 0));
            (m.checked_div(&column).unwrap_or_else(Monomial::one), column)
        };
        columns.extend(all.iter().flat_map(Poly::terms).map(|(m, _)| parts(m).1));
        sort_unique(&mut columns);
        for (row, p) in rows.iter_mut().zip(&all) {
            let mut entries = vec![Vec::new(); columns.len()];
            for (m, c) in p.terms() {
                let (shape, column) = parts(m);
                entries[columns.binary_search(&column).ok()?].push((shape, c.clone()));
            }
            row.extend(entries.into_iter().map(Poly::from_terms));
        }
    }
    if !has_numbers {
        return None;
    }
    let pieces = family.pieces(&[], &[], true);
    let mut said = Vec::new();
    for (number, piece) in pieces.iter().enumerate().filter(|(_, piece)| piece.is_exact()) {
        let row = |row: &Vec<Poly>| row.iter().map(|p| piece.pull_back(p)).collect::<Option<Vec<Poly>>>();
        let rows = rows.iter().map(row).collect::<Option<Vec<_>>>()?;
        let statement = Statement::Independent { rows, except: Vec::new(), region: piece.domain().region };
        let of = APART[raised];
        let stated = Stated::new(super::on_part(of, number, pieces.len()), statement);
        said.push(Said { stated, of: String::from(of), piece: piece.clone() });
    }
    Some(said)
}

/// What is said of the sum of the squares of the maximal minors.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Squares {
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
pub(super) const BY_SQUARES: [Squares; 3] = [Squares::Factors, Squares::Product, Squares::Whole];

/// More functions than this have too large a determinant.
const MAX_SQUARES: usize = 6;

/// Independence as an inequality: det(A·Aᵀ), the sum of the squares of the maximal minors of the table A, is > 0 where
/// what is assumed holds and no exception is, and 0 at the exceptions. Where what is assumed is no part of a box it may decide what
/// the table on the whole box does not. `None` for many functions, and for variables beside their sines.
pub(super) fn by_squares(family: &Family, except: &[Values], of: Squares) -> Option<Vec<Said>> {
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
        let mut away = domain.clone();
        for values in except {
            let own = match &pulled_back(values, piece)?[..] {
                [] => continue,
                [own] => own.clone(),
                _ => return None,
            };
            away.premises.push((squared_distance(&own), Relation::Positive));
            let (of, statement) = (at_exception(family, values), dependent_at(&value, &domain, &own));
            let stated = Stated::new(super::on_part(&of, number, pieces.len()), statement);
            all.push(Said { stated, of, piece: piece.clone() });
        }
        let domain = Rc::new(away);
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
        let enough = |p: &Poly| if of == Squares::Plain { None } else { premises::without(&sign(p.clone())) };
        let statements = parts.into_iter().flat_map(|p| enough(&p).unwrap_or_else(|| vec![sign(p)])).listed();
        for statement in statements {
            let stated = Stated::new(super::on_part(SQUARES, number, pieces.len()), statement);
            all.push(Said { stated, of: String::from(SQUARES), piece: piece.clone() });
        }
    }
    Some(all)
}

/// What is evaluated at an exception, where it has to be 0.
fn at_exception(family: &Family, values: &Values) -> String {
    format!("{SQUARES} at {}", exception_text(family, values))
}

/// An exception as it is written, `p = 1`, of several values with brackets.
fn exception_text(family: &Family, values: &[(Var, Rational)]) -> String {
    let parts: Vec<String> = values.mapped(|(v, x)| format!("{} = {x}", family.names[v.0]));
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

/// The combination of the functions that vanishes at a point, or the exception at which they are independent.
pub(super) fn witness(
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
        .map(|(v, c)| c.describe(&family.names[v.0]))
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
        let all = except.iter().flatten().map(|(v, x)| format!("{} = {x}", family.names[v.0])).listed();
        return format!("{note}; one that needs all of these values is `except ({})`", all.join(", "));
    }
    note
}

/// The combination of functions that one of them and their multiples by the powers of a number is.
fn with_multiples(family: &Family, factors: &[Univariate], raised: usize) -> Vec<Poly> {
    let number = multiplier(family).map_or_else(Poly::one, Poly::var);
    let sum = |own: &[Univariate]| {
        let terms = own.iter().enumerate().map(|(k, c)| &Poly::constant(c.leading()) * &number.pow(k as u32));
        terms.fold(Poly::zero(), |sum, term| &sum + &term)
    };
    factors.chunks(raised + 1).map(sum).listed()
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
