//! How messages are printed: lines, marks, words about them.

use basis_engine::diagnostic::Place;
use basis_engine::{Diagnostic, Source, Sources};

/// The rendered message about parts of a text, which are given as they are written and with a word about each.
fn rendered(text: &str, parts: &[(&str, &str)]) -> String {
    let mut sources = Sources::default();
    let id = sources.add(Source::text("a.basis", text));
    let mut diagnostic = Diagnostic::unplaced("wrong");
    for (part, label) in parts {
        let start = text.find(part).expect("the part is in the text");
        diagnostic = diagnostic.also(Place::Text(id, start..start + part.len()), *label);
    }
    diagnostic.render(&sources, false)
}

#[test]
fn each_mark_has_a_row_below_its_line() {
    let text = "let α = 2;\n\nlet β = 3; let α = 4;\n";
    assert_eq!(
        rendered(text, &[("α = 4", "again"), ("β", ""), ("let α = 2", "first")]),
        "\
error: wrong
 --> a.basis:3:16
  |
1 | let α = 2;
  | --------- first
2 |
3 | let β = 3; let α = 4;
  |                ^^^^^ again
  |     -"
    );
}

#[test]
fn a_mark_over_several_lines_is_a_bracket() {
    assert_eq!(
        rendered("a;\n  prove b[0]\n    == 7;\n", &[("prove b[0]\n    == 7;", "refuted")]),
        "\
error: wrong
 --> a.basis:2:3
  |
2 | /   prove b[0]
3 | |     == 7;
  | |_________^ refuted"
    );
    let long = "a; b\n1\n2\n3\n\n5\n6\n7\n8; c\n9\n10\n11\n12 d";
    assert_eq!(
        rendered(long, &[("b\n1\n2\n3\n\n5\n6\n7\n8;", "here"), ("d", "there")]),
        "\
error: wrong
  --> a.basis:1:4
   |
 1 |   a; b
   |  ____^
 2 | | 1
 3 | | 2
...  |
 8 | | 7
 9 | | 8; c
   | |__^ here
...
13 |   12 d
   |      - there"
    );
}

#[test]
fn columns_are_those_of_a_terminal() {
    let text = "\tx /* 漢字 e\u{301} \u{1b}[31m \u{202e} */ y";
    assert_eq!(
        rendered(text, &[("y", "")]),
        "\
error: wrong
 --> a.basis:1:24
  |
1 |     x /* 漢字 e\u{301} ␛[31m \u{fffd} */ y
  |                            ^"
    );
}

#[test]
fn of_a_very_long_line_what_surrounds_the_mark_is_shown() {
    let text = format!("{} here {}", "α ".repeat(100_000), "β ".repeat(100_000));
    let shown = rendered(&text, &[("here", "this")]);
    let rows: Vec<&str> = shown.lines().skip(3).collect();
    let [line, marks] = rows[..] else { panic!("{shown}") };
    assert!(line.chars().count() < 150 && line.ends_with("..."), "{shown}");
    let at = |row: &str, part: &str| row.find(part).map(|at| row[..at].chars().count());
    assert_eq!(at(line, "here"), at(marks, "^^^^ this"), "{shown}");
}

#[test]
fn notes_go_on_below_their_first_line() {
    let sources = Sources::default();
    let diagnostic = Diagnostic::unplaced("wrong").note("one\ntwo").help("three");
    let text = "error: wrong\n |\n = note: one\n         two\n = help: three";
    assert_eq!(diagnostic.render(&sources, false), text);
    let styled = diagnostic.render(&sources, true);
    assert!(styled.starts_with("\u{1b}[1m\u{1b}[91merror\u{1b}[0m\u{1b}[1m: wrong\u{1b}[0m\n"), "{styled}");
}

#[test]
fn two_texts() {
    let mut sources = Sources::default();
    let [a, b] = ["a.basis", "b.basis"].map(|name| sources.add(Source::text(name, "one\ntwo")));
    let diagnostic = Diagnostic::error(Place::Text(a, 4..7), "wrong").label("here");
    assert_eq!(
        diagnostic.also(Place::Text(b, 0..3), "there").render(&sources, false),
        "\
error: wrong
 --> a.basis:2:1
  |
2 | two
  | ^^^ here
 ::: b.basis:1:1
  |
1 | one
  | --- there"
    );
}

/// A token that stands in for a character of several bytes ends inside of it, and an error at the end of a text has an
/// empty range.
#[test]
fn any_two_ranges_can_be_marked() {
    let text = "α\tb\r\n\n漢 = ;\n  \u{301}";
    let mut sources = Sources::default();
    let id = sources.add(Source::text("a.basis", text));
    let ends = text.len() + 2;
    for start in 0..ends {
        for end in start..ends {
            for other in 0..ends {
                let diagnostic = Diagnostic::error(Place::Text(id, start..end), "wrong");
                let diagnostic = diagnostic.also(Place::Text(id, other..ends), "other");
                let shown = diagnostic.render(&sources, false);
                assert!(shown.contains('^') && shown.contains("- other"), "{shown}");
            }
        }
    }
}
