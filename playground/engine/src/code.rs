//! Generated code, as `basis emit` writes it.

use basis_engine::emit::c::{C, Scalar};
use basis_engine::emit::python::Python;
use basis_engine::emit::shader::Shader;
use basis_engine::emit::typescript::TypeScript;
use basis_engine::emit::{self, Job, Wanted, rust};
use basis_engine::state::Run;
use basis_engine::{
    Checked, Diagnostic, Library, Prover, Selected, Source, Subject, TheoremKind, contradictions,
    decide_within, theorem,
};
use serde_json::{Value, json};

use crate::layout;
use crate::text::{NAME, NoFiles};

/// A language: its name for `basis emit --to`, its usual name, and how a file is written in it.
type Target = (&'static str, &'static str, fn(&Job<'_>) -> Result<String, Vec<Diagnostic>>);

/// What `basis emit` writes.
const TARGETS: &[Target] = &[
    ("rust", "Rust", rust_text),
    ("c", "C", |job| emit::emit(&C(Scalar::F64), job)),
    ("python", "Python", |job| emit::emit(&Python, job)),
    ("wgsl", "WGSL", |job| emit::emit(&Shader::Wgsl, job)),
    ("glsl", "GLSL", |job| emit::emit(&Shader::Glsl, job)),
    ("typescript", "TypeScript", |job| emit::emit(&TypeScript, job)),
];

/// The languages: the name of each for `basis emit --to`, and its usual name.
pub(crate) fn languages() -> Vec<[&'static str; 2]> {
    TARGETS.iter().map(|(to, name, _)| [*to, *name]).collect()
}

/// The code of a family or join of a text in a language.
pub(crate) fn emit(text: &str, subject: &Subject, to: &str) -> Value {
    let library = Library::from_source(&NoFiles, &Prover, Source::text(NAME, text));
    let run = &mut Run::default();
    let wanted = match item(&library, subject, run) {
        Ok(checked) => [Wanted { checked, name: None }],
        Err(why) => return json!({ "error": why }),
    };
    let title = subject.title();
    let quoted = if subject.order().is_empty() { title } else { format!("'{title}'") };
    let command = format!("basis emit {NAME} {quoted} --to {to}");
    let job = Job { items: &wanted, spec: NAME, command: &command };
    let Some((.., write)) = TARGETS.iter().find(|(known, ..)| *known == to) else {
        return json!({ "error": format!("there is no language `{to}`") });
    };
    match write(&job) {
        Ok(text) => json!({ "code": text, "command": command }),
        Err(errors) => json!({ "error": messages(&errors) }),
    }
}

fn messages(errors: &[Diagnostic]) -> String {
    errors.iter().map(Diagnostic::text).collect::<Vec<_>>().join("\n\n")
}

/// The family or join again, with its verdicts; code is written only for what is as it is declared.
fn item(library: &Library<'_>, subject: &Subject, run: &mut Run) -> Result<Checked, String> {
    if let Subject::Theorem(theorem) = subject
        && theorem.kind != TheoremKind::Join
    {
        return Err(String::from(
            "a theorem says something, and computes nothing: choose a family or a join",
        ));
    }
    let mut all = library.items(Selected::EveryOrder).into_iter().chain(theorem::theorems(library));
    let same = |other: &Subject| other.is_same(subject) && other.order() == subject.order();
    let Some(item) = all.find(|item| same(&item.subject)) else {
        return Err(String::from("the spec has errors; correct them first"));
    };
    let checked = decide_within(item, run);
    let wrong = contradictions(&checked);
    if wrong.is_empty() { Ok(checked) } else { Err(messages(&wrong)) }
}

/// A file of Rust. The layout is our own, because a formatter is half as large as the engine; `basis emit --check` does
/// not look at it.
fn rust_text(job: &Job<'_>) -> Result<String, Vec<Diagnostic>> {
    let items = rust::items(job, &[])?;
    let header: String =
        emit::header(job).iter().map(|line| format!("// {line}").trim_end().to_string() + "\n").collect();
    Ok(format!("{header}\n{}", layout::text(items)))
}
