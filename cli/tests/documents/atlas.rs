//! The library: `specs/README.md` lists every family with its source and verdicts, and every published claim that is
//! false with its counterexample; the README has a line for each folder.
//!
//! `BASIS_TESTS=overwrite cargo test -p basis-cli --test documents atlas` writes the tables of today; read the
//! difference before you keep it.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use serde_json::Value;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The folders of the library in the order of the tables, and what is in them.
const FOLDERS: [(&str, &str); 11] = [
    (
        ".",
        "the textbook: Bernstein, Ball, Hermite, Lagrange, B-splines, cardinal splines, triangles, first shape parameters",
    ),
    (
        "curves",
        "polynomial curve bases with shape parameters, q-analogues, urn models, exponents, more of Ball's kind",
    ),
    ("splines", "B-splines over their support, and segments with tension, uneven knots or shape parameters"),
    (
        "trigonometric",
        "angles and exponentials: shape parameters, C- and H-Bézier, tension, kernels of Fourier series, windows",
    ),
    (
        "rational",
        "conics, circles, weights, tension, interpolation without poles, operators on the half line",
    ),
    ("triangles", "patches and finite elements on triangles, tetrahedra and prisms"),
    ("elements", "finite elements on intervals, squares and cubes"),
    ("polynomials", "orthogonal polynomials, and the sequences of algebra and combinatorics"),
    ("kernels", "compact kernels of statistics, particles and data assimilation; wavelets"),
    ("joins", "blends between given values or pieces"),
    ("papers", "every claim of five papers; in [a table of its own](papers/README.md)"),
];

/// One family, all its orders together.
struct Family {
    /// `SaidBallOdd`.
    name: String,
    /// The cells of `basis table`, up to the column of joints.
    cells: Vec<String>,
    source: String,
    proved: usize,
    refuted: usize,
    open: usize,
    /// Identifiers of published statements that are false.
    wrong: Vec<String>,
}

/// A published statement that is false.
struct Wrong {
    id: String,
    statement: String,
    counterexample: String,
    corrected: String,
}

/// What the command says about the library, read once.
struct Atlas {
    /// Families by the name of their file.
    files: BTreeMap<String, Vec<Family>>,
    wrong: Vec<(String, Wrong)>,
}

fn atlas() -> &'static Atlas {
    static ATLAS: LazyLock<Atlas> = LazyLock::new(read);
    &ATLAS
}

