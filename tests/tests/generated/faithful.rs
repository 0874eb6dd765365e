//! The steps of the engine are what the compiled code does: interpreted in `f32` and `f64` they give the same floats,
//! bit for bit but for the sign of a zero, and exactly they give the functions of the spec.

use basis_engine::algebra::rational::Rational;
use basis_engine::plan::Input;
use basis_engine::steps::{FamilySteps, JoinSteps, Number, Step, Steps};
use basis_engine::theorem::theorems;
use basis_engine::{Disk, Library, Prover, Subject, source};
use basis_runtime::{Array, Basis, Curve, FUSED_HERE, Scalar, basis};
use basis_test_support::cases;
use basis_tests::exact::{Reference, fraction};
use basis_tests::families::{Shipped, Touching};
use basis_tests::patches::{ShippedPatch, TouchingBox, TouchingTriangle, exact};
use basis_tests::random::Random;
use basis_tests::{each_family, each_patch};

/// What the inputs of steps stand for.
#[derive(Default)]
struct Inputs<'a, S> {
    shape: &'a [S],
    at: &'a [S],
    points: &'a [S],
    derivatives: &'a [S],
}

impl<S: Scalar> Inputs<'_, S> {
    fn get(&self, input: Input) -> S {
        match input {
            Input::Coordinate(k) => self.at[k],
            Input::Shape(k) => self.shape[k],
            Input::Point(k) => self.points[k],
            Input::Derivative(k) => self.derivatives[k],
            Input::Bound(k) => panic!("coefficient {k} was not bound"),
        }
    }

    /// Compares the outputs of steps with what the compiled code gave.
    fn same(&self, steps: &Steps, compiled: &[S], what: &dyn Fn() -> String)
    where
        S: Number,
    {
        let interpreted = steps.evaluate(|input| self.get(input)).expect("floats divide always");
        assert_eq!(interpreted.len(), compiled.len(), "{}", what());
        for (k, (i, c)) in interpreted.iter().zip(compiled).enumerate() {
            assert!(!c.is_nan(), "{}, output {k}", what());
            // Floats that are equal have the same bits, but for the sign of a zero.
            assert!(i == c, "{}, output {k}: interpreted {i}, compiled {c}", what());
        }
    }
}

/// Each operation of steps is needed, and none is there twice.
fn are_tidy(steps: &Steps) {
    for (k, step) in steps.steps.iter().enumerate() {
        assert!(!steps.steps[..k].contains(step), "{step:?}");
        assert!(step.operands().iter().all(|operand| *operand < k));
        let used =
            steps.outputs.contains(&k) || steps.steps[k + 1..].iter().any(|s| s.operands().contains(&k));
        assert!(used, "{step:?}");
        let constants = step.operands().iter().all(|a| matches!(steps.steps[*a], Step::Constant(_)));
        assert!(step.operands().is_empty() || !constants || !matches!(step, Step::Neg(_)));
    }
}

/// A parameter often at or next to an end of the domain.
fn parameter<B: Basis>(random: &mut Random) -> B::Scalar {
    let [low, high] = B::domain();
    match random.below(6) {
        0 => low,
        1 => high,
        2 => low + (high - low) * B::Scalar::EPSILON,
        3 => high - (high - low) * B::Scalar::EPSILON,
        _ => low + (high - low) * random.unit(),
    }
}

