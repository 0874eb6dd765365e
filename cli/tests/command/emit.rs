//! `basis emit`: what is written, and what is refused.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::{BERNSTEIN, Folder, QUARTIC, Run};

/// The files that are checked in are what their specs give: `INSTA_UPDATE=always` writes them.
#[test]
fn the_checked_in_files_are_up_to_date() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let flag = if std::env::var("INSTA_UPDATE").is_ok_and(|v| v == "always") { "-o" } else { "--check" };
    for name in ["shapes", "quotients"] {
        let (spec, file) =
            (format!("tests/emitted/specs/{name}.basis"), format!("tests/emitted/src/{name}.rs"));
        let arguments = ["emit", &spec, "--to", "rust", flag, &file];
        let run = Command::new(env!("CARGO_BIN_EXE_basis")).args(arguments).current_dir(&root).output();
        let run = Run::of(run.expect("the command starts"));
        assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
    }
}

/// A denominator that is positive for some of the shape values that are assumed and negative for others is not cut off at 0.
#[test]
fn denominators_with_another_sign_on_each_part_of_what_is_assumed() {
    let parts = "shape -1 <= p <= 3; assume p^2 >= 1/4; b[0] = (1 - t)*p/(p + t/100);";
    let one_sign = "shape 0 <= p <= 1; b[0] = (1 - t)/((t - p)^2*(t + 1) + 1/50);";
    for (own, is_cut_off) in [(parts, false), (one_sign, true)] {
        let spec = format!("family F {{ domain 0 <= t <= 1; {own} }}");
        let folder = Folder::with("f.basis", &spec);
        let run = folder.run(&["emit", "f.basis", "--to", "typescript"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(run.stdout.contains("Math.max(0.0"), is_cut_off, "{own}: {}", run.stdout);
    }
}

#[test]
fn a_file_is_written_and_recognized() {
    let folder = Folder::with("specs/quartic.basis", QUARTIC).and("src/lib.rs", "");
    let emit = ["emit", "specs/quartic.basis", "--to", "rust"];
    let run = folder.run(&[&emit[..], &["-o", "src/families.rs"]].concat());
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
    let path = folder.path().join("src/families.rs");
    let text = fs::read_to_string(&path).expect("it was written");
    for part in [
        "//     basis emit specs/quartic.basis --to rust -o src/families.rs\n",
        "include_bytes!(\"../specs/quartic.basis\")",
        "pub struct QuarticBernstein<S = f64> {",
        "| `partition_of_unity` | proved by expansion of the sum |",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let check = [&emit[..], &["--check", "src/families.rs"]].concat();
    assert_eq!(folder.run(&check).code, 0);
    // Line ends of another system, and another layout of the code, are the same file.
    fs::write(&path, text.replace('\n', "\r\n")).expect("it can be written");
    assert_eq!(folder.run(&check).code, 0);
    fs::write(&path, text.replace("\n    ", "\n  ")).expect("it can be written");
    assert_eq!(folder.run(&check).code, 0);
    fs::write(&path, text.replace("S::of(3.0)", "S::of(4.0)")).expect("it can be written");
    assert_eq!(folder.run(&check).code, 1);
    folder.write("specs/quartic.basis", &QUARTIC.replace("-3 <= λ", "-2 <= λ"));
    let run = folder.run(&check);
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("`src/families.rs` is not what the spec gives now"), "{}", run.stderr);
    assert!(run.stderr.contains("run `basis emit specs/quartic.basis --to rust -o src/families.rs`"));
}

/// A file that nobody wrote yet, and what is printed where no file is named.
#[test]
fn without_a_file_the_text_is_printed() {
    let folder = Folder::with("bern.basis", BERNSTEIN);
    let run = folder.run(&["emit", "bern.basis", "Bern(n=3) as Cubic", "Bern(2)", "--to", "rust"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(
        run.stdout.contains("pub struct Cubic<S = f64>") && run.stdout.contains("pub struct Bern<S = f64>")
    );
    assert!(!run.stdout.contains("include_bytes"), "a text has no folder");
    assert!(run.stdout.contains("basis emit bern.basis 'Bern(n=3) as Cubic' 'Bern(2)' --to rust\n"));
    let run = folder.run(&["emit", "bern.basis", "Bern(2)", "--to", "rust", "--check", "none.rs"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot read `none.rs`"), "{}", run.stderr);
}

#[test]
fn what_cannot_be_written_is_an_error() {
    let rational = "family Arc { domain 0 <= t <= 1, 0 <= u <= 1; b[0] = (1 - t)/(1 + u); }";
    let theorem = "theorem T { curve P = Bernstein(2); prove P(0) == P[0]; }";
    let folder = Folder::with("quartic.basis", QUARTIC)
        .and("bern.basis", BERNSTEIN)
        .and("false.basis", QUARTIC.replace("refute b[0]", "prove b[0]"))
        .and("broken.basis", "family F { domain 0 <= t <= 1; b[0] = t +; }")
        .and("unknown.basis", "family F { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = u; }")
        .and(
            "endless.basis",
            "family F { shape 0 < α; domain 0 <= t <= α; b[0] = (sinh(t) - t)/(sinh(α) - α); }",
        )
        .and(
            "long.basis",
            "family F { shape 0 < α <= 60; domain 0 <= t <= α; b[0] = (sinh(t) - t)/(sinh(α) - α); }",
        )
        .and("vast.basis", "family F { shape 0 < α <= 600; domain 0 <= t <= α; b[0] = sinh(t)/sinh(α); }")
        .and("rational.basis", rational)
        .and("huge.basis", "family Huge { domain 0 <= t <= 1; b[0] = 10^50*t; b[1] = 1 - t; }")
        .and("theorem.basis", theorem);
    for (arguments, code, message) in [
        (vec!["quartic.basis", "Quartic"], 2, "there is no family `Quartic`"),
        (vec!["quartic.basis", "QuarticBernstein as fn"], 1, "`fn` cannot be a name in Rust"),
        (vec!["quartic.basis", "QuarticBernstein as a b"], 1, "`a b` cannot be a name in Rust"),
        (vec!["quartic.basis", "QuarticBernstein as f64"], 1, "`f64` cannot be the name of a Rust type"),
        (vec!["bern.basis", "Bern(2)", "Bern(3)"], 1, "are both called `Bern` in the file"),
        (vec!["bern.basis"], 2, "every family in it has index parameters"),
        (vec!["false.basis"], 1, "the claim `b[0] = b[1]` is false"),
        (vec!["broken.basis"], 1, "broken.basis:1"),
        (vec!["endless.basis", "--to", "c"], 1, "end the range of `α` earlier: `shape 0 < α <= 16;`"),
        (vec!["long.basis", "--to", "c"], 1, "end the range of `α` earlier: `shape 0 < α <= 16;`"),
        (vec!["vast.basis", "--to", "c"], 1, "exp(600), which this contains, is too large a number"),
        (vec!["unknown.basis"], 1, "the name `u` is not declared"),
        (
            vec!["rational.basis"],
            1,
            "no code is generated yet for families with denominators, angles or exponentials in several domain variables",
        ),
        (vec!["theorem.basis", "T"], 2, "`T` is a theorem, which computes nothing"),
        (vec!["none.basis"], 2, "there is no spec file `none.basis`"),
        (vec!["quartic.basis", "-o", "no/such/folder.rs"], 1, "cannot find `no/such`"),
        (vec!["quartic.basis", "--to", "cobol"], 2, "invalid value 'cobol'"),
        (vec!["rational.basis", "--to", "c"], 1, "no code is generated yet for families with denominators"),
        (vec!["quartic.basis", "QuarticBernstein as a b", "--to", "python"], 1, "`a b` cannot be a name"),
        (vec!["bern.basis", "Bern(2)", "Bern(3)", "--to", "wgsl"], 1, "are both called `Bern` in the file"),
        (vec!["quartic.basis", "--to", "wgsl", "--scalar", "f64"], 2, "WGSL has no f64"),
        (vec!["quartic.basis", "--to", "python", "--scalar", "f32"], 2, "arrays of float32 included"),
        (vec!["quartic.basis", "--to", "rust", "--scalar", "f32"], 2, "are for f64 and f32"),
        (
            vec!["quartic.basis", "--to", "typescript", "--scalar", "f32"],
            2,
            "the numbers of TypeScript are f64",
        ),
        (vec!["huge.basis", "--to", "c", "--scalar", "f32"], 1, "beyond what f32 holds"),
        (
            vec!["bern.basis", "Bern(2)", "Bern(3) as BernCurve", "--to", "python"],
            1,
            "is needed for parts of `Bern(2)`",
        ),
        (
            vec!["bern.basis", "Bern(2)", "Bern(3) as Bern_eval", "--to", "c"],
            1,
            "is needed for parts of `Bern(2)`",
        ),
        (vec!["huge.basis", "--to", "glsl"], 1, "beyond what f32 holds"),
    ] {
        let target: &[&str] = if arguments.contains(&"--to") { &[] } else { &["--to", "rust"] };
        let run = folder.run(&[&["emit"], arguments.as_slice(), target].concat());
        assert_eq!((run.code, run.stdout.as_str()), (code, ""), "{arguments:?} {}", run.stderr);
        assert!(run.stderr.contains(message), "{arguments:?}: {}", run.stderr);
    }
}

/// Every language has the header, the verdicts, the proved bound, and names that it can have.
#[test]
fn other_languages_say_where_they_come_from() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    for (target, name, comment) in [
        (
            "c",
            "q.h",
            "static inline void QuarticBernstein_values(QuarticBernstein family, double t, double values[4])",
        ),
        ("python", "q.py", "        lambda_ = self.lambda_\n"),
        ("typescript", "q.ts", "    evalN(at: ArrayLike<number>"),
        ("wgsl", "q.wgsl", "fn QuarticBernstein_eval_n(@builtin(global_invocation_id) id: vec3u) {"),
        ("glsl", "q.glsl", "float[4] QuarticBernstein_values(float lambda, float t) {"),
    ] {
        let run = folder.run(&["emit", "quartic.basis", "--to", target, "-o", name]);
        assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""), "{target}");
        let text = fs::read_to_string(folder.path().join(name)).expect("it was written");
        for part in [
            &format!("basis emit quartic.basis --to {target} -o {name}\n"),
            "No rights are claimed on this file",
            "| `b[0] = b[1]` | refuted: ",
            "`b[1]`: 4.51 ε of the value",
            comment,
        ] {
            assert!(text.contains(part), "{target}: {part}\n{text}");
        }
        let check = ["emit", "quartic.basis", "--to", target, "--check", name];
        assert_eq!(folder.run(&check).code, 0, "{target}");
        fs::write(folder.path().join(name), text + "\n").expect("it can be written");
        assert_eq!(folder.run(&check).code, 1, "{target}");
    }
    let run = folder.run(&["emit", "quartic.basis", "--to", "c", "--scalar", "f32"]);
    assert!(run.stdout.contains("float values[4]") && run.stdout.contains("--to c --scalar f32\n"));
}

/// Exponentials that overflow for all values of a range: an error in every language, which says how far floats reach.
#[test]
fn a_range_that_no_float_reaches_is_an_error() {
    let family = "family Far { shape 10 < α; domain 0 <= t <= 1; b[0] = 1/(t + exp(-40*α)); }";
    let near = "family Far { shape 2 < α; domain 0 <= t <= 1; b[0] = 1/(t + exp(-40*α)); }";
    let folder = Folder::with("far.basis", family).and("near.basis", near);
    for language in ["rust", "c", "python", "typescript", "wgsl", "glsl"] {
        let floats = if matches!(language, "wgsl" | "glsl") { "f32" } else { "f64" };
        let run = folder.run(&["emit", "far.basis", "--to", language]);
        assert_eq!((run.code, run.stdout.as_str()), (1, ""), "{language}");
        let said = format!("exponentials of `α` overflow in {floats} for all values in its range `10 < α`");
        assert!(run.stderr.contains(&said), "{language}: {}", run.stderr);
        // Wide floats reach 5.75.
        let run = folder.run(&["emit", "near.basis", "--to", language]);
        assert_eq!(run.code, i32::from(floats == "f32"), "{language}: {}", run.stderr);
    }
}

/// Why there is no code for functions of a high degree beside the domain variable.
#[test]
fn a_degree_may_be_too_high_for_power_series() {
    let high = "family F { shape 0 < α; domain 0 <= t <= α; b[i] = (sinh(t) - t)^i*cosh(t)^(20 - i) for i in 0..=20; }";
    let run = Folder::with("high.basis", high).run(&["emit", "high.basis", "--to", "c"]);
    assert_eq!(run.code, 1);
    assert!(run.stderr.contains("of too high a degree"), "{}", run.stderr);
}
