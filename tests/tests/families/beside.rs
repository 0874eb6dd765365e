//! Families in which the variable stands beside its sine or exponential: the generated types beside values of mpmath, next to the
//! ends of the domain and to 0, where differences such as t − sin t have lost all digits.
#![expect(clippy::unreadable_literal, reason = "tables of numbers")]

use basis_runtime::{ParametricCurve, Scalar, SpannedBasis, basis};
use basis_tests::exact::epsilon;

basis! {
    family Quarter {
        domain 0 <= t <= pi/2;
        b[0] = (pi/2 - t - cos(t))/(pi/2 - 1);
        b[1] = (1 - sin(t) - b[0])/(2 - pi/2);
        b[2] = (1 - cos(t) - b[3])/(2 - pi/2);
        b[3] = (t - sin(t))/(pi/2 - 1);
        prove partition_of_unity;
        prove nonnegative;
    }
    family Turn {
        domain -pi <= t <= pi;
        shape 0 <= λ <= 1;
        b[0] = t - λ*sin(t) + pi/2;
        b[1] = 1 + cos(t);
        b[2] = t*sin(t);
    }
    family Exponential {
        domain -1 <= t <= 1;
        b[0] = exp(t) - 1 - t;
        b[1] = 1 - t;
        b[2] = exp(t) - exp(1)*t;
        prove nonnegative;
    }
}

/// The variable with the values of all functions; all of the variables are floats of 32 bits.
type Table = &'static [(f64, &'static [f64])];

const QUARTER: Table = &[
    (
        9.094947017729282e-13,
        &[0.9999999999984066, 1.593378687068482e-12, 9.636224759862481e-25, 2.1966865973327373e-37],
    ),
    (
        0.0009765625,
        &[0.9982899580514812, 0.0017089313291796273, 1.1103474025104267e-06, 2.719366162930271e-10],
    ),
    (0.25, &[0.6164789235069723, 0.317138751917108, 0.06183422112183091, 0.0045481034540888025]),
    (0.78125, &[0.13930090208409493, 0.3647023458407582, 0.36095298089621236, 0.13504377117893449]),
    (1.25, &[0.009590048398462987, 0.0965167234860893, 0.36653282561485984, 0.5273604025005879]),
    (1.5625, &[1.6673379588154055e-07, 7.97933244594514e-05, 0.014394401610358269, 0.9855256383313864]),
    (1.5703125, &[3.307023828185852e-11, 2.7262374139222764e-07, 0.0008471570269623914, 0.999152570316226]),
    (
        1.570796012878418,
        &[9.032540594472536e-21, 1.1479810595207225e-13, 5.499621303014451e-07, 0.9999994500377549],
    ),
];
const TURN: Table = &[
    (-3.141592502593994, &[-1.5707961003011979, 1.1399865672597252e-14, 4.743672703689539e-07]),
    (-3.0, &[-1.3586436691751698, 0.010007503399554543, 0.42336002417960167]),
    (-1.5, &[0.5695438200969238, 1.0707372016677028, 1.4962424799060816]),
    (-9.313225746154785e-10, &[1.5707963263292353, 2.0, 8.673617379884035e-19]),
    (0.000244140625, &[1.5709183971086094, 1.9999999701976778, 5.960464418327168e-08]),
    (1.0, &[2.150060834390948, 1.5403023058681398, 0.8414709848078965]),
    (3.125, &[4.6875003806802225, 0.00013765491831341562, 0.0518496632167122]),
];
const EXPONENTIAL: Table = &[
    (-0.9999999403953552, &[0.3678794034941216, 1.9999999403953552, 3.0861611295355886]),
    (-0.5, &[0.10653065971263342, 1.5, 1.965671573942156]),
    (-9.5367431640625e-07, &[4.547472063262089e-13, 1.0000009536743164, 1.000001638681703]),
    (2.9103830456733704e-11, &[4.2351647363125885e-22, 0.9999999999708962, 0.9999999999499914]),
    (0.75, &[0.3670000166126747, 0.25, 0.07828864526839074]),
    (0.9999990463256836, &[0.7182801897790332, 9.5367431640625e-07, 1.2361310674990498e-12]),
];

/// Values to within 64 ε of themselves.
fn check<B: SpannedBasis>(basis: &B, table: Table) {
    let eps = epsilon::<B::Scalar>();
    for (t, exact) in table {
        for (got, exact) in SpannedBasis::values(basis, B::Scalar::of(*t)).as_ref().iter().zip(*exact) {
            let error = (got.to_f64() - exact).abs() / exact.abs();
            assert!(error <= 64.0 * eps, "{} at {t}: {got} for {exact}, off by {} ε", B::NAME, error / eps);
        }
    }
}

#[test]
fn values_keep_their_digits() {
    check(&Quarter::<f64>::new(), QUARTER);
    check(&Quarter::<f32>::new(), QUARTER);
    check(&Turn::<f64>::new(0.5).expect("in range"), TURN);
    check(&Turn::<f32>::new(0.5).expect("in range"), TURN);
    check(&Exponential::<f64>::new(), EXPONENTIAL);
    check(&Exponential::<f32>::new(), EXPONENTIAL);
}

#[test]
fn ends_are_exact() {
    use core::f64::consts::FRAC_PI_2;
    let quarter = Quarter::<f64>::new();
    assert_eq!(quarter.values(0.0), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(quarter.values(FRAC_PI_2), [0.0, 0.0, 0.0, 1.0]);
    assert_eq!(Exponential::<f64>::new().values(0.0)[0], 0.0);
    assert_eq!(Exponential::<f64>::new().values(1.0), [0.718_281_828_459_045_2, 0.0, 0.0]);
}

/// A curve over them, its derivative as that of the functions, and its length as that of a finer polygon.
#[test]
fn curves() {
    let quarter = Quarter::<f64>::new();
    let points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]];
    let curve = quarter.curve(points);
    let at = |t: f64| {
        let b = quarter.values(t);
        [0, 1].map(|d| (0..4).map(|k| b[k] * points[k][d]).sum::<f64>())
    };
    let mut length = 0.0;
    for k in 0..200 {
        let [a, b] = [k, k + 1].map(|k| at(core::f64::consts::FRAC_PI_2 * f64::from(k) / 200.0));
        length += (b[0] - a[0]).hypot(b[1] - a[1]);
        let t = core::f64::consts::FRAC_PI_2 * f64::from(k) / 200.0;
        let point = curve.eval(t);
        assert!((point[0] - a[0]).abs() < 1e-13 && (point[1] - a[1]).abs() < 1e-13, "{t}");
    }
    let own = curve.arclen(1e-9);
    assert!((own - length).abs() < 1e-3 && own >= length, "{own} {length}");
}
