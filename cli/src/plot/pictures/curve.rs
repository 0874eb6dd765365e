//! The curve of a control polygon, for every setting.

use svg::node::element::{Circle, Group, Rectangle, Title};

use super::frame::{FAINT, Frame, INK, extent, hex, mix, text};
use crate::plot::Scene;
use crate::plot::samples::{Sampled, strength};

/// The colour of curves.
const CURVE: [u8; 3] = [0, 90, 160];

/// The curves with their control polygon, in a square from `left` and `top` on; and where it ends.
pub(in crate::plot) fn curve(
    scene: &Scene,
    samples: &[Sampled],
    left: f64,
    top: f64,
    size: f64,
) -> (Group, f64) {
    let points = &scene.points;
    let curves: Vec<Vec<[Option<f64>; 2]>> = samples.iter().map(|s| through(points, s)).collect();
    let coordinates = |axis: usize| {
        let drawn = curves.iter().flatten().filter_map(move |p| p[axis]);
        points.iter().map(move |p| p[axis]).chain(drawn).collect::<Vec<f64>>()
    };
    let (x, y) = (extent(coordinates(0).into_iter(), 0.08), extent(coordinates(1).into_iter(), 0.08));
    // One unit is as long in both directions.
    let half = ((x[1] - x[0]).max(y[1] - y[0])) / 2.0;
    let around = |[low, high]: [f64; 2]| [f64::midpoint(low, high) - half, f64::midpoint(low, high) + half];
    let frame = Frame { place: [left, top, size, size], x: around(x), y: around(y) };
    let border = Rectangle::new().set("x", left).set("y", top).set("width", size).set("height", size);
    let mut group = Group::new().add(border.set("fill", "none").set("stroke", "#9a9a9a"));
    let polygon: Vec<[Option<f64>; 2]> = points.iter().map(|p| p.map(Some)).collect();
    group =
        group.add(frame.path(&polygon, FAINT, 1.2).set("stroke-dasharray", "5 4").set("class", "polygon"));
    for (s, curve) in curves.iter().enumerate() {
        let colour = hex(mix(CURVE, [255; 3], strength(s, curves.len())));
        let title = Title::new(scene.settings[s].label.clone());
        group = group.add(frame.path(curve, &colour, 2.4).set("class", "curve").add(title));
    }
    let middle = points.iter().map(|p| p[1]).sum::<f64>() / points.len() as f64;
    for (k, [x, y]) in points.iter().enumerate() {
        let [px, py] = frame.at(*x, *y);
        let index: Vec<String> = scene.family.functions[k].index.iter().map(i64::to_string).collect();
        group = group.add(Circle::new().set("cx", px).set("cy", py).set("r", 3.6).set("fill", FAINT));
        // The name stands on the side that is turned away from the others.
        let away = if *y >= middle { -9.0 } else { 18.0 };
        group = group.add(text(&format!("P[{}]", index.join(",")), px, py + away, 12.0, "middle", INK));
    }
    (group, left + size + 20.0)
}

/// `Σ b[i] P[i]`.
fn through(points: &[[f64; 2]], sample: &Sampled) -> Vec<[Option<f64>; 2]> {
    let point = |values: &Vec<Option<f64>>| {
        [0, 1].map(|axis| values.iter().zip(points).map(|(b, p)| b.map(|b| b * p[axis])).sum::<Option<f64>>())
    };
    sample.values.iter().map(point).collect()
}
