//! The runtime behind other paths.

mod my_crate {
    pub mod numerics {
        pub use basis_runtime as runtime;
    }
}

mod absolute {
    basis_runtime::basis!("../../../specs/quadratic.basis", crate = crate::my_crate::numerics::runtime);
}
mod relative {
    use super::my_crate::numerics;
    numerics::runtime::basis!("../../../specs/quadratic.basis", crate = self::numerics::runtime, QuadraticBezier as Curve);
}
mod inline {
    basis_runtime::basis! {
        crate = ::basis_runtime;
        family Line { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; }
    }
}

fn main() {
    assert_eq!(absolute::QuadraticBezier::new(0.5).unwrap().values(1.0), [0.0, 0.0, 1.0]);
    assert_eq!(relative::Curve::new(0.5).unwrap().values(1.0), [0.0, 0.0, 1.0]);
    assert_eq!(inline::Line::new().values(0.25), [0.75, 0.25]);
}
