//! Boxes around surfaces contain them, and the tight one touches them.

use core::f64::consts::PI;

use basis_runtime::{
    BernsteinBasis, Bezier, BoxPatch, Curve, Point, RationalSurface, Surface, SurfaceOfRevolution,
    TriangularPatch, basis,
};

use crate::families::{Cubic, Linear, bicubic, graph, random_surface};
use crate::random::Random;

basis!("../../../../specs/triangular.basis", TriangularII(4));

/// Samples of the surface are inside of the tight box and come near its sides; the control box contains it.
fn check<S: Surface<Point = [f64; 3]>>(
    surface: &S,
    [low, high]: [[f64; 3]; 2],
    control: [[f64; 3]; 2],
    slack: f64,
) {
    let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for i in 0..=60 {
        for j in 0..=60 {
            let (x, y) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
            let (u, v) = surface.domain().at(x, y);
            let point = surface.eval(u, v);
            for c in 0..3 {
                least[c] = least[c].min(point[c]);
                most[c] = most[c].max(point[c]);
            }
        }
    }
    for c in 0..3 {
        assert!(low[c] <= least[c] + 1e-13 && low[c] > least[c] - slack, "{c}: {low:?} {least:?}");
        assert!(high[c] >= most[c] - 1e-13 && high[c] < most[c] + slack, "{c}: {high:?} {most:?}");
        assert!(
            control[0][c] <= low[c] + 1e-13 && control[1][c] >= high[c] - 1e-13,
            "{c}: {control:?} {low:?} {high:?}"
        );
    }
}

#[test]
fn of_surfaces_of_revolution() {
    let random = &mut Random::new(62);
    for round in 0..4 {
        let mut point = || core::array::from_fn::<f64, 3, _>(|_| random.between(-1.0, 1.0));
        let generatrix = Curve::new(Cubic::new(), core::array::from_fn(|_| point()));
        let (origin, axis) = (point(), point());
        let angle = if round % 4 == 0 { 2.0 * PI } else { random.between(0.1, 2.0 * PI) };
        let surface = SurfaceOfRevolution::new(&generatrix, origin, axis, angle).unwrap();
        check(&surface, surface.bounding_box(), surface.control_box(), 2e-2);
        for patch in surface.half_turns().into_iter().chain(surface.to_rational_patches()).step_by(2) {
            // A control point at infinity makes the control box of a half-turn infinite.
            check(&patch, patch.bounding_box(), patch.control_box(), 5e-2);
        }
    }
    let sphere = {
        let quarter = RationalSurface::new(
            BernsteinBasis::<_, 1>::new(),
            BernsteinBasis::<_, 3>::new(),
            [[[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]],
            [[1.0, 0.5_f64.sqrt(), 1.0]],
        );
        quarter.bounding_box()
    };
    assert_eq!(sphere, [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
    // The whole circle touches its box in four points only, the cylinder along lines.
    let line = Bezier::from_points([[0.0, 2.0], [1.0, 2.0]]);
    let cylinder = SurfaceOfRevolution::about_x(&line, 2.0 * PI).unwrap();
    assert_eq!(cylinder.bounding_box(), [[0.0, -2.0, -2.0], [1.0, 2.0, 2.0]]);
}

#[test]
fn of_rational_surfaces() {
    let random = &mut Random::new(63);
    for _ in 0..10 {
        let net = core::array::from_fn(|_| {
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)))
        });
        let weights: [[f64; 4]; 2] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(0.2, 3.0)));
        let surface: RationalSurface<Linear, Cubic, [f64; 3]> =
            RationalSurface::new(Linear::new(), Cubic::new(), net, weights);
        check(&surface, surface.bounding_box(), surface.control_box(), 5e-2);
        // The same surface with weights of the other sign.
        let turned =
            RationalSurface::new(Linear::new(), Cubic::new(), net, weights.map(|row| row.map(|w| -w)));
        assert_eq!(turned.bounding_box(), surface.bounding_box());
    }
    // A pole inside: 1/(1 - 2x) is infinite at 1/2.
    let bases = (Linear::new(), Linear::new());
    let net = [[[1.0_f64, 0.0, 0.0]; 2]; 2];
    let pole = RationalSurface::new(bases.0, bases.1, net, [[1.0, -1.0]; 2]);
    assert!(pole.bounding_box()[1][0].is_infinite() && pole.control_box()[1][0].is_infinite());
    let nan = RationalSurface::new(bases.0, bases.1, net, [[1.0, f64::NAN]; 2]);
    assert!(nan.bounding_box()[0][0].is_nan() && nan.control_box()[1][2].is_nan());
}

