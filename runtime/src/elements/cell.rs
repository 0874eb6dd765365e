//! Cells as products of simplices, an interval being the simplex with two corners.

use alloc::vec::Vec;
use core::ops::Range;

use super::tabulation::lattice;
use crate::DomainFactor;

/// A factor of a cell, with the indices of the Bernstein polynomials of its degree.
pub(crate) struct Factor {
    /// The number of corners.
    pub(super) corners: usize,
    /// The components of an index that are coordinates: of an interval one, of a simplex all.
    pub(super) coordinates: Range<usize>,
    /// The degree of the polynomials.
    pub(super) degree: usize,
    /// The index of each polynomial, one component for each corner, with the degree as their sum.
    indices: Vec<usize>,
}

impl Factor {
    /// A simplex, its polynomials in lexicographic order of their indices.
    pub(crate) fn simplex(corners: usize, degree: usize) -> Self {
        Self { corners, coordinates: 0..corners, degree, indices: lattice(corners, degree) }
    }

    /// An interval, the polynomial that is not 0 at its lower end first; that end is corner 0.
    pub(crate) fn interval(degree: usize) -> Self {
        let indices = (0..=degree).flat_map(|k| [degree - k, k]).collect();
        Self { corners: 2, coordinates: 1..2, degree, indices }
    }

    /// The number of polynomials.
    pub(super) fn size(&self) -> usize {
        self.indices.len() / self.corners
    }

    /// The index of a polynomial.
    pub(super) fn index(&self, place: usize) -> &[usize] {
        &self.indices[place * self.corners..][..self.corners]
    }
}

/// The factors of a domain.
pub(crate) fn product(factors: &[DomainFactor]) -> Vec<Factor> {
    let factor = |factor: &DomainFactor| match *factor {
        DomainFactor::Interval { degree } => Factor::interval(degree),
        DomainFactor::Triangle { degree } => Factor::simplex(3, degree),
        DomainFactor::Tetrahedron { degree } => Factor::simplex(4, degree),
    };
    factors.iter().map(factor).collect()
}

/// The places in each factor of a product of polynomials; of products those of the last factor change fastest.
pub(super) fn places(factors: &[Factor], product: usize) -> Vec<usize> {
    let mut rest = product;
    let mut places = alloc::vec![0; factors.len()];
    for (place, factor) in places.iter_mut().zip(factors).rev() {
        *place = rest % factor.size();
        rest /= factor.size();
    }
    places
}
