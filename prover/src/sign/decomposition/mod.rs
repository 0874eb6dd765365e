//! Step 6: cylindrical decompositions, open for p ≥ 0 and by slices for p > 0.

pub(super) mod cells;
pub(crate) mod projection;
pub(super) mod slices;
pub(crate) mod zeros;
