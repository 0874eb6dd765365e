//! What follows from the formulas of a family, apart from its claims: factored and expanded forms, and what its curves
//! do at their ends.

mod contacts;
mod definitions;
mod dependence;
mod extrema;
mod matrices;
mod nonnegative;
mod reading;
mod shape_values;
mod theorems;

pub use contacts::{Contact, contacts};
pub use definitions::definitions;
pub use dependence::{Dependence, dependence, describe_exception, exceptional_set};
pub use extrema::{AllExtrema, Extrema, Extremum, Locus, LocusKind, extrema};
pub use matrices::{Matrix, MatrixKind, conversions, matrices, matrices_left_out, matrices_of_whole_domain};
pub use nonnegative::{NonnegativeRange, nonnegative_ranges};
pub use theorems::determined_points;

use std::rc::Rc;

use crate::algebra::divisors::gcd::{gcd, split_monomial};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{self, Claim, ClaimKind, Expected};
use crate::generate::{factored, factored_on_box};
use crate::model::{Family, Function};
use crate::plan::interval::form::IntervalForm;
use crate::plan::patch::form::{PatchForm, factored_text};
use crate::state::Verdict;
use crate::{rounding, state};

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
    if denom.display(&family.names).to_string().starts_with('-') {
        denom = -&denom;
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

/// Proved bounds of the rounding errors of the values, and of a point of a curve or patch, each with what it is about,
/// or why there is none; nothing for families for which no code can be generated.
///
/// ε is the distance from 1 to the next float. Functions with the same bound share a line.
pub fn rounding(family: &Family) -> Vec<(String, String)> {
    let errors = state::value_errors(family)
        .into_iter()
        .map(|known| known.map(|(error, _)| error))
        .collect::<Vec<_>>();
    let groups = rounding::grouped(&errors, family, &|k| rounding::advice(family, Some(k)));
    let mut lines = groups.into_iter().map(|group| (group.labels, group.text)).collect::<Vec<_>>();
    match state::point_error(family) {
        Some((error, _)) => {
            let text = format!("{error} times the largest control point, in each coordinate");
            lines.push((state::point_name(family), text));
        }
        None if !errors.is_empty() => lines.push((state::point_name(family), rounding::advice(family, None))),
        None => {}
    }
    lines
}
