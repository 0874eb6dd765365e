//! Linear independence as a statement about functions: if a combination is zero everywhere, all of its factors are.
//!
//! The kernel's certificate says which minors of the table of coefficients do not vanish. Coq gets for each function a sum
//! of coefficients of monomials in which only this function, and those that are done, have a part that is not zero: the
//! columns of the adjugate of a block.

use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{Role, Sign, Term, polynomial};
use basis_engine::{Coordinate, Family, Witness};
use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::work::Work;
use basis_kernel::{Certificate, Minors, Proof, Signed, Statement, Values, minor, pieces};

use super::certificate;
use super::formula::{number, rational};
use super::frame::{between, range_data};
use super::theorem::{Missing, Subject};

/// Exponents of the domain variables with a number: a part of a sum of coefficients.
type Functional = Vec<(Vec<u32>, Rational)>;

/// The most parts into which exceptions cut the ranges.
const MAX_PIECES: usize = 16;

const TOO_LONG: Missing = "a table of coefficients that is too long";

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
        if !self
            .formulas
            .functions
            .iter()
            .map(|f| self.divisors(*f))
            .collect::<Vec<_>>()
            .windows(2)
            .all(|w| w[0] == w[1])
        {
            return Err("independence of functions with different denominators");
        }
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
        let mut all = vec![self.everywhere(name, except, &cases)];
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

    /// What stands below fraction lines in a definition and in those that it calls, but for numbers: Coq reduces no
    /// fractions, so that functions have a common denominator only if it is written in the same way.
    fn divisors(&self, definition: usize) -> Vec<Term> {
        fn below(term: &Term, found: &mut Vec<Term>, called: &mut Vec<usize>) {
            match term {
                Term::Number(_) | Term::Variable(_) | Term::Pi => {}
                Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => below(x, found, called),
                Term::Sum(parts) => {
                    for (_, x) in parts {
                        below(x, found, called);
                    }
                }
                Term::Product(parts) => {
                    for (role, x) in parts {
                        if *role == Role::Divisor && !matches!(x, Term::Number(_)) {
                            found.push(x.clone());
                        }
                        below(x, found, called);
                    }
                }
                Term::Call(f, args) => {
                    if !called.contains(f) {
                        called.push(*f);
                    }
                    for x in args {
                        below(x, found, called);
                    }
                }
                Term::Derivative { body, at, .. } => {
                    below(body, found, called);
                    below(at, found, called);
                }
            }
        }
        let (mut found, mut called, mut done) = (Vec::new(), vec![definition], 0);
        while let Some(next) = called.get(done).copied() {
            done += 1;
            below(&self.formulas.definitions[next].value, &mut found, &mut called);
        }
        found
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
    fn everywhere(&self, name: &str, except: &[Values], cases: &[(&Region, Vec<String>)]) -> String {
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
                "    {{ refine (independent_by [{}] {} [{}] [{}]\n      [{}]\n      [{}] A' _ _ _); [run | box |].\n",
                sides.join("; "),
                self.defined_on(&variables_of(self.family)),
                dims.join("; "),
                functions.join("; "),
                steps.join(";\n       "),
                values.join("; ")
            );
            let destruct =
                variables.iter().rev().fold(String::from("[|]"), |inner, y| format!("[|{y} {inner}]"));
            let products: Vec<String> = factors
                .iter()
                .enumerate()
                .map(|(k, a)| format!("{a} * {}", self.at(k, &variables)))
                .collect();
            let nested = products.iter().rev().fold(String::from("0"), |sum, p| format!("{p} + ({sum})"));
            text += &format!("      intros xs' X'. destruct xs' as {destruct}; simpl in X'; try tauto.\n");
            text += "      cbv [inside fst snd Q2R Qnum Qden] in X'.\n";
            text += &format!("      change ({nested} = 0).\n");
            text += &format!("      transitivity ({}); [ring |].\n", products.join(" + "));
            text += "      apply H'; lra. }\n";
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
        let coordinates: Vec<usize> = self.family.domain_variables().map(|p| p.var.0).collect();
        let independent: Vec<usize> = self.family.domain.iter().map(|p| p.var.0).collect();
        let free = self.family.shapes.iter().filter(|p| values.iter().all(|(v, _)| *v != p.var));
        let env: Vec<usize> = independent.iter().copied().chain(free.clone().map(|p| p.var.0)).collect();
        let last = |term: Term| match self.family.simplices.first().map(|s| &s.last) {
            None => term,
            Some(p) => {
                let others = independent.iter().map(|v| (Sign::Minus, Term::Variable(*v)));
                let rest = Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(others).collect());
                term.put(&|v| (v == p.var.0).then(|| rest.clone()))
            }
        };
        let parts = self.formulas.functions.iter().zip(factors).map(|(f, factor)| {
            let call = Term::Call(*f, (0..self.names.len()).map(Term::Variable).collect());
            (Sign::Plus, Term::Product(vec![(Role::Factor, put(factor)), (Role::Factor, last(put(&call)))]))
        });
        let sum = Term::Sum(parts.collect());
        let names: Vec<&str> = coordinates.iter().map(|v| self.names[*v].as_str()).collect();
        text += &format!("  intros {}; intros.\n", names.join(" "));
        if let Some(p) = self.family.simplices.first().map(|s| &s.last) {
            let others: Vec<&str> = independent.iter().map(|v| self.names[*v].as_str()).collect();
            let w = &self.names[p.var.0];
            text += &format!("  assert ({w} = 1 - {}) by lra; subst {w}.\n", others.join(" - "));
        }
        let mut sides: Vec<String> = if self.family.is_simplex() {
            independent.iter().map(|_| String::from("(Inf, Inf)")).collect()
        } else {
            self.family.domain.iter().map(|p| range_data(&p.range)).collect()
        };
        sides.extend(free.map(|p| range_data(&p.range)));
        let open: Vec<(Var, Range)> =
            variables_of(self.family).into_iter().filter(|(v, _)| env.contains(&v.0)).collect();
        let point: Vec<&str> = env.iter().map(|v| self.names[*v].as_str()).collect();
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
        let coordinates: Vec<&str> =
            self.family.domain_variables().map(|p| self.names[p.var.0].as_str()).collect();
        let mut text = format!("forall {} : R, ", coordinates.join(" "));
        if self.family.is_simplex() {
            for x in &coordinates {
                text += &format!("0 <= {x} -> ");
            }
            text += &format!("{} = 1 -> ", coordinates.join(" + "));
        } else {
            for p in &self.family.domain {
                text += &between(&self.names[p.var.0], &p.range)
                    .map_or_else(String::new, |range| format!("{range} -> "));
            }
        }
        let names: Vec<String> = coordinates.iter().map(|x| (*x).to_string()).collect();
        let sum: Vec<String> =
            factors.iter().enumerate().map(|(k, a)| format!("{a} * {}", self.called(k, &names))).collect();
        format!("{text}{} = 0", sum.join(" + "))
    }

    /// A basis function at all coordinates of a point.
    fn called(&self, function: usize, coordinates: &[String]) -> String {
        let shapes = self.family.shapes.iter().map(|p| self.names[p.var.0].clone());
        let args: Vec<String> = shapes.chain(coordinates.iter().cloned()).collect();
        format!("{} {}", self.definitions[self.formulas.functions[function]], args.join(" "))
    }

    /// A basis function at independent coordinates.
    fn at(&self, function: usize, variables: &[String]) -> String {
        let mut coordinates = variables.to_vec();
        if self.family.is_simplex() {
            coordinates.push(format!("(1 - {})", variables.join(" - ")));
        }
        self.called(function, &coordinates)
    }

    /// The numbers of the domain variables, and then of the shape parameters.
    fn order(&self) -> Vec<usize> {
        self.family.domain.iter().chain(&self.family.shapes).map(|p| p.var.0).collect()
    }

    /// The basis functions as data, in independent coordinates.
    fn functions(&self, order: &[usize]) -> Vec<String> {
        let none = |_: usize| None;
        let writer = self.writer(&none);
        let independent = self.family.domain.iter().map(|p| (Sign::Minus, Term::Variable(p.var.0)));
        let rest = Term::Sum(std::iter::once((Sign::Plus, Term::integer(1))).chain(independent).collect());
        let dependent = self.family.simplices.first().map(|s| s.last.var.0);
        let args: Vec<Term> = (0..self.names.len())
            .map(|v| if Some(v) == dependent { rest.clone() } else { Term::Variable(v) })
            .collect();
        let calls = self.formulas.functions.iter().map(|f| Term::Call(*f, args.clone()));
        calls.map(|call| writer.data(&call, order)).collect()
    }

    /// An interval for each independent coordinate, all together inside of the domain.
    fn dims(&self) -> Vec<(Rational, Rational)> {
        let width = Rational::new(1, self.family.domain.len() as i64);
        let inside = |p: &basis_engine::model::Parameter| {
            if self.family.is_simplex() {
                return Some((Rational::ZERO, width.clone()));
            }
            p.range.finite().map(|(a, b)| (a.clone(), b.clone()))
        };
        self.family.domain.iter().filter_map(inside).collect()
    }
}

