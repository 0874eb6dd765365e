//! Where random and degenerate curves meet themselves and each other, beside a search by boxes alone: nothing is missed,
//! nothing is invented. `CASES=10000` tests more of each kind.

use basis_runtime::bspline::{BSplineCurve, NurbsCurve};
use basis_runtime::{Meeting, MeetingKind, ParametricCurve};

use crate::queries::distance;
use crate::random::Random;

/// A rational Bézier curve over 0 ≤ t ≤ 1: points, and weights.
type Points<const D: usize> = (Vec<[f64; D]>, Vec<f64>);

type Dynamic<'a, const D: usize> = &'a dyn ParametricCurve<Point = [f64; D]>;

const KINDS: usize = 11;

fn cases(usual: usize) -> usize {
    std::env::var("CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

fn random_curve<const D: usize>(random: &mut Random, degree: usize, whole: bool) -> Points<D> {
    let mut coordinate =
        || -> f64 { if whole { random.below(7) as f64 - 3.0 } else { random.between(-1.0, 1.0) } };
    let points = (0..=degree).map(|_| [(); D].map(|()| coordinate())).collect();
    (points, vec![1.0; degree + 1])
}

fn value<const D: usize>((points, weights): &Points<D>, t: f64) -> [f64; D] {
    let mut rows: Vec<([f64; D], f64)> =
        points.iter().zip(weights).map(|(p, w)| (p.map(|x| x * w), *w)).collect();
    while rows.len() > 1 {
        rows = rows.windows(2).map(|pair| middle(pair[0], pair[1], t)).collect();
    }
    rows[0].0.map(|x| x / rows[0].1)
}

fn middle<const D: usize>(a: ([f64; D], f64), b: ([f64; D], f64), t: f64) -> ([f64; D], f64) {
    (core::array::from_fn(|d| (1.0 - t) * a.0[d] + t * b.0[d]), (1.0 - t) * a.1 + t * b.1)
}

/// The part of a polynomial curve between two parameters, by its polar form.
fn part<const D: usize>((points, _): &Points<D>, from: f64, to: f64) -> Points<D> {
    let degree = points.len() - 1;
    let point = |k: usize| {
        let mut row = points.clone();
        for step in 0..degree {
            let t = if step < k { to } else { from };
            row = row
                .windows(2)
                .map(|pair| core::array::from_fn(|d| (1.0 - t) * pair[0][d] + t * pair[1][d]))
                .collect();
        }
        row[0]
    };
    ((0..=degree).map(point).collect(), vec![1.0; degree + 1])
}

/// Two curves of a kind.
fn pair<const D: usize>(random: &mut Random, kind: usize) -> [Points<D>; 2] {
    let degrees = [0, 1].map(|_| {
        let most = if random.below(8) == 0 { 7 } else { 3 };
        1 + random.below(most)
    });
    let [mut a, mut b] = degrees.map(|degree| random_curve::<D>(random, degree, kind == 1));
    let moved = |b: &mut Points<D>, from: [f64; D], to: [f64; D]| {
        for p in &mut b.0 {
            *p = core::array::from_fn(|d| p[d] - from[d] + to[d]);
        }
    };
    let (s, t): (f64, f64) = (random.unit(), random.unit());
    match kind {
        // In space curves meet only if they are made to.
        0 | 1 if D == 3 => {
            let (p, q) = (value(&a, s), value(&b, t));
            moved(&mut b, q, p);
        }
        2 => {
            for curve in [&mut a, &mut b] {
                let n = curve.0.len();
                match random.below(4) {
                    0 => curve.0[1] = curve.0[0],
                    1 => curve.0[n - 2] = curve.0[n - 1],
                    2 => curve.0 = vec![curve.0[0]; n],
                    _ => {}
                }
            }
            let (p, q) = (value(&a, s), value(&b, t));
            moved(&mut b, q, p);
        }
        3 => {
            let (p, q) = (a.0[0], b.0[b.0.len() - 1]);
            moved(&mut b, q, p);
        }
        4 => {
            let (p, q) = (value(&a, s), b.0[0]);
            moved(&mut b, q, p);
        }
        // They touch at the beginning of the second one.
        5 => {
            let (p, q) = (value(&a, s), value(&a, s + 1e-3));
            let length: f64 = random.between(-300.0, 300.0);
            b.0[0] = p;
            b.0[1] = core::array::from_fn(|d| p[d] + length * (q[d] - p[d]));
        }
        6 => {
            let [from, to]: [f64; 2] = [0, 1].map(|_| random.between(-0.5, 1.5));
            b = part(&a, from, to);
        }
        7 => {
            let whole = random.below(2) == 0;
            let line = random_curve::<D>(random, 1, whole);
            let ends: [f64; 2] = [0, 1].map(|_| random.between(-1.0, 2.0));
            b = part(&line, ends[0], ends[1]);
            a = line;
        }
        8 => b = a.clone(),
        9 => {
            for curve in [&mut a, &mut b] {
                curve.1 = curve.0.iter().map(|_| random.between(0.2, 4.0)).collect();
            }
            let (p, q) = (value(&a, s), value(&b, t));
            if random.below(2) == 0 {
                moved(&mut b, q, p);
            }
        }
        10 => {
            for curve in [&mut a, &mut b] {
                let n = curve.0.len();
                curve.0[n - 1] = curve.0[0];
            }
            let (p, q) = (value(&a, s), value(&b, t));
            moved(&mut b, q, p);
        }
        _ => {}
    }
    [a, b]
}

/// A part of a curve in the search by boxes: its interval, and homogeneous control points.
type Part<const D: usize> = ([f64; 2], Vec<([f64; D], f64)>);

fn halves<const D: usize>(([lo, hi], points): &Part<D>) -> [Part<D>; 2] {
    let (mut left, mut right, mut row) = (Vec::new(), Vec::new(), points.clone());
    while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
        left.push(first);
        right.push(last);
        row = row.windows(2).map(|pair| middle(pair[0], pair[1], 0.5)).collect();
    }
    right.reverse();
    let between = 0.5 * (lo + hi);
    [([*lo, between], left), ([between, *hi], right)]
}

fn bounds<const D: usize>((_, points): &Part<D>) -> [[f64; 2]; D] {
    core::array::from_fn(|d| {
        points
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], (p, w)| [lo.min(p[d] / w), hi.max(p[d] / w)])
    })
}

