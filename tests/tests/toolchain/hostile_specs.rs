//! No text makes the engine panic, and every text is answered within the work budgets.

use basis_engine::{Report, Source, check};
use basis_tests::random::Random;

const SHIPPED: [&str; 6] = [
    include_str!("../../../specs/quartic.basis"),
    include_str!("../../../specs/cardinal.basis"),
    include_str!("../../../specs/beta_spline.basis"),
    include_str!("../../../specs/lagrange.basis"),
    include_str!("../../../specs/triangular.basis"),
    include_str!("../../../specs/papers/quadratic.basis"),
];

/// Pieces that a formula can be broken with.
const PIECES: [&str; 24] = [
    "(",
    ")",
    "{",
    "}",
    "[",
    "]",
    "^",
    "-",
    "/0",
    "^999999999",
    "t",
    "λ",
    ";",
    "=",
    "<=",
    "..=",
    "for i in 0..=9999999",
    "sum(",
    "D(",
    "\"",
    "/*",
    "é",
    "\u{0}",
    "9999999999999999999999999999",
];

fn mutate(text: &str, random: &mut Random) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(3) {
        let at = random.below(text.len().max(1));
        match random.below(5) {
            0 => text.truncate(at),
            1 => {
                let end = (at + random.below(12)).min(text.len());
                text.drain(at..end);
            }
            2 => {
                let other = random.below(text.len().max(1));
                if at < text.len() {
                    text.swap(at, other);
                }
            }
            _ => {
                let piece = PIECES[random.below(PIECES.len())];
                text.splice(at..at, piece.chars());
            }
        }
    }
    text.into_iter().collect()
}

/// Every message can be shown with its place.
fn rendered(report: &Report) {
    for diagnostic in &report.diagnostics {
        let text = diagnostic.render(&report.sources, false);
        assert!(text.starts_with("error: ") || text.starts_with("warning: "), "{text}");
    }
}

/// Answers broken versions of a spec: the beginning of it, as much as one or two families.
fn broken_versions_of(spec: usize) {
    let mut random = Random::new(2024 + spec as u64);
    let start: String = SHIPPED[spec].chars().take(1200).collect();
    let mut refused = 0;
    for _ in 0..25 {
        let report = check(Source::text("mutant.basis", &mutate(&start, &mut random)));
        refused += usize::from(!report.diagnostics.is_empty());
        rendered(&report);
    }
    assert!(refused > 12, "only {refused} of 25 broken specs were refused");
}

/// One test for each spec, so that the list of tests tells the progress.
macro_rules! broken {
    ($($name:ident $spec:expr),*) => {$(
        #[test]
        fn $name() {
            broken_versions_of($spec);
        }
    )*};
}

broken! { broken_quartic 0, broken_cardinal 1, broken_beta_spline 2, broken_lagrange 3, broken_triangular 4, broken_paper 5 }

#[test]
fn formulas_that_ask_for_too_much_are_refused() {
    let deep = format!("{}t{}", "(".repeat(5000), ")".repeat(5000));
    for formula in [
        "(1 + t + λ)^100000",
        "(1 + t + λ)^100*(1 + t + λ)^100",
        "((((1 + t + λ)^9)^9)^9)^9",
        "2^(10^9)",
        "2^2^2^2^2^2",
        "factorial(10^9)",
        "sum((t + λ)^i for i in 0..=10^9)",
        "product(t + λ + i for i in 0..=5000)",
        "sum(sum(t^i*λ^j for j in 0..=200) for i in 0..=200)",
        "1/((1 + λ)^150)^2",
        deep.as_str(),
    ] {
        let text = format!("family F {{ domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = {formula}; }}");
        let report = check(Source::text("hostile.basis", &text));
        assert!(!report.diagnostics.is_empty(), "{formula:.60} is accepted");
        rendered(&report);
    }
}

