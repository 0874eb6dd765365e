//! Surfaces from curves, against their formulas.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use basis_runtime::bspline::{
    BSplineCurve, BSplineSurface, ConstructionError, FitError, KnotVector, NurbsCurve, NurbsSurface, Spacing,
};
use basis_runtime::{CurveError, ParametricCurve, Surface};
use proptest::prelude::*;

use super::support::{P3, curve_of, distance, point};

fn plus(a: P3, b: P3, factor: f64) -> P3 {
    [0, 1, 2].map(|d| a[d] + factor * b[d])
}

/// Places in the unit square.
fn places() -> impl Iterator<Item = (f64, f64)> {
    (0..=6).flat_map(|i| (0..=6).map(move |j| (f64::from(i) / 6.0, f64::from(j) / 6.0)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn extruded_ruled_and_translated(a in curve_of(3), b in curve_of(2), along in point()) {
        let wall = BSplineSurface::extruded(&a, along).unwrap();
        let lines = BSplineSurface::ruled(&a, &b).unwrap();
        let moved = BSplineSurface::translated(&a, &b).unwrap();
        for (u, v) in places() {
            prop_assert!(distance(wall.eval(u, v), plus(a.eval(u), along, v)) < 1e-12);
            let between = plus(plus([0.0; 3], a.eval(u), 1.0 - v), b.eval(u), v);
            prop_assert!(distance(lines.eval(u, v), between) < 1e-11);
            let there = plus(plus(a.eval(u), b.eval(v), 1.0), b.start(), -1.0);
            prop_assert!(distance(moved.eval(u, v), there) < 1e-11);
        }
    }

    #[test]
    fn lofted_surfaces_pass_through_their_sections(
        a in curve_of(3), b in curve_of(2), c in curve_of(1), d in curve_of(3), degree in 1..4_usize,
    ) {
        let sections = [a, b, c, d];
        let surface = BSplineSurface::lofted(&sections, degree, Spacing::Uniform).unwrap();
        prop_assert_eq!(surface.degrees(), [3, degree]);
        for (k, section) in sections.iter().enumerate() {
            for i in 0..=10 {
                let u = f64::from(i) / 10.0;
                prop_assert!(distance(surface.eval(u, k as f64 / 3.0), section.eval(u)) < 1e-10);
            }
        }
    }

    #[test]
    fn coons_by_its_formula(a in curve_of(3), b in curve_of(2), c in curve_of(1), d in curve_of(3)) {
        // The ends of the curves along v are pulled to those of the curves along u.
        let between = |curve: &BSplineCurve<P3>, from: P3, to: P3| {
            let mut curve = curve.clamped();
            let points = curve.control_points_mut();
            let last = points.len() - 1;
            (points[0], points[last]) = (from, to);
            curve
        };
        let [a, b] = [a.clamped(), b.clamped()];
        let (c, d) = (between(&c, a.start(), b.start()), between(&d, a.end(), b.end()));
        let surface = BSplineSurface::coons([&a, &b], [&c, &d], 1e-9).unwrap();
        for (u, v) in places() {
            let lines_v = plus(plus([0.0; 3], a.eval(u), 1.0 - v), b.eval(u), v);
            let lines_u = plus(plus([0.0; 3], c.eval(v), 1.0 - u), d.eval(v), u);
            let low = plus(plus([0.0; 3], a.start(), 1.0 - u), a.end(), u);
            let high = plus(plus([0.0; 3], b.start(), 1.0 - u), b.end(), u);
            let expected = plus(plus(plus(lines_v, lines_u, 1.0), low, v - 1.0), high, -v);
            prop_assert!(distance(surface.eval(u, v), expected) < 1e-10);
        }
    }
}

#[test]
fn domains_are_mapped_to_the_first() {
    let a = BSplineCurve::new(
        KnotVector::clamped(1, &[2.0, 3.0, 6.0]).unwrap(),
        [[0.0; 2], [1.0, 0.0], [2.0, 1.0]],
    )
    .unwrap();
    let b = BSplineCurve::from_bezier([[0.0, 1.0], [1.0, 3.0], [2.0, 2.0]]).unwrap();
    let surface = BSplineSurface::ruled(&a, &b).unwrap();
    assert_eq!(surface.domain().ranges(), [[2.0, 6.0], [0.0, 1.0]]);
    assert_eq!(surface.eval(3.0, 0.0), a.eval(3.0));
    let [found, expected]: [[f64; 2]; 2] = [surface.eval(4.0, 1.0), b.eval(0.5)];
    assert!((0..2).all(|d| (found[d] - expected[d]).abs() < 1e-15));
}

#[test]
fn corners_that_do_not_meet_are_named() {
    let line = |a: P3, b: P3| BSplineCurve::from_bezier([a, b]).unwrap();
    let corners = [[[0.0; 3], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 1.0]]];
    let [a, b] = [0, 1].map(|v| line(corners[0][v], corners[1][v]));
    let [c, d] = [0, 1].map(|u| line(corners[u][0], corners[u][1]));
    assert!(BSplineSurface::coons([&a, &b], [&c, &d], 0.0).is_ok());
    let error = BSplineSurface::coons([&a, &b], [&c, &d.map(|p| plus(p, p, 0.5))], 1e-3).unwrap_err();
    assert_eq!(error, ConstructionError::Corner { corner: [1, 0], gap: 0.5 });
    assert_eq!(
        error.to_string(),
        "the boundary curves at the corner u = 1, v = 0 are 0.5 apart: they should end in one point there"
    );
}

#[test]
fn a_sweep_along_a_circle_comes_near_to_a_torus() {
    let weights = [1.0, FRAC_1_SQRT_2, 1.0];
    let quarter: NurbsCurve<P3> = NurbsCurve::new(
        KnotVector::uniform(2, 1).unwrap(),
        [[3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]],
        weights,
    )
    .unwrap();
    let profile = BSplineCurve::from_bezier([[0.5, 0.0, 0.0], [0.5, 1.0, 0.0], [-0.5, 0.7, 0.0]]).unwrap();
    let error = |count: usize| {
        let surface = BSplineSurface::swept(&profile, &quarter, count, Some([1.0, 0.0, 0.0])).unwrap();
        let mut worst = 0.0_f64;
        for (u, v) in places() {
            // Turned back to the plane of the axis it is the profile.
            let [x, y, z] = surface.eval(u, (v * 5.3).fract());
            let [along, across, _] = profile.eval(u);
            worst = worst.max((x.hypot(y) - 3.0 - along).hypot(z.abs() - across.abs()));
        }
        worst
    };
    let [few, many] = [error(9), error(17)];
    assert!(few < 1e-3 && few / many > 10.0, "{few} {many}");
    // Along a straight line it is exact.
    let line = BSplineCurve::from_bezier([[0.0; 3], [0.0, 0.0, 4.0]]).unwrap();
    let straight = BSplineSurface::swept(&profile, &line, 5, Some([1.0, 0.0, 0.0])).unwrap();
    for (u, v) in places() {
        let [along, across, _] = profile.eval(u);
        assert!(distance(straight.eval(u, v), [along, across, 4.0 * v]) < 1e-13);
    }
    let error = BSplineSurface::swept(&profile, &line, 1, None).unwrap_err();
    assert_eq!(error, ConstructionError::Fit(FitError::TooFew { needed: 2, found: 1 }));
    assert!(BSplineSurface::swept(&profile, &line, usize::MAX, None).is_err());
}

#[test]
fn cylinders_and_cones_are_exact() {
    let half = [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0]).unwrap();
    let arc = NurbsCurve::new(knots, half, [1.0, FRAC_1_SQRT_2, 1.0, FRAC_1_SQRT_2, 1.0]).unwrap();
    let cylinder = NurbsSurface::extruded(&arc, [0.0, 0.0, 2.0]).unwrap();
    let cone = NurbsSurface::ruled(&arc, &arc.map(|_| [0.0, 0.0, 1.0])).unwrap();
    for (u, v) in places() {
        let [x, y, z] = cylinder.eval(2.0 * u, v);
        assert!((x.hypot(y) - 1.0).abs() < 1e-15 && (z - 2.0 * v).abs() < 1e-15);
        let [x, y, z] = cone.eval(2.0 * u, v);
        assert!((x.hypot(y) + z - 1.0).abs() < 1e-15);
        let normal = cylinder.normal(2.0 * u, v).unwrap();
        assert!(normal[2].abs() < 1e-15);
    }
    assert!((arc.arclen(1e-10) - PI).abs() < 1e-9);
}

