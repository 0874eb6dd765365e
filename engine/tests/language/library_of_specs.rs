//! `use library "…"`: specs of the library in other specs, and within the library.

use std::io;
use std::path::Path;

use basis_engine::{Diagnostic, Files, Library, Selected, Source, source};

/// A library of its own, and no files.
struct Shelf(Vec<(&'static str, &'static str)>);

impl Files for Shelf {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }

    fn library(&self) -> &[(&str, &str)] {
        &self.0
    }
}

/// The rendered errors of a spec, its claims included.
fn errors(files: &dyn Files, source: Source) -> Vec<String> {
    let library = Library::from_source(files, &basis_engine::Prover, source);
    let items = library.items(Selected::EveryOrder);
    let wrong: Vec<Diagnostic> = items
        .into_iter()
        .map(basis_engine::decide)
        .flat_map(|checked| basis_engine::contradictions(&checked))
        .collect();
    let all = library.diagnostics().into_iter().chain(wrong);
    all.map(|diagnostic| diagnostic.render(library.sources(), false)).collect()
}

fn line(claim: &str) -> String {
    format!("family Line {{ domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; {claim} }}")
}

#[test]
fn families_of_the_shipped_library_can_be_named() {
    let spec = format!(
        "use library \"quartic\"; {}",
        line("prove QuarticBernstein(0)[0] = QuarticBernstein(1)[0];")
    );
    let [error] = &errors(&basis_engine::Disk, Source::text("mine.basis", &spec))[..] else { panic!() };
    assert!(error.contains("mine.basis:1:") && error.contains("is false"), "{error}");
    let spec = format!("use library \"quartic\"; {}", line("prove sum(QuarticBernstein(1)) = sum(b);"));
    assert_eq!(errors(&basis_engine::Disk, Source::text("mine.basis", &spec)), [""; 0]);
}

#[test]
fn paths_stay_in_the_library() {
    let shelf = Shelf(vec![
        ("end", "family End { domain 0 <= t <= 1; b[0] = t; }"),
        (
            "papers/a/one",
            "use \"../two.basis\"; family One { domain 0 <= t <= 1; b[0] = Two[0]; prove b = Two; }",
        ),
        ("papers/two", "use \"./../end.basis\"; family Two { domain 0 <= t <= 1; b[0] = End[0]; }"),
    ]);
    let used = format!("use library \"papers/a/one\"; use library \"end\"; {}", line("prove b[1] = One[0];"));
    assert_eq!(errors(&shelf, Source::text("mine.basis", &used)), [""; 0]);
    let itself = source::library(&shelf, "papers/a/one").expect("it is there");
    assert_eq!(errors(&shelf, itself), [""; 0]);
}

#[test]
fn places_in_the_library_have_its_names() {
    let shelf = Shelf(vec![("papers/one", "family One {\n    domain 0 <= t <= 1;\n    b[0] = t t;\n}")]);
    let spec = format!("use library \"papers/one\"; {}", line(""));
    let [error] = &errors(&shelf, Source::text("mine.basis", &spec))[..] else { panic!() };
    assert!(error.contains("--> library:papers/one:3:"), "{error}");
}

#[test]
fn unknown_names() {
    let find = |name: &str| source::library(&basis_engine::Disk, name).expect_err("there is no such spec");
    for (typed, meant) in [
        ("quartik", "quartic"),
        ("Quartic", "quartic"),
        ("quartic.basis", "quartic"),
        ("specs/quartic.basis", "quartic"),
        ("papers/quartik", "papers/quartic"),
    ] {
        let error = find(typed);
        assert_eq!(error.message, format!("there is no spec `{typed}` in the library"));
        assert_eq!(error.help, Some(format!("did you mean `{meant}`?")), "{typed}");
    }
    // All names are listed where none is meant, else those that contain what was typed.
    let error = find("nothing of the kind");
    assert_eq!(error.help, None);
    assert!(error.notes[0].contains("`ball`, ") && error.notes[0].contains("`quartic`, "));
    assert!(find("quartik").notes.is_empty());
    let spec = "use library \"quartik\";";
    let [error] = &errors(&basis_engine::Disk, Source::text("mine.basis", spec))[..] else { panic!() };
    assert!(error.contains("mine.basis:1:13") && error.contains("did you mean `quartic`?"), "{error}");
}

#[test]
fn wrong_uses() {
    for (spec, message) in [
        ("use library quartic;", "expected the name of a spec of the library in quotation marks"),
        ("use library;", "expected the name of a spec of the library in quotation marks"),
        ("use library \"quartic\"", "expected `;` after the path"),
    ] {
        let errors = errors(&basis_engine::Disk, Source::text("mine.basis", spec));
        assert!(errors[0].contains(message), "{errors:?}");
        assert!(errors[0].contains("write `use library \"quartic\";`"), "{errors:?}");
    }
    let shelf = Shelf(vec![
        ("a", "use \"b.basis\";"),
        ("b", "use \"a.basis\";"),
        ("out", "use \"../x.basis\";"),
        ("name", "use \"a\";"),
        ("gone", "use \"c.basis\";"),
    ]);
    let of = |name: &str| errors(&shelf, source::library(&shelf, name).expect("it is there")).join("\n");
    assert!(of("a").contains("cyclic `use`: library:a uses library:b uses library:a"), "{}", of("a"));
    assert!(of("out").contains("leads out of the library"), "{}", of("out"));
    assert!(of("name").contains("the names of its files end with `.basis`"), "{}", of("name"));
    assert!(of("gone").contains("there is no spec `c` in the library"), "{}", of("gone"));
}
