//! Points to curves of all kinds, and grids of points to surfaces.
#![cfg(all(feature = "std", feature = "bspline", feature = "macros"))]
#![allow(unreachable_pub)]

mod families;
mod grids;
mod hostile;
mod orthogonal;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod splines;

use basis_runtime::basis;

basis!("../../../specs/quartic.basis");
basis! {
    /// Rational functions with a weight and a shape parameter more.
    family Weighted {
        shape 1/10 <= ω <= 5, -1 <= κ <= 1;
        domain 0 <= t <= 2;
        let x = t/2;
        let w = (1 - x)^2 + 2*ω*x*(1 - x) + x^2;
        b[0] = (1 - x)^2*(1 - κ*x)/w;
        b[1] = (2*ω*x*(1 - x) + κ*x*(1 - x)^2)/w;
        b[2] = x^2/w;
    }
}
basis! {
    /// 1, cos θ and sin θ, over an angle that is a shape value.
    family Turning {
        shape 0 < φ < pi;
        domain 0 <= θ <= φ;
        b[0] = cos(θ);
        b[1] = 1 - cos(θ);
        b[2] = sin(θ);
    }
}
basis! {
    /// The quadratic B-splines over two spans.
    family Spans {
        shape 1/4 <= d <= 4;
        domain 0 <= x <= 1, 1 <= x <= 1 + d;
        b[0] = (1 - x)^2 | 0;
        b[1] = x*(1 - x) + x*(1 + d - x)/(1 + d) | (1 + d - x)^2/(d*(1 + d));
        b[2] = x^2/(1 + d) | 1 - (1 + d - x)^2/(d*(1 + d)) - ((x - 1)/d)^2;
        b[3] = 0 | ((x - 1)/d)^2;
    }
}

/// The distance of two points.
fn distance<const D: usize>(p: [f64; D], q: [f64; D]) -> f64 {
    (0..D).map(|d| (p[d] - q[d]).powi(2)).sum::<f64>().sqrt()
}
