//! Decides claims: every kind of claim has a file, and every verdict its certificate or its witness.

#[cfg(any(test, feature = "tools"))]
pub mod check;
mod gram;
mod identity;
mod independent;
mod inequality;
mod net;
mod parallel;
mod point;
mod quadratic;
mod report;
mod run;
mod theorem;

pub use gram::Square;
use inequality::Inequality;
pub use report::{diagnose, diagnose_theorem};
pub use run::Run;
pub use theorem::theorem_claim;
#[cfg(any(test, feature = "tools"))]
pub use theorem::theorem_statements;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::collections::list::Mapped;
use crate::decide::{Coordinate, Proof, Relation, Table, Values};
use crate::model::{Claim, ClaimKind, Expected, Family};

/// What is known about a claim.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The claim is true.
    Proved(Evidence),
    /// The claim is false.
    Refuted(Witness),
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// Why a claim is true.
#[derive(Clone, Debug)]
pub struct Evidence {
    /// The method in a few words; where several steps were needed, the most elaborate one.
    pub method: String,
    /// One proof for each polynomial that the claim is about.
    pub steps: Vec<Step>,
}

/// A polynomial and the proof of what is claimed of it.
#[derive(Clone, Debug)]
pub struct Step {
    /// The expression as text, such as `b[1]`.
    pub of: String,
    /// The proof.
    pub proof: StepProof,
}

/// The kinds of proofs.
#[derive(Clone, Debug)]
pub enum StepProof {
    /// After expansion nothing is left: whoever expands anew has checked it.
    Identity,
    /// The sign of a polynomial on the declared ranges.
    Sign(Proof),
    /// The rank of the coefficient table.
    Independence(RankProof),
    /// A sum of squares of vectors.
    Squares(Vec<Square>),
}

/// What has to be shown for a claim to be true.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The expression as text, such as `b[1]`.
    pub of: String,
    /// What has to be shown of it.
    pub assertion: Assertion,
    /// How many times the usual work the spec allows for the proof.
    pub budget: u32,
}

/// The kinds of statements, each about polynomials alone.
#[derive(Clone, Debug)]
pub enum Assertion {
    /// The expression is zero.
    Zero(Fraction),
    /// A polynomial, with the sign of the expression, is ≥ 0 or > 0 on a box.
    Sign {
        /// The polynomial; on a simplex in the coordinates of the box that is mapped to it.
        polynomial: Poly,
        /// What is claimed of it.
        relation: Relation,
        /// The box.
        region: Region,
    },
    /// A polynomial that is linear in dot products of points is ≥ 0 or > 0 for all points.
    Squares {
        /// The polynomial.
        polynomial: Poly,
        /// What is claimed of it.
        relation: Relation,
        /// The numbers of the two points whose dot product a variable is.
        products: Vec<(Var, (usize, usize))>,
    },
    /// The rows of a table are independent at all points of a box but the exceptions, and dependent at these.
    Independent {
        /// The coefficients of the functions, up to denominators, which vanish nowhere.
        table: Table,
        /// The exceptions.
        except: Vec<Values>,
        /// The box.
        region: Region,
    },
}

#[cfg(any(test, feature = "tools"))]
pub(crate) use independent::combination_text;
pub use independent::{RankProof, coefficient_table};
#[cfg(any(test, feature = "tools"))]
pub(crate) use inequality::functions as function_signs;

/// A point at which a claim fails.
#[derive(Clone, Debug)]
pub struct Witness {
    /// The expression whose value contradicts the claim; for an equation left side minus right side.
    pub of: String,
    /// The point: every shape parameter and domain variable.
    pub at: Vec<(String, Coordinate)>,
    /// Names in `at` and `net` on which the expression does not depend, such as t for a difference at the ends of the domain:
    /// they are left out of texts.
    pub idle: Vec<String>,
    /// For claims of theorems: the control points with their coordinates.
    pub net: Vec<(String, Vec<Rational>)>,
    /// The exact value of the expression there.
    pub value: Rational,
    /// What it means, in one line each.
    pub notes: Vec<String>,
}

/// More points than this are not all written if most of them are zero.
const MAX_ALL: usize = 8;

impl Witness {
    /// The control points that matter, and whether those at zero are left out because most of many are.
    pub fn points(&self) -> (Vec<&(String, Vec<Rational>)>, bool) {
        let mut points: Vec<_> = self.net.iter().filter(|(name, _)| !self.idle.contains(name)).collect();
        let all = points.len();
        let zero = |place: &[Rational]| place.iter().all(Rational::is_zero);
        let zeros = points.iter().filter(|(_, place)| zero(place)).count();
        let short = all > MAX_ALL && 2 * zeros > all;
        points.retain(|(_, place)| !short || !zero(place));
        (points, short)
    }

    /// The point as text, such as `λ = 1, t = 1/2`, with control points such as `P[0] = (0, 0)`.
    pub fn point(&self) -> String {
        let shown = self.at.iter().filter(|(name, _)| !self.idle.contains(name));
        let mut parts: Vec<String> = shown.map(|(name, c)| c.describe(name)).collect();
        let (points, short) = self.points();
        parts.extend(points.iter().map(|(name, place)| format!("{name} = {}", point_text(place))));
        if short {
            parts.push(String::from("all other points 0"));
        }
        parts.join(", ")
    }
}

