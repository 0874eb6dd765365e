//! Curves that continue a curve: the formulas that the engine derives for each family, beside elimination, which knows
//! nothing of them, and beside the derivatives of the curves that they make.

use basis_runtime::{__private::end_points, Array, Contact, Curve, CurveError, Point, Scalar};
use basis_test_support::cases;
use basis_tests::each_family;
use basis_tests::exact::epsilon;
use basis_tests::families::{
    BetaSpline, CubicBSpline, CubicHermite, QuadraticBezier, QuarticBernstein, Shipped, Smootheststep,
};
use basis_tests::random::Random;

fn size<P: Point>(points: &[P]) -> f64 {
    let components = points.iter().flat_map(|p| (0..P::DIM).map(|d| p.component(d).to_f64().abs()));
    components.fold(0.0, f64::max)
}

/// The derivatives of a curve at an end are those that were asked for; returns how many cases have a solution.
fn derivatives_are_met<B: Shipped>(rounds: usize, met: &mut usize) {
    let (reference, random) = (B::reference(), &mut Random::new(21));
    for round in 0..cases(rounds) {
        let basis = B::with(&reference.shape(random)).expect("inside the range");
        let free = B::Points::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let wanted: [[B::Scalar; 2]; 3] =
            core::array::from_fn(|_| core::array::from_fn(|_| random.between(-1.0, 1.0)));
        let at_end = round % 2 == 1;
        for count in 1..=3.min(B::LEN) {
            let wanted = &wanted[..count];
            let solve = if at_end { B::end_points } else { B::start_points };
            let Ok(points) = solve(&basis, wanted, free) else { continue };
            *met += 1;
            let curve: &[[B::Scalar; 2]] = points.as_ref();
            let mut scale = size(curve).max(1.0);
            for (k, wanted) in wanted.iter().enumerate() {
                let weights = basis.derivatives(B::domain()[usize::from(at_end)], k);
                let largest = weights.as_ref().iter().map(|w| w.to_f64().abs()).fold(1.0, f64::max);
                let found = curve.iter().zip(weights.as_ref());
                let found = found.fold([B::Scalar::ZERO; 2], |sum, (&p, &w)| sum.add_weighted(p, w));
                let error = size(&[found.add_weighted(*wanted, -B::Scalar::ONE)]);
                assert!(error <= 1e3 * epsilon::<B::Scalar>() * scale * largest, "{basis:?} {k}: {error:e}");
            }
            // Elimination replaces the outermost points; a formula may replace others where those do not matter.
            if let Ok(eliminated) = end_points(&basis, wanted, free, at_end) {
                scale = scale.max(size(eliminated.as_ref()));
                for (&a, &b) in curve.iter().zip(eliminated.as_ref()) {
                    let error = size(&[a.add_weighted(b, -B::Scalar::ONE)]);
                    assert!(error <= 1e6 * epsilon::<B::Scalar>() * scale, "{basis:?}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn derivatives_are_met_in_f32_and_f64() {
    let mut met = 0;
    each_family!(f32, derivatives_are_met, 60, &mut met);
    each_family!(f64, derivatives_are_met, 60, &mut met);
    // All but a few families have solutions for all three orders.
    assert!(met > 2 * cases(60) * 70, "{met}");
}

const P: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];

fn error<B: Shipped<Scalar = f64>>(shape: &[f64], contact: Contact<f64>) -> CurveError {
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), P);
    let free = B::Points::from_fn(|_| [0.0; 2]);
    B::with(shape).unwrap().curve_after(&curve, contact, free).unwrap_err()
}

#[test]
fn errors_name_the_shape_value() {
    let (g1, g2) = (Contact::Tangent { f: 2.0 }, Contact::Curvature { f: 2.0, c: 1.0 });
    let join = |family, conditions, at| CurveError::Join { family, conditions, at };
    assert_eq!(error::<QuarticBernstein>(&[-3.0], g1), join("QuarticBernstein", 2, "λ = -3"));
    assert_eq!(error::<QuarticBernstein>(&[-3.0], g2), join("QuarticBernstein", 3, "λ = -3"));
    assert_eq!(error::<QuadraticBezier>(&[-2.0], g1), join("QuadraticBezier", 2, "λ = -2"));
    assert_eq!(error::<QuadraticBezier>(&[1.0], g2), join("QuadraticBezier", 3, "λ = 1"));
    let text = error::<QuadraticBezier>(&[-2.0], g2).to_string();
    assert_eq!(
        text,
        "QuadraticBezier at λ = -2: the control points do not determine 3 derivatives at this end; choose other \
         shape values or a lower order of contact"
    );
    // Its derivatives at the ends are zero for all control points.
    assert_eq!(error::<Smootheststep>(&[], g1), join("Smoothstep(5)", 2, ""));
    assert_eq!(
        error::<QuarticBernstein>(&[0.0], Contact::Tangent { f: -1.0 }),
        CurveError::Factor { name: "f", value: -1.0 }
    );
    // Next to the exception there is a solution: Q1 = P3 + P'(1)/(f (2 + λ)).
    let step = 4.0 * f64::EPSILON;
    let near = QuadraticBezier::new(-2.0 + step).unwrap();
    let curve = Curve::new(QuarticBernstein::new(0.5).unwrap(), P);
    let next = near.curve_after(&curve, g1, [[0.0; 2]; 3]).unwrap();
    assert_eq!(next.control_points()[..2], [[4.0, 0.0], [4.0 + 1.75 / step, -3.5 / step]]);
}

#[test]
fn methods_of_types() {
    // G1 of a quadratic curve after a quartic one: f Q'(0) = P'(1), (2 + λ)(Q1 - Q0) = (3 + λ)(P3 - P2)/f.
    let curve = Curve::new(QuarticBernstein::new(1.0).unwrap(), P);
    let next = QuadraticBezier::new(0.0).unwrap();
    let next = next.curve_after(&curve, Contact::Tangent { f: 2.0 }, [[9.0; 2]; 3]).unwrap();
    assert_eq!(next.control_points(), [[4.0, 0.0], [5.0, -2.0], [9.0, 9.0]]);
    // A B-spline is continued by shifting its control points.
    let spline = Curve::new(CubicBSpline::new(), P);
    let (c2, free) = (Contact::Parametric { order: 2 }, [[7.0, -1.0]; 4]);
    let after = CubicBSpline::new().curve_after(&spline, c2, free).unwrap();
    assert!(size_of_difference(after.control_points(), [P[1], P[2], P[3], free[3]]) < 1e-14);
    let before = CubicBSpline::new().curve_before(&spline, c2, free).unwrap();
    assert!(size_of_difference(before.control_points(), [free[0], P[0], P[1], P[2]]) < 1e-14);
    // Hermite's control points are values and derivatives at the ends.
    let hermite = CubicHermite::new().curve_after(&spline, Contact::Parametric { order: 1 }, free).unwrap();
    let [end, velocity] = spline.eval_with_derivs(1.0);
    assert!(size_of_difference(hermite.control_points(), [end, velocity, free[2], free[3]]) < 1e-14);
    // Tension moves the points of a beta-spline, not its continuity.
    let beta = BetaSpline::new(2.0, 3.0).unwrap();
    let curve = Curve::new(beta, P);
    let next = beta.curve_after(&curve, c2, free).unwrap();
    assert_eq!(curve.joint(&next).parametric_order(1e-12, [1e-12, 1e-12, 0.0]), Some(2));
}

fn size_of_difference(a: &[[f64; 2]], b: [[f64; 2]; 4]) -> f64 {
    let differences: Vec<[f64; 2]> = a.iter().zip(b).map(|(a, b)| a.add_weighted(b, -1.0)).collect();
    size(&differences)
}
