//! Steps 1 and 5: Bernstein coefficients on the box, and on the cells of a subdivision.

use super::problem::{Point, Problem, end, rational, side, simple};
use super::witness;
use crate::algebra::bernstein::{Form, Side};
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use basis_kernel::Cuts;
use basis_kernel::Relation;

/// What a search came to.
pub(super) enum Attempt {
    Proved(Cuts),
    Refuted(Point),
    /// Neither within the number of cuts and the work.
    Open,
}

/// The most cuts from the whole box to a cell.
const MAX_DEPTH: usize = 200;
/// The most variables: the corners of a cell are looked at one by one.
const MAX_VARIABLES: usize = 10;

/// Looks at the Bernstein coefficients, with at most `cuts` cuts of the box.
pub(super) fn search(problem: &Problem, relation: Relation, cuts: usize, work: &mut Work) -> Attempt {
    if problem.ranges.len() > MAX_VARIABLES {
        return Attempt::Open;
    }
    let mut search = Search { problem, relation, cuts, work, refuted: None };
    let tree = search.whole(&problem.ranges);
    match (tree, search.refuted) {
        (_, Some(point)) => Attempt::Refuted(point),
        (Some(tree), None) => Attempt::Proved(tree),
        (None, None) => Attempt::Open,
    }
}

/// What the coefficients on the whole box and a look at all its faces take at least; some times that where many variables of
/// degree 1 have ranges without an end, as one of the two corners of each has hardly any terms then.
pub(super) fn least_work(problem: &Problem) -> u64 {
    /// Of how many variables the coefficients are as good as the corners.
    const FEW: usize = 8;
    let sizes = problem.ranges.iter().map(|(v, _)| u64::from(problem.poly.degree(*v)) + 1);
    let coefficients = sizes.fold(1, u64::saturating_mul);
    let axes = problem.ranges.len() as u32;
    // Each of the axes is converted by itself.
    let looks = 1_u64.checked_shl(axes).unwrap_or(u64::MAX) / 4;
    let unbounded = |(v, range): &&(Var, Range)| problem.poly.degree(*v) == 1 && range.finite().is_none();
    let times = if problem.ranges.iter().filter(unbounded).count() + 2 > FEW { 16 } else { 1 };
    coefficients.saturating_mul(times).saturating_mul(looks.saturating_add(3 * u64::from(axes)))
}

struct Search<'a> {
    problem: &'a Problem,
    relation: Relation,
    cuts: usize,
    work: &'a mut Work,
    refuted: Option<Point>,
}

/// One axis of a cell.
#[derive(Clone)]
struct Axis {
    var: Var,
    side: Side,
    /// Whether the lower and the upper end belong to the region.
    included: [bool; 2],
    /// Whether a factor that vanishes at the end was taken out.
    removed: [bool; 2],
    cuts: usize,
}

impl Search<'_> {
    /// A box whose sides may have no ends at all: those are cut at 0 first.
    fn whole(&mut self, ranges: &[(Var, Range)]) -> Option<Cuts> {
        if let Some(k) = ranges.iter().position(|(_, r)| side(r).is_none()) {
            let var = ranges[k].0;
            let zero = || End::Included(Rational::ZERO);
            let mut part = |range: Range| {
                let mut ranges = ranges.to_vec();
                ranges[k].1 = range;
                self.whole(&ranges).map(Box::new)
            };
            let low = part(Range { low: End::Infinite, high: zero() })?;
            let high = part(Range { low: zero(), high: End::Infinite })?;
            return Some(Cuts::At { var, low, high });
        }
        let mut axes = Vec::with_capacity(ranges.len());
        for (var, range) in ranges {
            let included = [range.low.is_included(), range.high.is_included()];
            axes.push(Axis { var: *var, side: side(range)?, included, removed: [false; 2], cuts: 0 });
        }
        let sides: Vec<(Var, Side)> = axes.mapped(|a| (a.var, a.side.clone()));
        let whole = Form::new(&self.problem.poly, &sides, self.work)?;
        let (form, exponents) = stripped(&whole);
        for (axis, (low, high)) in axes.iter_mut().zip(exponents) {
            axis.removed = [low > 0, high > 0];
        }
        if self.relation == Relation::Positive
            && let Some((k, high)) = vanishing_face(&axes)
        {
            // The polynomial vanishes on this whole face.
            self.refute(ranges.iter().enumerate().map(|(i, (var, range))| {
                let end = end(&axes[k].side, high).filter(|_| i == k);
                (*var, end.map_or_else(|| simple(range), Clone::clone))
            }));
            return None;
        }
        self.visit(&axes, &form, 0)
    }

    fn refute(&mut self, point: impl Iterator<Item = (Var, Rational)>) {
        self.refuted = Some(rational(point.listed()));
    }

    fn visit(&mut self, axes: &[Axis], form: &Form, depth: usize) -> Option<Cuts> {
        self.work.spend((form.coefficients().len() << axes.len()) as u64 / 4 + 20)?;
        if form.is_nonnegative() {
            if self.relation == Relation::Positive
                && let Some(face) = unsupported_face(axes, form)
            {
                // All coefficients on this face are zero, and it belongs to the region.
                self.refute(axes.iter().zip(&face).map(|(axis, face)| {
                    let end = face.and_then(|high| end(&axis.side, high));
                    (axis.var, end.map_or_else(|| axis.side.middle(), Clone::clone))
                }));
                return None;
            }
            return Some(Cuts::None);
        }
        for number in 0..1_usize << axes.len() {
            let high = |axis: usize| number >> axis & 1 == 1;
            let sign = corner(form, high).signum();
            let belongs = || axes.iter().enumerate().all(|(k, a)| a.included[usize::from(high(k))]);
            if sign < 0 || sign == 0 && self.relation == Relation::Positive && belongs() {
                let corner = axes.iter().enumerate().map(|(k, a)| (a.var, &a.side, high(k))).listed();
                self.refuted = witness::inside(self.problem, self.relation, &corner, self.work).map(rational);
                return None;
            }
        }
        self.cuts = self.cuts.checked_sub(1)?;
        if depth == MAX_DEPTH {
            return None;
        }
        let k = best_axis(axes, form)?;
        let (low, high) = form.halves(k, &axes[k].side, self.work)?;
        let (lower, upper) = axes[k].side.halves();
        let mut axes = axes.to_vec();
        let whole = axes[k].clone();
        axes[k].cuts += 1;
        axes[k].side = lower;
        axes[k].included[1] = true;
        axes[k].removed[1] = false;
        let low = self.visit(&axes, &low, depth + 1).map(Box::new)?;
        axes[k].side = upper;
        axes[k].included = [true, whole.included[1]];
        axes[k].removed = [false, whole.removed[1]];
        let high = self.visit(&axes, &high, depth + 1).map(Box::new)?;
        Some(Cuts::At { var: whole.var, low, high })
    }
}

