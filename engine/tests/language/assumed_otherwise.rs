//! Claims that are proved with fewer conditions than they have, or with these as they are written.

use crate::verdicts::verdicts;

/// `=` for each claim that is proved, `≠` for each one that is refuted.
fn marks(spec: &str) -> Vec<String> {
    let mark = |verdict: String| {
        if verdict.contains(" at ") && !verdict.starts_with("undecided") {
            String::from("≠")
        } else {
            verdict
        }
    };
    verdicts(spec).into_iter().map(mark).collect()
}

/// What is true without a condition is true with it, also where the condition makes the proof harder.
#[test]
fn conditions_that_a_claim_does_not_need() {
    let found = marks(
        "family F {
            domain 0 <= t <= 1;
            shape -2 <= p < 1, 0 < q <= 2;
            assume p^2 <= q;
            b[0] = (1 - t)*q;
            b[1] = t*p;
            prove q > 0;
            prove at t = 0 { b[0] > 0; }
            refute q > 1/1000;
            refute at t = 1 { b[0] > 0; }
        }
        family Symmetric {
            domain 0 <= t <= 1;
            shape -1 <= p <= 1, 0 < q <= 2;
            assume p^2 <= q;
            f[0] = 1 - t;
            f[1] = 1 + p*t + q;
            prove q > 0;
            prove q^3 > 0;
        }
        family G {
            domain 0 <= t <= 1;
            shape 4 <= k <= m <= 6, 0 <= r <= 1;
            assume r^2 + k^2 <= 121/4;
            b[0] = t*k;
            b[1] = (1 - t)*m + r;
            prove 5*(m - 5)^2*(m^4 - 3*m + 1) + 1/1000 > 0;
            refute 5*(m - 5)^2*(m^4 - 3*m + 1) > 0;
        }",
    );
    assert_eq!(found, ["=", "=", "≠", "≠", "=", "=", "=", "≠"]);
}

/// Where p² ≤ q, q·s² + 2·p·s·t + t² = (q − p²)·s² + (p·s + t)².
#[test]
fn multiples_of_a_condition_as_it_is_written() {
    let found = marks(
        "family Conic {
            domain 0 <= t <= 1;
            shape -2 <= p < 1, 0 < q <= 2;
            assume p^2 <= q;
            f[0] = q*(1 - t)^2 + 2*p*t*(1 - t) + t^2;
            prove nonnegative;
            refute f[0] > 0;
            prove q - p^2/2 > 0;
            refute q - p^2*1001/1000 >= 0;
        }",
    );
    assert_eq!(found, ["=", "≠", "=", "≠"]);
}

/// A sum of squares that is ≤ 0 has no term but 0.
#[test]
fn equations_that_an_inequality_says() {
    let found = marks(
        "family Line {
            domain 0 <= t <= 1;
            shape a, c;
            assume (a - 1)^2 + (c - 2*a)^2 <= 0;
            b[0] = (1 - t)*a;
            b[1] = t*c/2;
            prove a = 1;
            prove partition_of_unity;
            prove symmetric;
            refute c = 2*a + 1;
        }
        family Almost {
            domain 0 <= t <= 1;
            shape a, c;
            assume a^2 + c^2 <= 1/1000000;
            b[0] = t*a + c;
            refute a = 0;
            refute b[0] = 0;
        }",
    );
    assert_eq!(found, ["=", "=", "=", "≠", "≠", "≠"]);
}

/// f ≥ 0 and f ≤ 0 by two assumptions.
#[test]
fn equations_that_two_inequalities_say() {
    let found = marks(
        "family Circle {
            domain 0 <= t <= 1;
            shape -1 <= a <= 1, -1 <= c <= 1;
            assume a^2 + c^2 <= 1;
            assume a^2 + c^2 >= 1;
            b[0] = a*t;
            b[1] = c*t;
            prove a^2 + c^2 = 1;
            prove (1 - a)*(1 + a) = c^2;
            prove a + c <= 3/2;
            prove a*c <= 1/2;
            refute a^2 = 1;
            refute a + c = 1;
            refute a + c <= 1;
            refute a*c <= 0;
        }
        family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 <= p, 0 <= q;
            assume p*q >= 1;
            assume p*q <= 1;
            b[0] = p*t + q;
            prove p*q = 1;
            prove 1/p = q;
            refute p = q;
        }",
    );
    assert_eq!(found, ["=", "=", "=", "=", "≠", "≠", "≠", "≠", "=", "=", "≠"]);
}

/// Independence by a way that is not the first one from what is assumed; and functions that are dependent where k is at an end of its
/// range only, and m is irrational.
#[test]
fn independence_by_later_ways_and_dependence_at_an_end() {
    let found = marks(
        "family F {
            domain 0 <= t <= 1;
            shape -1 <= k <= 1, -1 <= m <= 1;
            assume (k + 1)*(m + 1) > 74/25;
            b[0] = (1 - t)^2*k;
            b[1] = ((k + 1)*(m + 1) - 74/25)^2*m + 3 - 3*t*k;
            prove independent;
        }
        family G {
            domain 0 <= t <= 1;
            shape 1 <= k <= 2, -2 <= m <= 2;
            assume k*m >= -1;
            b[0] = ((2 - k)^2 + (m^2 - 3)^2)*t;
            b[1] = 1 - t;
            refute independent;
        }",
    );
    assert_eq!(found, ["=", "≠"]);
}

/// Where α² + α·β + β² ≤ 3, α·x + β·y ≥ −2·√(x² − x·y + y²).
#[test]
fn functions_that_are_linear_on_an_ellipse() {
    let found = marks(
        "family Ellipse {
            domain 0 <= t <= 1;
            shape -3 <= α <= 3, -3 <= β <= 3;
            assume α^2 + α*β + β^2 <= 3;
            f[0] = 2*(t^2 + (1 - t)^2) + α*t^2 + β*(1 - t)^2;
            prove f[0] >= 0;
            refute f[0] >= 1/1000;
        }
        family Larger {
            domain 0 <= t <= 1;
            shape -3 <= α <= 3, -3 <= β <= 3;
            assume α^2 + α*β + β^2 <= 31/10;
            f[0] = 2*(t^2 + (1 - t)^2) + α*t^2 + β*(1 - t)^2;
            refute f[0] >= 0;
        }",
    );
    assert_eq!(found, ["=", "≠", "≠"]);
}
