//! Joined surfaces have the order of contact asked for, and the measurement sees it.

use basis_runtime::{
    BernsteinBasis, Contact, Curve, Direction, Edge, EdgePair, JoinError, Orientation, RationalSurface,
    Surface, SurfaceOfRevolution, TensorSurface,
};

use crate::families::{
    Cubic, FiveParameters, QuarticBernstein, bicubic, graph, random_quartic, random_surface,
};
use crate::random::Random;

const UU: EdgePair = EdgePair::along(Edge::VEnd, Edge::VStart);
const UV: EdgePair = EdgePair::along(Edge::VEnd, Edge::UStart);
const VV: EdgePair = EdgePair::along(Edge::UEnd, Edge::UStart);

fn scaled(order: usize, f: f64) -> Contact<f64> {
    Contact::Scaled { order, f }
}

type Net = [[[f64; 3]; 4]; 4];

fn net(surface: &FiveParameters<[f64; 3]>) -> Net {
    core::array::from_fn(|i| core::array::from_fn(|j| surface.control_point(i, j).unwrap()))
}

/// A random surface near the graph of a plane, so that normals exist and curvatures are of moderate size.
fn sheet(random: &mut Random, x: f64, y: f64) -> Net {
    core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let mut wobble = || random.between::<f64>(-0.3, 0.3);
            [x + i as f64 + wobble(), y + j as f64 + wobble(), wobble()]
        })
    })
}

#[test]
fn u_u() {
    let random = &mut Random::new(71);
    for _ in 0..30 {
        let lambda = random_quartic(random);
        let gammas = core::array::from_fn(|_| random_quartic(random));
        let first = TensorSurface::with_rows(lambda, gammas, sheet(random, 0.0, 0.0));
        let gammas = core::array::from_fn(|_| random_quartic(random));
        let draft = TensorSurface::with_rows(lambda, gammas, sheet(random, 0.0, 3.0));
        let factor = random.between(0.5, 2.0);
        for contact in 0..=2 {
            let next = first.continued(UU, scaled(contact, factor), &draft).unwrap();
            let measured = first.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &next, 33);
            assert_eq!(measured.geometric_order(1e-12, 1e-10, 1e-8), Some(contact), "{measured:?}");
            assert_eq!(measured.normals, Orientation::Same);
            assert_eq!(measured.without_normal, 0);
            for (i, row) in next.rows().iter().enumerate() {
                assert_eq!(row.basis(), gammas[i]);
                assert_eq!(
                    row.control_points()[contact + 1..],
                    draft.rows()[i].control_points()[contact + 1..]
                );
            }
            for k in 0..=8 {
                let u = f64::from(k) / 8.0;
                let [a, b] =
                    [first.eval_with_partials::<3>(u, 1.0)[0], next.eval_with_partials::<3>(u, 0.0)[0]];
                for order in 0..=contact {
                    for c in 0..3 {
                        let expected = factor.powi(order as i32) * b[order][c];
                        assert!((a[order][c] - expected).abs() < 1e-10);
                    }
                }
            }
        }
    }
}

/// Theorem 1 of the paper, with the factors at the differences to which they belong:
/// `(3 + γ¹_i) (P¹_i3 - P¹_i2) = f (3 + γ²_i) (P²_i1 - P²_i0)`.
#[test]
fn u_u_in_the_papers_terms() {
    let random = &mut Random::new(72);
    let first = random_surface::<[f64; 3]>(random);
    let gammas = core::array::from_fn(|_| random_quartic(random));
    let draft = TensorSurface::with_rows(first.u_basis(), gammas, sheet(random, 0.0, 0.0));
    let next = first.continued(UU, scaled(1, 0.8), &draft).unwrap();
    let (p, q) = (net(&first), net(&next));
    for i in 0..4 {
        let (before, after) = (first.rows()[i].basis().lambda(), gammas[i].lambda());
        for c in 0..3 {
            assert_eq!(q[i][0][c], p[i][3][c]);
            let left = (3.0 + before) * (p[i][3][c] - p[i][2][c]);
            assert!((left - 0.8 * (3.0 + after) * (q[i][1][c] - q[i][0][c])).abs() < 1e-13);
        }
    }
}

