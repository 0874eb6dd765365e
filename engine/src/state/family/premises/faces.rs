//! Counterexamples where a variable is at an end of its range: where a value is 0 there and positive elsewhere, no way downhill
//! need lead to it.

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{
    Coordinate, Counterexample, Failure, Symmetries, decide, refute, typical, within, working_with,
};
use std::rc::Rc;

use super::search::{Search, among_points};
use super::touching::zeros_between;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// The work for each step on a face.
const WORK: u64 = 100_000;

/// A counterexample to a statement about a sign on a face of its box.
pub(super) fn counterexample(statement: &Rc<Statement>, work: &mut Work) -> Option<Counterexample> {
    let Statement::Sign { domain, .. } = &**statement else { return None };
    for (var, range) in &domain.region.ranges {
        for end in [&range.low, &range.high].into_iter().filter(|end| end.is_included()) {
            let face = end.value().and_then(|end| Face::new(statement, *var, end));
            if let Some(found) = face.and_then(|face| face.counterexample(work)) {
                return Some(found);
            }
        }
    }
    None
}

/// A face of the box of a statement.
struct Face<'s> {
    statement: &'s Rc<Statement>,
    /// The variable that does not change on it, with its value.
    fixed: (Var, Rational),
    value: Quotient,
    relation: Relation,
    domain: Domain,
}

impl<'s> Face<'s> {
    fn new(statement: &'s Rc<Statement>, var: Var, end: &Rational) -> Option<Self> {
        let Statement::Sign { value, relation, domain } = &**statement else { return None };
        let [numerator, denominator] = [&value.numerator, &value.denominator].map(|p| p.at(var, end));
        let mut domain = Domain::clone(domain);
        domain.region.ranges.retain(|(own, _)| *own != var);
        for (g, _) in &mut domain.premises {
            *g = g.at(var, end);
        }
        let (value, fixed) = (Quotient { numerator, denominator }, (var, end.clone()));
        (!value.denominator.is_zero()).then_some(Self {
            statement,
            fixed,
            value,
            relation: *relation,
            domain,
        })
    }

    fn counterexample(&self, work: &mut Work) -> Option<Counterexample> {
        let all = self.stated(Domain { premises: Vec::new(), ..self.domain.clone() });
        let decided = within(WORK, &mut || decide(all.clone(), &Symmetries::new(), 1));
        // Where there is none without premises there is none with them.
        let Err(Failure::Refuted(found)) = decided else { return None };
        self.refuted(&found.point, work).or_else(|| self.at_zeros(work)).or_else(|| {
            match working_with(WORK, &mut |work| among_points(&self.stated(self.domain.clone()), work))? {
                Search::Found(found) => self.refuted(&found.point, work),
                Search::Lowest(_) => None,
            }
        })
    }

    /// One of the zeros of a value that depends on one variable.
    fn at_zeros(&self, work: &mut Work) -> Option<Counterexample> {
        let [var] = self.value.numerator.variables()[..] else { return None };
        let (_, range) = self.domain.region.ranges.iter().find(|(own, _)| *own == var)?;
        let zeros = zeros_between(&self.value.numerator, var, [range.low.value(), range.high.value()], work)?;
        let others = self.domain.region.ranges.iter().filter(|(own, _)| *own != var);
        let others = others.map(|(own, range)| (*own, Coordinate::Rational(typical(range)))).listed();
        zeros.into_iter().find_map(|zero| self.refuted(&[&others[..], &[(var, zero)]].concat(), work))
    }

    fn stated(&self, domain: Domain) -> Statement {
        Statement::Sign { value: self.value.clone(), relation: self.relation, domain: Rc::new(domain) }
    }

    /// What a point of the face is to the whole statement.
    fn refuted(&self, point: &[(Var, Coordinate)], work: &mut Work) -> Option<Counterexample> {
        let (var, end) = &self.fixed;
        refute(self.statement, &[point, &[(*var, Coordinate::Rational(end.clone()))]].concat(), work)
    }
}
