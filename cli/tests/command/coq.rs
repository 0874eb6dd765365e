//! `basis check --coq`: what is written, and that Coq accepts it and refuses what is changed.
//!
//! The tests that run Coq are ignored unless they are asked for: `cargo test -p basis-cli --test command coq -- --ignored`.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::{Folder, QUARTIC};

/// A triangle with a quotient of shape parameters, a range without an end, and claims of all kinds.
const TRIANGLE: &str = "\
family Skew {
    domain triangle (u, v, w);
    shape 0 < p;
    b[0] = u^2 + p/(1 + p)*u*v;
    b[1] = v^2 + u*v/(1 + p);
    b[2] = w^2 + 2*u*w;
    b[3] = u*v + 2*v*w;
    prove partition_of_unity;
    prove nonnegative;
    prove at u = 1, v = 0 { D(b[0], u) = 2; b[0] = 1; b[3] = 0; }
    prove at w = 0 { b[0] + b[1] = 1 - b[3]; b[2] <= u; }
    prove D(b[0], p) >= 0;
    refute D(b[0], p) > 0;
    refute b[0] = u;
    refute b[1] < v;
}
";

/// Points of any space and points of the plane, curves and surfaces, and claims of all kinds.
const POINTS: [&str; 2] = [
    "\
join Next {
    curve P = Bernstein(3);
    curve Q = Bernstein(2);
    scalar 0 < f;
    let Q[0] = P[3];
    let Q[1] = Q[0] + 3*(P[3] - P[2])/(2*f);
    prove Q(0) == P(1);
    prove D(P)(1) == f*D(Q)(0);
    prove D(P)(1) parallel D(Q)(0);
    refute D(P, 2)(1) == f^2*D(Q, 2)(0);
    prove cross(D(P)(1), D(P, 2)(1)) == 18*cross(P[3] - P[2], P[1] - P[2]);
    refute cross(D(P)(1), D(P, 2)(1)) == 18*cross(P[3] - P[2], P[1]);
}
",
    "\
theorem Plane {
    scalar 0 <= c <= 1;
    scalar 0 <= t <= 1;
    curve P = Bernstein(2) [(0, 0), (1, 0), (c, 1)];
    curve R = Bernstein(1);
    surface S = Bernstein(1)(u) * Bernstein(2)(v);
    surface T = TriangularBernstein(2);
    prove cross(D(P)(t), D(P, 2)(t)) > 0;
    prove P(t)[0] >= 0;
    refute P(t)[0] <= 1/2;
    prove dot(D(P)(0), D(P)(0)) == 4;
    refute D(P)(1) == (2, 2);
    prove D(S, v)(0, 0) == 2*(S[0,1] - S[0,0]);
    prove D(S, u, v)(0, 1) == 2*(S[1,2] - S[1,1] - S[0,2] + S[0,1]);
    prove D(T, u)(1, 0, 0) == 2*(T[2,0,0] - T[1,0,1]);
    prove R(t)[0] - R[0][0] == t*(R[1][0] - R[0][0]);
}
",
];

/// The text of the only file with theorems.
pub(crate) fn exported(folder: &Folder, spec: &str) -> (i32, String, String) {
    let run = folder.run(&["check", "--coq", "v", spec]);
    let mut files: Vec<_> = fs::read_dir(folder.path().join("v"))
        .expect("a folder is written")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| path.extension().is_some_and(|e| e == "v") && !path.ends_with("Basis.v"))
        .collect();
    let file = files.pop().expect("a file is written");
    (run.code, run.stdout, fs::read_to_string(file).expect("it is text"))
}

/// Whether Coq accepts a file, and what it says.
pub(crate) fn accepted(folder: &Path, text: &str) -> (bool, String) {
    let coqc = |file: &str| {
        let run = Command::new("coqc").args(["-Q", ".", "Basis", file]).current_dir(folder).output();
        let run = run.expect("Coq is installed");
        (run.status.success(), String::from_utf8_lossy(&[run.stdout, run.stderr].concat()).into_owned())
    };
    if !folder.join("Basis.vo").exists() {
        let (fine, said) = coqc("Basis.v");
        assert!(fine, "{said}");
    }
    fs::write(folder.join("Tried.v"), text).expect("a file can be written");
    coqc("Tried.v")
}

