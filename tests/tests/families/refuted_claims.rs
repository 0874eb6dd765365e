//! Every published claim that is refuted fails on floats, too, and its correction holds; the claims are stated and
//! decided in `specs/papers`.

use basis_runtime::{Curve, Edge, EdgePair, Surface, SurfaceOfRevolution, TensorSurface, basis};
use basis_tests::random::Random;

basis!("../../../specs/quadratic.basis", QuadraticBezier);
basis!("../../../specs/quartic.basis");
basis!("../../../specs/quartic_surface.basis");
basis!(
    "../../../specs/triangular.basis",
    TriangularI(3) as TypeI3,
    TriangularII(3) as TypeII3,
    TriangularII(4) as TypeII4,
    TriangularII(5) as TypeII5,
    TriangularBernstein(4) as Bernstein4
);

type Plane = [f64; 2];
type Net = [[[f64; 3]; 4]; 4];

fn quadratic(lambda: f64, points: [Plane; 3]) -> Curve<QuadraticBezier, Plane> {
    Curve::new(QuadraticBezier::new(lambda).unwrap(), points)
}

fn cross(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Plane, b: Plane) -> Plane {
    [a[0] - b[0], a[1] - b[1]]
}

fn length(a: Plane) -> f64 {
    a[0].hypot(a[1])
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs()).max(1.0)
}

/// A convex polygon with legs of different lengths.
const POINTS: [Plane; 3] = [[0.0, 0.0], [1.0, 2.0], [4.0, 1.0]];

/// quad-L2
#[test]
fn quad_l2() {
    for lambda in [-1.5, -1.0, 0.3, 1.0] {
        let [_, v, a] = quadratic(lambda, POINTS).eval_with_derivs::<3>(1.0);
        let legs = cross(minus(POINTS[1], POINTS[0]), minus(POINTS[2], POINTS[1]));
        assert!(!close(cross(v, a), 2.0 * (lambda + 2.0) * (lambda + 1.0) * legs), "{lambda}");
        assert!(close(cross(v, a), 2.0 * (lambda + 2.0) * (1.0 - lambda) * legs), "{lambda}");
    }
}

/// quad-P1
#[test]
fn quad_p1() {
    let chord = quadratic(-2.0, POINTS);
    let step = minus(chord.eval(1e-3), POINTS[0]);
    assert!(cross(step, minus(POINTS[1], POINTS[0])).abs() > 0.1 * length(step));
    assert!(cross(step, minus(POINTS[2], POINTS[0])).abs() < 1e-12);
}

/// quad-P2
#[test]
fn quad_p2() {
    let [a, b, c] = POINTS;
    let (curve, reversed) = (quadratic(0.5, POINTS), quadratic(0.5, [c, b, a]));
    assert!(length(minus(curve.eval(0.25), reversed.eval(0.25))) > 1.0);
    assert!(length(minus(curve.eval(0.25), reversed.eval(0.75))) < 1e-15);
}

/// quad-T1
#[test]
fn quad_t1_at_the_end_of_the_range() {
    // The condition asks for Q₁ = Q₀; the curves meet at an angle.
    let (p, q) = (quadratic(-2.0, POINTS), quadratic(0.5, [POINTS[2], POINTS[2], [4.0, 5.0]]));
    let (before, after) = (minus(POINTS[2], p.eval(1.0 - 1e-4)), minus(q.eval(1e-4), POINTS[2]));
    assert!(cross(before, after) > 0.5 * length(before) * length(after));
}