#[test]
fn long_formulas_are_answered() {
    let negative = format!("{}t", "-".repeat(50_000));
    let long = vec!["t"; 20_000].join(" + ");
    for formula in [negative, long] {
        let text = format!("family F {{ domain 0 <= t <= 1; b[0] = {formula}; }}");
        rendered(&check(Source::text("long.basis", &text)));
    }
}

/// Claims about tables of large numbers: more functions than coefficients, and many of high degree.
#[test]
fn tables_of_large_numbers_are_answered() {
    for (claim, functions) in [
        ("refute independent", "b[i] = ((i + 1)/(i + 2) + t)^30 for i in 0..=90;"),
        ("prove independent", "b[i] = binomial(90, i) * t^i * (1 - t)^(90 - i) for i in 0..=90;"),
        ("prove independent", "b[i] = (t + 1/(i + 2))^40 for i in 0..=40;"),
        ("prove independent except λ = 1/3", "b[i] = (t + λ/(i + 2))^14 for i in 0..=14;"),
    ] {
        let text = format!("family F {{ domain 0 <= t <= 1; shape 0 < λ <= 1; {functions} {claim}; }}");
        rendered(&check(Source::text("table.basis", &text)));
    }
}

/// The errors that are the answer.
fn messages(spec: &str) -> Vec<String> {
    let report = check(Source::text("hostile.basis", spec));
    rendered(&report);
    let (errors, warnings): (Vec<_>, Vec<_>) =
        report.diagnostics.iter().partition(|d| d.severity == basis_engine::Severity::Error);
    assert!(warnings.len() <= 20, "{} warnings", warnings.len());
    errors.iter().map(|d| d.message.clone()).collect()
}

/// A family with the functions 1 - t and t, and more statements.
fn with(statements: &str) -> String {
    format!("family F {{ domain 0 <= t <= 1; shape 0 < x <= 1; b[0] = 1 - t; b[1] = t; {statements} }}")
}

#[test]
fn what_would_exhaust_the_stack_is_refused() {
    for (statements, message) in [
        (format!("b[2] = b[0]{};", "(t)".repeat(4000)), "the expression is nested too deeply"),
        (format!("b[2] = b{};", "[0]".repeat(4000)), "the expression is nested too deeply"),
        (
            format!("b[2] = ({}t{});", "(t)(".repeat(60), ")".repeat(60)),
            "the expression is nested too deeply",
        ),
        (format!("b[2] = t{};", "^1".repeat(4000)), "the expression is nested too deeply"),
        (
            format!("prove b[0] = t for {} in 0..=0;", names(20_000).join(" in 0..=0, ")),
            "a `for` has at most 16 index variables",
        ),
        (
            format!("prove b[0] = t for {} in simplex(3);", names(20_000).join(", ")),
            "a `for` has at most 16 index variables",
        ),
        (format!("b[2{}] = t;", ", 0".repeat(20_000)), "a function has at most 16 indices"),
    ] {
        assert_eq!(messages(&with(&statements)), [message], "{statements:.40}");
    }
    // What is looked for in what stands before it would take the square of the length.
    for (spec, message) in [
        (with(&format!("let h({}) = t;", names(60_000).join(", "))), "a name has at most 16 arguments"),
        (with(&format!("prove t{} > 0;", " #".repeat(200_000))), "expected"),
    ] {
        assert!(messages(&spec)[0].contains(message), "{:?}", messages(&spec)[0]);
    }
    let spec =
        format!("family F({} in 1..=1) {{ domain 0 <= t <= 1; b[0] = t; }}", names(900).join(" in 1..=1, "));
    assert_eq!(messages(&spec)[0], "a family has at most 16 index parameters");
}

fn names(count: usize) -> Vec<String> {
    (0..count).map(|k| format!("i{k}")).collect()
}

