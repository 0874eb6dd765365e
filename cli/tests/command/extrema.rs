//! `basis explain` states zeros and extrema of functions of several variables, and of functions with a variable
//! beside its sine. All values were compared with a search among points computed in Python, apart from this code.

use crate::support::Folder;

/// The lines about functions that are negative somewhere, each without its indentation.
fn lines(spec: &str) -> Vec<String> {
    let run = Folder::with("f.basis", spec).run(&["explain", "f.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let parts = run.stdout.split("  Functions that are negative somewhere\n").skip(1);
    parts.flat_map(|part| part.lines().take_while(|l| !l.is_empty()).map(|l| l.trim().to_string())).collect()
}

#[track_caller]
fn compare(spec: &str, expected: &[&str]) {
    let found = lines(spec);
    assert_eq!(found, expected, "\n{}", found.join("\n"));
}

#[test]
fn on_a_triangle() {
    compare(
        "family Saddle { domain triangle (u, v, w);
            a[0] = u*v - 2*v*w + u*w/3; a[1] = u^3 + v^3 + w^3 - 4*u*v*w - 1/4; a[2] = u*(u - v)*(2*w - 1);
            a[3] = (u - v)^2*(w - 1/2); a[4] = w*(5*w^2 - 5*w + 1); a[5] = (u^2 + v^2)*(3*w - 1);
            a[6] = -(3*u - 1)^2 - (3*v - 1)^2; a[7] = u*v*w; a[8] = w - 1; }",
        &[
            "a[0]: zero on the curve u + 8*u*v + 6*v^2 = 6*v + u^2; least value -1/2 at (u, v, w) = (0, 1/2, 1/2); \
             greatest value 1/4 at (u, v, w) = (1/2, 1/2, 0)",
            "a[1]: zero on the curve 12*u + 12*v = 3 + 12*u^2 + 8*u*v + 12*v^2 + 4*u^2*v + 4*u*v^2; least value -31/108 at \
             (u, v, w) = (1/3, 1/3, 1/3); greatest value 3/4 at (u, v, w) = (1, 0, 0), (0, 1, 0), (0, 0, 1)",
            "a[2]: zero on the lines u = 0, u = v and w = 1/2; least value -1 at (u, v, w) = (1, 0, 0); greatest value 1/8 at \
             (u, v, w) = (1/4, 3/4, 0)",
            "a[3]: zero on the lines u = v and w = 1/2; least value -1/2 at (u, v, w) = (1, 0, 0), (0, 1, 0); greatest value \
             1/54 at (u, v, w) = (1/3, 0, 2/3), (0, 1/3, 2/3)",
            // A function of one coordinate is constant on lines, irrational ones among them.
            "a[4]: zero on the lines w = 0, w = 1/2 + 1/10*sqrt(5) and w = 1/2 - 1/10*sqrt(5); least value -1/27 - 4/135*sqrt(10) \
             on the line w = 1/3 + 1/15*sqrt(10); greatest value 1 at (u, v, w) = (0, 0, 1)",
            "a[5]: zero on the line w = 1/3 and at (u, v, w) = (0, 0, 1); least value -1 at (u, v, w) = (1, 0, 0), (0, 1, 0); \
             greatest value 32/243 at (u, v, w) = (4/9, 0, 5/9), (0, 4/9, 5/9)",
            "a[6]: zero at (u, v, w) = (1/3, 1/3, 1/3); least value -5 at (u, v, w) = (1, 0, 0), (0, 1, 0); greatest value 0 at \
             (u, v, w) = (1/3, 1/3, 1/3)",
            "a[8]: zero at (u, v, w) = (0, 0, 1); least value -1 on the line w = 0; greatest value 0 at (u, v, w) = (0, 0, 1)",
        ],
    );
}

#[test]
fn on_a_rectangle() {
    compare(
        "family Plate { domain -1 <= x <= 2, 0 <= y <= 1;
            c[0] = (x^2 - 2)*(y^2 - y + 1/8); c[1] = x^3 - 3*x*y - 1; c[2] = x^4 + y^4 - x*y;
            c[3] = (x^2 + y^2 - 1/4)^2 - 1/9; c[4] = x^2 - 1/2; c[5] = x*y/(1 + x^2 + y^2); c[6] = -2;
            c[7] = x^5 - 2*x^2*y^3 + y - 1/3*x*y; }",
        &[
            "c[0]: zero on the lines x = sqrt(2), y = 1/2 + 1/4*sqrt(2) and y = 1/2 - 1/4*sqrt(2); least value -1/4 at (x, y) = \
             (2, 1/2), (0, 0), (0, 1); greatest value 1/4 at (x, y) = (2, 0), (2, 1), (0, 1/2)",
            "c[1]: zero on the curve x^3 = 1 + 3*x*y; least value -3 at (x, y) = (1, 1); greatest value 7 at (x, y) = (2, 0)",
            "c[2]: zero on the curve x^4 + y^4 = x*y; least value -1/8 at (x, y) = (1/2, 1/2); greatest value 16 at (x, y) = (2, 0)",
            // A circle of stationary points.
            "c[3]: zero on the curve 144*x^4 + 288*x^2*y^2 + 144*y^4 = 7 + 72*x^2 + 72*y^2; least value -1/9 on the curve \
             4*x^2 + 4*y^2 = 1; greatest value 3233/144 at (x, y) = (2, 1)",
            "c[4]: zero on the lines x = 1/2*sqrt(2) and x = -1/2*sqrt(2); least value -1/2 on the line x = 0; greatest value 7/2 \
             on the line x = 2",
            "c[5]: zero on the lines x = 0 and y = 0; least value -1/3 at (x, y) = (-1, 1); greatest value 1/4*sqrt(2) at (x, y) = \
             (sqrt(2), 1)",
            "c[6]: constant, -2",
            // Stationary points of a high degree.
            "c[7]: zero on the curve 3*y + 3*x^5 = x*y + 6*x^2*y^3; least value between -1.666668 and -1.666666; greatest value \
             between 32.026189 and 32.026191; the values are bounds, the exact ones were not found",
        ],
    );
}

