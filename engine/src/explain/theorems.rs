//! What a theorem or join determines, as formulas.

use crate::model::label;
use crate::theorem::{Origin, Theorem, Unit};
use crate::weights::combination;

/// The control points that `let` determines, such as `Q[0]` and `P[2]`, in terms of given points, or by their
/// coordinates.
pub fn determined_points(theorem: &Theorem) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for patch in &theorem.patches {
        for point in patch.points.iter().filter(|point| point.origin == Origin::Determined) {
            let terms = point.value.terms.iter().filter_map(|(unit, weight)| match unit {
                Unit::Point(p) => Some((theorem.points.get(*p)?.name.as_str(), weight)),
                Unit::Pair(..) => None,
            });
            let formula = match theorem.dimension {
                None => combination(terms, &theorem.names),
                Some(dimension) => {
                    let coordinate = |k| point.value.coefficient(Unit::Point(k)).display(&theorem.names);
                    format!("({})", (0..dimension).map(coordinate).collect::<Vec<_>>().join(", "))
                }
            };
            all.push((label(&patch.name, &point.index), formula));
        }
    }
    all
}