/// quad-eq7, quad-eq8
#[test]
fn quad_eq7_and_eq8() {
    for lambda in [-1.5, 0.3, 0.9] {
        let curve = quadratic(lambda, POINTS);
        let legs = [minus(POINTS[1], POINTS[0]), minus(POINTS[2], POINTS[1])];
        let area = cross(legs[0], legs[1]).abs();
        let [_, v, a] = curve.eval_with_derivs::<3>(1.0);
        let (end, d1) = (cross(v, a).abs() / length(v).powi(3), area / length(legs[1]));
        let published = 2.0 * d1 * (lambda + 1.0) / (lambda + 2.0).powi(2) / length(legs[1]).powi(2);
        let corrected = 2.0 * d1 * (1.0 - lambda) / (lambda + 2.0).powi(2) / length(legs[1]).powi(2);
        assert!(!close(end, published) && close(end, corrected), "{end} {published} {corrected}");
        let [_, v, a] = curve.eval_with_derivs::<3>(0.0);
        let (start, d2) = (cross(v, a).abs() / length(v).powi(3), area / length(legs[0]));
        let published = 2.0 * d2 * (lambda - 1.0) / (lambda + 2.0).powi(2) / length(legs[0]).powi(2);
        assert!(published < 0.0 && close(start, -published), "{start} {published}");
    }
}

/// quad-T2
#[test]
fn quad_t2() {
    let (l1, l2, a, b, d2) = (0.25, -0.5, 1.5, 0.75, 0.5);
    let ratio = (l1 + 2.0_f64).powi(2) / (l2 + 2.0_f64).powi(2) * (a * a) / (b * b);
    let published = (l2 - 1.0) / (l1 + 1.0) * ratio;
    let corrected = (1.0 - l2) / (1.0 - l1) * ratio;
    let curvature = |mu: f64| {
        let first = quadratic(l1, [[-2.0, mu * d2], [-a, 0.0], [0.0, 0.0]]);
        let next = quadratic(l2, [[0.0, 0.0], [b, 0.0], [2.0, d2]]);
        let joint = first.joint(&next);
        assert!(joint.angle < 1e-15);
        joint.curvature
    };
    assert!(curvature(published) > 0.1);
    assert!(curvature(corrected) < 1e-14);
}

/// quad-T3: at the end of the range a curve joins C2, although the quotient of its legs does not exist.
#[test]
fn quad_t3() {
    let curve = quadratic(-2.0, POINTS);
    for inner in [[3.0, -2.0], [7.0, 5.0]] {
        let next = quadratic(-2.0, [POINTS[2], inner, POINTS[0]]);
        assert_eq!(curve.joint(&next).parametric_order(1e-15, [1e-13, 1e-13, 0.0]), Some(2));
        assert!(cross(minus(inner, POINTS[2]), minus(POINTS[2], POINTS[1])).abs() > 1.0);
    }
    // The corrected condition with the right leg, and with another one.
    let next = |legs: f64| {
        let [l1, l2] = [0.25, -0.5];
        let end = quadratic(l1, POINTS);
        let leg = minus(POINTS[2], POINTS[1]).map(|x| legs * x * (l1 + 2.0) / (l2 + 2.0));
        let inner = [POINTS[2][0] + leg[0], POINTS[2][1] + leg[1]];
        // (λ₁-1)α₁₁ + (2λ₁+1)α₁₂ + (2λ₂+1)α₂₁ + (λ₂-1)α₂₂ = 0, solved for Q₂.
        let (a, b) = (minus(POINTS[1], POINTS[0]), minus(POINTS[2], POINTS[1]));
        let last: Plane = core::array::from_fn(|d| {
            let rest = (l1 - 1.0) * a[d] + (2.0 * l1 + 1.0) * b[d] + (2.0 * l2 + 1.0) * leg[d];
            inner[d] - rest / (l2 - 1.0)
        });
        end.joint(&quadratic(l2, [POINTS[2], inner, last])).parametric_order(1e-15, [1e-12, 1e-12, 0.0])
    };
    assert_eq!([next(1.0), next(1.5)], [Some(2), Some(0)]);
}

