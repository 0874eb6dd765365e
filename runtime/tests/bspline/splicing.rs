//! Splicing: all edges, orientations and methods; tolerances measured independently; what is refused.

use basis_runtime::Surface;
use basis_runtime::bspline::{
    BSplineSurface, Continuity, Direction, Edge, EdgeKnots, EdgePair, KnotVector, Method, Net, Orientation,
    SecondRow, SpliceError, SpliceOptions,
};
use proptest::prelude::*;

#[cfg(feature = "nalgebra")]
use crate::golden::{assert_near, golden, knots, points};
use crate::support::{P3, at_edge, cross, distance, dot, edge, orientation, surface};
#[cfg(feature = "nalgebra")]
use serde_json::Value;

/// The methods, each with options for the tests. The dense systems of the published method take long without
/// optimisation, so it is asked for less.
fn methods() -> Vec<SpliceOptions> {
    let options = SpliceOptions::default();
    vec![
        #[cfg(feature = "nalgebra")]
        options.method(Method::Midpoints).angle(2e-3).spans(60).edge_knots(EdgeKnots::Own),
        options.method(Method::LeastSquares),
        options.method(Method::Exact),
    ]
}

fn is_published(options: &SpliceOptions) -> bool {
    !matches!(options.method, Method::LeastSquares | Method::Exact)
}

/// Gap and angle from nothing but points and partial derivatives, at 1000 parameters away from knots.
fn independent(a: &BSplineSurface<P3>, b: &BSplineSurface<P3>, joint: EdgePair) -> (f64, f64) {
    let (mut gap, mut angle) = (0.0_f64, 0.0_f64);
    for i in 0..1000 {
        let part = (f64::from(i) + 0.5) / 1000.0;
        let (p, out, tangent) = at_edge(a, joint.first, part, 1.0);
        let other = if joint.orientation == Orientation::Opposite { 1.0 - part } else { part };
        let (q, into, other) = at_edge(b, joint.second, other, -1.0);
        let other = other.map(|x| if joint.orientation == Orientation::Opposite { -x } else { x });
        gap = gap.max(distance(p, q));
        let (n, m) = (cross(out, tangent), cross(into, other));
        angle = angle.max(distance(cross(n, m), [0.0; 3]).atan2(dot(n, m)));
    }
    (gap, angle)
}

/// The shortest normal along the second edge of a joint, the cross product of the derivatives across and along it, as
/// a part of the longest.
fn least_normal(surface: &BSplineSurface<P3>, joint: EdgePair) -> f64 {
    let at = |i: i32| {
        let (_, into, along) = at_edge(surface, joint.second, f64::from(i) / 10_000.0, -1.0);
        distance(cross(into, along), [0.0; 3])
    };
    let (least, most) = (0..=10_000).map(at).fold((f64::INFINITY, 0.0), |(a, b), n| (n.min(a), n.max(b)));
    least / most
}

/// A surface of degree `k` over uneven knots; `x` from `from` to `from + 1`, `y` from 0 to 1, with the given waves.
fn sheet(k: usize, spans: usize, from: f64, waves: [f64; 4]) -> BSplineSurface<P3> {
    let breakpoints: Vec<f64> =
        (0..=spans).map(|i| i as f64 / spans as f64).map(|t| t * (0.8 + 0.2 * t)).collect();
    let along = KnotVector::clamped(k, &breakpoints).unwrap();
    let across = KnotVector::uniform(k, 4).unwrap();
    let (gu, gv) = (across.greville(), along.greville());
    let net = Net::from_fn(gu.len(), gv.len(), |i, j| {
        let (x, y): (f64, f64) = (from + gu[i], gv[j]);
        [x + 0.1 * waves[0] * y * y, y + 0.1 * waves[1] * x, 0.3 * (waves[2] * y + waves[3] * x).sin()]
    });
    BSplineSurface::new(across, along, net.unwrap()).unwrap()
}

/// The same surface with its parameters exchanged and mirrored so that the edge that was `UEnd` becomes `edge`.
fn turned(surface: &BSplineSurface<P3>, from: Edge, to: Edge, flipped: bool) -> BSplineSurface<P3> {
    let mut surface = surface.clone();
    if flipped {
        let along = if from.across() == Direction::U { Direction::V } else { Direction::U };
        surface = surface.reversed(along);
    }
    if from.is_end() != to.is_end() {
        surface = surface.reversed(from.across());
    }
    if from.across() == to.across() { surface } else { surface.transposed() }
}

