//! Surfaces with their nets, seen from a direction.

use basis_runtime::{BoundedSurface, Mesh, MeshError, Point, Point3, Surface, Tessellation};

use super::raster::{Colour, Corner, Raster};

/// The size of a picture in pixels.
const SIZE: [usize; 2] = [840, 640];

/// The share of the picture that stays empty at each side.
const MARGIN: f64 = 0.05;

/// The front colours of surfaces, in turn.
const FRONT: [Colour; 6] = [
    [0.36, 0.60, 0.85],
    [0.91, 0.62, 0.30],
    [0.44, 0.73, 0.45],
    [0.80, 0.47, 0.66],
    [0.55, 0.52, 0.80],
    [0.78, 0.70, 0.32],
];
const BACK: Colour = [0.74, 0.72, 0.68];
const INK: Colour = [0.12, 0.13, 0.16];
const NET: Colour = [0.62, 0.12, 0.12];

/// Three components of a point.
pub(crate) type Point3d = [f64; 3];

/// What is shown.
#[derive(Default)]
pub(crate) struct Scene {
    meshes: Vec<Mesh<f64>>,
    lines: Vec<Line>,
    points: Vec<Point3d>,
    colours: Option<Vec<usize>>,
    inside_out: bool,
}

struct Line {
    points: Vec<Point3d>,
    is_net: bool,
}

/// From where a scene is seen: angles in degrees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Around the vertical, from the x axis towards the y axis.
    pub(crate) azimuth: f64,
    /// Above the horizon.
    pub(crate) elevation: f64,
}

impl Scene {
    /// Surfaces as one mesh, their boundaries and a few isocurves drawn on them. The tolerance is a part of their size.
    ///
    /// # Errors
    /// When they cannot be meshed.
    pub(crate) fn surfaces<T, P>(&mut self, surfaces: &[T]) -> Result<&Mesh<f64>, MeshError>
    where
        T: BoundedSurface + Surface<Point = P>,
        P: Point3<Scalar = f64>,
    {
        let mut tessellation = Tessellation::new(tolerance(surfaces))?;
        for surface in surfaces {
            tessellation = tessellation.with(surface);
        }
        let mesh = tessellation.mesh()?;
        self.meshes.push(mesh);
        for surface in surfaces {
            self.isocurves(surface);
        }
        Ok(&self.meshes[self.meshes.len() - 1])
    }

    /// The colour of each surface of the last mesh, as a number.
    pub(crate) fn colours(&mut self, colours: Vec<usize>) {
        self.colours = Some(colours);
    }

    /// Gives the back of the surfaces their colour, and the front that of backs.
    pub(crate) fn inside_out(&mut self) {
        self.inside_out = true;
    }

    fn isocurves<T, P>(&mut self, surface: &T)
    where
        T: Surface<Point = P>,
        P: Point3<Scalar = f64>,
    {
        let [u, v] = surface.domain().ranges();
        for k in 0..=4 {
            let along = |of: &dyn Fn(usize) -> P| (0..=48).map(|i| components(of(i))).collect();
            let across_u = along(&|i| surface.eval(at(u, i, 48), at(v, k, 4)));
            let across_v = along(&|i| surface.eval(at(u, k, 4), at(v, i, 48)));
            for points in [across_u, across_v] {
                self.lines.push(Line { points, is_net: false });
            }
        }
    }

    /// A net of control points: lines along rows and columns, and the points.
    pub(crate) fn net(&mut self, rows: &[Vec<Point3d>]) {
        for row in rows {
            self.polygon(row);
        }
        let columns = rows.iter().map(Vec::len).min().unwrap_or(0);
        for j in 0..columns {
            self.lines.push(Line { points: rows.iter().map(|row| row[j]).collect(), is_net: true });
        }
    }

    /// Single points.
    pub(crate) fn points(&mut self, points: &[Point3d]) {
        self.points.extend_from_slice(points);
    }

    /// A control polygon with its points.
    pub(crate) fn polygon(&mut self, points: &[Point3d]) {
        self.points.extend_from_slice(points);
        self.lines.push(Line { points: points.to_vec(), is_net: true });
    }

