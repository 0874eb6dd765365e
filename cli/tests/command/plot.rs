//! `basis plot`: what is drawn, and what is refused.

use std::fs;

use crate::support::{BERNSTEIN, Folder, QUARTIC};
use serde_json::{Value, json};

/// The picture that a call writes.
fn drawn(folder: &Folder, arguments: &[&str], file: &str) -> String {
    let run = folder.run(&[&["plot"], arguments, &["-o", file]].concat());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{arguments:?}");
    assert_eq!(run.stdout, format!("wrote {file}\n"));
    let bytes = fs::read(folder.path().join(file)).expect("it is written");
    String::from_utf8(bytes).expect("it is a text")
}

fn count(text: &str, part: &str) -> usize {
    text.matches(part).count()
}

/// The coordinates of the last point of each path that has a title.
fn ends(svg: &str, title: &str) -> Vec<f64> {
    let before = svg.split(&format!("<title>{title}</title>")).next().expect("there is a path");
    let path = before.rsplit("<path").next().expect("there is a path");
    let data = path.split("d=\"").nth(1).and_then(|d| d.split('"').next()).expect("it has data");
    let last = data.rsplit(['L', 'M']).next().expect("it has points");
    last.split(' ').map(|x| x.parse().expect("it is a number")).collect()
}

#[test]
fn each_function_is_a_line() {
    let folder = Folder::with("q.basis", QUARTIC);
    let svg = drawn(&folder, &["q.basis", "--shape", "λ=1/2"], "q.svg");
    assert_eq!(count(&svg, "<path"), 4);
    for part in ["QuarticBernstein", "0 ≤ t ≤ 1,  λ = 1/2", "b[3]", "<title>b[0], λ = 1/2</title>"] {
        assert!(svg.contains(part), "{part}");
    }
    // At t = 1 the last function is 1 and the others are 0.
    let heights: Vec<f64> = (0..4).map(|k| ends(&svg, &format!("b[{k}], λ = 1/2"))[1]).collect();
    assert!(
        heights[0] == heights[1] && heights[1] == heights[2] && heights[3] < heights[2] - 300.0,
        "{heights:?}"
    );
    assert_eq!(drawn(&folder, &["q.basis", "QuarticBernstein", "--shape", "lambda=0.5"], "r.svg"), svg);
}

#[test]
fn a_range_of_shape_values_gives_a_family_of_lines() {
    let folder = Folder::with("q.basis", QUARTIC);
    let points = ["--points", "0,0 1,2 3,2 4,-0.5"];
    let svg = drawn(&folder, &[&["q.basis", "--shape", "λ=-3..1"][..], &points].concat(), "q.svg");
    // Five lines for each function, five curves and the polygon.
    assert_eq!(count(&svg, "<path"), 4 * 5 + 5 + 1);
    assert_eq!((count(&svg, "class=\"curve\""), count(&svg, "class=\"polygon\"")), (5, 1));
    for value in ["λ = −3", "λ = −2", "λ = −1", "λ = 0", "λ = 1", "P[3]"] {
        assert!(
            svg.contains(&format!(">\n{value}\n<")) || svg.contains(&format!(">{value}<")),
            "{value}: {svg}"
        );
    }
    // What has one value for all lines stands above.
    let two = QUARTIC.replace("shape", "shape 0 <= μ <= 1; shape");
    let svg = drawn(
        &Folder::with("t.basis", &two),
        &["t.basis", "--shape", "λ=-3..1", "--shape", "μ=1/3"],
        "t.svg",
    );
    assert!(svg.contains("0 ≤ t ≤ 1,  μ = 1/3"), "{svg}");
    // Ends that a range leaves out are not drawn.
    let open = QUARTIC.replace("-3 <= λ <= 1", "-3 < λ < 1");
    let svg = drawn(&Folder::with("o.basis", &open), &["o.basis", "--shape", "λ=-3..1"], "o.svg");
    assert!(!svg.contains("λ = −3") && svg.contains("λ = −7/3") && svg.contains("λ = 1/3"));
}

