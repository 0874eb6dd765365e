//! What the README shows is what the command prints; the shipped specs are as declared.

use std::path::Path;

use crate::support::Folder;

const README: &str = include_str!("../../../README.md");

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
