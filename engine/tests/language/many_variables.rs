//! Claims in many variables, and claims with more work.

use crate::verdicts::verdicts;

/// A bicubic rational patch whose 16 weights are parameters: its weight is positive, and so are the functions.
#[test]
fn weights_that_are_positive() {
    let patch = |low: &str, claim: &str| {
        format!(
            "family Patch {{
                domain 0 <= u <= 1, 0 <= v <= 1;
                shape {low} w[i] for i in 0..=15;
                let W = sum(w[4*i+j]*Bernstein(3)[i](u)*Bernstein(3)[j](v) for i in 0..=3, j in 0..=3);
                b[i, j] = w[4*i+j]*Bernstein(3)[i](u)*Bernstein(3)[j](v)/W for i in 0..=3, j in 0..=3;
                {claim}
            }}"
        )
    };
    assert_eq!(verdicts(&patch("0 <", "prove nonnegative;")), ["="]);
    let found = verdicts(&patch("1 <=", "refute b[0, 0] <= 1/2; prove W >= 1;"));
    assert!(found[0].contains(" at ") && found[1] == "=", "{found:?}");
}

/// A proof that takes too much work to check gives way to another one: with more work no proof is lost.
#[test]
fn more_work_loses_no_proofs() {
    for budget in [2, 10, 30, 1000] {
        let spec = format!(
            "family Sum {{
                domain 0 <= t <= 1;
                shape a, b, c, d;
                budget {budget};
                let p = a*(1 - t)^3 + b*t*(1 - t)^2 + c*t^2*(1 - t) + d*t^3;
                f[0] = p^2 + D(p)^2;
                prove f[0] >= 0;
                prove integral(p^2) >= 0;
            }}"
        );
        assert_eq!(verdicts(&spec), ["=", "="], "{budget}");
    }
}
