//! The lines of a grid, all of one direction at once: curves with common parameters, and what is asked of their ends.

use alloc::vec::Vec;

use super::functions::{Functions, ends_of_domain};
use super::linear::{Data, End, Problem, Space, dot, sum};
use super::{GridEnd, unit_of};
use crate::bspline::{FitError, Net};
use crate::vector::{direction, dot as product, largest_component};
use crate::{Point, Scalar};

/// What the lines of one direction have at an end.
#[derive(Clone)]
pub(super) enum Known<P> {
    Nothing,
    /// The first or last point of each.
    Points,
    /// These points and these derivatives.
    Derivatives(Vec<P>),
}

impl<P> Known<P> {
    /// The points alone.
    fn points(&self) -> Self {
        if let Self::Nothing = self { Self::Nothing } else { Self::Points }
    }

    fn demands(&self) -> usize {
        match self {
            Self::Nothing => 0,
            Self::Points => 1,
            Self::Derivatives(_) => 2,
        }
    }
}

/// How the lines of a grid are fitted.
#[derive(Clone, Debug)]
pub(super) struct Lines<'a, P: Point> {
    /// What is asked of the edges across both directions.
    pub(super) ends: [[GridEnd<'a, P>; 2]; 2],
    pub(super) smoothing: P::Scalar,
}

impl<P: Point> Lines<'_, P> {
    pub(super) fn have_tangents(&self) -> bool {
        self.ends.iter().flatten().any(GridEnd::has_tangents)
    }

    /// What the lines of a direction, the columns of the net, have at both ends: derivatives with the directions that were
    /// asked for, as long as that of the curve over that line alone.
    pub(super) fn known(
        &self,
        direction: usize,
        functions: &dyn Functions,
        net: &Net<P>,
        t: &[f64],
    ) -> Result<[Known<P>; 2], FitError> {
        let ends = &self.ends[direction];
        let lanes = net.columns();
        let mut known = ends.map(|end| match end {
            GridEnd::Free => Known::Nothing,
            GridEnd::Interpolated => Known::Points,
            GridEnd::Tangent(_) | GridEnd::Tangents(_) => Known::Derivatives(Vec::with_capacity(lanes)),
        });
        for end in ends {
            if let GridEnd::Tangents(tangents) = end
                && tangents.len() != lanes
            {
                return Err(FitError::Count { expected: lanes, found: tangents.len() });
            }
        }
        if !ends.iter().any(GridEnd::has_tangents) {
            return Ok(known);
        }
        enough(functions, net.rows(), &known, self.smoothing > P::Scalar::ZERO)?;
        for lane in 0..lanes {
            let line: Vec<P> = (0..net.rows()).map(|i| net[[i, lane]]).collect();
            let data = Data::new(&line, 1, None)?;
            let mut demands = [End::Free, End::Free];
            for (e, i) in [0, data.len() - 1].into_iter().enumerate() {
                let point = data.point(i).to_vec();
                demands[e] = match (ends[e].tangent(lane), &known[e]) {
                    (Some(tangent), _) => End::Tangent(point, unit_of::<P>(tangent, e)?),
                    (None, Known::Nothing) => End::Free,
                    (None, _) => End::Point(point),
                };
            }
            let space = Space::new(functions, data.smoothing(self.smoothing.to_f64())?);
            let problem = Problem { data: &data, ends: &demands };
            let control = problem.control(&space, t)?;
            let scale = data.unit / (space.domain[1] - space.domain[0]);
            for ((known, end), rows) in known.iter_mut().zip(&demands).zip(&space.ends) {
                if let (Known::Derivatives(derivatives), Some(unit)) = (known, end.tangent()) {
                    let length = dot(&sum(&rows[1], &control, data.dim), unit) * scale;
                    derivatives.push(P::from_components(|d| P::Scalar::of(length * unit[d])));
                }
            }
        }
        Ok(known)
    }

    /// The control points of the columns of a net, one row for each function.
    pub(super) fn direction(
        &self,
        net: &Net<P>,
        functions: &dyn Functions,
        t: &[f64],
        known: &[Known<P>; 2],
    ) -> Result<Net<P>, FitError> {
        let data = Data::new(net.as_slice(), net.columns(), None)?;
        let control = self.half(&data, functions, t, known)?;
        points_of(&control, data.unit, net.columns())
    }

    pub(super) fn half(
        &self,
        data: &Data,
        functions: &dyn Functions,
        t: &[f64],
        known: &[Known<P>; 2],
    ) -> Result<Vec<f64>, FitError> {
        let smoothing = data.smoothing(self.smoothing.to_f64())?;
        enough(functions, data.len(), known, smoothing > 0.0)?;
        let space = Space::new(functions, smoothing);
        let scale = (space.domain[1] - space.domain[0]) / data.unit;
        let end = |known: &Known<P>, i: usize| match known {
            Known::Nothing => End::Free,
            Known::Points => End::Point(data.point(i).to_vec()),
            Known::Derivatives(derivatives) => {
                let components =
                    |p: &P| (0..P::DIM).map(|d| p.component(d).to_f64() * scale).collect::<Vec<_>>();
                End::Derivative(data.point(i).to_vec(), derivatives.iter().flat_map(components).collect())
            }
        };
        let ends = [end(&known[0], 0), end(&known[1], data.len() - 1)];
        let problem = Problem { data, ends: &ends };
        let control = problem.control(&space, t)?;
        if problem.ends_are_met(&space, &control) { Ok(control) } else { Err(FitError::Ends) }
    }

    /// The control points along the first direction of the derivatives across an edge of the second one.
    ///
    /// At a corner with an edge that has one direction all along it, the derivative of these, the mixed one of the surface,
    /// has that direction as well, and is zero if the two edges have different ones.
    pub(super) fn along(
        &self,
        functions: &dyn Functions,
        t: &[f64],
        ends: &[Known<P>; 2],
        derivatives: &[P],
        edge: &GridEnd<'_, P>,
    ) -> Result<Vec<P>, FitError> {
        let column = column_of(derivatives)?;
        let mut ends = ends.each_ref().map(Known::points);
        let free = self.direction(&column, functions, t, &ends)?;
        for (e, end) in ends.iter_mut().enumerate() {
            if let GridEnd::Tangent(tangent) = self.ends[0][e] {
                let unit = direction(tangent).ok_or(FitError::Tangent { end: e })?;
                let mixed = derivative_at(functions, e, &free, 0);
                let mut part = unit.scale(product(mixed.to_vector(), unit));
                if let GridEnd::Tangent(other) = *edge {
                    let other = direction(other).ok_or(FitError::Tangent { end: e })?;
                    let across = part.add_scaled(other, -product(part, other));
                    let noise = P::Scalar::EPSILON.sqrt() * largest_component(part);
                    if largest_component(across) > noise {
                        part = part.scale(P::Scalar::ZERO);
                    }
                }
                *end = Known::Derivatives(alloc::vec![P::from_vector(part)]);
            }
        }
        let all_free = ends.iter().all(|end| end.demands() < 2);
        let fitted = if all_free { free } else { self.direction(&column, functions, t, &ends)? };
        Ok(fitted.as_slice().to_vec())
    }

    /// Whether the surface crosses the edges of a direction in the directions that were asked for, and not in the opposite
    /// ones; the rows of the net belong to that direction.
    pub(super) fn arrives(
        &self,
        direction: usize,
        functions: [&dyn Functions; 2],
        net: &Net<P>,
        t: &[Vec<f64>; 2],
    ) -> Result<bool, FitError> {
        let (across, along) = (functions[direction], functions[1 - direction]);
        for (e, end) in self.ends[direction].iter().enumerate() {
            if end.has_tangents() {
                let control: Vec<P> = (0..net.columns()).map(|j| derivative_at(across, e, net, j)).collect();
                let found = values(along, &column_of(&control)?, &t[1 - direction])?;
                let forwards = |(line, derivative): (usize, &P)| {
                    let tangent = end.tangent(line);
                    tangent.is_none_or(|tangent| product(derivative.to_vector(), tangent) > P::Scalar::ZERO)
                };
                if !found.as_slice().iter().enumerate().all(forwards) {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }
}

/// Whether there are as many conditions as unknowns, and not more demands than unknowns.
fn enough<P>(
    functions: &dyn Functions,
    points: usize,
    known: &[Known<P>; 2],
    smoothed: bool,
) -> Result<(), FitError> {
    let demands: usize = known.iter().map(Known::demands).sum();
    if demands > functions.count() {
        return Err(FitError::Ends);
    }
    let derivatives = known.iter().filter(|known| known.demands() == 2).count();
    if points + derivatives < functions.count() && !smoothed {
        return Err(FitError::TooFew { needed: functions.count() - derivatives, found: points });
    }
    Ok(())
}

/// A net of one column.
fn column_of<P: Point>(points: &[P]) -> Result<Net<P>, FitError> {
    let count = points.len();
    Net::from_fn(count, 1, |i, _| points[i]).map_err(|_| FitError::TooFew { needed: 1, found: count })
}

/// The derivative at an end of the curve whose control points are a column of a net.
fn derivative_at<P: Point>(functions: &dyn Functions, end: usize, net: &Net<P>, column: usize) -> P {
    let (first, row) = functions.row(ends_of_domain(functions)[end], 1);
    let terms = row.iter().enumerate();
    terms.fold(P::zero(), |sum, (i, &b)| sum.add_weighted(net[[first + i, column]], P::Scalar::of(b)))
}

/// The points at parameters of the curves whose control points are the columns of a net, one row for each parameter.
pub(super) fn values<P: Point>(
    functions: &dyn Functions,
    net: &Net<P>,
    t: &[f64],
) -> Result<Net<P>, FitError> {
    let rows: Vec<(usize, Vec<f64>)> = t.iter().map(|&t| functions.row(t, 0)).collect();
    let at = |i: usize, c: usize| {
        let (first, row) = &rows[i];
        let terms = row.iter().enumerate();
        terms.fold(P::zero(), |sum, (j, &b)| sum.add_weighted(net[[first + j, c]], P::Scalar::of(b)))
    };
    Net::from_fn(t.len(), net.columns(), at).map_err(|_| FitError::TooFew { needed: 1, found: t.len() })
}

/// A net of points from components in a unit.
pub(super) fn points_of<P: Point>(control: &[f64], unit: f64, columns: usize) -> Result<Net<P>, FitError> {
    let rows = control.len() / (columns * P::DIM).max(1);
    let at = |i: usize, j: usize| {
        let start = (i * columns + j) * P::DIM;
        P::from_components(|d| P::Scalar::of(control[start + d] * unit))
    };
    Net::from_fn(rows, columns, at).map_err(|_| FitError::TooFew { needed: 1, found: 0 })
}
