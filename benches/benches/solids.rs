//! Rays through a torus beside curvo's, and meshes of a torus and a sphere beside those of curvo and truck:
//! `cargo bench -p basis-benches --bench solids`.
//!
//! Prints two tables in Markdown. The rays are random lines through a torus, of which the zeros of a polynomial of degree
//! four tell how often they meet it; right are the lines for which a library finds as many places. The meshes are compared
//! at one distance from the surface: ours is the tolerance that was asked for, the others have tolerances of normals and
//! of parts of the surface, and the coarsest mesh counts whose triangles are, at samples, not farther away than that.

use std::f64::consts::PI;
use std::time::{Duration, Instant};

use basis_runtime::bspline::{KnotVector, NurbsCurve, NurbsSurface};
use basis_runtime::{BoundedSurface, Tessellation};
use curvo::prelude::{
    AdaptiveTessellationOptions, Intersects, NurbsCurve3D, NurbsSurface3D, Tessellation as _,
};
use divan::black_box;
use nalgebra::{Point3, Vector3};
use truck_meshalgo::tessellation::{MeshableShape as _, MeshedShape as _};
use truck_modeling::{Rad, Shell, Wire, builder};

type P3 = [f64; 3];

/// Both radii of the torus.
const RADII: [f64; 2] = [2.0, 1.0];

const LINES: u32 = 1000;

fn main() {
    let (ours, curvos) = (torus(), curvo_torus());
    println!("| {LINES} lines and a torus | right | µs for a line |");
    println!("| --- | --- | --- |");
    let lines: Vec<[P3; 2]> = (0..LINES).map(line).collect();
    let count = |[start, end]: [P3; 2]| {
        let along = [0, 1, 2].map(|d| end[d] - start[d]);
        ours.ray_intersections(start, along, 1e-9).map_or(0, |all| all.iter().filter(|m| m.at <= 1.0).count())
    };
    row("ours", &lines, count);
    let count = |[start, end]: [P3; 2]| {
        let line = NurbsCurve3D::polyline(&[Point3::from(start), Point3::from(end)], false);
        curvos.find_intersection(&line, None).map_or(0, |all| all.len())
    };
    row("curvo", &lines, count);

    println!("\n| surface, within | triangles, ours | ms | triangles, curvo | ms | triangles, truck | ms |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let (ball, curvos_ball) = (sphere(), curvo_sphere());
    for tolerance in [1e-1, 1e-2, 1e-3] {
        meshes("torus", tolerance, [&ours, &curvos, &truck_torus()], distance);
        meshes("sphere", tolerance, [&ball, &curvos_ball, &truck_sphere()], |[x, y, z]| {
            (x.hypot(y).hypot(z) - 1.0).abs()
        });
    }
}

/// A surface that a library meshes with a tolerance of its own: all triangles.
trait Meshed {
    fn mesh(&self, tolerance: f64) -> Vec<[P3; 3]>;
}

impl Meshed for NurbsSurface<P3> {
    fn mesh(&self, tolerance: f64) -> Vec<[P3; 3]> {
        let mesh = Tessellation::new(tolerance).and_then(|all| all.with(self).mesh()).expect("it has a mesh");
        mesh.triangles
            .iter()
            .filter_map(|&triangle| mesh.corners(triangle))
            .map(|corners| corners.map(|k| mesh.positions[k as usize]))
            .collect()
    }
}

impl Meshed for NurbsSurface3D<f64> {
    fn mesh(&self, tolerance: f64) -> Vec<[P3; 3]> {
        let options =
            AdaptiveTessellationOptions::<f64>::default().with_norm_tolerance(tolerance).with_max_depth(20);
        let mesh = self.tessellate(Some(options));
        let corner = |k: usize| <[f64; 3]>::from(mesh.points()[k].coords);
        mesh.faces().iter().map(|face| face.map(corner)).collect()
    }
}

impl Meshed for Shell {
    fn mesh(&self, tolerance: f64) -> Vec<[P3; 3]> {
        let mesh = self.triangulation(tolerance).to_polygon();
        let corner = |k: usize| Into::<[f64; 3]>::into(mesh.positions()[k]);
        mesh.faces().triangle_iter().map(|face| face.map(|vertex| corner(vertex.pos))).collect()
    }
}

/// A row: of ours, curvo's and truck's the triangles and milliseconds.
fn meshes(name: &str, tolerance: f64, surfaces: [&dyn Meshed; 3], distance: impl Fn(P3) -> f64) {
    let mut row = format!("| {name}, {tolerance} |");
    for (index, surface) in surfaces.into_iter().enumerate() {
        let mut own = if index == 0 { tolerance } else { 1.0 };
        let found = loop {
            let triangles = surface.mesh(own);
            if triangles.iter().all(|&triangle| farthest(triangle, &distance) <= tolerance) {
                break Some(timed(|| surface.mesh(own)));
            }
            own *= 0.8;
            if own < 1e-3 * tolerance {
                break None;
            }
        };
        row += &match found {
            Some((triangles, time)) => format!(" {} | {:.2} |", triangles.len(), 1e3 * time.as_secs_f64()),
            None => " never | |".to_owned(),
        };
    }
    println!("{row}");
}

fn truck_torus() -> Shell {
    let vertex = builder::vertex(truck_modeling::Point3::new(RADII[0] + RADII[1], 0.0, 0.0));
    let middle = truck_modeling::Point3::new(RADII[0], 0.0, 0.0);
    let circle = builder::rsweep(&vertex, middle, truck_modeling::Vector3::unit_y(), Rad(7.0));
    let middle = truck_modeling::Point3::new(0.0, 0.0, 0.0);
    builder::rsweep(&circle, middle, truck_modeling::Vector3::unit_z(), Rad(7.0))
}

fn truck_sphere() -> Shell {
    let [low, high] = [-1.0, 1.0].map(|z| builder::vertex(truck_modeling::Point3::new(0.0, 0.0, z)));
    let arc = builder::circle_arc(&low, &high, truck_modeling::Point3::new(1.0, 0.0, 0.0));
    builder::cone(&Wire::from(vec![arc]), truck_modeling::Vector3::unit_z(), Rad(7.0))
}

fn sphere() -> NurbsSurface<P3> {
    let h = 0.5_f64.sqrt();
    let points = vec![[0.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]];
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0]).expect("increasing");
    let arc = NurbsCurve::new(knots, points, [1.0, h, 1.0, h, 1.0]).expect("five points");
    NurbsSurface::revolved(&arc, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).expect("an axis")
}

