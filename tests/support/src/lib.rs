//! What the tests of several crates share: random numbers, and polynomials from text.

mod random;
mod text;

pub use random::Random;
pub use text::Names;
