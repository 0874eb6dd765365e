//! Functions on an interval as lines, with the curve of a control polygon beside them.

use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};
use svg::Document;
use svg::node::element::{Circle, Group, Line, Rectangle, Title};

use super::curve::curve;
use super::frame::{FAINT, Frame, INK, colour, dashes, extent, hex, mix, rounded, text};
use crate::domain;
use crate::plot::samples::{sampled, strength};
use crate::plot::values::{Functions, pieces};
use crate::plot::{Mark, Scene};

/// The size of the rectangle in which functions are drawn.
const SIZE: [f64; 2] = [560.0, 380.0];

/// How many names of functions stand below each other in the legend.
const ROWS: usize = 18;

/// The name of a domain variable, of an angle its own.
fn name<'f>(family: &'f Family, parameter: &'f Parameter) -> &'f str {
    family.analytic.angle(parameter.var).map_or(parameter.name.as_str(), |angle| angle.name.as_str())
}

/// The picture.
pub(in crate::plot) fn svg(scene: &Scene) -> Result<String, Diagnostic> {
    let family = &scene.family;
    let samples = sampled(scene)?;
    let count = family.functions.len();
    let all = samples.iter().flat_map(|s| s.values.iter().flatten().flatten().copied());
    let [mut low, mut high] = extent(all.chain([0.0]), 0.05);
    if low > -0.06 {
        low = low.min(0.0);
    }
    high = high.max(low + 0.1);
    let x = extent(samples.iter().flat_map(|s| s.at.iter().copied()), 0.0);
    let frame = Frame { place: [64.0, 58.0, SIZE[0], SIZE[1]], x, y: [low, high] };
    let variable = family.domain.first().map_or("t", |p| name(family, p));
    let mut group = Group::new().add(frame.axes(variable));
    for (s, sample) in samples.iter().enumerate() {
        for k in 0..count {
            let points: Vec<[Option<f64>; 2]> =
                sample.at.iter().zip(&sample.values).map(|(t, values)| [Some(*t), values[k]]).collect();
            let own = hex(mix(colour(k, count), [255; 3], strength(s, samples.len())));
            let label = family.function_label(k);
            let setting = &scene.settings[s].label;
            let title = if setting.is_empty() { label } else { format!("{label}, {setting}") };
            let mut path = frame.path(&points, &own, 2.0);
            if let Some(dashes) = dashes(k, count) {
                path = path.set("stroke-dasharray", dashes);
            }
            group = group.add(path.add(Title::new(title)));
        }
    }
    let (legend, mut width) = legend(scene, frame.place[0] + SIZE[0] + 18.0);
    group = group.add(legend);
    let bottom = frame.place[1] + SIZE[1] + 62.0;
    let (notes, mut height) = marks(scene, &frame, bottom);
    group = group.add(notes);
    if !scene.points.is_empty() {
        let (drawn, right) = curve(scene, &samples, width + 30.0, frame.place[1], SIZE[1]);
        group = group.add(drawn);
        width = right;
    }
    height = height.max(bottom);
    Ok(document(scene, width, height, group))
}

/// A whole picture: a white ground, the name and the ranges above.
pub(in crate::plot) fn document(scene: &Scene, width: f64, height: f64, content: Group) -> String {
    let family = &scene.family;
    let title = text(&family.title(), 20.0, 26.0, 17.0, "start", INK).set("font-weight", "bold");
    let mut facts = domain::describe(family);
    if let Some(cut) = &scene.cut {
        facts += &format!(",  cut at {}", cut.label);
    }
    let shown = match scene.settings.as_slice() {
        [only] => only.label.as_str(),
        several => several.first().map_or("", |s| s.common.as_str()),
    };
    if !shown.is_empty() {
        facts += &format!(",  {shown}");
    }
    let facts = pretty(&facts);
    let width = rounded(width.max(40.0 + 8.0 * facts.chars().count() as f64));
    let height = rounded(height);
    let ground = Rectangle::new().set("width", width).set("height", height).set("fill", "#ffffff");
    let document = Document::new()
        .set("viewBox", (0, 0, width, height))
        .set("width", width)
        .set("height", height)
        .add(Title::new(family.title()))
        .add(ground)
        .add(title)
        .add(text(&facts, 20.0, 45.0, 13.0, "start", FAINT))
        .add(content);
    format!("{document}\n")
}

/// Signs and π as they are printed.
pub(in crate::plot) fn pretty(text: &str) -> String {
    let is_sign = |c: char| !c.is_alphanumeric() && c != '_';
    let printed = |part: &str| match part.strip_prefix("pi").filter(|rest| rest.chars().all(is_sign)) {
        Some(rest) => format!("π{rest}"),
        None => String::from(part),
    };
    let text: String = text.split_inclusive(is_sign).map(printed).collect();
    text.replace("<=", "≤").replace(">=", "≥").replace('-', "\u{2212}")
}

