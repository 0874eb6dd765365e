//! Claims about families.

#[cfg(feature = "angles")]
mod beside;
#[cfg(not(feature = "angles"))]
#[path = "no_beside.rs"]
mod beside;
mod conditions;
mod decide;
mod identity;
mod independent;
mod point;
mod positivity;
mod powers;
pub(in crate::state) mod premises;
mod proved;
mod refuted;
#[cfg(any(test, feature = "rounding"))]
mod rounding;
mod spans;
mod witness;

use std::rc::Rc;

use super::inequality::{self, compared_on};
use super::verdict::{Stated, Verdict};
use basis_kernel::{Domain, Statement};
use basis_prover::Shown;

use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{Claim, ClaimKind, Comparison, Joint};
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};
use basis_prover::collections::list::{Listed, Mapped};
use independent::Squares;
use positivity::{chebyshev, minors, wronskian};

#[cfg(any(test, feature = "tools"))]
pub(crate) use identity::moves;
#[cfg(any(test, feature = "tools"))]
pub(crate) use independent::combination_text;
pub use independent::{Table, table};
#[cfg(any(test, feature = "rounding"))]
pub use rounding::{point_error, point_name, value_errors};

/// The expressions that a claim compares with zero, as text and as quotients of polynomials; `None` when the work is
/// spent, or where nothing is known that is enough for it.
fn expressions(
    family: &Family,
    kind: &ClaimKind,
    plainly: bool,
    work: &mut Work,
) -> Option<Vec<(String, Fraction, Comparison)>> {
    let equations = |all: Vec<(String, Fraction)>| {
        all.into_iter().map(|(of, value)| (of, value, Comparison::Equal)).listed()
    };
    let all = match kind {
        ClaimKind::PartitionOfUnity => equations(identity::partition_of_unity(family, work)?),
        ClaimKind::Symmetric if !family.pieces.is_empty() => equations(spans::symmetric(family, work)?),
        ClaimKind::Symmetric => equations(identity::symmetric(family, work)?),
        ClaimKind::Continuity(joint) => equations(identity::continuity(family, joint)?),
        ClaimKind::Smooth(order) => equations(spans::smooth(family, *order, work)?),
        ClaimKind::TotallyPositive if plainly => wronskian::conditions(family, work),
        ClaimKind::TotallyPositive => chebyshev::conditions(family, work)?,
        ClaimKind::Nonnegative => {
            let functions = family.functions.iter().enumerate();
            let least = Comparison::GreaterEqual;
            functions.map(|(k, f)| (family.function_label(k), f.value.clone(), least)).listed()
        }
        ClaimKind::Relation { differences, .. } => {
            differences.mapped(|(comparison, d)| (d.text.clone(), d.value.clone(), *comparison))
        }
        _ => Vec::new(),
    };
    let all = all.into_iter();
    Some(all.map(|(of, value, comparison)| (of, family.analytic.reduced(value), comparison)).listed())
}

/// A statement of a claim, with what it is about and the part of the points of which it says that.
struct Said {
    stated: Stated,
    /// The expression; of several parts the label of the statement says more.
    of: String,
    piece: Piece,
}

/// Proofs of what is enough for a claim, each with its name, and the ways that lead to it.
type ByWays = (Vec<(String, Shown)>, Vec<usize>);