#[test]
fn in_space() {
    compare(
        "family Cone { domain tetrahedron (a, b, c, d); g[0] = 3*a*b - c*d; g[1] = 256*a*b*c*d - 1/2; g[2] = (a - b)*(c - d);
            g[3] = 1 - 3*d; }
        family Bar { domain triangle (u, v, w), 0 <= z <= 2; h[0] = u*v*(z - 1); h[1] = z - u - 1/2;
            h[2] = w*(2*w - 1)*(2 - z); h[3] = u - v; }
        family Cube { domain 0 <= x <= 1, 0 <= y <= 1, -1 <= z <= 1; k[0] = x*y*z; k[1] = (x - 1/3)*(y^2 - 1/2); }",
        &[
            "g[0]: zero on the surface 3*a*b + a*c + b*c + c^2 = c; least value -1/4 at (a, b, c, d) = (0, 0, 1/2, 1/2); greatest \
             value 3/4 at (a, b, c, d) = (1/2, 1/2, 0, 0)",
            "g[1]: zero on the surface 512*a*b*c = 1 + 512*a^2*b*c + 512*a*b^2*c + 512*a*b*c^2; least value -1/2 on the planes \
             a = 0, b = 0, c = 0 and d = 0; greatest value 1/2 at (a, b, c, d) = (1/4, 1/4, 1/4, 1/4)",
            "g[2]: zero on the planes a = b and d = c; least value -1/4 at (a, b, c, d) = (0, 1/2, 1/2, 0), (1/2, 0, 0, 1/2); \
             greatest value 1/4 at (a, b, c, d) = (1/2, 0, 1/2, 0), (0, 1/2, 0, 1/2)",
            "g[3]: zero on the plane d = 1/3; least value -2 at (a, b, c, d) = (0, 0, 0, 1); greatest value 1 on the plane d = 0",
            "h[0]: zero on the planes u = 0, v = 0 and z = 1; least value -1/4 at (u, v, w, z) = (1/2, 1/2, 0, 0); greatest value \
             1/4 at (u, v, w, z) = (1/2, 1/2, 0, 2)",
            "h[1]: zero on the plane 2*z = 1 + 2*u; least value -3/2 at (u, v, w, z) = (1, 0, 0, 0); greatest value 3/2 on the \
             line u = 0, z = 2",
            "h[2]: zero on the planes w = 0, z = 2 and w = 1/2; least value -1/4 on the line w = 1/4, z = 0; greatest value 2 at \
             (u, v, w, z) = (0, 0, 1, 0)",
            "h[3]: zero on the plane u = v; least value -1 on the line u = 0, v = 1; greatest value 1 on the line u = 1, v = 0",
            "k[0]: zero on the planes x = 0, y = 0 and z = 0; least value -1 at (x, y, z) = (1, 1, -1); greatest value 1 at \
             (x, y, z) = (1, 1, 1)",
            "k[1]: zero on the planes x = 1/3 and y = 1/2*sqrt(2); least value -1/3 on the line x = 1, y = 0; greatest value 1/3 on \
             the line x = 1, y = 1",
        ],
    );
}

