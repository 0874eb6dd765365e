//! Parameters and shape values as unknowns: Gauss and Newton's method with the damping of Levenberg and Marquardt.
//!
//! A parameter that may move takes the component of its residual along the curve away, so that only the components across it
//! count (the distance from the tangent; W. Wang, H. Pottmann, Y. Liu, "Fitting B-spline curves to point clouds by
//! curvature-based squared distance minimization", ACM Transactions on Graphics 25, 2006). After a step the parameters are
//! moved to the nearest points and the control points are the best ones for them again, so that no step makes anything worse.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

use super::functions::{Functions, ends_of_domain};
use super::linear::{Data, HEAVY, Problem, Row, Space, dot, minus, sum};
use crate::Scalar;
use crate::bspline::{Banded, FitError};
use crate::domain::{from_unit, unit};

/// The functions with these shape values, if there are any.
pub(super) type Family<'a, 'f> = &'a mut dyn FnMut(&[f64]) -> Option<Box<dyn Functions + 'f>>;

/// The unknowns, and what is minimised.
#[derive(Clone)]
pub(super) struct State {
    pub(super) control: Vec<f64>,
    pub(super) t: Vec<f64>,
    pub(super) shapes: Vec<f64>,
    pub(super) cost: f64,
}

/// How the search goes.
pub(super) struct Search<'a> {
    pub(super) problem: Problem<'a>,
    pub(super) smoothing: f64,
    /// The ranges of the shape values.
    pub(super) ranges: &'a [[f64; 2]],
    /// How often parameters and shape values are improved.
    pub(super) rounds: usize,
    /// Whether the parameters may move, but for those at the ends of the domain.
    pub(super) moving: bool,
    /// The domain of the first parameters.
    pub(super) domain: [f64; 2],
    /// Whether a parameter stays what it is where the domain depends on a shape value, and not its place in the domain.
    pub(super) given: bool,
}

/// More starting values are not looked at.
const MOST_STARTS: usize = 729;