/// quad-ex1, quad-ex2
#[test]
#[allow(clippy::approx_constant)] // a published coordinate
fn quad_examples() {
    let hat = [
        quadratic(0.62, [[0.0, 0.04], [1.98, -0.23], [3.14, 0.51]]),
        quadratic(0.73, [[3.14, 0.51], [0.45, 1.29], [0.52, 1.33]]),
        quadratic(0.81, [[0.52, 1.33], [5.98, 1.26], [6.02, 1.68]]),
        quadratic(0.60, [[6.02, 1.68], [6.51, 1.32], [7.85, 1.29]]),
    ];
    for pair in hat.windows(2) {
        let joint = pair[0].joint(&pair[1]);
        assert!(joint.gap < 1e-15 && joint.angle > 0.5, "{joint:?}");
    }
    let first = quadratic(0.57, [[2.58, 6.27], [0.11, 4.45], [2.05, 2.81]]);
    let next = quadratic(0.52, [[2.05, 2.81], [3.75, 2.13], [2.01, 0.02]]);
    let joint = first.joint(&next);
    assert!(joint.gap < 1e-15 && joint.angle > 0.3, "{joint:?}");
}

/// quart-LI
#[test]
fn quart_li() {
    let basis = QuarticBernstein::new(-3.0).unwrap();
    for t in [0.1, 0.4, 0.8] {
        let [_, b1, b2, _]: [f64; 4] = basis.values(t);
        assert!((b1 - b2).abs() < 1e-15, "{b1} {b2}");
    }
}

fn surface(
    lambda: f64,
    gamma: [f64; 4],
    net: &Net,
) -> TensorSurface<QuarticBernstein, QuarticBernstein, [f64; 3]> {
    TensorSurface::with_rows(
        QuarticBernstein::new(lambda).unwrap(),
        gamma.map(|g| QuarticBernstein::new(g).unwrap()),
        *net,
    )
}

fn net(random: &mut Random) -> Net {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| [2.0 * i as f64, 2.0 * j as f64, random.between(-1.0, 1.0)])
    })
}

/// quart-P5
#[test]
fn quart_p5() {
    // A Bézier curve of degree 4 would start with 4(P₁ - P₀).
    let curve = Curve::new(QuarticBernstein::new(0.0).unwrap(), [0.0, 1.0, 3.0, 2.0]);
    let [_, velocity] = curve.eval_with_derivs(0.0);
    assert!(close(velocity, 3.0) && !close(velocity, 4.0));
}

/// quart-eq8
#[test]
fn quart_eq8() {
    // P₀ + P₃ = P₁ + P₂: other parameters and other inner points give the same curve.
    let (l1, l2) = (-1.0_f64, 0.5);
    let k = (3.0 + l1) / (3.0 + l2);
    let [a, b, c] = [[0.0, 0.0], [1.0, 2.0], [4.0, 1.0]];
    let d = [b[0] + c[0] - a[0], b[1] + c[1] - a[1]];
    let towards = |p: Plane, q: Plane| [p[0] + k * (q[0] - p[0]), p[1] + k * (q[1] - p[1])];
    let first = Curve::new(QuarticBernstein::new(l1).unwrap(), [a, b, c, d]);
    let second = Curve::new(QuarticBernstein::new(l2).unwrap(), [a, towards(a, b), towards(d, c), d]);
    for t in [0.1, 0.35, 0.7] {
        assert!(length(minus(first.eval(t), second.eval(t))) < 1e-14);
    }
    assert!(length(minus(b, towards(a, b))) > 0.5);
}

/// quart-T6
#[test]
fn quart_t6() {
    let mut random = Random::new(6);
    let (s, mut t) = (net(&mut random), net(&mut random));
    let (l1, l2, eta, f) = (0.5, -1.0, -0.5, 0.8);
    let first = surface(l1, [0.0, eta, eta, eta], &s);
    let rows =
        quartic_surface::g2_vv(&s, quartic_surface::G2VvScalars { lambda1: l1, lambda2: l2, f }).unwrap();
    t[..3].copy_from_slice(&rows);
    let joined = |t: &Net| order(&first, Edge::UEnd, &surface(l2, [eta, eta, eta, 0.0], t), Edge::UStart);
    assert_eq!(joined(&t), Some(2));
    // As printed, with the points of the last columns.
    for j in 0..4 {
        for d in 0..3 {
            let published = (1.0 + l1) * (s[j][3][d] - s[j][2][d]) - (s[j][2][d] - s[j][1][d]);
            t[2][j][d] = t[1][j][d] - (1.0 + l2) * (t[0][j][d] - t[1][j][d]) + published / (f * f);
        }
    }
    assert_eq!(joined(&t), Some(1));
}

