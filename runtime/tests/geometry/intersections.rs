//! Where curves meet: nothing is missed, and what is answered is there.

use basis_runtime::bspline::BSplineCurve;
use basis_runtime::{Bezier, Curve, Meeting, MeetingKind, ParametricCurve, Path, PiecewiseCurve};
use basis_test_support::cases;

use crate::queries::{circle, distance, nurbs, spline};
use crate::random::Random;

type P2 = [f64; 2];
type P3 = [f64; 3];

fn cubic<const D: usize>(random: &mut Random) -> Bezier<[f64; D], 4> {
    Bezier::from_points([(); 4].map(|()| [(); D].map(|()| random.between(-1.0, 1.0))))
}

/// The parameters at which polygons with many corners cross.
fn brute(
    a: &dyn ParametricCurve<Point = P2>,
    b: &dyn ParametricCurve<Point = P2>,
    count: usize,
) -> Vec<[f64; 2]> {
    let corners = |c: &dyn ParametricCurve<Point = P2>| {
        let [lo, hi] = c.domain();
        let at = |k: usize| lo + (hi - lo) * k as f64 / count as f64;
        (0..=count).map(|k| (at(k), c.eval(at(k)))).collect::<Vec<_>>()
    };
    let (a, b) = (corners(a), corners(b));
    let mut found = Vec::new();
    for p in a.windows(2) {
        for q in b.windows(2) {
            let side = |o: P2, e: P2, x: P2| (e[0] - o[0]) * (x[1] - o[1]) - (e[1] - o[1]) * (x[0] - o[0]);
            let differ = |x: f64, y: f64| (x > 0.0) != (y > 0.0);
            let (p0, p1, q0, q1) = (p[0].1, p[1].1, q[0].1, q[1].1);
            let apart =
                (0..2).any(|d| p0[d].max(p1[d]) < q0[d].min(q1[d]) || q0[d].max(q1[d]) < p0[d].min(p1[d]));
            if !apart
                && differ(side(p0, p1, q0), side(p0, p1, q1))
                && differ(side(q0, q1, p0), side(q0, q1, p1))
            {
                found.push([0.5 * (p[0].0 + p[1].0), 0.5 * (q[0].0 + q[1].0)]);
            }
        }
    }
    found
}

fn covers(meeting: &Meeting<P2>, at: [f64; 2], gap: f64) -> bool {
    let within = |[lo, hi]: [f64; 2], t: f64| {
        if lo > hi { t >= lo - gap || t <= hi + gap } else { t >= lo - gap && t <= hi + gap }
    };
    within(meeting.first, at[0]) && within(meeting.second, at[1])
}

/// All that crosses is found once, and nothing else.
fn agree(a: &dyn ParametricCurve<Point = P2>, b: &dyn ParametricCurve<Point = P2>, gap: f64) -> usize {
    let found = a.intersections(b, 1e-9).unwrap();
    let expected = brute(a, b, 250);
    for &at in &expected {
        assert!(found.iter().any(|meeting| covers(meeting, at, gap)), "{at:?} is missing in {found:?}");
    }
    for meeting in &found {
        assert!(meeting.distance <= 2e-9, "{meeting:?}");
        assert!(distance(a.eval(meeting.at[0]), meeting.point) < 1e-15);
    }
    assert!(found.windows(2).all(|pair| pair[0].at[0] <= pair[1].at[0]));
    let crossings = found.iter().filter(|meeting| meeting.kind == MeetingKind::Crossing).count();
    assert!(
        crossings >= expected.len().saturating_sub(1) && found.len() <= expected.len() + 2,
        "{found:?} {expected:?}"
    );
    expected.len()
}

#[test]
fn of_random_curves() {
    let random = &mut Random::new(1901);
    let mut total = 0;
    for _ in 0..60 {
        total += agree(&cubic::<2>(random), &cubic::<2>(random), 0.02);
    }
    for _ in 0..4 {
        total += agree(&spline::<2>(random), &nurbs::<2>(random), 0.1);
        total += agree(&circle(), &spline::<2>(random), 0.1);
    }
    assert!(total > 60, "{total}");
}

