//! What `basis explain` says, as data: the text, the JSON and the LaTeX are three ways to print it.

use basis_engine::claim::ClaimKind;
use basis_engine::query::{FunctionFacts, function_facts, latex};
use basis_engine::state::as_declared;
use basis_engine::{Checked, Claim, Family, Library, Subject, Verdict, explain, rounding};
use serde::Serialize;

use crate::domain;

/// Derivatives at the ends are shown up to this order.
const ORDER: u32 = 2;

/// What there is to say of a family, a join or a theorem.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub(super) enum Facts {
    /// A family of one order.
    Family(Box<FamilyFacts>),
    /// A theorem.
    Theorem(TheoremFacts),
    /// A join.
    Join(TheoremFacts),
}

/// What there is to say of a family.
#[derive(Debug, Serialize)]
pub(super) struct FamilyFacts {
    /// The name.
    pub(super) name: String,
    /// The name with its order.
    pub(super) title: String,
    /// The doc comment, one string a line.
    pub(super) doc: Vec<String>,
    /// Such as `0 <= t <= 1`; of one span where there are several.
    pub(super) domain: String,
    /// All spans, where there are several; what is said of the family is about all of them, formulas and ends are those
    /// of one.
    pub(super) whole_domain: Option<String>,
    /// Such as `-3 <= λ <= 1`.
    pub(super) shapes: Vec<String>,
    /// What is assumed of the shape parameters, such as `α^2 + β^2 <= 1`.
    pub(super) assumptions: Vec<String>,
    /// The functions in all their forms.
    pub(super) functions: Vec<Function>,
    /// The derivatives of a curve at both ends as combinations of its control points.
    pub(super) ends: Vec<Equation>,
    /// The shape values at which the functions are linearly dependent.
    pub(super) dependent: Vec<String>,
    /// What is left open about them; nothing if these are all.
    pub(super) dependent_open: Option<String>,
    /// Proved bounds of the rounding errors of evaluation.
    pub(super) rounding: Vec<Rounding>,
    /// What they assume of sines, exponentials and the like; nothing without these.
    pub(super) rounding_assumes: Option<String>,
    /// The control points that contacts determine; of several spans, at the ends of the whole domain, with the first one.
    pub(super) contacts: Vec<Contact>,
    /// Matrices: to and from the Bernstein basis and another family, degree elevation, mass, stiffness, moments.
    pub(super) matrices: Vec<MatrixFacts>,
    /// Mass, stiffness and moments of the whole domain of several spans; with the first one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) matrices_of_whole_domain: Vec<MatrixFacts>,
    /// Which matrices are left out, and why.
    pub(super) matrices_open: Option<String>,
    /// Zeros and extrema of the functions that are negative somewhere.
    pub(super) extrema: Vec<ExtremaFacts>,
    /// The functions of which nothing of this is said, and why.
    pub(super) extrema_open: Vec<Open>,
    /// The largest ranges of the shape parameters on which all functions are nonnegative.
    pub(super) nonnegative: Vec<String>,
    /// The claims with their verdicts; none where they are not asked for.
    pub(super) claims: Vec<ClaimFacts>,
    /// What names in the claims stand for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) definitions: Vec<Equation>,
}

/// A function in all its forms.
#[derive(Debug, Serialize)]
pub(super) struct Function {
    pub(super) name: String,
    pub(super) factored: String,
    pub(super) expanded: String,
    /// The coefficients in the Bernstein basis of the family's degree; none where there is no such table.
    pub(super) bernstein: Vec<String>,
    /// The factored form in math mode.
    pub(super) latex: String,
}

/// A name with its value.
#[derive(Debug, Serialize)]
pub(super) struct Equation {
    pub(super) name: String,
    pub(super) value: String,
    /// Both sides in math mode, `name &= value`.
    pub(super) latex: String,
}

