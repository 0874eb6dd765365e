//! Families with sines and exponentials: the generated types, and the curves over them, beside values of mpmath.

mod reach;

use basis_runtime::{Array, CurveError, ParametricCurve, RationalBasis, Scalar, basis};
use basis_tests::exact::epsilon;
use serde_json::Value;

basis!(library "trigonometric/han");
basis!(
    library "trigonometric/end_angle",
    CBezierQuadratic, HBezierQuadratic, ExponentialLine, TrigonometricBBasis(2), ExponentialBernstein(3)
);

basis! {
    family HalfTurn {
        domain 0 <= t <= pi;
        b[0] = 1 - t/pi;
        b[1] = t/pi;
        prove partition_of_unity;
        prove nonnegative;
    }
    family Hat {
        domain -pi <= t <= 0, 0 <= t <= pi;
        b[0] = 1 + t/pi | 1 - t/pi;
        prove smooth(0);
        prove nonnegative;
    }
}

/// Golden values of one scalar type; written by `golden.py`.
fn golden(scalar: &str) -> Vec<Value> {
    let all: Value = serde_json::from_str(include_str!("golden.json")).expect("it is JSON");
    all[scalar].as_array().expect("a list").clone()
}

/// A float, which is written as its bits.
fn float(bits: &Value) -> f64 {
    f64::from_bits(bits.as_u64().expect("a whole number"))
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

/// Values to within some ε of themselves, derivatives of the largest of their order.
fn check<B: RationalBasis>(basis: &B, points: &Value, ulps: f64, worst: &mut f64) {
    let eps = epsilon::<B::Scalar>();
    let mut sliced = 0.0;
    check_slices(basis, points, &mut sliced);
    println!("{} in slices: {sliced:.1} ε", B::NAME);
    for point in points.as_array().expect("a list") {
        let t = B::Scalar::of(float(&point[0]));
        for (k, (got, exact)) in basis.values(t).as_ref().iter().zip(numbers(&point[1][0])).enumerate() {
            assert!(*got >= B::Scalar::ZERO, "{} b[{k}]({t}) = {got}", B::NAME);
            let error = (got.to_f64() - exact).abs() / exact / eps;
            // What is below the normal floats has no relative accuracy.
            if exact > B::Scalar::MIN_POSITIVE.to_f64() {
                *worst = worst.max(error);
                assert!(error <= ulps, "{} b[{k}]({t}) = {got} for {exact}, off by {error} ε", B::NAME);
            }
        }
        for order in 1..3 {
            let exact = numbers(&point[1][order]);
            let size = exact.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            for (got, exact) in basis.derivatives(t, order).as_ref().iter().zip(exact) {
                let error = (got.to_f64() - exact).abs() / size / eps;
                assert!(
                    error <= 400.0,
                    "{} order {order} at {t}: {got} for {exact}, off by {error} ε",
                    B::NAME
                );
            }
        }
    }
}

/// The values once more, as points of curves in slices.
fn check_slices<B: RationalBasis>(basis: &B, points: &Value, worst: &mut f64) {
    const ULPS: f64 = 16.0;
    let points = points.as_array().expect("a list");
    let ts: Vec<B::Scalar> = points.iter().map(|p| B::Scalar::of(float(&p[0]))).collect();
    // A tile and a part of the next one.
    let ts: Vec<B::Scalar> = ts.iter().copied().cycle().take(ts.len().max(100)).collect();
    for k in 0..B::LEN {
        let one = |i| if i == k { B::Scalar::ONE } else { B::Scalar::ZERO };
        let curve = basis.curve(B::Points::from_fn(one));
        let mut out = vec![B::Scalar::NAN; ts.len()];
        curve.eval_into(&ts, &mut out).expect("as many points as parameters");
        let short = CurveError::Length { expected: ts.len(), found: 1 };
        assert_eq!(curve.eval_into(&ts, &mut out[..1]), Err(short));
        for ((got, t), point) in out.iter().zip(&ts).zip(points.iter().cycle()) {
            let exact = numbers(&point[1][0])[k];
            if exact > B::Scalar::MIN_POSITIVE.to_f64() {
                let error = (got.to_f64() - exact).abs() / exact / epsilon::<B::Scalar>();
                *worst = worst.max(error);
                assert!(error <= ULPS, "{} b[{k}]({t}) = {got} for {exact}, off by {error} ε", B::NAME);
            }
        }
    }
}

fn families<S: Scalar>(scalar: &str) {
    let mut seen = Vec::new();
    for case in golden(scalar) {
        let name = case["family"].as_str().expect("a name");
        let shape: Vec<S> =
            case["shape"].as_array().expect("a list").iter().map(|x| S::of(float(x))).collect();
        let points = &case["points"];
        let mut worst = 0.0;
        match (name, &shape[..]) {
            ("QuadraticTrigonometric", &[λ]) => {
                check(&QuadraticTrigonometric::new(λ).expect("inside"), points, 10.0, &mut worst);
            }
            ("CubicTrigonometricBezier", &[λ, μ]) => {
                check(&CubicTrigonometricBezier::new(λ, μ).expect("inside"), points, 10.0, &mut worst);
            }
            ("CBezierQuadratic", &[α]) => {
                check(&CBezierQuadratic::new(α).expect("inside"), points, 10.0, &mut worst);
            }
            ("TrigonometricBBasis", &[α]) => {
                check(&TrigonometricBBasis::new(α).expect("inside"), points, 10.0, &mut worst);
            }
            ("HBezierQuadratic", &[α]) => {
                check(&HBezierQuadratic::new(α).expect("inside"), points, 10.0, &mut worst);
            }
            ("ExponentialLine", []) => check(&ExponentialLine::<S>::new(), points, 10.0, &mut worst),
            ("ExponentialBernstein", &[α]) => {
                check(&ExponentialBernstein::new(α).expect("inside"), points, 10.0, &mut worst);
            }
            _ => panic!("{name} is not tested"),
        }
        println!("{scalar} {name} {shape:?}: {worst:.1} ε");
        seen.push(name.to_string());
    }
    seen.dedup();
    assert_eq!(seen.len(), 7);
}

#[test]
fn values_keep_their_digits_next_to_both_ends() {
    families::<f32>("f32");
    families::<f64>("f64");
}

/// At the floats that stand for the ends.
#[test]
fn the_ends_are_exact() {
    let family = CubicTrigonometricBezier::<f64>::new(0.5, -1.0).expect("inside");
    let [lo, hi] = family.domain();
    assert_eq!([lo, hi], [0.0, core::f64::consts::FRAC_PI_2]);
    assert_eq!([family.values(lo), family.values(hi)], [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]);
    let points = [[0.0, 3.0], [0.1, 1.0], [1.0, 0.7], [3.0, 0.1]];
    let curve = family.curve(points);
    assert_eq!(
        [curve.start(), curve.eval(lo), curve.eval(hi), curve.end()],
        [points[0], points[0], points[3], points[3]]
    );
    assert!(CBezierQuadratic::<f64>::new(3.15).is_err() && CBezierQuadratic::<f64>::new(0.0).is_err());
    let message = CBezierQuadratic::<f64>::new(4.0).expect_err("too large").to_string();
    assert!(message.contains("0 < α < pi") && message.contains('4'), "{message}");
}

/// The unit circle: with its angle as the parameter everything is known.
#[test]
fn a_quarter_of_a_circle() {
    let curve = EllipticArc::<f64>::new().curve([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let half_pi = core::f64::consts::FRAC_PI_2;
    for k in 0..=32 {
        let t = half_pi * f64::from(k) / 32.0;
        let [[x, y], velocity, acceleration] = curve.eval_with_derivs(t);
        let (sin, cos) = t.sin_cos();
        let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 4e-15;
        assert!(
            near([x, y], [cos, sin]) && near(velocity, [-sin, cos]) && near(acceleration, [-cos, -sin]),
            "{t}"
        );
    }
    assert!((curve.arclen(1e-12) - half_pi).abs() < 1e-12);
    assert!((curve.inv_arclen(0.5, 1e-12) - 0.5).abs() < 1e-12);
    let nearest = curve.nearest([3.0, 4.0], 1e-12).expect("finite");
    assert!(
        (nearest.distance - 4.0).abs() < 1e-12 && (nearest.at - 0.8_f64.asin()).abs() < 1e-7,
        "{nearest:?}"
    );
    let [before, after] = curve.split(0.5).expect("inside");
    assert!(
        (before.arclen(1e-12) - 0.5).abs() < 1e-12 && (after.arclen(1e-12) - half_pi + 0.5).abs() < 1e-12
    );
    let part = curve.subsegment(1.0..0.25).expect("inside");
    assert!((part.arclen(1e-12) - 0.75).abs() < 1e-12 && (part.start()[0] - 1.0_f64.cos()).abs() < 1e-15);
    let [touch] = curve.plane_intersections([0.5, 0.0], [1.0, 0.0]).expect("finite").try_into().expect("one");
    assert!((touch.interval[0] - 0.5_f64.acos()).abs() < 1e-12);
    let direction = curve.tangent(1.25).expect("not a point");
    assert!((direction[0] + 1.25_f64.sin()).abs() < 1e-14);
    let polygon = curve.flatten(1e-3).expect("finite");
    assert!(polygon.len() > 4 && polygon.iter().all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-15));
    assert!(matches!(curve.split(half_pi), Err(CurveError::AtEnd { .. })));
    assert!(matches!(curve.split(1.6), Err(CurveError::Parameter { .. })));
}

/// Outside of the domain, and where a parameter is not a number, slices have what single points have.
#[test]
fn slices_go_on_outside_of_the_domain() {
    let curve = EllipticArc::<f64>::new().curve([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let mut ts: Vec<f64> = (0..200).map(|k| 1.5 * f64::from(k) / 199.0).collect();
    ts[70] = -0.25;
    ts[131] = 2.0;
    ts[150] = f64::NAN;
    ts[199] = core::f64::consts::FRAC_PI_2;
    let mut out = vec![[0.0; 2]; ts.len()];
    curve.eval_into(&ts, &mut out).expect("as many points as parameters");
    for (k, (point, t)) in out.iter().zip(&ts).enumerate() {
        let alone = curve.eval(*t);
        if k == 150 {
            assert!(point[0].is_nan() && point[1].is_nan());
        } else if [70, 131, 199].contains(&k) {
            assert_eq!(*point, alone, "{t}");
        } else {
            assert!(point.iter().zip(alone).all(|(got, one)| (got - one).abs() <= 4.0 * f64::EPSILON), "{t}");
        }
    }
}

/// Next to the knot the values of both spans, whatever the order of the parameters.
#[test]
fn slices_of_several_spans() {
    use core::f64::consts::PI;
    let curve = Hat::<f64>::new().curve([3.0]);
    let ts: Vec<f64> =
        (0..300).map(|k| PI * (f64::from((k * 37) % 300) / 149.5 - 1.0).clamp(-1.0, 1.0)).collect();
    for ts in [&ts[..], &{
        let mut sorted = ts.clone();
        sorted.sort_by(f64::total_cmp);
        sorted
    }] {
        let mut out = vec![0.0; ts.len()];
        curve.eval_into(ts, &mut out).expect("as many points as parameters");
        for (point, t) in out.iter().zip(ts) {
            assert!((point - curve.eval(*t)).abs() <= 4.0 * f64::EPSILON, "{t}");
        }
    }
}

/// From the parameter of the Bézier form and back.
#[test]
fn the_map_has_an_inverse() {
    fn both_ways<B: RationalBasis<Scalar = f64>>(basis: &B) {
        let (chart, [lo, hi]) = (basis.chart(), basis.domain());
        for k in 0..=64 {
            let t = lo + (hi - lo) * f64::from(k) / 64.0;
            let back = chart.parameter(chart.place(t));
            assert!((back - t).abs() <= 8.0 * f64::EPSILON * (hi - lo).max(1.0), "{} {t} {back}", B::NAME);
        }
        assert_eq!([chart.parameter(0.0), chart.parameter(1.0)], [lo, hi]);
    }
    both_ways(&CubicTrigonometricBezier::new(0.5, 0.5).expect("inside"));
    both_ways(&QuadraticTrigonometric::new(0.5).expect("inside"));
    both_ways(&ExponentialLine::new());
    for α in [1e-6, 0.25, 1.0, 2.5] {
        both_ways(&CBezierQuadratic::new(α).expect("inside"));
        both_ways(&HBezierQuadratic::new(α).expect("inside"));
    }
}

#[test]
fn polynomials_end_at_multiples_of_pi() {
    use core::f64::consts::{FRAC_1_PI, PI};
    for (t, share) in [(0.0, 0.0), (1.0, FRAC_1_PI), (PI / 2.0, 0.5), (PI, 1.0)] {
        let [left, right] = HalfTurn::new().values(t);
        assert!(
            (right - share).abs() <= 1e-15 && (left - (1.0 - share)).abs() <= 1e-15,
            "{t}: {left}, {right}"
        );
        for side in [-t, t] {
            let [hat] = Hat::new().values(side);
            assert!((hat - (1.0 - share)).abs() <= 1e-15 && hat >= 0.0, "{side}: {hat}");
        }
    }
    let slope = HalfTurn::new().derivatives(1.0, 1);
    assert!((slope[1] - FRAC_1_PI).abs() <= 1e-15 && (slope[0] + FRAC_1_PI).abs() <= 1e-15);
}

basis! {
    /// tan(α/2) at the end of the range of α is the root of 3.
    family ThirdOfATurn {
        shape 0 < α <= 2*pi/3;
        domain 0 <= t <= α;
        b[0] = (1 - cos(α - t))/(1 - cos(α));
        b[1] = 1 - b[0] - b[2];
        b[2] = (1 - cos(t))/(1 - cos(α));
        prove nonnegative;
        prove cos(α) >= -1/2;
    }
}

#[test]
fn the_end_of_a_range_may_have_an_irrational_tangent() {
    let end = 2.0 * core::f64::consts::FRAC_PI_3;
    let basis = ThirdOfATurn::new(end).expect("the end belongs to the range");
    for (value, third) in basis.values(end / 2.0).iter().zip([1.0 / 3.0; 3]) {
        assert!((value - third).abs() < 4e-16, "{value}");
    }
    assert!(ThirdOfATurn::new(end + 1e-15).is_err());
    assert!(ThirdOfATurn::new(0.0).is_err());
}

basis! {
    /// sin(π/4) at the end of the domain.
    family HalfAngles {
        domain 0 <= t <= pi/2;
        b[0] = cos(t/2) - sin(t/2);
        b[1] = 2*sin(t/2)*(cos(t/2) - sin(pi/4));
        b[2] = 1 - b[0] - b[1];
        prove b[0] >= 0;
        prove b[1] >= 0;
    }
}

/// The functions vanish at the ends themselves, and keep their digits next to them: b[0] is √2·sin((π/2 − t)/2).
#[test]
fn the_end_of_a_domain_may_have_an_irrational_tangent() {
    use core::f64::consts::{FRAC_PI_2, SQRT_2};
    let basis = HalfAngles::<f64>::new();
    assert_eq!(basis.values(0.0), [1.0, 0.0, 0.0]);
    let [first, second, last] = basis.values(FRAC_PI_2);
    assert!(first == 0.0 && second == 0.0 && (last - 1.0).abs() <= 8.0 * f64::EPSILON, "{last}");
    for k in 1..40 {
        let rest = FRAC_PI_2 * 0.5_f64.powi(k);
        let [first, second, _] = basis.values(FRAC_PI_2 - rest);
        // π/2 is larger than its float.
        let rest = FRAC_PI_2 - (FRAC_PI_2 - rest) + 6.123_233_995_736_766e-17;
        let exact = SQRT_2 * (0.5 * rest).sin();
        assert!((first - exact).abs() <= 8.0 * f64::EPSILON * exact, "{k}: {first}, {exact}");
        assert!(second > 0.0);
    }
}
