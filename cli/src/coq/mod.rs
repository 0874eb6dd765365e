//! `basis check --coq`: the theorems of specs for Coq, whose kernel then checks them a second time.
//!
//! A family of one order becomes a file: its formulas as they are written, as definitions of functions of real numbers;
//! for each of them the same as data of `Basis.v`; and a theorem for each comparison that its claims make. What has no
//! counterpart is counted and listed.

mod angles;
mod certificate;
mod formula;
mod frame;
mod independence;
mod names;
mod points;
mod quotients;
mod theorem;

use std::fs;
use std::path::Path;
use std::rc::Rc;

use basis_engine::formulas::{Definition, Formulas, PointFormulas};
use basis_engine::model::obligation::Obligation;
use basis_engine::plural::count;
use basis_engine::theorem::Theorem;
use basis_engine::{Family, Subject};
use basis_kernel::Proof;

use crate::check::prove::{Decided, DecidedClaim, Outcome};
use formula::Writer;
use names::{Names, identifier};

/// What all files need.
const BASIS: &str = include_str!("Basis.v");

const MAKEFILE: &str = "\
# Has Coq check every theorem: `make`, with `make -j2` on two cores. Needs Coq 8.16 or newer and Coquelicot 3.
all: Makefile.coq
\t$(MAKE) -f Makefile.coq

Makefile.coq: _CoqProject
\tcoq_makefile -f _CoqProject -o Makefile.coq

clean: Makefile.coq
\t$(MAKE) -f Makefile.coq cleanall
\trm -f Makefile.coq Makefile.coq.conf

.PHONY: all clean
";

/// What was written, and what could not be.
#[derive(Debug, Default)]
pub(crate) struct Export {
    files: Vec<String>,
    theorems: usize,
    /// Claims without a counterpart: where, which, and why.
    missing: Vec<String>,
}

impl Export {
    /// Writes the files of one spec.
    ///
    /// # Errors
    /// What stands in the way.
    pub(crate) fn add(&mut self, folder: &Path, outcome: &Outcome) -> Result<(), String> {
        for decided in &outcome.items {
            let title = decided.subject.title();
            let missing = |claim: &DecidedClaim, why: &str| {
                let line =
                    outcome.line(&claim.claim.place).map(|line| format!(":{line}")).unwrap_or_default();
                format!("{}{line}: {title}: `{}`: {why}", outcome.path, claim.claim.text)
            };
            let family = match &decided.subject {
                Subject::Family(family) => family,
                Subject::Theorem(theorem) => {
                    if !theorem.relations.is_empty() {
                        let why = "a theorem whose scalars are related to one another";
                        self.missing.extend(decided.claims.iter().map(|c| missing(c, why)));
                        continue;
                    }
                    let Some(formulas) = &decided.points else {
                        let why = "a curve or a `let` of the theorem cannot be stated in Coq yet";
                        self.missing.extend(decided.claims.iter().map(|c| missing(c, why)));
                        continue;
                    };
                    let (text, left_out) = Text::of_theorem(outcome, decided, theorem, formulas);
                    self.missing
                        .extend(left_out.into_iter().map(|(k, why)| missing(&decided.claims[k], why)));
                    self.write(folder, outcome, decided, text)?;
                    continue;
                }
            };
            let Some(formulas) = &decided.formulas else {
                let why = "a formula of the family cannot be stated in Coq yet";
                self.missing.extend(decided.claims.iter().map(|c| missing(c, why)));
                continue;
            };
            if !family.analytic.is_empty() && !family.constraints.is_empty() {
                self.missing.extend(decided.claims.iter().map(|c| missing(c, theorem::ASSUMED)));
                continue;
            }
            if !family.analytic.is_empty() {
                match Text::of_angles(outcome, decided, family, formulas) {
                    Ok((text, left_out)) => {
                        self.missing
                            .extend(left_out.into_iter().map(|(k, why)| missing(&decided.claims[k], why)));
                        self.write(folder, outcome, decided, text)?;
                    }
                    Err(why) => self.missing.extend(decided.claims.iter().map(|c| missing(c, why))),
                }
                continue;
            }
            // What is proved under an assumption need not hold on all ranges, and theorems are about these.
            let all = family.obligations.iter().chain(&decided.obligations);
            let obligations: Vec<&Obligation> =
                if family.constraints.is_empty() { all.collect() } else { Vec::new() };
            // On a simplex one of the coordinates is expressed by the others.
            let cancel = |family: &Family, functions: &[usize]| {
                family.simplices.is_empty() && quotients::cancel(family, formulas, functions, &obligations)
            };
            let spans = family.pieces.iter().zip(&formulas.spans);
            if spans.into_iter().any(|(piece, functions)| cancel(piece, functions))
                || family.pieces.is_empty() && cancel(family, &formulas.functions)
            {
                let lowest = "a quotient that is brought into lowest terms";
                let why = if family.constraints.is_empty() { lowest } else { theorem::ASSUMED };
                self.missing.extend(decided.claims.iter().map(|c| missing(c, why)));
                continue;
            }
            let mut text = Text::new(outcome, decided, family, formulas);
            for (claim, why) in text.claims(outcome, decided, family, formulas) {
                self.missing.push(missing(&decided.claims[claim], why));
            }
            self.write(folder, outcome, decided, text)?;
        }
        Ok(())
    }

