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
fn interior_zeros() {
    for p in
        ["(t - 1/3)^2", "(t - λ)^2", "t^2 - t*λ + λ^2", "(3*t - 1)^2 + (3*λ - 1)^2", "t^4 - t^2*λ + 1/4*λ^2"]
    {
        println!("{p}: {}", claim(&format!("{p} >= 0"), UNIT));
        println!("{p} - 10^-6: {}", claim(&format!("{p} >= 0.000001"), UNIT));
        println!("{p} > 0: {}", claim(&format!("{p} > 0"), UNIT));
        println!("{p} > -10^-6: {}", claim(&format!("{p} > 0 - 0.000001"), UNIT));
    }
}

#[test]
fn irrational() {
    println!("{}", claim("(t^2 - 2)^2 > 0", "0<=t<=2"));
    println!("{}", claim("(t^2 - 2)^2 + (λ^2 - 3)^2 > 0", "0<=t<=2, 0<=λ<=2"));
    println!("{}", claim("(t^2 + λ^2 - 1)^2 + (t-λ)^2 > 0", "0<=t<=2, 0<=λ<=2"));
    println!("{}", claim("(t^2 + λ^2 - 1)^2 + (t-λ)^2 >= 0", "0<=t<=2, 0<=λ<=2"));
    println!("{}", claim("(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2> 0", "0<=t<=2, 0<=λ<=2, 0<=μ<=3"));
    println!("{}", claim("(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2>= 0", "0<=t<=2, 0<=λ<=2, 0<=μ<=3"));
    println!("{}", claim("(t^2 - 2)^2 + (λ^2 - 3)^2 + (t*λ-μ)^2 + 1/1000 > 0", "0<=t<=2, 0<=λ<=2, 0<=μ<=3"));
    println!("{}", claim("1 + 64*t^4*λ^2 + 64*t^2*λ^4 - 48*t^2*λ^2 >= 0", "0<=t<=1, 0<=λ<=1"));
    println!("{}", claim("1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 >= 0", ""));
    println!("{}", claim("1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 > 0", ""));
    println!("{}", claim("1/1000 + 1 + t^4*λ^2 + t^2*λ^4 - 3*t^2*λ^2 > 0", ""));
    println!("{}", claim("(t*λ-1)^2 + t^2 > 0", ""));
    println!("{}", claim("(t*λ-1)^2 + t^2 > 1/1000", ""));
    println!("{}", claim("λ > 0", "0<λ<=1"));
    println!("{}", claim("λ > 0", "0<=λ<=1"));
    println!("{}", claim("f*(1-t) + t*f^2 > 0", "0<f, 0<=t<=1"));
    println!("{}", claim("f*(1-t) + t*f^2 - 3*f*t> 0", "0<f, 0<=t<=1"));
    println!("{}", claim("t*λ > 0", "0<t<=1, 0<=λ<=1"));
    println!("{}", claim("t+λ > 0", "0<t<=1, 0<=λ<=1"));
    println!("{}", claim("t^2 -t*λ+ λ^2 > 0", "0<t<=1, 0<=λ<=1"));
    println!("{}", claim("t^2 -t*λ+ λ^2 > 0", "0<t<=1, 0<=λ<=1, 0<=μ<=1"));
    println!("{}", claim("t^2 -2*t*λ+ λ^2 > 0", "0<t<=1, 1<λ<=2"));
    println!("{}", claim("t^2 -2*t*λ+ λ^2 > 0", "0<t<=1, 1<=λ<=2"));
    println!("{}", claim("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ >= 0", "0<=t<=1, 0<=λ<=1, 0<=μ<=1"));
    println!("{}", claim("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ > 0", "0<=t<=1, 0<=λ<=1, 0<=μ<=1"));
    println!("{}", claim("t^2 + λ^2 + μ^2 -t*λ - t*μ - λ*μ > 0", "0<=t<1, 0<=λ<=1, 1<=μ<=2"));
}
