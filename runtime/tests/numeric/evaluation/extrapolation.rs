//! Outside of the domain the polynomial is continued.

use basis_runtime::Curve;

use crate::families::{Bernstein7, QuadraticLagrange, QuarticBernstein};
use crate::reference::{evaluate, quartic};

#[test]
fn continues_the_polynomial() {
    let curve = Curve::new(QuadraticLagrange::new(), [3.0, 7.0, -1.0]); // 7 - 2 t - 6 t²
    assert_eq!(curve.eval(2.0), -21.0);
    assert_eq!(curve.eval(-3.0), -41.0);

    let points = [1.0, -2.0, 0.5, 3.0];
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), points);
    for t in [-2.0, -0.5, 1.25, 3.0] {
        let exact: f64 = quartic(0.5).iter().zip(points).map(|(b, p)| evaluate(b, t) * p).sum();
        assert!((curve.eval(t) - exact).abs() <= 1e-12 * exact.abs(), "{t}");
    }
}

#[test]
fn continues_the_bernstein_form() {
    let line = Curve::new(Bernstein7::new(), core::array::from_fn(|k| k as f64));
    for t in [-2.0, -0.5, 1.25, 3.0] {
        assert!((line.eval(t) - 7.0 * t).abs() < 1e-9, "{t}: {}", line.eval(t));
    }
}
