//! Meshes are within the tolerance, have no cracks, and turn one way.

use basis_runtime::{
    BernsteinBasis, Bezier, BoundedSurface, Curve, Direction, Mesh, MeshError, Point, Point3,
    RationalSurface, Scalar, SurfaceOfRevolution, TensorSurface, Tessellation, Vertex,
};

use crate::families::{Cubic, Linear, QuarticBernstein, bicubic, graph, random_surface};
use crate::random::Random;

const FULL: f64 = 2.0 * core::f64::consts::PI;

/// The largest distance that was met of points of the triangles from their surface, and of points of the surfaces from
/// the mesh.
pub(super) fn deviation<T>(mesh: &Mesh<f64>, surfaces: &[&T]) -> f64
where
    T: BoundedSurface,
    T::Point: Point3<Scalar = f64>,
{
    let mut largest = 0.0_f64;
    let step = mesh.triangles.len().div_ceil(16);
    for &triangle in mesh.triangles.iter().step_by(step) {
        let vertices = triangle.map(|v| mesh.vertices[v as usize]);
        for weights in [[1.0, 1.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [4.0, 1.0, 1.0]] {
            let sum: f64 = weights.iter().sum();
            let corners = vertices.map(|vertex| mesh.positions[vertex.position as usize]);
            let flat = T::Point::from_components(|k| (0..3).map(|n| weights[n] / sum * corners[n][k]).sum());
            let surface = surfaces[vertices[0].surface as usize];
            largest = largest.max(surface.nearest(flat, 1e-6).unwrap().at_least);
        }
    }
    for surface in surfaces {
        for n in 0..7 * 7 {
            let [x, y] = [n / 7, n % 7].map(|k| f64::from(k) / 6.0);
            let (u, v) = surface.domain().at(x, y);
            let point = surface.eval(u, v);
            let point = [0, 1, 2].map(|k| point.component(k));
            let corners =
                |triangle: &[u32; 3]| mesh.corners(*triangle).unwrap().map(|p| mesh.positions[p as usize]);
            let away = mesh.triangles.iter().map(corners).fold(f64::INFINITY, |least, corners| {
                if is_farther(point, corners, least) { least } else { least.min(to_triangle(point, corners)) }
            });
            largest = largest.max(away);
        }
    }
    largest
}

/// Whether a triangle lies beyond a plane, across one of the axes, that is at this distance from the point.
fn is_farther(point: [f64; 3], [a, b, c]: [[f64; 3]; 3], distance: f64) -> bool {
    (0..3).any(|k| {
        let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
        low - point[k] > distance || point[k] - high > distance
    })
}

/// The distance of a point from a triangle, by the nearest of many of its points and the walk to a better one.
fn to_triangle(p: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] - b[k]);
    let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
    let length = |a: [f64; 3]| dot(a, a).sqrt();
    let segment = |from: [f64; 3], to: [f64; 3]| {
        let (chord, arm) = (minus(to, from), minus(p, from));
        let x = (dot(arm, chord) / dot(chord, chord)).clamp(0.0, 1.0);
        length(minus(arm, chord.map(|c| x * c)))
    };
    let sides = segment(a, b).min(segment(b, c)).min(segment(c, a));
    // The foot on the plane, if it lies inside of all three sides.
    let (e, f, arm) = (minus(b, a), minus(c, a), minus(p, a));
    let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let square = dot(normal, normal);
    let foot = minus(arm, normal.map(|n| n * dot(arm, normal) / square));
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let (y, z) = (dot(cross(foot, f), normal) / square, dot(cross(e, foot), normal) / square);
    let inside = y >= 0.0 && z >= 0.0 && y + z <= 1.0;
    if inside { sides.min(dot(arm, normal).abs() / square.sqrt()) } else { sides }
}

