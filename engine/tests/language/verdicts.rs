//! What papers write beyond single formulas: names with arguments, lists, chains, factors of families; each with true
//! claims and with false ones beside them, whose values were computed by other means.

use crate::rechecked::rechecked;
use crate::support::recheck;
use basis_engine::{Source, Verdict, check};

/// The verdicts of a spec without other errors than false claims, `=` for proved, else the value of the counterexample
/// and its place. All of them check out.
pub(crate) fn verdicts(spec: &str) -> Vec<String> {
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

/// The ends of the domain are those of the counterexample, in ranges that depend on one another too.
#[test]
fn points_between_ends_that_are_parameters() {
    let found = verdicts(
        "family Between {
            domain k <= t <= m;
            shape 2/3 <= k < m <= 8/3;
            b[0] = (m - t)*(m - k);
            b[1] = t - k;
            prove partition_of_unity;
            prove t <= 5/3;
            prove b[0] + b[1]*(m - k) = (m - k)^2;
        }",
    );
    assert_eq!(found, ["-17/72 at k = 1, m = 11/6, t = 17/12", "1 at k = 1, m = 8/3, t = 8/3", "="]);
}

/// Numbers such as exp(500) have bounds, so that denominators made of them are known not to vanish.
#[test]
fn exponentials_of_large_numbers_have_bounds() {
    let found = verdicts(
        "family Long {
            shape 0 < α <= 500;
            domain 0 <= t <= α;
            b[0] = (cosh(α - t) - 1)/(cosh(α) - 1);
            b[1] = 1 - b[0];
            prove b[0] >= 0;
            prove b[1] >= 0;
            refute b[0] > 0;
        }",
    );
    assert_eq!(found[..2], ["=", "="]);
    assert!(found[2].starts_with("0 at "), "{found:?}");
    let beyond = "family F { shape 0 < α <= 600; domain 0 <= t <= α; b[0] = sinh(t)/sinh(α); }";
    let report = check(Source::text("language.basis", beyond));
    let messages: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages, ["exp(600), which this contains, is too large a number"]);
}

/// An equation is false where a point of what is assumed says so, if that is a corner or a disk.
#[test]
fn equations_under_assumptions() {
    let found = verdicts(
        "family Corner {
            domain 0 <= t <= 1;
            shape -4 <= k <= -3;
            shape -4 <= m <= -3;
            assume (k + 4)*(m + 4) > 37/50;
            b[0] = t*(m - k);
            b[1] = 1 - t;
            prove partition_of_unity;
            prove integral(b[1]) = 1/2;
            prove m = k;
        }
        family Disk {
            domain 0 <= t <= 1;
            shape -3 <= k <= 0, -3 <= m <= 0;
            assume (k + 3/2)^2 + (m + 3/2)^2 <= 9/4;
            b[0] = 1 - t;
            prove (k + 3/2)^2 + (m + 3/2)^2 = 3;
            prove at k = 0 { m = -3/2; }
        }",
    );
    assert_eq!(
        found,
        [
            "-1 at k = -3, m = -3, t = 1",
            "=",
            "-1/24 at k = -3, m = -73/24",
            "-3 at k = -3/2, m = -3/2",
            "=" // one point of the disk is left
        ]
    );
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
    assert_eq!(found[..2], ["="; 2]);
    // (3t² − t)/2 has its minimum −1/24 at t = 1/6.
    assert!(found[3].starts_with('-'), "{}", found[3]);
    assert_eq!(found[4..], ["=", "0 at λ = -2"]);
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
    assert_eq!(found[5], "5/72 at u = 1/2, v = 1/3"); // 3v(1 − v)² − 3u(1 − u)² = 4/9 − 3/8
}

