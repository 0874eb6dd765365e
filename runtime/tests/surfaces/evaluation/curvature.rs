//! Curvatures of surfaces whose curvatures are known.

use basis_runtime::Surface;

use crate::families::{bicubic, graph, random_surface};
use crate::random::Random;

#[test]
fn of_a_paraboloid() {
    let bowl = graph(|u, v| u * u + v * v);
    for u in [0.0, 0.25, -0.75, 1.0_f64] {
        let curvature = bowl.curvature(u, 0.0).unwrap();
        let slope = 1.0 + 4.0 * u * u;
        let (meridian, parallel) = (2.0 / slope.powf(1.5), 2.0 / slope.sqrt());
        assert!((curvature.principal[0] - parallel).abs() < 1e-14, "{curvature:?}");
        assert!((curvature.principal[1] - meridian).abs() < 1e-14);
        assert!((curvature.gaussian() - 4.0 / (slope * slope)).abs() < 1e-14);
        assert!((curvature.mean() - 0.5 * (meridian + parallel)).abs() < 1e-14);
        if u != 0.0 {
            assert!(curvature.directions[0][1].abs() > 1.0 - 1e-14);
        }
    }
}

#[test]
fn of_a_saddle_between_its_axes() {
    let curvature = graph(|u, v| 3.0 * u * v).curvature(0.0, 0.0).unwrap();
    assert_eq!(curvature.principal, [3.0, -3.0]);
    let [x, y, z] = curvature.directions[0];
    assert!((x - y).abs() < 1e-15 && z == 0.0);
    // Asymptotic directions.
    assert!(curvature.along([1.0, 0.0, 0.0]).unwrap().abs() < 1e-15);
    assert!((curvature.along([1.0, 1.0, 0.0]).unwrap() - 3.0).abs() < 1e-15);
    assert_eq!(curvature.along([0.0, 0.0, 1.0]), None);
    assert_eq!(curvature.along([0.0; 3]), None);
    assert_eq!(curvature.along([f64::NAN; 3]), None);
}

/// The curvatures do not depend on the parametrisation: shear and stretch the parameters of the same paraboloid.
#[test]
fn do_not_depend_on_the_parameters() {
    let straight = graph(|u, v| u * u - 0.5 * v * v + u * v);
    let sheared = bicubic(|i, j| {
        // x = (s + t)/4, y = t/3 with the polar form of z = x² - y²/2 + x y.
        let (s, t) = (i as f64 / 3.0, j as f64 / 3.0);
        let (x, y) = ((s + t) / 4.0, t / 3.0);
        let (s2, t2) = ([0.0, 0.0, 1.0, 3.0][i] / 3.0, [0.0, 0.0, 1.0, 3.0][j] / 3.0);
        let xx = (s2 + 2.0 * s * t + t2) / 16.0;
        let xy = (s * t + t2) / 12.0;
        [x, y, xx - t2 / 18.0 + xy]
    });
    let [x, y, z] = sheared.eval(0.4, 0.7);
    let flat = straight.eval(x, y);
    assert!((flat[2] - z).abs() < 1e-15, "the same surface");
    let (a, b) = (straight.curvature(x, y).unwrap(), sheared.curvature(0.4, 0.7).unwrap());
    for k in 0..2 {
        assert!((a.principal[k] - b.principal[k]).abs() < 1e-13, "{a:?} {b:?}");
        let cosine: f64 = (0..3).map(|c| a.directions[k][c] * b.directions[k][c]).sum();
        assert!(cosine.abs() > 1.0 - 1e-13);
    }
}

/// Gaussian curvature as (L N - M²)/(E G - F²), mean as (E N - 2 F M + G L)/(2 (E G - F²)).
#[test]
fn agree_with_the_fundamental_forms() {
    let random = &mut Random::new(31);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    for _ in 0..100 {
        let surface = random_surface::<[f64; 3]>(random);
        let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let partials = surface.eval_with_partials::<3>(u, v);
        let (su, sv) = (partials[1][0], partials[0][1]);
        let normal = surface.normal(u, v).unwrap();
        let (e, f, g) = (dot(su, su), dot(su, sv), dot(sv, sv));
        let [l, m, n] = [partials[2][0], partials[1][1], partials[0][2]].map(|s| dot(s, normal));
        let first = e * g - f * f;
        let (gaussian, mean) = ((l * n - m * m) / first, (e * n - 2.0 * f * m + g * l) / (2.0 * first));
        let curvature = surface.curvature(u, v).unwrap();
        let scale = curvature.principal[0].abs().max(curvature.principal[1].abs());
        assert!((curvature.gaussian() - gaussian).abs() <= 1e-10 * scale * scale);
        assert!((curvature.mean() - mean).abs() <= 1e-10 * scale);
        assert!(curvature.principal[0] >= curvature.principal[1]);
    }
}

#[test]
fn do_not_exist_without_a_tangent_plane() {
    assert_eq!(bicubic(|i, j| [i as f64, (i * j) as f64, 0.0]).curvature(0.0, 0.5), None);
    assert_eq!(bicubic(|_, _| [0.0; 3]).curvature(0.5, 0.5), None);
    assert_eq!(bicubic(|i, j| [i as f64, j as f64, f64::NAN]).curvature(0.5, 0.5), None);
}

#[test]
fn of_a_plane_are_zero() {
    let curvature = bicubic(|i, j| [i as f64, j as f64, (2 * i + j) as f64]).curvature(0.25, 0.5).unwrap();
    assert!(curvature.principal.iter().all(|k| k.abs() < 1e-15));
    assert!(curvature.directions.iter().flatten().all(|c| c.is_finite()));
}

/// A curvature is the inverse of a length, whatever the unit.
#[test]
fn in_any_unit_of_length() {
    let at = |size: f64| {
        let saddle = bicubic(|i, j| [i as f64, j as f64, (i * j) as f64 + 0.25 * i as f64].map(|c| c * size));
        saddle.curvature(0.25, 0.5).unwrap()
    };
    let expected = at(1.0);
    for size in [1e-150, 1e-40, 1e-20, 1e20, 1e40, 1e150] {
        let found = at(size);
        for k in 0..2 {
            let scaled = found.principal[k] * size;
            assert!((scaled - expected.principal[k]).abs() < 1e-14, "{size}: {scaled}");
        }
    }
}
