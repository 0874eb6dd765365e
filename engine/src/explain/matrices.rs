//! Matrices of a family, exact: to and from the Bernstein basis and other families, degree elevation, mass, stiffness,
//! moments.

mod integrals;

use basis_prover::collections::list::{Listed, Mapped};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, PolyExt as _, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::Kind;
use crate::model::{Family, Function, Library};
use crate::plan::patch::form::{Group, PatchForm, exponents};
use integrals::integrals;
pub use integrals::matrices_of_whole_domain;

/// The work for the matrices of a family.
const WORK: u64 = 5_000_000;

/// Families of more functions have no matrices here.
const MAX_FUNCTIONS: usize = 40;

/// More columns than this are not made.
const MAX_COLUMNS: usize = 400;

/// What a matrix says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixKind {
    /// The functions in the Bernstein basis.
    ToBernstein,
    /// The Bernstein basis in the functions.
    FromBernstein,
    /// The functions in those of another family.
    ToFamily,
    /// The functions of another family in these.
    FromFamily,
    /// The functions in those of the next order, or in the Bernstein basis of the next degree.
    Elevation,
    /// ∫ `b[i]·b[j]` over the domain.
    Mass,
    /// ∫ `∇b[i]·∇b[j]` over the domain.
    Stiffness,
    /// ∫ `m·b[j]` over the domain for monomials m.
    Moments,
}

impl MatrixKind {
    /// A name for tools, such as `to_bernstein`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ToBernstein => "to_bernstein",
            Self::FromBernstein => "from_bernstein",
            Self::ToFamily => "to_family",
            Self::FromFamily => "from_family",
            Self::Elevation => "elevation",
            Self::Mass => "mass",
            Self::Stiffness => "stiffness",
            Self::Moments => "moments",
        }
    }
}

/// A matrix with names of its rows and columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// What it says.
    pub kind: MatrixKind,
    /// The same in words and as a formula, such as `Mass matrix, the integrals of b[i]*b[j]`.
    pub title: String,
    /// The names of the rows, such as `b[0]`.
    pub rows: Vec<String>,
    /// The names of the columns, such as `B[0]`.
    pub columns: Vec<String>,
    /// The entries, rational functions of the shape parameters, row by row.
    pub entries: Vec<Vec<Fraction>>,
    /// The names of the variables in them.
    pub names: Vec<String>,
    /// The entries for reading, where they are made of sin, cos, exp and the like.
    written: Option<Vec<Vec<String>>>,
}

impl Matrix {
    /// The entries for reading.
    pub fn texts(&self) -> Vec<Vec<String>> {
        let plain = || self.entries.mapped(|row| row.mapped(|entry| entry.display(&self.names)));
        self.written.clone().unwrap_or_else(plain)
    }
}

/// The matrices of a family on an interval, a triangle, a tetrahedron, a box or a product of these; `next` is the
/// family in its next order.
///
/// Families with sin, exp or the like have integrals only. Left out are integrals that leave the functions of a spec, such
/// as logarithms, what takes too much work, the inverse of a matrix that has none, and all of families with many
/// functions.
pub fn matrices(library: &Library<'_>, family: &Family, next: Option<&Family>) -> Vec<Matrix> {
    if family.functions.len() > MAX_FUNCTIONS {
        return Vec::new();
    }
    let work = &mut Work::new(WORK);
    let mut all = Vec::new();
    if is_plain(family) {
        all = bernstein(family, work);
        let nested = next.and_then(|next| in_next_order(family, next, work));
        all.extend(nested.or_else(|| elevation(family, work)));
    } else if has_numbers(family) {
        all = bernstein(family, work);
        all.extend(elevation(family, work));
        for matrix in &mut all {
            let written = |row: &Vec<Fraction>| row.mapped(|entry| super::written(family, entry));
            matrix.written = Some(matrix.entries.mapped(written));
        }
    }
    all.extend(integrals(library, family, work));
    all
}

