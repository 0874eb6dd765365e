//! The functions of another family in expressions: `Bernstein(3)`, `Other(λ)`, `Raised(4)(λ)`.

use proc_macro2::Span;

use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::model::scope::{Inside, Scope};
use crate::plural::{count, here};
use crate::syntax::Expr;
use basis_prover::collections::list::{Listed, Mapped};

impl Scope<'_> {
    /// The functions of another family, in this family's domain variables.
    pub(crate) fn family(
        &mut self,
        name: &str,
        orders: &[Expr],
        shapes: &[Expr],
        only: Option<&[i64]>,
        span: Span,
    ) -> Option<Value> {
        let mut order = Vec::new();
        for o in orders {
            order.push(self.whole(o, "the order of a family")?);
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
        self.inherit(&family.obligations);
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
        if family.domain.len() != self.domain.len() || family.is_simplex() != self.dependent.is_some() {
            let kind = |simplex: bool, n: usize| match (simplex, n) {
                (true, 2) => String::from("a triangle"),
                (true, _) => String::from("a tetrahedron"),
                (false, 1) => String::from("an interval"),
                (false, n) => format!("a box in {n} variables"),
            };
            let theirs = kind(family.is_simplex(), family.domain.len());
            let ours = kind(self.dependent.is_some(), self.domain.len());
            let error = self.error(span, format!("`{name}` lives on {theirs}, this family on {ours}"));
            self.report(error.help("compare with a family on the same domain, or with formulas"));
            return None;
        }
        let mut by = Vec::new();
        for (shape, parameter) in shapes.iter().zip(&family.shapes) {
            let value = self.scalar(shape)?;
            if let Some(var) = self.domain.iter().find(|v| value.depends_on(**v)) {
                let error = self.error(
                    shape.span,
                    format!("a shape value of `{name}` contains the domain variable `{}`", self.names[var.0]),
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
        // The other family's shape parameters stand aside until their values take their places, so that no value
        // is substituted into another; different variables take them at once.
        let plain = by.mapped(Fraction::as_var);
        let renamed = (0..plain.len()).all(|k| plain[k].is_some() && !plain[..k].contains(&plain[k]));
        let width = self.names.len();
        let aside = |k: usize| Var(width + k);
        let mut names: Vec<Var> =
            (0..by.len()).map(|k| plain[k].filter(|_| renamed).unwrap_or_else(|| aside(k))).listed();
        names.extend(&self.domain);
        names.extend(family.dependent.as_ref().and(self.dependent));
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
                        self.report(self.error(span, format!("a denominator of `{name}` becomes zero here")));
                        return None;
                    }
                }
            }
            // The domain here may be a wider one.
            if self.domain.iter().any(|v| value.denom().depends_on(*v)) {
                self.must_be_defined(&value, span);
            }
            list.push((f.index.clone(), value));
        }
        Some(Value::List(list))
    }
}
