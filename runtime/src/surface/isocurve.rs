//! The curves on a surface of any type along which one parameter is constant.

use alloc::vec::Vec;
use core::fmt::{self, Debug, Formatter};
use core::ops::Range;

use super::piece::{Line, PieceKind, arc_angle, arc_place};
use super::{BoundedSurface, Direction, Edge, ScalarOf, Surface, SurfaceDomain, VectorOf};
use crate::curve::{divisible, nonempty};
use crate::domain::from_unit;
use crate::numeric::binomial::binomial;
use crate::{CurveError, CurvePiece, ParametricCurve, Point, RationalBezier, Scalar};

/// The curve `v ↦ S(u, v)` or `u ↦ S(u, v)` on a surface of any type, with the parameter of the surface: what
/// [`BoundedSurface::isocurve`] and [`BoundedSurface::boundary`] give. All that is asked of curves can be asked of it.
///
/// The curve on which `u` is constant has the parameter `v`; on a surface of revolution that is the angle, over a triangle
/// it ends at `1 - u`. The edge `v = 1 - u` of a triangle has the parameter `u`, and the corner `u = 1` is a curve of
/// one point over `0 <= v <= 0`. Parts have
/// their part of the domain; one that runs backwards over `lo <= t <= hi` is at `t` where the surface has the parameter
/// `lo + hi - t`.
///
/// ```
/// use basis_runtime::{Bezier, Direction, Isocurve, ParametricCurve, Surface, SurfaceOfRevolution};
///
/// let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [2.0, 2.0]]), 3.0)?;
/// let circle = Isocurve::new(&cone, Direction::U, 0.5);
/// assert_eq!(circle.domain(), [0.0, 3.0]);
/// assert_eq!(circle.eval(0.7), cone.eval(0.5, 0.7));
/// assert!((circle.arclen(1e-9) - 3.0_f64).abs() < 1e-9); // an angle of 3 on a circle of radius 1
/// # Ok::<(), basis_runtime::RevolutionError>(())
/// ```
pub struct Isocurve<'a, T: Surface + ?Sized> {
    surface: &'a T,
    line: Line<ScalarOf<T>>,
    /// The part of the domain of the surface.
    domain: [ScalarOf<T>; 2],
    backwards: bool,
    /// All of the curve on the surface.
    pieces: Vec<CurvePiece>,
    /// The domains of the pieces in which the parameter is the angle of an arc.
    arcs: Vec<[f64; 2]>,
}

impl<T: Surface + ?Sized> Clone for Isocurve<'_, T> {
    fn clone(&self) -> Self {
        Self { pieces: self.pieces.clone(), arcs: self.arcs.clone(), ..*self }
    }
}

impl<T: Surface + ?Sized> Debug for Isocurve<'_, T>
where
    ScalarOf<T>: Debug,
{
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Isocurve")
            .field("line", &self.line)
            .field("domain", &self.domain)
            .field("backwards", &self.backwards)
            .finish_non_exhaustive()
    }
}

impl<'a, T: BoundedSurface + ?Sized> Isocurve<'a, T> {
    /// The curve on which the parameter `constant` is `at`, also of a `&dyn BoundedSurface`. Where a surface is made of
    /// patches it is a curve of the later one; outside of the domain the formulas of the outermost patches are
    /// continued.
    pub fn new(surface: &'a T, constant: Direction, at: ScalarOf<T>) -> Self {
        Self::on(surface, Line::Constant(constant, at))
    }

    /// The curve along an edge, also of a `&dyn BoundedSurface`.
    pub fn along(surface: &'a T, edge: Edge) -> Self {
        let domain = surface.domain();
        let [u, v] = domain.ranges();
        let line = match edge {
            Edge::UStart => Line::Constant(Direction::U, u[0]),
            Edge::UEnd => Line::Constant(Direction::U, u[1]),
            Edge::VStart => Line::Constant(Direction::V, v[0]),
            Edge::VEnd if domain == SurfaceDomain::Triangle => Line::Diagonal,
            Edge::VEnd => Line::Constant(Direction::V, v[1]),
        };
        Self::on(surface, line)
    }

