//! What families assume of their shape values: claims that hold only there, with false ones beside them.

use crate::verdicts::verdicts;

/// As many claims as are declared to be false have counterexamples, and none is undecided.
pub(crate) fn refuted(spec: &str) -> Vec<String> {
    let found = verdicts(spec);
    let refuted: Vec<String> = found.iter().filter(|v| *v != "=").cloned().collect();
    assert_eq!(refuted.len(), spec.matches("refute ").count(), "{found:?}");
    assert!(refuted.iter().all(|v| v.contains(" at ")), "{refuted:?}");
    refuted
}

#[test]
fn counterexamples_are_inside_of_what_is_assumed() {
    // The quadrilateral has the corners (0, 1/4), (0, 1), (1, 0), (1/2, 0).
    let found = verdicts(
        "family Polygon {
            domain 0 <= t <= 1;
            shape 0 <= α, 0 <= β <= 1;
            assume α + β <= 1;
            assume 1/2 <= α + 2*β;
            b[0] = 1 - α - β*t;
            b[1] = α + β*t^2 + t/100;
            prove nonnegative;
            prove α <= 1;
            prove 2*α + β >= 1/4;
            prove at β = 0 { α >= 1/2; }
            prove at β = 1 { α = 0; }
            prove at α = β { 1/6 <= α <= 1/2; }
            prove independent except α = 1;
            refute b[0] > 0;
            refute 2*α + β > 1/4;
            refute at β = 0 { α > 1/2; }
            refute at α = β { α < 1/2; }
            refute independent;
        }
        family Line {
            domain 0 <= t <= 1;
            shape 0 <= B <= 1, C;
            assume B + 2*C = 1;
            b[0] = 1 - B*t; b[1] = C*t + 1;
            prove C = (1 - B)/2;
            prove 0 <= C <= 1/2;
            prove at B = 1 { b[1] = 1; }
            prove independent;
            refute C > 0;
        }",
    );
    assert_eq!(found.iter().filter(|v| *v == "=").count(), 11, "{found:?}");
    assert!(found.iter().all(|v| !v.contains("undecided")), "{found:?}");
    assert!(found[8].starts_with("0 at α = 0, β = 1/4"), "{}", found[8]);
}

/// √2 = 1.41421…, the largest value of α + β on the unit disk.
#[test]
fn assumptions_that_are_no_part_of_a_box() {
    let found = verdicts(
        "family Disk {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = 1 + α*t + β*(1 - t);
            b[1] = 2 - (α + β)^2;
            b[2] = 1 - 2*α*β*t;
            b[3] = 1 - α^2 - t*β^2;
            prove nonnegative;
            prove α + β <= 3/2;
            prove α + β < 1415/1000;
            prove t*(α + β) <= 3/2;
            prove (α + β)/(1 + t) <= 3/2;
            refute b[0] > 0;
            refute α + β <= 139/100;
            refute b[3] >= 1/10;
        }
        family Ellipse {
            domain 0 <= t <= 1;
            shape λ, μ;
            assume λ^2 + 4*μ^2 <= 4;
            b[0] = 2 + λ*t;
            prove nonnegative;
            prove -2 <= λ <= 2;
            prove μ <= 1;
            refute μ <= 99/100;
            refute λ < 2;
        }
        family Open {
            domain 0 <= t <= 1;
            shape 0 < p <= 4, 0 < q <= 4;
            assume p*q > 1;
            b[0] = p*t + q;
            prove q > 1/4;
            refute q >= 1/2;
            refute p + q >= 21/10;
        }",
    );
    let proved = [0, 1, 2, 3, 4, 8, 9, 10, 13];
    for (k, verdict) in found.iter().enumerate() {
        if proved.contains(&k) {
            assert_eq!(verdict, "=", "{k}: {found:?}");
        } else {
            assert!(verdict.contains(" at "), "{k}: {found:?}");
        }
    }
}

/// The border is touched at irrational points, such as α = β = 1/√2 and α² = 2/3, β² = 1/3.
#[test]
fn what_is_false_at_an_irrational_point_only() {
    let found = refuted(
        "family Disk {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = t;
            prove α*β <= 1/2;
            refute α*β < 1/2;
            refute t*α*β > -1/2;
            refute (α + β)^2 < 2;
            refute α^4*β^2 < 4/27;
        }
        family Ellipse {
            domain 0 <= t <= 1;
            shape -3 <= a <= 3, -2 <= b <= 2;
            assume a^2/9 + b^2/4 <= 1;
            f[0] = a + b*t;
            prove f[0]^2 <= 13;
            refute f[0]^2 < 13;
            refute a*b < 3;
        }",
    );
    assert!(found.iter().all(|v| v.starts_with("0 at ")), "{found:?}");
    assert!(found[5].contains("sqrt("), "{}", found[5]);
}

