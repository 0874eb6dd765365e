//! Families as finite elements.

use basis_runtime::{Array, Basis, BoxBasis, Point, Quadrature, Scalar, SimplexBasis, basis};

use crate::random::Random;

basis!(library "lagrange", Lagrange(5), TriangularLagrange(1) as P1, TriangularLagrange(3) as P3,
    TriangularLagrange(4) as P4,
    TetrahedralLagrange(2) as Solid, Serendipity);
basis!(library "elements", CrouzeixRaviart, HermiteTriangle);

basis! {
    /// Cubic Lagrange functions with nodes at Chebyshev's points, roughly: no lattice.
    family Uneven {
        domain -1 <= t <= 3;
        let y = [-1, -1/2, 2, 3];
        b[i] = product((t - y[j])/(y[i] - y[j]) for j in 0..=3 if j != i) for i in 0..=3;
    }
    /// A quadratic family on a box that belongs to no lattice of its degrees.
    family Mixed {
        domain 0 <= x <= 2, -1 <= y <= 1, 0 <= z <= 3;
        b[0] = (1 - x/2)*(1 - y)*(1 + z^2);
        b[1] = x^2*(1 + y)*z*(3 - z);
        b[2] = x*(2 - x)*(1 - y^2)*z*(3 - z);
        b[3] = 1;
    }
}

/// Numbers in `0..1`.
fn number(random: &mut Random) -> f64 {
    random.between(0.0, 1.0)
}

/// The derivatives of all functions at a point, straight from the trait, against the table.
fn near<S: Scalar>(found: &[S], expected: &[S], size: S, what: &str) {
    assert_eq!(found.len(), expected.len());
    for (f, e) in found.iter().zip(expected) {
        assert!((*f - *e).abs() <= S::of(64.0) * S::EPSILON * size, "{what}: {f} for {e}");
    }
}

#[test]
fn tables_on_triangles_have_what_partials_give() {
    fn all<B: SimplexBasis<Scalar = f64, Coordinates = [f64; 3], Orders = [usize; 2]>>(basis: B) {
        let mut random = Random::new(7);
        let at: Vec<[f64; 3]> = (0..20)
            .map(|_| {
                let [u, v] = [number(&mut random), number(&mut random)];
                [u, v, 1.0 - u - v] // outside of the triangle too
            })
            .collect();
        let table = basis.tabulate(&at, 5);
        assert_eq!((table.points(), table.functions(), table.order()), (20, B::LEN, 5));
        for (q, &at) in at.iter().enumerate() {
            assert_eq!(table.values(q), basis.values(at).as_ref());
            for a in 0..=5 {
                for b in 0..=5 - a {
                    let found = table.derivatives(q, [a, b]).unwrap();
                    near(found, basis.partials(at, [a, b]).as_ref(), 1e4, B::NAME);
                }
            }
            assert_eq!(table.derivatives(q, [3, 3]), None);
            for i in 0..B::LEN {
                let of = |orders| table.derivatives(q, orders).unwrap()[i];
                assert_eq!(table.gradient(q, i), [of([1, 0]), of([0, 1])]);
                assert_eq!(table.hessian(q, i), [[of([2, 0]), of([1, 1])], [of([1, 1]), of([0, 2])]]);
            }
        }
    }
    all(P1::new());
    all(P4::new());
    all(HermiteTriangle::new());
}

#[test]
fn tables_on_tetrahedra_and_boxes() {
    let mut random = Random::new(11);
    let solid = Solid::new();
    for _ in 0..20 {
        let [u, v, w] = [0; 3].map(|_| number(&mut random));
        let at = [u, v, w, 1.0 - u - v - w];
        let table = solid.tabulate(&[at], 2);
        let of = |orders| solid.partials(at, orders);
        for i in 0..10 {
            near(
                &table.gradient(0, i),
                &[of([1, 0, 0])[i], of([0, 1, 0])[i], of([0, 0, 1])[i]],
                32.0,
                "solid",
            );
            let hessian = table.hessian(0, i);
            near(&hessian[0], &[of([2, 0, 0])[i], of([1, 1, 0])[i], of([1, 0, 1])[i]], 32.0, "solid");
            near(&hessian[1], &[of([1, 1, 0])[i], of([0, 2, 0])[i], of([0, 1, 1])[i]], 32.0, "solid");
            near(&hessian[2], &[of([1, 0, 1])[i], of([0, 1, 1])[i], of([0, 0, 2])[i]], 32.0, "solid");
        }
        let at = [2.0 * u, 2.0 * v - 1.0, 3.0 * w];
        let table = Mixed::new().tabulate(&[at], 4);
        for orders in [[0, 0, 0], [1, 0, 0], [0, 1, 2], [2, 1, 1], [1, 1, 1], [0, 0, 2], [3, 0, 0], [2, 2, 0]]
        {
            let expected = Mixed::new().partials(at, orders);
            near(table.derivatives(0, orders).unwrap(), &expected, 128.0, "box");
        }
    }
}

