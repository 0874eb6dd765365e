//! What holds of a family: its functions in all their forms, and the claims that could be made of it.

use core::ops::Range;

use basis_prover::Coordinate;
use basis_prover::collections::sort::sort_by_key;
use basis_prover::rank::ExceptionalSet;

use super::document::Document;
use super::lex::tokens;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::diagnostic::Place;
use crate::explain::{exceptional_set, formulas, written};
use crate::model::{Family, Function, Library, Selected};
use crate::plan::interval::form::IntervalForm;
use crate::source::{Files, Source};
use crate::state::{Prover, Run, Verdict};
use crate::subject::{Item, Subject};

/// One function of a family in all its forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FunctionFacts {
    /// The name, such as `b[1]`.
    pub label: String,
    /// As a product.
    pub factored: String,
    /// Expanded into monomials.
    pub expanded: String,
    /// On an interval, the coefficients in the Bernstein basis of the family's degree.
    pub bernstein: Vec<String>,
    /// Numbers between which all values lie, the least and the largest of these coefficients; only where they contain no
    /// shape parameter.
    pub between: Option<(String, String)>,
}

/// The functions of a family in all their forms.
pub fn function_facts(family: &Family) -> Vec<FunctionFacts> {
    let polynomial = !family.is_rational() && family.analytic.is_empty();
    let form = IntervalForm::new(family).filter(|_| polynomial);
    let facts = formulas(family).into_iter().enumerate().map(|(k, formula)| {
        let (mut bernstein, mut between) = (Vec::new(), None);
        let own = |form: &IntervalForm| Some((form.var, form.functions.get(k)?.clone()));
        if let Some((var, f)) = form.as_ref().and_then(own)
            && !f.denom.depends_on(var)
            && family.analytic.is_empty()
        {
            let over = |p: &Poly| Fraction::new(p.clone(), f.denom.clone());
            let coefficients: Vec<Fraction> = f.bernstein.iter().filter_map(over).collect();
            bernstein = coefficients.iter().map(|c| c.display(&family.names)).collect();
            let numbers: Option<Vec<Rational>> = coefficients.iter().map(Fraction::as_constant).collect();
            between = numbers.and_then(|numbers| {
                Some((numbers.iter().min()?.to_string(), numbers.iter().max()?.to_string()))
            });
        }
        let crate::explain::Formula { label, factored, expanded } = formula;
        FunctionFacts { label, factored, expanded, bernstein, between }
    });
    facts.collect()
}

/// A claim that is proved and that a spec does not make yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Holds {
    /// The statement, such as `prove symmetric;`, over several lines where it has a block.
    pub statement: String,
}