/// Every normal agrees with the triangles around it.
fn normals_agree(mesh: &Mesh<f64>) -> bool {
    mesh.triangles.iter().all(|&triangle| {
        let [a, b, c] = mesh.corners(triangle).unwrap().map(|p| mesh.positions[p as usize]);
        let [x, y] = [b, c].map(|p| [0, 1, 2].map(|k| p[k] - a[k]));
        let area = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        triangle.iter().all(|&v| {
            let normal = mesh.vertices[v as usize].normal;
            (0..3).map(|k| normal[k] * area[k]).sum::<f64>() > 0.0
        })
    })
}

pub(super) fn lonely<T>(surface: &T, tolerance: f64) -> Mesh<f64>
where
    T: BoundedSurface,
    T::Point: Point3<Scalar = f64>,
{
    Tessellation::new(tolerance).unwrap().with(surface).mesh().unwrap()
}

#[test]
fn are_within_the_tolerance() {
    let random = &mut Random::new(81);
    for _ in 0..2 {
        let surface = random_surface::<[f64; 3]>(random);
        let mut last = 0;
        for tolerance in [0.1, 0.02] {
            let mesh = lonely(&surface, tolerance);
            let distance = deviation(&mesh, &[&surface]);
            assert!(distance <= tolerance, "{distance} > {tolerance}");
            assert!(mesh.is_oriented());
            assert!(mesh.triangles.len() > last, "finer means more");
            last = mesh.triangles.len();
        }
    }
}

#[test]
fn flat_surfaces_need_two_triangles() {
    let mesh = lonely(&bicubic(|i, j| [i as f64, j as f64, 0.0]), 1e-9);
    assert_eq!((mesh.triangles.len(), mesh.positions.len()), (2, 4));
    assert_eq!(mesh.area(), 9.0);
    assert_eq!(mesh.boundary().len(), 4);
    assert!(mesh.vertices.iter().all(|v| v.normal == [0.0, 0.0, 1.0]));
}

/// More triangles where the surface bends.
#[test]
fn are_adaptive() {
    let surface = bicubic(|i, j| [i as f64, j as f64, if i == 3 && j == 3 { 3.0 } else { 0.0 }]);
    let mesh = lonely(&surface, 1e-3);
    let in_quarter = |low: f64| {
        mesh.vertices.iter().filter(|v| v.uv.iter().all(|&x| (low..=low + 0.5).contains(&x))).count()
    };
    assert!(in_quarter(0.5) > 3 * in_quarter(0.0), "{} {}", in_quarter(0.5), in_quarter(0.0));
    assert!(deviation(&mesh, &[&surface]) <= 1e-3);
}

#[test]
fn joined_surfaces_share_their_seam() {
    let random = &mut Random::new(82);
    for _ in 0..2 {
        let surface = random_surface::<[f64; 3]>(random);
        let [left, right] = surface.split(Direction::U, 0.37).unwrap();
        let [below, above] = left.split(Direction::V, 0.6).unwrap();
        // One of them runs the other way round.
        let right = right.subpatch(0.0..1.0, 1.0..0.0).unwrap();
        let [upper, lower] = right.split(Direction::V, 0.4).unwrap();
        let parts = [&below, &above, &upper, &lower];
        let tessellation = parts.iter().fold(Tessellation::new(0.01).unwrap(), |t, part| t.with(*part));
        assert!(deviation(&disc(&tessellation), &parts) <= 0.01);
    }
}

/// The mesh of the surfaces, which must have no crack: one boundary loop, as many of its edges as positions on it, and
/// what Euler's formula gives for a disc.
fn disc(tessellation: &Tessellation<'_, f64>) -> Mesh<f64> {
    let mesh = tessellation.mesh().unwrap();
    assert!(mesh.is_oriented());
    let boundary = mesh.boundary();
    let mut on_boundary: Vec<u32> = boundary.iter().flatten().copied().collect();
    on_boundary.sort_unstable();
    on_boundary.dedup();
    assert_eq!(boundary.len(), on_boundary.len());
    let twice_the_edges = 3 * mesh.triangles.len() + boundary.len();
    assert_eq!(2 * (mesh.positions.len() + mesh.triangles.len()), twice_the_edges + 2);
    mesh
}

