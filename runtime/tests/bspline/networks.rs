//! Networks: neighbours follow a deformed patch, corners included; the others stay bit by bit the same.

use basis_runtime::bspline::{
    BSplineSurface, Direction, Edge, EdgePair, FollowOptions, Followed, KnotVector, Method, Net, Network,
    NetworkError, PointConstraint, Seam, SpliceOptions,
};
use proptest::prelude::*;

use crate::support::{P3, distance};

/// A smooth landscape over the unit square.
fn landscape(spans: usize, waves: [f64; 3]) -> BSplineSurface<P3> {
    let knots = KnotVector::uniform(3, spans).unwrap();
    let g = knots.greville();
    let net = Net::from_fn(g.len(), g.len(), |i, j| {
        let (x, y): (f64, f64) = (g[i], g[j]);
        [x + 0.05 * (5.0 * y).sin(), y, waves[0] * (4.0 * x + waves[1]).sin() + waves[2] * x * y]
    });
    BSplineSurface::new(knots.clone(), knots, net.unwrap()).unwrap()
}

/// The landscape cut into `n × n` patches, each with knots of its own.
fn patches(n: usize, waves: [f64; 3], extra: &[f64]) -> Vec<BSplineSurface<P3>> {
    let mut rest = landscape(2 * n, waves);
    let mut all = Vec::new();
    for i in 1..=n {
        let mut row = rest.clone();
        if i < n {
            let [low, high] = rest.split(Direction::U, i as f64 / n as f64).unwrap();
            (row, rest) = (low, high);
        }
        for j in 1..=n {
            let mut patch = row.clone();
            if j < n {
                let [low, high] = row.split(Direction::V, j as f64 / n as f64).unwrap();
                (patch, row) = (low, high);
            }
            for (k, direction) in [Direction::U, Direction::V].into_iter().enumerate() {
                if let Some(&part) = extra.get((all.len() * 2 + k) % extra.len().max(1)) {
                    let [lo, hi] = patch.domain().ranges()[k];
                    patch = patch.insert_knots(direction, &[lo + (hi - lo) * part]).unwrap();
                }
            }
            all.push(patch);
        }
    }
    all
}

/// A patch that passes through points above it, some near its corners.
fn dented(patch: &BSplineSurface<P3>, heights: [f64; 5]) -> BSplineSurface<P3> {
    let [[a, b], [c, d]] = patch.domain().ranges();
    let at = [(0.5, 0.5), (0.02, 0.03), (0.97, 0.05), (0.04, 0.96), (0.98, 0.97)];
    let constraints: Vec<_> = at
        .iter()
        .zip(heights)
        .map(|(&(x, y), height)| {
            let at = [a + (b - a) * x, c + (d - c) * y];
            let [px, py, pz] = patch.eval(at[0], at[1]);
            PointConstraint::At(at, [px + 0.3 * height, py, pz + height])
        })
        .collect();
    patch.pass_through(&constraints).unwrap().surface
}

/// The figures of all seams, and that nothing else changed.
#[track_caller]
fn check(before: &Network<P3>, found: &Followed<P3>, tolerances: [f64; 2]) {
    for seam in 0..before.seams().len() {
        let measure = found.network.joint_bounds(seam).unwrap();
        assert!(measure.gap <= tolerances[0] && measure.angle <= tolerances[1], "seam {seam}: {measure:?}");
    }
    for (index, (a, b)) in before.patches().iter().zip(found.network.patches()).enumerate() {
        if !found.changed.contains(&index) {
            assert_eq!(a, b);
        }
    }
}

#[test]
fn eight_neighbours_follow_and_sixteen_stay() {
    let network = Network::grid(patches(5, [0.2, 0.3, 0.4], &[0.3, 0.62, 0.45]), 5).unwrap();
    let deformed = dented(&network.patches()[12], [0.05, 0.02, -0.03, 0.01, 0.04]);
    let found = network.follow(12, &deformed, &FollowOptions::default()).unwrap();
    let mut changed = found.changed.clone();
    assert_eq!(changed[0], 12);
    changed.sort_unstable();
    assert_eq!(changed, [6, 7, 8, 11, 12, 13, 16, 17, 18]);
    assert_eq!(found.network.patches()[12], deformed);
    // Constant ratios across all seams: nothing but rounding.
    check(&network, &found, [1e-13, 1e-11]);
    assert_eq!(found.seams.len(), 24); // all seams of nine patches
}

