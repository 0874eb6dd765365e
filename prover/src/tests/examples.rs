//! The claims that the toolchain must decide.

use super::claim;

const UNIT: &str = "0<=t<=1, 0<=λ<=1";

#[track_caller]
fn proved(text: &str, ranges: &str, method: &str) {
    assert_eq!(claim(text, ranges), format!("proved: {method}"), "{text} on {ranges}");
}

#[track_caller]
fn refuted(text: &str, ranges: &str, witness: &str) {
    assert_eq!(claim(text, ranges), format!("refuted: {witness}"), "{text} on {ranges}");
}

#[test]
fn quartic_family_is_nonnegative_exactly_on_its_range() {
    let family =
        ["(1 - λ*t)*(1 - t)^3", "(3 + λ - λ*t)*t*(1 - t)^2", "(3 + λ*t)*t^2*(1 - t)", "(1 - λ + λ*t)*t^3"];
    for b in family {
        proved(&format!("{b} >= 0"), "0<=t<=1, -3<=λ<=1", "Bernstein coefficients");
    }
    let [b0, b1, b2, b3] = family.map(|b| format!("{b} >= 0"));
    refuted(&b1, "0<=t<=1, -4<=λ<=1", "t = 1/5, λ = -4: -16/625");
    refuted(&b2, "0<=t<=1, -4<=λ<=1", "t = 4/5, λ = -4: -16/625");
    refuted(&b0, "0<=t<=1, -3<=λ<=11/10", "t = 11/12, λ = 11/10: -1/207360");
    refuted(&b3, "0<=t<=1, -3<=λ<=11/10", "t = 1/12, λ = 11/10: -1/207360");
}

#[test]
fn quadratic_family_is_nonnegative_exactly_on_its_range() {
    let family = ["(1 - λ*t)*(1 - t)^2", "(2 + λ)*(1 - t)*t", "(1 - λ + λ*t)*t^2"];
    for b in family {
        proved(&format!("{b} >= 0"), "0<=t<=1, -2<=λ<=1", "Bernstein coefficients");
    }
    let [b0, b1, b2] = family.map(|b| format!("{b} >= 0"));
    refuted(&b1, "0<=t<=1, -21/10<=λ<=1", "t = 1/2, λ = -21/10: -1/40");
    refuted(&b0, "0<=t<=1, -2<=λ<=11/10", "t = 11/12, λ = 11/10: -1/17280");
    refuted(&b2, "0<=t<=1, -2<=λ<=11/10", "t = 1/12, λ = 11/10: -1/17280");
}

#[test]
fn sums_of_squares() {
    let squares = |text| proved(text, "", "a sum of squares");
    squares("t^2 + λ^2 + μ^2 - t*λ - λ*μ - μ*t >= 0");
    squares("(t*μ - λ*w)^2 + (t*w - λ*μ)^2 + (μ*λ - w*t)^2 >= 0");
    // The matrix is one of many, and singular.
    squares("t^4 + λ^4 + μ^4 - t*λ*μ*(t + λ + μ) >= 0");
    squares("t^4 + λ^4 + μ^4 + w^4 - 4*t*λ*μ*w >= 0");
    squares("t^2 - 2*t*λ + 2*λ^2 - λ*μ + μ^2 + 1/10 > 0");
    refuted("t^4 + λ^4 + μ^4 + w^4 - 5*t*λ*μ*w >= 0", "", "t = 1, λ = 1, μ = 1, w = 1: -1");
    // Motzkin's polynomial is no such sum.
    proved("t^4*λ^2 + t^2*λ^4 + 1 - 3*t^2*λ^2 >= 0", "", "cylindrical decomposition");
}

