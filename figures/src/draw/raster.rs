//! A small renderer: shaded triangles, lines and points with a depth buffer, as PNG.

use std::f64::consts::FRAC_1_SQRT_2;

/// Red, green, blue; each from 0 to 1.
pub(crate) type Colour = [f32; 3];

/// How many pixels are averaged in each direction, against jagged edges.
const FINE: usize = 2;

/// A picture that is being drawn. Positions are in pixels, `x` to the right, `y` down, with the depth in the same unit;
/// smaller is nearer.
pub(crate) struct Raster {
    width: usize,
    height: usize,
    colour: Vec<Colour>,
    depth: Vec<f32>,
}

/// A corner of a triangle: a position, and a unit normal in the directions of the picture, `z` towards the viewer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    pub(crate) at: [f64; 3],
    pub(crate) normal: [f64; 3],
}

impl Raster {
    /// A white picture.
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let (width, height) = (width * FINE, height * FINE);
        Self {
            width,
            height,
            colour: vec![[1.0; 3]; width * height],
            depth: vec![f32::INFINITY; width * height],
        }
    }

    /// A shaded triangle; `front` and `back` colour its two sides.
    pub(crate) fn triangle(&mut self, corners: [Corner; 3], front: Colour, back: Colour) {
        let [a, b, c] = corners.map(|corner| corner.at.map(|x| x * FINE as f64));
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area.abs() < 1e-12 {
            return;
        }
        let Some((columns, rows)) = self.range([a, b, c], 0.0) else { return };
        for y in rows {
            for x in columns.clone() {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let wa = ((b[0] - px) * (c[1] - py) - (b[1] - py) * (c[0] - px)) / area;
                let wb = ((c[0] - px) * (a[1] - py) - (c[1] - py) * (a[0] - px)) / area;
                let wc = 1.0 - wa - wb;
                if wa < -1e-9 || wb < -1e-9 || wc < -1e-9 {
                    continue;
                }
                let depth = (wa * a[2] + wb * b[2] + wc * c[2]) as f32;
                let pixel = y * self.width + x;
                if depth < self.depth[pixel] {
                    self.depth[pixel] = depth;
                    let normal = [0, 1, 2].map(|k| {
                        wa * corners[0].normal[k] + wb * corners[1].normal[k] + wc * corners[2].normal[k]
                    });
                    self.colour[pixel] = shade(normal, front, back);
                }
            }
        }
    }

    /// A straight line of that width. `hidden` is how much of it shows where something is in front of it, from 0 to 1.
    pub(crate) fn line(
        &mut self,
        from: [f64; 3],
        to: [f64; 3],
        width: f64,
        colour: Colour,
        opacity: f32,
        hidden: f32,
    ) {
        let [a, b] = [from, to].map(|p| p.map(|x| x * FINE as f64));
        let half = width * FINE as f64 * 0.5;
        let Some((columns, rows)) = self.range([a, b, b], half + 1.0) else { return };
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let square = dx * dx + dy * dy;
        for y in rows {
            for x in columns.clone() {
                let (px, py) = (x as f64 + 0.5 - a[0], y as f64 + 0.5 - a[1]);
                let t = if square > 0.0 { ((px * dx + py * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
                let distance = (px - t * dx).hypot(py - t * dy);
                let cover = (half + 0.5 - distance).clamp(0.0, 1.0) as f32;
                if cover > 0.0 {
                    let depth = a[2] + t * (b[2] - a[2]);
                    self.blend(x, y, depth, colour, cover * opacity, hidden);
                }
            }
        }
    }

    /// A disc of that diameter.
    pub(crate) fn disc(&mut self, at: [f64; 3], diameter: f64, colour: Colour, hidden: f32) {
        self.line(at, at, diameter, colour, 1.0, hidden);
    }

    fn blend(&mut self, x: usize, y: usize, depth: f64, colour: Colour, cover: f32, hidden: f32) {
        let pixel = y * self.width + x;
        // Lines on a surface lie in front of it by this much.
        let bias = 0.004 * self.width as f64;
        let visible = (depth - bias) as f32 <= self.depth[pixel];
        let cover = if visible { cover } else { cover * hidden };
        for (old, new) in self.colour[pixel].iter_mut().zip(colour) {
            *old += (new - *old) * cover;
        }
    }

    /// The pixels around points, cut off at the border; `None` if there are none or a point is not finite.
    fn range(
        &self,
        points: [[f64; 3]; 3],
        margin: f64,
    ) -> Option<(std::ops::Range<usize>, std::ops::Range<usize>)> {
        if !points.iter().flatten().all(|c| c.is_finite()) {
            return None;
        }
        let range = |k: usize, size: usize| {
            let low = points.iter().fold(f64::INFINITY, |a, p| a.min(p[k])) - margin;
            let high = points.iter().fold(f64::NEG_INFINITY, |a, p| a.max(p[k])) + margin;
            let limit = size as f64;
            low.floor().clamp(0.0, limit) as usize..high.ceil().clamp(0.0, limit) as usize
        };
        Some((range(0, self.width), range(1, self.height)))
    }

    /// The picture as PNG, with a text about it.
    pub(crate) fn png(&self, title: &str, description: &str) -> Result<Vec<u8>, png::EncodingError> {
        let (width, height) = (self.width / FINE, self.height / FINE);
        let mut bytes = Vec::with_capacity(width * height * 3);
        for y in 0..height {
            for x in 0..width {
                for k in 0..3 {
                    let mut sum = 0.0;
                    for row in 0..FINE {
                        for column in 0..FINE {
                            sum += self.colour[(y * FINE + row) * self.width + x * FINE + column][k];
                        }
                    }
                    let mean = sum / (FINE * FINE) as f32;
                    bytes.push((mean.clamp(0.0, 1.0) * 255.0).round() as u8);
                }
            }
        }
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, width as u32, height as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.add_itxt_chunk(String::from("Title"), title.to_owned())?;
        encoder.add_itxt_chunk(String::from("Description"), description.to_owned())?;
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&bytes)?;
        writer.finish()?;
        Ok(out)
    }
}

/// Light from the upper left, a weaker one from the right, and a highlight.
fn shade(normal: [f64; 3], front: Colour, back: Colour) -> Colour {
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length == 0.0 {
        return front;
    }
    let side = if normal[2] < 0.0 { -1.0 } else { 1.0 };
    let n = normal.map(|c| c * side / length);
    let base = if side > 0.0 { front } else { back };
    let dot = |light: [f64; 3]| (n[0] * light[0] + n[1] * light[1] + n[2] * light[2]).max(0.0);
    let key = dot([-0.48, 0.6, 0.64]);
    let fill = dot([FRAC_1_SQRT_2, 0.0, FRAC_1_SQRT_2]);
    let highlight = dot([-0.265, 0.331, 0.906]).powi(60);
    let strength = (0.46 + 0.48 * key + 0.2 * fill) as f32;
    base.map(|c| (c * strength + 0.28 * highlight as f32).min(1.0))
}
