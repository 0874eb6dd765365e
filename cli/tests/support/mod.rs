//! Runs the command on specs in a temporary folder.
#![allow(dead_code)] // each test file uses its part

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;
use tempfile::TempDir;

/// The quartic family of generalized Bernstein functions, with claims that hold and one that does not.
pub(crate) const QUARTIC: &str = "\
/// λ = 0 gives the cubic Bernstein basis.
family QuarticBernstein {
    domain 0 <= t <= 1;
    shape -3 <= λ <= 1;

    b[0] = (1 - λ*t) * (1 - t)^3;
    b[1] = (3 + λ - λ*t) * t * (1 - t)^2;
    b[2] = (3 + λ*t) * t^2 * (1 - t);
    b[3] = (1 - λ + λ*t) * t^3;

    prove partition_of_unity;
    prove symmetric;
    prove at t = 0 { b = [1, 0, 0, 0]; D(b) = [-(3+λ), 3+λ, 0, 0]; }
    prove at λ = 0 { b = Bernstein(3); }
    refute b[0] = b[1];
}
";

/// The Bernstein basis of several degrees.
pub(crate) const BERNSTEIN: &str = "\
family Bern(n in 1..=12) {
    domain 0 <= t <= 1;
    b[i] = binomial(n, i) * t^i * (1 - t)^(n - i) for i in 0..=n;
    prove partition_of_unity;
    prove symmetric;
    prove b[i] = Bernstein(n)[i] for i in 0..=n;
    prove at t = 0 { D(b[0]) = -n; }
}
";

/// A temporary folder with files.
pub(crate) struct Folder(TempDir);

impl Folder {
    /// An empty folder.
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder can be made"))
    }

    /// A folder with one file.
    pub(crate) fn with(name: &str, text: &str) -> Self {
        Self::new().and(name, text)
    }

    /// The folder with one file more.
    pub(crate) fn and(self, name: &str, text: impl AsRef<[u8]>) -> Self {
        let path = self.path().join(name);
        fs::create_dir_all(path.parent().expect("inside the folder")).expect("a folder can be made");
        fs::write(path, text).expect("a file can be written");
        self
    }

    /// Overwrites a file of the folder.
    pub(crate) fn write(&self, name: &str, text: &str) -> &Self {
        fs::write(self.path().join(name), text).expect("a file can be written");
        self
    }

    /// Where it is.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    /// The command, to be run in this folder.
    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(PathBuf::from(env!("CARGO_BIN_EXE_basis")));
        command.args(arguments).current_dir(self.path()).stdin(Stdio::null());
        for variable in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
            command.env_remove(variable);
        }
        command
    }

    /// Runs the command in this folder.
    pub(crate) fn run(&self, arguments: &[&str]) -> Run {
        Run::of(self.command(arguments).output().expect("the command starts"))
    }

    /// Runs `basis check --format json`.
    pub(crate) fn check_json(&self, paths: &[&str]) -> (i32, Value) {
        let run = self.run(&[&["check", "--format", "json"], paths].concat());
        assert_eq!(run.stderr, "", "with JSON there is nothing on standard error");
        (run.code, run.json())
    }
}

/// What a run of the command left behind.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    pub(crate) fn of(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("the output is UTF-8");
        let code = output.status.code().expect("the command is not killed");
        Self { code, stdout: text(output.stdout), stderr: text(output.stderr) }
    }

    /// Standard output as one JSON value.
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|e| panic!("{e}: {self:?}"))
    }

    /// Standard output without the times, which differ from run to run, and without the names of the methods,
    /// which the engine chooses.
    pub(crate) fn stable(&self) -> String {
        let lines = self.stdout.lines().map(|line| {
            let mut line = line.trim_end();
            for word in ["total", "worst", "time"] {
                line = line.strip_suffix(word).map_or(line, str::trim_end);
            }
            while let Some(rest) = strip_time(line) {
                line = rest.trim_end().trim_end_matches(';');
            }
            match line.split_once("expansion of ") {
                Some((before, _)) => format!("{before}expansion of …\n"),
                None => format!("{line}\n"),
            }
        });
        lines.collect()
    }
}

/// The line without ` 12 µs` at its end.
fn strip_time(line: &str) -> Option<&str> {
    let rest = [" µs", " ms", " s"].iter().find_map(|unit| line.strip_suffix(unit))?;
    let number = rest.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
    (number.len() < rest.len()).then_some(number)
}
