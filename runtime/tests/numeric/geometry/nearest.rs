//! The nearest point is nearest of all, as closely as promised.

use basis_runtime::{Basis, Bezier, Curve};

use crate::families::{Bernstein7, Constant, Linear, QuarticBernstein};
use crate::random::Random;

fn distance(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// No sample is nearer, and the point is on the curve.
fn is_nearest<B: Basis<Scalar = f64>>(curve: &Curve<B, [f64; 2]>, point: [f64; 2], accuracy: f64) {
    let nearest = curve.nearest(point, accuracy).unwrap();
    assert!(
        nearest.at_least <= nearest.distance && nearest.at_least >= nearest.distance - accuracy.max(1e-13)
    );
    assert_eq!(nearest.point, curve.eval_checked(nearest.at).unwrap());
    assert!((nearest.distance - distance(&nearest.point, &point)).abs() <= 1e-15 * nearest.distance);
    for sample in curve.samples(2001) {
        assert!(
            nearest.distance <= distance(&sample, &point) + accuracy.max(1e-14),
            "{curve:?} {point:?} {accuracy}: {nearest:?} {sample:?}"
        );
    }
}

#[test]
fn of_random_curves() {
    let random = &mut Random::new(55);
    for _ in 0..60 {
        let [x, y] = [random.between(-1.5, 1.5), random.between(-1.5, 1.5)];
        let points = core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let curve = Curve::new(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), points);
        let wild = Curve::new(
            Bernstein7::new(),
            core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]),
        );
        for accuracy in [0.0, 1e-12, 1e-6, 1e-2] {
            is_nearest(&curve, [x, y], accuracy);
            is_nearest(&wild, [x, y], accuracy);
        }
    }
}

/// On a grid of whole numbers the derivative of the distance often vanishes at an end of the curve, exactly: because
/// two control points are one, or because the first leg is perpendicular to the line of sight. The nearest point is
/// inside nevertheless.
#[test]
fn where_the_start_is_farther_than_its_neighbours() {
    let nearest = Bezier::from_points([[1.0, 3.0], [1.0, 3.0], [1.0, 2.0], [0.0, 2.0]])
        .nearest([1.0, 2.0], 1e-12)
        .unwrap();
    assert!((nearest.distance - 0.393_115_212_253_786_3_f64).abs() < 1e-12, "{nearest:?}");
    let arch = Bezier::from_points([[0.0, 2.0], [1.0, 2.0], [1.0, 0.0]]);
    assert_eq!(arch.nearest([0.0, 0.0], 1e-12).unwrap().point, [1.0, 0.0]);

    let random = &mut Random::new(57);
    for _ in 0..150 {
        let mut grid = || [(); 2].map(|()| f64::floor(random.between(0.0, 4.0)));
        let (target, points) = (grid(), core::array::from_fn(|_| grid()));
        let quartic = Curve::new(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), points);
        is_nearest(&quartic, target, 0.0);
        is_nearest(&quartic.reversed(), target, 1e-9);
        is_nearest(&Bezier::from_points(points), target, 1e-9);
    }
}

/// Finite control points, between which the curve overflows.
#[test]
fn of_a_curve_that_overflows() {
    let points = [[1e8, f64::MAX], [1.0, 1e-300], [1e154, 1e300], [-1.0, 1e-8]];
    let nearest = Curve::new(QuarticBernstein::new(-1.6).unwrap(), points).nearest([-1e150, 1e154], 1e-3);
    assert!(nearest.is_none_or(|nearest| nearest.distance <= 1e154), "{nearest:?}");
}

