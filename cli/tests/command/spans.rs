//! Families on several spans and on domains whose ends are shape parameters.

use crate::support::Folder;

const SPLINE: &str = "
family Spline {
    domain 0 <= x <= 1, 1 <= x <= 3, 3 <= x <= 4;
    f[0] = x^2/4 | (-x^2 + 4*x - 2)/4 | (4 - x)^2/4;
    f[1] = x^3/12 | (-x^3 + 6*x^2 - 6*x + 2)/12 | 1 - (4 - x)^3/12;
    prove smooth(1);
    refute smooth(2);
    prove nonnegative;
    prove independent;
    prove D(f[1]) = f[0];
    prove integral(f[0]) = 1;
    refute integral(f[1]) = 1;
    prove integral(f[1]) = 2;
    prove at x = 1 { f[0] = 1/4; D(f[0]) = 1/2; }
    refute at x = 1 { D(f[0], 2) = 1/2; }
    refute at x = 3 { D(f[0], 2) = 1/2; }
    prove at x = 2 { f[0] = 1/2; }
    prove f[0] <= 1/2;
    refute f[0] < 1/2;
    refute D(f[0]) >= 0;
}
";

const KNOTS: &str = "
family Hats {
    shape 0 < d1;
    shape 0 < d2;
    domain 0 <= x <= d1, d1 <= x <= d1 + d2;
    f[0] = (d1 - x)/d1 | 0;
    f[1] = x/d1 | (d1 + d2 - x)/d2;
    f[2] = 0 | (x - d1)/d2;
    prove smooth(0);
    refute smooth(1);
    prove partition_of_unity;
    prove nonnegative;
    prove independent;
    prove at x = d1 { f = [0, 1, 0]; }
    prove integral(f[1]) = (d1 + d2)/2;
    refute integral(f[1]) = d1;
    prove at d1 = d2 { integral(f[1]) = d2; }
}
family Shifted {
    shape a;
    shape 0 < h;
    domain a <= x <= a + h;
    b[i] = binomial(2, i)*((x - a)/h)^i*((a + h - x)/h)^(2 - i) for i in 0..=2;
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at x = a { D(b) = [-2/h, 2/h, 0]; }
    prove integral(b[1]) = h/3;
    prove integral(x, x, a, a + h/2) = h*(4*a + h)/8;
    prove sum((a + i*h/2)*b[i] for i in 0..=2) = x;
    prove D(b[2], h) = -2*(x - a)^2/h^3;
    refute x <= a + h/2;
    refute D(b[1]) >= 0;
}
";

/// Dependent on the whole domain although not on each span alone, and the other way round.
const DEPENDENCE: &str = "
family Together {
    domain -1 <= x <= 0, 0 <= x <= 1;
    f[0] = x | 0;
    f[1] = 0 | x;
    prove independent;
    refute smooth(1);
}
family Sum {
    domain -1 <= x <= 0, 0 <= x <= 1;
    f[0] = x + 1 | 1 - x;
    f[1] = x^2;
    f[2] = x + 1 + x^2 | 1 - x + x^2;
    refute independent;
}
family Turning {
    domain -pi/2 <= t <= 0, 0 <= t <= pi/2;
    f[0] = 1 + sin(t) | 1 - sin(t);
    f[1] = cos(t);
    prove smooth(0);
    refute smooth(1);
    prove nonnegative;
    prove independent;
    prove at t = 0 { f = [1, 1]; }
}
";

fn checked(spec: &str) -> String {
    let run = Folder::with("s.basis", spec).run(&["check", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
    run.stdout
}

#[test]
fn numbers_as_knots() {
    let table = checked(SPLINE);
    assert!(table.contains("domain 0 <= x <= 1, 1 <= x <= 3, 3 <= x <= 4"), "{table}");
    assert!(table.contains("(D(f[0], 2) before x = 1) - (D(f[0], 2) after it) = 1"), "{table}");
}

#[test]
fn parameters_as_knots() {
    checked(KNOTS);
}

#[test]
fn the_whole_domain() {
    checked(DEPENDENCE);
}

#[test]
fn knots_at_angles_that_other_spans_do_not_have() {
    checked(
        "family TrigonometricBSpline {
            domain -pi <= t <= -pi/2, -pi/2 <= t <= 0, 0 <= t <= pi/2;
            f[0] = 1 + cos(t) | cos(t) - sin(t) | 1 - sin(t);
            prove smooth(1);
            prove at t = -pi { f[0] = 0; D(f[0]) = 0; }
            prove at t = 0 { f[0] = 1; D(f[0]) = -1; }
            refute at t = pi/2 { f[0] = 1; }
        }",
    );
    let outside = "family T {
        domain -pi/2 <= t <= 0, 0 <= t <= pi/2;
        f[0] = cos(t) - sin(t) | 1 - sin(t);
        prove at t = pi { f[0] = 1; }
    }";
    let run = Folder::with("s.basis", outside).run(&["check", "s.basis"]);
    assert!(run.stderr.contains("the point lies in none of the spans"), "{}", run.stderr);
}

