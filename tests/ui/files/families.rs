//! A family or an order that the spec does not have, and other mistakes in the call itself.
use basis_runtime::basis;

basis!("../specs/powers.basis", Power(2));
basis!("../specs/powers.basis", Powers(9));
basis!("../specs/powers.basis", Powers);
basis!("../specs/powers.basis", Powers(2, 3));
basis!("../specs/powers.basis");
basis!("../specs/powers.basis", Powers(2) as 3);
basis!("../specs/powers.basis", Powers(x));
basis!("../specs/powers.basis" Powers(2));
basis!("../specs/powers.basis", crate = ::basis_runtime, crate = ::basis_runtime);
basis!("../specs/powers.basis", Powers(2) as self);
basis!("../specs/powers.basis", Powers(n = 2));
basis!("../specs/powers.basis", Powers(2), Powers(3));
basis!("../specs/powers.basis", Powers(2) as Same, Powers(3) as Same);
basis!(../specs/powers.basis);
basis!(specs/powers.basis);

fn main() {}
