//! Surfaces: both directions, edges, grids, normals.

use basis_runtime::bspline::{BSplineSurface, Direction, Edge, KnotVector, Net, NurbsSurface, SplineError};
use basis_runtime::{Surface, Tessellation};
use proptest::prelude::*;

use crate::support::{P3, distance, surface};

const ROUNDING: f64 = 1e-12;

fn largest_distance(a: &BSplineSurface<P3>, b: &BSplineSurface<P3>) -> f64 {
    let parameters = || (0..=9).map(|i| f64::from(i) / 9.0);
    let pairs = parameters().flat_map(|u| parameters().map(move |v| (u, v)));
    pairs.map(|(u, v)| distance(a.eval(u, v), b.eval(u, v))).fold(0.0, f64::max)
}

#[test]
fn sizes_are_checked() {
    let knots = KnotVector::uniform(2, 2).unwrap();
    let net = Net::from_fn(4, 3, |_, _| [0.0; 3]).unwrap();
    let error = BSplineSurface::new(knots.clone(), knots, net).unwrap_err();
    assert_eq!(error, SplineError::Size { expected: [4, 4], found: [4, 3] });
}

#[test]
fn the_normal_of_a_plane_and_of_a_pole() {
    let plane = Net::from_fn(2, 2, |i, j| [i as f64, j as f64, 0.0]).unwrap();
    let plane = BSplineSurface::from_bezier(plane).unwrap();
    assert_eq!(plane.normal(0.3, 0.8), Some([0.0, 0.0, 1.0]));
    assert_eq!(plane.transposed().normal(0.3, 0.8), Some([0.0, 0.0, -1.0]));
    assert_eq!(plane.reversed(Direction::U).normal(0.3, 0.8), Some([0.0, 0.0, -1.0]));
    let pole = Net::from_fn(2, 2, |i, j| [i as f64, (i * j) as f64, 0.0]).unwrap();
    let pole = BSplineSurface::from_bezier(pole).unwrap();
    assert_eq!(pole.partial(0.0, 0.5, [0, 1]), [0.0; 3]);
    assert_eq!(pole.normal(0.0, 0.5), Some([0.0, 0.0, 1.0])); // the limit
    assert_eq!(pole.normal(f64::NAN, 0.5), None);
}

