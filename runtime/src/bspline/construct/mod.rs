//! Surfaces from curves: extruded, ruled, translated, lofted, swept, and filled between four boundary curves.

mod error;
mod rational;

use alloc::vec::Vec;

pub use error::ConstructionError;

use super::fit::{averaged, parameters_of_rows};
use super::{BSplineCurve, BSplineSurface, Direction, KnotVector, Net, Spacing};
use crate::vector::{distance, is_finite, recast};
use crate::{CurveError, Frame, ParametricCurve, Point, Point3, Scalar};

/// More sections of a sweep are refused.
const MOST_SECTIONS: usize = 1 << 16;

impl<P: Point> BSplineSurface<P> {
    /// The surface `S(u, v) = C(u) + v · along`, `0 <= v <= 1`, over the curve's own knots in `u`.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineCurve, BSplineSurface};
    ///
    /// let arch = BSplineCurve::from_bezier([[0.0, 0.0, 0.0], [1.0, 0.0, 2.0], [2.0, 0.0, 0.0]])?;
    /// let wall = BSplineSurface::extruded(&arch, [0.0, 3.0, 0.0])?;
    /// assert_eq!(wall.eval(0.5, 1.0), [1.0, 3.0, 1.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ConstructionError::Curve`] if a control point of the surface is not finite.
    pub fn extruded(curve: &BSplineCurve<P>, along: P::Vector) -> Result<Self, ConstructionError> {
        let along = recast(along);
        let rows = curve.control_points().iter().map(|&p| [p, p.add_weighted(along, P::Scalar::ONE)]);
        finite(Self::new(curve.knots().clone(), KnotVector::uniform(1, 1)?, Net::from_rows(rows)?)?)
    }

    /// The surface `S(u, v) = (1 - v) A(u) + v B(u)`, `0 <= v <= 1`: the straight lines between points of two curves with
    /// the same parameter. The domain is that of the first curve; that of the second one is mapped to it.
    ///
    /// # Errors
    /// [`ConstructionError::Knots`] if the common knots are too many or lie too near to each other,
    /// [`ConstructionError::Curve`] if a control point of the surface is not finite.
    pub fn ruled(first: &BSplineCurve<P>, second: &BSplineCurve<P>) -> Result<Self, ConstructionError> {
        let both = compatible(&[first, second])?;
        let [a, b] = [0, 1].map(|i| &both[i]);
        let rows = a.control_points().iter().zip(b.control_points()).map(|(&a, &b)| [a, b]);
        finite(Self::new(a.knots().clone(), KnotVector::uniform(1, 1)?, Net::from_rows(rows)?)?)
    }

    /// The surface `S(u, v) = C(u) + T(v) - T(lo)` that a curve sweeps when it is moved along another one without
    /// turning, exactly.
    ///
    /// # Errors
    /// [`ConstructionError::Curve`] if a control point of the surface is not finite.
    pub fn translated(curve: &BSplineCurve<P>, path: &BSplineCurve<P>) -> Result<Self, ConstructionError> {
        let start = path.start();
        let rows = curve.control_points().iter().map(|&p| {
            let moved = |&t: &P| p.add_scaled(t.minus(start), P::Scalar::ONE);
            path.control_points().iter().map(moved).collect::<Vec<_>>()
        });
        finite(Self::new(curve.knots().clone(), path.knots().clone(), Net::from_rows(rows)?)?)
    }

    /// The surface of that degree in `v` through all sections, one after the other: `S(u, v[k]) = C_k(u)` at parameters
    /// `0 = v[0] < … < v[n - 1] = 1` that [`Spacing`] gives for the control points of the sections, and the mean of them.
    ///
    /// The sections may have any knots and degrees; all are mapped to the domain of the first. They should run in the
    /// same direction.
    ///
    /// # Errors
    /// [`ConstructionError::Fit`] if there are not more sections than the degree (and two), or neighbours coincide;
    /// the others as for [`ruled`](Self::ruled).
    pub fn lofted(
        sections: &[BSplineCurve<P>],
        degree: usize,
        spacing: Spacing,
    ) -> Result<Self, ConstructionError> {
        let all = compatible(&sections.iter().collect::<Vec<_>>())?;
        let grid = grid(&all)?;
        Self::through(&all[0], &grid, degree, &parameters_of_rows(&grid, spacing)?)
    }

