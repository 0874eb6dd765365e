//! `basis eval`: exact values, compared with formulas that are evaluated here.

use crate::support::{BERNSTEIN, Folder, QUARTIC};
use serde_json::json;

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
fn tangents_of_counterexamples() {
    let folder = Folder::with(
        "f.basis",
        "family C { shape 0 < α < pi; domain 0 <= t <= α; b[0] = sin(t); b[1] = sin(α - t); }",
    );
    let said = |arguments: &[&str]| folder.run(&[&["eval", "f.basis", "C"], arguments].concat());
    let run = said(&["--shape", "tan(α/2)=1/2", "--at", "tan(t/2)=1/4"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    // sin t = 2x/(1 + x²).
    assert!(
        run.stdout.contains("at tan(α/2) = 1/2, tan(t/2) = 1/4") && run.stdout.contains("8/17"),
        "{}",
        run.stdout
    );
    let run = said(&["--shape", "tan(α/2)=1/2", "--at", "tan(t/2)=3/4"]);
    assert!(run.stderr.contains("tan(t/2) = 3/4 is outside of the domain `0 <= t <= α`"), "{}", run.stderr);
    let run = said(&["--shape", "tan(α/2)=1/2", "--at", "tan(t/4)=1/4"]);
    assert!(run.stderr.contains("write --at t=…, or --at 'tan(t/2)=…'"), "{}", run.stderr);
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
        "{\"at\":{\"λ\":\"1/2\",\"t\":\"1/3\"},\"values\":{\"b[0]\":\"20/81\",\"b[1]\":\"40/81\",\"b[2]\":\"19/81\",\"b[3]\":\"2/81\"},\"derivatives\":{}}\n"
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
            json!({
                "at": {"u": "1/2", "v": "1/3", "w": "1/6"},
                "values": {"b[0]": "1/24", "b[1]": "1/3"},
                "derivatives": derivatives
            })
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

#[test]
fn several_points_and_steps() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let eval = |rest: &[&str]| {
        let run = folder.run(&[&["eval", "quartic.basis", "QuarticBernstein"], rest].concat());
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{rest:?}");
        run
    };
    let run = eval(&["--shape", "λ=0", "--at", "t=0..1:1/10", "--format", "csv"]);
    let lines: Vec<&str> = run.stdout.lines().collect();
    assert_eq!(lines.len(), 12);
    assert_eq!(
        (lines[0], lines[4]),
        ("λ,t,b[0],b[1],b[2],b[3]", "0,3/10,343/1000,441/1000,189/1000,27/1000")
    );
    // The end is reached only by a whole number of steps.
    let run = eval(&["--shape", "λ=-3..1:3", "--at", "t=0..1:2/3", "--format", "json"]);
    let at: Vec<String> = run.json()["points"]
        .as_array()
        .expect("several points")
        .iter()
        .map(|p| format!("{} {}", p["at"]["λ"].as_str().unwrap(), p["at"]["t"].as_str().unwrap()))
        .collect();
    assert_eq!(at, ["-3 0", "-3 2/3", "0 0", "0 2/3"]);
    let several =
        eval(&["--shape", "λ=1", "--at", "t=0,t=1", "--at", "t=1/2", "--format", "csv", "--decimal"]);
    assert_eq!(
        several.stdout,
        "λ,t,b[0],b[1],b[2],b[3]\n1,0,1,0,0,0\n1,1,0,0,0,1\n1,0.5,0.0625,0.4375,0.4375,0.0625\n"
    );
    // The functions are negative outside of the declared range: this is what it is for.
    let run = eval(&["--shape", "λ=3", "--at", "t=-1/2..3/2:1", "--anyway", "--format", "csv"]);
    assert_eq!(run.stdout.lines().nth(2), Some("3,1/2,-1/16,9/16,9/16,-1/16"));
    insta::assert_snapshot!(eval(&["--shape", "λ=1/2", "--at", "t=0..1:1/4", "--order", "1"]).stdout);
}

#[test]
fn points_of_curves_and_surfaces() {
    let folder =
        Folder::with("quartic.basis", QUARTIC).and("polygon.csv", "x,y\n0, 0\n1, 2\n3; 2\n4 0\n").and(
            "box.basis",
            "family B { domain 0 <= u <= 1, 0 <= v <= 1; b[i,j] = u^i*v^j for i in 0..=1, j in 0..=1; }",
        );
    let eval = |points: &str| {
        let run = folder.run(&[
            "eval",
            "quartic.basis",
            "QuarticBernstein",
            "--shape",
            "λ=0",
            "--at",
            "t=1/2",
            "--order",
            "1",
            "--points",
            points,
            "--format",
            "json",
        ]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        run.json()["curve"].clone()
    };
    // (P0 + 3 P1 + 3 P2 + P3)/8, and 3/4 (P2 + P3 − P0 − P1).
    assert_eq!(eval("0,0 1,2 3,2 4,0"), json!({"C": ["2", "3/2"], "D(C)": ["9/2", "0"]}));
    assert_eq!(eval("polygon.csv"), json!({"C": ["2", "3/2"], "D(C)": ["9/2", "0"]}));
    assert_eq!(eval("-1 0 0 1/3"), json!({"C": ["-1/12"], "D(C)": ["1"]}));
    let run = folder.run(&[
        "eval",
        "box.basis",
        "B",
        "--at",
        "u=0..1:1,v=1/2",
        "--points",
        "0,0,1 0,1,2 1,0,3 1,1,0",
        "--format",
        "csv",
        "--order",
        "1",
    ]);
    // b = (1, v, u, uv) at (0, 1/2) and (1, 1/2).
    assert_eq!(
        run.stdout,
        "u,v,S.x,S.y,S.z,\"D(S,u).x\",\"D(S,u).y\",\"D(S,u).z\",\"D(S,v).x\",\"D(S,v).y\",\"D(S,v).z\"\n\
         0,1/2,0,1/2,2,3/2,1/2,3,0,1,2\n1,1/2,3/2,1,5,3/2,1/2,3,1,2,2\n"
    );
}

#[test]
fn a_grid_on_a_triangle_has_the_points_inside() {
    let folder = Folder::with("f.basis", "family F { domain triangle (u, v, w); b[0] = u^2*w; b[1] = v; }");
    let run = folder.run(&["eval", "f.basis", "F", "--at", "u=0..1:1/2,v=0..1:1/2", "--format", "csv"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let points: Vec<&str> =
        run.stdout.lines().skip(1).map(|line| line.rsplitn(3, ',').last().expect("a point")).collect();
    assert_eq!(points, ["0,0,1", "0,1/2,1/2", "0,1,0", "1/2,0,1/2", "1/2,1/2,0", "1,0,0"]);
    let run = folder.run(&["eval", "f.basis", "F", "--at", "u=2,v=1", "--anyway", "--format", "json"]);
    assert_eq!(run.json()["values"], json!({"b[0]": "-8", "b[1]": "1"}));
}

#[test]
fn points_of_a_prism_and_a_grid_on_it() {
    let spec = "family F { domain -1 <= z <= 1, triangle (u, v, w); b[0] = u^2*w*z; b[1] = v; }";
    let folder = Folder::with("f.basis", spec);
    for at in ["u=1/2,v=1/3,z=-1/2", "z=-1/2,w=1/6,v=1/3", "w=1/6,v=1/3,u=1/2,z=-1/2"] {
        let run = folder.run(&["eval", "f.basis", "F", "--at", at, "--order", "1", "--format", "json"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        // With w = 1 - u - v.
        let derivatives = json!({
            "D(b[0],z)": "1/24", "D(b[1],z)": "0", "D(b[0],u)": "1/24", "D(b[1],u)": "0",
            "D(b[0],v)": "1/8", "D(b[1],v)": "1",
        });
        assert_eq!(run.json()["values"], json!({"b[0]": "-1/48", "b[1]": "1/3"}));
        assert_eq!(run.json()["derivatives"], derivatives);
        assert_eq!(run.json()["at"], json!({"z": "-1/2", "u": "1/2", "v": "1/3", "w": "1/6"}));
    }
    let run =
        folder.run(&["eval", "f.basis", "F", "--at", "z=0..1:1,u=0..1:1/2,v=0..1:1/2", "--format", "csv"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let points: Vec<&str> =
        run.stdout.lines().skip(1).map(|line| line.rsplitn(3, ',').last().expect("a point")).collect();
    let of_triangle = ["0,0,1", "0,1/2,1/2", "0,1,0", "1/2,0,1/2", "1/2,1/2,0", "1,0,0"];
    let all: Vec<String> =
        ["0", "1"].iter().flat_map(|z| of_triangle.map(|point| format!("{z},{point}"))).collect();
    assert_eq!(points, all);
    // A grid that leaves the interval is an error, and not cut off.
    let run = folder.run(&["eval", "f.basis", "F", "--at", "z=0..2:1,u=0..1:1/2,v=0..1:1/2"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("z = 2 is outside of the domain"), "{}", run.stderr);
}

#[test]
fn spans_take_the_points_that_lie_on_them() {
    let spec = "family M { domain 0 <= x <= 1, 1 <= x <= 3; f[0] = x | (3 - x)/2; f[1] = x^2; }";
    let folder = Folder::with("m.basis", spec);
    let run = folder.run(&[
        "eval",
        "m.basis",
        "M",
        "--at",
        "x=-1..4:1",
        "--anyway",
        "--order",
        "1",
        "--format",
        "csv",
    ]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert_eq!(
        run.stdout,
        "x,f[0],f[1],D(f[0]),D(f[1])\n-1,-1,1,1,-2\n0,0,0,1,0\n1,1,1,-1/2,2\n2,1/2,4,-1/2,4\n3,0,9,-1/2,6\n4,-1/2,16,-1/2,8\n"
    );
}

/// At a knot the later span counts, as in generated code, and it is named.
#[test]
fn a_knot_belongs_to_the_later_span() {
    let spec = "family Hat { domain 0 <= x <= 1, 1 <= x <= 3; f[0] = x | (3 - x)/2; }";
    let folder = Folder::with("h.basis", spec);
    let run = folder.run(&["eval", "h.basis", "--at", "x=1", "--order", "1"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.starts_with("Hat on 1 <= x <= 3 at x = 1\n"), "{}", run.stdout);
    assert!(run.stdout.contains("D(f[0])   -1/2"), "{}", run.stdout);
    let json = folder.run(&["eval", "h.basis", "--at", "x=1/2", "--format", "json"]).json();
    assert_eq!((&json["span"], &json["at"]["x"]), (&"0 <= x <= 1".into(), &"1/2".into()));
}

#[test]
fn the_only_family_need_not_be_named() {
    let folder = Folder::with("q.basis", QUARTIC).and("b.basis", format!("{QUARTIC}{BERNSTEIN}"));
    let run = folder.run(&["eval", "q.basis", "--shape", "λ=1", "--at", "t=1/2"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.starts_with("QuarticBernstein at λ = 1, t = 1/2\n"), "{}", run.stdout);
    let run = folder.run(&["eval", "b.basis", "--at", "t=1/2"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("name one of them: QuarticBernstein, Bern(1)"), "{}", run.stderr);
    let run = folder.run(&["explain", "q.basis", "--to", "Bernstein(4)"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
}

#[test]
fn a_list_has_one_value_or_several() {
    let spec = "family W { domain 0 <= t <= 1; shape 0 < w[i] for i in 0..=1; b[0] = w[0]*t; b[1] = w[1]; }";
    let folder = Folder::with("w.basis", spec);
    let run = folder.run(&["eval", "w.basis", "--shape", "w=2", "--at", "t=1/2"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.starts_with("W at w[0] = 2, w[1] = 2, t = 1/2\n"), "{}", run.stdout);
    // An entry of its own counts more than all, wherever it stands.
    for shapes in [["w=2", "w[1]=3"], ["w[1]=3", "w=2"]] {
        let run =
            folder.run(&["eval", "w.basis", "--shape", shapes[0], "--shape", shapes[1], "--at", "t=1/2"]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        assert!(run.stdout.starts_with("W at w[0] = 2, w[1] = 3, t = 1/2\n"), "{}", run.stdout);
    }
    for twice in ["w[1]=4", "w=4"] {
        let shapes = ["--shape", "w=2", "--shape", "w[1]=3", "--shape", twice];
        let run = folder.run(&[&["eval", "w.basis", "--at", "t=1/2"], &shapes[..]].concat());
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("is given twice"), "{}", run.stderr);
    }
    for shape in [&["w=1..2"][..], &["w=1..2", "w[0]=3"]] {
        let shapes = shape.iter().flat_map(|shape| ["--shape", *shape]).collect::<Vec<_>>();
        let run = folder.run(&[&["plot", "w.basis"], &shapes[..], &["-o", "-"]].concat());
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    }
}

#[test]
fn decimals_are_decimals_in_all_columns() {
    let folder = Folder::with("q.basis", QUARTIC);
    let shape = ["--shape", "λ=1/2", "--at", "t=0..1/2:1/4", "--format", "csv", "--decimal"];
    let run = folder.run(&[&["eval", "q.basis"], &shape[..]].concat());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.contains("\n0.5,0.25,"), "{}", run.stdout);
    assert!(!run.stdout.contains('/'), "{}", run.stdout);
}

#[test]
fn degrees_are_translated() {
    let spec = "family T { domain 0 <= θ <= pi/2; b[0] = sin(θ); }";
    let folder = Folder::with("t.basis", spec);
    for (typed, meant) in [("45deg", "pi/4"), ("30°", "pi/6"), ("-120 degrees", "-2*pi/3"), ("0deg", "0")] {
        let run = folder.run(&["eval", "t.basis", "--at", &format!("θ={typed}")]);
        assert_eq!(run.code, 2);
        let message = format!("is in degrees, and angles are in radians; write {meant}\n");
        assert!(run.stderr.contains(&message), "{}", run.stderr);
    }
}
