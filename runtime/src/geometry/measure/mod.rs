//! How long curves are, where they turn, what they enclose, and polygons that follow them.

pub(super) mod bounds;
pub(super) mod enclosed;
pub(super) mod flatten;
pub(super) mod length;