    fn write(
        &mut self,
        folder: &Path,
        outcome: &Outcome,
        decided: &Decided,
        text: Text,
    ) -> Result<(), String> {
        self.theorems += text.theorems.len();
        let name = self.name(&outcome.path, &decided.subject);
        fs::create_dir_all(folder)
            .and_then(|()| fs::write(folder.join(format!("{name}.v")), text.finish()))
            .map_err(|e| format!("cannot write `{}`: {e}", folder.join(format!("{name}.v")).display()))?;
        self.files.push(name);
        Ok(())
    }

    /// The name of a file, `quartic_QuarticBernstein` or `bernstein_Bernstein_3`, different from all others.
    fn name(&self, path: &str, subject: &Subject) -> String {
        let stem = Path::new(path).with_extension("");
        let parts = stem.components().filter_map(|c| match c {
            std::path::Component::Normal(part) => part.to_str(),
            _ => None,
        });
        let mut parts: Vec<String> = parts.map(|part| part.replace(':', "_")).collect();
        parts.push(subject.name().to_string());
        parts.extend(subject.order().iter().map(|(_, value)| value.to_string()));
        let plain = identifier(&parts.join("_"));
        let mut name = plain.clone();
        let mut number = 1;
        while self.files.contains(&name) || name == "Basis" {
            number += 1;
            name = format!("{plain}_{number}");
        }
        name
    }

    /// Writes what belongs to all files; a line that says how much was exported, and lines for what was not.
    ///
    /// # Errors
    /// What stands in the way.
    pub(crate) fn finish(&self, folder: &Path) -> Result<String, String> {
        let mut project = String::from("-Q . Basis\n-arg -w -arg -ambiguous-paths\nBasis.v\n");
        for name in &self.files {
            project += &format!("{name}.v\n");
        }
        fs::create_dir_all(folder)
            .map_err(|e| format!("cannot make the folder `{}`: {e}", folder.display()))?;
        for (name, text) in [("Basis.v", BASIS), ("Makefile", MAKEFILE), ("_CoqProject", &project)] {
            let path = folder.join(name);
            fs::write(&path, text).map_err(|e| format!("cannot write `{}`: {e}", path.display()))?;
        }
        let (theorems, files) = (count(self.theorems, "theorem"), count(self.files.len(), "file"));
        let mut said = format!("Coq: {theorems} in {files}");
        if !self.missing.is_empty() {
            said += &format!(", {} not exported:", count(self.missing.len(), "claim"));
        }
        said.push('\n');
        for line in &self.missing {
            said += &format!("  {line}\n");
        }
        Ok(said)
    }

    /// Whether every claim has its theorems.
    pub(crate) fn is_complete(&self) -> bool {
        self.missing.is_empty()
    }
}