    fn on(surface: &'a T, line: Line<ScalarOf<T>>) -> Self {
        let (free, at) = match line {
            Line::Constant(Direction::U, at) => (1, at.to_f64()),
            Line::Constant(Direction::V, at) => (0, at.to_f64()),
            Line::Diagonal => (0, 0.0),
        };
        let along = match line {
            Line::Constant(constant, _) => Line::Constant(constant, at),
            Line::Diagonal => Line::Diagonal,
        };
        let mut nets = surface.pieces();
        let starts = nets.iter().map(|piece| piece.domain()[1 - free][0]);
        let first = starts.clone().fold(f64::INFINITY, f64::min);
        let here = starts.filter(|&start| start <= at).fold(first, f64::max);
        nets.retain(|piece| piece.domain()[1 - free][0] == here);
        nets.sort_by(|a, b| a.domain()[free][0].total_cmp(&b.domain()[free][0]));
        let turns = nets.iter().filter(|net| free == 1 && matches!(net.kind, PieceKind::Arc));
        let arcs = turns.map(|net| net.domain()[1]).collect();
        let pieces = nets.iter().map(|net| net.curve_along(along)).collect();
        Self { surface, line, domain: line.range(surface.domain()), backwards: false, pieces, arcs }
    }

    /// The parameters `(u, v)` of the surface at the parameter `t` of the curve.
    pub fn surface_parameters(&self, t: ScalarOf<T>) -> (ScalarOf<T>, ScalarOf<T>) {
        self.line.at(self.free(t))
    }

    /// The parameter of the surface that belongs to one of the curve, and the other way round.
    fn free(&self, t: ScalarOf<T>) -> ScalarOf<T> {
        let [lo, hi] = self.domain;
        match t {
            _ if !self.backwards => t,
            _ if t == lo => hi,
            _ if t == hi => lo,
            _ => lo + hi - t,
        }
    }

    /// The parameter of the pieces that belongs to one of the surface.
    fn place(&self, free: f64) -> f64 {
        let arc = self.arcs.iter().find(|[lo, hi]| (*lo..=*hi).contains(&free));
        arc.map_or(free, |&arc| from_unit(arc, arc_place(arc, free)))
    }

    /// The ends of the domain as parameters of the pieces.
    fn ends(&self) -> [f64; 2] {
        self.domain.map(|t| self.place(t.to_f64()))
    }

    fn part(&self, domain: [ScalarOf<T>; 2], turned: bool) -> Self {
        Self { domain, backwards: self.backwards ^ turned, ..self.clone() }
    }

    /// The piece that ends at a parameter of the surface before another one begins.
    fn piece_before(&self, free: f64) -> Option<&CurvePiece> {
        let ends = |piece: &&CurvePiece| self.arcs.is_empty() && piece.domain()[1] == free;
        let (_, before) = self.pieces.split_last()?;
        before.iter().find(ends)
    }
}

