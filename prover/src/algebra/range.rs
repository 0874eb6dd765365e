//! The kernel's ranges, and how they are written.

use core::fmt;

pub use basis_kernel::algebra::range::{End, Range, Region};

/// Ranges as text.
pub trait DisplayRange {
    /// The range as a chain of inequalities, such as `-3 <= λ < 1`; only the name when there is no end.
    fn display<'a>(&'a self, name: &'a str) -> impl fmt::Display + 'a;
}

impl DisplayRange for Range {
    fn display<'a>(&'a self, name: &'a str) -> impl fmt::Display + 'a {
        Shown { range: self, name }
    }
}

struct Shown<'a> {
    range: &'a Range,
    name: &'a str,
}

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = |end: &End| if end.is_included() { "<=" } else { "<" };
        if let Some(v) = self.range.low.value() {
            write!(f, "{v} {} ", sign(&self.range.low))?;
        }
        write!(f, "{}", self.name)?;
        if let Some(v) = self.range.high.value() {
            write!(f, " {} {v}", sign(&self.range.high))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::rational::Rational;

    #[test]
    fn chains_of_inequalities() {
        let range = |low, high| Range { low, high }.display("λ").to_string();
        let x = |x: i64| Rational::from(x);
        assert_eq!(range(End::Included(x(-3)), End::Excluded(x(1))), "-3 <= λ < 1");
        assert_eq!(range(End::Infinite, End::Included(x(1))), "λ <= 1");
        assert_eq!(range(End::Infinite, End::Infinite), "λ");
    }
}
