//! Scalars of theorems that are related to one another, by what is assumed and by the families of curves.

use crate::verdicts::verdicts;

const SPEC: &str = include_str!("../../../tests/specs/good/related_scalars.basis");

#[test]
fn claims_about_related_scalars() {
    let found = verdicts(SPEC);
    let refuted: Vec<&String> = found.iter().filter(|v| *v != "=").collect();
    assert_eq!(refuted.len(), SPEC.matches("refute ").count(), "{found:?}");
    assert!(refuted.iter().all(|v| v.contains(" at ")), "{refuted:?}");
    // The images of points of boxes, not these.
    assert!(refuted.contains(&&String::from("0 at a = 1, c = 1")), "{refuted:?}");
    assert!(refuted.contains(&&String::from("0 at x = 1, y = 1")), "{refuted:?}");
}

#[test]
fn what_no_values_satisfy_is_an_error() {
    let specs = [
        "theorem Empty { scalar 0 <= a; scalar 0 <= b; assume a + b <= -1; prove a <= b; }",
        "theorem Round { scalar a; assume a^2 <= -1; prove a <= 1; }",
    ];
    for spec in specs {
        let report = basis_engine::check(basis_engine::Source::text("empty.basis", spec));
        let messages: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(messages, ["no values of the scalars satisfy all that is assumed"]);
    }
}
