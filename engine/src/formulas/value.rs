//! From expressions to terms.

use std::rc::Rc;

use basis_prover::collections::sort::{sort, sort_by_key};

use super::scope::{Constants, Reader, Scope, Value, parameters};
use super::{Circular, Comparison, Role, Sign, Term};
use crate::algebra::number::binomial;
use crate::algebra::rational::Rational;
use crate::model::tuples::multi_indices;
use crate::model::words::{BUILTINS, CIRCULAR, PI};
use crate::syntax::{Condition, Expr, ExprKind, Generator, Loops};

/// Terms with their signs.
type Signed = Vec<(Sign, Term)>;

/// A family that an expression names, perhaps with its order and shape values.
struct Named<'e> {
    name: &'e str,
    orders: &'e [Expr],
    shapes: &'e [Expr],
}

impl Reader<'_, '_> {
    /// The values of the index variables of a loop.
    pub(super) fn tuples(&mut self, scope: &Scope<'_>, loops: &Loops) -> Option<Vec<Constants>> {
        let mut all: Vec<Constants> = vec![Vec::new()];
        for generator in &loops.generators {
            let mut longer = Vec::new();
            for start in all {
                match generator {
                    Generator::Range(range) => {
                        let (low, high) = scope.with(&start, || {
                            Some((self.whole(scope, &range.low)?, self.whole(scope, &range.high)?))
                        })?;
                        let values = low..=high - i64::from(!range.inclusive);
                        longer.extend(values.map(|i| [&start[..], &[(range.name.text.clone(), i)]].concat()));
                    }
                    Generator::Simplex(names, sum) => {
                        let sum = scope.with(&start, || self.whole(scope, sum))?;
                        for index in multi_indices(names.len(), sum, usize::MAX - 1) {
                            let new = names.iter().map(|n| n.text.clone()).zip(index);
                            longer.push(start.iter().cloned().chain(new).collect());
                        }
                    }
                }
            }
            self.spend(longer.len())?;
            all = longer;
        }
        let Some(condition) = &loops.condition else { return Some(all) };
        let mut kept = Vec::new();
        for values in all {
            if scope.with(&values, || self.holds(scope, condition))? {
                kept.push(values);
            }
        }
        Some(kept)
    }

    fn holds(&mut self, scope: &Scope<'_>, condition: &Condition) -> Option<bool> {
        Some(match condition {
            Condition::Compare(a, sign, b) => {
                let (x, y) = (self.number(scope, a)?, self.number(scope, b)?);
                match sign {
                    Comparison::Equal => x == y,
                    Comparison::NotEqual => x != y,
                    Comparison::Less => x < y,
                    Comparison::LessEqual => x <= y,
                    Comparison::Greater => x > y,
                    Comparison::GreaterEqual => x >= y,
                }
            }
            Condition::All(parts) => {
                for part in parts {
                    if !self.holds(scope, part)? {
                        return Some(false);
                    }
                }
                true
            }
            Condition::Any(parts) => {
                for part in parts {
                    if self.holds(scope, part)? {
                        return Some(true);
                    }
                }
                false
            }
            Condition::Not(inner) => !self.holds(scope, inner)?,
        })
    }

    /// The whole number that an expression is.
    pub(super) fn whole(&mut self, scope: &Scope<'_>, expr: &Expr) -> Option<i64> {
        self.number(scope, expr)?.to_i64()
    }

    /// The number that an expression is.
    fn number(&mut self, scope: &Scope<'_>, expr: &Expr) -> Option<Rational> {
        let term = self.scalar(scope, expr)?;
        self.number_of(&term)
    }