fn basis(arguments: &[&str]) -> Vec<u8> {
    let run = Command::new(env!("CARGO_BIN_EXE_basis"))
        .current_dir(Path::new(ROOT).join("specs"))
        .args(arguments)
        .output()
        .expect("the command runs");
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
    run.stdout
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

fn folder(file: &str) -> &str {
    file.split_once('/').map_or(".", |(folder, _)| folder)
}

fn read() -> Atlas {
    let report: Value =
        serde_json::from_slice(&basis(&["check", "--format", "json", "."])).expect("it is JSON");
    let published = report["published"].as_array().expect("there are statements");
    let false_ones: Vec<&Value> = published.iter().filter(|p| text(&p["verdict"]) == "refuted").collect();
    let mut atlas = Atlas { files: BTreeMap::new(), wrong: Vec::new() };
    for file in report["files"].as_array().expect("there are files") {
        let name = text(&file["path"]).trim_start_matches("./").replace('\\', "/");
        let source =
            std::fs::read_to_string(Path::new(ROOT).join("specs").join(&name)).expect("it can be read");
        let spec = Spec::new(&source);
        let items = file["items"].as_array().expect("there are items");
        let mut families: Vec<Family> = Vec::new();
        for row in String::from_utf8(basis(&["table", &name])).expect("UTF-8").lines().skip(2) {
            let cells: Vec<String> =
                row.trim_matches('|').split(" | ").map(|c| c.trim().to_string()).collect();
            let family = cells[0].trim_start_matches('[').split(']').next().unwrap_or_default().to_string();
            let mut counted = [0; 3];
            let claims = items
                .iter()
                .filter(|item| text(&item["kind"]) == "family" && text(&item["name"]) == family)
                .flat_map(|item| item["claims"].as_array().expect("there are claims"));
            for claim in claims {
                match text(&claim["verdict"]) {
                    "proved" => counted[0] += 1,
                    "refuted" => counted[1] += 1,
                    _ => counted[2] += 1,
                }
            }
            families.push(Family {
                source: spec.source(&family),
                cells: cells.into_iter().take(7).collect(),
                name: family,
                proved: counted[0],
                refuted: counted[1],
                open: counted[2],
                wrong: Vec::new(),
            });
        }
        for statement in &false_ones {
            let id = text(&statement["id"]);
            let lines = spec.statement(id);
            let Some(&line) = lines.first() else { continue };
            let refuted = lines.iter().rev().find_map(|line| {
                let about = spec.about(*line);
                items
                    .iter()
                    .flat_map(|item| item["claims"].as_array().expect("there are claims"))
                    .filter(|claim| text(&claim["verdict"]) == "refuted" && claim["witness"].is_object())
                    .find(|claim| claim["line"].as_u64().is_some_and(|line| about.contains(&line)))
            });
            let wrong = Wrong {
                id: id.to_string(),
                statement: text(&statement["statement"]).to_string(),
                counterexample: refuted.map(counterexample).unwrap_or_default(),
                corrected: text(&statement["corrected"]["statement"]).to_string(),
            };
            let around = spec.family(line);
            if let Some(family) = families.iter_mut().find(|f| Some(f.name.as_str()) == around) {
                family.wrong.push(id.to_string());
            }
            atlas.wrong.push((name.clone(), wrong));
        }
        atlas.files.insert(name, families);
    }
    atlas
}

/// More numbers than this of one counterexample are left to the command: those of surfaces have dozens.
const LONG: usize = 12;

/// The point and the value there, `b[1] = 0 at λ = -2`.
fn counterexample(claim: &Value) -> String {
    let witness = &claim["witness"];
    let Some(at) = witness["at"].as_object() else { return String::new() };
    let (of, value) = (text(&witness["of"]), text(&witness["value"]));
    let mut at: Vec<String> = at.iter().map(|(name, value)| format!("{name} = {}", text(value))).collect();
    if at.len() > LONG {
        at.truncate(LONG);
        at.push(String::from("…"));
    }
    let at =
        if at.is_empty() || of.contains(" at ") { String::new() } else { format!(" at {}", at.join(", ")) };
    if of.is_empty() {
        format!("`{}` is false{at}", text(&claim["claim"]))
    } else {
        format!("`{of}` = {value}{at}")
    }
}

/// The text of a spec by lines, for what only its comments say.
struct Spec<'a>(Vec<&'a str>);

impl<'a> Spec<'a> {
    fn new(text: &'a str) -> Self {
        Self(text.lines().collect())
    }

    /// The lines, counted from 1, of the comments that begin with this identifier.
    fn statement(&self, id: &str) -> Vec<usize> {
        let id = format!("/// {id}:");
        (1..=self.0.len()).filter(|line| self.0[line - 1].trim_start().starts_with(&id)).collect()
    }

    /// The lines of what a comment stands above: of one claim, or of a whole family, theorem or join.
    fn about(&self, comment: usize) -> RangeInclusive<u64> {
        let rest = self.0[comment..].iter();
        let first = comment + 1 + rest.take_while(|line| line.trim_start().starts_with("///")).count();
        let of_one_claim = self.0[first - 1].starts_with(' ');
        let length = self.0[first - 1..].iter().take_while(|line| **line != "}").count();
        first as u64..=(first + if of_one_claim { 0 } else { length }) as u64
    }

