//! What the repository says of its specs is what the command finds: documentation, tables and grammars.

mod atlas;
mod editors;
mod guide;
mod papers;
mod readme;
#[path = "../support/mod.rs"]
mod support;
