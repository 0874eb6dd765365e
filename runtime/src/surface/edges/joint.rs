//! How smoothly two surfaces meet along an edge, measured at samples.

use super::{Edge, EdgePair, Orientation};
use crate::curve::leading_order;
use crate::surface::limit::rounding;
use crate::surface::{ScalarOf, VectorOf};
use crate::vector::{cross, direction, distance, dot, largest_component, length};
use crate::{Curvature, Point, Point3, Scalar, Surface, SurfaceDomain};

/// How two surfaces meet along an edge, measured by [`Surface::joint`]: the largest figures at a number of samples.
///
/// Between the samples they may be larger. Bounds for all parameters of the edge are what
/// [`JointBounds`](crate::bspline::JointBounds) of B-spline surfaces has, with the same names.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EdgeJoint<S> {
    /// The largest distance of two points that belong together, in the unit of the points.
    pub gap: S,
    /// Where it occurs: the parameter of the first surface along its edge.
    pub gap_at: S,
    /// The largest angle in radians by which the surfaces do not continue each other: 0 where the joint is smooth, π
    /// where one folds back on the other. NaN if at no sample both surfaces have a normal.
    pub angle: S,
    /// Where it occurs: the parameter of the first surface along its edge; NaN if the angle is.
    pub angle_at: S,
    /// The largest difference of the normal curvatures, over all tangent directions, in the inverse of the unit of the
    /// points; NaN if at no sample both surfaces have curvatures.
    pub curvature: S,
    /// Where it occurs: the parameter of the first surface along its edge; NaN if the difference is.
    pub curvature_at: S,
    /// Whether the normals of both surfaces point to the same side where they continue each other, or to opposite
    /// sides. It follows from which edges are joined in which direction.
    pub normals: Orientation,
    /// The number of samples at which a surface has no normal, which do not count for the angle.
    pub without_normal: usize,
    /// The number of samples at which a surface has no curvature, as at poles, which do not count for the curvature.
    pub without_curvature: usize,
}

impl<S: Scalar> EdgeJoint<S> {
    /// The order of geometric continuity that the measured figures allow: 2 for G2, 1 for G1, 0 for G0, or `None` if
    /// there is a gap.
    ///
    /// The tolerances are in the unit of length, in radians, and in the inverse of the unit of length. A figure that is
    /// NaN is above its tolerance.
    pub fn geometric_order(&self, gap: S, angle: S, curvature: S) -> Option<usize> {
        leading_order(self.gap <= gap, [self.angle <= angle, self.curvature <= curvature])
    }
}

/// The largest of some figures, and where it occurs.
#[derive(Clone, Copy)]
struct Largest<S> {
    value: S,
    at: S,
}

impl<S: Scalar> Largest<S> {
    /// Of no figures yet.
    const NONE: Self = Self { value: S::NAN, at: S::NAN };

    /// With one figure more; a figure that is NaN stays the largest.
    fn with(self, value: S, at: S) -> Self {
        // Without a place there is no figure yet.
        let replaces = self.at.is_nan() || value > self.value || value.is_nan() && !self.value.is_nan();
        if replaces { Self { value, at } } else { self }
    }
}

