//! Surfaces from rational curves: circles, and random curves with weights.

use basis_runtime::bspline::{ConstructionError, KnotVector, NurbsCurve, NurbsSurface, Spacing, SplineError};
use basis_runtime::{Bezier, ParametricCurve};
use proptest::prelude::*;

use super::support::{P3, curve_of, distance};

/// An arc of less than half a turn about the z axis, as one rational quadratic; all weights are multiplied by `scale`, and
/// `skew` changes the parameter but not the points.
fn arc(radius: f64, z: f64, [from, to]: [f64; 2], scale: f64, skew: f64) -> NurbsCurve<P3> {
    let half = (to - from) / 2.0;
    let at = |angle: f64, r: f64| [r * angle.cos(), r * angle.sin(), z];
    let points = [at(from, radius), at(from + half, radius / half.cos()), at(to, radius)];
    let weights = [scale, scale * skew * half.cos(), scale * skew * skew];
    NurbsCurve::new(KnotVector::uniform(2, 1).unwrap(), points, weights).unwrap()
}

fn rational(degree: usize) -> impl Strategy<Value = NurbsCurve<P3>> {
    curve_of(degree).prop_flat_map(|curve| {
        let count = curve.control_points().len();
        prop::collection::vec(0.4..2.5_f64, count).prop_map(move |weights| {
            NurbsCurve::new(curve.knots().clone(), curve.control_points(), weights).unwrap()
        })
    })
}

fn places() -> impl Iterator<Item = (f64, f64)> {
    (0..=6).flat_map(|i| (0..=6).map(move |j| (f64::from(i) / 6.0, f64::from(j) / 6.0)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn translated(a in rational(3), b in rational(2)) {
        let surface = NurbsSurface::translated(&a, &b).unwrap();
        let [lo, hi] = b.domain();
        let [first, last] = a.domain();
        for (u, v) in places() {
            let (u, v) = (first + u * (last - first), lo + v * (hi - lo));
            let (p, q, start) = (a.eval(u), b.eval(v), b.start());
            let expected = [0, 1, 2].map(|d| p[d] + q[d] - start[d]);
            prop_assert!(distance(surface.eval(u, v), expected) < 1e-10);
        }
    }

    #[test]
    fn lofted_passes_through_the_sections(a in rational(3), b in rational(2), c in rational(1)) {
        // Of degree 1 weights between positive ones are positive.
        let sections = [a, b, c];
        let surface = NurbsSurface::lofted(&sections, 1, Spacing::Uniform).unwrap();
        let [first, last] = sections[0].domain();
        for (k, section) in sections.iter().enumerate() {
            let [lo, hi] = section.domain();
            for i in 0..=10 {
                let s = f64::from(i) / 10.0;
                let found = surface.eval(first + s * (last - first), k as f64 / 2.0);
                prop_assert!(distance(found, section.eval(lo + s * (hi - lo))) < 1e-9);
            }
        }
    }
}

#[test]
fn arcs_of_the_same_angle_are_lofted_to_a_surface_of_revolution() {
    let quarter = [0.1, 1.5];
    // z = 0, 1, 2, 3 and r = 1 + z(3 − z)/4 lie on a parabola; the weights of the sections differ by a factor.
    let sections =
        [0.0, 1.0, 2.0, 3.0].map(|z: f64| arc(1.0 + z * (3.0 - z) / 4.0, z, quarter, 1.0 + z * z, 1.0));
    let surface = NurbsSurface::lofted(&sections, 3, Spacing::Uniform).unwrap();
    for (u, v) in places() {
        let [x, y, z] = surface.eval(u, v);
        assert!((x.hypot(y) - 1.0 - z * (3.0 - z) / 4.0).abs() < 1e-12, "({u}, {v})");
    }
}

#[test]
fn weights_that_a_loft_makes_negative_are_refused() {
    let sections = [1.0, 1.0, 20.0, 1.0, 1.0]
        .iter()
        .zip(0..)
        .map(|(&skew, k)| arc(1.0, f64::from(k), [0.0, 1.0], 1.0, skew))
        .collect::<Vec<_>>();
    let error = NurbsSurface::lofted(&sections, 3, Spacing::Uniform).unwrap_err();
    assert!(matches!(error, ConstructionError::Spline(SplineError::Weight { .. })), "{error}");
    assert!(NurbsSurface::lofted(&sections, 1, Spacing::Uniform).is_ok());
    assert!(NurbsSurface::<P3>::lofted(&[], 1, Spacing::Uniform).is_err());
}

#[test]
fn coons_keeps_circles_with_unequal_weights_as_boundaries() {
    // A ring of a quarter of a turn: two arcs, the outer one higher, and two curves between them, each with a parameter of
    // its own.
    let angles = [0.0, 1.5];
    let (inner, outer) = (arc(1.0, 0.0, angles, 3.0, 1.7), arc(2.0, 1.0, angles, 1.0, 0.6));
    let side = |angle: f64, weights: [f64; 3]| {
        let at = |r: f64, z: f64| [r * angle.cos(), r * angle.sin(), z];
        let points = [at(1.0, 0.0), at(1.6, -0.4), at(2.0, 1.0)];
        NurbsCurve::new(KnotVector::uniform(2, 1).unwrap(), points, weights).unwrap()
    };
    let sides = [side(0.0, [1.0, 0.8, 2.0]), side(1.5, [5.0, 1.0, 1.0])];
    let surface = NurbsSurface::coons([&inner, &outer], [&sides[0], &sides[1]], 1e-12).unwrap();
    for i in 0..=50 {
        let s = f64::from(i) / 50.0;
        for (v, radius, height) in [(0.0, 1.0, 0.0), (1.0, 2.0, 1.0)] {
            let [x, y, z] = surface.eval(s, v);
            assert!((x.hypot(y) - radius).abs() < 1e-12 && (z - height).abs() < 1e-12);
        }
        for (u, side) in [(0.0, &sides[0]), (1.0, &sides[1])] {
            let point = surface.eval(u, s);
            assert!(side.nearest(point, 1e-10).unwrap().distance < 1e-9, "({u}, {s})");
        }
    }
    let apart = NurbsSurface::coons([&inner, &outer], [&sides[1], &sides[0]], 1e-12).unwrap_err();
    assert!(matches!(apart, ConstructionError::Corner { corner: [0, 0], .. }), "{apart}");
}

#[test]
fn a_circle_swept_along_a_curve_is_a_tube() {
    let path = Bezier::from_points([[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [6.0, 6.0, 4.0], [0.0, 8.0, 4.0]]);
    let profile = arc(0.5, 0.0, [0.0, 1.5], 2.0, 1.3);
    let tube = NurbsSurface::swept(&profile, &path, 40, None).unwrap();
    for (u, v) in places() {
        let gap = path.nearest(tube.eval(u, v), 1e-12).unwrap().distance;
        assert!((gap - 0.5).abs() < 1e-4, "({u}, {v}): {gap}");
    }
}
