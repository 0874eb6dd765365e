//! How much work a decision may take.

use core::cell::Cell;

use crate::algebra::work::{Work, done};
use crate::method::Method;

/// What a decision takes beside the work that is counted: its statement is made, checked and kept.
const DECISION: u64 = 1_500;

/// Units of work for one decision: about a second of an unoptimised build.
const UNITS: u64 = 5_000_000;

/// The work that a decision may still do, counted in operations and never in time, so that one claim gets one
/// verdict on every machine.
#[derive(Debug)]
pub struct Budget {
    pub(crate) work: Work,
    /// Methods that are left out: how the tests compare the later steps of the cascade with the earlier ones.
    disabled: Vec<Method>,
    /// What there was at the beginning; 0 for a part, which counts with the whole.
    units: u64,
    /// Whether this was less than usual, for the sake of the work within which it is done.
    is_short: bool,
}

thread_local! {
    /// The units of all decisions so far. Nothing depends on it but the difference over a claim.
    static SPENT: Cell<u64> = const { Cell::new(0) };
    /// What may be spent on this thread before `within` ends.
    static CEILING: Cell<u64> = const { Cell::new(u64::MAX) };
    /// The units of the innermost `within`.
    static SHARE: Cell<u64> = const { Cell::new(u64::MAX) };
    /// How many decisions the ceilings have cut short.
    static CUTS: Cell<u64> = const { Cell::new(0) };
    /// Whether the innermost `working` has less work than usual.
    static IS_SHORT: Cell<bool> = const { Cell::new(false) };
}

/// How many times its share of the work a claim may take in one check of a proof that was found.
const CHECKS: u64 = 4;

/// The units that all decisions on this thread have taken so far: what one claim takes is the difference.
pub fn spent() -> u64 {
    SPENT.get()
}

/// Counts work that has no budget of its own: that of the kernel, and what a search is prepared with.
pub fn charge(units: u64) {
    SPENT.set(SPENT.get().saturating_add(units));
}

/// Does work that has no budget of its own, such as values at many points, and counts it; `None`, and nothing is done, where the
/// innermost `within` has nothing left.
pub fn charged<T>(work: &mut dyn FnMut() -> T) -> Option<T> {
    if SPENT.get() >= CEILING.get() {
        CUTS.set(CUTS.get() + 1);
        return None;
    }
    let operations = done();
    let result = work();
    charge(done() - operations);
    Some(result)
}

/// Counts a decision.
pub(crate) fn begin() {
    charge(DECISION);
}

/// Does work, with the units that it takes: those that are counted for it, or those that its operations have taken where these
/// are more, as formulas are expanded before there is anything to decide.
pub fn measured<T>(work: &mut dyn FnMut() -> T) -> (T, u64) {
    let (counted, operations) = (spent(), done());
    let result = work();
    (result, (spent() - counted).max(done() - operations))
}

/// Does work whose budgets together have these units, however many decisions it consists of.
///
/// A claim about spans, or one that takes enclosures of a sine, is decided in many parts, and each of them has a budget
/// of its own.
pub fn within<T>(units: u64, work: &mut dyn FnMut() -> T) -> T {
    let outer = (CEILING.get(), SHARE.get(), CUTS.get());
    let own = spent().saturating_add(units);
    CEILING.set(outer.0.min(own));
    SHARE.set(outer.1.min(units));
    let result = work();
    CEILING.set(outer.0);
    SHARE.set(outer.1);
    if own < outer.0 {
        // What these units cut short is the same whatever there is around them.
        CUTS.set(outer.2);
    }
    result
}

/// Does work with half of the units that are left, so that something else can follow.
pub fn within_half<T>(work: &mut dyn FnMut() -> T) -> T {
    let outer = CEILING.get();
    let left = outer.saturating_sub(spent());
    CEILING.set(outer - left / 2);
    let result = work();
    CEILING.set(outer);
    result
}

/// The same as [`within`], and whether anything went without work that it would have had alone: if so, with more units something else may
/// come out.
pub fn cut_short_within<T>(units: u64, work: &mut dyn FnMut() -> T) -> (T, bool) {
    let mut cuts = 0;
    let result = within(units, &mut || {
        let before = CUTS.get();
        let result = work();
        cuts = CUTS.get() - before;
        result
    });
    (result, cuts > 0)
}

/// The work for checking a proof that was found, with `budget` times the usual work.
pub(crate) fn checking(budget: u32) -> Work {
    Work::new(Work::usual(budget).left().min(SHARE.get().saturating_mul(CHECKS)))
}

/// Counts a check that was refused for want of work, with the units that its operations have taken. It ends when something is
/// more than what is left, of which nothing is done.
pub(crate) fn charge_refused(units: u64) {
    if SHARE.get() < u64::MAX {
        CUTS.set(CUTS.get() + 1);
    }
    charge(units.min(SHARE.get()));
}

