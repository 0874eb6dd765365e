//! Ends of ranges that are irrational, as numbers.
//!
//! **Theorem.** Let g be a polynomial in x with a single zero ρ between a and b, g(a) > 0 and g(b) < 0. Where g(x) ≥ 0
//! on [a, b], x is a + (ρ − a)·z with 0 ≤ z ≤ 1, and z < 1 where g(x) > 0. A function f(x) = f(a + (ρ − a)·z) is a
//! polynomial in z and ρ, of which multiples of g(ρ) may be taken away. It is ≥ 0 if the rest is for all z from 0 to 1
//! and all numbers in place of ρ between two that have ρ between them.
//!
//! A claim that is sharp at the end has coefficients that vanish there exactly.

use basis_kernel::{Domain, Quotient, Relation, Statement};
use std::rc::Rc;

use super::{Sign, divided, without_premises};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{Root, isolate};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;

/// The work for the zeros of a premise, and how often the interval of one is halved.
const ZEROS: u64 = 1_000_000;
const HALVINGS: u32 = 60;

/// Longer polynomials are not written with the number.
const MAX_TERMS: usize = 600;

/// The zero of a premise that ends a range.
struct Zero {
    /// Numbers below and above it.
    between: [Rational; 2],
    /// Whether it is the upper end.
    is_upper: bool,
}

impl Zero {
    /// The only zero of a polynomial in a range at one end of which it is positive, and at the other one negative.
    fn of(g: &Poly, x: Var, range: &Range) -> Option<Self> {
        let (low, high) = range.finite()?;
        let p = Univariate::from_poly(g, x)?;
        let is_upper = match (p.sign_at(low), p.sign_at(high)) {
            (1, -1) => true,
            (-1, 1) => false,
            _ => return None,
        };
        let work = &mut Work::new(ZEROS);
        let mut zeros = isolate(&p.square_free_part(work)?, Some(low), Some(high), work)?;
        if zeros.len() != 1 || !matches!(zeros.first(), Some(Root::Between(..))) {
            return None;
        }
        let zero = zeros.first_mut()?;
        for _ in 0..HALVINGS {
            zero.refine(&p, work)?;
        }
        Some(Self { between: [zero.low().clone(), zero.high().clone()], is_upper })
    }
}

impl Sign<'_> {
    /// The statement with the irrational ends as numbers, where all premises say such ends.
    pub(super) fn at_irrational_ends(&self) -> Option<Vec<Statement>> {
        let Quotient { numerator, denominator } = &self.value;
        let mut domain = Domain::clone(&*without_premises(self.domain));
        let (mut above, mut below) = (numerator.clone(), denominator.clone());
        let ranged = domain.region.ranges.iter().map(|(v, _)| *v);
        let all = ranged.chain(numerator.variables()).chain(denominator.variables());
        let free = all.map(|v| v.0 + 1).max()?;
        for (k, (g, relation)) in self.domain.premises.iter().enumerate() {
            let [x] = g.variables()[..] else { return None };
            let (_, range) = domain.region.ranges.iter_mut().find(|(v, _)| *v == x)?;
            let Zero { between: [low, high], is_upper } = Zero::of(g, x, range)?;
            let (number, z) = (Var(free + k), Poly::var(x));
            // From the rational end towards the zero.
            let end = if is_upper { range.low.clone() } else { range.high.clone() };
            let from = Poly::constant(end.value()?.clone());
            let place = &from + &(&z * &(&Poly::var(number) - &from));
            let zero = g.substitute(x, &Poly::var(number));
            let put = |p: &Poly| Some(divided(&p.substitute(x, &place), &zero)?.1);
            (above, below) = (put(&above)?, put(&below)?);
            if above.len() > MAX_TERMS || below.len() > MAX_TERMS || below.is_zero() {
                return None;
            }
            let included = |x: Rational, yes: bool| if yes { End::Included(x) } else { End::Excluded(x) };
            *range = Range {
                low: included(Rational::ZERO, end.is_included()),
                high: included(Rational::ONE, *relation == Relation::NonNegative),
            };
            domain.region.ranges.push((number, Range::closed(low, high)));
        }
        let value = Quotient { numerator: above, denominator: below };
        Some(vec![Statement::Sign { value, relation: self.relation, domain: Rc::new(domain) }])
    }
}
