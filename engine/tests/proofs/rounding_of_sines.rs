//! Rounding errors of families with angles and exponentials beside their proved bounds, in `f32`, with the same steps
//! in `f64` as the reference: no error is larger, at the floats next to both ends of the domain and between them.

use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::angle::Kind;
use basis_engine::plan::Input;
use basis_engine::rounding::{self, Error};
use basis_engine::steps::{FamilySteps, Number, Steps};
use basis_engine::{Disk, Family, Library, Prover, Selected, Source, Subject, generate};

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn unit(&mut self) -> f64 {
        self.next() as f64 / (1_u64 << 31) as f64
    }
}

/// The values of all functions on a span for one choice of shape values.
struct OnSpan<'a, N> {
    steps: &'a Steps,
    shapes: Vec<N>,
}

impl<'a, N: Number> OnSpan<'a, N> {
    fn new(family: &FamilySteps<'_>, steps: &'a Steps, given: &[N]) -> Option<Self> {
        let mut shapes = given.to_vec();
        if let Some(derived) = family.derived() {
            shapes.extend(derived.steps.evaluate(|input| of(given, input))?);
        }
        Some(Self { steps, shapes })
    }

    fn at(&self, t: &N) -> Option<Vec<N>> {
        self.steps.evaluate(|input| match input {
            Input::Coordinate(_) => t.clone(),
            _ => of(&self.shapes, input),
        })
    }
}

impl<N: Number> OnSpan<'_, N> {
    /// A component of a point of a curve.
    fn point(&self, t: &N, points: &[N]) -> N {
        let values = self.steps.evaluate(|input| match input {
            Input::Coordinate(_) => t.clone(),
            Input::Point(k) => points[k].clone(),
            _ => of(&self.shapes, input),
        });
        values.expect("floats divide").remove(0)
    }
}

fn of<N: Number>(shapes: &[N], input: Input) -> N {
    let Input::Shape(k) = input else { unreachable!("a shape value") };
    shapes[k].clone()
}

/// Shape values inside of their ranges, those of angles from their tangents.
fn shapes(family: &Family, random: &mut Random) -> Vec<f32> {
    let shape = |p: &basis_engine::model::Parameter| {
        let [low, high] = [&p.range.low, &p.range.high].map(|end| end.value().map(Rational::to_f64));
        let low = low.or(high.map(|high| high - 8.0)).unwrap_or(-8.0);
        let high = high.unwrap_or(low + 8.0);
        let part =
            [random.unit(), random.unit().powi(4), 1.0 - random.unit().powi(4)][random.next() as usize % 3];
        let value = low + (high - low) * part.clamp(0.001, 0.999);
        match family.analytic.angle(p.var) {
            Some(angle) if angle.kind == Kind::Circular => (value.atan() / angle.speed().to_f64()) as f32,
            Some(angle) if angle.kind == Kind::Hyperbolic => (value.atanh() / angle.speed().to_f64()) as f32,
            _ => value as f32,
        }
    };
    family.shapes.iter().map(shape).collect()
}

/// Floats inside of a domain: those next to both ends, and others.
fn parameters([low, high]: [f32; 2], random: &mut Random) -> Vec<f32> {
    let mut all = Vec::new();
    let (mut up, mut down) = (low.next_up(), high.next_down());
    for _ in 0..40 {
        all.extend([up, down]);
        (up, down) = (up.next_up(), down.next_down());
    }
    for _ in 0..160 {
        let part =
            [random.unit(), random.unit().powi(6), 1.0 - random.unit().powi(6)][random.next() as usize % 3];
        all.push((f64::from(low) + (f64::from(high) - f64::from(low)) * part) as f32);
    }
    // Sines of smaller numbers have powers that underflow.
    all.retain(|t| low < *t && *t < high && t.abs() > 1e-5);
    all
}

/// The largest of the ratios of errors and bounds; no error is beyond its bound.
fn largest_ratio(family: &Family, bounds: &[Option<Error>], random: &mut Random) -> f64 {
    let mut largest = 0.0_f64;
    let steps = FamilySteps::new(family).expect("a family with bounds");
    for _ in 0..24 {
        let given = shapes(family, random);
        let wide: Vec<f64> = given.iter().map(|x| f64::from(*x)).collect();
        let knots = steps.knots().evaluate(|input| of(&given, input)).expect("knots");
        for (k, ends) in knots.windows(2).enumerate() {
            let values = steps.on_span(k).values();
            let (Some(narrow), Some(exact)) =
                (OnSpan::<f32>::new(&steps, &values, &given), OnSpan::<f64>::new(&steps, &values, &wide))
            else {
                continue;
            };
            for t in parameters([ends[0], ends[1]], random) {
                let (Some(found), Some(exact)) = (narrow.at(&t), exact.at(&f64::from(t))) else { continue };
                for ((found, exact), bound) in found.iter().zip(&exact).zip(bounds) {
                    let (Some(bound), true) = (bound, exact.is_finite() && exact.abs() > 1e-30) else {
                        continue;
                    };
                    let allowed = bound.epsilons().to_f64() * f64::from(f32::EPSILON);
                    let allowed =
                        if matches!(bound, Error::Relative(_)) { allowed * exact.abs() } else { allowed };
                    let ratio = (f64::from(*found) - exact).abs() / allowed;
                    // The values in `f64` are off by 2⁻²⁹ of that.
                    assert!(
                        ratio <= 1.0 + 1e-6,
                        "{}: {found} for {exact} at {t}, {given:?}, {ratio}",
                        family.title()
                    );
                    largest = largest.max(ratio);
                }
            }
        }
    }
    largest
}