/// A bound of rounding errors.
#[derive(Debug, Serialize)]
pub(super) struct Rounding {
    /// The functions that have it, or `C(t)` for a point of a curve.
    pub(super) of: String,
    /// Such as `4.41 ε of the value`.
    pub(super) bound: String,
}

/// A contact with another curve.
#[derive(Debug, Serialize)]
pub(super) struct Contact {
    /// Such as `C1, Q after P: Q'(0) = P'(1)`.
    pub(super) title: String,
    pub(super) points: Vec<Equation>,
    /// Where the points are not determined.
    pub(super) conditions: Vec<String>,
}

/// A matrix of rational functions of the shape parameters.
#[derive(Debug, Serialize)]
pub(super) struct MatrixFacts {
    /// Such as `to_bernstein` or `mass`.
    pub(super) kind: &'static str,
    /// What it says, such as `Mass matrix, the integrals of b[i]*b[j]`.
    pub(super) title: String,
    /// The names of its rows.
    pub(super) rows: Vec<String>,
    /// The names of its columns.
    pub(super) columns: Vec<String>,
    /// Its entries, row by row.
    pub(super) entries: Vec<Vec<String>>,
    /// The matrix in math mode.
    pub(super) latex: String,
}

/// Zeros and extrema of a function.
#[derive(Debug, Serialize)]
pub(super) struct ExtremaFacts {
    pub(super) name: String,
    /// Such as `t = 1/2` or `(u, v, w) = (0, 0, 1)`.
    pub(super) zeros: Vec<String>,
    /// Lines, curves and so on at whose points it is zero.
    pub(super) zeros_on: Vec<Locus>,
    /// Whether there may be other zeros.
    pub(super) zeros_open: bool,
    pub(super) minimum: Extremum,
    pub(super) maximum: Extremum,
    /// Whether the extreme values may be taken at other points, too.
    pub(super) extrema_open: bool,
    /// Whether the extreme values are bounds.
    pub(super) bounds: bool,
}

/// A least or greatest value with the points at which it is taken.
#[derive(Debug, Serialize)]
pub(super) struct Extremum {
    pub(super) value: String,
    pub(super) at: Vec<String>,
    /// Lines, curves and so on at all of whose points it is taken.
    pub(super) on: Vec<Locus>,
}

/// A function of which nothing is said, and why.
#[derive(Debug)]
pub(super) struct Open {
    pub(super) name: String,
    pub(super) why: String,
}

/// As one text, `b[2]: it contains a number that is not rational`.
impl Serialize for Open {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&format_args!("{}: {}", self.name, self.why))
    }
}

/// The points of the domain that satisfy an equation.
#[derive(Debug, Serialize)]
pub(super) struct Locus {
    /// `line`, `curve`, `plane`, `surface`, or `domain` for all points.
    pub(super) kind: &'static str,
    /// Such as `2*u + v = 1`.
    pub(super) equation: String,
}

/// What there is to say of a join or theorem.
#[derive(Debug, Serialize)]
pub(super) struct TheoremFacts {
    pub(super) name: String,
    pub(super) doc: Vec<String>,
    /// Its curves and surfaces, such as `P = Quadratic(λ)`.
    pub(super) patches: Vec<String>,
    /// The ranges of its scalars, and how they are related.
    pub(super) scalars: Vec<String>,
    /// The control points that it determines.
    pub(super) points: Vec<Equation>,
    pub(super) claims: Vec<ClaimFacts>,
    /// What names in the claims stand for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) definitions: Vec<Equation>,
    /// With a title and all of that, as text.
    #[serde(skip)]
    pub(super) heading: String,
}

