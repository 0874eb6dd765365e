//! What is drawn of a scene: functions on an interval as lines, those of two variables as maps.

mod curve;
pub(super) mod frame;
pub(super) mod lines;
pub(super) mod maps;
