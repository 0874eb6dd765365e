//! Families with sin, cos and exp: verdicts, counterexamples, explanations, values and certificates.

use crate::support::Folder;

const QUARTER: &str = "
family Quarter {
    domain 0 <= θ <= pi/2;
    b[0] = 1 - sin(θ);
    b[1] = sin(θ) + cos(θ) - 1;
    b[2] = 1 - cos(θ);
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at θ = 0 { b = [1, 0, 0]; D(b) = [-1, 1, 0]; }
    prove at θ = pi/2 { b = [0, 0, 1]; D(b) = [0, -1, 1]; }
    prove (b[0] + b[1])^2 + (b[1] + b[2])^2 = 1;
    prove D(b, 2)[0] = sin(θ);
    prove sin(3*θ) = 3*sin(θ) - 4*sin(θ)^3;
    refute sin(3*θ) = 3*sin(θ) - 3*sin(θ)^3;
    prove b[1] <= 41422/100000;
    refute b[1] <= 41421/100000;
    refute b[0] > 0;
    refute D(b[1]) >= 0;
    prove b[0](pi/2 - θ) = b[2];
    refute b[0](-θ) = b[0];
}
";

const UNIT: &str = "
family Unit {
    domain 0 <= t <= 1;
    b[0] = 1 - sin(pi*t/2);
    b[1] = sin(pi*t/2) + cos(pi*t/2) - 1;
    b[2] = 1 - cos(π*t/2);
    prove partition_of_unity;
    prove symmetric;
    prove at t = 0 { D(b) = [-pi/2, pi/2, 0]; }
    refute at t = 0 { D(b) = [-157/100, 157/100, 0]; }
    prove D(b, 2)[0] = pi^2/4*sin(pi*t/2);
    prove D(b[2]) >= 0;
    refute D(b[1]) >= 0;
    prove D(b[2]) <= 158/100;
    prove pi > 314159/100000;
    prove D(b[2]) < 22/7;
}
";

const END: &str = "
family End {
    shape 0 < α < pi;
    domain 0 <= t <= α;
    b[0] = (1 - cos(α - t))/(1 - cos(α));
    b[1] = 1 - b[0] - b[2];
    b[2] = (1 - cos(t))/(1 - cos(α));
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove at t = 0 { D(b) = 1/tan(α/2)*[-1, 1, 0]; }
    refute at t = 0 { D(b) = 1/sin(α)*[-1, 1, 0]; }
    prove at t = α { b = [0, 0, 1]; D(b)[2] = sin(α)/(1 - cos(α)); }
    prove at α = pi/2 { b[2] = 1 - cos(t); }
    prove b[1]^2 = 2*(1 + cos(α))*b[0]*b[2];
    prove D(b[2], t) >= 0;
    prove D(b[2], α) <= 0;
    refute D(b[2], α) >= 0;
    refute b[1] <= 1/3;
}
";

const HYPERBOLIC: &str = "
family Hyperbolic {
    shape 0 < α;
    domain 0 <= t <= α;
    b[0] = sinh(α - t)/sinh(α);
    b[1] = sinh(t)/sinh(α);
    prove nonnegative;
    prove symmetric;
    prove independent;
    refute partition_of_unity;
    prove sum(b) <= 1;
    prove D(b, 2) = b;
    prove at t = 0 { D(b) = [-1/tanh(α), 1/sinh(α)]; }
    prove exp(t) >= 1;
    refute exp(t) > 1;
    refute b[1] <= 1/2;
}
family Fixed {
    domain 0 <= t <= 1;
    b[0] = (exp(1) - exp(t))/(exp(1) - 1);
    b[1] = (exp(t) - 1)/(exp(1) - 1);
    prove partition_of_unity;
    prove nonnegative;
    prove independent;
    refute symmetric;
    prove at t = 0 { D(b) = [-1, 1]/(exp(1) - 1); }
    refute at t = 0 { D(b) = [-1, 1]/17*10; }
    prove at t = 1/2 { b[1] = 1/(1 + exp(1/2)); }
    prove D(b[1]) <= 159/100;
}
";

