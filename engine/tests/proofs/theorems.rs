//! Claims of theorems have exact verdicts, and counterexamples name scalars and control points.

use crate::support::recheck;
use basis_engine::{Report, Source, Verdict, check};

const QUADRATIC: &str = "family Quadratic {
    domain 0 <= t <= 1;
    shape -2 <= λ <= 1;
    b[0] = (1 - λ*t) * (1 - t)^2;
    b[1] = (2 + λ) * (1 - t) * t;
    b[2] = (1 - λ + λ*t) * t^2;
}
";

fn checked(theorem: &str) -> Report {
    check(Source::text("theorem.basis", &format!("{QUADRATIC}{theorem}")))
}

/// The verdicts of a theorem without errors, `=` for proved, else the value of the counterexample and its place. All of
/// them check out.
fn verdicts(theorem: &str) -> Vec<String> {
    let report = checked(&format!("theorem T {{ {theorem} }}"));
    let errors: Vec<&str> =
        report.diagnostics.iter().map(|d| d.message.as_str()).filter(|m| !m.contains("the claim")).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let shown = |verdict: &Verdict| match verdict {
        Verdict::Proved(_) => String::from("="),
        Verdict::Refuted(witness) => format!("{} at {}", witness.value, witness.point()),
        Verdict::Undecided(_) => String::from("?"),
    };
    let checked = report.items.last().expect("the theorem");
    for (claim, verdict) in &checked.claims {
        assert_eq!(recheck(&checked.subject, claim, verdict), Ok(()), "{}", claim.text);
    }
    checked.claims.iter().map(|(_, verdict)| shown(verdict)).collect()
}

#[test]
fn identities_hold_for_all_points_in_every_dimension() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        prove P(0) == P[0];
        prove D(P, 2)(0) == 2*λ*(2*P[0] - P[1] - P[2]) + 2*(P[0] - 2*P[1] + P[2]);
        prove cross(P[0], P[1]) == -cross(P[1], P[0]);
        prove cross(P(t), P(t)) == 0;
        prove dot(P[0], P[1]) == dot(P[1], P[0]);
        prove dot(P[0] - P[1], P[0] + P[1]) == dot(P[0], P[0]) - dot(P[1], P[1]);
        prove D(P(t), t) == D(P)(t);
        prove D(P, λ)(t) == D(P(t), λ);",
    );
    assert_eq!(found, ["="; 8]);
}

#[test]
fn a_false_identity_has_a_net_and_a_value() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        prove D(P)(0) == (λ + 1)*(P[1] - P[0]);
        prove cross(P[0], P[1]) == cross(P[1], P[0]);
        prove dot(P[0], P[1]) == dot(P[2], P[2]);",
    );
    // Neither λ nor P[2] matters.
    assert_eq!(found[0], "1 at P[0] = (0, 0), P[1] = (1, 1)");
    // The regular net has its first point at the origin, where the outer product vanishes: another one is taken.
    assert_ne!(found[1], "=");
    assert!(!found[1].starts_with("0 at"), "{}", found[1]);
    assert_eq!(found[2], "-20 at P[0] = (0, 0), P[1] = (1, 1), P[2] = (2, 4)");
}

#[test]
fn parallel_needs_a_positive_factor_wherever_a_side_is_not_zero() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        scalar 0 < δ;
        prove δ*P[0] parallel P[0];
        prove -δ*P[0] parallel P[0];
        prove P[0] parallel P[1];
        prove 0*P[0] parallel 0*P[1];
        prove 0*P[0] parallel P[1];
        prove D(P)(0) parallel P[1] - P[0];
        prove cross(δ*P[0], P[1]) parallel cross(P[0], P[1]);
        prove cross(P[1], P[0]) parallel cross(P[0], P[1]);",
    );
    let proved: Vec<bool> = found.iter().map(|v| v == "=").collect();
    assert_eq!(proved, [true, false, false, true, false, false, true, false], "{found:?}");
    // At λ = -2 the tangent vector is zero.
    assert!(found[5].contains("λ = -2"), "{}", found[5]);
}

