//! Triangular patches as tensor surfaces.

use basis_runtime::{
    Edge, EdgePair, JoinError, Orientation, Surface, SurfaceDomain, Tessellation, TriangleContact,
    TriangleEdge, TriangleIndex, TriangularBernsteinBasis, TriangularBezier, TriangularBezierOf,
    TriangularPatch, basis,
};

use crate::random::Random;

basis!(
    "../../../../specs/triangular.basis",
    TriangularI(2),
    TriangularII(4),
    TriangularII(3) as TriangularCubic
);

fn near(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < tolerance)
}

#[test]
fn are_the_same_surface() {
    let random = &mut Random::new(95);
    for _ in 0..20 {
        let basis = TriangularI::new(random.between(0.1, 4.0), random.between(0.0, 5.0)).unwrap();
        let points = core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let patch: TriangularPatch<_, [f64; 3]> = TriangularPatch::new(basis, points);
        let surface = patch.to_tensor_surface();
        let (x, y): (f64, f64) = (random.between(0.0, 0.99), random.between(0.0, 1.0));
        let (u, v) = SurfaceDomain::Triangle.at(x, y);
        assert!(near(surface.eval(x, y), patch.eval(u, v), 4e-15));
        assert!(near(surface.normal(x, y).unwrap(), patch.normal(u, v).unwrap(), 1e-10));
        // At the corner that has become an edge.
        assert!(near(surface.eval(1.0, y), patch.eval(1.0, 0.0), 4e-15));
        assert!(near(surface.normal(1.0, y).unwrap(), patch.normal(1.0, 0.0).unwrap(), 1e-10));
    }
}

/// Eight patches over the faces of an octahedron, each with its corners in another order: closed and outwards.
#[test]
fn mesh_together() {
    let basis = TriangularII::new(2.0, 1.5).unwrap();
    let corners = |k: usize| {
        let sign = |bit: usize| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let mut corners = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        corners.rotate_left(k % 3);
        corners
    };
    let patches: Vec<_> = (0..8)
        .map(|k| {
            let points = core::array::from_fn(|position| {
                let index = TriangleIndex::at(4, position).unwrap().components();
                let mut point = [0.0; 3];
                for (count, corner) in index.into_iter().zip(corners(k)) {
                    for (sum, c) in point.iter_mut().zip(corner) {
                        *sum += 0.25 * count as f64 * c;
                    }
                }
                let length: f64 = point.iter().map(|c| c * c).sum::<f64>().sqrt();
                point.map(|c| c / length)
            });
            TriangularPatch::new(basis, points)
        })
        .collect();
    let mut tessellation = Tessellation::new(0.003).unwrap();
    for patch in &patches {
        tessellation = tessellation.with(patch);
    }
    let mesh = tessellation.mesh().unwrap();
    assert!(mesh.is_closed());
    assert!(mesh.volume() > 2.5 && mesh.volume() < 4.2, "{}", mesh.volume());
    assert_eq!(2 * (mesh.positions.len() + mesh.triangles.len()), 3 * mesh.triangles.len() + 4);
}

/// The curvatures are those of the tensor surface, and a part is the patch over a smaller triangle.
#[test]
fn have_curvatures_and_parts() {
    let random = &mut Random::new(97);
    for _ in 0..20 {
        let basis = TriangularII::new(random.between(0.1, 3.0), random.between(0.0, 2.0)).unwrap();
        let points = core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let patch: TriangularPatch<_, [f64; 3]> = TriangularPatch::new(basis, points);
        let (u, v): (f64, f64) = (random.between(0.1, 0.4), random.between(0.1, 0.4));
        let (ours, theirs) =
            (patch.curvature(u, v).unwrap(), patch.to_tensor_surface().curvature(u, v / (1.0 - u)).unwrap());
        assert!((ours.gaussian() - theirs.gaussian()).abs() < 1e-9 * ours.gaussian().abs().max(1.0));
        assert!((ours.mean() - theirs.mean()).abs() < 1e-9 * ours.mean().abs().max(1.0));

        let mut corner = || {
            let [a, b]: [f64; 2] = [random.between(-0.2, 1.0), random.between(-0.2, 1.0)];
            [a, b, 1.0 - a - b]
        };
        let corners = [corner(), corner(), corner()];
        let part = patch.part(corners);
        let at = [0.2, 0.5, 0.3];
        let there = core::array::from_fn(|c| (0..3).map(|k| at[k] * corners[k][c]).sum());
        assert!(near(part.eval_at(at), patch.eval_at(there), 1e-12));
    }
}

