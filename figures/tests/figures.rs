//! Figures are drawn, and the page and `figures.json` say what was measured in them.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

fn draw(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_basis-figures"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the command starts")
}

#[test]
fn figures_page_and_facts() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let run = draw(folder.path(), &["out", "--only", "quad-ex2-repaired-g1"]);
    let said = String::from_utf8(run.stderr).expect("the messages are UTF-8");
    assert_eq!(run.status.code(), Some(0), "{said}");
    assert!(said.contains("[ 1/2] The vase, repaired to G1: the generatrix"), "{said}");
    assert!(said.contains("2 figures"), "{said}");

    let read = |name: &str| std::fs::read(folder.path().join("out").join(name)).expect("the file is there");
    let figures: Vec<Value> = serde_json::from_slice(&read("figures.json")).expect("the file is JSON");
    assert_eq!(figures.len(), 2);
    for figure in &figures {
        for key in ["id", "paper", "title", "file", "params", "facts"] {
            assert!(!figure[key].is_null(), "{key} in {figure}");
        }
        assert_eq!(figure["paper"], "quadratic");
        assert_eq!(figure["facts"]["measured"][0], "G1");
        assert!(figure["facts"]["angles in degrees"][0].as_f64().unwrap() < 1e-9);
        let file = figure["file"].as_str().unwrap();
        let bytes = read(file);
        if figure["id"].as_str().unwrap().ends_with("generatrix") {
            let text = String::from_utf8(bytes).unwrap();
            assert!(file.contains(".svg") && text.starts_with("<svg") && text.contains("λ = 0.57"), "{text}");
        } else {
            assert!(file.contains(".png") && bytes.starts_with(b"\x89PNG"));
        }
    }
    let page = String::from_utf8(read("index.html")).unwrap();
    assert!(page.contains("quad-ex2-repaired-g1-surface.png"));
    assert!(page.contains("<td>quad-T2</td>") && page.contains("class=\"refuted\">refuted"));
}

#[test]
fn folders_that_cannot_be_made() {
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    std::fs::write(folder.path().join("taken"), "a file").expect("a file can be written");
    let run = draw(folder.path(), &["taken", "--only", "none"]);
    let said = String::from_utf8(run.stderr).expect("the messages are UTF-8");
    assert_eq!(run.status.code(), Some(2));
    assert!(said.contains("error: cannot make the folder `taken`"), "{said}");
}
