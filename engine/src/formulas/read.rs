//! Families as they are written: the functions that they define, in the order in which they call each other.

use std::cell::RefCell;

use super::value::Value;
use super::{Claimed, Definition, Formulas, Term};
use crate::claim::Claim;
use crate::model::label;
use crate::model::tuples::{grid, multi_indices};
use crate::model::{Family, Library};
use crate::syntax::{self, Binding, ExprKind, FunctionDef, NameDef, StatementKind};
use basis_prover::collections::map::SortedMap;

/// Functions by their indices.
pub(super) type Functions = SortedMap<Vec<i64>, usize>;

/// Index variables with their values.
pub(super) type Constants = Vec<(String, i64)>;

/// The spec and the place of a family, and its order.
type Key = (usize, usize, Vec<i64>);

/// The most parts of all formulas of a family; more are not exported.
const MAX_PARTS: usize = 4_000_000;

/// Definitions that need each other through more levels than this are not exported.
const MAX_DEPTH: usize = 200;

/// The variables of derivatives have numbers from here on.
const BOUND: usize = 1 << 20;

/// Reads formulas.
pub(super) struct Reader<'a, 'f> {
    pub(super) library: &'a Library<'f>,
    pub(super) definitions: Vec<Definition>,
    /// The families that were read, each with its functions.
    known: Vec<(Key, Functions)>,
    /// The number of the next variable of a derivative.
    pub(super) fresh: usize,
    /// How many parts of formulas may still be made.
    parts: usize,
    /// How many definitions are being read, one inside of the other.
    depth: usize,
}

/// The formulas of a family of the spec that was asked for, and of its claims; `None` when one of its functions has no
/// counterpart.
pub fn of(library: &Library<'_>, family: &Family, claims: &[Claim]) -> Option<Formulas> {
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    let (unit, written) = library.written(&family.name)?;
    if !is_algebraic(family) {
        return None;
    }
    let (definitions, known) = (Vec::new(), Vec::new());
    let mut reader = Reader { library, definitions, known, fresh: BOUND, parts: MAX_PARTS, depth: 0 };
    let functions = reader.family(unit, &family.name, &order)?;
    let place = |f: &crate::model::Function| functions.get(&f.index).copied();
    let places = family.functions.iter().map(place).collect::<Option<Vec<usize>>>()?;
    let claims: Vec<Option<Claimed>> = reader.claims(unit, written, family, functions, claims)?;
    Some(Formulas { definitions: reader.definitions, functions: places, claims })
}

/// Whether all variables of a family stand for themselves, and one formula for the whole domain: no angle, no π and no
/// exponential function occurs, and the domain has one span.
const fn is_algebraic(family: &Family) -> bool {
    let analytic = &family.analytic;
    analytic.angles.is_empty()
        && analytic.pi.is_none()
        && analytic.exponential.is_none()
        && family.pieces.is_empty()
}

/// A function that no formula has needed yet, or that is being read.
struct Planned<'w> {
    def: &'w FunctionDef,
    constants: Constants,
}

/// What names mean while formulas of one family are read.
pub(super) struct Scope<'w> {
    pub(super) unit: usize,
    title: RefCell<String>,
    /// Index parameters and index variables, the innermost last.
    pub(super) constants: RefCell<Constants>,
    /// The index parameters.
    order: Constants,
    /// What `let` gives, as it is written.
    pub(super) lets: Vec<&'w NameDef>,
    /// What it gives, as far as it was needed.
    known: RefCell<Vec<(String, Value)>>,
    /// The arguments of the name with arguments whose formula is being read.
    pub(super) arguments: RefCell<Vec<(String, Value)>>,
    pub(super) names: Vec<String>,
    domain: usize,
    pub(super) dependent: bool,
    pub(super) function_name: String,
    pub(super) functions: RefCell<Functions>,
    planned: RefCell<SortedMap<Vec<i64>, Planned<'w>>>,
    /// While an order is raised: functions outside of the order before are 0.
    pub(super) missing_is_zero: RefCell<bool>,
}

impl<'w> Scope<'w> {
    pub(super) fn new(unit: usize, family: &Family, written: &'w syntax::Family) -> Self {
        let lets = written.statements.iter().filter_map(|s| match &s.kind {
            StatementKind::Let(def) => Some(def),
            _ => None,
        });
        Self {
            unit,
            title: RefCell::new(family.title()),
            constants: RefCell::new(family.order.clone()),
            order: family.order.clone(),
            lets: lets.collect(),
            known: RefCell::default(),
            arguments: RefCell::default(),
            names: family.names.clone(),
            domain: family.domain.len(),
            dependent: family.is_simplex(),
            function_name: family.function_name.clone(),
            functions: RefCell::new(SortedMap::new()),
            planned: RefCell::new(SortedMap::new()),
            missing_is_zero: RefCell::new(false),
        }
    }

    pub(super) fn constant(&self, name: &str) -> Option<i64> {
        self.constants.borrow().iter().rev().find(|(n, _)| n == name).map(|(_, value)| *value)
    }

    /// Does something with index variables that have values.
    pub(super) fn with<T>(&self, values: &[(String, i64)], run: impl FnOnce() -> T) -> T {
        let depth = self.constants.borrow().len();
        self.constants.borrow_mut().extend(values.iter().cloned());
        let result = run();
        self.constants.borrow_mut().truncate(depth);
        result
    }

