//! Counterexamples where two premises, g ≥ 0 and −g ≥ 0, say an equation: points beside its zeros do not count, so that a variable takes
//! the values of zeros of g where the others have numbers of their ranges.

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, refute};
use std::rc::Rc;

use super::points::{all_ranges, counts, sample};
use super::touching::zeros_between;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Choices of the other variables, at most.
const MAX_CHOICES: usize = 60;

/// A counterexample to a statement about a sign, or to an equation, at a point of the zeros of a premise.
pub(super) fn counterexample(statement: &Rc<Statement>, work: &mut Work) -> Option<Counterexample> {
    let (value, domain) = match &**statement {
        Statement::Sign { value, domain, .. } | Statement::Zero { value, domain } => (value, domain),
        Statement::Products { .. } | Statement::Independent { .. } => return None,
    };
    let equation = equation(domain)?;
    let points = sample(value, domain)?;
    let ranges = all_ranges(value, domain);
    for solved in equation.variables() {
        let range = &ranges.iter().find(|(v, _)| *v == solved)?.1;
        let others = Domain {
            premises: domain.premises.iter().filter(|(g, _)| !g.depends_on(solved)).cloned().listed(),
            ..Domain::clone(domain)
        };
        let mut choices: Vec<Vec<Rational>> = Vec::new();
        for point in points.iter().filter(|point| counts(&others, point)) {
            let is_new =
                |known: &Vec<Rational>| ranges.iter().any(|(v, _)| *v != solved && known[v.0] != point[v.0]);
            if choices.iter().all(is_new) {
                choices.push(point.clone());
            }
        }
        // In all parts of the ranges.
        let step = choices.len().div_ceil(MAX_CHOICES).max(1);
        for point in choices.iter().step_by(step) {
            let others = equation.variables().into_iter().filter(|v| *v != solved);
            let alone = others.fold(equation.clone(), |p, v| p.at(v, &point[v.0]));
            let zeros = zeros_between(&alone, solved, [range.low.value(), range.high.value()], work);
            for zero in zeros.unwrap_or_default() {
                let coordinate = |v: Var| match v {
                    v if v == solved => zero.clone(),
                    v => Coordinate::Rational(point[v.0].clone()),
                };
                let at = ranges.iter().map(|(v, _)| (*v, coordinate(*v))).listed();
                if let Some(found) = refute(statement, &at, work) {
                    return Some(found);
                }
            }
        }
    }
    None
}

/// A polynomial that is 0 where the premises of a domain hold.
fn equation(domain: &Domain) -> Option<&Poly> {
    let weak = || domain.premises.iter().filter(|(_, relation)| *relation == Relation::NonNegative);
    weak().map(|(g, _)| g).find(|g| !g.is_zero() && weak().any(|(other, _)| other == &-*g))
}
