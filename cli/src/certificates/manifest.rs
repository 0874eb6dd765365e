//! The list of what a folder of certificates holds, by which a missing one is noticed.
//!
//! `DIR/manifest.json` has the paths that were given to `check` and, for each spec that they stand for, its families in
//! all orders, theorems and joins with the numbers of their claims. `verify` finds and reads the specs itself and
//! expects the same.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::fields::Fields;
use super::specs::Specs;
use crate::check::prove::Outcome;

/// The first field.
const FORMAT: &str = "basis certificates 1";

/// Where the list stands.
pub(super) fn path(folder: &Path) -> PathBuf {
    folder.join("manifest.json")
}

/// What a list says.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Manifest {
    /// The paths that were given.
    paths: BTreeSet<String>,
    /// By spec the numbers of claims of each item.
    specs: BTreeMap<String, BTreeMap<String, usize>>,
}

impl Manifest {
    /// A list of specs that these paths stand for.
    pub(crate) fn new(paths: &[PathBuf]) -> Self {
        let paths = paths.iter().map(|p| p.display().to_string()).collect();
        Self { paths, specs: BTreeMap::new() }
    }

    /// Adds a spec.
    pub(crate) fn add(&mut self, outcome: &Outcome) {
        let items = outcome.items.iter().map(|d| (d.subject.title(), d.claims.len()));
        self.specs.insert(outcome.path.clone(), items.collect());
    }

    /// Writes the list; what it says of other specs is kept.
    ///
    /// # Errors
    /// What stands in the way.
    pub(crate) fn write(mut self, folder: &Path) -> Result<(), String> {
        let path = path(folder);
        if path.exists() {
            let old = read(folder).map_err(|e| format!("`{}` is in the way: {e}", path.display()))?;
            self.paths.extend(old.paths);
            for (spec, items) in old.specs {
                self.specs.entry(spec).or_insert(items);
            }
        }
        let value = json!({"format": FORMAT, "paths": self.paths, "specs": self.specs});
        let text = serde_json::to_string_pretty(&value).map_err(|e| e.to_string())?;
        fs::write(&path, text + "\n").map_err(|e| format!("cannot write `{}`: {e}", path.display()))
    }
}

fn read(folder: &Path) -> Result<Manifest, String> {
    let text = fs::read_to_string(path(folder)).map_err(|e| e.to_string())?;
    let value: Value = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let mut fields = Fields::of(&value)?;
    if fields.text("format")? != FORMAT {
        return Err(format!("the format is not `{FORMAT}`"));
    }
    let paths = fields.texts("paths")?.into_iter().map(String::from).collect();
    let object = |value: &Value| -> Result<Map<String, Value>, String> {
        value.as_object().cloned().ok_or_else(|| String::from("an object is expected"))
    };
    let mut specs = BTreeMap::new();
    for (spec, items) in object(fields.take("specs")?)? {
        let mut counts = BTreeMap::new();
        for (item, count) in object(&items)? {
            let count = super::fields::position(&count)?;
            counts.insert(item, count);
        }
        specs.insert(spec, counts);
    }
    fields.end()?;
    Ok(Manifest { paths, specs })
}

/// What is wrong with the list of a folder; `asked` are paths of specs that must be on it, those that they stand for
/// included.
///
/// All specs that should have certificates are read.
pub(super) fn verify(folder: &Path, asked: &[PathBuf], specs: &mut Specs) -> Vec<String> {
    let manifest = match read(folder) {
        Ok(manifest) => manifest,
        Err(e) => {
            let path = path(folder);
            return vec![format!("the list of the specs, `{}`, cannot be read: {e}", path.display())];
        }
    };
    let mut problems = Vec::new();
    let given = manifest.paths.iter().map(PathBuf::from).chain(asked.iter().cloned());
    let expected: BTreeSet<String> = given.flat_map(|path| specs.under(&path)).collect();
    for spec in &expected {
        if !manifest.specs.contains_key(spec) {
            problems.push(format!("{spec}: no certificates were written for it"));
        }
    }
    for spec in expected.iter().chain(manifest.specs.keys()).collect::<BTreeSet<_>>() {
        let says = match specs.items(spec) {
            Ok(items) => items.iter().map(|s| (s.item.subject.title(), s.item.claims.len())).collect(),
            Err(problem) => {
                problems.push(problem);
                continue;
            }
        };
        if manifest.specs.get(spec).is_some_and(|listed| *listed != says) {
            problems.push(format!("{spec}: its claims are not those for which certificates were written"));
        }
        if !expected.contains(spec) {
            problems.push(format!("{spec}: it is in none of the checked folders"));
        }
    }
    problems
}