#[test]
fn no_error_is_beyond_its_bound() {
    let random = &mut Random(11);
    let (mut bounded, mut others, mut near, mut series) = (0, 0, 0, 0);
    for (name, text) in basis_specs::SPECS {
        let library = Library::from_source(&Disk, &Prover, Source::text(format!("{name}.basis"), text));
        let mut last = String::new();
        for item in library.items(Selected::EveryOrder) {
            let Subject::Family(family) = &item.subject else { continue };
            let spans = family.pieces.iter().map(|piece| &**piece);
            let is_transcendental = spans.chain([&**family]).any(|span| span.analytic.is_transcendental());
            if !is_transcendental || family.name == last {
                continue;
            }
            last.clone_from(&family.name);
            let evaluated = generate::evaluated(family, &[]);
            let (Some(bounds), Ok(evaluated)) = (rounding::values(family), evaluated) else {
                others += 1;
                continue;
            };
            let bounds: Vec<Option<Error>> = bounds.into_iter().map(|b| b.map(|b| b.error)).collect();
            let is_series = evaluated.pieces.iter().any(|piece| piece.truncations.is_some());
            assert!(bounds.iter().all(Option::is_some), "{}: {bounds:?}", family.title());
            let ratio = largest_ratio(&evaluated, &bounds, random);
            if is_series {
                series += 1;
                continue;
            }
            bounded += 1;
            near += usize::from(ratio > 0.1);
        }
    }
    assert!(series >= 6, "{series}");
    // Those with knots that are sums of shape parameters have none.
    assert!(bounded > 3 * others, "{bounded} and {others}");
    // Libraries are better than assumed, and roundings do not all conspire.
    assert!(near > bounded - bounded / 8, "{near} of {bounded}");
}

/// The functions of a family with t beside its sine in `f64` at a shape value, if there is one, and a parameter.
type Formulas = fn(f64, f64) -> [f64; 3];

/// Functions with t beside its sine, on domains that end at a shape parameter and at a number: values in `f32` and
/// points of curves are compared with the formulas themselves in `f64`, where these keep enough digits. No bound is a
/// hundred times the largest error.
#[test]
fn series_are_within_their_bounds() {
    let cases: [(&str, Formulas); 2] = [
        (
            "family Mixed { shape 1/2 < α <= 2; domain 0 <= t <= α; \
             b[0] = (α - t - sin(α - t))/(α - sin(α)); b[1] = t/α; b[2] = 1 - cos(t); }",
            |a, t| [(a - t - (a - t).sin()) / (a - a.sin()), t / a, 2.0 * (t / 2.0).sin().powi(2)],
        ),
        (
            "family Between { domain 0 <= t <= 2; b[0] = 2 - t; b[1] = sinh(t) - t/4; \
             b[2] = t*cosh(t) - 3*t; }",
            |_, t| [2.0 - t, t.sinh() - t / 4.0, t * t.cosh() - 3.0 * t],
        ),
    ];
    for (spec, formulas) in cases {
        let library = Library::from_source(&Disk, &Prover, Source::text("mixed.basis", spec));
        let items = library.items(Selected::EveryOrder);
        let Subject::Family(family) = &items[0].subject else { panic!("a family") };
        let evaluated = generate::evaluated(family, &[]).expect("code");
        let bounds = rounding::values(family).expect("bounds").into_iter();
        let bounds: Vec<Error> = bounds.map(|b| b.expect("a bound").error).collect();
        let of_point = rounding::point(family).expect("a bound of points").error.epsilons().to_f64();
        let steps = FamilySteps::new(&evaluated).expect("steps");
        let random = &mut Random(5);
        let mut largest = [0.0_f64; 4];
        for _ in 0..20 {
            let shape = || (0.5 + 1.5 * random.unit()).clamp(0.51, 2.0) as f32;
            let shapes: Vec<f32> = core::iter::repeat_with(shape).take(evaluated.shapes.len()).collect();
            let knots = steps.knots().evaluate(|input| of(&shapes, input)).expect("knots");
            let a = f64::from(shapes.first().copied().unwrap_or(2.0));
            for (k, ends) in knots.windows(2).enumerate() {
                let span = steps.on_span(k);
                let (values, curve) =
                    (span.values(), steps.on_control_points(&span.curve(1).expect("a curve")));
                let narrow = OnSpan::<f32>::new(&steps, &values, &shapes).expect("values");
                let point = OnSpan::<f32>::new(&steps, &curve, &shapes).expect("points");
                for t in parameters([ends[0], ends[1]], random) {
                    let (found, exact) = (narrow.at(&t).expect("values"), formulas(a, f64::from(t)));
                    // What the formula loses in `f64`.
                    let error = |found: f32, exact: f64| {
                        ((f64::from(found) - exact).abs() - 1e-14) / f64::from(f32::EPSILON)
                    };
                    for (k, ((found, exact), bound)) in found.iter().zip(exact).zip(&bounds).enumerate() {
                        let unit = if matches!(bound, Error::Relative(_)) { exact.abs() } else { 1.0 };
                        let ratio = error(*found, exact) / unit / bound.epsilons().to_f64();
                        assert!(ratio <= 1.0, "{found} for {exact} at {t}, {shapes:?}: {bound}");
                        largest[k] = largest[k].max(ratio);
                    }
                    let signs = [1.0, -1.0, if random.next() & 1 == 0 { 1.0 } else { -1.0 }];
                    let exact = exact[0] - exact[1] + f64::from(signs[2]) * exact[2];
                    let ratio = error(point.point(&t, &signs), exact) / of_point;
                    assert!(ratio <= 1.0, "a point at {t}, {shapes:?}: {ratio} of {of_point}");
                    largest[3] = largest[3].max(ratio);
                }
            }
        }
        assert!(largest.iter().all(|ratio| *ratio > 0.01), "{largest:?}");
    }
}

