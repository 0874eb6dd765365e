//! Pictures: curves as SVG, shaded surfaces as PNG.

pub(crate) mod plot;
mod raster;
pub(crate) mod scene;
