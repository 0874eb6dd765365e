//! Linear independence as a statement about functions: if a combination is zero everywhere, all of its factors are.
//!
//! The kernel's certificate says which minors of the table of coefficients do not vanish. Coq gets for each function a sum
//! of coefficients of monomials in which only this function, and those that are done, have a part that is not zero: the
//! columns of the adjugate of a block.

mod table;

use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Role, Sign, Term, polynomial};
use basis_engine::model::{Factor, Parameter};
use basis_engine::{Coordinate, Family, Witness};
use basis_kernel::algebra::poly::Var;
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::collections::sort::sort;
use basis_kernel::{Certificate, Proof, Statement, Values, pieces};

use super::formula::{number, rational};
use super::frame::{between, range_data};
use super::theorem::{Missing, Subject};
use table::Table;

/// The most parts into which exceptions cut the ranges.
const MAX_PIECES: usize = 16;

impl Subject<'_> {
    /// The theorems of a claim of independence: one for all shape values but the exceptions, one for each of these.
    pub(super) fn independent(
        &self,
        name: &str,
        except: &[Values],
        proof: &Proof,
    ) -> Result<Vec<String>, Missing> {
        let Statement::Independent { rows, region, .. } = proof.statement() else {
            return Err("a statement of another kind");
        };
        let table = Table::new(self.family, rows)?;
        let parts = pieces(region, except, MAX_PIECES).ok_or("too many exceptions")?;
        let mut cases = Vec::new();
        for (k, part) in parts.iter().enumerate() {
            let steps = match proof.certificate() {
                Certificate::Direct => table.numbers()?,
                Certificate::Rank(rank) => {
                    let piece = rank.pieces.get(k).ok_or("a certificate that is too short")?;
                    if piece.change.is_some() {
                        return Err("independence by another basis");
                    }
                    table.blocks(&piece.blocks, part)?
                }
                _ => return Err("another kind of certificate"),
            };
            cases.push((part, steps));
        }
        let mut all = vec![self.everywhere(name, except, &table.quotients(), &cases)];
        if let Certificate::Rank(rank) = proof.certificate() {
            for (k, (values, factors)) in except.iter().zip(&rank.exceptions).enumerate() {
                let some = factors.iter().any(|c| c.as_constant().is_some_and(|c| !c.is_zero()));
                if !some {
                    return Err("an exception without a factor that is a number");
                }
                let factors: Vec<Term> = factors.iter().map(polynomial).collect();
                all.push(self.dependent(&format!("{name}_exception_{k}"), values, &factors, None));
            }
        }
        Ok(all)
    }

    /// A point at which the functions are dependent.
    pub(super) fn refuted_independence(
        &self,
        name: &str,
        except: &[Values],
        witness: &Witness,
    ) -> Result<String, Missing> {
        let basis_kernel::Witness::Dependent(_, factors) = witness.refutation().witness() else {
            return Err("an exception at which the functions are independent");
        };
        let factors: Option<Vec<Term>> =
            factors.iter().map(|f| f.is_constant().then(|| Term::Number(f.leading()))).collect();
        let factors = factors.ok_or("a refutation at an irrational point")?;
        let mut values = Vec::new();
        for shape in &self.family.shapes {
            match witness.at.iter().find(|(n, _)| *n == shape.name) {
                Some((_, Coordinate::Rational(x))) => values.push((shape.var, x.clone())),
                _ => return Err("a refutation at an irrational point"),
            }
        }
        let _ = except; // the kernel has checked that the point is none of them, which `lra` checks again
        Ok(self.dependent(name, &values, &factors, Some(except)))
    }

    /// Independence at all shape values but the exceptions.
    fn everywhere(
        &self,
        name: &str,
        except: &[Values],
        (below, above): &(String, Vec<String>),
        cases: &[(&Region, Vec<String>)],
    ) -> String {
        let shapes: Vec<&str> = self.family.shapes.iter().map(|p| self.names[p.var.0].as_str()).collect();
        let factors: Vec<String> = (0..self.family.functions.len()).map(|k| format!("a'{k}")).collect();
        let mut hypotheses: Vec<String> =
            self.family.shapes.iter().filter_map(|p| between(&self.names[p.var.0], &p.range)).collect();
        let ranges = hypotheses.len();
        hypotheses.extend(except.iter().map(|values| format!("~ ({})", self.values(values))));
        let lines: String = hypotheses.iter().map(|h| format!("  {h} ->\n")).collect::<Vec<_>>().concat();
        let zero: Vec<String> = factors.iter().map(|a| format!("{a} = 0")).collect();
        let quantified =
            if shapes.is_empty() { String::new() } else { format!("forall {} : R,\n", shapes.join(" ")) };
        let mut text = format!(
            "Theorem {name} : {quantified}{lines}  forall {} : R,\n  ({}) ->\n  {}.\nProof.\n",
            factors.join(" "),
            self.vanishes(&factors),
            zero.join(" /\\ "),
        );
        let names: Vec<String> = (0..hypotheses.len()).map(|k| format!(" H'{k}")).collect();
        let shape_names: String = shapes.iter().map(|s| format!(" {s}")).collect::<Vec<_>>().concat();
        text += &format!("  intros{shape_names}{} {} H'.\n", names.concat(), factors.join(" "));
        text += &format!("  set (A' := fun k : nat => nth k [{}] 0).\n", factors.join("; "));
        text += "  assert (Z' : forall k, (k < length [";
        text += &factors.join("; ");
        text += "])%nat -> A' k = 0).\n  {\n";
        // The ranges without the exceptions.
        let parts: Vec<String> = cases.iter().map(|(part, _)| self.part(part)).collect();
        if cases.len() > 1 || ranges < hypotheses.len() {
            text += &format!("    assert (P' : {}).\n    {{ ", parts.join(" \\/ "));
            for (var, x) in except.iter().flatten() {
                text += &format!(
                    "destruct (Rtotal_order {} {}) as [? | [? | ?]]; ",
                    self.names[var.0],
                    number(x)
                );
            }
            text += "try (exfalso; lra); apart. }\n";
            if cases.len() > 1 {
                // a \/ (b \/ (c \/ ...)
                let pattern = (1..cases.len()).fold(String::from("P'"), |inner, _| format!("[P' | {inner}]"));
                text += &format!("    destruct P' as {pattern}.\n");
            }
        }
        let order: Vec<usize> = self.order();
        let dims = self.dims();
        let variables: Vec<String> = (0..dims.len()).map(|k| format!("y'{k}")).collect();
        let functions = self.functions(&order);
        let values: Vec<&str> = shapes.clone();
        for (part, steps) in cases {
            let sides: Vec<String> =
                self.family.shapes.iter().map(|p| range_data(&part.range(p.var))).collect();
            let dims: Vec<String> =
                dims.iter().map(|(a, b)| format!("({}%Q, {}%Q)", rational(a), rational(b))).collect();
            text += &format!(
                "    {{ refine (independent_by [{}] {} [{}] [{}]\n      ({below})\n      [{}]\n      [{}]\n      [{}] A' _ _ _); [run | box |].\n",
                sides.join("; "),
                self.defined_on(&variables_of(self.family)),
                dims.join("; "),
                functions.join("; "),
                above.join(";\n       "),
                steps.join(";\n       "),
                values.join("; ")
            );
            let destruct =
                variables.iter().rev().fold(String::from("[|]"), |inner, y| format!("[|{y} {inner}]"));
            let products = |variables: &[String], written: bool| -> Vec<String> {
                let each = factors.iter().enumerate();
                each.map(|(k, a)| format!("{a} * {}", self.at(k, variables, written))).collect()
            };
            let nested = products(&variables, false);
            let nested = nested.iter().rev().fold(String::from("0"), |sum, p| format!("{p} + ({sum})"));
            text += &format!("      intros xs' X'. destruct xs' as {destruct}; simpl in X'; try tauto.\n");
            text += "      cbv [inside fst snd Q2R Qnum Qden] in X'.\n";
            text += &format!("      change ({nested} = 0).\n");
            let (places, steps, last) = match &self.angle {
                None => (variables.clone(), "", "lra"),
                Some(angle) => (vec![String::from("t'")], angle.from_tangents.as_str(), "arrive"),
            };
            text += steps;
            text += &format!("      transitivity ({}); [ring |].\n", products(&places, true).join(" + "));
            text += &format!("      apply H'; {last}. }}\n");
        }
        text += "  }\n";
        for (k, a) in factors.iter().enumerate() {
            text += &format!("  assert ({a} = 0) by (apply (Z' {k}%nat); simpl; lia).\n");
        }
        text += "  repeat split; assumption.\nQed.\n";
        text
    }

    /// At values of shape parameters, the others free, a combination with factors is zero everywhere.
    ///
    /// With exceptions, that the point is none of them, as a refutation; else as a theorem about all other shape values.
    fn dependent(&self, name: &str, values: &Values, factors: &[Term], refuted: Option<&[Values]>) -> String {
        let shapes: Vec<&str> = self.family.shapes.iter().map(|p| self.names[p.var.0].as_str()).collect();
        let unknown: Vec<String> = (0..factors.len()).map(|k| format!("a'{k}")).collect();
        let own = |v: usize| self.names.get(v).cloned();
        let writer = self.writer(&own);
        let given: Vec<String> = factors.iter().map(|f| writer.argument(f)).collect();
        let zero: Vec<String> = unknown.iter().map(|a| format!("{a} = 0")).collect();
        let claim = format!(
            "exists {} : R,\n  ~ ({}) /\\\n  ({})",
            unknown.join(" "),
            zero.join(" /\\ "),
            self.vanishes(&unknown)
        );
        let ranges: Vec<String> =
            self.family.shapes.iter().filter_map(|p| between(&self.names[p.var.0], &p.range)).collect();
        let mut text = format!("Theorem {name} : ");
        let conditions: Vec<String> = match refuted {
            None => ranges.into_iter().chain([self.values(values)]).collect(),
            Some(except) => {
                ranges.into_iter().chain(except.iter().map(|v| format!("~ ({})", self.values(v)))).collect()
            }
        };
        let (quantifier, sign) = if refuted.is_some() { ("exists", "/\\") } else { ("forall", "->") };
        if !shapes.is_empty() {
            text += &format!("{quantifier} {} : R,\n", shapes.join(" "));
            for condition in &conditions {
                text += &format!("  {condition} {sign}\n");
            }
        }
        text += &format!("  {claim}.\nProof.\n");
        if refuted.is_some() {
            if !shapes.is_empty() {
                let point: Vec<String> = values.iter().map(|(_, x)| number(x)).collect();
                text += &format!("  exists {}.\n", point.join(", "));
                text += &"  split; [repeat split; lra |].\n".repeat(conditions.len());
            }
        } else {
            let names: Vec<String> = (0..conditions.len()).map(|k| format!(" H'{k}")).collect();
            let last = conditions.len() - 1;
            let equal: Vec<String> = (0..values.len()).map(|k| format!("E'{k}")).collect();
            text += &format!("  intros {}{}.\n", shapes.join(" "), names.concat());
            if values.len() > 1 {
                text += &format!("  destruct H'{last} as ({}).\n", equal.join(" & "));
            }
            for (var, _) in values {
                text += &format!("  subst {}.\n", self.names[var.0]);
            }
        }
        text += &format!("  exists {}.\n", given.join(", "));
        text += "  split; [intros N'; repeat match goal with H : _ /\\ _ |- _ => destruct H end; lra |].\n";
        // The sum is zero by computing, at any point.
        let put = |term: &Term| {
            term.put(&|v| values.iter().find(|(var, _)| var.0 == v).map(|(_, x)| Term::Number(x.clone())))
        };
        let independent: Vec<usize> = self.family.domain.iter().map(|p| p.var.0).collect();
        let free = self.family.shapes.iter().filter(|p| values.iter().all(|(v, _)| *v != p.var));
        let env: Vec<usize> = independent.iter().copied().chain(free.clone().map(|p| p.var.0)).collect();
        let last = |term: Term| term.put(&|v| self.rest(v));
        let parts = self.formulas.functions.iter().zip(factors).map(|(f, factor)| {
            let call = Term::Call(*f, self.arguments());
            (Sign::Plus, Term::Product(vec![(Role::Factor, put(factor)), (Role::Factor, last(put(&call)))]))
        });
        let sum = Term::Sum(parts.collect());
        match &self.angle {
            None => text += &format!("  intros {}; intros.\n", self.coordinates().join(" ")),
            Some(angle) => text += &format!("  intros {} D'.\n{}", angle.variable, angle.to_tangents),
        }
        for factor in self.family.factors() {
            if let Factor::Simplex(others, p) = factor {
                let others: Vec<&str> = others.iter().map(|p| self.names[p.var.0].as_str()).collect();
                let w = &self.names[p.var.0];
                text += &format!("  assert ({w} = 1 - {}) by lra; subst {w}.\n", others.join(" - "));
            }
        }
        let side = |p: &Parameter| match self.simplex_of(p.var) {
            Some(_) => String::from("(Inf, Inf)"),
            None => range_data(&p.range),
        };
        let mut sides: Vec<String> = self.family.domain.iter().map(side).collect();
        sides.extend(free.map(|p| range_data(&p.range)));
        let open: Vec<(Var, Range)> =
            variables_of(self.family).into_iter().filter(|(v, _)| env.contains(&v.0)).collect();
        let own = |v: &usize| match &self.angle {
            Some(angle) if independent.contains(v) => angle.tangent.as_str(),
            _ => self.names[*v].as_str(),
        };
        let point: Vec<&str> = env.iter().map(own).collect();
        text += &format!(
            "  refine (equal_by [{}] {} {} (Num 0) [{}] _ _); [run | box].\nQed.\n",
            sides.join("; "),
            self.defined_on(&open),
            writer.data(&sum, &env),
            point.join("; ")
        );
        text
    }

    /// A box as a condition of the shape parameters.
    fn part(&self, part: &Region) -> String {
        let ranges = self.family.shapes.iter().filter_map(|p| {
            let range = part.range(p.var);
            let low = match &range.low {
                End::Infinite => None,
                End::Included(x) => Some(format!("{} <= {}", number(x), self.names[p.var.0])),
                End::Excluded(x) => Some(format!("{} < {}", number(x), self.names[p.var.0])),
            };
            let high = match &range.high {
                End::Infinite => None,
                End::Included(x) => Some(format!("{} <= {}", self.names[p.var.0], number(x))),
                End::Excluded(x) => Some(format!("{} < {}", self.names[p.var.0], number(x))),
            };
            let both: Vec<String> = low.into_iter().chain(high).collect();
            (!both.is_empty()).then(|| both.join(" /\\ "))
        });
        let ranges: Vec<String> = ranges.collect();
        if ranges.is_empty() { String::from("True") } else { format!("({})", ranges.join(" /\\ ")) }
    }

    /// The values of an exception.
    fn values(&self, values: &Values) -> String {
        let all: Vec<String> =
            values.iter().map(|(v, x)| format!("{} = {}", self.names[v.0], number(x))).collect();
        all.join(" /\\ ")
    }

    /// That a combination is zero on the whole domain.
    fn vanishes(&self, factors: &[String]) -> String {
        let coordinates = self.coordinates();
        let mut text = format!("forall {} : R, ", coordinates.join(" "));
        if let Some(angle) = &self.angle {
            text += &format!("{} -> ", angle.domain);
        } else {
            for factor in self.family.factors() {
                let own: Vec<&str> = factor.variables().map(|p| self.names[p.var.0].as_str()).collect();
                match factor {
                    Factor::Interval(p) => {
                        let range = between(&self.names[p.var.0], &p.range);
                        text += &range.map_or_else(String::new, |range| format!("{range} -> "));
                    }
                    Factor::Simplex(..) => {
                        for x in &own {
                            text += &format!("0 <= {x} -> ");
                        }
                        text += &format!("{} = 1 -> ", own.join(" + "));
                    }
                }
            }
        }
        let names: Vec<String> = coordinates.iter().map(|x| (*x).to_string()).collect();
        let sum: Vec<String> = factors
            .iter()
            .enumerate()
            .map(|(k, a)| format!("{a} * {}", self.called(k, &names, true)))
            .collect();
        format!("{text}{} = 0", sum.join(" + "))
    }

    /// The identifiers of all coordinates of a point.
    fn coordinates(&self) -> Vec<&str> {
        match &self.angle {
            Some(angle) => vec![angle.variable.as_str()],
            None => self.variables().into_iter().map(|v| self.names[v].as_str()).collect(),
        }
    }

    /// The domain variables in the order in which functions take them.
    fn variables(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.family.domain_variables().map(|p| p.var.0).collect();
        sort(&mut all);
        all
    }

    /// The other coordinates of the simplex to which a coordinate belongs, without the last, and the last.
    fn simplex_of(&self, var: Var) -> Option<(Vec<usize>, usize)> {
        self.family.factors().into_iter().find_map(|factor| match factor {
            Factor::Simplex(others, last) if factor.variables().any(|p| p.var == var) => {
                Some((others.iter().map(|p| p.var.0).collect(), last.var.0))
            }
            _ => None,
        })
    }

    /// 1 minus the others, for the last coordinate of a simplex.
    fn rest(&self, variable: usize) -> Option<Term> {
        let (others, _) = self.simplex_of(Var(variable)).filter(|(_, last)| *last == variable)?;
        let others = others.into_iter().map(|v| (Sign::Minus, Term::Variable(v)));
        Some(Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect()))
    }

    /// The arguments of a function as data: all variables, or shape parameters and the tangent.
    fn arguments(&self) -> Vec<Term> {
        match &self.angle {
            None => (0..self.names.len()).map(Term::Variable).collect(),
            Some(_) => self
                .family
                .shapes
                .iter()
                .chain(&self.family.domain)
                .map(|p| Term::Variable(p.var.0))
                .collect(),
        }
    }

    /// A basis function at all coordinates of a point, as it is written or else in tangents.
    fn called(&self, function: usize, coordinates: &[String], written: bool) -> String {
        let definitions = match &self.angle {
            Some(angle) if written => angle.definitions,
            _ => self.definitions,
        };
        let shapes = self.family.shapes.iter().map(|p| self.names[p.var.0].clone());
        let args: Vec<String> = shapes.chain(coordinates.iter().cloned()).collect();
        format!("{} {}", definitions[self.formulas.functions[function]], args.join(" "))
    }

    /// A basis function at independent coordinates.
    fn at(&self, function: usize, variables: &[String], written: bool) -> String {
        let own =
            |v: usize| self.family.domain.iter().position(|p| p.var.0 == v).map(|k| variables[k].clone());
        let coordinate = |v: usize| match self.rest(v) {
            Some(rest) => format!("({})", self.writer(&own).text(&rest)),
            None => own(v).unwrap_or_default(),
        };
        let coordinates: Vec<String> = match &self.angle {
            Some(_) => variables.to_vec(),
            None => self.variables().into_iter().map(coordinate).collect(),
        };
        self.called(function, &coordinates, written)
    }

    /// The numbers of the domain variables, and then of the shape parameters.
    fn order(&self) -> Vec<usize> {
        self.family.domain.iter().chain(&self.family.shapes).map(|p| p.var.0).collect()
    }

    /// The basis functions as data, in independent coordinates.
    fn functions(&self, order: &[usize]) -> Vec<String> {
        let none = |_: usize| None;
        let writer = self.writer(&none);
        let args: Vec<Term> = self.arguments().iter().map(|x| x.put(&|v| self.rest(v))).collect();
        let calls = self.formulas.functions.iter().map(|f| Term::Call(*f, args.clone()));
        calls.map(|call| writer.data(&call, order)).collect()
    }

    /// An interval for each independent coordinate, all together inside of the domain.
    fn dims(&self) -> Vec<(Rational, Rational)> {
        let inside = |p: &Parameter| match self.simplex_of(p.var) {
            Some((others, _)) => Some((Rational::ZERO, Rational::new(1, others.len() as i64))),
            None => p.range.finite().map(|(a, b)| (a.clone(), b.clone())),
        };
        self.family.domain.iter().filter_map(inside).collect()
    }
}

/// The independent domain variables, and then the shape parameters, with their ranges.
fn variables_of(family: &Family) -> Vec<(Var, Range)> {
    family.domain.iter().chain(&family.shapes).map(|p| (p.var, p.range.clone())).collect()
}
