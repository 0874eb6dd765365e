//! The points at which a family is evaluated.

use std::rc::Rc;

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Var;
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};

use super::assign::{self, Given, Known};
use crate::args::Axis;
use crate::domain;
use crate::name;
use crate::output::error;

/// More points than this are refused.
const MAX_POINTS: usize = 100_000;

/// What the options give values to: combinations of names with one value each.
#[derive(Debug)]
pub(super) struct Combination<'a> {
    /// Each name with its value.
    pub(super) given: Vec<Given<'a>>,
    /// Whether values in steps are among them, so that points outside of a triangle are left out.
    pub(super) stepped: bool,
}

/// All combinations of what stands for the names, the last name running fastest; with `repeat` a name that comes again
/// begins another point.
///
/// # Errors
/// There are too many.
pub(super) fn combinations<'a>(
    axes: &'a [Axis],
    names: &[&str],
    repeat: bool,
) -> Result<Vec<Combination<'a>>, Diagnostic> {
    let mut groups: Vec<Vec<&Axis>> = vec![Vec::new()];
    let same = |a: &Axis, b: &Axis| {
        a.name == b.name
            || name::position(&a.name, names).is_some_and(|k| Some(k) == name::position(&b.name, names))
    };
    for axis in axes {
        if repeat && groups.last().is_some_and(|group| group.iter().any(|known| same(known, axis))) {
            groups.push(Vec::new());
        }
        groups.last_mut().into_iter().for_each(|group| group.push(axis));
    }
    let mut all = Vec::new();
    for group in groups {
        let count = group.iter().try_fold(1_usize, |n, axis| n.checked_mul(axis.values.len()));
        let count = count.filter(|n| all.len() + n <= MAX_POINTS);
        let Some(count) = count else {
            return Err(
                error(format!("there are more than {MAX_POINTS} points")).help("choose a larger step")
            );
        };
        let stepped = group.iter().any(|axis| axis.stepped);
        for k in 0..count {
            let mut rest = k;
            let mut given = Vec::new();
            for axis in group.iter().rev() {
                let value = &axis.values[rest % axis.values.len()];
                rest /= axis.values.len();
                given.push(Given { name: &axis.name, value });
            }
            given.reverse();
            all.push(Combination { given, stepped });
        }
    }
    Ok(all)
}

/// A value for each shape parameter and each domain variable.
#[derive(Debug)]
pub(super) struct Point {
    /// The family, or the one on the span on which the point lies.
    pub(super) family: Rc<Family>,
    known: Known,
}

impl Point {
    /// The point that the options give; of a family on several spans on the last one that contains it, as in generated
    /// code, or with `anyway` next to it.
    ///
    /// # Errors
    /// As for [`assign::values`].
    pub(super) fn new(
        family: &Rc<Family>,
        shapes: &[Given<'_>],
        at: &[Given<'_>],
        anyway: bool,
    ) -> Result<Self, Vec<Diagnostic>> {
        let spans = if family.pieces.is_empty() { std::slice::from_ref(family) } else { &family.pieces };
        for piece in spans.iter().rev() {
            if let Ok(known) = assign::values(piece, family, shapes, at, false) {
                return Ok(Self { family: Rc::clone(piece), known });
            }
        }
        let Some(first) = spans.first() else { return Err(Vec::new()) };
        let known = assign::values(first, family, shapes, at, anyway)?;
        if let (Some(last), Some(var)) = (spans.last(), first.domain.first())
            && spans.len() > 1
            && var.range.low.value().is_some_and(|low| known.values[var.var.0] > *low)
        {
            let known = assign::values(last, family, shapes, at, anyway)?;
            return Ok(Self { family: Rc::clone(last), known });
        }
        Ok(Self { family: Rc::clone(first), known })
    }

    /// The span of several on which the point lies, such as `1 <= x <= 3`.
    pub(super) fn span(&self, whole: &Family) -> Option<String> {
        (!whole.pieces.is_empty()).then(|| domain::describe(&self.family))
    }

    /// All values, by variable.
    pub(super) fn values(&self) -> &[Rational] {
        &self.known.values
    }

    /// Whether the value of a function at the point is rounded.
    pub(super) fn is_rounded(&self, f: &Fraction) -> bool {
        (0..self.known.errors.len()).any(|k| !self.known.errors[k].is_zero() && f.depends_on(Var(k)))
    }

    /// The value of a function at the point: 0 where only the rounding errors of terms that cancel are left. `None` at a pole.
    pub(super) fn value(&self, f: &Fraction) -> Option<Rational> {
        let value = f.eval(self.values())?;
        // Larger values are far above the errors, which are not worth finding.
        let small = Rational::from(10).pow(20).recip()?;
        if value.is_zero() || value.abs() > small || !self.is_rounded(f) {
            return Some(value);
        }
        let spread = assign::spread(f, self.values(), &self.known.errors)?;
        Some(if value.abs() <= spread { Rational::ZERO } else { value })
    }

    /// The values of some parameters, such as `λ = 1/2, t = 1/3`.
    pub(super) fn describe<'p>(&self, parameters: impl Iterator<Item = &'p Parameter>) -> String {
        parameters.map(|p| self.assignment(p)).collect::<Vec<_>>().join(", ")
    }

    /// The value of a parameter, such as `λ = 1/2`.
    pub(super) fn assignment(&self, parameter: &Parameter) -> String {
        let known = || format!("{} = {}", parameter.name, self.known.values[parameter.var.0]);
        self.known.typed[parameter.var.0].clone().unwrap_or_else(known)
    }

    /// The name of a parameter and its value, as they are typed.
    pub(super) fn named(&self, parameter: &Parameter) -> (String, String) {
        let text = self.assignment(parameter);
        text.split_once(" = ").map(|(name, value)| (name.to_string(), value.to_string())).unwrap_or_default()
    }
}