/// The coordinates of a point as they are written in a spec, `(1, 1/2)`.
pub fn point_text(place: &[Rational]) -> String {
    let parts: Vec<String> = place.mapped(Rational::to_string);
    format!("({})", parts.join(", "))
}

/// Decides a claim about a family.
pub fn claim(family: &Family, claim: &Claim) -> Verdict {
    if let ClaimKind::Independent(except) = &claim.kind {
        return independent::independent(family, except);
    }
    let expressions = expressions(family, claim);
    match Inequality::of(family, &claim.kind) {
        Some(inequality) => inequality.decide(&claim.kind, expressions),
        None => identity::decide(family, &claim.kind, expressions),
    }
}

/// The expressions that a claim compares with zero, as text and as quotients of polynomials.
pub fn expressions(family: &Family, claim: &Claim) -> Vec<(String, Fraction)> {
    match &claim.kind {
        ClaimKind::PartitionOfUnity => identity::partition_of_unity(family),
        ClaimKind::Symmetric => identity::symmetric(family),
        ClaimKind::Continuity(order) => identity::continuity(family, *order),
        ClaimKind::Nonnegative => {
            let functions = family.functions.iter().enumerate();
            functions.map(|(k, f)| (family.function_label(k), f.value.clone())).collect()
        }
        ClaimKind::Independent(_) => Vec::new(),
        ClaimKind::Relation { differences, .. } => differences.mapped(|d| (d.text.clone(), d.value.clone())),
    }
}

/// What has to be shown for a claim to be true: the same statements, in the same order, as the steps of a proof.
#[cfg(any(test, feature = "tools"))]
pub fn statements(family: &Family, claim: &Claim) -> Vec<Statement> {
    if let ClaimKind::Independent(except) = &claim.kind {
        let table = coefficient_table(family);
        let assertion =
            Assertion::Independent { table, except: except.clone(), region: family.shape_region() };
        return vec![Statement {
            of: String::from(independent::COEFFICIENTS),
            assertion,
            budget: family.budget,
        }];
    }
    let inequality = Inequality::of(family, &claim.kind);
    let assertion = |value: Fraction| match &inequality {
        None => Assertion::Zero(value),
        Some(inequality) => Assertion::Sign {
            polynomial: inequality.polynomial(&value),
            relation: inequality.relation,
            region: inequality.region().clone(),
        },
    };
    let all = expressions(family, claim).into_iter();
    all.map(|(of, value)| Statement { of, assertion: assertion(value), budget: family.budget }).collect()
}

/// The variables that an `at` block fixes.
fn fixed(kind: &ClaimKind) -> &[(Var, Fraction)] {
    match kind {
        ClaimKind::Relation { fixed, .. } => fixed,
        _ => &[],
    }
}

/// Whether a verdict is the one that the author of the claim declared.
pub const fn as_declared(expected: Expected, verdict: &Verdict) -> bool {
    matches!(
        (expected, verdict),
        (Expected::True, Verdict::Proved(_)) | (Expected::False, Verdict::Refuted(_))
    )
}

/// The names of the domain variables.
fn domain_names(family: &Family) -> Vec<String> {
    family.domain_variables().map(|p| p.name.clone()).collect()
}

/// A point of the variables as a point of the names, complete with what `at` fixes.
fn named_point(
    family: &Family,
    point: &[(Var, Coordinate)],
    fixed: &[(Var, Fraction)],
) -> Vec<(String, Coordinate)> {
    let mut rational = vec![Rational::ZERO; family.names.len()];
    for (var, c) in point {
        if let (Some(slot), Coordinate::Rational(value)) = (rational.get_mut(var.0), c) {
            *slot = value.clone();
        }
    }
    let known: Vec<(String, Option<Coordinate>, &Range)> = family
        .shapes
        .iter()
        .chain(&family.domain)
        .map(|p| {
            let given = point.iter().find(|(v, _)| *v == p.var).map(|(_, c)| c.clone());
            // What is fixed has an irrational value only where it is given.
            let is_irrational = matches!(given, Some(Coordinate::Algebraic(_)));
            let fixed_value = fixed.iter().find(|(v, _)| *v == p.var && !is_irrational);
            let fixed_value = fixed_value.and_then(|(_, f)| f.eval(&rational));
            (p.name.clone(), fixed_value.map(Coordinate::Rational).or(given), &p.range)
        })
        .collect();
    // On a simplex no more than what is left.
    let mut left = Rational::ONE;
    let mut all: Vec<(String, Coordinate)> = Vec::new();
    for (k, (name, given, range)) in known.into_iter().enumerate() {
        let on_simplex = family.is_simplex() && k >= family.shapes.len();
        let value = given.unwrap_or_else(|| {
            let simple = point::simple(range);
            Coordinate::Rational(if on_simplex { simple.min(left.clone()) } else { simple })
        });
        if let (true, Coordinate::Rational(x)) = (on_simplex, &value) {
            left -= x;
        }
        all.push((name, value));
    }
    if let Some(last) = &family.dependent {
        let mut rest = Some(Rational::ONE);
        for (_, c) in &all[family.shapes.len()..] {
            rest = match (rest, c) {
                (Some(rest), Coordinate::Rational(x)) => Some(&rest - x),
                _ => None,
            };
        }
        all.extend(rest.map(|rest| (last.name.clone(), Coordinate::Rational(rest))));
    }
    all
}
