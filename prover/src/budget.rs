//! How much work a decision may take.

use super::Method;
use crate::algebra::work::Work;

/// Units of work for one decision: about a second of an unoptimised build.
const UNITS: u64 = 5_000_000;

/// The work that a decision may still do, counted in operations and never in time, so that one claim gets one
/// verdict on every machine.
#[derive(Clone, Debug)]
pub struct Budget {
    pub(crate) work: Work,
    /// Methods that are left out: how the tests compare the later steps of the cascade with the earlier ones.
    disabled: Vec<Method>,
}

impl Default for Budget {
    fn default() -> Self {
        Self::scaled(1)
    }
}

impl Budget {
    /// The usual work times a factor.
    pub fn scaled(factor: u32) -> Self {
        Self { work: Work::new(UNITS.saturating_mul(u64::from(factor))), disabled: Vec::new() }
    }

    /// The same without one of the methods; what the others cannot decide is undecided.
    pub fn without(mut self, method: Method) -> Self {
        self.disabled.push(method);
        self
    }

    /// Whether a method may be used.
    pub(super) fn allows(&self, method: Method) -> bool {
        !self.disabled.contains(&method)
    }

    /// The units that are left.
    pub const fn left(&self) -> u64 {
        self.work.left()
    }

    /// Takes out a part for a method that may fail.
    pub(super) fn take(&mut self, units: u64) -> Self {
        let part = self.left().min(units);
        let _ = self.work.spend(part);
        Self { work: Work::new(part), disabled: self.disabled.clone() }
    }

    /// Puts back what a part has left over.
    pub(super) fn put_back(&mut self, part: &Self) {
        self.work = Work::new(self.left().saturating_add(part.left()));
    }
}