    /// The family that begins in the last line at or before this one that begins a family.
    fn family(&self, line: usize) -> Option<&'a str> {
        self.0[..line].iter().rev().find_map(|l| l.strip_prefix("family ")).map(name)
    }

    /// The paragraphs with a year or a title of the family's comment; without any, of the file's.
    fn source(&self, family: &str) -> String {
        let begins = |line: &&str| line.strip_prefix("family ").is_some_and(|rest| name(rest) == family);
        let at = self.0.iter().position(begins).expect("a family of this file");
        let comment = |prefix: &str, lines: &[&str]| -> Vec<String> {
            let lines: Vec<&str> =
                lines.iter().map_while(|line| line.strip_prefix(prefix)).map(str::trim).collect();
            let paragraphs = lines.split(|line| line.is_empty()).map(|lines| lines.join(" "));
            paragraphs.filter(|paragraph| is_source(paragraph)).collect()
        };
        let above =
            self.0[..at].iter().rposition(|line| !line.starts_with("///")).map_or(0, |before| before + 1);
        let own = comment("///", &self.0[above..at]);
        if own.is_empty() { comment("//!", &self.0).join(" ") } else { own.join(" ") }
    }
}

/// The name at the beginning of what follows `family `.
fn name(rest: &str) -> &str {
    rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default()
}

