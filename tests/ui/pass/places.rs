//! The macro in a function, in a module, in an associated constant's block; twice with different names.
#![deny(warnings)]

mod inner {
    pub mod deep {
        basis_runtime::basis!("../../../specs/bernstein.basis", Bernstein(2) as Quadratic, Bernstein(3) as Cubic);
    }
    basis_runtime::basis!("../../../specs/bernstein.basis", Bernstein(2) as Cubic);
}

fn local() -> [f64; 3] {
    basis_runtime::basis! {
        family Local {
            domain 0 <= t <= 1;
            b[0] = (1 - t)^2;
            b[1] = 2*t*(1 - t);
            b[2] = t^2;
            prove partition_of_unity;
        }
    }
    Local::new().values(0.5)
}

struct Holder;
impl Holder {
    const VALUE: fn() -> [f64; 1] = {
        basis_runtime::basis! { family Constant { domain 0 <= t <= 1; c[0] = 2; } }
        || Constant::new().values(0.3)
    };
}

fn main() {
    assert_eq!(local(), [0.25, 0.5, 0.25]);
    assert_eq!((Holder::VALUE)(), [2.0]);
    assert_eq!(inner::deep::Quadratic::new().values(0.5), local());
    assert_eq!(inner::deep::Cubic::new().values(1.0_f32), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(inner::Cubic::new().values(0.5), local());
}
