//! Names that are different in the spec and the same in Rust, and names that generated code needs itself.
use basis_runtime::basis;

basis! {
    family Λ1 { domain 0 <= t <= 1; b[0] = t; }
    family Lambda1 { domain 0 <= t <= 1; b[0] = t; }
    family f64 { domain 0 <= t <= 1; b[0] = t; }
    family str { domain 0 <= t <= 1; b[0] = t; }
    family usize { domain 0 <= t <= 1; b[0] = t; }
    family Self { domain 0 <= t <= 1; b[0] = t; }
    family joins { domain 0 <= t <= 1; b[0] = t; }
    join λ1 {
        curve P = Bernstein(2);
        curve Q = Bernstein(2);
        let Q[0] = P[2];
        prove P(1) == Q(0);
    }
    join lambda1 {
        curve P = Bernstein(2);
        curve Q = Bernstein(2);
        let Q[0] = P[2];
        prove P(1) == Q(0);
    }
}

fn main() {}