#[test]
fn edges_with_different_parameters_are_one_seam() {
    let random = &mut Random::new(83);
    let cubic = BernsteinBasis::<f64, 4>::new();
    for round in 0..2 {
        // Both edges are the segment from (1, 0, 0) to (1, 1, 0), with other control points on it.
        let (a, b) = (random.between(0.05, 0.9), random.between(0.1, 0.95));
        let side = |at: [f64; 4], x: f64, heights: [f64; 4]| {
            core::array::from_fn(|i| {
                let away = i as f64 / 3.0;
                core::array::from_fn(|j| [1.0 + x * away, at[j], away * heights[j] * (1.0 + away)])
            })
        };
        let left =
            TensorSurface::new(cubic, cubic, side([0.0, a * 0.5, a, 1.0], -1.0, [0.1, 0.7, -0.4, 0.3]));
        let mut at = [0.0, b * 0.3, b, 1.0];
        if round % 2 == 1 {
            at.reverse();
        }
        let right = TensorSurface::new(cubic, cubic, side(at, 1.0, [-0.2, 0.5, 0.3, -0.6]));
        let surfaces = [&left, &right];
        let mesh = disc(&Tessellation::new(2e-3).unwrap().with(&left).with(&right));
        assert!(deviation(&mesh, &surfaces) <= 2e-3);
        assert!(normals_agree(&mesh));
        // The seam is no boundary.
        let inside = |p: &[f64; 3]| p[0] == 1.0 && p[1] > 0.0 && p[1] < 1.0;
        assert!(mesh.positions.iter().filter(|&p| inside(p)).count() > 5);
        let positions = &mesh.positions;
        assert!(!mesh.boundary().iter().any(|edge| edge.iter().any(|&p| inside(&positions[p as usize]))));
    }
}

#[test]
fn a_long_edge_meets_short_ones() {
    let random = &mut Random::new(84);
    for _ in 0..1 {
        let surface = random_surface::<[f64; 3]>(random);
        let [left, right] = surface.split(Direction::U, 0.37).unwrap();
        let [below, above] = left.split(Direction::V, 0.6).unwrap();
        let [first, rest] = right.split(Direction::V, 0.25).unwrap();
        let [second, third] = rest.split(Direction::V, 0.4).unwrap();
        let parts = [&below, &above, &first, &second, &third];
        let tessellation = parts.iter().fold(Tessellation::new(0.01).unwrap(), |t, part| t.with(*part));
        assert!(deviation(&disc(&tessellation), &parts) <= 0.01);
    }
}

#[test]
fn circles_that_begin_at_different_angles() {
    let arc = |points: [[f64; 2]; 4], turn: f64| {
        let points = points.map(|[x, r]| [x, r * turn.cos(), r * turn.sin()]);
        let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
        SurfaceOfRevolution::new(&curve, [0.0; 3], [1.0, 0.0, 0.0], FULL).unwrap()
    };
    let cup = arc([[-1.0, 0.0], [-1.0, 0.5], [-0.6, 1.0], [0.0, 1.0]], 0.0);
    let lid = arc([[0.0, 1.0], [0.6, 1.0], [1.0, 0.7], [1.0, 0.0]], 1.0);
    let mesh = Tessellation::new(0.01).unwrap().with(&cup).with(&lid).mesh().unwrap();
    assert!(mesh.is_closed() && mesh.volume() > 0.0);
    assert!(deviation(&mesh, &[&cup, &lid]) <= 0.01);
    assert!(normals_agree(&mesh));
}

