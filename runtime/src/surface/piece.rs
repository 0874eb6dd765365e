//! One rational Bézier patch of a surface, in double precision.

use alloc::vec::Vec;

use super::nearest::Piece;
use super::{Direction, SurfaceDomain};
use crate::simplex::{square_row, triangle_line};
use crate::{CurveError, CurvePiece, Point, Scalar, TriangleIndex, bernstein};

/// One rational Bézier patch of a surface, in double precision: what a [`BoundedSurface`](crate::BoundedSurface) consists
/// of.
///
/// ```text
/// S(u, v) = Σ_i Σ_j B[i,m](x) B[j,n](y) w[i,j] P[i,j] / Σ_i Σ_j B[i,m](x) B[j,n](y) w[i,j]
/// ```
///
/// with `x = (u - lo_u) / (hi_u - lo_u)` and `y` likewise; on a surface of revolution `v` is the angle and `y` the
/// parameter of a rational quadratic arc, which grows with it; over a triangle, `x = u` and `y = v / (1 - u)`.
#[derive(Clone, Debug)]
pub struct SurfacePiece {
    pub(crate) domain: [[f64; 2]; 2],
    pub(crate) kind: PieceKind,
    pub(crate) net: Piece,
}

/// A straight line in the parameters of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Line<S> {
    /// One parameter has that value, the other one is that of the line.
    Constant(Direction, S),
    /// The edge `v = 1 - u` of a triangle, with the parameter `u`.
    Diagonal,
}

impl<S: Scalar> Line<S> {
    /// The parameters of the surface at one of the line.
    #[inline]
    pub(super) fn at(self, t: S) -> (S, S) {
        match self {
            Self::Constant(Direction::U, at) => (at, t),
            Self::Constant(Direction::V, at) => (t, at),
            Self::Diagonal => (t, S::ONE - t),
        }
    }

    /// The parameters of the line.
    #[inline]
    pub(super) fn range(self, domain: SurfaceDomain<S>) -> [S; 2] {
        match self {
            Self::Constant(constant, at) => domain.range(constant, at),
            Self::Diagonal => [S::ZERO, S::ONE],
        }
    }

    /// Its parameters in the triangle, and the barycentric coordinates of both ends.
    #[inline]
    fn on_triangle(self) -> ([S; 2], [[S; 3]; 2]) {
        let range = self.range(SurfaceDomain::Triangle);
        let ends = range.map(|t| {
            let (u, v) = self.at(t);
            [u, v, S::ONE - u - v]
        });
        (range, ends)
    }
}

/// How the parameters of the surface follow from a place of the unit square.
#[derive(Clone, Debug)]
pub(crate) enum PieceKind {
    /// Linearly.
    Rectangle,
    /// `v` is the angle of a circular arc whose parameter is rational.
    Arc,
    /// They are those of a triangle. With the Bernstein coefficients of each component on the triangle, in lexicographic
    /// order.
    Triangle(Vec<Vec<f64>>),
}

impl SurfacePiece {
    /// The polynomial patch over a rectangle with these Bézier control points, row by row; a row belongs to one
    /// function of `u`, and there are `rows` of them.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the number of points is no multiple of the number of rows.
    #[inline]
    pub fn polynomial<P: Point>(
        domain: [[P::Scalar; 2]; 2],
        rows: usize,
        points: &[P],
    ) -> Result<Self, CurveError> {
        let columns = columns(rows, points.len())?;
        let of = |n: usize, c: usize| points[n].component(c).to_f64();
        Ok(Self::from_fn(domain, [rows, columns], P::DIM, P::DIM, of))
    }

