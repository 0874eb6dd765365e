//! Every public type of data is written and read back the same, and threads can share it; what is read is checked.
//!
//! JSON is read up to the last digit, so the numbers are short.
#![cfg(all(feature = "serde", feature = "laws", feature = "std"))]

mod sources;

use basis_runtime::bspline::{
    BSplineCurve, BSplineSurface, BezierPatch, BezierPiece, Constrained, ConstraintError, ConstructionError,
    Continuity, Direction, EdgeKnots, FitError, FollowOptions, Followed, Homogeneous, JointBounds, KnotError,
    KnotVector, Method, Net, Network, NetworkError, NurbsCurve, NurbsSurface, PointConstraint, Seam,
    SecondRow, Spacing, Splice, SpliceError, SpliceOptions, SplineError,
};
use basis_runtime::laws::{Checks, Law, Place, Violation};
use basis_runtime::{
    AnyCurve, Area, BernsteinBasis, BernsteinForm, Bezier, BoundedSurface, BoxPatch, Chart, Closest, Contact,
    CountError, Curvature, Curve, CurveError, CurvePiece, DomainFactor, Edge, EdgeBasis, EdgeJoint, EdgePair,
    Enclosed, EndpointForm, Entities, Entity, Fit, FitEnd, Fitted, FittedSurface, Frame, GridEnd, GridFit,
    Isocurve, JoinError, Joint, LineCap, LineJoin, Meeting, MeetingKind, Mesh, MeshError, Nearest, Offset,
    Orientation, ParametricCurve, Path, PathSegment, PiecewiseCurve, PlaneMeeting, ProductPatch, Quadrature,
    QuadratureError, RationalBezier, RationalCurve, RationalSpline, RationalSurface, RevolutionError,
    RevolutionPatch, Rounding, Samples, ShapeError, SimplexIndex, SimplexPatch, SpanOf, SpannedBasis,
    SpannedCurve, Stroke, Surface, SurfaceDomain, SurfaceMeeting, SurfaceOfRevolution, SurfacePiece,
    SvgError, SvgMistake, Tabulation, TensorSurface, Tessellation, TriangleContact, TriangleEdge,
    TriangularBernsteinBasis, TriangularBezier, Vertex, basis,
    bernstein::{Root, RootKind},
};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::json;

basis!("../../specs/quartic.basis");
basis!("../../specs/triangular.basis", TriangularII(3));
basis!("../../specs/lagrange.basis", Bilinear, TetrahedralLagrange(1));

basis!("../../specs/triangles/prisms.basis", LinearWedge);
basis!("../../specs/rational/bezier.basis", Conic);
basis! {
    /// Two parabolas that meet at a knot.
    family Hat {
        shape 0 < d;
        domain 0 <= x <= 1, 1 <= x <= 1 + d;
        b[0] = x^2 | ((1 + d - x)/d)^2;
        b[1] = 1 - b[0];
    }
}

type P = [f64; 3];

/// What is read is what was written, also to the type that is expected.
#[allow(clippy::needless_pass_by_value)] // most values are made in the call
fn again<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug + Send + Sync + 'static>(value: T) {
    let text = serde_json::to_string(&value).unwrap();
    let read: T = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    assert_eq!(read, value, "{text}");
}

/// A value of a type that only the library makes, from what it is written as.
fn read<T: DeserializeOwned>(json: serde_json::Value) -> T {
    serde_json::from_value(json).unwrap()
}

fn refused<T: Serialize + DeserializeOwned>(value: &T, change: impl Fn(&mut serde_json::Value)) {
    let mut json = serde_json::to_value(value).unwrap();
    change(&mut json);
    assert!(serde_json::from_value::<T>(json.clone()).is_err(), "{json}");
}

fn quartic() -> QuarticBernstein {
    QuarticBernstein::new(0.5).unwrap()
}

fn curve() -> Curve<QuarticBernstein, P> {
    Curve::new(quartic(), [[0.0, 0.0, 1.0], [1.0, 2.0, 0.0], [3.0, 2.0, 0.0], [4.0, 0.0, 1.0]])
}

