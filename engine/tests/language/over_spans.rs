//! Integrals over several spans: each part of them has the formulas that hold there, whatever stands between.

use crate::verdicts::verdicts;
use basis_engine::{Source, check};

/// Every claim of a spec is found to be as it is declared, and checks out again.
fn as_declared(spec: &str) {
    let report = check(Source::text("spans.basis", spec));
    assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
    crate::rechecked::rechecked(&report);
}

#[test]
fn between_numbers() {
    as_declared(
        "family Ramp {
            domain 0 <= x <= 1, 1 <= x <= 3;
            f[0] = x | 1;
            f[1] = integral(x, x, 0, 1)*x | 1/2;
            prove integral(f[0], x, 0, 1) = 1/2;
            refute integral(f[0], x, 0, 1) = 1;
            prove integral(f[0], x, 0, 3) = integral(f[0]);
            prove integral(f[0], x, 1, 2) = 1;
            prove integral(f[0], x, 1/2, 2) = 11/8;
            prove integral(f[0], x, 2, 1/2) = -11/8;
            prove integral(f[0], x, 1, 1) = 0;
            prove integral(f, x, 0, 2) = [3/2, 3/4];
            prove integral(x^2, x, 0, 3) = 9;
        }",
    );
    // The counterexample has the value of the whole.
    let found = verdicts(
        "family Ramp {
            domain 0 <= x <= 1, 1 <= x <= 3;
            f[0] = x | 1;
            prove integral(f[0], x, 1/2, 3) <= 2;
        }",
    );
    assert_eq!(found, ["3/8 at "]);
}

/// A bound that depends on shape parameters is a knot, or stays in one span.
#[test]
fn between_parameters() {
    as_declared(
        "family Hat {
            shape 0 < h <= 2, 0 < d;
            domain 0 <= x <= h, h <= x <= h + d;
            f[0] = x/h | (h + d - x)/d;
            prove integral(f[0], x, 0, h) = h/2;
            prove integral(f[0], x, h/2, h + d/2) = 3*h/8 + 3*d/8;
            refute integral(f[0], x, h/2, h + d/2) = 3*h/8 + d/8;
            prove integral(f[0], x, h + d, 0) = -(h + d)/2;
            prove D(integral(f[0], x, 0, h + d/2), d) = 3/8;
            prove integral(f[0], x, 0, h) <= 1;
            refute integral(f[0], x, 0, h) < 1;
        }
        family Turn {
            domain 0 <= θ <= pi/2, pi/2 <= θ <= pi;
            f[0] = 1 - cos(θ) | sin(θ);
            prove integral(f[0], θ, 0, pi/2) = pi/2 - 1;
            prove integral(f[0], θ, 0, pi) = pi/2;
            prove integral(θ*f[0], θ, pi/2, pi) = pi - 1;
            refute integral(f[0], θ, pi/2, pi) = pi/2 - 1;
        }",
    );
}

/// Integrals in one another, and names with arguments whose integrands differ from span to span.
#[test]
fn of_arguments_and_of_integrals() {
    as_declared(
        "family Ramp {
            domain 0 <= x <= 1, 1 <= x <= 3;
            f[0] = x | 1;
            f[1] = 1 - x | 0;
            let mean(g) = integral(g)/3;
            let part(g, a) = integral(g*f[0], x, a, 2);
            prove mean(f[0]) = 5/6;
            prove mean(f[i]) = [5/6, 1/6][i] for i in 0..=1;
            prove integral((f[0] - mean(f[0]))^2) = 1/4;
            prove integral(f[0] - integral(f[0])) = -5;
            refute integral(f[0] - integral(f[0])) = -2;
            prove part(f[1], 1/2) = 1/12;
            prove part(f[0] + x, 0) = 19/6;
            prove mean(mean(f[0])) = 5/6;
        }",
    );
}

/// Exponentials over three spans whose length has a largest value: the quadratic hyperbolic B-spline.
#[test]
fn hyperbolic_splines() {
    let found = verdicts(
        "family Hyperbolic {
            shape 0 < α <= 1;
            domain 0 <= x <= α, α <= x <= 2*α, 2*α <= x <= 3*α;
            f[0] = sinh(x) | sinh(α) | sinh(3*α - x);
            prove smooth(0);
            prove nonnegative;
            prove smooth(1);
        }",
    );
    assert_eq!(found[..2], ["=", "="]);
    assert!(found[2].contains(" at "), "{found:?}");
}
