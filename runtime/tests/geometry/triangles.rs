//! Surfaces over triangles and patches on boxes answer what all surfaces do.

use basis_runtime::{
    Bezier, BoundedSurface, CurveError, Direction, Edge, EdgePair, Isocurve, MeetingKind, Orientation,
    ParametricCurve, Surface, SurfaceDomain, SurfacePiece, Tessellation, TriangleEdge, TriangleIndex,
    TriangularBezier,
};

use crate::queries::distance;
use crate::random::Random;
use crate::surfaces::{against_samples, isocurves, summed_area};

type P3 = [f64; 3];
type Cubic = TriangularBezier<P3, 4, 10>;

/// The patch whose points are nearly those of the graph of a function over the triangle of the parameters.
fn cubic(random: &mut Random) -> Cubic {
    Cubic::from_points(core::array::from_fn(|k| {
        let [i, j, _] = TriangleIndex::at(3, k).unwrap().components();
        let [x, y] = [i, j].map(|i| i as f64 + random.between::<f64>(-0.25, 0.25));
        [x, y, random.between(-1.0, 1.0)]
    }))
}

/// A type of one's own, which has only what the traits ask for.
struct Own<T>(T);

impl<T: Surface> Surface for Own<T> {
    type Point = T::Point;

    fn domain(&self) -> SurfaceDomain<basis_runtime::ScalarOf<T>> {
        self.0.domain()
    }

    fn eval(&self, u: basis_runtime::ScalarOf<T>, v: basis_runtime::ScalarOf<T>) -> T::Point {
        self.0.eval(u, v)
    }

    fn partial(
        &self,
        u: basis_runtime::ScalarOf<T>,
        v: basis_runtime::ScalarOf<T>,
        orders: [usize; 2],
    ) -> basis_runtime::VectorOf<T> {
        self.0.partial(u, v, orders)
    }
}

impl<T: BoundedSurface> BoundedSurface for Own<T> {
    fn pieces(&self) -> Vec<SurfacePiece> {
        self.0.pieces()
    }
}

#[cfg(feature = "macros")]
mod boxes {
    use basis_runtime::{BoxPatch, basis};

    basis! {
        family Sheet {
            domain -1 <= u <= 2, 0 <= v <= 1/2;
            b[i, j] = binomial(2, i) * ((u + 1)/3)^i * ((2 - u)/3)^(2 - i) * binomial(3, j) * (2*v)^j * (1 - 2*v)^(3 - j)
                for i in 0..=2, j in 0..=3;
        }
    }

    pub(crate) fn sheet(random: &mut crate::random::Random) -> BoxPatch<Sheet, [f64; 3]> {
        BoxPatch::new(
            Sheet::new(),
            core::array::from_fn(|k| [(k / 4) as f64, (k % 4) as f64, random.between(-1.0, 1.0)]),
        )
    }
}

#[test]
fn answer_as_all_surfaces_do() {
    let random = &mut Random::new(1811);
    for _ in 0..3 {
        let triangle = cubic(random);
        let surfaces: [&dyn BoundedSurface<Point = P3>; 2] = [&triangle, &Own(triangle)];
        for surface in surfaces {
            against_samples(surface, random);
            isocurves(surface, random);
        }
        #[cfg(feature = "macros")]
        {
            let sheet = boxes::sheet(random);
            against_samples(&sheet, random);
            isocurves(&sheet, random);
        }
    }
}

#[test]
fn have_areas() {
    let random = &mut Random::new(1812);
    let triangle = cubic(random);
    let mut surfaces: Vec<Box<dyn BoundedSurface<Point = P3>>> =
        vec![Box::new(triangle), Box::new(Own(triangle))];
    #[cfg(feature = "macros")]
    surfaces.push(Box::new(boxes::sheet(random)));
    for surface in surfaces {
        let area = surface.area(1e-6).unwrap();
        let sum = summed_area(&surface);
        assert!(area.error <= 1e-6 && (sum - area.value).abs() < 1e-3 * sum, "{area:?} {sum}");
    }
    // In the plane: ∫ (1 + u) du dv over the triangle = 1/2 + 1/6, for (u + u²/2, v).
    let flat = TriangularBezier::<[f64; 2], 3, 6>::from_points([
        [0.0, 0.0],
        [0.0, 0.5],
        [0.0, 1.0],
        [0.5, 0.0],
        [0.5, 0.5],
        [1.5, 0.0],
    ]);
    let area = flat.area(1e-10).unwrap();
    assert!(area.error <= 1e-10 && (area.value - 2.0 / 3.0).abs() <= area.error + 1e-15, "{area:?}");
}

