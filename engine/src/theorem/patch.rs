//! Curves and surfaces: `curve P = F(λ) […];`, `surface S = F(λ)(u) * G(γ[i])(v);`,
//! `surface T = TriangularII(4)(λ1, λ2);`.

use std::rc::Rc;

use proc_macro2::Span;

use super::draft::{Elaboration, Implicit, OWN, PatchDef};
use super::form::{Form, Unit};
use super::{ControlPoint, GivenPoint, Origin};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::model::formula::print::Printer;
use crate::model::scope::Inside;
use crate::model::{Family, Parameter, label};
use crate::plural::{count, here};
use crate::syntax::{Expr, ExprKind, Name, PatchKind, Role};
use basis_prover::collections::list::{Listed, Mapped};

/// One factor of a surface: a family with its shape values as they are written, and the name of its parameter.
struct Factor<'e> {
    family: Rc<Family>,
    shapes: &'e [Expr],
    parameter: Option<&'e Expr>,
    span: Span,
}

impl Elaboration<'_> {
    /// A statement that declares a curve or a surface.
    pub(super) fn patch(&mut self, kind: PatchKind, name: &Name, value: &Expr) -> Option<()> {
        self.check_free(&name.text, name.span)?;
        let (written, points) = split_points(value);
        let (parts, listed) = match &written {
            Some(parts) => (parts.clone(), points),
            None => (vec![value], points),
        };
        if parts.len() > 2 || (kind == PatchKind::Curve && parts.len() > 1) {
            let error = self.scope.error(value.span, "this is not a curve or surface");
            self.scope.report(error.help(
                "a curve is one family, `curve P = Bernstein(3);`, a surface a family on a triangle or a product of two, `surface S = Bernstein(3)(u) * Bernstein(2)(v);`",
            ));
            return None;
        }
        let product = parts.len() == 2;
        let mut factors = Vec::new();
        for part in &parts {
            factors.push(self.factor(part, product)?);
        }
        let printer = Printer { constants: &[], component: None };
        let shown: Vec<String> = parts.mapped(|p| printer.print(p));
        let mut def = PatchDef {
            name: name.text.clone(),
            written: shown.join("*"),
            kind,
            parameters: Vec::new(),
            dependent: None,
            functions: Vec::new(),
            points: Vec::new(),
            used: Vec::new(),
        };
        match factors.as_slice() {
            [a, b] => self.tensor_product(a, b, &mut def)?,
            [only] => self.single(only, &mut def, name)?,
            _ => return None,
        }
        self.control_points(&mut def, listed, name, value)?;
        self.patches.push(def);
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
        let ExprKind::Name(name) = &callee.kind else {
            let error = self.scope.error(callee.span, "expected the name of a family");
            self.scope.report(error.help("write `Bernstein(3)` or `QuarticBernstein(λ)`"));
            return None;
        };
        let mut calls = calls.into_iter();
        let mut order = Vec::new();
        if self.scope.library.order_count(self.scope.unit, name) > 0 {
            for o in calls.next().unwrap_or_default() {
                if self.scope.mentions_variable(o) {
                    let error = self.scope.error(o.span, "the order of a family is a number here");
                    let shapes = if calls.len() == 0 {
                        String::new()
                    } else {
                        format!("; shape values follow: `{name}(3)(λ)`")
                    };
                    self.scope.report(error.help(format!(
                        "a {} is about one order of each family: write `{name}(3)`{shapes}",
                        self.kind.keyword()
                    )));
                    return None;
                }
                order.push(self.scope.whole(o, "the order of a family")?);
            }
        }
        let family = match self.scope.library.family(self.scope.unit, name, &order) {
            Ok(family) => family,
            Err(reason) => {
                if let Some((message, help)) = reason {
                    self.scope.report(self.scope.error(callee.span, message).help(help));
                }
                return None;
            }
        };
        if !family.analytic.is_empty() || !family.pieces.is_empty() {
            let what = if family.pieces.is_empty() {
                "has sin, cos, exp, pi, or a shape parameter at an end of its domain, if only in a claim"
            } else {
                "has several spans"
            };
            let error = self.scope.error(callee.span, format!("`{name}` {what}"));
            self.scope.report(
                error.help("theorems are about curves over families of polynomials and their quotients; a claim with `pi` belongs to a family of its own"),
            );
            return None;
        }
        let shapes = if family.shapes.is_empty() { &[][..] } else { calls.next().unwrap_or_default() };
        let wanted: Vec<String> = family.shapes.mapped(|s| s.name.clone());
        let call = if wanted.is_empty() {
            family.title()
        } else {
            format!("{}({})", family.title(), wanted.join(", "))
        };
        if shapes.len() != wanted.len() {
            let has = count(wanted.len(), "shape parameter");
            let error = self
                .scope
                .error(expr.span, format!("`{}` has {has}, {}", family.title(), here(shapes.len())));
            self.scope.report(error.help(format!("write `{call}`")));
            return None;
        }
        let parameter = calls.next();
        if calls.next().is_some()
            || parameter.is_some_and(|p| p.len() != 1)
            || (parameter.is_some() != product)
        {
            let written = Printer { constants: &[], component: None }.print(expr);
            let (message, help) = match parameter {
                None => (
                    "a factor of a surface names its parameter",
                    format!(
                        "write `{written}(u)` or `{written}(v)`, as in `Bernstein(3)(u) * Bernstein(2)(v)`"
                    ),
                ),
                Some([Expr { kind: ExprKind::Name(_), .. }]) if !product => (
                    "a parameter is named in a product only",
                    format!("write `{call}`, and `P(t)` for a point of the curve `P`"),
                ),
                Some(_) => (
                    "this is not a curve or surface",
                    format!("write `{call}`, with given control points in brackets `{call} [(0, 0), …]`"),
                ),
            };
            self.scope.report(self.scope.error(expr.span, message).help(help));
            return None;
        }
        Some(Factor { family, shapes, parameter: parameter.and_then(<[Expr]>::first), span: expr.span })
    }

    /// A family on an interval, a box or a simplex.
    fn single(&mut self, factor: &Factor<'_>, def: &mut PatchDef, name: &Name) -> Option<()> {
        let family = &factor.family;
        if def.kind == PatchKind::Curve && family.interval().is_none() {
            let error =
                self.scope.error(factor.span, format!("`{}` is not a family on an interval", family.title()));
            self.scope.report(error.help(format!("write `surface {} = …;`", name.text)));
            return None;
        }
        if def.kind == PatchKind::Surface && family.domain.len() < 2 || family.domain.len() > OWN {
            let error = self.scope.error(factor.span, "a surface has two parameters");
            self.scope.report(error.help(format!(
                "write `curve {} = …;`, or a product such as `Bernstein(3)(u) * Bernstein(2)(v)`",
                name.text
            )));
            return None;
        }
        if family.is_product() {
            let message =
                format!("`{}` is a family on a product of a simplex and something else", family.title());
            let help = "theorems are about families on intervals, triangles, tetrahedra and boxes; claim what holds in the family itself";
            self.scope.report(self.scope.error(factor.span, message).help(help));
            return None;
        }
        for parameter in &family.domain {
            self.parameter(&parameter.name, &parameter.range, factor.span);
            def.parameters.push(parameter.name.clone());
        }
        def.dependent = family.simplices.first().map(|s| s.last.name.clone());
        if let Some(last) = &def.dependent {
            let last = last.clone();
            self.dependent_parameter(&last, family);
        }
        let shapes = self.shapes(factor)?;
        let own: Vec<Var> = (0..family.domain.len()).map(Var).listed();
        for f in &family.functions {
            def.functions.push((f.index.clone(), self.put_shapes(&f.value, &shapes, &own, factor.span)?));
        }
        Some(())
    }

    /// Σ bᵢ(u) cⱼ(v): the shape values of c may depend on i, those of b on j.
    fn tensor_product(&mut self, a: &Factor<'_>, b: &Factor<'_>, def: &mut PatchDef) -> Option<()> {
        for factor in [a, b] {
            let (Some(expr), [domain]) = (factor.parameter, factor.family.domain.as_slice()) else {
                let error =
                    self.scope.error(factor.span, "the factors of a surface are families on an interval");
                self.scope.report(error.help("write `Bernstein(3)(u) * Bernstein(2)(v)`"));
                return None;
            };
            let ExprKind::Name(name) = &expr.kind else {
                let error = self.scope.error(expr.span, "expected the name of a parameter of the surface");
                self.scope.report(error.help(
                    "write `Bernstein(3)(u) * Bernstein(2)(v)`, and `S(u, 0)` for points of the surface `S`",
                ));
                return None;
            };
            if def.parameters.contains(name) {
                let error =
                    self.scope.error(expr.span, "the two parameters of a surface have different names");
                self.scope.report(error.help("write `Bernstein(3)(u) * Bernstein(2)(v)`"));
                return None;
            }
            self.parameter(name, &domain.range, factor.span);
            def.parameters.push(name.clone());
        }
        let (rows, columns) = (&a.family.functions, &b.family.functions);
        let (column_name, row_name) = (self.free_index(a.shapes).ok()?, self.free_index(b.shapes).ok()?);
        // One list of functions for each value of the index, or one for all.
        let mut first: Vec<Vec<Fraction>> = Vec::new();
        let mut second: Vec<Vec<Fraction>> = Vec::new();
        for (factor, name, other, lists, var) in
            [(a, &column_name, columns, &mut first, Var(0)), (b, &row_name, rows, &mut second, Var(1))]
        {
            let times = if name.is_some() { other.len() } else { 1 };
            for k in 0..times {
                let depth = self.scope.constants.len();
                if let Some(name) = name {
                    self.scope.constants.push((name.clone(), k as i64));
                }
                let shapes = self.shapes(factor);
                self.scope.constants.truncate(depth);
                let shapes = shapes?;
                let mut list = Vec::new();
                for f in &factor.family.functions {
                    list.push(self.put_shapes(&f.value, &shapes, &[var], factor.span)?);
                }
                lists.push(list);
            }
        }
        for (i, row) in rows.iter().enumerate() {
            for (j, column) in columns.iter().enumerate() {
                let (x, y) = (&first[j % first.len()][i], &second[i % second.len()][j]);
                let product = self.fits(self.scope.budget.mul(x, y), a.span)?;
                let index = row.index.iter().chain(&column.index).copied().listed();
                def.functions.push((index, product));
            }
        }
        Some(())
    }

    /// The name among the indices of shape values that has no meaning yet: it stands for the row, or the column.
    ///
    /// # Errors
    /// There are several; that is reported.
    fn free_index(&mut self, shapes: &[Expr]) -> Result<Option<String>, ()> {
        let mut found: Option<String> = None;
        for shape in shapes {
            let ExprKind::Index(_, indices) = &shape.kind else { continue };
            for index in indices {
                let ExprKind::Name(name) = &index.kind else { continue };
                if self.taken(name).is_some() || found.as_ref() == Some(name) {
                    continue;
                }
                if found.is_some() {
                    let error = self.scope.error(index.span, "there is more than one index without a value");
                    self.scope.report(
                        error.help("one index stands for the row of the net: `F(λ)(u) * F(γ[i])(v)`"),
                    );
                    return Err(());
                }
                found = Some(name.clone());
            }
        }
        Ok(found)
    }

    /// The shape values; a new name becomes a scalar with the declared range of the shape parameter.
    fn shapes(&mut self, factor: &Factor<'_>) -> Option<Vec<Fraction>> {
        let mut values = Vec::new();
        for (expr, parameter) in factor.shapes.iter().zip(&factor.family.shapes) {
            let name = self.target_name(expr);
            if let (None, ExprKind::Index(..)) = (&name, &expr.kind) {
                return None;
            }
            if let Some(name) = name.filter(|name| !self.scope.constants.iter().any(|(n, _)| n == name)) {
                if self.taken(&name).is_none() && !self.is_point(expr) {
                    let var = self.new_scalar(&name, parameter.range.clone(), &parameter.doc, expr.span);
                    self.shape_values.push(var);
                    values.push(Fraction::var(var));
                    continue;
                }
                let var = self.scope.variable(&name);
                if var.is_some_and(|var| self.implicit.iter().any(|p| p.var == var)) {
                    let message =
                        format!("`{name}` is the parameter of a curve or surface, not a shape value");
                    self.scope.report(self.scope.error(expr.span, message).help(format!(
                        "choose another name; where the shape value is to change along the curve, declare `scalar 0 <= {name} <= 1;` before"
                    )));
                    return None;
                }
                // A name that another shape value introduced belongs to both ranges. One with a range of its own is
                // never cut: it must lie inside.
                let introduced = |p: &Parameter| p.name == name && self.shape_values.contains(&p.var);
                if let Some(at) = self.scalars.iter().position(introduced) {
                    self.narrow(at, &parameter.range, expr.span)?;
                }
            }
            let value = self.scalar(expr)?;
            let inside = Inside {
                value: value.clone(),
                name: parameter.name.clone(),
                range: parameter.range.clone(),
                family: Some(factor.family.title()),
                assumable: true,
                written: None,
            };
            let place = self.scope.place(expr.span);
            self.scope.must_stay_inside(inside, place);
            values.push(value);
        }
        let span = factor.shapes.first().map_or_else(Span::call_site, |expr| expr.span);
        self.inherit(&factor.family, &values, span)?;
        Some(values)
    }

    fn is_point(&self, expr: &Expr) -> bool {
        let ExprKind::Index(base, _) = &expr.kind else { return false };
        matches!(&base.kind, ExprKind::Name(name) if self.patches.iter().any(|p| p.name == *name))
    }

    /// A function of a family with shape values, and with the variables of the patch, in place of its own.
    fn put_shapes(&mut self, f: &Fraction, shapes: &[Fraction], own: &[Var], span: Span) -> Option<Fraction> {
        // The family's shape parameters stand aside, so that no value is substituted into another.
        let aside: Vec<Var> = (0..shapes.len()).map(|k| Var(self.scope.names.len() + k)).listed();
        let names: Vec<Var> = aside.iter().chain(own).copied().chain([Var(OWN - 1)]).listed();
        let mut value = f.rename(&names);
        for (var, by) in aside.iter().zip(shapes) {
            let put = self.scope.budget.substitute(&value, *var, by);
            let Some(put) = self.fits(put, span)? else {
                self.scope.report(self.scope.error(span, "a denominator of the family becomes zero here"));
                return None;
            };
            value = put;
        }
        Some(value)
    }

    /// The parameter of a patch is a scalar on the domain, unless the name has a meaning already.
    fn parameter(&mut self, name: &str, range: &Range, span: Span) {
        if self.taken(name).is_none() {
            let var = self.new_scalar(name, range.clone(), &[], span);
            self.implicit.push(Implicit { var, mentioned: false });
        }
    }

    /// The last barycentric coordinate is 1 minus the others.
    fn dependent_parameter(&mut self, name: &str, family: &Family) {
        if self.taken(name).is_some() {
            return;
        }
        let mut rest = Fraction::constant(crate::algebra::rational::Rational::ONE);
        for parameter in &family.domain {
            let Some(var) = self.scope.variable(&parameter.name) else { return };
            rest = &rest - &Fraction::var(var);
        }
        self.scope.lets.insert(name.to_string(), Some(crate::model::formula::Value::Scalar(rest)));
    }

    /// The control points: those that are listed, or given ones.
    fn control_points(
        &mut self,
        def: &mut PatchDef,
        listed: Option<&[Expr]>,
        name: &Name,
        value: &Expr,
    ) -> Option<()> {
        let Some(listed) = listed else {
            for (index, _) in &def.functions {
                let form = self.given(&def.name, index);
                let origin = Origin::Given;
                def.points.push(ControlPoint { index: index.clone(), value: form, origin });
            }
            def.used = vec![None; def.points.len()];
            return Some(());
        };
        // The net of a surface is a list of rows.
        let flat: Vec<&Expr> = listed
            .iter()
            .flat_map(|e| match &e.kind {
                ExprKind::List(row) => row.iter().listed(),
                _ => vec![e],
            })
            .listed();
        let in_brackets = listed.iter().find(|e| {
            matches!(&e.kind, ExprKind::List(row)
            if row.iter().all(|x| matches!(x.kind, ExprKind::Number(_))))
        });
        if let Some(point) = in_brackets {
            let error = self.scope.error(point.span, "a point is written in parentheses, these are brackets");
            self.scope.report(error.help("write `(0, 1)` for a point, `[(0, 0), (0, 1)]` for a row of two"));
            return None;
        }
        self.check_rows(def, listed, name, value)?;
        if flat.len() != def.functions.len() {
            let wanted = count_points(def.functions.len());
            let error =
                self.scope.error(value.span, format!("`{}` has {wanted}, {}", name.text, here(flat.len())));
            let last = def.functions.last().map_or_else(String::new, |(index, _)| label(&name.text, index));
            self.scope
                .report(error.help(format!("write one point for each index, the last one is `{last}`")));
            return None;
        }
        for ((index, _), expr) in def.functions.iter().zip(flat) {
            let form = self.vector(expr, "a control point")?;
            def.points.push(ControlPoint { index: index.clone(), value: form, origin: Origin::Listed });
        }
        def.used = vec![None; def.points.len()];
        Some(())
    }

    /// A net is written in rows, those of the functions with the same first index.
    fn check_rows(&self, def: &PatchDef, listed: &[Expr], name: &Name, value: &Expr) -> Option<()> {
        let width = def.functions.first().map_or(0, |(index, _)| index.len());
        let lengths: Vec<usize> = listed
            .iter()
            .map(|e| match &e.kind {
                ExprKind::List(row) => row.len(),
                _ => 0,
            })
            .listed();
        let in_rows = lengths.iter().any(|length| *length > 0);
        let is_net = width == 2 && def.dependent.is_none();
        if !is_net && !in_rows {
            return Some(());
        }
        let rows = def.functions.chunk_by(|(a, _), (b, _)| a.first() == b.first()).map(<[_]>::len).listed();
        if is_net && rows == lengths {
            return Some(());
        }
        let error =
            self.scope.error(value.span, format!("the control points of `{}` are not its net", name.text));
        let help = if is_net {
            let (count, first) = (rows.len(), rows.first().copied().unwrap_or(0));
            format!(
                "write a list of {count} rows, of those with the same first index, the first one of {}: `[[(0, 0), (0, 1)], [(1, 0), (1, 1)]]`",
                count_points(first)
            )
        } else {
            String::from("write one list of points in the order of the functions, `[(0, 0), (1, 0), (0, 1)]`")
        };
        self.scope.report(error.help(help));
        None
    }

    /// A point that can be any point: a unit, or with coordinates a combination of basis vectors.
    fn given(&mut self, patch: &str, index: &[i64]) -> Form {
        let name = label(patch, index);
        let mut coordinates = Vec::new();
        let mut form = Form::default();
        match self.dimension {
            None => form = Form::unit(Unit::Point(self.points.len())),
            Some(dimension) => {
                for k in 0..dimension {
                    let var = self.new_variable(format!("{name}[{k}]"));
                    coordinates.push(var);
                    form.terms.insert(Unit::Point(k), Fraction::var(var));
                }
            }
        }
        self.points.push(GivenPoint { name, patch: self.patches.len(), index: index.to_vec(), coordinates });
        form
    }

    /// `let P[i] = …;`
    pub(super) fn define_point(
        &mut self,
        patch: usize,
        index: &[i64],
        span: Span,
        value: &Expr,
    ) -> Option<()> {
        // The value is read first: it may not use the point itself.
        let at = self.patches[patch].points.iter().position(|p| p.index == index);
        let before = at.and_then(|at| self.patches[patch].used[at]);
        let form = self.vector(value, "a control point")?;
        let Some(at) = at else {
            self.no_point(patch, index, span);
            return None;
        };
        let name = label(&self.patches[patch].name, index);
        let (message, help) = match self.patches[patch].points[at].origin {
            Origin::Given => {
                if let Some(used) = self.patches[patch].used[at] {
                    self.used_before(patch, at, used, before.map(|_| span));
                    return None;
                }
                let point = &mut self.patches[patch].points[at];
                point.value = form;
                point.origin = Origin::Determined;
                return Some(());
            }
            Origin::Listed => (
                format!("`{name}` is given by the list of control points"),
                "leave out the list, or this statement",
            ),
            Origin::Determined => (format!("`{name}` is determined twice"), "remove one of the statements"),
        };
        self.scope.report(self.scope.error(span, message).help(help));
        None
    }

    /// Reports a point that something before its `let` depends on, or its own value if nothing else says where it is
    /// determined.
    fn used_before(&self, patch: usize, at: usize, used: Span, determined: Option<Span>) {
        let def = &self.patches[patch];
        let name = label(&def.name, &def.points[at].index);
        let Some(determined) = determined else {
            let error = self.scope.error(used, format!("`{name}` is determined by itself"));
            self.scope.report(error.help("a control point is determined by other points: solve for it"));
            return;
        };
        let error = self.scope.error(used, format!("this depends on `{name}`, which is determined later"));
        self.scope.report(error.also(self.scope.place(determined), "determined here").help(format!(
            "move `let {name} = …;` before it; a point may depend only on points that are known"
        )));
    }
}

/// The factors of a product, and the list of control points that stands after the last one.
pub(crate) fn split_points(value: &Expr) -> (Option<Vec<&Expr>>, Option<&[Expr]>) {
    let (mut factors, last) = match &value.kind {
        ExprKind::Product(parts) if parts.iter().all(|(role, _)| *role == Role::Factor) => {
            let mut factors: Vec<&Expr> = parts.mapped(|(_, e)| e);
            let Some(last) = factors.pop() else { return (None, None) };
            (factors, last)
        }
        _ => (Vec::new(), value),
    };
    match &last.kind {
        ExprKind::Index(base, points) => {
            factors.push(base);
            (Some(factors), Some(points))
        }
        _ => {
            factors.push(last);
            (Some(factors), None)
        }
    }
}

/// The points that a patch has, in words.
fn count_points(n: usize) -> String {
    count(n, "control point")
}
