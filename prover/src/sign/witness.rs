//! Counterexamples: from a corner of a cell into the region, and from any point to a simple one.

use super::problem::{Problem, end};
use crate::algebra::bernstein::Side;
use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, isolate};
use crate::algebra::real::simplest::{simplest_between, spend_simplest};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use basis_kernel::Relation;

/// A rational point.
type Rationals = Vec<(Var, Rational)>;

/// Whether a point of the region contradicts the claim.
pub(super) fn violates(problem: &Problem, relation: Relation, point: &[(Var, Rational)]) -> bool {
    problem.contains(point) && !relation.holds(&problem.value(point))
}

/// A point that contradicts the claim near a corner of a cell; the corner may be excluded or infinite.
pub(super) fn inside(
    problem: &Problem,
    relation: Relation,
    corner: &[(Var, &Side, bool)],
    work: &mut Work,
) -> Option<Rationals> {
    let exact: Option<Rationals> =
        corner.iter().map(|(v, s, high)| Some((*v, end(s, *high)?.clone()))).collect();
    if let Some(point) = exact
        && violates(problem, relation, &point)
    {
        return Some(point);
    }
    let mut step = Rational::ONE;
    for k in 0..300 {
        problem.spend_value(2 + k, work)?;
        step *= &Rational::new(1, 2);
        let point: Rationals = corner.mapped(|(v, s, high)| (*v, near(s, *high, &step)));
        if violates(problem, relation, &point) {
            return Some(point);
        }
    }
    None
}

/// The point of a side with s (low end) or r (high end) about `step`.
fn near(side: &Side, high: bool, step: &Rational) -> Rational {
    let far = || step.recip().unwrap_or(Rational::ONE);
    match (side, high) {
        (Side::Finite(a, b), false) => a + &(&(b - a) * step),
        (Side::Finite(a, b), true) => b - &(&(b - a) * step),
        (Side::Upwards(a), false) => a + step,
        (Side::Upwards(a), true) => a + &far(),
        (Side::Downwards(b), true) => b - step,
        (Side::Downwards(b), false) => b - &far(),
    }
}

/// A point of the region near an end of the range of one variable, the other coordinates given, that contradicts the
/// claim.
pub(super) fn near_end(
    problem: &Problem,
    relation: Relation,
    var: Var,
    high: bool,
    others: &[(Var, Rational)],
    work: &mut Work,
) -> Option<Rationals> {
    let range = problem.range(var);
    let side = super::problem::side(&range)?;
    let with = |x: Rational| {
        let mut point = others.to_vec();
        point.push((var, x));
        point
    };
    let end = end(&side, high).map(|x| with(x.clone())).filter(|p| violates(problem, relation, p));
    if end.is_some() {
        return end;
    }
    let mut step = Rational::ONE;
    for k in 0..300 {
        problem.spend_value(2 + k, work)?;
        step *= &Rational::new(1, 2);
        let point = with(near(&side, high, &step));
        if violates(problem, relation, &point) {
            return Some(point);
        }
    }
    None
}

/// A simple point that contradicts the claim, found from any.
pub(super) fn simplify(
    problem: &Problem,
    relation: Relation,
    point: Rationals,
    work: &mut Work,
) -> Rationals {
    if let Some(found) = grid(problem, relation, work) {
        return found;
    }
    let mut best = point;
    for _ in 0..2 {
        for k in 0..best.len() {
            if let Some(x) = simplest_coordinate(problem, relation, &best, k, work)
                && size(&x) < size(&best[k].1)
            {
                best[k].1 = x;
            }
        }
    }
    best
}

/// What is simple in a number: first of all a small denominator.
fn size(x: &Rational) -> (Rational, Rational) {
    (x.denom(), x.abs())
}

/// The most points of the grid that are looked at.
const MAX_GRID: usize = 400;

/// The simplest point that contradicts the claim, with simple numbers and ends of ranges as coordinates.
fn grid(problem: &Problem, relation: Relation, work: &mut Work) -> Option<Rationals> {
    let lists: Vec<(Var, Vec<Rational>)> = problem.ranges.mapped(|(v, r)| (*v, candidates(r)));
    let longest: usize = lists.iter().map(|(_, l)| l.len()).sum();
    let mut looked_at = 0;
    // By increasing sum of the places in the lists.
    for total in 0..=longest {
        let mut places = vec![0; lists.len()];
        if !first_with_sum(&lists, &mut places, total) {
            continue;
        }
        loop {
            let point: Rationals = lists.iter().zip(&places).map(|((v, l), k)| (*v, l[*k].clone())).listed();
            problem.spend_value(8, work)?;
            if violates(problem, relation, &point) {
                return Some(point);
            }
            looked_at += 1;
            if looked_at == MAX_GRID {
                return None;
            }
            if !next_with_sum(&lists, &mut places) {
                break;
            }
        }
    }
    None
}

