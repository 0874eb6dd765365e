//! What names mean while formulas are read.

use std::cell::RefCell;
use std::ops::Range;
use std::rc::Weak;

use super::{Definition, Term};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::model::angle::{Angle, Kind};
use crate::model::{Factor, Family, Library, label};
use crate::syntax::{self, Expr, FunctionDef, NameDef, StatementKind};
use basis_prover::collections::map::SortedMap;

/// Functions by their indices.
pub(super) type Functions = SortedMap<Vec<i64>, usize>;

/// Index variables with their values.
pub(super) type Constants = Vec<(String, i64)>;

/// The spec and the place of a family, and its order.
pub(super) type Key = (usize, usize, Vec<i64>);

/// One formula or several, each with its index.
#[derive(Clone)]
pub(super) enum Value {
    /// One.
    Scalar(Term),
    /// Several.
    List(Vec<(Vec<i64>, Term)>),
}

/// Reads formulas.
pub(super) struct Reader<'a, 'f> {
    pub(super) library: &'a Library<'f>,
    pub(super) definitions: Vec<Definition>,
    /// The families that were read, each with its functions.
    pub(super) known: Vec<(Key, Functions)>,
    /// The number of the next variable of a derivative.
    pub(super) fresh: usize,
    /// How many parts of formulas may still be made.
    pub(super) parts: usize,
    /// How many definitions are being read, one inside of the other.
    pub(super) depth: usize,
}

/// A function that no formula has needed yet, or that is being read.
pub(super) struct Planned<'w> {
    pub(super) def: &'w FunctionDef,
    pub(super) constants: Constants,
}

