//! Claims that need smaller parts of an angle than the functions, sharp claims at irrational ends of ranges, points
//! inside of spans between shape parameters, and lists of shape parameters beside angles.

use crate::rechecked::counterexamples;

/// The claims about the middle of the domain need tan(α/8), whose range ends at an irrational number; the others do not.
#[test]
fn one_claim_in_smaller_parts_leaves_the_others_as_they_are() {
    let found = counterexamples(
        "family BBasis {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = sin((α - t)/2)^2/sin(α/2)^2;
            b[1] = 2*cos(α/2)*sin((α - t)/2)*sin(t/2)/sin(α/2)^2;
            b[2] = sin(t/2)^2/sin(α/2)^2;
            prove at t = α/2 { b[0] = 1/(4*cos(α/4)^2); b[0] = b[2]; }
            refute at t = α/2 { b[0] = 1/4; }
            prove at t = 0 { D(b) = 1/tan(α/2)*[-1, 1, 0]; }
            prove D(b[0]) <= 0;
            prove D(b[0], α) >= 0;
            refute D(b[0]) < 0;
            refute b[1] <= 49/100;
            prove at α = pi/3 { b[1] <= 1/2; }
        }
        family Sphere {
            shape 0 < Ω < pi;
            domain 0 <= s <= Ω;
            b[0] = sin(Ω - s)/sin(Ω);
            b[1] = sin(s)/sin(Ω);
            prove at s = Ω/3 { b[1] = sin(Ω/3)/sin(Ω); b[1] > 1/3; }
            prove at Ω = 2*pi/3, s = pi/3 { b = [1, 1]; }
            prove sum(b) >= 1;
        }
        family Exponential {
            domain 0 <= t <= 1;
            b[0] = (exp(t) - 1)/(exp(1) - 1);
            prove at t = 1/2 { b[0] = 1/(exp(1/2) + 1); b[0] < 38/100; }
            prove b[0] <= t;
            refute at t = 1/4 { b[0] = 1/4; }
        }",
    );
    assert_eq!(found.len(), 4, "{found:?}");
    assert!(found[1].ends_with("t = α"), "{found:?}");
}

/// tan(π/8) and tan(π/12): the claims are sharp there.
#[test]
fn sharp_claims_at_irrational_ends() {
    let found = counterexamples(
        "family BBasis {
            shape 0 < α < pi/2;
            domain -α <= t <= α;
            let p = sin((α - t)/2)/sin(α);
            let q = sin((α + t)/2)/sin(α);
            let c = cos(α);
            b[0] = p^4;
            b[1] = (2 + 4*c^2)*p^2*q^2;
            prove b[1] <= 1/2;
            refute b[1] <= 49/100;
            prove D(b[0]) <= 0;
        }
        family Spline {
            shape 0 < h <= pi/3;
            domain 0 <= x <= h;
            b[0] = sin(x/2)^3/sin(h/2)/sin(h)/sin(3*h/2);
            prove b[0] <= 1/4 + 1/12;
            prove (1 - 2*cos(h))*b[0] <= 0;
            refute b[0] <= 28/100;
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn points_inside_of_spans() {
    let found = counterexamples(
        "family Spline {
            shape 0 < h < pi/3;
            domain 0 <= x <= h, h <= x <= 2*h, 2*h <= x <= 3*h;
            let d = sin(h/2)*sin(h);
            f[0] = sin(x/2)^2/d
                 | (sin(x/2)*sin((2*h - x)/2) + sin((3*h - x)/2)*sin((x - h)/2))/d
                 | sin((3*h - x)/2)^2/d;
            prove at x = 3*h/2 { f[0] = 2*sin(3*h/4)*sin(h/4)/d; }
            prove at x = h { f[0] = 1/(2*cos(h/2)); }
            prove at x = 5*h/2 { f[0] = sin(h/4)^2/d; }
            refute at x = h/2 { f[0] = sin(h/2)^2/d; }
        }
        family Knots {
            shape 0 < h[i] for i in 1..=3;
            domain 0 <= x <= h[1], h[1] <= x <= h[1] + h[2], h[1] + h[2] <= x <= h[1] + h[2] + h[3];
            let e = h[1] + h[2] + h[3];
            N[0] = x^2/(h[1]*(h[1] + h[2]))
                 | x*(h[1] + h[2] - x)/((h[1] + h[2])*h[2]) + (e - x)*(x - h[1])/((h[2] + h[3])*h[2])
                 | (e - x)^2/((h[2] + h[3])*h[3]);
            prove smooth(1);
            prove at x = h[1]/2 { N[0] = h[1]/(4*(h[1] + h[2])); }
            prove at x = h[1] + h[2]/2 { N[0] > 0; }
            prove at h = 1 { N[0] <= 3/4; }
            refute at x = e - h[3]/2 { N[0] = h[3]/(h[2] + h[3]); }
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn lists_of_shape_parameters_beside_angles() {
    let found = counterexamples(
        "family Rational {
            domain 0 <= t <= pi/2;
            shape 0 < w[i] for i in 0..=3;
            let B = [(1 - sin(t))^2, 2*sin(t)*(1 - sin(t)), 2*cos(t)*(1 - cos(t)), (1 - cos(t))^2];
            b[i] = w[i]*B[i]/sum(w[j]*B[j] for j in 0..=3) for i in 0..=3;
            prove partition_of_unity;
            prove nonnegative;
            prove independent;
            prove at t = 0 { D(b[1]) = 2*w[1]/w[0]; }
            prove at w = 1 { b[0] = (1 - sin(t))^2; }
            prove D(b[0], w[1]) <= 0;
            refute at w[1] = 1 { b[1] <= 1/2; }
        }
        family Increasing {
            domain 0 <= t <= pi/2;
            shape 0 <= m[i] <= m[i + 1] for i in 1..3;
            b[i] = m[i + 1]*sin(t) for i in 0..=2;
            prove b[0] <= b[1] <= b[2];
            refute b[1] <= b[0];
        }",
    );
    assert_eq!(found.len(), 2, "{found:?}");
}
