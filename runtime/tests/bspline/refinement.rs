//! Insertion, removal, elevation, splitting, extraction and merging: none of them moves a point.

use basis_runtime::CurveError;
use basis_runtime::bspline::{BSplineCurve, KnotError, KnotVector};
use proptest::prelude::*;

use crate::support::{curve, curve_of, distance, largest_distance, parameters};

const ROUNDING: f64 = 1e-12; // control points are up to 10

#[test]
fn exact_in_binary_fractions() {
    let knots = KnotVector::new(2, [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]).unwrap();
    let curve = BSplineCurve::new(knots, [0.0, 4.0, 8.0, 4.0]).unwrap();
    let finer = curve.insert_knots(&[1.0, 0.5, 0.5]).unwrap();
    assert_eq!(finer.knots().as_slice(), [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 2.0, 2.0, 2.0]);
    assert_eq!(finer.control_points(), [0.0, 2.0, 3.5, 5.0, 6.0, 8.0, 4.0]);
    for i in 0..=64 {
        let t = f64::from(i) / 32.0;
        assert_eq!(finer.eval(t), curve.eval(t));
    }
    let (back, removed) = finer.remove_knot(0.5, 2, 0.0).unwrap();
    assert_eq!(removed, 2);
    let (back, removed) = back.remove_knot(1.0, 1, 0.0).unwrap();
    assert_eq!((removed, &back), (1, &curve));
    // What is left is a knot at which the second derivative jumps.
    assert_eq!(back.remove_knot(1.0, 1, 0.0).unwrap().1, 0);
}

#[test]
fn a_line_stays_exactly_itself() {
    let line = BSplineCurve::from_bezier([3.0, 3.0, 3.0]).unwrap();
    let many = line.insert_knots(&[0.1, 0.3, 0.3, 0.7]).unwrap().elevate().unwrap().elevate().unwrap();
    assert!(many.control_points().iter().all(|&p| p == 3.0));
}

#[test]
fn bezier_elevation_has_the_known_points() {
    let curve = BSplineCurve::from_bezier([0.0, 3.0, 6.0, 12.0]).unwrap();
    assert_eq!(curve.elevate().unwrap().control_points(), [0.0, 2.25, 4.5, 7.5, 12.0]);
}

#[test]
fn what_cannot_be_inserted_or_removed() {
    let curve = BSplineCurve::new(KnotVector::uniform(2, 2).unwrap(), [0.0, 1.0, 2.0, 3.0]).unwrap();
    let excess = KnotError::Multiplicity { knot: 0.5, multiplicity: 4, degree: 2 };
    assert_eq!(curve.insert_knots(&[0.5; 3]), Err(excess));
    assert_eq!(curve.insert_knots(&[0.5; 2]).unwrap().control_points().len(), 6);
    assert!(matches!(curve.insert_knots(&[0.0]), Err(KnotError::Multiplicity { .. })));
    assert!(matches!(curve.insert_knots(&[0.2, f64::NAN]), Err(KnotError::Outside { .. })));
    assert_eq!(curve.remove_knot(0.4, 1, 1.0), Err(KnotError::NoInnerKnot { parameter: 0.4 }));
    assert_eq!(curve.remove_knot(0.0, 1, 1.0), Err(KnotError::NoInnerKnot { parameter: 0.0 }));
    assert_eq!(curve.split(1.0), Err(CurveError::AtEnd { parameter: 1.0 }));
    let other = BSplineCurve::new(KnotVector::clamped(1, &[0.0, 2.0]).unwrap(), [0.0, 1.0]).unwrap();
    assert!(matches!(curve.merged(&other), Err(KnotError::Domains { .. })));
}

#[test]
fn a_jump_survives_elevation_and_extraction() {
    let knots = KnotVector::new(1, [0.0, 0.0, 0.5, 0.5, 1.0, 1.0]).unwrap();
    let curve = BSplineCurve::new(knots, [0.0_f64, 1.0, 5.0, 6.0]).unwrap();
    let cubic = curve.elevate().unwrap().elevate().unwrap();
    assert_eq!(cubic.knots().multiplicity(0.5), 4);
    assert!((cubic.eval(0.5) - 5.0).abs() < 1e-15);
    assert!((cubic.eval(0.25) - 0.5).abs() < 1e-15);
    let pieces = cubic.to_bezier();
    assert_eq!(pieces.len(), 2);
    assert!((pieces[0].points[3] - 1.0).abs() < 1e-15 && (pieces[1].points[0] - 5.0).abs() < 1e-15);
}

#[test]
fn many_jumps_survive_elevation() {
    for degree in 0..4_usize {
        let mut breakpoints = vec![0.0];
        for i in 1..8 {
            breakpoints.extend(std::iter::repeat_n(
                f64::from(i),
                if i % 3 == 0 { degree.max(1) } else { degree + 1 },
            ));
        }
        breakpoints.push(8.0);
        let knots = KnotVector::clamped(degree, &breakpoints).unwrap();
        let points: Vec<f64> = (0..knots.functions()).map(|i| (i * i % 7) as f64).collect();
        let curve = BSplineCurve::new(knots, points).unwrap();
        let higher = curve.elevate().unwrap();
        for i in 0..=80 {
            let t = f64::from(i) / 10.0;
            assert!((higher.eval(t) - curve.eval(t)).abs() < 1e-14);
        }
        for i in 1..8 {
            let t = f64::from(i);
            assert_eq!(higher.knots().multiplicity(t), curve.knots().multiplicity(t) + 1);
        }
    }
}

