//! sin, cos, exp and the like of arguments that are linear in the variables, and values put in place of an angle.
//!
//! With ψ half of the argument, c + i·s in proportion to exp(iψ) is a product of powers of 1 + i·tan(v·s), one for each
//! variable s, and of 1 + i for each multiple of π/4; the same with j² = 1 in place of i² = −1 for exp(jψ).

use proc_macro2::Span;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Var};
use crate::algebra::rational::Rational;
use crate::model::angle::{Analytic, Angle, Kind, multiple_of_pi, times};
use crate::model::roots::{Root, is_number};
use crate::model::scope::{Argument, Scope};
use crate::model::words::CIRCULAR;
use crate::syntax::Expr;
use basis_prover::collections::list::{Listed, Mapped};

/// A sum of multiples of variables, of π, and of 1.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    /// Variables with their factors, and whether these are to be multiplied by π.
    pub(crate) parts: Vec<(Var, Rational, bool)>,
    /// The factor of π.
    pub(crate) pi: Rational,
    /// The number.
    pub(crate) number: Rational,
}

impl Linear {
    /// The number, π rounded, without the variables.
    pub(crate) fn about(&self) -> Rational {
        &self.number + &(&self.pi * &Analytic::pi())
    }

    /// The sum that a function is; `None` for any other function.
    pub(crate) fn of(f: &Fraction, pi: Option<Var>) -> Option<Self> {
        let mut linear = Self { parts: Vec::new(), pi: Rational::ZERO, number: Rational::ZERO };
        for (monomial, c) in f.as_poly()?.terms() {
            let turns = pi.map_or(0, |pi| monomial.exponent(pi));
            let variables: Vec<Var> = (0..monomial.width())
                .map(Var)
                .filter(|v| Some(*v) != pi && monomial.exponent(*v) > 0)
                .collect();
            match (variables.as_slice(), monomial.total_degree()) {
                ([], 0) => linear.number = c.clone(),
                ([], 1) => linear.pi = c.clone(),
                ([only], degree) if turns < 2 && degree == 1 + u32::from(turns) => {
                    linear.parts.push((*only, c.clone(), turns == 1));
                }
                _ => return None,
            }
        }
        Some(linear)
    }

    /// The sum times a number.
    pub(crate) fn scaled(&self, by: &Rational) -> Self {
        Self {
            parts: self.parts.mapped(|(var, c, turns)| (*var, c * by, *turns)),
            pi: &self.pi * by,
            number: &self.number * by,
        }
    }

    /// The sum times v and π if the rate of an angle says so, minus the shift: its ψ with the sum in its place; `None`
    /// where π would be squared.
    fn in_place_of(&self, angle: &Angle) -> Option<Self> {
        let mut psi = self.scaled(&angle.rate);
        let shift = &angle.rate * &angle.shift;
        if angle.turns {
            if !psi.pi.is_zero() || psi.parts.iter().any(|(_, _, turns)| *turns) {
                return None;
            }
            psi.pi = &psi.number - &shift;
            psi.number = Rational::ZERO;
            psi.parts.iter_mut().for_each(|(_, _, turns)| *turns = true);
        } else {
            psi.pi -= &shift;
        }
        Some(psi)
    }
}

/// What is wrong with an argument, and what to write instead.
pub(crate) type Wrong = (String, String);

/// c + i·s in proportion to exp(iψ), or with j² = 1, without a part of ψ whose tangent is irrational.
struct Phase {
    kind: Kind,
    c: Fraction,
    s: Fraction,
    /// The tangent of that part, if there is one.
    further: Option<Fraction>,
}

impl Phase {
    /// Of the angle 0.
    fn alone(&self) -> Self {
        let one = Fraction::constant(Rational::ONE);
        Self { kind: self.kind, c: one, s: Fraction::zero(), further: None }
    }

    /// c and s of the whole angle.
    fn whole(mut self, scope: &Scope<'_>, span: Span) -> Option<Self> {
        if let Some(tangent) = self.further.take() {
            self.turned(scope, (&Fraction::constant(Rational::ONE), &tangent), 1, span)?;
        }
        Some(self)
    }