    /// The picture as PNG.
    pub(crate) fn png(
        &self,
        view: View,
        title: &str,
        description: &str,
    ) -> Result<Vec<u8>, png::EncodingError> {
        let camera = Camera::new(view, &self.all_points());
        let mut raster = Raster::new(SIZE[0], SIZE[1]);
        for mesh in &self.meshes {
            for triangle in &mesh.triangles {
                let corners = triangle.map(|v| {
                    let vertex = &mesh.vertices[v as usize];
                    let position = mesh.positions[vertex.position as usize];
                    Corner { at: camera.project(position), normal: camera.turn(vertex.normal) }
                });
                let surface = mesh.vertices[triangle[0] as usize].surface as usize;
                let colour = self.colours.as_ref().and_then(|c| c.get(surface).copied()).unwrap_or(surface);
                let colour = FRONT[colour % FRONT.len()];
                let [front, back] = if self.inside_out { [BACK, colour] } else { [colour, BACK] };
                raster.triangle(corners, front, back);
            }
        }
        for line in &self.lines {
            for pair in line.points.windows(2) {
                let [from, to] = [pair[0], pair[1]].map(|p| camera.project(p));
                if line.is_net {
                    raster.line(from, to, 1.6, NET, 0.9, 0.35);
                } else {
                    raster.line(from, to, 1.1, INK, 0.45, 0.0);
                }
            }
        }
        for &point in &self.points {
            raster.disc(camera.project(point), 7.0, NET, 0.45);
        }
        raster.png(title, description)
    }

    fn all_points(&self) -> Vec<Point3d> {
        let positions = self.meshes.iter().flat_map(|mesh| &mesh.positions);
        positions.chain(self.lines.iter().flat_map(|line| &line.points)).copied().collect()
    }
}

/// The tolerance of meshes: a small part of the size of the surfaces.
fn tolerance<T, P>(surfaces: &[T]) -> f64
where
    T: Surface<Point = P>,
    P: Point3<Scalar = f64>,
{
    let mut points = Vec::new();
    for surface in surfaces {
        let [u, v] = surface.domain().ranges();
        for i in 0..=8 {
            for j in 0..=8 {
                points.push(components(surface.eval(at(u, i, 8), at(v, j, 8))));
            }
        }
    }
    let [low, high] = extent(&points);
    let size = (0..3).map(|c| (high[c] - low[c]).powi(2)).sum::<f64>().sqrt();
    if size > 0.0 && size.is_finite() { size / 5000.0 } else { 1e-3 }
}

/// A parallel projection that fits a set of points into the picture.
struct Camera {
    right: Point3d,
    up: Point3d,
    /// Towards the viewer.
    back: Point3d,
    scale: f64,
    centre: [f64; 2],
}

impl Camera {
    fn new(view: View, points: &[Point3d]) -> Self {
        let (azimuth, elevation) = (view.azimuth.to_radians(), view.elevation.to_radians());
        let back = [elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()];
        let right = [-azimuth.sin(), azimuth.cos(), 0.0];
        let up = [-elevation.sin() * azimuth.cos(), -elevation.sin() * azimuth.sin(), elevation.cos()];
        let mut camera = Self { right, up, back, scale: 1.0, centre: [0.0; 2] };
        let flat: Vec<Point3d> = points.iter().map(|&p| camera.turn(p)).collect();
        let [low, high] = extent(&flat);
        let fits = [0, 1].map(|k| {
            let extent = high[k] - low[k];
            let room = SIZE[k] as f64 * (1.0 - 2.0 * MARGIN);
            if extent > 0.0 { room / extent } else { f64::INFINITY }
        });
        let scale = fits[0].min(fits[1]);
        camera.scale = if scale.is_finite() { scale } else { 1.0 };
        camera.centre = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
        camera
    }

    /// In the directions of the picture.
    fn turn(&self, p: Point3d) -> Point3d {
        [self.right, self.up, self.back].map(|e| e[0] * p[0] + e[1] * p[1] + e[2] * p[2])
    }

    /// In pixels, with the depth.
    fn project(&self, p: Point3d) -> Point3d {
        let [x, y, z] = self.turn(p);
        [
            0.5 * SIZE[0] as f64 + (x - self.centre[0]) * self.scale,
            0.5 * SIZE[1] as f64 - (y - self.centre[1]) * self.scale,
            -z * self.scale,
        ]
    }
}

/// The smallest and the largest components.
fn extent(points: &[Point3d]) -> [Point3d; 2] {
    let extreme = |of: fn(f64, f64) -> f64, start: f64| {
        [0, 1, 2].map(|c| points.iter().map(|p| p[c]).filter(|c| c.is_finite()).fold(start, of))
    };
    if points.is_empty() {
        return [[0.0; 3]; 2];
    }
    [extreme(f64::min, f64::INFINITY), extreme(f64::max, f64::NEG_INFINITY)]
}

/// The step `k` of `count` through a range; exact at both ends.
fn at([lo, hi]: [f64; 2], k: usize, count: usize) -> f64 {
    let x = k as f64 / count as f64;
    lo * (1.0 - x) + hi * x
}

fn components<P: Point<Scalar = f64>>(point: P) -> Point3d {
    [0, 1, 2].map(|c| point.component(c))
}