/// An end that belongs to the region and at which a factor was taken out.
fn vanishing_face(axes: &[Axis]) -> Option<(usize, bool)> {
    let end = |a: &Axis| (0..2).find(|e| a.included[*e] && a.removed[*e]);
    axes.iter().enumerate().find_map(|(k, a)| Some((k, end(a)? == 1)))
}

/// A smallest face that belongs to the region and on which all coefficients are zero.
///
/// It is enough to look at the smallest faces: a larger one has at least the same coefficients.
fn unsupported_face(axes: &[Axis], form: &Form) -> Option<Vec<Option<bool>>> {
    let choices: Vec<Vec<Option<bool>>> = axes.mapped(|a| match a.included {
        [false, false] => vec![None],
        [true, false] => vec![Some(false)],
        [false, true] => vec![Some(true)],
        [true, true] => vec![Some(false), Some(true)],
    });
    let count: usize = choices.iter().map(Vec::len).product();
    (0..count)
        .map(|mut k| {
            let pick = |choice: &Vec<Option<bool>>| {
                let picked = choice[k % choice.len()];
                k /= choice.len();
                picked
            };
            choices.mapped(pick)
        })
        .find(|face| !form.has_support(face))
}

/// The form divided by s and r as long as all coefficients of a face of the box are zero; by axis, the exponents of s
/// and r that it was divided by. The zero form stays as it is.
fn stripped(form: &Form) -> (Form, Vec<(usize, usize)>) {
    let (mut degrees, mut coefficients) = (form.degrees().to_vec(), form.coefficients().to_vec());
    let mut exponents = vec![(0, 0); degrees.len()];
    if coefficients.iter().all(Rational::is_zero) {
        return (form.clone(), exponents);
    }
    for axis in 0..degrees.len() {
        let (n, stride) = (degrees[axis], degrees[axis + 1..].iter().map(|d| d + 1).product::<usize>());
        let index = |place: usize| place / stride % (n + 1);
        let (mut first, mut last) = (n, 0);
        for (place, _) in coefficients.iter().enumerate().filter(|(_, c)| !c.is_zero()) {
            (first, last) = (first.min(index(place)), last.max(index(place)));
        }
        exponents[axis] = (first, n - last);
        if first > 0 || last < n {
            let mut place = 0;
            coefficients.retain(|_| {
                let k = index(place);
                place += 1;
                first <= k && k <= last
            });
            degrees[axis] = last - first;
        }
    }
    (Form::of(degrees, coefficients), exponents)
}

/// The coefficient at a corner: the value of the polynomial there, up to a positive factor.
fn corner(form: &Form, high: impl Fn(usize) -> bool) -> &Rational {
    let mut place = 0;
    for (axis, n) in form.degrees().iter().enumerate() {
        place = place * (n + 1) + if high(axis) { *n } else { 0 };
    }
    &form.coefficients()[place]
}

/// The axis along which the signs change most often, those that were cut less often first.
fn best_axis(axes: &[Axis], form: &Form) -> Option<usize> {
    let score = |k: usize| (mixed_fibres(form, k) * 64) >> axes[k].cuts.min(16);
    let cuttable = (0..axes.len()).filter(|k| form.degrees()[*k] > 0);
    cuttable.max_by_key(|k| (score(*k), core::cmp::Reverse(axes[*k].cuts)))
}

/// The number of fibres along an axis that have coefficients of both signs.
fn mixed_fibres(form: &Form, axis: usize) -> usize {
    let (n, stride) = (form.degrees()[axis], form.stride(axis));
    let fibres = form.coefficients().len() / (n + 1);
    let mixed = |k: &usize| {
        let start = k / stride * stride * (n + 1) + k % stride;
        let (mut below, mut above) = (false, false);
        for i in 0..=n {
            match form.coefficients()[start + i * stride].signum() {
                -1 => below = true,
                1 => above = true,
                _ => {}
            }
        }
        below && above
    };
    (0..fibres).filter(mixed).count()
}