/// Where both sides are zero the claim holds, where one is, it fails; elsewhere the sign of the factor decides.
#[test]
fn directions_where_a_factor_vanishes() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        scalar c; scalar 0 <= k; scalar 0 <= y; scalar 0 <= x <= 2;
        prove k*P[0] parallel k^2*P[0];
        prove (λ + 2)*P[0] parallel (λ + 2)^2*P[0];
        prove (λ + 2)^2*P[0] parallel (λ + 2)*P[0];
        prove c*P[0] parallel c^3*P[0];
        prove c*(1 + y)*P[0] parallel c*P[0];
        prove (x^2 - 2)^2*P[0] parallel (x^2 - 2)^4*P[0];
        prove (k^2 + y^2)*(k*P[0] + y*P[1]) parallel k*P[0] + y*P[1];
        prove k*y*P[0] parallel k^2*y*P[0];",
    );
    assert_eq!(found, ["="; 8]);
    assert_eq!(verdicts("scalar c; prove (c, c^2) parallel (c^3, c^4);"), ["="]);
    let found = verdicts(
        "curve P = Quadratic(λ) [(1, 0), (0, 1), (2, 3)];
        scalar c; scalar 0 <= k <= 1; scalar 0 <= x <= 2; scalar 0 <= y <= 1;
        prove c*P[0] parallel -c*P[0];
        prove c*P[0] parallel c^2*P[0];
        prove (x^2 - 2)^2*P[0] parallel P[0];
        prove (λ + 2)*P[0] parallel P[0];
        prove P[0] parallel (λ + 2)*P[0];
        prove k*P[0] parallel y*P[0];
        prove c*P[0] parallel 0*P[0];
        prove (x^2 - 2)*P[0] parallel (x^2 - 2)^2*P[0];",
    );
    let expected = [
        "-1 at c = 1",
        "-1 at c = -1",
        "0 at x = sqrt(2)",
        "0 at λ = -2",
        "0 at λ = -2",
        "0 at y = 0",
        "0 at c = 1",
        "-8 at x = 0",
    ];
    for (found, expected) in found.iter().zip(expected) {
        let (value, place) = expected.split_once(" at ").expect("both are given");
        assert!(found.starts_with(&format!("{value} at ")) && found.contains(place), "{found}, {expected}");
    }
    assert_eq!(found.len(), expected.len());
}

/// Without coordinates the dot products of a counterexample are those of its points.
#[test]
fn directions_where_both_sides_vanish_together() {
    // The factor is zero at x = √2 alone, and only for points with which the other side is zero, too.
    let plane = "dimension 2; curve P = Bernstein(1); scalar x; let w = (P[0][0] - 5)*P[1];";
    let claim = "prove ((x^2 - 2)^2 + (P[0][0] - 5)^2)*w parallel w;";
    assert_ne!(verdicts(&format!("{plane} {claim}"))[0].chars().next(), Some('0'));
    let anywhere = "curve P = Bernstein(1); scalar x;";
    let claim = "prove ((x^2 - 2)^2 + dot(P[0], P[0])^2)*P[0] parallel P[0];";
    assert_ne!(verdicts(&format!("{anywhere} {claim}"))[0].chars().next(), Some('0'));
}

/// Also where a scalar is irrational; points that do not matter are left out, those that depend on it follow from the
/// others.
#[test]
fn irrational_counterexamples_name_the_control_points() {
    let found = verdicts(
        "curve P = Quadratic(0); curve Q = Quadratic(0); scalar 0 <= k <= 2;
        let Q[0] = k*P[0];
        prove (k^2 - 2)^2*P[0] parallel P[0];
        prove (k^2 - 2)^2*(1 + dot(P[0], P[1])^2) > 0;",
    );
    let root = "0 at k = sqrt(2)";
    for found in found {
        let named = |point: &str| found.contains(&format!("{point} = ("));
        assert!(found.starts_with(root) && named("P[0]"), "{found}");
        assert!(!named("P[2]") && !named("Q[0]"), "{found}");
    }
    let found = verdicts(
        "dimension 2; curve P = Bernstein(1); scalar 0 <= k <= 2;
        prove (k^2 - 2)^2*P[0] parallel P[0];
        prove (k^2 - 2)^2 + P[0][0]^2 > 0;",
    );
    assert!(found.iter().all(|f| f.starts_with(root) && f.contains("P[0] = (")), "{found:?}");
}

