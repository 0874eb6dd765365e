//! B-spline curves and surfaces over arbitrary knot vectors, polynomial and rational.
//!
//! | | polynomial | rational |
//! | --- | --- | --- |
//! | curves | [`BSplineCurve`] | [`NurbsCurve`] |
//! | surfaces | [`BSplineSurface`] | [`NurbsSurface`] |
//!
//! | for | look at |
//! | --- | --- |
//! | points, derivatives of any order | [`BSplineCurve::derivative`], [`BSplineSurface::partial`] |
//! | normals, curvatures, meshes | the traits [`Surface`](crate::Surface) and [`BoundedSurface`](crate::BoundedSurface) |
//! | other knots and degrees, the same shape | `insert_knots`, `refined`, `remove_knot`, `elevate`, `split`, `to_bezier`, `merged` of all four |
//! | points in, a curve or a surface out | [`BSplineCurve::interpolate`], [`BSplineCurve::fit`], [`BSplineSurface::interpolate`], [`BSplineSurface::fit`] |
//! | the same within a tolerance, with a number of control points, smoothing, given directions at the ends | [`Fit`](crate::Fit), [`GridFit`](crate::GridFit) |
//! | a surface from curves: extruded, ruled, translated, lofted, swept, between four boundary curves | [`BSplineSurface::extruded`], [`ruled`](BSplineSurface::ruled), [`translated`](BSplineSurface::translated), [`lofted`](BSplineSurface::lofted), [`swept`](BSplineSurface::swept), [`coons`](BSplineSurface::coons); rational [`NurbsSurface::extruded`], [`ruled`](NurbsSurface::ruled), [`translated`](NurbsSurface::translated), [`lofted`](NurbsSurface::lofted), [`swept`](NurbsSurface::swept), [`coons`](NurbsSurface::coons) |
//! | closed curves without ends | [`KnotVector::periodic`], [`BSplineCurve::periodic`], [`BSplineCurve::interpolate_closed`] |
//! | surfaces of revolution | [`NurbsSurface::revolved`]; `try_from` of a [`SurfaceOfRevolution`](crate::SurfaceOfRevolution) |
//! | the nearest point | [`BSplineSurface::nearest`], [`ParametricCurve::nearest`](crate::ParametricCurve::nearest) |
//! | a surface through given points | [`BSplineSurface::pass_through`] |
//! | a surface that continues another one across an edge, whatever their knots and degrees, with a given contact of any order | [`BSplineSurface::continued`], [`NurbsSurface::continued`] |
//! | the same with tangent planes or curvatures within tolerances and the least change, also by a published method | [`BSplineSurface::continued_within`] |
//! | bounds of gap and angle between two surfaces along an edge | [`BSplineSurface::joint_bounds`] |
//! | neighbours that follow a deformed patch | [`Network`] |
//!
//! All of them stand over [`KnotVector`]s, which are validated when they are made; after that nothing can fail for
//! their sake. A rational curve is a polynomial one of [`Homogeneous`] points. What changes the representation and not
//! the shape is the same code for all four.
//!
//! The control points are any [`Point`](crate::Point); `f32` and `f64` both work. All of it needs the feature `alloc`,
//! and the published method of splicing, `Method::Midpoints`, the features `std` and `nalgebra`.

/// Functions that set one field of options each.
macro_rules! setters {
    ($options:ty; $($field:ident: $type:ty, $doc:literal;)+) => {
        impl $options {
            $(
                #[doc = $doc]
                #[must_use]
                pub fn $field(mut self, $field: $type) -> Self {
                    self.$field = $field;
                    self
                }
            )+
        }
    };
}
use setters;

mod buffer;
mod constrain;
mod construct;
mod continued;
mod curve;
mod error;
mod fit;
mod functions;
mod knots;
mod nearest;
mod net;
mod network;
mod nurbs;
mod patch;
mod rows;
mod slices;
mod splice;
mod surface;

pub use constrain::{Constrained, ConstraintError, PointConstraint};
pub use construct::ConstructionError;
pub use curve::{BSplineCurve, BezierPiece};
pub use error::{KnotError, SplineError};
pub(crate) use fit::{Banded, parameters_of_rows};
pub use fit::{FitError, Spacing, parameters};
pub use knots::{KnotVector, MAX_DEGREE};
pub use net::Net;
pub use network::{FollowOptions, Followed, Network, NetworkError, Seam};
pub use nurbs::{Homogeneous, NurbsCurve, NurbsSurface};
pub use splice::{Continuity, EdgeKnots, JointBounds, Method, SecondRow, Splice, SpliceError, SpliceOptions};
pub use surface::{BSplineSurface, BezierPatch};

pub use crate::{Direction, Edge, EdgePair, Orientation};