/// The reference prism has the volume 1/2·2; the numbers of false claims are those of the corners and edges.
#[test]
fn products_of_simplices_and_intervals() {
    let found = verdicts(
        "family Wedge {
            domain triangle (u, v, w), -1 <= z <= 1;
            b[i,j,k,l] = Bernstein(1)[l]((1 + z)/2) * u^i * v^j * w^k for i, j, k in simplex(1), l in 0..=1;
            prove partition_of_unity; prove nonnegative; prove symmetric; prove independent;
            prove integral(1 + 0*u) = 1;
            prove integral(u^2*z^2) = 2/3 * 2/24;
            prove D(b[0,0,1,1], u, z) = -1/2;
            prove at z = -1 { b[0,0,1,0] = w; b[0,0,1,1] = 0; }
            prove at w = 1, z = 1/2 { b[0,0,1,1] = 3/4; }
            prove at z = u { b[1,0,0,1] = u*(1 + u)/2; }
            prove at w = 1/4, u = 1/4 { b[0,1,0,0] = (1 - z)/4; }
            prove b[1,0,0,0](0, 1/2, 1/2, 1) + b[0,1,0,1](0, 1/2, 1/2, 1) = u + v + w - 1/2;
            prove D(b[1,0,0,1], u) >= 0;
            prove integral(u) = 1/3;
            prove integral(u) = 1/6;
            prove b[0,0,1,1] <= 9/10;
            prove at z = 0 { b[0,0,1,1] < 1/2; }
            prove w*z >= -9/10;
            prove D(b[0,0,1,1], v) = -(1 - z)/2;
        }",
    );
    assert_eq!(found[..15], ["="; 15]);
    assert_eq!(
        found[15..],
        [
            "1/6 at ", // 1/6·2 is 1/3
            "1/10 at u = 0, v = 0, w = 1, z = 1",
            "0 at u = 0, v = 0, w = 1, z = 0",
            "-1/10 at u = 0, v = 0, w = 1, z = -1",
            "-1 at u = 1/2, v = 1/4, w = 1/4, z = 1",
        ]
    );
}

/// The interval first, a simplex of four corners, two triangles: coordinates, indices and arguments in the order of the domain.
#[test]
fn factors_of_a_domain_stand_in_any_order() {
    let found = verdicts(
        "family Solid {
            domain 0 <= x <= 2, tetrahedron (p, q, r, s), -1 <= z <= 1;
            shape 0 <= λ <= 1;
            b[0] = λ*x*p*(1 - z)/4;
            b[1] = 1 - b[0];
            prove nonnegative;
            prove integral(b[0]) = λ/24; // 2·1/24·2/4
            prove at p = 1, x = 2 { b[0] = λ*(1 - z)/2; }
            prove b[0](1, 1/2, 1/2, 0, 0, 0) = λ/8;
            prove D(b[0], x, z) = -λ*p/4;
            prove independent except λ = 0;
            prove b[0] < 1;
            prove p + q + r <= 1/2;
        }
        family Pair {
            domain triangle (u, v, w), triangle (r, s, t);
            permute b[1,0,0,1,0,0] = u*r;
            prove partition_of_unity; prove symmetric; prove independent;
            prove integral(b[0,0,1,0,1,0]) = 1/36;
            prove b[0,0,1,0,0,1] = w*t;
            prove b[0,1,0,0,0,1] = w*t;
        }
        family Recursive(n in 2..=2) {
            domain -1 <= z <= 1, triangle (u, v, w);
            base n = 1 { permute b[0,1,0,0] = u*(1 - z)/2; permute b[1,1,0,0] = u*(1 + z)/2; }
            raise b[l,i,j,k] = (1 - z)/2*(u*b[l,i-1,j,k] + v*b[l,i,j-1,k] + w*b[l,i,j,k-1])
                + (1 + z)/2*(u*b[l-1,i-1,j,k] + v*b[l-1,i,j-1,k] + w*b[l-1,i,j,k-1]);
            prove b[l,i,j,k] = Bernstein(2)[l]((1 + z)/2) * 2/(factorial(i)*factorial(j)*factorial(k))*u^i*v^j*w^k
                for l in 0..=2, i, j, k in simplex(2);
        }",
    );
    assert_eq!(found[..6], ["="; 6]);
    assert_eq!(found[6], "0 at λ = 1, x = 2, p = 1, q = 0, r = 0, s = 0, z = -1");
    assert!(found[7].starts_with("1/2 at"), "{}", found[7]);
    assert_eq!(found[8..13], ["="; 5]);
    assert_eq!(found[14..], ["="; 18]);
}

#[test]
fn assumptions_beside_simplices() {
    let found = verdicts(
        "family Disk {
            domain triangle (u, v, w), -1 <= z <= 1;
            shape -1 <= a <= 1, -1 <= c <= 1;
            assume a^2 + c^2 <= 1/4;
            b[0] = u*z*a; b[1] = v*c;
            prove b[0]^2 + b[1]^2 <= 1/4;
            prove b[0] + b[1] <= 1/2;
            prove b[0] + b[1] <= 1/3;
        }
        family Half {
            domain triangle (u, v, w);
            shape 0 <= a <= 1, 0 <= c <= 1;
            assume 2*a*c <= 1/2;
            b[0] = a*c*u; b[1] = 1 - b[0];
            prove b[0] <= 1/4;
            prove b[0] < 1/5;
        }",
    );
    assert_eq!([&found[0], &found[3]], ["="; 2]);
    // The second needs both the assumption and u + v <= 1, which no multiple of the one gives.
    assert!(found[1] == "=" || found[1].starts_with("undecided"), "{}", found[1]);
    for k in [2, 4] {
        assert!(!found[k].starts_with('-') && found[k].contains(" at a = "), "{}", found[k]);
    }
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

