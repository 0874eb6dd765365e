//! Surfaces of revolution turn by exactly the angle asked for, in every form.

use core::f64::consts::{FRAC_PI_2, PI};

use basis_runtime::{
    Curve, RevolutionError, Surface, SurfaceDomain, SurfaceOfRevolution, half_turn_parameter,
};

use crate::families::{Cubic, QuarticBernstein};
use crate::random::Random;

const FULL: f64 = 2.0 * PI;

type Vase = SurfaceOfRevolution<QuarticBernstein, [f64; 3]>;

/// The vase of the paper's equation (18), which starts at a pole on the axis.
fn vase(lambda: f64, angle: f64) -> Vase {
    let points = [[0.0, 0.0], [0.5, 0.4], [0.2, 1.8], [1.0, 2.0]];
    let generatrix = Curve::new(QuarticBernstein::new(lambda).unwrap(), points);
    SurfaceOfRevolution::about_x(&generatrix, angle).unwrap()
}

/// The angle about the x axis, in 0 <= α < 2π.
fn turned([_, y, z]: [f64; 3]) -> f64 {
    let angle = z.atan2(y);
    if angle < -1e-12 { angle + FULL } else { angle }
}

fn angles() -> Vec<f64> {
    let random = &mut Random::new(41);
    let mut angles = vec![1e-9, 0.1, FRAC_PI_2, 2.0, PI, PI + 1e-9, 1.5 * PI, FULL - 1e-9, FULL];
    angles.extend((0..50).map(|_| random.between::<f64>(0.01, FULL)));
    angles
}

#[test]
fn ends_at_the_angle() {
    for angle in angles() {
        let surface = vase(0.5, angle);
        assert_eq!(surface.domain(), SurfaceDomain::Rectangle([[0.0, 1.0], [0.0, angle]]));
        let end = surface.eval(1.0, angle);
        assert!((end[1] - 2.0 * angle.cos()).abs() < 1e-14 && (end[2] - 2.0 * angle.sin()).abs() < 1e-14);
        assert_eq!(surface.meridian(angle).eval(1.0), end);
        assert_eq!(surface.is_closed(), angle == FULL);
    }
    assert_eq!(vase(0.5, FULL).eval(0.7, FULL), vase(0.5, FULL).eval(0.7, 0.0));
}

/// Both half-turns together go through every angle from 0 to θ once, and end at θ.
#[test]
fn half_turns_cover_the_angle_without_gap_or_overlap() {
    for angle in angles() {
        let parts = vase(-0.75, angle).half_turns();
        assert_eq!(parts.len(), if angle > PI { 2 } else { 1 });
        let mut last = -1e-15;
        for (k, part) in parts.iter().enumerate() {
            let first = turned(part.eval(0.8, 0.0));
            assert!((first - PI * k as f64).abs() < 1e-15, "part {k} starts at {first}");
            for step in 1..=50 {
                let point = part.eval(0.8, f64::from(step) / 50.0);
                let mut alpha = turned(point);
                if step == 50 && angle == FULL && k == 1 {
                    alpha += FULL; // 0 and 2π are one direction
                }
                assert!(alpha > last, "{alpha} after {last}");
                last = alpha;
            }
        }
        assert!((last - angle).abs() < 1e-14, "{last} instead of {angle}");
    }
}

/// The linear t = θ/π would be wrong by degrees.
#[test]
fn parameters_of_half_turns() {
    assert_eq!(half_turn_parameter(FRAC_PI_2), 0.5);
    assert_eq!(half_turn_parameter(PI), 1.0);
    assert_eq!(half_turn_parameter(0.0_f32), 0.0);
    for k in 0..=100 {
        let angle = PI * f64::from(k) / 100.0;
        let t = half_turn_parameter(angle);
        let w = 1.0 - 2.0 * t + 2.0 * t * t;
        assert!(((1.0 - 2.0 * t) / w - angle.cos()).abs() < 4e-16);
        assert!((2.0 * t * (1.0 - t) / w - angle.sin()).abs() < 4e-16);
    }
    let t = half_turn_parameter(PI / 4.0);
    assert!((t - 0.25).abs() > 0.04);
}

