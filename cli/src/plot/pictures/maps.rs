//! Functions on a triangle or a square as maps: each in a panel of its own, one scale of colours for all.

use basis_engine::Diagnostic;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use svg::node::element::{Circle, Group, Path, Polygon, Rectangle, Title};

use super::frame::{FAINT, INK, hex, mix, number, rounded, scale, text, ticks};
use super::lines::{document, pretty, wrapped};
use crate::output::error;
use crate::plot::Scene;
use crate::plot::values::{Functions, between};

/// More functions than this are too small to be seen.
const MAX_PANELS: usize = 66;

/// The corner of a small triangle: place and value.
type Corner = ([f64; 2], f64);

/// A small triangle between two neighbouring lines of the grid.
struct Cell {
    /// The places of its corners with the values of all functions.
    corners: [([f64; 2], Vec<Option<f64>>); 3],
    /// Which of the corners lie on the second line.
    far: [bool; 3],
}

/// The picture.
pub(in crate::plot) fn svg(scene: &Scene) -> Result<String, Diagnostic> {
    let family = &scene.family;
    let count = family.functions.len();
    if count > MAX_PANELS {
        let message =
            format!("`{}` has {count} functions, which are too many for one picture", family.title());
        return Err(error(message).help("draw a lower order"));
    }
    let Some(setting) = scene.settings.first() else { return Err(error("there are no shape values")) };
    let functions = Functions::new(family, &setting.values);
    let (parts, size) = match count {
        0..=6 => (48, 190.0),
        7..=15 => (36, 150.0),
        16..=28 => (24, 118.0),
        _ => (18, 96.0),
    };
    let strips = grid(scene, parts, &functions)?;
    let range = |k: usize| {
        let values = strips.iter().flatten().flat_map(|t| t.corners.iter().filter_map(move |(_, v)| v[k]));
        values.fold([0.0_f64; 2], |[low, high], v| [low.min(v), high.max(v)])
    };
    let ranges: Vec<[f64; 2]> = (0..count).map(range).collect();
    let levels = levels(&ranges);
    let columns = (1..=count).find(|c| c * c * 3 >= count * 4).unwrap_or(1).max(count.min(3));
    // Beside a square stands the name of its variable.
    let (gap, top, start) = (26.0, 78.0, if family.is_simplex() { 20.0 } else { 46.0 });
    let mut group = Group::new();
    for k in 0..count {
        let place =
            [start + (size + gap) * (k % columns) as f64, top + (size + gap + 8.0) * (k / columns) as f64];
        group = group.add(panel(scene, k, place, size, &strips, &levels));
    }
    let rows = count.div_ceil(columns);
    let right = start + (size + gap) * columns as f64;
    let height = (rows as f64 * (size + gap + 8.0)).max(170.0);
    group = group.add(key(&levels, right + 4.0, top, (height - gap).min(300.0)));
    let mut y = top + height + 8.0;
    for mark in &scene.marks {
        for line in wrapped(&pretty(&format!("✗ {}", mark.failure.text)), 92) {
            group = group.add(text(&line, 20.0, y, 13.0, "start", mark.colour()));
            y += 18.0;
        }
    }
    Ok(document(scene, right + 84.0, y, group))
}

