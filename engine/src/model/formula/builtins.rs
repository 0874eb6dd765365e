//! Sums and products of lists, and functions of whole numbers.

use proc_macro2::Span;

use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::number::binomial;
use crate::algebra::rational::Rational;
use crate::model::formula::print::Printer;
use crate::model::scope::Scope;
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::Listed;

/// factorial and binomial of larger numbers are refused.
const MAX_FACTORIAL: i64 = 500;

impl Scope<'_> {
    /// The value of a function of the language.
    pub(super) fn builtin(&mut self, name: &str, arguments: &[Expr], span: Span) -> Option<Value> {
        let constant = |value: Rational| Some(Value::Scalar(Fraction::constant(value)));
        match (name, arguments) {
            ("sum" | "product", [one]) => {
                let list = match &one.kind {
                    ExprKind::Each(body, loops) => self.collect(body, loops)?,
                    _ => match self.value(one)? {
                        Value::List(list) => list.into_iter().map(|(_, f)| f).listed(),
                        Value::Scalar(f) => vec![f],
                    },
                };
                let mut result =
                    Fraction::constant(if name == "sum" { Rational::ZERO } else { Rational::ONE });
                for f in &list {
                    let next =
                        if name == "sum" { self.budget.add(&result, f) } else { self.budget.mul(&result, f) };
                    result = self.fits(next, span)?;
                }
                Some(Value::Scalar(result))
            }
            ("binomial", [n, k]) => {
                let (n, k) = (
                    self.whole(n, "the first argument of `binomial`")?,
                    self.whole(k, "the second argument of `binomial`")?,
                );
                if !(0..=MAX_FACTORIAL).contains(&n) {
                    self.report(
                        self.error(span, format!("binomial({n}, {k}) is not computed"))
                            .help(format!("the first argument is from 0 to {MAX_FACTORIAL}")),
                    );
                    return None;
                }
                constant(u32::try_from(k).map_or(Rational::ZERO, |k| binomial(n as u32, k)))
            }
            ("factorial", [n]) => {
                let n = self.whole(n, "the argument of `factorial`")?;
                if !(0..=MAX_FACTORIAL).contains(&n) {
                    self.report(
                        self.error(span, format!("factorial({n}) is not computed"))
                            .help(format!("the argument is from 0 to {MAX_FACTORIAL}")),
                    );
                    return None;
                }
                constant((1..=n).fold(Rational::ONE, |p, k| &p * &Rational::from(k)))
            }
            ("floor", [x]) => {
                let x = self.compared_number(x, "floor")?;
                constant(x.floor())
            }
            ("ceil", [x]) => {
                let x = self.compared_number(x, "ceil")?;
                constant(-(-x).floor())
            }
            ("min" | "max", [x, y]) => {
                let (x, y) = (self.compared_number(x, name)?, self.compared_number(y, name)?);
                constant(if name == "min" { x.min(y) } else { x.max(y) })
            }
            _ => {
                let usage = match name {
                    "sum" | "product" => format!("{name}(t^i for i in 0..=n)"),
                    "binomial" => String::from("binomial(n, i)"),
                    "min" | "max" => format!("{name}(i, j)"),
                    _ => format!("{name}(n)"),
                };
                let error = self.error(span, format!("wrong number of arguments for `{name}`"));
                let printer = Printer { constants: &[], component: None };
                self.report(error.help(match (name, arguments) {
                    // As other systems have it.
                    ("sum" | "product", [x, Expr { kind: ExprKind::Name(i), .. }, low, high]) => {
                        let [x, low, high] = [x, low, high].map(|part| printer.print(part));
                        format!("write `{name}({x} for {i} in {low}..={high})`")
                    }
                    ("min" | "max", [_]) => format!(
                        "`{usage}` compares two numbers; that a function is nowhere larger is an inequality, `b[0] <= 1`"
                    ),
                    _ => format!("write `{usage}`"),
                }));
                None
            }
        }
    }
}
