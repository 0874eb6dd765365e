//! Families as they are written: the functions that they define, in the order in which they call each other.

use super::scope::{Constants, Functions, Planned, Reader, Scope, Value, is_plain, places};
use super::{Claimed, Definition, Formulas, Term, spans};
use crate::claim::{Claim, ClaimKind};
use crate::model::label;
use crate::model::tuples::numbered;
use crate::model::{Family, Library};
use crate::syntax::{self, Binding, ExprKind, FunctionDef, NameDef, StatementKind};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort;

/// The most parts of all formulas of a family; more are not exported.
const MAX_PARTS: usize = 4_000_000;

/// Definitions that need each other through more levels than this are not exported.
const MAX_DEPTH: usize = 200;

/// The variables of derivatives have numbers from here on.
pub(super) const BOUND: usize = 1 << 20;

/// The formulas of a family of the spec that was asked for, and of its claims; `None` when one of its functions has no
/// counterpart.
pub fn of(library: &Library<'_>, family: &Family, claims: &[Claim]) -> Option<Formulas> {
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    let (unit, written) = library.written(&family.name)?;
    if !family.pieces.is_empty() {
        return spans::of(library, family, (unit, written), claims);
    }
    if !is_plain(family) {
        return None;
    }
    let mut reader = Reader::new(library);
    let functions = reader.family(unit, &family.name, &order)?;
    let functions_of = places(family, &functions)?;
    let scope = Scope::new(unit, family, written);
    scope.functions.replace(functions);
    let kinds: Vec<Option<&ClaimKind>> = claims.iter().map(|claim| Some(&claim.kind)).collect();
    let claims: Vec<Option<Claimed>> = reader.claims(&scope, written, family, &kinds)?;
    Some(Formulas { definitions: reader.definitions, functions: functions_of, spans: Vec::new(), claims })
}

impl<'a, 'f> Reader<'a, 'f> {
    pub(super) fn new(library: &'a Library<'f>) -> Self {
        let (definitions, known) = (Vec::new(), Vec::new());
        Self { library, definitions, known, fresh: BOUND, parts: MAX_PARTS, depth: 0 }
    }
}

impl Reader<'_, '_> {
    /// Counts the parts of a formula that is copied.
    pub(super) fn spend(&mut self, parts: usize) -> Option<()> {
        self.parts = self.parts.checked_sub(parts)?;
        Some(())
    }

    /// Goes one level deeper.
    pub(super) fn inside<T>(&mut self, run: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        if self.depth >= MAX_DEPTH {
            return None;
        }
        self.depth += 1;
        let result = run(self);
        self.depth -= 1;
        result
    }

    /// The functions of a family of one order, defined now or before.
    pub(super) fn family(&mut self, unit: usize, name: &str, order: &[i64]) -> Option<Functions> {
        let (home, position) = self.library.place_of(unit, name)?;
        let key = (home, position, order.to_vec());
        if let Some((_, functions)) = self.known.iter().find(|(known, _)| *known == key) {
            return Some(functions.clone());
        }
        let family = self.library.family(unit, name, order).ok()?;
        if !is_plain(&family) {
            return None;
        }
        let written = self.library.tree(home, position)?;
        let scope = Scope::new(home, &family, written);
        self.functions_of(&scope, &family, written)?;
        let functions = scope.functions.into_inner();
        self.known.push((key, functions.clone()));
        Some(functions)
    }

