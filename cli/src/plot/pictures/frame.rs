//! What all pictures share: colours, text, axes with round numbers.

use svg::node::element::{Group, Line, Path, Rectangle, Text};

/// The family of letters.
pub(in crate::plot) const FONT: &str = "DejaVu Sans, Helvetica, Arial, sans-serif";

/// The colour of text and axes.
pub(in crate::plot) const INK: &str = "#222222";

/// The colour of what is less important.
pub(in crate::plot) const FAINT: &str = "#6b6b6b";

/// The colour of what fails.
pub(in crate::plot) const BAD: &str = "#c1121f";

/// Eight colours that differ for every eye (Okabe and Ito), darkened where they would be too light on white.
const COLOURS: [[u8; 3]; 8] = [
    [0, 114, 178],
    [213, 94, 0],
    [0, 140, 102],
    [180, 90, 150],
    [176, 128, 0],
    [60, 160, 215],
    [40, 40, 40],
    [140, 90, 40],
];

/// Colours from dark blue over green to ochre, for what has an order and is more than eight.
const SCALE: [[u8; 3]; 6] =
    [[58, 30, 110], [49, 80, 150], [30, 125, 140], [40, 160, 110], [130, 175, 50], [205, 165, 20]];

/// The colour of one of several functions.
pub(in crate::plot) fn colour(k: usize, of: usize) -> [u8; 3] {
    if of <= COLOURS.len() { COLOURS[k % COLOURS.len()] } else { scale(k as f64 / (of - 1) as f64) }
}

/// How the line of one of several functions is broken: neighbours on the scale of colours are too much alike where they cross.
pub(in crate::plot) fn dashes(k: usize, of: usize) -> Option<&'static str> {
    if of <= COLOURS.len() { None } else { [None, Some("8 4"), Some("2 3")][k % 3] }
}

/// The colour at a place from 0 to 1 of the scale.
pub(in crate::plot) fn scale(at: f64) -> [u8; 3] {
    let at = at.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let k = (at as usize).min(SCALE.len() - 2);
    mix(SCALE[k], SCALE[k + 1], at - k as f64)
}

/// A colour between two.
pub(in crate::plot) fn mix(a: [u8; 3], b: [u8; 3], at: f64) -> [u8; 3] {
    [0, 1, 2].map(|k| (f64::from(a[k]) * (1.0 - at) + f64::from(b[k]) * at).round() as u8)
}

/// A colour as it is written.
pub(in crate::plot) fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A line of text.
pub(in crate::plot) fn text(content: &str, x: f64, y: f64, size: f64, anchor: &str, colour: &str) -> Text {
    Text::new(content)
        .set("x", rounded(x))
        .set("y", rounded(y))
        .set("font-family", FONT)
        .set("font-size", size)
        .set("text-anchor", anchor)
        .set("fill", colour)
}

/// A number with at most two decimals.
pub(in crate::plot) fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

/// Round numbers that divide a range into about this number of parts.
pub(in crate::plot) fn ticks(low: f64, high: f64, parts: f64) -> Vec<f64> {
    let raw = (high - low) / parts;
    if !raw.is_finite() || raw <= 0.0 {
        return Vec::new();
    }
    let power = 10_f64.powf(raw.log10().floor());
    let step =
        [1.0, 2.0, 2.5, 5.0, 10.0].into_iter().map(|s| s * power).find(|s| *s >= raw * 0.999).unwrap_or(raw);
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last.min(first + 50)).map(|k| k as f64 * step).collect()
}

/// A round number as it is written.
pub(in crate::plot) fn number(x: f64) -> String {
    let text = format!("{:.6}", x + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" || text.is_empty() { String::from("0") } else { text.replace('-', "\u{2212}") }
}

/// A rectangle of a picture with the ranges of its two axes.
#[derive(Clone, Copy, Debug)]
pub(in crate::plot) struct Frame {
    /// Left, top, width and height.
    pub(in crate::plot) place: [f64; 4],
    /// What stands at the left and the right.
    pub(in crate::plot) x: [f64; 2],
    /// What stands at the bottom and the top.
    pub(in crate::plot) y: [f64; 2],
}

impl Frame {
    /// Where a point is drawn.
    pub(in crate::plot) fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let [left, top, width, height] = self.place;
        let across = (x - self.x[0]) / (self.x[1] - self.x[0]);
        let up = (y - self.y[0]) / (self.y[1] - self.y[0]);
        [rounded(left + width * across), rounded(top + height * (1.0 - up))]
    }

    /// The axes with their numbers and a light grid; `name` is that of the horizontal axis.
    pub(in crate::plot) fn axes(&self, name: &str) -> Group {
        let [left, top, width, height] = self.place;
        let border = Rectangle::new()
            .set("x", left)
            .set("y", top)
            .set("width", width)
            .set("height", height)
            .set("fill", "none")
            .set("stroke", "#9a9a9a");
        let mut group = Group::new();
        let line = |from: [f64; 2], to: [f64; 2], colour: &str| {
            let line = Line::new().set("x1", from[0]).set("y1", from[1]).set("x2", to[0]).set("y2", to[1]);
            line.set("stroke", colour.to_string()).set("stroke-width", 1)
        };
        for x in ticks(self.x[0], self.x[1], 6.0) {
            let [at, _] = self.at(x, self.y[0]);
            group = group.add(line([at, top], [at, top + height], "#ececec"));
            group = group.add(text(&number(x), at, top + height + 17.0, 12.0, "middle", FAINT));
        }
        for y in ticks(self.y[0], self.y[1], 6.0) {
            let [_, at] = self.at(self.x[0], y);
            let colour = if y == 0.0 { "#b0b0b0" } else { "#ececec" };
            group = group.add(line([left, at], [left + width, at], colour));
            group = group.add(text(&number(y), left - 7.0, at + 4.0, 12.0, "end", FAINT));
        }
        group = group.add(border);
        group.add(
            text(name, left + width / 2.0, top + height + 36.0, 14.0, "middle", INK)
                .set("font-style", "italic"),
        )
    }

    /// A line through points; nothing is drawn where there is none.
    pub(in crate::plot) fn path(&self, points: &[[Option<f64>; 2]], colour: &str, width: f64) -> Path {
        let mut data = String::new();
        let mut pen_down = false;
        for [x, y] in points {
            let (Some(x), Some(y)) = (x, y) else {
                pen_down = false;
                continue;
            };
            let [x, y] = self.at(*x, *y);
            data += &format!("{}{x} {y}", if pen_down { "L" } else { "M" });
            pen_down = true;
        }
        Path::new()
            .set("d", data)
            .set("fill", "none")
            .set("stroke", colour.to_string())
            .set("stroke-width", width)
            .set("stroke-linejoin", "round")
    }
}

/// A range that holds all numbers, with some room; at least a small one.
pub(in crate::plot) fn extent(values: impl Iterator<Item = f64>, room: f64) -> [f64; 2] {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return [0.0, 1.0];
    }
    let room = if high - low < 1e-12 { 0.5 } else { (high - low) * room };
    [low - room, high + room]
}
