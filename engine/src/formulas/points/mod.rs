//! Theorems and joins as they are written: a curve is the sum of its functions times coordinates of its control points.

mod value;

use std::rc::Rc;

use basis_prover::collections::sort::sort;

use super::read::BOUND;
use super::scope::{Constants, Reader, Scope};
use super::{Definition, Term};
use crate::model::{Family, Library, label};
use crate::syntax::{self, Expr, ExprKind, TheoremStatementKind};
use crate::theorem::{Theorem, TheoremRelation};

/// The parameters of curves and surfaces have these numbers until arguments take their places.
const PARAMETER: usize = BOUND << 1;

/// The coordinates of points have numbers from here on.
const POINT: usize = BOUND << 2;

/// How many numbers each point has.
const COORDINATES: usize = 16;

/// A scalar, or the coordinates of a vector.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A scalar.
    Scalar(Term),
    /// A vector: its coordinates, or without a dimension one formula for the coordinate with any number i.
    Vector(Vec<Term>),
    /// An outer product in a space of any dimension: one formula for the coordinates with any numbers i and j.
    Outer(Term),
}

/// A claim about points.
#[derive(Clone, Debug, PartialEq)]
pub struct PointClaim {
    /// The left side.
    pub left: Quantity,
    /// What stands between the sides.
    pub relation: TheoremRelation,
    /// The right side; a lone 0 is the zero of whatever stands on the left.
    pub right: Quantity,
}

/// The formulas of a theorem or join.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointFormulas {
    /// The functions of families, each after those that it calls.
    pub definitions: Vec<Definition>,
    /// The points that can be any points, by their names; also those that `let` determines.
    pub points: Vec<String>,
    /// The claims, in the order of the item; nothing for one without a counterpart, such as an integral.
    pub claims: Vec<Option<PointClaim>>,
}

/// A coordinate of a point: which point, by its place in [`PointFormulas::points`], and which coordinate; without a
/// dimension 0 for the coordinate with the number i, and 1 for that with the number j. Nothing for other variables.
pub const fn coordinate(variable: usize) -> Option<(usize, usize)> {
    match variable.checked_sub(POINT) {
        Some(n) => Some((n / COORDINATES, n % COORDINATES)),
        None => None,
    }
}

/// The variable that stands for a coordinate of a point.
pub const fn coordinate_variable(point: usize, which: usize) -> usize {
    POINT + COORDINATES * point + which
}

/// The formulas of a theorem of the spec that was asked for; `None` when a curve or a `let` has no counterpart.
pub fn of_theorem(library: &Library<'_>, theorem: &Theorem) -> Option<PointFormulas> {
    let mut found = None;
    library.each_theorem(&mut |unit, _, written| {
        if written.name.text == theorem.name && written.kind == theorem.kind {
            found = Some(read(library, unit, written, theorem));
        }
        crate::diagnostic::Diagnostics::default()
    });
    found?
}

fn read(
    library: &Library<'_>,
    unit: usize,
    written: &syntax::Theorem,
    theorem: &Theorem,
) -> Option<PointFormulas> {
    let scope = Scope::of_theorem(unit, theorem.names.clone());
    let reader = Reader::new(library);
    let mut all =
        TheoremReader { reader, scope, theorem, values: Vec::new(), patches: Vec::new(), points: Vec::new() };
    for statement in &written.statements {
        match &statement.kind {
            TheoremStatementKind::Patch(_, name, value) => all.patch(&name.text, value)?,
            TheoremStatementKind::Let(target, value, loops) => {
                for values in all.reader.tuples(&all.scope, loops)? {
                    all.with(&values, |all| all.define(target, value))?;
                }
            }
            _ => {}
        }
    }
    let mut claims = Vec::new();
    for statement in &written.statements {
        let TheoremStatementKind::Claim(claim) = &statement.kind else { continue };
        for values in all.reader.tuples(&all.scope, &claim.loops)? {
            claims.push(all.with(&values, |all| {
                let (left, right) = (all.quantity(&claim.left)?, all.quantity(&claim.right)?);
                Some(PointClaim { left, relation: claim.relation, right })
            }));
        }
    }
    Some(PointFormulas { definitions: all.reader.definitions, points: all.points, claims })
}

/// A curve or surface.
struct Patch {
    name: String,
    /// The names of its parameters, of which those from [`PARAMETER`] on stand in the functions.
    parameters: Vec<String>,
    /// Whether the last of these is 1 minus the others.
    dependent: bool,
    /// Indices and functions.
    functions: Vec<(Vec<i64>, Term)>,
    /// The control points, as far as they are determined.
    points: Vec<Option<Vec<Term>>>,
}

