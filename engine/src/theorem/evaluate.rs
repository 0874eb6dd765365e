//! From an expression of a theorem to the scalar, vector or outer product that it denotes.

use basis_prover::collections::list::Listed;
use proc_macro2::Span;

use super::draft::{Elaboration, Value, kind};
use super::form::{Form, Unit};
use crate::advice::did_you_mean;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::ascii;
use crate::model::formula::print::Printer;
use crate::model::words::BUILTINS;
use crate::plural::here;
use crate::syntax::{Expr, ExprKind, Role, Sign, TheoremKind};

/// The functions of theorems that families do not have.
const PRODUCTS: [&str; 2] = ["cross", "dot"];

/// What an outer product becomes with coordinates.
const OUTER: &str = "with `dimension 2;` a product `cross(a, b)` is a number, with `dimension 3;` a vector";

/// What to write for the functions of the field that the language does not have.
fn elsewhere(name: &str) -> Option<&'static str> {
    Some(match name {
        "norm" | "length" | "len" | "abs" | "magnitude" | "mag" | "dist" | "distance" | "normsq" => {
            "lengths are compared by their squares: `dot(a, a)`"
        }
        "sqrt" | "root" => "a claim about a root is one about its square",
        "normalize" | "normalized" | "unit" | "direction" | "tangent" => {
            "directions are compared by `a parallel b`, the same direction and the same sense"
        }
        "normal" => "the normal of a surface has the direction of `cross(D(S, u)(u, v), D(S, v)(u, v))`",
        "curvature" | "kappa" => {
            "curvatures are compared by `cross(D(P)(t), D(P, 2)(t))`, at the same speed, or by `dot(…, …)` of these"
        }
        "det" | "wedge" | "outer" | "vec" => {
            "write `cross(a, b)`: the determinant in the plane, a vector in space, an outer product without coordinates; `dot(cross(a, b), c)` is the determinant in space"
        }
        "inner" | "scalar_product" => "write `dot(a, b)`",
        "angle" => "angles are compared by `dot` and `cross`, or by `parallel`",
        "diff" | "derivative" | "deriv" | "dd" | "d" | "grad" | "Diff" => {
            "write `D(P)(0)` for a derivative at 0, `D(P, 2)(0)` for the second, `D(S, u)(0, v)` of a surface"
        }
        "sin" | "cos" | "tan" | "exp" | "log" | "ln" | "sinh" | "cosh" => {
            "scalars are rational functions; with `scalar r;` the point `((1 - r^2)/(1 + r^2), 2*r/(1 + r^2))` runs over the circle"
        }
        "pi" | "π" => "numbers are rational: write a fraction such as 22/7",
        "C" | "choose" | "binom" | "nCr" => "write `binomial(n, i)`",
        "infinity" | "inf" => "leave the end of the range out: `scalar 0 < c;` has no upper end",
        _ => return None,
    })
}

