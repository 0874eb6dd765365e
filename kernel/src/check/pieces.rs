//! A box without some flats, as boxes.
//!
//! **Theorem.** The points of a box that do not have all of the values x₁ = c₁, …, xₖ = cₖ are those with x₁ < c₁ or
//! x₁ > c₁, those with x₁ = c₁ and x₂ < c₂ or x₂ > c₂, and so on: at most 2k boxes.

use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::collections::sort::sort_by;
use crate::statement::Values;

/// The parts of a box in which no point has all values of one of the exceptions, none of them empty; `None` when there
/// are more than `most`.
pub fn pieces(region: &Region, except: &[Values], most: usize) -> Option<Vec<Region>> {
    let mut parts: Vec<Region> = Vec::new();
    if !region.ranges.iter().any(|(_, r)| r.is_empty()) {
        parts.push(region.clone());
    }
    for values in except {
        let mut cut = Vec::new();
        for part in &parts {
            cut.extend(without(part, values));
        }
        parts = cut;
        if parts.len() > most {
            return None;
        }
    }
    Some(parts)
}

/// A box without the points that have all of the given values.
fn without(region: &Region, values: &[(Var, Rational)]) -> Vec<Region> {
    if values.iter().any(|(v, x)| !region.range(*v).contains(x)) {
        return vec![region.clone()];
    }
    let mut rest = region.clone();
    let mut parts = Vec::new();
    for (var, x) in values {
        let range = rest.range(*var);
        let below = Range { low: range.low.clone(), high: End::Excluded(x.clone()) };
        let above = Range { low: End::Excluded(x.clone()), high: range.high };
        parts.extend([below, above].into_iter().filter(|r| !r.is_empty()).map(|r| with(&rest, *var, r)));
        rest = with(&rest, *var, Range::closed(x.clone(), x.clone()));
    }
    parts
}

/// The box with another range of one variable.
pub fn with(region: &Region, var: Var, range: Range) -> Region {
    let mut result = region.clone();
    result.ranges.retain(|(v, _)| *v != var);
    result.ranges.push((var, range));
    sort_by(&mut result.ranges, |a, b| a.0.cmp(&b.0));
    result
}
