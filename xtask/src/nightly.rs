//! The steps of a night, from the cheapest to the most expensive.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;
use std::{env, fs};

/// How a step ended, unless it passed.
enum Ended {
    Failed(String),
    Skipped(String),
}

type Outcome = Result<(), Ended>;

/// A step: its name, what it shows, and how.
struct Step(&'static str, &'static str, fn(&Path) -> Outcome);

const STEPS: [Step; 9] = [
    Step("forge", "1.2 million forged certificates and witnesses, none accepted", forge),
    Step("oracle", "the checker in Python on 100 000 corrupted certificates", oracle),
    Step("judges", "100 000 verdicts against values computed in Python", judges),
    Step("sanitizer", "the tests of kernel and runtime under the address sanitizer", sanitizer),
    Step("miri", "the runtime's unsafe code and its modules, interpreted by Miri", miri),
    Step("fuzz", "no panic and no hang on any input, 20 minutes for each target", fuzz),
    Step("coq", "Coq accepts the theorems of all specs", coq),
    Step("specs", "every mutant of the shipped specs", mutants_of_specs),
    Step("kernel", "every mutant of the kernel", mutants_of_kernel),
];

/// The names of the steps, each with what it shows.
pub(crate) fn list() -> String {
    let lines: Vec<String> = STEPS.iter().map(|Step(name, what, _)| format!("  {name:8}{what}")).collect();
    lines.join("\n")
}

/// Runs the steps that are named, or all of them.
pub(crate) fn run(wanted: &[String]) -> ExitCode {
    if let Some(unknown) = wanted.iter().find(|name| !STEPS.iter().any(|Step(known, ..)| known == name)) {
        eprintln!("there is no step `{unknown}`; the steps are\n{}", list());
        return ExitCode::from(2);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let mut report = Vec::new();
    let mut failed = false;
    for Step(name, what, step) in STEPS {
        if !wanted.is_empty() && !wanted.iter().any(|w| w == name) {
            continue;
        }
        println!("\n=== {name}: {what}");
        let start = Instant::now();
        let ended = match step(root) {
            Ok(()) => String::from("passed: "),
            Err(Ended::Skipped(why)) => format!("skipped ({why}): "),
            Err(Ended::Failed(why)) => {
                failed = true;
                format!("FAILED ({why}): ")
            }
        };
        report.push(format!("{ended}{what}, {} s", start.elapsed().as_secs()));
    }
    println!("\n{}", report.join("\n"));
    ExitCode::from(u8::from(failed))
}

/// A program with arguments, in the root of the repository.
fn command(root: &Path, line: &str) -> Command {
    let mut words = line.split(' ');
    let mut command = Command::new(words.next().unwrap_or_default());
    command.args(words).current_dir(root);
    command
}

/// Runs a command that has to end well.
fn succeed(mut command: Command) -> Outcome {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(Ended::Failed(format!("{command:?} ends with {status}"))),
        Err(e) => Err(Ended::Failed(format!("{command:?}: {e}"))),
    }
}

/// Whether a command runs and ends well, silently.
fn works(mut command: Command) -> bool {
    command.output().is_ok_and(|said| said.status.success())
}

fn tools(root: &Path) -> PathBuf {
    root.join("target/ci-tools")
}

/// The path of programs with that of our own tools in front.
fn search_path(root: &Path) -> std::ffi::OsString {
    let usual = env::var_os("PATH").unwrap_or_default();
    let all = [tools(root).join("bin")].into_iter().chain(env::split_paths(&usual));
    env::join_paths(all).unwrap_or(usual)
}

/// A subcommand of cargo: installed unless it is there.
fn subcommand(root: &Path, name: &str) -> Outcome {
    let mut known = command(root, &format!("cargo {name} --version"));
    known.env("PATH", search_path(root));
    let mut install = command(root, &format!("cargo install --quiet --locked --debug cargo-{name} --root"));
    install.arg(tools(root)).env("CARGO_PROFILE_DEV_DEBUG", "0");
    if works(known) || works(install) {
        Ok(())
    } else {
        Err(Ended::Skipped(format!("cargo-{name} cannot be installed")))
    }
}

