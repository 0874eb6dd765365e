//! Claims in which a variable stands beside its sine or exponential: how they are proved and refuted, and what is shown of
//! values that contain π or exp(r).

use std::rc::Rc;

use basis_kernel::{Domain, Proof, Statement};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, Counterexample, simple, within, working_with};

use super::factors::factors;
use super::{Sample, combination, sample, values};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind, Comparison};
use crate::model::Family;
use crate::model::angle::enclosure::{Anchor, From, row_without};
use crate::model::angle::tangents::has_ends;
use crate::model::angle::{Angle, Kind};
use crate::model::chart::Piece;
use crate::state::family::{
    ByWays, Enough, Said, Saying, Where, is_wider, premises, said, statements, without_numbers,
};
use crate::state::inequality::compared_on;
use crate::state::proofs::all;
use crate::state::verdict::Stated;

/// What is enough for a comparison.
pub(in crate::state::family) fn enough<'f>(
    family: &'f Family,
    (of, value, comparison): (&str, &Fraction, Comparison),
    part: &(Piece, Rc<Domain>),
    sample: &mut Option<Sample<'f>>,
    saying: &mut Saying<'_>,
) -> Enough {
    if !super::is_mixed(family, value, comparison) {
        return Enough::Itself;
    }
    by_a_way(family, (of, value, comparison), part, sample, saying).map_or(Enough::Unknown, Enough::All)
}

/// What is enough where an angle stands beside its sine, with the names of what it is about; `None` where no way leads
/// to a proof.
fn by_a_way<'f>(
    family: &'f Family,
    (of, value, comparison): (&str, &Fraction, Comparison),
    part: &(Piece, Rc<Domain>),
    sample: &mut Option<Sample<'f>>,
    saying: &mut Saying<'_>,
) -> Option<Vec<(Stated, String)>> {
    if matches!(saying, Saying::Plainly) {
        return None;
    }
    let value = premises::Positive::of(&part.1).reduced(&value.quotient());
    let value = &Fraction::new(value.numerator, value.denominator)?;
    let by = |way: usize, sample: &mut Option<Sample<'f>>| {
        let sample = if way == super::WIDER { None } else { sampled(family, sample) };
        let steps = basis_prover::working(family.budget, &mut |work| {
            super::steps(family, of, value, comparison, (way, sample), work)
        })?;
        stated(family, steps, part)
    };
    match saying {
        Saying::Plainly => None,
        Saying::Enough(ways) => match ways.next().copied().unwrap_or(0) {
            super::COMBINATION => combined(family, (of, value, comparison), part, sample, saying),
            super::FACTORS => factored(family, (value, comparison), part, sample, saying),
            way => by(way, sample),
        },
        Saying::By(way, count) => {
            **count += 1;
            by(*way, sample)
        }
        Saying::Found(found) | Saying::Tried(found) => {
            let first = |ways: &[usize], sample: &mut Option<Sample<'f>>| {
                ways.iter().find_map(|way| {
                    let way = *way;
                    by(way, sample).filter(|all| are_proved(all, family.budget)).map(|all| (way, all))
                })
            };
            let before = found.len();
            found.push(0);
            if let Some((way, all)) = first(&[super::WIDER, super::LADDER], sample) {
                found[before] = way;
                return Some(all);
            }
            found[before] = super::COMBINATION;
            if let Some(all) =
                combined(family, (of, value, comparison), part, sample, &mut Saying::Found(found))
            {
                return Some(all);
            }
            found.truncate(before);
            found.push(super::FACTORS);
            if let Some(all) = factored(family, (value, comparison), part, sample, &mut Saying::Found(found))
            {
                return Some(all);
            }
            found.truncate(before);
            let way = first(&super::LATER, sample);
            found.push(way.as_ref().map_or(0, |(way, _)| *way));
            way.map(|(_, all)| all)
        }
    }
}