/// From a point of the curve the distance is zero, and from a point next to it the parameter is found to the last
/// digits.
#[test]
fn from_points_on_the_curve() {
    let random = &mut Random::new(56);
    for _ in 0..100 {
        let points = core::array::from_fn(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let curve = Curve::new(QuarticBernstein::new(random.between(-2.0, 1.0)).unwrap(), points);
        let t = random.between(0.0, 1.0);
        let nearest = curve.nearest(curve.eval(t), 1e-13).unwrap();
        assert!(nearest.distance < 1e-13, "{curve:?} {t}: {nearest:?}");
    }
}

/// Two valleys, of which the lower one is narrow: a search from samples or from one start finds the other.
#[test]
fn the_global_minimum() {
    let curve =
        Bezier::from_points([[0.0, 1.0], [0.1, -4.0], [0.2, 9.0], [0.3, -6.2], [0.4, 4.0], [0.5, 0.1_f64]]);
    is_nearest(&curve, [0.25, -3.0], 1e-12);
    is_nearest(&curve, [0.25, 30.0], 1e-12);
}

/// An arc whose points are almost equally far from its centre: every one may be the answer, none takes long to find.
#[test]
fn from_the_centre_of_an_arc() {
    let k = 0.552_284_749_830_793_4;
    let arc = Bezier::from_points([[1.0, 0.0], [1.0, k], [k, 1.0], [0.0, 1.0]]);
    for accuracy in [0.0, 1e-15, 1e-9, 1e-3] {
        is_nearest(&arc, [0.0, 0.0], accuracy);
    }
    // 0.9999999999999999 or so at both ends and in the middle.
    assert!((arc.nearest([0.0, 0.0], 0.0).unwrap().distance - 1.0).abs() < 1e-15);
}

#[test]
fn symmetric_and_straight_curves() {
    let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]);
    is_nearest(&parabola, [0.0, 4.0], 0.0); // both ends are at √10, the two feet nearer
    is_nearest(&parabola, [0.0, 0.5], 0.0); // the centre of curvature: a minimum of fourth order
    let line = Curve::new(Linear::default(), [[0.0, 0.0], [3.0, 4.0]]);
    is_nearest(&line, [4.0, -3.0], 0.0);
    is_nearest(&line, [9.0, 9.0], 0.0);
    let back = Bezier::from_points([[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 0.0]]);
    is_nearest(&back, [0.75, 1.0], 0.0);
    is_nearest(&back, [0.3, 0.0], 0.0);
}

/// A curve that halts: the squares of the distances next to the halt are smaller than the rounding errors of the whole.
#[test]
fn from_points_at_a_halt() {
    for offset in [0.0, 1e-12, 1e-8, 1e-4] {
        // (x - 1/2)³ (1, 2), and the fifth power
        let cubic = Bezier::from_points([-1.0_f64, 1.0, -1.0, 1.0].map(|c| [3.0 + c, 1.0 + 2.0 * c]));
        let fifth =
            Bezier::from_points([-1.0_f64, 1.0, -1.0, 1.0, -1.0, 1.0].map(|c| [3.0 + c, 1.0 + 2.0 * c]));
        let point = [3.0 - 2.0 * offset, 1.0 + offset];
        let expected = offset * 5_f64.sqrt();
        assert!((cubic.nearest(point, 0.0).unwrap().distance - expected).abs() < 2e-15, "{offset:e}");
        assert!((fifth.nearest(point, 0.0).unwrap().distance - expected).abs() < 2e-15, "{offset:e}");
        is_nearest(&cubic, point, 0.0);
        is_nearest(&fifth, point, 0.0);
    }
}

#[test]
fn degenerate_curves_and_points() {
    is_nearest(&Curve::new(Constant::default(), [[1.0, 2.0]]), [4.0, 6.0], 0.0);
    is_nearest(&Bezier::from_points([[1.0, 2.0]; 6]), [4.0, 6.0], 0.0);
    is_nearest(&Bezier::from_points([[1.0, 2.0]; 6]), [1.0, 2.0], 0.0);
    let parabola = |size: f64| Bezier::from_points([[-size, size], [0.0, -size], [size, size]]);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(parabola(1.0).nearest([bad, 0.0], 1e-9), None);
        assert_eq!(parabola(bad).nearest([0.0, 0.0], 1e-9), None);
    }
    for size in [1e-300, 1e-200, 1e200] {
        let nearest = parabola(size).nearest([0.0, -2.0 * size], 0.0).unwrap();
        assert!((nearest.at - 0.5).abs() < 1e-7 && (nearest.distance / size - 2.0).abs() < 1e-14, "{size:e}");
    }
}

/// The distance from all of the curve is the same up to rounding errors, which grow with the dimension of the space.
#[test]
fn in_many_dimensions() {
    let mut line = [[1.0_f64; 12]; 2];
    [line[0][0], line[0][1], line[1][0], line[1][1]] = [0.0, 2.0, 2.0, 0.0];
    let nearest = Bezier::from_points(line).nearest([0.0; 12], 0.0).unwrap();
    assert!((nearest.distance - 12_f64.sqrt()).abs() < 1e-14);
    let tiny: [[f64; 20]; 4] = core::array::from_fn(|i| {
        core::array::from_fn(|d| if d == 0 { 1.0 + 1e-6 * (i as f64 - 1.4) } else { 1.0 })
    });
    let nearest = Bezier::from_points(tiny).nearest([0.0; 20], 0.0).unwrap();
    assert!((nearest.distance - (19.0 + (1.0 - 1.4e-6_f64).powi(2)).sqrt()).abs() < 1e-14);
}