#[test]
fn ranges_depend_on_other_parameters() {
    let found = verdicts(
        "family Pair {
            domain 0 <= t <= 1;
            shape 0 < q < p <= 1;
            b[0] = (p - q)*t; b[1] = q*(1 - t) + 1 - p;
            prove nonnegative;
            prove q < 1;
            prove p - q > 0;
            prove at p = 1/2 { q < 1/2; b[0] <= t/2; }
            prove independent;
            refute p - q >= 1/10;
            refute q < 1/2;
            refute at p = 1/2 { q < 1/3; }
            refute independent except (p = 1/2, q = 1/4);
        }
        family Below {
            domain 0 <= t <= 1;
            shape -1 <= λ <= 2;
            shape 0 <= μ <= λ;
            b[0] = 1 + μ*t; b[1] = λ*t + 1;
            prove λ >= 0;
            prove b[1] >= b[0];
            prove at λ = 0 { b[0] = 1; b[0] = b[1]; }
            prove at μ = λ { b[0] = b[1]; }
            prove at μ = 1 { λ >= 1; }
            refute at μ = 1 { λ > 1; }
            refute independent except λ = 0, μ = 0;
        }",
    );
    assert_eq!(found[..6], ["="; 6], "{found:?}");
    let at_q = ["-1/60 at q = 2/3, p = 3/4", "0 at q = 1/2, p = 3/4"];
    assert_eq!(found[6..8], at_q);
    assert_eq!(found[8], "0 at q = 1/3, p = 1/2");
    assert!(found[9].ends_with(" at q = 1/4, p = 1/2"), "{}", found[9]);
    assert_eq!(found[10..16], ["="; 6], "{found:?}");
    assert_eq!(found[16..], ["0 at λ = 1, μ = 1", "16/9 at λ = 4/3, μ = 0"]);
}

#[test]
fn shape_parameters_with_an_index() {
    let found = verdicts(
        "family F(n in 2..=3) {
            domain 0 <= t <= 1;
            shape -binomial(n, i) <= λ[i] <= binomial(n, i - 1) for i in 1..=n, 0 <= γ;
            b[i] = (1 + λ[i])*t^i for i in 1..=n;
            b[0] = 1 - sum(b[i] for i in 1..=n) + γ;
            prove sum(b) = 1 + γ;
            prove λ[1] <= 1;
            prove D(b[1], λ[1]) = t;
            prove sum(λ) = sum(λ[i] for i in 1..=n);
            prove at λ = 0 { b[1] = t; b[2] = t^2; }
            prove at λ[1] = -1 { b[1] = 0; }
            prove independent except λ[1] = -1, λ[2] = -1, λ[3] = -1 if n == 3;
            refute λ[n] > -1;
            refute independent except λ[1] = -1 if n == 2;
        }",
    );
    assert_eq!(found.iter().filter(|v| *v == "=").count(), 15, "{found:?}");
    assert_eq!(found[7], "0 at λ[2] = -1");
}

