//! Arc lengths are as accurate as they promise, also at cusps, and their inverse finds the parameters.

use basis_runtime::{Bezier, Curve, Scalar};
use basis_test_support::cases;

use crate::families::{Linear, QuarticBernstein};
use crate::random::Random;

/// √5/2 + asinh(2)/4, the length of y = x² over 0 <= x <= 1.
const PARABOLA: f64 = 1.478_942_857_544_597_4;

fn parabola<S: Scalar>() -> Bezier<[S; 2], 3> {
    Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]].map(|p| p.map(S::of)))
}

/// The length of a polygon with very many corners, which is too short by about a part in 10^10.
fn polygon<B, const D: usize>(curve: &Curve<B, [f64; D]>) -> f64
where
    B: basis_runtime::Basis<Scalar = f64>,
{
    let points: Vec<[f64; D]> = curve.samples(100_001).collect();
    let square = |a: &[f64; D], b: &[f64; D]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    points.windows(2).map(|pair| square(&pair[0], &pair[1]).sqrt()).sum()
}

#[test]
fn every_accuracy_is_kept() {
    for exponent in 1..=15 {
        let accuracy = 10_f64.powi(-exponent);
        assert!((parabola().arclen(accuracy) - PARABOLA).abs() <= accuracy.max(1e-15));
    }
    assert!((parabola::<f32>().arclen(1e-6).to_f64() - PARABOLA).abs() < 1e-6);
}

#[test]
fn without_accuracy_as_good_as_the_scalar_type() {
    for accuracy in [0.0, -1.0, f64::NAN, 1e-300] {
        assert!((parabola().arclen(accuracy) - PARABOLA).abs() < 2e-15);
    }
    assert!(parabola::<f64>().arclen(f64::INFINITY).is_finite());
}

/// (t², t³) has a cusp at 0; its length over 0..1 is (13√13 - 8)/27, twice that over -1..1.
#[test]
fn cusps() {
    let exact = (13.0 * 13_f64.sqrt() - 8.0) / 27.0;
    let half = Bezier::from_points([[0.0, 0.0], [0.0, 0.0], [1.0 / 3.0, 0.0], [1.0, 1.0]]);
    let whole = Bezier::from_points([[1.0, -1.0], [-1.0 / 3.0, 1.0], [-1.0 / 3.0, -1.0], [1.0, 1.0]]);
    for accuracy in [1e-3, 1e-8, 1e-13] {
        assert!((half.arclen(accuracy) - exact).abs() <= accuracy);
        assert!((whole.arclen(accuracy) - 2.0 * exact).abs() <= accuracy);
        assert!(
            (whole.subsegment(0.0..0.51).unwrap().arclen(accuracy)
                + whole.subsegment(0.51..1.0).unwrap().arclen(accuracy)
                - 2.0 * exact)
                .abs()
                <= 2.0 * accuracy
        );
    }
    // There and back on a line: the direction turns round at 1/2.
    let back = Bezier::from_points([0.0_f64, 1.0, 0.0]);
    assert!((back.arclen(1e-13) - 1.0).abs() < 1e-13);
}

#[test]
fn random_curves_in_space() {
    let random = &mut Random::new(51);
    for _ in 0..cases(40) {
        let points: [[f64; 3]; 4] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let curve = Curve::new(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), points);
        let expected = polygon(&curve);
        for accuracy in [1e-2, 1e-5, 1e-12] {
            let gap: f64 = (curve.arclen(accuracy) - expected).abs();
            assert!(gap <= accuracy + 1e-8 * expected, "{gap} {accuracy} {curve:?}");
        }
    }
}

/// By the zeros of the velocity, against the same curve in space: random ones, and such with cusps, turns, double points and
/// equal control points, a little disturbed.
#[test]
fn plane_curves_as_those_in_space() {
    fn agree<const N: usize>(points: [[f64; 2]; N]) {
        let size = points.as_flattened().iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let space = Bezier::from_points(points.map(|[x, y]| [x, y, 0.0]));
        for accuracy in [1e-2, 1e-6, 1e-10, 1e-13] {
            let accuracy: f64 = accuracy * size;
            let [plane, space] = [Bezier::from_points(points).arclen(accuracy), space.arclen(accuracy)];
            let rounding = 16.0 * f64::EPSILON * (plane + size);
            assert!(
                (plane - space).abs() <= 2.0 * accuracy + rounding,
                "{plane} {space} {accuracy} {points:?}"
            );
        }
    }
    let random = &mut Random::new(52);
    for round in 0..600 {
        let unit = [1.0, 1e-150, 1e150][round % 3];
        let disturbance = [0.0, 1e-12, 1e-8, 1e-4, 1.0][round % 5];
        let mut coordinate = || {
            unit * (random.between::<f64>(-3.0, 3.0).round() + disturbance * random.between::<f64>(-1.0, 1.0))
        };
        let [a, b, c, d] = [(); 4].map(|()| [coordinate(), coordinate()]);
        agree([a, b]);
        agree([a, b, c]);
        agree([a, b, c, d]);
        // There and back, and all on a line.
        agree([a, b, b, a]);
        agree([a, b, a]);
        agree([a, b, c, d].map(|[x, _]| [x, x]));
    }
}