#[test]
fn tables_on_intervals_in_single_precision() {
    let basis = Lagrange::<f32>::new();
    let at = [0.0, 0.1, 0.7, 1.0];
    let table = basis.tabulate(&at, 3);
    for (q, &t) in at.iter().enumerate() {
        for order in 0..=3 {
            near(table.derivatives(q, [order]).unwrap(), &basis.derivatives(t, order), 3e4, "interval");
        }
        assert_eq!(table.gradient(q, 2), [table.derivatives(q, [1]).unwrap()[2]]);
        assert_eq!(table.hessian(q, 2), [[table.derivatives(q, [2]).unwrap()[2]]]);
    }
}

#[test]
fn orders_above_the_degree_are_zero_and_cost_nothing() {
    let table = P1::<f64>::new().tabulate(&[[0.2, 0.3, 0.5]], 1_000_000);
    assert_eq!(table.derivatives(0, [999_999, 0]), Some(&[0.0; 3][..]));
    assert_eq!(table.hessian(0, 1), [[0.0; 2]; 2]);
    assert_eq!(table.derivatives(0, [usize::MAX, 1]), None);
    assert_eq!(P1::<f64>::new().tabulate(&[], 1).points(), 0);
}

#[test]
fn stiffness_of_the_reference_triangle_is_exact() {
    // Row sums vanish, because the functions sum to 1, and the matrix is that of the textbooks for P1.
    let rule = Quadrature::<[f64; 3]>::on_simplex(0).unwrap();
    let table = P1::<f64>::new().tabulate(rule.points(), 1);
    let entry = |i, j| {
        rule.weights().iter().enumerate().fold(0.0, |sum, (q, w)| {
            let [a, b]: [[f64; 2]; 2] = [table.gradient(q, i), table.gradient(q, j)];
            sum + w * (a[0] * b[0] + a[1] * b[1])
        })
    };
    // In the order w, v, u of the corners (0,0), (0,1), (1,0).
    let expected = [[1.0, -0.5, -0.5], [-0.5, 0.5, 0.0], [-0.5, 0.0, 0.5]];
    for (i, row) in expected.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            assert_eq!(entry(i, j), *value);
        }
    }
}

/// How far a list of points is from the expected one.
fn apart<X: AsRef<[f64]>, Y: AsRef<[f64]>>(found: &[X], expected: &[Y]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let pairs = found.iter().zip(expected).flat_map(|(f, e)| f.as_ref().iter().zip(e.as_ref()));
    pairs.map(|(f, e)| (f - e).abs()).fold(0.0, f64::max)
}

#[test]
fn nodes() {
    let lattice: Vec<[f64; 3]> = (0..15)
        .map(|p| basis_runtime::TriangleIndex::at(4, p).unwrap().components().map(|k| k as f64 / 4.0))
        .collect();
    assert!(apart(&P4::<f64>::new().nodes().unwrap(), &lattice) < 1e-15);
    let halves = CrouzeixRaviart::<f64>::new().nodes().unwrap();
    assert!(apart(&halves, &[[0.0, 0.5, 0.5], [0.5, 0.0, 0.5], [0.5, 0.5, 0.0]]) < 1e-15);
    let uneven = Uneven::<f64>::new().nodes().unwrap().map(|t| [t]);
    assert!(apart(&uneven, &[[-1.0], [-0.5], [2.0], [3.0]]) < 1e-14);
    let equal = Lagrange::<f64>::new().nodes().unwrap().map(|t| [t]);
    let fifths: Vec<[f64; 1]> = (0..=5).map(|i| [f64::from(i) / 5.0]).collect();
    assert!(apart(&equal, &fifths) < 1e-14);
    // Fewer functions than Bernstein coefficients.
    let around = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [0.0, -1.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
    ];
    assert!(apart(&Serendipity::<f64>::new().nodes().unwrap(), &around) < 1e-14);
    assert_eq!(Solid::<f64>::new().nodes().unwrap().len(), 10);
    assert!(P4::<f32>::new().nodes().is_some());
    // Derivatives at the corners are no values; some functions do not span the coordinates, others no basis at all.
    assert_eq!(HermiteTriangle::<f64>::new().nodes(), None);
    assert_eq!(Mixed::<f64>::new().nodes(), None);
    assert_eq!(basis_runtime::BernsteinBasis::<f64, 4>::default().nodes(), None);
}

