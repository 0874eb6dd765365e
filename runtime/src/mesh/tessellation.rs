//! From surfaces to one mesh.

use alloc::boxed::Box;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec::Vec;

use super::cut::cells::{Cells, Leaf, Sheet, is_crowded, on_edge, unit};
use super::cut::facets::Node;
use super::cut::facets::{Cut, triangles};
use super::cut::index::Index;
use super::cut::limits::Limits;
use super::cut::lines::WIDTH;
use super::meet::meet;
use super::orient::orient;
use super::patch::Patch;
use super::weld::{self, Classes, Seam};
use super::{Mesh, MeshError, Vertex, area_vector, sixfold_volume};
use crate::vector::{direction, distance, largest_component, safe_unit};
use crate::{BoundedSurface, Edge, Point3, Scalar, Surface};

/// Surfaces that become one mesh.
///
/// Every point of a triangle is nearer to its surface than the tolerance, and every point of a surface nearer than that
/// to the mesh; this is proved from the control points over each part ([`BoundedSurface`]) and not only tested at
/// samples. The distance is that of points, whatever the parameters: flat regions need few triangles, also where the
/// parameters are uneven, and a cylinder is cut around but not along its axis.
///
/// Two edges that run along each other become a seam, whatever their parameters and directions, and also where a long
/// edge meets several short ones; so do both ends of a surface that closes on itself. The triangles on both sides share
/// their positions, and turn the same way. Edges belong together where they are no farther apart than 1/16 of the
/// tolerance; of a pile of edges that near to each other, only those are joined for which no position moves by more
/// than 1/8 of the tolerance. An edge that is one point becomes one position, with the normals of all directions. Where
/// joining would leave a part of a surface without triangles, it is done again with less.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use basis_runtime::{Curve, SurfaceOfRevolution, Tessellation};
///
/// let arc = Curve::new(QuarticBernstein::new(0.5)?, [[-1.0, 0.0], [-1.0, 1.0], [1.0, 1.0], [1.0, 0.0]]);
/// let egg = SurfaceOfRevolution::about_x(&arc, 2.0 * std::f64::consts::PI)?;
/// let mesh = Tessellation::new(0.01)?.with(&egg).mesh()?;
/// assert!(mesh.is_closed());
/// assert!(mesh.volume() > 2.5);
/// # Ok(())
/// # }
/// ```
pub struct Tessellation<'a, S> {
    tolerance: S,
    longest_edge: S,
    largest_angle: S,
    largest_aspect: S,
    patches: Vec<Box<dyn Patch<S> + 'a>>,
}

/// How often edges are joined again, with a quarter of the distance each time.
const ROUNDS: usize = 4;

impl<'a, S: Scalar> Tessellation<'a, S> {
    /// No surfaces yet; the tolerance is the largest distance of the mesh from the surfaces, both ways, in the unit of
    /// length.
    ///
    /// # Errors
    /// When the tolerance is not positive and finite.
    pub fn new(tolerance: S) -> Result<Self, MeshError> {
        if tolerance > S::ZERO && tolerance.is_finite() {
            let [longest_edge, largest_angle, largest_aspect] = [S::INFINITY; 3];
            Ok(Self { tolerance, longest_edge, largest_angle, largest_aspect, patches: Vec::new() })
        } else {
            Err(MeshError::Tolerance { value: tolerance.to_f64() })
        }
    }

    /// With triangles whose sides are no longer than this, but for diagonals, which are no longer than twice as much.
    ///
    /// # Errors
    /// When the length is not positive.
    pub fn longest_edge(mut self, length: S) -> Result<Self, MeshError> {
        if length <= S::ZERO || length.is_nan() {
            return Err(MeshError::Limit { value: length.to_f64() });
        }
        self.longest_edge = length;
        Ok(self)
    }

    /// With triangles at whose corners the normals of the surface differ by no more than this angle in radians along
    /// each side, for smooth shading.
    ///
    /// # Errors
    /// When the angle is not positive.
    pub fn largest_angle(mut self, angle: S) -> Result<Self, MeshError> {
        if angle <= S::ZERO || angle.is_nan() {
            return Err(MeshError::Limit { value: angle.to_f64() });
        }
        self.largest_angle = angle;
        Ok(self)
    }

