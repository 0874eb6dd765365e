//! Functions of joins: the control points that they compute make curves and surfaces join, measured on the evaluated
//! curves and surfaces, which know nothing of the formulas.

use basis_runtime::{
    Contact, Curve, CurveError, Edge, EdgeJoint, EdgePair, Orientation, Surface, TensorSurface, basis,
};
use basis_tests::random::Random;

basis!("../../../specs/quadratic.basis");
basis!("../../../specs/quartic.basis");
basis!("../../../specs/quartic_surface.basis");

// Control points that are a multiple of one vector: half the derivative at an end, and in the join.
basis! {
    family HalfTangents {
        domain 0 <= t <= 1;
        b[0] = (1 + 2*t) * (1 - t)^2;
        b[1] = 2 * t * (1 - t)^2;
        b[2] = 2 * (t - 1) * t^2;
        b[3] = t^2 * (3 - 2*t);
    }

    join SlowedDown {
        curve P = HalfTangents;
        curve Q = HalfTangents;
        let Q[0] = P[3];
        let Q[1] = 1/4*P[2];
        prove Q(0) == P(1);
        prove D(Q)(0) == 1/4*D(P)(1);
    }

    // The names of scalars and nets are those that locals of generated functions would have.
    join Named {
        curve given = HalfTangents;
        curve Q = HalfTangents;
        scalar 0 <= x1;
        scalar 0 <= x0;
        scalar 0 <= c0;
        scalar 0 <= r0;
        let Q[0] = given[3];
        let Q[1] = (2 + x0)*(1 + c0)/((3 + x1)*(5 + r0 + x0))*given[2];
        prove Q(0) == given(1);
    }
}

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
fn no_name_of_a_spec_is_taken_for_a_local_of_the_function() {
    let (x1, x0, c0, r0) = (1.0, 4.0, 9.0, 7.0); // nothing is rounded
    let points = joins::named(&[0.0, 0.0, 7.0, 2.0], joins::NamedScalars { x1, x0, c0, r0 }).unwrap();
    assert_eq!(points, [2.0, 7.0 * ((2.0 + x0) * (1.0 + c0) / ((3.0 + x1) * (5.0 + r0 + x0)))]);
}

#[test]
fn curves_join_with_a_common_tangent() {
    let mut random = Random::new(1);
    for _ in 0..200 {
        let (l1, l2): (f64, f64) = (random.between(-1.9, 1.0), random.between(-1.9, 1.0));
        let delta = random.between(0.1, 10.0);
        let p: [[f64; 3]; 3] = core::array::from_fn(|_| point(&mut random));
        let [q0, q1] = quadratic::g1(&p, quadratic::G1Scalars { lambda1: l1, lambda2: l2, delta }).unwrap();
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
        let q = quadratic::g2(&p, quadratic::G2Scalars { lambda1: l1, lambda2: l2, delta, c }).unwrap();
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
    let next = Curve::new(
        QuadraticBezier::new(0.25).unwrap(),
        quadratic::g2(&p, quadratic::G2Scalars { lambda1: 0.5, lambda2: 0.25, delta: 1.0, c: 0.0 }).unwrap(),
    );
    let joint = Curve::new(QuadraticBezier::new(0.5).unwrap(), p).joint(&next);
    assert_eq!(joint.parametric_order(1e-15, [1e-14, 1e-13, 0.0]), Some(2));
}

#[test]
fn an_assumption_that_fails_is_an_error() {
    let p = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 1.0]];
    let refused = |l1: f64, l2: f64, delta: f64| match quadratic::g1(
        &p,
        quadratic::G1Scalars { lambda1: l1, lambda2: l2, delta },
    ) {
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
    let error = quadratic::g2(&p, quadratic::G2Scalars { lambda1: 0.5, lambda2: 1.0, delta: 1.0, c: 0.0 })
        .unwrap_err();
    assert_eq!(error.to_string(), "G2: λ2 = 1 is outside the declared range -2 < λ2 < 1");
}

