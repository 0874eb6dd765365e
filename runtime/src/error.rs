//! The one error of this crate: a shape parameter outside its declared range.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A shape parameter was given a value outside its declared range, for which nothing is proved.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() {
/// let error = QuarticBernstein::new(2.0).unwrap_err();
/// assert_eq!(error.parameter(), "λ");
/// assert_eq!(error.to_string(), "QuarticBernstein: λ = 2 is outside the declared range -3 <= λ <= 1");
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeError {
    family: &'static str,
    parameter: &'static str,
    value: f64,
    range: &'static str,
}

impl ShapeError {
    #[cold]
    pub(crate) fn new(
        family: &'static str,
        parameter: &'static str,
        value: f64,
        range: &'static str,
    ) -> Self {
        Self { family, parameter, value, range }
    }

    /// The name of the family.
    pub fn family(&self) -> &'static str {
        self.family
    }

    /// The name of the shape parameter, as the spec writes it.
    pub fn parameter(&self) -> &'static str {
        self.parameter
    }

    /// The value that was refused.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The declared range, as the spec writes it, for example `-3 <= λ <= 1`.
    pub fn range(&self) -> &'static str {
        self.range
    }
}

impl Display for ShapeError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { family, parameter, value, range } = *self;
        if value.is_nan() {
            write!(f, "{family}: {parameter} is not a number; the declared range is {range}")
        } else if value.is_infinite() {
            write!(f, "{family}: {parameter} = {value} is not finite; the declared range is {range}")
        } else if value == 0.0 || (1e-5..1e16).contains(&value.abs()) {
            write!(f, "{family}: {parameter} = {value} is outside the declared range {range}")
        } else {
            write!(f, "{family}: {parameter} = {value:e} is outside the declared range {range}")
        }
    }
}

impl Error for ShapeError {}
