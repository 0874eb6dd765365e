//! Line ends of another system, a byte order mark, and paths from both folders.
use basis_runtime::basis;

basis!("../specs/crlf.basis");
basis!("../specs/byte_order_mark.basis");
basis!("../specs/powers.basis", Powers(1) as Affine, Powers(4),);

fn main() {
    assert_eq!(Crlf::new().values(0.25_f64), [0.75, 0.25]);
    assert_eq!(Marked::new().values(0.25_f64), [0.75, 0.25]);
    assert_eq!(Affine::new().values(0.25_f64), [1.0, 0.25]);
    assert_eq!(Powers::new().values(0.5_f64), [1.0, 0.5, 0.25, 0.125, 0.0625]);
}