#[test]
fn every_edge_in_both_directions_by_every_method() {
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    for options in methods() {
        for edge in Edge::ALL {
            for target in Edge::ALL {
                if is_published(&options) && target != Edge::VEnd {
                    continue;
                }
                for flips in 0..4 {
                    let a = turned(&left, Edge::UEnd, edge, flips % 2 == 1);
                    let b = turned(&right, Edge::UStart, target, flips >= 2);
                    let joint = EdgePair::nearest(&a, edge, &b, target);
                    assert_eq!(joint.orientation == Orientation::Opposite, flips == 1 || flips == 2);
                    let found = b.continued_within(joint.swapped(), &options, &a).unwrap();
                    let (gap, angle) = independent(&found.surface, &b, joint);
                    assert!(gap <= options.gap && angle <= options.angle, "{options:?} {gap} {angle}");
                    // The opposite edge and its second row stay where they were.
                    for t in [0.0, 0.3, 1.0] {
                        let opposite = edge.opposite();
                        let (p, q) = (a.boundary(opposite), found.surface.boundary(opposite));
                        assert!(distance(p.eval(t), q.eval(t)) < 1e-14);
                    }
                    if options.method == Method::Exact {
                        assert!(gap < 1e-14 && angle < 1e-13, "{gap} {angle}");
                    }
                }
            }
        }
    }
}

/// The rows that the quadratic programmes of the paper have, solved by numpy from the KKT systems as they are written.
#[cfg(feature = "nalgebra")]
#[test]
fn the_published_method_solves_its_programmes() {
    for case in golden("splices") {
        let along = [0, 1].map(|i| knots(&case["degrees"][i], &case["knots"][i]));
        let across = KnotVector::uniform(3, 1).unwrap();
        let rows = |value: &Value| [0, 1].map(|i| points::<3>(&value[i]));
        let ([edge, inner], [other, next]) = (rows(&case["rows"]), rows(&case["target"]));
        let shifted = |row: &[P3], by: f64| row.iter().map(|[x, y, z]| [x + by, *y, *z]).collect::<Vec<P3>>();
        let net = Net::from_rows([shifted(&inner, -0.6), shifted(&inner, -0.3), inner, edge]).unwrap();
        let surface = BSplineSurface::new(across.clone(), along[0].clone(), net).unwrap();
        let net = Net::from_rows([other, next.clone(), shifted(&next, 0.3), shifted(&next, 0.6)]).unwrap();
        let target = BSplineSurface::new(across, along[1].clone(), net).unwrap();
        // Whatever one round gives is good enough.
        let options = SpliceOptions::default()
            .method(Method::Midpoints)
            .gap(1e3)
            .angle(1e3)
            .second_row(SecondRow::Kept)
            .edge_knots(EdgeKnots::Own);
        let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
        let found = target.continued_within(joint.swapped(), &options, &surface).unwrap();
        assert_eq!(found.rounds, 1);
        let [edge, inner] = rows(&case["spliced"]);
        assert_near(found.surface.net().row(3), &edge, 1e-10);
        assert_near(found.surface.net().row(2), &inner, 1e-10);
    }
}

#[test]
fn different_degrees() {
    for options in methods() {
        for (a, b) in [(1, 3), (2, 3), (3, 2), (4, 3), (3, 5), (5, 5), (1, 1)] {
            let left = sheet(a, 5, -1.0, [0.5, -0.5, 3.0, 1.0]);
            let right = sheet(b, 7, 0.0, [0.4, 0.6, 3.1, -0.4]);
            let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
            match right.continued_within(joint.swapped(), &options, &left) {
                Ok(found) => {
                    let (gap, angle) = independent(&found.surface, &right, joint);
                    assert!(
                        gap <= options.gap && angle <= options.angle,
                        "{options:?} {a} {b}: {gap} {angle}"
                    );
                }
                // The published method is not made for everything, but it says so.
                Err(error) => {
                    assert!(is_published(&options), "{a} {b}: {error}");
                }
            }
        }
    }
}

