//! Ranges of shape parameters on which all functions of a family are nonnegative.

use core::cmp::Ordering;
use std::rc::Rc;

use basis_kernel::{Chart, Domain, Relation, Statement, with};
use basis_prover::collections::list::Mapped;
use basis_prover::range::{LargestRange, Part, largest_range, nonnegative_parts};
use basis_prover::{Budget, Coordinate, decide, pull_back, typical};

use crate::algebra::divisors::gcd::square_free;
use crate::algebra::poly::Poly;
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_between;
use crate::algebra::work::Work;
use crate::claim::ClaimKind;
use crate::model::angle::{Angle, Kind};
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};
use crate::state::Verdict;

/// The work for the factors of denominators.
const DENOMINATORS: u64 = 1_000_000;

/// Where a shape parameter may be so that all functions are nonnegative, the other parameters on their declared ranges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NonnegativeRange {
    /// The name of the parameter.
    pub name: String,
    /// The ranges, such as `-3 <= λ <= 1`; one around the declared range, or several that meet it.
    pub ranges: Vec<String>,
    /// What is left open, or that a function is negative on the declared ranges.
    pub remark: Option<String>,
}

impl core::fmt::Display for NonnegativeRange {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match (&self.ranges[..], &self.remark) {
            ([], remark) => write!(f, "{}: {}", self.name, remark.as_deref().unwrap_or("undecided")),
            (ranges, None) => f.write_str(&ranges.join(" or ")),
            (ranges, Some(remark)) => write!(f, "{} ({remark})", ranges.join(" or ")),
        }
    }
}

/// What is said where a function is negative at declared shape values.
const NEGATIVE: &str = "a function is negative somewhere on the declared ranges";

/// What is said where a range could be larger than the declared one.
const DECLARED: &str = "as declared; no other values were looked at";

/// For each shape parameter the largest range around its declared one on which all functions stay nonnegative, the
/// other parameters on their declared ranges.
///
/// Where a denominator vanishes the range ends, too, and does not contain its end. When a function is negative
/// somewhere on the declared ranges, the largest ranges that meet the declared one.
///
/// Where a function contains π, or a variable beside its sine, nothing is said of values beyond the declared ranges. Nor is
/// it where ranges depend on one another or something is assumed and that is needed: what is said then is what the claim
/// `nonnegative` comes to, or where the parameter may be among its declared values.
pub fn nonnegative_ranges(family: &Family) -> Vec<NonnegativeRange> {
    let dependent = family.analytic.dependent();
    if family.functions.iter().any(|f| dependent.iter().any(|v| f.value.depends_on(*v))) {
        return nonnegative_as_declared(family, DECLARED);
    }
    let on_box = Problem::on_box(family);
    let mut all: Vec<NonnegativeRange> = family.shapes.mapped(|shape| on_box.range(shape));
    let is_settled =
        |range: &NonnegativeRange| range.remark.as_deref().is_none_or(|remark| remark == DECLARED);
    if family.constraints.is_empty() || all.iter().all(is_settled) {
        return all;
    }
    let mut declared = None;
    for (range, shape) in all.iter_mut().zip(&family.shapes).filter(|(range, _)| !is_settled(range)) {
        let found = Problem::on_piece(family, shape).map(|(problem, shape)| problem.range(&shape));
        let found = found.filter(|range| !range.ranges.is_empty());
        *range = found.unwrap_or_else(|| {
            let assumed = "as declared and assumed; no other values were looked at";
            let declared = declared.get_or_insert_with(|| nonnegative_as_declared(family, assumed));
            let own = declared.iter().find(|declared| declared.name == family.name_of(shape));
            own.unwrap_or(range).clone()
        });
    }
    all
}

/// The signs of all functions on the points that count.
struct Problem<'f> {
    family: &'f Family,
    /// The points, as a box with simplices, and how the shape parameters follow from its variables.
    domain: Domain,
    piece: Piece,
    signs: Signs,
    /// Whether nothing can be said of values beyond those of the box.
    is_bound: bool,
}