fn random_patch(random: &mut Random) -> TriangularPatch<TriangularII, [f64; 3]> {
    let basis = TriangularII::new(random.between(0.1, 3.0), random.between(0.0, 2.0)).unwrap();
    let points = core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
    TriangularPatch::new(basis, points)
}

/// `[u, v, w]` inside of the triangle.
fn inside(random: &mut Random) -> [f64; 3] {
    let [s, r]: [f64; 2] = [random.between(0.0, 1.0), random.between(0.0, 1.0)];
    [1.0 - s, s * (1.0 - r), s * r]
}

#[test]
fn are_elevated_and_split() {
    let random = &mut Random::new(98);
    for _ in 0..20 {
        let patch = random_patch(random);
        let bezier: TriangularBezierOf<TriangularII, [f64; 3]> = patch.to_bezier();
        let elevated: TriangularBezier<[f64; 3], 8, 36> = patch.elevate();
        let at = inside(random);
        assert!(near(bezier.eval_at(at), patch.eval_at(at), 1e-14));
        assert!(near(elevated.eval_at(at), patch.eval_at(at), 1e-14));
        assert_eq!(patch.elevate::<5, 15>(), bezier);
        // The corners are exact.
        for corner in [[7, 0, 0], [0, 7, 0], [0, 0, 7]] {
            let lower = TriangleIndex::new(corner.map(|count| count / 7 * 4));
            assert_eq!(elevated.control_point(TriangleIndex::new(corner)), bezier.control_point(lower));
        }
        for (edge, [start, end]) in TriangleEdge::ALL.into_iter().zip([[2, 1], [2, 0], [1, 0]]) {
            let t = random.between(0.0, 1.0);
            let [first, second] = patch.split_edge(edge, t);
            let moved = edge.point(t);
            for (part, place) in [(first, end), (second, start)] {
                // The corner at that place has moved.
                let there = core::array::from_fn(|c| {
                    let own = if c == place { 0.0 } else { at[c] };
                    own + at[place] * moved[c]
                });
                assert!(near(part.eval_at(at), patch.eval_at(there), 1e-13));
            }
            // The points of the common line: those without the corner that has not moved.
            for (a, b) in [(0, 4), (1, 3), (3, 1), (4, 0)] {
                let index = |place: usize| {
                    let mut components = [0; 3];
                    components[place] = a;
                    components[3 - start - end] = b;
                    TriangleIndex::new(components)
                };
                assert_eq!(first.control_point(index(end)), second.control_point(index(start)));
            }
        }
    }
}

#[test]
fn have_nearest_points() {
    let random = &mut Random::new(99);
    for _ in 0..20 {
        let patch = random_patch(random);
        let target: [f64; 3] = core::array::from_fn(|_| random.between(-2.0, 2.0));
        let away = |p: [f64; 3]| p.iter().zip(target).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let found = patch.nearest(target, 1e-6).unwrap();
        let [u, v] = found.at;
        assert!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 + 1e-15);
        assert!(near(patch.eval(u, v), found.point, 1e-13));
        assert!((away(found.point) - found.distance).abs() < 1e-14);
        assert!(found.at_least >= found.distance - 1e-6 && found.at_least <= found.distance);
        for _ in 0..2000 {
            assert!(away(patch.eval_at(inside(random))) >= found.at_least);
        }
    }
}