#[test]
fn ends_do_not_hinder_least_squares_over_own_knots() {
    // With every division of the last span its tangent would become worse if it were fitted, not met.
    let across = KnotVector::uniform(5, 4).unwrap();
    let left = KnotVector::clamped(5, &[0.0, 0.22, 0.41, 0.63, 0.8, 1.0]).unwrap();
    let right = KnotVector::clamped(3, &[0.0, 0.09, 0.2, 0.37, 0.45, 0.6, 0.78, 0.9, 1.0]).unwrap();
    let over = |along: KnotVector<f64>, shape: fn(f64, f64) -> P3| {
        let (u, v) = (across.greville(), along.greville());
        let net = Net::from_fn(u.len(), v.len(), |i, j| shape(u[i], v[j])).unwrap();
        BSplineSurface::new(across.clone(), along, net).unwrap()
    };
    let left = over(left, |u, v| [u, v, 0.3 * (4.2 * v + 0.4).sin() * (0.6 + 0.4 * u)]);
    let right = over(right, |u, v| {
        let hill = 0.05 * (-((v - 0.55) / 0.3).powi(2)).exp();
        let z = 0.3 * (4.2 * v + 0.4).sin() * (1.0 - 0.35 * u) + hill * (1.0 - 0.6 * u) + 0.15 * u;
        [1.0 + u + 0.08 * (5.0 * v).sin(), v + 0.05 * u * v, z]
    });
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    for (second_row, spans) in [(SecondRow::Kept, 100), (SecondRow::Carried, 40)] {
        let options = SpliceOptions::default().method(Method::LeastSquares).edge_knots(EdgeKnots::Own);
        let options = options.second_row(second_row).spans(spans);
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        let (gap, angle) = independent(&found.surface, &right, joint);
        assert!(gap <= options.gap && angle <= options.angle);
        // Tangents along the edge agree at its ends, but for rounding.
        for t in [0.0, 1.0] {
            let (a, b) = (found.surface.partial(1.0, t, [0, 1]), right.partial(0.0, t, [0, 1]));
            assert!(distance(a, b) < 1e-11);
        }
    }
}

#[test]
fn different_domains_and_single_precision() {
    let knots = |lo: f32, hi: f32, spans: usize| {
        KnotVector::<f32>::uniform(3, spans).unwrap().mapped([lo, hi]).unwrap()
    };
    let sheet = |v: KnotVector<f32>, from: f32| {
        let u = KnotVector::<f32>::uniform(3, 3).unwrap();
        let [lo, hi] = v.domain();
        let net = Net::from_fn(6, v.functions(), |i, j| {
            let (x, y) = (from + u.greville()[i], (v.greville()[j] - lo) / (hi - lo));
            [x, y, 0.2 * (3.0 * y).sin() + 0.1 * x * y]
        });
        BSplineSurface::new(u, v.clone(), net.unwrap()).unwrap()
    };
    let (left, right) = (sheet(knots(0.0, 1.0, 4), -1.0), sheet(knots(-2.0, 5.0, 7), 0.0));
    let joint = EdgePair::nearest(&left, Edge::UEnd, &right, Edge::UStart);
    for options in methods() {
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        assert!(found.joint.gap <= options.gap && found.joint.angle <= options.angle);
        assert_eq!(found.joint, right.joint_bounds(joint.swapped(), &found.surface).unwrap());
    }
    // A tolerance that single precision cannot meet.
    let options = SpliceOptions::default().gap(1e-12);
    let error = right.continued_within(joint.swapped(), &options, &left).unwrap_err();
    let SpliceError::NotReached { achieved, .. } = error else { panic!("{error}") };
    assert!(achieved.gap > 1e-12 && achieved.gap < 1e-5);
}