/// Round numbers below, between and above all values: at equal distances, or as 1, 2, 5, 10 where some functions are much
/// smaller than others.
fn levels(ranges: &[[f64; 2]]) -> Vec<f64> {
    let low = ranges.iter().map(|r| r[0]).fold(0.0, f64::min);
    let high = ranges.iter().map(|r| r[1]).fold(0.0, f64::max);
    let largest = high.max(-low);
    let peaks = ranges.iter().map(|[a, b]| b.max(-a)).filter(|p| *p > largest * 1e-9);
    let least = peaks.fold(largest, f64::min);
    if largest < 1e-12 {
        return vec![-1.0, 0.0, 1.0];
    }
    if least > largest / 4.0 {
        let mut levels = ticks(low, high, 10.0);
        let step = if levels.len() > 1 { levels[1] - levels[0] } else { largest };
        if levels.first().is_none_or(|first| *first > low + 1e-9 * step) {
            levels.insert(0, levels.first().map_or(low, |first| first - step));
        }
        if levels.last().is_none_or(|last| *last < high - 1e-9 * step) {
            levels.push(levels.last().map_or(high, |last| last + step));
        }
        return levels;
    }
    // Three steps below the peak of the smallest function, but no more than eight in all.
    let from = (least / 4.0).max(largest / 400.0);
    let mut steps = Vec::new();
    let mut power = 10_f64.powf(from.log10().floor());
    while steps.last().is_none_or(|last| *last < largest * (1.0 - 1e-9)) {
        steps.extend([1.0, 2.0, 5.0].map(|s| s * power).into_iter().filter(|s| *s >= from * (1.0 - 1e-9)));
        power *= 10.0;
    }
    let below = |limit: f64| {
        let needed = steps.iter().position(|s| *s >= limit * (1.0 - 1e-9)).map_or(steps.len(), |k| k + 1);
        steps[..if limit <= 0.0 { 0 } else { needed }].to_vec()
    };
    let negative = below(-low).into_iter().rev().map(|s| -s);
    negative.chain([0.0]).chain(below(high)).collect()
}

/// Small triangles that fill the domain in a unit square, those between two lines of the grid together.
fn grid(scene: &Scene, parts: i64, functions: &Functions) -> Result<Vec<Vec<Cell>>, Diagnostic> {
    let family = &scene.family;
    let ranges: Option<Vec<_>> = family.domain.iter().map(|p| p.range.finite()).collect();
    let Some([(a, b), (c, d)]) = ranges.as_deref() else {
        return Err(error("the domain has no picture in the plane"));
    };
    let (us, vs) = (between(a, b, parts), between(c, d, parts));
    let corner = |i: usize, j: usize| {
        let at: [Rational; 2] = [us[i].clone(), vs[j].clone()];
        (place(scene, [i as f64 / parts as f64, j as f64 / parts as f64]), functions.values(&at))
    };
    let n = parts as usize;
    let inside = |i: usize, j: usize| !family.is_simplex() || i + j <= n;
    let corners: Vec<Vec<_>> =
        (0..=n).map(|i| (0..=n).filter(|j| inside(i, *j)).map(|j| corner(i, j)).collect()).collect();
    let get = |i: usize, j: usize| corners[i][j].clone();
    let strip = |i: usize| {
        let mut cells = Vec::new();
        for j in 0..n {
            if inside(i + 1, j) && inside(i, j + 1) {
                let corners = [get(i, j), get(i + 1, j), get(i, j + 1)];
                cells.push(Cell { corners, far: [false, true, false] });
            }
            if inside(i + 1, j + 1) {
                let corners = [get(i + 1, j), get(i + 1, j + 1), get(i, j + 1)];
                cells.push(Cell { corners, far: [true, true, false] });
            }
        }
        cells
    };
    Ok((0..n).map(strip).collect())
}

/// Where a point of the unit square, or of its lower left half, stands in a panel: a triangle has equal sides.
fn place(scene: &Scene, [u, v]: [f64; 2]) -> [f64; 2] {
    if scene.family.is_simplex() {
        // w at the lower left, u at the lower right, v on top.
        let height = 3_f64.sqrt() / 2.0;
        return [u + v / 2.0, 1.0 - height * v];
    }
    [u, 1.0 - v]
}