/// Does work that belongs to a decision, such as expanding what is to be decided, with `budget` times the usual work.
pub fn working<T>(budget: u32, work: &mut dyn FnMut(&mut Work) -> T) -> T {
    working_on(Budget::scaled(budget), work)
}

/// The same with a number of units, whatever the budget is.
pub fn working_with<T>(units: u64, work: &mut dyn FnMut(&mut Work) -> T) -> T {
    working_on(Budget::of(units), work)
}

fn working_on<T>(mut budget: Budget, work: &mut dyn FnMut(&mut Work) -> T) -> T {
    let outer = IS_SHORT.replace(budget.is_short);
    let result = work(&mut budget.work);
    IS_SHORT.set(outer);
    result
}

/// Counts that something is done less often than it may be because of the work that is left: with the usual work it may come
/// to something else, although nothing is asked for that is not there.
pub fn done_less_often() {
    if IS_SHORT.get() {
        CUTS.set(CUTS.get() + 1);
    }
}

impl Drop for Budget {
    fn drop(&mut self) {
        SPENT.set(SPENT.get() + self.units.saturating_sub(self.work.left()));
        // After a request for more than is left, nothing is left.
        if self.is_short && self.work.left() == 0 {
            CUTS.set(CUTS.get() + 1);
        }
    }
}

impl Default for Budget {
    fn default() -> Self {
        Self::scaled(1)
    }
}

impl Budget {
    /// The usual work times a factor, or what is left of the work within which it is done.
    pub fn scaled(factor: u32) -> Self {
        Self::of(UNITS.saturating_mul(u64::from(factor)))
    }

    fn of(usual: u64) -> Self {
        let units = usual.min(CEILING.get().saturating_sub(spent()));
        Self { work: Work::new(units), disabled: Vec::new(), units, is_short: units < usual }
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

    /// Takes out a number of units for a method that may fail, or all that is left.
    pub(super) fn take(&mut self, units: u64) -> Self {
        let part = self.left().min(units);
        self.part(part, part < units)
    }

    /// The same with some of sixteen parts of what is left: of less than usual it is less.
    pub(super) fn take_sixteenths(&mut self, parts: u64) -> Self {
        self.part(self.left() / 16 * parts, true)
    }

    /// A part counts as cut short when it is used up, if the whole has less than usual and therefore the part.
    fn part(&mut self, units: u64, depends_on_the_whole: bool) -> Self {
        let _ = self.work.spend(units);
        let is_short = self.is_short && depends_on_the_whole;
        Self { work: Work::new(units), disabled: self.disabled.clone(), units: 0, is_short }
    }

    /// Whether there is as much work left as something takes at least. Of less than usual it counts if there is not.
    pub(super) fn suffices(&self, units: u64) -> bool {
        let suffices = units <= self.left();
        if !suffices && self.is_short {
            CUTS.set(CUTS.get() + 1);
        }
        suffices
    }

    /// Puts back what a part has left over.
    pub(super) fn put_back(&mut self, part: &Self) {
        self.work = Work::new(self.left().saturating_add(part.left()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether something that uses up a part of a budget counts as cut short within some units.
    fn is_cut(units: u64, part: fn(&mut Budget) -> Budget) -> bool {
        let mut work = || {
            let mut budget = Budget::default();
            let mut part = part(&mut budget);
            let units = part.left();
            assert!(part.work.spend(units + 1).is_none());
            budget.put_back(&part);
        };
        cut_short_within(units, &mut work).1
    }

    #[test]
    fn parts_of_a_short_budget_are_short() {
        let quarter = |budget: &mut Budget| budget.take_sixteenths(4);
        assert!(is_cut(UNITS / 2, quarter));
        assert!(!is_cut(2 * UNITS, quarter));
        assert!(is_cut(UNITS / 2, |budget| budget.take_sixteenths(8).take_sixteenths(8)));
    }

    /// What a number of units is not enough for, they are not enough for with all the work there is.
    #[test]
    fn parts_of_fixed_size_are_short_where_there_is_less() {
        let some = |budget: &mut Budget| budget.take(50_000);
        assert!(is_cut(40_000, some));
        assert!(!is_cut(60_000, some));
    }

    #[test]
    fn what_is_done_less_often_counts_where_work_is_short() {
        let is_cut = |units: u64| cut_short_within(units, &mut || working(1, &mut |_| done_less_often())).1;
        assert!(is_cut(UNITS / 2));
        assert!(!is_cut(2 * UNITS));
        assert!(cut_short_within(10, &mut || working_with(20, &mut |work| work.spend(15))).1);
        assert!(!cut_short_within(30, &mut || working_with(20, &mut |work| work.spend(25))).1);
    }
}