#[test]
fn total_positivity() {
    let found = verdicts(
        "family Powers { domain 0 <= t <= 1; b[i] = t^i for i in 0..=5; prove totally_positive; }
        family Quadratic {
            domain 0 <= t <= 1;
            shape -2 <= λ <= 1;
            b[0] = (1 - λ*t) * (1 - t)^2;
            b[1] = (2 + λ) * (1 - t) * t;
            b[2] = (1 - λ + λ*t) * t^2;
            prove totally_positive;
        }
        family Conic {
            domain 0 <= t <= 1;
            shape 0 < ω;
            let w = (1 - t)^2 + 2*ω*t*(1 - t) + t^2;
            b[0] = (1 - t)^2/w; b[1] = 2*ω*t*(1 - t)/w; b[2] = t^2/w;
            prove totally_positive;
        }
        family Raised {
            domain 0 <= t <= 2;
            b[0] = (2 - t)^2 + t^2/4; b[1] = t^2;
            prove totally_positive;
        }
        family Below { domain -1 <= t <= 1; b[i] = t^i for i in 0..=2; refute totally_positive; }
        family Nodes {
            domain 0 <= t <= 1;
            b[0] = 2*(t - 1/2)*(t - 1); b[1] = 4*t*(1 - t); b[2] = 2*t*(t - 1/2);
            refute totally_positive;
        }
        family Swapped { domain 0 <= t <= 1; b[0] = t; b[1] = 1 - t; refute totally_positive; }
        family Third {
            domain 0 <= t <= 1;
            b[0] = 1; b[1] = 1 + t; b[2] = 1 + 3*t - t^2;
            refute totally_positive;
        }
        family Depends {
            domain 0 <= t <= 1;
            shape 0 <= p <= 1, 0 <= q <= 1;
            b[0] = 1 + p*t; b[1] = 1 + q*t;
            refute totally_positive;
        }
        family Ordered {
            domain 0 <= t <= 1;
            shape 0 <= p <= q <= 1;
            b[0] = 1 + p*t; b[1] = 1 + q*t;
            prove totally_positive;
        }
        family Many {
            domain 0 <= t <= 1;
            b[i] = t^i*(1 - t)^(60 - i)*(1 + t) for i in 0..=60;
            prove totally_positive;
        }
        family Backwards {
            domain 0 <= t <= 1;
            b[i] = t^(60 - i)*(1 - t)^i for i in 0..=60;
            refute totally_positive;
        }",
    );
    assert_eq!(found[..4], ["="; 4], "{found:?}");
    assert_eq!(found[4], "-1 at ");
    assert_eq!(found[5..7], ["-1/8 at ", "-1/3 at "]);
    // 1, 1 + t, 1 + 3t − t² have the determinant −(t₁ − t₀)(t₂ − t₀)(t₂ − t₁).
    assert!(found[7].starts_with('-'), "{}", found[7]);
    assert!(found[8].starts_with('-') && found[8].contains("p = "), "{}", found[8]);
    assert_eq!(found[9..11], ["="; 2]);
    assert!(found[11].starts_with('-'), "{}", found[11]);
}

#[test]
fn neighbours_have_other_shape_values() {
    // A segment of a spline with one number for each interval: b[0] ends where its part in the next one begins.
    let found = verdicts(
        "family Segment {
            domain 0 <= t <= 1;
            shape 0 < a <= 1, 0 < c <= 1;
            b[0] = (1 - t)*a; b[1] = t*c;
            prove continuity(0) with a = c;
            refute continuity(0);
            refute continuity(1) with a = c;
            refute continuity(0) with c = a;
            refute continuity(0) with a = c/2;
        }
        family Knots {
            domain 0 <= t <= 1;
            shape 0 < d0, 0 < d1, 0 < d2;
            let s = d1*t;
            b[0] = (d1 - s)^2/(d1*(d0 + d1));
            b[2] = s^2/(d1*(d1 + d2));
            b[1] = 1 - b[0] - b[2];
            prove continuity(0) with d0 = d1, d1 = d2;
            refute continuity(0);
        }",
    );
    assert_eq!(found[0], "=");
    assert!(found[1..5].iter().all(|v| v.contains(" at a = 1/2, c = ")), "{found:?}");
    assert!(found[3].contains("a' = "), "{}", found[3]);
    assert_eq!(found[5], "=");
    assert_ne!(found[6], "=");
}

/// A variable beside its own sine or exponential ends where the domain does, and is no variable of its own there.
#[test]
fn variables_beside_their_sine_end_with_the_domain() {
    let spans = "family F { domain 0 <= x <= 1, 1 <= x <= 2; f[0] = exp(x) | exp(1)*x;
        prove smooth(1); prove smooth(2); }";
    let found = verdicts(spans);
    assert!(found[0] == "=" && !found[1].starts_with(['=', 'u']), "{found:?}");
    let joints =
        "family F { domain 0 <= t <= pi; b[0] = pi - t + sin(t); b[1] = t - sin(t); prove continuity(0); }
        family G { domain 0 <= t <= 2; b[0] = 1 - t/2 + 0*exp(t); b[1] = t/2; prove continuity(0); }";
    assert_eq!(verdicts(joints), ["="; 2]);
}

/// What is enough for a claim, and a value that is taken for a number, refute nothing.
#[test]
fn no_counterexample_where_none_is_known() {
    let spec = "family F { domain 0 <= t <= pi/2; shape -1 <= a <= 1, -1 <= c <= 1; assume a^2 + c^2 <= 1;
            b[0] = 19/10 + a*t + c*sin(t); prove nonnegative; prove b[0] >= -1; }
        family G { domain 0 <= t <= 1; b[0] = 3.14159265358979323846265 - pi; prove totally_positive; }
        family H { domain 0 <= t <= 1; shape 0 <= α <= 0; b[0] = 1 + sin(α)*t; prove α = 0; }";
    let mut found = verdicts(spec);
    assert_eq!(found.remove(1), "=");
    assert!(found.len() == 3 && found.iter().all(|v| v.starts_with("undecided")), "{found:?}");
}

