//! `basis emit`: proved families and joins as source files of a language.

use std::fs;
use std::path::{Path, PathBuf};

use basis_engine::emit::c::{C, Scalar};
use basis_engine::emit::python::Python;
use basis_engine::emit::rust::{self, Digest};
use basis_engine::emit::shader::Shader;
use basis_engine::emit::typescript::TypeScript;
use basis_engine::emit::{self, Job, Wanted};
use basis_engine::state::Run;
use basis_engine::theorem::theorems;
use basis_engine::{
    Diagnostic, Disk, Item, Library, Prover, Selected, Severity, Sources, Subject, TheoremKind,
    contradictions, decide_within,
};
use syn::parse_quote;

use crate::args::{EmitArguments, EmitScalar, EmitTarget};
use crate::output::{self, Status, complain, error};
use crate::{eval, spec};

/// Writes the families and joins that the arguments name, or says whether a file has them.
pub(crate) fn run(arguments: &EmitArguments) -> Status {
    if let Err(error) = has_scalar(arguments) {
        return refuse(&Sources::default(), &[error], Status::Unusable);
    }
    let library = match spec::read(&arguments.file) {
        Ok(source) => Library::from_source(&Disk, &Prover, source),
        Err(error) => return refuse(&Sources::default(), &[error], Status::Unusable),
    };
    let sources = library.sources();
    let selected = selected(&library, &arguments.names);
    // Those of a family are found when it is expanded.
    let errors =
        library.diagnostics().into_iter().filter(|d| d.severity == Severity::Error).collect::<Vec<_>>();
    if !errors.is_empty() {
        return refuse(sources, &errors, Status::Wrong);
    }
    let items = match selected {
        Ok(items) => items,
        Err(errors) => return refuse(sources, &errors, Status::Unusable),
    };
    let (mut wanted, mut diagnostics) = (Vec::new(), Vec::new());
    let run = &mut Run::default();
    for (item, name) in items {
        let checked = decide_within(item, run);
        diagnostics.extend(contradictions(&checked));
        // A theorem says something, and computes nothing.
        if !matches!(&checked.subject, Subject::Theorem(theorem) if theorem.kind != TheoremKind::Join) {
            wanted.push(Wanted { checked, name });
        }
    }
    // Warnings, such as that a conjecture is true, are said beside what is written.
    say(sources, &diagnostics);
    if diagnostics.iter().any(|d| d.severity == Severity::Error) {
        return Status::Wrong;
    }
    let spec = arguments.file.to_string_lossy().replace('\\', "/");
    let command = command(arguments, &spec);
    let job = Job { items: &wanted, spec: &spec, command: &command };
    let text = match arguments.to {
        EmitTarget::Rust => rust_text(&job, &library, destination(arguments)),
        EmitTarget::C => emit::emit(&C(scalar(arguments, Scalar::F64)), &job),
        EmitTarget::Python => emit::emit(&Python, &job),
        EmitTarget::TypeScript => emit::emit(&TypeScript, &job),
        EmitTarget::Wgsl => emit::emit(&Shader::Wgsl, &job),
        EmitTarget::Glsl => emit::emit(&Shader::Glsl, &job),
    };
    match text {
        Ok(text) => finish(arguments, &text, &command),
        Err(errors) => refuse(sources, &errors, Status::Wrong),
    }
}

/// Whether the language has the scalar type that is asked for; Rust and Python take numbers as they come.
fn has_scalar(arguments: &EmitArguments) -> Result<(), Diagnostic> {
    let other = match (arguments.to, arguments.scalar) {
        (EmitTarget::Rust, Some(EmitScalar::F32)) => {
            "the types of Rust are for f64 and f32: `QuarticBernstein::<f32>::new`"
        }
        (EmitTarget::Python, Some(EmitScalar::F32)) => {
            "Python computes with the numbers that it is given, arrays of float32 included"
        }
        (EmitTarget::TypeScript, Some(EmitScalar::F32)) => "the numbers of TypeScript are f64",
        (EmitTarget::Wgsl, Some(EmitScalar::F64)) => "WGSL has no f64",
        (EmitTarget::Glsl, Some(EmitScalar::F64)) => "GLSL is written with f32, which every version has",
        _ => return Ok(()),
    };
    Err(error(other).help("leave out `--scalar`"))
}

