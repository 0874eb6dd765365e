//! Bounds for functions in which the domain variable stands beside its sine or exponential, which are evaluated as
//! polynomials whose coefficients are numbers or power series in a shape value.
//!
//! A value is Σ cⱼ Bⱼ in Bernstein form, or xⁱsʲ S Σ gⱼ Bⱼ with a factor S such as the reciprocal of a denominator, cⱼ
//! = gⱼS; both are functions of shape values only. On each of a few parts of their ranges there are statements in shape
//! values alone: μ ≤ cⱼ ≤ Λ, and the error of the coefficients is at most E u, that of S at most ϱ u times S; file
//! `majorant`. With these numbers a value is at least a polynomial in the smaller coordinate and its error at most
//! another one (file `sum`), so that there are statements in this coordinate alone: κ times the one is at least the
//! other.
//!
//! What the quotient P/Q of polynomials differs from the function A/B by comes to this, with |A − P| ≤ a·e, e = yⁱ(1 −
//! y)ʲ, |B − Q| ≤ b, |Q| ≥ q: at most (a·e + b·|P/Q|)/(q − b), as P/Q − A/B = ((P − A) + (B − Q)·P/Q)/B. The numbers a
//! and b are found by arithmetic outside of the kernel ([`Truncation`]). They count for floats of 64 bits, u = 2⁻⁵³;
//! for shorter ones they are fewer u.
//!
//! A point of a curve is a sum in both coordinates, whose coefficients are those of the functions times the control
//! points.

use super::angles::{inputs, off};
use super::cell::Cell;
use super::exact::Exact;
use super::majorant::{Known, Majorants, between};
use super::sum::{Sum, in_both, is_counted};
use super::{Bound, Error, Inputs, Part, least_multiple, rest, rounded_up, with_share};
use crate::algebra::number::binomial;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::angle::Kind;
use crate::model::{Family, Truncation};
use crate::plan::interval::form::{Factored, RationalForm};
use crate::plan::interval::{rational, table};
use crate::steps::{Steps, lower};
use basis_prover::collections::list::{Listed, Mapped};
use std::rc::Rc;

/// Into how many parts the range of a shape parameter is cut where there is enough work left.
const SHAPE_CELLS: u32 = 2;

/// Into how many parts that of a coordinate is.
const COORDINATE_CELLS: u32 = 1;

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
            bounds
                .push(on_finest(share, work, &mut |count, work| of_function(family, &forms, k, count, work)));
        }
        Some(bounds)
    })
}

/// Does something with a share of the work on the whole range of a shape parameter, and if that takes little of it, on
/// parts of the range.
fn on_finest<T>(share: u64, work: &mut Work, part: &mut dyn FnMut(u32, &mut Work) -> Option<T>) -> Option<T> {
    let before = work.left();
    let whole = with_share(work, share.min(before), &mut |work| part(1, work))?;
    let used = before - work.left();
    let left = share.saturating_sub(used);
    if left < 2 * u64::from(SHAPE_CELLS) * used {
        basis_prover::done_less_often();
        return Some(whole);
    }
    Some(with_share(work, left, &mut |work| part(SHAPE_CELLS, work)).unwrap_or(whole))
}

/// The bound of a function on all spans, relative if there is one on each.
fn of_function(
    family: &Family,
    forms: &[RationalForm],
    function: usize,
    count: u32,
    work: &mut Work,
) -> Option<Bound> {
    let (mut parts, mut all) = (Vec::new(), Vec::new());
    for (piece, form) in family.pieces.iter().zip(forms) {
        all.extend(on_span(piece, form, function, count, &mut parts, work)?);
    }
    for error in [Error::Relative, Error::Absolute] {
        let is_relative = matches!(error(Rational::ZERO), Error::Relative(_));
        let mut own = Vec::new();
        let errors = all.iter().map(|value| value.error(is_relative, &mut own, work));
        let Some(errors) = errors.collect::<Option<Vec<_>>>() else { continue };
        let most = errors.into_iter().max().unwrap_or(Rational::ZERO);
        parts.extend(own);
        return Some(Bound { cells: parts, ..rounded_up(Vec::new(), error, &most) });
    }
    None
}