/// What is said of a claim.
#[cfg_attr(not(feature = "angles"), allow(dead_code))] // there are no ways
enum Saying<'w> {
    /// What it says itself.
    Plainly,
    /// What is enough for it, of several ways by those with the numbers given, one after the other.
    Enough(&'w mut core::slice::Iter<'w, usize>),
    /// What is enough for it, by the ways that lead to a proof, of which the numbers are noted.
    Found(&'w mut Vec<usize>),
    /// The same, where also the ways after the first one are tried that lead away from assumptions.
    Tried(&'w mut Vec<usize>),
    /// What is enough for it by one way, for as many comparisons as are counted; nothing where that leads nowhere.
    By(usize, &'w mut usize),
}

/// Which parameters are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Where {
    /// Some in all parts of their ranges.
    Everywhere,
    /// Those next to ends that are left out.
    NextToEnds,
}

/// What is enough for a comparison.
#[cfg_attr(not(feature = "angles"), allow(dead_code))] // it is always itself
enum Enough {
    /// Nothing but itself: no variable stands beside its own sine or exponential in it.
    Itself,
    /// These statements, with the names of what they are about.
    All(Vec<(Stated, String)>),
    /// What no way to a proof says.
    Unknown,
}

/// Decides a claim, on each span if the family has several.
pub(super) fn decide(family: &Family, claim: &Claim) -> Verdict {
    match &claim.kind {
        ClaimKind::Spans(parts) => spans::decide(family, claim, parts),
        _ => decide::decide(family, claim),
    }
}

/// What a claim says, by the ways that are given; `None` when the budget of the family does not suffice to expand it.
pub fn statements(family: &Family, claim: &Claim, ways: &[usize]) -> Option<Vec<Stated>> {
    statements_by(family, claim, &mut ways.iter())
}

/// What a claim says, by the next ones of some ways.
fn statements_by<'w>(
    family: &Family,
    claim: &Claim,
    ways: &'w mut core::slice::Iter<'w, usize>,
) -> Option<Vec<Stated>> {
    let all = said(family, claim, &mut Saying::Enough(ways))?;
    Some(all.into_iter().map(|said| said.stated).listed())
}

/// The statements of a claim one of which may be false: of independence only those whose points all count.
pub(in crate::state) fn refutable(family: &Family, claim: &Claim) -> Option<Vec<Stated>> {
    let mut all = said(family, claim, &mut Saying::Plainly)?;
    if let ClaimKind::Independent(except) = &claim.kind
        && all.iter().any(|said| !said.piece.is_exact())
    {
        all.extend(
            independent::by_squares(family, except, Squares::Plain, &mut premises::without)
                .unwrap_or_default(),
        );
    }
    if matches!(&claim.kind, ClaimKind::Independent(except) if except.is_empty()) {
        all.extend(independent::apart(family));
    }
    let all = all.into_iter();
    let counts = |said: &Said| {
        let independent = matches!(said.stated.statement, Statement::Independent { .. });
        (!independent || said.piece.is_exact())
            && !said.stated.is_stronger
            && !is_wider(family, &said.stated.statement)
    };
    Some(all.filter(counts).map(|said| said.stated).listed())
}

/// Whether ways begin with that to total positivity by Wronskians.
fn by_wronskians(kind: &ClaimKind, ways: &[usize]) -> bool {
    matches!(kind, ClaimKind::TotallyPositive) && ways.first() == Some(&wronskian::BY_WRONSKIANS)
}

/// Parts of the points of a family, where variables are fixed.
type Parts = dyn Fn(&Family, &[(Var, Fraction)]) -> Vec<(Piece, Rc<Domain>)>;

/// What a claim says of each part of the points.
fn said(family: &Family, claim: &Claim, saying: &mut Saying<'_>) -> Option<Vec<Said>> {
    let kind = &claim.kind;
    if let ClaimKind::Spans(parts) = kind {
        let plain = |stated: Stated| Said { of: stated.of.clone(), stated, piece: Piece::default() };
        return Some(spans::statements(family, claim, parts, saying)?.into_iter().map(plain).listed());
    }
    if let Saying::Enough(ways) = saying
        && let Some(conditions) = conditions::next_of(ways)
    {
        return conditions::said_with(family, claim, conditions, saying);
    }
    said_of(family, claim, saying, &inequality::parts)
}

