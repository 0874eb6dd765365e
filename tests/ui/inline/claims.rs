//! Claims that say nothing, say too little, or are false.
use basis_runtime::basis;

basis! {
    family Claims {
        domain 0 <= t <= 1;
        shape -3 <= λ <= 1;
        b[0] = 1 - t;
        b[1] = t + λ*t^2;
        prove partition_of_unity;
        prove symetric;
        porve symmetric;
        prove 1 = 2;
        prove at t = 0 { b = [1, 0, 0]; D(b) = [-1, 1]; }
        prove at t = 2 { b[0] = -1; }
        prove D(b[1], 2) = λ;
        refute b[0] + t = 1;
    }
}

fn main() {}