/// 3·√3 = 5.196…: the largest value of a·b·c is 1/5.196, that of a²·b is 2/5.196.
#[test]
fn multiples_of_an_assumption() {
    refuted(
        "family Ball {
            domain 0 <= t <= 1;
            shape 0 <= a <= 1, 0 <= b <= 1, 0 <= c <= 1;
            assume a^2 + b^2 + c^2 <= 1;
            f[0] = a + b*t + c*t^2;
            prove (a + b + c)^2 <= 3;
            prove a*b + c <= 1;
            prove a*b*c <= 1/5;
            prove a^2*b <= 385/1000;
            refute a^2*b <= 38/100;
            refute a*b*c <= 192/1000;
            refute a*b + c < 1;
        }
        family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 < a, 0 < b;
            assume a*b >= 1;
            f[0] = a + b*t;
            prove a + b >= 2;
            prove a + 3*b >= 3;
            prove 2*a + b >= 14/5;
            refute a + b > 2;
            refute 2*a + b >= 3;
        }
        family Ring {
            domain 0 <= t <= 1;
            shape 0 <= a, 0 <= b;
            assume a + b <= 1;
            assume a^2 + b^2 >= 1/2;
            f[0] = a + b*t;
            prove a + b >= 7/10;
            prove a*b <= 1/4;
            refute a*b < 1/4;
            refute a + b >= 71/100;
        }",
    );
}

/// One inequality decides what the table of coefficients on the whole box does not.
#[test]
fn independence_where_something_is_assumed() {
    let found = refuted(
        "family Always {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = 1; b[1] = 2;
            refute independent;
        }
        family Inside {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1;
            assume α^2 <= 1/2;
            b[0] = 1; b[1] = α*t;
            refute independent;
            prove independent except α = 0;
        }
        family Line {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = 1; b[1] = t*(α + β - 7/5);
            refute independent;
        }
        family Outside {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = (1 - t)*(3/2 - α - β); b[1] = t*(3/2 - α - β);
            prove independent;
            prove totally_positive;
        }
        family Numbers {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = α + 2; b[1] = α*t + 2*t + β*t^2;
            prove independent;
        }",
    );
    assert!(found.iter().all(|v| v.starts_with("0 at ")), "{found:?}");
}

/// A step of the elimination below 0 says nothing of a matrix in another basis: only minors of the functions refute.
#[test]
fn total_positivity_is_refuted_by_minors_only() {
    let found = verdicts(
        "family Tight {
            domain 0 <= t <= 1;
            shape -1 <= a <= 1, -1 <= b <= 1;
            assume a^2 + b^2 <= 1;
            f[0] = 1 - t; f[1] = t*(7/5 - a - b);
            refute totally_positive;
        }
        family Clear {
            domain 0 <= t <= 1;
            shape -1 <= a <= 1, -1 <= b <= 1;
            assume a^2 + b^2 <= 1;
            f[0] = 1 - t; f[1] = t*a;
            refute totally_positive;
        }",
    );
    assert!(found.iter().all(|v| !v.contains("step") && *v != "="), "{found:?}");
    assert!(found[1].contains(" at a = "), "{found:?}");
}

/// What is zero at points that are not assumed only is positive.
#[test]
fn strict_inequalities_on_a_border_that_is_left_out() {
    let refuted = refuted(
        "family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 <= r <= 2, 0 <= s <= 2;
            assume 1 <= r*s <= 2;
            b[0] = r + s*t;
            b[1] = r*t + s*(1 - t);
            prove b > 0;
            prove r > 0;
            prove r + s >= 2;
            refute r + s > 2;
            refute b[0] > 1/2;
        }
        family Independent {
            domain 0 <= u <= 1, 0 <= v <= 1;
            shape 0 <= a <= 4, 0 <= c <= 4;
            assume a*c >= 1;
            b[0] = a*u + c*(1 - u);
            b[1] = a + c - 2*v;
            b[2] = a^2 + c^2 - 2*u*v;
            prove independent;
            prove b[0] > 0;
            refute b[1] > 0;
        }",
    );
    assert_eq!(refuted.len(), 3);
}