impl Search<'_> {
    /// The best that is found from the parameters `t`, and the number of rounds.
    pub(super) fn run(&self, family: Family<'_, '_>, t: &[f64]) -> Result<(State, usize), FitError> {
        if self.ranges.is_empty() {
            let state = self.start(family, &[], t)?;
            return Ok(self.improved(family, state));
        }
        let mut refused = FitError::Shapes;
        let mut starts: Vec<State> = Vec::new();
        for shapes in grid(self.ranges) {
            match self.start(family, &shapes, t) {
                Ok(state) => starts.push(state),
                Err(FitError::Shapes) => {}
                Err(error) => refused = error,
            }
        }
        starts.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        starts.truncate(3);
        let mut best: Option<(State, usize)> = None;
        for state in starts {
            let found = self.improved(family, state);
            if best.as_ref().is_none_or(|(best, _)| found.0.cost < best.cost) {
                best = Some(found);
            }
        }
        best.ok_or(refused)
    }

    /// The best control points for given shape values and parameters.
    fn start(&self, family: Family<'_, '_>, shapes: &[f64], t: &[f64]) -> Result<State, FitError> {
        let functions = family(shapes).ok_or(FitError::Shapes)?;
        let space = Space::new(&*functions, self.smoothing);
        let t = self.carried(t, self.domain, space.domain).ok_or(FitError::Shapes)?;
        let control = self.problem.control(&space, &t)?;
        let cost = self.problem.cost(&space, &control, &t);
        if !cost.is_finite() {
            return Err(FitError::Undetermined { function: 0 });
        }
        Ok(State { control, t, shapes: shapes.to_vec(), cost })
    }

    /// Parameters of one domain in another one; `None` if they do not lie in it.
    fn carried(&self, t: &[f64], from: [f64; 2], to: [f64; 2]) -> Option<Vec<f64>> {
        if self.given {
            let inside = t.iter().all(|&t| t >= to[0] && t <= to[1]);
            return inside.then(|| t.to_vec());
        }
        if from == to {
            return Some(t.to_vec());
        }
        Some(t.iter().map(|&t| from_unit(to, unit(from, t)[1])).collect())
    }

    /// Improves parameters and shape values until nothing changes.
    fn improved(&self, family: Family<'_, '_>, mut state: State) -> (State, usize) {
        if !self.moving && self.ranges.is_empty() {
            return (state, 0);
        }
        let pinned: Vec<bool> = match family(&state.shapes) {
            Some(functions) => {
                let ends = ends_of_domain(&*functions);
                state.t.iter().map(|&t| !self.moving || t <= ends[0] || t >= ends[1]).collect()
            }
            None => return (state, 0),
        };
        let mut damping = 1e-3;
        for round in 0..self.rounds {
            let mut better = None;
            for _ in 0..12 {
                if let Some(next) = self.step(family, &state, &pinned, damping)
                    && next.cost < state.cost
                {
                    damping = f64::max(damping * 0.1, 1e-15);
                    better = Some(next);
                    break;
                }
                damping *= 10.0;
            }
            let Some(next) = better else { return (state, round) };
            let gain = state.cost - next.cost;
            let done = gain <= 1e-12 * state.cost || next.cost <= 1e-31 * self.problem.data.len() as f64;
            state = next;
            if done {
                return (state, round + 1);
            }
        }
        (state, self.rounds)
    }

    /// The state after one step with that damping.
    fn step(&self, family: Family<'_, '_>, state: &State, pinned: &[bool], damping: f64) -> Option<State> {
        let functions = family(&state.shapes)?;
        let space = Space::new(&*functions, self.smoothing);
        // The same functions with each shape value a little different.
        let mut varied: Vec<(Box<dyn Functions + '_>, f64)> = Vec::new();
        for (k, &[lo, hi]) in self.ranges.iter().enumerate() {
            let mut step = 1e-6 * (hi - lo);
            if state.shapes[k] + step > hi {
                step = -step;
            }
            let mut shapes = state.shapes.clone();
            shapes[k] += step;
            varied.push((family(&shapes)?, (shapes[k] - state.shapes[k]) / (hi - lo)));
        }
        let varied: Vec<(&dyn Functions, f64)> = varied.iter().map(|(f, step)| (&**f, *step)).collect();
        let mut frozen = vec![false; self.ranges.len()];
        let (control, shapes) = loop {
            let (control, change) = self.solve(&space, &varied, &frozen, state, pinned, damping)?;
            let mut shapes = state.shapes.clone();
            let mut again = false;
            for (k, &[lo, hi]) in self.ranges.iter().enumerate() {
                let wanted = state.shapes[k] + change[k] * (hi - lo);
                shapes[k] = wanted.clamp(lo, hi);
                // What stands at an end of its range and would leave it stays.
                if shapes[k] == state.shapes[k] && wanted != shapes[k] && !frozen[k] {
                    frozen[k] = true;
                    again = true;
                }
            }
            if !again {
                break (control, shapes);
            }
        };
        let before = space.domain;
        let functions = family(&shapes)?;
        let space = Space::new(&*functions, self.smoothing);
        let data = self.problem.data;
        let t = self.carried(&state.t, before, space.domain)?;
        let t = projected(&space, data, &control, &t, pinned);
        let control = self.problem.control(&space, &t).ok()?;
        let t = projected(&space, data, &control, &t, pinned);
        let cost = self.problem.cost(&space, &control, &t);
        Some(State { control, t, shapes, cost })
    }

    /// The control points and the changes of the shape values, in parts of their ranges, after a step of the linearised problem.
    fn solve(
        &self,
        space: &Space<'_>,
        varied: &[(&dyn Functions, f64)],
        frozen: &[bool],
        state: &State,
        pinned: &[bool],
        damping: f64,
    ) -> Option<(Vec<f64>, Vec<f64>)> {
        let (data, functions) = (self.problem.data, space.functions);
        let (dim, count, shapes) = (data.dim, functions.count(), varied.len());
        let unknowns = count * dim + shapes;
        let width = if shapes == 0 { functions.width() * dim } else { unknowns };
        let mut system = Banded::new(unknowns, width, 1);
        let mut equations: Vec<(usize, Vec<f64>, f64)> = Vec::new();
        // `weight (Σ row[j] v · δP[j] + Σ slopes[k] δs[k]) = weight right`
        let mut add = |row: &Row, v: &[f64], slopes: &[f64], right: f64, weight: f64| {
            let start = if shapes == 0 { row.0 * dim } else { 0 };
            let len = if shapes == 0 { row.1.len() * dim } else { unknowns };
            let mut factors = vec![0.0; len];
            for (j, b) in row.1.iter().enumerate() {
                for (c, v) in v.iter().enumerate() {
                    factors[(row.0 + j) * dim + c - start] = b * v * weight;
                }
            }
            for (k, slope) in slopes.iter().enumerate().filter(|(k, _)| !frozen[*k]) {
                factors[count * dim + k] = slope * weight;
            }
            equations.push((start, factors, right * weight));
        };
        let all: Vec<Vec<f64>> =
            (0..dim).map(|c| (0..dim).map(|d| f64::from(u8::from(c == d))).collect()).collect();
        let slopes = |t: f64, order: usize, scale: f64| -> Vec<Vec<f64>> {
            let here = sum(&functions.row(t, order), &state.control, dim);
            let slope = |&(functions, step): &(&dyn Functions, f64)| -> Vec<f64> {
                let domain = ends_of_domain(functions);
                let t = if self.given { t } else { from_unit(domain, unit(space.domain, t)[1]) };
                let there = sum(&functions.row(t, order), &state.control, dim);
                there.iter().zip(&here).map(|(a, b)| (a - b) * scale / step).collect()
            };
            varied.iter().map(slope).collect()
        };
        let along = |slopes: &[Vec<f64>], v: &[f64]| slopes.iter().map(|s| dot(s, v)).collect::<Vec<_>>();
        let length = space.domain[1] - space.domain[0];
        for ((end, rows), t) in self.problem.ends.iter().zip(&space.ends).zip(space.domain) {
            if let Some(point) = end.point() {
                let away = minus(point, &sum(&rows[0], &state.control, dim));
                let slopes = slopes(t, 0, 1.0);
                for v in &all {
                    add(&rows[0], v, &along(&slopes, v), dot(&away, v), HEAVY);
                }
            }
            if let Some(tangent) = end.tangent() {
                let slope = sum(&rows[1], &state.control, dim);
                let slopes = slopes(t, 1, length);
                for v in &across(tangent) {
                    add(&rows[1], v, &along(&slopes, v), -dot(&slope, v), HEAVY);
                }
            }
        }
        for (i, (&t, &weight)) in state.t.iter().zip(&data.weights).enumerate() {
            let row = functions.row(t, 0);
            let away = minus(data.point(i), &sum(&row, &state.control, dim));
            let velocity = sum(&functions.row(t, 1), &state.control, dim);
            let speed = Scalar::sqrt(dot(&velocity, &velocity));
            let normals = if pinned[i] || speed * length <= 1e-9 {
                None
            } else {
                Some(across(&velocity.iter().map(|x| x / speed).collect::<Vec<_>>()))
            };
            let slopes = slopes(t, 0, 1.0);
            for v in normals.as_ref().unwrap_or(&all) {
                add(&row, v, &along(&slopes, v), dot(&away, v), weight);
            }
        }
        for row in &space.bending {
            let bend = sum(row, &state.control, dim);
            for v in &all {
                add(row, v, &vec![0.0; shapes], -dot(&bend, v), 1.0);
            }
        }
        let mean = data.weights.iter().map(|w| w * w).sum::<f64>() / count as f64;
        let weight = Scalar::sqrt(damping * mean.max(1e-300));
        for j in 0..count {
            for v in &all {
                add(&(j, vec![1.0]), v, &vec![0.0; shapes], 0.0, weight);
            }
        }
        for k in 0..shapes {
            let mut factors = vec![0.0; unknowns];
            // A value that is frozen has no other equation.
            factors[count * dim + k] = if frozen[k] { 1.0 } else { weight };
            equations.push((0, factors, 0.0));
        }
        // Those that have to hold first: the others are in the order of their first unknowns.
        equations.sort_by_key(|equation| equation.0);
        let heavy = |equation: &(usize, Vec<f64>, f64)| equation.1.iter().any(|x| x.abs() > 1e50);
        let (first, rest): (Vec<_>, Vec<_>) = equations.into_iter().partition(heavy);
        for (start, mut factors, right) in first.into_iter().chain(rest) {
            system.add(start, &mut factors, &mut [right]);
        }
        let mut change = system.solve().ok()?;
        if change.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let shapes = change.split_off(count * dim);
        let control = state.control.iter().zip(&change).map(|(a, b)| a + b).collect();
        Some((control, shapes))
    }
}