/// The independent domain variables, and then the shape parameters, with their ranges.
fn variables_of(family: &Family) -> Vec<(Var, Range)> {
    family.domain.iter().chain(&family.shapes).map(|p| (p.var, p.range.clone())).collect()
}

/// The coefficients of the functions, in the basis of the certificate and as sums of coefficients of monomials.
struct Table<'a> {
    rows: &'a [Vec<Poly>],
    columns: Vec<Functional>,
    shapes: Vec<Var>,
}

impl<'a> Table<'a> {
    /// Finds out which sum of coefficients each column is.
    fn new(family: &Family, rows: &'a [Vec<Poly>]) -> Result<Self, Missing> {
        let same = family.functions.iter().all(|f| f.value.denom() == family.functions[0].value.denom());
        if !family.is_rational() && !same {
            return Err("independence of functions with different denominators");
        }
        let numerators = family.numerators();
        let domain: Vec<Var> = family.domain.iter().map(|p| p.var).collect();
        let known = candidates(family, &numerators, &domain, rows.first().map_or(0, Vec::len));
        let values: Vec<Vec<Poly>> = known
            .iter()
            .map(|functional| numerators.iter().map(|p| applied(functional, p, &domain)).collect())
            .collect();
        let mut columns = Vec::new();
        for c in 0..rows.first().map_or(0, Vec::len) {
            let column: Vec<Poly> = rows.iter().map(|row| row[c].clone()).collect();
            let found = values.iter().position(|v| *v == column);
            columns.push(known[found.ok_or("a table of coefficients in another basis")?].clone());
        }
        Ok(Self { rows, columns, shapes: family.shapes.iter().map(|p| p.var).collect() })
    }

