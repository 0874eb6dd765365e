//! The best control points for given parameters: linear least squares with the conditions at the ends as exact equations.

use alloc::vec;
use alloc::vec::Vec;

use super::functions::Functions;
use crate::bspline::{Banded, FitError};
use crate::numeric::gauss::jacobi;
use crate::vector::largest_component;
use crate::{Point, Scalar};

/// The weight of an equation that has to hold: a rotation with such an equation eliminates its first unknown from all others,
/// and its square is finite.
pub(super) const HEAVY: f64 = 1e100;

/// The points, in a unit in which the largest component is 1, and their weights.
pub(super) struct Data {
    pub(super) dim: usize,
    pub(super) points: Vec<f64>,
    pub(super) weights: Vec<f64>,
    pub(super) unit: f64,
    /// By which the weights were divided.
    heaviest: f64,
}

impl Data {
    /// `lanes` points belong to one parameter each.
    pub(super) fn new<P: Point>(
        points: &[P],
        lanes: usize,
        weights: Option<&[P::Scalar]>,
    ) -> Result<Self, FitError> {
        let count = points.len() / lanes.max(1);
        if let Some(found) = weights.map(<[_]>::len).filter(|&found| found != count) {
            return Err(FitError::Count { expected: count, found });
        }
        let mut unit = 0.0_f64;
        for (index, &point) in points.iter().enumerate() {
            let size = largest_component(point).to_f64();
            if !size.is_finite() {
                return Err(FitError::NotFinite { index });
            }
            unit = unit.max(size);
        }
        let weights: Vec<f64> = match weights {
            Some(weights) => weights.iter().map(|w| w.to_f64()).collect(),
            None => vec![1.0; count],
        };
        if let Some(index) = weights.iter().position(|w| !w.is_finite()) {
            return Err(FitError::NotFinite { index });
        }
        // Weights count by their quotients; the largest becomes 1.
        let heaviest = weights.iter().fold(0.0_f64, |a, w| a.max(w.abs()));
        let heaviest = if heaviest > 0.0 { heaviest } else { 1.0 };
        let weights = weights.iter().map(|w| w / heaviest).collect();
        let unit = if unit > 0.0 { unit } else { 1.0 };
        let components = points.iter().flat_map(|p| (0..P::DIM).map(|d| p.component(d).to_f64() / unit));
        Ok(Self { dim: lanes * P::DIM, points: components.collect(), weights, unit, heaviest })
    }

    /// The factor of the smoothing beside these weights.
    ///
    /// # Errors
    /// [`FitError::Smoothing`] if it is negative or not finite.
    pub(super) fn smoothing(&self, factor: f64) -> Result<f64, FitError> {
        let scaled = factor / self.heaviest / self.heaviest;
        let valid = factor >= 0.0 && scaled.is_finite();
        if valid { Ok(scaled) } else { Err(FitError::Smoothing { value: factor }) }
    }

    pub(super) fn len(&self) -> usize {
        self.weights.len()
    }

    pub(super) fn point(&self, i: usize) -> &[f64] {
        &self.points[i * self.dim..][..self.dim]
    }
}

/// What is asked of an end of the curve, in the unit of the data.
#[derive(Clone)]
pub(super) enum End {
    Free,
    /// It is this point.
    Point(Vec<f64>),
    /// It is this point, and the derivative has this direction, of length 1.
    Tangent(Vec<f64>, Vec<f64>),
    /// It is this point, and this is the derivative times the length of the domain.
    Derivative(Vec<f64>, Vec<f64>),
}

impl End {
    pub(super) fn point(&self) -> Option<&[f64]> {
        match self {
            Self::Free => None,
            Self::Point(point) | Self::Tangent(point, _) | Self::Derivative(point, _) => Some(point),
        }
    }

    pub(super) fn tangent(&self) -> Option<&[f64]> {
        if let Self::Tangent(_, tangent) = self { Some(tangent) } else { None }
    }

    pub(super) fn derivative(&self) -> Option<&[f64]> {
        if let Self::Derivative(_, derivative) = self { Some(derivative) } else { None }
    }
}

/// The factors of neighbouring control points, from one on, in a sum.
pub(super) type Row = (usize, Vec<f64>);

/// Functions, with what depends on them alone.
pub(super) struct Space<'f> {
    pub(super) functions: &'f dyn Functions,
    pub(super) domain: [f64; 2],
    /// The values of the functions at both ends, and their derivatives there times the length of the domain.
    pub(super) ends: [[Row; 2]; 2],
    /// The second derivatives at Gauss nodes, times the roots of the weights and the smoothing: the sum of the squares of these
    /// rows is `smoothing ∫ |C''|²`.
    pub(super) bending: Vec<Row>,
}