fn panel(
    scene: &Scene,
    function: usize,
    [left, top]: [f64; 2],
    size: f64,
    strips: &[Vec<Cell>],
    levels: &[f64],
) -> Group {
    let family = &scene.family;
    let at = |[x, y]: [f64; 2]| [tenth(left + size * x), tenth(top + size * y)];
    let mut bands = vec![String::new(); levels.len().saturating_sub(1)];
    for strip in strips {
        // Neighbours that lie in one band are drawn as one quadrilateral.
        let mut run: Option<(usize, [Vec<[f64; 2]>; 2])> = None;
        for cell in strip {
            let corner = |(p, values): &([f64; 2], Vec<Option<f64>>)| {
                Some((at(*p), values.get(function).copied().flatten()?))
            };
            let corners: Option<Vec<Corner>> = cell.corners.iter().map(corner).collect();
            let whole = corners.as_ref().and_then(|corners| {
                let inside = |k: &usize| corners.iter().all(|(_, v)| levels[*k] <= *v && *v <= levels[k + 1]);
                (0..bands.len()).rev().find(inside)
            });
            if run.as_ref().map(|(band, _)| *band) != whole {
                flush(&mut run, &mut bands);
            }
            let Some(corners) = corners else { continue };
            if let Some(band) = whole {
                let (_, sides) = run.get_or_insert_with(|| (band, [Vec::new(), Vec::new()]));
                for ((p, _), far) in corners.iter().zip(cell.far) {
                    sides[usize::from(far)].push(*p);
                }
                continue;
            }
            for (k, band) in bands.iter_mut().enumerate() {
                let part = clip(&clip(&corners, levels[k], 1.0), levels[k + 1], -1.0);
                polygon(&part.iter().map(|(p, _)| *p).collect::<Vec<_>>(), band);
            }
        }
        flush(&mut run, &mut bands);
    }
    let label = family.function_label(function);
    let mut group = Group::new().add(Title::new(label.clone()));
    for (k, data) in bands.into_iter().enumerate().filter(|(_, data)| !data.is_empty()) {
        let fill = band_colour(levels, k);
        // A thin edge of the same colour closes the seams between triangles.
        let path =
            Path::new().set("d", data).set("fill", fill.clone()).set("stroke", fill).set("stroke-width", 0.6);
        group = group.add(path);
    }
    let outline: Vec<[f64; 2]> = if family.is_simplex() {
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|p| at(place(scene, p))).to_vec()
    } else {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|p| at(place(scene, p))).to_vec()
    };
    let corners: Vec<String> = outline.iter().map(|[x, y]| format!("{x},{y}")).collect();
    group = group
        .add(Polygon::new().set("points", corners.join(" ")).set("fill", "none").set("stroke", "#555555"));
    group = group.add(text(
        &label,
        left,
        top - 6.0 + if family.is_simplex() { 12.0 } else { 0.0 },
        12.5,
        "start",
        INK,
    ));
    // Where the variables grow is written once.
    if function == 0 {
        group = group.add(names(scene, &outline));
    }
    for mark in scene.marks.iter().filter(|m| m.failure.function.is_none_or(|f| f == function)) {
        let [Some(u), Some(v)] = &mark.failure.at[..] else { continue };
        let unit = |k: usize, x: &Rational| {
            let (low, high) = family.domain[k].range.finite().unwrap_or((x, x));
            (x - low).checked_div(&(high - low)).map_or(0.0, |x| x.to_f64())
        };
        let [x, y] = at(place(scene, [unit(0, u), unit(1, v)]));
        let ring = Circle::new().set("cx", x).set("cy", y).set("r", 5).set("class", "counterexample");
        group = group.add(ring.set("fill", "#ffffff").set("stroke", mark.colour()).set("stroke-width", 2.2));
    }
    group
}

/// Adds the quadrilateral of a run to its band.
fn flush(run: &mut Option<(usize, [Vec<[f64; 2]>; 2])>, bands: &mut [String]) {
    let Some((band, [near, far])) = run.take() else { return };
    let ends = [near.first(), near.last(), far.last(), far.first()];
    polygon(&ends.into_iter().flatten().copied().collect::<Vec<_>>(), &mut bands[band]);
}

