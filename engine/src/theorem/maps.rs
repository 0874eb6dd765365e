//! Curves and surfaces at parameter values, and their derivatives.

use proc_macro2::Span;

use super::draft::{Elaboration, OWN, Value, kind};
use super::form::Form;
use crate::advice::along_edges;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::formula::print::Printer;
use crate::plural::{count, here};
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::{Listed, Mapped};

impl Elaboration<'_> {
    /// P(t), D(S, v, 2)(u, 0): Σ of the differentiated functions at the arguments, times the control points.
    pub(super) fn apply(
        &mut self,
        patch: usize,
        steps: &[Var],
        callee: &Expr,
        arguments: &[Expr],
        span: Span,
    ) -> Option<Form> {
        let def = &self.patches[patch];
        let (name, own) = (def.name.clone(), def.parameters.len());
        let all = own + usize::from(def.dependent.is_some());
        if arguments.len() != all {
            let names: Vec<&str> = def.parameters.iter().chain(&def.dependent).map(String::as_str).listed();
            let (wanted, names) = (count(all, "parameter"), names.join(", "));
            let error = self.scope.error(span, format!("`{name}` has {wanted}, {}", here(arguments.len())));
            let written = Printer { constants: &self.scope.constants, component: None }.print(callee);
            self.scope.report(error.help(format!("write `{written}({names})`")));
            return None;
        }
        let mut by = Vec::new();
        for argument in arguments {
            by.push(self.scalar(argument)?);
        }
        if all > own {
            let sum = by.iter().fold(Fraction::zero(), |sum, f| &sum + f);
            if sum != Fraction::constant(Rational::ONE) {
                let shown = sum.display(&self.scope.names);
                let error =
                    self.scope.error(span, format!("the barycentric coordinates sum to {shown}, not to 1"));
                self.scope.report(error.help("the last coordinate is 1 minus the others"));
                return None;
            }
            by.pop();
        }
        let inner = steps.iter().all(|var| var.0 < OWN);
        let mut sum = Form::default();
        for at in 0..self.patches[patch].points.len() {
            let mut f = self.patches[patch].functions[at].1.clone();
            if (0..own).any(|k| f.denom().depends_on(Var(k))) {
                // The arguments may lie outside of the domain.
                let value = self.at(f.clone(), &by, span)?;
                self.scope.must_be_defined(&value, span);
            }
            if inner {
                f = self.differentiated(f, steps, span)?;
                f = self.at(f, &by, span)?;
            }
            // Whatever the point is, it does not matter here.
            if f.is_zero() {
                continue;
            }
            self.use_point(patch, at, span);
            let done = sum.add_scaled(&self.patches[patch].points[at].value, &f, &self.scope.budget);
            self.fits(done, span)?;
        }
        if inner {
            return Some(sum);
        }
        // Shape values occur in functions and points: the sum is differentiated, and then the arguments put in.
        sum.map(&mut |f| {
            let f = self.differentiated(f.clone(), steps, span).ok_or(())?;
            self.at(f, &by, span).ok_or(())
        })
        .ok()
    }

    /// The arguments in place of the parameters; they do not contain these variables themselves.
    fn at(&self, mut f: Fraction, by: &[Fraction], span: Span) -> Option<Fraction> {
        for (k, value) in by.iter().enumerate() {
            if f.depends_on(Var(k)) {
                f = self.scope.put_one(&f, Var(k), value, span)?;
            }
        }
        Some(f)
    }

    fn differentiated(&self, mut f: Fraction, steps: &[Var], span: Span) -> Option<Fraction> {
        for var in steps {
            let size = (f.numer().len() + f.denom().len()) as u64;
            self.fits(self.scope.budget.spend(size), span)?;
            f = f.derivative(*var);
        }
        Some(f)
    }

    /// `D(P)`, `D(S, v, 2)` of a patch; `D(x, t)` of a scalar or vector.
    pub(super) fn derivative(&mut self, arguments: &[Expr], span: Span) -> Option<Value> {
        let Some((subject, rest)) = arguments.split_first() else {
            let error = self.scope.error(span, "`D` needs a curve or surface");
            self.scope.report(error.help("write `D(P)(0)` or `D(S, v, 2)(u, 0)`"));
            return None;
        };
        let value = self.value(subject)?;
        let mut steps: Vec<Var> = Vec::new();
        for argument in rest {
            let name = match &argument.kind {
                ExprKind::Name(_) | ExprKind::Index(..) => self.target_name(argument),
                _ => None,
            };
            match name.filter(|n| self.scope.constant(n).is_none()) {
                Some(name) => steps.push(self.step(&value, &name, argument.span)?),
                None => {
                    let order = self.scope.scalar(argument)?.as_constant().and_then(|n| n.to_i64());
                    let Some(order) = order.filter(|n| (0..=100).contains(n)) else {
                        let error = self.scope.error(argument.span, "this is not the order of a derivative");
                        self.scope.report(error.help(
                            "write a small whole number, `D(P, 2)`; the parameter value goes in brackets of its own, `D(P)(1/2)`",
                        ));
                        return None;
                    };
                    let var = match steps.pop() {
                        Some(var) => var,
                        None => self.only_parameter(&value, span)?,
                    };
                    steps.extend((0..order).map(|_| var));
                }
            }
        }
        if rest.is_empty() {
            steps.push(self.only_parameter(&value, span)?);
        }
        match value {
            Value::Map(patch, mut before) => {
                before.extend(steps);
                Some(Value::Map(patch, before))
            }
            Value::Scalar(f) => Some(Value::Scalar(self.differentiated(f, &steps, span)?)),
            Value::Vector(form) | Value::Outer(form) if steps.is_empty() => Some(Value::Vector(form)),
            Value::Vector(form) => {
                let form = form.map(&mut |f| self.differentiated(f.clone(), &steps, span).ok_or(()));
                form.ok().map(Value::Vector)
            }
            Value::Outer(form) => {
                let form = form.map(&mut |f| self.differentiated(f.clone(), &steps, span).ok_or(()));
                form.ok().map(Value::Outer)
            }
        }
    }

    /// integral(x, c, a, b): of a scalar or a vector in a scalar c.
    pub(super) fn integral(&mut self, arguments: &[Expr], span: Span) -> Option<Value> {
        let [subject, variable, low, high] = arguments else {
            let error = self.scope.error(span, "an integral needs its variable and bounds here");
            self.scope.report(error.help("write `integral(P(t), t, 0, 1)`"));
            return None;
        };
        let value = self.value(subject)?;
        let name = match &variable.kind {
            ExprKind::Name(_) | ExprKind::Index(..) => self.target_name(variable)?,
            _ => String::new(),
        };
        let Some(var) = self.scope.variable(&name).filter(|_| !name.is_empty()) else {
            if name.is_empty() || !self.scope.is_mistaken(&name) {
                let error =
                    self.scope.error(variable.span, "expected the variable of the integral, a scalar");
                self.scope.report(error.help("write `integral(P(t), t, 0, 1)`"));
            }
            return None;
        };
        let (low, high) = (self.scalar(low)?, self.scalar(high)?);
        let mut over = |f: &Fraction| self.scope.between_numbers(f, var, &low, &high, span).ok_or(());
        match value {
            Value::Scalar(f) => over(&f).ok().map(Value::Scalar),
            Value::Vector(form) => form.map(&mut over).ok().map(Value::Vector),
            Value::Outer(form) => form.map(&mut over).ok().map(Value::Outer),
            Value::Map(..) => {
                let error = self.scope.error(subject.span, "a curve or surface needs its parameters here");
                self.scope.report(error.help("write `integral(P(t), t, 0, 1)`"));
                None
            }
        }
    }

    /// The variable by which a name says to differentiate.
    fn step(&mut self, value: &Value, name: &str, span: Span) -> Option<Var> {
        if let Value::Map(patch, _) = value {
            let def = &self.patches[*patch];
            if let Some(own) = def.parameters.iter().position(|p| p == name) {
                return Some(Var(own));
            }
            if def.dependent.as_deref() == Some(name) {
                let parameters: Vec<&str> = def.parameters.mapped(String::as_str);
                let help = along_edges(&def.name, &parameters, name);
                let error =
                    self.scope.error(span, format!("`{name}` depends on the other barycentric coordinates"));
                self.scope.report(error.help(help));
                return None;
            }
        }
        if let Some(var) = self.scope.variable(name) {
            self.mention(var);
            return Some(var);
        }
        let error = self.scope.error(span, format!("`{name}` is not a variable to differentiate by"));
        self.scope.report(match value {
            Value::Map(patch, _) => {
                let def = &self.patches[*patch];
                error.help(format!(
                    "the parameters of `{}` are {}",
                    def.name,
                    crate::plural::list(&def.parameters)
                ))
            }
            _ => error.help("differentiate by a scalar"),
        });
        None
    }

    fn only_parameter(&self, value: &Value, span: Span) -> Option<Var> {
        let error = match value {
            Value::Map(patch, _) => match self.patches[*patch].parameters.as_slice() {
                [_] => return Some(Var(0)),
                names => {
                    let name = &self.patches[*patch].name;
                    let ways: Vec<String> = names.mapped(|n| format!("`D({name}, {n})`"));
                    let error = self.scope.error(span, format!("`{name}` has {} parameters", names.len()));
                    error.help(format!("say by which to differentiate: {}", ways.join(" or ")))
                }
            },
            other => {
                let error =
                    self.scope.error(span, format!("by which scalar is {} differentiated?", kind(other)));
                error.help("differentiate a curve first and then choose the parameter, `D(P)(0)`, or name the scalar, `D(x, t)`")
            }
        };
        self.scope.report(error);
        None
    }
}