fn egg(angle: f64) -> SurfaceOfRevolution<QuarticBernstein, [f64; 3]> {
    let points = [[-1.0, 0.0], [-1.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    SurfaceOfRevolution::about_x(&Curve::new(QuarticBernstein::new(0.5).unwrap(), points), angle).unwrap()
}

/// Two poles and a seam: closed, oriented outwards, and of the right volume.
#[test]
fn closed_surfaces_of_revolution() {
    let surface = egg(FULL);
    let mesh = lonely(&surface, 1e-3);
    assert!(mesh.is_closed());
    // V - E + F = 2.
    assert_eq!(mesh.positions.len() + mesh.triangles.len(), 3 * mesh.triangles.len() / 2 + 2);
    assert!(normals_agree(&mesh));
    assert!(deviation(&mesh, &[&surface]) <= 1e-3);
    // ∫ π y² dx by Simpson's rule.
    let curve = surface.meridian(0.0);
    let slice = |t: f64| {
        let [p, d] = curve.eval_with_derivs(t);
        core::f64::consts::PI * p[1] * p[1] * d[0]
    };
    let simpson: f64 = (0..1000)
        .map(|k| {
            let t = f64::from(k) / 1000.0;
            (slice(t) + 4.0 * slice(t + 0.0005) + slice(t + 0.001)) / 6000.0
        })
        .sum();
    assert!(mesh.volume() > 0.0 && (mesh.volume() - simpson).abs() < 0.02, "{} {simpson}", mesh.volume());
}

#[test]
fn open_surfaces_of_revolution() {
    let mesh = lonely(&egg(2.0), 1e-2);
    assert!(!mesh.is_closed() && mesh.is_oriented() && normals_agree(&mesh));
    // The rational patches of the full turn close as well.
    let patches = egg(FULL).to_rational_patches();
    let mut tessellation = Tessellation::new(1e-2).unwrap();
    for patch in &patches {
        tessellation = tessellation.with(patch);
    }
    let mesh = tessellation.mesh().unwrap();
    assert!(mesh.is_closed() && normals_agree(&mesh) && mesh.volume() > 0.0);
    assert!(deviation(&mesh, &patches.iter().collect::<Vec<_>>()) <= 1e-2);
    // So do both half-turns of the paper, with a control point at infinity.
    let patches = egg(FULL).half_turns();
    let mesh = Tessellation::new(1e-2).unwrap().with(&patches[0]).with(&patches[1]).mesh().unwrap();
    assert!(mesh.is_closed() && mesh.volume() > 0.0);
}

/// Six faces, each with parameters that turn any way: a closed cube that faces outwards.
#[test]
fn a_cube() {
    let linear = Linear::new();
    let corner = |k: usize| [0, 1, 2].map(|c| f64::from((k >> c & 1) as u32));
    let faces = [[0, 1, 2, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 3, 6, 7], [0, 2, 4, 6], [1, 3, 5, 7]];
    let faces = faces.map(|[a, b, c, d]| {
        TensorSurface::new(linear, linear, [[corner(a), corner(b)], [corner(c), corner(d)]])
    });
    let mut tessellation = Tessellation::new(1e-3).unwrap();
    for face in &faces {
        tessellation = tessellation.with(face);
    }
    let mesh = tessellation.mesh().unwrap();
    assert!(mesh.is_closed());
    assert_eq!((mesh.positions.len(), mesh.vertices.len(), mesh.triangles.len()), (8, 24, 12));
    assert_eq!((mesh.volume(), mesh.area()), (1.0, 6.0));
    assert!(normals_agree(&mesh));
}

/// A band of two pieces, one of them twisted by a half turn: there is no orientation, and no endless loop.
#[test]
fn a_strip_with_one_side() {
    let linear = Linear::new();
    let a = TensorSurface::new(
        linear,
        linear,
        [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]],
    );
    let b = TensorSurface::new(
        linear,
        linear,
        [[[0.0, 1.0, 0.0], [0.0, 0.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]],
    );
    let mesh = Tessellation::new(1e-3).unwrap().with(&a).with(&b).mesh().unwrap();
    assert!(mesh.triangles.len() > 2 && !mesh.is_oriented());
}

#[test]
fn in_single_precision() {
    let surface = TensorSurface::new(
        QuarticBernstein::new(0.5_f32).unwrap(),
        Cubic::<f32>::new(),
        core::array::from_fn(|i| core::array::from_fn(|j| [i as f32, j as f32, ((i * j) as f32).sin()])),
    );
    let mesh = Tessellation::new(0.01).unwrap().with(&surface).mesh().unwrap();
    assert!(mesh.triangles.len() > 10 && mesh.is_oriented());
    #[cfg(feature = "glam")]
    {
        let net = core::array::from_fn(|i| {
            core::array::from_fn(|j| glam::Vec3::new(i as f32, j as f32, ((i * j) as f32).sin()))
        });
        let surface = TensorSurface::new(QuarticBernstein::new(0.5_f32).unwrap(), Cubic::new(), net);
        assert_eq!(Tessellation::new(0.01).unwrap().with(&surface).mesh().unwrap(), mesh);
    }
}

#[test]
fn degenerate_surfaces() {
    // A point, a straight line, a curve.
    for surface in [
        bicubic(|_, _| [1.0; 3]),
        bicubic(|i, _| [i as f64, 0.0, 0.0]),
        bicubic(|i, j| [(i * j) as f64, 0.0, 0.0]),
    ] {
        let error = Tessellation::new(0.1).unwrap().with(&surface).mesh().unwrap_err();
        assert_eq!(error, MeshError::Collapsed { surface: 0 });
        assert!(error.to_string().contains("is a curve or a point"), "{error}");
    }
    let empty = Tessellation::<f64>::new(0.1).unwrap().mesh().unwrap();
    assert_eq!(empty, Mesh::default());
    assert_eq!(empty.volume(), 0.0);
}

#[test]
fn of_surfaces_behind_references() {
    let surface = egg(2.0);
    let expected = Tessellation::new(0.05).unwrap().with(&surface).mesh().unwrap();
    let behind: &dyn BoundedSurface<Point = [f64; 3]> = &surface;
    assert_eq!(Tessellation::new(0.05).unwrap().with(behind).mesh().unwrap(), expected);
    assert_eq!(Tessellation::new(0.05).unwrap().with(&behind).mesh().unwrap(), expected);
}

#[test]
fn refused() {
    for tolerance in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(Tessellation::new(tolerance).err(), Some(MeshError::Tolerance { value: tolerance }));
    }
    assert!(Tessellation::new(f64::NAN).is_err());
    for wrong in [f64::NAN, f64::INFINITY, f64::MAX] {
        let surface = bicubic(|i, j| [i as f64, j as f64, if i == 1 { wrong } else { 0.0 }]);
        assert!(Tessellation::new(0.1).unwrap().with(&surface).mesh().is_err(), "{wrong}");
    }
    let bent = graph(|u, v| u * u + v * v);
    let error = Tessellation::new(1e-14).unwrap().with(&bent).mesh().unwrap_err();
    assert!(matches!(error, MeshError::TooFine { surface: 0, .. }), "{error}");
    // So far away that the tolerance is a rounding error.
    let far = [1e12, 1e12 + 1.0].map(|x| [x, 1.0]);
    let far = SurfaceOfRevolution::about_x(&Bezier::from_points(far), FULL).unwrap();
    let error = Tessellation::new(1e-4).unwrap().with(&far).mesh().unwrap_err();
    assert!(matches!(error, MeshError::TooFine { surface: 0, .. }), "{error}");
    // A quotient with a pole.
    let linear = BernsteinBasis::<f64, 2>::new();
    let net = [[[0.0; 3], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]];
    let pole = RationalSurface::new(linear, linear, net, [[1.0, 1.0], [-1.0, -1.0]]);
    assert!(Tessellation::new(0.1).unwrap().with(&pole).mesh().is_err());
}

#[test]
fn edges_and_angles_as_short_as_asked_for() {
    let surface = egg(2.0);
    let mesh = Tessellation::new(0.1).unwrap().longest_edge(0.05).unwrap().with(&surface).mesh().unwrap();
    for triangle in &mesh.triangles {
        let [a, b, c] = mesh.corners(*triangle).unwrap().map(|p| mesh.positions[p as usize]);
        for [p, q] in [[a, b], [b, c], [c, a]] {
            let length = (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
            assert!(length <= 0.1 + 1e-9, "{length}");
        }
    }
    let count = |angle: f64| {
        let tessellation = Tessellation::new(0.1).unwrap().largest_angle(angle).unwrap();
        tessellation.with(&surface).mesh().unwrap().triangles.len()
    };
    assert!(count(0.05) > 3 * count(0.2) && count(0.2) > lonely(&surface, 0.1).triangles.len());
    for wrong in [0.0, -1.0, f64::NAN] {
        assert!(Tessellation::new(0.1).unwrap().longest_edge(wrong).is_err());
        assert!(Tessellation::new(0.1).unwrap().largest_angle(wrong).is_err());
    }
}

/// A long cylinder in strips, or in triangles of a decent shape; around poles there are none.
#[test]
fn triangles_of_a_decent_shape() {
    let tube = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 1.0], [20.0, 1.0]]), FULL).unwrap();
    let count = |aspect: Option<f64>| {
        let mut tessellation = Tessellation::new(0.01).unwrap();
        if let Some(aspect) = aspect {
            tessellation = tessellation.largest_aspect(aspect).unwrap();
        }
        let mesh = tessellation.with(&tube).mesh().unwrap();
        assert!(deviation(&mesh, &[&tube]) <= 0.01);
        let shape = |triangle: &[u32; 3]| {
            let [a, b, c] = mesh.corners(*triangle).unwrap().map(|p| mesh.positions[p as usize]);
            let length = |p: [f64; 3], q: [f64; 3]| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
            let sides = [length(a, b), length(b, c), length(c, a)];
            sides.into_iter().fold(0.0, f64::max) / sides.into_iter().fold(f64::INFINITY, f64::min)
        };
        (mesh.triangles.len(), mesh.triangles.iter().map(shape).fold(0.0, f64::max))
    };
    let (strips, long) = count(None);
    let (decent, shape) = count(Some(3.0));
    assert!(strips < 100 && long > 40.0, "{strips} {long}");
    assert!(decent < 100 * strips && shape <= f64::hypot(3.0, 1.0) + 1e-9, "{decent} {shape}");
    let ball = egg(2.0);
    let round = Tessellation::new(0.05).unwrap().largest_aspect(2.0).unwrap().with(&ball).mesh().unwrap();
    assert!(deviation(&round, &[&ball]) <= 0.05);
    for wrong in [1.9, 0.0, -3.0, f64::NAN] {
        assert!(matches!(
            Tessellation::new(0.1).unwrap().largest_aspect(wrong),
            Err(MeshError::Aspect { .. })
        ));
    }
}

