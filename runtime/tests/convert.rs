//! Curves go to other crates and come back.
#![cfg(all(feature = "kurbo", feature = "lyon_geom"))]

use basis_runtime::{Bezier, Curve, CurveError, PiecewiseCurve};
use kurbo::{ParamCurve, ParamCurveArclen, Shape};
use lyon_geom::{CubicBezierSegment, QuadraticBezierSegment};

const POINTS: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];

#[test]
fn kurbo_and_back() {
    let curve = Bezier::from_points(POINTS);
    let cubic = kurbo::CubicBez::try_from(&curve).unwrap();
    assert_eq!(<(f64, f64)>::from(cubic.eval(0.25)), curve.eval(0.25).into());
    assert!((cubic.arclen(1e-9) - curve.arclen(1e-9)).abs() < 2e-9);
    let back: Bezier<kurbo::Point, 4> = cubic.into();
    assert_eq!(back.end(), kurbo::Point::new(4.0, 0.0));
    assert!((back.nearest(kurbo::Point::new(2.0, 9.0), 1e-9).unwrap().at - 0.5).abs() < 1e-15);
    // A lower degree is elevated, a higher one refused.
    let line = Bezier::from_points([[0.0, 0.0], [3.0, 6.0]]);
    let quadratic = kurbo::QuadBez::try_from(&line).unwrap();
    assert_eq!(quadratic.p1, kurbo::Point::new(1.5, 3.0));
    assert_eq!(Bezier::<kurbo::Point, 3>::from(quadratic).eval(0.5), kurbo::Point::new(1.5, 3.0));
    assert_eq!(kurbo::QuadBez::try_from(&curve), Err(CurveError::Degree { most: 2, found: 3 }));
    assert_eq!(kurbo::Line::try_from(&curve), Err(CurveError::Degree { most: 1, found: 3 }));
    let space = Bezier::from_points([[0.0_f64; 3]; 2]);
    assert_eq!(kurbo::Line::try_from(&space), Err(CurveError::Dimension { expected: 2, found: 3 }));
}

#[test]
fn a_path_of_segments() {
    let curve = Bezier::from_points(POINTS);
    let path =
        kurbo::BezPath::try_from(&PiecewiseCurve::new(vec![curve, curve.reversed()]).unwrap()).unwrap();
    assert_eq!(path.segments().count(), 2);
    assert!((path.perimeter(1e-9) - 2.0 * curve.arclen(1e-9)).abs() < 4e-9);
    let high = PiecewiseCurve::from(Bezier::from_points([
        [0.0, 0.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [4.0, 0.0],
        [5.0, 1.0],
    ]));
    assert_eq!(kurbo::BezPath::try_from(&high), Err(CurveError::Degree { most: 3, found: 4 }));
}

/// What counts is the degree of the curve, not the one that its family can have.
#[test]
fn curves_of_a_lower_degree_than_their_family() {
    let cubic = Bezier::from_points(POINTS);
    let back = kurbo::CubicBez::try_from(&cubic.elevate::<9>()).unwrap();
    for (found, expected) in [back.p0, back.p1, back.p2, back.p3].into_iter().zip(POINTS) {
        assert!((found - kurbo::Point::from(<(f64, f64)>::from(expected))).hypot() < 1e-12, "{back:?}");
    }
    let parabola = Bezier::from_points([[0.0, 1.0], [1.0, 2.0], [5.0, 0.0]]);
    let raised = kurbo::QuadBez::try_from(&parabola.elevate::<5>()).unwrap();
    assert!((raised.p1 - kurbo::Point::new(1.0, 2.0)).hypot() < 1e-14);
    assert_eq!((raised.p0, raised.p2), (kurbo::Point::new(0.0, 1.0), kurbo::Point::new(5.0, 0.0)));
    assert!(QuadraticBezierSegment::try_from(&parabola.elevate::<4>()).is_ok());
    // The degree that is found is the one of the curve.
    assert_eq!(
        kurbo::QuadBez::try_from(&cubic.elevate::<7>()),
        Err(CurveError::Degree { most: 2, found: 3 })
    );
    // A change that is small, but no rounding error, is not lost.
    let mut bent = cubic.elevate::<5>().to_bernstein();
    bent[2][1] += 1e-12;
    assert_eq!(
        kurbo::CubicBez::try_from(&Bezier::from_points(bent)),
        Err(CurveError::Degree { most: 3, found: 4 })
    );
    let wild = Bezier::from_points([[f64::NAN, 0.0], [0.0, 1.0], [f64::MAX, 1.0], [0.0, 0.0], [1.0, 1.0]]);
    assert!(kurbo::CubicBez::try_from(&wild).is_err());
}

#[test]
fn lyon_and_back() {
    let curve = Bezier::from_points(POINTS.map(|p| p.map(|c| c as f32)));
    let cubic = CubicBezierSegment::try_from(&curve).unwrap();
    assert_eq!(cubic.sample(0.25).to_array(), curve.eval(0.25));
    let back: Bezier<lyon_geom::Point<f32>, 4> = cubic.into();
    assert_eq!(back.eval(0.5), lyon_geom::point(2.0, 1.5));
    let parabola = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0_f64]]);
    let quadratic = QuadraticBezierSegment::try_from(&parabola).unwrap();
    assert_eq!(quadratic.sample(0.5).to_array(), [1.0, 1.0]);
    assert_eq!(
        Bezier::<lyon_geom::Point<f64>, 3>::from(quadratic).bounding_box()[1],
        lyon_geom::point(2.0, 1.0)
    );
    assert!(lyon_geom::LineSegment::try_from(&parabola).is_err());
}

