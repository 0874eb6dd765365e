//! `basis lsp`, as an editor drives it.

use crate::editor::{Editor, apply, position, slice};
use crate::support::{Folder, QUARTIC};
use serde_json::json;

#[test]
fn verdicts_follow_every_edit() {
    let spec = QUARTIC.replace("    prove symmetric", "    prove nonnegative;\n    prove symmetric");
    let mut editor = Editor::showing(Folder::new(), "q.basis", &spec);
    assert!(editor.errors(1).is_empty());
    let wider = spec.replace("-3 <= λ", "-4 <= λ");
    // The newest of several versions is the one that counts.
    for version in 2..20 {
        editor.edit("q.basis", version, &spec.replace("-3 <= λ", "-5 <= λ"));
    }
    editor.edit("q.basis", 20, &wider);
    let errors = editor.errors(20);
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert_eq!(slice(&wider, &errors[0]["range"]), "prove nonnegative;");
    let message = errors[0]["message"].as_str().expect("it is a text");
    assert!(message.contains("`b[1]` is -16/625 at λ = -4, t = 1/5"), "{message}");
    // Columns are UTF-16 units: behind a letter outside of the first plane as well.
    let strange = spec.replace("b[3] = (1 - λ", "/* 𝔸λ */ b[3] = (1 - ν");
    editor.edit("q.basis", 21, &strange);
    let errors = editor.errors(21);
    assert_eq!(slice(&strange, &errors[0]["range"]), "ν", "{errors:?}");
    editor.close();
}

#[test]
fn every_claim_has_a_mark() {
    let spec = "family F(n in 1..=3) {
    domain 0 <= t <= 1;
    b[0] = 1 - t;
    b[1] = t;
    prove partition_of_unity;
    refute b[1] = 0;
    prove at t = 1 { b[1] = 1; D(b[1]) = n; }
}
";
    let mut editor = Editor::showing(Folder::new(), "f.basis", spec);
    let whole = json!({ "start": position(spec, 0), "end": position(spec, spec.len()) });
    let params = json!({ "textDocument": { "uri": editor.uri("f.basis") }, "range": whole });
    let hints = editor.ask("textDocument/inlayHint", params);
    let hints: Vec<(&str, u64)> = hints
        .as_array()
        .expect("they are a list")
        .iter()
        .map(|h| (h["label"].as_str().expect("text").trim(), h["position"]["line"].as_u64().expect("number")))
        .collect();
    assert_eq!(
        hints,
        [
            ("✓", 4),
            ("✗ b[1] differs from 0 by t; at t = 1/2 the difference is 1/2", 5),
            ("✓", 6),
            ("✓ n = 1  ✗ n = 2, 3", 6),
        ]
    );
    let text = editor.hover("f.basis", spec, "partition", 2);
    assert!(text.contains("the functions sum to 1") && text.contains("**proved**"), "{text}");
    editor.close();
}

#[test]
fn a_pointer_shows_formulas_and_ranges() {
    let mut editor = Editor::showing(Folder::new(), "q.basis", QUARTIC);
    let mut hover = |mark: &str| editor.hover("q.basis", QUARTIC, mark, 0);
    let function = hover("b[1]");
    for part in [
        "b[1] = (3 + λ - λ*t)*t*(1 - t)^2",
        "Bernstein coefficients of degree 4: `0, ",
        "b_{1} = \\left(3 + \\lambda",
    ] {
        assert!(function.contains(part), "{part}: {function}");
    }
    assert!(!function.contains("b[2]"));
    let shape = hover("λ <= 1");
    for part in ["`-3 <= λ <= 1`", "nonnegative for `-3 <= λ <= 1`", "dependent at `λ = -3: b[1] - b[2] = 0`"]
    {
        assert!(shape.contains(part), "{part}: {shape}");
    }
    assert!(hover("QuarticBernstein").contains("4 functions of degree 4 on `0 <= t <= 1`"));
    assert!(hover("Bernstein(3)").contains("family"), "a family of the prelude");
    assert_eq!(hover("<= t"), "");
    editor.close();
}

