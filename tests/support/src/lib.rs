//! What the tests of several crates share: random numbers, polynomials from text, and the text of statements.

mod random;
mod statement;
mod text;

pub use random::Random;
pub use statement::statement_text;
pub use text::Names;