/// What edges of two surfaces have to do with each other.
fn order(
    first: &TensorSurface<QuarticBernstein, QuarticBernstein, [f64; 3]>,
    edge: Edge,
    next: &TensorSurface<QuarticBernstein, QuarticBernstein, [f64; 3]>,
    other: Edge,
) -> Option<usize> {
    first.joint(EdgePair::along(edge, other), next, 33).geometric_order(1e-13, 1e-11, 1e-9)
}

/// The parameter γ' with 3 + γ' = k (3 + γ).
fn times(k: f64, gamma: f64) -> f64 {
    k * (3.0 + gamma) - 3.0
}

/// quart-adj
#[test]
fn quart_adj_uu() {
    let mut random = Random::new(7);
    let (s, mut t) = (net(&mut random), net(&mut random));
    let (g1, g2) = ([0.5, -1.0, 0.25, -2.0], [0.0, 0.5, -0.5, 1.0]);
    for (row, new) in t.iter_mut().zip(
        quartic_surface::g2_uu(&s, quartic_surface::G2UuScalars { gamma1: g1, gamma2: g2, f: 1.25 }).unwrap(),
    ) {
        row[..3].copy_from_slice(&new);
    }
    let joined = |[l1, l2]: [f64; 2], g1, g2| {
        order(&surface(l1, g1, &s), Edge::VEnd, &surface(l2, g2, &t), Edge::VStart)
    };
    let factor = |k: f64, list: [f64; 4]| list.map(|g| times(k, g));
    assert_eq!(joined([0.5; 2], g1, g2), Some(2));
    // The common λ is free, and so is a common factor of all 3 + γ.
    assert_eq!(joined([-1.5; 2], g1, g2), Some(2));
    assert_eq!(joined([0.5; 2], factor(0.5, g1), factor(0.5, g2)), Some(2));
    // A factor on one side, or different ones, keep G1.
    assert_eq!(joined([0.5; 2], factor(0.5, g1), g2), Some(1));
    assert_eq!(joined([0.5; 2], g1, factor(0.75, g2)), Some(1));
    assert_eq!(joined([0.5; 2], factor(1.1, g1), factor(0.75, g2)), Some(1));
    // The parameter of one row, and λ of one surface.
    assert_eq!(joined([0.5; 2], [0.5, -1.0, 0.25, 0.0], g2), Some(0));
    assert_eq!(joined([0.5; 2], g1, [0.0, 0.5, 0.5, 1.0]), Some(0));
    assert_eq!(joined([0.5, 0.25], g1, g2), None);
}

/// quart-adj
#[test]
fn quart_adj_uv() {
    let mut random = Random::new(8);
    let (s, mut t) = (net(&mut random), net(&mut random));
    let (g1, l2, eta) = ([0.5, -1.0, 0.25, -2.0], -0.5, 0.75);
    t[..3].copy_from_slice(
        &quartic_surface::g2_uv(&s, quartic_surface::G2UvScalars { gamma1: g1, lambda2: l2, f: 1.25 })
            .unwrap(),
    );
    let joined = |l1, g1, l2, g2| order(&surface(l1, g1, &s), Edge::VEnd, &surface(l2, g2, &t), Edge::UStart);
    let g2 = |eta| [eta, eta, eta, -1.0];
    let factor = |k: f64| g1.map(|g| times(k, g));
    assert_eq!(joined(eta, g1, l2, g2(eta)), Some(2));
    // The common parameter, γ²₃, and a common factor are free.
    assert_eq!(joined(-2.0, g1, l2, g2(-2.0)), Some(2));
    assert_eq!(joined(eta, g1, l2, [eta, eta, eta, 0.5]), Some(2));
    assert_eq!(joined(eta, factor(0.5), times(0.5, l2), g2(eta)), Some(2));
    // γ²₂ and factors on one side keep G1.
    assert_eq!(joined(eta, g1, l2, [eta, eta, -0.5, -1.0]), Some(1));
    assert_eq!(joined(eta, factor(0.5), l2, g2(eta)), Some(1));
    assert_eq!(joined(eta, g1, -2.0, g2(eta)), Some(1));
    // The others do not.
    assert_eq!(joined(eta, [0.5, -1.0, 0.25, 0.0], l2, g2(eta)), Some(0));
    assert_eq!(joined(eta, g1, l2, [eta, -0.5, eta, -1.0]), Some(0));
    assert_eq!(joined(0.25, g1, l2, g2(eta)), None);
}

