//! Closed curves through points.

use alloc::vec::Vec;

use super::{FitError, Spacing, parameters};
use crate::bspline::{BSplineCurve, KnotVector};
use crate::{Point, Scalar};

impl<P: Point> BSplineCurve<P> {
    /// The closed curve of that degree through all points and back to the first one, as smooth there as everywhere:
    /// `degree - 1` derivatives are continuous. Its period is 1, and the first point has the parameter 0.
    ///
    /// The parameters of the points follow from their distances, the one from the last to the first included; the
    /// breakpoints are these parameters for odd degrees, and the middles between them for even ones, where the domain begins
    /// before 0. The first point need
    /// not be repeated at the end.
    ///
    /// ```
    /// use basis_runtime::ParametricCurve;
    /// use basis_runtime::bspline::{BSplineCurve, Spacing};
    ///
    /// let corners = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0_f64]];
    /// let curve = BSplineCurve::interpolate_closed(3, &corners, Spacing::Chord)?;
    /// assert!((0..4).all(|i| (curve.eval(i as f64 / 4.0)[0] - corners[i][0]).abs() < 1e-15));
    /// assert!((curve.curvature(0.0) - curve.curvature(1.0)).abs() < 1e-14);
    /// # Ok::<(), basis_runtime::bspline::FitError>(())
    /// ```
    ///
    /// # Errors
    /// If there are fewer than three points, one is not finite, or neighbours coincide (of these the last
    /// and the first are), [`FitError::Undetermined`] if the points do not determine the curve.
    pub fn interpolate_closed(degree: usize, points: &[P], spacing: Spacing) -> Result<Self, FitError> {
        if points.len() < 3 {
            return Err(FitError::TooFew { needed: 3, found: points.len() });
        }
        let mut around = points.to_vec();
        around.push(points[0]);
        let at = parameters(&around, spacing)?;
        let (count, half) = (points.len(), P::Scalar::of(0.5));
        let breakpoints: Vec<P::Scalar> = if degree % 2 == 1 {
            at.clone()
        } else {
            // From the middle before the first point to the middle behind the last.
            let before = (at[count - 1] - P::Scalar::ONE) * half;
            let middles = at.windows(2).map(|pair| (pair[0] + pair[1]) * half);
            core::iter::once(before).chain(middles.take(count - 1)).chain([before + P::Scalar::ONE]).collect()
        };
        let knots = KnotVector::periodic(degree, &breakpoints)?;
        let exact = knots.to_f64();
        let mut system = Cyclic::new(count, degree, P::DIM);
        for (&t, &point) in at.iter().zip(points) {
            let (first, values) = exact.values(t.to_f64().clamp(exact.domain()[0], exact.domain()[1]))?;
            let right = (0..P::DIM).map(|d| point.component(d).to_f64()).collect();
            system.add(first, &values, right);
        }
        let solution = system.solve().map_err(|function| FitError::Undetermined { function })?;
        let control = |i: usize| P::from_components(|d| P::Scalar::of(solution[i][d]));
        let points = (0..count + degree).map(|i| control(i % count)).collect();
        Ok(Self::trusted(knots, points))
    }
}

/// One equation: coefficients of neighbouring unknowns from one on, of the unknowns of the border, and right-hand sides.
#[derive(Clone)]
struct Equation {
    band: Vec<f64>,
    border: Vec<f64>,
    right: Vec<f64>,
}

/// Linear equations each of which has neighbouring unknowns, the last beside the first: the last unknowns are the border,
/// all others are eliminated by rotations as the equations come.
struct Cyclic {
    count: usize,
    /// The number of unknowns that are not in the border.
    inner: usize,
    width: usize,
    /// For each inner unknown the equation that begins with it.
    rows: Vec<Option<Equation>>,
    /// Equations for the border alone.
    rest: Vec<Equation>,
    components: usize,
}

impl Cyclic {
    fn new(count: usize, degree: usize, components: usize) -> Self {
        let inner = count.saturating_sub(degree);
        Self { count, inner, width: degree + 1, rows: alloc::vec![None; inner], rest: Vec::new(), components }
    }

