//! The text that is open, as the engine sees it: a file without others beside it.

use std::io;
use std::path::Path;

use basis_engine::Files;

/// The name of the text in messages.
pub(crate) const NAME: &str = "spec.basis";

/// There are no files beside the text, but the library.
#[derive(Debug)]
pub(crate) struct NoFiles;

impl Files for NoFiles {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        let message = "a page has no files; `use library \"…\";` names a spec of the library";
        Err(io::Error::new(io::ErrorKind::NotFound, message))
    }
}