    /// A step for each row of a table of numbers.
    fn numbers(&self) -> Result<Vec<String>, Missing> {
        let rows: Option<Vec<Vec<Rational>>> =
            self.rows.iter().map(|row| row.iter().map(Poly::as_constant).collect()).collect();
        let inverse = right_inverse(&rows.ok_or("a table that does not consist of numbers")?)
            .ok_or("functions that are dependent")?;
        let steps = (0..self.rows.len()).map(|i| {
            let factors = inverse.iter().map(|(c, x)| (*c, Poly::constant(x[i].clone())));
            self.step(i, factors.collect(), "Direct")
        });
        Ok(steps.collect())
    }

    /// Steps for blocks, the last one first.
    fn blocks(&self, blocks: &[Minors], region: &Region) -> Result<Vec<String>, Missing> {
        let mut steps = Vec::new();
        let ranges: Vec<_> = self.shapes.iter().map(|v| (*v, region.range(*v))).collect();
        let work = &mut Work::usual(1);
        for block in blocks.iter().rev() {
            let (Signed::Positive(proof) | Signed::Negative(proof)) = &block.sign;
            let cert = certificate::sign(proof, &ranges)?;
            let rows: Vec<&[Poly]> = block.rows.iter().map(|r| &self.rows[*r][..]).collect();
            for (i, row) in block.rows.iter().enumerate() {
                let mut factors: Vec<(usize, Poly)> = Vec::new();
                for columns in &block.columns {
                    // Of several minors the squares are added.
                    let weight = match block.columns.len() {
                        1 => Poly::one(),
                        _ => minor(&rows, columns, work).map_err(|_| TOO_LONG)?,
                    };
                    for (c, column) in columns.iter().enumerate() {
                        let others: Vec<&[Poly]> =
                            rows.iter().enumerate().filter(|(r, _)| *r != i).map(|(_, row)| *row).collect();
                        let rest: Vec<usize> =
                            columns.iter().copied().filter(|other| other != column).collect();
                        let cofactor = minor(&others, &rest, work).map_err(|_| TOO_LONG)?;
                        let cofactor = if (i + c) % 2 == 1 { -&cofactor } else { cofactor };
                        factors.push((*column, &cofactor * &weight));
                    }
                }
                steps.push(self.step(*row, factors, &cert));
            }
        }
        Ok(steps)
    }