/// Which matrices a family might have are left out, and why.
pub fn matrices_left_out(family: &Family) -> Option<String> {
    if family.functions.len() > MAX_FUNCTIONS {
        return Some(format!("No matrices are stated: there are more than {MAX_FUNCTIONS} functions."));
    }
    let is_known = is_plain(family) || has_numbers(family);
    if !is_known && !family.analytic.is_transcendental() && !family.analytic.roots.is_empty() {
        let why = "No matrices to and from the Bernstein basis are stated: the functions contain tan(pi/n).";
        return Some(String::from(why));
    }
    let why = "No degree elevation is stated: the functions are quotients, and it would depend on weights.";
    (is_known && family.is_rational()).then(|| String::from(why))
}

/// Whether the functions are quotients of polynomials but for transcendental numbers, which are variables of their own.
fn has_numbers(family: &Family) -> bool {
    let analytic = &family.analytic;
    !analytic.numbers().is_empty() && analytic.roots.is_empty() && analytic.angles.is_empty()
}

/// Whether the functions of a family are quotients of polynomials in its domain variables.
fn is_plain(family: &Family) -> bool {
    let analytic = &family.analytic;
    let strange =
        |f: &Function| analytic.angles.iter().any(|a| a.itself != a.var && f.value.depends_on(a.itself));
    analytic.numbers().is_empty()
        && analytic.angles.iter().all(|a| a.kind == Kind::Linear)
        && !family.functions.iter().any(strange)
}

fn labels(family: &Family) -> Vec<String> {
    (0..family.functions.len()).map(|k| family.function_label(k)).listed()
}

/// The functions of another family by its title, such as `Bernstein(3)[0]`.
fn foreign(family: &Family) -> Vec<String> {
    family.functions.mapped(|f| crate::model::label(&family.title(), &f.index))
}

/// The functions over their common denominator.
fn numerators(family: &Family) -> Vec<Function> {
    if !family.is_rational() {
        return family.functions.clone();
    }
    let values = family.numerators();
    let function =
        |(f, value): (&Function, Poly)| Function { index: f.index.clone(), value: Fraction::from(value) };
    family.functions.iter().zip(values).map(function).listed()
}

/// Functions in Bernstein form.
struct Table {
    /// The coefficients, a row for each function.
    rows: Vec<Vec<Fraction>>,
    /// The names of the Bernstein polynomials.
    columns: Vec<String>,
    /// Their degree; of a box one for each variable.
    degrees: Vec<u32>,
}

/// The Bernstein coefficients of functions on the domain of a family.
fn table(family: &Family, functions: &[Function]) -> Option<Table> {
    let form = PatchForm::of_functions(family, functions)?;
    let columns = bernstein_names(&form.groups, &form.degrees);
    let row = |f: &crate::plan::patch::form::PatchFunction| {
        let entry = |c: &Poly| Fraction::new(c.clone(), f.denom.clone()).unwrap_or_else(Fraction::zero);
        f.bernstein.mapped(entry)
    };
    let rows = form.functions.mapped(row);
    Some(Table { rows, columns, degrees: form.degrees })
}

/// The names of Bernstein polynomials, in the order of their coefficients.
fn bernstein_names(groups: &[Group], degrees: &[u32]) -> Vec<String> {
    let name = |e: &Vec<u32>| {
        let mut index: Vec<String> = Vec::new();
        let mut rest = e.as_slice();
        for group in groups {
            let (own, others) = rest.split_at(group.vars.len() + 1);
            // Of x and s the power of x says all.
            let shown = if group.vars.len() == 1 { &own[..1] } else { own };
            index.extend(shown.iter().map(u32::to_string));
            rest = others;
        }
        format!("B[{}]", index.join(","))
    };
    exponents(groups, degrees).mapped(name)
}

