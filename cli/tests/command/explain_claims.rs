//! `basis explain` writes claims so that they can be read: with what names in them stand for, and refuted ones as sentences.

use crate::support::Folder;

fn explained(spec: &str, format: &str) -> String {
    let run = Folder::with("f.basis", spec).run(&["explain", "f.basis", "--format", format]);
    assert_eq!(run.stderr, "", "{spec}");
    run.stdout
}

#[track_caller]
fn contains(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
}

const NAMES: &str = "family A { domain 0 <= t <= 1; shape u, v; let w = u^2 /* squares */
        + v^2; let h(x) = w*x; let idle = 3;
    b[0] = 1 - t + w*t + idle*0; b[1] = t; prove b[0] = 1 - t + h(t); }
theorem T { curve P = A(u, v); curve Q = A(u, v); scalar s; let c = s^2 + 1; let Q[0] = P[1];
    prove c > 0; prove Q[0] == P[1]; }";

/// What a claim names, and what that names in turn.
#[test]
fn names_in_claims_are_defined() {
    let text = explained(NAMES, "text");
    contains(&text, &["  Names in the claims\n    w    = u^2 + v^2\n    h(x) = w*x\n\n"]);
    contains(&text, &["  Names in the claims\n    c = s^2 + 1\n"]);
    let latex = explained(NAMES, "latex");
    contains(
        &latex,
        &["w &= u^{2} + v^{2} \\\\\nh\\left(x\\right) &= w\\,x\n\\end{align*}", "c &= s^{2} + 1\n"],
    );
    assert!(!latex.contains("idle"), "{latex}");
    let json = explained(NAMES, "json");
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(json["items"][0]["definitions"][1]["value"], "w*x");
}

#[test]
fn refuted_claims_are_sentences() {
    let spec = "family Q { shape 0 <= a <= 1; domain 0 <= t <= 1; b[0] = 1 - t + a*t; b[1] = t;
            refute at t = 1 { b[0] = 2; } refute integral(b[0] + t, t, 0, 1/2) = 3; refute integral(t, t, 0, 1) = a; }
        theorem T { curve P = Bernstein(2); scalar u[i] for i in 0..=3;
            refute u[i]*P[0] parallel P[0] for i in 0..=3; }";
    let latex = explained(spec, "latex");
    let parts = [
        "It is false that at $t = 1$: $b_{0} = 2$. Indeed, $b_{0}$ at $t = 1$ differs",
        "It is false that $\\int_{0}^{\\frac{1}{2}} \\left(b_{0} + t\\right) \\,dt = 3$.",
        "It is false that $\\int_{0}^{1} t \\,dt = a$.",
        "is $u_{0}$ times the right side; the two sides have opposite directions: ",
        " $= -2$ at $u_{0} = -1,\\ P_{0} = \\left(1, -1\\right)$.\n",
    ];
    contains(&latex, &parts);
    assert!(!latex.contains("mathit{side}") && !latex.contains("declares"), "{latex}");
    let text = explained(spec, "text");
    contains(&text, &["    u[i]*P[0] parallel P[0] for i in 0..=3 (4 claims)\n      refuted: "]);
    assert_eq!(text.matches("can be any number").count(), 1, "{text}");
}

#[test]
fn quotients_without_fractions_above_fractions() {
    let spec = "family F { domain 0 <= t <= 1; shape a, b; assume a^2 + b^2 < 1; f[0] = 1/(1 - a^2 - b^2); f[1] = t; }
        family G { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; f[0] = a*t - 1; f[1] = -1; }";
    let text = explained(spec, "text");
    contains(
        &text,
        &["1/(2*(1 - a^2 - b^2))", "C(0)   = 1/(1 - a^2 - b^2)*P[0]", "    f[1]: constant, -1\n"],
    );
    let latex = explained(spec, "latex");
    contains(&latex, &["The function $f_{1}$ is constant, $-1$.", "\\frac{1}{1 - a^{2} - b^{2}}"]);
    assert!(!latex.contains("\\frac{\\frac"), "{latex}");
    let sample =
        "family F { domain 0 <= t <= 1; shape 0 <= a <= 1; f[0] = t^3 - a*t + t^2/3 - 1/7; f[1] = t; }";
    let latex = explained(sample, "latex");
    contains(&latex, &["The function $f_{0}$ at $a = "]);
}
