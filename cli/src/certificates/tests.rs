//! Certificates come back as they were written, and a corrupt one is rejected wherever it is corrupt.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Value, json};

use super::specs::{Stated, items};
use super::verify::{certificate, claim};
use super::write;
use crate::check::files::Entry;
use crate::check::prove;

/// Families and theorems whose claims need every kind of certificate and of witness.
const SPEC: &str = "\
family Curve {
    domain 0 <= t <= 1;
    shape -3 <= λ <= 1;
    b[0] = (1 - λ*t)*(1 - t)^3;
    b[1] = (3 + λ - λ*t)*t*(1 - t)^2;
    b[2] = (3 + λ*t)*t^2*(1 - t);
    b[3] = (1 - λ + λ*t)*t^3;
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    refute independent;
    prove independent except λ = -3;
    refute independent except λ = 0;
    prove at t = 0, λ = 1 { b = [1, 0, 0, 0]; }
    refute at t = 1/2 { b[0] = b[1]; }
    refute D(b[1]) >= 0;
    prove at t = 0, λ = 0 { b[0] > 0; }
}
family Methods {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 1;
    shape 0 < μ < 2;
    b[0] = t;
    b[1] = 1 - t;
    prove (t - λ)^2 >= 0;
    prove (3*t - 1)^2 + (3*λ - 1)^2 >= 0;
    prove (3*t - 1)^2 + (3*λ - 1)^2 + 1/1000000 > 0;
    prove (2*t^2 - 1)^2 + (3*λ^2 - 1)^2 + 1/1000000 > 0;
    prove 1 + t + λ*(t - λ)^2*μ > 0;
    prove t^2 - t + 1/3 > 0;
    prove (t^2 - 1/2)^2 + (λ^2 - 1/2)^2 + (t - λ)^2*(t + λ) >= 0;
    prove (2*t - 1)^2 + (2*λ - 1)^2 + (μ - 1)^2 + 1/50 > 0;
    prove at t = 1/2 { μ*(λ^2 - λ + 1/3) > 0; }
    refute (2*t^2 - 1)^2 > 0;
    refute (2*t^2 - 1)^2 + (3*λ^2 - 1)^2 > 0;
    prove independent;
}
family Open {
    domain 0 <= t <= 1;
    shape 0 < λ < 1;
    shape 0 < μ < 1;
    b[0] = 1;
    prove (λ^2 + μ^2 - 1/4)^2 + (λ - 2*μ)^2*t + 1/1000 > 0;
    prove at t = 1 { (2*λ^2 - 1)^2 + (3*μ^2 - 1)^2 + (λ - μ)^2 > 0; }
}
family Denominators {
    domain 0 <= t <= 1;
    shape λ, μ;
    assume λ*μ >= 1;
    b[0] = (1 - t)/(λ*μ - 1/2);
    b[1] = t/λ;
    prove b[0] >= 0;
    refute b[1] >= 0;
}
family Disk {
    domain 0 <= t <= 1;
    shape λ, μ;
    assume λ^2 + μ^2 <= 1;
    b[0] = (1 - t)/(λ + μ - 3/2);
    b[1] = t/(2 - λ);
    refute b[0] >= 0;
    prove b[1] >= 0;
    prove independent;
    refute independent except (λ = 0, μ = 1);
    refute independent except λ = 0;
}
family Line {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 2;
    b[0] = (λ^2 - 2)*t;
    b[1] = λ + (1 - λ)*t^2;
    refute independent;
}
family Patch(n in 2..=3) {
    domain triangle (u, v, w);
    shape 1 <= λ <= 2;
    base n = 2 {
        b[2, 0, 0] = u^2 + (2 - λ)*u*v;
        b[0, 2, 0] = v^2;
        b[0, 0, 2] = w^2;
        b[1, 1, 0] = λ*u*v;
        b[1, 0, 1] = 2*u*w;
        b[0, 1, 1] = 2*v*w;
    }
    raise b[i, j, k] = u*b[i - 1, j, k] + v*b[i, j - 1, k] + w*b[i, j, k - 1];
    refute symmetric;
    prove nonnegative;
    prove independent;
}
family Large(n in 3..=6) {
    domain triangle (u, v, w);
    shape 2 <= λ1 <= 3;
    shape 1 <= λ2 <= 2;
    base n = 3 {
        permute b[2, 1, 0] = λ1 * u^2 * v;
        b[1, 1, 1] = 3 * λ2 * u*v*w;
        permute b[3, 0, 0] = u^3 + (3 - λ1)*(u^2*v + u^2*w) + (2 - λ2)*u*v*w;
    }
    raise b[i, j, k] = u*b[i - 1, j, k] + v*b[i, j - 1, k] + w*b[i, j, k - 1];
    prove independent;
}
family Corners {
    domain tetrahedron (u, v, w, x);
    shape 0 <= λ <= 1;
    shape 0 <= μ <= 3;
    b[1, 0, 0, 0] = u;
    b[0, 1, 0, 0] = v;
    b[0, 0, 1, 0] = w;
    b[0, 0, 0, 1] = λ*x;
    refute independent;
    refute independent except λ = 1;
    refute λ*u >= μ;
    refute λ = 0;
}
family Quasi(n in 3..=4) {
    domain triangle (u, v, w);
    shape 2 <= λ <= 3;
    base n = 3 {
        permute b[2, 1, 0] = λ*u^2*v;
        b[1, 1, 1] = 6*u*v*w;
        permute b[3, 0, 0] = u^3 + (3 - λ)*(u^2*v + u^2*w);
    }
    raise b[i, j, k] = u*b[i - 1, j, k] + v*b[i, j - 1, k] + w*b[i, j, k - 1];
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
}
theorem Tangents {
    curve P = Curve(λ);
    prove D(P)(0) = (3 + λ)*(P[1] - P[0]);
    refute D(P)(0) parallel P[2] - P[0];
    refute D(P)(0) parallel P[1] - P[0];
    scalar 0 <= x <= 2;
    prove x*(x^2 + 1)*P[0] parallel x^2*P[0];
    refute (x^2 - 2)^2*P[0] parallel P[0];
    refute λ > 0;
    prove λ^2 >= 0;
}
theorem Squares {
    curve P = Curve(0);
    prove dot(P[0], P[0])^2 + dot(P[0], P[1])^2 >= 0;
    prove dot(P[0] - 2*P[1], P[0] + 2*P[1]) + 5*dot(P[1], P[1]) + 1 > 0;
    prove dot(P[0], P[0])*P[0] parallel P[0];
    refute dot(P[0], P[1]) >= 0;
}
theorem Single {
    curve P = Curve(1/2);
    scalar 1 <= r <= 1;
    prove P(r) = P[3];
}
join Smooth {
    curve P = Curve(1/2);
    curve Q = Curve(1/2);
    let Q[0] = P[3];
    let Q[1] = Q[0] + P[3] - P[2];
    prove P(1) = Q(0);
    prove D(P)(1) parallel D(Q)(0);
}
";

