//! Signs of functions in which a variable, or the end of its range, stands beside its own sine or exponential.
//!
//! There are several ways to statements that are enough for such a sign, and need not be true if it is as claimed; a
//! certificate holds the number of the one that was successful. All of them lead to polynomials in tangents:
//!
//! - for shape parameters in exponentials whose ranges end in numbers, what is enough without these ends;
//! - the ladder of derivatives, with bounds for the parameters at the end of the domain in what it leaves, or with ladders in
//!   these; also with the domain reversed;
//! - bounds for the variable itself, exact where it is 0, cell by cell at the nearest end, or in many short cells;
//! - as a combination of the functions of the family, each of which is ≥ 0, or as a product of factors;
//! - by ladders on the parts of the domain between points at which the value or its derivative vanishes.
//!
//! A claim is false where the value is not as claimed whatever the numbers are that its enclosures leave
//! ([`refute`]).

mod claims;
mod combination;
mod cuts;
mod factors;
mod fine;
mod ladder;
mod parameter;
mod point;
mod sample;
mod values;

use basis_kernel::{Domain, Proof, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample};
use std::rc::Rc;

use super::Where;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::angle::enclosure::{Anchor, From, without};
use crate::model::angle::{Angle, Kind};
use crate::model::{Family, Function};
use ladder::Ladder;
use values::Values;

pub(super) use crate::model::angle::tangents::wider;
pub(super) use claims::{
    Whatever, about, at_point, enough, proved_at_once, refuted, refuted_whatever, rows_between_bounds, shown,
};
pub(super) use point::{name_angles, places, value_at};
pub(super) use sample::Sample;
pub(super) use values::genuine;

/// Something that has to be ≥ 0, or > 0.
#[derive(Clone)]
pub(super) struct Step {
    pub(super) of: String,
    pub(super) value: Fraction,
    pub(super) comparison: Comparison,
    /// Ranges of variables that are not those of the domain.
    ranges: Vec<(Var, Range)>,
    /// From where an angle is measured.
    anchor: Anchor,
    /// On which side of 0 its points lie, if only one.
    half: Option<Half>,
}

/// One side of 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Half {
    Below,
    Above,
}

impl Step {
    const fn new(of: String, value: Fraction, comparison: Comparison) -> Self {
        Self { of, value, comparison, ranges: Vec::new(), anchor: Anchor::Zero, half: None }
    }

    /// Whether it is about the whole domain, in the variables of the family.
    const fn is_plain(&self) -> bool {
        self.ranges.is_empty() && matches!(self.anchor, Anchor::Zero) && self.half.is_none()
    }

    /// The points that it is about, of those that a claim is about.
    pub(super) fn domain(&self, whole: &Rc<Domain>) -> Rc<Domain> {
        let mut domain = (**whole).clone();
        for (var, range) in &self.ranges {
            domain.region.ranges.retain(|(v, _)| v != var);
            domain.region.ranges.push((*var, range.clone()));
        }
        Rc::new(domain)
    }
}

/// A text with a sign or the like before it.
fn named(before: &str, of: &str) -> String {
    if of.contains(' ') { format!("{before}({of})") } else { format!("{before}{of}") }
}

/// Ways to what is enough: by derivatives or not, also in a shape parameter, and the level of the bounds.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Wider,
    Ladder(u32),
    Halves(u32),
    Parameter(u32),
    /// The same with the domain reversed.
    Mirrored(u32),
    Whole(u32),
    Cells(u32),
    /// As a combination of functions, whose own ways follow.
    Combination,
    /// On parts of the domain.
    Parts(u32),
    /// On this number of short cells.
    Fine(u32),
    /// As a product of factors, whose own ways follow.
    Factors,
}

