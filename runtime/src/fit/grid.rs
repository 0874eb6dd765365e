//! Grids of points to tensor surfaces: one direction after the other.

use alloc::vec::Vec;

use super::functions::{Functions, Polynomial, ends_of_domain};
use super::knots::{self, Over};
use super::linear::{Data, Space, dot, sum};
use super::lines::{Known, Lines, points_of, values};
use super::{GridEnd, SHAPE_ROUNDS, check_ranges, check_tolerance, in_unit, scalar_knots, shapes};
use crate::bspline::{BSplineSurface, FitError, KnotVector, Net, Spacing, parameters_of_rows};
use crate::vector::largest_component;
use crate::{Array, Basis, Point, Scalar, ShapeError, TensorSurface};

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
    /// How often shape values were improved.
    pub rounds: usize,
}

/// A grid of points to which a tensor surface is fitted, and how; the rows of the grid belong to `u`.
///
/// The control points minimise `Σ_ij |S(u[i], v[j]) - p[i, j]|²`, or with smoothing the same in one direction after the
/// other. The minimum over a product of spaces is that in the one direction, of that in the other: the columns of the grid are
/// fitted as curves, then the rows of the control points. With [`surface_over`](Self::surface_over) shape values are unknowns
/// too, and with [`ends`](Self::ends) edges and the directions across them are fixed.
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
    lines: Lines<'a, P>,
}

/// Control points, and what is between their surface and the grid.
struct Attempt<P: Point> {
    net: Net<P>,
    parameters: [Vec<f64>; 2],
    /// The differences, component by component, in a unit in which the largest component of a point is 1.
    errors: Vec<f64>,
    unit: f64,
}

impl<'a, P: Point> GridFit<'a, P> {
    /// A grid with parameters from the mean lengths of the chords between its points, free edges and nothing else.
    pub fn new(grid: &'a Net<P>) -> Self {
        let lines = Lines { ends: [[GridEnd::Free; 2]; 2], smoothing: P::Scalar::ZERO };
        Self { grid, parameters: None, spacing: Spacing::Chord, lines }
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
        self.lines.smoothing = factor;
        self
    }