/// sin t is negative beyond π, where the tangent of t/2 is another one.
#[test]
fn an_angle_does_not_pass_the_pole_of_its_tangent() {
    for domain in ["0 <= t <= α + pi", "0 <= t <= α + pi/2", "0 <= t <= α + β", "α <= t <= α + β"] {
        let spec = format!(
            "family F {{ shape 0 < α < pi, 0 < β < pi; domain {domain}; b[0] = sin(t); prove sin(t) >= 0; }}"
        );
        let report = check(Source::text("pole.basis", &spec));
        let found: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert!(found.iter().any(|m| m.ends_with("can be pi or more")), "{domain}: {found:?}");
        assert!(report.items.is_empty(), "{domain}");
    }
}

#[test]
fn polynomials_up_to_a_multiple_of_pi() {
    let found = verdicts(
        "family HalfTurn {
            domain 0 <= t <= pi;
            b[0] = 1 - t/pi;
            b[1] = t/pi;
            prove partition_of_unity;
            prove nonnegative;
            prove symmetric;
            prove independent;
            prove D(b[1]) = 1/pi;
            prove integral(b[1]) = pi/2;
            prove integral(b[0]*b[1]) = pi/6;
            prove at t = pi { b = [0, 1]; }
            refute b[1] <= 9/10;
        }
        family Shifted {
            domain -pi <= t <= 2*pi;
            shape 0 <= k <= 1;
            b[0] = (2*pi - t)^2/(9*pi^2) - k*t;
            prove b[0] >= -63/10;
            refute b[0] >= -62/10;
            prove D(b[0]) <= 0;
            prove at k = 0 { integral(b[0]) = pi; }
        }
        family Hat {
            domain -pi <= t <= 0, 0 <= t <= pi;
            b[0] = 1 + t/pi | 1 - t/pi;
            prove smooth(0);
            prove nonnegative;
            prove symmetric;
            prove integral(b[0]) = pi;
            refute smooth(1);
        }",
    );
    let refuted: Vec<&str> = found.iter().map(String::as_str).filter(|f| *f != "=").collect();
    assert_eq!(found.len(), 18);
    assert_eq!(refuted[0], "1/10 at t = pi");
    assert!(refuted[1].ends_with("at k = 1, t = 2*pi"), "{refuted:?}");
    assert_eq!(refuted.len(), 3);
}

/// The angle of the parameter is half of that of the variable there.
#[test]
fn angles_in_the_middle_of_a_domain() {
    let found = verdicts(
        "family CBezierQuadratic {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = (1 - cos(α - t))/(1 - cos(α));
            b[2] = (1 - cos(t))/(1 - cos(α));
            b[1] = 1 - b[0] - b[2];
            prove at t = α/2 { b[0] = b[2]; b[0] = 1/(2 + 2*cos(α/2)); D(b[1]) = 0; }
            prove b[1](α/2) <= 1/2;
            prove b[1] <= b[1](α/2);
            refute at t = α/2 { b[1] = 1/2; }
            prove nonnegative;
        }
        family Between {
            shape 0 < α < pi, 0 < β < pi;
            domain -α <= t <= β;
            b[0] = sin(β - t);
            b[1] = sin(t + α);
            prove at t = (β - α)/2 { b[0] = b[1]; }
            prove at t = β/2 { b[0] = sin(β/2); }
        }",
    );
    let expected = ["=", "=", "=", "=", "=", "-1/8 at tan(α/4) = 1/2, tan(t/2) = 1/2", "=", "=", "="];
    assert_eq!(found, expected);
}

