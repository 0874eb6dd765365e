//! Curves and surfaces over families of polynomial basis functions, with or without shape parameters.
//!
//! A family is written down as a spec; [`basis!`] proves its claims while the crate that uses it is compiled and turns
//! it into a small type that implements [`Basis`]. This crate holds everything that does not depend on the family: the
//! types of points and scalars, the curves and the surfaces.
//!
//! ```
//! # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
//! # fn main() -> Result<(), basis_runtime::ShapeError> {
//! use basis_runtime::Curve;
//!
//! // basis!("specs/quartic.basis");                     gives the type QuarticBernstein
//! let basis = QuarticBernstein::new(0.5)?;              // an error outside the declared range -3 <= λ <= 1
//! let values: [f64; 4] = basis.values(0.25);            // b[0](1/4), …, b[3](1/4)
//! assert!(values.iter().all(|&value| value >= 0.0));
//!
//! let curve = Curve::new(basis, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
//! let point = curve.eval(0.25);
//! let [_, velocity, acceleration] = curve.eval_with_derivs(0.25);
//! # assert_eq!([point, velocity, acceleration], [[0.953125, 1.2421875], [4.0625, 3.125], [1.5, -13.5]]);
//! assert_eq!(curve.eval(1.0), curve.end());             // exact at both ends
//! # Ok(())
//! # }
//! ```
//!
//! # Domains
//!
//! A family on an interval implements [`Basis`] and makes a [`Curve`], two of them a [`TensorSurface`]; one with
//! denominators, angles or exponentials implements [`RationalBasis`] and makes a [`RationalCurve`], one on
//! several spans [`SpannedBasis`] and a [`SpannedCurve`]. A family on a
//! triangle or a tetrahedron implements [`SimplexBasis`] and makes a [`TriangularPatch`] or a [`SimplexPatch`], one on
//! a box of several variables implements [`BoxBasis`] and makes a [`BoxPatch`], one on a product of simplices and intervals,
//! such as a prism, [`ProductBasis`] and a [`ProductPatch`].
//!
//! # Where things are
//!
//! | for | look at |
//! | --- | --- |
//! | a curve: points, derivatives, frames, arc length, nearest point, parts, boxes | [`Curve`]; of several segments [`PiecewiseCurve`], of different families and degrees with [`AnyCurve`] as its segments |
//! | a curve that continues another one of any type with a contact of any order | [`ParametricCurve::continued`], [`Contact`]; from a family [`Basis::curve_after`] |
//! | lines, arcs, ellipses and Bézier segments of any degrees as one curve, SVG paths in and out | [`Path`], [`to_svg`] |
//! | the curve beside a curve, with joins and trimmed; the outline of a stroke | [`Offset`], [`Stroke`] |
//! | a tensor surface, its parts and joins | [`TensorSurface`], rational [`RationalSurface`] |
//! | a curve that turns about an axis | [`SurfaceOfRevolution`] |
//! | a patch on a triangle, a tetrahedron, a box, a prism | [`TriangularPatch`], [`SimplexPatch`], [`BoxPatch`], [`ProductPatch`] |
//! | normals and curvatures of all of these surfaces, over rectangles and triangles | the trait [`Surface`], [`SurfaceDomain`] |
//! | a surface that continues another one across an edge, with a contact of any order | [`TensorSurface::continued`] and the methods of this name of all surfaces with rows of control points, [`Contact`]; of triangular patches [`SimplexPatch::continued`] with a [`TriangleContact`]; of splines within tolerances `BSplineSurface::continued_within` |
//! | how smoothly a curve or a surface continues another one | [`Joint`] of curves, [`EdgeJoint`] of surfaces at samples along an edge, `bspline::JointBounds` proved for the whole edge of B-spline surfaces |
//! | where curves, rays and lines meet surfaces | [`SurfaceMeeting`] |
//! | Bézier curves and patches without a spec | [`Bezier`], [`BernsteinBasis`], [`TriangularBezier`] |
//! | a curve over a family with denominators | [`RationalCurve`] over a [`RationalBasis`]; its Bézier form [`RationalBezier`] |
//! | a curve over a family on several spans | [`SpannedCurve`] over a [`SpannedBasis`]; its Bézier form [`RationalSpline`] |
//! | B-splines | [`bspline`] |
//! | the same path with fewer segments, of lower degree | [`Path::simplified`], [`Path::to_cubics`], [`Path::to_quadratics`] |
//! | points in, a curve over any family, a B-spline or a path out; grids of points to surfaces | [`Fit`], [`GridFit`] |
//! | finite elements: quadrature, gradients at many points, nodes, functions of edges and faces | [`Quadrature`], [`SimplexBasis::tabulate`], [`SimplexBasis::nodes`], [`Entities`] |
//! | triangles, files of meshes | [`Tessellation`], [`Mesh`] |
//! | Bernstein coefficients as slices: roots, products, degrees | [`bernstein`] |
//!
//! # Curves of all types
//!
//! What can be asked of a curve has one name and one signature, that of the trait `ParametricCurve` (feature
//! `geometry`), whatever the type: [`Curve`] over a family and Bézier curves, [`PiecewiseCurve`],
//! [`BSplineCurve`](bspline::BSplineCurve), [`NurbsCurve`](bspline::NurbsCurve), [`RationalCurve`], [`RationalBezier`],
//! [`RationalSpline`], [`SpannedCurve`], and [`Path`], which holds segments of several types. The types without a
//! column, [`AnyCurve`] too, answer all of it as well; an [`Isocurve`] has no control points of its own to be moved or
//! mapped. Lists of curves of several types are `Vec<AnyCurve<P>>`, or `Vec<Box<dyn ParametricCurve<Point = P>>>` if none is cut.
//!
//! | a curve's | [`Curve`], [`Bezier`] | [`PiecewiseCurve`] | [`PiecewiseCurve`] of [`AnyCurve`] | `BSplineCurve` | `NurbsCurve` | through `dyn` |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | points: `domain`, `eval`, `eval_checked`, `eval_clamped`, `eval_into`, `start`, `end`, `samples_into` | yes | yes | yes | yes | yes | yes |
//! | points one after the other: `samples` | yes | yes | yes | yes | yes | no: the iterator has a type of its own |
//! | derivatives: `derivative`, `derivatives_into` | yes | yes | yes | yes | yes | yes |
//! | as an array: `eval_with_derivs` | yes | yes | yes | yes | yes | no: the length is a parameter of the function |
//! | direction and bending: `tangent`, `curvature`, `torsion`, `frenet_frame` | yes | yes | yes | yes | yes | yes |
//! | frames that do not turn: `rotation_minimizing_frames` | yes | yes | yes | yes | yes | yes |
//! | length: `arclen`, `inv_arclen` | yes | yes | yes | yes | yes | yes |
//! | equal distances: `arclen_parameters`, `samples_by_arclen` | yes | yes | yes | yes | yes | yes |
//! | a polygon within a tolerance: `flatten` | yes | yes | yes | yes | yes | yes |
//! | boxes: `bounding_box`, `control_box` | yes | yes | yes | yes | yes | yes |
//! | special points: `extrema`, `inflections` | yes | yes | yes | yes | yes | yes |
//! | the nearest point, with a lower bound: `nearest` | yes | yes | yes | yes | yes | yes |
//! | the first point with that value of a component: `first_where` | yes | yes | yes | yes | yes | yes |
//! | what a closed curve encloses, how often it goes round a point: `enclosed`, `winding` | yes | yes | yes | yes | yes | yes |
//! | the curve beside it at a distance: `offset` | yes | yes | yes | yes | yes | yes |
//! | where it and another curve are nearest to each other: `closest` | yes | yes | yes | yes | yes | yes |
//! | how smoothly another curve continues it: `joint` | yes | yes | yes | yes | yes | yes |
//! | a curve of any type, moved so that it comes next or before: `continued`, `preceded` | yes | yes | yes | yes | yes | no: the other curve has a type of its own |
//! | where it meets curves, itself, planes: `intersections`, `self_intersections`, `plane_intersections` | yes | yes | yes | yes | yes | yes |
//! | where it meets a surface: `surface_intersections` | yes | yes | yes | yes | yes | yes |
//! | rational Bézier pieces: `pieces` | yes | yes | yes | yes | yes | yes |
//! | parts: `split`, `subsegment`, `reversed` | yes | yes | yes | yes | yes | no: a part has a type of its own |
//! | the image under an affine map, a closure or [one of the library of points](AffineMap): `map`, `transform` | yes | yes | yes | yes | yes | no: the image has a type of its own |
//!
//! # Surfaces of all types
//!
//! The trait [`Surface`] is what every surface answers; a [`BoundedSurface`] knows its rational Bézier patches, from which
//! boxes, nearest points and meshes follow.
//!
//! | a surface's | [`TensorSurface`] | [`RationalSurface`] | [`SurfaceOfRevolution`] | `BSplineSurface` | `NurbsSurface` | [`TriangularPatch`] | [`BoxPatch`] of two variables | through `dyn` |
//! | --- | --- | --- | --- | --- | --- | --- | --- | --- |
//! | points: `domain`, `eval`, `eval_checked`, `eval_clamped`, `eval_grid` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | derivatives: `partial`, `partials_into` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | as an array: `eval_with_partials` | yes | yes | yes | yes | yes | yes | yes | no: the length is a parameter of the function |
//! | `normal`, with its limits at poles, `curvature` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | how smoothly another surface of any type continues it across an edge, at samples: `joint` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | the same as proved bounds for the whole edge: `joint_bounds` | no: `joint` at samples; a Bézier surface is a `BSplineSurface`, too | no: the proof is for polynomials | no: the proof is for polynomials | yes | no: the proof is for polynomials | no: the proof is for rectangles | no: `joint` at samples only | no: the other surface has a type of its own |
//! | another surface of its type, moved so that it continues this one across an edge, of surfaces of revolution across a circle: `continued` | yes | yes | yes | yes | yes | yes | no: its control points are not in rows along an edge | no: the other surface has a type of its own |
//! | rational Bézier patches: `pieces` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | boxes: `control_box`, `bounding_box` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | curves on it: `isocurve`, `boundary` | yes | yes | yes | yes | yes | yes | yes | no: [`Isocurve::new`] takes a `&dyn BoundedSurface` |
//! | the area, with a bound of its error: `area` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | the nearest point, with a lower bound: `nearest` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | where rays and lines meet it: `ray_intersections`, `line_intersections` | yes | yes | yes | yes | yes | yes | yes | yes |
//! | parts: `split`, `subpatch`, `reversed` | yes | yes | yes | yes | yes | no: a part over a rectangle is no triangle; it has `split_edge` and `part` | yes | no: a part has a type of its own |
//! | the image under an affine map, a closure or [one of the library of points](AffineMap), of a surface of revolution under a similarity: `map`, `transform` | yes | yes | yes | yes | yes | yes | yes | no: the image has a type of its own |
//! | triangles within a tolerance, by a [tessellation](Tessellation): `with` | yes | yes | yes | yes | yes | yes | yes | yes |
//!
//! The parameters are those of a rectangle or of a triangle, [`SurfaceDomain`], with the same four edges; generic code
//! that asks the domain for parameters is right for both.
//!
//! # Points
//!
//! A control point is anything that implements [`Point`]: `f32` and `f64`, arrays `[S; D]`, the float vectors of glam,
//! the vectors and points of nalgebra and mint, or a type of your own. Differences of points, derivatives, tangents,
//! normals, axes and directions are vectors: of points of nalgebra, mint, kurbo and lyon_geom the vectors of these
//! libraries, otherwise the type itself ([`Point::Vector`]).
//!
//! # Accuracy
//!
//! With `ε` the distance from 1 to the next number of the scalar type and `M` the largest control point of the curve in
//! Bernstein form, a point of a curve of degree up to 12 has an error below `4 ε M` in each component, and at degree 30
//! about `11 ε M`. Both ends are exact.
//!
//! # Features
//!
//! `basis-runtime = "0.1"` has everything but the exchange with other crates and file formats. With
//! `default-features = false, features = ["std"]` it is built alone, without the engine behind [`basis!`] and without
//! glam; one of `std` and `libm` has to be there, for square roots and angles.
//!
//! | feature | default | |
//! | --- | --- | --- |
//! | `std` | yes | fused multiply-add, and vector instructions where the processor has them; implies `alloc`. Without it the crate is `no_std` |
//! | `libm` | no | square roots, angles and exponentials without `std`; with `std` it changes nothing |
//! | `alloc` | by `std` | everything that returns a vector, and what needs room to search: the nearest point, extrema, tight boxes; rational patches of surfaces of revolution |
//! | `macros` | yes | [`basis!`] |
//! | `angles` | yes | sines, exponentials and π in specs, and domains that end at a shape parameter; without it the first of them is an error that names the feature; implies `macros` |
//! | `joins` | yes | theorems and joins in specs; without it the first of them is an error that names the feature; implies `macros` |
//! | `rounding` | yes | proved bounds of the rounding errors of generated functions, as constants and in claims; implies `macros` |
//! | `geometry` | yes | what all types of curves answer, `ParametricCurve`; curves of several segments, [`PiecewiseCurve`]; what surfaces of Bézier patches do, `BoundedSurface`; implies `alloc` |
//! | `bspline` | yes | B-spline curves and surfaces over any knots, polynomial and rational; their joints and networks: [`bspline`]; points to curves of all types: [`Fit`]; implies `geometry` |
//! | `elements` | yes | finite elements: rules of quadrature, [`Quadrature`], functions at many points, [`Tabulation`], nodes, and what belongs to corners, edges and faces, [`Entities`]; implies `alloc` |
//! | `mesh` | yes | surfaces as triangles within a tolerance: [`Tessellation`]; implies `geometry` |
//! | `glam` | yes | `Vec2`, `Vec3`, `Vec3A`, `Vec4`, `DVec2`, `DVec3`, `DVec4` of glam 0.34 are points |
//! | `glam_030`, `glam_032`, `glam_033` | no | those of glam 0.30, 0.32 and 0.33 too, such as the `Vec3` of Bevy 0.17 and 0.18, of Bevy 0.19, of Bevy 0.20; several versions can be on |
//! | `mint` | no | `Point2`, `Point3`, `Vector2`, `Vector3`, `Vector4` of mint 0.5 are points; most libraries convert to and from these |
//! | `nalgebra` | no | `SVector<S, D>` and `Point<S, D>` of nalgebra 0.34 are points; with `std` and `bspline` also the published method of splicing |
//! | `kurbo`, `lyon_geom` | no | the points of kurbo 0.13 and lyon_geom 1 are points, and curves go to and from their segments where the degree allows; `kurbo::fit_to_bezpath` takes curves of any degree. `lyon_geom` implies `std` |
//! | `gltf`, `obj`, `stl` | no | meshes are written as binary glTF, Wavefront OBJ, binary STL; imply `std` and `mesh` |
//! | `laws` | no | checks of the laws that families keep, for families of your own: `laws` |
//! | `serde` | no | public data can be written and read; what is read is checked as by the constructors. `serde_json` reads numbers up to the last digit only with its own feature `float_roundtrip`: without it a number of seventeen digits can come back changed by some units of its last digit. Knots come back in order all the same, repeated ones repeated |

