//! Domains that end at sums of shape parameters, in angles and exponentials: what is in order, and what is not.

use crate::rechecked::counterexamples;
use basis_engine::{Source, check};

fn family(shape: &str, domain: &str, claims: &str) -> String {
    format!("family F {{ shape {shape}; domain {domain}; b[0] = 1 - cos(t); b[1] = cos(t); {claims} }}")
}

#[test]
fn a_width_above_zero_is_enough() {
    for (shape, domain) in [
        ("-1 <= a <= 1, 0 < h <= 2", "a <= t <= a + h"),
        ("-pi/4 <= a <= pi/4, 0 < h <= pi/2", "a <= t <= a + h"),
        ("0 <= a < 1, 1 <= c < 2", "a <= t <= c"),
        ("-pi/2 <= a < 0, 0 <= c < pi/2", "a <= t <= c"),
    ] {
        let spec = family(shape, domain, "prove b[0] >= 0; prove partition_of_unity; prove independent;");
        assert_eq!(counterexamples(&spec), [""; 0], "{shape}; {domain}");
    }
    let false_ones = family("-1 <= a <= 1, 0 < h <= 2", "a <= t <= a + h", "refute b[0] <= b[1];");
    assert_eq!(counterexamples(&false_ones).len(), 1);
}

#[test]
fn ends_that_may_meet_or_cross_are_errors() {
    for (shape, domain) in [
        ("-1 <= a <= 1, 0 <= h <= 2", "a <= t <= a + h"),
        ("0 <= a <= 1, 1 <= c < 2", "a <= t <= c"),
        ("0 < a < 2, 1 < c < 2", "a <= t <= c"),
        ("-pi/2 <= a < 1, 0 <= c < pi/2", "a <= t <= c"),
    ] {
        let report = check(Source::text("ends.basis", &family(shape, domain, "prove b[0] >= 0;")));
        let found: Vec<_> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(
            found,
            ["the ends of the domain of `t` could not be proved to be in order"],
            "{shape}; {domain}"
        );
    }
}
