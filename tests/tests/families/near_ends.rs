//! Values on the last floats before an end that is a sum of shape parameters, and of a family whose angle is nearly π: beside
//! values of mpmath with 60 digits, for the numbers that the floats are.
#![expect(clippy::unreadable_literal, clippy::excessive_precision, reason = "tables of numbers")]
#![expect(clippy::approx_constant, reason = "an angle next to π, not π itself")]

use basis_runtime::{Scalar, SpannedBasis, basis};
use basis_tests::exact::epsilon;

basis! {
    family Knots {
        shape 0 < d0, 0 < d1, 0 < d2;
        domain 0 <= x <= d0, d0 <= x <= d0 + d1, d0 + d1 <= x <= d0 + d1 + d2;
        let e = d0 + d1 + d2;
        f[0] = x^2/(d0*(d0 + d1))
             | x*(d0 + d1 - x)/((d0 + d1)*d1) + (e - x)*(x - d0)/((d1 + d2)*d1)
             | (e - x)^2/((d1 + d2)*d2);
        prove smooth(1);
    }
    family Angles {
        shape 0 < a < pi/3, 0 < c < pi/3, 0 < e < pi/3;
        domain 0 <= x <= a, a <= x <= a + c, a + c <= x <= a + c + e;
        let left = sin(x/2)*sin((a + c - x)/2)/sin((a + c)/2);
        let right = sin((a + c + e - x)/2)*sin((x - a)/2)/sin((c + e)/2);
        f[0] = sin(x/2)^2/(sin(a/2)*sin((a + c)/2))
             | (left + right)/sin(c/2)
             | sin((a + c + e - x)/2)^2/(sin(e/2)*sin((c + e)/2));
        prove smooth(1);
    }
    family Arc {
        shape 0 < α < pi;
        domain 0 <= t <= α;
        let p = sin((α - t)/2)/sin(α/2);
        let q = sin(t/2)/sin(α/2);
        let c = cos(α/2);
        b[0] = p^4;
        b[1] = 4*c*p^3*q;
        b[2] = (2 + 4*c^2)*p^2*q^2;
        b[3] = 4*c*p*q^3;
        b[4] = q^4;
        prove nonnegative;
    }
}

/// 20 units in the last place, half of which ε is.
fn assert_near<S: Scalar>(found: S, exact: f64, at: f64) {
    let error = ((found.to_f64() - exact) / exact).abs();
    assert!(
        error <= 10.0 * epsilon::<S>(),
        "{found:?} in place of {exact} at {at}: {} ε",
        error / epsilon::<S>()
    );
}

fn ends_that_are_sums<S: Scalar>(knots: &[(f64, f64)], angles: &[(f64, f64)]) {
    let of = |x: f64| S::of(x);
    let basis = Knots::new(of(0.1), of(2.0), of(0.7)).unwrap();
    for &(x, exact) in knots {
        assert_near(basis.values(of(x))[0], exact, x);
    }
    assert_eq!(basis.values(SpannedBasis::domain(&basis)[1])[0], S::ZERO);
    let basis = Angles::new(of(0.1), of(1.0), of(0.7)).unwrap();
    for &(x, exact) in angles {
        assert_near(basis.values(of(x))[0], exact, x);
    }
}

#[test]
fn next_to_an_end_that_is_a_sum() {
    ends_that_are_sums::<f32>(
        &[
            (2.799999713897705, 4.0208871780584187e-14),
            (2.799999475479126, 1.3983523633846699e-13),
            (2.799999237060547, 2.9961336817658093e-13),
        ],
        &[
            (1.7999998331069946, 2.3757025931833589e-14),
            (1.799999713897705, 7.3749134922176971e-14),
            (1.7999995946884155, 1.5132309714857102e-13),
        ],
    );
    ends_that_are_sums::<f64>(
        &[
            (2.7999999999999994, 1.7975346147614203e-31),
            (2.799999999999999, 5.5801017859600552e-31),
            (2.7999999999999985, 1.1449602568854489e-30),
        ],
        &[
            (1.7999999999999998, 1.8690190346762679e-32),
            (1.7999999999999996, 1.2634568674411571e-31),
            (1.7999999999999994, 3.2969495771689366e-31),
        ],
    );
}