/// The claims without a theorem, by their places, each with the reason.
type Missing = Vec<(usize, &'static str)>;

/// A file that is being written.
struct Text {
    written: String,
    definitions: Vec<String>,
    names: Vec<String>,
    identifiers: Names,
    /// The identifiers of the theorems.
    theorems: Vec<String>,
}

impl Text {
    /// The beginning of a file, with all definitions.
    fn new(outcome: &Outcome, decided: &Decided, family: &Family, formulas: &Formulas) -> Self {
        let mut this = Self::named(outcome, decided, family, formulas);
        for (k, definition) in formulas.definitions.iter().enumerate() {
            this.define(k, definition);
        }
        this
    }

    /// A file without anything in it, but with the names of all.
    fn named(outcome: &Outcome, decided: &Decided, family: &Family, formulas: &Formulas) -> Self {
        let mut identifiers = Names::default();
        let names: Vec<String> = family.names.iter().map(|name| identifiers.give(name)).collect();
        let title = decided.subject.title();
        let given = |names: &mut Names, definition: &Definition| match definition.span {
            _ if definition.family != title => {
                names.give(&format!("{}_{}", identifier(&definition.family), definition.name))
            }
            Some(k) => names.give(&format!("{}_span_{}", identifier(&definition.name), k + 1)),
            None => names.give(&definition.name),
        };
        let definitions = formulas.definitions.iter().map(|d| given(&mut identifiers, d)).collect();
        let written = beginning(&title, &outcome.path);
        Self { written, definitions, names, identifiers, theorems: Vec::new() }
    }

    /// The file of a family with an angle, and the claims without a theorem, each with the reason.
    ///
    /// # Errors
    /// What a function of the family has that cannot be stated.
    fn of_angles(
        outcome: &Outcome,
        decided: &Decided,
        family: &Family,
        formulas: &Formulas,
    ) -> Result<(Self, Missing), &'static str> {
        let turn = angles::Turn::of(family).ok_or("pi or more than one angle")?;
        let mut this = Self::named(outcome, decided, family, formulas);
        let (definitions, names) = (this.definitions.clone(), this.names.clone());
        let all = family.obligations.iter().chain(&decided.obligations);
        let obligations: Vec<&Proof> = all.filter_map(|o| o.proof()).collect();
        let subject = angles::Angular {
            family,
            formulas,
            turn,
            definitions: &definitions,
            names: &names,
            obligations: &obligations,
            turning: angles::angular(formulas),
        };
        for (k, definition) in formulas.definitions.iter().enumerate() {
            if !subject.turning[k] {
                this.define(k, definition);
                continue;
            }
            if definition.family != decided.subject.title() {
                return Err("a function of another family with an angle");
            }
            let in_tangents = subject.definition(k, definition)?;
            let parameters = this.state(&definitions[k], &definitions, definition);
            this.written.push('\n');
            let own = subject.all_in_tangents();
            this.with_data(&own[k], &own, &in_tangents);
            this.written += &subject.lemma(k, &parameters)?;
        }
        let mut missing = Vec::new();
        for (k, (claim, claimed)) in decided.claims.iter().zip(&formulas.claims).enumerate() {
            let name = this.identifiers.give(&format!("claim_{}_{}", k + 1, kind(claim)));
            let claimed = claimed.as_ref().ok_or("a formula that cannot be stated in Coq yet");
            match claimed.and_then(|claimed| subject.theorems(&name, &claim.claim, claimed, &claim.verdict)) {
                Ok(theorems) => this.add(outcome, claim, theorems),
                Err(why) => missing.push((k, why)),
            }
        }
        Ok((this, missing))
    }

    /// The file of a theorem or join, and the claims without a theorem, each with the reason.
    fn of_theorem(
        outcome: &Outcome,
        decided: &Decided,
        theorem: &Rc<Theorem>,
        formulas: &PointFormulas,
    ) -> (Self, Missing) {
        let mut identifiers = Names::default();
        let name =
            |names: &mut Names, d: &Definition| names.give(&format!("{}_{}", identifier(&d.family), d.name));
        let definitions: Vec<String> =
            formulas.definitions.iter().map(|d| name(&mut identifiers, d)).collect();
        let written = beginning(&decided.subject.title(), &outcome.path);
        let names = Vec::new();
        let mut this = Self { written, definitions, names, identifiers, theorems: Vec::new() };
        for (k, definition) in formulas.definitions.iter().enumerate() {
            this.define(k, definition);
        }
        let obligations: Vec<&Proof> = decided.obligations.iter().filter_map(|o| o.proof()).collect();
        let definitions = this.definitions.clone();
        let about = points::About::new(theorem, formulas, &definitions, &obligations, &mut this.identifiers);
        let mut missing = Vec::new();
        for (k, claim) in decided.claims.iter().enumerate() {
            let name = this.identifiers.give(&format!("claim_{}", k + 1));
            let claimed = formulas.claims.get(k).and_then(Option::as_ref);
            let theorems = claimed
                .ok_or("a formula that cannot be stated in Coq yet")
                .and_then(|claimed| about.theorems(&name, &claim.claim, claimed, &claim.verdict));
            match theorems {
                Ok(theorems) => this.add(outcome, claim, theorems),
                Err(why) => missing.push((k, why)),
            }
        }
        (this, missing)
    }

    /// The theorems of a claim.
    fn add(&mut self, outcome: &Outcome, claim: &DecidedClaim, theorems: Vec<String>) {
        let line = outcome.line(&claim.claim.place).map(|l| format!("Line {l}: ")).unwrap_or_default();
        let keyword = claim.claim.expected.keyword();
        self.written += &format!("(** {line}{keyword} {}. *)\n", comment(&claim.claim.text));
        for theorem in theorems {
            let name = theorem.split_whitespace().nth(1).unwrap_or_default();
            self.theorems.push(name.to_string());
            self.written += &theorem;
            self.written.push('\n');
        }
    }

    /// A definition, and the same as data.
    fn define(&mut self, place: usize, definition: &Definition) {
        let definitions = self.definitions.clone();
        self.with_data(&definitions[place], &definitions, definition);
    }

    /// A definition with a name; the identifiers of its parameters.
    fn state(&mut self, name: &str, definitions: &[String], definition: &Definition) -> Vec<String> {
        let mut own = Names::default();
        let parameters: Vec<String> = definition.parameters.iter().map(|p| own.give(p)).collect();
        // A parameter must not hide a function.
        let parameters: Vec<String> = parameters
            .into_iter()
            .map(|p| if self.definitions.contains(&p) { format!("{p}'") } else { p })
            .collect();
        let called = |v: usize| parameters.get(v).cloned();
        let value = Writer { definitions, variables: &called }.text(&definition.value);
        self.written += &format!("Definition {name} ({} : R) : R :=\n  {value}.\n", parameters.join(" "));
        parameters
    }

    fn with_data(&mut self, name: &str, definitions: &[String], definition: &Definition) {
        let parameters = self.state(name, definitions, definition);
        let called = |v: usize| parameters.get(v).cloned();
        let writer = Writer { definitions, variables: &called };
        let env: Vec<usize> = (0..parameters.len()).collect();
        let data = writer.data(&definition.value, &env);
        let applied: Vec<String> = env.iter().map(|k| format!("(nth {k} env 0)")).collect();
        let applied = format!("(fun env => {name} {})", applied.join(" "));
        self.written += &format!(
            "Definition {name}'data : expr := {data}.\n\
             Definition {name}'norm : norm_result := Eval vm_compute in norm {name}'data.\n\
             Lemma {name}'ok : forall env,\n  Forall (nz env) (cs {name}'norm) -> is (fr {name}'norm) env ({applied} env).\n\
             Proof. apply (fn_by _ {name}'data); [vm_cast_no_check (eq_refl {name}'norm) | reflexivity]. Qed.\n\
             Definition {name}'fn : fn := Fn {applied} (fr {name}'norm) (cs {name}'norm) {name}'ok.\n\n",
        );
    }

    /// The theorems of all claims; those without any, and why.
    fn claims(
        &mut self,
        outcome: &Outcome,
        decided: &Decided,
        family: &Family,
        formulas: &Formulas,
    ) -> Missing {
        let all = family.obligations.iter().chain(&decided.obligations);
        let obligations: Vec<&Proof> = all.filter_map(|o| o.proof()).collect();
        let mut missing = Vec::new();
        for (k, (decided, claimed)) in decided.claims.iter().zip(&formulas.claims).enumerate() {
            let name = self.identifiers.give(&format!("claim_{}_{}", k + 1, kind(decided)));
            let subject = theorem::Subject {
                family,
                formulas,
                definitions: &self.definitions,
                names: &self.names,
                obligations: &obligations,
                angle: None,
            };
            let Some(claimed) = claimed else {
                missing.push((k, "a formula that cannot be stated in Coq yet"));
                continue;
            };
            match subject.theorems(&name, &decided.claim, claimed, &decided.verdict) {
                Ok(theorems) => self.add(outcome, decided, theorems),
                Err(why) => missing.push((k, why)),
            }
        }
        missing
    }

    /// The whole file; at its end Coq says by which axioms all theorems are proved.
    fn finish(mut self) -> String {
        if !self.theorems.is_empty() {
            self.written += &format!("Definition all'theorems := ({}, I).\n", self.theorems.join(", "));
            self.written += "Print Assumptions all'theorems.\n";
        }
        self.written
    }
}

/// What stands first in a file.
fn beginning(title: &str, path: &str) -> String {
    let mut text = format!("(** {} of {}. *)\n\n", comment(title), comment(path));
    text += "From Coq Require Import Reals QArith Lia Lra.\nFrom Coquelicot Require Import Coquelicot.\n";
    text += "From Basis Require Import Basis.\nImport List ListNotations.\nOpen Scope R_scope.\n\n";
    text
}

/// A word for a claim.
fn kind(decided: &DecidedClaim) -> &'static str {
    use basis_engine::ClaimKind;
    match decided.claim.kind {
        ClaimKind::PartitionOfUnity => "partition_of_unity",
        ClaimKind::Nonnegative => "nonnegative",
        ClaimKind::Symmetric => "symmetric",
        ClaimKind::Independent(_) => "independent",
        ClaimKind::Continuity(_) => "continuity",
        _ => "relation",
    }
}

/// A text that can stand in a comment of Coq.
fn comment(text: &str) -> String {
    text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}
