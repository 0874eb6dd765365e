//! `basis check --certificates` and `basis verify` at a terminal.

use crate::support::{BERNSTEIN, Folder, QUARTIC};
use serde_json::{Value, json};

#[test]
fn certificates_are_written_and_verified() {
    let folder = Folder::with("sub/quartic.basis", QUARTIC).and("b.basis", BERNSTEIN);
    let run = folder.run(&["check", "--certificates", "proofs", "b.basis", "sub"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for file in ["proofs/sub/quartic/QuarticBernstein.json", "proofs/b/Bern-1.json", "proofs/b/Bern-12.json"]
    {
        assert!(folder.path().join(file).is_file(), "{file}");
    }
    let run = folder.run(&["verify", "proofs"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout.contains("13 certificates, ") && run.stdout.contains(": all verified; "),
        "{}",
        run.stdout
    );
    let run = folder.run(&["verify", "--format", "json", "proofs"]);
    assert_eq!(run.code, 0);
    let report = run.json();
    assert_eq!((&report["ok"], &report["missing"]), (&json!(true), &json!([])));
    assert_eq!(report["certificates"].as_array().map(Vec::len), Some(13));
    // Once more gives the same files.
    let file = folder.path().join("proofs/b/Bern-3.json");
    let before = std::fs::read(&file).expect("a file");
    folder.run(&["check", "--format", "json", "--certificates", "proofs", "b.basis"]);
    assert_eq!(std::fs::read(&file).expect("a file"), before);
    // From elsewhere the specs are found around the certificates.
    let elsewhere = Folder::new();
    let path = folder.path().join("proofs");
    assert_eq!(elsewhere.run(&["verify", path.to_str().expect("Unicode")]).code, 0);
}

#[test]
fn another_spec_is_noticed() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "quartic.basis"]).code, 0);
    for (from, to) in [
        ("(1 - λ*t) * (1 - t)^3", "(1 - λ*t) * (1 - t)^4"),
        ("prove symmetric;", ""),
        ("refute b[0] = b[1]", "refute b[0] = b[2]"),
        ("/// λ", "\n/// λ"),
    ] {
        let folder = folder.write("quartic.basis", &QUARTIC.replace(from, to));
        let run = folder.run(&["verify", "proofs"]);
        assert_eq!(run.code, 1, "{from} → {to}: {}", run.stdout);
        assert!(run.stdout.contains("✗"), "{}", run.stdout);
    }
    // Where all claims are as true as before, the proofs are as good.
    let folder = folder.write("quartic.basis", &QUARTIC.replace("-3 <= λ <= 1", "-3 <= λ <= 2"));
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
    // A comment changes nothing but lines.
    let folder = folder.write(
        "quartic.basis",
        &QUARTIC.replace("    prove symmetric;", "    prove symmetric; // as in the paper"),
    );
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
}

