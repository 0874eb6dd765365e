//! Assumptions on ranges without ends, and inequalities that are strict only because an assumption is.

use crate::assumed::refuted;
use crate::verdicts::verdicts;

/// Where p·q ≥ 1 neither p nor q is 0, each of them may be small, and then the other one is large.
#[test]
fn ranges_without_ends() {
    let found = refuted(
        "family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 <= p, 0 <= q;
            assume p*q >= 1;
            f[0] = p*t + q*(1 - t);
            f[1] = t/(p*t + q*(1 - t));
            prove f[0] > 0;
            prove nonnegative;
            prove p > 0;
            refute p >= 1/100;
            refute f[0] <= 1000;
            refute f[0] >= 1/100;
        }",
    );
    assert_eq!(found.len(), 3, "{found:?}");
}

/// A definite matrix: p·f − (p·q − r²)·t² is a square, and f(0) = p.
#[test]
fn strict_by_a_strict_assumption() {
    let found = verdicts(
        "family Definite {
            domain 0 <= t <= 1;
            shape 0 < p, 0 < q, r;
            assume p*q > r^2;
            f[0] = p*(1 - t)^2 + 2*r*t*(1 - t) + q*t^2;
            f[1] = t/(p*(1 - t)^2 + 2*r*t*(1 - t) + q*t^2);
            prove f[0] > 0;
            prove f[1] >= 0;
        }
        theorem Semidefinite {
            scalar 0 <= a, 0 <= c, b, x, y;
            assume b^2 <= a*c;
            prove a*x^2 + 2*b*x*y + c*y^2 >= 0;
        }",
    );
    assert_eq!(found, ["="; 3]);
}

/// What is ≥ 0 is more than a negative number; a square times the assumption is ≥ 0 also where the point that is farthest inside is
/// a zero of it.
#[test]
fn numbers_and_squares_beside_an_assumption() {
    let found = verdicts(
        "family Shifted {
            domain 0 <= t <= 1;
            shape -1 <= a <= 2, -1 <= c <= 2;
            assume 4*a*c > (a + c - 1)^2;
            f[0] = (3/2 - t)*a*c;
            prove f[0] >= -3/100;
        }
        family Squares {
            domain 0 <= t <= 1;
            shape 2 <= k <= 5, 2 <= m <= 5;
            assume (k - 2)*(m - 2) >= 27/4;
            f[0] = (m - k)^2*((k - 2)*(m - 2) - 27/4);
            prove f[0] >= 0;
        }",
    );
    assert_eq!(found, ["="; 2]);
}

/// Between √2 and the claim there is little, and only where t is at its end.
#[test]
fn false_by_little_at_an_end_of_the_domain() {
    let of = |assumed: &str, claim: &str| {
        format!(
            "family F {{
                domain 0 <= t <= 1; shape 0 <= a <= 2, 0 <= c <= 2;
                assume {assumed}; f[0] = a*t + c; f[1] = a*t; refute {claim};
            }}"
        )
    };
    refuted(&of("a^2 + c^2 <= 1", "f[0] <= 69/50"));
    refuted(&of("a^2 + c^2 < a + c", "f[1] <= 119/100"));
}