#[test]
fn a_knot_has_two_sides() {
    let spec =
        SPLINE.replace("refute at x = 1 { D(f[0], 2) = 1/2; }", "prove at x = 1 { D(f[0], 2) = 1/2; }");
    let run = Folder::with("s.basis", &spec).run(&["check", "s.basis"]);
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("D(f[0], 2) = 1/2"), "{}", run.stderr);
}

#[test]
fn explained_and_evaluated_by_span() {
    let folder = Folder::with("s.basis", SPLINE);
    let run = folder.run(&["explain", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    // What is about all spans comes first, and once.
    let (whole, spans) = run.stdout.split_once("\n  On 0 <= x <= 1\n").expect("the first span");
    assert!(whole.starts_with("Spline: 0 <= x <= 1, 1 <= x <= 3, 3 <= x <= 4\n\n  Claims: "), "{whole}");
    assert!(whole.contains("\n\n  Linear independence\n    independent for all shape values\n\n"), "{whole}");
    assert!(
        !spans.contains("Claims") && !spans.contains("independen") && !spans.contains("Spline"),
        "{spans}"
    );
    assert!(spans.contains("\n  On 1 <= x <= 3\n") && spans.contains("\n  On 3 <= x <= 4\n"), "{spans}");
    let latex = folder.run(&["explain", "s.basis", "--format", "latex"]).stdout;
    for part in [
        "The functions are once continuously differentiable on the whole domain.",
        "\\item At $x = 1$: $f_{0} = \\frac{1}{4}$.",
        "It is false that the functions are 2 times continuously differentiable",
        "\\subsection*{On $1 \\le x \\le 3$}",
        "A curve $C = \\sum_i f_i P_i$",
    ] {
        assert!(latex.contains(part), "{part} is missing in\n{latex}");
    }
    assert!(!latex.contains("mathit"), "{latex}");
    let run = folder.run(&["eval", "s.basis", "Spline", "--at", "x=7/2", "--order", "1", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let json: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    assert_eq!((&json["values"]["f[0]"], &json["derivatives"]["D(f[0])"]), (&"1/16".into(), &"-1/4".into()));
}

/// Another curve begins on the first span and this one ends on the last one; integrals are over all spans.
#[test]
fn contacts_and_matrices_of_the_whole_domain() {
    let hats = "family Hats { domain 0 <= x <= 1, 1 <= x <= 2;
        f[0] = 1 - x | 0; f[1] = x | 2 - x; f[2] = 0 | x - 1; }";
    let folder = Folder::with("s.basis", hats).and("k.basis", KNOTS);
    let run = folder.run(&["explain", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let (whole, spans) = run.stdout.split_once("\n  On 0 <= x <= 1\n").expect("the first span");
    for part in [
        "  C1, Q after P: Q'(0) = P'(2)\n    Q[0] = P[2]\n    Q[1] = -P[1] + 2*P[2]\n",
        "  C1, Q before P: Q'(2) = P'(0)\n    Q[1] = 2*P[0] - P[1]\n    Q[2] = P[0]\n",
        "  Mass matrix of the whole domain, the integrals of f[i]*f[j]\n          f[0]  f[1]  f[2]\n    f[0]   1/3   1/6     0\n    f[1]   1/6   2/3   1/6\n",
        "    f[1]    -1     2    -1\n",
        "  Moments of the whole domain, the integrals of m*f[j] for m = 1, x, x^2\n",
    ] {
        assert!(whole.contains(part), "{part} is missing in\n{whole}");
    }
    assert!(!spans.contains("after P") && spans.contains("  Mass matrix, the integrals"), "{spans}");
    let latex = folder.run(&["explain", "s.basis", "--format", "latex"]).stdout;
    let (whole, spans) = latex.split_once("\\subsection*{On $0 \\le x \\le 1$}").expect("the first span");
    assert!(whole.contains("Mass matrix of the whole domain") && whole.contains("C1, Q after P"), "{whole}");
    assert!(!spans.contains("after P"), "{spans}");
    let run = folder.run(&["explain", "k.basis", "Hats"]);
    let row = "    f[1]  1/6*d1  1/3*d1 + 1/3*d2  1/6*d2\n";
    assert!(run.stdout.contains(row), "{}", run.stdout);
}

#[test]
fn certificates() {
    let spec = format!("{SPLINE}{KNOTS}");
    let folder = Folder::with("s.basis", &spec);
    let written = folder.run(&["check", "--certificates", "proofs", "s.basis"]);
    assert_eq!(written.code, 0, "{}", written.stderr);
    let verified = folder.run(&["verify", "proofs", "s.basis"]);
    assert_eq!(verified.code, 0, "{}{}", verified.stdout, verified.stderr);
    let folder = folder.and("s.basis", spec.replace("(4 - x)^2/4", "(4 - x)^2/5"));
    assert_ne!(folder.run(&["verify", "proofs", "s.basis"]).code, 0);
}
