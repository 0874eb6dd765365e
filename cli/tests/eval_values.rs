//! `basis eval`: exact values, compared with formulas that are evaluated here.

mod support;

use serde_json::json;
use support::{Folder, QUARTIC};

/// A fraction in lowest terms with a positive denominator.
#[derive(Clone, Copy)]
struct Q(i128, i128);

impl Q {
    fn new(n: i128, d: i128) -> Self {
        let (mut a, mut b) = (n.abs(), d.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let sign = d.signum();
        Self(sign * n / a.max(1), d.abs() / a.max(1))
    }
}

impl std::ops::Add for Q {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.0 * o.1 + o.0 * self.1, self.1 * o.1)
    }
}

impl std::ops::Sub for Q {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.0 * o.1 - o.0 * self.1, self.1 * o.1)
    }
}

impl std::ops::Mul for Q {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.0 * o.0, self.1 * o.1)
    }
}

impl std::fmt::Display for Q {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.1 == 1 { write!(f, "{}", self.0) } else { write!(f, "{}/{}", self.0, self.1) }
    }
}

#[test]
fn values_and_derivatives_of_the_quartic_family() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    for (λ, t) in
        [((1, 2), (1, 3)), ((-3, 1), (1, 2)), ((1, 1), (0, 1)), ((-7, 5), (1, 1)), ((0, 1), (99, 100))]
    {
        let run = folder.run(&[
            "eval",
            "quartic.basis",
            "QuarticBernstein",
            "--order",
            "1",
            "--format",
            "json",
            "--shape",
            &format!("λ={}/{}", λ.0, λ.1),
            "--at",
            &format!("t={}/{}", t.0, t.1),
        ]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        let (λ, t) = (Q::new(λ.0, λ.1), Q::new(t.0, t.1));
        let [zero, one, two, three] = [0, 1, 2, 3].map(|n| Q::new(n, 1));
        let s = one - t;
        // The formulas of the paper, and their derivatives by the product rule.
        let values = [
            (one - λ * t) * s * s * s,
            (three + λ - λ * t) * t * s * s,
            (three + λ * t) * t * t * s,
            (one - λ + λ * t) * t * t * t,
        ];
        let derivatives = [
            zero - λ * s * s * s - three * (one - λ * t) * s * s,
            (three + λ - λ * t) * (s * s - two * t * s) - λ * t * s * s,
            (three + λ * t) * (two * t - three * t * t) + λ * t * t * s,
            λ * t * t * t + three * (one - λ + λ * t) * t * t,
        ];
        let report = run.json();
        for i in 0..4 {
            assert_eq!(
                report["values"][format!("b[{i}]")],
                json!(values[i].to_string()),
                "b[{i}] at {λ}, {t}"
            );
            assert_eq!(
                report["derivatives"][format!("D(b[{i}])")],
                json!(derivatives[i].to_string()),
                "{i} at {λ}, {t}"
            );
        }
    }
}

#[test]
fn the_report_is_one_object_in_the_order_of_the_functions() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let arguments = [
        "eval",
        "quartic.basis",
        "QuarticBernstein",
        "--shape",
        "lambda=0.5",
        "--at",
        "t=1/3",
        "--format",
        "json",
    ];
    let run = folder.run(&arguments);
    assert_eq!(
        run.stdout,
        "{\"values\":{\"b[0]\":\"20/81\",\"b[1]\":\"40/81\",\"b[2]\":\"19/81\",\"b[3]\":\"2/81\"},\"derivatives\":{}}\n"
    );
    let run = folder.run(&[&arguments[..], &["--order", "6"]].concat());
    let report = run.json();
    let derivatives = report["derivatives"].as_object().expect("an object");
    assert_eq!(derivatives.len(), 24);
    assert_eq!(derivatives["D(b[0])"], json!("-34/27"));
    assert_eq!(derivatives["D(b[0],2)"], json!("14/3"));
    assert_eq!(derivatives["D(b[0],4)"], json!("12"));
    assert_eq!(derivatives["D(b[3],5)"], json!("0"));
    assert_eq!(derivatives["D(b[3],6)"], json!("0"));
}