#[test]
fn outer_products_have_the_same_axes_on_both_sides() {
    let curves = "dimension 4; scalar s; scalar r; curve A = Bernstein(1);
        curve P = Bernstein(1) [(1, 0, 0, 0), (0, s - 1, 1, 0)]; curve B = Bernstein(1) [(1, 0, 0, 0), (0, 0, 1, r - 1)];";
    let [verdict] = &verdicts(&format!("{curves} prove cross(P[0], P[1]) parallel cross(B[0], B[1]);"))[..]
    else {
        panic!("one claim");
    };
    // At s = r = 1 the sides agree.
    assert!(verdict != "=" && verdict != "?" && !verdict.ends_with("at s = 1, r = 1"), "{verdict}");
}

/// In coordinates along axes that belong to the points, one of which may be the origin.
#[test]
fn dot_products_that_are_multiplied() {
    let found = verdicts(
        "curve P = Bernstein(3); scalar 0 < k;
        prove dot(P[0], P[0])*dot(P[1], P[1]) >= dot(P[0], P[1])^2;
        prove dot(P[0], P[0])*dot(P[1], P[1]) > dot(P[0], P[1])^2;
        prove dot(P[0], P[0])*dot(P[1], P[1]) >= k/(k + 1)*dot(P[0], P[1])^2;
        prove dot(P[0], P[0])*dot(P[1], P[1]) >= 101/100*dot(P[0], P[1])^2;
        prove dot(D(P)(0), D(P)(0))*dot(D(P)(1), D(P)(1)) >= dot(D(P)(0), D(P)(1))^2;
        prove dot(P[1] - P[0], P[1] - P[0])*dot(P[2] - P[0], P[2] - P[0]) >= dot(P[1] - P[0], P[2])^2;
        prove dot(P[0], P[0])*dot(P[1], P[1])*dot(P[2], P[2]) + 2*dot(P[0], P[1])*dot(P[1], P[2])*dot(P[0], P[2])
            >= dot(P[0], P[1])^2*dot(P[2], P[2]) + dot(P[0], P[2])^2*dot(P[1], P[1]) + dot(P[1], P[2])^2*dot(P[0], P[0]);",
    );
    for k in [0, 2, 4, 6] {
        assert_eq!(found[k], "=", "{k}");
    }
    for k in [1, 3, 5] {
        assert!(found[k].contains(" at ") && found[k].contains("P[0] = ("), "{k}: {}", found[k]);
    }
}

#[test]
fn directions_with_dot_products() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        prove (1 + dot(P[0], P[1])^2)*P[1] parallel P[1];
        prove dot(P[0], P[0])*P[1] parallel dot(P[0], P[0])^2*P[1];
        prove dot(P[0], P[0]) >= 0;
        prove dot(P[0], P[0])*P[0] parallel P[0];
        prove dot(P[0], P[1])*P[1] parallel P[1];
        prove dot(P[0] - P[1], P[0] - P[1])*(P[0] - P[1]) parallel P[0] - P[1];
        prove dot(P[0] - P[1], P[0] - P[1])*P[0] parallel P[0];",
    );
    assert_eq!(found[..4], ["="; 4]);
    assert!(found[4].starts_with("-2 at") || found[4].starts_with("0 at"), "{}", found[4]);
    assert_eq!(found[5], "=");
    // With P0 = P1 one side is zero.
    assert_ne!(found[6], "=");
    let found = verdicts(
        "dimension 2;
        curve P = Quadratic(λ);
        prove dot(P[0] - P[1], P[0] - P[1]) >= 0;
        prove dot(P[0], P[0])*P[0] parallel P[0];
        prove P[0][0]*P[1] parallel P[0][0]^3*P[1];
        prove P[0][0]*P[1] parallel P[1];",
    );
    assert_eq!(found[..3], ["="; 3]);
    assert!(found[3].starts_with("0 at") || found[3].starts_with('-'), "{}", found[3]);
}