/// The scalar type that is asked for.
fn scalar(arguments: &EmitArguments, default: Scalar) -> Scalar {
    match arguments.scalar {
        None => default,
        Some(EmitScalar::F32) => Scalar::F32,
        Some(EmitScalar::F64) => Scalar::F64,
    }
}

fn refuse(sources: &Sources, errors: &[Diagnostic], status: Status) -> Status {
    say(sources, errors);
    status
}

fn say(sources: &Sources, diagnostics: &[Diagnostic]) {
    for diagnostic in diagnostics {
        complain(&(diagnostic.render(sources, true) + "\n\n"));
    }
}

/// The file that the text belongs to.
fn destination(arguments: &EmitArguments) -> Option<&Path> {
    arguments.output.as_deref().or(arguments.check.as_deref())
}

/// Writes the text to its file or to standard output, or compares it with a file.
fn finish(arguments: &EmitArguments, text: &str, command: &str) -> Status {
    let unusable = |message: String| refuse(&Sources::default(), &[error(message)], Status::Unusable);
    if let Some(path) = &arguments.check {
        return match fs::read_to_string(path) {
            Ok(found) if same(arguments.to, &found, text) => Status::Fine,
            Ok(_) => {
                let message = format!("`{}` is not what the spec gives now", path.display());
                let error = error(message).help(format!("run `{command}`"));
                refuse(&Sources::default(), &[error], Status::Wrong)
            }
            Err(e) => unusable(format!("cannot read `{}`: {e}", path.display())),
        };
    }
    match &arguments.output {
        None => output::print(text),
        Some(path) => match fs::write(path, text) {
            Ok(()) => Status::Fine,
            Err(e) => unusable(format!("cannot write `{}`: {e}", path.display())),
        },
    }
}

/// Whether a file has a text; line ends and, in Rust, the layout make no difference.
fn same(target: EmitTarget, found: &str, text: &str) -> bool {
    let found = found.replace('\r', "");
    let comments = |text: &str| -> Vec<String> {
        text.lines().filter(|line| line.starts_with("// ")).map(String::from).collect()
    };
    let code = |text: &str| syn::parse_file(text).map(|file| prettyplease::unparse(&file)).ok();
    match target {
        _ if found == text => true,
        EmitTarget::Rust => {
            comments(&found) == comments(text) && code(text).is_some_and(|t| code(&found) == Some(t))
        }
        _ => false,
    }
}

/// The command that writes the file again.
fn command(arguments: &EmitArguments, spec: &str) -> String {
    let quoted = |text: &str| {
        let plain = text.chars().all(|c| c.is_alphanumeric() || "_-./:".contains(c));
        if plain { text.to_string() } else { format!("'{text}'") }
    };
    let mut words = vec![String::from("basis emit"), quoted(spec)];
    words.extend(arguments.names.iter().map(|name| quoted(name)));
    words.push(format!("--to {}", arguments.to.name()));
    words.extend(arguments.scalar.map(|scalar| format!("--scalar {}", scalar.name())));
    if let Some(path) = destination(arguments) {
        words.push(format!("-o {}", quoted(&path.to_string_lossy().replace('\\', "/"))));
    }
    words.join(" ")
}

/// What is named, with the names for the file: `Bernstein(n=3) as Cubic`, `G1`. Without names every family without
/// index parameters, every join, and every theorem, which has to be true as well.
fn selected(library: &Library<'_>, names: &[String]) -> Result<Vec<(Item, Option<String>)>, Vec<Diagnostic>> {
    let theorems = theorems(library);
    if names.is_empty() {
        let families = library.items(Selected::WithoutOrder);
        let nothing = families.is_empty() && theorems.iter().all(|item| !is_join(item));
        if nothing {
            let error = error("the spec has no join, and every family in it has index parameters");
            let name = library.names().first().map_or_else(String::new, |(name, _)| name.clone());
            return Err(vec![
                error.help(format!("name the families with their orders, such as '{name}(3)'")),
            ]);
        }
        return Ok(families.into_iter().chain(theorems).map(|item| (item, None)).collect());
    }
    let mut items = Vec::new();
    let mut errors = Vec::new();
    for text in names {
        let (own, other) = match text.split_once(" as ") {
            Some((own, other)) => (own.trim(), Some(other.trim().to_string())),
            None => (text.trim(), None),
        };
        if let Some(theorem) = theorems.iter().find(|theorem| theorem.subject.name() == own) {
            if is_join(theorem) {
                items.push((theorem.clone(), other));
            } else {
                let message = format!("`{own}` is a theorem, which computes nothing");
                errors.push(error(message).help("name families and joins"));
            }
            continue;
        }
        let item = eval::find_family(library, own).and_then(|family| {
            let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
            library.item(&family.name, &order).map_err(|_| library.diagnostics())
        });
        match item {
            Ok(item) => items.push((item, other)),
            Err(problems) => errors.extend(problems),
        }
    }
    if errors.is_empty() { Ok(items) } else { Err(errors) }
}