    /// Times (c + i·s)^n, n perhaps negative.
    fn turned(
        &mut self,
        scope: &Scope<'_>,
        (c, s): (&Fraction, &Fraction),
        n: i64,
        span: Span,
    ) -> Option<()> {
        let budget = &scope.budget;
        let s = if n < 0 { -s } else { s.clone() };
        for _ in 0..n.abs() {
            let mul = |a: &Fraction, b: &Fraction| scope.fits(budget.mul(a, b), span);
            let (cc, ss) = (mul(&self.c, c)?, mul(&self.s, &s)?);
            let (cs, sc) = (mul(&self.c, &s)?, mul(&self.s, c)?);
            let real = if self.kind == Kind::Circular { budget.sub(&cc, &ss) } else { budget.add(&cc, &ss) };
            (self.c, self.s) = (scope.fits(real, span)?, scope.fits(budget.add(&cs, &sc), span)?);
        }
        Some(())
    }
}

/// A shape parameter and the domain variable of which it is the frequency: a polynomial of degree 2
/// in these that has their product.
pub(crate) fn frequency(
    value: &Fraction,
    is_parameter: impl Fn(Var) -> bool,
    is_domain: impl Fn(Var) -> bool,
) -> Option<(Var, Var)> {
    let polynomial = value.as_poly()?;
    let variables = polynomial.variables();
    // Multiples of π are numbers.
    let counted = variables.iter().filter(|v| is_parameter(**v) || is_domain(**v)).listed();
    let degree = |m: &Monomial| counted.iter().map(|v| u32::from(m.exponent(**v))).sum::<u32>();
    if polynomial.terms().map(|(m, _)| degree(m)).max() != Some(2) {
        return None;
    }
    let pairs = variables
        .iter()
        .filter(|p| is_parameter(**p))
        .flat_map(|p| variables.iter().filter(|t| is_domain(**t)).map(move |t| (*p, *t)));
    let mut pairs = pairs.filter(|(p, t)| !polynomial.derivative(*p).derivative(*t).is_zero());
    pairs.next()
}

/// What to write for a shape parameter as a frequency.
pub(crate) fn as_end_of_domain(name: &str, parameter: &str, t: &str, turns: bool) -> String {
    let pi = if turns { "pi*" } else { "" };
    format!(
        "a frequency is a number: let the parameter be the end of the domain, `shape 0 < {parameter}; domain 0 <= {t} <= {parameter};`, and write `{name}({pi}{t})`"
    )
}

/// More than this often no angle is multiplied.
const MAX_MULTIPLE: i64 = 40;

