//! Expressions of theorems.

use std::rc::Rc;

use super::super::value::parts;
use super::{PARAMETER, Quantity, TheoremReader, coordinate, coordinate_variable};
use crate::formulas::{Role, Sign, Term};
use crate::model::words::BUILTINS;
use crate::syntax::{Expr, ExprKind};

/// What an expression is.
#[derive(Clone)]
enum Value {
    Quantity(Quantity),
    /// A curve or surface, and the variables by which it is differentiated.
    Map(usize, Vec<usize>),
}

impl TheoremReader<'_, '_> {
    pub(super) fn scalar(&mut self, expr: &Expr) -> Option<Term> {
        match self.quantity(expr)? {
            Quantity::Scalar(term) => Some(term),
            _ => None,
        }
    }

    pub(super) fn quantity(&mut self, expr: &Expr) -> Option<Quantity> {
        match self.value(expr)? {
            Value::Quantity(value) => Some(value),
            Value::Map(..) => None,
        }
    }

    fn value(&mut self, expr: &Expr) -> Option<Value> {
        self.reader.spend(1)?;
        let value = match &expr.kind {
            ExprKind::Number(n) => Quantity::Scalar(Term::Number(n.clone())),
            ExprKind::Name(name) => return self.named(name),
            ExprKind::Neg(inner) => match self.quantity(inner)? {
                Quantity::Scalar(Term::Number(n)) => Quantity::Scalar(Term::Number(-&n)),
                value => value.each(&mut |x| Term::Neg(Rc::new(x))),
            },
            ExprKind::Sum(parts) => {
                let mut values = Vec::new();
                for (sign, part) in parts {
                    values.push((*sign, self.quantity(part)?));
                }
                sum(values)?
            }
            ExprKind::Product(parts) => {
                let mut values = Vec::new();
                for (role, part) in parts {
                    values.push((*role, self.quantity(part)?));
                }
                product(values)?
            }
            ExprKind::Power(base, exponent) => {
                let (base, exponent) = (self.scalar(base)?, self.whole(exponent)?);
                let power = Term::Power(Rc::new(base), u32::try_from(exponent.abs()).ok()?);
                Quantity::Scalar(if exponent < 0 {
                    Term::Product(vec![(Role::Factor, Term::integer(1)), (Role::Divisor, power)])
                } else {
                    power
                })
            }
            ExprKind::Index(base, indices) => self.indexed(base, indices, expr)?,
            ExprKind::Call(callee, arguments) => return self.call(callee, arguments, expr),
            ExprKind::Tuple(parts) => {
                Quantity::Vector(parts.iter().map(|x| self.scalar(x)).collect::<Option<_>>()?)
            }
            ExprKind::List(_) | ExprKind::Each(..) => return None,
        };
        Some(Value::Quantity(value))
    }

    fn named(&mut self, name: &str) -> Option<Value> {
        if let Some(value) = self.scope.constant(name) {
            return Some(Value::Quantity(Quantity::Scalar(Term::integer(value))));
        }
        if let Some(patch) = self.patches.iter().position(|p| p.name == name) {
            return Some(Value::Map(patch, Vec::new()));
        }
        if let Some((_, value)) = self.values.iter().find(|(n, _)| n == name) {
            let value = value.clone();
            self.reader.spend(value.terms().map(parts).sum())?;
            return Some(Value::Quantity(value));
        }
        if let Some(var) = self.scope.names.iter().position(|n| n == name) {
            return Some(Value::Quantity(Quantity::Scalar(Term::Variable(var))));
        }
        // The last barycentric coordinate, which no scalar stands for.
        let patch =
            self.patches.iter().find(|p| p.dependent && p.parameters.last().is_some_and(|n| n == name))?;
        let others = patch.parameters.split_last()?.1.iter();
        let others = others
            .map(|n| Some((Sign::Minus, Term::Variable(self.scope.names.iter().position(|m| m == n)?))));
        let others = others.collect::<Option<Vec<_>>>()?;
        let all = std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect();
        Some(Value::Quantity(Quantity::Scalar(Term::Sum(all))))
    }

    /// `P[1]` is a control point, `γ[1]` a scalar with an index, `P(t)[0]` a coordinate.
    fn indexed(&mut self, base: &Expr, indices: &[Expr], whole: &Expr) -> Option<Quantity> {
        if let ExprKind::Name(name) = &base.kind {
            if let Some(patch) = self.patches.iter().position(|p| p.name == *name) {
                let index = self.indices(indices)?;
                let at = self.patches[patch].functions.iter().position(|(i, _)| *i == index)?;
                return Some(Quantity::Vector(self.point(patch, at)?));
            }
            if self.values.iter().all(|(n, _)| n != name) {
                let name = self.name(whole)?;
                let Value::Quantity(value) = self.named(&name)? else { return None };
                return Some(value);
            }
        }
        let Quantity::Vector(coordinates) = self.quantity(base)? else { return None };
        self.theorem.dimension?;
        let [k] = self.indices(indices)?[..] else { return None };
        Some(Quantity::Scalar(coordinates.get(usize::try_from(k).ok()?)?.clone()))
    }

