//! No text makes the engine panic, and every text is answered within the work budgets.

use basis_engine::{Report, Source, check};
use basis_tests::random::Random;

const SHIPPED: [&str; 6] = [
    include_str!("../../specs/quartic.basis"),
    include_str!("../../specs/cardinal.basis"),
    include_str!("../../specs/beta_spline.basis"),
    include_str!("../../specs/lagrange.basis"),
    include_str!("../../specs/triangular.basis"),
    include_str!("../../specs/papers/quadratic.basis"),
];

/// Pieces that a formula can be broken with.
const PIECES: [&str; 24] = [
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    "^",
    "-",
    "/0",
    "^999999999",
    "t",
    "λ",
    ";",
    "=",
    "<=",
    "..=",
    "for i in 0..=9999999",
    "sum(",
    "D(",
    "\"",
    "/*",
    "é",
    "\u{0}",
    "9999999999999999999999999999",
];

fn mutate(text: &str, random: &mut Random) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(3) {
        let at = random.below(text.len().max(1));
        match random.below(5) {
            0 => text.truncate(at),
            1 => {
                let end = (at + random.below(12)).min(text.len());
                text.drain(at..end);
            }
            2 => {
                let other = random.below(text.len().max(1));
                if at < text.len() {
                    text.swap(at, other);
                }
            }
            _ => {
                let piece = PIECES[random.below(PIECES.len())];
                text.splice(at..at, piece.chars());
            }
        }
    }
    text.into_iter().collect()
}

/// Every message can be shown with its place.
fn rendered(report: &Report) {
    for diagnostic in &report.diagnostics {
        let text = diagnostic.render(&report.sources, false);
        assert!(text.starts_with("error: ") || text.starts_with("warning: "), "{text}");
    }
}

#[test]
fn broken_specs_are_answered() {
    let mut random = Random::new(2024);
    let mut refused = 0;
    for round in 0..150 {
        // One family of a spec at a time: the first so many characters.
        let text = SHIPPED[round % SHIPPED.len()];
        let start: String = text.chars().take(1200).collect();
        let report = check(Source::text("mutant.basis", &mutate(&start, &mut random)));
        refused += usize::from(!report.diagnostics.is_empty());
        rendered(&report);
    }
    assert!(refused > 75, "only {refused} of 150 broken specs were refused");
}

#[test]
fn specs_that_ask_for_too_much_are_refused() {
    let deep = format!("{}t{}", "(".repeat(5000), ")".repeat(5000));
    let negative = format!("{}t", "-".repeat(50_000));
    let long = vec!["t"; 20_000].join(" + ");
    for formula in [
        "(1 + t + λ)^100000",
        "(1 + t + λ)^100*(1 + t + λ)^100",
        "((((1 + t + λ)^9)^9)^9)^9",
        "2^(10^9)",
        "2^2^2^2^2^2",
        "factorial(10^9)",
        "sum((t + λ)^i for i in 0..=10^9)",
        "product(t + λ + i for i in 0..=5000)",
        "sum(sum(t^i*λ^j for j in 0..=200) for i in 0..=200)",
        "1/((1 + λ)^150)^2",
        deep.as_str(),
    ] {
        let text = format!("family F {{ domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = {formula}; }}");
        let report = check(Source::text("hostile.basis", &text));
        assert!(!report.diagnostics.is_empty(), "{formula:.60} is accepted");
        rendered(&report);
    }
    for formula in [negative, long] {
        let text = format!("family F {{ domain 0 <= t <= 1; b[0] = {formula}; }}");
        rendered(&check(Source::text("long.basis", &text)));
    }
    // Claims about tables of large numbers: more functions than coefficients, and many of high degree.
    for (claim, functions) in [
        ("refute independent", "b[i] = ((i + 1)/(i + 2) + t)^40 for i in 0..=300;"),
        ("prove independent", "b[i] = binomial(90, i) * t^i * (1 - t)^(90 - i) for i in 0..=90;"),
        ("prove independent", "b[i] = (t + 1/(i + 2))^40 for i in 0..=40;"),
        ("prove independent except λ = 1/3", "b[i] = (t + λ/(i + 2))^20 for i in 0..=20;"),
    ] {
        let text = format!("family F {{ domain 0 <= t <= 1; shape 0 < λ <= 1; {functions} {claim}; }}");
        rendered(&check(Source::text("table.basis", &text)));
    }
}
