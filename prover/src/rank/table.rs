//! Functions as the rows of a matrix of their coefficients.

use basis_kernel::Values;

use super::symmetry::Symmetries;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::collections::list::Mapped;
use crate::collections::sort::sort_by;
use crate::sign::problem::value;

/// A matrix of polynomials.
#[derive(Clone, Copy, Debug)]
pub struct Table<'a> {
    /// One row for each function, all of one length.
    pub rows: &'a [Vec<Poly>],
    /// Permutations that leave the matrix unchanged, as far as they are known.
    pub symmetries: &'a Symmetries,
}

impl Table<'_> {
    /// The rows with numbers in place of some parameters.
    pub(super) fn fix(&self, values: &Values) -> Vec<Vec<Poly>> {
        let at = |p: &Poly| values.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
        self.rows.mapped(|row| row.mapped(at))
    }
}

/// The region with all real numbers for the parameters that it says nothing of.
pub(super) fn complete(rows: &[Vec<Poly>], region: &Region) -> Region {
    let mut region = region.clone();
    for var in rows.iter().flatten().flat_map(Poly::variables) {
        if !region.ranges.iter().any(|(v, _)| *v == var) {
            region.ranges.push((var, Range::all()));
        }
    }
    sort_by(&mut region.ranges, |a, b| a.0.cmp(&b.0));
    region
}

/// The matrix at a rational point.
pub(super) fn at(rows: &[Vec<Poly>], point: &[(Var, Rational)]) -> Vec<Vec<Rational>> {
    rows.mapped(|row| row.mapped(|p| value(p, point)))
}
