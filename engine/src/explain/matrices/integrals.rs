//! Mass, stiffness and moments: integrals over a domain of one span or several.

use basis_prover::collections::list::{Listed, Mapped};
use proc_macro2::Span;

use super::super::reading;
use super::{MAX_FUNCTIONS, Matrix, MatrixKind, WORK, is_plain, labels};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::{Angle, Kind};
use crate::model::scope::Scope;
use crate::model::{Factor, Family, Library};

/// The integrals over the whole domain of a family on several spans, sums of those over each; none of a family on one span,
/// nor where those over a span contain π or the like.
pub fn matrices_of_whole_domain(library: &Library<'_>, family: &Family) -> Vec<Matrix> {
    let Some((first, others)) = family.pieces.split_first() else { return Vec::new() };
    if first.functions.len() > MAX_FUNCTIONS {
        return Vec::new();
    }
    // The shape parameters are the first variables of all spans; others may stand for different things.
    let is_of_shapes = |f: &Fraction| {
        let both = [f.numer(), f.denom()];
        both.iter().all(|p| p.variables().iter().all(|v| v.0 < family.shapes.len()))
    };
    let of_span = |piece: &Family, work: &mut Work| {
        let mut all = integrals(library, piece, work);
        all.retain(|matrix| matrix.entries.iter().flatten().all(is_of_shapes));
        all
    };
    let work = &mut Work::new(WORK);
    let mut all = of_span(first, work);
    for piece in others {
        let own = of_span(piece, work);
        all = all.into_iter().filter_map(|sum| sum.plus(&own, work)).listed();
    }
    for matrix in &mut all {
        matrix.title = matrix.title.replacen(", the integrals", " of the whole domain, the integrals", 1);
        matrix.written = (!first.analytic.is_empty())
            .then(|| matrix.entries.mapped(|row| row.mapped(|entry| reading::expanded(first, entry))));
    }
    all
}

impl Matrix {
    /// The sum with the one of the same kind among others.
    fn plus(mut self, others: &[Self], work: &mut Work) -> Option<Self> {
        let other = others.iter().find(|other| other.kind == self.kind && other.rows == self.rows)?;
        for (row, more) in self.entries.iter_mut().zip(&other.entries) {
            for (entry, more) in row.iter_mut().zip(more) {
                *entry = entry.add_within(more, work)?;
            }
        }
        Some(self)
    }
}