fn surface() -> TensorSurface<QuarticBernstein, QuarticBernstein, P> {
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]));
    TensorSurface::with_rows(
        quartic(),
        [0.25, -1.0, -2.5, 1.0].map(|c| QuarticBernstein::new(c).unwrap()),
        net,
    )
}

fn triangle() -> SimplexPatch<TriangularII, P> {
    let basis = TriangularII::new(1.5, 2.0).unwrap();
    SimplexPatch::new(basis, core::array::from_fn(|i| [i as f64, (i * i) as f64, 0.5]))
}

fn spline() -> BSplineSurface<P> {
    let u = KnotVector::new(2, [0.0, 0.0, 0.0, 0.25, 1.0, 1.0, 1.0]).unwrap();
    let v = KnotVector::uniform(1, 2).unwrap();
    let height = |i: usize, j: usize| [i as f64, j as f64, (i * j) as f64];
    BSplineSurface::new(u, v, Net::from_fn(4, 3, height).unwrap()).unwrap()
}

#[test]
fn bases_forms_and_curves() {
    again(quartic());
    again(BernsteinBasis::<f64, 4>::new());
    again(TriangularBernsteinBasis::<f64, 4, 10>::new());
    again(TriangularBezier::<f64, 2, 3>::from_points([0.5, 1.0, 2.0]));
    again(EndpointForm::new([0.0, 4.0], [12.0, 1.0]));
    again(BernsteinForm::new([[0.0, 4.0], [12.0, 1.0]]));
    again(curve());
    again(Bezier::from_points([[0.0_f32, 1.0]; 3]));
    let piecewise = PiecewiseCurve::new([curve(), curve()].to_vec()).unwrap();
    again(piecewise.clone());
    refused(&piecewise, |json| *json = json!([]));
    refused(&curve(), |json| json["basis"]["lambda"] = json!(-4.0));
    refused(&curve(), |json| drop(json["points"].as_array_mut().unwrap().pop()));
    refused(&EndpointForm::new([0.0, 4.0], [12.0, 1.0]), |json| json["inner"] = json!([1.0]));

    let conic: RationalCurve<Conic, P> =
        Conic::new(0.5).unwrap().curve([[0.0; 3], [1.0; 3], [2.0, 0.0, 1.0]]);
    again(conic);
    refused(&conic, |json| json["basis"]["omega"] = json!(0.0));
    let bezier: RationalBezier<P> = conic.to_rational_bezier();
    again(bezier.clone());
    refused(&bezier, |json| drop(json["weights"].as_array_mut().unwrap().pop()));
    refused(&bezier, |json| json["domain"] = json!([1.0, 1.0]));

    let hat: SpannedCurve<Hat, P> = Hat::new(0.5).unwrap().curve([[0.0; 3], [1.0, 2.0, 4.0]]);
    again(hat);
    refused(&hat, |json| json["basis"]["d"] = json!(-1.0));
    let span: SpanOf<Hat> = hat.basis().span(1);
    again(span);
    let spline: RationalSpline<P> = hat.to_rational_spline();
    again(spline.clone());
    refused(&spline, |json| json["curves"] = json!([]));

    let nearest: Nearest<P> = curve().nearest([0.0, 0.0, 1.0], 1e-9).unwrap();
    again(nearest);
    // Few digits: a reader of numbers may miss the last of seventeen.
    let [rising, falling] =
        [[[0.0; 3], [4.0, 4.0, 0.0]], [[0.0, 4.0, 0.0], [4.0, 0.0, 0.0]]].map(Bezier::from_points);
    let meetings: Vec<Meeting<P>> = rising.intersections(&falling, 1e-3).unwrap();
    assert_eq!(meetings.len(), 1);
    let met: Vec<PlaneMeeting<P>> = curve().plane_intersections([0.0; 3], [1.0, 0.0, 0.0]).unwrap();
    let ruled = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 1.0], [4.0, 1.0]]), 6.0).unwrap();
    let pierced: Vec<SurfaceMeeting<P>> =
        ruled.ray_intersections([1.0, -2.0, 0.5], [0.0, 1.0, 0.0], 1e-9).unwrap();
    assert_eq!(pierced.len(), 2);
    pierced.into_iter().for_each(again);
    again(MeetingKind::Crossing);
    let mut square = Path::rectangle([[1.0, 2.0], [3.0, 4.0]]);
    again(square.enclosed().unwrap());
    let arc = PathSegment::rational([[1.0, 2.0], [3.0, 2.0], [3.0, 4.0]], [1.0, 0.5, 2.0]).unwrap();
    again(arc.clone());
    square.push(arc);
    again(PathSegment::line([0.0, 1.0], [2.0, 3.0]));
    again(square);
    meetings.into_iter().for_each(again);
    met.into_iter().for_each(again);
    let joint = json!({ "gap": 0.5, "angle": 1.0, "curvature": 2.0, "derivatives": [0.0, 1.0, 2.0] });
    again(read::<Joint<f64>>(joint));
    again(Contact::Scaled { order: 3, f: 0.5 });
    again(Contact::Curvature { f: 0.5, c: 2.0 });
    again(read::<Frame<P>>(json!({
        "point": [0.0, 0.0, 0.0],
        "tangent": [1.0, 0.0, 0.0],
        "normal": [0.0, 1.0, 0.0],
        "binormal": [0.0, 0.0, 1.0],
    })));
    again(read::<Root<f64>>(json!({ "x": 0.5, "kind": "Crossing" })));
    again(RootKind::Contact);
    again(Checks::default());
    again(Law::Split);
}

