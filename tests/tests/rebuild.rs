//! An edit of a spec file, or of a file that it uses, makes Cargo build the crate anew, also after an error.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

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

fn run(folder: &Path) -> Output {
    // One target folder for all runs of the test: the dependencies are built once.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rebuild");
    Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline"])
        .current_dir(folder)
        .env("CARGO_TARGET_DIR", target)
        .output()
        .expect("cargo can be started")
}

fn output(folder: &Path) -> String {
    let output = run(folder);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    text.trim().to_string()
}

#[test]
fn follows_every_edit_of_a_spec() {
    let root =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().expect("the workspace is there");
    let folder = tempfile::tempdir().expect("a temporary folder can be made");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("inside the folder")).expect("a folder can be made");
        fs::write(path, text).expect("a file can be written");
    };
    let runtime = root.join("runtime");
    let manifest = format!(
        "[package]\nname = \"rebuilt\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
         basis-runtime = {{ path = {runtime:?}, default-features = false }}\n"
    );
    write("Cargo.toml", &manifest);
    fs::copy(root.join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("the lock file is there");
    write("src/main.rs", MAIN);
    write("src/specs/line.basis", &line("t"));
    write("src/specs/used.basis", &used("t"));
    assert_eq!(output(folder.path()), "[0.0, 1.0]");

    // The spec itself.
    write("src/specs/line.basis", &line("2*t"));
    let refused = run(folder.path());
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        !refused.status.success() && message.contains("the claim `b[1] = Used[0]` is false"),
        "{message}"
    );
    // The place is one that a terminal opens from the folder in which Cargo runs.
    assert!(message.contains("--> src/specs/line.basis:2:"), "{message}");

    // A file that it uses, after an error.
    write("src/specs/used.basis", &used("t + t"));
    assert_eq!(output(folder.path()), "[0.0, 2.0]");
}
