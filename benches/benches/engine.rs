//! What a build pays: reading, expanding, proving and generating, and the rejection of hostile specs.
//!
//! The macro runs unoptimised in a `cargo build`; measure that with
//! `cargo bench -p basis-benches --bench engine --profile dev`.

use basis_benches::spec;
use basis_engine::{Disk, Library, Prover, Selected, Source, decide};
use divan::Bencher;

fn main() {
    divan::main();
}

const SPECS: [&str; 4] = ["quadratic.basis", "quartic.basis", "beta_spline.basis", "bspline.basis"];

/// From text to families and claims.
#[divan::bench(args = SPECS)]
fn expand(bencher: Bencher<'_, '_>, name: &str) {
    let source = spec(name);
    bencher.bench_local(|| Library::from_source(&Disk, &Prover, source.clone()).items(Selected::EveryOrder));
}

/// All claims of a spec, from its families to verdicts.
#[divan::bench(args = SPECS)]
fn prove(bencher: Bencher<'_, '_>, name: &str) {
    let library = Library::from_source(&Disk, &Prover, spec(name));
    let items = library.items(Selected::EveryOrder);
    bencher.bench_local(|| items.iter().cloned().map(decide).count());
}

/// From text to verdicts: what the macro does before it emits code.
#[divan::bench(args = SPECS)]
fn expand_and_prove(bencher: Bencher<'_, '_>, name: &str) {
    let source = spec(name);
    bencher.bench_local(|| {
        Library::from_source(&Disk, &Prover, source.clone())
            .items(Selected::EveryOrder)
            .into_iter()
            .map(decide)
            .count()
    });
}

/// The whole shipped library, every order of every family.
#[divan::bench(sample_count = 3)]
fn whole_library() {
    let mut files: Vec<_> = std::fs::read_dir(basis_benches::specs())
        .expect("the specs are there")
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| std::path::Path::new(name).extension().is_some_and(|e| e == "basis"))
        .collect();
    files.sort();
    for name in files {
        let library = Library::from_source(&Disk, &Prover, spec(&name));
        library.items(Selected::EveryOrder).into_iter().map(decide).for_each(drop);
    }
}

/// One inequality for each step of the cascade of `decide`.
#[divan::bench(args = [
    "1 + t >= 0",                                         // coefficients of one sign
    "t^2*(1 - λ)^2*(1 + t) >= 0",                         // zero faces
    "t^2 - t + 1/3 >= 0",                                 // one variable
    "(t - 1/3)^2 >= 0",                                   // an interior zero
    "1 - t*λ + t^2*λ^2 >= 0",                             // subdivision
    "(t - λ)^2 >= 0",                                     // cylindrical decomposition
    "(3*t - 1)^2 + (3*λ - 1)^2 >= 0",                     // an isolated zero
    "t^4 - t^2*λ + 1/4*λ^2 >= 0",                         // a square in disguise
])]
fn inequality(bencher: Bencher<'_, '_>, claim: &str) {
    let text = format!("family F {{ domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = t + λ; prove {claim}; }}");
    let library = Library::from_source(&Disk, &Prover, Source::text("inequality.basis", &text));
    let items = library.items(Selected::EveryOrder);
    bencher.bench_local(|| items.iter().cloned().map(decide).count());
}

/// Specs that ask for too much must be refused soon.
#[divan::bench(args = [
    "(1 + t + λ)^100000",
    "(1 + t + λ + t*λ)^99*(1 + t)^99",
    "2^(10^9)",
    "((1 + t + λ)^20)^10",
    "sum((t + λ)^i for i in 0..=1000)",
], sample_count = 5)]
fn hostile(bencher: Bencher<'_, '_>, formula: &str) {
    let text = format!("family F {{ domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = {formula}; }}");
    bencher.bench_local(|| basis_engine::check(Source::text("hostile.basis", &text)));
}
