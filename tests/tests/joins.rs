//! Functions of joins: the control points that they compute make curves and surfaces join, measured on the evaluated curves
//! and surfaces, which know nothing of the formulas.

use basis_runtime::{
    Contact, Curve, CurveError, Edge, EdgeContinuity, TensorSurface, basis, edge_continuity,
};
use basis_tests::random::Random;

basis!("../../specs/quadratic.basis");
basis!("../../specs/quartic.basis");
basis!("../../specs/quartic_surface.basis");

type Net = [[[f64; 3]; 4]; 4];

fn point(random: &mut Random) -> [f64; 3] {
    core::array::from_fn(|_| random.between(-1.0, 1.0))
}

/// A net near a grid, so that no derivative is close to zero.
fn net(random: &mut Random) -> Net {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let [x, y, z] = point(random);
            [2.0 * i as f64 + 0.4 * x, 2.0 * j as f64 + 0.4 * y, z]
        })
    })
}

#[test]
fn curves_join_with_a_common_tangent() {
    let mut random = Random::new(1);
    for _ in 0..200 {
        let (l1, l2): (f64, f64) = (random.between(-1.9, 1.0), random.between(-1.9, 1.0));
        let delta = random.between(0.1, 10.0);
        let p: [[f64; 3]; 3] = core::array::from_fn(|_| point(&mut random));
        let [q0, q1] = quadratic::g1(&p, l1, l2, delta).unwrap();
        let first = Curve::new(QuadraticBezier::new(l1).unwrap(), p);
        let next = Curve::new(QuadraticBezier::new(l2).unwrap(), [q0, q1, point(&mut random)]);
        let joint = first.joint(&next);
        assert!(joint.gap <= 1e-15 && joint.angle <= 1e-13, "{joint:?}");
        // P'(1) = δ Q'(0)
        let velocity = |[_, v]: [[f64; 3]; 2]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let ratio = velocity(first.eval_with_derivs(1.0)) / velocity(next.eval_with_derivs(0.0));
        assert!((ratio / delta - 1.0).abs() <= 1e-13, "{ratio} {delta}");
    }
}

#[test]
fn curves_join_with_a_common_curvature() {
    let mut random = Random::new(2);
    for _ in 0..200 {
        let (l1, l2): (f64, f64) = (random.between(-1.5, 0.9), random.between(-1.5, 0.9));
        let (delta, c) = (random.between(0.5, 2.0), random.between(-3.0, 3.0));
        let p: [[f64; 3]; 3] = core::array::from_fn(|_| point(&mut random));
        let q = quadratic::g2(&p, l1, l2, delta, c).unwrap();
        let first = Curve::new(QuadraticBezier::new(l1).unwrap(), p);
        let next = Curve::new(QuadraticBezier::new(l2).unwrap(), q);
        let joint = first.joint(&next);
        let [_, v, a] = first.eval_with_derivs::<3>(1.0);
        let speed = v.iter().map(|x| x * x).sum::<f64>();
        let scale = a.iter().map(|x| x.abs()).fold(1.0, f64::max) / speed;
        assert!(joint.gap <= 1e-15 && joint.angle <= 1e-12, "{joint:?}");
        assert!(joint.curvature <= 1e-11 * scale.max(1.0), "{joint:?}, {scale}");
    }
    // δ = 1 and c = 0 give C2.
    let p = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 1.0, 1.0]];
    let next =
        Curve::new(QuadraticBezier::new(0.25).unwrap(), quadratic::g2(&p, 0.5, 0.25, 1.0, 0.0).unwrap());
    let joint = Curve::new(QuadraticBezier::new(0.5).unwrap(), p).joint(&next);
    assert_eq!(joint.parametric_order(1e-15, [1e-14, 1e-13, 0.0]), Some(2));
}

