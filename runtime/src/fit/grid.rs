//! Grids of points to tensor surfaces: one direction after the other.

use alloc::vec::Vec;

use super::functions::{Functions, Polynomial, ends_of_domain};
use super::knots::{self, Over};
use super::linear::{Data, End, Problem, Space};
use super::{check_tolerance, in_unit, scalar_knots};
use crate::bspline::{BSplineSurface, FitError, KnotVector, Net, Spacing, parameters_of_rows};
use crate::{Array, Basis, Point, Scalar, TensorSurface};

/// A surface near a grid of points, and how near.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: serde::Serialize, S: serde::Serialize",
        deserialize = "T: serde::Deserialize<'de>, S: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct FittedSurface<T, S> {
    /// The surface.
    pub surface: T,
    /// The parameters of the rows of the grid, in `u`, and those of its columns, in `v`.
    pub parameters: [Vec<S>; 2],
    /// The largest distance of a point from the point of the surface at its parameters; no point is farther from the surface.
    pub largest: S,
    /// The root of the mean square of these distances.
    pub root_mean_square: S,
}

/// A grid of points to which a tensor surface is fitted, and how; the rows of the grid belong to `u`.
///
/// The control points minimise `Σ_ij |S(u[i], v[j]) - p[i, j]|²`, or with smoothing the same in one direction after the
/// other. The minimum over a product of spaces is that in the one direction, of that in the other: the columns of the grid are
/// fitted as curves, then the rows of the control points.
///
/// ```
/// use basis_runtime::bspline::Net;
/// use basis_runtime::{GridFit, Surface};
///
/// let height = |x: f64, y: f64| (x * x + 2.0 * y).sin();
/// let at = |i: usize| i as f64 / 30.0;
/// let grid = Net::from_fn(31, 31, |i, j| [at(i), at(j), height(at(i), at(j))])?;
/// let found = GridFit::new(&grid).spline_within([3, 3], 1e-4)?;
/// assert!(found.largest <= 1e-4);
/// assert!(found.surface.net().as_slice().len() < 31 * 31 / 4);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct GridFit<'a, P: Point> {
    grid: &'a Net<P>,
    parameters: Option<[&'a [P::Scalar]; 2]>,
    spacing: Spacing,
    smoothing: P::Scalar,
    corners: GridCorners,
}

/// What is asked of the corners of a fitted surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum GridCorners {
    /// Nothing: they are where the other points want them.
    #[default]
    Free,
    /// They are the corners of the grid, and the boundary curves are fitted to the boundaries of the grid alone.
    Interpolated,
}

impl<'a, P: Point> GridFit<'a, P> {
    /// A grid with parameters from the mean lengths of the chords between its points, free corners and nothing else.
    pub fn new(grid: &'a Net<P>) -> Self {
        let (parameters, smoothing) = (None, P::Scalar::ZERO);
        Self { grid, parameters, spacing: Spacing::Chord, smoothing, corners: GridCorners::Free }
    }

