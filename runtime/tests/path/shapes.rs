//! Arcs, circles, ellipses, rectangles.

use std::f64::consts::{FRAC_PI_2, PI};

use basis_runtime::{ParametricCurve, Path};

use crate::random::Random;

#[test]
fn circles_are_round_and_closed() {
    let circle = Path::<[f64; 2]>::circle([3.0, -1.0], 2.0);
    assert_eq!(circle.segments().len(), 4);
    assert!(circle.is_closed());
    for point in circle.samples(401) {
        assert!(((point[0] - 3.0).hypot(point[1] + 1.0) - 2.0).abs() < 2e-15);
    }
    // Anticlockwise from the first axis, exact at the axes.
    let ends = [0.0, 1.0, 2.0, 3.0].map(|u| circle.eval(u));
    assert_eq!(ends, [[5.0, -1.0], [3.0, 1.0], [1.0, -1.0], [3.0, -3.0]]);
    assert!((circle.arclen(1e-12) - 4.0 * PI).abs() < 1e-11);
    let small = Path::<[f32; 2]>::circle([0.0, 0.0], 1.0);
    assert!(small.samples(100).all(|[x, y]| (x.hypot(y) - 1.0).abs() < 4e-7));
}

#[test]
fn arcs_begin_and_end_at_their_angles() {
    let mut random = Random::new(5);
    for _ in 0..200 {
        let (start, turn) = (random.between(-7.0_f64, 7.0), random.between(-6.2, 6.2));
        let arc = Path::<[f64; 2]>::circle_arc([0.0, 0.0], 1.0, start, turn);
        assert!(arc.segments().len() <= 4 && !arc.is_closed());
        for (point, angle) in [(arc.start(), start), (arc.end(), start + turn)] {
            assert!((point[0] - angle.cos()).abs() < 1e-14 && (point[1] - angle.sin()).abs() < 1e-14);
        }
        assert!((arc.arclen(1e-11) - turn.abs()).abs() < 1e-10, "{start} {turn}");
        // It turns to the left if the turn is positive.
        assert!(arc.curvature(0.1) * turn.signum() > 0.0);
    }
    assert_eq!(Path::<[f64; 2]>::circle_arc([0.0, 0.0], 1.0, 0.0, FRAC_PI_2).segments().len(), 1);
    assert_eq!(Path::<[f64; 2]>::circle_arc([0.0, 0.0], 1.0, 0.0, 100.0), Path::circle([0.0, 0.0], 1.0));
}

#[test]
fn ellipses_in_the_plane_and_in_space() {
    let ellipse = Path::<[f64; 2]>::ellipse([1.0, 2.0], [3.0, 0.5], 0.7);
    let (sin, cos) = 0.7_f64.sin_cos();
    for [x, y] in ellipse.samples(301) {
        let (along, across) = ((x - 1.0) * cos + (y - 2.0) * sin, (y - 2.0) * cos - (x - 1.0) * sin);
        assert!(((along / 3.0).powi(2) + (across / 0.5).powi(2) - 1.0).abs() < 4e-15);
    }
    assert!((ellipse.enclosed().unwrap().area - PI * 1.5).abs() < 1e-14);
    // A circle in the plane across (1, 1, 1).
    let (a, b) = (
        [2.0_f64.sqrt().recip(), -(2.0_f64.sqrt().recip()), 0.0],
        [1.0, 1.0, -2.0].map(|c| c / 6.0_f64.sqrt()),
    );
    let circle = Path::ellipse_arc([0.0; 3], [a, b], 0.3, 4.0);
    for point in circle.samples(100) {
        assert!((point.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 2e-15);
        assert!(point.iter().sum::<f64>().abs() < 1e-15);
    }
}

#[test]
fn rectangles_and_polygons() {
    let rectangle = Path::rectangle([[1.0, 2.0, 5.0], [4.0, 4.0, 9.0]]);
    let corners = [0.0, 1.0, 2.0, 3.0, 4.0].map(|u| rectangle.eval(u));
    assert_eq!(
        corners,
        [[1.0, 2.0, 5.0], [4.0, 2.0, 5.0], [4.0, 4.0, 5.0], [1.0, 4.0, 5.0], [1.0, 2.0, 5.0]]
    );
    assert_eq!(Path::polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap().segments().len(), 3);
    assert_eq!(Path::polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]).unwrap().segments().len(), 2);
}