/// quart-adj
#[test]
fn quart_adj_vv() {
    let mut random = Random::new(9);
    let (s, mut t) = (net(&mut random), net(&mut random));
    let (l1, l2, eta) = (0.5, -1.0, -0.5);
    t[..3].copy_from_slice(
        &quartic_surface::g2_vv(&s, quartic_surface::G2VvScalars { lambda1: l1, lambda2: l2, f: 0.8 })
            .unwrap(),
    );
    let joined = |l1, g1, l2, g2| order(&surface(l1, g1, &s), Edge::UEnd, &surface(l2, g2, &t), Edge::UStart);
    let (g1, g2) = (|eta| [1.0, eta, eta, eta], |eta| [eta, eta, eta, -2.0]);
    assert_eq!(joined(l1, g1(eta), l2, g2(eta)), Some(2));
    // The common parameter, γ¹₀ and γ²₃, and a common factor are free.
    assert_eq!(joined(l1, g1(1.0), l2, g2(1.0)), Some(2));
    assert_eq!(joined(l1, [-1.0, eta, eta, eta], l2, [eta, eta, eta, 0.5]), Some(2));
    assert_eq!(joined(times(0.5, l1), g1(eta), times(0.5, l2), g2(eta)), Some(2));
    // γ¹₁, γ²₂, λ₁ and λ₂ alone keep G1.
    assert_eq!(joined(l1, [1.0, -2.0, eta, eta], l2, g2(eta)), Some(1));
    assert_eq!(joined(l1, g1(eta), l2, [eta, eta, 0.5, -2.0]), Some(1));
    assert_eq!(joined(-2.0, g1(eta), l2, g2(eta)), Some(1));
    assert_eq!(joined(l1, g1(eta), 0.25, g2(eta)), Some(1));
    // The others do not.
    assert_eq!(joined(l1, [1.0, eta, 0.5, eta], l2, g2(eta)), Some(0));
    assert_eq!(joined(l1, g1(eta), l2, [eta, 0.5, eta, -2.0]), Some(0));
    assert_eq!(joined(l1, g1(0.25), l2, g2(eta)), None);
}

/// A random point of the triangle.
fn barycentric(random: &mut Random) -> [f64; 3] {
    let (u, v): (f64, f64) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
    let v = v * (1.0 - u);
    [u, v, 1.0 - u - v]
}

/// The place of b[i,j,k] of order n: the indices are in lexicographic order.
fn place(n: usize, index: [usize; 3]) -> usize {
    let before: usize = (0..index[0]).map(|i| n - i + 1).sum();
    before + index[1]
}

/// tri-P1.4, tri-P2.4
#[test]
fn tri_p1_4_and_p2_4() {
    let mut random = Random::new(8);
    let three = TypeII3::new(1.5, 0.0).unwrap();
    let five = TypeII5::new(0.5, 1.25).unwrap();
    // The combination that `basis explain` shows, at λ₂ = 5/4.
    let l2 = 1.25;
    let combination = [
        ([0, 2, 3], 12.0 + 9.0 * l2),
        ([0, 3, 2], -12.0 - 9.0 * l2),
        ([1, 1, 3], 6.0 - 3.0 * l2),
        ([1, 3, 1], -6.0 + 3.0 * l2),
        ([2, 1, 2], -2.0 + l2),
        ([2, 2, 1], 2.0 - l2),
    ];
    for _ in 0..50 {
        let at = barycentric(&mut random);
        // So that the middle control point does not move the surface.
        assert!(three.values(at)[place(3, [1, 1, 1])].abs() < 1e-16);
        let values = five.values(at);
        let sum: f64 = combination.iter().map(|(index, c)| c * values[place(5, *index)]).sum();
        assert!(sum.abs() < 1e-13, "{sum}");
    }
}

