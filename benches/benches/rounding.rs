//! Proved bounds of rounding errors beside the largest errors that a search finds, in `f32`: `cargo bench -p basis-benches
//! --bench rounding`. A table in Markdown; no time is measured.
//!
//! The search interprets the steps of a family, which are those of the compiled code, at all floats of a grid in t for
//! several shape values, at random inputs, and uphill from the worst of them.

use basis_engine::plan::Input;
use basis_engine::rounding::Error;
use basis_engine::state::{point_error, value_errors};
use basis_engine::steps::{FamilySteps, Steps};
use basis_engine::{Disk, Family, Library, Prover, Source, Subject};

/// What is in the table: the spec of the library, the family, its order.
const FAMILIES: &[(&str, &str, &[i64])] = &[
    ("quartic", "QuarticBernstein", &[]),
    ("quadratic", "QuadraticBezier", &[]),
    ("bernstein", "Bernstein", &[2]),
    ("bernstein", "Bernstein", &[3]),
    ("bernstein", "Bernstein", &[5]),
    ("bernstein", "Bernstein", &[8]),
    ("bernstein", "Bernstein", &[12]),
    ("ball", "SaidBall", &[]),
    ("triangular", "TriangularII", &[3]),
    ("lagrange", "Lagrange", &[3]),
    ("rational/bezier", "Conic", &[]),
    ("rational/bezier", "RationalQuadratic", &[]),
];

/// Random inputs, and steps uphill.
const SAMPLES: usize = 2_000_000;
const STEPS: usize = 200_000;

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

/// The inputs of steps: shape values, coordinates, one component of the control points.
#[derive(Clone)]
struct Inputs {
    values: Vec<f32>,
    ranges: Vec<[f32; 2]>,
    shapes: usize,
    coordinates: usize,
}

impl Inputs {
    fn of(family: &Family, points: usize) -> Self {
        let end = |x: Option<&basis_engine::algebra::rational::Rational>| x.map(|x| x.to_f64() as f32);
        let finite = |p: &basis_engine::model::Parameter| {
            let (low, high) = (end(p.range.low.value()), end(p.range.high.value()));
            [low.unwrap_or(-8.0), high.unwrap_or(low.unwrap_or(-8.0) + 8.0)]
        };
        let shapes = family.shapes.iter().map(finite);
        let coordinates: Vec<[f32; 2]> = family.domain_variables().map(finite).collect();
        let ranges: Vec<[f32; 2]> =
            shapes.chain(coordinates.iter().copied()).chain((0..points).map(|_| [-1.0, 1.0])).collect();
        let (shapes, coordinates) = (family.shapes.len(), coordinates.len());
        Self { values: ranges.iter().map(|[low, _]| *low).collect(), ranges, shapes, coordinates }
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
        for (k, [low, high]) in self.ranges.iter().enumerate() {
            let x = match random.next() % 4 {
                // Control points at the corners are the worst ones.
                0 | 1 if k >= self.shapes + self.coordinates => [*low, *high][(random.next() % 2) as usize],
                _ => (f64::from(*low) + f64::from(high - low) * random.unit()) as f32,
            };
            self.values[k] = x.clamp(*low, *high);
        }
    }

    /// Some inputs moved by up to a few thousand floats.
    fn nearby(&self, random: &mut Random) -> Self {
        let mut other = self.clone();
        for (x, [low, high]) in other.values.iter_mut().zip(&self.ranges) {
            if random.next().is_multiple_of(2) {
                let by = (random.next() % (1 << (random.next() % 13))) as f64 * f64::from(f32::EPSILON) / 4.0;
                let sign = if random.next().is_multiple_of(2) { 1.0 } else { -1.0 };
                *x = ((f64::from(*x) * (1.0 + sign * by)) as f32).clamp(*low, *high);
            }
        }
        other
    }
}

/// The error of an output in ε, relative or absolute as its bound is.
fn error(steps: &Steps, output: usize, kind: &Error, inputs: &Inputs) -> f64 {
    let Some(computed) = steps.evaluate::<f32>(|i| inputs.get(i)) else { return 0.0 };
    let Some(exact) = steps.evaluate::<f64>(|i| f64::from(inputs.get(i))) else { return 0.0 };
    let (computed, exact) = (f64::from(computed[output]), exact[output]);
    let scale = match kind {
        Error::Relative(_) if exact.abs() < 1e-30 => return 0.0, // next to underflow
        Error::Relative(_) => exact.abs(),
        Error::Absolute(_) => 1.0,
    };
    (computed - exact).abs() / scale / f64::from(f32::EPSILON)
}

/// The largest error that is found.
fn search(steps: &Steps, output: usize, kind: &Error, mut inputs: Inputs) -> f64 {
    let random = &mut Random(0x9e37_79b9_7f4a_7c15);
    let mut best: Vec<(f64, Inputs)> = Vec::new();
    for _ in 0..SAMPLES / steps.outputs.len() {
        inputs.at_random(random);
        let found = error(steps, output, kind, &inputs);
        if best.len() < 16 || found > best[best.len() - 1].0 {
            best.push((found, inputs.clone()));
            best.sort_by(|a, b| b.0.total_cmp(&a.0));
            best.truncate(16);
        }
    }
    let rounds = STEPS / steps.outputs.len() / best.len().max(1);
    for (found, at) in &mut best {
        for _ in 0..rounds {
            let other = at.nearby(random);
            let error = error(steps, output, kind, &other);
            if error >= *found {
                (*found, *at) = (error, other);
            }
        }
    }
    best.iter().map(|(found, _)| *found).fold(0.0, f64::max)
}

fn main() {
    println!("| family | of | proved | found | proved/found |\n| --- | --- | --- | --- | --- |");
    for (spec, name, order) in FAMILIES {
        let text = basis_specs::text(spec).expect("a spec of the library");
        let library = Library::from_source(&Disk, &Prover, Source::text(format!("{spec}.basis"), text));
        let Ok(item) = library.item(name, order) else { panic!("{spec} has no family {name}") };
        let Subject::Family(family) = &item.subject else { panic!("{name} is no family") };
        let form = FamilySteps::new(family).expect("code is generated for it");
        let row = |of: &str, proved: &Error, found: f64| {
            let bound = proved.epsilons().to_f64();
            println!("| {} | {of} | {proved} | {found:.2} | {:.2} |", family.title(), bound / found);
        };
        let (steps, errors) = (form.values(), value_errors(family));
        // The function with the largest ratio speaks for all.
        let mut worst: Option<(String, Error, f64)> = None;
        for (k, known) in errors.iter().enumerate() {
            let Some((proved, _)) = known else { continue };
            let found = search(&steps, k, proved, Inputs::of(family, 0));
            let ratio = |error: &Error, found: f64| error.epsilons().to_f64() / found;
            if found > 0.0 && worst.as_ref().is_none_or(|(_, e, f)| ratio(proved, found) > ratio(e, *f)) {
                worst = Some((family.function_label(k), proved.clone(), found));
            }
        }
        if let Some((label, proved, found)) = worst {
            row(&label, &proved, found);
        }
        if let (Some((proved, _)), Some(curve)) = (point_error(family), form.curve(1)) {
            let steps = form.on_control_points(&curve);
            let found = search(&steps, 0, &proved, Inputs::of(family, family.functions.len()));
            row("C(t)", &proved, found);
        }
    }
}
