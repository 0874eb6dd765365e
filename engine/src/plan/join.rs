//! The control points that a join determines.

use super::{Builder, Input, Plan};
use crate::model::Parameter;
use crate::theorem::{Form, Unit};

/// The points as combinations of the given ones: `scalars` are the shape values of the plan, and the points of the
/// theorem in the list `used` its control points, both by their positions in these lists.
pub fn determined<'a>(
    scalars: &[&Parameter],
    used: &[usize],
    points: impl Iterator<Item = &'a Form>,
) -> Plan {
    let mut builder = Builder::default();
    for (k, scalar) in scalars.iter().enumerate() {
        builder.variable(k, scalar);
    }
    let mut outputs = Vec::new();
    for form in points {
        let (mut points, mut weights) = (Vec::new(), Vec::new());
        for (unit, weight) in &form.terms {
            let Unit::Point(point) = unit else { continue };
            let place = used.iter().position(|u| u == point).unwrap_or(0);
            points.push(builder.input(Input::Point(place)));
            weights.push(builder.quotient(weight.numer(), weight.denom()));
        }
        outputs.push(builder.combination(points, weights));
    }
    builder.finish(outputs)
}