/// Where a minor is negative is found by the step of the elimination that is.
#[test]
fn minors_under_assumptions() {
    let refuted = refuted(
        "family Total {
            domain 0 <= t <= 1;
            shape 0 <= a <= 2, 0 <= c <= 2;
            assume a*c <= 1;
            b[0] = 1 + a*t;
            b[1] = c + t;
            prove totally_positive;
        }
        family Beyond {
            domain 0 <= t <= 1;
            shape 0 <= a <= 2, 0 <= c <= 2;
            assume a*c <= 11/10;
            b[0] = 1 + a*t;
            b[1] = c + t;
            refute totally_positive;
        }
        family Narrow {
            domain 0 <= t <= 1;
            shape 0 <= λ <= 1;
            b[0] = 1 + t/2;
            b[1] = 2 - (λ - 3/10)^2*100 + t;
            refute totally_positive;
        }",
    );
    assert_eq!(refuted.len(), 2);
}

/// With π in the value: false whatever it is between its bounds.
#[test]
fn numbers_beside_assumptions() {
    let refuted = refuted(
        "family Angles {
            domain 0 <= θ <= pi/2;
            shape -1 <= a <= 1, -1 <= c <= 1;
            assume a^2 + c^2 <= 1;
            b[0] = 1 + a*sin(θ);
            prove integral(b[0]) >= 1/2;
            prove integral(b[0]) = pi/2 + a;
            refute integral(b[0]) >= 3/5;
            refute integral(b[0]) + c <= 29/10;
        }",
    );
    assert!(refuted.iter().all(|v| v.contains("a = ")), "{refuted:?}");
}

/// Beside the coordinates of triangles and boxes: multiples that touch, and counterexamples downhill along the border.
#[test]
fn assumptions_beside_several_coordinates() {
    let refuted = refuted(
        "family Triangle {
            domain triangle (u, v, w);
            shape -2 <= a <= 2, -2 <= c <= 2;
            assume a^2 + c^2 <= 1;
            b[0] = u + a*u*v;
            prove b[0] >= 0;
            prove a*u + c*v <= 1;
            prove integral(b[0]) >= 1/8;
            refute a*u + c*v < 1;
            refute integral(b[0]) > 1/8;
        }
        family Square {
            domain 0 <= u <= 1, 0 <= v <= 1;
            shape -1 <= a <= 1, -1 <= c <= 1;
            assume a^2 + c^2 <= 1;
            b[0] = a*u + c*v;
            prove b[0] <= 3/2;
            prove a*u*(1 - u) + c*v*(1 - v) <= 1/2;
            refute b[0] <= 7/5;
        }",
    );
    assert_eq!(refuted.len(), 3);
}

/// Of two bounds one may be beyond the other for all values: a long chain is one box.
#[test]
fn long_chains() {
    let refuted = refuted(
        "family Rising {
            domain 0 <= t <= 1;
            shape 0 < h[i] <= h[i + 1] for i in 1..12;
            b[0] = sum(h[i]*t^i for i in 1..=12) + h[1];
            prove b[0] > 0;
            prove b[0] <= 13*h[12];
            refute b[0] <= 11*h[12];
        }",
    );
    assert_eq!(refuted.len(), 1);
    // With both ends the last of thirty is a product of as many differences, the first one a product of variables.
    let chain: Vec<String> = (0..30).map(|i| format!("h[{i}]")).collect();
    let spec = format!(
        "family Between {{
            domain 0 <= t <= 1;
            shape 0 <= {} <= 1;
            b[0] = sum(h[i]*t^i for i in 0..=29);
            prove h[0] <= h[29];
            prove h[3]*h[20] <= h[25];
            prove b[0] <= 30;
            refute b[0] <= 29;
            refute h[29] <= h[0];
        }}",
        chain.join(" <= ")
    );
    assert_eq!(self::refuted(&spec).len(), 2);
}