fn curves<B: Shipped<Scalar: Number>>(rounds: usize) {
    let (reference, random) = (B::reference(), &mut Random::new(71));
    let family = FamilySteps::new(&reference.family).expect("a family that is generated");
    let values = family.values();
    let weights = family.bernstein_weights();
    let derivatives: Vec<Steps> = (1..=3).map(|order| family.derivatives(&[order])).collect();
    let point = family.on_control_points(&family.curve(1).expect("a curve"));
    let with_derivatives = family.on_control_points(&family.curve(3).expect("a curve"));
    let ends = [true, false].map(|at_start| family.ends(2, at_start));
    for steps in [&values, &weights, &point, &with_derivatives].into_iter().chain(&derivatives) {
        are_tidy(steps);
    }
    for _ in 0..cases(rounds) {
        let shape: Vec<B::Scalar> = reference.shape(random);
        let basis = B::with(&shape).expect("inside the range");
        let t = parameter::<B>(random);
        let control = B::Points::from_fn(|_| random.wild());
        let given: [B::Scalar; 3] = core::array::from_fn(|_| random.between(-1.0, 1.0));
        let inputs = Inputs { shape: &shape, at: &[t], points: control.as_ref(), derivatives: &given };
        let what = |part: &str| format!("{part} of {} at {shape:?}, {t}", B::NAME);
        inputs.same(&values, basis.values(t).as_ref(), &|| what("values"));
        let rows = basis.bernstein_weights();
        let rows: Vec<B::Scalar> = rows.as_ref().iter().flat_map(|row| row.as_ref().to_vec()).collect();
        inputs.same(&weights, &rows, &|| what("weights"));
        for (steps, order) in derivatives.iter().zip(1..) {
            inputs.same(steps, basis.derivatives(t, order).as_ref(), &|| what("derivatives"));
        }
        let curve = Curve::new(basis, control);
        inputs.same(&point, &[curve.eval(t)], &|| what("point"));
        inputs.same(&with_derivatives, &curve.eval_with_derivs::<3>(t), &|| what("point with derivatives"));
        for (ends, solve) in ends.iter().zip([B::start_points, B::end_points]) {
            for end in ends {
                let count = end.positions.len();
                // Where the derivatives do not determine the points, a divisor is zero.
                let Ok(solved) = solve(&basis, &given[..count], control) else {
                    let outputs =
                        end.steps.evaluate(|input| inputs.get(input)).expect("floats divide always");
                    assert!(outputs[count..].contains(&B::Scalar::ZERO), "{}", what("ends"));
                    continue;
                };
                let mut expected: Vec<B::Scalar> =
                    end.positions.iter().map(|position| solved.as_ref()[*position]).collect();
                let outputs = end.steps.evaluate(|input| inputs.get(input)).expect("floats divide always");
                expected.extend(&outputs[count..]);
                inputs.same(&end.steps, &expected, &|| what("ends"));
            }
        }
    }
}

fn patches<B: ShippedPatch<Scalar: Number>>(rounds: usize) {
    let (reference, random) = (B::reference(), &mut Random::new(72));
    let title = reference.family.title();
    let family = FamilySteps::new(&reference.family).expect("a family that is generated");
    let variables = reference.family.domain.len();
    // The table of 45 functions takes long.
    let rounds = if reference.family.functions.len() > 30 { 2 } else { rounds };
    let values = family.values();
    let mut orders: Vec<Vec<usize>> = vec![vec![0; variables]];
    for k in 0..variables {
        for more in [vec![k], vec![k, k], vec![k, (k + 1) % variables]] {
            let mut one = vec![0; variables];
            for k in more {
                one[k] += 1;
            }
            orders.push(one);
        }
    }
    let large = reference.family.functions.len() > 30;
    if large {
        orders.truncate(3);
    }
    let derivatives: Vec<Steps> = orders[1..].iter().map(|orders| family.derivatives(orders)).collect();
    let patches: Vec<Steps> = orders
        .iter()
        .map(|orders| family.on_control_points(&family.patch(orders).expect("a patch")))
        .collect();
    if !large {
        derivatives.iter().chain(&patches).chain([&values]).for_each(are_tidy);
    }
    for _ in 0..cases(rounds) {
        let shape: Vec<B::Scalar> = reference.shape(random);
        let basis = B::with(&shape).expect("inside the range");
        let at = B::point(&reference, random);
        let control: Vec<B::Scalar> = reference.family.functions.iter().map(|_| random.wild()).collect();
        let inputs = Inputs { shape: &shape, at: &at, points: &control, derivatives: &[] };
        let what = |part: &str| format!("{part} of {title} at {shape:?}, {at:?}");
        inputs.same(&values, &basis.values(&at), &|| what("values"));
        for (steps, orders) in derivatives.iter().zip(&orders[1..]) {
            inputs.same(steps, &basis.partials(&at, orders), &|| what(&format!("derivatives {orders:?}")));
        }
        for (steps, orders) in patches.iter().zip(&orders) {
            let compiled = basis.patch(&control, &at, orders);
            inputs.same(steps, &[compiled], &|| what(&format!("derivative {orders:?} of a patch")));
        }
    }
}

