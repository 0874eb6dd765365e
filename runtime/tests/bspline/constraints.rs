//! Point constraints and projections.

use basis_runtime::bspline::{BSplineSurface, ConstraintError, Direction, KnotVector, Net, PointConstraint};
use proptest::prelude::*;

use crate::support::{P3, distance, point, surface};

fn plane() -> BSplineSurface<P3> {
    let knots = KnotVector::uniform(3, 4).unwrap();
    let greville = knots.greville();
    let net = Net::from_fn(7, 7, |i, j| [greville[i], greville[j], 0.0]).unwrap();
    BSplineSurface::new(knots.clone(), knots, net).unwrap()
}

#[test]
fn the_change_is_the_least_one() {
    // One constraint: ΔP = N (point - S) / Σ N².
    let plane = plane();
    let found = plane.pass_through(&[PointConstraint::At([0.4, 0.7], [0.4, 0.7, 2.0])]).unwrap();
    let (fu, u) = plane.knots(Direction::U).values(0.4).unwrap();
    let (fv, v) = plane.knots(Direction::V).values(0.7).unwrap();
    let squares: f64 = u.iter().flat_map(|a| v.iter().map(move |b| (a * b).powi(2))).sum();
    for i in 0..7 {
        for j in 0..7 {
            let factor = |first: usize, values: &[f64], i: usize| {
                i.checked_sub(first).and_then(|i| values.get(i)).copied().unwrap_or(0.0)
            };
            let expected = factor(fu, &u, i) * factor(fv, &v, j) / squares * 2.0;
            assert!((found.surface.net()[[i, j]][2] - expected).abs() < 1e-14);
        }
    }
    assert!((found.change - 2.0 / squares.sqrt()).abs() < 1e-13);
    assert!(found.miss < 1e-14);
}

#[test]
fn an_infeasible_set_says_which() {
    let plane = plane();
    let at = |u, v, z| PointConstraint::At([u, v], [u, v, z]);
    let twice = plane.pass_through(&[at(0.1, 0.1, 0.0), at(0.5, 0.5, 1.0), at(0.5, 0.5, 2.0)]).unwrap_err();
    let ConstraintError::Infeasible { constraint: 2, against, distance } = &twice else { panic!("{twice}") };
    assert_eq!(against, &[1]);
    assert!((distance - 1.0).abs() < 1e-14);
    assert!(twice.to_string().starts_with("constraint 2 contradicts 1: these determine the surface"));

    // On the edge v = 0 of the first span there are four coefficients for five points.
    let points = [0.0, 0.05, 0.1, 0.15, 0.2];
    let mut five: Vec<_> = points.iter().map(|&u| at(u, 0.0, u * u * u)).collect();
    assert!(plane.pass_through(&five).is_ok()); // a cubic
    five[4] = at(0.2, 0.0, 1.0);
    let error = plane.pass_through(&five).unwrap_err();
    let ConstraintError::Infeasible { constraint: 4, against, .. } = error else { panic!("{error}") };
    assert_eq!(against, [0, 1, 2, 3]);

    // The same point twice is no contradiction.
    assert!(plane.pass_through(&[at(0.5, 0.5, 1.0), at(0.5, 0.5, 1.0)]).is_ok());
}

#[test]
fn a_contradiction_is_seen_whatever_the_units_and_the_origin() {
    for (unit, offset) in
        [(1.0, 0.0), (1e-6, 0.0), (1e-300, 0.0), (1e6, 0.0), (1e200, 0.0), (1.0, 1e6), (1e-3, 1e3)]
    {
        let surface = plane().map(|p| p.map(|x| x * unit + offset));
        let at = |parameters: [f64; 2], height: f64| {
            let [x, y, z] = surface.eval(parameters[0], parameters[1]);
            PointConstraint::At(parameters, [x, y, z + height * unit])
        };
        let (p, q, r) = ([0.5, 0.5], [0.1 + 0.2, 0.7], [0.3, 0.7]); // q and r differ by a rounding error
        let fine = surface.pass_through(&[at(p, 0.5), at(q, 0.25), at(r, 0.25), at(p, 0.5)]).unwrap();
        assert!(fine.miss <= 1e-15 * (unit + offset), "{unit} {offset}: {}", fine.miss);
        let error = surface.pass_through(&[at(p, 0.5), at(q, 0.25), at(r, 0.25001)]).unwrap_err();
        let ConstraintError::Infeasible { constraint: 2, against, distance } = error else {
            panic!("{error}")
        };
        assert_eq!(against, [1]);
        assert!((distance / unit - 1e-5).abs() < 1e-8, "{unit} {offset}: {distance}");
    }
}