/// At shape values that are named, with angles as coordinates; where nothing is stated there is a reason.
#[test]
fn with_parameters_angles_and_numbers() {
    compare(
        "family Shaped { domain triangle (u, v, w); shape 0 <= k <= 2; s[0] = u - k*v; s[1] = u; }
        family Sector { domain 0 <= t <= pi/2, 0 <= r <= 1; q[0] = r*cos(t) - 1/2; q[1] = r - 1/2; }
        family Many { domain 0 <= a <= 1, 0 <= b <= 1, 0 <= c <= 1, 0 <= d <= 1; f[0] = a*b*c - d; f[1] = a*b*c*d; }
        family Number { domain 0 <= x <= 1, 0 <= y <= 1; n[0] = x - pi*y; n[1] = x; }",
        &[
            "s[0] at k = 1: zero on the line u = v; least value -1 at (u, v, w) = (0, 1, 0); greatest value 1 at (u, v, w) = \
             (1, 0, 0)",
            "q[0]: zero on the curve 2*r = 1 + tan(t/2)^2 + 2*tan(t/2)^2*r; least value -1/2 on the lines r = 0 and t = pi/2; \
             greatest value 1/2 at (t, r) = (0, 1)",
            "q[1]: zero on the line r = 1/2; least value -1/2 on the line r = 0; greatest value 1/2 on the line r = 1",
            "f[0]: zeros and extrema are not stated: its domain has more than 3 dimensions",
            "n[0]: zeros and extrema are not stated: it contains a number that is not rational",
        ],
    );
}

/// Multiples of π and rational numbers are found exactly, others between bounds.
#[test]
fn beside_sines_and_exponentials() {
    compare(
        "family Mixed { domain 0 <= t <= pi/2; m[0] = t - sin(t); m[1] = t - 2*sin(t); m[2] = sin(t) - 2*t/pi;
            m[3] = t*cos(t) - 1/2; m[4] = (t - pi/4)*(1 + sin(t)); m[5] = (t - 1/2)*(sin(t) - 1/2); }
        family Grow { domain 0 <= t <= 1; e[0] = exp(t) - 3*t; e[1] = exp(t) - 1 - t; e[2] = (2*t - 1)*exp(t); }
        family Arc { shape 0 < α < pi; domain 0 <= t <= α; d[0] = t - sin(t); d[1] = sin(t) - t/2 - 1/8; }
        family Turn { domain -1 <= t <= 1; r[0] = t*(1/2 - sin(pi*t/2)); r[1] = t + sin(pi*t/2); }
        family Touch { domain -pi <= t <= pi; o[0] = (t^2 - 1)*(cos(t) - 1/2)^2; o[1] = t + 2*sin(t); }",
        &[
            "m[1]: zero at t = 0; least value about -0.684853256 at t = pi/3; greatest value 0 at t = 0",
            "m[3]: zero at t = about 0.610031284, t = about 1.098008877; least value -1/2 at t = 0, t = pi/2; greatest value about \
             0.061096338 at t = about 0.860333589",
            "m[4]: zero at t = pi/4; least value -1/4*pi at t = 0; greatest value 1/2*pi at t = pi/2",
            "m[5]: zero at t = 1/2, t = pi/6; least value about -1.20981096e-4 at t = about 0.511779634; greatest value \
             1/4*pi - 1/4 at t = pi/2",
            "e[0]: zero at t = about 0.619061287; least value exp(1) - 3 at t = 1; greatest value 1 at t = 0",
            "e[2]: zero at t = 1/2; least value -1 at t = 0; greatest value exp(1) at t = 1",
            "d[1] at tan(α/2) = 1: zero at t = about 0.255544470; least value -1/8 at t = 0; greatest value about 0.217426628 at \
             t = about 1.047197551",
            "r[0]: zero at t = 0, t = 1/3; least value -3/2 at t = -1; greatest value about 0.040220166 at t = about 0.162678500",
            "r[1]: zero at t = 0; least value -2 at t = -1; greatest value 2 at t = 1",
            "o[1]: zero at t = 0; least value about -3.826445910 at t = -2*pi/3; greatest value about 3.826445910 at t = 2*pi/3",
            "o[0]: zeros and extrema are not stated: a variable stands in it beside its sine or exponential, and its zeros were not \
             separated",
        ],
    );
}