    /// A step as data: factors of columns become factors of monomials.
    fn step(&self, row: usize, factors: Vec<(usize, Poly)>, cert: &str) -> String {
        let mut sum: Vec<(Vec<u32>, Poly)> = Vec::new();
        for (column, factor) in factors {
            for (exponents, x) in &self.columns[column] {
                let part = factor.scale(x);
                match sum.iter_mut().find(|(known, _)| known == exponents) {
                    Some((_, p)) => *p = &*p + &part,
                    None => sum.push((exponents.clone(), part)),
                }
            }
        }
        let parts = sum.iter().filter(|(_, p)| !p.is_zero()).map(|(exponents, p)| {
            let exponents: Vec<String> = exponents.iter().map(u32::to_string).collect();
            format!("([{}]%nat, {})", exponents.join("; "), data(p, &self.shapes))
        });
        let parts: Vec<String> = parts.collect();
        format!("Step {row} [{}] {cert}", parts.join("; "))
    }
}

/// The value of a sum of coefficients, a polynomial in the shape parameters.
fn applied(functional: &Functional, p: &Poly, domain: &[Var]) -> Poly {
    let mut terms = Vec::new();
    for (m, c) in p.terms() {
        let exponents: Vec<u32> = domain.iter().map(|v| u32::from(m.exponent(*v))).collect();
        if let Some((_, x)) = functional.iter().find(|(known, _)| *known == exponents) {
            let shape = domain.iter().fold(m.clone(), |m, v| m.with_exponent(*v, 0));
            terms.push((shape, c * x));
        }
    }
    Poly::from_terms(terms)
}

/// What a column can be: a coefficient of a monomial; a Bernstein coefficient; a coefficient of a homogeneous monomial.
fn candidates(family: &Family, numerators: &[Poly], domain: &[Var], width: usize) -> Vec<Functional> {
    let mut monomials: Vec<Vec<u32>> = Vec::new();
    for (m, _) in numerators.iter().flat_map(Poly::terms) {
        monomials.push(domain.iter().map(|v| u32::from(m.exponent(*v))).collect());
    }
    monomials.sort();
    monomials.dedup();
    let mut all = Vec::new();
    if family.is_simplex() {
        let total = |m: &[u32]| m.iter().sum::<u32>();
        let degree = monomials.iter().map(|m| total(m)).max().unwrap_or(0);
        let mut exponents: Vec<Vec<u32>> = vec![Vec::new()];
        for _ in domain {
            exponents = exponents
                .into_iter()
                .flat_map(|e: Vec<u32>| {
                    let left = degree - total(&e);
                    (0..=left).map(move |k| [&e[..], &[k]].concat()).collect::<Vec<_>>()
                })
                .collect();
        }
        for e in exponents {
            // Of a monomial m times (u + v + w)^(degree - |m|) the coefficient with the exponents e.
            let below = monomials.iter().filter(|m| m.iter().zip(&e).all(|(a, b)| a <= b));
            let parts = below.map(|m| {
                let mut rest: Vec<u32> = e.iter().zip(m).map(|(b, a)| b - a).collect();
                rest.push(degree - total(&e));
                let factor = rest.iter().fold(factorial(degree - total(m)), |x, k| &x / &factorial(*k));
                (m.clone(), factor)
            });
            all.push(parts.collect());
        }
        return all;
    }
    if let Some((_, low, high)) = family.interval() {
        let (n, length) = (width.saturating_sub(1) as u32, high - low);
        for j in 0..=n {
            // The Bernstein coefficients of x^k on 0 <= x <= 1 are binomial(j, k)/binomial(n, k), with t = low + length x.
            let parts = monomials.iter().map(|m| {
                let i = m[0];
                let sum = (0..=i.min(j)).map(|k| {
                    let power = &low.pow(i - k) * &length.pow(k);
                    &(&binomial(i, k) * &power) * &(&binomial(j, k) / &binomial(n, k))
                });
                (m.clone(), sum.fold(Rational::ZERO, |a, b| &a + &b))
            });
            all.push(parts.filter(|(_, x)| !x.is_zero()).collect());
        }
    }
    all.extend(monomials.into_iter().map(|m| vec![(m, Rational::ONE)]));
    all
}