    fn call(&mut self, callee: &Expr, arguments: &[Expr], whole: &Expr) -> Option<Value> {
        if let ExprKind::Name(name) = &callee.kind {
            match (name.as_str(), arguments) {
                ("D", _) => return self.derivative(arguments),
                ("integral", _) => return None,
                ("cross", [a, b]) => return self.cross(a, b).map(Value::Quantity),
                ("dot", [a, b]) => return self.dot(a, b).map(Value::Quantity),
                ("sum", [Expr { kind: ExprKind::Each(body, loops), .. }]) => {
                    let mut values = Vec::new();
                    for index in self.reader.tuples(&self.scope, loops)? {
                        values.push((Sign::Plus, self.with(&index, |all| all.quantity(body))?));
                    }
                    return sum(values).map(Value::Quantity);
                }
                _ if BUILTINS.contains(&name.as_str()) => {
                    let number = self.reader.scalar(&self.scope, whole)?;
                    return Some(Value::Quantity(Quantity::Scalar(number)));
                }
                _ => {}
            }
        }
        let Value::Map(patch, steps) = self.value(callee)? else { return None };
        let mut by = Vec::new();
        for argument in arguments {
            by.push(self.scalar(argument)?);
        }
        self.at(patch, &steps, &by).map(|x| Value::Quantity(Quantity::Vector(x)))
    }

    /// P(t), D(S, v, 2)(u, 0): the sum of functions times points, differentiated, and then the arguments put in.
    fn at(&mut self, patch: usize, steps: &[usize], by: &[Term]) -> Option<Vec<Term>> {
        if by.len() != self.patches[patch].parameters.len() {
            return None;
        }
        let mut sums: Vec<Vec<(Sign, Term)>> = vec![Vec::new(); self.theorem.dimension.unwrap_or(1)];
        for at in 0..self.patches[patch].functions.len() {
            let f = self.patches[patch].functions[at].1.clone();
            for (sum, x) in sums.iter_mut().zip(self.point(patch, at)?) {
                sum.push((Sign::Plus, f.clone().by(x)));
            }
        }
        let own = self.patches[patch].parameters.len();
        let dependent = (self.patches[patch].dependent && !steps.is_empty()).then(|| {
            let others = (0..own - 1).map(|k| (Sign::Minus, Term::Variable(PARAMETER + k)));
            let all = std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect();
            (PARAMETER + own - 1, Term::Sum(all))
        });
        let mut coordinates = Vec::new();
        for sum in sums {
            let mut term = Term::Sum(sum);
            if let Some((last, rest)) = &dependent {
                term = term.put(&|v| (v == *last).then(|| rest.clone()));
            }
            for var in steps {
                term = self.differentiated(&term, *var);
            }
            coordinates.push(term.put(&|v| by.get(v.checked_sub(PARAMETER)?).cloned()));
        }
        self.reader.spend(coordinates.iter().map(parts).sum())?;
        Some(coordinates)
    }

    fn differentiated(&mut self, term: &Term, var: usize) -> Term {
        let bound = self.reader.fresh;
        self.reader.fresh += 1;
        let body = term.put(&|v| (v == var).then_some(Term::Variable(bound)));
        Term::Derivative { body: Rc::new(body), bound, at: Rc::new(Term::Variable(var)) }
    }

    /// `D(P)`, `D(S, v, 2)` of a curve or surface; `D(x, t)` of a scalar or vector.
    fn derivative(&mut self, arguments: &[Expr]) -> Option<Value> {
        let (subject, rest) = arguments.split_first()?;
        let value = self.value(subject)?;
        let only = |all: &Self| match &value {
            Value::Map(patch, _) if all.patches[*patch].parameters.len() == 1 => Some(PARAMETER),
            _ => None,
        };
        let mut steps: Vec<usize> = Vec::new();
        for argument in rest {
            let name = match &argument.kind {
                ExprKind::Name(_) | ExprKind::Index(..) => self.name(argument),
                _ => None,
            };
            match name.filter(|n| self.scope.constant(n).is_none()) {
                Some(name) => steps.push(self.step(&value, &name)?),
                None => {
                    let order = usize::try_from(self.whole(argument)?).ok()?;
                    let var = match steps.pop() {
                        Some(var) => var,
                        None => only(self)?,
                    };
                    steps.extend(std::iter::repeat_n(var, order));
                }
            }
        }
        if rest.is_empty() {
            steps.push(only(self)?);
        }
        Some(match value {
            Value::Map(patch, before) => Value::Map(patch, [before, steps].concat()),
            Value::Quantity(value) => Value::Quantity(value.each(&mut |mut x| {
                for var in &steps {
                    x = self.differentiated(&x, *var);
                }
                x
            })),
        })
    }

