//! Step 6 for p ≥ 0: open cylindrical decomposition, complete for any number of variables.
//!
//! On each cell of the decomposition that is open in the box, p has one sign, and the cells together are dense in
//! the box; so p ≥ 0 if p is positive at one point of each of them.

use core::slice;

use super::projection::{Levels, all_roots, levels, univariates};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, between_roots};
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::list::{Listed, Mapped};
use crate::method::Method;
use crate::sign::outcome::{Outcome, spent};
use crate::sign::problem::{Problem, rational};
use basis_kernel::Relation;
use basis_kernel::{Cells, Sample, SignProof};

/// Decides p ≥ 0.
pub(in crate::sign) fn by_cells(problem: &Problem, budget: &mut Budget) -> Outcome {
    let work = &mut budget.work;
    let Some(levels) = levels(slice::from_ref(&problem.poly), &problem.ranges, None, false, work) else {
        return spent(problem, "projections");
    };
    let mut lifting = Lifting { problem, levels: &levels, point: Vec::new(), work };
    match lifting.samples(&levels.sets, &problem.poly) {
        Lifted::Samples(samples) => {
            let cells = Cells { order: levels.order, levels: levels.sets, samples };
            Outcome::Proved(Method::Cells, SignProof::Cells(cells))
        }
        Lifted::Negative(point) => Outcome::Refuted(rational(point)),
        Lifted::Spent => spent(problem, "cells"),
    }
}

struct Lifting<'a> {
    problem: &'a Problem,
    levels: &'a Levels,
    point: Vec<(Var, Rational)>,
    work: &'a mut Work,
}

enum Lifted {
    Samples(Vec<Sample>),
    Negative(Vec<(Var, Rational)>),
    Spent,
}

impl Lifting<'_> {
    /// The samples over the current point; the polynomials have its coordinates in place of the lower variables.
    fn samples(&mut self, sets: &[Vec<Poly>], poly: &Poly) -> Lifted {
        let level = self.point.len();
        let Some(values) = self.level(level, sets) else { return Lifted::Spent };
        let var = self.levels.order[level];
        let mut samples = Vec::with_capacity(values.len());
        for value in values {
            let poly = poly.at(var, &value);
            self.point.push((var, value.clone()));
            let above = if level + 1 == self.levels.order.len() {
                if !Relation::NonNegative.holds(&poly.as_constant().unwrap_or(Rational::ZERO)) {
                    return Lifted::Negative(self.point.clone());
                }
                Vec::new()
            } else {
                let sets: Vec<Vec<Poly>> = sets[1..].mapped(|set| set.mapped(|p| p.at(var, &value)));
                match self.samples(&sets, &poly) {
                    Lifted::Samples(above) => above,
                    other => return other,
                }
            };
            self.point.pop();
            samples.push(Sample { value, above });
        }
        Lifted::Samples(samples)
    }

    /// One number in each open interval between the roots of the lowest of the sets.
    fn level(&mut self, level: usize, sets: &[Vec<Poly>]) -> Option<Vec<Rational>> {
        let var = self.levels.order[level];
        let terms: usize = sets.iter().flatten().map(Poly::len).sum();
        self.work.spend(20 * terms as u64 + 50)?;
        let range = self.problem.range(var);
        let roots = all_roots(&univariates(&sets[0], var)?, &range, self.work)?;
        let roots: Vec<Root> = roots.into_iter().map(|(_, root)| root).listed();
        Some(between_roots(&roots, range.low.value(), range.high.value()))
    }
}
