//! Normals, and their limits where the product of the partial derivatives vanishes.

use basis_runtime::{Surface, TensorSurface};

use crate::families::{FiveParameters, Lagrange2, QuarticBernstein, bicubic, graph, random_surface};
use crate::random::Random;

fn near(a: [f64; 3], b: [f64; 3], tolerance: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
}

#[test]
fn are_perpendicular_and_of_length_one() {
    let random = &mut Random::new(21);
    for _ in 0..100 {
        let surface = random_surface::<[f64; 3]>(random);
        let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
        let normal = surface.normal(u, v).unwrap();
        let [[_, along_v], [along_u, _]] = surface.eval_with_partials(u, v);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        assert!(dot(normal, along_u).abs() < 1e-13 && dot(normal, along_v).abs() < 1e-13);
        assert!((dot(normal, normal) - 1.0).abs() < 1e-15);
    }
}

#[test]
fn point_where_u_then_v_turns_left() {
    assert_eq!(graph(|_, _| 7.0).normal(0.3, 0.4), Some([0.0, 0.0, 1.0]));
    let tilted = graph(|u, _| u).normal(0.3, 0.4).unwrap();
    let half = 0.5_f64.sqrt();
    assert!(near(tilted, [-half, 0.0, half], 1e-15));
}

/// A net whose first row is one point; its neighbour row decides on the normals at the pole.
fn fan(height: f64) -> FiveParameters<[f64; 3]> {
    let quartic = |shape| QuarticBernstein::new(shape).unwrap();
    let net = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let (i, j) = (i as f64, j as f64);
            [i, i * (j - 1.5), height * i * (j - 1.5) * (j - 1.5)]
        })
    });
    TensorSurface::with_rows(quartic(-2.0), [-3.0, 0.5, 1.0, -1.0].map(quartic), net)
}

#[test]
fn have_limits_at_a_pole() {
    for height in [0.0, 1.0, -0.3] {
        let surface = fan(height);
        for k in 0..=16 {
            let v = f64::from(k) / 16.0;
            assert_eq!(surface.eval_with_partials::<2>(0.0, v)[0][1], [0.0; 3]);
            let at_pole = surface.normal(0.0, v).unwrap();
            for (u, tolerance) in [(1e-3, 2e-2), (1e-6, 2e-5), (1e-9, 1e-6), (1e-13, 1e-6), (1e-17, 1e-12)] {
                let beside = surface.normal(u, v).unwrap();
                assert!(
                    near(at_pole, beside, tolerance),
                    "height {height}, v = {v}, u = {u}: {at_pole:?} {beside:?}"
                );
            }
        }
    }
}

/// The same pole at the other end of the parameter: the limit comes from inside the domain, so it has the same side.
#[test]
fn have_limits_at_a_pole_at_the_upper_end() {
    let surface = fan(0.7);
    let reversed = TensorSurface::with_rows(
        surface.u_basis(),
        core::array::from_fn(|i| surface.rows()[3 - i].basis()),
        core::array::from_fn(|i| core::array::from_fn(|j| surface.control_point(3 - i, j).unwrap())),
    );
    for k in 0..=8 {
        let v = f64::from(k) / 8.0;
        let (a, b) = (surface.normal(0.0, v).unwrap(), reversed.normal(1.0, v).unwrap());
        assert!(near(a, b.map(|c| -c), 1e-12), "{a:?} {b:?}");
        assert!(near(b, reversed.normal(1.0 - 1e-5, v).unwrap(), 1e-4));
    }
}

/// In f32 too, where rounding errors are large.
#[test]
fn have_limits_at_a_pole_in_f32() {
    let surface = fan(1.0);
    let single = TensorSurface::with_rows(
        QuarticBernstein::new(-2.0_f32).unwrap(),
        [-3.0, 0.5, 1.0, -1.0].map(|gamma| QuarticBernstein::new(gamma).unwrap()),
        core::array::from_fn(|i| {
            core::array::from_fn(|j| surface.control_point(i, j).unwrap().map(|c| c as f32))
        }),
    );
    for k in 0..=8 {
        let v = f64::from(k) / 8.0;
        let (double, single) = (surface.normal(0.0, v).unwrap(), single.normal(0.0, v as f32).unwrap());
        assert!(near(double, single.map(f64::from), 1e-4));
    }
}

