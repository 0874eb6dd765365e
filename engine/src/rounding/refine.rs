//! Cells that are cut where a bound is the largest.
//!
//! A bound on the whole domain is the largest of those on cells, so that only the cell with the largest one is worth a
//! cut: in halves, along the variable that helps. On one without a bound any cut may help.

use super::cell::Cell;
use super::{Inputs, Part, Parts};
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// No more cells are made.
const MOST: usize = 32;

/// How often a cell without a bound is cut along each variable, one after the other.
const DEPTH: usize = 3;

/// A cut that leaves more than this many 256ths of a bound is not worth it.
const LEAST_GAIN: i64 = 255;

/// A cut that leaves fewer is taken without a look at other variables.
const GOOD_GAIN: i64 = 240;

/// Why there is no bound on a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Lack {
    /// There may be one on its parts.
    Here,
    /// There is a part of it without one, however it is cut.
    Everywhere,
}

/// The bound on a cell in u, with what it follows from.
pub(super) type OnCell<'f> = dyn FnMut(&Cell, &mut Work) -> Result<(Rational, Part), Lack> + 'f;

/// Whether this much work is left. Where it is not, more work may lead to another bound. That is told of: a claim is
/// then decided again with all the work there is for it, and says what explanations and emitted files say.
fn suffices(work: &Work, units: u64) -> bool {
    let suffices = work.left() >= units;
    if !suffices {
        basis_prover::done_less_often();
    }
    suffices
}

/// Tells of a part of the work that is spent, likewise.
pub(super) fn told_if_spent(part: &Work) {
    if part.left() == 0 {
        basis_prover::done_less_often();
    }
}

/// A cell with its bound.
struct Leaf {
    cell: Cell,
    found: Result<(Rational, Part), Lack>,
    /// How often it was cut.
    depth: usize,
    /// The work that its bound took.
    taken: u64,
}

impl Leaf {
    fn new(cell: Cell, depth: usize, on: &mut OnCell<'_>, work: &mut Work) -> Self {
        let before = work.left();
        let found = on(&cell, work);
        Self { cell, found, depth, taken: before - work.left() }
    }

    fn bound(&self) -> Option<&Rational> {
        self.found.as_ref().ok().map(|(bound, _)| bound)
    }

    /// Both halves along a variable, with bounds of at most `most` u, if there has to be one; `None` where there are
    /// none or the work is not enough for them.
    fn cut(
        &self,
        var: Var,
        most: Option<&Rational>,
        on: &mut OnCell<'_>,
        work: &mut Work,
    ) -> Option<[Self; 2]> {
        let mut half = |cell: Cell| {
            if !suffices(work, self.taken) {
                return None;
            }
            let half = Self::new(cell, self.depth + 1, on, work);
            let is_good = most.is_none_or(|most| half.bound().is_some_and(|own| own <= most));
            is_good.then_some(half)
        };
        let [low, high] = self.cell.halves(var)?;
        Some([half(low)?, half(high)?])
    }

    /// The cells in its place that are better; `None` where there are none.
    fn better(&self, along: &[Var], on: &mut OnCell<'_>, work: &mut Work) -> Option<Vec<Self>> {
        let turn = self.depth.checked_rem(along.len()).unwrap_or(0);
        let (before, after) = along.split_at(turn);
        let mut in_turn = after.iter().chain(before);
        let Some(bound) = self.bound() else {
            let is_cut = self.depth < DEPTH * along.len() && self.found.as_ref().err() == Some(&Lack::Here);
            return is_cut.then(|| in_turn.find_map(|var| self.cut(*var, None, on, work)))?.map(Vec::from);
        };
        if bound.is_zero() {
            return None;
        }
        let part = |of: i64| bound * &Rational::new(of, 256);
        let (mut most, mut best) = (part(LEAST_GAIN), None);
        for var in in_turn {
            let Some(halves) = self.cut(*var, Some(&most), on, work) else { continue };
            if let [Some(low), Some(high)] = halves.each_ref().map(Self::bound) {
                most = low.max(high).clone();
                best = Some(Vec::from(halves));
            }
            if most <= part(GOOD_GAIN) {
                return best;
            }
        }
        // A higher degree takes more work.
        if let Some(cell) = self.cell.raised().filter(|_| suffices(work, 4 * self.taken)) {
            let raised = Self::new(cell, self.depth, on, work);
            if raised.bound().is_some_and(|own| *own <= most) {
                best = Some(vec![raised]);
            }
        }
        best
    }
}

/// The bounds on cells of the ranges of all inputs; `None` if one of the cells has none. This share of the work may be
/// spent on smaller bounds, and all of it on one for each cell.
pub(super) fn refined(inputs: &Inputs, share: u64, work: &mut Work, on: &mut OnCell<'_>) -> Option<Parts> {
    // On simplices everything is homogeneous, and a cell next to 0 like all of them.
    let along = [&inputs.of_intervals[..], &inputs.shapes].concat();
    let mut share = Work::new(share.min(work.left()));
    let mut leaves = vec![Leaf::new(Cell::whole(&inputs.region, &inputs.simplices), 0, on, work)];
    while leaves.len() < MOST {
        let mut worst = 0;
        for (k, leaf) in leaves.iter().enumerate().skip(1) {
            let Some(bound) = leaves[worst].bound() else { break };
            if leaf.bound().is_none_or(|own| own > bound) {
                worst = k;
            }
        }
        let better = if leaves[worst].found.is_ok() {
            let before = share.left();
            let better = leaves[worst].better(&along, on, &mut share);
            work.spend(before - share.left());
            told_if_spent(&share);
            better
        } else {
            leaves[worst].better(&along, on, work)
        };
        let Some(better) = better else { break };
        leaves.splice(worst..=worst, better);
    }
    let mut parts = Parts::new();
    for leaf in leaves {
        parts.push(leaf.found.ok()?);
    }
    Some(parts)
}