    /// The number that a term without variables is.
    pub(super) fn number_of(&self, term: &Term) -> Option<Rational> {
        Some(match term {
            Term::Number(n) => n.clone(),
            Term::Variable(_)
            | Term::Pi
            | Term::Circular(..)
            | Term::Derivative { .. }
            | Term::Integral { .. } => return None,
            Term::Neg(x) => -self.number_of(x)?,
            Term::Sum(parts) => {
                let mut sum = Rational::ZERO;
                for (sign, x) in parts {
                    let x = self.number_of(x)?;
                    sum = if *sign == Sign::Minus { &sum - &x } else { &sum + &x };
                }
                sum
            }
            Term::Product(parts) => {
                let mut product = Rational::ONE;
                for (role, x) in parts {
                    let x = self.number_of(x)?;
                    product = if *role == Role::Divisor { product.checked_div(&x)? } else { &product * &x };
                }
                product
            }
            Term::Power(x, n) => self.number_of(x)?.pow(*n),
            Term::Call(f, args) => {
                let args: Vec<Rational> = args.iter().map(|x| self.number_of(x)).collect::<Option<_>>()?;
                let value = &self.definitions[*f].value;
                self.number_of(&value.put(&|v| args.get(v).cloned().map(Term::Number)))?
            }
        })
    }

    /// The one formula that an expression is.
    pub(super) fn scalar(&mut self, scope: &Scope<'_>, expr: &Expr) -> Option<Term> {
        match self.value(scope, expr)? {
            Value::Scalar(term) => Some(term),
            Value::List(_) => None,
        }
    }

    /// What an expression is; `None` when it has no counterpart.
    pub(super) fn value(&mut self, scope: &Scope<'_>, expr: &Expr) -> Option<Value> {
        self.spend(1)?;
        Some(match &expr.kind {
            ExprKind::Number(n) => Value::Scalar(Term::Number(n.clone())),
            ExprKind::Name(name) => return self.named(scope, name),
            ExprKind::Neg(inner) => each(self.value(scope, inner)?, &mut |x| match x {
                Term::Number(n) => Term::Number(-n),
                x => Term::Neg(Rc::new(x)),
            }),
            ExprKind::Sum(parts) => {
                let mut values = Vec::new();
                for (sign, part) in parts {
                    values.push((*sign, self.value(scope, part)?));
                }
                return together(values);
            }
            ExprKind::Product(parts) => {
                let mut values = Vec::new();
                for (role, part) in parts {
                    values.push((*role, self.value(scope, part)?));
                }
                return product(values);
            }
            ExprKind::Power(base, exponent) => {
                let (base, exponent) = (self.scalar(scope, base)?, self.whole(scope, exponent)?);
                let power = Term::Power(Rc::new(base), u32::try_from(exponent.abs()).ok()?);
                Value::Scalar(if exponent < 0 {
                    Term::Product(vec![(Role::Factor, Term::integer(1)), (Role::Divisor, power)])
                } else {
                    power
                })
            }
            ExprKind::Index(base, indices) => {
                let index = indices.iter().map(|i| self.whole(scope, i)).collect::<Option<Vec<i64>>>()?;
                if matches!(&base.kind, ExprKind::Name(name) if *name == scope.function_name) {
                    let place = self.function(scope, &index);
                    return Some(Value::Scalar(match place {
                        Some(place) => scope.call(place),
                        None if *scope.missing_is_zero.borrow() => Term::integer(0),
                        None => return None,
                    }));
                }
                if let ExprKind::Name(name) = &base.kind
                    && let Some(var) = scope.parameter(name, &index)
                {
                    return Some(Value::Scalar(Term::Variable(var)));
                }
                let Value::List(list) = self.value(scope, base)? else { return None };
                Value::Scalar(list.into_iter().find(|(i, _)| *i == index)?.1)
            }
            ExprKind::Call(callee, arguments) => return self.call(scope, callee, arguments),
            ExprKind::List(parts) => {
                let parts = parts.iter().map(|x| self.scalar(scope, x)).collect::<Option<Vec<Term>>>()?;
                Value::List(numbered(parts))
            }
            ExprKind::Tuple(_) => return None,
            ExprKind::Each(body, loops) => Value::List(numbered(self.collect(scope, body, loops)?)),
        })
    }