/// The same, of points in other parts than those of [`inequality::parts`] if it is about points.
fn said_of(family: &Family, claim: &Claim, saying: &mut Saying<'_>, parts: &Parts) -> Option<Vec<Said>> {
    let kind = &claim.kind;
    set_known_factors(family.analytic.denominators());
    if let ClaimKind::Independent(except) = kind {
        if let Saying::Enough(ways) = saying
            && let Some(way) = ways.next()
        {
            return match way.checked_sub(1).and_then(|k| independent::BY_SQUARES.get(k)) {
                Some(of) => independent::by_squares(family, except, *of, &mut |s| premises::by_next(s, ways)),
                None => independent::said(&beside::wider(family)?, except),
            };
        }
        return independent::said(family, except);
    }
    let is_total = matches!(kind, ClaimKind::TotallyPositive);
    let plainly = matches!(saying, Saying::Plainly);
    let by_wronskians = match saying {
        Saying::Enough(ways) => by_wronskians(kind, ways.as_slice()) && ways.next().is_some(),
        Saying::Found(ways) | Saying::Tried(ways) => by_wronskians(kind, ways),
        Saying::Plainly | Saying::By(..) => false,
    };
    let inside;
    let family = if by_wronskians {
        inside = wronskian::inside(family);
        &inside
    } else {
        family
    };
    // What total positivity says plainly is only what must hold: its minors are not listed.
    if is_total && !plainly && !by_wronskians && !chebyshev::is_mixed(family) {
        return basis_prover::working(family.budget, &mut |work| minors::said(family, work));
    }
    let mut parts = parts(family, kind.fixed());
    if let ClaimKind::Continuity(Joint { free, .. }) = kind {
        for (_, domain) in &mut parts {
            Rc::make_mut(domain).region.ranges.extend(free.iter().map(|p| (p.var, p.range.clone())));
        }
    }
    #[cfg(any(test, feature = "rounding"))]
    if let ClaimKind::Rounding(epsilons) = kind {
        let plain = |stated: Stated| Said { of: stated.of.clone(), stated, piece: Piece::default() };
        return Some(rounding::statements(family, epsilons)?.into_iter().map(plain).listed());
    }
    let expressions = basis_prover::working(family.budget, &mut |work| {
        if by_wronskians {
            return wronskian::sufficient(family, work);
        }
        expressions(family, kind, plainly, work)
    })?;
    let there = family.where_fixed(kind.fixed())?;
    let (mut all, mut sample) = (Vec::new(), None);
    for (number, part) in parts.iter().enumerate() {
        for (of, value, comparison) in &expressions {
            let comparison = *comparison;
            match beside::enough(&there, (of, value, comparison), part, &mut sample, saying) {
                Enough::All(steps) => {
                    for (stated, of) in steps {
                        let stated =
                            Stated { of: on_part(&of, number, parts.len()), is_stronger: true, ..stated };
                        all.push(Said { stated, of, piece: part.0.clone() });
                    }
                    continue;
                }
                Enough::Unknown if matches!(saying, Saying::By(..)) => return None,
                Enough::Unknown | Enough::Itself => {}
            }
            let is_sign = !matches!(comparison, Comparison::Equal | Comparison::NotEqual);
            let powers = if plainly || !is_sign { None } else { powers::enough(family, of, value) };
            let is_stronger = is_total && !plainly || powers.as_ref().is_some_and(|all| all.len() > 1);
            for (of, value) in powers.unwrap_or_else(|| vec![(of.clone(), value.clone())]) {
                let (of, value) = if is_sign { without_numbers(family, of, value) } else { (of, value) };
                let stated =
                    Stated::new(on_part(&of, number, parts.len()), compared_on(&value, comparison, part)?);
                let stated = Stated { is_stronger, ..stated };
                let enough = if plainly { None } else { away_from_premises(&stated.statement, saying) };
                let Some(enough) = enough else {
                    all.push(Said { stated, of, piece: part.0.clone() });
                    continue;
                };
                for statement in enough {
                    let stated = Stated { statement, is_stronger: true, ..stated.clone() };
                    all.push(Said { stated, of: of.clone(), piece: part.0.clone() });
                }
            }
        }
    }
    Some(all)
}

/// What is enough for a statement where what is assumed is no part of a box, by the way that is given or found.
fn away_from_premises(statement: &Statement, saying: &mut Saying<'_>) -> Option<Vec<Statement>> {
    match saying {
        Saying::Enough(ways) => premises::by_next(statement, ways),
        Saying::Tried(ways) => premises::tried(statement, ways),
        Saying::Found(ways) => premises::by_first(statement, ways),
        Saying::Plainly | Saying::By(..) => premises::without(statement),
    }
}

/// The label of a statement about one of several parts of the points.
pub(in crate::state) fn on_part(of: &str, number: usize, parts: usize) -> String {
    if parts == 1 { String::from(of) } else { format!("{of} [part {}]", number + 1) }
}