/// Mass, stiffness, moments.
pub(super) fn integrals(library: &Library<'_>, family: &Family, work: &mut Work) -> Vec<Matrix> {
    let mut all = Vec::new();
    let is_polynomial = is_plain(family) && !family.is_rational();
    let scope = Scope::of_family(library, 0, family);
    let integral = |f: &Fraction, work: &mut Work| {
        if is_polynomial { integral(family, f, work) } else { scope.over_domain_of(f, Span::call_site()) }
    };
    let (rows, b) = (labels(family), &family.function_name);
    let values: Vec<Fraction> = family.functions.mapped(|f| f.value.clone());
    let matrix = |kind, title, rows: Vec<String>, entries: Vec<Vec<Fraction>>| Matrix {
        kind,
        title,
        rows,
        columns: labels(family),
        written: (!family.analytic.is_empty())
            .then(|| entries.mapped(|row| row.mapped(|entry| reading::expanded(family, entry)))),
        entries,
        names: family.names.clone(),
    };
    let symmetric = |parts: &[Vec<Fraction>], work: &mut Work| -> Option<Vec<Vec<Fraction>>> {
        let mut entries = vec![vec![Fraction::zero(); values.len()]; values.len()];
        for i in 0..values.len() {
            for j in 0..=i {
                let mut sum = Fraction::zero();
                for part in parts {
                    sum = sum.add_within(&part[i].mul_within(&part[j], work)?, work)?;
                }
                entries[i][j] = integral(&sum, work)?;
                entries[j][i] = entries[i][j].clone();
            }
        }
        Some(entries)
    };
    if let Some(entries) = symmetric(core::slice::from_ref(&values), work) {
        let title = format!("Mass matrix, the integrals of {b}[i]*{b}[j]");
        all.push(matrix(MatrixKind::Mass, title, rows.clone(), entries));
    }
    let gradient: Option<Vec<Vec<Fraction>>> = family
        .domain
        .iter()
        .map(|p| values.iter().map(|f| family.derivative_within(f, p.var, work)).collect())
        .collect();
    if let Some(entries) = gradient.and_then(|parts| symmetric(&parts, work)) {
        let products = family.domain.mapped(|p| match family.domain.len() {
            1 => format!("D({b}[i])*D({b}[j])"),
            _ => format!("D({b}[i], {0})*D({b}[j], {0})", p.name),
        });
        let title = format!("Stiffness matrix, the integrals of {}", products.join(" + "));
        all.push(matrix(MatrixKind::Stiffness, title, rows, entries));
    }
    // 1, t, t² on an interval, 1 and the variables elsewhere.
    let mut monomials: Vec<(String, Fraction)> = vec![(String::from("1"), Fraction::constant(Rational::ONE))];
    for p in &family.domain {
        let own = |angle: &Angle| match angle.kind {
            Kind::Linear => angle.tangent(),
            _ => Fraction::var(angle.itself),
        };
        let value = family.analytic.angle(p.var).map_or_else(|| Fraction::var(p.var), own);
        let name = family.analytic.angle(p.var).map_or(&p.name, |angle| &angle.name);
        monomials.push((name.clone(), value.clone()));
        if family.domain.len() == 1 {
            monomials.push((format!("{name}^2"), &value * &value));
        }
    }
    let mut moments = || {
        let mut entries = Vec::new();
        for (_, m) in &monomials {
            let mut row = Vec::new();
            for f in &values {
                row.push(integral(&f.mul_within(m, work)?, work)?);
            }
            entries.push(row);
        }
        Some(entries)
    };
    if let Some(entries) = moments() {
        let title = format!("Moments, the integrals of m*{b}[j] for m = {}", names(&monomials));
        all.push(matrix(MatrixKind::Moments, title, monomials.mapped(|(name, _)| name.clone()), entries));
    }
    all
}

fn names(monomials: &[(String, Fraction)]) -> String {
    monomials.mapped(|(name, _)| name.clone()).join(", ")
}

/// The integral over the domain of a function whose denominator holds no domain variable: of each monomial the product
/// of the integrals over the factors of the domain, ∏ aₖ!/(Σ aₖ + d)! for a simplex. A variable low + width·y brings its
/// width as a factor.
fn integral(family: &Family, f: &Fraction, work: &mut Work) -> Option<Fraction> {
    if family.domain.iter().any(|p| f.denom().depends_on(p.var)) {
        return None;
    }
    let factorial =
        |n: u32| (1..=i64::from(n)).fold(Rational::ONE, |product, k| &product * &Rational::from(k));
    let factors = family.factors();
    let mut terms = Vec::new();
    for (m, c) in f.numer().terms() {
        let (mut rest, mut value) = (m.clone(), c.clone());
        for p in &family.domain {
            rest = rest.with_exponent(p.var, 0);
        }
        for factor in &factors {
            match factor {
                Factor::Simplex(independent, _) => {
                    let mut sum = independent.len() as u32;
                    for p in *independent {
                        let e = u32::from(m.exponent(p.var));
                        value *= &factorial(e);
                        sum += e;
                    }
                    value = value.checked_div(&factorial(sum))?;
                }
                Factor::Interval(p) => {
                    let e = u32::from(m.exponent(p.var));
                    let (low, high) = p.range.finite()?;
                    let difference = &high.pow(e + 1) - &low.pow(e + 1);
                    value = &(&value * &difference) * &Rational::new(1, i64::from(e) + 1);
                }
            }
        }
        terms.push((rest, value));
    }
    let mut value = Fraction::new(Poly::from_terms(terms), f.denom().clone())?;
    for p in &family.domain {
        if let Some(angle) = family.analytic.angle(p.var) {
            value = value.mul_within(&angle.width, work)?;
        }
    }
    Some(value)
}