/// Surfaces whose edges lie on each other: nothing of them is lost.
#[test]
fn folded_surfaces_stay_whole() {
    let linear = Linear::new();
    let fold = TensorSurface::new(
        linear,
        linear,
        [[[1.0, 2.0, 1.0], [2.0, 2.0, 1.0]], [[2.0, 2.0, 1.0], [1.0, 0.0, 1.0]]],
    );
    for tolerance in [0.1, 0.05, 0.01] {
        let mesh = lonely(&fold, tolerance);
        assert!(deviation(&mesh, &[&fold]) <= tolerance, "{tolerance}");
    }
    let needle = Bezier::from_points([[0.392, 0.0], [0.995, 0.0062], [-0.039, 0.0]]);
    let needle = SurfaceOfRevolution::about_x(&needle, 1.0).unwrap();
    for tolerance in [0.03, 0.003, 1e-4] {
        let mesh = lonely(&needle, tolerance);
        assert!(deviation(&mesh, &[&needle]) <= tolerance, "{tolerance}");
    }
    let random = &mut Random::new(85);
    for _ in 0..10 {
        // Few different points, so that edges, corners and diagonals fall on each other.
        let points: Vec<[f64; 3]> = (0..3).map(|_| [(); 3].map(|()| random.between(-1.0, 1.0))).collect();
        let mut pick = || points[f64::floor(random.between(0.0, 2.999)) as usize];
        let surface = TensorSurface::new(linear, linear, [[pick(), pick()], [pick(), pick()]]);
        match Tessellation::new(0.05).unwrap().with(&surface).mesh() {
            Ok(mesh) => assert!(deviation(&mesh, &[&surface]) <= 0.05, "{surface:?}"),
            Err(error) => assert!(matches!(error, MeshError::Collapsed { surface: 0 }), "{error}"),
        }
    }
}