/// Claims that hold of a family of a spec, in all its orders, and that the spec does not make: those about the whole
/// family, values and derivatives at the ends of an interval, and shape values at which it is a Bernstein basis.
///
/// Each of them is written into the spec and decided as if its author had written it; what is not proved is left out.
/// Nothing holds of a family with errors.
pub fn claims_that_hold(files: &dyn Files, source: &Source, name: &str) -> Vec<Holds> {
    let Some(text) = source.text.as_deref() else { return Vec::new() };
    let document = Document::new(text);
    let entry = document.entries.iter().find(|e| {
        e.title == name && e.symbol.is_some_and(|s| document.symbols[s].kind == super::SymbolKind::Family)
    });
    let Some((entry, body)) = entry.and_then(|e| Some((e, e.body.clone()?))) else { return Vec::new() };
    let families = |source: &Source| -> Vec<_> {
        let library = Library::from_source(files, &Prover, source.clone());
        let items = library.items(Selected::EveryOrder).into_iter();
        items.filter(|item| item.subject.name() == name && item.subject.kind() == "family").collect()
    };
    let Some(Subject::Family(family)) = families(source).first().map(|item| item.subject.clone()) else {
        return Vec::new();
    };
    let made: Vec<String> = entry.children.iter().map(|c| squeezed(document.slice(&c.whole))).collect();
    let mut candidates: Vec<Vec<String>> = candidates(&family)
        .into_iter()
        .filter(|c| !c.is_made(&made))
        .map(|c| c.statements(&made))
        .filter(|c| !c.is_empty())
        .collect();
    let write = |candidates: &[Vec<String>]| {
        let (tried, places) = with_statements(source, text, body.end, candidates);
        (families(&tried), places)
    };
    let (mut items, mut places) = write(&candidates);
    let is_read = |items: &[Item], places: &[Range<usize>]| {
        let mut claims = items.iter().flat_map(|item| &item.claims);
        claims.any(|c| matches!(&c.place, Place::Text(_, at) if places.iter().any(|p| p.start <= at.start && at.end <= p.end)))
    };
    if places.iter().any(|own| !is_read(&items, own)) {
        // A claim that has no meaning here, such as `symmetric` on spans that are not, is an error of the family.
        candidates.retain(|candidate| {
            let (items, places) = write(core::slice::from_ref(candidate));
            is_read(&items, &places.concat())
        });
        (items, places) = write(&candidates);
    }
    let run = &mut Run::default();
    let mut fails: Vec<Range<usize>> = Vec::new();
    let mut seen: Vec<Range<usize>> = Vec::new();
    for item in &items {
        for claim in &item.claims {
            let Place::Text(_, place) = &claim.place else { continue };
            let inside = |r: &&Range<usize>| r.start <= place.start && place.end <= r.end;
            let Some(at) = places.iter().flatten().find(inside) else { continue };
            if fails.contains(at) {
                continue;
            }
            seen.push(at.clone());
            if !matches!(run.decide(&item.subject, claim), Verdict::Proved(_)) {
                fails.push(at.clone());
            }
        }
    }
    let mut all = Vec::new();
    for (alternatives, places) in candidates.into_iter().zip(places) {
        // Of several the first one that holds says most.
        let holds = |(_, place): &(String, Range<usize>)| seen.contains(place) && !fails.contains(place);
        if let Some((statement, _)) = alternatives.into_iter().zip(places).find(holds) {
            all.push(Holds { statement });
        }
    }
    all
}

/// A spec with more statements at a place, and where they stand.
fn with_statements(
    source: &Source,
    text: &str,
    end: usize,
    candidates: &[Vec<String>],
) -> (Source, Vec<Vec<Range<usize>>>) {
    let mut longer = text[..end].to_string();
    let mut places = Vec::new();
    for alternatives in candidates {
        let mut own = Vec::new();
        for statement in alternatives {
            longer.push('\n');
            own.push(longer.len()..longer.len() + statement.len());
            longer += statement;
        }
        places.push(own);
    }
    longer.push('\n');
    longer += &text[end..];
    let mut tried = Source::text(source.name.clone(), &longer);
    tried.path.clone_from(&source.path);
    tried.library.clone_from(&source.library);
    (tried, places)
}

/// A statement without white space and comments.
fn squeezed(statement: &str) -> String {
    tokens(statement).iter().filter(|t| !t.is_comment()).map(|t| t.text(statement)).collect()
}

/// Claims that may hold.
enum Candidate {
    /// A claim about the whole family, from the one that says most to the one that says least.
    Property(Vec<String>),
    /// What stands before a block, and the two sides of each of its equations.
    Block(String, Vec<(String, String)>),
}

impl Candidate {
    /// Whether the same property is claimed already, perhaps with other values.
    fn is_made(&self, made: &[String]) -> bool {
        let Self::Property(claims) = self else { return false };
        claims.iter().any(|claim| {
            let word = claim.split(['(', ' ']).next().unwrap_or_default();
            made.iter().any(|m| m.strip_prefix("prove").is_some_and(|m| m.starts_with(word)))
        })
    }

    /// The statements, of which the first one that holds is meant, without equations whose left sides have values already.
    fn statements(self, made: &[String]) -> Vec<String> {
        let (at, mut equations) = match self {
            Self::Property(claims) => return claims.iter().map(|claim| format!("prove {claim};")).collect(),
            Self::Block(at, equations) => (at, equations),
        };
        let head = squeezed(&format!("prove at {at} {{"));
        let blocks: Vec<&str> = made.iter().filter_map(|m| m.strip_prefix(&head)).collect();
        equations.retain(|(left, _)| {
            let start = format!("{}=", squeezed(left));
            !blocks.iter().any(|block| block.split(';').any(|equation| equation.starts_with(&start)))
        });
        match equations.as_slice() {
            [] => Vec::new(),
            [(left, right)] => {
                vec![format!("prove at {at} {{ {left} = {right}; }}")]
            }
            several => {
                let lines: Vec<String> = several.iter().map(|(l, r)| format!("    {l} = {r};\n")).collect();
                vec![format!("prove at {at} {{\n{}}}", lines.concat())]
            }
        }
    }
}

