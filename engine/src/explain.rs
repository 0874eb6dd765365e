//! What follows from the formulas of a family, apart from its claims: factored and expanded forms, and what its curves
//! do at their ends.

mod contacts;
mod extrema;
mod matrices;
mod reading;
mod theorems;

pub use contacts::{Contact, contacts};
pub use extrema::{AllExtrema, Extrema, Extremum, Locus, LocusKind, extrema};
pub use matrices::{Matrix, MatrixKind, conversions, matrices, matrices_left_out};
pub use theorems::determined_points;

use std::rc::Rc;

use basis_kernel::{Chart, Relation, Statement, Values, with};
use basis_prover::range::{LargestRange, Part, largest_range, nonnegative_parts};
use basis_prover::rank::{Exceptional, ExceptionalSet};
use basis_prover::{Budget, Coordinate, decide, pull_back, typical};

use crate::algebra::divisors::gcd::{gcd, split_monomial, square_free};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{DisplayRange as _, End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_between;
use crate::algebra::work::Work;
use crate::claim::{self, Claim, ClaimKind, Expected};
use crate::generate::{factored, factored_on_box};
use crate::model::chart::Constraint;
use crate::model::{Family, Function, Parameter};
use crate::plan::interval::form::IntervalForm;
use crate::plan::patch::form::{PatchForm, factored_text};
use crate::state::Verdict;
use crate::{rounding, state};

/// The work for the factors of denominators.
const DENOMINATORS: u64 = 1_000_000;

/// One function in its two forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// The name, such as `b[1]`.
    pub label: String,
    /// As a product; the powers of the distances to the ends of an interval and the faces of a box are factors, on a
    /// simplex those of the coordinates.
    pub factored: String,
    /// Expanded into monomials.
    pub expanded: String,
}

/// The formulas of a family.
pub fn formulas(family: &Family) -> Vec<Formula> {
    if !family.analytic.is_empty() {
        let functions = family.functions.iter().enumerate();
        return functions
            .map(|(k, f)| Formula {
                label: family.function_label(k),
                factored: reading::factored(family, &f.value),
                expanded: reading::expanded(family, &f.value),
            })
            .collect();
    }
    let form = IntervalForm::new(family);
    let patch = if form.is_none() { PatchForm::new(family) } else { None };
    family
        .functions
        .iter()
        .enumerate()
        .map(|(k, f)| {
            let expanded = f.value.display(&family.names);
            let factored = match (&form, &patch) {
                (Some(form), _) => factored(family, form, &form.functions[k]),
                (_, Some(form)) if family.is_simplex() => factored_text(family, &form.functions[k], form),
                (_, Some(form)) => factored_on_box(family, form, &form.functions[k]),
                _ => expanded.clone(),
            };
            Formula { label: family.function_label(k), factored, expanded }
        })
        .collect()
}

/// The derivatives of a curve `C = Σ b[i] P[i]` at both ends of an interval as combinations of the control points, such
/// as `C'(0) = (3 + λ)*(-P[0] + P[1])`, for the orders 0 to `order`; empty on other domains.
pub fn end_derivatives(family: &Family, order: u32) -> Vec<(String, String)> {
    let Some((_, low, high)) = family.interval() else { return Vec::new() };
    let mut lines = Vec::new();
    let inside = |end: &Rational| family.domain.iter().all(|p| p.range.contains(end));
    let Some(texts) = family.end_texts() else { return lines };
    let ends = [(low, false), (high, true)].into_iter().zip(texts);
    for ((_, upper), end_text) in ends.filter(|((end, _), _)| inside(end)) {
        // A denominator vanishes nowhere on the domain.
        let derivatives = |f: &Function| {
            let all = family.derivatives_at_end(&f.value, order, upper, &mut Work::unlimited());
            all.unwrap_or_default()
        };
        let by_function: Vec<Vec<Fraction>> = family.functions.iter().map(derivatives).collect();
        for order in 0..=order {
            let weight =
                |all: &Vec<Fraction>| all.get(order as usize).cloned().unwrap_or_else(Fraction::zero);
            let weights: Vec<Fraction> = by_function.iter().map(weight).collect();
            let name = match order {
                0..=3 => format!("C{}({end_text})", "'".repeat(order as usize)),
                _ => format!("C^({order})({end_text})"),
            };
            lines.push((name, combination(family, &weights)));
        }
    }
    lines
}

