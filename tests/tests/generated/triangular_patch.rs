//! Triangular patches: points, derivatives, boundary curves, normals.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_runtime::{
    Array, Basis, BoxPatch, Curve, Scalar, SimplexBasis, SimplexPatch, TetrahedronIndex, TriangleEdge,
    TriangleIndex, TriangularBasis, TriangularPatch,
};
use basis_tests::exact::{epsilon, fraction};
use basis_tests::patches::{
    Bubble, P4, Quotients, Serendipity, ShippedPatch, Tetrahedral2, TriangularBernstein, TriangularI,
    TriangularI3, TriangularII, TriangularII5, exact,
};
use basis_tests::random::Random;

/// Points and partial derivatives are the exact sums over the control points.
fn sums<B: TriangularBasis<Scalar = S> + ShippedPatch<Scalar = S>, S: Scalar>() {
    let (reference, random) = (B::reference(), &mut Random::new(61));
    for shape in reference.shapes::<S>(4, random) {
        let basis = B::with(&shape).expect("inside the range");
        let points = B::Points::from_fn(|_| [random.between::<S>(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let patch = TriangularPatch::new(basis, points);
        let weights = basis.bernstein_weights();
        let size =
            weights.as_ref().iter().map(|row| row.as_ref().iter().map(|w| w.to_f64().abs()).sum::<f64>());
        let size = size.fold(1.0, f64::max);
        for _ in 0..6 {
            let at = <B as ShippedPatch>::point(&reference, random);
            let partials = patch.eval_with_partials::<3>(at[0], at[1]);
            for (i, j) in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (2, 2)] {
                let functions = exact(&reference, &shape, &at, &[i, j]);
                for k in 0..2 {
                    let terms = functions.iter().zip(points.as_ref()).map(|(b, p)| b * &fraction(p[k]));
                    let expected = terms.fold(Rational::ZERO, |sum, term| sum + term);
                    let error = (&fraction(partials[i][j][k]) - &expected).to_f64().abs();
                    let growth =
                        (0..i + j).map(|k| 2.0 * B::DEGREE.saturating_sub(k) as f64).product::<f64>();
                    let tolerance = 12.0 * epsilon::<S>() * size * growth.max(1.0);
                    assert!(error <= tolerance, "{} {shape:?} ∂({i},{j}) at {at:?}: off by {error}", B::NAME);
                }
            }
            assert_eq!(partials[0][0], patch.eval(at[0], at[1]));
            let [u, v] = [at[0], at[1]];
            assert_eq!(patch.eval(u, v), patch.eval_at([u, v, S::ONE - u - v]));
            let w = S::ONE - u - v;
            assert_eq!(patch.partial_at([u, v, w], [2, 1]), partials[2][1]);
            let along_edge = patch.derivative([u, v, w], [S::ONE, S::ZERO, -S::ONE], 2);
            assert_eq!(along_edge, partials[2][0]);
        }
    }
}

#[test]
fn points_and_derivatives_are_those_of_the_sum() {
    sums::<TriangularBernstein<f64>, _>();
    sums::<TriangularI<f64>, _>();
    sums::<TriangularI<f32>, _>();
    sums::<TriangularI3<f64>, _>();
    sums::<TriangularII<f32>, _>();
    sums::<TriangularII5<f64>, _>();
    sums::<P4<f64>, _>();
    sums::<Bubble<f64>, _>();
    sums::<Quotients<f32>, _>();
}

/// A boundary curve is the edge of the patch, and where the family allows it over the control points of the edge.
fn edges<B: TriangularBasis<Scalar = S> + ShippedPatch<Scalar = S>, S: Scalar>(own: bool) {
    assert_eq!(B::OWN_EDGES, own, "{}", B::NAME);
    let (reference, random) = (B::reference(), &mut Random::new(62));
    for shape in reference.shapes::<S>(4, random) {
        let basis = B::with(&shape).expect("inside the range");
        let points = B::Points::from_fn(|_| [random.between::<S>(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let patch = TriangularPatch::new(basis, points);
        for edge in TriangleEdge::ALL {
            let curve = patch.edge_curve(edge);
            for t in (0..=16).map(|k| S::of(f64::from(k) / 16.0)) {
                let [on_curve, tangent] = curve.eval_with_derivs(t);
                let on_patch = patch.eval_at(edge.point(t));
                let [from, to] = [edge.point(S::ZERO), edge.point(S::ONE)];
                let along = [0, 1, 2].map(|i| to[i] - from[i]);
                let slope = patch.derivative(edge.point(t), along, 1);
                for k in 0..2 {
                    let error = (on_curve[k] - on_patch[k]).to_f64().abs();
                    assert!(error <= 60.0 * epsilon::<S>(), "{} {edge:?} at {t}: off by {error}", B::NAME);
                    let error = (tangent[k] - slope[k]).to_f64().abs();
                    assert!(
                        error <= 600.0 * epsilon::<S>(),
                        "{} {edge:?} at {t}: slope off by {error}",
                        B::NAME
                    );
                }
            }
            if own {
                let order = B::ORDER.expect("a lattice");
                for (place, point) in curve.control_points().iter().enumerate() {
                    assert_eq!(patch.control_point(edge.index(order, place)), Some(*point));
                }
                let values = curve.basis().values(S::of(0.25));
                let sum = values.as_ref().iter().fold(0.0, |sum, b| sum + b.to_f64());
                assert!((sum - 1.0).abs() <= 8.0 * epsilon::<S>());
                let rest: f64 = basis_values(basis, edge.point(S::of(0.25))) - sum;
                assert!(rest.abs() <= 8.0 * epsilon::<S>(), "{}", B::NAME);
            }
        }
        // From the corner w = 1 to both others, and between these.
        let [u, v, w] = TriangleEdge::ALL.map(|edge| patch.edge_curve(edge));
        assert_eq!((u.start(), v.end(), w.start()), (v.start(), w.end(), u.end()));
    }
}

fn basis_values<B: TriangularBasis>(basis: B, at: [B::Scalar; 3]) -> f64 {
    SimplexBasis::values(&basis, at).as_ref().iter().map(|b| b.to_f64()).sum()
}

#[test]
fn boundary_curves_are_the_edges() {
    edges::<TriangularBernstein<f64>, _>(true);
    edges::<TriangularI<f64>, _>(true);
    edges::<TriangularI3<f32>, _>(true);
    edges::<TriangularII<f64>, _>(true);
    edges::<TriangularII5<f64>, _>(true);
    edges::<P4<f64>, _>(true);
    edges::<Bubble<f64>, _>(false);
    edges::<Quotients<f64>, _>(false);
}

/// The edge of a patch of type II does not know the second shape parameter, and is a curve of one family over four
/// points.
#[test]
fn an_edge_of_type_ii_is_a_curve_over_its_own_points() {
    let points: [[f64; 2]; 10] = core::array::from_fn(|i| [i as f64, (i * i % 7) as f64]);
    let patches = [0.0, 1.0, 2.0].map(|mu| TriangularPatch::new(TriangularII::new(1.5, mu).unwrap(), points));
    for edge in TriangleEdge::ALL {
        let curves = patches.map(|p| p.edge_curve(edge));
        for t in [0.0, 0.3, 0.9, 1.0] {
            assert_eq!(curves[0].eval(t), curves[1].eval(t));
            assert_eq!(curves[0].eval(t), curves[2].eval(t));
        }
        let weights = curves[0].basis().bernstein_weights();
        assert_eq!(
            weights,
            [[1.0, 0.0, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0], [0.0, 0.0, 0.5, 0.5], [0.0, 0.0, 0.0, 1.0]]
        );
        assert_eq!(curves[0].basis().values(0.25).map(|b| b * 128.0), [81.0, 27.0, 9.0, 11.0]);
    }
}

/// The corners are exact, also next to them the patch is where it should be.
#[test]
fn corners_are_interpolated_exactly() {
    let random = &mut Random::new(63);
    let points: [[f32; 3]; 45] = core::array::from_fn(|_| core::array::from_fn(|_| random.wild()));
    for (a, b) in [(0.3, 0.1), (4.0, 5.0), (2.0, 4.0)] {
        let patch = TriangularPatch::new(basis_tests::patches::TriangularI8::new(a, b).unwrap(), points);
        assert_eq!(patch.eval(1.0, 0.0), points[44]);
        assert_eq!(patch.eval(0.0, 1.0), points[8]);
        assert_eq!(patch.eval(0.0, 0.0), points[0]);
    }
}

fn near(a: Option<[f64; 3]>, b: [f64; 3]) {
    let a = a.expect("a normal");
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-6), "{a:?} for {b:?}");
}

type Quadratic<S = f64> = basis_tests::patches::TriangularI<S>;

/// Ten points in the order of their indices from a function of (i, j, k)/3.
fn cubic(f: impl Fn([f64; 3]) -> [f64; 3]) -> TriangularPatch<TriangularII, [f64; 3]> {
    let points: Vec<[f64; 3]> =
        TriangleIndex::all(3).map(|i| f(i.components().map(|c| c as f64 / 3.0))).collect();
    TriangularPatch::from_slice(TriangularII::new(3.0, 2.0).unwrap(), &points).unwrap()
}

#[test]
fn normals_where_the_patch_is_regular() {
    let plane = cubic(|[u, v, _]| [u, v, 2.0]);
    for (u, v) in [(0.2, 0.3), (0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5), (-0.5, 2.0)] {
        near(plane.normal(u, v), [0.0, 0.0, 1.0]);
    }
    let turned = cubic(|[u, v, _]| [v, u, 2.0]);
    near(turned.normal(0.25, 0.25), [0.0, 0.0, -1.0]);
    let shifted = cubic(|[u, v, _]| [1e9 + u, v, 2.0 + u]);
    near(shifted.normal(0.25, 0.25), [-0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()]);
}

/// An edge that has shrunk to a point: the derivative along it vanishes all along it.
#[test]
fn normals_at_a_pole() {
    // v and w end at the same point when u = 0.
    let fan = cubic(|[u, v, w]| if v + w < 0.9 || u > 0.05 { [u, u * (v - w), 0.0] } else { [0.0; 3] });
    let (a, b) = (fan.eval(0.0, 0.2), fan.eval(0.0, 0.8));
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-15));
    let inside = fan.normal(0.3, 0.3).expect("regular");
    for v in [0.0, 0.1, 0.5, 0.9, 1.0] {
        near(fan.normal(0.0, v), inside);
    }
    near(fan.normal(1e-15, 0.5), inside);
}

/// A corner at which two neighbours coincide with it: the first derivatives vanish there.
#[test]
fn normals_at_a_corner_without_tangents() {
    // In a plane the limit exists, …
    let height = |f: &dyn Fn([f64; 3]) -> f64| {
        cubic(|x| {
            let near_corner = x[0] > 0.6;
            if near_corner { [1.0, 0.0, 0.0] } else { [x[0], x[1], f(x)] }
        })
    };
    near(height(&|_| 0.0).normal(1.0, 0.0), [0.0, 0.0, 1.0]);
    // … at the apex of a cone it does not.
    assert_eq!(height(&|x| x[1] * x[2]).normal(1.0, 0.0), None);
    // The middle control point alone decides.
    assert!(height(&|x| x[1] * x[2]).normal(0.9, 0.05).is_some());
}

/// Two tangents in one direction: a cusp, whose tangent plane needs second derivatives.
#[test]
fn normals_at_a_corner_with_one_tangent() {
    let patch = cubic(|[u, v, w]| {
        let bend = if u > 0.5 { 0.0 } else { v - w };
        [v + w, bend, 0.0]
    });
    let (inside, limit) = (patch.normal(0.9, 0.06), patch.normal(1.0, 0.0));
    near(limit, inside.expect("regular"));
}

/// A quadratic patch from its polar form, a function of two points (u, v).
fn quadratic(polar: impl Fn([f64; 2], [f64; 2]) -> [f64; 3]) -> TriangularPatch<Quadratic, [f64; 3]> {
    let (w, v, u) = ([0.0, 0.0], [0.0, 1.0], [1.0, 0.0]);
    let points = [(w, w), (w, v), (v, v), (w, u), (v, u), (u, u)].map(|(a, b)| polar(a, b));
    TriangularPatch::new(Quadratic::new(2.0, 4.0).unwrap(), points)
}

/// With x and y from (1/4, 1/4).
#[test]
fn normals_at_zeros_inside() {
    let moved = |a: [f64; 2]| [a[0] - 0.25, a[1] - 0.25];
    // x² - y², 2xy: an isolated zero with a limit.
    let square = quadratic(|a, b| {
        let ([x, y], [p, q]) = (moved(a), moved(b));
        [x * p - y * q, x * q + y * p, 0.0]
    });
    near(square.normal(0.25, 0.25), [0.0, 0.0, 1.0]);
    // xy, x, y²: Whitney's umbrella, without one.
    let umbrella = quadratic(|a, b| {
        let ([x, y], [p, q]) = (moved(a), moved(b));
        [f64::midpoint(x * q, y * p), f64::midpoint(x, p), y * q]
    });
    assert_eq!(umbrella.normal(0.25, 0.25), None);
    // x³, y: a curve of zeros, with the same normal on both sides.
    let power = |base: f64, x: f64| base.powi((3.0 * x).round() as i32);
    let curve = cubic(|[u, v, w]| [power(0.75, u) * power(-0.25, v + w), v, 0.0]);
    near(curve.normal(0.24, 0.3), [0.0, 0.0, 1.0]);
    near(curve.normal(0.26, 0.3), [0.0, 0.0, 1.0]);
    assert_eq!(curve.normal(0.25, 0.3), None);
}

/// Points on a line, as far as numbers of their size can tell.
#[test]
fn no_normals_on_a_line_far_from_the_origin() {
    for line in [[1.0, 2.0, -1.0], [3.0, -1.0, 2.0], [1.0, 1.0, -3.0], [2.0, 3.0, 1.0]] {
        let points = cubic(|[u, v, w]| line.map(|x| 1e4 + (u * u + v - 2.0 * v * w) * x));
        for (u, v) in [(0.2, 0.3), (0.0, 0.4), (0.0, 0.0), (1.0, 0.0)] {
            assert_eq!(points.normal(u, v), None, "{line:?} at {u}, {v}");
        }
    }
}

#[test]
fn no_normals_without_a_surface() {
    assert_eq!(cubic(|_| [1.0, 2.0, 3.0]).normal(0.3, 0.3), None);
    assert_eq!(cubic(|[u, _, _]| [u, u * u, 3.0 * u]).normal(0.3, 0.3), None);
    assert_eq!(cubic(|[u, v, _]| [u, v, f64::NAN]).normal(0.3, 0.3), None);
    assert_eq!(cubic(|[u, v, _]| [u, v, f64::INFINITY]).normal(0.3, 0.3), None);
    assert_eq!(cubic(|[u, v, _]| [u, v, 0.0]).normal(f64::NAN, 0.3), None);
    // A fold across which the normal flips: x = (u - v)², y = u + v.
    let fold = TriangularPatch::new(
        Quadratic::new(2.0, 4.0).unwrap(),
        // The coefficients of (u - v)² in the quadratic Bernstein basis, and of u + v.
        [
            [0.0, 0.0, 0.0],
            [0.0, 0.5, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 0.5, 0.0],
            [-1.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
        ],
    );
    near(fold.normal(0.4, 0.2), fold.normal(0.5, 0.1).unwrap());
    let (one, other) = (fold.normal(0.4, 0.2).unwrap(), fold.normal(0.2, 0.4).unwrap());
    near(Some(one), other.map(|x| -x));
    assert_eq!(fold.normal(0.25, 0.25), None);
}

#[test]
fn points_of_every_type() {
    let flat: [[f32; 3]; 6] = core::array::from_fn(|i| [i as f32, (i * i) as f32, 1.0]);
    let basis = Quadratic::<f32>::new(1.0, 2.0).unwrap();
    let arrays = TriangularPatch::new(basis, flat);
    let vectors = TriangularPatch::new(basis, flat.map(glam::Vec3::from));
    let affine = TriangularPatch::new(basis, flat.map(nalgebra::Point3::from));
    let scalars = TriangularPatch::new(basis, flat.map(|p| p[1]));
    for (u, v) in [(0.0, 0.0), (0.25, 0.5), (0.3, 0.1)] {
        let expected = arrays.eval(u, v);
        assert_eq!(vectors.eval(u, v).to_array(), expected);
        assert_eq!(affine.eval(u, v), nalgebra::Point3::from(expected));
        assert_eq!(scalars.eval(u, v), expected[1]);
        assert_eq!(vectors.normal(u, v).map(|n| n.to_array()), arrays.normal(u, v));
    }
}

#[test]
fn a_wrong_number_of_points_is_an_error() {
    let error = TriangularPatch::from_slice(Quadratic::new(1.0, 2.0).unwrap(), &[[0.0; 3]; 5]).unwrap_err();
    assert_eq!(error.to_string(), "TriangularI(2) has 6 functions, so it needs 6 control points, not 5");
    let error = BoxPatch::from_slice(Serendipity::new(), &[0.0; 9]).unwrap_err();
    assert_eq!((error.family(), error.expected(), error.found()), ("Serendipity", 8, 9));
}

#[test]
fn elements_interpolate_at_their_nodes() {
    let values: [f64; 10] = core::array::from_fn(|i| (i * i) as f64 - 7.0);
    let solid = SimplexPatch::new(Tetrahedral2::new(), values);
    for (index, value) in TetrahedronIndex::all(2).zip(values) {
        assert_eq!(solid.eval_at(index.components().map(|c| c as f64 / 2.0)), value);
        assert_eq!(solid.control_point(index), Some(value));
    }
    assert_eq!(solid.control_point(TriangleIndex::new([1, 0, 1])), None);
    let element = BoxPatch::new(Serendipity::new(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    let nodes = [[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]];
    for (node, value) in nodes.iter().zip(1..) {
        assert_eq!(element.eval_at(node.map(f64::from)), f64::from(value));
    }
    // The element is quadratically complete: it reproduces its own coordinates.
    let coordinates = BoxPatch::new(Serendipity::new(), nodes.map(|n| n.map(f64::from)));
    assert_eq!(coordinates.eval_at([0.25, -0.5]), [0.25, -0.5]);
    assert_eq!(coordinates.partial_at([0.25, -0.5], [0, 1]), [0.0, 1.0]);
}

#[test]
fn positions_and_indices_are_inverse() {
    for order in 0..9 {
        for (position, index) in TriangleIndex::all(order).enumerate() {
            assert_eq!((index.position(), index.order()), (position, order));
            assert_eq!(TriangleIndex::at(order, position), Some(index));
        }
        for (position, index) in TetrahedronIndex::all(order).enumerate() {
            assert_eq!((index.position(), index.order()), (position, order));
            assert_eq!(TetrahedronIndex::at(order, position), Some(index));
        }
        assert_eq!(TriangleIndex::all(order).count(), TriangleIndex::count(order));
        assert_eq!(TetrahedronIndex::at(order, TetrahedronIndex::count(order)), None);
    }
}

#[test]
fn indices_of_any_size_are_answered() {
    let patch = cubic(|[u, v, w]| [u, v, w]);
    for components in [[usize::MAX, 1, 0], [usize::MAX; 3], [usize::MAX - 1, 1, 1], [0, usize::MAX, 4]] {
        let index = TriangleIndex::new(components);
        assert_eq!((index.order(), index.position()), (usize::MAX, usize::MAX));
        assert_eq!(patch.control_point(index), None);
    }
    assert_eq!(TriangleIndex::count(usize::MAX), usize::MAX);
    assert_eq!(TetrahedronIndex::count(1 << 22), (1 << 22 | 3) * ((1 << 21) + 1) / 3 * ((1 << 22) + 1));
    // The last positions of a large order.
    let order = 1 << 20;
    let last = TriangleIndex::count(order) - 1;
    assert_eq!(TriangleIndex::at(order, last), Some(TriangleIndex::new([order, 0, 0])));
    assert_eq!(TriangleIndex::at(order, last - 1), Some(TriangleIndex::new([order - 1, 1, 0])));
    assert_eq!(TriangleIndex::at(usize::MAX, 7), Some(TriangleIndex::new([0, 7, usize::MAX - 7])));
    for order in [1 << 31, (1 << 32) - 9] {
        let last = TriangleIndex::count(order) - 1;
        assert_eq!(TriangleIndex::at(order, last), Some(TriangleIndex::new([order, 0, 0])));
    }
    for position in [1 << 40, usize::MAX - 1] {
        for order in [1 << 40, usize::MAX] {
            assert_eq!(TriangleIndex::at(order, position).unwrap().position(), position);
            assert_eq!(TetrahedronIndex::at(order, position).unwrap().position(), position);
        }
    }
}

/// The curve of an edge is a curve like any other.
#[test]
fn boundary_curves_can_be_made_from_their_family() {
    let patch = cubic(|[u, v, w]| [u, v * w, w]);
    let edge = patch.edge_curve(TriangleEdge::V);
    let same = Curve::new(edge.basis(), <[[f64; 3]; 4]>::try_from(edge.control_points()).unwrap());
    assert_eq!(edge, same);
}