#[test]
fn single_precision() {
    let knots = || KnotVector::<f32>::uniform(3, 3).unwrap();
    let net = Net::from_fn(6, 6, |i, j| [i as f32, j as f32, 1.0]).unwrap();
    let surface = BSplineSurface::new(knots(), knots(), net).unwrap();
    assert!((surface.eval(0.4, 0.7)[2] - 1.0).abs() <= 4.0 * f32::EPSILON);
    assert_eq!(surface.eval(1.0, 0.0), [5.0, 0.0, 1.0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn representations_of_one_surface(surface in surface(), at in 0.05..0.95) {
        for direction in [Direction::U, Direction::V] {
            prop_assert!(largest_distance(&surface.insert_knots(direction, &[at, 0.5]).unwrap(), &surface) < ROUNDING);
            prop_assert!(largest_distance(&surface.elevate(direction).unwrap(), &surface) < ROUNDING);
            prop_assert!(largest_distance(&surface.refined(direction), &surface) < ROUNDING);
            let finer = surface.insert_knots(direction, &[at]).unwrap();
            let (back, removed) = finer.remove_knot(direction, at, 1, 1e-7).unwrap();
            prop_assert_eq!(removed, 1);
            prop_assert!(largest_distance(&back, &surface) < 1e-7);
            let [low, high] = surface.split(direction, at).unwrap();
            for x in [0.0, 0.2, 0.6, 1.0] {
                for y in [0.0, 0.4, 1.0] {
                    let (u, v) = if direction == Direction::U { (x, y) } else { (y, x) };
                    let part = if x < at { &low } else { &high };
                    prop_assert!(distance(part.eval(u, v), surface.eval(u, v)) < ROUNDING);
                }
            }
        }
        prop_assert!(largest_distance(&surface.clamped(), &surface) < ROUNDING);
        for patch in surface.to_bezier() {
            let [[a, b], [c, d]] = patch.domain;
            let bezier = BSplineSurface::from_bezier(patch.net).unwrap();
            let (x, y) = (0.25, 0.75);
            let expected = surface.eval(a + (b - a) * x, c + (d - c) * y);
            prop_assert!(distance(bezier.eval(x, y), expected) < ROUNDING);
        }
    }

    #[test]
    fn edges_grids_and_isocurves(surface in surface()) {
        for edge in Edge::ALL {
            let boundary = surface.boundary(edge);
            let at = f64::from(u8::from(edge.is_end()));
            for t in [0.0, 0.35, 1.0] {
                let (u, v) = if edge.across() == Direction::U { (at, t) } else { (t, at) };
                prop_assert!(distance(boundary.eval(t), surface.eval(u, v)) < ROUNDING);
            }
        }
        let (us, vs) = ([0.0, 0.3, 1.0], [0.1, 0.9]);
        let mut grid = vec![[0.0; 3]; us.len() * vs.len()];
        surface.eval_grid(&us, &vs, &mut grid).unwrap();
        for (i, &u) in us.iter().enumerate() {
            for (j, &v) in vs.iter().enumerate() {
                prop_assert!(distance(grid[i * vs.len() + j], surface.eval(u, v)) < ROUNDING);
                prop_assert!(distance(surface.isocurve(Direction::V, v).eval(u), grid[i * vs.len() + j]) < ROUNDING);
                prop_assert_eq!(surface.eval_with_partials::<1>(u, v)[0][0], surface.eval(u, v));
            }
        }
    }

    /// Many parameters at once, in order and not, few and many of them in a span: the points of `eval`.
    #[test]
    fn dense_grids_and_slices(surface in surface(), seed in 0..1000_usize) {
        let dense = |count: usize| (0..count).map(|k| k as f64 / (count - 1) as f64).collect::<Vec<f64>>();
        let (us, mut vs) = (dense(60), dense(120));
        let rational = NurbsSurface::from(surface.clone());
        for is_shuffled in [false, true] {
            if is_shuffled {
                for k in 0..vs.len() {
                    vs.swap(k, (k * 7919 + seed) % 120);
                }
            }
            for us in [&us[..], &us[40..45], &[0.7, 0.2]] {
                let mut grid = vec![[0.0; 3]; us.len() * vs.len()];
                let mut other = grid.clone();
                surface.eval_grid(us, &vs, &mut grid).unwrap();
                rational.eval_grid(us, &vs, &mut other).unwrap();
                for (n, (&p, &q)) in grid.iter().zip(&other).enumerate() {
                    let point = surface.eval(us[n / vs.len()], vs[n % vs.len()]);
                    prop_assert!(distance(p, point) < ROUNDING && distance(q, point) < ROUNDING);
                }
                prop_assert!(surface.eval_grid(us, &vs, &mut grid[..5]).is_err());
                prop_assert!(rational.eval_grid(us, &vs, &mut grid[..5]).is_err());
            }
            let curve = surface.isocurve(Direction::U, 0.4);
            let mut points = vec![[0.0; 3]; vs.len()];
            curve.eval_into(&vs, &mut points).unwrap();
            for (&t, &p) in vs.iter().zip(&points) {
                prop_assert!(distance(p, curve.eval(t)) < ROUNDING);
            }
        }
    }

    #[test]
    fn merging_is_exact(a in surface(), b in surface()) {
        let [c, d] = a.merged(&b).unwrap();
        for direction in [Direction::U, Direction::V] {
            prop_assert_eq!(c.knots(direction), d.knots(direction));
        }
        prop_assert!(largest_distance(&a, &c) < ROUNDING);
        prop_assert!(largest_distance(&b, &d) < ROUNDING);
    }
}

#[test]
fn surfaces_are_meshed_within_a_tolerance() {
    let knots = KnotVector::uniform(3, 4).unwrap();
    let net = Net::from_fn(7, 7, |i, j| [i as f64, j as f64, ((i * j) % 3) as f64]).unwrap();
    let surface = BSplineSurface::new(knots.clone(), knots, net).unwrap();
    let mesh = Tessellation::new(0.01).unwrap().with(&surface).mesh().unwrap();
    assert!(mesh.triangles.len() > 100);
}
