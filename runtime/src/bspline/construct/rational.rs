//! Surfaces from rational curves.

use alloc::vec::Vec;

use super::super::fit::parameters_of_rows;
use super::super::{
    BSplineCurve, BSplineSurface, Homogeneous, KnotVector, Net, NurbsCurve, NurbsSurface, Spacing,
    SplineError,
};
use super::{ConstructionError, compatible, finite, grid, placed, sweep};
use crate::vector::recast;
use crate::{ParametricCurve, Point, Point3, Scalar};

/// How often the boundary curves of a Coons surface are refined until all weights are positive.
const REFINEMENTS: usize = 4;

impl<P: Point> NurbsSurface<P> {
    /// The surface `S(u, v) = C(u) + v · along`, `0 <= v <= 1`, with the weights of the curve: cylinders over circles and
    /// ellipses, exactly.
    ///
    /// # Errors
    /// As [`BSplineSurface::extruded`].
    pub fn extruded(curve: &NurbsCurve<P>, along: P::Vector) -> Result<Self, ConstructionError> {
        let along = recast(along);
        let rows = curve.homogeneous().control_points().iter().map(|&p| {
            let scaled = p.scaled.add_weighted(along, p.weight);
            [p, Homogeneous { scaled, weight: p.weight }]
        });
        let line = KnotVector::uniform(1, 1)?;
        let surface = BSplineSurface::new(curve.knots().clone(), line, Net::from_rows(rows)?)?;
        Ok(Self::from_homogeneous(finite(surface)?)?)
    }

    /// The surface of the straight lines between points of two curves with the same parameter, as
    /// [`BSplineSurface::ruled`] over homogeneous points: where the weights of both points differ, the parameter on the
    /// line is a rational function of `v`.
    ///
    /// # Errors
    /// As [`BSplineSurface::ruled`].
    pub fn ruled(first: &NurbsCurve<P>, second: &NurbsCurve<P>) -> Result<Self, ConstructionError> {
        Ok(Self::from_homogeneous(BSplineSurface::ruled(first.homogeneous(), second.homogeneous())?)?)
    }

    /// The surface `S(u, v) = C(u) + T(v) - T(lo)` that a curve sweeps when it is moved along another one without turning,
    /// exactly: its weights are the products of theirs.
    ///
    /// # Errors
    /// [`ConstructionError::Spline`] if a product of weights is zero,
    /// [`ConstructionError::Curve`] if one, or a control point of the surface, is not finite.
    pub fn translated(curve: &NurbsCurve<P>, path: &NurbsCurve<P>) -> Result<Self, ConstructionError> {
        let start = path.start();
        let rows = curve.homogeneous().control_points().iter().map(|p| {
            let moved = |t: &Homogeneous<P>| {
                let along = t.scaled.add_weighted(start, -t.weight);
                let scaled = p.scaled.scale(t.weight).add_weighted(along, p.weight);
                Homogeneous { scaled, weight: p.weight * t.weight }
            };
            path.homogeneous().control_points().iter().map(moved).collect::<Vec<_>>()
        });
        let net = Net::from_rows(rows)?;
        let surface = BSplineSurface::new(curve.knots().clone(), path.knots().clone(), net)?;
        Ok(Self::from_homogeneous(finite(surface)?)?)
    }

    /// The surface of that degree in `v` through all sections, as [`BSplineSurface::lofted`]: the weights are interpolated
    /// as the points are. The weights of each section are divided by the first one of them, which does not change the
    /// section.
    ///
    /// # Errors
    /// As [`BSplineSurface::lofted`], and [`ConstructionError::Spline`] if a weight between sections is not positive: more
    /// sections or a lower degree help, and the degree 1 is always possible.
    pub fn lofted(
        sections: &[NurbsCurve<P>],
        degree: usize,
        spacing: Spacing,
    ) -> Result<Self, ConstructionError> {
        let sections: Vec<_> = sections.iter().map(|section| over_first(section.homogeneous())).collect();
        let all = compatible(&sections.iter().collect::<Vec<_>>())?;
        let grid = grid(&all)?;
        let points = Net::from_fn(grid.rows(), grid.columns(), |i, j| grid.row(i)[j].project())?;
        let parameters = parameters_of_rows(&points, spacing)?;
        Ok(Self::from_homogeneous(BSplineSurface::through(&all[0], &grid, degree, &parameters)?)?)
    }

