//! The values that a command gives, checked against the declared ranges.

use basis_engine::algebra::range::DisplayRange as _;
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};

use crate::args::Assignment;
use crate::domain;
use crate::name;
use crate::output::error;

/// A value for each shape parameter and each domain variable, by variable.
///
/// # Errors
/// Every name that is unknown, doubled or missing, and every value outside of its range.
pub(super) fn values(
    family: &Family,
    shapes: &[Assignment],
    at: &[Assignment],
) -> Result<Vec<Rational>, Vec<Diagnostic>> {
    let mut table =
        Table { family, values: vec![None; family.names.len()], meant: Vec::new(), errors: Vec::new() };
    for (role, given) in [(Role::Shape, shapes), (Role::At, at)] {
        for assignment in given {
            table.assign(role, assignment);
        }
    }
    if family.is_simplex() {
        table.complete();
    }
    table.miss(Role::Shape);
    table.miss(Role::At);
    let Table { values, errors, .. } = table;
    if errors.is_empty() {
        // Every variable is a shape parameter or a domain variable, and none is missing.
        Ok(values.into_iter().flatten().collect())
    } else {
        Err(errors)
    }
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

    /// What its values must lie in.
    const fn place(self) -> &'static str {
        match self {
            Self::Shape => "declared range",
            Self::At => "domain",
        }
    }

    fn names(self, family: &Family) -> Vec<&str> {
        self.parameters(family).into_iter().map(|p| p.name.as_str()).collect()
    }

    const fn other(self) -> Self {
        match self {
            Self::Shape => Self::At,
            Self::At => Self::Shape,
        }
    }
}

/// The point as far as it is given.
struct Table<'f> {
    family: &'f Family,
    /// By variable.
    values: Vec<Option<Rational>>,
    /// Names without a value that were probably meant where another name was typed.
    meant: Vec<&'f str>,
    errors: Vec<Diagnostic>,
}

impl Table<'_> {
    /// Puts in what was typed for one name.
    fn assign(&mut self, role: Role, typed: &Assignment) {
        let parameters = role.parameters(self.family);
        let names = role.names(self.family);
        let Some(parameter) = name::position(&typed.name, &names).map(|k| parameters[k]) else {
            return self.unknown(role, typed);
        };
        let (name, value) = (&parameter.name, &typed.value);
        let slot = &mut self.values[parameter.var.0];
        if slot.is_some() {
            let message = format!("the {} `{name}` is given twice", role.noun());
            self.errors.push(error(message).help("give it one value"));
        } else if !parameter.range.contains(value) {
            let range = match role {
                Role::At => domain::describe(self.family),
                Role::Shape => parameter.range.display(name).to_string(),
            };
            let message = format!("{name} = {value} is outside of the {} `{range}`", role.place());
            let help = format!("choose a value inside: {} {name}={}", role.flag(), inside(parameter));
            self.errors.push(error(message).help(help));
        }
        *slot = Some(value.clone());
    }

    /// A name that the family does not have, and what is probably meant.
    fn unknown(&mut self, role: Role, typed: &Assignment) {
        let Assignment { name, value } = typed;
        let (own, others) = (role.names(self.family), role.other().names(self.family));
        let (noun, other) = (role.noun(), role.other());
        let misplaced = name::position(name, &others).map(|k| others[k]);
        let near = name::closest(name, &own);
        self.meant.extend(misplaced.or(near));
        let help = match (misplaced, near, own.as_slice()) {
            (Some(meant), ..) => format!("it is a {}: write {} {meant}={value}", other.noun(), other.flag()),
            (_, Some(near), _) => format!("did you mean `{near}`?"),
            (_, _, []) => format!("the family has no {noun}s"),
            (_, _, [only]) => format!("the only {noun} is `{only}`"),
            (_, _, several) => format!("the {noun}s are {}", name::list(several)),
        };
        let message = format!("`{name}` is not a {noun} of `{}`", self.family.title());
        self.errors.push(error(message).help(help));
    }

    /// On a simplex the barycentric coordinates are not negative and sum to 1; one of them may be left out.
    fn complete(&mut self) {
        let family = self.family;
        let (given, missing): (Vec<&Parameter>, Vec<&Parameter>) =
            family.domain_variables().partition(|p| self.values[p.var.0].is_some());
        let mut rest = Rational::ONE;
        for value in given.iter().filter_map(|p| self.values[p.var.0].as_ref()) {
            rest -= value;
        }
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
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
                self.errors.push(error(message).help(help));
            }
            [last] if !self.meant.contains(&last.name.as_str()) => {
                if rest.is_negative() && self.errors.is_empty() {
                    let message = format!(
                        "{} = {rest} is outside of the domain `{}`",
                        last.name,
                        domain::describe(family)
                    );
                    let help = format!("no barycentric coordinate is negative, and {sum} = 1");
                    self.errors.push(error(message).help(help));
                }
                self.values[last.var.0] = Some(rest);
            }
            _ => {}
        }
    }

    /// The parameters without a value.
    fn miss(&mut self, role: Role) {
        let mut missing = role.parameters(self.family);
        missing.retain(|p| self.values[p.var.0].is_none());
        let free = role == Role::At && self.family.is_simplex();
        if free {
            // One coordinate follows from the others.
            missing.pop();
        }
        for parameter in missing.into_iter().filter(|p| !self.meant.contains(&p.name.as_str())) {
            let (flag, noun, name) = (role.flag(), role.noun(), &parameter.name);
            let help = if free {
                format!("add {flag} {name}=…; one of the barycentric coordinates may be left out")
            } else {
                let range = parameter.range.display(name);
                format!("add {flag} {name}={}, or another value with `{range}`", inside(parameter))
            };
            self.errors.push(error(format!("the {noun} `{name}` has no value")).help(help));
        }
    }
}

/// A simple number inside a range.
pub(crate) fn inside(parameter: &Parameter) -> Rational {
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