impl Elaboration<'_> {
    /// What an expression denotes; `None` when that is reported as an error.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<Value> {
        // Names are looked for one after the other.
        let names = self.scope.names.len() + self.vectors.len() + self.patches.len();
        self.fits(self.scope.budget.step(1 + names as u64 / 32), expr.span)?;
        match &expr.kind {
            ExprKind::Number(n) => Some(Value::Scalar(Fraction::constant(n.clone()))),
            ExprKind::Name(name) => self.named(name, expr.span),
            ExprKind::Neg(inner) => {
                let value = self.definite(inner)?;
                self.scaled(value, &Fraction::constant(-&Rational::ONE), inner.span)
            }
            ExprKind::Sum(parts) => {
                let mut sum: Option<Value> = None;
                for (sign, part) in parts {
                    let value = self.definite(part)?;
                    sum = Some(match sum {
                        None => value,
                        Some(sum) => self.add(sum, value, *sign, part.span)?,
                    });
                }
                sum
            }
            ExprKind::Product(parts) => {
                let mut product: Option<Value> = None;
                for (role, part) in parts {
                    let value = self.definite(part)?;
                    product = Some(match product {
                        None => value,
                        Some(product) if *role == Role::Divisor => {
                            self.quotient(product, &value, part.span)?
                        }
                        Some(product) => self.product(product, value, part.span)?,
                    });
                }
                product
            }
            ExprKind::Power(base, exponent) => self.power(base, exponent),
            ExprKind::Index(base, indices) => self.indexed(base, indices, expr),
            ExprKind::Call(callee, arguments) => self.call(callee, arguments, expr),
            ExprKind::Tuple(parts) => self.point(parts, expr.span),
            ExprKind::List(_) | ExprKind::Each(..) => {
                let error = self.scope.error(expr.span, "a list has no meaning here");
                self.scope.report(
                    error.help("write a point with round brackets, `(1, 2)`, several claims with `for`"),
                );
                None
            }
        }
    }

    /// What an expression denotes; reports a curve or surface without a parameter value.
    pub(super) fn definite(&mut self, expr: &Expr) -> Option<Value> {
        let value = self.value(expr)?;
        let Value::Map(patch, _) = &value else { return Some(value) };
        let printer = Printer { constants: &self.scope.constants, component: None };
        let patch = &self.patches[*patch];
        let names: Vec<&str> = patch.parameters.iter().chain(&patch.dependent).map(String::as_str).listed();
        let (shown, names) = (printer.print(expr), names.join(", "));
        let mut error = self.scope.error(expr.span, format!("`{shown}` needs a parameter value"));
        let order = match &expr.kind {
            ExprKind::Call(_, arguments) => match arguments.as_slice() {
                [curve, Expr { kind: ExprKind::Number(order), .. }] => Some((printer.print(curve), order)),
                _ => None,
            },
            _ => None,
        };
        self.scope.report(match order {
            Some((curve, order)) if *order == Rational::ZERO || *order == Rational::ONE => {
                error.message =
                    format!("`{shown}` is the derivative of order {order} without a parameter value");
                error.help(format!(
                    "write `D({curve})({order})` for the derivative at {names} = {order}, `D({curve}, 2)({order})` for the second"
                ))
            }
            _ => error.help(format!("write `{shown}({names})` for all of them, or numbers for one point")),
        });
        None
    }

    /// The scalar that an expression is; reports anything else.
    pub(super) fn scalar(&mut self, expr: &Expr) -> Option<Fraction> {
        match self.definite(expr)? {
            Value::Scalar(f) => Some(f),
            other => {
                let error = self.scope.error(expr.span, format!("expected a scalar, found {}", kind(&other)));
                self.scope.report(error.help(
                    "`dot(a, b)` and, in the plane, `cross(a, b)` are scalars; so are coordinates, `P(t)[0]`",
                ));
                None
            }
        }
    }

    /// The vector that an expression is; reports anything else.
    pub(super) fn vector(&mut self, expr: &Expr, what: &str) -> Option<Form> {
        match self.definite(expr)? {
            Value::Vector(form) => Some(form),
            other => {
                let error = self.scope.error(expr.span, format!("{what} is a point, found {}", kind(&other)));
                self.scope.report(
                    error.help("write coordinates, `(1, 2)`, or a combination of other control points"),
                );
                None
            }
        }
    }

    /// Notes that a parameter of a patch occurs in the theorem.
    pub(super) fn mention(&mut self, var: Var) {
        if let Some(parameter) = self.implicit.iter_mut().find(|p| p.var == var) {
            parameter.mentioned = true;
        }
    }

    fn named(&mut self, name: &str, span: Span) -> Option<Value> {
        if let Some(value) = self.scope.constant(name) {
            return Some(Value::Scalar(Fraction::constant(Rational::from(value))));
        }
        if let Some(patch) = self.patches.iter().position(|p| p.name == name) {
            return Some(Value::Map(patch, Vec::new()));
        }
        if let Some((_, value)) = self.vectors.iter().find(|(n, _)| n == name) {
            return value.clone();
        }
        if let Some(value) = self.scope.lets.named(name) {
            let Some(crate::model::formula::Value::Scalar(value)) = value else { return None };
            self.fits(self.scope.budget.copy(value), span)?;
            let value = value.clone();
            for var in value.numer().variables() {
                self.mention(var);
            }
            return Some(Value::Scalar(value));
        }
        if let Some(var) = self.scope.variable(name) {
            self.mention(var);
            return Some(Value::Scalar(Fraction::var(var)));
        }
        if BUILTINS.contains(&name) || PRODUCTS.contains(&name) {
            let error = self.scope.error(span, format!("`{name}` needs arguments"));
            self.scope.report(error.help(format!("write `{name}(…)`")));
            return None;
        }
        self.unknown(name, span);
        None
    }

    /// Reports an unknown name, with the known name that it resembles; not while it could be that of a shape value.
    pub(super) fn unknown(&self, name: &str, span: Span) {
        if self.incomplete || self.scope.is_mistaken(name) {
            return;
        }
        let error = self.scope.error(span, format!("the name `{name}` is not declared"));
        if self.scope.is_full() {
            return self.scope.report(error);
        }
        self.scope.undeclared.borrow_mut().push(name.to_string());
        let family = name.split('[').next().unwrap_or(name);
        if self.scope.library.knows(self.scope.unit, family) {
            let order = if self.scope.library.order_count(self.scope.unit, family) == 1 { "(3)" } else { "" };
            self.scope.report(
                error
                    .label("this is a family")
                    .help(format!("a theorem speaks of its functions through curves: after `curve F = {family}{order};`, F(t) is their sum with control points `F[0]`, `F[1]`, …")),
            );
            return;
        }
        if let Some(help) = elsewhere(name) {
            self.scope.report(error.help(help));
            return;
        }
        // A name with an index, of which there are others, or the name alone.
        let (base, indexed) = name.split_once('[').map_or((name, false), |(base, _)| (base, true));
        let names = self.scope.names.iter().chain(self.scope.lets.keys()).map(String::as_str);
        let others = names.filter(|other| other.split_once('[').is_some_and(|(b, _)| b == base));
        // `c[10]` comes after `c[9]`.
        let last = others.max_by_key(|other| (other.len(), *other));
        if let Some(last) = last {
            let help = if indexed {
                format!("the last one is `{last}`")
            } else {
                format!("it has an index, such as `{last}`")
            };
            self.scope.report(error.help(help));
            return;
        }
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        if letters.len() < name.len() && self.patches.iter().any(|patch| patch.name == letters) {
            let help = format!("write `{letters}[{}]` for the control point", &name[letters.len()..]);
            self.scope.report(error.help(help));
            return;
        }
        let mut known: Vec<&str> = BUILTINS.iter().chain(&PRODUCTS).copied().listed();
        known.extend(self.scope.names.iter().map(String::as_str));
        known.extend(self.scope.constants.iter().map(|(n, _)| n.as_str()));
        known.extend(self.scope.lets.keys().map(String::as_str));
        known.extend(self.vectors.iter().map(|(n, _)| n.as_str()));
        known.extend(self.patches.iter().map(|p| p.name.as_str()));
        let declare = || match name.split_once('[') {
            Some((curve, _)) => {
                format!("declare it: `curve {curve} = …;` has control points, or `let {name} = …;`")
            }
            None => {
                format!("declare it: `scalar 0 < {name};`, `let {name} = …;` or `curve {name} = …;`")
            }
        };
        self.scope.report(error.help(did_you_mean(name, &known, &declare)));
    }

    /// (x, y): Σ coordinates times basis vectors.
    fn point(&mut self, parts: &[Expr], span: Span) -> Option<Value> {
        if self.dimension != Some(parts.len()) {
            let dimension = self.dimension.unwrap_or(0);
            let message = format!("this point has {} coordinates, points here have {dimension}", parts.len());
            let error = self.scope.error(span, message);
            self.scope.report(error.help("give all points of a theorem the same number of coordinates"));
            return None;
        }
        let mut form = Form::default();
        for (k, part) in parts.iter().enumerate() {
            let value = self.scalar(part)?;
            if !value.is_zero() {
                form.terms.insert(Unit::Point(k), value);
            }
        }
        Some(Value::Vector(form))
    }

    fn add(&self, a: Value, b: Value, sign: Sign, span: Span) -> Option<Value> {
        let budget = &self.scope.budget;
        match (a, b) {
            (Value::Scalar(x), Value::Scalar(y)) => {
                let sum = if sign == Sign::Minus { budget.sub(&x, &y) } else { budget.add(&x, &y) };
                Some(Value::Scalar(self.fits(sum, span)?))
            }
            (Value::Vector(x), Value::Vector(y)) => Some(Value::Vector(self.add_forms(x, &y, sign, span)?)),
            (Value::Outer(x), Value::Outer(y)) => Some(Value::Outer(self.add_forms(x, &y, sign, span)?)),
            (a, b) => {
                let (a, b) = (kind(&a), kind(&b));
                let verb = if sign == Sign::Minus { "subtracted from" } else { "added to" };
                let error = self.scope.error(span, format!("{b} cannot be {verb} {a}"));
                self.scope.report(error.help("both sides of a sum are scalars, or both are vectors"));
                None
            }
        }
    }

    fn add_forms(&self, mut a: Form, b: &Form, sign: Sign, span: Span) -> Option<Form> {
        let one = Fraction::constant(Rational::ONE);
        let done = a.add_scaled(b, &if sign == Sign::Minus { -&one } else { one }, &self.scope.budget);
        self.fits(done, span)?;
        Some(a)
    }

    /// A scalar times a value.
    fn scaled(&self, value: Value, factor: &Fraction, span: Span) -> Option<Value> {
        let budget = &self.scope.budget;
        match value {
            Value::Scalar(x) => Some(Value::Scalar(self.fits(budget.mul(&x, factor), span)?)),
            Value::Vector(form) => {
                Some(Value::Vector(self.fits(form.map(&mut |x| budget.mul(x, factor)), span)?))
            }
            Value::Outer(form) => {
                Some(Value::Outer(self.fits(form.map(&mut |x| budget.mul(x, factor)), span)?))
            }
            // Reported where the curve or surface stands.
            Value::Map(..) => None,
        }
    }

    fn product(&self, a: Value, b: Value, span: Span) -> Option<Value> {
        match (a, b) {
            (Value::Scalar(x), other) | (other, Value::Scalar(x)) => self.scaled(other, &x, span),
            (a, b) => {
                let error = self.scope.error(span, format!("{} times {} has no meaning", kind(&a), kind(&b)));
                self.scope.report(error.help("write `dot(a, b)` or `cross(a, b)`"));
                None
            }
        }
    }

    fn quotient(&mut self, a: Value, b: &Value, span: Span) -> Option<Value> {
        let Value::Scalar(divisor) = b else {
            let error = self.scope.error(span, format!("{} cannot be a denominator", kind(b)));
            self.scope.report(error.help("divide by a scalar; that vectors are multiples of one another is said by `a == f*b` or `a parallel b`"));
            return None;
        };
        self.scope.check_divisor(divisor, span)?;
        let one = Fraction::constant(Rational::ONE);
        let factor = self.fits(self.scope.budget.div(&one, divisor), span)?;
        self.scaled(a, &factor, span)
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Option<Value> {
        let value = match self.definite(base)? {
            Value::Scalar(x) => x,
            other => {
                let error = self.scope.error(base.span, format!("{} has no powers", kind(&other)));
                let help = match &other {
                    Value::Outer(_) => OUTER,
                    _ => "the square of a length is `dot(a, a)`",
                };
                self.scope.report(error.help(help));
                return None;
            }
        };
        let exponent_value = self.scope.whole(exponent, "an exponent")?;
        let Ok(magnitude) = u32::try_from(exponent_value.unsigned_abs()) else {
            self.scope.report(self.scope.error(exponent.span, "the exponent is too large"));
            return None;
        };
        let power = self.fits(self.scope.budget.pow(&value, magnitude), base.span)?;
        if exponent_value >= 0 {
            return Some(Value::Scalar(power));
        }
        let one = Value::Scalar(Fraction::constant(Rational::ONE));
        self.quotient(one, &Value::Scalar(power), base.span)
    }

    /// `P[1]` is a control point, `γ[1]` a scalar with an index, `P(t)[0]` a coordinate.
    fn indexed(&mut self, base: &Expr, indices: &[Expr], whole: &Expr) -> Option<Value> {
        if let ExprKind::Name(name) = &base.kind {
            if let Some(patch) = self.patches.iter().position(|p| p.name == *name) {
                let index = self.indices(indices)?;
                return Some(Value::Vector(self.control_point(patch, &index, whole.span)?));
            }
            if self.vectors.iter().all(|(n, _)| n != name) {
                let name = self.target_name(whole)?;
                return self.named(&name, whole.span);
            }
        }
        let form = match self.definite(base)? {
            Value::Vector(form) => form,
            other => {
                let error = self.scope.error(base.span, format!("{} has no coordinates", kind(&other)));
                self.scope.report(error.help(match other {
                    Value::Outer(_) if self.dimension.is_none() => {
                        "with `dimension 3;` at the beginning of a theorem it is a vector, with `dimension 2;` a scalar"
                    }
                    _ => "`P[1]` is a control point, `P(t)[0]` the first coordinate of a point",
                }));
                return None;
            }
        };
        let Some(dimension) = self.dimension else {
            let error = self.scope.error(whole.span, "points have no coordinates here");
            self.scope.report(error.help(match self.kind {
                TheoremKind::Theorem => "write `dimension 2;` at the beginning of the theorem",
                TheoremKind::Join => {
                    "a join is for points of any space: state this in a `theorem`, with `dimension 2;`"
                }
            }));
            return None;
        };
        let index = self.indices(indices)?;
        match index.as_slice() {
            [k] if usize::try_from(*k).is_ok_and(|k| k < dimension) => {
                Some(Value::Scalar(form.coefficient(Unit::Point(*k as usize))))
            }
            _ => {
                let error = self.scope.error(whole.span, format!("points have {dimension} coordinates"));
                self.scope.report(error.help(format!("the last one is `[{}]`", dimension - 1)));
                None
            }
        }
    }

    fn call(&mut self, callee: &Expr, arguments: &[Expr], whole: &Expr) -> Option<Value> {
        if let ExprKind::Name(name) = &callee.kind {
            match name.as_str() {
                "D" => return self.derivative(arguments, whole.span),
                "integral" => return self.integral(arguments, whole.span),
                "cross" | "dot" => return self.vector_product(name, arguments, whole.span),
                "sum" => return self.sum(arguments, whole.span),
                _ if BUILTINS.contains(&name.as_str()) => {
                    return self.scope.scalar(whole).map(Value::Scalar);
                }
                _ => {}
            }
        }
        if let ExprKind::Name(name) = &callee.kind
            && self.scope.constant(name).is_none()
            && self.taken(name).is_none()
            && !self.scope.library.knows(self.scope.unit, name)
            && elsewhere(name).is_none()
        {
            let functions: Vec<&str> = BUILTINS.iter().chain(&PRODUCTS).copied().listed();
            let curves = self.patches.iter().map(|p| p.name.as_str());
            let known: Vec<&str> = functions.iter().copied().chain(curves).listed();
            let help = did_you_mean(name, &known, &|| {
                if ascii::is_capitalised(name) {
                    return format!("declare it: `curve {name} = Bernstein(3);`");
                }
                format!(
                    "functions are `{}`, and curves and surfaces that are declared",
                    functions.join("`, `")
                )
            });
            if !self.scope.is_mistaken(name) {
                let error = self.scope.error(callee.span, format!("there is no function `{name}`"));
                self.scope.report(error.help(help));
                self.scope.undeclared.borrow_mut().push(name.clone());
            }
            return None;
        }
        match self.value(callee)? {
            Value::Map(patch, steps) => {
                self.apply(patch, &steps, callee, arguments, whole.span).map(Value::Vector)
            }
            other => {
                let error = self.scope.error(callee.span, format!("{} is not a function", kind(&other)));
                self.scope.report(error.help("write `*` between the factors of a product"));
                None
            }
        }
    }

    /// `sum(x for i in 0..=n)`.
    fn sum(&mut self, arguments: &[Expr], span: Span) -> Option<Value> {
        let [Expr { kind: ExprKind::Each(body, loops), .. }] = arguments else {
            let error = self.scope.error(span, "`sum` needs an expression with `for`");
            let printer = Printer { constants: &[], component: None };
            self.scope.report(error.help(match arguments {
                // As other systems have it.
                [x, Expr { kind: ExprKind::Name(i), .. }, low, high] => {
                    let [x, low, high] = [x, low, high].map(|part| printer.print(part));
                    format!("write `sum({x} for {i} in {low}..={high})`")
                }
                _ => String::from("write `sum(P[i] for i in 0..=3)`"),
            }));
            return None;
        };
        let mut total: Option<Value> = None;
        self.each(loops, &mut |all| {
            let value = all.value(body)?;
            total = Some(match total.take() {
                None => value,
                Some(sum) => all.add(sum, value, Sign::Plus, body.span)?,
            });
            Some(())
        })?;
        total
    }

    /// cross(a, b): a scalar in the plane, a vector in space, an outer product where points have no coordinates;
    /// dot(a, b) is a scalar.
    fn vector_product(&mut self, name: &str, arguments: &[Expr], span: Span) -> Option<Value> {
        let [a, b] = arguments else {
            let error =
                self.scope.error(span, format!("`{name}` has two arguments, {}", here(arguments.len())));
            self.scope.report(error.help(format!("write `{name}(a, b)`")));
            return None;
        };
        let (a, b) = (self.factor_vector(a, name)?, self.factor_vector(b, name)?);
        if name == "dot" {
            return self.dot(&a, &b, span).map(Value::Scalar);
        }
        let outer = self.fits(a.outer(&b, &self.scope.budget), span)?;
        let part = |p: usize, q: usize| outer.coefficient(Unit::Pair(p, q));
        Some(match self.dimension {
            Some(2) => Value::Scalar(part(0, 1)),
            Some(3) => {
                let mut form = Form::default();
                for (k, x) in [part(1, 2), -&part(0, 2), part(0, 1)].into_iter().enumerate() {
                    if !x.is_zero() {
                        form.terms.insert(Unit::Point(k), x);
                    }
                }
                Value::Vector(form)
            }
            _ => Value::Outer(outer),
        })
    }

    fn factor_vector(&mut self, expr: &Expr, name: &str) -> Option<Form> {
        match self.definite(expr)? {
            Value::Vector(form) => Some(form),
            other => {
                let error = self
                    .scope
                    .error(expr.span, format!("`{name}` multiplies two vectors, this is {}", kind(&other)));
                self.scope.report(match &other {
                    Value::Outer(_) => error.help(OUTER),
                    _ => error.help(format!(
                        "write `{name}(a, b)` with vectors, such as `D(P)(0)` or `P[1] - P[0]`"
                    )),
                });
                None
            }
        }
    }

    /// Σ aₚ·b_q ⟨p, q⟩; without coordinates the dot products of given points are variables.
    fn dot(&mut self, a: &Form, b: &Form, span: Span) -> Option<Fraction> {
        let mut sum = Fraction::zero();
        for (p, x) in &a.terms {
            for (q, y) in &b.terms {
                let (Unit::Point(p), Unit::Point(q)) = (*p, *q) else { continue };
                if self.dimension.is_some() && p != q {
                    continue;
                }
                let mut product = self.fits(self.scope.budget.mul(x, y), span)?;
                if self.dimension.is_none() {
                    let var = Fraction::var(self.dot_variable(p.min(q), p.max(q)));
                    product = self.fits(self.scope.budget.mul(&product, &var), span)?;
                }
                sum = self.fits(self.scope.budget.add(&sum, &product), span)?;
            }
        }
        Some(sum)
    }

    fn dot_variable(&mut self, p: usize, q: usize) -> Var {
        if let Some((var, _)) = self.products.iter().find(|(_, pair)| *pair == (p, q)) {
            return *var;
        }
        let name = format!("dot({}, {})", self.points[p].name, self.points[q].name);
        let var = self.new_variable(name);
        self.products.push((var, (p, q)));
        var
    }
}
