//! What the features bring along, and what is said where one is missing.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn cargo(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO"))
        .args(args)
        .arg("--offline")
        .current_dir(folder)
        .env("CARGO_TERM_COLOR", "never")
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env_remove("RUSTFLAGS") // under a sanitizer they are not for macros, and these builds name no target
        .env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("users")) // shared with tests/tests/toolchain
        .output()
        .expect("cargo can be started")
}

/// The packages that are built with these features, in alphabetical order, without those of the development.
fn packages(features: &str) -> Vec<String> {
    let args =
        ["tree", "--no-default-features", "--features", features, "--edges", "normal", "--prefix", "none"];
    let output = cargo(Path::new(env!("CARGO_MANIFEST_DIR")), &args);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let names = String::from_utf8_lossy(&output.stdout);
    let mut names: Vec<_> =
        names.lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect();
    names.sort();
    names.dedup();
    names
}

/// What the compiler says about a crate with that source that depends on the runtime with these features.
fn refusal(name: &str, features: &str, source: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(folder.join("src")).expect("a folder can be made");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         basis-runtime = {{ path = {:?}, default-features = false, features = [{features}] }}\n",
        env!("CARGO_MANIFEST_DIR")
    );
    let lock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../Cargo.lock");
    fs::write(folder.join("Cargo.toml"), manifest).expect("a file can be written");
    fs::copy(lock, folder.join("Cargo.lock")).expect("the lock file is there");
    fs::write(folder.join("src/lib.rs"), source).expect("a file can be written");
    let output = cargo(&folder, &["check", "--quiet"]);
    assert!(!output.status.success(), "it compiles");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The names in the first cells of the rows of the table of features.
fn listed(text: &str) -> Vec<String> {
    let rows = text
        .lines()
        .map(|line| line.trim_start_matches("//! "))
        .skip_while(|line| !line.starts_with("| feature"));
    let cells = rows.take_while(|line| line.starts_with('|')).skip(2).filter_map(|row| row.split('|').nth(1));
    let mut names: Vec<_> =
        cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).map(str::to_owned).collect();
    names.sort();
    names
}

#[test]
fn both_tables_list_every_feature() {
    let manifest = include_str!("../Cargo.toml");
    let section = manifest.split("\n[features]\n").nth(1).and_then(|rest| rest.split("\n\n").next());
    let lines = section.expect("the manifest has features").lines();
    let mut declared: Vec<_> =
        lines.filter_map(|line| line.split(" =").next()).filter(|&name| name != "default").collect();
    declared.sort_unstable();
    assert_eq!(listed(include_str!("../src/lib.rs")), declared);
    assert_eq!(listed(include_str!("../README.md")), declared);
}

#[test]
fn std_alone_brings_nothing_along() {
    assert_eq!(packages("std"), ["basis-runtime"]);
    assert_eq!(packages("std,bspline,mesh,laws"), ["basis-runtime"]);
    assert_eq!(packages("libm"), ["basis-runtime", "libm"]);
}

#[test]
fn with_std_neither_glam_nor_kurbo_brings_libm() {
    assert_eq!(packages("std,glam"), ["basis-runtime", "glam"]);
    for version in ["glam_030", "glam_032", "glam_033"] {
        assert_eq!(packages(&format!("std,{version}")), ["basis-runtime", "glam"]);
    }
    assert_eq!(packages("std,mint"), ["basis-runtime", "mint"]);
    let kurbo = packages("std,kurbo");
    assert!(kurbo.contains(&"kurbo".to_owned()) && !kurbo.contains(&"libm".to_owned()), "{kurbo:?}");
    assert!(packages("libm,kurbo").contains(&"libm".to_owned()));
}

#[test]
fn the_macro_brings_the_engine_along() {
    let packages = packages("std,macros");
    assert!(packages.contains(&"basis-macros".to_owned()), "{packages:?}");
}