/// A text with one place changed, which has to be there.
pub(crate) fn changed(text: &str, old: &str, new: &str) -> String {
    assert_ne!(old, new);
    assert!(text.contains(old), "`{old}` is not in\n{text}");
    text.replacen(old, new, 1)
}

/// Coq accepts a text, and none of the texts with one place changed.
pub(crate) fn refuses(folder: &Path, text: &str, changes: &[(&str, &str)]) {
    let (fine, said) = accepted(folder, text);
    assert!(fine, "{said}");
    for (old, new) in changes {
        let (fine, said) = accepted(folder, &changed(text, old, new));
        assert!(!fine, "`{new}` in place of `{old}` is accepted: {said}");
    }
}

/// The same of a file that was written to the folder `v`.
pub(crate) fn refuses_in(folder: &Folder, file: &str, changes: &[(&str, &str)]) {
    let folder = folder.path().join("v");
    let text = fs::read_to_string(folder.join(file)).expect("it is written");
    refuses(&folder, &text, changes);
}

/// Coq divides by t² − t as it is written, at 0 too, where the engine has t + 1: listed, and not written as a theorem that is
/// refused.
#[test]
fn quotients_in_lower_terms_than_written_are_listed() {
    let spec = |quotient: &str| {
        format!("family Quotient {{ domain 0 <= t <= 1; shape 0 < k; b[0] = {quotient}; prove b[0] >= 0; }}")
    };
    for (quotient, exported) in [
        ("(t^3 - t)/(t^2 - t)", false),
        ("t^2/(2*t)", false),
        ("k*t/(t/(1 + t))", false),
        ("(t^2 - k^2)/(t - k)/(1 + t)", false),
        ("(1 - t^2)/(-t - 1)/(t - 2)", true),
        ("(1 + t)^2/(1 + t)", true),
        ("k*t/(1 + k*t)^2", true),
        ("1/(1 + t/(1 + k))", true),
    ] {
        let folder = Folder::with("quotient.basis", &spec(quotient));
        let run = folder.run(&["check", "--coq", "v", "quotient.basis"]);
        let listed = run.stdout.contains("`b[0] >= 0`: a quotient that is brought into lowest terms");
        assert_eq!((run.code, listed), (i32::from(!exported), !exported), "{quotient}: {}", run.stdout);
    }
}

#[test]
fn theorems_are_about_the_formulas_as_they_are_written() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let (code, said, text) = exported(&folder, "quartic.basis");
    assert_eq!(code, 0, "{said}");
    assert!(said.contains("Coq: 16 theorems in 1 file\n"), "{said}");
    for part in [
        "Definition b_0 (λ t : R) : R :=\n  (1 - λ * t) * (1 - t) ^ 3.\n",
        "(** Line 11: prove partition_of_unity. *)\n",
        "  -3 <= λ <= 1 ->\n  0 <= t <= 1 ->\n  b_0 λ t + b_1 λ t + b_2 λ t + b_3 λ t = 1.\n",
        "  t = 0 ->\n  is_derive (fun x' => b_0 λ x') t (- (3 + λ)).\n",
        "  λ = 0 ->\n  b_0 λ t = Bernstein_3_b_0 t.\n",
        "exists λ t : R,\n",
        "  ~ (b_0 λ t = b_1 λ t).\n",
        "Print Assumptions all'theorems.\n",
    ] {
        assert!(text.replace("(-3)", "-3").contains(part), "`{part}` is not in\n{text}");
    }
}

