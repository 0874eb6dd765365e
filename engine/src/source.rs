//! Texts of specs and where they came from; the only place in the engine that reads files.

use crate::advice::closest;
use crate::plural::list;
use basis_prover::collections::list::{Listed, Mapped};
use core::cell::OnceCell;
use core::fmt;
use core::ops::Range;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// A spec as the engine reads it.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// The name to show in messages: a path as the user wrote it.
    pub name: String,
    /// Where the text was read, for `use` relative to it and for rebuilds; `None` for texts in memory and in the
    /// library.
    pub path: Option<PathBuf>,
    /// The name of a spec of the library, such as `papers/quartic`, for `use` relative to it; such a spec has no path.
    pub library: Option<String>,
    /// The text, with `\n` line ends and no byte order mark; `None` for tokens of a macro call, which the
    /// compiler shows itself.
    pub text: Option<String>,
    /// Where the lines of the text begin, found when a line is asked for.
    lines: OnceCell<Vec<usize>>,
}

impl Source {
    /// A text in memory.
    pub fn text(name: impl Into<String>, text: &str) -> Self {
        Self { name: name.into(), text: Some(normalize(text)), ..Self::default() }
    }

    /// The tokens of a macro call; `path` is the file with the call, for `use` relative to it.
    pub fn tokens(path: Option<PathBuf>) -> Self {
        Self { name: String::from("<basis!>"), path, ..Self::default() }
    }

    /// The same spec as if it were read at a path.
    pub fn at(mut self, path: PathBuf) -> Self {
        self.path = Some(path);
        self
    }

    /// Line and column of a byte offset, both counted from one, the column in characters.
    pub fn line_column(&self, offset: usize) -> (usize, usize) {
        let text = self.text.as_deref().unwrap_or_default();
        let inside = (0..=offset.min(text.len())).rev().find(|at| text.is_char_boundary(*at));
        let inside = inside.unwrap_or_default();
        let line = self.line(inside);
        let start = self.starts()[line - 1];
        (line, text[start..inside].chars().count() + 1)
    }

    /// The line of a byte offset, counted from one.
    pub fn line(&self, offset: usize) -> usize {
        self.starts().partition_point(|start| *start <= offset).max(1)
    }

    /// The bytes of a line, which is counted from one, without its end; empty after the last line.
    pub fn line_range(&self, line: usize) -> Range<usize> {
        let end = self.text.as_deref().unwrap_or_default().len();
        let starts = self.starts();
        let start = line.checked_sub(1).and_then(|k| starts.get(k)).copied().unwrap_or(end);
        start..starts.get(line).map_or(end, |next| next - 1).max(start)
    }

    /// Where the lines begin; there is always a first one.
    fn starts(&self) -> &[usize] {
        self.lines.get_or_init(|| {
            let mut starts = vec![0];
            for (at, byte) in self.text.as_deref().unwrap_or_default().bytes().enumerate() {
                if byte == b'\n' {
                    starts.push(at + 1);
                }
            }
            starts
        })
    }
}

/// Lines end with `\n` and there is no byte order mark.
fn normalize(text: &str) -> String {
    text.strip_prefix('\u{feff}').unwrap_or(text).replace("\r\n", "\n")
}

/// The sources of one run; a [`SourceId`] is an index into it.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    all: Vec<Source>,
}

/// Which source a place belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SourceId(usize);

impl Sources {
    /// Adds a source.
    pub fn add(&mut self, source: Source) -> SourceId {
        self.all.push(source);
        SourceId(self.all.len() - 1)
    }

    /// The source with this id.
    pub fn get(&self, id: SourceId) -> &Source {
        &self.all[id.0]
    }

    /// All sources with their ids, in the order in which they were read.
    pub fn iter(&self) -> impl Iterator<Item = (SourceId, &Source)> {
        self.all.iter().enumerate().map(|(i, s)| (SourceId(i), s))
    }

    /// The source that was read from the same file, or is the same spec of the library.
    pub fn find(&self, new: &Source) -> Option<SourceId> {
        let is_same = |s: &Source| {
            (s.path.is_some() && s.path == new.path) || (s.library.is_some() && s.library == new.library)
        };
        self.iter().find(|(_, s)| is_same(s)).map(|(id, _)| id)
    }
}

/// Why a file could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadError {
    /// What is wrong, in one clause.
    pub message: String,
    /// Every place that was tried, or what there is.
    pub notes: Vec<String>,
    /// What to write instead.
    pub help: Option<String>,
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        self.notes.iter().try_for_each(|n| write!(f, "\n{n}"))?;
        self.help.iter().try_for_each(|help| write!(f, "\n{help}"))
    }
}

impl std::error::Error for ReadError {}

/// Reads files: from the disk, or from wherever else the caller keeps them.
pub trait Files {
    /// The bytes of a file; of a very large one only the first, as many as are needed to refuse it.
    ///
    /// # Errors
    /// As for [`std::fs::read`], and for what is not a regular file: a pipe may never end, or never begin.
    fn read(&self, path: &Path) -> io::Result<Vec<u8>>;

    /// One name for one file, so that a file reached by two paths is read once.
    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }

    /// Whether there is a folder at the path.
    fn is_dir(&self, _path: &Path) -> bool {
        false
    }

    /// The specs that `use library "…"` can name, as names with their texts: those of basis-specs, unless the caller
    /// keeps others.
    fn library(&self) -> &[(&str, &str)] {
        basis_specs::SPECS
    }
}

