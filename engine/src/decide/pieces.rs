//! A box without some flats, as boxes.

use super::independence::Values;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::collections::sort::sort_by;

/// The parts of a box in which no point has all values of one of the exceptions; none of them empty.
pub(super) fn pieces(region: &Region, except: &[Values]) -> Vec<Region> {
    let mut parts: Vec<Region> = Vec::new();
    if !region.ranges.iter().any(|(_, r)| r.is_empty()) {
        parts.push(region.clone());
    }
    for values in except {
        parts = parts.iter().flat_map(|part| without(part, values)).collect();
    }
    parts
}

/// A box without the points that have all of the given values.
fn without(region: &Region, values: &[(Var, Rational)]) -> Vec<Region> {
    if values.iter().any(|(v, x)| !region.range(*v).contains(x)) {
        return vec![region.clone()];
    }
    // Below and above the first value; and at the first value, below and above the second; and so on.
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
pub(super) fn with(region: &Region, var: Var, range: Range) -> Region {
    let mut result = region.clone();
    result.ranges.retain(|(v, _)| *v != var);
    result.ranges.push((var, range));
    sort_by(&mut result.ranges, |a, b| a.0.cmp(&b.0));
    result
}
