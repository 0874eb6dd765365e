//! Bounds for functions in which the domain variable stands beside its sine or exponential, which are evaluated as
//! polynomials whose coefficients are power series in a shape value.
//!
//! A value is Σ cⱼ Bⱼ in Bernstein form, or xⁱsʲ S Σ gⱼ Bⱼ with a factor S such as the reciprocal of a denominator, cⱼ
//! = gⱼS; both are functions of shape values only. For these there are statements in shape values alone: μ ≤ |cⱼ| ≤ Λ,
//! and the error of the coefficients is at most E u, that of S at most ϱ u times S; file `majorant`.
//!
//! The sum is computed in the smaller coordinate y ≤ 1/2 by T := T − T y + tⱼ, tⱼ = cⱼ binomial(n, j) yʲ, where what
//! the addition loses is kept in a second number, so that only the other roundings count. A local error goes on with
//! the factor (1 − y)ⁿ⁻ʲ, with which |tⱼ| becomes |cⱼ|Bⱼ and |T y| at most y/(1 − y)·Λ Σ_{i < j} Bᵢ; the sums of these
//! over j are at most Λ and n y Λ, and that of j|tⱼ| is at most n y Λ. There are j + 1 roundings in tⱼ, one in T y, one
//! in the difference, one where the lost part is found, each at most the difference, and one at the end. To first order
//! that is
//!
//! (n y + 1) + n y + 2(1 + n y) + 1 = 4 n y + 4.
//!
//! Where all cⱼ that are not 0 have one sign, the sums are at most n times the value, which makes 4 n + 4 and n w of
//! these, relative to it, and coefficients that are off relatively count so.
//!
//! What is of higher order is a multiple of n²u with a factor below 50, and n w u of a coordinate that is off by w u,
//! of which the first order is n w y max|cᵢ − cⱼ|: both are less than 1 for n ≤ 64 and n w ≤ 512. That is counted by
//! hand, as are the coordinates in file `angles`; `engine/tests/proofs/rounding_of_sines.rs` looks for larger errors.
//!
//! What the quotient P/Q of polynomials differs from the function A/B by comes to this, with |A − P| ≤ a·e, e = yⁱ(1 −
//! y)ʲ, |B − Q| ≤ b, |Q| ≥ q and |P/Q| ≤ Λ·e: at most τ·e, τ = (a + Λb)/(q − b), as P/Q − A/B = ((P − A) + (B −
//! Q)·P/Q)/B. The numbers a and b are found by arithmetic outside of the kernel ([`Truncation`]). They count for floats
//! of 64 bits, u = 2⁻⁵³; for shorter ones they are fewer u.

use super::angles::{inputs, off};
use super::cell::Cell;
use super::exact::Exact;
use super::majorant::{Known, Majorants, between, nearest};
use super::{Bound, Error, Inputs, Part, least_multiple, rest, rounded_up, with_share};
use crate::algebra::number::binomial;
use crate::algebra::poly::Poly;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::Kind;
use crate::model::{Family, Truncation};
use crate::plan::interval::form::{Factored, RationalForm};
use crate::plan::interval::{rational, table};
use crate::steps::{Steps, lower};
use basis_prover::collections::list::{Listed, Mapped};
use std::rc::Rc;

/// The highest degree for which the roundings of a sum are counted.
const MOST_TERMS: i64 = 64;

/// Whether polynomials are evaluated in place of the functions of a family.
pub(super) fn is_series(family: &Family) -> bool {
    family.pieces.iter().any(|piece| piece.truncations.is_some())
}

/// Bounds of the errors of the values of all functions; `None` for one without.
pub(super) fn values(family: &Family) -> Option<Vec<Option<Bound>>> {
    let forms = RationalForm::of_family(family)?;
    basis_prover::working(family.budget, &mut |work| {
        let count = family.functions.len();
        let mut bounds = Vec::new();
        for k in 0..count {
            let left = u64::try_from(count - k).unwrap_or(u64::MAX);
            let share = work.left() / left;
            bounds.push(with_share(work, share, &mut |work| of_function(family, &forms, k, work)));
        }
        Some(bounds)
    })
}

/// The errors in u of a function on a span: relative, if there is such a bound, and absolute.
struct Errors {
    relative: Option<Rational>,
    absolute: Rational,
}

/// The bound of a function on all spans, relative if there is one on each.
fn of_function(family: &Family, forms: &[RationalForm], function: usize, work: &mut Work) -> Option<Bound> {
    let mut parts = Vec::new();
    let (mut absolute, mut relative) = (Rational::ZERO, Some(Rational::ZERO));
    for (piece, form) in family.pieces.iter().zip(forms) {
        let errors = on_span(piece, form, function, &mut parts, work)?;
        absolute = absolute.max(errors.absolute);
        relative = relative.zip(errors.relative).map(|(a, b)| a.max(b));
    }
    let bound = match relative {
        Some(relative) => rounded_up(Vec::new(), Error::Relative, &relative),
        None => rounded_up(Vec::new(), Error::Absolute, &absolute),
    };
    Some(Bound { cells: parts, ..bound })
}

