//! Isocurves, boundaries and parts are the same surface.

use basis_runtime::{
    BernsteinBasis, Bezier, CurveError, Direction, RationalSurface, Surface, SurfaceOfRevolution,
    TensorSurface,
};

use crate::families::{QuarticBernstein, UniformBSpline, graph, random_quartic, random_surface};
use crate::random::Random;

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 2e-15)
}

#[test]
fn isocurves() {
    let random = &mut Random::new(51);
    for _ in 0..50 {
        let surface = random_surface::<[f64; 3]>(random);
        let (u, v): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        assert!(near(surface.along_u(v).eval(u), surface.eval(u, v)));
        assert!(near(surface.along_v_bezier(u).eval(v), surface.eval(u, v)));
        // With five different shape values the curve in v is not one of the family.
        assert_eq!(surface.along_v(u), None);

        let gamma = random_quartic(random);
        let net = core::array::from_fn(|i| core::array::from_fn(|j| surface.control_point(i, j).unwrap()));
        let plain = TensorSurface::new(surface.u_basis(), gamma, net);
        assert!(near(plain.along_v(u).unwrap().eval(v), plain.eval(u, v)));
    }
}

/// The boundaries belong to the outer rows: along v with the shape value of the row, along u with λ.
#[test]
fn boundaries_are_those_of_the_outer_rows() {
    let random = &mut Random::new(52);
    let surface = random_surface::<[f64; 3]>(random);
    let [start, end] = surface.boundary_along_v().map(Option::unwrap);
    assert_eq!(start, surface.rows()[0]);
    assert_eq!(end, surface.rows()[3]);
    let [start, end] = surface.boundary_along_u();
    assert_eq!((start.basis(), end.basis()), (surface.u_basis(), surface.u_basis()));
    for i in 0..4 {
        assert_eq!(start.control_points()[i], surface.control_point(i, 0).unwrap());
        assert_eq!(end.control_points()[i], surface.control_point(i, 3).unwrap());
    }
}

/// A family that does not interpolate its end points.
#[test]
fn boundaries_of_a_bspline() {
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]));
    let surface = TensorSurface::new(UniformBSpline::new(), UniformBSpline::new(), net);
    let boundary = surface.boundary_along_v()[1].unwrap();
    assert!(near(boundary.eval(0.25), surface.eval(1.0, 0.25)));
}

#[test]
fn parts() {
    let random = &mut Random::new(53);
    for _ in 0..20 {
        let surface = random_surface::<[f64; 3]>(random);
        let (u, v): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let (s, t): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let [before, after] = surface.split(Direction::U, u).unwrap();
        assert!(near(before.eval(s, t), surface.eval(u * s, t)));
        assert!(near(after.eval(s, t), surface.eval(u + (1.0 - u) * s, t)));
        assert_eq!(before.boundary_along_v()[1], after.boundary_along_v()[0]);
        let [before, after] = surface.split(Direction::V, v).unwrap();
        assert!(near(before.eval(s, t), surface.eval(s, v * t)));
        assert!(near(after.eval(s, t), surface.eval(s, v + (1.0 - v) * t)));
        assert_eq!(before.boundary_along_u()[1], after.boundary_along_u()[0]);
        let part = surface.subpatch(0.75..0.25, 0.0..v).unwrap();
        assert!(near(part.eval(s, t), surface.eval(0.75 - 0.5 * s, v * t)));
        assert_eq!(surface.subpatch(0.0..1.0, 0.0..1.0).unwrap(), surface.to_bezier());
    }
}

#[test]
fn parts_on_another_domain() {
    let surface = graph(|u, v| u * u * v);
    let part = surface.subpatch(-0.5..0.5, 0.0..1.0).unwrap();
    assert!(near(part.eval(0.75, 0.5), surface.eval(0.25, 0.5)));
    let [before, _] = surface.split(Direction::U, 0.0).unwrap();
    assert!(near(before.eval(0.5, 0.5), surface.eval(-0.5, 0.0)));
}

#[test]
fn parameters_that_no_part_has() {
    let surface = graph(|u, v| u * u * v);
    let domain = [-1.0, 1.0];
    assert_eq!(surface.split(Direction::U, 1.5), Err(CurveError::Parameter { value: 1.5, domain }));
    assert_eq!(surface.split(Direction::V, -1.0), Err(CurveError::AtEnd { parameter: -1.0 }));
    assert!(matches!(surface.split(Direction::V, f64::NAN), Err(CurveError::Parameter { .. })));
    assert_eq!(surface.subpatch(0.0..2.0, 0.0..1.0), Err(CurveError::Parameter { value: 2.0, domain }));
    assert_eq!(surface.subpatch(0.0..1.0, 0.5..0.5), Err(CurveError::EmptyRange { at: 0.5 }));
}

