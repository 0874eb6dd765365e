//! Denominators that what is assumed keeps from 0, and others that it does not.

use basis_engine::{Source, check};

use crate::assumed::refuted;

/// Denominators that vanish in the declared ranges, but nowhere where what is assumed holds.
#[test]
fn denominators_that_assumptions_keep_from_zero() {
    let found = refuted(
        "family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 <= p <= 2, 0 <= q <= 2;
            assume p*q >= 1;
            b[0] = (1 - t)/p;
            b[1] = t/(p + q - 1);
            prove nonnegative;
            prove p*b[0] = 1 - t;
            prove b[0] <= 2;
            prove b[1] <= 1;
            prove 1/p <= q;
            refute b[0] <= 19/10;
            refute b[1] < 1;
            prove independent;
        }
        family TwoParts {
            domain 0 <= t <= 1;
            shape p, q;
            assume p*q >= 1;
            b[0] = (1 - t)/p;
            b[1] = t/(p*q - 1/2);
            prove b[0]*q >= 0;
            prove b[1] >= 0;
            prove b[1] <= 2;
            refute b[0] >= 0;
        }
        family Disk {
            domain 0 <= t <= 1;
            shape a, c;
            assume a^2 + c^2 <= 1;
            b[0] = (1 - t)^2/(3/2 + a - c);
            b[1] = 2*t*(1 - t)/(a*c - 1);
            b[2] = t^2/(9/8 - a);
            prove b[0] >= 0;
            prove b[1] <= 0;
            prove b[2] <= 8;
            refute b[2] <= 7;
            prove independent;
        }
        family Outside {
            domain 0 <= t <= 1;
            shape u, v, w;
            assume u^2 + v^2 + w^2 >= 1;
            b[0] = (1 - t)/(u^2 + v^2 + w^2);
            prove 0 <= b[0] <= 1;
            refute b[0] < 1;
        }
        theorem Circle {
            scalar x, y;
            assume x^2 + y^2 <= 1;
            prove 1/(2 - x - y) >= 1/4;
            prove 1/(2 - x) >= 1/3;
            refute 1/(2 - x - y) >= 1/2;
        }",
    );
    assert!(found[3].starts_with("1 at a = 1, c = 0"), "{found:?}");
}

/// A denominator that vanishes where what is assumed holds is named with the place; one that has both signs there, and no zero that
/// is found, is left.
#[test]
fn denominators_that_vanish_where_assumptions_hold() {
    for (assumed, below, place) in [
        ("a^2 + c^2 >= 1", "a + c", "vanishes at a = "),
        ("a^2 + c^2 <= 4", "a^2 + c^2 - 2", "sqrt("),
        ("a^2 + c^2 <= 2", "2 - a - c", "vanishes at a = 1, c = 1"),
        ("a^2 + c^2 <= 1", "3 - 2*t + a + c", "t = 1"),
        ("a*c >= 1", "a + c - 2", "vanishes at a = 1, c = 1"),
        // Of what is part of a box the point is an irrational one.
        ("a + c >= 3", "c^2 - 2", "vanishes at c = "),
    ] {
        let spec =
            format!("family F {{ domain 0 <= t <= 1; shape a, c; assume {assumed}; b[0] = t/({below}); }}");
        let report = check(Source::text("denominator.basis", &spec));
        let [error] = &report.diagnostics[..] else { panic!("{:?}", report.diagnostics) };
        assert!(error.message.contains(place), "{assumed}, {below}: {}", error.message);
    }
}

/// Where what is assumed has several parts a denominator may have another sign on each.
#[test]
fn total_positivity_beside_denominators_with_several_signs() {
    let found = refuted(
        "family Sign {
            domain 0 <= t <= 1;
            shape -1 <= p <= 1;
            assume p^2 >= 1/4;
            b[0] = (1 - t)/p;
            b[1] = t/p;
            refute totally_positive;
        }
        family OneMoves {
            domain 0 <= t <= 1;
            shape p, q;
            assume p*q >= 1;
            b[0] = (1 - t)/p;
            b[1] = t/q;
            refute totally_positive;
        }
        family Positive {
            domain 0 <= t <= 1;
            shape 0 <= p <= 2, 0 <= q <= 2;
            assume p*q >= 1;
            b[0] = (1 - t)/p;
            b[1] = t/q;
            prove totally_positive;
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}