    /// The formulas for all values of index variables.
    fn collect(&mut self, scope: &Scope<'_>, body: &Expr, loops: &Loops) -> Option<Vec<Term>> {
        let mut all = Vec::new();
        for values in self.tuples(scope, loops)? {
            all.push(scope.with(&values, || self.scalar(scope, body))?);
        }
        Some(all)
    }

    fn named(&mut self, scope: &Scope<'_>, name: &str) -> Option<Value> {
        if let Some(value) = scope.constant(name) {
            return Some(Value::Scalar(Term::integer(value)));
        }
        let argument = scope.arguments.borrow().iter().find(|(n, _)| n == name).map(|(_, x)| x.clone());
        if let Some(value) = argument {
            self.spend(size(&value))?;
            return Some(value);
        }
        if PI.contains(&name) {
            return Some(Value::Scalar(Term::Pi));
        }
        if let Some(var) = scope.names.iter().position(|n| n == name) {
            return Some(Value::Scalar(Term::Variable(var)));
        }
        let several = scope.indexed(name);
        if !several.is_empty() {
            return Some(Value::List(several.into_iter().map(|(i, v)| (i, Term::Variable(v))).collect()));
        }
        if let Some(def) = scope.lets.iter().find(|def| def.name.text == name && def.parameters.is_empty()) {
            return self.given(scope, def);
        }
        if name == scope.function_name {
            self.all(scope)?;
            let list: Vec<_> =
                scope.functions.borrow().iter().map(|(i, f)| (i.clone(), scope.call(*f))).collect();
            self.spend(list.len() * scope.names.len())?;
            return Some(Value::List(list));
        }
        self.other(scope, &Named { name, orders: &[], shapes: &[] }, None)
    }

    /// Has all functions read.
    fn all(&mut self, scope: &Scope<'_>) -> Option<()> {
        while let Some(index) = scope.next() {
            self.function(scope, &index)?;
        }
        Some(())
    }

    /// The functions of another family, in the domain variables here or with arguments in place of its own.
    fn other(&mut self, scope: &Scope<'_>, named: &Named<'_>, arguments: Option<&[Expr]>) -> Option<Value> {
        let order = named.orders.iter().map(|o| self.whole(scope, o)).collect::<Option<Vec<i64>>>()?;
        let family = self.library.family(scope.unit, named.name, &order).ok()?;
        let (shapes, arguments) = match arguments {
            None if family.shapes.is_empty() && !named.orders.is_empty() && !named.shapes.is_empty() => {
                (&[][..], Some(named.shapes))
            }
            _ => (named.shapes, arguments),
        };
        let mut args = shapes.iter().map(|x| self.scalar(scope, x)).collect::<Option<Vec<Term>>>()?;
        match arguments {
            Some(arguments) => {
                // In the order of the variables' numbers, in which the last coordinates of simplices follow the others.
                let mut all = Vec::new();
                for (p, x) in family.domain_variables().zip(arguments) {
                    all.push((p.var, self.scalar(scope, x)?));
                }
                sort_by_key(&mut all, |(var, _)| *var);
                args.extend(all.into_iter().map(|(_, x)| x));
            }
            None => {
                let mut own = scope.coordinates();
                sort(&mut own);
                args.extend(own.into_iter().map(Term::Variable));
            }
        }
        if args.len() != parameters(&family).len() {
            return None;
        }
        let functions = self.inside(|reader| reader.family(scope.unit, named.name, &order))?;
        let list = functions.iter().map(|(i, f)| (i.clone(), Term::Call(*f, args.clone())));
        let value = Value::List(list.collect());
        self.spend(size(&value))?;
        Some(value)
    }

