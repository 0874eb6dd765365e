#![doc = include_str!("../README.md")]

pub mod algebra;
mod certificate;
mod check;
pub mod collections;
mod point;
mod proof;
mod refusal;
mod statement;
#[cfg(feature = "text")]
pub mod text;

pub use certificate::{
    Base, Cells, Certificate, ChangeOfBasis, Combination, Cuts, FactorSign, Minors, Piece, Rank, Sample,
    Section, SignProof, Signed, Slices,
};
pub use check::Chart;
pub use check::pieces::{pieces, with};
pub use check::products::Gram;
pub use check::rank::minor;
pub use point::{Point, Root};
pub use proof::{Proof, Refutation, Witness};
pub use refusal::Refusal;
pub use statement::{Domain, Products, Quotient, Relation, Simplex, Statement, Values};