/// The statements that steps make, with the names of what they are about.
fn stated(
    family: &Family,
    steps: Vec<super::Step>,
    part: &(Piece, Rc<Domain>),
) -> Option<Vec<(Stated, String)>> {
    let mut all = Vec::new();
    for step in steps {
        let part = (part.0.clone(), step.domain(&part.1));
        let (of, value) = without_numbers(family, step.of, family.analytic.reduced(step.value));
        all.push((Stated::new(of.clone(), compared_on(&value, step.comparison, &part)?), of));
    }
    Some(all)
}

fn are_proved(all: &[(Stated, String)], budget: u32) -> bool {
    all.iter().all(|(s, _)| basis_prover::decide(s.statement.clone(), &s.symmetries, budget).is_ok())
}

/// The points at which functions are looked at, found when they are first asked for.
fn sampled<'s, 'f>(family: &'f Family, sample: &'s mut Option<Sample<'f>>) -> Option<&'s Sample<'f>> {
    if sample.is_none() {
        *sample = basis_prover::working(family.budget, &mut |work| Sample::new(family, work));
    }
    sample.as_ref()
}

/// What is enough for a combination of the functions of the family, each of these by a way of its own.
fn combined<'f>(
    family: &'f Family,
    (of, value, comparison): (&str, &Fraction, Comparison),
    part: &(Piece, Rc<Domain>),
    sample: &mut Option<Sample<'f>>,
    saying: &mut Saying<'_>,
) -> Option<Vec<(Stated, String)>> {
    let (value, comparison) = positive(value, comparison)?;
    let strict = comparison == Comparison::Greater;
    let parts = basis_prover::working(family.budget, &mut |work| combination::parts(family, &value, work))?;
    let mut all = Vec::new();
    for position in &parts {
        let (label, function) = (family.function_label(*position), &family.functions[*position].value);
        all.extend(by_a_way(family, (&label, function, Comparison::GreaterEqual), part, sample, saying)?);
    }
    if strict {
        let sample = sampled(family, sample)?;
        let positive = basis_prover::working(family.budget, &mut |work| {
            combination::positive(family, (of, &value), &parts, sample, work)
        });
        all.extend(stated(family, positive?, part).filter(|all| are_proved(all, family.budget))?);
    }
    Some(all)
}

/// The work for finding factors, most of which leads to none.
const FACTORING: u64 = 1_500_000;

/// What is enough for a product, each of whose factors goes a way of its own.
fn factored<'f>(
    family: &'f Family,
    (value, comparison): (&Fraction, Comparison),
    part: &(Piece, Rc<Domain>),
    sample: &mut Option<Sample<'f>>,
    saying: &mut Saying<'_>,
) -> Option<Vec<(Stated, String)>> {
    let (value, comparison) = positive(value, comparison)?;
    let found = sampled(family, sample)?;
    let strict = comparison == Comparison::Greater;
    let factors = working_with(FACTORING, &mut |work| factors(&value, strict, found, work))?;
    let mut all = Vec::new();
    for factor in factors {
        let of = factor.display(&family.names);
        all.extend(by_a_way(family, (&of, &factor, comparison), part, sample, saying)?);
    }
    Some(all)
}

/// A value that is ≥ 0 or > 0 where another one compares with 0.
fn positive(value: &Fraction, comparison: Comparison) -> Option<(Fraction, Comparison)> {
    match comparison {
        Comparison::GreaterEqual | Comparison::Greater => Some((value.clone(), comparison)),
        Comparison::LessEqual => Some((-value, Comparison::GreaterEqual)),
        Comparison::Less => Some((-value, Comparison::Greater)),
        Comparison::Equal | Comparison::NotEqual => None,
    }
}

/// A point at which a statement fails, and the proof that it does whatever π and exp(r) are between their bounds.
pub(in crate::state::family) type Whatever = (Counterexample, Proof);

/// The work for a first look for a point at which each of several comparisons fails: those that hold take all that there is.
const FIRST_LOOK: u64 = 1_000_000;

