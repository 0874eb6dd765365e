//! Projections: the nearest point of the whole surface.

use basis_runtime::Surface;
use basis_runtime::bspline::{BSplineSurface, Direction, KnotVector, Net};
use proptest::prelude::*;

use crate::support::{P3, distance, point, surface};

fn plane() -> BSplineSurface<P3> {
    let knots = KnotVector::uniform(3, 4).unwrap();
    let greville = knots.greville();
    let net = Net::from_fn(7, 7, |i, j| [greville[i], greville[j], 0.0]).unwrap();
    BSplineSurface::new(knots.clone(), knots, net).unwrap()
}

/// A quarter of a dome: nearly all of it is nearly as far from the origin as all else.
fn dome() -> BSplineSurface<P3> {
    let c = 0.552_284_749_830_793_6;
    let arc = [[1.0, 0.0], [1.0, c], [c, 1.0], [0.0, 1.0]];
    let net = Net::from_fn(4, 4, |i, j| [arc[i][0] * arc[j][0], arc[i][1] * arc[j][0], arc[j][1]]);
    BSplineSurface::from_bezier(net.unwrap()).unwrap()
}

#[test]
fn projections_on_a_plane_are_feet() {
    let plane = plane();
    let found = plane.nearest([0.3, 0.6, -2.0], 1e-10).unwrap();
    assert!((found.at[0] - 0.3).abs() < 1e-8 && (found.at[1] - 0.6).abs() < 1e-8);
    assert!((found.distance - 2.0).abs() < 1e-14);
    let beyond = plane.nearest([1.5, -0.5, 0.0], 1e-10).unwrap();
    assert_eq!(beyond.at, [1.0, 0.0]);
    assert_eq!(plane.nearest([f64::NAN; 3], 1e-10), None);
}

#[test]
fn a_narrow_dip_is_found() {
    // Between the samples of any coarse grid: a single control point reaches down to the given one.
    let knots = KnotVector::clamped(3, &[0.0, 0.41, 0.418, 0.4185, 0.419, 0.427, 1.0]).unwrap();
    let greville = knots.greville();
    let net =
        Net::from_fn(9, 9, |i, j| [greville[i], greville[j], if (i, j) == (4, 4) { -2.0 } else { 0.0 }])
            .unwrap();
    let surface = BSplineSurface::new(knots.clone(), knots, net).unwrap();
    let found = surface.nearest([0.4, 0.4, -1.0], 1e-10).unwrap();
    assert!((0.41..0.427).contains(&found.at[0]) && found.distance < 0.2, "{found:?}");
    assert!(found.distance - found.at_least < 1e-9);
}

#[test]
fn jumps_creases_and_constant_directions() {
    // Two constant bands at the heights 0 and 1, straight in the other direction.
    let knots = [KnotVector::uniform(0, 2).unwrap(), KnotVector::uniform(1, 3).unwrap()];
    let net = Net::from_fn(2, 4, |i, j| [i as f64, j as f64, i as f64]).unwrap();
    let [u, v] = knots;
    let bands = BSplineSurface::new(u, v, net).unwrap();
    let found = bands.nearest([1.0, 1.75, 2.0], 1e-10).unwrap();
    assert!((found.distance - 1.0).abs() < 1e-12 && (found.at[1] - 1.75 / 3.0).abs() < 1e-9);
    let below = bands.nearest([0.0, 3.0, -1.0], 1e-10).unwrap();
    assert_eq!((below.distance, below.point), (1.0, [0.0, 3.0, 0.0]));

    // A tent: its ridge is nearest to what is above it.
    let knots = KnotVector::uniform(1, 2).unwrap();
    let net = Net::from_fn(3, 2, |i, j| [i as f64, j as f64, if i == 1 { 1.0 } else { 0.0 }]).unwrap();
    let tent = BSplineSurface::new(knots, KnotVector::uniform(1, 1).unwrap(), net).unwrap();
    let found = tent.nearest([1.0, 0.25, 3.0], 1e-10).unwrap();
    assert_eq!((found.at, found.distance), ([0.5, 0.25], 2.0));
}

