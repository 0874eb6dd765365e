//! Claims of theorems and joins as theorems with their proofs.
//!
//! Points have coordinates. In a theorem with a dimension each coordinate is a variable; in one for points of any space a point
//! is a function of the number of the coordinate, and an equation of vectors says that all coordinates agree, those of outer
//! products with two numbers each.

use basis_kernel::collections::sort::{sort_by, sort_unique};
use std::rc::Rc;

use basis_engine::algebra::range::Range;
use basis_engine::algebra::rational::Rational;
use basis_engine::formulas::{
    self, Comparison, PointClaim, PointFormulas, Quantity, Term, coordinate, coordinate_variable,
};
use basis_engine::theorem::{Form, Theorem, TheoremRelation, Unit};
use basis_engine::{Claim, ClaimKind, Coordinate, Subject, Verdict, Witness, state};
use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::{Chart, Proof, Relation, Statement};

use super::certificate::{self, Signs};
use super::formula::{Writer, number};
use super::frame::{between, range_data};
use super::names::{Names, identifier};
use super::theorem::Missing;

/// What coordinates are called, as far as that is usual.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A theorem with everything that its claims mention.
pub(super) struct About<'a> {
    theorem: &'a Rc<Theorem>,
    formulas: &'a PointFormulas,
    /// The identifiers of the definitions.
    definitions: &'a [String],
    /// Why no denominator vanishes.
    obligations: &'a [&'a Proof],
    /// The identifiers of scalars and of coordinates, or of points where these are functions.
    names: Vec<(usize, String)>,
    /// The numbers of coordinates of points of any space.
    numbers: [String; 2],
}

/// A variable of a statement: its number, what it is in formulas, and its range.
struct Place {
    variable: usize,
    text: String,
    range: Range,
}

/// What stands between two formulas, in a goal without the words in front.
struct Pair<'t> {
    left: &'t Term,
    comparison: Comparison,
    right: &'t Term,
}