fn whole<const D: usize>((points, weights): &Points<D>) -> Part<D> {
    ([0.0, 1.0], points.iter().zip(weights).map(|(p, w)| (p.map(|x| x * w), *w)).collect())
}

/// Pairs of parameters near which the curves may meet: middles of parts no longer than `leaf` whose boxes do; `None` if
/// they are too many.
fn candidates<const D: usize>(a: &Part<D>, b: &Part<D>, leaf: f64, adjacent: f64) -> Option<Vec<[f64; 2]>> {
    let mut found = Vec::new();
    let mut open = vec![(a.clone(), b.clone())];
    let mut work = 0;
    while let Some((a, b)) = open.pop() {
        work += 1;
        if work > 6_000 {
            return None;
        }
        let (p, q) = (bounds(&a), bounds(&b));
        // Of one curve with itself only what is that far apart, the smaller parameter first.
        let apart = (0..D).any(|d| p[d][0] - q[d][1] > 1e-12 || q[d][0] - p[d][1] > 1e-12);
        if apart || b.0[1] - a.0[0] < adjacent {
            continue;
        }
        let size = |side: &[[f64; 2]; D]| side.iter().map(|[lo, hi]| hi - lo).fold(0.0, f64::max);
        if size(&p).max(size(&q)) <= leaf {
            found.push([0.5 * (a.0[0] + a.0[1]), 0.5 * (b.0[0] + b.0[1])]);
        } else if size(&p) >= size(&q) {
            open.extend(halves(&a).map(|half| (half, b.clone())));
        } else {
            open.extend(halves(&b).map(|half| (a.clone(), half)));
        }
    }
    Some(found)
}