impl Scope<'_> {
    /// exp(iψ) up to a positive factor.
    fn phase(&self, kind: Kind, psi: &Linear, span: Span) -> Result<Option<Phase>, Wrong> {
        let one = Fraction::constant(Rational::ONE);
        let mut phase = Phase { kind, c: one.clone(), s: Fraction::zero(), further: None };
        let (mut pi, mut number) = (psi.pi.clone(), psi.number.clone());
        for (var, factor, turns) in &psi.parts {
            let name = &self.names[var.0];
            let Some(angle) = self.analytic.angles.iter().find(|a| a.itself == *var && a.kind == kind) else {
                if !self.simplices.is_empty() && self.analytic.angles.iter().all(|a| a.itself != *var) {
                    return Err((
                        format!("`{name}` stands in `sin`, `exp` or the like beside a simplex"),
                        String::from("angles and exponentials belong to families on intervals and boxes"),
                    ));
                }
                return Err((
                    format!("`{name}` appears in `sin` or `cos` and in `exp`, `sinh` or `cosh`"),
                    String::from("one of the two in a family, for each variable"),
                ));
            };
            let n =
                factor.checked_div(&angle.rate).filter(|_| *turns == angle.turns).and_then(|n| n.to_i64());
            let Some(n) = n.filter(|n| n.abs() <= MAX_MULTIPLE) else {
                let unit = times(&(&angle.rate + &angle.rate), angle.turns, name);
                return Err((
                    format!(
                        "the functions are known at whole multiples of `{unit}`, and this is not one of them"
                    ),
                    String::from("write the sines and cosines of this argument themselves"),
                ));
            };
            let shift = &(&angle.rate * &angle.shift) * &Rational::from(n);
            pi += &shift;
            let x = angle.tangent();
            if phase.turned(self, (&one, &x), n, span).is_none() {
                return Ok(None);
            }
        }
        if kind == Kind::Circular {
            // Whole eighths of a turn, and what is left of the angle in parts of which the tangent is known.
            let (mut quarters, mut further) = ((&pi * &Rational::from(4)).to_i64(), None);
            if quarters.is_none() {
                let two = Rational::from(2);
                let nearest = (&(&pi * &two) + &Rational::new(1, 2)).floor();
                let rest = &pi - &(&nearest * &Rational::new(1, 2));
                let parts = |root: &Root| Some((root.var, (&rest * &Rational::from(root.parts)).to_i64()?));
                further = self.analytic.roots.iter().find_map(parts);
                quarters = further.and_then(|_| (&nearest * &two).to_i64());
            }
            let multiple = match &self.analytic.tangent {
                _ if number.is_zero() => Some(0),
                Some((_, unit)) => number.checked_div(unit).and_then(|n| n.to_i64()),
                None => None,
            };
            let multiple = multiple.filter(|n| n.abs() <= MAX_MULTIPLE);
            let (Some(quarters), Some(multiple)) = (quarters, multiple) else {
                let what = if number.is_zero() {
                    multiple_of_pi(&(&pi + &pi))
                } else {
                    (&number + &number).to_string()
                };
                return Err((
                    format!("sin and cos of the angle {what} are irrational"),
                    String::from(
                        "constant parts of an angle are multiples of pi/2, or of one small part of `pi` for the whole family such as pi/12, and of shape parameters",
                    ),
                ));
            };
            if phase.turned(self, (&one, &one), quarters.rem_euclid(8), span).is_none() {
                return Ok(None);
            }
            if let (Some((var, _)), 1..) = (&self.analytic.tangent, multiple.abs()) {
                let tangent = Fraction::var(*var);
                if phase.turned(self, (&one, &tangent), multiple, span).is_none() {
                    return Ok(None);
                }
            }
            if let Some((root, parts)) = further {
                let mut own = phase.alone();
                if own.turned(self, (&one, &Fraction::var(root)), parts, span).is_none() {
                    return Ok(None);
                }
                let Some(tangent) = own.s.checked_div(&own.c) else { return Ok(None) };
                phase.further = Some(self.analytic.reduced(tangent));
            }
            return Ok(Some(phase));
        }
        if !pi.is_zero() {
            return Err((
                String::from("`pi` has no meaning in `exp`, `sinh` and `cosh`"),
                String::from("their arguments are rational multiples of a variable, plus numbers"),
            ));
        }
        number = &number + &number;
        if !number.is_zero() {
            let unit = self.analytic.exponential.as_ref();
            let power = unit.and_then(|(_, unit)| number.checked_div(unit)?.to_i64());
            let (Some((var, _)), Some(power)) = (unit, power.filter(|n| n.abs() <= MAX_MULTIPLE)) else {
                return Err((
                    format!("exp({number}) is not one of the numbers in which the family is expanded"),
                    String::from(
                        "it stands in formulas, `let c = exp(1);`; domains end at rational numbers, multiples of `pi` and shape parameters",
                    ),
                ));
            };
            // tanh ψ = (E − 1)/(E + 1) with E = exp 2ψ.
            let Ok(e) = self.budget.pow(&Fraction::var(*var), power.unsigned_abs() as u32) else {
                return Ok(None);
            };
            let (c, s) = (&e + &one, &e - &one);
            if phase.turned(self, (&c, &s), power.signum(), span).is_none() {
                return Ok(None);
            }
        }
        Ok(Some(phase))
    }

    /// sin, cos, tan, sinh, cosh, tanh or exp of an argument.
    pub(crate) fn transcendental(&mut self, name: &str, argument: &Expr, span: Span) -> Option<Fraction> {
        let before = self.pending.len();
        let value = self.scalar(argument)?;
        let kind = if CIRCULAR.contains(&name) { Kind::Circular } else { Kind::Hyperbolic };
        if let Some(recorded) = &mut self.recorded {
            // tan(ψ) itself is one of the tangents.
            let value = if is_tangent(name) { &value + &value } else { value };
            recorded.arguments.push(Argument { name: name.to_owned(), value, span: argument.span });
            return Some(Fraction::var(Var(self.names.len())));
        }
        let Some(linear) = Linear::of(&value, self.analytic.pi) else {
            self.pending.truncate(before);
            self.report_frequency(name, &value, argument.span);
            return None;
        };
        if let Some(number) = special(name, &linear) {
            return Some(Fraction::constant(number));
        }
        let half = if is_tangent(name) { linear } else { linear.scaled(&Rational::new(1, 2)) };
        let phase = match self.phase(kind, &half, argument.span) {
            Ok(phase) => phase?,
            Err((message, help)) => {
                self.report(self.error(argument.span, message).help(help));
                return None;
            }
        };
        if is_tangent(name) {
            let phase = phase.whole(self, span)?;
            if phase.c.is_zero() {
                self.report(self.error(span, "the tangent of a right angle has no value"));
                return None;
            }
            let tangent = self.fits(self.budget.div(&phase.s, &phase.c), span)?;
            let tangent = self.constant_reduced(tangent);
            self.must_be_defined(&tangent, span);
            return Some(tangent);
        }
        let (budget, circular) = (&self.budget, kind == Kind::Circular);
        let mul = |a: &Fraction, b: &Fraction| self.fits(budget.mul(a, b), span);
        let (cc, ss, cs) = (mul(&phase.c, &phase.c)?, mul(&phase.s, &phase.s)?, mul(&phase.c, &phase.s)?);
        let sum = self.fits(budget.add(&cc, &ss), span)?;
        let difference = self.fits(budget.sub(&cc, &ss), span)?;
        let (square, cos) = if circular { (&sum, &difference) } else { (&difference, &sum) };
        let twice = &cs + &cs;
        if let Some(tangent) = &phase.further {
            // By the addition theorem: a common denominator would contain the irrational number.
            let (sin, cos) =
                (self.fits(budget.div(&twice, square), span)?, self.fits(budget.div(cos, square), span)?);
            let below = &Fraction::constant(Rational::ONE) + &(tangent * tangent);
            let number = |above: Fraction| Some(self.analytic.reduced(above.checked_div(&below)?));
            let own_sin = number(tangent + tangent)?;
            let own_cos = number(&Fraction::constant(Rational::from(2)) - &below)?;
            let sum = match name {
                "sin" => budget.add(&mul(&sin, &own_cos)?, &mul(&cos, &own_sin)?),
                _ => budget.sub(&mul(&cos, &own_cos)?, &mul(&sin, &own_sin)?),
            };
            return self.fits(sum, span).map(|value| self.constant_reduced(value));
        }
        let quotient = match name {
            "sin" | "sinh" => budget.div(&twice, square),
            "cos" | "cosh" => budget.div(cos, square),
            _ => budget.div(&(&phase.c + &phase.s), &(&phase.c - &phase.s)),
        };
        self.fits(quotient, span).map(|value| self.constant_reduced(value))
    }

    /// A value, without a fraction line if it is a number made of tan(π/n).
    fn constant_reduced(&self, value: Fraction) -> Fraction {
        if is_number(&self.analytic.roots, &value) { self.analytic.reduced(value) } else { value }
    }

    /// Notes that functions of angles have to be known at a multiple of π, as if its sine and
    /// cosine stood in the claim.
    pub(in crate::model::formula) fn record_bound(&mut self, bound: &Fraction, span: Span) {
        let is_multiple = self.analytic.pi.is_some_and(|pi| {
            let slope = bound.as_poly().and_then(|p| p.derivative(pi).as_constant());
            let rest = slope.map(|slope| bound - &(&Fraction::constant(slope) * &Fraction::var(pi)));
            bound.depends_on(pi) && rest.is_some_and(|rest| rest.is_zero())
        });
        if let Some(recorded) = self.recorded.as_mut().filter(|_| is_multiple) {
            // One of the two can be rational where the other one is not.
            for name in ["sin", "cos"] {
                recorded.arguments.push(Argument { name: String::from(name), value: bound.clone(), span });
            }
        }
    }

    /// The error for an argument that is not linear.
    fn report_frequency(&self, name: &str, value: &Fraction, span: Span) {
        let is_angle = |v: Var| {
            let mut angles = self.analytic.angles.iter();
            angles.any(|angle| angle.itself == v && self.domain.contains(&angle.var))
        };
        let is_domain = |v: Var| self.domain.contains(&v) || is_angle(v);
        let is_parameter = |v: Var| !is_domain(v) && Some(v) != self.analytic.pi;
        let error = self.error(span, format!("the argument of `{name}` is not linear in one variable"));
        self.report(match frequency(value, is_parameter, is_domain) {
            Some((parameter, t)) => {
                let turns = self.analytic.pi.is_some_and(|pi| value.depends_on(pi));
                error.help(as_end_of_domain(name, &self.names[parameter.0], &self.names[t.0], turns))
            }
            None => error.help(
                "it is a rational multiple of a variable, or that times `pi`, plus multiples of shape parameters and of `pi/2`",
            ),
        });
    }

    /// What takes the place of an angle, y and the variable itself, where the variable has a value.
    pub(crate) fn angle_at(
        &self,
        angle: &Angle,
        value: &Fraction,
        span: Span,
    ) -> Result<Option<Fraction>, Wrong> {
        if angle.kind == Kind::Linear {
            let rise = self.fits(self.budget.sub(value, &angle.low), span);
            return Ok(rise.and_then(|rise| self.fits(self.budget.div(&rise, &angle.width), span)));
        }
        let linear = Linear::of(value, self.analytic.pi).and_then(|linear| linear.in_place_of(angle));
        let Some(psi) = linear else {
            let message = format!("the value of `{}` is not linear", angle.name);
            let help = "values of an angle are numbers, multiples of `pi`, and multiples of other angles";
            return Err((message, String::from(help)));
        };
        let phase = self.phase(angle.kind, &psi, span)?.and_then(|phase| phase.whole(self, span));
        let Some(phase) = phase else { return Ok(None) };
        if phase.c.is_zero() {
            let message =
                format!("this value of `{}` lies outside of its range `{}`", angle.name, angle.declared);
            return Err((message, String::from("claims are about the declared ranges")));
        }
        let y = self.budget.div(&phase.s, &phase.c).and_then(|x| self.budget.sub(&x, &angle.low));
        let y = self.fits(y, span).and_then(|rise| self.fits(self.budget.div(&rise, &angle.width), span));
        Ok(y.map(|y| self.constant_reduced(y)))
    }
}

/// Whether a function is a tangent.
fn is_tangent(name: &str) -> bool {
    name == "tan" || name == "tanh"
}

/// sin, cos and tan of numbers that are rational: of multiples of π/6.
pub(crate) fn special(name: &str, linear: &Linear) -> Option<Rational> {
    if !linear.parts.is_empty() || !linear.number.is_zero() || !CIRCULAR.contains(&name) {
        return None;
    }
    let sixths = (&linear.pi * &Rational::from(6)).to_i64()?.rem_euclid(12);
    let sin = |k: i64| match k.rem_euclid(12) {
        0 | 6 => Some(Rational::ZERO),
        1 | 5 => Some(Rational::new(1, 2)),
        3 => Some(Rational::ONE),
        7 | 11 => Some(Rational::new(-1, 2)),
        9 => Some(Rational::from(-1)),
        _ => None,
    };
    match name {
        "sin" => sin(sixths),
        "cos" => sin(sixths + 3),
        _ => None,
    }
}
