//! Beginning a spec and living with it: `new`, `fmt`, `check -q`, `check -`, `check --watch`, and what shells know.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::process::Stdio;
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

use crate::support::{Folder, QUARTIC, Run};

#[test]
fn a_new_spec_is_proved_and_in_the_standard_layout() {
    for (kind, family, file) in [
        ("curve", "RationalCubic", "rational_cubic.basis"),
        ("degrees", "Degrees", "degrees.basis"),
        ("rational", "Hyperbolas", "hyperbolas.basis"),
        ("trigonometric", "Waves", "waves.basis"),
        ("spline", "Bells", "bells.basis"),
        ("triangle", "Δ2", "delta2.basis"),
        ("box", "B", "b.basis"),
        ("join", "G1Join", "g1_join.basis"),
    ] {
        let folder = Folder::new();
        let run = folder.run(&["new", family, "--kind", kind]);
        assert_eq!((run.code, run.stderr.as_str()), (0, ""));
        assert_eq!(run.stdout, format!("wrote {file}; `basis check {file}` proves its claims\n"));
        let text = fs::read_to_string(folder.path().join(file)).expect("it is written");
        assert!(text.contains(family));
        let check = folder.run(&["check", "-q", file]);
        assert_eq!((check.code, check.stdout.as_str(), check.stderr.as_str()), (0, "", ""), "{kind}");
        let fmt = folder.run(&["fmt", "--check", file]);
        assert_eq!((fmt.code, fmt.stdout.as_str()), (0, ""), "{kind}");
        // Nothing is overwritten.
        let again = folder.run(&["new", family]);
        assert_eq!(again.code, 2);
        assert!(again.stderr.contains("already"), "{}", again.stderr);
        assert_eq!(fs::read_to_string(folder.path().join(file)).expect("it is there"), text);
    }
    // Without a kind the name says what is meant.
    for (family, kind, word) in [
        ("RationalQuartic", "rational", "/w;"),
        ("TrigBezier", "trigonometric", "sin(θ)"),
        ("CubicSpline", "spline", " | "),
        ("Quartic", "curve", "λ*t"),
    ] {
        let run = Folder::new().run(&["new", family]);
        assert!(run.stdout.contains(&format!(", with `--kind {kind}`; ")), "{}", run.stdout);
        assert!(Folder::new().run(&["new", family, "-o", "-"]).stdout.contains(word), "{family}");
    }
    let folder = Folder::new();
    for name in ["2d", "a b", "for", ""] {
        assert_eq!(folder.run(&["new", name]).code, 2, "{name}");
    }
    assert!(folder.run(&["new", "F", "-o", "-"]).stdout.starts_with("//! "));
    assert_eq!(folder.run(&["new", "F", "-o", "no/f.basis"]).code, 2);
}

const MESSY: &str = "// λ\nfamily F{domain 0<=t<=1;   // the unit interval
b[0]=1-t;b[1]=t;/* both */
prove   partition_of_unity ;}";

const NEAT: &str = "// λ
family F {
    domain 0 <= t <= 1;   // the unit interval
    b[0] = 1 - t;
    b[1] = t; /* both */
    prove partition_of_unity;
}
";

