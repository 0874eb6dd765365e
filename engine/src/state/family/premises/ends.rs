//! Ends of ranges that are irrational, as numbers.
//!
//! **Theorem.** Let g be a polynomial in x with a single zero ρ between a and b, g(a) > 0 and g(b) < 0. Where g(x) ≥ 0
//! on [a, b], x is a + (ρ − a)·z with 0 ≤ z ≤ 1, and z < 1 where g(x) > 0. A function f(x) = f(a + (ρ − a)·z) is a
//! polynomial in z and ρ, of which multiples of g(ρ) may be taken away. It is ≥ 0 if the rest is for all z from 0 to 1
//! and all numbers in place of ρ between two that have ρ between them.
//!
//! With a zero ρ at the lower end and a zero σ at the upper one it is ρ + (σ − ρ)·z. Where ρ > σ no number satisfies both
//! premises, and nothing has to hold.
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
use basis_prover::collections::list::Listed;

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

/// An end of a range: a rational number, or the zero of a premise.
struct Place {
    value: Poly,
    is_included: bool,
    zero: Option<Number>,
}

/// A zero that is written as a variable.
struct Number {
    var: Var,
    between: [Rational; 2],
    /// The premise in the variable, which is 0.
    vanishes: Poly,
}

impl Place {
    /// An end that the range has of its own.
    fn of(end: &End) -> Option<Self> {
        Some(Self { value: Poly::constant(end.value()?.clone()), is_included: end.is_included(), zero: None })
    }

    /// Numbers below and above the end; `None` of a rational one, which every zero in the range replaces.
    fn between(&self) -> Option<&[Rational; 2]> {
        self.zero.as_ref().map(|zero| &zero.between)
    }
}

impl Sign<'_> {
    /// The statement with the irrational ends as numbers, where all premises say such ends.
    pub(super) fn at_irrational_ends(&self) -> Option<Vec<Statement>> {
        let Quotient { numerator, denominator } = &self.value;
        let mut domain = Domain::clone(&*without_premises(self.domain));
        let (mut above, mut below) = (numerator.clone(), denominator.clone());
        let ranged = domain.region.ranges.iter().map(|(v, _)| *v);
        let of_simplices = domain.simplices.iter().flat_map(|s| s.variables.iter().copied());
        let all = ranged.chain(of_simplices).chain(numerator.variables()).chain(denominator.variables());
        let free = all.map(|v| v.0 + 1).max()?;
        let mut ends: Vec<(Var, [Place; 2])> = Vec::new();
        for (k, (g, relation)) in self.domain.premises.iter().enumerate() {
            let [x] = g.variables()[..] else { return None };
            let (_, range) = domain.region.ranges.iter().find(|(v, _)| *v == x)?;
            if ends.iter().all(|(v, _)| *v != x) {
                ends.push((x, [Place::of(&range.low)?, Place::of(&range.high)?]));
            }
            let Zero { between, is_upper } = Zero::of(g, x, range)?;
            let (_, places) = ends.iter_mut().find(|(v, _)| *v == x)?;
            let place = &mut places[usize::from(is_upper)];
            // Of two zeros on the same side the inner one is the end.
            if let Some([low, high]) = place.between() {
                let [nearer, farther] = if is_upper {
                    [&between[1] < low, high < &between[0]]
                } else {
                    [high < &between[0], &between[1] < low]
                };
                if !nearer && !farther {
                    return None;
                }
                if farther {
                    continue;
                }
            }
            let var = Var(free + k);
            let value = Poly::var(var);
            let vanishes = g.substitute(x, &value);
            let zero = Some(Number { var, between, vanishes });
            *place = Place { value, is_included: *relation == Relation::NonNegative, zero };
        }
        for (x, [low, high]) in ends {
            // From the lower end to the upper one, the variable now runs from 0 to 1.
            let way = &high.value - &low.value;
            let place = &low.value + &(&Poly::var(x) * &way);
            let (_, range) = domain.region.ranges.iter_mut().find(|(v, _)| *v == x)?;
            let end =
                |x: Rational, is_included| if is_included { End::Included(x) } else { End::Excluded(x) };
            let [low_end, high_end] =
                [end(Rational::ZERO, low.is_included), end(Rational::ONE, high.is_included)];
            *range = Range { low: low_end, high: high_end };
            let numbers = [low.zero, high.zero].into_iter().flatten().listed();
            let put = |p: &Poly| {
                let p = p.substitute(x, &place);
                numbers.iter().try_fold(p, |p, number| Some(divided(&p, &number.vanishes)?.1))
            };
            (above, below) = (put(&above)?, put(&below)?);
            if above.len() > MAX_TERMS || below.len() > MAX_TERMS || below.is_zero() {
                return None;
            }
            for Number { var, between: [low, high], .. } in numbers {
                domain.region.ranges.push((var, Range::closed(low, high)));
            }
        }
        let value = Quotient { numerator: above, denominator: below };
        Some(vec![Statement::Sign { value, relation: self.relation, domain: Rc::new(domain) }])
    }
}
