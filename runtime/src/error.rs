//! The errors of this crate: a shape parameter outside its declared range, a wrong number of control points.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::Array;

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
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// A slice holds another number of control points than a family has functions.
///
/// ```
/// use basis_runtime::{TriangularPatch, basis};
///
/// basis! { family Plane { domain triangle (u, v, w); b[0] = u; b[1] = v; b[2] = w; } }
/// # fn main() {
/// let error = TriangularPatch::from_slice(Plane::new(), &[[0.0, 1.0], [2.0, 3.0]]).unwrap_err();
/// assert_eq!((error.expected(), error.found()), (3, 2));
/// assert_eq!(error.to_string(), "Plane has 3 functions, so it needs 3 control points, not 2");
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountError {
    family: &'static str,
    expected: usize,
    found: usize,
}

impl CountError {
    #[cold]
    pub(crate) fn new(family: &'static str, expected: usize, found: usize) -> Self {
        Self { family, expected, found }
    }

    /// The elements of a slice, one for each function of a family.
    pub(crate) fn one_each<T: Copy, A: Array<T>>(family: &'static str, elements: &[T]) -> Result<A, Self> {
        if elements.len() != A::LEN {
            return Err(Self::new(family, A::LEN, elements.len()));
        }
        Ok(A::from_fn(|i| elements[i]))
    }

    /// The name of the family.
    pub fn family(&self) -> &'static str {
        self.family
    }

    /// The number of functions of the family.
    pub fn expected(&self) -> usize {
        self.expected
    }

    /// The number of control points that were given.
    pub fn found(&self) -> usize {
        self.found
    }
}

impl Display for CountError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { family, expected, found } = *self;
        write!(f, "{family} has {expected} functions, so it needs {expected} control points, not {found}")
    }
}

impl Error for CountError {}