    /// Does something in which only the names of the family have a meaning, and some arguments.
    pub(super) fn alone<T>(&self, arguments: Vec<(String, Value)>, run: impl FnOnce() -> T) -> T {
        let constants = self.constants.replace(self.order.clone());
        let arguments = self.arguments.replace(arguments);
        let result = run();
        self.constants.replace(constants);
        self.arguments.replace(arguments);
        result
    }

    /// The first function that was noted and not read.
    pub(super) fn next(&self) -> Option<Vec<i64>> {
        self.planned.borrow().keys().next().cloned()
    }

    /// Whether a name has a meaning of its own, so that it is no family.
    pub(super) fn is_taken(&self, name: &str) -> bool {
        name == self.function_name
            || self.constant(name).is_some()
            || self.names.iter().any(|n| n == name)
            || self.lets.iter().any(|def| def.name.text == name)
    }

    /// The numbers of the domain variables, the dependent one last.
    pub(super) fn coordinates(&self) -> Vec<usize> {
        (self.names.len() - self.domain - usize::from(self.dependent)..self.names.len()).collect()
    }

    /// A function at the point itself.
    pub(super) fn call(&self, definition: usize) -> Term {
        Term::Call(definition, (0..self.names.len()).map(Term::Variable).collect())
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
        if !is_algebraic(&family) {
            return None;
        }
        let written = self.library.tree(home, position)?;
        // What is assumed of shape values is not exported.
        if !family.constraints.is_empty() || !family.determined.is_empty() {
            return None;
        }
        let scope = Scope::new(home, &family, written);
        let recursive =
            |s: &syntax::Statement| matches!(s.kind, StatementKind::Base(..) | StatementKind::Raise(_));
        let recursive = written.statements.iter().any(recursive);
        let all = written.statements.iter().filter_map(|s| match &s.kind {
            StatementKind::Function(def) if !recursive => Some(def),
            _ => None,
        });
        for def in all {
            self.plan(&scope, def)?;
        }
        let mut base: Option<(&str, i64)> = None;
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Function(def) => {
                    if recursive {
                        self.plan(&scope, def)?;
                    }
                    self.planned(&scope)?;
                }
                StatementKind::Base(Binding { name, value, .. }, functions) => {
                    let lowest = self.whole(&scope, value)?;
                    let title = scope.title.borrow().clone();
                    if scope.constant(&name.text)? > lowest {
                        scope.title.replace(format!("{title}, {} = {lowest}", name.text));
                    }
                    scope.with(&[(name.text.clone(), lowest)], || {
                        for def in functions {
                            self.plan(&scope, def)?;
                            self.planned(&scope)?;
                        }
                        Some(())
                    })?;
                    scope.title.replace(title);
                    base = Some((&name.text, lowest));
                }
                StatementKind::Raise(def) => {
                    let (order, lowest) = base?;
                    self.raise(&scope, def, order, lowest)?;
                }
                _ => {}
            }
        }
        let functions = scope.functions.into_inner();
        self.known.push((key, functions.clone()));
        Some(functions)
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
                sorted.sort_unstable();
                sorted
            };
            let planned = scope.planned.borrow();
            let same = planned.keys().find(|other| sorted(other) == sorted(index));
            written.clone_from(same.filter(|other| planned.get(other).is_some_and(|p| p.def.permute))?);
        }
        let Planned { def, constants } = scope.planned.borrow_mut().remove(&written)?;
        let value = self.inside(|reader| {
            scope.alone(Vec::new(), || scope.with(&constants, || reader.scalar(scope, &def.value)))
        })?;
        let place = self.define(scope, label(&scope.function_name, &written), value);
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
            None => scope.call(self.define(scope, name, term)),
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

    fn define(&mut self, scope: &Scope<'_>, name: String, value: Term) -> usize {
        let (family, parameters) = (scope.title.borrow().clone(), scope.names.clone());
        self.definitions.push(Definition { family, name, parameters, value });
        self.definitions.len() - 1
    }

    /// The functions that follow by permuting indices and barycentric coordinates together.
    fn permuted(&mut self, scope: &Scope<'_>, index: &[i64], place: usize) {
        let coordinates = scope.coordinates();
        let corners = coordinates.len();
        if index.len() != corners {
            return;
        }
        for order in grid(&vec![corners as i64; corners], usize::MAX - 1) {
            let twice = (0..corners).any(|k| order[..k].contains(&order[k]));
            let mut moved = vec![0; corners];
            for (from, to) in order.iter().enumerate() {
                moved[*to as usize] = index[from];
            }
            if twice || scope.functions.borrow().get(&moved).is_some() {
                continue;
            }
            let args = (0..scope.names.len()).map(|v| {
                let k = coordinates.iter().position(|c| *c == v);
                Term::Variable(k.map_or(v, |k| coordinates[order[k] as usize]))
            });
            let value = Term::Call(place, args.collect());
            let new = self.define(scope, label(&scope.function_name, &moved), value);
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
            let indices = if scope.dependent && last.len() == scope.domain + 1 {
                multi_indices(last.len(), last.iter().sum::<i64>() + 1, usize::MAX - 1)
            } else {
                let known = scope.functions.borrow();
                let size = |k: usize| known.keys().map(|i| i[k]).max().map(|most| most + 2);
                grid(&(0..last.len()).map(size).collect::<Option<Vec<i64>>>()?, usize::MAX - 1)
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
                let place = self.define(scope, label(&scope.function_name, &index), value);
                raised.insert(index, place);
            }
            scope.missing_is_zero.replace(false);
            scope.title.replace(title.clone());
            scope.functions.replace(raised);
        }
        Some(())
    }
}
