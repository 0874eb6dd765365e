//! `basis check --coq`: families on several spans, integrals, parameters with indices and assumptions.

use std::fs;

use crate::coq::{exported, refuses_in};
use crate::support::Folder;

/// Two spans of different lengths with a parameter and a denominator.
const SPANS: &str = "\
family Kernel {
    domain -1 <= t <= 0, 0 <= t <= 1;
    shape 0 <= k <= 1;
    let cap(r) = (1 - r)^2*(1 + 2*r) + k*r^2*(1 - r)^2;
    f[0] = cap(-t) | cap(t);
    prove nonnegative;
    prove symmetric;
    prove smooth(2);
    refute smooth(3);
    prove f[0] <= 1;
    prove integral(f[0]) = 1 + k/15;
    prove at t = 0 { f[0] = 1; D(f[0]) = 0; }
    refute at t = 1/2 { f[0] = 1/2; }
    refute f[0] >= k/2;
}
family Uneven {
    domain 0 <= x <= 1, 1 <= x <= 3;
    b[0] = 1/(1 + x) | (3 - x)/4;
    b[1] = x/(1 + x) | (1 + x)/4;
    prove partition_of_unity;
    prove smooth(1);
    refute smooth(2);
    prove D(b[1]) > 0;
}
";

/// Integrals over intervals, boxes and simplices, between bounds, of functions of a parameter, and below a sign.
const INTEGRALS: &str = "\
family Segment {
    domain -1 <= t <= 2;
    shape 1 <= k <= 2;
    b[0] = (1 + t)^2/k;
    prove integral(b[0]) = 9/k;
    prove integral(b[0], t, 0, k) = ((1 + k)^3 - 1)/(3*k);
    prove integral(k*t^2*b[0], t, -1, 0) >= 0;
    prove integral(D(b[0])) = b[0](2) - b[0](-1);
    refute integral(b[0]) <= 8;
}
family Wedge {
    domain triangle (u, v, w), 0 <= z <= 1;
    b[0] = u*v*(1 - z);
    b[1] = w^2*z;
    prove integral(b[0]) = 1/48;
    prove integral(b[1]) = 1/24;
    prove integral(w*b[0], z, 0, 1/2) = 3/8*u*v*w;
}
";

/// Parameters that share a name; an assumption, without which the equations hold as well.
const PARAMETERS: &str = "\
family Several {
    domain 0 <= t <= 1;
    shape 0 <= c[i] <= i for i in 1..=2;
    b[0] = (1 - t)*(1 + c[1]*t);
    b[1] = t - c[1]*t + c[1]*t^2 + (c[2] - c[2])*t;
    prove partition_of_unity;
    prove b[0] >= 0;
    prove at c = 0 { b = Bernstein(1); }
    prove at c[1] = 1 { b[0] = 1 - t^2; }
    refute b[1] = t;
}
family Assumed {
    domain 0 <= t <= 1;
    shape 0 <= k <= 1, 0 <= m <= 1;
    assume k <= m;
    b[0] = (1 + k*t)/(1 + m);
    prove (1 + m)*b[0] = 1 + k*t;
    prove b[0] <= 1;
}
family Below {
    domain 0 <= t <= 1;
    shape 0 <= k <= 1, 0 <= m <= 1;
    assume 1 <= k + m;
    b[0] = t/(k + m);
    prove (k + m)*b[0] = t;
}
";