/// A claim with its verdict.
#[derive(Debug, Serialize)]
pub(super) struct ClaimFacts {
    /// As it is written, index variables replaced by their values.
    pub(super) claim: String,
    /// `prove` or `refute`.
    pub(super) declared: &'static str,
    /// `proved`, `refuted` or `undecided`.
    pub(super) verdict: &'static str,
    /// Whether the verdict is the declared one.
    pub(super) as_declared: bool,
    /// The method, the counterexample, or what is left to decide.
    pub(super) reason: String,
    /// The claim in LaTeX, as a sentence.
    pub(super) latex: String,
    /// The statement that makes it.
    #[serde(skip)]
    pub(super) statement: (usize, usize),
    /// That statement as it is written.
    #[serde(skip)]
    pub(super) written: String,
}

/// A name with its value, also in LaTeX.
fn equation((name, value): (String, String)) -> Equation {
    let side = |text: &str| latex::math(text).unwrap_or_else(|| format!("\\text{{{}}}", latex::escape(text)));
    let latex = format!("{} &= {}", side(&name), side(&value));
    Equation { name, value, latex }
}

fn matrix(matrix: &explain::Matrix) -> MatrixFacts {
    let entries = matrix.texts();
    let math = |text: &String| latex::math(text).unwrap_or_else(|| latex::escape(text));
    let rows: Vec<String> =
        entries.iter().map(|row| row.iter().map(math).collect::<Vec<_>>().join(" & ")).collect();
    MatrixFacts {
        kind: matrix.kind.name(),
        title: matrix.title.clone(),
        rows: matrix.rows.clone(),
        columns: matrix.columns.clone(),
        latex: format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.join(" \\\\ ")),
        entries,
    }
}

fn extrema(facts: explain::Extrema) -> ExtremaFacts {
    let loci = |all: Vec<explain::Locus>| -> Vec<Locus> {
        all.into_iter().map(|l| Locus { kind: l.kind.name(), equation: l.equation }).collect()
    };
    let extremum = |e: explain::Extremum| Extremum { value: e.value, at: e.at, on: loci(e.on) };
    ExtremaFacts {
        name: facts.label,
        zeros: facts.zeros,
        zeros_on: loci(facts.zeros_on),
        zeros_open: facts.zeros_are_open,
        minimum: extremum(facts.minimum),
        maximum: extremum(facts.maximum),
        extrema_open: facts.is_open,
        bounds: facts.are_bounds,
    }
}

/// What is known of a family as a whole, on however many spans it is.
pub(super) struct Whole<'f> {
    family: &'f Family,
    /// Where its functions are dependent.
    dependence: explain::Dependence,
    /// The bounds of its rounding errors.
    rounding: Vec<(String, String)>,
}

impl<'f> Whole<'f> {
    pub(super) fn new(family: &'f Family) -> Self {
        let rounding = explain::rounding(family);
        Self { family, dependence: explain::dependence(family), rounding }
    }
}

