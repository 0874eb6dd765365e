//! Tangents, curvature, torsion and frames, compared with curves for which they are known.

use basis_runtime::{Bezier, Curve, CurveError, Frame};

use crate::families::QuarticBernstein;
use crate::random::Random;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// (t, t², t³) over 0..1.
fn twisted_cubic() -> Bezier<[f64; 3], 4> {
    Bezier::from_points([
        [0.0, 0.0, 0.0],
        [1.0 / 3.0, 0.0, 0.0],
        [2.0 / 3.0, 1.0 / 3.0, 0.0],
        [1.0, 1.0, 1.0],
    ])
}

#[test]
fn curvature_and_torsion_of_the_twisted_cubic() {
    for t in [0.0_f64, 0.25, 0.5, 1.0] {
        let speed = 1.0 + 4.0 * t * t + 9.0 * t.powi(4);
        let area = 9.0 * t.powi(4) + 9.0 * t * t + 1.0; // |C' × C''|² / 4
        assert!((twisted_cubic().curvature(t) - 2.0 * area.sqrt() / speed.powf(1.5)).abs() < 1e-14);
        assert!((twisted_cubic().torsion(t) - 3.0 / area).abs() < 1e-13);
    }
}

#[test]
fn curvature_has_a_sign_in_the_plane_only() {
    let left = Bezier::from_points([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0_f64]]);
    assert!(left.curvature(0.3) > 0.0 && left.reversed().curvature(0.7) < 0.0);
    let space = Bezier::from_points([[1.0, 1.0, 5.0], [1.0, 0.0, 5.0], [0.0, 0.0, 5.0_f64]]);
    assert!((space.curvature(0.7) - left.curvature(0.3)).abs() < 1e-14);
    assert_eq!(Bezier::from_points([0.0, 1.0, 5.0_f64]).curvature(0.5), 0.0);
}

#[test]
fn tangents_where_the_velocity_vanishes() {
    // λ = -3: both ends have the velocity zero.
    let curve =
        Curve::new(QuarticBernstein::new(-3.0).unwrap(), [[0.0, 0.0], [7.0, -1.0], [9.0, 3.0], [4.0, 0.0]]);
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-4;
    let [start, end] = [curve.tangent(0.0).unwrap(), curve.tangent(1.0).unwrap()];
    assert!(near(start, curve.tangent(1e-6).unwrap()) && near(end, curve.tangent(1.0 - 1e-6).unwrap()));
    // A cusp at 1/2 with the tangent (±1, 0): it leaves to the right.
    let cusp = Bezier::from_points([[1.0, -1.0], [-1.0 / 3.0, 1.0], [-1.0 / 3.0, -1.0], [1.0, 1.0]]);
    assert!(near(cusp.tangent(0.5).unwrap(), [1.0, 0.0]));
    // Three coincident points.
    let late = Bezier::from_points([[0.1, 0.2], [0.1, 0.2], [0.1, 0.2], [3.1, 4.2]]);
    assert!(near(late.tangent(0.0).unwrap(), [0.6, 0.8]));
    assert!(near(late.reversed().tangent(1.0).unwrap(), [-0.6, -0.8]));
    assert_eq!(Bezier::from_points([[0.1, 0.2]; 5]).tangent(0.3), None);
    assert_eq!(Bezier::from_points([[0.1, 0.2], [f64::NAN, 1.0]]).tangent(0.3), None);
}

fn assert_orthonormal(frame: &Frame<[f64; 3]>) {
    let Frame { tangent, normal, binormal, .. } = *frame;
    for unit in [tangent, normal, binormal] {
        assert!((dot(unit, unit) - 1.0).abs() < 1e-14);
    }
    assert!(dot(tangent, normal).abs() < 1e-15 && dot(tangent, binormal).abs() < 1e-15);
    assert!(dot(normal, binormal).abs() < 1e-15);
}

