//! The examples of SPEC.md are specs whose claims are all as declared.

use basis_engine::{Source, check};

#[test]
fn every_example_is_as_declared() {
    let page = include_str!("../../../SPEC.md");
    let examples: Vec<&str> =
        page.split("```basis\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(examples.len() >= 3, "the page has lost its examples");
    for example in examples {
        let report = check(Source::text("SPEC.md", example));
        let messages: Vec<String> =
            report.diagnostics.iter().map(|d| d.render(&report.sources, false)).collect();
        assert!(messages.is_empty(), "{}", messages.join("\n"));
        assert!(
            report.items.iter().any(|item| !item.claims.is_empty()),
            "an example claims nothing:\n{example}"
        );
    }
}