#[test]
fn what_is_missing_or_unreadable() {
    let folder = Folder::with("b.basis", BERNSTEIN);
    assert_eq!(folder.run(&["verify", "proofs"]).code, 2);
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "b.basis"]).code, 0);
    let file = folder.path().join("proofs/b/Bern-3.json");
    let text = std::fs::read_to_string(&file).expect("a file");
    std::fs::remove_file(&file).expect("a file");
    let run = folder.run(&["verify", "--format", "json", "proofs"]);
    assert_eq!((run.code, &run.json()["missing"]), (1, &json!(["b.basis: Bern(3)"])));
    for broken in ["", "{", "[]", "{}", "null", "{\"spec\": \"b.basis\"}", &text[..text.len() / 2]] {
        std::fs::write(&file, broken).expect("a file");
        let run = folder.run(&["verify", "proofs"]);
        assert_ne!(run.code, 0, "{broken}");
        assert!(run.stdout.contains("Bern-3.json"), "{}", run.stdout);
    }
    std::fs::write(&file, text.replace("b.basis", "c.basis")).expect("a file");
    assert_eq!(folder.run(&["verify", "proofs"]).code, 2);
    // A verdict that is not as declared is written, and rejected.
    let folder =
        Folder::with("f.basis", "family F { domain 0 <= t <= 1; b[0] = t; prove partition_of_unity; }");
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "f.basis"]).code, 1);
    let run = folder.run(&["verify", "proofs"]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("contradicts"), "{}", run.stdout);
    // A file where the folder should be.
    let run = folder.run(&["check", "--certificates", "f.basis", "f.basis"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot write the certificate"), "{}", run.stderr);
}

#[test]
fn errors_in_claims_are_said_once() {
    let family = |name: &str, claim: &str| {
        format!("family {name} {{ domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; prove {claim}; }}\n")
    };
    let folder = Folder::with("f.basis", &[family("A", "b[1] >= 0"), family("B", "nonnegative")].concat());
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "f.basis"]).code, 0);
    folder.write("f.basis", &[family("A", "b[7] >= 0"), family("B", "nonnegative")].concat());
    let run = folder.run(&["verify", "proofs"]);
    assert_eq!(run.code, 2);
    let said = "the spec `f.basis` has errors: line 1: there is no function `b[7]`";
    assert_eq!(run.stdout.matches(said).count(), 1, "{}", run.stdout);
    assert!(!run.stdout.contains("its claims are not those"), "{}", run.stdout);
}

#[test]
fn a_spec_without_any_certificate_is_noticed() {
    let folder = Folder::with("specs/quartic.basis", QUARTIC).and("specs/b.basis", BERNSTEIN);
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "specs"]).code, 0);
    let of_quartic = folder.path().join("proofs/specs/quartic");
    std::fs::remove_dir_all(&of_quartic).expect("a folder");
    let run = folder.run(&["verify", "proofs"]);
    assert_eq!(run.code, 1);
    let missing = "✗ specs/quartic.basis: QuarticBernstein: there is no certificate";
    assert!(run.stdout.contains(missing), "{}", run.stdout);
    // Taken off the list as well, it is missed in the folder that was checked.
    let list = folder.path().join("proofs/manifest.json");
    let manifest: Value = serde_json::from_slice(&std::fs::read(&list).expect("a file")).expect("JSON");
    let mut less = manifest.clone();
    less["specs"].as_object_mut().expect("an object").remove("specs/quartic.basis");
    std::fs::write(&list, less.to_string()).expect("a file");
    let run = folder.run(&["verify", "--format", "json", "proofs"]);
    let lacks = json!(["specs/quartic.basis: no certificates were written for it"]);
    assert_eq!((run.code, &run.json()["manifest"]), (1, &lacks));
    // With that changed too, it is missed when the command names the specs that must have certificates.
    less["paths"] = json!(["specs/b.basis"]);
    std::fs::write(&list, less.to_string()).expect("a file");
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
    assert_eq!(folder.run(&["verify", "proofs", "specs/b.basis"]).code, 0);
    for path in ["specs", "specs/quartic.basis"] {
        let run = folder.run(&["verify", "--format", "json", "proofs", path]);
        assert_eq!((run.code, &run.json()["manifest"]), (1, &lacks), "{path}");
    }
}

#[test]
fn the_list_of_the_specs_is_checked() {
    let folder = Folder::with("a.basis", QUARTIC).and("b.basis", BERNSTEIN);
    // In two runs: the second keeps what the first has listed.
    for spec in ["a.basis", "b.basis"] {
        assert_eq!(folder.run(&["check", "--certificates", "proofs", spec]).code, 0);
    }
    let list = folder.path().join("proofs/manifest.json");
    let text = std::fs::read_to_string(&list).expect("a file");
    let manifest: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(manifest["paths"], json!(["a.basis", "b.basis"]));
    assert_eq!(manifest["specs"]["a.basis"], json!({"QuarticBernstein": 6}));
    assert_eq!(manifest["specs"]["b.basis"].as_object().map(serde_json::Map::len), Some(12));
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
    for (from, to) in [
        ("\"format\": \"basis", "\"format\": \"basic"),
        ("\"QuarticBernstein\": 6", "\"QuarticBernstein\": 7"),
        ("\"QuarticBernstein\": 6", "\"Quartic\": 6"),
        ("\"QuarticBernstein\": 6", ""),
        ("\"Bern(3)\"", "\"Bern(33)\""),
        ("\"a.basis\",", ""),
        ("\"a.basis\": {", "\"c.basis\": {"),
        ("\"paths\"", "\"path\""),
        ("{\n  \"format\"", "{\n  \"more\": 1,\n  \"format\""),
        ("{", "["),
    ] {
        assert!(text.contains(from), "{from}");
        std::fs::write(&list, text.replacen(from, to, 1)).expect("a file");
        let run = folder.run(&["verify", "proofs"]);
        assert_eq!(run.code, 1, "{from} → {to}: {}", run.stdout);
        assert!(run.stdout.contains("the list of the specs"), "{}", run.stdout);
    }
    std::fs::remove_file(&list).expect("a file");
    assert_eq!(folder.run(&["verify", "proofs"]).code, 1);
}

