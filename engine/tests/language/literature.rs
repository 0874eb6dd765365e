//! Families of the literature beyond polynomials, with claims that are sharp and others that are false by little.

use crate::rechecked::counterexamples;

const SPEC: &str = "
/// The Said–Ball basis of degree 4 in sine and cosine, with a shape parameter.
family TrigSaidBall {
    domain 0 <= t <= pi/2;
    shape 0 <= λ <= 2;
    let s = sin(t);
    let c = cos(t);
    b[0] = (1 - s)^2*(1 + (2 - λ)*s);
    b[1] = λ*s*(1 - s)^2;
    b[2] = 1 - b[0] - b[1] - b[3] - b[4];
    b[3] = λ*c*(1 - c)^2;
    b[4] = (1 - c)^2*(1 + (2 - λ)*c);
    prove partition_of_unity;
    prove symmetric;
    prove nonnegative;
    refute independent;
    prove independent except λ = 0;
    prove at t = 0 { D(b) = [-λ, λ, 0, 0, 0]; }
    refute at t = 0 { D(b) = [-λ, λ, λ, 0, 0]; }
    prove b[0] <= 1;
    prove b[1] <= 8/27;
    refute b[1] <= 7/27;
    refute b[1] < 8/27;
    prove b[1] <= 4/27*λ;
    prove at t = pi/4 { b[0] = b[4]; }
    prove at t = pi/2 { b = [0, 0, 0, 0, 1]; }
    refute D(b[0], λ) < 0;
    prove D(b[0], λ) <= 0;
    prove D(b[2]) = -D(b[0] + b[1] + b[3] + b[4]);
    prove at t = 0 { D(b[0], 2) = 4*λ - 6; } 
}

/// The quadratic B-spline over any knots.
family QuadraticB {
    shape 0 < h0, 0 < h1, 0 < h2;
    domain 0 <= x <= h0, h0 <= x <= h0 + h1, h0 + h1 <= x <= h0 + h1 + h2;
    let a = h0;
    let b = h0 + h1;
    let c = h0 + h1 + h2;
    f[0] = x^2/(h0*(h0 + h1)) | x*(b - x)/((h0 + h1)*h1) + (c - x)*(x - a)/((h1 + h2)*h1) | (c - x)^2/((h1 + h2)*h2);
    prove smooth(1);
    refute smooth(2);
    prove nonnegative;
    prove f[0] <= 1;
    refute f[0] <= 9/10;
    prove integral(f[0]) = (h0 + h1 + h2)/3;
    refute integral(f[0]) = (h0 + h1 + h2)/2;
    prove at x = h0 { f[0] = h0/(h0 + h1); }
    refute at x = h0 { f[0] = h1/(h0 + h1); }
    prove at x = h0 + h1 { D(f[0]) = -2/(h1 + h2); }
    prove at x = h0 { D(f[0]) = 2/(h0 + h1); }
    prove at x = 0 { f[0] = 0; D(f[0]) = 0; }
}

/// The quadratic trigonometric B-spline on knots at equal distances (T. Lyche, R. Winther 1979).
family TrigHat {
    shape 0 < h < pi/2;
    domain 0 <= x <= h, h <= x <= 2*h, 2*h <= x <= 3*h;
    f[0] = sin(x/2)^2/(sin(h/2)*sin(h)) | (sin(x/2)*sin((2*h - x)/2) + sin((3*h - x)/2)*sin((x - h)/2))/(sin(h/2)*sin(h)) | sin((3*h - x)/2)^2/(sin(h/2)*sin(h));
    prove smooth(1);
    refute smooth(2);
    prove nonnegative;
    prove symmetric;
    prove at x = h { f[0] = sin(h/2)/sin(h); }
    refute at x = h { f[0] = 1/2; }
    prove f[0] <= 1 + 1/2;
    prove at x = h { D(f[0]) = 1/(2*sin(h/2)); }
    prove f[0] <= 1/cos(h/2);
    refute f[0] <= 1/2;
}

