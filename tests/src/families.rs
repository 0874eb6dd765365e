//! Every family of the library, generated in this crate as in any other.

use basis_runtime::{Basis, Scalar, ShapeError, basis};

use crate::exact::Reference;

basis!(library "ball");
basis!(library "ball", SaidBallOdd(3), WangBall(3));
// Above degree 4 curves are evaluated in another form.
basis!(
    library "bernstein",
    Bernstein(1) as Linear,
    Bernstein(3) as Cubic,
    Bernstein(4) as Bernstein4,
    Bernstein(5) as Bernstein5,
    Bernstein(30) as Bernstein30
);
basis!(library "beta_spline");
basis!(library "bspline");
basis!(library "bspline", UniformBSpline(5));
basis!(library "cardinal");
basis!(library "delgado_pena", DelgadoPenaEven(3), DelgadoPenaOdd(2));
basis!(library "hermite");
basis!(library "kochanek_bartels");
basis!(library "lagrange", Lagrange(8));
basis!(library "quadratic");
basis!(library "quartic");
basis!(library "smoothstep", Smoothstep(0), Smoothstep(5) as Smootheststep);
basis!("../specs/good/quadric.basis");
basis!("../specs/good/tenths.basis");
basis!("../specs/good/double_zeros.basis", Touching);

/// A generated type, with what it needs to be compared with its spec.
pub trait Shipped: Basis {
    /// The file, the family and its order.
    fn reference() -> Reference;

    /// The family with shape values.
    ///
    /// # Errors
    /// As `new`.
    fn with(shape: &[Self::Scalar]) -> Result<Self, ShapeError>;

    /// As the method of the type.
    fn coefficients(&self) -> Vec<Vec<Self::Scalar>>;

    /// As the method of the type.
    fn bernstein_coefficients(&self) -> Vec<Vec<Self::Scalar>>;
}

macro_rules! shipped {
    ($($type:ident: $file:literal $name:ident $order:expr, ($($shape:ident),*) => $new:expr;)+) => {$(
        impl<S: Scalar> Shipped for $type<S> {
            fn reference() -> Reference {
                Reference::new($file, stringify!($name), &$order)
            }
            fn with(shape: &[S]) -> Result<Self, ShapeError> {
                let [$($shape),*] = *shape else { panic!("wrong number of shape values") };
                $new
            }
            fn coefficients(&self) -> Vec<Vec<S>> {
                $type::coefficients(self).iter().map(|row| row.to_vec()).collect()
            }
            fn bernstein_coefficients(&self) -> Vec<Vec<S>> {
                $type::bernstein_coefficients(self).iter().map(|row| row.to_vec()).collect()
            }
        }
    )+};
}
shipped! {
    BallAlphaBeta: "ball.basis" BallAlphaBeta [], (alpha, beta) => Self::new(alpha, beta);
    SaidBall: "ball.basis" SaidBall [], () => Ok(Self::new());
    SaidBallOdd: "ball.basis" SaidBallOdd [3], () => Ok(Self::new());
    WangBall: "ball.basis" WangBall [3], () => Ok(Self::new());
    Linear: "bernstein.basis" Bernstein [1], () => Ok(Self::new());
    Cubic: "bernstein.basis" Bernstein [3], () => Ok(Self::new());
    Bernstein4: "bernstein.basis" Bernstein [4], () => Ok(Self::new());
    Bernstein5: "bernstein.basis" Bernstein [5], () => Ok(Self::new());
    Bernstein30: "bernstein.basis" Bernstein [30], () => Ok(Self::new());
    BetaSpline: "beta_spline.basis" BetaSpline [], (beta1, beta2) => Self::new(beta1, beta2);
    QuadraticBSpline: "bspline.basis" QuadraticBSpline [], () => Ok(Self::new());
    CubicBSpline: "bspline.basis" CubicBSpline [], () => Ok(Self::new());
    UniformBSpline: "bspline.basis" UniformBSpline [5], () => Ok(Self::new());
    Cardinal: "cardinal.basis" Cardinal [], (tau) => Self::new(tau);
    DelgadoPenaEven: "delgado_pena.basis" DelgadoPenaEven [3], () => Ok(Self::new());
    DelgadoPenaOdd: "delgado_pena.basis" DelgadoPenaOdd [2], () => Ok(Self::new());
    CubicHermite: "hermite.basis" CubicHermite [], () => Ok(Self::new());
    QuinticHermite: "hermite.basis" QuinticHermite [], () => Ok(Self::new());
    KochanekBartels: "kochanek_bartels.basis" KochanekBartels [], (tau, c, beta) => Self::new(tau, c, beta);
    Lagrange: "lagrange.basis" Lagrange [8], () => Ok(Self::new());
    QuadraticBezier: "quadratic.basis" QuadraticBezier [], (lambda) => Self::new(lambda);
    QuarticBernstein: "quartic.basis" QuarticBernstein [], (lambda) => Self::new(lambda);
    Smoothstep: "smoothstep.basis" Smoothstep [0], () => Ok(Self::new());
    Smootheststep: "smoothstep.basis" Smoothstep [5], () => Ok(Self::new());
    Tenths: "../tests/specs/good/tenths.basis" Tenths [], (lambda) => Self::new(lambda);
    Quadric: "../tests/specs/good/quadric.basis" Quadric [], (mu) => Self::new(mu);
    Touching: "../tests/specs/good/double_zeros.basis" Touching [], (a, c) => Self::new(a, c);
}

/// Calls a function, generic over [`Shipped`], for every family with that scalar type but [`Touching`], whose values have no
/// small relative errors.
#[macro_export]
macro_rules! each_family {
    ($scalar:ty, $visit:ident $(, $argument:expr)*) => {
        $crate::each_family!(@ $scalar, $visit, ($($argument),*),
            BallAlphaBeta SaidBall SaidBallOdd WangBall Linear Cubic Bernstein4 Bernstein5 Bernstein30 BetaSpline
            QuadraticBSpline CubicBSpline UniformBSpline Cardinal DelgadoPenaEven DelgadoPenaOdd CubicHermite
            QuinticHermite KochanekBartels Lagrange QuadraticBezier QuarticBernstein Smoothstep Smootheststep Quadric Tenths)
    };
    (@ $scalar:ty, $visit:ident, $arguments:tt, $($type:ident)+) => {
        $($crate::each_family!(% $visit::<$crate::families::$type<$scalar>>, $arguments);)+
    };
    (% $visit:expr, ($($argument:expr),*)) => { $visit($($argument),*) };
}