#[test]
fn equally_near_points_cost_bounded_work_and_the_bound_says_what_is_proved() {
    for height in [0.0, 1e-3, 0.1] {
        let found = dome().nearest([0.0, 0.0, height], 1e-10).unwrap();
        assert!(found.at_least <= found.distance && found.at_least > 0.999 * found.distance, "{found:?}");
    }
    let collapsed = dome().map(|_| [1.0, 2.0, 2.0]);
    let found = collapsed.nearest([0.0; 3], 1e-10).unwrap();
    assert!(found.distance == 3.0 && found.at_least > 3.0 - 1e-12);
}

#[test]
fn any_scale_and_what_is_not_finite() {
    let at = [0.3, 0.4, 2.0];
    let here = dome().nearest(at, 1e-10).unwrap();
    for scale in [1e-200, 1e-9, 1e9, 1e200] {
        let scaled = |p: P3| p.map(|x| x * scale);
        let found = dome().map(scaled).nearest(scaled(at), 1e-10).unwrap();
        assert!((found.distance / scale - here.distance).abs() < 1e-12, "{scale}: {found:?}");
    }
    // Nothing could be proved where the surface is not finite.
    for number in [f64::NAN, f64::INFINITY] {
        let mut broken = plane();
        broken.control_points_mut()[0] = [number; 3];
        assert_eq!(broken.nearest([0.9, 0.9, 1.0], 1e-10), None);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_sample_is_nearer(surface in surface(), point in point()) {
        let found = surface.nearest(point, 1e-10).unwrap();
        prop_assert!(found.at_least <= found.distance && found.distance - found.at_least < 1e-7);
        let parameters: Vec<f64> = (0..=60).map(|i| f64::from(i) / 60.0).collect();
        let mut samples = vec![[0.0; 3]; 61 * 61];
        surface.eval_grid(&parameters, &parameters, &mut samples).unwrap();
        for sample in samples {
            prop_assert!(distance(sample, point) >= found.at_least, "{} {:?}", distance(sample, point), found);
            prop_assert!(distance(sample, point) >= found.distance - 1e-8);
        }
    }

    #[test]
    fn points_of_the_surface_are_found(surface in surface(), u in 0.0..=1.0, v in 0.0..=1.0) {
        let found = surface.nearest(surface.eval(u, v), 1e-10).unwrap();
        prop_assert!(found.distance < 1e-8, "{:?}", found);
    }

    #[test]
    fn projections_are_minima(surface in surface(), point in point()) {
        // Where a surface jumps, no point need be the nearest one.
        let jumps = |d| surface.knots(d).breakpoints().into_iter().skip(1).any(|t| {
            t < 1.0 && surface.knots(d).multiplicity(t) > surface.knots(d).degree()
        });
        prop_assume!(!jumps(Direction::U) && !jumps(Direction::V));
        let found = surface.nearest(point, 1e-10).unwrap();
        let [u, v] = found.at;
        prop_assert_eq!(found.point, surface.eval(u, v));
        prop_assert!((distance(found.point, point) - found.distance).abs() < 1e-12);
        for [du, dv] in [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [0.7, 0.7], [-0.7, 0.7]] {
            let near = surface.eval_clamped(u + 1e-5 * du, v + 1e-5 * dv);
            prop_assert!(distance(near, point) >= found.distance - 1e-9);
        }
    }

    #[test]
    fn projections_on_a_landscape_are_the_nearest_points(
        heights in prop::collection::vec(-0.15..0.15, 49),
        point in [-0.5..1.5, -0.5..1.5, -1.0..1.0],
    ) {
        let mut surface = plane();
        for (point, height) in surface.control_points_mut().iter_mut().zip(heights) {
            point[2] = height;
        }
        let found = surface.nearest(point, 1e-10).unwrap();
        for i in 0..=40 {
            for j in 0..=40 {
                let sample = surface.eval(f64::from(i) / 40.0, f64::from(j) / 40.0);
                prop_assert!(distance(sample, point) >= found.distance - 1e-9);
            }
        }
    }
}
