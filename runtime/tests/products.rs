//! Families on products of simplices and intervals: values, derivatives, patches and matrices beside formulas.

#![cfg(feature = "macros")]

use basis_runtime::{DomainFactor, ProductBasis, ProductPatch, basis};

basis!(library "triangles/prisms", LinearWedge, QuadraticWedge, TriquadraticWedge, BernsteinPrism(3, 2) as Prism);

basis! {
    /// A shape parameter, the interval first, a simplex with four corners.
    family Solid {
        domain -1 <= z <= 2, tetrahedron (p, q, r, s), 0 <= x <= 1;
        shape 0 <= λ <= 2;
        b[0] = λ*z*p^2*s + x*q;
        b[1] = (2 - z)*(p + r)*x^2;
        b[2] = 1 - b[0] - b[1];
    }
    family Corners {
        domain 0 <= z <= 1, tetrahedron (p, q, r, s), 0 <= x <= 1;
        b[k,i,j,l,m,n] = (1 - k + (2*k - 1)*z) * p^i*q^j*r^l*s^m * (1 - n + (2*n - 1)*x)
            for k in 0..=1, i, j, l, m in simplex(1), n in 0..=1;
    }
    family Pair {
        domain triangle (u, v, w), triangle (r, s, t);
        b[0] = u*(v + t)*(w + r*s);
        b[1] = 1 - u*w*t^2;
    }
}

/// The point (u, v, w, z) of a grid on a prism.
fn prism() -> impl Iterator<Item = [f64; 4]> {
    (0..=4).flat_map(|i| {
        (0..=4 - i).flat_map(move |j| {
            (0..=4).map(move |k| {
                let [u, v] = [f64::from(i), f64::from(j)].map(|x| x / 4.0);
                [u, v, 1.0 - u - v, f64::from(k) / 2.0 - 1.0]
            })
        })
    })
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{a} instead of {b}");
}

