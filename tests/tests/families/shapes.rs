//! Shape parameters with an index come as an array; a constructor enforces what is assumed.

use basis_runtime::basis;

basis! {
    family Pair {
        domain 0 <= t <= 1;
        shape 0 < q < p <= 1, 0 <= α[i] for i in 1..=2;
        assume α[1] + α[2] <= q;
        b[0] = (p - q)*(1 - t) + α[1];
        b[1] = (p - q)*t + α[2];
        prove nonnegative;
    }
    family Three {
        domain 0 <= t <= 1;
        /// How much is added to the powers.
        shape -1 <= λ[i] <= i for i in 1..=3, 0 <= γ;
        b[i] = (1 + λ[i])*t^i for i in 1..=3;
        b[0] = 1 + γ - sum(b[i] for i in 1..=3);
        prove sum(b) = 1 + γ;
    }
}

#[test]
fn parameters_with_an_index_are_an_array() {
    let family = Three::new([0.5, -1.0, 3.0], 0.25).unwrap();
    assert_eq!(family.lambda(), [0.5, -1.0, 3.0]);
    assert_eq!(family.gamma(), 0.25);
    let values = family.values(0.5);
    assert_eq!(values[1..], [0.75, 0.0, 0.5]);
    assert_eq!(values[0], 0.0);
    let error = Three::new([0.5, -1.5, 3.0], 0.25).unwrap_err();
    assert_eq!(error.parameter(), "λ[2]");
    assert_eq!(error.to_string(), "Three: λ[2] = -1.5 is outside the declared range -1 <= λ[2] <= 2");
}

#[test]
fn what_is_assumed_is_enforced() {
    let family = Pair::new(0.5, 0.75, [0.25, 0.25]).unwrap();
    assert_eq!(family.values(0.0), [0.5, 0.25]);
    let refused = |q: f64, p: f64, α: [f64; 2]| Pair::new(q, p, α).unwrap_err().to_string();
    assert_eq!(refused(0.75, 0.5, [0.0; 2]), "Pair: -q + p = -0.25 is outside the declared range q < p");
    assert_eq!(refused(0.5, 0.5, [0.0; 2]), "Pair: -q + p = 0 is outside the declared range q < p");
    assert!(refused(0.5, 0.75, [0.75, 0.0]).ends_with("outside the declared range α[1] + α[2] <= q"));
    assert!(refused(0.5, f64::NAN, [0.0; 2]).contains("is not a number"));
    assert!(Pair::new(0.25_f32, 1.0, [0.25, 0.0]).is_ok());
}
