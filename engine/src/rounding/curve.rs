//! Bounds of the errors of points of curves over quotients, over functions on several spans, and over those with angles
//! or exponentials.
//!
//! Emitted code and the runtime compute such a point in two orders, and the runtime has the points at the ends of a
//! span from the values of the functions there. A bound is one of all of these, on all spans.

use super::angles::OnCoordinates;
use super::series::{self, is_series};
use super::{Bound, Error, Inputs, Parts, of_points, rounded_up};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::plan::evaluated::is_evaluated;
use crate::plan::interval::form::RationalForm;
use crate::steps::point::{Association, at_end, of_curve};

/// The most control points of which all choices of signs are tried.
const MOST_SIGNED: usize = 5;

/// The bound in ε, relative to the largest |Pₖ|; `None` when nothing is found or the work is spent.
pub(super) fn point(family: &Family) -> Option<Bound> {
    if !is_evaluated(family) {
        return None;
    }
    if is_series(family) {
        return series::point(family);
    }
    let forms = RationalForm::of_family(family)?;
    let mut computations = Vec::new();
    for (k, form) in forms.iter().enumerate() {
        let own = family.pieces.get(k).map_or(family, |piece| &**piece);
        for association in [Association::Steps, Association::Runtime] {
            computations.push(if own.analytic.is_empty() {
                let steps = of_curve(own, form, association);
                OnCoordinates { steps, inputs: Inputs::of(own, own.functions.len()) }
            } else {
                OnCoordinates::of_point(own, form, association)?
            });
        }
        for is_upper in [false, true] {
            let steps = at_end(own, form, is_upper);
            computations.push(if own.analytic.is_empty() {
                OnCoordinates { steps, inputs: Inputs::of(own, own.functions.len()) }
            } else {
                OnCoordinates::of(steps, own, form, own.functions.len())?
            });
        }
    }
    basis_prover::working(family.budget, &mut |work| {
        let mut parts = Parts::new();
        let count = computations.len();
        for (k, computation) in computations.iter().enumerate() {
            let left = u64::try_from(count - k).unwrap_or(u64::MAX);
            let OnCoordinates { steps, inputs } = computation;
            parts.extend(of_points(steps, inputs, MOST_SIGNED, work.left() / left, work)?);
        }
        Some(rounded_up(parts, Error::Absolute, &Rational::ZERO))
    })
}