fn candidates(family: &Family) -> Vec<Candidate> {
    let one = |claim: &str| Candidate::Property(vec![claim.to_string()]);
    let mut all = vec![one("partition_of_unity"), one("nonnegative"), one("symmetric")];
    all.push(match independent_claim(family, &exceptional_set(family)) {
        Some(claim) if family.order.is_empty() => one(&claim),
        _ => one("independent"),
    });
    if !family.pieces.is_empty() {
        all.push(Candidate::Property((0..=3).rev().map(|k| format!("smooth({k})")).collect()));
        return all;
    }
    if family.interval().is_some() {
        all.push(Candidate::Property((1..=3).rev().map(|k| format!("continuity({k})")).collect()));
    }
    if family.order.is_empty() {
        all.extend(ends(family));
        all.extend(bernstein_values(family));
    }
    all
}

/// `independent`, or `independent except …` with all exceptions; nothing where these are irrational, or not all known.
pub fn independent_claim(family: &Family, set: &ExceptionalSet) -> Option<String> {
    if set.open.is_some() {
        return None;
    }
    let mut exceptions = Vec::new();
    for exception in &set.exceptions {
        let mut values = Vec::new();
        for (var, value) in &exception.values {
            let Coordinate::Rational(value) = value else { return None };
            values.push(family.shape_value(*var, value));
        }
        match values.as_slice() {
            [] => return None,
            [only] => exceptions.push(only.clone()),
            several => exceptions.push(format!("({})", several.join(", "))),
        }
    }
    if exceptions.is_empty() {
        return Some(String::from("independent"));
    }
    Some(format!("independent except {}", exceptions.join(", ")))
}

/// The work for the derivatives at the ends; formulas that take more are of no use to a reader.
const ENDS: u64 = 2_000_000;

/// The values and the first two derivatives at both ends of an interval, as blocks.
fn ends(family: &Family) -> Vec<Candidate> {
    let (Some((var, ..)), Some(ends)) = (family.interval(), family.end_texts()) else { return Vec::new() };
    if family.leaves_an_end_out() {
        return Vec::new();
    }
    let angle = family.analytic.angle(var);
    let (name, b) = (angle.map_or(&family.names[var.0], |angle| &angle.name), &family.function_name);
    let work = &mut Work::new(ENDS);
    let mut blocks = Vec::new();
    for (upper, end) in [false, true].into_iter().zip(ends) {
        let derivatives = |f: &Function| family.derivatives_at_end(&f.value, 2, upper, work);
        let Some(all) = family.functions.iter().map(derivatives).collect::<Option<Vec<_>>>() else {
            continue;
        };
        let mut lines = Vec::new();
        for order in 0..=2 {
            let text = |all: &Vec<Fraction>| Some(written(family, all.get(order)?));
            let Some(values) = all.iter().map(text).collect::<Option<Vec<_>>>() else { continue };
            let left = match order {
                0 => b.clone(),
                1 => format!("D({b})"),
                _ => format!("D({b}, {order})"),
            };
            lines.push((left, format!("[{}]", values.join(", "))));
        }
        blocks.push(Candidate::Block(format!("{name} = {end}"), lines));
    }
    blocks
}

/// The shape values at which a family on [0, 1] is the Bernstein basis of as many functions.
fn bernstein_values(family: &Family) -> Option<Candidate> {
    let (var, low, high) = family.interval()?;
    if !low.is_zero() || !high.is_one() || family.shapes.is_empty() || !family.analytic.is_empty() {
        return None;
    }
    let degree = family.functions.len().checked_sub(1)? as u32;
    let (t, s) = (Poly::var(var), &Poly::one() - &Poly::var(var));
    // Polynomials in the shape parameters, all of which have to vanish.
    let mut equations: Vec<Poly> = Vec::new();
    for (k, f) in family.functions.iter().enumerate() {
        let k = k as u32;
        let bernstein = (&s.pow(degree - k) * &t.pow(k)).scale(&crate::algebra::number::binomial(degree, k));
        let difference = f.value.numer() - &(&bernstein * f.value.denom());
        equations.extend(difference.coefficients_in(var).into_iter().filter(|p| !p.is_zero()));
    }
    let mut values: Vec<(Var, Rational)> = Vec::new();
    while !equations.is_empty() {
        let (var, value) = equations.iter().find_map(linear)?;
        equations = equations.iter().map(|p| p.at(var, &value)).filter(|p| !p.is_zero()).collect();
        values.push((var, value));
    }
    sort_by_key(&mut values, |(var, _)| var.0);
    let inside = values
        .iter()
        .all(|(var, value)| family.shapes.iter().any(|p| p.var == *var && p.range.contains(value)));
    if !inside || values.is_empty() {
        return None;
    }
    let at: Vec<String> =
        values.iter().map(|(var, value)| format!("{} = {value}", family.names[var.0])).collect();
    let equation = (family.function_name.clone(), format!("Bernstein({degree})"));
    Some(Candidate::Block(at.join(", "), vec![equation]))
}