fn checked(spec: &str) -> String {
    let run = Folder::with("s.basis", spec).run(&["check", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
    run.stdout
}

#[test]
fn quarter_turns() {
    let table = checked(QUARTER);
    assert!(table.contains("domain 0 <= θ <= pi/2"), "{table}");
    assert!(table.contains("tan(θ/2) = "), "{table}");
}

#[test]
fn a_denominator_with_an_angle_beside_its_sine_has_no_false_zero() {
    // α - sin(α) is positive; as a polynomial in α and tan(α/2), taken apart, it has zeros.
    let spec = "family Beside {
        shape 0 < α < pi;
        domain 0 <= t <= α;
        b[0] = cos(t/2)/(α - sin(α));
        prove b[0] >= 0;
    }";
    let run = Folder::with("s.basis", spec).run(&["check", "s.basis"]);
    assert!(!run.stderr.contains("the denominator vanishes at"), "{}", run.stderr);
}

#[test]
fn the_angle_as_a_multiple_of_the_variable() {
    let table = checked(UNIT);
    // The value is exact, with pi.
    assert!(table.contains("157/100 - 1/2*pi at t = 0"), "{table}");
}

#[test]
fn the_end_as_a_parameter() {
    let table = checked(END);
    assert!(table.contains("domain 0 <= t <= α; shape 0 < α < pi"), "{table}");
}

#[test]
fn exponentials() {
    checked(HYPERBOLIC);
}

#[test]
fn half_turns_and_shifted_ends() {
    checked(
        "family Half {
            domain 0 <= θ <= pi;
            b[0] = (1 + cos(θ))/2;
            b[1] = (1 - cos(θ))/2;
            prove nonnegative;
            prove symmetric;
            prove at θ = pi/2 { b[0] = 1/2; D(b)[0] = -1/2; }
            prove at θ = pi { b = [0, 1]; D(b) = 0; }
        }
        family Second {
            domain pi/2 <= θ <= pi;
            b[0] = sin(θ);
            b[1] = -cos(θ);
            prove nonnegative;
            prove symmetric;
            refute sin(θ) >= 1/2;
        }
        family Turn {
            domain -pi <= θ <= pi;
            b[0] = cos(θ/2);
            b[1] = 1 + sin(θ);
            prove nonnegative;
            refute b[0] > 0;
            prove at θ = pi { b = [0, 1]; }
        }
        family Tangent {
            domain 0 <= θ < pi/2;
            b[0] = tan(θ);
            prove b[0] >= 0;
            prove D(b[0]) = 1 + tan(θ)^2;
            refute b[0] <= 1000;
        }",
    );
}

