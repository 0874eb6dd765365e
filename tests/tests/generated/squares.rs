//! Next to a double zero no value of a nonnegative function is negative.

use basis_runtime::basis;
use basis_tests::random::Random;

basis! {
    family Squares {
        shape 0 <= μ <= 1;
        domain 0 <= t <= 1;
        b[0] = (t^2 - t + 4/17)^2*(7*t - 3)^2;
        b[1] = (10*t - 3)^2/(1 + μ*t);
        b[2] = (t^2 - 3/10)^2 + (t^2 - 3/10)^4;
        b[3] = (t - μ)^2*(1 + t);
        b[4] = (3*t - 1)^5*(3*t - 1)*(t - 2/3)^2*(2 - t)*t^2;
        b[5] = (t - μ/2 - 1/4)^4*(1 - t)^3;
        prove nonnegative;
    }
}

/// All f32 within 2¹⁴ steps of the places, and 2¹⁶ of [0, 1].
#[test]
fn of_functions_with_double_zeros_are_not_negative() {
    let random = &mut Random::new(21);
    for mu in [0.0_f32, 0.1, 0.3, 0.5, 0.7, 0.999_999_94, 1.0] {
        let basis = Squares::new(mu).expect("inside the range");
        let zeros = [3.0 / 7.0, 0.3, 0.3_f32.sqrt(), mu, 1.0 / 3.0, 2.0 / 3.0, mu / 2.0 + 0.25];
        let beside = zeros.iter().flat_map(|&zero| {
            let bits = zero.to_bits();
            (bits.saturating_sub(1 << 14)..=bits + (1 << 14)).map(f32::from_bits).filter(|&t| t <= 1.0)
        });
        let anywhere: Vec<f32> = (0..1 << 16).map(|_| random.unit()).collect();
        for t in beside.chain(anywhere) {
            let values = basis.values(t);
            assert!(values.iter().all(|&value| value >= 0.0), "{mu} at {t}: {values:?}");
        }
    }
}
