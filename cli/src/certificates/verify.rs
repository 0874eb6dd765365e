//! `basis verify`: checks certificates against the specs that they are about, and proofs against statements.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use basis_engine::algebra::rational::Rational;
use basis_engine::prove::{Witness, as_declared, check};
use basis_engine::{Diagnostic, Disk, Library, Selected, Severity, Sources, Theorem, Verdict, prove};
use serde::Serialize;
use serde_json::{Map, Value};

use super::fields::Fields;
use super::text::{coordinate, number};
use super::{FORMAT, manifest, proofs, statements, write};
use crate::args::{Format, VerifyArguments};
use crate::check::files;
use crate::check::prove::{Question, Subject};
use crate::name::count;
use crate::output::{self, Status, complain, error};
use crate::spec;

/// What verifying a folder gives.
#[derive(Debug, Serialize)]
struct Report {
    /// What is wrong with the list of the specs whose certificates the folder holds.
    manifest: Vec<String>,
    certificates: Vec<Verified>,
    /// Items of the specs for which there is no certificate.
    missing: Vec<String>,
    ok: bool,
}

/// What verifying one certificate gives.
#[derive(Debug, Serialize)]
struct Verified {
    path: String,
    /// What it is about, if that can be read.
    of: Option<String>,
    claims: usize,
    problems: Vec<String>,
    #[serde(skip)]
    status: Status,
}

/// Verifies all certificates in a folder.
pub(crate) fn run(arguments: &VerifyArguments) -> Status {
    let start = Instant::now();
    let mut files = Vec::new();
    if let Err(e) = find(&arguments.folder, &mut files) {
        return unusable(format!("cannot read the folder `{}`: {e}", arguments.folder.display()));
    }
    files.retain(|file| *file != manifest::path(&arguments.folder));
    files.sort();
    if files.is_empty() {
        return unusable(format!("there is no certificate in the folder `{}`", arguments.folder.display()));
    }
    let mut specs = Specs { folder: arguments.folder.clone(), known: BTreeMap::new() };
    let listed = manifest::verify(&arguments.folder, &arguments.specs, &mut specs);
    let certificates: Vec<Verified> = files.iter().map(|path| one(path, &mut specs)).collect();
    let missing = specs.missing();
    let mut status = certificates.iter().map(|c| c.status).max().unwrap_or(Status::Fine);
    if !missing.is_empty() || !listed.is_empty() {
        status = status.max(Status::Wrong);
    }
    let report = Report { manifest: listed, certificates, missing, ok: status == Status::Fine };
    let printed = match arguments.format {
        Format::Json => output::print_json(&report),
        Format::Text => output::print(&text(&report, start)),
    };
    status.max(printed)
}

fn unusable(message: String) -> Status {
    complain(&(error(message).render(&Sources::default(), true) + "\n"));
    Status::Unusable
}

fn find(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        // Links are not followed: they could form a loop.
        if entry.file_type()?.is_dir() {
            find(&path, files)?;
        } else if path.extension().is_some_and(|e| e == "json") {
            files.push(path);
        }
    }
    Ok(())
}

fn text(report: &Report, start: Instant) -> String {
    let mut text = String::new();
    for certificate in &report.certificates {
        let mark = if certificate.problems.is_empty() { '✓' } else { '✗' };
        let of = certificate.of.as_deref().unwrap_or("?");
        text += &format!(" {mark} {of}  {}  {}\n", count(certificate.claims, "claim"), certificate.path);
        for problem in &certificate.problems {
            text += &format!("     {problem}\n");
        }
    }
    for problem in &report.manifest {
        text += &format!(" ✗ {problem}\n");
    }
    for missing in &report.missing {
        text += &format!(" ✗ {missing}: there is no certificate\n");
    }
    let rejected = report.certificates.iter().filter(|c| !c.problems.is_empty()).count();
    let claims = report.certificates.iter().map(|c| c.claims).sum();
    let outcome = match (rejected, report.missing.len()) {
        (0, 0) if !report.manifest.is_empty() => String::from("the list of the specs is rejected"),
        (0, 0) => String::from("all verified"),
        (0, missing) => format!("{missing} missing"),
        (rejected, 0) => format!("{rejected} rejected"),
        (rejected, missing) => format!("{rejected} rejected, {missing} missing"),
    };
    let all = count(report.certificates.len(), "certificate");
    let seconds = start.elapsed().as_secs_f64();
    text + &format!("\n{all}, {}: {outcome}; {seconds:.2} s\n", count(claims, "claim"))
}

/// The specs that certificates are about, each read once.
pub(super) struct Specs {
    folder: PathBuf,
    known: BTreeMap<String, Result<Vec<Item>, String>>,
}

/// A family of one order, a theorem or a join, with what the spec says of it.
#[derive(Debug)]
pub(super) struct Item {
    pub(super) subject: Subject,
    /// The claims with their lines.
    pub(super) claims: Vec<(Question, Option<usize>)>,
    /// Whether a certificate was found.
    pub(super) found: bool,
}