/// The files of this machine.
#[derive(Clone, Copy, Debug, Default)]
pub struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        // Before it is opened: opening a pipe waits for a writer.
        if !std::fs::metadata(path)?.is_file() {
            let message = "it is not a regular file, but a pipe or a device";
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        let mut bytes = Vec::new();
        std::fs::File::open(path)?.take(MAX_BYTES as u64 + 1).read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.canonicalize().unwrap_or_else(|_| path.to_path_buf())
    }

    fn is_dir(&self, path: &Path) -> bool {
        path.is_dir()
    }
}

/// The longest text of a spec, in bytes.
pub(crate) const MAX_BYTES: usize = 1 << 20;

/// Reads the spec that `name` denotes, trying the folders in order; an absolute `name` is taken as it is.
///
/// # Errors
/// When no folder has the file (all places are listed), or it is a folder, unreadable, or not UTF-8.
pub fn read(files: &dyn Files, name: &str, folders: &[PathBuf]) -> Result<Source, ReadError> {
    let candidates: Vec<PathBuf> = if Path::new(name).is_absolute() || folders.is_empty() {
        vec![PathBuf::from(name)]
    } else {
        folders.mapped(|f| f.join(name))
    };
    let mut tried = Vec::new();
    for path in &candidates {
        if files.is_dir(path) {
            return Err(ReadError {
                message: format!("`{name}` is a folder, not a spec file"),
                notes: Vec::new(),
                help: Some(String::from("name one file, such as \"specs/quartic.basis\"")),
            });
        }
        match files.read(path) {
            Ok(bytes) => return decode(name, Some(files.canonical(path)), bytes),
            Err(e) if e.kind() == io::ErrorKind::NotFound => {
                tried.push(format!("tried {}", path.display()));
            }
            Err(e) => {
                let message = format!("cannot read `{name}`: {e}");
                return Err(ReadError { message, notes: Vec::new(), help: None });
            }
        }
    }
    tried.dedup();
    Err(ReadError { message: format!("there is no spec file `{name}`"), notes: tried, help: None })
}

/// What stands before the name of a spec of the library where paths are typed: `library:quartic`.
pub const LIBRARY: &str = "library:";

/// The spec of the library with this name, `quartic` or `papers/quartic`.
///
/// # Errors
/// When there is no such spec: which name is meant, or which names there are.
pub fn library(files: &dyn Files, name: &str) -> Result<Source, ReadError> {
    let specs = files.library();
    if let Some((_, text)) = specs.iter().find(|(known, _)| *known == name) {
        let mut source = Source::text(format!("{LIBRARY}{name}"), text);
        source.library = Some(name.to_string());
        return Ok(source);
    }
    let names: Vec<&str> = specs.mapped(|(known, _)| *known);
    let typed = name.strip_suffix(".basis").unwrap_or(name);
    let (_, last) = typed.rsplit_once('/').unwrap_or(("", typed));
    let same = names.iter().copied().find(|known| *known == last);
    let near = same.or_else(|| closest(typed, &names)).or_else(|| closest(last, &names));
    let quoted = |names: &[&str]| list(&names.mapped(|name| format!("`{name}`")));
    let like: Vec<&str> = names.iter().copied().filter(|known| known.contains(last)).listed();
    let notes = match (like.as_slice(), near) {
        ([], Some(_)) => Vec::new(),
        ([], None) => vec![format!("the library has `{}`", names.join("`, `"))],
        (like, _) => vec![format!("the library has {}", quoted(like))],
    };
    Err(ReadError {
        message: format!("there is no spec `{name}` in the library"),
        notes,
        help: near.map(|near| format!("did you mean `{near}`?")),
    })
}

/// The name in the library of `path`, which a spec of the library with the name `from` uses: `bspline.basis` is
/// `bspline` beside `beta_spline`, and `papers/bspline` beside `papers/quartic`.
///
/// # Errors
/// When the path does not name a spec file, or leaves the library.
pub(crate) fn beside(from: &str, path: &str) -> Result<String, ReadError> {
    let refuse = |why: &str| ReadError {
        message: format!("there is no spec file `{path}` in the library"),
        notes: vec![String::from(why)],
        help: None,
    };
    let file =
        path.strip_suffix(".basis").ok_or_else(|| refuse("the names of its files end with `.basis`"))?;
    let mut parts: Vec<&str> = from.split('/').listed();
    parts.pop();
    for part in file.split('/') {
        match part {
            "." => {}
            ".." => {
                parts.pop().ok_or_else(|| refuse("the path leads out of the library"))?;
            }
            _ => parts.push(part),
        }
    }
    Ok(parts.join("/"))
}

/// The spec in some bytes, shown in messages as `name`.
///
/// # Errors
/// When they are too many, or not UTF-8.
pub fn decode(name: &str, path: Option<PathBuf>, bytes: Vec<u8>) -> Result<Source, ReadError> {
    if bytes.len() > MAX_BYTES {
        return Err(ReadError {
            message: format!("`{name}` is larger than {} MiB", MAX_BYTES >> 20),
            notes: Vec::new(),
            help: Some(String::from("split it into several specs")),
        });
    }
    let text = String::from_utf8(bytes).map_err(|e| {
        let valid = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..valid].iter().filter(|b| **b == b'\n').count() + 1;
        ReadError {
            message: format!(
                "`{name}` is not UTF-8: invalid byte 0x{:02x} in line {line}",
                e.as_bytes()[valid]
            ),
            notes: Vec::new(),
            help: Some(String::from("save the file with the encoding UTF-8")),
        }
    })?;
    Ok(Source { path, ..Source::text(name, &text) })
}
