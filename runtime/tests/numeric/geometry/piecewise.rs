//! Curves of several segments: joins hold what they promise, joints are measured, and questions reach all segments.

use basis_runtime::{Array, Basis, BernsteinBasis, Bezier, Contact, Curve, CurveError, PiecewiseCurve};

use crate::families::{Bernstein7, Linear, QuadraticLagrange, QuarticBernstein, UniformCubic};
use crate::random::Random;

fn random_curve<B: Basis<Scalar = f64>>(basis: B, random: &mut Random) -> Curve<B, [f64; 3]> {
    Curve::new(basis, B::Points::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0))))
}

fn joins_hold<B: Basis<Scalar = f64>, C: Basis<Scalar = f64>>(first: B, next: C, random: &mut Random) {
    let first = random_curve(first, random);
    let free = random_curve(next, random);
    let points = C::Points::from_fn(|i| free.control_points()[i]);
    let (f, c) = (random.between(0.5, 2.0), random.between(-1.0, 1.0));
    let small = |order: usize| (0.0_f64).max(1e-9 * 10_f64.powi(order as i32));
    for order in 0..C::LEN.min(4) {
        let next = next.curve_after(&first, Contact::Parametric { order }, points).unwrap();
        let joint = first.joint(&next);
        assert!(joint.gap < 1e-12, "{joint:?}");
        assert!((1..=order).all(|k| joint.derivatives[k - 1] < small(k)), "order {order}: {joint:?}");
        assert_eq!(next.control_points()[order + 1..], free.control_points()[order + 1..]);
        assert_eq!(joint.parametric_order(1e-9, [small(1), small(2), small(3)]), Some(order));
    }
    let next_g1 = next.curve_after(&first, Contact::Tangent { f }, points).unwrap();
    let [_, before] = first.eval_with_derivs(first.domain()[1]);
    let [_, after] = next_g1.eval_with_derivs(next_g1.domain()[0]);
    assert!((0..3).all(|d| (f * after[d] - before[d]).abs() < 1e-9));
    let joint = first.joint(&next_g1);
    assert_eq!(joint.geometric_order(1e-9, 1e-9, 1e-9), Some(1), "{joint:?}");
    if C::LEN > 2 {
        let next_g2 = next.curve_after(&first, Contact::Curvature { f, c }, points).unwrap();
        let joint = first.joint(&next_g2);
        assert_eq!(joint.geometric_order(1e-9, 1e-7, 1e-6), Some(2), "{joint:?}");
        assert_eq!(joint.parametric_order(1e-9, [1e-9; 3]), Some(0));
    }
}

#[test]
fn joins_of_all_families() {
    let random = &mut Random::new(31);
    for _ in 0..30 {
        let quartic = || QuarticBernstein::new(0.5).unwrap();
        joins_hold(quartic(), QuarticBernstein::new(random.between(-2.0, 0.9)).unwrap(), random);
        joins_hold(Bernstein7::new(), quartic(), random);
        joins_hold(UniformCubic::new(), Bernstein7::new(), random);
        // A domain of another width, and a basis whose functions do not vanish at the ends one after the other.
        joins_hold(quartic(), UniformCubic::new(), random);
        joins_hold(quartic(), QuadraticLagrange::new(), random);
    }
}

