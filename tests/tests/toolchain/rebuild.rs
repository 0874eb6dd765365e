//! An edit of a spec file, of a file that it uses, or of an environment variable in its path makes Cargo rebuild the
//! crate, also after an error; a file that `basis emit` wrote stops the build when its spec was edited.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use basis_engine::emit::rust::{Digest, digest};
use basis_engine::emit::{self, Job, Wanted};
use basis_engine::{Disk, Library, Prover, Source, decide};

const MAIN: &str = r#"
basis_runtime::basis!("specs/line.basis");
fn main() { println!("{:?}", Line::<f64>::new().values(1.0)); }
"#;

fn line(second: &str) -> String {
    format!(
        "use \"used.basis\";\nfamily Line {{ domain 0 <= t <= 1; b[0] = 1 - t; b[1] = {second}; prove b[1] = Used[0]; }}"
    )
}

fn used(function: &str) -> String {
    format!("family Used {{ domain 0 <= t <= 1; b[0] = {function}; }}")
}

/// A crate that depends on the runtime.
struct Crate(tempfile::TempDir);

impl Crate {
    fn new(name: &str, main: &str) -> Self {
        Self::with(name, main, &["macros", "std"])
    }

    fn with(name: &str, main: &str, features: &[&str]) -> Self {
        let root =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().expect("the workspace is there");
        let folder = Self(tempfile::tempdir().expect("a temporary folder can be made"));
        let runtime = root.join("runtime").display().to_string();
        let manifest = format!(
            "[package]\nname = {name:?}\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
             basis-runtime = {{ path = {runtime:?}, default-features = false, features = {features:?} }}\n"
        );
        folder.write("Cargo.toml", &manifest);
        fs::copy(root.join("Cargo.lock"), folder.0.path().join("Cargo.lock"))
            .expect("the lock file is there");
        folder.write("src/main.rs", main);
        folder
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.0.path().join(name);
        fs::create_dir_all(path.parent().expect("inside the folder")).expect("a folder can be made");
        fs::write(path, text).expect("a file can be written");
    }

    fn run(&self, variables: &[(&str, &str)]) -> Output {
        // One target folder for all runs, and for those of `runtime/tests/features.rs`: the dependencies are built once.
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("users");
        Command::new(env!("CARGO"))
            .args(["run", "--quiet", "--offline"])
            .current_dir(self.0.path())
            .env("CARGO_TERM_COLOR", "never")
            .env("CARGO_PROFILE_DEV_DEBUG", "0") // as there, so that they are the same
            .env("CARGO_TARGET_DIR", target)
            .env_remove("RUSTFLAGS")
            .envs(variables.iter().copied())
            .output()
            .expect("cargo can be started")
    }

    fn output(&self, variables: &[(&str, &str)]) -> String {
        let output = self.run(variables);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        text.trim().to_string()
    }

    /// What the compiler says when it refuses.
    fn refusal(&self, variables: &[(&str, &str)]) -> String {
        let refused = self.run(variables);
        assert!(!refused.status.success());
        String::from_utf8_lossy(&refused.stderr).into_owned()
    }
}

#[test]
fn follows_every_edit_of_a_spec() {
    let rebuilt = Crate::new("rebuilt", MAIN);
    rebuilt.write("src/specs/line.basis", &line("t"));
    rebuilt.write("src/specs/used.basis", &used("t"));
    assert_eq!(rebuilt.output(&[]), "[0.0, 1.0]");

    // The spec itself.
    rebuilt.write("src/specs/line.basis", &line("2*t"));
    let message = rebuilt.refusal(&[]);
    assert!(message.contains("the claim `b[1] = Used[0]` is false"), "{message}");
    // The place is one that a terminal opens from the folder in which Cargo runs.
    assert!(message.contains("--> src/specs/line.basis:2:"), "{message}");

    // A file that it uses, after an error.
    rebuilt.write("src/specs/used.basis", &used("t + t"));
    assert_eq!(rebuilt.output(&[]), "[0.0, 2.0]");
}

#[test]
fn follows_an_environment_variable() {
    let main = MAIN.replace("\"specs/line.basis\"", "concat!(env!(\"BASIS_TEST_FOLDER\"), \"/line.basis\")");
    let moved = Crate::new("moved", &main);
    for (folder, second) in [("one", "t"), ("two", "3*t")] {
        moved.write(&format!("src/{folder}/line.basis"), &line(second));
        moved.write(&format!("src/{folder}/used.basis"), &used(second));
    }
    let message = moved.refusal(&[]);
    assert!(message.contains("`BASIS_TEST_FOLDER` is not set"), "{message}");
    assert_eq!(moved.output(&[("BASIS_TEST_FOLDER", "one")]), "[0.0, 1.0]");
    assert_eq!(moved.output(&[("BASIS_TEST_FOLDER", "two")]), "[0.0, 3.0]");
    let message = moved.refusal(&[("BASIS_TEST_FOLDER", "three")]);
    assert!(message.contains("there is no spec file `three/line.basis`"), "{message}");
    assert_eq!(moved.output(&[("BASIS_TEST_FOLDER", "one")]), "[0.0, 1.0]");
}

/// The items of a file that `basis emit` writes beside a spec with this text.
fn emitted(spec: &str) -> String {
    let library = Library::from_source(&Disk, &Prover, Source::text("line.basis", spec));
    let checked = decide(library.item("Line", &[]).expect("a family"));
    let items = [Wanted { checked, name: None }];
    let job = Job { items: &items, spec: "line.basis", command: "basis emit line.basis" };
    let digest = Digest { path: String::from("specs/line.basis"), digest: digest(spec.as_bytes()) };
    let items = emit::rust::items(&job, &[digest]).expect("a small family");
    prettyplease::unparse(&syn::parse2(items).expect("Rust"))
}

/// A crate with a file that was written ahead builds without the macro, until the spec is edited.
#[test]
fn an_edited_spec_stops_the_build_of_a_file() {
    let main = "mod families;\nfn main() { println!(\"{:?}\", families::Line::<f64>::new().values(1.0)); }";
    let ahead = Crate::with("ahead", main, &["std"]);
    let line = |second: &str| {
        format!("family Line {{ domain 0 <= t <= 1; b[0] = 1 - t;\nb[1] = {second}; prove independent; }}\n")
    };
    ahead.write("src/families.rs", &emitted(&line("t")));
    ahead.write("src/specs/line.basis", &line("t"));
    assert_eq!(ahead.output(&[]), "[0.0, 1.0]");
    ahead.write("src/specs/line.basis", &line("2*t"));
    let message = ahead.refusal(&[]);
    assert!(
        message.contains("the spec `specs/line.basis` was edited after this file was written"),
        "{message}"
    );
    assert!(message.contains("run `basis emit line.basis`"), "{message}");
    // A checkout with other line ends has the same spec.
    ahead.write("src/specs/line.basis", &line("t").replace('\n', "\r\n"));
    assert_eq!(ahead.output(&[]), "[0.0, 1.0]");
    ahead.write("src/families.rs", &emitted(&line("2*t")));
    ahead.write("src/specs/line.basis", &line("2*t"));
    assert_eq!(ahead.output(&[]), "[0.0, 2.0]");
}