/// The certificates of a spec, and the spec as it is read again.
fn certificates(spec: &str) -> (tempfile::TempDir, String, Vec<Value>, Vec<Stated>) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("spec.basis");
    std::fs::write(&path, spec).expect("a file can be written");
    let outcome = prove::file(Entry { path: path.clone(), problem: None }, prove::Formal::Left);
    let messages: Vec<String> =
        outcome.all_diagnostics().iter().map(basis_engine::Diagnostic::text).collect();
    assert_eq!(messages, [""; 0], "everything is as declared");
    let values = outcome
        .items
        .iter()
        .map(|d| serde_json::from_str(&write::item(&outcome, d)).expect("a certificate is JSON"));
    let values = values.collect();
    (folder, outcome.path.clone(), values, items(&path).expect("the spec is right"))
}

/// Everything that can be done to one place of a value; if the place is `exact`, also other numbers of about its size.
fn mutants(value: &Value, exact: bool) -> Vec<Value> {
    let mut all = match value {
        Value::Null => vec![json!(0), json!("x"), json!([])],
        Value::Bool(b) => vec![json!(!b), Value::Null],
        Value::Number(n) => {
            let n = n.as_i64().unwrap_or_default();
            vec![
                json!(n + 1),
                json!(n - 1),
                json!(n + 1_000_000),
                json!(n.to_string()),
                json!(0.5),
                Value::Null,
            ]
        }
        Value::String(s) => {
            let negated = s.strip_prefix('-').map_or_else(|| format!("-{s}"), String::from);
            // Another number in the place of the first one, far away: a near one can be just as good a proof.
            let at = s.find(|c: char| c.is_ascii_digit()).unwrap_or(0);
            let larger = format!("{}100{}", &s[..at], &s[at..]);
            let mut all =
                vec![json!(negated), json!(larger), json!(""), json!("1000000"), json!("λ"), Value::Null];
            // Near numbers can be just as good a sample, but no other counterexample.
            if exact {
                all.extend(["0", "1", "1/2", "1/3", "3/4"].map(Value::from));
            }
            all
        }
        Value::Array(list) => {
            let mut all = vec![json!([]), json!({}), Value::Null];
            if let (Some(first), Some(last)) = (list.first(), list.last()) {
                all.push(Value::from(list[1..].to_vec()));
                all.push(Value::from(list[..list.len() - 1].to_vec()));
                all.push(Value::from([list, std::slice::from_ref(last)].concat()));
                all.push(Value::from([std::slice::from_ref(first), list].concat()));
            }
            all.push(Value::from([&list[..], &[Value::Null]].concat()));
            all
        }
        Value::Object(object) => {
            let mut all = vec![json!([]), Value::Null];
            for key in object.keys() {
                let mut less = object.clone();
                less.remove(key);
                all.push(Value::from(less));
            }
            let mut more = object.clone();
            more.insert(String::from("extra"), json!(1));
            all.push(Value::from(more));
            all
        }
    };
    all.retain(|mutant| mutant != value);
    all
}

