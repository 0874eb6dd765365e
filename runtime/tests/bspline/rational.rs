//! Rational curves and surfaces: circles, derivatives, surfaces of revolution.

use core::f64::consts::{PI, SQRT_2};

use basis_runtime::bspline::{
    BSplineCurve, Direction, Homogeneous, KnotVector, Net, NurbsCurve, NurbsSurface, SplineError,
};
use basis_runtime::{BernsteinBasis, Curve, Edge, ParametricCurve, Surface, SurfaceOfRevolution};
use proptest::prelude::*;

use crate::support::{P3, curve, distance};

/// The unit circle as four rational quadratic arcs.
fn circle() -> NurbsCurve<P3> {
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]).unwrap();
    let square = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let points = square.map(|(x, y)| [f64::from(x), f64::from(y), 0.0]);
    let weights: Vec<f64> = (0..9).map(|i| if i % 2 == 0 { 1.0 } else { SQRT_2 / 2.0 }).collect();
    NurbsCurve::new(knots, points, weights).unwrap()
}

#[test]
fn weights_are_checked() {
    let knots = || KnotVector::uniform(1, 1).unwrap();
    let with = |weights: &[f64]| NurbsCurve::new(knots(), [[0.0], [1.0]], weights).unwrap_err();
    assert_eq!(with(&[1.0, 0.0]), SplineError::Weight { index: 1, weight: 0.0 });
    assert_eq!(with(&[-1.0, 1.0]), SplineError::Weight { index: 0, weight: -1.0 });
    assert!(matches!(with(&[1.0, f64::NAN]), SplineError::Weight { index: 1, .. }));
    assert_eq!(with(&[1.0]), SplineError::Weights { expected: 2, found: 1 });
}

#[test]
fn a_circle_is_round_in_every_representation() {
    let circle = circle();
    let finer = circle.insert_knots(&[0.3, 2.7]).unwrap();
    let higher = circle.elevate().unwrap();
    let [low, high] = circle.split(1.7).unwrap();
    for i in 0..=100 {
        let t = f64::from(i) / 25.0;
        let part = if t < 1.7 { &low } else { &high };
        for curve in [&circle, &finer, &higher, part] {
            assert!((distance(curve.eval(t), [0.0; 3]) - 1.0).abs() < 1e-14);
            let [p, v, a] = curve.eval_with_derivs(t);
            // p·p = 1, so p·v = 0 and v·v + p·a = 0.
            let dot = |a: P3, b: P3| a[0] * b[0] + a[1] * b[1];
            assert!(dot(p, v).abs() < 1e-13 && (dot(v, v) + dot(p, a)).abs() < 1e-12);
        }
    }
    let (back, removed) = finer.remove_knot(0.3, 1, 1e-9).unwrap();
    assert_eq!((removed, back.weights().len()), (1, 10));
    assert_eq!(circle.to_bezier().len(), 4);
}

#[test]
fn rational_derivatives_agree_with_the_polynomial_quotient() {
    // (1 + t) C(t) over 1 + t is C(t).
    let weights = [1.0, 2.0];
    let curve = NurbsCurve::new(KnotVector::uniform(1, 1).unwrap(), [[1.0_f64], [3.0]], weights).unwrap();
    // x = (1 + 5t) / (1 + t), x' = 4 / (1 + t)², x'' = -8 / (1 + t)³, x''' = 24 / (1 + t)⁴
    let found = curve.eval_with_derivs::<4>(1.0);
    for (found, expected) in found.iter().zip([3.0, 1.0, -1.0, 1.5]) {
        assert!((found[0] - expected).abs() < 1e-15);
    }
}

#[test]
fn partials_agree_with_differences() {
    let u = KnotVector::uniform(2, 2).unwrap();
    let net = Net::from_fn(4, 4, |i, j| [i as f64, j as f64, (i * j) as f64 / 3.0]).unwrap();
    let weights = Net::from_fn(4, 4, |i, j| 1.0 + 0.3 * ((3 * i + 5 * j) % 7) as f64).unwrap();
    let surface = NurbsSurface::new(u.clone(), u, &net, &weights).unwrap();
    let (u, v, h) = (0.3, 0.6, 1e-5);
    let partials = surface.eval_with_partials::<3>(u, v);
    let difference = |a: P3, b: P3| [0, 1, 2].map(|i| (b[i] - a[i]) / (2.0 * h));
    for r in 0..2 {
        for c in 0..2 {
            let along_u = difference(
                surface.eval_with_partials::<3>(u - h, v)[r][c],
                surface.eval_with_partials::<3>(u + h, v)[r][c],
            );
            let along_v = difference(
                surface.eval_with_partials::<3>(u, v - h)[r][c],
                surface.eval_with_partials::<3>(u, v + h)[r][c],
            );
            assert!(distance(along_u, partials[r + 1][c]) < 1e-6);
            assert!(distance(along_v, partials[r][c + 1]) < 1e-6);
        }
    }
}