/// Indices that do not exist are an error where a file is written; triangles with them have no area.
#[test]
fn broken_meshes_are_refused() {
    let vertex = |position| Vertex { position, normal: [0.0; 3], uv: [0.0; 2], surface: 3 };
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].to_vec();
    let whole = Mesh { positions, vertices: [0, 1, 2].map(vertex).to_vec(), triangles: [[0, 1, 2]].to_vec() };
    assert_eq!((whole.check(), whole.area()), (Ok(()), 0.5));
    let mut vertices = whole.clone();
    vertices.vertices[2] = vertex(7);
    let mut triangles = whole.clone();
    triangles.triangles.push([0, 1, u32::MAX]);
    for (mesh, error, area) in [
        (vertices, MeshError::Index { vertex: Some(2), triangle: None }, 0.0),
        (triangles, MeshError::Index { vertex: None, triangle: Some(1) }, 0.5),
    ] {
        assert_eq!((mesh.check(), mesh.area()), (Err(error), area));
        let _ = (mesh.volume(), mesh.boundary(), mesh.is_closed(), mesh.is_oriented());
        #[cfg(feature = "obj")]
        assert_eq!(mesh.write_obj(Vec::new()).unwrap_err().to_string(), error.to_string());
        #[cfg(feature = "stl")]
        assert!(mesh.write_stl(std::io::Cursor::new(Vec::new())).is_err());
        #[cfg(feature = "gltf")]
        assert!(mesh.write_gltf(Vec::new()).is_err());
    }
}

