//! Families and nets that the tests build surfaces from.

use basis_runtime::{Point, Scalar, TensorSurface, basis};

use crate::random::Random;

basis!("../../../specs/quartic.basis");
basis!("../../../specs/quadratic.basis");
basis!(
    "../../../specs/bernstein.basis",
    Bernstein(1) as Linear,
    Bernstein(2) as Quadratic,
    Bernstein(3) as Cubic
);
basis!("../../../specs/bspline.basis", UniformBSpline(3));
basis! {
    /// Parabolas through three points.
    family Lagrange2 {
        domain -1 <= t <= 1;
        b[0] = t*(t - 1)/2;
        b[1] = (1 - t)*(1 + t);
        b[2] = t*(t + 1)/2;
    }
}

/// The parabolic graph of a function that is at most quadratic in each variable, over the square of side 2.
pub fn graph(height: impl Fn(f64, f64) -> f64) -> TensorSurface<Lagrange2, Lagrange2, [f64; 3]> {
    let net = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let (u, v) = (i as f64 - 1.0, j as f64 - 1.0);
            [u, v, height(u, v)]
        })
    });
    TensorSurface::new(Lagrange2::new(), Lagrange2::new(), net)
}

/// The surface with five shape parameters.
pub type FiveParameters<P> =
    TensorSurface<QuarticBernstein<<P as Point>::Scalar>, QuarticBernstein<<P as Point>::Scalar>, P>;

/// A surface with five shape parameters over a random net in the cube of side 2.
pub fn random_surface<P: Point>(random: &mut Random) -> FiveParameters<P> {
    TensorSurface::with_rows(
        random_quartic(random),
        core::array::from_fn(|_| random_quartic(random)),
        core::array::from_fn(|_| core::array::from_fn(|_| P::from_components(|_| random.between(-1.0, 1.0)))),
    )
}

pub fn random_quartic<S: Scalar>(random: &mut Random) -> QuarticBernstein<S> {
    QuarticBernstein::new(random.between(-2.9, 1.0)).unwrap()
}

/// A bicubic surface over a net.
pub fn bicubic(net: impl Fn(usize, usize) -> [f64; 3]) -> TensorSurface<Cubic, Cubic, [f64; 3]> {
    let net = core::array::from_fn(|i| core::array::from_fn(|j| net(i, j)));
    TensorSurface::new(Cubic::new(), Cubic::new(), net)
}