/// The tangents at the ends are irrational; claims are sharp there.
#[test]
fn angles_that_end_at_a_third_of_a_turn() {
    let found = verdicts(
        "family CBezierQuadratic {
            shape 0 < α <= 2*pi/3;
            domain 0 <= t <= α;
            b[0] = (1 - cos(α - t))/(1 - cos(α));
            b[2] = (1 - cos(t))/(1 - cos(α));
            b[1] = 1 - b[0] - b[2];
            prove nonnegative;
            prove cos(α) >= -1/2;
            prove (1 + 2*cos(α))*sin(t) >= 0;
            prove 1 - cos(t) <= 3/2;
            refute cos(α) >= -499/1000;
        }
        family TwoEnds {
            shape pi/6 <= α < pi/3, pi/4 <= β <= 3*pi/4;
            domain 0 <= t <= pi/2;
            b[0] = cos(t)*cos(α) + sin(t)*sin(β);
            prove sin(α) >= 1/2;
            prove 2*cos(α) - 1 > 0;
            prove cos(β)^2 <= 1/2;
            prove cos(α) + sin(β) >= 6/5;
            prove tan(α)^2 < 3;
            refute sin(α)^2 <= 29/10*cos(α)^2;
            refute 2*cos(β)^2 <= 999/1000;
        }
        family FifthOfATurn {
            shape 0 < α < 2*pi/5;
            domain 0 <= t <= α;
            b[0] = sin(α - t)/sin(α);
            b[1] = sin(t)/sin(α);
            prove 16*sin(α)^4 - 20*sin(α)^2 + 5 <= 5;
            prove nonnegative;
            prove 4*cos(α)^2 + 2*cos(α) - 1 > 0;
            refute 4*cos(α)^2 + 2*cos(α) - 1 > 1/100;
        }",
    );
    let is_proved = found.iter().map(|verdict| verdict == "=").collect::<Vec<_>>();
    let expected = [&[true; 4][..], &[false], &[true; 5], &[false; 2], &[true; 3], &[false]];
    assert_eq!(is_proved, expected.concat(), "{found:?}");
    assert!(found.iter().all(|verdict| !verdict.starts_with("undecided")), "{found:?}");
}

/// Values at a knot are compared in one tangent, and in powers of one exponential, whatever the ends of the other spans are.
#[test]
fn spans_of_different_lengths() {
    let found = verdicts(
        "family Angles {
            shape 0 < h < pi/3;
            domain 0 <= x <= 2*h, 2*h <= x <= 3*h;
            b[0] = sin(x) | sin(x);
            b[1] = sin(x) | sin(x)*cos(x - 2*h);
            prove smooth(1);
            refute smooth(2);
        }
        family Exponentials {
            domain 0 <= t <= 2, 2 <= t <= 3, 3 <= t <= 7/2;
            b[0] = exp(t) | exp(t) | exp(t);
            b[1] = t*exp(-t) | t*exp(-t) | t*exp(-t);
            b[2] = 1 | exp(t - 2) | exp(1)*(t - 2);
            prove smooth(0);
            refute smooth(1);
        }
        family QuadraticTrigonometricBSpline {
            shape 0 < h < 2*pi/3;
            domain 0 <= x <= h, h <= x <= 2*h, 2*h <= x <= 3*h;
            let c = sin(h/2)*sin(h);
            let p(x) = sin(x/2)^2/c;
            let q(x) = (sin(x/2)*sin((2*h - x)/2) + sin((3*h - x)/2)*sin((x - h)/2))/c;
            N[0] = p(x) | q(x) | p(3*h - x);
            prove smooth(1);
            refute smooth(2);
            prove nonnegative;
            prove at x = h { N[0] = sin(h/2)/sin(h); }
            prove symmetric;
        }",
    );
    let [a, b, c, d, e, f, rest @ ..] = &found[..] else { panic!("{found:?}") };
    assert_eq!([a, c, e], ["="; 3], "{found:?}");
    assert_eq!(rest, ["="; 3], "{found:?}");
    // Of sin(x) cos(x - 2h) the second derivative is less by sin(2h); h = 2 arctan(7/24) there.
    assert!(b.starts_with("354144/390625 at"), "{b}");
    assert_eq!(d, "-1 at ", "{d}");
    assert!(f.starts_with("150060625/79328256 at"), "{f}");
}

/// Each span takes the place of another one, in whose angle it is written.
#[test]
fn spans_with_angles_are_reversed() {
    let found = verdicts(
        "family Exponentials {
            shape 0 < c;
            domain 0 <= t <= c, c <= t <= 3*c, 3*c <= t <= 4*c;
            b[0] = t*exp(t) | exp(c)*t*(4*c - t)/(3*c) | (4*c - t)*exp(4*c - t);
            b[1] = b[0] | b[0] | b[0];
            prove symmetric;
        }
        family Quarters {
            domain -pi/2 <= t <= 0, 0 <= t <= pi/2;
            b[0] = cos(t) | cos(t)^2;
            b[1] = cos(t)^2 | cos(t);
            prove symmetric;
        }
        family Odd {
            domain -pi/2 <= t <= 0, 0 <= t <= pi/2;
            b[0] = sin(t) | sin(t);
            refute symmetric;
        }",
    );
    assert_eq!(found[..2], ["="; 2]);
    // 2 sin t.
    assert_eq!(found[2..], ["-8/5 at tan(t/2) = -1/2"]);
}

