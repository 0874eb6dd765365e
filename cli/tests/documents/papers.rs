//! `specs/papers`: every published claim is as declared, none is missing, and the table in the documentation is
//! current.
//!
//! `BASIS_TESTS=overwrite cargo test -p basis-cli --test documents papers` writes the table of today; read the difference before
//! you keep it.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::LazyLock;

use crate::support::Folder;
use serde_json::Value;

const PAPERS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/papers");

/// The claims of the papers on one basis, by their identifiers.
const CLAIMS: [&str; 64] = [
    "quad-PU",
    "quad-NN",
    "quad-L1",
    "quad-L2",
    "quad-P1",
    "quad-P2",
    "quad-P3",
    "quad-P5",
    "quad-T1",
    "quad-eq7",
    "quad-eq8",
    "quad-T2",
    "quad-T3",
    "quad-ex1",
    "quad-ex2",
    "quart-PU",
    "quart-NN",
    "quart-SYM",
    "quart-RED",
    "quart-LI",
    "quart-P1",
    "quart-P2",
    "quart-P3",
    "quart-P4",
    "quart-P5",
    "quart-eq2",
    "quart-eq8",
    "quart-T1",
    "quart-T2",
    "quart-T3",
    "quart-T4",
    "quart-T5",
    "quart-T6",
    "quart-eq11",
    "quart-eq18",
    "quart-steps",
    "quart-adj",
    "tri-P1.1",
    "tri-P1.2",
    "tri-P1.3",
    "tri-P1.4",
    "tri-P1.5",
    "tri-P2.4",
    "tri-P2.5",
    "tri-P2.6",
    "tri-P3",
    "tri-L1",
    "tri-P4",
    "tri-P5",
    "tri-C1",
    "tri-6.1",
    "tri-Tab1",
    "rev-T1",
    "rev-def2",
    "rev-eq16",
    "rev-eq15",
    "rev-circ",
    "rev-angle",
    "rev-P1",
    "rev-P2",
    "rev-P3",
    "rev-P4",
    "rev-eq18",
    "rev-eq22",
];

/// What the command prints; it runs once.
fn report() -> &'static Value {
    static REPORT: LazyLock<Value> = LazyLock::new(run);
    &REPORT
}

fn run() -> Value {
    let output = Folder::new().command(&["check", "--format", "json", PAPERS]).output().expect("it runs");
    let report: Value = serde_json::from_slice(&output.stdout).expect("it prints JSON");
    assert_eq!(report["ok"], Value::Bool(true), "{}", report["files"]);
    report
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

#[test]
fn no_claim_is_missing() {
    let report = report();
    let published = report["published"].as_array().expect("there are statements");
    for id in CLAIMS {
        assert!(published.iter().any(|p| text(&p["id"]) == id), "{id} is missing");
    }
}

#[test]
fn what_is_refuted_has_a_correction_that_is_proved() {
    for statement in report()["published"].as_array().expect("there are statements") {
        match text(&statement["verdict"]) {
            "proved" => assert!(statement.get("corrected").is_none(), "{statement}"),
            "refuted" => assert_eq!(text(&statement["corrected"]["verdict"]), "proved", "{statement}"),
            other => {
                assert_eq!(other, "not_expressed", "{statement}");
                assert!(!text(&statement["reason"]).is_empty(), "{statement}");
            }
        }
    }
}

#[test]
fn the_table_in_the_documentation_is_current() {
    let mut page = String::from(
        "# Published claims\n\n\
        Every claim of five papers on curves and surfaces with shape parameters: what is published, whether it is true, and what is true\n\
        instead. Each stands under its identifier in one of the specs of this folder, with the derivation of the correction beside it.\n\
        `basis check specs/papers` proves and refutes them all, and prints this table.\n",
    );
    let report = report();
    let title = |prefix: &str| match prefix {
        "quad" => "Quadratic Bézier curves with one shape parameter (`quadratic.basis`)",
        "quart" => "Quartic generalized Bézier surfaces and their joins (`quartic.basis`)",
        "spl" => "Splicing of B-spline surfaces (`bspline.basis`)",
        "tri" => "Triangular quasi-Bézier surfaces (`triangular.basis`)",
        _ => "Surfaces of revolution from quartic generatrices (`revolution.basis`)",
    };
    let mut last = "";
    for statement in report["published"].as_array().expect("there are statements") {
        let id = text(&statement["id"]);
        let prefix = id.split('-').next().unwrap_or_default();
        if prefix != last {
            let header = "| claim | as published | verdict | corrected |\n| --- | --- | --- | --- |";
            write!(page, "\n## {}\n\n{header}\n", title(prefix)).expect("a string takes everything");
            last = prefix;
        }
        let remark = [&statement["corrected"]["statement"], &statement["reason"]];
        let remark: String = remark.into_iter().map(text).collect();
        let verdict = text(&statement["verdict"]).replace('_', " ");
        let cell = |text: &str| text.replace('|', "\\|");
        let (published, remark) = (cell(text(&statement["statement"])), cell(&remark));
        writeln!(page, "| {id} | {published} | {verdict} | {remark} |").expect("a string takes everything");
    }
    let path = Path::new(PAPERS).join("README.md");
    if std::env::var_os("BASIS_TESTS").is_some_and(|v| v == "overwrite") {
        std::fs::write(&path, &page).expect("the file can be written");
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(written, page, "the table is old: run this test with BASIS_TESTS=overwrite");
}
