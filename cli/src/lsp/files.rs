//! Files as the editor sees them: texts that are open, and what is on the disk.

use basis_kernel::collections::sort::sort;
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use basis_engine::query::{Document, Import, PRELUDE};
use basis_engine::{Disk, Files, source};
use lsp_types::Uri;

use crate::spec::EXTENSION;

/// The texts that are open in the editor, by path, before those on the disk.
#[derive(Debug, Default)]
pub(super) struct Overlay {
    pub(super) open: BTreeMap<PathBuf, String>,
}

impl Files for Overlay {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.open.get(&self.canonical(path)) {
            Some(text) => Ok(text.clone().into_bytes()),
            None => Disk.read(path),
        }
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        Disk.canonical(path)
    }

    fn is_dir(&self, path: &Path) -> bool {
        Disk.is_dir(path)
    }
}

/// The path of a `file:` address.
pub(super) fn path(uri: &Uri) -> Option<PathBuf> {
    let rest = uri.as_str().strip_prefix("file://")?;
    let rest = &rest[rest.find('/')?..];
    let mut bytes = Vec::new();
    let mut left = rest.as_bytes();
    while let Some((first, more)) = left.split_first() {
        let hex = |b: Option<&u8>| b.and_then(|b| char::from(*b).to_digit(16));
        match (first, hex(more.first()), hex(more.get(1))) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((high * 16 + low) as u8);
                left = &more[2..];
            }
            _ => {
                bytes.push(*first);
                left = more;
            }
        }
    }
    let text = String::from_utf8(bytes).ok()?;
    // `/C:/…` on Windows.
    let drive = text.len() > 2 && text.as_bytes()[2] == b':' && cfg!(windows);
    let path = PathBuf::from(if drive { &text[1..] } else { &text });
    Some(Disk.canonical(&path))
}

/// The `file:` address of a path.
pub(super) fn uri(path: &Path) -> Option<Uri> {
    let text = path.to_str()?.replace('\\', "/");
    let text = text.strip_prefix("//?/").unwrap_or(&text);
    let mut address = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'-' | b'_' | b'.' | b'~' | b':' => {
                address.push(char::from(byte));
            }
            _ => address += &format!("%{byte:02X}"),
        }
    }
    address.parse().ok()
}

/// A spec that another one uses: where it is, and its text.
pub(super) struct Other {
    /// The file; of a spec of the library one in a folder for such copies, which is written when it is asked for.
    pub(super) path: PathBuf,
    /// Whether it comes with the toolchain.
    pub(super) shipped: bool,
    /// Its names.
    pub(super) document: Document,
}

/// The specs that a spec at `path` can name families of: those that it uses, and the prelude.
pub(super) fn visible(files: &Overlay, path: Option<&Path>, imports: &[Import]) -> Vec<Other> {
    let mut all: Vec<Other> = imports.iter().filter_map(|import| used(files, path, import)).collect();
    let document = Document::new(PRELUDE);
    all.push(Other { path: copy("prelude"), shipped: true, document });
    all
}

fn used(files: &Overlay, path: Option<&Path>, import: &Import) -> Option<Other> {
    if import.library {
        let source = source::library(files, &import.path).ok()?;
        let document = Document::new(source.text.unwrap_or_default());
        return Some(Other { path: copy(&import.path), shipped: true, document });
    }
    let folder = path?.parent()?.to_path_buf();
    let source = source::read(files, &import.path, &[folder]).ok()?;
    let document = Document::new(source.text.unwrap_or_default());
    Some(Other { path: source.path?, shipped: false, document })
}

/// Where a copy of a spec of the library is kept for the editor to show.
fn copy(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("basis-library-{}", env!("CARGO_PKG_VERSION")));
    folder.join(format!("{name}.{EXTENSION}"))
}

/// The address of another spec; what is shipped is written to a file first, so that the editor can show it.
pub(super) fn address(other: &Other) -> Option<Uri> {
    if other.shipped && fs::read_to_string(&other.path).ok().as_deref() != Some(&other.document.text) {
        fs::create_dir_all(other.path.parent()?).ok()?;
        fs::write(&other.path, &other.document.text).ok()?;
    }
    uri(&other.path)
}

/// The names of the other spec files in the folder of a spec.
pub(super) fn beside(path: Option<&Path>) -> Vec<String> {
    let Some((path, folder)) = path.and_then(|p| Some((p, p.parent()?))) else { return Vec::new() };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let specs = entries.filter(|p| p != path && p.extension().is_some_and(|e| e == EXTENSION));
    let mut names: Vec<String> =
        specs.filter_map(|p| Some(p.file_name()?.to_str()?.to_string())).take(MAX_SPECS).collect();
    sort(&mut names);
    names
}

/// The most specs of a workspace that are looked at.
const MAX_SPECS: usize = 2000;

/// The spec files in some folders, folders of build results and hidden ones left out.
pub(super) fn specs(roots: &[PathBuf]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders: Vec<PathBuf> = roots.to_vec();
    let mut seen = 0;
    while let Some(folder) = folders.pop() {
        seen += 1;
        if found.len() >= MAX_SPECS || seen > 10 * MAX_SPECS {
            break;
        }
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let (path, name) = (entry.path(), entry.file_name());
            let name = name.to_string_lossy();
            let Ok(kind) = entry.file_type() else { continue };
            if kind.is_dir() && !name.starts_with('.') && name != "target" && name != "node_modules" {
                folders.push(path);
            } else if kind.is_file() && path.extension().is_some_and(|e| e == EXTENSION) {
                found.push(Disk.canonical(&path));
            }
        }
    }
    sort(&mut found);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_paths() {
        let path_of = |text: &str| path(&text.parse().expect("it is an address"));
        assert_eq!(path_of("file:///no/%CE%BB%20x.basis"), Some(PathBuf::from("/no/λ x.basis")));
        assert_eq!(path_of("untitled:Untitled-1"), None);
        let address = uri(Path::new("/no/λ x.basis")).expect("it has an address");
        assert_eq!(address.as_str(), "file:///no/%CE%BB%20x.basis");
    }
}