#[test]
fn an_assumption_that_fails_is_an_error() {
    let p = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 1.0]];
    let refused = |l1: f64, l2: f64, delta: f64| match quadratic::g1(&p, l1, l2, delta) {
        Err(CurveError::Shape(error)) => (error.parameter(), error.range()),
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(0.5, 0.5, 0.0), ("δ", "0 < δ"));
    assert_eq!(refused(0.5, 0.5, -1.0), ("δ", "0 < δ"));
    assert_eq!(refused(0.5, 0.5, f64::NAN), ("δ", "0 < δ"));
    assert_eq!(refused(0.5, 0.5, f64::INFINITY), ("δ", "0 < δ"));
    assert_eq!(refused(-2.0, 0.5, 1.0), ("λ1", "-2 < λ1 <= 1"));
    assert_eq!(refused(0.5, -2.0, 1.0), ("λ2", "-2 < λ2 <= 1"));
    assert_eq!(refused(0.5, 1.5, 1.0), ("λ2", "-2 < λ2 <= 1"));
    // At λ = 1 the second derivative at the start does not depend on the last point.
    let error = quadratic::g2(&p, 0.5, 1.0, 1.0, 0.0).unwrap_err();
    assert_eq!(error.to_string(), "G2: λ2 = 1 is outside the declared range -2 < λ2 < 1");
}

#[test]
fn points_that_are_not_finite_are_an_error() {
    let p = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 1.0]];
    // The reciprocal of the smallest number is infinite, and so is that of a square.
    assert_eq!(quadratic::g1(&p, 0.5, 0.5, 5e-324), Err(CurveError::NotFinite));
    assert_eq!(quadratic::g2(&p, 0.5, 0.5, 1e-200, 0.0), Err(CurveError::NotFinite));
    assert_eq!(quadratic::g2(&p, 0.5, 0.5, 1.0, 1e308), Err(CurveError::NotFinite));
    assert_eq!(
        quadratic::g1(&[[0.0, 0.0], [1.0, f64::NAN], [3.0, 1.0]], 0.5, 0.5, 1.0),
        Err(CurveError::NotFinite)
    );
    let surface = [[[0.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 3.0, 0.0]]; 4];
    assert_eq!(quartic_surface::g1_uu(&surface, [0.5; 4], [0.5; 4], 1e-310), Err(CurveError::NotFinite));
    // A small δ alone is none.
    assert!(quadratic::g1(&p, 0.5, 0.5, 1e-300).is_ok());
}

#[test]
fn single_precision_and_numbers_are_points_too() {
    let p = [[0.0_f32, 0.0], [1.0, 2.0], [3.0, 1.0]];
    assert_eq!(quadratic::g1(&p, 0.5, -1.0, 2.5), Ok([[3.0, 1.0], [5.0, 0.0]]));
    assert_eq!(quadratic::g1(&[0.0, 1.0, 3.0], 0.5, -1.0, 2.5), Ok([3.0, 5.0]));
}

/// Shape values of the rows of a net.
fn rows(random: &mut Random) -> [f64; 4] {
    core::array::from_fn(|_| random.between(-2.5, 1.0))
}

fn surface(
    lambda: f64,
    gamma: [f64; 4],
    net: &Net,
) -> TensorSurface<QuarticBernstein, QuarticBernstein, [f64; 3]> {
    let [u, v0, v1, v2, v3] =
        [lambda, gamma[0], gamma[1], gamma[2], gamma[3]].map(|l| QuarticBernstein::new(l).unwrap());
    TensorSurface::with_rows(u, [v0, v1, v2, v3], *net)
}

/// The order of contact and whether the normals point to the same side.
fn measured(joint: EdgeContinuity<f64>) -> (Option<usize>, bool) {
    assert_eq!(joint.without_normal, 0);
    (joint.order(1e-13, 1e-11, 1e-9), joint.same_side)
}

#[test]
fn surfaces_join_u_u() {
    let mut random = Random::new(3);
    for _ in 0..20 {
        let (s, mut t) = (net(&mut random), net(&mut random));
        let (lambda, g1, g2) = (random.between(-2.5, 1.0), rows(&mut random), rows(&mut random));
        let f = random.between(0.5, 2.0);
        let first = surface(lambda, g1, &s);
        let tangents = quartic_surface::g1_uu(&s, g1, g2, f).unwrap();
        for (row, new) in t.iter_mut().zip(tangents) {
            row[..2].copy_from_slice(&new);
        }
        let next = surface(lambda, g2, &t);
        let joint = edge_continuity(&first, Edge::VEnd, &next, Edge::VStart, false, 33);
        assert_eq!(measured(joint), (Some(1), true), "{joint:?}");
        // The published steps: everything but the last column.
        let steps = quartic_surface::g2_uu(&s, g1, g2, f).unwrap();
        for (row, new) in t.iter_mut().zip(steps) {
            row[..3].copy_from_slice(&new);
        }
        let next = surface(lambda, g2, &t);
        let joint = edge_continuity(&first, Edge::VEnd, &next, Edge::VStart, false, 33);
        assert_eq!(measured(joint), (Some(2), true), "{joint:?}");
    }
}

