//! Families on several spans, and on domains without an end: the generated types and the curves over them.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_runtime::{CurveError, ParametricCurve, RationalBasis, SpannedBasis, basis};
use basis_tests::exact::{Reference, fraction};
use basis_tests::random::Random;

basis!(library "splines/kernels");

basis! {
    /// A quadratic spline function over knots of any distances.
    family Knots {
        shape 0 < d, 0 < e;
        domain 0 <= x <= d, d <= x <= d + e;
        b[0] = x^2/(d*(d + e)) | 1 - b[1];
        b[1] = 1 - x^2/(d*(d + e)) | (d + e - x)^2/(e*(d + e));
        prove partition_of_unity;
        prove nonnegative;
        prove smooth(1);
        refute smooth(2);
    }

    /// A quarter of a circle and a rational curve: each span has a denominator of its own.
    family Mixture {
        domain 0 <= t <= 1, 1 <= t <= 3;
        b[0] = (1 - t^2)/(1 + t^2) | (1 - t)/2;
        b[1] = 2*t/(1 + t^2) | 1 + (t - 1)/t;
    }

    /// Without its upper end, at which it is infinite.
    family Tangent {
        domain 0 <= t < pi/2;
        b[0] = tan(t);
        b[1] = 1;
    }

    /// Without its lower end.
    family Inverse {
        domain 0 < t <= 2;
        b[0] = 1/t;
        b[1] = t;
    }
}

/// The functions of each span at points of it, and at the knots those of the later one.
fn agree<B: SpannedBasis<Scalar = f64>>(basis: &B, name: &str, shape: &[f64]) {
    let family = Reference::new("splines/kernels.basis", name, &[]).family;
    let random = &mut Random::new(4);
    let charts = basis.charts();
    for (k, piece) in family.pieces.iter().enumerate() {
        let [lo, hi] = charts.as_ref()[k].domain();
        for x in [0.0, 1e-9, 0.25, random.unit::<f64>(), 1.0 - 1e-9] {
            let t = lo + (hi - lo) * x;
            assert_eq!(basis.span_at(t), k, "{name} at {t}");
            let mut point: Vec<Rational> = shape.iter().map(|value| fraction(*value)).collect();
            point.push(fraction(t));
            for (got, f) in basis.values(t).as_ref().iter().zip(&piece.functions) {
                let exact = f.value.eval(&point).expect("a polynomial");
                let error = (fraction(*got) - exact.clone()).to_f64().abs();
                assert!(error <= 8.0 * f64::EPSILON, "{name} at {t}: {got} for {}", exact.to_f64());
            }
        }
    }
}

#[test]
fn values_are_those_of_the_span() {
    agree(&Keys::new(-0.5).expect("inside"), "Keys", &[-0.5]);
    agree(&MitchellNetravali::new(0.25, 0.375).expect("inside"), "MitchellNetravali", &[0.25, 0.375]);
    agree(&Dodgson::<f64>::new(), "Dodgson", &[]);
}

#[test]
fn knots_belong_to_the_later_span() {
    let keys = Keys::new(-0.5).expect("inside");
    assert_eq!(keys.domain(), [-2.0, 2.0]);
    assert_eq!([-2.0, -1.0, 0.0, 1.0, 2.0].map(|x| keys.values(x)[0]), [0.0, 0.0, 1.0, 0.0, 0.0]);
    assert_eq!([-2.5, -1.0, -0.5, 0.0, 1.0, 2.0, 7.0].map(|x| keys.span_at(x)), [0, 1, 1, 2, 3, 3, 3]);
    // The first derivative is continuous, the second jumps at ±1 from 2a to 2(a + 3) - 6(a + 2)… of the other formula.
    assert_eq!([-1.0, 0.0, 1.0].map(|x| keys.derivatives(x, 1)[0]), [0.5, 0.0, -0.5]);
    let second = |x: f64| keys.derivatives(x, 2)[0];
    assert!(
        (second(1.0) - second(1.0 + 1e-9)).abs() < 1e-6 && (second(1.0) - second(1.0 - 1e-9)).abs() > 1.0
    );
    assert!(keys.values(f64::NAN)[0].is_nan());
}

/// Knots that are shape values are the floats that they are computed as.
#[test]
fn knots_may_be_shape_values() {
    for (d, e) in [(1.0_f64, 1.0_f64), (0.1, 0.2), (3.0, 1e-3)] {
        let family = Knots::new(d, e).expect("positive");
        assert_eq!(family.domain(), [0.0, d + e]);
        assert_eq!([family.span_at(d), family.span_at(d * (1.0 - 1e-15))], [1, 0]);
        for x in [0.0, d / 3.0, d, d + e / 7.0, d + e] {
            let second =
                if x < d { 1.0 - x * x / (d * (d + e)) } else { (d + e - x).powi(2) / (e * (d + e)) };
            let [got, other] = [family.values(x)[1], family.values(x)[0]];
            assert!((got - second).abs() < 1e-14 && (got + other - 1.0).abs() < 1e-15, "{d} {e} {x}: {got}");
        }
        assert_eq!(family.values(d + e), [1.0, 0.0]);
    }
    assert!(Knots::new(1.0, 0.0).is_err());
}

