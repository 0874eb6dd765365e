//! Claims as comparisons of terms.

use std::rc::Rc;

use super::scope::{Reader, Scope, Value};
use super::{Claimed, Compared, Comparison, Role, Sign, Term};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::claim::ClaimKind;
use crate::model::Family;
use crate::model::angle::Angle;
use crate::state::moves;
use crate::syntax::{self, Binding, StatementKind};

impl Reader<'_, '_> {
    /// The claims, in the order of the item, with the kind of each; nothing for those that have no counterpart or are about
    /// something else. `None` when they cannot be told apart.
    pub(super) fn claims(
        &mut self,
        scope: &Scope<'_>,
        written: &syntax::Family,
        family: &Family,
        kinds: &[Option<&ClaimKind>],
    ) -> Option<Vec<Option<Claimed>>> {
        let mut all = Vec::new();
        for statement in &written.statements {
            let StatementKind::Claim(claim) = &statement.kind else { continue };
            match &claim.kind {
                syntax::ClaimKind::Relation(relation) => {
                    self.relation(scope, relation, Some(&[]), &mut all)?;
                }
                syntax::ClaimKind::At(bindings, relations) => {
                    let fixed = bindings.iter().map(|binding| self.fixed(scope, binding));
                    let fixed = fixed.collect::<Option<Vec<_>>>().map(|all| all.concat());
                    for relation in relations {
                        self.relation(scope, relation, fixed.as_deref(), &mut all)?;
                    }
                }
                _ => {
                    for _ in self.tuples(scope, &claim.loops)? {
                        let kind = *kinds.get(all.len())?;
                        let property = kind.and_then(|kind| self.property(scope, family, kind));
                        all.push(property.map(|all| Claimed { fixed: Vec::new(), all }));
                    }
                }
            }
        }
        (all.len() == kinds.len()).then_some(all)
    }

    /// The variables that have a value in an `at` block: one, or all shape parameters that share a name.
    fn fixed(&mut self, scope: &Scope<'_>, binding: &Binding) -> Option<Vec<(usize, Term)>> {
        let Binding { name, value, indices } = binding;
        let value = self.scalar(scope, value)?;
        let value = self.number_of(&value).map_or(value, Term::Number);
        let index = indices.iter().map(|i| self.whole(scope, i)).collect::<Option<Vec<i64>>>()?;
        if index.is_empty() {
            let several = scope.indexed(&name.text);
            if !several.is_empty() {
                return Some(several.into_iter().map(|(_, v)| (v, value.clone())).collect());
            }
            return Some(vec![(scope.names.iter().position(|n| *n == name.text)?, value)]);
        }
        Some(vec![(scope.parameter(&name.text, &index)?, value)])
    }

    /// One equation, inequality or chain, for each value of its index variables.
    fn relation(
        &mut self,
        scope: &Scope<'_>,
        relation: &syntax::Relation,
        fixed: Option<&[(usize, Term)]>,
        all: &mut Vec<Option<Claimed>>,
    ) -> Option<()> {
        for values in self.tuples(scope, &relation.loops)? {
            let compared = scope.with(&values, || {
                let mut compared = Vec::new();
                let mut left = self.value(scope, &relation.left)?;
                let first = std::iter::once((relation.comparison, &relation.right));
                for (comparison, side) in first.chain(relation.chain.iter().map(|(sign, side)| (*sign, side)))
                {
                    let right = self.value(scope, side)?;
                    compared.extend(pairs(left, comparison, right.clone()));
                    left = right;
                }
                Some(compared)
            });
            all.push(compared.zip(fixed).map(|(all, fixed)| Claimed { fixed: fixed.to_vec(), all }));
        }
        Some(())
    }

