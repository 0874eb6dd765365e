//! Generated code in a crate without the standard library, under another name of the runtime, with every warning an
//! error.
#![no_std]
#![deny(
    warnings,
    missing_docs,
    unused,
    unreachable_pub,
    missing_debug_implementations,
    clippy::all,
    clippy::pedantic
)]

curves::basis!(library "quartic", crate = curves);
curves::basis!(library "bernstein", crate = ::curves, Bernstein(3), Bernstein(14) as High);

/// A point of the curve over four numbers.
///
/// # Errors
/// When λ is outside of its declared range.
pub fn point(lambda: f32, points: [f32; 4], t: f32) -> Result<f32, curves::ShapeError> {
    Ok(curves::Curve::new(QuarticBernstein::new(lambda)?, points).eval(t))
}

#[cfg(test)]
#[allow(clippy::float_cmp)] // these numbers are exact
mod tests {
    use super::{Bernstein, High, point};

    #[test]
    fn the_crate_works() {
        assert_eq!(point(1.0, [1.0, 2.0, 4.0, 8.0], 1.0), Ok(8.0));
        assert!(point(2.0, [0.0; 4], 0.5).is_err());
        assert_eq!(Bernstein::<f64>::new().values(0.5), [0.125, 0.375, 0.375, 0.125]);
        assert_eq!(High::<f64>::default().values(0.0)[0], 1.0);
    }
}