#[test]
fn what_has_no_counterpart_is_listed() {
    let spec = "theorem T { curve P = Bernstein(2); prove P(0) == P[0]; prove integral(P(t), t, 0, 1) == (P[0] + P[1] + P[2])/3; }\n";
    let folder = Folder::with("t.basis", &format!("{QUARTIC}{spec}"));
    let run = folder.run(&["check", "--coq", "v", "t.basis"]);
    assert_eq!(run.code, 1, "{run:?}");
    let last = "Coq: 17 theorems in 2 files, 1 claim not exported:\n  t.basis:17: theorem T: `integral(P(t), t, 0, 1) == (P[0] + P[1] + P[2])/3`: a formula that cannot be stated in Coq yet\n";
    assert!(run.stdout.ends_with(last), "{}", run.stdout);
    let project = fs::read_to_string(folder.path().join("v/_CoqProject")).expect("it is written");
    assert!(project.ends_with("Basis.v\nt_QuarticBernstein.v\nt_T.v\n"), "{project}");
}

#[test]
fn with_json_standard_output_is_one_value() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let run = folder.run(&["check", "--format", "json", "--coq", "v", "quartic.basis"]);
    assert_eq!(run.stderr, "Coq: 16 theorems in 1 file\n");
    assert!(run.json()["files"].is_array());
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_theorems_and_refuses_changed_ones() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let (_, _, text) = exported(&folder, "quartic.basis");
    let folder = folder.path().join("v");
    refuses(
        &folder,
        &text,
        &[
            // a coefficient of the formula, of the data, and of both
            ("(1 - λ * t) * (1 - t) ^ 3", "(1 - λ * t) * (1 - t) ^ 2"),
            ("(Pow (Diff (Num (1)) (Var 1)) 3)", "(Pow (Diff (Num (1)) (Var 1)) 2)"),
            // what is claimed
            ("b_0 λ t + b_1 λ t + b_2 λ t + b_3 λ t = 1.", "b_0 λ t + b_1 λ t + b_2 λ t + b_3 λ t = 2."),
            ("is_derive (fun x' => b_0 λ x') t (- (3 + λ))", "is_derive (fun x' => b_0 λ x') t (3 + λ)"),
            ("b_0 λ t = b_3 λ", "b_1 λ t = b_3 λ"),
            // where it is claimed
            ("  t = 0 ->\n  b_0 λ t = 1.", "  t = 1 ->\n  b_0 λ t = 1."),
            ("  λ = 0 ->\n", "  λ = 1 ->\n"),
        ],
    );
    // both, so that the data are those of the formula
    let text = changed(&text, "(1 - λ * t) * (1 - t) ^ 3", "(1 - λ * t) * (1 - t) ^ 2");
    let text = changed(&text, "(Pow (Diff (Num (1)) (Var 1)) 3)", "(Pow (Diff (Num (1)) (Var 1)) 2)");
    assert!(!accepted(&folder, &text).0);
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_quotients_and_simplices() {
    let folder = Folder::with("skew.basis", TRIANGLE);
    let (code, said, text) = exported(&folder, "skew.basis");
    assert_eq!(code, 0, "{said}");
    let folder = folder.path().join("v");
    let claimed = |line: &str| text.contains(line);
    assert!(claimed("u + v + w = 1 ->") && claimed("0 < p ->"), "{text}");
    let changes = [
        // a quotient that vanishes somewhere, a sign and a range that are too much
        ("(Quot (Var 0) (Sum (Num (1)) (Var 0)))", "(Quot (Var 0) (Diff (Num (1)) (Var 0)))"),
        ("  b_0 p u v w >= 0.", "  b_0 p u v w >= 1."),
        ("  0 < p ->\n", "  (-1) < p ->\n"),
        ("  w = 0 ->\n", "  w = 1 ->\n"),
    ];
    refuses(&folder, &text, &changes);
    // The point of a refutation: another one at which the equation holds, and one outside of the domain.
    let at = text.find("~ (b_0 p u v w = u)").expect("it is refuted");
    let (before, after) = text.split_at(at);
    let start = after.find("exists ").expect("a point is given");
    let end = start + after[start..].find(".\n").expect("it ends");
    for point in ["exists 1, 0, 0, 1", "exists 1, 2, (-1), 0"] {
        let text = format!("{before}{}{point}{}", &after[..start], &after[end..]);
        assert!(!accepted(&folder, &text).0, "`{point}` is accepted");
    }
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_independence_and_no_smaller_list_of_exceptions() {
    let spec = "\
family Pair {
    domain -1 <= t <= 2;
    shape -1 <= k <= 1;
    b[0] = (1 + k^2)*t + k;
    b[1] = t^2 - 1;
    b[2] = k*(k - 1/2)*t^3 + t^2 - 1;
    refute independent;
    prove independent except k = 0, k = 1/2;
}
";
    let folder = Folder::with("pair.basis", spec);
    let (code, said, text) = exported(&folder, "pair.basis");
    assert_eq!(code, 0, "{said}");
    assert!(text.contains("a'0 * b_0 k t + a'1 * b_1 k t + a'2 * b_2 k t = 0"), "{text}");
    let folder = folder.path().join("v");
    refuses(
        &folder,
        &text,
        &[
            // an exception less, another range, other functions, another dependence
            ("  ~ (k = 0) ->\n", ""),
            ("  (-1) <= k <= 1 ->\n  ~ (k = 0)", "  (-1) <= k ->\n  ~ (k = 0)"),
            ("a'1 * b_1 k t + a'2 * b_2 k t = 0) ->", "a'1 * b_1 k t + a'2 * b_1 k t = 0) ->"),
            ("  k = (1 / 2) ->\n", "  k = (1 / 3) ->\n"),
        ],
    );
}

