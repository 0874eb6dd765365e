//! Integrals in expressions: `integral(f)` over the domain, `integral(f, t, a, b)` in one variable between bounds.
//!
//! A polynomial has a polynomial as its antiderivative; for quotients see `antiderivative`, for angles `angles`, over several
//! spans `spans`. Over the simplex
//! u₁ + … + uₖ ≤ 1 the integral of u₁^a₁ ⋯ uₖ^aₖ is a₁! ⋯ aₖ!/(a₁ + … + aₖ + k)!.

#[cfg(feature = "angles")]
mod angles;
mod antiderivative;
mod spans;

use proc_macro2::Span;

use super::AngleValue;
use super::Value;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::angle::{Angle, Kind};
use crate::model::scope::Scope;
use crate::plural::here;
use crate::syntax::{Expr, ExprKind};
use basis_prover::collections::list::Listed;

/// n!
fn factorial(n: u32) -> Rational {
    (1..=i64::from(n)).fold(Rational::ONE, |product, k| &product * &Rational::from(k))
}

/// What an integral that cannot be written down is answered with.
const LEAVES: &str = "logarithms and arc tangents are not in the language: claim that the integrand lies between polynomials, `p <= x <= q`; their integrals bound this one";

/// What an integral over a simplex is answered with.
const ON_A_SIMPLEX: &str = "over a simplex polynomials are integrated: claim that the integrand lies between two of them, `p <= x <= q`; their integrals bound this one";