    /// With triangles from rectangles whose longer sides are no more than that many times as long as the shorter ones, but
    /// for those with a side that is one point. Without it, flat directions are not cut: a cylinder is cut into strips.
    ///
    /// # Errors
    /// When the quotient is less than 2, or NaN.
    pub fn largest_aspect(mut self, aspect: S) -> Result<Self, MeshError> {
        if aspect.is_nan() || aspect < S::of(2.0) {
            return Err(MeshError::Aspect { value: aspect.to_f64() });
        }
        self.largest_aspect = aspect;
        Ok(self)
    }

    /// With one surface more, also a `dyn BoundedSurface`.
    ///
    /// ```
    /// use basis_runtime::{Bezier, BoundedSurface, SurfaceOfRevolution, Tessellation};
    ///
    /// let turned = |from, to| SurfaceOfRevolution::about_x(&Bezier::from_points([from, to]), 6.0);
    /// let cup: [Box<dyn BoundedSurface<Point = [f64; 3]>>; 2] =
    ///     [Box::new(turned([0.0, 0.0], [0.0, 1.0])?), Box::new(turned([0.0, 1.0], [2.0, 1.5])?)];
    /// let mesh = cup.iter().fold(Tessellation::new(0.01)?, |all, surface| all.with(surface)).mesh()?;
    /// assert!(mesh.is_oriented());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with<T, P>(mut self, surface: &'a T) -> Self
    where
        T: BoundedSurface + Surface<Point = P> + ?Sized,
        P: Point3<Scalar = S>,
    {
        self.patches.push(Box::new(surface));
        self
    }

    /// The mesh of all surfaces; empty without any.
    ///
    /// # Errors
    /// When a surface is infinite or NaN, when it is a curve or a point, as a whole or in part, so that no triangles
    /// can stand for it, or when the tolerance is so small that a surface would need millions of triangles.
    pub fn mesh(&self) -> Result<Mesh<S>, MeshError> {
        // What the seams take of the tolerance is left to them: positions that become one are nowhere farther than that
        // from it.
        let mut weld = self.tolerance * S::of(0.0625);
        let mut lost = 0;
        for _ in 0..ROUNDS {
            match self.welded(weld)? {
                Ok(mesh) => return Ok(mesh),
                Err(surface) => lost = surface,
            }
            weld = weld * S::of(0.25);
        }
        Err(MeshError::Collapsed { surface: lost })
    }

    /// The mesh with edges joined that are no farther apart than that; or the first surface of which a part is left
    /// without triangles.
    fn welded(&self, weld: S) -> Result<Result<Mesh<S>, usize>, MeshError> {
        let reach = weld + weld;
        let patches: &[&dyn Patch<S>] = &self.patches.iter().map(|patch| &**patch as _).collect::<Vec<_>>();
        let limits = Limits {
            tolerance: self.tolerance.to_f64(),
            reach: reach.to_f64(),
            weld: weld.to_f64(),
            edge: self.longest_edge.to_f64(),
            angle: self.largest_angle.to_f64(),
            aspect: self.largest_aspect.to_f64(),
        };
        let sheets: Vec<Sheet<'_, S>> =
            patches.iter().enumerate().map(|(k, patch)| Sheet::new(*patch, k, limits)).collect();
        let mut cells = Vec::with_capacity(patches.len());
        for sheet in &sheets {
            cells.push(Cells::new(sheet)?);
        }
        let found = weld::find(patches, weld);
        // Until no rectangle is moved too far by the corners of its neighbours.
        let met = loop {
            share_parameters(&mut cells, &found.seams);
            let met = meet(patches, &mut cells, &found, self.tolerance, weld);
            share_parameters(&mut cells, &found.seams);
            let mut changed = false;
            for (sheet, cells) in sheets.iter().zip(&mut cells) {
                while cells.refine(sheet)? {
                    changed = true;
                }
            }
            if !changed {
                break met;
            }
        };

        let mut builder = Builder::default();
        for (surface, (patch, cells)) in patches.iter().zip(&cells).enumerate() {
            builder.facets(surface, *patch, cells, reach)?;
        }
        let mut classes = Classes::new(builder.points.len(), reach);
        for seam in &found.seams {
            let [a, b] = seam.sides;
            for &along in cells[a.surface].edge(a.edge).iter() {
                let other = on_edge(b.edge, seam.across(along));
                builder.join(&mut classes, (a.surface, on_edge(a.edge, along)), (b.surface, other));
            }
        }
        for pole in &found.poles {
            for &along in cells[pole.surface].edge(pole.edge).iter() {
                let first = (pole.surface, on_edge(pole.edge, 0));
                builder.join(&mut classes, first, (pole.surface, on_edge(pole.edge, along)));
            }
        }
        for [a, b] in met {
            builder.join(&mut classes, a, b);
        }
        builder.join_corners(&mut classes, patches.len(), weld);
        let mut mesh = match builder.finish(&mut classes) {
            Ok(mesh) => mesh,
            Err(surface) => return Ok(Err(surface)),
        };
        turn(&mut mesh, patches.len());
        shade(&mut mesh);
        Ok(Ok(mesh))
    }
}

