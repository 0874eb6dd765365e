//! Standard output and standard error: colours only on a terminal, no panic when the reader is gone.

use std::io::{self, Write};
use std::process::ExitCode;

use basis_engine::Diagnostic;

/// How a run ends; of several outcomes the last one counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Status {
    /// Everything is as it should be.
    Fine = 0,
    /// A claim is not as declared, or a spec has errors.
    Wrong = 1,
    /// Something cannot be read or written, or the command is used wrongly.
    Unusable = 2,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        Self::from(status as u8)
    }
}

/// Prints to standard output; styles are left out unless it is a terminal that shows them.
pub(crate) fn print(text: &str) -> Status {
    // Looking for styles to leave out takes longer than most checks, and JSON has none.
    let mut out: Box<dyn Write> = if text.contains('\x1b') {
        Box::new(anstream::stdout().lock())
    } else {
        Box::new(io::stdout().lock())
    };
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Status::Fine,
        // The reader has seen enough, as in `basis check specs | head`.
        Err(e) if e.kind() == io::ErrorKind::BrokenPipe => Status::Fine,
        Err(e) => {
            complain(&format!("error: cannot write to standard output: {e}\n"));
            Status::Unusable
        }
    }
}

/// Prints to standard error; styles are left out unless it is a terminal that shows them.
pub(crate) fn complain(text: &str) {
    // There is no third place to say that this failed.
    let _ = anstream::stderr().lock().write_all(text.as_bytes());
}

/// The width of the terminal to which standard output goes; `None` when it goes elsewhere.
pub(crate) fn width() -> Option<u16> {
    terminal_size::terminal_size_of(io::stdout()).map(|(width, _)| width.0).filter(|w| *w > 0)
}

/// An error that is not about a place in a spec.
pub(crate) fn error(message: impl Into<String>) -> Diagnostic {
    Diagnostic::unplaced(message)
}

/// Prints one JSON value on one line to standard output.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Status {
    match serde_json::to_string(value) {
        Ok(text) => print(&(text + "\n")),
        Err(e) => {
            complain(&format!("error: cannot write JSON: {e}\n"));
            Status::Unusable
        }
    }
}