#[test]
fn theorems_about_points_are_about_their_coordinates() {
    let [join, plane] = POINTS.map(|spec| {
        let folder = Folder::with("points.basis", spec);
        let (code, said, text) = exported(&folder, "points.basis");
        assert_eq!(code, 0, "{said}");
        text
    });
    for part in [
        "  forall (f : R) (P_0 P_1 P_2 P_3 Q_2 : nat -> R),\n  0 < f ->\n  forall i : nat, is_derive",
        "  exists f' : R, 0 < f' /\\ forall i : nat, Derive",
        "  forall i j : nat, ",
        "  exists i : nat, ~ (",
    ] {
        assert!(join.contains(part), "`{part}` is not in\n{join}");
    }
    for part in ["  forall (c t : R),\n  0 <= c <= 1 ->\n  0 <= t <= 1 ->\n  ", "S_0_1_x", "T_2_0_0_y"] {
        assert!(plane.contains(part), "`{part}` is not in\n{plane}");
    }
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_theorems_about_points() {
    let changes: [&[(&str, &str)]; 2] = [
        &[
            // a factor, a control point, a range, the number of a coordinate
            ("3 * (P_3 i - P_2 i) / (2 * f)", "2 * (P_3 i - P_2 i) / (2 * f)"),
            ("0 < f ->\n  forall i : nat, is_derive", "0 <= f ->\n  forall i : nat, is_derive"),
            ("exists (f / 1)", "exists (f / 2)"),
            ("18 * ((P_3 i - P_2 i) * (P_1 j", "18 * ((P_3 i - P_2 i) * (P_1 i"),
        ],
        &[
            ("2 * (S_0_1_x - S_0_0_x)", "2 * (S_0_1_y - S_0_0_x)"),
            ("Bernstein_2_b_2 t * c >= 0", "Bernstein_2_b_2 t * c >= 1"),
        ],
    ];
    for (spec, changes) in POINTS.into_iter().zip(changes) {
        let folder = Folder::with("points.basis", spec);
        let (_, _, text) = exported(&folder, "points.basis");
        let folder = folder.path().join("v");
        refuses(&folder, &text, changes);
    }
}

/// An angle with a shape parameter, and another one as a multiple of pi.
const ANGLE: &str = "\
family Quarter {
    domain 0 <= θ <= pi/2;
    shape -1 <= λ <= 1;
    b[0] = (1 - sin(θ))*(1 - λ*sin(θ));
    b[1] = (1 + λ)*(sin(θ) + cos(θ) - 1);
    b[2] = 1 - b[0] - b[1];
    prove partition_of_unity;
    prove nonnegative;
    prove D(b[0]) <= 0;
    prove at θ = pi/2 { b = [0, 0, 1]; D(b[2], 2) = 2*λ; }
    prove sin(2*θ) = 2*sin(θ)*cos(θ);
    refute independent;
    prove independent except λ = -1;
    prove symmetric;
    refute b[0] >= b[1];
    refute D(b[1]) >= 0;
    refute at θ = pi/2 { b[2] = λ; }
}
family Turn {
    domain 0 <= t < 1;
    b[0] = (1 - cos(pi*t/2))/(1 + cos(pi*t/2));
    prove nonnegative;
    prove D(b[0])(0) = 0;
    prove b[0] < 1;
    prove independent;
    refute b[0] >= 1/3;
}
";

