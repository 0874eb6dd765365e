//! The tools for polynomials in Bernstein form agree with values of the polynomials.

use basis_runtime::bernstein;

use crate::random::Random;

const DEGREES: [usize; 8] = [0, 1, 2, 3, 4, 7, 13, 30];

fn points(degree: usize, random: &mut Random) -> Vec<[f64; 2]> {
    (0..=degree).map(|_| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]).collect()
}

fn assert_near(a: [f64; 2], b: [f64; 2]) {
    assert!((a[0] - b[0]).abs() < 2e-14 && (a[1] - b[1]).abs() < 2e-14, "{a:?} {b:?}");
}

#[test]
fn halves_continue_each_other() {
    let random = &mut Random::new(91);
    for degree in DEGREES {
        let whole = points(degree, random);
        let x = random.between(0.0, 1.0);
        let (mut left, mut right) = (whole.clone(), whole.clone());
        bernstein::split(&mut left, x, &mut right);
        assert_eq!(left.last(), right.first());
        assert_eq!((left.first(), right.last()), (whole.first(), whole.last()));
        for y in [0.1, 0.5, 0.75] {
            assert_near(bernstein::eval(&left, y), bernstein::eval(&whole, x * y));
            assert_near(bernstein::eval(&right, y), bernstein::eval(&whole, x + (1.0 - x) * y));
        }
        let (mut kept, mut rest) = (whole.clone(), whole);
        bernstein::keep_left(&mut kept, x);
        bernstein::keep_right(&mut rest, x);
        assert_eq!((kept, rest), (left, right));
    }
}

#[test]
fn parts_in_both_directions() {
    let random = &mut Random::new(92);
    for degree in DEGREES {
        let whole = points(degree, random);
        for _ in 0..20 {
            let (from, to) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
            let mut part = whole.clone();
            bernstein::restrict(&mut part, from, to);
            for y in [0.0, 0.3, 1.0] {
                assert_near(bernstein::eval(&part, y), bernstein::eval(&whole, from + (to - from) * y));
            }
        }
        let mut same = whole.clone();
        bernstein::restrict(&mut same, 0.0, 1.0);
        assert_eq!(same, whole);
        bernstein::restrict(&mut same, 1.0, 0.0);
        assert!(same.iter().eq(whole.iter().rev()));
    }
}

#[test]
fn elevation_keeps_the_curve_and_its_ends() {
    let random = &mut Random::new(93);
    for degree in DEGREES {
        let curve = points(degree, random);
        let mut elevated = vec![[f64::NAN; 2]; degree + 5];
        bernstein::elevate(&curve, &mut elevated);
        assert_eq!((curve.first(), curve.last()), (elevated.first(), elevated.last()));
        for x in [0.2, 0.5, 0.9] {
            assert_near(bernstein::eval(&elevated, x), bernstein::eval(&curve, x));
        }
    }
    let mut nothing = [7.0];
    bernstein::elevate(&[], &mut nothing);
    assert_eq!(nothing, [0.0]);
}

#[test]
fn derivatives_by_differences() {
    // x³ has the Bernstein coefficients 0, 0, 0, 1.
    let mut derivatives = [f64::NAN; 5];
    bernstein::eval_with_derivs(&[0.0, 0.0, 0.0, 1.0], 0.5, &mut [0.0; 4], &mut derivatives);
    assert_eq!(derivatives, [0.125, 0.75, 3.0, 6.0, 0.0]);
}

#[test]
fn products_of_all_degrees() {
    let random = &mut Random::new(94);
    for m in DEGREES {
        for n in DEGREES {
            let (p, q) = (points(m, random), points(n, random));
            let mut product = vec![f64::NAN; m + n + 1];
            bernstein::dot(&p, &q, &mut product);
            for x in [0.0, 0.3, 0.5, 1.0] {
                let ([a, b], [c, d]) = (bernstein::eval(&p, x), bernstein::eval(&q, x));
                let expected = a * c + b * d;
                assert!((bernstein::eval(&product, x) - expected).abs() < 2e-14, "{m} {n} {x}");
            }
        }
    }
}

#[test]
fn bounds_hold_everything_but_nan() {
    assert_eq!(bernstein::bounds(&[1.0, -2.0, 5.0]), [-2.0, 5.0]);
    assert_eq!(bernstein::bounds::<f64>(&[]), [0.0, 0.0]);
    assert!(bernstein::bounds(&[1.0, f64::NAN, 5.0])[1].is_nan());
}