fn on_span(
    piece: &Family,
    form: &RationalForm,
    function: usize,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Errors> {
    let truncation = piece.truncations.as_ref()?.get(function)?.as_ref()?;
    let own = &form.numerators.functions[function];
    if own.bernstein.iter().all(Poly::is_zero) {
        return Some(Errors { relative: Some(Rational::ZERO), absolute: Rational::ZERO });
    }
    let Factored { square, inner, content, .. } = &own.factored;
    let one = Poly::one();
    let (steps, is_factored) = if form.is_tabulated {
        let mut steps = lower(&rational::numerators(piece, form));
        let count = form.numerators.len();
        steps.outputs = steps.outputs.into_iter().skip(function).step_by(count).listed();
        (steps, false)
    } else if square.is_empty() {
        let mut row = inner.mapped(|p| (p, &one));
        row.push((&one, &own.denom));
        (lower(&table(piece, vec![row])), true)
    } else {
        return None;
    };
    let coordinates = off(piece, form, &steps)?;
    let inputs = with_ranges(piece, inputs(piece, &steps, &coordinates, Range::unit(), 0)?);
    let cells = Cell::grid(&inputs.region, &[]);
    let mut stage = Stage::new(&steps, &inputs, &cells)?;
    let plain = [one.clone(), one.clone()];
    let mut places = steps.outputs.clone();
    // How far the factors are off, and what they are.
    let (mut scale, mut of_factors) = (plain.clone(), Rational::ZERO);
    if is_factored {
        let factor = places.pop()?;
        let (known, value) = Known::relative(&mut stage.exact, factor, &mut stage.cells, work)?;
        of_factors = known.error;
        scale = [value[0].scale(content), value[1].clone()];
    }
    let mut all = Vec::new();
    for k in &places {
        all.push(Known::of(&mut stage.exact, *k, &scale, &mut stage.cells, work)?);
    }
    let divisor = stage.divisor(piece, truncation, work)?;
    for Majorants { conditions, of_steps, .. } in &stage.cells {
        parts.push(only(conditions.cell, [&conditions.known[..], &of_steps[..]].concat()));
    }
    let sum = Sum::of(&all, &coordinates)?;
    let missing = |size: &Rational| {
        let missing = &truncation.above + &(size * &truncation.below);
        Some(&missing.checked_div(&divisor)? * &Rational::from(1_i64 << 53))
    };
    if !is_factored {
        // Powers of the coordinates are factors of the function, but not of what is computed.
        let absolute = &sum.error + &missing(&sum.most)?;
        let [i, j] = truncation.ends.map(|power| power as usize);
        let inside = i..own.bernstein.len().saturating_sub(j);
        let is_there = |k: usize| own.bernstein[k].is_zero() != inside.contains(&k);
        let relative = if (0..own.bernstein.len()).all(is_there) {
            all.get(inside).and_then(|inside| Sum::relative_to_each(inside, all.len(), &coordinates))
        } else {
            None
        };
        // cⱼBⱼ is e times a term of the Bernstein form of lower degree with this coefficient, and e at most the sum of
        // all Bⱼ there.
        let (n, [i, j]) = (form.numerators.degree, truncation.ends);
        let mut grown = Rational::ONE;
        for k in 0..=n.saturating_sub(i + j) {
            let factor = binomial(n, k + i).checked_div(&binomial(n.saturating_sub(i + j), k))?;
            grown = grown.max(factor);
        }
        let relative = relative.and_then(|(relative, least)| {
            Some(&relative + &missing(&(&sum.most * &grown))?.checked_div(&least)?)
        });
        return Some(Errors { relative, absolute });
    }
    // The powers, with that of each coordinate, and at most six products: of the number, the reciprocal, the sum and
    // the powers.
    let Factored { x_power, s_power, .. } = own.factored;
    let mut others = &of_factors + &Rational::from(8);
    for (power, off) in [s_power, x_power].into_iter().zip(&coordinates) {
        others += &(&(off + &Rational::ONE) * &Rational::from(i64::from(power)));
    }
    let others = with_higher(&others)?;
    let missing = missing(&sum.most)?;
    let is_whole = truncation.ends == [x_power, s_power];
    let relative = sum.relative().filter(|_| is_whole).and_then(|relative| {
        let missing = missing.checked_div(&sum.least)?;
        Some(&with_higher(&(&relative + &others))? + &missing)
    });
    let absolute = &(&sum.error + &with_higher(&(&others * &sum.most))?) + &missing;
    Some(Errors { relative, absolute })
}

/// A number of u with what is of higher order: a product of factors that are off by S u in all is off by at most (1 + 3 S
/// u) S u.
fn with_higher(sum: &Rational) -> Option<Rational> {
    Some(sum + &rest::of_product(sum)?)
}

/// A sum in Bernstein form.
struct Sum {
    most: Rational,
    /// What its absolute value is at least.
    least: Rational,
    /// In u.
    error: Rational,
}

impl Sum {
    fn of(coefficients: &[Known], off: &[Rational; 2]) -> Option<Self> {
        let n = i64::try_from(coefficients.len().saturating_sub(1)).ok()?;
        let worse = off[0].clone().max(off[1].clone());
        let in_all = &worse * &Rational::from(n);
        if n > MOST_TERMS || in_all > Rational::from(512) {
            return None;
        }
        let (mut most, mut error) = (Rational::ZERO, Rational::ZERO);
        for known in coefficients {
            most = most.max(known.most.clone());
            error = error.max(known.error.clone());
        }
        let signs = coefficients.mapped(|known| known.least.clone());
        let least = nearest(&signs);
        // Coefficients of one sign differ by less than the largest.
        let spread = if least.is_zero() { &most * &Rational::from(2) } else { most.clone() };
        let largest = &most + &(&error * &rest::unit());
        // y ≤ 1/2 + 2⁻¹⁰
        let half = &Rational::new(1, 2) + &Rational::new(1, 1 << 10);
        let roundings = match n {
            0 => Rational::ZERO,
            // s c₀ + x c₁: of each three roundings, and both coordinates.
            1 => &Rational::from(4) + &worse,
            _ => &(&Rational::from(4 * n) * &half) + &Rational::from(6),
        };
        let of_place = if n < 2 { Rational::ZERO } else { &(&in_all * &half) * &spread };
        let error = &(&(&roundings * &largest) + &error) + &of_place;
        Some(Self { most, least: least.abs(), error })
    }

    /// The relative error in u where the coefficients that are not 0 have one sign and are off by a multiple of
    /// themselves, and the smallest of them, of as many coefficients in all.
    fn relative_to_each(
        coefficients: &[Known],
        all: usize,
        off: &[Rational; 2],
    ) -> Option<(Rational, Rational)> {
        let n = Rational::from(i64::try_from(all.saturating_sub(1)).ok()?);
        let worse = off[0].clone().max(off[1].clone());
        let signs = coefficients.mapped(|known| known.least.clone());
        let least = nearest(&signs).abs();
        let mut of_coefficients = Rational::ZERO;
        for known in coefficients {
            of_coefficients = of_coefficients.max(known.error.checked_div(&known.least.abs())?);
        }
        let roundings = &(&n * &Rational::from(4)) + &Rational::from(6);
        let relative = &(&roundings + &of_coefficients) + &(&n * &worse);
        (!least.is_zero()).then_some((relative, least))
    }

    fn relative(&self) -> Option<Rational> {
        self.error.checked_div(&self.least)
    }
}

/// The inputs with the ranges of shape parameters themselves, where those of their tangents were.
fn with_ranges(piece: &Family, mut inputs: Inputs) -> Inputs {
    for (var, range) in &mut inputs.region.ranges {
        let Some(angle) = piece.analytic.angle(*var).filter(|angle| angle.kind == Kind::Linear) else {
            continue;
        };
        let number = |k: usize| piece.analytic.number(&angle.limits[k]).filter(|_| !angle.ends[k].is_empty());
        if let [Some(low), Some(high)] = [0, 1].map(number) {
            // Numbers such as π are known by many digits only, and few make short proofs.
            let part = 64;
            *range = Range::closed(-&least_multiple(&-&low, part), least_multiple(&high, part));
        }
    }
    inputs
}

/// What is known of numbers that depend on shape values only.
struct Stage<'a> {
    exact: Exact<'a>,
    cells: Vec<Majorants<'a>>,
}