#[test]
fn functions_of_two_variables_are_maps() {
    let spec = "family T { domain triangle (u, v, w); permute b[2,0,0] = u^2; permute b[1,1,0] = 2*u*v; }
family B { domain -1 <= x <= 1, 0 <= y <= 2; f[0] = x*y; f[1] = (1 - x)*(2 - y); }";
    let folder = Folder::with("s.basis", spec);
    let svg = drawn(&folder, &["s.basis", "T"], "t.svg");
    assert!(count(&svg, "<path") >= 6 && count(&svg, "<polygon") == 6);
    for part in ["b[0,1,1]", "u = 1", "v = 1", "w = 1"] {
        assert!(svg.contains(part), "{part}");
    }
    // Values below zero have colours of their own.
    let svg = drawn(&folder, &["s.basis", "B"], "b.svg");
    assert!(svg.contains("−2") && svg.contains("x →") && svg.contains("#a00a1e"), "{svg}");
    // The name of the variable that grows upwards ends left of the box, and begins inside of the picture.
    let name = svg.split("y ↑").next().and_then(|s| s.rsplit("<text").next()).expect("a name");
    let x: f64 = name.split(" x=\"").nth(1).and_then(|x| x.split('"').next()?.parse().ok()).expect("a place");
    assert!(x > 30.0, "{name}");
}

/// Functions of three variables are cut: a prism at a height, a box at a value of any of its variables.
#[test]
fn functions_of_three_variables_are_cut() {
    let spec = "family Prism {
    domain 0 <= z <= 2, triangle (u, v, w);
    b[0] = u*z/2;
    b[1] = 3/4 - u*z/2;
    prove b[1] >= 0;
}
family Solid { domain 0 <= x <= 1, 0 <= y <= 1, 0 <= z <= 1; b[0] = x*y*z; b[1] = 1 - x*y*z; }";
    let folder = Folder::with("p.basis", spec);
    // Without a height at that of the counterexample, which is marked.
    let svg = drawn(&folder, &["p.basis", "Prism"], "p.svg");
    let height = svg.split("cut at z = ").nth(1).and_then(|rest| rest.lines().next()).expect("a height");
    assert!(svg.contains(&format!("z = {height}, u = ")) && svg.contains("w = 1"), "{svg}");
    assert_eq!(count(&svg, "class=\"counterexample\""), 1);
    // At another height its place is not in the picture, and the functions have other values.
    let svg = drawn(&folder, &["p.basis", "Prism", "--at", "z=1/5"], "q.svg");
    assert!(svg.contains("triangle (u, v, w),  cut at z = 1/5"), "{svg}");
    assert_eq!(count(&svg, "class=\"counterexample\""), 0);
    let data = page_data(&drawn(&folder, &["p.basis", "Prism", "--at", "z=1/5"], "p.html"));
    assert_eq!(
        (&data["kind"], &data["pieces"][0]["functions"][0]["numer"][0][0]),
        (&json!("triangle"), &json!(0.1))
    );
    let data = page_data(&drawn(&folder, &["p.basis", "Solid", "--at", "y=1/4"], "s.html"));
    assert_eq!((&data["kind"], &data["variables"]), (&json!("box"), &json!(["x", "z"])));
    for (arguments, why) in [
        (&["Prism", "--at", "u=1/2"][..], "`u` is not an interval of the domain of `Prism`"),
        (&["Prism", "--at", "z=3"], "z = 3 is outside of the domain `0 <= z <= 2`"),
        (&["Prism", "--at", "z=0..1"], "are cut at one value of `z`"),
    ] {
        let run = folder.run(&[&["plot", "p.basis"], arguments].concat());
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.stdout);
        assert!(run.stderr.contains(why), "{arguments:?}: {}", run.stderr);
    }
}

