//! The two parameter directions and the four edges of a surface, and how smoothly two surfaces meet along one.

use crate::Surface;
use crate::surface::limit::rounding;
use crate::surface::{ScalarOf, VectorOf};
use crate::vector::{cross, direction, distance, dot, largest_component, length};
use crate::{Curvature, Point, Point3, Scalar, SurfaceDomain};

/// One of the two parameter directions of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Direction {
    /// The first parameter, which numbers the rows of a net.
    U,
    /// The second parameter, which numbers the columns of a net.
    V,
}

/// How two directions along one line are related, or two normals of one plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Orientation {
    /// They are the same.
    Same,
    /// One is the reverse of the other.
    Opposite,
}

/// An edge of the parameters of a surface, a rectangle or a triangle: see [`SurfaceDomain`](crate::SurfaceDomain).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Edge {
    /// `u = lo`; runs along `v`.
    UStart,
    /// `u = hi`; runs along `v`. Of a triangle the corner `u = 1`.
    UEnd,
    /// `v = lo`; runs along `u`.
    VStart,
    /// `v = hi`; runs along `u`. Of a triangle `v = 1 - u`.
    VEnd,
}

impl Edge {
    /// All four.
    pub const ALL: [Self; 4] = [Self::UStart, Self::UEnd, Self::VStart, Self::VEnd];

    /// Whether the edge runs along `u`.
    pub fn runs_along_u(self) -> bool {
        matches!(self, Self::VStart | Self::VEnd)
    }

    /// The parameter that is constant on the edge, of a triangle but for `VEnd`.
    pub fn across(self) -> Direction {
        if self.runs_along_u() { Direction::V } else { Direction::U }
    }

    /// Whether the constant parameter is at its upper end.
    pub fn is_end(self) -> bool {
        matches!(self, Self::UEnd | Self::VEnd)
    }

    /// The edge on the other side of the surface.
    pub fn opposite(self) -> Self {
        match self {
            Self::UStart => Self::UEnd,
            Self::UEnd => Self::UStart,
            Self::VStart => Self::VEnd,
            Self::VEnd => Self::VStart,
        }
    }

    /// Whether, seen from the side to which the normal points, the surface is to the right of the edge.
    pub(crate) fn surface_on_the_right(self) -> bool {
        matches!(self, Self::UStart | Self::VEnd)
    }

    /// The derivatives along the edge and across it, out of the surface.
    fn derivatives<P: Point<Vector = P>>(self, is_triangle: bool, along_u: P, along_v: P) -> [P; 2] {
        let back = |p: P| p.scale(-P::Scalar::ONE);
        match self {
            Self::UEnd if is_triangle => [P::zero(), along_u],
            Self::VEnd if is_triangle => {
                [along_u.minus(along_v), along_u.add_scaled(along_v, P::Scalar::ONE)]
            }
            Self::UStart => [along_v, back(along_u)],
            Self::UEnd => [along_v, along_u],
            Self::VStart => [along_u, back(along_v)],
            Self::VEnd => [along_u, along_v],
        }
    }
}

/// How two surfaces meet along an edge, measured by [`edge_continuity`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct EdgeContinuity<S> {
    /// The largest distance of two points that belong together.
    pub gap: S,
    /// The largest angle in radians by which the surfaces do not continue each other: 0 where the join is smooth, π
    /// where one folds back on the other. NaN if nowhere on the edge both surfaces have a normal.
    pub angle: S,
    /// The largest difference of the normal curvatures, over all tangent directions; NaN if nowhere on the edge both
    /// surfaces have curvatures.
    pub curvature: S,
    /// Whether the normals of both surfaces point to the same side where they continue each other, or to opposite sides.
    /// It follows from which edges are joined in which direction.
    pub normals: Orientation,
    /// The number of samples at which a surface has no normal, which do not count for the angle.
    pub without_normal: usize,
    /// The number of samples at which a surface has no curvature, as at poles, which do not count for the curvature.
    pub without_curvature: usize,
}

impl<S: Scalar> EdgeContinuity<S> {
    /// The order of geometric continuity that the measured numbers allow: 0, 1 or 2, or `None` if there is a gap.
    ///
    /// The tolerances are in the unit of length, in radians, and in the inverse of the unit of length.
    pub fn order(&self, gap: S, angle: S, curvature: S) -> Option<usize> {
        // A comparison with NaN is false, so that NaN counts as too large.
        if self.gap <= gap {
            let smooth = [self.angle <= angle, self.curvature <= curvature];
            Some(smooth.into_iter().take_while(|&is_small| is_small).count())
        } else {
            None
        }
    }
}

/// An edge each of two surfaces that belong together: to measure how smoothly they meet there, or to join them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EdgePair {
    /// The edge of the first surface; of a splice that of the surface that is adjusted.
    pub first: Edge,
    /// The edge of the second surface; of a splice that of the target.
    pub second: Edge,
    /// Whether the parameters along the two edges run in the same direction or in opposite ones.
    pub orientation: Orientation,
}

