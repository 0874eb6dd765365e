//! Knot vectors: what is refused, and with which error; and that nothing hostile panics.

use basis_runtime::CurveError;
use basis_runtime::bspline::{BSplineCurve, KnotError, KnotVector, MAX_DEGREE, Net, SplineError};
use proptest::prelude::*;

use crate::support::knots;

#[track_caller]
fn refused(degree: usize, knots: &[f64], error: KnotError) {
    assert_eq!(KnotVector::new(degree, knots), Err(error));
}

#[test]
fn each_mistake_has_its_error() {
    refused(1, &[0.0, 0.0, f64::NAN, 1.0, 1.0], KnotError::NotFinite { index: 2 });
    refused(1, &[0.0, 0.0, 1.0, f64::INFINITY], KnotError::NotFinite { index: 3 });
    refused(2, &[0.0, 0.0, 0.0, 0.7, 0.3, 1.0, 1.0, 1.0], KnotError::Decreasing { index: 4 });
    let fourfold = KnotError::Multiplicity { knot: 0.5, multiplicity: 4, degree: 2 };
    refused(2, &[0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0], fourfold);
    refused(3, &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0], KnotError::TooFew { found: 7, degree: 3 });
    refused(0, &[], KnotError::TooFew { found: 0, degree: 0 });
    refused(1, &[0.0, 1.0, 1.0, 2.0], KnotError::EmptyDomain { at: 1.0 });
    refused(0, &[-f64::MAX, f64::MAX], KnotError::Overflow);
    refused(usize::MAX, &[0.0, 1.0], KnotError::Degree { degree: usize::MAX });
    refused(MAX_DEGREE, &[0.0, 1.0], KnotError::TooFew { found: 2, degree: MAX_DEGREE });
}

#[test]
fn short_hands_refuse_what_they_cannot_build() {
    assert!(matches!(KnotVector::<f64>::clamped(3, &[]), Err(KnotError::TooFew { .. })));
    assert_eq!(KnotVector::<f64>::uniform(3, 0), Err(KnotError::EmptyDomain { at: 0.0 }));
    assert_eq!(KnotVector::clamped(3, &[0.5]), Err(KnotError::EmptyDomain { at: 0.5 }));
    assert_eq!(KnotVector::<f64>::clamped(3, &[]), Err(KnotError::TooFew { found: 0, degree: 3 }));
    assert_eq!(KnotVector::<f64>::uniform(3, usize::MAX), Err(KnotError::Memory));
    assert!(matches!(KnotVector::<f64>::uniform(usize::MAX, 2), Err(KnotError::Degree { .. })));
    assert!(KnotVector::<f64>::uniform(MAX_DEGREE, 1).is_ok());
}

#[test]
fn messages_say_what_to_do() {
    let text = KnotVector::new(1, [0.0, 1.0, 0.5, 2.0]).unwrap_err().to_string();
    assert_eq!(text, "knot 2 is smaller than the knot before it; knots must not decrease");
    let knots = KnotVector::uniform(2, 2).unwrap();
    let text = BSplineCurve::new(knots, [[0.0; 2]; 3]).unwrap_err().to_string();
    assert_eq!(text, "3 control points; the knots ask for 4 (knots - degree - 1)");
    let ragged = Net::from_rows([vec![1.0, 2.0], vec![3.0]]).unwrap_err();
    assert_eq!(ragged, SplineError::Ragged { row: 1 });
}

#[test]
fn parameters_outside_of_the_domain() {
    let knots = KnotVector::new(1, [0.0, 1.0, 2.0, 3.0]).unwrap();
    let curve = BSplineCurve::new(knots.clone(), [5.0_f64, 7.0]).unwrap();
    assert_eq!(curve.domain(), [1.0, 2.0]);
    for t in [0.5, 2.5, f64::INFINITY] {
        assert_eq!(curve.eval_checked(t), Err(CurveError::Parameter { value: t, domain: [1.0, 2.0] }));
        assert_eq!(knots.values(t), Err(KnotError::Outside { parameter: t, domain: [1.0, 2.0] }));
    }
    assert!(matches!(curve.eval_checked(f64::NAN), Err(CurveError::Parameter { .. })));
    assert!(curve.eval(f64::NAN).is_nan());
    assert_eq!(curve.eval(3.0), 9.0); // the line continued
    assert_eq!(curve.eval_clamped(3.0), 7.0);
}

#[test]
fn spans_at_repeated_ends_of_unclamped_vectors() {
    // The domain is [1, 2]; both of its ends are repeated inside of it.
    let knots = KnotVector::new(2, [0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0]).unwrap();
    assert_eq!(knots.domain(), [1.0, 2.0]);
    let curve = BSplineCurve::new(knots, [9.0, 1.0, 2.0, 3.0, 9.0]).unwrap();
    assert_eq!([curve.start(), curve.eval(1.5), curve.end()], [1.0, 2.0, 3.0]);
}

#[test]
fn abscissae_of_constant_pieces_are_their_middles() {
    let knots = KnotVector::new(0, [0.0, 1.0, 1.5, 4.0]).unwrap();
    assert_eq!(knots.greville(), [0.5, 1.25, 2.75]);
}

