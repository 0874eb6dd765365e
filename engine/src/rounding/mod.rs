//! Proved bounds of rounding errors.
//!
//! The value that floats give for a function is that of its [`Steps`] in which step k is multiplied by 1 + δₖ, |δₖ| ≤
//! u, where u = ε/2 is half the distance from 1 to the next float. To first order the error is Σ δₖ·wₖvₖ, with vₖ the
//! exact value of the step and wₖ the derivative of the result with respect to it. Both are rational functions of the
//! inputs, so that a bound is a statement like any other one about signs, which the kernel decides:
//!
//! - *relative*, κ·u times the value: κ·|v| − Σ|wₖvₖ| ≥ 0; file `relative`;
//! - *absolute*, c·u, for functions that change their sign: c − Σ|wₖvₖ| ≥ 0; file `absolute`. Points of curves are
//!   bounded so, and those of patches in two stages; file `net`.
//!
//! What is of higher order in u is bounded by a number that counts roundings, with u = 2⁻²⁴, that of `f32`; file
//! `rest`. Steps that do not round are left out: inputs, numbers that are floats, negation, products with powers of
//! two, and differences a − b with b/2 ≤ a ≤ 2b (Sterbenz). The domain is cut into cells for these, and where a bound
//! is the largest; file `refine`.
//!
//! A value that is proved to be nonnegative may be cut off at 0, which changes no error for the worse: the exact value
//! is not on the other side. So its bound is that of what is cut off.
//!
//! A fused multiplication and addition rounds less, so that the bounds hold for fused code, too. They hold as long as
//! nothing overflows; each product that underflows is off by half the smallest float, which a division after it may
//! enlarge.
//!
//! Where a variable stands beside its sine, polynomials are evaluated in place of the functions; files `series` and
//! `sum`. Points of curves over quotients, in all orders in which they are computed: file `curve`. Where there is no bound,
//! file `advice` says why.
//!
//! Sines, exponentials and the like are assumed to be within one unit in the last place; what comes out of them are inputs
//! that are off; file `angles`. Where a float is that of an end such as π/2, the value is the one at the end.
//!
//! Shape values and the coordinates of a point are exact as they are given. All three or four barycentric coordinates
//! are inputs: the exact value is that of the formula, made homogeneous in them, for these floats, also if they do not
//! quite sum to 1. An absolute bound is then one times a power of their sum.

mod absolute;
#[cfg(any(test, feature = "tools"))]
mod advice;
mod angles;
mod cell;
mod conditions;
mod curve;
mod exact;
mod majorant;
mod net;
mod refine;
mod relative;
mod rest;
mod series;
mod sum;

use std::rc::Rc;

use basis_kernel::{Domain, Quotient, Relation, Statement};
use basis_prover::collections::list::{Listed, Mapped};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::{Factor, Family, Truncations};
use crate::plan::Input;
use crate::plan::evaluated::{self, is_evaluated};
use crate::plan::interval::form::RationalForm;
use crate::steps::{FamilySteps, Steps};
use absolute::{Absolute, MOST_SIGNED, counted};
#[cfg(any(test, feature = "tools"))]
pub use advice::advice;
use angles::OnCoordinates;
pub use angles::{BARYCENTRIC, NEAREST, assumed, has_ends_beside_floats, needs_functions};
use cell::Cell;
use exact::Exact;
use refine::{Lack, refined, told_if_spent};
use relative::Relative;

/// How far a computed value may be from the exact one, in units of ε, the distance from 1 to the next float: 2⁻²³ for
/// `f32`, 2⁻⁵² for `f64`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Error {
    /// This many ε times the value.
    Relative(Rational),
    /// This many ε.
    Absolute(Rational),
}

impl Error {
    /// The number of ε.
    pub const fn epsilons(&self) -> &Rational {
        match self {
            Self::Relative(bound) | Self::Absolute(bound) => bound,
        }
    }
}

impl core::fmt::Display for Error {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let epsilons = decimal(self.epsilons());
        match self {
            _ if self.epsilons().is_zero() => f.write_str("exact"),
            Self::Relative(_) => write!(f, "{epsilons} ε of the value"),
            Self::Absolute(_) => write!(f, "{epsilons} ε"),
        }
    }
}

/// A whole number of hundredths as a decimal number.
pub fn decimal(x: &Rational) -> String {
    let whole = x.floor();
    let hundredths = (&(x - &whole) * &Rational::from(100)).to_string();
    match hundredths.trim_end_matches('0') {
        "" => whole.to_string(),
        _ if hundredths.len() == 1 => format!("{whole}.0{hundredths}"),
        digits => format!("{whole}.{digits}"),
    }
}

