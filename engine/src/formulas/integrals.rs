//! Integrals as they are written.

use std::rc::Rc;

use super::scope::{Reader, Scope, Value};
use super::value::{each, size, together};
use super::{Sign, Term};
use crate::syntax::{Expr, ExprKind};

/// A variable with its bounds.
type Bounds = (usize, Term, Term);

impl Reader<'_, '_> {
    /// integral(f), integral(f, t, a, b).
    pub(super) fn integral(&mut self, scope: &Scope<'_>, arguments: &[Expr]) -> Option<Value> {
        let (f, bounds) = match arguments {
            [f] => (f, None),
            [f, variable, low, high] => {
                let ExprKind::Name(name) = &variable.kind else { return None };
                let var = scope.names.iter().position(|n| n == name)?;
                (f, Some((var, self.scalar(scope, low)?, self.scalar(scope, high)?)))
            }
            _ => return None,
        };
        if scope.span.is_some() {
            // Between bounds it is about parts of the spans, which are not told apart here.
            return if bounds.is_none() { self.over_spans(scope, f) } else { None };
        }
        let value = self.value(scope, f)?;
        self.over(scope, value, bounds.as_ref())
    }

    /// Over several spans, the sum of the integrals over each.
    fn over_spans(&mut self, scope: &Scope<'_>, f: &Expr) -> Option<Value> {
        let mut sum = Vec::new();
        for sibling in scope.siblings.borrow().iter() {
            let sibling = sibling.upgrade()?;
            let (constants, arguments) = (scope.constants.borrow().clone(), scope.arguments.borrow().clone());
            let value = if sibling.span == scope.span {
                self.value(scope, f)
            } else {
                let own = (sibling.constants.replace(constants), sibling.arguments.replace(arguments));
                let value = self.value(&sibling, f);
                sibling.constants.replace(own.0);
                sibling.arguments.replace(own.1);
                value
            };
            let value = self.over(&sibling, value?, None)?;
            sum.push((Sign::Plus, value));
        }
        together(sum)
    }

    /// The integral of each formula.
    fn over(&mut self, scope: &Scope<'_>, value: Value, bounds: Option<&Bounds>) -> Option<Value> {
        let mut failed = false;
        let value = each(value, &mut |f| {
            let integral = match bounds {
                Some((var, low, high)) => Some(self.integrated(&f, *var, low.clone(), high.clone())),
                None => self.over_domain(scope, &f),
            };
            failed |= integral.is_none();
            integral.unwrap_or(f)
        });
        self.spend(size(&value))?;
        (!failed).then_some(value)
    }

    /// The integral in one variable.
    fn integrated(&mut self, f: &Term, var: usize, low: Term, high: Term) -> Term {
        let bound = self.fresh;
        self.fresh += 1;
        let body = f.put(&|v| (v == var).then_some(Term::Variable(bound)));
        Term::Integral { body: Rc::new(body), bound, low: Rc::new(low), high: Rc::new(high) }
    }

    /// The integral over the whole domain: over each interval, and over a simplex in all coordinates but the last, each from 0
    /// to what those before it leave.
    fn over_domain(&mut self, scope: &Scope<'_>, f: &Term) -> Option<Term> {
        let mut value = f.clone();
        for (factor, ends) in scope.domain() {
            match (&factor[..], ends) {
                ([var], ends) => {
                    let [low, high] = ends.clone()?;
                    value = self.integrated(&value, *var, low, high);
                }
                ([others @ .., last], _) => {
                    let left = |others: &[usize]| {
                        if others.is_empty() {
                            return Term::integer(1);
                        }
                        let minus = others.iter().map(|v| (Sign::Minus, Term::Variable(*v)));
                        Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(minus).collect())
                    };
                    value = value.put(&|v| (v == *last).then(|| left(others)));
                    for k in (0..others.len()).rev() {
                        value = self.integrated(&value, others[k], Term::integer(0), left(&others[..k]));
                    }
                }
                ([], _) => {}
            }
        }
        Some(value)
    }
}
