//! `basis explain` shows formulas, ends and exceptional sets exactly.

use crate::support::{BERNSTEIN, Folder, QUARTIC};

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
fn joins_at_both_ends() {
    let folder = Folder::with("q.basis", QUARTIC);
    let run = folder.run(&["explain", "q.basis"]);
    for line in [
        "C1, Q after P: Q'(0) = P'(1)",
        "Q[1] = -(3 + λ_P)/(3 + λ_Q)*P[2] + (6 + λ_P + λ_Q)/(3 + λ_Q)*P[3]\n    for λ_Q != -3\n",
        "C2, Q before P: Q'(1) = P'(0), Q''(1) = P''(0)",
        "G2, Q after P: f*Q'(0) = P'(1), f^2*Q''(0) + c*Q'(0) = P''(1)",
        "G1, Q before P: f*Q'(1) = P'(0)",
        "Q[2] = (3 + λ_P + 3*f + λ_Q*f)/(f*(3 + λ_Q))*P[0] - (3 + λ_P)/(f*(3 + λ_Q))*P[1]",
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
fn joins_and_theorems() {
    let spec = "
use \"q.basis\";
/// Tangent continuation.
join G1 {
    curve P = QuarticBernstein(λ);
    curve Q = QuarticBernstein(μ);
    scalar 0 < δ;
    assume μ > -3;
    let Q[0] = P[3];
    let Q[1] = Q[0] + (3 + λ)/(δ*(3 + μ)) * (P[3] - P[2]);
    prove D(P)(1) == δ*D(Q)(0);
    refute D(P, 2)(1) == δ^2*D(Q, 2)(0);
}
theorem Worked {
    curve P = QuarticBernstein(1) [(0, 0), (1, 2), (3, 2), (4, 0)];
    curve Q = QuarticBernstein(0);
    let Q[0] = P[3] + (1, 1/2);
    prove P(1/2)[1] > 1;
}";
    let folder = Folder::with("q.basis", QUARTIC);
    folder.write("j.basis", spec);
    let run = folder.run(&["explain", "j.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    for line in [
        "join G1: P = QuarticBernstein(λ), Q = QuarticBernstein(μ); -3 <= λ <= 1, -3 < μ <= 1, 0 < δ\n    Tangent continuation.\n",
        "  Determined control points\n    Q[0] = P[3]\n    Q[1] = -(3 + λ)/(δ*(3 + μ))*P[2] + (3 + λ + 3*δ + μ*δ)/(δ*(3 + μ))*P[3]\n",
        "    D(P)(1) == δ*D(Q)(0)\n      proved: expansion of both sides\n",
        "    D(P, 2)(1) == δ^2*D(Q, 2)(0)\n      refuted: the two sides differ by ",
        "    Q[0] = (5, 1/2)\n",
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
    let one = folder.run(&["explain", "j.basis", "Worked"]);
    assert!(one.stdout.starts_with("theorem Worked: ") && !one.stdout.contains("G1"), "{}", one.stdout);
    let none = folder.run(&["explain", "j.basis", "G2"]);
    assert_eq!(none.code, 2);
    assert!(none.stderr.contains("joins and theorems here: G1, Worked"), "{}", none.stderr);
}

#[test]
fn mistakes() {
    let folder = Folder::with("q.basis", QUARTIC);
    let run = folder.run(&["explain", "q.basis", "Quartic"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("Quartic"), "{}", run.stderr);
    assert_eq!(folder.run(&["explain", "missing.basis"]).code, 2);
}

/// A family is explained whatever is wrong with others.
#[test]
fn one_family_among_mistakes() {
    let spec = "family Good { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; }
        family Bad { domain 0 <= t <= 1; b[0] = zz; }
        theorem About { curve P = Bad; prove P(0) = P[0]; }
        theorem Other { curve P = Good; prove P(0) = P[0]; }";
    let folder = Folder::with("m.basis", spec);
    for name in ["Good", "Other"] {
        let run = folder.run(&["explain", "m.basis", name]);
        assert!(run.stdout.contains("Good"), "{}", run.stderr);
    }
    let run = folder.run(&["explain", "m.basis", "Bad"]);
    assert!(run.stdout.is_empty() && run.stderr.contains("`zz` is not declared"), "{}", run.stderr);
    assert!(!run.stderr.contains("joins and theorems here"), "{}", run.stderr);
}

/// What stands under the title of the largest ranges.
fn ranges(spec: &str, family: &str) -> Vec<String> {
    let run = Folder::with("f.basis", spec).run(&["explain", "f.basis", family]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let (_, after) = run.stdout.split_once("All functions are nonnegative").expect("a title");
    after.lines().skip(1).map(|line| line.trim().to_string()).collect()
}

#[test]
fn largest_ranges_end_where_a_denominator_vanishes() {
    let spec = "family R {
        domain 0 <= t <= 1;
        shape 0 <= λ <= 1;
        b[0] = (1 - t)^2/(2 - λ);
        b[1] = t*(1 - λ*t)/(λ + 3)^2;
    }";
    assert_eq!(ranges(spec, "R"), ["-3 < λ <= 1"]);
    assert_eq!(ranges(&spec.replace("1 - λ*t", "8 - λ^3*t"), "R"), ["-3 < λ < 2"]);
    assert_eq!(
        ranges(&spec.replace("(λ + 3)^2", "(λ^2 + 1)").replace("1 - λ*t", "1 + λ*t"), "R"),
        ["-1 <= λ < 2"]
    );
}

/// A quadratic family on a triangle, raised.
const RAISED: &str = "family T(n in 2..=7) {
    domain triangle (u, v, w);
    shape 1/2 <= λ <= 1;
    base n = 2 {
        permute b[2, 0, 0] = u^2 + (1 - λ/2)*(u*v + u*w);
        permute b[1, 1, 0] = λ*u*v;
    }
    raise b[i, j, k] = u*b[i - 1, j, k] + v*b[i, j - 1, k] + w*b[i, j, k - 1];
    prove partition_of_unity;
}";

#[test]
fn largest_ranges_on_a_triangle() {
    assert_eq!(ranges(RAISED, "T(2)"), ["0 <= λ <= 2"]);
}

#[test]
fn a_range_that_is_too_wide() {
    let negative = "(a function is negative somewhere on the declared ranges)";
    let quartic = QUARTIC.replace("prove at λ = 0 { b = Bernstein(3); }", "");
    for (declared, good) in [
        ("-4 <= λ <= 2", "-3 <= λ <= 1"),
        ("-4 <= λ <= 1", "-3 <= λ <= 1"),
        ("-4 <= λ", "-3 <= λ <= 1"),
        ("0 <= λ <= 11/10", "-3 <= λ <= 1"),
        ("1 <= λ <= 2", "-3 <= λ <= 1"),
    ] {
        let spec = quartic.replace("-3 <= λ <= 1", declared);
        assert_eq!(ranges(&spec, "QuarticBernstein"), [format!("{good} {negative}")], "{declared}");
    }
    let spec = quartic.replace("-3 <= λ <= 1", "2 <= λ <= 3");
    let none = "λ: a function is negative somewhere on the declared ranges, whatever λ is in its range";
    assert_eq!(ranges(&spec, "QuarticBernstein"), [none]);
    // Several parts, a single number, irrational ends, a second parameter with an end of its own.
    let spec = "family F {
        domain 0 <= t <= 1;
        shape -4 <= λ <= 4;
        shape 0 <= μ <= 1;
        b[0] = t*(λ^2 - 2)*(λ + 3)^2*(3 - λ) + (1 - t);
        b[1] = (1 + μ)*(3 - λ) + t;
    }";
    let (low, high) = ("-sqrt(2)", "sqrt(2)");
    assert_eq!(
        ranges(spec, "F"),
        [
            format!("λ <= {low} or {high} <= λ <= 3 {negative}"),
            String::from(
                "μ: a function is negative somewhere on the declared ranges, whatever μ is in its range"
            )
        ]
    );
    let spec = "family G { domain 0 <= t <= 1; shape -1 <= λ <= 4; b[0] = -(λ - 2)^2*(λ + t); b[1] = 1; }";
    assert_eq!(ranges(spec, "G"), [format!("λ <= -1 or λ = 2 {negative}")]);
}

#[test]
fn an_irrational_end() {
    let spec = "family F { domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = 2 - λ^2 + t; b[1] = 1; }";
    assert_eq!(ranges(spec, "F"), ["-sqrt(2) <= λ <= sqrt(2)"]);
}

/// Many functions of a raised family, of which only a few narrow the range.
#[test]
fn largest_ranges_of_a_high_order() {
    assert_eq!(ranges(RAISED, "T(7)"), ["-20/11 <= λ <= 2"]);
}

#[test]
fn factors_on_other_domains() {
    let functions = |spec: &str| {
        let run = Folder::with("f.basis", spec).run(&["explain", "f.basis"]);
        let (_, after) = run.stdout.split_once("Functions\n").expect("a title");
        let lines = after.lines().take_while(|line| !line.is_empty());
        lines.map(|line| line.trim().to_string()).collect::<Vec<_>>()
    };
    assert_eq!(
        functions(
            "family F { domain -2 <= s <= 3/2; shape 0 <= μ <= 1; b[0] = (3/2 - s)^2*(2 - μ)*4/49; b[1] = s^3/3 - 4/3*s; }"
        ),
        ["b[0] = 4/49*(2 - μ)*(3/2 - s)^2", "b[1] = -1/3*(2*s - s^2)*(2 + s)"]
    );
    assert_eq!(
        functions(
            "family F { domain -1 <= x <= 1, 0 <= y <= 2; shape 0 <= μ <= 1; b[0] = x*(1 - x^2)*y^2/4; b[1] = (1 + x)*(x + y - 1)/(1 + μ); b[2] = 0; }"
        ),
        ["b[0] = 1/4*x*(1 + x)*(1 - x)*y^2", "b[1] = (-1 + x + y)*(1 + x)/(1 + μ)", "b[2] = 0"]
    );
    assert_eq!(
        functions(
            "family F { domain triangle (u, v, w); shape 0 <= c <= 1; b[0] = u - c*u*v*w; b[1] = 9/2*v*w*(2*v - u - w); b[2] = u^2*w + 4*u*v*w; }"
        ),
        ["b[0] = (1 - c*v + c*u*v + c*v^2)*u", "b[1] = 9/2*(-1 + 3*v)*v*w", "b[2] = (4*v + u)*u*w"]
    );
}

/// The matrix of a kind that `explain` prints, as text.
fn matrix(run: &crate::support::Run, kind: &str) -> Vec<Vec<String>> {
    let report = run.json();
    let all = report["items"][0]["matrices"].as_array().expect("a list").clone();
    let found = all.into_iter().find(|m| m["kind"] == kind).unwrap_or_else(|| panic!("there is no {kind}"));
    serde_json::from_value(found["entries"].clone()).expect("texts")
}

#[test]
fn matrices_of_an_interval() {
    let spec = "family Quadratic { domain -1 <= t <= 1; b[0] = 1; b[1] = t; b[2] = (3*t^2 - 1)/2; }
    family Powers { domain -1 <= t <= 1; shape λ; b[0] = 1; b[1] = t + λ; b[2] = t^2; }
    family Short { domain -1 <= t <= 1; b[0] = t; }
    family Other { domain 0 <= t <= 1; b[0] = t; }";
    let folder = Folder::with("q.basis", spec);
    let explain = |rest: &[&str]| folder.run(&[&["explain", "q.basis"], rest].concat());
    let run = explain(&["Quadratic", "--to", "Powers", "--format", "json"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    // Legendre polynomials: 2/(2k + 1), and ∫ 1 = 2, ∫ (3t)² = 6.
    assert_eq!(matrix(&run, "mass"), [["2", "0", "0"], ["0", "2/3", "0"], ["0", "0", "2/5"]]);
    assert_eq!(matrix(&run, "stiffness"), [["0", "0", "0"], ["0", "2", "0"], ["0", "0", "6"]]);
    assert_eq!(matrix(&run, "moments"), [["2", "0", "0"], ["0", "2/3", "0"], ["2/3", "0", "4/15"]]);
    assert_eq!(matrix(&run, "to_bernstein"), [["1", "1", "1"], ["-1", "0", "1"], ["1", "-2", "1"]]);
    assert_eq!(
        matrix(&run, "from_bernstein"),
        [["1/3", "-1/2", "1/6"], ["1/3", "0", "-1/3"], ["1/3", "1/2", "1/6"]]
    );
    assert_eq!(matrix(&run, "to_family"), [["1", "0", "0"], ["-λ", "1", "0"], ["-1/2", "0", "3/2"]]);
    assert_eq!(matrix(&run, "from_family"), [["1", "0", "0"], ["λ", "1", "0"], ["1/3", "0", "2/3"]]);
    // Of two families one of which spans the other there is one matrix.
    let run = explain(&["Short", "--to", "Powers"]);
    assert!(run.stdout.contains("Short in terms of Powers: b[i] = Σ M[i,j]*Powers[j]"), "{}", run.stdout);
    assert!(!run.stdout.contains("Powers in terms of Short"), "{}", run.stdout);
    for (from, to, reason) in [
        ("Short", "Other", "`Other` has another domain than `Short`"),
        ("Short", "Bernstein(1)", "`Bernstein(1)` has another domain"),
        ("Short", "Nothing", "there is no family `Nothing`"),
    ] {
        let run = explain(&[from, "--to", to]);
        assert_eq!(run.code, 2, "{}", run.stdout);
        assert!(run.stderr.contains(reason), "{}", run.stderr);
    }
}

#[test]
fn matrices_of_several_variables() {
    let spec = "family P1 { domain triangle (u, v, w); b[0] = u; b[1] = v; b[2] = w; }
    family Q1 { domain 0 <= u <= 2, 0 <= v <= 1; b[i,j] = (i*u/2 + (1 - i)*(1 - u/2))*(j*v + (1 - j)*(1 - v)) for i in 0..=1, j in 0..=1; }";
    let folder = Folder::with("p.basis", spec);
    let run = folder.run(&["explain", "p.basis", "P1", "--format", "json"]);
    // On the reference triangle of area 1/2.
    assert_eq!(
        matrix(&run, "mass"),
        [["1/12", "1/24", "1/24"], ["1/24", "1/12", "1/24"], ["1/24", "1/24", "1/12"]]
    );
    assert_eq!(
        matrix(&run, "stiffness"),
        [["1/2", "0", "-1/2"], ["0", "1/2", "-1/2"], ["-1/2", "-1/2", "1"]]
    );
    let run = folder.run(&["explain", "p.basis", "Q1", "--format", "json"]);
    assert_eq!(matrix(&run, "mass")[0], ["2/9", "1/9", "1/9", "1/18"]);
    // 4 by 1/3 + 1/2 by 1/3 … : ∫ (u-part)'² ∫ (v-part)² + the same with u and v exchanged.
    assert_eq!(matrix(&run, "stiffness")[0], ["5/6", "-7/12", "1/6", "-5/12"]);
}

/// A curve keeps its points when its control points are those of the next order.
#[test]
fn degree_elevation() {
    let folder = Folder::with("b.basis", BERNSTEIN);
    let run = folder.run(&["explain", "b.basis", "Bern(2)", "--format", "json"]);
    assert_eq!(
        matrix(&run, "elevation"),
        [["1", "1/3", "0", "0"], ["0", "2/3", "2/3", "0"], ["0", "0", "1/3", "1"]]
    );
    let spec = "family L { domain 0 <= t <= 1; shape h; b[0] = 1 - h*t; b[1] = h*t; }";
    let run = Folder::with("l.basis", spec).run(&["explain", "l.basis", "--format", "json"]);
    assert_eq!(matrix(&run, "elevation"), [["1", "1 - 1/2*h", "1 - h"], ["0", "1/2*h", "h"]]);
}

/// On simplices and boxes curves' rule holds in each factor; the sum of each column stays that of the coefficients of 1.
#[test]
fn degree_elevation_of_several_variables() {
    let spec = "family Triangle { domain triangle (u, v, w); b[0] = u; b[1] = v; b[2] = w; }
        family Box { domain 0 <= u <= 1, 0 <= v <= 2; b[0] = (1 - u)*v; b[1] = u; }";
    let folder = Folder::with("e.basis", spec);
    let run = |name: &str| folder.run(&["explain", "e.basis", name, "--format", "json"]);
    let half = ["0", "0", "0", "1/2", "1/2", "1"];
    assert_eq!(matrix(&run("Triangle"), "elevation")[0], half);
    // v from 0 to 2 is 2·(0, 1/2, 1); 1 - u is (1, 1/2, 0), all in the degree 2.
    let rows = matrix(&run("Box"), "elevation");
    assert_eq!(rows[0], ["0", "1", "2", "0", "1/2", "1", "0", "0", "0"]);
    assert_eq!(rows[1], ["0", "0", "0", "1/2", "1/2", "1/2", "1", "1", "1"]);
}

/// Integrals of everything that a claim could integrate: angles, exponentials, ends that are parameters, quotients.
#[test]
fn integrals_of_functions_that_are_no_polynomials() {
    let spec = "family Angle { domain 0 <= s <= pi/2; b[0] = 1 - sin(s); b[1] = sin(s); }
        family Exponential { domain 0 <= t <= 1; b[0] = exp(t); }
        family End { shape 0 < h; domain 0 <= x <= h; b[0] = 1 - x/h; b[1] = x/h; }
        family AngleEnd { shape 0 < a < pi; domain 0 <= s <= a; b[0] = 1 - cos(s); }
        family Quotient { domain 0 <= x <= 1; b[0] = 1/(1 + x); }
        family Logarithm { domain 0 <= x <= 1; b[0] = 1/(1 + x); b[1] = 1; }";
    let folder = Folder::with("i.basis", spec);
    let run = |name: &str| folder.run(&["explain", "i.basis", name, "--format", "json"]);
    let angle = run("Angle");
    assert_eq!(matrix(&angle, "mass"), [["3/4*pi - 2", "1 - 1/4*pi"], ["1 - 1/4*pi", "1/4*pi"]]);
    assert_eq!(matrix(&angle, "stiffness")[0], ["1/4*pi", "-1/4*pi"]);
    assert_eq!(matrix(&angle, "moments")[1], ["1/8*pi^2 - 1", "1"]);
    assert_eq!(matrix(&run("Exponential"), "mass"), [["1/2*exp(2) - 1/2"]]);
    let end = run("End");
    assert_eq!(matrix(&end, "mass"), [["1/3*h", "1/6*h"], ["1/6*h", "1/3*h"]]);
    assert_eq!(matrix(&end, "stiffness"), [["1/h", "-1/h"], ["-1/h", "1/h"]]);
    assert_eq!(matrix(&run("AngleEnd"), "moments")[0], ["a - sin(a)"]);
    assert_eq!(matrix(&run("Quotient"), "mass"), [["1/2"]]);
    // The integral of b[0]*b[1] is a logarithm.
    assert!(!run("Logarithm").stdout.contains("\"kind\":\"mass\""));
}

#[test]
fn zeros_and_extrema() {
    let spec = "family Timmer { domain 0 <= t <= 1;
        b[0] = (1 - 2*t)*(1 - t)^2; b[1] = 4*t*(1 - t)^2; b[2] = 4*t^2*(1 - t); b[3] = (2*t - 1)*t^2; }";
    let folder = Folder::with("t.basis", spec);
    let run = folder.run(&["explain", "t.basis"]);
    for line in [
        "b[0]: zero at t = 1/2, t = 1; least value -1/27 at t = 2/3; greatest value 1 at t = 0",
        "b[3]: zero at t = 0, t = 1/2; least value -1/27 at t = 1/3; greatest value 1 at t = 1",
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
    assert!(!run.stdout.contains("b[1]: "), "{}", run.stdout);
}

/// With shape parameters for all of their values where they are quotients of these, else at values that are named; of
/// angles by their tangents, or by themselves at ends and where these vanish.
#[test]
fn zeros_and_extrema_with_parameters_and_angles() {
    let spec = "family Cardinal { domain 0 <= t <= 1; shape 0 <= τ <= 1;
            b[0] = -τ*t*(1 - t)^2; b[1] = 1 - b[0] - b[2]; b[2] = t^2*(3 - 2*t); }
        family Keys { domain 1 <= x <= 2; shape -1 <= a < 0; k[0] = a*(x^3 - 5*x^2 + 8*x - 4); }
        family Ends { shape 0 < c; domain 0 <= x <= c; e[0] = x*(x - c)/c; e[1] = (c - 2*x)/c; }
        family Pole { domain 0 <= t < 1; p[0] = (t - 1/2)/(1 - t); p[1] = t - 1/3; }
        family Sines { domain 0 <= θ <= pi/2;
            s[0] = 1 - 2*sin(θ); s[1] = 1 - cos(4*θ) - 2*sin(2*θ); s[2] = cos(θ); }
        family Turn { domain 0 <= t <= 1; r[0] = cos(pi*t); }
        family Sampled { domain 0 <= t <= 1; shape -1 <= λ <= 1; q[0] = t*(1 - t)*(2*t - 1 - λ*t^2); }
        family Irrational { domain 0 <= t <= 1; i[0] = (t^2 - 1/2)*(t^3 + t - 1); }
        family Numbers { domain 0 <= t <= 1; n[0] = exp(t) - 2; }
        family Slope { domain 0 <= t <= 1; l[0] = exp(1)*t - 1; }
        family Long { domain 0 <= t <= α; shape 0 < α; o[0] = (t/α)^5 + t/α - 1; o[1] = t^2/α^2 - 1/2*t/α - 1/7; }
        family Half { domain 0 <= t <= pi; h[0] = t/pi - 1/2; h[1] = t - 1; }";
    let folder = Folder::with("t.basis", spec);
    let run = folder.run(&["explain", "t.basis"]);
    for line in [
        "b[0]: zero at t = 0, t = 1; least value -4/27*τ at t = 1/3; greatest value 0 at t = 0, t = 1",
        "k[0]: zero at x = 1, x = 2; least value 4/27*a at x = 4/3; greatest value 0 at x = 1, x = 2",
        "e[0]: zero at x = 0, x = c; least value -1/4*c at x = 1/2*c; greatest value 0 at x = 0, x = c",
        "e[1]: zero at x = 1/2*c; least value -1 at x = c; greatest value 1 at x = 0",
        "p[0]: zeros and extrema are not stated: it has no bound next to an end that the domain leaves out",
        "p[1]: zero at t = 1/3; least value -1/3 at t = 0; greatest value 2/3 at t = 1",
        "s[0]: zero at tan(θ/2) = 2 - sqrt(3); least value -1 at θ = pi/2; greatest value 1 at θ = 0",
        // 2S² - 2S with S = sin 2θ: -1/2 at S = 1/2, which are θ = π/12 and 5π/12; 0 at S = 0 and 1.
        "s[1]: zero at θ = 0, tan(θ/2) = -1 + sqrt(2), θ = pi/2; least value -1/2 at tan(θ/2) = 0.131652498",
        "r[0]: zero at t = 1/2; least value -1 at t = 1; greatest value 1 at t = 0",
        "q[0] at λ = 0: zero at t = 0, t = 1/2, t = 1; least value -1/18*sqrt(3) at t = 1/2 - 1/6*sqrt(3)",
        // Numbers that no fraction is: exact at the ends, decimals inside.
        "n[0]: zero at (tanh(t/2)/tanh(1/2)) = about 0.721317805; least value -1 at t = 0; greatest value exp(1) - 2 at t = 1",
        "l[0]: zero at t = about 0.367879441; least value -1 at t = 0; greatest value exp(1) - 1 at t = 1",
        "h[0]: zero at t = 1/2*pi; least value -1/2 at t = 0; greatest value 1/2 at t = pi",
        "h[1]: zero at t = about 1.000000000; least value -1 at t = 0; greatest value pi - 1 at t = pi",
        "o[0]: zero at t/α = 0.754877666 (root of -1 + x^2 + x^3 between 0.754 and 0.755); least value -1 at t = 0; greatest value 1 at t = α",
        "o[1]: zero at t/α = 1/4 + 1/28*sqrt(161); least value -23/112 at t = 1/4*α; greatest value 5/14 at t = α",
        // A root of a quadratic factor has a square root, one of a cubic factor a decimal.
        "i[0]: zero at t = 0.682327804 (root of -1 + x + x^3 between 0.682 and 0.683), t = 1/2*sqrt(2); least ",
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
    assert!(!run.stdout.contains("s[2]: "), "{}", run.stdout);
}

#[test]
fn verdicts_are_summed_up() {
    let spec = "family F { domain 0 <= t <= 1; b[0] = t; b[1] = 1 - t; b[2] = 0;
        prove partition_of_unity; refute independent; prove b[i] >= 0 for i in 0..=2; }";
    let run = Folder::with("f.basis", spec).run(&["explain", "f.basis"]);
    for line in
        ["Claims: 4 proved, 1 refuted", "    refuted   independent\n", "b[i] >= 0 for i in 0..=2 (3 claims)"]
    {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
}

/// Families in sines, exponentials, between ends that are shape parameters, and beside the variable itself.
const ANALYTIC: [&str; 7] = [
    "family Scaled { shape 0 < h; domain 0 <= x <= h; b[0] = (1 - x/h)^2; b[1] = 2*(x/h)*(1 - x/h); b[2] = (x/h)^2; }",
    "family Shifted { shape a; shape 0 < h; domain a <= x <= a + h; b[0] = (a + h - x)^3/h^3; b[1] = (x - a)/(2*h); }",
    "family Cycloid { domain 0 <= t <= pi/2; b[0] = (t - sin(t))/(pi/2 - 1); b[1] = 1 - b[0] - b[2]; b[2] = 1 - cos(t); }",
    "family Sines { domain 0 <= θ <= pi/2; shape -2 <= λ <= 1; b[0] = (1 - λ*sin(θ))*(1 - sin(θ))^2;
        b[1] = cos(θ)*(1 - cos(θ))*(2 + λ - λ*cos(θ)); b[2] = 1/(1 + sin(θ))^2; b[3] = tan(θ/2)*(1 + cos(θ)); b[4] = -cos(2*θ)/3; }",
    "family Arc { shape 0 < α < pi; domain 0 <= t <= α; b[0] = (1 - cos(α - t))/(1 - cos(α)); b[1] = 1 - b[0] - b[2];
        b[2] = (1 - cos(t))/(1 - cos(α)); b[3] = sin(α - t)/sin(α); }",
    "family Exponential { domain 0 <= t <= 2; shape 0 < a <= 3; b[0] = exp(-t); b[1] = a*tanh(t/2); b[2] = exp(t) - 1;
        b[3] = sinh(2*t) - 2*exp(-3*t); b[4] = (a + exp(t))/(a + cosh(t)); b[5] = (exp(2) - exp(t))/(1 - exp(2)); }",
    "family Catenary { shape 0 < α; domain 0 <= t <= α; b[0] = sinh(α - t)/sinh(α); b[1] = exp(α - t); }",
];

/// What is printed is a formula of the language, and proved to be the function.
#[test]
fn formulas_for_reading_are_the_functions() {
    for spec in ANALYTIC {
        let run = Folder::with("f.basis", spec).run(&["explain", "f.basis", "--format", "json"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{spec}");
        let json = run.json();
        let mut claims = String::new();
        for f in json["items"][0]["functions"].as_array().expect("a list") {
            for form in ["factored", "expanded"] {
                let text = f[form].as_str().expect("a text");
                assert!(
                    !text.contains("tan(t/2)/") && !text.contains("--") && !text.contains("*-"),
                    "{text}"
                );
                claims += &format!("prove {} = {text};\n", f["name"].as_str().expect("a name"));
            }
            assert_ne!(f["latex"], "", "{f}");
        }
        let open = spec.strip_suffix('}').expect("a brace");
        let run = Folder::with("f.basis", &format!("{open}{claims}}}")).run(&["check", "f.basis"]);
        assert_eq!(run.code, 0, "{claims}\n{}\n{}", run.stdout, run.stderr);
    }
}

#[test]
fn formulas_look_as_one_writes_them() {
    let all = ANALYTIC.concat();
    let run = Folder::with("f.basis", &all).run(&["explain", "f.basis"]);
    for line in [
        "b[1] = 2*x*(h - x)/h^2",
        "b[0] = 2*(t - sin(t))/(pi - 2)",
        "C(pi/2)   = P[0] - P[1] + P[2]",
        "C'(pi/2)  = 2/(pi - 2)*P[0] - pi/(pi - 2)*P[1] + P[2]",
        "b[0] = (1 - λ*sin(θ))*(1 - sin(θ))^2",
        "b[2] = (1 - cos(t))/(1 - cos(α))",
        "b[0] = exp(-t)",
        "b[1] = a*tanh(t/2)",
        "C'(0)  = -P[0] + 1/2*a*P[1] + P[2] + 8*P[3]",
        "Scaled: 0 <= x <= h; shape 0 < h\n",
    ] {
        assert!(run.stdout.contains(line), "{line} is missing in\n{}", run.stdout);
    }
}

#[test]
fn ranges_stay_where_there_is_a_domain() {
    assert_eq!(ranges(ANALYTIC[0], "Scaled"), ["0 < h"]);
    assert_eq!(ranges(&ANALYTIC[0].replace("0 < h;", "1 <= h < 5;"), "Scaled"), ["0 < h"]);
    let falls = "family F { shape 0 < h; domain 0 <= x <= h; b[0] = x/h; b[1] = x*(h - 2); }";
    assert_eq!(ranges(falls, "F"), ["2 <= h (a function is negative somewhere on the declared ranges)"]);
    // Only at the end that is left out.
    let never = "family F { shape 0 < h; domain 0 <= x <= 1; b[0] = x; b[1] = -h*x; }";
    assert_eq!(
        ranges(never, "F"),
        ["h: a function is negative somewhere on the declared ranges, whatever h is in its range"]
    );
}

#[test]
fn what_is_assumed_is_said() {
    let spec = "family A { domain 0 <= t <= 1; shape 0 <= q < p <= 1; shape B; shape C; assume p^2 + q^2 <= 1;
        assume B + 2*C = 1; b[0] = p*t + C; b[1] = q*(1 - t) + B; prove at p = 1, q = 0, B = 1, t = 0 { b[1] = 1; } }";
    let folder = Folder::with("a.basis", spec);
    let assumed = "; assume q < p, p^2 + q^2 <= 1, C = 1/2 - 1/2*B\n";
    for command in ["check", "explain"] {
        let run = folder.run(&[command, "a.basis"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        assert!(run.stdout.contains(assumed), "{}", run.stdout);
    }
}

/// Where two sides differ by a number, one note says so, and no point.
#[test]
fn a_difference_that_is_a_number_is_said_once() {
    let spec = "family N { domain 0 <= x <= 1, 1 <= x <= 2; b[0] = x | 2 - x; b[1] = 1 - x | x - 1;
        prove integral(b[1]) = 3; prove smooth(1); }";
    let run = Folder::with("n.basis", spec).run(&["check", "n.basis"]);
    for note in ["= note: `integral(b[1])` differs from `3` by `-2`\n  = help", "after it)` is 2\n  = help"] {
        assert!(run.stderr.contains(note), "{}", run.stderr);
    }
}
