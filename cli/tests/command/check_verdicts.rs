//! `basis check`: exit status and JSON.

use crate::support::{BERNSTEIN, Folder, QUARTIC};
use serde_json::{Value, json};

/// The claims of an item, without what differs from run to run.
fn claims(item: &Value) -> Vec<Value> {
    let claims = item["claims"].as_array().expect("a list of claims");
    claims
        .iter()
        .map(|claim| {
            let mut claim = claim.clone();
            let micros = claim.as_object_mut().and_then(|c| c.remove("micros")).expect("a time");
            assert!(micros.is_u64());
            if claim["verdict"] == "proved" {
                let method = claim.as_object_mut().and_then(|c| c.remove("method"));
                assert!(method.is_some_and(|m| m.as_str().is_some_and(|m| m.starts_with("expansion of "))));
            }
            claim
        })
        .collect()
}

#[test]
fn everything_as_declared() {
    let (code, report) = Folder::with("quartic.basis", QUARTIC).check_json(&["quartic.basis"]);
    assert_eq!(code, 0);
    assert_eq!(report["ok"], json!(true));
    let keys: Vec<&String> = report.as_object().expect("an object").keys().collect();
    assert_eq!(keys, ["files", "ok"]);
    let file = &report["files"][0];
    assert_eq!(file["path"], json!("quartic.basis"));
    assert_eq!(file["diagnostics"], json!([]));
    assert_eq!(file["items"].as_array().map(Vec::len), Some(1));
    let item = &file["items"][0];
    assert_eq!(item["kind"], json!("family"));
    assert_eq!(item["name"], json!("QuarticBernstein"));
    assert_eq!(item["order"], Value::Null);
    let proved = |claim: &str, line: u32| json!({"claim": claim, "line": line, "declared": "prove", "verdict": "proved", "witness": null});
    let claims = claims(item);
    assert_eq!(claims[0], proved("partition_of_unity", 11));
    assert_eq!(claims[1], proved("symmetric", 12));
    assert_eq!(claims[2], proved("at t = 0: b = [1, 0, 0, 0]", 13));
    assert_eq!(claims[3], proved("at t = 0: D(b) = [-(3 + λ), 3 + λ, 0, 0]", 13));
    assert_eq!(claims[4], proved("at λ = 0: b = Bernstein(3)", 14));
    let refuted = &claims[5];
    assert_eq!(refuted["claim"], json!("b[0] = b[1]"));
    assert_eq!(refuted["declared"], json!("refute"));
    assert_eq!(refuted["verdict"], json!("refuted"));
    assert_eq!(refuted["method"], json!("counterexample"));
    assert_eq!(refuted["witness"]["of"], json!("b[0] - b[1]"));
    assert_eq!(claims.len(), 6);
}

#[test]
fn a_false_claim_comes_with_its_point() {
    let spec = "family F { domain 0 <= t <= 1; shape -3 <= λ <= 1;
    b[0] = 1 - t; b[1] = t + λ*t^2;
    prove partition_of_unity; }";
    let (code, report) = Folder::with("f.basis", spec).check_json(&["f.basis"]);
    assert_eq!(code, 1);
    assert_eq!(report["ok"], json!(false));
    let claim = &report["files"][0]["items"][0]["claims"][0];
    assert_eq!(claim["verdict"], json!("refuted"));
    assert_eq!(claim["declared"], json!("prove"));
    assert_eq!(claim["line"], json!(3));
    assert_eq!(
        claim["witness"],
        json!({"at": {"λ": "1", "t": "1/2"}, "value": "1/4", "of": "b[0] + b[1] - 1"})
    );
    let diagnostic = &report["files"][0]["diagnostics"][0];
    assert_eq!(diagnostic["severity"], json!("error"));
    assert_eq!((&diagnostic["line"], &diagnostic["column"]), (&json!(3), &json!(5)));
    let message = diagnostic["message"].as_str().expect("a text");
    assert!(message.contains("the claim `partition_of_unity` is false"), "{message}");
    assert!(message.contains("1 + λ*t^2") && message.contains("5/4"), "{message}");
    assert_eq!(diagnostic.get("path"), None);
}