/// `3`, or `2, 3` on a box.
fn degrees_text(degrees: &[u32]) -> String {
    degrees.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

/// To the Bernstein basis, and back.
fn bernstein(family: &Family, work: &mut Work) -> Vec<Matrix> {
    let mut all = Vec::new();
    let Some(table) = table(family, &numerators(family)) else { return all };
    let Table { rows: entries, columns, degrees } = table;
    if columns.len() > MAX_COLUMNS {
        return all;
    }
    let (rows, b) = (labels(family), &family.function_name);
    let (w, over) = if family.is_rational() {
        let below = family.over.display(&family.names).to_string();
        (format!("({below})*"), format!(" over the common denominator {below}"))
    } else {
        Default::default()
    };
    let degree = degrees_text(&degrees);
    let matrix = |kind, title, rows: &[String], columns: &[String], entries| Matrix {
        kind,
        title,
        rows: rows.to_vec(),
        columns: columns.to_vec(),
        entries,
        names: family.names.clone(),
        written: None,
    };
    let title = format!("Bernstein form of degree {degree}{over}: {w}{b}[i] = Σ M[i,j]*B[j]");
    all.push(matrix(MatrixKind::ToBernstein, title, &rows, &columns, entries.clone()));
    if rows.len() == columns.len() {
        let unit = |k: usize| {
            let entry = |j: usize| Fraction::constant(if j == k { Rational::ONE } else { Rational::ZERO });
            (0..columns.len()).map(entry).listed()
        };
        let units = (0..columns.len()).map(unit).listed();
        let inverse =
            combinations(&entries, &units, work).and_then(|all| all.into_iter().collect::<Option<Vec<_>>>());
        if let Some(inverse) = inverse {
            let title = format!("Back from the Bernstein form of degree {degree}: B[i] = Σ M[i,j]*{w}{b}[j]");
            all.push(matrix(MatrixKind::FromBernstein, title, &columns, &rows, inverse));
        }
    }
    all
}

/// The functions in those of the next order; `None` where these do not span them.
fn in_next_order(family: &Family, next: &Family, work: &mut Work) -> Option<Matrix> {
    // The orders of a family share their shape parameters if they are the same.
    if !same_domain(family, next) || family.names != next.names {
        return None;
    }
    let entries = in_terms_of(family, next, work)?.into_iter().collect::<Option<Vec<_>>>()?;
    let (b, title) = (&family.function_name, next.title());
    Some(Matrix {
        kind: MatrixKind::Elevation,
        title: format!("Degree elevation, {b}[i] = Σ M[i,j]*{title}[j]: Q[j] = Σ M[i,j]*P[i]"),
        rows: labels(family),
        columns: foreign(next),
        entries,
        names: family.names.clone(),
        written: None,
    })
}

/// The functions in the Bernstein basis of the next degree.
fn elevation(family: &Family, work: &mut Work) -> Option<Matrix> {
    if family.is_rational() {
        return None;
    }
    let form = PatchForm::of_functions(family, &family.functions)?;
    let Table { mut rows, mut degrees, .. } = table(family, &family.functions)?;
    for group in 0..degrees.len() {
        rows = raised(&rows, &form.groups, &mut degrees, group, work)?;
    }
    let columns = bernstein_names(&form.groups, &degrees);
    if columns.len() > MAX_COLUMNS {
        return None;
    }
    let degree = degrees_text(&degrees);
    let title = format!("Degree elevation, to the Bernstein form of degree {degree}: Q[j] = Σ M[i,j]*P[i]");
    Some(Matrix {
        kind: MatrixKind::Elevation,
        title,
        rows: labels(family),
        columns,
        entries: rows,
        names: family.names.clone(),
        written: None,
    })
}

/// Bernstein coefficients of a degree greater by one in one factor of the domain: of the degree n on a simplex those with
/// the index e are Σ eₖ·c(e − k-th unit)/(n + 1).
fn raised(
    rows: &[Vec<Fraction>],
    groups: &[Group],
    degrees: &mut [u32],
    group: usize,
    work: &mut Work,
) -> Option<Vec<Vec<Fraction>>> {
    let before = exponents(groups, degrees);
    degrees[group] += 1;
    let first: usize = groups[..group].iter().map(|g| g.vars.len() + 1).sum();
    let places = first..=first + groups[group].vars.len();
    // For each new coefficient the old ones with their factors.
    let sum = |e: &Vec<u32>| {
        let part = |k: usize| {
            let mut old = e.clone();
            old[k] = e[k].checked_sub(1)?;
            let factor = Rational::new(i64::from(e[k]), i64::from(degrees[group]));
            Some((before.iter().position(|known| *known == old)?, Fraction::constant(factor)))
        };
        places.clone().filter_map(part).listed()
    };
    let sums = exponents(groups, degrees).mapped(sum);
    let mut all = Vec::new();
    for row in rows {
        let mut raised = Vec::new();
        for sum in &sums {
            let mut value = Fraction::zero();
            for (k, factor) in sum {
                value = value.add_within(&row[*k].mul_within(factor, work)?, work)?;
            }
            raised.push(value);
        }
        all.push(raised);
    }
    Some(all)
}

/// The functions of a family in terms of those of another one on the same domain, and back.
///
/// Shape parameters of the other family with the same name as one of this family get its name as a suffix.
///
/// # Errors
/// Why there is no such matrix.
pub fn conversions(family: &Family, other: &Family) -> Result<Vec<Matrix>, String> {
    let work = &mut Work::new(WORK);
    let (a, b) = (family.title(), other.title());
    if !is_plain(family) || !is_plain(other) {
        return Err(String::from("families with sin, exp or the like are not converted"));
    }
    let (renamed, names) = side_by_side(family, other);
    if !same_domain(family, other) {
        return Err(format!("`{b}` has another domain than `{a}`"));
    }
    let spent = || String::from("the functions are dependent, or the matrix takes too much work");
    let mut all = Vec::new();
    let mut reasons = Vec::new();
    let (own, others) = (labels(family), foreign(&renamed));
    let f = &family.function_name;
    for (kind, from, to) in
        [(MatrixKind::ToFamily, family, &renamed), (MatrixKind::FromFamily, &renamed, family)]
    {
        let (rows, columns, equation) = match kind {
            MatrixKind::ToFamily => (&own, &others, format!("{f}[i] = Σ M[i,j]*{b}[j]")),
            _ => (&others, &own, format!("{b}[i] = Σ M[i,j]*{f}[j]")),
        };
        let entries = in_terms_of(from, to, work).ok_or_else(spent)?;
        if let Some(missing) = entries.iter().position(Option::is_none) {
            reasons.push(format!("`{}` is not a combination of those of `{}`", rows[missing], to.title()));
            continue;
        }
        let title = format!("{} in terms of {}: {equation}", from.title(), to.title());
        let entries = entries.into_iter().flatten().listed();
        let (rows, columns) = (rows.clone(), columns.clone());
        all.push(Matrix { kind, title, rows, columns, entries, names: names.clone(), written: None });
    }
    if all.is_empty() {
        let reasons = reasons.join("; ");
        return Err(format!("neither family spans the functions of the other: {reasons}"));
    }
    Ok(all)
}

/// The other family in variables beside those of the first one, its domain variables as in the first one; and the names of
/// all variables.
fn side_by_side(family: &Family, other: &Family) -> (Family, Vec<String>) {
    let mut names = family.names.clone();
    let mut map: Vec<Var> = Vec::new();
    for (k, name) in other.names.iter().enumerate() {
        let position = other.domain.iter().position(|p| p.var.0 == k);
        map.push(match position.and_then(|p| family.domain.get(p)) {
            Some(own) => own.var,
            None => {
                let clash = family.names.contains(name);
                names.push(if clash { format!("{name}_{}", other.name) } else { name.clone() });
                Var(names.len() - 1)
            }
        });
    }
    let mut renamed = other.clone();
    for f in &mut renamed.functions {
        f.value = f.value.rename(&map);
    }
    for (p, own) in renamed.domain.iter_mut().zip(&family.domain) {
        p.var = own.var;
    }
    renamed.over = other.over.rename(&map);
    renamed.names.clone_from(&names);
    (renamed, names)
}

/// Whether two families are about the same domain, whatever its variables are called.
fn same_domain(family: &Family, other: &Family) -> bool {
    let ends = |f: &Family| {
        f.domain.iter().map(|p| (p.range.low.value().cloned(), p.range.high.value().cloned())).listed()
    };
    let simplices = |f: &Family| f.simplices.iter().map(|s| s.places.clone()).listed();
    simplices(family) == simplices(other)
        && ends(family) == ends(other)
        && family.analytic.angles.is_empty()
        && other.analytic.angles.is_empty()
}

/// For each function of a family the coefficients that make it a combination of the functions of another one on the same
/// domain and in the same variables, or nothing where there are none; `None` when there are too many functions, or the
/// work is spent.
fn in_terms_of(family: &Family, other: &Family, work: &mut Work) -> Option<Vec<Option<Vec<Fraction>>>> {
    if family.functions.len().max(other.functions.len()) > MAX_FUNCTIONS {
        return None;
    }
    // f/w is a combination of the g/v if and only if f·v is one of the g·w.
    let mut put = |f: &Family, factors: [&Poly; 2]| {
        let times =
            Fraction::from(factors[0].clone()).mul_within(&Fraction::from(factors[1].clone()), work)?;
        f.functions.iter().map(|f| f.value.mul_within(&times, work)).collect::<Option<Vec<_>>>()
    };
    let factors = [&family.over, &other.over];
    let (targets, basis) = (put(family, factors)?, put(other, factors)?);
    let domain = family.domain.mapped(|p| p.var);
    let mut monomials: Vec<Monomial> = Vec::new();
    let mut parts: Vec<Vec<(Monomial, Fraction)>> = Vec::new();
    for f in basis.iter().chain(&targets) {
        let own = by_monomial(f, &domain);
        for (m, _) in &own {
            if !monomials.contains(m) {
                monomials.push(m.clone());
            }
        }
        parts.push(own);
    }
    if monomials.len() > MAX_COLUMNS {
        return None;
    }
    let row = |own: &Vec<(Monomial, Fraction)>| {
        let entry =
            |m: &Monomial| own.iter().find(|(n, _)| n == m).map_or_else(Fraction::zero, |(_, c)| c.clone());
        monomials.mapped(entry)
    };
    let rows = parts.mapped(row);
    let (basis, targets) = rows.split_at(basis.len());
    combinations(basis, targets, work)
}

/// The coefficients of a function whose denominator holds no domain variable, by monomial in these.
fn by_monomial(f: &Fraction, domain: &[Var]) -> Vec<(Monomial, Fraction)> {
    let mut groups: Vec<(Monomial, Vec<(Monomial, Rational)>)> = Vec::new();
    for (m, c) in f.numer().terms() {
        let mut inner = m.clone();
        let mut key = Monomial::one();
        for var in domain {
            key = key.with_exponent(*var, m.exponent(*var));
            inner = inner.with_exponent(*var, 0);
        }
        match groups.iter_mut().find(|(known, _)| *known == key) {
            Some((_, terms)) => terms.push((inner, c.clone())),
            None => groups.push((key, vec![(inner, c.clone())])),
        }
    }
    let over =
        |terms| Fraction::new(Poly::from_terms(terms), f.denom().clone()).unwrap_or_else(Fraction::zero);
    groups.into_iter().map(|(key, terms)| (key, over(terms))).listed()
}

/// For each target the coefficients c with Σ c[i]·rows[i] = target, or nothing where there are none; the whole is `None`
/// when the rows are linearly dependent for all shape values, or the work is spent.
///
/// Gauss-Jordan elimination of the system whose columns are the rows and the targets; pivots are numbers where there are
/// some.
fn combinations(
    rows: &[Vec<Fraction>],
    targets: &[Vec<Fraction>],
    work: &mut Work,
) -> Option<Vec<Option<Vec<Fraction>>>> {
    let (width, height) = (rows.len(), rows.first().map_or(0, Vec::len));
    let mut system: Vec<Vec<Fraction>> =
        (0..height).map(|k| rows.iter().chain(targets).map(|row| row[k].clone()).listed()).listed();
    let size = |f: &Fraction| f.numer().len() + f.denom().len();
    for column in 0..width {
        let below = (column..height).filter(|r| !system[*r][column].is_zero());
        let pivot = below.min_by_key(|r| size(&system[*r][column]))?;
        system.swap(column, pivot);
        let lead = system[column][column].clone();
        let mut own = core::mem::take(&mut system[column]);
        for entry in own.iter_mut().skip(column).filter(|e| !e.is_zero()) {
            *entry = entry.div_within(&lead, work).ok().flatten()?;
        }
        for (r, row) in system.iter_mut().enumerate() {
            if r == column || row[column].is_zero() {
                continue;
            }
            let factor = row[column].clone();
            for (entry, pivot) in row.iter_mut().zip(&own).skip(column).filter(|(_, p)| !p.is_zero()) {
                *entry = entry.sub_within(&factor.mul_within(pivot, work)?, work)?;
            }
        }
        system[column] = own;
    }
    let solution = |k: usize| {
        let solved = system[width..].iter().all(|row| row[width + k].is_zero());
        solved.then(|| (0..width).map(|r| system[r][width + k].clone()).listed())
    };
    Some((0..targets.len()).map(solution).listed())
}