/// Where there are more functions than colours, neighbours differ beside their colours.
#[test]
fn many_lines_can_be_told_apart() {
    let folder = Folder::with("b.basis", BERNSTEIN);
    let svg = drawn(&folder, &["b.basis", "Bern(12)"], "b.svg");
    // Lines and their signs in the legend: five whole ones of thirteen, and of the others two kinds.
    let [long, short] = ["8 4", "2 3"].map(|dashes| count(&svg, &format!("stroke-dasharray=\"{dashes}\"")));
    assert_eq!((long, short), (8, 8));
    let few = drawn(&folder, &["b.basis", "Bern(3)"], "few.svg");
    assert_eq!(count(&few, "stroke-dasharray"), 0);
}

#[test]
fn a_counterexample_is_marked() {
    let wide = QUARTIC
        .replace("-3 <= λ", "-4 <= λ")
        .replace("prove partition", "prove nonnegative; prove partition");
    let folder = Folder::with("q.basis", &wide);
    // Without shape values those at which the claim fails are drawn.
    let svg = drawn(&folder, &["q.basis"], "q.svg");
    assert_eq!(count(&svg, "class=\"counterexample\""), 1);
    assert!(svg.contains("nonnegative: b[1] is −16/625 at λ = −4, t = 1/5"), "{svg}");
    assert_eq!(count(&drawn(&folder, &["q.basis", "--shape", "λ=1/2"], "r.svg"), "counterexample"), 0);
    // That functions depend is so at a shape value, and at no point that one could see.
    let dependent = QUARTIC.replace("refute b[0] = b[1]", "refute independent");
    let svg = drawn(&Folder::with("q.basis", &dependent), &["q.basis"], "s.svg");
    assert!(svg.contains("λ = 1/2"), "{svg}");
    assert_eq!(count(&svg, "counterexample"), 0);
}

#[test]
fn counterexamples_at_ends_of_angles_and_several_at_one_point_are_marked() {
    let spec = "family Wave {
    domain 0 <= t <= pi/2;
    f[0] = cos(t);
    f[1] = sin(t);
    prove f[0] <= 1/2;
    prove f[0] <= 3/4;
    prove f[1] <= 1/2;
}
family Growth {
    domain 0 <= t <= 2;
    g[0] = exp(t)/8;
    g[1] = exp(-t);
    prove g[0] <= 1/2;
    prove g[1] <= 1/2;
}";
    let folder = Folder::with("w.basis", spec);
    for (family, marks) in [("Wave", 2), ("Growth", 2)] {
        let svg = drawn(&folder, &["w.basis", family], "w.svg");
        assert_eq!(count(&svg, "class=\"counterexample\""), marks, "{family}: {svg}");
        assert_eq!(svg.contains(">1, 2<") || svg.contains("1, 2\n"), family == "Wave", "{svg}");
    }
}

/// What a page draws.
fn page_data(html: &str) -> Value {
    let data = html.split("const data = ").nth(1).and_then(|rest| rest.split(";\n").next());
    serde_json::from_str(data.expect("it has data")).expect("it is JSON")
}

#[test]
fn a_page_is_one_file_with_sliders() {
    let folder = Folder::with("q.basis", &format!("/// A </script> & more.\n{QUARTIC}"));
    let html = drawn(&folder, &["q.basis", "--points", "0,0 1,2 3,2 4,0"], "q.html");
    assert_eq!(count(&html, "</script>"), 1);
    assert!(
        !html.contains("http://") || count(&html, "http://") == count(&html, "http://www.w3.org/2000/svg")
    );
    assert!(!html.contains("https://") && !html.contains("src="));
    let data = page_data(&html);
    assert_eq!(data["shapes"][0]["name"], "λ");
    assert_eq!(data["functions"].as_array().expect("a list").len(), 4);
    assert_eq!(data["points"][1], json!([1.0, 2.0]));
}