/// Functions with the same bound.
pub(crate) struct Group {
    pub(crate) labels: String,
    /// Their bound, or what is said in its place.
    pub(crate) text: String,
    pub(crate) is_bounded: bool,
}

/// The bounds of all functions of a family as text, each with the functions that have it, in the order of the first; what
/// is said of a function in place of a bound where there is none.
pub(crate) fn grouped(
    errors: &[Option<Error>],
    family: &Family,
    without: &dyn Fn(usize) -> String,
) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (k, error) in errors.iter().enumerate() {
        let text = error.as_ref().map_or_else(|| without(k), ToString::to_string);
        let (labels, is_bounded) = (family.function_label(k), error.is_some());
        match groups.iter_mut().find(|other| other.text == text) {
            Some(other) => other.labels += &format!(", {labels}"),
            None => groups.push(Group { labels, text, is_bounded }),
        }
    }
    groups
}

/// A bound with what it follows from.
#[derive(Clone, Debug)]
pub struct Bound {
    /// The bound, rounded up to hundredths.
    pub error: Error,
    cells: Vec<Part>,
}

/// What a bound takes on one cell of the domain.
#[derive(Clone, Debug)]
struct Part {
    domain: Rc<Domain>,
    /// Polynomials that are not negative: conditions under which the others say something about the error.
    conditions: Vec<Poly>,
    /// With a bound of κ u: (κ − `rest`)·`value` is at least each of the `sums`.
    value: Poly,
    sums: Vec<Poly>,
    rest: Rational,
    /// The bound of a stage in u; `None` where it is the whole bound.
    own: Option<Rational>,
}

impl Part {
    /// What is not negative if the error is at most this many u.
    fn last(&self, bound: &Rational) -> Vec<Poly> {
        let most = self.value.scale(&(bound - &self.rest));
        self.sums.mapped(|sum| &most - sum)
    }
}

impl Bound {
    /// The statements from which it follows that the error is at most `epsilons` times ε, relative or absolute as the
    /// bound is.
    pub fn statements(&self, epsilons: &Rational) -> Vec<Statement> {
        let mut all = Vec::new();
        for part in &self.cells {
            let whole = epsilons * &Rational::from(2);
            let last = part.last(part.own.as_ref().unwrap_or(&whole));
            for poly in part.conditions.iter().chain(&last) {
                let (value, domain) = (Quotient::from(poly.clone()), Rc::clone(&part.domain));
                all.push(Statement::Sign { value, relation: Relation::NonNegative, domain });
            }
        }
        all
    }
}

/// Bounds of the errors of the values of all functions; `None` for one without. On several spans a function has one bound
/// for all of them.
///
/// `None` in place of a list when the work is spent, the family is too large to be generated, or has an end that is
/// computed otherwise than as a sum of multiples of shape parameters.
pub fn values(family: &Family) -> Option<Vec<Option<Bound>>> {
    let family = &*evaluated::form(family, Truncations::Found)?;
    if series::is_series(family) {
        return series::values(family);
    }
    let spans = spans(family)?;
    basis_prover::working(family.budget, &mut |work| {
        let mut exact = Vec::new();
        for (steps, inputs) in &spans {
            exact.push(OnSpan { exact: Exact::new(steps, inputs)?, steps, inputs });
        }
        let (count, whole) = (family.functions.len(), work.left());
        let mut bounds: Vec<Option<Bound>> = vec![None; count];
        let steps: u64 = exact.iter().map(|span| span.steps.steps.len() as u64).sum();
        // A hard function takes at most a quarter of the work, or its part of what is left for it and those after it;
        // what is left by all is for those without a bound.
        for most in [whole / 4, 0] {
            for k in 0..count {
                if bounds[k].is_some() {
                    continue;
                }
                let others = bounds[k..].iter().filter(|bound| bound.is_none()).count() as u64;
                // Which steps a function needs is found among those of all functions.
                let part = (work.left() / others).saturating_sub(steps);
                let share = part.max(work.left().min(most));
                if work.spend(steps).is_some() {
                    bounds[k] = with_share(work, share, &mut |own| value(&mut exact, k, part / 2, own));
                }
            }
        }
        Some(bounds)
    })
}

/// Does something with a part of the work.
fn with_share<T>(work: &mut Work, share: u64, part: &mut dyn FnMut(&mut Work) -> Option<T>) -> Option<T> {
    let mut own = Work::new(share);
    let result = part(&mut own);
    told_if_spent(&own);
    work.spend(share - own.left())?;
    result
}