impl Scope<'_> {
    /// integral(f), integral(f, t, a, b).
    pub(crate) fn integral(&mut self, arguments: &[Expr], span: Span) -> Option<Value> {
        let (f, bounds) = match arguments {
            [f] => (f, None),
            [f, variable, low, high] => (f, Some((self.integrated(variable)?, low, high))),
            _ => {
                let error =
                    self.error(span, format!("`integral` takes 1 or 4 arguments, {}", here(arguments.len())));
                self.report(error.help(
                    "write `integral(b[0])` over the whole domain, `integral(b[0], t, 0, 1/2)` between bounds",
                ));
                return None;
            }
        };
        let bounds = match bounds {
            Some((var, low, high)) => {
                let spans = [low.span, high.span];
                let (low, high) = (self.bound(low), self.bound(high));
                let (low, high) = (low?, high?);
                for (bound, span) in [&low, &high].into_iter().zip(spans) {
                    self.record_bound(bound, span);
                }
                Some((var, low, high))
            }
            None if self.domain.is_empty() => {
                let error = self.error(span, "an integral needs its variable and bounds here");
                self.report(error.help("write `integral(x, t, 0, 1)`"));
                return None;
            }
            None => None,
        };
        let own = |var: Var| self.analytic.angle(var).map_or(var, |angle| angle.var);
        let over_domain = bounds.as_ref().is_none_or(|(var, ..)| self.domain.contains(&own(*var)));
        if over_domain && self.is_of_spans(f, bounds.is_none()) {
            let bounds = bounds.map(|(_, low, high)| [low, high]);
            return self.over_spans(f, bounds.as_ref(), span);
        }
        self.over_one(f, bounds, span)
    }

    /// The integral of the formulas of this scope.
    pub(in crate::model::formula) fn over_one(
        &mut self,
        f: &Expr,
        bounds: Option<(Var, Fraction, Fraction)>,
        span: Span,
    ) -> Option<Value> {
        let bounds = match bounds {
            Some((var, low, high)) => Some(match self.analytic.angle(var).cloned() {
                Some(angle) => {
                    let (from, to) =
                        (self.value_of(&angle, &low, span)?, self.value_of(&angle, &high, span)?);
                    (angle.var, [(from, low), (to, high)])
                }
                None => (var, [(low.clone(), low), (high.clone(), high)]),
            }),
            None => None,
        };
        let over = |scope: &mut Self, f: &Fraction| match &bounds {
            Some((var, [low, high])) => scope.between(f, *var, [low, high], span),
            None => scope.over_domain_of(f, span),
        };
        match self.value(f)? {
            Value::Scalar(f) => Some(Value::Scalar(over(self, &f)?)),
            Value::List(list) => {
                let mut result = Vec::new();
                for (index, f) in list {
                    result.push((index, over(self, &f)?));
                }
                Some(Value::List(result))
            }
        }
    }

    /// The variable of an integral.
    fn integrated(&self, expr: &Expr) -> Option<Var> {
        let ExprKind::Name(name) = &expr.kind else {
            let error = self.error(expr.span, "expected the variable of the integral");
            self.report(error.help("write `integral(x, t, 0, 1)`: the variable, then its bounds"));
            return None;
        };
        let var = self.variable_called(name);
        if var.is_some_and(|v| self.simplex_of(v).is_some()) {
            let error = self.error(expr.span, "on a simplex an integral is over all of it");
            self.report(
                error.help("write `integral(x)`; with w = 1 - u - v in place of w every variable matters"),
            );
            return None;
        }
        match var {
            Some(var) => Some(var),
            None if self.is_mistaken(name) => None,
            None => {
                self.no_variable(name, "integrate", expr.span);
                None
            }
        }
    }

    /// The variable with a name, or the one that stands for an argument of the name whose formula is evaluated.
    pub(crate) fn variable_called(&self, name: &str) -> Option<Var> {
        match self.arguments.iter().find(|(n, _)| n == name) {
            Some((_, Value::Scalar(f))) => f.as_var(),
            Some(_) => None,
            None => self.variable(name),
        }
    }

    /// Whether a domain variable occurs in a function: of an angle its tangent, or itself.
    pub(in crate::model::formula) fn occurs(&self, f: &Fraction, var: Var) -> bool {
        f.depends_on(var) || self.analytic.angle(var).is_some_and(|a| f.depends_on(a.itself))
    }

    /// A bound of an integral.
    fn bound(&mut self, expr: &Expr) -> Option<Fraction> {
        let value = self.scalar(expr)?;
        let Some(var) = self.domain.iter().find(|v| self.occurs(&value, **v)) else { return Some(value) };
        let name = self.analytic.angle(*var).map_or(&self.names[var.0], |angle| &angle.name);
        let error = self.error(expr.span, format!("a bound contains the domain variable `{name}`"));
        self.report(error.help("bounds are made of shape parameters and numbers"));
        None
    }

    /// What takes the place of an angle where it has a value.
    fn value_of(&self, angle: &Angle, value: &Fraction, span: Span) -> Option<Fraction> {
        match self.angle_at(angle, value, span) {
            Ok(place) => place,
            Err((message, _)) => {
                let error = self.error(span, "the functions are not known at a bound of the integral");
                let error = error.label(message);
                self.report(error.help(if angle.kind == Kind::Circular {
                    String::from("bounds are ends of the domain, shape parameters, and multiples of one small part of `pi` such as pi/12")
                } else {
                    String::from("bounds are ends of the domain and shape parameters")
                }));
                None
            }
        }
    }

    /// The integral in one variable; of an angle, and of a variable whose ends contain shape parameters, y and itself at both
    /// ends.
    fn between(&self, f: &Fraction, var: Var, [low, high]: [&AngleValue; 2], span: Span) -> Option<Fraction> {
        match self.analytic.angle(var) {
            Some(angle) if angle.kind != Kind::Linear => self.over_angle(f, angle, [low, high], span),
            // s = low + width·y: ds is width times dy.
            Some(angle) => {
                let value = self.between_numbers(f, var, &low.0, &high.0, span)?;
                self.fits(self.budget.mul(&value, &angle.width), span)
            }
            None => self.between_numbers(f, var, &low.0, &high.0, span),
        }
    }

    /// The integral of a polynomial in one variable.
    pub(crate) fn between_numbers(
        &self,
        f: &Fraction,
        var: Var,
        low: &Fraction,
        high: &Fraction,
        span: Span,
    ) -> Option<Fraction> {
        self.fits(self.budget.spend(f.numer().len() as u64), span)?;
        let antiderivative = if f.denom().depends_on(var) {
            // Where there is none other bounds do not help.
            let Some(found) = self.fits(self.rational_antiderivative(f, var), span)? else {
                let error = self.error(span, "the integral is not a rational number or function");
                let label = "the antiderivative has a logarithm or an arc tangent";
                self.report(error.label(label).help(LEAVES));
                return None;
            };
            self.check_bounds(var, [low, high], span)?;
            found
        } else {
            let raised = f.numer().terms().map(|(m, c)| {
                let exponent = m.exponent(var) + 1;
                (m.with_exponent(var, exponent), c * &Rational::new(1, i64::from(exponent)))
            });
            Fraction::new(Poly::from_terms(raised), f.denom().clone())?
        };
        let at = |bound: &Fraction, side: &str| {
            self.put_one_or(&antiderivative, var, bound, span, &|| self.diverges(var, bound, side, span))
        };
        let (upper, lower) = (at(high, "upper")?, at(low, "lower")?);
        self.fits(self.budget.sub(&upper, &lower), span)
    }

    /// The error for an integral up to a pole: where the antiderivative has one the integrand has one of a higher order.
    fn diverges(&self, var: Var, bound: &Fraction, side: &str, span: Span) -> Diagnostic {
        let end = match self.analytic.angle(var) {
            Some(angle) => format!("the {side} end of `{}`", angle.name),
            None => format!("the {side} end {} = {}", self.names[var.0], bound.display(&self.names)),
        };
        let error = self.error(span, "the integral diverges");
        let error = error.label(format!("the integrand has a pole at {end}"));
        error.help("it has no value: claim integrals that end before the pole, or of a function without it")
    }

    /// A function is known to have no pole in the domain; between other bounds it may.
    fn check_bounds(&self, var: Var, bounds: [&Fraction; 2], span: Span) -> Option<()> {
        let own = self.domain.iter().position(|v| *v == var).and_then(|k| self.ends.get(k));
        let inside = own.is_some_and(|(low, high)| {
            let ends = [low.as_constant(), high.as_constant()];
            bounds.into_iter().all(|bound| {
                let between = |x: Rational| matches!(&ends, [Some(a), Some(b)] if *a <= x && x <= *b);
                bound == low || bound == high || bound.as_constant().is_some_and(between)
            })
        });
        if !inside {
            let name = &self.names[var.0];
            let error = self.error(span, "the integrand may have a pole between the bounds");
            let error = error.label(format!("`{name}` is in a denominator"));
            self.report(error.help(if self.domain.is_empty() {
                "claim the integral in the family, where the denominator is known to be positive: here polynomials are integrated"
            } else {
                "where there is a denominator, the bounds are ends of the domain or numbers in it"
            }));
        }
        inside.then_some(())
    }

    /// The integral over the whole domain; where it leaves the functions of a spec, that is reported.
    pub(crate) fn over_domain_of(&self, f: &Fraction, span: Span) -> Option<Fraction> {
        let mut value = f.clone();
        for (var, (low, high)) in self.domain.iter().zip(&self.ends) {
            if self.simplex_of(*var).is_none() {
                let [from, to] = match self.analytic.angle(*var) {
                    Some(angle) => angle.limits.clone(),
                    None => [low.clone(), high.clone()],
                };
                let ends = [&(low.clone(), from), &(high.clone(), to)];
                value = self.between(&value, *var, ends, span)?;
            }
        }
        for simplex in &self.simplices {
            value = self.over_simplex(&value, &self.domain[simplex.places.clone()], span)?;
        }
        Some(value)
    }

    /// The integral over a simplex with these independent coordinates.
    fn over_simplex(&self, f: &Fraction, coordinates: &[Var], span: Span) -> Option<Fraction> {
        self.check_integrand(f, coordinates, span)?;
        self.fits(self.budget.spend(f.numer().len() as u64), span)?;
        let terms = f.numer().terms().map(|(m, c)| {
            let mut value = c.clone();
            let (mut rest, mut sum) = (m.clone(), coordinates.len() as u32);
            for var in coordinates {
                let exponent = u32::from(m.exponent(*var));
                value *= &factorial(exponent);
                rest = rest.with_exponent(*var, 0);
                sum += exponent;
            }
            (rest, &value / &factorial(sum))
        });
        let terms: Vec<(Monomial, Rational)> = terms.listed();
        Fraction::new(Poly::from_terms(terms), f.denom().clone())
    }

    /// No variable of the integral stands below a fraction line.
    fn check_integrand(&self, f: &Fraction, vars: &[Var], span: Span) -> Option<()> {
        let Some(var) = vars.iter().find(|v| f.denom().depends_on(**v)) else { return Some(()) };
        let name = &self.names[var.0];
        let error = self.error(span, "the integral is not a rational number or function");
        self.report(error.label(format!("`{name}` is in a denominator")).help(ON_A_SIMPLEX));
        None
    }
}