/// `R(s, 0)`, `R(s, 1/2)` and `R(s, 1)` are the three meridians that the paper interpolates.
#[test]
fn the_half_turn_interpolates_three_meridians() {
    let half_turn = vase(1.0, PI).half_turns()[0];
    let generatrix = vase(1.0, PI).meridian(0.0);
    for k in 0..=10 {
        let s = f64::from(k) / 10.0;
        let [x, y, _] = generatrix.eval(s);
        for (t, expected) in [(0.0, [x, y, 0.0]), (0.5, [x, 0.0, y]), (1.0, [x, -y, 0.0])] {
            let point = half_turn.eval(s, t);
            assert!(point.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{point:?} {expected:?}");
        }
    }
}

#[test]
fn rational_patches_are_the_surface() {
    for angle in angles() {
        let surface = vase(-1.5, angle);
        let patches = surface.to_rational_patches();
        assert_eq!(patches.len(), (angle / FRAC_PI_2).ceil() as usize);
        let step = angle / patches.len() as f64;
        for (k, patch) in patches.iter().enumerate() {
            for i in 0..=4 {
                for j in 0..=8 {
                    let (u, x) = (f64::from(i) / 4.0, f64::from(j) / 8.0);
                    let point = patch.eval(u, x);
                    // The rational arc turns by the angle with tan(α/2 - φ/4) = (2x - 1) tan(φ/4).
                    let offset = 2.0 * ((2.0 * x - 1.0) * (step / 4.0).tan()).atan();
                    let expected = surface.eval(u, step * (k as f64 + 0.5) + offset);
                    assert!(
                        point.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14),
                        "{angle} {k} {u} {x}: {point:?} {expected:?}"
                    );
                }
            }
            assert!(patch.weight().rows().iter().flat_map(Curve::control_points).all(|&w| w > 0.7));
        }
        // Neighbours share their seam, bit for bit; a full turn closes.
        for pair in patches.windows(2) {
            assert_eq!(seam(&pair[0], 2), seam(&pair[1], 0));
        }
        if angle == FULL {
            assert_eq!(seam(&patches[3], 2), seam(&patches[0], 0));
        }
    }
}

fn seam(patch: &basis_runtime::RevolutionPatch<QuarticBernstein, [f64; 3]>, j: usize) -> Vec<[f64; 3]> {
    (0..5).map(|i| patch.control_point(i, j).unwrap().0).collect()
}

#[test]
fn partials_of_rational_patches() {
    let patch = vase(0.3, 5.0).to_rational_patches()[1];
    let (u, v, h) = (0.37, 0.61, 1e-4);
    let partials = patch.eval_with_partials::<3>(u, v);
    let difference = |f: &dyn Fn(f64) -> [f64; 3]| {
        let [a, b] = [f(h), f(-h)];
        [0, 1, 2].map(|c| (a[c] - b[c]) / (2.0 * h))
    };
    let checks = [
        (partials[1][0], difference(&|h| patch.eval(u + h, v))),
        (partials[0][1], difference(&|h| patch.eval(u, v + h))),
        (partials[1][1], difference(&|h| patch.eval_with_partials::<2>(u + h, v)[0][1])),
        (partials[0][2], difference(&|h| patch.eval_with_partials::<2>(u, v + h)[0][1])),
        (partials[2][0], difference(&|h| patch.eval_with_partials::<2>(u + h, v)[1][0])),
        (partials[2][2], difference(&|h| patch.eval_with_partials::<3>(u + h, v)[1][2])),
    ];
    for (exact, difference) in checks {
        assert!(exact.iter().zip(difference).all(|(a, b)| (a - b).abs() < 1e-6), "{exact:?} {difference:?}");
    }
}

#[test]
fn partials_turn() {
    let surface = vase(0.3, FULL);
    let (u, v) = (0.4, 2.5);
    let partials = surface.eval_with_partials::<6>(u, v);
    for row in &partials {
        let [_, y, z] = row[0];
        assert!(row[1][0] == 0.0);
        assert!((row[1][1] + z).abs() < 1e-12 && (row[1][2] - y).abs() < 1e-12);
        assert!((row[4][1] - y).abs() < 1e-12 && (row[5][1] + z).abs() < 1e-12);
    }
}

