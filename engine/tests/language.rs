//! What papers write beyond single formulas: names with arguments, lists, chains, factors of families; each with true
//! claims and with false ones beside them, whose values were computed by other means.

mod support;

use basis_engine::{Source, Verdict, check};
use support::recheck;

/// The verdicts of a spec without other errors than false claims, `=` for proved, else the value of the counterexample
/// and its place. All of them check out.
fn verdicts(spec: &str) -> Vec<String> {
    let report = check(Source::text("language.basis", spec));
    let errors: Vec<&str> =
        report.diagnostics.iter().map(|d| d.message.as_str()).filter(|m| !m.contains("the claim")).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let mut all = Vec::new();
    for item in &report.items {
        for (claim, verdict) in &item.claims {
            assert_eq!(recheck(&item.subject, claim, verdict), Ok(()), "{}", claim.text);
            all.push(match verdict {
                Verdict::Proved(_) => String::from("="),
                Verdict::Refuted(witness) => format!("{} at {}", witness.value, witness.point()),
                Verdict::Undecided(left) => format!("undecided: {left}"),
            });
        }
    }
    all
}

#[test]
fn names_and_functions_stand_in_any_order() {
    let found = verdicts(
        "family F(n in 2..=2) {
            domain 0 <= t <= 1;
            shape -c <= λ <= c;
            b[2] = 1 - b[0] - b[1];
            b[1] = c*t*(1 - t)^(y[1] + 1);
            b[0] = h(1 - t)*k;
            let k = y[0]/2;
            let c = n;
            let h(x) = sum(p(x, i) for i in 1..=n)/n;
            let p(x, i) = x^i;
            let y = [2*k0, 0];
            let k0 = 1;
            let s = sum(b);
            prove s = 1;
            prove h(1/2) = 3/8*s;
            prove b[2] = (3*t^2 - t)/2 + λ - λ;
            prove b[2] >= 0;
            prove λ >= -2;
            prove λ > -2;
        }",
    );
    assert_eq!(found[..3], ["="; 3]);
    // (3t² − t)/2 has its minimum −1/24 at t = 1/6.
    assert!(found[3].starts_with('-'), "{}", found[3]);
    assert_eq!(found[4..], ["=", "0 at λ = -2, t = 1/2"]);
}

#[test]
fn a_name_with_arguments_sees_the_family_only() {
    let found = verdicts(
        "family F {
            domain 0 <= t <= 1;
            let i = 5;
            let f(x) = x + i;
            let pair(g) = [g, D(g)*t/2];
            let lagrange(x, j) = product((x - y[k])/(y[j] - y[k]) for k in 0..=2 if k != j);
            let y = [0, 1/3, 1];
            b[j] = lagrange(t, j) for j in 0..=2;
            prove partition_of_unity;
            prove b[j](y[k]) = 0 for j in 0..=2, k in 0..=2 if j != k;
            prove f(t) = t + 5;
            prove sum(f(k) for k in 0..=2) = 18 + 0*t;
            prove pair(t^2) = [t^2, t^2];
            prove D(lagrange(t, 1), t)(1/3) = 3/2;
        }",
    );
    assert_eq!(found, ["="; 11]);
}

#[test]
fn chains_are_true_as_a_whole() {
    let found = verdicts(
        "family Legendre {
            domain -1 <= x <= 1;
            P[0] = 1; P[1] = x; P[2] = (3*x^2 - 1)/2; P[3] = (5*x^3 - 3*x)/2;
            prove -1 <= P[i] <= 1 for i in 0..=3;
            refute -1/2 < P[2] <= 1;
            refute -1 <= P[3] < 1;
            prove 1 >= P[2] >= -1/2;
            prove at x = 1 { P[0] = P[1] = P[2] = P[3] = 1; }
            prove P[2] = P[3] = 0;
            prove -1/2 <= P[2] <= 3/4 <= 1;
        }",
    );
    assert_eq!(found[..4], ["="; 4]);
    assert_eq!(found[4..6], ["0 at x = 0", "0 at x = 1"]);
    assert_eq!(found[6..8], ["="; 2]);
    assert!(found[8].contains(" at x = ") && found[9].starts_with("1/4 at x = "), "{found:?}");
}

#[test]
fn conditions_are_joined_and_negated() {
    let found = verdicts(
        "family F(n in 3..=4) {
            domain 0 <= t <= 1;
            b[i] = t^i for i in 0..=n;
            prove at t = 0 { b[i] = 0 for i in 0..=n if !(i == 0 || i > n); }
            prove b[i] < 1 for i in 0..=n if (i == 0 || i == n) && !(i == 0) && n == 3;
            prove b[1] > 0 if n == 3 || n == 7;
        }",
    );
    assert_eq!(found, ["=", "=", "=", "0 at t = 1", "0 at t = 0", "=", "=", "=", "="]);
}

