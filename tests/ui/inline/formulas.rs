//! Formulas that are no polynomials, and formulas that are too large.
use basis_runtime::basis;

basis! {
    family NotPolynomial {
        domain 0 <= t <= 1;
        shape 0 <= λ <= 1;
        b[0] = t^(1/2);
        b[1] = t^λ;
        b[2] = 1/0;
        b[3] = t/0;
        b[4] = 2t;
        b[5] = (1 - t)(1 + t);
        b[6] = t**2;
    }
    family Huge {
        domain 0 <= t <= 1;
        shape 0 <= λ <= 1;
        b[0] = (1 + t + λ)^100000;
        b[1] = t^99999999999999999999;
        b[2] = 2^1000000;
    }
}

fn main() {}
