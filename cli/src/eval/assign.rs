//! The values that a command gives, checked against the declared ranges.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Var;
use basis_engine::algebra::range::DisplayRange as _;
use basis_engine::algebra::rational::Rational;
use basis_engine::model::angle::{Angle, Kind};
use basis_engine::model::{Factor, Parameter};
use basis_engine::{Diagnostic, Family};

use super::number::{self, Number};
use crate::domain;
use crate::name;
use crate::output::error;

/// A name with one value.
#[derive(Clone, Debug)]
pub(super) struct Given<'a> {
    /// The name as it is typed.
    pub(super) name: &'a str,
    /// The value.
    pub(super) value: &'a Number,
}

/// A value for each variable of a family.
#[derive(Clone, Debug)]
pub(super) struct Known {
    /// By variable.
    pub(super) values: Vec<Rational>,
    /// By variable, how far the value is at most from the one that is meant: 0 where it is not rounded.
    pub(super) errors: Vec<Rational>,
    /// By variable, the value as it is typed.
    pub(super) typed: Vec<Option<String>>,
}

/// A value for each shape parameter and each domain variable; `anyway` also outside of their ranges. Of several spans
/// `family` is one, and messages are about the domain of the `whole` one.
///
/// # Errors
/// Every name that is unknown, doubled or missing, every value outside of its range, and the first assumption that does
/// not hold.
pub(super) fn values(
    family: &Family,
    whole: &Family,
    shapes: &[Given<'_>],
    at: &[Given<'_>],
    anyway: bool,
) -> Result<Known, Vec<Diagnostic>> {
    let width = width(family);
    let mut table = Table {
        family,
        whole,
        anyway,
        values: vec![None; width],
        errors: vec![Rational::ZERO; width],
        typed: vec![None; width],
        meant: Vec::new(),
        found: Vec::new(),
    };
    table.numbers();
    for (role, given) in [(Role::Shape, shapes), (Role::At, at)] {
        let names = role.names(family);
        let words: Vec<&str> = given.iter().map(|given| given.name).collect();
        for (given, meant) in given.iter().zip(name::each_position(&words, &names)) {
            if meant.is_empty() {
                table.assign(role, given);
            }
            for k in meant {
                table.assign(role, &Given { name: names[k], value: given.value });
            }
        }
    }
    for factor in family.factors() {
        table.complete(factor);
    }
    table.miss(Role::Shape);
    table.miss(Role::At);
    table.assumed();
    let Table { values, errors, typed, found, .. } = table;
    if found.is_empty() {
        // Every variable of a formula is a shape parameter, a domain variable or a number, and none is missing.
        let values = values.into_iter().map(|value| value.unwrap_or(Rational::ZERO)).collect();
        Ok(Known { values, errors, typed })
    } else {
        Err(found)
    }
}

/// How far the value of a function is at most from the one at the values that are meant, each at most its error away:
/// to first order the sum of the changes by each, here doubled. `None` at a pole.
pub(super) fn spread(f: &Fraction, values: &[Rational], errors: &[Rational]) -> Option<Rational> {
    let at = f.eval(values)?;
    let mut sum = Rational::ZERO;
    let mut moved = values.to_vec();
    for k in (0..values.len()).filter(|&k| !errors[k].is_zero() && f.depends_on(Var(k))) {
        moved[k] = &values[k] + &errors[k];
        let change = &f.eval(&moved)? - &at;
        sum = &sum + &(&change.abs() * &Rational::from(2));
        moved[k].clone_from(&values[k]);
    }
    Some(sum)
}

/// How many variables there are, those of numbers such as π and of angles themselves included.
fn width(family: &Family) -> usize {
    let analytic = &family.analytic;
    let angles = analytic.angles.iter().flat_map(|a| [a.var.0, a.itself.0]);
    let numbers = analytic.numbers().into_iter().map(|v| v.0);
    angles.chain(numbers).map(|v| v + 1).max().unwrap_or(0).max(family.names.len())
}

/// The two options that give values.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    Shape,
    At,
}

impl Role {
    /// The name of the option.
    const fn flag(self) -> &'static str {
        match self {
            Self::Shape => "--shape",
            Self::At => "--at",
        }
    }

    /// What it gives a value to.
    const fn noun(self) -> &'static str {
        match self {
            Self::Shape => "shape parameter",
            Self::At => "domain variable",
        }
    }

    fn parameters(self, family: &Family) -> Vec<&Parameter> {
        match self {
            Self::Shape => family.shapes.iter().collect(),
            Self::At => family.domain_variables().collect(),
        }
    }

    /// The names as they are typed: of an angle its own, which stands for a tangent in the formulas.
    fn names(self, family: &Family) -> Vec<&str> {
        self.parameters(family).into_iter().map(|p| written(family, p)).collect()
    }

    /// The parameter with a name.
    fn find<'f>(self, name: &str, family: &'f Family) -> Option<&'f Parameter> {
        let parameters = self.parameters(family);
        let tangents: Vec<&str> = parameters.iter().map(|p| p.name.as_str()).collect();
        let position = name::position(name, &self.names(family)).or_else(|| name::position(name, &tangents));
        let of_angle = || parameters.iter().position(|p| is_tangent(name, family, p));
        position.or_else(of_angle).map(|k| parameters[k])
    }

    /// What its values must lie in.
    const fn place(self) -> &'static str {
        match self {
            Self::Shape => "declared range",
            Self::At => "domain",
        }
    }

    const fn other(self) -> Self {
        match self {
            Self::Shape => Self::At,
            Self::At => Self::Shape,
        }
    }
}

