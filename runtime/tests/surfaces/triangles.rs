//! Triangular patches as tensor surfaces.

use basis_runtime::{Surface, Tessellation, TriangleIndex, TriangularPatch, basis};

use crate::random::Random;

basis!("../../../specs/triangular.basis", TriangularI(2), TriangularII(4));

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
        let (s, r): (f64, f64) = (random.between(0.01, 1.0), random.between(0.0, 1.0));
        let (u, v) = (1.0 - s, s * (1.0 - r));
        assert!(near(surface.eval(s, r), patch.eval(u, v), 4e-15));
        assert!(near(surface.normal(s, r).unwrap(), patch.normal(u, v).unwrap(), 1e-10));
        // At the corner that has become an edge.
        assert!(near(surface.eval(0.0, r), patch.eval(1.0, 0.0), 4e-15));
        assert!(near(surface.normal(0.0, r).unwrap(), patch.normal(1.0, 0.0).unwrap(), 1e-10));
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
            TriangularPatch::new(basis, points).to_tensor_surface()
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
        let (ours, theirs) = (
            patch.curvature(u, v).unwrap(),
            patch.to_tensor_surface().curvature(1.0 - u, 1.0 - v / (1.0 - u)).unwrap(),
        );
        assert!((ours.gaussian() - theirs.gaussian()).abs() < 1e-9 * ours.gaussian().abs().max(1.0));
        assert!((ours.mean() - theirs.mean()).abs() < 1e-9 * ours.mean().abs().max(1.0));

        let mut corner = || {
            let [a, b]: [f64; 2] = [random.between(-0.2, 1.0), random.between(-0.2, 1.0)];
            [a, b, 1.0 - a - b]
        };
        let corners = [corner(), corner(), corner()];
        // With these shape values the family is that of Bernstein.
        let part = TriangularPatch::new(TriangularII::new(3.0, 2.0).unwrap(), patch.part(corners));
        let at = [0.2, 0.5, 0.3];
        let there = core::array::from_fn(|c| (0..3).map(|k| at[k] * corners[k][c]).sum());
        assert!(near(part.eval_barycentric(at), patch.eval_barycentric(there), 1e-12));
    }
}