#[test]
fn every_span_has_functions_of_its_own() {
    let folder = Folder::with("spans.basis", SPANS);
    let run = folder.run(&["check", "--coq", "v", "spans.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    let text = fs::read_to_string(folder.path().join("v/spans_Kernel.v")).expect("it is written");
    for part in [
        "Definition f_0_span_1 (k t : R) : R :=\n  (1 - (- t)) ^ 2 *",
        "Definition f_0_span_2 (k t : R) : R :=\n  (1 - t) ^ 2 *",
        "  0 <= k <= 1 ->\n  0 <= t <= 1 ->\n  f_0_span_2 k t >= 0.\n",
        "  f_0_span_1 k t = f_0_span_2 k (0 - t).\n",
        "  is_derive (fun x' => f_0_span_1 k x') 0 (Derive (fun x' => f_0_span_2 k x') 0).\n",
        "RInt (fun x' => f_0_span_1 k x') (-1) 0 + RInt (fun x' => f_0_span_2 k x') 0 1 = 1 + k / 15.\n",
    ] {
        assert!(text.contains(part), "`{part}` is not in\n{text}");
    }
}

#[test]
fn integrals_are_stated_as_such() {
    let folder = Folder::with("integrals.basis", INTEGRALS);
    let run = folder.run(&["check", "--coq", "v", "integrals.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    let text = |file| fs::read_to_string(folder.path().join("v").join(file)).expect("it is written");
    let (segment, wedge) = (text("integrals_Segment.v"), text("integrals_Wedge.v"));
    for part in [
        "  is_RInt (fun x' => b_0 k x') (-1) 2 (9 / k).\n",
        "  is_RInt (fun x' => b_0 k x') 0 k (((1 + k) ^ 3 - 1) / (3 * k)).\n",
        "  ~ (RInt (fun x' => b_0 k x') (-1) 2 <= 8).\n",
    ] {
        assert!(segment.contains(part), "`{part}` is not in\n{segment}");
    }
    let inner = "RInt (fun x''' => b_0 x'' x''' x' (1 - x'' - x''')) 0 (1 - x'')";
    let part = format!("  is_RInt (fun x' => RInt (fun x'' => {inner}) 0 1) 0 1 (1 / 48).\n");
    assert!(wedge.contains(&part), "{wedge}");
}

#[test]
fn parameters_share_a_name_and_equations_need_no_assumption() {
    let folder = Folder::with("own.basis", PARAMETERS);
    let run = folder.run(&["check", "--coq", "v", "own.basis"]);
    let last = "Coq: 7 theorems in 2 files, 2 claims not exported:
  own.basis:18: Assumed: `b[0] <= 1`: a claim under an assumption
  own.basis:25: Below: `(k + m)*b[0] = t`: a claim under an assumption\n";
    assert!(run.stdout.ends_with(last), "{}", run.stdout);
    let text = fs::read_to_string(folder.path().join("v/own_Several.v")).expect("it is written");
    for part in [
        "Definition b_0 (c_1 c_2 t : R) : R :=\n  (1 - t) * (1 + c_1 * t).\n",
        "  c_1 = 0 ->\n  c_2 = 0 ->\n  b_0 c_1 c_2 t = Bernstein_1_b_0 t.\n",
        "  c_1 = 1 ->\n  b_0 c_1 c_2 t = 1 - t ^ 2.\n",
    ] {
        assert!(text.contains(part), "`{part}` is not in\n{text}");
    }
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_parameters_that_share_a_name() {
    let folder = Folder::with("own.basis", PARAMETERS);
    folder.run(&["check", "--coq", "v", "own.basis"]);
    refuses_in(
        &folder,
        "own_Several.v",
        &[
            ("(1 - t) * (1 + c_1 * t)", "(1 - t) * (1 + c_2 * t)"),
            (
                "  0 <= c_1 <= 1 ->\n  0 <= c_2 <= 2 ->\n  0 <= t <= 1 ->\n  b_0 c_1 c_2 t >= 0",
                "  (-2) <= c_1 <= 1 ->\n  0 <= c_2 <= 2 ->\n  0 <= t <= 1 ->\n  b_0 c_1 c_2 t >= 0",
            ),
            ("  c_1 = 1 ->\n", "  c_2 = 1 ->\n"),
        ],
    );
    refuses_in(&folder, "own_Assumed.v", &[("= 1 + k * t.", "= 1 + m * t.")]);
}

/// A denominator that contains the variable has no antiderivative that Coq computes: listed.
#[test]
fn integrals_of_quotients_are_listed() {
    let spec = "family Quotient { domain 0 <= t <= 1; b[0] = 1/(1 + t)^2; prove integral(b[0]) = 1/2; }";
    let folder = Folder::with("quotient.basis", spec);
    let (code, said, text) = exported(&folder, "quotient.basis");
    assert_eq!(code, 1, "{said}");
    assert!(said.contains("`integral(b[0]) = 1/2`: an integral of a quotient\n"), "{said}");
    assert!(!text.contains("RInt"), "{text}");
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_spans() {
    let folder = Folder::with("spans.basis", SPANS);
    let run = folder.run(&["check", "--coq", "v", "spans.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    refuses_in(
        &folder,
        "spans_Kernel.v",
        &[
            // a coefficient of one span, the end of one, the knot, the other span, the integral, a witness
            ("f_0_span_2 (k t : R) : R :=\n  (1 - t) ^ 2", "f_0_span_2 (k t : R) : R :=\n  (1 - t) ^ 3"),
            ("  0 <= t <= 1 ->\n  f_0_span_2 k t >= 0.", "  0 <= t <= 2 ->\n  f_0_span_2 k t > 0."),
            ("f_0_span_1 k 0 = f_0_span_2 k 0", "f_0_span_1 k 1 = f_0_span_2 k 1"),
            ("f_0_span_1 k t = f_0_span_2 k (0 - t)", "f_0_span_1 k t = f_0_span_1 k (0 - t)"),
            ("= 1 + k / 15.", "= 1 + k / 16."),
        ],
    );
    refuses_in(
        &folder,
        "spans_Uneven.v",
        &[
            ("(3 - x) / 4", "(4 - x) / 4"),
            ("b_0_span_1 1 = b_0_span_2 1", "b_0_span_1 1 = b_1_span_2 2"),
            (
                "  1 <= x <= 3 ->\n  b_0_span_2 x + b_1_span_2 x = 1.",
                "  1 <= x <= 3 ->\n  b_0_span_2 x + b_1_span_1 x = 1.",
            ),
        ],
    );
}

#[test]
#[ignore = "needs Coq and Coquelicot"]
fn coq_accepts_integrals() {
    let folder = Folder::with("integrals.basis", INTEGRALS);
    let run = folder.run(&["check", "--coq", "v", "integrals.basis"]);
    assert_eq!(run.code, 0, "{run:?}");
    refuses_in(
        &folder,
        "integrals_Segment.v",
        &[
            // the value, a bound, the function, the range of a parameter by which is divided
            ("(-1) 2 (9 / k).", "(-1) 2 (8 / k)."),
            ("(fun x' => b_0 k x') 0 k (((1", "(fun x' => b_0 k x') 1 k (((1"),
            ("(1 + t) ^ 2 / k.", "(1 + t) ^ 3 / k."),
            (
                "  1 <= k <= 2 ->\n  (-1) <= t <= 2 ->\n  is_RInt",
                "  0 <= k <= 2 ->\n  (-1) <= t <= 2 ->\n  is_RInt",
            ),
        ],
    );
    refuses_in(&folder, "integrals_Wedge.v", &[("(1 / 48).", "(1 / 24)."), ("0 (1 / 2) (", "0 (1 / 3) (")]);
}