impl<'a> Stage<'a> {
    fn new(steps: &'a Steps, inputs: &Inputs, cells: &'a [Cell]) -> Option<Self> {
        let mut all = Vec::new();
        for cell in cells {
            all.push(Majorants::new(cell, steps.steps.len()));
        }
        Some(Self { exact: Exact::new(steps, inputs)?, cells: all })
    }

    /// A number that |B| is at least.
    fn divisor(&mut self, piece: &Family, truncation: &Truncation, work: &mut Work) -> Option<Rational> {
        let mut divisor = truncation.divisor.clone();
        for angle in piece.analytic.angles.iter().filter(|angle| angle.kind == Kind::Linear) {
            divisor = divisor.substitute(angle.itself, &Poly::var(angle.var));
        }
        let mut all = Vec::new();
        for cell in &mut self.cells {
            all.push(between(&[divisor.clone(), Poly::one()], &mut cell.conditions, work)?.1);
        }
        let left = &nearest(&all).abs() - &truncation.below;
        left.is_positive().then_some(left)
    }
}

/// Conditions without a bound.
fn only(cell: &Cell, conditions: Vec<Poly>) -> Part {
    Part {
        domain: Rc::clone(&cell.domain),
        conditions,
        value: Poly::zero(),
        sums: Vec::new(),
        rest: Rational::ZERO,
        own: Some(Rational::ZERO),
    }
}
