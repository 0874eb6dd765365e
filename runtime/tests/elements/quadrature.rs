//! Rules of quadrature: moments in closed form.

use basis_runtime::{Point, Quadrature, QuadratureError, Scalar};

fn factorial(n: usize) -> f64 {
    (1..=n).map(|k| k as f64).product()
}

/// All exponents with `K` components and a sum up to `most`.
fn exponents(components: usize, most: usize) -> Vec<Vec<i32>> {
    if components == 0 {
        return vec![Vec::new()];
    }
    let firsts = 0..=most;
    firsts
        .flat_map(|first| {
            exponents(components - 1, most - first).into_iter().map(move |mut rest| {
                rest.insert(0, first as i32);
                rest
            })
        })
        .collect()
}

/// All moments up to the degree of the rule, of which the lowest that is wrong by more than rounding errors is told.
fn moments_on_simplex<const K: usize>(asked: usize) {
    let rule = Quadrature::<[f64; K]>::on_simplex(asked).unwrap();
    assert!(rule.degree() >= asked);
    assert!(rule.weights().iter().all(|&w| w > 0.0), "{asked}");
    for at in rule.points() {
        assert!(at.iter().all(|&x| x > 0.0) && (at.iter().sum::<f64>() - 1.0).abs() < 4e-16, "{at:?}");
    }
    for powers in exponents(K, rule.degree()) {
        // ∫ u^i v^j … = i! j! … / (i + j + … + K - 1)!
        let sum = powers.iter().sum::<i32>() as usize;
        let exact = powers.iter().map(|&p| factorial(p as usize)).product::<f64>() / factorial(sum + K - 1);
        let found = rule.integrate(|at| at.iter().zip(&powers).map(|(x, &p)| x.powi(p)).product::<f64>());
        assert!(
            (found / exact - 1.0).abs() < 2e-13,
            "{K} corners, degree {asked}, {powers:?}: {found}, {exact}"
        );
    }
}

#[test]
fn all_moments_on_triangles() {
    (0..=24).for_each(moments_on_simplex::<3>);
}

#[test]
fn all_moments_on_tetrahedra() {
    (0..=12).for_each(moments_on_simplex::<4>);
}

#[test]
fn all_moments_on_other_simplices() {
    (0..=15).for_each(moments_on_simplex::<2>);
    (0..=5).for_each(moments_on_simplex::<5>);
    let point = Quadrature::<[f64; 1]>::on_simplex(3).unwrap();
    assert_eq!((point.points(), point.weights()), (&[[1.0]][..], &[1.0][..]));
}

#[test]
fn rules_are_exact_no_further_than_they_say() {
    // The claim `degree` would be of no use if it were too low: one degree more is wrong for some moment.
    for asked in 0..=12 {
        let rule = Quadrature::<[f64; 3]>::on_simplex(asked).unwrap();
        let next = rule.degree() + 1;
        let wrong = exponents(3, next).iter().any(|powers| {
            let sum = powers.iter().sum::<i32>() as usize;
            let exact = powers.iter().map(|&p| factorial(p as usize)).product::<f64>() / factorial(sum + 2);
            let found = rule.integrate(|at| at.iter().zip(powers).map(|(x, &p)| x.powi(p)).product::<f64>());
            (found / exact - 1.0).abs() > 1e-10
        });
        assert!(wrong, "the rule for {asked} says {} and is exact beyond", rule.degree());
    }
}

#[test]
fn symmetric_rules_do_not_change_when_corners_are_exchanged() {
    for degree in 1..=10 {
        let rule = Quadrature::<[f64; 3]>::on_simplex(degree).unwrap();
        let mut sorted: Vec<_> = rule.iter().map(|([u, v, w], weight)| [u, v, w, weight]).collect();
        let mut turned: Vec<_> = rule.iter().map(|([u, v, w], weight)| [w, u, v, weight]).collect();
        for list in [&mut sorted, &mut turned] {
            list.sort_by(|a, b| a.partial_cmp(b).unwrap());
        }
        assert_eq!(sorted, turned);
    }
}

