//! Random knot vectors, curves and surfaces; distances.

use basis_runtime::bspline::{BSplineCurve, BSplineSurface, Direction, Edge, KnotVector, Net, Orientation};
use proptest::prelude::*;

pub(crate) type P3 = [f64; 3];

/// A knot vector over `[0, 1]` with random inner knots of multiplicity up to `degree + 1`, clamped or not.
pub(crate) fn knots(degree: usize) -> impl Strategy<Value = KnotVector<f64>> {
    let inner = prop::collection::vec((0.02..1.0, 1..=degree + 1), 0..5);
    let outer = prop::collection::vec(0.01..0.5, 2 * degree);
    (inner, prop::option::of(outer)).prop_map(move |(inner, outer)| {
        let mut all = vec![0.0];
        let mut t = 0.0;
        let total: f64 = inner.iter().map(|(step, _)| step).sum::<f64>() + 0.3;
        for (step, times) in inner {
            t += step / total;
            all.extend(std::iter::repeat_n(t, times));
        }
        all.push(1.0);
        let (mut lo, mut hi) = (0.0, 1.0);
        for i in 0..degree {
            if let Some(outer) = &outer {
                lo -= outer[i];
                hi += outer[degree + i];
            }
            all.insert(0, lo);
            all.push(hi);
        }
        KnotVector::new(degree, all).expect("a valid vector")
    })
}

pub(crate) fn point() -> impl Strategy<Value = P3> {
    [-10.0..10.0, -10.0..10.0, -10.0..10.0]
}

pub(crate) fn curve_of(degree: usize) -> impl Strategy<Value = BSplineCurve<P3>> {
    knots(degree).prop_flat_map(|knots| {
        let count = knots.functions();
        prop::collection::vec(point(), count)
            .prop_map(move |points| BSplineCurve::new(knots.clone(), points).expect("as many points"))
    })
}

pub(crate) fn curve() -> impl Strategy<Value = BSplineCurve<P3>> {
    (0..=5_usize).prop_flat_map(curve_of)
}

pub(crate) fn surface() -> impl Strategy<Value = BSplineSurface<P3>> {
    let degrees = (1..=5_usize, 1..=5_usize);
    let both = degrees.prop_flat_map(|(ku, kv)| (knots(ku), knots(kv)));
    both.prop_flat_map(|(u, v)| {
        let (rows, columns) = (u.functions(), v.functions());
        prop::collection::vec(point(), rows * columns).prop_map(move |points| {
            let net = Net::from_fn(rows, columns, |i, j| points[i * columns + j]).expect("not empty");
            BSplineSurface::new(u.clone(), v.clone(), net).expect("the right size")
        })
    })
}

pub(crate) fn distance(a: P3, b: P3) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Evenly spaced parameters of `[0, 1]`, both ends included.
pub(crate) fn parameters() -> impl Iterator<Item = f64> {
    (0..=40).map(|i| f64::from(i) / 40.0)
}

/// The largest distance between two curves over `[0, 1]`.
pub(crate) fn largest_distance(a: &BSplineCurve<P3>, b: &BSplineCurve<P3>) -> f64 {
    parameters().map(|t| distance(a.eval(t), b.eval(t))).fold(0.0, f64::max)
}

pub(crate) fn cross(a: P3, b: P3) -> P3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: P3, b: P3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A point of an edge at a part of its length, the derivative there away from the surface (`sign` 1) or into it (−1),
/// and the derivative along the edge.
pub(crate) fn at_edge(surface: &BSplineSurface<P3>, edge: Edge, part: f64, sign: f64) -> (P3, P3, P3) {
    let [du, dv] = surface.domain().ranges();
    let (across, along) = if edge.across() == Direction::U { (du, dv) } else { (dv, du) };
    let c = across[usize::from(edge.is_end())];
    let t = along[0] + (along[1] - along[0]) * part;
    let (u, v, orders) = match edge.across() {
        Direction::U => (c, t, [[1, 0], [0, 1]]),
        Direction::V => (t, c, [[0, 1], [1, 0]]),
    };
    let [out, tangent] = orders.map(|orders| surface.partial(u, v, orders));
    // Away from the surface at its upper end, into it at the lower one; `sign` says which is wanted.
    let sign = if edge.is_end() { sign } else { -sign };
    (surface.eval(u, v), out.map(|x| x * sign), tangent)
}

pub(crate) fn edge() -> impl Strategy<Value = Edge> {
    (0..4_usize).prop_map(|i| Edge::ALL[i])
}

pub(crate) fn orientation() -> impl Strategy<Value = Orientation> {
    prop_oneof![Just(Orientation::Same), Just(Orientation::Opposite)]
}