/// The rule for a whole curve against the sum of 64 short parts, for which any rule is good.
#[test]
fn every_degree_and_accuracy() {
    fn check<const N: usize>(random: &mut Random) {
        for _ in 0..20 {
            let curve = Bezier::<[f64; 2], N>::from_points(core::array::from_fn(|_| {
                [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]
            }));
            let part =
                |k: usize| curve.subsegment(k as f64 / 64.0..(k + 1) as f64 / 64.0).unwrap().arclen(0.0);
            let expected: f64 = (0..64).map(part).sum();
            for accuracy in [1e-1, 1e-2, 1e-4, 1e-7, 1e-10, 1e-12] {
                let gap = (curve.arclen(accuracy) - expected).abs();
                assert!(gap <= accuracy + 1e-13, "{gap:e} {accuracy:e} {curve:?}");
            }
            let single = Bezier::<[f32; 2], N>::from_points(core::array::from_fn(|i| {
                curve.control_points()[i].map(|c| c as f32)
            }));
            let gap = (f64::from(single.arclen(1e-3)) - expected).abs();
            assert!(gap <= 1e-3 + 2e-5, "{gap:e} {curve:?}");
        }
    }
    let random = &mut Random::new(53);
    check::<3>(random);
    check::<4>(random);
    check::<6>(random);
    check::<10>(random);
}

#[test]
fn the_inverse_splits_the_length() {
    let random = &mut Random::new(52);
    for round in 0..40 {
        let mut points: [[f64; 2]; 4] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        if round % 4 == 0 {
            points[1] = points[0];
        }
        let curve = Curve::new(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), points);
        let length = curve.arclen(1e-13);
        for part in [1e-6, 0.1, 0.5, 0.77, 1.0 - 1e-6] {
            let t = curve.inv_arclen(part * length, 1e-13);
            let before = curve.subsegment(0.0..t).unwrap().arclen(1e-13);
            assert!((before - part * length).abs() < 1e-11, "{before} {} {curve:?}", part * length);
        }
    }
}

#[test]
fn lengths_outside_of_the_curve() {
    let line = Curve::new(Linear::<f64>::default(), [[0.0, 0.0], [3.0, 4.0]]);
    let ends: [f64; 2] = line.domain();
    assert_eq!(line.arclen(1e-9), 5.0);
    assert_eq!(line.inv_arclen(0.0, 1e-9), ends[0]);
    assert_eq!(line.inv_arclen(-1.0, 1e-9), ends[0]);
    assert_eq!(line.inv_arclen(6.0, 1e-9), ends[1]);
    assert!((line.inv_arclen(2.5, 1e-9) - 0.4).abs() < 1e-15);
    assert!(line.inv_arclen(f64::NAN, 1e-9).is_nan());
}

#[test]
fn points_at_equal_distances() {
    let curve = Bezier::from_points([[0.0_f64, 0.0], [0.0, 0.0], [3.0, 5.0], [1.0, 0.0]]);
    let parameters = curve.arclen_parameters(11, 1e-12);
    assert_eq!([parameters[0], parameters[10]], [0.0, 1.0]);
    let step = curve.arclen(1e-12) / 10.0;
    for pair in parameters.windows(2) {
        assert!((curve.subsegment(pair[0]..pair[1]).unwrap().arclen(1e-12) - step).abs() < 1e-10);
    }
    let points = curve.samples_by_arclen(11, 1e-12);
    assert_eq!([points[0], points[10]], [curve.start(), curve.end()]);
    let arch = Bezier::from_points([[0.0_f64, 0.0], [1.0, 2.0], [3.0, 2.5], [4.0, 0.0]]);
    assert_eq!(arch.samples_by_arclen(3, 1e-9)[0], arch.start());
    assert_eq!(arch.inv_arclen(0.0, 1e-9), 0.0);
    assert!(curve.arclen_parameters(0, 1e-9).is_empty());
    assert_eq!(curve.arclen_parameters(1, 1e-9), [0.0]);
}