const USER: &str = "use \"base.basis\";
use library \"quadratic\";

family Mine {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 1;
    let w = 1 + λ;
    b[i] = Base(2)[i]*w/w for i in 0..=2;
    prove b = Base(2);
    prove at λ = 0 { b = QuadraticBezier(0); }
}

join Next {
    curve P = Mine(λ1);
    curve Q = Base(2);
    let Q[0] = P[2];
    prove Q(0) == P(1);
}
";

const BASE: &str = "/// The basis.
family Base(n in 1..=4) {
    domain 0 <= t <= 1;
    b[i] = binomial(n, i)*t^i*(1 - t)^(n - i) for i in 0..=n;
}
";

#[test]
fn names_lead_to_other_files() {
    let folder =
        Folder::with("base.basis", BASE).and("user.basis", USER).and("other.basis", "family Base {}\n");
    let mut editor = Editor::showing(folder, "user.basis", USER);
    let base = editor.uri("base.basis");
    let found = editor.ask_at("textDocument/definition", "user.basis", USER, "Base(2)[", 1, json!({}));
    assert_eq!(found[0]["uri"], base);
    assert_eq!(slice(BASE, &found[0]["range"]), "Base");
    let found = editor.ask_at("textDocument/definition", "user.basis", USER, "\"base", 3, json!({}));
    assert_eq!(found[0]["uri"], base);
    let found = editor.ask_at("textDocument/definition", "user.basis", USER, "QuadraticBezier", 1, json!({}));
    let copy = found[0]["uri"].as_str().expect("a shipped spec can be shown").to_string();
    let path = copy.strip_prefix("file://").expect("it is a file");
    let shown = std::fs::read_to_string(path).expect("it is there");
    assert_eq!(slice(&shown, &found[0]["range"]), "QuadraticBezier");
    let found = editor.ask_at("textDocument/definition", "user.basis", USER, "w/w", 0, json!({}));
    assert_eq!(slice(USER, &found[0]["range"]), "w");
    // References and a new name go through all files that mean this family.
    let more = json!({ "context": { "includeDeclaration": true } });
    let all = editor.ask_at("textDocument/references", "user.basis", USER, "Base(2)[", 1, more);
    let all = all.as_array().expect("they are a list");
    assert_eq!(all.len(), 4, "{all:?}");
    assert_eq!(all.iter().filter(|l| l["uri"] == base).count(), 1);
    let edit = editor.ask_at(
        "textDocument/rename",
        "user.basis",
        USER,
        "Base(2)[",
        1,
        json!({ "newName": "Power" }),
    );
    let user = apply(USER, &edit["changes"][editor.uri("user.basis")]);
    assert!(
        user.contains("b = Power(2)") && user.contains("use \"base.basis\"") && !user.contains("Base"),
        "{user}"
    );
    assert!(apply(BASE, &edit["changes"][base]).contains("family Power(n in"));
    assert!(edit["changes"].get(editor.uri("other.basis")).is_none());
    editor.close();
}

#[test]
fn a_new_name_is_refused_where_it_means_something_else() {
    let mut editor = Editor::showing(Folder::with("base.basis", BASE), "user.basis", USER);
    let edit =
        editor.ask_at("textDocument/rename", "user.basis", USER, "λ <= 1", 0, json!({ "newName": "α" }));
    let renamed = apply(USER, &edit["changes"][editor.uri("user.basis")]);
    assert_eq!(renamed, USER.replace("λ <= 1", "α <= 1").replace("+ λ", "+ α").replace("at λ", "at α"));
    for (mark, new, why) in [
        ("λ <= 1", "w", "already a name"),
        ("λ <= 1", "for", "not a name"),
        ("λ <= 1", "2x", "not a name"),
        ("QuadraticBezier", "X", "comes with the toolchain"),
    ] {
        let params = json!({
            "textDocument": { "uri": editor.uri("user.basis") },
            "position": position(USER, USER.find(mark).expect("it is there")),
            "newName": new
        });
        let response = editor.response("textDocument/rename", params);
        let message = response["error"]["message"].as_str().unwrap_or_default();
        assert!(message.contains(why), "{mark} → {new}: {response}");
    }
    editor.close();
}