    /// The surface through sections over the knots of the first, whose control points are the columns of a grid.
    fn through(
        first: &BSplineCurve<P>,
        grid: &Net<P>,
        degree: usize,
        parameters: &[P::Scalar],
    ) -> Result<Self, ConstructionError> {
        let v = averaged(degree, parameters)?;
        let rows: Vec<Vec<P>> = (0..grid.rows())
            .map(|i| {
                let row = BSplineCurve::interpolate_at(v.clone(), parameters, grid.row(i))?;
                Ok(row.control_points().to_vec())
            })
            .collect::<Result<_, ConstructionError>>()?;
        finite(Self::new(first.knots().clone(), v, Net::from_rows(rows)?)?)
    }

    /// The surface of Coons with these four boundary curves, `along_u` at the lower and the upper end of `v` and `along_v`
    /// at the lower and the upper end of `u`:
    ///
    /// ```text
    /// S(u, v) = (1-v) A0(u) + v A1(u) + (1-u) B0(v) + u B1(v)
    ///           - (1-u)(1-v) P00 - u (1-v) P10 - (1-u) v P01 - u v P11
    /// ```
    ///
    /// over `0 <= u, v <= 1`, to which the domains are mapped; exact, as the sum of three B-spline surfaces (S. A. Coons,
    /// "Surfaces for computer-aided design of space forms", 1967).
    ///
    /// # Errors
    /// [`ConstructionError::Corner`] if two curves that should meet in a corner are farther from each other there than
    /// `tolerance`, or that is NaN; the others as for [`ruled`](Self::ruled).
    pub fn coons(
        along_u: [&BSplineCurve<P>; 2],
        along_v: [&BSplineCurve<P>; 2],
        tolerance: P::Scalar,
    ) -> Result<Self, ConstructionError> {
        let on_unit = |curve: &BSplineCurve<P>| {
            let knots = curve.knots().mapped([P::Scalar::ZERO, P::Scalar::ONE])?;
            Ok::<_, ConstructionError>(BSplineCurve::new(knots, curve.control_points())?.clamped())
        };
        let [a0, a1, b0, b1] =
            [on_unit(along_u[0])?, on_unit(along_u[1])?, on_unit(along_v[0])?, on_unit(along_v[1])?];
        let corners = [
            [(a0.start(), b0.start()), (a1.start(), b0.end())],
            [(a0.end(), b1.start()), (a1.end(), b1.end())],
        ];
        for (u, pair) in corners.iter().enumerate() {
            for (v, &(a, b)) in pair.iter().enumerate() {
                let gap = distance(a, b);
                if gap.is_nan() || tolerance.is_nan() || gap > tolerance {
                    return Err(ConstructionError::Corner { corner: [u, v], gap: gap.to_f64() });
                }
            }
        }
        let across_v = Self::ruled(&a0, &a1)?;
        let across_u = Self::ruled(&b0, &b1)?.transposed();
        let line = KnotVector::uniform(1, 1)?;
        let half = P::Scalar::of(0.5);
        let corner = |i: usize, j: usize| {
            let (a, b) = corners[i][j];
            a.scale(half).add_weighted(b, half)
        };
        let bilinear = Self::new(line.clone(), line, Net::from_fn(2, 2, corner)?)?;
        let [first, _] = across_v.merged(&across_u)?;
        let [first, third] = first.merged(&bilinear)?;
        let [second, _] = across_u.merged(&first)?;
        let points = first.net().as_slice().iter().zip(second.net().as_slice()).zip(third.net().as_slice());
        let points =
            points.map(|((&a, &b), &c)| a.add_weighted(b, P::Scalar::ONE).add_weighted(c, -P::Scalar::ONE));
        let net = Net::trusted(points.collect(), first.net().columns());
        let [u, v] = [Direction::U, Direction::V].map(|direction| first.knots(direction).clone());
        finite(Self::new(u, v, net)?)
    }
}

