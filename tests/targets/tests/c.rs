//! C and C++: the header compiles without a warning by every standard, and computes what the steps say.

use std::fmt::Write as _;
use std::process::Command;

use basis_engine::emit::FamilyCode;
use basis_engine::emit::c::{C, Scalar};
use basis_tests_targets::{
    Case, DIMENSION, Floats, Join, RELATED, Rounds, UNRELATED, cases, compare, guide, has, list, orders,
    related_join, run, write,
};

/// A program that prints all results.
fn program(case: &Case, floats: Floats, code: &FamilyCode<'_>) -> String {
    let (t, suffix) = if floats == Floats::Single { ("float", "f") } else { ("double", "") };
    let name = code.name.as_str();
    let member =
        |part: &str| if name.ends_with('_') { format!("{name}{part}") } else { format!("{name}_{part}") };
    let functions = case.family.functions.len();
    let samples = case.samples(floats);
    let width = samples[0].len();
    let mut text = format!("#include \"{}.h\"\n#include <stdio.h>\n#include <string.h>\n", case.name);
    text += "static void show(double x) { unsigned long long bits; memcpy(&bits, &x, 8); printf(\"%016llx\\n\", bits); }\n";
    text += "int main(void) {\n";
    let shaped = !case.shapes.is_empty();
    if shaped {
        let _ = writeln!(
            text,
            "{name} family; if ({}(&family, {}) != 0) return 1;",
            member("init"),
            list(&case.shapes, suffix)
        );
    }
    let family = if shaped { "family, " } else { "" };
    let _ = writeln!(text, "const {t} samples[] = {{{}}};", list(&samples.concat(), suffix));
    let _ = writeln!(text, "const {t} points[] = {{{}}};", list(&case.points(), suffix));
    let (coefficients, point) = (member("COEFFICIENTS"), 3 * DIMENSION);
    let _ = writeln!(text, "{t} bound[{coefficients} * {DIMENSION}], values[{functions}], point[{point}];");
    let _ = writeln!(text, "{t} all[{}];", samples.len() * DIMENSION);
    let _ = writeln!(text, "{}({family}{DIMENSION}, points, bound);", member("bind"));
    let quotient = if case.steps().is_quotient() { family } else { "" };
    let _ = writeln!(
        text,
        "{}({quotient}{DIMENSION}, bound, {}, samples, all);",
        member("eval_n"),
        samples.len()
    );
    let _ = writeln!(
        text,
        "for (int k = 0; k < {}; k++) {{ const {t} *at = samples + k * {width};",
        samples.len()
    );
    let at: Vec<String> = (0..width).map(|k| format!("at[{k}]")).collect();
    let at = at.join(", ");
    let show = |array: &str, count: usize| format!("for (int i = 0; i < {count}; i++) show({array}[i]);\n");
    let _ = writeln!(text, "{}({family}{at}, values);", member("values"));
    text += &show("values", functions);
    let point_check = format!(
        "#ifdef UNFUSED\nfor (int i = 0; i < {DIMENSION}; i++) if (point[i] != all[k * {DIMENSION} + i]) return 2;\n#endif\n"
    );
    if case.is_curve() {
        for part in ["derivatives", "second_derivatives"] {
            let _ = writeln!(text, "{}({family}{at}, values);", member(part));
            text += &show("values", functions);
        }
        let _ = writeln!(text, "{}({quotient}{DIMENSION}, bound, {at}, point);", member("eval"));
        text += &show("point", DIMENSION);
        text += &point_check;
        let part = member("eval_with_derivatives");
        let _ = writeln!(text, "{part}({quotient}{DIMENSION}, bound, {at}, point);");
        text += &show("point", 3 * DIMENSION);
    } else {
        let orders = orders(case.family.domain.len());
        for order in &orders {
            let _ = writeln!(
                text,
                "{}({family}{at}, values);",
                member(&format!("partials_{}", code.along(order)))
            );
            text += &show("values", functions);
        }
        let _ = writeln!(text, "{}({DIMENSION}, bound, {at}, point);", member("eval"));
        text += &show("point", DIMENSION);
        text += &point_check;
        for order in &orders {
            let part = member(&format!("eval_partial_{}", code.along(order)));
            let _ = writeln!(text, "{part}({DIMENSION}, bound, {at}, point);");
            text += &show("point", DIMENSION);
        }
    }
    text += "}\n";
    let (derivatives, f, c) = case.contact();
    let _ =
        writeln!(text, "const {t} derivatives[] = {{{}}}; (void)derivatives;", list(&derivatives, suffix));
    for (part, at_start) in [("curve_after", true), ("curve_before", false)] {
        for order in case.contacts(at_start) {
            let all = case.points().len();
            let _ = writeln!(text, "{{ {t} solved[{all}]; memcpy(solved, points, sizeof solved);");
            let _ = writeln!(
                text,
                "if ({}({family}{order}, {f:?}{suffix}, {c:?}{suffix}, {DIMENSION}, derivatives, solved) != 0) return 3;",
                member(part)
            );
            text += &show("solved", all);
            text += "}\n";
        }
    }
    text + "return 0; }\n"
}

