//! Total positivity of functions in which a variable stands beside its sine or exponential.

use crate::rechecked::{counterexamples, rechecked};
use basis_engine::{Report, Source, Verdict, check};

fn none_is_proved(report: &Report) {
    for verdict in rechecked(report) {
        assert!(!matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
}

#[test]
fn bases_of_cycloids_and_catenaries() {
    let found = counterexamples(
        "family Quarter {
            domain 0 <= t <= pi/2;
            let z(x) = (x - sin(x))/(pi/2 - 1);
            b[0] = z(pi/2 - t);
            b[1] = (1 - sin(t) - z(pi/2 - t))/(2 - pi/2);
            b[2] = (1 - cos(t) - z(t))/(2 - pi/2);
            b[3] = z(t);
            prove totally_positive;
        }
        family CBezier {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            let h(t) = (t - sin(t))/(α - sin(α));
            let m = (1 - cos(α))^2/(2 - 2*cos(α) - α*sin(α));
            b[0] = h(α - t);
            b[1] = m*((1 - cos(α - t))/(1 - cos(α)) - b[0]);
            b[2] = m*((1 - cos(t))/(1 - cos(α)) - b[3]);
            b[3] = h(t);
            prove totally_positive;
        }
        family CBSpline {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            let e(t) = (t - sin(t))/(2*α*(1 - cos(α)));
            b[0] = e(α - t);
            b[1] = (α - t)/α + e(t) - 2*e(α - t);
            b[2] = t/α + e(α - t) - 2*e(t);
            b[3] = e(t);
            prove totally_positive;
        }
        family HBezier {
            shape 0 < α;
            domain 0 <= t <= α;
            let s = (sinh(t) - t)/(sinh(α) - α);
            b[0] = (sinh(α - t) - (α - t))/(sinh(α) - α);
            b[3] = s;
            let m = (cosh(α) - 1)^2/(α*sinh(α) - 2*cosh(α) + 2);
            b[1] = m*((cosh(α - t) - 1)/(cosh(α) - 1) - b[0]);
            b[2] = m*((cosh(t) - 1)/(cosh(α) - 1) - s);
            prove totally_positive;
        }
        family Weighted {
            domain 0 <= t <= 1;
            shape 0 < α < 1;
            b[0] = (1 - t)/(α - sin(α));
            b[1] = t/(α - sin(α));
            prove totally_positive;
        }",
    );
    assert!(found.is_empty(), "{found:?}");
}

/// All of these are false but the last one, whose functions vanish twice and three times at 0. The first one was proved, with a
/// matrix without rows, and the others were refuted, also the last one, with a variable apart from its sine.
#[test]
fn other_functions_are_never_proved() {
    let report = check(Source::text(
        "claims.basis",
        "family Swapped {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            let e(t) = (t - sin(t))/(2*α*(1 - cos(α)));
            b[0] = e(α - t);
            b[2] = (α - t)/α + e(t) - 2*e(α - t);
            b[1] = t/α + e(α - t) - 2*e(t);
            b[3] = e(t);
            prove totally_positive;
        }
        family Rising {
            domain 0 <= t <= pi/2;
            b[0] = 1 + t - sin(t);
            b[1] = 1;
            prove totally_positive;
        }
        family Signs {
            domain 0 <= t <= 1;
            shape 0 < α < 1;
            b[0] = (1 - t)/(α - sin(α));
            b[1] = t/(sin(α) - α);
            prove totally_positive;
        }
        family Alone {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = α - t - sin(α - t);
            b[1] = t - sin(t);
            b[2] = t;
            prove totally_positive;
        }
        family Lines {
            domain 0 <= t <= pi;
            b[0] = 1;
            b[1] = t;
            b[2] = sin(t);
            prove totally_positive;
        }",
    ));
    assert!(!rechecked(&report).is_empty());
    none_is_proved(&report);
    let cycloid = check(Source::text(
        "claims.basis",
        "family Cycloid {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            let s = (t - sin(t))/(α - sin(α));
            let c = (1 - cos(t))/(1 - cos(α));
            b[0] = 1 - c;
            b[1] = c - s;
            b[2] = s;
            prove totally_positive;
        }",
    ));
    assert!(!matches!(rechecked(&cycloid)[0], Verdict::Refuted(_)), "{:?}", rechecked(&cycloid)[0]);
}

/// One Wronskian is negative, among others that are positive and take more work than there is; no proof is searched before.
#[test]
fn negative_wronskians_are_found_first() {
    let found = counterexamples(
        "family Falling {
            domain 0 <= t <= 1;
            b[0] = exp(t);
            b[1] = 1;
            b[2] = t^2;
            refute totally_positive;
        }
        family Weighted {
            domain 0 <= t <= 1;
            shape 0 <= λ <= 1, 0 <= μ <= 2;
            b[0] = exp(t);
            b[1] = 1;
            b[2] = λ*t^2;
            b[3] = μ*t^3;
            refute totally_positive;
        }",
    );
    let of_the_first_two = |found: &String| found.starts_with("-exp(1) at ");
    assert!(found.len() == 2 && found.iter().all(of_the_first_two), "{found:?}");
}

/// Their spans have no functions that vanish as often as they must at both ends: proved by the functions themselves.
#[test]
fn positive_wronskians_are_enough() {
    let found = counterexamples(
        "family Exponential {
            domain 0 <= t <= 1;
            b[0] = exp(t);
            b[1] = t;
            prove totally_positive;
        }
        family Circle {
            domain 0 <= t <= pi/2;
            b[0] = cos(t);
            b[1] = sin(t);
            b[2] = t;
            prove totally_positive;
        }
        family Catenary {
            shape 0 < α;
            domain 0 <= t <= α;
            b[0] = 1;
            b[1] = sinh(t) + t;
            prove totally_positive;
        }
        family Inflection {
            domain 0 <= t <= 1;
            b[0] = exp(0);
            b[1] = (1 + (2*t - 1)^3)*exp(t);
            prove totally_positive;
        }",
    );
    assert!(found.is_empty(), "{found:?}");
}

/// Almost the same ones: a Wronskian is negative next to an end, or a function vanishes inside, where the other Wronskians say
/// nothing.
#[test]
fn other_wronskians_are_not_enough() {
    let report = check(Source::text(
        "claims.basis",
        "family Early {
            domain 0 <= t <= 1;
            b[0] = exp(11/10*t);
            b[1] = 1 + t;
            prove totally_positive;
        }
        family Double {
            domain 0 <= t <= 1;
            b[0] = (2*t - 1)^2;
            b[1] = (2*t - 1)^2*exp(t) + (1 - t)*t;
            prove totally_positive;
        }
        family Turned {
            domain 0 <= t <= pi/2;
            b[0] = sin(t);
            b[1] = cos(t);
            b[2] = t;
            prove totally_positive;
        }",
    ));
    assert_eq!(rechecked(&report).len(), 3);
    none_is_proved(&report);
}
