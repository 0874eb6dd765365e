//! Where two curves are nearest to each other, against samples and closed forms.

use basis_runtime::{Bezier, ParametricCurve, Path, PathSegment};

use crate::random::Random;

fn apart<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    (0..D).map(|d| (a[d] - b[d]).powi(2)).sum::<f64>().sqrt()
}

/// A random segment of a random degree, polynomial or rational, about a place.
fn segment(random: &mut Random, about: f64) -> Path<[f64; 3]> {
    let count = 2 + random.below(4);
    let points: Vec<[f64; 3]> =
        (0..count).map(|_| [0; 3].map(|_| about + random.between::<f64>(-1.0, 1.0))).collect();
    if random.below(2) == 0 {
        return PathSegment::polynomial(points).unwrap().into();
    }
    let weights: Vec<f64> = points.iter().map(|_| random.between(0.2, 4.0)).collect();
    PathSegment::rational(points, weights).unwrap().into()
}

#[test]
fn of_random_curves() {
    let mut random = Random::new(31);
    for round in 0..40 {
        let (a, b) = (segment(&mut random, 0.0), segment(&mut random, f64::from(round % 4) * 0.8));
        let found = a.closest(&b, 1e-8).unwrap();
        assert!(found.distance - found.at_least <= 1.1e-8, "{found:?}");
        assert_eq!(found.points, [a.eval(found.at[0]), b.eval(found.at[1])]);
        assert!((apart(found.points[0], found.points[1]) - found.distance).abs() < 1e-14);
        // No point of the one is nearer to the other than the bound, and some are as near as was found.
        let nearest =
            a.samples(60).map(|p| b.nearest(p, 1e-6).unwrap().distance).fold(f64::INFINITY, f64::min);
        assert!(found.at_least <= nearest && found.distance <= nearest + 1e-6, "{found:?} {nearest}");
        let exact = b.nearest(found.points[0], 1e-9).unwrap();
        assert!((exact.distance - found.distance).abs() <= 1.2e-8);
        let back = b.closest(&a, 1e-8).unwrap();
        assert!((back.distance - found.distance).abs() <= 1.1e-8);
    }
}

#[test]
fn in_closed_form() {
    // Two circles, one far from the other, one inside, touching ones, and concentric ones.
    let circle = |x: f64, r: f64| Path::<[f64; 2]>::circle([x, 0.5], r);
    for (x, r, expected) in [(5.0, 1.5, 2.5), (0.25, 0.5, 0.25), (1.0, 1.0, 0.0), (0.0, 0.75, 0.25)] {
        let accuracy = if x == 0.0 { 1e-4 } else { 1e-9 };
        let found = circle(0.0, 1.0).closest(&circle(x, r), accuracy).unwrap();
        assert!(
            (found.distance - expected).abs() <= accuracy && found.at_least <= expected,
            "{x}: {found:?}"
        );
    }
    // Two lines that pass each other in space: the distance along the common normal.
    let a = Bezier::from_points([[-1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    let b = Bezier::from_points([[0.0, -3.0, 0.7], [0.0_f64, 1.0, 0.7]]);
    let found = a.closest(&b, 1e-12).unwrap();
    assert!((found.distance - 0.7).abs() < 1e-12 && apart(found.points[0], [0.0; 3]) < 1e-5);
    // Parallel ones, and a point.
    let c = a.map(|[x, y, z]| [x, y + 0.3, z]);
    assert!((a.closest(&c, 1e-6).unwrap().distance - 0.3).abs() < 1e-12);
    let point = Bezier::from_points([[0.5, 1.0, 0.0]]);
    assert!((a.closest(&point, 1e-9).unwrap().distance - 1.0).abs() <= 1e-9);
}

/// The parameter of a curve with sines is not the one in which it is rational.
#[cfg(feature = "macros")]
#[test]
fn of_a_curve_with_another_parameter() {
    basis_runtime::basis! {
        family Quarter {
            domain 0 <= t <= pi/2;
            b[0] = cos(t);
            b[1] = sin(t);
        }
    }
    let arc = basis_runtime::RationalCurve::new(Quarter::new(), [[1.0, 0.0], [0.0, 1.0]]);
    let angle = 0.4_f64;
    let beside = Bezier::from_points([[3.0 * angle.cos(), 3.0 * angle.sin()]]);
    let found = arc.closest(&beside, 1e-12).unwrap();
    assert!((found.at[0] - angle).abs() < 1e-5 && (found.distance - 2.0).abs() < 1e-12, "{found:?}");
    let [x, y] = arc.first_where(0, 0.25).unwrap();
    assert!((x - 0.25).abs() < 1e-15 && (y - 0.9375_f64.sqrt()).abs() < 1e-15);
    // A quarter of a disk less the triangle below its chord.
    let area = arc.enclosed().unwrap().area;
    assert!((area - (std::f64::consts::FRAC_PI_4 - 0.5)).abs() < 1e-14);
    let turned = arc.map(|[x, y]| [-y, x]);
    assert!(apart(turned.eval(0.3), [-0.3_f64.sin(), 0.3_f64.cos()]) < 1e-15);
    let path = Path::from_curve(&arc);
    assert!(path.samples(20).all(|[x, y]| (x.hypot(y) - 1.0).abs() < 1e-15));
    let moved = arc.subsegment(0.2..0.9).unwrap().map(|[x, y]| [2.0 * x + 1.0, y - 3.0]);
    let ends: [[f64; 2]; 2] = [0.2_f64, 0.9].map(|t| [2.0 * t.cos() + 1.0, t.sin() - 3.0]);
    assert!(apart(moved.start(), ends[0]) < 1e-14 && apart(moved.end(), ends[1]) < 1e-14);
}

#[test]
fn of_any_size() {
    let arch = Bezier::from_points([[-1.0, 0.0], [0.0, 2.0], [1.0, 0.0]]);
    let line = Bezier::from_points([[-1.0, 1.5], [1.0, 1.5]]);
    for size in [1e-150, 1e-6, 1e9, 1e150] {
        let scaled = |[x, y]: [f64; 2]| [x * size, y * size];
        let found = arch.map(scaled).closest(&line.map(scaled), 1e-9 * size).unwrap();
        assert!((found.distance / size - 0.5).abs() < 1e-9, "{size}: {found:?}");
    }
    // Beside each other, far from the origin.
    let far = |[x, y]: [f64; 2]| [x + 1e6, y - 1e6];
    let found = arch.map(far).closest(&line.map(far), 1e-9).unwrap();
    assert!((found.distance - 0.5).abs() < 1e-8 && found.at_least <= 0.5, "{found:?}");
    let single = Bezier::from_points([[0.0_f32, 0.0], [1.0, 0.0]]);
    let above = Bezier::from_points([[0.25_f32, 0.5], [0.75, 0.75]]);
    assert!((single.closest(&above, 0.0).unwrap().distance - 0.5).abs() < 1e-5);
    let broken = Bezier::from_points([[f64::NAN, 0.0], [1.0, 0.0]]);
    assert_eq!(arch.closest(&broken, 1e-9), None);
}
