//! Method (a), that of the paper: equations at both ends and the middle of every span, and a quadratic programme for
//! the rest, solved by its Karush–Kuhn–Tucker system.
//!
//! Source: Huang W. et al., *A smooth splicing method for B-spline surfaces*.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::SpliceError;
use super::correct::correction;
use super::strip::{Strip, Vector};
use crate::Point;
use crate::bspline::KnotVector;

/// Eigenvalues below this part of the largest one are zero: the objective does not see the direction.
const FLAT: f64 = 1e-10;

/// Both ends of the domain, and the middle of every span.
fn samples(knots: &KnotVector<f64>) -> Vec<f64> {
    let [lo, hi] = knots.domain();
    let all = knots.as_slice();
    let middles = knots.spans().map(|span| all[span] + (all[span + 1] - all[span]) * 0.5);
    core::iter::once(lo).chain(middles).chain([hi]).collect()
}

/// The derivatives of that order of all basis functions at the samples, a row for each.
fn collocation(knots: &KnotVector<f64>, samples: &[f64], order: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(samples.len(), knots.functions());
    for (row, &t) in samples.iter().enumerate() {
        let span = knots.span(t);
        for (j, &value) in knots.derivatives_on(span, t, order).iter().enumerate() {
            matrix[(row, span - knots.degree() + j)] = value;
        }
    }
    matrix
}

/// The equations `A x = b` of the samples, by a QR decomposition of `Aᵀ`: `A` has full row rank at degree 2 and above.
struct Equations {
    /// All of the orthogonal factor; its first columns span the rows of `A`, the others the null space.
    orthogonal: DMatrix<f64>,
    triangular: DMatrix<f64>,
    count: usize,
}

impl Equations {
    fn new(matrix: &DMatrix<f64>) -> Self {
        let unknowns = matrix.ncols();
        let decomposition = matrix.transpose().qr();
        let mut orthogonal = DMatrix::identity(unknowns, unknowns);
        decomposition.q_tr_mul(&mut orthogonal);
        orthogonal.transpose_mut();
        Self { orthogonal, triangular: decomposition.r(), count: matrix.nrows() }
    }

    /// The solution with the least norm, `Aᵀ (A Aᵀ)⁻¹ b`: that of the KKT system of `min |x|²` subject to `A x = b`.
    fn least(&self, right: &DMatrix<f64>) -> Result<DMatrix<f64>, SpliceError> {
        let coordinates = self.triangular.tr_solve_upper_triangular(right).ok_or(SpliceError::Singular)?;
        Ok(self.orthogonal.columns(0, self.count) * coordinates)
    }

    fn null_space(&self) -> DMatrix<f64> {
        let unknowns = self.orthogonal.nrows();
        self.orthogonal.columns(self.count, unknowns - self.count).into_owned()
    }
}

fn matrix(rows: &[Vector]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), 3, |i, j| rows[i][j])
}

/// Moves the edge through the samples of the target's, with tangents as parallel as possible.
///
/// Minimises `Σ |S_v(q) × T_t(q)|² = Σ S_vᵀ W S_v`, `W = |c|² I - c cᵀ` with `c = T_t(q)`, subject to `S(q) = T(q)`.
/// The KKT system is solved in its null-space form: the solutions of the equations are `x + Z y`, with the least change
/// `x` and a basis `Z` of the null space; what remains is a positive semidefinite system in `y`. Where it is singular,
/// as for straight edges, the `y` of least norm is taken, and `x + Z y` is then the smallest of all optimal changes.
pub(super) fn edge(strip: &mut Strip, target: &Strip) -> Result<Vec<Vector>, SpliceError> {
    let samples = samples(&strip.knots);
    let frames: Vec<_> = samples.iter().map(|&t| target.at(t)).collect();
    let wanted: Vec<_> =
        samples.iter().zip(&frames).map(|(&t, to)| to.point.minus(strip.at(t).point)).collect();
    let equations = Equations::new(&collocation(&strip.knots, &samples, 0));
    let mut change = equations.least(&matrix(&wanted))?;

    let free = equations.null_space();
    let r = free.ncols();
    if r > 0 {
        let slopes = collocation(&strip.knots, &samples, 1);
        let moved = &slopes * (matrix(&strip.edge) + &change);
        let directions = &slopes * &free;
        let mut hessian = DMatrix::zeros(3 * r, 3 * r);
        let mut gradient = DVector::zeros(3 * r);
        for (l, frame) in frames.iter().enumerate() {
            let c = Vector3::from(frame.tangent);
            let weight = Matrix3::identity() * c.norm_squared() - c * c.transpose();
            let pull = weight * moved.row(l).transpose();
            for a in 0..r {
                for i in 0..3 {
                    gradient[3 * a + i] += directions[(l, a)] * pull[i];
                }
                for b in 0..r {
                    let factor = directions[(l, a)] * directions[(l, b)];
                    let mut block = hessian.fixed_view_mut::<3, 3>(3 * a, 3 * b);
                    block += weight * factor;
                }
            }
        }
        let eigen = hessian.symmetric_eigen();
        let largest = eigen.eigenvalues.amax();
        let mut coordinates = eigen.eigenvectors.tr_mul(&gradient);
        for (coordinate, &value) in coordinates.iter_mut().zip(eigen.eigenvalues.iter()) {
            *coordinate = if value > FLAT * largest { -*coordinate / value } else { 0.0 };
        }
        let y = eigen.eigenvectors * coordinates;
        change += free * DMatrix::from_fn(r, 3, |a, i| y[3 * a + i]);
    }
    Ok(add(&mut strip.edge, &change))
}

/// Turns the second row into the tangent planes of the target at the samples, with the least change of its points.
pub(super) fn inner(strip: &mut Strip, target: &Strip) -> Result<(), SpliceError> {
    let samples = samples(&strip.knots);
    let wanted: Result<Vec<_>, _> = samples.iter().map(|&t| correction(strip, target, t)).collect();
    let equations = Equations::new(&collocation(&strip.knots, &samples, 0));
    let change = equations.least(&matrix(&wanted?))?;
    add(&mut strip.inner, &change);
    Ok(())
}

fn add(row: &mut [Vector], change: &DMatrix<f64>) -> Vec<Vector> {
    let changes = change.row_iter().map(|row| [row[0], row[1], row[2]]).collect::<Vec<Vector>>();
    for (point, change) in row.iter_mut().zip(&changes) {
        *point = point.add_weighted(*change, 1.0);
    }
    changes
}