#[test]
fn words_are_suggested_where_they_fit() {
    let spec =
        "use \"base.basis\";\nfamily F {\n    domain 0 <= t <= 1;\n    b[0] = \\lam;\n    prove n\n}\n";
    let mut editor = Editor::showing(Folder::with("base.basis", BASE), "f.basis", spec);
    let claims = editor.ask_at("textDocument/completion", "f.basis", spec, "prove n", 7, json!({}));
    let labels: Vec<&str> =
        claims.as_array().expect("a list").iter().filter_map(|c| c["label"].as_str()).collect();
    for label in ["nonnegative", "Base", "Bernstein", "b"] {
        assert!(labels.contains(&label), "{label}: {labels:?}");
    }
    assert!(!labels.contains(&"domain"));
    let letters = editor.ask_at("textDocument/completion", "f.basis", spec, "\\lam", 4, json!({}));
    assert_eq!(apply(spec, &json!([letters[0]["textEdit"]])), spec.replace("\\lam", "λ"));
    editor.close();
}

#[test]
fn names_of_specs_are_suggested_and_explained() {
    let spec = "use \"b\";\nuse library \"quad\";\nuse library \"quadratic\";\nuse \"base.basis\";\n";
    let mut editor = Editor::showing(Folder::with("base.basis", BASE), "f.basis", spec);
    let mut labels = |mark: &str, after: usize| -> Vec<String> {
        let all = editor.ask_at("textDocument/completion", "f.basis", spec, mark, after, json!({}));
        let all = all.as_array().expect("a list").iter();
        all.map(|s| s["label"].as_str().expect("a name").to_string()).collect()
    };
    assert_eq!(labels("\"b\"", 2), ["base.basis"], "the spec itself is left out");
    let library = labels("\"quad\"", 5);
    assert!(library.contains(&String::from("quadratic")) && !library.contains(&String::from("base.basis")));
    let mut hover = |mark: &str| editor.hover("f.basis", spec, mark, 1);
    let quadratic = hover("\"quadratic\"");
    assert!(
        quadratic.starts_with("Quadratic Bézier curves") && quadratic.contains("family **QuadraticBezier**")
    );
    assert_eq!(hover("\"base.basis\""), "\n- family **Base**: The basis.");
    assert_eq!(hover("\"quad\""), "", "there is no such spec");
    editor.close();
}

#[test]
fn parameters_show_their_declarations() {
    let spec = "family F(n in 1..=3) {
    domain 0 <= t <= 1;
    shape 0 <= λ[i] <= i for i in 1..=n;
    let h(x) = 1 - x;
    b[j] = binomial(n, j)*t^j*h(t)^(n - j) for j in 0..=n if j >= 0;
}
family G { shape 0 < α < pi; domain 0 <= θ <= α; g[0] = sin(θ); }
";
    let mut editor = Editor::showing(Folder::new(), "f.basis", spec);
    for (mark, declared) in [
        ("n, j", "n in 1..=3"),
        ("λ[i]", "shape 0 <= λ[i] <= i for i in 1..=n;"),
        ("j)*t", "j in 0..=n"),
        ("x;", "let h(x) = 1 - x;"),
        ("α < pi", "shape 0 < α < pi;"),
    ] {
        let value = editor.hover("f.basis", spec, mark, 0);
        assert!(value.ends_with(&format!("```basis\n{declared}\n```")), "{mark}: {value}");
    }
    editor.close();
}

