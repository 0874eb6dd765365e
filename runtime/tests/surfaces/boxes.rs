//! Boxes around surfaces contain them, and the tight one touches them.

use basis_runtime::Surface;

use crate::families::{bicubic, graph, random_surface};
use crate::random::Random;

#[test]
fn contain_the_surface_and_touch_it() {
    let random = &mut Random::new(61);
    for _ in 0..20 {
        let surface = random_surface::<[f64; 3]>(random);
        let ([low, high], [lower, higher]) = (surface.bounding_box(), surface.control_box());
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for i in 0..=100 {
            for j in 0..=100 {
                let point = surface.eval(f64::from(i) / 100.0, f64::from(j) / 100.0);
                for c in 0..3 {
                    least[c] = least[c].min(point[c]);
                    most[c] = most[c].max(point[c]);
                }
            }
        }
        for c in 0..3 {
            assert!(low[c] <= least[c] + 1e-14 && low[c] > least[c] - 1e-2, "{low:?} {least:?}");
            assert!(high[c] >= most[c] - 1e-14 && high[c] < most[c] + 1e-2, "{high:?} {most:?}");
            assert!(lower[c] <= low[c] && higher[c] >= high[c]);
        }
    }
}

#[test]
fn are_tight_inside() {
    let [low, high] = graph(|u, v| u * (1.0 - u) - (v - 0.3) * (v - 0.3)).bounding_box();
    assert!((high[2] - 0.25).abs() < 1e-14 && (low[2] + 2.0 + 1.69).abs() < 1e-14, "{low:?} {high:?}");
    assert_eq!(([low[0], low[1]], [high[0], high[1]]), ([-1.0, -1.0], [1.0, 1.0]));
}

/// A ridge: the largest value along a whole curve across the parameters.
#[test]
fn of_a_ridge_are_nearly_tight() {
    let ridge = graph(|u, v| -(u - v) * (u - v));
    let [low, high] = ridge.bounding_box();
    assert!(high[2] >= 0.0 && high[2] < 1e-4, "{high:?}");
    assert!((low[2] + 4.0).abs() < 1e-14);
}

#[test]
fn of_degenerate_surfaces() {
    assert_eq!(bicubic(|_, _| [1.0, 2.0, 3.0]).bounding_box(), [[1.0, 2.0, 3.0]; 2]);
    let [low, high] =
        bicubic(|i, j| [i as f64, j as f64, if i == 1 { f64::NAN } else { 0.0 }]).bounding_box();
    assert!(low[2].is_nan() && high[2].is_nan());
    assert_eq!((low[0], high[1]), (0.0, 3.0));
    let [low, _] = bicubic(|i, j| [i as f64, j as f64, f64::INFINITY]).bounding_box();
    assert!(low[2].is_nan());
    assert!(bicubic(|i, _| [if i == 3 { f64::NAN } else { 0.0 }; 3]).control_box()[0][0].is_nan());
}