#[test]
fn constraints_close_together_are_met_by_a_surface_that_meets_them() {
    // Points of another surface at parameters that are hardly different.
    let plane = plane();
    let other = plane.map(|[x, y, _]| [x, y, (3.0 * x + 2.0 * y).sin()]);
    for step in [1e-4, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-15] {
        let at = [[0.4, 0.4], [0.4 + step, 0.4], [0.4, 0.4 + step]];
        let constraints = at.map(|at| PointConstraint::At(at, other.eval(at[0], at[1])));
        let found = plane.pass_through(&constraints).unwrap();
        assert!(found.miss < 1e-12, "{step}: {}", found.miss);
    }
}

#[test]
fn points_out_of_reach() {
    let far = plane().pass_through(&[PointConstraint::At([0.4, 0.4], [1.7e308, 0.0, 0.0])]);
    assert_eq!(far.unwrap_err(), ConstraintError::Overflow);
    let knots = KnotVector::<f32>::uniform(3, 4).unwrap();
    let net = Net::from_fn(7, 7, |i, j| [i as f32, j as f32, 0.0]).unwrap();
    let surface = BSplineSurface::new(knots.clone(), knots, net).unwrap();
    let far = surface.pass_through(&[PointConstraint::At([0.4, 0.4], [3e38_f32, 0.0, 0.0])]);
    assert_eq!(far.unwrap_err(), ConstraintError::Overflow);
}

#[test]
fn held_control_points_stay_or_are_the_reason() {
    let plane = plane();
    let wanted = [PointConstraint::At([0.05, 0.5], [0.0, 0.5, 1.0])];
    let found = plane.pass_through_holding(&wanted, |row, _| row < 2).unwrap();
    assert!(found.miss < 1e-14);
    assert_eq!(found.surface.net().row(0), plane.net().row(0));
    assert_eq!(found.surface.net().row(1), plane.net().row(1));
    let error = plane.pass_through_holding(&wanted, |row, _| row < 4).unwrap_err();
    let ConstraintError::Infeasible { constraint: 0, against, .. } = &error else { panic!("{error}") };
    assert!(against.is_empty() && error.to_string().contains("held"));
}

#[test]
fn what_cannot_be_read() {
    let plane = plane();
    let error = plane.pass_through(&[PointConstraint::At([0.5, 1.5], [0.0; 3])]).unwrap_err();
    assert!(matches!(error, ConstraintError::Outside { constraint: 0, .. }));
    let error = plane.pass_through(&[PointConstraint::Nearest([f64::NAN; 3])]).unwrap_err();
    assert_eq!(error, ConstraintError::NotFinite { constraint: 0 });
    let mut broken = plane.clone();
    broken.control_points_mut()[3] = [f64::INFINITY; 3];
    assert_eq!(broken.pass_through(&[]).unwrap_err(), ConstraintError::Surface);
    assert_eq!(plane.pass_through(&[]).unwrap().surface, plane);
}

#[test]
fn projected_constraints_in_single_precision() {
    let knots = KnotVector::<f32>::uniform(3, 4).unwrap();
    let net = Net::from_fn(7, 7, |i, j| [i as f32, j as f32, 0.0]).unwrap();
    let surface = BSplineSurface::new(knots.clone(), knots, net).unwrap();
    let target = [2.5_f32, 3.5, 0.75];
    let found = surface.pass_through(&[PointConstraint::Nearest(target)]).unwrap();
    let [u, v] = found.parameters[0];
    let reached = found.surface.eval(u, v);
    assert!((0..3).all(|i| (reached[i] - target[i]).abs() < 1e-5));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn all_constraints_are_met(
        surface in surface(),
        wanted in prop::collection::vec(([0.0..=1.0, 0.0..=1.0], point()), 1..5),
    ) {
        let constraints: Vec<_> = wanted.iter().map(|&(at, point)| PointConstraint::At(at, point)).collect();
        match surface.pass_through(&constraints) {
            Ok(found) => {
                for (at, point) in &wanted {
                    let size = 1.0 + found.change;
                    prop_assert!(distance(found.surface.eval(at[0], at[1]), *point) < 1e-12 * size);
                }
            }
            Err(error) => {
                let too_many = wanted.len() > 4;
                prop_assert!(too_many, "{}", error);
            }
        }
    }
}
