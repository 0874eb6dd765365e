//! Claims of a family as theorems with their proofs.

use basis_engine::algebra::range::Range;
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Claimed, Compared, Comparison, Formulas, Term};
use basis_engine::{Claim, ClaimKind, Coordinate, Evidence, Family, Verdict, Witness, state};
use basis_kernel::algebra::poly::Var;
use basis_kernel::{Chart, Proof, Statement};

use super::certificate::{self, Signs};
use super::formula::{Writer, number};
use super::frame::Frame;
use super::quotients;

/// Why there is no theorem for a claim.
pub(super) type Missing = &'static str;

/// Why only equations are exported of families with assumptions: they hold without them.
pub(super) const ASSUMED: Missing = "a claim under an assumption";

/// A theorem for each comparison of a claim that is proved, with its own identifier if there are several.
pub(super) fn each_proved(
    name: &str,
    claimed: &Claimed,
    evidence: &Evidence,
    theorem: &mut dyn FnMut(&str, &Compared, &Proof) -> Result<String, Missing>,
) -> Result<Vec<String>, Missing> {
    if evidence.steps().len() != claimed.all.len() {
        return Err("formulas that cannot be told apart");
    }
    let many = claimed.all.len() > 1;
    let each = claimed.all.iter().zip(evidence.steps()).enumerate();
    each.map(|(k, (compared, (_, proof)))| {
        let name = if many { format!("{name}_{k}") } else { name.to_string() };
        theorem(&name, compared, proof)
    })
    .collect()
}

/// What a family in sin and cos of an angle says of its variable, where the definitions are those in tangents.
pub(super) struct OfAngle<'a> {
    /// The identifiers of the definitions as they are written.
    pub(super) definitions: &'a [String],
    /// The identifier of the domain variable.
    pub(super) variable: String,
    /// Its range as a hypothesis.
    pub(super) domain: String,
    /// The tangent of half the angle there.
    pub(super) tangent: String,
    /// Steps from the hypothesis `D'`, the range of the variable, to that of the tangent, and to a goal in tangents.
    pub(super) to_tangents: String,
    /// Steps from a tangent `y'0` inside of its range to a variable in its own, and back to the functions as they are written.
    pub(super) from_tangents: String,
}

/// A family with everything that its theorems mention.
pub(super) struct Subject<'a> {
    pub(super) family: &'a Family,
    pub(super) formulas: &'a Formulas,
    /// The identifiers of the definitions.
    pub(super) definitions: &'a [String],
    /// The identifiers of the variables.
    pub(super) names: &'a [String],
    /// Why no denominator vanishes.
    pub(super) obligations: &'a [&'a Proof],
    /// Of a family with an angle what is said of it.
    pub(super) angle: Option<OfAngle<'a>>,
}

