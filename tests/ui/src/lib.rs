//! Nothing: the cases are the files in `files`, `inline` and `pass`, which `tests/ui.rs` compiles one by one.
