//! Curves over all types of points give the same numbers.

use approx::assert_relative_eq;
use basis_runtime::{Curve, basis};
use glam::{DVec3, Vec2};
use nalgebra::{Point2, Vector3};

basis!("../../../specs/quartic.basis");

const POINTS: [[f64; 3]; 4] = [[0.1, 0.2, 0.3], [1.3, 2.1, -0.4], [2.2, -1.7, 0.9], [3.1, 0.6, 1.7]];

fn family<S: basis_runtime::Scalar>() -> QuarticBernstein<S> {
    QuarticBernstein::new(S::of(0.5)).expect("0.5 is in the declared range")
}

#[test]
fn arrays_glam_and_nalgebra_agree() {
    let arrays = Curve::new(family::<f64>(), POINTS);
    let glam = Curve::new(family::<f64>(), POINTS.map(DVec3::from));
    let nalgebra = Curve::new(family::<f64>(), POINTS.map(Vector3::from));
    let scalars = Curve::new(family::<f64>(), POINTS.map(|p| p[1]));
    for k in 0..=20 {
        let t = f64::from(k) / 20.0;
        let [point, velocity, acceleration] = arrays.eval_with_derivs(t);
        assert_eq!(glam.eval_with_derivs(t).map(|p: DVec3| p.to_array()), [point, velocity, acceleration]);
        assert_eq!(nalgebra.eval_with_derivs(t).map(<[f64; 3]>::from), [point, velocity, acceleration]);
        assert_eq!(scalars.eval(t), point[1]);
    }
}

#[test]
fn single_precision_is_near_double_precision() {
    let single = POINTS.map(|p| Vec2::new(p[0] as f32, p[1] as f32));
    let single = Curve::new(family::<f32>(), single);
    let double = Curve::new(
        family::<f64>(),
        POINTS.map(|p| Point2::new(f64::from(p[0] as f32), f64::from(p[1] as f32))),
    );
    for k in 0..=20 {
        let t = k as f32 / 20.0;
        let (a, b) = (single.eval(t), double.eval(f64::from(t)));
        assert_relative_eq!(f64::from(a.x), b.x, epsilon = 1e-6);
        assert_relative_eq!(f64::from(a.y), b.y, epsilon = 1e-6);
    }
}

#[test]
fn derivatives_above_the_degree_are_zero() {
    let curve = Curve::new(family::<f64>(), POINTS);
    let derivatives: [[f64; 3]; 8] = curve.eval_with_derivs(0.3);
    assert_eq!(derivatives[5..], [[0.0; 3]; 3]);
    assert_eq!(family::<f64>().derivatives(0.3, 5), [0.0; 4]);
    assert_eq!(family::<f64>().derivatives(0.3, 1000), [0.0; 4]);
}