fn nearly_half_a_turn<S: Scalar>(rows: &[(f64, [f64; 5])]) {
    let basis = Arc::new(S::of(3.14)).unwrap();
    for (t, row) in rows {
        for (found, exact) in basis.values(S::of(*t)).into_iter().zip(row) {
            assert_near(found, *exact, *t);
        }
    }
}

#[test]
fn where_an_angle_is_nearly_half_a_turn() {
    nearly_half_a_turn::<f32>(&[
        (
            0.0010000000474974513,
            [
                0.99999790745257346,
                1.5925465321270505e-6,
                5.0000043377230438e-7,
                3.9813730667524058e-13,
                6.2500080714358922e-14,
            ],
        ),
        (
            1.0,
            [
                0.59210140452558386,
                0.0010307207964117113,
                0.35372943226486793,
                0.00030788292090314508,
                0.052830559492233354,
            ],
        ),
    ]);
    nearly_half_a_turn::<f64>(&[
        (
            0.001,
            [
                0.99999790734779253,
                1.5926513604321899e-6,
                5.0000038637392677e-7,
                3.981634760264899e-13,
                6.2500068850425086e-14,
            ],
        ),
        (
            1.0,
            [
                0.59210133663004226,
                0.0010307886033067732,
                0.35372941207265388,
                0.00030790319293729991,
                0.052830559501059784,
            ],
        ),
        (
            3.1399999999999997,
            [
                2.4308684259170105e-63,
                3.4871639321654428e-50,
                9.8607800744725664e-32,
                7.0728042376017493e-19,
                1.0,
            ],
        ),
    ]);
}

/// Derivatives of order 1 and 2 keep their digits there, too: they are at most about 1 in size.
fn derivatives_of_nearly_half_a_turn<S: Scalar>() {
    let rows: [(f64, usize, [f64; 5]); 6] = [
        (0.0, 1, [-0.00159254902220518563, 0.00159254902220518563, 0.0, 0.0, 0.0]),
        (0.0, 2, [-0.999998097840708905, -3.80431858219003924e-6, 1.0000019021592911, 0.0, 0.0]),
        (
            1.5,
            1,
            [
                -0.533295382075430961,
                -0.00073224638740618078,
                0.0697160923448901342,
                0.000843457104703824752,
                0.463468079013243183,
            ],
        ),
        (
            1.5,
            2,
            [
                0.460644785067911888,
                -0.00101525520099106548,
                -0.989424166778350789,
                -0.000570884781807736579,
                0.530365521693237703,
            ],
        ),
        (
            3.125,
            1,
            [
                -8.43721311101276454e-7,
                -2.68719242467759419e-7,
                -0.014997614765874961,
                -0.00159204408397445436,
                0.0165907712904029844,
            ],
        ),
        (
            3.125,
            2,
            [
                0.000168736754071389786,
                0.0000358254799710239252,
                0.999516103019652995,
                -0.0000635159303850711859,
                -0.999657149323310338,
            ],
        ),
    ];
    let basis = Arc::new(S::of(3.140000104904175)).unwrap();
    for (t, order, row) in rows {
        for (found, exact) in basis.derivatives(S::of(t), order).into_iter().zip(row) {
            let error = (found.to_f64() - exact).abs() / epsilon::<S>();
            assert!(error < 24.0, "{found:?} in place of {exact} at {t}: {error} ε");
        }
    }
}

#[test]
fn derivatives_where_an_angle_is_nearly_half_a_turn() {
    derivatives_of_nearly_half_a_turn::<f32>();
    derivatives_of_nearly_half_a_turn::<f64>();
}