/// Beside the changes of side of a point that runs along the curve, and beside the answers for the line as a cubic.
#[test]
fn of_lines() {
    let random = &mut Random::new(1902);
    let mut total = 0;
    for round in 0..cases(3000) {
        // Every other pair on a coarse grid: lines through ends, tangents, symmetric curves.
        let mut point = || {
            let [x, y] = [(); 2].map(|()| random.between(-1.0, 1.0));
            if round % 2 == 0 { [x, y] } else { [x, y].map(|c: f64| (3.0 * c).round()) }
        };
        let curve = Bezier::from_points([(); 4].map(|()| point()));
        let ends = [point(), point()];
        let line = Bezier::from_points(ends);
        let between = |x: f64| [0, 1].map(|d| ends[0][d] + x * (ends[1][d] - ends[0][d]));
        let cubic = Bezier::from_points([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(between));
        let found = curve.intersections(&line, 1e-9).unwrap();
        let side = |t: f64| {
            let (p, [from, to]) = (curve.eval(t), ends);
            let (v, w) = ([to[0] - from[0], to[1] - from[1]], [p[0] - from[0], p[1] - from[1]]);
            let square = v[0] * v[0] + v[1] * v[1];
            ((v[0] * w[1] - v[1] * w[0]), (v[0] * w[0] + v[1] * w[1]) / square)
        };
        for k in 0..1000 {
            let [t, next] = [0.001 * f64::from(k), 0.001 * f64::from(k + 1)];
            let ((a, x), (b, y)) = (side(t), side(next));
            if a * b < 0.0 && x.min(y) > 0.0 && x.max(y) < 1.0 {
                total += 1;
                let at = [0.5 * (t + next), 0.5 * (x + y)];
                let gap = 0.001 + (x - y).abs();
                assert!(found.iter().any(|m| covers(m, at, gap)), "{at:?} of {curve:?} {line:?}: {found:?}");
            }
        }
        assert!(found.iter().all(|m| m.distance <= 2e-9), "{found:?}");
        let other = curve.intersections(&cubic, 1e-9).unwrap();
        for (some, all) in [(&found, &other), (&other, &found)] {
            for m in some {
                assert!(all.iter().any(|n| covers(n, m.at, 1e-3)), "{m:?} of {curve:?} {line:?}: {all:?}");
            }
        }
    }
    assert!(total > cases(800), "{total}");
}

/// Nine points of two cubics, and curves of high degree.
#[test]
fn as_many_as_there_can_be() {
    let wave = |x: fn(f64) -> P2| {
        let values = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(x);
        // The Bézier points of the cubic through these.
        let inner = |i: usize| {
            let d = |d: usize| {
                let v = |k: usize| values[k][d];
                if i == 1 {
                    (-5.0 * v(0) + 18.0 * v(1) - 9.0 * v(2) + 2.0 * v(3)) / 6.0
                } else {
                    (2.0 * v(0) - 9.0 * v(1) + 18.0 * v(2) - 5.0 * v(3)) / 6.0
                }
            };
            [d(0), d(1)]
        };
        Bezier::from_points([values[0], inner(1), inner(2), values[3]])
    };
    let across = wave(|t| [2.0 * t - 1.0, 4.0 * (2.0 * t - 1.0).powi(3) - 3.0 * (2.0 * t - 1.0)]);
    let along = wave(|t| [4.0 * (2.0 * t - 1.0).powi(3) - 3.0 * (2.0 * t - 1.0), 2.0 * t - 1.0]);
    let found = across.intersections(&along, 1e-10).unwrap();
    assert_eq!(found.len(), 9);
    // At both corners the curves end.
    let crossings = found.iter().filter(|meeting| meeting.kind == MeetingKind::Crossing).count();
    assert_eq!(crossings, 9, "{found:?}");
}

#[test]
fn touching_curves() {
    let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]);
    let line = Bezier::from_points([[-1.0, 0.0], [1.0, 0.0]]);
    for accuracy in [1e-4, 1e-6, 1e-9] {
        let [touch] = parabola.intersections(&line, accuracy).unwrap().try_into().unwrap();
        assert_eq!(touch.kind, MeetingKind::Contact);
        assert!(touch.distance <= accuracy && covers(&touch, [0.5, 0.5], 0.0), "{touch:?}");
        assert!(touch.first[1] - touch.first[0] < 8.0 * f64::sqrt(accuracy), "{touch:?}");
    }
    // A tenth above: nothing; a little below: two points.
    let above = Bezier::from_points([[-1.0, -0.1], [1.0, -0.1]]);
    assert_eq!(parabola.intersections(&above, 1e-9), Some(vec![]));
    let below = Bezier::from_points([[-1.0, 1e-6], [1.0, 1e-6]]);
    let found = parabola.intersections(&below, 1e-12).unwrap();
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0].point[0] + 1e-3).abs() < 1e-12 && (found[1].point[0] - 1e-3).abs() < 1e-12);
    // y = x³ meets its tangent in a triple point.
    let cubic = Bezier::from_points([[-1.0, -1.0], [-1.0 / 3.0, 1.0], [1.0 / 3.0, -1.0], [1.0, 1.0]]);
    let [triple] = cubic.intersections(&line, 1e-9).unwrap().try_into().unwrap();
    assert!(triple.kind != MeetingKind::Crossing && covers(&triple, [0.5, 0.5], 0.0), "{triple:?}");
    // Two circles that touch.
    let unit = circle();
    let points = unit.control_points().iter().map(|p| [p[0] + 2.0, p[1]]).collect::<Vec<_>>();
    let other =
        basis_runtime::bspline::NurbsCurve::new(unit.knots().clone(), points, unit.weights()).unwrap();
    let found = unit.intersections(&other, 1e-8).unwrap();
    assert!(!found.is_empty() && found.iter().all(|m| distance(m.point, [1.0, 0.0]) < 1e-3), "{found:?}");
}