proptest! {
    #[test]
    fn mapping_and_mirroring_meet_the_ends_exactly(
        knots in (0..=4_usize).prop_flat_map(knots), [lo, hi] in [-1.0..1.0, 1.0..3.0],
    ) {
        let mapped = knots.mapped([lo, hi]).unwrap();
        prop_assert_eq!(mapped.domain(), [lo, hi]);
        prop_assert_eq!(mapped.is_clamped(), knots.is_clamped());
        prop_assert_eq!(mapped.breakpoints().len(), knots.breakpoints().len());
        let mirrored = mapped.reversed();
        prop_assert_eq!(mirrored.domain(), [lo, hi]);
        prop_assert_eq!(mirrored.is_clamped(), knots.is_clamped());
        for (a, b) in mirrored.as_slice().iter().zip(mapped.as_slice().iter().rev()) {
            prop_assert!((a + b - (lo + hi)).abs() <= 1e-14);
        }
    }

    #[test]
    fn values_are_a_partition_of_unity((knots, t) in (0..=6_usize).prop_flat_map(|k| (knots(k), 0.0..=1.0))) {
        let (first, values) = knots.values(t).unwrap();
        prop_assert!(first + values.len() <= knots.functions());
        prop_assert!(values.iter().all(|&value| value >= 0.0));
        prop_assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let (_, slopes) = knots.derivatives(t, 1).unwrap();
        let size = slopes.iter().fold(1.0, |size: f64, slope| size.max(slope.abs()));
        prop_assert!(slopes.iter().sum::<f64>().abs() < 1e-13 * size);
    }

    #[test]
    fn greville_abscissae_reproduce_the_parameter((knots, t) in (1..=6_usize).prop_flat_map(|k| (knots(k), 0.0..=1.0))) {
        let line = BSplineCurve::new(knots.clone(), knots.greville()).unwrap();
        prop_assert!((line.eval(t) - t).abs() < 1e-14);
    }

    #[test]
    fn any_numbers_are_accepted_or_refused(
        degree in prop_oneof![0..6_usize, Just(usize::MAX), Just(1023)],
        raw in prop::collection::vec(prop_oneof![any::<f64>(), Just(0.0), Just(1.0), Just(2.0), -1.0..3.0], 0..14),
        t in any::<f64>(),
        sorted in any::<bool>(),
    ) {
        let mut raw = raw;
        if sorted {
            raw.sort_by(f64::total_cmp);
        }
        if let Ok(knots) = KnotVector::new(degree, raw) {
            let count = knots.functions();
            let points: Vec<f64> = (0..count).map(|i| i as f64).collect();
            let curve = BSplineCurve::new(knots, points).unwrap();
            let _ = (curve.eval(t), curve.derivative(t, 1), curve.clamped(), curve.elevate(), curve.to_bezier());
            let _ = (curve.split(t), curve.insert_knots(&[t, t]), curve.remove_knot(t, 3, 1.0), curve.reversed());
            let _ = (curve.refined(), curve.knots().mapped([t, 2.0]), curve.merged(&curve.clone()));
            let _ = curve.remove_knot(curve.knots().as_slice()[count / 2], usize::MAX, f64::NAN);
        }
    }
}

/// The span that bisection finds, whatever the knots: even, nearly even, repeated, far apart, unclamped.
#[test]
fn spans_are_those_of_bisection() {
    let even = |n: usize| (0..=n).map(|i| i as f64 / n as f64).collect::<Vec<f64>>();
    let mut vectors = vec![KnotVector::uniform(3, 7).unwrap()];
    for breakpoints in [
        even(1),
        even(3),
        even(49),
        even(1000),
        vec![-1.0, 0.0, 1e-9, 0.5, 1.0, 1e9],
        vec![0.1, 0.2, 0.3, 0.7, 0.8, 0.9],
        vec![-1e300, 0.0, 1e300],
    ] {
        vectors.push(KnotVector::clamped(2, &breakpoints).unwrap());
        vectors.push(KnotVector::periodic(2, &breakpoints).unwrap_or_else(|_| vectors[0].clone()));
    }
    vectors.push(KnotVector::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 4.0, 4.0, 4.0]).unwrap());
    vectors.push(KnotVector::new(2, vec![0.0, 1.0, 2.0, 2.0, 3.0, 4.0, 4.0, 5.0, 6.0]).unwrap());
    for knots in vectors {
        let all = knots.as_slice();
        let (k, n) = (knots.degree(), knots.functions());
        let bisected = |t: f64| {
            let span = k + all[k + 1..n].partition_point(|&knot| knot <= t);
            let last = (k..=span).rev().find(|&span| all[span] < all[n]).unwrap_or(k);
            (last..n).find(|&span| all[span + 1] > all[k]).unwrap_or(last)
        };
        let mut places: Vec<f64> = all.iter().flat_map(|&t| [t.next_down(), t, t.next_up()]).collect();
        places.extend(all.windows(2).map(|pair| 0.5 * pair[0] + 0.5 * pair[1]));
        places.extend([-1e308, 1e308, f64::INFINITY, f64::NEG_INFINITY, f64::NAN]);
        for t in places {
            assert_eq!(knots.span(t), bisected(t), "{t} in {all:?}");
        }
    }
}
