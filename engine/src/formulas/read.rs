//! From syntax trees to terms.

use std::rc::Rc;

use super::{Claimed, Compared, Comparison, Definition, Formulas, Role, Sign, Term};
use crate::algebra::number::binomial;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind};
use crate::model::label;
use crate::model::tuples::{grid, multi_indices};
use crate::model::{Family, Library};
use crate::state::moves;
use crate::syntax::{self, Binding, Expr, ExprKind, FunctionDef, Generator, Loops, StatementKind};
use basis_prover::map::SortedMap;

/// Functions by their indices.
type Functions = SortedMap<Vec<i64>, usize>;

/// The spec and the place of a family, and its order.
type Key = (usize, usize, Vec<i64>);

/// Terms with their signs.
type Signed = Vec<(Sign, Term)>;

/// One formula or several, each with its index.
enum Value {
    Scalar(Term),
    List(Vec<(Vec<i64>, Term)>),
}

/// What is known of the families that were read: by the place of the family and its order, their functions.
struct Reader<'a, 'f> {
    library: &'a Library<'f>,
    definitions: Vec<Definition>,
    known: Vec<(Key, Functions)>,
    /// The number of the next variable of a derivative.
    fresh: usize,
}

/// The variables of derivatives have numbers from here on.
const BOUND: usize = 1 << 20;

/// The formulas of a family of the spec that was asked for, and of its claims; `None` when something in them has no
/// counterpart.
pub fn of(library: &Library<'_>, family: &Family, claims: &[Claim]) -> Option<Formulas> {
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    let (unit, written) = library.written(&family.name)?;
    let mut reader = Reader { library, definitions: Vec::new(), known: Vec::new(), fresh: BOUND };
    let functions = reader.family(unit, &family.name, &order)?;
    let places: Vec<usize> =
        family.functions.iter().map(|f| functions.get(&f.index).copied()).collect::<Option<_>>()?;
    let claimed = reader.claims(unit, written, family, functions, claims)?;
    Some(Formulas { definitions: reader.definitions, functions: places, claims: claimed })
}

/// What names mean while formulas of one family are read.
struct Scope {
    unit: usize,
    title: String,
    constants: Vec<(String, i64)>,
    lets: Vec<(String, Term)>,
    names: Vec<String>,
    /// The number of independent domain variables, which stand at the end of the names, before the dependent one.
    domain: usize,
    dependent: bool,
    function_name: String,
    functions: Functions,
    /// While an order is raised: functions outside of the order before are 0.
    missing_is_zero: bool,
}

impl Scope {
    fn new(unit: usize, family: &Family) -> Self {
        Self {
            unit,
            title: family.title(),
            constants: family.order.clone(),
            lets: Vec::new(),
            names: family.names.clone(),
            domain: family.domain.len(),
            dependent: family.is_simplex(),
            function_name: family.function_name.clone(),
            functions: SortedMap::new(),
            missing_is_zero: false,
        }
    }

    fn constant(&self, name: &str) -> Option<i64> {
        self.constants.iter().rev().find(|(n, _)| n == name).map(|(_, value)| *value)
    }

    /// The numbers of the domain variables, the dependent one last.
    fn coordinates(&self) -> Vec<usize> {
        (self.names.len() - self.domain - usize::from(self.dependent)..self.names.len()).collect()
    }

    /// A function at the point itself.
    fn call(&self, definition: usize) -> Term {
        Term::Call(definition, (0..self.names.len()).map(Term::Variable).collect())
    }
}