#[test]
fn mixed_derivatives_list_the_variables_in_order() {
    let spec = "family Tensor(m in 1..=3, n in 1..=3) { domain 0 <= v <= 1, -1 <= u <= 2; shape α;
    b[i,j] = v^i * u^j + α for i in 0..=m, j in 0..=n; }";
    let folder = Folder::with("tensor.basis", spec);
    let run = folder.run(&[
        "eval",
        "tensor.basis",
        "Tensor(n=3, m=2)",
        "--shape",
        "alpha=-10",
        "--at",
        "u=2,v=1/2",
        "--order",
        "3",
        "--format",
        "json",
    ]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let report = run.json();
    assert_eq!(report["values"].as_object().map(serde_json::Map::len), Some(12));
    assert_eq!(report["values"]["b[2,3]"], json!("-8"));
    let derivatives = report["derivatives"].as_object().expect("an object");
    let of_last = |key: &&String| key.starts_with("D(b[2,3]");
    let keys: Vec<&str> =
        derivatives.keys().filter(of_last).map(|key| &key["D(b[2,3],".len()..key.len() - 1]).collect();
    assert_eq!(keys, ["v", "u", "v,v", "v,u", "u,u", "v,v,v", "v,v,u", "v,u,u", "u,u,u"]);
    assert_eq!(derivatives["D(b[2,3],v)"], json!("8"));
    assert_eq!(derivatives["D(b[2,3],v,u)"], json!("12"));
    assert_eq!(derivatives["D(b[2,3],v,v,u)"], json!("24"));
    assert_eq!(derivatives["D(b[2,3],u,u,u)"], json!("3/2"));
    assert_eq!(derivatives["D(b[2,3],v,v,v)"], json!("0"));
}

#[test]
fn a_point_of_a_triangle_needs_two_coordinates() {
    // The derivatives are those of u², v², w², … as functions of u and v, with w = 1 − u − v.
    let spec = "family F { domain triangle (u, v, w); b[0] = u^2*w; b[1] = v; }";
    let folder = Folder::with("f.basis", spec);
    for at in ["u=1/2,v=1/3", "u=1/2,w=1/6", "w=1/6,v=1/3", "w=1/6,v=1/3,u=1/2"] {
        let run = folder.run(&["eval", "f.basis", "F", "--at", at, "--order", "2", "--format", "json"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        let derivatives = json!({
            "D(b[0],u)": "-1/12", "D(b[1],u)": "0", "D(b[0],v)": "-1/4", "D(b[1],v)": "1",
            "D(b[0],u,u)": "-5/3", "D(b[1],u,u)": "0", "D(b[0],u,v)": "-1", "D(b[1],u,v)": "0",
            "D(b[0],v,v)": "0", "D(b[1],v,v)": "0",
        });
        assert_eq!(
            run.json(),
            json!({"values": {"b[0]": "1/24", "b[1]": "1/3"}, "derivatives": derivatives})
        );
    }
}

#[test]
fn families_of_the_prelude_and_of_used_files() {
    let folder =
        Folder::with("main.basis", "use \"quartic.basis\";\nfamily F { domain 0 <= t <= 1; f[0] = 1; }")
            .and("quartic.basis", QUARTIC);
    for family in ["Bernstein(2)", "Bernstein(n=2)", " Bernstein ( n = 2 ) "] {
        let run = folder.run(&["eval", "main.basis", family, "--at", "t=1/2", "--format", "json"]);
        assert_eq!(run.json()["values"], json!({"b[0]": "1/4", "b[1]": "1/2", "b[2]": "1/4"}));
    }
    let run = folder.run(&[
        "eval",
        "main.basis",
        "QuarticBernstein",
        "--shape",
        "λ=−1/2",
        "--at",
        "t=1",
        "--format",
        "json",
    ]);
    assert_eq!(run.json()["values"]["b[3]"], json!("1"));
    let run = folder.run(&["eval", "main.basis", "F", "--at", "t=1", "--format", "json"]);
    assert_eq!(run.json()["values"], json!({"f[0]": "1"}));
}

#[test]
fn numbers_of_any_size_are_exact() {
    let folder = Folder::with("main.basis", "family F { domain 0 <= t <= 1; shape λ; b[0] = λ^8*t; }");
    let run = folder.run(&[
        "eval",
        "main.basis",
        "F",
        "--shape",
        "λ=1000000000000000000000000",
        "--at",
        "t=0.000000000000000000000000001",
        "--format",
        "json",
    ]);
    assert_eq!(run.json()["values"]["b[0]"], json!(format!("1{}", "0".repeat(192 - 27))));
}

#[test]
fn a_table_of_fractions_and_decimals() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let run = folder.run(&[
        "eval",
        "quartic.basis",
        "QuarticBernstein",
        "--shape",
        "λ=1/2",
        "--at",
        "t=1/3",
        "--order",
        "1",
    ]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(run.stdout);
}