/// Distributes a sum over places, as much as possible to the last ones.
fn first_with_sum(lists: &[(Var, Vec<Rational>)], places: &mut [usize], sum: usize) -> bool {
    let mut rest = sum;
    for (place, (_, list)) in places.iter_mut().zip(lists).rev() {
        *place = rest.min(list.len() - 1);
        rest -= *place;
    }
    rest == 0
}

/// The next distribution of the same sum.
fn next_with_sum(lists: &[(Var, Vec<Rational>)], places: &mut [usize]) -> bool {
    let mut after = 0;
    for k in (0..places.len()).rev() {
        if after > 0 && places[k] + 1 < lists[k].1.len() {
            places[k] += 1;
            let first = first_with_sum(&lists[k + 1..], &mut places[k + 1..], after - 1);
            if first {
                return true;
            }
            places[k] -= 1;
        }
        after += places[k];
    }
    false
}

/// Simple numbers of a range, the simplest first.
fn candidates(range: &Range) -> Vec<Rational> {
    let mut list: Vec<Rational> = Vec::new();
    let mut push = |x: &Rational| {
        if range.contains(x) && !list.contains(x) {
            list.push(x.clone());
        }
    };
    for (n, d) in [(0, 1), (1, 1), (1, 2)] {
        push(&Rational::new(n, d));
    }
    for end in [&range.low, &range.high] {
        if let Some(x) = end.value() {
            push(x);
        }
    }
    let more = [
        (-1, 1),
        (2, 1),
        (-2, 1),
        (1, 3),
        (2, 3),
        (1, 4),
        (3, 4),
        (3, 1),
        (-3, 1),
        (-1, 2),
        (3, 2),
        (4, 1),
        (10, 1),
    ];
    for (n, d) in more {
        push(&Rational::new(n, d));
    }
    push(&simplest_between(range.low.value(), range.high.value()));
    if let Some((a, b)) = range.finite() {
        push(&(&(a + b) * &Rational::new(1, 2)));
    }
    list
}

/// The work of one interval between roots, besides that of its numbers.
const CELL: u64 = 40;

/// The simplest value of one coordinate, the others kept, with which the point contradicts the claim.
fn simplest_coordinate(
    problem: &Problem,
    relation: Relation,
    point: &[(Var, Rational)],
    k: usize,
    work: &mut Work,
) -> Option<Rational> {
    let var = point[k].0;
    let mut poly = problem.poly.clone();
    for (v, x) in point.iter().filter(|(v, _)| *v != var) {
        work.spend_at(&poly, *v, x)?;
        poly = poly.at(*v, x);
    }
    problem.spend_value(8, work)?;
    let p = Univariate::from_poly(&poly, var)?.primitive();
    let range = problem.range(var);
    let bad = |x: &Rational| range.contains(x) && !relation.holds(&Rational::from(i64::from(p.sign_at(x))));
    let ends = [&range.low, &range.high].into_iter().filter_map(|e| e.value()).filter(|x| bad(x)).cloned();
    let mut found: Vec<Rational> = ends.listed();
    let square_free = if p.is_constant() { p.clone() } else { p.square_free_part(work)? };
    let mut roots = isolate(&square_free, range.low.value(), range.high.value(), work)?;
    for root in &mut roots {
        root.detect_rational(&square_free, work)?;
    }
    for _ in 0..48 {
        let mut sure = true;
        for cell in 0..=roots.len() {
            let (before, after) = (cell.checked_sub(1).and_then(|k| roots.get(k)), roots.get(cell));
            for root in before.into_iter().chain(after) {
                spend_simplest(root.low(), root.high(), work)?;
            }
            work.spend(CELL)?;
            // The widest interval that the cell can be: if the simplest number there is bad, there is none simpler.
            let widest = simplest_between(
                before.map(Root::low).or(range.low.value()),
                after.map(Root::high).or(range.high.value()),
            );
            p.spend_sign(&widest, work)?;
            if bad(&widest) {
                found.push(widest);
            } else if found.iter().all(|f| size(f) > size(&widest)) {
                let inside = simplest_between(
                    before.map(Root::high).or(range.low.value()),
                    after.map(Root::low).or(range.high.value()),
                );
                p.spend_sign(&inside, work)?;
                if bad(&inside) {
                    sure &= size(&inside) <= size(&widest);
                    found.push(inside);
                }
            }
        }
        if sure {
            break;
        }
        for root in &mut roots {
            root.refine(&square_free, work)?;
        }
    }
    found.into_iter().min_by_key(size)
}
