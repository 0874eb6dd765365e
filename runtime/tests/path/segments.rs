//! Paths as curves: evaluation, derivatives, parts, other curves.

use basis_runtime::{Bezier, CurveError, ParametricCurve, Path, PathSegment};

use crate::closed;
use crate::random::Random;

fn near(a: [f64; 2], b: [f64; 2], tolerance: f64) {
    assert!((0..2).all(|d| (a[d] - b[d]).abs() <= tolerance), "{a:?} {b:?}");
}

/// The point of a rational segment by its formula.
fn formula(segment: &PathSegment<[f64; 2]>, x: f64) -> [f64; 2] {
    let (points, n) = (segment.control_points(), segment.degree());
    let mut sums = [0.0; 3];
    let mut binomial = 1.0;
    for (i, point) in points.iter().enumerate() {
        let weight = segment.weights().map_or(1.0, |w| w[i]);
        let b = binomial * x.powi(i as i32) * (1.0 - x).powi((n - i) as i32) * weight;
        sums = [sums[0] + b * point[0], sums[1] + b * point[1], sums[2] + b];
        binomial = binomial * (n - i) as f64 / (i + 1) as f64;
    }
    [sums[0] / sums[2], sums[1] / sums[2]]
}

#[test]
fn points_and_derivatives() {
    let mut random = Random::new(1);
    for _ in 0..50 {
        let path = closed(&mut random, 3);
        for (k, segment) in path.segments().iter().enumerate() {
            let x: f64 = random.between(0.01, 0.99);
            let u = k as f64 + x;
            near(path.eval(u), formula(segment, u - k as f64), 1e-13);
            assert_eq!(path.eval(k as f64), segment.start());
            let [point, first, second, third] = path.eval_with_derivs::<4>(u);
            assert_eq!(point, path.eval(u));
            let h = 1e-4;
            let [a, b, c, d] = [u - 2.0 * h, u - h, u + h, u + 2.0 * h].map(|u| path.eval(u));
            for d_ in 0..2 {
                let slope = (8.0 * (c[d_] - b[d_]) - (d[d_] - a[d_])) / (12.0 * h);
                assert!((slope - first[d_]).abs() < 1e-5 * (1.0 + first[d_].abs()), "{slope} {first:?}");
                let bend = (c[d_] - 2.0 * point[d_] + b[d_]) / (h * h);
                assert!((bend - second[d_]).abs() < 1e-2 * (1.0 + second[d_].abs() + third[d_].abs()));
            }
        }
    }
}

#[test]
fn parts_are_the_same_curve() {
    let mut random = Random::new(2);
    for _ in 0..50 {
        let path = closed(&mut random, 4);
        let u = random.between(0.01, 3.99);
        let [before, after] = path.split(u).unwrap();
        assert_eq!((before.start(), after.end()), (path.start(), path.end()));
        assert_eq!(before.end(), after.start());
        let lengths = [&path, &before, &after].map(|path| path.arclen(1e-10));
        assert!((lengths[0] - lengths[1] - lengths[2]).abs() < 1e-9);
        let (a, b) = (random.between(0.0, 4.0), random.between(0.0, 4.0));
        let part = path.subsegment(a..b).unwrap();
        assert_eq!((part.start(), part.end()), (path.eval(a), path.eval(b)));
        assert_eq!(part.reversed().start(), part.end());
        near(part.reversed().reversed().eval(0.3), part.eval(0.3), 0.0);
    }
    let [line, rest] = Path::polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap().split(1.0).unwrap();
    assert_eq!((line.segments().len(), rest.segments().len()), (1, 2));
    assert!(matches!(line.split(1.0), Err(CurveError::AtEnd { .. })));
    assert!(matches!(line.split(f64::NAN), Err(CurveError::Parameter { .. })));
    assert!(matches!(line.subsegment(0.5..0.5), Err(CurveError::EmptyRange { .. })));
}

#[test]
fn any_curve_is_a_path_and_can_be_added_to_one() {
    let cubic = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    let mut path = Path::from_curve(&cubic);
    near(path.eval(0.3), cubic.eval(0.3), 0.0);
    path.append(&Bezier::from_points([[4.0, 0.0], [5.0, -1.0]]));
    path.line_to([2.0, -3.0]);
    path.close();
    path.close();
    assert_eq!(path.segments().iter().map(PathSegment::degree).collect::<Vec<_>>(), [3, 1, 1, 1]);
    assert!(path.is_closed());
    let as_dyn: &dyn ParametricCurve<Point = [f64; 2]> = &path;
    assert_eq!(Path::from_curve(as_dyn), path);
}

#[test]
fn affine_maps() {
    let mut random = Random::new(3);
    for _ in 0..20 {
        let path = closed(&mut random, 3);
        let map = |[x, y]: [f64; 2]| [0.5 * x - 2.0 * y + 1.0, x + 0.25 * y - 3.0];
        let mapped = path.map(map);
        let u = random.between(0.0, 3.0);
        near(mapped.eval(u), map(path.eval(u)), 1e-13);
        let lifted = path.map(|[x, y]| [x, y, x + y]);
        assert!((lifted.eval(u)[2] - path.eval(u)[0] - path.eval(u)[1]).abs() < 1e-13);
    }
}

#[test]
fn the_point_of_a_component() {
    // The timing function `ease` of CSS, against bisection.
    let ease = Bezier::from_points([[0.0_f64, 0.0], [0.25, 0.1], [0.25, 1.0], [1.0, 1.0]]);
    for k in 0..=100 {
        let x = f64::from(k) / 100.0;
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..60 {
            let t = f64::midpoint(low, high);
            if ease.eval(t)[0] < x { low = t } else { high = t }
        }
        let found = ease.first_where(0, x).unwrap();
        near(found, [x, ease.eval(low)[1]], 1e-12);
    }
    assert_eq!(ease.first_where(0, 1.5), None);
    assert_eq!(ease.first_where(2, 0.5), None);
    assert_eq!(ease.first_where(0, f64::NAN), None);
    // Of several the first.
    let path = Path::polyline(&[[0.0, 0.0], [2.0, 1.0], [0.0, 2.0]]).unwrap();
    near(path.first_where(0, 1.0).unwrap(), [1.0, 0.5], 1e-15);
}

#[test]
fn what_is_no_segment() {
    assert_eq!(Path::<[f64; 2]>::new(vec![]), Err(CurveError::NoSegments));
    assert!(PathSegment::<[f64; 2]>::polynomial([]).is_err());
    assert!(matches!(
        PathSegment::rational([[0.0, 0.0], [1.0, 1.0]], [1.0]),
        Err(CurveError::Length { expected: 2, found: 1 })
    ));
    assert!(matches!(
        PathSegment::rational([[0.0, 0.0], [1.0, 1.0]], [1.0, -1.0]),
        Err(CurveError::Weight { index: 1, .. })
    ));
    assert!(Path::polyline(&[[1.0, 2.0]]).is_err());
}