/// Where figures are largest, and where there is no tangent plane, is said in the parameter of the surface that stays.
#[test]
fn places_are_those_of_the_surface_that_stays() {
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let moved = |surface: &BSplineSurface<P3>| {
        let [u, v] = [Direction::U, Direction::V].map(|direction| surface.knots(direction));
        BSplineSurface::new(u.clone(), v.mapped([2.0, 6.0]).unwrap(), surface.net().clone()).unwrap()
    };
    for edges in [EdgePair::along(Edge::UStart, Edge::UEnd), EdgePair::against(Edge::UStart, Edge::UEnd)] {
        let options = SpliceOptions::default().method(Method::LeastSquares).spans(13);
        let [here, there] = [right.clone(), moved(&right)].map(|right| {
            let error = right.continued_within(edges, &options, &left).unwrap_err();
            let SpliceError::NotReached { achieved, .. } = error else { panic!("{error}") };
            achieved
        });
        assert!((here.angle_at * 4.0 + 2.0 - there.angle_at).abs() < 1e-6, "{here:?} {there:?}");
        // Without a tangent plane on the last span, where the row next to the edge lies on it.
        let mut flat = moved(&right);
        let columns = flat.net().columns();
        for j in columns - 4..columns {
            let edge = flat.net()[[0, j]];
            flat.control_points_mut()[columns + j] = edge;
        }
        let error = flat.continued_within(edges, &SpliceOptions::default(), &left).unwrap_err();
        let SpliceError::Degenerate { parameter } = error else { panic!("{error}") };
        assert!((5.0..=6.0).contains(&parameter), "{parameter}");
    }
}

#[test]
fn positions_only() {
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    for options in methods() {
        let options = options.continuity(Continuity::G0);
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        assert!(independent(&found.surface, &right, joint).0 <= options.gap);
        // Tangent planes are not touched on purpose.
        assert!(found.joint.angle > 1e-3);
    }
}

#[test]
fn the_change_is_how_far_the_rows_moved() {
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let joint = EdgePair::along(Edge::UStart, Edge::UStart);
    let left = right.map(|[x, y, z]| [x, y, z + 0.25]);
    for method in [Method::LeastSquares, Method::Exact] {
        // Carried along, both rows move by a quarter.
        let options = SpliceOptions::default().method(method).continuity(Continuity::G0);
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        assert!((found.change - 0.25).abs() < 1e-14);
        let options = options.method(method).second_row(SecondRow::Kept);
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        assert!((found.change - 0.25).abs() < 1e-14);
    }
    // For a smooth joint the second row swings to the other side of the edge; no point moves further than `change`.
    let found = right.continued_within(joint.swapped(), &SpliceOptions::default(), &left).unwrap();
    let far = (0..=200).map(|i| {
        let t = f64::from(i) / 200.0;
        (0..=40)
            .map(|j| f64::from(j) / 40.0)
            .map(|u| distance(found.surface.eval(u, t), left.eval(u, t)))
            .fold(0.0, f64::max)
    });
    let far = far.fold(0.0, f64::max);
    assert!(far <= found.change * (1.0 + 1e-3) && far >= 0.5 * found.change, "{far} {}", found.change);
}

#[test]
fn positions_only_where_no_tangent_plane_is() {
    // The second row of the target is its edge, or its edge is one point.
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    let (columns, row) = (right.net().columns(), right.net().row(0).to_vec());
    let (mut narrow, mut pole) = (right.clone(), right);
    narrow.control_points_mut()[columns..2 * columns].copy_from_slice(&row);
    pole.control_points_mut()[..columns].fill(row[0]);
    for target in [narrow, pole] {
        // The tangents to which the published method adjusts the edge do not exist at a pole.
        for options in methods().into_iter().filter(|options| !is_published(options)) {
            let found = target.continued_within(joint.swapped(), &options.continuity(Continuity::G0), &left);
            let found = found.unwrap();
            for i in 0..=100 {
                let t = f64::from(i) / 100.0;
                assert!(distance(found.surface.eval(1.0, t), target.eval(0.0, t)) <= options.gap);
            }
        }
    }
}

