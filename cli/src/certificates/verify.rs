//! `basis verify`: checks certificates against the specs that they are about, and proofs against statements.

use basis_kernel::collections::sort::sort;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::time::Instant;

use basis_engine::algebra::rational::{self, Rational};
use basis_engine::algebra::work::Work;
use basis_engine::claim::Expected;
use basis_engine::model::obligation::Obligation;
use basis_engine::state;
use basis_engine::{Claim, Sources, Subject};
use basis_kernel::{Certificate, Proof, Refutation, Statement, Witness, text as kernel};
use serde::Serialize;
use serde_json::Value;

use super::fields::{Fields, list, text as word};
use super::head::{self, FORMAT, SIGNS};
use super::manifest;
use super::specs::{Specs, Stated};
use crate::args::{Format, VerifyArguments};
use crate::name::count;
use crate::output::{self, Status, complain, error};

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
    sort(&mut files);
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
    // What is wrong with a spec is said once.
    let mut said: Vec<&String> = Vec::new();
    for certificate in &report.certificates {
        let mark = if certificate.problems.is_empty() { '✓' } else { '✗' };
        let of = certificate.of.as_deref().unwrap_or("?");
        text += &format!(" {mark} {of}  {}  {}\n", count(certificate.claims, "claim"), certificate.path);
        let unusable = certificate.status == Status::Unusable;
        for problem in certificate.problems.iter().filter(|problem| !(unusable && said.contains(problem))) {
            text += &format!("     {problem}\n");
        }
        said.extend(certificate.problems.iter().filter(|_| unusable));
    }
    for problem in report.manifest.iter().filter(|problem| !said.contains(problem)) {
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
pub(super) fn certificate(value: &Value, spec: &str, items: &mut [Stated]) -> Vec<String> {
    let of = |stated: &Stated| {
        let subject = head::subject(&stated.item.subject);
        ["kind", "name", "order"].iter().all(|key| value.get(*key) == subject.get(*key))
    };
    let Some(stated) = items.iter_mut().find(|stated| of(stated)) else {
        return vec![String::from("the spec has no such family, theorem or join")];
    };
    stated.found = true;
    match against(value, spec, stated) {
        Ok(problems) => problems,
        Err(problem) => vec![problem],
    }
}

/// Everything but the proofs must be as the spec says; then the obligations and claims one by one.
fn against(value: &Value, spec: &str, stated: &Stated) -> Result<Vec<String>, String> {
    let mut fields = Fields::of(value)?;
    if fields.text("format")? != FORMAT {
        return Err(format!("the format is not `{FORMAT}`"));
    }
    if fields.text("spec")? != spec {
        return Err(String::from("it belongs to another spec"));
    }
    let item = &stated.item;
    for (key, expected) in head::subject(&item.subject) {
        if *fields.take(&key)? != expected {
            return Err(format!("`{key}` is not what the spec says"));
        }
    }
    let obligations = fields.list("obligations")?;
    let claims = fields.list("claims")?;
    fields.end()?;
    if obligations.len() != item.obligations.len() {
        return Err(format!(
            "the spec has {} obligations, the certificate {}",
            item.obligations.len(),
            obligations.len()
        ));
    }
    if claims.len() != item.claims.len() {
        return Err(format!("the certificate has {} claims, the spec {}", claims.len(), item.claims.len()));
    }
    let budget = item.subject.budget();
    let mut problems = Vec::new();
    for (value, known) in obligations.iter().zip(&item.obligations) {
        if let Err(problem) = obligation(value, known, budget) {
            problems.push(format!("`{}`: {problem}", known.of));
        }
    }
    for ((value, claim), line) in claims.iter().zip(&item.claims).zip(&stated.lines) {
        if let Err(problem) = self::claim(value, &item.subject, claim, *line) {
            problems.push(format!("`{}`: {problem}", claim.text));
        }
    }
    Ok(problems)
}

/// Checks something that must be true for the formulas to mean something.
fn obligation(value: &Value, known: &Obligation, budget: u32) -> Result<(), String> {
    let mut fields = Fields::of(value)?;
    if fields.text("of")? != known.of {
        return Err(String::from("this is not what the spec needs"));
    }
    let alternative = alternative(&mut fields)?;
    let way = match fields.take_if_any("way") {
        None => None,
        Some(way) => {
            let way = way.as_u64().and_then(|way| usize::try_from(way).ok());
            Some(way.ok_or("`way` is not a number")?)
        }
    };
    let statements = state::ground_statements(&known.goal, alternative, way);
    let statements = statements.ok_or("nothing that is enough for it is known by that sign and way")?;
    if way.is_none() {
        let proof = fields.take_if_any("proof");
        fields.end()?;
        return statements.into_iter().try_for_each(|statement| shown(statement, proof, budget));
    }
    if fields.take("steps")?.as_u64() != Some(statements.len() as u64) {
        return Err(format!("the way leads to {}", count(statements.len(), "statement")));
    }
    let named = statements.into_iter().map(|statement| (known.of.clone(), statement));
    proofs(named, fields.take_if_any("proofs"), budget)?;
    fields.end()
}

/// Which of the alternatives of a goal is proved.
fn alternative(fields: &mut Fields<'_>) -> Result<usize, String> {
    let mut found = 0;
    for (k, sign) in SIGNS.iter().enumerate() {
        let Some((sign, value)) = sign.and_then(|sign| Some((sign, fields.take_if_any(sign)?))) else {
            continue;
        };
        if *value != Value::Bool(true) || found > 0 {
            return Err(format!("`{sign}` is either `true`, alone, or absent"));
        }
        found = k;
    }
    Ok(found)
}

/// Has the kernel check a proof; without one, whether computing is enough.
fn shown(statement: Statement, proof: Option<&Value>, budget: u32) -> Result<(), String> {
    let certificate = match proof {
        None => Certificate::Direct,
        Some(proof) => match kernel::certificate(word(proof)?).map_err(|e| e.to_string())? {
            Certificate::Direct => return Err(String::from("a proof by computation alone is left out")),
            other => other,
        },
    };
    let proof = Proof::new(Rc::new(statement), certificate, &mut Work::usual(budget));
    proof.map(|_| ()).map_err(|e| e.to_string())
}

/// What a certificate says of one claim.
pub(super) fn claim(
    value: &Value,
    subject: &Subject,
    claim: &Claim,
    line: Option<usize>,
) -> Result<(), String> {
    let mut fields = Fields::of(value)?;
    for (key, expected) in head::claim(claim, line) {
        if *fields.take(&key)? != expected {
            return Err(format!("`{key}` is not what the spec says"));
        }
    }
    if let Some(steps) = fields.take_if_any("steps") {
        let ways = match fields.take_if_any("ways") {
            None => Vec::new(),
            Some(ways) => self::ways(ways)?,
        };
        let statements = state::statements(subject, claim, &ways)
            .ok_or("expanding the claim takes more work than the budget of the spec allows")?;
        if steps.as_u64() != Some(statements.len() as u64) {
            return Err(format!("the claim makes {}", count(statements.len(), "statement")));
        }
        let named = statements.into_iter().map(|stated| (stated.of, stated.statement));
        proofs(named, fields.take_if_any("proofs"), subject.budget())?;
        fields.end()?;
        return declared(claim, Expected::True);
    }
    if fields.take_if_any("left").is_some() {
        if claim.expected == Expected::Open {
            return fields.end();
        }
        return Err(String::from("the claim is undecided"));
    }
    let of = fields.text("of")?;
    let witness = kernel::witness(fields.text("witness")?).map_err(|e| e.to_string())?;
    let given = match fields.take_if_any("given") {
        None => Vec::new(),
        Some(given) => list(given)?.iter().map(place).collect::<Result<_, _>>()?,
    };
    let value = fields.take_if_any("value");
    let proof = fields.take_if_any("proof");
    fields.end()?;
    let instances = state::instances(subject, claim, &given)?;
    let found = instances.into_iter().find(|stated| stated.of == of).map(|stated| stated.statement);
    let statement = match found {
        Some(_) if proof.is_some() => {
            return Err(String::from("a value that is a number at a point needs no proof"));
        }
        Some(statement) => statement,
        None => {
            let [statement, negation] = beside(subject, claim, of, &witness)
                .ok_or_else(|| format!("the claim says nothing about `{of}`"))?;
            shown(negation, proof, subject.budget())?;
            statement
        }
    };
    let refutation = Refutation::new(Rc::new(statement), witness, &mut Work::usual(subject.budget()));
    let refutation = refutation.map_err(|e| e.to_string())?;
    if value.map(Value::as_str) != refutation.value().map(Rational::to_string).as_deref().map(Some) {
        return Err(String::from("the value is not that of the claim there"));
    }
    declared(claim, Expected::False)
}

/// What a claim says of `of` at the point of a witness, and that it fails whatever the numbers are that are not rational there.
fn beside(subject: &Subject, claim: &Claim, of: &str, witness: &Witness) -> Option<[Statement; 2]> {
    let Witness::At(point) = witness else { return None };
    let rational = point.root.is_none();
    let coordinates: Vec<_> = point.coordinates.iter().map(|(var, x)| (*var, x.leading())).collect();
    if rational { state::at_point(subject, claim, of, &coordinates) } else { None }
}

/// The numbers of the ways to what is enough for comparisons, not all of them 0.
fn ways(value: &Value) -> Result<Vec<usize>, String> {
    let ways: Option<Vec<usize>> =
        list(value)?.iter().map(|way| way.as_u64().and_then(|n| usize::try_from(n).ok())).collect();
    ways.filter(|all| all.iter().any(|way| *way > 0))
        .ok_or_else(|| String::from("`ways` is not as it is written"))
}

/// Whether a claim is declared as it was found to be.
fn declared(claim: &Claim, found: Expected) -> Result<(), String> {
    if claim.expected == found || claim.expected == Expected::Open && found == Expected::True {
        Ok(())
    } else {
        Err(String::from("the verdict contradicts what the spec declares"))
    }
}

/// Checks statements, each with what it is about, with the proofs that are written, by their places.
fn proofs(
    statements: impl Iterator<Item = (String, Statement)>,
    written: Option<&Value>,
    budget: u32,
) -> Result<(), String> {
    let mut fields = match written {
        None => None,
        Some(Value::Object(object)) if object.is_empty() => {
            return Err(String::from("an empty list of proofs is left out"));
        }
        Some(written) => Some(Fields::of(written)?),
    };
    for (place, (of, statement)) in statements.enumerate() {
        let proof = fields.as_mut().and_then(|f| f.take_if_any(&place.to_string()));
        shown(statement, proof, budget).map_err(|e| format!("`{of}`: {e}"))?;
    }
    fields.map_or(Ok(()), Fields::end)
}

/// The coordinates of a point.
fn place(value: &Value) -> Result<Vec<Rational>, String> {
    let number = |value: &Value| {
        let text = word(value)?;
        let number = rational::parse(text).filter(|x| x.to_string() == text);
        number.ok_or_else(|| format!("`{text}` is not a number in lowest terms"))
    };
    list(value)?.iter().map(number).collect()
}