/// G1 across every edge to every other one in both directions, to families with other shape values and of a higher
/// degree.
#[test]
fn are_continued() {
    let random = &mut Random::new(100);
    for round in 0..18 {
        let first = random_patch(random);
        let (place, other) = (round % 3, round / 3 % 3);
        let [edge, next_edge] = [place, other].map(|k| Edge::from(TriangleEdge::ALL[k]));
        let orientation = if round < 9 { Orientation::Same } else { Orientation::Opposite };
        let pair = EdgePair { first: edge, second: next_edge, orientation };
        let mut apex = [random.between(0.2, 1.2); 3];
        apex[place] = -random.between::<f64>(0.3, 1.5);
        apex[(place + 1) % 3] = 1.0 - apex[place] - apex[(place + 2) % 3];
        let points = core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let family = TriangularII::new(random.between(0.5, 3.0), random.between(0.5, 2.0)).unwrap();
        let second = first
            .continued(pair, TriangleContact::new(1, apex), &TriangularPatch::new(family, points))
            .unwrap();
        // Control points farther away are free.
        assert!(
            TriangleIndex::all(4)
                .filter(|index| index.components()[other] > 1)
                .all(|index| { second.control_point(index) == Some(points[index.position()]) })
        );
        assert_eq!(pair, EdgePair::nearest(&first, edge, &second, next_edge));
        let joint = first.joint(pair, &second, 33);
        assert!(joint.gap < 1e-11 && joint.angle < 1e-6, "{pair:?} {joint:?}");
        assert!(joint.curvature > 1e-3);

        let points = core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let basis = TriangularBernsteinBasis::<f64, 7, 28>::new();
        let smooth = first
            .continued(pair, TriangleContact::new(2, apex), &TriangularPatch::new(basis, points))
            .unwrap();
        let joint = first.joint(pair, &smooth, 33);
        assert_eq!(joint.geometric_order(1e-11, 1e-6, 1e-4), Some(2), "{joint:?}");
    }
}

/// The edge u = 0, and beyond it the edge w = 0 of the other patch.
const PAIR: EdgePair = EdgePair::against(Edge::UStart, Edge::VEnd);

#[test]
fn continuations_that_do_not_exist() {
    let first = random_patch(&mut Random::new(101));
    let family = TriangularII::new(2.0, 1.5).unwrap();
    let points = [[0.5; 3]; 15];
    let apex = [-1.0, 1.0, 1.0];
    let draft = TriangularPatch::new(family, points);
    let along = |apex, order| first.continued(PAIR, TriangleContact::new(order, apex), &draft).map(|_| ());
    assert_eq!(along(apex, 1), Ok(()));
    assert_eq!(along([0.5, 0.5, 0.0], 1), Err(JoinError::Apex { value: 0.5 }));
    assert!(matches!(along([f64::NAN, 0.5, 0.5], 1), Err(JoinError::Apex { .. })));
    for corner in [EdgePair::along(Edge::UEnd, Edge::VEnd), EdgePair::along(Edge::VEnd, Edge::UEnd)] {
        let found = first.continued(corner, TriangleContact::new(0, apex), &draft).map(|_| ());
        assert_eq!(found, Err(JoinError::Corner));
    }
    assert_eq!(along(apex, 5), Err(JoinError::Contact { most: 4, found: 5 }));
    // Four points on an edge of degree four are one too few.
    let quartic = TriangularI::new(2.0, 4.0).unwrap();
    let found = first
        .continued(PAIR, TriangleContact::new(0, apex), &TriangularPatch::new(quartic, [[0.5; 3]; 6]))
        .map(|_| ());
    assert_eq!(found, Err(JoinError::Unreachable));
    // At λ2 = 0 and λ1 = 3 the order 3 has no function for its inner point; at λ2 = 2 all are those of Bernstein.
    let cubic = TriangularBezier::<[f64; 3], 4, 10>::from_points(core::array::from_fn(|k| {
        let k = k as f64;
        [k.sin(), (2.0 * k).sin(), (3.0 * k).sin()]
    }));
    let with = |lambda2| {
        let basis = TriangularCubic::new(3.0, lambda2).unwrap();
        cubic.continued(PAIR, TriangleContact::new(1, apex), &TriangularPatch::new(basis, [[0.5; 3]; 10]))
    };
    assert_eq!(with(0.0).map(|_| ()), Err(JoinError::Unreachable));
    let bernstein = cubic.continued(
        PAIR,
        TriangleContact::new(1, apex),
        &TriangularBezier::<[f64; 3], 4, 10>::from_points([[0.5; 3]; 10]),
    );
    let (ours, theirs) = (with(2.0).unwrap(), bernstein.unwrap());
    assert!(ours.control_points().iter().zip(theirs.control_points()).all(|(&a, &b)| near(a, b, 1e-13)));
}
