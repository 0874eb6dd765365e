//! Rational families: the generated types, and the curves over them, against exact values.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Poly, PolyExt, Var};
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::Family;
use basis_runtime::bspline::{KnotVector, NurbsCurve};
use basis_runtime::{
    CurveError, ParametricCurve, RationalBasis, RationalBezier, RationalCurve, Scalar, basis,
};
use basis_tests::exact::{Reference, epsilon, fraction};
use basis_tests::random::Random;

basis!(library "rational/bezier");

basis! {
    /// A denominator whose Bernstein coefficients are not all positive, a domain that is not the unit interval, and
    /// functions of which none vanishes at an end.
    family Bumps {
        domain -1 <= t <= 3;
        shape -1/2 <= λ <= 1/2;
        b[0] = (1 + λ*t)/(1 + 20*(t - 1)^2);
        b[1] = t^3/(2 + t^2);
        b[2] = 1 - b[0] - b[1];
        prove partition_of_unity;
        refute nonnegative;
    }
}

/// The value and three derivatives are compared.
const ORDERS: usize = 4;

/// The derivatives of a function at a point of shape values and t, exactly: those of its power series in t.
fn exact(f: &Fraction, var: Var, point: &[Rational]) -> [Rational; ORDERS] {
    let t = &point[var.0];
    let taylor = |p: &Poly| {
        let mut rest: Vec<Rational> = p.coefficients_in(var).iter().map(|c| c.eval(point)).collect();
        let series: [Rational; ORDERS] = core::array::from_fn(|k| {
            // Horner's scheme leaves the quotient by t - t0.
            for i in (k..rest.len().saturating_sub(1)).rev() {
                rest[i] = &rest[i] + &(&rest[i + 1] * t);
            }
            rest.get(k).cloned().unwrap_or(Rational::ZERO)
        });
        series
    };
    let (numer, denom) = (taylor(f.numer()), taylor(f.denom()));
    let mut series = numer;
    let mut factorial = Rational::ONE;
    for k in 0..ORDERS {
        for i in 1..=k {
            series[k] = &series[k] - &(&denom[i] * &series[k - i]);
        }
        series[k] = &series[k] / &denom[0];
    }
    for (k, term) in series.iter_mut().enumerate().skip(1) {
        factorial = &factorial * &Rational::from(k as i64);
        *term = &*term * &factorial;
    }
    series
}

/// Values are within some ε of the exact ones, relative to themselves; derivatives relative to the largest of them.
fn agree<B: RationalBasis>(basis: B, family: &Family, shape: &[B::Scalar]) {
    let eps = epsilon::<B::Scalar>();
    let [lo, hi] = basis.domain();
    let random = &mut Random::new(7);
    let width = (hi - lo).to_f64();
    let near = [0.0, 1e-6, 1e-3, random.unit::<f64>()];
    let inside = near.iter().flat_map(|x| [lo.to_f64() + width * x, hi.to_f64() - width * x]);
    for t in inside.map(B::Scalar::of) {
        let mut point: Vec<Rational> = shape.iter().map(|value| fraction(*value)).collect();
        point.push(fraction(t));
        let var = family.interval().expect("an interval").0;
        let all: Vec<_> = family.functions.iter().map(|f| exact(&f.value, var, &point)).collect();
        let exact = |order: usize| -> Vec<Rational> { all.iter().map(|f| f[order].clone()).collect() };
        for (k, (got, exact)) in basis.values(t).as_ref().iter().zip(exact(0)).enumerate() {
            let error = (fraction(*got) - exact.clone()).to_f64().abs();
            assert!(error <= 16.0 * eps * exact.to_f64(), "{} b[{k}]({t}) = {got}, off by {error}", B::NAME);
        }
        let all = basis.values_with_derivs::<ORDERS>(t);
        for (order, all) in all.into_iter().enumerate().skip(1) {
            let expected = exact(order);
            let size = expected.iter().fold(1.0, |size: f64, e| size.max(e.to_f64().abs()));
            let one = basis.derivatives(t, order);
            assert_eq!(one, all);
            for (got, exact) in one.as_ref().iter().zip(expected) {
                let error = (fraction(*got) - exact).to_f64().abs();
                assert!(
                    error <= 200.0 * eps * size,
                    "{} order {order} at {t}: {got}, off by {error}",
                    B::NAME
                );
            }
        }
    }
}