#[test]
fn degenerate_curves() {
    let point = Bezier::from_points([[2.0_f64, 1.0]; 4]);
    assert_eq!(point.arclen(1e-9), 0.0);
    assert_eq!(point.inv_arclen(0.0, 1e-9), 1.0);
    assert_eq!(point.arclen_parameters(3, 1e-9), [0.0, 0.0, 1.0]);
    assert_eq!(Bezier::from_points([[2.0_f64, 1.0]]).arclen(1e-9), 0.0);
    // Finite points may be farther from each other than any number.
    let far = Bezier::from_points([[0.0, 0.0], [f64::MAX, -f64::MAX], [-f64::MAX, f64::MAX]]);
    assert_eq!(far.arclen(1e-9), f64::INFINITY);
    assert!((0.0..1e-3).contains(&far.inv_arclen(1.0, 1e-9)));
    for bad in [f64::NAN, f64::INFINITY] {
        let curve = Bezier::from_points([[0.0, 0.0], [bad, -bad], [-bad, bad]]);
        assert!(curve.arclen(1e-9).is_nan());
        assert!(curve.inv_arclen(1.0, 1e-9).is_nan());
        assert!(curve.samples_by_arclen(3, 1e-9).iter().all(|p| p[0].is_nan()));
    }
    for size in [1e-300, 1e-160, 1e150, 1e300] {
        let curve = Bezier::from_points([[0.0, 0.0], [0.5 * size, 0.0], [size, size]]);
        assert!((curve.arclen(1e-9 * size) / size - PARABOLA).abs() < 2e-9, "{size:e}");
    }
}

/// A straight line whose speed vanishes, or that turns back.
#[test]
fn straight_lines_with_a_halt() {
    let halt =
        Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [0.5, 1.0], [0.5, 1.0], [0.0, 0.0], [1.0, 2.0_f64]]);
    let slow = Bezier::from_points([0.0_f64, 0.0, 0.0, 1.0]);
    for accuracy in [1e-3, 1e-9, 1e-13] {
        for target in [1e-4, 0.1, 0.4, 0.9] {
            assert!((slow.eval(slow.inv_arclen(target, accuracy)) - target).abs() <= accuracy + 1e-15);
            let t = halt.inv_arclen(target, accuracy);
            assert!(
                (halt.subsegment(0.0..t).unwrap().arclen(1e-14) - target).abs() <= 2.0 * accuracy + 1e-13
            );
        }
    }
}

/// Moving a curve by whole numbers does not change its length, nor how well it is known.
#[test]
fn far_from_the_origin() {
    let cusp = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0_f64]];
    let length = Bezier::from_points(cusp).arclen(1e-14);
    for x in [1e6, 1e9, 1e12] {
        let moved = Bezier::from_points(cusp.map(|[a, b]| [a + x, b - x]));
        assert!((moved.arclen(1e-14) - length).abs() < 1e-14);
    }
}

/// Curves with this many control points go to and fro; their lengths were computed with 60 digits.
fn wild<const N: usize>() -> Bezier<[f64; 2], N> {
    let residue = |k: usize, m: usize| (k % m) as f64;
    Bezier::from_points(core::array::from_fn(|k| {
        [(residue(7 * k * k, 11) - 5.0) / 4.0, (residue(5 * k * k * k, 13) - 6.0) / 4.0]
    }))
}

#[test]
fn of_high_degree() {
    for accuracy in [1e-6, 1e-10, 1e-13] {
        assert!((wild::<13>().arclen(accuracy) - 4.329_592_451_061_598).abs() <= accuracy);
        assert!((wild::<21>().arclen(accuracy) - 6.172_496_520_528_452).abs() <= accuracy);
        assert!((wild::<31>().arclen(accuracy) - 6.786_950_129_687_356).abs() <= accuracy);
    }
    let elevated = parabola::<f64>().elevate::<48>();
    assert!((elevated.arclen(1e-13) - PARABOLA).abs() <= 1e-13);
    let half = elevated.inv_arclen(PARABOLA / 2.0, 1e-13);
    assert!((half - parabola().inv_arclen(PARABOLA / 2.0, 1e-13)).abs() <= 1e-12);
}

/// Where the curve turns back there is nothing but rounding errors; halving them again and again would not end.
#[test]
fn of_high_degree_to_and_fro() {
    let line: [[f64; 2]; 31] = wild::<31>().control_points().try_into().unwrap();
    let flat = Bezier::from_points(line.map(|[x, y]| [x, 0.5 * x + 1e-9 * y]));
    let straight = Bezier::from_points(line.map(|[x, _]| [x, 0.5 * x]));
    assert!((flat.arclen(0.0) - straight.arclen(0.0)).abs() < 1e-8);
}