/// Two spans with the variable beside its sine.
family MixedSpline {
    shape 0 < h < pi/2;
    domain 0 <= x <= h, h <= x <= 2*h;
    f[0] = (x - sin(x))/(h - sin(h)) | (2*h - x - sin(2*h - x))/(h - sin(h));
    prove smooth(0);
    refute smooth(1);
    prove nonnegative;
    prove symmetric;
    prove f[0] <= 1;
    refute f[0] <= 99/100;
    prove at x = h { f[0] = 1; }
    prove integral(f[0]) = (h^2 + 2*cos(h) - 2)/(h - sin(h));
    prove D(f[0]) <= (1 - cos(h))/(h - sin(h));
}

/// One span of a spline in tension (D. G. Schweikert 1966), the tension times its length being α.
family ExpTension {
    shape 0 < α <= 20;
    domain 0 <= t <= α;
    b[0] = sinh(α - t)/sinh(α);
    b[1] = (α - t)/α - b[0];
    b[2] = t/α - b[3];
    b[3] = sinh(t)/sinh(α);
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove b[3] <= t/α;
    refute b[3] <= (t/α)^2;
    prove at t = 0 { D(b[3]) = 1/sinh(α); }
    prove b[1] <= 1;
    refute b[1] <= 1/4;
    prove D(b[3], 2) = b[3];
    refute D(b[3], 2) = 2*b[3];
    prove at t = α/2 { b[3] = 1/(2*cosh(α/2)); }
    prove D(b[0]) <= 0;
    prove b[2] >= 0;
}

/// The quadratic hyperbolic B-spline (Y. Lu, G. Wang, X. Yang 2002).
family HypQuad {
    shape 0 < h;
    domain 0 <= x <= h, h <= x <= 2*h, 2*h <= x <= 3*h;
    let k = 2*(cosh(h) - 1);
    f[0] = (cosh(x) - 1)/k | (2*cosh(h) - cosh(x - h) - cosh(2*h - x))/k | (cosh(3*h - x) - 1)/k;
    prove smooth(1);
    refute smooth(2);
    prove nonnegative;
    prove symmetric;
    prove at x = h { f[0] = 1/2; D(f[0]) = sinh(h)/k; }
    prove f[0] <= 1;
    refute f[0] <= 3/4 - 1/100;
    refute f[0] >= 3/4;
    prove integral(f[0]) = h;
}

/// The symmetric rational Bézier quartic with two weights.
family RatQuarticTwo {
    domain 0 <= t <= 1;
    shape 0 < u, 0 < v;
    let d = (1 - t)^4 + 4*u*t*(1 - t)^3 + 6*v*t^2*(1 - t)^2 + 4*u*t^3*(1 - t) + t^4;
    b[0] = (1 - t)^4/d;
    b[1] = 4*u*t*(1 - t)^3/d;
    b[2] = 6*v*t^2*(1 - t)^2/d;
    b[3] = 4*u*t^3*(1 - t)/d;
    b[4] = t^4/d;
    prove partition_of_unity;
    prove nonnegative;
    prove symmetric;
    prove independent;
    prove totally_positive;
    prove at t = 0 { D(b) = 4*u*[-1, 1, 0, 0, 0]; }
    prove at t = 1/2 { b[2] = 3*v/(1 + 4*u + 3*v); }
    refute at t = 1/2 { b[2] = 6*v/(1 + 4*u + 3*v); }
    prove b[2] < 1;
    refute b[2] <= b[1] + b[3] + 1/2;
    prove D(b[2], u) <= 0;
    refute D(b[1], u) <= D(b[1], v);
    prove 16*u^2*b[2]^2 = 36*v^2*b[1]*b[3];
    prove at u = 1, v = 1 { b = Bernstein(4); }
}
// weights may touch zero

";

/// What is claimed is decided as it is declared, and the counterexamples are checked by other means.
#[test]
fn sharp_claims_are_proved_and_false_ones_refuted() {
    let found = counterexamples(SPEC);
    assert_eq!(found.len(), 23, "{found:#?}");
}
