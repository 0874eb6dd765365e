//! What premises say to be positive, taken out of quotients and matrices.

use basis_kernel::{Domain, Quotient, Relation};
use basis_prover::collections::list::Listed;

use crate::algebra::poly::Poly;

/// Polynomials that are positive at all points that count, because a premise says so. What is divided by one of them keeps
/// its sign, and a row or column of a matrix keeps the rank.
pub(in crate::state::family) struct Positive(Vec<Poly>);

impl Positive {
    /// Those of a domain.
    pub(in crate::state::family) fn of(domain: &Domain) -> Self {
        let strict = domain.premises.iter().filter(|(g, sign)| *sign == Relation::Positive && !g.is_zero());
        Self(strict.map(|(g, _)| g.clone()).filter(|g| g.as_constant().is_none()).listed())
    }

    /// A quotient without those that divide what stands above or below the fraction line.
    pub(in crate::state::family) fn reduced(&self, value: &Quotient) -> Quotient {
        let Quotient { numerator, denominator } = value.clone();
        let without = |p: Poly| self.0.iter().fold(p, |p, g| divided_by_all(&[&p], g).pop().unwrap_or(p));
        Quotient { numerator: without(numerator), denominator: without(denominator) }
    }

    /// The rows of a matrix without those that divide all entries of a row, or of a column.
    pub(in crate::state::family) fn of_rows(&self, mut rows: Vec<Vec<Poly>>) -> Vec<Vec<Poly>> {
        for g in &self.0 {
            for row in &mut rows {
                *row = divided_by_all(&row.iter().listed(), g);
            }
            for k in 0..rows.iter().map(Vec::len).min().unwrap_or(0) {
                let column = divided_by_all(&rows.iter().map(|row| &row[k]).listed(), g);
                for (row, entry) in rows.iter_mut().zip(column) {
                    row[k] = entry;
                }
            }
        }
        rows
    }
}

/// Polynomials, divided by another one as often as it divides all of them; 0 is left as it is.
fn divided_by_all(all: &[&Poly], by: &Poly) -> Vec<Poly> {
    let mut all = all.iter().map(|p| (*p).clone()).listed();
    while all.iter().any(|p| !p.is_zero()) {
        let Some(quotients) = all.iter().map(|p| p.div_exact(by)).collect() else { break };
        all = quotients;
    }
    all
}
