//! Triangle meshes of surfaces: within a tolerance, without cracks, consistently oriented.

mod cells;
mod error;
mod facets;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(feature = "obj")]
mod obj;
mod orient;
mod patch;
#[cfg(feature = "stl")]
mod stl;
mod tessellation;
mod weld;

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use crate::Scalar;
use crate::vector::{cross, dot, length};
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
    /// The parameters, scaled so that the domain of the surface is the unit square.
    pub uv: [S; 2],
    /// The number of the surface, in the order in which they were added.
    pub surface: u32,
}

/// A triangle mesh.
///
/// Connected surfaces share positions, so that the mesh has no cracks between them. All triangles of a connected part turn
/// the same way, if that is possible at all; those of a closed part turn counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mesh<S> {
    /// The positions, no two of them meant to be the same.
    pub positions: Vec<[S; 3]>,
    /// The vertices.
    pub vertices: Vec<Vertex<S>>,
    /// The triangles, as indices of vertices in counter-clockwise order.
    pub triangles: Vec<[u32; 3]>,
}

impl<S: Scalar> Mesh<S> {
    /// The indices of the three positions of a triangle.
    ///
    /// # Panics
    /// If an index of the triangle is none of a vertex.
    pub fn corners(&self, triangle: [u32; 3]) -> [u32; 3] {
        triangle.map(|vertex| self.vertices[vertex as usize].position)
    }

    fn corner_positions(&self, triangle: [u32; 3]) -> [[S; 3]; 3] {
        self.corners(triangle).map(|position| self.positions[position as usize])
    }

    /// The sum of the areas of all triangles.
    pub fn area(&self) -> S {
        self.triangles.iter().fold(S::ZERO, |sum, &t| sum + length(area_vector(self.corner_positions(t))))
    }

    /// The volume enclosed by a closed mesh; what it means for an open one depends on the origin.
    pub fn volume(&self) -> S {
        let sum = self.triangles.iter().fold(S::ZERO, |sum, &t| {
            let [a, b, c] = self.corner_positions(t);
            sum + dot(a, cross(b, c))
        });
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

    /// Whether every edge belongs to two triangles that go through it in opposite directions: the mesh is closed, without a
    /// crack, and consistently oriented.
    pub fn is_closed(&self) -> bool {
        self.edges().values().all(|&uses| uses == [1, 1])
    }

    /// Whether no edge is used twice in the same direction.
    pub fn is_oriented(&self) -> bool {
        self.edges().values().all(|uses| uses.iter().all(|&count| count <= 1))
    }

    /// How often triangles go through each edge, upwards and downwards in the index of the position.
    fn edges(&self) -> BTreeMap<[u32; 2], [u32; 2]> {
        let mut edges = BTreeMap::new();
        for &triangle in &self.triangles {
            let [a, b, c] = self.corners(triangle);
            for [from, to] in [[a, b], [b, c], [c, a]] {
                let uses: &mut [u32; 2] = edges.entry([from.min(to), from.max(to)]).or_default();
                uses[usize::from(from > to)] += 1;
            }
        }
        edges
    }
}

/// The normal of a triangle, as long as its area.
fn area_vector<S: Scalar>([a, b, c]: [[S; 3]; 3]) -> [S; 3] {
    let [x, y] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    cross(x, y).map(|component| component * S::of(0.5))
}