#[test]
fn turns_by_any_angle_are_exact() {
    let profile = BSplineCurve::from_bezier([[1.0, 0.0, 0.0], [2.0, 0.0, 1.0], [0.5, 0.0, 3.0]]).unwrap();
    for degrees in [1, 45, 90, 91, 180, 200, 270, 359, 360] {
        let angle = f64::from(degrees).to_radians();
        let surface =
            NurbsSurface::revolved(&profile.clone().into(), [0.0; 3], [0.0, 0.0, 2.0], angle).unwrap();
        assert_eq!(surface.domain().ranges()[1], [0.0, angle]);
        for v in [0.0, 0.3, 1.0] {
            let [x, _, z] = profile.eval(v);
            for i in 0..=20 {
                let [px, py, pz] = surface.eval(v, angle * f64::from(i) / 20.0);
                assert!((px.hypot(py) - x).abs() < 1e-14 && (pz - z).abs() < 1e-14);
            }
            let [ex, ey, _] = surface.eval(v, angle);
            assert!((ex - x * angle.cos()).abs() < 1e-14 && (ey - x * angle.sin()).abs() < 1e-14);
            let normal = surface.normal(v, 0.4 * angle).unwrap();
            assert!((distance(normal, [0.0; 3]) - 1.0).abs() < 1e-14);
        }
    }
    let full = NurbsSurface::revolved(&profile.clone().into(), [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).unwrap();
    assert_eq!(full.eval(0.7, 0.0), full.eval(0.7, 2.0 * PI));
    for angle in [0.0, -1.0, 6.3, f64::NAN] {
        let refused = NurbsSurface::revolved(&profile.clone().into(), [0.0; 3], [0.0, 0.0, 1.0], angle);
        assert!(matches!(refused, Err(SplineError::Angle { .. })));
    }
    let refused = NurbsSurface::revolved(&profile.into(), [0.0; 3], [0.0; 3], 1.0);
    assert_eq!(refused, Err(SplineError::Axis));
}

#[test]
fn a_surface_of_revolution_converts_exactly() {
    let points = [[1.0, 0.5, 0.0], [2.0, 0.1, 1.0], [0.5, 0.0, 3.0], [1.0, -0.3, 3.5]];
    let generatrix = Curve::new(BernsteinBasis::<f64, 4>::new(), points);
    for degrees in [20, 90, 135, 270, 360] {
        let angle = f64::from(degrees).to_radians();
        let turned = SurfaceOfRevolution::new(&generatrix, [0.2, 0.1, 0.0], [0.1, 0.3, 1.0], angle).unwrap();
        let surface = NurbsSurface::try_from(&turned).unwrap();
        assert_eq!(surface.degrees(), [3, 2]);
        assert_eq!(surface.domain().ranges(), [[0.0, 1.0], [0.0, angle]]);
        // The same meridians where arcs meet, and in the middle of each; the same circles.
        let arcs = surface.knots(Direction::V).spans().count();
        for half in 0..=2 * arcs {
            let v = angle * half as f64 / (2 * arcs) as f64;
            for u in [0.0, 0.25, 0.7, 1.0] {
                assert!(distance(surface.eval(u, v), turned.eval(u, v)) < 1e-14);
            }
        }
        // Everywhere it is as far from the axis as the generatrix, at the same height.
        let axis = [0.1, 0.3, 1.0].map(|x: f64| x / 1.1_f64.sqrt());
        let height = |p: P3| (0..3).map(|i| (p[i] - [0.2, 0.1, 0.0][i]) * axis[i]).sum::<f64>();
        let radius = |p: P3| (distance(p, [0.2, 0.1, 0.0]).powi(2) - height(p).powi(2)).sqrt();
        for i in 0..=30 {
            let (u, p) = (0.37, surface.eval(0.37, angle * f64::from(i) / 30.0));
            let q = turned.eval(u, 0.0);
            assert!((height(p) - height(q)).abs() < 1e-14 && (radius(p) - radius(q)).abs() < 1e-14);
        }
    }
}

#[test]
fn what_keeps_the_shape_is_there_for_rational_surfaces_too() {
    let profile = BSplineCurve::from_bezier([[1.0, 0.0, 0.0], [2.0, 0.0, 1.0], [0.5, 0.0, 3.0]]).unwrap();
    let turned = NurbsSurface::revolved(&profile.clone().into(), [0.0; 3], [0.0, 0.0, 1.0], 4.0).unwrap();
    let finer = turned.insert_knots(Direction::V, &[0.3]).unwrap().elevate(Direction::V).unwrap();
    let [a, b] = turned.merged(&finer).unwrap();
    assert_eq!(a.knots(Direction::V), b.knots(Direction::V));
    let backwards = turned.reversed(Direction::V);
    for (u, v) in [(0.0, 0.0), (0.4, 1.3), (1.0, 4.0), (0.8, 2.7)] {
        let here = turned.eval(u, v);
        for other in [&a, &b, &turned.refined(Direction::U), &turned.clamped()] {
            assert!(distance(other.eval(u, v), here) < 1e-14);
        }
        assert!(distance(turned.transposed().eval(v, u), here) < 1e-15);
        assert!(distance(backwards.eval(u, 4.0 - v), here) < 1e-14);
    }
    assert_eq!(turned.boundary(Edge::UEnd).eval(1.1), turned.eval(1.0, 1.1));
    let edge = turned.boundary(Edge::VStart);
    let [edge, other] = edge.merged(&edge.refined().elevate().unwrap()).unwrap();
    assert_eq!(edge.knots(), other.knots());
    assert!(distance(edge.reversed().eval(0.3), profile.eval(0.7)) < 1e-15);
    assert!(distance(other.clamped().eval(0.3), profile.eval(0.3)) < 1e-15);
}

#[test]
fn removal_far_from_the_origin_and_in_any_unit() {
    for (unit, offset) in [(1.0, 0.0), (1.0, 1e6), (1e6, 0.0), (1e-6, 0.0), (1e-6, 1.0)] {
        let circle = circle();
        let points: Vec<_> = circle.control_points().iter().map(|p| p.map(|x| x * unit + offset)).collect();
        let circle = NurbsCurve::new(circle.knots().clone(), points, circle.weights()).unwrap();
        let finer = circle.insert_knots(&[0.3, 2.7]).unwrap();
        for knot in [0.3, 2.7] {
            assert_eq!(finer.remove_knot(knot, 1, 1e-6 * unit).unwrap().1, 1, "{unit} {offset}");
        }
    }
}

#[test]
fn a_weight_moves_points_though_its_own_control_point_stays() {
    // The control point 5 is in the middle of 0 and 10, where it would be without the knot.
    let knots = KnotVector::uniform(1, 2).unwrap();
    let curve = NurbsCurve::new(knots, [[0.0], [5.0], [10.0]], [1.0, 1.5, 1.0]).unwrap();
    assert_eq!(curve.eval(0.25), [3.0]);
    assert_eq!(curve.remove_knot(0.5, 1, 0.1).unwrap().1, 0);
    let (line, removed) = curve.remove_knot(0.5, 1, 12.0).unwrap();
    assert_eq!((removed, line.eval(0.25)), (1, [2.5]));
}

#[test]
fn an_uneven_net_is_kept_together_with_its_weights() {
    // Different weights, and one point at a distance: what the bound says holds for the curve.
    let knots = KnotVector::uniform(2, 4).unwrap();
    let points: Vec<P3> =
        (0..6).map(|i| [f64::from(i), f64::from(i * i % 5), if i == 3 { 50.0 } else { 0.0 }]).collect();
    let weights = [1.0, 1.2, 0.9, 1.05, 1.0, 0.8];
    let curve = NurbsCurve::new(knots, points, weights).unwrap();
    let mut removals = 0;
    for tolerance in [1e-9, 1.0, 5.0, 20.0, 60.0, 200.0, 1e3, 1e4] {
        for knot in [0.25, 0.5, 0.75] {
            let (fewer, removed) = curve.remove_knot(knot, 1, tolerance).unwrap();
            removals += removed;
            for i in 0..=200 {
                let t = f64::from(i) / 200.0;
                assert!(distance(fewer.eval(t), curve.eval(t)) <= tolerance);
            }
        }
    }
    assert!(removals > 0 && removals < 24, "{removals}");
}

proptest! {
    #[test]
    fn equal_weights_change_nothing(curve in curve(), weight in 0.1..10.0, t in 0.0..=1.0) {
        let points: Vec<_> = curve.control_points().iter().map(|&p| Homogeneous::new(p, weight)).collect();
        let rational = BSplineCurve::new(curve.knots().clone(), points).unwrap();
        let rational = NurbsCurve::from_homogeneous(rational).unwrap();
        prop_assert!(distance(rational.eval(t), curve.eval(t)) < 1e-13);
        let (a, b) = (rational.eval_with_derivs::<3>(t), curve.eval_with_derivs::<3>(t));
        for (a, b) in a.into_iter().zip(b) {
            prop_assert!(distance(a, b) < 1e-12 * distance(b, [0.0; 3]).max(1.0) * 1e2);
        }
    }
}

#[test]
fn surfaces_keep_their_points_in_both_directions() {
    let profile = circle();
    let torus = NurbsSurface::revolved(&profile, [3.0, 0.0, 0.0], [0.0, 1.0, 0.0], 2.0 * PI).unwrap();
    let finer = torus.insert_knots(Direction::V, &[1.0]).unwrap().elevate(Direction::U).unwrap();
    for (u, v) in [(0.2, 0.1), (1.9, 3.0), (3.9, 6.0)] {
        let [x, y, z] = finer.eval(u, v);
        assert!(distance(finer.eval(u, v), torus.eval(u, v)) < 1e-13);
        let ring = (x - 3.0).hypot(z) - 3.0;
        assert!((ring.hypot(y) - 1.0).abs() < 1e-13);
        assert!(distance(torus.isocurve(Direction::U, u).eval(v), torus.eval(u, v)) < 1e-13);
    }
}