#[test]
fn explained_in_sines() {
    let run = Folder::with("s.basis", END).run(&["explain", "s.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for line in ["b[2] = (1 - cos(t))/(1 - cos(α))", "C(α)", "independent for all shape values"] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
}

#[test]
fn evaluated_at_tangents() {
    let folder = Folder::with("s.basis", QUARTER);
    let run = folder.run(&[
        "eval",
        "s.basis",
        "Quarter",
        "--at",
        "tan(θ/2)=1/2",
        "--order",
        "1",
        "--format",
        "json",
    ]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let json: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    // sin = 4/5, cos = 3/5
    assert_eq!(json["values"]["b[0]"], "1/5");
    assert_eq!(json["values"]["b[1]"], "2/5");
    assert_eq!(json["derivatives"]["D(b[0])"], "-3/5");
}

/// Compared with sin, cos and exp of the standard library.
#[test]
fn evaluated_at_angles() {
    let folder = Folder::with("s.basis", &[QUARTER, UNIT, END, HYPERBOLIC].concat())
        .and("mixed.basis", "family Mixed { domain 0 <= t <= pi/2; b[0] = t - sin(t); b[1] = t; }")
        .and("length.basis", "family L { shape 0 < h; domain 0 <= t <= h; b[0] = 1 - t/h; b[1] = t^2/h; }");
    let eval = |file: &str, family: &str, rest: &[&str]| {
        let run = folder.run(&[&["eval", file, family, "--format", "json", "--order", "1"], rest].concat());
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{family} {rest:?}");
        run.json()
    };
    let near = |json: &serde_json::Value, key: &str, expected: f64| {
        let all = if key.starts_with('D') { &json["derivatives"] } else { &json["values"] };
        let value: f64 = all[key].as_str().expect("a value").parse().expect("a decimal");
        assert!((value - expected).abs() < 1e-15, "{key}: {value} {expected}");
    };
    let quarter = eval("s.basis", "Quarter", &["--at", "θ=1/3"]);
    near(&quarter, "b[0]", 1.0 - (1.0_f64 / 3.0).sin());
    near(&quarter, "D(b[1])", (1.0_f64 / 3.0).cos() - (1.0_f64 / 3.0).sin());
    // Rational values stay exact.
    assert_eq!(eval("s.basis", "Quarter", &["--at", "θ=pi/2"])["values"]["b[1]"], "0");
    let unit = eval("s.basis", "Unit", &["--at", "t=1/3"]);
    near(&unit, "b[2]", 1.0 - (std::f64::consts::PI / 6.0).cos());
    near(&unit, "D(b[2])", std::f64::consts::FRAC_PI_2 * (std::f64::consts::PI / 6.0).sin());
    let end = eval("s.basis", "End", &["--shape", "α=2", "--at", "t=5/4"]);
    near(&end, "b[2]", (1.0 - 1.25_f64.cos()) / (1.0 - 2.0_f64.cos()));
    near(&end, "D(b[2])", 1.25_f64.sin() / (1.0 - 2.0_f64.cos()));
    let hyperbolic = eval("s.basis", "Hyperbolic", &["--shape", "α=2", "--at", "t=2"]);
    assert_eq!(hyperbolic["values"], serde_json::json!({"b[0]": "0", "b[1]": "1"}));
    let fixed = eval("s.basis", "Fixed", &["--at", "t=1/5"]);
    near(&fixed, "b[1]", 0.2_f64.exp_m1() / 1.0_f64.exp_m1());
    // A variable beside its sine: small differences keep their digits.
    let mixed = eval("mixed.basis", "Mixed", &["--at", "t=1/1000"]);
    let small: f64 = mixed["values"]["b[0]"].as_str().expect("a value").parse().expect("a decimal");
    assert!((small / 1.666_666_583_333_335e-10 - 1.0).abs() < 1e-15, "{small}");
    let length = eval("length.basis", "L", &["--shape", "h=3", "--at", "t=2"]);
    assert_eq!(length["values"], serde_json::json!({"b[0]": "1/3", "b[1]": "4/3"}));
    assert_eq!(length["derivatives"]["D(b[1])"], "4/3");
    let run = folder.run(&["eval", "length.basis", "L", "--shape", "h=3", "--at", "t=4"]);
    assert!(run.stderr.contains("t = 4 is outside of the domain `0 <= t <= h`"), "{}", run.stderr);
}

/// Small values are not taken for what is left of terms that cancel, and these not for values.
#[test]
fn small_values_have_digits_and_cancelled_terms_have_none() {
    let spec = "family E { domain 0 <= t <= 200; b[0] = exp(-t); b[1] = exp(-t) - exp(-200); }
        family S { domain 0 <= t <= pi; b[0] = sin(t)^20; b[1] = 1 + cos(t); b[2] = 1 - cos(t)^2 - sin(t)^2; }
        family H { shape 0 < α; domain 0 <= t <= α; b[0] = (cosh(t) - 1)/(cosh(α) - 1); b[1] = exp(t) - exp(α); }";
    let folder = Folder::with("s.basis", spec);
    let value = |family: &str, function: &str, at: &[&str]| -> f64 {
        let run = folder.run(&[&["eval", "s.basis", family, "--format", "json"], at].concat());
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{family} {at:?}");
        run.json()["values"][function].as_str().expect("a value").parse().expect("a decimal")
    };
    let near =
        |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-13, "{value:e} {expected:e}");
    near(value("E", "b[0]", &["--at", "t=100"]), (-100.0_f64).exp());
    near(value("E", "b[1]", &["--at", "t=199"]), (-199.0_f64).exp() * (-(-1.0_f64).exp_m1()));
    near(value("S", "b[0]", &["--at", "t=1/100000"]), 1e-5_f64.sin().powi(20));
    near(
        value("H", "b[0]", &["--shape", "α=300", "--at", "t=1"]),
        (1.0_f64.cosh() - 1.0) / (300.0_f64.cosh() - 1.0),
    );
    for (family, function, at) in [
        ("E", "b[1]", ["--at", "t=200"].as_slice()),
        ("S", "b[1]", &["--at", "t=pi"]),
        ("S", "b[2]", &["--at", "t=1/100000"]),
        ("H", "b[1]", &["--shape", "α=300", "--at", "t=300"]),
        ("H", "b[1]", &["--shape", "α=pi", "--at", "t=pi"]),
    ] {
        assert_eq!(value(family, function, at).to_bits(), 0, "{family} {function} {at:?}");
    }
}

#[test]
fn certificates() {
    let spec = [QUARTER, UNIT, END, HYPERBOLIC].concat();
    let folder = Folder::with("s.basis", &spec);
    let written = folder.run(&["check", "--certificates", "proofs", "s.basis"]);
    assert_eq!(written.code, 0, "{}", written.stderr);
    let verified = folder.run(&["verify", "proofs", "s.basis"]);
    assert_eq!(verified.code, 0, "{}{}", verified.stdout, verified.stderr);
    let folder = folder.and("s.basis", spec.replace("b[2] = 1 - cos(θ)", "b[2] = 1 - cos(2*θ)"));
    assert_ne!(folder.run(&["verify", "proofs", "s.basis"]).code, 0);
}

/// A strict bound of a sum whose functions need no points to be looked at.
#[test]
fn certificates_of_strict_sums() {
    let spec = "family S {
        domain 0 <= t <= pi/2;
        b[0] = t/10;
        b[1] = (sin(t) - 1/2)^2;
        prove b[0] + b[1] > 0;
    }";
    let folder = Folder::with("s.basis", spec);
    let written = folder.run(&["check", "--certificates", "proofs", "s.basis"]);
    assert_eq!(written.code, 0, "{}", written.stderr);
    let verified = folder.run(&["verify", "proofs", "s.basis"]);
    assert_eq!(verified.code, 0, "{}{}", verified.stdout, verified.stderr);
}

/// A variable beside its own sine or exponential: by derivatives and values at the ends.
#[test]
fn a_variable_beside_its_sine() {
    checked(
        "family Sines {
            domain 0 <= t <= pi/2;
            b[0] = t - sin(t);
            prove nonnegative;
            prove sin(t) <= t;
            prove 1 - t^2/2 <= cos(t);
            prove cos(t) <= 1 - t^2/2 + t^4/24;
            prove 2*t/pi <= sin(t);
            prove D(b[0]) = 1 - cos(t);
            prove independent;
            prove b[0](pi/2 - t) = pi/2 - t - cos(t);
            prove at t = pi/2 { b[0] = pi/2 - 1; }
            refute at t = pi/2 { b[0] = 1/2; }
        }
        family Tangent {
            domain 0 <= t < pi/2;
            b[0] = tan(t);
            prove t <= tan(t);
        }
        family Exponential {
            domain 0 <= t <= 1;
            b[0] = exp(t);
            prove exp(t) >= 1 + t;
            prove exp(t) >= 1 + t + t^2/2;
            prove exp(t) <= 1 + t*(exp(1) - 1);
        }
        family CubicArc {
            domain 0 <= t <= pi/2;
            let c = pi/2 - 1;
            b[0] = (pi/2 - t - cos(t))/c;
            b[1] = 1 - sin(t) - b[0];
            b[2] = 1 - cos(t) - b[3];
            b[3] = (t - sin(t))/c;
            prove b[0] >= 0;
            prove b[3] >= 0;
            prove symmetric;
            prove independent;
        }",
    );
}