/// A function on each part of the range of a shape parameter, on a span; nothing where it is 0.
fn on_span(
    piece: &Family,
    form: &RationalForm,
    function: usize,
    count: u32,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Vec<Value>> {
    let truncation = piece.truncations.as_ref()?.get(function)?.as_ref()?;
    if form.numerators.functions[function].bernstein.iter().all(Poly::is_zero) {
        return Some(Vec::new());
    }
    let (steps, factor) = coefficient_steps(piece, form, function)?;
    let coordinates = off(piece, form, &steps)?;
    let inputs = with_ranges(piece, inputs(piece, &steps, &coordinates, Range::unit(), 0)?);
    let cells = shape_cells(&inputs, count);
    let mut stage = Stage::new(&steps, &inputs, &cells)?;
    let mut all = Vec::new();
    for cell in 0..cells.len() {
        let value = Value::new(&mut stage, cell, truncation, factor, piece, work)?;
        let value = Value { y: *inputs.coordinates.first()?, off: coordinates.clone(), ..value };
        if !is_counted(value.coefficients.len().saturating_sub(1), &coordinates) {
            return None;
        }
        all.push(value);
    }
    parts.extend(stage.parts());
    Some(all)
}

/// The content of a function and the powers of x and s in it.
type Factor<'f> = (&'f Rational, [u32; 2]);

/// The coefficients of the sum of which a function is made, and where other factors come after it, the reciprocal of
/// its denominator as the last output.
fn coefficient_steps<'f>(
    piece: &Family,
    form: &'f RationalForm,
    function: usize,
) -> Option<(Steps, Option<Factor<'f>>)> {
    let own = &form.numerators.functions[function];
    let Factored { square, inner, content, x_power, s_power, .. } = &own.factored;
    if form.is_tabulated {
        let mut steps = lower(&rational::numerators(piece, form));
        let count = form.numerators.len();
        steps.outputs = steps.outputs.into_iter().skip(function).step_by(count).listed();
        return Some((steps, None));
    }
    let one = Poly::one();
    let mut row = inner.mapped(|p| (p, &one));
    row.push((&one, &own.denom));
    square.is_empty().then(|| (lower(&table(piece, vec![row])), Some((content, [*x_power, *s_power]))))
}

/// Parts of the ranges of shape parameters.
fn shape_cells(inputs: &Inputs, count: u32) -> Vec<Cell> {
    let count = if inputs.shapes.len() == 1 { count } else { 1 };
    Cell::grid(&inputs.region, &inputs.shapes.mapped(|shape| (*shape, count)))
}

/// A value on a part of the ranges of shape parameters.
struct Value {
    /// The smaller coordinate, and how many u both are off.
    y: Var,
    off: [Rational; 2],
    /// The coefficients of the sum.
    coefficients: Vec<Known>,
    /// The powers of x and s by which it is multiplied after it.
    powers: [u32; 2],
    /// How many u all other factors are off; `None` where the sum is the value.
    others: Option<Rational>,
    missing: Missing,
}

/// What a value differs by from that of the function, in u of floats of 64 bits.
struct Missing {
    /// This many times xⁱsʲ.
    of_ends: Rational,
    /// And this many times the value.
    of_size: Rational,
    ends: [u32; 2],
}

impl Missing {
    fn new(
        stage: &mut Stage<'_>,
        cell: usize,
        of: &Truncation,
        piece: &Family,
        work: &mut Work,
    ) -> Option<Self> {
        let unit = Rational::from(1_i64 << 53).checked_div(&stage.divisor(cell, piece, of, work)?)?;
        // With few digits.
        let most = |x: &Rational| least_multiple(&(x * &unit), 1 << 20);
        Some(Self { of_ends: most(&of.above), of_size: most(&of.below), ends: of.ends })
    }
}