impl<'f> Problem<'f> {
    /// On the declared ranges, as if they did not depend on one another and nothing were assumed.
    fn on_box(family: &'f Family) -> Self {
        let (domain, piece) = (family.points(), Piece::default());
        let signs = function_signs(family, &domain, &piece);
        Self { family, domain, piece, signs, is_bound: false }
    }

    /// On the values that count, if they are the image of a box of which a parameter is a variable; and this with its range
    /// there.
    fn on_piece(family: &'f Family, shape: &Parameter) -> Option<(Self, Parameter)> {
        let Ok([piece]) = <[Piece; 1]>::try_from(family.pieces(&[], &[shape.var], false)) else {
            return None;
        };
        if !piece.is_exact() || piece.steps.iter().any(|(var, _)| *var == shape.var) {
            return None;
        }
        let mut domain = piece.domain();
        domain.simplices = family.points().simplices;
        let range = domain.region.range(shape.var);
        let signs = function_signs(family, &domain, &piece);
        let shape = Parameter { range, ..shape.clone() };
        Some((Self { family, domain, piece, signs, is_bound: true }, shape))
    }

    /// Where a shape parameter may be.
    fn range(&self, shape: &Parameter) -> NonnegativeRange {
        let (ranges, remark) = self.parts(shape);
        NonnegativeRange { name: shape.name.clone(), ranges, remark }
    }

    fn parts(&self, shape: &Parameter) -> (Vec<String>, Option<String>) {
        let family = self.family;
        let Signs { numerators, denominators, region } = &self.signs;
        let name = &shape.name;
        let open = |remark: String| (Vec::new(), Some(remark));
        // Beyond its declared range there may be no angle; there is a domain as long as its width is positive.
        let of_domain = |a: &Angle| a.low.depends_on(shape.var) || a.width.depends_on(shape.var);
        let of_angle = |a: &Angle| a.var == shape.var || a.kind != Kind::Linear && of_domain(a);
        let angles = &family.analytic.angles;
        let bound = self.is_bound || angles.iter().any(of_angle);
        let widths = angles.iter().filter(|a| !bound && of_domain(a));
        let widths = widths.flat_map(|a| [a.width.numer(), a.width.denom(), a.low.denom()]);
        let mut budget = Budget::scaled(family.budget);
        let defined = denominators.iter().chain(widths).map(|d| with_simple_zeros(region, d));
        let Some(defined) = defined.collect::<Option<Vec<_>>>() else {
            return open(String::from("undecided: the denominators are too large"));
        };
        let poles = match largest_range(&defined, shape.var, region, &mut budget) {
            LargestRange::Between(low, high) => (low, high),
            _ => (None, None),
        };
        let text = |part: &Part| {
            if bound { within(family, part, shape) } else { range_text(name, part, &poles) }
        };
        let all = [&numerators[..], &defined].concat();
        match largest_range(&all, shape.var, region, &mut budget) {
            LargestRange::Between(low, high) => {
                let part = (low, high);
                let range = text(&part);
                if self.is_nonnegative(shape, &part) {
                    let may_be_larger = bound && !self.is_bound && !ends_as_declared(&part, &shape.range);
                    (vec![range], may_be_larger.then(|| String::from(DECLARED)))
                } else {
                    open(format!("undecided: {range} could not be proved to be enough"))
                }
            }
            LargestRange::Negative => match nonnegative_parts(&all, shape.var, region, &mut budget) {
                Ok(mut parts) => {
                    parts.retain(|part| meets(part, &shape.range));
                    if parts.is_empty() {
                        return open(format!("{NEGATIVE}, whatever {name} is in its range"));
                    }
                    (parts.mapped(text), Some(String::from(NEGATIVE)))
                }
                Err(left) => open(format!("{NEGATIVE}; where not is undecided: {left}")),
            },
            LargestRange::Undecided(left) => open(format!("undecided: {left}")),
        }
    }

