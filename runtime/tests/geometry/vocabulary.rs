//! The tables of the front page: which type answers which question.

use basis_runtime::bspline::{BSplineCurve, BSplineSurface, Net, NurbsCurve, NurbsSurface};
use basis_runtime::{
    AnyCurve, BernsteinBasis, Bezier, BoundedSurface, Contact, Direction, Edge, EdgePair, Isocurve,
    ParametricCurve, Path, PiecewiseCurve, Point, RationalBezier, RationalSurface, Surface,
    SurfaceOfRevolution, TensorSurface, Tessellation, TriangleContact, TriangularBezier,
};

#[cfg(feature = "macros")]
mod families {
    use basis_runtime::basis;

    basis!("../../../specs/rational/bezier.basis", Conic);
    basis! {
        /// Two parabolas that meet at a knot.
        family Hat {
            shape 0 < d;
            domain 0 <= x <= 1, 1 <= x <= 1 + d;
            b[0] = x^2 | ((1 + d - x)/d)^2;
            b[1] = 1 - b[0];
        }
    }
    basis! {
        family Square {
            domain 0 <= u <= 1, 0 <= v <= 1;
            b[i, j] = (1 - i + (2*i - 1)*u) * (1 - j + (2*j - 1)*v) for i in 0..=1, j in 0..=1;
        }
    }

    pub(crate) fn sheet() -> basis_runtime::BoxPatch<Square, [f64; 3]> {
        let points = [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0; 3]];
        basis_runtime::BoxPatch::new(Square::new(), points)
    }
}

/// The rows of the table that begins with this head: their cells.
fn table(head: &str) -> Vec<Vec<String>> {
    let page = include_str!("../../src/lib.rs");
    let lines = page.lines().map(|line| line.trim_start_matches("//!").trim());
    let rows = lines.skip_while(|line| !line.starts_with(head)).take_while(|line| line.starts_with('|'));
    rows.map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()).collect()
}

/// The functions of a trait, from its source, but for those that its documentation hides.
fn functions(source: &str, name: &str) -> Vec<String> {
    let body = source.split(&format!("pub trait {name}")).nth(1).expect("the trait is there");
    let body = body.split("\n}").next().expect("it ends");
    let (mut names, mut hidden) = (Vec::new(), false);
    for line in body.lines() {
        hidden |= line == "    #[doc(hidden)]";
        if let Some(head) = line.strip_prefix("    fn ") {
            if !hidden {
                names.push(head.split(['(', '<']).next().unwrap_or_default().to_owned());
            }
            hidden = false;
        }
    }
    names
}

/// Every function of the traits and of `others` has a row, every row is one, and an empty cell or a "no" has a reason; a
/// query whose name a type has is in its column.
fn agree(head: &str, traits: &[(&str, &str)], others: &[&str], asked: &[(&str, Vec<&str>)]) {
    let rows = table(head);
    assert!(rows.len() > 8, "the table {head} is there");
    let mut listed = Vec::new();
    for row in &rows[2..] {
        assert_eq!(row.len(), rows[0].len(), "{row:?}");
        let names: Vec<&str> =
            row[0].split('`').skip(1).step_by(2).filter(|name| !name.contains(']')).collect();
        for (cell, column) in row[1..].iter().zip(&rows[0][1..]) {
            let reason = cell.strip_prefix("no: ").is_some_and(|reason| reason.split(' ').count() > 2);
            assert!(cell == "yes" || reason, "{row:?}: {cell}");
            let (_, calls) = asked.iter().find(|(of, _)| column.contains(of)).expect("the column is asked");
            for name in &names {
                assert_eq!(calls.contains(name), cell == "yes", "`{name}` of {column}: {cell}");
            }
        }
        listed.extend(names.into_iter().map(str::to_owned));
    }
    let mut expected: Vec<String> =
        traits.iter().flat_map(|&(source, name)| functions(source, name)).collect();
    expected.extend(others.iter().map(|&name| name.to_owned()));
    listed.sort();
    expected.sort();
    assert_eq!(listed, expected);
}

/// Calls each query, which so is there under this name with these arguments, whether as a method of the type or of the
/// trait; what it answers is tested where it belongs. The names of the queries.
macro_rules! ask {
    ($object:expr => $($name:ident $(::<$count:literal>)? ($($argument:expr),*);)+) => {{
        $(let _ = $object.$name$(::<$count>)?($($argument),*);)+
        vec![$(stringify!($name)),+]
    }};
}