fn curvo_sphere() -> NurbsSurface3D<f64> {
    NurbsSurface3D::try_sphere(&Point3::origin(), &Vector3::z(), &Vector3::x(), 1.0).expect("a sphere")
}

fn torus() -> NurbsSurface<P3> {
    let h = 0.5_f64.sqrt();
    let corners = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]];
    let points: Vec<P3> = corners
        .iter()
        .map(|&[x, z]| [RADII[0] + RADII[1] * f64::from(x), 0.0, RADII[1] * f64::from(z)])
        .collect();
    let knots = KnotVector::clamped(2, &[0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0]).expect("increasing");
    let circle = NurbsCurve::new(knots, points, [1.0, h, 1.0, h, 1.0, h, 1.0, h, 1.0]).expect("nine points");
    NurbsSurface::revolved(&circle, [0.0; 3], [0.0, 0.0, 1.0], 2.0 * PI).expect("an axis")
}

fn curvo_torus() -> NurbsSurface3D<f64> {
    let all = (0.0, 2.0 * PI);
    NurbsSurface3D::try_torus(&Point3::origin(), &Vector3::x(), &Vector3::y(), RADII[0], RADII[1], all, all)
        .expect("a torus")
}

/// A segment through the middle of the torus' box, spread by irrational numbers.
fn line(k: u32) -> [P3; 2] {
    let spread = |n: u32| {
        let step = [0.618_033_988_749_895, 0.414_213_562_373_095, 0.732_050_807_568_877][n as usize % 3];
        (f64::from(k + 1) * step * f64::from(n + 1)).fract()
    };
    let middle = [0, 1, 2].map(|d| 3.0 * (2.0 * spread(d) - 1.0) / if d == 2 { 3.0 } else { 1.0 });
    let angle = 2.0 * PI * spread(3);
    let z = 2.0 * spread(4) - 1.0;
    let r = (1.0 - z * z).sqrt();
    let along = [8.0 * r * angle.cos(), 8.0 * r * angle.sin(), 8.0 * z];
    [-1.0, 1.0].map(|side| [0, 1, 2].map(|d| middle[d] + side * along[d]))
}

fn distance([x, y, z]: P3) -> f64 {
    ((x.hypot(y) - RADII[0]).hypot(z) - RADII[1]).abs()
}

/// How often a segment meets the torus, from changes of sign at many samples; `None` if it almost touches it.
fn expected([start, end]: [P3; 2]) -> Option<usize> {
    let height = |k: u32| {
        let [x, y, z] = [0, 1, 2].map(|d| start[d] + (end[d] - start[d]) * f64::from(k) / 20_000.0);
        (x.hypot(y) - RADII[0]).hypot(z) - RADII[1]
    };
    let heights: Vec<f64> = (0..=20_000).map(height).collect();
    let touches = heights.windows(3).any(|h| h[1].abs() < 1e-5 && (h[1] - h[0]) * (h[2] - h[1]) <= 0.0);
    (!touches).then(|| heights.windows(2).filter(|h| (h[0] > 0.0) != (h[1] > 0.0)).count())
}

fn row(name: &str, lines: &[[P3; 2]], count: impl Fn([P3; 2]) -> usize) {
    let (found, time) = timed(|| lines.iter().map(|&line| count(line)).collect::<Vec<usize>>());
    let known = lines.iter().zip(found).filter_map(|(&line, found)| Some((expected(line)?, found)));
    let (mut all, mut right) = (0, 0);
    for (expected, found) in known {
        all += 1;
        right += usize::from(expected == found);
    }
    println!("| {name} | {right} of {all} | {:.1} |", 1e6 * time.as_secs_f64() / f64::from(LINES));
}

/// The result, and the shortest of three times.
fn timed<T>(work: impl Fn() -> T) -> (T, Duration) {
    let mut best = Duration::MAX;
    for _ in 0..2 {
        let start = Instant::now();
        black_box(work());
        best = best.min(start.elapsed());
    }
    let start = Instant::now();
    let result = work();
    (result, best.min(start.elapsed()))
}

/// The largest distance of a triangle from the surface, at samples.
fn farthest([a, b, c]: [P3; 3], distance: impl Fn(P3) -> f64) -> f64 {
    let mut farthest = 0.0_f64;
    for i in 0..=4 {
        for j in 0..=4 - i {
            let weights = [i, j, 4 - i - j].map(|k| f64::from(k) / 4.0);
            let point = [0, 1, 2].map(|d| weights[0] * a[d] + weights[1] * b[d] + weights[2] * c[d]);
            farthest = farthest.max(distance(point));
        }
    }
    farthest
}