fn forge(root: &Path) -> Outcome {
    succeed(command(
        root,
        "cargo test --quiet --release -p basis-kernel --test checker -- --ignored --nocapture a_million",
    ))
}

/// Python, with a module unless it is empty.
fn python(root: &Path, module: &str) -> Outcome {
    let mut found = command(root, "python3 -c");
    found.arg(if module.is_empty() { String::from("pass") } else { format!("import {module}") });
    if works(found) { Ok(()) } else { Err(Ended::Skipped(format!("there is no python3 with {module}"))) }
}

fn oracle(root: &Path) -> Outcome {
    python(root, "")?;
    let test = "cargo test --quiet --release -p basis-engine --features tools --test proofs oracle -- --ignored --nocapture";
    let mut command = command(root, test);
    command.env("CORRUPTED", "100000");
    succeed(command)
}

fn judges(root: &Path) -> Outcome {
    python(root, "sympy")?;
    succeed(command(root, "cargo build --quiet --release -p basis-cli"))?;
    succeed(command(root, "python3 tests/oracle/judge.py target/release/basis --claims 100000"))
}

/// Lets the compiler that is installed take options that are unstable, so that no other one has to be fetched.
fn unstable(mut command: Command) -> Command {
    command.env("RUSTC_BOOTSTRAP", "1");
    command
}

/// The target for which the compiler builds by default.
fn host(root: &Path) -> Option<String> {
    let said = command(root, "rustc -vV").output().ok()?;
    let said = String::from_utf8(said.stdout).ok()?;
    said.lines().find_map(|line| line.strip_prefix("host: ")).map(str::to_owned)
}

fn sanitizer(root: &Path) -> Outcome {
    let host = host(root).ok_or_else(|| Ended::Skipped(String::from("there is no rustc")))?;
    let folder = root.join("target/sanitizer");
    let io = |e: std::io::Error| Ended::Failed(format!("{}: {e}", folder.display()));
    fs::create_dir_all(&folder).map_err(io)?;
    fs::write(folder.join("probe.rs"), "fn main() {}").map_err(io)?;
    let probe = "rustc -Zsanitizer=address -o target/sanitizer/probe target/sanitizer/probe.rs --target";
    if !works(unstable(command(root, &format!("{probe} {host}"))))
        || !works(command(root, "target/sanitizer/probe"))
    {
        return Err(Ended::Skipped(format!("the compiler has no address sanitizer for {host}")));
    }
    // With a target the flags are for what runs on it, and not for macros and build scripts.
    let tests = "cargo test --quiet -p basis-kernel -p basis-runtime --all-features --lib --tests \
                 --target-dir target/sanitizer --target";
    let mut run = unstable(command(root, &format!("{tests} {host}")));
    run.env("RUSTFLAGS", "-Zsanitizer=address");
    succeed(run)
}

/// Miri is part of nightly toolchains only, which `RUSTC_BOOTSTRAP` does not replace.
fn miri(root: &Path) -> Outcome {
    if !works(command(root, "cargo +nightly miri --version")) {
        let how = "rustup toolchain install nightly --component miri,rust-src";
        return Err(Ended::Skipped(format!("there is no Miri: `{how}`")));
    }
    let test =
        "cargo +nightly miri test --quiet -p basis-runtime --no-default-features --target-dir target/miri";
    let miri = |arguments: &str, flags: &str| {
        let mut run = command(root, &format!("{test} {arguments}"));
        // Test files are read, and the time is asked for.
        run.env("MIRIFLAGS", "-Zmiri-disable-isolation").env("RUSTFLAGS", flags);
        succeed(run)
    };
    // With these features of the processor the functions are called that need them: all `unsafe` there is.
    miri("--features std --test numeric -- slices::few slices::slices", "-Ctarget-feature=+avx2,+fma")?;
    miri("--features std,geometry,bspline,elements,mesh --lib", "")
}