    /// Reads the functions of a family, or of a span of one.
    pub(super) fn functions_of<'w>(
        &mut self,
        scope: &Scope<'w>,
        family: &Family,
        written: &'w syntax::Family,
    ) -> Option<()> {
        // A parameter that an assumption determines stands for something else.
        if !family.determined.is_empty() {
            return None;
        }
        let recursive =
            |s: &syntax::Statement| matches!(s.kind, StatementKind::Base(..) | StatementKind::Raise(_));
        let recursive = written.statements.iter().any(recursive);
        let all = written.statements.iter().filter_map(|s| match &s.kind {
            StatementKind::Function(def) if !recursive => Some(def),
            _ => None,
        });
        for def in all {
            self.plan(scope, def)?;
        }
        let mut base: Option<(&str, i64)> = None;
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Function(def) => {
                    if recursive {
                        self.plan(scope, def)?;
                    }
                    self.planned(scope)?;
                }
                StatementKind::Base(Binding { name, value, .. }, functions) => {
                    let lowest = self.whole(scope, value)?;
                    let title = scope.title.borrow().clone();
                    if scope.constant(&name.text)? > lowest {
                        scope.title.replace(format!("{title}, {} = {lowest}", name.text));
                    }
                    scope.with(&[(name.text.clone(), lowest)], || {
                        for def in functions {
                            self.plan(scope, def)?;
                            self.planned(scope)?;
                        }
                        Some(())
                    })?;
                    scope.title.replace(title);
                    base = Some((&name.text, lowest));
                }
                StatementKind::Raise(def) => {
                    let (order, lowest) = base?;
                    self.raise(scope, def, order, lowest)?;
                }
                _ => {}
            }
        }
        Some(())
    }

    /// Notes the functions that a statement defines.
    fn plan<'w>(&mut self, scope: &Scope<'w>, def: &'w FunctionDef) -> Option<()> {
        for values in self.tuples(scope, &def.loops)? {
            let index = scope.with(&values, || {
                def.indices.iter().map(|i| self.whole(scope, i)).collect::<Option<Vec<i64>>>()
            })?;
            let order = scope.order.len();
            let around = scope.constants.borrow().get(order..).map(<[_]>::to_vec)?;
            let constants = [around, values].concat();
            scope.planned.borrow_mut().insert(index, Planned { def, constants });
        }
        Some(())
    }

    /// Reads all functions that were noted.
    fn planned(&mut self, scope: &Scope<'_>) -> Option<()> {
        while let Some(index) = scope.next() {
            self.function(scope, &index)?;
        }
        Some(())
    }

    /// A function with an index, read now or before; one that `permute` defines needs the one that it follows from.
    pub(super) fn function(&mut self, scope: &Scope<'_>, index: &Vec<i64>) -> Option<usize> {
        if let Some(place) = scope.functions.borrow().get(index) {
            return Some(*place);
        }
        let mut written = index.clone();
        if scope.planned.borrow().get(&written).is_none() {
            let sorted = |index: &[i64]| {
                let mut sorted = index.to_vec();
                sort(&mut sorted);
                sorted
            };
            let planned = scope.planned.borrow();
            let same = planned.keys().find(|other| sorted(other) == sorted(index));
            written.clone_from(same.filter(|other| planned.get(other).is_some_and(|p| p.def.permute))?);
        }
        let Planned { def, constants } = scope.planned.borrow_mut().remove(&written)?;
        let value = self.inside(|reader| {
            scope.alone(Vec::new(), || scope.with(&constants, || reader.scalar(scope, scope.formula(def))))
        })?;
        let place = self.define(scope, label(&scope.function_name, &written), &value);
        scope.functions.borrow_mut().insert(written.clone(), place);
        if def.permute {
            self.permuted(scope, &written, place);
        }
        scope.functions.borrow().get(index).copied()
    }

    /// What `let` gives, read now or before: a number stands for itself, anything else becomes a function.
    pub(super) fn given(&mut self, scope: &Scope<'_>, def: &NameDef) -> Option<Value> {
        let name = &def.name.text;
        if let Some((_, value)) = scope.known.borrow().iter().find(|(n, _)| n == name) {
            return Some(value.clone());
        }
        let value = self.inside(|reader| scope.alone(Vec::new(), || reader.value(scope, &def.value)))?;
        let mut named = |term: Term, name: String| match self.number_of(&term) {
            Some(number) => Term::Number(number),
            None => scope.call(self.define(scope, name, &term)),
        };
        let value = match value {
            Value::Scalar(term) => Value::Scalar(named(term, name.clone())),
            Value::List(list) => Value::List(
                list.into_iter().map(|(i, term)| (i.clone(), named(term, label(name, &i)))).collect(),
            ),
        };
        scope.known.borrow_mut().push((name.clone(), value.clone()));
        Some(value)
    }

    fn define(&mut self, scope: &Scope<'_>, name: String, value: &Term) -> usize {
        let family = scope.title.borrow().clone();
        let parameters = scope.parameters.iter().filter_map(|v| scope.names.get(*v).cloned()).collect();
        // A variable is a parameter by its place from now on.
        let place = |v: usize| scope.parameters.iter().position(|p| *p == v).map(Term::Variable);
        let value = value.put(&place);
        self.definitions.push(Definition { family, name, span: scope.span, parameters, value });
        self.definitions.len() - 1
    }

    /// The functions that follow by permuting indices and barycentric coordinates together.
    fn permuted(&mut self, scope: &Scope<'_>, index: &[i64], place: usize) {
        let coordinates = scope.coordinates();
        let corners = coordinates.len();
        if index.len() != corners {
            return;
        }
        // Each coordinate goes to a place of its own simplex.
        let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
        for own in scope.index_places(corners) {
            for _ in own.clone() {
                let longer = |start: &Vec<usize>| {
                    let free: Vec<usize> = own.clone().filter(|k| !start.contains(k)).collect();
                    let start = start.clone();
                    free.into_iter().map(move |k| [&start[..], &[k]].concat())
                };
                orders = orders.iter().flat_map(longer).collect();
            }
        }
        for order in orders {
            let mut moved = vec![0; corners];
            for (from, to) in order.iter().enumerate() {
                moved[*to] = index[from];
            }
            if scope.functions.borrow().get(&moved).is_some() {
                continue;
            }
            let args = (0..scope.names.len()).map(|v| {
                let k = coordinates.iter().position(|c| *c == v);
                Term::Variable(k.map_or(v, |k| coordinates[order[k]]))
            });
            let value = Term::Call(place, args.collect());
            let new = self.define(scope, label(&scope.function_name, &moved), &value);
            scope.functions.borrow_mut().insert(moved, new);
        }
    }

    /// The functions of every order after the lowest.
    fn raise(&mut self, scope: &Scope<'_>, def: &FunctionDef, order: &str, lowest: i64) -> Option<()> {
        let wanted = scope.constant(order)?;
        let names = def.indices.iter().map(|i| match &i.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        });
        let names: Vec<String> = names.collect::<Option<_>>()?;
        let title = scope.title.borrow().clone();
        for current in lowest + 1..=wanted {
            let last = scope.functions.borrow().keys().next_back()?.clone();
            let indices = {
                let known = scope.functions.borrow();
                let size = |k: usize| known.keys().map(|i| i[k]).max().map(|most| most + 2);
                let sizes = (0..last.len()).map(size).collect::<Option<Vec<i64>>>()?;
                numbered(&scope.index_places(last.len()), &last, 1, &sizes, usize::MAX - 1)
            };
            if current < wanted {
                scope.title.replace(format!("{title}, {order} = {current}"));
            }
            scope.missing_is_zero.replace(true);
            let mut raised = SortedMap::new();
            for index in indices {
                let own = names.iter().cloned().zip(index.iter().copied());
                let values: Constants = std::iter::once((order.to_string(), current)).chain(own).collect();
                let value = scope.with(&values, || self.scalar(scope, &def.value))?;
                let place = self.define(scope, label(&scope.function_name, &index), &value);
                raised.insert(index, place);
            }
            scope.missing_is_zero.replace(false);
            scope.title.replace(title.clone());
            scope.functions.replace(raised);
        }
        Some(())
    }
}