/// The pointers to all places in a value.
fn places(value: &Value, at: &str, all: &mut Vec<String>) {
    all.push(at.to_string());
    match value {
        Value::Array(list) => list.iter().enumerate().for_each(|(k, v)| places(v, &format!("{at}/{k}"), all)),
        Value::Object(object) => {
            for (key, v) in object {
                places(v, &format!("{at}/{}", key.replace('~', "~0").replace('/', "~1")), all);
            }
        }
        _ => {}
    }
}

/// A place without positions: places of one kind are alike.
fn kind(place: &str) -> String {
    place.split('/').filter(|part| part.parse::<usize>().is_err()).collect::<Vec<_>>().join("/")
}

/// The number of places of one kind that are corrupted in each claim.
const ALIKE: usize = 2;

#[test]
fn every_corruption_is_rejected() {
    let (_folder, spec, values, mut items) = certificates(SPEC);
    let (mut count, mut kinds, mut accepted) = (0, BTreeSet::new(), Vec::new());
    let mut try_all = |whole: &Value, of_family: bool, is_accepted: &mut dyn FnMut(&Value) -> bool| {
        let mut all = Vec::new();
        places(whole, "", &mut all);
        let mut seen: BTreeMap<String, usize> = BTreeMap::new();
        for place in &all {
            let seen = seen.entry(kind(place)).or_default();
            *seen += 1;
            if *seen > ALIKE {
                continue;
            }
            let exact = of_family && place.ends_with("/witness");
            for mutant in mutants(whole.pointer(place).expect("a place"), exact) {
                let shown = mutant.to_string();
                // Many claims fail whatever some of the control points are.
                if place.contains("/given/") && shown.contains("100") {
                    continue;
                }
                let mut corrupt = whole.clone();
                *corrupt.pointer_mut(place).expect("a place") = mutant;
                count += 1;
                kinds.insert(kind(place));
                if is_accepted(&corrupt) {
                    accepted.push(format!("{} {place}: {shown}", whole["claim"]));
                }
            }
        }
    };
    for (k, value) in values.iter().enumerate() {
        assert_eq!(certificate(value, &spec, &mut items), [""; 0], "{}", value["name"]);
        // Around the claims, with as many as there are, but short ones.
        let mut frame = value.clone();
        let claims = frame["claims"].as_array_mut().map(std::mem::take).unwrap_or_default();
        try_all(&frame, false, &mut |corrupt| {
            let mut whole = corrupt.clone();
            if whole.get("claims") == Some(&json!([])) {
                whole["claims"] = Value::from(claims.clone());
            }
            certificate(&whole, &spec, &mut items).is_empty()
        });
        let Stated { item, lines, .. } = &items[k];
        for ((value, stated), line) in claims.iter().zip(&item.claims).zip(lines) {
            let of_family = item.subject.kind() == "family";
            try_all(value, of_family, &mut |corrupt| claim(corrupt, &item.subject, stated, *line).is_ok());
        }
    }
    assert_eq!(accepted, [""; 0], "{} of {count}", accepted.len());
    assert!(count > 3_000 && kinds.len() > 15, "{count} corruptions of {} kinds of places", kinds.len());
}