impl Value {
    fn new(
        stage: &mut Stage<'_>,
        cell: usize,
        truncation: &Truncation,
        factor: Option<Factor<'_>>,
        piece: &Family,
        work: &mut Work,
    ) -> Option<Self> {
        let mut places = stage.outputs.clone();
        let (mut scale, mut others, mut powers) = ([Poly::one(), Poly::one()], None, [0, 0]);
        let cells = &mut stage.cells[cell..=cell];
        if let Some((content, own)) = factor {
            let last = places.pop()?;
            let (known, value) = Known::relative(&mut stage.exact, last, cells, work)?;
            // At most six products: of the number, the reciprocal, the sum and the powers.
            others = Some(&known.error + &Rational::from(8));
            scale = [value[0].scale(content), value[1].clone()];
            powers = own;
        }
        let coefficients = coefficients(stage, cell, &places, &scale, work)?;
        let missing = Missing::new(stage, cell, truncation, piece, work)?;
        let off = [Rational::ZERO, Rational::ZERO];
        Some(Self { y: Var(0), off, coefficients, powers, others, missing })
    }

    /// The error in u on this part, relative or absolute.
    fn error(&self, is_relative: bool, parts: &mut Vec<Part>, work: &mut Work) -> Option<Rational> {
        let (n, y, off) = (self.coefficients.len().saturating_sub(1), self.y, &self.off);
        let mut others = self.others.clone().unwrap_or(Rational::ZERO);
        if self.others.is_some() {
            for (power, off) in self.powers.iter().zip([&off[1], &off[0]]) {
                others += &(&(off + &Rational::ONE) * &Rational::from(i64::from(*power)));
            }
            others = with_higher(&others)?;
        }
        let all = self.coefficients.iter().listed();
        let reversed = all.iter().rev().copied().listed();
        // In each of both coordinates, or where the degree is small in one for all of the domain.
        let halves = if n < 2 {
            vec![(Sum::linear(&all, off), 1)]
        } else {
            vec![(Sum::in_smaller(&all, &off[1]), 1), (Sum::in_smaller(&reversed, &off[0]), 0)]
        };
        let mut most = Rational::ZERO;
        for (sum, coordinate) in halves {
            let [low, size, error] =
                [&sum.low, &sum.size, &sum.error].map(|coefficients| Sum::polynomial(coefficients, y));
            // xⁱsʲ
            let ends = |[i, j]: [u32; 2]| {
                let (own, other) = (Poly::var(y), &Poly::one() - &Poly::var(y));
                let [x, s] = if coordinate == 1 { [own, other] } else { [other, own] };
                &x.pow(i) * &s.pow(j)
            };
            let with_missing = &error + &size.scale(&self.missing.of_size);
            for cell in cells_of_coordinate(y, n < 2) {
                let found = if is_relative {
                    // Powers of the coordinates that the function has, but not what is computed, are factors of `low`.
                    let left = [0, 1].map(|k| self.missing.ends[k].checked_sub(self.powers[k]));
                    let [Some(i), Some(j)] = left else { return None };
                    let sum = &with_missing + &ends([i, j]).scale(&self.missing.of_ends);
                    let found = ratio(&cell, &sum, &low, parts, work)?;
                    if self.others.is_some() { with_higher(&(&found + &others))? } else { found }
                } else {
                    let grown = &Rational::ONE + &(&others * &rest::unit());
                    let whole = &with_missing.scale(&grown) + &size.scale(&others);
                    let missing = ends(self.missing.ends).scale(&self.missing.of_ends);
                    ratio(&cell, &(&(&whole * &ends(self.powers)) + &missing), &Poly::one(), parts, work)?
                };
                most = most.max(found);
            }
        }
        Some(most)
    }
}

/// The least number of 256ths that times q is at least p on a cell, and what it follows from.
fn ratio(cell: &Cell, p: &Poly, q: &Poly, parts: &mut Vec<Part>, work: &mut Work) -> Option<Rational> {
    let bound = least_multiple(&cell.ratio(p, q, work)?, 256);
    parts.push(Part {
        value: q.clone(),
        sums: vec![p.clone()],
        own: Some(bound.clone()),
        ..only(cell, Vec::new())
    });
    Some(bound)
}