const STEPS: [[f64; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];

/// Goes from a pair of parameters to one at which the curves are nearest; in steps that become shorter.
fn nearest<const D: usize>(a: &Points<D>, b: &Points<D>, start: [f64; 2]) -> ([f64; 2], f64) {
    let away = |[s, t]: [f64; 2]| distance(value(a, s), value(b, t));
    let (mut at, mut best, mut step) = (start, away(start), 1e-3);
    let mut rounds = 0;
    while step > 1e-17 && best > 0.0 && rounds < 300 {
        rounds += 1;
        let mut moved = false;
        for [x, y] in STEPS {
            let next = [(at[0] + x * step).clamp(0.0, 1.0), (at[1] + y * step).clamp(0.0, 1.0)];
            let distance = away(next);
            if distance < best {
                (at, best, moved) = (next, distance, true);
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    (at, best)
}

fn covers<const D: usize>(meeting: &Meeting<[f64; D]>, at: [f64; 2], gap: f64) -> bool {
    let within = |[lo, hi]: [f64; 2], t: f64| t >= lo - gap && t <= hi + gap;
    within(meeting.first, at[0]) && within(meeting.second, at[1])
}

/// What the answers have to be, of curves of size 1.
fn check<const D: usize>(
    a: &Points<D>,
    b: &Points<D>,
    found: &[Meeting<[f64; D]>],
    scale: f64,
    accuracy: f64,
    adjacent: f64,
    what: &str,
) -> usize {
    for meeting in found {
        let distance = distance(value(a, meeting.at[0]), value(b, meeting.at[1]));
        assert!(
            distance <= 2.0 * accuracy + 1e-13,
            "{what}: invented, {distance:e}: {meeting:?}\n{a:?}\n{b:?}"
        );
        assert!(meeting.distance / scale <= 2.0 * accuracy + 1e-13, "{what}: {meeting:?}");
        assert!(covers(meeting, meeting.at, 0.0), "{what}: {meeting:?}");
        if meeting.kind == MeetingKind::Overlap {
            for k in 0..=4 {
                let s = meeting.first[0] + 0.25 * f64::from(k) * (meeting.first[1] - meeting.first[0]);
                let mut best = f64::INFINITY;
                for j in 0..=200 {
                    let t =
                        meeting.second[0] + f64::from(j) / 200.0 * (meeting.second[1] - meeting.second[0]);
                    best = best.min(distance_at(a, b, [s, t]));
                }
                let long = distance_at(b, b, meeting.second);
                assert!(
                    best <= 0.1 * long + 4.0 * accuracy,
                    "{what}: no overlap, {best}: {meeting:?}\n{a:?}\n{b:?}"
                );
            }
        }
    }
    let (p, q) = (whole(a), whole(b));
    let places = [1e-5, 1e-4, 1e-3, 1e-2].iter().find_map(|leaf| candidates(&p, &q, *leaf, adjacent));
    let mut met = 0;
    let mut looked_at: Vec<[f64; 2]> = Vec::new();
    for start in places.unwrap_or_default() {
        if found.iter().any(|meeting| covers(meeting, start, 0.0)) {
            met += 1;
            continue;
        }
        if looked_at.iter().any(|other| (0..2).all(|k| (other[k] - start[k]).abs() < 1e-4))
            || looked_at.len() > 30
        {
            continue;
        }
        looked_at.push(start);
        let (at, distance) = nearest(a, b, start);
        // That a curve ends where it begins is no answer.
        let apart = at[1] - at[0] >= adjacent && (adjacent < 0.0 || at[1] - at[0] < 1.0 - 1e-6);
        if distance <= 1e-15 && apart {
            met += 1;
            let known = found.iter().any(|meeting| covers(meeting, at, 1e-5));
            assert!(known, "{what}: missing {at:?}, {distance:e}, in {found:?}\n{a:?}\n{b:?}");
        }
    }
    met
}

fn distance_at<const D: usize>(a: &Points<D>, b: &Points<D>, at: [f64; 2]) -> f64 {
    distance(value(a, at[0]), value(b, at[1]))
}

/// Calls `ask` with the curve in a scale, of the simplest type.
fn scaled<const D: usize, T>(
    (points, weights): &Points<D>,
    scale: f64,
    ask: impl FnOnce(Dynamic<'_, D>) -> T,
) -> T {
    let points: Vec<[f64; D]> = points.iter().map(|p| p.map(|x| scale * x)).collect();
    let spline = BSplineCurve::from_bezier(points.clone()).unwrap();
    if weights.iter().all(|&w| w == 1.0) {
        ask(&spline)
    } else {
        ask(&NurbsCurve::new(spline.knots().clone(), points, weights.clone()).unwrap())
    }
}

fn pairs_in<const D: usize>(seed: u64, count: usize) {
    let random = &mut Random::new(seed);
    let mut met = 0;
    for kind in 0..KINDS {
        for case in 0..cases(count) {
            let [a, b] = pair::<D>(random, kind);
            let scale = 2.0_f64.powi([0, 0, 0, 30, -30, 400, -400][random.below(7)]);
            // Curves that run along each other take the longer the smaller it is.
            let along = matches!(kind, 6..=8);
            let accuracy = if along { 1e-3 } else { [1e-3, 1e-6, 1e-9][random.below(3)] };
            let found = scaled(&a, scale, |first| {
                scaled(&b, scale, |second| first.intersections(second, accuracy * scale).unwrap())
            });
            met += check(&a, &b, &found, scale, accuracy, -2.0, &format!("{D}, {kind}, {case}, {accuracy}"));
        }
    }
    assert!(met > 0);
}

#[test]
fn pairs_in_the_plane() {
    pairs_in::<2>(1911, 30);
}

#[test]
fn pairs_in_space() {
    pairs_in::<3>(1912, 20);
}

#[test]
fn curves_with_themselves() {
    let random = &mut Random::new(1913);
    let mut met = 0;
    for case in 0..cases(60) {
        let degree = 3 + random.below(3);
        let whole = random.below(3) == 0;
        let curve = random_curve::<2>(random, degree, whole);
        let scale = 2.0_f64.powi([0, 0, 30, -400][random.below(4)]);
        let found = scaled(&curve, scale, |curve| curve.self_intersections(1e-9 * scale).unwrap());
        assert!(found.iter().all(|meeting| meeting.at[0] < meeting.at[1]), "{found:?}");
        met += check(&curve, &curve, &found, scale, 1e-9, 0.05, &format!("{case}"));
    }
    assert!(met > 0);
}

/// The end of a curve that rounding has left beside another one.
#[test]
fn ends_beside_curves() {
    let random = &mut Random::new(1914);
    for _ in 0..cases(200) {
        let (a, mut b) = (random_curve::<2>(random, 3, false), random_curve::<2>(random, 3, false));
        let s: f64 = random.between(0.1, 0.9);
        let (point, tangent) = scaled(&a, 1.0, |curve| (curve.eval(s), curve.tangent(s).unwrap()));
        let side = [-tangent[1], tangent[0]];
        // From the side, so that it does not cross before its end.
        b.0 = [3.0, 2.0, 1.0, 1e-7].map(|x| core::array::from_fn(|d| point[d] + x * side[d])).to_vec();
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 1e-6).unwrap()));
        assert!(
            found.iter().any(|m| covers(m, [s, 1.0], 1e-4) && m.distance <= 1e-6),
            "{s} {found:?}\n{a:?}"
        );
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 1e-9).unwrap()));
        assert!(!found.iter().any(|m| covers(m, [s, 1.0], 1e-6)), "{found:?}");
    }
}

/// In space the place where the projections of both curves cross is far from where they are near each other.
#[test]
fn near_in_space_beside_a_crossing_of_projections() {
    let steep = |x: f64| vec![[0.0, 0.0, 0.0], [x, 0.0, 1.0], [2.0 * x, 0.0, 0.0]];
    let across = |x: f64, z: f64| (vec![[x, -0.5, z], [x, 0.5, z]], vec![1.0; 2]);
    let a = (steep(0.02), vec![1.0; 3]);
    for (b, at) in [(across(5e-5, 0.0), [0.0, 0.5]), (across(0.004, 0.1825), [0.1, 0.5])] {
        let found = scaled(&a, 1.0, |a| scaled(&b, 1.0, |b| a.intersections(b, 5e-4).unwrap()));
        assert!(found.iter().any(|m| covers(m, at, 5e-3) && m.distance <= 5e-4), "{found:?}");
    }
}