/// In builds that fuse multiplications with additions the compiled code rounds less often.
fn comparable() -> bool {
    if FUSED_HERE {
        println!("skipped: this build fuses multiplications and additions");
    }
    !FUSED_HERE
}

#[test]
fn steps_do_what_compiled_curves_do() {
    if comparable() {
        each_family!(f32, curves, 60);
        each_family!(f64, curves, 60);
        curves::<Touching<f32>>(60);
        curves::<Touching<f64>>(60);
    }
}

#[test]
fn steps_do_what_compiled_patches_do() {
    if comparable() {
        each_patch!(f32, patches, 12);
        each_patch!(f64, patches, 12);
        patches::<TouchingTriangle<f32>>(12);
        patches::<TouchingTriangle<f64>>(12);
        patches::<TouchingBox<f32>>(12);
        patches::<TouchingBox<f64>>(12);
    }
}

basis!(library "quadratic", G1, G2);

/// The steps of a join on scalars in the order of the declaration, and one component of the three points of P.
fn joins<S: Scalar + Number>(
    name: &str,
    scalars: &[&str],
    compiled: impl Fn(&[S; 3], &[S]) -> Vec<S>,
    random: &mut Random,
) {
    let path = basis_tests::spec("quadratic.basis").to_string_lossy().into_owned();
    let source = source::read(&Disk, &path, &[]).expect("readable");
    let library = Library::from_source(&Disk, &Prover, source);
    let items = theorems(&library);
    let item = items.iter().find(|item| item.subject.name() == name).expect("a join");
    let Subject::Theorem(theorem) = &item.subject else { panic!("a join") };
    let join = JoinSteps::new(theorem).expect("linear in the points");
    assert_eq!(join.scalars.iter().map(|scalar| scalar.name.as_str()).collect::<Vec<_>>(), scalars);
    are_tidy(&join.steps);
    for _ in 0..200 {
        let points: [S; 3] = core::array::from_fn(|_| random.between(-1.0, 1.0));
        let shape: Vec<S> = scalars.iter().map(|_| random.between(0.0625, 0.9375)).collect();
        let given: Vec<S> = join.given.iter().map(|k| points[theorem.points[*k].index[0] as usize]).collect();
        let inputs = Inputs { shape: &shape, points: &given, ..Inputs::default() };
        inputs.same(&join.steps, &compiled(&points, &shape), &|| format!("{name} at {shape:?}, {points:?}"));
    }
}

#[test]
fn steps_do_what_compiled_joins_do() {
    fn both<S: Scalar + Number>() {
        let random = &mut Random::new(75);
        let g1 = |p: &[S; 3], x: &[S]| {
            quadratic::g1(p, quadratic::G1Scalars { lambda1: x[0], lambda2: x[1], delta: x[2] })
                .expect("finite")
                .to_vec()
        };
        joins("G1", &["λ1", "λ2", "δ"], g1, random);
        let g2 = |p: &[S; 3], x: &[S]| {
            quadratic::g2(p, quadratic::G2Scalars { lambda1: x[0], lambda2: x[1], delta: x[2], c: x[3] })
                .expect("finite")
                .to_vec()
        };
        joins("G2", &["λ1", "λ2", "δ", "c"], g2, random);
    }
    if comparable() {
        both::<f32>();
        both::<f64>();
    }
}

/// The exact inputs that floats are.
fn exactly<S: Scalar>(inputs: &Inputs<'_, S>, steps: &Steps) -> Vec<Rational> {
    steps.evaluate(|input| fraction(inputs.get(input))).expect("no pole")
}

