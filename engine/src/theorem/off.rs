//! Stands for the reading of theorems and joins where the feature `joins` is off.

use crate::Library;
use crate::subject::Item;

/// Nothing; the library has an error for the first theorem or join that would have been decided.
pub fn theorems(library: &Library<'_>) -> Vec<Item> {
    library.refuse_theorems();
    Vec::new()
}