/// Both sides of a seam get the parameters of both, until nothing changes: several surfaces may share a seam.
fn share_parameters(cells: &mut [Cells], seams: &[Seam]) {
    let mut changed = true;
    while changed {
        changed = false;
        for seam in seams {
            let [a, b] = seam.sides;
            let [on_a, on_b] = [a, b].map(|side| {
                cells[side.surface]
                    .edge(side.edge)
                    .iter()
                    .map(|&along| seam.across(along))
                    .collect::<Vec<u32>>()
            });
            for along in on_b {
                changed |= cells[a.surface].edge(a.edge).insert(along);
            }
            for along in on_a {
                changed |= cells[b.surface].edge(b.edge).insert(along);
            }
        }
    }
}

/// The vertices and triangles of all surfaces, each vertex still with a position of its own.
struct Builder<S> {
    points: Vec<[S; 3]>,
    vertices: Vec<Vertex<S>>,
    /// The vertices of each surface.
    index: Vec<Index<u32>>,
    triangles: Vec<[u32; 3]>,
}

impl<S> Default for Builder<S> {
    fn default() -> Self {
        Self { points: Vec::new(), vertices: Vec::new(), index: Vec::new(), triangles: Vec::new() }
    }
}

impl<S: Scalar> Builder<S> {
    fn facets(
        &mut self,
        surface: usize,
        patch: &dyn Patch<S>,
        cells: &Cells,
        reach: S,
    ) -> Result<(), MeshError> {
        let mut finite = true;
        let (mut known, mut corners): (Vec<u32>, Vec<[S; 3]>) = (Vec::new(), Vec::new());
        self.index.resize_with(surface + 1, Index::default);
        for &Leaf { cell, .. } in &cells.leaves {
            let nodes = cells.around(cell);
            known.clear();
            known.extend(nodes.iter().map(|&node| self.vertex(surface, patch, node)));
            corners.clear();
            corners.extend(known.iter().map(|&vertex| self.points[vertex as usize]));
            let cut = if is_crowded(&corners, reach) { Cut::Middle } else { Cut::Shortest };
            let shorter = || distance(corners[0], corners[2]) <= distance(corners[1], corners[3]);
            triangles(cell, &nodes, cut, shorter, |triangle| {
                let triangle = triangle.map(|node| match nodes.iter().position(|&other| other == node) {
                    Some(k) => known[k],
                    None => self.vertex(surface, patch, node),
                });
                finite &= triangle.iter().all(|&v| self.points[v as usize].iter().all(|c| c.is_finite()));
                self.triangles.push(triangle);
            });
        }
        if finite { Ok(()) } else { Err(MeshError::NotFinite { surface }) }
    }

    fn vertex(&mut self, surface: usize, patch: &dyn Patch<S>, node: Node) -> u32 {
        if let Some(vertex) = self.index[surface].get(node) {
            return vertex;
        }
        let place = node.map(unit);
        let vertex = self.vertices.len() as u32;
        self.points.push(patch.point(place));
        let normal = patch.normal(place).unwrap_or([S::ZERO; 3]);
        self.vertices.push(Vertex { position: vertex, normal, uv: patch.uv(place), surface: surface as u32 });
        self.index[surface].insert(node, vertex);
        vertex
    }