impl<P: Point3> BSplineSurface<P> {
    /// The surface that a profile sweeps along a path without turning about it: through the profile in `count` frames at
    /// equal distances of the parameter of the path, interpolated by cubic curves in `v`, `0 <= v <= 1`.
    ///
    /// The profile stands in coordinates of the frame: its first component goes along the normal, the second one along
    /// the binormal and the third one along the tangent. The frames are those of
    /// [`rotation_minimizing_frames`](ParametricCurve::rotation_minimizing_frames), the first with the given normal.
    /// Between the frames the surface is a smooth blend, nearer to the exact sweep the more there are: the distance falls
    /// with the fourth power of their number.
    ///
    /// # Errors
    /// [`ConstructionError::Curve`] if the path is a point, there are more than 2¹⁶ frames, or a control point of the surface
    /// is not finite, [`ConstructionError::Fit`] for fewer than two frames, or if neighbouring sections coincide.
    pub fn swept(
        profile: &BSplineCurve<P>,
        path: &(impl ParametricCurve<Point = P> + ?Sized),
        count: usize,
        normal: Option<P::Vector>,
    ) -> Result<Self, ConstructionError> {
        sweep(path, count, normal, |frame| profile.map(|p| placed(frame, p)), Self::lofted)
    }
}

/// The surface, if all of its control points are finite.
fn finite<P: Point>(surface: BSplineSurface<P>) -> Result<BSplineSurface<P>, ConstructionError> {
    let all = surface.net().as_slice().iter().all(|&point| is_finite(point));
    if all { Ok(surface) } else { Err(CurveError::NotFinite.into()) }
}

/// The surface that `loft` puts through the sections in the frames of a path.
fn sweep<P: Point3, C, T>(
    path: &(impl ParametricCurve<Point = P> + ?Sized),
    count: usize,
    normal: Option<P::Vector>,
    section: impl Fn(&Frame<P>) -> C,
    loft: impl FnOnce(&[C], usize, Spacing) -> Result<T, ConstructionError>,
) -> Result<T, ConstructionError> {
    if count > MOST_SECTIONS {
        return Err(CurveError::TooManyPoints { needed: count as f64 }.into());
    }
    let frames = path.rotation_minimizing_frames(count, normal)?;
    let sections: Vec<C> = frames.iter().map(section).collect();
    // The frames lie at equal distances of the parameter.
    loft(&sections, 3.min(count.saturating_sub(1)), Spacing::Uniform)
}

/// The point with these coordinates in a frame.
fn placed<P: Point3>(frame: &Frame<P>, p: P) -> P {
    let [normal, binormal, tangent] = [frame.normal, frame.binormal, frame.tangent].map(recast::<_, P>);
    let along_normal = frame.point.add_weighted(normal, p.component(0));
    along_normal.add_weighted(binormal, p.component(1)).add_weighted(tangent, p.component(2))
}

/// The control points of curves over one knot vector, those of a curve as a column.
fn grid<P: Point>(curves: &[BSplineCurve<P>]) -> Result<Net<P>, ConstructionError> {
    let Some(first) = curves.first() else {
        return Err(super::FitError::TooFew { needed: 2, found: 0 }.into());
    };
    Ok(Net::from_fn(first.control_points().len(), curves.len(), |i, j| curves[j].control_points()[i])?)
}

/// The curves over one knot vector, the domain being that of the first; no point changes.
fn compatible<P: Point>(curves: &[&BSplineCurve<P>]) -> Result<Vec<BSplineCurve<P>>, ConstructionError> {
    let Some(first) = curves.first() else { return Ok(Vec::new()) };
    let domain = first.domain();
    let mut mapped = Vec::with_capacity(curves.len());
    for curve in curves {
        let knots =
            if curve.domain() == domain { curve.knots().clone() } else { curve.knots().mapped(domain)? };
        mapped.push(BSplineCurve::trusted(knots, curve.control_points().to_vec()));
    }
    // One curve after the other gives its knots to the last, which then gives all of them to each.
    let mut finest = mapped[0].clone();
    for curve in &mapped {
        let [merged, _] = finest.merged(curve)?;
        finest = merged;
    }
    let merged = mapped.iter().map(|curve| {
        let [merged, _] = curve.merged(&finest)?;
        Ok(merged)
    });
    merged.collect()
}
