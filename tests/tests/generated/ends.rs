//! A bound curve starts and ends where it says, bit for bit, for every shape value.

use basis_runtime::{Array, Curve, Scalar};
use basis_tests::each_family;
use basis_tests::families::{
    Bernstein30, Cardinal, Cubic, QuadraticBezier, Quadric, QuarticBernstein, SaidBall, Shipped,
};
use basis_tests::random::Random;

fn curves<B: Shipped>(rounds: usize) -> Vec<Curve<B, [B::Scalar; 2]>> {
    let (reference, random) = (B::reference(), &mut Random::new(11));
    let curve = |_| {
        let shape = reference.shape(random);
        let points = B::Points::from_fn(|_| core::array::from_fn(|_| random.wild()));
        Curve::new(B::with(&shape).expect("inside the range"), points)
    };
    (0..rounds).map(curve).collect()
}

fn bits<S: Scalar>(point: [S; 2]) -> [u64; 2] {
    // -0 and 0 are the same end.
    point.map(|c| (c.to_f64() + 0.0).to_bits())
}

fn are_exact<B: Shipped>(rounds: usize) {
    for curve in curves::<B>(rounds) {
        let [lo, hi] = B::domain();
        assert_eq!(bits(curve.eval(lo)), bits(curve.start()), "{curve:?}");
        assert_eq!(bits(curve.eval(hi)), bits(curve.end()), "{curve:?}");
        let [start, _, _] = curve.eval_with_derivs(lo);
        let [end, _, _] = curve.eval_with_derivs(hi);
        assert_eq!([bits(start), bits(end)], [bits(curve.start()), bits(curve.end())], "{curve:?}");
    }
}

#[test]
fn are_exact_in_f32() {
    each_family!(f32, are_exact, 300);
}

#[test]
fn are_exact_in_f64() {
    each_family!(f64, are_exact, 300);
}

/// Families with b = [1, 0, …] at the start and [… 0, 1] at the end interpolate the outer control points, or as the
/// Catmull–Rom spline two others.
fn are_control_points<B: Shipped>(first: usize, last: usize) {
    for curve in curves::<B>(300) {
        let [lo, hi] = B::domain();
        let points = curve.control_points();
        assert_eq!(bits(curve.eval(lo)), bits(points[first]), "{curve:?}");
        assert_eq!(bits(curve.eval(hi)), bits(points[last]), "{curve:?}");
    }
}

fn of_interpolating_families<S: Scalar>() {
    are_control_points::<QuadraticBezier<S>>(0, 2);
    are_control_points::<QuarticBernstein<S>>(0, 3);
    are_control_points::<SaidBall<S>>(0, 3);
    are_control_points::<Cubic<S>>(0, 3);
    are_control_points::<Bernstein30<S>>(0, 30);
    are_control_points::<Cardinal<S>>(1, 2);
    are_control_points::<Quadric<S>>(0, 2);
}

#[test]
fn of_interpolating_families_are_control_points() {
    of_interpolating_families::<f32>();
    of_interpolating_families::<f64>();
}