    /// The surface of Coons with these four boundary curves, as [`BSplineSurface::coons`] over homogeneous points. These
    /// have the weight 1 at the corners: where the weights at both ends of a curve differ, its parameter is changed by
    /// `s = c t / (1 - t + c t)`, which leaves the curve as it is.
    ///
    /// # Errors
    /// As [`BSplineSurface::coons`], and [`ConstructionError::Spline`] if the sum of weights is not positive inside: arcs
    /// that turn by less help.
    pub fn coons(
        along_u: [&NurbsCurve<P>; 2],
        along_v: [&NurbsCurve<P>; 2],
        tolerance: P::Scalar,
    ) -> Result<Self, ConstructionError> {
        let standard = |curve: &NurbsCurve<P>| with_weight_one_at_ends(curve.homogeneous());
        let mut u = [standard(along_u[0])?, standard(along_u[1])?];
        let mut v = [standard(along_v[0])?, standard(along_v[1])?];
        // Weights at control points may be negative where those of points are not; with more knots they are nearer.
        for _ in 0..REFINEMENTS {
            let surface = BSplineSurface::coons(u.each_ref(), v.each_ref(), tolerance)?;
            match Self::from_homogeneous(surface) {
                Err(SplineError::Weight { .. }) => {}
                surface => return Ok(surface?),
            }
            u = u.map(|curve| curve.refined());
            v = v.map(|curve| curve.refined());
        }
        Ok(Self::from_homogeneous(BSplineSurface::coons(u.each_ref(), v.each_ref(), tolerance)?)?)
    }
}

impl<P: Point3> NurbsSurface<P> {
    /// The surface that a profile sweeps along a path without turning about it, as [`BSplineSurface::swept`]: a tube, if
    /// the profile is a circle. All sections have the weights of the profile.
    ///
    /// Only the sections in the `count` frames are exact. The distance from the exact sweep falls with the fourth power of
    /// the number of frames, so that twice as many make it about 16 times smaller; comparing both surfaces tells how large
    /// it is. A closed path needs enough of them: its first and its last frame are at one point, so that the others alone
    /// say where it goes. Where the frames come back as they started, the surface meets itself;
    /// those along a closed path in space may come back turned about it.
    ///
    /// ```
    /// use basis_runtime::bspline::{KnotVector, NurbsCurve, NurbsSurface};
    /// use basis_runtime::{Bezier, Surface};
    ///
    /// let quarter = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    /// let arc = NurbsCurve::new(KnotVector::uniform(2, 1)?, quarter, [1.0, 0.5_f64.sqrt(), 1.0])?;
    /// let path = Bezier::from_points([[0.0, 0.0, 0.0], [0.0, 0.0, 4.0]]);
    /// let gutter = NurbsSurface::swept(&arc, &path, 2, Some([1.0, 0.0, 0.0]))?;
    /// let [x, y, z] = gutter.eval(0.3, 0.5);
    /// assert!((x.hypot(y) - 1.0).abs() < 1e-15 && z == 2.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`BSplineSurface::swept`].
    pub fn swept(
        profile: &NurbsCurve<P>,
        path: &(impl ParametricCurve<Point = P> + ?Sized),
        count: usize,
        normal: Option<P::Vector>,
    ) -> Result<Self, ConstructionError> {
        sweep(path, count, normal, |frame| profile.map(|p| placed(frame, p)), Self::lofted)
    }
}

/// The curve with its weights divided by the first one.
fn over_first<P: Point>(curve: &BSplineCurve<Homogeneous<P>>) -> BSplineCurve<Homogeneous<P>> {
    let first = curve.control_points().first().map_or(P::Scalar::ONE, |p| p.weight);
    if first == P::Scalar::ONE { curve.clone() } else { curve.map(|p| p.scale(P::Scalar::ONE / first)) }
}

/// The clamped curve over [0, 1] whose weights at both ends are 1.
///
/// With `t = s / D(s)`, `D(s) = c + (1 - c) s`, the homogeneous curve `D(s)^p F(t(s))` of degree `p` stands for the same
/// points. Its control points are its blossom at `p` knots each, `Π D(s[i+j]) F[i]` over `j = 1, …, p`, and with
/// `c^p = w[n] / w[0]` the weights at both ends agree.
fn with_weight_one_at_ends<P: Point>(
    curve: &BSplineCurve<Homogeneous<P>>,
) -> Result<BSplineCurve<Homogeneous<P>>, ConstructionError> {
    let one = P::Scalar::ONE;
    let clamped = curve.clamped();
    let knots = clamped.knots().mapped([P::Scalar::ZERO, one])?;
    let degree = knots.degree();
    let points = clamped.control_points();
    let [first, last] = [points[0].weight, points[points.len() - 1].weight];
    let c = if first == last {
        one
    } else {
        let root = |ratio: P::Scalar| {
            let parts = P::Scalar::from_usize(degree.max(1));
            ((ratio - one).ln_1p() / parts).exp_m1() + one
        };
        // Of numbers above 1 the difference from 1 has all digits.
        if last > first { root(last / first) } else { one / root(first / last) }
    };
    let moved: Vec<P::Scalar> =
        knots.as_slice().iter().map(|&t| if c == one { t } else { c * t / (one - t + c * t) }).collect();
    let mut points: Vec<Homogeneous<P>> = points
        .iter()
        .enumerate()
        .map(|(i, p)| {
            let factor =
                moved[i + 1..=i + degree].iter().fold(one / last, |all, &s| all * (c + (one - c) * s));
            if factor == one { *p } else { p.scale(factor) }
        })
        .collect();
    // Up to rounding they are 1 already.
    let end = points.len() - 1;
    for k in [0, end] {
        points[k] = Homogeneous::new(points[k].project(), one);
    }
    Ok(BSplineCurve::new(KnotVector::new(degree, moved)?, points)?)
}