#[test]
fn points_that_are_not_finite_are_an_error() {
    let p = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 1.0]];
    // The reciprocal of the smallest number is infinite, and so is that of a square.
    assert_eq!(
        quadratic::g1(&p, quadratic::G1Scalars { lambda1: 0.5, lambda2: 0.5, delta: 5e-324 }),
        Err(CurveError::NotFinite)
    );
    assert_eq!(
        quadratic::g2(&p, quadratic::G2Scalars { lambda1: 0.5, lambda2: 0.5, delta: 1e-200, c: 0.0 }),
        Err(CurveError::NotFinite)
    );
    assert_eq!(
        quadratic::g2(&p, quadratic::G2Scalars { lambda1: 0.5, lambda2: 0.5, delta: 1.0, c: 1e308 }),
        Err(CurveError::NotFinite)
    );
    assert_eq!(
        quadratic::g1(
            &[[0.0, 0.0], [1.0, f64::NAN], [3.0, 1.0]],
            quadratic::G1Scalars { lambda1: 0.5, lambda2: 0.5, delta: 1.0 }
        ),
        Err(CurveError::NotFinite)
    );
    let surface = [[[0.0_f64, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 3.0, 0.0]]; 4];
    assert_eq!(
        quartic_surface::g1_uu(
            &surface,
            quartic_surface::G1UuScalars { gamma1: [0.5; 4], gamma2: [0.5; 4], f: 1e-310 }
        ),
        Err(CurveError::NotFinite)
    );
    // A small δ alone is no error.
    assert!(quadratic::g1(&p, quadratic::G1Scalars { lambda1: 0.5, lambda2: 0.5, delta: 1e-300 }).is_ok());
}

#[test]
fn single_precision_and_numbers_are_points_too() {
    let p = [[0.0_f32, 0.0], [1.0, 2.0], [3.0, 1.0]];
    assert_eq!(
        quadratic::g1(&p, quadratic::G1Scalars { lambda1: 0.5, lambda2: -1.0, delta: 2.5 }),
        Ok([[3.0, 1.0], [5.0, 0.0]])
    );
    assert_eq!(
        quadratic::g1(&[0.0, 1.0, 3.0], quadratic::G1Scalars { lambda1: 0.5, lambda2: -1.0, delta: 2.5 }),
        Ok([3.0, 5.0])
    );
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
fn measured(joint: EdgeJoint<f64>) -> (Option<usize>, Orientation) {
    assert_eq!(joint.without_normal, 0);
    (joint.geometric_order(1e-13, 1e-11, 1e-9), joint.normals)
}

#[test]
fn surfaces_join_u_u() {
    let mut random = Random::new(3);
    for _ in 0..20 {
        let (s, mut t) = (net(&mut random), net(&mut random));
        let (lambda, g1, g2) = (random.between(-2.5, 1.0), rows(&mut random), rows(&mut random));
        let f = random.between(0.5, 2.0);
        let first = surface(lambda, g1, &s);
        let tangents =
            quartic_surface::g1_uu(&s, quartic_surface::G1UuScalars { gamma1: g1, gamma2: g2, f }).unwrap();
        for (row, new) in t.iter_mut().zip(tangents) {
            row[..2].copy_from_slice(&new);
        }
        let next = surface(lambda, g2, &t);
        let joint = first.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &next, 33);
        assert_eq!(measured(joint), (Some(1), Orientation::Same), "{joint:?}");
        // The published steps: everything but the last column.
        let steps =
            quartic_surface::g2_uu(&s, quartic_surface::G2UuScalars { gamma1: g1, gamma2: g2, f }).unwrap();
        for (row, new) in t.iter_mut().zip(steps) {
            row[..3].copy_from_slice(&new);
        }
        let next = surface(lambda, g2, &t);
        let joint = first.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &next, 33);
        assert_eq!(measured(joint), (Some(2), Orientation::Same), "{joint:?}");
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
        t[..2].copy_from_slice(
            &quartic_surface::g1_uv(&s, quartic_surface::G1UvScalars { gamma1: g1, lambda2: l2, f }).unwrap(),
        );
        let joint = first.joint(EdgePair::along(Edge::VEnd, Edge::UStart), &surface(l2, gamma, &t), 33);
        assert_eq!(measured(joint), (Some(1), Orientation::Opposite), "{joint:?}");
        let gamma = [l1, l1, l1, random.between(-2.5, 1.0)];
        t[..3].copy_from_slice(
            &quartic_surface::g2_uv(&s, quartic_surface::G2UvScalars { gamma1: g1, lambda2: l2, f }).unwrap(),
        );
        let joint = first.joint(EdgePair::along(Edge::VEnd, Edge::UStart), &surface(l2, gamma, &t), 33);
        assert_eq!(measured(joint), (Some(2), Orientation::Opposite), "{joint:?}");
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
        t[..2].copy_from_slice(
            &quartic_surface::g1_vv(&s, quartic_surface::G1VvScalars { lambda1: l1, lambda2: l2, f })
                .unwrap(),
        );
        let next = surface(l2, [eta, eta, other, other], &t);
        let joint = first.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &next, 33);
        assert_eq!(measured(joint), (Some(1), Orientation::Same), "{joint:?}");
        t[..3].copy_from_slice(
            &quartic_surface::g2_vv(&s, quartic_surface::G2VvScalars { lambda1: l1, lambda2: l2, f })
                .unwrap(),
        );
        let next = surface(l2, [eta, eta, eta, other], &t);
        let joint = first.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &next, 33);
        assert_eq!(measured(joint), (Some(2), Orientation::Same), "{joint:?}");
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