proptest! {
    #[test]
    fn insertion_moves_no_point(
        curve in curve(),
        inserted in prop::collection::vec(prop_oneof![0.0..=1.0, Just(0.5), Just(0.0)], 0..6),
    ) {
        match curve.insert_knots(&inserted) {
            Ok(finer) => {
                prop_assert_eq!(finer.control_points().len(), curve.control_points().len() + inserted.len());
                prop_assert!(largest_distance(&finer, &curve) < ROUNDING);
                // One by one in the given order gives the same.
                let one_by_one = inserted.iter().fold(curve.clone(), |c, &t| c.insert_knots(&[t]).unwrap());
                prop_assert_eq!(one_by_one.knots(), finer.knots());
                for (a, b) in one_by_one.control_points().iter().zip(finer.control_points()) {
                    prop_assert!(distance(*a, *b) < ROUNDING);
                }
            }
            Err(error) => {
                let is_excess = matches!(error, KnotError::Multiplicity { .. });
                prop_assert!(is_excess);
            }
        }
    }

    #[test]
    fn derivatives_stay_too(curve in curve(), inserted in prop::collection::vec(0.01..0.99, 1..4)) {
        let finer = curve.insert_knots(&inserted).unwrap();
        for t in parameters() {
            let (a, b) = (curve.derivative(t, 1), finer.derivative(t, 1));
            let size = distance(a, [0.0; 3]).max(1.0);
            prop_assert!(distance(a, b) < 1e-10 * size);
        }
    }

    #[test]
    fn removal_undoes_insertion(curve in curve(), t in 0.05..0.95, times in 1..3_usize) {
        let times = times.min(curve.degree() + 1);
        let multiplicity = curve.knots().multiplicity(t);
        prop_assume!(multiplicity == 0);
        // Next to another knot removal divides by small distances, and rounding counts.
        prop_assume!(curve.knots().breakpoints().iter().all(|knot| (knot - t).abs() > 1e-3));
        let finer = curve.insert_knots(&vec![t; times]).unwrap();
        let (back, removed) = finer.remove_knot(t, times, 1e-7).unwrap();
        prop_assert_eq!(removed, times);
        prop_assert_eq!(back.knots(), curve.knots());
        prop_assert!(largest_distance(&back, &curve) <= 1e-7);
    }

    #[test]
    fn removal_keeps_its_tolerance(curve in curve(), tolerance in prop_oneof![Just(0.0), 0.0..20.0]) {
        let breakpoints = curve.knots().breakpoints();
        for &knot in &breakpoints[1..breakpoints.len() - 1] {
            let (fewer, removed) = curve.remove_knot(knot, usize::MAX, tolerance).unwrap();
            prop_assert_eq!(fewer.control_points().len() + removed, curve.control_points().len());
            prop_assert!(largest_distance(&fewer, &curve) <= tolerance + ROUNDING);
        }
    }

    #[test]
    fn elevation_moves_no_point(curve in curve()) {
        let higher = curve.elevate().unwrap();
        prop_assert_eq!(higher.degree(), curve.degree() + 1);
        prop_assert!(largest_distance(&higher, &curve) < ROUNDING);
        for t in curve.knots().breakpoints() {
            let times = curve.clamped().knots().multiplicity(t) + 1;
            prop_assert_eq!(higher.knots().multiplicity(t), times);
        }
    }

    #[test]
    fn clamping_moves_no_point(curve in curve()) {
        let clamped = curve.clamped();
        prop_assert!(clamped.knots().is_clamped());
        prop_assert_eq!(clamped.domain(), curve.domain());
        prop_assert!(largest_distance(&clamped, &curve) < ROUNDING);
        prop_assert_eq!(clamped.start(), clamped.control_points()[0]);
        prop_assert_eq!(Some(&clamped.end()), clamped.control_points().last());
    }

    #[test]
    fn parts_are_the_curve(curve in curve(), at in 0.05..0.95) {
        let [low, high] = curve.split(at).unwrap();
        prop_assert_eq!((low.domain(), high.domain()), ([0.0, at], [at, 1.0]));
        for t in parameters() {
            let part = if t < at { &low } else { &high };
            prop_assert!(distance(part.eval(t), curve.eval(t)) < ROUNDING);
        }
        prop_assert!(distance(low.end(), high.start()) < ROUNDING);
    }

    #[test]
    fn pieces_are_the_curve(curve in curve()) {
        let pieces = curve.to_bezier();
        prop_assert_eq!(pieces.len(), curve.knots().spans().count());
        for piece in pieces {
            let [lo, hi] = piece.domain;
            let bezier = BSplineCurve::from_bezier(piece.points).unwrap();
            prop_assert_eq!(bezier.degree(), curve.degree());
            for x in [0.0, 0.3, 0.9] {
                prop_assert!(distance(bezier.eval(x), curve.eval(lo + (hi - lo) * x)) < ROUNDING);
            }
        }
    }

    #[test]
    fn merging_is_exact((a, b) in (1..=4_usize, 1..=4_usize).prop_flat_map(|(a, b)| (curve_of(a), curve_of(b)))) {
        let [c, d] = a.merged(&b).unwrap();
        prop_assert_eq!(c.knots(), d.knots());
        prop_assert!(largest_distance(&a, &c) < ROUNDING);
        prop_assert!(largest_distance(&b, &d) < ROUNDING);
    }

    #[test]
    fn reversal(curve in curve()) {
        let reversed = curve.reversed();
        for t in parameters() {
            prop_assert!(distance(reversed.eval(1.0 - t), curve.eval(t)) < 1e-9);
        }
    }
}