    /// With these parameters of the rows, in `u`, and of the columns, in `v`.
    #[must_use]
    pub fn parameters(mut self, parameters: [&'a [P::Scalar]; 2]) -> Self {
        self.parameters = Some(parameters);
        self
    }

    /// With parameters from the distances of the points by another rule than [`Spacing::Chord`].
    #[must_use]
    pub fn spacing(mut self, spacing: Spacing) -> Self {
        self.spacing = spacing;
        self
    }

    /// With λ > 0 times the integral of the squared second derivative of the curves of each direction; see
    /// [`Fit::smoothing`](super::Fit::smoothing).
    #[must_use]
    pub fn smoothing(mut self, factor: P::Scalar) -> Self {
        self.smoothing = factor;
        self
    }

    /// With these demands on the corners.
    #[must_use]
    pub fn corners(mut self, corners: GridCorners) -> Self {
        self.corners = corners;
        self
    }

    /// The tensor surface over two families.
    ///
    /// # Errors
    /// As [`Fit::curve`](super::Fit::curve), for both directions.
    #[allow(clippy::type_complexity)] // a surface over two families, with its scalar type
    pub fn surface<U, V>(
        &self,
        bases: (U, V),
    ) -> Result<FittedSurface<TensorSurface<U, V, P>, P::Scalar>, FitError>
    where
        U: Basis<Scalar = P::Scalar>,
        V: Basis<Scalar = P::Scalar>,
    {
        let functions: [&dyn Functions; 2] = [&Polynomial(bases.0), &Polynomial(bases.1)];
        let (net, found) = self.over(functions)?;
        let points = U::Points::from_fn(|i| V::Points::from_fn(|j| net[[i, j]]));
        Ok(found(TensorSurface::new(bases.0, bases.1, points)))
    }

    /// The B-spline surface over these knots.
    ///
    /// # Errors
    /// As [`Fit::spline`](super::Fit::spline), for both directions.
    pub fn spline(
        &self,
        knots: [KnotVector<P::Scalar>; 2],
    ) -> Result<FittedSurface<BSplineSurface<P>, P::Scalar>, FitError> {
        let exact = [knots[0].to_f64(), knots[1].to_f64()];
        self.spline_of(&exact, knots)
    }

    /// The clamped B-spline surface of these degrees with these numbers of control points; see
    /// [`Fit::spline_with`](super::Fit::spline_with).
    ///
    /// # Errors
    /// As [`Fit::spline_with`](super::Fit::spline_with), for both directions.
    pub fn spline_with(
        &self,
        degrees: [usize; 2],
        counts: [usize; 2],
    ) -> Result<FittedSurface<BSplineSurface<P>, P::Scalar>, FitError> {
        let t = self.parameters_in([None; 2])?;
        let mut exact = Vec::with_capacity(2);
        for k in 0..2 {
            let breakpoints = knots::averaged(degrees[k], counts[k], &t[k])?;
            exact.push(KnotVector::clamped(degrees[k], &breakpoints)?);
        }
        self.spline_of(&exact, [scalar_knots(&exact[0])?, scalar_knots(&exact[1])?])
    }

    /// The clamped B-spline surface of these degrees from which no point of the grid is farther than the tolerance, with few
    /// knots: each direction may take half of it.
    ///
    /// # Errors
    /// As [`Fit::spline_within`](super::Fit::spline_within).
    pub fn spline_within(
        &self,
        degrees: [usize; 2],
        tolerance: P::Scalar,
    ) -> Result<FittedSurface<BSplineSurface<P>, P::Scalar>, FitError> {
        check_tolerance(tolerance)?;
        let t = self.parameters_in([None; 2])?;
        let half = 0.5 * tolerance.to_f64();
        // The columns of the grid along u, then what these curves have at the parameters of the grid along v.
        let (u, control) = self.knots_within(degrees[0], self.grid, &t[0], half)?;
        let curves = values(&u, &control, &t[0])?;
        let (v, _) = self.knots_within(degrees[1], &curves.transposed(), &t[1], half)?;
        let exact = [u, v];
        self.spline_of(&exact, [scalar_knots(&exact[0])?, scalar_knots(&exact[1])?])
    }

    /// Knots over which the columns of a net are within a tolerance, and the control points.
    fn knots_within(
        &self,
        degree: usize,
        net: &Net<P>,
        t: &[f64],
        tolerance: f64,
    ) -> Result<(KnotVector<f64>, Net<P>), FitError> {
        let lanes = net.columns();
        let data = Data::new(net.as_slice(), lanes, None)?;
        let mut fit = |knots: KnotVector<f64>, t: &[f64]| {
            let control = self.half(&data, &knots, t)?;
            let space = Space::new(&knots, 0.0);
            let error = |(i, &t): (usize, &f64)| {
                let found = super::linear::sum(&space.functions.row(t, 0), &control, data.dim);
                let away = super::linear::minus(&found, data.point(i));
                let squares = away.chunks_exact(P::DIM.max(1)).map(|a| super::linear::dot(a, a));
                Scalar::sqrt(squares.fold(0.0_f64, f64::max))
            };
            let errors = t.iter().enumerate().map(error).collect();
            Ok(Over { knots, control, t: t.to_vec(), errors, rounds: 0 })
        };
        let over = knots::within(degree, t, tolerance / data.unit, 0, &mut fit)
            .map_err(|error| in_unit(error, data.unit))?;
        let net = points_of(&over.control, data.unit, lanes)?;
        Ok((over.knots, net))
    }

    fn spline_of(
        &self,
        exact: &[KnotVector<f64>],
        knots: [KnotVector<P::Scalar>; 2],
    ) -> Result<FittedSurface<BSplineSurface<P>, P::Scalar>, FitError> {
        let (net, found) = self.over([&exact[0], &exact[1]])?;
        let [u, v] = knots;
        let (functions, points) = (u.functions() * v.functions(), net.as_slice().len());
        let surface =
            BSplineSurface::new(u, v, net).map_err(|_| FitError::Functions { functions, points })?;
        Ok(found(surface))
    }

    /// The control points over functions in both directions, and what makes the answer of a surface.
    #[allow(clippy::type_complexity)] // the second part is a closure
    fn over<T>(
        &self,
        functions: [&dyn Functions; 2],
    ) -> Result<(Net<P>, impl FnOnce(T) -> FittedSurface<T, P::Scalar> + use<T, P>), FitError> {
        let domains = functions.map(|f| Some(ends_of_domain(f)));
        let t = self.parameters_in(domains)?;
        let first = self.direction(self.grid, functions[0], &t[0])?;
        let net = self.direction(&first.transposed(), functions[1], &t[1])?;
        // From the control points back to the grid, in the same way.
        let across = values(functions[1], &net, &t[1])?.transposed();
        let back = values(functions[0], &across, &t[0])?;
        let (mut largest, mut sum) = (0.0_f64, 0.0);
        for (&found, &given) in back.as_slice().iter().zip(self.grid.as_slice()) {
            let distance = crate::vector::distance(found, given).to_f64();
            largest = largest.max(distance);
            sum += distance * distance;
        }
        let mean = Scalar::sqrt(sum / self.grid.as_slice().len() as f64);
        let parameters = t.map(|t| t.into_iter().map(P::Scalar::of).collect());
        let [largest, root_mean_square] = [largest, mean].map(P::Scalar::of);
        let found = move |surface| FittedSurface { surface, parameters, largest, root_mean_square };
        Ok((net.transposed(), found))
    }

    /// The control points of the columns of a net, one row for each function.
    fn direction(&self, net: &Net<P>, functions: &dyn Functions, t: &[f64]) -> Result<Net<P>, FitError> {
        let data = Data::new(net.as_slice(), net.columns(), None)?;
        let control = self.half(&data, functions, t)?;
        points_of(&control, data.unit, net.columns())
    }

    fn half(&self, data: &Data, functions: &dyn Functions, t: &[f64]) -> Result<Vec<f64>, FitError> {
        let smoothing = data.smoothing(self.smoothing.to_f64())?;
        if data.len() < functions.count() && smoothing <= 0.0 {
            return Err(FitError::TooFew { needed: functions.count(), found: data.len() });
        }
        let end = |i: usize| match self.corners {
            GridCorners::Free => End::Free,
            GridCorners::Interpolated => End::Point(data.point(i).to_vec()),
        };
        let ends = [end(0), end(data.len() - 1)];
        let space = Space::new(functions, smoothing);
        let problem = Problem { data, ends: &ends };
        let control = problem.control(&space, t)?;
        if problem.ends_are_met(&space, &control) { Ok(control) } else { Err(FitError::Ends) }
    }

    /// The parameters of both directions.
    fn parameters_in(&self, domains: [Option<[f64; 2]>; 2]) -> Result<[Vec<f64>; 2], FitError> {
        if let Some(index) = self.grid.as_slice().iter().position(|&p| !crate::vector::is_finite(p)) {
            return Err(FitError::NotFinite { index });
        }
        let counts = [self.grid.rows(), self.grid.columns()];
        let mut all = [Vec::new(), Vec::new()];
        for k in 0..2 {
            all[k] = match self.parameters {
                Some(given) => {
                    let given: Vec<f64> = given[k].iter().map(|t| t.to_f64()).collect();
                    if given.len() != counts[k] {
                        return Err(FitError::Count { expected: counts[k], found: given.len() });
                    }
                    if let Some(index) = given.iter().position(|t| !t.is_finite()) {
                        return Err(FitError::NotFinite { index });
                    }
                    if let Some(domain @ [lo, hi]) = domains[k]
                        && let Some(index) = given.iter().position(|&t| t < lo || t > hi)
                    {
                        return Err(FitError::Outside { index, parameter: given[index], domain });
                    }
                    given
                }
                None => {
                    let turned = if k == 0 { &self.grid.transposed() } else { self.grid };
                    let domain = domains[k].unwrap_or([0.0, 1.0]);
                    let unit = parameters_of_rows(turned, self.spacing)?;
                    unit.into_iter().map(|x| crate::domain::from_unit(domain, x.to_f64())).collect()
                }
            };
        }
        Ok(all)
    }
}

/// The points at parameters of the curves whose control points are the columns of a net, one row for each parameter.
fn values<P: Point>(functions: &dyn Functions, net: &Net<P>, t: &[f64]) -> Result<Net<P>, FitError> {
    let rows: Vec<(usize, Vec<f64>)> = t.iter().map(|&t| functions.row(t, 0)).collect();
    let at = |i: usize, c: usize| {
        let (first, row) = &rows[i];
        let terms = row.iter().enumerate();
        terms.fold(P::zero(), |sum, (j, &b)| sum.add_weighted(net[[first + j, c]], P::Scalar::of(b)))
    };
    Net::from_fn(t.len(), net.columns(), at).map_err(|_| FitError::TooFew { needed: 1, found: t.len() })
}

/// A net of points from components in a unit.
fn points_of<P: Point>(control: &[f64], unit: f64, columns: usize) -> Result<Net<P>, FitError> {
    let rows = control.len() / (columns * P::DIM).max(1);
    let at = |i: usize, j: usize| {
        let start = (i * columns + j) * P::DIM;
        P::from_components(|d| P::Scalar::of(control[start + d] * unit))
    };
    Net::from_fn(rows, columns, at).map_err(|_| FitError::TooFew { needed: 1, found: 0 })
}