/// Without coordinates a sum of dot products is nonnegative if its matrix is positive semidefinite, and only then.
#[test]
fn sums_of_dot_products_are_decided_in_every_dimension() {
    let found = verdicts(
        "curve P = Quadratic(0);
        prove dot(P[0] - P[1], P[0] - P[1]) >= 0;
        prove dot(P[0] - 2*P[1] + P[2], P[0] - 2*P[1] + P[2]) + 1 > 0;
        prove 2*dot(P[0], P[1]) <= dot(P[0], P[0]) + dot(P[1], P[1]);
        prove dot(P[0] + P[1] + P[2], P[0] + P[1] + P[2]) <= 3*(dot(P[0], P[0]) + dot(P[1], P[1]) + dot(P[2], P[2]));
        prove dot(D(P)(1/2), D(P)(1/2)) >= 0;
        prove dot(P[0] - P[1], P[0] - P[1]) > 0;
        prove dot(P[0], P[1]) >= 0;
        prove dot(P[0], P[0]) + dot(P[1], P[2]) + 5 >= 0;
        prove dot(P[0], P[0]) + 3*dot(P[0], P[1]) + dot(P[1], P[1]) >= 0;
        prove dot(P[0], P[0]) >= 1;",
    );
    assert_eq!(found[..5], ["="; 5]);
    assert!(found[5].starts_with("0 at"), "{}", found[5]);
    assert!(found[6..].iter().all(|f| f.starts_with('-')), "{found:?}");
    assert_eq!(found.len(), 10);
}

/// Linear in dot products, an inequality says that a matrix is positive semidefinite: it is decided for points of any
/// space.
#[test]
fn inequalities_between_dot_products() {
    let claims = "
        prove dot(P[0] + P[2], P[0] + P[2]) >= 0;
        prove dot(D(P)(t), D(P)(t)) >= 0;
        prove dot(k*P(t) - P[1], k*P(t) - P[1]) > -1;
        prove dot(P(t), P(t)) + dot(D(P)(1/2), D(P)(1/2)) >= 2*dot(P(t), D(P)(1/2));
        prove dot(P[0], P[0]) + dot(P[1], P[1]) >= 2*m*dot(P[0], P[1]);
        prove dot(P[0] - P[1], P[0] - P[1]) <= 2*dot(P[0], P[0]) + 2*dot(P[1], P[1]);
        prove dot(D(P)(t), D(P)(t)) > 0;
        prove dot(P[0], P[0]) + dot(P[1], P[1]) >= 2*(m + 1/100)*dot(P[0], P[1]);
        prove dot(P[0], P[1]) <= dot(P[0], P[0]) + 3;
        prove dot(P[0], P[1]) >= 0;
        prove dot(P[0], P[0]) + (k^2 - 2)^2 > 0;";
    for dimension in ["", "dimension 2;", "dimension 3;"] {
        let curve = "curve P = Quadratic(λ); scalar k; scalar 0 <= m <= 1;";
        let found = verdicts(&format!("{dimension} {curve} {claims}"));
        assert_eq!(found[..6], ["="; 6], "{dimension}");
        let zero = if dimension == "dimension 3;" { "(0, 0, 0)" } else { "(0, 0)" };
        assert!(
            found[6].starts_with("0 at") && found[6].ends_with(&format!("P[2] = {zero}")),
            "{}",
            found[6]
        );
        // At m = 1 the matrix is [1, -1.01; -1.01, 1].
        assert!(found[7].starts_with("-201/10000 at m = 1, P[0] = (101/100, 0"), "{}", found[7]);
        assert!(!found[8].starts_with('-'), "{}", found[8]);
        assert!(found[9].starts_with('-'), "{}", found[9]);
        assert!(found[10].starts_with("0 at") && found[10].contains("k = -sqrt(2)"), "{}", found[10]);
    }
}

/// A factor may vanish where the simplest values of the other scalars make both sides zero.
#[test]
fn a_factor_that_vanishes_only_where_other_scalars_are_not_simple() {
    let found = verdicts(
        "curve P = Quadratic(λ); scalar k;
        prove k*P[0] parallel k*t*P[0];
        prove (t + λ)^2*λ*P[0] parallel λ*P[0];
        prove (t^2 - 1/2)^2*(k - λ)*P[0] parallel (k - λ)*P[0];",
    );
    for verdict in &found {
        assert!(verdict.starts_with("0 at"), "{verdict}");
    }
    assert!(found[0].contains("t = 0") && found[2].contains("t = 1/2*sqrt(2)"), "{found:?}");
}

#[test]
fn assumptions_narrow_the_ranges() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        assume λ > -2;
        prove D(P)(0) parallel P[1] - P[0];
        prove λ + 2 > 0;
        prove λ + 2 > 1;",
    );
    assert_eq!(&found[..2], ["=", "="]);
    assert!(found[2].contains("λ = -"), "{}", found[2]);
}