/// Values of SymPy.
#[test]
fn derivatives_of_rational_functions_with_two_weights() {
    let found = verdicts(
        "family RationalQuartic {
            shape 0 < w, 0 < v;
            domain 0 <= t <= 1;
            let s = 1 - t;
            b[0] = s^4/(s^4 + 4*w*t*s^3 + 6*v*t^2*s^2 + 4*w*t^3*s + t^4);
            prove at t = 0 { D(b[0], 2) = 32*w^2 - 12*v - 8*w; }
            refute at t = 0 { D(b[0], 2) = 32*w^2 - 12*v; }
            prove at t = 1 { D(b[0], 3) = 0; D(b[0], 4) = 24; }
        }",
    );
    assert_eq!(found, ["=", "-8 at w = 1, t = 0", "=", "="]);
}

/// Values that an `at` block fixes apply to what is assumed: it leaves a range or a value of other parameters, and gives
/// those that it determines.
#[test]
fn values_that_assumptions_leave() {
    let found = verdicts(
        "family Disk {
            shape a, c;
            assume a^2 + c^2 <= 1;
            domain 0 <= t <= 1;
            b[0] = 1 + a*t + c*(1 - t);
            prove at a = 1 { c = 0; b[0] = 1 + t; }
            prove at a = 3/5 { b[0] >= 1/5; }
            refute at a = 3/5 { c < 4/5; }
        }
        family Lens {
            shape x;
            assume 3*x - 2 - x^2 > 0;
            domain 0 <= t <= 1;
            b[0] = x*t;
            prove x > 1;
            prove b[0] < 2;
            refute b[0] <= 3/2;
        }
        family MitchellNetravali {
            shape 0 <= B <= 1, 0 <= C <= 1;
            assume B + 2*C = 1;
            domain 1 <= x <= 2;
            f[0] = ((-B - 6*C)*x^3 + (6*B + 30*C)*x^2 + (-12*B - 48*C)*x + 8*B + 24*C)/6;
            prove at B = 1/3, C = 1/3 { f[0] >= -1/27; }
            refute at C = 1/3, B = 1/3 { f[0] >= -1/30; }
            prove at C = 0 { f[0] >= 0; }
            prove at x = 1, C = 1/2 { f[0] = 0; }
        }
        family SpansOfTwoLengths {
            shape 0 < d;
            domain 0 <= x <= 1, 1 <= x <= 1 + d, 1 + d <= x <= 2 + d;
            f[0] = x | 1 | 2 + d - x;
            prove symmetric;
        }",
    );
    let refuted: Vec<&String> = found.iter().filter(|verdict| *verdict != "=").collect();
    assert_eq!(refuted, ["0 at a = 3/5, c = 4/5", "1/6 at x = 5/3, t = 1", "-1/720 at B = 1/3, x = 3/2"]);
    assert_eq!(found.len(), 12);
}

/// Negative powers and quotients in a product leave what is left in lowest terms.
#[test]
fn products_in_lowest_terms() {
    let found = verdicts(
        "family AlphaBernstein(n in 2..=4) {
            domain 0 <= x <= 1;
            shape 0 <= α <= 1;
            b[i] = (binomial(n - 2, i)*(1 - α)*x + binomial(n - 2, i - 2)*(1 - α)*(1 - x)
                + binomial(n, i)*α*x*(1 - x))*x^(i - 1)*(1 - x)^(n - i - 1) for i in 0..=n;
            prove partition_of_unity;
            prove nonnegative;
            prove at α = 1 { b = Bernstein(n); }
            refute independent;
        }
        family Powers {
            domain 0 <= t <= 1;
            b[0] = t^-1*t^2;
            b[1] = t^2/(1 + t)/t;
            b[2] = (1 - t)/(2*t - 1)*(2*t - 1)^2;
            prove b[0] = t;
            prove b[1] <= 1/2;
            refute b[2] >= -1/10;
        }",
    );
    let refuted: Vec<&String> = found.iter().filter(|verdict| *verdict != "=").collect();
    assert_eq!(refuted.len(), 4, "{found:?}");
    assert_eq!(refuted[3], "-9/10 at t = 0");
}

