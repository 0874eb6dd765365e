//! `basis check`: tables and messages as text.

use crate::support::{BERNSTEIN, Folder, QUARTIC};
use insta::assert_snapshot;

#[test]
fn a_table_for_each_family() {
    let folder = Folder::with("quartic.basis", QUARTIC);
    let run = folder.run(&["check", "quartic.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert_snapshot!(run.stable());
}

#[test]
fn orders_with_the_same_verdict_share_a_row() {
    let folder = Folder::with("bernstein.basis", BERNSTEIN);
    let run = folder.run(&["check", "bernstein.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    assert_snapshot!(run.stable());
}

#[test]
fn orders_with_other_verdicts_have_rows_of_their_own() {
    let spec = "\
family Powers(n in 1..=5) {
    domain 0 <= t <= 1;
    b[i] = t^i for i in 0..=n;
    prove partition_of_unity;
    prove at t = 0 {
        D(b[1]) = n;   // for lines only
        D(b[0]) = n - 3;
    }
    prove b[i] * b[n - i] = t^3 for i in 0..=n;
}
";
    let folder = Folder::with("powers.basis", spec);
    let run = folder.run(&["check", "powers.basis"]);
    assert_eq!(run.code, 1);
    assert_snapshot!("other_verdicts", run.stable());
    // One message for each statement that fails, with the orders that it does not show.
    let messages: Vec<&str> = run.stderr.split("error: ").skip(1).collect();
    assert_eq!(messages.len(), 4, "{}", run.stderr);
    for (message, rest) in messages.iter().zip(["n = 2..=5", "n = 3..=5", "n = 2, 4, 5", "n = 2, 4, 5"]) {
        assert!(message.contains(&format!("= note: for {rest}: the same verdict")), "{message}");
    }
    assert!(
        messages[3].contains("= note: 1 more claim of this statement: the same verdict"),
        "{}",
        messages[3]
    );
}

#[test]
fn many_claims_of_one_statement_share_a_row() {
    let spec = "family Many { domain 0 <= t <= 1; b[i] = t^i for i in 0..=9;
    prove b[i] = t^i for i in 0..=9;
    prove b[i] = t for i in 0..=2;
    refute b[i] = b[i+1] for i in 0..=8;
    prove at t = 0 { b[i] = 0 for i in 1..=9; } }";
    let run = Folder::with("many.basis", spec).run(&["check", "many.basis"]);
    assert_eq!(run.code, 1);
    assert_snapshot!(run.stable());
}

#[test]
fn glyphs_of_double_width_are_aligned() {
    let spec = "family 曲線 { domain 0 <= t <= 1; shape 0 <= 形 <= 1; b[0] = 1 - t + 形; b[1] = t - 形;
    prove partition_of_unity;
    prove b[0] + 形 - 形 = 1 - b[1];
    refute b[0] = 形; }";
    let run = Folder::with("wide.basis", spec).run(&["check", "wide.basis"]);
    assert_eq!(run.code, 0);
    assert_snapshot!(run.stable());
}

#[test]
fn a_family_without_claims_is_listed() {
    let spec = "family F { domain 0 <= u <= 1, 0 <= v <= 2; b[0] = u*v^2; }
family G { domain triangle (u, v, w); b[0] = u*w*v; }";
    let run = Folder::with("f.basis", spec).run(&["check", "f.basis"]);
    assert_eq!(run.code, 0);
    assert_snapshot!(run.stable());
}

#[test]
fn a_message_about_a_shared_file_is_printed_once() {
    let folder = Folder::with("a.basis", "use \"c.basis\";\nfamily A { domain 0 <= t <= 1; b[0] = C[0]; }")
        .and("b.basis", "use \"c.basis\";\nfamily B { domain 0 <= t <= 1; b[0] = C[0]; }")
        .and("c.basis", "family C { domain 0 <= t <= 1; b[0] = y; }");
    let run = folder.run(&["check", "a.basis", "b.basis", "c.basis"]);
    assert_eq!(run.code, 1);
    assert_eq!(run.stderr.matches("error: ").count(), 1, "{}", run.stderr);
}
