//! Kinds of bytes: each has its own tree of decisions and weights. NUMBER has five, by the length of the number.

pub(crate) const OPERATION: usize = 0;
pub(crate) const VARIABLE: usize = 1;
pub(crate) const OFFSET: usize = 2;
pub(crate) const OFFSET_MORE: usize = 3;
pub(crate) const LENGTH: usize = 4;
pub(crate) const NUMBER: usize = 5;
pub(crate) const CALL_HIGH: usize = 10;
pub(crate) const CALL_LOW: usize = 11;
pub(crate) const JUMP: usize = 12;
pub(crate) const KIND: usize = 13;
pub(crate) const LONG: usize = 14;
pub(crate) const DECLARED: usize = 15;
pub(crate) const REST: usize = 16;
pub(crate) const DATA: usize = 17;
pub(crate) const NEW: usize = 18;
pub(crate) const ABSENT: usize = 19; // whether a function is missing

/// How many there are. The last one is for the trees themselves.
pub(crate) const KINDS: usize = 21;
pub(crate) const SHAPES: usize = KINDS - 1;