#[test]
fn turned_and_mirrored_patches() {
    let plain = patches(2, [0.2, 0.3, 0.4], &[0.3, 0.62, 0.45]);
    // The right neighbour has its parameters exchanged, the upper one runs backwards.
    let turned = vec![
        plain[0].clone(),
        plain[1].transposed(),
        plain[2].reversed(Direction::V),
        plain[3].reversed(Direction::U).transposed(),
    ];
    let seams = vec![
        Seam { patches: [0, 1], edges: EdgePair::along(Edge::VEnd, Edge::UStart) },
        Seam { patches: [0, 2], edges: EdgePair::against(Edge::UEnd, Edge::UStart) },
        Seam { patches: [1, 3], edges: EdgePair::along(Edge::VEnd, Edge::VEnd) },
        Seam { patches: [2, 3], edges: EdgePair::against(Edge::VStart, Edge::UStart) },
    ];
    let network = Network::new(turned, seams).unwrap();
    for seam in 0..4 {
        let measure = network.joint_bounds(seam).unwrap();
        assert!(measure.gap < 1e-14 && measure.angle < 1e-12, "{seam}: {measure:?}");
    }
    for leader in 0..4 {
        let deformed = dented(&network.patches()[leader], [0.05, 0.02, -0.03, 0.01, 0.04]);
        let found = network.follow(leader, &deformed, &FollowOptions::default()).unwrap();
        assert_eq!(found.changed.len(), 4);
        check(&network, &found, [1e-13, 1e-11]);
    }
}

#[test]
fn ratios_that_vary_along_the_seam_are_kept_to_the_tolerance() {
    let right = landscape(4, [0.2, 0.0, 0.5]);
    let mut left = landscape(3, [0.25, 0.5, 0.2]);
    for point in left.control_points_mut() {
        point[0] -= 1.0 + 0.2 * point[1];
    }
    let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
    let options = SpliceOptions::default().method(Method::LeastSquares).angle(2e-5);
    let left = right.continued_within(joint.swapped(), &options, &left).unwrap().surface;
    let seam = Seam { patches: [0, 1], edges: EdgePair::along(Edge::UEnd, Edge::UStart) };
    let network = Network::new(vec![left, right], vec![seam]).unwrap();
    let deformed = dented(&network.patches()[1], [0.1, 0.02, 0.0, 0.05, 0.0]);
    let found = network.follow(1, &deformed, &FollowOptions::default()).unwrap();
    check(&network, &found, [1e-5, 1e-4]);
    assert!(network.patches()[0].joint_bounds(joint, &deformed).unwrap().gap > 1e-3);
}

/// Four plane patches around a corner, `u` along the first and `v` along the second direction; the edges from the
/// corner go west, south, east and north in these directions.
fn corner([west, south, east, north]: [[f64; 2]; 4]) -> Network<P3> {
    let patch = |a: [f64; 2], b: [f64; 2], [from_a, from_b]: [bool; 2]| {
        let knots = KnotVector::uniform(3, 1).unwrap();
        let away = |i: usize, towards: bool| if towards { 1.0 - i as f64 / 3.0 } else { i as f64 / 3.0 };
        let net = Net::from_fn(4, 4, |i, j| {
            let (x, y) = (away(i, from_a), away(j, from_b));
            [a[0] * x + b[0] * y, a[1] * x + b[1] * y, 0.0]
        });
        BSplineSurface::new(knots.clone(), knots, net.unwrap()).unwrap()
    };
    let patches = vec![
        patch(west, south, [true, true]),
        patch(west, north, [true, false]),
        patch(east, south, [false, true]),
        patch(east, north, [false, false]),
    ];
    Network::grid(patches, 2).unwrap()
}

/// The first patch, lifted by a quadratic function with a twist.
fn lifted(network: &Network<P3>) -> BSplineSurface<P3> {
    let mut deformed = network.patches()[0].clone();
    for point in deformed.control_points_mut() {
        let [x, y, _] = *point;
        point[2] = 0.2 * (x * x + x * y + y * y);
    }
    deformed
}

#[test]
fn twists_agree_where_the_edges_pass_straight_through_the_corner() {
    let network = corner([[-1.0, 0.2], [0.3, -0.8], [0.5, -0.1], [-0.45, 1.2]]);
    let options = FollowOptions::default().spans(1).gap(1e-13).angle(1e-13);
    let found = network.follow(0, &lifted(&network), &options).unwrap();
    check(&network, &found, [1e-13, 1e-13]);
}

