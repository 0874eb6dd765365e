//! Meshes as they are written; what is read has to have valid indices.

use alloc::vec::Vec;

use serde::Deserialize;

use crate::{Mesh, MeshError, Scalar, Vertex};

#[derive(Deserialize)]
#[serde(rename = "Mesh", expecting = "struct Mesh")]
pub(crate) struct Parts<S> {
    positions: Vec<[S; 3]>,
    vertices: Vec<Vertex<S>>,
    triangles: Vec<[u32; 3]>,
}

impl<S: Scalar> TryFrom<Parts<S>> for Mesh<S> {
    type Error = MeshError;

    fn try_from(read: Parts<S>) -> Result<Self, MeshError> {
        let mesh = Self { positions: read.positions, vertices: read.vertices, triangles: read.triangles };
        mesh.check().map(|()| mesh)
    }
}