/// Zeros on faces, edges and corners of the box, and polynomials that vanish identically on a face.
#[test]
fn zeros_on_the_boundary() {
    let closed = "0<=t<=1, 0<=λ<=1, 0<=μ<=1";
    // On a face, which may belong to the box or not.
    proved("t*(1 - λ)*(1 + μ) >= 0", closed, "Bernstein coefficients");
    refuted("t*(1 - λ)*(1 + μ) > 0", closed, "t = 0, λ = 0, μ = 0: 0");
    proved("t*(1 - λ)*(1 + μ) > 0", "0<t<=1, 0<=λ<1, 0<=μ<=1", "Bernstein coefficients");
    refuted("t*(1 - λ)*(1 + μ) > 0", "0<t<=1, 0<=λ<=1, 0<=μ<=1", "t = 1, λ = 1, μ = 0: 0");
    // On an edge, with another zero inside of a face.
    proved("t*(μ - 1/3)^2 + λ >= 0", closed, "factors");
    refuted("t*(μ - 1/3)^2 + λ > 0", closed, "t = 0, λ = 0, μ = 0: 0");
    proved("t*(μ - 1/3)^2 + λ > 0", "0<=t<=1, 0<λ<=1, 0<=μ<=1", "factors");
    refuted("t*(μ - 1/3)^2 + λ > 1/1000000", closed, "t = 0, λ = 0, μ = 0: -1/1000000");
    // In a corner; of degree 1 in each variable.
    proved("1 - t*λ*μ >= 0", closed, "Bernstein coefficients");
    refuted("1 - t*λ*μ > 0", closed, "t = 1, λ = 1, μ = 1: 0");
    proved("1 - t*λ*μ > 0", "0<=t<=1, 0<=λ<=1, 0<=μ<1", "Bernstein coefficients");
    // Identically zero on two faces, and on a surface inside.
    proved("t*(1 - μ)*(λ - t)^2 >= 0", closed, "factors");
    refuted("t*(1 - μ)*((λ - t)^2 - 1/1000000) >= 0", closed, "t = 1, λ = 1, μ = 0: -1/1000000");
    refuted("t*(1 - μ)*(λ - t)^2 > 0", "0<t<=1, 0<=λ<=1, 0<=μ<1", "t = 1, λ = 1, μ = 0: 0");
}

/// Where subdivision alone never ends.
#[test]
fn interior_zeros() {
    proved("(t - 1/3)^2 >= 0", UNIT, "factors");
    refuted("(t - 1/3)^2 >= 0.000001", UNIT, "t = 1/3, λ = 1/2: -1/1000000");
    refuted("(t - 1/3)^2 > 0", UNIT, "t = 1/3, λ = 1/2: 0");
    proved("(t - 1/3)^2 > 0 - 0.000001", UNIT, "Descartes");
    proved("(t - λ)^2 >= 0", UNIT, "factors");
    refuted("(t - λ)^2 >= 0.000001", UNIT, "t = 0, λ = 0: -1/1000000");
    refuted("(t - λ)^2 > 0", UNIT, "t = 0, λ = 0: 0");
    proved("(t - λ)^2 > 0 - 0.000001", UNIT, "cylindrical decomposition");
    proved("t^2 - t*λ + λ^2 >= 0", UNIT, "cylindrical decomposition");
    refuted("t^2 - t*λ + λ^2 >= 0.000001", UNIT, "t = 0, λ = 0: -1/1000000");
    refuted("t^2 - t*λ + λ^2 > 0", UNIT, "t = 0, λ = 0: 0");
    proved("t^2 - t*λ + λ^2 > 0 - 0.000001", UNIT, "subdivision");
    proved("(3*t - 1)^2 + (3*λ - 1)^2 >= 0", UNIT, "cylindrical decomposition");
    refuted("(3*t - 1)^2 + (3*λ - 1)^2 >= 0.000001", UNIT, "t = 1/3, λ = 1/3: -1/1000000");
    refuted("(3*t - 1)^2 + (3*λ - 1)^2 > 0", UNIT, "t = 1/3, λ = 1/3: 0");
    proved("(3*t - 1)^2 + (3*λ - 1)^2 > 0 - 0.000001", UNIT, "cylindrical decomposition");
    proved("t^4 - t^2*λ + 1/4*λ^2 >= 0", UNIT, "factors");
    refuted("t^4 - t^2*λ + 1/4*λ^2 >= 0.000001", UNIT, "t = 0, λ = 0: -1/1000000");
    refuted("t^4 - t^2*λ + 1/4*λ^2 > 0", UNIT, "t = 0, λ = 0: 0");
    proved("t^4 - t^2*λ + 1/4*λ^2 > 0 - 0.000001", UNIT, "cylindrical decomposition");
}

