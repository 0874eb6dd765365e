//! The two smallest families: one constant function, and two linear ones on a domain whose width is no float.

use core::marker::PhantomData;

use basis_runtime::__private::unit;
use basis_runtime::{Basis, EndpointForm, Point, Scalar};

/// `b[0] = 1` on `0 <= t <= 1`.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Constant<S = f64>(PhantomData<S>);

impl<S: Scalar> Basis for Constant<S> {
    type Scalar = S;
    type Values = [S; 1];
    type Points<T: Copy> = [T; 1];
    type Bernstein<T: Copy> = [T; 1];
    type Form<P: Point<Scalar = S>> = EndpointForm<P, 0>;

    const NAME: &'static str = "Constant";

    fn domain() -> [S; 2] {
        [S::of(0.0), S::of(1.0)]
    }

    fn values(&self, _t: S) -> [S; 1] {
        [S::of(1.0)]
    }

    fn bernstein_weights(&self) -> [[S; 1]; 1] {
        [[S::of(1.0)]]
    }

    fn bind<P: Point<Scalar = S>>(&self, points: &[P; 1]) -> Self::Form<P> {
        EndpointForm::new([points[0], points[0]], [])
    }
}

/// The chord on `1/10 <= t <= 7/10`.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Linear<S = f64>(PhantomData<S>);

impl<S: Scalar> Basis for Linear<S> {
    type Scalar = S;
    type Values = [S; 2];
    type Points<T: Copy> = [T; 2];
    type Bernstein<T: Copy> = [T; 2];
    type Form<P: Point<Scalar = S>> = EndpointForm<P, 0>;

    const NAME: &'static str = "Linear";

    fn domain() -> [S; 2] {
        [S::of(0.1), S::of(0.7)]
    }

    fn values(&self, t: S) -> [S; 2] {
        unit(Self::domain(), t)
    }

    fn bernstein_weights(&self) -> [[S; 2]; 2] {
        [[S::of(1.0), S::of(0.0)], [S::of(0.0), S::of(1.0)]]
    }

    fn bind<P: Point<Scalar = S>>(&self, points: &[P; 2]) -> Self::Form<P> {
        EndpointForm::new(*points, [])
    }
}
