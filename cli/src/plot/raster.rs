//! Pictures as PNG.

use std::sync::Arc;

use basis_engine::Diagnostic;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::output::error;

/// How many pixels a unit of the picture has: enough for print.
const SCALE: f32 = 2.0;

/// An SVG as PNG, with the letters of this machine.
///
/// # Errors
/// When the machine has no letters, or the picture is too large.
pub(super) fn png(svg: &str) -> Result<Vec<u8>, Diagnostic> {
    let mut fonts = fontdb::Database::new();
    fonts.load_system_fonts();
    if fonts.is_empty() {
        let message = "there are no fonts on this machine, so the PNG would have no letters";
        return Err(error(message).help("write an `.svg`, or install a font such as DejaVu Sans"));
    }
    let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
    let fail = |e: &dyn core::fmt::Display| error(format!("cannot draw the picture: {e}"));
    let tree = Tree::from_str(svg, &options).map_err(|e| fail(&e))?;
    let size = tree.size().to_int_size().scale_by(SCALE).ok_or_else(|| fail(&"it is empty"))?;
    let mut pixels = Pixmap::new(size.width(), size.height()).ok_or_else(|| fail(&"it is too large"))?;
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|e| fail(&e))
}
