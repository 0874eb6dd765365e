//! The attribute `d` of SVG paths.

mod error;
mod read;
mod write;

pub use error::{SvgError, SvgMistake};
pub use write::to_svg;