/// Flags of a compiler, and how what it compiles rounds.
fn flags(case: &Case) -> [(&'static [&'static str], Rounds); 3] {
    // GCC 12 makes fused operations of alternating sums and differences, also where it is told not to.
    const SLP: &str = "-fno-tree-slp-vectorize";
    let optimised: (&[&str], Rounds) = if case.calls() {
        // Sines of constants are computed by the compiler, in its own way.
        (&["-O3", "-march=native", "-ffp-contract=off"], Rounds::Fused)
    } else {
        (&["-O3", "-march=native", "-ffp-contract=off", SLP, "-DUNFUSED"], Rounds::EveryStep)
    };
    [
        (&["-O0", "-ffp-contract=off", "-DUNFUSED"], Rounds::EveryStep),
        optimised,
        (&["-O3", "-march=native", "-ffp-contract=fast"], Rounds::Fused),
    ]
}

#[test]
#[ignore = "needs gcc and clang"]
fn c_computes_what_the_steps_say() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let compilers: Vec<&str> = ["gcc", "clang"].into_iter().filter(|c| has(c, &["--version"])).collect();
    let mut wrong = Vec::new();
    for case in cases() {
        for (floats, scalar) in [(Floats::Double, Scalar::F64), (Floats::Single, Scalar::F32)] {
            let language = C(scalar);
            let code = case.code(&language);
            write(folder, &format!("{}.h", case.name), &case.emit(&language));
            write(folder, "main.c", &program(&case, floats, &code));
            let expected = case.expected(floats, Floats::Double);
            for compiler in &compilers {
                for (flags, rounds) in flags(&case) {
                    let strict = [
                        "-std=c99",
                        "-Wall",
                        "-Wextra",
                        "-Werror",
                        "-pedantic",
                        "main.c",
                        "-o",
                        "main",
                        "-lm",
                    ];
                    run(folder, compiler, &[&strict, flags].concat());
                    let printed = run(folder, "./main", &[]);
                    if let Err(error) = compare(&printed, &expected, rounds) {
                        wrong.push(format!("{compiler} {flags:?} {floats:?}: {error}"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Only the oldest and newest standards and C++, with all families in one unit: no name is there twice.
#[test]
#[ignore = "needs gcc and clang"]
fn headers_compile_by_every_standard() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    let mut all = String::new();
    for case in cases() {
        let name = format!("{}.h", case.name);
        write(folder, &name, &case.emit(&C(Scalar::F64)));
        all += &format!("#include \"{name}\"\n#include \"{name}\"\n");
    }
    all += "int main(void) { return 0; }\n";
    write(folder, "all.c", &all);
    write(folder, "all.cpp", &all);
    let strict = ["-Wall", "-Wextra", "-Wshadow", "-Werror", "-pedantic", "-fsyntax-only"];
    for (compiler, file, standards) in [
        ("gcc", "all.c", &["c99", "c11", "c17", "c2x", "gnu17"][..]),
        ("clang", "all.c", &["c99", "c11", "c17", "c2x", "gnu17"]),
        ("g++", "all.cpp", &["c++17", "c++20"]),
        ("clang++", "all.cpp", &["c++17", "c++20"]),
    ] {
        if !has(compiler, &["--version"]) {
            continue;
        }
        for standard in standards {
            run(folder, compiler, &[&strict[..], &[&format!("-std={standard}"), file]].concat());
        }
        for flag in ["-ffast-math", "-ffinite-math-only"] {
            let output =
                Command::new(compiler).args(["-fsyntax-only", flag, file]).current_dir(folder).output();
            let output = output.expect("the compiler starts");
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(!output.status.success() && said.contains("compile without"), "{said}");
        }
    }
}

#[test]
#[ignore = "needs gcc"]
fn joins_are_those_of_the_steps() {
    if !has("gcc", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (folder, join) = (folder.path(), Join::new());
    write(folder, "join.h", &join.emit(&C(Scalar::F64)));
    let program = format!(
        "#include \"join.h\"\n#include <stdio.h>\n#include <string.h>\nint main(void) {{\n\
         const double points[] = {{{}}}; double found[4];\n\
         if (smooth(2, points, 0.0, found) != 1 || smooth(2, points, NAN, found) != 1) return 1;\n\
         if (smooth(2, points, {:?}, found) != 0) return 2;\n\
         for (int k = 0; k < 4; k++) {{ unsigned long long bits; memcpy(&bits, found + k, 8); printf(\"%016llx\\n\", bits); }}\n\
         return 0; }}\n",
        list(&join.points, ""),
        join.delta
    );
    write(folder, "main.c", &program);
    run(
        folder,
        "gcc",
        &[
            "-std=c99",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-pedantic",
            "-ffp-contract=off",
            "main.c",
            "-o",
            "main",
        ],
    );
    compare(&run(folder, "./main", &[]), &join.expected(), Rounds::EveryStep)
        .unwrap_or_else(|e| panic!("{e}"));
}

/// Each relation has a number of its own, after those of the scalars.
#[test]
#[ignore = "needs gcc"]
fn joins_check_how_scalars_are_related() {
    if !has("gcc", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let folder = folder.path();
    write(folder, "join.h", &related_join(&C(Scalar::F64)));
    let mut program = format!(
        "#include \"join.h\"\nint main(void) {{\nconst double P[] = {{0.0, 1.0, 3.0}}; double Q[2];\n\
         if (related(1, P, {RELATED}, Q) != 0 || Q[0] != 3.0 || Q[1] != 4.0) return 1;\n"
    );
    for (k, scalars) in UNRELATED.iter().enumerate() {
        let number = 5 + k;
        let _ = writeln!(program, "if (related(1, P, {scalars}, Q) != {number}) return {number};");
    }
    write(folder, "main.c", &(program + "return 0; }\n"));
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "main.c", "-o", "main"];
    run(folder, "gcc", &strict);
    run(folder, "./main", &[]);
}

#[test]
#[ignore = "needs gcc"]
fn the_guide_is_true() {
    if !has("gcc", &["--version"]) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (listing, header) = guide("c", &C(Scalar::F64));
    write(folder.path(), "quartic.h", &header);
    write(folder.path(), "main.c", &listing);
    run(
        folder.path(),
        "gcc",
        &["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "main.c", "-o", "main"],
    );
    let printed = run(folder.path(), "./main", &[]);
    assert!(listing.contains(&format!("/* {} */", printed.trim())), "{printed}");
}
