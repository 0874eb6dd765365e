//! Signs from Bernstein coefficients, on a box or on the cells into which it is cut.
//!
//! **Theorem.** On a box, p is a combination of its Bernstein coefficients with nonnegative weights that sum to 1: p ≥
//! 0 if none is negative. At a point of a face, exactly the weights of the coefficients on that face are positive
//! inside of it: p > 0 there if one of these is positive. A face has at least the coefficients of the smaller faces in
//! it, so that the smallest ones which belong to the box are enough. On a side without an upper end, with x = a + s/(1
//! − s), the same is true of (1 − s)ⁿ p.

use super::claim::Claim;
use crate::algebra::bernstein::{Form, Side};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::certificate::Cuts;
use crate::refusal::{Refusal, fits, shown};
use crate::statement::Relation;

/// Cells within each other.
const MAX_DEPTH: usize = 300;
/// The most faces of a cell.
const MAX_FACES: usize = 1 << 12;

/// A side of a cell: its variable, and whether its lower and upper end belong to the box.
type Axis = (Var, Side, [bool; 2]);

/// Checks all cells.
pub(super) fn cuts(claim: &Claim, cuts: &Cuts, work: &mut Work) -> Result<(), Refusal> {
    whole(claim, &claim.ranges, cuts, work)
}

/// A box whose sides may have no ends at all: those are cut at 0 first.
fn whole(claim: &Claim, ranges: &[(Var, Range)], tree: &Cuts, work: &mut Work) -> Result<(), Refusal> {
    let line = |r: &Range| r.low == End::Infinite && r.high == End::Infinite;
    if let Some(k) = ranges.iter().position(|(_, r)| line(r)) {
        let zero = || End::Included(Rational::ZERO);
        let (low, high) = match tree {
            Cuts::None => (tree, tree),
            Cuts::At { var, low, high } => {
                fits(*var == ranges[k].0, "a side without ends has to be cut first")?;
                (&**low, &**high)
            }
        };
        let mut part = |range: Range, tree: &Cuts| {
            let mut ranges = ranges.to_vec();
            ranges[k].1 = range;
            whole(claim, &ranges, tree, work)
        };
        part(Range { low: End::Infinite, high: zero() }, low)?;
        return part(Range { low: zero(), high: End::Infinite }, high);
    }
    let mut axes: Vec<Axis> = Vec::new();
    for (var, range) in ranges {
        let side = Side::of(range).ok_or(Refusal::Unfit("a cell has a side without ends"))?;
        axes.push((*var, side, [range.low.is_included(), range.high.is_included()]));
    }
    let form = form(&claim.poly, &axes, work)?;
    cell(claim.relation, &axes, &form, tree, 0, work)
}

fn form(poly: &Poly, axes: &[Axis], work: &mut Work) -> Result<Form, Refusal> {
    let sides: Vec<(Var, Side)> = axes.iter().map(|(v, side, _)| (*v, side.clone())).collect();
    Form::new(poly, &sides, work).ok_or(Refusal::Spent)
}

fn cell(
    relation: Relation,
    axes: &[Axis],
    form: &Form,
    tree: &Cuts,
    depth: usize,
    work: &mut Work,
) -> Result<(), Refusal> {
    let Cuts::At { var, low, high } = tree else {
        shown(form.is_nonnegative(), "a Bernstein coefficient is negative")?;
        return match relation {
            Relation::NonNegative => Ok(()),
            Relation::Positive => supported(axes, form, work),
        };
    };
    fits(depth < MAX_DEPTH, "the cells are nested too deeply")?;
    let place = axes.iter().position(|(v, ..)| v == var);
    let k = place.ok_or(Refusal::Unfit("a cell is cut along a variable that does not occur"))?;
    let (lower, upper) = form.halves(k, &axes[k].1, work).ok_or(Refusal::Spent)?;
    let (below, above) = axes[k].1.halves();
    let included = axes[k].2;
    let mut axes = axes.to_vec();
    axes[k] = (*var, below, [included[0], true]);
    cell(relation, &axes, &lower, low, depth + 1, work)?;
    axes[k] = (*var, above, [true, included[1]]);
    cell(relation, &axes, &upper, high, depth + 1, work)
}

/// Checks that every smallest face of a cell that belongs to the box has a positive coefficient.
fn supported(axes: &[Axis], form: &Form, work: &mut Work) -> Result<(), Refusal> {
    let mut faces: Vec<Vec<Option<bool>>> = vec![Vec::new()];
    for (_, _, included) in axes {
        let mut longer = Vec::new();
        for face in faces {
            for (end, belongs) in [Some(false), Some(true)].into_iter().zip(*included) {
                if belongs {
                    longer.push([&face[..], &[end]].concat());
                }
            }
            if *included == [false, false] {
                longer.push([&face[..], &[None]].concat());
            }
        }
        faces = longer;
        fits(faces.len() <= MAX_FACES, "there are too many faces")?;
    }
    work.spend((faces.len() * form.coefficients().len()) as u64 / 4).ok_or(Refusal::Spent)?;
    for face in &faces {
        shown(form.has_support(face), "the polynomial vanishes on a face of a cell")?;
    }
    Ok(())
}

/// Checks that all coefficients on a closed box are positive.
pub(super) fn all_positive(poly: &Poly, sides: &[(Var, Range)], work: &mut Work) -> Result<(), Refusal> {
    let mut axes: Vec<Axis> = Vec::new();
    for (var, range) in sides {
        let side = Side::of(range).ok_or(Refusal::Unfit("a box has a side without ends"))?;
        axes.push((*var, side, [true, true]));
    }
    let form = form(poly, &axes, work)?;
    let positive = form.coefficients().iter().all(Rational::is_positive);
    shown(positive, "a Bernstein coefficient on a box is not positive")
}
