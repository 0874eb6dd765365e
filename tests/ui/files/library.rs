//! Names that the library does not have, and words that are not in quotation marks.
use basis_runtime::basis;

basis!(library "quartik");
basis!(library "quartic.basis");
basis!(library quartic);
basis!(library);
basis!(library "lagrange", Lagrnge(2));
basis! { use library "bsplin"; family Line { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t; } }

fn main() {}
