//! Plane curves with their control polygons, as SVG.

use basis_runtime::{Basis, Curve};
use svg::node::element::path::Data;
use svg::node::element::{Circle, Group, Line, Path, Rectangle, Text, Title};

/// The width of the drawing, without the text below.
const WIDTH: f64 = 840.0;
const MARGIN: f64 = 40.0;
const COLOURS: [&str; 6] = ["#2f6db3", "#c2571a", "#2c8a4b", "#9b3a86", "#5b52b5", "#8a7a12"];

/// Curves in one picture.
#[derive(Default)]
pub(crate) struct Plot {
    curves: Vec<Shown>,
    polygons: Vec<Vec<[f64; 2]>>,
    axis: Option<Axis>,
}

struct Shown {
    points: Vec<[f64; 2]>,
    label: String,
}

/// An axis of revolution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axis {
    X,
    Y,
}

impl Plot {
    /// A curve; curves with one label have one colour and one entry in the legend.
    pub(crate) fn curve<B: Basis<Scalar = f64>>(&mut self, curve: &Curve<B, [f64; 2]>, label: &str) {
        self.curves.push(Shown { points: curve.samples(200).collect(), label: label.to_owned() });
    }

    /// A control polygon with its points.
    pub(crate) fn polygon(&mut self, points: &[[f64; 2]]) {
        self.polygons.push(points.to_vec());
    }

    /// The axis about which the curves turn, as a dash-dotted line.
    pub(crate) fn axis(&mut self, axis: Axis) {
        self.axis = Some(axis);
    }

    /// The picture, with its title and a caption below.
    pub(crate) fn svg(&self, title: &str, caption: &str) -> String {
        let frame = Frame::new(self);
        let lines = wrap(caption, 112);
        let mut labels: Vec<&str> = Vec::new();
        for shown in &self.curves {
            if !labels.contains(&shown.label.as_str()) {
                labels.push(&shown.label);
            }
        }
        let (entries, legend) = legend(&labels);
        let below = frame.height + legend;
        let height = below + 34.0 + 20.0 * lines.len() as f64;
        let mut document = svg::Document::new()
            .set("viewBox", (0.0, 0.0, WIDTH, rounded(height)))
            .set("width", WIDTH)
            .set("height", rounded(height))
            .set("font-family", "system-ui, sans-serif")
            .add(Title::new(title))
            .add(Rectangle::new().set("width", "100%").set("height", "100%").set("fill", "white"));
        if let Some(axis) = self.axis {
            document = document.add(frame.axis(axis));
        }
        for polygon in &self.polygons {
            document = document.add(polygon_group(&frame, polygon));
        }
        for shown in &self.curves {
            let index = labels.iter().position(|label| *label == shown.label).unwrap_or_default();
            document = document.add(
                path(&frame, &shown.points)
                    .set("stroke", COLOURS[index % COLOURS.len()])
                    .set("stroke-width", 2.6),
            );
        }
        for ((x, row), (k, label)) in entries.into_iter().zip(labels.iter().enumerate()) {
            let y = frame.height + 12.0 + 22.0 * row;
            let line = Line::new()
                .set("x1", x)
                .set("x2", x + 30.0)
                .set("y1", rounded(y))
                .set("y2", rounded(y))
                .set("stroke", COLOURS[k % COLOURS.len()])
                .set("stroke-width", 2.6);
            document = document.add(line).add(text(label, x + 38.0, y + 4.5, 14));
        }
        document = document.add(text(title, 14.0, below + 18.0, 15).set("font-weight", "bold"));
        for (k, line) in lines.iter().enumerate() {
            document = document.add(text(line, 14.0, below + 39.0 + 20.0 * k as f64, 14));
        }
        document.to_string()
    }

    fn points(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.curves.iter().flat_map(|c| &c.points).chain(self.polygons.iter().flatten()).copied()
    }
}

/// Where the entries of the legend begin and in which row, and the height of all rows.
fn legend(labels: &[&str]) -> (Vec<(f64, f64)>, f64) {
    let (mut x, mut row) = (14.0, 0.0);
    let mut entries = Vec::with_capacity(labels.len());
    for label in labels {
        // Wide enough for the letters, which have about this width.
        let width = 60.0 + 9.0 * label.chars().count() as f64;
        if x + width > WIDTH {
            (x, row) = (14.0, row + 1.0);
        }
        entries.push((x, row));
        x += width;
    }
    let rows = if labels.is_empty() { 0.0 } else { row + 1.0 };
    (entries, 6.0 + 22.0 * rows)
}

fn polygon_group(frame: &Frame, polygon: &[[f64; 2]]) -> Group {
    let mut group = Group::new().set("fill", "#8d1f1f").add(
        path(frame, polygon).set("stroke", "#b06060").set("stroke-width", 1.2).set("stroke-dasharray", "5 4"),
    );
    for &point in polygon {
        let [x, y] = frame.place(point);
        group = group.add(Circle::new().set("cx", rounded(x)).set("cy", rounded(y)).set("r", 3.6));
    }
    group
}

fn path(frame: &Frame, points: &[[f64; 2]]) -> Path {
    let mut data = Data::new();
    for (k, &point) in points.iter().enumerate() {
        let [x, y] = frame.place(point).map(rounded);
        data = if k == 0 { data.move_to((x, y)) } else { data.line_to((x, y)) };
    }
    Path::new()
        .set("d", data)
        .set("fill", "none")
        .set("stroke-linejoin", "round")
        .set("stroke-linecap", "round")
}

fn text(content: &str, x: f64, y: f64, size: u32) -> Text {
    Text::new(content).set("x", x).set("y", rounded(y)).set("font-size", size).set("fill", "#222")
}

/// From the plane to the drawing, with equal units in both directions.
struct Frame {
    low: [f64; 2],
    high: [f64; 2],
    scale: f64,
    height: f64,
}

impl Frame {
    fn new(plot: &Plot) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in plot.points() {
            for k in 0..2 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        // The axis belongs into the picture.
        if let Some(axis) = plot.axis {
            let k = usize::from(axis == Axis::X);
            low[k] = low[k].min(0.0);
            high[k] = high[k].max(0.0);
        }
        let room = WIDTH - 2.0 * MARGIN;
        let scale = (room / (high[0] - low[0]).max(1e-9)).min(room * 0.72 / (high[1] - low[1]).max(1e-9));
        let height = (high[1] - low[1]) * scale + 2.0 * MARGIN;
        Self { low, high, scale, height }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let middle = 0.5 * (self.low[0] + self.high[0]);
        [0.5 * WIDTH + (x - middle) * self.scale, MARGIN + (self.high[1] - y) * self.scale]
    }

    fn axis(&self, axis: Axis) -> Line {
        let [x, y] = self.place([0.0, 0.0]).map(rounded);
        let line = Line::new().set("stroke", "#999").set("stroke-dasharray", "12 4 2 4");
        match axis {
            Axis::X => line.set("x1", 0).set("x2", WIDTH).set("y1", y).set("y2", y),
            Axis::Y => line.set("x1", x).set("x2", x).set("y1", 0).set("y2", rounded(self.height)),
        }
    }
}

fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

/// Lines of at most that many characters, broken between words.
fn wrap(text: &str, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
