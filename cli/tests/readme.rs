//! What the README shows is what the command prints; the shipped specs are as declared.

mod support;

use std::path::Path;

use support::Folder;

const README: &str = include_str!("../../README.md");

fn spec(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(name);
    std::fs::read_to_string(path).expect("a shipped spec can be read")
}

#[test]
fn the_broken_family_is_refused_as_shown() {
    let broken = spec("quartic.basis").replace("shape -3 <= λ <= 1;", "shape -4 <= λ <= 1;");
    let run = Folder::with("specs/quartic.basis", &broken).run(&["check", "specs/quartic.basis"]);
    assert_eq!(run.code, 1);
    assert!(README.contains(run.stderr.trim()), "the README does not show this:\n{}", run.stderr);
}

#[test]
fn exact_values_are_as_shown() {
    let folder = Folder::with("specs/quartic.basis", &spec("quartic.basis"));
    let call = README
        .lines()
        .find_map(|line| line.strip_prefix("cargo run -p basis-cli -- eval "))
        .expect("the README shows `eval`");
    let arguments: Vec<&str> = core::iter::once("eval").chain(call.split_whitespace()).collect();
    let run = folder.run(&arguments);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(README.contains(run.stdout.trim()), "the README does not show this:\n{}", run.stdout);
}

#[test]
fn certificates_are_as_shown() {
    let folder = Folder::with("quartic.basis", &spec("quartic.basis"));
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "quartic.basis"]).code, 0);
    let certificate = folder.path().join("proofs/quartic/QuarticBernstein.json");
    let certificate = std::fs::read_to_string(certificate).expect("a certificate is written");
    let shown: Vec<&str> = README.lines().filter(|line| line.starts_with("{\"claim\"")).collect();
    assert!(!shown.is_empty(), "the README shows no certificate");
    for line in shown {
        assert!(certificate.contains(line), "{line} is not what is written:\n{certificate}");
    }
}

#[test]
fn the_shown_family_is_as_declared() {
    let family = README
        .split("```text\n")
        .find_map(|block| block.split("```").next().filter(|b| b.contains("family Quartic")));
    let run = Folder::with("shown.basis", family.expect("the README shows a family"))
        .run(&["check", "shown.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
}

#[test]
fn every_shipped_spec_is_as_declared() {
    let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
    let run = Folder::new().run(&["check", specs.to_str().expect("the path is UTF-8")]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
}

/// `BASIS_TESTS=overwrite cargo test -p basis-cli --test readme` writes the table of today into the README.
#[test]
fn the_table_of_families_is_current() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files: Vec<String> = std::fs::read_dir(root.join("specs"))
        .expect("the library can be read")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "basis"))
        .filter_map(|path| Some(format!("specs/{}", path.file_name()?.to_str()?)))
        .collect();
    files.sort();
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_basis"))
        .current_dir(&root)
        .arg("table")
        .args(&files)
        .output()
        .expect("the command runs");
    assert_eq!((run.status.code(), run.stderr.as_slice()), (Some(0), b"".as_slice()));
    let table = String::from_utf8(run.stdout).expect("the table is UTF-8");
    let (start, end) = ("<!-- basis table specs/*.basis -->\n", "<!-- end of the table -->");
    let (before, rest) = README.split_once(start).expect("the README has a table");
    let (shown, after) = rest.split_once(end).expect("the table ends");
    if std::env::var_os("BASIS_TESTS").is_some_and(|mode| mode == "overwrite") {
        let text = format!("{before}{start}{table}{end}{after}");
        std::fs::write(root.join("README.md"), text).expect("the README can be written");
    } else {
        assert_eq!(shown, table, "BASIS_TESTS=overwrite cargo test -p basis-cli --test readme");
    }
}