impl<'f> Space<'f> {
    pub(super) fn new(functions: &'f dyn Functions, smoothing: f64) -> Self {
        let breakpoints = functions.breakpoints();
        let domain = [breakpoints[0], breakpoints[breakpoints.len() - 1]];
        let ends = domain.map(|t| {
            let scaled = |order: usize, factor: f64| {
                let (first, mut row) = functions.row(t, order);
                let largest = row.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
                for x in &mut row {
                    // What is left of rounding errors must not become a pivot.
                    *x = if x.abs() <= 1e-13 * largest { 0.0 } else { *x * factor };
                }
                (first, row)
            };
            [scaled(0, 1.0), scaled(1, domain[1] - domain[0])]
        });
        let mut bending = Vec::new();
        if smoothing > 0.0 {
            let rule = jacobi(functions.nodes(), 0);
            for span in breakpoints.windows(2) {
                let length = span[1] - span[0];
                for &[x, weight] in &rule {
                    let (first, mut row) = functions.row(span[0] + length * x, 2);
                    let factor = Scalar::sqrt(smoothing * weight * length);
                    for b in &mut row {
                        *b *= factor;
                    }
                    bending.push((first, row));
                }
            }
        }
        Self { functions, domain, ends, bending }
    }
}

/// What is minimised: `Σ (w[i] |C(t[i]) - p[i]|)²` and the bending, with ends as they should be.
pub(super) struct Problem<'a> {
    pub(super) data: &'a Data,
    pub(super) ends: &'a [End; 2],
}

