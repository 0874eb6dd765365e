//! `basis check --watch`: checks again whenever a file changes.
//!
//! Files are looked at five times a second. Their number is small, the same code serves every system and every file
//! system, and an editor that replaces a file by a new one is no special case.

use basis_kernel::collections::sort::sort_unique;
use std::fs;
use std::io::IsTerminal as _;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use super::files;
use crate::args::CheckArguments;
use crate::name::count;
use crate::output::{self, Status};

/// The time between two looks.
const PAUSE: Duration = Duration::from_millis(200);

/// The state of a file: when it was changed and how long it is; nothing where there is none.
type State = (PathBuf, Option<(SystemTime, u64)>);

/// Checks until the process is ended.
pub(super) fn run(arguments: &CheckArguments) -> Status {
    loop {
        // Before the files are read: a change that comes meanwhile is seen afterwards.
        let mut read = Vec::new();
        let before = states(arguments, &[]);
        if std::io::stdout().is_terminal() {
            output::print("\x1b[2J\x1b[H");
        }
        super::once(arguments, &mut read);
        let mut known = states(arguments, &read);
        for state in &mut known {
            if let Some(old) = before.iter().find(|(path, _)| *path == state.0) {
                state.1 = old.1;
            }
        }
        output::complain(&format!("watching {}; press Ctrl-C to stop\n", count(known.len(), "file")));
        while states(arguments, &read) == known {
            sleep(PAUSE);
        }
    }
}

/// The state of all files that the arguments stand for, and of those that were read.
fn states(arguments: &CheckArguments, read: &[PathBuf]) -> Vec<State> {
    let found = files::find(&arguments.paths).into_iter().map(|entry| entry.path);
    let mut paths: Vec<PathBuf> = found.map(|path| path.canonicalize().unwrap_or(path)).collect();
    paths.extend(read.iter().cloned());
    sort_unique(&mut paths);
    let state = |path: PathBuf| {
        let data = fs::metadata(&path).ok();
        let state = data.and_then(|data| Some((data.modified().ok()?, data.len())));
        (path, state)
    };
    paths.into_iter().map(state).collect()
}
