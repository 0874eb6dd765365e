//! Variables and numbers as polynomials.

use crate::algebra::poly::{Poly, Var};

pub(crate) fn x() -> Poly {
    Poly::var(Var(0))
}

pub(crate) fn y() -> Poly {
    Poly::var(Var(1))
}

pub(crate) fn z() -> Poly {
    Poly::var(Var(2))
}

pub(crate) fn n(k: i64) -> Poly {
    Poly::integer(k)
}