/// The four edges are those of the triangle, one of them a corner.
#[test]
fn have_edges() {
    let random = &mut Random::new(1813);
    let patch = cubic(random);
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[u, v]| patch.eval(u, v));
    let ends = |edge| {
        let curve = patch.boundary(edge);
        [curve.start(), curve.end()]
    };
    assert_eq!(ends(Edge::UStart), [corners[0], corners[2]]);
    assert_eq!(ends(Edge::VStart), [corners[0], corners[1]]);
    assert_eq!(ends(Edge::VEnd), [corners[2], corners[1]]);
    assert_eq!(ends(Edge::UEnd), [corners[1]; 2]);
    assert_eq!(TriangleEdge::of(Edge::UEnd), None);
    for of_family in TriangleEdge::ALL {
        let edge = Edge::from(of_family);
        assert_eq!(TriangleEdge::of(edge), Some(of_family));
        let (curve, own) = (patch.boundary(edge), patch.edge_curve(of_family));
        for t in [0.0, 0.125, 0.5, 1.0] {
            let (u, v) = patch.domain().on_edge(edge, t);
            assert_eq!((curve.surface_parameters(t), curve.eval(t)), ((u, v), patch.eval(u, v)));
            assert!(distance(curve.eval(t), own.eval(t)) < 1e-15);
            for order in 1..=3 {
                let [ours, theirs] = [curve.derivative(t, order), own.derivative(t, order)];
                assert!(distance(ours, theirs) < 1e-12, "{edge:?} {order}: {ours:?} {theirs:?}");
            }
        }
        assert!((curve.arclen(1e-10) - own.arclen(1e-10)).abs() < 2e-10);
        let point = random.between(0.0, 1.0);
        assert!((curve.nearest(own.eval(point), 1e-10).unwrap().at - point).abs() < 1e-6);
    }
    // The corner answers as a curve that is one point.
    let corner = patch.boundary(Edge::UEnd);
    assert_eq!((corner.domain(), corner.arclen(1e-9), corner.tangent(0.0)), ([0.0, 0.0], 0.0, None));
    assert_eq!(corner.bounding_box(), [corners[1]; 2]);
    assert_eq!(corner.nearest(corners[0], 1e-9).unwrap().distance, distance(corners[0], corners[1]));
    // Also behind a trait object, and outside of the triangle.
    let dynamic: &dyn BoundedSurface<Point = P3> = &patch;
    let beyond = Isocurve::new(dynamic, Direction::U, 1.5);
    assert_eq!(beyond.domain(), [-0.5, 0.0]);
    assert_eq!(beyond.eval(-0.25), patch.eval(1.5, -0.25));
    let found = beyond.nearest(patch.eval(1.5, -0.25), 1e-10).unwrap();
    assert!((found.at + 0.25).abs() < 1e-6 && found.distance < 1e-9, "{found:?}");
}