#[test]
fn frenet_frames() {
    let frame = twisted_cubic().frenet_frame(0.0).unwrap();
    assert_eq!(
        [frame.tangent, frame.normal, frame.binormal],
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    );
    for i in 0..=10 {
        assert_orthonormal(&twisted_cubic().frenet_frame(f64::from(i) / 10.0).unwrap());
    }
    let line = Bezier::from_points([[0.1, 0.2, 0.3], [0.2, 0.4, 0.6], [0.7, 1.4, 2.1_f64]]);
    assert_eq!(line.frenet_frame(0.25), Err(CurveError::NoNormal { parameter: 0.25 }));
    assert_eq!(Bezier::from_points([[1.0_f64; 3]; 3]).frenet_frame(0.25), Err(CurveError::NoTangent));
    // With equal steps the second derivative is nothing but rounding errors.
    for offset in [0.0, 1e6] {
        let line = Bezier::from_points([[0.1 + offset, 0.7, 0.3], [0.33 + offset, 0.15, 0.9]]).elevate::<6>();
        for parameter in [0.0, 0.3, 0.77, 1.0] {
            assert_eq!(line.frenet_frame(parameter), Err(CurveError::NoNormal { parameter }));
        }
    }
}

/// The exact frame turns against the Frenet frame by minus the integral of torsion over length.
#[test]
fn rotation_minimizing_frames_turn_as_the_torsion_says() {
    let curve = twisted_cubic();
    let first = curve.frenet_frame(0.0).unwrap();
    let turn = |count: usize| {
        let frames = curve.rotation_minimizing_frames(count, Some(first.normal)).unwrap();
        frames.iter().for_each(assert_orthonormal);
        let (last, frenet) = (frames[count - 1], curve.frenet_frame(1.0).unwrap());
        dot(last.normal, frenet.binormal).atan2(dot(last.normal, frenet.normal))
    };
    // ∫ τ |C'| dt by Simpson's rule.
    let speed = |t: f64| (1.0 + 4.0 * t * t + 9.0 * t.powi(4)).sqrt();
    let f = |i: u32| curve.torsion(f64::from(i) / 1000.0) * speed(f64::from(i) / 1000.0);
    let weight = |i: u32| if i == 0 || i == 1000 { 1.0 } else { 2.0 + f64::from(i % 2) * 2.0 };
    let exact: f64 = -(0..=1000).map(|i| weight(i) * f(i)).sum::<f64>() / 3000.0;
    let [coarse, fine] = [(turn(21) - exact).abs(), (turn(41) - exact).abs()];
    assert!(coarse < 1e-4 && fine < coarse / 12.0, "{coarse:e} {fine:e}"); // fourth order
}

#[test]
fn frames_of_straight_and_degenerate_curves() {
    let line = Bezier::from_points([[0.0, 0.0, 0.0], [1.0, 2.0, 2.0_f64]]);
    let frames = line.rotation_minimizing_frames(4, None).unwrap();
    frames.iter().for_each(assert_orthonormal);
    assert!(frames.windows(2).all(|pair| dot(pair[0].normal, pair[1].normal) > 1.0 - 1e-14));
    // A normal along the tangent is no normal.
    let frames = line.rotation_minimizing_frames(2, Some([2.0, 4.0, 4.0])).unwrap();
    frames.iter().for_each(assert_orthonormal);
    let point = Bezier::from_points([[1.0_f64; 3]; 3]);
    assert_eq!(point.rotation_minimizing_frames(3, None), Err(CurveError::NoTangent));
    assert_eq!(point.rotation_minimizing_frames(0, None), Ok(vec![]));
    let random = &mut Random::new(85);
    for _ in 0..50 {
        let points: [[f64; 3]; 4] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let curve = Curve::new(QuarticBernstein::new(random.between(-3.0, 1.0)).unwrap(), points);
        curve.rotation_minimizing_frames(10, None).unwrap().iter().for_each(assert_orthonormal);
    }
}