    /// With these demands on the edges: `ends[0]` on those at the start and the end of `u`, `ends[1]` on those of `v`.
    /// Derivatives across an edge with directions are as long as those of curves that are fitted to the lines of the grid
    /// alone.
    ///
    /// ```
    /// use basis_runtime::bspline::Net;
    /// use basis_runtime::{BernsteinBasis, GridEnd, GridFit, Surface};
    ///
    /// // A sheet that leaves the floor upright, along the edge x = 0.
    /// let grid = Net::from_fn(9, 5, |i, j| {
    ///     let (x, y) = (i as f64 / 8.0, j as f64 / 4.0);
    ///     [x * x, y, x * (2.0 - x) + 0.1 * y * x]
    /// })?;
    /// let upright = [GridEnd::Tangent([0.0, 0.0, 1.0]), GridEnd::Free];
    /// let cubic = BernsteinBasis::<f64, 4>::new();
    /// let found = GridFit::new(&grid).ends([upright, [GridEnd::Free; 2]]).surface((cubic, cubic))?;
    /// for v in [0.0, 0.3, 1.0] {
    ///     let [x, y, z] = found.surface.partial(0.0, v, [1, 0]);
    ///     assert!(x.abs() < 1e-12 && y.abs() < 1e-12 && z > 0.5);
    /// }
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn ends(mut self, ends: [[GridEnd<'a, P>; 2]; 2]) -> Self {
        self.lines.ends = ends;
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
        self.surface_over(([], []), (|[]| Ok(bases.0), |[]| Ok(bases.1)))
    }

    /// The tensor surface over two families with shape values that are unknowns too, each in the range with that index: those
    /// for which the sum of squared distances is least, looked for from many places of the ranges, as in
    /// [`Fit::curve_over`](super::Fit::curve_over). Where a family gives an error there is none.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// use basis_runtime::bspline::Net;
    /// use basis_runtime::{GridFit, Surface, TensorSurface};
    ///
    /// let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * i) as f64 - (j * j * i) as f64]));
    /// let bases = (QuarticBernstein::new(-0.75)?, QuarticBernstein::new(0.25)?);
    /// let given = TensorSurface::new(bases.0, bases.1, net);
    /// let t: Vec<f64> = (0..12).map(|i| f64::from(i) / 11.0).collect();
    /// let grid = Net::from_fn(12, 12, |i, j| given.eval(t[i], t[j]))?;
    ///
    /// let range = [[-3.0, 1.0]]; // -3 <= λ <= 1
    /// let families = (|[λ]: [f64; 1]| QuarticBernstein::new(λ), |[λ]: [f64; 1]| QuarticBernstein::new(λ));
    /// let found = GridFit::new(&grid).parameters([&t, &t]).surface_over((range, range), families)?;
    /// let (u, v) = (found.surface.u_basis(), found.surface.rows()[0].basis());
    /// assert!((u.lambda() + 0.75).abs() < 1e-6 && (v.lambda() - 0.25).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`surface`](Self::surface); [`FitError::Range`], in which the ranges of the second family count on from those of the
    /// first one, and [`FitError::Shapes`].
    #[allow(clippy::type_complexity)] // a surface over two families, with its scalar type
    pub fn surface_over<U, V, const M: usize, const N: usize>(
        &self,
        ranges: ([[P::Scalar; 2]; M], [[P::Scalar; 2]; N]),
        mut families: (
            impl FnMut([P::Scalar; M]) -> Result<U, ShapeError>,
            impl FnMut([P::Scalar; N]) -> Result<V, ShapeError>,
        ),
    ) -> Result<FittedSurface<TensorSurface<U, V, P>, P::Scalar>, FitError>
    where
        U: Basis<Scalar = P::Scalar>,
        V: Basis<Scalar = P::Scalar>,
    {
        let ranges: Vec<[f64; 2]> =
            ranges.0.iter().chain(&ranges.1).map(|range| range.map(Scalar::to_f64)).collect();
        check_ranges(&ranges)?;
        let mut of = |shapes: &[f64]| {
            let u = families.0(core::array::from_fn(|k| P::Scalar::of(shapes[k])));
            let v = families.1(core::array::from_fn(|k| P::Scalar::of(shapes[M + k])));
            u.ok().zip(v.ok()).ok_or(FitError::Shapes)
        };
        let (shapes, rounds) = if ranges.is_empty() {
            (Vec::new(), 0)
        } else {
            // A step for which neither rounding errors nor third derivatives spoil a central difference.
            let root = P::Scalar::EPSILON.sqrt().sqrt().sqrt().to_f64();
            let step = root * root * root;
            shapes::least(&ranges, SHAPE_ROUNDS, step, &mut |shapes: &[f64]| {
                let (u, v) = of(shapes)?;
                Ok(self.attempt([&Polynomial(u), &Polynomial(v)])?.errors)
            })?
        };
        let bases = of(&shapes)?;
        let attempt = self.attempt([&Polynomial(bases.0), &Polynomial(bases.1)])?;
        let points = U::Points::from_fn(|i| V::Points::from_fn(|j| attempt.net[[i, j]]));
        Ok(attempt.with(TensorSurface::new(bases.0, bases.1, points), rounds))
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
        let (u, control) = self.knots_within(0, degrees[0], self.grid, &t[0], half)?;
        let curves = values(&u, &control, &t[0])?;
        let (v, _) = self.knots_within(1, degrees[1], &curves.transposed(), &t[1], half)?;
        let exact = [u, v];
        let found = self.spline_of(&exact, [scalar_knots(&exact[0])?, scalar_knots(&exact[1])?])?;
        // The derivatives across an edge are those of the lines of the grid up to what can be fitted along it.
        if self.lines.have_tangents() && found.largest > tolerance {
            let [tolerance, reached] = [tolerance, found.largest].map(Scalar::to_f64);
            return Err(FitError::NotReached { tolerance, reached });
        }
        Ok(found)
    }

    /// Knots over which the columns of a net are within a tolerance, and the control points.
    fn knots_within(
        &self,
        direction: usize,
        degree: usize,
        net: &Net<P>,
        t: &[f64],
        tolerance: f64,
    ) -> Result<(KnotVector<f64>, Net<P>), FitError> {
        let lanes = net.columns();
        let data = Data::new(net.as_slice(), lanes, None)?;
        let mut fit = |knots: KnotVector<f64>, t: &[f64]| {
            let known = self.lines.known(direction, &knots, net, t)?;
            let control = self.lines.half(&data, &knots, t, &known)?;
            let space = Space::new(&knots, 0.0);
            let error = |(i, &t): (usize, &f64)| {
                let found = sum(&space.functions.row(t, 0), &control, data.dim);
                let away = super::linear::minus(&found, data.point(i));
                let squares = away.chunks_exact(P::DIM.max(1)).map(|a| dot(a, a));
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
        let attempt = self.attempt([&exact[0], &exact[1]])?;
        let [u, v] = knots;
        let (functions, points) = (u.functions() * v.functions(), attempt.net.as_slice().len());
        let surface = BSplineSurface::new(u, v, attempt.net.clone())
            .map_err(|_| FitError::Functions { functions, points })?;
        Ok(attempt.with(surface, 0))
    }

    /// The best control points over functions in both directions.
    fn attempt(&self, functions: [&dyn Functions; 2]) -> Result<Attempt<P>, FitError> {
        let domains = functions.map(|f| Some(ends_of_domain(f)));
        let t = self.parameters_in(domains)?;
        let first_ends = self.lines.known(0, functions[0], self.grid, &t[0])?;
        let [mut start, mut end] = self.lines.known(1, functions[1], &self.grid.transposed(), &t[1])?;
        let first = self.lines.direction(self.grid, functions[0], &t[0], &first_ends)?;
        // Derivatives across the edges of the second direction are functions along the first one, as points are.
        for (e, known) in [&mut start, &mut end].into_iter().enumerate() {
            if let Known::Derivatives(derivatives) = known {
                *derivatives = self.lines.along(
                    functions[0],
                    &t[0],
                    &first_ends,
                    derivatives,
                    &self.lines.ends[1][e],
                )?;
            }
        }
        let net = self.lines.direction(&first.transposed(), functions[1], &t[1], &[start, end])?;
        // From the control points back to the grid, in the same way.
        let across = values(functions[1], &net, &t[1])?.transposed();
        let back = values(functions[0], &across, &t[0])?;
        let net = net.transposed();
        if !(self.lines.arrives(0, functions, &net, &t)?
            && self.lines.arrives(1, functions, &net.transposed(), &t)?)
        {
            return Err(FitError::Ends);
        }
        let largest = |unit: f64, p: &P| unit.max(largest_component(*p).to_f64());
        let unit = self.grid.as_slice().iter().fold(f64::MIN_POSITIVE, largest);
        let errors = back.as_slice().iter().zip(self.grid.as_slice()).flat_map(|(found, given)| {
            (0..P::DIM).map(move |d| (found.component(d).to_f64() - given.component(d).to_f64()) / unit)
        });
        Ok(Attempt { net, errors: errors.collect(), parameters: t, unit })
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

impl<P: Point> Attempt<P> {
    fn with<T>(self, surface: T, rounds: usize) -> FittedSurface<T, P::Scalar> {
        let squares = self.errors.chunks_exact(P::DIM.max(1)).map(|error| dot(error, error));
        let (count, largest) = (self.errors.len() / P::DIM.max(1), squares.clone().fold(0.0, f64::max));
        let mean = squares.sum::<f64>() / count.max(1) as f64;
        let [largest, root_mean_square] =
            [largest, mean].map(|square| P::Scalar::of(Scalar::sqrt(square) * self.unit));
        let parameters = self.parameters.map(|t| t.into_iter().map(P::Scalar::of).collect());
        FittedSurface { surface, parameters, largest, root_mean_square, rounds }
    }
}