impl<T: BoundedSurface + ?Sized> ParametricCurve for Isocurve<'_, T> {
    type Point = T::Point;
    type Part = Self;

    fn domain(&self) -> [ScalarOf<T>; 2] {
        self.domain
    }

    fn eval(&self, t: ScalarOf<T>) -> T::Point {
        let (u, v) = self.surface_parameters(t);
        self.surface.eval(u, v)
    }

    fn derivatives_into(&self, t: ScalarOf<T>, derivatives: &mut [VectorOf<T>]) {
        let free = self.free(t);
        // The later piece of the surface is the earlier one of a curve that runs backwards, and at the end of a part it
        // does not belong to it.
        let earlier = if self.backwards { free > self.domain[0] } else { free == self.domain[1] };
        let before = self.piece_before(free.to_f64()).filter(|_| earlier);
        let bezier = before.and_then(|piece| {
            let control = |i: usize| Point::from_components(|d| ScalarOf::<T>::of(piece.control(i, d)));
            let points: Vec<T::Point> = (0..=piece.degree()).map(control).collect();
            let weights = piece.weights().map_or(alloc::vec![1.0; points.len()], <[f64]>::to_vec);
            let weights: Vec<ScalarOf<T>> = weights.into_iter().map(ScalarOf::<T>::of).collect();
            Some(
                RationalBezier::new(points, weights).ok()?.with_domain(piece.domain().map(ScalarOf::<T>::of)),
            )
        });
        if let Some(bezier) = bezier {
            bezier.derivatives_into(free, derivatives);
        } else {
            let (u, v) = self.surface_parameters(t);
            let partial = |orders| self.surface.partial(u, v, orders);
            for (order, derivative) in derivatives.iter_mut().enumerate() {
                *derivative = match self.line {
                    Line::Constant(Direction::U, _) => partial([0, order]),
                    Line::Constant(Direction::V, _) => partial([order, 0]),
                    // (∂u - ∂v)^order
                    Line::Diagonal => (0..=order).fold(VectorOf::<T>::zero(), |sum, j| {
                        let factor = binomial::<ScalarOf<T>>(order, j);
                        let sign = if j.is_multiple_of(2) { factor } else { -factor };
                        sum.add_weighted(partial([order - j, j]), sign)
                    }),
                };
            }
        }
        if self.backwards {
            for derivative in derivatives.iter_mut().skip(1).step_by(2) {
                *derivative = derivative.scale(-ScalarOf::<T>::ONE);
            }
        }
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        let [from, to] = self.ends();
        if from == to {
            // The corner of a triangle.
            return self.pieces.clone();
        }
        let part = |piece: &CurvePiece| {
            let [lo, hi] = piece.domain();
            let [a, b] = [lo.max(from), hi.min(to)];
            let part = if a == lo && b == hi {
                piece.clone()
            } else {
                piece.restricted(piece.place(a), piece.place(b)).over([a, b])
            };
            if self.backwards { part.restricted(1.0, 0.0).over([from + to - b, from + to - a]) } else { part }
        };
        let inside = self.pieces.iter().filter(|piece| piece.domain()[0] < to && piece.domain()[1] > from);
        let mut pieces: Vec<CurvePiece> = inside.map(part).collect();
        if self.backwards {
            pieces.reverse();
        }
        pieces
    }

    fn split(&self, t: ScalarOf<T>) -> Result<[Self; 2], CurveError> {
        divisible(self.domain, t)?;
        let ([lo, hi], free) = (self.domain, self.free(t));
        let parts = [self.part([lo, free], false), self.part([free, hi], false)];
        let [before, after] = parts;
        Ok(if self.backwards { [after, before] } else { [before, after] })
    }

    fn subsegment(&self, range: Range<ScalarOf<T>>) -> Result<Self, CurveError> {
        nonempty(self.domain, &range)?;
        let [a, b] = [range.start, range.end].map(|t| self.free(t));
        Ok(self.part(if a < b { [a, b] } else { [b, a] }, range.start > range.end))
    }

    fn reversed(&self) -> Self {
        self.part(self.domain, true)
    }

    fn parameter_of(&self, place: f64) -> ScalarOf<T> {
        let [from, to] = self.ends();
        let place = if self.backwards { from + to - place } else { place };
        let arc = self.arcs.iter().find(|[lo, hi]| (*lo..=*hi).contains(&place));
        let free = arc.map_or(place, |&[lo, hi]| arc_angle([lo, hi], (place - lo) / (hi - lo)));
        self.free(crate::geometry::clamped(self.domain, ScalarOf::<T>::of(free)))
    }

    fn place_of(&self, t: ScalarOf<T>) -> f64 {
        let place = self.place(self.free(t).to_f64());
        let [from, to] = self.ends();
        if self.backwards { from + to - place } else { place }
    }
}