/// Whether there is a year in which families were published, or a title in quotation marks.
fn is_source(paragraph: &str) -> bool {
    let mut numbers = paragraph.split(|c: char| !c.is_ascii_digit()).filter(|digits| digits.len() == 4);
    paragraph.contains('"') || numbers.any(|year| ("1600".."2100").contains(&year))
}

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// All tables of `specs/README.md`.
fn tables() -> String {
    let atlas = atlas();
    let mut page = String::new();
    let mut put =
        |line: std::fmt::Arguments<'_>| writeln!(page, "{line}").expect("a string takes everything");
    put(format_args!("\n## Families\n"));
    put(format_args!(
        "✓ is proved, ✗ refuted; after \"except\" stand the shape values at which the functions are dependent. The claims are counted \
         over\nall orders; \"open\" are conjectures. \"False\" are published or customary claims, which the table below shows.\n"
    ));
    for (name, about) in FOLDERS.iter().filter(|(name, _)| *name != "papers") {
        let title = if *name == "." { "This folder".to_string() } else { format!("`{name}`") };
        put(format_args!("### {title}: {about}\n"));
        put(format_args!(
            "| family | source | domain, shape parameters | sum 1 | ≥ 0 | symmetric | independent | joins | claims | false |"
        ));
        put(format_args!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"));
        for family in
            atlas.files.iter().filter(|(file, _)| folder(file) == *name).flat_map(|(_, families)| families)
        {
            let [link, properties @ ..] = family.cells.as_slice() else { unreachable!("seven cells") };
            let mut claims = format!("{} proved", family.proved);
            for (count, verdict) in [(family.refuted, "refuted"), (family.open, "open")] {
                if count > 0 {
                    write!(claims, ", {count} {verdict}").expect("a string takes everything");
                }
            }
            put(format_args!(
                "| {link} | {} | {} | {claims} | {} |",
                cell(&family.source),
                properties.join(" | "),
                family.wrong.join(", ")
            ));
        }
        put(format_args!(""));
    }
    put(format_args!("## Six of them\n"));
    for (file, family, shape) in PICTURES {
        let shape = shape.iter().map(|value| format!("`{value}`")).collect::<Vec<_>>().join(", ");
        let with = if shape.is_empty() { String::new() } else { format!(", {shape}") };
        put(format_args!("![{family} of {file}]({})\n\n{family} of `{file}`{with}\n", picture(family)));
    }
    put(format_args!("## What the literature has wrong\n"));
    put(format_args!(
        "Published or customary claims, as recalled here, that are false as they stand, each with an exact counterexample and with what\n\
         is true instead. Nearly all are a condition that was left out or a sign; none is a verdict on people, and the sources may well\n\
         say it better in a place that was not looked up. The identifiers stand beside the claims in the specs.\n"
    ));
    put(format_args!(
        "| claim | as stated | counterexample | what is true | spec |\n| --- | --- | --- | --- | --- |"
    ));
    for (file, wrong) in &atlas.wrong {
        put(format_args!(
            "| {} | {} | {} | {} | [{file}]({file}) |",
            wrong.id,
            cell(&wrong.statement),
            cell(&wrong.counterexample),
            cell(&wrong.corrected)
        ));
    }
    page
}

/// Pictures of families beyond polynomials: the file, the family, and its shape values.
const PICTURES: [(&str, &str, &[&str]); 6] = [
    ("rational/bezier", "Conic", &["ω=1/4..4"]),
    ("rational/tension", "RationalTension", &["r=0..12"]),
    ("trigonometric/shape", "QuadraticTwoParameters", &["m=-1..1", "n=0"]),
    ("trigonometric/end_angle", "CBezierQuadratic", &["tan(α/2)=2"]),
    ("splines/kernels", "Keys", &["a=-3..0"]),
    ("kernels/wavelets", "ChuiWang", &[]),
];

/// The name of the file of a picture, as seen from the library.
fn picture(family: &str) -> String {
    format!("pictures/{}.svg", family.to_lowercase())
}

#[test]
fn the_pictures_are_current() {
    for (file, family, shape) in PICTURES {
        let name = format!("{file}.basis");
        let mut arguments = vec!["plot", &name, family, "-o", "-"];
        for value in shape {
            arguments.extend(["--shape", value]);
        }
        let drawn = String::from_utf8(basis(&arguments)).expect("UTF-8");
        let path = Path::new(ROOT).join("specs").join(picture(family));
        if std::env::var_os("BASIS_TESTS").is_some_and(|mode| mode == "overwrite") {
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("it can be made");
            std::fs::write(&path, &drawn).expect("the picture can be written");
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            kept == drawn,
            "{family} is drawn otherwise: BASIS_TESTS=overwrite cargo test -p basis-cli --test documents atlas"
        );
    }
}

/// Compares what stands in a file after a line, up to another line, with what is current; or writes it.
fn current(file: &str, start: &str, end: &str, table: &str) {
    let path: PathBuf = Path::new(ROOT).join(file);
    let written = std::fs::read_to_string(&path).expect("the file can be read");
    let (before, rest) = written.split_once(start).expect("the file has the first mark");
    let (shown, after) = rest.split_once(end).expect("the file has the last mark");
    if std::env::var_os("BASIS_TESTS").is_some_and(|mode| mode == "overwrite") {
        std::fs::write(&path, format!("{before}{start}{table}{end}{after}"))
            .expect("the file can be written");
    } else {
        assert!(
            shown == table,
            "{file} is old: BASIS_TESTS=overwrite cargo test -p basis-cli --test documents atlas"
        );
    }
}

#[test]
fn the_tables_of_the_library_are_current() {
    current("specs/README.md", "<!-- tables of the library -->\n", "<!-- end of the tables -->", &tables());
}

#[test]
fn the_readme_has_a_line_for_each_folder() {
    let mut table = String::from("| folder | families | what they are |\n| --- | --- | --- |\n");
    for (name, about) in FOLDERS {
        let files = atlas().files.iter().filter(|(file, _)| folder(file) == name);
        let count: usize = files.map(|(_, families)| families.len()).sum();
        let path = if name == "." { String::from("specs") } else { format!("specs/{name}") };
        let about = about.replace("(papers/README.md)", "(specs/papers/README.md)");
        writeln!(table, "| [`{path}`]({path}) | {count} | {about} |").expect("a string takes everything");
    }
    current("README.md", "<!-- folders of the library -->\n", "<!-- end of the folders -->", &table);
}

#[test]
fn every_folder_is_described() {
    for file in atlas().files.keys() {
        assert!(
            FOLDERS.iter().any(|(name, _)| *name == folder(file)),
            "the folder of {file} has no description"
        );
    }
    for (name, _) in FOLDERS {
        assert!(atlas().files.keys().any(|file| folder(file) == name), "there is no folder {name}");
    }
}

#[test]
fn every_family_has_a_source() {
    for (file, families) in atlas().files.iter().filter(|(file, _)| folder(file) != "papers") {
        for family in families {
            assert!(!family.source.is_empty(), "{file}: {} has no source", family.name);
        }
    }
}

#[test]
fn what_is_false_has_a_counterexample_and_a_correction() {
    let wrong = &atlas().wrong;
    assert!(wrong.len() >= 10);
    for (file, wrong) in wrong {
        assert!(!wrong.corrected.is_empty(), "{file}: {} has no correction", wrong.id);
        assert!(!wrong.counterexample.is_empty(), "{file}: {} has no counterexample", wrong.id);
    }
}
