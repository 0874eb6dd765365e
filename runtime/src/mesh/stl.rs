//! Binary STL: triangles with their normals, in single precision.

use std::io::{self, Write};

use super::{Mesh, area_vector};
use crate::Scalar;
use crate::vector::direction;

impl<S: Scalar> Mesh<S> {
    /// Writes the mesh as binary STL, in single precision, with the normals of the triangles.
    ///
    /// Positions that several triangles share are the same numbers in all of them, so that the file has no cracks either.
    ///
    /// # Errors
    /// When the writer fails, and if an index does not exist, see [`check`](Self::check).
    pub fn write_stl(&self, mut writer: impl Write) -> io::Result<()> {
        self.check().map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        let vector = |v: [S; 3]| stl_io::Vector::new(v.map(|c| c.to_f64() as f32));
        let all: alloc::vec::Vec<[[S; 3]; 3]> = self.all_corner_positions().collect();
        let triangles = all.into_iter().map(|corners| {
            let normal = direction(area_vector(corners)).unwrap_or([S::ZERO; 3]);
            stl_io::Triangle { normal: vector(normal), vertices: corners.map(vector) }
        });
        stl_io::write_stl(&mut writer, triangles)
    }
}