    /// Whether it is proved that all functions are ≥ 0 where a shape parameter is between two ends; of an irrational end,
    /// up to a rational number next to it.
    fn is_nonnegative(&self, shape: &Parameter, (low, high): &Part) -> bool {
        let end = |c: &Option<Coordinate>, upper: bool| match c {
            None => End::Infinite,
            Some(Coordinate::Rational(x)) => End::Included(x.clone()),
            Some(Coordinate::Algebraic(x)) => {
                End::Included(if upper { x.low().clone() } else { x.high().clone() })
            }
        };
        let mut domain = self.domain.clone();
        let (low, high) = (end(low, false), end(high, true));
        let range = if self.is_bound { narrowed(&shape.range, low, high) } else { Range { low, high } };
        domain.region = with(&domain.region, shape.var, range);
        let domain = Rc::new(domain);
        self.family.functions.iter().all(|f| {
            let Some(value) = self.piece.pull_back_fraction(&f.value) else { return false };
            let sign = Statement::Sign { value, relation: Relation::NonNegative, domain: Rc::clone(&domain) };
            decide(sign, &Vec::new(), self.family.budget).is_ok()
        })
    }
}

/// For each shape parameter the declared range, with a remark, if all functions are nonnegative on it.
fn nonnegative_as_declared(family: &Family, proved: &str) -> Vec<NonnegativeRange> {
    let (is_proved, remark) = match super::verdict(family, ClaimKind::Nonnegative) {
        Verdict::Proved(_) => (true, proved),
        Verdict::Refuted(_) => (false, NEGATIVE),
        Verdict::Undecided(_) => (false, "undecided"),
    };
    let range = |shape: &Parameter| NonnegativeRange {
        name: family.name_of(shape).to_owned(),
        ranges: if is_proved { vec![declared(family, shape)] } else { Vec::new() },
        remark: Some(String::from(remark)),
    };
    family.shapes.iter().map(range).collect()
}

/// Whether a closed range has a point in a declared one.
fn meets((low, high): &Part, declared: &Range) -> bool {
    let end = |c: &Option<Coordinate>, upper: bool| match c {
        None => End::Infinite,
        Some(Coordinate::Rational(x)) => End::Included(x.clone()),
        Some(Coordinate::Algebraic(x)) => End::Included(if upper { x.high() } else { x.low() }.clone()),
    };
    let (low, high) = (end(low, false), end(high, true));
    let apart = |below: &End, above: &End| match (below.value(), above.value()) {
        (Some(a), Some(b)) => a < b || a == b && !(below.is_included() && above.is_included()),
        _ => false,
    };
    !apart(&high, &declared.low) && !apart(&declared.high, &low)
}

/// Whether a range has the ends of a declared one.
fn ends_as_declared((low, high): &Part, declared: &Range) -> bool {
    let same = |own: &Option<Coordinate>, end: &End| match own {
        None => end.value().is_none(),
        Some(Coordinate::Rational(x)) => end.value() == Some(x),
        Some(Coordinate::Algebraic(_)) => false,
    };
    same(low, &declared.low) && same(high, &declared.high)
}

/// The part of a range that is declared, such as `0 < h`.
fn within(family: &Family, (low, high): &Part, shape: &Parameter) -> String {
    let beyond = |c: &Coordinate, end: &End, wanted: Ordering| {
        let order = |x: &Rational| match c {
            Coordinate::Rational(own) => own.cmp(x),
            Coordinate::Algebraic(own) => own.compare(x),
        };
        end.value().is_none_or(|x| order(x) == wanted)
    };
    let low = low.as_ref().filter(|c| beyond(c, &shape.range.low, Ordering::Greater));
    let high = high.as_ref().filter(|c| beyond(c, &shape.range.high, Ordering::Less));
    if low.is_none() && high.is_none() {
        return declared(family, shape);
    }
    let name = &family.names[shape.var.0];
    let text = |own: Option<&Coordinate>, end: &End| {
        let sign = if own.is_some() || end.is_included() { "<=" } else { "<" };
        let value = own.map(|c| end_text(name, c)).or_else(|| end.value().map(Rational::to_string));
        value.map(|value| (value, sign))
    };
    let (low, high) = (text(low, &shape.range.low), text(high, &shape.range.high));
    if let (Some((a, _)), Some((b, _))) = (&low, &high)
        && a == b
    {
        return format!("{name} = {a}");
    }
    let low = low.map_or_else(String::new, |(value, sign)| format!("{value} {sign} "));
    let high = high.map_or_else(String::new, |(value, sign)| format!(" {sign} {value}"));
    format!("{low}{name}{high}")
}

