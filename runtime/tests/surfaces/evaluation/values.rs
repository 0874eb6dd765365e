//! Points of surfaces are the sums of their definition, in every type of point.

use basis_runtime::{Basis, Point, Scalar, Surface, TensorSurface};

use crate::families::{Cubic, QuadraticBezier, UniformBSpline, random_surface};
use crate::random::Random;

/// `Σ_i b_i(u) Σ_j c_ij(v) P_ij`, component by component, in `f64`.
fn sum<U: Basis, V: Basis<Scalar = U::Scalar>, P: Point<Scalar = U::Scalar>>(
    surface: &TensorSurface<U, V, P>,
    u: U::Scalar,
    v: U::Scalar,
    component: usize,
) -> f64 {
    let mut sum = 0.0;
    for (row, b) in surface.rows().iter().zip(surface.u_basis().values(u).as_ref()) {
        for (point, c) in row.control_points().iter().zip(row.basis().values(v).as_ref()) {
            sum += b.to_f64() * c.to_f64() * point.component(component).to_f64();
        }
    }
    sum
}

#[test]
fn from_slices_and_with_other_shape_values() {
    let random = &mut Random::new(5);
    for _ in 0..20 {
        let surface = random_surface::<[f64; 3]>(random);
        let (u_basis, v_basis) = (surface.u_basis(), surface.rows()[0].basis());
        let flat: Vec<[f64; 3]> =
            surface.rows().iter().flat_map(|row| row.control_points().to_vec()).collect();
        let same = TensorSurface::from_slice(u_basis, v_basis, &flat).unwrap();
        assert_eq!(same, surface.with_bases(u_basis, v_basis));
        assert_eq!(same.rows()[0], surface.rows()[0]);
        assert!(TensorSurface::from_slice(u_basis, v_basis, &flat[1..]).is_err());
    }
}

fn is_the_sum<P: Point>(tolerance: f64) {
    let random = &mut Random::new(3);
    for _ in 0..200 {
        let surface = random_surface::<P>(random);
        let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let point = surface.eval(u, v);
        for c in 0..P::DIM {
            let expected = sum(&surface, u, v, c);
            assert!((point.component(c).to_f64() - expected).abs() <= tolerance, "{point:?} {expected}");
        }
    }
}

#[test]
fn are_the_sums_of_the_definition() {
    is_the_sum::<[f64; 3]>(1e-15);
    is_the_sum::<f64>(1e-15);
    is_the_sum::<[f32; 2]>(6e-7);
    #[cfg(feature = "glam")]
    {
        is_the_sum::<glam::Vec3>(6e-7);
        is_the_sum::<glam::Vec3A>(6e-7);
        is_the_sum::<glam::DVec3>(1e-15);
    }
    #[cfg(feature = "nalgebra")]
    {
        is_the_sum::<nalgebra::Point3<f64>>(1e-15);
        is_the_sum::<nalgebra::Vector3<f32>>(6e-7);
    }
}

#[test]
fn any_two_families() {
    let net = core::array::from_fn(|i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]));
    let surface = TensorSurface::new(QuadraticBezier::new(-0.5).unwrap(), UniformBSpline::new(), net);
    let random = &mut Random::new(4);
    for _ in 0..50 {
        let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        for (c, value) in surface.eval(u, v).into_iter().enumerate() {
            assert!((value - sum(&surface, u, v, c)).abs() < 1e-15);
        }
    }
    assert_eq!(surface.control_point(2, 3), Some([2.0, 3.0, 6.0]));
    assert_eq!(surface.control_point(3, 0), None);
    assert_eq!(surface.control_point(0, 4), None);
}

#[test]
fn corners_are_exact() {
    let random = &mut Random::new(5);
    for _ in 0..100 {
        let surface = random_surface::<[f64; 3]>(random);
        let corner = |i, j| surface.control_point(i, j).unwrap();
        assert_eq!(surface.eval(0.0, 0.0), corner(0, 0));
        assert_eq!(surface.eval(0.0, 1.0), corner(0, 3));
        assert_eq!(surface.eval(1.0, 0.0), corner(3, 0));
        assert_eq!(surface.eval(1.0, 1.0), corner(3, 3));
    }
}

/// All rows with one γ make the plain tensor product.
#[test]
fn equal_rows_are_the_tensor_product() {
    let random = &mut Random::new(6);
    let rows = random_surface::<[f64; 3]>(random);
    let net = core::array::from_fn(|i| core::array::from_fn(|j| rows.control_point(i, j).unwrap()));
    let gamma = rows.rows()[0].basis();
    let one = TensorSurface::new(rows.u_basis(), gamma, net);
    let four = TensorSurface::with_rows(rows.u_basis(), [gamma; 4], net);
    assert_eq!(one, four);
    assert_ne!(one, rows);
    assert_eq!(one.eval(0.3, 0.6), four.eval(0.3, 0.6));
}

#[test]
fn surfaces_are_plain_values() {
    fn is_plain<T: Copy + Send + Sync + 'static>() {}
    is_plain::<TensorSurface<Cubic<f32>, Cubic<f32>, [f32; 3]>>();
}

#[test]
fn nan_gives_nan() {
    let surface = random_surface::<[f64; 3]>(&mut Random::new(7));
    assert!(surface.eval(f64::NAN, 0.5).iter().all(|c| c.is_nan()));
    assert!(surface.eval(0.5, f64::NAN).iter().all(|c| c.is_nan()));
}
