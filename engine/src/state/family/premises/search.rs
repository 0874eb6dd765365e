//! A search for counterexamples to what is said under premises, among some points and downhill from the best of them.

use basis_kernel::{Domain, Quotient, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Counterexample, refute};
use core::cmp::Ordering;
use std::rc::Rc;

use super::numbered::no_square;
use super::points::{all_ranges, counts, directions, fits, sample, values};
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Steps that are tried on the way down.
const MAX_TRIES: usize = 3000;

/// From how many other points with the least value steps are made.
const STARTS: usize = 4;

/// How much a way along a border turns inwards, in units of its length.
const TURNS: [i64; 4] = [0, 1, 4, 16];

/// What a search comes to.
pub(super) enum Search {
    Found(Box<Counterexample>),
    /// No point at which a sign is another one; the one with the lowest value.
    Lowest(Vec<Rational>),
}

/// A counterexample among some points, and downhill from some of them; `None` where there are no points, and of an equation.
pub(super) fn among_points(statement: &Statement, work: &mut Work) -> Option<Search> {
    let found = |found: Option<Counterexample>| found.map(|found| Search::Found(Box::new(found)));
    let (value, relation, domain) = match statement {
        Statement::Sign { value, relation, domain } => (value, Some(relation), domain),
        Statement::Zero { value, domain } => (value, None, domain),
        Statement::Products { .. } | Statement::Independent { .. } => return None,
    };
    if domain.premises.is_empty() {
        return None;
    }
    if all_ranges(value, domain).is_empty() {
        return found(refute(&Rc::new(statement.clone()), &[], work));
    }
    let points = sample(value, domain)?;
    let f = values(&value.numerator, &value.denominator, &points)?;
    let counts = |point: &[Rational]| counts(domain, point);
    // Of points with the same value the one that is farthest inside has the most room around it.
    let room = |point: &Vec<Rational>| domain.premises.iter().map(|(g, _)| g.eval(point)).min();
    let at = |point: &[Rational], work: &mut Work| {
        let ranges = all_ranges(value, domain);
        let coordinates = ranges.mapped(|(var, _)| (*var, Coordinate::Rational(point[var.0].clone())));
        refute(&Rc::new(statement.clone()), &coordinates, work)
    };
    let Some(relation) = relation else {
        let differs = points.iter().zip(f).filter(|(_, f)| f.as_ref().is_some_and(|f| !f.is_zero()));
        let inside = differs.map(|(point, _)| point).filter(|point| counts(point));
        if let Some(point) = inside.max_by_key(|point| room(point)) {
            return found(at(point, work));
        }
        // From a point at which it holds to those beside it.
        let Search::Found(beside) = among_points(&no_square(statement)?, work)? else { return None };
        return found(refute(&Rc::new(statement.clone()), &beside.point, work));
    };
    let mut best: Option<(Vec<Rational>, Rational)> = None;
    for (point, f) in points.iter().zip(&f) {
        let Some(f) = f else { continue };
        let better = best.as_ref().is_none_or(|(known, least)| match f.cmp(least) {
            Ordering::Equal => room(point) > room(known),
            order => order == Ordering::Less,
        });
        if better && counts(point) {
            best = Some((point.clone(), f.clone()));
        }
    }
    let (first, least_of_all) = best?;
    // Where others have the same value, some of them in all parts of the domain follow.
    let alike = |(_, f): &(&Vec<Rational>, &Option<Rational>)| f.as_ref() == Some(&least_of_all);
    let alike = points.iter().zip(&f).filter(alike).map(|(point, _)| point);
    let alike = alike.filter(|point| **point != first && counts(point)).listed();
    let last = alike.len().saturating_sub(1);
    let others = (0..STARTS.min(alike.len())).map(|k| alike[k * last / (STARTS - 1)].clone()).listed();
    let ranges = all_ranges(value, domain);
    let all: Vec<&(Var, Range)> = ranges
        .iter()
        .filter(|(var, _)| value.numerator.depends_on(*var) || value.denominator.depends_on(*var))
        .collect();
    // From a point downhill in smaller and smaller steps.
    let downhill = |start: Vec<Rational>, moving: &[&(Var, Range)]| {
        let directions = directions(moving.len());
        let slopes = Slopes::new(value, domain, moving);
        let finest = if moving.len() <= 2 { 28 } else { 14 };
        let (mut point, mut least) = (start, least_of_all.clone());
        let mut step = Rational::new(1, 16);
        let mut tries = 0;
        while tries < MAX_TRIES && relation.holds(&least) {
            let mut lower = None;
            let widths = |(var, range): &(Var, Range), steps: &i64| {
                let width = range.finite().map_or(Rational::ONE, |(low, high)| high - low);
                (*var, &(&step * &width) * &Rational::from(*steps))
            };
            let fixed = directions.iter().map(|direction| {
                moving.iter().zip(direction).map(|(one, steps)| widths(one, steps)).listed()
            });
            // Those along a border are asked for where none of the others leads down.
            let along = core::iter::once_with(|| slopes.moves(&point, &step)).flatten();
            for change in fixed.chain(along) {
                let mut next = point.clone();
                for (var, by) in &change {
                    next[var.0] += by;
                }
                tries += 1;
                let inside = ranges.iter().all(|(var, range)| range.contains(&next[var.0]));
                if !inside || !fits(domain, &next) || !counts(&next) {
                    continue;
                }
                if let Some(Some(f)) = values(&value.numerator, &value.denominator, &[next.clone()])?.pop()
                    && (f < least || f == least && room(&next) > room(&point))
                {
                    lower = Some((next, f));
                    break;
                }
            }
            match lower {
                Some(better) => (point, least) = better,
                None if step.denom().bits() > finest => break,
                None => step = &step * &Rational::new(1, 2),
            }
        }
        Some((relation.holds(&least), point))
    };
    // A variable that no premise has stays first where it is at an end.
    let is_free = |var: Var| domain.premises.iter().all(|(g, _)| !g.depends_on(var));
    let stays = |(var, range): &(Var, Range)| {
        is_free(*var) && [&range.low, &range.high].iter().any(|end| end.value() == Some(&first[var.0]))
    };
    let some: Vec<&(Var, Range)> = all.iter().copied().filter(|one| !stays(one)).collect();
    if some.len() < all.len() {
        let (holds, point) = downhill(first.clone(), &some)?;
        if !holds {
            return found(at(&point, work));
        }
    }
    let (holds, lowest) = downhill(first, &all)?;
    if !holds {
        return found(at(&lowest, work));
    }
    for start in others {
        let (holds, point) = downhill(start, &all)?;
        if !holds {
            return found(at(&point, work));
        }
    }
    if let Some(point) = far_away(&ranges, &|point| {
        let fits = fits(domain, point) && counts(point);
        let value = values(&value.numerator, &value.denominator, &[point.to_vec()]);
        fits && value.and_then(|mut all| all.pop()?).is_some_and(|f| !relation.holds(&f))
    }) {
        return found(at(&point, work));
    }
    Some(Search::Lowest(lowest))
}

