//! Proved bounds of rounding errors beside the largest errors that a search finds, in `f32`: `cargo bench -p basis-benches
//! --bench rounding`, or with names of families after `--`. A table in Markdown; no time is measured.
//!
//! The search interprets the steps of a family, which are those of the compiled code: at random inputs; near those where
//! the roundings would do the most harm if all of them conspired; of a family without shape values at every float
//! between 1/4 and 1/2, where 1 − t rounds; and uphill from the worst of them. Of a family with angles the numbers that are
//! computed once from the shape values, such as tan(α/2), are computed in `f32` as well.

use basis_engine::algebra::rational::ToFloat as _;
use basis_engine::model::Parameter;
use basis_engine::model::angle::Kind;
use basis_engine::plan::Input;
use basis_engine::plan::patch::form::multi_indices;
use basis_engine::rounding::Error;
use basis_engine::state::{point_error, point_name, value_errors};
use basis_engine::steps::{FamilySteps, Number, Step, Steps};
use basis_engine::{Disk, Family, Library, Prover, Source, Subject};

/// What is in the table: the spec of the library, the family, its order.
const FAMILIES: &[(&str, &str, &[i64])] = &[
    ("quartic", "QuarticBernstein", &[]),
    ("quadratic", "QuadraticBezier", &[]),
    ("bernstein", "Bernstein", &[2]),
    ("bernstein", "Bernstein", &[3]),
    ("bernstein", "Bernstein", &[5]),
    ("bernstein", "Bernstein", &[6]),
    ("bernstein", "Bernstein", &[8]),
    ("bernstein", "Bernstein", &[12]),
    ("ball", "SaidBall", &[]),
    ("triangular", "TriangularII", &[3]),
    ("lagrange", "Lagrange", &[3]),
    ("lagrange", "Bilinear", &[]),
    ("rational/bezier", "Conic", &[]),
    ("rational/bezier", "RationalQuadratic", &[]),
    ("trigonometric/han", "QuadraticTrigonometric", &[]),
    ("trigonometric/han", "CubicTrigonometricBezier", &[]),
    ("trigonometric/shape", "CyclicFour", &[]),
    ("trigonometric/end_angle", "CBezierQuadratic", &[]),
    ("trigonometric/end_angle", "TrigonometricBBasis", &[2]),
    ("trigonometric/end_angle", "HBezierQuadratic", &[]),
    ("trigonometric/end_angle", "ExponentialBernstein", &[3]),
];

/// Random inputs, and steps uphill.
const SAMPLES: usize = 1_000_000;
const STEPS: usize = 400_000;

struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// What is evaluated: steps, and before them those of the numbers that depend on the shape values alone.
struct Evaluation {
    derived: Option<Steps>,
    steps: Steps,
}

impl Evaluation {
    fn new(form: &FamilySteps<'_>, steps: Steps) -> Self {
        Self { derived: form.derived().map(|derived| derived.steps.clone()), steps }
    }