/// Parts of the range of a coordinate, or of that of the smaller one of both.
fn cells_of_coordinate(y: Var, is_whole: bool) -> Vec<Cell> {
    let half = &Rational::new(1, 2) + &Rational::new(1, 1 << 10);
    let range = Range::closed(Rational::ZERO, if is_whole { Rational::ONE } else { half });
    Cell::grid(&Region { ranges: vec![(y, range)] }, &[(y, COORDINATE_CELLS)])
}

/// What is known of coefficients of a sum in Bernstein form that are steps times a factor.
fn coefficients(
    stage: &mut Stage<'_>,
    cell: usize,
    places: &[usize],
    scale: &[Poly; 2],
    work: &mut Work,
) -> Option<Vec<Known>> {
    let n = places.len().saturating_sub(1) as u32;
    let mut all = Vec::new();
    for (j, place) in (0..).zip(places) {
        // What numbers are known by counts in the middle of a sum as at its ends.
        let factor = binomial(n, j);
        let scale = [scale[0].scale(&factor), scale[1].clone()];
        let known = Known::of(&mut stage.exact, *place, &scale, &mut stage.cells[cell..=cell], work)?;
        all.push(known.scaled(&factor.recip()?).shortened());
    }
    Some(all)
}

/// A number of u with what is of higher order: a product of factors that are off by S u in all is off by at most (1 + 3
/// S u) S u.
fn with_higher(sum: &Rational) -> Option<Rational> {
    Some(sum + &rest::of_product(sum)?)
}

/// The bound in ε of a point of a curve, in the orders in which it is computed somewhere, relative to the largest |Pₖ|.
pub(super) fn point(family: &Family) -> Option<Bound> {
    let forms = RationalForm::of_family(family)?;
    basis_prover::working(family.budget, &mut |work| {
        let of_point = &mut |count: u32, work: &mut Work| {
            let mut parts = Vec::new();
            let mut most = Rational::ZERO;
            for (piece, form) in family.pieces.iter().zip(&forms) {
                most = most.max(point_on_span(piece, form, count, &mut parts, work)?);
                if !form.is_tabulated {
                    most = most.max(point_at_ends(piece, form, count, &mut parts, work)?);
                }
            }
            let bound = rounded_up(Vec::new(), Error::Absolute, &most);
            Some(Bound { cells: parts, ..bound })
        };
        on_finest(work.left(), work, of_point)
    })
}

