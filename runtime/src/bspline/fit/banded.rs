//! Least squares with a banded matrix, row by row.
//!
//! Each equation is rotated into an upper triangular band (Givens), so the normal equations, which would square the
//! condition number, are never formed. Source: P. Dierckx, *Curve and Surface Fitting with Splines* (1993), section
//! 4.1.

use alloc::vec;
use alloc::vec::Vec;

use crate::Scalar;

/// The triangular system to which all equations so far are reduced: `unknowns` columns in a band of `width`, and
/// `lanes` right sides.
pub(crate) struct Banded {
    width: usize,
    lanes: usize,
    band: Vec<f64>,
    right: Vec<f64>,
    /// For each row of the band the size of the numbers it was computed from: its rounding errors are a part of that.
    sizes: Vec<f64>,
}

impl Banded {
    pub(crate) fn new(unknowns: usize, width: usize, lanes: usize) -> Self {
        Self {
            width,
            lanes,
            band: vec![0.0; unknowns * width],
            right: vec![0.0; unknowns * lanes],
            sizes: vec![0.0; unknowns],
        }
    }

    /// Adds the equation `Σ factors[i] x[first + i] = right`, both of which it uses up.
    ///
    /// Equations may come in any order; it takes the least time if their first unknowns do not decrease. One that comes after
    /// others with later unknowns fills its band again with theirs.
    pub(crate) fn add(&mut self, first: usize, factors: &mut [f64], right: &mut [f64]) {
        let mut own = factors.iter().fold(0.0, |size: f64, x| Scalar::max(size, Scalar::abs(*x)));
        let unknowns = self.sizes.len();
        let mut rest: Vec<f64>;
        let mut window = factors;
        for row in first..unknowns {
            // The equation has no more unknowns than the band of this row.
            let room = self.width.min(unknowns - row);
            let used =
                self.band[row * self.width..][..room].iter().rposition(|&x| x != 0.0).map_or(0, |i| i + 1);
            if used > window.len() {
                let mut longer = window.to_vec();
                longer.resize(used, 0.0);
                rest = longer;
                window = &mut rest;
            }
            let Some(&b) = window.first() else { return };
            if b != 0.0 {
                let pivots = &mut self.band[row * self.width..][..window.len()];
                let a = pivots[0];
                let size = a.abs().max(b.abs());
                let length = size * Scalar::sqrt((a / size) * (a / size) + (b / size) * (b / size));
                let (cos, sin) = (a / length, b / length);
                let rotate = |x: &mut f64, y: &mut f64| {
                    (*x, *y) = (cos * *x + sin * *y, cos * *y - sin * *x);
                };
                for (x, y) in pivots.iter_mut().zip(window.iter_mut()) {
                    rotate(x, y);
                }
                let pivots = &mut self.right[row * self.lanes..][..self.lanes];
                for (x, y) in pivots.iter_mut().zip(right.iter_mut()) {
                    rotate(x, y);
                }
                let (cos, sin, size) = (Scalar::abs(cos), Scalar::abs(sin), &mut self.sizes[row]);
                (*size, own) = (Scalar::max(cos * *size, sin * own), Scalar::max(cos * own, sin * *size));
            }
            window = &mut window[1..];
        }
    }