    /// The value of each input of the steps, made of floats by `number`.
    fn inputs<'a, N: Number + 'a>(&self, of: &'a Inputs, number: fn(f32) -> N) -> impl Fn(Input) -> N + 'a {
        let own = move |input: Input| number(of.get(input));
        let derived = self.derived.as_ref().and_then(|steps| steps.evaluate::<N>(own)).unwrap_or_default();
        move |input| match input {
            Input::Shape(k) if k >= of.shapes => derived[k - of.shapes].clone(),
            _ => own(input),
        }
    }

    fn outputs<N: Number>(&self, inputs: &Inputs, number: fn(f32) -> N) -> Vec<N> {
        self.steps.evaluate::<N>(self.inputs(inputs, number)).unwrap_or_default()
    }

    /// The values of all steps, as far as `f64` has digits.
    fn trace(&self, inputs: &Inputs) -> Vec<f64> {
        self.steps.trace::<f64>(self.inputs(inputs, f64::from)).unwrap_or_default()
    }
}

/// The inputs of steps: shape values, coordinates, one component of the control points.
#[derive(Clone)]
struct Inputs {
    values: Vec<f32>,
    ranges: Vec<[f32; 2]>,
    shapes: usize,
    coordinates: usize,
    /// The ends of the domain, where they depend on shape values or are no floats.
    ends: Option<Steps>,
    /// The power of the sum of the coordinates that an absolute error is relative to: of a patch on a simplex its degree.
    degree: i32,
}

/// The range of a parameter in floats: of an angle that of the angle itself.
fn range(family: &Family, p: &Parameter) -> [f32; 2] {
    let end = |side: usize| {
        let angle = family.analytic.angle(p.var).filter(|angle| angle.kind != Kind::Linear);
        let value = match angle {
            Some(angle) if angle.ends[side].is_empty() => None,
            Some(angle) => family.analytic.number(&angle.limits[side]),
            None => [&p.range.low, &p.range.high][side].value().cloned(),
        };
        value.map(|x| x.to_f64() as f32)
    };
    let (low, high) = (end(0), end(1));
    [low.unwrap_or(-8.0), high.unwrap_or(low.unwrap_or(-8.0) + 8.0)]
}

impl Inputs {
    fn of(family: &Family, form: &FamilySteps<'_>, points: usize) -> Self {
        let of = |p: &Parameter| range(family, p);
        let shapes = family.shapes.iter().map(of);
        let coordinates: Vec<[f32; 2]> = family.domain_variables().map(of).collect();
        let ranges: Vec<[f32; 2]> =
            shapes.chain(coordinates.iter().copied()).chain((0..points).map(|_| [-1.0, 1.0])).collect();
        let (shapes, coordinates) = (family.shapes.len(), coordinates.len());
        let values = ranges.iter().map(|[low, _]| *low).collect();
        let ends = (!family.analytic.is_empty()).then(|| form.knots());
        Self { values, ranges, shapes, coordinates, ends, degree: 0 }
    }

    /// The domain ends where the shape values say.
    fn end_domain(&mut self) {
        let Some(ends) = &self.ends else { return };
        let found = ends.evaluate::<f64>(|input| f64::from(self.get(input))).unwrap_or_default();
        if let [low, .., high] = found[..] {
            let (mut low, mut high) = (low as f32, high as f32);
            // The floats inside.
            low = if f64::from(low) < found[0] { low.next_up() } else { low };
            high = if f64::from(high) > found[found.len() - 1] { high.next_down() } else { high };
            self.ranges[self.shapes] = [low, high];
        }
    }

    fn scale(&self) -> f64 {
        let coordinates = &self.values[self.shapes..self.shapes + self.coordinates];
        coordinates.iter().copied().map(f64::from).sum::<f64>().powi(self.degree)
    }

    fn get(&self, input: Input) -> f32 {
        match input {
            Input::Shape(k) => self.values[k],
            Input::Coordinate(k) => self.values[self.shapes + k],
            Input::Point(k) => self.values[self.shapes + self.coordinates + k],
            Input::Derivative(_) | Input::Bound(_) => unreachable!("bound points are no inputs here"),
        }
    }

    fn at_random(&mut self, random: &mut Random) {
        for k in 0..self.values.len() {
            if k == self.shapes {
                self.end_domain();
            }
            let [low, high] = self.ranges[k];
            let x = match random.next() % 4 {
                // Control points at the corners are the worst ones.
                0..=2 if k >= self.shapes + self.coordinates => [low, high][(random.next() % 2) as usize],
                // Next to the lower end powers of 1 − t round most often.
                0 => (f64::from(low) + f64::from(high - low) * random.unit().powi(8)) as f32,
                _ => (f64::from(low) + f64::from(high - low) * random.unit()) as f32,
            };
            self.values[k] = x.clamp(low, high);
        }
    }