    /// The variable by which a name says to differentiate.
    fn step(&self, value: &Value, name: &str) -> Option<usize> {
        if let Value::Map(patch, _) = value {
            let patch = &self.patches[*patch];
            let own = patch.parameters.len() - usize::from(patch.dependent);
            if let Some(k) = patch.parameters[..own].iter().position(|p| p == name) {
                return Some(PARAMETER + k);
            }
        }
        self.scope.names.iter().position(|n| n == name)
    }

    fn cross(&mut self, a: &Expr, b: &Expr) -> Option<Quantity> {
        let (Quantity::Vector(a), Quantity::Vector(b)) = (self.quantity(a)?, self.quantity(b)?) else {
            return None;
        };
        let minor = |p: usize, q: usize| a[p].clone().by(b[q].clone()).minus(a[q].clone().by(b[p].clone()));
        Some(match self.theorem.dimension {
            None => {
                let (a, b) = (a.first()?, b.first()?);
                Quantity::Outer(a.clone().by(other(b)).minus(other(a).by(b.clone())))
            }
            Some(2) => Quantity::Scalar(minor(0, 1)),
            Some(3) => Quantity::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)]),
            Some(_) => return None,
        })
    }

    fn dot(&mut self, a: &Expr, b: &Expr) -> Option<Quantity> {
        let (Quantity::Vector(a), Quantity::Vector(b)) = (self.quantity(a)?, self.quantity(b)?) else {
            return None;
        };
        self.theorem.dimension?;
        let parts = a.into_iter().zip(b).map(|(x, y)| (Sign::Plus, x.by(y)));
        Some(Quantity::Scalar(Term::Sum(parts.collect())))
    }
}

impl Quantity {
    /// Its formulas.
    pub fn terms(&self) -> impl Iterator<Item = &Term> {
        match self {
            Self::Scalar(x) | Self::Outer(x) => std::slice::from_ref(x).iter(),
            Self::Vector(all) => all.iter(),
        }
    }

    /// The same done to each formula.
    fn each(self, with: &mut dyn FnMut(Term) -> Term) -> Self {
        match self {
            Self::Scalar(x) => Self::Scalar(with(x)),
            Self::Vector(all) => Self::Vector(all.into_iter().map(with).collect()),
            Self::Outer(x) => Self::Outer(with(x)),
        }
    }
}

/// The coordinate with the number j in place of that with the number i.
fn other(term: &Term) -> Term {
    term.put(&|v| match coordinate(v) {
        Some((point, 0)) => Some(Term::Variable(coordinate_variable(point, 1))),
        _ => None,
    })
}

/// A sum of scalars or of vectors.
fn sum(values: Vec<(Sign, Quantity)>) -> Option<Quantity> {
    let mut sums: Vec<Vec<(Sign, Term)>> = Vec::new();
    let first = values.first()?.1.clone();
    for (sign, value) in values {
        if std::mem::discriminant(&value) != std::mem::discriminant(&first) {
            return None;
        }
        sums.resize(sums.len().max(value.terms().count()), Vec::new());
        for (sum, x) in sums.iter_mut().zip(value.terms()) {
            sum.push((sign, x.clone()));
        }
    }
    let mut sums = sums.into_iter().map(|mut parts| match parts.first() {
        // The first sign is plus.
        Some((Sign::Minus, _)) => {
            parts.insert(0, (Sign::Plus, Term::integer(0)));
            Term::Sum(parts)
        }
        _ => Term::Sum(parts),
    });
    Some(first.each(&mut |_| sums.next().unwrap_or(Term::integer(0))))
}

/// A product of scalars with at most one vector.
fn product(values: Vec<(Role, Quantity)>) -> Option<Quantity> {
    let mut vector: Option<Quantity> = None;
    // The place of the vector is empty.
    let mut parts: Vec<(Role, Option<Term>)> = Vec::new();
    for (role, value) in values {
        match value {
            Quantity::Scalar(x) => parts.push((role, Some(x))),
            value if vector.is_none() && role == Role::Factor => {
                vector = Some(value);
                parts.push((role, None));
            }
            _ => return None,
        }
    }
    let with = |x: Option<Term>| {
        let part = |(role, part): &(Role, Option<Term>)| Some((*role, part.clone().or_else(|| x.clone())?));
        parts.iter().map(part).collect::<Option<_>>().map(Term::Product)
    };
    match vector {
        None => with(None).map(Quantity::Scalar),
        Some(vector) => Some(vector.each(&mut |x| with(Some(x)).unwrap_or(Term::integer(0)))),
    }
}
