//! What is asked of a surface: points, derivatives, normals, curvatures, boxes, the nearest point.

mod boxes;
mod curvature;
mod grids;
mod hostile;
mod nearest;
mod normals;
mod partials;
mod values;