/// A part that is ≥ 0 by itself, and another one that is not larger where an assumption holds.
#[test]
fn parts_that_are_larger_than_others() {
    let found = verdicts(
        "theorem Discriminant {
            scalar 0 <= a, 0 <= c, b, 0 <= t <= 1;
            assume b^2 <= 4*a*c;
            prove a + b + c >= 0;
            prove a - b + c >= 0;
            prove a*t^2 + b*t + c >= 0;
            refute a + 21/10*b + c >= 0;
        }
        family Disk {
            domain 0 <= t <= 1;
            shape α, β;
            assume α^2 + β^2 <= 1;
            b[0] = 1 + t^2 + α*(1 - t^2) + 2*β*t;
            prove nonnegative;
            refute b[0] >= t/100;
        }",
    );
    // Families come first.
    assert_eq!([&found[0], &found[2], &found[3], &found[4]], ["="; 4], "{found:?}");
    assert!(found[1].contains(" at ") && found[5].contains(" at "), "{found:?}");
}

/// Places next to bent borders, which no few directions lead to.
#[test]
fn false_by_little_along_a_border() {
    let found = verdicts(
        "family Disk {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1;
            assume α^2 + β^2 <= 1;
            b[0] = 3*α + 3.5*β + t;
            refute b[0] >= -4.6;
            refute b[0] >= -4.609;
            prove b[0] >= -4.61;
        }
        family Ball {
            domain 0 <= t <= 1;
            shape -1 <= α <= 1, -1 <= β <= 1, -1 <= γ <= 1;
            assume α^2 + β^2 + γ^2 <= 1;
            b[0] = α + 2*β - 3*γ + t;
            refute b[0] >= -3.74;
            prove b[0] >= -3.75;
        }",
    );
    assert_eq!([&found[2], &found[4]], ["="; 2], "{found:?}");
    assert!([0, 1, 3].iter().all(|k| found[*k].contains(" at ")), "{found:?}");
}

/// Ranges without an end, which an assumption gives them.
#[test]
fn ranges_have_the_ends_that_an_assumption_gives_them() {
    let found = verdicts(
        "family Monotone {
            domain 0 <= t <= 1;
            shape 0 <= α, 0 <= β;
            assume α^2 + β^2 <= 9;
            f[0] = t^2*(3 - 2*t) + α*t*(1 - t)^2 - β*t^2*(1 - t);
            prove D(f[0]) >= 0;
        }
        family Irrational {
            domain 0 <= t <= 1;
            shape 0 <= α, 0 <= β;
            assume 2*α^2 + β^2 <= 9;
            f[0] = t^2*(3 - 2*t) + α*t*(1 - t)^2 - β*t^2*(1 - t);
            prove D(f[0]) >= 0;
            refute D(f[0]) >= 1/100;
        }",
    );
    assert_eq!([&found[0], &found[1]], ["="; 2], "{found:?}");
    assert!(found[2].contains(" at "), "{found:?}");
}

/// The region of monotone cubics (F. N. Fritsch, R. E. Carlson, 1980), outside of the triangle α + β <= 3: the
/// derivative is proved to be nonnegative by its product with α, and by what it is for α = 0.
#[test]
fn other_ways_follow_where_the_first_one_fails() {
    let ellipse = |shape: &str, last: &str| {
        format!(
            "family Ellipse {{
                domain 0 <= t <= 1;
                shape {shape};
                assume α^2 + α*β + β^2 - 6*α - 6*β + {last} <= 0;
                b[0] = α*(1 - t)^2 + 2*(3 - α - β)*t*(1 - t) + β*t^2;
                prove b[0] >= 0;
            }}"
        )
    };
    assert_eq!(verdicts(&ellipse("0 < α, 0 < β", "9")), ["="]);
    assert_eq!(verdicts(&ellipse("0 <= α, 0 <= β", "9")), ["="]);
    let found = verdicts(&ellipse("0 <= α, 0 <= β", "17/2"));
    assert!(found[0].contains(" at "), "{found:?}");
    let found = verdicts(
        "theorem Product {
            scalar 0 < λ <= 1;
            scalar 0 < μ;
            assume λ*μ >= 1/4;
            prove μ >= 1/4;
            refute μ >= 13/50;
        }",
    );
    assert!(found[0] == "=" && found[1].contains(" at "), "{found:?}");
    // Where a is 0, so is b.
    let found = verdicts(
        "theorem Discriminant {
            scalar 0 <= a, 0 <= c, b, 0 <= t <= 1;
            assume b^2 <= a*c;
            prove a*(1 - t)^2 + 2*b*t*(1 - t) + c*t^2 >= 0;
            refute a*(1 - t)^2 + 21/10*b*t*(1 - t) + c*t^2 >= 0;
        }",
    );
    assert!(found[0] == "=" && found[1].contains(" at "), "{found:?}");
}