#[test]
fn circles() {
    let unit = circle();
    let moved = |by: P2| {
        let points = unit.control_points().iter().map(|p| [p[0] + by[0], p[1] + by[1]]).collect::<Vec<_>>();
        basis_runtime::bspline::NurbsCurve::new(unit.knots().clone(), points, unit.weights()).unwrap()
    };
    let found = unit.intersections(&moved([1.0, 0.3]), 1e-12).unwrap();
    assert_eq!(found.len(), 2);
    for meeting in found {
        let [x, y] = meeting.point;
        assert!((x.hypot(y) - 1.0).abs() < 1e-14 && ((x - 1.0).hypot(y - 0.3) - 1.0).abs() < 1e-13);
        assert_eq!(meeting.kind, MeetingKind::Crossing);
    }
    assert_eq!(unit.intersections(&moved([3.0, 0.0]), 1e-9), Some(vec![]));
    assert_eq!(unit.self_intersections(1e-9), Some(vec![]));
    let [diameter, other] = unit.plane_intersections([0.0, 0.0], [3.0, -4.0]).unwrap().try_into().unwrap();
    assert!(distance(diameter.point, [0.8, 0.6]) < 1e-15 && distance(other.point, [-0.8, -0.6]) < 1e-15);
}

/// Parts of one curve that overlap for some of their length.
#[test]
fn overlapping_curves() {
    let whole = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    let (first, second) = (whole.subsegment(0.0..0.7).unwrap(), whole.subsegment(0.4..1.0).unwrap());
    let found = first.intersections(&second, 1e-4).unwrap();
    let [overlap] = found.try_into().unwrap();
    assert_eq!(overlap.kind, MeetingKind::Overlap);
    let covered = |[lo, hi]: [f64; 2], [a, b]: [f64; 2]| lo <= a && hi >= b && lo > a - 0.01 && hi < b + 0.01;
    assert!(covered(overlap.first, [4.0 / 7.0, 1.0]) && covered(overlap.second, [0.0, 0.5]), "{overlap:?}");
    let line = Bezier::from_points([[0.0, 0.0], [2.0, 0.0]]);
    let backwards = Bezier::from_points([[3.0, 0.0], [1.0, 0.0]]);
    let [overlap] = line.intersections(&backwards, 1e-6).unwrap().try_into().unwrap();
    assert!(overlap.kind == MeetingKind::Overlap && covered(overlap.first, [0.5, 1.0]), "{overlap:?}");
}