    /// Adds `Σ values[i] x[(first + i) mod count] = right`.
    fn add(&mut self, first: usize, values: &[f64], right: Vec<f64>) {
        let mut border = alloc::vec![0.0; self.count - self.inner];
        let mut low: Vec<(usize, f64)> = Vec::new();
        for (i, &value) in values.iter().enumerate() {
            let place = (first + i) % self.count;
            match place.checked_sub(self.inner) {
                Some(place) => border[place] += value,
                None => low.push((place, value)),
            }
        }
        let Some(start) = low.iter().map(|&(place, _)| place).min() else {
            self.rest.push(Equation { band: Vec::new(), border, right });
            return;
        };
        let mut band = alloc::vec![0.0; self.width];
        for (place, value) in low {
            band[place - start] += value;
        }
        self.insert(start, Equation { band, border, right });
    }

    fn insert(&mut self, mut start: usize, mut equation: Equation) {
        while start < self.inner {
            if equation.band[0] != 0.0 {
                let Some(row) = &mut self.rows[start] else {
                    self.rows[start] = Some(equation);
                    return;
                };
                let size = Scalar::sqrt(row.band[0] * row.band[0] + equation.band[0] * equation.band[0]);
                let (cos, sin) = (row.band[0] / size, equation.band[0] / size);
                let rotate = |a: &mut [f64], b: &mut [f64]| {
                    for (a, b) in a.iter_mut().zip(b) {
                        (*a, *b) = (cos * *a + sin * *b, cos * *b - sin * *a);
                    }
                };
                rotate(&mut row.band, &mut equation.band);
                rotate(&mut row.border, &mut equation.border);
                rotate(&mut row.right, &mut equation.right);
            }
            equation.band.rotate_left(1);
            if let Some(last) = equation.band.last_mut() {
                *last = 0.0;
            }
            start += 1;
        }
        self.rest.push(equation);
    }

    /// The unknowns, or the index of one that the equations do not determine.
    fn solve(mut self) -> Result<Vec<Vec<f64>>, usize> {
        let size = self.count - self.inner;
        // Gauss's elimination with the largest pivot for the border.
        for column in 0..size {
            let largest = (column..self.rest.len()).max_by(|&a, &b| {
                self.rest[a].border[column].abs().total_cmp(&self.rest[b].border[column].abs())
            });
            let Some(largest) = largest else { return Err(self.inner + column) };
            self.rest.swap(column, largest);
            let pivot = self.rest[column].clone();
            if pivot.border[column].is_nan() || pivot.border[column].abs() <= 1e-13 {
                return Err(self.inner + column);
            }
            for row in &mut self.rest[column + 1..] {
                let factor = row.border[column] / pivot.border[column];
                for (a, b) in row.border.iter_mut().zip(&pivot.border) {
                    *a -= factor * b;
                }
                for (a, b) in row.right.iter_mut().zip(&pivot.right) {
                    *a -= factor * b;
                }
            }
        }
        let mut found = alloc::vec![alloc::vec![0.0; self.components]; self.count];
        for row in (0..self.count).rev() {
            let (equation, pivot) = match row.checked_sub(self.inner) {
                Some(border) => (&self.rest[border], self.rest[border].border[border]),
                None => match &self.rows[row] {
                    Some(equation) => (equation, equation.band[0]),
                    None => return Err(row),
                },
            };
            if pivot.is_nan() || pivot.abs() <= 1e-13 {
                return Err(row);
            }
            let mut rest = equation.right.clone();
            let mut subtract = |factor: f64, known: &[f64]| {
                for (rest, known) in rest.iter_mut().zip(known) {
                    *rest -= factor * known;
                }
            };
            if row < self.inner {
                for (&factor, known) in equation.band.iter().zip(&found[row..self.inner]).skip(1) {
                    subtract(factor, known);
                }
            }
            let behind = (row + 1).saturating_sub(self.inner);
            for (&factor, known) in equation.border.iter().zip(&found[self.inner..]).skip(behind) {
                subtract(factor, known);
            }
            found[row] = rest.into_iter().map(|rest| rest / pivot).collect();
        }
        Ok(found)
    }
}