#[test]
fn a_change_says_where_it_is() {
    let spec = QUARTIC.replace("family", "// 𝔸λ\r\nfamily");
    let mut editor = Editor::showing(Folder::new(), "q.basis", &spec);
    assert!(editor.errors(1).is_empty());
    // A wide character is two units. The second change is about the text after the first one.
    let at = |line: u32, character: u32| json!({ "line": line, "character": character });
    let first = position(&spec, spec.find("prove symmetric").expect("it is there"));
    let (line, column) = (first["line"].as_u64().expect("a number") as u32, first["character"].as_u64());
    let column = column.expect("a number") as u32;
    let changes = json!([
        { "range": { "start": at(0, 5), "end": at(0, 6) }, "text": "x\n// y" },
        { "range": { "start": at(line + 1, column), "end": at(line + 1, column + 5) }, "text": "refute" }
    ]);
    let document = json!({ "uri": editor.uri("q.basis"), "version": 2 });
    editor.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    let errors = editor.errors(2);
    assert_eq!(errors.len(), 1, "{errors:?}");
    assert_eq!(errors[0]["range"]["start"], at(line + 1, column));
    assert!(errors[0]["message"].as_str().expect("a text").contains("symmetric"));
    let outline = editor
        .ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": editor.uri("q.basis") } }));
    assert_eq!(
        outline[0]["range"]["start"]["line"],
        json!(spec.lines().position(|l| l.starts_with("family")).expect("it is there") + 1)
    );
    editor.close();
}

#[test]
fn a_text_has_an_outline_folds_colours_and_a_layout() {
    let messy = QUARTIC.replace("    prove symmetric", "  prove   symmetric ");
    let mut editor = Editor::showing(Folder::new(), "q.basis", &messy);
    let params = json!({ "textDocument": { "uri": editor.uri("q.basis") } });
    let outline = editor.ask("textDocument/documentSymbol", params.clone());
    assert_eq!(outline[0]["name"], "QuarticBernstein");
    assert_eq!(outline[0]["children"].as_array().expect("a list").len(), 11);
    let folds = editor.ask("textDocument/foldingRange", params.clone());
    assert_eq!((&folds[0]["startLine"], &folds[0]["endLine"]), (&json!(1), &json!(15)));
    let tokens = editor.ask("textDocument/semanticTokens/full", params.clone());
    let data = tokens["data"].as_array().expect("a list");
    assert!(data.len() > 300 && data.len().is_multiple_of(5));
    let mut formatting = params;
    formatting["options"] = json!({ "tabSize": 4, "insertSpaces": true });
    let edits = editor.ask("textDocument/formatting", formatting);
    assert_eq!(apply(&messy, &edits), QUARTIC.replace("3+λ", "3 + λ"));
    editor.close();
}

#[test]
fn actions_correct_claims() {
    let spec = QUARTIC
        .replace("-3 <= λ", "-4 <= λ")
        .replace("    prove symmetric", "    prove nonnegative;\n    prove independent;\n    prove symmetric")
        .replace("refute b[0] = b[1]", "prove b[0] = b[1]");
    let mut editor = Editor::showing(Folder::new(), "q.basis", &spec);
    assert_eq!(editor.errors(1).len(), 3);
    let narrow = editor.act("q.basis", &spec, "prove nonneg", "Narrow the range to `-3 <= λ <= 1`");
    let except = editor.act("q.basis", &narrow, "prove indep", "Write `independent except λ = -3`");
    let fixed = editor.act("q.basis", &except, "prove b[0] = b[1]", "Write `refute`");
    assert!(
        fixed.contains("shape -3 <= λ <= 1;") && fixed.contains("prove independent except λ = -3;"),
        "{fixed}"
    );
    editor.edit("q.basis", 2, &fixed);
    assert!(editor.errors(2).is_empty());
    let wrong = fixed.replace("prove symmetric", "refute symmetric");
    editor.edit("q.basis", 3, &wrong);
    assert_eq!(editor.act("q.basis", &wrong, "refute symmetric", "Write `prove`"), fixed);
    // What is as declared needs no correction.
    editor.edit("q.basis", 4, &fixed);
    let titles = editor.actions("q.basis", &fixed, "prove symmetric");
    assert_eq!(titles.len(), 1, "{titles:?}");
    editor.close();
}