/// The queries of curves, in space but for those that have a meaning in the plane alone.
macro_rules! ask_curve {
    ($space:expr, $plane:expr, $($more:tt)*) => {{
        let (space, plane) = ($space, $plane);
        let line = Bezier::from_points([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]);
        let mut names = ask! { space =>
            domain(); eval(0.3); eval_checked(0.3); eval_clamped(0.3); eval_into(&[0.3], &mut [[0.0; 3]; 1]); start(); end();
            samples_into(&mut [[0.0; 3]; 4]); derivative(0.3, 1); derivatives_into(0.3, &mut [[0.0; 3]; 2]);
            tangent(0.3); curvature(0.3); torsion(0.3); frenet_frame(0.3); rotation_minimizing_frames(3, None);
            arclen(1e-3); inv_arclen(0.5, 1e-3); arclen_parameters(3, 1e-3); samples_by_arclen(3, 1e-3);
            flatten(1e-2); bounding_box(); control_box(); extrema(); nearest([0.0; 3], 1e-3); first_where(0, 0.5);
            closest(&line, 1e-3); joint(&line); intersections(&line, 1e-3); self_intersections(1e-3);
            plane_intersections([0.0; 3], [1.0, 0.0, 0.0]); surface_intersections(&plane_patch(), 1e-3); pieces();
        };
        names.extend(ask! { plane => inflections(); enclosed(); winding([0.1, 0.2]); offset(0.1, 1e-3); });
        names.extend(ask! { space => $($more)* });
        names
    }};
    ($space:expr, $plane:expr) => {
        ask_curve!($space, $plane,
            samples(3); eval_with_derivs::<3>(0.3); split(0.3); subsegment(0.2..0.1); reversed(); map(|p| p); transform(&TURN);
            continued(Contact::Tangent { f: 1.0 }, &arch(|p| p)); preceded(Contact::Tangent { f: 1.0 }, &arch(|p| p));)
    };
}

/// The queries of surfaces.
macro_rules! ask_surface {
    // Of rows of control points: a surface of the type of this one, of which it may be a reference.
    ($surface:expr; continues $next:expr) => {{
        let mut names = ask_surface!($surface);
        names.extend(ask! { $surface => continued(ACROSS, Contact::Tangent { f: 1.0 }, $next); });
        names
    }};
    ($surface:expr, $($more:tt)*) => {{
        let surface = $surface;
        let mut names = ask! { surface =>
            domain(); eval(0.3, 0.4); eval_checked(0.3, 0.4); eval_clamped(0.3, 0.4); eval_grid(&[0.1], &[0.2], &mut [[0.0; 3]; 1]); partial(0.3, 0.4, [1, 1]);
            partials_into(0.3, 0.4, 2, &mut [[0.0; 3]; 4]); normal(0.3, 0.4); curvature(0.3, 0.4); pieces();
            control_box(); bounding_box(); area(1e-3); nearest([0.0; 3], 1e-3); joint(ACROSS, &plane_patch(), 3);
            ray_intersections([0.0; 3], [0.0, 0.0, 1.0], 1e-3); line_intersections([0.0; 3], [0.0, 0.0, 1.0], 1e-3);
        };
        let _ = Tessellation::new(0.5).unwrap().with(&surface).mesh();
        names.push("with");
        names.extend(ask! { surface => $($more)* });
        names
    }};
    ($surface:expr) => {
        ask_surface!($surface,
            eval_with_partials::<2>(0.3, 0.4); isocurve(Direction::U, 0.5); boundary(Edge::VEnd);
            split(Direction::U, 0.5); subpatch(0.75..0.25, 0.25..0.5); reversed(Direction::V); map(|p| p); transform(&TURN);)
    };
}

/// A right angle about the third axis, in rows.
const TURN: [[f64; 3]; 3] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

/// An edge across which a surface can be continued.
const ACROSS: EdgePair = EdgePair::along(Edge::UEnd, Edge::UStart);

/// The queries that are neither of a trait.
const PARTS: [&str; 8] =
    ["split", "subpatch", "reversed", "with", "map", "transform", "joint_bounds", "continued"];

fn plane_patch() -> BSplineSurface<[f64; 3]> {
    BSplineSurface::from_bezier(Net::from_fn(2, 2, |i, j| [i as f64, j as f64, 0.5]).unwrap()).unwrap()
}

fn arch<P: Point<Scalar = f64>>(of: impl Fn([f64; 3]) -> P) -> Bezier<P, 4> {
    Bezier::from_points([[0.0, 0.0, 0.0], [1.0, 2.0, 0.5], [2.0, -1.0, 1.0], [3.0, 0.5, 0.0]].map(of))
}

