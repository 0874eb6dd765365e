//! Nothing at all, and nothing of use.
use basis_runtime::basis;

basis!();
basis! {}
basis! { use "no_such_file.basis" }
basis! { crate = basis_runtime }
basis!(quartic);

fn main() {}
