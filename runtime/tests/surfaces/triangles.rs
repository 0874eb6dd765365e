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