#[test]
fn affine_maps_of_rational_surfaces() {
    let map = |[x, y, z]: P3| [x + 2.0 * y - 1.0, y - z + 3.0, 0.5 * z + x];
    let arc = NurbsCurve::new(
        KnotVector::uniform(2, 1).unwrap(),
        [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]],
        [1.0, FRAC_1_SQRT_2, 2.0],
    )
    .unwrap();
    let turned = NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], 3.0).unwrap();
    for (u, v) in places() {
        assert!(distance(arc.map(map).eval(u), map(arc.eval(u))) < 1e-14);
        assert!(distance(turned.map(map).eval(u, 3.0 * v), map(turned.eval(u, 3.0 * v))) < 1e-14);
    }
    // Also with a control point at infinity.
    let generatrix = basis_runtime::Bezier::from_points([[1.0, 0.0, 0.0], [2.0, 0.0, 1.0], [1.0, 0.0, 3.0]]);
    let vase = basis_runtime::SurfaceOfRevolution::new(&generatrix, [0.0; 3], [0.0, 0.0, 1.0], PI).unwrap();
    let whole = vase.half_turns()[0];
    for (u, v) in places() {
        assert!(distance(whole.map(map).eval(u, v), map(whole.eval(u, v))) < 1e-13);
    }
}