#[test]
fn u_v() {
    let random = &mut Random::new(73);
    for _ in 0..30 {
        let lambda = random_quartic(random);
        let first = TensorSurface::with_rows(
            lambda,
            core::array::from_fn(|_| random_quartic(random)),
            sheet(random, 0.0, 0.0),
        );
        // The rows of the next surface run along the edge.
        let mut points = sheet(random, 0.0, 3.0);
        points = core::array::from_fn(|i| core::array::from_fn(|j| points[j][i]));
        for contact in 0..=2 {
            let other = random_quartic(random);
            let gammas = core::array::from_fn(|i| if i <= contact { lambda } else { other });
            let draft = TensorSurface::with_rows(random_quartic(random), gammas, points);
            let next = first.continued(UV, scaled(contact, 1.3), &draft).unwrap();
            let measured = first.joint(EdgePair::along(Edge::VEnd, Edge::UStart), &next, 33);
            assert_eq!(measured.geometric_order(1e-12, 1e-10, 1e-8), Some(contact), "{measured:?}");
            assert_eq!(measured.normals, Orientation::Opposite);
            if contact > 0 {
                let mut gammas = gammas;
                gammas[contact] = other;
                let draft = TensorSurface::with_rows(draft.u_basis(), gammas, points);
                let error = first.continued(UV, scaled(contact, 1.0), &draft).unwrap_err();
                assert_eq!(error, JoinError::SecondShape { row: contact });
            }
        }
    }
}

#[test]
fn v_v() {
    let random = &mut Random::new(74);
    for _ in 0..30 {
        let (edge, other) = (random_quartic(random), random_quartic(random));
        for contact in 0..=2 {
            let gammas = core::array::from_fn(|i| if i >= 3 - contact { edge } else { other });
            let first = TensorSurface::with_rows(random_quartic(random), gammas, sheet(random, 0.0, 0.0));
            let gammas = core::array::from_fn(|i| if i <= contact { edge } else { other });
            let draft = TensorSurface::with_rows(random_quartic(random), gammas, sheet(random, 3.0, 0.0));
            let next = first.continued(VV, scaled(contact, 0.7), &draft).unwrap();
            let measured = first.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &next, 33);
            assert_eq!(measured.geometric_order(1e-12, 1e-10, 1e-8), Some(contact), "{measured:?}");
            assert_eq!(measured.normals, Orientation::Same);
            if contact < 2 {
                let error = first.continued(VV, scaled(contact + 1, 1.0), &draft).unwrap_err();
                assert_eq!(error, JoinError::FirstShape { row: 2 - contact });
            }
        }
    }
}

#[test]
fn refused() {
    let random = &mut Random::new(75);
    let first = random_surface::<[f64; 3]>(random);
    let same = TensorSurface::new(first.u_basis(), Cubic::new(), net(&first));
    assert_eq!(first.continued(UU, scaled(4, 1.0), &same), Err(JoinError::Contact { most: 3, found: 4 }));
    assert!(first.continued(UU, scaled(3, 1.0), &same).is_ok());
    for factor in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(
            first.continued(UU, scaled(1, factor), &same),
            Err(JoinError::Factor { name: "f", value: factor })
        );
    }
    assert!(first.continued(UU, scaled(1, f64::NAN), &same).is_err());
    let other = TensorSurface::new(random_quartic(random), Cubic::new(), net(&first));
    assert_eq!(first.continued(UU, scaled(0, 1.0), &other), Err(JoinError::Unreachable));
    // At γ = -3 the derivative at the end is zero whatever the control points are.
    let flat = TensorSurface::new(first.u_basis(), QuarticBernstein::new(-3.0).unwrap(), net(&first));
    assert_eq!(first.continued(UU, scaled(1, 1.0), &flat), Err(JoinError::Undetermined));
    assert!(first.continued(UU, scaled(0, 1.0), &flat).is_ok());
    assert!(JoinError::Undetermined.to_string().contains("shape values"));
}