/// The limits that follow from partial derivatives alone are those of the Newton polygon of the control points.
#[test]
fn have_limits_of_normals() {
    let random = &mut Random::new(1814);
    let regular = cubic(random);
    let places = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [0.5, 0.5], [0.25, 0.0], [0.0, 0.75], [0.25, 0.5]];
    for [u, v] in places {
        let [ours, theirs] = [Surface::normal(&Own(regular), u, v), regular.normal(u, v)].map(Option::unwrap);
        assert!(distance(ours, theirs) < 1e-12);
    }
    // One edge of a plane patch after the other is one point, and one corner after the other has no derivatives.
    let mut limits = 0;
    for kind in 0..6 {
        let place = |components: [usize; 3]| {
            let [u, v, w] = components.map(|i| i as f64 / 3.0);
            let at = [u, v, w][kind % 3];
            // Points next to the edge or the corner move to it, along straight lines through one point.
            let factor = if kind < 3 {
                at
            } else if at > 0.5 {
                0.0
            } else {
                1.0 - at
            };
            let [x, y] = [(v - u) * factor, (1.0 - w + 0.1 * u) * factor];
            [x, y, 0.0]
        };
        let patch = Cubic::from_points(core::array::from_fn(|k| {
            place(TriangleIndex::at(3, k).unwrap().components())
        }));
        for [u, v] in places {
            let [ours, theirs] = [Surface::normal(&Own(patch), u, v), patch.normal(u, v)];
            // Where both have a limit it is the same; the polygon sees more.
            if let (Some(ours), Some(theirs)) = (ours, theirs) {
                assert!(distance(ours, theirs) < 1e-6, "{kind} {u} {v}: {ours:?} {theirs:?}");
                let [a, b] = [patch.partial(u, v, [1, 0]), patch.partial(u, v, [0, 1])];
                limits += usize::from((a[0] * b[1] - a[1] * b[0]).abs() < 1e-12);
            }
            assert!(ours.is_none() || theirs.is_some(), "{kind} {u} {v}: {ours:?}");
        }
    }
    assert!(limits > 6, "{limits}");
}

/// A square of two triangles with a rectangle beside it: edges become seams, and all turn the same way.
#[test]
fn are_meshed_with_other_surfaces() {
    let at = |x: f64, y: f64| [x, y, 0.25 * x * x - 0.125 * x * y];
    // The Bézier points of the graph of this polynomial: its polar form in the middle of two places.
    let polar = |p: [f64; 2], q: [f64; 2]| {
        let product = |c: usize, d: usize| 0.5 * (p[c] * q[d] + p[d] * q[c]);
        [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.25 * product(0, 0) - 0.125 * product(0, 1)]
    };
    let triangle = |a: [f64; 2], b, c| {
        // At w = 1, v = 1 and u = 1.
        TriangularBezier::<P3, 3, 6>::from_points([
            polar(a, a),
            polar(a, b),
            polar(b, b),
            polar(a, c),
            polar(b, c),
            polar(c, c),
        ])
    };
    let [o, x, y, xy] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]];
    let (lower, upper) = (triangle(o, y, x), triangle(xy, x, y));
    let quadratic = basis_runtime::BernsteinBasis::<f64, 3>::new();
    let beside = basis_runtime::TensorSurface::new(
        quadratic,
        quadratic,
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                // x from 1 to 2 of degree two, y from 0 to 1.
                let (p, q) = (
                    [1.0 + [0.0, 0.0, 1.0][i], [0.0, 0.0, 1.0][j]],
                    [1.0 + [0.0, 1.0, 1.0][i], [0.0, 1.0, 1.0][j]],
                );
                let (x2, xy) = (p[0] * q[0], 0.25 * (p[0] + q[0]) * (p[1] + q[1]));
                [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.25 * x2 - 0.125 * xy]
            })
        }),
    );
    for (u, v) in [(0.2, 0.3), (0.5, 0.5)] {
        let [px, py, pz] = lower.eval(u, v);
        assert!(distance([px, py, pz], at(px, py)) < 1e-15);
        let [px, py, pz] = beside.eval(u, v);
        assert!(distance([px, py, pz], at(px, py)) < 1e-15);
    }
    // Smooth across the diagonal, and from the triangle to the rectangle.
    let diagonal = EdgePair::nearest(&lower, Edge::VEnd, &upper, Edge::VEnd);
    let joint = lower.joint(diagonal, &upper, 17);
    assert!(
        joint.geometric_order(1e-14, 1e-7, 1e-12) == Some(2) && joint.normals == Orientation::Same,
        "{joint:?}"
    );
    let side = EdgePair::nearest(&upper, Edge::UStart, &beside, Edge::UStart);
    let joint = upper.joint(side, &beside, 17);
    assert!(
        joint.geometric_order(1e-14, 1e-7, 1e-12) == Some(2) && joint.normals == Orientation::Same,
        "{joint:?}"
    );
    assert_eq!(joint.without_normal, 0);

    let mesh = Tessellation::new(1e-4).unwrap().with(&lower).with(&upper).with(&beside).mesh().unwrap();
    assert!(mesh.is_oriented());
    let boundary: f64 = mesh
        .boundary()
        .iter()
        .map(|&[a, b]| {
            let [a, b] = [a, b].map(|k| mesh.positions[k as usize]);
            (a[0] - b[0]).hypot(a[1] - b[1])
        })
        .sum();
    assert!((boundary - 6.0).abs() < 1e-12, "{boundary}"); // of a rectangle, and no seam between
    let area: f64 =
        [lower.area(1e-9), upper.area(1e-9), beside.area(1e-9)].map(|a| a.unwrap().value).iter().sum();
    assert!((mesh.area() - area).abs() < 1e-3, "{} {area}", mesh.area());
    for vertex in &mesh.vertices {
        let [u, v] = vertex.uv;
        let found = match vertex.surface {
            0 => lower.eval(u, v),
            1 => upper.eval(u, v),
            _ => beside.eval(u, v),
        };
        assert!(distance(found, mesh.positions[vertex.position as usize]) < 1e-5);
        assert!(vertex.surface == 2 || SurfaceDomain::Triangle.contains(u, v));
    }
}