#[test]
fn a_png_is_written_where_there_are_letters() {
    let folder = Folder::with("b.basis", BERNSTEIN);
    let run = folder.run(&["plot", "b.basis", "Bern(12)", "-o", "b.png"]);
    if run.stderr.contains("no fonts") {
        assert_eq!(run.code, 2);
        eprintln!("skipped: this machine has no fonts");
        return;
    }
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let png = fs::read(folder.path().join("b.png")).expect("it is written");
    assert!(png.starts_with(b"\x89PNG\r\n") && png.len() > 20_000);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let solid = "family S { domain tetrahedron (u, v, w, x); permute b[1,0,0,0] = u; }";
    let folder = Folder::with("q.basis", QUARTIC).and("s.basis", solid).and("b.basis", BERNSTEIN);
    let two = QUARTIC.replace("shape", "shape 0 <= μ <= 1; shape");
    let folder =
        folder.and("two.basis", &two).and("wrong.basis", "family F { domain 0 <= t <= 1; b[0] = x; }");
    for (arguments, why) in [
        (&["q.basis", "--shape", "λ=2"][..], "λ = 2 is outside of the declared range `-3 <= λ <= 1`"),
        (&["q.basis", "--shape", "λ=-4..1"], "λ = -4 is outside"),
        (&["q.basis", "--shape", "λ=1..0"], "the range 1..0 is empty"),
        (&["q.basis", "--shape", "λ=0..x"], "`x` is not an exact number"),
        (&["q.basis", "--shape", "μ=1"], "`μ` is not a shape parameter"),
        (&["q.basis", "--shape", "λ=1,λ=0"], "given twice"),
        (&["two.basis", "--shape", "λ=0..1,μ=0..1"], "both given as ranges"),
        (&["q.basis", "--points", "0,0 1,1"], "needs as many control points, not 2"),
        (&["q.basis", "--points", "0,0 1,1 2,0 x"], "`x` is not a point"),
        (&["s.basis"], "have 3 variables and no picture"),
        (&["q.basis", "--at", "t=1/2"], "are drawn whole"),
        (&["q.basis", "Quartik"], "there is no family"),
        (&["wrong.basis"], "the name `x` is not declared"),
        (&["nowhere.basis"], "there is no spec file"),
        (&["q.basis", "-o", "q.gif"], "does not say what kind of picture"),
        (&["q.basis", "-o", "no/q.svg"], "cannot write"),
        (&["library:triangular"], "the spec has several families"),
        (&["library:triangular", "TriangularII(3)", "--shape", "λ1=1..2"], "functions of one variable only"),
    ] {
        let run = folder.run(&[&["plot"], arguments].concat());
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.stdout);
        assert!(run.stderr.contains(why), "{arguments:?}: {}", run.stderr);
    }
}

/// A shape parameter that is an angle has its own name and values, multiples of pi among them.
#[test]
fn angles_are_given_as_angles() {
    let spec = "family Arc { shape 0 < α < pi; domain 0 <= t <= α; b[0] = (1 - cos(α - t))/(1 - cos(α)); b[1] = sin(t)/sin(α); }";
    let folder = Folder::with("a.basis", spec);
    let svg = drawn(&folder, &["a.basis", "--shape", "α=pi/3"], "Arc.svg");
    assert!(svg.contains("α = pi/3"), "{svg}");
    let svg = drawn(&folder, &["a.basis", "--shape", "alpha=0..pi"], "Arc.svg");
    assert!(svg.contains("α = pi/6") && svg.contains("α = 5*pi/6"), "{svg}");
    let svg = drawn(&folder, &["a.basis", "--shape", "tan(α/2)=1"], "Arc.svg");
    assert!(svg.contains("tan(α/2) = 1"), "{svg}");
    let run = folder.run(&["plot", "a.basis", "--shape", "α=4"]);
    assert!(run.stderr.contains("α = 4 is outside of the declared range `0 < α < pi`"), "{}", run.stderr);
}

