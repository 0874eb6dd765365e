//! `basis explain` shows formulas, ends and exceptional sets exactly.

mod support;

use support::{BERNSTEIN, Folder, QUARTIC};

#[test]
fn the_quartic_family() {
    let run = Folder::with("q.basis", QUARTIC).run(&["explain", "q.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for line in [
        "b[1] = (3 + λ - λ*t)*t*(1 - t)^2",
        "b[2] = 3*t^2 - 3*t^3 + λ*t^3 - λ*t^4",
        "C'(0)  = (3 + λ)*(-P[0] + P[1])",
        "C''(1) = 6*(P[1] - (2 + λ)*P[2] + (1 + λ)*P[3])",
        "dependent at λ = -3",
        "    -3 <= λ <= 1\n",
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
}

#[test]
fn one_order_of_a_family() {
    let folder = Folder::with("b.basis", BERNSTEIN);
    let run = folder.run(&["explain", "b.basis", "Bern(n=3)"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout.starts_with("Bern(3):") && run.stdout.contains("C'(1)  = 3*(-P[2] + P[3])"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("independent for all shape values"), "{}", run.stdout);
    let run = folder.run(&["explain", "b.basis"]);
    assert!(run.stdout.starts_with("Bern(1):"), "{}", run.stdout);
}

#[test]
fn mistakes() {
    let folder = Folder::with("q.basis", QUARTIC);
    let run = folder.run(&["explain", "q.basis", "Quartic"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("Quartic"), "{}", run.stderr);
    assert_eq!(folder.run(&["explain", "missing.basis"]).code, 2);
}