/// [`Surface::joint`], with surfaces of any types.
pub(in crate::surface) fn measured<A, B>(
    first: &A,
    pair: EdgePair,
    second: &B,
    samples: usize,
) -> EdgeJoint<ScalarOf<A>>
where
    A: Surface + ?Sized,
    A::Point: Point3,
    B: Surface<Point = A::Point> + ?Sized,
{
    let EdgePair { first: first_edge, second: second_edge, orientation } = pair;
    let one = ScalarOf::<A>::ONE;
    let last = samples.max(2) - 1;
    let [mut gap, mut angle, mut curvature] = [Largest::<ScalarOf<A>>::NONE; 3];
    // Two faces have one orientation if they are on different sides of their common edge.
    let sides_differ = first_edge.surface_on_the_right() != second_edge.surface_on_the_right();
    let (normals, sign) = match (sides_differ, orientation) {
        (true, Orientation::Same) | (false, Orientation::Opposite) => (Orientation::Same, one),
        (true, Orientation::Opposite) | (false, Orientation::Same) => (Orientation::Opposite, -one),
    };
    let (mut without_normal, mut without_curvature) = (0, 0);
    for k in 0..=last {
        let x = ScalarOf::<A>::from_usize(k) / ScalarOf::<A>::from_usize(last);
        let (u, v) = first.domain().on_edge(first_edge, x);
        let at = if first_edge.runs_along_u() { u } else { v };
        let y = match orientation {
            Orientation::Same => x,
            Orientation::Opposite => one - x,
        };
        let (s, t) = second.domain().on_edge(second_edge, y);
        gap = gap.with(distance(first.eval(u, v), second.eval(s, t)), at);
        let (Some(n), Some(m)) = (first.normal(u, v), second.normal(s, t)) else {
            without_normal += 1;
            without_curvature += 1;
            continue;
        };
        let outwards = conormal(first, first_edge, u, v, n).zip(conormal(second, second_edge, s, t, m));
        let here = match outwards {
            // One continues the other if it goes in where the other goes out.
            Some((out, other)) => length(cross(out, other)).atan2(-dot(out, other)),
            // On an edge that is one point there is only the plane.
            None => length(cross(n, m)).atan2(dot(n, m).abs()),
        };
        angle = angle.with(here, at);
        if let (Some(a), Some(b)) = (first.curvature(u, v), second.curvature(s, t)) {
            curvature = curvature.with(curvature_difference(&a, &b, sign), at);
        } else {
            without_curvature += 1;
        }
    }
    EdgeJoint {
        gap: gap.value,
        gap_at: gap.at,
        angle: angle.value,
        angle_at: angle.at,
        curvature: curvature.value,
        curvature_at: curvature.at,
        normals,
        without_normal,
        without_curvature,
    }
}

/// The unit tangent that is perpendicular to the edge and points out of the surface.
fn conormal<A: Surface + ?Sized>(
    surface: &A,
    edge: Edge,
    u: ScalarOf<A>,
    v: ScalarOf<A>,
    normal: VectorOf<A>,
) -> Option<VectorOf<A>>
where
    A::Point: Point3,
{
    let mut partials = [[VectorOf::<A>::zero(); 2]; 2];
    surface.partials_into(u, v, 2, partials.as_flattened_mut()).ok()?;
    let [[point, along_v], [along_u, _]] = partials;
    let domain = surface.domain();
    let [width_u, width_v] = domain.widths();
    let is_triangle = domain == SurfaceDomain::Triangle;
    let [along, out] = edge.derivatives(is_triangle, along_u.scale(width_u), along_v.scale(width_v));
    // Rounding errors have no direction.
    let [size, step] = [point, along].map(largest_component);
    if largest_component(out) <= rounding(size.max(step)) {
        return None;
    }
    let perpendicular = direction(cross(direction(along)?, normal))?;
    let height = dot(perpendicular, direction(out)?);
    // Where the derivative across the edge vanishes up to rounding it has no side.
    (height.abs() > ScalarOf::<A>::EPSILON.sqrt()).then(|| {
        if height > ScalarOf::<A>::ZERO { perpendicular } else { perpendicular.scale(-ScalarOf::<A>::ONE) }
    })
}

/// The largest absolute value of the difference of two quadratic forms on the tangent plane of the first.
fn curvature_difference<P: Point3>(a: &Curvature<P>, b: &Curvature<P>, sign: P::Scalar) -> P::Scalar {
    let entry = |i: usize, j: usize| {
        let mine = if i == j { a.principal[i] } else { P::Scalar::ZERO };
        (0..2).fold(mine, |sum, k| {
            let projected = dot(a.directions[i], b.directions[k]) * dot(a.directions[j], b.directions[k]);
            sum - sign * b.principal[k] * projected
        })
    };
    let (p, q, r) = (entry(0, 0), entry(0, 1), entry(1, 1));
    let half = P::Scalar::of(0.5);
    ((p + r) * half).abs() + ((p - r) * half * ((p - r) * half) + q * q).sqrt()
}