impl Specs {
    /// The folders in which the paths of specs may begin: where `check` was run, or around the certificates.
    fn bases(folder: &Path) -> Vec<PathBuf> {
        let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_path_buf());
        std::iter::once(PathBuf::new()).chain(folder.ancestors().map(Path::to_path_buf)).collect()
    }

    /// What a spec says.
    pub(super) fn items(&mut self, path: &str) -> Result<&mut Vec<Item>, String> {
        let folder = &self.folder;
        let items = self.known.entry(path.to_string()).or_insert_with(|| {
            let places = Self::bases(folder).into_iter().map(|base| base.join(path));
            let place = places.into_iter().find(|p| p.is_file());
            let place = place.ok_or(format!("there is no spec `{path}` here or around the certificates"))?;
            items(&place)
        });
        items.as_mut().map_err(|e| e.clone())
    }

    /// The specs that a path of the command line stands for, as `check` names them.
    pub(super) fn under(&self, path: &Path) -> Vec<String> {
        for base in Self::bases(&self.folder) {
            let place = base.join(path);
            if !place.exists() {
                continue;
            }
            let named = |file: &Path| match file.strip_prefix(&place) {
                Ok(rest) if !rest.as_os_str().is_empty() => path.join(rest),
                _ => path.to_path_buf(),
            };
            let found =
                files::find(std::slice::from_ref(&place)).into_iter().filter(|entry| entry.problem.is_none());
            let found: Vec<String> = found.map(|entry| named(&entry.path).display().to_string()).collect();
            // A folder of certificates can have the same name.
            if !found.is_empty() {
                return found;
            }
        }
        vec![path.display().to_string()]
    }

    fn missing(&self) -> Vec<String> {
        let items = self.known.iter().filter_map(|(path, items)| Some((path, items.as_ref().ok()?)));
        let lost = items.flat_map(|(path, items)| items.iter().filter(|i| !i.found).map(move |i| (path, i)));
        lost.map(|(path, item)| format!("{path}: {}", write::title(&item.subject))).collect()
    }
}

/// Everything that a spec says.
pub(super) fn items(path: &Path) -> Result<Vec<Item>, String> {
    let source = spec::read(path).map_err(|e| e.text())?;
    let library = Library::from_source(&Disk, source);
    let diagnostics = library.diagnostics();
    if let Some(error) = diagnostics.iter().find(|d| d.severity == Severity::Error) {
        return Err(format!("the spec `{}` has errors: {}", path.display(), Diagnostic::text(error)));
    }
    let line = |place: &basis_engine::diagnostic::Place| match place {
        basis_engine::diagnostic::Place::Text(id, range) => {
            Some(library.sources().get(*id).line_column(range.start).0)
        }
        basis_engine::diagnostic::Place::Token(..) => None,
    };
    let with_line = |question: Question| {
        let line = line(question.place());
        (question, line)
    };
    let families = library.items(Selected::EveryOrder).into_iter().map(|item| Item {
        claims: item.claims.into_iter().map(|c| with_line(Question::Family(c))).collect(),
        subject: Subject::Family(item.family),
        found: false,
    });
    let theorems = library.theorems().into_iter().map(|theorem: Theorem| Item {
        claims: theorem.claims.iter().map(|c| with_line(Question::Theorem(c.clone()))).collect(),
        subject: Subject::Theorem(Box::new(theorem)),
        found: false,
    });
    Ok(families.chain(theorems).collect())
}

/// Verifies one certificate.
fn one(path: &Path, specs: &mut Specs) -> Verified {
    let mut verified = Verified {
        path: path.display().to_string(),
        of: None,
        claims: 0,
        problems: Vec::new(),
        status: Status::Fine,
    };
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(e) => {
            verified.problems.push(format!("cannot be read: {e}"));
            verified.status = Status::Unusable;
            return verified;
        }
    };
    let value: Value = match serde_json::from_str(&text) {
        Ok(value) => value,
        Err(e) => {
            verified.problems.push(format!("is not JSON: {e}"));
            verified.status = Status::Wrong;
            return verified;
        }
    };
    let spec = value.get("spec").and_then(Value::as_str).unwrap_or_default();
    verified.of = value.get("name").and_then(Value::as_str).map(|name| format!("{spec}: {name}"));
    verified.claims = value.get("claims").and_then(Value::as_array).map_or(0, Vec::len);
    verified.status = match specs.items(spec) {
        Ok(items) => {
            verified.problems = certificate(&value, spec, items);
            if verified.problems.is_empty() { Status::Fine } else { Status::Wrong }
        }
        Err(problem) => {
            verified.problems.push(problem);
            Status::Unusable
        }
    };
    verified
}

/// What is wrong with a certificate about one of the items of a spec.
pub(super) fn certificate(value: &Value, spec: &str, items: &mut [Item]) -> Vec<String> {
    let of = |item: &Item| {
        let subject = statements::subject(&item.subject);
        ["kind", "name", "order"].iter().all(|key| value.get(*key) == subject.get(*key))
    };
    let Some(item) = items.iter_mut().find(|item| of(item)) else {
        return vec![String::from("the spec has no such family, theorem or join")];
    };
    item.found = true;
    match against(value, spec, item) {
        Ok(problems) => problems,
        Err(problem) => vec![problem],
    }
}