#[test]
fn the_scale_of_the_parameters_has_no_say() {
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let folded = sheet(3, 5, 0.0, [1.0, -0.5, 4.0, 1.0]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    for surface in [left, folded] {
        for options in methods().into_iter().filter(|options| !is_published(options)) {
            let expected = right.continued_within(joint.swapped(), &options, &surface).unwrap();
            for size in [2.0_f64.powi(-20), 2.0_f64.powi(20)] {
                let [u, v] =
                    [Direction::U, Direction::V].map(|d| surface.knots(d).mapped([0.0, size]).unwrap());
                let scaled = BSplineSurface::new(u, v, surface.net().clone()).unwrap();
                let found = right.continued_within(joint.swapped(), &options, &scaled).unwrap();
                // Powers of two are exact: the net is the same, bit by bit.
                assert_eq!(found.surface.net(), expected.surface.net());
            }
        }
    }
}

#[test]
fn surfaces_never_fold_back() {
    // Both sheets lie over 0 <= x <= 1: the first has to leave the edge in the other direction.
    let lower = sheet(3, 5, 0.0, [0.0, 0.0, 3.0, 0.4]);
    let upper = sheet(3, 6, 0.0, [0.0, 0.0, 3.2, 0.3]);
    let joint = EdgePair::along(Edge::UStart, Edge::UStart);
    let before = lower.joint_bounds(joint, &upper).unwrap();
    assert!(before.angle > 3.0); // the angle of a fold is near π, not near 0
    for method in [Method::LeastSquares, Method::Exact] {
        let options = SpliceOptions::default().method(method);
        let found = upper.continued_within(joint.swapped(), &options, &lower).unwrap();
        let (gap, angle) = independent(&found.surface, &upper, joint);
        assert!(gap <= options.gap && angle <= options.angle);
    }
}

#[test]
fn a_straight_edge() {
    let mut right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let greville = right.knots(Direction::V).greville();
    for (point, y) in right.control_points_mut().iter_mut().zip(greville) {
        *point = [0.0, y, 0.0];
    }
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    for options in methods() {
        let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
        let (gap, angle) = independent(&found.surface, &right, joint);
        assert!(gap <= options.gap && angle <= options.angle);
    }
}

#[test]
fn what_is_refused() {
    let left = sheet(3, 5, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let right = sheet(3, 8, 0.0, [0.8, 0.6, 4.2, -0.4]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let options = SpliceOptions::default().angle(bad);
        assert!(matches!(
            right.continued_within(joint.swapped(), &options, &left),
            Err(SpliceError::Tolerance { .. })
        ));
    }
    let options = SpliceOptions::default().method(Method::LeastSquares).spans(13);
    let error = right.continued_within(joint.swapped(), &options, &left).unwrap_err();
    let SpliceError::NotReached { achieved, spans, .. } = error else { panic!("{error}") };
    assert!(spans <= 13 && achieved.angle > 1e-4 && error.to_string().contains("wanted 1.000e-4"));

    // Below all rounding errors.
    let impossible = options.angle(1e-300).spans(1000);
    let error = right.continued_within(joint.swapped(), &impossible, &left).unwrap_err();
    assert!(matches!(error, SpliceError::NotReached { .. }), "{error}");

    let mut broken = left.clone();
    let last = broken.control_points_mut().len() - 1;
    broken.control_points_mut()[last] = [f64::NAN; 3];
    let options = SpliceOptions::default();
    assert_eq!(
        right.continued_within(joint.swapped(), &options, &broken).unwrap_err(),
        SpliceError::NotFinite
    );

    // A target whose edge and second row are one point.
    let mut point = right.clone();
    let columns = point.net().columns();
    for p in &mut point.control_points_mut()[..2 * columns] {
        *p = [0.0; 3];
    }
    let error = point.continued_within(joint.swapped(), &options, &left).unwrap_err();
    assert!(matches!(error, SpliceError::Degenerate { .. }), "{error}");
    for [a, b] in [[&left, &point], [&turned(&point, Edge::UStart, Edge::UEnd, false), &left]] {
        let error = a.joint_bounds(joint, b).unwrap_err().to_string();
        assert!(
            error.starts_with("a surface has no tangent plane at the parameter 0 of the joint"),
            "{error}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn random_sheets_reach_both_tolerances(
        degrees in [1..=5_usize, 1..=5_usize],
        spans in [2..9_usize, 2..9_usize],
        waves in [-1.0..1.0, -1.0..1.0, 1.0..4.0, -1.0..1.0],
        others in [-1.0..1.0, -1.0..1.0, 1.0..4.0, -1.0..1.0],
    ) {
        let left = sheet(degrees[0], spans[0], -1.0, waves);
        let right = sheet(degrees[1], spans[1], 0.0, others);
        let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
        for method in [Method::LeastSquares, Method::Exact] {
            let options = SpliceOptions::default().method(method);
            let found = right.continued_within(joint.swapped(), &options, &left).unwrap();
            let (gap, angle) = independent(&found.surface, &right, joint);
            prop_assert!(gap <= options.gap && angle <= options.angle);
        }
    }

    #[test]
    fn any_surfaces_are_joined_or_refused(
        left in surface(), right in surface(), edge in edge(), target in edge(), orientation in orientation(),
    ) {
        let joint = EdgePair { first: edge, second: target, orientation };
        for options in methods() {
            let options = options.spans(30);
            match right.continued_within(joint.swapped(), &options, &left) {
                Ok(found) => {
                    let (gap, angle) = independent(&found.surface, &right, joint);
                    prop_assert!(gap <= options.gap && angle <= options.angle, "{} {}", gap, angle);
                }
                // Exact joins exist for all but surfaces without tangent planes. Next to such a surface the normals are
                // differences of numbers that nearly agree, and the bound of the angle holds for all that rounding can
                // have done to them.
                Err(e) if options.method == Method::Exact => {
                    let flat = left.joint_bounds(joint, &right).is_err();
                    prop_assert!(flat || least_normal(&right, joint) < 1e-3, "{} {}", e, least_normal(&right, joint));
                }
                Err(_) => {}
            }
        }
    }
}

/// Normal curvatures agree across all edges in both directions, whatever degrees and knots; tangent planes alone leave them
/// apart.
#[test]
fn curvatures_are_continuous() {
    let options = SpliceOptions::default();
    for (k, l) in [(1, 3), (2, 4), (3, 3), (3, 1), (4, 2), (5, 3)] {
        let left = sheet(k, 3, -1.0, [1.0, -0.5, 4.0, 1.0]);
        let right = sheet(l, 5, 0.0, [0.8, 0.6, 4.2, -0.4]);
        for (n, edge) in Edge::ALL.into_iter().enumerate() {
            for flips in 0..4 {
                let target = Edge::ALL[(n + flips) % 4];
                let a = turned(&left, Edge::UEnd, edge, flips % 2 == 1);
                let b = turned(&right, Edge::UStart, target, flips >= 2);
                let joint = EdgePair::nearest(&a, edge, &b, target);
                let curvature = |continuity| {
                    let found =
                        b.continued_within(joint.swapped(), &options.continuity(continuity), &a).unwrap();
                    let opposite = edge.opposite();
                    for t in [0.0, 0.3, 1.0] {
                        let [p, q] = [&a, &found.surface].map(|surface| at_edge(surface, opposite, t, 1.0));
                        assert!(distance(p.0, q.0) < 1e-13 && distance(p.1, q.1) < 1e-11);
                    }
                    let measured = found.surface.joint(joint, &b, 129);
                    assert!(measured.gap < 1e-13 && measured.angle < 1e-12, "{measured:?}");
                    (measured.curvature, found.change)
                };
                let ((apart, _), (found, change)) = (curvature(Continuity::G1), curvature(Continuity::G2));
                assert!(found < 1e-9, "{found} at degrees {k}, {l}, {joint:?}");
                assert!(apart > 1e-2 && change > 0.0, "{apart}");
            }
        }
    }
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    let sheets = [-1.0, 0.0].map(|from| sheet(3, 2, from, [0.0; 4]));
    let options = options.continuity(Continuity::G2).method(Method::LeastSquares);
    let refused = sheets[1].continued_within(joint.swapped(), &options, &sheets[0]).unwrap_err();
    assert_eq!(refused, SpliceError::Curvatures);
}

/// No point moves further than the splice says, also where the third row moves most.
#[test]
fn the_change_counts_all_rows() {
    let a = sheet(3, 4, -1.0, [1.0, -0.5, 4.0, 1.0]);
    let b = sheet(3, 5, 0.0, [0.8, 0.6, 9.2, -6.4]);
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    let found = b
        .continued_within(joint.swapped(), &SpliceOptions::default().continuity(Continuity::G2), &a)
        .unwrap();
    let places = || (0..=40).flat_map(|i| (0..=40).map(move |j| [i, j].map(|x| f64::from(x) / 40.0)));
    let moved = places().map(|[u, v]| distance(a.eval(u, v), found.surface.eval(u, v))).fold(0.0, f64::max);
    assert!(moved > 0.1 && moved <= found.change * (1.0 + 1e-9), "{moved}, {}", found.change);
}