/// One of some comparisons of a claim that fails at a point with π, exp(r), or an angle beside its sine, and the point.
pub(in crate::state::family) fn refuted(
    family: &Family,
    claim: &Claim,
    all: Vec<Said>,
    only_mixed: bool,
    at: Where,
) -> Option<(Said, Whatever)> {
    let there = family.where_fixed(claim.kind.fixed())?;
    let mut open = Vec::new();
    for s in all {
        let Statement::Sign { value, .. } = &s.stated.statement else { continue };
        let value = Fraction::new(value.numerator.clone(), value.denominator.clone())?;
        let fits = if only_mixed {
            super::is_mixed(&there, &value, Comparison::GreaterEqual)
        } else {
            is_wider(family, &s.stated.statement)
        };
        if fits {
            open.push((s, value));
        }
    }
    let rounds: &[u64] = if open.len() > 1 { &[FIRST_LOOK, u64::MAX] } else { &[u64::MAX] };
    for units in rounds {
        for k in 0..open.len() {
            let (s, value) = &open[k];
            let found = within(*units, &mut || {
                basis_prover::working(family.budget, &mut |work| {
                    super::refute(&there, value, &s.stated.statement, at, work)
                })
            });
            if let Some(found) = found {
                return Some((open.swap_remove(k).0, found));
            }
        }
    }
    None
}

/// That a statement fails at a point whatever π and exp(r) are between their bounds.
pub(in crate::state::family) fn refuted_whatever(
    family: &Family,
    claim: &Claim,
    statement: &Statement,
    point: &[(Var, Rational)],
) -> Option<Whatever> {
    let there = family.where_fixed(claim.kind.fixed())?;
    let point = super::rational_part(family, point);
    basis_prover::working(family.budget, &mut |work| sample::refuted_at(&there, statement, &point, work))
}

/// The work for a proof that is tried before counterexamples are searched.
const AT_ONCE: u64 = 4_000_000;

/// The proofs of a claim in which an angle stands beside its sine, and the ways to them, if the way that is tried first leads to
/// them. It takes less time than the search for a counterexample, which most claims do not have.
pub(in crate::state::family) fn proved_at_once(family: &Family, claim: &Claim) -> Option<ByWays> {
    if family.analytic.is_empty() {
        return None;
    }
    // Where ranges end in numbers in exponentials, without these ends; otherwise the ladder of derivatives.
    let way = if has_ends(family) { super::WIDER } else { super::LADDER };
    let (stated, ways) = match &claim.kind {
        ClaimKind::Nonnegative | ClaimKind::Relation { .. } => {
            let mut count = 0;
            let said = said(family, claim, &mut Saying::By(way, &mut count))?;
            (said.into_iter().map(|said| said.stated).listed(), vec![way; count])
        }
        ClaimKind::Independent(except) if except.is_empty() && way == super::WIDER => {
            (statements(family, claim, &[0])?, vec![0])
        }
        _ => return None,
    };
    if ways.is_empty() {
        return None;
    }
    let mut stated = Some(stated);
    let shown = within(AT_ONCE, &mut || all(stated.take()?, family.budget).ok())?;
    Some((shown, ways))
}

/// The rows with all numbers between their bounds in place of parameters beside their sines; `None` where there is no such
/// parameter. If these are independent, the rows are.
pub(in crate::state::family) fn rows_between_bounds(
    family: &Family,
    rows: &[Vec<Poly>],
    region: &Region,
) -> Option<(Vec<Vec<Poly>>, Region)> {
    const LEVEL: u32 = 3;
    let occurs = |a: &&Angle| {
        a.kind != Kind::Linear && a.itself != a.var && rows.iter().flatten().any(|p| p.depends_on(a.itself))
    };
    let angles = family.analytic.angles.iter().filter(occurs).listed();
    if angles.is_empty() {
        return None;
    }
    let (mut rows, mut region) = (rows.to_vec(), region.clone());
    let typical = region.ranges.mapped(|(var, range)| (*var, simple(range)));
    for angle in angles {
        let range = region.range(angle.var);
        let from = From { anchor: Anchor::Zero, range: &range, n: LEVEL, typical: &typical };
        for row in &mut rows {
            *row = basis_prover::working(family.budget, &mut |work| {
                row_without(row, &family.analytic, angle, &from, work)
            })?;
        }
        region.ranges.push((angle.itself, Range::unit()));
    }
    Some((rows, region))
}

