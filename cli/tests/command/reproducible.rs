//! What is written does not depend on where: certificates, generated code, theorems for Coq and explanations are the same
//! bytes in other locales, time zones, terminals and folders, on one core and on many.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::{BERNSTEIN, Folder, QUARTIC};

/// Claims that need searches, a family with denominators, and a theorem.
const MORE: &str = "\
family Searched {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 1;
    let w = 1 + λ*t;
    b[0] = (1 - t)/w;
    b[1] = (1 + λ)*t/w;
    prove nonnegative;
    prove partition_of_unity;
    prove (3*t - 1)^2 + (3*λ - 1)^2 + 1/1000000 > 0;
    prove (t - λ)^2 >= 0;
    refute (2*t^2 - 1)^2 + (3*λ^2 - 1)^2 > 0;
    prove independent;
}
theorem Ends {
    curve P = Searched(λ);
    prove P(0) == P[0];
    refute dot(P[0], P[1]) >= 0;
}
";

/// The commands whose output is compared.
const COMMANDS: [&[&str]; 5] = [
    &["check", "--certificates", "proofs", "--quiet", "."],
    &["check", "--coq", "v", "--quiet", "quartic.basis"],
    &["emit", "quartic.basis", "--to", "rust", "-o", "families.rs"],
    &["explain", "quartic.basis"],
    &["emit", "bernstein.basis", "Bern(5)", "--to", "rust", "-o", "five.rs"],
];

/// All files below a folder, with their contents.
fn files(folder: &Path, found: &mut BTreeMap<String, Vec<u8>>, base: &Path) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(&path, found, base);
        } else {
            let name = path.strip_prefix(base).expect("below").display().to_string();
            found.insert(name, fs::read(&path).expect("a file can be read"));
        }
    }
}

/// What the commands write in a folder of its own, by way of another program such as `taskset`.
fn written(by: &[&str], variables: &[(&str, &str)]) -> BTreeMap<String, Vec<u8>> {
    let folder =
        Folder::with("quartic.basis", QUARTIC).and("bernstein.basis", BERNSTEIN).and("more.basis", MORE);
    let mut found = BTreeMap::new();
    for (k, arguments) in COMMANDS.iter().enumerate() {
        let program = [by, &[env!("CARGO_BIN_EXE_basis")]].concat();
        let mut command = Command::new(program[0]);
        command.args(&program[1..]).args(*arguments).current_dir(folder.path());
        command.envs(variables.iter().copied());
        let run = command.output().expect("the command starts");
        let stderr = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.code() == Some(0), "{arguments:?}: {stderr}");
        found.insert(format!("output {k}"), run.stdout);
    }
    files(folder.path(), &mut found, folder.path());
    found
}

#[test]
fn the_same_bytes_everywhere() {
    let usual = written(&[], &[]);
    assert!(usual.len() > 20, "{:?}", usual.keys());
    let mut others = vec![
        written(&[], &[("LC_ALL", "tr_TR.UTF-8"), ("LANG", "tr_TR.UTF-8"), ("LANGUAGE", "tr")]),
        written(&[], &[("LC_ALL", "C"), ("TZ", "Pacific/Kiritimati"), ("COLUMNS", "40"), ("TERM", "dumb")]),
        written(
            &[],
            &[("TZ", "UTC-11"), ("SOURCE_DATE_EPOCH", "1"), ("HOME", "/"), ("RUST_BACKTRACE", "full")],
        ),
    ];
    let one_core = ["taskset", "-c", "0"];
    if Command::new(one_core[0]).args(&one_core[1..]).arg("true").status().is_ok_and(|s| s.success()) {
        others.push(written(&one_core, &[]));
    }
    for other in others {
        assert_eq!(other.keys().collect::<Vec<_>>(), usual.keys().collect::<Vec<_>>());
        for (name, bytes) in &usual {
            assert!(other[name] == *bytes, "{name} differs");
        }
    }
}