/// Of sines on two spans.
#[test]
fn spans_may_hold_angles() {
    let bump = Bump::<f64>::new();
    for t in [-3.0, -1.0, -1e-9, 0.0, 0.5, 3.1] {
        let [exact, slope] = [0.5 + 0.5 * f64::cos(t), -0.5 * f64::sin(t)];
        assert!((bump.values(t)[0] - exact).abs() < 1e-15, "{t}");
        assert!((bump.derivatives(t, 1)[0] - slope).abs() < 1e-14, "{t}");
    }
    let [lo, hi] = bump.domain();
    assert_eq!([lo, hi], [-core::f64::consts::PI, core::f64::consts::PI]);
    assert_eq!([bump.values(lo), bump.values(0.0), bump.values(hi)], [[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]);
}

/// A curve of two spans: a quarter of the unit circle, and a curve that leaves from its end.
#[test]
fn curves_over_spans() {
    let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 1e-14;
    let curve = Mixture::<f64>::new().curve([[1.0, 0.0], [0.0, 1.0]]);
    assert_eq!((curve.domain(), curve.start(), curve.eval(1.0)), ([0.0, 3.0], [1.0, 0.0], [0.0, 1.0]));
    assert!(near(curve.end(), [-1.0, 1.0 + 2.0 / 3.0]));
    let [_, before] = curve.spans()[0].eval_with_derivs(1.0);
    let [_, after] = curve.eval_with_derivs(1.0);
    assert!((before[0] + 1.0).abs() < 1e-15 && (after[0] + 0.5).abs() < 1e-15, "{before:?} {after:?}");
    // The length of a quarter of a circle, and of the rest by its polygon.
    let steps = 100_000;
    let point = |k: usize| curve.eval(1.0 + 2.0 * k as f64 / f64::from(steps));
    let rest: f64 = (0..steps as usize)
        .map(|k| {
            let ([a, b], [c, d]) = (point(k), point(k + 1));
            (c - a).hypot(d - b)
        })
        .sum();
    let length = core::f64::consts::FRAC_PI_2 + rest;
    assert!((curve.arclen(1e-9) - length).abs() < 1e-8);
    assert!((curve.inv_arclen(core::f64::consts::FRAC_PI_2, 1e-9) - 1.0).abs() < 1e-8);
    let nearest = curve.nearest([3.0, 4.0], 1e-9).expect("finite");
    assert!((nearest.point[0] - 0.6).abs() < 1e-6 && (nearest.at - 0.5).abs() < 1e-6, "{nearest:?}");
    let nearest = curve.nearest([-2.0, 3.0], 1e-9).expect("finite");
    assert_eq!((nearest.at, nearest.point), (3.0, curve.end()));
    for at in [0.5, 1.0, 2.0] {
        let [first, second] = curve.split(at).expect("inside");
        assert!(near(first.start(), curve.start()) && near(first.end(), curve.eval(at)), "{at}");
        assert!(near(second.start(), curve.eval(at)) && near(second.end(), curve.end()), "{at}");
        assert!((first.arclen(1e-9) + second.arclen(1e-9) - length).abs() < 1e-8, "{at}");
    }
    for (from, to) in [(0.25, 0.5), (0.25, 1.0), (0.5, 2.5), (1.0, 3.0), (1.5, 2.5), (2.5, 0.5), (3.0, 0.0)] {
        let part = curve.subsegment(from..to).expect("inside");
        assert!(near(part.start(), curve.eval(from)) && near(part.end(), curve.eval(to)), "{from} {to}");
    }
    assert!(near(curve.reversed().start(), curve.end()));
    assert!(matches!(curve.split(3.0), Err(CurveError::AtEnd { .. })));
    assert!(matches!(curve.eval_checked(3.5), Err(CurveError::Parameter { .. })));
}

/// An end that does not belong to the domain is refused, and next to it values keep their digits.
#[test]
fn an_end_may_be_left_out() {
    let family = Tangent::<f64>::new();
    let [_, hi] = family.domain();
    for t in [1e-9, 0.5, 1.5, hi - 1e-9, hi.next_down()] {
        let [got, one] = family.values(t);
        assert!(
            (got / t.tan() - 1.0).abs() < 2e-15 && (one - 1.0).abs() < 1e-15,
            "{t}: {got} for {}",
            t.tan()
        );
    }
    assert!(
        !family.chart().contains(hi) && family.chart().contains(0.0) && !family.chart().contains(f64::NAN)
    );
    let curve = family.curve([[1.0, 0.0], [0.0, 1.0]]);
    assert!(curve.eval_checked(hi.next_down()).is_ok());
    assert!(matches!(curve.eval_checked(hi), Err(CurveError::Parameter { .. })));
    // Nothing bounds the curve: questions about all of it have no answer.
    assert!(curve.nearest([0.0, 0.0], 1e-9).is_none() && curve.arclen(1e-9).is_nan());

    let inverse = Inverse::<f64>::new();
    assert_eq!(inverse.values(0.5), [2.0, 0.5]);
    assert!((inverse.derivatives(0.25, 1)[0] + 16.0).abs() < 1e-12);
    let curve = inverse.curve([1.0, 0.0]);
    assert!(curve.eval_checked(0.0).is_err() && curve.eval_checked(2.0).is_ok());
}
