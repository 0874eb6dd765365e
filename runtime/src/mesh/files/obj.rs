//! Wavefront OBJ: a text format of positions, texture coordinates, normals and faces.

use std::io::{self, BufWriter, Write};

use crate::Scalar;
use crate::mesh::Mesh;

impl<S: Scalar> Mesh<S> {
    /// Writes the mesh as Wavefront OBJ, with normals and texture coordinates; every surface is a group.
    ///
    /// Numbers are written with as many digits as are needed to read the same numbers back.
    ///
    /// ```
    /// # use basis_runtime::{BernsteinBasis, TensorSurface, Tessellation};
    /// # let linear = BernsteinBasis::<f64, 2>::new();
    /// # let net = [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]];
    /// # let square = TensorSurface::new(linear, linear, net);
    /// let mesh = Tessellation::new(0.01)?.with(&square).mesh()?;
    /// let mut text = Vec::new();
    /// mesh.write_obj(&mut text)?;
    /// assert_eq!(String::from_utf8_lossy(&text).lines().filter(|line| line.starts_with("f ")).count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// When the writer fails, and if an index does not exist, see [`check`](Self::check).
    pub fn write_obj(&self, writer: impl Write) -> io::Result<()> {
        self.check().map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        let mut out = BufWriter::new(writer);
        for [x, y, z] in &self.positions {
            writeln!(out, "v {x} {y} {z}")?;
        }
        for vertex in &self.vertices {
            let [u, v] = vertex.uv;
            writeln!(out, "vt {u} {v}")?;
        }
        for vertex in &self.vertices {
            let [x, y, z] = vertex.normal;
            writeln!(out, "vn {x} {y} {z}")?;
        }
        let mut group = None;
        for &triangle in &self.triangles {
            let surface = self.vertices[triangle[0] as usize].surface;
            if group.replace(surface) != Some(surface) {
                writeln!(out, "g surface{surface}")?;
            }
            // Indices of the format begin at one.
            let [a, b, c] = triangle.map(|vertex| vertex + 1);
            let Some(corners) = self.corners(triangle) else { continue };
            let [p, q, r] = corners.map(|position| position + 1);
            writeln!(out, "f {p}/{a}/{a} {q}/{b}/{b} {r}/{c}/{c}")?;
        }
        out.flush()
    }
}
