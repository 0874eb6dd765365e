//! What a spec means: families as exact tables of functions over a domain and shape parameters, and their
//! claims as exact differences to be compared with zero.
//!
//! `library` reads the specs of a run and has families expanded on demand; `scope` knows what names mean
//! meanwhile; `formula` goes from expressions to exact functions; `expand` from the statements of a family to the
//! family and its claims. [`Family`] is what comes out.

pub mod angle;
pub(crate) mod bernstein;
pub(crate) mod budget;
pub mod chart;
pub(crate) mod ends;
mod expand;
mod family;
pub(crate) mod formula;
mod library;
pub mod obligation;
pub mod roots;
pub(crate) mod scope;
pub(crate) mod tuples;
mod unused;
pub(crate) mod words;

#[cfg(feature = "joins")]
pub(crate) use expand::shapes::parts;
pub(crate) use family::label;
pub use family::{Barycentric, Factor, Family, Function, Parameter, Truncation, Truncations};
pub use library::{Library, Selected};
