//! Which values rounding could make negative, although they are proved to be nonnegative; these are cut off at 0.
//!
//! Every node is enclosed in an interval that holds what floats of any kind compute for it, fused or not: each operation
//! widens its result by more than a rounding, which moves no end across 0, as rounding does not. Coordinates are
//! nonnegative, and sums in Bernstein form have the sign of their coefficients.

use super::build::{Builder, Variable};
use super::{Input, Node, Plan, Ref};
use crate::algebra::poly::Poly;
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use basis_kernel::{Certificate, Domain, Proof, Quotient, Relation, Statement};
use basis_prover::collections::list::Listed;
use std::rc::Rc;

/// Whether Bernstein coefficients are all ≥ 0, or all ≤ 0, for all shape values: as numbers, or as polynomials whose own
/// coefficients show it.
pub(super) fn has_one_sign(coefficients: &[Poly], region: &Region) -> bool {
    let domain = Rc::new(Domain::of(region.clone()));
    let fine = |p: &Poly| {
        p.as_constant().map_or_else(
            || {
                let (value, domain) = (Quotient::from(p.clone()), Rc::clone(&domain));
                let statement = Statement::Sign { value, relation: Relation::NonNegative, domain };
                Proof::new(Rc::new(statement), Certificate::Direct, &mut Work::usual(1)).is_ok()
            },
            |c| !c.is_negative(),
        )
    };
    coefficients.iter().all(fine) || coefficients.iter().all(|c| fine(&-c))
}

/// An interval; an end that is `None` is not known, or infinite.
#[derive(Clone)]
struct Interval {
    low: Option<Rational>,
    high: Option<Rational>,
}

impl Interval {
    const UNKNOWN: Self = Self { low: None, high: None };
    const NONNEGATIVE: Self = Self { low: Some(Rational::ZERO), high: None };

    fn number(value: &Rational) -> Self {
        Self { low: Some(value.clone()), high: Some(value.clone()) }.widened()
    }

    /// A range with its exact ends.
    fn of(range: &Range) -> Self {
        Self { low: range.low.value().cloned(), high: range.high.value().cloned() }
    }

    fn is_nonnegative(&self) -> bool {
        self.low.as_ref().is_some_and(|low| !low.is_negative())
    }

    fn is_nonpositive(&self) -> bool {
        self.high.as_ref().is_some_and(|high| !high.is_positive())
    }

    /// Wider by 2⁻²⁰ of each end, which is sixteen roundings of `f32`, and with ends that are multiples of 2⁻⁴⁰.
    fn widened(self) -> Self {
        let (unit, grid) = (Rational::new(1, 1 << 20), Rational::from(1 << 40));
        let cell = Rational::new(1, 1 << 40);
        let down = |x: Rational| &(&(&x - &(&x.abs() * &unit)) * &grid).floor() * &cell;
        // A positive number does not become smaller than 0, and 0 stays 0.
        Self { low: self.low.map(down), high: self.high.map(|x| -&down(-&x)) }
    }

    fn neg(&self) -> Self {
        Self { low: self.high.as_ref().map(|x| -x), high: self.low.as_ref().map(|x| -x) }
    }

    fn sum(&self, other: &Self) -> Self {
        let add = |a: &Option<Rational>, b: &Option<Rational>| Some(a.as_ref()? + b.as_ref()?);
        Self { low: add(&self.low, &other.low), high: add(&self.high, &other.high) }
    }

    fn product(&self, other: &Self) -> Self {
        if let (Some(a), Some(b), Some(c), Some(d)) = (&self.low, &self.high, &other.low, &other.high) {
            let all = [a * c, a * d, b * c, b * d];
            let (mut low, mut high) = (all[0].clone(), all[0].clone());
            for x in all {
                if x < low {
                    low = x;
                } else if x > high {
                    high = x;
                }
            }
            return Self { low: Some(low), high: Some(high) };
        }
        let signs = |x: &Self| (x.is_nonnegative(), x.is_nonpositive());
        match (signs(self), signs(other)) {
            ((true, _), (true, _)) | ((_, true), (_, true)) => Self::NONNEGATIVE,
            ((true, _), (_, true)) | ((_, true), (true, _)) => Self::NONNEGATIVE.neg(),
            _ => Self::UNKNOWN,
        }
    }

    fn reciprocal(&self) -> Self {
        if self.is_nonpositive() && !self.is_nonnegative() {
            return self.neg().reciprocal().neg();
        }
        if !self.is_nonnegative() {
            return Self::UNKNOWN;
        }
        let of = |x: &Option<Rational>| x.as_ref().and_then(Rational::recip);
        Self { low: Some(of(&self.high).unwrap_or(Rational::ZERO)), high: of(&self.low) }
    }
}

