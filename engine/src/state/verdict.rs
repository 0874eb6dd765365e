//! Verdicts. What is proved holds the kernel's proofs, what is refuted its refutation: nothing else makes one.

use basis_kernel::{Proof, Refutation, Statement};
use basis_prover::{Coordinate, Counterexample, Symmetries};

use crate::algebra::rational::Rational;
use crate::claim::Expected;
use crate::decimals;
use basis_prover::collections::list::{Listed, Mapped};

/// A statement with what it is about.
#[derive(Clone, Debug)]
pub struct Stated {
    /// The expression as text, such as `b[1]`.
    pub of: String,
    /// What is said of it.
    pub statement: Statement,
    /// Of a matrix, permutations that leave it unchanged, as far as they are known: a hint for the search.
    pub symmetries: Symmetries,
    /// Whether it says more than the claim: true only if the claim is, but perhaps false although the claim is true.
    pub is_stronger: bool,
}

impl Stated {
    /// A statement about an expression.
    pub(super) const fn new(of: String, statement: Statement) -> Self {
        Self { of, statement, symmetries: Symmetries::new(), is_stronger: false }
    }
}

/// The verdict on a claim.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The claim is true.
    Proved(Evidence),
    /// The claim is false.
    Refuted(Box<Witness>),
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// Why a claim is true.
///
/// Only the kernel makes proofs, and only this crate makes evidence of them:
///
/// ```compile_fail,E0451
/// use basis_engine::{Evidence, Verdict};
///
/// let verdict = Verdict::Proved(Evidence { method: String::from("because"), steps: Vec::new() });
/// ```
#[derive(Clone, Debug)]
pub struct Evidence {
    method: String,
    steps: Vec<(String, Proof)>,
    ways: Vec<usize>,
}

impl Evidence {
    /// Proofs of all that a claim says.
    pub(super) const fn new(method: String, steps: Vec<(String, Proof)>) -> Self {
        Self { method, steps, ways: Vec::new() }
    }

    /// The same proofs, of what is enough for the claim by the ways with these numbers.
    pub(super) fn by(self, ways: Vec<usize>) -> Self {
        Self { ways, ..self }
    }

    /// For each comparison in which an angle or exponent stands beside its sine or exponential, and each one under assumptions, the
    /// number of the way to statements that are enough for it, see [`statements`](super::statements); where the claim is proved with other
    /// conditions than it has, the number of these comes first.
    pub fn ways(&self) -> &[usize] {
        &self.ways
    }

    /// The method and the proofs.
    pub(super) fn into_parts(self) -> (String, Vec<(String, Proof)>) {
        (self.method, self.steps)
    }

    /// The method in a few words; where several steps were needed, the most elaborate one.
    pub fn method(&self) -> &str {
        &self.method
    }

    /// A proof for each statement that the claim makes, with what it is about.
    pub fn steps(&self) -> &[(String, Proof)] {
        &self.steps
    }
}

/// A point at which a claim fails.
#[derive(Clone, Debug)]
pub struct Witness {
    /// The expression whose value contradicts the claim; for an equation left side minus right side.
    pub of: String,
    /// The point: every shape parameter and domain variable.
    pub at: Vec<(String, Coordinate)>,
    /// Names in `at` and `net` on which the expression does not depend, such as t for a difference at the ends of the
    /// domain: they are left out of texts.
    pub idle: Vec<String>,
    /// Names in `at` whose values say little, with the place as one writes it, such as `t = pi/3`.
    pub places: Vec<(String, String)>,
    /// For claims of theorems: the control points with their coordinates.
    pub net: Vec<(String, Vec<Rational>)>,
    /// The given control points of a theorem, in order; what is refuted is the claim about these.
    pub given: Vec<Vec<Rational>>,
    /// The exact value of the expression there; where it is irrational, a number next to it, which `shown` says.
    pub value: Rational,
    /// The value as text where it is irrational, or contains π, exp(1) or the like, which the number above does not.
    pub shown: Option<String>,
    /// What it means, in one line each.
    pub notes: Vec<String>,
    /// What the refuted statement is about, as [`Stated::of`] has it.
    stated: String,
    refutation: Refutation,
    everywhere: Option<Proof>,
}

/// A number that stands for one next to it.
pub(super) fn about(x: &Rational) -> String {
    format!("about {}", decimals::readable(x, 6, 3))
}

/// More points than this are not all written if most of them are zero.
const MAX_ALL: usize = 8;

