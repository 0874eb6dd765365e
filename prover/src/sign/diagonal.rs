//! Counterexamples on diagonals: where an exchange of two variables changes nothing, a function is often least where
//! they are equal.

use basis_kernel::Relation;

use super::outcome::{Outcome, Prove};
use super::problem::{Point, Problem};
use crate::algebra::poly::{Poly, Var};
use crate::budget::Budget;

/// A point with two equal coordinates at which the claim fails; `None` when none is found, and that says nothing.
pub(super) fn on_diagonals(
    problem: &Problem,
    relation: Relation,
    budget: &mut Budget,
    prove: Prove,
) -> Option<Point> {
    for (k, (x, range)) in problem.ranges.iter().enumerate() {
        for (y, other) in &problem.ranges[k + 1..] {
            budget.work.spend(2 * problem.poly.len() as u64)?;
            if range != other || exchanged(&problem.poly, *x, *y) != problem.poly {
                continue;
            }
            budget.work.spend_product(&problem.poly, &Poly::var(*x))?;
            let diagonal = problem.with(problem.poly.substitute(*y, &Poly::var(*x)));
            if let Outcome::Refuted(mut point) = prove(&diagonal, relation, budget) {
                point = problem.with(Poly::var(*x)).complete(point);
                let (_, equal) = point.iter().find(|(v, _)| v == x)?.clone();
                point.push((*y, equal));
                return Some(problem.complete(point));
            }
            // One pair is enough: the others of a symmetric group are equal to it or lie on its diagonal.
            return None;
        }
    }
    None
}

/// The polynomial with two variables exchanged.
fn exchanged(p: &Poly, x: Var, y: Var) -> Poly {
    let exchange = |(m, c): (&crate::algebra::poly::Monomial, &crate::algebra::rational::Rational)| {
        (m.with_exponent(x, m.exponent(y)).with_exponent(y, m.exponent(x)), c.clone())
    };
    Poly::from_terms(p.terms().map(exchange))
}