#[test]
fn are_met_by_lines() {
    let random = &mut Random::new(1815);
    for round in 0..40 {
        let patch = cubic(random);
        let (u, v) = match round {
            0 => (0.5, 0.5),
            1 => (0.0, 1.0),
            2 => (0.25, 0.0),
            _ => SurfaceDomain::Triangle.at(random.between(0.0, 0.99), random.between(0.0, 1.0)),
        };
        let (point, along) = (patch.eval(u, v), [0.1, random.between(-0.2, 0.2), 1.0]);
        let origin = [0, 1, 2].map(|c| point[c] - 4.0 * along[c]);
        let found = patch.ray_intersections(origin, along, 1e-10).unwrap();
        let here = found.iter().find(|m| (m.at - 4.0).abs() < 1e-8).unwrap();
        assert!(here.distance < 1e-9 && here.kind == MeetingKind::Crossing, "{round} {here:?}");
        let [s, t] = here.surface_at;
        assert!(patch.domain().contains(s, t) && (s - u).abs() + (t - v).abs() < 1e-7, "{round} {here:?}");
    }
    // At the corner u = 1, where the patch over the unit square has a pole.
    let patch = cubic(random);
    let [x, y, z] = patch.eval(1.0, 0.0);
    let found = patch.line_intersections([x, y, z - 1.0], [0.0, 0.0, 1.0], 1e-9).unwrap();
    let here = found.iter().find(|m| (m.at - 1.0).abs() < 1e-6).unwrap();
    assert!((here.surface_at[0] - 1.0).abs() < 1e-6 && here.surface_at[1].abs() < 1e-6, "{here:?}");
}

#[test]
fn parameters_that_are_not_of_the_triangle() {
    let patch = cubic(&mut Random::new(1816));
    assert_eq!(patch.eval_checked(0.25, 0.75), Ok(patch.eval(0.25, 0.75)));
    assert_eq!(patch.eval_checked(0.5, 0.75), Err(CurveError::Parameter { value: 0.75, domain: [0.0, 0.5] }));
    assert!(patch.eval_checked(f64::NAN, 0.0).is_err() && patch.eval_checked(0.0, f64::NAN).is_err());
    assert_eq!(patch.eval_clamped(0.75, 0.75), patch.eval(0.5, 0.5));
    assert_eq!(patch.eval_clamped(-1.0, 3.0), patch.eval(0.0, 1.0));
    assert_eq!(patch.eval_clamped(2.0, -0.5), patch.eval(1.0, 0.0));
    // A net that is none.
    assert!(matches!(
        SurfacePiece::triangular(&[[0.0; 3]; 4]),
        Err(CurveError::Length { expected: 6, found: 4 })
    ));
    assert!(SurfacePiece::triangular::<P3>(&[]).is_err());
    let piece = SurfacePiece::triangular(patch.control_points()).unwrap();
    assert_eq!((piece.degrees(), piece.domain()), ([3, 3], [[0.0, 1.0]; 2]));
    let curve = Bezier::from_points([patch.eval(0.2, 0.2), [0.0, 0.0, 9.0]]);
    assert!(curve.surface_intersections(&patch, 1e-9).unwrap()[0].at < 1e-12);
}