impl Builder {
    /// The values, of which some are proved to be nonnegative: of these the ones that rounding could make negative are cut
    /// off at 0.
    pub(super) fn cut_off(&mut self, values: Vec<Ref>, nonnegative: &[bool]) -> Vec<Ref> {
        if !nonnegative.contains(&true) {
            return values;
        }
        let intervals = self.intervals();
        let values = values.into_iter().enumerate();
        values
            .map(|(k, value)| {
                let is_proved = nonnegative.get(k) == Some(&true);
                if is_proved && !intervals[value.position()].is_nonnegative() {
                    self.push(Node::CutOff(value))
                } else {
                    value
                }
            })
            .listed()
    }

    /// What each node lies between.
    fn intervals(&self) -> Vec<Interval> {
        let mut all: Vec<Interval> = Vec::new();
        for k in 0..self.len() {
            let interval = self.interval(Ref(k), &all);
            all.push(interval);
        }
        all
    }

    fn interval(&self, at: Ref, known: &[Interval]) -> Interval {
        let of = |at: &Ref| &known[at.position()];
        match self.node(at) {
            // Those of a simplex, or on a chart; the parameter of an interval stands in units only.
            Node::Input(Input::Coordinate(_)) | Node::CutOff(_) | Node::InversePowerOfTwo(_) => {
                Interval::NONNEGATIVE
            }
            Node::Input(_)
                if self.variables.iter().any(|v| {
                    [v.complement, v.rise].iter().flatten().any(|c| c.position() == at.position())
                }) =>
            {
                Interval::NONNEGATIVE
            }
            // The ends are rounded as well, or the value is computed.
            Node::Input(_) => {
                self.parameter(at).map_or(Interval::UNKNOWN, |v| Interval::of(&v.range).widened())
            }
            Node::Number(value) => Interval::number(value),
            Node::Neg(a) => of(a).neg(),
            Node::Sum(a, b) => self.offset_by(*a, *b, false).unwrap_or_else(|| of(a).sum(of(b)).widened()),
            Node::Difference(a, b) => {
                self.offset_by(*a, *b, true).unwrap_or_else(|| of(a).sum(&of(b).neg()).widened())
            }
            Node::Product(a, b) if a.position() == b.position() => Interval::NONNEGATIVE,
            Node::Product(a, b) => of(a).product(of(b)).widened(),
            Node::Reciprocal(a) => of(a).reciprocal().widened(),
            Node::Quotient(a, b) => of(a).product(&of(b).reciprocal().widened()).widened(),
            Node::Part(whole, k) => match self.node(*whole) {
                Node::List(all) => of(&all[*k]).clone(),
                _ => Interval { low: Some(Rational::ZERO), high: Some(Rational::ONE) }.widened(),
            },
            Node::Bernstein { coefficients, .. }
            | Node::SimplexSum { coefficients, .. }
            | Node::BoxSum { coefficients, .. } => {
                if coefficients.iter().all(|c| of(c).is_nonnegative()) {
                    Interval::NONNEGATIVE
                } else if coefficients.iter().all(|c| of(c).is_nonpositive()) {
                    Interval::NONNEGATIVE.neg()
                } else {
                    Interval::UNKNOWN
                }
            }
            Node::Unit { .. } | Node::List(_) | Node::Combine { .. } => Interval::UNKNOWN,
        }
    }

    /// λ + c or c − λ for a shape value λ that is given and a number c: as λ was compared with the ends of its range as
    /// floats, this has the sign of the exact sum where that has only one.
    fn offset_by(&self, a: Ref, b: Ref, minus: bool) -> Option<Interval> {
        let given = |at: Ref| self.parameter(at).filter(|v| v.is_given).map(|v| Interval::of(&v.range));
        let exact = |c: &Rational| Interval { low: Some(c.clone()), high: Some(c.clone()) };
        let sum = match (self.node(a), self.node(b)) {
            (Node::Number(c), _) if minus => exact(c).sum(&given(b)?.neg()),
            (Node::Number(c), _) => exact(c).sum(&given(b)?),
            (_, Node::Number(c)) if minus => exact(c).neg().sum(&given(a)?),
            (_, Node::Number(c)) => exact(c).sum(&given(a)?),
            _ => return None,
        };
        (sum.is_nonnegative() || sum.is_nonpositive()).then(|| sum.widened())
    }

    /// The shape parameter that an input is.
    fn parameter(&self, at: Ref) -> Option<&Variable> {
        self.variables.iter().find(|v| v.value.position() == at.position())
    }
}

impl Plan {
    /// Which outputs are cut off at 0.
    pub(crate) fn cut_off(&self) -> Vec<bool> {
        let mut all = Vec::new();
        for output in &self.outputs {
            match &self.nodes[output.position()] {
                Node::List(list) => all.extend(list.iter().map(|entry| self.is_cut_off(*entry))),
                _ => all.push(self.is_cut_off(*output)),
            }
        }
        all
    }

    fn is_cut_off(&self, at: Ref) -> bool {
        matches!(self.nodes[at.position()], Node::CutOff(_))
    }
}
