//! Angles whose sines are irrational: at an end of the domain, at a value that `at` gives, and as numbers such as
//! sin(π/4).

use crate::rechecked::counterexamples;
use crate::verdicts::verdicts;

/// The middle of the domain and others of its points: tan(π/8) = √2 − 1, tan(π/16), tan(π/12) = 2 − √3.
#[test]
fn values_at_parts_of_a_turn() {
    let found = counterexamples(
        "family OnTheUnitInterval {
            domain 0 <= t <= 1;
            b[0] = 1 - sin(pi*t/2);
            b[1] = sin(pi*t/2) + cos(pi*t/2) - 1;
            b[2] = 1 - cos(pi*t/2);
            prove at t = 1/2 { b[0] = b[2]; b[1]^2 + 2*b[1] = 1; D(b[1]) = 0; D(b[0])^2 = pi^2/8; }
            prove at t = 1/3 { b[0] = 1/2; b[1] <= 3661/10000; }
            prove at t = 1/4 { b[0] = 1 - sin(pi/8); }
            refute at t = 1/4 { b[0] = 1 - sin(3*pi/8); }
            prove at t = 1/2 { 41/100 < b[1] < 5/12; }
            refute at t = 1/2 { b[1] = 5/12; }
            refute at t = 1/2 { b[1] <= 41/100; }
            refute at t = 1/2 { D(b[0])^2 = pi^2/7; }
        }
        family InRadians {
            domain 0 <= t <= pi/2;
            b[0] = cos(t);
            b[1] = sin(t);
            prove at t = pi/4 { b[0] = b[1]; 2*b[0]^2 = 1; }
            prove at t = pi/3 { b[0] = 1/2; 4*b[1]^2 = 3; b[1] = b[0](pi/2 - t); }
            refute at t = pi/6 { b[1] > 1/2; }
        }
        family GoldenSection {
            domain 0 <= t <= pi/2;
            b[0] = cos(t);
            prove at t = 2*pi/5 { 2*b[0] = 1/(2*b[0] + 1); }
        }
        family Sums {
            domain 0 <= t <= pi/2;
            b[0] = sin(t + pi/3) + cos(pi/6)*t;
            b[1] = sin(t) + sin(pi/3)*cos(t);
            prove b[0] = sin(t)/2 + cos(pi/6)*(t + cos(t));
            prove b[1] >= 86/100;
            refute b[1] >= 87/100;
        }",
    );
    assert_eq!(found[1], "-5/12 + tan(pi/8) at t = 1/2");
    assert_eq!(found[3], "-1/56*pi^2 at t = 1/2");
    assert_eq!(found.len(), 6, "{found:?}");
}

/// tan(π/8), where the domain ends.
#[test]
fn domains_end_at_parts_of_a_turn() {
    let found = counterexamples(
        "family Halves {
            domain 0 <= t <= pi/2;
            b[0] = cos(t/2) - sin(t/2);
            b[1] = 2*sin(t/2)*(cos(t/2) - sin(pi/4));
            b[2] = 1 - b[0] - b[1];
            prove b[0] >= 0;
            prove b[1] >= 0;
            prove b[0] <= 1;
            prove independent;
            prove at t = 0 { b = [1, 0, 0]; }
            prove at t = pi/2 { b = [0, 0, 1]; D(b[0]) = -sin(pi/4); }
            prove at t = pi/4 { b[0] = cos(pi/8) - sin(pi/8); }
            refute b[0] >= 1/10;
            refute symmetric;
        }
        family BothSides {
            domain -pi/2 <= t <= pi/2;
            b[0] = cos(t/2) - sin(t/2);
            b[1] = cos(t/2) + sin(t/2);
            prove nonnegative;
            prove symmetric;
            prove independent;
            prove b[0]*b[1] = cos(t);
            prove at t = pi/3 { b[1]^2 = 1 + sin(pi/3); }
        }
        family Mixed {
            domain 0 <= t <= pi/2;
            b[0] = t - sin(t/2);
            b[1] = cos(t/2) - t*sin(pi/4)/(pi/2);
            prove b[0] >= 0;
            prove b[1] >= 0;
            prove sin(t/2) >= 2*t*sin(pi/4)/pi;
            refute sin(t/2) >= t*46/100;
            prove at t = pi/2 { b[0] = pi/2 - sin(pi/4); b[1] = 0; }
        }
        family Spans {
            domain 0 <= t <= pi/2, pi/2 <= t <= pi;
            f[0] = sin(t/2) | sin(pi/4)*(cos((t - pi/2)/2) + sin((t - pi/2)/2));
            prove smooth(3);
            prove nonnegative;
            prove at t = pi/3 { f[0] = 1/2; }
            prove at t = 2*pi/3 { f[0] = sin(pi/3); }
            prove at t = pi/2 { D(f[0]) = sin(pi/4)/2; }
        }
        family Third {
            domain 0 <= t <= 1;
            b[0] = 2*cos(pi*t/3) - 1;
            b[1] = sin(pi*t/3);
            prove nonnegative;
            prove at t = 1 { b[0] = 0; 4*b[1]^2 = 3; }
            refute b[1] >= t;
        }",
    );
    assert_eq!(found.len(), 4, "{found:?}");
}

