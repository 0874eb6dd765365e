//! Lists, maps and sorting that cost little to compile.
//!
//! The standard library's are compiled again for every closure and every pair of types, and every user of the macro
//! builds all of that, unoptimised. These are for the few elements that a spec has.

pub mod list;
pub mod sort;
