//! Curves of segments of different families and degrees.

use core::fmt::Debug;

use basis_runtime::bspline::BSplineCurve;
use basis_runtime::{
    AnyCurve, BernsteinBasis, Bezier, Contact, Curve, CurveError, JoinableCurve, ParametricCurve, Path,
    PiecewiseCurve, RationalBezier, basis,
};

use crate::queries::{Plain, against_samples};
use crate::random::Random;

basis!("../../../specs/quartic.basis");
basis!("../../../specs/trigonometric/end_angle.basis", CBezierQuadratic);

type P2 = [f64; 2];
type Mixed = PiecewiseCurve<AnyCurve<P2>>;

fn quartic() -> Curve<QuarticBernstein, P2> {
    Curve::new(QuarticBernstein::new(0.5).unwrap(), [[0.0, 0.0], [0.4, 0.9], [1.0, 1.1], [1.5, 0.5]])
}

/// A quartic of one family, half of a parabola, the curve `third` and a spline of two spans, each G1 behind the one
/// before.
fn with_third<C>(third: &C) -> Mixed
where
    C: JoinableCurve<Point = P2> + Debug + Send + Sync + 'static,
    C::Part: ParametricCurve<Part = C::Part> + Debug + Send + Sync,
{
    let first = quartic();
    let contact = Contact::Tangent { f: 2.0 };
    let parabola = first.continued(contact, &Bezier::from_points([[0.0; 2], [0.0; 2], [2.0, -1.0]])).unwrap();
    let third = parabola.continued(contact, third).unwrap();
    let spline = BSplineCurve::from_bezier(vec![[0.0; 2], [0.0; 2], [-0.5, 0.2], [0.3, 0.3]]).unwrap();
    let spline = third.continued(contact, &spline.insert_knots(&[0.5]).unwrap()).unwrap();
    let segments =
        [AnyCurve::new(first), AnyCurve::new(parabola), AnyCurve::new(third), AnyCurve::new(spline)];
    PiecewiseCurve::new(segments.to_vec()).unwrap()
}

/// With sines over an angle of 2.
fn mixed() -> Mixed {
    with_third(&CBezierQuadratic::new(2.0).unwrap().curve([[0.0; 2], [0.0; 2], [1.0, -1.5]]))
}

/// With a quotient of polynomials, whose parts keep the parameter.
fn rational() -> Mixed {
    let conic = RationalBezier::new([[0.0; 2], [0.0; 2], [1.0, -1.5]], [1.0, 0.6, 1.0]).unwrap();
    with_third(&conic.with_domain([0.0, 2.0]))
}

fn distance(a: P2, b: P2) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn every_segment_has_its_own_formula() {
    let curve = mixed();
    assert_eq!(curve.domain(), [0.0, 4.0]);
    assert_eq!(curve.continuity(1e-12, 1e-9, 1e-9), [Some(1); 3]);
    for (k, segment) in curve.segments().iter().enumerate() {
        let [lo, hi] = segment.domain();
        let u = k as f64 + 0.25;
        let t = lo + 0.25 * (hi - lo);
        assert_eq!(curve.locate(u), (k, t));
        assert_eq!(curve.eval(u), segment.eval(t));
        let ([point, velocity], [_, own]) = (curve.eval_with_derivs(u), segment.eval_with_derivs(t));
        assert_eq!(point, segment.eval(t));
        assert_eq!(velocity, own.map(|c: f64| c * (hi - lo)));
        assert_eq!([curve.eval(k as f64), curve.eval(4.0)], [segment.start(), curve.end()]);
    }
    assert_eq!(curve.segments()[0].downcast_ref(), Some(&quartic()));
    assert!(curve.segments()[1].downcast_ref::<Curve<QuarticBernstein, P2>>().is_none());
    assert!(format!("{curve:?}").contains("QuarticBernstein"));
}

#[test]
fn parameters_outside_are_refused() {
    let curve = mixed();
    for u in [-1e-9, 4.000_001, f64::NAN, f64::INFINITY] {
        assert!(matches!(curve.eval_checked(u), Err(CurveError::Parameter { .. })), "{u}");
        assert!(matches!(curve.split(u), Err(CurveError::Parameter { .. })), "{u}");
        assert!(matches!(curve.subsegment(1.0..u), Err(CurveError::Parameter { .. })), "{u}");
    }
    assert!(curve.eval_checked(4.0).is_ok());
    assert!(matches!(curve.split(4.0), Err(CurveError::AtEnd { .. })));
    assert!(matches!(curve.subsegment(1.0..1.0), Err(CurveError::EmptyRange { .. })));
    assert_eq!(Mixed::new(vec![]).err(), Some(CurveError::NoSegments));
}

