//! Area, centroid, moments and winding numbers, against polygons with many corners.

use std::f64::consts::PI;

use basis_runtime::{Bezier, CurveError, ParametricCurve, Path, PathSegment, Point};
use basis_test_support::cases;

use crate::closed;
use crate::random::Random;

/// The moments of a polygon, by triangles with the origin.
fn of_polygon(corners: &[[f64; 2]]) -> [f64; 6] {
    let mut sums = [0.0; 6];
    for (i, a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let area = (a[0] * b[1] - a[1] * b[0]) / 2.0;
        sums[0] += area;
        sums[1] += area * (a[0] + b[0]) / 3.0;
        sums[2] += area * (a[1] + b[1]) / 3.0;
        sums[3] += area * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 6.0;
        sums[4] += area * (2.0 * a[0] * a[1] + a[0] * b[1] + b[0] * a[1] + 2.0 * b[0] * b[1]) / 12.0;
        sums[5] += area * (a[1] * a[1] + a[1] * b[1] + b[1] * b[1]) / 6.0;
    }
    sums
}

fn all(curve: &dyn ParametricCurve<Point = [f64; 2]>) -> [f64; 6] {
    let found = curve.enclosed().unwrap();
    let ([x, y], [xx, xy, yy]) = (found.first_moments, found.second_moments);
    [found.area, x, y, xx, xy, yy]
}

/// The polygon with `n` corners to each segment has an error that falls like `1/n²`; two of them tell the limit.
fn extrapolated(path: &Path<[f64; 2]>, n: usize) -> [f64; 6] {
    let polygon = |n: usize| {
        let corners: Vec<_> =
            (0..path.segments().len() * n).map(|i| path.eval(i as f64 / n as f64)).collect();
        of_polygon(&corners)
    };
    let [coarse, fine] = [polygon(n), polygon(2 * n)];
    std::array::from_fn(|i| (4.0 * fine[i] - coarse[i]) / 3.0)
}

#[test]
fn moments_of_random_paths() {
    let mut random = Random::new(8);
    for _ in 0..60 {
        let path = closed(&mut random, 3);
        let (found, expected) = (all(&path), extrapolated(&path, 1000));
        for (f, e) in found.iter().zip(expected) {
            assert!((f - e).abs() < 1e-7 * (1.0 + e.abs()), "{found:?} {expected:?}");
        }
        // Backwards everything changes its sign.
        let backwards = all(&path.reversed());
        assert!(found.iter().zip(backwards).all(|(f, b)| (f + b).abs() < 1e-10 * (1.0 + f.abs())));
    }
}

#[test]
fn disks_to_the_last_digits() {
    let disk = Path::<[f64; 2]>::circle([3.0, -2.0], 0.5).enclosed().unwrap();
    let area = PI / 4.0;
    assert!((disk.area - area).abs() < 2e-15);
    let [x, y] = disk.centroid.unwrap();
    assert!((x - 3.0).abs() < 1e-15 && (y + 2.0).abs() < 1e-15);
    let about_centre = PI / 64.0;
    assert!((disk.second_moments[0] - about_centre - 9.0 * area).abs() < 2e-14);
    assert!((disk.second_moments[1] + 6.0 * area).abs() < 2e-14);
    assert!((disk.second_moments[2] - about_centre - 4.0 * area).abs() < 2e-14);
    // Weights far from each other, and of a high degree.
    let (points, weights) = ([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, 1e-6, 1e3]);
    let thin = Path::from(PathSegment::rational(points, weights).unwrap());
    let sharp = thin.enclosed().unwrap().area;
    // The conic with w = w1/√(w0 w2) between its chord and its tangents, by a reparametrisation with equal ends.
    let same = PathSegment::rational(points, [1.0, 1e-6 / 1e3_f64.sqrt(), 1.0]).unwrap();
    assert!((sharp - Path::from(same).enclosed().unwrap().area).abs() < 1e-15);
}

#[test]
fn open_curves_are_closed_by_lines_and_contours_stand_alone() {
    // Under the parabola y = 1 - x².
    let parabola = Bezier::from_points([[1.0_f64, 0.0], [0.0, 2.0], [-1.0, 0.0]]);
    assert!((parabola.enclosed().unwrap().area - 4.0 / 3.0).abs() < 1e-15);
    // A square with a square hole that runs the other way.
    let mut path = Path::rectangle([[0.0, 0.0], [4.0, 4.0]]);
    path.append(&Path::rectangle([[1.0, 1.0], [2.0, 2.0]]).reversed());
    let found = path.enclosed().unwrap();
    assert_eq!(found.area, 15.0);
    let [x, _] = found.centroid.unwrap();
    assert!((x - 30.5_f64 / 15.0).abs() < 1e-15);
    assert_eq!(
        [[0.5, 0.5], [1.5, 1.5], [5.0, 1.0]].map(|p| path.winding(p).unwrap()),
        [Some(1), Some(0), Some(0)]
    );
}