#[test]
fn twists_that_differ_are_named_until_there_are_enough_spans() {
    let network = corner([[-1.0, 0.2], [0.1, -1.0], [1.0, 0.0], [0.3, 1.0]]);
    let deformed = lifted(&network);
    let mut mismatches = Vec::new();
    for spans in [2, 4] {
        let options = FollowOptions::default().spans(spans);
        let error = network.follow(0, &deformed, &options).unwrap_err();
        let NetworkError::Twist { patch: 3, seams, mismatch, worst, achieved } = error else {
            panic!("{error}")
        };
        assert!(seams.contains(&worst) && achieved.angle > options.angle && achieved.gap < 1e-14);
        assert!(error.to_string().contains("in the corner of patch 3 between the seams"), "{error}");
        assert!(error.to_string().ends_with("pass straight through the corner"), "{error}");
        mismatches.push(mismatch);
    }
    // A control point for the twist stands for the square of the length of a span.
    assert!((mismatches[0] / mismatches[1] - 4.0).abs() < 0.5, "{mismatches:?}");
    let found = network.follow(0, &deformed, &FollowOptions::default()).unwrap();
    check(&network, &found, [1e-5, 1e-4]);
    let fine = FollowOptions::default().angle(1e-8);
    check(&network, &network.follow(0, &deformed, &fine).unwrap(), [1e-5, 1e-8]);
}

#[test]
fn a_deformation_inside_moves_no_neighbour() {
    let network = Network::grid(patches(3, [0.2, 0.3, 0.4], &[]), 3).unwrap();
    let mut finer = network.patches()[4].refined(Direction::U).refined(Direction::V);
    let (rows, columns) = (finer.net().rows(), finer.net().columns());
    assert!(rows > 5);
    finer.control_points_mut()[rows / 2 * columns + columns / 2][2] += 0.1;
    let found = network.follow(4, &finer, &FollowOptions::default()).unwrap();
    assert_eq!(found.changed, [4]);
    check(&network, &found, [1e-13, 1e-11]);
}

#[test]
fn a_seam_keeps_the_angle_it_had() {
    // The second patch is tilted a little about the seam, within the tolerance; the first one turns about it.
    let flat = landscape(2, [0.0; 3]).map(|[_, y, z]| [0.0, y, z]);
    let greville = flat.knots(Direction::U).greville();
    let columns = flat.net().columns();
    let turned = |from: f64, angle: f64| {
        let mut patch = flat.clone();
        for (index, point) in patch.control_points_mut().iter_mut().enumerate() {
            let x = from + greville[index / columns];
            *point = [x * angle.cos(), point[1], x * angle.sin()];
        }
        patch
    };
    let network = Network::grid(vec![turned(-1.0, 0.0), turned(0.0, 8e-5)], 1).unwrap();
    let angle = network.joint_bounds(0).unwrap().angle;
    assert!((angle - 8e-5).abs() < 1e-9);
    for turn in [0.4, 1.2, -0.7] {
        let found = network.follow(0, &turned(-1.0, turn), &FollowOptions::default()).unwrap();
        let after = found.network.joint_bounds(0).unwrap().angle;
        assert!((after - angle).abs() < 1e-9, "{angle} became {after}");
    }
}

/// Three quadrilaterals of a hexagon around its middle, flat.
fn hexagon() -> Network<P3> {
    let corner = |i: usize| {
        let angle = std::f64::consts::FRAC_PI_3 * i as f64;
        [angle.cos(), angle.sin(), 0.0]
    };
    let quad = |i: usize| {
        let ring = [corner(2 * i), corner(2 * i + 1), corner(2 * i + 2)];
        let net = Net::from_rows([[[0.0; 3], ring[2]], [ring[0], ring[1]]]).unwrap();
        let surface = BSplineSurface::from_bezier(net).unwrap();
        let raised = [Direction::U, Direction::V, Direction::U, Direction::V];
        raised.iter().fold(surface, |surface, &direction| surface.elevate(direction).unwrap())
    };
    let seam =
        |i: usize| Seam { patches: [i, (i + 1) % 3], edges: EdgePair::along(Edge::UStart, Edge::VStart) };
    Network::new((0..3).map(quad).collect(), (0..3).map(seam).collect()).unwrap()
}

#[test]
fn corners_of_three_say_why_not() {
    let network = hexagon();
    for seam in 0..3 {
        assert!(network.joint_bounds(seam).unwrap().gap < 1e-14);
    }
    let mut deformed = network.patches()[0].clone();
    for (point, height) in deformed.control_points_mut().iter_mut().zip([0.1, 0.3, -0.2, 0.1]) {
        point[2] += height;
    }
    let error = network.follow(0, &deformed, &FollowOptions::default()).unwrap_err();
    assert!(matches!(error, NetworkError::Corner { seam: 1, .. }), "{error}");
    assert!(error.to_string().contains("not one of four patches"));
}