/// Curves of a higher degree become cubics within a tolerance.
#[test]
fn kurbo_fits_cubics() {
    basis_runtime::basis! {
        family Shifted {
            domain 1 <= x <= 3;
            b[0] = ((3 - x)/2)^4;
            b[1] = 4*((x - 1)/2)*((3 - x)/2)^3;
            b[2] = 6*((x - 1)/2)^2*((3 - x)/2)^2;
            b[3] = 4*((x - 1)/2)^3*((3 - x)/2);
            b[4] = ((x - 1)/2)^4;
            prove partition_of_unity;
        }
    }
    let corners = [(0.0, 0.0), (0.0, 2.0), (3.0, 3.0), (4.0, 0.0), (6.0, 1.0)].map(kurbo::Point::from);
    let curve = Curve::new(Shifted::new(), corners);
    for tolerance in [1e-2, 1e-4, 1e-6] {
        let path = kurbo::fit_to_bezpath(&curve, tolerance);
        let cubics: Vec<kurbo::PathSeg> = path.segments().collect();
        let ends = [cubics[0].start(), cubics[cubics.len() - 1].end()];
        assert!((ends[0] - curve.start()).hypot() < 1e-14 && (ends[1] - curve.end()).hypot() < 1e-14);
        for cubic in &cubics {
            for step in 0..=20 {
                let there = curve.nearest(cubic.eval(f64::from(step) / 20.0), 1e-12).unwrap();
                assert!(there.distance <= 1.01 * tolerance, "{tolerance}: {cubic:?} {there:?}");
            }
        }
    }
    // (t², t³) over -1..1, its degree raised: no cubic with a tangent passes through the cusp.
    let cusp = Bezier::from_points(
        [(1.0, -1.0), (-1.0 / 3.0, 1.0), (-1.0 / 3.0, -1.0), (1.0, 1.0)].map(kurbo::Point::from),
    );
    let path = kurbo::fit_to_bezpath(&cusp.elevate::<5>(), 1e-6);
    let ends: Vec<kurbo::Point> = path.segments().map(|segment| segment.end()).collect();
    assert!(ends.iter().any(|end| end.to_vec2().hypot() < 1e-9), "{ends:?}");
    assert!(ends.len() <= 4, "{ends:?}");
}