    /// The family that an expression names, with its order and shape values.
    fn family_named<'e>(&self, scope: &Scope<'_>, expr: &'e Expr) -> Option<Named<'e>> {
        let free = |name: &str| !scope.is_taken(name) && self.library.knows(scope.unit, name);
        let ordered = |name: &str| self.library.order_count(scope.unit, name) > 0;
        match &expr.kind {
            ExprKind::Name(name) if free(name) && !ordered(name) => {
                Some(Named { name, orders: &[], shapes: &[] })
            }
            ExprKind::Call(inner, arguments) => match &inner.kind {
                ExprKind::Name(name) if free(name) && ordered(name) => {
                    Some(Named { name, orders: arguments, shapes: &[] })
                }
                ExprKind::Name(name) if free(name) => Some(Named { name, orders: &[], shapes: arguments }),
                ExprKind::Call(..) => {
                    let named = self.family_named(scope, inner)?;
                    let room = named.shapes.is_empty() && ordered(named.name);
                    room.then_some(Named { shapes: arguments, ..named })
                }
                _ => None,
            },
            _ => None,
        }
    }

    fn call(&mut self, scope: &Scope<'_>, callee: &Expr, arguments: &[Expr]) -> Option<Value> {
        if let ExprKind::Name(name) = &callee.kind {
            let def = scope.lets.iter().find(|def| def.name.text == *name && !def.parameters.is_empty());
            if let Some(def) = def {
                let mut own = Vec::new();
                for (parameter, argument) in def.parameters.iter().zip(arguments) {
                    own.push((parameter.text.clone(), self.value(scope, argument)?));
                }
                return self.inside(|reader| scope.alone(own, || reader.value(scope, &def.value)));
            }
            if name == "D" {
                return self.derivative(scope, arguments);
            }
            if name == "integral" {
                return self.integral(scope, arguments);
            }
            if BUILTINS.contains(&name.as_str()) {
                return self.builtin(scope, name, arguments);
            }
            if let ([x], true) = (arguments, CIRCULAR.contains(&name.as_str())) {
                let x = Rc::new(self.scalar(scope, x)?);
                let (sine, cosine) =
                    (Term::Circular(Circular::Sin, Rc::clone(&x)), Term::Circular(Circular::Cos, x));
                return Some(Value::Scalar(match name.as_str() {
                    "sin" => sine,
                    "cos" => cosine,
                    _ => Term::Product(vec![(Role::Factor, sine), (Role::Divisor, cosine)]),
                }));
            }
        }
        let (inner, index) = match &callee.kind {
            ExprKind::Index(inner, index) => (&**inner, Some(index)),
            _ => (callee, None),
        };
        if let Some(named) = self.family_named(scope, inner) {
            if let Some(index) = index {
                let index = index.iter().map(|i| self.whole(scope, i)).collect::<Option<Vec<i64>>>()?;
                let Value::List(list) = self.other(scope, &named, Some(arguments))? else { return None };
                return Some(Value::Scalar(list.into_iter().find(|(i, _)| *i == index)?.1));
            }
            let whole =
                matches!(&inner.kind, ExprKind::Call(inner, _) if !matches!(inner.kind, ExprKind::Name(_)));
            if whole || named.orders.is_empty() && !named.shapes.is_empty() {
                return self.other(scope, &named, Some(arguments));
            }
        }
        if let Some(named) = self.family_called(scope, callee, arguments) {
            return self.other(scope, &named, None);
        }
        // f(x): arguments in place of the domain variables.
        let value = self.value(scope, callee)?;
        let by = arguments.iter().map(|x| self.scalar(scope, x)).collect::<Option<Vec<Term>>>()?;
        let coordinates = scope.coordinates();
        if by.len() != coordinates.len() {
            return None;
        }
        let put = |v: usize| coordinates.iter().position(|c| *c == v).map(|k| by[k].clone());
        let value = each(value, &mut |term| term.put(&put));
        self.spend(size(&value))?;
        Some(value)
    }