    /// The solution, `lanes` numbers for each unknown.
    ///
    /// # Errors
    /// The index of an unknown that the equations do not determine.
    pub(crate) fn solve(mut self) -> Result<Vec<f64>, usize> {
        let (width, lanes) = (self.width, self.lanes);
        let unknowns = self.band.len() / width;
        for row in (0..unknowns).rev() {
            let pivot = self.band[row * width];
            // Rounding errors of the rotations; what is smaller is not information.
            if Scalar::abs(pivot) <= 1e-14 * self.sizes[row] || !pivot.is_finite() {
                return Err(row);
            }
            for lane in 0..lanes {
                let mut sum = self.right[row * lanes + lane];
                for i in 1..width.min(unknowns - row) {
                    sum -= self.band[row * width + i] * self.right[(row + i) * lanes + lane];
                }
                self.right[row * lanes + lane] = sum / pivot;
            }
        }
        Ok(self.right)
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::Banded;

    #[test]
    fn a_small_system_in_the_sense_of_least_squares() {
        // x = 1, x = 3, x + y = 5: x = 2 and y = 3.
        let mut system = Banded::new(2, 2, 1);
        system.add(0, &mut [1.0, 0.0], &mut [1.0]);
        system.add(0, &mut [1.0, 1.0], &mut [5.0]);
        system.add(0, &mut [1.0, 0.0], &mut [3.0]);
        let found = system.solve().unwrap();
        assert!((found[0] - 2.0).abs() < 1e-15 && (found[1] - 3.0).abs() < 1e-15);
    }

    #[test]
    fn equations_of_any_weight() {
        for weight in [1e-200, 1e-16, 1e16, 1e200] {
            // Whichever comes first.
            for heavy in 0..3 {
                let mut system = Banded::new(3, 3, 1);
                let rows = [([1.0, 1.0, 1.0], 6.0), ([1.0, 2.0, 4.0], 17.0), ([1.0, 3.0, 9.0], 34.0)];
                for (i, (factors, right)) in rows.into_iter().enumerate() {
                    let weight = if i == heavy { weight } else { 1.0 };
                    system.add(0, &mut factors.map(|x| x * weight), &mut [right * weight]);
                }
                let found = system.solve().unwrap();
                assert!(found.iter().zip([1.0, 2.0, 3.0]).all(|(a, b)| (a - b).abs() < 1e-13), "{found:?}");
            }
        }
        let mut system = Banded::new(2, 2, 1);
        system.add(0, &mut [1.0, 1.0 / 3.0], &mut [1.0]);
        system.add(0, &mut [3e9, 1e9], &mut [3e9]);
        assert_eq!(system.solve(), Err(1)); // the same equation twice
    }

    /// Any order of the equations, with any gaps, gives the same solution.
    #[test]
    fn equations_of_any_order() {
        let rows: Vec<(usize, [f64; 3], f64)> = (0..12)
            .map(|i| {
                let x = |k: usize| ((7 * i + 3 * k) % 11) as f64 - 4.5;
                (i % 4, [x(0), x(1), x(2)], x(3))
            })
            .collect();
        let solve = |order: &[usize]| {
            let mut system = Banded::new(6, 3, 1);
            for &i in order {
                let (first, mut factors, right) = rows[i];
                system.add(first, &mut factors, &mut [right]);
            }
            system.solve().unwrap()
        };
        let mut sorted: Vec<usize> = (0..12).collect();
        sorted.sort_by_key(|&i| rows[i].0);
        let expected = solve(&sorted);
        // Stationary: the columns are perpendicular to the residuals.
        let residual = |(first, factors, right): &(usize, [f64; 3], f64)| {
            factors.iter().zip(&expected[*first..]).map(|(f, x)| f * x).sum::<f64>() - right
        };
        for unknown in 0..6_usize {
            let entry = |(first, factors, _): &(usize, [f64; 3], f64)| {
                unknown.checked_sub(*first).and_then(|k| factors.get(k)).copied().unwrap_or(0.0)
            };
            assert!(rows.iter().map(|row| entry(row) * residual(row)).sum::<f64>().abs() < 1e-12);
        }
        for shift in 0..12 {
            let order: Vec<usize> = (0..12).map(|i| (5 * i + shift) % 12).collect();
            let found = solve(&order);
            assert!(
                found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-13),
                "{found:?} {expected:?}"
            );
            let backwards: Vec<usize> = sorted.iter().rev().copied().collect();
            assert!(solve(&backwards).iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-13));
        }
    }

    #[test]
    fn an_unknown_without_equation_is_named() {
        let mut system = Banded::new(3, 2, 1);
        system.add(0, &mut [1.0, 1.0], &mut [1.0]);
        system.add(0, &mut [2.0, 1.0], &mut [1.0]);
        assert_eq!(system.solve(), Err(2));
    }
}
