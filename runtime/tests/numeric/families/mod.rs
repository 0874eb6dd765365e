//! Families written by hand exactly as `basis!` emits them.

mod bernstein;
mod quadratic_lagrange;
mod quartic_bernstein;
mod small;
mod uniform_cubic;

pub use bernstein::{Bernstein7, Bernstein30};
pub use quadratic_lagrange::QuadraticLagrange;
pub use quartic_bernstein::QuarticBernstein;
pub use small::{Constant, Linear};
pub use uniform_cubic::UniformCubic;