/// A pipe whose first parameter runs around it.
fn pipe() -> BSplineSurface<P3> {
    let around = KnotVector::new(3, (-3..13).map(f64::from).collect::<Vec<_>>()).unwrap();
    let net = Net::from_fn(12, 6, |i, j| {
        let angle = std::f64::consts::TAU * (i % 9) as f64 / 9.0;
        [angle.cos(), angle.sin(), j as f64]
    });
    BSplineSurface::new(around, KnotVector::uniform(3, 3).unwrap(), net.unwrap()).unwrap()
}

#[test]
fn a_patch_that_meets_itself() {
    let seam = Seam { patches: [0, 0], edges: EdgePair::along(Edge::UEnd, Edge::UStart) };
    let network = Network::new(vec![pipe()], vec![seam]).unwrap();
    let wider = pipe().map(|[x, y, z]| [x * (1.0 + 0.1 * z), y, z]);
    let found = network.follow(0, &wider, &FollowOptions::default()).unwrap();
    assert_eq!(found.changed, [0]);
    check(&network, &found, [1e-13, 1e-11]);
    let mut torn = wider;
    torn.control_points_mut()[2][0] += 0.1;
    let error = network.follow(0, &torn, &FollowOptions::default()).unwrap_err();
    assert!(matches!(error, NetworkError::Ring { seam: 0, .. }), "{error}");
    assert!(error.to_string().contains("meets itself along seam 0; deform both edges alike"));
}

#[test]
fn what_is_refused() {
    let all = patches(2, [0.2, 0.3, 0.4], &[]);
    let error = Network::grid(all[..3].to_vec(), 2).unwrap_err();
    assert_eq!(error, NetworkError::Grid { patches: 3, columns: 2 });
    assert_eq!(
        Network::<P3>::grid(Vec::new(), 0).unwrap_err(),
        NetworkError::Grid { patches: 0, columns: 0 }
    );
    let seam = Seam { patches: [0, 9], edges: EdgePair::along(Edge::UEnd, Edge::UStart) };
    assert_eq!(Network::new(all.clone(), vec![seam]).unwrap_err(), NetworkError::Patch { patch: 9 });
    let seam = Seam { patches: [0, 1], edges: EdgePair::along(Edge::VEnd, Edge::VStart) };
    let error = Network::new(all.clone(), vec![seam, seam]).unwrap_err();
    assert_eq!(error, NetworkError::EdgeTwice { seam: 1 });

    let mut torn = all.clone();
    for point in torn[1].control_points_mut() {
        point[2] += 0.1;
    }
    let network = Network::grid(torn, 2).unwrap();
    let deformed = dented(&network.patches()[0], [0.1; 5]);
    let error = network.follow(0, &deformed, &FollowOptions::default()).unwrap_err();
    assert!(matches!(error, NetworkError::NotSmooth { .. }), "{error}");
    assert!(error.to_string().contains("join its patches first"));

    let network = Network::grid(all, 2).unwrap();
    let error = network.follow(0, &network.patches()[3], &FollowOptions::default()).unwrap_err();
    assert!(matches!(error, NetworkError::Domain(_)), "{error}");
    let error = network.follow(7, &deformed, &FollowOptions::default()).unwrap_err();
    assert_eq!(error, NetworkError::Patch { patch: 7 });
    assert_eq!(network.joint_bounds(9).unwrap_err(), NetworkError::NoSeam { seam: 9 });
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for options in [FollowOptions::default().gap(bad), FollowOptions::default().angle(bad)] {
            let error = network.follow(0, &deformed, &options).unwrap_err();
            assert!(matches!(error, NetworkError::Tolerance { .. }), "{error}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn random_networks_follow(
        waves in [0.05..0.3, -1.0..1.0, -0.5..0.5],
        extra in prop::collection::vec(0.1..0.9, 1..7),
        leader in 0..9_usize,
        heights in [-0.05..0.05, -0.05..0.05, -0.05..0.05, -0.05..0.05, -0.05..0.05],
    ) {
        let network = Network::grid(patches(3, waves, &extra), 3).unwrap();
        let deformed = dented(&network.patches()[leader], heights);
        let found = network.follow(leader, &deformed, &FollowOptions::default()).unwrap();
        check(&network, &found, [1e-5, 1e-4]);
        for (index, patch) in found.network.patches().iter().enumerate() {
            let near = |a: usize, b: usize| a.abs_diff(b) <= 1;
            prop_assert!(!found.changed.contains(&index) || near(index / 3, leader / 3) && near(index % 3, leader % 3));
            // Nothing moves far from the patch.
            let old = &network.patches()[index];
            let [[a, b], [c, d]] = old.domain().ranges();
            let middle = |surface: &BSplineSurface<P3>| surface.eval(f64::midpoint(a, b), f64::midpoint(c, d));
            let (p, q) = (middle(patch), middle(old));
            prop_assert!(distance(p, q) < 0.5);
        }
    }
}