/// A value as a formula of the language.
pub(crate) fn written(family: &Family, value: &Fraction) -> String {
    if family.analytic.is_empty() { value.display(&family.names) } else { reading::expanded(family, value) }
}

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

/// For each shape parameter the largest range around its declared one on which all functions stay nonnegative, the
/// other parameters on their declared ranges.
///
/// Where a denominator vanishes the range ends, too, and does not contain its end. When a function is negative
/// somewhere on the declared ranges, the largest ranges that meet the declared one.
///
/// Where a function contains π, or a variable beside its sine, nothing is said of values beyond the declared ranges.
pub fn nonnegative_ranges(family: &Family) -> Vec<NonnegativeRange> {
    let dependent = family.analytic.dependent();
    if family.functions.iter().any(|f| dependent.iter().any(|v| f.value.depends_on(*v))) {
        return nonnegative_as_declared(family);
    }
    let Signs { numerators: polys, denominators, region } = function_signs(family);
    let range = |shape: &Parameter| {
        let name = &shape.name;
        let open = |remark: String| (Vec::new(), Some(remark));
        // Beyond its declared range there may be no domain, or no angle.
        let bound = family
            .analytic
            .angles
            .iter()
            .any(|a| a.var == shape.var || a.low.depends_on(shape.var) || a.width.depends_on(shape.var));
        let mut budget = Budget::scaled(family.budget);
        let Some(defined) =
            denominators.iter().map(|d| with_simple_zeros(&region, d)).collect::<Option<Vec<_>>>()
        else {
            return open(String::from("undecided: the denominators are too large"));
        };
        let poles = match largest_range(&defined, shape.var, &region, &mut budget) {
            LargestRange::Between(low, high) => (low, high),
            _ => (None, None),
        };
        let all = [&polys[..], &defined].concat();
        match largest_range(&all, shape.var, &region, &mut budget) {
            LargestRange::Between(low, high) => {
                let part = (low.clone(), high.clone());
                let range =
                    if bound { within(family, &part, shape) } else { range_text(name, &part, &poles) };
                if is_nonnegative(family, shape, &(low, high)) {
                    (vec![range], None)
                } else {
                    open(format!("undecided: {range} could not be proved to be enough"))
                }
            }
            LargestRange::Negative => {
                let negative = String::from("a function is negative somewhere on the declared ranges");
                match nonnegative_parts(&all, shape.var, &region, &mut budget) {
                    Ok(mut parts) => {
                        parts.retain(|part| meets(part, &shape.range));
                        if parts.is_empty() {
                            return open(format!("{negative}, whatever {name} is in its range"));
                        }
                        let text = |part: &Part| {
                            if bound { within(family, part, shape) } else { range_text(name, part, &poles) }
                        };
                        (parts.iter().map(text).collect(), Some(negative))
                    }
                    Err(left) => open(format!("{negative}; where not is undecided: {left}")),
                }
            }
            LargestRange::Undecided(left) => open(format!("undecided: {left}")),
        }
    };
    let all = family.shapes.iter().map(|shape| {
        let (ranges, remark) = range(shape);
        NonnegativeRange { name: shape.name.clone(), ranges, remark }
    });
    all.collect()
}

/// For each shape parameter the declared range, if all functions are nonnegative on it.
fn nonnegative_as_declared(family: &Family) -> Vec<NonnegativeRange> {
    let (declared, remark) = match verdict(family, ClaimKind::Nonnegative) {
        Verdict::Proved(_) => (true, "as declared; no other values were looked at"),
        Verdict::Refuted(_) => (false, "a function is negative somewhere on the declared ranges"),
        Verdict::Undecided(_) => (false, "undecided"),
    };
    let range = |shape: &Parameter| NonnegativeRange {
        name: family.name_of(shape).to_owned(),
        ranges: if declared { vec![family.declared(shape)] } else { Vec::new() },
        remark: Some(String::from(remark)),
    };
    family.shapes.iter().map(range).collect()
}