#[test]
fn a_range_of_one_number_is_that_number() {
    let found = verdicts(
        "curve P = Quadratic(λ);
        assume λ >= 1;
        prove λ == 1;
        prove D(P)(0) == 3*(P[1] - P[0]);
        prove D(P)(0) parallel P[1] - P[0];
        prove D(P)(0) == 2*(P[1] - P[0]);",
    );
    assert_eq!(&found[..3], ["=", "=", "="]);
    assert_eq!(found[3], "1 at λ = 1, P[0] = (0, 0), P[1] = (1, 1)");
}

#[test]
fn numbers_and_coordinates() {
    let found = verdicts(
        "curve P = Quadratic(0.57) [(2.58, 6.27), (0.11, 4.45), (2.05, 2.81)];
        curve Q = Quadratic(0.52) [(2.05, 2.81), (3.75, 2.13), (2.01, 0.02)];
        prove P(1) == Q(0);
        prove cross(D(P)(1), D(Q)(0)) == 0;
        prove D(P)(1)[0]*D(Q)(0)[1] - D(P)(1)[1]*D(Q)(0)[0] == -cross(D(P)(1), D(Q)(0));
        prove P(1/2)[1] >= 4;
        prove P(1/2)[1] >= 5;",
    );
    // 2.57 (1.94, -1.64) × 2.52 (1.7, -0.68)
    assert_eq!(found[1], "7431669/781250 at ");
    assert_eq!(found[2].split(' ').next(), Some("7431669/390625"));
    assert_eq!([&found[0], &found[3]], ["=", "="]);
    assert!(found[4].ends_with(" at "), "{}", found[4]);
}

#[test]
fn space_has_a_vector_product() {
    let found = verdicts(
        "dimension 3;
        curve P = Quadratic(λ);
        prove dot(cross(P[0], P[1]), P[0]) == 0;
        prove cross((1, 0, 0), (0, 1, 0)) == (0, 0, 1);
        prove cross(P[0], P[1]) == cross(P[1], P[0]);",
    );
    assert_eq!(&found[..2], ["=", "="]);
    assert_ne!(found[2], "=");
}

#[test]
fn rows_of_a_net_have_shape_values_of_their_own() {
    let found = verdicts(
        "surface S = Quadratic(λ)(u) * Quadratic(γ[i])(v);
        prove D(S, v)(0, 0) == (2 + γ[0])*(S[0,1] - S[0,0]);
        prove D(S, v)(1, 0) == (2 + γ[2])*(S[2,1] - S[2,0]);
        prove D(S, v)(1, 0) == (2 + γ[0])*(S[2,1] - S[2,0]);
        prove D(S, γ[1])(0, v) == 0;",
    );
    assert_eq!(found[0], "=");
    assert_eq!(found[1], "=");
    assert!(found[2].contains("γ[2]"), "{}", found[2]);
    assert_eq!(found[3], "=");
}

#[test]
fn barycentric_coordinates_sum_to_one() {
    let report = check(Source::text(
        "triangle.basis",
        "theorem T {
            patch T = TriangularBernstein(2);
            prove T(1, 0, 0) == T[2,0,0];
            prove T(u, v, w) == T(u, v, 1 - u - v);
            prove D(T, u)(0, 0, 1) == 2*(T[1,0,1] - T[0,0,2]);
        }",
    ));
    assert!(report.diagnostics.is_empty());
    assert_eq!(report.items.last().map_or(0, |item| item.claims.len()), 3);
}

#[test]
fn a_join_determines_points_of_a_surface() {
    let report = checked(
        "join G1 {
            surface S = Quadratic(λ)(u) * Quadratic(γ[i])(v);
            surface T = Quadratic(λ)(u) * Quadratic(μ[i])(v);
            scalar 0 < f;
            assume μ[i] > -2 for i in 0..=2;
            let T[i,0] = S[i,2] for i in 0..=2;
            let T[i,1] = S[i,2] + (2 + γ[i])/(f*(2 + μ[i])) * (S[i,2] - S[i,1]) for i in 0..=2;
            prove T(u, 0) == S(u, 1);
            prove D(S, v)(u, 1) == f * D(T, v)(u, 0);
            prove cross(D(T, u)(u, 0), D(T, v)(u, 0)) parallel cross(D(S, u)(u, 1), D(S, v)(u, 1));
        }",
    );
    let messages: Vec<String> = report.diagnostics.iter().map(basis_engine::Diagnostic::text).collect();
    assert!(messages.is_empty(), "{messages:?}");
}
