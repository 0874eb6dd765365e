//! `basis explain` says nothing of shape values that are ruled out: by the order of a chain, by ranges that depend on one
//! another, or by what is assumed. What it says agrees with the verdicts of `basis check`.

use crate::support::Folder;

fn explained(spec: &str, format: &str) -> String {
    let run = Folder::with("f.basis", spec).run(&["explain", "f.basis", "--format", format]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{spec}");
    run.stdout
}

/// The lines under a title, without their indentation.
fn lines(spec: &str, title: &str) -> Vec<String> {
    let text = explained(spec, "text");
    let part = text.split_once(&format!("  {title}")).map_or("", |(_, part)| part);
    part.lines().skip(1).take_while(|l| !l.is_empty()).map(|l| l.trim().to_string()).collect()
}

fn dependence(spec: &str) -> Vec<String> {
    lines(spec, "Linear independence")
}

fn nonnegative(spec: &str) -> Vec<String> {
    lines(spec, "All functions are nonnegative")
}

fn negative(spec: &str) -> Vec<String> {
    lines(spec, "Functions that are negative somewhere")
}

/// Where two parameters of a chain are the same there is none between them.
#[test]
fn dependence_on_a_chain() {
    let chain = "family K { domain 0 <= t <= 1; shape 0 < x < y < z; FUNCTIONS; prove independent; }";
    for functions in [
        "b[0] = 1/(t + x); b[1] = 1/(t + y); b[2] = 1/(t + z)",
        "b[0] = 1 + x*t; b[1] = 1 + y*t + t^2*x; b[2] = 1 + z*t",
    ] {
        let spec = chain.replace("FUNCTIONS", functions);
        assert_eq!(dependence(&spec), ["independent for all shape values"], "{spec}");
        let latex = explained(&spec, "latex");
        assert!(latex.contains("linearly independent") && !latex.contains("linearly dependent"), "{latex}");
    }
    // With the ends of the chain they are dependent.
    let closed = "family K { domain 0 <= t <= 1; shape 0 <= x <= y <= 1; b[0] = 1 + x*t; b[1] = 1 + y*t; }";
    assert_eq!(dependence(closed), ["dependent at x = y: b[0] - b[1] = 0"]);
}

/// Infinitely many shape values by an equation, where that is known.
#[test]
fn dependence_along_lines_and_curves() {
    let sum = "family F { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; assume a + b <= 1;
        f[0] = 1 - t - a*t; f[1] = t*(1 - b) - a*t; }";
    assert_eq!(dependence(sum), ["dependent at a + b = 1: f[1] = 0"]);
    let circle = "family F { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; f[0] = 1; f[1] = t*(a^2 + b^2 - 1); }";
    assert_eq!(dependence(circle), ["dependent at a^2 + b^2 = 1: f[1] = 0"]);
    let several =
        "family F { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; f[0] = a; f[1] = t*(a - b); }";
    assert_eq!(dependence(several), ["dependent at a = 0: f[0] = 0", "dependent at a = b: f[1] = 0"]);
}

#[test]
fn dependence_at_the_end_of_what_is_assumed() {
    let spec = "family F { domain 0 <= t <= 1; shape 0 <= a, 0 <= b; assume a + b <= 1; f[0] = 1 - a - b*t;
        prove independent except (a = 1, b = 0); }";
    assert_eq!(dependence(spec), ["dependent at a = 1, b = 0: f[0] = 0"]);
    let ruled_out = "family F { domain 0 <= t <= 1; shape 0 <= a <= 2, 0 <= b <= 2; assume a + b <= 1;
        f[0] = 1 - t; f[1] = (a - 1)*t + (b - 1)*t^2; prove independent; }";
    assert_eq!(dependence(ruled_out), ["independent for all shape values"]);
    // On a disk.
    let disk =
        "family F { domain 0 <= t <= 1; shape a, b; assume a^2 + b^2 <= 1; f[0] = a - 2 + t*b; f[1] = t^2; }";
    assert_eq!(dependence(disk), ["independent for all shape values"]);
}

#[test]
fn nonnegative_as_the_claim_is_decided() {
    let proved = [
        ("shape 0 <= b <= a <= 1; f[0] = a - b*t", ["0 <= b <= 1", "0 <= a <= 1"]),
        ("shape 0 <= a, 0 <= b; assume a + b <= 1; f[0] = 1 - a - b*t", ["0 <= a <= 1", "0 <= b <= 1"]),
        (
            "shape a, b; assume a^2 + b^2 < 1; f[0] = 1/(1 - a^2 - b^2); f[1] = t",
            [
                "every a (as declared and assumed; no other values were looked at)",
                "every b (as declared and assumed; no other values were looked at)",
            ],
        ),
    ];
    for (body, ranges) in proved {
        let spec = format!("family F {{ domain 0 <= t <= 1; {body}; prove nonnegative; }}");
        assert_eq!(nonnegative(&spec), ranges, "{spec}");
        assert!(negative(&spec).is_empty(), "{spec}");
    }
}

/// Ranges at the values that count, and none beyond them.
#[test]
fn nonnegative_on_a_part() {
    let negative = "a function is negative somewhere on the declared ranges";
    let sum = "family F { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; assume a + b <= 1;
        f[0] = 1 - t - a*t; f[1] = t*(1 - b) - a*t; }";
    assert_eq!(nonnegative(sum), [format!("a = 0 ({negative})"), format!("b = 1 ({negative})")]);
    let never =
        "family F { domain 0 <= t <= 1; shape 0 <= a <= 2, 0 <= b <= 2; assume a + b <= 1; f[0] = 1 - t;
        f[1] = (a - 1)*t + (b - 1)*t^2; }";
    assert_eq!(nonnegative(never), [format!("a: {negative}"), format!("b: {negative}")]);
    // From 1/sqrt(2) on, which is no end of a range.
    let root = "family F { domain 0 <= t <= 1; shape 0 <= a <= 1, 0 <= b <= 1; assume a + b <= 1;
        f[0] = a^2 - 1/2 + t; f[1] = b; }";
    assert_eq!(nonnegative(root), [format!("1/2*sqrt(2) <= a <= 1 ({negative})"), format!("b: {negative}")]);
}

/// Zeros and extrema are those at values that count.
#[test]
fn extrema_at_values_that_count() {
    let disk = "family F { domain 0 <= t <= 1; shape a, b; assume a^2 + b^2 <= 1; f[0] = 1 - t;
        f[1] = (a - 1)*t + (b + 1)*t^2; }";
    let line = "f[1] at a = 0, b = 0: zero at t = 0, t = 1; least value -1/4 at t = 1/2; greatest value 0 at t = 0, t = 1";
    assert_eq!(negative(disk), [line]);
    let cone = "family F { domain 0 <= t <= 1; shape 0 < p, 0 < q, r; assume p*q > r^2; f[0] = 1/(p*q - r^2) - 2*t; }";
    let line =
        "f[0] at p = 1, q = 1, r = 0: zero at t = 1/2; least value -1 at t = 1; greatest value 1 at t = 0";
    assert_eq!(negative(cone), [line]);
    // Negative at a few shape values only, which are those of a counterexample.
    let rarely =
        "family F { domain 0 <= t <= 1; shape 0 <= a <= 1; f[0] = 1 - t; f[1] = t^2 - t*a/8 + 1/1000; }";
    let lines = negative(rarely);
    assert!(lines.len() == 1 && lines[0].starts_with("f[1] at a = 1:"), "{lines:?}");
}
