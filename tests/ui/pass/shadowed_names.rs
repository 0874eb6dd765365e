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
trait Basis {
    fn derivatives(&self) {}
    fn values(&self) {}
}
impl<T> Basis for T {}

fn unit() {}
fn bernstein() {}
fn combine() {}
fn check_shape() {}

macro_rules! include_bytes {
    ($($any:tt)*) => {
        compile_error!("not the macro of this crate")
    };
}

::basis_runtime::basis!("../../../specs/quartic.basis");
::basis_runtime::basis!("../../../specs/beta_spline.basis");
::basis_runtime::basis!("../../../specs/bernstein.basis", Bernstein(13));

fn main() {
    let quartic = QuarticBernstein::new(0.5_f32).unwrap();
    assert_eq!(quartic.values(0.0), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(quartic.derivatives(0.0, 1), [-3.5, 3.5, 0.0, 0.0]);
    let curve = ::basis_runtime::Curve::new(Bernstein::<f64>::new(), [1.0; 14]);
    assert_eq!(curve.eval(0.0), 1.0);
    assert!(BetaSpline::<f64>::new(1.0, 0.0).is_ok());
}