    /// Some inputs moved by up to a few thousand floats.
    fn nearby(&self, random: &mut Random) -> Self {
        let mut other = self.clone();
        for k in 0..other.values.len() {
            if k == other.shapes {
                other.end_domain();
            }
            let [low, high] = other.ranges[k];
            if random.next().is_multiple_of(2) {
                let by = (random.next() % (1 << (random.next() % 13))) as f64 * f64::from(f32::EPSILON) / 4.0;
                let sign = if random.next().is_multiple_of(2) { 1.0 } else { -1.0 };
                other.values[k] = (f64::from(other.values[k]) * (1.0 + sign * by)) as f32;
            }
            other.values[k] = other.values[k].clamp(low, high);
        }
        other
    }
}

/// The errors of the outputs in ε, relative or absolute as their bounds are; 0 without a bound.
fn errors(steps: &Evaluation, kinds: &[Option<Error>], inputs: &Inputs) -> Vec<f64> {
    let computed = steps.outputs::<f32>(inputs, |x| x);
    let exact = steps.outputs::<f64>(inputs, f64::from);
    let error = |((computed, exact), kind): ((f32, f64), &Option<Error>)| {
        let scale = match kind {
            Some(Error::Absolute(_)) if inputs.scale() > 1e-6 => inputs.scale(),
            Some(Error::Relative(_)) if exact.abs() > 1e-30 => exact.abs(), // not next to underflow
            _ => return 0.0,
        };
        let found = (f64::from(computed) - exact).abs() / scale / f64::from(f32::EPSILON);
        if found.is_finite() { found } else { 0.0 }
    };
    computed.into_iter().zip(exact).zip(kinds).map(error).collect()
}

/// The sum of the absolute values of the shares of all steps in the error of the first output, which is reached if all
/// of them round as far as they can to the side where it hurts.
fn harm(evaluation: &Evaluation, inputs: &Inputs) -> f64 {
    let (steps, values) = (&evaluation.steps, evaluation.trace(inputs));
    let mut slopes = vec![0.0; values.len()];
    let (Some(first), false) = (steps.outputs.first(), values.is_empty()) else { return 0.0 };
    slopes[*first] = 1.0;
    let mut sum = 0.0;
    for (k, step) in steps.steps.iter().enumerate().rev() {
        let slope = slopes[k];
        match *step {
            Step::Neg(a) => slopes[a] -= slope,
            Step::Add(a, b) => {
                slopes[a] += slope;
                slopes[b] += slope;
            }
            Step::Sub(a, b) => {
                slopes[a] += slope;
                slopes[b] -= slope;
            }
            Step::Mul(a, b) => {
                slopes[a] += slope * values[b];
                slopes[b] += slope * values[a];
            }
            Step::Div(a, b) => {
                slopes[a] += slope / values[b];
                slopes[b] -= slope * values[k] / values[b];
            }
            Step::CutOff(a) => slopes[a] += slope,
            _ => continue,
        }
        sum += (slope * values[k]).abs();
    }
    sum
}

/// The worst inputs that are known, from the worst on.
#[derive(Clone, Default)]
struct Worst(Vec<(f64, Inputs)>);

impl Worst {
    fn add(&mut self, found: f64, inputs: &Inputs) {
        const MOST: usize = 32;
        if self.0.len() < MOST || found > self.0[MOST - 1].0 {
            self.0.push((found, inputs.clone()));
            self.0.sort_by(|a, b| b.0.total_cmp(&a.0));
            self.0.truncate(MOST);
        }
    }
}

/// The largest errors of the outputs that are found.
fn search(steps: &Evaluation, kinds: &[Option<Error>], mut inputs: Inputs) -> Vec<f64> {
    let random = &mut Random(0x9e37_79b9_7f4a_7c15);
    let mut worst = vec![Worst::default(); kinds.len()];
    let try_at = |inputs: &Inputs, worst: &mut Vec<Worst>| {
        for (found, worst) in errors(steps, kinds, inputs).into_iter().zip(worst) {
            worst.add(found, inputs);
        }
    };
    for _ in 0..SAMPLES {
        inputs.at_random(random);
        try_at(&inputs, &mut worst);
    }
    let mut harmful = Worst::default();
    for _ in 0..SAMPLES / 10 {
        inputs.at_random(random);
        harmful.add(harm(steps, &inputs), &inputs);
    }
    for (_, at) in &harmful.0 {
        for _ in 0..SAMPLES / 100 {
            try_at(&at.nearby(random), &mut worst);
        }
    }
    if inputs.values.len() == 1 && inputs.coordinates == 1 {
        let (mut t, end) = (0.25_f32, 0.5);
        while t < end {
            inputs.values[0] = t;
            try_at(&inputs, &mut worst);
            t = t.next_up();
        }
    }
    let uphill = |(output, worst): (usize, Worst)| {
        let mut largest = 0.0_f64;
        for (mut found, mut at) in worst.0 {
            for _ in 0..STEPS / 32 {
                let other = at.nearby(random);
                let error = errors(steps, kinds, &other)[output];
                if error >= found {
                    (found, at) = (error, other);
                }
            }
            largest = largest.max(found);
        }
        largest
    };
    worst.into_iter().enumerate().map(uphill).collect()
}

fn main() {
    println!("| family | of | proved | found | proved/found |\n| --- | --- | --- | --- | --- |");
    let wanted: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    for (spec, name, order) in FAMILIES {
        if !wanted.is_empty() && !wanted.iter().any(|wanted| wanted == name) {
            continue;
        }
        let text = basis_specs::text(spec).expect("a spec of the library");
        let library = Library::from_source(&Disk, &Prover, Source::text(format!("{spec}.basis"), text));
        let Ok(item) = library.item(name, order) else { panic!("{spec} has no family {name}") };
        let Subject::Family(family) = &item.subject else { panic!("{name} is no family") };
        let form = FamilySteps::new(family).expect("code is generated for it");
        let row = |of: &str, proved: &Error, found: f64| {
            let bound = proved.epsilons().to_f64();
            println!("| {} | {of} | {proved} | {found:.2} | {:.2} |", family.title(), bound / found);
        };
        let (steps, errors) = (Evaluation::new(&form, form.values()), value_errors(family));
        // The function with the largest ratio speaks for all.
        let kinds: Vec<Option<Error>> =
            errors.into_iter().map(|known| known.map(|(error, _)| error)).collect();
        let mut worst: Option<(String, &Error, f64)> = None;
        for (k, (kind, found)) in
            kinds.iter().zip(search(&steps, &kinds, Inputs::of(family, &form, 0))).enumerate()
        {
            let Some(proved) = kind else { continue };
            let ratio = |error: &Error, found: f64| error.epsilons().to_f64() / found;
            if found > 0.0 && worst.as_ref().is_none_or(|(_, e, f)| ratio(proved, found) > ratio(e, *f)) {
                worst = Some((family.function_label(k), proved, found));
            }
        }
        if let Some((label, proved, found)) = worst {
            row(&label, proved, found);
        }
        let none = vec![0; family.domain.len()];
        if let (Some((proved, _)), Some(point)) =
            (point_error(family), form.curve(1).or_else(|| form.patch(&none)))
        {
            let steps = Evaluation::new(&form, form.on_control_points(&point));
            let mut inputs = Inputs::of(family, &form, family.functions.len());
            if family.is_simplex() {
                let corners = form.coordinates();
                let degree = (0..=64).find(|n| multi_indices(corners, *n).len() >= form.bound());
                inputs.degree = degree.map_or(0, |n| n as i32);
            }
            let found = search(&steps, &[Some(proved.clone())], inputs);
            row(&point_name(family), &proved, found[0]);
        }
    }
}
