//! From an expression to the exact function that it denotes.

use proc_macro2::Span;

use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::budget::TooLarge;
use crate::model::formula::print::Printer;
use crate::model::label;
use crate::model::scope::{Duty, Needed, Pending, Scope, Stage};
use crate::model::words::{BUILTINS, PI, is_transcendental};
use crate::plural::count;
use crate::syntax::{Expr, ExprKind, Loops, Role, Sign};
use basis_prover::collections::list::{Listed, Mapped};

impl Scope<'_> {
    /// The one function that an expression is; reports a list.
    pub(crate) fn scalar(&mut self, expr: &Expr) -> Option<Fraction> {
        match self.value(expr)? {
            Value::Scalar(value) => Some(value),
            Value::List(list) => {
                let error =
                    self.error(expr.span, format!("expected one function, found a list of {}", list.len()));
                let first = list.first().map_or(&[][..], |(index, _)| index);
                let part = match &expr.kind {
                    ExprKind::Name(name) => Some(name),
                    // Of a product the factor that is a list of shape parameters.
                    ExprKind::Product(parts) => parts.iter().find_map(|(_, part)| match &part.kind {
                        ExprKind::Name(name) if self.is_list_of_shapes(name) => Some(name),
                        _ => None,
                    }),
                    _ => None,
                };
                self.report(match &expr.kind {
                    _ if part.is_some() => {
                        let entry = part.map(|name| label(name, first)).unwrap_or_default();
                        error.help(format!("pick one of them with an index, such as `{entry}`"))
                    }
                    // Brackets around a part of a formula, as papers have them.
                    ExprKind::Product(parts) if parts.iter().any(|(_, part)| is_bracketed(part)) => {
                        error.help("write parentheses, `(…)`: square brackets make a list")
                    }
                    _ if is_bracketed(expr) => {
                        error.help("write parentheses, `(…)`: square brackets make a list")
                    }
                    ExprKind::List(_) => error.help(
                        "a function has one value, and the entries of a list cannot be lists; write a function or a name for each entry, a matrix as one list, `m[3*i + j]`, or a family for each component",
                    ),
                    _ => error.help("pick one of them with an index, such as `b[0]`"),
                });
                None
            }
        }
    }

    /// What an expression denotes; `None` when that is reported as an error.
    pub(crate) fn value(&mut self, expr: &Expr) -> Option<Value> {
        self.fits(self.budget.step(1), expr.span)?;
        match &expr.kind {
            ExprKind::Number(n) => Some(Value::Scalar(Fraction::constant(n.clone()))),
            ExprKind::Name(name) => self.named(name, expr.span),
            ExprKind::Neg(inner) => Some(map(self.value(inner)?, |f| -f)),
            ExprKind::Sum(parts) => {
                let mut sum: Option<Value> = None;
                for (sign, part) in parts {
                    let value = self.value(part)?;
                    sum = Some(match sum {
                        None => value,
                        Some(sum) => self.zip(sum, value, part.span, |b, x, y| {
                            if *sign == Sign::Minus { b.sub(x, y) } else { b.add(x, y) }
                        })?,
                    });
                }
                sum
            }
            ExprKind::Product(parts) => self.whole_product(parts),
            ExprKind::Power(base, exponent) => {
                let (power, is_inverse) = self.power(base, exponent, expr.span)?;
                if !is_inverse {
                    return Some(Value::Scalar(power));
                }
                let one = Fraction::constant(Rational::ONE);
                Some(Value::Scalar(self.divided(&one, &power, base.span)?))
            }
            ExprKind::Index(base, indices) => self.indexed(base, indices, expr.span),
            ExprKind::Call(callee, arguments) => self.call(callee, arguments, None, expr.span),
            ExprKind::List(parts) => {
                let mut list = Vec::new();
                for (k, part) in parts.iter().enumerate() {
                    list.push((vec![k as i64], self.scalar(part)?));
                }
                Some(Value::List(list))
            }
            ExprKind::Tuple(_) => {
                let error = self.error(expr.span, "points have no meaning in a family");
                self.report(error.help(
                    "the values of functions are numbers: write a function for each component, `b[0, 0] = …; b[0, 1] = …;`; a list has square brackets, `[x, y]`",
                ));
                None
            }
            ExprKind::Each(body, loops) => {
                let list = self.collect(body, loops)?;
                Some(Value::List(list.into_iter().enumerate().map(|(k, f)| (vec![k as i64], f)).listed()))
            }
        }
    }

    /// Passes on a result, or reports that a formula is too large.
    pub(crate) fn fits<T>(&self, result: Result<T, TooLarge>, span: Span) -> Option<T> {
        self.within(result, span, "lower the degree or the number of parameters")
    }

    /// The values of an expression for all values of index variables.
    pub(super) fn collect(&mut self, body: &Expr, loops: &Loops) -> Option<Vec<Fraction>> {
        let mut list = Vec::new();
        let fine = self.each(loops, &mut |scope| match scope.scalar(body) {
            Some(value) => {
                list.push(value);
                true
            }
            None => false,
        });
        fine.then_some(list)
    }

    fn named(&mut self, name: &str, span: Span) -> Option<Value> {
        if let Some((_, value)) = self.arguments.iter().find(|(n, _)| n == name) {
            return self.copy(value, span);
        }
        if let Some(value) = self.constant(name) {
            return Some(Value::Scalar(Fraction::constant(Rational::from(value))));
        }
        if let Some(value) = self.lets.named(name) {
            return self.copy(value.as_ref()?, span);
        }
        if let (Some(planned), None) = (self.planned.named(name), self.variable(name)) {
            if let Some(first) = planned.parameters.first() {
                let error = self
                    .error(span, format!("`{name}` needs {}", count(planned.parameters.len(), "argument")));
                self.report(error.help(format!("write `{name}({})`", first.text)));
            } else if self.waits_for.is_none() {
                self.waits_for = Some((Needed::Name(name.to_string()), span));
            }
            return None;
        }
        if let Some(pi) = self.analytic.pi.filter(|_| PI.contains(&name) && self.variable(name).is_none()) {
            return Some(Value::Scalar(Fraction::var(pi)));
        }
        if let Some(var) = self.variable(name) {
            if let Some(angle) =
                self.analytic.angles.iter().find(|a| a.itself == var && a.kind == Kind::Linear)
            {
                return Some(Value::Scalar(angle.tangent()));
            }
            let last = self.last_of(var).map(|simplex| self.last_coordinate(simplex));
            return Some(Value::Scalar(last.unwrap_or_else(|| Fraction::var(var))));
        }
        if let Some((_, value)) = self.determined.iter().find(|(n, _)| n == name) {
            return self.copy(&Value::Scalar(value.clone()), span);
        }
        if self.is_list_of_shapes(name) {
            return Some(Value::List(self.shapes_of(name)));
        }
        if name == self.function_name && !name.is_empty() {
            if let Some(index) = self.planned_functions.keys().next() {
                self.waits_for = Some((Needed::Function(index.clone()), span));
                return None;
            }
            if self.stage == Stage::Defining && (self.functions.is_empty() || self.missing_is_zero) {
                let error = self.error(
                    span,
                    format!("`{name}` alone means all functions, which are not all defined yet"),
                );
                self.report(error.help(format!("use one that is defined before, such as `{name}[0]`")));
                return None;
            }
            let mut list = Vec::new();
            for (index, value) in &self.functions {
                let value = value.as_ref()?;
                self.fits(self.budget.copy(value), span)?;
                list.push((index.clone(), value.clone()));
            }
            return Some(Value::List(list));
        }
        if BUILTINS.contains(&name) || is_transcendental(name) {
            if self.is_mistaken(name) {
                return None;
            }
            let error = self.error(span, format!("`{name}` needs arguments"));
            self.report(error.help(format!("write `{name}(…)`")));
            return None;
        }
        if self.library.knows(self.unit, name) {
            return self.family(name, &[], &[], None, None, span);
        }
        self.unknown(name, span);
        None
    }

    /// Applies an operation to two functions, or to the members of two lists of one length.
    fn zip(
        &self,
        a: Value,
        b: Value,
        span: Span,
        with: impl Fn(&crate::model::budget::Budget, &Fraction, &Fraction) -> Result<Fraction, TooLarge>,
    ) -> Option<Value> {
        match (a, b) {
            (Value::Scalar(x), Value::Scalar(y)) => {
                Some(Value::Scalar(self.fits(with(&self.budget, &x, &y), span)?))
            }
            (Value::List(x), Value::List(y)) if x.len() == y.len() => {
                let mut list = Vec::new();
                for ((index, p), (_, q)) in x.into_iter().zip(y) {
                    list.push((index, self.fits(with(&self.budget, &p, &q), span)?));
                }
                Some(Value::List(list))
            }
            (Value::List(x), Value::List(y)) => {
                let message = format!("lists of {} and {} functions cannot be combined", x.len(), y.len());
                self.report(self.error(span, message).help("write lists with as many entries"));
                None
            }
            _ => {
                let error = self.error(span, "a list and a single function cannot be added");
                self.report(error.help("pick one entry of the list, such as `b[0]` or `y[0]`"));
                None
            }
        }
    }

    fn product(&self, a: Value, b: Value, span: Span) -> Option<Value> {
        match (a, b) {
            (Value::List(_), Value::List(_)) => {
                self.report(
                    self.error(span, "two lists cannot be multiplied")
                        .help("multiply single functions, such as `b[0]*b[1]`, those of families `Bernstein(2)[i](u)*Bernstein(3)[j](v)`"),
                );
                None
            }
            (Value::List(list), Value::Scalar(factor)) | (Value::Scalar(factor), Value::List(list)) => {
                let mut result = Vec::new();
                for (index, f) in list {
                    result.push((index, self.fits(self.budget.mul(&f, &factor), span)?));
                }
                Some(Value::List(result))
            }
            (Value::Scalar(x), Value::Scalar(y)) => {
                Some(Value::Scalar(self.fits(self.budget.mul(&x, &y), span)?))
            }
        }
    }

    /// A product and quotient, in lowest terms as a whole: only what is left below the fraction line in the end must not
    /// vanish, so that `x^(i - 1)*y` is fine for i = 0 where y is a multiple of x.
    fn whole_product(&mut self, parts: &[(Role, Expr)]) -> Option<Value> {
        let mut product: Option<Value> = None;
        let mut divisors: Vec<(Fraction, Span)> = Vec::new();
        for (role, part) in parts {
            let (value, is_inverse, span) = match &part.kind {
                ExprKind::Power(base, exponent) => {
                    let (power, is_inverse) = self.power(base, exponent, part.span)?;
                    (Value::Scalar(power), is_inverse, base.span)
                }
                _ => (self.value(part)?, false, part.span),
            };
            let by = |product: Option<Value>| {
                product.unwrap_or_else(|| Value::Scalar(Fraction::constant(Rational::ONE)))
            };
            if is_inverse == (*role == Role::Divisor) {
                product = Some(match product {
                    None => value,
                    Some(product) => self.product(product, value, part.span)?,
                });
                continue;
            }
            let span = if is_inverse { span } else { part.span };
            let Value::Scalar(divisor) = value else {
                self.report(self.error(part.span, "a list cannot be a denominator"));
                return None;
            };
            if !is_inverse {
                self.check_divisor(&divisor, span)?;
            }
            product = Some(match by(product) {
                Value::Scalar(f) => Value::Scalar(self.fits(self.budget.div(&f, &divisor), span)?),
                Value::List(list) => {
                    let mut result = Vec::new();
                    for (index, f) in list {
                        result.push((index, self.fits(self.budget.div(&f, &divisor), span)?));
                    }
                    Value::List(result)
                }
            });
            if self.is_over_domain(&divisor) {
                divisors.push((divisor, span));
            }
        }
        let whole = product.as_ref()?;
        let values = match whole {
            Value::Scalar(f) => vec![f],
            Value::List(list) => list.iter().map(|(_, f)| f).listed(),
        };
        if let Some((_, first)) = divisors.first() {
            for f in values.into_iter().filter(|f| f.denom().as_constant().is_none()) {
                // Where one of several divisors is what is left.
                let own = |d: &Fraction| d.numer().div_exact(f.denom()).is_some();
                let span = divisors.iter().find(|(d, _)| own(d)).map_or(*first, |(_, span)| *span);
                self.must_be_defined(f, span);
            }
        }
        product
    }

    /// A quotient in lowest terms, by a divisor that is checked: what a domain variable leaves below the fraction line
    /// must not vanish.
    fn divided(&mut self, f: &Fraction, divisor: &Fraction, span: Span) -> Option<Fraction> {
        let quotient = self.fits(self.budget.div(f, divisor), span)?;
        if self.is_over_domain(divisor) {
            self.must_be_defined(&quotient, span);
        }
        Some(quotient)
    }

    /// Notes that what stands below the fraction line of a function must not vanish.
    pub(crate) fn must_be_defined(&mut self, f: &Fraction, span: Span) {
        if f.denom().as_constant().is_none() {
            let place = self.place(span);
            self.pending.push(Pending { duty: Duty::Nonzero(f.denom().clone()), place });
        }
    }

    /// A divisor is not zero. Of shape parameters alone it must not vanish on their ranges, which is proved later; with
    /// domain variables in it that is said of what is left in lowest terms.
    pub(crate) fn check_divisor(&mut self, divisor: &Fraction, span: Span) -> Option<()> {
        if divisor.is_zero() {
            self.report(self.error(span, "division by zero"));
            return None;
        }
        if divisor.as_constant().is_none() && !self.is_over_domain(divisor) {
            let place = self.place(span);
            self.pending.push(Pending { duty: Duty::Nonzero(divisor.numer().clone()), place });
        }
        Some(())
    }

    /// A power with the exponent without its sign, and whether that is negative; the base of such a power is checked.
    fn power(&mut self, base: &Expr, exponent: &Expr, span: Span) -> Option<(Fraction, bool)> {
        let value = self.scalar(base)?;
        let Some(e) = self.scalar(exponent)?.as_constant() else {
            let error =
                self.error(exponent.span, "the exponent contains a variable: this is not a polynomial");
            self.report(error.help("exponents are whole numbers, made of digits and index parameters; the exponential is `exp(t)`"));
            return None;
        };
        if !e.is_integer() {
            let error = self.error(
                exponent.span,
                format!("the exponent {e} is not a whole number: this is not a polynomial"),
            );
            let named = match &base.kind {
                ExprKind::Name(name) if self.is_over_domain(&value) => Some(name.as_str()),
                _ => None,
            };
            // Of t^(3/2) with t = s^2.
            let roots = e.denom().to_string();
            self.report(error.help(match named {
                Some(name) => format!(
                    "roots are not in the language: put {name} = s^{roots} and let s be the variable of the domain, `domain 0 <= s <= 1`; then {name}^(1/{roots}) is s"
                ),
                None => String::from(
                    "exponents are whole numbers: claim something about the power without the root, or let the root be a shape parameter",
                ),
            }));
            return None;
        }
        let magnitude = e.abs().to_i64().and_then(|n| u32::try_from(n).ok());
        let Some(magnitude) = magnitude else {
            self.report(self.error(exponent.span, "the exponent is too large"));
            return None;
        };
        if e.is_negative() {
            self.check_divisor(&value, base.span)?;
        }
        let power = self.fits(self.budget.pow(&value, magnitude), span)?;
        Some((power, e.is_negative()))
    }

    /// Reports an order in square brackets, as in `Bernstein[3,1]`.
    fn without_order(&self, name: &str, (orders, index): (&[Expr], &[Expr]), span: Span) {
        let print = |e: &Expr| Printer { constants: &self.constants, component: None }.print(e);
        let list = |all: &[Expr]| all.mapped(print).join(", ");
        let error = self.error(span, format!("`{name}` stands without its order"));
        self.report(error.help(format!("write `{name}({})[{}]`", list(orders), list(index))));
    }

    fn indexed(&mut self, base: &Expr, indices: &[Expr], span: Span) -> Option<Value> {
        if let ExprKind::Name(name) = &base.kind
            && (BUILTINS.contains(&name.as_str()) || is_transcendental(name))
        {
            let error = self.error(span, format!("`{name}` is a function, not a list"));
            self.report(error.help(format!("write its argument in round brackets, `{name}(…)`")));
            return None;
        }
        if let ExprKind::Name(name) = &base.kind
            && self.is_capitalised(name)
        {
            self.unknown_function(name, base.span);
            return None;
        }
        if let ExprKind::Name(name) = &base.kind
            && *name != self.function_name
            && self.taken(name).is_none()
            && let orders = self.library.order_count(self.unit, name)
            && orders > 0
            && indices.len() > orders
        {
            self.without_order(name, indices.split_at(orders), base.span);
            return None;
        }
        let mut index = Vec::new();
        let help = match &base.kind {
            ExprKind::Name(name) => format!(
                "an index is a whole number, `{name}[0]`, or an index variable, `{name}[i]` with `for i in 0..=3`; an argument stands in round brackets, `{name}[0](t)`"
            ),
            _ => String::from("an index is a whole number or an index variable, `for i in 0..=3`"),
        };
        for i in indices {
            index.push(self.whole_or(i, "an index", Some(&help))?);
        }
        if let ExprKind::Name(name) = &base.kind
            && *name == self.function_name
        {
            if let Some(value) = self.functions.get(&index) {
                let value = value.as_ref()?;
                self.fits(self.budget.copy(value), span)?;
                return Some(Value::Scalar(value.clone()));
            }
            if self.planned_functions.contains_key(&index) {
                self.waits_for = Some((Needed::Function(index), span));
                return None;
            }
            if self.missing_is_zero {
                let Some((message, help)) = gap(self, &index) else {
                    return Some(Value::Scalar(Fraction::zero()));
                };
                self.report(self.error(span, message).help(help));
                return None;
            }
            // It may be one whose definition went wrong.
            if self.cut_short {
                return None;
            }
            let wanted = label(name, &index);
            let error = self.error(span, format!("there is no function `{wanted}`"));
            // While they are defined, those that are to come are among them, but of a recursion there may be others.
            let mut known = self.defined.keys().listed();
            if self.stage != Stage::Defining {
                known = self.functions.keys().listed();
            }
            let known = known.first().filter(|_| self.base.is_empty()).map(|first| (*first, known.last()));
            self.report(match known {
                Some((first, last)) => {
                    let last = label(name, last.unwrap_or(&first));
                    error.help(if first.len() == index.len() {
                        format!("the last one is `{last}`")
                    } else {
                        format!(
                            "the functions have {}: from `{}` to `{last}`",
                            crate::plural::indices(first.len()),
                            label(name, first)
                        )
                    })
                }
                None => error.help("a formula may use functions that are defined before it"),
            });
            return None;
        }
        if let ExprKind::Name(name) = &base.kind
            && self.arguments.iter().all(|(n, _)| n != name)
            && self.is_list_of_shapes(name)
        {
            let all = self.shapes_of(name);
            if let Some((_, value)) = all.iter().find(|(i, _)| *i == index) {
                return Some(Value::Scalar(value.clone()));
            }
            self.no_such_shape(name, &label(name, &index), span);
            return None;
        }
        let value = match &base.kind {
            ExprKind::Call(callee, arguments) => self.call(callee, arguments, Some(&index), base.span)?,
            _ => self.value(base)?,
        };
        if let Value::Scalar(_) = value {
            let name = if let ExprKind::Name(name) = &base.kind { Some(name) } else { None };
            let error = match name {
                Some(name) if self.is_mistaken(name) => return None,
                Some(name) if self.variable(name).is_some_and(|v| !self.domain.contains(&v)) => self
                    .error(base.span, format!("`{name}` has no index"))
                    .help(format!("several shape parameters are declared with one: `shape 0 <= {name}[i] <= 1 for i in 0..=2;`")),
                Some(name) => self.error(base.span, format!("`{name}` has no index: it is a single expression")),
                None => self.error(base.span, "this has no index: it is a single function"),
            };
            self.report(error);
            return None;
        }
        self.entry(&value, &index, span)
    }

    /// The entry of a list that has an index.
    pub(crate) fn entry(&self, value: &Value, index: &[i64], span: Span) -> Option<Value> {
        let Value::List(list) = value else { return None };
        if let Some((_, value)) = list.iter().find(|(i, _)| i == index) {
            return Some(Value::Scalar(value.clone()));
        }
        let shown: Vec<String> = index.mapped(i64::to_string);
        let message = format!("the index {} is outside of a list of {}", shown.join(","), list.len());
        self.report(self.error(span, message).help(match (list.first(), list.last()) {
            (_, Some((last, _))) if last.len() == 1 && index.len() == 1 => {
                format!("indices run from 0 to {}", last[0])
            }
            (Some((first, _)), _) if first.len() != index.len() => {
                format!("an index has {} here, such as `{}`", count(first.len(), "place"), label("", first))
            }
            (Some((first, _)), _) => format!("the first index is `{}`", label("", first)),
            _ => String::from("the list is empty"),
        }));
        None
    }
}