    fn known(&self, (surface, node): (usize, Node)) -> Option<u32> {
        self.index.get(surface)?.get(node)
    }

    fn join(&self, classes: &mut Classes<S>, a: (usize, Node), b: (usize, Node)) {
        if let (Some(a), Some(b)) = (self.known(a), self.known(b)) {
            classes.join(&self.points, a as usize, b as usize);
        }
    }

    /// Corners of surfaces at one place are one position, also where only corners or poles meet.
    fn join_corners(&self, classes: &mut Classes<S>, surfaces: usize, tolerance: S) {
        let mut corners: Vec<usize> = (0..surfaces)
            .flat_map(|surface| {
                [Edge::VStart, Edge::VEnd]
                    .into_iter()
                    .flat_map(move |edge| [0, WIDTH].map(move |along| (surface, on_edge(edge, along))))
            })
            .filter_map(|key| self.known(key).map(|v| v as usize))
            .collect();
        corners.sort_by(|&a, &b| {
            self.points[a][0].partial_cmp(&self.points[b][0]).unwrap_or(core::cmp::Ordering::Equal)
        });
        for (k, &a) in corners.iter().enumerate() {
            let reach = self.points[a][0] + tolerance;
            for &b in corners[k + 1..].iter().take_while(|&&b| self.points[b][0] <= reach) {
                if distance(self.points[a], self.points[b]) <= tolerance {
                    classes.join(&self.points, a, b);
                }
            }
        }
    }

    /// Numbers the positions and leaves out triangles that have become edges or points. If nothing else stands for such
    /// a triangle, the surface that has lost it.
    fn finish(self, classes: &mut Classes<S>) -> Result<Mesh<S>, usize> {
        let mut positions = Vec::new();
        let mut number = alloc::vec![0_u32; self.points.len()];
        let mut vertices = self.vertices;
        for (k, vertex) in vertices.iter_mut().enumerate() {
            let class = classes.find(k);
            if class == k {
                number[k] = positions.len() as u32;
                positions.push(self.points[k]);
            }
            // A class is known by its smallest member, which has its number already.
            vertex.position = number[class];
        }
        let mut mesh = Mesh { positions, vertices, triangles: Vec::with_capacity(self.triangles.len()) };
        let mut lost = Vec::new();
        for triangle in self.triangles {
            let Some([a, b, c]) = mesh.corners(triangle) else { continue };
            if a != b && b != c && c != a {
                mesh.triangles.push(triangle);
            } else {
                lost.push((triangle[0], [a.min(b).min(c), a.max(b).max(c)]));
            }
        }
        if let Some(surface) = missing(&mesh, &lost) {
            return Err(surface);
        }
        // A surface that is a curve has triangles without area; beside the squares of their sides that is rounding.
        let mut areas: BTreeMap<u32, [S; 2]> = BTreeMap::new();
        let unit = unit_of(&mesh);
        for &triangle in &mesh.triangles {
            let Some([a, b, c]) = measured_in(unit, &mesh, triangle) else { continue };
            let sums = areas.entry(mesh.vertices[triangle[0] as usize].surface).or_insert([S::ZERO; 2]);
            let sides = [[a, b], [b, c], [c, a]].map(|[from, to]| distance(from, to));
            let area = area_vector([a, b, c]);
            sums[0] = sums[0] + distance(area, [S::ZERO; 3]);
            sums[1] = sides.iter().fold(sums[1], |sum, &side| sum + side * side);
        }
        match areas.iter().find(|(_, [area, squares])| *area <= S::of(4.0) * S::EPSILON * *squares) {
            Some((&surface, _)) => Err(surface as usize),
            None => Ok(mesh),
        }
    }
}