#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
// items say which feature they need
// This page links to everything; with fewer features some of it is not there.
#![cfg_attr(
    not(all(
        feature = "alloc",
        feature = "macros",
        feature = "geometry",
        feature = "bspline",
        feature = "elements",
        feature = "mesh"
    )),
    allow(rustdoc::broken_intra_doc_links)
)]

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "basis-runtime computes square roots and angles with the feature `std` or, without it, the feature `libm`: \
    switch one of them on"
);

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[doc(hidden)]
#[path = "macro_support.rs"]
pub mod __private;
mod affine;
mod basis;
pub mod bernstein;
mod boxes;
#[cfg(feature = "bspline")]
pub mod bspline;
#[cfg(any(feature = "kurbo", feature = "lyon_geom"))]
mod convert;
mod curve;
mod domain;
#[cfg(feature = "elements")]
mod elements;
mod error;
#[cfg(feature = "bspline")]
mod fit;
mod form;
pub mod generated;
#[cfg(feature = "geometry")]
mod geometry;
#[cfg(feature = "laws")]
pub mod laws;
mod matrices;
#[cfg(feature = "mesh")]
mod mesh;
#[cfg(feature = "alloc")]
mod nearest;
mod numeric;
#[cfg(feature = "geometry")]
mod path;
#[cfg(feature = "geometry")]
mod piecewise;
mod point;
mod product;
mod rational;
mod revolution;
mod scalar;
#[cfg(feature = "serde")]
mod serialize;
mod simplex;
mod surface;
#[allow(dead_code)] // some of it only with some features
mod vector;