impl<'a> About<'a> {
    pub(super) fn new(
        theorem: &'a Rc<Theorem>,
        formulas: &'a PointFormulas,
        definitions: &'a [String],
        obligations: &'a [&'a Proof],
        identifiers: &mut Names,
    ) -> Self {
        let numbers = ["i", "j"].map(|name| identifiers.give(name));
        let mut names = Vec::new();
        for scalar in &theorem.scalars {
            names.push((scalar.var.0, identifiers.give(&scalar.name)));
        }
        for (k, point) in formulas.points.iter().enumerate() {
            match theorem.dimension {
                None => names.push((coordinate_variable(k, 0), identifiers.give(point))),
                Some(dimension) => {
                    for c in 0..dimension {
                        let axis = AXES.get(c).map_or_else(|| c.to_string(), |axis| (*axis).to_string());
                        let name = identifiers.give(&format!("{}_{axis}", identifier(point)));
                        names.push((coordinate_variable(k, c), name));
                    }
                }
            }
        }
        Self { theorem, formulas, definitions, obligations, names, numbers }
    }

    /// What a variable is in formulas.
    fn text_of(&self, variable: usize) -> Option<String> {
        let named = |v: usize| self.names.iter().find(|(known, _)| *known == v).map(|(_, name)| name);
        match coordinate(variable) {
            Some((point, which)) if self.theorem.dimension.is_none() => {
                let point = named(coordinate_variable(point, 0))?;
                Some(format!("{point} {}", self.numbers.get(which)?))
            }
            _ => named(variable).cloned(),
        }
    }

    /// The variable that stands in formulas for one of the kernel.
    fn written(&self, var: Var) -> usize {
        let coordinate = self.theorem.points.iter().find_map(|p| {
            let c = p.coordinates.iter().position(|v| *v == var)?;
            Some(coordinate_variable(self.formulas.points.iter().position(|name| *name == p.name)?, c))
        });
        coordinate.unwrap_or(var.0)
    }

    fn place(&self, variable: usize) -> Option<Place> {
        let range = match coordinate(variable) {
            Some(_) => Range::all(),
            None => self.theorem.range(Var(variable)),
        };
        Some(Place { variable, text: self.text_of(variable)?, range })
    }

    /// The theorems that a claim makes, with the identifiers that begin with `name`.
    pub(super) fn theorems(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &PointClaim,
        verdict: &Verdict,
    ) -> Result<Vec<String>, Missing> {
        match (verdict, claimed.relation) {
            (Verdict::Undecided(_), _) => Err("an undecided claim"),
            (Verdict::Proved(evidence), TheoremRelation::Compare(comparison)) => {
                let proof = evidence.steps().first().map(|(_, proof)| proof);
                let pairs = pairs(claimed, comparison).ok_or("sides of different kinds")?;
                let many = pairs.len() > 1;
                let each = pairs.iter().enumerate();
                each.map(|(k, pair)| {
                    let name = if many { format!("{name}_{k}") } else { name.to_string() };
                    self.proved(&name, pair, proof)
                })
                .collect()
            }
            (Verdict::Proved(evidence), TheoremRelation::Parallel) => {
                let steps = evidence.steps().iter().map(|(_, proof)| proof);
                self.parallel(name, claim, claimed, steps).map(|text| vec![text])
            }
            (Verdict::Refuted(_), TheoremRelation::Parallel) => Err("a refutation of `parallel`"),
            (Verdict::Refuted(witness), TheoremRelation::Compare(comparison)) => {
                self.refuted(name, claim, claimed, comparison, witness).map(|text| vec![text])
            }
        }
    }

    /// The variables of a statement: those of a certificate first, in its order, then the others of some formulas.
    fn places(&self, terms: &[&Term], chart: &[(Var, Range)]) -> Option<Vec<Place>> {
        let mut all = Vec::new();
        for (var, range) in chart {
            let variable = self.written(*var);
            all.push(Place { variable, text: self.text_of(variable)?, range: range.clone() });
        }
        let mut used = Vec::new();
        for term in terms {
            variables(term, &mut used);
        }
        sort_unique(&mut used);
        used.retain(|v| all.iter().all(|place: &Place| place.variable != *v));
        for variable in used {
            all.push(self.place(variable)?);
        }
        Some(all)
    }

    /// The variables and hypotheses in front of a goal, and the first step of its proof.
    fn frame(&self, places: &[Place], goal: &str, quantifier: &str) -> (String, String, Vec<String>) {
        let used = |v: usize| places.iter().any(|p| p.variable == v);
        let mut reals = Vec::new();
        let mut points = Vec::new();
        let mut hypotheses = Vec::new();
        for (variable, name) in &self.names {
            match coordinate(*variable) {
                Some((point, _)) if self.theorem.dimension.is_none() => {
                    let occurs = used(*variable) || used(coordinate_variable(point, 1));
                    points.extend(occurs.then_some(name.as_str()));
                }
                _ if used(*variable) => {
                    reals.push(name.as_str());
                    hypotheses.extend(between(name, &self.theorem.range(Var(*variable))));
                }
                _ => {}
            }
        }
        let numbers: Vec<&str> = (0..2)
            .filter(|which| places.iter().any(|p| self.is_number(p.variable, *which)))
            .map(|which| self.numbers[which].as_str())
            .collect();
        let mut front = String::new();
        for (group, kind) in [(&reals, "R"), (&points, "nat -> R")] {
            if !group.is_empty() {
                front += &format!(" ({} : {kind})", group.join(" "));
            }
        }
        let (then, last) = if quantifier == "forall" { (" ->", "forall") } else { (" /\\", "exists") };
        let mut text = if front.is_empty() { String::new() } else { format!("{quantifier}{front},\n") };
        for h in &hypotheses {
            text += &format!("  {h}{then}\n");
        }
        text += "  ";
        if !numbers.is_empty() && !goal.starts_with("exists f'") {
            text += &format!("{last} {} : nat, ", numbers.join(" "));
        }
        text += goal;
        let named = hypotheses.iter().enumerate().map(|(k, _)| format!("H'{k}"));
        let mut introduced: Vec<String> = reals.iter().chain(&points).map(|n| (*n).to_string()).collect();
        introduced.extend(named);
        let numbers = numbers.iter().map(|n| (*n).to_string()).collect();
        let steps = if introduced.is_empty() {
            String::new()
        } else {
            format!("  intros {}.\n", introduced.join(" "))
        };
        (text, steps, numbers)
    }

    /// Whether a variable is a coordinate of a point of any space with the number i (0) or j (1).
    fn is_number(&self, variable: usize, which: usize) -> bool {
        self.theorem.dimension.is_none() && coordinate(variable).is_some_and(|(_, w)| w == which)
    }

    fn writer<'w>(&'w self, variables: &'w dyn Fn(usize) -> Option<String>) -> Writer<'w> {
        Writer { definitions: self.definitions, variables }
    }

    /// Certificates that denominators do not vanish.
    fn defined(&self, places: &[Place]) -> String {
        let variables: Vec<(Var, Range)> =
            places.iter().map(|p| (self.kernels(p.variable), p.range.clone())).collect();
        let known = self.obligations.iter().filter_map(|proof| certificate::by_cuts(proof, &variables).ok());
        let mut all: Vec<String> = known.map(|(above, _)| above).filter(|c| c != "Direct").collect();
        all.dedup();
        format!("[{}]", all.join("; "))
    }

    /// The variable of the kernel that stands for one in formulas.
    fn kernels(&self, variable: usize) -> Var {
        let Some((point, c)) = coordinate(variable) else { return Var(variable) };
        let given = self.theorem.points.iter().find(|p| Some(&p.name) == self.formulas.points.get(point));
        given.and_then(|p| p.coordinates.get(c).copied()).unwrap_or(Var(variable))
    }

    /// A comparison that holds everywhere.
    fn proved(&self, name: &str, pair: &Pair<'_>, proof: Option<&Proof>) -> Result<String, Missing> {
        let mut chart: Vec<(Var, Range)> = Vec::new();
        let mut signs = None;
        if pair.comparison != Comparison::Equal {
            let proof = proof.ok_or("a claim without a proof")?;
            let Statement::Sign { value, domain, .. } = proof.statement() else {
                return Err("an inequality between dot products of points of any space");
            };
            let found = Chart::new(domain, [&value.numerator, &value.denominator]);
            let found = found.map_err(|_| "a domain that has no chart")?;
            chart.clone_from(&found.region().ranges);
            signs = Some(Signs::of(proof, &found, &chart)?);
        }
        let places = self.places(&[pair.left, pair.right], &chart).ok_or("a variable that is not there")?;
        let common = self.common(&places);
        let env: Vec<usize> = places.iter().map(|p| p.variable).collect();
        let values = values(&places);
        let names = |v: usize| self.text_of(v);
        let writer = self.writer(&names);
        let data = |term: &Term| writer.data(term, &env);
        let by = |lemma: &str, a: &Term, b: &Term| {
            let lemma = signs.as_ref().map_or_else(String::new, |signs: &Signs| signs.lemma(lemma, &common));
            format!("{lemma} {} {} {values} _ _", data(a), data(b))
        };
        let (left, right) = (pair.left, pair.right);
        let goal = writer.compared(left, pair.comparison, right);
        let (goal, proof) = match (pair.comparison, left) {
            (Comparison::Equal, Term::Derivative { body, bound, at }) => {
                let goal = writer.derived(body, *bound, at, right);
                let function = writer.body(body, *bound, &env);
                let arguments = format!("{function} {} {} {values}", data(at), data(right));
                (goal, format!("derivative_by {common} {arguments} _ _"))
            }
            (Comparison::Equal, _) => {
                (goal, format!("equal_by {common} {} {} {values} _ _", data(left), data(right)))
            }
            (Comparison::LessEqual, _) => (goal, by("le", left, right)),
            (Comparison::Less, _) => (goal, by("lt", left, right)),
            (Comparison::GreaterEqual, _) => (goal, format!("Rle_ge _ _ ({})", by("le", right, left))),
            (Comparison::Greater, _) => (goal, format!("Rlt_gt _ _ ({})", by("lt", right, left))),
            (Comparison::NotEqual, _) => return Err("a comparison that is no claim"),
        };
        let (statement, steps, numbers) = self.frame(&places, &goal, "forall");
        let numbers =
            if numbers.is_empty() { String::new() } else { format!("  intros {}.\n", numbers.join(" ")) };
        let text = format!(
            "Theorem {name} :\n  {statement}.\nProof.\n{steps}{numbers}  refine ({proof}); [run | box].\nQed.\n"
        );
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }

    fn common(&self, places: &[Place]) -> String {
        let ranges: Vec<String> = places.iter().map(|p| range_data(&p.range)).collect();
        format!("[{}] {}", ranges.join("; "), self.defined(places))
    }

    /// Vectors of which one is a positive multiple of the other.
    fn parallel<'p>(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &PointClaim,
        steps: impl Iterator<Item = &'p Proof>,
    ) -> Result<String, Missing> {
        let ClaimKind::Parallel { left, right } = &claim.kind else { return Err("another kind of claim") };
        let (n, d) = factor(&left.value, &right.value).ok_or("vectors that are both zero")?;
        let product = &n * &d;
        let positive = steps
            .filter(|proof| match proof.statement() {
                Statement::Sign { value, relation: Relation::Positive, .. } => value.numerator == product,
                _ => false,
            })
            .last();
        let positive = positive.ok_or("vectors that are both zero somewhere")?;
        let Statement::Sign { value, domain, .. } = positive.statement() else {
            return Err("a claim without a proof");
        };
        let chart = Chart::new(domain, [&value.numerator, &value.denominator]);
        let chart = chart.map_err(|_| "a domain that has no chart")?.region().ranges.clone();
        let (below, above) = certificate::by_cuts(positive, &chart)?;
        let renamed = |p: &Poly| formulas::polynomial(p).put(&|v| Some(Term::Variable(self.written(Var(v)))));
        let (n, d) = (renamed(&n), renamed(&d));
        let (own, both) = (n.clone().by(d.clone()), pairs(claimed, Comparison::Equal));
        let both = both.ok_or("sides of different kinds")?;
        let mut terms: Vec<&Term> = vec![&own];
        terms.extend(both.iter().flat_map(|pair| [pair.left, pair.right]));
        let places = self.places(&terms, &chart).ok_or("a variable that is not there")?;
        let scalars: Vec<&Place> = places.iter().take(chart.len()).collect();
        if scalars.iter().any(|p| self.is_number(p.variable, 0) || self.is_number(p.variable, 1)) {
            return Err("a factor that depends on points of any space");
        }
        let names = |v: usize| self.text_of(v);
        let writer = self.writer(&names);
        let env: Vec<usize> = places.iter().map(|p| p.variable).collect();
        let (common, values) = (self.common(&places), values(&places));
        let parts: Vec<String> = both
            .iter()
            .map(|pair| format!("{} = f' * {}", writer.text(pair.left), writer.argument(pair.right)))
            .collect();
        // The sign first, of the scalars alone.
        let own_places: Vec<Place> = self.places(&[&own], &chart).ok_or("a variable that is not there")?;
        let own_env: Vec<usize> = own_places.iter().map(|p| p.variable).collect();
        let sign = format!(
            "lt_by {} {below} {above} (Num (0)) {} {} _ _",
            self.common(&own_places),
            writer.data(&own, &own_env),
            self::values(&own_places),
        );
        let forall = places.iter().any(|p| self.is_number(p.variable, 0));
        let second = places.iter().any(|p| self.is_number(p.variable, 1));
        let numbers = match (forall, second) {
            (false, _) => String::new(),
            (true, false) => self.numbers[0].clone(),
            (true, true) => self.numbers.join(" "),
        };
        let front = if forall { format!("forall {numbers} : nat, ") } else { String::new() };
        let goal = format!("exists f' : R, 0 < f' /\\ {front}{}", parts.join(" /\\ "));
        let (statement, introduced, _) = self.frame(&places, &goal, "forall");
        let (n_text, d_text) = (writer.argument(&n), writer.argument(&d));
        let mut proof = format!(
            "{introduced}  assert (S' : 0 < {}) by (refine ({sign}); [run | box]).\n  \
             exists ({n_text} / {d_text}). split; [exact (ratio_positive _ _ S') |].\n",
            writer.text(&own),
        );
        if forall {
            proof += &format!("  intros {numbers}.\n");
        }
        for (k, pair) in both.iter().enumerate() {
            let (left, right) = (d.clone().by(pair.left.clone()), n.clone().by(pair.right.clone()));
            let equal = format!(
                "equal_by {common} {} {} {values} _ _",
                writer.data(&left, &env),
                writer.data(&right, &env)
            );
            if k + 1 < both.len() {
                proof += "  split.\n";
            }
            proof += &format!("  {{ apply (ratio_by _ _ _ _ S'). refine ({equal}); [run | box]. }}\n");
        }
        let text = format!("Theorem {name} :\n  {statement}.\nProof.\n{proof}Qed.\n");
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }

    /// A comparison that fails at values of the scalars, for some points.
    fn refuted(
        &self,
        name: &str,
        claim: &Claim,
        claimed: &PointClaim,
        comparison: Comparison,
        witness: &Witness,
    ) -> Result<String, Missing> {
        let pairs = pairs(claimed, comparison).ok_or("sides of different kinds")?;
        let points: Vec<Vec<Rational>> =
            self.formulas.points.iter().map(|name| self.point(name, witness)).collect();
        let dimension = points.iter().map(Vec::len).max().unwrap_or(0);
        // Which coordinate differs.
        let subject = Subject::Theorem(Rc::clone(self.theorem));
        let part = match claimed.left {
            _ if pairs.len() == 1 && matches!(claimed.left, Quantity::Scalar(_)) => 0,
            _ => {
                let instances = state::instances(&subject, claim, &witness.given)
                    .map_err(|_| "a refutation that cannot be stated")?;
                let own = witness.of_statement();
                instances.iter().position(|s| s.of == own).ok_or("a statement that is not there")?
            }
        };
        let free = self.theorem.dimension.is_none();
        let pair =
            if free { pairs.first() } else { pairs.get(part) }.ok_or("a statement that is not there")?;
        let numbers: [usize; 2] = match claimed.left {
            Quantity::Outer(_) => {
                let axes = (0..dimension).flat_map(|i| (i + 1..dimension).map(move |j| [i, j]));
                axes.into_iter().nth(part).ok_or("a statement that is not there")?
            }
            _ => [part, part],
        };
        let scalar = |v: usize| -> Result<Rational, Missing> {
            let name = self.theorem.names.get(v).ok_or("a variable that is not there")?;
            match witness.at.iter().find(|(n, _)| n == name) {
                Some((_, Coordinate::Rational(x))) => Ok(x.clone()),
                Some(_) => Err("a refutation at an irrational point"),
                None => Err("a refutation at a point that is not complete"),
            }
        };
        let places = self.places(&[pair.left, pair.right], &[]).ok_or("a variable that is not there")?;
        let mut at: Vec<(usize, Rational)> = Vec::new();
        for place in &places {
            let value = match coordinate(place.variable) {
                Some((point, which)) => {
                    let k = if free { numbers[which] } else { which };
                    points.get(point).and_then(|p| p.get(k)).cloned().unwrap_or(Rational::ZERO)
                }
                None => scalar(place.variable)?,
            };
            at.push((place.variable, value));
        }
        let put = |term: &Term| {
            term.put(&|v| at.iter().find(|(w, _)| *w == v).map(|(_, x)| Term::Number(x.clone())))
        };
        let names = |v: usize| self.text_of(v);
        let writer = self.writer(&names);
        let goal = format!("~ ({})", writer.compared(pair.left, comparison, pair.right));
        let (left, right) = (writer.data(&put(pair.left), &[]), writer.data(&put(pair.right), &[]));
        let proof = super::theorem::fails(comparison, &left, &right, witness.value.is_negative())
            .ok_or("a comparison that is no claim")?;
        let (statement, _, given) = self.frame(&places, &goal, "exists");
        let mut exists: Vec<String> = Vec::new();
        let mut hypotheses = 0;
        for (variable, _) in &self.names {
            let here = |v: usize| at.iter().find(|(w, _)| *w == v).map(|(_, x)| x);
            match coordinate(*variable) {
                Some((point, _)) if free => {
                    if here(*variable).is_some() || here(coordinate_variable(point, 1)).is_some() {
                        let list: Vec<String> = points[point].iter().map(number).collect();
                        exists.push(format!("(fun n => nth n [{}] 0)", list.join("; ")));
                    }
                }
                _ => {
                    if let Some(x) = here(*variable) {
                        hypotheses += usize::from(between("", &self.theorem.range(Var(*variable))).is_some());
                        exists.push(number(x));
                    }
                }
            }
        }
        // Scalars stand before points.
        sort_by(&mut exists, |a, b| a.starts_with("(fun").cmp(&b.starts_with("(fun")));
        let mut steps = String::new();
        if !exists.is_empty() {
            steps += &format!("  exists {}.\n", exists.join(", "));
        }
        steps += &"  split; [repeat split; lra |].\n".repeat(hypotheses);
        if !given.is_empty() {
            let chosen: Vec<String> = (0..given.len()).map(|k| format!("{}%nat", numbers[k])).collect();
            steps += &format!("  exists {}.\n", chosen.join(", "));
        }
        let text =
            format!("Theorem {name} :\n  {statement}.\nProof.\n{steps}  refine ({proof}); run.\nQed.\n");
        if text.contains("missing'") { Err("a variable that is not there") } else { Ok(text) }
    }

    /// Where a given point is in a counterexample.
    fn point(&self, name: &str, witness: &Witness) -> Vec<Rational> {
        let given = self.theorem.points.iter().position(|p| p.name == name);
        let given = given.and_then(|k| witness.given.get(k));
        let listed = || witness.net.iter().find(|(n, _)| n == name).map(|(_, place)| place);
        let dimension = witness.given.first().map_or(self.theorem.dimension.unwrap_or(0), Vec::len);
        given.or_else(listed).cloned().unwrap_or_else(|| vec![Rational::ZERO; dimension])
    }
}

