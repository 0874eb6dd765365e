//! Every place where the file was looked for is listed; `rebuild.rs` has the case of a relative path.
use basis_runtime::basis;

basis!("/no/such/folder/quartic.basis");
basis!("");

fn main() {}
