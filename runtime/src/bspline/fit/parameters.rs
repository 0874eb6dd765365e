//! Parameters for points, and knots for parameters.

use alloc::vec::Vec;

use super::FitError;
use crate::bspline::{KnotVector, Net};
use crate::vector::{is_finite, length};
use crate::{Point, Scalar};

/// How far apart the parameters of neighbouring points are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Spacing {
    /// The same distance between all of them.
    Uniform,
    /// In proportion to their distance.
    Chord,
    /// In proportion to the square root of their distance: the smoothest curves through uneven points
    /// (E. T. Y. Lee, *Choosing nodes in parametric curve interpolation*, 1989).
    #[default]
    Centripetal,
}

/// Parameters from 0 to 1 for a row of points.
///
/// ```
/// use basis_runtime::bspline::{Spacing, parameters};
///
/// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 3.0]];
/// assert_eq!(parameters(&points, Spacing::Chord)?, [0.0, 0.25, 1.0]);
/// # Ok::<(), basis_runtime::bspline::FitError>(())
/// ```
///
/// # Errors
/// If there are fewer than two points, one is not finite, or neighbours coincide (which [`Spacing::Uniform`] allows).
pub fn parameters<P: Point>(points: &[P], spacing: Spacing) -> Result<Vec<P::Scalar>, FitError> {
    if points.len() < 2 {
        return Err(FitError::TooFew { needed: 2, found: points.len() });
    }
    if let Some(index) = points.iter().position(|&point| !is_finite(point)) {
        return Err(FitError::NotFinite { index });
    }
    let step = |pair: &[P]| {
        let distance = length(pair[1].minus(pair[0]));
        match spacing {
            Spacing::Uniform => P::Scalar::ONE,
            Spacing::Chord => distance,
            Spacing::Centripetal => distance.sqrt(),
        }
    };
    let mut sums = alloc::vec![P::Scalar::ZERO];
    let mut sum = P::Scalar::ZERO;
    for (index, pair) in points.windows(2).enumerate() {
        let next = sum + step(pair);
        if !next.is_finite() {
            return Err(FitError::NotFinite { index: index + 1 });
        }
        if next <= sum {
            return Err(FitError::Coincide { index: index + 1 });
        }
        sum = next;
        sums.push(sum);
    }
    Ok(sums.into_iter().map(|partial| partial / sum).collect())
}

/// One list of parameters for all rows of a grid: the mean of the rows' own.
///
/// Rows all of whose points coincide, such as poles, do not count.
pub(crate) fn common_parameters<P: Point>(
    grid: &Net<P>,
    spacing: Spacing,
) -> Result<Vec<P::Scalar>, FitError> {
    let mut sum = alloc::vec![P::Scalar::ZERO; grid.columns()];
    let (mut rows, mut refused) = (0, FitError::TooFew { needed: 2, found: grid.columns() });
    for row in 0..grid.rows() {
        match parameters(grid.row(row), spacing) {
            Ok(parameters) => {
                rows += 1;
                for (sum, parameter) in sum.iter_mut().zip(parameters) {
                    *sum = *sum + parameter;
                }
            }
            Err(error @ FitError::Coincide { .. }) => refused = error,
            Err(error) => return Err(error),
        }
    }
    if rows == 0 {
        return Err(refused);
    }
    let mut mean: Vec<_> = sum.into_iter().map(|sum| sum / P::Scalar::from_usize(rows)).collect();
    if let Some(last) = mean.last_mut() {
        *last = P::Scalar::ONE;
    }
    Ok(mean)
}

/// The clamped knot vector whose inner knots are means of `degree` neighbouring parameters, as many functions as
/// parameters: interpolation over it is always possible (C. de Boor).
pub(in crate::bspline) fn averaged<S: Scalar>(
    degree: usize,
    parameters: &[S],
) -> Result<KnotVector<S>, FitError> {
    let count = parameters.len();
    if count <= degree {
        return Err(FitError::TooFew { needed: degree.saturating_add(1), found: count });
    }
    let mut breakpoints = alloc::vec![parameters[0]];
    for j in 1..count - degree {
        let window = if degree == 0 { &parameters[j - 1..=j] } else { &parameters[j..j + degree] };
        let sum = window.iter().fold(S::ZERO, |sum, &t| sum + t);
        breakpoints.push(sum / S::from_usize(window.len()));
    }
    breakpoints.push(parameters[count - 1]);
    Ok(KnotVector::clamped(degree, &breakpoints)?)
}