#[test]
fn a_hundred_errors_are_shown_and_the_others_counted() {
    for (statement, count) in [
        (";", 2000),
        ("prove ;", 2000),
        ("prove b[0] > 0;", 1000),
        ("prove b[2] > 0;", 1000),
        ("let a = 2 t;", 1000),
        ("foo bar;", 1000),
        ("b[1] = t;", 1000),
        ("prove at t = 0 { b = [1, 0, 0]; }", 500),
    ] {
        for between in ["", "\n"] {
            let spec = with(&[statement, between].concat().repeat(count));
            let messages = messages(&spec);
            assert_eq!(messages.len(), 101, "{statement}");
            let more = messages[100].strip_suffix(" more errors are not shown").expect(&messages[100]);
            let more: usize = more.replace(' ', "").parse().expect("a number");
            assert!(more + 100 <= count && more + 110 > count, "{statement} {more}");
        }
    }
    for spec in ["use \"nowhere.basis\";", "family ", "use "] {
        assert_eq!(messages(&spec.repeat(400)).len(), 101, "{spec}");
    }
    assert_eq!(messages(&with(&"'".repeat(1 << 18))).len(), 1);
}

#[test]
fn the_sum_of_all_loops_and_orders_is_limited() {
    let loops = with(&"prove b[0] + i >= 0 for i in 0..=19999;".repeat(200));
    let orders = "family G(n in 1..=1000) { domain 0 <= t <= 1; b[i] = t*i for i in 0..=511; prove b[i] >= 0 for i in 0..=511; }";
    for spec in [&loops, orders] {
        let messages = messages(spec);
        assert_eq!(messages.len(), 1, "{messages:?}");
        assert!(messages[0].starts_with("the spec takes more than 20 000 claims"), "{messages:?}");
    }
    let family = |k| format!("family F{k}(a in 1..=1000) {{ domain 0 <= t <= 1; b[0] = t; }}");
    let families: Vec<String> = (0..60).map(family).collect();
    assert_eq!(messages(&families.concat()), ["the spec takes more than 5000 families, each order counted"]);
    let names: Vec<String> = names(6000).iter().map(|name| format!("let {name} = t;")).collect();
    let names = names.concat();
    assert_eq!(messages(&with(&names)), ["more than 5000 names are given"]);
    let shapes: String = names.replace("let ", "shape ").replace(" = t", "");
    assert_eq!(messages(&with(&shapes)), ["a family has at most 64 shape parameters and domain variables"]);
}

#[test]
fn many_spans_and_ranges_that_depend_on_one_another_are_answered() {
    let spans: Vec<String> = (0..201).map(|k| format!("{k} <= t <= {}", k + 1)).collect();
    let spans = format!("family F {{ domain {}; b[0] = t; prove smooth(1); }}", spans.join(", "));
    assert_eq!(messages(&spans), ["a family has at most 200 spans"]);

    // In the variables of a box the last parameter of the chain has 2^18 terms.
    let chain: Vec<String> = (0..18).map(|k| format!("p{k} < ")).collect();
    let chain = chain.concat();
    let family = |statements: &str| {
        format!("family F {{ domain 0 <= t <= 1; shape 0 < {chain}1; b[0] = t; b[1] = 1; {statements} }}")
    };
    assert_eq!(messages(&family("prove p0 < p1; prove independent;")), Vec::<String>::new());
    rendered(&check(Source::text("chain.basis", &family("prove p0 < p17; prove p5 + p15 < 2;"))));

    let conditions: Vec<String> = (1..=301).map(|k| format!("assume {k}*p + q <= {k} + 1;")).collect();
    let conditions = conditions.concat();
    let many =
        format!("family F {{ domain 0 <= t <= 1; shape 0 <= p <= 1, 0 <= q <= 1; b[0] = t; {conditions} }}");
    assert_eq!(messages(&many), ["a family has at most 300 conditions on its shape values"]);
    let many = format!("theorem T {{ scalar 0 <= p <= 1; scalar 0 <= q <= 1; {conditions} prove p >= 0; }}");
    assert_eq!(messages(&many), ["a theorem has at most 300 conditions on its scalars"]);

    // Of sixty bounds of five parameters each may be the one that counts.
    let bounds: Vec<String> = (0..60)
        .map(|i| {
            let (a, c) = (i * i % 17, i * i * i % 19);
            format!("assume a*{a} + c*{c} - d*{} - e*{} + f*{} <= {}; ", i % 7, i * 3 % 5, i % 3, 1 + i % 11)
        })
        .collect();
    let bounds = bounds.concat();
    let shapes = ["a", "c", "d", "e", "f"].map(|x| format!("0 <= {x} <= 1")).join(", ");
    let spec = format!(
        "family F {{ domain 0 <= t <= 1; shape {shapes}; b[0] = t*a + c; {bounds} prove nonnegative; }}"
    );
    assert_eq!(messages(&spec), Vec::<String>::new());
}

