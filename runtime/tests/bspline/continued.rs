//! Surfaces that continue another one across an edge, polynomial and rational, over any knots.

use basis_runtime::bspline::{
    BSplineSurface, Direction, Edge, EdgePair, KnotVector, Net, NurbsSurface, Orientation,
};
use basis_runtime::{BernsteinBasis, Contact, JoinError, Surface, SurfaceDomain, TensorSurface};
use proptest::prelude::*;

use crate::support::{P3, surface};

const CONTACTS: [Contact<f64>; 5] = [
    Contact::Parametric { order: 0 },
    Contact::Tangent { f: 1.25 },
    Contact::Curvature { f: 0.75, c: 0.5 },
    Contact::Parametric { order: 2 },
    Contact::Scaled { order: 3, f: 1.5 },
];

/// A surface near a plane over knots that are not uniform, of these degrees.
fn sheet(degrees: [usize; 2], spans: [usize; 2], phase: f64) -> BSplineSurface<P3> {
    let [u, v] = [0, 1].map(|k| {
        let breakpoints: Vec<f64> = (0..=spans[k]).map(|i| (i as f64 + phase).powf(1.3)).collect();
        KnotVector::clamped(degrees[k], &breakpoints).unwrap()
    });
    let (gu, gv) = (u.greville(), v.greville());
    let wave = |i: usize, j: usize| 0.2 * (phase + 1.7 * i as f64 + 0.9 * (i * j) as f64).sin();
    let net = Net::from_fn(gu.len(), gv.len(), |i, j| [gu[i] + 0.3 * wave(j, i), gv[j], wave(i, j)]).unwrap();
    BSplineSurface::new(u, v, net).unwrap()
}

fn all_pairs() -> impl Iterator<Item = EdgePair> {
    let edges = Edge::ALL.into_iter().flat_map(|first| Edge::ALL.map(|second| (first, second)));
    edges.flat_map(|(first, second)| {
        [Orientation::Same, Orientation::Opposite].map(|orientation| EdgePair { first, second, orientation })
    })
}

/// The derivatives across an edge up to that order, in the direction in which `first` is left, or `next` entered.
fn across(surface: &dyn Surface<Point = P3>, edge: Edge, x: f64, order: usize, leaves: bool) -> Vec<P3> {
    let (u, v) = surface.domain().on_edge(edge, x);
    let sign = if edge.is_end() == leaves { 1.0_f64 } else { -1.0 };
    let of = |k: usize| {
        let orders = if edge.across() == Direction::U { [k, 0] } else { [0, k] };
        surface.partial(u, v, orders).map(|c| sign.powi(k as i32) * c)
    };
    (0..=order).map(of).collect()
}

/// The derivatives on both sides of the edge agree as the contact says, to within rounding errors of their size.
fn agree(
    first: &dyn Surface<Point = P3>,
    pair: EdgePair,
    contact: Contact<f64>,
    next: &dyn Surface<Point = P3>,
) {
    let order = contact.order();
    for k in 0..=12 {
        let x = f64::from(k) / 12.0;
        let y = if pair.orientation == Orientation::Same { x } else { 1.0 - x };
        // A derivative along the edge jumps at a knot; those across it do not.
        let p = across(first, pair.first, x, order, true);
        let q = across(next, pair.second, y, order, false);
        let (f, c) = match contact {
            Contact::Tangent { f } | Contact::Scaled { f, .. } => (f, 0.0),
            Contact::Curvature { f, c } => (f, c),
            _ => (1.0, 0.0),
        };
        for k in 0..=order {
            for d in 0..3 {
                let extra = if k == 2 { c * q[1][d] } else { 0.0 };
                let size = p[k][d].abs().max(f.powi(k as i32) * q[k][d].abs()).max(1.0);
                let difference = f.powi(k as i32) * q[k][d] + extra - p[k][d];
                assert!(difference.abs() <= 1e-9 * size, "{pair:?} {contact:?} at {x}, {k}: {difference:e}");
            }
        }
    }
}

