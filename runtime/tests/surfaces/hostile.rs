//! No input makes a surface panic or run without end.

use basis_runtime::{
    Curve, Edge, Surface, SurfaceOfRevolution, TensorSurface, Tessellation, edge_continuity,
};

use crate::families::{QuarticBernstein, random_quartic};
use crate::random::Random;

/// Components that coincide, vanish, overflow and are no numbers.
const COMPONENTS: [f64; 12] =
    [0.0, 0.0, 1.0, 1.0, -1.0, 0.5, 1e-300, 1e300, -1e300, f64::MIN_POSITIVE, f64::INFINITY, f64::NAN];

#[test]
fn nets_of_extreme_numbers() {
    let random = &mut Random::new(101);
    for round in 0..96 {
        // Most nets are finite, and many of moderate size.
        let kinds = [6.0, 8.0, 10.0, 12.0][round % 4];
        let mut component = || COMPONENTS[random.between::<f64>(0.0, kinds) as usize % COMPONENTS.len()];
        let net = core::array::from_fn(|_| core::array::from_fn(|_| core::array::from_fn(|_| component())));
        let shape = |value| QuarticBernstein::new(value).unwrap();
        let lambda = [-3.0, 1.0, 0.0, -1.0][round / 4 % 4];
        let surface: TensorSurface<_, _, [f64; 3]> =
            TensorSurface::with_rows(shape(lambda), [-3.0, 1.0, 0.0, 0.5].map(shape), net);
        for (u, v) in [(0.0, 0.0), (0.5, 0.25), (1.0, 1.0), (0.0, 0.7), (f64::NAN, 0.5), (1e300, -1e300)] {
            if let Some(normal) = surface.normal(u, v) {
                let square: f64 = normal.iter().map(|c| c * c).sum();
                assert!((square - 1.0).abs() < 1e-9, "{net:?} at {u}, {v}: {normal:?}");
            }
            surface.curvature(u, v);
        }
        surface.bounding_box();
        for edge in Edge::ALL {
            edge_continuity(&surface, edge, &surface, Edge::UStart, round % 2 == 0, 5);
        }
        let _ = surface.join_uu(&surface, round % 5, 1.0);
        let _ = surface.join_vv(&surface, round % 5, 1e300);
        if let Ok(mesh) = Tessellation::new(0.05).unwrap().with(&surface).with(&surface).mesh() {
            assert!(mesh.positions.iter().flatten().all(|c| c.is_finite()));
        }
    }
}

#[test]
fn generatrices_of_extreme_numbers() {
    let random = &mut Random::new(102);
    for round in 0..60 {
        let kinds = [6.0, 8.0, 10.0, 12.0][round % 4];
        let points = core::array::from_fn(|_| {
            core::array::from_fn(|_| {
                COMPONENTS[random.between::<f64>(0.0, kinds) as usize % COMPONENTS.len()]
            })
        });
        let curve: Curve<QuarticBernstein, [f64; 3]> = Curve::new(random_quartic(random), points);
        let Ok(surface) = SurfaceOfRevolution::new(&curve, [0.0; 3], points[0], 4.0) else { continue };
        surface.normal(0.0, 0.0);
        for patch in surface.to_rational_patches().into_iter().chain(surface.half_turns()) {
            patch.normal(0.0, 1.0);
            patch.curvature(0.5, 0.5);
            let _ = Tessellation::new(0.05).unwrap().with(&patch).mesh();
        }
        let _ = Tessellation::new(0.05).unwrap().with(&surface).mesh();
    }
}