#[test]
fn interval_families_are_factors_on_a_box() {
    let found = verdicts(
        "family Hermite {
            domain 0 <= t <= 1;
            b[0] = (1 + 2*t)*(1 - t)^2; b[1] = t*(1 - t)^2; b[2] = t^2*(t - 1); b[3] = t^2*(3 - 2*t);
        }
        family Shaped { domain 0 <= t <= 1; shape 0 <= λ <= 2; b[0] = 1 - λ*t; b[1] = λ*t; }
        family Patch {
            domain 0 <= u <= 1, 0 <= v <= 1;
            shape 0 <= μ <= 1;
            b[i,j] = Bernstein(3)[i](u) * Hermite[j](v) for i in 0..=3, j in 0..=3;
            prove sum(b[i,0] + b[i,3] for i in 0..=3) = 1;
            prove Bernstein(2)(u) = [(1 - u)^2, 2*u*(1 - u), u^2];
            prove Shaped(μ)(u*v)[1] = μ*u*v;
            prove Shaped(μ)[1](2*v) = 2*μ*v;
            prove TriangularBernstein(2)[1,1,0](u, v, 1 - u - v) = 2*u*v;
            prove Bernstein(3)[1](v) = b[1,0](u, 0);
        }",
    );
    assert_eq!(found[..5], ["="; 5]);
    assert_eq!(found[5], "5/72 at μ = 1/2, u = 1/2, v = 1/3"); // 3v(1 − v)² − 3u(1 − u)² = 4/9 − 3/8
}

#[test]
fn integrals_over_the_domain_and_between_bounds() {
    let found = verdicts(
        "family Legendre {
            domain -1 <= x <= 1;
            shape 0 <= λ <= 1;
            P[0] = 1; P[1] = x; P[2] = (3*x^2 - 1)/2; P[3] = (5*x^3 - 3*x)/2;
            let inner(f, g) = integral(f*g);
            prove inner(P[i], P[j]) = 0 for i in 0..=3, j in 0..=3 if i != j;
            prove inner(P[i], P[i]) = 2/(2*i + 1) for i in 0..=3;
            refute inner(P[3], x^3) = 1/7;
            prove integral(P) = [2, 0, 0, 0];
            prove integral(x^2 + λ*x^3, x, 0, λ) = λ^3/3 + λ^5/4;
            prove D(integral(x^2/(1 + λ)), λ) = -2/(3*(1 + λ)^2);
            prove integral((x - λ)^2) >= 2/3;
            prove integral((x - λ)^2) > 2/3;
        }
        family Box {
            domain 0 <= u <= 1, -1 <= v <= 2;
            b[0] = u*v;
            prove integral(b[0]) = 3/4;
            prove integral(b[0], v, -1, 2) = 3/2*u;
            prove integral(u^2, u, 0, 1) = 1/3;
            prove integral(1) = 3;
        }
        family Corners {
            domain triangle (u, v, w);
            b[i,j,k] = TriangularBernstein(3)[i,j,k] for i, j, k in simplex(3);
            prove integral(b[i,j,k]) = 1/20 for i, j, k in simplex(3);
            prove integral(1) = 1/2;
            prove integral(u*v*w) = 1/120;
            prove integral(w^2) = 1/11;
        }
        family Solid {
            domain tetrahedron (u, v, w, x);
            b[0] = u; b[1] = v; b[2] = w; b[3] = x;
            prove integral(1) = 1/6;
            prove integral(b) = [1/24, 1/24, 1/24, 1/24];
            prove integral(b[3]^2*b[0]) = 1/360;
        }",
    );
    let equal = |range: core::ops::Range<usize>| found[range].iter().all(|v| v == "=");
    assert!(equal(0..16), "{found:?}");
    assert!(found[16].starts_with("-1/35 at"), "{}", found[16]); // 4/35 − 1/7
    assert!(equal(17..21), "{found:?}");
    assert!(found[21].starts_with("0 at λ = 0"), "{}", found[21]);
    assert!(equal(22..38), "{found:?}");
    assert!(found[38].starts_with("-1/132 at"), "{}", found[38]); // 1/12 − 1/11
    assert!(equal(39..42) && found.len() == 42, "{found:?}");
}

#[test]
fn integrals_of_curves() {
    let found = verdicts(
        "theorem Centre {
            curve P = Bernstein(3);
            scalar 0 <= h <= 1;
            prove integral(P(t), t, 0, 1) == (P[0] + P[1] + P[2] + P[3])/4;
            prove integral(D(P)(t), t, 0, h) == P(h) - P[0];
            refute integral(P(t), t, 0, 1) == (P[0] + 3*P[1] + 3*P[2] + P[3])/8;
            prove integral(t*h, t, h, 1) >= 0;
        }",
    );
    assert!(found[0] == "=" && found[1] == "=" && found[3] == "=", "{found:?}");
    assert_ne!(found[2], "=");
}