/// What is not finite makes no surface, whichever construction is asked.
#[test]
fn control_points_that_are_not_finite() {
    let line = |a: P3, b: P3| BSplineCurve::from_bezier([a, b]).unwrap();
    let good = line([0.0; 3], [1.0, 0.0, 0.0]);
    let far = line([0.0, f64::MAX, 0.0], [1.0, f64::MAX, 0.0]);
    let path = line([0.0; 3], [0.0, 0.0, 1.0]);
    for value in [f64::NAN, f64::INFINITY] {
        let bad = line([0.0, value, 0.0], [1.0, 0.0, 0.0]);
        let rational = |curve: &BSplineCurve<P3>| {
            NurbsCurve::new(curve.knots().clone(), curve.control_points(), [1.0, 1.0]).unwrap()
        };
        let (good_arc, bad_arc) = (rational(&good), rational(&bad));
        let polynomial = [
            BSplineSurface::extruded(&good, [value, 0.0, 0.0]),
            BSplineSurface::extruded(&bad, [0.0, 1.0, 0.0]),
            BSplineSurface::extruded(&far, [0.0, f64::MAX, 0.0]),
            BSplineSurface::ruled(&good, &bad),
            BSplineSurface::translated(&good, &bad),
            BSplineSurface::translated(&bad, &path),
            BSplineSurface::lofted(&[good.clone(), bad.clone()], 1, Spacing::Uniform),
            BSplineSurface::swept(&bad, &path, 3, None),
            BSplineSurface::coons([&good, &bad], [&path, &path], f64::INFINITY),
        ];
        let rational = [
            NurbsSurface::extruded(&good_arc, [value, 0.0, 0.0]),
            NurbsSurface::ruled(&good_arc, &bad_arc),
            NurbsSurface::translated(&good_arc, &bad_arc),
            NurbsSurface::lofted(&[good_arc.clone(), bad_arc.clone()], 1, Spacing::Uniform),
            NurbsSurface::swept(&bad_arc, &path, 3, None),
        ];
        for (i, found) in polynomial.into_iter().enumerate() {
            assert!(found.is_err(), "{value} {i}");
        }
        for (i, found) in rational.into_iter().enumerate() {
            assert!(found.is_err(), "{value} {i}");
        }
    }
    let error = BSplineSurface::extruded(&good, [f64::NAN, 0.0, 0.0]).unwrap_err();
    assert_eq!(error, ConstructionError::Curve(CurveError::NotFinite));
}
