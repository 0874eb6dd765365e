//! Derivatives in expressions: `D(f)`, `D(f, 2)`, `D(f, x)`, `D(f, x, 2)`, `D(f, x, y)`.

use proc_macro2::Span;

use super::Value;
use crate::advice::along_edges;
use crate::algebra::poly::Var;
use crate::model::formula::print::Printer;
use crate::model::label;
use crate::model::scope::Scope;
use crate::model::words::PI;
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::{Listed, Mapped};

impl Scope<'_> {
    /// D(f), D(f, 2), D(f, x), D(f, x, 2), D(f, x, y).
    pub(crate) fn derivative(&mut self, arguments: &[Expr], span: Span) -> Option<Value> {
        let Some((f, rest)) = arguments.split_first() else {
            self.report(self.error(span, "`D` needs a function").help("write `D(b)` or `D(b[0], 2)`"));
            return None;
        };
        let mut steps: Vec<(Var, i64)> = Vec::new();
        for argument in rest {
            let name = match &argument.kind {
                ExprKind::Name(name) if self.constant(name).is_none() => Some(name.clone()),
                ExprKind::Index(base, indices) => match &base.kind {
                    ExprKind::Name(name) if self.is_list_of_shapes(name) => {
                        let mut index = Vec::new();
                        for i in indices {
                            index.push(self.whole(i, "the index of a shape parameter")?);
                        }
                        Some(label(name, &index))
                    }
                    _ => None,
                },
                _ => None,
            };
            let name = name.as_deref();
            match (name, steps.last_mut()) {
                (Some(name), _) => match self.variable_called(name) {
                    Some(var) if self.last_of(var).is_some() => {
                        let error = self.error(
                            argument.span,
                            format!("`{name}` depends on the other barycentric coordinates"),
                        );
                        let places = self.last_of(var).map_or(0..0, |s| s.places.clone());
                        let names: Vec<&str> = self.domain[places].mapped(|v| self.names[v.0].as_str());
                        self.report(error.help(along_edges(&self.shown_function(f), &names, name)));
                        return None;
                    }
                    Some(var) => steps.push((var, 1)),
                    None if self.is_mistaken(name) => return None,
                    None => {
                        self.no_variable(name, "differentiate", argument.span);
                        return None;
                    }
                },
                (None, None) if rest.len() > 1 && rest.iter().any(|other| self.mentions_domain(other)) => {
                    let error = self.error(argument.span, "the order of a derivative follows its variable");
                    let print = |e: &Expr| Printer { constants: &self.constants, component: None }.print(e);
                    let help = match rest {
                        [order, variable] => {
                            let (f, order) = (self.shown_function(f), print(order));
                            format!(
                                "write `D({f}, {}, {order})`, with one variable `D({f}, {order})`",
                                print(variable)
                            )
                        }
                        _ => String::from("write `D(b[0], t, 2)`, with one variable `D(b[0], 2)`"),
                    };
                    self.report(error.help(help));
                    return None;
                }
                (None, None) => {
                    let var = self.only_domain_variable(f, span)?;
                    if matches!(f.kind, ExprKind::Number(_)) && !matches!(argument.kind, ExprKind::Number(_))
                    {
                        let error = self.error(argument.span, "the function stands before the order");
                        self.report(error.help("write `D(b[0], 2)`"));
                        return None;
                    }
                    steps.push((var, self.whole(argument, "the order of a derivative")?));
                }
                (None, Some(_)) => {
                    let order = self.whole(argument, "the order of a derivative")?;
                    if let Some(last) = steps.last_mut() {
                        last.1 = order;
                    }
                }
            }
        }
        if steps.is_empty() {
            steps.push((self.only_domain_variable(f, span)?, 1));
        }
        if let Some((_, order)) = steps.iter().find(|(_, order)| *order < 0) {
            let error = self.error(span, format!("the order {order} of a derivative is negative"));
            self.report(error.help("orders are whole numbers, such as `D(b[0], 2)`"));
            return None;
        }
        if let ExprKind::Call(callee, values) = &f.kind
            && self.is_function(callee)
            && steps.iter().all(|(var, _)| self.is_domain_variable(*var))
            && !values.iter().any(|value| self.mentions_domain(value))
        {
            let printer = Printer { constants: &self.constants, component: None };
            let printed = |all: &[Expr]| all.mapped(|part| printer.print(part)).join(", ");
            let derivative = printed(&[core::slice::from_ref(&**callee), rest].concat());
            let own = printer.print(f);
            let error = self.error(f.span, format!("`{own}` depends on no domain variable"));
            self.report(error.help(format!("differentiate first: `D({derivative})({})`", printed(values))));
            return None;
        }
        let value = self.value(f)?;
        let mut result = Vec::new();
        let (list, single) = match value {
            Value::Scalar(f) => (vec![(Vec::new(), f)], true),
            Value::List(list) => (list, false),
        };
        for (index, mut f) in list {
            for (var, order) in &steps {
                let order = u32::try_from(*order).unwrap_or(u32::MAX);
                f = self.fits(self.budget.derivative(&f, (*var, order), &self.analytic), span)?;
            }
            result.push((index, f));
        }
        match result.pop() {
            Some((_, only)) if single => Some(Value::Scalar(only)),
            last => Some(Value::List(result.into_iter().chain(last).listed())),
        }
    }

    /// Reports a name by which nothing is differentiated or integrated.
    pub(crate) fn no_variable(&self, name: &str, what: &str, span: Span) {
        let error = self.error(span, format!("`{name}` is not a variable to {what} by"));
        let Some((_, own)) = self.determined.iter().find(|(known, _)| known == name) else {
            return self.report(error.help(format!("variables are {}", crate::plural::list(&self.names))));
        };
        let error = error.label("it follows from the other shape parameters");
        let error = error.note(format!("as assumed, `{name}` is {}", own.display(&self.names)));
        let others = (0..self.names.len()).map(Var).filter(|var| own.depends_on(*var));
        let others: Vec<String> = others.map(|var| format!("`D(…, {})`", self.names[var.0])).listed();
        self.report(match others.as_slice() {
            [] => error.help("it has one value only"),
            [only] if what == "differentiate" => error.help(format!("write {only}")),
            _ => error.help(format!("variables are {}", crate::plural::list(&self.names))),
        });
    }

    /// Whether an expression is a basis function, the list of them, or a derivative of these.
    fn is_function(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Name(name) => *name == self.function_name,
            ExprKind::Index(base, _) => self.is_function(base),
            ExprKind::Call(callee, arguments) => {
                matches!(&callee.kind, ExprKind::Name(name) if name == "D")
                    && arguments.first().is_some_and(|f| self.is_function(f))
            }
            _ => false,
        }
    }

    /// Whether a domain variable stands in an expression, or a name that may stand for one.
    fn mentions_domain(&self, expr: &Expr) -> bool {
        let is_shape = |name: &str| {
            self.variable(name).is_some_and(|var| !self.is_domain_variable(var))
                || self.is_list_of_shapes(name)
        };
        match &expr.kind {
            ExprKind::Name(name) => {
                self.mentions_variable(expr) && !PI.contains(&name.as_str()) && !is_shape(name)
            }
            _ => expr.parts().iter().any(|part| self.mentions_domain(part)),
        }
    }

    /// A function as it is written, where that is short; else the name of the functions.
    fn shown_function(&self, f: &Expr) -> String {
        match &f.kind {
            ExprKind::Name(_) | ExprKind::Index(..) => {
                Printer { constants: &self.constants, component: None }.print(f)
            }
            _ if self.function_name.is_empty() => String::from("b"),
            _ => self.function_name.clone(),
        }
    }

    fn only_domain_variable(&self, f: &Expr, span: Span) -> Option<Var> {
        if let [only] = self.domain.as_slice() {
            return Some(*only);
        }
        let names: Vec<String> = self.domain.mapped(|v| self.names[self.itself(*v).0].clone());
        let error = self.error(span, format!("there are {} domain variables", names.len()));
        let f = self.shown_function(f);
        let all = names.mapped(|name| format!("`D({f}, {name})`")).join(" or ");
        self.report(error.help(format!("say by which to differentiate: {all}")));
        None
    }
}
