//! Standard streams: colours, closed pipes, full disks.

use std::io::Read;
use std::process::Stdio;

use crate::support::{BERNSTEIN, Folder, QUARTIC, Run};

#[test]
fn no_colours_unless_asked_for() {
    let folder =
        Folder::with("wrong.basis", "family F { domain 0 <= t <= 1; b[0] = t; prove partition_of_unity; }");
    let run = folder.run(&["check", "wrong.basis"]);
    assert!(!run.stdout.contains('\u{1b}') && !run.stderr.contains('\u{1b}'));
    let run = Run::of(
        folder.command(&["check", "wrong.basis"]).env("CLICOLOR_FORCE", "1").output().expect("it starts"),
    );
    assert!(run.stdout.contains("\u{1b}[") && run.stderr.contains("\u{1b}["));
    let forced =
        folder.command(&["check", "wrong.basis"]).env("CLICOLOR_FORCE", "1").env("NO_COLOR", "1").output();
    let run = Run::of(forced.expect("it starts"));
    assert!(!run.stdout.contains('\u{1b}') && !run.stderr.contains('\u{1b}'));
}

#[test]
fn a_reader_may_go_away() {
    let folder = Folder::with("bernstein.basis", BERNSTEIN).and("quartic.basis", QUARTIC);
    for format in ["text", "json"] {
        let mut child = folder
            .command(&["check", "--format", format, "bernstein.basis", "quartic.basis"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts");
        drop(child.stdout.take());
        let mut stderr = String::new();
        child.stderr.take().expect("piped").read_to_string(&mut stderr).expect("UTF-8");
        assert_eq!(child.wait().expect("it ends").code(), Some(0), "{stderr}");
        assert_eq!(stderr, "");
    }
}

#[test]
fn nobody_needs_to_read_the_messages() {
    let folder =
        Folder::with("wrong.basis", "family F { domain 0 <= t <= 1; b[0] = t; prove partition_of_unity; }");
    for arguments in [&["check", "wrong.basis"] as &[&str], &["eval", "wrong.basis", "G"], &["nonsense"]] {
        let mut child = folder
            .command(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it starts");
        drop(child.stderr.take());
        let code = child.wait().expect("it ends").code();
        assert_eq!(code, Some(if arguments[0] == "check" { 1 } else { 2 }));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_written_is_2() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    for format in ["text", "json"] {
        let full = std::fs::File::options().write(true).open("/dev/full").expect("Linux has it");
        let output = folder.command(&["check", "--format", format, "quartic.basis"]).stdout(full).output();
        let run = Run::of(output.expect("it starts"));
        assert_eq!(run.code, 2);
        assert!(run.stderr.starts_with("error: cannot write to standard output"), "{}", run.stderr);
    }
}
