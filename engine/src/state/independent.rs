//! Linear independence: the rank of the coefficient table and the shape values at which it drops.

use super::{Evidence, Step, StepProof, Verdict, Witness, domain_names, named_point, point};
use crate::SortedMap;
use crate::algebra::matrix::determinant;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::collections::list::Mapped;
use crate::collections::sort::sort_unique;
use crate::decide::{
    self, Budget, Coordinate, Exception, Independence, Piece, Symmetries, Symmetry, Table, Values,
};
use crate::model::Family;

/// Why functions are independent for all shape values in their ranges except some.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RankProof {
    /// The parts of the ranges with their minors.
    pub pieces: Vec<Piece>,
    /// For each exception polynomials cᵢ in the shape parameters, not all zero, such that Σ cᵢ·(row i of the table) = 0 there.
    pub exceptions: Vec<Vec<Poly>>,
}

/// What the claim is about, in place of an expression.
pub(super) const COEFFICIENTS: &str = "table of coefficients";

/// Independence on the declared ranges except for the listed shape values; at each of these the functions must be
/// dependent.
pub(super) fn independent(family: &Family, except: &[Values]) -> Verdict {
    let table = coefficient_table(family);
    let region = family.shape_region();
    let budget = || Budget::scaled(family.budget);
    let mut exceptions = Vec::new();
    for values in except {
        match decide::dependent(&table, values, &region, &mut budget()) {
            Exception::Dependent(combination) => exceptions.push(combination),
            Exception::Independent(point) => {
                return no_exception(family, &table, values, point).map_or_else(
                    || {
                        Verdict::Undecided(String::from(
                            "the budget is spent on the determinant of the coefficients",
                        ))
                    },
                    Verdict::Refuted,
                );
            }
            // The range contains every exception, or else the claim is an error.
            Exception::Outside => exceptions.push(Vec::new()),
            Exception::Undecided(left) => return Verdict::Undecided(left),
        }
    }
    match decide::independent(&table, except, &region, &mut budget()) {
        Independence::Proved(pieces) => {
            let proof = StepProof::Independence(RankProof { pieces, exceptions });
            let steps = vec![Step { of: String::from(COEFFICIENTS), proof }];
            Verdict::Proved(Evidence { method: String::from("minors"), steps })
        }
        Independence::Refuted(dependence) => Verdict::Refuted(dependent_at(family, &dependence)),
        Independence::Undecided(left) => Verdict::Undecided(left),
    }
}

/// The coefficients of all functions, one row for each; denominators, which vanish nowhere, are left out. On an interval
/// in the Bernstein basis, on a simplex in homogeneous monomials, in which more of them are numbers.
pub fn coefficient_table(family: &Family) -> Table {
    if let Some(rows) = crate::generate::form::bernstein_table(family) {
        let reversed = |len: usize| (0..len).rev().collect();
        let width = rows.first().map_or(0, Vec::len);
        let symmetries = vec![vec![Symmetry { rows: reversed(rows.len()), columns: reversed(width) }]];
        return Table { rows, symmetries };
    }
    let domain: Vec<Var> = family.domain.iter().map(|p| p.var).collect();
    // The shape parameters are the first variables.
    let parts_of = |m: &Monomial| m.split(family.shapes.len());
    let domain_degree = |m: &Monomial| parts_of(m).1.total_degree() as u16;
    let terms = family.functions.iter().flat_map(|f| f.value.numer().terms());
    let degree = terms.map(|(m, _)| domain_degree(m)).max().unwrap_or(0);
    // On a simplex times powers of u + v + w = 1; w is not written, its exponent is what the others leave of the degree.
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
        let mut row: SortedMap<Monomial, Poly> = SortedMap::new();
        for (m, c) in raised.fold(Poly::zero(), |sum, p| &sum + &p).terms() {
            let (shape, column) = parts_of(m);
            row.get_or_insert_with(column, Poly::zero).add_term(shape, c);
        }
        row
    };
    let rows: Vec<SortedMap<Monomial, Poly>> =
        family.functions.iter().map(|f| row(f.value.numer())).collect();
    let mut columns: Vec<&Monomial> = rows.iter().flat_map(SortedMap::keys).collect();
    sort_unique(&mut columns);
    let symmetries = if family.is_simplex() {
        let exponents = |m: &&Monomial| {
            let mut all: Vec<u16> = domain.iter().map(|v| m.exponent(*v)).collect();
            all.push(degree - domain_degree(m));
            all
        };
        exchanges(family, &columns.iter().map(exponents).collect::<Vec<_>>())
    } else {
        Symmetries::new()
    };
    let filled =
        rows.iter().map(|row| columns.iter().map(|c| row.get(*c).cloned().unwrap_or_default()).collect());
    Table { rows: filled.collect(), symmetries }
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