    /// The family that a callee with these arguments names.
    fn family_called<'e>(
        &self,
        scope: &Scope<'_>,
        callee: &'e Expr,
        arguments: &'e [Expr],
    ) -> Option<Named<'e>> {
        let ordered = |name: &str| self.library.order_count(scope.unit, name) > 0;
        match &callee.kind {
            ExprKind::Name(name) if ordered(name) && !scope.is_taken(name) => {
                Some(Named { name, orders: arguments, shapes: &[] })
            }
            ExprKind::Name(name) if self.library.knows(scope.unit, name) && !scope.is_taken(name) => {
                Some(Named { name, orders: &[], shapes: arguments })
            }
            ExprKind::Call(..) => {
                let named = self.family_named(scope, callee)?;
                (named.shapes.is_empty() && ordered(named.name))
                    .then_some(Named { shapes: arguments, ..named })
            }
            _ => None,
        }
    }

    fn builtin(&mut self, scope: &Scope<'_>, name: &str, arguments: &[Expr]) -> Option<Value> {
        let number = match (name, arguments) {
            ("sum" | "product", [one]) => {
                let list = match &one.kind {
                    ExprKind::Each(body, loops) => self.collect(scope, body, loops)?,
                    _ => match self.value(scope, one)? {
                        Value::List(list) => list.into_iter().map(|(_, x)| x).collect(),
                        Value::Scalar(x) => vec![x],
                    },
                };
                return Some(Value::Scalar(match (name, list.is_empty()) {
                    ("sum", true) => Term::integer(0),
                    (_, true) => Term::integer(1),
                    ("sum", _) => Term::Sum(list.into_iter().map(|x| (Sign::Plus, x)).collect()),
                    _ => Term::Product(list.into_iter().map(|x| (Role::Factor, x)).collect()),
                }));
            }
            ("binomial", [n, k]) => {
                let (n, k) = (self.whole(scope, n)?, self.whole(scope, k)?);
                u32::try_from(k)
                    .map_or(Some(Rational::ZERO), |k| Some(binomial(u32::try_from(n).ok()?, k)))?
            }
            ("factorial", [n]) => {
                let n = self.whole(scope, n)?;
                (1..=n).fold(Rational::ONE, |p, k| &p * &Rational::from(k))
            }
            ("floor", [x]) => self.number(scope, x)?.floor(),
            ("ceil", [x]) => -(-self.number(scope, x)?).floor(),
            ("min", [x, y]) => self.number(scope, x)?.min(self.number(scope, y)?),
            ("max", [x, y]) => self.number(scope, x)?.max(self.number(scope, y)?),
            _ => return None,
        };
        Some(Value::Scalar(Term::Number(number)))
    }

    /// D(f), D(f, 2), D(f, x), D(f, x, 2), D(f, x, y).
    fn derivative(&mut self, scope: &Scope<'_>, arguments: &[Expr]) -> Option<Value> {
        let (f, rest) = arguments.split_first()?;
        let only = || match scope.coordinates()[..] {
            [only] => Some(only),
            _ => None,
        };
        let mut steps: Vec<(usize, i64)> = Vec::new();
        for argument in rest {
            let name = match &argument.kind {
                ExprKind::Name(name) if scope.constant(name).is_none() => Some(name),
                _ => None,
            };
            match name {
                Some(name) => steps.push((scope.names.iter().position(|n| n == name)?, 1)),
                None => {
                    let order = self.whole(scope, argument)?;
                    match steps.last_mut() {
                        Some(last) => last.1 = order,
                        None => steps.push((only()?, order)),
                    }
                }
            }
        }
        if steps.is_empty() {
            steps.push((only()?, 1));
        }
        let value = self.value(scope, f)?;
        Some(each(value, &mut |mut term| {
            for (var, order) in &steps {
                for _ in 0..*order {
                    term = self.differentiated(scope, &term, *var);
                }
            }
            term
        }))
    }

    /// ∂f/∂x; on a simplex the last coordinate is 1 minus the others meanwhile.
    pub(super) fn differentiated(&mut self, scope: &Scope<'_>, term: &Term, var: usize) -> Term {
        let bound = self.fresh;
        self.fresh += 1;
        let here = |v: usize| Term::Variable(if v == var { bound } else { v });
        let simplex = scope.simplex_of(var);
        let rest = |others: &[usize]| {
            let others = others.iter().map(|c| (Sign::Minus, here(*c)));
            Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect())
        };
        let body = term.put(&|v| match &simplex {
            _ if v == var => Some(here(v)),
            Some((others, last)) if v == *last => Some(rest(others)),
            _ => None,
        });
        Term::Derivative { body: Rc::new(body), bound, at: Rc::new(Term::Variable(var)) }
    }
}

