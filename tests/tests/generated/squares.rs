//! Next to a double zero no value of a nonnegative function is negative.

use basis_engine::plan::Input;
use basis_engine::steps::FamilySteps;
use basis_engine::{Disk, Library, Prover, Source, Subject};
use basis_runtime::{Scalar, basis};
use basis_test_support::cases;
use basis_tests::families::Touching;
use basis_tests::patches::{TouchingBox, TouchingTriangle};
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

basis! {
    family Quotients {
        shape 0 < c <= 1;
        domain 0 <= t <= 1;
        b[0] = (t - 1/3)^2/((t - 1/3)^2 + c^2);
        b[1] = c^2/((t - 1/3)^2 + c^2);
        b[2] = ((t - c)^2 + (t - 1/3)^4)/(1 + t);
        prove nonnegative;
    }
    family Waves {
        shape 0 <= c <= 1;
        domain 0 <= t <= pi/2;
        b[0] = (sin(t) - c)^2;
        b[1] = (sin(t) - c)^2 + (cos(t) - 3/5)^2;
        b[2] = 2 - sin(t) - cos(t);
        prove nonnegative;
    }
    family Falling {
        shape 1/8 <= c <= 1;
        domain 0 <= t <= 2;
        b[0] = (exp(-t) - c)^2 + (c - 1/2)^2;
        b[1] = exp(t) - 1 - t;
        prove nonnegative;
    }
    family Joined {
        shape 0 <= c <= 1;
        domain 0 <= t <= 1, 1 <= t <= 3;
        b[0] = (t - c)^2 + (t - 1/2)^4 | (1 - c)^2 + 1/16 + (t - 1)*(t - 2)^2;
        prove nonnegative;
    }
}

/// A number between two others, often one of a few places or next to one.
fn near<S: Scalar>(random: &mut Random, [low, high]: [f64; 2], places: &[f64]) -> S {
    let place = if random.below(4) == 0 {
        low + (high - low) * random.unit::<f64>()
    } else {
        places[random.below(places.len())]
    };
    let steps = random.below(1 << 10) as f64 - 512.0;
    let step = [0.0, 1.0, 1.0, 4096.0][random.below(4)];
    S::of(S::of(place + steps * step * S::EPSILON.to_f64()).to_f64().clamp(low, high))
}

fn sums_of_squares<S: Scalar>(rounds: usize) {
    let random = &mut Random::new(22);
    let places = [0.0, 0.2, 1.0 / 7.0, 0.25, 1.0 / 3.0, 0.5, 0.6, 1.0, 1.5];
    let check = |values: &[S], what: &dyn Fn() -> String| {
        assert!(values.iter().all(|value| *value >= S::ZERO), "{}: {values:?}", what());
    };
    for _ in 0..cases(rounds) {
        let unit = |random: &mut Random| near::<S>(random, [0.0, 1.0], &places);
        let a: S = near(random, [-1.0, 2.0], &places);
        let c = [S::ZERO, unit(random)][random.below(2)];
        let t = if random.below(2) == 0 { unit(random) } else { a.max(S::ZERO).min(S::ONE) };
        let values = Touching::new(a, c).expect("inside the ranges").values(t);
        check(&values[..4], &|| format!("{a}, {c} at {t}"));

        let m = unit(random);
        let u: S = near(random, [0.0, 0.5], &places);
        let v = [u, near(random, [0.0, 0.5], &places)][random.below(2)];
        let at = [u, v, S::ONE - u - v];
        check(&TouchingTriangle::new(m).expect("inside the range").values(at), &|| format!("{m} at {at:?}"));

        let n: S = near(random, [-1.0, 1.5], &places);
        let x = near(random, [0.0, 1.0], &[m.to_f64()]);
        let y = near(random, [-1.0, 1.5], &[n.to_f64()]);
        let basis = TouchingBox::new(m, n).expect("inside the ranges");
        check(&basis.values([x, y]), &|| format!("{m}, {n} at {x}, {y}"));

        // Below, the denominator is 0 in f32.
        let c: S = near(random, [1.0 / 128.0, 1.0], &places);
        let values = Quotients::new(c).expect("inside the range").values(t);
        check(&values, &|| format!("quotients {c} at {t}"));
        let values = Waves::new(m).expect("inside the range").values(t);
        check(&values, &|| format!("sines {m} at {t}"));
        let c: S = near(random, [0.125, 1.0], &places);
        let t = near(random, [0.0, 2.0], &[-c.to_f64().ln(), 0.0, 1e-4]);
        let values = Falling::new(c).expect("inside the range").values(t);
        check(&values, &|| format!("exponentials {c} at {t}"));
        let t = near(random, [0.0, 3.0], &[m.to_f64(), 0.5, 1.0, 2.0]);
        check(&Joined::new(m).expect("inside the range").values(t), &|| format!("spans {m} at {t}"));
    }
}

#[test]
fn nor_are_sums_of_squares_for_single_shape_values() {
    sums_of_squares::<f32>(200_000);
    sums_of_squares::<f64>(50_000);
}

/// What is cut off has to be: in a family of which nothing is proved some of these values are negative.
#[test]
fn without_a_proof_they_are() {
    let text = include_str!("../../specs/good/double_zeros.basis");
    let library = Library::from_source(&Disk, &Prover, Source::text("double_zeros.basis", text));
    let item = library.item("Touching", &[]).expect("a family");
    let Subject::Family(family) = item.subject else { panic!("a family") };
    let steps = FamilySteps::new(&family).expect("it is small").values();
    let random = &mut Random::new(23);
    let mut negative = [0; 4];
    for _ in 0..4000 {
        let a = random.unit::<f32>();
        let t = f32::from_bits(a.to_bits() + random.below(64) as u32);
        let input = |input: Input| match input {
            Input::Shape(0) => a,
            Input::Shape(_) => [0.0, 1.0 / 7.0][usize::from(t > 0.5)],
            _ => t,
        };
        let values = steps.evaluate::<f32>(input).expect("floats divide always");
        for (count, value) in negative.iter_mut().zip(values) {
            *count += usize::from(value < 0.0);
        }
    }
    assert!(negative[0] > 100, "{negative:?}");
}
