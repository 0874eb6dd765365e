//! Specs that a build script has written, and specs of the library.
#![no_std]

use basis_runtime::basis;

basis!(concat!(env!("OUT_DIR"), "/ease.basis"));
basis!(
    ::core::concat!(std::env!("OUT_DIR", "there is a build script"), '/', "line", ".basis",),
    Line as Ramp
);

/// The library, all of a spec and one of its orders.
pub mod library {
    use basis_runtime::basis;

    basis!(library "quartic");
    basis!(library "lagrange", TriangularLagrange(2));
    basis!(crate = basis_runtime, library "beta_spline"); // it uses another spec of the library
    basis!(library "papers/quadratic", QuadraticBezier as Published,);
}

/// A spec in place that uses the library.
pub mod in_place {
    basis_runtime::basis! {
        use library "bspline";
        family Half {
            domain 0 <= t <= 1;
            b[0] = CubicBSpline[0](t/2);
            prove b[0] = (2 - t)^3/48;
        }
    }
}

macro_rules! from_a_macro {
    ($path:expr) => {
        basis!($path, Ease as Eased);
    };
}
from_a_macro!(concat!(env!("OUT_DIR"), "/ease.basis"));

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_a_written_spec() {
        assert_eq!(Ease::new().values(0.5_f64), [0.3125, 0.6875]);
        assert_eq!(Eased::new().values(0.5_f64), [0.3125, 0.6875]);
        assert_eq!(Ramp::new().values(0.25_f64), [0.75, 0.25]);
    }

    #[test]
    fn values_of_the_library() {
        let quartic = library::QuarticBernstein::new(0.0).expect("in the range");
        assert_eq!(quartic.values(0.5_f64), [0.125, 0.375, 0.375, 0.125]);
        let corner = library::TriangularLagrange::new().values([1.0_f64, 0.0, 0.0]);
        assert_eq!(corner.iter().filter(|value| **value == 1.0).count(), 1);
        assert_eq!(library::Published::new(0.0).expect("in the range").values(0.5_f64), [0.25, 0.5, 0.25]);
        assert!(library::BetaSpline::new(1.0, 0.0).is_ok());
        assert_eq!(in_place::Half::new().values(1.0_f64), [1.0 / 48.0]);
    }
}
