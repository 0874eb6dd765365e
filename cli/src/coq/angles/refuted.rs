//! A comparison of functions of an angle that fails: at the angle whose half has the tangent of the counterexample.

use std::rc::Rc;

use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Claimed, Term};
use basis_engine::{Claim, Coordinate, Witness, state};
use basis_kernel::Statement;

use super::super::formula::{Writer, number};
use super::super::frame::between;
use super::super::theorem::{Missing, fails};
use super::{Angular, OTHER, PI, any};

impl Angular<'_> {
    /// A theorem that says where a comparison fails.
    pub(super) fn refuted(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &Claimed,
        witness: &Witness,
    ) -> Result<String, Missing> {
        let subject = basis_engine::Subject::Family(Rc::new(self.family.clone()));
        let statements = state::statements(&subject, claim, &[]).ok_or("a claim that is too long")?;
        let refuted = witness.refutation().statement();
        let known = |s: &state::Stated| s.of == witness.of_statement() && s.statement == *refuted;
        let place = statements.iter().position(known).ok_or("a statement that is not there")?;
        let compared = claimed.all.get(place).ok_or("formulas that cannot be told apart")?;
        let (Statement::Zero { value, .. } | Statement::Sign { value, .. }) = refuted else {
            return Err("a statement of another kind");
        };
        let pi = self.family.analytic.pi;
        if pi.is_some_and(|pi| value.numerator.depends_on(pi) || value.denominator.depends_on(pi)) {
            return Err("a refutation with pi");
        }
        let coordinate = |name: &str| -> Result<Rational, Missing> {
            match witness.at.iter().find(|(n, _)| n == name) {
                Some((_, Coordinate::Rational(x))) => Ok(x.clone()),
                Some(_) => Err("a refutation at an irrational point"),
                None => Err("a refutation at a point that is not complete"),
            }
        };
        let (variable, tangent) = (self.variable(), self.tangent());
        let own = self.family.domain.first().ok_or(OTHER)?;
        // The angle has a value in the claim, or the counterexample gives it without its tangent.
        let given = claimed.fixed.iter().find(|(v, _)| *v == variable).map(|(_, value)| value.clone());
        let given = given.or_else(|| coordinate(&self.turn.angle.name).ok().map(Term::Number));
        let fixed = given.as_ref();
        let x = match fixed {
            None => Term::Number(coordinate(&self.turn.angle.tangent_name())?),
            Some(value) => self.tangent_of(value, &[]).ok_or("a value at another angle")?,
        };
        let mut point: Vec<(usize, Rational)> = Vec::new();
        for p in &self.family.shapes {
            point.push((p.var.0, coordinate(&p.name)?));
        }
        let put = |term: &Term| {
            let shape = |v: usize| point.iter().find(|(p, _)| *p == v).map(|(_, x)| Term::Number(x.clone()));
            term.put(&|v| shape(v).or_else(|| fixed.filter(|_| v == variable).cloned()))
        };
        let (left, right) = (put(&compared.left), put(&compared.right));
        let angles = [(variable, x.clone())];
        let (below, above) = (self.put(&left, &angles)?, self.put(&right, &angles)?);
        if [&below, &above].iter().any(|side| any(side, &|part| *part == Term::Variable(PI))) {
            return Err("a refutation with pi");
        }
        // What is said.
        let names = |v: usize| self.names.get(v).cloned();
        let writer = Writer { definitions: self.definitions, variables: &names };
        let t = &self.names[variable];
        let shapes = self.family.shapes.iter();
        let mut hypotheses: Vec<String> =
            shapes.clone().filter_map(|p| between(&self.names[p.var.0], &p.range)).collect();
        hypotheses.push(self.domain(t).ok_or(OTHER)?);
        for (v, value) in &claimed.fixed {
            hypotheses.push(format!("{} = {}", self.names[*v], writer.text(value)));
        }
        let quantified: Vec<&str> =
            shapes.map(|p| self.names[p.var.0].as_str()).chain([t.as_str()]).collect();
        let conditions: Vec<String> = hypotheses.iter().map(|h| format!("  {h} /\\\n")).collect();
        let conditions = conditions.concat();
        let goal = writer.compared(&compared.left, compared.comparison, &compared.right);
        let mut text = format!(
            "Theorem {name} : exists {} : R,\n{conditions}  ~ ({goal}).\nProof.\n",
            quantified.join(" ")
        );
        // Where it is.
        let (angle, bounds) = match fixed {
            Some(value) => {
                let angle = writer.argument(value);
                text += &format!("  assert (Q' : - PI < {} < PI) by angle.\n", self.turn.text(&angle));
                (angle, Vec::new())
            }
            None => {
                let x = writer.argument(&x);
                text += &format!("  {}\n", self.arrival(&x));
                (String::from("t'"), self.angle_bounds(&own.range, "t'", &x)?)
            }
        };
        for step in bounds {
            text += &format!("  {step}\n");
        }
        let numbers = point.iter().map(|(_, x)| number(x)).chain([angle.clone()]);
        text += &format!("  exists {}.\n", numbers.collect::<Vec<_>>().join(", "));
        text += &"  split; [arrive |].\n".repeat(hypotheses.len());
        // Why.
        let place = match fixed {
            Some(value) => writer.argument(value),
            None => angle,
        };
        let placed = |v: usize| {
            let shape = point.iter().find(|(p, _)| *p == v).map(|(_, x)| number(x));
            if v == variable { Some(place.clone()) } else { shape.or_else(|| names(v)) }
        };
        let both = left.minus(right);
        for step in self.steps(&both, &[(variable, place.clone())], "Q'", &placed)? {
            text += &format!("  {step}.\n");
        }
        for at in self.numbers(&both) {
            text += &format!("  try {}.\n", self.fixed(&at)?);
        }
        text += match fixed {
            None => "  rewrite ?T'.\n",
            Some(_) => "",
        };
        let tangents = self.all_in_tangents();
        let data = Writer { definitions: &tangents, variables: &names };
        let (a, b) = (data.data(&below, &[tangent]), data.data(&above, &[tangent]));
        let proof = fails(compared.comparison, &a, &b, witness.value.is_negative())
            .ok_or("a comparison that is no claim")?;
        text += &format!("  refine ({proof}); run.\nQed.\n");
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }
}