#[test]
fn intervals() {
    for degree in 0..=60 {
        let rule = Quadrature::on_interval([-1.0, 3.0], degree).unwrap();
        assert_eq!(rule.len(), degree / 2 + 1);
        assert!(rule.points().windows(2).all(|pair| pair[0] < pair[1]));
        for k in 0..=rule.degree() {
            // (x/3)^k, so that nothing is large.
            let n = (k + 1) as i32;
            let exact = 3.0 / f64::from(n) * (1.0 - (-1.0_f64 / 3.0).powi(n));
            let found = rule.integrate(|x: f64| (x / 3.0).powi(k as i32));
            assert!((found - exact).abs() < 1e-14 * 4.0, "{degree} {k}: {found} {exact}");
        }
    }
    // √(3/5) and 8/9 of the rule with three points.
    let three = Quadrature::on_interval([-1.0_f64, 1.0], 5).unwrap();
    let node = 0.6_f64.sqrt();
    for (found, expected) in three.points().iter().zip([-node, 0.0, node]) {
        assert!((found - expected).abs() < 2e-16);
    }
    for (found, expected) in three.weights().iter().zip([5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0]) {
        assert!((found - expected).abs() < 4e-16);
    }
    // The rule with 512 points: symmetric, and exact for a function with many oscillations.
    let many = Quadrature::on_interval([0.0, 1.0], 1023).unwrap();
    let sum = many.integrate(|x: f64| (300.0 * x).cos());
    assert!((sum - 300.0_f64.sin() / 300.0).abs() < 1e-14);
}

#[test]
fn boxes() {
    let rule = Quadrature::on_box([[0.0, -1.0, 2.0], [1.0, 1.0, 5.0]], 4).unwrap();
    assert_eq!((rule.len(), rule.degree()), (27, 5));
    let found = rule.integrate(|[x, y, z]: [f64; 3]| x.powi(5) * y.powi(4) * z.powi(3));
    let exact = 1.0 / 6.0 * 2.0 / 5.0 * (625.0 - 16.0) / 4.0;
    assert!((found / exact - 1.0).abs() < 1e-14);
    // The last coordinate fastest.
    let [first, second] = [rule.points()[0], rule.points()[1]];
    assert!(first[0] == second[0] && first[1] == second[1] && first[2] < second[2]);
}

#[test]
fn values_may_be_points_and_numbers_single() {
    let rule = Quadrature::<[f32; 3]>::on_simplex(2).unwrap();
    let centroid: [f32; 2] = rule.integrate(|[u, v, _]| [u, v]).scale(2.0);
    assert!(centroid.iter().all(|c| (c - 1.0 / 3.0).abs() < f32::EPSILON));
}

#[test]
fn what_cannot_be_a_rule_is_an_error() {
    let error = Quadrature::on_interval([1.0, 1.0], 3).unwrap_err();
    assert_eq!(error.to_string(), "the cell from 1 to 1 has no finite length above zero");
    for ends in [[0.0, f64::INFINITY], [f64::NAN, 1.0], [2.0, 1.0], [-f64::MAX, f64::MAX]] {
        assert!(matches!(Quadrature::on_interval(ends, 3), Err(QuadratureError::Domain { .. })));
        assert!(Quadrature::on_box([[0.0, ends[0]], [1.0, ends[1]]], 3).is_err());
    }
    let error = Quadrature::<[f64; 4]>::on_simplex(usize::MAX).unwrap_err();
    assert_eq!(error, QuadratureError::Degree { degree: usize::MAX, most: 321 });
    assert_eq!(
        Quadrature::on_interval([0.0, 1.0], 1024).unwrap_err().to_string(),
        "a rule of degree 1024 has too many points: the highest degree on this cell is 1023"
    );
    // In 30 dimensions one point in each direction is all that fits.
    assert_eq!(Quadrature::on_box([[0.0; 30], [1.0; 30]], 1).unwrap().len(), 1);
    assert!(matches!(
        Quadrature::on_box([[0.0; 30], [1.0; 30]], 2),
        Err(QuadratureError::Degree { degree: 2, most: 1 })
    ));
    assert!(f32::EPSILON.to_f64() > 0.0);
}
