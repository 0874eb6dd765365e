//! Brackets and powers nested too deeply.
use basis_runtime::basis;

basis! {
    family Nested {
        domain 0 <= t <= 1;
        b[0] = ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((t))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))));
    }
}

fn main() {}
