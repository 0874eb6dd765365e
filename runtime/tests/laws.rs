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
        let middle = P::from_vector(b.scale(S::of(2.0)).minus(a)).add_weighted(c, -S::ONE);
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

#[cfg(feature = "macros")]
mod on_domains {
    use basis_runtime::laws::{Checks, boxes, products, simplices};
    use basis_runtime::{BoxBasis, ProductBasis, SimplexBasis, TriangularBernsteinBasis, basis};

    use super::{Law, broken};

    /// The first law that is broken.
    type Kept = Option<Law>;

    basis!(library "triangles/prisms", QuadraticWedge, BernsteinPrism(2, 2) as Prism);
    basis!("../../specs/triangular.basis", TriangularII(3));
    basis!("../../specs/lagrange.basis", Bilinear, TetrahedralLagrange(2));

    basis! {
        family Sheet {
            shape 0 <= λ <= 1;
            domain -1 <= u <= 3, 0 <= v <= 1/2, 0 <= w <= 1;
            b[0] = λ*((u + 1)/4)^2*2*v;
            b[1] = 1 - b[0] - b[2];
            b[2] = (1 - λ)*((3 - u)/4)*(1 - 2*v)*w;
        }
        /// Sums to less than 1.
        family Short {
            domain triangle (u, v, w);
            b[0] = u^2;
            b[1] = v + w;
        }
    }

    fn of_simplex<B: SimplexBasis>(basis: B) -> [Kept; 2] {
        let checks = Checks::default();
        [simplices::consistent(&basis, &checks), simplices::geometric(&basis, &checks)].map(broken)
    }

    fn of_box<B: BoxBasis>(basis: B) -> [Kept; 2] {
        let checks = Checks::default();
        [boxes::consistent(&basis, &checks), boxes::geometric(&basis, &checks)].map(broken)
    }

    fn of_product<B: ProductBasis>(basis: B) -> [Kept; 2] {
        let checks = Checks::default();
        [products::consistent(&basis, &checks), products::geometric(&basis, &checks)].map(broken)
    }

    #[test]
    fn generated_families_keep_what_they_promise() {
        assert_eq!(of_simplex(TriangularBernsteinBasis::<f64, 4, 10>::new()), [None, None]);
        assert_eq!(of_simplex(TriangularBernsteinBasis::<f32, 3, 6>::new()), [None, None]);
        for (a, b) in [(0.5, 1.0), (1.5, 2.0)] {
            assert_eq!(of_simplex(TriangularII::<f64>::new(a, b).unwrap()), [None, None]);
            assert_eq!(of_simplex(TriangularII::<f32>::new(a as f32, b as f32).unwrap()), [None, None]);
        }
        for shape in [0.0, 0.25, 1.0] {
            assert_eq!(of_box(Sheet::<f64>::new(shape).unwrap()), [None, None]);
            assert_eq!(of_box(Sheet::<f32>::new(shape as f32).unwrap()), [None, None]);
        }
        assert_eq!(of_box(Bilinear::<f64>::new()), [None, None]);
        assert_eq!(of_product(Prism::<f64>::new()), [None, None]);
        assert_eq!(of_product(Prism::<f32>::new()), [None, None]);
    }

    #[test]
    fn what_is_broken_is_found() {
        // Nodal families of degree 2 are negative somewhere.
        assert_eq!(of_simplex(TetrahedralLagrange::<f64>::new()), [None, Some(Law::Nonnegative)]);
        assert_eq!(of_product(QuadraticWedge::<f64>::new()), [None, Some(Law::Nonnegative)]);
        assert_eq!(of_simplex(Short::<f64>::new()), [None, Some(Law::PartitionOfUnity)]);
        let violation = simplices::partition_of_unity(&Short::<f64>::new(), &Checks::default()).unwrap_err();
        assert_eq!(violation.at.coordinates().len(), 3);
        assert!(violation.to_string().starts_with("Short breaks the law that the functions sum to 1: "));
    }

    /// A wrapper that gets one of the answers wrong.
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct Wrong<const WHAT: u8>;

    impl<const WHAT: u8> BoxBasis for Wrong<WHAT> {
        type Scalar = f64;
        type Coordinates = [f64; 2];
        type Orders = [usize; 2];
        type Values = [f64; 4];
        type Points<T: Copy> = [T; 4];
        type Bernstein<T: Copy> = [T; 4];

        const NAME: &'static str = "Wrong";
        const DEGREES: &'static [usize] = &[1, 1];

        fn domain() -> [[f64; 2]; 2] {
            [[0.0, 0.0], [1.0, 1.0]]
        }

        fn values(&self, [u, v]: [f64; 2]) -> [f64; 4] {
            let extra = if WHAT == 0 { 1e-6 * u * v } else { 0.0 };
            [(1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v + extra]
        }

        fn bernstein_weights(&self) -> [[f64; 4]; 4] {
            core::array::from_fn(|j| core::array::from_fn(|i| f64::from(u8::from(i == j))))
        }

        fn partials(&self, at: [f64; 2], orders: [usize; 2]) -> [f64; 4] {
            let [u, v] = at;
            let factor = if WHAT == 1 { 1.0 + 1e-3 } else { 1.0 };
            match orders {
                [0, 0] => self.values(at),
                [1, 0] => [v - 1.0, -v, 1.0 - v, v],
                [0, 1] => [factor * (u - 1.0), 1.0 - u, -u, u],
                [1, 1] => [1.0, -1.0, -1.0, 1.0],
                _ => [0.0; 4],
            }
        }
    }

    #[test]
    fn implementations_that_contradict_themselves() {
        assert_eq!(of_box(Wrong::<0>)[0], Some(Law::Form));
        assert_eq!(of_box(Wrong::<1>)[0], Some(Law::Derivatives));
        assert_eq!(of_box(Wrong::<2>), [None, None]);
    }
}
