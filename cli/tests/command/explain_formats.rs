//! `basis explain --format json` and `--format latex`.

use std::fs;
use std::process::{Command, Stdio};

use crate::support::{Folder, QUARTIC};

const JOIN: &str = "
/// Ends meet: P'(1) = δ Q'(0).
join G1 {
    curve P = QuarticBernstein(λ1);
    curve Q = QuarticBernstein(λ2);
    scalar 0 < δ;
    assume λ2 > -3;
    let Q[0] = P[3];
    let Q[1] = Q[0] + (λ1 + 3)/(δ*(λ2 + 3)) * (P[3] - P[2]);
    prove D(P)(1) == δ*D(Q)(0);
    refute Q(1) == P(0);
}
";

#[test]
fn an_explanation_is_data() {
    let folder = Folder::with("q.basis", &format!("{QUARTIC}{JOIN}"));
    let run = folder.run(&["explain", "q.basis", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let json = run.json();
    let family = &json["items"][0];
    assert_eq!(family["kind"], "family");
    assert_eq!(family["domain"], "0 <= t <= 1");
    assert_eq!(family["functions"][0]["factored"], "(1 - λ*t)*(1 - t)^3");
    assert_eq!(family["functions"][0]["latex"], "\\left(1 - \\lambda\\,t\\right) \\left(1 - t\\right)^{3}");
    assert_eq!(family["functions"][1]["bernstein"][2], "1/2");
    assert_eq!(family["ends"][1]["value"], "(3 + λ)*(-P[0] + P[1])");
    assert_eq!(family["dependent"][0], "λ = -3: b[1] - b[2] = 0");
    assert_eq!(family["nonnegative"][0], "-3 <= λ <= 1");
    assert_eq!(family["contacts"][0]["points"][0]["value"], "P[3]");
    let claims = family["claims"].as_array().expect("they are a list");
    assert_eq!(claims.len(), 6);
    assert_eq!(
        (claims[5]["verdict"].as_str(), claims[5]["as_declared"].as_bool()),
        (Some("refuted"), Some(true))
    );
    let join = &json["items"][1];
    assert_eq!((join["kind"].as_str(), join["scalars"][0].as_str()), (Some("join"), Some("-3 <= λ1 <= 1")));
    assert_eq!(join["points"][0]["name"], "Q[0]");
    assert_eq!(join["claims"][1]["verdict"], "refuted");
}

/// What stands in a paper.
#[test]
fn an_explanation_is_the_section_of_a_paper() {
    let folder = Folder::with("q.basis", &format!("{QUARTIC}{JOIN}"));
    let run = folder.run(&["explain", "q.basis", "--format", "latex"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for part in [
        "\\section*{QuarticBernstein}\n$\\lambda$ = 0 gives the cubic Bernstein basis.",
        "For shape parameters $-3 \\le \\lambda \\le 1$ the functions on $0 \\le t \\le 1$ are",
        "b_{1} &= \\left(3 + \\lambda - \\lambda\\,t\\right)",
        "\\item The functions sum to one, $\\sum_i b_i = 1$.",
        "\\item The functions are symmetric, $b_i(t) = b_{3-i}(1 - t)$.",
        "\\item At $t = 0$: ${b}' = ",
        "It is false that $b_{0} = b_{1}$",
        "C'\\left(0\\right) &= \\left(3 + \\lambda\\right)",
        "linearly dependent at $\\lambda = -3$: $b_{1} - b_{2} = 0$",
        "Ends meet: P'(1) = $\\delta$ Q'(0).",
        "Q_{1} &= ",
    ] {
        assert!(run.stdout.contains(part), "{part}\n{}", run.stdout);
    }
}

/// Whatever is explained compiles, without an error and without a letter that is missing.
#[test]
fn latex_compiles() {
    if Command::new("pdflatex").arg("--version").stdout(Stdio::null()).status().is_err() {
        eprintln!("skipped: there is no pdflatex");
        return;
    }
    let strange = "/// 50% & $5_{x} ~ ^ \\ # “quoted” é Škoda – 漢 `code_x`.\nfamily Ω_1 {
    domain -1 <= ξ <= 3/2;
    shape 0 < weight;
    shape ζ_a;
    let h = 1 + weight;
    c[0] = (1 - ξ)^2*h/weight; c[1] = ζ_a*ξ - 1/3;
    prove c[0] >= 0;
    refute c[1] < 0;
    prove D(c[0], weight) <= 0;
}\n";
    let folder = Folder::with("q.basis", &format!("{QUARTIC}{JOIN}")).and("s.basis", strange);
    for spec in [
        "q.basis",
        "s.basis",
        "library:kochanek_bartels",
        "library:triangular",
        "library:elements",
        "library:papers/quadratic",
        "library:rational/lupas",
    ] {
        let run = folder.run(&["explain", spec, "--format", "latex"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{spec}");
        folder.write("x.tex", &run.stdout);
        let mut latex = Command::new("pdflatex");
        latex.args(["-interaction=nonstopmode", "-halt-on-error", "x.tex"]).current_dir(folder.path());
        let output = latex.stdin(Stdio::null()).output().expect("it starts");
        assert!(output.status.success(), "{spec}: {}", String::from_utf8_lossy(&output.stdout));
        let log = fs::read(folder.path().join("x.log")).expect("it is written");
        assert!(!String::from_utf8_lossy(&log).contains("Missing character"), "{spec}");
    }
}

/// Weights of two patches, common denominators, triangles and knots: everything that is a formula is set as one.
#[test]
fn formulas_of_all_kinds_are_set_as_formulas() {
    let spec = "family Weighted {
    domain 0 <= t <= 1;
    shape w[i] > 0 for i in 0..=1;
    b[0] = w[0]*(1 - t)/(w[0]*(1 - t) + w[1]*t);
    b[1] = w[1]*t/(w[0]*(1 - t) + w[1]*t);
}
family Wedge { domain triangle (u, v, w), 0 <= z <= 1; b[0] = u*z; b[1] = 1 - u*z; }
family Roof {
    shape 0 < k < 1;
    domain 0 <= x <= k, k <= x <= 1;
    f[0] = x/k | (1 - x)/(1 - k);
    refute smooth(1);
}";
    let run = Folder::with("s.basis", spec).run(&["explain", "s.basis", "--format", "latex"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for part in [
        "Q_{1} &= -\\frac{w_{0,Q}\\,w_{0,P}}{w_{1,Q}\\,w_{1,P}}\\,P_{0}",
        "\\paragraph{Bernstein form of degree 1 over the common denominator $-w_{0} + w_{0}\\,t - w_{1}\\,t$.} $",
        "\\bigr) b_{i} = \\sum M_{i,j}\\,B_{j}$",
        "on the triangle where $u + v + w = 1$ and $u, v, w \\ge 0$, times $0 \\le z \\le 1$ are",
        "It is false that the functions are once continuously differentiable",
        "before $x = k$) $-$ (${f_{0}}'$ after it)",
    ] {
        assert!(run.stdout.contains(part), "{part} is missing in\n{}", run.stdout);
    }
    assert!(!run.stdout.contains("\\text{") && !run.stdout.contains("M[i,j]"), "{}", run.stdout);
}
