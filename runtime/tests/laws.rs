//! The exported law checks accept what keeps the laws and find what breaks them.
#![cfg(feature = "laws")]

use core::marker::PhantomData;

use basis_runtime::laws::{self, Checks, Law, Violation};
use basis_runtime::{Basis, BernsteinBasis, EndpointForm, Point, Scalar};

/// Quadratic functions with the Bernstein coefficients `C`, whose derivatives and values can be made wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Custom<S> {
    coefficients: [[f64; 3]; 3],
    wrong_value: bool,
    wrong_derivative: bool,
    wrong_end: bool,
    scalar: PhantomData<S>,
}

impl<S: Scalar> Custom<S> {
    /// Rows by function.
    fn new(coefficients: [[f64; 3]; 3]) -> Self {
        Self {
            coefficients,
            wrong_value: false,
            wrong_derivative: false,
            wrong_end: false,
            scalar: PhantomData,
        }
    }
}

impl<S: Scalar> Basis for Custom<S> {
    type Scalar = S;
    type Values = [S; 3];
    type Points<T: Copy> = [T; 3];
    type Bernstein<T: Copy> = [T; 3];
    type Form<P: Point<Scalar = S>> = EndpointForm<P, 1>;

    const NAME: &'static str = "Custom";

    fn domain() -> [S; 2] {
        [S::of(-1.0), S::of(3.0)]
    }

    fn values(&self, t: S) -> [S; 3] {
        let x = (t + S::ONE) / S::of(4.0);
        let s = S::ONE - x;
        let b = [s * s, S::of(2.0) * s * x, x * x];
        let mut values =
            self.coefficients.map(|c| b[0] * S::of(c[0]) + b[1] * S::of(c[1]) + b[2] * S::of(c[2]));
        if self.wrong_value {
            values[1] = values[1] + S::of(1e-3) * x * s * s;
        }
        values
    }

    fn bernstein_weights(&self) -> [[S; 3]; 3] {
        core::array::from_fn(|j| core::array::from_fn(|i| S::of(self.coefficients[i][j])))
    }

    fn bind<P: Point<Scalar = S>>(&self, points: &[P; 3]) -> EndpointForm<P, 1> {
        let [a, b, c] = self.to_bernstein(points);
        let middle = b.scale(S::of(2.0)).minus(a).minus(c);
        let end = if self.wrong_end { c.scale(S::of(1.0 + 1e-3)) } else { c };
        EndpointForm::new([a, end], [middle])
    }

    fn derivatives(&self, t: S, order: usize) -> [S; 3] {
        if order == 0 {
            return self.values(t);
        }
        let x = (t + S::ONE) / S::of(4.0);
        let two = S::of(2.0);
        // Forgets the width of the domain if it is wrong.
        let scale = if self.wrong_derivative { S::ONE } else { S::of(0.25_f64.powi(order as i32)) };
        self.coefficients.map(|c| {
            let [a, b, c] = c.map(S::of);
            scale
                * match order {
                    1 => two * ((b - a) * (S::ONE - x) + (c - b) * x),
                    2 => two * (a - two * b + c),
                    _ => S::ZERO,
                }
        })
    }
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn broken(result: Result<(), Violation>) -> Option<Law> {
    result.err().map(|violation| violation.law)
}

#[test]
fn the_laws_hold_for_the_bernstein_basis() {
    fn hold<B: Basis>(basis: B) {
        let checks = Checks::default();
        laws::consistent(&basis, &checks).unwrap();
        laws::geometric(&basis, &checks).unwrap();
    }
    hold(BernsteinBasis::<f64, 1>::new());
    hold(BernsteinBasis::<f32, 2>::new());
    hold(BernsteinBasis::<f64, 4>::new());
    hold(BernsteinBasis::<f32, 8>::new());
    hold(BernsteinBasis::<f64, 21>::new());
    hold(Custom::<f64>::new(IDENTITY));
    hold(Custom::<f32>::new(IDENTITY));
}

/// The Lagrange basis sums to 1 but is negative; one function is missing 1/10 from the sum.
#[test]
fn geometric_laws_that_are_broken() {
    let checks = Checks::default();
    let lagrange = Custom::<f64>::new([[1.0, -0.5, 0.0], [0.0, 2.0, 0.0], [0.0, -0.5, 1.0]]);
    assert_eq!(broken(laws::consistent(&lagrange, &checks)), None);
    assert_eq!(broken(laws::partition_of_unity(&lagrange, &checks)), None);
    assert_eq!(broken(laws::affine_invariance(&lagrange, &checks)), None);
    assert_eq!(broken(laws::nonnegative(&lagrange, &checks)), Some(Law::Nonnegative));
    assert_eq!(broken(laws::convex_hull(&lagrange, &checks)), Some(Law::ConvexHull));
    let short = Custom::<f64>::new([[1.0, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 1.0]]);
    assert_eq!(broken(laws::consistent(&short, &checks)), None);
    assert_eq!(broken(laws::geometric(&short, &checks)), Some(Law::PartitionOfUnity));
    assert_eq!(broken(laws::affine_invariance(&short, &checks)), Some(Law::AffineInvariance));
}

#[test]
fn implementations_that_contradict_themselves() {
    let checks = Checks::default();
    let right = Custom::<f64>::new(IDENTITY);
    let wrong_value = Custom { wrong_value: true, ..right };
    assert_eq!(broken(laws::consistent(&wrong_value, &checks)), Some(Law::Form));
    let wrong_end = Custom { wrong_end: true, ..right };
    assert_eq!(broken(laws::consistent(&wrong_end, &checks)), Some(Law::Form));
    assert_eq!(broken(laws::split(&wrong_end, &checks)), Some(Law::Split));
    let wrong_derivative = Custom { wrong_derivative: true, ..right };
    assert_eq!(broken(laws::consistent(&wrong_derivative, &checks)), Some(Law::Derivatives));
    let nan = Custom::<f64>::new([[f64::NAN; 3]; 3]);
    assert!(laws::consistent(&nan, &checks).is_err() && laws::nonnegative(&nan, &checks).is_err());
}

#[test]
fn a_violation_says_where() {
    let short = Custom::<f64>::new([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]]);
    let violation = laws::partition_of_unity(&short, &Checks::default()).unwrap_err();
    assert_eq!(
        violation.to_string(),
        "Custom breaks the law that the functions sum to 1: 0.5 instead of 1 at 3"
    );
}
