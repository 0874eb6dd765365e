//! The only code that has to be believed: it checks proofs about polynomials, and nothing else says that something is true.
//!
//! A [`Statement`] is about polynomials on boxes and simplices, matrices of polynomials, or sums of dot products. A
//! [`Certificate`] says how it is proved, a [`Witness`] where it fails. A [`Proof`] and a [`Refutation`] can be made in no
//! other way than by checking them. Certificates are searched elsewhere; nothing that a search says counts before it has been
//! accepted here. So this crate is small and written to be read: each file of `check` begins with its theorem.
//!
//! ```
//! use std::rc::Rc;
//! use basis_kernel::algebra::{poly::{Poly, Var}, range::{Range, Region}, work::Work};
//! use basis_kernel::{Certificate, Domain, Proof, Quotient, Relation, Statement};
//!
//! // t (1 − t) ≥ 0 for 0 ≤ t ≤ 1: the empty certificate is enough.
//! let t = Poly::var(Var(0));
//! let value = Quotient::from(&t * &(&Poly::one() - &t));
//! let domain = Rc::new(Domain::of(Region { ranges: vec![(Var(0), Range::unit())] }));
//! let statement = Rc::new(Statement::Sign { value, relation: Relation::NonNegative, domain });
//! assert!(Proof::new(statement, Certificate::Direct, &mut Work::usual(1)).is_ok());
//! ```

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
pub use check::products::minor_signs;
pub use check::rank::minor;
pub use point::{Point, Root};
pub use proof::{Proof, Refutation, Witness};
pub use refusal::Refusal;
pub use statement::{Domain, Products, Quotient, Relation, Simplex, Statement, Values};