#[test]
fn the_claims_that_hold_are_inserted() {
    let spec = "family F {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 2;
    b[0] = (1 - t)*(1 - λ*t/2);
    b[1] = t*(1 - t)*λ/2 + t;
    // the end
}

family G { domain 0 <= t <= 1; g[0] = 1; }
";
    let mut editor = Editor::showing(Folder::new(), "f.basis", spec);
    let longer = editor.act("f.basis", spec, "shape", "Insert the claims that hold of F");
    editor.edit("f.basis", 2, &longer);
    assert!(editor.errors(2).is_empty(), "{longer}");
    for claim in
        ["prove partition_of_unity;", "prove nonnegative;", "D(b, 2) = [λ, -λ];", "b = Bernstein(1);"]
    {
        assert!(longer.contains(claim), "{claim}: {longer}");
    }
    assert!(longer.contains("    // the end\n\n    prove partition_of_unity;"), "{longer}");
    // What is there already is not inserted again.
    assert_eq!(editor.act("f.basis", &longer, "shape", "Insert the claims that hold of F"), longer);
    editor.close();
}

#[test]
fn whatever_is_typed_has_an_answer() {
    let mut editor = Editor::showing(Folder::new(), "q.basis", "");
    let cuts: Vec<usize> = QUARTIC.char_indices().map(|(at, _)| at).step_by(23).collect();
    for (k, cut) in cuts.iter().enumerate() {
        let text = &QUARTIC[..*cut];
        editor.edit("q.basis", k as i64 + 2, text);
        let at =
            json!({ "textDocument": { "uri": editor.uri("q.basis") }, "position": position(text, *cut) });
        for method in
            ["hover", "completion", "definition", "documentHighlight", "documentSymbol", "foldingRange"]
        {
            editor.ask(&format!("textDocument/{method}"), at.clone());
        }
        editor.actions("q.basis", text, "");
    }
    let response = editor.response("textDocument/unknown", json!({}));
    assert_eq!(response["error"]["code"], -32601);
    let nowhere = json!({ "textDocument": { "uri": "file:///nowhere.basis" }, "position": { "line": 9, "character": 9 } });
    assert!(editor.response("textDocument/hover", nowhere)["error"]["message"].is_string());
    editor.close();
}

#[test]
fn points_of_a_join_are_shown_where_they_are_named() {
    let spec = "use library \"quadratic\";
join G1 {
    curve P = QuadraticBezier(λ1);
    curve Q = QuadraticBezier(λ2);
    scalar 0 < δ;
    assume λ2 > -2;
    let Q[0] = P[2];
    let Q[1] = Q[0] + (λ1 + 2)/(δ*(λ2 + 2))*(P[2] - P[1]);
    prove Q(0) == P(1);
}
";
    let mut editor = Editor::showing(Folder::new(), "j.basis", spec);
    let both = editor.hover("j.basis", spec, "Q(0)", 0);
    assert!(both.contains("Q[0] = P[2]\nQ[1] = "), "{both}");
    let one = editor.hover("j.basis", spec, "Q[0] +", 0);
    assert!(one.ends_with("```basis\nQ[0] = P[2]\n```"), "{one}");
    assert!(!editor.hover("j.basis", spec, "P = ", 0).contains("P[2]"), "it is given");
    editor.close();
}

#[test]
fn a_claim_that_fails_in_many_orders_has_one_message() {
    let spec = "family F(n in 1..=5) {
    domain 0 <= t <= 1;
    b[i] = binomial(n, i)*t^i*(1 - t)^(n - i) for i in 0..=n;
    prove b[0] <= 1/2;
    prove b[0] <= 1;
}
";
    let mut editor = Editor::open(Folder::new());
    editor.show("f.basis", spec);
    let errors = editor.errors(1);
    assert_eq!(errors.len(), 1, "{errors:?}");
    let message = errors[0]["message"].as_str().expect("it is a text");
    assert!(message.contains("4 more claims of this statement: the same verdict"), "{message}");
    editor.close();
}