#[test]
fn surfaces_and_meshes() {
    again(surface());
    refused(&surface(), |json| drop(json["rows"].as_array_mut().unwrap().pop()));
    let weights = [[1.0, 0.5, 1.0, 1.0]; 4];
    let rational =
        RationalSurface::from_homogeneous(surface(), TensorSurface::new(quartic(), quartic(), weights));
    again(rational);
    let swept = SurfaceOfRevolution::new(&curve(), [0.0; 3], [0.0, 0.0, 2.0], 4.0).unwrap();
    again(swept);
    refused(&swept, |json| json["angle"] = json!(7.0));
    refused(&swept, |json| json["axis"] = json!([0.0, 0.0, 0.0]));
    // Bézier points with their last digits: the same surface up to these.
    let patch: RevolutionPatch<QuarticBernstein, P> = swept.to_rational_patches()[0];
    let text = serde_json::to_string(&patch).unwrap();
    let read: RevolutionPatch<QuarticBernstein, P> = serde_json::from_str(&text).unwrap();
    assert!(read.eval(0.3, 0.4).iter().zip(patch.eval(0.3, 0.4)).all(|(a, b)| (a - b).abs() < 1e-14));

    again(Edge::UStart);
    let mut joint: EdgeJoint<f64> = surface().joint(EdgePair::along(Edge::UEnd, Edge::UEnd), &surface(), 5);
    (joint.gap, joint.angle, joint.curvature) = (0.0, 0.5, 0.25);
    (joint.gap_at, joint.angle_at, joint.curvature_at) = (0.25, 0.0, 1.0);
    again(joint);
    let bend: Curvature<P> =
        serde_json::from_value(serde_json::to_value(surface().curvature(0.5, 0.5).unwrap()).unwrap())
            .unwrap();
    assert!((bend.gaussian() - surface().curvature(0.5, 0.5).unwrap().gaussian()).abs() < 1e-14);
    again(Vertex { position: 1, normal: [0.0, 0.0, 1.0], uv: [0.5, 0.25], surface: 0 });
    let flat: TensorSurface<BernsteinBasis<f64, 2>, BernsteinBasis<f64, 2>, P> = TensorSurface::new(
        BernsteinBasis::new(),
        BernsteinBasis::new(),
        [[[0.0; 3], [1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]],
    );
    let mesh: Mesh<f64> = Tessellation::new(0.5).unwrap().with(&flat).mesh().unwrap();
    refused(&mesh, |json| json["triangles"][0][1] = json!(99));
    again(mesh);
}

#[test]
fn patches_on_simplices_and_boxes() {
    again(triangle());
    refused(&triangle(), |json| drop(json["points"].as_array_mut().unwrap().pop()));
    refused(&triangle(), |json| json["basis"]["lambda1"] = json!(0.0));
    again(SimplexPatch::new(TetrahedralLagrange::new(), [[1.0, 2.0], [0.5, 0.0], [0.0, 0.25], [3.0, 4.0]]));
    again(ProductPatch::new(LinearWedge::new(), core::array::from_fn(|i| [i as f64, 0.5])));
    again(BoxPatch::new(Bilinear::new(), [[0.0, 0.0], [0.0, 2.0], [4.0, 0.0], [6.0, 3.0]]));
    again(SurfaceDomain::Rectangle([[0.0, 1.0], [-2.0, 3.0]]));
    again(SurfaceDomain::<f64>::Triangle);
    again(TriangleContact::new(1, [1.0, 1.0, -1.0]));
    again(TriangleEdge::V);
    again(EdgeBasis::new(TriangularII::new(1.5, 2.0).unwrap(), TriangleEdge::W));
    again(triangle().edge_curve(TriangleEdge::U));
    again(SimplexIndex::new([1, 0, 2]));
    refused(&SimplexIndex::new([1, 0, 2]), |json| *json = json!([1, 2]));
    refused(&SimplexIndex::new([1, 0, 2]), |json| *json = json!([usize::MAX, 1, 2]));
}

#[test]
fn splines() {
    let knots = KnotVector::new(2, [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0]).unwrap();
    again(knots.clone());
    refused(&knots, |json| json["knots"] = json!([0.0, 0.0, 0.0, 0.5, 0.25, 1.0, 1.0]));
    refused(&knots, |json| json["degree"] = json!(9));
    let net = Net::from_rows([[1.0, 2.0], [3.0, 4.0]]).unwrap();
    again(net.clone());
    refused(&net, |json| json["columns"] = json!(3));
    refused(&net, |json| json["columns"] = json!(0));
    let curve = BSplineCurve::new(knots.clone(), [[0.0, 1.0], [1.0, 1.0], [2.0, 0.0], [3.0, 1.0]]).unwrap();
    again(curve.clone());
    refused(&curve, |json| drop(json["points"].as_array_mut().unwrap().pop()));
    again(read::<BezierPiece<[f64; 2]>>(json!({ "domain": [0.0, 0.5], "points": [[1.0, 2.0]] })));
    again(spline());
    refused(&spline(), |json| json["net"]["columns"] = json!(4));
    again(read::<BezierPatch<f64>>(json!({ "domain": [[0.0, 1.0], [0.0, 1.0]], "net": net })));
    again(Direction::V);
    again(Homogeneous::new([1.0, 2.0], 0.5));
    let rational = NurbsCurve::new(knots, curve.control_points(), [1.0, 0.5, 2.0, 1.0]).unwrap();
    again(rational.clone());
    let weight = |json: &mut serde_json::Value| json["points"][0]["weight"] = json!(-1.0);
    refused(&rational, |json| weight(&mut json["homogeneous"]));
    again(NurbsSurface::from_homogeneous(spline().map(|p| Homogeneous::new(p, 0.5))).unwrap());
}

#[test]
fn fits() {
    let points: Vec<P> = (0..9).map(|i| [f64::from(i), f64::from(i % 3), 0.5]).collect();
    let ends = [FitEnd::Free, FitEnd::Tangent([1.0, 0.0, 0.0])];
    again(ends);
    // Points of a curve with short numbers.
    let fit = Fit::new(&points).ends(ends).spline_with(1, 9).unwrap();
    let read: Fitted<BSplineCurve<P>> = serde_json::from_str(&serde_json::to_string(&fit).unwrap()).unwrap();
    assert_eq!(read.parameters.len(), 9);
    let grid = Net::from_fn(3, 3, |i, j| [i as f64, j as f64, (i * j) as f64]).unwrap();
    let fit = GridFit::new(&grid).ends([[GridEnd::Interpolated; 2]; 2]).spline_with([1, 1], [2, 2]).unwrap();
    let read: FittedSurface<BSplineSurface<P>, f64> =
        serde_json::from_str(&serde_json::to_string(&fit).unwrap()).unwrap();
    assert_eq!(read.surface.net().rows(), 2);
}

#[test]
fn joints_and_networks_of_splines() {
    let seam = Seam { patches: [0, 1], edges: EdgePair::along(Edge::VEnd, Edge::VStart) };
    let network = Network::new([spline(), spline()].to_vec(), [seam].to_vec()).unwrap();
    again(seam);
    again(network.clone());
    refused(&network, |json| json["seams"][0]["patches"] = json!([0, 2]));
    let measure = json!({ "gap": 0.5, "gap_at": 0.25, "angle": 1.0, "angle_at": 0.0 });
    again(read::<JointBounds>(measure.clone()));
    again(read::<Followed<P>>(json!({ "network": network, "changed": [1], "seams": [[0, measure]] })));
    again(FollowOptions::default());
    again(EdgePair::against(Edge::UStart, Edge::UEnd));
    again(Orientation::Opposite);
    again((SecondRow::Kept, EdgeKnots::Own));
    again((Continuity::G0, Method::LeastSquares, Spacing::Chord, SpliceOptions::default()));
    let joint = EdgePair::along(Edge::UEnd, Edge::UEnd);
    let mut joined =
        spline().continued_within(joint.swapped(), &SpliceOptions::default(), &spline()).unwrap();
    (joined.surface, joined.joint, joined.change) = (spline(), read(measure), 0.5);
    again::<Splice<P>>(joined);
    again((PointConstraint::At([0.5, 0.25], [1.0, 0.0, 2.0]), PointConstraint::Nearest([1.0, 0.0, 2.0])));
    again(read::<Constrained<P>>(
        json!({ "surface": spline(), "parameters": [[0.5, 0.25]], "change": 0.5, "miss": 0.0 }),
    ));
    again(spline().nearest([0.0; 3], 1e-9).unwrap());
}

/// Knots in JSON, read by the usual reader, which may be off by some units of the last digit, and up to the last digit, as
/// `serde_json` does with its feature `float_roundtrip`.
#[test]
fn knots_survive_both_readers_of_numbers() {
    use basis_test_support::Random;
    let random = &mut Random::new(17);
    let (mut changed, mut farthest) = (0, 0.0_f64);
    for round in 0..3000 {
        let degree = round % 4;
        let mut knots: Vec<f64> = Vec::new();
        let scale = 10_f64.powi(round as i32 % 17 - 8);
        let unit = |random: &mut Random| random.below(1 << 30) as f64 / f64::from(1 << 30);
        let mut at = scale * (2.0 * unit(random) - 1.0);
        for _ in 0..2 * degree + 2 + random.below(8) {
            let times = 1 + random.below(degree + 1);
            knots.extend(std::iter::repeat_n(at, times));
            // Also a knot next to another one.
            at = if random.below(6) == 0 { at.next_up() } else { at + scale * unit(random) };
        }
        let Ok(written) = KnotVector::new(degree, knots) else { continue };
        let text = serde_json::to_string(&written).unwrap();

        let exact: Vec<f64> =
            text.split(['[', ']']).nth(1).unwrap().split(',').map(|number| number.parse().unwrap()).collect();
        let json = serde_json::json!({ "degree": degree, "knots": exact });
        assert_eq!(serde_json::from_value::<KnotVector<f64>>(json).unwrap(), written);

        let read: KnotVector<f64> = match serde_json::from_str(&text) {
            Ok(read) => read,
            // Different knots next to each other that became one, too often.
            Err(error) => {
                assert!(error.to_string().contains("times"), "{error}: {text}");
                let all = written.as_slice();
                assert!(all.windows(2).any(|pair| pair[0].next_up() == pair[1]), "{text}");
                continue;
            }
        };
        for (&a, &b) in written.as_slice().iter().zip(read.as_slice()) {
            let off = (a - b).abs() / (f64::EPSILON * a.abs());
            farthest = farthest.max(if a == b { 0.0 } else { off });
            changed += usize::from(a != b);
        }
        // Repeated knots come back repeated, also where neighbours were exchanged.
        let times = |knots: &KnotVector<f64>| {
            let groups = knots.as_slice().chunk_by(|a, b| a == b);
            let mut times: Vec<usize> = groups.map(<[f64]>::len).collect();
            times.sort_unstable();
            times
        };
        let (before, after) = (times(&written), times(&read));
        assert!(before == after || after.len() < before.len(), "{text}");
    }
    assert!(farthest <= 4.0, "{changed} knots changed, one by {farthest} ε");
}

/// A message names the type that was asked for, not one of ours behind it.
#[test]
fn messages_name_the_type() {
    fn message<T: DeserializeOwned>() -> String {
        serde_json::from_str::<T>("7").err().map(|error| error.to_string()).unwrap()
    }
    for (found, name) in [
        (message::<Curve<QuarticBernstein, [f64; 2]>>(), "struct Curve"),
        (message::<TensorSurface<QuarticBernstein, QuarticBernstein, P>>(), "struct TensorSurface"),
        (message::<BoxPatch<Bilinear, f64>>(), "struct BoxPatch"),
        (message::<BSplineSurface<P>>(), "struct BSplineSurface"),
        (message::<KnotVector<f64>>(), "struct KnotVector"),
        (message::<Mesh<f64>>(), "struct Mesh"),
    ] {
        assert_eq!(found, format!("invalid type: integer `7`, expected {name} at line 1 column 1"));
    }
}

/// What is no data can be shared too; errors are errors.
#[test]
fn all_else_is_shared() {
    fn shared<T: Send + Sync + 'static>() {}
    fn error<T: std::error::Error + Clone + PartialEq + Send + Sync + 'static>() {}
    error::<ShapeError>();
    error::<CountError>();
    error::<CurveError>();
    error::<JoinError>();
    error::<RevolutionError>();
    error::<MeshError>();
    error::<Violation>();
    shared::<Place>();
    error::<KnotError>();
    error::<SplineError>();
    error::<FitError>();
    error::<ConstraintError>();
    error::<SpliceError>();
    error::<NetworkError>();
    shared::<Samples<P, EndpointForm<P, 3>>>();
    shared::<CurvePiece>();
    shared::<SurfacePiece>();
    shared::<Rounding>();
    error::<QuadratureError>();
    error::<SvgError>();
    error::<ConstructionError>();
    shared::<SvgMistake>();
    shared::<AnyCurve<P>>();
    shared::<Enclosed<P>>();
    shared::<Closest<P>>();
    shared::<Area<f64>>();
    shared::<Isocurve<'_, BSplineSurface<P>>>();
    shared::<Quadrature<P>>();
    shared::<DomainFactor>();
    shared::<Tabulation<f64, [usize; 2]>>();
    shared::<Entities>();
    shared::<Entity>();
    shared::<Chart<f64>>();
    again(LineJoin::Miter { limit: 4.0 });
    again(LineCap::Square);
    shared::<Offset<f64>>();
    shared::<Stroke<f64>>();
    shared::<Fit<'_, P>>();
    shared::<GridFit<'_, P>>();
    shared::<GridEnd<'_, P>>();
}

/// Every public struct and enum of the crate stands in this file; the surfaces that a tessellation borrows are of any
/// kind.
#[test]
fn none_is_forgotten() {
    let tests = include_str!("serialized.rs");
    let mut found = 0;
    for (path, text) in sources::files("") {
        let heads =
            text.lines().filter_map(|l| l.strip_prefix("pub struct ").or(l.strip_prefix("pub enum ")));
        for head in heads {
            let name = head.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
            found += 1;
            let used = tests.split(|c: char| !c.is_alphanumeric()).filter(|word| *word == name);
            assert!(used.count() >= 2, "{name} of {} is neither read back nor shared", path.display());
        }
    }
    assert!(found > 40);
}
