//! Patches on triangles, tetrahedra and boxes.

use basis_runtime::{
    BoxPatch, Direction, Edge, EdgeBasis, EdgePair, SimplexBasis as _, SimplexIndex, SimplexPatch, Surface,
    SurfacePiece, TetrahedronIndex, TriangleContact, TriangleEdge, TriangleIndex, TriangularBernsteinBasis,
    TriangularBezier, TriangularPatch, basis,
};

use crate::surfaces::{any, areas_and_edges};
use crate::{Case, NUMBERS, P, check, is_box, is_finite, is_length, is_nan, is_unit};

basis!("../../../specs/triangular.basis", TriangularI(2), TriangularII(3));
basis!("../../../specs/lagrange.basis", Serendipity, TetrahedralLagrange(2));

type Triangle = TriangularPatch<TriangularII, P>;

const TRIANGLE: &[Case<Triangle>] = &[
    ("new", |_, a, b| TriangularII::new(a, b).is_ok() == (a > 0.0 && a <= 3.0 && (0.0..=2.0).contains(&b))),
    ("from_slice", |s, _, _| {
        Triangle::from_slice(s.basis(), &[]).is_err()
            && Triangle::from_slice(s.basis(), s.control_points()).is_ok()
    }),
    ("derivative", |s, a, b| {
        let _ = [0, 1, 3, 4, usize::MAX].map(|order| s.derivative([a, b, 0.5], [b, a, 1.0], order));
        true
    }),
    ("partial", |s, a, b| any(s, a, b)),
    ("partial_at", |s, a, b| {
        let _ = [[0, 0], [1, 2], [9, 0], [usize::MAX; 2]].map(|orders| s.partial_at([a, b, 0.5], orders));
        true
    }),
    ("eval_at", |s, a, _| !a.is_nan() || is_nan(s.eval_at([a; 3]))),
    ("basis", |s, _, _| s.basis().values([1.0, 0.0, 0.0])[9] == 1.0),
    ("control_points", |s, _, _| s.control_points().len() == 10),
    ("control_point", |s, _, _| {
        s.control_point(TriangleIndex::new([usize::MAX; 3])).is_none()
            && s.control_point(TetrahedronIndex::new([1, 1, 1, 0])).is_none()
    }),
    ("to_bernstein", |s, _, _| s.to_bernstein().len() == 10),
    ("eval", |s, a, b| !a.is_nan() || is_nan(s.eval(a, b))),
    ("eval_with_partials", |s, a, b| {
        let _ = (s.eval_with_partials::<0>(a, b), s.eval_with_partials::<6>(a, b));
        true
    }),
    ("normal", |s, a, b| s.normal(a, b).is_none_or(is_unit)),
    ("edge_curve", |s, a, _| {
        TriangleEdge::ALL.iter().all(|&edge| !a.is_nan() || is_nan(s.edge_curve(edge).eval(a)))
    }),
    ("edge", |s, _, _| s.edge_curve(TriangleEdge::V).basis().edge() == TriangleEdge::V),
    ("of", |_, _, _| TriangleEdge::ALL.iter().all(|&edge| TriangleEdge::of(Edge::from(edge)) == Some(edge))),
    ("point", |_, a, _| TriangleEdge::ALL.iter().all(|edge| edge.point(a).contains(&0.0))),
    ("index", |_, _, _| {
        TriangleEdge::U.index(3, usize::MAX).components() == [0, 3, 0]
            && TriangleEdge::W.index(usize::MAX, 1).order() == usize::MAX
    }),
    ("control_box", |s, _, _| is_box(s.control_box())),
    ("bounding_box", |s, a, b| a != 0.0 || b != 0.0 || is_box(s.bounding_box())),
    ("curvature", |s, a, b| s.curvature(a, b).is_none_or(|c| is_finite(c.normal))),
    ("part", |s, a, b| !a.is_nan() || is_nan(s.part([[a, b, 0.0]; 3]).eval_at([0.25, 0.25, 0.5]))),
    ("split_edge", |s, a, _| {
        TriangleEdge::ALL
            .iter()
            .all(|&edge| s.split_edge(edge, a).iter().all(|part| part.control_points().len() == 10))
    }),
    ("to_bezier", |s, _, _| s.to_bezier().control_points().len() == 10),
    ("elevate", |s, _, _| s.elevate::<8, 36>().control_points().len() == 36),
    ("nearest", |s, a, b| {
        let few = [0.375, 1e300, f64::NAN].into_iter().any(|x| x.to_bits() == a.to_bits());
        !few || s.nearest([a, 0.25, a], b).is_none_or(|found| {
            found.at.iter().all(|x| (0.0..=1.0).contains(x))
                && found.at_least <= found.distance
                && is_length(found.distance)
        })
    }),
    ("continued", |s, a, b| {
        [0, 1, 3, 4, usize::MAX].into_iter().all(|order| {
            Edge::ALL.into_iter().all(|edge| {
                let contact = TriangleContact::new(order, [0.5, a, b]);
                let next = s.continued(EdgePair::along(Edge::VStart, edge), contact, s);
                next.map_or(true, |next| next.control_points().iter().all(|&p| is_finite(p)))
            })
        })
    }),
    ("triangular", |s, a, _| {
        SurfacePiece::triangular(s.control_points()).is_ok_and(|piece| piece.degrees() == [3, 3])
            && SurfacePiece::triangular(&[a; 5]).is_err()
    }),
    ("to_tensor_surface", |s, a, b| {
        let tensor = s.to_tensor_surface();
        tensor.normal(a, b).is_none_or(is_unit) && (!a.is_nan() || is_nan(tensor.eval(a, b)))
    }),
    ("values", |s, a, _| {
        let bernstein = TriangularBernsteinBasis::<f64, 4, 10>::new();
        let _ = (bernstein.derivatives([a; 3], [1.0, -1.0, 0.0], usize::MAX), s.basis().values([a; 3]));
        bernstein.values([a; 3])[0].is_nan() == a.is_nan()
    }),
];