pub use affine::AffineMap;
pub use basis::{Array, Basis, Rounding};
#[cfg(feature = "macros")]
pub use basis_macros::basis;

/// Stands for the macro of the feature `macros`, and says that the feature is off.
#[cfg(not(feature = "macros"))]
#[macro_export]
macro_rules! basis {
    ($($input:tt)*) => {
        $crate::__private::core::compile_error!(
            "`basis!` needs the feature `macros` of basis-runtime, which is one of its default features"
        );
    };
}
#[doc(inline)]
pub use bernstein::{BernsteinBasis, BernsteinOf};
pub use boxes::{BoxBasis, BoxPatch};
pub use curve::{Bezier, BezierOf, Contact, Curve, CurveError, Frame, Joint, Samples};
#[cfg(feature = "elements")]
pub use elements::{Entities, Entity, Quadrature, QuadratureError, Tabulation};
pub use error::{CountError, ShapeError};
#[cfg(feature = "bspline")]
pub use fit::{Fit, FitEnd, Fitted, FittedSurface, GridEnd, GridFit};
pub use form::{BernsteinForm, EndpointForm, Form};
#[cfg(feature = "geometry")]
pub use geometry::{
    Closest, CurvePiece, CurveScalar, CurveVector, Enclosed, JoinableCurve, Meeting, MeetingKind,
    ParametricCurve, PlaneMeeting, SurfaceMeeting,
};
#[cfg(feature = "mesh")]
pub use mesh::{Mesh, MeshError, Tessellation, Vertex};
#[cfg(feature = "alloc")]
pub use nearest::Nearest;
#[cfg(feature = "geometry")]
pub use path::{LineCap, LineJoin, Offset, Path, PathSegment, Stroke, SvgError, SvgMistake, to_svg};
#[cfg(feature = "geometry")]
pub use piecewise::{AnyCurve, PiecewiseCurve};
pub use point::Point;
pub use product::{DomainFactor, ProductBasis, ProductPatch};
pub use rational::{Chart, RationalBasis, RationalCurve, SpanOf, SpannedBasis, SpannedCurve};
#[cfg(feature = "geometry")]
pub use rational::{RationalBezier, RationalSpline};
#[cfg(feature = "alloc")]
pub use revolution::RevolutionPatch;
pub use revolution::{RevolutionError, SurfaceOfRevolution, half_turn_parameter};
pub use scalar::{FUSED_HERE, Scalar};
#[cfg(feature = "alloc")]
pub use simplex::TriangleContact;
pub use simplex::{
    EdgeBasis, SimplexBasis, SimplexIndex, SimplexPatch, TetrahedronIndex, TriangleEdge, TriangleIndex,
    TriangularBasis, TriangularBernsteinBasis, TriangularBernsteinOf, TriangularBezier, TriangularBezierOf,
    TriangularPatch,
};
#[cfg(feature = "geometry")]
pub use surface::{Area, BoundedSurface, Isocurve, SurfacePiece};
pub use surface::{
    BezierPatchOf, Curvature, Direction, Edge, EdgeJoint, EdgePair, JoinError, Orientation, RationalPatchOf,
    RationalSurface, ScalarOf, Surface, SurfaceDomain, TensorSurface, VectorOf,
};
pub use vector::Point3;

#[cfg(all(doctest, feature = "macros"))]
#[doc = include_str!("../README.md")]
struct Readme;
