//! The nearest point of a tensor surface is the nearest of all, within the accuracy.

use basis_runtime::Surface;

use crate::families::random_surface;
use crate::random::Random;

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn is_the_nearest_of_all() {
    let random = &mut Random::new(110);
    for round in 0..20 {
        let surface = random_surface::<[f64; 3]>(random);
        let target: [f64; 3] = core::array::from_fn(|_| random.between(-2.0, 2.0));
        let accuracy = [1e-3, 1e-9][round % 2];
        let found = surface.nearest(target, accuracy).unwrap();
        let [u, v] = found.at;
        assert_eq!(surface.eval(u, v), found.point);
        assert!((distance(found.point, target) - found.distance).abs() < 1e-14);
        assert!(found.at_least >= found.distance - accuracy && found.at_least <= found.distance);
        for _ in 0..2000 {
            let other = surface.eval(random.between(0.0, 1.0), random.between(0.0, 1.0));
            assert!(distance(other, target) >= found.at_least);
        }
    }
}

#[test]
fn a_point_of_the_surface_is_its_own() {
    let random = &mut Random::new(111);
    for _ in 0..10 {
        let surface = random_surface::<[f64; 3]>(random);
        let target = surface.eval(random.between(0.0, 1.0), random.between(0.0, 1.0));
        assert!(surface.nearest(target, 1e-12).unwrap().distance < 1e-12);
    }
}

#[test]
fn not_finite() {
    let surface = random_surface::<[f64; 3]>(&mut Random::new(112));
    assert_eq!(surface.nearest([0.0, f64::NAN, 0.0], 1e-6), None);
    assert_eq!(surface.nearest([0.0, f64::INFINITY, 0.0], 1e-6), None);
    let found = [0.0, -1.0, f64::NAN].map(|accuracy| surface.nearest([0.5; 3], accuracy).unwrap());
    assert!(found.iter().all(|found| found.at_least > found.distance - 1e-12), "{found:?}");
}