/// `Σ row[j] control[first + j]`.
pub(super) fn sum(row: &Row, control: &[f64], dim: usize) -> Vec<f64> {
    let mut sum = vec![0.0; dim];
    for (j, factor) in row.1.iter().enumerate() {
        for (sum, c) in sum.iter_mut().zip(&control[(row.0 + j) * dim..]) {
            *sum += factor * c;
        }
    }
    sum
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `a - b`
pub(super) fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

impl Problem<'_> {
    /// The control points that are best for these parameters, one component after the other for each.
    ///
    /// A tangent of a given direction has an unknown length α: by linearity the control points are a sum of those for zero
    /// derivatives there and α times those for a unit derivative and zero points, and α solves a system with at most two
    /// unknowns. It is at least a hundredth of the length of the polygon of the points, so that the direction is not turned
    /// round.
    pub(super) fn control(&self, space: &Space<'_>, t: &[f64]) -> Result<Vec<f64>, FitError> {
        let (dim, functions) = (self.data.dim, space.functions);
        let tangents = self.ends.iter().any(|end| end.tangent().is_some());
        let lanes = dim + if tangents { 2 } else { 0 };
        let mut system = Banded::new(functions.count(), functions.width(), lanes);
        let mut right = vec![0.0; lanes];
        for (e, (end, rows)) in self.ends.iter().zip(&space.ends).enumerate() {
            let mut demand = |row: &Row, right: &mut [f64]| {
                let mut factors: Vec<f64> = row.1.iter().map(|x| x * HEAVY).collect();
                system.add(row.0, &mut factors, right);
            };
            if let Some(point) = end.point() {
                right.fill(0.0);
                right.iter_mut().zip(point).for_each(|(r, p)| *r = p * HEAVY);
                demand(&rows[0], &mut right);
            }
            if end.tangent().is_some() {
                right.fill(0.0);
                right[dim + e] = HEAVY;
                demand(&rows[1], &mut right);
            }
            if let Some(derivative) = end.derivative() {
                right.fill(0.0);
                right.iter_mut().zip(derivative).for_each(|(r, d)| *r = d * HEAVY);
                demand(&rows[1], &mut right);
            }
        }
        // In the order of their first unknowns, which keeps the band of the system narrow while it grows.
        let mut rows: Vec<(usize, Vec<f64>, Option<usize>)> =
            Vec::with_capacity(t.len() + space.bending.len());
        for (i, (&t, &weight)) in t.iter().zip(&self.data.weights).enumerate() {
            let (first, mut row) = functions.row(t, 0);
            for b in &mut row {
                *b *= weight;
            }
            rows.push((first, row, Some(i)));
        }
        rows.extend(space.bending.iter().map(|(first, row)| (*first, row.clone(), None)));
        rows.sort_by_key(|row| row.0);
        for (first, mut row, i) in rows {
            right.fill(0.0);
            if let Some(i) = i {
                let weight = self.data.weights[i];
                right.iter_mut().zip(self.data.point(i)).for_each(|(r, p)| *r = p * weight);
            }
            system.add(first, &mut row, &mut right);
        }
        let solution = system.solve().map_err(|function| FitError::Undetermined { function })?;
        let mut control: Vec<f64> =
            solution.chunks_exact(lanes.max(1)).flat_map(|lanes| &lanes[..dim]).copied().collect();
        if tangents {
            let unit = |e: usize| solution.chunks_exact(lanes).map(|l| l[dim + e]).collect::<Vec<_>>();
            self.add_tangents(space, t, &mut control, &[unit(0), unit(1)]);
        }
        Ok(control)
    }

    /// Adds the derivatives at the ends, of the best lengths.
    fn add_tangents(&self, space: &Space<'_>, t: &[f64], control: &mut [f64], units: &[Vec<f64>; 2]) {
        let dim = self.data.dim;
        let zero = vec![0.0; dim];
        let [first, last] = [0, 1].map(|e| self.ends[e].tangent().unwrap_or(&zero).to_vec());
        let (mut aa, mut ab, mut bb, mut ra, mut rb) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let mut count = |row: &Row, weight: f64, residual: &[f64]| {
            let [a, b] = [0, 1].map(|e| weight * sum(row, &units[e], 1)[0]);
            aa += a * a * dot(&first, &first);
            ab += a * b * dot(&first, &last);
            bb += b * b * dot(&last, &last);
            ra -= weight * a * dot(residual, &first);
            rb -= weight * b * dot(residual, &last);
        };
        for (i, (&t, &weight)) in t.iter().zip(&self.data.weights).enumerate() {
            let row = space.functions.row(t, 0);
            let residual = minus(&sum(&row, control, dim), self.data.point(i));
            count(&row, weight, &residual);
        }
        for row in &space.bending {
            let residual = sum(row, control, dim);
            count(row, 1.0, &residual);
        }
        let least = 0.01 * self.polygon().max(1e-9);
        let alone = |r: f64, square: f64, other: f64| {
            let best = (r - ab * other) / square;
            if best > least { best } else { least }
        };
        let both = [self.ends[0].tangent().is_some(), self.ends[1].tangent().is_some()];
        let mut lengths = match both {
            [true, true] => {
                let determinant = aa * bb - ab * ab;
                [(ra * bb - rb * ab) / determinant, (rb * aa - ra * ab) / determinant]
            }
            [true, false] => [alone(ra, aa, 0.0), 0.0],
            _ => [0.0, alone(rb, bb, 0.0)],
        };
        if both == [true, true] && !(lengths[0] > least && lengths[1] > least) {
            // The minimum over a quadrant is on one of its sides.
            let value =
                |[x, y]: [f64; 2]| aa * x * x + 2.0 * ab * x * y + bb * y * y - 2.0 * (ra * x + rb * y);
            let sides = [[least, alone(rb, bb, least)], [alone(ra, aa, least), least]];
            lengths = if value(sides[0]) < value(sides[1]) { sides[0] } else { sides[1] };
        }
        for (j, point) in control.chunks_exact_mut(dim).enumerate() {
            for (c, x) in point.iter_mut().enumerate() {
                *x += lengths[0] * units[0][j] * first[c] + lengths[1] * units[1][j] * last[c];
            }
        }
    }

    /// The length of the polygon of the points.
    pub(super) fn polygon(&self) -> f64 {
        let step = |i: usize| {
            let step = minus(self.data.point(i), self.data.point(i - 1));
            Scalar::sqrt(dot(&step, &step))
        };
        (1..self.data.len()).map(step).sum()
    }

    /// What is minimised.
    pub(super) fn cost(&self, space: &Space<'_>, control: &[f64], t: &[f64]) -> f64 {
        let mut cost = 0.0;
        for (i, square) in self.squares(space, control, t).into_iter().enumerate() {
            cost += self.data.weights[i] * self.data.weights[i] * square;
        }
        for row in &space.bending {
            let bend = sum(row, control, self.data.dim);
            cost += dot(&bend, &bend);
        }
        cost
    }

    /// The squares of the distances of the points from those of the curve.
    pub(super) fn squares(&self, space: &Space<'_>, control: &[f64], t: &[f64]) -> Vec<f64> {
        let square = |(i, &t): (usize, &f64)| {
            let away = minus(&sum(&space.functions.row(t, 0), control, self.data.dim), self.data.point(i));
            dot(&away, &away)
        };
        t.iter().enumerate().map(square).collect()
    }

    /// Whether the ends are where they should be, and go where they should.
    pub(super) fn ends_are_met(&self, space: &Space<'_>, control: &[f64]) -> bool {
        let dim = self.data.dim;
        self.ends.iter().zip(&space.ends).all(|(end, rows)| {
            let there = end.point().is_none_or(|point| {
                let away = minus(&sum(&rows[0], control, dim), point);
                dot(&away, &away) <= 1e-18
            });
            let along = end.tangent().is_none_or(|tangent| {
                let slope = sum(&rows[1], control, dim);
                let (along, square) = (dot(&slope, tangent), dot(&slope, &slope));
                along > 0.0 && square - along * along <= 1e-12 * square
            });
            let slope = end.derivative().is_none_or(|derivative| {
                let away = minus(&sum(&rows[1], control, dim), derivative);
                dot(&away, &away) <= 1e-18 * dot(derivative, derivative).max(1.0)
            });
            there && along && slope
        })
    }
}