/// Distances from 0, or from the only end of a range, at which a function is looked at, by powers of two.
const FAR: [i32; 8] = [-12, -8, -4, -1, 1, 4, 8, 12];

/// Points of this kind, at most.
const MAX_FAR: usize = 4000;

/// A point that is wanted, near the ends of ranges without another one and far away from them.
fn far_away(ranges: &[(Var, Range)], is_wanted: &dyn Fn(&[Rational]) -> bool) -> Option<Vec<Rational>> {
    if ranges.iter().all(|(_, range)| range.finite().is_some()) {
        return None;
    }
    let width = ranges.iter().map(|(var, _)| var.0 + 1).max()?;
    let mut points = vec![vec![Rational::ZERO; width]];
    for (var, range) in ranges {
        let far = |k: i32| if k < 0 { Rational::new(1, 1 << -k) } else { Rational::from(1_i64 << k) };
        let places = match (range.low.value(), range.high.value()) {
            (Some(low), Some(high)) => vec![low.clone(), high.clone()],
            (Some(low), None) => FAR.map(|k| low + &far(k)).to_vec(),
            (None, Some(high)) => FAR.map(|k| high - &far(k)).to_vec(),
            (None, None) => FAR.iter().flat_map(|k| [far(*k), -far(*k)]).listed(),
        };
        let mut next = Vec::new();
        for point in &points {
            for x in places.iter().filter(|x| range.contains(x)) {
                let mut point = point.clone();
                point[var.0] = x.clone();
                next.push(point);
            }
        }
        points = next;
        basis_prover::charge((points.len() * (8 + width)) as u64);
        if points.len() > MAX_FAR {
            return None;
        }
    }
    points.into_iter().find(|point| is_wanted(point))
}

