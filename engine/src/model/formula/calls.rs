//! The functions of another family in expressions: `Bernstein(3)`, `Other(λ)`, `Raised(4)(λ)`; with arguments in place
//! of its domain variables, `Bernstein(3)[i](u)`, on any domain.

use proc_macro2::Span;

use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::model::chart::Constraint;
use crate::model::formula::print::Printer;
use crate::model::scope::{Condition, Duty, Inside, Pending, Scope};
use crate::model::{Barycentric, Family};
use crate::plural::{count, here, list};
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::{Listed, Mapped};

/// The functions of a family, or one of them, as they are written.
#[derive(Clone, Copy)]
pub(crate) struct Factor<'e> {
    pub(crate) name: &'e str,
    pub(crate) orders: &'e [Expr],
    pub(crate) shapes: &'e [Expr],
    pub(crate) index: Option<&'e [Expr]>,
}

impl Scope<'_> {
    /// The family that an expression names, perhaps with its order, shape values and an index.
    pub(crate) fn factor<'e>(&self, expr: &'e Expr) -> Option<Factor<'e>> {
        let free = |name: &str| {
            name != self.function_name && self.taken(name).is_none() && self.library.knows(self.unit, name)
        };
        let ordered = |name: &str| self.library.order_count(self.unit, name) > 0;
        let plain = |name| Factor { name, orders: &[], shapes: &[], index: None };
        match &expr.kind {
            ExprKind::Name(name) if free(name) && !ordered(name) => Some(plain(name)),
            ExprKind::Call(inner, arguments) => match &inner.kind {
                ExprKind::Name(name) if free(name) => Some(if ordered(name) {
                    Factor { orders: arguments, ..plain(name) }
                } else {
                    Factor { shapes: arguments, ..plain(name) }
                }),
                ExprKind::Call(..) => {
                    let factor = self.factor(inner)?;
                    let room = factor.shapes.is_empty() && ordered(factor.name);
                    room.then_some(Factor { shapes: arguments, ..factor })
                }
                _ => None,
            },
            ExprKind::Index(inner, index) => {
                let factor = self.factor(inner)?;
                factor.index.is_none().then_some(Factor { index: Some(index), ..factor })
            }
            _ => None,
        }
    }

    /// The functions of a family, or one of them, with arguments in place of its domain variables.
    pub(crate) fn factor_at(&mut self, factor: Factor<'_>, arguments: &[Expr], span: Span) -> Option<Value> {
        let Factor { name, orders, shapes, index } = factor;
        let Some(index) = index else {
            return self.family(name, orders, shapes, Some(arguments), None, span);
        };
        let mut only = Vec::new();
        for i in index {
            only.push(self.whole(i, "an index")?);
        }
        let value = self.family(name, orders, shapes, Some(arguments), Some(&only), span)?;
        self.entry(&value, &only, span)
    }

    /// Notes that shape values must satisfy what a family assumes of them.
    pub(crate) fn must_satisfy(&mut self, family: &Family, by: &[Fraction], span: Span) -> Option<()> {
        self.must_hold(family, &family.constraints.iter().listed(), by, span)
    }

    /// The same of some of what it assumes.
    pub(crate) fn must_hold(
        &mut self,
        family: &Family,
        constraints: &[&Constraint],
        by: &[Fraction],
        span: Span,
    ) -> Option<()> {
        for constraint in constraints {
            let value = Fraction::from(constraint.value.clone());
            let vars: Vec<Var> = family.shapes.mapped(|p| p.var);
            let value = self.put(&value, &vars, by, span)?;
            let (relation, text) = (constraint.relation, constraint.text.clone());
            let condition = Condition { value, relation, text, family: family.title() };
            self.pending.push(Pending { duty: Duty::Holds(condition), place: self.place(span) });
        }
        Some(())
    }

    /// The functions of another family, in this family's domain variables or with arguments in place of its own.
    pub(crate) fn family(
        &mut self,
        name: &str,
        orders: &[Expr],
        shapes: &[Expr],
        arguments: Option<&[Expr]>,
        only: Option<&[i64]>,
        span: Span,
    ) -> Option<Value> {
        let mut order = Vec::new();
        for o in orders {
            let argument = Printer { constants: &self.constants, component: None }.print(o);
            let help = format!(
                "an order is a whole number, `Bernstein(3)`; an argument in place of the variable stands behind an index, `Bernstein(3)[0]({argument})`"
            );
            order.push(self.whole_or(o, "the order of a family", Some(&help))?);
        }
        let family = match self.library.family(self.unit, name, &order) {
            Ok(family) => family,
            Err(reason) => {
                if let Some((message, help)) = reason {
                    self.report(self.error(span, message).help(help));
                }
                return None;
            }
        };
        if !family.pieces.is_empty() {
            let error =
                self.error(span, format!("`{name}` has several spans: its functions cannot be named here"));
            self.report(error.help("write their formulas"));
            return None;
        }
        if !family.analytic.is_empty() {
            let error = self.error(
                span,
                format!("the functions of `{name}` cannot be named here: they have sin, cos, exp or pi"),
            );
            self.report(error.help("write their formulas"));
            return None;
        }
        self.inherit(&family.obligations);
        // What stands behind the order of a family without shape parameters is its argument.
        let (shapes, arguments) = match arguments {
            None if family.shapes.is_empty() && !orders.is_empty() && !shapes.is_empty() => {
                (&[][..], Some(shapes))
            }
            _ => (shapes, arguments),
        };
        if shapes.len() != family.shapes.len() {
            let wanted: Vec<String> = family.shapes.mapped(|s| s.name.clone());
            let error = self.error(
                span,
                format!("`{name}` has {}, {}", count(wanted.len(), "shape parameter"), here(shapes.len())),
            );
            let call = if order.is_empty() { name.to_string() } else { family.title() };
            self.report(error.help(if wanted.is_empty() {
                format!("write `{call}`")
            } else {
                format!("write `{call}({})`", wanted.join(", "))
            }));
            return None;
        }
        let variables = family.domain_variables().count();
        if let Some(arguments) = arguments
            && arguments.len() != variables
        {
            let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
            let wanted = count(variables, "argument");
            let message = format!("the functions of `{name}` take {wanted}, {}", here(arguments.len()));
            let error = self.error(span, message);
            let call = format!("{}[…]({})", written(&family), names.join(", "));
            self.report(error.help(if variables == 1 {
                format!("write `{call}`")
            } else {
                format!("write one for each coordinate, `{call}`")
            }));
            return None;
        }
        let sizes = |simplices: &[Barycentric]| simplices.iter().map(|s| s.places.clone()).listed();
        let alike =
            family.domain.len() == self.domain.len() && sizes(&family.simplices) == sizes(&self.simplices);
        if arguments.is_none() && !alike {
            let theirs = kind(family.domain.len(), &family.simplices);
            let ours = kind(self.domain.len(), &self.simplices);
            let error = self.error(span, format!("`{name}` is defined on {theirs}, this family on {ours}"));
            // Names that have a meaning here, as far as there are enough.
            let own: Vec<&str> =
                self.factors().iter().flatten().map(|v| self.names[self.itself(*v).0].as_str()).listed();
            let mut names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
            if names.len() <= own.len() && family.simplices.is_empty() {
                names = own[..names.len()].to_vec();
            }
            self.report(error.help(format!(
                "give its functions arguments, such as `{}[…]({})`, or compare with a family on the same domain",
                written(&family),
                names.join(", ")
            )));
            return None;
        }
        let mut by = Vec::new();
        for (shape, parameter) in shapes.iter().zip(&family.shapes) {
            let value = self.scalar(shape)?;
            if let Some(var) =
                self.domain.iter().find(|v| value.depends_on(**v) || value.depends_on(self.itself(**v)))
            {
                let error = self.error(
                    shape.span,
                    format!(
                        "a shape value of `{name}` contains the domain variable `{}`",
                        self.names[self.itself(*var).0]
                    ),
                );
                self.report(error.help("shape values are numbers, or made of shape parameters"));
                return None;
            }
            let inside = Inside {
                value: value.clone(),
                name: parameter.name.clone(),
                range: parameter.range.clone(),
                family: Some(family.title()),
                assumable: false,
                written: None,
            };
            let place = self.place(shape.span);
            if let Some(c) = value.as_constant() {
                // A number needs no proof, and a function with a forbidden one no further look.
                if !parameter.range.contains(&c) {
                    self.report(inside.outside(&c, place));
                    return None;
                }
            } else {
                self.must_stay_inside(inside, place);
            }
            by.push(value);
        }
        self.must_satisfy(&family, &by, span)?;
        if let Some(arguments) = arguments {
            let mut values = Vec::new();
            for argument in arguments {
                values.push(self.scalar(argument)?);
            }
            let factors = family.factors().mapped(|f| f.variables().count());
            by.extend(self.independent_of(&factors, &values, span)?);
        }
        // The other family's shape parameters stand aside until their values take their places, so that no value
        // is substituted into another; different variables take them at once.
        let plain = by.mapped(Fraction::as_var);
        let renamed = (0..plain.len()).all(|k| plain[k].is_some() && !plain[..k].contains(&plain[k]));
        let width = self.names.len();
        let aside = |k: usize| Var(width + k);
        let mut names: Vec<Var> =
            (0..by.len()).map(|k| plain[k].filter(|_| renamed).unwrap_or_else(|| aside(k))).listed();
        if arguments.is_none() {
            names.extend(self.domain.iter().map(|v| self.itself(*v)));
            names.extend(self.simplices.iter().map(|s| s.last.var));
        }
        // An index outside of the family is reported with the whole list.
        let only = only.filter(|index| family.functions.iter().any(|f| f.index == **index));
        let mut list = Vec::new();
        for f in family.functions.iter().filter(|f| only.is_none_or(|index| f.index == index)) {
            let size = (f.value.numer().len() + f.value.denom().len()) as u64;
            self.fits(self.budget.spend(size), span)?;
            let mut value = f.value.rename(&names);
            for (k, value_of) in by.iter().enumerate().filter(|_| !renamed) {
                match self.fits(self.budget.substitute(&value, aside(k), value_of), span)? {
                    Some(v) => value = v,
                    None => {
                        let error = self.error(span, format!("a denominator of `{name}` becomes zero here"));
                        self.report(error.help("choose other shape values, or another place"));
                        return None;
                    }
                }
            }
            // The domain here may be a wider one, and arguments may leave it.
            let leaves = arguments.is_some() && family.is_rational();
            if leaves || self.is_over_domain(&Fraction::from(value.denom().clone())) {
                self.must_be_defined(&value, span);
            }
            list.push((f.index.clone(), value));
        }
        Some(Value::List(list))
    }
}

/// What a domain is: `an interval`, `a box in 2 variables`, `a product of a triangle and an interval`.
fn kind(variables: usize, simplices: &[Barycentric]) -> String {
    let mut factors = Vec::new();
    let mut k = 0;
    while k < variables {
        let simplex = simplices.iter().find(|s| s.places.start == k);
        let len = simplex.map_or(1, |s| s.places.len());
        factors.push(String::from(match (simplex.is_some(), len) {
            (false, _) => "an interval",
            (true, 2) => "a triangle",
            (true, _) => "a tetrahedron",
        }));
        k += len;
    }
    match factors.as_slice() {
        [only] => only.clone(),
        _ if simplices.is_empty() => format!("a box in {variables} variables"),
        _ => format!("a product of {}", list(&factors)),
    }
}

/// A family as it is named in formulas, `Raised(4)(λ)`.
fn written(family: &Family) -> String {
    let shapes: Vec<&str> = family.shapes.mapped(|p| p.name.as_str());
    if shapes.is_empty() { family.title() } else { format!("{}({})", family.title(), shapes.join(", ")) }
}