impl FamilyFacts {
    /// What follows from the formulas of a family, on one span if it has several; its claims are those in `checked`, `next`
    /// is its next order, and `conversions` are matrices to and from another family.
    pub(super) fn new(
        library: &Library<'_>,
        (whole, span): (&Whole<'_>, &Family),
        checked: Option<&Checked>,
        next: Option<&Family>,
        conversions: &[explain::Matrix],
    ) -> Self {
        let Whole { family, dependence, rounding } = whole;
        let all_extrema = explain::extrema(span);
        let is_first = family.pieces.first().is_none_or(|first| core::ptr::eq(&raw const **first, span));
        let contacts = if is_first { explain::contacts(family) } else { Vec::new() };
        let function = |facts: FunctionFacts| {
            let FunctionFacts { label, factored, expanded, bernstein, .. } = facts;
            let latex = latex::math(&factored).unwrap_or_default();
            Function { name: label, factored, expanded, bernstein, latex }
        };
        let contact = |contact: explain::Contact| Contact {
            title: contact.title,
            points: contact.points.into_iter().map(equation).collect(),
            conditions: contact.conditions,
        };
        Self {
            name: family.name.clone(),
            title: family.title(),
            doc: family.doc.clone(),
            domain: domain::describe(span),
            whole_domain: (!family.pieces.is_empty()).then(|| domain::describe(family)),
            shapes: family.shapes.iter().map(|p| family.declared(p)).collect(),
            assumptions: domain::assumptions(family),
            functions: function_facts(span).into_iter().map(function).collect(),
            ends: explain::end_derivatives(span, ORDER).into_iter().map(equation).collect(),
            dependent: dependence.at.clone(),
            dependent_open: dependence.open.clone(),
            rounding_assumes: rounding::assumed(family).filter(|_| !rounding.is_empty()),
            rounding: rounding
                .iter()
                .map(|(of, bound)| Rounding { of: of.clone(), bound: bound.clone() })
                .collect(),
            contacts: contacts.into_iter().map(contact).collect(),
            matrices_of_whole_domain: if is_first {
                explain::matrices_of_whole_domain(library, family).iter().map(matrix).collect()
            } else {
                Vec::new()
            },
            matrices: conversions.iter().chain(&explain::matrices(library, span, next)).map(matrix).collect(),
            matrices_open: explain::matrices_left_out(span),
            extrema: all_extrema.known.into_iter().map(extrema).collect(),
            extrema_open: all_extrema.open.into_iter().map(|(name, why)| Open { name, why }).collect(),
            nonnegative: explain::nonnegative_ranges(span).iter().map(ToString::to_string).collect(),
            claims: checked.map_or_else(Vec::new, claims),
            definitions: checked.map_or_else(Vec::new, |checked| definitions(library, checked)),
        }
    }
}

impl Facts {
    /// What a join or theorem says.
    pub(super) fn theorem(library: &Library<'_>, checked: &Checked) -> Option<Self> {
        let Subject::Theorem(theorem) = &checked.subject else { return None };
        let patch = |p: &basis_engine::theorem::Patch| format!("{} = {}", p.name, p.written);
        let facts = TheoremFacts {
            name: theorem.name.clone(),
            doc: theorem.doc.clone(),
            patches: theorem.patches.iter().map(patch).collect(),
            scalars: theorem.conditions(),
            points: explain::determined_points(theorem).into_iter().map(equation).collect(),
            claims: claims(checked),
            definitions: definitions(library, checked),
            heading: domain::theorem_heading(theorem, &theorem.title()),
        };
        Some(match checked.subject.kind() {
            "join" => Self::Join(facts),
            _ => Self::Theorem(facts),
        })
    }
}

/// What names in claims stand for.
fn definitions(library: &Library<'_>, checked: &Checked) -> Vec<Equation> {
    let claims: Vec<&Claim> = checked.claims.iter().map(|(claim, _)| claim).collect();
    explain::definitions(library, &checked.subject, &claims).into_iter().map(equation).collect()
}

fn claims(checked: &Checked) -> Vec<ClaimFacts> {
    let fact = |(claim, verdict): &(Claim, Verdict)| {
        let (word, reason) = match verdict {
            Verdict::Proved(evidence) => ("proved", evidence.method().to_string()),
            Verdict::Refuted(witness) => ("refuted", witness.notes.join("; ")),
            Verdict::Undecided(left) => ("undecided", left.clone()),
        };
        ClaimFacts {
            claim: claim.text.clone(),
            declared: claim.expected.keyword(),
            verdict: word,
            as_declared: as_declared(claim.expected, verdict),
            reason,
            latex: sentence(&checked.subject, claim),
            statement: claim.statement.number,
            written: format!("{} {}", claim.statement.text, claim.statement.range).trim_end().to_string(),
        }
    };
    checked.claims.iter().map(fact).collect()
}

/// A claim as a sentence of a paper.
fn sentence(subject: &Subject, claim: &Claim) -> String {
    let Subject::Family(family) = subject else { return formula(&claim.statement.text, "") };
    let b = latex::name(&family.function_name);
    // What is claimed on several spans has one wording.
    match claim.kind.on_a_span() {
        ClaimKind::PartitionOfUnity => format!("The functions sum to one, $\\sum_i {b}_i = 1$."),
        ClaimKind::Nonnegative => {
            let shapes =
                if family.shapes.is_empty() { "" } else { " and for all shape values in their ranges" };
            format!("The functions are nonnegative on the domain{shapes}, ${b}_i \\ge 0$.")
        }
        ClaimKind::Symmetric => match reversed(family) {
            Some((t, image)) => {
                let n = family.functions.len() - 1;
                format!("The functions are symmetric, ${b}_i({t}) = {b}_{{{n}-i}}({image})$.")
            }
            None => String::from("The functions are symmetric under the symmetries of the domain."),
        },
        ClaimKind::Independent(exceptions) => {
            let point = |values: &basis_kernel::Values| {
                let parts: Vec<String> =
                    values.iter().map(|(var, x)| format!("{} = {x}", family.names[var.0])).collect();
                latex::inline(&parts.join(", "))
            };
            let except: Vec<String> = exceptions.iter().map(point).collect();
            let end = match except.as_slice() {
                [] => String::new(),
                [one] => format!(" except at {one}"),
                several => format!(" except at {}", several.join(" and ")),
            };
            format!("The functions are linearly independent{end}.")
        }
        ClaimKind::Continuity(joint) => {
            let other = if joint.next.is_empty() {
                String::new()
            } else {
                format!(" where \\texttt{{{}}}", latex::escape(&claim.text))
            };
            let order = joint.order;
            format!(
                "Neighbouring segments, the control points shifted by one, join with {order} continuous derivatives{other}."
            )
        }
        ClaimKind::Rounding(bound) => {
            let bound = latex::inline(&bound.to_string());
            format!("The computed values are within {bound} machine epsilons of the exact ones.")
        }
        ClaimKind::Smooth(0) => String::from("The functions are continuous on the whole domain."),
        ClaimKind::Smooth(order) => {
            let order = if *order == 1 { String::from("once") } else { format!("{order} times") };
            format!("The functions are {order} continuously differentiable on the whole domain.")
        }
        ClaimKind::TotallyPositive => {
            format!("The functions are totally positive: no minor of $({b}_j(t_i))$ is negative.")
        }
        ClaimKind::Relation { at: Some(at), .. } => {
            let range = if claim.statement.range.is_empty() {
                String::new()
            } else {
                format!(" {}", claim.statement.range)
            };
            format!("At {}: {}", latex::inline(at), formula(&format!("{}{range}", claim.statement.text), ""))
        }
        _ => formula(&claim.statement.text, ""),
    }
}

/// A domain variable and where the reversal of the domain takes it, in math mode; nothing on other domains than intervals.
fn reversed(family: &Family) -> Option<(String, String)> {
    let (var, ..) = family.interval()?;
    let (first, last) = match family.pieces.as_slice() {
        [] => (family, family),
        [first, .., last] => (&**first, &**last),
        [only] => (&**only, &**only),
    };
    let ([low, _], [_, high]) = (first.end_texts()?, last.end_texts()?);
    let parameter = family.domain.iter().find(|p| p.var == var)?;
    let name = family.name_of(parameter);
    let sum = match (low.parse::<i64>(), high.parse::<i64>()) {
        (Ok(low), Ok(high)) => match low.checked_add(high)? {
            0 => String::new(),
            sum => sum.to_string(),
        },
        (Ok(0), _) => high,
        _ => format!("{low} + {high}"),
    };
    Some((latex::name(name), latex::math(&format!("{sum} - {name}"))?))
}

/// An equation or inequality as a sentence; what is no formula stands as it is written.
fn formula(text: &str, end: &str) -> String {
    match latex::math(text) {
        Some(math) => format!("${math}$.{end}"),
        None => format!("\\texttt{{{}}}.{end}", latex::escape(text)),
    }
}