/// Every edge against every other one, in both directions, to a family that holds the derivatives along the edge, of a
/// higher degree; and a second derivative that is moved along the first.
#[test]
fn of_all_edges() {
    let random = &mut Random::new(76);
    let basis = BernsteinBasis::<f64, 6>::new();
    for first_edge in Edge::ALL {
        for second_edge in Edge::ALL {
            for orientation in [Orientation::Same, Orientation::Opposite] {
                let (edge, along) = (random_quartic(random), random_quartic(random));
                let first = TensorSurface::new(edge, along, sheet(random, 0.0, 0.0));
                let net: [[[f64; 3]; 6]; 6] = core::array::from_fn(|i| {
                    core::array::from_fn(|j| [i as f64, j as f64, random.between(-0.3, 0.3)])
                });
                let draft = TensorSurface::new(basis, basis, net);
                let pair = EdgePair { first: first_edge, second: second_edge, orientation };
                for (contact, order) in [
                    (Contact::Parametric { order: 0 }, 0),
                    (Contact::Tangent { f: 1.25 }, 1),
                    (Contact::Curvature { f: 0.75, c: 0.5 }, 2),
                    (scaled(3, 1.5), 2),
                ] {
                    let next = first.continued(pair, contact, &draft).unwrap();
                    let measured = first.joint(pair, &next, 17);
                    assert_eq!(
                        measured.geometric_order(1e-11, 1e-8, 1e-6),
                        Some(order),
                        "{pair:?} {contact:?} {measured:?}"
                    );
                    let is_kept = |i: usize, j: usize| {
                        let across = if second_edge.across() == Direction::U { i } else { j };
                        let away = if second_edge.is_end() { 5 - across } else { across };
                        away <= contact.order() || next.control_point(i, j) == Some(net[i][j])
                    };
                    assert!((0..36).all(|n| is_kept(n / 6, n % 6)));
                }
            }
        }
    }
}

/// The same of rational surfaces, whose weights change along the edge and across it.
#[test]
fn of_rational_surfaces() {
    let random = &mut Random::new(77);
    let quintic = BernsteinBasis::<f64, 6>::new();
    let mut refused = 0;
    for first_edge in Edge::ALL {
        for second_edge in Edge::ALL {
            for orientation in [Orientation::Same, Orientation::Opposite] {
                let pair = EdgePair { first: first_edge, second: second_edge, orientation };
                let (u, v) = (random_quartic(random), random_quartic(random));
                let net = sheet(random, 0.0, 0.0);
                let weights = core::array::from_fn(|_| core::array::from_fn(|_| random.between(0.95, 1.05)));
                let first = RationalSurface::new(u, v, net, weights);
                let draft: [[[f64; 3]; 6]; 6] = core::array::from_fn(|i| {
                    core::array::from_fn(|j| [i as f64, j as f64, random.between(-0.3, 0.3)])
                });
                let size = random.between(0.01, 100.0);
                let draft = RationalSurface::new(quintic, quintic, draft, [[size; 6]; 6]);
                let flat = RationalSurface::new(u, v, net, [[2.0; 4]; 4]);
                for contact in [
                    Contact::Parametric { order: 0 },
                    Contact::Tangent { f: 1.25 },
                    Contact::Curvature { f: 0.75, c: 0.5 },
                ] {
                    let Ok(next) = first.continued(pair, contact, &draft) else {
                        refused += 1;
                        continue;
                    };
                    let joint = first.joint(pair, &next, 17);
                    let order = joint.geometric_order(1e-11, 1e-8, 1e-6);
                    assert_eq!(order, Some(contact.order()), "{pair:?} {contact:?} {joint:?}");
                    let kept = |i: usize, j: usize| {
                        let across = if second_edge.across() == Direction::U { i } else { j };
                        let away = if second_edge.is_end() { 5 - across } else { across };
                        away <= contact.order() || next.control_point(i, j) == draft.control_point(i, j)
                    };
                    assert!((0..36).all(|n| kept(n / 6, n % 6)));
                    // With equal weights it is the join of the numerators, and all weights stay.
                    let next = flat.continued(pair, contact, &draft).unwrap();
                    let plain = TensorSurface::new(u, v, net).continued(
                        pair,
                        contact,
                        &draft.numerator().map(|p| p.map(|c| c / size)),
                    );
                    for n in 0..36 {
                        let (point, weight) = next.control_point(n / 6, n % 6).unwrap();
                        let expected = plain.unwrap().control_point(n / 6, n % 6).unwrap();
                        assert!((weight / size - 1.0).abs() < 1e-11);
                        assert!((0..3).all(|d| (point[d] - expected[d]).abs() < 1e-9));
                    }
                }
            }
        }
    }
    assert_eq!(refused, 0);
}

