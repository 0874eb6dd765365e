//! A curve over a family from a spec file, and what its shape parameter does.
//!
//! `cargo run --example curve` prints how the curve comes nearer to its middle control point as λ grows.

use basis_runtime::{Curve, basis};

// The claims of the family are proved while this line is compiled. Change a sign in the file, and the build stops.
basis!("quadratic.basis");

fn main() -> Result<(), basis_runtime::ShapeError> {
    let points = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]];
    println!("   λ   height   length");
    let mut last = 0.0;
    for lambda in [-2.0, -1.0, 0.0, 0.5, 1.0] {
        let curve = Curve::new(Quadratic::new(lambda)?, points);
        let [_, height] = curve.eval(0.5);
        println!("{lambda:4}   {height:6.4}   {:6.4}", curve.arclen(1e-9));
        // b[1](1/2) = (2 + λ)/4, and the middle control point has the height 2.
        assert_eq!(height, 2.0 * ((2.0 + lambda) / 4.0));
        assert!(height >= last);
        last = height;
    }
    // Outside of the range that the spec declares there is no such family.
    let error = Quadratic::new(1.5_f64).unwrap_err();
    println!("{error}");
    Ok(())
}

#[test]
fn runs() -> Result<(), basis_runtime::ShapeError> {
    main()
}