/// The zero of a linear polynomial in one variable.
fn linear(p: &Poly) -> Option<(Var, Rational)> {
    let [var] = p.variables()[..] else { return None };
    if p.degree(var) != 1 {
        return None;
    }
    let coefficients = p.coefficients_in(var);
    let (constant, slope) = (coefficients.first()?.as_constant()?, coefficients.get(1)?.as_constant()?);
    Some((var, -constant.checked_div(&slope)?))
}

/// Whether a name stands in an expression, and not only as a part of a longer one.
fn is_named(expression: &str, name: &str) -> bool {
    let in_a_word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let ends_a_word = in_a_word(name.chars().next_back());
    expression.match_indices(name).any(|(at, _)| {
        let after = expression[at + name.len()..].chars().next();
        let before = expression[..at].chars().next_back();
        !(in_a_word(before) || ends_a_word && in_a_word(after))
    })
}

/// The function that an expression is about: `b[3]`, or the only one in `b[3] - 1/2`, but not its derivative or its value
/// elsewhere.
pub fn function_of(family: &Family, expression: &str) -> Option<usize> {
    let labels: Vec<String> = (0..family.functions.len()).map(|k| family.function_label(k)).collect();
    if let Some(k) = labels.iter().position(|label| label == expression) {
        return Some(k);
    }
    let mut named = labels.iter().enumerate().filter(|(_, label)| is_named(expression, label));
    let (k, label) = named.next().filter(|_| !expression.contains("D("))?;
    (named.next().is_none() && !expression.contains(&format!("{label}("))).then_some(k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Disk;

    fn statements(text: &str, name: &str) -> Vec<String> {
        let source = Source::text("spec.basis", text);
        claims_that_hold(&Disk, &source, name).into_iter().map(|h| h.statement).collect()
    }

    const QUADRATIC: &str = "family Q {
    domain 0 <= t <= 1;
    shape -2 <= λ <= 1;
    b[0] = (1 - λ*t) * (1 - t)^2;
    b[1] = (2 + λ) * (1 - t) * t;
    b[2] = (1 - λ + λ*t) * t^2;
    CLAIMS
}
";

    #[test]
    fn what_holds_is_found() {
        assert_eq!(
            statements(QUADRATIC.replace("CLAIMS", "").as_str(), "Q"),
            [
                "prove partition_of_unity;",
                "prove nonnegative;",
                "prove symmetric;",
                "prove independent except λ = -2;",
                "prove at t = 0 {\n    b = [1, 0, 0];\n    D(b) = [-2 - λ, 2 + λ, 0];\n    D(b, 2) = [2 + 4*λ, -4 - 2*λ, 2 - 2*λ];\n}",
                "prove at t = 1 {\n    b = [0, 0, 1];\n    D(b) = [0, -2 - λ, 2 + λ];\n    D(b, 2) = [2 - 2*λ, -4 - 2*λ, 2 + 4*λ];\n}",
                "prove at λ = 0 { b = Bernstein(2); }",
            ]
        );
    }

    #[cfg(feature = "angles")]
    #[test]
    fn ends_of_angles_and_exponentials_have_values() {
        let found = statements(
            "family A {
    domain 0 <= t <= α;
    shape 0 < α < pi;
    b[0] = sin(α - t)/sin(α);
    b[1] = sin(t)/sin(α);
}",
            "A",
        );
        let start = "prove at t = 0 {\n    b = [1, 0];\n    D(b) = [-cos(α)/sin(α), 1/sin(α)];\n    D(b, 2) = [-1, 0];\n}";
        assert!(found.iter().any(|s| s == start), "{found:?}");
        assert!(found.iter().any(|s| s.starts_with("prove at t = α {\n    b = [0, 1];")), "{found:?}");
        let found = statements("family E { domain 0 <= t <= 2; f[0] = exp(-t); f[1] = 1 - exp(-t); }", "E");
        assert!(found.iter().any(|s| s.contains("f = [exp(-2), 1 - exp(-2)];")), "{found:?}");
    }

    #[test]
    fn what_is_claimed_or_false_is_left_out() {
        let claims = "prove symmetric; prove at t = 1 { b = [0, 0, 1]; D(b)=[0,-λ-2,λ+2]; D(b, 2) = [-2*λ + 2, -2*λ - 4, 4*λ + 2]; }";
        let found = statements(&QUADRATIC.replace("CLAIMS", claims).replace("-2 <= λ", "-3 <= λ"), "Q");
        assert_eq!(found.len(), 4);
        assert!(
            !found
                .iter()
                .any(|s| s.contains("nonnegative") || s.contains("symmetric") || s.contains("t = 1"))
        );
        // In every order, or not at all.
        let smooth = "family S(n in 1..=3) { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; b[2] = (n - 1)*t; }";
        assert!(
            !statements(smooth, "S").iter().any(|s| s.contains("partition") || s.contains("independent"))
        );
        assert_eq!(statements(smooth, "S"), ["prove nonnegative;"]);
        assert!(statements("family F { domain 0 <= t <= 1; b[0] = x; }", "F").is_empty());
        assert!(statements(&QUADRATIC.replace("CLAIMS", ""), "Other").is_empty());
    }

    #[test]
    fn splines_join_as_often_as_they_do() {
        let text = "family S { domain 0 <= t <= 1; b[0] = (1 - t)^2/2; b[1] = 1/2 + t - t^2; b[2] = t^2/2; }";
        let found = statements(text, "S");
        assert!(found.contains(&String::from("prove continuity(1);")), "{found:?}");
    }

    #[test]
    fn spans_join_as_often_as_they_do() {
        let text = "family S { domain 0 <= x <= 1, 1 <= x <= 2; f[0] = x^2 | 1; f[1] = 1 - x^2 | 0; }";
        assert_eq!(
            statements(text, "S"),
            ["prove partition_of_unity;", "prove nonnegative;", "prove independent;", "prove smooth(0);"]
        );
        let text = "family S { domain 0 <= x <= 1, 1 <= x <= 3; f[0] = x^2 | 2*x - 1; f[1] = x^3 | x^3; }";
        let found = statements(text, "S");
        assert!(found.contains(&String::from("prove smooth(1);")), "{found:?}");
    }

    #[test]
    fn functions_have_bounds() {
        let source = Source::text(
            "f.basis",
            "family F { domain 0 <= t <= 1; b[0] = 3*t^2 - 2*t^3; b[1] = 1 - 3*t^2 + 2*t^3; }",
        );
        let library = Library::from_source(&Disk, &Prover, source);
        let items = library.items(Selected::EveryOrder);
        let Subject::Family(family) = &items[0].subject else { panic!("it is a family") };
        let facts = function_facts(family);
        assert_eq!(facts[0].bernstein, ["0", "0", "1", "1"]);
        assert_eq!(facts[0].between, Some((String::from("0"), String::from("1"))));
    }

    #[test]
    fn expressions_are_about_the_functions_whose_names_are_in_them() {
        let source = Source::text(
            "f.basis",
            "family F { domain 0 <= t <= 1; shape 0 <= a_f <= 1; f[0] = a_f*t; f[1] = 1 - t; }",
        );
        let library = Library::from_source(&Disk, &Prover, source);
        let items = library.items(Selected::EveryOrder);
        let Subject::Family(family) = &items[0].subject else { panic!("it is a family") };
        let of = |expression: &str| function_of(family, expression);
        assert_eq!((of("f[0]"), of("f[1] - 1/2"), of("3*f[0] - a_f")), (Some(0), Some(1), Some(0)));
        assert_eq!((of("ff[1] - 1"), of("f[0] - f[1]"), of("D(f[0]) - 1")), (None, None, None));
    }
}