/// Circles of two surfaces of revolution, in either direction; what goes on beyond a meridian is the same surface.
#[test]
fn of_surfaces_of_revolution() {
    let random = &mut Random::new(78);
    let axis = [0.3, -0.4, 1.2];
    let mut turned = |basis| {
        let points = core::array::from_fn(|i| [2.0 + i as f64, random.between(-0.5, 0.5), i as f64]);
        SurfaceOfRevolution::new(&Curve::new(basis, points), [0.1, 0.2, 0.3], axis, 4.0).unwrap()
    };
    let [first, draft] = [0.5, -0.7].map(|lambda| turned(QuarticBernstein::new(lambda).unwrap()));
    for first_edge in [Edge::UStart, Edge::UEnd] {
        for second_edge in [Edge::UStart, Edge::UEnd] {
            for orientation in [Orientation::Same, Orientation::Opposite] {
                let pair = EdgePair { first: first_edge, second: second_edge, orientation };
                for contact in [
                    Contact::Parametric { order: 0 },
                    Contact::Tangent { f: 1.25 },
                    Contact::Curvature { f: 0.75, c: 0.5 },
                ] {
                    let next = first.continued(pair, contact, &draft).unwrap();
                    let joint = first.joint(pair, &next, 17);
                    let order = joint.geometric_order(1e-12, 1e-7, 1e-9);
                    assert_eq!(order, Some(contact.order()), "{pair:?} {contact:?} {joint:?}");
                    assert_eq!((next.angle(), next.generatrix().basis()), (4.0, draft.generatrix().basis()));
                }
            }
        }
    }
    let contact = Contact::Tangent { f: 1.0 };
    for pair in [EdgePair::along(Edge::VEnd, Edge::VStart), EdgePair::along(Edge::UEnd, Edge::VStart)] {
        assert_eq!(first.continued(pair, contact, &draft), Err(JoinError::Meridian));
    }
    let high = Contact::Parametric { order: 4 };
    let pair = EdgePair::along(Edge::UEnd, Edge::UStart);
    assert_eq!(first.continued(pair, high, &draft), Err(JoinError::Contact { most: 3, found: 4 }));
}

/// Half a turn about the edge: the tangent planes agree, but the surface comes back.
#[test]
fn a_fold_is_not_smooth() {
    let left = bicubic(|i, j| [i as f64, j as f64, 0.0]);
    let back = bicubic(|i, j| [i as f64, 3.0 - j as f64, 0.0]);
    let on = bicubic(|i, j| [i as f64, 3.0 + j as f64, 0.0]);
    let measured = left.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &back, 9);
    assert_eq!((measured.gap, measured.angle), (0.0, core::f64::consts::PI));
    assert_eq!(measured.geometric_order(1e-9, 1e-3, 1.0), Some(0));
    let measured = left.joint(EdgePair::along(Edge::VEnd, Edge::VStart), &on, 9);
    assert_eq!((measured.gap, measured.angle, measured.curvature), (0.0, 0.0, 0.0));
}