/// The sides of a claim coordinate by coordinate; a lone 0 is compared with all of them.
fn pairs(claimed: &PointClaim, comparison: Comparison) -> Option<Vec<Pair<'_>>> {
    let (left, right): (Vec<&Term>, Vec<&Term>) =
        (claimed.left.terms().collect(), claimed.right.terms().collect());
    let at = |side: &[&Term], k: usize| if side.len() == 1 { 0 } else { k };
    let count = left.len().max(right.len());
    let fits = |side: &[&Term]| side.len() == count || side.len() == 1;
    (fits(&left) && fits(&right)).then(|| {
        let pair = |k: usize| Pair { left: left[at(&left, k)], comparison, right: right[at(&right, k)] };
        (0..count).map(pair).collect()
    })
}

/// f = n/d with a = f·b.
fn factor(a: &Form, b: &Form) -> Option<(Poly, Poly)> {
    let (unit, below): (&Unit, _) = b.terms.iter().next()?;
    let f = a.coefficient(*unit).checked_div(below)?;
    Some((f.numer().clone(), f.denom().clone()))
}

/// The free variables of a formula.
fn variables(term: &Term, found: &mut Vec<usize>) {
    match term {
        Term::Number(_) | Term::Pi => {}
        Term::Variable(v) => found.push(*v),
        Term::Neg(x) | Term::Power(x, _) | Term::Circular(_, x) => variables(x, found),
        Term::Sum(parts) => parts.iter().for_each(|(_, x)| variables(x, found)),
        Term::Product(parts) => parts.iter().for_each(|(_, x)| variables(x, found)),
        Term::Call(_, args) => args.iter().for_each(|x| variables(x, found)),
        Term::Derivative { body, bound, at } => {
            let mut inner = Vec::new();
            variables(body, &mut inner);
            found.extend(inner.into_iter().filter(|v| v != bound));
            variables(at, found);
        }
        Term::Integral { body, bound, low, high } => {
            let mut inner = Vec::new();
            variables(body, &mut inner);
            found.extend(inner.into_iter().filter(|v| v != bound));
            variables(low, found);
            variables(high, found);
        }
    }
}

fn values(places: &[Place]) -> String {
    let texts: Vec<&str> = places.iter().map(|p| p.text.as_str()).collect();
    format!("[{}]", texts.join("; "))
}
