//! Total positivity: all minors of (b[j](t_i)) are ≥ 0 for t_0 < t_1 < ….
//!
//! The functions are combinations of the Bernstein basis, b = A·B, and the minors of a product are sums of products of
//! minors (Cauchy and Binet). Those of B are ≥ 0; so those of b are if those of A are. A is totally nonnegative if Neville
//! elimination, of A and then of the transpose of what is left, subtracts nonnegative multiples of neighbouring rows only
//! and leaves nonnegative numbers: A is then a product of totally nonnegative matrices. With shape parameters the
//! multiples are rational functions. Where one of them has no value the minors are limits of minors that are ≥ 0.
//!
//! In a basis of higher degree A may be totally nonnegative where it is not in one of lower degree; whether the degree is
//! raised, and how often, is seen from some shape values, and proved for all. A claim is false if one minor of the
//! functions is negative at some points.

use std::rc::Rc;

use basis_kernel::{Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Failure, Symmetries, candidates, decide, refute};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::model::bernstein::bernstein_table;
use crate::model::chart::Piece;
use crate::model::{Family, Function};
use crate::state::family::point::{domain_names, named_point};
use crate::state::family::{Said, on_part, premises};
use crate::state::verdict::{Stated, Witness};

/// How often the degree is raised at most.
const MAX_RAISED: usize = 12;

/// The most functions of a minor that is looked for; beyond, a claim that is not proved is left undecided.
pub(in crate::state::family) const MAX_FUNCTIONS: usize = 24;

/// What is left to decide when there is neither a proof nor a negative minor.
pub(in crate::state::family) const OPEN: &str = "no conversion matrix to a Bernstein basis was found to be totally nonnegative, and no minor of the functions to be negative";

/// What is said of more functions than are looked at.
pub(in crate::state::family) const TOO_MANY: &str = "there are more minors than the budget allows";

/// A step of the elimination on a part of the shape values: what has to be ≥ 0.
struct Step {
    /// The number of the part.
    number: usize,
    piece: Piece,
    of: String,
    statement: Statement,
}

/// The statements from which total positivity follows; `None` when the work is spent or there is no elimination.
pub(in crate::state::family) fn said(family: &Family, work: &mut Work) -> Option<Vec<Said>> {
    let parts = family.pieces(&[], &[], true).len();
    let mut all = Vec::new();
    for Step { number, piece, of, statement } in steps(family, work)? {
        let enough = premises::without(&statement).unwrap_or_else(|| vec![statement]);
        for statement in enough {
            // A matrix in another basis may have a step below 0.
            let stated = Stated::new(on_part(&of, number, parts), statement);
            let stated = Stated { is_stronger: true, ..stated };
            all.push(Said { stated, of: of.clone(), piece: piece.clone() });
        }
    }
    Some(all)
}

/// The steps of the elimination on all parts.
fn steps(family: &Family, work: &mut Work) -> Option<Vec<Step>> {
    let table = bernstein_table(family)?;
    let pieces = family.pieces(&[], &[], true);
    let mut all = Vec::new();
    for (number, piece) in pieces.iter().enumerate() {
        let domain = Rc::new(piece.domain());
        let mut points = samples(piece);
        points.retain(|point| counts(point, &domain.premises));
        let mut rows = signed(family, piece, &table, points.first()?)?;
        for row in &mut rows {
            for entry in row.iter_mut() {
                *entry = piece.pull_back(entry)?;
            }
        }
        let mut best = rows.clone();
        for raised in 0..=MAX_RAISED {
            if points.iter().all(|point| is_nonnegative(&rows, point, work)) {
                best = rows;
                break;
            }
            if raised == MAX_RAISED {
                break;
            }
            rows = rows.mapped(|row| raise(row));
        }
        for (k, value) in elimination(fractions(&best), work)?.into_iter().enumerate() {
            let (relation, domain) = (Relation::NonNegative, Rc::clone(&domain));
            let statement = Statement::Sign { value: value.quotient(), relation, domain };
            let of = format!("step {} of the elimination", k + 1);
            all.push(Step { number, piece: piece.clone(), of, statement });
        }
    }
    Some(all)
}

/// Whether premises hold at a point of a box.
fn counts(point: &[(Var, Rational)], premises: &[(Poly, Relation)]) -> bool {
    let at = |p: &Poly| point.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x)).as_constant();
    premises.iter().all(|(g, sign)| at(g).is_none_or(|value| sign.holds(&value)))
}