/// What names mean while formulas of one family are read.
pub(super) struct Scope<'w> {
    pub(super) unit: usize,
    pub(super) title: RefCell<String>,
    /// Index parameters and index variables, the innermost last.
    pub(super) constants: RefCell<Constants>,
    /// The index parameters.
    pub(super) order: Constants,
    /// What `let` gives, as it is written.
    pub(super) lets: Vec<&'w NameDef>,
    /// What it gives, as far as it was needed.
    pub(super) known: RefCell<Vec<(String, Value)>>,
    /// The arguments of the name with arguments whose formula is being read.
    pub(super) arguments: RefCell<Vec<(String, Value)>>,
    pub(super) names: Vec<String>,
    /// The numbers of the variables on which functions depend: an angle, not its tangent.
    pub(super) parameters: Vec<usize>,
    /// For each factor of the domain the numbers of its variables, of a simplex the dependent one last.
    factors: Vec<Vec<usize>>,
    /// The ends of each factor that is an interval, where both are numbers.
    ends: Vec<Option<[Term; 2]>>,
    /// Of several spans the number of this one.
    pub(super) span: Option<usize>,
    /// The same on each of several spans, this one among them.
    pub(super) siblings: RefCell<Vec<Weak<Self>>>,
    pub(super) function_name: String,
    pub(super) functions: RefCell<Functions>,
    pub(super) planned: RefCell<SortedMap<Vec<i64>, Planned<'w>>>,
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
            parameters: parameters(family),
            factors: family
                .factors()
                .iter()
                .map(|f| f.variables().map(|p| itself(family, p.var)).collect())
                .collect(),
            // Of an angle the ends are those of its tangent.
            ends: family.factors().iter().map(|f| ends(f).filter(|_| family.analytic.is_empty())).collect(),
            span: None,
            siblings: RefCell::default(),
            function_name: family.function_name.clone(),
            functions: RefCell::new(SortedMap::new()),
            planned: RefCell::new(SortedMap::new()),
            missing_is_zero: RefCell::new(false),
        }
    }

    /// Of a theorem only the variables are known here.
    pub(super) fn of_theorem(unit: usize, names: Vec<String>) -> Self {
        Self {
            unit,
            title: RefCell::default(),
            constants: RefCell::default(),
            order: Constants::new(),
            lets: Vec::new(),
            known: RefCell::default(),
            arguments: RefCell::default(),
            parameters: (0..names.len()).collect(),
            names,
            factors: Vec::new(),
            ends: Vec::new(),
            span: None,
            siblings: RefCell::default(),
            function_name: String::new(),
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

    /// The shape parameter with a name and an index.
    pub(super) fn parameter(&self, name: &str, index: &[i64]) -> Option<usize> {
        let label = label(name, index);
        self.names.iter().position(|n| *n == label)
    }

    /// The shape parameters that share a name, with their indices.
    pub(super) fn indexed(&self, name: &str) -> Vec<(Vec<i64>, usize)> {
        let index = |(v, full): (usize, &String)| {
            let inside = full.strip_prefix(name)?.strip_prefix('[')?.strip_suffix(']')?;
            let index = inside.split(',').map(|i| i.trim().parse().ok()).collect::<Option<Vec<i64>>>()?;
            Some((index, v))
        };
        self.names.iter().enumerate().filter_map(index).collect()
    }

    /// Whether a name has a meaning of its own, so that it is no family.
    pub(super) fn is_taken(&self, name: &str) -> bool {
        name == self.function_name
            || self.constant(name).is_some()
            || self.names.iter().any(|n| n == name)
            || !self.indexed(name).is_empty()
            || self.lets.iter().any(|def| def.name.text == name)
    }

    /// The numbers of the variables of each factor of the domain, of a simplex the dependent one last, and the ends of those
    /// that are intervals between numbers.
    pub(super) fn domain(&self) -> impl Iterator<Item = (&Vec<usize>, &Option<[Term; 2]>)> {
        self.factors.iter().zip(&self.ends)
    }

    /// The numbers of the domain variables in the order of the spec.
    pub(super) fn coordinates(&self) -> Vec<usize> {
        self.factors.concat()
    }

    /// Of the simplex to which a variable belongs the coordinates but the last, and the last.
    pub(super) fn simplex_of(&self, var: usize) -> Option<(Vec<usize>, usize)> {
        let own = self.factors.iter().find(|own| own.len() > 1 && own.contains(&var))?;
        let (last, others) = own.split_last()?;
        Some((others.to_vec(), *last))
    }

    /// Where an index with one place for each coordinate has those of each factor, if there is a simplex.
    pub(super) fn index_places(&self, width: usize) -> Vec<Range<usize>> {
        let mut next = 0;
        let places = self.factors.iter().map(|own| {
            next += own.len();
            next - own.len()..next
        });
        let places: Vec<Range<usize>> = places.collect();
        let corners = self.factors.iter().any(|own| own.len() > 1);
        if corners && next == width { places } else { Vec::new() }
    }

    /// The formula of a function, of several spans the one for this span.
    pub(super) fn formula(&self, def: &'w FunctionDef) -> &'w Expr {
        let further = self.span.and_then(|k| def.further.get(k.checked_sub(1)?));
        further.unwrap_or(&def.value)
    }

    /// A function at the point itself.
    pub(super) fn call(&self, definition: usize) -> Term {
        Term::Call(definition, self.parameters.iter().copied().map(Term::Variable).collect())
    }
}

/// The ends of an interval, if they are numbers.
fn ends(factor: &Factor<'_>) -> Option<[Term; 2]> {
    let Factor::Interval(p) = factor else { return None };
    let end = |end: &End| end.value().cloned().map(Term::Number);
    Some([end(&p.range.low)?, end(&p.range.high)?])
}

/// The numbers of the variables on which the functions of a family depend.
pub(super) fn parameters(family: &Family) -> Vec<usize> {
    if family.analytic.angles.is_empty() && family.analytic.pi.is_none() {
        return (0..family.names.len()).collect();
    }
    let all = family.shapes.iter().chain(family.domain_variables());
    all.map(|p| itself(family, p.var)).collect()
}

/// The number of a variable, of the tangent of an angle that of the angle.
fn itself(family: &Family, var: Var) -> usize {
    family.analytic.angle(var).map_or(var, |angle| angle.itself).0
}

/// The definitions of the functions of a family, in their order.
pub(super) fn places(family: &Family, functions: &Functions) -> Option<Vec<usize>> {
    family.functions.iter().map(|f| functions.get(&f.index).copied()).collect()
}

/// Whether one formula stands for the whole domain, all shape parameters stand for themselves, and so does the domain
/// variable or it is an angle whose tangent has rational ends.
pub(super) fn is_plain(family: &Family) -> bool {
    let analytic = &family.analytic;
    let angle = |a: &Angle| {
        a.kind == Kind::Circular
            && a.low.is_zero()
            && a.width == Fraction::constant(Rational::ONE)
            && family.domain.iter().any(|p| p.var == a.var)
    };
    analytic.angles.iter().all(angle)
        && (analytic.is_empty() || family.domain.len() == 1)
        && analytic.exponential.is_none()
        && analytic.tangent.is_none()
        && analytic.roots.is_empty()
        && family.pieces.is_empty()
}
