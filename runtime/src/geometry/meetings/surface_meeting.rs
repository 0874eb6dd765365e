//! Where curves, rays and lines meet surfaces, with points.

use alloc::vec::Vec;

use super::MeetingKind;
use crate::geometry::pierce::{Pierced, line_pieces, piercings};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::{distance, recast};
use crate::{BoundedSurface, ParametricCurve, Point, Point3, Scalar};

/// A place at which a curve, a ray or a line meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct SurfaceMeeting<P: Point> {
    /// How they meet: at one place of both, at an angle; nearer to each other than the accuracy next to one point, where
    /// they touch or the curve meets a pole; or so along an interval.
    pub kind: MeetingKind,
    /// The parameters of the curve between which they meet here; of a ray or a line multiples of the direction.
    pub curve: [P::Scalar; 2],
    /// The parameters `[[from_u, to_u], [from_v, to_v]]` of the surface between which they meet here.
    pub surface: [[P::Scalar; 2]; 2],
    /// The parameter of the curve at which they meet, or are nearest to each other.
    pub at: P::Scalar,
    /// The parameters `[u, v]` of the surface there.
    pub surface_at: [P::Scalar; 2],
    /// The point of the curve there.
    pub point: P,
    /// Its distance from the point of the surface.
    pub distance: P::Scalar,
}

/// The places of a curve at which it meets a surface.
pub(crate) fn of_curve<P: Point3>(
    curve: &(impl ParametricCurve<Point = P> + ?Sized),
    surface: &dyn BoundedSurface<Point = P>,
    accuracy: P::Scalar,
) -> Option<Vec<SurfaceMeeting<P>>> {
    let found =
        piercings(&curve.pieces(), &surface.pieces(), accuracy.to_f64(), P::Scalar::EPSILON.to_f64())?;
    Some(with_points(&|t| curve.parameter_of(t), &|t| curve.eval(t), surface, found))
}

/// The places `start + t direction`, `from <= t`, at which a line meets a surface.
pub(crate) fn of_line<P: Point3>(
    surface: &(impl BoundedSurface<Point = P> + ?Sized),
    start: P,
    direction: P::Vector,
    from: f64,
    accuracy: P::Scalar,
) -> Option<Vec<SurfaceMeeting<P>>> {
    let pieces = surface.pieces();
    let direction: P = recast(direction);
    let [origin, along] = [start, direction].map(|p| [0, 1, 2].map(|d| p.component(d).to_f64()));
    let accuracy = accuracy.to_f64();
    let line = line_pieces(&pieces, origin, along, [from, f64::INFINITY], accuracy)?;
    let found = piercings(&line, &pieces, accuracy, P::Scalar::EPSILON.to_f64())?;
    Some(with_points(&P::Scalar::of, &|t| start.add_weighted(direction, t), surface, found))
}

fn with_points<P: Point3>(
    parameter: &dyn Fn(f64) -> P::Scalar,
    point: &dyn Fn(P::Scalar) -> P,
    surface: &(impl BoundedSurface<Point = P> + ?Sized),
    found: Vec<Pierced>,
) -> Vec<SurfaceMeeting<P>> {
    let (domain, ranges) = (surface.domain(), surface.domain().ranges());
    let meeting = |f: Pierced| {
        let place = |k: usize, t: f64| crate::geometry::clamped(ranges[k], P::Scalar::of(t));
        let (u, v) = domain.clamped(P::Scalar::of(f.at[1]), P::Scalar::of(f.at[2]));
        let (at, surface_at) = (parameter(f.at[0]), [u, v]);
        let found = point(at);
        SurfaceMeeting {
            kind: f.kind,
            curve: f.curve.map(parameter),
            surface: [0, 1].map(|k| f.surface[k].map(|t| place(k, t))),
            at,
            surface_at,
            point: found,
            distance: distance(found, surface.eval(surface_at[0], surface_at[1])),
        }
    };
    found.into_iter().map(meeting).collect()
}