/// A volume is a sum of which little is left far from the origin, unless it is measured from near by; and its sign
/// turns closed meshes over.
#[test]
fn far_from_the_origin() {
    let near = egg_at(0.0_f64).volume();
    for x in [1e6, 1e9, 1e11] {
        let mesh = egg_at(x);
        assert!(mesh.is_closed() && (mesh.volume() - near).abs() < 1e-3, "{x}: {} {near}", mesh.volume());
    }
    for x in [1e2, 1e3, 3e3_f32] {
        let mesh = egg_at(x);
        assert!(mesh.is_closed() && (mesh.volume() - near as f32).abs() < 0.02, "{x}: {}", mesh.volume());
    }
}

fn egg_at<S: Scalar>(x: S) -> Mesh<S> {
    let [a, b] = [x - S::ONE, x + S::ONE];
    let side = x + S::of(1.25);
    let arc = Bezier::from_points([[a, x, x], [a, side, x], [b, side, x], [b, x, x]]);
    let axis = [S::ONE, S::ZERO, S::ZERO];
    let egg = SurfaceOfRevolution::new(&arc, [x; 3], axis, S::of(2.0) * S::PI).unwrap();
    Tessellation::new(S::of(0.01)).unwrap().with(&egg).mesh().unwrap()
}

/// Each sheet would be joined to the next one, and the first to the last.
#[test]
fn of_any_size() {
    let mesh = |scale: f64| {
        let points = [[-1.0, 0.0], [-1.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|p| p.map(|x| x * scale));
        let arc = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
        let egg = SurfaceOfRevolution::about_x(&arc, FULL).unwrap();
        let mut net = [[[0.0; 3]; 3]; 4];
        for (i, row) in net.iter_mut().enumerate() {
            for (j, p) in row.iter_mut().enumerate() {
                *p = [i as f64, 2.0 * j as f64, (i * i * j) as f64 / 3.0].map(|x| (x + 5.0) * scale);
            }
        }
        let sheet = TensorSurface::new(BernsteinBasis::<f64, 4>::new(), BernsteinBasis::<f64, 3>::new(), net);
        let mesh = Tessellation::new(0.02 * scale).unwrap().with(&egg).with(&sheet).mesh();
        let mesh = mesh.unwrap_or_else(|e| panic!("{scale:e}: {e}"));
        mesh.check().unwrap();
        mesh
    };
    let ordinary = mesh(1.0);
    // Squares, or fourth powers, of lengths overflow or vanish.
    for exponent in [-1000, -600, -300, 300, 600, 1000] {
        let scale = 2.0_f64.powi(exponent);
        let mut scaled = mesh(scale);
        let counts = |mesh: &Mesh<f64>| (mesh.triangles.len(), mesh.positions.len(), mesh.boundary().len());
        assert_eq!(counts(&scaled), counts(&ordinary), "2^{exponent}");
        for p in &mut scaled.positions {
            *p = p.map(|x| x / scale);
        }
        assert!(normals_agree(&scaled), "2^{exponent}");
        let volumes = [&scaled, &ordinary].map(Mesh::volume);
        assert!((volumes[0] - volumes[1]).abs() < 0.01, "2^{exponent}: {volumes:?}");
    }
}

/// A control point so far away that squares of its coordinates overflow: seen from there the rest is one point.
#[test]
fn with_a_control_point_far_away() {
    for far in [1e100, 1e200, -f64::MAX] {
        let mut net = [[[1.5, 2.5, -1.0]; 3]; 4];
        net[0][0] = [0.0; 3];
        net[0][2] = [1.0, 3.0, 4.0];
        net[3][0][1] = far;
        let surface =
            TensorSurface::new(BernsteinBasis::<f64, 4>::new(), BernsteinBasis::<f64, 3>::new(), net);
        // 140 seconds, when the squares were infinite.
        let mesh = Tessellation::new(0.01 * far.abs()).unwrap().with(&surface).mesh();
        assert!(matches!(mesh, Err(MeshError::Collapsed { surface: 0 })), "{far:e}: {mesh:?}");
    }
}

#[test]
fn piles_are_not_drawn_together() {
    let tolerance = 0.1;
    let step = tolerance / 20.0;
    let linear = Linear::new();
    let pile: Vec<_> = (0..30)
        .map(|k| {
            let z = step * f64::from(k);
            TensorSurface::new(
                linear,
                linear,
                [[[0.0, 0.0, z], [0.0, 1.0, z]], [[1.0, 0.0, z], [1.0, 1.0, z]]],
            )
        })
        .collect();
    let strips: Vec<_> = (0..30)
        .map(|k| {
            let [y, w] = [k, k + 1].map(|k| step * f64::from(k));
            TensorSurface::new(
                linear,
                linear,
                [[[0.0, y, 0.0], [0.0, w, 0.0]], [[1.0, y, 0.0], [1.0, w, 0.0]]],
            )
        })
        .collect();
    for surfaces in [&pile, &strips] {
        let tessellation = surfaces.iter().fold(Tessellation::new(tolerance).unwrap(), Tessellation::with);
        let mesh = tessellation.mesh().unwrap();
        assert!(!mesh.triangles.is_empty());
        assert!(deviation(&mesh, &surfaces.iter().collect::<Vec<_>>()) <= tolerance);
    }
}
