//! Combinations of rows that vanish at a point.

use super::cut::Cut;
use super::table::Table;
use crate::algebra::matrix;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::real::field::Element;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::collections::list::Listed;
use crate::counterexample::Exact;

/// Factors of the rows with which their sum is zero at a point, one of them a number: whole numbers without common
/// factor at a rational one; `None` when the rows are independent there, or the work is spent.
pub(crate) fn combination(exact: &mut Exact, table: Table<'_>, work: &mut Work) -> Option<Vec<Element>> {
    let Some(field) = &exact.field else {
        let mut numbers: Vec<Vec<Rational>> = Vec::new();
        for row in table.rows {
            let values: Option<Vec<Element>> = row.iter().map(|p| exact.value(p, work)).collect();
            numbers.push(values?.iter().map(Univariate::leading).listed());
        }
        let found = matrix::vanishing_combination(&numbers, work).ok()??;
        return Some(found.into_iter().map(|c| Univariate::new(vec![c])).listed());
    };
    let mut field = field.clone();
    let at = &exact.coordinates;
    // In blocks, each of which is zero in the columns of all later ones, few entries have to be eliminated.
    let cut = Cut::new(table.rows, table.symmetries);
    let (rows, order): (&[Vec<Poly>], Vec<usize>) = match &cut {
        Some(cut) => (&cut.rows, cut.blocks.iter().flat_map(|b| b.rows.iter().copied()).listed()),
        None => (table.rows, (0..table.rows.len()).listed()),
    };
    let row = |field: &crate::algebra::real::field::Field, k: usize, work: &mut Work| {
        rows[order[k]].iter().map(|p| field.eval(p, at, work)).collect::<Option<Vec<Element>>>()
    };
    let found = field.vanishing_combination(rows.len(), &row, work)??;
    let mut factors = vec![Univariate::default(); table.rows.len()];
    let change = cut.as_ref().and_then(|cut| cut.change.as_ref());
    for (k, factor) in found.into_iter().enumerate() {
        match change {
            None => factors[order[k]] = factor,
            Some(change) => {
                for (r, x) in &change.rows[order[k]] {
                    factors[*r] = factors[*r].add(&factor.scale(x));
                }
            }
        }
    }
    let mut first = None;
    for factor in &factors {
        if !field.is_zero(factor, work)? {
            first = Some(factor.clone());
            break;
        }
    }
    let inverse = field.inverse(&first?, work)?;
    for factor in &mut factors {
        *factor = field.mul(factor, &inverse, work)?;
    }
    exact.field = Some(field);
    Some(factors)
}