fn fuzz(root: &Path) -> Outcome {
    let targets = ["parser", "spec", "certificate", "tokens", "knots", "nets", "emitted"];
    if subcommand(root, "fuzz").is_ok() {
        for target in targets {
            let found = root.join("target/fuzz").join(target);
            fs::create_dir_all(&found).map_err(|e| Ended::Failed(format!("{}: {e}", found.display())))?;
            // The sanitizer has a step of its own, and takes half of the speed. The first folder is for what is found.
            let line = format!("cargo fuzz run --sanitizer none {target}");
            let mut run = unstable(command(root, &line));
            run.arg(&found);
            // Of the parser the corpus is that of specs.
            let own = root.join("fuzz/corpus").join(target);
            if own.exists() {
                run.arg(own);
            }
            let is_spec = matches!(target, "parser" | "tokens" | "emitted");
            if is_spec {
                run.arg(root.join("fuzz/corpus/spec")); // the same language: its own folder has what this one lacks
            }
            run.arg("--");
            run.args(["-max_total_time=1200", "-timeout=10", "-rss_limit_mb=512", "-max_len=2048"]);
            run.arg("-print_final_stats=1");
            let dictionary = if matches!(target, "parser" | "emitted") { "spec" } else { target };
            let dictionary = root.join(format!("fuzz/{dictionary}.dict"));
            if dictionary.exists() {
                run.arg(format!("-dict={}", dictionary.display()));
            }
            run.env("PATH", search_path(root));
            succeed(run)?;
        }
        return Ok(());
    }
    println!("there is no cargo-fuzz: random changes of the corpus, without its guidance");
    let line =
        "cargo run --quiet --release --manifest-path fuzz/Cargo.toml --no-default-features --example replay";
    for target in targets {
        succeed(command(root, &format!("{line} -- {target} 1200")))?;
    }
    Ok(())
}

fn coq(root: &Path) -> Outcome {
    if !works(command(root, "coqc --version")) {
        return Err(Ended::Skipped(String::from("there is no coqc")));
    }
    succeed(command(root, ".ci/coq"))
}

fn mutants_of_specs(root: &Path) -> Outcome {
    succeed(command(
        root,
        "cargo test --quiet --release -p basis-engine --features tools --test proofs mutation -- --ignored --nocapture",
    ))
}

fn mutants_of_kernel(root: &Path) -> Outcome {
    subcommand(root, "mutants")?;
    let output = root.join("target/mutants");
    let mut run = command(root, "cargo mutants --package basis-kernel --timeout 120 --output");
    run.arg(&output).env("PATH", search_path(root));
    // Exit code 2: some mutants are missed; whether they may be, is said below.
    match run.status() {
        Ok(status) if matches!(status.code(), Some(0 | 2 | 3)) => {}
        Ok(status) => return Err(Ended::Failed(format!("cargo mutants ends with {status}"))),
        Err(e) => return Err(Ended::Failed(e.to_string())),
    }
    let read = |path: PathBuf| {
        fs::read_to_string(&path).map_err(|e| Ended::Failed(format!("{}: {e}", path.display())))
    };
    let missed = read(output.join("mutants.out/missed.txt"))?;
    let explained = read(root.join("kernel/tests/survivors.md"))?;
    let new: Vec<&str> = missed.lines().filter(|line| !explained.contains(&without_place(line))).collect();
    if new.is_empty() {
        return Ok(());
    }
    Err(Ended::Failed(format!("mutants survive without an explanation:\n{}", new.join("\n"))))
}

/// `kernel/src/point.rs:50:36: replace < with <= in Point::check` without the line and the column, which change.
fn without_place(line: &str) -> String {
    let mut parts = line.splitn(4, ':');
    let (file, rest) = (parts.next().unwrap_or_default(), parts.nth(2).unwrap_or_default());
    format!("`{file}:{rest}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_left_out() {
        let line = "kernel/src/point.rs:50:36: replace < with <= in Point::check";
        assert_eq!(without_place(line), "`kernel/src/point.rs: replace < with <= in Point::check`");
    }

    #[test]
    fn targets_are_those_of_the_folder() {
        let manifest = include_str!("../../fuzz/Cargo.toml");
        for target in ["parser", "spec", "certificate", "tokens", "knots", "nets", "emitted"] {
            assert!(manifest.contains(&format!("name = \"{target}\"")), "{target}");
        }
    }
}