/// The names of functions with their colours, and below them the shape values; and where the legend ends.
fn legend(scene: &Scene, left: f64) -> (Group, f64) {
    let family = &scene.family;
    let count = family.functions.len();
    let labels: Vec<String> = (0..count).map(|k| family.function_label(k)).collect();
    let column = 34.0 + 8.2 * labels.iter().map(|l| l.chars().count()).max().unwrap_or(0) as f64;
    let settings: Vec<&str> = if scene.settings.len() > 1 {
        scene.settings.iter().map(|s| s.label.as_str()).collect()
    } else {
        Vec::new()
    };
    let rows = ROWS - settings.len();
    let mut group = Group::new();
    for (k, label) in labels.iter().enumerate() {
        let (x, y) = (left + column * (k / rows) as f64, 70.0 + 20.0 * (k % rows) as f64);
        let mut line = sample_line(x, y, &hex(colour(k, count)));
        if let Some(dashes) = dashes(k, count) {
            line = line.set("stroke-dasharray", dashes);
        }
        group = group.add(line);
        group = group.add(text(label, x + 26.0, y + 4.0, 13.0, "start", INK));
    }
    let top = 70.0 + 20.0 * count.min(rows) as f64 + 12.0;
    let mut right = left + column * count.div_ceil(rows) as f64;
    for (s, label) in settings.iter().enumerate() {
        let y = top + 20.0 * s as f64;
        let grey = hex(mix([40; 3], [255; 3], strength(s, settings.len())));
        group = group.add(sample_line(left, y, &grey));
        group = group.add(text(&pretty(label), left + 26.0, y + 4.0, 13.0, "start", INK));
        right = right.max(left + 34.0 + 8.2 * label.chars().count() as f64);
    }
    (group, right + 6.0)
}

fn sample_line(x: f64, y: f64, colour: &str) -> Line {
    let line = Line::new().set("x1", x).set("x2", x + 20.0).set("y1", y).set("y2", y);
    line.set("stroke", colour.to_string()).set("stroke-width", 3)
}

/// The counterexamples: a point on the function or a line at the place, numbered, with their words below; and where
/// these end.
fn marks(scene: &Scene, frame: &Frame, top: f64) -> (Group, f64) {
    let mut group = Group::new();
    let mut y = top;
    // Several claims may fail at one point.
    let mut rings: Vec<Ring> = Vec::new();
    for (k, mark) in scene.marks.iter().enumerate() {
        let number = (k + 1).to_string();
        let colour = mark.colour();
        if let Some(ring) = ring(scene, mark, frame) {
            match rings.iter_mut().find(|known| known.at == ring.at) {
                Some(known) => known.numbers.push(number.clone()),
                None => rings.push(Ring { numbers: vec![number.clone()], ..ring }),
            }
        }
        for (line, part) in wrapped(&pretty(&mark.failure.text), 92).iter().enumerate() {
            let head = if line == 0 { format!("{number}  ✗ ") } else { String::from("      ") };
            group = group.add(text(&format!("{head}{part}"), 20.0, y, 13.0, "start", colour));
            y += 18.0;
        }
    }
    for Ring { at: [x, at], foot, colour, numbers } in rings {
        if let Some(foot) = foot {
            let line = Line::new().set("x1", x).set("x2", x).set("y1", at).set("y2", foot);
            group = group.add(line.set("stroke", colour).set("stroke-dasharray", "4 3"));
        }
        let ring = Circle::new().set("cx", x).set("cy", at).set("r", 5.5).set("class", "counterexample");
        group = group.add(ring.set("fill", "none").set("stroke", colour).set("stroke-width", 2));
        // Above the frame are the ranges.
        let beside = if foot.is_some() { at + 17.0 } else { at - 7.0 };
        let numbers = numbers.join(", ");
        // Beside the frame is the legend.
        let right = x + 14.0 + 8.2 * numbers.chars().count() as f64;
        let (left, anchor) =
            if right > frame.place[0] + frame.place[2] { (x - 9.0, "end") } else { (x + 9.0, "start") };
        let numbers = text(&numbers, left, beside, 13.0, anchor, colour);
        group = group.add(numbers.set("font-weight", "bold"));
    }
    (group, y)
}

/// Where a counterexample is marked.
struct Ring {
    at: [f64; 2],
    /// Where the line ends on which it stands, if it is about no function.
    foot: Option<f64>,
    colour: &'static str,
    numbers: Vec<String>,
}

/// Where a counterexample is marked, if it has a place.
fn ring(scene: &Scene, mark: &Mark, frame: &Frame) -> Option<Ring> {
    let t = mark.failure.at.first()?.as_ref()?;
    let piece = pieces(&scene.family).into_iter().nth(mark.failure.piece).unwrap_or(&scene.family);
    let functions = Functions::new(piece, &scene.settings[mark.setting].values);
    let value = mark.failure.function.and_then(|f| functions.value(f, core::slice::from_ref(t)));
    let t = functions.axis(t);
    let foot = if value.is_none() { Some(frame.at(t, frame.y[0])[1]) } else { None };
    let at = frame.at(t, value.unwrap_or(frame.y[1])).map(rounded);
    Some(Ring { at, foot, colour: mark.colour(), numbers: Vec::new() })
}

/// A text in lines of limited length, in characters.
pub(in crate::plot) fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].chars().count() + word.chars().count() >= most {
            lines.push(word.to_string());
        } else {
            if !lines[last].is_empty() {
                lines[last].push(' ');
            }
            lines[last] += word;
        }
    }
    lines
}