#[test]
fn in_space() {
    let random = &mut Random::new(1902);
    for _ in 0..40 {
        // Two cubics through one point.
        let (a, mut b) = (cubic::<3>(random), cubic::<3>(random));
        let (s, t): (f64, f64) = (random.between(0.05, 0.95), random.between(0.05, 0.95));
        let (p, q) = (a.eval(s), b.eval(t));
        let moved = |i: usize| core::array::from_fn(|d| b.control_points()[i][d] + p[d] - q[d]);
        b = Bezier::from_points(core::array::from_fn::<P3, 4, _>(moved));
        let found = a.intersections(&b, 1e-9).unwrap();
        let is_it = |m: &Meeting<P3>| (m.at[0] - s).abs() < 1e-6 && (m.at[1] - t).abs() < 1e-6;
        assert!(found.iter().any(is_it) && found.len() <= 2, "{s} {t} {found:?}");
        // A millimetre apart they do not meet; within an accuracy of a centimetre they do.
        let away = |i: usize| core::array::from_fn(|d| b.control_points()[i][d] + 1e-3 * [0.6, 0.0, 0.8][d]);
        let c = Bezier::from_points(core::array::from_fn::<P3, 4, _>(away));
        assert!(a.intersections(&c, 1e-2).unwrap().iter().any(|m| (m.at[0] - s).abs() < 0.2));
        let [x, y, z] = c.tangent(t).unwrap();
        let u = a.tangent(s).unwrap();
        let normal = [u[1] * z - u[2] * y, u[2] * x - u[0] * z, u[0] * y - u[1] * x];
        let gap = 1e-3 * (0.6 * normal[0] + 0.8 * normal[2]).abs();
        if gap > 5e-4 {
            let near = |m: &Meeting<P3>| (m.at[0] - s).abs() < 0.01;
            assert!(!a.intersections(&c, 1e-9).unwrap().iter().any(near));
        }
    }
}

#[test]
fn with_themselves() {
    let random = &mut Random::new(1903);
    let mut total = 0;
    for _ in 0..60 {
        let curve = cubic::<2>(random);
        let found = curve.self_intersections(1e-9).unwrap();
        // Of a cubic there is at most one double point: a quadratic equation of which both zeros are inside.
        let expected =
            brute(&curve, &curve, 300).into_iter().filter(|[s, t]| t - s > 0.02).collect::<Vec<_>>();
        for &at in &expected {
            assert!(found.iter().any(|meeting| covers(meeting, at, 0.02)), "{at:?} {found:?}");
        }
        assert!(found.len() <= 1 && found.iter().all(|m| m.at[0] < m.at[1]), "{found:?}");
        total += expected.len();
    }
    assert!(total > 5, "{total}");
    let eight = PiecewiseCurve::new(vec![
        Bezier::from_points([[0.0, 0.0], [2.0, 2.0], [2.0, -2.0], [0.0, 0.0]]),
        Bezier::from_points([[0.0, 0.0], [-2.0, 2.0], [-2.0, -2.0], [0.0, 0.0]]),
    ])
    .unwrap();
    let found = eight.self_intersections(1e-9).unwrap();
    assert!(found.iter().all(|m| distance(m.point, [0.0; 2]) < 1e-6), "{found:?}");
    let arch = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    assert_eq!(arch.self_intersections(1e-9), Some(vec![]));
}

