//! Expressions that must be numbers: whole numbers, ends of ranges, budgets.

use proc_macro2::Span;

use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::scope::{Scope, Subject};
use crate::model::words::BUILTINS;
use crate::syntax::{Expr, ExprKind, IndexRange, Limit};

impl Scope<'_> {
    /// The number that an expression is; reports anything else.
    pub(crate) fn number(&mut self, expr: &Expr, what: &str) -> Option<Rational> {
        let value = self.scalar(expr)?.as_constant();
        if value.is_none() {
            self.report(self.no_number(expr, what));
        }
        value
    }

    /// The same, with what to write instead.
    pub(crate) fn number_or(&mut self, expr: &Expr, what: &str, help: &str) -> Option<Rational> {
        let value = self.scalar(expr)?.as_constant();
        if value.is_none() {
            self.report(self.no_number(expr, what).help(help));
        }
        value
    }

    /// The error about something that has to be a number.
    fn no_number(&self, expr: &Expr, what: &str) -> Diagnostic {
        self.error(expr.span, format!("{what} must be a number")).label("this contains a variable")
    }

    /// The number that an argument of `min`, `max`, `floor` or `ceil` is.
    pub(crate) fn compared_number(&mut self, expr: &Expr, function: &str) -> Option<Rational> {
        let is_shape = |name: &&str| self.variable(name).is_some_and(|v| !self.is_domain_variable(v));
        let help = if self.subject == Subject::Family && expr.names().iter().all(is_shape) {
            "a family has one formula for all values of its shape parameters: write one family for each part of the range, such as `shape 0 <= λ <= 1/2;` and `shape 1/2 <= λ <= 1;`"
        } else {
            "on parts of the domain a function is given in spans, `domain 0 <= t <= 1/2, 1/2 <= t <= 1; b[0] = 1 - t | t;`"
        };
        self.number_or(expr, &format!("an argument of `{function}`"), help)
    }

    /// The whole number that an expression is; reports anything else.
    pub(crate) fn whole(&mut self, expr: &Expr, what: &str) -> Option<i64> {
        self.whole_or(expr, what, None)
    }

    /// The same, with what to write instead of what is no number.
    pub(crate) fn whole_or(&mut self, expr: &Expr, what: &str, help: Option<&str>) -> Option<i64> {
        let counts = core::mem::replace(&mut self.counts, true);
        let value = match help {
            Some(help) => self.number_or(expr, what, help),
            None => self.number(expr, what),
        };
        self.counts = counts;
        let value = value?;
        match value.to_i64() {
            Some(n) => Some(n),
            None => {
                let message = format!("{what} must be a whole number, but is {value}");
                self.report(self.error(expr.span, message).help("write a whole number, such as 2"));
                None
            }
        }
    }

    /// The first and last value that a generator runs over.
    pub(crate) fn bounds(&mut self, generator: &IndexRange) -> Option<(i64, i64)> {
        let low = self.end_of_loop(&generator.low, "the first value of an index")?;
        let high = self.end_of_loop(&generator.high, "the last value of an index")?;
        let last = if generator.inclusive { high } else { high.checked_sub(1)? };
        Some((low, last))
    }

    /// One of them; of a shape parameter, with what to declare in its place.
    fn end_of_loop(&mut self, expr: &Expr, what: &str) -> Option<i64> {
        let is_shape = |name: &&str| self.variable(name).is_some_and(|v| !self.is_domain_variable(v));
        let shape = expr.names().into_iter().find(is_shape).filter(|_| self.subject == Subject::Family);
        let help = shape.map(|name| {
            format!(
                "`{name}` is a shape parameter, which has all values of its range; whole numbers belong to an index parameter, `family F({name} in 1..=3)`"
            )
        });
        self.whole_or(expr, what, help.as_deref())
    }

    /// Whether an expression mentions a function, a variable, or another family: anything that can vary.
    pub(crate) fn mentions_variable(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Number(_) => false,
            ExprKind::Name(name) => self.constant(name).is_none() && !BUILTINS.contains(&name.as_str()),
            ExprKind::Neg(inner) | ExprKind::Each(inner, _) => self.mentions_variable(inner),
            ExprKind::Sum(parts) => parts.iter().any(|(_, e)| self.mentions_variable(e)),
            ExprKind::Product(parts) => parts.iter().any(|(_, e)| self.mentions_variable(e)),
            ExprKind::Power(base, exponent) => {
                self.mentions_variable(base) || self.mentions_variable(exponent)
            }
            // An integral of numbers is about the domain.
            ExprKind::Call(base, _) if matches!(&base.kind, ExprKind::Name(name) if name == "integral") => {
                true
            }
            ExprKind::Index(base, rest) | ExprKind::Call(base, rest) => {
                self.mentions_variable(base) || rest.iter().any(|e| self.mentions_variable(e))
            }
            ExprKind::List(parts) | ExprKind::Tuple(parts) => parts.iter().any(|e| self.mentions_variable(e)),
        }
    }
}

/// The factor of the usual work that `budget …;` allows.
pub(crate) fn budget_value(scope: &mut Scope<'_>, value: &Expr) -> Option<u32> {
    if let n @ 1..=10_000 = scope.whole(value, "the budget")? {
        return Some(n as u32);
    }
    let error = scope.error(value.span, "the budget is from 1 to 10000");
    scope.report(error.help("`budget 10;` allows ten times the usual work"));
    None
}

/// A range from its ends as they are written, with what to write instead of an end that is no number; the name is for
/// messages.
pub(crate) fn range_of(
    scope: &mut Scope<'_>,
    span: Span,
    (low, high): (Option<&Limit>, Option<&Limit>),
    instead: Option<&str>,
    name: &dyn Fn() -> String,
) -> Option<Range> {
    let end = |scope: &mut Scope<'_>, end: Option<&Limit>| match end {
        None => Some(End::Infinite),
        Some(Limit { value, included }) => {
            const END: &str = "the end of a range";
            let value = match instead {
                Some(help) => scope.number_or(value, END, help)?,
                None => scope.number(value, END)?,
            };
            Some(if *included { End::Included(value) } else { End::Excluded(value) })
        }
    };
    let (low, high) = (end(scope, low), end(scope, high));
    let range = Range { low: low?, high: high? };
    checked_range(scope, span, range, name)
}

/// A range with points; of one without any that is reported.
pub(crate) fn checked_range(
    scope: &Scope<'_>,
    span: Span,
    range: Range,
    name: &dyn Fn() -> String,
) -> Option<Range> {
    if !range.is_empty() {
        return Some(range);
    }
    let name = name();
    let error = scope.error(span, format!("the range of `{name}` is empty"));
    let reversed = range.finite().is_some_and(|(a, b)| a > b);
    scope.report(match range.finite() {
        Some((a, b)) if reversed => error
            .label(format!("{a} is above {b}"))
            .help(format!("write the smaller end first: `{b} <= {name} <= {a}`")),
        Some((a, _)) => {
            error.label(format!("its ends are both {a}")).help("let its ends differ, or belong to it: `<=`")
        }
        None => error.help("let its ends differ, or belong to it: `<=`"),
    });
    None
}