/// Each of several inequalities of a claim, and each span, has a way of its own.
#[test]
fn ways_belong_to_their_statements() {
    let quadratic = "a*(1 - t)^2 + 2*b*t*(1 - t) + c*t^2";
    let family = |domain: &str, rest: &str| {
        format!("family F {{ domain {domain}; shape 0 <= a, 0 <= c, b; assume b^2 <= a*c; {rest} }}")
    };
    let two = format!(
        "f[0] = a*c + a - b^2; f[1] = {quadratic}; f[2] = 1 + a*t; prove [f[0], f[1]] >= 0; prove [f[1], f[0]] >= 0; \
         prove nonnegative;"
    );
    assert_eq!(verdicts(&family("0 <= t <= 1", &two)), ["="; 3]);
    let spans = format!("f[0] = {quadratic} | a*c + a - b^2; prove f[0] >= 0;");
    assert_eq!(verdicts(&family("0 <= t <= 1, 1 <= t <= 2", &spans)), ["="]);
}

/// The least value among simple points is 0 at many of them, and only some lie next to a point where it is negative.
#[test]
fn counterexamples_next_to_one_of_many_zeros() {
    let found = verdicts(
        "family Disk {
            domain 0 <= t <= 1;
            shape -1 <= a <= 1, -1 <= b <= 1;
            assume a^2 + b^2 <= 1;
            f[0] = t;
            refute t*b/2 + a^2 <= 1;
            prove t*b/2 + a^2 <= 9/8;
        }",
    );
    assert!(found[0].contains(" at ") && found[1] == "=", "{found:?}");
}

/// What is assumed of scalars says nothing of the coordinates of points, which may be any numbers.
#[test]
fn points_beside_scalars_that_are_related() {
    let found = verdicts(
        "theorem Coordinates {
            scalar 0 <= a <= 1, 0 <= b <= 1;
            assume a*b >= 1/4;
            curve P = Bernstein(1);
            dimension 1;
            refute P[0][0] <= 1;
            refute b*P[0][0] <= 1;
            refute a == b;
        }
        theorem Anywhere {
            scalar -1 <= a <= 1, -1 <= b <= 1;
            assume a^2 + b^2 <= 1;
            curve P = Bernstein(1);
            refute b == b + 1/10;
            refute a == 2*a;
            refute P[1] == P[1] + 1/10*P[0];
            refute (1 + a)*P[0] parallel P[1];
        }",
    );
    assert!(found.iter().all(|verdict| !verdict.contains("undecided")), "{found:?}");
}

/// A product with something positive follows from what is assumed, and so does the sign itself.
#[test]
fn signs_of_products_with_positive_parameters() {
    let found = verdicts(
        "family Hyperbola {
            domain 0 <= t <= 1;
            shape 0 <= λ <= 1, -1 <= μ <= 1;
            assume λ*μ >= 1/4;
            b[0] = λ;
            b[1] = t - t*μ;
            prove μ >= 0;
            prove b[1] <= 3/4;
            refute b[1] <= 74/100;
            refute μ > 1/4;
        }
        family Unbounded {
            domain 0 <= t <= 1;
            shape 0 <= λ;
            shape μ;
            assume λ*μ >= 1;
            b[0] = λ + t;
            b[1] = μ;
            prove μ >= 0;
        }",
    );
    assert_eq!([&found[0], &found[1], &found[4]], ["="; 3], "{found:?}");
    assert!(found[2].contains(" at ") && found[3].contains(" at "), "{found:?}");
}

/// Of shape values in two parts no factor of the minors has one sign, but their product has, or their square.
#[test]
fn independence_where_factors_have_both_signs() {
    let found = verdicts(
        "family Both {
            domain 0 <= t <= 1;
            shape -1 <= p <= 1, -1 <= q <= 1;
            assume p*q >= 1/4;
            b[0] = p;
            b[1] = q*t;
            prove independent;
        }
        family Sum {
            domain 0 <= t <= 1;
            shape -1 <= p <= 1, -1 <= q <= 1;
            assume p*q >= 1/4;
            b[0] = t;
            b[1] = p + q;
            prove independent;
        }
        family Difference {
            domain 0 <= t <= 1;
            shape -1 <= p <= 1, -1 <= q <= 1;
            assume p*q >= 1/4;
            b[0] = t;
            b[1] = p - q;
            refute independent;
        }",
    );
    assert_eq!(found[..2], ["=", "="], "{found:?}");
    assert!(found[2].starts_with("0 at p = "), "{found:?}");
}