#[test]
fn with_planes() {
    let random = &mut Random::new(1904);
    for _ in 0..40 {
        let curve = spline::<3>(random);
        let (point, normal): (P3, P3) =
            ([(); 3].map(|()| random.between(-0.3, 0.3)), [(); 3].map(|()| random.between(-1.0, 1.0)));
        let height = |t: f64| (0..3).map(|d| (curve.eval(t)[d] - point[d]) * normal[d]).sum::<f64>();
        let found = curve.plane_intersections(point, normal).unwrap();
        let [lo, hi] = curve.domain();
        let at = |k: u32| lo + (hi - lo) * f64::from(k) / 4000.0;
        let expected: Vec<f64> =
            (0..4000).filter(|&k| (height(at(k)) > 0.0) != (height(at(k + 1)) > 0.0)).map(at).collect();
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        for (meeting, t) in found.iter().zip(expected) {
            assert!((meeting.interval[0] - t).abs() < 2e-3 && height(meeting.interval[0]).abs() < 1e-13);
            assert_eq!(meeting.kind, MeetingKind::Crossing);
        }
    }
    let flat = BSplineCurve::from_bezier([[0.0, 0.0, 1.0], [1.0, 2.0, 1.0], [2.0, 0.0, 1.0]]).unwrap();
    let [lies] = flat.plane_intersections([0.0, 0.0, 1.0], [0.0, 0.0, 2.0]).unwrap().try_into().unwrap();
    assert_eq!((lies.kind, lies.interval), (MeetingKind::Overlap, [0.0, 1.0]));
    assert_eq!(flat.plane_intersections([0.0; 3], [0.0; 3]), None);
    // A corner in the plane: the curve goes on at the other side, or comes back.
    let corner = |end: f64| {
        let legs = [[0.0, 0.0], [1.0, 1.0]].map(|p| p);
        PiecewiseCurve::new(vec![Bezier::from_points(legs), Bezier::from_points([[1.0, 1.0], [2.0, end]])])
            .unwrap()
    };
    for (end, kind) in [(2.0, MeetingKind::Crossing), (0.0, MeetingKind::Contact)] {
        let [met] = corner(end).plane_intersections([0.0, 1.0], [0.0, 1.0]).unwrap().try_into().unwrap();
        assert_eq!((met.kind, met.interval), (kind, [1.0; 2]));
    }
}

#[test]
fn of_hostile_curves() {
    let curve =
        |size: f64| Bezier::from_points([[0.0, 0.0], [size, 2.0 * size], [3.0 * size, -size], [size, size]]);
    for size in [f64::NAN, f64::INFINITY] {
        assert_eq!(curve(size).intersections(&curve(1.0), 1e-9), None);
        assert_eq!(curve(size).self_intersections(1e-9), None);
        assert_eq!(curve(size).plane_intersections([0.0; 2], [1.0, 0.0]), None);
    }
    for size in [0.0, 1e-300, 1e-9, 1e9, 1e300] {
        for accuracy in [0.0, -1.0, f64::NAN, 1e-3 * size, f64::INFINITY] {
            let found = curve(size).intersections(&curve(0.5 * size), accuracy).unwrap();
            assert!(!found.is_empty(), "{size} {accuracy}"); // both begin at the origin
            assert!(curve(size).self_intersections(accuracy).unwrap().len() < 3);
        }
    }
    let point = Curve::new(basis_runtime::BernsteinBasis::<f64, 1>::new(), [[1.0, 2.0]]);
    assert_eq!(point.intersections(&point, 1e-9).unwrap().len(), 1);
    assert_eq!(point.self_intersections(1e-9), Some(vec![]));
}

