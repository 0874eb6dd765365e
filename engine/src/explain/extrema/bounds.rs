//! Proved bounds of the least value of a function whose stationary points are out of reach.

use super::domain::{Product, at};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use basis_kernel::Relation;

/// The steps of the lattice on which the search begins, and how often its steps are halved.
const STEPS: i64 = 8;
const HALVINGS: u32 = 12;
/// The work for one bound.
const WORK: u64 = 1_000_000;

/// Numbers with few digits between which the least value of numer/denom lies, denom > 0: above it is a value, below
/// it is proved that there is none.
pub(super) fn least(domain: &Product, numer: &Poly, denom: &Poly) -> Option<(Rational, Rational)> {
    let value = |point: &[(Var, Rational)]| at(numer, point)?.checked_div(&at(denom, point)?);
    let mut best: Option<(Rational, Vec<(Var, Rational)>)> = None;
    for point in domain.lattice(STEPS) {
        let Some(x) = value(&point) else { continue };
        if best.as_ref().is_none_or(|(known, _)| &x < known) {
            best = Some((x, point));
        }
    }
    let (mut least, mut point) = best?;
    let mut step = Rational::new(1, 2 * STEPS);
    for _ in 0..HALVINGS {
        let mut moved = true;
        while moved {
            moved = false;
            for (k, (_, side)) in domain.sides().iter().enumerate() {
                for sign in [1, -1] {
                    let mut next = point.clone();
                    next[k].1 += &(&(&step * side) * &Rational::from(sign));
                    if !domain.has(&next) {
                        continue;
                    }
                    let Some(x) = value(&next) else { continue };
                    if x < least {
                        (least, point, moved) = (x, next, true);
                    }
                }
            }
        }
        step = &step * &Rational::new(1, 2);
    }
    // A little below, with as few digits as there are.
    for digits in [6, 4, 3, 2] {
        let unit = Rational::from(10_i64.pow(digits));
        let down = |x: &Rational| (x * &unit).floor().checked_div(&unit);
        let (high, low) = (-down(&-&least)?, down(&(&least - &unit.recip()?))?);
        let above = numer - &denom.scale(&low);
        if domain.decide(above.into(), Relation::NonNegative, WORK).is_ok() {
            return Some((low, high));
        }
    }
    None
}