#[test]
fn a_true_claim_must_not_be_declared_false() {
    let spec = "family F { domain 0 <= t <= 1; b[0] = 1;\n refute partition_of_unity; }";
    let (code, report) = Folder::with("f.basis", spec).check_json(&["f.basis"]);
    assert_eq!(code, 1);
    let file = &report["files"][0];
    assert_eq!(file["items"][0]["claims"][0]["verdict"], json!("proved"));
    assert_eq!(file["diagnostics"].as_array().map(Vec::len), Some(1));
}

#[test]
fn every_order_is_an_item() {
    let (code, report) = Folder::with("b.basis", BERNSTEIN).check_json(&["b.basis"]);
    assert_eq!(code, 0);
    let items = report["files"][0]["items"].as_array().expect("a list");
    assert_eq!(items.len(), 12);
    for (n, item) in (1_usize..).zip(items) {
        assert_eq!(item["name"], json!("Bern"));
        assert_eq!(item["order"], json!({"n": n}));
        // The sum, the symmetry, one reduction for each function, the derivative.
        assert_eq!(item["claims"].as_array().map(Vec::len), Some(n + 4));
    }
    assert_eq!(items[2]["claims"][5]["claim"], json!("b[3] = Bernstein(3)[3]"));
    assert_eq!(items[2]["claims"][6]["claim"], json!("at t = 0: D(b[0]) = -3"));
}

#[test]
fn a_spec_with_errors_is_not_as_declared() {
    let spec = "family F {\n    domain 0 <= t <= 1;\n    b[0] = x;\n}\n";
    let (code, report) = Folder::with("f.basis", spec).check_json(&["f.basis"]);
    assert_eq!(code, 1);
    let file = &report["files"][0];
    assert_eq!(file["items"], json!([]));
    let diagnostic = &file["diagnostics"][0];
    assert_eq!((&diagnostic["line"], &diagnostic["column"]), (&json!(3), &json!(12)));
}

#[test]
fn an_error_in_a_used_file_names_that_file() {
    let folder =
        Folder::with("main.basis", "use \"sub/other.basis\";\nfamily F { domain 0 <= t <= 1; b[0] = G[0]; }")
            .and("sub/other.basis", "\n\nfamily G { domain 0 <= t <= 1; b[0] = y; }");
    let (code, report) = folder.check_json(&["main.basis"]);
    assert_eq!(code, 1);
    let diagnostic = &report["files"][0]["diagnostics"][0];
    assert_eq!(diagnostic["line"], json!(3));
    let path = diagnostic["path"].as_str().expect("a path").replace('\\', "/");
    assert_eq!(path, "sub/other.basis");
    let run = folder.run(&["check", "main.basis"]);
    assert!(run.stderr.replace('\\', "/").contains("--> sub/other.basis:3:39"), "{}", run.stderr);
}

#[test]
fn only_the_families_of_the_file_itself_are_listed() {
    let folder = Folder::with(
        "main.basis",
        "use \"quartic.basis\";\nfamily F { domain 0 <= t <= 1; b[0] = 1; prove partition_of_unity; }",
    )
    .and("quartic.basis", QUARTIC);
    let (code, report) = folder.check_json(&["main.basis"]);
    assert_eq!(code, 0);
    let items = report["files"][0]["items"].as_array().expect("a list");
    assert_eq!(items.len(), 1);
    assert_eq!(items[0]["name"], json!("F"));
}

#[test]
fn wrong_usage_is_2() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    for arguments in [
        &[] as &[&str],
        &["chek"],
        &["check"],
        &["check", "--format", "yaml", "quartic.basis"],
        &["check", "--wrong"],
    ] {
        let run = folder.run(arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        assert_eq!(run.stdout, "", "{arguments:?}");
        assert_ne!(run.stderr, "", "{arguments:?}");
    }
}

#[test]
fn help_and_version() {
    let folder = Folder::new();
    for arguments in [&["--help"] as &[&str], &["check", "--help"], &["eval", "--help"], &["help", "check"]] {
        let run = folder.run(arguments);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{arguments:?}");
        assert!(run.stdout.contains("Examples:"), "{arguments:?}");
    }
    let run = folder.run(&["--version"]);
    assert_eq!(run.stdout, format!("basis {}\n", env!("CARGO_PKG_VERSION")));
}