/// A declared range, `every λ` where there are no ends.
fn declared(family: &Family, shape: &Parameter) -> String {
    if shape.range == Range::all() { format!("every {}", shape.name) } else { family.declared(shape) }
}

/// The end of a range, in brackets where it is longer than a number.
fn end_text(name: &str, c: &Coordinate) -> String {
    match c {
        Coordinate::Rational(x) => x.to_string(),
        Coordinate::Algebraic(x) => match x.reading(name) {
            root if root.contains(' ') => format!("({root})"),
            root => root,
        },
    }
}

/// The numbers of a range that lie between two others.
fn narrowed(range: &Range, low: End, high: End) -> Range {
    let narrower = |declared: &End, own: End, inside: Ordering| match (declared.value(), own.value()) {
        (Some(a), Some(b)) if b.cmp(a) == inside => own,
        (None, Some(_)) => own,
        _ => declared.clone(),
    };
    Range {
        low: narrower(&range.low, low, Ordering::Greater),
        high: narrower(&range.high, high, Ordering::Less),
    }
}

/// `-3 <= λ <= 1`; ends at which a denominator vanishes are left out.
fn range_text(name: &str, (low, high): &Part, poles: &Part) -> String {
    let end = |c: &Coordinate| end_text(name, c);
    if let (Some(Coordinate::Rational(a)), Some(Coordinate::Rational(b))) = (low, high)
        && a == b
    {
        return format!("{name} = {a}");
    }
    let sign =
        |end: &Coordinate, pole: &Option<Coordinate>| if Some(end) == pole.as_ref() { "<" } else { "<=" };
    let low = low.as_ref().map_or_else(String::new, |c| format!("{} {} ", end(c), sign(c, &poles.0)));
    let high = high.as_ref().map_or_else(String::new, |c| format!(" {} {}", sign(c, &poles.1), end(c)));
    if low.is_empty() && high.is_empty() { format!("every {name}") } else { format!("{low}{name}{high}") }
}

/// A polynomial with the zeros of a denominator, each of them a change of sign, positive on the declared ranges; `None`
/// when the denominator is too large.
fn with_simple_zeros(region: &Region, denom: &Poly) -> Option<Poly> {
    let parts = square_free(denom, &mut Work::new(DENOMINATORS))?;
    let product = parts.iter().fold(Poly::one(), |product, (p, _)| &product * p);
    let inner = |range: &Range| simplest_between(range.low.value(), range.high.value());
    Some(if sign_at(&product, region, &inner) < 0 { -&product } else { product })
}

/// The sign of a polynomial at a point of a box, which has a coordinate in each range.
fn sign_at(p: &Poly, region: &Region, coordinate: &dyn Fn(&Range) -> Rational) -> i32 {
    let value = region.ranges.iter().fold(p.clone(), |p, (var, range)| p.at(*var, &coordinate(range)));
    value.as_constant().map_or(0, |c| c.signum())
}

/// Polynomials that decide the signs of functions.
struct Signs {
    /// With the signs of the functions.
    numerators: Vec<Poly>,
    /// The denominators that are no numbers, each once.
    denominators: Vec<Poly>,
    /// The box on which to look at them.
    region: Region,
}

/// The signs of all functions on a domain, whose variables are those of a box.
fn function_signs(family: &Family, domain: &Domain, piece: &Piece) -> Signs {
    let (mut numerators, mut denominators) = (Vec::new(), Vec::new());
    let mut region = domain.region.clone();
    for f in &family.functions {
        let Some(value) = piece.pull_back_fraction(&f.value) else { continue };
        let (numer, denom) = (&value.numerator, &value.denominator);
        let Ok(chart) = Chart::new(domain, [numer, denom]) else { continue };
        region = chart.region().clone();
        let below = pull_back(&chart, denom);
        let signed = if sign_at(&below, &region, &typical) < 0 { -numer } else { numer.clone() };
        numerators.push(pull_back(&chart, &signed));
        if below.as_constant().is_none() && !denominators.contains(&below) {
            denominators.push(below);
        }
    }
    Signs { numerators, denominators, region }
}