/// At the ends of a span the runtime has a point from the values of the functions, which are no entries of the table
/// where there are factors after a sum.
fn point_at_ends(
    piece: &Family,
    form: &RationalForm,
    count: u32,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Rational> {
    let functions = form.numerators.len();
    let mut most = Rational::ZERO;
    for k in 0..functions {
        if form.numerators.functions[k].bernstein.iter().all(Poly::is_zero) {
            continue;
        }
        let truncation = piece.truncations.as_ref()?.get(k)?.as_ref()?;
        let (steps, factor) = coefficient_steps(piece, form, k)?;
        let inputs =
            with_ranges(piece, inputs(piece, &steps, &[Rational::ZERO, Rational::ZERO], Range::unit(), 0)?);
        let cells = shape_cells(&inputs, count);
        let mut stage = Stage::new(&steps, &inputs, &cells)?;
        let mut of_function = Rational::ZERO;
        for cell in 0..cells.len() {
            let value = Value::new(&mut stage, cell, truncation, factor, piece, work)?;
            // Coordinates are 0 and 1 there: of the sum one term is left. With the products with control points.
            let others = &value.others.unwrap_or(Rational::ZERO) + &Rational::from(functions as i64);
            let others = with_higher(&others)?;
            for known in [value.coefficients.first()?, value.coefficients.last()?] {
                let of_value = &(&known.computed() * &others) + &(&known.error * &Rational::new(65, 64));
                let missing = &value.missing.of_ends + &(&value.missing.of_size * &known.computed());
                of_function = of_function.max(&of_value + &missing);
            }
        }
        most += &of_function;
        parts.extend(stage.parts());
    }
    Some(most)
}

fn point_on_span(
    piece: &Family,
    form: &RationalForm,
    count: u32,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Rational> {
    let steps = lower(&rational::numerators(piece, form));
    let coordinates = off(piece, form, &steps)?;
    let inputs = with_ranges(piece, inputs(piece, &steps, &coordinates, Range::unit(), 0)?);
    let (cells, count) = (shape_cells(&inputs, count), form.numerators.len());
    let y = *inputs.coordinates.first()?;
    let truncations = piece.truncations.as_ref()?;
    let mut stage = Stage::new(&steps, &inputs, &cells)?;
    let mut most = Rational::ZERO;
    let rows = steps.outputs.len() / count.max(1);
    let functions = Rational::from(i64::try_from(count).ok()?);
    for cell in 0..cells.len() {
        let (mut size, mut error) = (vec![Rational::ZERO; rows], vec![Rational::ZERO; rows]);
        let mut missing = Poly::zero();
        for k in 0..count {
            let places = steps.outputs.iter().skip(k).step_by(count).copied().listed();
            let plain = [Poly::one(), Poly::one()];
            let own = coefficients(&mut stage, cell, &places, &plain, work)?;
            for (j, known) in own.iter().enumerate() {
                size[j] += &known.computed();
                error[j] += &known.error;
            }
            let lost = Missing::new(&mut stage, cell, truncations.get(k)?.as_ref()?, piece, work)?;
            let sizes = own.mapped(Known::computed);
            let x = Poly::var(y);
            let ends = &x.pow(lost.ends[0]) * &(&Poly::one() - &x).pow(lost.ends[1]);
            missing = &missing + &ends.scale(&lost.of_ends);
            missing = &missing + &Sum::polynomial(&sizes, y).scale(&lost.of_size);
        }
        // Each product with a control point, and the sums of these.
        for (error, size) in error.iter_mut().zip(&size) {
            *error += &(size * &functions);
        }
        if !is_counted(rows.saturating_sub(1), &coordinates) {
            return None;
        }
        for is_divided in [false, true] {
            let errors = in_both(&size, &error, &coordinates, is_divided)?;
            let sum = &Sum::polynomial(&errors, y) + &missing;
            for cell in cells_of_coordinate(y, true) {
                most = most.max(ratio(&cell, &sum, &Poly::one(), parts, work)?);
            }
        }
    }
    parts.extend(stage.parts());
    Some(most)
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
    outputs: Vec<usize>,
    exact: Exact<'a>,
    cells: Vec<Majorants<'a>>,
}

impl<'a> Stage<'a> {
    fn new(steps: &'a Steps, inputs: &Inputs, cells: &'a [Cell]) -> Option<Self> {
        let mut all = Vec::new();
        for cell in cells {
            all.push(Majorants::new(cell, steps.steps.len()));
        }
        Some(Self { outputs: steps.outputs.clone(), exact: Exact::new(steps, inputs)?, cells: all })
    }

    /// A number that |B| is at least on a cell.
    fn divisor(
        &mut self,
        cell: usize,
        piece: &Family,
        truncation: &Truncation,
        work: &mut Work,
    ) -> Option<Rational> {
        let mut divisor = truncation.divisor.clone();
        for angle in piece.analytic.angles.iter().filter(|angle| angle.kind == Kind::Linear) {
            divisor = divisor.substitute(angle.itself, &Poly::var(angle.var));
        }
        let conditions = &mut self.cells[cell].conditions;
        let (_, least) = between(&[divisor, Poly::one()], conditions, work)?;
        let left = &least.abs() - &truncation.below;
        left.is_positive().then_some(left)
    }

    /// What the numbers follow from.
    fn parts(&self) -> Vec<Part> {
        let of_cell = |Majorants { conditions, of_steps, .. }: &Majorants<'_>| {
            only(conditions.cell, [&conditions.known[..], &of_steps[..]].concat())
        };
        self.cells.mapped(of_cell)
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