/// The rows of a table of numerators, each with the sign of what stands below it; `None` where that may be another one elsewhere,
/// as 1/p where p² ≥ 1/4.
fn signed(
    family: &Family,
    piece: &Piece,
    table: &[Vec<Poly>],
    sample: &[(Var, Rational)],
) -> Option<Vec<Vec<Poly>>> {
    let below =
        |f: &Function| if family.is_rational() { family.over.clone() } else { f.value.denom().clone() };
    if !piece.is_exact() && family.functions.iter().any(|f| below(f).as_constant().is_none()) {
        return None;
    }
    let mut point = vec![Rational::ZERO; family.names.len()];
    for (var, c) in piece.image(&sample.mapped(|(v, x)| (*v, Coordinate::Rational(x.clone())))) {
        if let Coordinate::Rational(x) = c {
            *point.get_mut(var.0)? = x;
        }
    }
    for variable in &family.domain {
        *point.get_mut(variable.var.0)? = basis_prover::typical(&variable.range);
    }
    let mut rows = Vec::new();
    for (row, f) in table.iter().zip(&family.functions) {
        let sign = below(f).eval(&point).signum();
        if sign == 0 {
            return None;
        }
        rows.push(row.mapped(|p| p.scale(&Rational::from(i64::from(sign)))));
    }
    Some(rows)
}

/// The coefficients in the Bernstein basis of the next degree.
fn raise(row: &[Poly]) -> Vec<Poly> {
    let degree = row.len() as i64;
    let part = |k: usize, factor: i64| {
        row.get(k).map_or_else(Poly::zero, |p| p.scale(&Rational::new(factor, degree)))
    };
    let entry = |k: usize| {
        let before = if k == 0 { Poly::zero() } else { part(k - 1, k as i64) };
        &before + &part(k, degree - k as i64)
    };
    (0..=row.len()).map(entry).listed()
}

/// Some points of a box, away from its ends, with different numbers for different variables.
fn samples(piece: &Piece) -> Vec<Vec<(Var, Rational)>> {
    const POINTS: usize = 6;
    let point = |k: usize| {
        let coordinate = |(n, (var, range)): (usize, &(Var, crate::algebra::range::Range))| {
            let all = candidates(range, (POINTS + piece.ranges.len()) as u32);
            (*var, all[(k * (n + 1) + n) % all.len()].clone())
        };
        piece.ranges.iter().enumerate().map(coordinate).listed()
    };
    (0..if piece.ranges.is_empty() { 1 } else { POINTS }).map(point).listed()
}

/// Whether the elimination of a matrix at a point finds nothing negative.
fn is_nonnegative(rows: &[Vec<Poly>], point: &[(Var, Rational)], work: &mut Work) -> bool {
    let at = |p: &Poly| point.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
    let numbers = rows.mapped(|row| row.mapped(at));
    let all = elimination(fractions(&numbers), work);
    all.is_some_and(|all| all.iter().all(|f| f.as_constant().is_some_and(|c| !c.is_negative())))
}

fn fractions(rows: &[Vec<Poly>]) -> Vec<Vec<Fraction>> {
    rows.mapped(|row| row.mapped(|p| Fraction::from(p.clone())))
}

/// Neville elimination of a matrix, and of the transpose of what is left: everything that has to be ≥ 0; `None` when it
/// needs an exchange of rows, or the work is spent.
pub(in crate::state::family) fn elimination(
    mut rows: Vec<Vec<Fraction>>,
    work: &mut Work,
) -> Option<Vec<Fraction>> {
    let mut all = Vec::new();
    for _ in 0..2 {
        echelon(&mut rows, &mut all, work)?;
        let width = rows.first().map_or(0, Vec::len);
        rows = (0..width).map(|k| rows.iter().map(|row| row[k].clone()).listed()).listed();
    }
    // What is left has one entry at most in every row and column, each to the right of those above it.
    let mut last = None;
    for row in &rows {
        let mut places = (0..row.len()).filter(|k| !row[*k].is_zero());
        let Some(place) = places.next() else { continue };
        if places.next().is_some() || last.is_some_and(|last| place <= last) {
            return None;
        }
        last = Some(place);
        all.push(row[place].clone());
    }
    Some(all)
}

