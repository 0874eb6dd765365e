//! Fields are private: outside of the module shape values come through `new`.
mod elsewhere {
    basis_runtime::basis! {
        family Hidden {
            domain 0 <= t <= 1;
            shape 0 <= λ <= 1;
            b[0] = λ*t;
        }
    }
}

fn main() {
    let _ = elsewhere::Hidden { lambda: 7.0 };
}
