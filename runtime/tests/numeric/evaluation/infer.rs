//! Types are inferred from what is passed, and curves are plain values.

use basis_runtime::{Basis, Curve, ShapeError};

use crate::families::{QuadraticLagrange, QuarticBernstein};

#[test]
fn from_literals() -> Result<(), ShapeError> {
    let (p0, p1, p2, p3) = ([0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]);
    let basis = QuarticBernstein::new(0.5)?;
    let curve = Curve::new(basis, [p0, p1, p2, p3]);
    let values: [f64; 4] = basis.values(1.0 / 3.0);
    assert!(values[0] > 0.0);
    assert_eq!(curve.eval(0.5), [2.0, 1.625]);
    let [p, v, a] = curve.eval_with_derivs::<3>(0.5);
    assert_eq!([p, v, a], [[2.0, 1.625], [4.25, 0.0], [0.0, -12.0]]);
    Ok(())
}

#[test]
fn the_scalar_type_from_the_points() -> Result<(), ShapeError> {
    let curve = Curve::new(QuarticBernstein::new(0.5)?, [[0.0_f32], [1.0], [2.0], [3.0]]);
    let _: [f32; 1] = curve.eval(0.25);
    assert_eq!(Curve::new(QuadraticLagrange::new(), [1.0, 0.0, 1.0]).eval(0.5), 0.25);
    Ok(())
}

#[test]
fn in_generic_code() {
    fn middle<B: Basis<Scalar = f64>>(curve: &Curve<B, [f64; 3]>) -> [f64; 3] {
        let [lo, hi] = curve.domain();
        curve.eval(0.5 * (lo + hi))
    }
    let curve = Curve::new(QuadraticLagrange::new(), [[0.0; 3], [5.0; 3], [1.0; 3]]);
    assert_eq!(middle(&curve), [5.0; 3]);
}

#[test]
fn curves_are_values() {
    let curve = Curve::new(QuadraticLagrange::new(), [1.0, 2.0, 3.0]);
    let copy = curve;
    assert_eq!(copy, curve);
    assert_ne!(curve, Curve::new(QuadraticLagrange::new(), [1.0, 2.0, 4.0]));
    assert_ne!(
        Curve::new(QuarticBernstein::new(0.5).unwrap(), [0.0; 4]),
        Curve::new(QuarticBernstein::new(0.25).unwrap(), [0.0; 4])
    );
    assert_eq!(copy.control_points(), [1.0, 2.0, 3.0]);
    assert_eq!(
        format!("{curve:?}"),
        "Curve { basis: QuadraticLagrange(PhantomData<f64>), control_points: [1.0, 2.0, 3.0], .. }"
    );
}