/// Every edge against every other one, in both directions, whatever the knots and the degrees are.
#[test]
fn of_all_edges() {
    for (first, draft) in [
        (sheet([3, 3], [2, 3], 0.3), sheet([3, 3], [4, 4], 1.0)),
        (sheet([2, 4], [3, 1], 0.0), sheet([3, 4], [2, 3], 0.7)),
        (sheet([1, 1], [1, 2], 0.5), sheet([4, 3], [1, 1], 0.2)),
    ] {
        for pair in all_pairs() {
            for contact in CONTACTS {
                let next = first.continued(pair, contact, &draft).unwrap();
                agree(&first, pair, contact, &next);
                // Beyond the rows that are replaced the surface is what it was.
                let (lo, hi) = (draft.domain().at(0.0, 0.0), draft.domain().at(1.0, 1.0));
                let knots = draft.knots(pair.second.across());
                let spans = knots.breakpoints();
                let far = if pair.second.is_end() { spans[0] } else { spans[spans.len() - 1] };
                for k in 0..=8 {
                    let along = f64::from(k) / 8.0;
                    let (u, v) = match pair.second.across() {
                        Direction::U => (far, lo.1 + (hi.1 - lo.1) * along),
                        Direction::V => (lo.0 + (hi.0 - lo.0) * along, far),
                    };
                    let is_far = knots.functions() > contact.order() + 1;
                    let near = |a: P3, b: P3| (0..3).all(|d| (a[d] - b[d]).abs() < 1e-12);
                    assert!(!is_far || near(next.eval(u, v), draft.eval(u, v)), "{pair:?} {contact:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(basis_test_support::cases(64) as u32))]

    /// Unclamped knots, jumps, and control points far apart.
    #[test]
    fn of_any_knots(
        first in surface(), draft in surface(), ends in (0..4_usize, 0..4_usize), same: bool, order in 0..3_usize
    ) {
        let (first_edge, second) = (Edge::ALL[ends.0], Edge::ALL[ends.1]);
        let orientation = if same { Orientation::Same } else { Orientation::Opposite };
        let pair = EdgePair { first: first_edge, second, orientation };
        let most = draft.knots(second.across()).degree();
        let found = first.continued(pair, Contact::Scaled { order, f: 1.5 }, &draft);
        if order > most {
            prop_assert_eq!(found, Err(JoinError::Contact { most, found: order }));
        } else {
            // Knots that are almost equal after the edges are mapped onto each other may be too many in one place.
            match found {
                Ok(next) => {
                    let edges = [first.boundary(pair.first), next.boundary(pair.second)];
                    for k in 0..40 {
                        let x = (f64::from(k) + 0.31) / 40.0;
                        let y = if same { x } else { 1.0 - x };
                        let [a, b] = [edges[0].eval(at(&edges[0], x)), edges[1].eval(at(&edges[1], y))];
                        prop_assert!((0..3).all(|d| (a[d] - b[d]).abs() < 1e-9), "{:?} {:?}", a, b);
                    }
                }
                Err(error) => prop_assert!(matches!(error, JoinError::Knots), "{:?}", error),
            }
        }
    }
}

fn at(curve: &basis_runtime::bspline::BSplineCurve<P3>, x: f64) -> f64 {
    let [lo, hi] = curve.knots().domain();
    lo + (hi - lo) * x
}

/// One span is a Bézier surface, for which the families say the same.
#[test]
fn as_bezier_surfaces() {
    let net =
        |x: f64| Net::from_fn(4, 4, |i, j| [x + i as f64, j as f64, (x + (i * j) as f64).sin()]).unwrap();
    let array = |net: &Net<P3>| core::array::from_fn(|i| core::array::from_fn(|j| net[[i, j]]));
    let cubic = BernsteinBasis::<f64, 4>::new();
    let tensor = |x: f64| TensorSurface::new(cubic, cubic, array(&net(x)));
    let spline = |x: f64| BSplineSurface::from_bezier(net(x)).unwrap();
    for pair in all_pairs() {
        for contact in CONTACTS {
            let expected = tensor(0.0).continued(pair, contact, &tensor(3.5)).unwrap();
            let found = spline(0.0).continued(pair, contact, &spline(3.5)).unwrap();
            for (k, point) in found.net().as_slice().iter().enumerate() {
                let expected = expected.control_point(k / 4, k % 4).unwrap();
                assert!((0..3).all(|d| (point[d] - expected[d]).abs() < 1e-12), "{pair:?} {contact:?}");
            }
        }
    }
}

/// With weights that change along the edge and across it.
#[test]
fn rational() {
    let weighted = |surface: BSplineSurface<P3>, by: f64| {
        let weights = Net::from_fn(surface.net().rows(), surface.net().columns(), |i, j| {
            by * (1.0 + 0.05 * ((i + 2 * j) as f64).sin())
        });
        let [u, v] = [Direction::U, Direction::V].map(|direction| surface.knots(direction).clone());
        NurbsSurface::new(u, v, surface.net(), &weights.unwrap()).unwrap()
    };
    let first = weighted(sheet([3, 2], [2, 3], 0.3), 1.0);
    for by in [1.0, 1e-3, 40.0] {
        let draft = weighted(sheet([3, 3], [3, 2], 1.0), by);
        for pair in all_pairs() {
            for contact in &CONTACTS[..4] {
                match first.continued(pair, *contact, &draft) {
                    Ok(next) => {
                        agree(&first, pair, *contact, &next);
                        // The mean of the weights stays, and so their size.
                        assert!(next.weights().as_slice().iter().all(|w| (0.0..10.0).contains(&(w / by))));
                    }
                    Err(error) => assert!(error == JoinError::Weights && contact.order() > 0, "{error:?}"),
                }
            }
        }
    }
    let joined = all_pairs().filter(|&pair| first.continued(pair, CONTACTS[2], &first).is_ok());
    assert!(joined.count() > 24);
    // A polynomial surface gives its neighbour polynomial rows, and a polynomial neighbour stays one.
    let polynomial = sheet([3, 2], [2, 3], 0.3);
    let draft = sheet([3, 3], [3, 2], 1.0);
    let pair = EdgePair::against(Edge::VEnd, Edge::UStart);
    let [one, other] = [&polynomial, &draft].map(|surface| NurbsSurface::from(surface.clone()));
    let found = one.continued(pair, CONTACTS[2], &other).unwrap();
    let expected = polynomial.continued(pair, CONTACTS[2], &draft).unwrap();
    assert!(found.weights().as_slice().iter().all(|w| (w - 1.0).abs() < 1e-13));
    for (a, b) in found.net().as_slice().iter().zip(expected.net().as_slice()) {
        assert!((0..3).all(|d| (a[d] - b[d]).abs() < 1e-12), "{a:?} {b:?}");
    }
}

/// Points of any dimension, also numbers; surfaces over other domains; single precision.
#[test]
fn of_other_points() {
    let knots = |lo: f32, hi: f32| KnotVector::clamped(2, &[lo, 0.5 * (lo + hi), hi]).unwrap();
    let heights = |x: f32| {
        let net = Net::from_fn(4, 4, |i, j| x + (i * j) as f32).unwrap();
        BSplineSurface::new(knots(x, x + 3.0), knots(-x, 7.0), net).unwrap()
    };
    let pair = EdgePair::along(Edge::UEnd, Edge::VStart);
    let next = heights(1.0).continued(pair, Contact::Parametric { order: 2 }, &heights(2.0)).unwrap();
    let SurfaceDomain::Rectangle([[lo, hi], _]) = next.domain() else { panic!("a rectangle") };
    for k in 0..=8 {
        let x = k as f32 / 8.0;
        let first = heights(1.0);
        let (u, v) = first.domain().on_edge(Edge::UEnd, x);
        let (s, t) = (lo + (hi - lo) * x, next.domain().ranges()[1][0]);
        for order in 0..=2 {
            let [a, b] = [first.partial(u, v, [order, 0]), next.partial(s, t, [0, order])];
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
    }
}

#[test]
fn refused() {
    let surface = sheet([3, 2], [2, 2], 0.3);
    let pair = EdgePair::along(Edge::UEnd, Edge::VStart);
    let scaled = |order, f| Contact::Scaled { order, f };
    assert_eq!(
        surface.continued(pair, scaled(3, 1.0), &surface),
        Err(JoinError::Contact { most: 2, found: 3 })
    );
    assert_eq!(
        surface.continued(pair, scaled(1, 0.0), &surface),
        Err(JoinError::Factor { name: "f", value: 0.0 })
    );
    let broken = surface.map(|[x, y, _]| [x, y, f64::NAN]);
    assert_eq!(broken.continued(pair, scaled(1, 1.0), &surface), Err(JoinError::NotFinite));
    let rational = NurbsSurface::from(surface.clone());
    // Weights that fall so steeply towards the edge that they would be negative beyond it.
    let weights = Net::from_fn(surface.net().rows(), surface.net().columns(), |i, j| {
        if i == 4 && j == 1 { 0.01 } else { 1.0 }
    });
    let [u, v] = [Direction::U, Direction::V].map(|direction| surface.knots(direction).clone());
    let steep = NurbsSurface::new(u, v, surface.net(), &weights.unwrap()).unwrap();
    let pair = EdgePair::along(Edge::UEnd, Edge::UStart);
    assert!(steep.continued(pair, scaled(0, 1.0), &rational).is_ok());
    assert_eq!(steep.continued(pair, scaled(1, 0.01), &rational), Err(JoinError::Weights));
    assert!(JoinError::Weights.to_string().contains("larger factor"));
}

/// With opposite edges a knot has different sides on both surfaces: limits from the same side of the joint are compared.
#[test]
fn creases_across_opposite_edges_are_no_angle() {
    let knots = |degree| KnotVector::uniform(degree, 2).unwrap();
    let sheet = |from: f64, ridge: f64| {
        let height = |i: usize, j: usize| if j == 1 { ridge * (1.0 + 0.25 * i as f64) } else { 0.0 };
        let net = Net::from_fn(5, 3, |i, j| [from + i as f64, j as f64, height(i, j)]).unwrap();
        BSplineSurface::new(knots(3), knots(1), net).unwrap()
    };
    let (a, c) = (sheet(0.0, 0.4), sheet(5.0, -0.3));
    let pairs = [
        EdgePair::against(Edge::UEnd, Edge::UStart),
        EdgePair::along(Edge::UEnd, Edge::UStart),
        EdgePair::against(Edge::UEnd, Edge::UEnd),
    ];
    for pair in pairs {
        let next = a.continued(pair, Contact::Tangent { f: 1.0 }, &c).unwrap();
        let (joint, bounds) = (a.joint(pair, &next, 65), a.joint_bounds(pair, &next).unwrap());
        assert!(joint.angle <= bounds.angle && joint.gap <= bounds.gap + 1e-14, "{joint:?} {bounds:?}");
        // Where only one of them has a crease it is an angle on one side.
        let bent = a.joint(pair, &sheet(5.0, 0.4), 65);
        assert!(bent.angle > 0.01, "{bent:?}");
    }
}

/// A jump along both edges is no gap, whichever of its sides a surface takes at the knot.
#[test]
fn jumps_along_opposite_edges_are_no_gap() {
    let along = KnotVector::new(1, [0.0, 0.0, 0.5, 0.5, 1.0, 1.0]).unwrap();
    let net = |from: f64, turned: bool| {
        Net::from_fn(2, 4, |i, j| {
            let j = if turned { 3 - j } else { j };
            [from + i as f64, j as f64, if j > 1 { 0.75 } else { 0.0 }]
        })
    };
    let sheet = |from, turned| {
        let across = KnotVector::uniform(1, 1).unwrap();
        BSplineSurface::new(across, along.clone(), net(from, turned).unwrap()).unwrap()
    };
    let pair = EdgePair::against(Edge::UEnd, Edge::UStart);
    let joint = sheet(0.0, false).joint(pair, &sheet(1.0, true), 65);
    assert!(joint.gap < 1e-14 && joint.angle < 1e-14, "{joint:?}");
}