/// Curves that nearly coincide cross where they should, however small the angle is, and each place is one answer.
#[test]
fn of_nearly_equal_curves() {
    let round = Path::circle([0.0, 0.0], 1.0);
    for by in [1e-3, 1e-5, 1e-7, 1e-8] {
        for (direction, places) in
            [([1.0, 0.0], [1.0, 3.0]), ([0.0, 1.0], [0.0, 2.0]), ([0.6, 0.8], [1.5858, 3.5858])]
        {
            for accuracy in [1e-9, 1e-12] {
                let other = Path::circle(direction.map(|d| by * d), 1.0);
                let found = round.intersections(&other, accuracy).unwrap();
                assert_eq!(found.len(), 2, "{by} {direction:?} {accuracy} {found:?}");
                for t in places {
                    let beside = |at: f64| (at - t).abs().min((at - t - 4.0).abs()) < by + 1e-4;
                    assert!(found.iter().any(|m| beside(m.at[0]) && m.distance < accuracy), "{found:?}");
                }
            }
        }
    }
    let arch = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]);
    for e in [1e-4, 1e-6, 1e-7, 1e-8] {
        let lower = arch.map(|[x, y]| [x, y * (1.0 - e) + 0.25 * e]);
        let [left, right] = arch.intersections(&lower, 1e-9).unwrap().try_into().unwrap();
        assert!(covers(&left, [0.25; 2], 1e-7) && covers(&right, [0.75; 2], 1e-7), "{left:?} {right:?}");
    }
    let wave = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, -2.0], [3.0, 1.0]]);
    let tilted = wave.map(|[x, y]| [x, y + 1e-8 * (x - 0.7)]);
    let [met]: [Meeting<P2>; 1] = wave.intersections(&tilted, 1e-10).unwrap().try_into().unwrap();
    assert!((met.at[0] - 0.7 / 3.0).abs() < 1e-6 && met.distance < 1e-12, "{met:?}");
    // In space, with a height that is zero at one place.
    let lifted = wave.map(|[x, y]| [x, y, 0.3 * x]);
    let other = wave.map(|[x, y]| [x, y + 1e-7 * (x - 0.7), 0.3 * x + 2e-7 * (x - 0.7)]);
    let [met]: [Meeting<P3>; 1] = lifted.intersections(&other, 1e-10).unwrap().try_into().unwrap();
    assert!((met.at[0] - 0.7 / 3.0).abs() < 1e-3 && met.distance < 1e-10, "{met:?}");
}

/// A place at the end of a closed curve is one answer, and a curve that starts elsewhere is the same curve.
#[test]
fn through_the_ends_of_closed_curves() {
    let round = Path::circle([0.0, 0.0], 1.0);
    let [touch] = round.intersections(&Path::circle([2.0, 0.0], 1.0), 1e-9).unwrap().try_into().unwrap();
    assert_eq!(touch.kind, MeetingKind::Contact);
    assert!(touch.first[0] > 3.99 && touch.first[1] < 0.01, "{touch:?}");
    let [inside] = round.intersections(&Path::circle([0.5, 0.0], 0.5), 1e-9).unwrap().try_into().unwrap();
    assert!(inside.first[0] > inside.first[1] && inside.second[0] > inside.second[1], "{inside:?}");
    let turned = round.map(|[x, y]: P2| [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y]);
    let [same] = round.intersections(&turned, 1e-9).unwrap().try_into().unwrap();
    assert_eq!((same.kind, same.first, same.second), (MeetingKind::Overlap, [0.0, 4.0], [0.0, 4.0]));
    let line = Path::polyline(&[[0.0, 0.0], [2.0, 0.0]]).unwrap();
    let [cross] = round.intersections(&line, 1e-9).unwrap().try_into().unwrap();
    assert!(cross.kind == MeetingKind::Crossing && cross.point == [1.0, 0.0], "{cross:?}");
}
