//! What is said of a joint holds for all of its parameters: bounds that no dense sampling exceeds, and that are
//! attained but for one percent.

use basis_runtime::Surface;
use basis_runtime::bspline::{
    BSplineSurface, Direction, Edge, EdgePair, KnotVector, Method, Net, Orientation, SpliceOptions,
};
use proptest::prelude::*;

use crate::support::{P3, at_edge, cross, distance, dot, edge, orientation, surface};

/// The parameters of an edge as a part of its domain, from 0 to 1: those at which its polynomial may change.
fn breakpoints(surface: &BSplineSurface<P3>, edge: Edge) -> Vec<f64> {
    let along = if edge.across() == Direction::U { Direction::V } else { Direction::U };
    let all = surface.knots(along).breakpoints();
    let (lo, hi) = (all[0], all[all.len() - 1]);
    all.iter().map(|t| (t - lo) / (hi - lo)).collect()
}

/// The largest gap and angle from nothing but points and partial derivatives, at `count` parameters inside of each
/// piece on which both surfaces are polynomial; and the least sine of the directions along and across an edge.
fn sampled(a: &BSplineSurface<P3>, b: &BSplineSurface<P3>, joint: EdgePair, count: usize) -> [f64; 3] {
    let turned = |part: f64| if joint.orientation == Orientation::Opposite { 1.0 - part } else { part };
    let mut all = breakpoints(a, joint.first);
    all.extend(breakpoints(b, joint.second).into_iter().map(turned));
    all.sort_by(f64::total_cmp);
    let (mut gap, mut angle, mut sine) = (0.0_f64, 0.0_f64, 1.0_f64);
    for piece in all.windows(2).filter(|piece| piece[1] - piece[0] > 1e-9) {
        for i in 0..count {
            // Closer together towards the ends, where the largest values are as often as not.
            let x = 0.5 - 0.5 * (std::f64::consts::PI * (i as f64 + 0.5) / count as f64).cos();
            let part = piece[0] + (piece[1] - piece[0]) * x;
            let (p, out, tangent) = at_edge(a, joint.first, part, 1.0);
            let (q, into, other) = at_edge(b, joint.second, turned(part), -1.0);
            let other = other.map(|x| if joint.orientation == Orientation::Opposite { -x } else { x });
            gap = gap.max(distance(p, q));
            let (n, m) = (cross(out, tangent), cross(into, other));
            angle = angle.max(distance(cross(n, m), [0.0; 3]).atan2(dot(n, m)));
            for [x, y] in [[out, tangent], [into, other]] {
                let sizes = distance(x, [0.0; 3]) * distance(y, [0.0; 3]);
                sine = sine.min(distance(cross(x, y), [0.0; 3]) / sizes);
            }
        }
    }
    [gap, angle, sine]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Of surfaces that have nothing to do with each other: all angles up to π.
    #[test]
    fn figures_of_any_surfaces_are_bounds(
        a in surface(), b in surface(), edge in edge(), target in edge(), orientation in orientation(),
    ) {
        let joint = EdgePair { first: edge, second: target, orientation };
        if let Ok(found) = a.joint_bounds(joint, &b) {
            let [gap, angle, sine] = sampled(&a, &b, joint, 200);
            prop_assert!(gap <= found.gap && angle <= found.angle + 1e-12 / sine, "{:?} {} {}", found, gap, angle);
            prop_assert!(found.gap <= 1.01 * gap, "{:?} {}", found, gap);
            // Where directions become nearly parallel an angle has steep maxima, which samples miss.
            if found.angle > 1.01 * angle && sine > 0.1 {
                let [_, angle, _] = sampled(&a, &b, joint, 4000);
                prop_assert!(found.angle <= 1.01 * angle, "{:?} {} {}", found, angle, sine);
            }
        }
    }

    /// Of surfaces that were joined by least squares, where the angle oscillates inside of each span and is small.
    #[test]
    fn figures_of_splices_are_bounds(
        degrees in [2..=5_usize, 1..=5_usize],
        spans in [1..7_usize, 1..7_usize],
        waves in [-1.0..1.0, -1.0..1.0, 1.0..4.0, -1.0..1.0],
        others in [-1.0..1.0, -1.0..1.0, 1.0..4.0, -1.0..1.0],
        tolerance in -7.0..-1.0,
    ) {
        let sheet = |degree: usize, spans: usize, from: f64, waves: [f64; 4]| {
            let (across, along) = (KnotVector::uniform(degree, 3).unwrap(), KnotVector::uniform(degree, spans).unwrap());
            let (gu, gv) = (across.greville(), along.greville());
            let net = Net::from_fn(gu.len(), gv.len(), |i, j| {
                let (x, y): (f64, f64) = (from + gu[i], gv[j]);
                [x + 0.1 * waves[0] * y * y, y + 0.1 * waves[1] * x, 0.3 * (waves[2] * y + waves[3] * x).sin()]
            });
            BSplineSurface::new(across, along, net.unwrap()).unwrap()
        };
        let (a, b) = (sheet(degrees[0], spans[0], -1.0, waves), sheet(degrees[1], spans[1], 0.0, others));
        let joint = EdgePair::along(Edge::UEnd, Edge::UStart);
        let tolerance = 10.0_f64.powf(tolerance);
        let options = SpliceOptions::default().method(Method::LeastSquares).angle(tolerance).gap(1.0);
        if let Ok(found) = b.continued_within(joint.swapped(), &options, &a) {
            let [gap, angle, _] = sampled(&found.surface, &b, joint, 100);
            let measure = found.joint;
            prop_assert!(gap <= measure.gap && angle <= measure.angle && measure.angle <= tolerance, "{:?} {} {}", measure, gap, angle);
            prop_assert!(measure.gap <= 1.01 * gap + 1e-13, "{:?} {}", measure, gap);
            prop_assert!(measure.angle <= 1.01 * angle + 1e-12, "{:?} {}", measure, angle);
        }
    }
}

/// Surfaces in one plane whose edges cross have equal normals, but do not continue each other.
#[test]
fn the_angle_of_normals_is_not_that_of_conormals() {
    let knots = KnotVector::uniform(1, 1).unwrap();
    let sheet = |from: f64, slope: f64| {
        let net = Net::from_fn(2, 2, |i, j| [from + i as f64 + slope * j as f64, j as f64, 0.0]).unwrap();
        BSplineSurface::new(knots.clone(), knots.clone(), net).unwrap()
    };
    let (a, b) = (sheet(0.0, 0.0), sheet(1.0, 0.5));
    let pair = EdgePair::along(Edge::UEnd, Edge::UStart);
    let (joint, bounds) = (a.joint(pair, &b, 9), a.joint_bounds(pair, &b).unwrap());
    assert!((joint.angle - 0.5_f64.atan()).abs() < 1e-15 && bounds.angle < 1e-12, "{joint:?} {bounds:?}");
    assert!((joint.gap - 0.5).abs() < 1e-15 && (bounds.gap - 0.5).abs() < 1e-12, "{joint:?} {bounds:?}");
}