#[test]
fn irrational_zeros_and_open_or_infinite_ranges() {
    refuted("(t^2 - 2)^2 > 0", "0<=t<=2", "t = sqrt(2): 0");
    refuted("(t^2 - 2)^2 + (λ^2 - 3)^2 > 0", "0<=t<=2, 0<=λ<=2", "t = sqrt(2), λ = sqrt(3): 0");
    refuted("(t^2 + λ^2 - 1)^2 + (t-λ)^2 > 0", "0<=t<=2, 0<=λ<=2", "t = 1/2*sqrt(2), λ = 1/2*sqrt(2): 0");
    proved("(t^2 + λ^2 - 1)^2 + (t-λ)^2 >= 0", "0<=t<=2, 0<=λ<=2", "cylindrical decomposition");
    refuted(
        "(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2> 0",
        "0<=t<=2, 0<=λ<=2, 0<=μ<=3",
        "t = sqrt(2), λ = sqrt(3), μ = sqrt(6): 0",
    );
    proved(
        "(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2>= 0",
        "0<=t<=2, 0<=λ<=2, 0<=μ<=3",
        "cylindrical decomposition",
    );
    proved("(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2 + 1/1000 > 0", "0<=t<=2, 0<=λ<=2, 0<=μ<=3", "subdivision");
    proved("1 + 64*t^4*λ^2 + 64*t^2*λ^4 - 48*t^2*λ^2 >= 0", "0<=t<=1, 0<=λ<=1", "cylindrical decomposition");
    proved("1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 >= 0", "", "cylindrical decomposition");
    refuted("1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 > 0", "", "t = 1, λ = 1: 0");
    proved("1/1000 + 1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 > 0", "", "cylindrical decomposition");
    proved("(t*λ-1)^2 + t^2 > 0", "", "cylindrical decomposition");
    refuted("(t*λ-1)^2 + t^2 > 1/1000", "", "t = -1/33, λ = -33: -89/1089000");
    proved("λ > 0", "0<λ<=1", "Bernstein coefficients");
    refuted("λ > 0", "0<=λ<=1", "λ = 0: 0");
    proved("f*(1-t) + t*f^2 > 0", "0<f, 0<=t<=1", "Bernstein coefficients");
    refuted("f*(1-t) + t*f^2 - 3*f*t> 0", "0<f, 0<=t<=1", "t = 1, f = 1: -2");
    refuted("t*λ > 0", "0<t<=1, 0<=λ<=1", "t = 1, λ = 0: 0");
    proved("t+λ > 0", "0<t<=1, 0<=λ<=1", "Bernstein coefficients");
    proved("t^2 -t*λ+ λ^2 > 0", "0<t<=1, 0<=λ<=1", "cylindrical decomposition");
    proved("t^2 -t*λ+ λ^2 > 0", "0<t<=1, 0<=λ<=1, 0<=μ<=1", "cylindrical decomposition");
    proved("t^2 -2*t*λ+ λ^2 > 0", "0<t<=1, 1<λ<=2", "Bernstein coefficients");
    refuted("t^2 -2*t*λ+ λ^2 > 0", "0<t<=1, 1<=λ<=2", "t = 1, λ = 1: 0");
    proved("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ >= 0", "0<=t<=1, 0<=λ<=1, 0<=μ<=1", "cylindrical decomposition");
    refuted("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ > 0", "0<=t<=1, 0<=λ<=1, 0<=μ<=1", "t = 0, λ = 0, μ = 0: 0");
    proved("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ > 0", "0<=t<1, 0<=λ<=1, 1<=μ<=2", "cylindrical decomposition");
}