/// By their numbers in certificates.
const WAYS: [Way; 15] = [
    Way::Wider,
    Way::Ladder(5),
    Way::Halves(5),
    Way::Parameter(5),
    Way::Mirrored(5),
    Way::Whole(3),
    Way::Cells(4),
    Way::Ladder(10),
    Way::Whole(8),
    Way::Cells(9),
    Way::Combination,
    Way::Parts(8),
    Way::Fine(8),
    Way::Fine(32),
    Way::Factors,
];

/// The level of bounds in short cells: an even one.
const NEXT_TO_A_POINT: u32 = 2;

/// The level of the first bounds.
const LEVEL: u32 = 5;

/// The positions of some of them.
const WIDER: usize = 0;
const LADDER: usize = 1;
const COMBINATION: usize = 10;
const PARTS: usize = 11;
const FACTORS: usize = 14;

/// The order in which the others are tried.
const LATER: [usize; 11] = [PARTS, 12, 2, 3, 4, 5, 13, 6, 7, 8, 9];

/// Whether a comparison is about the sign of a function in which an angle stands beside its sine.
fn is_mixed(family: &Family, value: &Fraction, comparison: Comparison) -> bool {
    !matches!(comparison, Comparison::Equal | Comparison::NotEqual)
        && family.analytic.beside(value).next().is_some()
}

