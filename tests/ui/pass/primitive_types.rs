//! Types with the names of primitive types.
#![allow(dead_code, non_camel_case_types)]

struct f64;
struct usize;
struct str;
struct u8;

basis_runtime::basis!("../../../specs/quadratic.basis");

fn main() {
    let basis = QuadraticBezier::<f32>::new(0.5).unwrap();
    assert_eq!(basis.values(0.0), [1.0, 0.0, 0.0]);
}