#[test]
fn joins_that_do_not_exist() {
    let first =
        Curve::new(QuarticBernstein::new(0.5).unwrap(), [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0_f64]]);
    let join =
        |lambda, contact| QuarticBernstein::new(lambda).unwrap().curve_after(&first, contact, [[0.0; 2]; 4]);
    // At λ = -3 the derivative at the start is zero for all control points.
    let error = join(-3.0, Contact::Tangent { f: 1.0 }).unwrap_err();
    assert_eq!(error, CurveError::Join { family: "QuarticBernstein", conditions: 2, at: "" });
    assert!(join(-3.0, Contact::Parametric { order: 0 }).is_ok());
    // At λ = 1 the cross product of the first two derivatives is that of the points: G2 exists.
    assert!(join(1.0, Contact::Curvature { f: 1.0, c: 0.0 }).is_ok());
    assert_eq!(
        join(0.0, Contact::Parametric { order: 4 }),
        Err(CurveError::Contact { family: "QuarticBernstein", most: 3, found: 4 })
    );
    assert!(join(0.0, Contact::Parametric { order: usize::MAX }).is_err());
    for bad in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(join(0.0, Contact::Tangent { f: bad }), Err(CurveError::Factor { name: "f", value: bad }));
    }
    assert!(join(0.0, Contact::Curvature { f: 1.0, c: f64::NAN }).is_err());
    let infinite = Bezier::from_points([[0.0, f64::INFINITY], [1.0, 1.0]]);
    let next =
        BernsteinBasis::<f64, 3>::new().curve_after(&infinite, Contact::Tangent { f: 1.0 }, [[0.0; 2]; 3]);
    assert_eq!(next, Err(CurveError::NotFinite));
}

