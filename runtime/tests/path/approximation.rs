//! Lower degrees within a tolerance.

use basis_runtime::{Bezier, CurveError, ParametricCurve, Path};

use crate::closed;
use crate::random::Random;

/// How far points of the one are from the other.
fn apart(path: &Path<[f64; 2]>, other: &Path<[f64; 2]>) -> f64 {
    path.samples(60).map(|p| other.nearest(p, 1e-9).unwrap().distance).fold(0.0, f64::max)
}

#[test]
fn both_are_within_the_tolerance_of_each_other() {
    let mut random = Random::new(12);
    for round in 0..6 {
        let path = closed(&mut random, 2);
        let tolerance = [1e-1, 1e-2, 1e-3][round % 3];
        for (degree, lowered) in
            [(3, path.to_cubics(tolerance).unwrap()), (2, path.to_quadratics(tolerance).unwrap())]
        {
            assert!(lowered.segments().iter().all(|s| s.degree() <= degree && s.weights().is_none()));
            assert!(lowered.is_closed());
            let meet = lowered.segments().windows(2).all(|pair| pair[0].end() == pair[1].start());
            assert!(meet);
            assert!(apart(&path, &lowered) <= tolerance && apart(&lowered, &path) <= tolerance);
        }
    }
}

#[test]
fn the_number_of_segments_grows_like_a_power_of_the_tolerance() {
    let cubic = Path::from_curve(&Bezier::from_points([[0.0_f64, 0.0], [1.0, 2.0], [3.0, -2.0], [4.0, 0.0]]));
    let count = |tolerance| cubic.to_quadratics(tolerance).unwrap().segments().len();
    // √3/36 |third difference| / n³: the bound of the literature, of which the Bernstein coefficients see 1/12 … 1/24.
    let third = 12.0_f64;
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let needed = (3.0_f64.sqrt() / 36.0 * third / tolerance).cbrt();
        let found = count(tolerance) as f64;
        assert!(found >= needed.floor() && found <= 2.0 * needed + 1.0, "{tolerance}: {found} for {needed}");
    }
    let circle = Path::<[f64; 2]>::circle([0.0, 0.0], 1.0);
    let counts = [1e-2, 1e-4, 1e-6, 1e-8].map(|t| circle.to_cubics(t).unwrap().segments().len());
    assert!(counts[0] <= 8 && counts[3] <= 400, "{counts:?}");
    // A cubic stays a cubic.
    assert_eq!(cubic.to_cubics(1e-9).unwrap(), cubic);
}

#[test]
fn what_cannot_be_kept_is_an_error() {
    let cubic = Path::from_curve(&Bezier::from_points([[0.0_f64, 0.0], [1.0, 2.0], [3.0, -2.0], [4.0, 0.0]]));
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(cubic.to_quadratics(tolerance), Err(CurveError::Tolerance { .. })));
    }
    // No part is smaller than rounding errors.
    assert!(cubic.to_quadratics(1e-300).unwrap().segments().len() < 200_000);
    let infinite = cubic.map(|[x, y]| [x / 0.0, y]);
    assert_eq!(infinite.to_quadratics(0.1), Err(CurveError::NotFinite));
}