#[test]
fn neither_std_nor_libm_is_refused_in_one_sentence() {
    let message = refusal("neither", "", "");
    assert!(message.contains("with the feature `std` or, without it, the feature `libm`"), "{message}");
    let errors = message.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 2, "{message}"); // the other one: could not compile
}

#[test]
fn what_needs_a_feature_says_which() {
    let source = "basis_runtime::basis!(\"specs/quartic.basis\");\n\
                  use basis_runtime::bspline::KnotVector;\n\
                  use basis_runtime::Tessellation;\n";
    let message = refusal("missing", "\"std\"", source);
    assert!(message.contains("`basis!` needs the feature `macros` of basis-runtime"), "{message}");
    for feature in ["bspline", "mesh"] {
        assert!(message.contains(&format!("gated behind the `{feature}` feature")), "{message}");
    }
}

#[test]
fn what_specs_need_features_for_says_which() {
    let family = |name: &str, body: &str| {
        format!("basis_runtime::basis! {{ family {name} {{ {body} prove partition_of_unity; }} }}\n")
    };
    let source = [
        family("Sine", "domain 0 <= t <= pi/2;\nb[0] = sin(t)^2;\nb[1] = cos(t)^2;"),
        family("Exponential", "domain 0 <= t <= 1;\nb[0] = exp(-t);\nb[1] = 1 - exp(-t);"),
        family("Parameter", "shape 0 < α;\ndomain 0 <= t <= α;\nb[0] = t/α;\nb[1] = 1 - t/α;"),
        family("Rounded", "domain 0 <= t <= 1;\nb[0] = t;\nb[1] = 1 - t;\nprove rounding <= 4;"),
        family("Line", "domain 0 <= t <= 1;\nb[0] = t;\nb[1] = 1 - t;"),
        String::from("pub fn line() -> [f64; 2] { Line::new().values(0.5) }\n"),
    ];
    let message = refusal("angles", "\"std\", \"macros\"", &source.concat());
    let said =
        "sines and exponentials, `pi`, and domains that end at a shape parameter need the feature `angles`";
    assert_eq!(message.matches(said).count(), 3, "{message}"); // one mistake, one error
    let said = "claims about rounding need the feature `rounding`";
    assert_eq!(message.matches(said).count(), 1, "{message}");
    for (feature, place) in
        [("angles", "t <= pi/2"), ("angles", "exp(-t)"), ("angles", "t <= α"), ("rounding", "prove rounding")]
    {
        assert!(message.contains(&format!("features = [\"{feature}\"]")), "{message}");
        assert!(message.contains(place), "{message}");
    }
    let errors = message.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 5, "{message}"); // the last one: could not compile
}

#[test]
fn theorems_and_joins_say_that_their_feature_is_off() {
    let claims = "{ curve P = Bernstein(2); prove P(0) == P[0]; }";
    let source = format!(
        "basis_runtime::basis! {{\n\
             family Line {{ domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; prove partition_of_unity; }}\n\
             theorem First {claims}\n\
             join Second {claims}\n\
         }}\n\
         basis_runtime::basis!(library \"quadratic\", QuadraticBezier);\n\
         mod all {{ basis_runtime::basis!(library \"quadratic\"); }}\n\
         pub fn quadratic() -> QuadraticBezier {{ QuadraticBezier::new(0.5).unwrap() }}\n\
         pub fn line() -> [f64; 2] {{ Line::new().values(0.5) }}\n"
    );
    let message = refusal("joins", "\"std\", \"macros\"", &source);
    let said = "theorems and joins need the feature `joins` of basis-runtime, which is off";
    // Once for each spec of which all is asked for; a list that names families alone needs no theorem.
    assert_eq!(message.matches(said).count(), 2, "{message}");
    assert!(message.contains("theorem First") && !message.contains("join Second"), "{message}");
    assert!(message.contains("features = [\"joins\"]"), "{message}");
    // The families of both specs are there.
    let errors = message.lines().filter(|line| line.starts_with("error"));
    assert_eq!(errors.count(), 3, "{message}"); // the last one: could not compile
}
