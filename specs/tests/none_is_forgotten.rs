//! Every spec file of the package is in the list, and the list is sorted.

use std::fs;
use std::path::Path;

/// The names of all spec files in a folder, those of its folders after a slash.
fn names(folder: &Path, prefix: &str, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().and_then(|s| s.to_str()).expect("names are Unicode");
        if path.is_dir() {
            names(&path, &format!("{prefix}{name}/"), found);
        } else if path.extension().is_some_and(|e| e == "basis") {
            found.push(format!("{prefix}{name}"));
        }
    }
}

#[test]
fn the_list_is_the_folder() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    names(folder, "", &mut files);
    files.sort();
    let listed: Vec<&str> = basis_specs::SPECS.iter().map(|(name, _)| *name).collect();
    assert_eq!(listed, files);
}

#[test]
fn a_text_is_its_file() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, text) in basis_specs::SPECS {
        let file = fs::read_to_string(folder.join(format!("{name}.basis"))).expect("the file can be read");
        assert_eq!(*text, file, "{name}");
        assert_eq!(basis_specs::text(name), Some(*text));
    }
    assert_eq!(basis_specs::text("quartic.basis"), None);
}