/// Brings a matrix into echelon form by subtracting multiples of the row above; adds these multiples. Rows of zeros are
/// left out.
fn echelon(rows: &mut Vec<Vec<Fraction>>, all: &mut Vec<Fraction>, work: &mut Work) -> Option<()> {
    let width = rows.first().map_or(0, Vec::len);
    let mut done = 0;
    for column in 0..width {
        // A row of zeros takes part in no minor that is not zero.
        rows.retain(|row| row.iter().any(|f| !f.is_zero()));
        for k in (done + 1..rows.len()).rev() {
            if rows[k][column].is_zero() {
                continue;
            }
            let factor = rows[k][column].div_within(&rows[k - 1][column], work).ok()??;
            let (above, below) = rows.split_at_mut(k);
            subtract(&mut below[0][column..], &above[k - 1][column..], &factor, work)?;
            all.push(factor);
        }
        if done < rows.len() && !rows[done][column].is_zero() {
            done += 1;
        }
    }
    Some(())
}

/// Subtracts a multiple of a row.
fn subtract(row: &mut [Fraction], other: &[Fraction], factor: &Fraction, work: &mut Work) -> Option<()> {
    for (x, y) in row.iter_mut().zip(other).filter(|(_, y)| !y.is_zero()) {
        *x = x.sub_within(&factor.mul_within(y, work)?, work)?;
    }
    Some(())
}

/// The minor of functions at points of the domain, as a function of the shape parameters, on each part of their values.
///
/// # Errors
/// What is wrong with the points, the first list, or with the numbers of the functions, the second.
pub(in crate::state::family) fn instances(
    family: &Family,
    given: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    let [points, functions] = given else { return Err("a minor has points and functions") };
    let range = family.domain.first().map(|p| &p.range).ok_or("there is no domain")?;
    let rising = |list: &[Rational]| list.windows(2).all(|pair| pair[0] < pair[1]);
    let numbers: Option<Vec<usize>> = functions
        .iter()
        .map(|k| usize::try_from(k.to_i64()?).ok().filter(|k| *k < family.functions.len()))
        .collect();
    let numbers = numbers.ok_or("there is no such function")?;
    if points.is_empty() || points.len() != numbers.len() || !rising(points) || !rising(functions) {
        return Err("points and functions of a minor are as many, in ascending order");
    }
    if points.len() > MAX_FUNCTIONS || !points.iter().all(|t| range.contains(t)) {
        return Err("the points of a minor lie in the domain");
    }
    let value = minor(family, &numbers, points).ok_or("the minor has no value")?;
    if family.analytic.dependent().into_iter().any(|v| value.depends_on(v)) {
        return Err(
            "the sign of a minor with pi, exp or a variable beside its sine in it is not shown by one point",
        );
    }
    let pieces = family.pieces(&[], &[], true);
    let stated = |(number, piece): (usize, &Piece)| {
        let of = on_part(&label(family, &numbers, points), number, pieces.len());
        let (value, domain) = (piece.pull_back_fraction(&value)?, Rc::new(piece.domain()));
        Some(Stated::new(of, Statement::Sign { value, relation: Relation::NonNegative, domain }))
    };
    let all: Option<Vec<Stated>> = pieces.iter().enumerate().map(stated).collect();
    all.ok_or("the minor has too many terms")
}

/// The determinant of the values of functions at points.
fn minor(family: &Family, functions: &[usize], points: &[Rational]) -> Option<Fraction> {
    let var = family.domain.first()?.var;
    let at =
        |k: usize, t: &Rational| family.functions[k].value.substitute(var, &Fraction::constant(t.clone()));
    let mut rows: Vec<Vec<Fraction>> = Vec::new();
    for t in points {
        rows.push(functions.iter().map(|k| at(*k, t)).collect::<Option<_>>()?);
    }
    basis_prover::working(family.budget, &mut |work| determinant(rows.clone(), work))
}

/// The determinant of a matrix; `None` where the work is spent.
pub(in crate::state::family) fn determinant(
    mut rows: Vec<Vec<Fraction>>,
    work: &mut Work,
) -> Option<Fraction> {
    let mut product = Fraction::constant(Rational::ONE);
    for k in 0..rows.len() {
        let Some(pivot) = (k..rows.len()).find(|r| !rows[*r][k].is_zero()) else {
            return Some(Fraction::zero());
        };
        if pivot != k {
            rows.swap(pivot, k);
            product = -&product;
        }
        product = product.mul_within(&rows[k][k], work)?;
        for r in k + 1..rows.len() {
            if rows[r][k].is_zero() {
                continue;
            }
            let factor = rows[r][k].div_within(&rows[k][k], work).ok()??;
            let (above, below) = rows.split_at_mut(r);
            subtract(&mut below[0][k..], &above[k][k..], &factor, work)?;
        }
    }
    Some(product)
}

