//! The checker from outside: what it must accept, what it must refuse, and forged certificates.

use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::rational::Rational;

mod arithmetic;
mod forged;
mod signs;
mod tables;
mod text;
mod witnesses;

/// The value of a polynomial at a point with a number for every variable.
fn value(p: &Poly, point: &[Rational]) -> Rational {
    let at = point.iter().enumerate().fold(p.clone(), |p, (k, x)| p.at(Var(k), x));
    at.as_constant().expect("a number for every variable")
}
