//! Specs and calls that another macro writes.

macro_rules! line {
    ($name:ident, $first:expr, $slope:expr, $t:ident, $degree:literal) => {
        basis_runtime::basis! {
            family $name {
                domain 0 <= $t <= 1;
                b[0] = $first * 2;
                b[1] = $slope^$degree;
                prove b[1](1) = 4;
            }
        }
    };
}
line!(FromMacro, 1 - t, 2 * t, t, 2);

macro_rules! from_file {
    ($path:literal, $name:ident, $order:literal) => {
        basis_runtime::basis!($path, $name($order) as FromFile);
    };
}
from_file!("../specs/powers.basis", Powers, 3);

fn main() {
    // An expression that a macro passes on stays one operand.
    assert_eq!(FromMacro::new().values(0.25), [1.5, 0.25]);
    assert_eq!(FromFile::new().values(0.5), [1.0, 0.5, 0.25, 0.125]);
}
