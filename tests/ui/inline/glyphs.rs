//! Glyphs that are no tokens of Rust are the compiler's own errors.
use basis_runtime::basis;

basis! {
    family Glyphs {
        domain 0 <= t <= 1;
        b[0] = t²;
        b[1] = λ₁;
        b[2] = 1 − t;
    }
}

fn main() {}