#[test]
fn joints_are_measured() {
    let first = Bezier::from_points([[0.0, 0.0], [1.0, 0.0_f64]]);
    let joint = first.joint(&Bezier::from_points([[1.0, 0.5], [1.0, 1.5]]));
    assert_eq!((joint.gap, joint.curvature), (0.5, 0.0));
    assert!((joint.angle - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
    assert_eq!(joint.geometric_order(0.1, 1.0, 1.0), None);
    assert_eq!(joint.geometric_order(0.5, 1.0, 1.0), Some(0));
    let back = first.joint(&first.reversed());
    assert!((back.angle - core::f64::consts::PI).abs() < 1e-15);
    let halt = first.joint(&Bezier::from_points([[1.0, 0.0]; 3]));
    assert!(halt.angle.is_nan() && halt.curvature.is_nan());
    assert_eq!(halt.geometric_order(1.0, 9.0, 9.0), Some(0));
    // A tangent of which the velocity vanishes is still a tangent.
    let slow = first.joint(&Bezier::from_points([[1.0, 0.0], [1.0, 0.0], [2.0, 0.0]]));
    assert_eq!((slow.angle, slow.geometric_order(0.0, 0.0, 0.0)), (0.0, Some(1)));
}

fn two_segments() -> PiecewiseCurve<Curve<QuarticBernstein, [f64; 2]>> {
    let first =
        Curve::new(QuarticBernstein::new(0.5).unwrap(), [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    let contact = Contact::Parametric { order: 2 };
    let next = QuarticBernstein::new(-1.0).unwrap().curve_after(&first, contact, [[8.0, 3.0]; 4]).unwrap();
    PiecewiseCurve::new(vec![first, next]).unwrap()
}

#[test]
fn curves_are_put_behind_each_other() {
    let (mut whole, other) = (two_segments(), two_segments());
    whole.append(&other);
    assert_eq!(whole.domain(), [0.0, 4.0]);
    assert_eq!([whole.eval(0.75), whole.eval(2.75)], [other.eval(0.75); 2]);
    let (end, start) = (other.end(), other.start());
    assert_eq!(whole.joints()[1].gap, (end[0] - start[0]).hypot(end[1] - start[1]));
}

#[test]
fn one_parameter_runs_through_all_segments() {
    let curve = two_segments();
    let [first, second] = curve.segments() else { panic!("two segments") };
    assert_eq!(curve.domain(), [0.0, 2.0]);
    assert_eq!([curve.eval(0.0), curve.eval(0.25)], [first.start(), first.eval(0.25)]);
    assert_eq!([curve.eval(1.0), curve.eval(1.25)], [second.start(), second.eval(0.25)]);
    assert_eq!([curve.eval(2.0), curve.eval(2.5)], [second.end(), second.eval(1.5)]);
    assert_eq!([curve.eval(-1.0), curve.eval_clamped(-1.0)], [first.eval(-1.0), first.start()]);
    assert!(curve.eval(f64::NAN)[0].is_nan());
    assert!(curve.eval_checked(2.0).is_ok() && curve.eval_checked(2.1).is_err());
    assert!(curve.eval_checked(f64::NAN).is_err());
    assert_eq!(curve.eval_with_derivs::<3>(1.25), second.eval_with_derivs::<3>(0.25));
    assert_eq!(curve.continuity(1e-9, 1e-9, 1e-9), [Some(2)]);
    assert!(curve.samples(5).eq([0.0, 0.5, 1.0, 1.5, 2.0].map(|u| curve.eval(u))));
    assert_eq!(PiecewiseCurve::<Curve<QuarticBernstein, [f64; 2]>>::new(vec![]), Err(CurveError::NoSegments));
    // Derivatives are those with respect to the common parameter.
    let line = PiecewiseCurve::from(Curve::new(Linear::default(), [1.0_f64, 7.0]));
    let [point, velocity] = line.eval_with_derivs(0.5);
    assert!((point - 4.0_f64).abs() < 1e-14 && (velocity - 6.0_f64).abs() < 1e-14);
}

#[test]
fn questions_reach_all_segments() {
    let curve = two_segments();
    let length = curve.arclen(1e-10);
    let parts: f64 = curve.segments().iter().map(|segment| segment.arclen(1e-12)).sum();
    assert!((length - parts).abs() < 1e-10);
    for part in [0.1, 0.5, 0.9] {
        let u = curve.inv_arclen(part * length, 1e-10);
        let [before, after] = curve.split(u).unwrap();
        assert!((before.arclen(1e-10) - part * length).abs() < 1e-9);
        assert!((after.arclen(1e-10) - (1.0 - part) * length).abs() < 1e-9);
    }
    assert!(curve.inv_arclen(f64::NAN, 1e-9).is_nan());
    let points = curve.samples_by_arclen(9, 1e-10);
    assert_eq!([points[0], points[8]], [curve.start(), curve.end()]);
    for point in [[1.0, 1.0], [7.0, -3.0], [9.0, 9.0], [4.0, 0.0]] {
        let nearest = curve.nearest(point, 1e-10).unwrap();
        let distance = |p: [f64; 2]| (p[0] - point[0]).hypot(p[1] - point[1]);
        assert!((distance(curve.eval(nearest.at)) - nearest.distance).abs() < 1e-12);
        assert!(curve.samples(999).all(|p| nearest.distance <= distance(p) + 1e-10));
    }
    let [low, high] = curve.bounding_box();
    for p in curve.samples(999) {
        assert!((0..2).all(|d| low[d] <= p[d] + 1e-12 && p[d] <= high[d] + 1e-12));
    }
    let corners = curve.flatten(1e-3).unwrap();
    assert_eq!(corners.iter().filter(|&&corner| corner == curve.eval(1.0)).count(), 1);
    let back = curve.reversed();
    assert!(
        back.samples(7).zip(curve.samples(7).rev()).all(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-13)
    );
}

#[test]
fn infinite_segments() {
    let finite = Bezier::from_points([[0.0, 0.0], [1.0, 1.0]]);
    let infinite = Bezier::from_points([[1.0, 1.0], [f64::NAN, 2.0]]);
    let curve = PiecewiseCurve::new(vec![finite, infinite, finite]).unwrap();
    assert!(curve.arclen(1e-9).is_nan() && curve.inv_arclen(3.0, 1e-9).is_nan());
    assert_eq!(curve.nearest([0.0, 0.1], 1e-9), None);
    assert!(curve.bounding_box()[1][0].is_nan() && curve.bounding_box()[1][1] == 2.0);
    assert_eq!(curve.flatten(0.1), Err(CurveError::NotFinite));
    assert_eq!(curve.samples_by_arclen(4, 1e-9).len(), 4);
}