/// Points of curves over quotients, with angles and on several spans: each has a bound, which no error in `f32`
/// exceeds, and which is less than five times the largest one.
#[test]
fn points_are_within_their_bounds() {
    let spec = "family Weighted { domain 0 <= t <= 1; shape 0 < p <= 8, 1/4 <= q; \
                let w = (1 - t)^3 + 3*p*t*(1 - t)^2 + 3*q*t^2*(1 - t) + t^3; \
                b[0] = (1 - t)^3/w; b[1] = 3*p*t*(1 - t)^2/w; b[2] = 3*q*t^2*(1 - t)/w; b[3] = t^3/w; } \
                family Turned { domain 0 <= t <= pi/2; shape -1 <= m <= 1; \
                b[0] = (1 - sin(t))*(1 - m*sin(t)); b[2] = (1 - cos(t))*(1 - m*cos(t)); \
                b[1] = (1 + m)*(sin(t)*(1 - sin(t)) + cos(t)*(1 - cos(t))); } \
                family Parts { domain -1 <= x <= 0, 0 <= x <= 2; shape 0 < w; \
                f[0] = (1 + x)^2/(1 + w*x^2) | (1 - x/2)^3/(1 + w*x*(2 - x)); \
                f[1] = -x/(1 + w*x^2) | w*x*(2 - x)/(1 + w*x*(2 - x)); }";
    let library = Library::from_source(&Disk, &Prover, Source::text("points.basis", spec));
    for item in library.items(Selected::EveryOrder) {
        let Subject::Family(family) = &item.subject else { continue };
        let bound = rounding::point(family).expect("a bound of points").error.epsilons().to_f64();
        let evaluated = generate::evaluated(family, &[]).expect("code");
        let steps = FamilySteps::new(&evaluated).expect("steps");
        let random = &mut Random(17);
        let mut largest = 0.0_f64;
        for _ in 0..60 {
            let given = shapes(&evaluated, random);
            let wide: Vec<f64> = given.iter().map(|x| f64::from(*x)).collect();
            let knots = steps.knots().evaluate(|input| of(&given, input)).expect("knots");
            let points: Vec<f32> = (0..evaluated.functions.len())
                .map(|_| {
                    (1.0 - random.unit() / 64.0) as f32 * if random.next() & 1 == 0 { 1.0 } else { -1.0 }
                })
                .collect();
            for (k, ends) in knots.windows(2).enumerate() {
                let point = steps.on_control_points(&steps.on_span(k).curve(1).expect("a curve"));
                let (narrow, exact) = (
                    OnSpan::<f32>::new(&steps, &point, &given).expect("floats"),
                    OnSpan::<f64>::new(&steps, &point, &wide).expect("floats"),
                );
                for t in parameters([ends[0], ends[1]], random) {
                    let found = narrow.point(&t, &points);
                    let wide: Vec<f64> = points.iter().map(|p| f64::from(*p)).collect();
                    let error = (f64::from(found) - exact.point(&f64::from(t), &wide)).abs();
                    largest = largest.max(error / f64::from(f32::EPSILON));
                }
            }
        }
        assert!(largest <= bound && bound < 5.0 * largest, "{}: {largest}, {bound}", family.title());
    }
}
