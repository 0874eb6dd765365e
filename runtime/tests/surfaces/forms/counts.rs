//! How many triangles meshes have, beside the least number that a tolerance allows.

use basis_runtime::bspline::{BSplineCurve, BSplineSurface, KnotVector, Net, NurbsCurve, NurbsSurface};
use basis_runtime::{Bezier, SurfaceOfRevolution, Tessellation};

use super::meshes::{deviation, lonely};
use crate::families::{bicubic, graph};

const FULL: f64 = 2.0 * core::f64::consts::PI;

/// What a flat piece needs, and no more: around a circle the sides that a tolerance asks for, and nothing along straight
/// lines.
#[test]
fn no_more_triangles_than_are_needed() {
    let revolved = |from: [f64; 2], to: [f64; 2]| {
        SurfaceOfRevolution::about_x(&Bezier::from_points([from, to]), FULL).unwrap()
    };
    let (disk, cone, cylinder) = (
        revolved([0.0, 0.0], [0.0, 1.0]),
        revolved([0.0, 0.0], [1.0, 1.0]),
        revolved([0.0, 1.0], [1.0, 1.0]),
    );
    for (tolerance, sides) in [(1e-2, 23), (1e-3, 71), (1e-4, 223)] {
        let counts = [&disk, &cone, &cylinder].map(|surface| {
            let mesh = lonely(surface, tolerance);
            assert!(mesh.is_oriented());
            if tolerance > 2e-4 {
                assert!(deviation(&mesh, &[surface]) <= tolerance);
            }
            mesh.triangles.len()
        });
        let most = sides + sides / 3;
        assert!(counts[0] <= most && counts[1] <= most && counts[2] <= 2 * most, "{counts:?}");
    }
    // The parameters run unevenly, and not along the sides.
    let uneven = |k: usize| [0.0, 0.05, 0.9, 1.0][k];
    let square = bicubic(|i, j| [uneven(i), uneven(3 - j), 0.0]);
    assert_eq!(lonely(&square, 1e-9).triangles.len(), 2);
    let slanted = bicubic(|i, j| [uneven(i), if i % 3 == 0 { uneven(j) } else { j as f64 / 3.0 }, 0.0]);
    assert_eq!(lonely(&slanted, 1e-9).triangles.len(), 2);
}

/// In each direction in which a surface bends the number grows with the root of the tolerance.
#[test]
fn growth() {
    let bowl = graph(|u, v| u * u + v * v);
    let trough = graph(|u, _| u * u);
    let twisted = graph(|u, v| u * v);
    for (surface, power) in [(&bowl, 1.0), (&trough, 0.5), (&twisted, 1.0)] {
        let counts = [1e-1, 1e-3].map(|tolerance| lonely(surface, tolerance).triangles.len() as f64);
        let growth = counts[1] / counts[0];
        assert!(growth <= 1.3 * 100_f64.powf(power), "{counts:?}");
    }
}

/// Quarters of a circle around (x, 0) in the plane of x and z; the first one begins at the angle of `start` right angles.
fn arcs(x: f64, start: i32, quarters: i32) -> NurbsCurve<[f64; 3]> {
    let half = 0.5_f64.sqrt();
    let corner = |k: i32| {
        // The corners of a square and the middles of its sides; a quarter of a turn behind, a cosine is a sine.
        let cosine = |eighth: i32| {
            let around = [1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0];
            around[eighth.rem_euclid(8) as usize]
        };
        let eighth = 2 * start + k;
        [x + cosine(eighth), 0.0, cosine(eighth - 2)]
    };
    let ends: Vec<f64> = (1..quarters).flat_map(|k| [f64::from(k); 2]).collect();
    let knots = [vec![0.0], ends, vec![f64::from(quarters)]].concat();
    let weights = (0..=2 * quarters).map(|k| if k % 2 == 0 { 1.0 } else { half });
    let points: Vec<[f64; 3]> = (0..=2 * quarters).map(corner).collect();
    NurbsCurve::new(KnotVector::clamped(2, &knots).unwrap(), points, weights.collect::<Vec<_>>()).unwrap()
}

/// A sphere of radius 1 needs `4π / A` triangles if all are equilateral and as large as they can be with corners on the
/// sphere: of a height `ε` of the sphere above them their circumscribed circles have the radius `√(2ε)`, and their area
/// is `A = 3√3/4 · 2ε`.
#[test]
fn spheres_and_tori() {
    let revolved =
        |arc: NurbsCurve<[f64; 3]>| NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], FULL).unwrap();
    let (sphere, torus) = (revolved(arcs(0.0, -1, 2)), revolved(arcs(2.5, 0, 4)));
    for tolerance in [0.03, 0.01, 0.004, 0.001] {
        let mesh = lonely(&sphere, tolerance);
        assert!(mesh.is_closed());
        let least = 2.0 * FULL / (1.5 * 3.0_f64.sqrt() * tolerance);
        let count = mesh.triangles.len() as f64;
        assert!(count <= 2.0 * least, "{count}, {least} for {tolerance}");
        // Triangles around the torus, with half of the tolerance in each direction.
        let mesh = lonely(&torus, tolerance);
        assert!(mesh.is_closed());
        let sides = FULL / (2.0 * tolerance.sqrt());
        let count = mesh.triangles.len() as f64;
        assert!(count <= 1.15 * 2.0 * sides * sides * 3.5_f64.sqrt(), "{count} for {tolerance}");
    }
    assert!(deviation(&lonely(&sphere, 0.02), &[&sphere]) <= 0.02);
    assert!(deviation(&lonely(&torus, 0.05), &[&torus]) <= 0.05);
}

/// A crease is where the knot is, and the sides between creases are flat.
#[test]
fn creases_at_knots() {
    for spans in [2_u32, 3, 5, 7, 9] {
        let knots: Vec<f64> = (0..=spans).map(f64::from).collect();
        let points: Vec<[f64; 3]> = (0..=spans).map(|k| [f64::from(k), f64::from(k % 2), 0.0]).collect();
        let profile = BSplineCurve::new(KnotVector::clamped(1, &knots).unwrap(), points).unwrap();
        let folded = BSplineSurface::extruded(&profile, [0.0, 0.0, 1.0]).unwrap();
        let mesh = lonely(&folded, 1e-9);
        assert_eq!(mesh.triangles.len(), 2 * spans as usize);
    }
}

/// A surface whose parts need parts of different numbers has no cracks where they meet.
#[test]
fn more_where_more_is_needed() {
    let random = &mut crate::random::Random::new(85);
    for _ in 0..3 {
        let knots = || KnotVector::clamped(3, &[0.0, 0.4, 1.0, 1.3, 2.0]).unwrap();
        let rows = (0..7).map(|i| {
            let height = if i < 3 { 0.2 } else { 2.0 };
            let point = |j: i32| {
                let [aside, up]: [f64; 2] = [0.3, 1.0].map(|most| random.between(-most, most));
                [f64::from(i) + aside, f64::from(j), height * up]
            };
            (0..7).map(point).collect::<Vec<[f64; 3]>>()
        });
        let net = Net::from_rows(rows).unwrap();
        let surface = BSplineSurface::new(knots(), knots(), net).unwrap();
        let mesh = Tessellation::new(0.01).unwrap().with(&surface).mesh().unwrap();
        let edges = mesh.boundary().len();
        assert_eq!(2 * (mesh.positions.len() + mesh.triangles.len()), 3 * mesh.triangles.len() + edges + 2);
        assert!(deviation(&mesh, &[&surface]) <= 0.01);
    }
}