/// Everything but the claims must be as the spec says; then the claims one by one.
fn against(value: &Value, spec: &str, item: &Item) -> Result<Vec<String>, String> {
    let mut fields = Fields::of(value)?;
    if fields.text("format")? != FORMAT {
        return Err(format!("the format is not `{FORMAT}`"));
    }
    if fields.text("spec")? != spec {
        return Err(String::from("the spec is another one"));
    }
    for (key, expected) in statements::subject(&item.subject) {
        if *fields.take(&key)? != expected {
            return Err(format!("`{key}` is not what the spec says"));
        }
    }
    let claims = fields.list("claims")?;
    fields.end()?;
    if claims.len() != item.claims.len() {
        return Err(format!("there are {} claims, and the spec makes {}", claims.len(), item.claims.len()));
    }
    let names = statements::names(&item.subject);
    let mut problems = Vec::new();
    for (value, (question, line)) in claims.iter().zip(&item.claims) {
        if let Err(problem) = claim(value, question, *line, &item.subject, &names) {
            problems.push(format!("`{}`: {problem}", question.text()));
        }
    }
    Ok(problems)
}

/// What a certificate says of one claim.
pub(super) fn claim(
    value: &Value,
    question: &Question,
    line: Option<usize>,
    subject: &Subject,
    names: &[String],
) -> Result<(), String> {
    let mut fields = Fields::of(value)?;
    for (key, expected) in write::head(question, line) {
        if *fields.take(&key)? != expected {
            return Err(format!("`{key}` is not what the spec says"));
        }
    }
    let verdict = match fields.text("verdict")? {
        "proved" => {
            steps(fields.list("steps")?, &subject.statements(question), names)?;
            Verdict::Proved(prove::Evidence { method: String::new(), steps: Vec::new() })
        }
        "refuted" => {
            let witness = witness(fields.take("witness")?)?;
            subject.check_witness(question, &witness)?;
            Verdict::Refuted(witness)
        }
        "undecided" => return Err(String::from("the claim is undecided")),
        other => return Err(format!("`{other}` is not a verdict")),
    };
    fields.end()?;
    if as_declared(question.expected(), &verdict) {
        Ok(())
    } else {
        Err(String::from("the verdict contradicts what the spec declares"))
    }
}

/// Every statement must be what the spec says, and its proof must show the statement as it stands in the certificate.
fn steps(values: &[Value], expected: &[prove::Statement], names: &[String]) -> Result<(), String> {
    if values.len() != expected.len() {
        return Err(format!("there are {} proofs for {} statements", values.len(), expected.len()));
    }
    for (value, expected) in values.iter().zip(expected) {
        let of = &expected.of;
        step(value, expected, names).map_err(|e| format!("`{of}`: {e}"))?;
    }
    Ok(())
}

fn step(value: &Value, expected: &prove::Statement, names: &[String]) -> Result<(), String> {
    for (key, expected) in statements::statement(names, expected) {
        if value.get(&key) != Some(&expected) {
            return Err(format!("`{key}` is not what the spec says"));
        }
    }
    let mut fields = Fields::of(value)?;
    let statement = statements::read(&mut fields, names, expected.budget)?;
    let (proof, written) = proofs::read(&statement, fields.take("proof")?, names)?;
    fields.end()?;
    // Here nothing is known but the statement and the proof.
    if check::proof(&statement, &proof)? == written {
        Ok(())
    } else {
        Err(String::from("a Bernstein coefficient or a minor has another value"))
    }
}

fn witness(value: &Value) -> Result<Witness, String> {
    let mut fields = Fields::of(value)?;
    let of = fields.text("of")?.to_string();
    let named = |value: &Value| -> Result<Map<String, Value>, String> {
        value.as_object().cloned().ok_or_else(|| String::from("a point is not an object"))
    };
    let mut at = Vec::new();
    for (name, value) in named(fields.take("at")?)? {
        let value = coordinate(value.as_str().ok_or("a coordinate is not a text")?, &name)?;
        at.push((name, value));
    }
    let mut net = Vec::new();
    for (name, value) in named(fields.take("net")?)? {
        let place = place(value.as_str().ok_or("a point is not a text")?)?;
        net.push((name, place));
    }
    let value = number(fields.text("value")?)?;
    fields.end()?;
    Ok(Witness { of, at, idle: Vec::new(), net, value, notes: Vec::new() })
}

/// A point such as `(1, 1/2)`.
fn place(text: &str) -> Result<Vec<Rational>, String> {
    let inner = text.strip_prefix('(').and_then(|t| t.strip_suffix(')'));
    if inner == Some("") {
        return Ok(Vec::new());
    }
    let inner = inner.ok_or_else(|| format!("`{text}` is not a point such as `(1, 1/2)`"))?;
    inner.split(", ").map(number).collect()
}