#[test]
fn factors_and_ranges_are_those_of_the_spec() {
    let degree = 2;
    assert_eq!(
        QuadraticWedge::<f64>::FACTORS,
        [DomainFactor::Triangle { degree }, DomainFactor::Interval { degree }]
    );
    assert_eq!(QuadraticWedge::<f64>::domain(), [[0.0, 0.0, 0.0, -1.0], [1.0, 1.0, 1.0, 1.0]]);
    assert_eq!(
        Solid::<f64>::FACTORS,
        [
            DomainFactor::Interval { degree: 1 },
            DomainFactor::Tetrahedron { degree: 3 },
            DomainFactor::Interval { degree: 2 }
        ]
    );
    assert_eq!(Solid::<f64>::domain(), [[-1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [2.0, 1.0, 1.0, 1.0, 1.0, 1.0]]);
}

#[test]
fn nodal_values_are_exact() {
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let wedge = QuadraticWedge::new();
    for (i, [u, v, w]) in corners.into_iter().enumerate() {
        for (first, z) in [(0, -1.0), (3, 1.0), (12, 0.0)] {
            let values = wedge.values([u, v, w, z]);
            let unit: [f64; 15] = core::array::from_fn(|k| if k == first + i { 1.0 } else { 0.0 });
            assert_eq!(values, unit);
        }
    }
}

#[test]
fn values_and_derivatives_of_wedges() {
    for [u, v, w, z] in prism() {
        let at = [u, v, w, z];
        let values = QuadraticWedge::new().values(at);
        near(values[1], v * (2.0 * v - 1.0) * (1.0 - z) / 2.0 - v * (1.0 - z * z) / 2.0);
        near(values[9], 2.0 * v * w * (1.0 + z));
        near(values[12], u * (1.0 - z * z));
        near(values.iter().sum(), 1.0);
        // Along the edge from w = 1 to u = 1, and along the axis.
        let [du, dz, mixed] =
            [[1, 0, 0], [0, 0, 1], [1, 0, 1]].map(|orders| QuadraticWedge::new().partials(at, orders));
        near(du[9], -2.0 * v * (1.0 + z));
        near(dz[12], -2.0 * u * z);
        near(mixed[9], -2.0 * v);
        near(du.iter().sum(), 0.0);
        let [second, none, far] =
            [[0, 0, 2], [0, 0, 3], [2, 2, 0]].map(|orders| QuadraticWedge::new().partials(at, orders));
        near(second[13], -2.0 * v);
        assert_eq!((none, far), ([0.0; 15], [0.0; 15]));
        // b[2,1,0,1], of the degree 3 in the triangle and 2 along the axis 0 <= z <= 1: ten triples, three numbers each.
        let (z, place) = (f64::midpoint(1.0, z), 8 * 3 + 1);
        let at = [u, v, w, z];
        near(Prism::new().values(at)[place], 6.0 * u * u * v * z * (1.0 - z));
        near(Prism::new().partials(at, [1, 1, 1])[place], 12.0 * u * (1.0 - 2.0 * z));
    }
}

#[test]
fn factors_in_any_order() {
    let solid = Solid::new(1.5).unwrap();
    for [p, q, rest, z] in prism() {
        let (r, s, x) = (rest / 4.0, rest * 0.75, f64::midpoint(z, 1.0));
        let at = [z, p, q, r, s, x];
        let [b0, b1, b2] = solid.values(at);
        near(b0, 1.5 * z * p * p * s + x * q);
        near(b1, (2.0 - z) * (p + r) * x * x);
        near(b2, 1.0 - b0 - b1);
        // z, p, q, r, x; s falls as p, q or r grow.
        near(solid.partials(at, [1, 0, 0, 0, 0])[0], 1.5 * p * p * s);
        near(solid.partials(at, [1, 1, 0, 0, 0])[0], 1.5 * (2.0 * p * s - p * p));
        near(solid.partials(at, [0, 0, 0, 1, 0])[0], -1.5 * z * p * p);
        near(solid.partials(at, [0, 0, 1, 0, 1])[0], 1.0);
        near(solid.partials(at, [1, 1, 0, 0, 2])[1], -2.0);
        let patch = ProductPatch::new(solid, [[1.0, 4.0], [2.0, 0.0], [-3.0, 1.0]]);
        let [a, b] = patch.eval_at(at);
        near(a, b0 + 2.0 * b1 - 3.0 * b2);
        near(b, 4.0 * b0 + b2);
    }
    for [u, v, w, _] in prism() {
        let at = [u, v, w, v, w, u];
        let [r, s, t] = [v, w, u];
        let [b0, b1] = Pair::new().values(at);
        near(b0, u * (v + t) * (w + r * s));
        near(b1, 1.0 - u * w * t * t);
        near(Pair::new().partials(at, [0, 1, 1, 0])[1], -2.0 * u * t);
    }
}

#[test]
fn a_patch_is_the_sum_of_its_points() {
    let wedge = TriquadraticWedge::new();
    let points: [[f64; 3]; 18] = core::array::from_fn(|k| {
        let k = k as f64;
        [k.sin(), (2.0 * k).cos(), k * k / 50.0]
    });
    let patch = ProductPatch::new(wedge, points);
    assert_eq!(ProductPatch::from_slice(wedge, &points), Ok(patch));
    assert!(ProductPatch::from_slice(wedge, &points[1..]).is_err());
    let [low, high] = patch.control_box();
    for at in prism() {
        for orders in [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [0, 2, 2]] {
            let functions = wedge.partials(at, orders);
            let point = patch.partial_at(at, orders);
            for c in 0..3 {
                near(point[c], functions.iter().zip(&points).map(|(b, p)| b * p[c]).sum());
                if orders == [0; 3] {
                    assert!(low[c] - 1e-14 <= point[c] && point[c] <= high[c] + 1e-14);
                }
            }
        }
    }
    let moved = patch.map(|[x, y, z]| [y, x + 1.0, 2.0 * z]);
    let [[x, y, z], [a, b, c]] = [patch.eval_at([0.2, 0.3, 0.5, 0.1]), moved.eval_at([0.2, 0.3, 0.5, 0.1])];
    for (a, b) in [(a, y), (b, x + 1.0), (c, 2.0 * z)] {
        near(a, b);
    }
}

/// The exact numbers of the linear wedge, as `basis explain` prints them.
#[test]
fn matrices_are_the_exact_ones() {
    let wedge = LinearWedge::new();
    let [mass, stiffness]: [[[f64; 6]; 6]; 2] = [wedge.mass_matrix(), wedge.stiffness_matrix()];
    for (j, expected) in [4.0, 2.0, 2.0, 1.0, 2.0, 1.0].into_iter().enumerate() {
        near(mass[0][j], expected / 72.0);
    }
    for (j, expected) in [34.0, 14.0, -15.0, -9.0, -15.0, -9.0].into_iter().enumerate() {
        near(stiffness[0][j], expected / 48.0);
    }
    near(stiffness[2][4], 1.0 / 48.0);
    // The volume of the domain, 3·1/6·1, and no slope of a constant.
    let solid = Solid::new(1.0).unwrap();
    near(solid.mass_matrix().iter().flatten().sum(), 0.5);
    for row in solid.stiffness_matrix() {
        near(row.iter().sum(), 0.0);
    }
    near(Pair::new().mass_matrix()[1][1], {
        // ∫ (1 - u w t²)² = 1/4 - 2·1/24·2/24 + 2·2/720·24/720
        0.25 - 2.0 / 24.0 * (2.0 / 24.0) + 4.0 / 720.0 * (24.0 / 720.0)
    });
}

#[test]
fn single_precision() {
    let wedge: TriquadraticWedge<f32> = TriquadraticWedge::new();
    let patch = ProductPatch::new(wedge, [1.0_f32; 18]);
    assert!((patch.eval_at([0.25, 0.25, 0.5, 0.5]) - 1.0).abs() < 1e-6);
}

#[cfg(feature = "elements")]
mod elements {
    use super::*;

    #[test]
    fn wedges_have_nodes_and_entities() {
        let wedge = TriquadraticWedge::<f64>::new();
        let nodes = wedge.nodes().expect("a nodal family");
        for (i, &node) in nodes.iter().enumerate() {
            let values = wedge.values(node);
            for (j, &value) in values.iter().enumerate() {
                near(value, if i == j { 1.0 } else { 0.0 });
            }
        }
        // Six corners, three edges across and six around, three faces with a node; nothing inside.
        let entities = wedge.entities();
        assert!(entities.is_complete());
        let count = |dimension| entities.of_dimension(dimension).len();
        assert_eq!([count(0), count(1), count(2), count(3)], [6, 9, 3, 0]);
        // The corner u = 1 at z = 1 is corner 1, v = 1 at z = -1 is corner 2.
        let is_near = |a: &[f64; 4], b: &[f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        let at = |point: [f64; 4]| nodes.iter().position(|node| is_near(node, &point)).expect("a node");
        assert_eq!(entities.functions(&[1]), [at([1.0, 0.0, 0.0, 1.0])]);
        assert_eq!(entities.functions(&[2]), [at([0.0, 1.0, 0.0, -1.0])]);
        assert_eq!(entities.functions(&[1, 3]), [at([0.5, 0.5, 0.0, 1.0])]);
        assert_eq!(entities.functions(&[2, 3]), [at([0.0, 1.0, 0.0, 0.0])]);
        // The face w = 0 has the nine nodes of a biquadratic square.
        let mut face: Vec<usize> = (0..nodes.len()).filter(|&i| nodes[i][2].abs() < 1e-12).collect();
        face.sort_unstable();
        assert_eq!(entities.closure(&[0, 1, 2, 3]), face);
        let serendipity = QuadraticWedge::<f64>::new().entities();
        assert_eq!([0, 1, 2].map(|dimension| serendipity.of_dimension(dimension).len()), [6, 9, 0]);
        assert_eq!(LinearWedge::<f64>::new().entities().of_dimension(0).len(), 6);
        // The interval first: 2 · 4 · 2 corners, of which the coordinates z, s and x choose one.
        let corners = Corners::<f64>::new();
        let entities = corners.entities();
        assert_eq!(entities.of_dimension(0).len(), 16);
        for (i, node) in corners.nodes().expect("a nodal family").into_iter().enumerate() {
            let [z, p, q, r, s, x] = node.map(|c| c.round() as usize);
            let vertex = [p, q, r, s].iter().position(|c| *c == 1).expect("a corner");
            assert_eq!(entities.functions(&[(4 * z + vertex) * 2 + x]), [i]);
        }
        // Functions that are no products.
        assert_eq!(Pair::<f64>::new().nodes(), None);
    }

    #[test]
    fn rules_integrate_products_of_functions() {
        fn check<B: ProductBasis<Scalar = f64, Coordinates = [f64; K]>, const K: usize>(
            basis: B,
            degree: usize,
        ) {
            let rule = B::quadrature(degree).expect("a rule");
            assert!(rule.weights().iter().all(|w| *w > 0.0) && rule.degree() >= degree);
            let table = basis.tabulate(rule.points(), 0);
            let mass = basis.mass_matrix();
            for i in 0..B::LEN {
                for j in 0..B::LEN {
                    let entry = |q: usize, w: &f64| w * table.values(q)[i] * table.values(q)[j];
                    let sum = rule.weights().iter().enumerate().map(|(q, w)| entry(q, w)).sum();
                    near(mass.as_ref()[i].as_ref()[j], sum);
                }
            }
        }
        check(QuadraticWedge::<f64>::new(), 4);
        check(TriquadraticWedge::<f64>::new(), 6);
        check(Solid::new(1.5).expect("in its range"), 8);
        check(Pair::<f64>::new(), 10);
        let error = QuadraticWedge::<f64>::quadrature(2000).expect_err("too many points");
        assert!(error.to_string().contains("2000"), "{error}");
    }

    #[test]
    fn tables_hold_values_and_derivatives() {
        let solid = Solid::new(0.75).expect("in its range");
        let at = [[0.5, 0.25, 0.25, 0.25, 0.25, 0.125], [-1.0, 0.5, 0.0, 0.25, 0.25, 1.0]];
        let table = solid.tabulate(&at, 3);
        for (q, &at) in at.iter().enumerate() {
            for orders in
                [[0; 5], [1, 0, 0, 0, 0], [0, 1, 0, 0, 1], [0, 0, 1, 1, 0], [0, 2, 0, 0, 1], [0, 0, 0, 3, 0]]
            {
                let found = table.derivatives(q, orders).expect("of order 3 at most");
                for (a, b) in found.iter().zip(solid.partials(at, orders)) {
                    near(*a, b);
                }
            }
            assert_eq!(table.derivatives(q, [2, 2, 0, 0, 0]), None);
            let gradient = table.gradient(q, 0);
            near(gradient[4], solid.partials(at, [0, 0, 0, 0, 1])[0]);
            near(table.hessian(q, 1)[1][4], solid.partials(at, [0, 1, 0, 0, 1])[1]);
        }
    }
}