/// The family is expanded anew, on a domain that ends there.
#[test]
fn shape_parameters_at_parts_of_a_turn() {
    let found = counterexamples(
        "family CBezier {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = b[3](α - t);
            b[1] = 1 - b[0] - b[2] - b[3];
            b[2] = (1 - cos(t))/(1 - cos(α)) - b[3];
            b[3] = (t - sin(t))/(α - sin(α));
            prove at α = pi/3 { b[3] >= 0; b[0] >= 0; b[2] >= 0; b[3](t) = b[0](α - t); }
            refute at α = pi/3 { b[2] >= 1/100; }
            prove at α = pi/4, t = α { D(b[3]) = (1 - cos(pi/4))/(pi/4 - sin(pi/4)); }
            refute at α = 2*pi/3, t = α { D(b[3]) = 1; }
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}

/// The antiderivative is found although tan(π/8) or tan(π/12) stands in the functions.
#[test]
fn integrals_up_to_parts_of_a_turn() {
    let found = counterexamples(
        "family Half {
            domain 0 <= t <= pi/2;
            b[0] = cos(t/2)^2;
            prove integral(sin(t)) = 1;
            prove integral(b[0]) = pi/4 + 1/2;
            prove integral(b[0]) <= 13/10;
            refute integral(b[0]) >= 13/10;
        }
        family Third {
            domain 0 <= t <= pi/2;
            b[0] = 1 - sin(t/3);
            prove integral(sin(t/3)) = 3 - 3*cos(pi/6);
            prove integral(t*sin(t/3)) = 9*sin(pi/6) - 3*pi/2*cos(pi/6);
            refute integral(t*sin(t/3)) = 9*sin(pi/6) - 3*pi*cos(pi/6);
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].starts_with("-4/5 + 1/4*pi"), "{found:?}");
}

/// Where the middle of the domain is named, the end of the range of the parameter has an irrational tangent.
#[test]
fn functions_that_depend_on_one_another_at_the_end_that_is_left_out() {
    let found = counterexamples(
        "family Quadratic {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = sin((α - t)/2)^2/sin(α/2)^2;
            b[1] = 2*cos(α/2)*sin((α - t)/2)*sin(t/2)/sin(α/2)^2;
            b[2] = sin(t/2)^2/sin(α/2)^2;
            prove independent;
            prove totally_positive;
            prove at t = α/2 { b[0] = 1/(4*cos(α/4)^2); }
            prove integral(b[0]) <= α/2;
            prove b[1] < 1/2;
        }",
    );
    assert!(found.is_empty(), "{found:?}");
}

/// Claims that are sharp, or nearly so, where the range of the parameter ends at a part of a turn.
#[test]
fn signs_up_to_irrational_ends() {
    let found = counterexamples(
        "family Quarter {
            shape 0 < α <= pi/2;
            domain 0 <= t <= α;
            b[0] = sin(t/2);
            prove cos(t) >= 0;
            prove sin(t/2)^2 <= 1/2;
            prove α <= pi/2;
            refute sin(t) < 1;
        }
        family BelowQuarter {
            shape 0 < α < pi/2;
            domain 0 <= t <= α;
            b[0] = sin(t/2);
            prove cos(t) > 0;
        }
        family Eighth {
            shape 0 < α <= pi/4;
            domain 0 <= t <= α;
            b[0] = sin(t);
            prove cos(2*t) >= 0;
            prove sin(t)^2 <= 1/2;
            prove t <= pi/4;
            refute sin(t)^2 < 1/2;
        }
        family Thirds {
            shape pi/3 <= α <= 2*pi/3;
            domain 0 <= t <= α;
            b[0] = sin(t);
            prove sin(α) >= 866025/1000000;
            refute sin(α) >= 866026/1000000;
        }",
    );
    assert_eq!(found.len(), 3, "{found:?}");
    assert!(found[0].starts_with("0 at tan(α/4) = "), "{found:?}");
}