#[test]
fn normals_at_the_pole() {
    // The generatrix leaves the axis at an angle: a cone's apex, with one limit for each meridian.
    let cone = vase(0.0, FULL);
    for k in 0..8 {
        let v = FULL * f64::from(k) / 8.0;
        let (pole, beside) = (cone.normal(0.0, v).unwrap(), cone.normal(1e-7, v).unwrap());
        assert!(pole.iter().zip(beside).all(|(a, b)| (a - b).abs() < 1e-5));
    }
    // It leaves the axis at a right angle: one tangent plane for all meridians.
    let points = [[0.0, 0.0], [0.0, 1.0], [1.0, 2.0], [2.0, 2.0]];
    let dome = SurfaceOfRevolution::about_x(&Curve::new(Cubic::new(), points), FULL).unwrap();
    for k in 0..8 {
        let normal = dome.normal(0.0, FULL * f64::from(k) / 8.0).unwrap();
        assert!((normal[0].abs() - 1.0).abs() < 1e-15, "{normal:?}");
    }
}

#[test]
fn about_any_axis() {
    // The diagonal: a third of a turn permutes the coordinates.
    let points = [[1.0, 0.0, 0.0], [2.0, 0.5, 0.0], [2.0, 1.0, 1.0], [0.0, 3.0, 1.0]];
    let curve = Curve::new(Cubic::new(), points);
    let surface = SurfaceOfRevolution::new(&curve, [5.0; 3], [2.0; 3], FULL).unwrap();
    for k in 0..=10 {
        let u = f64::from(k) / 10.0;
        let ([x, y, z], turned) = (curve.eval(u), surface.eval(u, FULL / 3.0));
        assert!(turned.iter().zip([z, x, y]).all(|(a, b)| (a - b).abs() < 1e-14), "{turned:?}");
        let start = surface.eval(u, 0.0);
        assert!(start.iter().zip([x, y, z]).all(|(a, b)| (a - b).abs() < 1e-14));
    }
}

#[test]
fn refused() {
    let curve = |p: f64| Curve::new(Cubic::new(), [[0.0, 1.0], [1.0, p], [2.0, 1.0], [3.0, 1.0]]);
    for angle in [0.0, -1.0, 6.3, f64::INFINITY] {
        let error = SurfaceOfRevolution::about_x(&curve(1.0), angle).unwrap_err();
        assert_eq!(error, RevolutionError::Angle { value: angle });
    }
    assert!(SurfaceOfRevolution::about_x(&curve(1.0), f64::NAN).is_err());
    for p in [f64::NAN, f64::INFINITY] {
        assert_eq!(SurfaceOfRevolution::about_x(&curve(p), 1.0), Err(RevolutionError::NotFinite));
    }
    let in_space = Curve::new(Cubic::new(), [[0.0; 3]; 4]);
    for axis in [[0.0; 3], [f64::NAN; 3], [f64::INFINITY, 0.0, 0.0]] {
        assert_eq!(SurfaceOfRevolution::new(&in_space, [0.0; 3], axis, 1.0), Err(RevolutionError::Axis));
    }
    assert_eq!(SurfaceOfRevolution::new(&in_space, [f64::NAN; 3], [1.0; 3], 1.0), Err(RevolutionError::Axis));
    assert!(RevolutionError::Angle { value: 7.0 }.to_string().contains("radians"));
}

/// A generatrix on the axis is a surface without area; nothing panics.
#[test]
fn degenerate_generatrices() {
    let axis = Curve::new(Cubic::new(), [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]);
    let surface = SurfaceOfRevolution::about_x(&axis, FULL).unwrap();
    assert_eq!(surface.eval(0.5, 1.0), [1.5, 0.0, 0.0]);
    assert_eq!(surface.normal(0.5, 1.0), None);
    assert_eq!(surface.curvature(0.5, 1.0), None);
}