fn families<S: Scalar>() {
    let of = |name| Reference::new("rational/bezier.basis", name, &[]).family;
    let (conic, quadratic, cubic) = (of("Conic"), of("RationalQuadratic"), of("RationalCubic"));
    let random = &mut Random::new(3);
    for _ in 0..4 {
        let [a, b, c, d]: [S; 4] = core::array::from_fn(|_| random.between(0.1, 4.0));
        agree(Conic::new(b).expect("positive"), &conic, &[b]);
        agree(RationalQuadratic::new(a, b, c).expect("positive"), &quadratic, &[a, b, c]);
        agree(RationalCubic::new(a, b, c, d).expect("positive"), &cubic, &[a, b, c, d]);
    }
}

#[test]
fn values_and_derivatives_are_exact_up_to_rounding() {
    families::<f64>();
    families::<f32>();
}

/// No claim says that they are nonnegative, and nothing vanishes at the ends.
#[test]
fn other_denominators() {
    for λ in [-0.5, 0.0, 0.375] {
        let family = Bumps::new(λ).expect("inside");
        for t in [-1.0, -0.5, 0.0, 0.9375, 1.0, 2.5, 3.0] {
            let (first, second) =
                ((1.0 + λ * t) / (1.0 + 20.0 * (t - 1.0) * (t - 1.0)), t * t * t / (2.0 + t * t));
            for (got, expected) in family.values(t).into_iter().zip([first, second, 1.0 - first - second]) {
                assert!((got - expected).abs() <= 1e-14, "{λ} {t}: {got} for {expected}");
            }
            let u = 1.0 + 20.0 * (t - 1.0) * (t - 1.0);
            let slope = (λ * u - (1.0 + λ * t) * 40.0 * (t - 1.0)) / (u * u);
            assert!((family.derivatives(t, 1)[0] - slope).abs() <= 1e-12, "{λ} {t}");
        }
    }
    // The denominator has negative Bernstein coefficients: the pieces have not.
    let curve = Bumps::new(0.25).expect("inside").curve([[0.0, 1.0], [2.0, 0.0], [1.0, -1.0]]);
    let pieces = ParametricCurve::pieces(&curve);
    assert!(
        pieces.len() > 1 && pieces.iter().all(|p| p.weights().is_none_or(|w| w.iter().all(|w| *w > 0.0)))
    );
    // Its length, by the trapezoidal rule.
    let steps = 200_000;
    let point = |k: usize| curve.eval(-1.0 + 4.0 * k as f64 / f64::from(steps));
    let polygon: f64 = (0..steps as usize)
        .map(|k| {
            let ([a, b], [c, d]) = (point(k), point(k + 1));
            (c - a).hypot(d - b)
        })
        .sum();
    assert!((curve.arclen(1e-10) - polygon).abs() < 1e-7, "{} {polygon}", curve.arclen(1e-10));
}