/// Whether a name is that of the tangent of an angle, `tan(t/2)`, as counterexamples have it.
fn is_tangent(name: &str, family: &Family, parameter: &Parameter) -> bool {
    let tangent = family.analytic.angle(parameter.var).map(Angle::tangent_name);
    tangent.is_some_and(|tangent| name::position(name, &[&tangent]).is_some())
}

/// The name of a parameter as the spec has it.
pub(super) fn written<'f>(family: &'f Family, parameter: &'f Parameter) -> &'f str {
    family.analytic.angle(parameter.var).map_or(&parameter.name, |angle| &angle.name)
}

/// The point as far as it is given.
struct Table<'f> {
    family: &'f Family,
    whole: &'f Family,
    anyway: bool,
    /// By variable.
    values: Vec<Option<Rational>>,
    /// By variable.
    errors: Vec<Rational>,
    /// By variable.
    typed: Vec<Option<String>>,
    /// Names without a value that were probably meant where another name was typed.
    meant: Vec<&'f str>,
    found: Vec<Diagnostic>,
}

impl Table<'_> {
    fn set(&mut self, var: Var, value: Rational, error: Rational) {
        self.values[var.0] = Some(value);
        self.errors[var.0] = error;
    }

    /// The values of π, of powers of e, and of the tangent of a number.
    fn numbers(&mut self) {
        if let Some(var) = self.family.analytic.pi {
            self.set(var, number::pi(), number::precision());
        }
        if let Some((var, exponent)) = &self.family.analytic.exponential
            && let Some(power) = number::exp(exponent)
        {
            let error = &power * &number::precision();
            self.set(*var, power, error);
        }
        if let Some((var, angle)) = &self.family.analytic.tangent
            && let Some((tangent, error)) = Number::rational(angle.clone()).tan()
        {
            self.set(*var, tangent, error);
        }
    }

    /// A function of what has a value, and how far it is at most from the one that is meant; `None` where it has none.
    fn known(&self, f: &Fraction) -> Option<(Rational, Rational)> {
        let known: Vec<Rational> = self.values.iter().map(|v| v.clone().unwrap_or(Rational::ZERO)).collect();
        let open = |k: &usize| f.depends_on(Var(*k));
        if (0..known.len()).filter(open).any(|k| self.values[k].is_none()) {
            return None;
        }
        Some((f.eval(&known)?, spread(f, &known, &self.errors)?))
    }

    /// Puts in what was typed for one name.
    fn assign(&mut self, role: Role, typed: &Given<'_>) {
        let family = self.family;
        let Some(parameter) = role.find(typed.name, family) else { return self.unknown(role, typed) };
        let (var, value) = (parameter.var, typed.value);
        let tangent = name::position(typed.name, &role.names(family)).is_none();
        // The part of the way between the ends of a range has a name, too.
        let scaled = tangent && is_tangent(typed.name, family, parameter);
        let name = match family.analytic.angle(var) {
            Some(angle) if scaled => &angle.tangent_name(),
            _ if tangent => &parameter.name,
            _ => written(family, parameter),
        };
        if self.values[var.0].is_some() {
            let message = format!("the {} `{name}` is given twice", role.noun());
            let help = match role {
                Role::Shape => "give it one value; several are written in steps, as in --shape λ=0..1:1/4",
                Role::At => "give it one value",
            };
            self.found.push(error(message).help(help));
            return;
        }
        self.typed[var.0] = Some(format!("{name} = {value}"));
        let inner = match family.analytic.angle(var) {
            None => Some((value.value(), value.error())),
            Some(angle) if scaled => {
                let known = self.part_of_range(angle, &value.value(), &value.error());
                if let Some((y, _)) = &known {
                    self.itself(angle, y);
                }
                known
            }
            Some(angle) if tangent => {
                let known = value.value();
                self.itself(angle, &known);
                Some((known, value.error()))
            }
            Some(angle) => self.inner(angle, value),
        };
        let range = match role {
            Role::At => domain::describe(self.whole),
            Role::Shape if tangent => parameter.range.display(&parameter.name).to_string(),
            Role::Shape => family.declared(parameter),
        };
        // The tangent of an angle is the one of the angle less a half turn, too.
        let branch = family.analytic.angle(var).filter(|angle| angle.kind == Kind::Circular && !tangent);
        let principal = branch.is_none_or(|angle| {
            value.phase(&angle.rate, angle.turns, &angle.shift).is_within_a_quarter_turn()
        });
        let inside = principal
            && inner.as_ref().is_some_and(|(x, error)| {
                [x.clone(), x + error, x - error].iter().any(|x| parameter.range.contains(x))
            });
        // Where the domain ends at a shape parameter with a wrong value, or without one, that is the mistake.
        let follows = role == Role::At
            && family.analytic.angle(var).is_some_and(|angle| {
                !self.found.is_empty() || [&angle.low, &angle.width].iter().any(|f| self.known(f).is_none())
            });
        if !follows && (inner.is_none() || !inside && !self.anyway) {
            let message = match family.analytic.angle(var).map(|angle| angle.kind) {
                Some(Kind::Hyperbolic) if inner.is_none() && !tangent => {
                    format!("{name} = {value} is too large: exponentials are evaluated up to exp(1000)")
                }
                Some(Kind::Circular) if inner.is_none() && self.anyway && !tangent => format!(
                    "{name} = {value} has no value: sines are evaluated in the tangent of a part of the angle, which is infinite there"
                ),
                _ => format!("{name} = {value} is outside of the {} `{range}`", role.place()),
            };
            let choice = match family.analytic.angle(var) {
                Some(_) if !tangent && self.anyway => String::from("choose another value"),
                Some(_) if !tangent => String::from("choose a value inside"),
                _ => format!("choose a value inside: {} {name}={}", role.flag(), inside_of(parameter)),
            };
            let anyway = if inner.is_some() { "; --anyway evaluates outside as well" } else { "" };
            self.found.push(error(message).help(format!("{choice}{anyway}")));
        }
        let (value, error) = inner.unwrap_or((Rational::ZERO, Rational::ZERO));
        self.set(var, value, error);
    }

    /// The variable y that stands for an angle, and the angle itself; `None` where it has no tangent.
    fn inner(&mut self, angle: &Angle, value: &Number) -> Option<(Rational, Rational)> {
        let phase = value.phase(&angle.rate, angle.turns, &angle.shift);
        let (x, error) = match angle.kind {
            Kind::Circular => phase.tan()?,
            Kind::Hyperbolic => phase.tanh()?,
            Kind::Linear => (value.value(), value.error()),
        };
        self.set(angle.itself, value.value(), value.error());
        self.part_of_range(angle, &x, &error)
    }

    /// y of an angle with the tangent x, and how far it is at most from the one that is meant.
    fn part_of_range(&self, angle: &Angle, x: &Rational, error: &Rational) -> Option<(Rational, Rational)> {
        let ((low, of_low), (width, of_width)) = (self.known(&angle.low)?, self.known(&angle.width)?);
        let y = (x - &low).checked_div(&width)?;
        let sum = &(error + &of_low) + &(&y.abs() * &of_width);
        Some((y, sum.checked_div(&width.abs())?))
    }

    /// The angle of which y is given.
    fn itself(&mut self, angle: &Angle, y: &Rational) {
        let (Some((low, _)), Some((width, _))) = (self.known(&angle.low), self.known(&angle.width)) else {
            return;
        };
        let x = &low + &(&width * y);
        if angle.kind == Kind::Linear {
            return self.set(angle.itself, x, Rational::ZERO);
        }
        let hyperbolic = angle.kind == Kind::Hyperbolic;
        let Some(phase) = number::inverse(&x, hyperbolic) else { return };
        let shift = if angle.turns { angle.shift.clone() } else { &angle.shift * &number::pi() };
        let rate = if angle.turns { &angle.rate * &number::pi() } else { angle.rate.clone() };
        if let Some(s) = phase.checked_div(&rate) {
            let sum = &s + &shift;
            let error = &(&s.abs() + &shift.abs()) * &number::precision();
            self.set(angle.itself, sum, error);
        }
    }

    /// What is assumed of the shape parameters holds.
    fn assumed(&mut self) {
        if self.anyway || !self.found.is_empty() {
            return;
        }
        let family = self.family;
        let broken = family.assumed().find(|constraint| {
            let known = self.known(&Fraction::from(constraint.value.clone()));
            known.is_some_and(|(value, _)| !constraint.relation.holds(&value))
        });
        let Some(broken) = broken else { return };
        let given = family.shapes.iter().filter(|p| broken.value.depends_on(p.var));
        let given: Vec<&str> = given.filter_map(|p| self.typed[p.var.0].as_deref()).collect();
        let message = format!("{} is outside of what is assumed: `{}`", given.join(", "), broken.text);
        let help = "choose values that satisfy it; --anyway evaluates outside as well";
        self.found.push(error(message).help(help));
    }

    /// A name that the family does not have, and what is probably meant.
    fn unknown(&mut self, role: Role, typed: &Given<'_>) {
        let Given { name, value } = typed;
        if role == Role::Shape
            && let Some((name, by)) = self.family.determined.iter().find(|(n, _)| n == name)
        {
            let family = self.family;
            let value = by.display(&family.names);
            self.meant
                .extend(family.shapes.iter().filter(|p| by.depends_on(p.var)).map(|p| written(family, p)));
            let message = format!("`{name}` follows from the other shape parameters");
            self.found.push(error(message).help(format!("give those instead: `{name}` is {value}")));
            return;
        }
        let (own, others) = (role.names(self.family), role.other().names(self.family));
        let (noun, other) = (role.noun(), role.other());
        let misplaced = name::position(name, &others).map(|k| others[k]);
        let open = role.parameters(self.family).into_iter().filter(|p| self.values[p.var.0].is_none());
        let open: Vec<&str> = open.map(|p| written(self.family, p)).collect();
        let near = name::closest(name, &open);
        // A name that is like none may have been meant for any.
        match misplaced.or(near) {
            Some(meant) => self.meant.push(meant),
            None => self.meant.extend(&own),
        }
        // A multiple of an angle of which no tangent is known.
        let angles =
            role.parameters(self.family).into_iter().filter_map(|p| self.family.analytic.angle(p.var));
        let angle = angles.filter(|_| name.starts_with("tan")).find(|angle| {
            let words = name.split(|c: char| !c.is_alphanumeric() && c != '_');
            words.into_iter().any(|word| name::position(word, &[&angle.name]).is_some())
        });
        let in_its_tangent = |angle: &Angle| {
            let (flag, name, tangent) = (role.flag(), &angle.name, angle.tangent_name());
            format!("write {flag} {name}=…, or {flag} '{tangent}=…'")
        };
        let help = match (misplaced, near, own.as_slice()) {
            _ if angle.is_some() => angle.map(in_its_tangent).unwrap_or_default(),
            (Some(meant), ..) => format!("it is a {}: write {} {meant}={value}", other.noun(), other.flag()),
            (_, Some(near), _) => format!("did you mean `{near}`?"),
            (_, _, []) => format!("the family has no {noun}s"),
            (_, _, [only]) => format!("the only {noun} is `{only}`"),
            (_, _, several) => format!("the {noun}s are {}", name::list(several)),
        };
        let message = format!("`{name}` is not a {noun} of `{}`", self.family.title());
        self.found.push(error(message).help(help));
    }

    /// On a simplex the barycentric coordinates are not negative and sum to 1; one of them may be left out.
    fn complete(&mut self, factor: Factor<'_>) {
        let Factor::Simplex(..) = factor else { return };
        let family = self.family;
        let own: Vec<&Parameter> = family.domain_variables().filter(|p| contains(factor, p)).collect();
        let (given, missing): (Vec<&Parameter>, Vec<&Parameter>) =
            own.iter().partition(|p| self.values[p.var.0].is_some());
        let mut rest = Rational::ONE;
        for value in given.iter().filter_map(|p| self.values[p.var.0].as_ref()) {
            rest -= value;
        }
        let names: Vec<&str> = own.iter().map(|p| p.name.as_str()).collect();
        let sum = names.join(" + ");
        match missing.as_slice() {
            [] if !rest.is_zero() => {
                let message = format!(
                    "{sum} = {} on the domain `{}`",
                    &Rational::ONE - &rest,
                    domain::describe(family)
                );
                let last = names.last().copied().unwrap_or_default();
                let help = format!(
                    "barycentric coordinates sum to 1; leave out {last}, which follows from the others"
                );
                self.found.push(error(message).help(help));
            }
            [last] if !self.meant.contains(&last.name.as_str()) => {
                if rest.is_negative() && self.found.is_empty() && !self.anyway {
                    let message = format!(
                        "{} = {rest} is outside of the domain `{}`",
                        last.name,
                        domain::describe(family)
                    );
                    let help = format!("no barycentric coordinate is negative, and {sum} = 1");
                    self.found.push(error(message).help(help));
                }
                self.set(last.var, rest, Rational::ZERO);
            }
            _ => {}
        }
    }

    /// The parameters without a value.
    fn miss(&mut self, role: Role) {
        let family = self.family;
        let mut missing = role.parameters(family);
        missing.retain(|p| self.values[p.var.0].is_none());
        let mut barycentric: Vec<&str> = Vec::new();
        for factor in family.factors().into_iter().filter(|_| role == Role::At) {
            if let Factor::Simplex(..) = factor {
                // One coordinate follows from the others.
                let last = missing.iter().rposition(|p| contains(factor, p));
                last.map(|k| missing.remove(k));
                barycentric.extend(factor.variables().map(|p| p.name.as_str()));
            }
        }
        for parameter in missing.into_iter().filter(|p| !self.meant.contains(&written(family, p))) {
            let (flag, noun, name) = (role.flag(), role.noun(), written(family, parameter));
            let help = if barycentric.contains(&parameter.name.as_str()) {
                format!("add {flag} {name}=…; one of the barycentric coordinates may be left out")
            } else if family.analytic.angle(parameter.var).is_some() {
                format!("add {flag} {name}=…, a value with `{}`", self.whole.declared(parameter))
            } else {
                let range = self.whole.declared(parameter);
                format!("add {flag} {name}={}, or another value with `{range}`", inside_of(parameter))
            };
            self.found.push(error(format!("the {noun} `{name}` has no value")).help(help));
        }
    }
}

/// Whether a domain variable belongs to a factor.
fn contains(factor: Factor<'_>, parameter: &Parameter) -> bool {
    factor.variables().any(|p| p.var == parameter.var)
}

/// A simple number inside a range.
pub(crate) fn inside_of(parameter: &Parameter) -> Rational {
    let range = &parameter.range;
    let middle = range.finite().map(|(low, high)| &(low + high) * &Rational::new(1, 2));
    let near = |end: Option<&Rational>, step: i64| end.map(|e| e + &Rational::from(step));
    let candidates = [
        Some(Rational::new(1, 2)),
        Some(Rational::ONE),
        Some(Rational::ZERO),
        middle,
        near(range.low.value(), 1),
        near(range.high.value(), -1),
    ];
    candidates.into_iter().flatten().find(|x| range.contains(x)).unwrap_or(Rational::ZERO)
}
