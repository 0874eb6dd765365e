//! What the tests of several crates share: how many cases a test takes, random numbers, polynomials from text, and the text of statements.

mod cases;
mod random;
mod statement;
mod text;

pub use cases::{all_cases, cases};
pub use random::Random;
pub use statement::statement_text;
pub use text::Names;
