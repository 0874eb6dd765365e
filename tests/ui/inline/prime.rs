//! A prime is the beginning of a character for the compiler.
basis_runtime::basis! {
    family Prime {
        domain 0 <= t <= 1;
        b[0] = t;
        prove b'(0) = 1;
    }
}

fn main() {}