/// `minor of b[0], b[2] at t = 1/4, 1/2`.
fn label(family: &Family, functions: &[usize], points: &[Rational]) -> String {
    let functions: Vec<String> = functions.mapped(|k| family.function_label(*k));
    let points: Vec<String> = points.mapped(Rational::to_string);
    let name = family.domain.first().map_or("", |p| p.name.as_str());
    format!("minor of {} at {name} = {}", functions.join(", "), points.join(", "))
}

/// A negative minor at some rational points and shape values: at some of these, then where a step of the elimination is
/// negative.
pub(in crate::state::family) fn refutation(family: &Family, work: &mut Work) -> Option<Witness> {
    let pieces = family.pieces(&[], &[], true);
    let at_samples = |(number, piece): (usize, &Piece), work: &mut Work| {
        let points = [samples(piece), corners(piece)].concat();
        refutation_at(family, (number, piece), &points, work)
    };
    let first = pieces.iter().enumerate().find_map(|part| at_samples(part, work));
    first.or_else(|| {
        let steps = steps(family, work)?;
        steps.iter().find_map(|Step { number, statement, .. }| {
            let point = negative_step(family, statement, work)?;
            refutation_at(family, (*number, pieces.get(*number)?), &[point], work)
        })
    })
}

/// Shape values at which a step of the elimination is negative.
fn negative_step(family: &Family, statement: &Statement, work: &mut Work) -> Option<Vec<(Var, Rational)>> {
    let Statement::Sign { domain, .. } = statement else { return None };
    let found = if domain.premises.is_empty() {
        match decide(statement.clone(), &Symmetries::new(), family.budget) {
            Err(Failure::Refuted(found)) => *found,
            _ => return None,
        }
    } else {
        premises::counterexample(statement, work)?
    };
    let rational = |(var, c): (Var, Coordinate)| match c {
        Coordinate::Rational(x) => Some((var, x)),
        Coordinate::Algebraic(_) => None,
    };
    found.point.into_iter().map(rational).collect()
}

/// A negative minor at one of some shape values, given as points of the box of a part of them.
fn refutation_at(
    family: &Family,
    (number, piece): (usize, &Piece),
    points: &[Vec<(Var, Rational)>],
    work: &mut Work,
) -> Option<Witness> {
    let range = &family.domain.first()?.range;
    let (low, high) = range.finite()?;
    let len = family.functions.len().min(MAX_FUNCTIONS);
    for sample in points {
        let shapes = piece.image(&sample.mapped(|(v, x)| (*v, Coordinate::Rational(x.clone()))));
        let mut values = family.functions.mapped(|f| Some(f.value.clone()));
        for (var, c) in &shapes {
            if let Coordinate::Rational(x) = c {
                for value in &mut values {
                    let put = value.as_ref().and_then(|f| f.substitute(*var, &Fraction::constant(x.clone())));
                    *value = put;
                }
            }
        }
        let values: Option<Vec<Fraction>> = values.into_iter().collect();
        let Some(values) = values else { continue };
        for steps in [len as i64 + 1, 12, 29] {
            let points: Vec<Rational> = (0..=steps)
                .map(|k| low + &(&(high - low) * &Rational::new(k, steps)))
                .filter(|t| range.contains(t))
                .listed();
            let Some(table) = table(family, &values, &points, work) else { continue };
            let Some((functions, places)) = negative(&table, work) else { continue };
            let own = places.mapped(|k| points[*k].clone());
            let given = vec![own, functions.mapped(|k| Rational::from(*k as i64))];
            let Ok(all) = instances(family, &given) else { continue };
            let Some(stated) = all.into_iter().nth(number) else { continue };
            let statement = Rc::new(stated.statement);
            let point = sample.mapped(|(v, x)| (*v, Coordinate::Rational(x.clone())));
            let Some(found) = refute(&statement, &point, &mut Work::usual(family.budget)) else {
                continue;
            };
            let at = named_point(family, &found, &[], piece);
            let of = label(family, &functions, &given[0]);
            let mut witness = Witness::at_point(of.clone(), at, &found, false).about(&stated.of);
            witness.given = given;
            witness.idle = domain_names(family);
            let here = witness.point();
            let here = if here.is_empty() { here } else { format!(" where {here}") };
            witness.notes = vec![format!("the {of} is {}{here}", witness.value_text())];
            return Some(witness);
        }
    }
    None
}