#[test]
fn of_triangular_patches() {
    let random = &mut Random::new(64);
    for _ in 0..6 {
        let basis = TriangularII::new(random.between(0.1, 3.0), random.between(0.0, 2.0)).unwrap();
        let patch: TriangularPatch<_, [f64; 3]> = TriangularPatch::new(
            basis,
            core::array::from_fn(|_| Point::from_components(|_| random.between(-1.0, 1.0))),
        );
        check(&patch, patch.bounding_box(), patch.control_box(), 5e-2);
    }
}

#[test]
fn contain_the_surface_and_touch_it() {
    let random = &mut Random::new(61);
    for _ in 0..8 {
        let surface = random_surface::<[f64; 3]>(random);
        let ([low, high], [lower, higher]) = (surface.bounding_box(), surface.control_box());
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for i in 0..=100 {
            for j in 0..=100 {
                let point = surface.eval(f64::from(i) / 100.0, f64::from(j) / 100.0);
                for c in 0..3 {
                    least[c] = least[c].min(point[c]);
                    most[c] = most[c].max(point[c]);
                }
            }
        }
        for c in 0..3 {
            assert!(low[c] <= least[c] + 1e-14 && low[c] > least[c] - 1e-2, "{low:?} {least:?}");
            assert!(high[c] >= most[c] - 1e-14 && high[c] < most[c] + 1e-2, "{high:?} {most:?}");
            assert!(lower[c] <= low[c] && higher[c] >= high[c]);
        }
    }
}

#[test]
fn are_tight_inside() {
    let [low, high] = graph(|u, v| u * (1.0 - u) - (v - 0.3) * (v - 0.3)).bounding_box();
    assert!((high[2] - 0.25).abs() < 1e-14 && (low[2] + 2.0 + 1.69).abs() < 1e-14, "{low:?} {high:?}");
    assert_eq!(([low[0], low[1]], [high[0], high[1]]), ([-1.0, -1.0], [1.0, 1.0]));
}

/// A ridge: the largest value along a whole curve across the parameters.
#[test]
fn of_a_ridge_are_nearly_tight() {
    let ridge = graph(|u, v| -(u - v) * (u - v));
    let [low, high] = ridge.bounding_box();
    assert!(high[2] >= 0.0 && high[2] < 1e-4, "{high:?}");
    assert!((low[2] + 4.0).abs() < 1e-14);
}

#[test]
fn of_degenerate_surfaces() {
    assert_eq!(bicubic(|_, _| [1.0, 2.0, 3.0]).bounding_box(), [[1.0, 2.0, 3.0]; 2]);
    let [low, high] =
        bicubic(|i, j| [i as f64, j as f64, if i == 1 { f64::NAN } else { 0.0 }]).bounding_box();
    assert!(low[2].is_nan() && high[2].is_nan());
    assert_eq!((low[0], high[1]), (0.0, 3.0));
    let [low, _] = bicubic(|i, j| [i as f64, j as f64, f64::INFINITY]).bounding_box();
    assert!(low[2].is_nan());
    assert!(bicubic(|i, _| [if i == 3 { f64::NAN } else { 0.0 }; 3]).control_box()[0][0].is_nan());
}

basis! {
    family Brick {
        domain -1 <= x <= 1, 0 <= y <= 3, 0 <= z <= 1;
        b[0] = (1 - x^2)*y*z^3;
        b[1] = x*y^2*(1 - z);
        b[2] = x^3*z - y;
        b[3] = 1 - b[0] - b[1] - b[2];
    }
}

#[test]
fn of_patches_on_boxes() {
    let random = &mut Random::new(63);
    for _ in 0..4 {
        let points: [[f64; 2]; 4] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let patch = BoxPatch::new(Brick::new(), points);
        let ([low, high], control) = (patch.bounding_box(), patch.control_box());
        let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for k in 0..24_u32.pow(3) {
            let part = |digit: u32| f64::from(k / 24_u32.pow(digit) % 24) / 23.0;
            let point = patch.eval_at([2.0 * part(0) - 1.0, 3.0 * part(1), part(2)]);
            for c in 0..2 {
                least[c] = least[c].min(point[c]);
                most[c] = most[c].max(point[c]);
            }
        }
        for c in 0..2 {
            assert!(low[c] <= least[c] + 1e-13 && low[c] > least[c] - 0.1, "{low:?} {least:?}");
            assert!(high[c] >= most[c] - 1e-13 && high[c] < most[c] + 0.1, "{high:?} {most:?}");
            assert!(control[0][c] <= low[c] && control[1][c] >= high[c]);
        }
    }
}
