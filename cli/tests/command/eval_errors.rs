//! `basis eval`: what is wrong, and what to write instead.

use crate::support::{BERNSTEIN, Folder, QUARTIC};

fn folder() -> Folder {
    Folder::with("quartic.basis", QUARTIC)
        .and("bernstein.basis", BERNSTEIN)
        .and("broken.basis", "family A {\n    domain 0 <= t <= 1;\n    b[0] = 1 - t;\n    b[1] = t +;\n}\n")
        .and(
            "assumed.basis",
            "family Pair { domain 0 <= t <= 1; shape 0 <= p <= 1, 0 <= q <= 1; assume p + q <= 1; b[0] = p*t; b[1] = q; }
            family Line { domain 0 <= t <= 1; shape B, C; assume B + 2*C = 1; b[0] = B*t; b[1] = C; }",
        )
        .and(
            "prism.basis",
            "family F { domain triangle (u, v, w), 0 <= z <= 1, triangle (r, s, t); b[0] = u*z*r; }",
        )
        .and(
            "spans.basis",
            "family F { domain 0 <= x <= 1, 1 <= x <= 2, 2 <= x <= 4; b[0] = x | x | 2; }
            family G { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; }
            theorem T { curve P = G; prove P(0) = P[0]; }
            join J { curve P = G; curve Q = G; let Q[0] = P[1]; prove Q(0) = P(1); }",
        )
        .and("triangle.basis", "family F { domain triangle (u, v, w); b[0] = u*w; }")
        .and(
            "two.basis",
            "family Two(m in 1..=3, n in 1..=9) { domain 0 <= t <= 1; b[0] = t^m; b[1] = t^n; }",
        )
}

/// Runs `basis eval` and demands that it fails with these errors and hints, in this order and no others.
fn fails(arguments: &str, errors: &[(&str, &str)]) {
    let arguments: Vec<&str> = ["eval"].into_iter().chain(arguments.split_whitespace()).collect();
    let run = folder().run(&arguments);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?}");
    let printed: Vec<&str> = run.stderr.split("error: ").skip(1).collect();
    assert_eq!(printed.len(), errors.len(), "{}", run.stderr);
    for (text, (message, help)) in printed.iter().zip(errors) {
        assert!(text.starts_with(message), "{text}");
        assert!(text.contains(help), "{text}");
    }
}

#[test]
fn families() {
    fails(
        "quartic.basis QuarticBernstien --at t=1",
        &[("there is no family `QuarticBernstien`", "did you mean `QuarticBernstein`?")],
    );
    fails("quartic.basis Cubic --at t=1", &[("there is no family `Cubic`", "QuarticBernstein")]);
    fails("quartic.basis (3) --at t=1", &[("`(3)` is not a family", "write its name")]);
    fails("quartic.basis Bernstein(3 --at t=1", &[("`Bernstein(3` is not a family", "write its name")]);
}

/// What is about a family on several spans names all of them.
#[test]
fn several_spans() {
    let whole = "`0 <= x <= 1, 1 <= x <= 2, 2 <= x <= 4`";
    let outside = format!("x = 5 is outside of the domain {whole}");
    fails("spans.basis F --at x=5", &[(&outside, "--at x=1/2")]);
    fails("spans.basis F --at x=-1", &[(&outside.replace("= 5", "= -1"), "--at x=1/2")]);
    fails("spans.basis F", &[("the domain variable `x` has no value", whole)]);
}

#[test]
fn theorems_are_no_families() {
    fails("spans.basis T --at t=1", &[("`T` is a theorem, not a family", "families here are F, G")]);
    fails("spans.basis J --at t=1", &[("`J` is a join, not a family", "families here are F, G")]);
}

#[test]
fn orders() {
    let at = "--at t=1";
    fails(
        &format!("quartic.basis QuarticBernstein(3) {at}"),
        &[("`QuarticBernstein` has no index parameters", "write `QuarticBernstein`")],
    );
    fails(
        &format!("bernstein.basis Bern {at}"),
        &[("the index parameter `n` has no value", "write `Bern(n=…)`")],
    );
    fails(
        &format!("bernstein.basis Bern(3,4) {at}"),
        &[("`Bern` has only 1 index parameter", "write `Bern(n=…)`")],
    );
    fails(
        &format!("bernstein.basis Bern(m=3) {at}"),
        &[("`m` is not an index parameter of `Bern`", "write `Bern(n=…)`")],
    );
    fails(
        &format!("bernstein.basis Bern(x) {at}"),
        &[("`x` is not the value of an index parameter", "whole numbers")],
    );
    fails(
        &format!("bernstein.basis Bern(1/2) {at}"),
        &[("`1/2` is not the value of an index parameter", "whole numbers")],
    );
    fails(
        &format!("bernstein.basis Bern(13) {at}"),
        &[("n = 13 is outside of the declared range 1..=12", "")],
    );
    fails(
        &format!("bernstein.basis Bern(-1) {at}"),
        &[("n = -1 is outside of the declared range 1..=12", "")],
    );
    fails(
        &format!("two.basis Two(n=1,n=2) {at}"),
        &[("the index parameter `n` is given twice", "write `Two(m=…, n=…)`")],
    );
    fails(
        &format!("two.basis Two(n=5) {at}"),
        &[("the index parameter `m` has no value", "write `Two(m=…, n=…)`")],
    );
}