#[test]
fn a_split_at_a_joint_cuts_nothing() {
    let curve = mixed();
    for k in 1..4 {
        let [before, after] = curve.split(k as f64).unwrap();
        assert_eq!([before.segments().len(), after.segments().len()], [k, 4 - k]);
        for (i, segment) in before.segments().iter().chain(after.segments()).enumerate() {
            assert_eq!(segment.domain(), curve.segments()[i].domain());
            assert!((0..9).all(|j| {
                let t = segment.domain()[1] * f64::from(j) / 8.0;
                segment.eval(t) == curve.segments()[i].eval(t)
            }));
        }
        assert_eq!(before.segments()[0].downcast_ref(), Some(&quartic()));
    }
    let [before, after] = curve.split(2.5).unwrap();
    assert_eq!([before.segments().len(), after.segments().len()], [3, 2]);
    assert_eq!((before.start(), after.end()), (curve.start(), curve.end()));
    let at = curve.eval(2.5);
    assert!(distance(before.end(), at) < 1e-14 && distance(after.start(), at) < 1e-14);
    // From joint to joint, and backwards.
    let part = curve.subsegment(1.0..3.0).unwrap();
    assert_eq!((part.segments().len(), part.start(), part.end()), (2, curve.eval(1.0), curve.eval(3.0)));
    let back = curve.subsegment(3.5..0.5).unwrap();
    assert_eq!(back.segments().len(), 4);
    assert!(distance(back.start(), curve.eval(3.5)) < 1e-14 && distance(back.end(), curve.eval(0.5)) < 1e-14);
    let reversed = curve.reversed();
    assert!((reversed.arclen(1e-12) - curve.arclen(1e-12)).abs() < 1e-11);
    assert!([0.0, 1.0, 2.0, 3.0, 4.0].iter().all(|&u| reversed.eval(u) == curve.eval(4.0 - u)));
}

#[test]
fn all_questions() {
    let random = &mut Random::new(2611);
    let curve = rational();
    against_samples(&curve, random);
    against_samples(&Plain(curve.clone()), random);
    against_samples(&curve.split(2.3).unwrap()[1], random);
    // As segments of another curve, and of two arcs of one type.
    let part = curve.subsegment(1.5..2.5).unwrap();
    let twice = PiecewiseCurve::new(vec![part.clone(), part.reversed()]).unwrap();
    against_samples(&twice, random);
    let half = 0.5_f64.sqrt();
    let arc = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, half, 1.0]).unwrap();
    let arcs = PiecewiseCurve::new(vec![arc.clone(), arc.map(|[x, y]| [-y, x])]).unwrap();
    assert_eq!(arcs.continuity(1e-12, 1e-12, 1e-12), [Some(2)]);
    assert!((arcs.arclen(1e-12) - core::f64::consts::PI).abs() < 1e-12);
    against_samples(&arcs, random);
}

#[test]
fn places_of_segments_over_angles_are_parameters() {
    let sines = CBezierQuadratic::new(2.0).unwrap().curve([[0.0; 2], [0.7, 0.8], [1.0, -0.5]]);
    let curve = PiecewiseCurve::from(AnyCurve::new(sines));
    let half = curve.first_where(0, sines.eval(0.6)[0]).unwrap();
    assert!(distance(half, sines.eval(0.6)) < 1e-12);
    let near = curve.nearest(sines.eval(1.7), 1e-12).unwrap();
    assert!((near.at - 0.85).abs() < 1e-6 && near.distance < 1e-12);
    let length = sines.split(0.6).unwrap()[0].arclen(1e-12);
    assert!((curve.inv_arclen(length, 1e-12) - 0.3).abs() < 1e-9);
}

#[test]
fn images() {
    let curve = mixed();
    // Far away, where a translation of unit vectors would lose digits.
    let map = |[x, y]: P2| [1e6 + 2.0 * x - y, x + 3.0 * y - 1e6, 0.5 * x];
    let image = curve.map(map);
    for i in 0..=40 {
        let u = f64::from(i) / 10.0;
        let (found, expected) = (image.eval(u), map(curve.eval(u)));
        assert!((0..3).all(|d| (found[d] - expected[d]).abs() < 1e-9), "{found:?} {expected:?}");
        let ([_, found], [_, [x, y]]) = (image.eval_with_derivs::<2>(u), curve.eval_with_derivs::<2>(u));
        let expected = [2.0 * x - y, x + 3.0 * y, 0.5 * x];
        assert!((0..3).all(|d| (found[d] - expected[d]).abs() < 1e-8), "{found:?} {expected:?}");
    }
    let turn = [[0.0, -1.0], [1.0, 0.0]];
    let turned = curve.transform(&turn);
    assert!((turned.arclen(1e-12) - curve.arclen(1e-12)).abs() < 1e-11);
    assert_eq!(turned.joints().iter().map(|joint| joint.gap).fold(0.0, f64::max), 0.0);
    assert_eq!(turned.split(2.0).unwrap()[1].segments().len(), 2);
    against_samples(&rational().transform(&turn), &mut Random::new(2612));
}

#[test]
fn of_one_family_or_into_a_path() {
    let family = Curve::new(BernsteinBasis::<f64, 3>::new(), [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
    let piecewise = PiecewiseCurve::new(vec![family, family.map(|[x, y]| [x + 2.0, y])]).unwrap();
    let shared = piecewise.segments().iter().map(|&segment| AnyCurve::new(segment)).collect();
    let shared = PiecewiseCurve::new(shared).unwrap();
    assert!((0..=20).all(|i| shared.eval(f64::from(i) / 10.0) == piecewise.eval(f64::from(i) / 10.0)));
    let path = Path::from_curve(&mixed());
    assert_eq!(path.segments().len(), 5);
    assert!((path.arclen(1e-12) - mixed().arclen(1e-12)).abs() < 1e-11);
    // Whatever the segments are, the ends can be moved if those of the segments can.
    let moved = family.continued(Contact::Parametric { order: 1 }, &piecewise).unwrap();
    assert_eq!(family.joint(&moved).parametric_order(1e-12, [1e-12; 3]), Some(1));
}