#[test]
fn files_get_the_standard_layout() {
    let folder =
        Folder::with("a.basis", MESSY).and("sub/b.basis", NEAT).and("c.basis", NEAT.replace('\n', "\r\n"));
    let check = folder.run(&["fmt", "--check", "."]);
    assert_eq!((check.code, check.stdout.as_str()), (1, "./a.basis\n./c.basis\n"));
    assert_eq!(fs::read_to_string(folder.path().join("a.basis")).expect("it is there"), MESSY);
    let run = folder.run(&["fmt", "."]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
    for file in ["a.basis", "sub/b.basis", "c.basis"] {
        assert_eq!(fs::read_to_string(folder.path().join(file)).expect("it is there"), NEAT, "{file}");
    }
    assert_eq!(folder.run(&["fmt", "--check", "."]).code, 0);
}

#[test]
fn what_has_no_layout_stays_as_it_is() {
    let folder = Folder::with("a.basis", "family F {\n    b[0] = (1;\n}\n");
    let run = folder.run(&["fmt", "a.basis"]);
    assert_eq!(run.code, 2);
    assert_eq!(
        run.stderr.trim(),
        "error: `{` is not closed, so the spec has no layout
 --> a.basis:1:10
  |
1 | family F {
  |          ^ it has no partner
  |
  = help: write the other bracket; the file is as it was"
    );
    assert_eq!(folder.run(&["fmt", "library:quartic"]).code, 2);
    assert_eq!(folder.run(&["fmt", "nowhere.basis"]).code, 2);
}

/// The shipped specs are in the standard layout.
#[test]
fn the_library_is_in_the_standard_layout() {
    let run = Folder::new().run(&["fmt", "--check", concat!(env!("CARGO_MANIFEST_DIR"), "/../specs")]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
}

const USER: &str =
    "use \"q.basis\"; family F { domain 0 <= t <= 1; b[i] = QuarticBernstein(0)[i] for i in 0..=3; }";

/// Runs the command with a text on standard input.
fn with_input(folder: &Folder, arguments: &[&str], input: &[u8]) -> Run {
    let mut command = folder.command(arguments);
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    child.stdin.take().expect("it has an input").write_all(input).expect("it reads");
    Run::of(child.wait_with_output().expect("it ends"))
}

#[test]
fn a_spec_can_come_from_standard_input() {
    let folder = Folder::with("q.basis", QUARTIC);
    let run = with_input(&folder, &["check", "-"], QUARTIC.as_bytes());
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert!(run.stdout.contains("QuarticBernstein"));
    let wrong = QUARTIC.replace("refute", "prove");
    let run = with_input(&folder, &["check", "--quiet", "-"], wrong.as_bytes());
    assert_eq!((run.code, run.stdout.as_str()), (1, ""));
    assert!(run.stderr.contains("<stdin>:15:5"), "{}", run.stderr);
    let run = with_input(&folder, &["fmt", "-"], MESSY.as_bytes());
    assert_eq!((run.code, run.stdout.as_str()), (0, NEAT));
    assert_eq!(with_input(&folder, &["fmt", "--check", "-"], MESSY.as_bytes()).code, 1);
    let at = ["eval", "-", "QuarticBernstein", "--shape", "λ=0", "--at", "t=1/2"];
    assert!(with_input(&folder, &at, QUARTIC.as_bytes()).stdout.contains("3/8"));
    // What it uses is found in the current folder.
    let user =
        "use \"q.basis\"; family F { domain 0 <= t <= 1; b[i] = QuarticBernstein(0)[i] for i in 0..=3; }";
    assert_eq!(with_input(&folder, &["check", "-"], user.as_bytes()).code, 0);
    let run = with_input(&folder, &["check", "-"], b"family \xff");
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("not UTF-8"), "{}", run.stderr);
    for flag in [&["--watch"][..], &["--certificates", "proofs"]] {
        let run = folder.run(&[&["check", "-"], flag].concat());
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains("standard input cannot be checked"), "{}", run.stderr);
    }
}

#[test]
fn a_change_is_checked_again() {
    let folder = Folder::with("q.basis", QUARTIC).and("user.basis", USER);
    let mut command = folder.command(&["check", "--watch", "user.basis"]);
    let mut child =
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
    let (sender, lines) = channel();
    let output = BufReader::new(child.stderr.take().expect("it has an output"));
    thread::spawn(move || output.lines().map_while(Result::ok).all(|line| sender.send(line).is_ok()));
    let wait = |word: &str| loop {
        let line = lines.recv_timeout(Duration::from_secs(60)).expect("it goes on");
        if line.contains(word) {
            break line;
        }
    };
    assert_eq!(wait("watching"), "watching 2 files; press Ctrl-C to stop");
    folder.write("q.basis", &QUARTIC.replace("λ*t", "ν*t"));
    wait("error");
    wait("watching");
    folder.write("q.basis", QUARTIC);
    wait("watching");
    child.kill().expect("it runs still");
    child.wait().expect("it ends");
}

#[test]
fn shells_and_manuals_know_the_command() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.run(&["completions", shell]);
        assert_eq!(run.code, 0);
        assert!(run.stdout.contains("explain") && run.stdout.contains("certificates"), "{shell}");
    }
    assert!(folder.run(&["man"]).stdout.contains(".TH basis 1"));
    assert_eq!(folder.run(&["man", "-o", "man1"]).code, 0);
    let page = fs::read_to_string(folder.path().join("man1/basis-check.1")).expect("it is written");
    assert!(page.contains("Prove or refute every claim"));
    assert_eq!(folder.run(&["man", "check"]).stdout, page);
    let run = folder.run(&["man", "chekc"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.contains("the commands are `check`"), "{}", run.stderr);
}

#[test]
fn a_word_of_the_language_names_no_family() {
    let folder = Folder::new();
    for (word, help) in [
        ("triangle", "choose another: `basis new MyFamily --kind triangle`"),
        ("family", "choose another: `basis new MyFamily`"),
    ] {
        let run = folder.run(&["new", word]);
        assert_eq!(run.code, 2);
        assert!(
            run.stderr.contains("is a word of the language") && run.stderr.contains(help),
            "{}",
            run.stderr
        );
    }
}
