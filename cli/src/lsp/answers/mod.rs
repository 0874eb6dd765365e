//! Answers to the requests of an editor, one file for each kind.

pub(super) mod actions;
pub(super) mod complete;
pub(super) mod hover;
pub(super) mod marks;
pub(super) mod names;
pub(super) mod outline;
pub(super) mod words;