    /// What a property says.
    fn property(&mut self, scope: &Scope<'_>, family: &Family, kind: &ClaimKind) -> Option<Vec<Compared>> {
        let calls: Vec<Term> = scope.functions.borrow().iter().map(|(_, f)| scope.call(*f)).collect();
        let equal = |left, right| Compared::new(left, Comparison::Equal, right);
        Some(match kind {
            ClaimKind::PartitionOfUnity => {
                let sum = Term::Sum(calls.into_iter().map(|x| (Sign::Plus, x)).collect());
                vec![equal(sum, Term::integer(1))]
            }
            ClaimKind::Nonnegative => {
                let one = |left| Compared::new(left, Comparison::GreaterEqual, Term::integer(0));
                calls.into_iter().map(one).collect()
            }
            ClaimKind::Symmetric => {
                let coordinates = scope.coordinates();
                let angle = family.domain.first().and_then(|p| family.analytic.angle(p.var));
                let mut all = Vec::new();
                for (this, that, arguments) in moves(family) {
                    let by: Vec<Term> = match angle {
                        // The polynomials are about its tangent.
                        Some(angle) => vec![reversed(family, angle)?],
                        None => arguments.iter().map(polynomial).collect(),
                    };
                    let put = |v: usize| coordinates.iter().position(|c| *c == v).map(|k| by[k].clone());
                    all.push(equal(calls.get(this)?.clone(), calls.get(that)?.put(&put)));
                }
                all
            }
            ClaimKind::Continuity(joint) if joint.next.is_empty() && family.analytic.is_empty() => {
                let (var, low, high) = family.interval()?;
                let mut derivatives = calls;
                let mut all = Vec::new();
                for k in 0..=joint.order {
                    if k > 0 {
                        derivatives =
                            derivatives.iter().map(|f| self.differentiated(scope, f, var.0)).collect();
                    }
                    let at = |f: Option<&Term>, x: &Rational| {
                        let x = Term::Number(x.clone());
                        f.map_or(Term::integer(0), |f| f.put(&|v| (v == var.0).then(|| x.clone())))
                    };
                    for i in 0..=derivatives.len() {
                        let before = i.checked_sub(1).and_then(|i| derivatives.get(i));
                        all.push(equal(at(before, low), at(derivatives.get(i), high)));
                    }
                }
                all
            }
            ClaimKind::Independent(_) => Vec::new(),
            _ => return None,
        })
    }
}

/// An angle as its range is run through from the other end: the sum of its ends minus itself. `None` for ends that are neither
/// numbers nor multiples of π.
fn reversed(family: &Family, angle: &Angle) -> Option<Term> {
    let [low, high] = &angle.limits;
    let (sum, itself) = (low + high, Term::Variable(angle.itself.0));
    let end = match (sum.as_constant(), family.analytic.pi) {
        (Some(x), _) if x.is_zero() => return Some(Term::Neg(Rc::new(itself))),
        (Some(x), _) => Term::Number(x),
        (None, pi) => {
            let pi = Fraction::var(pi?);
            Term::Number(sum.checked_div(&pi)?.as_constant()?).by(Term::Pi)
        }
    };
    Some(end.minus(itself))
}

/// Two sides component by component; a single 0 stands for all components.
fn pairs(left: Value, comparison: Comparison, right: Value) -> Vec<Compared> {
    let terms = |list: Vec<(Vec<i64>, Term)>| list.into_iter().map(|(_, x)| x).collect::<Vec<_>>();
    let (left, right) = match (left, right) {
        (Value::Scalar(l), Value::Scalar(r)) => (vec![l], vec![r]),
        (Value::List(l), Value::List(r)) => (terms(l), terms(r)),
        (Value::List(l), Value::Scalar(r)) => {
            let same = vec![r; l.len()];
            (terms(l), same)
        }
        (Value::Scalar(l), Value::List(r)) => (vec![l; r.len()], terms(r)),
    };
    left.into_iter().zip(right).map(|(left, right)| Compared::new(left, comparison, right)).collect()
}

/// A polynomial as it is expanded.
pub fn polynomial(p: &Poly) -> Term {
    let mut parts = Vec::new();
    for (monomial, coefficient) in p.terms() {
        let mut factors = vec![(Role::Factor, Term::Number(coefficient.clone()))];
        for var in p.variables() {
            let variable = Term::Variable(var.0);
            factors.extend(match monomial.exponent(var) {
                0 => None,
                1 => Some((Role::Factor, variable)),
                n => Some((Role::Factor, Term::Power(Rc::new(variable), u32::from(n)))),
            });
        }
        if factors.len() > 1 && coefficient.is_one() {
            factors.remove(0);
        }
        let only = if factors.len() == 1 { factors.pop() } else { None };
        parts.push((Sign::Plus, only.map_or(Term::Product(factors), |(_, only)| only)));
    }
    match parts.len() {
        0 => Term::integer(0),
        1 => parts.remove(0).1,
        _ => Term::Sum(parts),
    }
}