/// A run has the work of twenty hard claims. Where 20 000 claims, the most of a spec, would take longer than a few seconds, each
/// has to count for its part of that, so that the last ones are answered by "undecided".
#[test]
fn claims_count_for_what_they_take() {
    let high = "b[i] = binomial(60, i)*t^i*(1 - t)^(60 - i) for i in 0..=60;";
    let unit = |functions: &str| format!("family F {{ domain 0 <= t <= 1; {functions} ");
    let assumed = "shape -1 <= x <= 1, -1 <= y <= 1; assume x^2 + y^2 <= 1; b[0] = t;";
    let many = "b[i] = t + i for i in 0..=511;";
    let box_of = |sides: usize, functions: &str| {
        let sides: Vec<String> = (0..sides).map(|k| format!("0 <= x{k} <= 1")).collect();
        format!("family F {{ domain {}; {functions} ", sides.join(", "))
    };
    let quarter = |functions: &str| format!("family F {{ domain 0 <= t <= pi/2; {functions} ");
    for (family, claim, least) in [
        (unit("b[0] = t;"), "prove (t^3 - 1/3)^2 >= 1/10^20;", 5_000),
        (unit("b[0] = t;"), "prove (t - 3/7)^40 >= 0;", 5_000),
        (unit("b[0] = t;"), "prove (t - 1/5)^30*(t + 1/7)^30 > 0;", 5_000),
        (unit("b[i] = (t + i/7)^30 for i in 0..=30;"), "prove independent;", 50_000),
        (unit(high), "prove symmetric;", 50_000),
        (unit(high), "prove partition_of_unity;", 2_000),
        (unit(assumed), "prove (x*t + y)^2 <= 2;", 5_000),
        (unit(many), "prove rounding <= 50;", 50_000),
        (unit(many), "refute symmetric;", 50_000),
        (box_of(40, "b[i] = x0*x1*x2 for i in 0..=1;"), "prove symmetric;", 20_000),
        (quarter("b[0] = sin(t);"), "prove sin(t) + cos(t) <= 2*sin(pi/4);", 5_000),
        (quarter("b[0] = sin(t);"), "prove at t = pi/4 { b[0] = sin(pi/4); }", 1_000),
    ] {
        let units = |count: usize| {
            let spec = format!("{family}{}}}", claim.repeat(count));
            let check = || rendered(&check(Source::text("claims.basis", &spec)));
            basis_prover::measured(&mut { check }).1
        };
        let each = (units(9) - units(1)) / 8;
        assert!(each >= least, "{claim} {each}");
    }
}

/// Reading a pipe may wait for ever for a writer.
#[test]
#[cfg(unix)]
fn only_regular_files_are_read() {
    let error = basis_engine::source::read(&basis_engine::Disk, "/dev/zero", &[]).unwrap_err();
    assert_eq!(error.message, "cannot read `/dev/zero`: it is not a regular file, but a pipe or a device");
}