fn map(value: Value, with: impl Fn(&Fraction) -> Fraction) -> Value {
    match value {
        Value::Scalar(f) => Value::Scalar(with(&f)),
        Value::List(list) => Value::List(list.into_iter().map(|(i, f)| (i, with(&f))).listed()),
    }
}

/// What is wrong with a function that the recursion reads and that does not exist; `None` when it lies outside of the
/// order before, which has no gap and whose functions are 0 elsewhere.
fn gap(scope: &Scope<'_>, index: &[i64]) -> Option<(String, &'static str)> {
    if index.iter().any(|i| *i < 0) {
        return None;
    }
    let other = scope.functions.keys().next()?;
    let places = scope.index_places(index.len());
    let sums = places.into_iter().filter(|own| own.len() > 1).map(|own| {
        let sum = |index: &[i64]| index[own.clone()].iter().sum::<i64>();
        (sum(index), sum(other))
    });
    let (sum, before) = { sums }.find(|(sum, before)| sum != before)?;
    let wanted = label(&scope.function_name, index);
    Some((
        format!("the indices of `{wanted}` sum to {sum}, those of the order before to {before}"),
        "lower one index by one in every term: `b[i-1,j,k]`, `b[i,j-1,k]`, `b[i,j,k-1]`",
    ))
}

/// Whether an expression is a list of one entry, as square brackets around a part of a formula make it.
fn is_bracketed(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::List(entries) if entries.len() == 1)
}