/// A value without the powers of π and exp(r) that are its factors: they are positive and play no part in its sign.
fn without_numbers(family: &Family, mut of: String, value: Fraction) -> (String, Fraction) {
    let mut result = value;
    for var in family.analytic.transcendental() {
        let least = |p: &Poly| p.terms().map(|(m, _)| m.exponent(var)).min().unwrap_or(0);
        let (above, below) = (least(result.numer()), least(result.denom()));
        if result.is_zero() || above == below {
            continue;
        }
        let power = |n: u16| Fraction::from(Poly::var(var).pow(u32::from(n)));
        let factor = power(above).checked_div(&power(below)).unwrap_or_else(Fraction::zero);
        let Some(rest) = result.checked_div(&factor) else { continue };
        of = format!("({of})/({})", factor.display(&family.names));
        result = rest;
    }
    (of, result)
}

/// The expression of a claim whose sign is that of a value without powers of π and exp(r), and what was taken away;
/// `None` if nothing was.
fn with_numbers(family: &Family, kind: &ClaimKind, of: &str) -> Option<(String, Fraction)> {
    let all: Vec<(String, Fraction)> = match kind {
        ClaimKind::Relation { differences, .. } => {
            let signs = differences.iter().filter(|(comparison, _)| *comparison != Comparison::Equal);
            signs.map(|(_, d)| (d.text.clone(), d.value.clone())).listed()
        }
        ClaimKind::Nonnegative => {
            let functions = family.functions.iter().enumerate();
            functions.map(|(k, f)| (family.function_label(k), f.value.clone())).listed()
        }
        ClaimKind::TotallyPositive => {
            let all = basis_prover::working(family.budget, &mut |work| wronskian::conditions(family, work));
            all.into_iter().map(|(text, value, _)| (text, value)).listed()
        }
        _ => return None,
    };
    all.into_iter().filter(|(text, _)| text != of).find_map(|(text, value)| {
        let (short, rest) = without_numbers(family, text.clone(), value.clone());
        Some((text, value.checked_div(&rest)?)).filter(|_| short == of)
    })
}

/// Whether a statement says something of π, of exp(r), or of a variable beside its sine: these are variables in it, and
/// points at which it fails need not be points at which the claim does. An equation holds for all values of these
/// variables if it holds, because they are transcendental, and algebraically independent of one another as far as they
/// occur together.
pub(super) fn is_wider(family: &Family, statement: &Statement) -> bool {
    let variables = || {
        let angles = family.analytic.angles.iter().map(|a| a.itself);
        family.analytic.numbers().into_iter().chain(angles)
    };
    let of = |p: &Poly| variables().any(|v| p.depends_on(v));
    match statement {
        // Nobody knows whether π and exp(1) are independent of one another.
        Statement::Zero { value, .. } => {
            let occurs = |v: &Var| value.numerator.depends_on(*v) || value.denominator.depends_on(*v);
            // At a single value a parameter is not independent of its tangent.
            let single = |p: &Parameter| p.range.finite().is_some_and(|(a, b)| a == b);
            let fixed =
                family.shapes.iter().filter(|p| single(p)).filter_map(|p| family.analytic.angle(p.var));
            family.analytic.transcendental().into_iter().filter(occurs).count() > 1
                || fixed.map(|angle| angle.itself).any(|itself| occurs(&itself))
        }
        Statement::Sign { value, .. } => of(&value.numerator) || of(&value.denominator),
        Statement::Products { value, .. } => of(value),
        Statement::Independent { rows, .. } => rows.iter().flatten().any(of),
    }
}

/// A statement that a claim makes of an expression, at one point with bounds for what is not rational there, and the
/// statement that it fails whatever that is between the bounds; `None` if the claim does not make it.
pub(in crate::state) fn at_point(
    family: &Family,
    claim: &Claim,
    of: &str,
    point: &[(Var, Rational)],
) -> Option<[Statement; 2]> {
    if let ClaimKind::Spans(parts) = &claim.kind {
        return spans::at_point(family, claim, parts, of, point);
    }
    let mut all = said(family, claim, &mut Saying::Plainly)?.into_iter();
    let own = all.find(|s| s.stated.of == of && is_wider(family, &s.stated.statement))?;
    let there = family.where_fixed(claim.kind.fixed())?;
    beside::at_point(family, &there, &own.stated.statement, point)
}

/// The minors of a family that `given` names, each of which has to be ≥ 0.
///
/// # Errors
/// When it names none.
pub(in crate::state) fn minors(
    family: &Family,
    given: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    minors::instances(family, given)
}
