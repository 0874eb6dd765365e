//! Families with a domain variable below the fraction line, from the spec to verdicts, explanations, values and
//! certificates.

use crate::support::Folder;

const CONIC: &str = "
family Conic {
    domain 0 <= t <= 1;
    shape 0 < w;
    let d = (1 - t)^2 + 2*w*t*(1 - t) + t^2;
    b[0] = (1 - t)^2/d;
    b[1] = 2*w*t*(1 - t)/d;
    b[2] = t^2/d;
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at t = 0 { D(b) = [-2*w, 2*w, 0]; D(b, 2)[2] = 2; }
    refute at t = 1 { D(b) = [0, -2, 2]; }
    refute D(b[1]) >= 0;
    refute b[1] <= 2/3;
    refute independent except w = 1;
}
";

/// What is true of one function at one end or for one shape value only.
const SUBTLE: &str = "
family Subtle {
    domain 0 <= t <= 2;
    shape 0 <= a <= 1;
    b[0] = 1/(1 + t);
    b[1] = (1 + a*t)/(1 + t);
    b[2] = 1/(2 + t);
    prove independent except a = 0;
    refute independent;
    prove b[0] >= 1/3;
    refute b[0] > 1/3;
    refute b[0] >= 334/1000;
    prove b[0] - b[2] = b[0]*b[2];
    refute b[0] - b[2] = b[0]*b[1];
    prove D(b[0]) = -b[0]^2;
    prove b[1] <= 1;
    refute b[1] < 1;
    refute continuity(0);
}
";

fn checked(spec: &str) -> String {
    let run = Folder::with("s.basis", spec).run(&["check", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
    run.stdout
}

#[test]
fn claims_about_quotients() {
    let table = checked(CONIC);
    assert!(table.contains("D(b[1]) = -2 at w = 1, t = 1"), "{table}");
    assert!(table.contains("independent at w = 1") || table.contains("at w = 1"), "{table}");
    let table = checked(SUBTLE);
    assert!(table.contains("b[0] - 1/3 = 0 at") && table.contains("t = 2"), "{table}");
    assert!(table.contains("b[0] - b[1] = 0 at a = 0"), "{table}");
}

#[test]
fn exact_quotients_are_polynomials() {
    let table = checked(
        "family Exact {
            domain 0 <= t <= 1;
            shape 0 <= c <= 1;
            b[0] = (t^3 - t)/(t^2 - t);
            b[1] = (t^3 - c^3)/(t - c);
            prove b[0] = 1 + t;
            prove at t = 0 { b[0] = 1; b[1] = c^2; }
            prove at t = c { b[1] = 3*c^2; }
            prove b[1](1/2) = 1/4 + c/2 + c^2;
        }",
    );
    assert!(table.contains("2 functions of degree 2"), "{table}");
}

#[test]
fn on_simplices_and_boxes() {
    checked(
        "family Triangle {
            domain triangle (u, v, w);
            let q = 1 + u*v + v*w + u*w;
            permute b[1,0,0] = u/q;
            prove nonnegative;
            prove symmetric;
            prove independent;
            prove sum(b) = 1/q;
            refute sum(b) >= 4/5;
            prove sum(b) >= 3/4;
            refute sum(b) > 3/4;
        }
        family Square {
            domain 0 <= u <= 1, 0 <= v <= 1;
            b[0,0] = 1/(1 + u + v);
            b[1,0] = u/(1 + u + v);
            b[0,1] = v/(1 + u + v);
            b[1,1] = 0*u;
            prove partition_of_unity;
            prove nonnegative;
            refute independent;
            prove D(b[0,0], u) = -b[0,0]^2;
        }",
    );
}

#[test]
fn curves_in_theorems() {
    checked(&format!(
        "{CONIC}
        theorem Ends {{
            curve P = Conic(k);
            prove P(0) == P[0];
            prove D(P)(0) == 2*k*(P[1] - P[0]);
            refute D(P)(1) == 2*k*(P[1] - P[2]);
            prove D(P)(1) parallel P[2] - P[1];
        }}"
    ));
}

#[test]
fn explained() {
    let run = Folder::with("c.basis", CONIC).run(&["explain", "c.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for line in [
        "b[1] = 2*w*t*(1 - t)/(1 - 2*t + 2*w*t + 2*t^2 - 2*w*t^2)",
        "C'(0)  = 2*w*(-P[0] + P[1])",
        "Q[1] = -w_P/w_Q*P[1] + (w_P + w_Q)/w_Q*P[2]",
        "independent for all shape values",
        "    0 <= w\n", // at w = 0 the denominator is positive as well
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
}

#[test]
fn evaluated() {
    let folder = Folder::with("c.basis", CONIC);
    let arguments = ["--shape", "w=1/2", "--at", "t=1/3", "--order", "2", "--format", "json"];
    let run = folder.run(&[&["eval", "c.basis", "Conic"], &arguments[..]].concat());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let json: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    // With d = 1 - t + t^2 at w = 1/2: b[2] = t^2/d, d = 7/9, d' = -1/3, d'' = 2 at t = 1/3.
    assert_eq!(json["values"]["b[2]"], "1/7");
    assert_eq!(json["derivatives"]["D(b[2])"], "45/49");
    assert_eq!(json["derivatives"]["D(b[2],2)"], "1026/343");
}

#[test]
fn certificates_are_verified_and_those_of_other_claims_are_not() {
    let spec = format!("{CONIC}{SUBTLE}");
    let folder = Folder::with("s.basis", &spec);
    let written = folder.run(&["check", "--certificates", "proofs", "s.basis"]);
    assert_eq!(written.code, 0, "{}", written.stderr);
    let verified = folder.run(&["verify", "proofs", "s.basis"]);
    assert_eq!(verified.code, 0, "{}{}", verified.stdout, verified.stderr);
    // The same certificates for a family with a wrong weight.
    let folder = folder.and("s.basis", spec.replace("b[1] = 2*w*t*(1 - t)/d", "b[1] = 2*t*(1 - t)/d"));
    let refused = folder.run(&["verify", "proofs", "s.basis"]);
    assert_ne!(refused.code, 0, "{}", refused.stdout);
}
