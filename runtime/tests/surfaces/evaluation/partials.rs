//! Partial derivatives of every order.

use basis_runtime::Surface;

use crate::families::{graph, random_surface};
use crate::random::Random;

/// `Σ_i b_i⁽ᵃ⁾(u) Σ_j c_ij⁽ᵇ⁾(v) P_ij`, the derivatives of the functions by another way.
#[test]
fn are_sums_of_derivatives() {
    let random = &mut Random::new(11);
    for _ in 0..50 {
        let surface = random_surface::<[f64; 2]>(random);
        let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let partials = surface.eval_with_partials::<6>(u, v);
        assert_eq!(partials[0][0], surface.eval(u, v));
        for (a, row) in partials.iter().enumerate() {
            for (b, partial) in row.iter().enumerate() {
                let weights = surface.u_basis().derivatives(u, a);
                let mut expected = [0.0; 2];
                for (row, weight) in surface.rows().iter().zip(weights) {
                    for (point, c) in row.control_points().iter().zip(row.basis().derivatives(v, b)) {
                        expected = [0, 1].map(|k| expected[k] + weight * c * point[k]);
                    }
                }
                let tolerance = 1e-14 * 6_f64.powi((a + b) as i32);
                for k in 0..2 {
                    assert!(
                        (partial[k] - expected[k]).abs() < tolerance,
                        "{a} {b}: {partial:?} {expected:?}"
                    );
                }
            }
        }
        assert_eq!(partials[5], [[0.0; 2]; 6]);
    }
}

/// z = u² v on the square from -1 to 1: the width of the domain counts.
#[test]
fn on_another_domain() {
    let surface = graph(|u, v| u * u * v);
    let [[point, v], [u, uv]] = surface.eval_with_partials(0.5, -0.25);
    assert_eq!(point, [0.5, -0.25, -0.0625]);
    assert_eq!([u, v, uv], [[1.0, 0.0, -0.25], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0]]);
    assert_eq!(surface.eval_with_partials::<3>(0.5, -0.25)[2][1], [0.0, 0.0, 2.0]);
}

#[test]
fn none_or_one() {
    let surface = graph(|u, v| u + v);
    assert_eq!(surface.eval_with_partials::<0>(0.5, 0.5), [[[0.0; 3]; 0]; 0]);
    assert_eq!(surface.eval_with_partials::<1>(0.5, 0.5), [[surface.eval(0.5, 0.5)]]);
}
