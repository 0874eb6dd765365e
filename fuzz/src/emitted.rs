//! Emitted C against the interpreter of steps: a header of each family that has one compiles without a warning, and its program
//! prints what the steps say, bit for bit.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

use basis_engine::algebra::range::Range;
use basis_engine::algebra::rational::ToFloat as _;
use basis_engine::emit::c::{C, Scalar};
use basis_engine::emit::{self, FamilyCode, Job, Wanted};
use basis_engine::plan::Input;
use basis_engine::steps::{Step, Steps};
use basis_engine::{Checked, Disk, Library, Prover, Source, Subject, generate, source};

use super::as_text;

/// The most families of a spec that are compiled: each costs a run of the compiler.
const MAX_FAMILIES: usize = 2;

/// A spec whose families are emitted, compiled and run. The folder of the programs is that of this process.
pub fn emitted(data: &[u8]) {
    let Some(text) = as_text(data) else { return };
    let report = basis_engine::check(Source::text("fuzz.basis", text));
    if !report.diagnostics.is_empty() {
        return;
    }
    let families = report.items.into_iter().filter(|item| matches!(item.subject, Subject::Family(_)));
    for checked in families.take(MAX_FAMILIES) {
        one(checked);
    }
}

/// A library family by name, for tests of this target itself.
pub fn of_library(file: &str) {
    let read = source::library(&Disk, file).expect("a file of the library");
    let library = Library::from_source(&Disk, &Prover, read);
    for item in library.items(basis_engine::Selected::EveryOrder) {
        one(basis_engine::decide(item));
    }
}

fn one(checked: Checked) {
    let wanted = Wanted { checked, name: Some(String::from("Tried")) };
    let Subject::Family(told) = &wanted.checked.subject else { return };
    let Ok(family) = generate::evaluated(told, &wanted.checked.claims) else { return };
    let language = C(Scalar::F64);
    let Ok(code) = FamilyCode::new(told, &family, &wanted, &language) else { return };
    if code.steps.spans() > 1 || code.steps.derived().is_some() {
        return; // sines are rounded by every library in its own way; spans are places, and not floats alone
    }
    let job = Job { items: std::slice::from_ref(&wanted), spec: "fuzz.basis", command: "basis emit" };
    let Ok(header) = emit::emit(&language, &job) else { return };
    let shapes: Vec<f64> = family.shapes.iter().map(|p| inside(&p.range, 0.375)).collect();
    let places = places(&code);
    let values = code.steps.values();
    if values.steps.iter().any(|step| matches!(step, Step::Call(..))) {
        return;
    }
    let folder = folder();
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file can be written");
    write("tried.h", &header);
    write("main.c", &program(&code, &shapes, &places));
    let mut compiler = Command::new("cc");
    compiler.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O0", "-ffp-contract=off"]);
    let said = compiler.args(["main.c", "-o", "main", "-lm"]).current_dir(&folder).output();
    let said = said.expect("a C compiler");
    assert!(said.status.success(), "{}\n{header}", String::from_utf8_lossy(&said.stderr));
    let run = Command::new(folder.join("main")).output().expect("the program starts");
    if run.status.code() == Some(1) {
        return; // the shape values are not as is assumed, all together
    }
    let printed = String::from_utf8_lossy(&run.stdout);
    let expected: String = places.iter().map(|at| expected(&values, &shapes, at)).collect();
    assert!(run.status.success() && printed == expected, "{printed}\nis not\n{expected}\n{header}");
}

/// A folder for the programs of this process.
fn folder() -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let make = || {
        let folder = std::env::temp_dir().join(format!("basis-fuzz-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder can be made");
        folder
    };
    FOLDER.get_or_init(make).clone()
}

/// A number inside of a range: a part of the way between its ends.
fn inside(range: &Range, part: f64) -> f64 {
    let end = |end: Option<&basis_engine::algebra::rational::Rational>| end.map(|x| x.to_f64());
    match (end(range.low.value()), end(range.high.value())) {
        (Some(low), Some(high)) => low + (high - low) * part,
        (Some(low), None) => low + 1.0 + part,
        (None, Some(high)) => high - 1.0 - part,
        (None, None) => part,
    }
}

/// Points of the domain: a few on the way from one corner to another one.
fn places(code: &FamilyCode<'_>) -> Vec<Vec<f64>> {
    let family = code.family;
    let axis =
        |k: usize, part: f64| inside(&family.domain[k].range, if k % 2 == 0 { part } else { 1.0 - part });
    let parts = [0.0625, 0.25, 0.398_437_5, 0.5, 0.9375];
    let mut all: Vec<Vec<f64>> = Vec::new();
    for part in parts {
        let count = code.coordinates.len();
        if family.simplices.is_empty() {
            all.push((0..count).map(|k| axis(k, part)).collect());
        } else if family.is_simplex() {
            let mut at = vec![(1.0 - part) / (count - 1) as f64; count];
            at[0] = part;
            all.push(at);
        }
    }
    all
}

/// What the steps make of a point, as the program prints it; zeros have no sign.
fn expected(values: &Steps, shapes: &[f64], at: &[f64]) -> String {
    let input = |input: Input| match input {
        Input::Shape(k) => shapes[k],
        Input::Coordinate(k) => at[k],
        other => panic!("{other:?}"),
    };
    let found = values.evaluate::<f64>(input).expect("floats divide");
    found.iter().fold(String::new(), |mut text, x| {
        // Of what is no number the bits differ from one machine to another one.
        let bits = if x.is_nan() { 1 } else { (x + 0.0).to_bits() };
        let _ = writeln!(text, "{bits:016x}");
        text
    })
}

fn program(code: &FamilyCode<'_>, shapes: &[f64], places: &[Vec<f64>]) -> String {
    let name = code.name.as_str();
    let listed = |numbers: &[f64]| numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", ");
    let mut text = String::from(
        "#include \"tried.h\"\n#include <stdio.h>\n#include <string.h>\n\
         static void show(double x) { unsigned long long bits = 1; x += 0.0; if (x == x) memcpy(&bits, &x, 8); printf(\"%016llx\\n\", bits); }\n\
         int main(void) {\n",
    );
    let mut family = "";
    if !shapes.is_empty() {
        let _ = writeln!(text, "{name} family; if ({name}_init(&family, {}) != 0) return 1;", listed(shapes));
        family = "family, ";
    }
    let count = code.labels.len();
    let _ = writeln!(text, "double values[{count}];");
    for at in places {
        let _ = writeln!(text, "{name}_values({family}{}, values);", listed(at));
        let _ = writeln!(text, "for (int i = 0; i < {count}; i++) show(values[i]);");
    }
    text + "return 0; }\n"
}

#[cfg(test)]
mod tests {
    #[test]
    fn families_of_the_library_are_compiled_and_agree() {
        for file in ["quartic", "quadratic", "ball"] {
            super::of_library(file);
        }
    }
}
