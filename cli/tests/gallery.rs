//! `basis gallery` draws figures, and says what was measured in them.

mod support;

use serde_json::Value;
use support::Folder;

#[test]
fn figures_page_and_facts() {
    let folder = Folder::new();
    let run = folder.run(&["gallery", "out", "--only", "quad-ex2-repaired-g1"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("[ 1/2] The vase, repaired to G1: the generatrix"), "{}", run.stderr);
    assert!(run.stdout.contains("2 figures"), "{}", run.stdout);

    let read = |name: &str| std::fs::read(folder.path().join("out").join(name)).unwrap();
    let figures: Vec<Value> = serde_json::from_slice(&read("figures.json")).unwrap();
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
    let folder = Folder::new();
    folder.write("taken", "a file");
    let run = folder.run(&["gallery", "taken", "--only", "none"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot make the folder `taken`"), "{}", run.stderr);
}