fn is_join(item: &Item) -> bool {
    matches!(&item.subject, Subject::Theorem(theorem) if theorem.kind == TheoremKind::Join)
}

/// The text of a file of Rust. With a file to go to, an edited spec stops its build.
fn rust_text(
    job: &Job<'_>,
    library: &Library<'_>,
    destination: Option<&Path>,
) -> Result<String, Vec<Diagnostic>> {
    let mut specs = Vec::new();
    for (_, source) in library.sources().iter() {
        if let (Some(path), Some(destination)) = (&source.path, destination) {
            specs.push(digest(path, destination).map_err(|error| vec![error])?);
        }
    }
    let items = rust::items(job, &specs)?;
    let file: syn::File = syn::parse2(items).map_err(|e| {
        vec![
            error(format!("the generated code is not Rust: {e}"))
                .help("this is a mistake in basis; report it"),
        ]
    })?;
    let mut text: String =
        emit::header(job).iter().map(|line| format!("// {line}").trim_end().to_string() + "\n").collect();
    for mut item in file.items {
        // Nobody uses all of it.
        match &mut item {
            syn::Item::Struct(item) => item.attrs.push(parse_quote!(#[allow(dead_code)])),
            syn::Item::Impl(item) if item.trait_.is_none() => {
                item.attrs.push(parse_quote!(#[allow(dead_code)]));
            }
            syn::Item::Fn(item) => item.attrs.push(parse_quote!(#[allow(dead_code)])),
            _ => {}
        }
        let file = syn::parse_quote!(#item);
        text += "\n";
        text += &spaced(&prettyplease::unparse(&file));
    }
    Ok(text)
}

/// The same with an empty line between functions.
fn spaced(code: &str) -> String {
    let mut text = String::new();
    let mut ended = false;
    for line in code.lines() {
        let start = line.trim_start();
        if ended && ["///", "#[", "pub fn ", "fn "].iter().any(|word| start.starts_with(word)) {
            text += "\n";
        }
        text += line;
        text += "\n";
        ended = start == "}";
    }
    text
}

/// The digest of a spec, and its path from the folder of another file.
fn digest(spec: &Path, destination: &Path) -> Result<Digest, Diagnostic> {
    let bytes = fs::read(spec).map_err(|e| error(format!("cannot read `{}`: {e}", spec.display())))?;
    let folder = match destination.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let absolute = |path: &Path| {
        path.canonicalize().map_err(|e| error(format!("cannot find `{}`: {e}", path.display())))
    };
    let path = relative(&absolute(folder)?, &absolute(spec)?);
    Ok(Digest { path: path.to_string_lossy().replace('\\', "/"), digest: rust::digest(&bytes) })
}

/// The path to a file from a folder, both absolute.
fn relative(folder: &Path, file: &Path) -> PathBuf {
    let shared = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return file.to_path_buf();
    }
    let up = folder.components().skip(shared).map(|_| Path::new(".."));
    up.chain(file.components().skip(shared).map(|part| Path::new(part.as_os_str()))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_go_up_and_down() {
        let to = |folder: &str, file: &str| {
            relative(Path::new(folder), Path::new(file)).to_string_lossy().into_owned()
        };
        assert_eq!(to("/a/b/src", "/a/b/specs/q.basis"), "../specs/q.basis");
        assert_eq!(to("/a/b", "/a/b/q.basis"), "q.basis");
        assert_eq!(to("/a/b/c", "/d/q.basis"), "../../../d/q.basis");
    }
}