/// The gradients of a quotient and of the premises.
struct Slopes<'d> {
    value: &'d Quotient,
    variables: Vec<(Var, Range)>,
    /// Of numerator and denominator.
    own: [Vec<Poly>; 2],
    premises: Vec<Vec<Poly>>,
    /// The widest range.
    width: Rational,
}

impl<'d> Slopes<'d> {
    fn new(value: &'d Quotient, domain: &Domain, moving: &[&(Var, Range)]) -> Self {
        let variables = moving.mapped(|one| (*one).clone());
        let gradient = |p: &Poly| variables.mapped(|(var, _)| p.derivative(*var));
        let own = [gradient(&value.numerator), gradient(&value.denominator)];
        let premises = domain.premises.mapped(|(g, _)| gradient(g));
        let widths = moving.iter().filter_map(|(_, range)| range.finite().map(|(low, high)| high - low));
        let width = widths.max().unwrap_or(Rational::ONE);
        Self { value, variables, own, premises, width }
    }

    /// Changes of a point against the gradient, and along the border of each premise with more and more of a turn inwards,
    /// as a border is bent.
    fn moves(&self, point: &[Rational], step: &Rational) -> Vec<Vec<(Var, Rational)>> {
        let at = |all: &[Poly]| all.mapped(|p| p.eval(point));
        let [above, below] = [&self.value.numerator, &self.value.denominator].map(|p| p.eval(point));
        let [slope_above, slope_below] = [&self.own[0], &self.own[1]].map(|all| at(all));
        let slopes = slope_above.iter().zip(&slope_below);
        let mut down = slopes.map(|(n, d)| &(&above * d) - &(n * &below)).listed();
        // What leads out of a range stays at its end.
        let within = |direction: &mut Vec<Rational>| {
            for (by, (var, range)) in direction.iter_mut().zip(&self.variables) {
                let end = if by.is_negative() { &range.low } else { &range.high };
                if end.value() == Some(&point[var.0]) {
                    *by = Rational::ZERO;
                }
            }
        };
        within(&mut down);
        let dot = |a: &[Rational], b: &[Rational]| {
            a.iter().zip(b).fold(Rational::ZERO, |sum, (x, y)| &sum + &(x * y))
        };
        let mut all = vec![(down.clone(), None)];
        for premise in &self.premises {
            let mut inward = at(premise);
            within(&mut inward);
            let (towards, length) = (dot(&down, &inward), dot(&inward, &inward));
            if let Some(share) = (-towards).checked_div(&length).filter(|share| !share.is_negative()) {
                let along = down.iter().zip(&inward).map(|(d, g)| d + &(g * &share)).listed();
                all.push((along, Some(inward)));
            }
        }
        let length = step * &self.width;
        let mut moves = Vec::new();
        for (along, inward) in all {
            let Some(along) = rounded(&along) else { continue };
            let inward = inward.and_then(|inward| rounded(&inward));
            let turns = if inward.is_some() { &TURNS[..] } else { &TURNS[..1] };
            for turn in turns {
                let turn = &length * &Rational::from(*turn);
                let turned = |k: usize| {
                    let turned = inward.as_ref().map_or(Rational::ZERO, |inward| &inward[k] * &turn);
                    &(&along[k] + &turned) * &length
                };
                moves.push(self.variables.iter().enumerate().map(|(k, (var, _))| (*var, turned(k))).listed());
            }
        }
        moves
    }
}

/// A direction with components up to 1, which are short numbers.
fn rounded(direction: &[Rational]) -> Option<Vec<Rational>> {
    let largest = direction.iter().map(Rational::abs).max()?;
    let scale = Rational::from(64).checked_div(&largest)?;
    Some(direction.mapped(|x| &(x * &scale).floor() * &Rational::new(1, 64)))
}