/// Barycentric coordinates near 0 and 1 are these numbers, and the sum of all is 1.
fn on_the_cell<B: SimplexBasis>(basis: B) {
    let near = |c: B::Scalar, end: f64| (c.to_f64() - end).abs() < 1e-3;
    for node in basis.nodes().unwrap().as_ref() {
        let coordinates = node.as_ref();
        for &c in coordinates {
            assert!(!near(c, 0.0) || c == B::Scalar::ZERO, "{}: {c}", B::NAME);
            assert!(!near(c, 1.0) || c == B::Scalar::ONE, "{}: {c}", B::NAME);
        }
        let sum = coordinates.iter().fold(B::Scalar::ZERO, |sum, &c| sum + c);
        assert!((sum - B::Scalar::ONE).abs() <= B::Scalar::EPSILON, "{}: {sum}", B::NAME);
    }
}

#[test]
fn nodes_on_the_boundary_lie_on_it() {
    on_the_cell(P1::<f64>::new());
    on_the_cell(P3::<f64>::new());
    on_the_cell(P4::<f64>::new());
    on_the_cell(Solid::<f64>::new());
    on_the_cell(CrouzeixRaviart::<f64>::new());
    on_the_cell(P3::<f32>::new());
    on_the_cell(P4::<f32>::new());
    for node in Serendipity::<f64>::new().nodes().unwrap() {
        assert!(node.iter().any(|c| c.abs() == 1.0) && node.iter().all(|c| c.abs() <= 1.0), "{node:?}");
    }
    let uneven = Uneven::<f64>::new().nodes().unwrap();
    assert_eq!((uneven[0], uneven[3]), (-1.0, 3.0));
    let equal = Lagrange::<f64>::new().nodes().unwrap();
    assert_eq!((equal[0], equal[5]), (0.0, 1.0));
}

/// Whether a function vanishes on a side is asked of its values there, and compared with what it belongs to.
fn by_values<B: SimplexBasis<Scalar = f64>>(basis: B) {
    let corners = <B::Coordinates as Array<f64>>::LEN;
    let entities = basis.entities();
    let mut random = Random::new(3);
    let mut zero = vec![vec![true; corners]; B::LEN];
    for side in 0..corners {
        for _ in 0..30 {
            let weights: Vec<f64> =
                (0..corners).map(|j| if j == side { 0.0 } else { number(&mut random) + 0.01 }).collect();
            let sum: f64 = weights.iter().sum();
            let values = basis.values(B::Coordinates::from_fn(|j| weights[j] / sum));
            for (i, zero) in zero.iter_mut().enumerate() {
                zero[side] &= values.component(i).abs() < 1e-12;
            }
        }
    }
    for (i, zero) in zero.iter().enumerate() {
        let expected: Vec<usize> = (0..corners).filter(|&j| zero[j]).collect();
        let found = entities.entity(i).map_or(&[][..], |entity| entity.corners());
        assert_eq!(found, expected, "{} {i}", B::NAME);
        assert!(expected.is_empty() || entities.entity(i).unwrap().dimension() + 1 == expected.len());
    }
}

#[test]
fn functions_belong_to_where_they_do_not_vanish() {
    by_values(P1::new());
    by_values(P4::new());
    by_values(Solid::new());
    by_values(CrouzeixRaviart::new());
    by_values(HermiteTriangle::new());

    let p4 = P4::<f64>::new().entities();
    assert!(p4.is_complete());
    assert_eq!(p4.of_dimension(0), [0, 4, 14]);
    assert_eq!(p4.functions(&[2, 0]).len(), 3);
    assert_eq!(p4.closure(&[0, 2]).len(), 5);
    assert_eq!(p4.functions(&[0, 1, 2]).len(), 3);
    assert_eq!(p4.functions(&[7]), [0; 0]);
    let nonconforming = CrouzeixRaviart::<f64>::new().entities();
    assert!(!nonconforming.is_complete());
    assert_eq!(nonconforming.entity(0), None);
}

#[test]
fn functions_of_corners_and_edges_of_boxes() {
    let eight = Serendipity::<f64>::new().entities();
    // Corners (−1, −1), (−1, 1), (1, −1), (1, 1).
    assert_eq!([0, 1, 2, 3].map(|c| eight.functions(&[c])), [[0], [3], [1], [2]]);
    assert_eq!(eight.functions(&[0, 2]), [4]); // the edge η = −1
    assert_eq!(eight.closure(&[0, 2]), [0, 1, 4]);
    assert_eq!(eight.functions(&[0, 1, 2, 3]), [0; 0]);

    let mixed = Mixed::<f64>::new().entities();
    let corners = |i: usize| mixed.entity(i).map(|entity| (entity.dimension(), entity.corners().to_vec()));
    assert_eq!(corners(0), None); // not zero at z = 0 and z = 3
    assert_eq!(corners(1), Some((1, vec![6, 7]))); // x and y at their upper ends
    assert_eq!(corners(2), Some((3, (0..8).collect())));
    assert_eq!(corners(3), None);

    let interval = Lagrange::<f64>::new().entities();
    assert_eq!((interval.functions(&[0]), interval.functions(&[1])), (vec![0], vec![5]));
    assert_eq!(interval.functions(&[0, 1]), [1, 2, 3, 4]);
}
