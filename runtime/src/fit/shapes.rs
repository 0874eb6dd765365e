//! Shape values of surfaces as unknowns: Gauss and Newton's method with the damping of Levenberg and Marquardt, in the
//! shape values alone, since the best control points follow from them.

use alloc::vec;
use alloc::vec::Vec;

use super::linear::dot;
use super::orthogonal;
use crate::bspline::{Banded, FitError};

/// The distances, component by component, that remain with these shape values.
pub(super) type Residuals<'a> = &'a mut dyn FnMut(&[f64]) -> Result<Vec<f64>, FitError>;

/// Shape values with what remains.
#[derive(Clone)]
struct State {
    shapes: Vec<f64>,
    residuals: Vec<f64>,
    cost: f64,
}

/// In how many places the search begins.
const BEGINNINGS: usize = 3;

/// Shape values in the ranges for which the sum of squares of the residuals is least, looked for from many places, and how
/// often they were improved. For derivatives a shape value changes by that part of its range.
pub(super) fn least(
    ranges: &[[f64; 2]],
    rounds: usize,
    step: f64,
    residuals: Residuals<'_>,
) -> Result<(Vec<f64>, usize), FitError> {
    let mut refused = FitError::Shapes;
    let mut starts = Vec::new();
    for shapes in orthogonal::grid(ranges) {
        match state(shapes, residuals) {
            Ok(state) => starts.push(state),
            Err(FitError::Shapes) => {}
            Err(error) => refused = error,
        }
    }
    starts.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    starts.truncate(BEGINNINGS);
    let improved = starts.into_iter().map(|start| improved(ranges, rounds, step, residuals, start));
    let best = improved.min_by(|(a, _), (b, _)| a.cost.total_cmp(&b.cost)).ok_or(refused)?;
    Ok((best.0.shapes, best.1))
}

fn state(shapes: Vec<f64>, residuals: Residuals<'_>) -> Result<State, FitError> {
    let residuals = residuals(&shapes)?;
    let cost = dot(&residuals, &residuals);
    if cost.is_finite() {
        Ok(State { shapes, residuals, cost })
    } else {
        Err(FitError::Undetermined { function: 0 })
    }
}

/// The state after up to that many rounds, and their number.
fn improved(
    ranges: &[[f64; 2]],
    rounds: usize,
    step: f64,
    residuals: Residuals<'_>,
    mut best: State,
) -> (State, usize) {
    let mut damping = 1e-3;
    for round in 0..rounds {
        let Some(slopes) = slopes(ranges, step, residuals, &best) else { return (best, round) };
        let mut better = None;
        for _ in 0..12 {
            let next = moved(ranges, &slopes, &best, damping).and_then(|s| state(s, residuals).ok());
            if let Some(next) = next.filter(|next| next.cost < best.cost) {
                damping = f64::max(damping * 0.1, 1e-15);
                better = Some(next);
                break;
            }
            damping *= 10.0;
        }
        let Some(next) = better else { return (best, round) };
        let gain = best.cost - next.cost;
        let done = gain <= 1e-12 * best.cost || next.cost <= 1e-31 * next.residuals.len() as f64;
        best = next;
        if done {
            return (best, round + 1);
        }
    }
    (best, rounds)
}

/// The derivatives of the residuals with respect to each shape value, measured in its range, by central differences; at an
/// end of the range, or where there is no family on one side, by those of the other side.
fn slopes(ranges: &[[f64; 2]], step: f64, residuals: Residuals<'_>, best: &State) -> Option<Vec<Vec<f64>>> {
    let mut slopes = Vec::with_capacity(ranges.len());
    for (k, &[lo, hi]) in ranges.iter().enumerate() {
        let mut beside = |step: f64| {
            let mut shapes = best.shapes.clone();
            shapes[k] = (shapes[k] + step).clamp(lo, hi);
            let place = (shapes[k] - best.shapes[k]) / (hi - lo);
            let found = if place == 0.0 { None } else { residuals(&shapes).ok() };
            found.map_or((0.0, best.residuals.clone()), |found| (place, found))
        };
        let step = step * (hi - lo);
        let ((from, before), (to, after)) = (beside(-step), beside(step));
        if from == to {
            return None;
        }
        slopes.push(before.iter().zip(&after).map(|(a, b)| (b - a) / (to - from)).collect());
    }
    Some(slopes)
}

/// The shape values after one step with that damping; what stands at an end of its range and would leave it stays.
fn moved(ranges: &[[f64; 2]], slopes: &[Vec<f64>], best: &State, damping: f64) -> Option<Vec<f64>> {
    let count = ranges.len();
    let mut frozen = vec![false; count];
    loop {
        let mut system = Banded::new(count, count, 1);
        for (i, residual) in best.residuals.iter().enumerate() {
            let slope = |k: usize| if frozen[k] { 0.0 } else { slopes[k][i] };
            system.add(0, &mut (0..count).map(slope).collect::<Vec<_>>(), &mut [-residual]);
        }
        for k in 0..count {
            let size = f64::max(damping * dot(&slopes[k], &slopes[k]), 1e-300);
            let mut factors = vec![0.0; count];
            factors[k] = if frozen[k] { 1.0 } else { crate::Scalar::sqrt(size) };
            system.add(0, &mut factors, &mut [0.0]);
        }
        let change = system.solve().ok()?;
        let mut shapes = best.shapes.clone();
        let mut again = false;
        for (k, &[lo, hi]) in ranges.iter().enumerate() {
            let wanted = best.shapes[k] + change[k] * (hi - lo);
            if !wanted.is_finite() {
                return None;
            }
            shapes[k] = wanted.clamp(lo, hi);
            if shapes[k] == best.shapes[k] && wanted != shapes[k] && !frozen[k] {
                frozen[k] = true;
                again = true;
            }
        }
        if !again {
            return Some(shapes);
        }
    }
}
