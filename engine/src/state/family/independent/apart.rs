//! Dependence of functions in which π, exp(r) and the like occur.

use basis_kernel::Statement;
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_unique;

use super::super::{Said, on_part};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::univariate::Univariate;
use crate::model::Family;
use crate::state::verdict::Stated;

/// What a dependence is read from where π, exp(r) and the like occur, without and with the functions times powers of
/// one of them.
pub(super) const APART: [&str; 3] = [
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
pub(in crate::state::family) fn apart(family: &Family) -> Vec<Said> {
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
        let stated = Stated::new(on_part(of, number, pieces.len()), statement);
        said.push(Said { stated, of: String::from(of), piece: piece.clone() });
    }
    Some(said)
}

/// The combination of functions that one of them and their multiples by the powers of a number is.
pub(super) fn with_multiples(family: &Family, factors: &[Univariate], raised: usize) -> Vec<Poly> {
    let number = multiplier(family).map_or_else(Poly::one, Poly::var);
    let sum = |own: &[Univariate]| {
        let terms = own.iter().enumerate().map(|(k, c)| &Poly::constant(c.leading()) * &number.pow(k as u32));
        terms.fold(Poly::zero(), |sum, term| &sum + &term)
    };
    factors.chunks(raised + 1).map(sum).listed()
}