/// The size of P' - f Q' and of P'' - f² Q'' - c Q', in terms of the size of P' and P''.
fn missed(p: [[f64; 3]; 3], q: [[f64; 3]; 3], f: f64, c: f64) -> [f64; 2] {
    let size = |v: [f64; 3]| v.into_iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scale = size(p[1]).max(size(p[2])).max(1.0);
    let first = core::array::from_fn(|d| p[1][d] - f * q[1][d]);
    let second = core::array::from_fn(|d| p[2][d] - f * f * q[2][d] - c * q[1][d]);
    [size(first) / scale, size(second) / scale]
}

/// A G2 contact leaves two scalars free, f and c: the derivatives say that these are the ones that were asked for,
/// which tangents and curvatures do not.
#[test]
fn the_scalars_of_a_contact_are_those_that_were_asked_for() {
    let mut random = Random::new(7);
    for _ in 0..100 {
        let family = QuarticBernstein::new(0.25).unwrap();
        let p: [[f64; 3]; 4] = core::array::from_fn(|_| point(&mut random));
        let free: [[f64; 3]; 4] = core::array::from_fn(|_| point(&mut random));
        let curve = Curve::new(QuarticBernstein::new(-1.5).unwrap(), p);
        let (f, c) = (random.between(0.5, 2.0), random.between(-3.0, 3.0));
        let next = family.curve_after(&curve, Contact::Curvature { f, c }, free).unwrap();
        let previous = family.curve_before(&curve, Contact::Curvature { f, c }, free).unwrap();
        let after = missed(curve.eval_with_derivs(1.0), next.eval_with_derivs(0.0), f, c);
        let before = missed(curve.eval_with_derivs(0.0), previous.eval_with_derivs(1.0), f, c);
        assert!(after.into_iter().chain(before).all(|x| x < 1e-12), "{after:?} {before:?}");
        let next = family.curve_after(&curve, Contact::Tangent { f }, free).unwrap();
        let previous = family.curve_before(&curve, Contact::Tangent { f }, free).unwrap();
        let [after, _] = missed(curve.eval_with_derivs(1.0), next.eval_with_derivs(0.0), f, c);
        let [before, _] = missed(curve.eval_with_derivs(0.0), previous.eval_with_derivs(1.0), f, c);
        assert!(after < 1e-12 && before < 1e-12, "{after:e} {before:e}");
        // What the contact does not determine is as it was given.
        assert_eq!(next.control_points()[2..], free[2..]);
        assert_eq!(previous.control_points()[..2], free[..2]);
        // The join of the papers.
        let (l1, l2) = (random.between(-1.5, 0.9), random.between(-1.5, 0.9));
        let p = [p[0], p[1], p[2]];
        let first = Curve::new(QuadraticBezier::new(l1).unwrap(), p);
        let next = Curve::new(
            QuadraticBezier::new(l2).unwrap(),
            quadratic::g2(&p, quadratic::G2Scalars { lambda1: l1, lambda2: l2, delta: f, c }).unwrap(),
        );
        let joined = missed(first.eval_with_derivs(1.0), next.eval_with_derivs(0.0), f, c);
        assert!(joined.into_iter().all(|x| x < 1e-12), "{joined:?}");
    }
}

