//! The checker from outside: what it must accept, what it must refuse, and forged certificates.

mod forged;
mod signs;
mod tables;
mod text;
mod witnesses;
