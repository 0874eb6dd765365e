//! Curves of every type continue curves of every type, with every contact that their control points allow.

use basis_runtime::bspline::{BSplineCurve, KnotVector, NurbsCurve};
use basis_runtime::{
    BernsteinBasis, Bezier, Contact, Curve, CurveError, Isocurve, JoinableCurve, ParametricCurve, Path,
    PiecewiseCurve, RationalBezier, RationalSpline, SurfaceOfRevolution,
};

use crate::queries::{distance, nurbs};
use crate::random::Random;

type P3 = [f64; 3];

fn points<const N: usize>(random: &mut Random) -> [P3; N] {
    core::array::from_fn(|i| {
        let [x, y, z] = [(); 3].map(|()| random.between(-0.5, 0.5));
        [i as f64 + x, y, z]
    })
}

fn spline(random: &mut Random, periodic: bool) -> BSplineCurve<P3> {
    let knots =
        if periodic { KnotVector::uniform(4, 3) } else { KnotVector::clamped(4, &[-1.0, 0.0, 0.5, 2.0]) };
    BSplineCurve::new(knots.unwrap(), points::<7>(random)).unwrap()
}

/// The joint of a curve with another one, at either end, has the order that was asked for, and the rest has not moved.
fn joined<C: JoinableCurve<Point = P3>>(
    first: &dyn ParametricCurve<Point = P3>,
    draft: &C,
    random: &mut Random,
) {
    let most = draft.highest_contact().min(4);
    for order in 0..=most {
        let mut expected = vec![[0.0; 3]; order + 1];
        first.derivatives_into(first.domain()[1], &mut expected);
        let next = draft.with_start(&expected).unwrap();
        let mut found = vec![[0.0; 3]; order + 1];
        next.derivatives_into(next.domain()[0], &mut found);
        for (k, (a, b)) in found.iter().zip(&expected).enumerate() {
            let scale = 1.0 + distance(*b, [0.0; 3]);
            assert!(
                distance(*a, *b) < 1e-9 * scale * 10_f64.powi(k as i32),
                "order {k} of {order}: {a:?} {b:?}"
            );
        }
        assert!(distance(next.end(), draft.end()) < 1e-12 || order == draft.highest_contact());
    }
    assert!(matches!(
        draft.with_end(&vec![[1.0; 3]; draft.highest_contact() + 2]),
        Err(CurveError::Contact { .. })
    ));
    let geometric = [
        (Contact::Parametric { order: 0 }, 0),
        (Contact::Tangent { f: random.between(0.5, 2.0) }, 1),
        (Contact::Curvature { f: random.between(0.5, 2.0), c: random.between(-1.0, 1.0) }, 2),
    ];
    for (contact, order) in geometric {
        if order <= most {
            let line = Bezier::from_points(points::<5>(random));
            let next = line.continued(contact, draft).unwrap();
            assert!(
                line.joint(&next).geometric_order(1e-10, 1e-7, 1e-7) >= Some(order),
                "{:?}",
                line.joint(&next)
            );
            let before = line.preceded(contact, draft).unwrap();
            let joint = before.joint(&line);
            assert!(joint.geometric_order(1e-10, 1e-7, 1e-7) >= Some(order), "{joint:?}");
            assert!(distance(before.start(), draft.start()) < 1e-12);
        }
    }
    let wrong = Bezier::from_points(points::<3>(random)).continued(Contact::Tangent { f: -1.0 }, draft);
    assert!(matches!(wrong, Err(CurveError::Factor { name: "f", .. })));
    let huge =
        Bezier::from_points(points::<3>(random)).continued(Contact::Parametric { order: usize::MAX }, draft);
    assert!(matches!(huge, Err(CurveError::Contact { .. })));
}

#[test]
fn every_type_after_every_type() {
    let random = &mut Random::new(2401);
    for _ in 0..20 {
        let bezier = Bezier::from_points(points::<6>(random));
        let rational = RationalBezier::new(points::<6>(random), [1.0, 2.0, 0.5, 1.5, 1.0, 0.7]).unwrap();
        let moved = rational.with_domain([2.0, 5.0]);
        let family = Curve::new(BernsteinBasis::<f64, 5>::new(), points::<5>(random));
        let piecewise = PiecewiseCurve::new(vec![family, family]).unwrap();
        let (clamped, periodic) = (spline(random, false), spline(random, true));
        let rational_spline = nurbs(random);
        let path = Path::from_curve(&rational);
        let mut mixed = Path::from_curve(&bezier);
        mixed.append(&rational);
        let spans = RationalSpline::new([rational.clone(), moved.clone()]).unwrap();
        let generatrix = Bezier::from_points([[0.0, 1.0], [1.0, 2.5], [3.0, 1.0]]);
        let vase = SurfaceOfRevolution::about_x(&generatrix, 5.0).unwrap();
        let circle = Isocurve::new(&vase, basis_runtime::Direction::U, 0.4);
        let first: [&dyn ParametricCurve<Point = P3>; 7] =
            [&bezier, &moved, &piecewise, &clamped, &periodic, &path, &circle];
        for first in first {
            joined(first, &bezier, random);
            joined(first, &moved, random);
            joined(first, &piecewise, random);
            joined(first, &clamped, random);
            joined(first, &periodic, random);
            joined(first, &rational_spline, random);
            joined(first, &path, random);
            joined(first, &mixed, random);
            joined(first, &spans, random);
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let draft = Bezier::from_points([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
    let knots = KnotVector::clamped(2, &[0.0, 1.0]).unwrap();
    let spline = BSplineCurve::new(knots, [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]).unwrap();
    let rational = NurbsCurve::from(spline.clone());
    let bad = Bezier::from_points([[0.0, 0.0], [f64::NAN, 0.0]]);
    let contact = Contact::Parametric { order: 1 };
    assert_eq!(bad.continued(contact, &draft), Err(CurveError::NotFinite));
    assert_eq!(bad.continued(contact, &spline), Err(CurveError::NotFinite));
    assert_eq!(bad.preceded(contact, &rational), Err(CurveError::NotFinite));
}

/// A curve that is a point has no tangent that another one could have in common with it: the equations alone hold.
#[test]
fn to_a_curve_that_is_a_point() {
    let point = Bezier::from_points([[1.0_f64, 2.0]; 3]);
    let draft = Bezier::from_points([[0.0; 2], [0.0; 2], [4.0, 6.0], [5.0, 6.0]]);
    let next = ParametricCurve::continued(&point, Contact::Tangent { f: 2.0 }, &draft).unwrap();
    assert_eq!(next.control_points(), &[[1.0, 2.0], [1.0, 2.0], [4.0, 6.0], [5.0, 6.0]]);
    let [x, y] = next.tangent(0.0).unwrap();
    assert!((x - 0.6).abs() < 1e-15 && (y - 0.8).abs() < 1e-15, "{x} {y}");
    let joint = ParametricCurve::joint(&point, &next);
    assert!(joint.gap == 0.0 && joint.derivatives[0] == 0.0 && joint.angle.is_nan(), "{joint:?}");
    assert_eq!(joint.geometric_order(1e-9, 1e-9, 1e-9), Some(0));
}