#[test]
fn a_contact_that_has_no_meaning_is_an_error() {
    let family = QuarticBernstein::new(0.25).unwrap();
    let points = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
    let refused = |contact: Contact<f64>, points: [[f64; 2]; 4]| {
        let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
        let errors = [
            family.curve_after(&curve, contact, [[0.0; 2]; 4]).map(|_| ()),
            family.curve_before(&curve, contact, [[0.0; 2]; 4]).map(|_| ()),
        ];
        assert_eq!(format!("{:?}", errors[0]), format!("{:?}", errors[1]));
        errors[0].unwrap_err()
    };
    let is_factor = |error: CurveError| matches!(error, CurveError::Factor { .. });
    for f in [0.0, -2.0, f64::INFINITY, f64::NAN] {
        assert!(is_factor(refused(Contact::Tangent { f }, points)), "{f}");
        assert!(is_factor(refused(Contact::Curvature { f, c: 0.0 }, points)), "{f}");
    }
    for c in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        assert!(is_factor(refused(Contact::Curvature { f: 1.0, c }, points)), "{c}");
    }
    // A reciprocal that overflows, and points that are not finite.
    assert_eq!(refused(Contact::Tangent { f: 5e-324 }, points), CurveError::NotFinite);
    let mut broken = points;
    broken[0][1] = f64::NAN;
    broken[3][0] = f64::INFINITY;
    assert_eq!(refused(Contact::Tangent { f: 1.0 }, broken), CurveError::NotFinite);
    // Four control points do not determine four derivatives and the point.
    let error = refused(Contact::Parametric { order: 4 }, points);
    assert!(matches!(error, CurveError::Contact { most: 3, found: 4, .. }), "{error}");
}

/// As many derivatives as there are control points: all of them follow from the other curve.
#[test]
fn a_contact_of_the_highest_order_determines_all_points() {
    let curve =
        Curve::new(QuarticBernstein::new(0.0).unwrap(), [[0.0_f64, 1.0], [1.0, 2.0], [3.0, 2.5], [4.0, 0.0]]);
    let family = QuarticBernstein::new(0.0).unwrap();
    let order = Contact::Parametric { order: 3 };
    // With λ = 0 both are polynomials of degree 3, so that the curve goes on as it is.
    let next = family.curve_after(&curve, order, [[9.0; 2]; 4]).unwrap();
    let previous = family.curve_before(&curve, order, [[9.0; 2]; 4]).unwrap();
    for t in [0.0_f64, 0.25, 0.5, 1.0] {
        let ([a, b], [c, d]) = ([curve.eval(1.0 + t), next.eval(t)], [curve.eval(t - 1.0), previous.eval(t)]);
        for k in 0..2 {
            assert!((a[k] - b[k]).abs() < 1e-11 && (c[k] - d[k]).abs() < 1e-11, "{a:?} {b:?} {c:?} {d:?}");
        }
    }
}

#[test]
fn control_points_that_are_multiples_of_one_vector() {
    let points = [[0.0_f64, 0.0, 1.0], [1.0, 2.0, 0.0], [3.0, 2.0, -1.0], [4.0, 0.0, 2.0]];
    let free = [[7.0, 8.0, 9.0]; 4];
    let curve = Curve::new(HalfTangents::new(), points);
    let next = HalfTangents::new().curve_after(&curve, Contact::Tangent { f: 2.0 }, free).unwrap();
    let previous = HalfTangents::new().curve_before(&curve, Contact::Tangent { f: 2.0 }, free).unwrap();
    // The derivatives at the ends are twice P[1] and P[2].
    let wanted =
        [[points[3], [1.5, 1.0, -0.5], free[2], free[3]], [free[0], free[1], [0.5, 1.0, 0.0], points[0]]];
    for (found, wanted) in [next.control_points(), previous.control_points()].into_iter().zip(wanted) {
        let pairs = found.as_flattened().iter().zip(wanted.as_flattened());
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {wanted:?}");
    }
    assert_eq!(joins::slowed_down(&points), Ok([points[3], [0.75, 0.5, -0.25]]));
}