/// The values on each span with what their inputs are; `None` where nothing is known of these.
fn spans(family: &Family) -> Option<Vec<(Steps, Inputs)>> {
    if let Some(steps) = without_angles(family) {
        let span = |k: usize| {
            let own = family.pieces.get(k).map_or(family, |piece| &**piece);
            (steps.on_span(k).values(), Inputs::of(own, 0))
        };
        return Some((0..steps.spans()).map(span).listed());
    }
    if !is_evaluated(family) {
        return None;
    }
    let mut spans = Vec::new();
    for (k, form) in RationalForm::of_family(family)?.iter().enumerate() {
        let own = family.pieces.get(k).map_or(family, |piece| &**piece);
        spans.extend(OnCoordinates::new(own, form)?.into_iter().map(|part| (part.steps, part.inputs)));
    }
    Some(spans)
}

/// The steps of a family without angles.
fn without_angles(family: &Family) -> Option<FamilySteps<'_>> {
    let is_plain = |piece: &Family| piece.analytic.is_empty();
    (is_plain(family) && family.pieces.iter().all(|piece| is_plain(piece)))
        .then(|| FamilySteps::new(family))?
}

/// A bound of the error of each component of a point of a curve or patch, with the binding of its control points, relative
/// to the largest absolute value of that component of a control point. Barycentric coordinates add up to 1.
///
/// `None` when the work is spent or nothing is found.
pub fn point(family: &Family) -> Option<Bound> {
    let family = &*evaluated::form(family, Truncations::Found)?;
    if RationalForm::is_of(family) {
        return curve::point(family);
    }
    let form = FamilySteps::new(family)?;
    let Some(curve) = form.curve(1) else {
        return basis_prover::working(family.budget, &mut |work| net::patch_point(family, &form, work));
    };
    let steps = form.on_control_points(&curve);
    let inputs = Inputs::of(family, family.functions.len());
    basis_prover::working(family.budget, &mut |work| {
        let parts = of_points(&steps, &inputs, MOST_SIGNED, work.left(), work)?;
        Some(rounded_up(parts, Error::Absolute, &Rational::ZERO))
    })
}

/// Bounds of the error of steps that are linear in control points, with a share of the work: with the signs of the
/// points that are the worst for each step by itself, and, if there are few points, with those that are the worst for
/// all of them.
fn of_points(
    steps: &Steps,
    inputs: &Inputs,
    most_signed: usize,
    share: u64,
    work: &mut Work,
) -> Option<Parts> {
    let mut exact = Exact::new(steps, inputs)?;
    let output = *steps.outputs.first()?;
    let share = share.min(work.left());
    let mut on_points = |most_signed: usize, share: u64, work: &mut Work| {
        with_share(work, share, &mut |work| {
            let absolute = Absolute::new(&mut exact, output, &inputs.points, most_signed, work)?;
            let on =
                &mut |cell: &Cell, work: &mut Work| absolute.on(&mut exact, cell, work).ok_or(Lack::Here);
            refined(inputs, share, work, on)
        })
    };
    // What one way does not take is left for the next, which is better on as many cells.
    let (before, is_signed) = (work.left(), inputs.points.len() <= most_signed);
    let unsigned = on_points(0, if is_signed { share / 4 } else { share / 4 * 3 }, work);
    let mut left = share - (before - work.left());
    let signed = is_signed
        .then(|| on_points(most_signed, if unsigned.is_none() { left / 2 } else { left }, work))
        .flatten();
    left = share - (before - work.left());
    let most = |parts: &Parts| parts.iter().map(|(bound, _)| bound.clone()).max();
    let found = [unsigned, signed].into_iter().flatten().min_by_key(most);
    found.or_else(|| {
        with_share(work, left, &mut |work| {
            let on =
                &mut |cell: &Cell, work: &mut Work| counted(&mut exact, output, cell, work).ok_or(Lack::Here);
            refined(inputs, left / 4, work, on)
        })
    })
}

/// The steps of the values on one span.
struct OnSpan<'a> {
    exact: Exact<'a>,
    steps: &'a Steps,
    inputs: &'a Inputs,
}

type Parts = Vec<(Rational, Part)>;

