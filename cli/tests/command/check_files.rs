//! `basis check`: which files a path stands for, and files that cannot be read.

use crate::support::{Folder, QUARTIC};
use serde_json::{Value, json};

const FINE: &str = "family F { domain 0 <= t <= 1; b[0] = 1; prove partition_of_unity; }";
const WRONG: &str = "family F { domain 0 <= t <= 1; b[0] = t; prove partition_of_unity; }";

fn paths(report: &Value) -> Vec<String> {
    let files = report["files"].as_array().expect("a list of files");
    files.iter().map(|f| f["path"].as_str().expect("a path").replace('\\', "/")).collect()
}

#[test]
fn folders_are_searched_and_sorted() {
    let folder = Folder::with("specs/b.basis", FINE)
        .and("specs/a.basis", FINE)
        .and("specs/papers/deep/c.basis", QUARTIC)
        .and("specs/papers.basis", FINE)
        .and("specs/notes.txt", "not a spec")
        .and("specs/basis", "not a spec")
        .and("other.basis", FINE);
    let (code, report) = folder.check_json(&["specs"]);
    assert_eq!(code, 0);
    let sorted = ["specs/a.basis", "specs/b.basis", "specs/papers/deep/c.basis", "specs/papers.basis"];
    assert_eq!(paths(&report), sorted);
    // Files and folders in the order of the arguments, each file once, as it is written.
    let (code, report) = folder.check_json(&[
        "other.basis",
        "specs/papers.basis",
        "specs/papers/",
        "./specs/b.basis",
        "other.basis",
    ]);
    assert_eq!(code, 0);
    assert_eq!(
        paths(&report),
        ["other.basis", "specs/papers.basis", "specs/papers/deep/c.basis", "./specs/b.basis"]
    );
}

#[test]
fn a_file_may_have_any_name() {
    let (code, report) = Folder::with("spec.txt", FINE).check_json(&["spec.txt"]);
    assert_eq!((code, paths(&report)), (0, vec![String::from("spec.txt")]));
}

#[cfg(unix)]
#[test]
fn links_may_form_loops() {
    use std::os::unix::fs::symlink;
    let folder = Folder::with("specs/a/one.basis", FINE).and("elsewhere/two.basis", FINE);
    let root = folder.path().join("specs");
    symlink("..", root.join("a/up")).expect("a link");
    symlink("a", root.join("0-first")).expect("a link");
    symlink("../elsewhere", root.join("linked")).expect("a link");
    symlink("../../elsewhere/two.basis", root.join("a/link.basis")).expect("a link");
    let (code, report) = folder.check_json(&["specs"]);
    assert_eq!(code, 0);
    assert_eq!(paths(&report), ["specs/a/link.basis", "specs/a/one.basis", "specs/linked/two.basis"]);
}

#[test]
fn what_cannot_be_read_is_2() {
    let folder = Folder::with("fine.basis", FINE)
        .and("wrong.basis", WRONG)
        .and("latin1.basis", b"// Bernstein\n// \xe9")
        .and("empty/readme.txt", "");
    for (path, message) in [
        ("missing.basis", "there is no spec file `missing.basis`"),
        ("latin1.basis", "`latin1.basis` is not UTF-8: invalid byte 0xe9 in line 2"),
        ("empty", "there is no spec in the folder `empty`"),
        ("fine.basis/deeper", "fine.basis/deeper"),
    ] {
        let (code, report) = folder.check_json(&["wrong.basis", path, "fine.basis"]);
        assert_eq!(code, 2, "{path}");
        assert_eq!(report["ok"], json!(false));
        assert_eq!(paths(&report), ["wrong.basis", path, "fine.basis"]);
        let file = &report["files"][1];
        assert_eq!(file["items"], json!([]));
        let diagnostic = &file["diagnostics"][0];
        assert!(diagnostic["message"].as_str().is_some_and(|m| m.contains(message)), "{diagnostic}");
        assert_eq!((&diagnostic["line"], &diagnostic["column"]), (&Value::Null, &Value::Null));

        let run = folder.run(&["check", path]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""));
        assert!(run.stderr.starts_with("error: ") && run.stderr.contains(message), "{}", run.stderr);
    }
}

#[test]
fn the_nearest_file_is_proposed() {
    let folder = Folder::with("specs/quartic.basis", FINE);
    for path in ["specs/quartic", "specs/qartic.basis"] {
        let run = folder.run(&["check", path]);
        assert!(
            run.stderr.replace('\\', "/").contains("did you mean `specs/quartic.basis`?"),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn an_empty_spec_is_an_error_of_the_spec() {
    let folder = Folder::with("empty.basis", "").and("comment.basis", "// later\n");
    for path in ["empty.basis", "comment.basis"] {
        let (code, report) = folder.check_json(&[path]);
        assert_eq!(code, 1, "{report}");
    }
}

#[test]
fn line_ends_and_byte_order_marks_of_other_systems() {
    let text = format!("\u{feff}{}", WRONG.replace("; ", ";\r\n"));
    let (code, report) = Folder::with("f.basis", &text).check_json(&["f.basis"]);
    assert_eq!(code, 1);
    assert_eq!(report["files"][0]["items"][0]["claims"][0]["line"], json!(3));
    assert_eq!(report["files"][0]["diagnostics"][0]["line"], json!(3));
    assert_eq!(report["files"][0]["diagnostics"][0]["column"], json!(1));
}