#[test]
fn names_of_values() {
    let command = "quartic.basis QuarticBernstein";
    let no_shape =
        ("the shape parameter `λ` has no value", "add --shape λ=1/2, or another value with `-3 <= λ <= 1`");
    let no_point =
        ("the domain variable `t` has no value", "add --at t=1/2, or another value with `0 <= t <= 1`");
    fails(command, &[no_shape, no_point]);
    fails(&format!("{command} --at t=1"), &[no_shape]);
    fails(&format!("{command} --shape λ=1"), &[no_point]);
    fails(
        &format!("{command} --shape lamda=1 --at x=1"),
        &[
            ("`lamda` is not a shape parameter", "did you mean `λ`?"),
            ("`x` is not a domain variable", "the only domain variable is `t`"),
        ],
    );
    fails(
        &format!("{command} --shape t=1 --at λ=1"),
        &[
            ("`t` is not a shape parameter", "write --at t=1"),
            ("`λ` is not a domain variable", "write --shape λ=1"),
        ],
    );
    fails(
        &format!("{command} --shape λ=1,lambda=0 --at t=1"),
        &[("the shape parameter `λ` is given twice", "one value")],
    );
    fails(
        "bernstein.basis Bern(2) --at t=1 --shape μ=1",
        &[("`μ` is not a shape parameter of `Bern(2)`", "the family has no shape parameters")],
    );
}

#[test]
fn values_outside_of_their_ranges() {
    fails(
        "quartic.basis QuarticBernstein --shape λ=1.01 --at t=-1/1000",
        &[
            (
                "λ = 101/100 is outside of the declared range `-3 <= λ <= 1`",
                "choose a value inside: --shape λ=1/2",
            ),
            ("t = -1/1000 is outside of the domain `0 <= t <= 1`", "choose a value inside: --at t=1/2"),
        ],
    );
}

#[test]
fn angles_a_turn_away() {
    let folder = Folder::with(
        "m.basis",
        "family M { domain 0 <= t <= pi/2; b[0] = t - sin(t); }\n\
         family N { domain 0 <= t <= 1; shape 0 < α < pi; b[0] = t*cos(α); }\n",
    );
    let said = |arguments: &[&str]| folder.run(&[&["eval", "m.basis"], arguments].concat()).stderr;
    for value in ["7", "-6", "2*pi", "2", "3", "100"] {
        let said = said(&["M", "--at", &format!("t={value}")]);
        assert!(said.contains(&format!("t = {value} is outside of the domain `0 <= t <= pi/2`")), "{said}");
    }
    assert_eq!(said(&["M", "--at", "t=pi/2"]), "");
    assert_eq!(said(&["M", "--at", "t=7", "--anyway"]), "");
    let far = said(&["N", "--at", "t=1/2", "--shape", "α=7"]);
    assert!(far.contains("α = 7 is outside of the declared range `0 < α < pi`"), "{far}");
}

#[test]
fn values_that_break_an_assumption() {
    let pair = "assumed.basis Pair --at t=1 --shape";
    let refused = "p = 1, q = 1/2 is outside of what is assumed: `p + q <= 1`";
    fails(&format!("{pair} p=1,q=1/2"), &[(refused, "--anyway evaluates outside as well")]);
    fails(
        "assumed.basis Line --at t=1 --shape C=1",
        &[("`C` follows from the other shape parameters", "give those instead: `C` is 1/2 - 1/2*B")],
    );
}

#[test]
fn several_points() {
    let command = "bernstein.basis Bern(2) --at";
    fails(&format!("{command} t=0..1"), &[("invalid value 't=0..1'", "as in t=0..1:1/10")]);
    fails(
        &format!("{command} t=1..0:1/2"),
        &[("invalid value 't=1..0:1/2'", "write the smaller value first")],
    );
    fails(&format!("{command} t=0..1:0"), &[("invalid value 't=0..1:0'", "the step 0 is not positive")]);
    fails(&format!("{command} t=0..1:-1/2"), &[("invalid value", "the step -1/2 is not positive")]);
    fails(&format!("{command} t=0..1:1/1000000000000"), &[("invalid value", "more than 100000 steps")]);
    fails(&format!("{command} t=0..1:x"), &[("invalid value", "`x` is not an exact number")]);
    fails(&format!("{command} t=0..2:1"), &[("t = 2 is outside of the domain", "--anyway")]);
    fails(
        &format!("{command} t=0..1:1/10000 --order 400"),
        &[("there are more than 1000000 values", "choose a larger step")],
    );
}