    /// The rational patch over a rectangle with these Bézier control points and weights, row by row.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the number of points is no multiple of the number of rows, or there is not one weight for
    /// each of them, [`CurveError::Weight`] if a weight is not positive and finite.
    #[inline]
    pub fn rational<P: Point>(
        domain: [[P::Scalar; 2]; 2],
        rows: usize,
        points: &[P],
        weights: &[P::Scalar],
    ) -> Result<Self, CurveError> {
        let columns = columns(rows, points.len())?;
        if points.len() != weights.len() {
            return Err(CurveError::Length { expected: points.len(), found: weights.len() });
        }
        for (index, &weight) in weights.iter().enumerate() {
            if !(weight > P::Scalar::ZERO && weight.is_finite()) {
                return Err(CurveError::Weight { index, value: weight.to_f64() });
            }
        }
        let of = |n: usize, c: usize| {
            let weight = weights[n].to_f64();
            if c == P::DIM { weight } else { points[n].component(c).to_f64() * weight }
        };
        Ok(Self::from_fn(domain, [rows, columns], P::DIM, P::DIM + 1, of))
    }

    /// The polynomial patch over the triangle, as [`TriangularBezier`](crate::TriangularBezier), with these Bézier control
    /// points in the lexicographic order of their indices.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the number of points is not that of a triangle, `(n + 1) (n + 2) / 2`.
    pub fn triangular<P: Point>(points: &[P]) -> Result<Self, CurveError> {
        let mut degree = 0;
        while TriangleIndex::count(degree) < points.len() {
            degree += 1;
        }
        if TriangleIndex::count(degree) != points.len() {
            return Err(CurveError::Length { expected: TriangleIndex::count(degree), found: points.len() });
        }
        let side = degree + 1;
        let (mut net, mut row) = (Vec::with_capacity(side * side), alloc::vec![P::zero(); side]);
        for i in 0..side {
            square_row(points, degree, i, &mut row);
            net.extend_from_slice(&row);
        }
        let unit = [[P::Scalar::ZERO, P::Scalar::ONE]; 2];
        let of = |n: usize, c: usize| net[n].component(c).to_f64();
        let components = (0..P::DIM).map(|c| points.iter().map(|p| p.component(c).to_f64()).collect());
        let kind = PieceKind::Triangle(components.collect());
        Ok(Self { kind, ..Self::from_fn(unit, [side, side], P::DIM, P::DIM, of) })
    }

    /// From the component `c` of the homogeneous point `n`, row by row.
    #[inline]
    pub(crate) fn from_fn<S: Scalar>(
        domain: [[S; 2]; 2],
        [rows, columns]: [usize; 2],
        dim: usize,
        stride: usize,
        of: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let mut net = Vec::with_capacity(rows * columns * stride);
        for j in 0..columns {
            for i in 0..rows {
                net.extend((0..stride).map(|c| of(i * columns + j, c)));
            }
        }
        let domain = domain.map(|ends| ends.map(Scalar::to_f64));
        Self { domain, kind: PieceKind::Rectangle, net: Piece::new([rows - 1, columns - 1], dim, net) }
    }

    /// The rectangle of parameters, or that around the triangle.
    #[inline]
    pub fn domain(&self) -> [[f64; 2]; 2] {
        self.domain
    }

    /// The degrees in both directions.
    #[inline]
    pub fn degrees(&self) -> [usize; 2] {
        self.net.degrees()
    }

    /// The parameters of the surface at a place of the unit square.
    #[inline]
    pub(crate) fn parameters(&self, at: [f64; 2]) -> [f64; 2] {
        let linear = [0, 1].map(|axis| crate::domain::from_unit(self.domain[axis], at[axis]));
        match self.kind {
            PieceKind::Rectangle => linear,
            PieceKind::Arc => [linear[0], arc_angle(self.domain[1], at[1])],
            PieceKind::Triangle(_) => SurfaceDomain::Triangle.at(at[0], at[1]).into(),
        }
    }

    /// The smallest ranges around the parameters of the surface over a rectangle in the unit square.
    #[inline]
    pub(crate) fn parameter_ranges(&self, [[x0, x1], [y0, y1]]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        let [[from_u, from_v], [to_u, to_v]] = [[x0, y0], [x1, y1]].map(|at| self.parameters(at));
        if let PieceKind::Triangle(_) = self.kind {
            // v falls as u grows.
            let [[_, low], [_, high]] = [[x1, y0], [x0, y1]].map(|at| self.parameters(at));
            return [[from_u, to_u], [low, high]];
        }
        [[from_u, to_u], [from_v, to_v]]
    }