/// The surface of the first lost triangle for which nothing stands: each is given by a vertex and by both ends of the
/// edge that it has become, or twice the point.
fn missing<S: Scalar>(mesh: &Mesh<S>, lost: &[(u32, [u32; 2])]) -> Option<usize> {
    if lost.is_empty() {
        return None;
    }
    let mut of_lost = alloc::vec![false; mesh.positions.len()];
    for end in lost.iter().flat_map(|(_, ends)| ends) {
        of_lost[*end as usize] = true;
    }
    let sides = mesh.triangles.iter().filter_map(|&triangle| mesh.corners(triangle));
    let sides = sides.flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]]);
    let (mut kept, mut used) = (BTreeSet::new(), BTreeSet::new());
    for [a, b] in sides.filter(|side| side.iter().any(|&end| of_lost[end as usize])) {
        kept.insert([a.min(b), a.max(b)]);
        used.extend([a, b]);
    }
    // What has become an edge must be one of a triangle, what has become a point must be a corner.
    let stands = |[a, b]: [u32; 2]| if a == b { used.contains(&a) } else { kept.contains(&[a, b]) };
    let (vertex, _) = lost.iter().find(|(_, ends)| !stands(*ends))?;
    Some(mesh.vertices[*vertex as usize].surface as usize)
}

/// A unit of length in which areas and volumes neither overflow nor vanish.
fn unit_of<S: Scalar>(mesh: &Mesh<S>) -> S {
    safe_unit(mesh.positions.iter().map(|&p| largest_component(p)).fold(S::ZERO, S::max), 2)
}

/// The corners of a triangle in that unit.
fn measured_in<S: Scalar>(unit: S, mesh: &Mesh<S>, triangle: [u32; 3]) -> Option<[[S; 3]; 3]> {
    Some(mesh.corner_positions(triangle)?.map(|corner| corner.map(|x| x / unit)))
}

/// Turns surfaces over so that neighbours agree and closed parts face outwards.
fn turn<S: Scalar>(mesh: &mut Mesh<S>, surfaces: usize) {
    let orientation = orient(surfaces, mesh);
    let mut flipped = orientation.flipped;
    flip(mesh, &flipped);

    let mut volumes = alloc::vec![S::ZERO; surfaces];
    // Measured from a point of each part, which may be far from the origin.
    let mut tips = alloc::vec![None; surfaces];
    let unit = unit_of(mesh);
    for &triangle in &mesh.triangles {
        let component = orientation.component[mesh.vertices[triangle[0] as usize].surface as usize];
        let Some(corners) = measured_in(unit, mesh, triangle) else { continue };
        let tip = *tips[component].get_or_insert(corners[0]);
        volumes[component] = volumes[component] + sixfold_volume(corners, tip);
    }
    let mut open = alloc::vec![false; surfaces];
    let mut component_of = alloc::vec![0; mesh.positions.len()];
    for vertex in &mesh.vertices {
        component_of[vertex.position as usize] = orientation.component[vertex.surface as usize];
    }
    for [from, _] in mesh.boundary() {
        open[component_of[from as usize]] = true;
    }
    for (surface, turn) in flipped.iter_mut().enumerate() {
        let component = orientation.component[surface];
        *turn = !open[component] && volumes[component] < S::ZERO;
    }
    flip(mesh, &flipped);
}

/// Turns the triangles and normals of the surfaces over that are marked.
fn flip<S: Scalar>(mesh: &mut Mesh<S>, marked: &[bool]) {
    for triangle in &mut mesh.triangles {
        if marked[mesh.vertices[triangle[0] as usize].surface as usize] {
            triangle.swap(1, 2);
        }
    }
    for vertex in &mut mesh.vertices {
        if marked[vertex.surface as usize] {
            vertex.normal = vertex.normal.map(|c| -c);
        }
    }
}

/// Where the surface has no normal the triangles of the vertex decide, by their areas.
fn shade<S: Scalar>(mesh: &mut Mesh<S>) {
    let mut sums: BTreeMap<u32, [S; 3]> = BTreeMap::new();
    let unit = unit_of(mesh);
    for &triangle in &mesh.triangles {
        for vertex in triangle {
            if mesh.vertices[vertex as usize].normal == [S::ZERO; 3] {
                let Some(corners) = measured_in(unit, mesh, triangle) else { continue };
                let area = area_vector(corners);
                let sum = sums.entry(vertex).or_insert([S::ZERO; 3]);
                *sum = [0, 1, 2].map(|c| sum[c] + area[c]);
            }
        }
    }
    for (vertex, sum) in sums {
        mesh.vertices[vertex as usize].normal = direction(sum).unwrap_or([S::ZERO; 3]);
    }
}
