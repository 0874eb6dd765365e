//! The control points next to an end of a curve, from its derivatives there.

use super::{Builder, Input, Node, Plan, Ref};
use crate::algebra::poly::Poly;
use crate::continuation::EndPoints;
use crate::model::Family;

/// The determined points as combinations of the derivatives and of the other control points, in the order of their
/// positions in `points`; after them the values of the `divisors`, polynomials in the shape values without whose zeros
/// the points are determined.
pub fn end_points(family: &Family, points: &EndPoints, divisors: &[Poly]) -> Plan {
    let mut builder = Builder::of(family);
    let mut outputs = Vec::new();
    for (inverse, others) in points.inverse.iter().zip(&points.others) {
        let derivatives = inverse.iter().enumerate().filter(|(_, weight)| !weight.is_zero());
        let derivatives = derivatives.map(|(k, weight)| (Input::Derivative(k), weight));
        let others = others.iter().map(|(k, weight)| (Input::Point(*k), weight));
        let (mut points, mut weights): (Vec<Ref>, Vec<Ref>) = (Vec::new(), Vec::new());
        for (input, weight) in derivatives.chain(others) {
            points.push(builder.input(input));
            weights.push(builder.quotient(weight.numer(), weight.denom()));
        }
        outputs.push(builder.combination(points, weights));
    }
    for divisor in divisors {
        outputs.push(builder.scalar(divisor));
    }
    builder.finish(outputs)
}

impl Builder {
    /// Σ weight·point; the point itself where it is the only one and has the weight 1.
    pub(super) fn combination(&mut self, points: Vec<Ref>, weights: Vec<Ref>) -> Ref {
        match (points.as_slice(), weights.as_slice()) {
            ([point], [weight]) if matches!(self.node(*weight), Node::Number(w) if w.is_one()) => *point,
            _ => self.push(Node::Combine { points, weights }),
        }
    }
}
