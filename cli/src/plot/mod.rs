//! `basis plot`: pictures of basis functions, of curves over them, and of counterexamples.
//!
//! Values of quotients of polynomials are computed exactly and rounded once, to the place of a point in the picture; those
//! of sines and exponentials in floating point.

mod cut;
mod failures;
mod marks;
mod page;
mod pictures;
#[cfg(feature = "png")]
mod raster;
mod samples;
mod settings;
mod values;

use std::fs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use basis_engine::ascii::ascii;
use basis_engine::{Checked, Diagnostic, Disk, Family, Library, Prover, Sources, decide};

use crate::args::PlotArguments;
use crate::output::{self, Status, complain, error};
use crate::spec::STDIN;
use crate::{eval, spec};
use cut::Cut;
use failures::Failure;
use marks::Mark;
use pictures::{lines, maps};
use settings::Setting;

/// What is drawn.
struct Scene {
    family: Rc<Family>,
    /// Where a family of three variables is cut; of it the family above is what is left.
    cut: Option<Cut>,
    /// The shape values.
    settings: Vec<Setting>,
    /// The places of a control polygon; none where no curve is drawn.
    points: Vec<[f64; 2]>,
    /// Where claims fail.
    failures: Vec<Failure>,
    /// Those at the shape values that are drawn.
    marks: Vec<Mark>,
}

/// How a picture is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Svg,
    Png,
    Html,
}

/// Draws the family that the arguments name.
pub(crate) fn run(arguments: &PlotArguments) -> Status {
    let library = match spec::read(&arguments.file) {
        Ok(source) => Library::from_source(&Disk, &Prover, source),
        Err(error) => return refuse(&Sources::default(), &[error]),
    };
    let drawn = scene(arguments, &library).and_then(|scene| {
        let path = arguments.output.clone().unwrap_or_else(|| file_name(&scene.family));
        let kind = kind(&path).map_err(|e| vec![e])?;
        let picture = draw(&scene, kind).map_err(|e| vec![e])?;
        Ok((path, picture))
    });
    let (path, picture) = match drawn {
        Ok(drawn) => drawn,
        Err(errors) => return refuse(library.sources(), &errors),
    };
    if path == Path::new(STDIN) {
        return output::print(&String::from_utf8_lossy(&picture));
    }
    match fs::write(&path, picture) {
        Ok(()) => output::print(&format!("wrote {}\n", path.display())),
        Err(e) => {
            let error = error(format!("cannot write `{}`: {e}", path.display()));
            refuse(&Sources::default(), &[error.help("name another file with `-o FILE`")])
        }
    }
}

fn refuse(sources: &Sources, errors: &[Diagnostic]) -> Status {
    for error in errors {
        complain(&(error.render(sources, true) + "\n\n"));
    }
    Status::Unusable
}

/// `QuarticBernstein.svg`, `Bernstein-3.svg`.
fn file_name(family: &Family) -> PathBuf {
    let mut name = ascii(&family.name);
    for (_, value) in &family.order {
        name += &format!("-{value}");
    }
    PathBuf::from(name + ".svg")
}

/// How a picture is written follows from the name of its file; standard output gets SVG.
fn kind(path: &Path) -> Result<Kind, Diagnostic> {
    if path == Path::new(STDIN) {
        return Ok(Kind::Svg);
    }
    match path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase).as_deref() {
        Some("svg") => Ok(Kind::Svg),
        Some("png") => Ok(Kind::Png),
        Some("html" | "htm") => Ok(Kind::Html),
        _ => {
            let message = format!("`{}` does not say what kind of picture it is", path.display());
            Err(error(message).help("the name ends with `.svg`, `.png` or `.html`"))
        }
    }
}

fn scene(arguments: &PlotArguments, library: &Library<'_>) -> Result<Scene, Vec<Diagnostic>> {
    let family = match &arguments.family {
        Some(name) => eval::find_family(library, name)?,
        None => eval::only_family(library)?,
    };
    if family.domain.len() > 1 && (!family.analytic.is_empty() || !family.pieces.is_empty()) {
        let message = format!("`{}` has angles in several variables and no picture", family.title());
        return Err(vec![error(message).help("draw a family of one variable")]);
    }
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    let checked = library.item(&family.name, &order).ok().map(decide);
    let mut failures =
        checked.as_ref().map_or_else(Vec::new, |checked: &Checked| failures::failures(&family, checked));
    let shown = |failures: &[Failure]| failures.iter().find(|f| f.is_shown()).cloned();
    let (mut family, mut cut) = (family, None);
    if family.domain.len() > 2 {
        let place =
            cut::place(&family, arguments.at.as_ref(), shown(&failures).as_ref()).map_err(|e| vec![e])?;
        failures = cut::failures(failures, &place);
        family = Rc::new(cut::family(&family, &place).map_err(|e| vec![e])?);
        cut = Some(place);
    } else if arguments.at.is_some() {
        let message = format!("the functions of `{}` are drawn whole", family.title());
        return Err(vec![error(message).help("leave `--at` out; it cuts functions of three variables")]);
    }
    let variables = family.domain.len();
    let settings = settings::settings(&family, &arguments.shapes, shown(&failures).as_ref())?;
    if settings.len() > 1 && variables > 1 {
        let message = "a range of shape values is drawn for functions of one variable only";
        return Err(vec![error(message).help("give one value: `--shape λ=1/2`")]);
    }
    let points = arguments.points.clone();
    if !points.is_empty() && variables > 1 {
        return Err(vec![error("a control polygon belongs to a curve, and this family has two variables")]);
    }
    if !points.is_empty() && points.len() != family.functions.len() {
        let (given, wanted) = (points.len(), family.functions.len());
        let message = format!(
            "`{}` has {wanted} functions and needs as many control points, not {given}",
            family.title()
        );
        let example: Vec<String> = (0..wanted).map(|k| format!("{k},{}", k % 2)).collect();
        return Err(vec![error(message).help(format!("for example `--points \"{}\"`", example.join(" ")))]);
    }
    let marks = marks::at(&failures, &settings);
    Ok(Scene { family, cut, settings, points, failures, marks })
}

fn draw(scene: &Scene, kind: Kind) -> Result<Vec<u8>, Diagnostic> {
    match kind {
        Kind::Html => page::page(scene).map(String::into_bytes),
        Kind::Svg => svg(scene).map(String::into_bytes),
        #[cfg(feature = "png")]
        Kind::Png => raster::png(&svg(scene)?),
        #[cfg(not(feature = "png"))]
        Kind::Png => Err(error("this command was built without the feature `png`").help("write an `.svg`")),
    }
}

fn svg(scene: &Scene) -> Result<String, Diagnostic> {
    if scene.family.domain.len() == 1 { lines::svg(scene) } else { maps::svg(scene) }
}
