//! Integrals over angles and exponents: true equations from tables, and near misses.

use crate::rechecked::rechecked;
use basis_engine::{Source, check};

/// Every claim of a spec is found to be as it is declared, and checks out again.
fn as_declared(spec: &str) {
    let report = check(Source::text("integrals.basis", spec));
    assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
    rechecked(&report);
}

fn errors(body: &str) -> String {
    let report = check(Source::text("integrals.basis", &format!("family F {{ {body} }}")));
    let texts = report.diagnostics.iter().map(|d| format!("{}: {:?} {:?}", d.message, d.labels, d.help));
    texts.collect::<Vec<_>>().join("; ")
}

#[test]
fn over_a_quarter_turn() {
    as_declared(
        "family Quarter {
            domain 0 <= t <= pi/2;
            b[0] = sin(t); b[1] = cos(t); b[2] = t;
            prove integral(b) = [1, 1, pi^2/8];
            prove integral(sin(t)^2) = pi/4;
            prove integral(sin(t)^3*cos(t)^2) = 2/15;
            prove integral(t*sin(t)) = 1;
            prove integral(t^2*cos(t)) = pi^2/4 - 2;
            prove integral(t^3*sin(t)^2) = pi^4/128 + 3*pi^2/32 - 3/8;
            refute integral(t^3*sin(t)^2) = pi^4/128 + 3*pi^2/32 - 3/8 + 1/10^20;
            prove integral(sin(t)) <= integral(t);
            refute integral(sin(t)) >= integral(t);
            prove integral(cos(t), t, 0, pi/2) = 1;
        }",
    );
}

/// Where the tangent is measured from the middle, with π in the argument, on a box, and over spans.
#[test]
fn over_other_domains() {
    as_declared(
        "family Turn {
            domain -pi <= t <= pi;
            b[0] = sin(t); b[1] = cos(3*t); b[2] = sin(2*t);
            prove integral(b[0]*b[2]) = 0;
            prove integral(b[1]^2) = pi;
            prove integral(t*b[0]) = 2*pi;
            prove integral(1) = 2*pi;
            prove integral(t^2) = 2*pi^3/3;
        }
        family Unit {
            domain 0 <= t <= 1;
            shape -1 <= λ <= 1;
            b[0] = (1 - sin(pi*t/2))*(1 - λ*sin(pi*t/2));
            b[1] = t*cos(pi*t);
            prove integral(b) = [1 - 2/pi - 2*λ/pi + λ/2, -2/pi^2];
            prove D(integral(b[0]), λ) = 1/2 - 2/pi;
            refute integral(b[0]) <= 499/1000;
        }
        family Box {
            domain 0 <= u <= pi, 0 <= v <= 1;
            b[0] = sin(u)*v;
            prove integral(b[0]) = 1;
            prove integral(b[0], u, 0, pi) = 2*v;
        }
        family Spans {
            domain 0 <= t <= pi/2, pi/2 <= t <= pi;
            b[0] = sin(t) | 1;
            prove integral(b[0]) = 1 + pi/2;
        }",
    );
}

#[test]
fn up_to_a_shape_parameter() {
    as_declared(
        "family Cycloid {
            shape 0 < α < pi;
            domain 0 <= t <= α;
            b[0] = (α - t - sin(α - t))/(α - sin(α));
            b[1] = (1 - cos(t))/(1 - cos(α));
            prove integral(b[0]) = (α^2/2 - 1 + cos(α))/(α - sin(α));
            prove integral(b[1]) = (α - sin(α))/(1 - cos(α));
            prove integral(sin(t)^2) = α/2 - sin(2*α)/4;
            refute integral(sin(t)^2) = α/2 + sin(2*α)/4;
        }
        family Hyperbolic {
            shape 0 < α;
            domain 0 <= t <= α;
            b[0] = sinh(t)/sinh(α);
            prove integral(b[0]) = (cosh(α) - 1)/sinh(α);
            prove integral(t*cosh(t)) = α*sinh(α) - cosh(α) + 1;
            prove integral(sinh(t)^2) = sinh(α)*cosh(α)/2 - α/2;
        }
        family Exponential {
            domain -1 <= t <= 1;
            b[0] = exp(t)*(1 - t);
            prove integral(b[0]) = exp(1) - 3*exp(-1);
            prove integral(exp(2*t)) = (exp(2) - exp(-2))/2;
            prove integral(exp(-t)*t^2) = exp(1) - 5*exp(-1);
            refute integral(b[0]) >= 7/4;
        }",
    );
}

