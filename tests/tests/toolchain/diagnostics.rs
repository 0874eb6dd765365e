//! What a mistake in a spec is answered with: every message with its place, notes and advice.
//!
//! Each spec in `specs/bad` carries what is expected of it as comments under the lines concerned:
//!
//! ```text
//!     b[0] = 1 - tt;
//! //~            ^^ error: the name `tt` is not declared
//! //~               help: …
//! ```
//!
//! Carets mark the main place, dashes another one. A place in the first three columns, where the comment itself
//! stands, is written as a number. `BASIS_TESTS=overwrite cargo test -p basis-tests --test toolchain diagnostics` writes the
//! messages of today into the files; read the difference before you keep it.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use basis_engine::diagnostic::Place;
use basis_engine::{Diagnostic, Severity, Source, check, source};

const MARK: &str = "//~";

fn specs(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = folder.read_dir().unwrap().map(|e| e.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            specs(&path, found);
        } else if path.extension().is_some_and(|e| e == "basis") {
            found.push(path);
        }
    }
}

#[test]
fn are_as_written_in_the_specs() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("specs/bad");
    let overwrite = std::env::var_os("BASIS_TESTS").is_some_and(|v| v == "overwrite");
    let mut found = Vec::new();
    specs(&folder, &mut found);
    assert!(found.len() > 40, "the specs are missing");
    let mut wrong = String::new();
    for path in found {
        let expected = std::fs::read_to_string(&path).unwrap();
        let actual = annotated(&path, &expected);
        if actual == expected {
            continue;
        }
        if overwrite {
            std::fs::write(&path, &actual).unwrap();
        }
        writeln!(wrong, "{}, with the messages of today:\n{actual}", path.display()).unwrap();
    }
    assert!(overwrite || wrong.is_empty(), "{wrong}");
}

/// Correct specs have neither errors nor warnings.
#[test]
fn correct_specs_have_none() {
    let mut found = Vec::new();
    specs(&Path::new(env!("CARGO_MANIFEST_DIR")).join("specs/good"), &mut found);
    assert!(!found.is_empty(), "the specs are missing");
    for path in found {
        let report = check(Source::text("good.basis", &std::fs::read_to_string(&path).unwrap()));
        let said: Vec<_> = report.diagnostics.iter().map(|d| d.render(&report.sources, false)).collect();
        assert!(said.is_empty(), "{}: {said:?}", path.display());
    }
}

/// The spec with the messages of today in place of those that it expects.
fn annotated(path: &Path, text: &str) -> String {
    let spec: String = text.split_inclusive('\n').filter(|line| !line.starts_with(MARK)).collect();
    let name = path.file_name().unwrap().to_str().unwrap();
    let report = check(Source::text(name, &spec).at(path.canonicalize().unwrap()));
    assert!(!report.diagnostics.is_empty(), "{name} is accepted");

    let main = report.sources.iter().next().unwrap().0;
    let mut notes: Vec<(usize, String)> = Vec::new();
    for diagnostic in &report.diagnostics {
        // A message is what makes the reader look; the places come before the words about them.
        let mut elsewhere = String::new();
        for (k, (place, label)) in diagnostic.labels.iter().enumerate() {
            let Place::Text(id, range) = place else { panic!("{name}: a place outside of all texts") };
            let (line, column) = report.sources.get(*id).line_column(range.start);
            let words = if k == 0 { headline(diagnostic) } else { label.clone() };
            if *id == main {
                let rest = spec.lines().nth(line - 1).map_or(0, |l| l.chars().count() + 1 - column);
                let width = spec[range.clone()].chars().count().clamp(1, rest.max(1));
                notes.push((line, marked(column, width, if k == 0 { '^' } else { '-' }, &words)));
                if k == 0 {
                    let indent = column + width;
                    notes.extend(facts(diagnostic).into_iter().map(|fact| {
                        (line, format!("{MARK}{:indent$}{fact}\n", "", indent = indent.max(4) - 3))
                    }));
                }
            } else {
                let file = &report.sources.get(*id).name;
                writeln!(elsewhere, "{MARK} {file} {line}:{column} {words}").unwrap();
                if k == 0 {
                    for fact in facts(diagnostic) {
                        writeln!(elsewhere, "{MARK}    {fact}").unwrap();
                    }
                }
            }
        }
        notes.push((usize::MAX, elsewhere));
    }
    // Messages about missing files name the folders of this machine.
    let folder = path.canonicalize().unwrap().parent().unwrap().display().to_string();
    assemble(&spec, &notes).replace(&folder, "$DIR")
}

fn headline(diagnostic: &Diagnostic) -> String {
    let level = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
    let label = diagnostic.labels.first().map(|(_, label)| label.as_str()).filter(|label| !label.is_empty());
    format!("{level}: {}{}", diagnostic.message, label.map(|l| format!(" ({l})")).unwrap_or_default())
}

fn facts(diagnostic: &Diagnostic) -> Vec<String> {
    let notes = diagnostic.notes.iter().map(|note| format!("note: {note}"));
    notes.chain(diagnostic.help.iter().map(|help| format!("help: {help}"))).collect()
}

fn marked(column: usize, width: usize, sign: char, words: &str) -> String {
    match column.checked_sub(MARK.len() + 1) {
        Some(indent) => format!("{MARK}{:indent$}{} {words}\n", "", sign.to_string().repeat(width)),
        None => format!("{MARK} column {column}: {words}\n"),
    }
}

/// Puts the notes under their lines.
fn assemble(spec: &str, notes: &[(usize, String)]) -> String {
    let mut result = String::new();
    let lines = spec.split_inclusive('\n').count();
    for (number, line) in (1..).zip(spec.split_inclusive('\n')) {
        result.push_str(line);
        let here = |at: usize| if number == lines { at >= number } else { at == number };
        let mut below = notes.iter().filter(|(at, text)| here(*at) && !text.is_empty()).peekable();
        if below.peek().is_some() && !line.ends_with('\n') {
            result.push('\n');
        }
        below.for_each(|(_, text)| result.push_str(text));
    }
    result
}

/// A file that is no spec never gets as far as its text.
#[test]
fn of_a_text_that_cannot_be_decoded() {
    let error = source::read(&Bytes(b"family F {\n    // caf\xe9\n}"), "latin1.basis", &[]).unwrap_err();
    assert_eq!(error.message, "`latin1.basis` is not UTF-8: invalid byte 0xe9 in line 2");
    assert_eq!(error.help.as_deref(), Some("save the file with the encoding UTF-8"));
}

struct Bytes(&'static [u8]);

impl basis_engine::Files for Bytes {
    fn read(&self, _: &Path) -> std::io::Result<Vec<u8>> {
        Ok(self.0.to_vec())
    }
}
