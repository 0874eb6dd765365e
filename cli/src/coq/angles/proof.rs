//! Claims of a family with an angle as theorems with their proofs.

use basis_engine::Verdict;
use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Var;
use basis_engine::algebra::range::{End, Range};
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Claimed, Compared, Comparison, Term};
use basis_kernel::{Chart, Proof, Statement};

use super::super::certificate;
use super::super::formula::{Writer, number};
use super::super::frame::{between, range_data};
use super::super::theorem::{Missing, each_proved};
use super::{Angular, OTHER, PI, any};

impl Angular<'_> {
    /// The theorems that a claim makes, with the identifiers that begin with `name`.
    pub(in crate::coq) fn theorems(
        &self,
        name: &str,
        claimed: &Claimed,
        verdict: &Verdict,
    ) -> Result<Vec<String>, Missing> {
        let Verdict::Proved(evidence) = verdict else { return Err("a refutation beside an angle") };
        if claimed.all.is_empty() {
            return Err("independence of functions of an angle");
        }
        each_proved(name, claimed, evidence, &|name, compared, proof| {
            self.proved(name, claimed, compared, proof)
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
        let mut certificates = (String::new(), String::new());
        if let Statement::Sign { value, domain, .. } = proof.statement() {
            let pi = self.family.analytic.pi;
            if pi.is_some_and(|pi| value.numerator.depends_on(pi) || value.denominator.depends_on(pi)) {
                return Err("an inequality with pi");
            }
            let chart = Chart::new(domain, [&value.numerator, &value.denominator]);
            let chart = chart.map_err(|_| "a domain that has no chart")?;
            let ranges: Vec<(Var, Range)> =
                chart.region().ranges.iter().filter(|(v, _)| Some(*v) != pi).cloned().collect();
            certificates = certificate::by_cuts(proof, &ranges)?;
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
        let own_names: Vec<String> =
            self.definitions.iter().enumerate().map(|(k, d)| self.in_tangents(k, d)).collect();
        let tangents = Writer { definitions: &own_names, variables: &names };
        let (a, b) = (tangents.data(&below, &env), tangents.data(&above, &env));
        let values = format!("[{}]", values.join("; "));
        let (cn, cd) = certificates;
        let by = |lemma: &str, a: &str, b: &str| format!("{lemma} {common} {cn} {cd} {a} {b} {values} _ _");
        let refined = match compared.comparison {
            Comparison::Equal => format!("equal_by {common} {a} {b} {values} _ _"),
            Comparison::LessEqual => by("le_by", &a, &b),
            Comparison::Less => by("lt_by", &a, &b),
            Comparison::GreaterEqual => format!("Rle_ge _ _ ({})", by("le_by", &b, &a)),
            Comparison::Greater => format!("Rlt_gt _ _ ({})", by("lt_by", &b, &a)),
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
            for (k, (end, low)) in [(&own.range.low, true), (&own.range.high, false)].into_iter().enumerate()
            {
                let Some(x) = end.value() else { continue };
                let quarter = x.to_i64().ok_or(OTHER)?;
                let tangent = self.turn.tangent_text(t);
                let (said, lemma) = match (low, end.is_included()) {
                    (true, true) => (format!("({quarter}) <= {tangent}"), "tangent_from"),
                    (true, false) => (format!("({quarter}) < {tangent}"), "tangent_above"),
                    (false, true) => (format!("{tangent} <= ({quarter})"), "tangent_to"),
                    (false, false) => (format!("{tangent} < ({quarter})"), "tangent_below"),
                };
                text += &format!("  assert (Y'{k} : {said}) by (clear - H'{range} X'; tangent {lemma}).\n");
            }
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
    fn domain(&self, t: &str) -> Option<String> {
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