/// Called in the tests below.
const OTHERS: &[&str] = &[
    "at",
    "position",
    "order",
    "components",
    "count",
    "all",
    "box_sum",
    "raise_weights",
    "from_points",
    "partials",
    "domain",
];

/// The names that stand among those of splines.
pub(crate) fn of_splines() -> impl Iterator<Item = &'static str> {
    BOX.iter().map(|(name, _)| *name).filter(|name| name.contains(':'))
}

pub(crate) const NAMES: &[&str] = &{
    let mut names = [""; TRIANGLE.len() + OTHERS.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = if k < TRIANGLE.len() { TRIANGLE[k].0 } else { OTHERS[k - TRIANGLE.len()] };
        k += 1;
    }
    names
};

#[test]
fn triangles() {
    for shape in [[1.5, 1.0], [1e-300, 0.0]] {
        check(TRIANGLE, |net| {
            let basis = TriangularII::new(shape[0], shape[1]).unwrap();
            Some(TriangularPatch::new(basis, core::array::from_fn(net)))
        });
    }
    areas_and_edges(|net| {
        let basis = TriangularII::new(1.5, 1.0).unwrap();
        Some(TriangularPatch::new(basis, core::array::from_fn(net)))
    });
}

#[test]
fn triangles_of_degree_zero() {
    let point = TriangularBezier::<P, 1, 1>::from_points([[1.0, 2.0, 3.0]]);
    for a in NUMBERS {
        let _ = (point.eval(a, a), point.derivative([a; 3], [a; 3], 1), point.split_edge(TriangleEdge::U, a));
        assert_eq!(point.normal(a, a), None);
        assert_eq!(point.curvature(a, a).map(|c| c.normal), None);
        let found = point.nearest([1.0, 2.0, 5.0], a).unwrap();
        assert_eq!(found.distance, 2.0);
    }
    assert_eq!(point.bounding_box(), [[1.0, 2.0, 3.0]; 2]);
    assert_eq!(point.elevate::<3, 6>().control_points(), [[1.0, 2.0, 3.0]; 6]);
}

type Box2 = BoxPatch<Serendipity, P>;

