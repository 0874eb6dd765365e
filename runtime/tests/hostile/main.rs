//! No number makes a function of curves, surfaces, patches or meshes panic or run without end, and what they answer is
//! defined.
//!
//! Every public function stands in one of the tables, under its name, and is called with every net and every pair of
//! numbers.
#![cfg(feature = "std")]

mod curves;
mod patches;
mod slices;
#[path = "../sources/mod.rs"]
mod sources;
mod splines;
mod surfaces;

use core::fmt::Debug;

use basis_runtime::{Edge, EdgePair};
use basis_test_support::all_cases;

/// A function by its name, and a call that says whether the answer is one that the documentation allows.
type Case<T> = (&'static str, fn(&T, f64, f64) -> bool);

/// Parameters, lengths, accuracies, factors, angles.
const NUMBERS: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.375,
    3.0,
    1e-9,
    1e-300,
    f64::from_bits(1),
    1e300,
    f64::MAX,
    -f64::MAX,
    1e9,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

type P = [f64; 3];

fn pair(first: Edge, second: Edge, opposite: bool) -> EdgePair {
    if opposite { EdgePair::against(first, second) } else { EdgePair::along(first, second) }
}

/// The kinds of nets, of points in space with the number `i`.
const NETS: [fn(usize) -> P; 17] = [
    |i| [i as f64, (i * i) as f64 * 0.25, 1.0 - (i as f64).sin()],
    |_| [0.0; 3],
    |_| [0.5, -2.0, 1e10],
    |_| [f64::NAN; 3],
    |_| [f64::INFINITY, f64::NEG_INFINITY, 0.0],
    // A line, and one that is run along more than once.
    |i| [i as f64, 2.0 * i as f64, 0.5],
    |i| [(i % 2) as f64, 0.0, 0.0],
    // Cusps, and pairs of equal points.
    |i| [[0.0, 1.0, 0.0, 1.0][i % 4], [0.0, 1.0, 1.0, 0.0][i % 4], 0.0],
    |i| [(i / 2) as f64, ((i / 2) % 2) as f64, 0.0],
    // All sizes.
    |i| [1e308 * (i as f64).cos(), 1e308 * (i as f64).sin(), -1e308],
    |i| [f64::MAX * [1.0, -1.0][i % 2], f64::MAX * [1.0, -1.0][i / 2 % 2], 0.0],
    |i| [1e-308 * i as f64, 1e-308 * (i * i) as f64, 1e-308],
    |i| [5e-324 * i as f64, 5e-324 * ((i * i) % 3) as f64, 0.0],
    |i| [1e160 * i as f64, 1e-160 * (i * i) as f64, 1.0],
    |i| [1e16 + 2.0 * i as f64, 1.0 - (i as f64).cos(), (i as f64).sin()],
    // One component that is not a number.
    |i| [i as f64, if i == 2 { f64::NAN } else { 1.0 }, 0.0],
    |i| [i as f64, if i == 3 { f64::INFINITY } else { 1.0 }, 0.0],
];

/// Calls all cases with all nets and the pairs of numbers for each.
fn check<T: Debug>(cases: &[Case<T>], make: impl Fn(fn(usize) -> P) -> Option<T>) {
    let mut wrong: Vec<String> = Vec::new();
    for (k, net) in NETS.into_iter().enumerate() {
        let Some(value) = make(net) else { continue };
        for (name, call) in cases {
            if let Some((a, b)) = pairs(k).find(|&(a, b)| !call(&value, a, b)) {
                wrong.push(format!("{name} with {a:e} and {b:e} on net {k}: {value:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every number with itself and two others; where not all cases are asked for each of these three on every third net,
/// so that every net and every pair has its turn.
fn pairs(net: usize) -> impl Iterator<Item = (f64, f64)> {
    let all = all_cases();
    NUMBERS.into_iter().enumerate().flat_map(move |(k, a)| {
        let steps = [0, 5, 11].into_iter().enumerate();
        let here = steps.filter(move |(i, _)| all || (net + k + i).is_multiple_of(3));
        here.map(move |(_, step)| (a, NUMBERS[(k + step) % NUMBERS.len()]))
    })
}

fn is_nan(p: P) -> bool {
    p.iter().all(|c| c.is_nan())
}

fn is_finite(p: P) -> bool {
    p.iter().all(|c| c.is_finite())
}

/// Whether a distance is not negative; NaN stands for a question without an answer.
fn is_length(length: f64) -> bool {
    length.is_nan() || length >= 0.0
}

fn is_unit(p: P) -> bool {
    (p.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-9
}

/// Whether the corners of a box are in order, where they are numbers.
fn is_box([low, high]: [P; 2]) -> bool {
    low.iter().zip(high).all(|(&l, h)| l <= h || l.is_nan() || h.is_nan())
}

/// The type of which a line begins the implementation: `Net` of `impl<P: Copy> Net<P> {` and of
/// `impl<P> Surface for Net<P> {`.
fn implemented(line: &str) -> Option<&str> {
    let mut rest = line.strip_prefix("impl")?;
    if rest.starts_with('<') {
        let mut depth = 0;
        let end = rest.char_indices().find(|&(_, c)| {
            depth += i32::from(c == '<') - i32::from(c == '>');
            depth == 0
        })?;
        rest = &rest[end.0 + 1..];
    }
    let name = rest.rsplit(" for ").next()?.trim();
    name.split(|c: char| !c.is_alphanumeric() && c != '_').next()
}

/// Every public function of the folders stands in a table: of the splines, where many types have functions of one name,
/// with its type.
#[test]
fn none_is_forgotten() {
    let tables = [curves::NAMES, patches::NAMES, slices::NAMES, surfaces::NAMES].concat();
    let splines = splines::names();
    let folders = [
        "curve",
        "surface",
        "simplex",
        "boxes",
        "revolution",
        "mesh",
        "bernstein",
        "form",
        "convert",
        "bspline",
    ];
    let (mut found, mut of_splines) = (0, 0);
    for (folder, (path, text)) in
        folders.into_iter().flat_map(|f| sources::files(f).into_iter().map(move |file| (f, file)))
    {
        let mut of = None;
        for line in text.lines() {
            if !line.starts_with(' ') && !line.starts_with('}') {
                of = implemented(line).or(of.filter(|_| !line.starts_with("pub fn")));
            }
            let line = line.trim_start();
            let head = ["pub fn ", "pub const fn "].iter().find_map(|start| line.strip_prefix(start));
            let Some(head) = head else { continue };
            let name = head.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
            if name.is_empty() {
                continue; // of a macro, for each of its names
            }
            found += 1;
            if folder == "bspline" {
                of_splines += 1;
                let name = of.map_or(name.to_owned(), |of| format!("{of}::{name}"));
                assert!(splines.contains(&name.as_str()), "{name} of {} is never called", path.display());
            } else {
                assert!(tables.contains(&name), "{name} of {} is never called", path.display());
            }
        }
    }
    assert!(found > 250 && of_splines > 100, "{found} {of_splines}");
}