impl Subject<'_> {
    /// The theorems that a claim makes, with the identifiers that begin with `name`.
    pub(super) fn theorems(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &Claimed,
        verdict: &Verdict,
    ) -> Result<Vec<String>, Missing> {
        let sides = claimed.all.iter().flat_map(|compared| [&compared.left, &compared.right]);
        if sides.into_iter().any(|side| quotients::integrated(side, self.formulas)) {
            return Err("an integral of a quotient");
        }
        match verdict {
            Verdict::Undecided(_) => Err("an undecided claim"),
            Verdict::Proved(evidence) => {
                if let ClaimKind::Independent(except) = &claim.kind {
                    self.is_simple()?;
                    let (_, proof) = evidence.steps().first().ok_or("a claim without a proof")?;
                    return self.independent(name, except, proof);
                }
                each_proved(name, claimed, evidence, &mut |name, compared, proof| {
                    self.proved(name, claimed, compared, proof)
                })
            }
            Verdict::Refuted(witness) => Ok(vec![self.refuted(name, claim, claimed, witness)?]),
        }
    }

    /// Independence is about one span, without assumptions.
    fn is_simple(&self) -> Result<(), Missing> {
        match (self.family.pieces.is_empty(), self.family.constraints.is_empty()) {
            (false, _) => Err("independence on several spans"),
            (_, false) => Err(ASSUMED),
            _ => Ok(()),
        }
    }

    pub(super) fn writer<'w>(&'w self, variables: &'w dyn Fn(usize) -> Option<String>) -> Writer<'w> {
        Writer { definitions: self.definitions, variables }
    }

    /// The family, or the span of it on which something is said.
    fn on(&self, compared: &Compared) -> &Family {
        self.family.pieces.get(compared.span).map_or(self.family, |piece| piece)
    }

    /// A comparison that holds everywhere.
    fn proved(
        &self,
        name: &str,
        claimed: &Claimed,
        compared: &Compared,
        proof: &Proof,
    ) -> Result<String, Missing> {
        let family = self.on(compared);
        let (frame, boxed, variables, signs) = match proof.statement() {
            Statement::Zero { value, domain } if !family.simplices.is_empty() && family.is_rational() => {
                // Denominators do not vanish on the simplex alone.
                let chart = Chart::new(domain, [&value.numerator, &value.denominator]);
                let chart = chart.map_err(|_| "a domain that has no chart")?;
                let frame = Frame::new(family, self.names, &claimed.fixed, Some((domain, &chart)));
                (frame, Vec::new(), Vec::new(), None)
            }
            Statement::Zero { .. } => {
                let frame = Frame::new(family, self.names, &claimed.fixed, None);
                (frame, Vec::new(), Vec::new(), None)
            }
            Statement::Sign { .. } if !family.constraints.is_empty() => return Err(ASSUMED),
            Statement::Sign { value, domain, .. } => {
                let chart = Chart::new(domain, [&value.numerator, &value.denominator]);
                let chart = chart.map_err(|_| "a domain that has no chart")?;
                let frame = Frame::new(family, self.names, &claimed.fixed, Some((domain, &chart)));
                let ranges = chart.region().ranges.clone();
                let signs = Signs::of(proof, &chart, &ranges)?;
                let boxed: Vec<Var> = domain.region.ranges.iter().map(|(v, _)| *v).collect();
                (frame, boxed, ranges, Some(signs))
            }
            _ => return Err("a statement of another kind"),
        };
        let frame = frame.ok_or("a point that varies on a simplex")?;
        let env = frame.env();
        // The variables of a chart follow, in the same order.
        let same = boxed.iter().map(|v| v.0).eq(env.iter().copied().take(boxed.len()));
        if !variables.is_empty() && (variables.len() != env.len() || !same) {
            return Err("a domain that is described in another way");
        }
        let (left, right) = (frame.put(&compared.left), frame.put(&compared.right));
        let names = |v: usize| self.names.get(v).cloned();
        let writer = self.writer(&names);
        let data = |term: &Term| writer.data(term, &env);
        let common = format!("{} {}", frame.ranges(), self.defined(&frame));
        let by = |lemma: &str, a: &Term, b: &Term| {
            let lemma = signs.as_ref().map_or_else(String::new, |signs| signs.lemma(lemma, &common));
            format!("{lemma} {} {} {} _ _", data(a), data(b), frame.values())
        };
        let goal = writer.compared(&compared.left, compared.comparison, &compared.right);
        let (goal, proof) = match (compared.comparison, &left, &compared.left) {
            (
                Comparison::Equal,
                Term::Derivative { body, bound, at },
                Term::Derivative { body: own, bound: own_bound, at: own_at },
            ) => {
                let goal = writer.derived(own, *own_bound, own_at, &compared.right);
                let function = writer.body(body, *bound, &env);
                let arguments = format!("{function} {} {} {}", data(at), data(&right), frame.values());
                (goal, format!("derivative_by {common} {arguments} _ _"))
            }
            (
                Comparison::Equal,
                Term::Integral { body, bound, low, high },
                Term::Integral { body: own, bound: own_bound, low: own_low, high: own_high },
            ) => {
                let goal = writer.integrated(own, *own_bound, [own_low, own_high], &compared.right);
                let ends = format!("{} {}", data(low), data(high));
                let arguments = format!("{} {ends} {}", writer.body(body, *bound, &env), data(&right));
                (goal, format!("integral_by {common} {arguments} {} _ _", frame.values()))
            }
            (Comparison::Equal, ..) => {
                (goal, format!("equal_by {common} {} {} {} _ _", data(&left), data(&right), frame.values()))
            }
            (Comparison::LessEqual, ..) => (goal, by("le", &left, &right)),
            (Comparison::Less, ..) => (goal, by("lt", &left, &right)),
            (Comparison::GreaterEqual, ..) => (goal, format!("Rle_ge _ _ ({})", by("le", &right, &left))),
            (Comparison::Greater, ..) => (goal, format!("Rlt_gt _ _ ({})", by("lt", &right, &left))),
            (Comparison::NotEqual, ..) => return Err("a comparison that is no claim"),
        };
        let steps = self.introduced(&frame);
        let text = format!(
            "Theorem {name} : {}{goal}.\nProof.\n{steps}  refine ({proof}); [run | box].\nQed.\n",
            self.stated(&frame)
        );
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }

    /// The variables and hypotheses in front of a goal.
    fn stated(&self, frame: &Frame) -> String {
        let hypotheses: Vec<String> = frame.hypotheses.iter().map(|h| format!("  {h} ->\n")).collect();
        format!("forall {} : R,\n{}  ", self.names.join(" "), hypotheses.concat())
    }

    /// The first steps of a proof.
    fn introduced(&self, frame: &Frame) -> String {
        let hypotheses: Vec<String> = (0..frame.hypotheses.len()).map(|k| format!(" H'{k}")).collect();
        let steps: Vec<String> = frame.steps.iter().map(|step| format!("  {step}\n")).collect();
        format!("  intros {}{}.\n{}", self.names.join(" "), hypotheses.concat(), steps.concat())
    }

    /// Certificates that denominators do not vanish, for the variables of a frame.
    fn defined(&self, frame: &Frame) -> String {
        let variables: Vec<(Var, Range)> =
            frame.independent.iter().map(|(v, _, range)| (Var(*v), range.clone())).collect();
        self.defined_on(&variables)
    }

    /// The same for variables with their ranges.
    pub(super) fn defined_on(&self, variables: &[(Var, Range)]) -> String {
        let known = self.obligations.iter().filter_map(|proof| certificate::by_cuts(proof, variables).ok());
        let mut all: Vec<String> = known.map(|(above, _)| above).filter(|c| c != "Direct").collect();
        all.dedup();
        format!("[{}]", all.join("; "))
    }

    /// A comparison that fails at a point.
    fn refuted(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &Claimed,
        witness: &Witness,
    ) -> Result<String, Missing> {
        if let ClaimKind::Independent(except) = &claim.kind {
            self.is_simple()?;
            return self.refuted_independence(name, except, witness);
        }
        if !self.family.constraints.is_empty() {
            return Err(ASSUMED);
        }
        let subject = basis_engine::Subject::Family(std::rc::Rc::new(self.family.clone()));
        let statements = state::statements(&subject, claim, &[]).ok_or("a claim that is too long")?;
        let refuted = witness.refutation().statement();
        let place = statements
            .iter()
            .position(|s| s.of == witness.of_statement() && s.statement == *refuted)
            .ok_or("a statement that is not there")?;
        let compared = claimed.all.get(place).ok_or("formulas that cannot be told apart")?;
        let value = |name: &String| -> Result<Rational, Missing> {
            match witness.at.iter().find(|(n, _)| n == name) {
                Some((_, Coordinate::Rational(x))) => Ok(x.clone()),
                Some(_) => Err("a refutation at an irrational point"),
                None => Err("a refutation at a point that is not complete"),
            }
        };
        let point = self.family.names.iter().map(value).collect::<Result<Vec<_>, _>>()?;
        let put = |term: &Term| term.put(&|v| point.get(v).cloned().map(Term::Number));
        let frame = Frame::new(self.on(compared), self.names, &claimed.fixed, None);
        let frame = frame.ok_or("a point that varies")?;
        let names = |v: usize| self.names.get(v).cloned();
        let writer = self.writer(&names);
        let goal = writer.compared(&compared.left, compared.comparison, &compared.right);
        let (left, right) = (writer.data(&put(&compared.left), &[]), writer.data(&put(&compared.right), &[]));
        let proof = fails(compared.comparison, &left, &right, witness.value.is_negative())
            .ok_or("a comparison that is no claim")?;
        let hypotheses: Vec<String> = frame.hypotheses.iter().map(|h| format!("  {h} /\\\n")).collect();
        let numbers: Vec<String> = point.iter().map(number).collect();
        let splits = "  split; [repeat split; lra |].\n".repeat(frame.hypotheses.len());
        Ok(format!(
            "Theorem {name} : exists {} : R,\n{}  ~ {}.\nProof.\n  exists {}.\n{splits}  refine ({proof}); run.\nQed.\n",
            self.names.join(" "),
            hypotheses.concat(),
            format_args!("({goal})"),
            numbers.join(", "),
        ))
    }
}

/// Why a comparison of numbers, given as data, fails; of two that are said to be equal, whether the left one is less.
pub(super) fn fails(comparison: Comparison, left: &str, right: &str, is_less: bool) -> Option<String> {
    let by = |lemma: &str, a: &str, b: &str| format!("{lemma} [] [] Direct Direct {a} {b} [] _ I");
    Some(match comparison {
        Comparison::Equal if is_less => format!("Rlt_not_eq _ _ ({})", by("lt_by", left, right)),
        Comparison::Equal => format!("Rgt_not_eq _ _ (Rlt_gt _ _ ({}))", by("lt_by", right, left)),
        Comparison::LessEqual => format!("Rlt_not_le _ _ ({})", by("lt_by", right, left)),
        Comparison::GreaterEqual => format!("Rlt_not_ge _ _ ({})", by("lt_by", left, right)),
        Comparison::Less => format!("Rle_not_lt _ _ ({})", by("le_by", right, left)),
        Comparison::Greater => format!("Rle_not_gt _ _ ({})", by("le_by", left, right)),
        Comparison::NotEqual => return None,
    })
}
