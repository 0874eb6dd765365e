//! The control points that a join determines.

use super::{Builder, Input, Plan};
use crate::model::Parameter;
use crate::theorem::{Form, Origin, Patch, Theorem, Unit};
use basis_prover::collections::list::Listed;

/// A patch with the points that are determined, by their indices.
pub type Determined<'a> = (&'a Patch, Vec<(&'a [i64], &'a Form)>);

/// What a join determines.
pub fn determined(theorem: &Theorem) -> Vec<Determined<'_>> {
    let mut all = Vec::new();
    for patch in &theorem.patches {
        let points = patch.points.iter().filter(|p| p.origin == Origin::Determined);
        let points = points.map(|p| (p.index.as_slice(), &p.value)).listed();
        if !points.is_empty() {
            all.push((patch, points));
        }
    }
    all
}

/// The given points that determined ones depend on, by their positions in the theorem.
pub fn used(theorem: &Theorem, determined: &[Determined<'_>]) -> Vec<usize> {
    let uses = |k: usize| {
        let mut forms = determined.iter().flat_map(|(_, points)| points);
        forms.any(|(_, form)| form.terms.contains_key(&Unit::Point(k)))
    };
    (0..theorem.points.len()).filter(|k| uses(*k)).listed()
}

/// The points as combinations of the given ones: `scalars` are the shape values of the plan, and the points of the
/// theorem in the list `used` its control points, both by their positions in these lists.
pub fn points<'a>(scalars: &[&Parameter], used: &[usize], points: impl Iterator<Item = &'a Form>) -> Plan {
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