const BOX: &[Case<Box2>] = &[
    ("from_slice", |s, _, _| Box2::from_slice(s.basis(), &[[0.0; 3]]).is_err()),
    ("eval_at", |s, a, _| !a.is_nan() || is_nan(s.eval_at([a; 2]))),
    ("eval", |s, a, b| any(s, a, b)),
    ("partial_at", |s, a, b| {
        let _ = [[0, 0], [1, 2], [9, 0], [usize::MAX; 2]].map(|orders| s.partial_at([a, b], orders));
        true
    }),
    ("corners", |s, _, _| s.corners() == [[-1.0; 2], [1.0; 2]]),
    ("basis", |s, _, _| s.basis() == Serendipity::new()),
    ("control_points", |s, _, _| s.control_points().len() == 8),
    ("to_bernstein", |s, _, _| s.to_bernstein().len() == 9),
    ("control_box", |s, _, _| is_box(s.control_box())),
    ("bounding_box", |s, a, b| a != 0.0 || b != 0.0 || is_box(s.bounding_box())),
    ("BoxPatch::split", |s, a, _| {
        [Direction::U, Direction::V].iter().all(|&d| s.split(d, a).is_ok() == (a > -1.0 && a < 1.0))
    }),
    ("BoxPatch::subpatch", |s, a, b| {
        let given = [a, b].iter().all(|x| (-1.0..=1.0).contains(x)) && a != b;
        s.subpatch(a..b, b..a).is_ok() == given
    }),
    ("BoxPatch::reversed", |s, a, _| {
        s.reversed(Direction::V).is_ok_and(|s| !a.is_nan() || is_nan(s.eval(a, a)))
    }),
];

#[test]
fn boxes() {
    check(BOX, |net| Some(BoxPatch::new(Serendipity::new(), core::array::from_fn(net))));
}

#[test]
fn tetrahedra() {
    let cases: &[Case<SimplexPatch<TetrahedralLagrange, P>>] = &[
        ("eval_at", |s, a, b| !a.is_nan() || is_nan(s.eval_at([a, b, a, b]))),
        ("partial", |s, a, b| {
            let _ = [[0; 3], [1, 1, 0], [usize::MAX; 3]].map(|orders| s.partial_at([a, b, a, b], orders));
            true
        }),
        ("derivative", |s, a, b| {
            let _ = [0, 2, 3, usize::MAX].map(|order| s.derivative([a, b, a, b], [b, a, b, a], order));
            true
        }),
        ("control_box", |s, _, _| is_box(s.control_box())),
    ];
    check(cases, |net| Some(SimplexPatch::new(TetrahedralLagrange::new(), core::array::from_fn(net))));
}

#[test]
fn indices() {
    let sizes = [0, 1, 2, 5, 1 << 20, 1 << 32, usize::MAX - 1, usize::MAX];
    for a in sizes {
        for b in sizes {
            for c in sizes {
                let index = TriangleIndex::new([a, b, c]);
                assert_eq!(index.components(), [a, b, c]);
                assert!(index.order() >= a.max(b).max(c));
                let solid = TetrahedronIndex::new([a, b, c, a]);
                let (there, position) = (index.position(), solid.position());
                if [b, c].iter().try_fold(a, |sum: usize, &part| sum.checked_add(part)).is_some()
                    && there < usize::MAX
                {
                    assert_eq!(TriangleIndex::at(index.order(), there), Some(index));
                }
                if [b, c, a].iter().try_fold(a, |sum: usize, &part| sum.checked_add(part)).is_some()
                    && position < usize::MAX
                {
                    assert_eq!(TetrahedronIndex::at(solid.order(), position), Some(solid));
                }
            }
            assert!(TriangleIndex::at(a, b).is_none_or(|index| index.position() == b));
            assert!(TetrahedronIndex::at(a, b).is_none_or(|index| index.position() == b));
        }
        assert_eq!(SimplexIndex::<1>::count(a), 1);
        assert!(TriangleIndex::all(a).nth(1).is_some() || a == 0);
        let _ = (TriangleIndex::count(a), TetrahedronIndex::count(a), SimplexIndex::<9>::count(a));
    }
}

/// Families on edges are families like others.
#[test]
fn edges() {
    use basis_runtime::Basis as _;
    for basis in [TriangularI::new(1.0, 2.0).unwrap(), TriangularI::new(1e-300, 0.0).unwrap()] {
        for edge in TriangleEdge::ALL {
            let edge = EdgeBasis::new(basis, edge);
            for a in NUMBERS {
                assert!(!a.is_nan() || edge.values(a).iter().all(|b| b.is_nan()));
                let _ = edge.derivatives(a, usize::MAX);
            }
        }
    }
}