#[test]
fn irrational_witnesses() {
    let spec = "family F { domain 0 <= t <= 2; b[0] = t;\n refute (t^2 - 2)^2 > 0; prove (t^2 - 2)^2 >= 0; }";
    let folder = Folder::with("f.basis", spec);
    let (code, report) = folder.check_json(&["f.basis"]);
    assert_eq!(code, 0);
    let witness = &report["files"][0]["items"][0]["claims"][0]["witness"];
    assert_eq!(
        *witness,
        json!({"at": {"t": "root of -2 + t^2 between 1.414 and 1.415"}, "value": "0", "of": "(t^2 - 2)^2"})
    );
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "f.basis"]).code, 0);
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
    let file = folder.path().join("proofs/f/F.json");
    let mut value: Value = serde_json::from_slice(&std::fs::read(&file).expect("a file")).expect("JSON");
    assert_eq!(value["claims"][0]["witness"], "(at (root (-2 0 1) 707/500 283/200) (x0 (0 1)))");
    value["claims"][0]["witness"] = json!("(at (root (-3 0 1) 433/250 1733/1000) (x0 (0 1)))");
    std::fs::write(&file, value.to_string()).expect("a file");
    let run = folder.run(&["verify", "proofs"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
}

#[test]
fn irrational_points_of_a_simplex() {
    let spec = "family T { domain triangle (u, v, w); b[0] = u;
        refute (u^2 - 1/2)^2 > 0;
        refute (w^2 - 1/2)^2 > 0;
        refute at w = 0 { (u^2 - 1/2)^2 > 0; }
        prove (u^2 - 1/2)^2 >= 0; }";
    let folder = Folder::with("t.basis", spec);
    let (code, report) = folder.check_json(&["t.basis"]);
    assert_eq!(code, 0);
    let claims = &report["files"][0]["items"][0]["claims"];
    let u = "root of -1 + 2*u^2 between 0.707 and 0.708";
    let half = |name: &str| format!("root of 1 - 8*{name} + 8*{name}^2 between 0.146446 and 0.146447");
    assert_eq!(claims[0]["witness"]["at"], json!({"u": u, "v": half("v"), "w": half("w")}));
    let v = "root of 1 - 4*v + 2*v^2 between 0.292 and 0.293";
    assert_eq!(claims[2]["witness"]["at"], json!({"u": u, "v": v, "w": "0"}));
    assert_eq!(folder.run(&["check", "--certificates", "proofs", "t.basis"]).code, 0);
    assert_eq!(folder.run(&["verify", "proofs"]).code, 0);
    let file = folder.path().join("proofs/t/T.json");
    let text = std::fs::read_to_string(&file).expect("a file");
    for (from, to) in [("(-1 0 2)", "(-1 0 3)"), ("(x0 (1 -1))", "(x0 (0 1))"), ("(x0 (1 -1))", "(x0 1/2)")] {
        assert!(text.contains(from), "{text}");
        std::fs::write(&file, text.replace(from, to)).expect("a file");
        assert_eq!(folder.run(&["verify", "proofs"]).code, 1, "{from} → {to}");
    }
}