/// The axis is that of the angle, and the values are those of sines.
#[test]
fn angles_are_drawn_as_angles() {
    let spec = "family Turn {
    domain 0 <= θ <= pi/2;
    b[0] = 1 - sin(θ);
    b[1] = sin(θ) + cos(θ) - 1;
    b[2] = 1 - cos(θ);
}
family Mixed { domain 0 <= t <= 1; b[0] = t - sin(pi*t/2)*2/pi; b[1] = 1 - t; }";
    let folder = Folder::with("s.basis", spec);
    let svg = drawn(&folder, &["s.basis", "Turn"], "s.svg");
    let path =
        svg.split("<title>b[0]</title>").next().and_then(|s| s.rsplit("<path").next()).expect("a line");
    let data = path.split("d=\"").nth(1).and_then(|d| d.split('"').next()).expect("it has data");
    let points: Vec<[f64; 2]> = data
        .trim_start_matches('M')
        .split('L')
        .map(|p| {
            p.split_once(' ').map(|(x, y)| [x, y].map(|x| x.parse().expect("a number"))).expect("a point")
        })
        .collect();
    let ([left, top], [right, bottom]) = (points[0], points[points.len() - 1]);
    for [x, y] in &points {
        let angle = (x - left) / (right - left) * core::f64::consts::FRAC_PI_2;
        let expected = bottom - (bottom - top) * (1.0 - angle.sin());
        assert!((y - expected).abs() < 0.02, "{angle}: {y} {expected}");
    }
    // A function of t and sin t: 0 at 0, 1 - 2/π at 1.
    let svg = drawn(&folder, &["s.basis", "Mixed"], "m.svg");
    let (a, b) = (ends(&svg, "b[0]")[1], ends(&svg, "b[1]")[1]);
    let unit = 380.0 / 1.05 / 1.05;
    assert!((b - a) / unit > 0.3 && (b - a) / unit < 0.42, "{a} {b}");
}

/// The tangent of half a shape value has many digits, and the coefficients more than floats have room for.
#[test]
fn a_variable_beside_its_sine_is_drawn_at_any_shape_value() {
    let folder = Folder::with("s.basis", "");
    for shape in ["α=1", "α=1..3", "α=pi/3"] {
        let svg = drawn(
            &folder,
            &["library:trigonometric/mixed", "CBezierCubic", "--shape", shape, "--points", "0,0 1,2 3,2 4,0"],
            "s.svg",
        );
        assert!(count(&svg, "<path") >= 5 && count(&svg, "d=\"\"") == 0, "{shape}");
    }
}

/// Where a domain ends at shape parameters, the variable of the formulas runs from 0 to 1 on each span.
#[test]
fn counterexamples_between_knots_that_are_parameters_are_marked() {
    let spec = "family Roof {
    shape 1 <= h <= 2, 1 <= k <= 3;
    domain 0 <= x <= h, h <= x <= h + k;
    f[0] = 1 - x/(4*h) | (x - h)/k - 1/4;
    prove f[0] <= 2/3;
    prove nonnegative;
}";
    let folder = Folder::with("r.basis", spec);
    let data = page_data(&drawn(&folder, &["r.basis"], "r.html"));
    let failures = data["failures"].as_array().expect("a list");
    assert_eq!(failures.len(), 2);
    // Above 2/3 are all y of the first span and y > 11/12 of the second, below 0 y < 1/4 of the second: at the
    // knot as well, which is on both.
    let y: Vec<f64> = failures.iter().map(|f| f["at"][0].as_f64().expect("it has a place")).collect();
    assert!(failures[0]["piece"] == 0 || y[0] > 11.0 / 12.0, "{failures:?}");
    assert!(failures[1]["piece"] == 1 && (0.0..0.25).contains(&y[1]), "{failures:?}");
    let svg = drawn(&folder, &["r.basis", "--shape", "h=1,k=1"], "r.svg");
    // A parameter that plays no part may have any value.
    let ones = |f: &&Value| {
        f["shapes"].as_array().is_some_and(|all| all.iter().all(|x| x.is_null() || *x == json!(1.0)))
    };
    let marked = failures.iter().filter(ones).count();
    assert_eq!(count(&svg, "class=\"counterexample\""), marked);
}