/// A theorem while it is read.
struct TheoremReader<'a, 'f> {
    reader: Reader<'a, 'f>,
    scope: Scope<'a>,
    theorem: &'a Theorem,
    /// What `let` gives.
    values: Vec<(String, Quantity)>,
    patches: Vec<Patch>,
    points: Vec<String>,
}

impl TheoremReader<'_, '_> {
    /// Does something with index variables that have values.
    fn with<T>(&mut self, values: &[(String, i64)], run: impl FnOnce(&mut Self) -> T) -> T {
        let before: Constants = self.scope.constants.borrow().clone();
        self.scope.constants.borrow_mut().extend(values.iter().cloned());
        let result = run(self);
        self.scope.constants.replace(before);
        result
    }

    fn whole(&mut self, expr: &Expr) -> Option<i64> {
        let Quantity::Scalar(term) = self.quantity(expr)? else { return None };
        self.reader.number_of(&term)?.to_i64()
    }

    fn indices(&mut self, indices: &[Expr]) -> Option<Vec<i64>> {
        indices.iter().map(|i| self.whole(i)).collect()
    }

    /// The name that a name, or a name with an index, stands for.
    fn name(&mut self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Name(name) => Some(name.clone()),
            ExprKind::Index(base, indices) => {
                let ExprKind::Name(name) = &base.kind else { return None };
                Some(label(name, &self.indices(indices)?))
            }
            _ => None,
        }
    }

    /// `let name = …;` or `let P[i] = …;`
    fn define(&mut self, target: &Expr, value: &Expr) -> Option<()> {
        let value = self.quantity(value)?;
        if let ExprKind::Index(base, indices) = &target.kind
            && let ExprKind::Name(name) = &base.kind
            && let Some(patch) = self.patches.iter().position(|p| p.name == *name)
        {
            let index = self.indices(indices)?;
            let at = self.patches[patch].functions.iter().position(|(i, _)| *i == index)?;
            let Quantity::Vector(point) = value else { return None };
            self.patches[patch].points[at] = Some(point);
            return Some(());
        }
        let name = self.name(target)?;
        self.values.push((name, value));
        Some(())
    }

    /// `curve P = F(λ) […];`, `surface S = F(λ)(u) * G(γ[i])(v);`
    fn patch(&mut self, name: &str, value: &Expr) -> Option<()> {
        let (factors, listed) = crate::theorem::split_points(value);
        let factors = factors.unwrap_or_else(|| vec![value]);
        let mut patch = Patch {
            name: name.to_string(),
            parameters: Vec::new(),
            dependent: false,
            functions: Vec::new(),
            points: Vec::new(),
        };
        match factors.as_slice() {
            [only] => {
                let factor = self.factor(only, false)?;
                patch.parameters = factor.family.domain_variables().map(|p| p.name.clone()).collect();
                patch.dependent = factor.family.is_simplex();
                let shapes = self.shapes(factor.shapes)?;
                // The arguments in the order of the variables' numbers, the dependent one last.
                let mut order: Vec<(usize, usize)> =
                    factor.family.domain_variables().enumerate().map(|(k, p)| (p.var.0, k)).collect();
                sort(&mut order);
                let own = order.into_iter().map(|(_, k)| Term::Variable(PARAMETER + k));
                let arguments: Vec<Term> = shapes.into_iter().chain(own).collect();
                for (index, f) in factor.functions {
                    patch.functions.push((index, Term::Call(f, arguments.clone())));
                }
            }
            [first, second] => self.product([first, second], &mut patch)?,
            _ => return None,
        }
        self.reader.spend(patch.functions.len())?;
        patch.points = match listed {
            None => vec![None; patch.functions.len()],
            Some(listed) => {
                let flat = listed.iter().flat_map(|e| match &e.kind {
                    ExprKind::List(row) => row.iter().collect(),
                    _ => vec![e],
                });
                let mut points = Vec::new();
                for point in flat {
                    let Quantity::Vector(point) = self.quantity(point)? else { return None };
                    points.push(Some(point));
                }
                points
            }
        };
        if listed.is_none() {
            self.points.extend(patch.functions.iter().map(|(index, _)| label(name, index)));
        }
        (patch.points.len() == patch.functions.len()).then(|| self.patches.push(patch))
    }

    /// A tensor product; an index without a value in a shape value stands for the row or column of the other factor.
    fn product(&mut self, factors: [&Expr; 2], patch: &mut Patch) -> Option<()> {
        let [first, second] = factors.map(|f| self.factor(f, true));
        let (first, second) = (first?, second?);
        for factor in [&first, &second] {
            let ExprKind::Name(name) = &factor.parameter?.kind else { return None };
            patch.parameters.push(name.clone());
        }
        let mut values = |own: &Factor<'_>, k: usize, other: usize| -> Option<Vec<Vec<Term>>> {
            let name = self.free_index(own.shapes);
            let mut lists = Vec::new();
            for at in 0..other as i64 {
                let given: Constants = name.iter().map(|name| (name.clone(), at)).collect();
                let shapes = self.with(&given, |all| all.shapes(own.shapes))?;
                let arguments: Vec<Term> =
                    shapes.into_iter().chain([Term::Variable(PARAMETER + k)]).collect();
                lists.push(own.functions.iter().map(|(_, f)| Term::Call(*f, arguments.clone())).collect());
            }
            Some(lists)
        };
        let rows = values(&first, 0, second.functions.len())?;
        let columns = values(&second, 1, first.functions.len())?;
        for (i, (row, _)) in first.functions.iter().enumerate() {
            for (j, (column, _)) in second.functions.iter().enumerate() {
                let index = row.iter().chain(column).copied().collect();
                patch
                    .functions
                    .push((index, rows.get(j)?.get(i)?.clone().by(columns.get(i)?.get(j)?.clone())));
            }
        }
        Some(())
    }

    /// `Family(order)(shapes)(u)`, whatever of it the family needs.
    fn factor<'e>(&mut self, expr: &'e Expr, product: bool) -> Option<Factor<'e>> {
        let mut calls: Vec<&[Expr]> = Vec::new();
        let mut callee = expr;
        while let ExprKind::Call(inner, arguments) = &callee.kind {
            calls.insert(0, arguments);
            callee = inner;
        }
        let ExprKind::Name(name) = &callee.kind else { return None };
        let mut calls = calls.into_iter();
        let mut order = Vec::new();
        if self.reader.library.order_count(self.scope.unit, name) > 0 {
            for o in calls.next().unwrap_or_default() {
                order.push(self.whole(o)?);
            }
        }
        let family = self.reader.library.family(self.scope.unit, name, &order).ok()?;
        let shapes = if family.shapes.is_empty() { &[][..] } else { calls.next()? };
        let parameter = if product { calls.next()?.first() } else { None };
        let unit = self.scope.unit;
        let functions = self.reader.inside(|reader| reader.family(unit, name, &order))?;
        let functions = family.functions.iter().map(|f| Some((f.index.clone(), *functions.get(&f.index)?)));
        let functions = functions.collect::<Option<Vec<_>>>()?;
        Some(Factor { family, shapes, parameter, functions })
    }

    /// The name of an index of shape values that has no meaning of its own.
    fn free_index(&self, shapes: &[Expr]) -> Option<String> {
        shapes.iter().find_map(|shape| {
            let ExprKind::Index(_, indices) = &shape.kind else { return None };
            indices.iter().find_map(|index| match &index.kind {
                ExprKind::Name(name) => {
                    let known = self.scope.constant(name).is_some()
                        || self.scope.names.contains(name)
                        || self.values.iter().any(|(n, _)| n == name);
                    (!known).then(|| name.clone())
                }
                _ => None,
            })
        })
    }

    fn shapes(&mut self, shapes: &[Expr]) -> Option<Vec<Term>> {
        shapes.iter().map(|x| self.scalar(x)).collect()
    }

    /// The control point with an index.
    fn point(&mut self, patch: usize, at: usize) -> Option<Vec<Term>> {
        if let Some(point) = &self.patches[patch].points[at] {
            let point = point.clone();
            self.reader.spend(point.iter().map(super::value::parts).sum())?;
            return Some(point);
        }
        let name = label(&self.patches[patch].name, &self.patches[patch].functions[at].0);
        let number = self.points.iter().position(|n| *n == name)?;
        let dimension = self.theorem.dimension.unwrap_or(1);
        Some((0..dimension).map(|k| Term::Variable(coordinate_variable(number, k))).collect())
    }
}

/// One factor of a surface.
struct Factor<'e> {
    family: Rc<Family>,
    shapes: &'e [Expr],
    parameter: Option<&'e Expr>,
    functions: Vec<(Vec<i64>, usize)>,
}
