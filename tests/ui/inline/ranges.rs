//! Empty and reversed ranges, no domain, an angle beside its sine.
use basis_runtime::basis;

basis! {
    family Ranges {
        domain 0 <= t <= 1;
        shape 1 <= λ <= -3;
        shape 0 < μ < 0;
        shape ν in 0..=1;
        b[0] = t;
    }
    family Mixed {
        shape 0 < α < pi; domain 0 <= t <= α;
        b[0] = t - sin(t);
    }
    family Without {
        b[0] = 1;
    }
}

fn main() {}