#[test]
fn quotients_in_sines() {
    for f in ["tan(t)", "1/(2 + sin(t))", "1/(1 + t)*cos(t)", "t/(1 + cos(t))"] {
        let error = errors(&format!("domain 0 <= t < pi/2; b[0] = sin(t); prove integral({f}) = 1;"));
        assert!(error.contains("integrals of quotients in sin, cos are not supported"), "{f}: {error}");
    }
    let error = errors("domain 0 <= t <= pi/2; b[0] = sin(t); prove integral(b[0], t, 0, pi/5) = 1;");
    assert!(error.contains("pi/5"), "{error}");
}

#[test]
fn bounds_at_parts_of_pi() {
    as_declared(
        "family Sines {
            domain 0 <= t <= pi/2;
            b[0] = sin(t);
            prove integral(b[0], t, 0, pi/3) = 1/2;
            prove integral(sin(t), t, pi/6, pi/3) = cos(pi/6) - cos(pi/3);
            refute integral(cos(t), t, 0, pi/6) = 1/3;
        }
        family Power {
            domain 0 <= t <= pi;
            b[0] = t/pi;
            prove integral(t^2, t, 0, pi/3) = pi^3/81;
        }",
    );
}

#[test]
fn quotients() {
    as_declared(
        "family Quotients {
            domain 0 <= t <= 1;
            shape 0 < c, 1 <= k <= 2;
            b[0] = 1/(c + t);
            prove integral(b[0]^2) = 1/(c*(c + 1));
            prove integral(t/(1 + t^2)^2) = 1/4;
            prove integral((1 - t^2)/(1 + t^2)^2) = 1/2;
            prove integral(1/(1 + t)^3) = 3/8;
            refute integral(1/(1 + t)^3) = 1/4;
            prove integral((2*t + k)/(t^2 + k*t + 1)^2) = 1 - 1/(2 + k);
            prove integral(t^2 + 1/(1 + t)^2, t, 0, 1/2) = 3/8;
            prove integral(t^2*(3 + 2*t)/(1 + t)^2) = 1/2;
            refute integral(t^2*(3 + 2*t)/(1 + t)^2) = 1/3;
            prove D(integral(b[0]^2), c) <= 0;
        }
        family Box {
            domain 0 <= x <= 1, 0 <= y <= 1;
            b[0] = x*y;
            prove integral(1/(1 + x + y)^3) = 1/6;
            prove integral(y/(1 + x)^2, x, 0, 1) = y/2;
        }
        family Spans {
            domain -1 <= t <= 0, 0 <= t <= 1;
            b[0] = 1/(2 + t)^2 | 1/(2 - t)^2;
            prove integral(b[0]) = 1;
        }",
    );
    let no = |domain: &str, claim: &str| errors(&format!("domain {domain}; b[0] = t; prove {claim};"));
    for f in ["1/(1 + t)", "1/(1 + t^2)", "(1 + t^2)/(1 + t)^2", "t/(1 + t)^2"] {
        let error = no("0 <= t <= 1", &format!("integral({f}) = 1"));
        assert!(error.contains("the integral is not a rational number or function"), "{f}: {error}");
    }
    // A pole between the bounds, at an end, or perhaps.
    for (domain, f, what) in [
        ("0 <= t <= 1", "integral(1/(2*t - 1)^2)", "vanishes at t = 1/2"),
        ("0 < t <= 1", "integral(1/t^2)", "the integral diverges"),
        ("1 <= t <= 2", "integral(1/t^2, t, -1, 1)", "may have a pole"),
    ] {
        let error = no(domain, &format!("{f} = 1"));
        assert!(error.contains(what), "{f}: {error}");
    }
}