fn exact_curves<B: Shipped>() {
    let (reference, random) = (B::reference(), &mut Random::new(73));
    let family = FamilySteps::new(&reference.family).expect("a family that is generated");
    let curve = family.on_control_points(&family.curve(2).expect("a curve"));
    for shape in reference.shapes::<B::Scalar>(2, random) {
        let functions = reference.at(&shape);
        let t = parameter::<B>(random);
        let control: Vec<B::Scalar> = (0..B::LEN).map(|_| random.between(-1.0, 1.0)).collect();
        let inputs = Inputs { shape: &shape, at: &[t], points: &control, derivatives: &[] };
        let mut rows = vec![functions.values(&fraction(t))];
        assert_eq!(exactly(&inputs, &family.values()), rows[0], "{}", B::NAME);
        for order in 1..=2 {
            let expected = functions.derivatives(&fraction(t), order);
            assert_eq!(exactly(&inputs, &family.derivatives(&[order])), expected, "{} {order}", B::NAME);
            rows.push(expected);
        }
        let point = |row: &Vec<Rational>| {
            let terms = row.iter().zip(&control).map(|(b, p)| b * &fraction(*p));
            terms.fold(Rational::ZERO, |sum, term| &sum + &term)
        };
        assert_eq!(exactly(&inputs, &curve), [point(&rows[0]), point(&rows[1])], "{}", B::NAME);
    }
}

fn exact_patches<B: ShippedPatch>() {
    let (reference, random) = (B::reference(), &mut Random::new(74));
    if reference.family.functions.len() > 30 {
        return;
    }
    let family = FamilySteps::new(&reference.family).expect("a family that is generated");
    let variables = reference.family.domain.len();
    for shape in reference.shapes::<B::Scalar>(1, random) {
        let at = B::point(&reference, random);
        let inputs = Inputs { shape: &shape, at: &at, points: &[], derivatives: &[] };
        for k in 0..=variables {
            let mut orders = vec![0; variables];
            if let Some(order) = orders.get_mut(k) {
                *order = 1;
            }
            let expected = exact(&reference, &shape, &at, &orders);
            let title = reference.family.title();
            assert_eq!(exactly(&inputs, &family.derivatives(&orders)), expected, "{title} {orders:?}");
        }
    }
}

#[test]
fn steps_mean_the_formulas_of_the_spec() {
    each_family!(f64, exact_curves);
    exact_curves::<Touching<f64>>();
    each_patch!(f64, exact_patches);
    exact_patches::<TouchingTriangle<f64>>();
    exact_patches::<TouchingBox<f64>>();
}

/// A family that nothing else mentions: another domain, a denominator, numbers that no float is.
#[test]
fn steps_of_any_family_mean_its_formulas() {
    let text = "family Odd { domain 1/3 <= t <= 7/5; shape 1/7 <= α <= 3; shape 0 < β;
        b[0] = (7/5 - t)^3*(t - 1/3)*(1/10 + α*t)/(1 + α*β); b[1] = α^2*β*t^5 - 2/3*t; b[2] = 5/9; }";
    let library = Library::from_source(&Disk, &Prover, basis_engine::Source::text("odd.basis", text));
    let item = library.item("Odd", &[]).expect("a family");
    let Subject::Family(family) = item.subject else { panic!("a family") };
    let reference = Reference { family };
    let steps = FamilySteps::new(&reference.family).expect("it is small");
    let shape = [0.75, 2.5];
    let functions = reference.at(&shape);
    for t in [0.375, 0.5, 1.0, 1.25] {
        let inputs = Inputs { shape: &shape, at: &[t], points: &[], derivatives: &[] };
        assert_eq!(exactly(&inputs, &steps.values()), functions.values(&fraction(t)));
        for order in 1..=7 {
            let expected = functions.derivatives(&fraction(t), order);
            assert_eq!(exactly(&inputs, &steps.derivatives(&[order])), expected, "{order}");
        }
    }
}