#[test]
fn an_eight_has_no_centroid() {
    let eight = Path::polygon(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
    let found = eight.enclosed().unwrap();
    assert_eq!((found.area, found.centroid), (0.0, None));
    let space = Bezier::from_points([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]);
    assert_eq!(space.enclosed().unwrap_err(), CurveError::Dimension { expected: 2, found: 3 });
    assert!(space.winding([0.0; 3]).is_err());
    let infinite = Bezier::from_points([[0.0, f64::INFINITY], [1.0, 0.0]]);
    assert_eq!(infinite.enclosed().unwrap_err(), CurveError::NotFinite);
    assert_eq!(infinite.winding([0.0, 0.0]), Ok(None));
}

#[test]
fn winding_numbers_by_angles() {
    let mut random = Random::new(9);
    let mut seen = [0; 7];
    for _ in 0..40 {
        let path = closed(&mut random, 4);
        let n = 2000;
        let corners: Vec<_> = (0..4 * n).map(|i| path.eval(f64::from(i) / f64::from(n))).collect();
        for _ in 0..25 {
            let point: [f64; 2] = [random.between(-3.0, 5.0), random.between(-4.0, 2.0)];
            if path.nearest(point, 1e-6).unwrap().distance < 0.02 {
                continue;
            }
            let angle = |p: [f64; 2]| (p[1] - point[1]).atan2(p[0] - point[0]);
            let turns: f64 = (0..corners.len())
                .map(|i| {
                    let turn = angle(corners[(i + 1) % corners.len()]) - angle(corners[i]);
                    turn - 2.0 * PI * (turn / (2.0 * PI)).round()
                })
                .sum();
            let expected = (turns / (2.0 * PI)).round() as i32;
            assert_eq!(path.winding(point), Ok(Some(expected)));
            seen[(expected + 3) as usize] += 1;
        }
    }
    assert!(seen[1..6].iter().all(|&count| count > 0), "{seen:?}");
}

#[test]
fn points_on_the_curve_have_no_winding_number() {
    let circle = Path::<[f64; 2]>::circle([0.0, 0.0], 1.0);
    for angle in [0.0_f64, 0.3, 1.0, 2.0, 4.5] {
        assert_eq!(circle.winding([angle.cos(), angle.sin()]), Ok(None), "{angle}");
    }
    let square = Path::rectangle([[0.0, 0.0], [1.0, 1.0]]);
    for on in [[0.0, 0.0], [0.5, 0.0], [1.0, 1.0], [1.0, 0.25], [0.0, 0.75]] {
        assert_eq!(square.winding(on), Ok(None), "{on:?}");
    }
    // The ray meets corners and runs along sides.
    for (beside, count) in [([-1.0, 0.0], 0), ([-1.0, 1.0], 0), ([2.0, 0.0], 0), ([0.5, 0.5], 1)] {
        assert_eq!(square.winding(beside), Ok(Some(count)), "{beside:?}");
    }
    let diamond = Path::polygon(&[[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]).unwrap();
    assert_eq!(
        [[0.0, 0.0], [-3.0, 0.0], [-2.0, 1.0]].map(|p| diamond.winding(p).unwrap()),
        [Some(1), Some(0), Some(0)]
    );
}

/// How many of many points of a curve have a winding number.
fn beside<P: Point>(curve: &impl ParametricCurve<Point = P>) -> usize {
    curve.samples(cases(2_001)).filter(|&p| curve.winding(p).unwrap().is_some()).count()
}

/// A point of the curve differs from it by rounding errors, those of its scalar type.
#[test]
fn computed_points_on_the_curve_have_no_winding_number() {
    assert_eq!(beside(&Path::<[f64; 2]>::circle([0.0, 0.0], 1.0)), 0);
    assert_eq!(beside(&Path::<[f32; 2]>::circle([0.0, 0.0], 1.0)), 0);
    assert_eq!(beside(&Path::<[f32; 2]>::circle([1e3, -3.0], 0.7)), 0);
    let mut random = Random::new(10);
    for _ in 0..2 {
        let mut point = || [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let points: [[f64; 2]; 5] = core::array::from_fn(|_| point());
        for count in 1..=5 {
            let points = &points[..count];
            let path = Path::from(PathSegment::polynomial(points.to_vec()).unwrap());
            assert_eq!(beside(&path), 0, "{points:?}");
            let single: Vec<[f32; 2]> = points.iter().map(|p| p.map(|c| c as f32)).collect();
            assert_eq!(beside(&Path::from(PathSegment::polynomial(single).unwrap())), 0, "{points:?}");
            let far: Vec<[f64; 2]> = points.iter().map(|p| p.map(|c| 1e6 + c)).collect();
            assert_eq!(beside(&Path::from(PathSegment::polynomial(far).unwrap())), 0, "{points:?}");
        }
    }
    let point = [999_999.53, 999_999.95];
    for count in 1..=4 {
        assert_eq!(beside(&Path::from(PathSegment::polynomial(vec![point; count]).unwrap())), 0);
    }
    // A little farther away there is one.
    let circle = Path::<[f32; 2]>::circle([0.0, 0.0], 1.0);
    for angle in [0.0_f32, 0.3, 1.0, 2.0, 4.5] {
        let at = |radius: f32| [radius * angle.cos(), radius * angle.sin()];
        assert_eq!([0.9999, 1.0001].map(|r| circle.winding(at(r)).unwrap()), [Some(1), Some(0)]);
    }
}
