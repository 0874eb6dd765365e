//! Names with arguments: which function is called, and arguments in place of its variables.

use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::scope::{CallSite, Needed, Planned, Scope, Stage};
use crate::model::words::{BUILTINS, is_transcendental};
use crate::plural::{count, here};
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::{Listed, Mapped};
use proc_macro2::Span;

impl Scope<'_> {
    /// The value of a call; of the functions of another family perhaps one only.
    pub(super) fn call(
        &mut self,
        callee: &Expr,
        arguments: &[Expr],
        only: Option<&[i64]>,
        span: Span,
    ) -> Option<Value> {
        match &callee.kind {
            ExprKind::Name(name) if self.is_called(name) => self.call_name(name, arguments, span),
            ExprKind::Name(name) if name == "D" => self.derivative(arguments, span),
            ExprKind::Name(name) if name == "integral" => self.integral(arguments, span),
            ExprKind::Name(name) if BUILTINS.contains(&name.as_str()) => self.builtin(name, arguments, span),
            ExprKind::Name(name) if is_transcendental(name) => {
                let [argument] = arguments else {
                    let error =
                        self.error(span, format!("`{name}` has one argument, {}", here(arguments.len())));
                    self.report(error.help(format!("write `{name}(t)`")));
                    return None;
                };
                Some(Value::Scalar(self.transcendental(name, argument, span)?))
            }
            ExprKind::Name(name) if *name != self.function_name && self.taken(name).is_some() => {
                let is_list = |value: Option<&Option<Value>>| matches!(value, Some(Some(Value::List(_))));
                if let (Some(_), None) = (self.planned.named(name), self.lets.named(name)) {
                    self.waits_for = Some((Needed::Name(name.clone()), callee.span));
                    return None;
                }
                let error = if is_list(self.lets.named(name)) {
                    let error = self.error(callee.span, format!("`{name}` is a list, not a function"));
                    error.help(format!("write `{name}[0]` for its first entry"))
                } else {
                    // `let h = t^2; … h(1 - t)`
                    let varies = match self.lets.named(name) {
                        Some(Some(Value::Scalar(f))) => self.domain.iter().any(|v| self.occurs(f, *v)),
                        _ => false,
                    };
                    let error = self.error(callee.span, format!("`{name}` is not a function"));
                    error.help(if varies {
                        format!(
                            "write `let {name}(s) = …;` for a name with an argument, `{name}*(…)` for a product"
                        )
                    } else {
                        format!("write `{name}*(…)` for a product")
                    })
                };
                self.report(error);
                None
            }
            ExprKind::Name(name) if *name != self.function_name => {
                if !self.library.knows(self.unit, name) {
                    self.unknown_function(name, callee.span);
                    return None;
                }
                if self.library.order_count(self.unit, name) == 0 {
                    self.family(name, &[], arguments, None, only, span)
                } else {
                    self.family(name, arguments, &[], None, only, span)
                }
            }
            // Family(order)(shape values)
            ExprKind::Call(inner, orders)
                if matches!(&inner.kind, ExprKind::Name(name)
                    if self.library.order_count(self.unit, name) > 0 && self.taken(name).is_none()) =>
            {
                let ExprKind::Name(name) = &inner.kind else { return None };
                self.family(name, orders, arguments, None, only, span)
            }
            ExprKind::Name(_) | ExprKind::Index(..) | ExprKind::Call(..) => {
                if let Some(factor) = self.factor(callee) {
                    return self.factor_at(factor, arguments, span);
                }
                let value = self.value(callee)?;
                self.apply(value, arguments, span)
            }
            _ => {
                let error = self.error(callee.span, "this is not a function");
                self.report(error.help("write `*` between the factors of a product"));
                None
            }
        }
    }

    /// Whether a name stands for an expression with arguments.
    fn is_called(&self, name: &str) -> bool {
        self.arguments.iter().all(|(n, _)| n != name)
            && self.variable(name).is_none()
            && self.planned.named(name).is_some_and(|planned| !planned.parameters.is_empty())
    }

    /// h(x): the expression that `let h(x) = …` gives, with a value in place of each argument.
    fn call_name(&mut self, name: &str, arguments: &[Expr], span: Span) -> Option<Value> {
        let Planned { parameters, value, .. } = *self.planned.named(name)?;
        if parameters.len() != arguments.len() {
            let names: Vec<&str> = parameters.mapped(|p| p.text.as_str());
            let message =
                format!("`{name}` takes {}, {}", count(parameters.len(), "argument"), here(arguments.len()));
            let error = self.error(span, message);
            self.report(error.help(format!("write `{name}({})`", names.join(", "))));
            return None;
        }
        if let Some(first) = self.calls.iter().position(|active| active == name) {
            let mut error = self.error(span, format!("`{name}` is defined by itself"));
            if first + 1 < self.calls.len() {
                error = error.note(format!("the circle is {} -> {name}", self.calls[first..].join(" -> ")));
            }
            self.report(
                error.help("a formula may use functions and names, in any order, that do not need it"),
            );
            return None;
        }
        let mut own = Vec::new();
        for (parameter, argument) in parameters.iter().zip(arguments) {
            own.push((parameter.text.clone(), self.value(argument)?));
        }
        if !self.library.enter() {
            let error = self.error(span, "names with arguments use one another through too many levels");
            self.report(error.help("write a part of the formula out"));
            return None;
        }
        if self.siblings.is_some() {
            self.call_sites.push(CallSite {
                parameters: parameters.mapped(|p| p.text.clone()),
                arguments: arguments.to_vec(),
                constants: self.constants.clone(),
            });
        }
        // What is around the call has no meaning in the formula of the name.
        let around = self.constants.split_off(self.order.min(self.constants.len()));
        let outer = core::mem::replace(&mut self.arguments, own);
        self.calls.push(name.to_string());
        let result = self.value(value);
        self.calls.pop();
        self.call_sites.pop();
        self.arguments = outer;
        self.constants.extend(around);
        self.library.leave();
        result
    }

    /// A value that is kept, counted.
    pub(super) fn copy(&self, value: &Value, span: Span) -> Option<Value> {
        match value {
            Value::Scalar(f) => self.fits(self.budget.copy(f), span)?,
            Value::List(list) => {
                for (_, f) in list {
                    self.fits(self.budget.copy(f), span)?;
                }
            }
        }
        Some(value.clone())
    }

    /// f(x): the function with an argument in place of the domain variable.
    pub(super) fn apply(&mut self, value: Value, arguments: &[Expr], span: Span) -> Option<Value> {
        let factors = self.factors();
        let all = factors.iter().map(Vec::len).sum();
        if arguments.len() != all {
            let expected = count(all, "argument");
            let error = self.error(span, format!("the functions take {expected}, {}", here(arguments.len())));
            let variables: Vec<&str> = factors.iter().flatten().map(|v| self.names[v.0].as_str()).listed();
            let function = format!("{}[…]({})", self.function_name, variables.join(", "));
            self.report(error.help(if all == 1 {
                format!("write `{function}`")
            } else {
                format!("write one for each coordinate, `{function}`")
            }));
            return None;
        }
        let mut by = Vec::new();
        for argument in arguments {
            by.push(self.scalar(argument)?);
        }
        let by = self.independent_of(&factors.mapped(Vec::len), &by, span)?;
        match value {
            Value::Scalar(f) => Some(Value::Scalar(self.at_arguments(&f, &by, span)?)),
            Value::List(list) => {
                let mut result = Vec::new();
                for (index, f) in list {
                    result.push((index, self.at_arguments(&f, &by, span)?));
                }
                Some(Value::List(result))
            }
        }
    }

    /// The arguments in place of the independent variables of a domain whose factors have these numbers of variables.
    /// Those in place of the coordinates of a simplex sum to 1.
    pub(crate) fn independent_of(
        &self,
        factors: &[usize],
        arguments: &[Fraction],
        span: Span,
    ) -> Option<Vec<Fraction>> {
        let mut independent = Vec::new();
        let mut rest = arguments;
        for count in factors {
            let (own, others) = rest.split_at(*count);
            rest = others;
            if *count > 1 {
                self.check_corners(own, span)?;
            }
            independent.extend_from_slice(&own[..(*count - 1).max(1)]);
        }
        Some(independent)
    }

    /// Barycentric coordinates sum to 1.
    fn check_corners(&self, coordinates: &[Fraction], span: Span) -> Option<()> {
        let sum = coordinates.iter().fold(Fraction::zero(), |sum, f| &sum + f);
        if sum == Fraction::constant(Rational::ONE) {
            return Some(());
        }
        let shown = sum.display(&self.names);
        let error = self.error(span, format!("the barycentric coordinates sum to {shown}, not to 1"));
        self.report(error.help("choose coordinates that sum to 1"));
        None
    }

    /// The function with arguments in place of the domain variables; they may leave the domain, but not come upon a
    /// zero of its denominator.
    fn at_arguments(&mut self, f: &Fraction, by: &[Fraction], span: Span) -> Option<Fraction> {
        if self.span.is_some() {
            let error = self.error(span, "a function on several spans has no argument");
            self.report(error.help("claim what holds at a point: `at x = 2 { … }`"));
            return None;
        }
        let (mut vars, mut values) = (Vec::new(), Vec::new());
        #[cfg(feature = "angles")]
        if let Some(recorded) = &mut self.recorded {
            recorded.places.extend(self.domain.iter().copied().zip(by.iter().cloned()));
        }
        for (var, value) in self.domain.iter().zip(by) {
            let Some(angle) = self.analytic.angle(*var) else {
                vars.push(*var);
                values.push(value.clone());
                continue;
            };
            if f.depends_on(angle.var) {
                let y = match self.angle_at(angle, value, span) {
                    Ok(y) => y?,
                    Err((message, help)) => {
                        self.report(self.error(span, message).help(help));
                        return None;
                    }
                };
                vars.push(angle.var);
                values.push(y);
            }
            vars.push(angle.itself);
            values.push(value.clone());
        }
        let value = self.put_or(f, &vars, &values, span, &|| self.pole(by, span))?;
        if self.domain.iter().any(|v| f.denom().depends_on(*v)) {
            self.must_be_defined(&value, span);
        }
        Some(value)
    }

    /// The error for a place at which a denominator of a function is zero.
    fn pole(&self, by: &[Fraction], span: Span) -> Diagnostic {
        let at = |(var, value): (&Var, &Fraction)| {
            format!("{} = {}", self.names[self.itself(*var).0], value.display(&self.names))
        };
        let place = self.domain.iter().zip(by).map(at).listed().join(", ");
        let error = self.error(span, format!("the function has a pole at {place}"));
        error.label("a denominator is zero there").help("choose a place at which the function has a value")
    }

    /// A function with others put in place of variables, all at once.
    pub(crate) fn put(&self, f: &Fraction, vars: &[Var], by: &[Fraction], span: Span) -> Option<Fraction> {
        self.put_or(f, vars, by, span, &|| self.zero_denominator(span))
    }

    /// The error for a denominator that becomes zero.
    fn zero_denominator(&self, span: Span) -> Diagnostic {
        self.error(span, "a denominator becomes zero here")
    }

    /// The same with another error for a denominator that becomes zero.
    fn put_or(
        &self,
        f: &Fraction,
        vars: &[Var],
        by: &[Fraction],
        span: Span,
        instead: &dyn Fn() -> Diagnostic,
    ) -> Option<Fraction> {
        let mut result = f.clone();
        let later = |k: usize| vars.iter().skip(k + 1).any(|var| by[k].depends_on(*var));
        if !(0..by.len()).any(later) {
            for (var, value) in vars.iter().zip(by) {
                result = self.put_one_or(&result, *var, value, span, instead)?;
            }
            return Some(result);
        }
        // By way of variables that occur nowhere, so that no argument is substituted twice.
        let aside = self.names.len(); // no variable has these numbers
        for (k, var) in vars.iter().enumerate() {
            result = self.put_one_or(&result, *var, &Fraction::var(Var(aside + k)), span, instead)?;
        }
        for (k, value) in by.iter().enumerate() {
            result = self.put_one_or(&result, Var(aside + k), value, span, instead)?;
        }
        Some(result)
    }

    pub(crate) fn put_one(&self, f: &Fraction, var: Var, by: &Fraction, span: Span) -> Option<Fraction> {
        self.put_one_or(f, var, by, span, &|| self.zero_denominator(span))
    }

    /// The same with another error for a denominator that becomes zero.
    pub(crate) fn put_one_or(
        &self,
        f: &Fraction,
        var: Var,
        by: &Fraction,
        span: Span,
        instead: &dyn Fn() -> Diagnostic,
    ) -> Option<Fraction> {
        if !f.depends_on(var) {
            return Some(f.clone());
        }
        let put = self.fits(self.budget.substitute(f, var, by), span)?;
        // An error about the denominator of a function says more.
        if put.is_none() && self.stage != Stage::Broken {
            self.report(instead());
        }
        put
    }

    /// A value with those of the shape parameters that are fixed.
    pub(crate) fn put_all(&self, f: Fraction, fixed: &[(Var, Fraction)], span: Span) -> Option<Fraction> {
        fixed.iter().try_fold(f, |f, (var, by)| self.put_one(&f, *var, by, span))
    }
}
