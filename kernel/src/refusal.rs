//! Why the checker does not accept something.

use core::fmt;

/// Why a certificate or a counterexample is not accepted. It does not say that the statement is false, or true.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Refusal {
    /// Checking takes more work than is allowed.
    Spent,
    /// It does not have the form that it must have for the statement.
    Unfit(&'static str),
    /// It has the right form, but a step of it does not hold.
    Unproved(&'static str),
    /// The interval of an irrational number is too wide for a sign to be seen.
    Vague,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Spent => f.write_str("it takes more work to check than the budget of the spec allows"),
            Self::Vague => f.write_str("the sign of a value is not seen in the interval of the root"),
            Self::Unfit(reason) | Self::Unproved(reason) => f.write_str(reason),
        }
    }
}

impl core::error::Error for Refusal {}

/// An error unless the form is right.
pub(crate) fn fits(holds: bool, reason: &'static str) -> Result<(), Refusal> {
    if holds { Ok(()) } else { Err(Refusal::Unfit(reason)) }
}

/// An error unless a step holds.
pub(crate) fn shown(holds: bool, reason: &'static str) -> Result<(), Refusal> {
    if holds { Ok(()) } else { Err(Refusal::Unproved(reason)) }
}