impl EdgePair {
    /// Edges along which the parameters run in the same direction.
    pub const fn along(first: Edge, second: Edge) -> Self {
        Self { first, second, orientation: Orientation::Same }
    }

    /// Edges along which the parameters run in opposite directions.
    pub const fn against(first: Edge, second: Edge) -> Self {
        Self { first, second, orientation: Orientation::Opposite }
    }

    /// Edges of two surfaces in the direction in which their ends are nearer to each other.
    ///
    /// ```
    /// use basis_runtime::{BernsteinBasis, Edge, EdgePair, TensorSurface};
    ///
    /// let linear = BernsteinBasis::<f64, 2>::new();
    /// let square = |net: [[[f64; 3]; 2]; 2]| TensorSurface::new(linear, linear, net);
    /// let left = square([[[0.0; 3], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]]);
    /// let right = square([[[1.0, 1.0, 0.0], [1.0, 0.0, 0.0]], [[2.0, 1.0, 0.0], [2.0, 0.0, 0.0]]]);
    /// let pair = EdgePair::nearest(&left, Edge::UEnd, &right, Edge::UStart);
    /// assert_eq!(pair, EdgePair::against(Edge::UEnd, Edge::UStart));
    /// ```
    pub fn nearest<A, B>(first: &A, first_edge: Edge, second: &B, second_edge: Edge) -> Self
    where
        A: Surface + ?Sized,
        B: Surface<Point = A::Point> + ?Sized,
    {
        let ends = [ScalarOf::<A>::ZERO, ScalarOf::<A>::ONE];
        let [start, end] = ends.map(|x| {
            let (u, v) = first.domain().on_edge(first_edge, x);
            first.eval(u, v)
        });
        let [other_start, other_end] = ends.map(|x| {
            let (u, v) = second.domain().on_edge(second_edge, x);
            second.eval(u, v)
        });
        let same = distance(start, other_start) + distance(end, other_end);
        let opposite = distance(start, other_end) + distance(end, other_start);
        if opposite < same {
            Self::against(first_edge, second_edge)
        } else {
            Self::along(first_edge, second_edge)
        }
    }

    /// The edges in the other order.
    pub const fn swapped(self) -> Self {
        Self { first: self.second, second: self.first, orientation: self.orientation }
    }
}

/// Measures how smoothly two surfaces meet along a pair of edges, at `samples` evenly spaced parameters (at least two).
///
/// The parameters along the edges correspond by the affine map. Between samples the numbers may be larger; those of
/// polynomial surfaces of low degree differ little from the largest with 65 samples.
///
/// ```
/// use basis_runtime::{BernsteinBasis, Edge, EdgePair, Orientation, TensorSurface, edge_continuity};
///
/// // Two sides of a roof.
/// let linear = BernsteinBasis::<f64, 2>::new();
/// let side = |net: [[[f64; 3]; 2]; 2]| TensorSurface::new(linear, linear, net);
/// let left = side([[[0.0, 0.0, 0.0], [0.0, 1.0, 1.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]]);
/// let right = side([[[0.0, 1.0, 1.0], [0.0, 2.0, 0.0]], [[1.0, 1.0, 1.0], [1.0, 2.0, 0.0]]]);
/// let ridge = edge_continuity(&left, &right, EdgePair::along(Edge::VEnd, Edge::VStart), 9);
/// assert_eq!(ridge.gap, 0.0);
/// assert!((ridge.angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// assert_eq!(ridge.normals, Orientation::Same);
/// assert_eq!(ridge.order(1e-9, 1e-6, 1e-3), Some(0));
/// ```
pub fn edge_continuity<A, B>(
    first: &A,
    second: &B,
    pair: EdgePair,
    samples: usize,
) -> EdgeContinuity<ScalarOf<A>>
where
    A: Surface + ?Sized,
    A::Point: Point3,
    B: Surface<Point = A::Point> + ?Sized,
{
    let EdgePair { first: first_edge, second: second_edge, orientation } = pair;
    let zero = ScalarOf::<A>::ZERO;
    let one = ScalarOf::<A>::ONE;
    let last = samples.max(2) - 1;
    let (mut gap, mut angle, mut curvature) = (zero, zero, zero);
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
        let y = match orientation {
            Orientation::Same => x,
            Orientation::Opposite => one - x,
        };
        let (s, t) = second.domain().on_edge(second_edge, y);
        gap = larger(gap, distance(first.eval(u, v), second.eval(s, t)));
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
        angle = larger(angle, here);
        if let (Some(a), Some(b)) = (first.curvature(u, v), second.curvature(s, t)) {
            curvature = larger(curvature, curvature_difference(&a, &b, sign));
        } else {
            without_curvature += 1;
        }
    }
    if without_normal > last {
        angle = ScalarOf::<A>::NAN;
    }
    if without_curvature > last {
        curvature = ScalarOf::<A>::NAN;
    }
    EdgeContinuity { gap, angle, curvature, normals, without_normal, without_curvature }
}

/// The larger one; NaN stays.
fn larger<S: Scalar>(a: S, b: S) -> S {
    if b <= a || a.is_nan() { a } else { b }
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