impl Reader<'_, '_> {
    /// The functions of a family of one order, defined now or before.
    fn family(&mut self, unit: usize, name: &str, order: &[i64]) -> Option<Functions> {
        let key =
            self.library.place_of(unit, name).map(|(unit, position)| (unit, position, order.to_vec()))?;
        if let Some((_, functions)) = self.known.iter().find(|(known, _)| *known == key) {
            return Some(functions.clone());
        }
        let family = self.library.family(unit, name, order).ok()?;
        let written = self.library.tree(key.0, key.1)?;
        let mut scope = Scope::new(key.0, &family);
        let mut base: Option<(&str, i64)> = None;
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Let(name, value) => self.name(&mut scope, &name.text, value)?,
                StatementKind::Function(def) => self.functions(&mut scope, def)?,
                StatementKind::Base(Binding { name, value }, functions) => {
                    let lowest = self.whole(&scope, value)?;
                    let top = scope.constant(&name.text)? > lowest;
                    let title = scope.title.clone();
                    if top {
                        scope.title = format!("{title}, {} = {lowest}", name.text);
                    }
                    scope.constants.push((name.text.clone(), lowest));
                    for def in functions {
                        self.functions(&mut scope, def)?;
                    }
                    scope.constants.pop();
                    scope.title = title;
                    base = Some((&name.text, lowest));
                }
                StatementKind::Raise(def) => {
                    let (order, lowest) = base?;
                    self.raise(&mut scope, def, order, lowest)?;
                }
                _ => {}
            }
        }
        self.known.push((key, scope.functions.clone()));
        Some(scope.functions)
    }

    /// A name that `let` gives: a number stands for itself, anything else becomes a function.
    fn name(&mut self, scope: &mut Scope, name: &str, value: &Expr) -> Option<()> {
        let term = self.scalar(scope, value)?;
        let term = match self.number_of(&term) {
            Some(number) => Term::Number(number),
            None => {
                let place = self.define(scope, name.to_string(), term);
                scope.call(place)
            }
        };
        scope.lets.push((name.to_string(), term));
        Some(())
    }

    fn define(&mut self, scope: &Scope, name: String, value: Term) -> usize {
        let (family, parameters) = (scope.title.clone(), scope.names.clone());
        self.definitions.push(Definition { family, name, parameters, value });
        self.definitions.len() - 1
    }

    /// The functions that one statement defines.
    fn functions(&mut self, scope: &mut Scope, def: &FunctionDef) -> Option<()> {
        for values in self.tuples(scope, &def.loops)? {
            let depth = scope.constants.len();
            scope.constants.extend(values);
            let index = def.indices.iter().map(|i| self.whole(scope, i)).collect::<Option<Vec<i64>>>()?;
            let value = self.scalar(scope, &def.value)?;
            let place = self.define(scope, label(&scope.function_name, &index), value);
            scope.functions.insert(index.clone(), place);
            if def.permute {
                self.permuted(scope, &index, place);
            }
            scope.constants.truncate(depth);
        }
        Some(())
    }

    /// The functions that follow by permuting indices and barycentric coordinates together.
    fn permuted(&mut self, scope: &mut Scope, index: &[i64], place: usize) {
        let coordinates = scope.coordinates();
        let corners = coordinates.len();
        for order in grid(&vec![corners as i64; corners], usize::MAX - 1) {
            let twice = (0..corners).any(|k| order[..k].contains(&order[k]));
            let mut moved = vec![0; corners];
            for (from, to) in order.iter().enumerate() {
                moved[*to as usize] = index[from];
            }
            if twice || scope.functions.get(&moved).is_some() {
                continue;
            }
            let args = (0..scope.names.len()).map(|v| {
                let k = coordinates.iter().position(|c| *c == v);
                Term::Variable(k.map_or(v, |k| coordinates[order[k] as usize]))
            });
            let value = Term::Call(place, args.collect());
            let new = self.define(scope, label(&scope.function_name, &moved), value);
            scope.functions.insert(moved, new);
        }
    }

    /// The functions of every order after the lowest.
    fn raise(&mut self, scope: &mut Scope, def: &FunctionDef, order: &str, lowest: i64) -> Option<()> {
        let wanted = scope.constant(order)?;
        let names = def.indices.iter().map(|i| match &i.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        });
        let names: Vec<String> = names.collect::<Option<_>>()?;
        let title = scope.title.clone();
        for current in lowest + 1..=wanted {
            let last = scope.functions.keys().next_back()?.clone();
            let indices = if scope.dependent && last.len() == scope.domain + 1 {
                multi_indices(last.len(), last.iter().sum::<i64>() + 1, usize::MAX - 1)
            } else {
                let size = |k: usize| scope.functions.keys().map(|i| i[k]).max().map(|most| most + 2);
                grid(&(0..last.len()).map(size).collect::<Option<Vec<i64>>>()?, usize::MAX - 1)
            };
            if current < wanted {
                scope.title = format!("{title}, {order} = {current}");
            }
            scope.constants.push((order.to_string(), current));
            scope.missing_is_zero = true;
            let mut raised = SortedMap::new();
            for index in indices {
                let depth = scope.constants.len();
                scope.constants.extend(names.iter().cloned().zip(index.iter().copied()));
                let value = self.scalar(scope, &def.value)?;
                scope.constants.truncate(depth);
                let place = self.define(scope, label(&scope.function_name, &index), value);
                raised.insert(index, place);
            }
            scope.missing_is_zero = false;
            scope.constants.pop();
            scope.title.clone_from(&title);
            scope.functions = raised;
        }
        Some(())
    }

    /// The values of the index variables of a loop.
    fn tuples(&mut self, scope: &mut Scope, loops: &Loops) -> Option<Vec<Vec<(String, i64)>>> {
        let mut all: Vec<Vec<(String, i64)>> = vec![Vec::new()];
        for generator in &loops.generators {
            let mut longer = Vec::new();
            for start in all {
                let depth = scope.constants.len();
                scope.constants.extend(start.iter().cloned());
                match generator {
                    Generator::Range(range) => {
                        let low = self.whole(scope, &range.low)?;
                        let high = self.whole(scope, &range.high)? - i64::from(!range.inclusive);
                        longer.extend(
                            (low..=high).map(|i| [&start[..], &[(range.name.text.clone(), i)]].concat()),
                        );
                    }
                    Generator::Simplex(names, sum) => {
                        for index in multi_indices(names.len(), self.whole(scope, sum)?, usize::MAX - 1) {
                            let new = names.iter().map(|n| n.text.clone()).zip(index);
                            longer.push(start.iter().cloned().chain(new).collect());
                        }
                    }
                }
                scope.constants.truncate(depth);
            }
            all = longer;
        }
        let mut kept = Vec::new();
        for values in all {
            let depth = scope.constants.len();
            scope.constants.extend(values.iter().cloned());
            let mut holds = true;
            for (a, sign, b) in &loops.conditions {
                let (x, y) = (self.number(scope, a)?, self.number(scope, b)?);
                holds &= match sign {
                    Comparison::Equal => x == y,
                    Comparison::NotEqual => x != y,
                    Comparison::Less => x < y,
                    Comparison::LessEqual => x <= y,
                    Comparison::Greater => x > y,
                    Comparison::GreaterEqual => x >= y,
                };
            }
            scope.constants.truncate(depth);
            if holds {
                kept.push(values);
            }
        }
        Some(kept)
    }

    /// The whole number that an expression is.
    fn whole(&mut self, scope: &Scope, expr: &Expr) -> Option<i64> {
        self.number(scope, expr)?.to_i64()
    }

    /// The number that an expression is.
    fn number(&mut self, scope: &Scope, expr: &Expr) -> Option<Rational> {
        let term = self.scalar(scope, expr)?;
        self.number_of(&term)
    }

    /// The number that a term without variables is.
    fn number_of(&self, term: &Term) -> Option<Rational> {
        Some(match term {
            Term::Number(n) => n.clone(),
            Term::Variable(_) | Term::Derivative { .. } => return None,
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
    fn scalar(&mut self, scope: &Scope, expr: &Expr) -> Option<Term> {
        match self.value(scope, expr)? {
            Value::Scalar(term) => Some(term),
            Value::List(_) => None,
        }
    }

    fn value(&mut self, scope: &Scope, expr: &Expr) -> Option<Value> {
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
                return together(values, Term::Sum);
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
                    return Some(Value::Scalar(match scope.functions.get(&index) {
                        Some(place) => scope.call(*place),
                        None if scope.missing_is_zero => Term::integer(0),
                        None => return None,
                    }));
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
    fn collect(&mut self, scope: &Scope, body: &Expr, loops: &Loops) -> Option<Vec<Term>> {
        let mut inner = Scope {
            title: scope.title.clone(),
            constants: scope.constants.clone(),
            lets: scope.lets.clone(),
            names: scope.names.clone(),
            function_name: scope.function_name.clone(),
            functions: scope.functions.clone(),
            ..*scope
        };
        let mut all = Vec::new();
        for values in self.tuples(&mut inner, loops)? {
            let depth = inner.constants.len();
            inner.constants.extend(values);
            all.push(self.scalar(&inner, body)?);
            inner.constants.truncate(depth);
        }
        Some(all)
    }

    fn named(&mut self, scope: &Scope, name: &str) -> Option<Value> {
        if let Some(value) = scope.constant(name) {
            return Some(Value::Scalar(Term::integer(value)));
        }
        if let Some((_, term)) = scope.lets.iter().find(|(n, _)| n == name) {
            return Some(Value::Scalar(term.clone()));
        }
        if let Some(var) = scope.names.iter().position(|n| n == name) {
            return Some(Value::Scalar(Term::Variable(var)));
        }
        if name == scope.function_name {
            return Some(Value::List(
                scope.functions.iter().map(|(i, f)| (i.clone(), scope.call(*f))).collect(),
            ));
        }
        self.other(scope, name, &[], &[])
    }

    /// The functions of another family.
    fn other(&mut self, scope: &Scope, name: &str, orders: &[Expr], shapes: &[Expr]) -> Option<Value> {
        let order = orders.iter().map(|o| self.whole(scope, o)).collect::<Option<Vec<i64>>>()?;
        let mut args = shapes.iter().map(|x| self.scalar(scope, x)).collect::<Option<Vec<Term>>>()?;
        args.extend(scope.coordinates().into_iter().map(Term::Variable));
        let functions = self.family(scope.unit, name, &order)?;
        Some(Value::List(functions.iter().map(|(i, f)| (i.clone(), Term::Call(*f, args.clone()))).collect()))
    }

    fn call(&mut self, scope: &Scope, callee: &Expr, arguments: &[Expr]) -> Option<Value> {
        let family = |name: &str| {
            name != scope.function_name
                && scope.constant(name).is_none()
                && !scope.names.iter().any(|n| n == name)
                && self.library.knows(scope.unit, name)
        };
        match &callee.kind {
            ExprKind::Name(name) if name == "D" => return self.derivative(scope, arguments),
            ExprKind::Name(name) if crate::model::words::BUILTINS.contains(&name.as_str()) => {
                return self.builtin(scope, name, arguments);
            }
            ExprKind::Name(name) if family(name) => {
                let indexed = self.library.order_count(scope.unit, name) > 0;
                let (orders, shapes): (&[Expr], &[Expr]) =
                    if indexed { (arguments, &[]) } else { (&[], arguments) };
                return self.other(scope, name, orders, shapes);
            }
            ExprKind::Call(inner, orders) => {
                if let ExprKind::Name(name) = &inner.kind
                    && family(name)
                    && self.library.order_count(scope.unit, name) > 0
                {
                    return self.other(scope, name, orders, arguments);
                }
            }
            _ => {}
        }
        // f(x): arguments in place of the domain variables.
        let value = self.value(scope, callee)?;
        let by = arguments.iter().map(|x| self.scalar(scope, x)).collect::<Option<Vec<Term>>>()?;
        let coordinates = scope.coordinates();
        if by.len() != coordinates.len() {
            return None;
        }
        let put = |v: usize| coordinates.iter().position(|c| *c == v).map(|k| by[k].clone());
        Some(each(value, &mut |term| term.put(&put)))
    }

    fn builtin(&mut self, scope: &Scope, name: &str, arguments: &[Expr]) -> Option<Value> {
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
    fn derivative(&mut self, scope: &Scope, arguments: &[Expr]) -> Option<Value> {
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
    fn differentiated(&mut self, scope: &Scope, term: &Term, var: usize) -> Term {
        let bound = self.fresh;
        self.fresh += 1;
        let coordinates = scope.coordinates();
        let here = |v: usize| Term::Variable(if v == var { bound } else { v });
        let last = coordinates.last().copied().filter(|_| scope.dependent);
        let rest = |w: usize| {
            let others = coordinates.iter().filter(|c| **c != w).map(|c| (Sign::Minus, here(*c)));
            Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect())
        };
        let inner = coordinates.contains(&var);
        let body = term.put(&|v| {
            if v == var {
                Some(here(v))
            } else if inner && Some(v) == last {
                Some(rest(v))
            } else {
                None
            }
        });
        Term::Derivative { body: Rc::new(body), bound, at: Rc::new(Term::Variable(var)) }
    }

    /// The claims, in the order of the item.
    fn claims(
        &mut self,
        unit: usize,
        written: &syntax::Family,
        family: &Family,
        functions: Functions,
        claims: &[Claim],
    ) -> Option<Vec<Claimed>> {
        let mut scope = Scope::new(unit, family);
        scope.functions = functions;
        let mut all = Vec::new();
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Let(name, value) => self.name(&mut scope, &name.text, value)?,
                StatementKind::Claim(claim) => match &claim.kind {
                    syntax::ClaimKind::Relation(relation) => {
                        self.relation(&mut scope, relation, &[], &mut all)?;
                    }
                    syntax::ClaimKind::At(bindings, relations) => {
                        let mut fixed = Vec::new();
                        for Binding { name, value } in bindings {
                            let var = scope.names.iter().position(|n| *n == name.text)?;
                            fixed.push((var, self.scalar(&scope, value)?));
                        }
                        for relation in relations {
                            self.relation(&mut scope, relation, &fixed, &mut all)?;
                        }
                    }
                    _ => {
                        for _ in self.tuples(&mut scope, &claim.loops)? {
                            let kind = &claims.get(all.len())?.kind;
                            all.push(Claimed {
                                fixed: Vec::new(),
                                all: self.property(&scope, family, kind)?,
                            });
                        }
                    }
                },
                _ => {}
            }
        }
        (all.len() == claims.len()).then_some(all)
    }

    fn relation(
        &mut self,
        scope: &mut Scope,
        relation: &syntax::Relation,
        fixed: &[(usize, Term)],
        all: &mut Vec<Claimed>,
    ) -> Option<()> {
        for values in self.tuples(scope, &relation.loops)? {
            let depth = scope.constants.len();
            scope.constants.extend(values);
            let (left, right) = (self.value(scope, &relation.left)?, self.value(scope, &relation.right)?);
            scope.constants.truncate(depth);
            let zero = |list: &[(Vec<i64>, Term)]| vec![Term::integer(0); list.len()];
            let terms = |list: Vec<(Vec<i64>, Term)>| list.into_iter().map(|(_, x)| x).collect::<Vec<_>>();
            let (left, right) = match (left, right) {
                (Value::Scalar(l), Value::Scalar(r)) => (vec![l], vec![r]),
                (Value::List(l), Value::List(r)) => (terms(l), terms(r)),
                (Value::List(l), Value::Scalar(_)) => {
                    let zeros = zero(&l);
                    (terms(l), zeros)
                }
                (Value::Scalar(_), Value::List(r)) => (zero(&r), terms(r)),
            };
            let comparison = relation.comparison;
            let compared =
                left.into_iter().zip(right).map(|(left, right)| Compared { left, comparison, right });
            all.push(Claimed { fixed: fixed.to_vec(), all: compared.collect() });
        }
        Some(())
    }

    /// What a property says.
    fn property(&mut self, scope: &Scope, family: &Family, kind: &ClaimKind) -> Option<Vec<Compared>> {
        let calls: Vec<Term> = scope.functions.iter().map(|(_, f)| scope.call(*f)).collect();
        let equal = |left: Term, right: Term| Compared { left, comparison: Comparison::Equal, right };
        Some(match kind {
            ClaimKind::PartitionOfUnity => {
                let sum = Term::Sum(calls.into_iter().map(|x| (Sign::Plus, x)).collect());
                vec![equal(sum, Term::integer(1))]
            }
            ClaimKind::Nonnegative => {
                let one =
                    |left| Compared { left, comparison: Comparison::GreaterEqual, right: Term::integer(0) };
                calls.into_iter().map(one).collect()
            }
            ClaimKind::Symmetric => {
                let coordinates = scope.coordinates();
                let mut all = Vec::new();
                for (this, that, arguments) in moves(family) {
                    let by: Vec<Term> = arguments.iter().map(polynomial).collect();
                    let put = |v: usize| coordinates.iter().position(|c| *c == v).map(|k| by[k].clone());
                    all.push(equal(calls.get(this)?.clone(), calls.get(that)?.put(&put)));
                }
                all
            }
            ClaimKind::Continuity(order) => {
                let (var, low, high) = family.interval()?;
                let mut derivatives = calls;
                let mut all = Vec::new();
                for k in 0..=*order {
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

/// A list with positions for indices.
fn numbered(terms: Vec<Term>) -> Vec<(Vec<i64>, Term)> {
    terms.into_iter().enumerate().map(|(k, x)| (vec![k as i64], x)).collect()
}

fn each(value: Value, with: &mut dyn FnMut(Term) -> Term) -> Value {
    match value {
        Value::Scalar(x) => Value::Scalar(with(x)),
        Value::List(list) => Value::List(list.into_iter().map(|(i, x)| (i, with(x))).collect()),
    }
}

/// The sum of parts that are all single formulas, or all lists of one length.
fn together(parts: Vec<(Sign, Value)>, make: fn(Signed) -> Term) -> Option<Value> {
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
        (true, _) => Some(Value::Scalar(make(scalars))),
        (false, true) => Some(Value::List(lists.into_iter().map(|(i, parts)| (i, make(parts))).collect())),
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

/// A polynomial as it is expanded.
pub(super) fn polynomial(p: &Poly) -> Term {
    let mut parts = Vec::new();
    for (monomial, coefficient) in p.terms() {
        let mut factors = vec![(Role::Factor, Term::Number(coefficient.clone()))];
        for var in p.variables() {
            let exponent = monomial.exponent(var);
            if exponent > 0 {
                factors
                    .push((Role::Factor, Term::Power(Rc::new(Term::Variable(var.0)), u32::from(exponent))));
            }
        }
        if factors.len() > 1 && coefficient.is_one() {
            factors.remove(0);
        }
        parts.push((Sign::Plus, Term::Product(factors)));
    }
    match parts.len() {
        0 => Term::integer(0),
        _ => Term::Sum(parts),
    }
}