#[test]
fn control_points() {
    let command = ["bernstein.basis", "Bern(2)", "--at", "t=1/2", "--points"];
    let long = "x,y\n0,0\n1,2\n3,a\n";
    for (points, message, help) in [
        ("0,0 1,2", "2 control points are given, `Bern(2)` has 3 functions", "one control point for each"),
        ("0,0 1,2,3 1,1", "the control point 2 has 3 coordinates, the first one has 2", "the same number"),
        ("0,0 1:2 3,4", "`1:2` is not a control point", "write exact numbers with commas"),
        ("", "`` is not a control point", "or name a file"),
        ("long.csv", "`3,a` is not a control point", "line 4 of `long.csv`"),
        ("empty.csv", "cannot read control points from `empty.csv`: it has no points", ""),
    ] {
        let folder = folder().and("long.csv", long).and("empty.csv", "\n\n");
        let run = folder.run(&[&["eval"], &command[..], &[points]].concat());
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{points:?}");
        assert!(run.stderr.starts_with(&format!("error: {message}")), "{}", run.stderr);
        assert!(run.stderr.contains(help), "{}", run.stderr);
    }
}

#[test]
fn points_of_a_triangle() {
    let missing = |name| {
        (
            format!("the domain variable `{name}` has no value"),
            "one of the barycentric coordinates may be left out",
        )
    };
    let (u, v) = (missing("u"), missing("v"));
    fails("triangle.basis F", &[(&u.0, u.1), (&v.0, v.1)]);
    fails("triangle.basis F --at u=1/2", &[(&v.0, v.1)]);
    let domain = "the domain `triangle (u, v, w)`";
    fails(
        "triangle.basis F --at u=1/2,v=1/3,w=1/5",
        &[(&format!("u + v + w = 31/30 on {domain}"), "leave out w")],
    );
    fails(
        "triangle.basis F --at u=3/4,w=1/2",
        &[(&format!("v = -1/4 is outside of {domain}"), "u + v + w = 1")],
    );
    fails(
        "triangle.basis F --at u=-1,v=1",
        &[(&format!("u = -1 is outside of {domain}"), "choose a value inside")],
    );
}

#[test]
fn points_of_a_prism() {
    let missing = |name| format!("the domain variable `{name}` has no value");
    let one = "one of the barycentric coordinates may be left out";
    let (v, z, r, s) = (missing("v"), missing("z"), missing("r"), missing("s"));
    fails(
        "prism.basis F --at u=1/2",
        &[(&v, one), (&z, "another value with `0 <= z <= 1`"), (&r, one), (&s, one)],
    );
    let domain = "the domain `triangle (u, v, w), 0 <= z <= 1, triangle (r, s, t)`";
    fails(
        "prism.basis F --at u=1/2,v=1/3,z=2,r=0,s=0",
        &[(&format!("z = 2 is outside of {domain}"), "--at z=1/2")],
    );
    fails(
        "prism.basis F --at u=1/2,v=1/3,z=1,r=1/2,s=1/2,t=1/2",
        &[(&format!("r + s + t = 3/2 on {domain}"), "leave out t")],
    );
}

#[test]
fn malformed_values() {
    let command = "bernstein.basis Bern(2) --at";
    fails(&format!("{command} t"), &[("invalid value 't'", "write a name and its value, such as t=1/2")]);
    fails(&format!("{command} t=0,5"), &[("invalid value '5'", "decimals are written with a point")]);
    fails(&format!("{command} t="), &[("invalid value 't='", "the value is missing")]);
    fails(&format!("{command} =1/2"), &[("invalid value '=1/2'", "the name is missing")]);
    fails(&format!("{command} t=1/0"), &[("invalid value 't=1/0'", "divides by zero")]);
    fails(&format!("{command} t=1e-3"), &[("invalid value 't=1e-3'", "is not an exact number")]);
    fails(&format!("{command} t=half"), &[("invalid value 't=half'", "is not an exact number")]);
    for order in ["-1", "1/2", "two", "99999999999"] {
        let message =
            format!("invalid value '{order}' for '--order <K>': the highest order of derivatives is a whole");
        fails(&format!("{command} t=1 --order {order}"), &[(&message, "such as 0 or 2")]);
    }
    fails(
        &format!("{command} t=1 --order 999999"),
        &[("there are too many derivatives up to order 999999", "ask for --order")],
    );
}

#[test]
fn specs() {
    fails("missing.basis Bern(2) --at t=1", &[("there is no spec file `missing.basis`", "")]);
    fails(
        "quartic QuarticBernstein --at t=1",
        &[("there is no spec file `quartic`", "did you mean `quartic.basis`?")],
    );
    fails(". QuarticBernstein --at t=1", &[("`.` is a folder, not a spec file", "")]);
    fails(
        "broken.basis A --at t=1",
        &[("expected a number, a name or `(`, found `;`", "--> broken.basis:4:15")],
    );
}