/// Adds a polygon to a path; corners that are the same in print are one.
fn polygon(corners: &[[f64; 2]], path: &mut String) {
    let mut corners: Vec<[f64; 2]> = corners.iter().map(|p| p.map(tenth)).collect();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    if corners.len() < 3 {
        return;
    }
    for (n, [x, y]) in corners.iter().enumerate() {
        *path += &format!("{}{x} {y}", if n == 0 { "M" } else { "L" });
    }
    path.push('Z');
}

/// A number with one decimal: a grid has many points.
fn tenth(x: f64) -> f64 {
    (x * 10.0).round() / 10.0
}

/// The names of the corners of a triangle, or of the sides of a square.
fn names(scene: &Scene, outline: &[[f64; 2]]) -> Group {
    let family = &scene.family;
    let mut group = Group::new();
    let variables: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
    let mut write = |content: &str, x: f64, y: f64, anchor: &str| {
        group = group.clone().add(text(content, x, y, 11.0, anchor, FAINT).set("font-style", "italic"));
    };
    match (variables.as_slice(), outline) {
        ([u, v, w], [a, b, c]) => {
            write(&format!("{w} = 1"), a[0], a[1] + 13.0, "start");
            write(&format!("{u} = 1"), b[0], b[1] + 13.0, "end");
            write(&format!("{v} = 1"), c[0] + 8.0, c[1] + 4.0, "start");
        }
        ([u, v], [a, b, _, d]) => {
            write(&format!("{u} →"), f64::midpoint(a[0], b[0]), a[1] + 13.0, "middle");
            write(&format!("{v} ↑"), a[0] - 3.0, f64::midpoint(a[1], d[1]), "end");
        }
        _ => {}
    }
    group
}

/// The part of a polygon on which the value is at least, or with the other sign at most, a level.
fn clip(polygon: &[Corner], level: f64, sign: f64) -> Vec<Corner> {
    let mut part = Vec::new();
    for (k, (p, a)) in polygon.iter().enumerate() {
        let (q, b) = &polygon[(k + 1) % polygon.len()];
        let (da, db) = (sign * (a - level), sign * (b - level));
        if da >= 0.0 {
            part.push((*p, *a));
        }
        if da * db < 0.0 {
            let s = da / (da - db);
            part.push(([p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])], level));
        }
    }
    part
}

/// The colour between two levels: shades of red below zero, from light to dark above.
fn band_colour(levels: &[f64], k: usize) -> String {
    // The bands below zero, and those above.
    let below = levels.iter().filter(|level| **level < 0.0).count();
    let above = levels.len().saturating_sub(below + 1).max(1);
    if k < below {
        let at = (below - k) as f64 / below as f64;
        return hex(mix([255, 225, 215], [160, 10, 30], at));
    }
    let at = ((k - below) as f64 + 0.5) / above as f64;
    hex(mix([250, 250, 245], scale(1.0 - at), (0.25 + 0.9 * at).min(1.0)))
}

/// The scale of colours with its numbers.
fn key(levels: &[f64], left: f64, top: f64, height: f64) -> Group {
    let mut group = Group::new();
    let bands = levels.len().saturating_sub(1).max(1);
    let step = height / bands as f64;
    for k in 0..levels.len().saturating_sub(1) {
        let y = top + height - step * (k + 1) as f64;
        let bar = Rectangle::new()
            .set("x", left)
            .set("y", rounded(y))
            .set("width", 18)
            .set("height", rounded(step));
        group = group
            .add(bar.set("fill", band_colour(levels, k)).set("stroke", "#bbbbbb").set("stroke-width", 0.5));
    }
    for (k, level) in levels.iter().enumerate() {
        let y = top + height - step * k as f64;
        group = group.add(text(&number(*level), left + 24.0, y + 4.0, 11.5, "start", FAINT));
    }
    group
}