    /// The place in the unit square of a parameter in one direction, not of a triangle.
    #[inline]
    pub(crate) fn place(&self, axis: usize, t: f64) -> f64 {
        let range = self.domain[axis];
        match self.kind {
            PieceKind::Arc if axis == 1 => arc_place(range, t),
            _ => crate::domain::unit(range, t)[1],
        }
    }

    /// The same patch over its unit square instead of the triangle.
    #[cfg(feature = "mesh")]
    pub(crate) fn on_square(self) -> Self {
        let kind = if let PieceKind::Triangle(_) = self.kind { PieceKind::Rectangle } else { self.kind };
        Self { kind, ..self }
    }

    /// The curve on the patch along a line of the parameters, over its part of the domain.
    #[inline]
    pub(super) fn curve_along(&self, along: Line<f64>) -> CurvePiece {
        let dim = self.net.dim();
        if let PieceKind::Triangle(components) = &self.kind {
            let (range, ends) = along.on_triangle();
            let degree = self.degrees()[0];
            let coefficients = components.iter().flat_map(|net| triangle_line(net, degree, ends)).collect();
            return CurvePiece::of_numerators(
                range,
                dim,
                coefficients,
                core::iter::repeat_n(1.0, degree + 1),
            );
        }
        let Line::Constant(constant, at) = along else {
            // A surface over a triangle whose patches are not: nothing bounds the curve.
            return CurvePiece::of_numerators(
                [0.0, 1.0],
                dim,
                alloc::vec![f64::NAN; dim],
                core::iter::once(1.0),
            );
        };
        let free = usize::from(constant == Direction::U);
        let (x, degrees) = (self.place(1 - free, at), self.degrees());
        let rows = degrees[0] + 1;
        // The component `c` of the control points of the curve; of the weights for the dimension of the points.
        let component = |c: usize| {
            (0..=degrees[free]).map(move |k| {
                let control = |l: usize| {
                    let [i, j] = if free == 0 { [k, l] } else { [l, k] };
                    if c == dim { self.net.weight(j * rows + i) } else { self.net.point(i, j)[c] }
                };
                bernstein::eval(&(0..=degrees[1 - free]).map(control).collect::<Vec<f64>>(), x)
            })
        };
        let mut coefficients: Vec<f64> = (0..dim).flat_map(component).collect();
        if !component(dim).all(|weight| weight > 0.0) {
            // Nothing bounds the curve: as if a point of it were not finite.
            coefficients.fill(f64::NAN);
        }
        CurvePiece::of_numerators(self.domain[free], dim, coefficients, component(dim))
    }
}

/// The angle at the parameter of a rational quadratic arc from `lo` to `hi` with equal weights at its ends.
#[inline]
pub(super) fn arc_angle([lo, hi]: [f64; 2], y: f64) -> f64 {
    if y <= 0.0 || y >= 1.0 {
        return crate::domain::from_unit([lo, hi], y);
    }
    // y / (1 - y) = sin(φ/2) / sin((δ - φ)/2) for the angle φ in an arc of the angle δ.
    let (sin, cos) = Scalar::sin_cos(0.5 * (hi - lo));
    lo + 2.0 * Scalar::atan2(y * sin, (1.0 - y) + y * cos)
}

/// The parameter of the rational arc at an angle; beyond its ends not that of the circle, on which it is infinite somewhere.
#[inline]
pub(super) fn arc_place([lo, hi]: [f64; 2], angle: f64) -> f64 {
    if angle <= lo || angle >= hi {
        return crate::domain::unit([lo, hi], angle)[1];
    }
    let [before, after] = [angle - lo, hi - angle].map(|angle| Scalar::sin_cos(0.5 * angle).0);
    before / (before + after)
}

#[inline]
fn columns(rows: usize, points: usize) -> Result<usize, CurveError> {
    let columns = points.checked_div(rows).unwrap_or(0);
    if columns > 0 && rows * columns == points {
        Ok(columns)
    } else {
        Err(CurveError::Length { expected: rows.max(1) * (columns + 1), found: points })
    }
}