#[test]
fn as_data_and_in_latex() {
    let spec =
        "family F { domain triangle (u, v, w); b[0] = u*(3*w - 1) - 1/9*v; b[1] = (u^2 + v^2)*(3*w - 1); }";
    let folder = Folder::with("f.basis", spec);
    let json = folder.run(&["explain", "f.basis", "--format", "json"]).json();
    let facts = &json["items"][0];
    assert_eq!(facts["extrema"][1]["zeros"], serde_json::json!(["(u, v, w) = (0, 0, 1)"]));
    assert_eq!(
        facts["extrema"][1]["zeros_on"],
        serde_json::json!([{ "kind": "line", "equation": "w = 1/3" }])
    );
    assert_eq!(facts["extrema"][1]["minimum"]["value"], "-1");
    assert_eq!(facts["extrema"][1]["maximum"]["on"], serde_json::json!([]));
    assert_eq!(facts["extrema"][1]["bounds"], false);
    assert_eq!(facts["extrema_open"], serde_json::json!([]));
    let latex = folder.run(&["explain", "f.basis", "--format", "latex"]).stdout;
    let sentence = "has zeros on the line $w = \\frac{1}{3}$ and at $\\left(u, v, w\\right) = \\left(0, 0, 1\\right)$, the least value";
    assert!(latex.contains(sentence), "{latex}");
}

/// With π and e in their coefficients, which are transcendental, polynomials have all matrices; of quotients it is
/// said that there is no elevation.
#[test]
fn matrices_that_contain_numbers() {
    let spec = "family P { domain 0 <= t <= 1; b[0] = 1 - pi*t; b[1] = exp(1)*t; }
        family Q { domain 0 <= t <= 1; b[0] = (1 - t)/(1 + t); b[1] = 2*t/(1 + t); }";
    let folder = Folder::with("f.basis", spec);
    let json = folder.run(&["explain", "f.basis", "--format", "json"]).json();
    let matrix = |kind: &str| {
        let all = json["items"][0]["matrices"].as_array().expect("a list");
        all.iter().find(|m| m["kind"] == kind).expect("a matrix")["entries"].clone()
    };
    assert_eq!(matrix("to_bernstein"), serde_json::json!([["1", "1 - pi"], ["0", "exp(1)"]]));
    let back = serde_json::json!([["1", "pi*exp(-1) - exp(-1)"], ["0", "exp(-1)"]]);
    assert_eq!(matrix("from_bernstein"), back);
    let raised = serde_json::json!([["1", "1 - 1/2*pi", "1 - pi"], ["0", "1/2*exp(1)", "exp(1)"]]);
    assert_eq!(matrix("elevation"), raised);
    assert_eq!(json["items"][0]["matrices_open"], serde_json::Value::Null);
    let why = "No degree elevation is stated: the functions are quotients, and it would depend on weights.";
    assert_eq!(json["items"][1]["matrices_open"], why);
}
