//! The caller's names do not get into the generated code.
#![allow(dead_code, non_camel_case_types, non_upper_case_globals, unused_macros, clippy::all)]

mod core {}
mod std {}
mod basis_runtime_values {}

struct Result;
struct Option;
struct Some;
struct None;
struct Ok;
struct Err;
struct PhantomData;
struct Bound;
struct ShapeError;
struct Array;
struct Values;
struct Form;
struct Points;
trait Copy {}
trait Clone {}
trait Debug {}
trait Default {}
trait PartialEq {}
trait Into {}
trait Scalar {}
trait Point {}
trait SimplexBasis {}
trait BoxBasis {}
trait TriangularBasis {}
trait Basis {
    fn derivatives(&self) {}
    fn values(&self) {}
}
impl<T> Basis for T {}

fn unit() {}
fn bernstein() {}
fn combine() {}
fn check_shape() {}
fn simplex_sum() {}
fn box_sum() {}
fn raise_weights() {}
fn table() {}

macro_rules! include_bytes {
    ($($any:tt)*) => {
        compile_error!("not the macro of this crate")
    };
}

::basis_runtime::basis!("../../../specs/quartic.basis");
::basis_runtime::basis!("../../../specs/beta_spline.basis");
::basis_runtime::basis!("../../../specs/bernstein.basis", Bernstein(13));
::basis_runtime::basis!("../../../specs/triangular.basis", TriangularI(3));
::basis_runtime::basis!("../../../specs/lagrange.basis", Serendipity, TetrahedralLagrange(2));

fn main() {
    let quartic = QuarticBernstein::new(0.5_f32).unwrap();
    assert_eq!(quartic.values(0.0), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(quartic.derivatives(0.0, 1), [-3.5, 3.5, 0.0, 0.0]);
    let curve = ::basis_runtime::Curve::new(Bernstein::<f64>::new(), [1.0; 14]);
    assert_eq!(curve.eval(0.0), 1.0);
    let triangle = TriangularI::<f64>::new(1.0, 2.0).unwrap();
    assert_eq!(triangle.values([1.0, 0.0, 0.0])[9], 1.0);
    assert_eq!(Serendipity::<f64>::new().values([1.0, -1.0])[1], 1.0);
    assert_eq!(TetrahedralLagrange::<f32>::new().values([0.0, 0.0, 0.0, 1.0])[0], 1.0);
    assert!(BetaSpline::<f64>::new(1.0, 0.0).is_ok());
}
