//! Pieces of Rust code that the generators for intervals, for simplices and boxes, and for joins share: names, numbers,
//! documentation, and the type itself.

pub(super) mod docs;
pub(super) mod floats;
pub(super) mod names;
pub(super) mod reach;
pub(super) mod shell;
pub(super) mod tokens;
