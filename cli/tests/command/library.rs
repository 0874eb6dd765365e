//! Specs of the library at the command line: `library:quartic` wherever a spec is named.

use crate::support::Folder;

#[test]
fn every_command_takes_them() {
    let folder = Folder::new();
    let check = folder.run(&["check", "library:quartic"]);
    assert_eq!((check.code, check.stderr.as_str()), (0, ""), "{}", check.stdout);
    assert!(
        check.stdout.contains("library:quartic") && check.stdout.contains("QuarticBernstein"),
        "{check:?}"
    );

    let call = ["eval", "library:quartic", "QuarticBernstein", "--shape", "lambda=1/2", "--at", "t=1/3"];
    let eval = folder.run(&call);
    assert!(eval.code == 0 && eval.stdout.contains("40/81"), "{eval:?}");

    // Its joins stand in a spec that uses another one.
    let explain = folder.run(&["explain", "library:quartic_surface"]);
    assert!(explain.code == 0 && explain.stdout.contains("G1"), "{explain:?}");

    let table = folder.run(&["table", "library:hermite"]);
    assert!(table.code == 0 && table.stdout.contains("[CubicHermite](library:hermite)"), "{table:?}");
}

#[test]
fn folders_of_the_library() {
    let folder = Folder::new();
    let (code, report) = folder.check_json(&["library:papers"]);
    assert_eq!(code, 0);
    let files = |report: &serde_json::Value| -> Vec<String> {
        let files = report["files"].as_array().expect("there are files");
        files.iter().map(|file| file["path"].as_str().expect("a path").to_string()).collect()
    };
    let papers = ["bspline", "quadratic", "quartic", "revolution", "triangular"];
    assert_eq!(files(&report), papers.map(|name| format!("library:papers/{name}")));
    let (code, report) = folder.check_json(&["library:"]);
    assert_eq!((code, report["ok"].as_bool()), (0, Some(true)));
    let all = files(&report);
    assert!(
        all.contains(&String::from("library:ball")) && all.contains(&String::from("library:papers/bspline"))
    );
}

#[test]
fn specs_that_use_the_library() {
    let spec = "use library \"quartic\";\nfamily Mine { domain 0 <= t <= 1; b[0] = QuarticBernstein(1/2)[1];\n\
                prove b[0] <= 1/2; refute b[0] <= 1/4; }";
    let run = Folder::with("mine.basis", spec).run(&["check", "mine.basis"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{}", run.stdout);
}

#[test]
fn certificates_of_the_library() {
    let folder = Folder::new();
    let check =
        folder.run(&["check", "--certificates", "proofs", "library:quartic", "library:papers/bspline"]);
    assert_eq!((check.code, check.stderr.as_str()), (0, ""));
    assert!(folder.path().join("proofs/library/quartic/QuarticBernstein.json").is_file());
    let verify = folder.run(&["verify", "proofs"]);
    assert_eq!((verify.code, verify.stderr.as_str()), (0, ""), "{}", verify.stdout);
    let verify = folder.run(&["verify", "proofs", "library:quartic"]);
    assert_eq!(verify.code, 0, "{}", verify.stdout);
    let more = folder.run(&["verify", "proofs", "library:hermite"]);
    assert!(
        more.code == 1 && more.stdout.contains("library:hermite: no certificates were written for it"),
        "{more:?}"
    );
}

#[test]
fn unknown_names() {
    for call in [
        vec!["check", "library:quartik"],
        vec!["check", "library:quartic.basis"],
        vec!["explain", "library:specs/quartic"],
        vec!["eval", "library:quartik", "QuarticBernstein", "--at", "t=0"],
    ] {
        let run = Folder::new().run(&call);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(
            run.stderr.contains(" in the library") && run.stderr.contains("did you mean `quartic`?"),
            "{run:?}"
        );
        assert!(run.stderr.contains("basis table library:") && !run.stderr.contains("`ball`"), "{run:?}");
    }
    // What contains the word, or where nothing does, all.
    let run = Folder::new().run(&["check", "library:trigonometric"]);
    assert!(run.stdout.contains("library:trigonometric/han"), "a folder is one of the names: {run:?}");
    let run = Folder::new().run(&["explain", "library:chebysh"]);
    assert!(run.stderr.contains("= note: the library has `polynomials/chebyshev`\n"), "{run:?}");
    let run = Folder::new().run(&["explain", "library:nope"]);
    assert!(!run.stderr.contains("others") && run.stderr.contains(", `trigonometric/han`, "), "{run:?}");
}

/// A file with such a name is named with its folder; Windows has no such names.
#[cfg(unix)]
#[test]
fn a_file_that_is_called_like_the_library() {
    let folder = Folder::with("library:x", "family One { domain 0 <= t <= 1; b[0] = 1; prove sum(b) = 1; }");
    assert_eq!(folder.run(&["check", "library:x"]).code, 2);
    assert_eq!(folder.run(&["check", "./library:x"]).code, 0);
}