impl OnSpan<'_> {
    /// A bound relative to the value; so much of the work is spent on a smaller one.
    fn relative(&mut self, function: usize, share: u64, work: &mut Work) -> Option<Parts> {
        let Self { exact, steps, inputs } = self;
        let relative = Relative::new(exact, steps.outputs[function], work)?;
        let on = &mut |cell: &Cell, work: &mut Work| {
            relative.on(exact, cell, work).ok_or_else(|| relative.lack(cell, work))
        };
        refined(inputs, share, work, on)
    }

    fn absolute(&mut self, function: usize, share: u64, work: &mut Work) -> Option<Parts> {
        let Self { exact, steps, inputs } = self;
        let absolute = Absolute::new(exact, steps.outputs[function], &[], 0, work)?;
        let on = &mut |cell: &Cell, work: &mut Work| absolute.on(exact, cell, work).ok_or(Lack::Here);
        refined(inputs, share, work, on)
    }
}

/// The bound of one value, relative if there is one on all spans; so much of the work is spent on a smaller one.
fn value(spans: &mut [OnSpan<'_>], function: usize, share: u64, work: &mut Work) -> Option<Bound> {
    let most = share / spans.len().max(1) as u64;
    let mut on_all = |is_relative: bool| {
        let mut all = Vec::new();
        for span in &mut *spans {
            all.extend(if is_relative {
                span.relative(function, most, work)?
            } else {
                span.absolute(function, most, work)?
            });
        }
        Some(all)
    };
    if let Some(parts) = on_all(true) {
        return Some(rounded_up(parts, Error::Relative, &Rational::ZERO));
    }
    Some(rounded_up(on_all(false)?, Error::Absolute, &Rational::ZERO))
}

/// The largest bound, or a number, which are in u, in hundredths of ε.
fn rounded_up(parts: Parts, error: fn(Rational) -> Error, least: &Rational) -> Bound {
    let mut largest = least.clone();
    for (bound, _) in &parts {
        if *bound > largest {
            largest = bound.clone();
        }
    }
    let error = error(least_multiple(&(&largest * &Rational::new(1, 2)), 100));
    Bound { error, cells: parts.into_iter().map(|(_, part)| part).listed() }
}

/// The least multiple of 1/`parts` that is not below x.
fn least_multiple(x: &Rational, parts: i64) -> Rational {
    let count = -&(-&(x * &Rational::from(parts))).floor();
    &count * &Rational::new(1, parts)
}

/// The variables that stand for the inputs of steps.
struct Inputs {
    /// The ranges of all of them.
    region: Region,
    shapes: Vec<Var>,
    /// On a simplex one more than are independent.
    coordinates: Vec<Var>,
    /// Those of intervals.
    of_intervals: Vec<Var>,
    /// Those of each simplex.
    simplices: Vec<Vec<Var>>,
    /// One component of each control point, between −1 and 1.
    points: Vec<Var>,
    /// The inputs that are no variables, with their exact values and how many u they are off.
    off: Vec<(Input, Poly, Rational)>,
}

impl Inputs {
    fn of(family: &Family, points: usize) -> Self {
        let mut ranges: Vec<(Var, Range)> = family.shapes.mapped(|p| (p.var, p.range.clone()));
        let shapes = family.shapes.mapped(|p| p.var);
        let mut coordinates = Vec::new();
        for p in family.domain_variables() {
            ranges.push((p.var, p.range.clone()));
            coordinates.push(p.var);
        }
        let (mut of_intervals, mut simplices) = (Vec::new(), Vec::new());
        for factor in family.factors() {
            match factor {
                Factor::Interval(p) => of_intervals.push(p.var),
                Factor::Simplex(independent, last) => {
                    simplices.push(independent.iter().chain([last]).map(|p| p.var).listed());
                }
            }
        }
        let points = with_points(&mut ranges, points);
        let (region, off) = (Region { ranges }, Vec::new());
        Self { region, shapes, coordinates, of_intervals, simplices, points, off }
    }

    fn variable(&self, input: Input) -> Option<Var> {
        match input {
            Input::Shape(k) => self.shapes.get(k).copied(),
            Input::Coordinate(k) => self.coordinates.get(k).copied(),
            Input::Point(k) => self.points.get(k).copied(),
            Input::Derivative(_) | Input::Bound(_) => None,
        }
    }
}

/// New variables between −1 and 1, one for each control point.
fn with_points(ranges: &mut Vec<(Var, Range)>, points: usize) -> Vec<Var> {
    let first = ranges.iter().map(|(v, _)| v.0 + 1).max().unwrap_or(0);
    let points = (first..first + points).map(Var).listed();
    for point in &points {
        ranges.push((*point, Range::closed(Rational::from(-1), Rational::ONE)));
    }
    points
}

#[cfg(test)]
mod tests;