/// What is false of t beside sin t is refuted, at an end with the exact value.
#[test]
fn false_inequalities_are_refuted() {
    let spec = "family False {
        domain 0 <= t <= pi/2;
        b[0] = t;
        prove sin(t) >= t;
        prove 2*t/3 <= sin(t);
        prove 1 - t^2/3 <= cos(t);
        prove t - sin(t) > 0;
    }";
    let run = Folder::with("s.basis", spec).run(&["check", "s.basis"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    assert_eq!(run.stdout.matches(" refuted ").count(), 4, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains("is 0 at t = 0"), "{}", run.stderr);
}

/// What depends on the value of pi beyond its bounds, or on t beside sin t, is left open and never wrong.
#[test]
fn open_questions_stay_open() {
    let run = Folder::with(
        "s.basis",
        "family Open {
            domain 0 <= t <= pi/2;
            b[0] = t - sin(t);
            prove D(b[0]) = 1 - cos(t);
            prove D(b[0]) >= 0;
            prove at t = pi/2 { b[0] = pi/2 - 1; }
            refute b[0] = 0;
            prove b[0](pi/2 - t) = pi/2 - t - cos(t);
            refute independent;
        }",
    )
    .run(&["check", "s.basis"]);
    assert!(run.stdout.matches('✓').count() >= 5, "{}{}", run.stdout, run.stderr);
}

#[test]
fn exceptions_are_angles_as_they_are_written() {
    let folder = Folder::with(
        "f.basis",
        "family F {
            shape 0 < α <= pi;
            domain 0 <= t <= α;
            b[0] = sin(t);
            b[1] = sin(α - t);
            refute independent;
            prove independent except α = pi;
        }
        family Inside {
            shape 0 < α < 2*pi/3;
            domain 0 <= t <= 1;
            b[0] = 1;
            b[1] = 1 + t*cos(α);
            prove independent except α = pi/2;
        }",
    );
    let run = folder.run(&["check", "f.basis"]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("b[0] - b[1] = 0 at α = pi"), "{}", run.stdout);
    for command in [&["check"][..], &["table"], &["explain"]] {
        let arguments: Vec<&str> = command.iter().copied().chain(["f.basis"]).collect();
        let run = folder.run(&arguments);
        for exception in ["α = pi", "α = pi/2"] {
            assert!(run.stdout.contains(exception), "{command:?} {}", run.stdout);
        }
        assert!(!run.stdout.contains("tan("), "{command:?} {}", run.stdout);
    }
}
