//! What is still to be decided before a formula is used.

use basis_kernel::Relation;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::range::{DisplayRange as _, End, Range};
use crate::algebra::rational::Rational;
use crate::diagnostic::{Diagnostic, Place};

/// Something to be decided before a formula is used.
#[derive(Clone, Debug)]
pub(crate) struct Pending {
    pub(crate) duty: Duty,
    pub(crate) place: Place,
}

/// What is to be decided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Duty {
    /// This stands below a fraction line.
    Nonzero(Poly),
    /// This value of a parameter stays in its range.
    Inside(Inside),
    /// The shape values of another family satisfy what it assumes.
    Holds(Condition),
}

/// What another family assumes, about the values that its parameters get here.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Condition {
    /// What has the sign.
    pub(crate) value: Fraction,
    pub(crate) relation: Relation,
    /// As the family has it.
    pub(crate) text: String,
    /// The family.
    pub(crate) family: String,
}

/// A value for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Inside {
    pub(crate) value: Fraction,
    /// The parameter.
    pub(crate) name: String,
    pub(crate) range: Range,
    /// The family that has the parameter, if it is another one.
    pub(crate) family: Option<String>,
    /// Whether `assume` can narrow the ranges, as in theorems.
    pub(crate) assumable: bool,
    /// Of an angle what is written, such as `t = pi/2`, and its range.
    pub(crate) written: Option<(String, String)>,
}

impl Inside {
    /// The error for a number that is not in the range.
    pub(crate) fn outside(&self, value: &Rational, place: Place) -> Diagnostic {
        let Self { name, range, .. } = self;
        let message = format!(
            "{name} = {value} is outside of the declared range `{}`{}",
            range.display(name),
            self.of()
        );
        let help = match &self.family {
            Some(family) => format!("choose a value inside, or widen the range in `{family}`"),
            None => String::from(
                "claims are about the declared ranges; widen the range, or choose a value inside",
            ),
        };
        Diagnostic::error(place, message).help(help)
    }

    /// What to do about a value, as it is shown, that goes beyond an end of the range.
    pub(crate) fn help(&self, shown: &str, end: &End, above: bool) -> String {
        if !self.assumable {
            return String::from("narrow the ranges so that the value stays inside");
        }
        let symbol = match (above, end.is_included()) {
            (true, true) => "<=",
            (true, false) => "<",
            (false, true) => ">=",
            (false, false) => ">",
        };
        let limit = end.value().map_or_else(String::new, |bound| format!("{shown} {symbol} {bound}"));
        match self.value.numer().variables().as_slice() {
            [var] if self.value == Fraction::var(*var) => format!("restrict the scalar: `assume {limit};`"),
            _ => format!("restrict the scalars, such as by `assume`, so that {limit}"),
        }
    }

    pub(crate) fn of(&self) -> String {
        self.family.as_ref().map_or_else(String::new, |family| format!(" of `{family}`"))
    }
}

impl Duty {
    /// The same about other functions; `None` when one of them becomes meaningless.
    pub(crate) fn replace(&self, with: &dyn Fn(&Fraction) -> Option<Fraction>) -> Option<Self> {
        match self {
            Self::Nonzero(p) => Some(Self::Nonzero(with(&Fraction::from(p.clone()))?.numer().clone())),
            Self::Holds(condition) => {
                Some(Self::Holds(Condition { value: with(&condition.value)?, ..condition.clone() }))
            }
            Self::Inside(inside) => {
                Some(Self::Inside(Inside { value: with(&inside.value)?, ..inside.clone() }))
            }
        }
    }
}