/// The same surface cut in four: every edge against its neighbour, in both directions.
#[test]
fn of_parts_of_one_surface() {
    let bowl = graph(|u, v| u * u + 0.5 * v * v - u * v);
    let [left, right] = bowl.split(Direction::U, 0.25).unwrap();
    let measured = left.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &right, 17);
    assert_eq!(measured.geometric_order(1e-14, 1e-14, 1e-12), Some(2), "{measured:?}");
    let turned = bowl.subpatch(0.25..1.0, 1.0..-1.0).unwrap();
    let measured = left.joint(EdgePair::against(Edge::UEnd, Edge::UStart), &turned, 17);
    assert_eq!(measured.geometric_order(1e-14, 1e-14, 1e-12), Some(2), "{measured:?}");
    assert_eq!(measured.normals, Orientation::Opposite);
    let apart = left.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &turned, 17);
    assert_eq!(apart.geometric_order(1e-3, 1.0, 1.0), None);
}

/// The difference of curvature is measured: a parabola continued by its tangent plane.
#[test]
fn differences_of_curvature() {
    let parabola = graph(|u, _| (u - 1.0) * (u - 1.0));
    let flat = bicubic(|i, j| [1.0 + i as f64, 2.0 * j as f64 / 3.0 - 1.0, 0.0]);
    let measured = parabola.joint(EdgePair::along(Edge::UEnd, Edge::UStart), &flat, 9);
    assert!(measured.angle < 1e-15 && (measured.curvature - 2.0).abs() < 1e-13, "{measured:?}");
}

/// The places of the largest figures are parameters of the first surface, along its edge.
#[test]
fn where_figures_are_largest() {
    // A gap that opens towards the end, an angle that is largest in the middle, a curvature that is at the start.
    let flat = bicubic(|i, j| [i as f64 - 3.0, j as f64, 0.0]);
    let opening = bicubic(|i, j| [i as f64, j as f64, 0.125 * j as f64]);
    let bent = bicubic(|i, j| [i as f64, j as f64, if i == 1 && (j == 1 || j == 2) { 0.5 } else { 0.0 }]);
    let curved = bicubic(|i, j| [i as f64, j as f64, if i == 2 && j == 0 { 0.5 } else { 0.0 }]);
    let pair = EdgePair::along(Edge::UEnd, Edge::UStart);
    let domain = flat.domain().ranges()[1];
    let [joint, angle, curvature] = [opening, bent, curved].map(|next| flat.joint(pair, &next, 17));
    assert_eq!((joint.gap, joint.gap_at), (0.375, domain[1]));
    assert_eq!(angle.angle_at, 0.5 * (domain[0] + domain[1]));
    assert!((angle.angle - 0.375_f64.atan()).abs() < 1e-14, "{angle:?}");
    assert_eq!(angle.geometric_order(1e-9, 0.5, 1e9), Some(2));
    assert_eq!((curvature.curvature_at, curvature.geometric_order(1e-9, 1e-9, 1e-9)), (domain[0], Some(1)));
    let reversed = opening.joint(EdgePair::along(Edge::UStart, Edge::UEnd), &flat, 17);
    assert_eq!((reversed.gap, reversed.gap_at), (joint.gap, opening.domain().ranges()[1][1]));
    let none = bicubic(|_, _| [0.0; 3]);
    let joint = none.joint(pair, &none, 3);
    assert!(joint.angle_at.is_nan() && joint.curvature_at.is_nan() && joint.gap_at == domain[0], "{joint:?}");
}

#[test]
fn along_an_edge_that_is_a_point() {
    let pole = |side: f64| bicubic(|i, j| [side * i as f64, i as f64 * (j as f64 - 1.5), 0.0]);
    let measured = pole(1.0).joint(EdgePair::along(Edge::UStart, Edge::UStart), &pole(-1.0), 9);
    assert_eq!((measured.gap, measured.without_normal), (0.0, 0));
    assert!(measured.angle < 1e-15);
    assert_eq!(measured.without_curvature, 9);
    assert!(measured.curvature.is_nan());
    let point = bicubic(|_, _| [0.0; 3]);
    let measured = point.joint(EdgePair::along(Edge::UStart, Edge::UStart), &point, 0);
    assert_eq!(measured.without_normal, 2);
    assert!(measured.angle.is_nan());
    assert_eq!(measured.geometric_order(1.0, 1.0, 1.0), Some(0));
}
