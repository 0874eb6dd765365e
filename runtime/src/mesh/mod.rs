//! Triangle meshes of surfaces: within a tolerance, without cracks, and consistently oriented wherever that is possible.
//! It is not on a Möbius strip, nor where a surface comes back to an edge of its own triangles from the other side, as a
//! bow tie in a plane does at its middle: such a mesh is no error, and [`Mesh::is_oriented`] says it.

mod cut;
mod error;
mod files;
mod meet;
mod orient;
mod patch;
mod tessellation;
mod weld;

use alloc::vec::Vec;

use crate::vector::{cross, dot, length};
use crate::{Point, Scalar};
pub use error::MeshError;
pub use tessellation::Tessellation;

/// A corner of triangles: a position, with the normal and the parameters that it has on one surface.
///
/// Several vertices share a position where surfaces meet, where a surface closes on itself, and at poles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vertex<S> {
    /// The index of its position in [`Mesh::positions`].
    pub position: u32,
    /// The unit normal, towards the side from which the triangles turn counter-clockwise; zero if all triangles of the
    /// vertex have no area.
    pub normal: [S; 3],
    /// The parameters, scaled so that the domain of the surface is the unit square; over a triangle as they are.
    pub uv: [S; 2],
    /// The number of the surface, in the order in which they were added.
    pub surface: u32,
}

/// A triangle mesh.
///
/// Connected surfaces share positions, so that the mesh has no cracks between them. All triangles of a connected part
/// turn the same way, if that is possible at all; those of a closed part turn counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialize::mesh::Parts<S>",
        bound(serialize = "S: serde::Serialize", deserialize = "S: Scalar + serde::Deserialize<'de>")
    )
)]
pub struct Mesh<S> {
    /// The positions, no two of them meant to be the same.
    pub positions: Vec<[S; 3]>,
    /// The vertices.
    pub vertices: Vec<Vertex<S>>,
    /// The triangles, as indices of vertices in counter-clockwise order.
    pub triangles: Vec<[u32; 3]>,
}

impl<S: Scalar> Mesh<S> {
    /// Whether all indices are those of vertices and positions, as in every mesh of a [`Tessellation`]. What asks for
    /// triangles leaves out those that are not; what writes a file refuses the mesh.
    ///
    /// # Errors
    /// [`MeshError::Index`] with the first triangle or vertex that is not.
    pub fn check(&self) -> Result<(), MeshError> {
        let fits = |index: u32, len: usize| usize::try_from(index).is_ok_and(|index| index < len);
        let (positions, vertices) = (self.positions.len(), self.vertices.len());
        let vertex = self.vertices.iter().position(|vertex| !fits(vertex.position, positions));
        let triangle = self.triangles.iter().position(|t| t.iter().any(|&vertex| !fits(vertex, vertices)));
        match (vertex, triangle) {
            (None, None) => Ok(()),
            (vertex, triangle) => Err(MeshError::Index { vertex, triangle }),
        }
    }

    /// The indices of the three positions of a triangle; `None` if the triangle has an index without a vertex.
    pub fn corners(&self, triangle: [u32; 3]) -> Option<[u32; 3]> {
        let [a, b, c] = triangle.map(|vertex| Some(self.vertices.get(vertex as usize)?.position));
        Some([a?, b?, c?])
    }

    /// The positions as files hold them; [`MeshError::Single`] with the first that is too large.
    #[cfg(any(feature = "gltf", feature = "stl"))]
    fn single_positions(&self) -> Result<Vec<[f32; 3]>, MeshError> {
        let single = self.positions.iter().map(|p| p.map(|c| c.to_f64() as f32));
        single
            .enumerate()
            .map(
                |(position, p)| {
                    if crate::vector::is_finite(p) { Ok(p) } else { Err(MeshError::Single { position }) }
                },
            )
            .collect()
    }

    fn corner_positions(&self, triangle: [u32; 3]) -> Option<[[S; 3]; 3]> {
        let [a, b, c] = self.corners(triangle)?.map(|position| self.positions.get(position as usize));
        Some([*a?, *b?, *c?])
    }

    /// The corners of all triangles.
    fn all_corner_positions(&self) -> impl Iterator<Item = [[S; 3]; 3]> {
        self.triangles.iter().filter_map(|&triangle| self.corner_positions(triangle))
    }

    /// The sum of the areas of all triangles.
    pub fn area(&self) -> S {
        self.all_corner_positions().fold(S::ZERO, |sum, corners| sum + length(area_vector(corners)))
    }

    /// The volume enclosed by a closed mesh; of an open one, of the cone over it whose tip is its first position.
    pub fn volume(&self) -> S {
        // From a point of the mesh: from the origin, far away, there would be little left of the sum.
        let Some(&tip) = self.positions.first() else { return S::ZERO };
        let sum =
            self.all_corner_positions().fold(S::ZERO, |sum, corners| sum + sixfold_volume(corners, tip));
        sum / S::of(6.0)
    }

    /// The edges that belong to one triangle only, as pairs of positions in the order of the triangle: the boundary.
    pub fn boundary(&self) -> Vec<[u32; 2]> {
        self.edges()
            .into_iter()
            .filter(|(_, uses)| uses.iter().sum::<u32>() == 1)
            .map(|(e, uses)| if uses[0] == 1 { e } else { [e[1], e[0]] })
            .collect()
    }

    /// Whether every edge belongs to two triangles that go through it in opposite directions: the mesh is closed,
    /// without a crack, and consistently oriented.
    pub fn is_closed(&self) -> bool {
        self.edges().iter().all(|&(_, uses)| uses == [1, 1])
    }

    /// Whether no edge is used twice in the same direction. Not of a Möbius strip, nor of a surface that folds through
    /// itself along an edge.
    pub fn is_oriented(&self) -> bool {
        self.edges().iter().all(|(_, uses)| uses.iter().all(|&count| count <= 1))
    }

    /// How often triangles go through each edge, upwards and downwards in the index of the position.
    fn edges(&self) -> Vec<([u32; 2], [u32; 2])> {
        let mut sides: Vec<([u32; 2], bool)> = Vec::with_capacity(3 * self.triangles.len());
        for &triangle in &self.triangles {
            let Some([a, b, c]) = self.corners(triangle) else { continue };
            let all = [[a, b], [b, c], [c, a]];
            sides.extend(all.map(|[from, to]| ([from.min(to), from.max(to)], from > to)));
        }
        sides.sort_unstable();
        let uses = |along: &[([u32; 2], bool)]| {
            let downwards = along.iter().filter(|(_, is_down)| *is_down).count();
            (along[0].0, [along.len() - downwards, downwards].map(|count| count as u32))
        };
        sides.chunk_by(|a, b| a.0 == b.0).map(uses).collect()
    }
}

/// The normal of a triangle, as long as its area.
fn area_vector<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> [S; 3] {
    let [x, y] = [b, c].map(|p| p.minus(a));
    cross(x, y).map(|component| component * S::of(0.5))
}

/// Six times the volume of the tetrahedron between a triangle and a point, positive if the triangle turns
/// counter-clockwise seen from the other side.
fn sixfold_volume<S: Scalar>(corners: [[S; 3]; 3], tip: [S; 3]) -> S {
    let [a, b, c] = corners.map(|p| p.minus(tip));
    dot(a, cross(b, c))
}