/// A function has a formula for each span.
#[test]
fn spans_are_drawn_one_after_another() {
    let spec = "family S {
    domain 0 <= x <= 1, 1 <= x <= 3, 3 <= x <= 4;
    f[0] = x^2/4 | (-x^2 + 4*x - 2)/4 | (4 - x)^2/4;
    prove smooth(1);
}";
    let folder = Folder::with("s.basis", spec);
    let svg = drawn(&folder, &["s.basis"], "s.svg");
    let path =
        svg.split("<title>f[0]</title>").next().and_then(|s| s.rsplit("<path").next()).expect("a line");
    assert_eq!(path.matches('M').count(), 3, "the pen is lifted twice");
    assert!(svg.contains("0 ≤ x ≤ 1, 1 ≤ x ≤ 3, 3 ≤ x ≤ 4"), "{svg}");
    let data = page_data(&drawn(&folder, &["s.basis"], "s.html"));
    let ranges: Vec<_> = data["pieces"].as_array().expect("a list").iter().map(|p| &p["ranges"][0]).collect();
    assert_eq!(ranges, [&json!([0.0, 1.0]), &json!([1.0, 3.0]), &json!([3.0, 4.0])]);
    // (−x² + 4x − 2)/4 on the second span.
    let second = data["pieces"][1]["functions"][0]["numer"].as_array().expect("a list");
    let mut coefficients: Vec<f64> = second.iter().map(|term| term[0].as_f64().expect("a number")).collect();
    coefficients.sort_by(f64::total_cmp);
    assert_eq!(coefficients, [-0.5, -0.25, 1.0]);
}

#[test]
fn what_is_declared_false_is_marked_in_grey() {
    let spec = "family Bump {
    domain 0 <= t <= 1;
    shape 0 <= a <= 1, 0 <= c <= 1;
    b[0] = 4*a*t*(1 - t);
    b[1] = c*t;
    refute b[0] <= 1/2;
}";
    let folder = Folder::with("b.basis", spec);
    // What is not drawn elsewhere is drawn where the claim fails.
    let svg = drawn(&folder, &["b.basis"], "b.svg");
    let ring = "class=\"counterexample\"";
    let mark = svg.lines().find(|line| line.contains(ring)).expect("there is a mark");
    assert!(mark.contains("stroke=\"#6b6b6b\""), "{mark}");
    assert!(svg.contains("b[0] ≤ 1/2, declared false: "));
    let data = page_data(&drawn(&folder, &["b.basis"], "b.html"));
    let failure = &data["failures"][0];
    assert_eq!(failure["declared"], true);
    assert!(failure["shapes"][0].is_number() && failure["shapes"][1].is_null(), "{failure}");
    // No value of c plays a part.
    assert_eq!(count(&drawn(&folder, &["b.basis", "--shape", "c=1/3"], "b.svg"), ring), 1);
    assert_eq!(count(&drawn(&folder, &["b.basis", "--shape", "a=1/3"], "b.svg"), ring), 0);
    // What is wrongly declared stands first, and in red.
    let folder = Folder::with("b.basis", &spec.replace("refute", "prove b[1] <= 1/2; refute"));
    let svg = drawn(&folder, &["b.basis"], "b.svg");
    let first = svg.lines().find(|line| line.contains(ring)).expect("there is a mark");
    assert!(first.contains("stroke=\"#c1121f\""), "{first}");
}
