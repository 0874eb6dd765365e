//! Control points as they are typed, or from a file.

use std::fs;
use std::path::Path;

use basis_engine::algebra::rational::{self, Rational};
use basis_engine::{Diagnostic, Family};

use crate::name;
use crate::output::error;

/// A longer file than this holds no control points.
const MAX_BYTES: u64 = 16 << 20;

/// The control points in a text such as `0,0 1,2 3,2 4,0`, or in the file of that name: a point a line, its coordinates
/// with commas or spaces between them.
///
/// # Errors
/// What is no point, coordinates or points that are too few or too many, a file that cannot be read.
pub(super) fn points(text: &str, family: &Family) -> Result<Vec<Vec<Rational>>, Diagnostic> {
    let path = Path::new(text);
    let points = if path.is_file() { from_file(path)? } else { from_text(text)? };
    if let (Some(first), Some((k, other))) = (
        points.first(),
        points.iter().enumerate().find(|(_, p)| Some(p.len()) != points.first().map(Vec::len)),
    ) {
        let message = format!(
            "the control point {} has {}, the first one has {}",
            k + 1,
            name::count(other.len(), "coordinate"),
            first.len()
        );
        return Err(error(message).help("give all points the same number of coordinates"));
    }
    if points.len() != family.functions.len() {
        let message = format!(
            "{} given, `{}` has {}",
            control_points_are(points.len()),
            family.title(),
            name::count(family.functions.len(), "function")
        );
        return Err(
            error(message).help("give one control point for each function, in the order of the functions")
        );
    }
    Ok(points)
}

fn control_points_are(count: usize) -> String {
    format!("{} {}", name::count(count, "control point"), if count == 1 { "is" } else { "are" })
}

fn from_text(text: &str) -> Result<Vec<Vec<Rational>>, Diagnostic> {
    let points = text
        .split(|c: char| c.is_whitespace() || c == ';')
        .filter(|point| !point.is_empty())
        .map(|point| coordinates(point.split(','), point));
    let points: Vec<Vec<Rational>> = points.collect::<Result<_, _>>()?;
    if points.is_empty() { Err(malformed(text)) } else { Ok(points) }
}

fn from_file(path: &Path) -> Result<Vec<Vec<Rational>>, Diagnostic> {
    let shown = path.display();
    let refuse = |why: String| error(format!("cannot read control points from `{shown}`: {why}"));
    let long = fs::metadata(path).is_ok_and(|data| data.len() > MAX_BYTES);
    if long {
        return Err(refuse(String::from("it is longer than 16 MiB")));
    }
    let text = fs::read_to_string(path).map_err(|e| refuse(e.to_string()))?;
    let mut points = Vec::new();
    for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let separators = |c: char| c == ',' || c == ';' || c.is_whitespace();
        let fields: Vec<&str> = line.split(separators).filter(|field| !field.is_empty()).collect();
        match coordinates(fields.iter().copied(), line) {
            Ok(point) => points.push(point),
            // The first line may say what the columns are.
            Err(_) if number == 0 && fields.iter().all(|f| f.starts_with(char::is_alphabetic)) => {}
            Err(problem) => return Err(problem.note(format!("line {} of `{shown}`", number + 1))),
        }
    }
    if points.is_empty() { Err(refuse(String::from("it has no points"))) } else { Ok(points) }
}

fn coordinates<'t>(fields: impl Iterator<Item = &'t str>, whole: &str) -> Result<Vec<Rational>, Diagnostic> {
    let point: Option<Vec<Rational>> = fields.map(|field| rational::parse(field.trim())).collect();
    point.ok_or_else(|| malformed(whole))
}

fn malformed(text: &str) -> Diagnostic {
    // Letters and a dot are the name of a file; numbers have no letters.
    if Path::new(text).extension().is_some_and(|e| e.to_string_lossy().starts_with(char::is_alphabetic)) {
        let help = "a file has one point a line; points are also typed, \"0,0 1,2 3,2 4,0\"";
        return error(format!("there is no file `{text}`")).help(help);
    }
    let help = "write exact numbers with commas, and spaces between points: \"0,0 1,2 3,2 4,0\"; or name a file with one point a line";
    error(format!("`{text}` is not a control point")).help(help)
}
