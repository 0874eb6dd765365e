//! Mutants of the shipped specs: one coefficient, sign, exponent or range end is changed at a time, and every mutant
//! that changes the mathematics must be rejected with evidence that checks out.
//!
//! `cargo test` looks at every 71st mutant; all of them, with their numbers:
//! `cargo test --release -p basis-engine --features tools --test proofs mutation -- --ignored --nocapture`.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::recheck;
use basis_engine::theorem::theorems;
use basis_engine::{Disk, Item, Library, Prover, Selected, Severity, Source, Subject, Verdict, state};

/// Mutants that are refused without a witness, with the reason, one by one.
const EXPLAINED: [(&str, &str); 2] = [
    (
        "triangular.basis:264: `+` → `-`",
        "`… - v*b[i,j-1,k] + …` in the recursion of `TypeIIndependent`: without the symmetries of the triangle its tables do not \
         fall apart, and the budget is spent on the signs of minors in two shape parameters from order 4 on",
    ),
    ("triangular.basis:264: `+` → `-`", "`… - w*b[i,j,k-1]` in the same recursion, from order 3 on"),
];

/// What became of a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Fate {
    /// The spec has errors apart from its claims, such as a range whose ends are exchanged.
    Malformed,
    /// A claim is refuted, and the witness evaluates to what it says; or a claim that is declared false is proved.
    Rejected,
    /// The functions, ranges and claims are the same as before.
    Unchanged,
    /// Every claim is still as declared, and its proof or witness checks out: no error of the toolchain.
    StillTrue,
    /// A claim is neither proved nor refuted.
    Undecided,
}

/// A change of a text: what stands at a place, and what takes its place.
struct Mutation {
    start: usize,
    end: usize,
    new: String,
}

/// All mutations of the code of a spec: numbers grow by one, signs are exchanged, ends of ranges are left out or
/// included.
fn mutations(text: &str) -> Vec<Mutation> {
    let bytes = text.as_bytes();
    let mut all = Vec::new();
    let mut at = 0;
    // Index parameters say which orders are checked, not what is claimed of them.
    let mut in_header = false;
    while at < bytes.len() {
        let rest = &text[at..];
        if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        }
        if let Some(inside) = rest.strip_prefix('"') {
            at += 2 + inside.find('"').unwrap_or(0);
            continue;
        }
        if rest.starts_with("family ") || rest.starts_with("budget ") {
            in_header = true;
        }
        if rest.starts_with('{') || rest.starts_with(';') {
            in_header = false;
        }
        let before = text[..at].chars().next_back();
        let in_name = before.is_some_and(|c| c.is_alphanumeric() || c == '_');
        if bytes[at].is_ascii_digit() && !in_name {
            let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
            let decimals = rest[digits..]
                .strip_prefix('.')
                .map_or(0, |d| d.bytes().take_while(u8::is_ascii_digit).count());
            let len = if decimals > 0 { digits + 1 + decimals } else { digits };
            if !in_header {
                let new = if decimals > 0 {
                    format!("{}1", &rest[..len])
                } else {
                    (rest[..digits].parse::<u64>().expect("a small number") + 1).to_string()
                };
                all.push(Mutation { start: at, end: at + len, new });
            }
            at += len;
            continue;
        }
        let replaced = [("<=", "<"), (">=", ">"), ("+", "-"), ("-", "+"), ("<", "<="), (">", ">=")];
        if let Some((old, new)) = replaced.iter().find(|(old, _)| rest.starts_with(old)) {
            if !in_header {
                all.push(Mutation { start: at, end: at + old.len(), new: String::from(*new) });
            }
            at += old.len();
            continue;
        }
        at += rest.chars().next().map_or(1, char::len_utf8);
    }
    all
}