#[test]
fn surfaces_join_u_v_with_opposite_normals() {
    let mut random = Random::new(4);
    for _ in 0..20 {
        let (s, mut t) = (net(&mut random), net(&mut random));
        let (l1, l2, g1) = (random.between(-2.5, 1.0), random.between(-2.5, 1.0), rows(&mut random));
        let f = random.between(0.5, 2.0);
        let first = surface(l1, g1, &s);
        let gamma = [l1, l1, random.between(-2.5, 1.0), random.between(-2.5, 1.0)];
        t[..2].copy_from_slice(&quartic_surface::g1_uv(&s, g1, l2, f).unwrap());
        let joint = edge_continuity(&first, Edge::VEnd, &surface(l2, gamma, &t), Edge::UStart, false, 33);
        assert_eq!(measured(joint), (Some(1), false), "{joint:?}");
        let gamma = [l1, l1, l1, random.between(-2.5, 1.0)];
        t[..3].copy_from_slice(&quartic_surface::g2_uv(&s, g1, l2, f).unwrap());
        let joint = edge_continuity(&first, Edge::VEnd, &surface(l2, gamma, &t), Edge::UStart, false, 33);
        assert_eq!(measured(joint), (Some(2), false), "{joint:?}");
    }
}

#[test]
fn surfaces_join_v_v() {
    let mut random = Random::new(5);
    for _ in 0..20 {
        let (s, mut t) = (net(&mut random), net(&mut random));
        let (l1, l2, eta) = (random.between(-2.5, 1.0), random.between(-2.5, 1.0), random.between(-3.0, 1.0));
        let (f, free, other) =
            (random.between(0.5, 2.0), random.between(-3.0, 1.0), random.between(-3.0, 1.0));
        let first = surface(l1, [free, eta, eta, eta], &s);
        t[..2].copy_from_slice(&quartic_surface::g1_vv(&s, l1, l2, f).unwrap());
        let next = surface(l2, [eta, eta, other, other], &t);
        let joint = edge_continuity(&first, Edge::UEnd, &next, Edge::UStart, false, 33);
        assert_eq!(measured(joint), (Some(1), true), "{joint:?}");
        t[..3].copy_from_slice(&quartic_surface::g2_vv(&s, l1, l2, f).unwrap());
        let next = surface(l2, [eta, eta, eta, other], &t);
        let joint = edge_continuity(&first, Edge::UEnd, &next, Edge::UStart, false, 33);
        assert_eq!(measured(joint), (Some(2), true), "{joint:?}");
    }
}

/// At both ends, with a common curvature.
#[test]
fn curves_are_continued_at_either_end() {
    let mut random = Random::new(6);
    for _ in 0..100 {
        let family = QuarticBernstein::new(0.25).unwrap();
        let p: [[f64; 3]; 4] = core::array::from_fn(|_| point(&mut random));
        let free: [[f64; 3]; 4] = core::array::from_fn(|_| point(&mut random));
        let curve = Curve::new(QuarticBernstein::new(-1.5).unwrap(), p);
        let contact = Contact::Curvature { f: random.between(0.5, 2.0), c: random.between(-1.0, 1.0) };
        let next = family.curve_after(&curve, contact, free).unwrap();
        let previous = family.curve_before(&curve, contact, free).unwrap();
        assert_eq!((next.control_points()[3], previous.control_points()[0]), (free[3], free[0]));
        for (joint, end) in [(curve.joint(&next), 1.0), (previous.joint(&curve), 0.0)] {
            let [_, v, a] = curve.eval_with_derivs::<3>(end);
            let bend = a.iter().map(|x| x.abs()).fold(1.0, f64::max) / v.iter().map(|x| x * x).sum::<f64>();
            assert!(joint.gap <= 1e-14 && joint.angle <= 1e-12, "{joint:?}");
            assert!(joint.curvature <= 1e-10 * bend.max(1.0), "{joint:?}");
        }
    }
}
