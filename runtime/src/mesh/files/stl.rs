//! Binary STL: triangles with their normals, in single precision.

use std::io::{self, Write};

use crate::Scalar;
use crate::mesh::{Mesh, area_vector};
use crate::vector::direction;

impl<S: Scalar> Mesh<S> {
    /// Writes the mesh as binary STL, in single precision, with the normals of the triangles.
    ///
    /// Positions that several triangles share are the same numbers in all of them, so that the file has no cracks
    /// either.
    ///
    /// # Errors
    /// When the writer fails, if an index does not exist, see [`check`](Self::check), and if a position is too large
    /// for single precision, with a [`MeshError`](crate::MeshError) inside.
    pub fn write_stl(&self, mut writer: impl Write) -> io::Result<()> {
        let positions = self
            .check()
            .and_then(|()| self.single_positions())
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        let all: alloc::vec::Vec<[u32; 3]> = self.triangles.iter().filter_map(|&t| self.corners(t)).collect();
        let triangles = all.into_iter().map(|corners| {
            let normal = direction(area_vector(corners.map(|p| self.positions[p as usize])));
            let normal = normal.unwrap_or([S::ZERO; 3]).map(|c| c.to_f64() as f32);
            stl_io::Triangle {
                normal: stl_io::Vector::new(normal),
                vertices: corners.map(|p| stl_io::Vector::new(positions[p as usize])),
            }
        });
        stl_io::write_stl(&mut writer, triangles)
    }
}
