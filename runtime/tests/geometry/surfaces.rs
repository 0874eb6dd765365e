//! Surfaces of every type answer boxes, nearest points and partial derivatives, and are meshed.

use core::f64::consts::PI;

use basis_runtime::bspline::{BSplineSurface, KnotVector, Net, NurbsSurface};
use basis_runtime::{Bezier, BoundedSurface, CurveError, SurfaceOfRevolution, SurfacePiece, Tessellation};

use crate::queries::{distance, nurbs};
use crate::random::Random;

type P3 = [f64; 3];

fn spline(random: &mut Random) -> BSplineSurface<P3> {
    let (u, v) =
        (KnotVector::uniform(2, 3).unwrap(), KnotVector::clamped(3, &[-1.0, 0.5, 0.5, 2.0]).unwrap());
    let net = Net::from_fn(u.functions(), v.functions(), |i, j| {
        let [x, y, z]: P3 = [random.between(0.0, 0.5), random.between(0.0, 0.5), random.between(-1.0, 1.0)];
        [i as f64 + x, j as f64 + y, z]
    });
    BSplineSurface::new(u, v, net.unwrap()).unwrap()
}

fn against_samples(surface: &dyn BoundedSurface<Point = P3>, random: &mut Random) {
    const COUNT: usize = 121;
    let [[u0, u1], [v0, v1]] = surface.domain();
    let at = |n: usize| {
        let [x, y] = [n / COUNT, n % COUNT].map(|k| k as f64 / (COUNT - 1) as f64);
        (u0 * (1.0 - x) + u1 * x, v0 * (1.0 - y) + v1 * y)
    };
    let points: Vec<P3> = (0..COUNT * COUNT).map(at).map(|(u, v)| surface.eval(u, v)).collect();
    let ([low, high], [far_low, far_high]) = (surface.bounding_box(), surface.control_box());
    for d in 0..3 {
        let least = points.iter().map(|p| p[d]).fold(f64::MAX, f64::min);
        let largest = points.iter().map(|p| p[d]).fold(f64::MIN, f64::max);
        assert!(low[d] <= least + 1e-13 && low[d] > least - 2e-2, "{low:?} {least}");
        assert!(high[d] >= largest - 1e-13 && high[d] < largest + 2e-2, "{high:?} {largest}");
        assert!(far_low[d] <= low[d] + 1e-12 && far_high[d] >= high[d] - 1e-12);
    }
    for _ in 0..4 {
        let target = [(); 3].map(|()| random.between(-1.0, 4.0));
        let found = surface.nearest(target, 1e-7).unwrap();
        let sampled = points.iter().map(|&p| distance(p, target)).fold(f64::MAX, f64::min);
        assert!(found.distance <= sampled + 1e-7 && found.at_least <= sampled, "{found:?} {sampled}");
        assert!(found.distance - found.at_least <= 1.01e-7, "{found:?}");
        let [u, v] = found.at;
        assert!(distance(surface.eval(u, v), found.point) < 1e-13);
    }
    assert_eq!(surface.nearest([f64::NAN; 3], 1e-6), None);
    // Partial derivatives one by one, and all at once.
    let (u, v) = at(4_321);
    let mut partials = [[0.0; 3]; 16];
    surface.partials_into(u, v, 4, &mut partials);
    for (n, &partial) in partials.iter().enumerate() {
        let [i, j] = [n / 4, n % 4];
        assert!(
            distance(surface.partial(u, v, [i, j]), partial) < 1e-9 * (1.0 + distance(partial, [0.0; 3]))
        );
        if i > 0 && i + j <= 3 {
            let h = 1e-5 * (u1 - u0);
            let [a, b] = [u - h, u + h].map(|u| surface.partial(u, v, [i - 1, j]));
            let difference = [0, 1, 2].map(|d| (b[d] - a[d]) / (2.0 * h));
            let size = 1.0 + distance(partial, [0.0; 3]);
            assert!(distance(difference, partial) < 1e-3 * size, "{i} {j}: {difference:?} {partial:?}");
        }
    }
    assert!(surface.partial(u, v, [0, 9]).iter().all(|c| c.is_finite()));
}

#[test]
fn of_every_type() {
    let random = &mut Random::new(1801);
    let polynomial = spline(random);
    let rational = NurbsSurface::revolved(&nurbs(random), [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let patches = vase.to_rational_patches();
    let surfaces: [&dyn BoundedSurface<Point = P3>; 4] = [&polynomial, &rational, &vase, &patches[1]];
    for surface in surfaces {
        against_samples(surface, random);
    }
}

/// A torus: the distance from any point is known.
#[test]
fn of_a_torus() {
    let half = 0.5_f64.sqrt();
    let points = [[3.0, 0.0, 0.0], [3.0, 0.0, 1.0], [2.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0]).unwrap();
    let arc = basis_runtime::bspline::NurbsCurve::new(knots, points, [1.0, half, 1.0, half, 1.0]).unwrap();
    let upper = NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).unwrap();
    let random = &mut Random::new(1802);
    for _ in 0..10 {
        let [x, y, z]: P3 = [random.between(-4.0, 4.0), random.between(-4.0, 4.0), random.between(0.1, 3.0)];
        let found = upper.nearest([x, y, z], 1e-9).unwrap();
        let exact = ((x.hypot(y) - 2.0).hypot(z) - 1.0).abs();
        assert!(
            (found.distance - exact).abs() < 1e-9 && found.at_least <= exact + 1e-12,
            "{found:?} {exact}"
        );
    }
    let [low, high] = upper.bounding_box();
    assert!(distance(low, [-3.0, -3.0, 0.0]) < 1e-2 && distance(high, [3.0, 3.0, 1.0]) < 1e-2);
    let mesh = Tessellation::new(0.05).unwrap().with(&upper).mesh().unwrap();
    let area = 2.0 * PI * PI * 2.0;
    assert!((mesh.area() - area).abs() < 0.05 * area && mesh.is_oriented(), "{} {area}", mesh.area());
}

#[test]
fn pieces_of_a_type_of_ones_own() {
    let square = [[0.0, 0.0], [1.0, 1.0]];
    let points = [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let piece = SurfacePiece::polynomial([[0.0, 1.0]; 2], 2, &points).unwrap();
    assert_eq!((piece.degrees(), piece.domain()), ([1, 1], [[0.0, 1.0]; 2]));
    assert!(matches!(SurfacePiece::polynomial(square, 3, &points), Err(CurveError::Length { .. })));
    assert!(matches!(SurfacePiece::polynomial(square, 0, &points), Err(CurveError::Length { .. })));
    assert!(matches!(SurfacePiece::rational(square, 2, &points, &[1.0; 3]), Err(CurveError::Length { .. })));
    let bad = SurfacePiece::rational(square, 2, &points, &[1.0, 1.0, 0.0, 1.0]);
    assert!(matches!(bad, Err(CurveError::Weight { index: 2, .. })));
}