/// The values of functions at points, a row for each function; each function and each point has a positive factor, by
/// which the values of polynomials are whole numbers. `None` where one has no value, or the work is spent.
fn table(
    family: &Family,
    functions: &[Fraction],
    points: &[Rational],
    work: &mut Work,
) -> Option<Vec<Vec<Rational>>> {
    let var = family.domain.first()?.var;
    let degree = |part: fn(&Fraction) -> &Poly| functions.iter().map(|f| part(f).degree(var)).max();
    let (degree, below) = (degree(Fraction::numer)?, degree(Fraction::denom)?);
    let mut rows = Vec::new();
    for f in functions {
        let whole = |p: &Poly| Some(Univariate::from_poly(p, var)?.primitive());
        let (numer, denom) = (whole(f.numer())?, whole(f.denom())?);
        let mut row = Vec::new();
        for t in points {
            let value = homogeneous(numer.coefficients(), degree, t, work)?;
            row.push(value.checked_div(&homogeneous(denom.coefficients(), below, t, work)?)?);
        }
        rows.push(row);
    }
    Some(rows)
}

/// Σ cₖ aᵏ b^(n − k): bⁿ times the value at a/b.
fn homogeneous(coefficients: &[Rational], degree: u32, at: &Rational, work: &mut Work) -> Option<Rational> {
    let (a, b) = (at.numer(), at.denom());
    let words = 1 + u64::from(degree) * at.bits() / 64;
    work.spend((u64::from(degree) + 1) * words)?;
    let mut value = Rational::ZERO;
    let mut power = Rational::ONE;
    // Horner's scheme, with a power of b for each coefficient.
    for k in (0..=degree as usize).rev() {
        value = &value * &a;
        if let Some(c) = coefficients.get(k).filter(|c| !c.is_zero()) {
            value = &value + &(c * &power);
        }
        power = &power * &b;
    }
    Some(value)
}

/// Points of a box at its ends as far as they belong to it: for a function of degree 1 in each variable the extreme ones.
fn corners(piece: &Piece) -> Vec<Vec<(Var, Rational)>> {
    let mut all: Vec<Vec<(Var, Rational)>> = vec![Vec::new()];
    for (var, range) in piece.ranges.iter().take(4) {
        let mut ends: Vec<Rational> = [&range.low, &range.high]
            .into_iter()
            .filter(|e| e.is_included())
            .filter_map(|e| e.value().cloned())
            .listed();
        if ends.is_empty() {
            ends.push(basis_prover::typical(range));
        }
        all = all
            .iter()
            .flat_map(|point| ends.iter().map(move |x| [point.as_slice(), &[(*var, x.clone())]].concat()))
            .listed();
    }
    for (var, range) in piece.ranges.iter().skip(4) {
        for point in &mut all {
            point.push((*var, basis_prover::typical(range)));
        }
    }
    all
}

/// A negative minor of a matrix of numbers, by its rows and columns: of all small ones, then of neighbouring rows with
/// neighbouring columns. `None` when there is none among them, or the work is spent.
fn negative(rows: &[Vec<Rational>], work: &mut Work) -> Option<(Vec<usize>, Vec<usize>)> {
    let (height, width) = (rows.len(), rows.first().map_or(0, Vec::len));
    let bits = rows.iter().flatten().map(Rational::bits).max()?;
    let product = 1 + bits * bits / 4096;
    for (r, row) in rows.iter().enumerate() {
        if let Some(c) = row.iter().position(Rational::is_negative) {
            return Some((vec![r], vec![c]));
        }
    }
    for (r, s) in (0..height).flat_map(|r| (r + 1..height).map(move |s| (r, s))) {
        for (c, d) in (0..width).flat_map(|c| (c + 1..width).map(move |d| (c, d))) {
            work.spend(2 * product)?;
            let value = &(&rows[r][c] * &rows[s][d]) - &(&rows[r][d] * &rows[s][c]);
            if value.is_negative() {
                return Some((vec![r, s], vec![c, d]));
            }
        }
    }
    for size in 3..=height.min(width) {
        for first in 0..=height - size {
            for (start, step) in (1..=(width - 1) / (size - 1))
                .flat_map(|step| (0..=width - 1 - step * (size - 1)).map(move |start| (start, step)))
            {
                let columns: Vec<usize> = (0..size).map(|k| start + step * k).listed();
                let part = (first..first + size).map(|r| columns.mapped(|c| rows[r][*c].clone())).listed();
                let value = basis_prover::algebra::matrix::determinant(part, work)?;
                if value.is_negative() {
                    return Some(((first..first + size).listed(), columns));
                }
            }
        }
    }
    None
}