#[test]
fn of_curves() {
    let (space, plane) = (arch(|p| p), arch(|[x, y, _]| [x, y]));
    let splines = (
        BSplineCurve::from_bezier(space.control_points().to_vec()).unwrap(),
        BSplineCurve::from_bezier(plane.control_points().to_vec()).unwrap(),
    );
    let nurbs = (NurbsCurve::from(splines.0.clone()), NurbsCurve::from(splines.1.clone()));
    let (path, flat) = (Path::from_curve(&space), Path::from_curve(&plane));
    let rational = RationalBezier::new([[0.0; 3], [1.0; 3]], [1.0, 2.0]).unwrap();
    let rational_plane = RationalBezier::new([[0.0; 2], [1.0; 2]], [1.0, 2.0]).unwrap();
    let surface = plane_patch();
    let isocurve = Isocurve::new(&surface, Direction::U, 0.5);
    // Types without a column answer all as well.
    let _ = ask_curve!(AnyCurve::new(space), AnyCurve::new(plane));
    let _ = (ask_curve!(&path, &flat), ask_curve!(&rational, &rational_plane));
    #[cfg(feature = "macros")]
    {
        let conic = families::Conic::new(0.5).unwrap();
        let ends = ([[0.0; 3], [1.0, 2.0, 0.5], [2.0, 0.0, 1.0]], [[0.0; 2], [1.0, 2.0], [2.0, 0.0]]);
        let _ = ask_curve!(conic.curve(ends.0), conic.curve(ends.1));
        let hat = families::Hat::new(0.5).unwrap();
        let hats = (hat.curve([ends.0[0], ends.0[1]]), hat.curve([ends.1[0], ends.1[1]]));
        let _ = ask_curve!(hats.0, hats.1);
        let splines = (hats.0.to_rational_spline(), hats.1.to_rational_spline());
        let _ = ask_curve!(&splines.0, &splines.1);
    }
    let _ = ask_curve!(&isocurve, &flat, samples(3); eval_with_derivs::<3>(0.3); split(0.3); reversed(););
    let asked = [
        ("`Curve`", ask_curve!(space, plane)),
        ("`AnyCurve`", {
            let of = |curve| PiecewiseCurve::new(vec![curve, AnyCurve::new(arch(|p| p))]).unwrap();
            let flat = PiecewiseCurve::from(AnyCurve::new(plane));
            ask_curve!(of(AnyCurve::new(splines.0.clone())), flat)
        }),
        ("`PiecewiseCurve`", ask_curve!(PiecewiseCurve::from(space), PiecewiseCurve::from(plane))),
        ("`BSplineCurve`", ask_curve!(&splines.0, &splines.1)),
        ("`NurbsCurve`", ask_curve!(&nurbs.0, &nurbs.1)),
        ("dyn", {
            let space: &dyn ParametricCurve<Point = [f64; 3]> = &space;
            let plane: &dyn ParametricCurve<Point = [f64; 2]> = &plane;
            ask_curve!(space, plane, domain();)
        }),
    ];
    agree(
        "| a curve's",
        &[(include_str!("../../src/geometry/parametric.rs"), "ParametricCurve")],
        &["map", "transform"],
        &asked,
    );
}

#[test]
fn of_surfaces() {
    let [surface, bounded] =
        [include_str!("../../src/surface/mod.rs"), include_str!("../../src/surface/pieces.rs")];
    let bilinear = [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]];
    let linear = BernsteinBasis::<f64, 2>::new();
    let tensor = TensorSurface::new(linear, linear, bilinear);
    let rational = RationalSurface::new(linear, linear, bilinear, [[1.0, 2.0], [1.0, 1.0]]);
    let generatrix = Bezier::from_points([[0.0, 1.0], [1.0, 2.0]]);
    let revolved = SurfaceOfRevolution::about_x(&generatrix, 1.0).unwrap();
    let spline = plane_patch();
    let nurbs = NurbsSurface::from(spline.clone());
    let triangle =
        TriangularBezier::<[f64; 3], 2, 3>::from_points([[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    #[cfg(feature = "macros")]
    let sheet = ask_surface!(families::sheet());
    #[cfg(not(feature = "macros"))]
    let sheet = ask_surface!(&spline);
    let asked = [
        ("`TensorSurface`", ask_surface!(tensor; continues &tensor)),
        ("`RationalSurface`", ask_surface!(rational; continues &rational)),
        ("`SurfaceOfRevolution`", ask_surface!(revolved; continues &revolved)),
        ("`BSplineSurface`", {
            let mut names = ask_surface!(&spline; continues &spline);
            names.extend(ask! { &spline => joint_bounds(ACROSS, &spline); });
            names
        }),
        ("`NurbsSurface`", ask_surface!(&nurbs; continues &nurbs)),
        (
            "`TriangularPatch`",
            ask_surface!(triangle,
                eval_with_partials::<2>(0.3, 0.4); isocurve(Direction::U, 0.5); boundary(Edge::VEnd); map(|p| p); transform(&TURN);
                continued(EdgePair::against(Edge::VEnd, Edge::VEnd), TriangleContact::new(0, [1.0, 1.0, -1.0]), &triangle);),
        ),
        ("`BoxPatch`", sheet),
        ("dyn", {
            let surface: &dyn BoundedSurface<Point = [f64; 3]> = &tensor;
            ask_surface!(surface, domain();)
        }),
    ];
    agree("| a surface's", &[(surface, "Surface"), (bounded, "BoundedSurface")], &PARTS, &asked);
}