/// A list with positions for indices.
fn numbered(terms: Vec<Term>) -> Vec<(Vec<i64>, Term)> {
    terms.into_iter().enumerate().map(|(k, x)| (vec![k as i64], x)).collect()
}

/// The same done to each formula.
pub(super) fn each(value: Value, with: &mut dyn FnMut(Term) -> Term) -> Value {
    match value {
        Value::Scalar(x) => Value::Scalar(with(x)),
        Value::List(list) => Value::List(list.into_iter().map(|(i, x)| (i, with(x))).collect()),
    }
}

/// The sum of parts that are all single formulas, or all lists of one length.
pub(super) fn together(parts: Vec<(Sign, Value)>) -> Option<Value> {
    let mut lists: Vec<(Vec<i64>, Signed)> = Vec::new();
    let mut scalars = Vec::new();
    for (sign, part) in parts {
        match part {
            Value::Scalar(x) => scalars.push((sign, x)),
            Value::List(list) if lists.is_empty() => {
                lists = list.into_iter().map(|(i, x)| (i, vec![(sign, x)])).collect();
            }
            Value::List(list) => {
                for ((_, parts), (_, x)) in lists.iter_mut().zip(list) {
                    parts.push((sign, x));
                }
            }
        }
    }
    match (lists.is_empty(), scalars.is_empty()) {
        (true, _) => Some(Value::Scalar(Term::Sum(scalars))),
        (false, true) => {
            Some(Value::List(lists.into_iter().map(|(i, parts)| (i, Term::Sum(parts))).collect()))
        }
        (false, false) => None,
    }
}

/// A product with at most one list among its parts.
fn product(parts: Vec<(Role, Value)>) -> Option<Value> {
    let mut list: Option<Vec<(Vec<i64>, Term)>> = None;
    let mut scalars = Vec::new();
    for (k, (role, part)) in parts.into_iter().enumerate() {
        match part {
            Value::Scalar(x) => scalars.push((k, role, x)),
            Value::List(l) if list.is_none() && role == Role::Factor => list = Some(l),
            Value::List(_) => return None,
        }
    }
    let Some(list) = list else {
        return Some(Value::Scalar(Term::Product(
            scalars.into_iter().map(|(_, role, x)| (role, x)).collect(),
        )));
    };
    let times = |x: Term| {
        let rest = scalars.iter().map(|(_, role, s)| (*role, s.clone()));
        Term::Product(std::iter::once((Role::Factor, x)).chain(rest).collect())
    };
    Some(Value::List(list.into_iter().map(|(i, x)| (i, times(x))).collect()))
}

/// How many parts the formulas of a value have.
pub(super) fn size(value: &Value) -> usize {
    match value {
        Value::Scalar(x) => parts(x),
        Value::List(list) => list.iter().map(|(_, x)| parts(x)).sum(),
    }
}

pub(super) fn parts(term: &Term) -> usize {
    1 + match term {
        Term::Number(_) | Term::Variable(_) | Term::Pi => 0,
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => parts(x),
        Term::Sum(list) => list.iter().map(|(_, x)| parts(x)).sum(),
        Term::Product(list) => list.iter().map(|(_, x)| parts(x)).sum(),
        Term::Call(_, args) => args.iter().map(parts).sum(),
        Term::Derivative { body, at, .. } => parts(body) + parts(at),
        Term::Integral { body, low, high, .. } => parts(body) + parts(low) + parts(high),
    }
}
