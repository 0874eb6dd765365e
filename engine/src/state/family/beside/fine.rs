//! A domain in many short cells, in each of which the variable is measured from the lower end of the cell.
//!
//! Next to that two terms of a continued fraction are as good as nine are from an end of the domain, and the polynomials are of low
//! degree: this is for functions with a highest or lowest value inside, such as t·exp(−t) ≤ 37/100. They are polynomials in the
//! tangent itself, which runs between short fractions.

use super::{Step, values};
use crate::algebra::fraction::Fraction;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::enclosure::{Anchor, UNIT, inverse};
use crate::model::angle::{Angle, Kind};

/// The level of the bounds by which the ends of cells are chosen.
const LEVEL: u32 = 6;

/// The cells of a domain whose ends are numbers, about equally long in the variable itself; `None` where its ends depend on parameters.
pub(super) fn cells(
    family: &Family,
    angle: &Angle,
    range: &Range,
    count: u32,
    whole: &Step,
) -> Option<Vec<Step>> {
    if angle.kind == Kind::Linear {
        return None;
    }
    let value = super::by_the_tangent(angle, &whole.value)?;
    let (low, high) = range.finite()?;
    let end = |y: &Rational, up: bool| {
        let x = angle.tangent().substitute(angle.var, &Fraction::constant(y.clone()))?;
        let unit = Rational::from(UNIT);
        let parts = &values::bound(family, &x, up)? * &unit;
        if up { (-(-parts).floor()).to_i64() } else { parts.floor().to_i64() }
    };
    let (low, high) = (end(low, false)?, end(high, true)?);
    let itself = |parts: i64| Some(inverse(angle.kind, &Rational::new(parts, UNIT), LEVEL)?.0);
    let between = [itself(low)?, itself(high)?];
    let length = &between[1] - &between[0];
    let mut ends = vec![low];
    for k in 1..count {
        let wanted = &between[0] + &(&length * &Rational::new(i64::from(k), i64::from(count)));
        let (mut below, mut above) = (low, high);
        while above - below > 1 {
            let middle = below + (above - below) / 2;
            if itself(middle)? < wanted { below = middle } else { above = middle }
        }
        if ends.last().is_some_and(|last| *last < below) {
            ends.push(below);
        }
    }
    ends.push(high);
    let mut cells = Vec::new();
    for (k, pair) in ends.windows(2).enumerate() {
        let [from, to] = pair else { continue };
        let [low, high] = [from, to].map(|parts| Rational::new(*parts, UNIT));
        let of = format!("{} [cell {} of {}]", whole.of, k + 1, ends.len() - 1);
        let ranges = vec![(angle.var, Range::closed(low, high))];
        cells.push(Step { of, ranges, value: value.clone(), anchor: Anchor::At(*from), ..whole.clone() });
    }
    Some(cells)
}