/// Rows 0 and 1 coincide: the product vanishes to the third order.
#[test]
fn have_limits_at_a_pole_of_higher_order() {
    let surface = bicubic(|i, j| {
        let (r, j) = (i.saturating_sub(1) as f64, j as f64);
        [r, r * j, r * r * 0.25]
    });
    for v in [0.0, 0.25, 0.5, 1.0] {
        let (pole, beside) = (surface.normal(0.0, v).unwrap(), surface.normal(1e-4, v).unwrap());
        assert!(near(pole, beside, 1e-2), "{pole:?} {beside:?}");
    }
}

/// Two edges meet in a straight angle: S_u and S_v are parallel at the corner, yet the normal has a limit.
#[test]
fn have_limits_at_a_straight_corner() {
    let surface = bicubic(|i, j| {
        let (i, j) = (i as f64, j as f64);
        [i - j, i * j, 0.0]
    });
    let [[_, v], [u, _]] = surface.eval_with_partials(0.0, 0.0);
    assert_eq!([u, v], [[3.0, 0.0, 0.0], [-3.0, 0.0, 0.0]]);
    assert_eq!(surface.normal(0.0, 0.0), Some([0.0, 0.0, 1.0]));
}

#[test]
fn do_not_exist_where_two_poles_meet() {
    // Row 0 and column 0 are one point, and the normals near it depend on the direction.
    let surface =
        bicubic(
            |i, j| {
                if i == 0 || j == 0 { [0.0; 3] } else { [(i * i) as f64, (j * j) as f64, (i * j) as f64] }
            },
        );
    assert_eq!(surface.normal(0.0, 0.0), None);
    assert!(surface.normal(0.0, 0.5).is_some() && surface.normal(0.5, 0.0).is_some());
}

#[test]
fn do_not_exist_on_a_fold() {
    // x = u², the sheet folded along u = 0: the normal flips.
    let net: [[[f64; 3]; 3]; 3] = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let (u, v) = (i as f64 - 1.0, j as f64 - 1.0);
            [u * u, v, 0.0]
        })
    });
    let folded = TensorSurface::new(Lagrange2::new(), Lagrange2::new(), net);
    assert_eq!(folded.normal(0.0, 0.2), None);
    assert_eq!(folded.normal(0.5, 0.2), Some([0.0, 0.0, 1.0]));
    assert_eq!(folded.normal(-0.5, 0.2), Some([0.0, 0.0, -1.0]));
}

#[test]
fn do_not_exist_on_curves_points_and_what_is_not_finite() {
    assert_eq!(bicubic(|_, _| [1.0, 2.0, 3.0]).normal(0.5, 0.5), None);
    assert_eq!(bicubic(|i, _| [i as f64, 1.0, 0.1]).normal(0.5, 0.5), None);
    assert_eq!(bicubic(|i, j| [(i + j) as f64 / 3.0, 0.0, 0.1]).normal(0.3, 0.0), None);
    assert_eq!(bicubic(|i, j| [i as f64, j as f64, f64::NAN]).normal(0.5, 0.5), None);
    assert_eq!(bicubic(|i, j| [i as f64, j as f64, f64::INFINITY]).normal(0.5, 0.5), None);
    assert_eq!(graph(|_, _| 0.0).normal(f64::NAN, 0.0), None);
    assert_eq!(graph(|_, _| 0.0).normal(0.0, f64::INFINITY), None);
}

#[test]
fn do_not_depend_on_the_size() {
    for size in [1e-200, 1e-30, 1.0, 1e30, 1e150] {
        let surface = bicubic(|i, j| [size * i as f64, size * j as f64, 0.0]);
        assert_eq!(surface.normal(0.25, 0.5), Some([0.0, 0.0, 1.0]));
        let pole = bicubic(|i, j| [size * i as f64, size * (i * j) as f64, 0.0]);
        assert_eq!(pole.normal(0.0, 0.5), Some([0.0, 0.0, 1.0]));
    }
}
