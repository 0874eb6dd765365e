//! Every type of point gives the same curve.

use basis_runtime::{Curve, Point, Scalar};

use crate::families::QuarticBernstein;

/// Points of small whole components, so that the curve at t = 1/4 is exact in every type.
fn net<P: Point>() -> [P; 4] {
    core::array::from_fn(|k| P::from_components(|i| P::Scalar::from_usize(k * k + i * k)))
}

fn is_a_point<P: Point>(dim: usize) {
    assert_eq!(P::DIM, dim);
    let point = P::from_components(|i| P::Scalar::from_usize(i + 1));
    for i in 0..dim {
        let (component, two) = (P::Scalar::from_usize(i + 1), P::Scalar::of(2.0));
        assert_eq!(point.component(i), component);
        assert_eq!(P::zero().component(i), P::Scalar::ZERO);
        assert_eq!(point.scale(two).component(i), component * two);
        assert_eq!(point.minus(point.scale(two)).component(i), -component);
        assert_eq!(point.add_scaled(point, two).component(i), component * P::Scalar::of(3.0));
    }
    let curve = Curve::new(QuarticBernstein::new(P::Scalar::of(0.5)).unwrap(), net::<P>());
    let along = Curve::new(QuarticBernstein::new(0.5).unwrap(), net::<[f64; 4]>());
    let t = 0.25;
    let points = curve.eval_with_derivs::<3>(P::Scalar::of(t));
    for (point, expected) in points.iter().zip(along.eval_with_derivs::<3>(t)) {
        for (i, expected) in expected.into_iter().enumerate().take(dim) {
            assert_eq!(point.component(i).to_f64(), expected);
        }
    }
}

#[test]
fn scalars_and_arrays() {
    is_a_point::<f32>(1);
    is_a_point::<f64>(1);
    is_a_point::<[f32; 3]>(3);
    is_a_point::<[f64; 1]>(1);
    is_a_point::<[f64; 4]>(4);
    assert_eq!(<[f64; 0]>::zero(), [0.0; 0]);
}

#[test]
#[cfg(feature = "glam")]
fn glam_vectors() {
    is_a_point::<glam::Vec2>(2);
    is_a_point::<glam::Vec3>(3);
    is_a_point::<glam::Vec3A>(3);
    is_a_point::<glam::Vec4>(4);
    is_a_point::<glam::DVec2>(2);
    is_a_point::<glam::DVec3>(3);
    is_a_point::<glam::DVec4>(4);

    let [p0, p1, p2, p3] = net::<glam::Vec3>();
    let curve = Curve::new(QuarticBernstein::new(-2.0).unwrap(), [p0, p1, p2, p3]);
    assert_eq!(curve.eval(1.0), p3);
}

#[test]
#[cfg(feature = "nalgebra")]
fn nalgebra_vectors_and_points() {
    is_a_point::<nalgebra::Vector2<f32>>(2);
    is_a_point::<nalgebra::Vector3<f64>>(3);
    is_a_point::<nalgebra::Point3<f64>>(3);
    is_a_point::<nalgebra::Point2<f32>>(2);

    let [p0, p1, p2, p3] = net::<nalgebra::Point3<f64>>();
    let curve = Curve::new(QuarticBernstein::new(-2.0).unwrap(), [p0, p1, p2, p3]);
    assert_eq!(curve.eval(1.0), p3);
}
