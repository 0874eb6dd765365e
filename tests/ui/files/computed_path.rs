//! Paths that are put together: variables that are not set, macros and constants that a macro cannot look into.
use basis_runtime::basis;

const PATH: &str = "quartic.basis";

basis!(concat!(env!("BASIS_NO_SUCH_VARIABLE"), "/quartic.basis"));
basis!(env!("BASIS_NO_SUCH_VARIABLE", "run `configure` first"));
basis!(concat!(env!("CARGO_PKG_NAME"), '/', 1, "/no_such", ".basis"));
basis!(concat!(include_str!("path.txt"), "/quartic.basis"));
basis!(concat!("folder/", PATH));
basis!(std::concat("quartic.basis"));
basis!(1);

fn main() {}
