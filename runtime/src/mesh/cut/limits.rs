//! What is asked of a mesh.

/// What the triangles of a surface have to keep.
#[derive(Clone, Copy, Debug)]
pub(in crate::mesh) struct Limits {
    /// The largest distance from the surface.
    pub(in crate::mesh) tolerance: f64,
    /// How far points on edges may move when they become one.
    pub(in crate::mesh) reach: f64,
    /// Points that near to each other are one.
    pub(in crate::mesh) weld: f64,
    /// The longest side of a rectangle.
    pub(in crate::mesh) edge: f64,
    /// The largest angle in radians between normals at the corners of a rectangle.
    pub(in crate::mesh) angle: f64,
    /// The largest quotient of the lengths of two sides of a rectangle that meet.
    pub(in crate::mesh) aspect: f64,
}

impl Limits {
    /// The same in another unit of length.
    pub(in crate::mesh) fn measured_in(self, unit: f64) -> Self {
        let Self { tolerance, reach, weld, edge, angle, aspect } = self;
        let [tolerance, reach, weld, edge] = [tolerance, reach, weld, edge].map(|length| length / unit);
        Self { tolerance, reach, weld, edge, angle, aspect }
    }
}