/// Shape values all over their ranges, the middle first.
pub(super) fn grid(ranges: &[[f64; 2]]) -> Vec<Vec<f64>> {
    let middle: Vec<f64> = ranges.iter().map(|r| f64::midpoint(r[0], r[1])).collect();
    let mut grid = vec![middle.clone()];
    let count = if ranges.len() == 1 { 17 } else { 7 };
    let place = |[lo, hi]: [f64; 2], i: usize| lo + (hi - lo) * (i as f64 + 0.5) / count as f64;
    let all = u32::try_from(ranges.len()).ok().and_then(|n| usize::pow(count, 1).checked_pow(n));
    if let Some(all) = all.filter(|&all| all <= MOST_STARTS) {
        for mut index in 0..all {
            let mut shapes = Vec::with_capacity(ranges.len());
            for &range in ranges {
                shapes.push(place(range, index % count));
                index /= count;
            }
            grid.push(shapes);
        }
    } else {
        for (k, &range) in ranges.iter().enumerate() {
            for i in 0..count {
                let mut shapes = middle.clone();
                shapes[k] = place(range, i);
                grid.push(shapes);
            }
        }
    }
    grid
}

/// The parameters of the nearest points, each by Newton's method from where it is, but for those that are pinned.
fn projected(space: &Space<'_>, data: &Data, control: &[f64], t: &[f64], pinned: &[bool]) -> Vec<f64> {
    let dim = data.dim;
    let [lo, hi] = space.domain;
    let at = |t: f64, order: usize| sum(&space.functions.row(t, order), control, dim);
    let project = |(i, &start): (usize, &f64)| {
        if pinned[i] {
            return start;
        }
        let away = |t: f64| minus(&at(t, 0), data.point(i));
        let (mut t, mut here) = (start, away(start));
        for _ in 0..6 {
            let (velocity, bend) = (at(t, 1), at(t, 2));
            let slope = dot(&here, &velocity);
            let square = dot(&velocity, &velocity);
            let second = square + dot(&here, &bend);
            let mut step = -slope / if second > 0.1 * square { second } else { square };
            if !step.is_finite() {
                break;
            }
            let mut moved = false;
            for _ in 0..8 {
                let next = (t + step).clamp(lo, hi);
                let there = away(next);
                if dot(&there, &there) < dot(&here, &here) {
                    (t, here, moved) = (next, there, true);
                    break;
                }
                step *= 0.25;
            }
            if !moved || step.abs() <= 1e-14 * (hi - lo) {
                break;
            }
        }
        t
    };
    t.iter().enumerate().map(project).collect()
}

/// Unit vectors perpendicular to a unit vector and to each other: the columns of Householder's reflection that takes the
/// first axis to it.
fn across(unit: &[f64]) -> Vec<Vec<f64>> {
    let Some(&first) = unit.first() else { return Vec::new() };
    let sign = if first >= 0.0 { 1.0 } else { -1.0 };
    let mut axis = unit.to_vec();
    axis[0] += sign;
    let square = dot(&axis, &axis);
    let column = |c: usize| {
        let entry = |r: usize| f64::from(u8::from(r == c)) - 2.0 * axis[r] * axis[c] / square;
        (0..unit.len()).map(entry).collect()
    };
    (1..unit.len()).map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::{across, dot};

    #[test]
    fn vectors_across() {
        for unit in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.6, 0.0, -0.8], [-0.48, 0.6, 0.64]] {
            let [a, b] = across(&unit).try_into().unwrap();
            for (x, y) in [(&a[..], &unit[..]), (&b, &unit), (&a, &b)] {
                assert!(dot(x, y).abs() < 1e-15);
            }
            assert!((dot(&a, &a) - 1.0).abs() < 1e-15 && (dot(&b, &b) - 1.0).abs() < 1e-15);
        }
        assert!(across(&[1.0]).is_empty());
    }
}