/// What is shown of a difference is in the variables as they are written, also where the domain ends at shape parameters.
#[test]
fn differences_are_in_the_variables_themselves() {
    let report = basis_engine::check(basis_engine::Source::text(
        "ends.basis",
        "family Ends {
            shape 0 < c;
            domain 0 <= t <= c;
            b[0] = (c - t)^2/c^2;
            b[1] = t/c;
            prove partition_of_unity;
            prove b[0] = t^2*b[1];
        }",
    ));
    let notes: Vec<&str> = report.diagnostics.iter().flat_map(|d| &d.notes).map(String::as_str).collect();
    assert_eq!(
        notes,
        [
            "the sum of the functions is `(c^2 - c*t + t^2)/c^2`",
            "at c = 1, t = 1/2 it is 3/4",
            "`b[0]` differs from `t^2*b[1]` by `(c^2 - 2*c*t + t^2 - c*t^3)/c^2`",
            "at c = 1, t = 1/2 the difference is 1/8",
        ]
    );
}

/// From order 3 on the functions of the order before were taken over with its numbers of variables: t became s[3].
#[test]
fn recursions_with_more_parameters_in_each_order() {
    let report = check(Source::text(
        "claims.basis",
        "family Raised(n in 1..=4) {
            domain 0 <= t <= 1;
            shape 0 < s[i] for i in 1..=n;
            shape 0 < r if n > 2;
            base n = 1 { b[0] = 1 - t; b[1] = t; }
            raise b[i] = (1 - t)*b[i] + t*b[i - 1];
            prove b = Bernstein(n);
            prove nonnegative;
        }
        family Weighted(n in 1..=3) {
            domain 0 <= t <= 1;
            shape 0 < s[i] for i in 1..=n;
            base n = 1 { b[0] = 1 - t; b[1] = s[1]*t; }
            raise b[i] = (1 - t)*b[i] + s[n]*t*b[i - 1];
            prove b[n] = product(s[i] for i in 1..=n)*t^n;
        }",
    ));
    for verdict in rechecked(&report) {
        assert!(matches!(verdict, Verdict::Proved(_)), "{verdict:?}");
    }
    assert_eq!(rechecked(&report).len(), 4 * 2 + 3);
}

/// The parameters of a list are given in the order of their indices, in whichever a chain names them.
#[test]
fn lists_of_parameters_are_in_order() {
    let report = check(Source::text(
        "claims.basis",
        "family Falling {
            domain 0 <= t <= 1;
            shape 0 <= γ[i] <= γ[i - 1] for i in 1..=2;
            b[0] = γ[0];
            b[1] = γ[1]*t;
            b[2] = γ[2];
        }
        theorem Values {
            curve P = Falling(3, 2, 1);
            prove P(0) == 3*P[0] + P[2];
        }",
    ));
    let verdicts = rechecked(&report);
    assert!(verdicts.len() == 1 && matches!(verdicts[0], Verdict::Proved(_)), "{:?}", report.diagnostics);
}

/// A sum over the members of a list that has none is 0.
#[test]
fn lists_without_members() {
    let found = verdicts(
        "family Shifted(n in 0..=2) {
            domain 0 <= t <= 1;
            shape 0 < λ[i] for i in 1..=n;
            b[0] = t + sum(λ);
            b[1] = product(λ) - t;
            prove nonnegative;
            prove b[0] + b[1] >= 1;
        }",
    );
    let of_a_let = verdicts(
        "family Ends(n in 0..=2) {
            domain 0 <= t <= 1;
            let y = [1, 2, 3];
            shape 0 <= a[i] <= y[i] for i in 1..=n;
            b[0] = y[0]*t + sum(a);
            prove nonnegative;
        }",
    );
    assert_eq!(of_a_let, ["="; 3]);
    assert_eq!(found[..2], ["=", "="], "{found:?}");
    assert!(found[2..].iter().all(|f| f.contains(" at ") || f == "="), "{found:?}");
}

/// The search for points among those that are assumed is counted, so that the claims after it have their work.
#[test]
fn hard_searches_leave_work_for_others() {
    let found = verdicts(
        "family Hard {
            domain 0 <= t <= a;
            shape 0 < a <= 2*pi/3;
            f[0] = 1;
            prove 3/2*cos(a - t) - 3*sin(a - t)*sin(a)*cos(a - t) + 2*cos(t)^2*sin(a - t) + cos(a)^2*cos(a/2) >= -233/2500;
        }
        family Easy { domain 0 <= t <= 1; f[0] = t*(1 - t); prove f[0] = t - t^2; prove nonnegative; prove f[0] <= 1; }",
    );
    assert_eq!(found[1..], ["="; 3]);
}