/// tri-P3
#[test]
fn tri_p3() {
    let (i, at) = (place(3, [2, 1, 0]), [0.2, 0.7, 0.1]);
    let one = |l1: f64, l2: f64, at| TypeI3::new(l1, l2).unwrap().values(at)[i];
    assert!(one(2.0, 1.5, at) < one(2.0, 1.0, at));
    let other = [0.2, 0.1, 0.7];
    assert!(one(2.5, 1.0, other) < one(2.0, 1.0, other));
    let i = place(4, [3, 1, 0]);
    let two = |l1: f64, l2: f64| TypeII4::new(l1, l2).unwrap().values(at)[i];
    assert!(two(2.5, 1.0) < two(2.0, 1.0) && two(2.0, 1.5) < two(2.0, 1.0));
}

/// tri-C1
#[test]
fn tri_c1() {
    let (i, at) = (place(4, [3, 1, 0]), [0.2, 0.7, 0.1]);
    let [quasi, plain] = [TypeII4::new(1.0, 1.0).unwrap().values(at)[i], Bernstein4::new().values(at)[i]];
    assert!(quasi > plain, "{quasi} {plain}");
}

/// tri-6.1: the degree along a line, by differences of one order more; type I has the degree 5 for n = 3, but 3 where
/// it is the Bernstein basis.
#[test]
fn tri_6_1() {
    let difference = |l1: f64, l2: f64, order: usize| {
        let family = TypeI3::new(l1, l2).unwrap();
        let at = |k: usize| {
            let u = k as f64 / order as f64;
            family.values([u, 0.75 * (1.0 - u), 0.25 * (1.0 - u)])[place(3, [3, 0, 0])]
        };
        let mut values: Vec<f64> = (0..=order).map(at).collect();
        for _ in 0..order {
            values = values.windows(2).map(|w| w[1] - w[0]).collect();
        }
        values[0]
    };
    assert!(difference(1.0, 3.0, 5).abs() > 1e-3 && difference(1.0, 3.0, 6).abs() < 1e-14);
    assert!(difference(2.0, 4.0, 3).abs() > 1e-3 && difference(2.0, 4.0, 4).abs() < 1e-14);
}

/// rev-T1
#[test]
fn rev_t1_at_the_end_of_the_range() {
    let p = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 1.0]];
    let first = Curve::new(QuarticBernstein::new(-3.0).unwrap(), p);
    let next = Curve::new(QuarticBernstein::new(0.5).unwrap(), [p[3], p[3], [4.0, 4.0], [5.0, 5.0]]);
    let (before, after) = (minus(p[3], first.eval(1.0 - 1e-4)), minus(next.eval(1e-4), p[3]));
    assert!(cross(before, after) > 0.5 * length(before) * length(after));
}

/// rev-def2
#[test]
fn rev_def2_on_the_axis() {
    type Space = [f64; 3];
    let dot = |a: Space, b: Space| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let inverse = |a: Space| a.map(|x| x / dot(a, a));
    let minus = |a: Space, b: Space| core::array::from_fn(|k| a[k] - b[k]);
    let plus = |a: Space, k: f64, b: Space| -> Space { core::array::from_fn(|i| a[i] + k * b[i]) };
    let fraction = |y: f64, t: f64| -> Space {
        let [v0, v1, v2] = [[2.0, y, 0.0], [2.0, 0.0, y], [2.0, -y, 0.0]];
        let (b1, c2) = (inverse(minus(v1, v0)).map(|x| 0.5 * x), inverse(minus(v2, v0)));
        let b2 = inverse(minus(c2, b1)).map(|x| 0.5 * x);
        plus(v0, t, inverse(plus(b1, t - 0.5, inverse(b2))))
    };
    for y in [1.5, -0.5] {
        for (t, wanted) in [(0.0, [2.0, y, 0.0]), (0.5, [2.0, 0.0, y]), (1.0, [2.0, -y, 0.0])] {
            let found = fraction(y, t);
            assert!((0..3).all(|k| close(found[k], wanted[k])), "{found:?}");
        }
    }
    assert!(fraction(0.0, 0.5).iter().all(|x| x.is_nan()));
}

