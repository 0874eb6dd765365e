//! The exported law checks, tried as a crate would that has families of its own.

use basis_runtime::laws::{self, Checks, Law};
use basis_runtime::{Basis, BernsteinForm, Point, basis};

basis! {
    /// A quadratic family on an interval of its own, with one shape parameter.
    family Own {
        domain -1 <= t <= 3;
        shape 0 <= μ <= 2;

        let x = (t + 1)/4;
        b[0] = (1 - x)^2 + (2 - μ)*x*(1 - x)/2;
        b[1] = μ*x*(1 - x);
        b[2] = x^2 + (2 - μ)*x*(1 - x)/2;

        prove partition_of_unity;
        prove nonnegative;
    }

    /// Its functions do not sum to 1.
    family NoUnity {
        domain 0 <= t <= 1;
        b[0] = (1 - t)^2;
        b[1] = t;

        refute partition_of_unity;
        prove nonnegative;
    }

    /// One of its functions is negative for t < 1/2.
    family Negative {
        domain 0 <= t <= 1;
        b[0] = (1 - t)*(1 - 2*t);
        b[1] = 4*t*(1 - t);
        b[2] = t*(2*t - 1);

        prove partition_of_unity;
        refute nonnegative;
    }
}

#[test]
fn what_is_proved_keeps_the_laws() {
    let checks = Checks::default();
    for mu in [0.0, 0.5, 2.0] {
        laws::consistent(&Own::new(mu).unwrap(), &checks).unwrap();
        laws::geometric(&Own::new(mu).unwrap(), &checks).unwrap();
    }
    laws::consistent(&Own::<f32>::new(1.25).unwrap(), &checks).unwrap();
    laws::geometric(&Own::<f32>::new(1.25).unwrap(), &checks).unwrap();
}

#[test]
fn what_is_refuted_breaks_them() {
    let checks = Checks::default();
    laws::consistent(&NoUnity::<f64>::new(), &checks).unwrap();
    let broken = laws::geometric(&NoUnity::<f64>::new(), &checks).unwrap_err();
    assert_eq!((broken.law, broken.family), (Law::PartitionOfUnity, "NoUnity"));
    assert_eq!(
        laws::affine_invariance(&NoUnity::<f64>::new(), &checks).unwrap_err().law,
        Law::AffineInvariance
    );

    laws::consistent(&Negative::<f64>::new(), &checks).unwrap();
    laws::partition_of_unity(&Negative::<f64>::new(), &checks).unwrap();
    let broken = laws::nonnegative(&Negative::<f64>::new(), &checks).unwrap_err();
    assert!(
        broken.law == Law::Nonnegative
            && broken.found < 0.0
            && (0.0..1.0).contains(&broken.at.coordinates()[0])
    );
    assert_eq!(laws::convex_hull(&Negative::<f64>::new(), &checks).unwrap_err().law, Law::ConvexHull);
}

/// A family that was written by hand around a generated one, with mistakes to choose from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ByHand {
    own: Own,
    /// Every value is too large by this part.
    value: f64,
    /// So is every derivative.
    derivative: f64,
    /// The Bernstein coefficients are in the wrong order.
    turned: bool,
}

impl Basis for ByHand {
    type Scalar = f64;
    type Values = [f64; 3];
    type Points<T: Copy> = [T; 3];
    type Bernstein<T: Copy> = [T; 3];
    type Form<P: Point<Scalar = f64>> = BernsteinForm<P, 3>;

    const NAME: &'static str = "ByHand";

    fn domain() -> [f64; 2] {
        Own::<f64>::domain()
    }

    fn values(&self, t: f64) -> [f64; 3] {
        self.own.values(t).map(|b| b * (1.0 + self.value))
    }

    fn derivatives(&self, t: f64, order: usize) -> [f64; 3] {
        if order == 0 {
            return self.values(t);
        }
        self.own.derivatives(t, order).map(|b| b * (1.0 + self.derivative))
    }

    fn bernstein_weights(&self) -> [[f64; 3]; 3] {
        let mut weights = self.own.bernstein_weights();
        if self.turned {
            weights.reverse();
        }
        weights
    }

    fn bind<P: Point<Scalar = f64>>(&self, points: &[P; 3]) -> BernsteinForm<P, 3> {
        BernsteinForm::new(self.own.to_bernstein(points))
    }
}

#[test]
fn mistakes_of_a_family_by_hand_are_caught() {
    let checks = Checks::default();
    let right = ByHand { own: Own::new(0.75).unwrap(), value: 0.0, derivative: 0.0, turned: false };
    laws::consistent(&right, &checks).unwrap();
    laws::geometric(&right, &checks).unwrap();

    let law = |basis: ByHand| laws::consistent(&basis, &checks).unwrap_err().law;
    assert_eq!(law(ByHand { value: 1e-9, ..right }), Law::Form);
    assert_eq!(law(ByHand { derivative: 1e-3, ..right }), Law::Derivatives);
    assert_eq!(law(ByHand { turned: true, ..right }), Law::Form);
}
