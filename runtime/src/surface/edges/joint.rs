//! How smoothly two surfaces meet along an edge, measured at samples.

use super::{Edge, EdgePair, Orientation};
use crate::curve::leading_order;
use crate::surface::limit::rounding;
use crate::surface::{ScalarOf, VectorOf};
use crate::vector::{cross, direction, distance, dot, largest_component, length};
use crate::{Curvature, Point, Point3, Scalar, Surface, SurfaceDomain};

/// How two surfaces meet along an edge, measured by [`Surface::joint`]: the largest figures at a number of samples.
///
/// Between the samples they may be larger. [`JointBounds`](crate::bspline::JointBounds) of B-spline surfaces has bounds for
/// all parameters of the edge: of the same gap, and of the angle between the normals, which is [`angle`](Self::angle) where
/// the edges have the same tangent.
///
/// At a sample inside of the edge the limits from below and from above are measured, on the same side of the joint on
/// both surfaces, and the larger figure counts. So a crease across the edge, as at a knot of low multiplicity, is no angle
/// between the surfaces if both have it there, nor is a jump a gap. The limits are taken at parameters that differ from
/// the sample by some 16 rounding errors.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EdgeJoint<S> {
    /// The largest distance of two points that belong together, in the unit of the points.
    pub gap: S,
    /// Where it occurs: the parameter of the first surface along its edge.
    pub gap_at: S,
    /// The largest angle in radians by which the surfaces do not continue each other: 0 where the joint is smooth, π
    /// where one folds back on the other. It is the angle from the conormal out of the first surface, the unit vector in its
    /// tangent plane that is perpendicular to its edge, to the one into the second. So it also counts by how much the
    /// directions of the edges differ, which they do in the presence of a gap. Where an edge is a point, or a surface leaves
    /// its edge along the edge, it is the angle between the tangent planes, up to π/2. NaN if at no sample both surfaces have
    /// a normal.
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
    let last = samples.max(2) - 1;
    let [mut gap, mut angle, mut curvature] = [Largest::<ScalarOf<A>>::NONE; 3];
    let (normals, _) = sides::<ScalarOf<A>>(pair);
    let (mut without_normal, mut without_curvature) = (0, 0);
    let beside = beside(first.domain(), pair, second.domain())
        .min(ScalarOf::<A>::of(0.25) / ScalarOf::<A>::from_usize(last));
    for k in 0..=last {
        let x = ScalarOf::<A>::from_usize(k) / ScalarOf::<A>::from_usize(last);
        let (u, v) = first.domain().on_edge(pair.first, x);
        let at = if pair.first.runs_along_u() { u } else { v };
        let limits = if k == 0 || k == last { [x; 2] } else { [x - beside, x + beside] };
        let [before, after] = limits.map(|x| Figures::at(first, pair, second, x));
        for figures in [before, after] {
            gap = gap.with(figures.gap, at);
            angle = figures.angle.map_or(angle, |figure| angle.with(figure, at));
            curvature = figures.curvature.map_or(curvature, |figure| curvature.with(figure, at));
        }
        without_normal += usize::from(before.angle.is_none() || after.angle.is_none());
        without_curvature += usize::from(before.curvature.is_none() || after.curvature.is_none());
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

/// How far from a sample, as a part of the edge, both surfaces are surely on the same side of a knot that both have there:
/// some rounding errors of the parameters.
fn beside<S: Scalar>(first: SurfaceDomain<S>, pair: EdgePair, second: SurfaceDomain<S>) -> S {
    let errors = [(first, pair.first), (second, pair.second)].map(|(domain, edge)| {
        let [lo, hi] = domain.ranges()[usize::from(!edge.runs_along_u())];
        lo.abs().max(hi.abs()) / (hi - lo)
    });
    S::of(16.0) * S::EPSILON * errors[0].max(errors[1]).max(S::ONE)
}

/// Whether the normals point to the same side, and the sign with which curvatures then agree.
fn sides<S: Scalar>(pair: EdgePair) -> (Orientation, S) {
    // Two faces have one orientation if they are on different sides of their common edge.
    let sides_differ = pair.first.surface_on_the_right() != pair.second.surface_on_the_right();
    match (sides_differ, pair.orientation) {
        (true, Orientation::Same) | (false, Orientation::Opposite) => (Orientation::Same, S::ONE),
        (true, Orientation::Opposite) | (false, Orientation::Same) => (Orientation::Opposite, -S::ONE),
    }
}

/// The figures at one parameter, as far as there are any.
#[derive(Clone, Copy)]
struct Figures<S> {
    gap: S,
    angle: Option<S>,
    curvature: Option<S>,
}

impl<S: Scalar> Figures<S> {
    /// At a parameter of the first edge, as a part of it.
    fn at<A, B>(first: &A, pair: EdgePair, second: &B, x: S) -> Self
    where
        A: Surface + ?Sized,
        A::Point: Point3<Scalar = S>,
        B: Surface<Point = A::Point> + ?Sized,
    {
        let (u, v) = first.domain().on_edge(pair.first, x);
        let y = match pair.orientation {
            Orientation::Same => x,
            Orientation::Opposite => S::ONE - x,
        };
        let (s, t) = second.domain().on_edge(pair.second, y);
        let gap = distance(first.eval(u, v), second.eval(s, t));
        let (Some(n), Some(m)) = (first.normal(u, v), second.normal(s, t)) else {
            return Self { gap, angle: None, curvature: None };
        };
        let outwards = conormal(first, pair.first, u, v, n).zip(conormal(second, pair.second, s, t, m));
        let angle = match outwards {
            // One continues the other if it goes in where the other goes out.
            Some((out, other)) => length(cross(out, other)).atan2(-dot(out, other)),
            // On an edge that is one point there is only the plane.
            None => length(cross(n, m)).atan2(dot(n, m).abs()),
        };
        let curvatures = first.curvature(u, v).zip(second.curvature(s, t));
        let curvature = curvatures.map(|(a, b)| curvature_difference(&a, &b, sides(pair).1));
        Self { gap, angle: Some(angle), curvature }
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
