//! Bounds that are attained inside of the domain, at numbers whose exponentials and tangents stand in the claim: true claims, with
//! false ones beside them, which are refuted or stay undecided.

use crate::rechecked::{counterexamples, rechecked};
use basis_engine::{Source, Verdict, check};

#[test]
fn exponentials_and_their_tangents() {
    let found = counterexamples(
        "family Short {
            domain 0 <= t <= 3;
            b[0] = t*exp(-t);
            prove b[0] <= exp(-1);
            prove t*exp(1 - t) <= 1;
            prove exp(t) >= t*exp(1);
            prove b[0] <= 368/1000;
            refute b[0] <= 367/1000;
            refute exp(t) >= t*exp(1) + 1/1000;
            refute exp(t) >= t*exp(1) + (t - 1)/1000;
        }
        family Long {
            domain 0 <= t <= 4;
            b[0] = exp(t);
            prove t*exp(-t) <= exp(-1);
            prove t*exp(1 - t) <= 1;
            prove b[0] >= t*exp(1);
            // At 2, and at 1 to the fourth order.
            prove t^2*exp(-t) <= 4*exp(-2);
            prove b[0] >= exp(1)*(1 + (t - 1) + (t - 1)^2/2 + (t - 1)^3/6);
            refute b[0] >= exp(1)*(1 + (t - 1) + (t - 1)^2/2 + (t - 1)^4/6);
        }
        family OnBothSides {
            domain -2 <= t <= 2;
            shape 0 <= λ <= 1;
            b[0] = exp(-t);
            prove b[0] >= exp(1)*(-t);
            prove b[0] + λ >= -t*exp(1);
            prove cosh(t) >= 1 + t^2/2;
            refute b[0] + λ >= 1/100 - t*exp(1);
        }",
    );
    assert_eq!(found.len(), 5, "{found:?}");
}

#[test]
fn tangents_of_the_sine() {
    let found = counterexamples(
        "family Quarter {
            domain 0 <= t <= pi/2;
            b[0] = sin(t);
            prove b[0] <= sin(pi/4) + cos(pi/4)*(t - pi/4);
            prove b[0] <= sin(pi/6) + cos(pi/6)*(t - pi/6);
            prove b[0] <= 1/2*sin(pi/3)/cos(pi/6) + cos(pi/6)*(t - pi/6) + (t - pi/6)^2;
            refute b[0] <= sin(pi/4) + cos(pi/4)*(t - pi/4) - 1/100000;
            refute b[0] <= sin(pi/4) + cos(pi/4)*(t - pi/4) - (t - pi/4)/100;
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}

/// The maximum exp(-1) of the first one is 0.36787944117…: nothing between it and the bounds is proved.
#[test]
fn near_misses_are_never_proved() {
    let report = check(Source::text(
        "claims.basis",
        "family Near {
            domain 0 <= t <= 3;
            b[0] = t*exp(-t);
            prove b[0] <= 3678794411/10000000000;
            prove exp(t) >= t*exp(1) + (t - 1)/10000000;
        }
        family Quarter {
            domain 0 <= t <= pi/2;
            shape 0 <= λ <= 1;
            b[0] = sin(t);
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ - 1/10000000000;
            prove b[0] + cos(t) < 2*sin(pi/4) + λ;
            prove b[0] <= sin(pi/4) + cos(pi/4)*(t - pi/4) - 1/10000000000;
        }",
    ));
    for verdict in rechecked(&report) {
        assert!(!matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
}

#[test]
fn where_a_shape_parameter_takes_part() {
    let found = counterexamples(
        "family Quarter {
            domain 0 <= t <= pi/2;
            shape 0 <= λ <= 1;
            b[0] = sin(t);
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ;
            prove b[0] + cos(t) <= 2*sin(pi/4)*(1 + λ);
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ*(1 - λ);
            refute b[0] + cos(t) <= 2*sin(pi/4) + λ - 1/1000;
            refute b[0] + cos(t) <= 2*sin(pi/4) + λ*(1 - 2*λ);
        }
        family Two {
            domain 0 <= t <= pi/2;
            shape 0 <= λ, -1 <= μ <= 1;
            b[0] = sin(t);
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ;
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ + μ + 1;
        }
        family Arc {
            shape 0 < α <= pi/2;
            domain 0 <= t <= α;
            b[0] = sin(t);
            prove b[0] + cos(t) <= 2*sin(pi/4);
            prove b[0] + sin(pi/3)*cos(t)/sin(pi/6) <= 2;
            refute b[0] + cos(t) <= 2*sin(pi/4) - 1/1000;
        }
        family LongArc {
            shape 0 < α < pi, 0 <= λ;
            domain 0 <= t <= α;
            b[0] = sin(t);
            prove b[0] + cos(t) <= 2*sin(pi/4) + λ;
            refute b[0] + cos(t) <= 2*sin(pi/4) + λ - 1/1000;
        }",
    );
    assert_eq!(found.len(), 4, "{found:?}");
}
