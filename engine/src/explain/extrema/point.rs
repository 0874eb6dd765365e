//! Points whose coordinates are rational, or lie in one field that a real algebraic number generates.

use super::numbers;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::field::{Element, Field, enclosure, field_of};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use basis_prover::Coordinate;
use basis_prover::collections::list::Listed;

/// Fields of a higher degree are left alone.
const MAX_DEGREE: usize = 12;

/// Values of some variables.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// The field of the coordinates; none where all of them are rational.
    field: Option<Field>,
    coordinates: Vec<(Var, Element)>,
}

/// A rational number as an element of any field.
pub(super) fn constant(x: &Rational) -> Element {
    Univariate::new(vec![x.clone()])
}

impl Point {
    /// The point with rational coordinates.
    pub(super) fn rational(coordinates: &[(Var, Rational)]) -> Self {
        let coordinates = coordinates.iter().map(|(var, x)| (*var, constant(x))).listed();
        Self { field: None, coordinates }
    }

    /// The point with irrational coordinates; `None` where their field is of a high degree, or the work is spent.
    pub(super) fn irrational(roots: &[(Var, Algebraic)], work: &mut Work) -> Option<Self> {
        let numbers = roots.iter().map(|(_, x)| x.clone()).listed();
        if numbers.is_empty() {
            return Some(Self::rational(&[]));
        }
        let degree = numbers.iter().fold(1, |n: usize, x| n.saturating_mul(x.polynomial().degree()));
        if degree > MAX_DEGREE {
            return None;
        }
        let (field, elements) = field_of(&numbers, work)?;
        let coordinates = roots.iter().map(|(var, _)| *var).zip(elements).listed();
        Some(Self { field: Some(field), coordinates })
    }

    /// The point with a further coordinate in the same field.
    pub(super) fn with(mut self, var: Var, x: Element) -> Self {
        self.coordinates.push((var, x));
        self
    }

    /// The point with a further coordinate that is in another field.
    pub(super) fn with_root(self, var: Var, x: &Algebraic, work: &mut Work) -> Option<Self> {
        let Some(field) = &self.field else {
            let mut point = Self::irrational(&[(var, x.clone())], work)?;
            point.coordinates.extend(self.coordinates);
            return Some(point);
        };
        let own = field.root().clone();
        if own.polynomial().degree().saturating_mul(x.polynomial().degree()) > MAX_DEGREE {
            return None;
        }
        let (larger, elements) = field_of(&[own, x.clone()], work)?;
        let mut coordinates = Vec::new();
        for (known, element) in &self.coordinates {
            coordinates.push((*known, larger.compose(element, elements.first()?, work)?));
        }
        coordinates.push((var, elements.last()?.clone()));
        Some(Self { field: Some(larger), coordinates })
    }

    /// Whether a variable has a coordinate.
    pub(super) fn has(&self, var: Var) -> bool {
        self.coordinates.iter().any(|(v, _)| *v == var)
    }

    /// The coordinate of a variable; 0 for one that has none.
    pub(super) fn element(&self, var: Var) -> Element {
        self.coordinates.iter().find(|(v, _)| *v == var).map(|(_, x)| x.clone()).unwrap_or_default()
    }

    /// The field of the coordinates, if they are not all rational.
    pub(super) const fn field(&mut self) -> Option<&mut Field> {
        self.field.as_mut()
    }

    /// The value of a polynomial.
    pub(super) fn eval(&self, p: &Poly, work: &mut Work) -> Option<Element> {
        let Some(field) = &self.field else {
            let mut p = p.clone();
            for (var, x) in &self.coordinates {
                let x = x.leading();
                work.spend_at(&p, *var, &x)?;
                p = p.at(*var, &x);
            }
            return Some(constant(&p.as_constant()?));
        };
        field.eval(p, &self.coordinates, work)
    }

    /// The value of a quotient; nothing inside where its denominator is 0, `None` when the work is spent.
    #[expect(clippy::option_option, reason = "the work may be spent")]
    pub(super) fn quotient(&mut self, f: &Fraction, work: &mut Work) -> Option<Option<Element>> {
        let (above, below) = (self.eval(f.numer(), work)?, self.eval(f.denom(), work)?);
        if self.sign(&below, work)? == 0 {
            return Some(None);
        }
        let Some(field) = &mut self.field else {
            return Some(Some(constant(&above.leading().checked_div(&below.leading())?)));
        };
        let inverse = field.inverse(&below, work)?;
        Some(Some(field.mul(&above, &inverse, work)?))
    }

    /// The sign of an element: −1, 0 or 1.
    pub(super) fn sign(&mut self, x: &Element, work: &mut Work) -> Option<i32> {
        let Some(field) = &mut self.field else { return Some(x.leading().signum()) };
        if field.is_zero(x, work)? {
            return Some(0);
        }
        let x = field.reduce(x, work)?;
        let mut root = field.root().clone();
        loop {
            let (low, high) = enclosure(&x, &root, work)?;
            if low.is_positive() || high.is_negative() {
                return Some(low.signum());
            }
            let width = &(root.high() - root.low()) * &Rational::new(1, 4);
            root.refine_below(&width, work)?;
        }
    }

    /// Numbers between which an element lies, close together.
    pub(super) fn bounds(&self, x: &Element, work: &mut Work) -> Option<(Rational, Rational)> {
        let Some(field) = &self.field else { return Some((x.leading(), x.leading())) };
        let mut root = field.root().clone();
        root.refine_below(&Rational::new(1, 1 << 40), work)?;
        enclosure(&field.reduce(x, work)?, &root, work)
    }

    /// An element as a number of its own.
    pub(super) fn number(&self, x: &Element, work: &mut Work) -> Option<Coordinate> {
        match &self.field {
            Some(field) => numbers::in_field(field, &field.reduce(x, work)?, work),
            None => Some(Coordinate::Rational(x.leading())),
        }
    }
}