/// The circle as a conic: what a curve answers is known exactly.
#[test]
fn a_quarter_of_a_circle() {
    let family = Conic::new(0.5_f64.sqrt()).expect("positive");
    let curve = RationalCurve::new(family, [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let half_pi = core::f64::consts::FRAC_PI_2;
    assert!((curve.arclen(1e-12) - half_pi).abs() < 1e-12);
    assert!((curve.inv_arclen(half_pi / 2.0, 1e-12) - 0.5).abs() < 1e-11);
    assert!((curve.curvature(0.3) - 1.0).abs() < 1e-13);
    let nearest = curve.nearest([3.0, 4.0], 1e-12).expect("finite");
    assert!((nearest.distance - 4.0).abs() < 1e-12 && nearest.at_least <= nearest.distance);
    assert!((nearest.point[0] - 0.6).abs() < 1e-7 && (nearest.point[1] - 0.8).abs() < 1e-7);
    assert_eq!(curve.bounding_box(), [[0.0, 0.0], [1.0, 1.0]]);
    let [first, rest] = curve.split(0.25).expect("inside");
    assert!((first.arclen(1e-12) + rest.arclen(1e-12) - half_pi).abs() < 1e-11);
    assert_eq!(first.end(), rest.start());
    assert!((first.eval(0.5)[0] - curve.eval(0.125)[0]).abs() < 1e-15);
    let back = curve.subsegment(0.75..0.25).expect("inside");
    assert!((back.eval(0.25)[1] - curve.eval(0.625)[1]).abs() < 1e-15);
    assert_eq!(curve.reversed().start(), curve.end());
    for corner in curve.flatten(1e-4).expect("finite") {
        assert!((corner[0].hypot(corner[1]) - 1.0).abs() < 1e-14);
    }
    assert!(matches!(curve.split(1.0), Err(CurveError::AtEnd { .. })));
    assert!(matches!(curve.eval_checked(1.5), Err(CurveError::Parameter { .. })));
    let line: &dyn ParametricCurve<Point = [f64; 2]> =
        &basis_runtime::Bezier::from_points([[0.0, 0.0], [1.0, 1.0]]);
    let [meeting] = curve.intersections(line, 1e-12).expect("finite").try_into().expect("one");
    assert!((meeting.point[0] - 0.5_f64.sqrt()).abs() < 1e-12);
}

/// From a family to NURBS and back, the weights being shape values.
#[test]
fn nurbs_and_families_are_the_same_curves() {
    let points = [[0.0, 0.0, 1.0], [1.0, 2.0, 0.0], [3.0, 2.0, -1.0], [4.0, 0.0, 0.5]];
    let weights = [1.0, 0.3, 2.0, 0.75];
    let [w0, w1, w2, w3] = weights;
    let curve = RationalCubic::new(w0, w1, w2, w3).expect("positive").curve(points);
    let bezier = curve.to_rational_bezier();
    assert_eq!((bezier.weights(), bezier.degree()), (&weights[..], 3));
    let nurbs = NurbsCurve::try_from(&bezier).expect("positive weights");
    assert_eq!(nurbs.weights(), weights);
    let nearly = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14);
    for k in 0..=16 {
        let t = f64::from(k) / 16.0;
        assert!(nearly(nurbs.eval(t), curve.eval(t)), "{t}");
    }
    // Two spans give two curves over the family.
    let knots = KnotVector::new(3, [0.0, 0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0, 1.0]).expect("clamped");
    let two = NurbsCurve::new(
        knots,
        [points[0], points[1], points[2], points[3], points[1]],
        [1.0, 2.0, 0.5, 1.0, 3.0],
    );
    let two = two.expect("five points");
    for part in two.to_rational_bezier() {
        let (points, w): (Vec<_>, _) = (part.control_points(), part.weights());
        let family = RationalCubic::new(w[0], w[1], w[2], w[3]).expect("positive");
        let own = family.curve([points[0], points[1], points[2], points[3]]);
        let [lo, hi] = part.domain();
        for k in 0..=8 {
            let x = f64::from(k) / 8.0;
            assert!(nearly(own.eval(x), two.eval(lo + (hi - lo) * x)), "{x}");
        }
    }
    assert!(matches!(RationalBezier::new([[0.0, 0.0]], [0.0]), Err(CurveError::Weight { index: 0, .. })));
    assert!(matches!(RationalBezier::new([[0.0, 0.0]], [1.0, 1.0]), Err(CurveError::Length { .. })));
}

/// Curves over rational families continue curves of any type.
#[test]
fn contacts() {
    use basis_runtime::Contact;

    let first = Conic::new(0.5_f64.sqrt()).expect("positive").curve([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    let family = RationalCubic::new(1.0, 2.0, 0.5, 3.0).expect("positive");
    let free = [[0.0, 0.0], [0.0, 0.0], [-2.0, 0.5], [-3.0, 1.0]];
    let near = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).abs() + (p[1] - q[1]).abs() < 1e-12;
    for f in [0.5, 1.0, 3.0] {
        let next = family.curve_after(&first, Contact::Tangent { f }, free).expect("it is determined");
        let ([end, arriving], [start, leaving]) = (first.eval_with_derivs(1.0), next.eval_with_derivs(0.0));
        assert!(near(start, end) && near(leaving.map(|x| f * x), arriving), "{f}");
        assert_eq!(next.control_points()[2..], free[2..]);
    }
    // A circle that goes on has the same curvature.
    let next =
        family.curve_after(&first, Contact::Curvature { f: 1.0, c: 0.0 }, free).expect("it is determined");
    assert!((next.curvature(0.0) - 1.0).abs() < 1e-10, "{}", next.curvature(0.0));
    let before =
        family.curve_before(&next, Contact::Parametric { order: 2 }, free).expect("it is determined");
    for (own, other) in before.eval_with_derivs::<3>(1.0).into_iter().zip(next.eval_with_derivs::<3>(0.0)) {
        assert!(near(own, other), "{own:?} {other:?}");
    }
    let order = family.curve_after(&first, Contact::Parametric { order: 4 }, free);
    assert!(matches!(order, Err(CurveError::Contact { most: 3, found: 4, .. })));
}