/// rev-P3
#[test]
fn rev_p3_on_the_axis() {
    let normals = |points: [Plane; 4], u: f64| {
        let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
        let surface = SurfaceOfRevolution::about_x(&curve, std::f64::consts::PI).unwrap();
        [0.0, std::f64::consts::FRAC_PI_2].map(|v| surface.normal(u, v).unwrap())
    };
    let dot = |[a, b]: [[f64; 3]; 2]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    // Away from the axis the normals of both surfaces agree.
    let first = [[0.0, 1.0], [1.0, 2.0], [2.0, 2.0], [3.0, 1.0]];
    let next = [[3.0, 1.0], [4.0, 0.0], [5.0, 1.0], [6.0, 3.0]];
    for (a, b) in normals(first, 1.0).into_iter().zip(normals(next, 0.0)) {
        assert!(close(dot([a, b]), 1.0), "{a:?} {b:?}");
    }
    // Next to a point of the axis there are many, but for a perpendicular generatrix.
    let near = 1.0 - 1e-6;
    assert!(dot(normals([[0.0, 3.0], [1.0, 2.0], [2.0, 1.0], [3.0, 0.0]], near)) < 0.6);
    assert!(dot(normals([[0.0, 3.0], [1.0, 2.0], [2.0, 0.0], [3.0, 0.0]], near)) < 0.1);
    assert!(dot(normals([[0.0, 3.0], [2.0, 2.0], [3.0, 1.0], [3.0, 0.0]], near)) > 0.999);
}

/// rev-angle
#[test]
fn rev_angle() {
    let angle = |t: f64| {
        let w = 2.0 * t * t - 2.0 * t + 1.0;
        ((2.0 * t - 2.0 * t * t) / w).atan2((1.0 - 2.0 * t) / w)
    };
    for theta in [0.3, 1.0, 2.0, 3.0_f64] {
        let published = angle(theta / std::f64::consts::PI);
        assert!((published - theta).abs() > 1e-2, "{theta} {published}");
        let k = (theta / 2.0).tan();
        assert!(close(angle(k / (1.0 + k)), theta));
        // Beyond π: the mirrored half, from its end back to 1/(1 + m).
        let m = (theta / 2.0).tan();
        let full = std::f64::consts::PI + theta;
        assert!(close(2.0 * std::f64::consts::PI - angle(1.0 / (1.0 + m)), full));
    }
}

#[test]
fn every_refuted_claim_has_a_test() {
    let table = include_str!("../../../specs/papers/README.md");
    let refuted: Vec<&str> = table
        .lines()
        .filter_map(|line| {
            let mut cells = line.split(" | ");
            let id = cells.next()?.strip_prefix("| ")?;
            line.contains(" | refuted | ").then_some(id)
        })
        .collect();
    assert!(refuted.len() > 20, "{refuted:?}");
    // The lines of a comment that stands over a test, nothing between them.
    let source: Vec<&str> = include_str!("refuted_claims.rs").lines().collect();
    let over_a_test = |k: usize| {
        let rest = source[k..].iter().find(|line| !line.starts_with("///"));
        rest.is_some_and(|line| *line == "#[test]")
    };
    let comments: Vec<&str> = (0..source.len())
        .filter(|k| over_a_test(*k))
        .filter_map(|k| source[k].strip_prefix("/// "))
        .collect();
    for id in refuted {
        let named = |line: &str| {
            let ids = line.split(": ").next().unwrap_or(line);
            ids.split(", ").any(|other| other == id)
        };
        assert!(comments.iter().any(|line| named(line)), "{id}");
    }
}