/// Everything that a spec says, for comparison; places left out.
fn meaning(library: &Library<'_>) -> String {
    let said = |item: &Item| {
        let claims: Vec<String> =
            item.claims.iter().map(|c| format!("{:?}{:?}", c.expected, c.kind)).collect();
        match &item.subject {
            Subject::Family(f) => {
                format!("{}{:?}{:?}{:?}{:?}{claims:?}", f.name, f.order, f.shapes, f.domain, f.functions)
            }
            Subject::Theorem(t) => format!("{}{:?}{claims:?}", t.name, t.scalars),
        }
    };
    items(library).iter().map(said).collect()
}

/// The families in all orders, the theorems and the joins.
fn items(library: &Library<'_>) -> Vec<Item> {
    library.items(Selected::EveryOrder).into_iter().chain(theorems(library)).collect()
}

/// What becomes of a spec; the first claim that is not as declared decides.
fn fate(text: &str, path: &Path, original: &str) -> Result<Fate, String> {
    let mut source = Source::text("mutant.basis", text);
    source.path = Some(path.to_path_buf());
    let library = Library::from_source(&Disk, &Prover, source);
    let mut fate = Fate::StillTrue;
    let items = items(&library);
    if library.diagnostics().iter().any(|d| d.severity == Severity::Error) {
        return Ok(Fate::Malformed);
    }
    if meaning(&library) == original {
        return Ok(Fate::Unchanged);
    }
    for Item { subject, claims, .. } in items {
        for claim in &claims {
            let verdict = state::decide(&subject, claim);
            let checked = recheck(&subject, claim, &verdict);
            checked.map_err(|e| format!("{}: `{}`: {e}", subject.title(), claim.text))?;
            match &verdict {
                // A conjecture may be undecided, in a mutant as in the original, and so may the sign of t beside sin t.
                Verdict::Undecided(_) if claim.expected.keyword() == "conjecture" => {}
                Verdict::Undecided(why) if why.contains("a variable beside its sine") => {}
                Verdict::Undecided(_) => fate = Fate::Undecided,
                _ if state::as_declared(claim.expected, &verdict) => {}
                _ => return Ok(Fate::Rejected),
            }
        }
    }
    Ok(fate)
}

/// The shipped specs, sorted.
fn specs() -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs")];
    let mut specs = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of specs") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "basis") {
                specs.push(path);
            }
        }
    }
    specs.sort();
    specs
}

/// The fates of every `every`-th mutant: the number of each, and the mutants that are undecided.
fn run(every: usize) -> (BTreeMap<Fate, usize>, Vec<String>) {
    let (mut fates, mut undecided) = (BTreeMap::new(), Vec::new());
    let mut number = 0;
    for path in specs() {
        let text = fs::read_to_string(&path).expect("a spec");
        let mut source = Source::text("original.basis", &text);
        source.path = Some(path.clone());
        let original = meaning(&Library::from_source(&Disk, &Prover, source));
        for Mutation { start, end, new } in mutations(&text) {
            number += 1;
            if number % every != 0 {
                continue;
            }
            let mutant = format!("{}{new}{}", &text[..start], &text[end..]);
            let line = text[..start].matches('\n').count() + 1;
            let name = path.file_name().and_then(|n| n.to_str()).expect("Unicode");
            let place = format!("{name}:{line}: `{}` → `{new}`", &text[start..end]);
            let fate = fate(&mutant, &path, &original).unwrap_or_else(|e| panic!("{place}: {e}"));
            *fates.entry(fate).or_default() += 1;
            if fate == Fate::Undecided {
                undecided.push(place);
            }
        }
    }
    (fates, undecided)
}

#[test]
fn a_sample_of_the_mutants() {
    let (fates, undecided) = run(191);
    assert!(
        undecided.iter().all(|mutant| EXPLAINED.iter().any(|(known, _)| mutant == known)),
        "{undecided:?}"
    );
    assert!(fates[&Fate::Rejected] > 30, "{fates:?}");
}

#[test]
#[ignore = "minutes in an unoptimised build"]
fn all_mutants() {
    let (fates, undecided) = run(1);
    println!("{fates:?}");
    assert_eq!(undecided, EXPLAINED.map(|(mutant, _)| mutant));
    assert!(fates[&Fate::Rejected] > 3000, "{fates:?}");
}