/// What a claim about a family comes to that no statement makes.
fn verdict(family: &Family, kind: ClaimKind) -> Verdict {
    let nothing: Rc<str> = "".into();
    let statement = claim::Statement { number: (0, 0), text: Rc::clone(&nothing), range: nothing };
    let claim = Claim {
        text: String::new(),
        doc: Vec::new(),
        expected: Expected::True,
        place: family.place.clone(),
        statement,
        kind,
        about: None,
    };
    state::of_family(family, &claim)
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

/// The part of a range that is declared, such as `0 < h`.
fn within(family: &Family, (low, high): &Part, shape: &Parameter) -> String {
    let closed = |c: &Option<Coordinate>| match c {
        Some(Coordinate::Rational(x)) => Some(x.clone()),
        _ => None,
    };
    let narrower =
        |declared: &End, own: Option<Rational>, inside: core::cmp::Ordering| match (declared.value(), own) {
            (Some(a), Some(b)) if b.cmp(a) == inside => End::Included(b),
            (None, Some(b)) => End::Included(b),
            _ => declared.clone(),
        };
    let low = narrower(&shape.range.low, closed(low), core::cmp::Ordering::Greater);
    let high = narrower(&shape.range.high, closed(high), core::cmp::Ordering::Less);
    let range = Range { low, high };
    if range == shape.range {
        family.declared(shape)
    } else {
        range.display(&family.names[shape.var.0]).to_string()
    }
}

/// `-3 <= λ <= 1`; ends at which a denominator vanishes are left out.
fn range_text(name: &str, (low, high): &Part, poles: &Part) -> String {
    let end = |c: &Coordinate| match c {
        Coordinate::Rational(x) => x.to_string(),
        Coordinate::Algebraic(x) => match x.reading(name) {
            root if root.contains(' ') => format!("({root})"),
            root => root,
        },
    };
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

fn function_signs(family: &Family) -> Signs {
    let domain = family.points();
    let (mut numerators, mut denominators) = (Vec::new(), Vec::new());
    let mut region = domain.region.clone();
    for f in &family.functions {
        let (numer, denom) = (f.value.numer(), f.value.denom());
        let Ok(chart) = Chart::new(&domain, [numer, denom]) else { continue };
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

/// Whether it is proved that all functions are ≥ 0 where a shape parameter is between two ends; of an irrational end,
/// up to a rational number next to it.
fn is_nonnegative(family: &Family, shape: &Parameter, (low, high): &Part) -> bool {
    let end = |c: &Option<Coordinate>, upper: bool| match c {
        None => End::Infinite,
        Some(Coordinate::Rational(x)) => End::Included(x.clone()),
        Some(Coordinate::Algebraic(x)) => {
            End::Included(if upper { x.low().clone() } else { x.high().clone() })
        }
    };
    let mut domain = family.points();
    let range = Range { low: end(low, false), high: end(high, true) };
    domain.region = with(&domain.region, shape.var, range);
    let domain = Rc::new(domain);
    family.functions.iter().all(|f| {
        let (value, domain) = (f.value.quotient(), Rc::clone(&domain));
        let sign = Statement::Sign { value, relation: Relation::NonNegative, domain };
        decide(sign, &Vec::new(), family.budget).is_ok()
    })
}

/// The work for the shape values at which functions are dependent, of which each is looked for with a budget of its own.
const EXCEPTIONS: u64 = 20_000_000;

/// The shape values at which the functions of a family are dependent, and what is left open: nothing only if it is
/// proved that they are independent everywhere else.
pub fn exceptional_set(family: &Family) -> ExceptionalSet {
    let units = EXCEPTIONS.saturating_mul(u64::from(family.budget));
    basis_prover::within(units, &mut || exceptions(family))
}

fn exceptions(family: &Family) -> ExceptionalSet {
    let state::Table { rows, symmetries } = state::table(family);
    let table = basis_prover::rank::Table { rows: &rows, symmetries: &symmetries };
    let mut set = basis_prover::rank::exceptional_set(table, &family.shape_region(), family.budget);
    set.exceptions.retain(|e| !is_ruled_out(family, &e.values));
    let dependent = family.analytic.dependent();
    if rows.iter().flatten().any(|p| dependent.iter().any(|v| p.depends_on(*v))) {
        // Where an angle and its tangent have values that do not belong together nothing is said.
        set.exceptions.retain(|e| !e.values.iter().any(|(var, _)| dependent.contains(var)));
        let value = |(var, c): &(Var, Coordinate)| match c {
            Coordinate::Rational(x) => Some((*var, x.clone())),
            Coordinate::Algebraic(_) => None,
        };
        let except: Vec<Option<Values>> =
            set.exceptions.iter().map(|e| e.values.iter().map(value).collect()).collect();
        let except: Option<Vec<Values>> = except.into_iter().collect();
        set.open = except.map_or_else(|| Some(String::from(OTHERS)), |except| open_besides(family, except));
        return set;
    }
    let mut except = Vec::new();
    let mut rational = !set.exceptions.iter().any(|e| e.values.is_empty());
    for exception in &set.exceptions {
        let mut values = Vec::new();
        for (var, c) in &exception.values {
            match c {
                Coordinate::Rational(x) => values.push((*var, x.clone())),
                Coordinate::Algebraic(_) => rational = false,
            }
        }
        except.push(values);
    }
    if rational && !family.constraints.is_empty() {
        // On the whole box the functions may be dependent where what is assumed is false.
        set.open = open_besides(family, except);
    } else if rational && set.open.is_none() {
        let statement = Statement::Independent { rows, except, region: family.shape_region() };
        if decide(statement, &symmetries, family.budget).is_err() {
            set.open = Some(String::from(OTHERS));
        }
    }
    set
}

/// What is left open of exceptions that may not be all.
const OTHERS: &str = "it is not proved that there are no others";

/// What is left open where functions are said to be independent but for these exceptions.
fn open_besides(family: &Family, except: Vec<Values>) -> Option<String> {
    match verdict(family, ClaimKind::Independent(except)) {
        Verdict::Proved(_) => None,
        _ => Some(String::from(OTHERS)),
    }
}

/// Whether a condition in which only these shape parameters occur is false at their values.
fn is_ruled_out(family: &Family, values: &[(Var, Coordinate)]) -> bool {
    let put = |p: &Poly| {
        values.iter().fold(p.clone(), |p, (var, c)| match c {
            Coordinate::Rational(x) => p.at(*var, x),
            Coordinate::Algebraic(_) => p,
        })
    };
    let fails = |c: &Constraint| put(&c.value).as_constant().is_some_and(|x| !c.relation.holds(&x));
    family.constraints.iter().any(fails)
}

/// What an element of the exceptional set says, such as `λ = -3: b[1] - b[2] = 0`.
pub fn describe_exception(family: &Family, exception: &Exceptional) -> String {
    let values: Vec<String> = exception.values.iter().map(|(v, c)| c.describe(&family.names[v.0])).collect();
    let at = if values.is_empty() { String::from("all shape values") } else { values.join(", ") };
    let Some(combination) = &exception.combination else { return at };
    let fixed = |p: &Poly| {
        exception.values.iter().fold(p.clone(), |p, (v, c)| match c {
            Coordinate::Rational(x) => p.at(*v, x),
            Coordinate::Algebraic(_) => p,
        })
    };
    let scaled: Vec<Poly> =
        combination.iter().enumerate().map(|(k, c)| c * &fixed(&family.numerator_factor(k))).collect();
    format!("{at}: {} = 0", state::combination_text(family, &scaled))
}

/// Σ weight·P[i] with common factors taken out, if they are polynomials in the shape parameters.
fn combination(family: &Family, weights: &[Fraction]) -> String {
    let numbers = family.analytic.numbers();
    if family.analytic.is_transcendental() || numbers.iter().any(|v| weights.iter().any(|w| w.depends_on(*v)))
    {
        let separate = separate(family, weights);
        let angles = |w: &Fraction| family.analytic.angles.iter().any(|a| w.depends_on(a.var));
        let is_pi = |v: &Var| Some(*v) == family.analytic.pi;
        let other = |w: &Fraction| numbers.iter().any(|v| !is_pi(v) && w.depends_on(*v));
        if weights.iter().any(|w| angles(w) || other(w)) {
            return separate;
        }
        let common = over_one_denominator(family, weights);
        return if common.chars().count() < separate.chars().count() { common } else { separate };
    }
    over_one_denominator(family, weights)
}

/// Σ weight·P[i], the common factors of the weights before it.
fn over_one_denominator(family: &Family, weights: &[Fraction]) -> String {
    // Over one denominator.
    let mut denom = Poly::one();
    for w in weights {
        let common = gcd(&denom, w.denom());
        // The common divisor divides both.
        denom = &denom * &w.denom().div_exact(&common).unwrap_or_else(Poly::one);
    }
    let numers: Vec<Poly> =
        weights.iter().map(|w| &denom.div_exact(w.denom()).unwrap_or_else(Poly::one) * w.numer()).collect();
    let content = numers.iter().fold(Rational::ZERO, |g, p| g.gcd(&p.numeric_content()));
    let mut common = numers.iter().fold(Poly::zero(), |g, p| gcd(&g, p));
    if common.is_zero() {
        return String::from("0");
    }
    common = common.normalized().scale(&content);
    if common.display(&family.names).to_string().starts_with('-') {
        common = -&common;
    }
    let mut text = String::new();
    for (k, numer) in numers.iter().enumerate() {
        let weight = numer.div_exact(&common).unwrap_or_else(Poly::zero);
        if weight.is_zero() {
            continue;
        }
        let point = point(family, k);
        let negative = weight.display(&family.names).to_string().starts_with('-');
        let magnitude = if negative { -&weight } else { weight };
        text += match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        text += &match magnitude.len() {
            _ if magnitude.is_one() => point,
            1 => format!("{}*{point}", magnitude.display(&family.names)),
            _ => format!("({})*{point}", magnitude.display(&family.names)),
        };
    }
    let single = numers.iter().filter(|p| !p.is_zero()).count() == 1;
    let factor = factor(&common, &denom, &family.names);
    match factor.as_str() {
        "1" => text,
        _ if single => match text.strip_prefix('-') {
            Some(text) => format!("-{factor}*{text}"),
            None => format!("{factor}*{text}"),
        },
        _ => format!("{factor}*({text})"),
    }
}

/// Σ weight·P[i], each weight for itself.
fn separate(family: &Family, weights: &[Fraction]) -> String {
    let mut text = String::new();
    for (k, weight) in weights.iter().enumerate().filter(|(_, weight)| !weight.is_zero()) {
        let of = reading::as_factor(family, weight);
        let (negative, of) = of.strip_prefix('-').map_or((false, of.as_str()), |of| (true, of));
        text += match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let point = point(family, k);
        text += &if of == "1" { point } else { format!("{of}*{point}") };
    }
    if text.is_empty() { String::from("0") } else { text }
}

/// The control point of a function, such as `P[2]`.
fn point(family: &Family, k: usize) -> String {
    format!("P[{}]", family.functions[k].index.iter().map(i64::to_string).collect::<Vec<_>>().join(","))
}

/// A common factor for reading.
fn factor(numer: &Poly, denom: &Poly, names: &[String]) -> String {
    let bracket = |p: &Poly| {
        let content = p.numeric_content();
        let (monomial, rest) = split_monomial(&p.scale(&content.recip().unwrap_or(Rational::ONE)));
        if rest.as_constant().is_some() {
            return p.display(names).to_string();
        }
        let single = Poly::from_terms([(monomial, content)]);
        if single.is_one() {
            return format!("({})", rest.display(names));
        }
        format!("{}*({})", single.display(names), rest.display(names))
    };
    let below = bracket(denom);
    let below = if below.contains('*') && !below.starts_with('(') { format!("({below})") } else { below };
    if denom.is_one() { bracket(numer) } else { format!("{}/{below}", bracket(numer)) }
}

/// Proved bounds of the rounding errors of the values, and of a point of a curve or patch, each with what it is about;
/// nothing for families for which no code can be generated.
///
/// ε is the distance from 1 to the next float. Functions with the same bound share a line.
pub fn rounding(family: &Family) -> Vec<(String, String)> {
    let errors = state::value_errors(family)
        .into_iter()
        .map(|known| known.map(|(error, _)| error))
        .collect::<Vec<_>>();
    let mut lines = rounding::grouped(&errors, family, "no bound found");
    if let Some((error, _)) = state::point_error(family) {
        let text = format!("{error} times the largest control point, in each coordinate");
        lines.push((state::point_name(family), text));
    }
    lines
}
