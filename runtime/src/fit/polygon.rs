//! The polygon of the points: parameters from the lengths of its sides, corners where it turns.

use alloc::vec::Vec;

use super::linear::{Data, dot, minus};
use crate::Scalar;
use crate::bspline::{FitError, Spacing};

/// Parameters from 0 to 1 by the distances of neighbours, which may coincide.
pub(super) fn spaced(data: &Data, spacing: Spacing) -> Result<Vec<f64>, FitError> {
    let (mut sum, mut sums) = (0.0, alloc::vec![0.0]);
    for i in 1..data.len() {
        let step = minus(data.point(i), data.point(i - 1));
        let distance = Scalar::sqrt(dot(&step, &step));
        sum += match spacing {
            Spacing::Uniform => 1.0,
            Spacing::Chord => distance,
            Spacing::Centripetal => Scalar::sqrt(distance),
        };
        sums.push(sum);
    }
    if sum <= 0.0 {
        return Err(FitError::Coincide { index: 1 });
    }
    Ok(sums.into_iter().map(|partial| partial / sum).collect())
}

/// The first and the last point, and those at which the polygon turns by more than an angle; of points that coincide the last.
pub(super) fn corners(data: &Data, angle: f64) -> Vec<usize> {
    let last = data.len() - 1;
    let mut corners = alloc::vec![0];
    let mut before: Option<Vec<f64>> = None;
    for i in 0..last {
        let step = minus(data.point(i + 1), data.point(i));
        let length = Scalar::sqrt(dot(&step, &step));
        if length <= 0.0 {
            continue;
        }
        let heading: Vec<f64> = step.iter().map(|x| x / length).collect();
        if let Some(before) = before {
            let apart = minus(&heading, &before);
            let together = minus(&heading, &before.iter().map(|x| -x).collect::<Vec<_>>());
            let sides = [apart, together].map(|side| Scalar::sqrt(dot(&side, &side)));
            if 2.0 * Scalar::atan2(sides[0], sides[1]) > angle {
                corners.push(i);
            }
        }
        before = Some(heading);
    }
    corners.push(last);
    corners
}