#[test]
fn large_certificates_are_refused_at_once() {
    let spec = "\
family Methods {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 1;
    b[0] = t;
    prove (3*t - 1)^2 + (3*λ - 1)^2 + 1/100 > 0;
    prove (2*t - 1)^4 + (2*λ^2 - 1)^2 + 1/1000 >= 0;
}
";
    let (_folder, _, values, items) = certificates(spec);
    let Stated { item, lines, .. } = &items[0];
    let refused = |k: usize, proof: String, why: &str| {
        let mut corrupt = values[0]["claims"][k].clone();
        corrupt["proofs"] = json!({"0": proof});
        let problem = claim(&corrupt, &item.subject, &item.claims[k], lines[k]).expect_err("no proof");
        assert!(problem.contains(why) && problem.len() < 500, "{problem}");
    };
    // A number of 300 000 digits.
    let long = format!("(sign _ (corners x1 . . 1/3{} .))", "0".repeat(300_000));
    refused(0, long, "a word is too long");
    // A cut within a cut within a cut.
    let deep = |n: usize| format!("(sign _ {}.{})", "(cut x1 ".repeat(n), " .)".repeat(n));
    refused(0, deep(2000), "nested too deeply");
    refused(0, deep(400), "nested too deeply");
    // Sample points of 19 000 digits, and projections of a high degree.
    let number = format!("1/{}1", "1".repeat(19_000));
    refused(1, format!("(sign _ (cells (x0 x1) ((-1+2*x0^2) (-1+2*x1)) (({number} {number}))))"), "");
    let (x, y) = ("1-x1^900+x0^800*x1^901", "1+x0^65000");
    for levels in [format!("(() ({x}))"), format!("(({y}) ())"), format!("(({y}) ({x}))")] {
        refused(1, format!("(sign _ (cells (x0 x1) {levels} ((1/2 1/2))))"), "");
    }
}

#[test]
fn claims_are_neither_lost_nor_exchanged() {
    let (_folder, spec, values, mut items) = certificates(SPEC);
    let claims = values[0]["claims"].as_array().expect("a list");
    for k in 1..claims.len() {
        let mut exchanged = claims.clone();
        exchanged.swap(0, k);
        let mut corrupt = values[0].clone();
        corrupt["claims"] = Value::from(exchanged);
        assert_ne!(certificate(&corrupt, &spec, &mut items), [""; 0]);
        corrupt["claims"] = Value::from(claims[..k].to_vec());
        assert_ne!(certificate(&corrupt, &spec, &mut items), [""; 0]);
    }
    // The certificate of one order is not valid for another.
    let orders: Vec<&Value> = values.iter().filter(|v| v["name"] == "Patch").collect();
    let mut corrupt = orders[0].clone();
    corrupt["order"] = orders[1]["order"].clone();
    assert_ne!(certificate(&corrupt, &spec, &mut items), [""; 0]);
}

#[test]
fn every_kind_of_certificate_is_written() {
    let (_folder, _, values, _) = certificates(SPEC);
    let text = values.iter().map(Value::to_string).collect::<String>();
    for kind in [
        "(sign _ (",
        "(cut x",
        "(corners x",
        "(factors (",
        "(faces ",
        "(cells (",
        "(slices (",
        "(rank (",
        "(change (",
        "(at (x",
        "(at (root (",
        "(dependent (at",
        "(independent (at",
        "\"given\":[",
    ] {
        assert!(text.contains(kind), "{kind}");
    }
}
