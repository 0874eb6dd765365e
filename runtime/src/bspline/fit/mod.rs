//! Curves through and near rows of points, surfaces through and near grids.
//!
//! All systems are banded and are solved in `f64`, whatever the scalar type, in time proportional to the data.

mod banded;
mod closed;
mod error;
mod parameters;

use alloc::vec::Vec;

pub(crate) use banded::Banded;
pub use error::FitError;
pub(super) use parameters::averaged;
use parameters::common_parameters;
pub(crate) use parameters::common_parameters as parameters_of_rows;
pub use parameters::{Spacing, parameters};

use super::{BSplineCurve, BSplineSurface, KnotVector, Net};
use crate::{Point, Scalar};

impl<P: Point> BSplineCurve<P> {
    /// The clamped curve over `0 <= t <= 1` through all points, one after the other.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineCurve, Spacing};
    ///
    /// let points = [[0.0_f64, 0.0], [1.0, 2.0], [4.0, 2.0], [5.0, 0.0], [6.0, 1.0]];
    /// let curve = BSplineCurve::interpolate(3, &points, Spacing::Uniform)?;
    /// assert!((curve.eval(0.5)[0] - 4.0).abs() < 1e-14);
    /// # Ok::<(), basis_runtime::bspline::FitError>(())
    /// ```
    ///
    /// # Errors
    /// If there are not more points than the degree (and two), one is not finite, or neighbours coincide.
    pub fn interpolate(degree: usize, points: &[P], spacing: Spacing) -> Result<Self, FitError> {
        let parameters = parameters(points, spacing)?;
        let knots = averaged(degree, &parameters)?;
        Self::interpolate_at(knots, &parameters, points)
    }

    /// The curve over these knots that has these points at these parameters: `C(parameters[i]) = points[i]`.
    ///
    /// # Errors
    /// If there are not as many points and parameters as basis functions, the parameters do not increase or are outside
    /// of the domain, or do not determine the curve: for each basis function there must be a parameter inside of its
    /// support (Schoenberg and Whitney).
    pub fn interpolate_at(
        knots: KnotVector<P::Scalar>,
        parameters: &[P::Scalar],
        points: &[P],
    ) -> Result<Self, FitError> {
        let (functions, points_given) = (knots.functions(), points.len());
        if functions != points_given {
            return Err(FitError::Functions { functions, points: points_given });
        }
        if let Some(index) = parameters.windows(2).position(|pair| pair[0] >= pair[1]) {
            return Err(FitError::NotIncreasing { index: index + 1 });
        }
        Self::fit(knots, parameters, points, None)
    }

    /// The curve over these knots that is nearest to the points: it minimises
    /// `Σ (w[i] |C(parameters[i]) - points[i]|)²`.
    ///
    /// All weights are 1 if none are given. The parameters may have any order, and repeat.
    ///
    /// # Errors
    /// If the numbers of points, parameters and weights differ, one is not finite, a parameter is outside of the
    /// domain, or the data do not determine the curve.
    pub fn fit(
        knots: KnotVector<P::Scalar>,
        parameters: &[P::Scalar],
        points: &[P],
        weights: Option<&[P::Scalar]>,
    ) -> Result<Self, FitError> {
        let points = fit_rows(&knots, parameters, points, 1, weights)?;
        Ok(Self::trusted(knots, points))
    }
}

impl<P: Point> BSplineSurface<P> {
    /// The clamped surface over the unit square through all points of a grid; the rows of the grid belong to `u`.
    ///
    /// # Errors
    /// As [`BSplineCurve::interpolate`] for the rows and columns of the grid.
    pub fn interpolate(degrees: [usize; 2], grid: &Net<P>, spacing: Spacing) -> Result<Self, FitError> {
        check_finite(grid)?;
        let [u, v] = [common_parameters(&grid.transposed(), spacing)?, common_parameters(grid, spacing)?];
        let knots = [averaged(degrees[0], &u)?, averaged(degrees[1], &v)?];
        Self::fit(knots, [&u, &v], grid)
    }

    /// The surface over these knots that is nearest to the grid: it minimises `Σ |S(u[i], v[j]) - grid[i, j]|²`.
    ///
    /// With as many parameters as basis functions in both directions it passes through all points.
    ///
    /// # Errors
    /// As [`BSplineCurve::fit`], for both directions.
    pub fn fit(
        [u, v]: [KnotVector<P::Scalar>; 2],
        parameters: [&[P::Scalar]; 2],
        grid: &Net<P>,
    ) -> Result<Self, FitError> {
        check_finite(grid)?;
        // The normal equations are a product of those of both directions: one direction after the other.
        let rows = fit_rows(&u, parameters[0], grid.as_slice(), grid.columns(), None)?;
        let turned = Net::trusted(rows, grid.columns()).transposed();
        let columns = fit_rows(&v, parameters[1], turned.as_slice(), turned.columns(), None)?;
        let net = Net::trusted(columns, turned.columns()).transposed();
        Self::new(u, v, net)
            .map_err(|_| FitError::Count { expected: grid.rows(), found: parameters[0].len() })
    }
}

fn check_finite<P: Point>(grid: &Net<P>) -> Result<(), FitError> {
    match grid.as_slice().iter().position(|&point| !crate::vector::is_finite(point)) {
        Some(index) => Err(FitError::NotFinite { index }),
        None => Ok(()),
    }
}

/// Fits all lanes at once.
fn fit_rows<P: Point>(
    knots: &KnotVector<P::Scalar>,
    parameters: &[P::Scalar],
    points: &[P],
    lanes: usize,
    weights: Option<&[P::Scalar]>,
) -> Result<Vec<P>, FitError> {
    let expected = points.len() / lanes;
    for found in [Some(parameters.len()), weights.map(<[_]>::len)].into_iter().flatten() {
        if found != expected {
            return Err(FitError::Count { expected, found });
        }
    }
    let (k, functions) = (knots.degree(), knots.functions());
    if expected < functions {
        return Err(FitError::TooFew { needed: functions, found: expected });
    }
    let knots = knots.to_f64();
    let components = lanes * P::DIM;
    let mut system = Banded::new(functions, k + 1, components);
    let mut right = Vec::with_capacity(components);
    for (index, &t) in parameters.iter().enumerate() {
        let weight = weights.map_or(1.0, |weights| weights[index].to_f64());
        if !t.is_finite() || !weight.is_finite() {
            return Err(FitError::NotFinite { index });
        }
        right.clear();
        for point in &points[index * lanes..(index + 1) * lanes] {
            right.extend((0..P::DIM).map(|i| point.component(i).to_f64() * weight));
        }
        if right.iter().any(|x| !x.is_finite()) {
            return Err(FitError::NotFinite { index });
        }
        let (first, mut factors) = knots.values(t.to_f64())?;
        for factor in &mut factors {
            *factor *= weight;
        }
        system.add(first, &mut factors, &mut right);
    }
    let solution = system.solve().map_err(|function| FitError::Undetermined { function })?;
    let point = |components: &[f64]| P::from_components(|i| P::Scalar::of(components[i]));
    if P::DIM == 0 {
        return Ok(alloc::vec![P::zero(); functions * lanes]);
    }
    Ok(solution.chunks_exact(P::DIM).map(point).collect())
}