/// The statement at one point, and that it fails whatever is not rational there, between its bounds; `None` of other statements
/// than those about a sign.
pub(in crate::state::family) fn at_point(
    family: &Family,
    there: &Family,
    statement: &Statement,
    point: &[(Var, Rational)],
) -> Option<[Statement; 2]> {
    sample::at_point(there, statement, &super::rational_part(family, point))
}

/// Values of angles at a point, by their names.
pub(in crate::state::family) fn about(
    family: &Family,
    there: &Family,
    point: &[(Var, Rational)],
) -> Vec<(String, Rational)> {
    values::about(there, &super::rational_part(family, point))
}

/// The value at a counterexample for reading, if it contains π, exp(r), or a variable beside its sine; of a sign times a factor
/// of π and exp(r).
pub(in crate::state::family) fn shown(
    family: &Family,
    there: &Family,
    found: &Counterexample,
    value: (&Rational, bool),
    factor: Option<&Fraction>,
) -> Option<String> {
    of_equation(there, found).or_else(|| super::of_sign(family, found, value, factor))
}

/// Longer numbers are shown as decimals.
const LONGEST: usize = 48;

/// A text with powers of exp(r) as one number, `exp(2)` for `exp(1/2)^4`.
pub(super) fn numbers_written(family: &Family, text: &str) -> String {
    let Some((var, rate)) = &family.analytic.exponential else { return String::from(text) };
    let power = format!("{}^", family.names[var.0]);
    let mut parts = text.split(&power);
    let mut written = String::from(parts.next().unwrap_or_default());
    for part in parts {
        let digits = part.chars().take_while(char::is_ascii_digit).count();
        let exponent = part[..digits].parse::<i64>().map_or(Rational::ONE, Rational::from);
        written.push_str(&format!("exp({}){}", &exponent * rate, &part[digits..]));
    }
    written
}

/// The value at a counterexample to an equation as text, if it contains π, exp(r), or a variable beside its sine.
fn of_equation(family: &Family, found: &Counterexample) -> Option<String> {
    let Statement::Zero { value, .. } = found.refutation.statement() else { return None };
    let wide = |v: Var| {
        family.analytic.numbers().contains(&v) || family.analytic.angles.iter().any(|a| a.itself == v)
    };
    let of = |p: &Poly| p.variables().into_iter().any(wide);
    if !of(&value.numerator) && !of(&value.denominator) {
        return None;
    }
    let rational = found.point.iter().filter_map(|(v, c)| match c {
        Coordinate::Rational(x) if !wide(*v) => Some((*v, x.clone())),
        _ => None,
    });
    let rational = rational.listed();
    let put = |p: &Poly| rational.iter().fold(p.clone(), |p, (v, x)| p.at(*v, x));
    let value = Fraction::new(put(&value.numerator), put(&value.denominator))?;
    let exact = values::exact(family, &rational);
    let value = exact.iter().try_fold(value, |value, (var, x)| value.substitute(*var, x))?;
    let text = numbers_written(family, &value.display(&family.names));
    let number = || {
        let exact = family.analytic.number(&value);
        exact.or_else(|| values::about_value(family, &rational, &value))
    };
    // A parameter beside its sine, which is a number here, says nothing about the size.
    let open = family.analytic.angles.iter().any(|a| a.itself != a.var && value.depends_on(a.itself));
    let about =
        (open || text.len() > LONGEST).then(number).flatten().map(|x| crate::state::verdict::about(&x));
    Some(match about {
        Some(about) if text.len() > LONGEST => about,
        Some(about) => format!("{text} ({about})"),
        None => text,
    })
}