fn factorial(n: u32) -> Rational {
    (1..=i64::from(n)).fold(Rational::ONE, |p, k| &p * &Rational::from(k))
}

fn binomial(n: u32, k: u32) -> Rational {
    if k > n { Rational::ZERO } else { &factorial(n) / &(&factorial(k) * &factorial(n - k)) }
}

/// Columns with factors for each row: the sum of factor times column is the unit vector of the row.
fn right_inverse(rows: &[Vec<Rational>]) -> Option<Vec<(usize, Vec<Rational>)>> {
    let n = rows.len();
    // [rows | 1], brought into reduced form: then the right half is the inverse of the pivot columns.
    let unit = |i: usize| (0..n).map(move |j| if i == j { Rational::ONE } else { Rational::ZERO });
    let mut wide: Vec<Vec<Rational>> =
        rows.iter().enumerate().map(|(i, r)| r.iter().cloned().chain(unit(i)).collect()).collect();
    let width = rows.first()?.len();
    let mut pivots = Vec::new();
    for column in 0..width {
        let done = pivots.len();
        let Some(found) = (done..n).find(|r| !wide[*r][column].is_zero()) else { continue };
        wide.swap(done, found);
        let factor = wide[done][column].recip()?;
        for x in &mut wide[done] {
            *x = &*x * &factor;
        }
        let pivot = wide[done].clone();
        for (r, row) in wide.iter_mut().enumerate() {
            if r != done && !row[column].is_zero() {
                let factor = row[column].clone();
                for (x, p) in row.iter_mut().zip(&pivot) {
                    *x = &*x - &(&factor * p);
                }
            }
        }
        pivots.push(column);
        if pivots.len() == n {
            break;
        }
    }
    if pivots.len() < n {
        return None;
    }
    Some(pivots.into_iter().enumerate().map(|(k, c)| (c, wide[k][width..].to_vec())).collect())
}

/// A polynomial as data, its variables in this order.
fn data(p: &Poly, variables: &[Var]) -> String {
    if let Some(c) = p.as_constant() {
        return format!("C {}", rational(&c));
    }
    let Some((first, rest)) = variables.split_first() else { return String::from("C 0") };
    let coefficients: Vec<String> = p.coefficients_in(*first).iter().map(|c| data(c, rest)).collect();
    format!("P [{}]", coefficients.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_inverses_give_unit_vectors() {
        let r = |n: i64| Rational::from(n);
        let rows = vec![vec![r(1), r(2), r(3)], vec![r(2), r(4), r(7)]];
        let inverse = right_inverse(&rows).expect("independent");
        for (i, row) in rows.iter().enumerate() {
            for j in 0..2 {
                let sum = inverse.iter().fold(Rational::ZERO, |sum, (c, x)| &sum + &(&row[*c] * &x[j]));
                assert_eq!(sum, r(i64::from(i == j)));
            }
        }
        assert!(right_inverse(&[vec![r(1), r(2)], vec![r(2), r(4)]]).is_none());
    }
}