/// What is enough for a value to compare with 0 as claimed, by a way with this number; `None` where that leads nowhere.
fn steps(
    family: &Family,
    of: &str,
    value: &Fraction,
    comparison: Comparison,
    (way, sample): (usize, Option<&Sample<'_>>),
    work: &mut Work,
) -> Option<Vec<Step>> {
    let (value, of) = match comparison {
        Comparison::GreaterEqual | Comparison::Greater => (value.clone(), of.to_string()),
        Comparison::LessEqual | Comparison::Less => (-value, named("-", of)),
        Comparison::Equal | Comparison::NotEqual => return None,
    };
    let strict = matches!(comparison, Comparison::Greater | Comparison::Less);
    let (var, ..) = family.interval()?;
    let range = &family.domain.first()?.range;
    let own = family.analytic.angle(var).filter(|a| a.kind != Kind::Linear && value.depends_on(a.itself));
    let relation = if strict { Comparison::Greater } else { Comparison::GreaterEqual };
    let way = WAYS.get(way)?;
    let (value, own) = match own.filter(|angle| !value.depends_on(angle.var)) {
        // Alone it runs from one end to the other as its tangent would.
        Some(angle) => (value.substitute(angle.itself, &angle.along(range)?)?, None),
        None => (value, own),
    };
    let value = parameters_alone(family, value)?;
    let whole = Step::new(of.clone(), value.clone(), relation);
    if family.analytic.beside(&value).next().is_none() {
        // By the ways that are tried first, with and without ends of ranges.
        return matches!(way, Way::Wider | Way::Ladder(_)).then(|| vec![whole]);
    }
    if *way == Way::Wider {
        return in_wider_ranges(family, &whole, work);
    }
    let sample = sample?;
    if let (Way::Parts(level), Some(angle)) = (way, own) {
        return cuts::steps(family, angle, &whole, *level, sample, work);
    }
    let (found, level) = match (way, own) {
        (Way::Ladder(level) | Way::Parameter(level), Some(angle)) => {
            let mut ladder = Ladder::new(family, angle, range, sample);
            ladder.start(&of, &value, strict, work)?;
            (ladder.found, *level)
        }
        (Way::Mirrored(level), Some(angle)) => {
            let mut ladder = Ladder::new(family, angle, range, sample);
            ladder.start(
                &format!("{of} reversed"),
                &mirrored(family, angle, range, &value, work)?,
                strict,
                work,
            )?;
            (ladder.found, *level)
        }
        (Way::Halves(level), Some(angle)) => {
            let at = zero(angle, sample, work)?;
            let mut all = Vec::new();
            for half in [Half::Below, Half::Above] {
                let sample = sample.half(angle, half, work)?;
                let mut ladder = Ladder::new(family, angle, range, &sample);
                ladder.zero = Some((at.clone(), half));
                ladder.start(&of, &value, strict, work)?;
                all.extend(ladder.found.into_iter().map(|step| Step { half: Some(half), ..step }));
            }
            (all, *level)
        }
        (Way::Cells(level), Some(angle)) => (cells(angle, range, sample, &whole)?, *level),
        (Way::Fine(count), Some(angle)) => {
            (fine::cells(family, angle, range, *count, &whole)?, NEXT_TO_A_POINT)
        }
        (Way::Ladder(level) | Way::Whole(level) | Way::Parameter(level), _) => (vec![whole], *level),
        (Way::Wider | Way::Combination | Way::Parts(_) | Way::Factors, _)
        | (Way::Cells(_) | Way::Fine(_) | Way::Halves(_) | Way::Mirrored(_), None) => return None,
    };
    let (mut all, mut changed) = (Vec::new(), false);
    for step in found {
        let other = matches!(way, Way::Parameter(_) | Way::Mirrored(_))
            .then(|| parameter::instead(family, &step, sample, work));
        let steps = other.flatten().inspect(|_| changed = true).unwrap_or_else(|| vec![step]);
        all.extend(all_bounded(family, steps, level, sample, work)?);
    }
    // Without a ladder along a parameter it is what was tried before.
    (changed || !matches!(way, Way::Parameter(_))).then_some(all)
}

/// A function with the variable running from the upper to the lower end of the domain, where both belong to it or neither does.
fn mirrored(
    family: &Family,
    angle: &Angle,
    range: &Range,
    value: &Fraction,
    work: &mut Work,
) -> Option<Fraction> {
    let [(y, reversed), (s, place)] = angle.mirror.as_slice() else { return None };
    // What takes the place of one contains only that one, and shape parameters.
    let fits = range.low.is_included() == range.high.is_included()
        && family.constraints.is_empty()
        && !reversed.depends_on(*s)
        && !place.depends_on(*y);
    if !fits {
        return None;
    }
    let other = value.substitute_within(*y, reversed, work).ok()??;
    other.substitute_within(*s, place, work).ok()?
}

/// What is enough by the ladder of derivatives where the shape parameters in exponentials have no largest values.
fn in_wider_ranges(family: &Family, whole: &Step, work: &mut Work) -> Option<Vec<Step>> {
    let function = Function { index: Vec::new(), value: whole.value.clone() };
    let alone = Family { functions: vec![function], pieces: Vec::new(), over: Poly::one(), ..family.clone() };
    let wide = wider(&alone)?;
    let value = wide.functions.first()?.value.clone();
    let sample = Sample::new(&wide, work)?;
    let mut all = steps(&wide, &whole.of, &value, whole.comparison, (LADDER, Some(&sample)), work)?;
    for step in &mut all {
        let own = wide.shapes.iter().filter(|p| step.ranges.iter().all(|(v, _)| *v != p.var)).listed();
        step.ranges.extend(own.into_iter().map(|p| (p.var, p.range.clone())));
    }
    Some(all)
}

/// The domain in cells, in each of which the variable is measured from the nearest end, or from 0.
fn cells(angle: &Angle, range: &Range, sample: &Sample<'_>, whole: &Step) -> Option<Vec<Step>> {
    let (low, high) = range.finite()?;
    let middle = |a: &Rational, b: &Rational| &(a + b) * &Rational::new(1, 2);
    // Where the tangent is 0, about.
    let zero = {
        let typical = sample.typical();
        let put = |f: &Fraction| {
            let f = typical
                .iter()
                .try_fold(f.clone(), |f, (v, x)| f.substitute(*v, &Fraction::constant(x.clone())));
            f?.as_constant()
        };
        let at = (-put(&angle.low)?).checked_div(&put(&angle.width)?)?;
        Some(at).filter(|y| low < y && y < high)
    };
    let mut cells = Vec::new();
    let included = |x: &Rational| End::Included(x.clone());
    match zero {
        None => {
            let cut = middle(low, high);
            cells.push((Range { low: range.low.clone(), high: included(&cut) }, Anchor::Low));
            cells.push((Range { low: included(&cut), high: range.high.clone() }, Anchor::High));
        }
        Some(zero) => {
            let unit = Rational::from(64);
            let short = |x: &Rational| (x * &unit).floor().checked_div(&unit).unwrap_or_else(|| x.clone());
            let (a, b) = (short(&middle(low, &zero)), short(&middle(&zero, high)));
            if !(*low < a && a < b && b < *high) {
                return None;
            }
            cells.push((Range { low: range.low.clone(), high: included(&a) }, Anchor::Low));
            cells.push((Range { low: included(&a), high: included(&b) }, Anchor::Zero));
            cells.push((Range { low: included(&b), high: range.high.clone() }, Anchor::High));
        }
    }
    let count = cells.len();
    let step = |(k, (range, anchor)): (usize, (Range, Anchor))| Step {
        of: format!("{} [cell {} of {count}]", whole.of, k + 1),
        ranges: vec![(angle.var, range)],
        anchor,
        ..whole.clone()
    };
    Some(cells.into_iter().enumerate().map(step).listed())
}

/// A value with functions of their tangents, as [`Angle::along`] has them, in place of shape parameters that stand in it, and not
/// in sines or exponentials. Those with a range that depends on others, or that a condition restricts, stay.
fn parameters_alone(family: &Family, value: Fraction) -> Option<Fraction> {
    let mut value = value;
    for p in &family.shapes {
        let angle = family.analytic.angle(p.var).filter(|a| value.depends_on(a.itself));
        let Some(angle) = angle.filter(|a| a.itself != a.var && !value.depends_on(a.var)) else { continue };
        // At an irrational end the tangent runs a little beyond it, and the parameter itself to the end.
        let is_free = family.constraints.iter().all(|c| c.is_end || !c.value.depends_on(angle.var));
        if is_free
            && angle.ends.iter().all(|end| !end.is_empty())
            && let Some(own) = angle.along(&p.range)
        {
            value = value.substitute(angle.itself, &own)?;
        }
    }
    Some(value)
}

/// Where 0 lies strictly inside of the range of an angle: the value of its variable there.
fn zero(angle: &Angle, sample: &Sample<'_>, work: &mut Work) -> Option<Fraction> {
    let at = (-&angle.low).checked_div(&angle.width)?;
    (angle.shift.is_zero()
        && sample.half(angle, Half::Below, work).is_some()
        && sample.half(angle, Half::Above, work).is_some())
    .then_some(at)
}

/// The same step, about the tangent itself in place of the variable that runs between the ends of its range, if these contain
/// exp(r) or tan(r) and the step does not: about a little more than this range.
fn in_the_tangent(family: &Family, angle: &Angle, step: &Step) -> Option<(Step, Angle)> {
    let numbers = family.analytic.numbers().into_iter().filter(|var| Some(*var) != family.analytic.pi);
    let number = &numbers.listed().into_iter().find(|number| angle.tangent().depends_on(*number))?;
    if step.ranges.iter().any(|(v, _)| *v == angle.var) {
        return None;
    }
    let value = by_the_tangent(angle, &step.value).filter(|value| !value.depends_on(*number))?;
    let end = |y: i64, up: bool| {
        let x = angle.tangent().substitute(angle.var, &Fraction::constant(Rational::from(y)))?;
        values::bound(family, &x, up)
    };
    let (mut low, mut high) = (end(0, false)?, end(1, true)?);
    match step.half {
        Some(Half::Below) => high = Rational::ZERO,
        Some(Half::Above) => low = Rational::ZERO,
        None => {}
    }
    let mut ranges = step.ranges.clone();
    ranges.push((angle.var, Range::closed(low, high)));
    Some((Step { value, ranges, half: None, ..step.clone() }, by_itself(angle)))
}

/// A value with the tangent itself in place of the variable that runs between the ends of its range.
fn by_the_tangent(angle: &Angle, value: &Fraction) -> Option<Fraction> {
    value.substitute(angle.var, &(&Fraction::var(angle.var) - &angle.low).checked_div(&angle.width)?)
}

/// The angle whose variable is the tangent itself.
fn by_itself(angle: &Angle) -> Angle {
    Angle { low: Fraction::zero(), width: Fraction::constant(Rational::ONE), ..angle.clone() }
}

/// The statements about some steps in which bounds stand in place of the angles themselves.
fn all_bounded(
    family: &Family,
    found: Vec<Step>,
    level: u32,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let mut all = Vec::new();
    for step in found {
        all.extend(bounded(family, step, level, sample, work)?);
    }
    Some(all)
}

/// The statements about a step in which bounds stand in place of the angles themselves.
fn bounded(
    family: &Family,
    step: Step,
    level: u32,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let (mut step, mut local) = (step, None);
    if step.anchor == Anchor::Zero
        && let Some(angle) = family.interval().and_then(|(var, ..)| family.analytic.angle(var))
        && step.value.depends_on(angle.var)
    {
        if let Some((changed, other)) = in_the_tangent(family, angle, &step) {
            (step, local) = (changed, Some(other));
        } else if let Some(half) = step.half {
            let at = zero(angle, sample, work)?.as_constant()?;
            let range = family.domain.first()?.range.clone();
            let range = match half {
                Half::Below => Range { high: End::Included(at), ..range },
                Half::Above => Range { low: End::Included(at), ..range },
            };
            step.ranges.push((angle.var, range));
        }
    }
    if let Anchor::At(_) = step.anchor {
        // Its variable is the tangent itself.
        local = family.interval().and_then(|(var, ..)| family.analytic.angle(var)).map(by_itself);
    }
    if family.analytic.beside(&step.value).next().is_none() {
        return Some(vec![step]);
    }
    let mut all = Vec::new();
    let (mut above, below) = (step.value.numer().clone(), step.value.denom().clone());
    if below.as_constant().is_none() {
        // A quotient has the sign of the numerator where the denominator is positive.
        let rows = sample.signs(&Fraction::from(below.clone()), work)?;
        let negative = rows.iter().flatten().find(|s| **s != 0).is_some_and(|s| *s < 0);
        let below = if negative { -&below } else { below };
        above = if negative { -&above } else { above };
        let of = format!("the denominator of {}", step.of);
        all.push((Step { of, comparison: Comparison::GreaterEqual, ..step.clone() }, below));
    } else {
        above = above.scale(&below.as_constant()?.recip()?);
    }
    all.push((step, above));
    let mut done = Vec::new();
    for (step, poly) in all {
        let mut parts = vec![(step.of.clone(), poly, step.ranges.clone())];
        // From the domain variable, whose ends are the parameters, to these.
        for angle in
            family.analytic.angles.iter().rev().filter(|a| a.kind != Kind::Linear && a.itself != a.var)
        {
            let mut next = Vec::new();
            for (of, poly, ranges) in parts {
                if !poly.depends_on(angle.itself) {
                    next.push((of, poly, ranges));
                    continue;
                }
                let own = family.domain.iter().any(|p| p.var == angle.var);
                let anchor = if own { step.anchor } else { Anchor::Zero };
                let declared = family.region().range(angle.var);
                let mut typical = sample.typical();
                let cell =
                    step.ranges.iter().find(|(v, _)| matches!(anchor, Anchor::At(_)) && *v == angle.var);
                if let Some((low, high)) = cell.and_then(|(_, cell)| cell.finite()) {
                    typical.retain(|(v, _)| *v != angle.var);
                    typical.push((angle.var, &(low + high) * &Rational::new(1, 2)));
                }
                let from = From { anchor, range: &declared, n: level, typical: &typical };
                let angle = local.as_ref().filter(|local| local.var == angle.var).unwrap_or(angle);
                let found = without(&poly, &family.analytic, angle, &from, false, work)?;
                let count = found.len();
                for (k, poly) in found.into_iter().enumerate() {
                    let mut ranges = ranges.clone();
                    ranges.push((angle.itself, Range::unit()));
                    let name = &angle.name;
                    next.push((
                        match (count, k) {
                            (1, _) => format!("{of} with the bound for {name}"),
                            (2, 0) => format!("{of} with the lower bound for {name}"),
                            (2, _) => format!("{of} with the upper bound for {name}"),
                            _ => format!("{of} between the bounds for {name}, coefficient {k}"),
                        },
                        poly,
                        ranges,
                    ));
                }
            }
            parts = next;
        }
        for (of, poly, ranges) in parts {
            done.push(Step { of, value: Fraction::from(poly), ranges, ..step.clone() });
        }
    }
    Some(done)
}

/// A counterexample to a statement about a sign in which π, exp(r) or an angle beside its sine occur, with the proof that the
/// statement fails whatever these are between their bounds.
fn refute(
    family: &Family,
    value: &Fraction,
    statement: &Statement,
    at: Where,
    work: &mut Work,
) -> Option<(Counterexample, Proof)> {
    let Statement::Sign { domain, .. } = statement else { return None };
    let sample = Sample::at(at, family, work)?.under(&domain.premises);
    let points = sample.lowest(value, work)?;
    points.into_iter().take(24).find_map(|point| sample::refuted_at(family, statement, &point, work))
}

/// The coordinates of a point that are no angles themselves, and no numbers such as π.
fn rational_part(family: &Family, point: &[(Var, Rational)]) -> Values {
    let numbers = family.analytic.numbers();
    let wide = |var: Var| {
        numbers.contains(&var) || family.analytic.angles.iter().any(|a| a.itself == var && a.var != var)
    };
    point.iter().filter(|(var, _)| !wide(*var)).cloned().listed()
}

/// A number times one of π and exp(r), in the middle of the bounds for these.
pub(super) fn about_number(family: &Family, factor: &Fraction, value: &Rational) -> Rational {
    let middle = |f: Fraction, (var, range): &(Var, Range)| {
        let put = range.finite().and_then(|(low, high)| {
            let middle = &(low + high) * &Rational::new(1, 2);
            f.substitute(*var, &Fraction::constant(middle))
        });
        put.unwrap_or(f)
    };
    let number = family.analytic.ranges.iter().fold(factor.clone(), middle).as_constant();
    number.map_or_else(|| value.clone(), |number| &number * value)
}

/// The value at a counterexample for reading, if it is not rational: with π, or as a decimal; times a factor of π and exp(r).
fn of_sign(
    family: &Family,
    found: &Counterexample,
    (value, negated): (&Rational, bool),
    factor: Option<&Fraction>,
) -> Option<String> {
    const LONGEST: usize = 24;
    let Statement::Sign { value: exact, .. } = found.refutation.statement() else { return None };
    let numbers = family.analytic.numbers();
    let rational = found.point.iter().filter(|(var, _)| !numbers.contains(var));
    let put = |p: &Poly| {
        rational.clone().fold(p.clone(), |p, (var, c)| match c {
            Coordinate::Rational(x) if family.analytic.angles.iter().all(|a| a.itself != *var) => {
                p.at(*var, x)
            }
            _ => p,
        })
    };
    let exact = Fraction::new(put(&exact.numerator), put(&exact.denominator))?;
    let exact = if negated { -&exact } else { exact };
    let (exact, value) = match factor {
        Some(factor) => (&exact * factor, about_number(family, factor, value)),
        None => (exact, value.clone()),
    };
    let text = claims::numbers_written(family, &exact.display(&family.names));
    let own = family.analytic.angles.iter().any(|a| a.itself != a.var && exact.depends_on(a.itself));
    (own || numbers.iter().any(|n| exact.depends_on(*n))).then(|| {
        if own || text.len() > LONGEST { crate::state::verdict::about(&value) } else { text.clone() }
    })
}