/// The refutation when the functions are not dependent at a listed exception; `None` when the budget is spent.
fn no_exception(family: &Family, table: &Table, values: &Values, point: Values) -> Option<Witness> {
    let idle = |v: Var| values.iter().all(|(w, _)| *w != v) && !depends_on(table, v);
    let mut exact: Vec<(Var, Coordinate)> = Vec::new();
    for (v, x) in point {
        let shape = family.shapes.iter().find(|p| p.var == v && idle(v));
        exact.push((v, Coordinate::Rational(shape.map_or(x, |p| decide::simple(&p.range)))));
    }
    let point = exact;
    let coordinates = point::coordinates(&point, family.names.len());
    let rows: Vec<Vec<Rational>> = table.rows.mapped(|row| row.mapped(|p| p.eval(&coordinates)));
    // The sum of the squares of the minors is the determinant of the table times its transpose (Cauchy–Binet).
    let product =
        |a: &[Rational], b: &[Rational]| a.iter().zip(b).fold(Rational::ZERO, |s, (x, y)| &s + &(x * y));
    let squares = rows.mapped(|a| rows.mapped(|b| product(a, b)));
    let value = determinant(squares, &mut Budget::scaled(family.budget).work)?;
    let described: Vec<String> = values.mapped(|(v, x)| format!("{} = {x}", family.names[v.0]));
    Some(Witness {
        of: String::from(SQUARES),
        at: named_point(family, &point, &[]),
        idle: domain_names(family),
        net: Vec::new(),
        value,
        notes: vec![format!("at {} the functions are independent: it is no exception", described.join(", "))],
    })
}

/// Whether a parameter occurs in a table.
pub(super) fn depends_on(table: &Table, var: Var) -> bool {
    table.rows.iter().flatten().any(|p| p.depends_on(var))
}

/// What is evaluated where there is no combination to show.
pub(super) const SQUARES: &str = "sum of the squares of the maximal minors";

/// The combination of the functions that vanishes at a point of the shape parameters.
pub(super) fn dependent_at(family: &Family, dependence: &decide::Dependence) -> Witness {
    let point = &dependence.point;
    let coordinates = point::coordinates(point, family.names.len());
    let described: Vec<String> = point
        .iter()
        .filter(|(v, _)| family.shapes.iter().any(|s| s.var == *v))
        .map(|(v, c)| c.describe(&family.names[v.0]))
        .collect();
    let at = if described.is_empty() { String::new() } else { format!(" at {}", described.join(", ")) };
    let (of, note) = match &dependence.combination {
        Some(factors) => {
            // The rows are numerators; a function is its numerator over its denominator.
            let scaled: Vec<Poly> = factors
                .iter()
                .zip(&family.functions)
                .map(|(c, f)| Poly::constant(c * &f.value.denom().eval(&coordinates)))
                .collect();
            let of = combination_text(family, &scaled);
            let note = format!("`{of}` vanishes identically{at}");
            (of, note)
        }
        None => (String::from(SQUARES), format!("the functions are linearly dependent{at}")),
    };
    let at = named_point(family, point, &[]);
    let idle = domain_names(family);
    Witness { of, at, idle, net: Vec::new(), value: Rational::ZERO, notes: vec![note] }
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