impl Witness {
    /// The witness that a refutation is.
    pub(super) fn new(
        of: String,
        at: Vec<(String, Coordinate)>,
        value: Rational,
        refutation: Refutation,
    ) -> Self {
        let (idle, places) = (Vec::new(), Vec::new());
        let (net, given, notes) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            stated: of.clone(),
            of,
            at,
            idle,
            places,
            net,
            given,
            value,
            shown: None,
            notes,
            refutation,
            everywhere: None,
        }
    }

    /// The witness that a counterexample is; the value with the other sign where its opposite is stated.
    pub(super) fn at_point(
        of: String,
        at: Vec<(String, Coordinate)>,
        found: &Counterexample,
        negated: bool,
    ) -> Self {
        let value = found.value();
        let number = value.as_ref().map_or(Rational::ZERO, |(x, _)| if negated { -x } else { x.clone() });
        let mut witness = Self::new(of, at, number, found.refutation.clone());
        witness.shown = match value {
            Some((_, true)) => None,
            Some((_, false)) => Some(about(&witness.value)),
            None => Some(String::from("a number that is not as claimed")),
        };
        witness
    }

    /// The value of the expression for reading.
    pub fn value_text(&self) -> String {
        self.shown.clone().unwrap_or_else(|| self.value.to_string())
    }

    /// The same witness, of a statement with another name.
    pub(super) fn about(mut self, stated: &str) -> Self {
        self.stated = String::from(stated);
        self
    }

    /// What the refuted statement is about, as [`Stated::of`] has it.
    pub fn of_statement(&self) -> &str {
        &self.stated
    }

    /// The statement that is false, and where: what the claim says of `of`, for a theorem about the given points.
    pub const fn refutation(&self) -> &Refutation {
        &self.refutation
    }

    /// The same witness, with the proof that the value is not as claimed whatever π, exp(r) and angles beside their sines
    /// are between the bounds for them.
    pub(super) fn whatever(mut self, proof: Proof) -> Self {
        self.everywhere = Some(proof);
        self
    }

    /// Where the value contains π, exp(r), or an angle beside its sine, of which there are bounds only: the proof that it is
    /// not as claimed for all numbers between these.
    pub const fn everywhere(&self) -> Option<&Proof> {
        self.everywhere.as_ref()
    }

    /// The control points that matter.
    pub fn points(&self) -> WitnessPoints<'_> {
        let mut points: Vec<_> = self.net.iter().filter(|(name, _)| !self.idle.contains(name)).listed();
        let all = points.len();
        let zero = |place: &[Rational]| place.iter().all(Rational::is_zero);
        let zeros = points.iter().filter(|(_, place)| zero(place)).count();
        let others_at_zero = all > MAX_ALL && 2 * zeros > all;
        points.retain(|(_, place)| !others_at_zero || !zero(place));
        WitnessPoints { listed: points, others_at_zero }
    }

    /// The point as text, such as `λ = 1, t = 1/2`, with control points such as `P[0] = (0, 0)`.
    pub fn point(&self) -> String {
        let shown = self.at.iter().filter(|(name, _)| !self.idle.contains(name));
        let place =
            |name: &String| self.places.iter().find(|(own, _)| own == name).map(|(_, text)| text.clone());
        let describe = |(name, c): &(String, Coordinate)| place(name).unwrap_or_else(|| c.describe(name));
        let mut parts: Vec<String> = shown.map(describe).listed();
        let points = self.points();
        parts.extend(points.listed.iter().map(|(name, place)| format!("{name} = {}", point_text(place))));
        if points.others_at_zero {
            parts.push(String::from("all other points 0"));
        }
        parts.join(", ")
    }
}

/// The control points of a witness that matter.
#[derive(Debug)]
pub struct WitnessPoints<'w> {
    /// Their names and coordinates.
    pub listed: Vec<&'w (String, Vec<Rational>)>,
    /// Whether those at zero are left out, because most of many are.
    pub others_at_zero: bool,
}

/// The coordinates of a point as they are written in a spec, `(1, 1/2)`.
pub fn point_text(place: &[Rational]) -> String {
    let parts: Vec<String> = place.mapped(Rational::to_string);
    format!("({})", parts.join(", "))
}

/// Whether a verdict is the one that the author of the claim declared; of a conjecture any but that it is false.
pub const fn as_declared(expected: Expected, verdict: &Verdict) -> bool {
    matches!(
        (expected, verdict),
        (Expected::True, Verdict::Proved(_))
            | (Expected::False, Verdict::Refuted(_))
            | (Expected::Open, Verdict::Undecided(_) | Verdict::Proved(_))
    )
}