/// Lists of shape parameters at ends of domains and beside angles.
#[test]
fn parameters_with_an_index() {
    let refuted = counterexamples(
        "family Knots {
            shape 0 < h[i] for i in 0..=2;
            domain 0 <= x <= h[1];
            b[0] = (h[1] - x)^2/(h[1]*(h[0] + h[1]));
            b[2] = x^2/(h[1]*(h[1] + h[2]));
            b[1] = 1 - b[0] - b[2];
            prove nonnegative;
            prove continuity(1) with h[0] = h[1], h[1] = h[2];
            prove integral(b[0]) = h[1]^2/(3*(h[0] + h[1]));
            prove at h = 1 { b[0] = (1 - x)^2/2; }
            refute D(integral(b[0]), h[0]) >= 0;
        }
        family Spans {
            shape 0 < d[1] <= d[2];
            domain 0 <= x <= d[1], d[1] <= x <= d[1] + d[2];
            f[0] = x/d[1] | 1 - (x - d[1])/d[2];
            prove smooth(0);
            prove integral(f[0]) >= d[1];
            refute integral(f[0]) > d[1];
        }
        family Powers(n in 2..=3) {
            domain 0 <= θ <= pi/2;
            shape -1 <= λ[i] <= i for i in 1..=n;
            b[0] = sum(λ[i]*cos(θ)^i*sin(θ)^(n - i) for i in 1..=n);
            prove b[0] >= -n;
            prove at λ = 0 { b[0] = 0; }
            prove integral(b[0]) = λ[1]/2 + λ[2]*pi/4 if n == 2;
            refute b[0] <= 1/2;
        }
        family Arcs {
            shape 0 < α[i] < pi/2 for i in 1..=2;
            domain 0 <= t <= α[1];
            b[0] = sin(t)/sin(α[1]);
            prove 0 <= b[0] <= 1;
            prove cos(t) + sin(α[2]) > 0;
            refute cos(t) >= sin(α[2]);
        }
        family Given {
            shape 0 < α[i] < pi for i in 0..=1;
            domain 0 <= t <= α[0];
            b[0] = sin(t)*cos(α[1]);
            prove at α[0] = pi/3, α[1] = pi/3 { b[0] <= 1/2; }
            prove at α[1] = 2*pi/3 { b[0] = -sin(t)/2; }
            prove at α = pi/3 { b[0] = sin(t)/2; }
            refute at α[0] = pi/3, α[1] = pi/3 { b[0] <= 43/100; }
            refute at α[1] = pi/3 { b[0] = -sin(t)/2; }
        }",
    );
    assert_eq!(refuted.len(), 7, "{refuted:?}");
}

/// Where the value is attained at an irrational point, alone and with a shape parameter as a factor; the same bounds made
/// less are false.
#[test]
fn bounds_that_are_attained_at_parts_of_a_turn() {
    let found = counterexamples(
        "family Greatest {
            domain 0 <= t <= pi/2;
            b[0] = 1 - sin(t);
            b[1] = sin(t) + cos(t) - 1;
            b[2] = 1 - cos(t);
            prove b[1] <= 2*sin(pi/4) - 1;
            prove (sin(t) + cos(t))^3 <= 8*sin(pi/4)^3;
            refute b[1] <= 2*sin(pi/4) - 1 - 1/1000000;
            refute b[1] >= 2*sin(pi/4) - 1;
        }
        family OnTheUnitInterval {
            domain 0 <= t <= 1;
            b[0] = sin(pi*t/2) + cos(pi*t/2);
            prove b[0] <= 2*sin(pi/4);
            prove b[0]^2 - 4*b[0]*sin(pi/4) + 2 >= 0;
            refute b[0]^2 - 4*b[0]*sin(pi/4) + 2 >= 1/100000;
        }
        family WithAFactor {
            domain 0 <= t <= pi;
            shape 0 <= λ <= 1;
            b[0] = λ*(1 - sin(t));
            b[1] = t - sin(t);
            prove sin(t)*sin(pi/3) + cos(t)*cos(pi/3) <= 1;
            prove sin(t)*cos(pi/5) - cos(t)*sin(pi/5) <= 1;
            prove λ*(sin(t)*sin(pi/3) + cos(t)*cos(pi/3)) <= λ;
            refute λ*(sin(t)*sin(pi/3) + cos(t)*cos(pi/3)) <= 9*λ/10;
        }
        family UpToAParameter {
            domain 0 <= t <= α;
            shape 0 < α <= pi/2;
            b[0] = sin(t);
            prove sin(α) + cos(α) <= 2*sin(pi/4);
        }",
    );
    assert_eq!(found.len(), 4, "{found:?}");
}

/// It is a bound that is attained, so the strict one is false, and is not proved.
#[test]
fn strict_bounds_that_are_attained_are_not_proved() {
    let spec = "family Greatest {
        domain 0 <= t <= pi/2;
        b[0] = sin(t) + cos(t);
        conjecture b[0] < 2*sin(pi/4);
        conjecture b[0] <= 2*sin(pi/4) - 1/1000000000000;
    }";
    let report = basis_engine::check(basis_engine::Source::text("claims.basis", spec));
    for verdict in crate::rechecked::rechecked(&report) {
        assert!(!matches!(verdict, basis_engine::Verdict::Proved(_)), "{verdict:?}");
    }
}

/// Where `at` fixes the place, the counterexample names that place, also where it has a value of its own for the variable.
#[test]
fn fixed_places_are_named() {
    let found = verdicts(
        "family Fixed {
            domain 0 <= t <= pi;
            b[0] = (cos(t/2) - sin(pi/4)) * sin(t/2 + pi/4);
            b[1] = cos(t/2)^2;
            prove at t = pi { D(b[0]) > -103/1000; }
            prove at t = pi { b[0] > -4/10; }
        }",
    );
    assert!(found.iter().all(|verdict| verdict.ends_with(" at t = pi")), "{found:?}");
}
