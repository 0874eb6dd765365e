//! Claims of a family with an angle as theorems with their proofs.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Var;
use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Claimed, Compared, Comparison, Term};
use basis_engine::{Claim, ClaimKind, Verdict};
use basis_kernel::{Chart, Proof, Statement};

use super::super::certificate::{self, Signs};
use super::super::formula::{Writer, number};
use super::super::frame::{between, range_data};
use super::super::theorem::{Missing, OfAngle, Subject, each_proved};
use super::{Angular, OTHER, PI, any};

impl Angular<'_> {
    /// The theorems that a claim makes, with the identifiers that begin with `name`.
    pub(in crate::coq) fn theorems(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &Claimed,
        verdict: &Verdict,
    ) -> Result<Vec<String>, Missing> {
        match (verdict, &claim.kind) {
            (Verdict::Undecided(_), _) => Err("an undecided claim"),
            (Verdict::Proved(evidence), ClaimKind::Independent(except)) => {
                let (_, proof) = evidence.steps().first().ok_or("a claim without a proof")?;
                self.with_tangents(|family| family.independent(name, except, proof))
            }
            (Verdict::Refuted(witness), ClaimKind::Independent(except)) => {
                self.with_tangents(|family| Ok(vec![family.refuted_independence(name, except, witness)?]))
            }
            (Verdict::Proved(evidence), _) => {
                each_proved(name, claimed, evidence, &mut |name, compared, proof| {
                    self.proved(name, claimed, compared, proof)
                })
            }
            (Verdict::Refuted(witness), _) => Ok(vec![self.refuted(name, claim, claimed, witness)?]),
        }
    }

    /// The family as one of quotients in the tangent.
    fn with_tangents<T>(&self, run: impl FnOnce(&Subject<'_>) -> Result<T, Missing>) -> Result<T, Missing> {
        let definitions = self.all_in_tangents();
        let own = self.family.domain.first().ok_or(OTHER)?;
        let variable = self.names[self.variable()].clone();
        let functions: Vec<&String> = self.formulas.functions.iter().map(|f| &self.definitions[*f]).collect();
        if self.formulas.functions.iter().any(|f| !self.turning[*f]) {
            return Err("a function without the angle");
        }
        let mut to_tangents =
            format!("  assert (X' : - PI < {} < PI) by angle.\n", self.turn.text(&variable));
        to_tangents += &self.tangent_bounds(&own.range, &variable, "D'")?;
        let mut from_tangents = format!("      {}\n", self.arrival("y'0"));
        for step in self.angle_bounds(&own.range, "t'", "y'0")? {
            from_tangents += &format!("      {step}\n");
        }
        from_tangents += "      rewrite <- T'.\n";
        for f in functions {
            to_tangents += &format!("  rewrite ?{f}'angle by exact X'.\n");
            from_tangents += &format!("      rewrite <- ?{f}'angle by exact Q'.\n");
        }
        run(&Subject {
            family: self.family,
            formulas: self.formulas,
            definitions: &definitions,
            names: self.names,
            obligations: self.obligations,
            angle: Some(OfAngle {
                definitions: self.definitions,
                domain: self.domain(&variable).ok_or(OTHER)?,
                tangent: self.turn.tangent_text(&variable),
                variable,
                to_tangents,
                from_tangents,
            }),
        })
    }

    /// A comparison that holds everywhere.
    fn proved(
        &self,
        name: &str,
        claimed: &Claimed,
        compared: &Compared,
        proof: &Proof,
    ) -> Result<String, Missing> {
        let (variable, tangent) = (self.variable(), self.tangent());
        let own = self.family.domain.first().ok_or(OTHER)?;
        let fixed = claimed.fixed.iter().find(|(v, _)| *v == variable).map(|(_, value)| value);
        // Shape parameters, and then the tangent.
        let mut independent: Vec<(usize, Range)> = Vec::new();
        for p in &self.family.shapes {
            if claimed.fixed.iter().all(|(v, _)| *v != p.var.0) {
                independent.push((p.var.0, p.range.clone()));
            }
        }
        if fixed.is_none() {
            independent.push((tangent, own.range.clone()));
        }
        let mut signs = None;
        if let Statement::Sign { value, domain, .. } = proof.statement() {
            let pi = self.family.analytic.pi;
            if pi.is_some_and(|pi| value.numerator.depends_on(pi) || value.denominator.depends_on(pi)) {
                return Err("an inequality with pi");
            }
            let chart = Chart::new(domain, [&value.numerator, &value.denominator]);
            let chart = chart.map_err(|_| "a domain that has no chart")?;
            let ranges: Vec<(Var, Range)> =
                chart.region().ranges.iter().filter(|(v, _)| Some(*v) != pi).cloned().collect();
            signs = Some(Signs::of(proof, &chart, &ranges)?);
            if !ranges.iter().map(|(v, _)| v.0).eq(independent.iter().map(|(v, _)| *v)) {
                return Err("a domain that is described in another way");
            }
        }
        let put_fixed = |term: &Term| {
            term.put(&|v| claimed.fixed.iter().find(|(f, _)| *f == v).map(|(_, value)| value.clone()))
        };
        let (left, right) = (put_fixed(&compared.left), put_fixed(&compared.right));
        let angles = [(variable, Term::Variable(tangent))];
        let (below, above) = (self.put(&left, &angles)?, self.put(&right, &angles)?);
        let mut env: Vec<usize> = independent.iter().map(|(v, _)| *v).collect();
        let t = &self.names[variable];
        let text_of = |v: usize| {
            if v == tangent {
                self.turn.tangent_text(t)
            } else {
                self.names.get(v).cloned().unwrap_or_default()
            }
        };
        let mut values: Vec<String> = env.iter().map(|v| text_of(*v)).collect();
        let mut ranges: Vec<String> = independent.iter().map(|(_, range)| range_data(range)).collect();
        if [&below, &above].iter().any(|side| any(side, &|part| *part == Term::Variable(PI))) {
            env.push(PI);
            values.push(String::from("PI"));
            ranges.push(String::from("(Excl (0), Inf)"));
        }
        let defined: Vec<(Var, Range)> = independent.iter().map(|(v, r)| (Var(*v), r.clone())).collect();
        let defined = self.obligations.iter().filter_map(|proof| certificate::by_cuts(proof, &defined).ok());
        let mut defined: Vec<String> = defined.map(|(above, _)| above).filter(|c| c != "Direct").collect();
        defined.dedup();
        let common = format!("[{}] [{}]", ranges.join("; "), defined.join("; "));
        let names = |v: usize| self.names.get(v).cloned();
        let writer = Writer { definitions: self.definitions, variables: &names };
        let own_names = self.all_in_tangents();
        let tangents = Writer { definitions: &own_names, variables: &names };
        let (a, b) = (tangents.data(&below, &env), tangents.data(&above, &env));
        let values = format!("[{}]", values.join("; "));
        let by = |lemma: &str, a: &str, b: &str| {
            let lemma = signs.as_ref().map_or_else(String::new, |signs: &Signs| signs.lemma(lemma, &common));
            format!("{lemma} {a} {b} {values} _ _")
        };
        let refined = match compared.comparison {
            Comparison::Equal => format!("equal_by {common} {a} {b} {values} _ _"),
            Comparison::LessEqual => by("le", &a, &b),
            Comparison::Less => by("lt", &a, &b),
            Comparison::GreaterEqual => format!("Rle_ge _ _ ({})", by("le", &b, &a)),
            Comparison::Greater => format!("Rlt_gt _ _ ({})", by("lt", &b, &a)),
            Comparison::NotEqual => return Err("a comparison that is no claim"),
        };
        // What is said.
        let mut text = format!("Theorem {name} : forall");
        let mut introduced = Vec::new();
        let mut hypotheses: Vec<String> = Vec::new();
        for p in &self.family.shapes {
            text += &format!(" {}", self.names[p.var.0]);
            introduced.push(self.names[p.var.0].clone());
            hypotheses.extend(between(&self.names[p.var.0], &p.range));
        }
        text += &format!(" {t} : R,\n");
        introduced.push(t.clone());
        hypotheses.push(self.domain(t).ok_or(OTHER)?);
        let range = hypotheses.len() - 1;
        for (v, value) in &claimed.fixed {
            hypotheses.push(format!("{} = {}", self.names[*v], writer.text(value)));
        }
        for h in &hypotheses {
            text += &format!("  {h} ->\n");
        }
        text += &format!(
            "  {}.\nProof.\n",
            writer.compared(&compared.left, compared.comparison, &compared.right)
        );
        let marks: Vec<String> = (0..hypotheses.len()).map(|k| format!("H'{k}")).collect();
        text += &format!("  intros {} {}.\n", introduced.join(" "), marks.join(" "));
        for (v, _) in &claimed.fixed {
            text += &format!("  subst {}.\n", self.names[*v]);
        }
        let place = match fixed {
            None => t.clone(),
            Some(value) => writer.argument(value),
        };
        text += &format!("  assert (X' : - PI < {} < PI) by angle.\n", self.turn.text(&place));
        if fixed.is_none() {
            text += &self.tangent_bounds(&own.range, t, &format!("H'{range}"))?;
        }
        let names_fixed =
            |v: usize| if v == variable && fixed.is_some() { Some(place.clone()) } else { names(v) };
        let both = left.clone().minus(right.clone());
        let around = [(variable, place.clone())];
        for step in self.steps(&both, &around, "X'", &names_fixed)? {
            text += &format!("  {step}.\n");
        }
        for at in self.numbers(&both) {
            text += &format!("  try {}.\n", self.fixed(&at)?);
        }
        let positive = if env.contains(&PI) { "  pose proof PI_RGT_0.\n" } else { "" };
        text += &format!("{positive}  refine ({refined}); [run | box].\nQed.\n");
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }

    /// The range of the angle.
    pub(super) fn domain(&self, t: &str) -> Option<String> {
        let own = self.family.domain.first()?;
        let mut text = String::from(t);
        let pi = self.family.analytic.pi;
        for (k, (end, limit)) in
            [&own.range.low, &own.range.high].into_iter().zip(&self.turn.angle.limits).enumerate()
        {
            if matches!(end, End::Infinite) {
                return None;
            }
            let sign = if end.is_included() { "<=" } else { "<" };
            let value = match limit.as_constant() {
                Some(x) => number(&x),
                None => {
                    let pi = pi?;
                    let one = limit.substitute(pi, &Fraction::constant(Rational::ONE))?;
                    format!("{} * PI", number(&one.as_constant()?))
                }
            };
            text = if k == 0 { format!("{value} {sign} {text}") } else { format!("{text} {sign} {value}") };
        }
        Some(text)
    }
}
