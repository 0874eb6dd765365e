//! A curve ends exactly where it says that it ends, for every shape value and every control point.

use basis_runtime::{Basis, Curve, Scalar};

use crate::families::{Bernstein7, Bernstein30, Linear, QuadraticLagrange, QuarticBernstein, UniformCubic};
use crate::random::Random;

fn ends_are_exact<B: Basis>(basis: B, random: &mut Random) -> Curve<B, [B::Scalar; 3]> {
    use basis_runtime::Array;
    let points = B::Points::from_fn(|_| core::array::from_fn(|_| random.wild()));
    let curve = Curve::new(basis, points);
    let [lo, hi] = B::domain();
    assert_eq!(curve.eval(lo), curve.start(), "{curve:?}");
    assert_eq!(curve.eval(hi), curve.end(), "{curve:?}");
    assert_eq!(curve.eval_with_derivs::<3>(hi)[0], curve.end());
    curve
}

fn all_families<S: Scalar>(seed: u64) {
    let random = &mut Random::new(seed);
    for _ in 0..3000 {
        let lambda = random.between(-3.0, 1.0);
        let curve = ends_are_exact(QuarticBernstein::<S>::new(lambda).unwrap(), random);
        assert_eq!([curve.start(), curve.end()], [curve.control_points()[0], curve.control_points()[3]]);
        let curve = ends_are_exact(QuadraticLagrange::<S>::new(), random);
        assert_eq!([curve.start(), curve.end()], [curve.control_points()[0], curve.control_points()[2]]);
        let curve = ends_are_exact(Bernstein7::<S>::new(), random);
        assert_eq!([curve.start(), curve.end()], [curve.control_points()[0], curve.control_points()[7]]);
        ends_are_exact(UniformCubic::<S>::new(), random);
        ends_are_exact(Linear::<S>::default(), random);
    }
    for _ in 0..200 {
        ends_are_exact(Bernstein30::<S>::new(), random);
    }
}

#[test]
fn in_f32() {
    all_families::<f32>(11);
}

#[test]
fn in_f64() {
    all_families::<f64>(12);
}

/// The ends of a segment of a B-spline are averages of control points; two segments meet up to rounding.
#[test]
fn segments_of_a_spline_meet() {
    let points = [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 3.0], [4.0, 1.0], [6.0, -1.0]];
    let first = Curve::new(UniformCubic::new(), [points[0], points[1], points[2], points[3]]);
    let second = Curve::new(UniformCubic::new(), [points[1], points[2], points[3], points[4]]);
    for i in 0..2 {
        assert!((first.end()[i] - second.start()[i]).abs() < 1e-15);
    }
    assert!((first.start()[0] - 7.0 / 6.0).abs() < 1e-15);
}

#[test]
fn bezier_points_start_and_end_with_the_curve() {
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), [1.0, 3.0, 5.0, 11.0]);
    assert_eq!(curve.to_bernstein(), [1.0, 2.75, 4.0, 5.75, 11.0]);
}