#[test]
fn parts_that_run_backwards() {
    let surface = graph(|u, v| u * u * v + v);
    for (s, t) in [(0.25, 0.75), (0.0, 1.0), (0.5, 0.125)] {
        let along = |x: f64| 2.0 * x - 1.0;
        assert!(near(surface.reversed(Direction::U).eval(s, t), surface.eval(-along(s), along(t))));
        assert!(near(surface.reversed(Direction::V).eval(s, t), surface.eval(along(s), -along(t))));
    }
}

#[test]
fn parts_of_surfaces_of_revolution() {
    let random = &mut Random::new(58);
    let profile = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [2.0, 0.5], [3.0, 1.0]]);
    let vase = SurfaceOfRevolution::about_x(&profile, 5.0).unwrap();
    let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14);
    for _ in 0..20 {
        let (u, v): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 5.0));
        let (s, t): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let [before, after] = vase.split(Direction::U, u).unwrap();
        assert!(close(before.eval(s, 5.0 * t), vase.eval(u * s, 5.0 * t)));
        assert!(close(after.eval(s, 5.0 * t), vase.eval(u + (1.0 - u) * s, 5.0 * t)));
        let [before, after] = vase.split(Direction::V, v).unwrap();
        assert_eq!((before.angle(), after.angle()), (v, 5.0 - v));
        assert!(close(before.eval(s, v * t), vase.eval(s, v * t)));
        assert!(close(after.eval(s, (5.0 - v) * t), vase.eval(s, v + (5.0 - v) * t)));
        assert!(close(after.generatrix().eval(s), vase.eval(s, v)));
        let part = vase.subpatch(0.75..0.25, 4.0..1.0).unwrap();
        assert!(close(part.eval(s, 3.0 * t), vase.eval(0.75 - 0.5 * s, 4.0 - 3.0 * t)));
        assert!(close(vase.reversed(Direction::U).eval(s, v), vase.eval(1.0 - s, v)));
        assert!(close(vase.reversed(Direction::V).eval(s, v), vase.eval(s, 5.0 - v)));
        let [a, b] = [part.normal(s, 3.0 * t).unwrap(), vase.normal(0.75 - 0.5 * s, 4.0 - 3.0 * t).unwrap()];
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12)); // turned twice
    }
    assert_eq!(vase.split(Direction::V, 5.0), Err(CurveError::AtEnd { parameter: 5.0 }));
}

/// The Bézier form of one family is that of the paper's cubic at λ = 0.
#[test]
fn bezier_form() {
    let zero = QuarticBernstein::new(0.0).unwrap();
    let net: [[[f64; 1]; 4]; 4] =
        core::array::from_fn(|i| core::array::from_fn(|j| [if (i, j) == (1, 1) { 16.0 } else { 0.0 }]));
    let bezier = TensorSurface::new(zero, zero, net).to_bezier();
    // Degree elevation of a cubic: 3/4 and 1/2 of the inner point.
    assert_eq!(bezier.control_point(1, 1), Some([9.0]));
    assert_eq!(bezier.control_point(1, 2), Some([6.0]));
    assert_eq!(bezier.control_point(2, 2), Some([4.0]));
    assert_eq!(bezier.control_point(3, 3), Some([0.0]));
}

/// A quarter of a circle swept along a line, with its weights; both parts are the surface, and share their edge bit for
/// bit.
#[test]
fn parts_of_rational_surfaces() {
    let half = 0.5_f64.sqrt();
    let arc = |x: f64| [[x, 1.0, 0.0], [x, 1.0, 1.0], [x, 0.0, 1.0]];
    let cylinder = RationalSurface::new(
        BernsteinBasis::<_, 2>::new(),
        BernsteinBasis::<_, 3>::new(),
        [arc(0.0), arc(2.0)],
        [[1.0, half, 1.0], [2.0, half, 0.5]],
    );
    assert_eq!(cylinder.to_bezier(), cylinder);
    let [before, after] = cylinder.split(Direction::U, 0.3).unwrap();
    let [low, high] = cylinder.split(Direction::V, 0.6).unwrap();
    for i in 0..=10 {
        let x = f64::from(i) / 10.0;
        assert_eq!(before.eval(1.0, x), after.eval(0.0, x));
        assert_eq!(low.eval(x, 1.0), high.eval(x, 0.0));
        assert!(near(before.eval(x, 0.7), cylinder.eval(0.3 * x, 0.7)));
        assert!(near(after.eval(x, 0.7), cylinder.eval(0.3 + 0.7 * x, 0.7)));
        assert!(near(low.eval(0.2, x), cylinder.eval(0.2, 0.6 * x)));
        assert!(near(high.eval(0.2, x), cylinder.eval(0.2, 0.6 + 0.4 * x)));
    }
}