/// Signs that are shown by factors, by corners, and by coefficients of a higher degree than those of a part have, products of
/// domains, and independence of functions over different denominators.
const OTHERS: &str = "\
family Signs {
    domain 0 <= t <= 1;
    shape 0 <= k;
    shape -1 <= m <= 2;
    b[0] = 1/(1 + t);
    b[1] = t/(2 + t) + k;
    b[2] = 1/(1 + k + t);
    prove (3*t - 1)^2*(2 + m*t)*(1 + k) >= 0;
    prove (3*t - 1)^2/(1 + k*t) >= 0;
    prove -(3*t - 1)^2*(m - 2) >= 0;
    prove (m + 1)*(t - k)^2 + (2 - m)*(3*t - k)^2 >= 0;
    prove independent except k = 0;
}
family Degrees {
    domain 0 <= t <= 1;
    shape 0 <= k <= 1;
    b[0] = (1 - k)*(t^2 - t + 2/5) + k*t^4;
    prove b[0] >= 0;
}
family Prism {
    domain triangle (u, v, w), -1 <= z <= 2;
    shape 1 <= k <= 2;
    let low = (2 - z)/3;
    b[1,0,0,0] = u*low;
    b[0,1,0,0] = v*low;
    b[0,0,1,0] = w*low;
    b[1,0,0,1] = u*(1 - low);
    b[0,1,0,1] = v*(1 - low);
    b[0,0,1,1] = w*(1 - low);
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove k*u*v <= 1/2 + z + 1;
    prove at w = 0 { b[1,0,0,0] + b[0,1,0,0] = low; }
    prove at z = 2, u = 1 { b[1,0,0,1] = 1; D(b[1,0,0,1], z) = 1/3; }
    refute b[1,0,0,0] >= b[0,1,0,0];
}
family Tension {
    domain 0 <= t <= 1;
    shape 0 < r;
    b[0] = t*(1 - t)^2/((1 - t)^3 + t^3 + r*t*(1 - t));
    prove b[0] >= 0;
}
family Plane {
    domain triangle (u, v, w);
    shape 0 <= k;
    b[1,0,0] = u;
    b[0,1,0] = v;
    b[0,0,1] = w;
    prove (3*u - 1)^2*(1 + k*v) >= 0;
    prove (3*u - 1)^2 + k*(3*v - w)^2 >= 0;
}
family Free {
    domain 0 <= t <= 1;
    shape p, q, r;
    b[0] = p*t;
    b[1] = q - r*t;
    prove p^2 + q^2 + r^2 >= p*q + q*r + r*p;
    prove p^2 - 2*p*q + 3*q^2 + 1 > 0;
}
";

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_factors_corners_and_different_denominators() {
    let folder = Folder::with("others.basis", OTHERS);
    let run = folder.run(&["check", "--coq", "v", "others.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    let changes: [(&str, &[(&str, &str)]); 6] = [
        ("others_Free.v", &[("(Plus (3 # 4)", "(Plus (2 # 4)"), ("(Plus (1 # 3)", "(Plus (-1 # 3)")]),
        ("others_Degrees.v", &[("  0 <= k <= 1 ->\n", "  0 <= k <= 2 ->\n")]),
        (
            "others_Prism.v",
            &[
                // the sum of the coordinates, the range of the last one, a function, a face
                ("  u + v + w = 1 ->\n  b_0_0_1_0 k", "  u + v + w = 2 ->\n  b_0_0_1_0 k"),
                ("  (-1) <= z <= 2 ->\n  0 <= u ->", "  (-1) <= z <= 3 ->\n  0 <= u ->"),
                ("a'5 * b_1_0_0_1 k u v z w = 0) ->", "a'5 * b_0_1_0_1 k u v z w = 0) ->"),
                ("  w = 0 ->\n", "  w = 1 ->\n"),
            ],
        ),
        ("others_Tension.v", &[("(Corner 0 ", "(Corner 1 "), ("  b_0 r t >= 0.", "  b_0 r t > 0.")]),
        (
            "others_Signs.v",
            &[
                // a factor, a corner, the range of a parameter, the common denominator, a numerator, an exception less
                ("(Square (P [P [P [C (-1); C (3)]]])", "(Square (P [P [P [C (-1); C (2)]]])"),
                ("(Corner 1 ", "(Corner 0 "),
                ("  (-1) <= m <= 2 ->\n", "  (-4) <= m <= 2 ->\n"),
                ("(P [P [C (2); C (2)]; P [C (5); C (3)]", "(P [P [C (2); C (2)]; P [C (5); C (4)]"),
                (
                    "[P [P [C (2); C (2)]; P [C (3); C (1)]; C (1)]",
                    "[P [P [C (2); C (2)]; P [C (3); C (2)]; C (1)]",
                ),
                ("  ~ (k = 0) ->\n", ""),
            ],
        ),
        ("others_Plane.v", &[("(Corner 0 ", "(Corner 1 "), ("  0 <= k ->\n", "  (-2) <= k ->\n")]),
    ];
    for (file, changes) in changes {
        refuses_in(&folder, file, changes);
    }
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_angles() {
    let folder = Folder::with("angle.basis", ANGLE);
    let run = folder.run(&["check", "--coq", "v", "angle.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(run.stdout.ends_with("Coq: 23 theorems in 2 files\n"), "{}", run.stdout);
    let changes: [(&str, &[(&str, &str)]); 2] = [
        (
            "angle_Quarter.v",
            &[
                // the function, its form in tangents, the range of the angle and of the parameter, the place, the slope
                ("(1 - sin θ) * (1 - λ * sin θ)", "(1 - sin θ) * (1 - λ * cos θ)"),
                ("(1 - 2 * x / (1 + x ^ 2)) * (1", "(1 - 2 * x / (2 + x ^ 2)) * (1"),
                ("  0 <= θ <= (1 / 2) * PI ->\n  b_0 λ θ >= 0", "  0 <= θ <= 2 * PI ->\n  b_0 λ θ >= 0"),
                (
                    "  (-1) <= λ <= 1 ->\n  0 <= θ <= (1 / 2) * PI ->\n  b_1 λ θ >= 0",
                    "  (-2) <= λ <= 1 ->\n  0 <= θ <= (1 / 2) * PI ->\n  b_1 λ θ >= 0",
                ),
                ("b_2 λ θ = 1.", "b_2 λ θ = 2."),
                ("θ = 2 * λ.", "θ = 3 * λ."),
                // an exception less, another one, other functions, another end, another point
                ("  ~ (λ = (-1)) ->\n", ""),
                ("  λ = (-1) ->\n", "  λ = 1 ->\n"),
                ("a'1 * b_1 λ θ + a'2 * b_2 λ θ = 0) ->", "a'1 * b_1 λ θ + a'2 * b_1 λ θ = 0) ->"),
                ("b_0 λ θ = b_2 λ ((1 / 2) * PI - θ)", "b_0 λ θ = b_2 λ ((1 / 3) * PI - θ)"),
                ("  ~ (b_0 λ θ >= b_1 λ θ)", "  ~ (b_0 λ θ <= b_1 λ θ)"),
                ("  exists 0, t'.\n", "  exists 2, t'.\n"),
            ],
        ),
        (
            "angle_Turn.v",
            &[
                ("  0 <= t < 1 ->\n  b_0 t < 1.", "  0 <= t <= 1 ->\n  b_0 t < 1."),
                ("  exists 0.\n", "  exists 1.\n"),
            ],
        ),
    ];
    for (file, changes) in changes {
        refuses_in(&folder, file, changes);
    }
}
